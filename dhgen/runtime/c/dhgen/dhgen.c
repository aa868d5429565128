/* SPDX-License-Identifier: MIT
 *
 * The runtime compiled once for all robots of a program: for files that are compiled with
 * -DDHGEN_SHARED. */
#undef DHGEN_SHARED
#ifdef __cplusplus
#define DHGEN_API extern "C"
#else
#define DHGEN_API
#endif
#include "serial.h"
#include "complete.h"
#include "ik.h"
#include "velocities.h"
