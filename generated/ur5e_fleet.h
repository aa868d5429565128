/* ur5e_fleet: Universal Robots UR5e, calibrated
 *
 * Inverse kinematics, generated from robots/ur5e.yaml and templates/c/calibrated.h.jinja.
 * Do not edit: run dhgen robots/ur5e.yaml. The formulas and where they come from: ur5e.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad.
 * Every entry of a pose counts.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 188073c3e2550859
 * SPDX-License-Identifier: MIT
 */
#ifndef UR5E_FLEET_H
#define UR5E_FLEET_H

#ifndef __CUDACC_RTC__ /* it has their functions without them */
#include <math.h>
#include <stddef.h>
#endif

#include "dhgen/calibration.h"

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

#define UR5E_FLEET_METHOD "general 6R"

/* Of the joints, from base to tool: R turns, P slides; what they are called; lowest and highest
 * value [rad or m], infinite (HUGE_VAL) where there is no limit. */
#define UR5E_FLEET_JOINT_TYPES "RRRRRR"
#define UR5E_FLEET_JOINT_NAMES "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"
#define UR5E_FLEET_JOINT_LIMITS \
    { -6.283185307179586, 6.283185307179586 }, { -6.283185307179586, 6.283185307179586 }, \
    { -6.283185307179586, 6.283185307179586 }, { -6.283185307179586, 6.283185307179586 }, \
    { -6.283185307179586, 6.283185307179586 }, { -6.283185307179586, 6.283185307179586 }

enum {
    UR5E_FLEET_DOF = 6, /* joints */
    UR5E_FLEET_ROWS = 16 /* branches */
};

/* What a row of ur5e_fleet_ik holds. */
enum {
    /* joint values */
    UR5E_FLEET_OK = 0,
    /* NaN: no solution in this branch, or one that an earlier row holds */
    UR5E_FLEET_UNREACHABLE = 1,
    /* joint values; a joint was indeterminate and took the seed's value, or one near it */
    UR5E_FLEET_FREE_JOINT = 2,
    /* joint values, at least one beyond its limits */
    UR5E_FLEET_OUT_OF_LIMITS = 3,
    /* NaN: T is not a valid pose */
    UR5E_FLEET_INVALID_POSE = 4
};

/* What ur5e_fleet_calibrate returns for a table, ur5e_fleet_calibrate_origins for
 * origins. */
enum {
    /* all functions answer for the arm */
    UR5E_FLEET_TAKEN = 0,
    /* a number that is not finite: all members are NaN, so are poses, and none has a solution */
    UR5E_FLEET_NOT_FINITE = 1,
    /* the tool is farther away than calibrations take it, at most by `turned` and `moved`, or a
     * number is above 100000 [rad, arm sizes]; the pose and the Jacobian are right, solutions may
     * be missing, and of far larger numbers wrong */
    UR5E_FLEET_ANOTHER_ARM = 2,
    /* three axes meet, or are parallel, to 1e-9, as the nominal arm's: such an arm needs the closed
     * form of the nominal arm or of a robot file with these numbers; the pose and the Jacobian are
     * right, solutions may be missing */
    UR5E_FLEET_NO_MISS = 3
};

/* An arm of this kind: it holds no pointers, may be copied, and read by several threads. */
typedef dhgen_calibration ur5e_fleet_calibration;

/* The table of the data sheet, standard: theta at q = 0 [rad], d [m], a [m], alpha [rad]. */
#ifndef __CUDA_ARCH__
extern const double ur5e_fleet_nominal[6][4];
#endif

/* Fills in an arm from its table, row by row, with the data sheet's columns. Returns
 * UR5E_FLEET_TAKEN, or what is wrong with it. The table must not be NULL. */
DHGEN_PUBLIC int ur5e_fleet_calibrate(const double *table, ur5e_fleet_calibration *arm);

/* Fills in an arm from joints' frames, as URDFs and drivers give them: x, y, z [m] and
 * roll, pitch, yaw [rad] of each one in the frame before, all joint values zero, from base to tool,
 * seven rows of six: the last row is a frame behind the last joint, zeros where there is none. The
 * base of the robot file comes before them, its tool behind them. Joints turn about z, in the sense
 * of the robot file. */
DHGEN_PUBLIC int ur5e_fleet_calibrate_origins(const double *origins, ur5e_fleet_calibration *arm);

#ifndef __CUDACC_RTC__
/* The name of every row. */
extern const char *const ur5e_fleet_branches[16];
#endif

/* The pose T of the joint values q. */
DHGEN_PUBLIC void ur5e_fleet_fk(const ur5e_fleet_calibration *arm, const double q[6], double T[16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, then angular
 * velocity. */
DHGEN_PUBLIC void ur5e_fleet_jacobian(const ur5e_fleet_calibration *arm, const double q[6], double
    J[36]);

/* The joint velocities with which the tool moves by a twist (velocity of its origin, angular
 * velocity): least squares of least norm, exact where the arm is regular. Near a singular pose what
 * the arm hardly can do is damped: no joint velocity exceeds a hundred times the twist, lengths in
 * arm sizes. */
DHGEN_PUBLIC void ur5e_fleet_joint_velocities(const ur5e_fleet_calibration *arm, const double q[6],
    const double twist[6], double velocities[6]);

/* All solutions, each in the row of the nominal arm that has its posture, or behind these: of
 * several solutions with one posture the first by ascending joint values has its row. (Where they
 * lie next to the nominal arm's rows it is not proven that no second one is near one of these.)
 * q_seed gives the values of joints that are indeterminate at this pose (NULL: zeros). Returns how
 * many rows are OK or FREE_JOINT, or -UR5E_FLEET_INVALID_POSE, also for a seed that is not finite
 * where it may be needed. */
DHGEN_PUBLIC int ur5e_fleet_ik(const ur5e_fleet_calibration *arm, const double T[16], const double
    *q_seed, double q[16][6], unsigned char status[16]);

/* The solution nearest to q_seed, with angles moved by whole turns into their limits. q may be
 * q_seed. Returns UR5E_FLEET_OK or UR5E_FLEET_FREE_JOINT, or, with NaN in q, minus
 * UR5E_FLEET_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE, the last one also for a seed that is
 * not finite; it must not be NULL. */
DHGEN_PUBLIC int ur5e_fleet_ik_nearest(const ur5e_fleet_calibration *arm, const double T[16], const
    double q_seed[6], double q[6]);

/* ur5e_fleet_ik without a seed for n poses: T holds n x 16 numbers,
 * q n x 16 x 6, status n x 16. */
DHGEN_PUBLIC void ur5e_fleet_ik_batch(const ur5e_fleet_calibration *arm, size_t n, const double *T,
    double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
