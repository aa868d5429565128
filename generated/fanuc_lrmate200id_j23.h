/* fanuc_lrmate200id_j23: Fanuc LR Mate 200iD, as its pendant counts
 *
 * Inverse kinematics, generated from robots/fanuc_lrmate200id_j23.yaml and
 * templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/fanuc_lrmate200id_j23.yaml. The formulas and where they come from:
 * fanuc_lrmate200id_j23.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 1565c3ae04adb845
 * SPDX-License-Identifier: MIT
 */
#ifndef FANUC_LRMATE200ID_J23_H
#define FANUC_LRMATE200ID_J23_H

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

#define FANUC_LRMATE200ID_J23_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define FANUC_LRMATE200ID_J23_JOINT_TYPES "RRRRRR"
#define FANUC_LRMATE200ID_J23_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"
#define FANUC_LRMATE200ID_J23_JOINT_LIMITS \
    { -2.9670597283903604, 2.9670597283903604 }, { -1.7453292519943295, 2.530727415391778 }, \
    { -HUGE_VAL, HUGE_VAL }, { -3.3161255787892263, 3.3161255787892263 }, \
    { -2.181661564992912, 2.181661564992912 }, { -6.283185307179586, 6.283185307179586 }

enum {
    FANUC_LRMATE200ID_J23_DOF = 6, /* joints */
    FANUC_LRMATE200ID_J23_ROWS = 8 /* branches */
};

/* What a row of fanuc_lrmate200id_j23_ik holds. */
enum {
    /* joint values */
    FANUC_LRMATE200ID_J23_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    FANUC_LRMATE200ID_J23_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    FANUC_LRMATE200ID_J23_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    FANUC_LRMATE200ID_J23_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    FANUC_LRMATE200ID_J23_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const fanuc_lrmate200id_j23_branches[8];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void fanuc_lrmate200id_j23_fk(const double q[6], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void fanuc_lrmate200id_j23_frames(const double q[6], double frames[8][16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void fanuc_lrmate200id_j23_jacobian(const double q[6], double J[36]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void fanuc_lrmate200id_j23_joint_velocities(
    const double q[6], const double twist[6], double velocities[6]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros). Returns how many rows are OK or FREE_JOINT, or
 * -FANUC_LRMATE200ID_J23_INVALID_POSE, also for a seed that is not finite where it may be
 * needed. */
DHGEN_PUBLIC int fanuc_lrmate200id_j23_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed. Returns FANUC_LRMATE200ID_J23_OK or FANUC_LRMATE200ID_J23_FREE_JOINT, or, with NaN in q,
 * minus FANUC_LRMATE200ID_J23_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a
 * seed that is not finite. */
DHGEN_PUBLIC int fanuc_lrmate200id_j23_ik_nearest(
    const double T[16], const double q_seed[6], double q[6]);

/* fanuc_lrmate200id_j23_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 8 x 6, status n x 8. */
DHGEN_PUBLIC void fanuc_lrmate200id_j23_ik_batch(
    size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
