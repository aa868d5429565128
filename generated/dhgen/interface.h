/* SPDX-License-Identifier: MIT
 *
 * What a robot's file and the runtime agree on: the number of their interface, statuses, and the
 * marks of functions and tables. */
#ifndef DHGEN_INTERFACE_H
#define DHGEN_INTERFACE_H

#ifdef __CUDACC_RTC__ /* its functions are built in, without headers, but not their constants */
#ifndef NAN
#define NAN __builtin_bit_cast(float, 0x7fc00000u)
#define INFINITY __builtin_bit_cast(float, 0x7f800000u)
#ifndef DHGEN_SINGLE_PRECISION
#define HUGE_VAL ((double)INFINITY)
#else
#define HUGE_VALF INFINITY
#endif
#endif
#else
#include <math.h>
#include <stddef.h>
#endif

/* NaN and infinity mark what is no solution and no limit: a compiler that assumes that they don't
 * exist makes solutions of poses that are out of reach. */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "dhgen needs NaN and infinity: compile without -ffast-math and -ffinite-math-only"
#endif

/* A robot's file names the interface that it was generated for. */
#define DHGEN_INTERFACE 1
#if defined(DHGEN_EXPECTS) && DHGEN_EXPECTS != DHGEN_INTERFACE
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

/* Marks. DHGEN_INLINE marks what is called in the fast path, DHGEN_FN all other functions of the
 * runtime, DHGEN_SMALL functions that kernels of CUDA call, too, DHGEN_APART functions that must
 * not be inlined, for their stack and code, DHGEN_TABLE constant tables, DHGEN_PUBLIC a robot's
 * public functions, DHGEN_API what robots' files call: with -DDHGEN_SHARED that is compiled once
 * for all of them, in dhgen.c, and their files have its declarations only.
 *
 * In CUDA functions are for both sides, and tables are where they are read. What is not called in
 * the fast path is a call there: inlined it compiles for minutes. */
#if defined(__GNUC__) || defined(__CUDACC__)
#define DHGEN_UNUSED __attribute__((unused))
#else
#define DHGEN_UNUSED
#endif
#ifndef DHGEN_PUBLIC
#ifdef __CUDACC__
#define DHGEN_PUBLIC __host__ __device__
#else
#define DHGEN_PUBLIC
#endif
#endif
#if defined(__CUDACC__)
#define DHGEN_NOINLINE __noinline__
#define DHGEN_ALWAYS
#define DHGEN_FN DHGEN_PUBLIC DHGEN_NOINLINE DHGEN_UNUSED static
#ifdef __CUDA_ARCH__
#define DHGEN_TABLE __device__ static const
#endif
#elif defined(__GNUC__)
#define DHGEN_NOINLINE __attribute__((noinline))
#define DHGEN_ALWAYS __attribute__((always_inline))
#else
#define DHGEN_NOINLINE
#define DHGEN_ALWAYS
#endif
#ifndef DHGEN_FN
#define DHGEN_FN DHGEN_UNUSED static
#endif
#ifndef DHGEN_SMALL
#ifdef __CUDACC__
#define DHGEN_SMALL DHGEN_PUBLIC DHGEN_UNUSED static inline
#else
#define DHGEN_SMALL DHGEN_FN
#endif
#endif
#ifndef DHGEN_INLINE
#define DHGEN_INLINE DHGEN_PUBLIC DHGEN_UNUSED static inline
#endif
#ifndef DHGEN_APART
#define DHGEN_APART DHGEN_PUBLIC DHGEN_NOINLINE DHGEN_UNUSED static
#endif
#ifndef DHGEN_TABLE
#define DHGEN_TABLE static const
#endif
#ifndef DHGEN_API
#if defined(DHGEN_SHARED) && defined(__cplusplus)
#define DHGEN_API extern "C"
#elif defined(DHGEN_SHARED)
#define DHGEN_API
#else
#define DHGEN_API DHGEN_APART
#endif
#endif

/* The mask of all 8 lanes: g++ 12 warns inside its own headers of what has none, and makes the same
 * of both. */
#define DHGEN_EACH (__mmask8)0xff

/* What is no solution. */
#define DHGEN_NAN ((double)NAN)

#define DHGEN_TURN 6.283185307179586
#define DHGEN_HALF_TURN 3.141592653589793

/* The statuses of rows. The last three are a solver's notes to the runtime: no caller sees them. */
enum {
    DHGEN_OK,
    DHGEN_UNREACHABLE,
    DHGEN_FREE_JOINT,
    DHGEN_OUT_OF_LIMITS,
    DHGEN_INVALID_POSE,
    DHGEN_CLOSE = 64,  /* roots nearly meet: the row may lie between two solutions */
    DHGEN_LOST = 128,  /* + j: the row was lost after joint j had been chosen freely */
    DHGEN_NEARLY = 192 /* + j: the same, joint j is nearly free, and q[1] of the row is its angle */
};

/* Notes why a row is lost, and how far it is from a solution: negative out of reach, positive where
 * it misses the pose. */
DHGEN_INLINE void dhgen_lose(int why, double off, double *q, unsigned char *status)
{
    *status = (unsigned char)why;
    q[0] = off;
}

/* The angle moved by whole turns to (-pi, pi]. */
DHGEN_INLINE double dhgen_wrap(double angle)
{
    return angle - DHGEN_TURN * ceil(angle / DHGEN_TURN - 0.5);
}

#endif
