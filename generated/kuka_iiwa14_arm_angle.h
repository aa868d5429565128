/* kuka_iiwa14_arm_angle: KUKA LBR iiwa 14 R820, arm angle given
 *
 * Inverse kinematics, generated from robots/kuka_iiwa14_arm_angle.yaml and
 * templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/kuka_iiwa14_arm_angle.yaml. The formulas and where they come from:
 * kuka_iiwa14_arm_angle.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: d4722574f6bbef95
 * SPDX-License-Identifier: MIT
 */
#ifndef KUKA_IIWA14_ARM_ANGLE_H
#define KUKA_IIWA14_ARM_ANGLE_H

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

#define KUKA_IIWA14_ARM_ANGLE_METHOD "closed form"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define KUKA_IIWA14_ARM_ANGLE_JOINT_TYPES "RRRRRRR"
#define KUKA_IIWA14_ARM_ANGLE_JOINT_NAMES \
    "joint1", "joint2", "joint3", "joint4", "joint5", "joint6", "joint7"
#define KUKA_IIWA14_ARM_ANGLE_JOINT_LIMITS \
    { -2.9670597283903604, 2.9670597283903604 }, { -2.0943951023931953, 2.0943951023931953 }, \
    { -2.9670597283903604, 2.9670597283903604 }, { -2.0943951023931953, 2.0943951023931953 }, \
    { -2.9670597283903604, 2.9670597283903604 }, { -2.0943951023931953, 2.0943951023931953 }, \
    { -3.0543261909900767, 3.0543261909900767 }

enum {
    KUKA_IIWA14_ARM_ANGLE_DOF = 7, /* joints */
    KUKA_IIWA14_ARM_ANGLE_FREE = 1, /* the arm angle, which the caller gives [rad] */
    KUKA_IIWA14_ARM_ANGLE_ROWS = 8 /* branches */
};

/* What a row of kuka_iiwa14_arm_angle_ik holds. */
enum {
    /* joint values */
    KUKA_IIWA14_ARM_ANGLE_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    KUKA_IIWA14_ARM_ANGLE_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    KUKA_IIWA14_ARM_ANGLE_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    KUKA_IIWA14_ARM_ANGLE_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose, or the arm angle is not finite */
    KUKA_IIWA14_ARM_ANGLE_INVALID_POSE = 4
};

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const kuka_iiwa14_arm_angle_branches[8];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void kuka_iiwa14_arm_angle_fk(const double q[7], double T[16]);

/* The frames of the base, of the links as the robot file has them, and of the tool. */
DHGEN_PUBLIC void kuka_iiwa14_arm_angle_frames(const double q[7], double frames[9][16]);

/* The geometric Jacobian, 6 x 7 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void kuka_iiwa14_arm_angle_jacobian(const double q[7], double J[42]);

/* The joint velocities with which the tool moves by a twist, what the task names of it (velocity of
 * its origin, angular velocity): least squares of least norm, exact where the arm is regular. Near
 * a singular pose what the arm hardly can do is damped: no joint velocity exceeds a hundred times
 * the twist, lengths in arm sizes. */
DHGEN_PUBLIC void kuka_iiwa14_arm_angle_joint_velocities(
    const double q[7], const double twist[6], double velocities[7]);

/* The arm angle of the joint values q, in (-pi, pi]: it turns the elbow about the line from the
 * shoulder to the wrist; zero is where the elbow leans towards the direction of axis 1. */
DHGEN_PUBLIC double kuka_iiwa14_arm_angle_arm_angle(const double q[7]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * at this pose (NULL: zeros). Returns how many rows are OK or FREE_JOINT, or
 * -KUKA_IIWA14_ARM_ANGLE_INVALID_POSE, also for a seed that is not finite where it may be
 * needed. */
DHGEN_PUBLIC int kuka_iiwa14_arm_angle_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[8][7],
    unsigned char status[8]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed. Returns KUKA_IIWA14_ARM_ANGLE_OK or KUKA_IIWA14_ARM_ANGLE_FREE_JOINT, or, with NaN in q,
 * minus KUKA_IIWA14_ARM_ANGLE_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a
 * seed that is not finite. */
DHGEN_PUBLIC int kuka_iiwa14_arm_angle_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7]);

/* kuka_iiwa14_arm_angle_ik without a seed for n poses: T holds n x 16 numbers, free_joints n x 1,
 * q n x 8 x 7, status n x 8. */
DHGEN_PUBLIC void kuka_iiwa14_arm_angle_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
