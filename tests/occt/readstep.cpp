// readstep.cpp - reads a STEP file with Open CASCADE and prints what arrived:
// faces, edges and free points, and for each face and edge the middle of its
// parameters and the point there, in 17 digits.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cstdio>

static void face(const TopoDS_Face &f)
{
    BRepAdaptor_Surface s(f);
    double u = (s.FirstUParameter() + s.LastUParameter()) / 2;
    double v = (s.FirstVParameter() + s.LastVParameter()) / 2;
    gp_Pnt p = s.Value(u, v);

    std::printf("face %.17g %.17g %.17g %.17g %.17g\n", u, v, p.X(), p.Y(),
                p.Z());
}

static void edge(const TopoDS_Edge &e)
{
    BRepAdaptor_Curve c(e);
    double t = (c.FirstParameter() + c.LastParameter()) / 2;
    gp_Pnt p = c.Value(t);

    std::printf("edge %.17g %.17g %.17g %.17g\n", t, p.X(), p.Y(), p.Z());
}

int main(int argc, char **argv)
{
    STEPControl_Reader r;

    if (argc != 2 || r.ReadFile(argv[1]) != IFSelect_RetDone)
        return 1;
    std::printf("roots %d of %d\n", r.TransferRoots(), r.NbRootsForTransfer());
    TopoDS_Shape s = r.OneShape();
    for (TopExp_Explorer x(s, TopAbs_FACE); x.More(); x.Next())
        face(TopoDS::Face(x.Current()));
    for (TopExp_Explorer x(s, TopAbs_EDGE, TopAbs_FACE); x.More(); x.Next())
        edge(TopoDS::Edge(x.Current()));
    return 0;
}
