/* stl.c - triangles for printing: text (.stl) and binary (.bstl). Faces of
 * surfaces are counter-clockwise seen from where S_u x S_v points, which is
 * outside for solids whose normals, S_v x S_u as in scripts, point inside. */
#include <math.h>
#include <string.h>

#include "io/export.h"
#include "io/shapes.h"

typedef struct {
    ix_buf *b;
    bool binary;
    uint32_t count;
} stl;

/* The unit normal of a face; 0 if it has no area. */
static void face_normal(const double *const p[3], double n[3])
{
    double a[3], b[3], len;

    for (int c = 0; c < 3; c++) {
        a[c] = p[1][c] - p[0][c];
        b[c] = p[2][c] - p[0][c];
    }
    for (int c = 0; c < 3; c++)
        n[c] = a[(c + 1) % 3] * b[(c + 2) % 3] -
               a[(c + 2) % 3] * b[(c + 1) % 3];
    len = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int c = 0; c < 3; c++)
        n[c] = len > 0 ? n[c] / len : 0;
}

/* Little-endian, whatever the machine. */
static void put_u32(ix_buf *b, uint32_t v)
{
    char s[4];

    for (int i = 0; i < 4; i++)
        s[i] = (char)(unsigned char)(v >> (8 * i) & 255);
    ix__buf_add(b, s, 4);
}

static void put_float(ix_buf *b, double v)
{
    float f = (float)v;
    uint32_t u;

    memcpy(&u, &f, sizeof u);
    put_u32(b, u);
}

static void put_vector(const stl *s, const char *word, const double *v)
{
    if (!s->binary)
        ix__buf_puts(s->b, word);
    for (int c = 0; c < 3; c++) {
        if (s->binary) {
            put_float(s->b, v[c]);
            continue;
        }
        ix__buf_putc(s->b, ' ');
        ix__buf_num(s->b, v[c]);
    }
    if (!s->binary)
        ix__buf_putc(s->b, '\n');
}

/* Facets that have become a line in single precision stay: they close the
 * surface. */
static ix_status put_face(stl *s, const double *const p[3])
{
    double n[3];

    if (s->binary && s->count == UINT32_MAX)
        return IX_FAIL(s->b->ctx, IX_EUNABLE, "too many triangles");
    s->count++;
    face_normal(p, n);
    put_vector(s, "facet normal", n);
    if (!s->binary)
        ix__buf_puts(s->b, "  outer loop\n");
    for (int k = 0; k < 3; k++)
        put_vector(s, "    vertex", p[k]);
    if (s->binary)
        ix__buf_add(s->b, "\0\0", 2);
    else
        ix__buf_puts(s->b, "  endloop\nendfacet\n");
    return IX_OK;
}

static ix_status put_mesh(void *arg, const ix_obj *o, const ix__mesh *m)
{
    stl *s = arg;

    (void)o;
    for (size_t i = 0; i < m->ntris; i++) {
        const double *const p[3] = {m->xyz + 3 * (size_t)m->tri[i][0],
                                    m->xyz + 3 * (size_t)m->tri[i][1],
                                    m->xyz + 3 * (size_t)m->tri[i][2]};

        IX_TRY(put_face(s, p));
    }
    return ix__buf_check(s->b);
}

static ix_status put_polygon(stl *s, const ix_polygon *pg)
{
    int *work, (*tri)[3], n;

    IX_SCRATCH(s->b->ctx, work, pg->n);
    IX_SCRATCH(s->b->ctx, tri, pg->n);
    n = ix__polygon_ears(pg, work, tri);
    for (int i = 0; i < n; i++) {
        const double *const p[3] = {pg->v[tri[i][0]].p, pg->v[tri[i][1]].p,
                                    pg->v[tri[i][2]].p};

        IX_TRY(put_face(s, p));
    }
    return ix__buf_check(s->b);
}

/* Each vertex after the second makes a triangle with the two before it. */
static ix_status put_strip(stl *s, const ix_polygon *pg)
{
    for (int i = 0; i + 2 < pg->n; i++) {
        const double *const p[3] = {pg->v[i + i % 2].p, pg->v[i + 1 - i % 2].p,
                                    pg->v[i + 2].p};

        IX_TRY(put_face(s, p));
    }
    return ix__buf_check(s->b);
}

static ix_status put_poly(void *arg, const ix_obj *o, const ix_poly *p)
{
    stl *s = arg;

    (void)o;
    for (int i = 0; i < p->n; i++) {
        ix_mark mk = ix__scratch_mark(s->b->ctx);
        ix_status st = IX_OK;

        if (p->poly[i].kind == IX_POLYGON && p->poly[i].n > 2)
            st = put_polygon(s, &p->poly[i]);
        else if (p->poly[i].kind == IX_POLYSTRIP)
            st = put_strip(s, &p->poly[i]);
        ix__scratch_release(s->b->ctx, mk);
        IX_TRY(st);
    }
    return IX_OK;
}

static ix_status write_shapes(stl *s, const ix_obj *o, const ix_write_opts *w)
{
    const ix__shape_sink sink = {.format = "an STL file",
                                 .holds = "surfaces, models, polygons",
                                 .mesh = put_mesh,
                                 .poly = put_poly,
                                 .arg = s};

    IX_TRY(ix__shapes(s->b->ctx, o, w ? w->tol : 0, &sink));
    if (s->count == 0)
        return IX_FAIL(s->b->ctx, IX_EARG,
                       "there are no surfaces or polygons for an STL file");
    return IX_OK;
}

ix_status ix__stl_write(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    const char *name = o->name ? o->name : "iritx";
    stl s = {.b = b};

    ix__buf_printf(b, "solid %.200s\n", name);
    IX_TRY(write_shapes(&s, o, w));
    ix__buf_printf(b, "endsolid %.200s\n", name);
    return ix__buf_check(b);
}

ix_status ix__bstl_write(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    static const char title[] = "binary STL by iritx";
    stl s = {.b = b, .binary = true};
    size_t at = b->len;

    ix__buf_puts(b, title);
    ix__buf_fill(b, ' ', 80 - (sizeof title - 1));
    put_u32(b, 0);
    IX_TRY(write_shapes(&s, o, w));
    IX_TRY(ix__buf_check(b));
    for (int i = 0; i < 4; i++)
        b->data[at + 80 + (size_t)i] = (char)(unsigned char)(s.count >>
                                                                 (8 * i) &
                                                             255);
    return IX_OK;
}
