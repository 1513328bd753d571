/* xml_read_mv.c - curves, surfaces, trivariates, multivariates and triangular
 * surfaces from XML. No count is believed that the text could not hold. */
#include <stdint.h>

#include "io/read_rules.h"
#include "io/xml_read_impl.h"

/* --- knots and points ------------------------------------------------- */

/* Rows of points, gathered from one element after the other. */
typedef struct {
    int naxes;
    size_t n, got; /* points */
    double *pts;   /* double[naxes][n] */
} rows;

static ix_status read_rows(ix__xmlr *r, rows *p)
{
    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(ix__xmlr_text(r));
    for (; !ix__xmlr_at_end(r); p->got++) {
        if (p->got == p->n)
            return ix__xmlr_bad_text(r, "all control points are given already");
        for (int a = 0; a < p->naxes; a++)
            IX_TRY(ix__xmlr_num(r, &p->pts[(size_t)a * p->n + p->got]));
    }
    return ix__poll(r->ctx);
}

static ix_status check_rows(ix__xmlr *r, size_t at, const rows *p)
{
    if (p->got == p->n)
        return IX_OK;
    return ix__xml_fail(r->x, at, "%zu control points expected, %zu found",
                        p->n, p->got);
}

/* Up to n knots of the element, behind those *got so far. */
static ix_status read_knots(ix__xmlr *r, int n, int *got, double *knots)
{
    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(ix__xmlr_text(r));
    for (; !ix__xmlr_at_end(r); ++*got) {
        if (*got == n)
            return ix__xmlr_bad_text(r, "all knots are given already");
        IX_TRY(ix__xmlr_num(r, knots + *got));
    }
    return IX_OK;
}

static ix_status check_knots(ix__xmlr *r, size_t at, const ix_dir *dir, int got)
{
    int n = ix_knots_count(dir);

    if (got == n)
        return IX_OK;
    return ix__xml_fail(
        r->x, at, "%d knots found, %d needed for %d%s points of order %d", got,
        n, dir->length, dir->periodic ? " periodic" : "", dir->order);
}

/* --- multivariates ---------------------------------------------------- */

typedef struct {
    size_t at;
    int ndirs, ncoords;
    bool rational;
    ix_dir dirs[IX_MAX_DIRS];
    rows points;
} header;

static ix_status read_spline(ix__xmlr *r, size_t at, ix_dir *dir)
{
    double *knots;
    bool more;
    int got = 0, n = ix_knots_count(dir);

    if (!dir->periodic && dir->order > dir->length)
        return ix__xml_fail(r->x, at, "order %d needs %d points, there are %d",
                            dir->order, dir->order, dir->length);
    IX_TRY(ix__xmlr_room(r, at, n, "knots"));
    IX_SCRATCH(r->ctx, knots, n);
    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            break;
        if (!ix__xmlr_is(r, "knots"))
            return ix__xmlr_unexpected(r, "knots");
        IX_TRY(read_knots(r, n, &got, knots));
    }
    dir->knots = knots;
    return check_knots(r, at, dir, got);
}

static ix_status read_direction(ix__xmlr *r, header *h)
{
    static const char *const bases[] = {"bezier", "bspline", "power"};
    const int most = INT32_MAX - 2 * IX_MAX_ORDER;
    size_t at = r->e.at;
    ix_dir *dir = &h->dirs[h->ndirs];
    int basis;

    if (h->ndirs == IX_MAX_DIRS)
        return ix__xml_fail(r->x, at, "more than %d directions", IX_MAX_DIRS);
    if (h->points.pts)
        return ix__xml_fail(r->x, at, "a direction behind the points");
    IX_TRY(ix__xmlr_allow(r, " basis order length periodic "));
    IX_TRY(ix__xmlr_word(r, "basis", 3, bases, &basis));
    *dir = (ix_dir){.basis = (ix_basis)basis};
    IX_TRY(ix__xmlr_int(r, "order", 1, IX_MAX_ORDER, &dir->order));
    dir->length = dir->order;
    if (basis == IX_BSPLINE || ix__xmlr_attr(r, "length"))
        IX_TRY(ix__xmlr_int(r, "length", 1, most, &dir->length));
    IX_TRY(ix__xmlr_bool(r, "periodic", &dir->periodic));
    if (basis != IX_BSPLINE && (dir->periodic || dir->length != dir->order))
        return ix__xml_fail(r->x, at,
                            "a %s direction has its order as length and is not "
                            "periodic",
                            bases[basis]);
    if (basis == IX_BSPLINE)
        IX_TRY(read_spline(r, at, dir));
    else
        IX_TRY(ix__xmlr_empty(r));
    h->ndirs++;
    return ix__xmlr_at(r, at, ix__mv_check_dirs(r->ctx, h->ndirs, h->dirs, 1));
}

/* All directions are known: memory for the points. */
static ix_status begin_points(ix__xmlr *r, int ndirs, header *h)
{
    double n = 1;

    if (h->ndirs == 0 || (ndirs > 0 && h->ndirs != ndirs))
        return ix__xml_fail(r->x, h->at, "%d directions found, %d needed",
                            h->ndirs, ndirs > 0 ? ndirs : 1);
    h->points.naxes = h->ncoords + (h->rational ? 1 : 0);
    for (int d = 0; d < h->ndirs; d++)
        n *= h->dirs[d].length;
    IX_TRY(ix__xmlr_room(r, h->at, n * h->points.naxes, "numbers"));
    h->points.n = (size_t)n;
    IX_SCRATCH(r->ctx, h->points.pts, h->points.n * (size_t)h->points.naxes);
    return IX_OK;
}

static ix_status read_mv(ix__xmlr *r, int ndirs, ix_mv **out)
{
    header h = {.at = r->e.at};
    double range[2];
    bool more;

    IX_TRY(ix__xmlr_allow(r, " type use "));
    IX_TRY(ix__xmlr_point_type(r, &h.ncoords, &h.rational));
    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            break;
        if (ix__xmlr_is(r, "direction")) {
            IX_TRY(read_direction(r, &h));
            continue;
        }
        if (!ix__xmlr_is(r, "points"))
            return ix__xmlr_unexpected(r, "direction or points");
        if (!h.points.pts)
            IX_TRY(begin_points(r, ndirs, &h));
        IX_TRY(read_rows(r, &h.points));
    }
    if (!h.points.pts)
        return ix__xml_fail(r->x, h.at, "no control points");
    IX_TRY(check_rows(r, h.at, &h.points));
    IX_TRY(ix__xmlr_at(r, h.at,
                       ix_mv_new(r->ctx, h.ndirs, h.dirs, h.ncoords, h.rational,
                                 h.points.pts, out)));
    if (ix__signs_change(*out, range))
        ix__xml_warn(r->x, h.at, "weights change sign (%g .. %g)", range[0],
                     range[1]);
    return IX_OK;
}

ix_status ix__xmlr_mv(ix__xmlr *r, int ndirs, const ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(r->ctx);
    ix_mv *m = NULL;
    ix_status st = read_mv(r, ndirs, &m);

    ix__scratch_release(r->ctx, mk);
    *out = m;
    return st;
}

/* --- triangular surfaces ---------------------------------------------- */

static ix_status read_tri_body(ix__xmlr *r, size_t at, ix_trisrf *t)
{
    ix_dir dir = {IX_BSPLINE, t->order, t->length, false, t->knots};
    rows p = {t->ncoords + (t->rational ? 1 : 0), (size_t)t->npts, 0, t->pts};
    int got = 0;
    bool more;

    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            break;
        if (ix__xmlr_is(r, "knots"))
            IX_TRY(read_knots(r, t->nknots, &got, t->knots));
        else if (ix__xmlr_is(r, "points"))
            IX_TRY(read_rows(r, &p));
        else
            return ix__xmlr_unexpected(r, "knots or points");
    }
    IX_TRY(check_rows(r, at, &p));
    if (t->kind != IX_TRI_BSPLINE)
        return IX_OK;
    IX_TRY(check_knots(r, at, &dir, got));
    return ix__xmlr_at(r, at, ix__mv_check_dirs(r->ctx, 1, &dir, 1));
}

static ix_status read_tri_header(ix__xmlr *r, ix_trisrf *h)
{
    static const char *const bases[] = {"bezier", "bspline", "gregory"};
    int kind;

    IX_TRY(ix__xmlr_allow(r, " type basis length order "));
    IX_TRY(ix__xmlr_point_type(r, &h->ncoords, &h->rational));
    IX_TRY(ix__xmlr_word(r, "basis", 3, bases, &kind));
    h->kind = (ix_tri_kind)kind;
    /* Below 5 the twists of a Gregory patch would not be three points. */
    IX_TRY(ix__xmlr_int(r, "length", kind == IX_TRI_GREGORY ? 5 : 1, 32767,
                        &h->length));
    h->order = h->length;
    if (kind == IX_TRI_BSPLINE)
        IX_TRY(ix__xmlr_int(r, "order", 1,
                            h->length < IX_MAX_ORDER ? h->length : IX_MAX_ORDER,
                            &h->order));
    return ix__xmlr_room(r, r->e.at,
                         h->length * (h->length + 1.0) / 2 *
                             (h->ncoords + h->rational),
                         "numbers");
}

ix_status ix__xmlr_trisrf(ix__xmlr *r, const void **out)
{
    size_t at = r->e.at;
    ix_trisrf h = {0}, *t;
    ix_status st;

    *out = NULL;
    IX_TRY(read_tri_header(r, &h));
    t = ix__trisrf_new(r->ctx, h.kind, h.length, h.order, h.ncoords,
                       h.rational);
    if (!t)
        return IX_ENOMEM;
    st = read_tri_body(r, at, t);
    if (st == IX_OK)
        *out = t;
    else
        ix__trisrf_unref(r->ctx, t);
    return st;
}
