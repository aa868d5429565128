/* SPDX-License-Identifier: MIT
 *
 * The general algorithm and the numerical solver, compiled once for all robots: with
 * -DDHGEN_SHARED, as their files. */
#ifndef DHGEN_SHARED
#error \
    "dhgen/general.c is for several robots in one program: compile it and them with -DDHGEN_SHARED"
#endif
#define DHGEN_BODIES

#include "serial.h"
#include "general.h"
#include "numerical.h"
