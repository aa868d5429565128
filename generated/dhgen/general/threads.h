/* SPDX-License-Identifier: MIT
 *
 * Lanes that are threads: one number of each of DHGEN_GROUP threads of a warp on a GPU, which solve
 * one pose together.
 *
 * Each of them computes for itself what is outside lanes, from the same numbers, so that all take
 * the same branches: what is asked of lanes is a vote, with one answer for all. Arrays by which
 * threads learn of each other's numbers, and large ones, are in the group's room in shared memory,
 * where those that are not needed at once share a place. All threads meet before and after lanes
 * are stored there, and where an array begins. What is outside lanes is written there by all of
 * them: between two meetings one value to a place, which none has read before. */
#ifndef DHGEN_GENERAL_THREADS_H
#define DHGEN_GENERAL_THREADS_H

#include "../interface.h"

/* What nvcc makes for the host has no groups. */
#if defined(DHGEN_GROUP) && (!defined(__CUDACC__) || defined(__CUDA_ARCH__))
#define DHGEN_LANES_ARE_THREADS
#if DHGEN_GROUP != 8 && DHGEN_GROUP != 16 && DHGEN_GROUP != 32
#error "a group of threads is DHGEN_GROUP 8, 16 or 32"
#endif
#define DHGEN_GENERAL_LANES DHGEN_GROUP

typedef double dhgen_lane;
typedef int dhgen_mask;
#define DHGEN_ALIGNED

/* Where in a room arrays are: after what stays, those of the equations, of the circle and of
 * candidates, which are not needed at once. */
enum {
    DHGEN_ROOM_E = 0,
    DHGEN_ROOM_BOARD = 192, /* 8 rows of lanes, for what is looked at soon */
    DHGEN_ROOM_PRODUCT = DHGEN_ROOM_BOARD,
    DHGEN_ROOM_SHARED = DHGEN_ROOM_BOARD + 8 * DHGEN_GROUP,

    DHGEN_ROOM_LEFT = DHGEN_ROOM_SHARED,
    DHGEN_ROOM_X = DHGEN_ROOM_LEFT + 480,
    DHGEN_ROOM_Y = DHGEN_ROOM_X + 240,
    DHGEN_ROOM_A = DHGEN_ROOM_Y + 240,
    DHGEN_ROOM_ALL = DHGEN_ROOM_Y,   /* Y is not needed any more then, */
    DHGEN_ROOM_RIGHT = DHGEN_ROOM_X, /* nor X */
    DHGEN_ROOM_EQUATIONS_END = DHGEN_ROOM_ALL + 405,

    DHGEN_ROOM_HARMONICS = DHGEN_ROOM_SHARED, /* before the circle is searched */
    DHGEN_ROOM_SAMPLES = DHGEN_ROOM_HARMONICS + 24,
    DHGEN_ROOM_GRID = DHGEN_ROOM_SHARED,
    DHGEN_ROOM_TURNING = DHGEN_ROOM_GRID + 528,
    DHGEN_ROOM_CROSSING = DHGEN_ROOM_TURNING + 160,
    DHGEN_ROOM_CELLS = DHGEN_ROOM_CROSSING + 480, /* 11 rows of lanes */
    DHGEN_ROOM_CIRCLE_END = DHGEN_ROOM_CELLS + 11 * DHGEN_GROUP,

    DHGEN_ROOM_CANDIDATES = DHGEN_ROOM_SHARED, /* or ways, or 12 rows of lanes with starts */
    DHGEN_ROOM_CANDIDATES_END = DHGEN_ROOM_CANDIDATES + (DHGEN_GROUP < 32 ? 1152 : 1280),

    /* the largest of these, whatever the group */
    DHGEN_ROOM_SIZE = DHGEN_ROOM_CIRCLE_END
};

/* Rows of lanes there. */
#define DHGEN_BOARD(row) (DHGEN_ROOM_BOARD + (row)*DHGEN_GROUP)
#define DHGEN_CELL_BOARD(row) (DHGEN_ROOM_CELLS + (row)*DHGEN_GROUP)
#define DHGEN_STARTS_BOARD(row) (DHGEN_ROOM_CANDIDATES + (row)*DHGEN_GROUP)

/* Which thread of its group this is. */
DHGEN_INLINE int dhgen_thread(void)
{
    return (int)(threadIdx.x % DHGEN_GROUP);
}

/* The threads of the group, as bits of the warp. */
DHGEN_INLINE unsigned dhgen_group(void)
{
    return 0xffffffffu >> (32 - DHGEN_GROUP) << (threadIdx.x % 32 / DHGEN_GROUP * DHGEN_GROUP);
}

/* All threads of the group meet, and know what each has written before. */
DHGEN_INLINE void dhgen_meet(void)
{
    __syncwarp(dhgen_group());
}

/* An array of the group's room in a block of 32 threads, of which nobody needs any more what was
 * there before. */
DHGEN_INLINE double *dhgen_room(int place)
{
    __shared__ double rooms[32 / DHGEN_GROUP][DHGEN_ROOM_SIZE];
    dhgen_meet();
    return rooms[threadIdx.x / DHGEN_GROUP] + place;
}

/* Arrays of numbers in the group's room, tables, lanes, and rows of lanes; members of a structure,
 * and where these are. What is zero elsewhere is not here: nothing is read that was not written. */
#define DHGEN_IN_ROOM(name, count, place) double *const name = dhgen_room(place)
#define DHGEN_ZEROS_IN_ROOM(name, count, place) DHGEN_IN_ROOM(name, count, place)
#define DHGEN_TABLE_IN_ROOM(name, rows, columns, place) \
    double(*const name)[columns] = (double(*)[columns])dhgen_room(place)
#define DHGEN_ZERO_TABLE_IN_ROOM(name, rows, columns, place) \
    DHGEN_TABLE_IN_ROOM(name, rows, columns, place)
#define DHGEN_LANES_IN_ROOM(name, place) DHGEN_IN_ROOM(name, DHGEN_GROUP, place)
#define DHGEN_ROWS_IN_ROOM(name, rows, place) DHGEN_TABLE_IN_ROOM(name, rows, DHGEN_GROUP, place)
#define DHGEN_KINDS_IN_ROOM(name, place) int *const name = (int *)dhgen_room(place)
#define DHGEN_MEMBER(name, count) double *name
#define DHGEN_MEMBER_ROWS(name, rows, count) double *name[rows]
#define DHGEN_PLACE_GRID(grid) \
    ((grid)->value = dhgen_room(DHGEN_ROOM_GRID), (grid)->slope = (grid)->value + 264)
#define DHGEN_PLACE_PARTS(parts, place, length) \
    do { \
        double *const at = dhgen_room(place); \
        (parts)->c = at; \
        (parts)->s = at + (length); \
        (parts)->width = at + 2 * (length); \
        (parts)->start = at + 3 * (length); \
        for (int i = 0; i < 3; i++) { \
            (parts)->low[i] = at + (4 + i) * (length); \
            (parts)->high[i] = at + (7 + i) * (length); \
        } \
    } while (0)
#define DHGEN_PLACE_ROWS(of, rows, count, length) \
    do { \
        double *const at = dhgen_room(DHGEN_ROOM_CANDIDATES); \
        (of)->c = at; \
        (of)->s = at + (length); \
        for (int i = 0; i < (count); i++) { \
            (of)->rows[i] = at + (2 + i) * (length); \
        } \
    } while (0)

/* From where to where a thread's loop over lanes goes: itself. */
#define DHGEN_FIRST_LANE dhgen_thread()
#define DHGEN_END_LANE (dhgen_thread() + 1)
#define DHGEN_MEET() dhgen_meet()

/* Loads a thread's own number, of so many; threads beyond have the first one. */
DHGEN_INLINE dhgen_lane dhgen_lane_load(const double *from, int count)
{
    return from[dhgen_thread() < count ? dhgen_thread() : 0];
}

/* Stores lanes, so many of them. */
DHGEN_INLINE void dhgen_lane_store(double *to, dhgen_lane x, int count)
{
    dhgen_meet();
    if (dhgen_thread() < count) {
        to[dhgen_thread()] = x;
    }
    dhgen_meet();
}

/* Lanes behind those that count are not in the arrays. */
#define DHGEN_LANES_BEHIND 0
#define DHGEN_LOAD(from) (from)[dhgen_thread()]
#define DHGEN_STORE(to, x) dhgen_lane_store(to, x, DHGEN_GROUP)
#define DHGEN_LOAD_SOME(from, count) dhgen_lane_load(from, count)
#define DHGEN_STORE_SOME(to, x, count) dhgen_lane_store(to, x, count)

/* The number of one lane. */
DHGEN_INLINE double dhgen_lane_number(dhgen_lane x, int lane)
{
    return __shfl_sync(dhgen_group(), x, lane, DHGEN_GROUP);
}

/* Stores lanes, so many of them, in an array that each thread has for itself. */
DHGEN_INLINE void dhgen_lane_spread(double *to, dhgen_lane x, int count)
{
    for (int k = 0; k < DHGEN_GROUP && k < count; k++) {
        to[k] = dhgen_lane_number(x, k);
    }
}

#define DHGEN_SPREAD(to, x, count) dhgen_lane_spread(to, x, count)

/* Numbers from one on, one a lane, as far as there are any; the first one behind. */
DHGEN_INLINE dhgen_lane dhgen_lane_from(const double *numbers, int from, int count)
{
    return dhgen_lane_load(numbers + from, count - from);
}

/* The largest number of all lanes; NaN where all are. */
DHGEN_INLINE double dhgen_lane_largest(dhgen_lane x)
{
    for (int step = DHGEN_GROUP / 2; step > 0; step /= 2) {
        const double other = __shfl_xor_sync(dhgen_group(), x, step, DHGEN_GROUP);
        x = other > x || isnan(x) ? other : x;
    }
    return dhgen_lane_number(x, 0);
}

/* Whether a number of some lane is above another one. */
DHGEN_INLINE int dhgen_lane_any_above(dhgen_lane a, dhgen_lane b)
{
    return __any_sync(dhgen_group(), a > b) != 0;
}

/* Bits of many numbers, lane after lane. */
typedef unsigned long long dhgen_lane_bits;

DHGEN_INLINE void dhgen_lane_add_bits(dhgen_lane_bits *bits, dhgen_mask set, int from)
{
    const unsigned all = __ballot_sync(dhgen_group(), set) & dhgen_group();
    const unsigned own = all >> (threadIdx.x % 32 / DHGEN_GROUP * DHGEN_GROUP);
    *bits |= (dhgen_lane_bits)own << from;
}
#endif

#endif
