/* igus_rebel: igus ReBeL
 *
 * Inverse kinematics, generated from robots/igus_rebel.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/igus_rebel.yaml. The formulas and where they come from:
 * igus_rebel.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: fbfb60e591c62a5d
 * SPDX-License-Identifier: MIT
 */
#ifndef IGUS_REBEL_H
#define IGUS_REBEL_H

#ifndef __CUDACC_RTC__ /* it has their functions without them */
#include <math.h>
#include <stddef.h>
#endif

#ifndef DHGEN_PUBLIC /* the mark of functions: in CUDA they are for both sides */
#ifdef __CUDACC__
#define DHGEN_PUBLIC __host__ __device__
#else
#define DHGEN_PUBLIC
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define IGUS_REBEL_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define IGUS_REBEL_JOINT_TYPES "RRRRRR"
#define IGUS_REBEL_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"
#define IGUS_REBEL_JOINT_LIMITS \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }

enum {
    IGUS_REBEL_DOF = 6, /* joints */
    IGUS_REBEL_ROWS = 8 /* branches */
};

/* What a row of igus_rebel_ik holds. */
enum {
    /* joint values */
    IGUS_REBEL_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    IGUS_REBEL_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    IGUS_REBEL_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    IGUS_REBEL_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    IGUS_REBEL_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const igus_rebel_branches[8];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void igus_rebel_fk(const double q[6], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void igus_rebel_frames(const double q[6], double frames[8][16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void igus_rebel_jacobian(const double q[6], double J[36]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void igus_rebel_joint_velocities(
    const double q[6], const double twist[6], double velocities[6]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -IGUS_REBEL_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int igus_rebel_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns IGUS_REBEL_OK or IGUS_REBEL_FREE_JOINT, or, with NaN in q,
 * minus IGUS_REBEL_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int igus_rebel_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* igus_rebel_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 8 x 6, status n x 8. */
DHGEN_PUBLIC void igus_rebel_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
