/* delta: Delta, three cranks with parallelograms
 *
 * Inverse kinematics, generated from robots/delta.yaml and templates/c/parallel.h.jinja.
 * Do not edit: run dhgen robots/delta.yaml. The formulas and where they come from: delta.md.
 *
 * A platform on 3 legs, each of which is a serial arm: compile delta.c delta_leg.c together. Poses
 * are row-major 4 x 4 matrices of the platform in the base frame, lengths in m, angles in rad. Of a
 * pose its place alone counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: f33bcc1b99634bba
 * SPDX-License-Identifier: MIT
 */
#ifndef DELTA_H
#define DELTA_H

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
    DELTA_LEGS = 3,
    DELTA_JOINTS = 3, /* of a leg, passive ones among them */
    DELTA_ROWS = 4, /* branches of a leg */
    DELTA_DOF = 3 /* of the platform, which has as many driven joints */
};

/* What a row of delta_ik holds. */
enum {
    /* joint values */
    DELTA_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    DELTA_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    DELTA_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    DELTA_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    DELTA_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row of every leg. A working mode is a row of each leg. */
extern const char *const *const delta_branches[3];
#endif

/* The leg and the joint of every drive, from 0. */
#ifndef __CUDA_ARCH__
extern const int delta_drives[3][2];
#endif

/* Joint values of all legs are a double q[3][3]. Where they are read, as `const double *`, they are
 * passed as q[0]: C99 takes no pointer to arrays for one to arrays of constants. */

/* All solutions of all legs. Row b of a leg is always its branch b. q_seed gives the values of
 * joints that are indeterminate at this pose (NULL: zeros).
 * Returns how many working modes there are, the product of the legs' rows that are OK or
 * FREE_JOINT, or -DELTA_INVALID_POSE, also for a seed that is not finite where it may be
 * needed. */
DHGEN_PUBLIC int delta_ik(const double T[16], const double *q_seed,
    double q[3][4][3], unsigned char status[3][4]);

/* Of every leg the solution nearest to q_seed, with angles moved by whole turns into their limits.
 * Returns DELTA_OK or DELTA_FREE_JOINT, or, with NaN in q, minus what is wrong with a
 * leg: DELTA_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed that
 * is not finite. */
DHGEN_PUBLIC int delta_ik_nearest(
    const double T[16], const double *q_seed, double q[3][3]);

/* delta_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 3 x 4 x 3, status n x 3 x 4. */
DHGEN_PUBLIC void delta_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

/* The driven joints alone of what delta_ik gives: as controllers need them, in less time. Row b
 * of a leg has its driven joints in their order, and the status that it has with passive ones. */
DHGEN_PUBLIC int delta_ik_drives(const double T[16],
    double q[3][4][1], unsigned char status[3][4]);

/* delta_ik_drives for n poses: q n x 3 x 4 x 1, status n x 3 x 4. */
DHGEN_PUBLIC void delta_ik_drives_batch(
    size_t n, const double *T, double *q, unsigned char *status);

/* The values of the driven joints. */
DHGEN_PUBLIC void delta_take_drives(const double *q, double drives[3]);

/* The pose of the platform that drives' values make, and the joint values of all legs, refined from
 * T_seed: a pose nearby that the legs reach.
 * Returns DELTA_OK; DELTA_FREE_JOINT where the platform is singular there, so that other
 * poses meet this one, or it or passive joints of a leg can move; or, with NaN in T and q,
 * -DELTA_UNREACHABLE where the legs did not meet the platform or do not reach the seed, or
 * -DELTA_INVALID_POSE. */
DHGEN_PUBLIC int delta_fk(const double drives[3], const double T_seed[16],
    double T[16], double q[3][3]);

/* All poses of the platform that drives' values allow, at most 2. Returns how many there
 * are, or, with T of no use, -DELTA_FREE_JOINT where they are a continuum, as the platform can
 * move while its drives are held, or -DELTA_INVALID_POSE for drives that are not finite. */
DHGEN_PUBLIC int delta_assemblies(const double drives[3], double T[2][16]);

/* A and B, with A xdot = B qdot at a pose and its joint values: xdot are the platform's velocities
 * (vx, vy, vz), qdot those of the drives. Returns DELTA_OK, or, with NaN in A
 * and B, -DELTA_FREE_JOINT where passive joints of a leg depend on each other, so that A and B
 * are not determined, or -DELTA_INVALID_POSE, also for joint values that are not finite. */
DHGEN_PUBLIC int delta_velocities(
    const double T[16], const double *q, double A[9], double B[9]);

/* How near a pose and its joint values are to singularities of the first kind (least[0], of B: the
 * platform loses a motion) and of the second (least[1], of A: the platform has a motion that the
 * drives do not hold): the smallest singular values, lengths in robot sizes.
 * Returns DELTA_OK; DELTA_FREE_JOINT where passive joints of a leg depend on each other:
 * the platform loses a motion, least[0] is 0 and least[1] NaN; or, with NaN in least,
 * -DELTA_INVALID_POSE, likewise. */
DHGEN_PUBLIC int delta_singularities(const double T[16], const double *q, double least[2]);

#ifdef __cplusplus
}
#endif

#endif
