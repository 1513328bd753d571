/* step_faces.c - trimmed surfaces and models as shells of STEP faces.
 *
 * An edge's curve in space is the surface composed with the trimming curve, so
 * it is exact, and has the same parameters as the curve in the parameter plane
 * that stands beside it. Edges and vertices that meet are written once: those
 * that a model says are one, and those that lie on each other, as at the seam
 * of a closed surface. */
#include <math.h>
#include <string.h>

#include "io/step_impl.h"
#include "iritx/sym.h"

/* Points that are nearer, as part of the size of the shell, are one vertex. */
#define SAME_POINT 1e-6

enum { PLANE_CURVES = 2 }; /* of an edge, at most */

typedef struct {
    double p[3];
    long id;
} vertex;

/* A piece of a trimming curve on a face. */
typedef struct {
    const ix__face_curve *from;
    int face;
    bool back, point; /* in its loop; shrunk to a point in space */
    ix_mv *uv, *xyz;  /* references */
    int edge;         /* in the shell's list */
    bool against;     /* the edge's direction */
} piece;

typedef struct {
    int v[2];
    double mid[3];
    int nuses;
    int use[PLANE_CURVES]; /* pieces */
    int model;             /* edge of the model, or -1 */
    long id;
} edge;

typedef struct {
    ix__step *s;
    ix_ctx *ctx;
    int n;
    const ix__face *face;
    double size;
    long *surface; /* [n] */
    int npieces, cap;
    piece *piece;
    int **first; /* [n][nloops + 1]: pieces of each loop */
    int nedges, nverts;
    edge *edges;
    vertex *verts;
} shell;

/* --- pieces --------------------------------------------------------------- */

/* How often the curve is to be cut: at corners, where its first derivative may
 * jump. */
static bool next_corner(const ix_mv *m, double *t)
{
    ix_dir d = ix_mv_dir(m, 0);

    for (int i = d.order; i + d.order - 1 <= d.length; i++)
        if (d.knots[i] == d.knots[i + d.order - 2]) {
            *t = d.knots[i];
            return true;
        }
    return false;
}

static ix_status add_piece(shell *h, const ix__face_curve *c, int f, ix_mv *uv)
{
    piece *more;

    if (h->npieces == h->cap) {
        IX_SCRATCH(h->ctx, more, 2 * h->cap + 16);
        if (h->npieces > 0)
            memcpy(more, h->piece, (size_t)h->npieces * sizeof *more);
        h->piece = more;
        h->cap = 2 * h->cap + 16;
    }
    h->piece[h->npieces++] = (piece){
        .from = c, .face = f, .back = c->back, .uv = uv, .edge = -1};
    return IX_OK;
}

/* The open B-spline of a trimming curve, cut at its corners if no other face
 * knows them. Takes over rest. */
static ix_status cut_curve(shell *h, const ix__face_curve *c, int f,
                           ix_mv *rest)
{
    ix_status st = IX_OK;
    ix_mv *part[2];
    double t;

    while (st == IX_OK && c->edge < 0 && next_corner(rest, &t)) {
        st = ix_mv_split(h->ctx, rest, 0, t, part);
        if (st != IX_OK)
            break;
        ix_mv_unref(h->ctx, rest);
        rest = part[1];
        st = add_piece(h, c, f, part[0]);
        if (st != IX_OK)
            ix_mv_unref(h->ctx, part[0]);
    }
    if (st == IX_OK)
        st = add_piece(h, c, f, rest);
    if (st != IX_OK)
        ix_mv_unref(h->ctx, rest);
    return st;
}

static void reverse_pieces(piece *p, int n)
{
    for (int i = 0; i < n / 2; i++) {
        piece x = p[i];

        p[i] = p[n - 1 - i];
        p[n - 1 - i] = x;
    }
}

static ix_status open_plane(ix_ctx *ctx, const ix_mv *uv, ix_mv **out)
{
    ix_mv *flat;
    ix_status st;

    IX_TRY(ix_mv_coerce(ctx, uv, 2, ix_mv_rational(uv), &flat));
    st = ix__step_normalized(ctx, flat, out);
    ix_mv_unref(ctx, flat);
    return st;
}

static ix_status loop_pieces(shell *h, int f, int l)
{
    const ix__face_loop *loop = &h->face[f].loop[l];

    h->first[f][l] = h->npieces;
    for (int k = 0; k < loop->n; k++) {
        int before = h->npieces;
        ix_mv *uv;

        IX_TRY(open_plane(h->ctx, loop->curve[k].uv, &uv));
        IX_TRY(cut_curve(h, &loop->curve[k], f, uv));
        if (loop->curve[k].back)
            reverse_pieces(h->piece + before, h->npieces - before);
    }
    h->first[f][l + 1] = h->npieces;
    return IX_OK;
}

/* --- points and curves in space ------------------------------------------- */

static double distance(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static ix_status point_at(const shell *h, const ix_mv *m, double part,
                          double p[3])
{
    double dom[2], v[IX_MAX_COORDS], t;

    ix_mv_domain(m, 0, dom);
    t = part == 1 ? dom[1] : dom[0] + part * (dom[1] - dom[0]);
    IX_TRY(ix_mv_point(h->ctx, m, &t, v));
    for (int c = 0; c < 3; c++)
        p[c] = c < ix_mv_ncoords(m) ? v[c] : 0;
    return IX_OK;
}

/* All control points within SAME_POINT of the first one. */
static ix_status is_point(const shell *h, const ix_mv *m, bool *is)
{
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS], d = 0;

    IX_TRY(ix_mv_bbox(h->ctx, m, lo, hi));
    for (int c = 0; c < ix_mv_ncoords(m); c++)
        d = fmax(d, hi[c] - lo[c]);
    *is = d <= SAME_POINT * h->size;
    return IX_OK;
}

/* Of the least degree that is exact: along isoparametric lines much less than
 * that of the composition. */
static ix_status in_space(shell *h, piece *p)
{
    ix_ctx *ctx = h->ctx;
    ix_mv *cur, *next;

    IX_TRY(ix_sym_compose(ctx, h->face[p->face].srf, p->uv, &cur));
    IX_TRY(
        ix__mv_step(ctx, &cur, &next, ix_sym_reduce(ctx, cur, 0, NULL, &next)));
    IX_TRY(ix__mv_step(ctx, &cur, &next, ix__step_normalized(ctx, cur, &next)));
    p->xyz = cur;
    if (ix_mv_has_poles(cur))
        return IX_FAIL(ctx, IX_EUNABLE,
                       "an edge has weights of both signs or zero");
    return is_point(h, cur, &p->point);
}

/* --- vertices and edges --------------------------------------------------- */

static int find_vertex(shell *h, const double p[3])
{
    vertex *v;

    for (int i = 0; i < h->nverts; i++)
        if (distance(h->verts[i].p, p) <= SAME_POINT * h->size)
            return i;
    v = &h->verts[h->nverts++];
    memcpy(v->p, p, sizeof v->p);
    v->id = ix__step_entity(h->s);
    ix__step_point(h->s, 3, p);
    (void)ix__step_entity(h->s);
    ix__buf_printf(h->s->b, "VERTEX_POINT('',#%ld);\n", v->id++);
    return h->nverts - 1;
}

/* Is the edge from v to w through mid this one, and which way? */
static bool matches(const shell *h, const edge *e, const piece *p,
                    const int v[2], const double mid[3], bool *against)
{
    bool ahead = e->v[0] == v[0] && e->v[1] == v[1];
    bool back = e->v[0] == v[1] && e->v[1] == v[0];

    *against = !ahead;
    if (e->nuses == PLANE_CURVES || (!ahead && !back))
        return false;
    if (p->from->edge >= 0 && p->from->edge == e->model)
        return true;
    if (v[0] == v[1] && h->piece[e->use[0]].back == p->back &&
        h->piece[e->use[0]].face == p->face)
        return false; /* a closed curve run through twice the same way */
    return distance(e->mid, mid) <= SAME_POINT * h->size;
}

static ix_status find_edge(shell *h, int at)
{
    piece *p = &h->piece[at];
    double ends[2][3], mid[3];
    int v[2];
    edge *e;

    for (int k = 0; k < 2; k++) {
        IX_TRY(point_at(h, p->xyz, k, ends[k]));
        v[k] = find_vertex(h, ends[k]);
    }
    IX_TRY(point_at(h, p->xyz, .5, mid));
    for (int i = 0; i < h->nedges; i++)
        if (matches(h, &h->edges[i], p, v, mid, &p->against)) {
            h->edges[i].use[h->edges[i].nuses++] = at;
            p->edge = i;
            return IX_OK;
        }
    p->edge = h->nedges;
    p->against = false;
    e = &h->edges[h->nedges++];
    *e = (edge){
        .v = {v[0], v[1]}, .nuses = 1, .use = {at}, .model = p->from->edge};
    memcpy(e->mid, mid, sizeof mid);
    return IX_OK;
}

/* --- entities of edges -----------------------------------------------------
 */

static long plane_context(ix__step *s)
{
    if (s->plane == 0) {
        s->plane = ix__step_entity(s);
        ix__buf_puts(s->b, "(GEOMETRIC_REPRESENTATION_CONTEXT(2)"
                           "PARAMETRIC_REPRESENTATION_CONTEXT()"
                           "REPRESENTATION_CONTEXT('2D SPACE',''));\n");
    }
    return s->plane;
}

/* The curve in the parameter plane of its face. One that runs against its edge
 * is turned. */
static ix_status put_plane_curve(shell *h, const piece *p, long *id)
{
    ix__step *s = h->s;
    long context = plane_context(s), def, curve;
    ix_mv *uv;

    if (p->against)
        IX_TRY(ix_mv_reverse(h->ctx, p->uv, 0, &uv));
    else
        uv = ix_mv_ref(p->uv);
    curve = ix__step_spline(s, uv, 2);
    ix_mv_unref(h->ctx, uv);
    def = ix__step_entity(s);
    ix__buf_printf(s->b, "DEFINITIONAL_REPRESENTATION('',(#%ld),#%ld);\n",
                   curve, context);
    *id = ix__step_entity(s);
    ix__buf_printf(s->b, "PCURVE('',#%ld,#%ld);\n", h->surface[p->face], def);
    return ix__buf_check(s->b);
}

static ix_status put_edge(shell *h, edge *e)
{
    ix__step *s = h->s;
    const piece *p = &h->piece[e->use[0]];
    long space = ix__step_spline(s, p->xyz, 3), plane[PLANE_CURVES] = {0};
    long curve;
    bool seam = e->nuses == 2 && p->face == h->piece[e->use[1]].face;

    for (int k = 0; k < e->nuses; k++)
        IX_TRY(put_plane_curve(h, &h->piece[e->use[k]], &plane[k]));
    curve = ix__step_entity(s);
    ix__buf_printf(s->b, "%s('',#%ld,(#%ld",
                   seam ? "SEAM_CURVE" : "SURFACE_CURVE", space, plane[0]);
    if (e->nuses > 1)
        ix__buf_printf(s->b, ",#%ld", plane[1]);
    ix__buf_puts(s->b, "),.PCURVE_S1.);\n");
    e->id = ix__step_entity(s);
    ix__buf_printf(s->b, "EDGE_CURVE('',#%ld,#%ld,#%ld,.T.);\n",
                   h->verts[e->v[0]].id, h->verts[e->v[1]].id, curve);
    return ix__buf_check(s->b);
}

/* --- faces -----------------------------------------------------------------
 */

/* The loop as it was given, backwards if turn. Returns 0 if nothing but points
 * is in it. */
static long put_loop(shell *h, int f, int l, bool turn)
{
    ix__step *s = h->s;
    int n = h->first[f][l + 1] - h->first[f][l];
    long first = s->next, last, id;

    for (int i = 0; i < n; i++) {
        int k = h->first[f][l] + (turn ? n - 1 - i : i);
        const piece *p = &h->piece[k];

        if (p->point)
            continue;
        (void)ix__step_entity(s);
        ix__buf_printf(s->b, "ORIENTED_EDGE('',*,*,#%ld,%s);\n",
                       h->edges[p->edge].id,
                       (p->back != turn) == p->against ? ".T." : ".F.");
    }
    last = s->next;
    if (first == last)
        return 0;
    id = ix__step_entity(s);
    ix__buf_puts(s->b, "EDGE_LOOP('',(");
    for (long i = first; i < last; i++)
        ix__buf_printf(s->b, "%s#%ld", i > first ? "," : "", i);
    ix__buf_puts(s->b, "));\n");
    return id;
}

/* The face within outer loop l, with its holes. */
static void put_face(shell *h, int f, int l, const ix__nesting *nest,
                     ix_buf *faces)
{
    ix__step *s = h->s;
    ix_buf bounds;
    long id;

    ix__buf_init(&bounds, h->ctx);
    for (int i = 0; i < h->face[f].nloops; i++) {
        bool turn = nest[i].turn != h->face[f].reversed;
        long loop = nest[i].outer == l ? put_loop(h, f, i, turn) : 0;

        if (loop == 0)
            continue;
        ix__step_add(&bounds, ix__step_entity(s));
        ix__buf_printf(s->b, "%s('',#%ld,.T.);\n",
                       i == l ? "FACE_OUTER_BOUND" : "FACE_BOUND", loop);
    }
    id = ix__step_entity(s);
    ix__buf_printf(s->b, "ADVANCED_FACE('',(%s),#%ld,%s);\n",
                   bounds.len > 0 ? bounds.data : "", h->surface[f],
                   h->face[f].reversed ? ".F." : ".T.");
    ix__step_style(s, id, true);
    ix__step_add(faces, id);
    s->b->failed = s->b->failed || bounds.failed;
    ix__buf_free(&bounds);
}

static ix_status put_faces(shell *h, ix_buf *faces)
{
    for (int f = 0; f < h->n; f++) {
        ix__nesting *nest;

        IX_TRY(ix__face_nesting(h->ctx, &h->face[f], &nest));
        for (int l = 0; l < h->face[f].nloops; l++)
            if (nest[l].outer == l && h->face[f].loop[l].n > 0)
                put_face(h, f, l, nest, faces);
    }
    IX_TRY(ix__buf_check(faces));
    return ix__buf_check(h->s->b);
}

/* --- the shell -------------------------------------------------------------
 */

static ix_status put_surface(shell *h, int f)
{
    const ix_mv *m = h->face[f].srf;
    ix_mv *open;
    double t;

    IX_TRY(ix__step_normalized(h->ctx, m, &open));
    for (int d = 0; d < 2; d++)
        if (ix__step_jump(open, d, &t)) {
            ix_mv_unref(h->ctx, open);
            return IX_FAIL(h->ctx, IX_EUNABLE,
                           "the trimmed surface jumps at %c = %g",
                           d ? 'v' : 'u', t);
        }
    h->surface[f] = ix__step_spline(h->s, open, 3);
    ix_mv_unref(h->ctx, open);
    return IX_OK;
}

static ix_status size_of(shell *h)
{
    for (int f = 0; f < h->n; f++) {
        double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

        if (ix_mv_has_poles(h->face[f].srf))
            return IX_FAIL(h->ctx, IX_EUNABLE,
                           "the weights of the trimmed surface are zero or of "
                           "both signs");
        IX_TRY(ix_mv_bbox(h->ctx, h->face[f].srf, lo, hi));
        for (int c = 0; c < ix_mv_ncoords(h->face[f].srf) && c < 3; c++)
            h->size = fmax(h->size, hi[c] - lo[c]);
    }
    return IX_OK;
}

static bool is_closed(const shell *h)
{
    for (int i = 0; i < h->nedges; i++)
        if (h->edges[i].nuses != 2)
            return false;
    return true;
}

static ix_status make_pieces(shell *h)
{
    IX_SCRATCH(h->ctx, h->surface, h->n);
    IX_SCRATCH(h->ctx, h->first, h->n);
    for (int f = 0; f < h->n; f++) {
        IX_TRY(put_surface(h, f));
        IX_SCRATCH_ZERO(h->ctx, h->first[f], h->face[f].nloops + 1);
        for (int l = 0; l < h->face[f].nloops; l++)
            IX_TRY(loop_pieces(h, f, l));
    }
    IX_SCRATCH(h->ctx, h->edges, h->npieces);
    IX_SCRATCH(h->ctx, h->verts, 2 * (size_t)h->npieces);
    for (int i = 0; i < h->npieces; i++) {
        IX_TRY(ix__poll(h->ctx));
        IX_TRY(in_space(h, &h->piece[i]));
        if (!h->piece[i].point)
            IX_TRY(find_edge(h, i));
    }
    return IX_OK;
}

static ix_status put_shell(shell *h, ix_buf *faces)
{
    ix__step *s = h->s;
    long id;

    IX_TRY(size_of(h));
    IX_TRY(make_pieces(h));
    for (int i = 0; i < h->nedges; i++)
        IX_TRY(put_edge(h, &h->edges[i]));
    IX_TRY(put_faces(h, faces));
    if (faces->len == 0)
        return IX_FAIL(h->ctx, IX_EUNABLE, "its faces have no loops");
    id = ix__step_entity(s);
    ix__buf_printf(s->b, "%s('',(%s));\n",
                   is_closed(h) ? "CLOSED_SHELL" : "OPEN_SHELL", faces->data);
    ix__step_add(&s->shells, ix__step_entity(s));
    ix__buf_printf(s->b, "SHELL_BASED_SURFACE_MODEL('',(#%ld));\n", id);
    return ix__buf_check(s->b);
}

static ix_status shell_of(ix__step *s, int n, const ix__face *face)
{
    shell h = {.s = s, .ctx = s->b->ctx, .n = n, .face = face};
    ix_buf faces;
    ix_status st;

    ix__buf_init(&faces, h.ctx);
    st = put_shell(&h, &faces);
    for (int i = 0; i < h.npieces; i++) {
        ix_mv_unref(h.ctx, h.piece[i].uv);
        ix_mv_unref(h.ctx, h.piece[i].xyz);
    }
    ix__buf_free(&faces);
    return st;
}

ix_status ix__step_shell(ix__step *s, int n, const ix__face *face)
{
    IX_RETURN_SCOPED(s->b->ctx, shell_of(s, n, face));
}
