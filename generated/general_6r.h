/* general_6r: General arm with six revolute joints
 *
 * Inverse kinematics, generated from robots/general_6r.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/general_6r.yaml. The formulas and where they come from:
 * general_6r.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 8f549a90cc09d617
 * SPDX-License-Identifier: MIT
 */
#ifndef GENERAL_6R_H
#define GENERAL_6R_H

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

#define GENERAL_6R_METHOD "general 6R"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define GENERAL_6R_JOINT_TYPES "RRRRRR"
#define GENERAL_6R_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"
#define GENERAL_6R_JOINT_LIMITS \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }

enum {
    GENERAL_6R_DOF = 6, /* joints */
    GENERAL_6R_ROWS = 16 /* branches */
};

/* What a row of general_6r_ik holds. */
enum {
    /* joint values */
    GENERAL_6R_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    GENERAL_6R_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    GENERAL_6R_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    GENERAL_6R_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    GENERAL_6R_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const general_6r_branches[16];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void general_6r_fk(const double q[6], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void general_6r_frames(const double q[6], double frames[8][16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void general_6r_jacobian(const double q[6], double J[36]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void general_6r_joint_velocities(
    const double q[6], const double twist[6], double velocities[6]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -GENERAL_6R_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int general_6r_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns GENERAL_6R_OK or GENERAL_6R_FREE_JOINT, or, with NaN in q,
 * minus GENERAL_6R_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int general_6r_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* general_6r_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 16 x 6, status n x 16. */
DHGEN_PUBLIC void general_6r_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
