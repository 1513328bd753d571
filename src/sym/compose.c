/* compose.c - f(g_1, g_2, ..).
 *
 * On a span [a, b] of f the local parameters of direction i are forms in g's
 * parameters, U = (x_i - a w) / h and V = (b w - x_i) / h, and f is the sum of
 * c_k U^k V^(d-k): sums and products of functions between 0 and 1 (DeRose,
 * Goldman, Hagen, Mann 1993 evaluate the same blossom). Where a curve g runs
 * through breaks of f it is cut first, so that each span of g stays in one
 * span of f in every direction. */
#include <math.h>

#include "sym/compose_impl.h"

/* f's directions as functions of g's parameters. */
typedef struct {
    const ix_form *f;             /* rows of f, perhaps with a weight row */
    const int *span[IX_MAX_DIRS]; /* [patches of g]: f's span in each */
    const ix_form *upower[IX_MAX_DIRS]; /* [degree + 1]: U^k */
    ix_form v[IX_MAX_DIRS];
    size_t npatches;
} inner;

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

/* --- the local forms ------------------------------------------------------ */

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

/* --- substitution --------------------------------------------------------- */

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

        IX_TRY(ix__inner_check(ctx, &xi, &w, i, &f.dirs[i]));
    }
    if (g.ndirs == 1)
        IX_TRY(ix__inner_cut(ctx, &f, &x, &w, &g));
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
    *out = NULL;
    IX_RETURN_SCOPED(ctx, compose(ctx, f, g, out));
}
