/* sisl.c - the tasks of tasks.h by SISL: cc sisl.c -lsisl -lm */
#define _POSIX_C_SOURCE 200809L
#include <sisl.h>

#include "tasks.h"
#include "time.h"

#define EPS_MEET 1e-9 /* points closer than that are one, for SISL */

typedef struct {
    SISLCurve *a, *b;
    SISLSurf *s;
    int n;
    double *pts, tol;
} work;

static double *numbers(int n)
{
    return malloc((size_t)n * sizeof(double));
}

/* Coordinates one array each, as SISL wants them: one point after another. */
static double *interleave(int n, int dim, const double *p)
{
    double *q = numbers(n * dim);

    for (int i = 0; i < n; i++)
        for (int k = 0; k < dim; k++)
            q[i * dim + k] = p[k * n + i];
    return q;
}

static SISLCurve *curve(int n, int dim, const double *p)
{
    double *kv = numbers(n + TASK_DEGREE + 1), *q = interleave(n, dim, p);
    SISLCurve *c;

    task_knots(n, kv);
    c = newCurve(n, TASK_DEGREE + 1, kv, q, 1, dim, 1);
    free(kv);
    free(q);
    return c;
}

static double meet(void *arg)
{
    work *w = arg;
    int npt, ncrv, stat;
    double *t, *r;
    SISLIntcurve **crv;

    s1857(w->a, w->b, 0, EPS_MEET, &npt, &t, &r, &ncrv, &crv, &stat);
    free(t);
    free(r);
    freeIntcrvlist(crv, ncrv);
    return stat < 0 ? stat : npt;
}

static void meets(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_meet_n); i++) {
        int n = task_meet_n[i];
        double *p = numbers(2 * n);

        task_meet_curve(0, n, p, p + n);
        w->a = curve(n, 2, p);
        task_meet_curve(1, n, p, p + n);
        w->b = curve(n, 2, p);
        peer_row("curve/curve intersection, cubics", n, meet, w);
        freeCurve(w->a);
        freeCurve(w->b);
        free(p);
    }
}

static double distance(const double *p, const double *q)
{
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                (p[2] - q[2]) * (p[2] - q[2]));
}

static double near_curve(void *arg)
{
    work *w = arg;
    double pt[3] = {task_point[0], task_point[1], task_point[2]}, *t, x[3];
    int npt, ncrv, stat, left = 0;
    SISLIntcurve **crv;

    s1953(w->a, pt, 3, 0, EPS_MEET, &npt, &t, &ncrv, &crv, &stat);
    if (stat < 0 || npt < 1)
        return -1;
    s1227(w->a, 0, t[0], &left, x, &stat);
    free(t);
    freeIntcrvlist(crv, ncrv);
    return distance(x, pt);
}

static void near_curves(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_crv_n); i++) {
        int n = task_crv_n[i];
        double *p = numbers(3 * n);

        task_curve(n, p, p + n, p + 2 * n);
        w->a = curve(n, 3, p);
        peer_row("point/curve distance, cubic", n, near_curve, w);
        freeCurve(w->a);
        free(p);
    }
}

static double near_surface(void *arg)
{
    work *w = arg;
    double pt[3] = {task_point_srf[0], task_point_srf[1], task_point_srf[2]};
    double *uv, x[3], normal[3];
    int npt, ncrv, stat, lu = 0, lv = 0;
    SISLIntcurve **crv;

    s1954(w->s, pt, 3, 0, EPS_MEET, &npt, &uv, &ncrv, &crv, &stat);
    if (stat < 0 || npt < 1)
        return -1;
    s1421(w->s, 0, uv, &lu, &lv, x, normal, &stat);
    free(uv);
    freeIntcrvlist(crv, ncrv);
    return distance(x, pt);
}

/* The topology of the contours, then their points. */
static double contour(void *arg)
{
    work *w = arg;
    double on[3] = {0, 0, task_level}, up[3] = {0, 0, 1}, *uv;
    int npt, ncrv, stat;
    SISLIntcurve **crv;

    s1851(w->s, on, up, 3, 0, 1e-6, &npt, &uv, &ncrv, &crv, &stat);
    if (stat < 0)
        return stat;
    for (int i = 0; i < ncrv; i++)
        s1314(w->s, on, up, 3, 0, TASK_TOL, 0, crv[i], 2, 0, &stat);
    free(uv);
    freeIntcrvlist(crv, ncrv);
    return ncrv;
}

static void surfaces(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_srf_n); i++) {
        int n = task_srf_n[i];
        double *kv = numbers(n + TASK_DEGREE + 1), *p = numbers(3 * n * n), *q;

        task_knots(n, kv);
        task_surface(n, p, p + n * n, p + 2 * n * n);
        q = interleave(n * n, 3, p);
        w->s = newSurf(n, n, TASK_DEGREE + 1, TASK_DEGREE + 1, kv, kv, q, 1, 3,
                       1);
        peer_row("point/surface distance, bicubic", n, near_surface, w);
        peer_row("contour of a bicubic", n, contour, w);
        freeSurf(w->s);
        free(q);
        free(p);
        free(kv);
    }
}

/* SISL has no fit with given knots: from the chord through all points it
 * removes knots within a tolerance, here that of our result's largest error. */
static double fit(void *arg)
{
    work *w = arg;
    double eps[3] = {w->tol, w->tol, w->tol}, err[3];
    SISLCurve *c = NULL;
    int stat, n;

    s1961(w->pts, w->n, 3, 1, NULL, eps, 1, 1, 1, w->tol, 10, TASK_DEGREE + 1,
          &c, err, &stat);
    if (stat < 0)
        return stat;
    n = c->in;
    freeCurve(c);
    return n;
}

static void fits(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_fit_n); i++) {
        int n = w->n = task_fit_n[i];
        double *p = numbers(3 * n);

        task_cloud(n, p, p + n, p + 2 * n);
        w->pts = interleave(n, 3, p);
        w->tol = 2e-3;
        peer_row("least squares, cubic, 1000 control points", n, fit, w);
        free(w->pts);
        free(p);
    }
}

int main(void)
{
    work w = {0};

    meets(&w);
    near_curves(&w);
    surfaces(&w);
    fits(&w);
    return 0;
}
