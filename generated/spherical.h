/* spherical: Spherical arm
 *
 * Inverse kinematics, generated from robots/spherical.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/spherical.yaml. The formulas and where they come from:
 * spherical.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of
 * a pose, the position T[0:3, 3] counts; other entries are ignored.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c459b1a01dddb7d5
 * SPDX-License-Identifier: MIT
 */
#ifndef SPHERICAL_H
#define SPHERICAL_H

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

#define SPHERICAL_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define SPHERICAL_JOINT_TYPES "RRP"
#define SPHERICAL_JOINT_NAMES "joint1", "joint2", "joint3"
#define SPHERICAL_JOINT_LIMITS \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }

enum {
    SPHERICAL_DOF = 3, /* joints */
    SPHERICAL_ROWS = 4 /* branches */
};

/* What a row of spherical_ik holds. */
enum {
    /* joint values */
    SPHERICAL_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    SPHERICAL_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    SPHERICAL_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    SPHERICAL_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    SPHERICAL_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const spherical_branches[4];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void spherical_fk(const double q[3], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void spherical_frames(const double q[3], double frames[5][16]);

/* The geometric Jacobian, 6 x 3 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void spherical_jacobian(const double q[3], double J[18]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void spherical_joint_velocities(
    const double q[3], const double twist[6], double velocities[3]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -SPHERICAL_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int spherical_ik(
    const double T[16], const double *q_seed, double q[4][3], unsigned char status[4]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns SPHERICAL_OK or SPHERICAL_FREE_JOINT, or, with NaN in q,
 * minus SPHERICAL_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int spherical_ik_nearest(const double T[16], const double q_seed[3], double q[3]);

/* spherical_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 4 x 3, status n x 4. */
DHGEN_PUBLIC void spherical_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
