/* b_files.c - whole files of 100 MB: saving and loading a scene in every
 * format, with the most memory that it took. Each row is a process of its own,
 * which runs once; what the scene itself takes is told beside. */
#define _DEFAULT_SOURCE
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/input.h"

enum { SIDE = 100, SURFACES = 165, GRID = 440, CURVES = 4000 };

static char folder[64];

static void append(ix_ctx *ctx, ix_obj *list, ix_obj *o)
{
    ix_bench_ok(ctx, ix__obj_append(ctx, list, o));
    ix__obj_unref(ctx, o);
}

static double height(double u, double v, int i)
{
    return sin(3 * u + i) * cos(2 * v - i);
}

/* A bicubic surface, smooth, whose coordinates have all their digits. */
static ix_obj *surface(ix_ctx *ctx, int i)
{
    static double knots[SIDE + 4], pts[3][SIDE * SIDE];
    ix_dir dirs[2] = {{IX_BSPLINE, 4, SIDE, false, knots},
                      {IX_BSPLINE, 4, SIDE, false, knots}};
    ix_mv *m = NULL;

    for (int k = 0; k < SIDE + 4; k++)
        knots[k] = fmin(fmax(k - 3, 0), SIDE - 3);
    for (int k = 0; k < SIDE * SIDE; k++) {
        double u = k % SIDE / (double)SIDE, v = k / SIDE / (double)SIDE;

        pts[0][k] = u + i / 7.0;
        pts[1][k] = v + i / 11.0;
        pts[2][k] = height(u, v, i);
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, 2, dirs, 3, false, pts[0], &m));
    return ix__obj_mv(ctx, IX_OBJ_SURFACE, m);
}

static ix_obj *curve(ix_ctx *ctx, int i)
{
    const ix_dir dir = {IX_BEZIER, 4, 4, false, NULL};
    double pts[12];
    ix_mv *m = NULL;

    for (int k = 0; k < 12; k++)
        pts[k] = sin(i + k);
    ix_bench_ok(ctx, ix_mv_new(ctx, 1, &dir, 3, false, pts, &m));
    return ix__obj_mv(ctx, IX_OBJ_CURVE, m);
}

/* Triangles over a grid. */
static ix_obj *triangles(ix_ctx *ctx)
{
    ix_poly *p = ix__poly_new(ctx, 2 * GRID * GRID);

    for (int t = 0; p && t < p->n; t++) {
        static const int corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}},
                                            {{0, 0}, {1, 1}, {0, 1}}};
        ix_polygon *pg = &p->poly[t];

        ix_bench_ok(ctx, ix__poly_vertices(ctx, pg, 3));
        for (int k = 0; k < 3; k++) {
            double *at = pg->v[k].p;

            at[0] = (t / 2 % GRID + corner[t % 2][k][0]) / (double)GRID;
            at[1] = (t / 2 / GRID + corner[t % 2][k][1]) / (double)GRID;
            at[2] = height(at[0], at[1], 0);
        }
    }
    return ix__obj_poly(ctx, p);
}

static ix_obj *make_scene(ix_ctx *ctx, bool polygons)
{
    ix_obj *list = ix__obj_list(ctx);

    if (polygons)
        append(ctx, list, triangles(ctx));
    for (int i = 0; !polygons && i < SURFACES; i++)
        append(ctx, list, surface(ctx, i));
    for (int i = 0; !polygons && i < CURVES; i++)
        append(ctx, list, curve(ctx, i));
    return list;
}

static const char *in_folder(const char *suffix)
{
    static char name[96];

    (void)snprintf(name, sizeof name, "%s/scene.%s", folder, suffix);
    return name;
}

/* The process' work: nanoseconds that saving or loading takes. */
static double work(const char *suffix, bool polygons, bool reading)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const char *name = in_folder(suffix);
    ix_obj *o = reading ? NULL : make_scene(ctx, polygons);
    double start = ix_bench_clock();

    if (reading)
        ix_bench_ok(ctx, ix__load(ctx, name, NULL, &o));
    else
        ix_bench_ok(ctx, ix__save(ctx, name, o, NULL));
    start = ix_bench_clock() - start;
    fprintf(stderr, "# %s %s: the objects take %.0f MB\n",
            reading ? "load" : "save", suffix, (double)ctx->live / 1e6);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
    return start;
}

/* Throughput is that of text: packed files count what they unpack to, which is
 * the size of the file before. */
static void row(const char *suffix, bool polygons, bool reading)
{
    static double bytes;
    struct rusage used;
    struct stat sb = {0};
    double ns = 0;
    int fd[2], status = 0;
    pid_t child;

    if (pipe(fd) != 0 || (child = fork()) < 0)
        exit(1);
    if (child == 0) {
        ns = work(suffix, polygons, reading);
        _exit(write(fd[1], &ns, sizeof ns) == sizeof ns ? 0 : 1);
    }
    (void)close(fd[1]);
    if (read(fd[0], &ns, sizeof ns) != sizeof ns ||
        wait4(child, &status, 0, &used) != child || status != 0 ||
        stat(in_folder(suffix), &sb) != 0)
        exit(1);
    (void)close(fd[0]);
    bytes = strstr(suffix, ".gz") ? bytes : (double)sb.st_size;
    printf("%s .%s, a scene of %s\t%.6g\t%.6g\tbyte\t%.6g\n",
           reading ? "load" : "save", suffix,
           polygons ? "390 k triangles" : "1.7 M control points", ns, bytes,
           1024.0 * (double)used.ru_maxrss);
    fflush(stdout);
}

static void both(const char *suffix)
{
    row(suffix, false, false);
    row(suffix, false, true);
    (void)unlink(in_folder(suffix));
}

static void writing(const char *suffix, bool polygons)
{
    row(suffix, polygons, false);
    (void)unlink(in_folder(suffix));
}

int main(void)
{
    const char *base = getenv("TMPDIR");

    (void)snprintf(folder, sizeof folder, "%.40s/iritx-XXXXXX",
                   base ? base : "/tmp");
    if (!mkdtemp(folder))
        return 1;
    both("itd");
    both("itd.gz");
    both("xml");
    both("xml.gz");
    writing("x3d", false);
    writing("step", false);
    writing("stl", true);
    writing("bstl", true);
    writing("obj", true);
    return rmdir(folder) != 0;
}
