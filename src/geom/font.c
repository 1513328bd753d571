/* font.c - see the header. The drawings are iritx's own.
 *
 * A glyph is a text of strokes with a blank between them; a stroke is pairs of
 * a letter (x = A, B, .. sixths) and a digit (y = 2 is the base line, 8 the top
 * of capitals), the vertices of a polyline; with ~ in front the control points
 * of a quadratic B-spline. */
#include "geom/font.h"

#include <string.h>

#include "geom/crvs.h"

#define FIRST 32
#define UNIT  (1.0 / 6)
#define BASE  '2'
#define MOST  16 /* points of a stroke */

static const char *const glyphs[] = {
    "",                                   /* space */
    "A8A4 A3A2",                          /* ! */
    "A8A6 B8B6",                          /* " */
    "B8B2 D8D2 A6E6 A4E4",                /* # */
    "~E7E8A8A5E5E2A2A3 C9C1",             /* $ */
    "A2E8 ~A7A8B8B6A6A7 ~E3E2D2D4E4E3",   /* % */
    "~E4E2A2A5D6D8B8B6E2",                /* & */
    "A8A6",                               /* ' */
    "~B9A8A2B1",                          /* ( */
    "~A9B8B2A1",                          /* ) */
    "C7C3 A6E4 A4E6",                     /* * */
    "C7C3 A5E5",                          /* + */
    "B3B2A1",                             /* , */
    "A5D5",                               /* - */
    "A2B2B3A3A2",                         /* . */
    "A2D8",                               /* / */
    "~C8A8A2E2E8C8",                      /* 0 */
    "A7B8B2 A2C2",                        /* 1 */
    "~A6A8E8E5A2 A2E2",                   /* 2 */
    "~A7A8E8E5B5 ~B5E5E2A2A3",            /* 3 */
    "D2D8A4E4",                           /* 4 */
    "E8A8A5 ~A5C6E6E2A2A3",               /* 5 */
    "~E7E8A8A2E2E5A5A4",                  /* 6 */
    "A8E8B2",                             /* 7 */
    "~C8A8A5C5E5E8C8 ~C5A5A2E2E5C5",      /* 8 */
    "~A3A2E2E8A8A5E5E6",                  /* 9 */
    "A2B2B3A3A2 A5B5B6A6A5",              /* : */
    "A5B5B6A6A5 B3B2A1",                  /* ; */
    "D7A5D3",                             /* < */
    "A6D6 A4D4",                          /* = */
    "A7D5A3",                             /* > */
    "~A7A8E8E6C5C4 C3C2",                 /* ? */
    "~D4B4B6D6D4E4E8A8A2E2",              /* @ */
    "A2C8E2 B5D5",                        /* A */
    "A2A8 ~A8E8E5A5 ~A5E5E2A2",           /* B */
    "~E7E8A8A2E2E3",                      /* C */
    "A2A8 ~A8E8E2A2",                     /* D */
    "E8A8A2E2 A5D5",                      /* E */
    "E8A8A2 A5D5",                        /* F */
    "~E7E8A8A2E2E5 E5C5",                 /* G */
    "A8A2 E8E2 A5E5",                     /* H */
    "A8C8 B8B2 A2C2",                     /* I */
    "D8D4 ~D4D2A2A4",                     /* J */
    "A8A2 E8A4 B5E2",                     /* K */
    "A8A2D2",                             /* L */
    "A2A8C5E8E2",                         /* M */
    "A2A8E2E8",                           /* N */
    "~C8A8A2E2E8C8",                      /* O */
    "A2A8 ~A8E8E5A5",                     /* P */
    "~C8A8A2E2E8C8 C4E2",                 /* Q */
    "A2A8 ~A8E8E5A5 C5E2",                /* R */
    "~E7E8A8A5E5E2A2A3",                  /* S */
    "A8E8 C8C2",                          /* T */
    "A8A4 ~A4A2E2E4 E4E8",                /* U */
    "A8C2E8",                             /* V */
    "A8B2C6D2E8",                         /* W */
    "A8E2 A2E8",                          /* X */
    "A8C5E8 C5C2",                        /* Y */
    "A8E8A2E2",                           /* Z */
    "B9A9A1B1",                           /* [ */
    "A8D2",                               /* \ */
    "A9B9B1A1",                           /* ] */
    "A6B8C6",                             /* ^ */
    "A1E1",                               /* _ */
    "A8B7",                               /* ` */
    "~D5D6A6A2D2D3 D6D2",                 /* a */
    "A8A2 ~A3A2D2D6A6A5",                 /* b */
    "~D5D6A6A2D2D3",                      /* c */
    "D8D2 ~D5D6A6A2D2D3",                 /* d */
    "A4D4 ~D4D6A6A2D2D3",                 /* e */
    "~C8B8B6 B6B2 A6C6",                  /* f */
    "~D5D6A6A2D2D3 D6D2 ~D2D0A0A1",       /* g */
    "A8A2 ~A4A6D6D4 D4D2",                /* h */
    "A6A2 A8A7",                          /* i */
    "B6B2 ~B2B0A0 B8B7",                  /* j */
    "A8A2 D6A3 B4D2",                     /* k */
    "A8A3 ~A3A2B2",                       /* l */
    "A6A2 ~A4A6C6C4 C4C2 ~C4C6E6E4 E4E2", /* m */
    "A6A2 ~A4A6D6D4 D4D2",                /* n */
    "~A4A6D6D2A2A4",                      /* o */
    "A6A0 ~A3A2D2D6A6A5",                 /* p */
    "D6D0 ~D5D6A6A2D2D3",                 /* q */
    "A6A2 ~A4A6C6",                       /* r */
    "~D6A6A4D4D2A2",                      /* s */
    "B8B3 ~B3B2C2 A6C6",                  /* t */
    "A6A4 ~A4A2D2D4 D6D2",                /* u */
    "A6C2E6",                             /* v */
    "A6B2C6D2E6",                         /* w */
    "A6D2 A2D6",                          /* x */
    "A6C2 E6B0",                          /* y */
    "A6D6A2D2",                           /* z */
    "~C9B9B5A5 ~A5B5B1C1",                /* { */
    "A9A1",                               /* | */
    "~A9B9B5C5 ~C5B5B1A1",                /* } */
    "~A5B6C4D5",                          /* ~ */
};
#define COUNT (int)(sizeof glyphs / sizeof *glyphs)

static const char *glyph_of(int ch)
{
    return ch >= FIRST && ch < FIRST + COUNT ? glyphs[ch - FIRST] : NULL;
}

double ix__glyph_width(int ch)
{
    const char *g = glyph_of(ch);
    int right = 0;

    if (!g)
        return -1;
    if (!*g)
        return 3 * UNIT;
    for (; *g; g++)
        if (*g >= 'A' && *g <= 'Z' && *g - 'A' > right)
            right = *g - 'A';
    return right * UNIT;
}

/* One stroke, up to the blank; *text moves behind it. */
static ix_status stroke(ix_ctx *ctx, const char **text, ix_mv **out)
{
    double xy[2][MOST], pts[2 * MOST], knots[MOST + 3];
    ix_dir d = {.basis = IX_BSPLINE, .order = 2, .knots = knots};
    const char *s = *text;

    if (*s == '~') {
        d.order = 3;
        s++;
    }
    for (; *s && *s != ' '; s += 2) {
        xy[0][d.length] = (s[0] - 'A') * UNIT;
        xy[1][d.length++] = (s[1] - BASE) * UNIT;
    }
    *text = *s ? s + 1 : s;
    for (int k = 0; k < 2; k++)
        memcpy(pts + (size_t)k * (size_t)d.length, xy[k],
               (size_t)d.length * sizeof *pts);
    IX_TRY(ix_knots_make(ctx, IX_KV_OPEN, d.order, d.length, knots));
    return ix_mv_new(ctx, 1, &d, 2, false, pts, out);
}

static int count_strokes(const char *g)
{
    int n = *g ? 1 : 0;

    for (; *g; g++)
        n += *g == ' ';
    return n;
}

ix_status ix__glyph(ix_ctx *ctx, int ch, ix_crvs *out)
{
    const char *g = glyph_of(ch);
    ix_status st = IX_OK;

    *out = (ix_crvs){0};
    if (!g)
        return IX_FAIL(ctx, IX_EARG,
                       "there is no glyph for the character of code %d; the "
                       "font has ASCII 32 to 126",
                       ch);
    IX_TRY(ix__crvs_new(ctx, count_strokes(g), out));
    for (int i = 0; st == IX_OK && i < out->n; i++)
        st = stroke(ctx, &g, &out->crv[i]);
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    return st;
}
