/* call.h - built-in functions called by their name, not from a script: what
 * iritx answers to another program. */
#ifndef LANG_CALL_H
#define LANG_CALL_H

#include "lang/types_impl.h"

/* The value of a function of the tables or of a plug-in, any case. argv
 * borrowed; *out a new reference. Err IX_EARG there is no such function, it is
 * not offered (IX_B_LOCAL, procedures), wrong number or types of arguments (as
 * in scripts: "argument 2 of EVOLUTE must be a curve, got a number");
 * IX_EUNABLE it gives no value; what the function fails with, its name in
 * front. */
ix_status ix__call_by_name(ix_interp *in, const char *name, int argc,
                           ix_obj **argv, ix_obj **out) IX_MUST_CHECK;
/* Must it be called in the process that keeps the states (IX_B_STATE)? */
bool ix__call_keeps_state(const char *name);

/* --- the same steps, for scripts ------------------------------------------ */
/* "NAME takes 2 arguments, got 1: NAME(...)" unless n is right. */
ix_status ix__call_count(ix_ctx *ctx, const ix__bi *bi, int n) IX_MUST_CHECK;
/* The message about argument i (0-based) of a set of wrong types; IX_EARG. */
ix_status ix__arg_mismatch(ix_interp *in, const ix__bi *bi, int i,
                           ix__types got);
/* The first of the arguments whose type is wrong, argc if none is. */
int ix__call_misfit(const ix__bi *bi, int argc, ix_obj *const *argv);
/* Runs the C function; c->result is NULL if it fails. */
ix_status ix__call_run(const ix__bi *bi, ix_call *c) IX_MUST_CHECK;
/* Puts "NAME: " or "argument N of NAME: " before the message of a failure st;
 * true if it names an argument. */
bool ix__call_blame(const ix__bi *bi, const ix_call *c, ix_status st);

#endif
