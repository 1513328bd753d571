/* ruled_fit.c - one ruled surface near a given one: rulings by dynamic
 * programming, then both sides by least squares over nearest points (Hoschek's
 * intrinsic parametrisation, 1988). Inside, rulings run along direction 1. */
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/parts.h"
#include "geom/ruled_rulings.h"
#include "geom/strip.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

enum { TEMPS = 7, ROUNDS = 40 };

/* --- points of the surface ------------------------------------------------ */

/* Points even in the parameters. If pinned, those of a side stay with that side
 * of the strip, and with ends those of the other two borders with its ends:
 * else the strip could reach out or fold where no point says anything. */
typedef struct {
    int n;
    bool pinned, ends;
    double u[2];
    double (*uv)[2]; /* v as the fraction of its domain */
    double (*p)[3];
} cloud;

static ix_status take_points(ix_ctx *ctx, const ix_mv *s, int nu, int nv,
                             cloud *out)
{
    double dom[2][2], t[2];

    *out = (cloud){.n = nu * nv};
    IX_SCRATCH(ctx, out->uv, out->n);
    IX_SCRATCH_ZERO(ctx, out->p, out->n);
    for (int d = 0; d < 2; d++)
        ix_mv_domain(s, d, dom[d]);
    memcpy(out->u, dom[0], sizeof out->u);
    for (int i = 0; i < out->n; i++) {
        int column = i / nv, row = i % nv;
        double x = column / (nu - 1.0), y = row / (nv - 1.0);

        t[0] = (1 - x) * dom[0][0] + x * dom[0][1];
        t[1] = (1 - y) * dom[1][0] + y * dom[1][1];
        out->uv[i][0] = t[0];
        out->uv[i][1] = y;
        IX_TRY(ix_mv_point(ctx, s, t, out->p[i]));
    }
    return IX_OK;
}

/* Where on the strip point i of the surface may be. */
static ix__strip_range range_of(const cloud *c, int i, const ix__strip *s)
{
    const ix_path *p = &s->side[0];
    ix__strip_range r = {{p->breaks[0], p->breaks[p->nspans]}, {0, 1}};

    if (c->pinned && (c->uv[i][1] <= 0 || c->uv[i][1] >= 1))
        r.x[0] = r.x[1] = c->uv[i][1];
    if (c->pinned && c->ends && c->uv[i][0] <= c->u[0])
        r.t[1] = r.t[0];
    if (c->pinned && c->ends && c->uv[i][0] >= c->u[1])
        r.t[0] = r.t[1];
    return r;
}

/* Each point's place on the strip, from where it was; anew: or from anywhere.
 */
static ix_status find_feet(ix_ctx *ctx, const cloud *c, const ix__strip *s,
                           bool anew, ix__strip_foot *foot, ix_fit_error *err)
{
    double sum = 0, most = 0;

    for (int i = 0; i < c->n; i++) {
        ix__strip_range in = range_of(c, i, s);
        ix__strip_foot f;

        if (i % 64 == 0)
            IX_TRY(ix__poll(ctx));
        ix__strip_nearest_from(s, c->p[i], foot[i].t, &in, &foot[i]);
        if (anew) {
            ix__strip_nearest(s, c->p[i], &in, &f);
            if (f.dist2 < foot[i].dist2)
                foot[i] = f;
        }
        sum += foot[i].dist2;
        most = fmax(most, foot[i].dist2);
    }
    err->rms = sqrt(sum / c->n);
    err->largest = sqrt(most);
    return IX_OK;
}

/* Where the rulings put the points. */
static ix_status first_feet(ix_ctx *ctx, const cloud *c, const ix__rulings *g,
                            ix__strip_foot **foot)
{
    IX_SCRATCH(ctx, *foot, c->n);
    for (int i = 0; i < c->n; i++)
        (*foot)[i] = (ix__strip_foot){
            .t = ix__rulings_over(g, c->uv[i][0], c->uv[i][1]),
            .x = c->uv[i][1]};
    return IX_OK;
}

static ix_status assess(ix_ctx *ctx, const cloud *c, const ix__rulings *g,
                        ix_mv *const side[2], ix_fit_error *err)
{
    ix__strip_foot *foot;
    ix__strip s;

    IX_TRY(ix__strip_new(ctx, side[0], side[1], &s));
    IX_TRY(first_feet(ctx, c, g, &foot));
    return find_feet(ctx, c, &s, true, foot, err);
}

/* --- both sides at once ----------------------------------------------------
 */

/* Second differences of both sides' control points are asked to be 0 with this
 * weight: it decides what no point of the surface does, and moves the rest by
 * about its square. */
#define FAIRNESS 1e-3

/* Unknowns: the coordinates of the control points of the sides in turn,
 * a0 b0 a1 b1 ...; room for a row. */
typedef struct {
    const ix_dir *dir;
    double *w, *row;
    ix_band b;
} sides;

static ix_status sides_new(ix_ctx *ctx, const ix_dir *dir, sides *out)
{
    /* second differences reach over three control points */
    int width = 6 * (dir->order > 2 || dir->length < 3 ? dir->order : 3);

    out->dir = dir;
    IX_SCRATCH(ctx, out->w, dir->order);
    IX_SCRATCH(ctx, out->row, width);
    return ix__band_new(ctx, 6 * dir->length, width, false, 1, &out->b);
}

static void ask_fair(sides *s)
{
    const double zero = 0;
    double row[13] = {0};

    row[0] = row[12] = FAIRNESS;
    row[6] = -2 * FAIRNESS;
    for (int i = 0; i < 6 * (s->dir->length - 2); i++)
        ix__band_add(&s->b, i, 13, row, &zero);
}

/* Unit vectors perpendicular to each other: first those along which the place
 * can move. */
static void frame_of(const ix__strip_foot *f, double e[3][3])
{
    const double unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    memcpy(e, unit, sizeof unit);
    if (f->nfree == 0)
        return;
    memcpy(e[0], f->free[0], sizeof e[0]);
    if (f->nfree == 2)
        memcpy(e[1], f->free[1], sizeof e[1]);
    else
        ix__perp3(e[0], e[1]);
    ix__cross3(e[0], e[1], e[2]);
}

/* Along directions in which places can move anyway only every few points ask
 * when this is to be loose: that needs only to be some hold. */
enum { HOLDERS = 4 };

/* Point i of the surface asks its place to come: fully, but only with weight
 * `loose` along the directions in which that place can move anyway. */
static void ask_point(sides *s, const cloud *c, int i, const ix__strip_foot *f,
                      double loose)
{
    int first = ix__basis_first(s->dir, f->t), o = s->dir->order;
    double e[3][3];

    ix__basis_derive(s->dir, first, f->t, 0, s->w);
    frame_of(f, e);
    for (int r = 0; r < 3; r++) {
        double weight = 1, rhs;

        if (r < f->nfree && loose < 1) {
            if (i % HOLDERS != 0)
                continue;
            weight = loose * sqrt(HOLDERS);
        }
        for (int q = 0; q < 2 * o; q++)
            for (int k = 0; k < 3; k++)
                s->row[3 * q + k] = weight * s->w[q / 2] *
                                    (q % 2 ? f->x : 1 - f->x) * e[r][k];
        rhs = weight * ix__dot3(e[r], c->p[i]);
        ix__band_add(&s->b, 6 * first, 6 * o, s->row, &rhs);
    }
}

static ix_status solve_sides(ix_ctx *ctx, const cloud *c,
                             const ix__strip_foot *foot, const ix_dir *dir,
                             double loose, int ncoords, ix_mv *side[2])
{
    size_t n = (size_t)dir->length;
    double *x, *pts;
    sides s;

    IX_TRY(sides_new(ctx, dir, &s));
    IX_SCRATCH(ctx, x, 6 * n);
    IX_SCRATCH(ctx, pts, 3 * n);
    ask_fair(&s);
    for (int i = 0; i < c->n; i++)
        ask_point(&s, c, i, &foot[i], loose);
    IX_TRY(ix__band_solve(ctx, &s.b, x));
    for (size_t k = 0; k < 2; k++) {
        for (size_t i = 0; i < 3 * n; i++)
            pts[i] = x[6 * (i % n) + 3 * k + i / n];
        IX_TRY(ix_mv_new(ctx, 1, dir, ncoords, false, pts, &side[k]));
    }
    return IX_OK;
}

/* --- rounds -----------------------------------------------------------------
 */

/* The best sides yet; references. */
typedef struct {
    ix_mv *side[2];
    ix_fit_error err;
} attempt;

static void drop(ix_ctx *ctx, attempt *a)
{
    ix__mv_unref_all(ctx, a->side, 2);
    a->side[0] = a->side[1] = NULL;
}

/* How the places are held along the directions in which they can move: firmly,
 * which lessens the sum of squares for sure, or more loosely, which is faster
 * (damped tangent distances, Wang, Pottmann, Liu 2006). */
static const double loose[] = {1, 0.3, 0.1, 0.03};
enum { LOOSEST = 3 };

static ix_status one_round(ix_ctx *ctx, const cloud *c, const ix_dir *dir,
                           int ncoords, double hold, ix__strip_foot *foot,
                           attempt *out)
{
    ix__strip s;

    IX_TRY(solve_sides(ctx, c, foot, dir, hold, ncoords, out->side));
    IX_TRY(ix__strip_new(ctx, out->side[0], out->side[1], &s));
    return find_feet(ctx, c, &s, false, foot, &out->err);
}

/* Solving and measuring in turn, as loosely as goes well. Ends when a round
 * wins less than a thousandth although the places are held firmly. */
static ix_status settle(ix_ctx *ctx, const cloud *c, const ix_dir *dir,
                        int ncoords, ix__strip_foot *foot, attempt *best)
{
    ix__strip_foot *next;
    int hold = 0;

    IX_SCRATCH(ctx, next, c->n);
    for (int i = 0; i < ROUNDS; i++) {
        attempt a = {{NULL, NULL}, {0, 0}};
        ix_mark mk = ix__scratch_mark(ctx);
        ix_status st;
        bool good;

        memcpy(next, foot, (size_t)c->n * sizeof *next);
        st = one_round(ctx, c, dir, ncoords, loose[hold], next, &a);
        ix__scratch_release(ctx, mk);
        good = a.err.rms < 0.999 * best->err.rms;
        if (st == IX_OK && a.err.rms < best->err.rms) {
            drop(ctx, best);
            *best = a;
            memcpy(foot, next, (size_t)c->n * sizeof *next);
        } else {
            drop(ctx, &a);
            IX_TRY(st);
        }
        if (!good && hold == 0)
            break;
        hold = good ? (hold < LOOSEST ? hold + 1 : hold) : hold - 1;
    }
    return IX_OK;
}

/* The middles of all spans go between n knots, which become more: new count. */
static int halve_spans(int n, double *knots)
{
    int m = n, k;

    for (int i = 0; i + 1 < n; i++)
        m += knots[i] < knots[i + 1];
    k = m - 1;
    for (int i = n - 1; i > 0; i--) {
        double lo = knots[i - 1], hi = knots[i];

        knots[k--] = hi;
        if (lo < hi)
            knots[k--] = (lo + hi) / 2;
    }
    return m;
}

/* The knots of s along its sides, over the rulings; spans halved as long as
 * there are at most so many control points. */
static ix_status side_dir(ix_ctx *ctx, const ix_mv *s, const ix__rulings *g,
                          int most, ix_dir *out)
{
    const ix_dir *d = &s->dirs[0];
    int o = d->order, n = d->length, spans = 0;
    double *a;

    IX_SCRATCH(ctx, a, 2 * (n + o + most));
    for (int i = 0; i < n + o; i++)
        a[i] = i < o    ? (g->t[0] + g->r[0]) / 2
               : i >= n ? (g->t[g->n - 1] + g->r[g->n - 1]) / 2
                        : d->knots[i];
    for (int i = o - 1; i < n; i++)
        spans += a[i] < a[i + 1];
    for (; n + spans <= most; spans *= 2)
        n = halve_spans(n + o, a) - o;
    *out = (ix_dir){.basis = IX_BSPLINE, .order = o, .length = n, .knots = a};
    return IX_OK;
}

/* Sides of a ruled surface whose rulings lean. */
static ix_status leaning(ix_ctx *ctx, const ix_mv *s, const ix_mv *wide,
                         const ix_ruled_opts *o, int fine, ix__rulings *g,
                         attempt *best)
{
    int slack = (int)ceil(o->extend * (o->samples - 1));
    ix__strip_foot *foot;
    ix_dir dir;
    cloud c;

    IX_TRY(ix__rulings_find(ctx, wide, o->samples + 2 * slack, slack, fine, g));
    IX_TRY(side_dir(ctx, s, g, s->dirs[0].order + o->samples / 4, &dir));
    IX_TRY(take_points(ctx, s, o->samples + 2, fine + 1, &c));
    c.pinned = true;
    c.ends = !(o->extend > 0);
    IX_TRY(first_feet(ctx, &c, g, &foot));
    best->err.rms = HUGE_VAL;
    return settle(ctx, &c, &dir, s->ncoords, foot, best);
}

/* --- the whole --------------------------------------------------------------
 */

/* The same surface as it was given (Bezier or B-spline), as an open B-spline,
 * and that one continued at both ends of direction 0. */
typedef struct {
    const ix_mv *own, *s, *wide;
    const ix_ruled_opts *o;
} task;

static ix_status continued(ix_ctx *ctx, const ix_mv *s, const ix_ruled_opts *o,
                           ix_mv **out)
{
    int slack = (int)ceil(o->extend * (o->samples - 1));
    double u[2], far;

    ix_mv_domain(s, 0, u);
    far = (u[1] - u[0]) * slack / (o->samples - 1);
    return ix__mv_continue(ctx, s, 0, (const double[2]){u[0] - far, u[1] + far},
                           out);
}

/* The sides of the surface itself, and how far it is from ruled between. */
static ix_status straight(ix_ctx *ctx, const task *k, const cloud *c,
                          attempt *out)
{
    double u[2], v[2];
    const ix__rulings g = {2, u, u};

    ix_mv_domain(k->s, 0, u);
    ix_mv_domain(k->s, 1, v);
    for (int e = 0; e < 2; e++)
        IX_TRY(ix_mv_fix(ctx, k->own, 1, v[e], &out->side[e]));
    return assess(ctx, c, &g, out->side, &out->err);
}

static ix_status size_of(ix_ctx *ctx, const ix_mv *s, double *out)
{
    double lo[3] = {0}, hi[3] = {0};

    IX_TRY(ix_mv_bbox(ctx, s, lo, hi));
    *out = fmax(hi[0] - lo[0], fmax(hi[1] - lo[1], hi[2] - lo[2]));
    return IX_OK;
}

/* a: the better sides; b is for the others. */
static ix_status better_sides(ix_ctx *ctx, const task *k, attempt *a,
                              attempt *b)
{
    int spans = 2 * k->s->dirs[1].length;
    int fine = spans < 8 ? 8 : spans > 32 ? 32 : spans;
    ix__rulings g;
    double size;
    cloud c;

    IX_TRY(take_points(ctx, k->s, 2 * k->o->samples + 1, 2 * fine + 1, &c));
    IX_TRY(straight(ctx, k, &c, a));
    IX_TRY(size_of(ctx, k->s, &size));
    if (a->err.largest <= 1e-12 * size) /* ruled, up to rounding */
        return IX_OK;
    IX_TRY(leaning(ctx, k->s, k->wide, k->o, fine, &g, b));
    IX_TRY(assess(ctx, &c, &g, b->side, &b->err));
    if (b->err.rms < a->err.rms) {
        attempt t = *a;

        *a = *b;
        *b = t;
    }
    return IX_OK;
}

/* The strip as a surface over v of the domain, its directions as in srf. */
static ix_status strip_surface(ix_ctx *ctx, const attempt *a, const double v[2],
                               int dir, ix_mv *t[2], ix_mv **out)
{
    IX_TRY(ix_srf_ruled(ctx, a->side[0], a->side[1], &t[0]));
    if (v[0] == 0 && v[1] == 1)
        t[1] = ix_mv_ref(t[0]);
    else
        IX_TRY(ix_mv_reparam(ctx, t[0], 1, v[0], v[1], &t[1]));
    if (dir == 0)
        return ix_mv_swap_dirs(ctx, t[1], 0, 1, out);
    *out = ix_mv_ref(t[1]);
    return IX_OK;
}

static ix_status fit(ix_ctx *ctx, const ix_mv *srf, const ix_ruled_opts *o,
                     attempt a[2], ix_mv *t[TEMPS], ix_mv **out)
{
    double v[2];
    task k;

    if (o->dir == 0)
        IX_TRY(ix_mv_swap_dirs(ctx, srf, 0, 1, &t[0]));
    else
        t[0] = ix_mv_ref(srf);
    IX_TRY(ix__mv_plain(ctx, t[0], &t[1]));
    IX_TRY(ix_mv_to_bspline(ctx, t[1], &t[2]));
    IX_TRY(ix_mv_to_open(ctx, t[2], &t[3]));
    if (ix_mv_has_poles(t[3]))
        return IX_FAIL(ctx, IX_EDOMAIN, "weights of both signs, or 0");
    IX_TRY(continued(ctx, t[3], o, &t[4]));
    k = (task){ix__mv_has_basis(t[1], IX_BEZIER) ? t[1] : t[3], t[3], t[4], o};
    IX_TRY(better_sides(ctx, &k, &a[0], &a[1]));
    ix_mv_domain(t[3], 1, v);
    return strip_surface(ctx, &a[0], v, o->dir, t + 5, out);
}

static ix_status check(ix_ctx *ctx, const ix_mv *srf, const ix_ruled_opts *o)
{
    if (srf->ndirs != 2 || srf->ncoords > 3 || srf->dirs[0].order < 2 ||
        srf->dirs[1].order < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions, %d coordinates, orders %d and %d; a "
                       "surface of at most 3 coordinates and orders from 2 on "
                       "is wanted",
                       srf->ndirs, srf->ncoords, srf->dirs[0].order,
                       srf->ndirs > 1 ? srf->dirs[1].order : 0);
    if (o->dir < 0 || o->dir > 1)
        return IX_FAIL(ctx, IX_EARG, "direction %d of a surface", o->dir);
    if (!(o->extend >= 0 && o->extend <= 1))
        return IX_FAIL(ctx, IX_EARG, "an extension by %g; 0 .. 1 is possible",
                       o->extend);
    if (o->samples < 2 || o->samples > 1000)
        return IX_FAIL(ctx, IX_EARG, "%d samples; 2 .. 1000 are possible",
                       o->samples);
    return IX_OK;
}

ix_status ix_srf_fit_ruled(ix_ctx *ctx, const ix_mv *srf,
                           const ix_ruled_opts *o, ix_fit_error *err,
                           ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    attempt a[2] = {{{NULL, NULL}, {0, 0}}, {{NULL, NULL}, {0, 0}}};
    ix_mv *t[TEMPS] = {NULL};
    ix_status st;

    *out = NULL;
    IX_TRY(check(ctx, srf, o));
    st = fit(ctx, srf, o, a, t, out);
    if (err)
        *err = a[0].err;
    drop(ctx, &a[0]);
    drop(ctx, &a[1]);
    ix__mv_unref_all(ctx, t, TEMPS);
    ix__scratch_release(ctx, mk);
    return st;
}
