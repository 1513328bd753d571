/* multires.c - curves as sums over nested spline spaces.
 *
 * The space of the curve's knots contains that with every second interior knot
 * removed, and so on down to polynomials; the curve minus its least squares
 * approximation in the next coarser space is the detail of a level (Elber and
 * Gotsman 1995). Removing one knot at a time instead, every detail has one
 * degree of freedom: a multiple of the B-wavelet of that knot, the spline that
 * is orthogonal to all splines without the knot (Kazinnik and Elber 1997). */
#include <math.h>
#include <string.h>

#include "geom/crvs.h"
#include "geom/parts.h"
#include "geom/project.h"

/* The direction without the knots that drop marks; knots in scratch. */
static ix_status without(ix_ctx *ctx, const ix_dir *fine, const bool *drop,
                         ix_dir *out)
{
    int n = ix_knots_count(fine), m = 0;
    double *knots;

    IX_SCRATCH(ctx, knots, n);
    for (int i = 0; i < n; i++)
        if (!drop[i])
            knots[m++] = fine->knots[i];
    *out = *fine;
    out->length = m - fine->order;
    out->knots = knots;
    return IX_OK;
}

/* May interior knot i be removed? keep: not if that closes a jump. */
static bool removable(const ix_dir *d, int i, bool keep)
{
    int mult = 0;

    for (int j = d->order; j < d->length; j++)
        mult += d->knots[j] == d->knots[i];
    return !keep || mult < d->order;
}

/* Marks what one step removes: every second removable knot, or (single) the
 * first of these only. Returns how many. */
static int mark(const ix_dir *d, bool keep, bool single, bool *drop)
{
    int seen = 0, n = 0;

    memset(drop, 0, (size_t)ix_knots_count(d) * sizeof *drop);
    for (int i = d->order; i < d->length; i++)
        if (removable(d, i, keep) && seen++ % 2 == 0 && !(single && n)) {
            drop[i] = true;
            n++;
        }
    return n;
}

/* Least squares of the curve in a space, as a curve. */
static ix_status project(ix_ctx *ctx, const ix_mv *crv, const ix_dir *dir,
                         ix_mv **out)
{
    ix_path p;
    double *coef;

    IX_SCRATCH(ctx, coef, (size_t)crv->ncoords * (size_t)dir->length);
    IX_TRY(ix__path_new(ctx, crv, &p));
    IX_TRY(ix__project(ctx, &p, dir, (ix_project_opts){0}, coef));
    return ix_mv_new(ctx, 1, dir, crv->ncoords, false, coef, out);
}

/* a - b on the knots of a, which are those of b and the dropped ones. */
static ix_status minus(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                       const bool *drop, ix_mv **out)
{
    const ix_dir *d = &a->dirs[0];
    double *add;
    int n = 0;
    ix_mv *fine;
    ix_status st;

    IX_SCRATCH(ctx, add, d->length);
    for (int i = d->order; i < d->length; i++)
        if (drop[i])
            add[n++] = d->knots[i];
    IX_TRY(ix_mv_insert_knots(ctx, b, 0, n, add, &fine));
    st = ix__mv_alloc(ctx, 1, d, a->ncoords, false, out);
    for (size_t i = 0; st == IX_OK && i < a->npts * (size_t)a->naxes; i++)
        (*out)->pts[i] = a->pts[i] - fine->pts[i];
    ix_mv_unref(ctx, fine);
    return st;
}

/* One step: coarse is the best approximation without the dropped knots, detail
 * what it lacks. */
static ix_status split(ix_ctx *ctx, const ix_mv *fine, const bool *drop,
                       ix_mv **coarse, ix_mv **detail)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_dir dir;
    ix_status st = without(ctx, &fine->dirs[0], drop, &dir);

    *coarse = *detail = NULL;
    if (st == IX_OK)
        st = project(ctx, fine, &dir, coarse);
    if (st == IX_OK)
        st = minus(ctx, fine, *coarse, drop, detail);
    if (st != IX_OK) {
        ix_mv_unref(ctx, *coarse);
        *coarse = NULL;
    }
    ix__scratch_release(ctx, mk);
    return st;
}

/* How many steps it takes until nothing is left to remove. */
static ix_status count_steps(ix_ctx *ctx, const ix_mv *open, bool keep,
                             bool single, bool *drop, int *steps)
{
    ix_dir dir = open->dirs[0];

    for (*steps = 0; mark(&dir, keep, single, drop); (*steps)++)
        IX_TRY(without(ctx, &dir, drop, &dir));
    return IX_OK;
}

static ix_status decompose(ix_ctx *ctx, const ix_mv *open, ix_multires how,
                           ix_crvs *out)
{
    bool single = how.wavelets, *drop;
    ix_mv *coarse;
    int n;

    IX_SCRATCH(ctx, drop, ix_knots_count(&open->dirs[0]));
    IX_TRY(count_steps(ctx, open, how.keep_jumps, single, drop, &n));
    if (n > 4096) /* all together n^2 control points */
        return IX_FAIL(ctx, IX_EUNABLE, "%d wavelets: more than 4096", n);
    IX_TRY(ix__crvs_new(ctx, n + 1, out));
    for (int i = 0; i <= n; i++)
        ix_mv_domain(open, 0, out->t + 2 * i);
    out->crv[0] = ix_mv_ref(open);
    for (int i = n; i > 0; i--) { /* crv[0] is what is still to be split */
        IX_TRY(ix__poll(ctx));
        (void)mark(&out->crv[0]->dirs[0], how.keep_jumps, single, drop);
        coarse = NULL;
        IX_TRY(split(ctx, out->crv[0], drop, &coarse, &out->crv[i]));
        ix_mv_unref(ctx, out->crv[0]);
        out->crv[0] = coarse;
    }
    return IX_OK;
}

static ix_status check(ix_ctx *ctx, const ix_mv *crv)
{
    if (ix_mv_ndirs(crv) != 1)
        return IX_FAIL(ctx, IX_EARG, "not a curve: %d directions",
                       ix_mv_ndirs(crv));
    if (ix_mv_rational(crv))
        return IX_FAIL(ctx, IX_EARG,
                       "rational curves are no sums of splines: make it "
                       "polynomial first");
    return IX_OK;
}

/* Power, Bezier, periodic and float curves as open B-splines. */
static ix_status to_open(ix_ctx *ctx, const ix_mv *crv, ix_mv **out)
{
    ix_mv *bsp = NULL;
    ix_status st = ix_mv_to_bspline(ctx, crv, &bsp);

    if (st == IX_OK)
        st = ix_mv_to_open(ctx, bsp, out);
    ix_mv_unref(ctx, bsp);
    return st;
}

ix_status ix_multires_split(ix_ctx *ctx, const ix_mv *crv, ix_multires how,
                            ix_crvs *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *open = NULL;
    ix_status st;

    *out = (ix_crvs){0};
    IX_TRY(check(ctx, crv));
    st = to_open(ctx, crv, &open);
    if (st == IX_OK)
        st = decompose(ctx, open, how, out);
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    ix_mv_unref(ctx, open);
    ix__scratch_release(ctx, mk);
    return st;
}

/* --- one wavelet
 * --------------------------------------------------------------
 */

/* The part of basis function i that is orthogonal to the space without the
 * knot. */
static ix_status residue(ix_ctx *ctx, const ix_dir *dir, int i,
                         const bool *drop, ix_mv **out)
{
    double *coef;
    ix_mv *f, *coarse;
    ix_status st;

    IX_SCRATCH_ZERO(ctx, coef, dir->length);
    coef[i] = 1;
    IX_TRY(ix_mv_new(ctx, 1, dir, 1, false, coef, &f));
    st = split(ctx, f, drop, &coarse, out);
    ix_mv_unref(ctx, coarse);
    ix_mv_unref(ctx, f);
    return st;
}

static double largest(const ix_mv *m)
{
    double top = 0;

    for (size_t i = 0; i < m->npts; i++)
        if (fabs(m->pts[i]) > fabs(top))
            top = m->pts[i];
    return top;
}

/* All functions that have the knot leave the same wavelet, up to a factor; the
 * largest residue has it most exactly. */
static ix_status wavelet(ix_ctx *ctx, const ix_mv *open, int knot, ix_mv **out)
{
    const ix_dir *dir = &open->dirs[0];
    ix_mv *best = NULL;
    double top;
    bool *drop;

    if (knot < dir->order || knot >= dir->length)
        return IX_FAIL(ctx, IX_EARG, "knot %d is not an inner one: %d .. %d",
                       knot, dir->order, dir->length - 1);
    IX_SCRATCH_ZERO(ctx, drop, ix_knots_count(dir));
    drop[knot] = true;
    for (int i = knot - dir->order; i <= knot; i++) {
        ix_mv *f = NULL;
        ix_status st = i >= 0 && i < dir->length
                           ? residue(ctx, dir, i, drop, &f)
                           : IX_OK;

        if (st == IX_OK && f &&
            (!best || fabs(largest(f)) > fabs(largest(best)))) {
            ix_mv *t = best;

            best = f;
            f = t;
        }
        ix_mv_unref(ctx, f);
        if (st != IX_OK) {
            ix_mv_unref(ctx, best);
            return st;
        }
    }
    if (!best)
        return IX_FAIL(ctx, IX_EUNABLE, "knot %d has no wavelet", knot);
    top = largest(best);
    for (size_t i = 0; i < best->npts; i++)
        best->pts[i] /= top;
    *out = best;
    return IX_OK;
}

ix_status ix_multires_wavelet(ix_ctx *ctx, const ix_mv *crv, int knot,
                              ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *open = NULL;
    ix_status st;

    *out = NULL;
    IX_TRY(check(ctx, crv));
    st = to_open(ctx, crv, &open);
    if (st == IX_OK)
        st = wavelet(ctx, open, knot, out);
    ix_mv_unref(ctx, open);
    ix__scratch_release(ctx, mk);
    return st;
}
