/* SPDX-License-Identifier: MIT
 *
 * The driven joints alone of all solutions of all legs: of one pose with legs side by side, of a
 * batch with poses side by side. Poses that need care are left to the legs' own solvers.
 *
 * The file that includes this one defines how many legs there are (DHGEN_LEGS), how many rows the
 * leg with the most has, and how many driven joints (DHGEN_LEG_ROWS, DHGEN_LEG_DRIVES). */
#ifndef DHGEN_DRIVES_H
#define DHGEN_DRIVES_H

#include "lanes.h"
#include "parallel.h"

enum {
    DHGEN_LEG_SIZE = DHGEN_LEG_ROWS * DHGEN_LEG_DRIVES,
    /* of tables by legs: lanes may be read behind the last one */
    DHGEN_LEG_COLUMNS = DHGEN_LEGS + 7
};

/* The legs by their chains. */
struct dhgen_leg_lanes {
    int chains;
    const int *first;                        /* leg of each chain, and of none behind the last */
    const size_t *legs;                      /* one chain's after another's */
    const double (*base)[DHGEN_LEG_COLUMNS]; /* their frames, an entry a line */
    const double (*end)[DHGEN_LEG_COLUMNS];
};

/* The driven joints of legs of a chain: their values, NaN without a solution, statuses, and whether
 * a lane needs care. */
typedef dhgen_wide_mask dhgen_solve_driven(
    int chain, const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind);

/* What a leg carries, in its own base, as in dhgen_leg_pose. */
DHGEN_ALWAYS
DHGEN_INLINE void dhgen_leg_pose_wide(const struct dhgen_leg *leg, const dhgen_wide *base,
    const dhgen_wide *end, const dhgen_wide *X, dhgen_wide *T)
{
    const int turns = leg->counted[leg->joints - 1] >= 3;
    const dhgen_wide zero = dhgen_all_wide(0.0);
    T[12] = T[13] = T[14] = zero;
    T[15] = dhgen_all_wide(1.0);
    DHGEN_WRITTEN_OUT
    for (int j = 0; j < 4; j++) {
        if (j < 3 && !turns) {
            T[j] = T[4 + j] = T[8 + j] = zero;
            continue;
        }
        dhgen_wide carried[3];
        DHGEN_WRITTEN_OUT
        for (int i = 0; i < 3; i++) {
            carried[i] = X[4 * i] * end[j] + X[4 * i + 1] * end[4 + j] + X[4 * i + 2] * end[8 + j];
            carried[i] = j < 3 ? carried[i] : carried[i] + X[4 * i + 3];
        }
        DHGEN_WRITTEN_OUT
        for (int i = 0; i < 3; i++) {
            T[4 * i + j] = base[4 * i] * carried[0] + base[4 * i + 1] * carried[1]
                + base[4 * i + 2] * carried[2];
            T[4 * i + j] = j < 3 ? T[4 * i + j] : T[4 * i + j] + base[4 * i + 3];
        }
    }
}

/* Solves lanes of a chain; rows that it has not are none. */
DHGEN_ALWAYS
DHGEN_INLINE unsigned dhgen_driven_rows(const struct dhgen_leg *leg, dhgen_solve_driven *solve,
    int chain, const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    const dhgen_wide none = dhgen_all_wide(DHGEN_NAN);
    DHGEN_WRITTEN_OUT
    for (int i = leg->rows * leg->drives < DHGEN_LEG_SIZE ? 0 : DHGEN_LEG_SIZE; i < DHGEN_LEG_SIZE;
         i++)
        q[i] = none;
    DHGEN_WRITTEN_OUT
    for (int row = leg->rows; row < DHGEN_LEG_ROWS; row++)
        kind[row] = dhgen_kind_wide(none);
    return dhgen_bits_wide(solve(chain, T, q, kind));
}

/* Writes the rows of lanes, as many as are counted, each to its place among legs. */
DHGEN_ALWAYS
DHGEN_INLINE void dhgen_store_driven(const dhgen_wide *found, const dhgen_wide_mask *kind,
    int count, const size_t *place, double *q, unsigned char *status)
{
#if DHGEN_LANES > 1
#if DHGEN_LEG_ROWS * DHGEN_LEG_DRIVES >= DHGEN_LANES
    DHGEN_WRITTEN_OUT
    for (int i = 0; i < DHGEN_LEG_SIZE; i += DHGEN_LANES) {
        const int from = i + DHGEN_LANES <= DHGEN_LEG_SIZE ? i : DHGEN_LEG_SIZE - DHGEN_LANES;
        dhgen_wide x[DHGEN_LANES];
        DHGEN_WRITTEN_OUT
        for (int k = 0; k < DHGEN_LANES; k++)
            x[k] = found[from + k];
        dhgen_transpose(x);
        DHGEN_WRITTEN_OUT
        for (int k = 0; k < count; k++)
            *(dhgen_wide_at *)(q + DHGEN_LEG_SIZE * place[k] + from) = x[k];
    }
#else
    DHGEN_WRITTEN_OUT
    for (int k = 0; k < count; k++)
        DHGEN_WRITTEN_OUT
    for (int i = 0; i < DHGEN_LEG_SIZE; i++)
        q[DHGEN_LEG_SIZE * place[k] + (size_t)i] = found[i][k];
#endif
    DHGEN_WRITTEN_OUT
    for (int first = 0; first < DHGEN_LEG_ROWS; first += 8) {
        const int size = DHGEN_LEG_ROWS - first < 8 ? DHGEN_LEG_ROWS - first : 8;
        dhgen_wide_mask words = kind[first];
        DHGEN_WRITTEN_OUT
        for (int i = 1; i < size; i++)
            words |= kind[first + i] << 8 * i;
        DHGEN_WRITTEN_OUT
        for (int k = 0; k < count; k++) {
            const long long word = words[k];
            __builtin_memcpy(status + DHGEN_LEG_ROWS * place[k] + first, &word, (size_t)size);
        }
    }
#else
    (void)count;
    DHGEN_WRITTEN_OUT
    for (int i = 0; i < DHGEN_LEG_SIZE; i++)
        q[DHGEN_LEG_SIZE * place[0] + (size_t)i] = found[i];
    DHGEN_WRITTEN_OUT
    for (int row = 0; row < DHGEN_LEG_ROWS; row++)
        status[DHGEN_LEG_ROWS * place[0] + (size_t)row] = (unsigned char)kind[row];
#endif
}

/* The driven joints of a leg by its own solver. Returns 0 where the pose is none of its. */
DHGEN_APART int dhgen_driven_with_care(const struct dhgen_parallel *robot, int number,
    const double *X, double *q, unsigned char *status)
{
    const struct dhgen_leg *const leg = robot->leg + number;
    double pose[16], rows[DHGEN_MOST_ROWS * DHGEN_MOST_JOINTS];
    unsigned char statuses[DHGEN_MOST_ROWS];
    dhgen_leg_pose(leg, X, pose);
    const int count = leg->ik(pose, NULL, rows, statuses);
    for (int row = 0; row < DHGEN_LEG_ROWS; row++) {
        const int has = row < leg->rows;
        double *const drives = q + row * DHGEN_LEG_DRIVES;
        status[row] = has ? statuses[row] : (unsigned char)DHGEN_UNREACHABLE;
        for (int k = 0; k < DHGEN_LEG_DRIVES; k++)
            drives[k] = DHGEN_NAN;
        if (has)
            dhgen_leg_drives(leg, rows + row * leg->joints, drives);
    }
    return count >= 0;
}

/* Of a chain without a program for regular poses: no solutions, and all lanes need care. */
DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask dhgen_all_with_care(dhgen_wide *q, dhgen_wide_mask *kind)
{
    for (int i = 0; i < DHGEN_LEG_SIZE; i++)
        q[i] = dhgen_all_wide(DHGEN_NAN);
    for (int row = 0; row < DHGEN_LEG_ROWS; row++)
        kind[row] = dhgen_kind_wide(q[0]);
    return dhgen_where_wide(1);
}

/* Empties the rows of all legs, as the pose is invalid. Returns the code of an invalid pose. */
DHGEN_APART int dhgen_no_drives(double *q, unsigned char *status)
{
    for (int i = 0; i < DHGEN_LEGS * DHGEN_LEG_ROWS; i++)
        status[i] = DHGEN_INVALID_POSE;
    for (int i = 0; i < DHGEN_LEGS * DHGEN_LEG_SIZE; i++)
        q[i] = DHGEN_NAN;
    return -DHGEN_INVALID_POSE;
}

/* The driven joints of all solutions of all legs. Returns what dhgen_parallel_ik does. */
DHGEN_ALWAYS
DHGEN_INLINE int dhgen_parallel_drives(const struct dhgen_parallel *robot,
    const struct dhgen_leg_lanes *lanes, dhgen_solve_driven *solve, const double *T, double *q,
    unsigned char *status)
{
    double X[12];
    int modes = 1;
    if (!dhgen_read_platform(robot, T, X))
        return dhgen_no_drives(q, status);
    for (int chain = 0; chain < lanes->chains; chain++)
        for (int i = lanes->first[chain]; i < lanes->first[chain + 1]; i += DHGEN_LANES) {
            const struct dhgen_leg *const leg = robot->leg + lanes->legs[i];
            dhgen_wide base[12], end[12], pose[16], placed[12], found[DHGEN_LEG_SIZE];
            dhgen_wide_mask kind[DHGEN_LEG_ROWS];
            DHGEN_WRITTEN_OUT
            for (int k = 0; k < 12; k++) {
                base[k] = *(const dhgen_wide_at *)(lanes->base[k] + i);
                end[k] = *(const dhgen_wide_at *)(lanes->end[k] + i);
                placed[k] = dhgen_all_wide(X[k]);
            }
            dhgen_leg_pose_wide(leg, base, end, placed, pose);
            const unsigned left = dhgen_driven_rows(leg, solve, chain, pose, found, kind);
            const int rest = lanes->first[chain + 1] - i;
            const int count = rest < DHGEN_LANES ? rest : DHGEN_LANES;
            dhgen_store_driven(found, kind, count, lanes->legs + i, q, status);
            for (int k = 0; k < count && left; k++) {
                const size_t number = lanes->legs[i + k];
                if (left >> k & 1u
                    && !dhgen_driven_with_care(robot, (int)number, X, q + DHGEN_LEG_SIZE * number,
                        status + DHGEN_LEG_ROWS * number))
                    return dhgen_no_drives(q, status);
            }
        }
    DHGEN_WRITTEN_OUT
    for (int i = 0; i < DHGEN_LEGS; i++) {
        int count = 0;
        DHGEN_WRITTEN_OUT
        for (int row = i * DHGEN_LEG_ROWS; row < (i + 1) * DHGEN_LEG_ROWS; row++)
            count += status[row] == DHGEN_OK || status[row] == DHGEN_FREE_JOINT;
        modes *= count;
    }
    return modes;
}

#if DHGEN_LANES > 1
/* Poses of the platform in lanes, as in dhgen_read_platform. Returns which are none, or rounded. */
DHGEN_ALWAYS
DHGEN_INLINE unsigned dhgen_read_platforms(
    const struct dhgen_parallel *robot, const double *T, dhgen_wide *X)
{
    dhgen_wide read[16];
    DHGEN_WRITTEN_OUT
    for (int i = 0; i < 16; i += DHGEN_LANES) {
        DHGEN_WRITTEN_OUT
        for (int k = 0; k < DHGEN_LANES; k++)
            read[i + k] = *(const dhgen_wide_at *)(T + 16 * k + i);
        dhgen_transpose(read + i);
    }
    dhgen_wide miss = 0.0 * (read[3] + read[7] + read[11]);
    DHGEN_WRITTEN_OUT
    for (int i = 0; i < 12; i++)
        X[i] = read[i];
    if (robot->task == DHGEN_POSE) {
        miss += dhgen_pose_misfit_wide(read);
    } else {
        const int turns = robot->task == DHGEN_YAW;
        const dhgen_wide c = turns ? read[0] : dhgen_all_wide(1.0);
        const dhgen_wide s = turns ? read[4] : dhgen_all_wide(0.0);
        const dhgen_wide off = c * c + s * s - 1.0;
        miss = off * off + 0.0 * (read[3] + read[7] + (robot->is_planar ? c : read[11]));
        X[0] = X[5] = c;
        X[1] = -s;
        X[4] = s;
        X[2] = X[6] = X[8] = X[9] = dhgen_all_wide(0.0);
        X[10] = dhgen_all_wide(1.0);
        X[11] = robot->is_planar ? dhgen_all_wide(0.0) : X[11];
    }
    return dhgen_bits_wide((miss <= DHGEN_ORTHONORMAL) == 0);
}
#endif

/* dhgen_parallel_drives for n poses. */
DHGEN_ALWAYS
DHGEN_INLINE void dhgen_parallel_drives_batch(const struct dhgen_parallel *robot,
    const struct dhgen_leg_lanes *lanes, dhgen_solve_driven *solve,
    int (*one)(const double *T, double *q, unsigned char *status), size_t n, const double *T,
    double *q, unsigned char *status)
{
    enum { SIZE = DHGEN_LEGS * DHGEN_LEG_SIZE, ROWS = DHGEN_LEGS * DHGEN_LEG_ROWS };
    size_t k = 0;
    (void)robot;
    (void)lanes;
    (void)solve;
#if DHGEN_LANES > 1
    for (; k + DHGEN_LANES <= n; k += DHGEN_LANES) {
        dhgen_wide X[12];
        size_t place[DHGEN_LANES];
        unsigned left = dhgen_read_platforms(robot, T + 16 * k, X);
        for (int chain = 0; chain < lanes->chains; chain++)
            for (int i = lanes->first[chain]; i < lanes->first[chain + 1]; i++) {
                const size_t number = lanes->legs[i];
                const struct dhgen_leg *const leg = robot->leg + number;
                dhgen_wide base[12], end[12], pose[16], found[DHGEN_LEG_SIZE];
                dhgen_wide_mask kind[DHGEN_LEG_ROWS];
                DHGEN_WRITTEN_OUT
                for (int j = 0; j < 12; j++) {
                    base[j] = dhgen_all_wide(leg->base[j]);
                    end[j] = dhgen_all_wide(leg->end[j]);
                }
                dhgen_leg_pose_wide(leg, base, end, X, pose);
                left |= dhgen_driven_rows(leg, solve, chain, pose, found, kind);
                DHGEN_WRITTEN_OUT
                for (size_t lane = 0; lane < DHGEN_LANES; lane++)
                    place[lane] = (k + lane) * DHGEN_LEGS + number;
                dhgen_store_driven(found, kind, DHGEN_LANES, place, q, status);
            }
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)one(T + 16 * i, q + SIZE * i, status + ROWS * i);
    }
#endif
    for (; k < n; k++)
        (void)one(T + 16 * k, q + SIZE * k, status + ROWS * k);
}

#endif
