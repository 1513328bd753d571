/* contact.c - rows of contact, embedded in the space of all parameters. */
#include "ops/contact.h"

#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/lift.h"

/* In dim coordinates over [0, 1] of nvars parameters, its own from start on. */
static ix_status embed(ix_ctx *ctx, const ix_mv *m, int dim, int nvars,
                       int start, ix_mv **out)
{
    ix_mv *cur, *next;
    double dom[2];
    ix_status st;

    IX_TRY(ix_mv_coerce(ctx, m, dim, m->rational, &cur));
    for (int i = 0; i < m->ndirs; i++) {
        ix_mv_domain(cur, i, dom);
        if (dom[0] == 0.0 && dom[1] == 1.0)
            continue;
        st = ix_mv_reparam(ctx, cur, i, 0.0, 1.0, &next);
        ix_mv_unref(ctx, cur);
        IX_TRY(st);
        cur = next;
    }
    if (m->ndirs == nvars) {
        *out = cur;
        return IX_OK;
    }
    st = ix_mv_promote(ctx, cur, nvars, start, out);
    ix_mv_unref(ctx, cur);
    return st;
}

/* L and its first derivatives. */
static ix_status rows_of(ix_ctx *ctx, const ix_form *f, ix_contact *k)
{
    IX_TRY(ix__lift(ctx, f, k->m->rational, &k->row[0]));
    k->nrows = 1;
    for (int i = 0; i < k->m->ndirs; i++) {
        IX_TRY(
            ix__form_derive(ctx, &k->row[0], k->start + i, &k->row[k->nrows]));
        k->nrows++;
    }
    return IX_OK;
}

/* The lift (q, 1, |q|^2), constant. */
static ix_status point_row(ix_ctx *ctx, const ix_contacts *c, const double *q,
                           const ix_form *like, ix_contact *k)
{
    double x[IX_MAX_COORDS + 2], s = 0.0;

    for (int i = 0; i < c->dim; i++) {
        x[i] = ldexp(q[i] - c->frame.shift[i], -c->frame.exp);
        s += x[i] * x[i];
    }
    x[c->dim] = 1.0;
    x[c->dim + 1] = s;
    k->nrows = 1;
    return ix__form_constant(ctx, like, c->dim + 2, x, &k->row[0]);
}

/* On common breaks, in the frame of all. */
static ix_status load(ix_ctx *ctx, ix_contacts *c, int n, const ix_mv *const *m,
                      ix_form *f)
{
    const ix_mv *in[IX__MAX_OBJECTS] = {NULL};
    ix_mv *own[IX__MAX_OBJECTS] = {NULL};
    ix_status st = IX_OK;
    int k = 0;

    for (int i = 0; i < n && st == IX_OK; i++)
        if (m[i]) {
            st = embed(ctx, m[i], c->dim, c->nvars, c->at[i].start, &own[k]);
            in[k] = own[k];
            k++;
        }
    if (st == IX_OK)
        st = ix__frame_of(ctx, k, in, &c->frame);
    if (st == IX_OK)
        st = ix__forms_load(ctx, k, in, &c->frame, f);
    for (int i = 0; i < k; i++)
        ix_mv_unref(ctx, own[i]);
    return st;
}

ix_status ix__contacts_of(ix_ctx *ctx, int n, const ix_mv *const *m,
                          const double *q, int dim, ix_contacts *out)
{
    ix_form f[IX__MAX_OBJECTS];
    int k = 0;

    *out = (ix_contacts){.dim = dim, .n = n};
    for (int i = 0; i < n; i++) {
        out->at[i] = (ix_contact){.m = m[i], .start = out->nvars};
        for (int d = 0; m[i] && d < m[i]->ndirs; d++)
            ix_mv_domain(m[i], d, out->at[i].dom[d]);
        out->nvars += m[i] ? m[i]->ndirs : 0;
    }
    IX_TRY(load(ctx, out, n, m, f));
    for (int i = 0; i < n; i++)
        if (m[i])
            IX_TRY(rows_of(ctx, &f[k++], &out->at[i]));
        else
            IX_TRY(point_row(ctx, out, q + (size_t)i * (size_t)dim, &f[0],
                             &out->at[i]));
    return IX_OK;
}

/* --- determinants ------------------------------------------------------------
 */

/* The degrees that are left, see contact.h. */
static void degrees_of(const ix_contacts *c, const ix_contact_row *rows, int n,
                       int *degrees)
{
    for (int i = 0; i < c->n; i++) {
        const ix_contact *k = &c->at[i];
        int count = 0, derived[2] = {0, 0}, whole = 1;

        for (int r = 0; r < n; r++) {
            if (rows[r].object != i)
                continue;
            count++;
            if (rows[r].row > 0)
                derived[rows[r].row - 1] = 1;
            else
                whole = 2; /* a leading term cancels beside L */
        }
        for (int d = 0; k->m && d < k->m->ndirs; d++) {
            int q = k->m->dirs[d].order - 1;

            degrees[k->start + d] = k->m->rational
                                        ? 2 * count * q - whole * derived[d]
                                    : count > 0 ? (count + 1) * q - derived[d]
                                                : 0;
        }
    }
}

static void pick(const ix_contacts *c, const ix_contact_row *rows, int n,
                 const ix_form **out)
{
    for (int r = 0; r < n; r++)
        out[r] = &c->at[rows[r].object].row[rows[r].row];
}

ix_status ix__contact_minors(ix_ctx *ctx, const ix_contacts *c,
                             const ix_contact_row *rows, ix_form *out)
{
    const ix_form *list[IX_MAX_COORDS + 2];
    int degrees[IX_MAX_DIRS] = {0};
    ix_form m;

    pick(c, rows, c->dim + 1, list);
    IX_TRY(ix__form_minors(ctx, c->dim + 1, list, &m));
    degrees_of(c, rows, c->dim + 1, degrees);
    return ix__form_lower(ctx, &m, degrees, out);
}

ix_status ix__contact_det(ix_ctx *ctx, const ix_contacts *c,
                          const ix_contact_row *rows, ix_mv **out)
{
    const ix_form *list[IX_MAX_COORDS + 2];
    int degrees[IX_MAX_DIRS] = {0};
    ix_form det, low;

    pick(c, rows, c->dim + 2, list);
    IX_TRY(ix__form_det(ctx, c->dim + 2, list, &det));
    degrees_of(c, rows, c->dim + 2, degrees);
    IX_TRY(ix__form_lower(ctx, &det, degrees, &low));
    return ix__form_store(ctx, &low, false, NULL, out);
}

/* --- points -----------------------------------------------------------------
 */

/* The quotient rule: h double[3][1 + dim] are value and partials. */
static void project(double h[3][4], int ndirs, double foot[3], double d[2][3])
{
    for (int k = 0; k < 3; k++) {
        foot[k] = h[0][k + 1] / h[0][0];
        for (int i = 0; i < ndirs; i++)
            d[i][k] = (h[i + 1][k + 1] - foot[k] * h[i + 1][0]) / h[0][0];
    }
}

ix_status ix__contact_foot(ix_ctx *ctx, const ix_contacts *c, int i,
                           const double *x, double foot[3], double d[2][3],
                           bool *ok)
{
    const ix_contact *k = &c->at[i];
    const ix_mv *m = k->m;
    double t[2] = {0, 0}, h[3][4] = {{0}}, v[IX_MAX_COORDS + 1];

    memset(d, 0, 6 * sizeof(double));
    for (int j = 0; j < m->ndirs; j++) {
        t[j] = k->dom[j][0] + x[k->start + j] * (k->dom[j][1] - k->dom[j][0]);
        t[j] = fmin(fmax(t[j], k->dom[j][0]), k->dom[j][1]);
    }
    for (int j = 0; j <= m->ndirs; j++) {
        int order[2] = {j == 1, j == 2}, r = m->rational;

        IX_TRY(ix_mv_partial(ctx, m, t, order, v));
        h[j][0] = r ? v[0] : j == 0;
        for (int a = 0; a < 3 && a < m->ncoords; a++)
            h[j][a + 1] = a < c->dim ? v[a + r] : 0.0;
    }
    *ok = h[0][0] != 0.0;
    if (*ok)
        project(h, m->ndirs, foot, d);
    return IX_OK;
}

/* r_a x r_b . r_c, in the plane r_a x r_b. */
static double volume(int dim, const double *a, const double *b, const double *c)
{
    double x[3];

    ix__cross3(a, b, x);
    return dim == 2 ? x[2] : ix__dot3(x, c);
}

static void solve(int dim, const double *a, const double *b, const double *c,
                  const double h[3], double vol, double p[3])
{
    double x[3][3];

    if (dim == 2) {
        p[0] = (h[0] * b[1] - h[1] * a[1]) / vol;
        p[1] = (h[1] * a[0] - h[0] * b[0]) / vol;
        p[2] = 0.0;
        return;
    }
    ix__cross3(b, c, x[0]);
    ix__cross3(c, a, x[1]);
    ix__cross3(a, b, x[2]);
    for (int k = 0; k < 3; k++)
        p[k] = (h[0] * x[0][k] + h[1] * x[1][k] + h[2] * x[2][k]) / vol;
}

bool ix__meet_planes(int dim, int n, double (*r)[3], const double *h,
                     double p[3])
{
    double best = 1e-9;
    bool found = false;

    for (int a = 0; a < n; a++)
        for (int b = a + 1; b < n; b++)
            for (int c = dim == 2 ? n - 1 : b + 1; c < n; c++) {
                double vol = volume(dim, r[a], r[b], r[c]);
                const double three[3] = {h[a], h[b], h[c]};

                if (!(fabs(vol) > best))
                    continue;
                best = fabs(vol);
                solve(dim, r[a], r[b], r[c], three, vol, p);
                found = true;
            }
    return found;
}
