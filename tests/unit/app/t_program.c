/* Tests of src/app: exit codes, standard streams, signals, options. They run
 * the program that was built with them; without one they are skipped. */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "harness/test.h"

static char program[4096], home[64];

static void put(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");

    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

#define HELLO "printf(\"hello\\\\n\", nil())"

/* build/CFG/tests/unit/app/t_program belongs to build/CFG/iritx. */
static int find_program(void **state)
{
    ssize_t n = readlink("/proc/self/exe", program, sizeof program - 20);

    (void)state;
    if (n < 0)
        return 1;
    program[n] = '\0';
    for (int i = 0; i < 4; i++)
        *strrchr(program, '/') = '\0';
    strcat(program, "/iritx");
    (void)strcpy(home, "/tmp/t_program.XXXXXX");
    if (!mkdtemp(home) || chdir(home) != 0)
        return 1;
    put("good.irt", HELLO ";\n");
    put("bad.irt", "a = 1 / 0;\n" HELLO ";\n");
    return 0;
}

static int leave(void **state)
{
    char command[100];

    (void)state;
    (void)snprintf(command, sizeof command, "rm -rf %s", home);
    return chdir("/") != 0 || system(command) != 0;
}

#define MAX_ARGS 8
typedef struct {
    const char *args[MAX_ARGS]; /* ended by NULL */
    const char *input;          /* NULL: none; else what stdin holds */
    const char *output;         /* NULL: caught; else a file; "-": closed */
    int signal;                 /* sent when it is at work */
} run_case;

typedef struct {
    int status; /* exit code, or -signal */
    char out[4096], err[4096];
} run_result;

static void child(const run_case *c, const int in[2], const int out[2],
                  const int err[2])
{
    char *argv[MAX_ARGS + 2] = {program};

    for (int i = 0; c->args[i]; i++)
        argv[i + 1] = strdup(c->args[i]);
    /* a background job or nohup may have them ignored */
    (void)signal(SIGINT, SIG_DFL);
    (void)signal(SIGHUP, SIG_DFL);
    (void)signal(SIGTERM, SIG_DFL);
    (void)dup2(in[0], 0);
    (void)dup2(out[1], 1);
    (void)dup2(err[1], 2);
    for (int i = 0; i < 2; i++) {
        (void)close(in[i]);
        (void)close(out[i]);
        (void)close(err[i]);
    }
    if (c->output)
        (void)close(1);
    if (c->output && strcmp(c->output, "-") != 0)
        (void)open(c->output, O_WRONLY | O_CREAT, 0600);
    (void)execv(program, argv);
    _exit(127);
}

static void read_all(int fd, char *buf, size_t size)
{
    size_t at = 0;
    ssize_t n;

    while (at < size - 1 && (n = read(fd, buf + at, size - 1 - at)) > 0)
        at += (size_t)n;
    buf[at] = '\0';
    (void)close(fd);
}

/* Does the process catch the signal? As Linux tells it. */
static bool catches(pid_t pid, int number)
{
    char path[64], line[256];
    unsigned long long mask = 0;
    FILE *f;

    (void)snprintf(path, sizeof path, "/proc/%ld/status", (long)pid);
    f = fopen(path, "r");
    while (f && fgets(line, sizeof line, f))
        if (strncmp(line, "SigCgt:", 7) == 0)
            mask = strtoull(line + 7, NULL, 16);
    if (f)
        (void)fclose(f);
    return mask >> (number - 1) & 1;
}

/* Sends it when the program is ready for it, which takes long where the machine
 * is busy, and has been at work for a moment. */
static void send_signal(pid_t pid, int number)
{
    const struct timespec moment = {0, 60000000};

    for (int i = 0; i < 200 && !catches(pid, number); i++)
        (void)nanosleep(&moment, NULL);
    (void)nanosleep(&moment, NULL);
    assert_int_equal(kill(pid, number), 0);
}

static run_result run(run_case c)
{
    run_result r = {.status = -1};
    int in[2], out[2], err[2], status;
    pid_t pid;

    if (access(program, X_OK) != 0)
        skip();
    assert_false(pipe(in) || pipe(out) || pipe(err));
    pid = fork();
    assert_true(pid >= 0);
    if (pid == 0)
        child(&c, in, out, err);
    (void)close(in[0]);
    (void)close(out[1]);
    (void)close(err[1]);
    if (c.input)
        assert_int_equal(write(in[1], c.input, strlen(c.input)),
                         (ssize_t)strlen(c.input));
    if (c.signal)
        send_signal(pid, c.signal);
    (void)close(in[1]);
    read_all(out[0], r.out, sizeof r.out);
    read_all(err[0], r.err, sizeof r.err);
    assert_int_equal(waitpid(pid, &status, 0), pid);
    r.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return r;
}
#define RUN(...) run((run_case){.args = {__VA_ARGS__, NULL}})

static void t_exit_codes(void **state)
{
    (void)state;
    assert_int_equal(RUN("good").status, 0);
    assert_int_equal(RUN("good.irt").status, 0);
    assert_int_equal(RUN("bad").status, 1);
    assert_int_equal(RUN("nosuch").status, 1);
    assert_int_equal(RUN("-e", "a = coord(point(1, 2, 3), 9)").status, 1);
    assert_int_equal(RUN("-e", "exit()").status, 0);
    assert_int_equal(RUN("--nosuch").status, 2);
    assert_int_equal(RUN("-e").status, 2);
    assert_int_equal(RUN("-D", "novalue").status, 2);
    assert_int_equal(RUN("--check=yes").status, 2);
    assert_int_equal(RUN("--degree-form", "best").status, 2);
    assert_int_equal(RUN("--threads", "-1").status, 2);
    assert_int_equal(RUN("--help", "nosuch").status, 2);
}

static void t_information(void **state)
{
    run_result r = RUN("--version");

    (void)state;
    assert_int_equal(strncmp(r.out, "iritx ", 6), 0);
    r = RUN("--help");
    assert_non_null(strstr(r.out, "--list-functions"));
    assert_int_equal(r.status, 0);
    r = RUN("draw", "--help");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, "usage: iritx draw FILE... -o PICTURE"));
    assert_non_null(strstr(r.out, "--shade"));
    assert_int_equal(RUN("info", "--help").status, 0);
    r = RUN("--help", "sin");
    assert_non_null(strstr(r.out, "SIN x:num -> num"));
    r = RUN("--list-functions");
    assert_non_null(strstr(r.out, "\nCHDIR"));
}

/* The first bad script ends the run; texts and scripts go in their order. */
static void t_order(void **state)
{
    run_result r = RUN("-e", "a = 1", "good", "-e", "a");

    (void)state;
    assert_string_equal(r.out, "hello\n"
                               "A          (1) - Numeric   type\n[OBJECT A\n"
                               "    [NUMBER 1]\n]\n");
    r = RUN("bad", "good");
    assert_string_equal(r.out, "");
    assert_string_equal(r.err, "bad.irt:1:7: error: division by zero\n"
                               "  a = 1 / 0;\n"
                               "        ^\n");
}

static void t_standard_input(void **state)
{
    run_result r = run((run_case){.args = {NULL}, .input = HELLO ";\n"});

    (void)state;
    assert_string_equal(r.out, "hello\n");
    r = run((run_case){.args = {"-"}, .input = HELLO ";\n" HELLO});
    assert_string_equal(r.out, "hello\n");
    assert_non_null(strstr(r.err, "<stdin>:2:"));
    assert_int_equal(r.status, 1);
    r = run((run_case){.args = {"-e", "a = getline(numeric_type); a + 1;"},
                       .input = "41\n"});
    assert_non_null(strstr(r.out, "[NUMBER 42]"));
}

/* Output that cannot be written is an error, whenever it is noticed. */
static void t_output_fails(void **state)
{
    run_result r;

    (void)state;
    if (access("/dev/full", W_OK) == 0) {
        r = run((run_case){.args = {"-e", HELLO}, .output = "/dev/full"});
        assert_int_equal(r.status, 1);
        assert_non_null(strstr(r.err, "cannot write standard output"));
        r = run((run_case){.args = {"-e", "for (i = 1, 1, 1e7, i)"},
                           .output = "/dev/full"});
        assert_int_equal(r.status, 1);
        assert_non_null(strstr(r.err, "cannot write the output"));
    }
    r = run((run_case){.args = {"-e", HELLO}, .output = "-"});
    assert_int_equal(r.status, 1);
    /* a file that is saved must not become standard output */
    r = run(
        (run_case){.args = {"-e", "save(\"s\", 1); " HELLO}, .output = "-"});
    assert_int_equal(r.status, 1);
    assert_int_equal(RUN("-e", "a = load(\"s\"); a;").status, 0);
}

/* The reader of a pipe has left: end at once, without a word. */
static void t_broken_pipe(void **state)
{
    char command[5000];
    FILE *f;
    char text[1000];
    size_t n;

    (void)state;
    if (access(program, X_OK) != 0)
        skip();
    (void)snprintf(command, sizeof command,
                   "{ %s -e 'for (i = 1, 1, 1e9, i)' 2>err; echo $? >rc; } | "
                   "head -1; cat err rc",
                   program);
    f = popen(command, "r");
    assert_non_null(f);
    n = fread(text, 1, sizeof text - 1, f);
    text[n] = '\0';
    (void)pclose(f);
    assert_string_equal(text, "I          (1) - Numeric   type\n1\n");
}

static void t_signals(void **state)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};

    (void)state;
    for (size_t i = 0; i < 3; i++) {
        run_result r = run(
            (run_case){.args = {"-e", "x = 0; while (1, x = x + 1)"},
                       .signal = signals[i]});

        assert_int_equal(r.status, 128 + signals[i]);
        assert_non_null(strstr(r.err, "interrupted"));
        r = run((run_case){.args = {"-"}, .signal = signals[i]});
        assert_int_equal(r.status, 128 + signals[i]);
    }
}

/* What was viewed is saved, but not after an error. */
static void t_viewed(void **state)
{
    (void)state;
    assert_int_equal(RUN("-o", "v.itd", "-e", "viewobj(point(1, 2, 3))").status,
                     0);
    assert_non_null(strstr(RUN("-e", "a = load(\"v\"); a").out, "POINT 1 2 3"));
    assert_int_equal(
        RUN("-o", "w.itd", "-e", "viewobj(point(1, 2, 3)); a = 1 / 0").status,
        1);
    assert_int_equal(access("w.itd", F_OK), -1);
    assert_int_equal(RUN("-o", "nosuch/w.itd", "-e", "viewobj(1)").status, 1);
    (void)RUN("-o", "two.itd", "-e", "viewobj(1); viewobj(2)");
    assert_non_null(strstr(RUN("-e", "a = load(\"two\"); s = sizeof(a); s").out,
                           "[NUMBER 2]"));
}

static void t_limits(void **state)
{
    run_result r = RUN("--max-memory", "20", "-e",
                       "l = nil(); while (1, snoc(\"some words\", l))");

    (void)state;
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.err, "memory limit of 20 MB"));
    r = RUN("--max-steps=100", "-e", "while (1, x = 1)");
    assert_int_equal(r.status, 1);
    assert_int_equal(RUN("--degree-form=irit", "-e",
                         "a = iritstate(\"DegreeForm\", 0); if (a != 3, "
                         "error(\"\"))")
                         .status,
                     0);
    assert_int_equal(RUN("--root", "nosuch", "-e", "a = 1").status, 1);
    assert_int_equal(RUN("--root", "/tmp", "-e", "save(\"s\", 1)").status, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_exit_codes),   cmocka_unit_test(t_information),
        cmocka_unit_test(t_order),        cmocka_unit_test(t_standard_input),
        cmocka_unit_test(t_output_fails), cmocka_unit_test(t_broken_pipe),
        cmocka_unit_test(t_signals),      cmocka_unit_test(t_viewed),
        cmocka_unit_test(t_limits),
    };

    return cmocka_run_group_tests(tests, find_program, leave);
}
