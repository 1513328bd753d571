/* Whole files: what is read, what is refused, that saving is all or nothing,
 * and that the suffix chooses the format. */
#define _DEFAULT_SOURCE
#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/io.h"

static char folder[64];

static const char *in_folder(const char *name)
{
    static char path[4][512];
    static int turn;

    turn = (turn + 1) % 4;
    (void)snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
    return path[turn];
}

static int count_files(void)
{
    DIR *dir = opendir(folder);
    int n = 0;

    assert_non_null(dir);
    for (struct dirent *e; (e = readdir(dir));)
        n += strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0;
    closedir(dir);
    return n;
}

static int make_folder(void **state)
{
    (void)state;
    strcpy(folder, "/dev/shm/iritx-test-XXXXXX"); /* syncs at no cost */
    if (mkdtemp(folder))
        return 0;
    strcpy(folder, "/tmp/iritx-test-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static void remove_all(void)
{
    DIR *dir = opendir(folder);

    for (struct dirent *e; dir && (e = readdir(dir));)
        if (e->d_name[0] != '.' || strlen(e->d_name) > 2)
            (void)remove(in_folder(e->d_name));
    closedir(dir);
}

static int remove_folder(void **state)
{
    (void)state;
    remove_all();
    return rmdir(folder);
}

static void write_file(ix_ctx *ctx, const char *name, const char *text)
{
    ASSERT_OK(ctx, ix__file_write(ctx, in_folder(name), text, strlen(text)));
}

static void expect_contents(ix_ctx *ctx, const char *name, const char *text)
{
    ix_buf b;

    ASSERT_OK(ctx, ix__file_read(ctx, in_folder(name), &b));
    assert_int_equal(b.len, strlen(text));
    assert_string_equal(b.data, text);
    ix__buf_free(&b);
}

/* --- reading and writing ---------------------------------------------- */

static void test_round(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    FILE *f;
    int first;

    (void)state;
    write_file(ctx, "a", "contents\n");
    expect_contents(ctx, "a", "contents\n");
    write_file(ctx, "a", ""); /* replaced */
    expect_contents(ctx, "a", "");
    write_file(ctx, "b.gz", "packed");
    expect_contents(ctx, "b.gz", "packed");
    f = fopen(in_folder("b.gz"), "rb");
    assert_non_null(f);
    first = fgetc(f);
    assert_int_equal(fclose(f), 0);
    assert_int_equal(first, 0x1f); /* it really is */
    assert_int_equal(rename(in_folder("b.gz"), in_folder("plain")), 0);
    expect_contents(ctx, "plain", "packed"); /* told by its bytes */
    assert_int_equal(count_files(), 2);
    ix_ctx_free(ctx);
}

/* A new file follows the umask, an old one keeps its mode. */
static void test_mode(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    mode_t old = umask(027);
    struct stat sb;

    (void)state;
    write_file(ctx, "m", "1");
    assert_int_equal(stat(in_folder("m"), &sb), 0);
    assert_int_equal(sb.st_mode & 0777, 0640);
    assert_int_equal(chmod(in_folder("m"), 0604), 0);
    write_file(ctx, "m", "2");
    assert_int_equal(stat(in_folder("m"), &sb), 0);
    assert_int_equal(sb.st_mode & 0777, 0604);
    (void)umask(old);
    ix_ctx_free(ctx);
}

static void expect_unreadable(ix_ctx *ctx, const char *name, ix_status st,
                              const char *message)
{
    ix_buf b;

    assert_int_equal(ix__file_read(ctx, name, &b), st);
    if (!strstr(ix_ctx_message(ctx), message))
        fail_msg("%s", ix_ctx_message(ctx));
    assert_ptr_equal(strstr(ix_ctx_message(ctx), name), ix_ctx_message(ctx));
    assert_null(b.data);
}

static void test_unreadable(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    expect_unreadable(ctx, in_folder("absent"), IX_EIO,
                      "cannot read: No such file or directory");
    expect_unreadable(ctx, folder, IX_EIO, "it is a directory, not a file");
    expect_unreadable(ctx, "/dev/null", IX_EIO, "it is a device, not a file");
    assert_int_equal(mkfifo(in_folder("fifo"), 0600), 0);
    expect_unreadable(ctx, in_folder("fifo"), IX_EIO,
                      "it is a FIFO, not a file"); /* and does not wait */
    write_file(ctx, "lzw", "\x1f\x9d...");
    expect_unreadable(ctx, in_folder("lzw"), IX_EPARSE, "repack it with gzip");
    write_file(ctx, "cut", "\x1f\x8b");
    expect_unreadable(ctx, in_folder("cut"), IX_EPARSE,
                      "unexpected end of gzip data");
    ix_ctx_free(ctx);
}

/* 1.2 MB of text and more; the digits of random numbers do not repeat. */
static ix_obj *large(ix_ctx *ctx)
{
    enum { N = 1000 };
    const ix_dir dir = {IX_BEZIER, N, N, false, NULL};
    static double pts[3 * N];
    ix_obj *list = ix__obj_list(ctx);
    ix_rng r = ix_rng_new(8);

    for (int i = 0; i < 20; i++) {
        ix_mv *m;
        ix_obj *o;

        for (int k = 0; k < 3 * N; k++)
            pts[k] = ix_rng_range(&r, -1, 1);
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 3, false, pts, &m));
        o = ix__obj_mv(ctx, IX_OBJ_CURVE, m);
        ASSERT_OK(ctx, ix__obj_append(ctx, list, o));
        ix__obj_unref(ctx, o);
    }
    return list;
}

/* --- all or nothing --------------------------------------------------- */

static void expect_unwritable(ix_ctx *ctx, const char *name,
                              const char *message)
{
    int files = count_files();

    assert_int_equal(ix__file_write(ctx, name, "new", 3), IX_EIO);
    if (!strstr(ix_ctx_message(ctx), message))
        fail_msg("%s", ix_ctx_message(ctx));
    assert_ptr_equal(strstr(ix_ctx_message(ctx), name), ix_ctx_message(ctx));
    assert_int_equal(count_files(), files);
}

static void test_unwritable(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    expect_unwritable(ctx, in_folder("no/such"),
                      "cannot write: No such file or directory");
    expect_unwritable(ctx, folder, "it is a directory");
    expect_unwritable(ctx, "/dev/null", "it is a device");
    expect_unwritable(ctx, "", "cannot write");
    write_file(ctx, "old", "old");
    if (geteuid() != 0) { /* root may write anywhere */
        assert_int_equal(chmod(folder, 0500), 0);
        expect_unwritable(ctx, in_folder("old"), "Permission denied");
        assert_int_equal(chmod(folder, 0700), 0);
    }
    expect_contents(ctx, "old", "old");
    ix_ctx_free(ctx);
}

/* A full disk, as a limit on the size of files: the old contents stay. */
static void test_full(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    struct rlimit old, low;
    int files;
    char *big = calloc(1, 100000);

    (void)state;
    write_file(ctx, "full", "old");
    files = count_files();
    (void)signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &old), 0);
    low = old;
    low.rlim_cur = 50000;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &low), 0);
    assert_int_equal(ix__file_write(ctx, in_folder("full"), big, 100000),
                     IX_EIO);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &old), 0);
    (void)signal(SIGXFSZ, SIG_DFL);
    assert_non_null(strstr(ix_ctx_message(ctx), "File too large"));
    assert_int_equal(count_files(), files);
    expect_contents(ctx, "full", "old");
    free(big);
    ix_ctx_free(ctx);
}

static void test_cancel(void **state)
{
    volatile int stop = 0;
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    int files;
    ix_buf b;

    (void)state;
    write_file(ctx, "kept", "old");
    files = count_files();
    ix_ctx_set_cancel(ctx, &stop);
    stop = 1;
    assert_int_equal(ix__file_write(ctx, in_folder("kept"), "new", 3),
                     IX_ECANCEL);
    assert_int_equal(ix__file_read(ctx, in_folder("kept"), &b), IX_ECANCEL);
    stop = 0;
    expect_contents(ctx, "kept", "old");
    assert_int_equal(count_files(), files);
    ix_ctx_free(ctx);
}

/* Law: a process that is killed while it saves leaves the old file or the new
 * one, whole; the next one saves as if nothing had happened. */
static void test_killed(void **state)
{
    ix_rng r = ix_rng_new(12);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = large(ctx), *p;

    (void)state;
    ASSERT_OK(ctx, ix__save(ctx, in_folder("kill.itd"), o, NULL));
    for (int i = 0; i < 10; i++) {
        const struct timespec wait = {0, ix_rng_int(&r, 0, 8000000)};
        pid_t child = fork();

        assert_true(child >= 0);
        if (child == 0)
            for (;;)
                if (ix__save(ctx, in_folder("kill.itd"), o, NULL) != IX_OK)
                    _exit(1);
        (void)nanosleep(&wait, NULL);
        assert_int_equal(kill(child, SIGKILL), 0);
        assert_int_equal(waitpid(child, NULL, 0), child);
        ASSERT_OK(ctx, ix__load(ctx, in_folder("kill.itd"), NULL, &p));
        assert_int_equal(p->u.list.n, o->u.list.n);
        ix__obj_unref(ctx, p);
    }
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
    remove_all(); /* what it wrote beside */
}

/* --- load and save ---------------------------------------------------- */

static void expect_saved_as(ix_ctx *ctx, const char *name, const char *file)
{
    ix_obj *o = ix__obj_number(ctx, 7), *p;
    ix_buf resolved;

    ASSERT_OK(ctx, ix__save(ctx, in_folder(name), o, NULL));
    assert_int_equal(access(in_folder(file), R_OK), 0);
    ix__buf_init(&resolved, ctx);
    ASSERT_OK(ctx, ix__load(ctx, in_folder(name), &resolved, &p));
    assert_string_equal(resolved.data, in_folder(file));
    assert_true(p->u.num == 7);
    ix__obj_unref(ctx, o);
    ix__obj_unref(ctx, p);
    ix__buf_free(&resolved);
    assert_int_equal(unlink(in_folder(file)), 0);
}

static void test_suffixes(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, 7), *p;

    (void)state;
    expect_saved_as(ctx, "q", "q.itd");
    expect_saved_as(ctx, "q.itd", "q.itd");
    expect_saved_as(ctx, "q.ITD", "q.ITD");
    expect_saved_as(ctx, "q.imd", "q.imd");
    expect_saved_as(ctx, "q.b", "q.b.itd");
    expect_saved_as(ctx, "q.gz", "q.gz.itd");
    expect_saved_as(ctx, "q.itd.gz", "q.itd.gz");
    expect_saved_as(ctx, "q.itd.Z", "q.itd.Z");
    assert_int_equal(mkdir(in_folder("both"), 0700), 0);
    expect_saved_as(ctx, "both", "both.itd"); /* beside a directory */
    assert_int_equal(rmdir(in_folder("both")), 0);
    assert_int_equal(ix__save(ctx, in_folder("q.wrl"), o, NULL), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "\"wrl\" cannot be"));
    assert_int_equal(ix__save(ctx, in_folder("q.igs.gz"), o, NULL), IX_EARG);
    assert_int_equal(ix__load(ctx, in_folder("q.stl"), NULL, &p), IX_EARG);
    assert_null(p);
    assert_int_equal(ix__load(ctx, in_folder("absent"), NULL, &p), IX_EIO);
    assert_null(p);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* Files hold what can be read back, whatever the caller's options are for. */
static void test_save_refuses(void **state)
{
    const ix_write_opts dump = {.float_format = "%.3g"};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, HUGE_VAL), *p;
    int files = count_files();

    (void)state;
    assert_int_equal(ix__save(ctx, in_folder("inf"), o, &dump), IX_EDOMAIN);
    assert_int_equal(count_files(), files);
    o->u.num = 1 / 3.0;
    ASSERT_OK(ctx, ix__save(ctx, in_folder("third"), o, &dump));
    ASSERT_OK(ctx, ix__load(ctx, in_folder("third"), NULL, &p));
    assert_true(p->u.num == 0.333);
    ix__obj_unref(ctx, o);
    ix__obj_unref(ctx, p);
    ix_ctx_free(ctx);
}

/* --- memory ----------------------------------------------------------- */

/* Law: beside the objects, no file takes more than 1 MB, to save or to load. */
static void test_bounded(void **state)
{
    static const char *const names[] = {"m.itd", "m.itd.gz", "m.xml",
                                        "m.xml.gz"};
    const size_t beside = 1000000;

    (void)state;
    for (int i = 0; i < 4; i++) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);
        ix_obj *o = large(ctx), *p;
        size_t objects = ctx->live;
        struct stat sb;

        ix_ctx_set_memory_limit(ctx, objects + beside);
        ASSERT_OK(ctx, ix__save(ctx, in_folder(names[i]), o, NULL));
        assert_int_equal(stat(in_folder(names[i]), &sb), 0);
        assert_true(sb.st_size > 500000);
        ix__obj_unref(ctx, o);
        ASSERT_OK(ctx, ix__load(ctx, in_folder(names[i]), NULL, &p));
        assert_int_equal(p->u.list.n, 20);
        ix__obj_unref(ctx, p);
        ix_ctx_free(ctx);
        assert_int_equal(unlink(in_folder(names[i])), 0);
    }
}

static void fault_setup(ix_ctx *ctx, void *state)
{
    ix_obj **o = state;
    ix_rng r = ix_rng_new(3);

    o[0] = ix_rand_obj_of(ctx, &r, IX_OBJ_LIST, 1);
    o[1] = NULL;
    assert_non_null(o[0]);
}

static ix_status fault_run(ix_ctx *ctx, void *state)
{
    ix_obj **o = state;

    IX_TRY(ix__save(ctx, in_folder("f.itd.gz"), o[0], NULL));
    return ix__load(ctx, in_folder("f.itd.gz"), NULL, &o[1]);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    ix_obj **o = state;

    ix__obj_unref(ctx, o[0]);
    ix__obj_unref(ctx, o[1]);
}

static void test_faults(void **state)
{
    ix_obj *o[2];
    ix_fault_case c = {fault_setup, fault_run, fault_teardown, o};
    int files = count_files();

    (void)state;
    assert_true(ix_fault_run(&c) > 10);
    assert_int_equal(count_files(), files + 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round),      cmocka_unit_test(test_mode),
        cmocka_unit_test(test_unreadable), cmocka_unit_test(test_unwritable),
        cmocka_unit_test(test_full),       cmocka_unit_test(test_cancel),
        cmocka_unit_test(test_suffixes),   cmocka_unit_test(test_save_refuses),
        cmocka_unit_test(test_bounded),    cmocka_unit_test(test_killed),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
