/* franka_panda: Franka Emika Panda
 *
 * Inverse kinematics, generated from robots/franka_panda.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/franka_panda.yaml. The formulas and where they come from:
 * franka_panda.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 3bdf97d21dac1f9a
 * SPDX-License-Identifier: MIT
 */
#ifndef FRANKA_PANDA_H
#define FRANKA_PANDA_H

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

#define FRANKA_PANDA_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define FRANKA_PANDA_JOINT_TYPES "RRRRRRR"
#define FRANKA_PANDA_JOINT_NAMES \
    "panda_joint1", "panda_joint2", "panda_joint3", "panda_joint4", "panda_joint5", \
    "panda_joint6", "panda_joint7"
#define FRANKA_PANDA_JOINT_LIMITS \
    { -2.8973, 2.8973 }, { -1.7628, 1.7628 }, { -2.8973, 2.8973 }, { -3.0718, -0.0698 }, \
    { -2.8973, 2.8973 }, { -0.0175, 3.7525 }, { -2.8973, 2.8973 }

enum {
    FRANKA_PANDA_DOF = 7, /* joints */
    FRANKA_PANDA_FREE = 1, /* free joints, whose values the caller gives: 7 */
    FRANKA_PANDA_ROWS = 8 /* branches */
};

/* What a row of franka_panda_ik holds. */
enum {
    /* joint values */
    FRANKA_PANDA_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    FRANKA_PANDA_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    FRANKA_PANDA_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    FRANKA_PANDA_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose, or a free joint's value is not finite */
    FRANKA_PANDA_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const franka_panda_branches[8];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void franka_panda_fk(const double q[7], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void franka_panda_frames(const double q[7], double frames[9][16]);

/* The geometric Jacobian, 6 x 7 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void franka_panda_jacobian(const double q[7], double J[42]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void franka_panda_joint_velocities(
    const double q[7], const double twist[6], double velocities[7]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros). Returns how many rows are OK or FREE_JOINT, or
 * -FRANKA_PANDA_INVALID_POSE, also for a seed that is not finite where it may be needed. */
DHGEN_PUBLIC int franka_panda_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[8][7],
    unsigned char status[8]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns FRANKA_PANDA_OK or FRANKA_PANDA_FREE_JOINT, or, with NaN in q,
 * minus FRANKA_PANDA_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int franka_panda_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7]);

/* franka_panda_ik without a seed for n poses: T holds n x 16 numbers, free_joints n x 1,
 * q n x 8 x 7, status n x 8. */
DHGEN_PUBLIC void franka_panda_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
