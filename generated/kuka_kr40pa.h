/* kuka_kr40pa: KUKA KR 40 PA palletizer, serial equivalent
 *
 * Inverse kinematics, generated from robots/kuka_kr40pa.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/kuka_kr40pa.yaml. The formulas and where they come from:
 * kuka_kr40pa.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: fcfe06ceda5e7cac
 * SPDX-License-Identifier: MIT
 */
#ifndef KUKA_KR40PA_H
#define KUKA_KR40PA_H

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

#define KUKA_KR40PA_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define KUKA_KR40PA_JOINT_TYPES "RRRR"
#define KUKA_KR40PA_JOINT_NAMES "joint1", "joint2", "joint3", "joint4"
#define KUKA_KR40PA_JOINT_LIMITS \
    { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, HUGE_VAL }, \
    { -HUGE_VAL, HUGE_VAL }

enum {
    KUKA_KR40PA_DOF = 4, /* joints */
    KUKA_KR40PA_ROWS = 2 /* branches */
};

/* What a row of kuka_kr40pa_ik holds. */
enum {
    /* joint values */
    KUKA_KR40PA_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    KUKA_KR40PA_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    KUKA_KR40PA_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    KUKA_KR40PA_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    KUKA_KR40PA_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const kuka_kr40pa_branches[2];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void kuka_kr40pa_fk(const double q[4], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void kuka_kr40pa_frames(const double q[4], double frames[6][16]);

/* The geometric Jacobian, 6 x 4 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void kuka_kr40pa_jacobian(const double q[4], double J[24]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void kuka_kr40pa_joint_velocities(
    const double q[4], const double twist[6], double velocities[4]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros).
 * Returns how many rows are OK or FREE_JOINT, or -KUKA_KR40PA_INVALID_POSE, also for a seed that is
 * not finite where it may be needed. */
DHGEN_PUBLIC int kuka_kr40pa_ik(
    const double T[16], const double *q_seed, double q[2][4], unsigned char status[2]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed.
 * Returns KUKA_KR40PA_OK or KUKA_KR40PA_FREE_JOINT, or, with NaN in q,
 * minus KUKA_KR40PA_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int kuka_kr40pa_ik_nearest(const double T[16], const double q_seed[4], double q[4]);

/* kuka_kr40pa_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 2 x 4, status n x 2. */
DHGEN_PUBLIC void kuka_kr40pa_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
