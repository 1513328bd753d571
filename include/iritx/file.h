/* file.h - objects from and to files; the suffix decides the format. */
#ifndef IRITX_FILE_H
#define IRITX_FILE_H

#include "iritx/object.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Loads a file: .itd, .ibd, .xml, each also with .gz behind it; a name that
 * does not exist is tried with ".itd" added. *out: the file's object, or an
 * unnamed list of several; a new reference. Err IX_EIO; IX_EPARSE ("a.itd:3:14:
 * error: ..."); IX_EARG a format that is not read; IX_ENOMEM. */
ix_status ix_load(ix_ctx *ctx, const char *name, ix_obj **out) IX_MUST_CHECK;

/* Saves o to a file, complete or not at all: .itd, .ibd, .xml, .x3d, .stl,
 * .obj, .step (docs/exports.md), .gz behind them; ".itd" is added to a name
 * without a known suffix. tol: of formats that hold polygons, the largest
 * distance from the true shape; 0: 1/1000 of its size. Numbers are exact. Err
 * IX_EIO; IX_EARG a format that is not written; IX_EUNABLE the format cannot
 * hold o; IX_EDOMAIN a number is not finite; IX_ENOMEM. */
ix_status ix_save(ix_ctx *ctx, const char *name, const ix_obj *o,
                  double tol) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
