/* geo_fit.c - curves that are traced on a surface as B-splines.
 *
 * Between two samples a quintic has their points and derivatives and passes
 * through two more computed points; where it misses three others by more than
 * half the tolerance the interval is halved. The curve in the parameter plane
 * and that in space have the same pieces; the error of the former counts as a
 * length, by the first fundamental form. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"
#include "ops/geo.h"

enum { ORDER = 6, NC = 5, PIECES = 4096, DEPTH = 30 };

void *ix__geo_grow(ix_ctx *ctx, void *at, int n, int *room, size_t size)
{
    int more = *room ? 2 * *room : 64;
    void *moved;

    if (n < *room)
        return at;
    moved = ix__scratch(ctx, (size_t)more, size);
    if (!moved)
        return NULL;
    if (n)
        memcpy(moved, at, (size_t)n * size);
    *room = more;
    return moved;
}

ix_status ix__geo_trace_add(ix_ctx *ctx, ix__geo_trace *t,
                            const ix__geo_sample *s)
{
    void *at = ix__geo_grow(ctx, t->at, t->n, &t->room, sizeof *t->at);

    if (!at)
        return IX_ENOMEM;
    t->at = at;
    t->at[t->n++] = *s;
    return IX_OK;
}

bool ix__geo_fill(const ix__geo *g, ix__geo_cell c, const double uv[2],
                  const double duv[2], ix__geo_sample *out)
{
    const ix__geo_srf *s = &g->s;
    double d[3];
    ix__geo_jet j;

    if (!ix__geo_eval(s, c, uv[0], uv[1], 1, j))
        return false;
    ix__geo_vector(j, duv, d);
    for (int i = 0; i < 2; i++) {
        out->p[i] = s->lo[i] + s->len[i] * uv[i];
        out->dp[i] = s->len[i] * duv[i];
    }
    for (int i = 0; i < 3; i++) {
        out->p[2 + i] = s->size * j[IX_GEO_S][i];
        out->dp[2 + i] = s->size * d[i];
    }
    for (int i = 0; i < 3; i++) { /* 11, 12, 22 */
        const double *a = j[i < 2 ? IX_GEO_SU : IX_GEO_SV];
        const double *b = j[i < 1 ? IX_GEO_SU : IX_GEO_SV];

        out->form[i] = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * s->size *
                       s->size / (s->len[i > 1] * s->len[i > 0]);
    }
    return true;
}

/* --- one piece ----------------------------------------------------------- */

typedef struct {
    double x0, x1;
    bool kink; /* only continuous at x0 */
    double c[NC][ORDER];
} piece;

typedef struct {
    ix_ctx *ctx;
    ix__geo_mid mid;
    const void *ud;
    double tol, worst, least;
    ix__geo_trace done;
    int n, room;
    piece *piece;
} fitter;

static void bernstein(double u, double b[ORDER])
{
    double v = 1 - u;

    b[0] = v * v * v * v * v;
    b[1] = 5 * u * v * v * v * v;
    b[2] = 10 * u * u * v * v * v;
    b[3] = 10 * u * u * u * v * v;
    b[4] = 5 * u * u * u * u * v;
    b[5] = u * u * u * u * u;
}

/* The two inner coefficients, by the points q at 1/3 and 2/3. */
static void make_piece(const ix__geo_sample *a, const ix__geo_sample *b,
                       const ix__geo_sample q[2], piece *p)
{
    double h = b->x - a->x, w[2][ORDER];

    bernstein(1.0 / 3, w[0]);
    bernstein(2.0 / 3, w[1]);
    *p = (piece){.x0 = a->x, .x1 = b->x, .kink = a->kink};
    for (int k = 0; k < NC; k++) {
        double *c = p->c[k], r[2], det;

        c[0] = a->p[k];
        c[1] = a->p[k] + h * a->dp[k] / 5;
        c[4] = b->p[k] - h * b->dp[k] / 5;
        c[5] = b->p[k];
        for (int i = 0; i < 2; i++)
            r[i] = q[i].p[k] - w[i][0] * c[0] - w[i][1] * c[1] -
                   w[i][4] * c[4] - w[i][5] * c[5];
        det = w[0][2] * w[1][3] - w[0][3] * w[1][2];
        c[2] = (r[0] * w[1][3] - r[1] * w[0][3]) / det;
        c[3] = (w[0][2] * r[1] - w[1][2] * r[0]) / det;
    }
}

/* Distance of the piece from a sample at the same parameter. */
static double error_at(const piece *p, const ix__geo_sample *s)
{
    double w[ORDER], d[NC], plane, space;

    bernstein((s->x - p->x0) / (p->x1 - p->x0), w);
    for (int k = 0; k < NC; k++) {
        d[k] = -s->p[k];
        for (int i = 0; i < ORDER; i++)
            d[k] += w[i] * p->c[k][i];
    }
    plane = s->form[0] * d[0] * d[0] + 2 * s->form[1] * d[0] * d[1] +
            s->form[2] * d[1] * d[1];
    space = d[2] * d[2] + d[3] * d[3] + d[4] * d[4];
    return sqrt(fmax(plane, space));
}

static ix_status keep_piece(fitter *f, const piece *p)
{
    void *at;

    if (f->n >= PIECES)
        return IX_FAIL(f->ctx, IX_EUNABLE,
                       "the tolerance %g is not reached with %d pieces", f->tol,
                       PIECES);
    at = ix__geo_grow(f->ctx, f->piece, f->n, &f->room, sizeof *f->piece);
    if (!at)
        return IX_ENOMEM;
    f->piece = at;
    f->piece[f->n++] = *p;
    return IX_OK;
}

static ix_status between(const fitter *f, const ix__geo_sample *a,
                         const ix__geo_sample *b, double u, ix__geo_sample *out)
{
    IX_TRY(f->mid(f->ud, a, b, a->x + u * (b->x - a->x), out));
    out->x = a->x + u * (b->x - a->x);
    out->kink = false;
    return IX_OK;
}

/* The largest errors of a quintic Hermite interpolant lie near these. */
static ix_status measure(const fitter *f, const ix__geo_sample *a,
                         const ix__geo_sample *b, const piece *p,
                         ix__geo_sample *middle, double *err)
{
    static const double u[3] = {0.18, 0.82, 0.5};

    *err = 0;
    for (int i = 0; i < 3; i++) {
        IX_TRY(between(f, a, b, u[i], middle));
        *err = fmax(*err, error_at(p, middle));
        if (!isfinite(*err))
            *err = HUGE_VAL;
    }
    return IX_OK;
}

static ix_status fit_between(fitter *f, const ix__geo_sample *a,
                             const ix__geo_sample *b, int depth)
{
    ix__geo_sample q[2], middle;
    double err;
    piece p;

    for (int i = 0; i < 2; i++)
        IX_TRY(between(f, a, b, (1 + i) / 3.0, &q[i]));
    make_piece(a, b, q, &p);
    IX_TRY(measure(f, a, b, &p, &middle, &err));
    if (!(err <= 0.5 * f->tol) && depth < DEPTH && b->x - a->x > f->least) {
        IX_TRY(fit_between(f, a, &middle, depth + 1));
        return fit_between(f, &middle, b, depth + 1);
    }
    f->worst = fmax(f->worst, err);
    IX_TRY(keep_piece(f, &p));
    return ix__geo_trace_add(f->ctx, &f->done, b);
}

/* --- the spline ----------------------------------------------------------- */

/* Control points of coordinate k, or their number. */
static int points(const fitter *f, int k, double *out)
{
    int n = 0;

    for (int i = 0; i < f->n; i++) {
        const piece *p = f->piece + i;

        /* A C1 joint has no control point of its own. */
        for (int q = i > 0 && !p->kink ? 1 : 0; q < ORDER - 1; q++, n++)
            if (out)
                out[n] = p->c[k][q];
    }
    if (out)
        out[n] = f->piece[f->n - 1].c[k][ORDER - 1];
    return n + 1;
}

static void make_knots(const fitter *f, double *kv)
{
    int n = 0;

    for (int i = 0; i <= f->n; i++) {
        bool end = i == 0 || i == f->n;
        int times = end ? ORDER : f->piece[i].kink ? ORDER - 1 : ORDER - 2;

        for (int k = 0; k < times; k++)
            kv[n++] = i < f->n ? f->piece[i].x0 : f->piece[i - 1].x1;
    }
}

static ix_status assemble(fitter *f, int from, int nc, ix_mv **out)
{
    int n = points(f, 0, NULL);
    double *kv, *pts;
    ix_dir dir = {IX_BSPLINE, ORDER, n, false, NULL};

    IX_SCRATCH(f->ctx, kv, n + ORDER);
    IX_SCRATCH(f->ctx, pts, n * nc);
    make_knots(f, kv);
    dir.knots = kv;
    for (int k = 0; k < nc; k++)
        (void)points(f, from + k, pts + k * n);
    return ix_mv_new(f->ctx, 1, &dir, nc, false, pts, out);
}

ix_status ix__geo_fit(ix_ctx *ctx, ix__geo_trace *t, ix__geo_mid mid,
                      const void *ud, double tol, ix_geo_curve *out)
{
    double length = t->n ? t->at[t->n - 1].x - t->at[0].x : 0;
    fitter f = {
        .ctx = ctx, .mid = mid, .ud = ud, .tol = tol, .least = 1e-9 * length};

    if (!(length > 0))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curve ends where it starts (%s): nothing to fit",
                       ix_geo_stop_name(out->stop[1]));
    IX_TRY(ix__geo_trace_add(ctx, &f.done, &t->at[0]));
    for (int i = 1; i < t->n; i++)
        if (t->at[i].x > t->at[i - 1].x)
            IX_TRY(fit_between(&f, &t->at[i - 1], &t->at[i], 0));
        else /* after a kink */
            IX_TRY(ix__geo_trace_add(ctx, &f.done, &t->at[i]));
    *t = f.done;
    out->fit = f.worst;
    IX_TRY(assemble(&f, 0, 2, &out->uv));
    return assemble(&f, 2, 3, &out->space);
}

ix_status ix__geo_states(ix_ctx *ctx, const ix__geo_trace *t, int k,
                         ix__geo_row row, const void *ud, ix_mv **out)
{
    double *kv, *pts, one[IX_MAX_COORDS];
    ix_dir dir = {IX_BSPLINE, 2, 0, false, NULL};
    int n = 0, room = t->n;

    IX_SCRATCH(ctx, kv, room + 2);
    IX_SCRATCH(ctx, pts, room * k);
    for (int i = 0; i < room; i++)
        if (!n || t->at[i].x > kv[n])
            kv[++n] = t->at[i].x;
    kv[0] = kv[1];
    kv[n + 1] = kv[n];
    for (int i = 0, at = 0; i < room && at < n; i++) {
        if (t->at[i].x != kv[at + 1]) /* a kink's second sample */
            continue;
        row(ud, &t->at[i], one);
        for (int c = 0; c < k; c++)
            pts[c * n + at] = one[c];
        at++;
    }
    dir.length = n;
    dir.knots = kv;
    return ix_mv_new(ctx, 1, &dir, k, false, pts, out);
}

/* --- their ownership ------------------------------------------------------ */

void ix_geo_curve_free(ix_ctx *ctx, ix_geo_curve *c)
{
    ix_mv_unref(ctx, c->uv);
    ix_mv_unref(ctx, c->space);
    ix_mv_unref(ctx, c->states);
    *c = (ix_geo_curve){0};
}

void ix_geo_curves_free(ix_ctx *ctx, ix_geo_curves *c)
{
    for (int i = 0; i < c->n; i++)
        ix_geo_curve_free(ctx, &c->crv[i]);
    ix__free(ctx, c->crv, c->bytes);
    *c = (ix_geo_curves){0};
}

ix_status ix__geo_keep(ix_ctx *ctx, ix__geo_found *f, const ix_geo_curve *c)
{
    if (f->n == f->room) {
        size_t size = sizeof *f->crv;
        int room = f->room ? 2 * f->room : 4;
        ix_geo_curve *more = ix__realloc(ctx, f->crv, (size_t)f->room * size,
                                         (size_t)room * size);

        if (!more)
            return IX_ENOMEM;
        f->crv = more;
        f->room = room;
    }
    f->crv[f->n++] = *c;
    return IX_OK;
}

ix_status ix__geo_found_end(ix_ctx *ctx, ix__geo_found *f, ix_status st,
                            ix_geo_curves *out)
{
    *out = (ix_geo_curves){f->n, f->crv, (size_t)f->room * sizeof *f->crv};
    if (st != IX_OK)
        ix_geo_curves_free(ctx, out);
    return st;
}

const char *ix_geo_stop_name(ix_geo_stop s)
{
    static const char *const name[] = {"end",      "domain", "focal",
                                       "focal2",   "crease", "corner",
                                       "singular", "reach",  "closed"};

    return s <= IX_GEO_CLOSED ? name[s] : "unknown";
}
