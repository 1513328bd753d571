/* threads.c - one pool of workers per context, started at the first large
 * piece of work and kept. Work is handed out in small blocks by a counter:
 * which thread does which block is open, what a block computes is not. */
#define _POSIX_C_SOURCE 200809L
#include "base/threads.h"

#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

#define WORTH_NS    50000.0 /* waking workers costs about 10 us */
#define BLOCK_NS    20000.0
#define MAX_THREADS 64

struct ix__pool {
    pthread_mutex_t lock;
    pthread_cond_t start, done;
    int nworkers, busy;
    unsigned long round; /* a new number for each piece of work */
    bool stop;
    ix__work_fn fn;
    void *arg;
    size_t n, block;
    atomic_size_t next;
    pthread_t threads[MAX_THREADS];
};

static void run_blocks(ix__pool *p)
{
    for (;;) {
        size_t b = atomic_fetch_add(&p->next, p->block);
        size_t e;

        if (b >= p->n)
            return;
        e = p->n - b < p->block ? p->n : b + p->block;
        p->fn(p->arg, b, e);
    }
}

static void *worker(void *arg)
{
    ix__pool *p = arg;
    unsigned long seen = 0;

    pthread_mutex_lock(&p->lock);
    for (;;) {
        while (!p->stop && p->round == seen)
            pthread_cond_wait(&p->start, &p->lock);
        if (p->stop)
            break;
        seen = p->round;
        pthread_mutex_unlock(&p->lock);
        run_blocks(p);
        pthread_mutex_lock(&p->lock);
        if (--p->busy == 0)
            pthread_cond_signal(&p->done);
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

static int wanted_threads(const ix_ctx *ctx)
{
    long n = ctx->nthreads;

    if (n <= 0)
        n = sysconf(_SC_NPROCESSORS_ONLN);
    if (n < 1)
        return 1;
    return n > MAX_THREADS ? MAX_THREADS : (int)n;
}

/* The pool, with as many workers as could be started; NULL if none. */
static ix__pool *get_pool(ix_ctx *ctx)
{
    int want = wanted_threads(ctx) - 1;
    ix__pool *p = ctx->pool;

    if (want < 1)
        return NULL;
    if (p)
        return p->nworkers ? p : NULL;
    p = ix__alloc(ctx, sizeof *p);
    if (!p)
        return NULL;
    *p = (ix__pool){.stop = false};
    pthread_mutex_init(&p->lock, NULL);
    pthread_cond_init(&p->start, NULL);
    pthread_cond_init(&p->done, NULL);
    while (p->nworkers < want &&
           pthread_create(&p->threads[p->nworkers], NULL, worker, p) == 0)
        p->nworkers++;
    ctx->pool = p;
    return p->nworkers ? p : NULL;
}

static void run_pool(ix__pool *p, size_t n, size_t block, ix__work_fn fn,
                     void *arg)
{
    pthread_mutex_lock(&p->lock);
    p->fn = fn;
    p->arg = arg;
    p->n = n;
    p->block = block;
    atomic_store(&p->next, 0);
    p->busy = p->nworkers;
    p->round++;
    pthread_cond_broadcast(&p->start);
    pthread_mutex_unlock(&p->lock);
    run_blocks(p);
    pthread_mutex_lock(&p->lock);
    while (p->busy > 0)
        pthread_cond_wait(&p->done, &p->lock);
    pthread_mutex_unlock(&p->lock);
}

void ix__parallel(ix_ctx *ctx, size_t n, double item_ns, ix__work_fn fn,
                  void *arg)
{
    double total = (double)n * item_ns;
    size_t block;
    ix__pool *p;

    if (n == 0)
        return;
    p = total > WORTH_NS && n > 1 ? get_pool(ctx) : NULL;
    if (!p) {
        fn(arg, 0, n);
        return;
    }
    block = (size_t)(BLOCK_NS / item_ns);
    run_pool(p, n, block > 0 ? block : 1, fn, arg);
}

void ix_ctx_set_threads(ix_ctx *ctx, int n)
{
    ix__pool_stop(ctx);
    ctx->nthreads = n;
}

void ix__pool_stop(ix_ctx *ctx)
{
    ix__pool *p = ctx->pool;

    if (!p)
        return;
    pthread_mutex_lock(&p->lock);
    p->stop = true;
    pthread_cond_broadcast(&p->start);
    pthread_mutex_unlock(&p->lock);
    for (int i = 0; i < p->nworkers; i++)
        pthread_join(p->threads[i], NULL);
    pthread_mutex_destroy(&p->lock);
    pthread_cond_destroy(&p->start);
    pthread_cond_destroy(&p->done);
    ix__free(ctx, p, sizeof *p);
    ctx->pool = NULL;
}
