/* medial_point.c - one point of a medial curve: its equations and Newton's
 * method for them. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "ops/medial.h"

enum { NEWTON = 40 };

/* --- the equations -------------------------------------------------------- */

static double dot(const ix__geo_metric *m, const double a[2], const double b[2])
{
    return m->e * a[0] * b[0] + m->f * (a[0] * b[1] + a[1] * b[0]) +
           m->g * a[1] * b[1];
}

/* Parts of the tangent vector x along dO1/ds and E of the first geodesic: both
 * stay what they are where s changes its sign. */
static void in_frame(const ix__geo_metric *m, const ix__geo_shot *a,
                     const double x[2], double out[2])
{
    out[0] = a->sign * dot(m, x, a->q + 2);
    out[1] = dot(m, x, a->side);
}

/* The vector orthogonal to both rows, for lengths as in medial.h. Where the
 * columns are as good as parallel there is none: the borders touch. */
static void find_tangent(double orient, ix__medial_point *p)
{
    double r[2][3], n[3], len, la = p->shot[0].len, lb = p->shot[1].len;

    for (int i = 0; i < 2; i++) {
        r[i][0] = p->j[i][0] / la;
        r[i][1] = p->j[i][1] / lb;
        r[i][2] = p->j[i][2];
    }
    n[0] = r[0][1] * r[1][2] - r[0][2] * r[1][1];
    n[1] = r[0][2] * r[1][0] - r[0][0] * r[1][2];
    n[2] = r[0][0] * r[1][1] - r[0][1] * r[1][0];
    len = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    p->regular = len > 1e-9;
    if (orient != 0)
        len *= orient;
    p->tangent[0] = n[0] / len / la;
    p->tangent[1] = n[1] / len / lb;
    p->tangent[2] = n[2] / len;
}

static bool equations(const ix__medial *m, ix__medial_point *p)
{
    const ix__geo_shot *a = &p->shot[0], *b = &p->shot[1];
    double x[2], col[2];
    ix__geo_metric g;
    ix__geo_jet j;

    if (!ix__geo_eval(&m->g->s, a->cell, a->q[0], a->q[1], 1, j) ||
        !ix__geo_metric_of(j, &g))
        return false;
    for (int i = 0; i < 2; i++)
        x[i] = b->q[i] - a->q[i];
    in_frame(&g, a, x, p->f);
    p->j[0][0] = 0;
    p->j[1][0] = -a->q[4];
    in_frame(&g, a, b->side, col);
    p->j[0][1] = b->q[4] * col[0];
    p->j[1][1] = b->q[4] * col[1];
    for (int i = 0; i < 2; i++)
        x[i] = m->side[1] * b->sign * b->q[2 + i] -
               m->side[0] * a->sign * a->q[2 + i];
    in_frame(&g, a, x, col);
    p->j[0][2] = col[0];
    p->j[1][2] = col[1];
    find_tangent(m->orient, p);
    return true;
}

int ix__medial_span(const ix__medial *m, int k, double t)
{
    const ix__geo_crv *c = &m->g->c[k];
    const int *group = c->group[m->span[k]];
    int span = ix__geo_crv_span(c, t);

    return span < group[0] ? group[0] : span >= group[1] ? group[1] - 1 : span;
}

ix_status ix__medial_eval(ix__medial *m, const double x[3],
                          ix__medial_point *out, bool *ok)
{
    const ix__geo_way way = {.margin = true};

    *ok = false;
    m->why = IX_GEO_SINGULAR;
    for (int i = 0; i < 3; i++)
        if (!isfinite(x[i]))
            return IX_OK;
    for (int i = 0; i < 2; i++) {
        IX_TRY(ix__geo_shoot(m->g, &m->g->c[i], ix__medial_span(m, i, x[i]),
                             x[i], m->side[i] * x[2], &way, &out->shot[i]));
        if (out->shot[i].stop != IX_GEO_END) {
            m->why = out->shot[i].stop;
            return IX_OK;
        }
    }
    *ok = equations(m, out);
    return IX_OK;
}

void ix__medial_spans(ix__medial *m, const double x[3], bool up)
{
    for (int i = 0; i < 2; i++) {
        const ix__geo_dir *d = &m->g->c[i].d;

        m->span[i] = ix__geo_crv_span(&m->g->c[i], x[i]);
        if (!up && m->span[i] > 0 && x[i] <= d->breaks[m->span[i]])
            m->span[i]--;
    }
}

/* --- Newton's method ------------------------------------------------------ */

/* The step of least length, or with one unknown kept. */
static bool newton_step(const ix__medial_point *p, int fixed, double dx[3])
{
    const double len[3] = {p->shot[0].len, p->shot[1].len, 1};
    double r[2][3], a = 0, b = 0, c = 0, det, l[2];

    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 2; i++)
            r[i][k] = k == fixed ? 0 : p->j[i][k] / len[k];
        a += r[0][k] * r[0][k];
        b += r[0][k] * r[1][k];
        c += r[1][k] * r[1][k];
    }
    det = a * c - b * b;
    if (!(det > 1e-24 * (a + c) * (a + c)))
        return false;
    l[0] = (c * p->f[0] - b * p->f[1]) / det;
    l[1] = (a * p->f[1] - b * p->f[0]) / det;
    for (int k = 0; k < 3; k++)
        dx[k] = -(r[0][k] * l[0] + r[1][k] * l[1]) / len[k];
    return true;
}

ix_status ix__medial_newton(ix__medial *m, int fixed, double x[3],
                            ix__medial_point *at, bool *ok)
{
    /* what an integration is exact to, and the most that is accepted */
    double aim = fmax(1e-2 * m->g->tol, 1e-13), most_f = 10 * m->g->tol;
    double before = HUGE_VAL;

    for (int i = 0; i < NEWTON; i++) {
        double size, most, dx[3];

        IX_TRY(ix__medial_eval(m, x, at, ok));
        if (!*ok)
            return IX_OK;
        size = fmax(fabs(at->f[0]), fabs(at->f[1]));
        if (size <= aim || (size <= most_f && size >= before))
            return IX_OK;
        before = size;
        *ok = newton_step(at, fixed, dx);
        if (!*ok)
            return IX_OK;
        most = fmax(fabs(dx[0]), fmax(fabs(dx[1]), fabs(dx[2])));
        for (int k = 0; k < 3; k++)
            x[k] += dx[k] * fmin(1, 0.2 / most);
    }
    *ok = false;
    return IX_OK;
}
