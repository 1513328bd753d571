/* builtins_text.c - text as curves, in the plane and on surfaces (chapters 11
 * and 12 of spec/functions). */
#include <string.h>

#include "geom/font.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"

/* Where a glyph of the font goes: x' = x0 + sx x, y' = y0 + sy y, z0. */
typedef struct {
    double x0, y0, z0, sx, sy;
    const ix_mv *srf; /* NULL, or (x', y') are its parameters */
} placing;

static ix_status place_stroke(ix_call *c, const ix_mv *stroke, const placing *p,
                              ix_obj *list)
{
    const double mat[16] = {p->sx, 0, 0, 0, 0,     p->sy, 0,     0,
                            0,     0, 1, 0, p->x0, p->y0, p->z0, 1};
    ix_mv *wide = NULL, *moved = NULL, *out = NULL;
    ix_status st = ix_mv_coerce(c->ctx, stroke, 3, false, &wide);

    if (st == IX_OK)
        st = ix_mv_transform(c->ctx, wide, mat, &moved);
    if (st == IX_OK && p->srf)
        st = ix_sym_compose(c->ctx, p->srf, moved, &out);
    else if (st == IX_OK)
        out = ix_mv_ref(moved);
    if (st == IX_OK)
        st = ix__list_add(c->ctx, list, ix__obj_mv(c->ctx, IX_OBJ_CURVE, out));
    ix_mv_unref(c->ctx, wide);
    ix_mv_unref(c->ctx, moved);
    return st;
}

/* The curves of one glyph as an element of the list. */
static ix_status add_glyph(ix_call *c, int ch, const placing *p, ix_obj *list)
{
    ix_obj *own;
    ix_crvs g;
    ix_status st;

    IX_TRY(ix__glyph(c->ctx, ch, &g));
    own = ix__obj_list(c->ctx);
    st = own ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < g.n; i++)
        st = place_stroke(c, g.crv[i], p, own);
    if (st == IX_OK && g.n > 0)
        st = ix__obj_append(c->ctx, list, own);
    ix__obj_unref(c->ctx, own);
    ix_crvs_free(c->ctx, &g);
    return st;
}

/* Width of the text with gap after each character but the last. */
static ix_status text_width(ix_call *c, int i, double gap, double *out)
{
    const char *s = ix__arg_str(c, i);

    *out = 0;
    if (!*s)
        return IX_ARG_FAIL(c, i, "an empty text");
    for (int k = 0; s[k]; k++) {
        double w = ix__glyph_width((unsigned char)s[k]);

        if (w < 0)
            return IX_ARG_FAIL(c, i,
                               "character %d has code %d; the font has ASCII "
                               "32 to 126",
                               k + 1, (unsigned char)s[k]);
        *out += w + (s[k + 1] ? gap : 0);
    }
    return IX_OK;
}

/* Glyph after glyph, each step p forward: its width and gap. */
static ix_status ret_text(ix_call *c, const char *s, placing p,
                          const double gap[3])
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (; st == IX_OK && *s; s++) {
        st = add_glyph(c, *s, &p, list);
        p.x0 += p.sx * ix__glyph_width(*s) + gap[0];
        p.y0 += gap[1];
        p.z0 += gap[2];
    }
    return ix__ret_list(c, list, st);
}

static ix_status textgeom(ix_call *c)
{
    placing p = {.sx = ix__arg_num(c, 2), .sy = ix__arg_num(c, 2)};
    double gap[3], width;

    IX_TRY(ix__arg_vec3(c, 1, gap));
    IX_TRY(text_width(c, 0, 0, &width));
    if (!(p.sx > 0))
        return IX_ARG_FAIL(c, 2, "a scale of %g; it must be positive", p.sx);
    return ret_text(c, ix__arg_str(c, 0), p, gap);
}

/* The text fills the surface's domain from left to right. */
static ix_status textwarp(ix_call *c)
{
    const ix_mv *s = ix__arg_mv(c, 0);
    double width, u[2], v[2], base = ix__arg_num(c, 3), top = ix__arg_num(c, 4);
    double gap = ix__arg_num(c, 2),
           bottom = base - IX__FONT_DEPTH * (top - base);
    placing p = {.srf = s};

    if (!(gap >= 0))
        return IX_ARG_FAIL(c, 2, "a space of %g; it cannot be negative", gap);
    if (!(base < top))
        return IX_ARG_FAIL(c, 3, "the base line %g is not below the top %g",
                           base, top);
    if (!(bottom >= 0) || !(base + (top - base) * 7 / 6 <= 1))
        return IX_ARG_FAIL(c, 3,
                           "letters between %g and %g reach from %g to %g, "
                           "which must be within 0 and 1",
                           base, top, bottom, base + (top - base) * 7 / 6);
    IX_TRY(text_width(c, 1, gap, &width));
    ix_mv_domain(s, 0, u);
    ix_mv_domain(s, 1, v);
    p.sx = width > 0 ? (u[1] - u[0]) / width : 0;
    p.x0 = width > 0 ? u[0] : (u[0] + u[1]) / 2; /* one vertical stroke */
    p.y0 = v[0] + base * (v[1] - v[0]);
    p.sy = (top - base) * (v[1] - v[0]);
    return ret_text(c, ix__arg_str(c, 1), p,
                    (const double[3]){gap * p.sx, 0, 0});
}

const ix_builtin ix__builtins_text[] = {
    {"TEXTGEOM", "text:str spacing:vector scale:num -> list",
     "Text as curves in the XY plane: a list of the curves of each character "
     "that is not a blank, from left to right. Capitals are scale high and "
     "stand on y = 0; after each character, spacing is added to its width.",
     "l = textgeom(\"Hi\", vector(0.2, 0, 0), 1);", textgeom, 0, 11},
    {"TEXTWARP",
     "s:surface text:str hspace:num vbase:num vtop:num ligature:num -> list",
     "The curves of TEXTGEOM exactly on a surface: the text fills the domain "
     "of u, with hspace times the height of a capital between letters; "
     "capitals reach from vbase to vtop, as parts of the domain of v, tails a "
     "third lower. The font has no ligatures: the last number is not needed.",
     "s = ruledsrf(ctlpt(E3,0,0,0) + ctlpt(E3,3,0,1), ctlpt(E3,0,1,0) + "
     "ctlpt(E3,3,1,1)); l = textwarp(s, \"abc\", 0.1, 0.3, 0.8, 0);",
     textwarp, 0, 12},
    {0}};
