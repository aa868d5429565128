/* stewart: Stewart platform, six cylinders (6-UPS)
 *
 * Inverse kinematics, generated from robots/stewart.yaml and templates/c/parallel.h.jinja.
 * Do not edit: run dhgen robots/stewart.yaml. The formulas and where they come from: stewart.md.
 *
 * A platform on 6 legs, each of which is a serial arm: compile stewart.c stewart_leg.c together.
 * Poses are row-major 4 x 4 matrices of the platform in the base frame, lengths in m, angles in
 * rad. Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 7e0d95027cd10e15
 * SPDX-License-Identifier: MIT
 */
#ifndef STEWART_H
#define STEWART_H

#ifndef __CUDACC_RTC__ /* it has their functions without them */
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

enum {
    STEWART_LEGS = 6,
    STEWART_JOINTS = 3, /* of a leg, passive ones among them */
    STEWART_ROWS = 4, /* branches of a leg */
    STEWART_DOF = 6 /* of the platform, which has as many driven joints */
};

/* What a row of stewart_ik holds. */
enum {
    /* joint values */
    STEWART_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    STEWART_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    STEWART_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    STEWART_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    STEWART_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row of every leg. A working mode is a row of each leg. */
extern const char *const *const stewart_branches[6];
#endif

/* The leg and the joint of every drive, from 0. */
#ifndef __CUDA_ARCH__
extern const int stewart_drives[6][2];
#endif

/* Joint values of all legs are a double q[6][3]. Where they are read, as `const double *`, they are
 * passed as q[0]: C99 takes no pointer to arrays for one to arrays of constants. */

/* All solutions of all legs. Row b of a leg is always its branch b. q_seed gives the values of
 * joints that are indeterminate at this pose (NULL: zeros).
 * Returns how many working modes there are, the product of the legs' rows that are OK or
 * FREE_JOINT, or -STEWART_INVALID_POSE, also for a seed that is not finite where it may be
 * needed. */
DHGEN_PUBLIC int stewart_ik(const double T[16], const double *q_seed,
    double q[6][4][3], unsigned char status[6][4]);

/* Of every leg the solution nearest to q_seed, with angles moved by whole turns into their limits.
 * Returns STEWART_OK or STEWART_FREE_JOINT, or, with NaN in q, minus what is wrong with a
 * leg: STEWART_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed that
 * is not finite. */
DHGEN_PUBLIC int stewart_ik_nearest(
    const double T[16], const double *q_seed, double q[6][3]);

/* stewart_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 6 x 4 x 3, status n x 6 x 4. */
DHGEN_PUBLIC void stewart_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

/* The driven joints alone of what stewart_ik gives: as controllers need them, in less time. Row b
 * of a leg has its driven joints in their order, and the status that it has with passive ones. */
DHGEN_PUBLIC int stewart_ik_drives(const double T[16],
    double q[6][4][1], unsigned char status[6][4]);

/* stewart_ik_drives for n poses: q n x 6 x 4 x 1, status n x 6 x 4. */
DHGEN_PUBLIC void stewart_ik_drives_batch(
    size_t n, const double *T, double *q, unsigned char *status);

/* The values of the driven joints. */
DHGEN_PUBLIC void stewart_take_drives(const double *q, double drives[6]);

/* The pose of the platform that drives' values make, and the joint values of all legs, refined from
 * T_seed: a pose nearby that the legs reach.
 * Returns STEWART_OK; STEWART_FREE_JOINT where the platform is singular there, so that other
 * poses meet this one, or it or passive joints of a leg can move; or, with NaN in T and q,
 * -STEWART_UNREACHABLE where the legs did not meet the platform or do not reach the seed, or
 * -STEWART_INVALID_POSE. */
DHGEN_PUBLIC int stewart_fk(const double drives[6], const double T_seed[16],
    double T[16], double q[6][3]);

/* A and B, with A xdot = B qdot at a pose and its joint values: xdot are the platform's velocities
 * (vx, vy, vz, wx, wy, wz), qdot those of the drives. Returns STEWART_OK, or, with NaN in A
 * and B, -STEWART_FREE_JOINT where passive joints of a leg depend on each other, so that A and B
 * are not determined, or -STEWART_INVALID_POSE, also for joint values that are not finite. */
DHGEN_PUBLIC int stewart_velocities(
    const double T[16], const double *q, double A[36], double B[36]);

/* How near a pose and its joint values are to singularities of the first kind (least[0], of B: the
 * platform loses a motion) and of the second (least[1], of A: the platform has a motion that the
 * drives do not hold): the smallest singular values, lengths in robot sizes.
 * Returns STEWART_OK; STEWART_FREE_JOINT where passive joints of a leg depend on each other:
 * the platform loses a motion, least[0] is 0 and least[1] NaN; or, with NaN in least,
 * -STEWART_INVALID_POSE, likewise. */
DHGEN_PUBLIC int stewart_singularities(const double T[16], const double *q, double least[2]);

#ifdef __cplusplus
}
#endif

#endif
