/* compose.c - f(g_1, g_2, ..).
 *
 * On a span [a, b] of f the local parameters of direction i are forms in g's
 * parameters, U = (x_i - a w) / h and V = (b w - x_i) / h, and f is the sum of
 * c_k U^k V^(d-k): sums and products of functions between 0 and 1 (DeRose,
 * Goldman, Hagen, Mann 1993 evaluate the same blossom). Where a curve g runs
 * through breaks of f it is cut first, so that each span of g stays in one
 * span of f in every direction. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "bern/bern.h"
#include "sym/form_impl.h"

/* How far g may leave f's domain, as a part of its length (spec/model 9.1). */
#define DOMAIN_TOL 1e-5
/* Refinement of g in search of a point outside ends at this size. */
#define MAX_SEARCH 500000

/* f's directions as functions of g's parameters. */
typedef struct {
    const ix_form *f;             /* rows of f, perhaps with a weight row */
    const int *span[IX_MAX_DIRS]; /* [patches of g]: f's span in each */
    const ix_form *upower[IX_MAX_DIRS]; /* [degree + 1]: U^k */
    ix_form v[IX_MAX_DIRS];
    size_t npatches;
} inner;

/* --- g's coordinates
 * ---------------------------------------------------------- */

/* x_i + factor w of g in direction i of f, as a form of one row. */
static ix_status offset(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                        double sx, double sw, ix_form *out)
{
    IX_TRY(ix__form_copy(ctx, x, out));
    for (size_t k = 0; k < out->n; k++)
        out->c[k] = sx * x->c[k] + sw * w->c[k];
    return IX_OK;
}

/* Weight of g (1 if it has none) at the degrees of its coordinates. */
static ix_status weight_of(ix_ctx *ctx, const ix_form *g, bool rational,
                           ix_form *w)
{
    static const double one = 1.0;
    int degrees[IX_MAX_DIRS];
    const double *b;
    int signs = 0;

    if (!rational) {
        for (int i = 0; i < g->ndirs; i++)
            degrees[i] = g->dirs[i].degree;
        IX_TRY(ix__form_constant(ctx, g, 1, &one, w));
        return ix__form_elevate(ctx, w, degrees, w);
    }
    *w = ix__form_rows(g, 0, 1);
    IX_TRY(ix__form_bernstein(ctx, w, &b));
    for (size_t k = 0; k < w->n; k++)
        signs |= b[k] > 0.0 ? 1 : 2;
    if (signs != 1 && signs != 2)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the inner function has weights of both signs or zero");
    return IX_OK;
}

/* --- staying in the domain
 * ------------------------------------------------------- */

/* Smallest coefficient, and the smallest value at corners of patches. */
static ix_status lowest(ix_ctx *ctx, const ix_form *f, double *coef,
                        double *corner)
{
    const double *b;

    IX_TRY(ix__form_bernstein(ctx, f, &b));
    *coef = *corner = b[0];
    for (size_t k = 0; k < f->n; k++) {
        size_t rest = k;
        bool at = true;

        for (int i = 0; i < f->ndirs; i++) {
            size_t n = (size_t)f->dirs[i].degree + 1, j;

            j = rest % ix__spans_size(&f->dirs[i]) % n;
            rest /= ix__spans_size(&f->dirs[i]);
            at &= j == 0 || j == n - 1;
        }
        *coef = b[k] < *coef ? b[k] : *coef;
        *corner = at && b[k] < *corner ? b[k] : *corner;
    }
    return IX_OK;
}

/* Every span of every direction halved. */
static ix_status halve(ix_ctx *ctx, const ix_form *f, ix_form *out)
{
    *out = *f;
    for (int i = 0; i < f->ndirs; i++) {
        const ix_spans *sp = &f->dirs[i];
        ix_spans fine = {sp->degree, 2 * sp->nspans, NULL, NULL};
        double *br;

        IX_SCRATCH(ctx, br, 2 * (size_t)sp->nspans + 1);
        for (int j = 0; j < sp->nspans; j++) {
            br[2 * j] = sp->breaks[j];
            br[2 * j + 1] = sp->breaks[j] / 2 + sp->breaks[j + 1] / 2;
        }
        br[2 * sp->nspans] = sp->breaks[sp->nspans];
        fine.breaks = br;
        IX_TRY(ix__form_refine(ctx, out, i, &fine, out));
    }
    return IX_OK;
}

/* A polynomial form that should not be negative: finer and finer, until its
 * coefficients tell that it is not or a value tells that it is. What is left
 * open at the end is smaller than can be seen. */
static ix_status check_positive(ix_ctx *ctx, const ix_form *f, int dir,
                                const ix_spans *sp)
{
    ix_form fine = *f;
    double coef, corner;

    for (;;) {
        IX_TRY(lowest(ctx, &fine, &coef, &corner));
        if (coef >= 0.0)
            return IX_OK;
        if (corner < 0.0)
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "coordinate %d of the inner function leaves the "
                           "domain [%g, %g] of direction %d",
                           dir + 1, sp->breaks[0], sp->breaks[sp->nspans], dir);
        if (fine.n > MAX_SEARCH)
            return IX_OK;
        IX_TRY(halve(ctx, &fine, &fine));
    }
}

static ix_status check_range(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                             int dir, const ix_spans *sp)
{
    double lo = sp->breaks[0], hi = sp->breaks[sp->nspans];
    double tol = DOMAIN_TOL * (hi - lo), s = w->c[0] > 0.0 ? 1.0 : -1.0;
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;
    ix_form f;

    st = offset(ctx, x, w, s, -s * (lo - tol), &f);
    if (st == IX_OK)
        st = check_positive(ctx, &f, dir, sp);
    if (st == IX_OK)
        st = offset(ctx, x, w, -s, s * (hi + tol), &f);
    if (st == IX_OK)
        st = check_positive(ctx, &f, dir, sp);
    ix__scratch_release(ctx, mk);
    return st;
}

/* --- cutting a curve g at the breaks of f
 * -------------------------------------------- */

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Where x - brk w changes sign inside its spans, appended to cuts. */
static ix_status crossings(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                           double brk, double *cuts, int *n)
{
    const ix_spans *sp = &x->dirs[0];
    int d = sp->degree;
    double *work, *u, band;
    const double *b;
    ix_form f;

    IX_TRY(offset(ctx, x, w, 1.0, -brk, &f));
    IX_TRY(ix__form_bernstein(ctx, &f, &b));
    IX_SCRATCH(ctx, work, 2 * (d + 1));
    IX_SCRATCH(ctx, u, d + 1);
    IX_TRY(ix__form_bound(ctx, x, &band)); /* rounding of the evaluation */
    band *= 4.0 * (d + 1) * DBL_EPSILON;
    for (int j = 0; j < sp->nspans; j++) {
        double h = sp->breaks[j + 1] - sp->breaks[j];
        int m = ix__bern_crossings(d, b + (size_t)j * (size_t)(d + 1), band,
                                   work, u);

        for (int i = 0; i < m; i++)
            cuts[(*n)++] = sp->breaks[j] + u[i] * h;
    }
    return IX_OK;
}

/* All cuts in all directions, sorted; room for every root there can be. */
static ix_status find_cuts(ix_ctx *ctx, const ix_form *f, const ix_form *x,
                           const ix_form *w, double **out, int *n)
{
    const ix_spans *sp = &x->dirs[0];
    size_t room = 1;

    for (int i = 0; i < f->ndirs; i++)
        room += (size_t)(f->dirs[i].nspans - 1) * (size_t)sp->nspans *
                (size_t)sp->degree;
    IX_SCRATCH(ctx, *out, room);
    *n = 0;
    for (int i = 0; i < f->ndirs; i++) {
        ix_form xi = ix__form_rows(x, i, 1);

        for (int k = 1; k < f->dirs[i].nspans; k++)
            IX_TRY(crossings(ctx, &xi, w, f->dirs[i].breaks[k], *out, n));
    }
    if (*n > 1)
        qsort(*out, (size_t)*n, sizeof **out, by_value);
    return IX_OK;
}

/* Breaks of g and cuts together. A cut within rounding of a break, or of the
 * cut before it, is left out: the value in the middle of a span tells where
 * it lies. */
static ix_status merge_cuts(ix_ctx *ctx, const ix_spans *g, const double *cuts,
                            int n, ix_spans *out)
{
    double *br, tol = 16.0 * DBL_EPSILON *
                      fmax(fabs(g->breaks[0]), fabs(g->breaks[g->nspans]));
    int m = 0, i = 0;

    IX_SCRATCH(ctx, br, (size_t)g->nspans + (size_t)n + 1);
    br[0] = g->breaks[0];
    for (int j = 1; j <= g->nspans; j++) {
        for (; i < n && cuts[i] < g->breaks[j]; i++)
            if (cuts[i] - br[m] > tol && g->breaks[j] - cuts[i] > tol)
                br[++m] = cuts[i];
        br[++m] = g->breaks[j];
    }
    *out = (ix_spans){g->degree, m, br, NULL};
    return IX_OK;
}

/* g on breaks at which it passes those of f. */
static ix_status cut_curve(ix_ctx *ctx, const ix_form *f, const ix_form *x,
                           const ix_form *w, ix_form *g)
{
    ix_spans fine;
    double *cuts;
    int n;

    IX_TRY(find_cuts(ctx, f, x, w, &cuts, &n));
    if (n == 0)
        return IX_OK;
    IX_TRY(merge_cuts(ctx, &g->dirs[0], cuts, n, &fine));
    return ix__form_refine(ctx, g, 0, &fine, g);
}

/* --- the local forms
 * ------------------------------------------------------------------- */

/* f's span on each span of the curve g in direction dir, by the value in the
 * middle; other g meet a single span. */
static ix_status assign(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                        int dir, inner *in)
{
    const ix_spans *sp = &x->dirs[0];
    int *span;

    IX_SCRATCH_ZERO(ctx, span, in->npatches);
    for (int j = 0; x->ndirs == 1 && j < sp->nspans; j++) {
        double t = sp->breaks[j] / 2 + sp->breaks[j + 1] / 2, vx, vw;

        ix__form_eval(x, &t, &vx);
        ix__form_eval(w, &t, &vw);
        span[j] = ix__spans_find(&in->f->dirs[dir], vx / vw);
    }
    in->span[dir] = span;
    return IX_OK;
}

/* U and V of direction dir. */
static ix_status local(ix_ctx *ctx, const ix_form *x, const ix_form *w, int dir,
                       const inner *in, ix_form *u, ix_form *v)
{
    const double *br = in->f->dirs[dir].breaks;
    size_t width = (size_t)x->dirs[0].degree + 1;

    IX_TRY(ix__form_copy(ctx, x, u));
    IX_TRY(ix__form_copy(ctx, x, v));
    for (size_t k = 0; k < x->n; k++) {
        int s = in->span[dir][x->ndirs == 1 ? k / width : 0];
        double h = br[s + 1] - br[s];

        u->c[k] = (x->c[k] - br[s] * w->c[k]) / h;
        v->c[k] = (br[s + 1] * w->c[k] - x->c[k]) / h;
    }
    return IX_OK;
}

static ix_status powers(ix_ctx *ctx, const ix_form *u, int d,
                        const ix_form **out)
{
    static const double one = 1.0;
    ix_form *p;

    IX_SCRATCH(ctx, p, d + 1);
    IX_TRY(ix__form_constant(ctx, u, 1, &one, &p[0]));
    for (int k = 1; k <= d; k++)
        IX_TRY(ix__form_mul(ctx, &p[k - 1], u, &p[k]));
    *out = p;
    return IX_OK;
}

static ix_status prepare(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                         inner *in)
{
    in->npatches = 1;
    for (int i = 0; i < x->ndirs; i++)
        in->npatches *= (size_t)x->dirs[i].nspans;
    for (int i = 0; i < in->f->ndirs; i++) {
        ix_form xi = ix__form_rows(x, i, 1), u;

        IX_TRY(assign(ctx, &xi, w, i, in));
        IX_TRY(local(ctx, &xi, w, i, in, &u, &in->v[i]));
        IX_TRY(powers(ctx, &u, in->f->dirs[i].degree, &in->upower[i]));
    }
    return IX_OK;
}

/* --- substitution
 * ---------------------------------------------------------------------------
 */

/* The coefficient at offset k of each patch of f, constant on g's patches. */
static ix_status leaf(ix_ctx *ctx, const inner *in, size_t k, ix_form *out)
{
    static const double zeros[IX_MAX_COORDS + 1];
    const ix_form *f = in->f;

    IX_TRY(ix__form_constant(ctx, &in->v[0], f->nrows, zeros, out));
    out->exp = f->exp;
    for (size_t p = 0; p < in->npatches; p++) {
        size_t at = k, stride = 1;

        for (int i = 0; i < f->ndirs; i++) {
            at += (size_t)in->span[i][p] * ((size_t)f->dirs[i].degree + 1) *
                  stride;
            stride *= ix__spans_size(&f->dirs[i]);
        }
        for (int r = 0; r < f->nrows; r++)
            out->c[(size_t)r * out->n + p] = f->c[(size_t)r * f->n + at];
    }
    return IX_OK;
}

/* Directions 0 .. dir of f substituted, at offset k of those above: Horner's
 * rule, c_0 V^d + .. + c_d U^d (as deep as f has directions). What a step
 * leaves in scratch but the sum itself is released. */
static ix_status substitute(ix_ctx *ctx, const inner *in, int dir, size_t k,
                            ix_form *out)
{
    size_t stride = 1;

    if (dir < 0)
        return leaf(ctx, in, k, out);
    for (int i = 0; i < dir; i++)
        stride *= ix__spans_size(&in->f->dirs[i]);
    IX_TRY(substitute(ctx, in, dir - 1, k, out));
    for (int j = 1; j <= in->f->dirs[dir].degree; j++) {
        const ix_spans *dirs;
        ix_status st;
        ix_mark mk;
        ix_form c;

        IX_TRY(ix__form_mul(ctx, out, &in->v[dir], out));
        dirs = out->dirs; /* those of every term */
        mk = ix__scratch_mark(ctx);
        st = substitute(ctx, in, dir - 1, k + (size_t)j * stride, &c);
        if (st == IX_OK)
            st = ix__form_mul_add(ctx, &c, 1, &in->upower[dir][j], out);
        ix__scratch_release(ctx, mk);
        out->dirs = dirs;
        IX_TRY(st);
    }
    return IX_OK;
}

/* At each break of the result: g's own continuity, and that of f at every
 * break of f between the spans on the left and on the right. */
static ix_status limit_cont(ix_ctx *ctx, const inner *in, ix_form *r)
{
    ix_spans *sp;
    int *cont;

    IX_SCRATCH(ctx, sp, 1);
    *sp = r->dirs[0];
    IX_SCRATCH(ctx, cont, sp->nspans);
    for (int j = 0; j + 1 < sp->nspans; j++) {
        cont[j] = sp->cont[j];
        for (int i = 0; i < in->f->ndirs; i++) {
            int a = in->span[i][j], b = in->span[i][j + 1];
            int lo = a < b ? a : b, hi = a < b ? b : a;

            for (int q = lo; q < hi; q++)
                if (in->f->dirs[i].cont[q] < cont[j])
                    cont[j] = in->f->dirs[i].cont[q];
        }
    }
    sp->cont = cont;
    r->dirs = sp;
    return IX_OK;
}

static ix_status check_operands(ix_ctx *ctx, const ix_form *f, const ix_form *g,
                                int ncoords)
{
    long total = 0;

    if (ncoords < f->ndirs)
        return IX_FAIL(ctx, IX_EARG,
                       "an inner function of %d coordinates for %d directions",
                       ncoords, f->ndirs);
    for (int i = 0; i < f->ndirs; i++) {
        if (f->dirs[i].nspans > 1 && g->ndirs > 1)
            return IX_FAIL(ctx, IX_EARG,
                           "direction %d has interior knots: only curves can "
                           "be substituted, not %d directions",
                           i, g->ndirs);
        total += f->dirs[i].degree;
    }
    for (int i = 0; i < g->ndirs; i++)
        if (total * g->dirs[i].degree >= IX_MAX_ORDER)
            return IX_FAIL(ctx, IX_EUNABLE,
                           "a composition of order %ld, at most %d",
                           total * g->dirs[i].degree + 1, IX_MAX_ORDER);
    return IX_OK;
}

/* f's rows; a weight row of ones first if only g is rational. */
static ix_status outer_rows(ix_ctx *ctx, const ix_mv *f, bool rational,
                            ix_form *out)
{
    static const double one = 1.0;
    ix_form poly, w;
    const ix_form *parts[2] = {&w, &poly};

    if (f->rational || !rational)
        return ix__forms_load(ctx, 1, &f, NULL, out);
    IX_TRY(ix__forms_load(ctx, 1, &f, NULL, &poly));
    IX_TRY(ix__form_constant(ctx, &poly, 1, &one, &w));
    return ix__form_join(ctx, 2, parts, out);
}

static ix_status compose(ix_ctx *ctx, const ix_mv *fm, const ix_mv *gm,
                         ix_mv **out)
{
    bool rational = fm->rational || gm->rational;
    ix_form f, g, w, x, r;
    inner in = {.f = &f};

    IX_TRY(outer_rows(ctx, fm, rational, &f));
    IX_TRY(ix__forms_load(ctx, 1, &gm, NULL, &g));
    ix__form_times(&g, ldexp(1.0, g.exp));
    g.exp = 0;
    IX_TRY(check_operands(ctx, &f, &g, gm->ncoords));
    IX_TRY(weight_of(ctx, &g, gm->rational, &w));
    x = ix__form_rows(&g, gm->rational, gm->ncoords);
    for (int i = 0; i < f.ndirs; i++) {
        ix_form xi = ix__form_rows(&x, i, 1);

        IX_TRY(check_range(ctx, &xi, &w, i, &f.dirs[i]));
    }
    if (g.ndirs == 1)
        IX_TRY(cut_curve(ctx, &f, &x, &w, &g));
    IX_TRY(weight_of(ctx, &g, gm->rational, &w));
    x = ix__form_rows(&g, gm->rational, gm->ncoords);
    IX_TRY(prepare(ctx, &x, &w, &in));
    IX_TRY(substitute(ctx, &in, f.ndirs - 1, 0, &r));
    if (g.ndirs == 1)
        IX_TRY(limit_cont(ctx, &in, &r));
    r.bezier = f.bezier == (1u << f.ndirs) - 1u ? g.bezier : 0;
    return ix__form_store(ctx, &r, rational, NULL, out);
}

ix_status ix_sym_compose(ix_ctx *ctx, const ix_mv *f, const ix_mv *g,
                         ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    st = compose(ctx, f, g, out);
    ix__scratch_release(ctx, mk);
    return st;
}
