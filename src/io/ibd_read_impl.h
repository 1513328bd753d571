/* ibd_read_impl.h - what the parts of the binary reader share. No count is
 * believed: memory grows with the bytes that have come. */
#ifndef IO_IBD_READ_IMPL_H
#define IO_IBD_READ_IMPL_H

#include "io/ibd.h"

typedef struct {
    ix_ctx *ctx;
    const char *name; /* for messages */
    ix__fill_fn fill;
    void *arg;
    size_t at; /* bytes read so far */
    bool swapped;
    int depth;
    bool pushed; /* type of a sync word that was looked at */
    int type;
} ix__ibdr;

/* The largest block, that of an object. */
typedef struct {
    unsigned char b[IX_IBD_OBJECT];
    bool swapped;
} ix__block;

/* IX_EPARSE, "name: byte N: " and the text. */
ix_status ix__ibdr_fail(ix__ibdr *r, const char *fmt, ...) IX_PRINTF(2, 3);
ix_status ix__ibdr_bytes(ix__ibdr *r, void *to, size_t n) IX_MUST_CHECK;
ix_status ix__ibdr_skip(ix__ibdr *r, size_t n) IX_MUST_CHECK;
/* The type of the next record; peek leaves it. */
ix_status ix__ibdr_sync(ix__ibdr *r, int *type) IX_MUST_CHECK;
ix_status ix__ibdr_peek(ix__ibdr *r, int *type) IX_MUST_CHECK;
ix_status ix__ibdr_expect(ix__ibdr *r, int type) IX_MUST_CHECK;
/* IX_OK with *more false at an END, true behind a sync word of that type. */
ix_status ix__ibdr_next(ix__ibdr *r, int type, bool *more) IX_MUST_CHECK;
ix_status ix__ibdr_block(ix__ibdr *r, ix__block *k, size_t n) IX_MUST_CHECK;
int ix__block_int(const ix__block *k, size_t at);
double ix__block_num(const ix__block *k, size_t at);
long long ix__block_long(const ix__block *k, size_t at);
bool ix__block_ptr(const ix__block *k, size_t at);
/* n finite numbers. */
ix_status ix__ibdr_nums(ix__ibdr *r, size_t n, double *v) IX_MUST_CHECK;
/* The same into scratch, which grows as they come; n may be any number. */
ix_status ix__ibdr_array(ix__ibdr *r, double n, double **out) IX_MUST_CHECK;
/* "int Len, bytes" as a text in scratch; a record of it with its sync word. */
ix_status ix__ibdr_text(ix__ibdr *r, char **s) IX_MUST_CHECK;
ix_status ix__ibdr_string(ix__ibdr *r, char **s) IX_MUST_CHECK;
/* Attribute records up to their END, in the order of writing. */
ix_status ix__ibdr_attrs(ix__ibdr *r, ix_attr **attrs) IX_MUST_CHECK;
/* The object behind its sync word; a new reference. */
ix_status ix__ibdr_object(ix__ibdr *r, int type, ix_obj **out) IX_MUST_CHECK;

/* Payloads. Each reads a sequence of records up to its END into an object. */
ix_status ix__ibdr_polys(ix__ibdr *r, ix_poly_kind kind,
                         ix_obj **out) IX_MUST_CHECK;
ix_status ix__ibdr_mvs(ix__ibdr *r, ix_obj_type type,
                       ix_obj **out) IX_MUST_CHECK;
ix_status ix__ibdr_trimsrfs(ix__ibdr *r, ix_obj **out) IX_MUST_CHECK;
ix_status ix__ibdr_trisrfs(ix__ibdr *r, ix_obj **out) IX_MUST_CHECK;
ix_status ix__ibdr_models(ix__ibdr *r, ix_obj **out) IX_MUST_CHECK;

/* What a sequence of records has given so far, in scratch. */
typedef struct {
    int n, cap;
    const void **item; /* references */
} ix__ibdr_refs;
ix_status ix__ibdr_mv_seq(ix__ibdr *r, ix_obj_type type,
                          ix__ibdr_refs *refs) IX_MUST_CHECK;
/* The references move into an object, or are released when st is a failure. */
ix_status ix__ibdr_seq(ix__ibdr *r, ix_obj_type type, ix__ibdr_refs *refs,
                       ix_status st, ix_obj **out) IX_MUST_CHECK;

#endif
