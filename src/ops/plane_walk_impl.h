/* plane_walk_impl.h - samples and their neighbours, for the walk and its runs.
 */
#ifndef OPS_PLANE_WALK_IMPL_H
#define OPS_PLANE_WALK_IMPL_H

#include "ops/plane_walk.h"

/* Beyond this distance the bisector goes to infinity, nearly straight. */
#define IX__FAR 4.0

/* The point c of a border element and the normal n there. */
void ix__own_frame(const ix__set *s, const ix__border *e, double at,
                   ix__sample *o);
/* Begins o, which has its own foot, with the circle that touches the other set
 * next to it; o->foot is left alone if there is none. False if both sets are
 * the same there. */
bool ix__narrow_foot(const ix__walk *w, ix__sample *o);
/* Feet so near each other that the centre is known to half the digits. */
bool ix__near_feet(const ix__sample *a);
/* Are both centres one, where pieces end and begin? */
bool ix__centres_meet(const ix__sample *a, const ix__sample *b);
/* How far the foot moves from a to b along its strand; infinite if there is no
 * way without a corner. */
double ix__foot_way(const ix__set *s, const ix__touch *a, const ix__touch *b);
/* Does a foot pass the place where its closed curve begins? There its parameter
 * jumps, and pieces between two objects are divided. */
bool ix__passes_seam(const ix__walk *w, const ix__sample *a,
                     const ix__sample *b);
/* How many times the tolerance the chord from a to b may be off. */
double ix__walk_share(const ix__walk *w, const ix__sample *a,
                      const ix__sample *b);
/* Are the feet on the same elements? */
bool ix__same_feet(const ix__walk *w, const ix__sample *a, const ix__sample *b);
/* With one set for both: do the feet change places between a and b? There the
 * medial axis ends, at a centre of curvature, and the walk turns back. */
bool ix__walk_turns(const ix__walk *w, const ix__sample *a,
                    const ix__sample *b);

#endif
