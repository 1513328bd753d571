/* ode.h - initial value problems with events, by the explicit Runge-Kutta
 * methods of SUNDIALS (ARKODE), which is loaded with the first problem.
 *
 * An event is a function g(t, y) that is positive before and falls through
 * zero; its time is refined by further integration, not by interpolation. */
#ifndef SOLVE_ODE_H
#define SOLVE_ODE_H

#include "base/ctx.h"

enum { IX_ODE_UNKNOWNS = 8, IX_ODE_EVENTS = 12 };

/* dy/dt; false: it cannot be evaluated there. */
typedef bool (*ix__ode_fn)(void *ud, double t, const double *y, double *dy);
/* The values of all events. */
typedef void (*ix__ode_event_fn)(void *ud, double t, const double *y,
                                 double *g);
/* Moves y onto a known invariant after each step; NULL: none. */
typedef void (*ix__ode_project_fn)(void *ud, double t, double *y);

typedef struct {
    int n, nevents; /* at most IX_ODE_UNKNOWNS, IX_ODE_EVENTS */
    ix__ode_fn f;
    ix__ode_event_fn g;
    ix__ode_project_fn project;
    void *ud;
    double tol;      /* of each step, relative and absolute; the error at the
                        end is some hundredths of it (check: about it) */
    double max_step; /* 0: none */
    bool check; /* Dormand-Prince 5(4) instead of Fehlberg 8(7): an independent
                   method for measuring */
} ix__ode_problem;

typedef struct ix__ode ix__ode;

typedef enum {
    IX_ODE_STEP, /* one step further */
    IX_ODE_END,  /* exactly at the end asked for */
    IX_ODE_EVENT,
    IX_ODE_STUCK /* no step is small enough: f cannot be evaluated */
} ix__ode_result;

/* Err IX_EUNABLE built without SUNDIALS, or the library is not installed. */
ix_status ix__ode_open(ix_ctx *ctx, const ix__ode_problem *p,
                       ix__ode **out) IX_MUST_CHECK;
void ix__ode_close(ix__ode *o); /* o may be NULL */

/* From (t, y[n]) to end, > t. No allocation from here on. */
ix_status ix__ode_start(ix__ode *o, double t, const double *y,
                        double end) IX_MUST_CHECK;
/* The next step: *t, y[n], and the event's index. An event whose g is not
 * positive at the start and falls there happens at once. */
ix_status ix__ode_step(ix__ode *o, double *t, double *y, int *event,
                       ix__ode_result *out) IX_MUST_CHECK;
/* All steps: IX_ODE_END, _EVENT or _STUCK. */
ix_status ix__ode_run(ix__ode *o, double *t, double *y, int *event,
                      ix__ode_result *out) IX_MUST_CHECK;

#endif
