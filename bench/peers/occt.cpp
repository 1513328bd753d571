// occt.cpp - the tasks of tasks.h by Open CASCADE.
#include <AppDef_BSpParLeastSquareOfMyBSplGradientOfBSplineCompute.hxx>
#include <AppDef_MultiLine.hxx>
#include <AppParCurves_MultiBSpCurve.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_IntSS.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <math_Vector.hxx>
#include <vector>

#include "tasks.h"
#include "time.h"

namespace
{

// Distinct knots and their multiplicities.
struct Knots {
    TColStd_Array1OfReal value;
    TColStd_Array1OfInteger mult;

    explicit Knots(int n)
        : value(1, n - TASK_DEGREE + 1), mult(1, n - TASK_DEGREE + 1)
    {
        for (int i = 1; i <= value.Upper(); i++) {
            value(i) = i - 1;
            mult(i) = i == 1 || i == value.Upper() ? TASK_DEGREE + 1 : 1;
        }
    }
};

struct Meet {
    Handle(Geom2d_Curve) a, b;
};

Handle(Geom2d_Curve) wave(int which, int n)
{
    std::vector<double> x(n), y(n);
    TColgp_Array1OfPnt2d p(1, n);
    Knots k(n);

    task_meet_curve(which, n, x.data(), y.data());
    for (int i = 0; i < n; i++)
        p(i + 1) = gp_Pnt2d(x[i], y[i]);
    return new Geom2d_BSplineCurve(p, k.value, k.mult, TASK_DEGREE);
}

double meet(void *arg)
{
    Meet *w = static_cast<Meet *>(arg);

    return Geom2dAPI_InterCurveCurve(w->a, w->b, 1e-9).NbPoints();
}

double near_curve(void *arg)
{
    gp_Pnt p(task_point[0], task_point[1], task_point[2]);

    return GeomAPI_ProjectPointOnCurve(p,
                                       *static_cast<Handle(Geom_Curve) *>(arg))
        .LowerDistance();
}

Handle(Geom_Curve) curve(int n)
{
    std::vector<double> x(n), y(n), z(n);
    TColgp_Array1OfPnt p(1, n);
    Knots k(n);

    task_curve(n, x.data(), y.data(), z.data());
    for (int i = 0; i < n; i++)
        p(i + 1) = gp_Pnt(x[i], y[i], z[i]);
    return new Geom_BSplineCurve(p, k.value, k.mult, TASK_DEGREE);
}

Handle(Geom_Surface) surface(int n)
{
    std::vector<double> x(n * n), y(n * n), z(n * n);
    TColgp_Array2OfPnt p(1, n, 1, n);
    Knots k(n);

    task_surface(n, x.data(), y.data(), z.data());
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++)
            p(i + 1, j + 1) = gp_Pnt(x[j * n + i], y[j * n + i], z[j * n + i]);
    return new Geom_BSplineSurface(p, k.value, k.value, k.mult, k.mult,
                                   TASK_DEGREE, TASK_DEGREE);
}

double near_surface(void *arg)
{
    gp_Pnt p(task_point_srf[0], task_point_srf[1], task_point_srf[2]);
    GeomAPI_ProjectPointOnSurf o(p, *static_cast<Handle(Geom_Surface) *>(arg));

    return o.NbPoints() > 0 ? o.LowerDistance() : -1;
}

double contour(void *arg)
{
    Handle(Geom_Surface)
        plane = new Geom_Plane(gp_Pnt(0, 0, task_level), gp_Dir(0, 0, 1));

    return GeomAPI_IntSS(*static_cast<Handle(Geom_Surface) *>(arg), plane,
                         TASK_TOL)
        .NbLines();
}

struct Fit {
    TColgp_Array1OfPnt points;
    math_Vector params;
    TColStd_Array1OfReal knots;
    TColStd_Array1OfInteger mults;

    explicit Fit(int n)
        : points(1, n), params(1, n), knots(1, TASK_FIT - TASK_DEGREE + 1),
          mults(1, TASK_FIT - TASK_DEGREE + 1)
    {
        std::vector<double> x(n), y(n), z(n);

        task_cloud(n, x.data(), y.data(), z.data());
        for (int i = 0; i < n; i++) {
            points(i + 1) = gp_Pnt(x[i], y[i], z[i]);
            params(i + 1) = i == 0
                                ? 0
                                : params(i) + points(i).Distance(points(i + 1));
        }
        params.Multiply(1 / params(n));
        for (int i = 1; i <= knots.Upper(); i++) {
            knots(i) = (i - 1.0) / (knots.Upper() - 1);
            mults(i) = i == 1 || i == knots.Upper() ? TASK_DEGREE + 1 : 1;
        }
    }
};

// The root mean square of the distances.
double fit(void *arg)
{
    Fit *w = static_cast<Fit *>(arg);
    AppDef_MultiLine line(w->points);
    AppDef_BSpParLeastSquareOfMyBSplGradientOfBSplineCompute o(
        line, w->knots, w->mults, 1, w->points.Upper(), AppParCurves_PassPoint,
        AppParCurves_PassPoint, w->params, TASK_FIT);
    double sum, far3, far2;

    if (!o.IsDone())
        return -1;
    o.Error(sum, far3, far2);
    return sqrt(sum / w->points.Upper());
}

} // namespace

int main()
{
    for (int n : task_meet_n) {
        Meet w = {wave(0, n), wave(1, n)};

        peer_row("curve/curve intersection, cubics", n, meet, &w);
    }
    for (int n : task_crv_n) {
        Handle(Geom_Curve) c = curve(n);

        peer_row("point/curve distance, cubic", n, near_curve, &c);
    }
    for (int n : task_srf_n) {
        Handle(Geom_Surface) s = surface(n);

        peer_row("point/surface distance, bicubic", n, near_surface, &s);
        peer_row("contour of a bicubic", n, contour, &s);
    }
    for (int n : task_fit_n) {
        Fit w(n);

        peer_row("least squares, cubic, 1000 control points", n, fit, &w);
    }
    return 0;
}
