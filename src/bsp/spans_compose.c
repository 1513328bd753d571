/* spans_compose.c - Bernstein coefficients of spans to B-spline coefficients.
 *
 * The B-spline coefficient i is the blossom value f(t[i+1], .., t[i+degree])
 * of any span inside its support (Ramshaw 1989). Arguments at the ends a, b
 * of the chosen span only select coefficients; each other argument u costs one
 * de Casteljau step and multiplies errors by up to (|u-a| + |u-b|) / (b-a).
 *
 * Where many arguments are far away (high degree and high continuity), least
 * squares over all spans multiply errors much less: by the condition of the
 * B-spline basis, about (pi/2)^order for even simple knots (Lyche 1978). */
#include <math.h>
#include <string.h>

#include "base/threads.h"
#include "bsp/knots.h"
#include "bsp/spans.h"
#include "bsp/weigh.h"

typedef struct {
    const ix_spans *sp;
    const int *at;    /* [knots]: which break each knot of the result is */
    const int *run;   /* [nspans + 2]: knots at or after each break */
    const double *in; /* [outer][nin][inner] */
    double *out;      /* [outer][nout][inner] */
    size_t outer, inner, nin, nout;
    int *chosen;  /* [nout]: span of each coefficient, or NULL */
    double *cost; /* [nout]: its amplification, with chosen only */
} job;

/* Below this degree a direct sum multiplies errors by about 1000 at most. */
#define SAFE_DEGREE 8
/* Amplification beyond which least squares are worth their price. */
#define TOO_MUCH 1e4

/* Arguments of coefficient i that are at break j. */
static int count_at(const job *jb, int i, int j)
{
    int d = jb->sp->degree;
    int lo = jb->run[j] > i + 1 ? jb->run[j] : i + 1;
    int hi = jb->run[j + 1] < i + d + 1 ? jb->run[j + 1] : i + d + 1;

    return hi > lo ? hi - lo : 0;
}

static double int_power(double x, int n)
{
    double p = 1;

    while (n > 0) {
        if (n & 1)
            p *= x;
        x *= x;
        n >>= 1;
    }
    return p;
}

/* By how much span j amplifies errors of coefficient i; anything not below
 * limit once it is known to be no better. */
static double amplification(const job *jb, int i, int j, const int range[2],
                            double limit)
{
    const double *br = jb->sp->breaks;
    double a = br[j], b = br[j + 1], cost = 1;

    for (int k = range[0]; k <= range[1] && cost < limit; k++)
        if (k != j && k != j + 1)
            cost *= int_power((fabs(br[k] - a) + fabs(br[k] - b)) / (b - a),
                              count_at(jb, i, k));
    return cost;
}

/* The span whose blossom gives coefficient i best. Between three breaks, the
 * longer span with the more arguments at its ends is best without a count. */
static int choose_span(const job *jb, int i, const int range[2])
{
    const double *br = jb->sp->breaks;
    int best = range[0];
    double least = HUGE_VAL;

    if (range[1] - range[0] == 2) {
        double longer = (br[best + 1] - br[best]) -
                        (br[best + 2] - br[best + 1]);
        int more = count_at(jb, i, best) - count_at(jb, i, best + 2);

        if (more >= 0 && longer >= 0)
            return best;
        if (more <= 0 && longer <= 0)
            return best + 1;
    }
    for (int j = range[0]; j < range[1] && least > 1; j++) {
        double cost = amplification(jb, i, j, range, least);

        if (cost < least) {
            least = cost;
            best = j;
        }
    }
    return best;
}

/* Weights, in the blossom value at the arguments of coefficient i, of the
 * coefficients of span j that follow the first count_at(j + 1); returns their
 * number less one. */
static int blossom(const job *jb, int i, int j, const int range[2], double *w)
{
    const double *br = jb->sp->breaks;
    double gap = br[j + 1] - br[j];
    int e = 0;

    w[0] = 1;
    for (int k = range[0]; k <= range[1]; k++) {
        double s = (br[k] - br[j]) / gap, r = (br[j + 1] - br[k]) / gap;

        if (k == j || k == j + 1)
            continue;
        for (int m = count_at(jb, i, k); m > 0; m--) {
            w[e + 1] = s * w[e];
            for (int q = e; q > 0; q--)
                w[q] = r * w[q] + s * w[q - 1];
            w[0] *= r;
            e++;
        }
    }
    return e;
}

/* Coefficient i of all rows from e + 1 coefficients of a span. */
static void put_sum(const job *jb, size_t i, size_t from, const double *w,
                    int e)
{
    for (size_t o = 0; o < jb->outer; o++)
        ix__weigh(jb->inner, e + 1, w,
                  jb->in + (o * jb->nin + from) * jb->inner, NULL,
                  jb->out + (o * jb->nout + i) * jb->inner);
}

/* Coefficients i .. i + n - 1 of all rows are those of a span. */
static void put_copies(const job *jb, size_t i, size_t from, size_t n)
{
    for (size_t o = 0; o < jb->outer; o++)
        memcpy(jb->out + (o * jb->nout + i) * jb->inner,
               jb->in + (o * jb->nin + from) * jb->inner,
               n * jb->inner * sizeof *jb->out);
}

/* From coefficient i on, those whose arguments are all at the ends of one
 * span; returns the first that is not. */
static int compose_run(const job *jb, int i, int end)
{
    int d = jb->sp->degree, j = jb->at[i + (d > 0)], first, stop;

    if (d > 0 && jb->at[i + d] == j && jb->at[i] < j)
        j--; /* all at one break: the end of the span before it */
    first = i + d + 1 - jb->run[j + 1];
    first = first < 0 ? 0 : first > d ? d : first;
    stop = i + d + 1 - first;
    if (j + 2 <= jb->sp->nspans && jb->run[j + 2] - d < stop)
        stop = jb->run[j + 2] - d;
    if (first == 0 || d == 0) /* the next one starts afresh */
        stop = i + 1;
    stop = stop < end ? stop : end;
    put_copies(jb, (size_t)i, (size_t)j * (size_t)(d + 1) + (size_t)first,
               (size_t)(stop - i));
    return stop;
}

static void compose_items(void *arg, size_t begin, size_t end)
{
    const job *jb = arg;
    int d = jb->sp->degree, i = (int)begin;
    double w[IX_MAX_ORDER];

    while (i < (int)end) {
        int range[2] = {jb->at[i + (d > 0)], jb->at[i + d]}, j, e;

        if (range[1] - range[0] <= 1) {
            i = compose_run(jb, i, (int)end);
            continue;
        }
        j = jb->chosen ? jb->chosen[i] : choose_span(jb, i, range);
        e = blossom(jb, i, j, range, w);
        put_sum(jb, (size_t)i,
                (size_t)j * (size_t)(d + 1) + (size_t)count_at(jb, i, j + 1), w,
                e);
        i++;
    }
}

static void choose_items(void *arg, size_t begin, size_t end)
{
    const job *jb = arg;
    int d = jb->sp->degree;

    for (size_t k = begin; k < end; k++) {
        int i = (int)k, range[2] = {jb->at[i + (d > 0)], jb->at[i + d]};

        jb->cost[k] = 1;
        if (range[1] - range[0] <= 1)
            continue;
        jb->chosen[k] = choose_span(jb, i, range);
        jb->cost[k] = amplification(jb, i, jb->chosen[k], range, HUGE_VAL);
    }
}

/* Chooses the spans of all coefficients; the largest amplification. */
static ix_status choose_all(ix_ctx *ctx, job *jb, double *worst)
{
    IX_SCRATCH(ctx, jb->chosen, jb->nout);
    IX_SCRATCH(ctx, jb->cost, jb->nout);
    ix__parallel(ctx, jb->nout, 20 + 2 * jb->sp->degree, choose_items, jb);
    *worst = 1;
    for (size_t i = 0; i < jb->nout; i++)
        *worst = fmax(*worst, jb->cost[i]);
    return IX_OK;
}

/* Which break each knot is, and where the knots of each break begin. */
static ix_status index_knots(ix_ctx *ctx, const ix_spans *sp, const ix_dir *dir,
                             job *jb)
{
    int n = dir->length + dir->order, j = 0;
    const double *kv;
    int *at, *run;

    IX_TRY(ix__dir_knots(ctx, dir, &kv));
    IX_SCRATCH(ctx, at, n);
    IX_SCRATCH(ctx, run, sp->nspans + 2);
    run[0] = 0;
    for (int i = 0; i < n; i++) {
        while (kv[i] > sp->breaks[j])
            run[++j] = i;
        at[i] = j;
    }
    run[sp->nspans + 1] = n;
    jb->at = at;
    jb->run = run;
    return IX_OK;
}

ix_status ix__spans_amplification(ix_ctx *ctx, const ix_spans *sp,
                                  const ix_dir *dir, double *worst)
{
    job jb = {.sp = sp, .nout = (size_t)dir->length};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = index_knots(ctx, sp, dir, &jb);

    if (st == IX_OK)
        st = choose_all(ctx, &jb, worst);
    ix__scratch_release(ctx, mk);
    return st;
}

static ix_status compose(ix_ctx *ctx, const ix_dir *dir, job *jb)
{
    double rows = (double)jb->outer * (double)jb->inner, worst = 1, *err;

    IX_TRY(index_knots(ctx, jb->sp, dir, jb));
    if (jb->sp->degree >= SAFE_DEGREE)
        IX_TRY(choose_all(ctx, jb, &worst));
    if (!(worst <= TOO_MUCH)) {
        IX_SCRATCH(ctx, err, jb->outer);
        return ix__spans_fit(ctx, jb->sp, dir, jb->outer, jb->inner, jb->in,
                             jb->out, err);
    }
    ix__parallel(ctx, jb->nout, 20 + rows * (2 + jb->sp->degree / 8.0),
                 compose_items, jb);
    return IX_OK;
}

ix_status ix__spans_compose(ix_ctx *ctx, const ix_spans *sp, const ix_dir *dir,
                            size_t outer, size_t inner, const double *in,
                            double *out)
{
    job jb = {.sp = sp, .in = in, .out = out, .outer = outer, .inner = inner};
    jb.nin = (size_t)sp->nspans * (size_t)(sp->degree + 1);
    jb.nout = (size_t)dir->length;
    IX_RETURN_SCOPED(ctx, compose(ctx, dir, &jb));
}
