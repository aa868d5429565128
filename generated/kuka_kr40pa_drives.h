/* kuka_kr40pa_drives: KUKA KR 40 PA palletizer, its hand's joint, by its drives
 *
 * Inverse kinematics, generated from robots/kuka_kr40pa_drives.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/kuka_kr40pa_drives.yaml. The formulas and where they come from:
 * kuka_kr40pa_drives.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of
 * a pose, the position T[0:3, 3] counts; other entries are ignored.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: a161591f8bab6b71
 * SPDX-License-Identifier: MIT
 */
#ifndef KUKA_KR40PA_DRIVES_H
#define KUKA_KR40PA_DRIVES_H

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

#define KUKA_KR40PA_DRIVES_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define KUKA_KR40PA_DRIVES_JOINT_TYPES "RRR"
#define KUKA_KR40PA_DRIVES_JOINT_NAMES "joint1", "joint2", "joint3"
#define KUKA_KR40PA_DRIVES_JOINT_LIMITS \
    { -2.705260340591211, 2.705260340591211 }, { -2.2165681500327987, 0.3490658503988659 }, \
    { -0.3490658503988659, 2.2689280275926285 }

enum {
    KUKA_KR40PA_DRIVES_DOF = 3, /* joints */
    KUKA_KR40PA_DRIVES_ROWS = 4 /* branches */
};

/* What a row of kuka_kr40pa_drives_ik holds. */
enum {
    /* joint values */
    KUKA_KR40PA_DRIVES_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    KUKA_KR40PA_DRIVES_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    KUKA_KR40PA_DRIVES_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    KUKA_KR40PA_DRIVES_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    KUKA_KR40PA_DRIVES_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const kuka_kr40pa_drives_branches[4];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void kuka_kr40pa_drives_fk(const double q[3], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void kuka_kr40pa_drives_frames(const double q[3], double frames[5][16]);

/* The geometric Jacobian, 6 x 3 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void kuka_kr40pa_drives_jacobian(const double q[3], double J[18]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void kuka_kr40pa_drives_joint_velocities(
    const double q[3], const double twist[6], double velocities[3]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros). Returns how many rows are OK or FREE_JOINT, or
 * -KUKA_KR40PA_DRIVES_INVALID_POSE, also for a seed that is not finite where it may be needed. */
DHGEN_PUBLIC int kuka_kr40pa_drives_ik(
    const double T[16], const double *q_seed, double q[4][3], unsigned char status[4]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed. Returns KUKA_KR40PA_DRIVES_OK or KUKA_KR40PA_DRIVES_FREE_JOINT, or, with NaN in q, minus
 * KUKA_KR40PA_DRIVES_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed
 * that is not finite. */
DHGEN_PUBLIC int kuka_kr40pa_drives_ik_nearest(
    const double T[16], const double q_seed[3], double q[3]);

/* kuka_kr40pa_drives_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 4 x 3, status n x 4. */
DHGEN_PUBLIC void kuka_kr40pa_drives_ik_batch(
    size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
