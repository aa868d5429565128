/* katana_400: Neuronics Katana 400
 *
 * Inverse kinematics, generated from robots/katana_400.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/katana_400.yaml. The formulas and where they come from:
 * katana_400.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 1b08c7fc3b36b795
 * SPDX-License-Identifier: MIT
 */
#ifndef KATANA_400_H
#define KATANA_400_H

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

#define KATANA_400_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define KATANA_400_JOINT_TYPES "RRRRR"
#define KATANA_400_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5"
#define KATANA_400_JOINT_LIMITS \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }

enum {
    KATANA_400_DOF = 5, /* joints */
    KATANA_400_ROWS = 4 /* branches */
};

/* What a row of katana_400_ik holds. */
enum {
    /* joint values */
    KATANA_400_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    KATANA_400_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    KATANA_400_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    KATANA_400_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    KATANA_400_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const katana_400_branches[4];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void katana_400_fk(const double q[5], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void katana_400_frames(const double q[5], double frames[7][16]);

/* The geometric Jacobian, 6 x 5 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void katana_400_jacobian(const double q[5], double J[30]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void katana_400_joint_velocities(
    const double q[5], const double twist[6], double velocities[5]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -KATANA_400_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int katana_400_ik(
    const double T[16], const double *q_seed, double q[4][5], unsigned char status[4]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns KATANA_400_OK or KATANA_400_FREE_JOINT, or, with NaN in q,
 * minus KATANA_400_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int katana_400_ik_nearest(const double T[16], const double q_seed[5], double q[5]);

/* katana_400_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 4 x 5, status n x 4. */
DHGEN_PUBLIC void katana_400_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
