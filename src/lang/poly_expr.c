/* poly_expr.c - polynomials written as text. A value in the making is a dense
 * array of coefficients with its own degrees, in scratch memory; the recursion
 * of parentheses is bounded. */
#include "lang/poly_expr.h"

#include <math.h>
#include <string.h>

enum { MAX_DEGREE = 1000, MAX_COEFFS = 1000000, MAX_NESTING = 100 };

typedef struct {
    int deg[IX_MAX_DIRS];
    size_t n; /* coefficients: product of deg + 1, direction 0 fastest */
    double *c;
} poly;

typedef struct {
    ix_ctx *ctx;
    int ndirs;
    const char *text, *at;
    int nesting;
} parser;

/* --- dense polynomials ------------------------------------------------- */

static ix_status poly_new(parser *p, const int *deg, poly *out)
{
    out->n = 1;
    memcpy(out->deg, deg, sizeof out->deg);
    for (int d = 0; d < p->ndirs; d++) {
        if (deg[d] > MAX_DEGREE)
            return IX_FAIL(p->ctx, IX_EARG, "degree %d in %c is above %d",
                           deg[d], 'A' + d, MAX_DEGREE);
        out->n *= (size_t)deg[d] + 1;
        if (out->n > MAX_COEFFS)
            return IX_FAIL(p->ctx, IX_EARG, "more than %d coefficients",
                           MAX_COEFFS);
    }
    IX_SCRATCH_ZERO(p->ctx, out->c, out->n);
    return IX_OK;
}

static ix_status poly_constant(parser *p, double v, poly *out)
{
    const int deg[IX_MAX_DIRS] = {0};

    IX_TRY(poly_new(p, deg, out));
    out->c[0] = v;
    return IX_OK;
}

/* Position in an array with the degrees of big of coefficient i of small. */
static size_t place(const parser *p, const poly *small, size_t i,
                    const poly *big)
{
    size_t at = 0, stride = 1;

    for (int d = 0; d < p->ndirs; d++) {
        size_t len = (size_t)small->deg[d] + 1;

        at += i % len * stride;
        i /= len;
        stride *= (size_t)big->deg[d] + 1;
    }
    return at;
}

/* a += sign b; a keeps its array if its degrees suffice. */
static ix_status poly_add(parser *p, poly *a, const poly *b, double sign)
{
    int deg[IX_MAX_DIRS] = {0};
    bool fits = true;

    for (int d = 0; d < p->ndirs; d++) {
        deg[d] = a->deg[d] > b->deg[d] ? a->deg[d] : b->deg[d];
        fits = fits && deg[d] == a->deg[d];
    }
    if (!fits) {
        poly sum;

        IX_TRY(poly_new(p, deg, &sum));
        for (size_t i = 0; i < a->n; i++)
            sum.c[place(p, a, i, &sum)] = a->c[i];
        *a = sum;
    }
    for (size_t i = 0; i < b->n; i++)
        a->c[place(p, b, i, a)] += sign * b->c[i];
    return IX_OK;
}

/* a *= b; b may be a. */
static ix_status poly_mul(parser *p, poly *a, const poly *b)
{
    int deg[IX_MAX_DIRS] = {0};
    poly prod;

    for (int d = 0; d < p->ndirs; d++)
        deg[d] = a->deg[d] + b->deg[d];
    IX_TRY(poly_new(p, deg, &prod));
    for (size_t i = 0; i < a->n; i++) {
        size_t at = place(p, a, i, &prod);

        IX_TRY(ix__poll(p->ctx));
        for (size_t j = 0; j < b->n && a->c[i] != 0; j++)
            prod.c[at + place(p, b, j, &prod)] += a->c[i] * b->c[j];
    }
    *a = prod;
    return IX_OK;
}

/* By squaring; e >= 0. */
static ix_status poly_pow(parser *p, const poly *a, int e, poly *out)
{
    poly base = *a;

    IX_TRY(poly_constant(p, 1, out));
    for (; e > 0; e >>= 1) {
        if (e & 1)
            IX_TRY(poly_mul(p, out, &base));
        if (e > 1)
            IX_TRY(poly_mul(p, &base, &base));
    }
    return IX_OK;
}

/* --- parsing ----------------------------------------------------------- */

static char peek(parser *p)
{
    while (*p->at == ' ' || *p->at == '\t' || *p->at == '\n')
        p->at++;
    return *p->at;
}

static int column(const parser *p)
{
    return (int)(p->at - p->text) + 1;
}

/* "column 5: a number, a letter or ( is needed, not *". */
static ix_status unexpected(parser *p, const char *wanted)
{
    char c = peek(p);

    if (!c)
        return IX_FAIL(p->ctx, IX_EARG, "column %d: %s is needed at the end",
                       column(p), wanted);
    return IX_FAIL(p->ctx, IX_EARG, "column %d: %s is needed, not \"%c\"",
                   column(p), wanted, c);
}

static ix_status parse_number(parser *p, double *v)
{
    const char *end = ix_num_parse(p->at, p->at + strlen(p->at), v);

    if (!end || !isfinite(*v))
        return unexpected(p, "a finite number");
    p->at = end;
    return IX_OK;
}

static ix_status parse_letter(parser *p, poly *out)
{
    int d = (*p->at & ~0x20) - 'A', deg[IX_MAX_DIRS] = {0};

    if (d >= p->ndirs)
        return IX_FAIL(p->ctx, IX_EARG,
                       "column %d: \"%c\" is beyond the %d direction%s A .. %c",
                       column(p), *p->at, p->ndirs, p->ndirs > 1 ? "s" : "",
                       'A' + p->ndirs - 1);
    p->at++;
    deg[d] = 1;
    IX_TRY(poly_new(p, deg, out));
    out->c[1] = 1;
    return IX_OK;
}

static bool is_letter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

static ix_status parse_sum(parser *p, poly *out);

static ix_status parse_atom(parser *p, poly *out)
{
    char c = peek(p);
    double v;

    if (is_letter(c))
        return parse_letter(p, out);
    if ((c >= '0' && c <= '9') || c == '.') {
        IX_TRY(parse_number(p, &v));
        return poly_constant(p, v, out);
    }
    if (c != '(')
        return unexpected(p, "a number, a letter or \"(\"");
    p->at++;
    if (++p->nesting > MAX_NESTING)
        return IX_FAIL(p->ctx, IX_EARG, "parentheses nested deeper than %d",
                       MAX_NESTING);
    IX_TRY(parse_sum(p, out));
    p->nesting--;
    if (peek(p) != ')')
        return unexpected(p, "\")\"");
    p->at++;
    return IX_OK;
}

static ix_status parse_power(parser *p, poly *out)
{
    poly base;
    double e;

    IX_TRY(parse_atom(p, &base));
    *out = base;
    if (peek(p) != '^')
        return IX_OK;
    p->at++;
    if (peek(p) < '0' || peek(p) > '9')
        return unexpected(p, "a whole number as exponent");
    IX_TRY(parse_number(p, &e));
    if (e != floor(e) || e > MAX_DEGREE)
        return IX_FAIL(p->ctx, IX_EARG,
                       "exponent %g is not a whole number up to %d", e,
                       MAX_DEGREE);
    return poly_pow(p, &base, (int)e, out);
}

static bool constant(const parser *p, const poly *a)
{
    for (int d = 0; d < p->ndirs; d++)
        if (a->deg[d] > 0)
            return false;
    return true;
}

static ix_status divide(parser *p, poly *a, const poly *b)
{
    if (!constant(p, b) || b->c[0] == 0)
        return IX_FAIL(p->ctx, IX_EARG,
                       "column %d: only a constant other than 0 may divide",
                       column(p));
    for (size_t i = 0; i < a->n; i++)
        a->c[i] /= b->c[0];
    return IX_OK;
}

static ix_status parse_term(parser *p, poly *out)
{
    IX_TRY(parse_power(p, out));
    while (peek(p) == '*' || peek(p) == '/') {
        char op = *p->at++;
        poly f;

        IX_TRY(parse_power(p, &f));
        if (op == '/')
            IX_TRY(divide(p, out, &f));
        else
            IX_TRY(poly_mul(p, out, &f));
    }
    return IX_OK;
}

static ix_status parse_sum(parser *p, poly *out)
{
    char sign = peek(p);

    if (sign == '+' || sign == '-')
        p->at++;
    IX_TRY(parse_term(p, out));
    if (sign == '-')
        for (size_t i = 0; i < out->n; i++)
            out->c[i] = -out->c[i];
    while (peek(p) == '+' || peek(p) == '-') {
        char op = *p->at++;
        poly t;

        IX_TRY(parse_term(p, &t));
        IX_TRY(poly_add(p, out, &t, op == '-' ? -1 : 1));
    }
    return IX_OK;
}

/* --- result ------------------------------------------------------------ */

/* True if some coefficient has the full degree in direction d. */
static bool full_degree(const poly *a, int d)
{
    size_t stride = 1, len = (size_t)a->deg[d] + 1;

    for (int e = 0; e < d; e++)
        stride *= (size_t)a->deg[e] + 1;
    for (size_t i = 0; i < a->n; i++)
        if (i / stride % len == len - 1 && a->c[i] != 0)
            return true;
    return false;
}

/* Cancelled leading coefficients ("A^2 - A^2 + B") leave no degree behind. */
static ix_status trim(parser *p, poly *a)
{
    poly t = *a;

    for (int d = 0; d < p->ndirs; d++)
        while (t.deg[d] > 0 && !full_degree(&t, d)) {
            poly old = t;

            old.deg[d]--;
            IX_TRY(poly_new(p, old.deg, &t));
            for (size_t i = 0; i < t.n; i++)
                t.c[i] = a->c[place(p, &t, i, a)];
        }
    *a = t;
    return IX_OK;
}

static ix_status parse_all(parser *p, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];
    poly a;

    IX_TRY(parse_sum(p, &a));
    if (peek(p))
        return unexpected(p, "an operator");
    IX_TRY(trim(p, &a));
    for (int d = 0; d < p->ndirs; d++)
        dirs[d] = (ix_dir){
            .basis = IX_POWER, .order = a.deg[d] + 1, .length = a.deg[d] + 1};
    return ix_mv_new(p->ctx, p->ndirs, dirs, 1, false, a.c, out);
}

ix_status ix__poly_expr(ix_ctx *ctx, int ndirs, const char *text, ix_mv **out)
{
    parser p = {.ctx = ctx, .ndirs = ndirs, .text = text, .at = text};
    *out = NULL;
    IX_RETURN_SCOPED(ctx, parse_all(&p, out));
}
