/* round.h - laws of a file format: what is written reads back the same, for
 * random objects and for the sample files; every allocation may fail. */
#ifndef HARNESS_ROUND_H
#define HARNESS_ROUND_H

#include "harness/test.h"
#include "io/io.h"

typedef struct {
    ix_status (*write)(ix_buf *b, const ix_obj *o);
    ix_status (*read)(ix_ctx *ctx, const char *fname, const char *text,
                      size_t n, ix_obj **out);
} ix_codec;

/* Names and attributes survive, too. */
void ix_round_check(const ix_codec *codec, ix_ctx *ctx, const ix_obj *o);
void ix_round_random(const ix_codec *codec);
/* All types, so that none depends on the luck of the random ones. */
void ix_round_each_type(const ix_codec *codec);
void ix_round_samples(const ix_codec *codec);
void ix_round_faults(const ix_codec *codec);

#endif
