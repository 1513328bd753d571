/* itd_read_mv.c - curves, surfaces, trivariates, multivariates from text. No
 * count is believed before the bytes left could hold it. */
#include <math.h>
#include <string.h>

#include "io/itd_read_impl.h"
#include "io/read_rules.h"

/* A point and the blanks in it rarely exceed POINT_ROOM bytes. */
enum { POINTS_A_POLL = 4096, POINT_ROOM = 1024 };

/* --- point types and points ------------------------------------------- */

static bool parse_point_type(const ix__token *t, int *ncoords, bool *rational)
{
    size_t n = (size_t)(t->end - t->s);
    int v = 0;

    if (t->kind != IX_T_WORD || n < 2 || n > 3 || t->s[1] == '0' ||
        !strchr("EePp", t->s[0]))
        return false;
    for (size_t i = 1; i < n; i++) {
        if (t->s[i] < '0' || t->s[i] > '9')
            return false;
        v = 10 * v + (t->s[i] - '0');
    }
    *ncoords = v;
    *rational = t->s[0] == 'P' || t->s[0] == 'p';
    return v <= IX_MAX_COORDS;
}

ix_status ix__itdr_point_type(ix__lex *l, int *ncoords, bool *rational)
{
    ix__token t;

    IX_TRY(ix__lex_next(l, &t));
    if (parse_point_type(&t, ncoords, rational))
        return IX_OK;
    return ix__lex_unexpected(l, &t, "point type E1 .. E18 or P1 .. P18");
}

static const char *skip_blanks(const char *p, const char *end)
{
    while (p < end && ix__lex_blank(*p))
        p++;
    return p;
}

/* The plain case at full speed: NULL if anything is out of order. */
static const char *plain_point(const char *p, const char *end, int naxes,
                               size_t stride, double *pt)
{
    p = skip_blanks(p, end);
    if (p == end || *p++ != '[')
        return NULL;
    for (int a = 0; a < naxes; a++) {
        double *v = pt + (size_t)a * stride;

        p = ix_num_parse(skip_blanks(p, end), end, v);
        if (!p || p == end || !(ix__lex_blank(*p) || *p == ']') ||
            !isfinite(*v))
            return NULL;
    }
    p = skip_blanks(p, end);
    return p < end && *p == ']' ? p + 1 : NULL;
}

/* A point that the window cut, or what is wrong with it. */
static ix_status careful_point(ix__lex *l, int naxes, size_t stride, double *p,
                               size_t i, size_t n)
{
    ix__token open, t;

    IX_TRY(ix__lex_next(l, &open));
    if (open.kind == IX_T_CLOSE)
        return ix__lex_fail(l, open.at,
                            "%zu control points expected, %zu found", n, i);
    if (open.kind != IX_T_OPEN)
        return ix__lex_unexpected(l, &open, "[ of a control point");
    for (int a = 0; a < naxes; a++) {
        IX_TRY(ix__lex_peek(l, &t));
        if (t.kind == IX_T_CLOSE)
            return ix__lex_fail(l, open.at,
                                "control point %zu has %d numbers; its type "
                                "needs %d",
                                i + 1, a, naxes);
        IX_TRY(ix__lex_num(l, "number", p + (size_t)a * stride));
    }
    IX_TRY(ix__lex_peek(l, &t));
    if (t.kind == IX_T_WORD)
        return ix__lex_fail(l, t.at,
                            "control point %zu has more than %d numbers", i + 1,
                            naxes);
    return ix__lex_close(l, "] of a control point");
}

ix_status ix__itdr_point(ix__lex *l, int naxes, size_t stride, double *p,
                         size_t i, size_t n)
{
    const char *next;

    IX_TRY(ix__text_ahead(&l->t, POINT_ROOM));
    next = plain_point(l->t.p, l->t.end, naxes, stride, p);
    if (!next)
        return careful_point(l, naxes, stride, p, i, n);
    l->t.p = next;
    return IX_OK;
}

ix_status ix__itdr_points(ix__lex *l, int naxes, size_t n, double *pts)
{
    for (size_t i = 0; i < n; i++) {
        if (i % POINTS_A_POLL == 0)
            IX_TRY(ix__poll(l->ctx));
        IX_TRY(ix__itdr_point(l, naxes, n, pts + i, i, n));
    }
    return IX_OK;
}

/* --- knots ------------------------------------------------------------ */

static ix_status read_knots(ix__lex *l, const ix_dir *dir, int n, double *knots)
{
    ix__token t;

    for (int i = 0; i < n; i++) {
        if (i % POINTS_A_POLL == 0)
            IX_TRY(ix__poll(l->ctx));
        IX_TRY(ix__lex_peek(l, &t));
        if (t.kind == IX_T_CLOSE)
            return ix__lex_fail(l, t.at,
                                "%d knots found, %d needed for %d%s points of "
                                "order %d",
                                i, n, dir->length,
                                dir->periodic ? " periodic" : "", dir->order);
        IX_TRY(ix__lex_num(l, "knot", knots + i));
    }
    IX_TRY(ix__lex_peek(l, &t));
    if (t.kind == IX_T_WORD)
        return ix__lex_fail(l, t.at,
                            "more than the %d knots of %d%s points of order "
                            "%d",
                            n, dir->length, dir->periodic ? " periodic" : "",
                            dir->order);
    return ix__lex_close(l, "] of the knots");
}

/* What lower floors refuse as an argument is malformed text here. */
static ix_status at_place(ix__lex *l, size_t at, ix_status st)
{
    if (st != IX_EARG)
        return st;
    return ix__lex_fail(l, at, "%s", ix_ctx_message(l->ctx));
}

ix_status ix__itdr_knots(ix__lex *l, ix_dir *dirs, int d)
{
    ix_dir *dir = dirs + d;
    ix__token open, t;
    double *knots;
    int n;

    IX_TRY(ix__lex_peek(l, &open));
    IX_TRY(ix__lex_open(l));
    IX_TRY(ix__lex_next(l, &t));
    dir->periodic = ix__token_is(&t, "KVP");
    if (!dir->periodic && !ix__token_is(&t, "KV"))
        return ix__lex_unexpected(l, &t, "KV or KVP");
    if (!dir->periodic && dir->order > dir->length)
        return ix__lex_fail(l, open.at,
                            "order %d needs %d points, there are %d",
                            dir->order, dir->order, dir->length);
    n = ix_knots_count(dir);
    IX_TRY(ix__lex_room(l, open.at, n, 2, "knots"));
    IX_SCRATCH(l->ctx, knots, n);
    IX_TRY(read_knots(l, dir, n, knots));
    dir->knots = knots;
    return at_place(l, open.at, ix__mv_check_dirs(l->ctx, d + 1, dirs, 1));
}

/* --- the header ------------------------------------------------------- */

typedef struct {
    size_t at; /* of the type keyword, for messages */
    ix_basis basis;
    int ndirs;
    ix_dir dirs[IX_MAX_DIRS];
    int ncoords, naxes;
    bool rational;
    size_t npts;
} header;

static ix_status read_basis(ix__lex *l, header *h)
{
    ix__token t;

    IX_TRY(ix__lex_next(l, &t));
    h->at = t.at;
    if (ix__token_is(&t, "BEZIER"))
        h->basis = IX_BEZIER;
    else if (ix__token_is(&t, "BSPLINE"))
        h->basis = IX_BSPLINE;
    else if (ix__token_is(&t, "POWER"))
        h->basis = IX_POWER;
    else
        return ix__lex_unexpected(l, &t, "BEZIER, BSPLINE or POWER");
    return IX_OK;
}

static ix_status read_sizes(ix__lex *l, header *h)
{
    const int most = INT32_MAX - 2 * IX_MAX_ORDER;
    bool spline = h->basis == IX_BSPLINE;

    for (int d = 0; d < h->ndirs; d++) {
        h->dirs[d].basis = h->basis;
        IX_TRY(ix__lex_int(
            l, spline ? "the number of control points" : "the order", 1,
            spline ? most : IX_MAX_ORDER, &h->dirs[d].length));
        h->dirs[d].order = h->dirs[d].length;
    }
    for (int d = 0; spline && d < h->ndirs; d++)
        IX_TRY(ix__lex_int(l, "the order", 1, IX_MAX_ORDER, &h->dirs[d].order));
    return IX_OK;
}

static ix_status read_header(ix__lex *l, ix_obj_type type, header *h)
{
    double n = 1;

    IX_TRY(read_basis(l, h));
    IX_TRY(ix__itdr_drop_attrs(l)); /* accepted and dropped, as in IRIT */
    h->ndirs = type == IX_OBJ_CURVE ? 1 : type == IX_OBJ_SURFACE ? 2 : 3;
    if (type == IX_OBJ_MULTIVAR)
        IX_TRY(ix__lex_int(l, "the number of directions", 1, IX_MAX_DIRS,
                           &h->ndirs));
    IX_TRY(read_sizes(l, h));
    IX_TRY(ix__itdr_point_type(l, &h->ncoords, &h->rational));
    h->naxes = h->ncoords + (h->rational ? 1 : 0);
    for (int d = 0; d < h->ndirs; d++)
        n *= h->dirs[d].length;
    /* "[1 2 3]": two characters a number and one. */
    IX_TRY(ix__lex_room(l, h->at, n, 2 * h->naxes + 1, "control points"));
    h->npts = (size_t)n;
    for (int d = 0; h->basis == IX_BSPLINE && d < h->ndirs; d++)
        IX_TRY(ix__itdr_knots(l, h->dirs, d));
    return IX_OK;
}

static ix_status read_mv(ix__lex *l, ix_obj_type type, ix_mv **out)
{
    header h = {0};
    double *pts, range[2];

    IX_TRY(read_header(l, type, &h));
    IX_SCRATCH(l->ctx, pts, h.npts * (size_t)h.naxes);
    IX_TRY(ix__itdr_points(l, h.naxes, h.npts, pts));
    IX_TRY(ix__lex_close(l, "] behind the last control point"));
    IX_TRY(at_place(
        l, h.at,
        ix_mv_new(l->ctx, h.ndirs, h.dirs, h.ncoords, h.rational, pts, out)));
    if (ix__signs_change(*out, range))
        ix__lex_warn(l, h.at, "weights change sign (%g .. %g)", range[0],
                     range[1]);
    return IX_OK;
}

ix_status ix__itdr_mv(ix__lex *l, ix_obj_type type, const void **out)
{
    ix_mark mk = ix__scratch_mark(l->ctx);
    ix_mv *m = NULL;
    ix_status st = read_mv(l, type, &m);

    ix__scratch_release(l->ctx, mk);
    *out = m;
    return st;
}

ix_status ix__itdr_whole_mv(ix__lex *l, ix_obj_type type, const ix_mv **out)
{
    const char *word = type == IX_OBJ_CURVE ? "CURVE" : "SURFACE";
    const void *m;
    ix__token t;

    IX_TRY(ix__lex_open(l));
    IX_TRY(ix__lex_next(l, &t));
    if (!ix__token_is(&t, word))
        return ix__lex_unexpected(l, &t, word);
    IX_TRY(ix__itdr_mv(l, type, &m));
    *out = m;
    return IX_OK;
}
