/* five_bar: Planar five-bar linkage (RR legs)
 *
 * Inverse kinematics, generated from robots/five_bar.yaml and templates/c/parallel.h.jinja.
 * Do not edit: run dhgen robots/five_bar.yaml. The formulas and where they come from: five_bar.md.
 *
 * A platform on 2 legs, each of which is a serial arm: compile five_bar.c five_bar_leg.c together.
 * Poses are row-major 4 x 4 matrices of the platform in the base frame, lengths in m, angles in
 * rad. Of a pose its place in the plane of x and y alone counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 5e95f08d2a024264
 * SPDX-License-Identifier: MIT
 */
#ifndef FIVE_BAR_H
#define FIVE_BAR_H

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
    FIVE_BAR_LEGS = 2,
    FIVE_BAR_JOINTS = 2, /* of a leg, passive ones among them */
    FIVE_BAR_ROWS = 2, /* branches of a leg */
    FIVE_BAR_DOF = 2 /* of the platform, which has as many driven joints */
};

/* What a row of five_bar_ik holds. */
enum {
    /* joint values */
    FIVE_BAR_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    FIVE_BAR_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    FIVE_BAR_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    FIVE_BAR_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    FIVE_BAR_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row of every leg. A working mode is a row of each leg. */
extern const char *const *const five_bar_branches[2];
#endif

/* The leg and the joint of every drive, from 0. */
#ifndef __CUDA_ARCH__
extern const int five_bar_drives[2][2];
#endif

/* Joint values of all legs are a double q[2][2]. Where they are read, as `const double *`, they are
 * passed as q[0]: C99 takes no pointer to arrays for one to arrays of constants. */

/* All solutions of all legs. Row b of a leg is always its branch b. q_seed gives the values of
 * joints that are indeterminate at this pose (NULL: zeros).
 * Returns how many working modes there are, the product of the legs' rows that are OK or
 * FREE_JOINT, or -FIVE_BAR_INVALID_POSE, also for a seed that is not finite where it may be
 * needed. */
DHGEN_PUBLIC int five_bar_ik(const double T[16], const double *q_seed,
    double q[2][2][2], unsigned char status[2][2]);

/* Of every leg the solution nearest to q_seed, with angles moved by whole turns into their limits.
 * Returns FIVE_BAR_OK or FIVE_BAR_FREE_JOINT, or, with NaN in q, minus what is wrong with a
 * leg: FIVE_BAR_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed that
 * is not finite. */
DHGEN_PUBLIC int five_bar_ik_nearest(
    const double T[16], const double *q_seed, double q[2][2]);

/* five_bar_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 2 x 2 x 2, status n x 2 x 2. */
DHGEN_PUBLIC void five_bar_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

/* The driven joints alone of what five_bar_ik gives: as controllers need them, in less time. Row b
 * of a leg has its driven joints in their order, and the status that it has with passive ones. */
DHGEN_PUBLIC int five_bar_ik_drives(const double T[16],
    double q[2][2][1], unsigned char status[2][2]);

/* five_bar_ik_drives for n poses: q n x 2 x 2 x 1, status n x 2 x 2. */
DHGEN_PUBLIC void five_bar_ik_drives_batch(
    size_t n, const double *T, double *q, unsigned char *status);

/* The values of the driven joints. */
DHGEN_PUBLIC void five_bar_take_drives(const double *q, double drives[2]);

/* The pose of the platform that drives' values make, and the joint values of all legs, refined from
 * T_seed: a pose nearby that the legs reach.
 * Returns FIVE_BAR_OK; FIVE_BAR_FREE_JOINT where the platform is singular there, so that other
 * poses meet this one, or it or passive joints of a leg can move; or, with NaN in T and q,
 * -FIVE_BAR_UNREACHABLE where the legs did not meet the platform or do not reach the seed, or
 * -FIVE_BAR_INVALID_POSE. */
DHGEN_PUBLIC int five_bar_fk(const double drives[2], const double T_seed[16],
    double T[16], double q[2][2]);

/* All poses of the platform that drives' values allow, at most 2. Returns how many there
 * are, or, with T of no use, -FIVE_BAR_FREE_JOINT where they are a continuum, as the platform can
 * move while its drives are held, or -FIVE_BAR_INVALID_POSE for drives that are not finite. */
DHGEN_PUBLIC int five_bar_assemblies(const double drives[2], double T[2][16]);

/* A and B, with A xdot = B qdot at a pose and its joint values: xdot are the platform's velocities
 * (vx, vy), qdot those of the drives. Returns FIVE_BAR_OK, or, with NaN in A
 * and B, -FIVE_BAR_FREE_JOINT where passive joints of a leg depend on each other, so that A and B
 * are not determined, or -FIVE_BAR_INVALID_POSE, also for joint values that are not finite. */
DHGEN_PUBLIC int five_bar_velocities(
    const double T[16], const double *q, double A[4], double B[4]);

/* How near a pose and its joint values are to singularities of the first kind (least[0], of B: the
 * platform loses a motion) and of the second (least[1], of A: the platform has a motion that the
 * drives do not hold): the smallest singular values, lengths in robot sizes.
 * Returns FIVE_BAR_OK; FIVE_BAR_FREE_JOINT where passive joints of a leg depend on each other:
 * the platform loses a motion, least[0] is 0 and least[1] NaN; or, with NaN in least,
 * -FIVE_BAR_INVALID_POSE, likewise. */
DHGEN_PUBLIC int five_bar_singularities(const double T[16], const double *q, double least[2]);

#ifdef __cplusplus
}
#endif

#endif
