/* keyboard.h - waiting for a person. */
#ifndef APP_KEYBOARD_H
#define APP_KEYBOARD_H

#include <stdbool.h>

/* Waits until standard input can be read (or has ended). False: a signal came
 * instead, or *cancel was set already; none is missed in between. */
bool keyboard_wait(const volatile int *cancel);

#endif
