// readstep.cpp - reads a STEP file with Open CASCADE and prints what arrived:
// faces, edges and free points, and for each face and edge the middle of its
// parameters and the point there, in 17 digits. Of shells: whether the shape is
// valid and closed, its area, and how far edges are from their curves in the
// parameter planes of faces, at most.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
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

// The largest distance of an edge from its curve on a face.
static double apart(const TopoDS_Edge &e, const TopoDS_Face &f)
{
    double a, b, c, d, most = 0;
    Handle(Geom_Curve) space = BRep_Tool::Curve(e, a, b);
    Handle(Geom2d_Curve) plane = BRep_Tool::CurveOnSurface(e, f, c, d);
    Handle(Geom_Surface) s = BRep_Tool::Surface(f);

    if (space.IsNull() || plane.IsNull())
        return BRep_Tool::Degenerated(e) ? 0 : 1;
    for (int i = 0; i <= 40; i++) {
        gp_Pnt2d q = plane->Value(c + (d - c) * i / 40);
        gp_Pnt p = space->Value(a + (b - a) * i / 40);

        most = std::max(most, p.Distance(s->Value(q.X(), q.Y())));
    }
    return most;
}

static void shell(const TopoDS_Shape &s)
{
    GProp_GProps g;
    double most = 0;

    BRepGProp::SurfaceProperties(s, g, 1e-9);
    for (TopExp_Explorer x(s, TopAbs_FACE); x.More(); x.Next())
        for (TopExp_Explorer y(x.Current(), TopAbs_EDGE); y.More(); y.Next())
            most = std::max(most, apart(TopoDS::Edge(y.Current()),
                                        TopoDS::Face(x.Current())));
    std::printf("shell %d %d %.17g %.3g\n", BRepCheck_Analyzer(s).IsValid(),
                BRep_Tool::IsClosed(s), g.Mass(), most);
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
    for (TopExp_Explorer x(s, TopAbs_SHELL); x.More(); x.Next())
        shell(x.Current());
    return 0;
}
