/* write_text.c - the end of a writer's loop: is there memory, has the text
 * become too long, is a number in it that files cannot hold. */
#include "io/write_text.h"

#include <math.h>

ix_status ix__write_check(ix_buf *b, size_t start, bool nonfinite)
{
    IX_TRY(ix__buf_check(b));
    if (nonfinite)
        return IX_FAIL(b->ctx, IX_EDOMAIN,
                       "a number is infinite or not a number; files hold "
                       "finite numbers only");
    if (ix__buf_total(b) - start > IX_MAX_TEXT)
        return IX_FAIL(b->ctx, IX_EUNABLE, "more than %zu bytes of text",
                       IX_MAX_TEXT);
    return ix__poll(b->ctx);
}

void ix__write_num(ix_buf *b, double v, bool *nonfinite)
{
    if (!isfinite(v))
        *nonfinite = true;
    ix__buf_num(b, v);
}
