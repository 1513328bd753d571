/* xml_read_brep.c - trimmed surfaces and models from XML. The parts are
 * gathered in flat arrays, as a stream does not tell their number before. */
#include <math.h>
#include <string.h>

#include "io/gather.h"
#include "io/xml_read_impl.h"

static ix_status need_child(ix__xmlr *r, const char *name)
{
    size_t at = r->e.at;
    bool more;

    IX_TRY(ix__xmlr_child(r, &more));
    if (!more)
        return ix__xml_fail(r->x, at, "element \"%s\" expected in it", name);
    return ix__xmlr_is(r, name) ? IX_OK : ix__xmlr_unexpected(r, name);
}

/* A curve into the place that its attribute "use" tells. */
static ix_status read_use(ix__xmlr *r, int n, const char *const *uses,
                          const ix_mv **const *places)
{
    size_t at = r->e.at;
    int i;

    if (!ix__xmlr_is(r, "curve"))
        return ix__xmlr_unexpected(r, "curve");
    IX_TRY(ix__xmlr_word(r, "use", n, uses, &i));
    if (*places[i])
        return ix__xml_fail(r->x, at, "a second curve for use \"%s\"", uses[i]);
    return ix__xmlr_mv(r, 1, places[i]);
}

static ix_status read_uses(ix__xmlr *r, int n, const char *const *uses,
                           const ix_mv **const *places)
{
    bool more;

    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            return IX_OK;
        IX_TRY(read_use(r, n, uses, places));
    }
}

/* --- trimmed surfaces ------------------------------------------------- */

static ix_status read_segment(ix__xmlr *r, ix__trimming *t)
{
    static const char *const uses[] = {"uv", "space"};
    size_t at = r->e.at;
    const ix_mv **places[2];
    ix_trimseg *s;

    if (!ix__xmlr_is(r, "segment"))
        return ix__xmlr_unexpected(r, "segment");
    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(ix__trimming_seg(r->ctx, t, &s));
    places[0] = &s->uv;
    places[1] = &s->euclid;
    IX_TRY(read_uses(r, 2, uses, places));
    return s->uv ? IX_OK
                 : ix__xml_fail(r->x, at, "a segment without its uv curve");
}

static ix_status read_loop(ix__xmlr *r, ix__trimming *t)
{
    size_t at = r->e.at;
    int first = t->nsegs;
    bool more;

    if (!ix__xmlr_is(r, "loop"))
        return ix__xmlr_unexpected(r, "loop");
    IX_TRY(ix__xmlr_allow(r, ""));
    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            break;
        IX_TRY(read_segment(r, t));
    }
    if (t->nsegs == first)
        return ix__xml_fail(r->x, at, "a loop without segments");
    return ix__trimming_loop(r->ctx, t, first);
}

static ix_status read_trimsrf(ix__xmlr *r, ix__trimming *t, ix_trimsrf **out)
{
    size_t at = r->e.at;
    bool more;

    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(need_child(r, "surface"));
    IX_TRY(ix__xmlr_mv(r, 2, &t->srf));
    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            break;
        IX_TRY(read_loop(r, t));
    }
    if (t->nloops == 0)
        ix__xml_warn(r->x, at, "a trimmed surface has no trimming curve");
    return ix__trimming_make(r->ctx, t, out);
}

ix_status ix__xmlr_trimsrf(ix__xmlr *r, const void **out)
{
    ix_mark mk = ix__scratch_mark(r->ctx);
    ix__trimming t = {0};
    ix_trimsrf *made = NULL;
    ix_status st = read_trimsrf(r, &t, &made);

    ix__trimming_drop(r->ctx, &t);
    ix__scratch_release(r->ctx, mk);
    *out = made;
    return st;
}

/* --- models ----------------------------------------------------------- */

typedef struct {
    const ix_mv *srf;
    int nloops;
} face;

/* A loop of a face: edges [0 .. n) of a common array. */
typedef struct {
    size_t at;
    int n;
} loop;

typedef struct {
    int nfaces, face_cap, nloops, loop_cap, nrefs, ref_cap, nedges, edge_cap;
    face *face;
    loop *loop;
    int *ref; /* numbers of edges, of all loops */
    ix_model_seg *edge;
} model;

static ix_status read_edge_numbers(ix__xmlr *r, model *m)
{
    const int most = 1 << 30;
    loop l = {.at = r->e.at};

    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(ix__xmlr_text(r));
    for (; !ix__xmlr_at_end(r); l.n++) {
        const char *p = r->p;
        double v;

        IX_TRY(ix__xmlr_num(r, &v));
        if (v != floor(v) || v == 0 || fabs(v) > most) {
            r->p = p;
            return ix__xmlr_bad_text(r, "the number of an edge expected (from "
                                        "1 on; negative: reversed)");
        }
        IX_TRY(ix__gather(r->ctx, m->nrefs, &m->ref_cap, sizeof *m->ref,
                          (void *)&m->ref));
        m->ref[m->nrefs++] = (int)v;
    }
    IX_TRY(ix__gather(r->ctx, m->nloops, &m->loop_cap, sizeof *m->loop,
                      (void *)&m->loop));
    m->loop[m->nloops++] = l;
    return IX_OK;
}

static ix_status read_face(ix__xmlr *r, model *m)
{
    bool more;
    face *f;

    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(ix__gather(r->ctx, m->nfaces, &m->face_cap, sizeof *m->face,
                      (void *)&m->face));
    f = &m->face[m->nfaces++];
    *f = (face){0};
    IX_TRY(need_child(r, "surface"));
    IX_TRY(ix__xmlr_mv(r, 2, &f->srf));
    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            return IX_OK;
        if (!ix__xmlr_is(r, "edges"))
            return ix__xmlr_unexpected(r, "edges");
        IX_TRY(read_edge_numbers(r, m));
        f->nloops++;
    }
}

static ix_status read_edge(ix__xmlr *r, model *m)
{
    static const char *const uses[] = {"uv1", "uv2", "space"};
    const ix_mv **places[3];
    ix_model_seg *s;

    IX_TRY(ix__xmlr_allow(r, " face1 face2 "));
    IX_TRY(ix__gather(r->ctx, m->nedges, &m->edge_cap, sizeof *m->edge,
                      (void *)&m->edge));
    s = &m->edge[m->nedges++];
    *s = (ix_model_seg){0};
    IX_TRY(ix__xmlr_int(r, "face1", 0, m->nfaces, &s->s1));
    IX_TRY(ix__xmlr_int(r, "face2", 0, m->nfaces, &s->s2));
    places[0] = &s->uv1;
    places[1] = &s->uv2;
    places[2] = &s->euclid;
    IX_TRY(read_uses(r, 3, uses, places));
    s->mask = (s->uv1 ? 1 : 0) + (s->uv2 ? 2 : 0) + (s->euclid ? 4 : 0);
    return IX_OK;
}

static ix_status check_edge_numbers(ix__xmlr *r, const model *m)
{
    const int *ref = m->ref;

    for (int i = 0; i < m->nloops; i++)
        for (int k = 0; k < m->loop[i].n; k++, ref++)
            if (*ref > m->nedges || *ref < -m->nedges)
                return ix__xml_fail(r->x, m->loop[i].at,
                                    "edge %d of %d in a loop", *ref, m->nedges);
    return IX_OK;
}

static ix_status read_parts(ix__xmlr *r, model *m)
{
    size_t at = r->e.at;
    bool more;

    IX_TRY(ix__xmlr_allow(r, ""));
    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            break;
        if (ix__xmlr_is(r, "face") && m->nedges == 0)
            IX_TRY(read_face(r, m));
        else if (ix__xmlr_is(r, "edge"))
            IX_TRY(read_edge(r, m));
        else
            return ix__xmlr_unexpected(r, "faces, then edges,");
    }
    if (m->nfaces == 0)
        return ix__xml_fail(r->x, at, "a model without faces");
    return check_edge_numbers(r, m);
}

/* The references move from m into out. */
static ix_status fill_model(ix__xmlr *r, model *m, ix_model *out)
{
    const loop *l = m->loop;
    const int *ref = m->ref;

    for (int i = 0; i < m->nfaces; i++) {
        ix_model_srf *s = &out->srf[i];

        s->srf = m->face[i].srf;
        m->face[i].srf = NULL;
        IX_TRY(ix__model_loops(r->ctx, s, m->face[i].nloops));
        for (int k = 0; k < m->face[i].nloops; k++, l++) {
            IX_TRY(ix__model_loop_segs(r->ctx, s, k, l->n));
            if (l->n > 0)
                memcpy(s->seg[k], ref, (size_t)l->n * sizeof *ref);
            ref += l->n;
        }
    }
    for (int i = 0; i < m->nedges; i++) {
        out->seg[i] = m->edge[i];
        m->edge[i] = (ix_model_seg){0};
    }
    return IX_OK;
}

static void drop_parts(ix_ctx *ctx, const model *m)
{
    for (int i = 0; i < m->nfaces; i++)
        ix_mv_unref(ctx, m->face[i].srf);
    for (int i = 0; i < m->nedges; i++) {
        ix_mv_unref(ctx, m->edge[i].uv1);
        ix_mv_unref(ctx, m->edge[i].uv2);
        ix_mv_unref(ctx, m->edge[i].euclid);
    }
}

ix_status ix__xmlr_model(ix__xmlr *r, const void **out)
{
    ix_mark mk = ix__scratch_mark(r->ctx);
    model m = {0};
    ix_model *made = NULL;
    ix_status st = read_parts(r, &m);

    if (st == IX_OK) {
        made = ix__model_new(r->ctx, m.nfaces, m.nedges);
        st = made ? fill_model(r, &m, made) : IX_ENOMEM;
    }
    drop_parts(r->ctx, &m);
    ix__scratch_release(r->ctx, mk);
    if (st != IX_OK && made)
        ix__model_unref(r->ctx, made);
    *out = st == IX_OK ? made : NULL;
    return st;
}
