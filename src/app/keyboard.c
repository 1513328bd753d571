/* keyboard.c - waiting for a person: signals are held back except while the
 * program sleeps, so that none can arrive between the look at the flag and the
 * sleep. */
#define _POSIX_C_SOURCE 200809L
#include "app/keyboard.h"

#include <signal.h>
#include <sys/select.h>
#include <unistd.h>

bool keyboard_wait(const volatile int *cancel)
{
    static const int held[] = {SIGINT, SIGTERM, SIGHUP, SIGWINCH, SIGCONT};
    sigset_t block, before;
    fd_set in;
    bool ready = false;

    (void)sigemptyset(&block);
    for (size_t i = 0; i < sizeof held / sizeof *held; i++)
        (void)sigaddset(&block, held[i]);
    (void)sigprocmask(SIG_BLOCK, &block, &before);
    FD_ZERO(&in);
    FD_SET(STDIN_FILENO, &in);
    if (!*cancel)
        ready = pselect(STDIN_FILENO + 1, &in, NULL, NULL, NULL, &before) > 0;
    (void)sigprocmask(SIG_SETMASK, &before, NULL);
    return ready;
}
