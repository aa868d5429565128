/* SPDX-License-Identifier: MIT
 *
 * dhgen_pose: poses in other notations, a 4x4 pose to and from what people and vendors write.
 * Part of dhgen, which puts a copy of this file beside the robots that it generates.
 *
 * A pose T is 4x4, row-major: rotation R = T[0..2, 4..6, 8..10], position xyz = T[3, 7, 11] in the
 * unit of length of the caller, last row 0 0 0 1. Angles are in radians, but in degrees where
 * the name says deg.
 *
 * Every function returns DHGEN_POSE_OK, or one of the negative codes below and fills its outputs
 * with NaN, which the solvers reject in turn. Inputs and outputs must not overlap. A T that
 * is only rounded, to float32 or to six decimals, is read to within that rounding. The checks need
 * arithmetic with NaN: do not compile with -ffast-math or -ffinite-math-only.
 *
 * Reading a pose and writing it again gives the same T to about 1e-15, at and near the singular
 * orientations too. There the angles themselves are not unique: each function documents which it
 * returns. dhgen_pose.c names the sources of the formulas. */
#ifndef DHGEN_POSE_H
#define DHGEN_POSE_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
    DHGEN_POSE_OK = 0,
    DHGEN_POSE_NOT_FINITE = -1,      /* an input is NaN or infinite */
    DHGEN_POSE_NOT_RIGID = -2,       /* T is not a rotation and a translation */
    DHGEN_POSE_ZERO_QUATERNION = -3, /* a zero quaternion is not a rotation */
    DHGEN_POSE_ZERO_AXIS = -4        /* a zero axis with an angle other than 0 is not a rotation */
};

/* rpy = roll, pitch, yaw about the fixed axes x, then y, then z: R = Rz(yaw) Ry(pitch) Rx(roll).
 *
 * to: roll and yaw in [-pi, pi], pitch in [-pi/2, pi/2]. At gimbal lock, cos(pitch) = 0, only
 * yaw - roll (pitch = pi/2) or yaw + roll (pitch = -pi/2) is determined: roll is 0 and yaw takes it
 * all. Close to it roll and yaw feel every rounding of T, but together they still give T.
 */
int dhgen_pose_from_xyz_rpy(const double xyz[3], const double rpy[3], double T[16]);
int dhgen_pose_to_xyz_rpy(const double T[16], double xyz[3], double rpy[3]);

/* quaternion_xyzw = x, y, z, w: scalar last. from: any length except 0; q and -q are the same
 * rotation.
 *
 * to: a unit quaternion with w >= 0; for a half turn, w = 0, the one whose first component other
 * than zero is positive.
 */
int dhgen_pose_from_xyz_quaternion_xyzw(
    const double xyz[3], const double quaternion_xyzw[4], double T[16]);
int dhgen_pose_to_xyz_quaternion_xyzw(const double T[16], double xyz[3], double quaternion_xyzw[4]);

/* quaternion_wxyz = w, x, y, z: scalar first; otherwise the same. */
int dhgen_pose_from_xyz_quaternion_wxyz(
    const double xyz[3], const double quaternion_wxyz[4], double T[16]);
int dhgen_pose_to_xyz_quaternion_wxyz(const double T[16], double xyz[3], double quaternion_wxyz[4]);

/* Axis of rotation and right-handed angle about it. from: an axis of any length; zero only together
 * with angle 0.
 *
 * to: a unit axis, angle in [0, pi]. Without rotation the axis is 0, 0, 1. For a half turn both
 * axis and -axis are right: the one whose first component other than zero is positive, and within
 * rounding of a half turn it may be either.
 */
int dhgen_pose_from_xyz_axis_angle(
    const double xyz[3], const double axis[3], double angle, double T[16]);
int dhgen_pose_to_xyz_axis_angle(const double T[16], double xyz[3], double axis[3], double *angle);

/* euler_zxz = a, b, c about z, x', z'': R = Rz(a) Rx(b) Rz(c).
 *
 * to: a and c in [-pi, pi], b in [0, pi]. For sin(b) = 0, first and last axis parallel, only a + c
 * (b = 0) or a - c (b = pi) is determined: c is 0 and a takes it all. Close to it a and c feel
 * every rounding of T, but together they still give T.
 */
int dhgen_pose_from_xyz_euler_zxz(const double xyz[3], const double euler_zxz[3], double T[16]);
int dhgen_pose_to_xyz_euler_zxz(const double T[16], double xyz[3], double euler_zxz[3]);

/* euler_zyz = a, b, c about z, y', z'': R = Rz(a) Ry(b) Rz(c); ranges and sin(b) = 0 as above. */
int dhgen_pose_from_xyz_euler_zyz(const double xyz[3], const double euler_zyz[3], double T[16]);
int dhgen_pose_to_xyz_euler_zyz(const double T[16], double xyz[3], double euler_zyz[3]);

/* rotvec = axis times angle [rad]: rx, ry, rz of UR. to: at most pi long, signs as axis_angle. */
int dhgen_pose_from_xyz_rotvec(const double xyz[3], const double rotvec[3], double T[16]);
int dhgen_pose_to_xyz_rotvec(const double T[16], double xyz[3], double rotvec[3]);

/* abc = A, B, C of KUKA: R = Rz(A) Ry(B) Rx(C); they are yaw, pitch, roll. abc_deg in degrees. */
int dhgen_pose_from_xyz_abc(const double xyz[3], const double abc[3], double T[16]);
int dhgen_pose_to_xyz_abc(const double T[16], double xyz[3], double abc[3]);
int dhgen_pose_from_xyz_abc_deg(const double xyz[3], const double abc_deg[3], double T[16]);
int dhgen_pose_to_xyz_abc_deg(const double T[16], double xyz[3], double abc_deg[3]);

/* wpr = W, P, R of FANUC, Rx, Ry, Rz of Yaskawa: they are rpy. wpr_deg in degrees. */
int dhgen_pose_from_xyz_wpr(const double xyz[3], const double wpr[3], double T[16]);
int dhgen_pose_to_xyz_wpr(const double T[16], double xyz[3], double wpr[3]);
int dhgen_pose_from_xyz_wpr_deg(const double xyz[3], const double wpr_deg[3], double T[16]);
int dhgen_pose_to_xyz_wpr_deg(const double T[16], double xyz[3], double wpr_deg[3]);

/* T is the pose right, given in the frame left, in the frame that left is given in. */
int dhgen_pose_multiply(const double left[16], const double right[16], double T[16]);

/* inverse is the pose of the frame that T is given in, in the frame T. */
int dhgen_pose_inverse(const double T[16], double inverse[16]);

#ifdef __cplusplus
}
#endif

#endif /* DHGEN_POSE_H */
