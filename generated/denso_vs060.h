/* denso_vs060: Denso VS-060
 *
 * Inverse kinematics, generated from robots/denso_vs060.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/denso_vs060.yaml. The formulas and where they come from:
 * denso_vs060.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: dde60b298a8ee644
 * SPDX-License-Identifier: MIT
 */
#ifndef DENSO_VS060_H
#define DENSO_VS060_H

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

#define DENSO_VS060_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define DENSO_VS060_JOINT_TYPES "RRRRRR"
#define DENSO_VS060_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"
#define DENSO_VS060_JOINT_LIMITS \
    { -2.96706, 2.96706 }, { -2.094395, 2.094395 }, { -2.181662, 2.70526 }, \
    { -4.712389, 4.712389 }, { -2.094395, 2.094395 }, { -6.283185, 6.283185 }

enum {
    DENSO_VS060_DOF = 6, /* joints */
    DENSO_VS060_ROWS = 8 /* branches */
};

/* What a row of denso_vs060_ik holds. */
enum {
    /* joint values */
    DENSO_VS060_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    DENSO_VS060_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    DENSO_VS060_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    DENSO_VS060_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    DENSO_VS060_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const denso_vs060_branches[8];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void denso_vs060_fk(const double q[6], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void denso_vs060_frames(const double q[6], double frames[8][16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void denso_vs060_jacobian(const double q[6], double J[36]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void denso_vs060_joint_velocities(
    const double q[6], const double twist[6], double velocities[6]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -DENSO_VS060_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int denso_vs060_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns DENSO_VS060_OK or DENSO_VS060_FREE_JOINT, or, with NaN in q,
 * minus DENSO_VS060_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int denso_vs060_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* denso_vs060_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 8 x 6, status n x 8. */
DHGEN_PUBLIC void denso_vs060_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
