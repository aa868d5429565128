/* ur5_f32: Universal Robots UR5
 *
 * Inverse kinematics, generated from robots/ur5.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/ur5.yaml. The formulas and where they come from: ur5.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad,
 * all in single precision. Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 5f2fe27a326bcf25
 * SPDX-License-Identifier: MIT
 */
#ifndef UR5_F32_H
#define UR5_F32_H

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

#define UR5_F32_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define UR5_F32_JOINT_TYPES "RRRRRR"
#define UR5_F32_JOINT_NAMES \
    "shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", \
    "wrist_3_joint"
#define UR5_F32_JOINT_LIMITS \
    { -6.2831855f, 6.2831855f }, { -6.2831855f, 6.2831855f }, \
    { -6.2831855f, 6.2831855f }, { -6.2831855f, 6.2831855f }, \
    { -6.2831855f, 6.2831855f }, { -6.2831855f, 6.2831855f }

enum {
    UR5_F32_DOF = 6, /* joints */
    UR5_F32_ROWS = 8 /* branches */
};

/* What a row of ur5_f32_ik holds. */
enum {
    /* joint values */
    UR5_F32_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    UR5_F32_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    UR5_F32_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    UR5_F32_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    UR5_F32_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const ur5_f32_branches[8];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void ur5_f32_fk(const float q[6], float T[16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void ur5_f32_jacobian(const float q[6], float J[36]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void ur5_f32_joint_velocities(
    const float q[6], const float twist[6], float velocities[6]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -UR5_F32_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int ur5_f32_ik(
    const float T[16], const float *q_seed, float q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns UR5_F32_OK or UR5_F32_FREE_JOINT, or, with NaN in q,
 * minus UR5_F32_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int ur5_f32_ik_nearest(const float T[16], const float q_seed[6], float q[6]);

/* ur5_f32_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 8 x 6, status n x 8. */
DHGEN_PUBLIC void ur5_f32_ik_batch(size_t n, const float *T, float *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
