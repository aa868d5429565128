/* planar_rrrr: Planar arm with four links, one joint too many twice over
 *
 * Inverse kinematics, generated from robots/planar_rrrr.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/planar_rrrr.yaml. The formulas and where they come from:
 * planar_rrrr.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of
 * a pose, x = T[0, 3] and y = T[1, 3] counts; other entries are ignored.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c20903e6caa02128
 * SPDX-License-Identifier: MIT
 */
#ifndef PLANAR_RRRR_H
#define PLANAR_RRRR_H

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

#define PLANAR_RRRR_METHOD "numerical"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define PLANAR_RRRR_JOINT_TYPES "RRRR"
#define PLANAR_RRRR_JOINT_NAMES "joint1", "joint2", "joint3", "joint4"
#define PLANAR_RRRR_JOINT_LIMITS \
    { -2.0943951023931953, 2.0943951023931953 }, { -2.0943951023931953, 2.0943951023931953 }, \
    { -2.0943951023931953, 2.0943951023931953 }, { -2.0943951023931953, 2.0943951023931953 }

enum {
    PLANAR_RRRR_DOF = 4, /* joints */
    PLANAR_RRRR_ROWS = 1 /* branches */
};

/* What a row of planar_rrrr_ik holds. */
enum {
    /* joint values */
    PLANAR_RRRR_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    PLANAR_RRRR_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    PLANAR_RRRR_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    PLANAR_RRRR_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    PLANAR_RRRR_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const planar_rrrr_branches[1];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void planar_rrrr_fk(const double q[4], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void planar_rrrr_frames(const double q[4], double frames[6][16]);

/* The geometric Jacobian, 6 x 4 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void planar_rrrr_jacobian(const double q[4], double J[24]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void planar_rrrr_joint_velocities(
    const double q[4], const double twist[6], double velocities[4]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -PLANAR_RRRR_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int planar_rrrr_ik(
    const double T[16], const double *q_seed, double q[1][4], unsigned char status[1]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns PLANAR_RRRR_OK or PLANAR_RRRR_FREE_JOINT, or, with NaN in q,
 * minus PLANAR_RRRR_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int planar_rrrr_ik_nearest(const double T[16], const double q_seed[4], double q[4]);

/* planar_rrrr_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 1 x 4, status n x 1. */
DHGEN_PUBLIC void planar_rrrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
