/* The components of bisectors of segments, against a walk along the bisector
 * that knows nothing but distances by dense sampling: from infinity (or from
 * between both) on, at each step the place on a small circle ahead where the
 * distances are equal, with feet that are ends or not. The sequences of feet
 * are the same, and so are the classes of the ends (Adamou et al., definition
 * 2).
 *
 * IX_TEST_ROUNDS=200 walks along that many bisectors of random disjoint
 * segments, IX_TEST_FIRST=17 begins with that one; by default two. */
#include "planar_pairs.h"
#include "planar_truth.h"

enum { MOST = 64 };
/* Farther out nothing is looked at. */
#define REACH 40.0
/* Feet nearer to an end, as a part of the curve, are the end. */
#define AT_END 1e-6

static const double pi = 3.14159265358979323846;

/* A foot that gets nearer reaches the end; others jump there. The walk tells
 * where feet change to 1e-4 of the size. */
#define REACHES 0.02

/* Where both feet are: 0, 1 an end, 2 between; the parameters at the beginning
 * and the end. */
typedef struct {
    int at[2];
    double t[2][2];
} feet;

typedef struct {
    int n;
    feet f[MOST];
    int ends[4]; /* feet of the ends of both in curve-curve components */
} sequence;

typedef struct {
    ix_ctx *ctx;
    truth_set set[2];
    double mid[2], size;
    double step; /* relative to the distance from the middle */
    int pair;
} problem;

static feet feet_at(const problem *p, const double x[2])
{
    feet o;

    for (int k = 0; k < 2; k++) {
        truth_foot f = truth_nearest(&p->set[k], x, false, NULL);

        o.at[k] = f.u <= AT_END ? 0 : f.u >= 1 - AT_END ? 1 : 2;
        o.t[0][k] = o.t[1][k] = f.u;
    }
    return o;
}

static bool same(const feet *a, const feet *b)
{
    return a->at[0] == b->at[0] && a->at[1] == b->at[1];
}

/* --- the walk --------------------------------------------------------------
 */

static void on_circle(const double c[2], double h, double a, double out[2])
{
    out[0] = c[0] + h * cos(a);
    out[1] = c[1] + h * sin(a);
}

/* The place on the circle around c between the angles lo and hi where the first
 * becomes the nearer one. */
static double settle(const problem *p, const double c[2], double h, double lo,
                     double hi)
{
    double x[2];

    for (int i = 0; i < 20; i++) {
        double m = 0.5 * (lo + hi);

        on_circle(c, h, m, x);
        if (truth_difference(p->set, x) > 0)
            lo = m;
        else
            hi = m;
    }
    return 0.5 * (lo + hi);
}

/* From b in direction *a on by h: true if there is one place with the first
 * curve to the left. */
static bool ahead(const problem *p, const double b[2], double h, double *a,
                  double out[2])
{
    enum { N = 16 };
    const double wide = 2.4;
    int found = 0;
    double last = 0, at = 0;

    for (int i = 0; i <= N; i++) {
        double x[2], d;

        on_circle(b, h, *a - wide + 2 * wide * i / N, x);
        d = truth_difference(p->set, x);
        if (i && last > 0 && d <= 0) {
            found++;
            at = *a - wide + 2 * wide * i / N;
        }
        last = d;
    }
    if (found != 1)
        return false;
    *a = settle(p, b, h, at - 2 * wide / N, at);
    on_circle(b, h, *a, out);
    return true;
}

static void add_feet(const problem *p, sequence *s, const feet *f)
{
    if (s->n && same(&s->f[s->n - 1], f)) {
        memcpy(s->f[s->n - 1].t[1], f->t[1], sizeof f->t[1]);
        return;
    }
    if (s->n == MOST)
        fail_msg("pair %d: more than %d components", p->pair, MOST);
    s->f[s->n++] = *f;
}

/* The step from b to where the walk is at h, halved while the feet change. */
static void step(const problem *p, const double b[2], double a, double h,
                 double out[2], double *dir, sequence *s)
{
    double m[2], at = a;
    feet f, g;

    if (!ahead(p, b, h, &at, out)) {
        if (h < 1e-7 * p->size)
            fail_msg("pair %d: no way on from (%.12g, %.12g)", p->pair, b[0],
                     b[1]);
        step(p, b, a, 0.5 * h, m, &at, s);
        step(p, m, at, 0.5 * h, out, dir, s);
        return;
    }
    f = feet_at(p, b);
    g = feet_at(p, out);
    if (!same(&f, &g) && h > 1e-4 * p->size) {
        step(p, b, a, 0.5 * h, m, &at, s);
        step(p, m, at, 0.5 * h, out, dir, s);
        return;
    }
    add_feet(p, s, &g);
    *dir = at;
}

/* Where the bisector comes in from far away, and its direction; false if it is
 * closed. */
static bool from_far(const problem *p, double b[2], double *a)
{
    enum { N = 720 };
    double h = REACH * p->size, last = 0, x[2];

    for (int i = 0; i <= N; i++) {
        double d;

        on_circle(p->mid, h, 2 * pi * i / N, x);
        d = truth_difference(p->set, x);
        /* inwards: the first curve to the left is at the smaller angle */
        if (i && last < 0 && d >= 0) {
            double lo = 2 * pi * (i - 1) / N, hi = 2 * pi * i / N;

            for (int j = 0; j < 36; j++) {
                double m = 0.5 * (lo + hi);

                on_circle(p->mid, h, m, x);
                if (truth_difference(p->set, x) < 0)
                    lo = m;
                else
                    hi = m;
            }
            on_circle(p->mid, h, lo, b);
            *a = lo + pi;
            return true;
        }
        last = d;
    }
    return false;
}

/* A place between both curves, and a direction with the first to the left. */
static void from_between(const problem *p, double b[2], double *a)
{
    const double *c = p->set[0].arc[0].x[0], *d = p->set[1].arc[0].x[0];
    double lo = 0, hi = 1;

    for (int i = 0; i < 50; i++) {
        double m = 0.5 * (lo + hi);

        for (int k = 0; k < 2; k++)
            b[k] = c[k] + m * (d[k] - c[k]);
        if (truth_difference(p->set, b) < 0)
            lo = m;
        else
            hi = m;
    }
    /* the first on the left: the direction has it turned by 90 degrees */
    *a = atan2(c[1] - d[1], c[0] - d[0]) - 0.5 * pi;
}

/* How often a component of two inner feet ends (e 1) or begins (0) with one of
 * them at an end of its curve. */
static void count_ends(sequence *s, bool closed)
{
    memset(s->ends, 0, sizeof s->ends);
    for (int i = 0; i < 2 * s->n; i++) {
        int e = i % 2, j = i / 2 + (e ? 1 : -1);
        const feet *f = &s->f[i / 2];

        if (closed)
            j = (j + s->n) % s->n;
        if (j < 0 || j >= s->n || f->at[0] != 2 || f->at[1] != 2)
            continue;
        for (int k = 0; k < 2; k++) {
            int at = s->f[j].at[k];

            if (at != 2 && fabs(f->t[e][k] - at) < REACHES &&
                s->ends[2 * k + at] < 2)
                s->ends[2 * k + at]++;
        }
    }
}

static bool walk(const problem *p, sequence *s)
{
    double b[2], a, start[2], x[2];
    bool far = from_far(p, b, &a);
    feet f;

    if (!far)
        from_between(p, b, &a);
    memcpy(start, b, sizeof start);
    s->n = 0;
    f = feet_at(p, b);
    add_feet(p, s, &f);
    for (int i = 0;; i++) {
        double off = truth_dist(b, p->mid), h;

        h = p->step * fmax(off, p->size);
        step(p, b, a, h, x, &a, s);
        memcpy(b, x, sizeof b);
        if (far && i > 5 && truth_dist(b, p->mid) > REACH * p->size)
            break;
        if (!far && i > 5 && truth_dist(b, start) < 1.2 * h)
            break;
        if (i > 100000)
            fail_msg("pair %d: the walk does not end", p->pair);
    }
    if (!far && s->n > 1 && same(&s->f[0], &s->f[s->n - 1])) {
        memcpy(s->f[0].t[0], s->f[s->n - 1].t[0], sizeof s->f[0].t[0]);
        s->n--;
    }
    count_ends(s, !far);
    return !far;
}

/* --- comparison ------------------------------------------------------------
 */

/* What the result says, without what begins beyond the reach of the walk. */
static void told(const problem *p, const ix_bisector *b, sequence *s)
{
    s->n = 0;
    for (int i = 0; i < b->n; i++) {
        const ix_bisector_piece *g = &b->piece[i];
        feet f;
        bool in = false;

        for (int j = 0; j < g->n && !in; j++)
            in = truth_dist(g->x + 2 * j, p->mid) < REACH * p->size;
        for (int k = 0; k < 2; k++) {
            f.at[k] = !g->point[k] ? 2 : g->foot[k] > 0.5;
            for (int e = 0; e < 2; e++)
                f.t[e][k] = g->foot[e ? 2 * (g->n - 1) + k : k];
        }
        if (in)
            add_feet(p, s, &f);
    }
    if (b->closed && s->n > 1 && same(&s->f[0], &s->f[s->n - 1]))
        s->n--;
}

static bool equal(const sequence *a, const sequence *b, bool closed)
{
    for (int shift = 0; shift < (closed ? a->n : 1); shift++)
        for (int back = 0; back < 2; back++) {
            bool all = a->n == b->n;

            for (int i = 0; i < a->n && all; i++) {
                int j = (back ? a->n - 1 - i : i) + shift;

                all = same(&a->f[j % a->n], &b->f[i]);
            }
            if (all)
                return true;
        }
    return false;
}

static void show(const char *name, const sequence *s)
{
    printf("%s:", name);
    for (int i = 0; i < s->n; i++)
        printf(" %c%c", "01c"[s->f[i].at[0]], "01c"[s->f[i].at[1]]);
    printf("\n");
}

/* Does any piece end near the reach of the walk, or beyond? */
static bool ends_far(const problem *p, const ix_bisector *b)
{
    for (int i = 0; i < b->n; i++)
        for (int e = 0; e < 2; e++) {
            const ix_bisector_piece *g = &b->piece[i];

            if (!g->unbounded[e] && truth_dist(g->x + (e ? 2 * (g->n - 1) : 0),
                                               p->mid) > 0.5 * REACH * p->size)
                return true;
        }
    return false;
}

/* The components of c[0] and c[1]; how many. */
static int check(ix_ctx *ctx, ix_mv *c[2], int pair, double step_size)
{
    const ix_mv *const a[1] = {c[0]}, *const b[1] = {c[1]};
    problem p = {.ctx = ctx, .pair = pair, .step = step_size};
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    sequence seen, said;
    ix_end_class end[4];
    ix_bisector s;
    bool closed;

    for (int k = 0; k < 2; k++) {
        p.set[k] = truth_of(ctx, 1, k ? b : a);
        for (int i = 0; i < 2; i++) {
            lo[i] = fmin(lo[i], p.set[k].arc[0].box[0][i]);
            hi[i] = fmax(hi[i], p.set[k].arc[0].box[1][i]);
        }
    }
    for (int i = 0; i < 2; i++)
        p.mid[i] = 0.5 * (lo[i] + hi[i]);
    p.size = 0.5 * fmax(hi[0] - lo[0], hi[1] - lo[1]);
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, a, 1, b, 0, &s));
    closed = walk(&p, &seen);
    told(&p, &s, &said);
    ix_bisector_ends(&s, c[0], c[1], end);
    if (closed != s.closed || !equal(&seen, &said, closed)) {
        show("seen", &seen);
        show("said", &said);
        fail_msg("pair %d: other components", pair);
    }
    for (int i = 0; i < 4 && !ends_far(&p, &s); i++)
        if ((int)end[i] != seen.ends[i])
            fail_msg("pair %d: end %d has %d feet, not %d", pair, i,
                     seen.ends[i], (int)end[i]);
    ix_bisector_free(ctx, &s);
    for (int k = 0; k < 2; k++)
        free(p.set[k].arc);
    return seen.n;
}

/* --- cases -----------------------------------------------------------------
 */

static double apart(ix_ctx *ctx, ix_mv *c[2])
{
    const ix_mv *const a[1] = {c[0]}, *const b[1] = {c[1]};
    truth_set s = truth_of(ctx, 1, a), t = truth_of(ctx, 1, b);
    double best = INFINITY;

    for (int i = 0; i <= ARC_SAMPLES; i++)
        best = fmin(best, truth_distance(&t, s.arc[0].x[i]));
    free(s.arc);
    free(t.arc);
    return best;
}

/* Straight ones, parabolas, conic arcs, and cubics now and then. */
static void random_pair(ix_ctx *ctx, int pair, ix_mv *c[2])
{
    ix_rng r = {4711u + (uint64_t)pair * 7919u};

    r.s = ix_rng_next(&r);
    do {
        pair_points a, b;
        bool cubic = pair % 8 == 7;

        a = pair_random(&r, cubic ? 3 : ix_rng_int(&r, 1, 2), 1,
                        ix_rng_int(&r, 0, 3) == 0, 0, 0, 1);
        b = pair_random(&r, cubic ? 3 : 2, 1, ix_rng_int(&r, 0, 3) == 0, 0, 0,
                        1);
        for (int k = 0; k < 2; k++)
            c[k] = pair_curve(ctx, k ? &b : &a);
        if (apart(ctx, c) > 0.05)
            return;
        ix_mv_unref(ctx, c[0]);
        ix_mv_unref(ctx, c[1]);
    } while (true);
}

static int number_of(const char *name, int otherwise)
{
    const char *s = getenv(name);

    return s ? atoi(s) : otherwise;
}

static void random_segments(void **state)
{
    int n = number_of("IX_TEST_ROUNDS", 2),
        first = number_of("IX_TEST_FIRST", 0);

    (void)state;
    for (int i = first; i < first + n; i++) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);
        ix_mv *c[2];
        int count;

        random_pair(ctx, i, c);
        count = check(ctx, c, i, n > 2 ? 0.02 : 0.12);
        if (n > 2)
            printf("pair %d: %d components\n", i, count);
        ix_mv_unref(ctx, c[0]);
        ix_mv_unref(ctx, c[1]);
        ix_ctx_free(ctx);
    }
}

/* Pairs in which something was wrong once: components of a curve that crosses
 * itself came in the order around it. */
static void found(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c[2];

    (void)state;
    random_pair(ctx, 79, c);
    (void)check(ctx, c, 79, 0.12);
    ix_mv_unref(ctx, c[0]);
    ix_mv_unref(ctx, c[1]);
    ix_ctx_free(ctx);
}

/* Eight components of two disjoint quadratic segments. */
static void eight(void **state)
{
    static const double p[2][2][3][2] = {
        {{{-0.28, 0.12}, {0.27, 0.84}, {-0.42, -0.11}},
         {{-0.27, -0.07}, {0.62, -0.05}, {-0.96, -0.45}}},
        {{{-0.64, -0.15}, {0.5, -0.69}, {0.27, -0.42}},
         {{-0.39, 0.83}, {-0.04, 0.11}, {-0.03, -0.14}}}};

    (void)state;
    for (int i = 0; i < 2; i++) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);
        ix_mv *c[2];

        for (int k = 0; k < 2; k++) {
            pair_points a = {.n = 3, .degree = 2};

            memcpy(a.p, p[i][k], sizeof p[i][k]);
            c[k] = pair_curve(ctx, &a);
        }
        assert_int_equal(check(ctx, c, -1 - i, 0.12), 8);
        ix_mv_unref(ctx, c[0]);
        ix_mv_unref(ctx, c[1]);
        ix_ctx_free(ctx);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_segments),
        cmocka_unit_test(eight),
        cmocka_unit_test(found),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
