/* puma560_f32: Unimation PUMA 560
 *
 * Inverse kinematics, generated from robots/puma560.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad,
 * all in single precision. Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c347f76f4868f211
 * SPDX-License-Identifier: MIT
 */
#ifndef PUMA560_F32_H
#define PUMA560_F32_H

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

#define PUMA560_F32_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define PUMA560_F32_JOINT_TYPES "RRRRRR"
#define PUMA560_F32_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"
#define PUMA560_F32_JOINT_LIMITS \
    { -2.7925267f, 2.7925267f }, { -1.9198622f, 1.9198622f }, \
    { -2.3561945f, 2.3561945f }, { -4.6425757f, 4.6425757f }, \
    { -1.7453293f, 1.7453293f }, { -4.6425757f, 4.6425757f }

enum {
    PUMA560_F32_DOF = 6, /* joints */
    PUMA560_F32_ROWS = 8 /* branches */
};

/* What a row of puma560_f32_ik holds. */
enum {
    /* joint values */
    PUMA560_F32_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    PUMA560_F32_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    PUMA560_F32_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    PUMA560_F32_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    PUMA560_F32_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const puma560_f32_branches[8];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void puma560_f32_fk(const float q[6], float T[16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void puma560_f32_jacobian(const float q[6], float J[36]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void puma560_f32_joint_velocities(
    const float q[6], const float twist[6], float velocities[6]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -PUMA560_F32_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int puma560_f32_ik(
    const float T[16], const float *q_seed, float q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns PUMA560_F32_OK or PUMA560_F32_FREE_JOINT, or, with NaN in q,
 * minus PUMA560_F32_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int puma560_f32_ik_nearest(const float T[16], const float q_seed[6], float q[6]);

/* puma560_f32_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 8 x 6, status n x 8. */
DHGEN_PUBLIC void puma560_f32_ik_batch(size_t n, const float *T, float *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
