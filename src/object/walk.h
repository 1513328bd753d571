/* walk.h - walks over an object's lists (and object attributes).
 *
 * Lists may share elements, so that n boxes can stand for 2^n paths: a walk
 * marks what it meets, looks into each box once, and clears the marks at its
 * end. Nothing here uses the C stack for depth. One walk at a time. */
#ifndef OBJECT_WALK_H
#define OBJECT_WALK_H

#include "object/object.h"

typedef struct ix__walk ix__walk;

/* A box with children, on the way or done. The fields below the line belong
 * to the caller. */
typedef struct ix__node ix__node;
struct ix__node {
    ix_obj *box;
    ix__node *up;  /* the box whose children led here first */
    ix__node *all; /* the node made before */
    const ix_attr *attr;
    int item;
    bool done;
    /* --- */
    double bytes;
    int depth;
    ix_obj *result;
};

/* What to do, each for the box on top of the way (walk->top). */
typedef struct {
    ix_status (*enter)(ix__walk *w); /* a new box is on top */
    ix_status (*leaf)(ix__walk *w, const ix_obj *child);
    /* a child with children is complete, now or since an earlier path */
    ix_status (*join)(ix__walk *w, const ix__node *child);
} ix__walk_ops;

struct ix__walk {
    ix_ctx *ctx;
    const ix__walk_ops *ops;
    bool attrs;          /* object attributes are children, too */
    int max_depth;       /* of boxes with children on one path; 0: no limit */
    int depth;           /* now */
    ix__node *top, *all; /* in scratch */
};

/* Does o have children? */
bool ix__walk_inner(const ix__walk *w, const ix_obj *o);
/* Depth first from root, which has children; its node is returned. Err
 * IX_EUNABLE a box contains itself, or the way is too deep; what ops return.
 * The caller has taken a scratch mark, and calls ix__walk_end in any case. */
ix_status ix__walk_run(ix__walk *w, const ix_obj *root,
                       ix__node **node) IX_MUST_CHECK;
void ix__walk_end(ix__walk *w); /* clears the marks */

/* Calls fn for o, or for each element that is no list of each list in it. */
typedef ix_status (*ix__leaf_fn)(void *arg, const ix_obj *leaf);
ix_status ix__walk_leaves(const ix_obj *o, ix__leaf_fn fn,
                          void *arg) IX_MUST_CHECK;

#endif
