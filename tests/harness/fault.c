/* fault.c - failing every allocation in turn. */
#include "harness/fault.h"

#include <stdlib.h>

#include "harness/test.h"

void *ix_fault_alloc(void *ud, void *p, size_t old_size, size_t size)
{
    ix_fault *f = ud;

    (void)old_size;
    if (!size) {
        f->live -= p != NULL;
        free(p);
        return NULL;
    }
    if (f->calls++ == f->fail_at)
        return NULL;
    f->live += p == NULL;
    return realloc(p, size);
}

long ix_fault_run(const ix_fault_case *c)
{
    for (long k = 0;; k++) {
        ix_fault f = {.fail_at = -1};
        ix_ctx *ctx = ix_ctx_new(ix_fault_alloc, &f);
        ix_status st;

        assert_non_null(ctx);
        ix_ctx_set_threads(ctx, 1);
        if (c->setup)
            c->setup(ctx, c->state);
        f.calls = 0;
        f.fail_at = k;
        st = c->run(ctx, c->state);
        f.fail_at = -1;
        assert_true(st == IX_OK || st == IX_ENOMEM);
        if (c->teardown)
            c->teardown(ctx, c->state);
        ix_ctx_free(ctx);
        assert_int_equal(f.live, 0);
        if (st == IX_OK && f.calls <= k)
            return k;
    }
}
