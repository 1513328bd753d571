/* The corpus of the text reader's fuzzer and the sample files, whole, cut, and
 * with pieces exchanged, under the fuzzer's own law. */
#include <dirent.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/fz_itd.c"
#include "harness/test.h"

#define MOST 65536

static size_t read_all(const char *dir, const char *name, uint8_t *data)
{
    char path[512];
    FILE *f;
    size_t n;

    (void)snprintf(path, sizeof path, "%s/%s", dir, name);
    f = fopen(path, "rb");
    assert_non_null(f);
    n = fread(data, 1, MOST, f);
    assert_int_equal(fclose(f), 0);
    return n;
}

/* Each file as it is, and cut in the middle of something. */
static int replay(const char *dir)
{
    static uint8_t data[MOST];
    DIR *d = opendir(dir);
    int n = 0;

    assert_non_null(d);
    for (struct dirent *e; (e = readdir(d));) {
        size_t size;

        if (e->d_name[0] == '.')
            continue;
        size = read_all(dir, e->d_name, data);
        (void)LLVMFuzzerTestOneInput(data, size);
        (void)LLVMFuzzerTestOneInput(data, size / 2);
        n++;
    }
    closedir(d);
    return n;
}

static void test_corpus(void **state)
{
    (void)state;
    assert_true(replay("tests/fuzz/itd") > 20);
}

static void test_samples(void **state)
{
    (void)state;
    assert_true(replay("tests/data/itd") > 50);
}

/* Copies a piece of the file over another place, some times. */
static void shuffle(ix_rng *r, uint8_t *data, size_t size)
{
    for (int i = ix_rng_int(r, 1, 4); i > 0; i--) {
        size_t from = (size_t)ix_rng_int(r, 0, (int)size - 1);
        size_t to = (size_t)ix_rng_int(r, 0, (int)size - 1);
        size_t last = from > to ? from : to;
        size_t n = (size_t)ix_rng_int(r, 1, 40);

        memmove(data + to, data + from, n < size - last ? n : size - last);
    }
}

static void test_shuffled(void **state)
{
    static uint8_t whole[2 * MOST], data[2 * MOST];
    ix_rng r = ix_rng_new(0xf22);
    size_t size = read_all("tests/data/itd", "spec-08-basics.itd", whole);

    (void)state;
    size += read_all("tests/data/itd", "spec-07-polys.itd", whole + size);
    for (int i = 0; i < 500; i++) {
        memcpy(data, whole, size);
        shuffle(&r, data, size);
        (void)LLVMFuzzerTestOneInput(data, size);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_corpus),
                                       cmocka_unit_test(test_samples),
                                       cmocka_unit_test(test_shuffled)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
