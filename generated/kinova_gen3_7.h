/* kinova_gen3_7: Kinova Gen3 with 7 joints
 *
 * Inverse kinematics, generated from robots/kinova_gen3_7.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/kinova_gen3_7.yaml. The formulas and where they come from:
 * kinova_gen3_7.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 24c1f9395bc7745f
 * SPDX-License-Identifier: MIT
 */
#ifndef KINOVA_GEN3_7_H
#define KINOVA_GEN3_7_H

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

#define KINOVA_GEN3_7_METHOD "general 6R"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define KINOVA_GEN3_7_JOINT_TYPES "RRRRRRR"
#define KINOVA_GEN3_7_JOINT_NAMES \
    "joint1", "joint2", "joint3", "joint4", "joint5", "joint6", "joint7"
#define KINOVA_GEN3_7_JOINT_LIMITS \
    { -HUGE_VAL, HUGE_VAL }, { -2.24, 2.24 }, { -HUGE_VAL, HUGE_VAL }, { -2.57, 2.57 }, \
    { -HUGE_VAL, HUGE_VAL }, { -2.09, 2.09 }, { -HUGE_VAL, HUGE_VAL }

enum {
    KINOVA_GEN3_7_DOF = 7, /* joints */
    KINOVA_GEN3_7_FREE = 1, /* free joints, whose values the caller gives: 3 */
    KINOVA_GEN3_7_ROWS = 16 /* branches */
};

/* What a row of kinova_gen3_7_ik holds. */
enum {
    /* joint values */
    KINOVA_GEN3_7_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    KINOVA_GEN3_7_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    KINOVA_GEN3_7_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    KINOVA_GEN3_7_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose, or a free joint's value is not finite */
    KINOVA_GEN3_7_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const kinova_gen3_7_branches[16];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void kinova_gen3_7_fk(const double q[7], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void kinova_gen3_7_frames(const double q[7], double frames[9][16]);

/* The geometric Jacobian, 6 x 7 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void kinova_gen3_7_jacobian(const double q[7], double J[42]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void kinova_gen3_7_joint_velocities(
    const double q[7], const double twist[6], double velocities[7]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros). Returns how many rows are OK or FREE_JOINT, or
 * -KINOVA_GEN3_7_INVALID_POSE, also for a seed that is not finite where it may be needed. */
DHGEN_PUBLIC int kinova_gen3_7_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[16][7],
    unsigned char status[16]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns KINOVA_GEN3_7_OK or KINOVA_GEN3_7_FREE_JOINT, or, with NaN in q,
 * minus KINOVA_GEN3_7_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int kinova_gen3_7_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7]);

/* kinova_gen3_7_ik without a seed for n poses: T holds n x 16 numbers, free_joints n x 1,
 * q n x 16 x 7, status n x 16. */
DHGEN_PUBLIC void kinova_gen3_7_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
