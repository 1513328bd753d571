/* itd_write_mv.c - curves, surfaces, trivariates, multivariates and triangular
 * surfaces as text: a header line, knot vectors, one control point a line. */
#include "io/itd_write_impl.h"

enum { POINTS_A_CHECK = 1024 };

static void write_point_type(ix__itdw *w, int ncoords, bool rational)
{
    ix__buf_printf(w->b, " %c%d\n", rational ? 'P' : 'E', ncoords);
}

/* Five knots a line. */
static void write_knots(ix__itdw *w, bool periodic, int n, const double *knots,
                        int column)
{
    ix__itdw_indent(w, column + 4);
    ix__buf_puts(w->b, periodic ? "[KVP" : "[KV");
    for (int i = 0; i < n; i++) {
        if (i > 0 && i % 5 == 0) {
            ix__buf_putc(w->b, '\n');
            ix__itdw_indent(w, column + 8);
        }
        ix__buf_putc(w->b, ' ');
        ix__itdw_num(w, knots[i]);
    }
    ix__buf_puts(w->b, "]\n");
}

/* One point of double[naxes][stride]. */
static void write_point(ix__itdw *w, int naxes, size_t stride, const double *p,
                        int column)
{
    ix__itdw_indent(w, column);
    ix__buf_putc(w->b, '[');
    for (int a = 0; a < naxes; a++) {
        if (a > 0)
            ix__buf_putc(w->b, ' ');
        ix__itdw_num(w, p[(size_t)a * stride]);
    }
    ix__buf_puts(w->b, "]\n");
}

static const char *basis_word(const ix_mv *m)
{
    static const char *const words[] = {"BEZIER", "BSPLINE", "POWER"};

    return words[ix_mv_dir(m, 0).basis];
}

static bool is_multivar(ix_obj_type type)
{
    return type == IX_OBJ_MULTIVAR;
}

static void write_header(ix__itdw *w, ix_obj_type type, const ix_mv *m)
{
    const char *gap = is_multivar(type) ? "  " : "";
    int nd = ix_mv_ndirs(m);

    ix__buf_puts(w->b, type == IX_OBJ_CURVE     ? "[CURVE "
                       : type == IX_OBJ_SURFACE ? "[SURFACE "
                       : type == IX_OBJ_TRIVAR  ? "[TRIVAR "
                                                : "[MULTIVAR ");
    ix__buf_puts(w->b, basis_word(m));
    if (is_multivar(type))
        ix__buf_printf(w->b, " %d", nd);
    ix__buf_puts(w->b, gap);
    for (int d = 0; d < nd; d++)
        ix__buf_printf(w->b, " %d", ix_mv_length(m, d));
    if (ix_mv_dir(m, 0).basis == IX_BSPLINE) {
        ix__buf_puts(w->b, gap);
        for (int d = 0; d < nd; d++)
            ix__buf_printf(w->b, " %d", ix_mv_order(m, d));
    }
    write_point_type(w, ix_mv_ncoords(m), ix_mv_rational(m));
}

/* Empty lines between rows, one more between planes of a trivariate. */
static void write_gap(ix__itdw *w, ix_obj_type type, const ix_mv *m, size_t i)
{
    size_t row = (size_t)ix_mv_length(m, 0);

    if (i == 0 || (type != IX_OBJ_SURFACE && type != IX_OBJ_TRIVAR))
        return;
    if (i % row == 0)
        ix__buf_putc(w->b, '\n');
    if (type == IX_OBJ_TRIVAR && i % (row * (size_t)ix_mv_length(m, 1)) == 0)
        ix__buf_putc(w->b, '\n');
}

static ix_status write_mv(ix__itdw *w, ix_obj_type type, const ix_mv *m,
                          int column)
{
    size_t n = ix_mv_npts(m);
    const double *pts = ix_mv_axis(m, 0);

    ix__itdw_indent(w, column);
    write_header(w, type, m);
    for (int d = 0; d < ix_mv_ndirs(m); d++) {
        ix_dir dir = ix_mv_dir(m, d);

        if (dir.basis == IX_BSPLINE)
            write_knots(w, dir.periodic, ix_knots_count(&dir), dir.knots,
                        column);
    }
    for (size_t i = 0; i < n; i++) {
        write_gap(w, type, m, i);
        write_point(w, ix_mv_naxes(m), n, pts + i, column + 4);
        if (i % POINTS_A_CHECK == 0)
            IX_TRY(ix__itdw_check(w));
    }
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "]\n");
    return ix__itdw_check(w);
}

static bool same_basis(const ix_mv *m)
{
    for (int d = 1; d < ix_mv_ndirs(m); d++)
        if (ix_mv_dir(m, d).basis != ix_mv_dir(m, 0).basis)
            return false;
    return true;
}

/* The format has one basis for all directions: others become B-splines. */
ix_status ix__itdw_mv(ix__itdw *w, ix_obj_type type, const ix_mv *m, int column)
{
    ix_mv *spline;
    ix_status st;

    if (same_basis(m))
        return write_mv(w, type, m, column);
    IX_TRY(ix_mv_to_bspline(w->b->ctx, m, &spline));
    st = write_mv(w, type, spline, column);
    ix_mv_unref(w->b->ctx, spline);
    return st;
}

/* --- triangular surfaces ---------------------------------------------- */

/* The number of the twist at mesh point i, or -1 (spec/itd-format 6.4). */
static int gregory_twist(const ix_trisrf *t, int i)
{
    int n = t->length;
    const int at[3] = {n + 1, 2 * n - 3, n * (n + 1) / 2 - 5};

    for (int k = 0; t->kind == IX_TRI_GREGORY && k < 3; k++)
        if (i == at[k])
            return k;
    return -1;
}

static void write_tri_point(ix__itdw *w, const ix_trisrf *t, int i, int column)
{
    int naxes = t->ncoords + (t->rational ? 1 : 0);
    int mesh = t->length * (t->length + 1) / 2;
    int twist = gregory_twist(t, i);
    size_t stride = (size_t)t->npts;

    if (twist < 0) {
        write_point(w, naxes, stride, t->pts + i, column);
        return;
    }
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "[\n");
    write_point(w, naxes, stride, t->pts + i, column + 4);
    write_point(w, naxes, stride, t->pts + mesh + twist, column + 4);
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "]\n");
}

ix_status ix__itdw_trisrf(ix__itdw *w, const ix_trisrf *t, int column)
{
    static const char *const words[] = {"BEZIER", "BSPLINE", "GREGORY"};
    int mesh = t->length * (t->length + 1) / 2;

    ix__itdw_indent(w, column);
    ix__buf_printf(w->b, "[TRISRF %s %d", words[t->kind], t->length);
    if (t->kind == IX_TRI_BSPLINE)
        ix__buf_printf(w->b, " %d", t->order);
    write_point_type(w, t->ncoords, t->rational);
    if (t->kind == IX_TRI_BSPLINE)
        write_knots(w, false, t->nknots, t->knots, column);
    for (int i = 0; i < mesh; i++) {
        write_tri_point(w, t, i, column + 4);
        if (i % POINTS_A_CHECK == 0)
            IX_TRY(ix__itdw_check(w));
    }
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "]\n");
    return ix__itdw_check(w);
}
