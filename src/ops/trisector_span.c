/* trisector_span.c - points, curves and surfaces as Bezier pieces with their
 * tangents, for trisectors: values at parameters, bounds over boxes of them. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "ops/trisector_impl.h"
#include "sym/form.h"

/* --- making -----------------------------------------------------------------
 */

/* The numerators of the derivatives, in the global parameters. */
static ix_status derivative(ix_ctx *ctx, const ix_form *f, bool rational,
                            int dir, ix_form *out)
{
    ix_form w, x;
    double degree = f->dirs[dir].degree, h = ix__spans_mean(&f->dirs[dir]);

    if (!rational)
        return ix__form_derive(ctx, f, dir, out);
    w = ix__form_rows(f, 0, 1);
    x = ix__form_rows(f, 1, 3);
    IX_TRY(ix__form_jacobian(ctx, &x, &w, dir, out));
    if (degree > 0.0)
        ix__form_times(out, 1.0 / (degree * h));
    return IX_OK;
}

/* The coefficients on span (i, j), times factor; without a weight w = 1. */
static ix_status field_of(ix_ctx *ctx, const ix_form *f, const double *all,
                          const int at[2], double factor, bool weight,
                          ix__tri_field *out)
{
    int d0 = f->dirs[0].degree, d1 = f->ndirs > 1 ? f->dirs[1].degree : 0;
    int row = f->dirs[0].nspans * (d0 + 1), extra = weight;
    double *c;

    *out = (ix__tri_field){f->nrows + extra, {d0, d1}, NULL};
    IX_SCRATCH(ctx, c, (d0 + 1) * (d1 + 1) * out->rows);
    out->c = c;
    for (int k = 0; k <= d1; k++)
        for (int i = 0; i <= d0; i++) {
            int n = (at[1] * (d1 + 1) + k) * row + at[0] * (d0 + 1) + i;

            if (weight)
                *c++ = 1.0;
            for (int r = 0; r < f->nrows; r++)
                *c++ = factor * all[(size_t)r * f->n + (size_t)n];
        }
    return IX_OK;
}

/* What vanishes on an edge, of the largest coefficient: rounding of products.
 */
#define VANISHES 1e-12

/* Coefficients of a tensor of these degrees. */
static size_t coefficients(const int deg[2])
{
    return ((size_t)deg[0] + 1) * ((size_t)deg[1] + 1);
}

static double largest(const ix__tri_field *f)
{
    return ix__bern_largest(coefficients(f->deg) * (size_t)f->rows, f->c);
}

static const double *coefs(const ix__tri_field *f, int i, int k)
{
    return f->c + (k * (f->deg[0] + 1) + i) * f->rows;
}

/* Whether f is zero where parameter dir is side (0 or 1). */
static bool zero_edge(const ix__tri_field *f, int dir, int side)
{
    double big = largest(f);

    for (int k = 0; k <= f->deg[!dir]; k++) {
        int i = side * f->deg[dir];

        if (ix__bern_largest((size_t)f->rows,
                             dir == 0 ? coefs(f, i, k) : coefs(f, k, i)) >
            VANISHES * big)
            return false;
    }
    return true;
}

/* f / u, or f / (1 - u): B(d,k+1) = d / (k + 1) u B(d-1,k). */
static ix_status divide(ix_ctx *ctx, int dir, int side, ix__tri_field *f)
{
    ix__tri_field g = *f;
    int d = f->deg[dir];
    double *c;

    g.deg[dir]--;
    IX_SCRATCH(ctx, c, (g.deg[0] + 1) * (g.deg[1] + 1) * g.rows);
    g.c = c;
    for (int k = 0; k <= g.deg[1]; k++)
        for (int i = 0; i <= g.deg[0]; i++) {
            int at = dir == 0 ? i : k;
            double factor = (double)d / (side ? d - at : at + 1);
            const double *from = coefs(f, i + (dir == 0 && !side),
                                       k + (dir == 1 && !side));

            for (int r = 0; r < g.rows; r++)
                *c++ = factor * from[r];
        }
    *f = g;
    return IX_OK;
}

static ix_status tangent_of(ix_ctx *ctx, const ix__tri_field *d,
                            ix__tri_field *out)
{
    *out = *d;
    for (int dir = 0; dir < 2; dir++)
        for (int side = 0; side < 2; side++)
            while (out->deg[dir] > 0 && zero_edge(out, dir, side))
                IX_TRY(divide(ctx, dir, side, out));
    return IX_OK;
}

/* C(p,i) C(q,k) / C(p+q,i+k): the weight of a product of two Bernstein
 * coefficients, double[p + 1][q + 1]. */
static ix_status weights_of(ix_ctx *ctx, int p, int q, const double **out)
{
    double *w, start = 1.0;

    IX_SCRATCH(ctx, w, (p + 1) * (q + 1));
    *out = w;
    for (int i = 0; i <= p; i++) {
        double v = start;

        for (int k = 0; k <= q; k++) {
            *w++ = v;
            v *= (double)(q - k) / (k + 1) * (i + k + 1) /
                 fmax(p + q - i - k, 1.0);
        }
        start *= (double)(p - i) / fmax(p + q - i, 1.0);
    }
    return IX_OK;
}

static ix_status span_of(ix_ctx *ctx, const ix_form *f, const ix_form *d,
                         const double *const all[3], bool rational,
                         const int at[2], ix__tri_span *s)
{
    size_t n = 0, most = 0;

    s->rational = rational;
    IX_TRY(field_of(ctx, f, all[0], at, 1.0, !rational, &s->p));
    for (int a = 0; a < s->ndirs; a++) {
        const ix_spans *sp = &f->dirs[a];
        double h = sp->breaks[at[a] + 1] - sp->breaks[at[a]];

        s->part[a] = h / (sp->breaks[sp->nspans] - sp->breaks[0]);
        IX_TRY(field_of(ctx, &d[a], all[a + 1], at, h, false, &s->d[a]));
        IX_TRY(tangent_of(ctx, &s->d[a], &s->t[a]));
        for (int b = 0; b < 2; b++)
            IX_TRY(
                weights_of(ctx, s->p.deg[b], s->t[a].deg[b], &s->weight[a][b]));
    }
    for (int a = -1; a < s->ndirs; a++) {
        const ix__tri_field *g = a < 0 ? &s->p : &s->d[a];
        size_t size = coefficients(g->deg) * (size_t)g->rows;

        n = size > n ? size : n;
    }
    for (int a = 0; a < s->ndirs; a++) {
        const int deg[2] = {s->p.deg[0] + s->t[a].deg[0],
                            s->p.deg[1] + s->t[a].deg[1]};
        size_t size = coefficients(deg);

        most = size > most ? size : most;
    }
    for (int a = 0; a < 8; a++)
        IX_SCRATCH(ctx, s->room[a], n);
    IX_SCRATCH(ctx, s->product, most + 1);
    IX_SCRATCH(ctx, s->last, 4);
    for (int a = 0; a < 4; a++)
        s->last[a] = HUGE_VAL; /* no box */
    return IX_OK;
}

static ix_status spans_of(ix_ctx *ctx, int which, const ix_form *f,
                          bool rational, ix__tri_object *o)
{
    const double *all[3] = {NULL};
    int n[2] = {f->dirs[0].nspans, f->ndirs > 1 ? f->dirs[1].nspans : 1};
    ix_form d[2];

    IX_TRY(ix__form_bernstein(ctx, f, &all[0]));
    for (int a = 0; a < o->ndirs; a++) {
        double size;

        IX_TRY(derivative(ctx, f, rational, a, &d[a]));
        IX_TRY(ix__form_bound(ctx, &d[a], &size));
        if (!(size > 0.0))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "operand %d does not change in direction %d: give a "
                           "point or a curve instead",
                           which, a + 1);
        IX_TRY(ix__form_bernstein(ctx, &d[a], &all[a + 1]));
    }
    o->nspans = n[0] * n[1];
    IX_SCRATCH_ZERO(ctx, o->span, o->nspans);
    for (int i = 0; i < o->nspans; i++) {
        const int at[2] = {i % n[0], i / n[0]};

        o->span[i].ndirs = o->ndirs;
        IX_TRY(span_of(ctx, f, d, all, rational, at, &o->span[i]));
    }
    return IX_OK;
}

ix_status ix__tri_object_of(ix_ctx *ctx, int which, const ix_mv *m,
                            ix__tri_object *out)
{
    const ix_mv *list[1];
    ix_status st;
    ix_mv *own;
    ix_form f;

    *out = (ix__tri_object){.ndirs = ix__is_point(m) ? 0 : m->ndirs};
    IX_TRY(ix_mv_coerce(ctx, m, 3, m->rational, &own));
    list[0] = own;
    st = ix__forms_load(ctx, 1, list, NULL, &f);
    ix_mv_unref(ctx, own);
    IX_TRY(st);
    return spans_of(ctx, which, &f, m->rational, out);
}

/* --- values -----------------------------------------------------------------
 */

/* Bernstein polynomials of degree d at u and their derivatives. */
static void basis(int d, double u, double *b, double *db)
{
    b[0] = 1.0;
    db[0] = 0.0;
    for (int k = 1; k <= d; k++) {
        double left = 0.0;

        /* from degree k - 1; the last time the derivatives too */
        for (int i = 0; i <= k; i++) {
            double here = i < k ? b[i] : 0.0;

            if (k == d)
                db[i] = d * (left - here);
            b[i] = (1.0 - u) * here + u * left;
            left = here;
        }
    }
}

enum { POW = IX_MAX_ORDER };

/* Bernstein polynomials at one place, for the degree last asked for. */
typedef struct {
    double u, b[POW], db[POW];
    int degree;
} table;

static void prepare(table *t, int degree)
{
    if (t->degree == degree)
        return;
    basis(degree, t->u, t->b, t->db);
    t->degree = degree;
}

/* Value and partial derivatives, double[3][rows]. */
static void field_at(const ix__tri_field *f, table *t, double out[3][4])
{
    const double *c = f->c;

    prepare(&t[0], f->deg[0]);
    prepare(&t[1], f->deg[1]);
    memset(out, 0, 12 * sizeof(double));
    for (int k = 0; k <= f->deg[1]; k++) {
        double v[4] = {0}, d[4] = {0};

        for (int i = 0; i <= f->deg[0]; i++, c += f->rows)
            for (int r = 0; r < f->rows; r++) {
                v[r] += t[0].b[i] * c[r];
                d[r] += t[0].db[i] * c[r];
            }
        for (int r = 0; r < f->rows; r++) {
            out[0][r] += t[1].b[k] * v[r];
            out[1][r] += t[1].b[k] * d[r];
            out[2][r] += t[1].db[k] * v[r];
        }
    }
}

void ix__tri_jet_at(const ix__tri_span *s, const double *u, ix__tri_jet *out)
{
    double h[3][4], w;
    table t[2];

    for (int a = 0; a < 2; a++) {
        t[a].u = a < s->ndirs ? u[a] : 0.0;
        t[a].degree = -1;
    }
    field_at(&s->p, t, h);
    w = out->w = h[0][0];
    for (int k = 0; k < 3; k++)
        out->x[k] = h[0][k + 1] / w;
    for (int a = 0; a < s->ndirs; a++) {
        bool same = s->d[a].c == s->t[a].c;

        field_at(&s->t[a], t, h);
        for (int k = 0; k < 3; k++) {
            out->t[a][k] = h[0][k];
            out->e[a][0][k] = h[1][k];
            out->e[a][1][k] = h[2][k];
        }
        if (!same)
            field_at(&s->d[a], t, h);
        for (int k = 0; k < 3; k++)
            out->d[a][k] = h[0][k] / (w * w);
    }
}

/* --- bounds -----------------------------------------------------------------
 */

/* The field over the box as if it were [0, 1]^2. */
static ix__tri_field restricted(const ix__tri_field *f, int ndirs,
                                const double *lo, const double *hi,
                                double *const room[2])
{
    ix__tri_field g = *f;
    size_t inner = ((size_t)f->deg[0] + 1) * (size_t)f->rows;
    const double *from = f->c;

    if (ndirs > 1) {
        ix__bern_restrict(f->deg[1], lo[1], hi[1], inner, from, room[0]);
        from = room[0];
    }
    for (int k = 0; k <= f->deg[1] && ndirs > 0; k++)
        ix__bern_restrict(f->deg[0], lo[0], hi[0], (size_t)f->rows,
                          from + (size_t)k * inner,
                          room[1] + (size_t)k * inner);
    g.c = ndirs > 0 ? room[1] : f->c;
    return g;
}

typedef struct {
    double lo[3], hi[3];
} range3;

static const range3 nothing = {{HUGE_VAL, HUGE_VAL, HUGE_VAL},
                               {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};

static void widen(range3 *r, const double *x, double factor, const double *less)
{
    for (int k = 0; k < 3; k++) {
        double v = factor * (less ? x[k] - less[k] : x[k]);

        r->lo[k] = v < r->lo[k] ? v : r->lo[k];
        r->hi[k] = v > r->hi[k] ? v : r->hi[k];
    }
}

static void halves(const range3 *r, double mid[3], double half[3])
{
    for (int k = 0; k < 3; k++) {
        mid[k] = 0.5 * (r->lo[k] + r->hi[k]);
        half[k] = 0.5 * (r->hi[k] - r->lo[k]);
    }
}

/* Of x / w for w of one sign; that of w^2 in w2. */
static bool point_range(const ix__tri_field *g, range3 *x, double w2[2])
{
    int n = (g->deg[0] + 1) * (g->deg[1] + 1);
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    *x = nothing;
    for (int i = 0; i < n; i++) {
        const double *c = g->c + 4 * i;

        lo = fmin(lo, c[0]);
        hi = fmax(hi, c[0]);
        widen(x, c + 1, 1.0 / c[0], NULL);
    }
    w2[0] = fmin(lo * lo, hi * hi);
    w2[1] = fmax(lo * lo, hi * hi);
    return lo > 0.0 || hi < 0.0;
}

static range3 value_range(const ix__tri_field *g)
{
    range3 r = nothing;
    int n = (g->deg[0] + 1) * (g->deg[1] + 1);

    for (int i = 0; i < n; i++)
        widen(&r, g->c + 3 * i, 1.0, NULL);
    return r;
}

/* Of the derivative in parameter b, whose box has the given width. */
static range3 slope_range(const ix__tri_field *g, int b, double width)
{
    range3 r = nothing;
    int n0 = g->deg[0] + 1, n1 = g->deg[1] + 1, step = b == 0 ? 1 : n0;

    if (g->deg[b] == 0)
        return (range3){{0}, {0}};
    for (int k = 0; k < n1 - (b == 1); k++)
        for (int i = 0; i < n0 - (b == 0); i++) {
            const double *c = g->c + 3 * (k * n0 + i);

            widen(&r, c + 3 * step, g->deg[b] / width, c);
        }
    return r;
}

static void over_weight(range3 *r, const double w2[2])
{
    for (int k = 0; k < 3; k++) {
        r->lo[k] /= r->lo[k] < 0.0 ? w2[0] : w2[1];
        r->hi[k] /= r->hi[k] > 0.0 ? w2[0] : w2[1];
    }
}

/* Point and tangents over a box, kept for another look at the same one. */
static void fields_over(const ix__tri_span *s, const double *lo,
                        const double *hi, ix__tri_field *p, ix__tri_field t[2])
{
    double *last = s->last;
    bool same = s->ndirs > 0;

    for (int a = 0; a < s->ndirs; a++) {
        same = same && last[2 * a] == lo[a] && last[2 * a + 1] == hi[a];
        last[2 * a] = lo[a];
        last[2 * a + 1] = hi[a];
    }
    for (int a = -1; a < s->ndirs; a++) {
        const ix__tri_field *f = a < 0 ? &s->p : &s->t[a];
        ix__tri_field *to = a < 0 ? p : &t[a];
        double *const *room = s->room + 2 * (a + 1);

        *to = *f;
        to->c = room[1];
        if (!same)
            *to = restricted(f, s->ndirs, lo, hi, room);
    }
}

bool ix__tri_bounds(const ix__tri_span *s, const double *lo, const double *hi,
                    ix__tri_jet *mid, ix__tri_jet *half)
{
    ix__tri_field g, t[2];
    double w2[2];
    range3 r;

    fields_over(s, lo, hi, &g, t);
    if (!point_range(&g, &r, w2))
        return false;
    halves(&r, mid->x, half->x);
    for (int a = 0; a < s->ndirs; a++) {
        g = t[a];
        r = value_range(&g);
        halves(&r, mid->t[a], half->t[a]);
        for (int b = 0; b < s->ndirs; b++) {
            r = slope_range(&g, b, hi[b] - lo[b]);
            halves(&r, mid->e[a][b], half->e[a][b]);
        }
        if (s->d[a].c != s->t[a].c)
            g = restricted(&s->d[a], s->ndirs, lo, hi, s->room + 6);
        r = value_range(&g);
        over_weight(&r, w2);
        halves(&r, mid->d[a], half->d[a]);
    }
    return true;
}

/* The Bernstein coefficients of (c w - S).T in both parameters. */
static void multiply(const ix__tri_field *p, const ix__tri_field *t,
                     const double *const weight[2], const double c[3],
                     double *out)
{
    int n0 = p->deg[0] + t->deg[0] + 1, n1 = p->deg[1] + t->deg[1] + 1;
    int rows = t->deg[1] + 1, row = t->deg[0] + 1;

    memset(out, 0, (size_t)(n0 * n1) * sizeof *out);
    for (int k = 0; k <= p->deg[1]; k++)
        for (int i = 0; i <= p->deg[0]; i++) {
            const double *a = p->c + 4 * (k * (p->deg[0] + 1) + i), *b = t->c;
            const double *w0 = weight[0] + i * row, *w1 = weight[1] + k * rows;
            double r[3];

            for (int x = 0; x < 3; x++)
                r[x] = c[x] * a[0] - a[x + 1];
            for (int l = 0; l < rows; l++) {
                double *to = out + (k + l) * n0 + i;

                for (int j = 0; j < row; j++, b += 3)
                    to[j] += w0[j] * w1[l] *
                             (r[0] * b[0] + r[1] * b[1] + r[2] * b[2]);
            }
        }
}

/* Range of the derivative of a polynomial double[n1][n0] in direction b. */
static void derivative_range(const double *x, const int n[2], int b,
                             double width, double *mid, double *half)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL, f = (n[b] - 1) / width;
    int step = b == 0 ? 1 : n[0];

    for (int k = 0; k < n[1] - (b == 1); k++)
        for (int i = 0; i < n[0] - (b == 0); i++) {
            double v = f * (x[k * n[0] + i + step] - x[k * n[0] + i]);

            lo = v < lo ? v : lo;
            hi = v > hi ? v : hi;
        }
    *mid = n[b] > 1 ? 0.5 * (lo + hi) : 0.0;
    *half = n[b] > 1 ? 0.5 * (hi - lo) : 0.0;
}

void ix__tri_turning(const ix__tri_span *s, const double *lo, const double *hi,
                     const double c[3], ix__tri_turn *out)
{
    int np = (s->p.deg[0] + 1) * (s->p.deg[1] + 1);
    ix__tri_field p, tangent[2];
    double w0 = HUGE_VAL, w1 = -HUGE_VAL;

    fields_over(s, lo, hi, &p, tangent);
    for (int i = 0; i < np; i++) {
        w0 = fmin(w0, p.c[4 * i]);
        w1 = fmax(w1, p.c[4 * i]);
    }
    out->w = 0.5 * (w0 + w1);
    out->hw = 0.5 * (w1 - w0);
    for (int a = 0; a < s->ndirs; a++) {
        ix__tri_field t = tangent[a];
        const int n[2] = {p.deg[0] + t.deg[0] + 1, p.deg[1] + t.deg[1] + 1};

        multiply(&p, &t, s->weight[a], c, s->product);
        for (int b = 0; b < s->ndirs; b++)
            derivative_range(s->product, n, b, hi[b] - lo[b], &out->g[a][b],
                             &out->h[a][b]);
    }
}
