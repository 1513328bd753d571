/* merge.c - two multivariates end to end in one direction, and a curve with a
 * straight segment to a point (spec/model 12).
 *
 * The result's knots are those of a without the last, the joint's, and those
 * of b behind its first order, shifted. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"

/* --- lengths of control polygons ---------------------------------------- */

/* Euclidean point i of a row of control points. */
static double coordinate(const ix_mv *m, int c, size_t i)
{
    double x = ix_mv_coord(m, c)[i];

    return m->rational ? x / m->pts[i] : x;
}

static double distance(const ix_mv *a, size_t i, const ix_mv *b, size_t j)
{
    double sum = 0;

    for (int c = 0; c < a->ncoords; c++) {
        double d = coordinate(b, c, j) - coordinate(a, c, i);

        sum += d * d;
    }
    return sqrt(sum);
}

/* Index of point i of row r (a combination of the other directions). */
static size_t point_at(const ix_mv *m, int dir, size_t r, size_t i)
{
    size_t inner = ix__mv_stride(m, dir);

    return (r / inner * (size_t)m->dirs[dir].length + i) * inner + r % inner;
}

static size_t count_rows(const ix_mv *m, int dir)
{
    return m->npts / (size_t)m->dirs[dir].length;
}

/* Mean length of the control polygons along dir. */
static double polygon_length(const ix_mv *m, int dir)
{
    size_t rows = count_rows(m, dir), n = (size_t)m->dirs[dir].length;
    double sum = 0;

    for (size_t r = 0; r < rows; r++)
        for (size_t i = 1; i < n; i++)
            sum += distance(m, point_at(m, dir, r, i - 1), m,
                            point_at(m, dir, r, i));
    return sum / (double)rows;
}

/* Mean distance of a's last layer and b's first. */
static double gap_length(const ix_mv *a, const ix_mv *b, int dir)
{
    size_t rows = count_rows(a, dir), last = (size_t)a->dirs[dir].length - 1;
    double sum = 0;

    for (size_t r = 0; r < rows; r++)
        sum += distance(a, point_at(a, dir, r, last), b,
                        point_at(b, dir, r, 0));
    return sum / (double)rows;
}

/* Knot span of a straight piece: as long for its length as the domain is for
 * the polygon's; lengths below 1e-2 count as 1e-2 (spec/model 2). A length
 * that is not finite (weight 0) gives the span of the mean. */
static double segment_span(double domain, double length, double gap)
{
    double s = domain * fmax(gap, 1e-2) / fmax(length, 1e-2);

    return isfinite(s) && s > 0 ? s : domain;
}

/* --- merge --------------------------------------------------------------- */

typedef struct {
    const ix_mv *a, *b; /* open B-splines, compatible but for dir's knots */
    int dir;
    ix_join how;
    double span;  /* of the bridge */
    double scale; /* of b's homogeneous points, so that the layers agree */
} joint;

/* Points between a's and b's, negative if one layer is shared. */
static int points_between(const joint *j)
{
    int order = j->a->dirs[j->dir].order;

    if (j->how == IX_JOIN_SHARED && order > 1)
        return -1;
    return j->how == IX_JOIN_BRIDGE && order > 1 ? order - 2 : 0;
}

static ix_status join_knots(ix_ctx *ctx, const joint *j, ix_dir *out)
{
    const ix_dir *da = j->a->dirs + j->dir, *db = j->b->dirs + j->dir;
    bool bridge = j->how == IX_JOIN_BRIDGE && da->order > 1;
    int o = da->order, n = 0, shared = points_between(j) != 0 || bridge;
    double end = da->knots[da->length], start = db->knots[0], *kv;
    double from = bridge ? end + j->span : end;

    *out = *da;
    if (__builtin_add_overflow(da->length + points_between(j), db->length,
                               &out->length))
        return IX_FAIL(ctx, IX_ENOMEM, "%d and %d points", da->length,
                       db->length);
    IX_SCRATCH(ctx, kv, (size_t)out->length + (size_t)o);
    for (int i = 0; i < da->length + o - shared; i++)
        kv[n++] = da->knots[i];
    for (int i = 0; bridge && i < o - 1; i++)
        kv[n++] = from;
    for (int i = o; i < db->length + o; i++)
        kv[n++] = from + (db->knots[i] - start);
    out->knots = kv;
    IX_TRY(ix__mv_check_dirs(ctx, 1, out, 1));
    return IX_OK;
}

/* One run of layers: a's, the bridge, b's (its first left out if shared). */
static void join_row(const joint *j, const double *a, const double *b,
                     size_t inner, double *out)
{
    size_t na = (size_t)j->a->dirs[j->dir].length;
    size_t nb = (size_t)j->b->dirs[j->dir].length;
    int between = points_between(j);
    const double *last = a + (na - 1) * inner;

    memcpy(out, a, na * inner * sizeof *out);
    out += na * inner;
    for (int k = 1; k <= between; k++)
        for (size_t l = 0; l < inner; l++)
            *out++ = last[l] +
                     (j->scale * b[l] - last[l]) * k / (double)(between + 1);
    for (size_t i = between < 0 ? inner : 0; i < nb * inner; i++)
        *out++ = j->scale * b[i];
}

static ix_status join(ix_ctx *ctx, const joint *j, ix_mv **out)
{
    ix__mv_extent s = ix__mv_shape(j->a, j->dir);
    size_t na, nb, no;
    ix_dir nd;

    IX_TRY(join_knots(ctx, j, &nd));
    IX_TRY(ix__mv_alloc_like(ctx, j->a, j->dir, &nd, out));
    ix__mv_join_knots(&nd, ix__mv_knots(*out, j->dir));
    na = (size_t)j->a->dirs[j->dir].length * s.inner;
    nb = (size_t)j->b->dirs[j->dir].length * s.inner;
    no = (size_t)nd.length * s.inner;
    for (size_t o = 0; o < s.outer; o++)
        join_row(j, j->a->pts + o * na, j->b->pts + o * nb, s.inner,
                 (*out)->pts + o * no);
    return IX_OK;
}

/* Factor that gives b's first point the weight of a's last. */
static double weight_ratio(const ix_mv *a, const ix_mv *b, int dir)
{
    double wa, wb;

    if (!a->rational)
        return 1;
    wa = a->pts[point_at(a, dir, 0, (size_t)a->dirs[dir].length - 1)];
    wb = b->pts[0];
    return wa != wb && wa != 0 && wb != 0 ? wa / wb : 1;
}

static ix_status join_scoped(ix_ctx *ctx, const joint *j, ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, join(ctx, j, out));
}

/* a and b are open B-splines of one kind. */
static ix_status merge_open(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                            int dir, ix_join how, ix_mv **out)
{
    joint j = {a, b, dir, how, 0, 1};
    double da[2], db[2];

    ix_mv_domain(a, dir, da);
    ix_mv_domain(b, dir, db);
    if (how == IX_JOIN_BRIDGE)
        j.span = segment_span(da[1] - da[0] + db[1] - db[0],
                              polygon_length(a, dir) + polygon_length(b, dir),
                              gap_length(a, b, dir));
    if (how == IX_JOIN_SHARED)
        j.scale = weight_ratio(a, b, dir);
    return join_scoped(ctx, &j, out);
}

/* Open B-spline in dir; consumes *m if it fails. */
static ix_status open_dir(ix_ctx *ctx, ix_mv **m, int dir)
{
    ix_mv *next;

    IX_TRY(ix__mv_step(ctx, m, &next, ix_mv_to_bspline(ctx, *m, &next)));
    return ix__mv_step(ctx, m, &next, ix__mv_open_dir(ctx, *m, dir, &next));
}

ix_status ix_mv_merge(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int dir,
                      ix_join how, ix_mv **out)
{
    unsigned flags[IX_MAX_DIRS];
    ix_mv *ca, *cb;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, a, dir));
    for (int d = 0; d < IX_MAX_DIRS; d++)
        flags[d] = d == dir ? IX_SAME_POINTS | IX_SAME_ORDERS : IX_SAME_ALL;
    IX_TRY(ix__mv_compatible_dirs(ctx, a, b, flags, &ca, &cb));
    st = open_dir(ctx, &ca, dir);
    if (st == IX_OK)
        st = open_dir(ctx, &cb, dir);
    if (st == IX_OK)
        st = merge_open(ctx, ca, cb, dir, how, out);
    ix_mv_unref(ctx, ca);
    ix_mv_unref(ctx, cb);
    return st;
}

/* --- a curve and a point -------------------------------------------------- */

/* order - 1 new points on the segment from the end point to p. */
static void add_points(const ix_mv *m, const double *p, bool before, ix_mv *out)
{
    size_t n = m->npts, k = out->npts - n;

    for (size_t a = 0; a < (size_t)m->naxes; a++) {
        const double *from = m->pts + a * n;
        double *to = out->pts + a * out->npts, end = from[before ? 0 : n - 1];

        memcpy(to + (before ? k : 0), from, n * sizeof *to);
        for (size_t i = 1; i <= k; i++)
            to[before ? k - i : n + i - 1] = i == k ? p[a]
                                                    : end + (p[a] - end) *
                                                                (double)i /
                                                                (double)k;
    }
}

/* Knots of m with a span of order - 1 new ones at one end. */
static ix_status add_knots(ix_ctx *ctx, const ix_mv *m, double span,
                           bool before, ix_dir *out)
{
    const ix_dir *d = m->dirs;
    int o = d->order, nk = d->length + o;
    double *kv, at;

    *out = *d;
    out->length += o - 1;
    IX_SCRATCH(ctx, kv, nk + o - 1);
    at = before ? d->knots[0] - span : d->knots[nk - 1] + span;
    if (before) { /* order times the new end, the old one once less */
        memcpy(kv + o, d->knots + 1, (size_t)(nk - 1) * sizeof *kv);
        for (int i = 0; i < o; i++)
            kv[i] = at;
    } else {
        memcpy(kv, d->knots, (size_t)(nk - 1) * sizeof *kv);
        for (int i = 0; i < o; i++)
            kv[nk - 1 + i] = at;
    }
    out->knots = kv;
    return ix__mv_check_dirs(ctx, 1, out, 1);
}

static double span_to(const ix_mv *m, const double *p, bool before)
{
    size_t i = before ? 0 : m->npts - 1;
    double dom[2], sum = 0;

    for (int c = 0; c < m->ncoords; c++) {
        double x = m->rational ? p[c + 1] / p[0] : p[c];

        x -= coordinate(m, c, i);
        sum += x * x;
    }
    ix_mv_domain(m, 0, dom);
    return segment_span(dom[1] - dom[0], polygon_length(m, 0), sqrt(sum));
}

static ix_status add_point(ix_ctx *ctx, const ix_mv *m, const double *p,
                           bool before, ix_mv **out)
{
    ix_dir nd;

    IX_TRY(add_knots(ctx, m, span_to(m, p, before), before, &nd));
    IX_TRY(ix__mv_alloc_like(ctx, m, 0, &nd, out));
    add_points(m, p, before, *out);
    return IX_OK;
}

static ix_status add_point_scoped(ix_ctx *ctx, const ix_mv *m, const double *p,
                                  bool before, ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, add_point(ctx, m, p, before, out));
}

ix_status ix_mv_add_point(ix_ctx *ctx, const ix_mv *m, const double *p,
                          bool before, ix_mv **out)
{
    ix_mv *cur, *next;

    *out = NULL;
    if (m->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "%d directions: not a curve", m->ndirs);
    for (int a = 0; a < m->naxes; a++)
        if (!isfinite(p[a]))
            return IX_FAIL(ctx, IX_EARG, "coordinate %d is %g", a, p[a]);
    cur = ix_mv_ref(m);
    IX_TRY(open_dir(ctx, &cur, 0));
    if (cur->dirs[0].order == 1) /* a segment is linear */
        IX_TRY(
            ix__mv_step(ctx, &cur, &next, ix_mv_raise(ctx, cur, 0, 2, &next)));
    IX_TRY(ix__mv_step(ctx, &cur, &next,
                       add_point_scoped(ctx, cur, p, before, &next)));
    *out = cur;
    return IX_OK;
}
