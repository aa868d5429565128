/* five_bar_leg: Planar five-bar linkage (RR legs): a leg
 *
 * Inverse kinematics, generated from robots/five_bar.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/five_bar.yaml. The formulas and where they come from:
 * five_bar_leg.md, of a leg of five_bar.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of
 * a pose, x = T[0, 3] and y = T[1, 3] counts; other entries are ignored.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 5e95f08d2a024264
 * SPDX-License-Identifier: MIT
 */
#ifndef FIVE_BAR_LEG_H
#define FIVE_BAR_LEG_H

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

#define FIVE_BAR_LEG_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define FIVE_BAR_LEG_JOINT_TYPES "RR"
#define FIVE_BAR_LEG_JOINT_NAMES "joint1", "joint2"
#define FIVE_BAR_LEG_JOINT_LIMITS { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }

enum {
    FIVE_BAR_LEG_DOF = 2, /* joints */
    FIVE_BAR_LEG_ROWS = 2 /* branches */
};

/* What a row of five_bar_leg_ik holds. */
enum {
    /* joint values */
    FIVE_BAR_LEG_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    FIVE_BAR_LEG_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    FIVE_BAR_LEG_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    FIVE_BAR_LEG_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    FIVE_BAR_LEG_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const five_bar_leg_branches[2];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void five_bar_leg_fk(const double q[2], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void five_bar_leg_frames(const double q[2], double frames[4][16]);

/* The geometric Jacobian, 6 x 2 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void five_bar_leg_jacobian(const double q[2], double J[12]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void five_bar_leg_joint_velocities(
    const double q[2], const double twist[6], double velocities[2]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros). Returns how many rows are OK or FREE_JOINT, or
 * -FIVE_BAR_LEG_INVALID_POSE, also for a seed that is not finite where it may be needed. */
DHGEN_PUBLIC int five_bar_leg_ik(
    const double T[16], const double *q_seed, double q[2][2], unsigned char status[2]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns FIVE_BAR_LEG_OK or FIVE_BAR_LEG_FREE_JOINT, or, with NaN in q,
 * minus FIVE_BAR_LEG_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int five_bar_leg_ik_nearest(const double T[16], const double q_seed[2], double q[2]);

/* five_bar_leg_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 2 x 2, status n x 2. */
DHGEN_PUBLIC void five_bar_leg_ik_batch(
    size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
