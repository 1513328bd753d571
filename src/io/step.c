/* step.c - STEP files (ISO 10303-21, schema AP214): curves and surfaces as
 * exact B-splines in one geometric set, in millimetres. Weights and points
 * apart, u the outer index; what STEP cannot say (poles, jumps) is cut away
 * before. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "io/export.h"
#include "io/shapes.h"
#include "io/step_impl.h"

/* Readers built on Open CASCADE drop curves of higher degree silently. */
enum { USUAL_DEGREE = 25 };

/* At poles, halvings of each direction; the weight is kept above 2^-POLE_DEPTH
 * of its largest value, as by the tessellator. */
enum { POLE_DEPTH = 6 };

/* Entities that every file begins with. */
enum { PRODUCT_SHAPE = 8, CONTEXT = 13, FIRST_FREE = 15 };

/* --- words --------------------------------------------------------------- */

/* A real has a point, and its exponent a capital E. */
static void put_real(ix_buf *b, double v)
{
    char s[IX_NUM_MAX];
    int n = ix_num_format(v == 0 ? 0 : v, s); /* no -0 */
    int k = (int)strcspn(s, "e");

    ix__buf_add(b, s, (size_t)k);
    if (!memchr(s, '.', (size_t)k))
        ix__buf_putc(b, '.');
    if (k < n) {
        ix__buf_putc(b, 'E');
        ix__buf_add(b, s + k + 1, (size_t)(n - k - 1));
    }
}

/* Quotes are doubled; what is not ASCII becomes "_". */
static void put_string(ix_buf *b, const char *s)
{
    ix__buf_putc(b, '\'');
    for (; s && *s; s++) {
        if (*s == '\'' || *s == '\\')
            ix__buf_putc(b, *s);
        ix__buf_putc(b, isprint((unsigned char)*s) ? *s : '_');
    }
    ix__buf_putc(b, '\'');
}

long ix__step_entity(ix__step *s)
{
    ix__buf_printf(s->b, "#%ld=", s->next);
    return s->next++;
}

void ix__step_add(ix_buf *list, long id)
{
    ix__buf_printf(list, "%s#%ld", list->len > 0 ? "," : "", id);
}

/* "(a,b,...)" of n numbers by steps of stride, times f. */
static void put_reals(ix_buf *b, size_t n, size_t stride, const double *v,
                      double f)
{
    ix__buf_putc(b, '(');
    for (size_t i = 0; i < n; i++) {
        if (i > 0)
            ix__buf_putc(b, ',');
        put_real(b, f * v[i * stride]);
    }
    ix__buf_putc(b, ')');
}

/* "#1,#2,..." */
static void put_refs(ix_buf *b, size_t n, size_t stride, long first)
{
    for (size_t i = 0; i < n; i++)
        ix__buf_printf(b, "%s#%ld", i > 0 ? "," : "",
                       first + (long)(i * stride));
}

/* --- styles -------------------------------------------------------------- */

void ix__step_style(ix__step *s, long geometry, bool surface)
{
    long colour, style;

    if (!s->colored)
        return;
    colour = ix__step_entity(s);
    ix__buf_puts(s->b, "COLOUR_RGB('',");
    for (int c = 0; c < 3; c++) {
        put_real(s->b, s->rgb[c]);
        ix__buf_puts(s->b, c < 2 ? "," : ");\n");
    }
    if (surface) {
        style = ix__step_entity(s);
        ix__buf_printf(s->b, "FILL_AREA_STYLE_COLOUR('',#%ld);\n", colour);
        (void)ix__step_entity(s);
        ix__buf_printf(s->b, "FILL_AREA_STYLE('',(#%ld));\n", style);
        (void)ix__step_entity(s);
        ix__buf_printf(s->b, "SURFACE_STYLE_FILL_AREA(#%ld);\n", style + 1);
        (void)ix__step_entity(s);
        ix__buf_printf(s->b, "SURFACE_SIDE_STYLE('',(#%ld));\n", style + 2);
        style = ix__step_entity(s);
        ix__buf_printf(s->b, "SURFACE_STYLE_USAGE(.BOTH.,#%ld);\n", style - 1);
    } else {
        (void)ix__step_entity(s);
        ix__buf_puts(s->b,
                     "DRAUGHTING_PRE_DEFINED_CURVE_FONT('continuous');\n");
        style = ix__step_entity(s);
        ix__buf_printf(s->b,
                       "CURVE_STYLE('',#%ld,POSITIVE_LENGTH_MEASURE(0.1),"
                       "#%ld);\n",
                       style - 1, colour);
    }
    (void)ix__step_entity(s);
    ix__buf_printf(s->b, "PRESENTATION_STYLE_ASSIGNMENT((#%ld));\n", style);
    ix__step_add(&s->styles, ix__step_entity(s));
    ix__buf_printf(s->b, "STYLED_ITEM('color',(#%ld),#%ld);\n", style + 1,
                   geometry);
}

static void add_item(ix__step *s, long id, bool surface)
{
    ix__step_add(&s->items, id);
    s->surfaces = s->surfaces || surface;
    ix__step_style(s, id, surface);
}

/* --- splines ------------------------------------------------------------- */

void ix__step_point(ix__step *s, int n, const double *p)
{
    ix__buf_puts(s->b, "CARTESIAN_POINT('',");
    put_reals(s->b, (size_t)n, 1, p, 1);
    ix__buf_puts(s->b, ");\n");
}

/* Projected control points; returns the number of the first one. */
static long put_points(ix__step *s, const ix_mv *m, int dim)
{
    long first = s->next;

    for (size_t i = 0; i < ix_mv_npts(m); i++) {
        double p[3] = {0, 0, 0};

        for (int c = 0; c < 3 && c < ix_mv_ncoords(m); c++)
            p[c] = ix_mv_coord(m, c)[i] /
                   (ix_mv_rational(m) ? ix_mv_weights(m)[i] : 1);
        (void)ix__step_entity(s);
        ix__step_point(s, dim, p);
    }
    return first;
}

/* Multiplicities or distinct knots of a direction, in parentheses. */
static void put_knots(ix_buf *b, const ix_mv *m, int d, bool values)
{
    ix_dir dir = ix_mv_dir(m, d);
    int n = ix_knots_count(&dir);

    ix__buf_putc(b, '(');
    for (int i = 0, k; i < n; i = k) {
        for (k = i; k < n && dir.knots[k] == dir.knots[i];)
            k++;
        if (i > 0)
            ix__buf_putc(b, ',');
        if (values)
            put_real(b, dir.knots[i]);
        else
            ix__buf_int(b, k - i);
    }
    ix__buf_putc(b, ')');
}

static void put_all_knots(ix_buf *b, const ix_mv *m)
{
    for (int values = 0; values < 2; values++)
        for (int d = 0; d < ix_mv_ndirs(m); d++) {
            put_knots(b, m, d, values);
            ix__buf_putc(b, ',');
        }
    ix__buf_puts(b, ".UNSPECIFIED.)");
}

/* Degrees, control points (u outside, v inside) and flags. */
static void put_net(ix_buf *b, const ix_mv *m, long first)
{
    size_t n0 = (size_t)ix_mv_length(m, 0);

    for (int d = 0; d < ix_mv_ndirs(m); d++)
        ix__buf_printf(b, "%d,", ix_mv_order(m, d) - 1);
    if (ix_mv_ndirs(m) == 1) {
        ix__buf_putc(b, '(');
        put_refs(b, n0, 1, first);
        ix__buf_puts(b, "),.UNSPECIFIED.,.F.,.U.");
        return;
    }
    for (size_t i = 0; i < n0; i++) {
        ix__buf_puts(b, i == 0 ? "((" : ",(");
        put_refs(b, (size_t)ix_mv_length(m, 1), n0, first + (long)i);
        ix__buf_putc(b, ')');
    }
    ix__buf_puts(b, "),.UNSPECIFIED.,.F.,.F.,.U.");
}

/* Weights are given a positive sign. */
static void put_weights(ix_buf *b, const ix_mv *m)
{
    const double *w = ix_mv_weights(m);
    size_t n0 = (size_t)ix_mv_length(m, 0);
    double f = w[0] < 0 ? -1 : 1;

    if (ix_mv_ndirs(m) == 1) {
        put_reals(b, n0, 1, w, f);
        return;
    }
    for (size_t i = 0; i < n0; i++) {
        ix__buf_putc(b, i == 0 ? '(' : ',');
        put_reals(b, (size_t)ix_mv_length(m, 1), n0, w + i, f);
    }
    ix__buf_putc(b, ')');
}

/* An instance of several types lists them in alphabetical order. */
static void put_rational(ix__step *s, const ix_mv *m, long first)
{
    const char *kind = ix_mv_ndirs(m) == 1 ? "CURVE" : "SURFACE";

    ix__buf_printf(s->b, "(BOUNDED_%s()B_SPLINE_%s(", kind, kind);
    put_net(s->b, m, first);
    ix__buf_printf(s->b, ")B_SPLINE_%s_WITH_KNOTS(", kind);
    put_all_knots(s->b, m);
    if (ix_mv_ndirs(m) == 1)
        ix__buf_puts(s->b, "CURVE()");
    ix__buf_printf(s->b, "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_%s(",
                   kind);
    put_weights(s->b, m);
    ix__buf_puts(s->b, ")REPRESENTATION_ITEM(");
    put_string(s->b, s->name);
    ix__buf_printf(s->b, ")%s);\n", ix_mv_ndirs(m) == 1 ? "" : "SURFACE()");
}

static void put_polynomial(ix__step *s, const ix_mv *m, long first)
{
    ix__buf_printf(s->b, "B_SPLINE_%s_WITH_KNOTS(",
                   ix_mv_ndirs(m) == 1 ? "CURVE" : "SURFACE");
    put_string(s->b, s->name);
    ix__buf_putc(s->b, ',');
    put_net(s->b, m, first);
    ix__buf_putc(s->b, ',');
    put_all_knots(s->b, m);
    ix__buf_puts(s->b, ";\n");
}

long ix__step_spline(ix__step *s, const ix_mv *m, int dim)
{
    long first = put_points(s, m, dim), id = ix__step_entity(s);

    if (ix_mv_rational(m))
        put_rational(s, m, first);
    else
        put_polynomial(s, m, first);
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        if (ix_mv_order(m, d) - 1 > s->degree)
            s->degree = ix_mv_order(m, d) - 1;
    return id;
}

/* An open B-spline of degree 1 or more without jumps or poles. */
static ix_status put_spline(ix__step *s, const ix_mv *m)
{
    add_item(s, ix__step_spline(s, m, 3), ix_mv_ndirs(m) == 2);
    return ix__buf_check(s->b);
}

/* --- cutting ------------------------------------------------------------- */

typedef ix_status (*use_fn)(ix__step *s, const ix_mv *m, double least,
                            int depth);

/* Both parts at t go to use. */
static ix_status cut(ix__step *s, const ix_mv *m, int d, double t, use_fn use,
                     double least, int depth)
{
    ix_mv *part[2];
    ix_status st;

    IX_TRY(ix_mv_split(s->b->ctx, m, d, t, part));
    st = use(s, part[0], least, depth);
    if (st == IX_OK)
        st = use(s, part[1], least, depth);
    ix_mv_unref(s->b->ctx, part[0]);
    ix_mv_unref(s->b->ctx, part[1]);
    return st;
}

static bool weights_ok(const ix_mv *m, double least)
{
    const double *w = ix_mv_weights(m);

    if (ix_mv_has_poles(m))
        return false;
    for (size_t i = 0; w && i < ix_mv_npts(m); i++)
        if (!(fabs(w[i]) >= least))
            return false;
    return true;
}

/* Halves until the weights are good; recursion of bounded depth. */
static ix_status without_poles(ix__step *s, const ix_mv *m, double least,
                               int depth)
{
    int nd = ix_mv_ndirs(m), d = depth % nd;
    double dom[2];

    IX_TRY(ix__poll(s->b->ctx));
    if (weights_ok(m, least))
        return put_spline(s, m);
    if (depth == nd * POLE_DEPTH) {
        s->nleft++;
        return IX_OK;
    }
    ix_mv_domain(m, d, dom);
    return cut(s, m, d, (dom[0] + dom[1]) / 2, without_poles, least, depth + 1);
}

bool ix__step_jump(const ix_mv *m, int d, double *t)
{
    ix_dir dir = ix_mv_dir(m, d);
    int o = dir.order;

    for (int i = o; i + o <= dir.length; i++)
        if (dir.knots[i] == dir.knots[i + o - 1]) {
            *t = dir.knots[i];
            return true;
        }
    return false;
}

/* Cut at one jump after the other: first parts have none, so that a loop does
 * for a direction; at most two directions are nested. */
static ix_status without_jumps(ix__step *s, const ix_mv *m, double least,
                               int dirs)
{
    ix_mv *rest = ix_mv_ref(m), *part[2];
    ix_status st = IX_OK;
    int d = dirs - 1;
    double t;

    if (dirs == 0) {
        st = without_poles(s, m, least, 0);
        ix_mv_unref(s->b->ctx, rest);
        return st;
    }
    while (st == IX_OK && ix__step_jump(rest, d, &t)) {
        st = ix_mv_split(s->b->ctx, rest, d, t, part);
        if (st != IX_OK)
            break;
        st = without_jumps(s, part[0], least, d);
        ix_mv_unref(s->b->ctx, part[0]);
        ix_mv_unref(s->b->ctx, rest);
        rest = part[1];
    }
    if (st == IX_OK)
        st = without_jumps(s, rest, least, d);
    ix_mv_unref(s->b->ctx, rest);
    return st;
}

/* --- objects ------------------------------------------------------------- */

static double least_weight(const ix_mv *m)
{
    double most = 0;

    if (!ix_mv_has_poles(m))
        return 0;
    for (size_t i = 0; i < ix_mv_npts(m); i++)
        most = fmax(most, fabs(ix_mv_weights(m)[i]));
    return ldexp(most, -POLE_DEPTH);
}

ix_status ix__step_normalized(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *next;

    IX_TRY(ix_mv_to_bspline(ctx, m, out));
    IX_TRY(ix__mv_step(ctx, out, &next, ix_mv_to_open(ctx, *out, &next)));
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        if (ix_mv_order(*out, d) == 1)
            IX_TRY(ix__mv_step(ctx, out, &next,
                               ix_mv_raise(ctx, *out, d, 2, &next)));
    return IX_OK;
}

static void take_attributes(ix__step *s, const ix_obj *o)
{
    s->name = o->name ? o->name : "";
    s->colored = ix__shape_color(o, s->rgb);
}

static ix_status put_freeform(void *arg, const ix_obj *o, const ix_mv *m)
{
    ix__step *s = arg;
    ix_mv *open;
    ix_status st;

    take_attributes(s, o);
    IX_TRY(ix__step_normalized(s->b->ctx, m, &open));
    st = without_jumps(s, open, least_weight(open), ix_mv_ndirs(open));
    ix_mv_unref(s->b->ctx, open);
    return st;
}

/* What cannot be trimmed exactly is told and left out: so it is written apart
 * first. */
static ix_status put_faces(void *arg, const ix_obj *o, int n, const ix__face *f)
{
    ix__step *s = arg, before = *s;
    ix_ctx *ctx = s->b->ctx;
    ix_status st;
    ix_buf part;

    if (n == 1 && f->nloops == 0)
        return put_freeform(arg, o, f->srf);
    take_attributes(s, o);
    ix__buf_init(&part, ctx);
    s->b = &part;
    st = ix__step_shell(s, n, f);
    s->b = before.b;
    if (st == IX_OK)
        ix__buf_add(s->b, part.data, part.len);
    ix__buf_free(&part);
    if (st != IX_EUNABLE && st != IX_EDOMAIN)
        return st == IX_OK ? ix__buf_check(s->b) : st;
    s->next = before.next;
    s->plane = before.plane;
    s->degree = before.degree;
    ix__note(ctx, "warning: %.60s is not in the STEP file: %s",
             o->name ? o->name : "an object", ix_ctx_message(ctx));
    return IX_OK;
}

static ix_status put_point(void *arg, const ix_obj *o, const double p[3])
{
    ix__step *s = arg;
    long id = ix__step_entity(s);

    take_attributes(s, o);
    ix__step_point(s, 3, p);
    ix__step_add(&s->items, id);
    return ix__buf_check(s->b);
}

/* Polygons are closed polylines; point lists are points. */
static void put_polygon(ix__step *s, const ix_polygon *pg)
{
    bool closed = pg->kind == IX_POLYGON && pg->n > 2;
    long first = s->next, id;

    for (int k = 0; k < pg->n; k++) {
        id = ix__step_entity(s);
        ix__step_point(s, 3, pg->v[k].p);
        if (pg->kind == IX_POINTLIST || pg->n == 1)
            ix__step_add(&s->items, id);
    }
    if (pg->kind == IX_POINTLIST || pg->n < 2)
        return;
    id = ix__step_entity(s);
    ix__buf_puts(s->b, "POLYLINE(");
    put_string(s->b, s->name);
    ix__buf_puts(s->b, ",(");
    put_refs(s->b, (size_t)pg->n, 1, first);
    if (closed)
        ix__buf_printf(s->b, ",#%ld", first);
    ix__buf_puts(s->b, "));\n");
    add_item(s, id, false);
}

static ix_status put_poly(void *arg, const ix_obj *o, const ix_poly *p)
{
    ix__step *s = arg;

    take_attributes(s, o);
    for (int i = 0; i < p->n; i++)
        put_polygon(s, &p->poly[i]);
    return ix__buf_check(s->b);
}

/* --- the file ------------------------------------------------------------ */

static void put_head(ix__step *s, const char *name)
{
    ix_buf *b = s->b;

    ix__buf_puts(b, "ISO-10303-21;\nHEADER;\n"
                    "FILE_DESCRIPTION((''),'2;1');\nFILE_NAME(");
    put_string(b, name);
    ix__buf_printf(b,
                   ",'1970-01-01T00:00:00',(''),(''),'iritx %s','iritx','');\n",
                   ix_version());
    ix__buf_puts(b,
                 "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));"
                 "\nENDSEC;\nDATA;\n"
                 "#1=APPLICATION_CONTEXT('core data for automotive mechanical "
                 "design processes');\n"
                 "#2=APPLICATION_PROTOCOL_DEFINITION('international standard',"
                 "'automotive_design',2000,#1);\n"
                 "#3=PRODUCT_CONTEXT('',#1,'mechanical');\n#4=PRODUCT(");
    put_string(b, name);
    ix__buf_putc(b, ',');
    put_string(b, name);
    ix__buf_puts(
        b, ",'',(#3));\n#5=PRODUCT_DEFINITION_FORMATION('','',#4);\n"
           "#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');\n"
           "#7=PRODUCT_DEFINITION('design','',#5,#6);\n"
           "#8=PRODUCT_DEFINITION_SHAPE('','',#7);\n"
           "#9=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
           "#10=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
           "#11=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"
           "#12=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#9,"
           "'distance_accuracy_value','');\n"
           "#13=(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
           "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))"
           "GLOBAL_UNIT_ASSIGNED_CONTEXT((#9,#10,#11))"
           "REPRESENTATION_CONTEXT('','3D'));\n"
           "#14=PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#4));\n");
}

/* The set of all items that are no faces. */
static void put_set(ix__step *s)
{
    long set;

    if (s->items.len == 0)
        return;
    set = ix__step_entity(s);
    ix__buf_printf(s->b, "%s('',(%s));\n",
                   s->surfaces ? "GEOMETRIC_SET" : "GEOMETRIC_CURVE_SET",
                   s->items.data);
    if (s->shells.len > 0)
        ix__step_add(&s->shells, set);
    else
        ix__buf_printf(&s->shells, "#%ld", set);
}

static const char *representation(const ix__step *s, bool shells)
{
    if (shells)
        return s->items.len > 0 ? "SHAPE_REPRESENTATION"
                                : "MANIFOLD_SURFACE_SHAPE_REPRESENTATION";
    return s->surfaces ? "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION"
                       : "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION";
}

/* All shells and the set represent the product's shape. */
static void put_tail(ix__step *s)
{
    const char *kind = representation(s, s->shells.len > 0);
    long id;

    put_set(s);
    id = ix__step_entity(s);
    ix__buf_printf(s->b, "%s('',(%s),#%d);\n", kind, s->shells.data, CONTEXT);
    (void)ix__step_entity(s);
    ix__buf_printf(s->b, "SHAPE_DEFINITION_REPRESENTATION(#%d,#%ld);\n",
                   PRODUCT_SHAPE, id);
    if (s->styles.len > 0) {
        (void)ix__step_entity(s);
        ix__buf_printf(s->b,
                       "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_"
                       "REPRESENTATION('',(%s),#%d);\n",
                       s->styles.data, CONTEXT);
    }
    ix__buf_puts(s->b, "ENDSEC;\nEND-ISO-10303-21;\n");
}

static void tell(const ix__step *s)
{
    if (s->nleft > 0)
        ix__note(s->b->ctx,
                 "the weight changes sign or vanishes: what is near the poles "
                 "is left out (%zu box%s)",
                 s->nleft, s->nleft > 1 ? "es" : "");
    if (s->degree > USUAL_DEGREE)
        ix__note(s->b->ctx,
                 "degree %d: many readers of STEP files take no more than %d",
                 s->degree, (int)USUAL_DEGREE);
}

static ix_status write_all(ix__step *s, const ix_obj *o, const ix_write_opts *w)
{
    const ix__shape_sink sink = {
        .format = "a STEP file",
        .holds = "curves, surfaces, models, polygons, points",
        .freeform = put_freeform,
        .faces = put_faces,
        .poly = put_poly,
        .point = put_point,
        .arg = s};

    put_head(s, o->name ? o->name : "iritx");
    IX_TRY(ix__shapes(s->b->ctx, o, w && w->tol > 0 ? w->tol : 1, &sink));
    IX_TRY(ix__buf_check(&s->items));
    IX_TRY(ix__buf_check(&s->styles));
    IX_TRY(ix__buf_check(&s->shells));
    if (s->items.len == 0 && s->shells.len == 0)
        return IX_FAIL(s->b->ctx, IX_EUNABLE,
                       "nothing is left for a STEP file");
    put_tail(s);
    tell(s);
    return ix__buf_check(s->b);
}

ix_status ix__step_write(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    ix__step s = {.b = b, .next = FIRST_FREE};
    ix_status st;

    ix__buf_init(&s.items, b->ctx);
    ix__buf_init(&s.styles, b->ctx);
    ix__buf_init(&s.shells, b->ctx);
    st = write_all(&s, o, w);
    ix__buf_free(&s.items);
    ix__buf_free(&s.styles);
    ix__buf_free(&s.shells);
    return st;
}
