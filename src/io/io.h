/* io.h - files: text geometry (itd), gzip, atomic saving; the suffix decides.
 *
 * A reader holds a window of the (inflated) input and never recurses deeper
 * than IX_MAX_DEPTH; its messages read "file:line:col: what". */
#ifndef IO_IO_H
#define IO_IO_H

#include "object/object.h"

#define IX_MAX_DEPTH 256

/* Neither read nor written: text of more bytes. */
#define IX_MAX_TEXT ((size_t)1 << 30)

typedef struct {
    const char *float_format; /* NULL: shortest round-trip numbers; else a
                                 printf-style format such as "%-16.14lg" */
    double tiny; /* with a format: smaller numbers are written 0; 0 stands
                    for ix__itd_tiny(float_format) */
    bool file;   /* true: the text can be read back (strings are escaped, NaN
                    and infinity refused); false: a dump for the eye */
    bool peer;   /* with file: for IRIT's end of a conversation (message.h): no
                    indentation, no names, strings that it accepts; of ".itd"
                    and ".ibd" */
    double tol;  /* of formats that hold polygons: the largest distance from
                    the true shape; 0: 1/1000 of its size */
} ix_write_opts;

/* Where reading stopped with an error, for messages of a caller. */
typedef struct {
    int line, col; /* 1-based; 0 if the error has no place in the text */
} ix_place;

/* Where text comes from, see io/input.h. */
typedef struct ix__input ix__input;

/* --- text ------------------------------------------------------------- */
/* Reads objects. *out is the single object or an unnamed list. Err IX_EPARSE
 * (message "name:line:col: error: ..."), IX_ENOMEM, what the source fails
 * with. */
ix_status ix__itd_read_from(ix__input *s, ix_obj **out) IX_MUST_CHECK;
/* The same from text[n]. fname is for messages only. */
ix_status ix__itd_read(ix_ctx *ctx, const char *fname, const char *text,
                       size_t n, ix_obj **out) IX_MUST_CHECK;
/* Appends o in the layout of spec itd-format 10: whole lines, indented to
 * column. Err IX_EARG float_format is none; IX_EUNABLE lists nested deeper
 * than IX_MAX_DEPTH, or so often shared that the text would exceed
 * IX_MAX_TEXT; IX_EDOMAIN w->file and a number is not finite; IX_ENOMEM. On
 * failure b holds part of the text. */
ix_status ix__itd_write(ix_buf *b, const ix_obj *o, const ix_write_opts *w,
                        int column) IX_MUST_CHECK;
/* Appends one number in the writer's form (14 or so digits, trailing zeros
 * cut, tiny values 0; or shortest). */
void ix__itd_number(ix_buf *b, const ix_write_opts *w, double v);
/* Below this a format writes 0: the least power of ten from 1e-25 to 1e-6
 * that it does not print as zero (spec/itd-format 10.3). 1e-13 for the
 * default "%-16.14lg" itself. */
double ix__itd_tiny(const char *float_format);

/* --- XML (docs/xml.md) ------------------------------------------------- */
/* As ix__itd_read_from, ix__itd_read. */
ix_status ix__xml_read_from(ix__input *s, ix_obj **out) IX_MUST_CHECK;
ix_status ix__xml_read(ix_ctx *ctx, const char *fname, const char *text,
                       size_t n, ix_obj **out) IX_MUST_CHECK;
/* Appends a whole document; numbers are the shortest that read back. Err
 * IX_EUNABLE too deep, too long, a name of more than 32 KiB; IX_EDOMAIN a
 * number is not finite; IX_ENOMEM. On failure b holds part of the text. */
ix_status ix__xml_write(ix_buf *b, const ix_obj *o) IX_MUST_CHECK;
/* Against docs/iritx.rng, which states the grammar, not counts and values. Err
 * IX_EPARSE (message "name:line:col: error: ..."), IX_ENOMEM, what the source
 * fails with. */
ix_status ix__xml_validate(ix__input *s) IX_MUST_CHECK;

/* --- X3D (docs/x3d.md) -------------------------------------------------- */
/* Appends a whole scene. What X3D cannot show is left out, with a note. w (may
 * be NULL): tol only. Err IX_EUNABLE as ix__xml_write, IX_EDOMAIN a number is
 * not finite, IX_ENOMEM. */
ix_status ix__x3d_write(ix_buf *b, const ix_obj *o,
                        const ix_write_opts *w) IX_MUST_CHECK;

/* --- formats that a program adds ---------------------------------------- */
/* Appends o in a format of its own. */
typedef ix_status (*ix__write_fn)(ix_buf *b, const ix_obj *o,
                                  const ix_write_opts *w);
/* SAVE to names with this suffix (static text) calls fn; at most 8, called
 * before any thread is started. */
void ix__save_register(const char *suffix, ix__write_fn fn);

/* --- files ------------------------------------------------------------ */
/* The whole regular file, inflated if it is gzip (told by its first bytes);
 * data is NUL-terminated, freed with ix__buf_free. Caps: 1 GiB, and a ratio
 * of 200 after the first 16 MiB. Checks the gzip trailer. Err IX_EIO,
 * IX_EPARSE, IX_ENOMEM; messages begin with the name. */
ix_status ix__file_read(ix_ctx *ctx, const char *name,
                        ix_buf *out) IX_MUST_CHECK;
/* A file in the making: a temporary one beside name, which stays the caller's.
 * Packed if the name ends in .gz, .Z or .x3dz. Err IX_EIO, IX_ENOMEM. */
typedef struct ix__outfile ix__outfile;
ix_status ix__outfile_open(ix_ctx *ctx, const char *name,
                           ix__outfile **out) IX_MUST_CHECK;
/* Its text goes here; ix__buf_check writes what has come together. */
ix_buf *ix__outfile_text(ix__outfile *f);
/* With st IX_OK the file is synced and renamed onto name, else, or on failure,
 * nothing is left behind. Returns st, or what failed; frees f. */
ix_status ix__outfile_close(ix__outfile *f, ix_status st) IX_MUST_CHECK;
/* All of it at once. */
ix_status ix__file_write(ix_ctx *ctx, const char *name, const char *data,
                         size_t n) IX_MUST_CHECK;

/* Loads by suffix; a name that does not exist is tried with ".itd" added.
 * resolved (may be NULL) receives the name that was read. */
ix_status ix__load(ix_ctx *ctx, const char *name, ix_buf *resolved,
                   ix_obj **out) IX_MUST_CHECK;
/* Does the suffix of that name mean some format, supported or not? */
bool ix__save_knows(const char *name);
/* Saves by suffix; ".itd" is added to any name without a known one. */
ix_status ix__save(ix_ctx *ctx, const char *name, const ix_obj *o,
                   const ix_write_opts *w) IX_MUST_CHECK;

#endif
