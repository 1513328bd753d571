/* vecs.c - vectors of functions. */
#include "geom/vecs.h"

const ix_mv *ix__sum0(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return !a ? b : !b ? a : ix__pool_add(q, a, b);
}

const ix_mv *ix__diff0(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    if (!b)
        return a;
    return a ? ix__pool_sub(q, a, b) : ix__pool_scale(q, b, -1);
}

const ix_mv *ix__prod0(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return a && b ? ix__pool_mul(q, a, b) : NULL;
}

ix__vec ix__vec_of(ix_pool *q, const ix_mv *m)
{
    ix__vec v = {{NULL}, NULL};

    for (int k = 0; k < m->ncoords && k < 3; k++)
        v.x[k] = ix__pool_axis(q, m, k + m->rational);
    if (m->rational)
        v.w = ix__pool_axis(q, m, 0);
    return v;
}

ix__vec ix__vec_tangent(ix_pool *q, ix__vec a, int dir)
{
    ix__vec t = {{NULL}, NULL};

    for (int k = 0; k < 3; k++) {
        if (!a.x[k])
            continue;
        t.x[k] = a.w ? ix__pool_wronskian(q, a.x[k], a.w, dir)
                     : ix__pool_derive(q, a.x[k], dir);
    }
    return t;
}

ix__vec ix__vec_promote(ix_pool *q, ix__vec a, int n, int start)
{
    ix__vec v = {{NULL}, NULL};

    for (int k = 0; k < 3; k++)
        if (a.x[k])
            v.x[k] = ix__pool_promote(q, a.x[k], n, start);
    if (a.w)
        v.w = ix__pool_promote(q, a.w, n, start);
    return v;
}

ix__vec ix__vec_add(ix_pool *q, ix__vec a, ix__vec b)
{
    ix__vec v = {{NULL}, NULL};

    for (int k = 0; k < 3; k++)
        v.x[k] = ix__sum0(q, a.x[k], b.x[k]);
    return v;
}

ix__vec ix__vec_sub(ix_pool *q, ix__vec a, ix__vec b)
{
    ix__vec v = {{NULL}, NULL};

    for (int k = 0; k < 3; k++)
        v.x[k] = ix__diff0(q, a.x[k], b.x[k]);
    return v;
}

ix__vec ix__vec_times(ix_pool *q, ix__vec a, const ix_mv *s)
{
    if (s)
        for (int k = 0; k < 3; k++)
            a.x[k] = ix__prod0(q, a.x[k], s);
    return a;
}

/* a_i b_j - a_j b_i */
static const ix_mv *minor(ix_pool *q, ix__vec a, ix__vec b, int i, int j)
{
    return ix__diff0(q, ix__prod0(q, a.x[i], b.x[j]),
                     ix__prod0(q, a.x[j], b.x[i]));
}

ix__vec ix__vec_cross(ix_pool *q, ix__vec a, ix__vec b)
{
    ix__vec v = {{NULL}, NULL};

    for (int k = 0; k < 3; k++)
        v.x[k] = minor(q, a, b, (k + 1) % 3, (k + 2) % 3);
    return v;
}

const ix_mv *ix__vec_cross2(ix_pool *q, ix__vec a, ix__vec b)
{
    return minor(q, a, b, 0, 1);
}

const ix_mv *ix__vec_dot(ix_pool *q, ix__vec a, ix__vec b)
{
    const ix_mv *s = NULL;

    for (int k = 0; k < 3; k++)
        s = ix__sum0(q, s, ix__prod0(q, a.x[k], b.x[k]));
    return s;
}

ix__vec ix__vec_between(ix_pool *q, ix__vec a, ix__vec b)
{
    return ix__vec_sub(q, ix__vec_times(q, a, b.w), ix__vec_times(q, b, a.w));
}

const ix_mv *ix__vec_dot_const(ix_pool *q, ix__vec a, const double v[3])
{
    const ix_mv *s = NULL;

    for (int k = 0; k < 3; k++)
        if (a.x[k] && (v[k] < 0 || v[k] > 0))
            s = ix__sum0(q, s, ix__pool_scale(q, a.x[k], v[k]));
    return s;
}
