/* abb_gofa_5: ABB GoFa CRB 15000-5/0.95
 *
 * Inverse kinematics, generated from robots/abb_gofa_5.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/abb_gofa_5.yaml. The formulas and where they come from:
 * abb_gofa_5.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 25c95d32d8b27f20
 * SPDX-License-Identifier: MIT
 */
#ifndef ABB_GOFA_5_H
#define ABB_GOFA_5_H

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

#define ABB_GOFA_5_METHOD "general 6R"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define ABB_GOFA_5_JOINT_TYPES "RRRRRR"
#define ABB_GOFA_5_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"
#define ABB_GOFA_5_JOINT_LIMITS \
    { -3.141592653589793, 3.141592653589793 }, { -3.141592653589793, 3.141592653589793 }, \
    { -3.9269908169872414, 1.4835298641951802 }, { -3.141592653589793, 3.141592653589793 }, \
    { -3.141592653589793, 3.141592653589793 }, { -3.141592653589793, 3.141592653589793 }

enum {
    ABB_GOFA_5_DOF = 6, /* joints */
    ABB_GOFA_5_ROWS = 16 /* branches */
};

/* What a row of abb_gofa_5_ik holds. */
enum {
    /* joint values */
    ABB_GOFA_5_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    ABB_GOFA_5_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    ABB_GOFA_5_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    ABB_GOFA_5_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    ABB_GOFA_5_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const abb_gofa_5_branches[16];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void abb_gofa_5_fk(const double q[6], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void abb_gofa_5_frames(const double q[6], double frames[8][16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void abb_gofa_5_jacobian(const double q[6], double J[36]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void abb_gofa_5_joint_velocities(
    const double q[6], const double twist[6], double velocities[6]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -ABB_GOFA_5_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int abb_gofa_5_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns ABB_GOFA_5_OK or ABB_GOFA_5_FREE_JOINT, or, with NaN in q,
 * minus ABB_GOFA_5_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int abb_gofa_5_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* abb_gofa_5_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 16 x 6, status n x 16. */
DHGEN_PUBLIC void abb_gofa_5_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
