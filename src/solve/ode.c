/* ode.c - initial value problems through ARKODE's ERKStep.
 *
 * One step at a time. Where the right side cannot be evaluated the step is
 * tried again from the last state with a quarter of its length. An event that
 * ARKODE brackets by its interpolant is refined by Newton's method with the
 * state integrated anew from the last step, so that it is as exact as the
 * integration. */
#include "solve/ode.h"

#ifndef IX_NO_SUNDIALS
#include <arkode/arkode_erkstep.h>
#include <dlfcn.h>
#include <float.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <pthread.h>
#include <string.h>

/* ARKODE 5 is the one of SUNDIALS 6. */
#define LIBRARY "libsundials_arkode.so.5"

enum {
    RETRIES = 60,   /* quarters of a step: 4^-60 is far below rounding */
    REFINEMENTS = 8 /* Newton steps of an event's time */
};

/* --- the library ---------------------------------------------------------- */

static struct {
    __typeof__(SUNContext_Create) *context_create;
    __typeof__(SUNContext_Free) *context_free;
    __typeof__(N_VNew_Serial) *vector_new;
    __typeof__(N_VDestroy) *vector_free;
    __typeof__(ERKStepCreate) *create;
    __typeof__(ERKStepReInit) *reinit;
    __typeof__(ERKStepFree) *free;
    __typeof__(ERKStepEvolve) *evolve;
    __typeof__(ERKStepSStolerances) *tolerances;
    __typeof__(ERKStepSetTableNum) *set_table;
    __typeof__(ERKStepSetInterpolantDegree) *set_interpolant;
    __typeof__(ERKStepRootInit) *root_init;
    __typeof__(ERKStepSetRootDirection) *root_direction;
    __typeof__(ERKStepSetNoInactiveRootWarn) *no_root_warning;
    __typeof__(ERKStepGetRootInfo) *root_info;
    __typeof__(ERKStepSetErrHandlerFn) *set_handler;
    __typeof__(ERKStepSetUserData) *set_data;
    __typeof__(ERKStepSetPostprocessStepFn) *set_postprocess;
    __typeof__(ERKStepSetStopTime) *set_stop;
    __typeof__(ERKStepSetInitStep) *set_init;
    __typeof__(ERKStepSetMaxStep) *set_max;
    __typeof__(ERKStepGetLastStep) *last_step;
    bool loaded;
} lib;

static void load_library(void)
{
    static const struct {
        const char *name;
        void *slot;
    } wanted[] = {
        {"SUNContext_Create", &lib.context_create},
        {"SUNContext_Free", &lib.context_free},
        {"N_VNew_Serial", &lib.vector_new},
        {"N_VDestroy", &lib.vector_free},
        {"ERKStepCreate", &lib.create},
        {"ERKStepReInit", &lib.reinit},
        {"ERKStepFree", &lib.free},
        {"ERKStepEvolve", &lib.evolve},
        {"ERKStepSStolerances", &lib.tolerances},
        {"ERKStepSetTableNum", &lib.set_table},
        {"ERKStepSetInterpolantDegree", &lib.set_interpolant},
        {"ERKStepRootInit", &lib.root_init},
        {"ERKStepSetRootDirection", &lib.root_direction},
        {"ERKStepSetNoInactiveRootWarn", &lib.no_root_warning},
        {"ERKStepGetRootInfo", &lib.root_info},
        {"ERKStepSetErrHandlerFn", &lib.set_handler},
        {"ERKStepSetUserData", &lib.set_data},
        {"ERKStepSetPostprocessStepFn", &lib.set_postprocess},
        {"ERKStepSetStopTime", &lib.set_stop},
        {"ERKStepSetInitStep", &lib.set_init},
        {"ERKStepSetMaxStep", &lib.set_max},
        {"ERKStepGetLastStep", &lib.last_step},
    };
    void *so = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL);

    for (size_t i = 0; so && i < sizeof wanted / sizeof *wanted; i++) {
        void *symbol = dlsym(so, wanted[i].name);

        if (!symbol)
            return;
        memcpy(wanted[i].slot, &symbol, sizeof symbol);
    }
    lib.loaded = so != NULL;
}

/* --- callbacks ------------------------------------------------------------ */

struct ix__ode {
    ix_ctx *ctx;
    ix__ode_problem p;
    SUNContext sun;
    void *mem;
    N_Vector y;
    bool quiet;  /* no events while one is refined */
    bool failed; /* f could not be evaluated in this step */
    double t, end, step;
    double at[IX_ODE_UNKNOWNS]; /* the state at t */
};

static int right_side(realtype t, N_Vector y, N_Vector dy, void *ud)
{
    ix__ode *o = ud;
    bool ok = o->p.f(o->p.ud, t, NV_DATA_S(y), NV_DATA_S(dy));

    for (int i = 0; ok && i < o->p.n; i++)
        ok = isfinite(NV_Ith_S(dy, i));
    o->failed |= !ok;
    return ok ? 0 : 1;
}

static int events(realtype t, N_Vector y, realtype *g, void *ud)
{
    ix__ode *o = ud;

    if (o->quiet)
        for (int i = 0; i < o->p.nevents; i++)
            g[i] = 1;
    else
        o->p.g(o->p.ud, t, NV_DATA_S(y), g);
    return 0;
}

static int postprocess(realtype t, N_Vector y, void *ud)
{
    ix__ode *o = ud;

    o->p.project(o->p.ud, t, NV_DATA_S(y));
    return 0;
}

/* Failures are told by what ERKStepEvolve returns. */
static void no_message(int code, const char *module, const char *function,
                       char *text, void *ud)
{
    (void)code;
    (void)module;
    (void)function;
    (void)text;
    (void)ud;
}

/* Sums over stages: half of the coefficients are zero, and vectors are short.
 * SUNDIALS' own goes over the vectors once for each term. */
static int combine(int n, realtype *c, N_Vector *x, N_Vector z)
{
    double sum[IX_ODE_UNKNOWNS] = {0};
    int len = (int)NV_LENGTH_S(z);

    for (int i = 0; i < n; i++) {
        const double *v = NV_DATA_S(x[i]);

        for (int k = 0; c[i] != 0 && k < len; k++)
            sum[k] += c[i] * v[k];
    }
    memcpy(NV_DATA_S(z), sum, (size_t)len * sizeof *sum);
    return 0;
}

/* --- opening and closing -------------------------------------------------- */

static bool set_events(ix__ode *o)
{
    int direction[IX_ODE_EVENTS];

    if (o->p.nevents == 0)
        return true;
    for (int i = 0; i < o->p.nevents; i++)
        direction[i] = -1;
    return lib.root_init(o->mem, o->p.nevents, events) == 0 &&
           lib.root_direction(o->mem, direction) == 0 &&
           lib.no_root_warning(o->mem) == 0;
}

static bool set_up(ix__ode *o)
{
    ARKODE_ERKTableID table = o->p.check ? ARKODE_DORMAND_PRINCE_7_4_5
                                         : ARKODE_FEHLBERG_13_7_8;

    if (lib.context_create(NULL, &o->sun) != 0)
        return false;
    o->y = lib.vector_new(o->p.n, o->sun);
    if (!o->y)
        return false;
    memset(NV_DATA_S(o->y), 0, (size_t)o->p.n * sizeof(double));
    o->y->ops->nvlinearcombination = combine; /* clones have it, too */
    o->mem = lib.create(right_side, 0.0, o->y, o->sun);
    return o->mem && lib.set_handler(o->mem, no_message, NULL) == 0 &&
           lib.set_data(o->mem, o) == 0 && lib.set_table(o->mem, table) == 0 &&
           lib.tolerances(o->mem, o->p.tol, o->p.tol) == 0 &&
           lib.set_max(o->mem, o->p.max_step) == 0 &&
           (!o->p.project || lib.set_postprocess(o->mem, postprocess) == 0) &&
           set_events(o);
}

/* ARKODE's own guess would be 1e-12 or so, and a dozen steps lost; one that is
 * too long costs one. In units in which the problem has the size 1. */
static double first_step(const ix__ode_problem *p)
{
    double h = 0.5 * pow(p->tol, p->check ? 0.2 : 0.125);

    return p->max_step > 0 ? fmin(h, p->max_step) : h;
}

ix_status ix__ode_open(ix_ctx *ctx, const ix__ode_problem *p, ix__ode **out)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    ix__ode *o;

    *out = NULL;
    (void)pthread_once(&once, load_library);
    if (!lib.loaded)
        return IX_FAIL(ctx, IX_EUNABLE,
                       "distances on surfaces need SUNDIALS: " LIBRARY
                       " cannot be loaded");
    o = ix__alloc(ctx, sizeof *o);
    if (!o)
        return IX_ENOMEM;
    *o = (ix__ode){.ctx = ctx, .p = *p, .step = first_step(p)};
    if (!set_up(o)) {
        ix__ode_close(o);
        return IX_FAIL(ctx, IX_ENOMEM, "no memory for the integrator");
    }
    *out = o;
    return IX_OK;
}

void ix__ode_close(ix__ode *o)
{
    if (!o)
        return;
    if (o->mem)
        lib.free(&o->mem);
    if (o->y)
        lib.vector_free(o->y);
    if (o->sun)
        (void)lib.context_free(&o->sun);
    ix__free(o->ctx, o, sizeof *o);
}

/* --- steps ---------------------------------------------------------------- */

/* The integrator set to the last state, towards end. */
static bool restart(ix__ode *o, double end)
{
    memcpy(NV_DATA_S(o->y), o->at, (size_t)o->p.n * sizeof(double));
    o->failed = false;
    return lib.reinit(o->mem, right_side, o->t, o->y) == 0 &&
           lib.set_init(o->mem, fmin(o->step, end - o->t)) == 0 &&
           lib.set_stop(o->mem, end) == 0;
}

ix_status ix__ode_start(ix__ode *o, double t, const double *y, double end)
{
    o->t = t;
    o->end = end;
    memcpy(o->at, y, (size_t)o->p.n * sizeof(double));
    if (!(end > t))
        return IX_FAIL(o->ctx, IX_EARG, "integration from %g to %g", t, end);
    if (!restart(o, end))
        return IX_FAIL(o->ctx, IX_EUNABLE, "the integrator cannot start");
    return IX_OK;
}

/* g and its derivative along the solution at (t, y). */
static bool event_slope(ix__ode *o, double t, const double *y, int i, double g0,
                        double *slope)
{
    double dy[IX_ODE_UNKNOWNS], z[IX_ODE_UNKNOWNS], g[IX_ODE_EVENTS], h;

    if (!o->p.f(o->p.ud, t, y, dy))
        return false;
    h = 1e-6 * fmax(o->end - o->t, fabs(t) * 1e-6);
    for (int k = 0; k < o->p.n; k++)
        z[k] = y[k] + h * dy[k];
    o->p.g(o->p.ud, t + h, z, g);
    *slope = (g[i] - g0) / h;
    return isfinite(*slope);
}

/* The event that is over at the start already, or -1. */
static int event_at_start(ix__ode *o)
{
    double g[IX_ODE_EVENTS], slope;

    if (o->p.nevents == 0)
        return -1;
    o->p.g(o->p.ud, o->t, o->at, g);
    for (int i = 0; i < o->p.nevents; i++)
        if (g[i] <= 0 && event_slope(o, o->t, o->at, i, g[i], &slope) &&
            slope < 0)
            return i;
    return -1;
}

/* The state at t, > o->t, by integration from the last step without events. */
static bool state_at(ix__ode *o, double t, double *y)
{
    double at = o->t;
    bool ok;
    int flag = ARK_SUCCESS;

    o->quiet = true;
    ok = restart(o, t);
    while (ok && flag != ARK_TSTOP_RETURN) {
        flag = lib.evolve(o->mem, t, o->y, &at, ARK_ONE_STEP);
        ok = flag >= 0;
    }
    o->quiet = false;
    memcpy(y, NV_DATA_S(o->y), (size_t)o->p.n * sizeof(double));
    return ok;
}

/* Newton steps for the zero of event i between the last step and hi, from *t.
 * Stops when the time does not change by more than rounding. */
static bool refine(ix__ode *o, int i, double hi, double *t, double *y)
{
    double g[IX_ODE_EVENTS], slope;

    for (int k = 0; k < REFINEMENTS; k++) {
        double next;

        if (!(*t > o->t)) {
            *t = o->t;
            memcpy(y, o->at, (size_t)o->p.n * sizeof(double));
            return true;
        }
        if (!state_at(o, *t, y))
            return false;
        o->p.g(o->p.ud, *t, y, g);
        if (!event_slope(o, *t, y, i, g[i], &slope) || !(slope < 0))
            return true; /* a touching zero: as bracketed */
        next = fmin(fmax(*t - g[i] / slope, o->t), hi);
        if (fabs(next - *t) <= 4 * DBL_EPSILON * fmax(fabs(hi), hi - o->t))
            return true;
        *t = next;
    }
    return true;
}

static int first_event(ix__ode *o)
{
    int found[IX_ODE_EVENTS];

    if (lib.root_info(o->mem, found) == 0)
        for (int i = 0; i < o->p.nevents; i++)
            if (found[i])
                return i;
    return 0;
}

static void accept(ix__ode *o, double t, const double *y)
{
    double h = 0;

    if (lib.last_step(o->mem, &h) == 0 && h > 0 && t < o->end)
        o->step = h;
    o->t = t;
    memcpy(o->at, y, (size_t)o->p.n * sizeof(double));
}

/* After a failure: a quarter of the step, or false when that is nothing. */
static bool shorter(ix__ode *o)
{
    double h = o->step > 0 ? o->step : (o->end - o->t);

    o->step = 0.25 * fmin(h, o->end - o->t);
    return o->step > 4 * DBL_EPSILON * fmax(fabs(o->t), o->end - o->t) &&
           restart(o, o->end);
}

ix_status ix__ode_step(ix__ode *o, double *t, double *y, int *event,
                       ix__ode_result *out)
{
    int flag = -1;

    IX_TRY(ix__poll(o->ctx));
    *event = event_at_start(o);
    *out = IX_ODE_EVENT;
    *t = o->t;
    memcpy(y, o->at, (size_t)o->p.n * sizeof(double));
    if (*event >= 0)
        return IX_OK;
    for (int k = 0; flag < 0 && k < RETRIES; k++) {
        flag = lib.evolve(o->mem, o->end, o->y, t, ARK_ONE_STEP);
        if (flag < 0 && !shorter(o))
            break;
    }
    *out = IX_ODE_STUCK;
    if (flag < 0) {
        *t = o->t;
        memcpy(y, o->at, (size_t)o->p.n * sizeof(double));
        return IX_OK;
    }
    memcpy(y, NV_DATA_S(o->y), (size_t)o->p.n * sizeof(double));
    if (flag == ARK_ROOT_RETURN) {
        *event = first_event(o);
        *out = refine(o, *event, o->end, t, y) ? IX_ODE_EVENT : IX_ODE_STUCK;
        return IX_OK;
    }
    *out = flag == ARK_TSTOP_RETURN ? IX_ODE_END : IX_ODE_STEP;
    accept(o, *t, y);
    return IX_OK;
}

#else

ix_status ix__ode_open(ix_ctx *ctx, const ix__ode_problem *p, ix__ode **out)
{
    (void)p;
    *out = NULL;
    return IX_FAIL(ctx, IX_EUNABLE,
                   "distances on surfaces need SUNDIALS, which this library "
                   "was built without (WITH_SUNDIALS=0)");
}

void ix__ode_close(ix__ode *o)
{
    (void)o;
}

ix_status ix__ode_start(ix__ode *o, double t, const double *y, double end)
{
    (void)o;
    (void)t;
    (void)y;
    (void)end;
    return IX_EUNABLE;
}

ix_status ix__ode_step(ix__ode *o, double *t, double *y, int *event,
                       ix__ode_result *out)
{
    (void)o;
    (void)t;
    (void)y;
    (void)event;
    (void)out;
    return IX_EUNABLE;
}
#endif

ix_status ix__ode_run(ix__ode *o, double *t, double *y, int *event,
                      ix__ode_result *out)
{
    do {
        IX_TRY(ix__ode_step(o, t, y, event, out));
    } while (*out == IX_ODE_STEP);
    return IX_OK;
}
