/* form_diff.c - calculus on forms: partials, derivatives, integrals, finer
 * breaks, values. Everything happens span by span along one direction. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "sym/form_impl.h"

typedef struct {
    int d;
    const double *breaks;
    double h0; /* mean span length */
} slope;

/* --- partials and derivatives --------------------------------------------- */

static void partial_u(const void *arg, size_t span, size_t inner,
                      const double *in, double *out)
{
    const slope *s = arg;
    double h = s->breaks[span + 1] - s->breaks[span];

    ix__bern_partial_u(s->d, h == s->h0 ? 1.0 : s->h0 / h, inner, in, out);
}

static void partial_v(const void *arg, size_t span, size_t inner,
                      const double *in, double *out)
{
    const slope *s = arg;

    (void)span;
    ix__bern_partial_v(s->d, 1.0, inner, in, out);
}

static void derive(const void *arg, size_t span, size_t inner, const double *in,
                   double *out)
{
    const slope *s = arg;

    ix__bern_derive(s->d, 1.0 / (s->breaks[span + 1] - s->breaks[span]), inner,
                    in, out);
}

/* Any of the three: degree and continuity one less. */
static ix_status lower(ix_ctx *ctx, const ix_form *f, int dir, ix__block_fn fn,
                       ix_form *out)
{
    ix_spans sp = f->dirs[dir];
    slope s = {sp.degree, sp.breaks, ix__spans_mean(&sp)};
    ix_form r;

    IX_TRY(ix__cont_shift(ctx, &sp, sp.degree > 0 ? -1 : IX__SMOOTH));
    sp.degree -= sp.degree > 0;
    IX_TRY(ix__form_like(ctx, f, dir, sp, &r));
    if (s.d > 0)
        ix__form_blocks(ctx, f, dir, fn, &s, s.d, &r);
    else
        memset(r.c, 0, (size_t)r.nrows * r.n * sizeof *r.c);
    *out = r;
    return IX_OK;
}

ix_status ix__form_partial(ix_ctx *ctx, const ix_form *f, int dir, ix__uv which,
                           ix_form *out)
{
    return lower(ctx, f, dir, which == IX__U ? partial_u : partial_v, out);
}

ix_status ix__form_partials(ix_ctx *ctx, const ix_form *f, int dir, int k,
                            ix_form *out)
{
    ix_form v = *f; /* differentiated i times by V */

    for (int i = 0; i <= k; i++) {
        if (i > 0)
            IX_TRY(ix__form_partial(ctx, &v, dir, IX__V, &v));
        out[i] = v;
        for (int j = i; j < k; j++)
            IX_TRY(ix__form_partial(ctx, &out[i], dir, IX__U, &out[i]));
    }
    return IX_OK;
}

ix_status ix__form_derive(ix_ctx *ctx, const ix_form *f, int dir, ix_form *out)
{
    return lower(ctx, f, dir, derive, out);
}

ix_status ix__form_jacobian(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                            int dir, ix_form *out)
{
    ix_form pa[2], pb[2];
    const ix_form *const la[2] = {&pa[0], &pa[1]}, *const lb[2] = {&pb[0],
                                                                   &pb[1]};

    IX_TRY(ix__form_partials(ctx, a, dir, 1, pa));
    IX_TRY(ix__form_partials(ctx, b, dir, 1, pb));
    return ix__form_bracket(ctx, la, lb, out);
}

/* --- integrals ------------------------------------------------------------ */

typedef struct {
    slope s;
    size_t inner;
    const double *row, *row1;
    double *start; /* [inner] */
} integral;

static void integrate_block(const void *arg, size_t span, size_t inner,
                            const double *in, double *out)
{
    const integral *w = arg;

    if (span == 0)
        memset(w->start, 0, inner * sizeof *w->start);
    ix__bern_integrate(w->s.d, w->s.breaks[span + 1] - w->s.breaks[span],
                       w->row, w->row1, inner, in, w->start, out);
}

ix_status ix__form_integrate(ix_ctx *ctx, const ix_form *f, int dir,
                             ix_form *out)
{
    ix_spans sp = f->dirs[dir];
    integral w = {.s = {.d = sp.degree, .breaks = sp.breaks}};
    double *room;
    ix_form r;
    ix__shape s;

    IX_TRY(ix__cont_shift(ctx, &sp, 1));
    sp.degree++;
    IX_TRY(ix__form_like(ctx, f, dir, sp, &r));
    IX_SCRATCH(ctx, room, 2 * sp.degree + 1);
    w.row = ix__binom(sp.degree - 1, room);
    w.row1 = ix__binom(sp.degree, room + sp.degree);
    ix__form_shape(f, dir, &s);
    IX_SCRATCH(ctx, w.start, s.inner);
    /* Spans follow each other: a cost of nothing keeps them in one thread. */
    ix__form_blocks(ctx, f, dir, integrate_block, &w, 0.0, &r);
    *out = r;
    return IX_OK;
}

/* --- finer breaks --------------------------------------------------------- */

typedef struct {
    int d;
    size_t inner, nin, nout;
    const int *from;       /* [nout]: the old span that holds each new one */
    const double *lo, *hi; /* [nout]: where, in the local parameter of it */
    const double *row;
} refinement;

static void refine_outer(const refinement *w, const double *in, double *out)
{
    size_t block = ((size_t)w->d + 1) * w->inner;

    for (size_t j = 0; j < w->nout; j++) {
        double *o = out + j * block;

        ix__bern_unscale(1, w->d, w->inner, w->row,
                         in + (size_t)w->from[j] * block, o);
        ix__bern_restrict(w->d, w->lo[j], w->hi[j], w->inner, o, o);
        ix__bern_scale(1, w->d, w->inner, w->row, o, o);
    }
}

/* Where the spans of fine lie in those of f's direction. */
static ix_status locate(ix_ctx *ctx, const ix_spans *old, const ix_spans *fine,
                        refinement *w)
{
    double *lo, *hi;
    int *from, j = 0;

    IX_SCRATCH(ctx, lo, fine->nspans);
    IX_SCRATCH(ctx, hi, fine->nspans);
    IX_SCRATCH(ctx, from, fine->nspans);
    for (int i = 0; i < fine->nspans; i++) {
        double a = fine->breaks[i], b = fine->breaks[i + 1], h;

        while (j + 1 < old->nspans && a / 2 + b / 2 >= old->breaks[j + 1])
            j++;
        h = old->breaks[j + 1] - old->breaks[j];
        from[i] = j;
        lo[i] = fmax(0.0, (a - old->breaks[j]) / h);
        hi[i] = fmin(1.0, (b - old->breaks[j]) / h);
    }
    w->from = from;
    w->lo = lo;
    w->hi = hi;
    return IX_OK;
}

ix_status ix__form_refine(ix_ctx *ctx, const ix_form *f, int dir,
                          const ix_spans *sp, ix_form *out)
{
    const ix_spans *old = &f->dirs[dir];
    ix_spans fine = {old->degree, sp->nspans, sp->breaks, NULL};
    refinement w = {.d = old->degree};
    int *cont, i = 0;
    double *room;
    ix__shape s;
    ix_form r;

    IX_SCRATCH(ctx, cont, sp->nspans);
    IX_TRY(locate(ctx, old, sp, &w));
    for (i = 0; i + 1 < sp->nspans; i++) {
        int j = w.from[i];

        cont[i] = j == w.from[i + 1] ? INT_MAX : old->cont[j];
    }
    fine.cont = cont;
    IX_TRY(ix__form_like(ctx, f, dir, fine, &r));
    IX_SCRATCH(ctx, room, w.d + 1);
    w.row = ix__binom(w.d, room);
    ix__form_shape(f, dir, &s);
    w.inner = s.inner;
    w.nin = s.inner * ix__spans_size(old);
    w.nout = (size_t)sp->nspans;
    for (size_t o = 0; o < s.outer; o++)
        refine_outer(&w, f->c + o * w.nin,
                     r.c + o * s.inner * ix__spans_size(&fine));
    r.bezier &= ~((unsigned)(sp->nspans > 1) << dir);
    *out = r;
    return IX_OK;
}

/* --- values --------------------------------------------------------------- */

int ix__spans_find(const ix_spans *sp, double t)
{
    int lo = 0, hi = sp->nspans;

    while (hi - lo > 1) {
        int mid = (lo + hi) / 2;

        if (t >= sp->breaks[mid])
            lo = mid;
        else
            hi = mid;
    }
    return lo;
}

/* Value of the patch coefficients that begin at c, directions 0 .. dir, by
 * Horner's rule in each (IX_MAX_DIRS deep at most). */
static double patch_value(const ix_form *f, int dir, const double *c,
                          const double (*uv)[2], const size_t *stride)
{
    int d = f->dirs[dir].degree;
    double r = 0.0, pw = 1.0;

    for (int k = 0; k <= d; k++) {
        double x = dir == 0
                       ? c[k]
                       : patch_value(f, dir - 1, c + (size_t)k * stride[dir],
                                     uv, stride);

        r = r * uv[dir][1] + x * pw;
        pw *= uv[dir][0];
    }
    return r;
}

void ix__form_eval(const ix_form *f, const double *t, double *out)
{
    double uv[IX_MAX_DIRS][2];
    size_t stride[IX_MAX_DIRS], base = 0, s = 1;

    for (int i = 0; i < f->ndirs; i++) {
        const ix_spans *sp = &f->dirs[i];
        int j = ix__spans_find(sp, t[i]);
        double a = sp->breaks[j], b = sp->breaks[j + 1];

        uv[i][0] = (t[i] - a) / (b - a);
        uv[i][1] = (b - t[i]) / (b - a);
        stride[i] = s;
        base += (size_t)j * ((size_t)sp->degree + 1) * s;
        s *= ix__spans_size(sp);
    }
    for (int r = 0; r < f->nrows; r++) {
        out[r] = patch_value(f, f->ndirs - 1, f->c + (size_t)r * f->n + base,
                             (const double(*)[2])uv, stride);
        if (f->exp != 0)
            out[r] = ldexp(out[r], f->exp);
    }
}

ix_status ix__form_bound(ix_ctx *ctx, const ix_form *f, double *out)
{
    const double *x;

    IX_TRY(ix__form_bernstein(ctx, f, &x));
    *out = ix__bern_largest((size_t)f->nrows * f->n, x);
    return IX_OK;
}
