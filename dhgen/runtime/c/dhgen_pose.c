/* SPDX-License-Identifier: MIT
 *
 * dhgen_pose: poses in the notations that dhgen_pose.h lists.
 * Part of dhgen, which puts a copy of this file beside the robots that it generates.
 *
 * "Document 001" is one of the course texts that dhgen follows, a chapter on kinematics in French.
 * Its sections 2.1.5 (axis and angle, quaternions) and 2.1.8 (Euler angles, roll-pitch-yaw) name
 * these notations; what is taken from it is written out here. */
#include "dhgen_pose.h"

#include <math.h>

/* How far T may be from a rigid transform, per entry of R - cof(R). Rounding every entry by 1e-6
 * makes less than 5e-6; a wrong matrix is off by far more. */
static const double rigid_tolerance = 1e-5;

/* The sine or cosine below which two axes count as parallel: what rounding leaves of zero. It
 * bounds the error of T that the convention for the indeterminate angle may cause. */
static const double parallel_tolerance = 1e-15;

static const double degree = 3.14159265358979323846 / 180.0;

static int all_finite(const double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            return 0;
        }
    }
    return 1;
}

static void fill_nan(double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        numbers[i] = (double)NAN;
    }
}

static double largest_of_three(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* The angle of a sine and a cosine with any common factor; -0.0 counts as 0.0. Without that a half
 * turn whose sine is -0.0 would be -pi, and no rotation would print as -0. */
static double angle_of(double sine, double cosine)
{
    return atan2(sine + 0.0, cosine);
}

/* The pose without rotation at xyz; NaN and infinity, there or in the orientation, are refused. */
static int pose_at(const double xyz[3], const double *orientation, int count, double T[16])
{
    if (!all_finite(xyz, 3) || !all_finite(orientation, count)) {
        fill_nan(T, 16);
        return DHGEN_POSE_NOT_FINITE;
    }
    for (int i = 0; i < 16; i++) {
        T[i] = i % 5 == 0 ? 1.0 : 0.0;
    }
    for (int i = 0; i < 3; i++) {
        T[4 * i + 3] = xyz[i];
    }
    return DHGEN_POSE_OK;
}

/* Whether T is a rotation and a translation. The matrices equal to their cofactors are the
 * rotations, right-handed only, and zero: each row is the cross product of the next two, and the
 * length of one row is that of zero or of a rotation. The comparisons are false for a NaN from an
 * overflow. */
static int is_rigid(const double T[16])
{
    if (!(largest_of_three(T + 12) <= rigid_tolerance && fabs(T[15] - 1.0) <= rigid_tolerance
            && fabs(T[0] * T[0] + T[1] * T[1] + T[2] * T[2] - 1.0) <= rigid_tolerance)) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        const double *row1 = T + 4 * ((i + 1) % 3), *row2 = T + 4 * ((i + 2) % 3);
        for (int j = 0; j < 3; j++) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double cofactor = row1[j1] * row2[j2] - row1[j2] * row2[j1];
            if (!(fabs(cofactor - T[4 * i + j]) <= rigid_tolerance)) {
                return 0;
            }
        }
    }
    return 1;
}

/* Checks T and reads its position; refusing it, fills both outputs with NaN. */
static int position_of(const double T[16], double xyz[3], double *orientation, int count)
{
    const int finite = all_finite(T, 16);
    if (!finite || !is_rigid(T)) {
        fill_nan(xyz, 3);
        fill_nan(orientation, count);
        return finite ? DHGEN_POSE_NOT_RIGID : DHGEN_POSE_NOT_FINITE;
    }
    for (int i = 0; i < 3; i++) {
        xyz[i] = T[4 * i + 3];
    }
    return DHGEN_POSE_OK;
}

/* Whether -q is the one to return: the first of w, x, y, z that is not zero is negative. */
static int is_negative(const double q[4])
{
    for (int i = 3; i < 7; i++) {
        if (q[i % 4] != 0.0) {
            return q[i % 4] < 0.0;
        }
    }
    return 0;
}

/* The unit quaternion x, y, z, w of a pose (Shepperd 1978): w >= 0.
 *
 * Document 001, eq. (11i), takes each component from a root of its own. Near zero such a root turns
 * an error of 1e-16 in R into 1e-8, and for a half turn its sgn(0) loses the vector. The sums and
 * differences of R are 4 w q, 4 x q, 4 y q, 4 z q: of these four multiples of q the one with the
 * largest factor, at least 2 long, has no cancellation, and its signs belong together. */
static void quaternion_xyzw_of(const double T[16], double q[4])
{
    const double r11 = T[0], r22 = T[5], r33 = T[10], trace = r11 + r22 + r33;
    const double wx = T[9] - T[6], wy = T[2] - T[8], wz = T[4] - T[1];
    const double xy = T[1] + T[4], yz = T[6] + T[9], xz = T[2] + T[8];
    if (trace >= r11 && trace >= r22 && trace >= r33) {
        q[0] = wx, q[1] = wy, q[2] = wz, q[3] = 1.0 + trace;
    } else if (r11 >= r22 && r11 >= r33) {
        q[0] = 1.0 + r11 - r22 - r33, q[1] = xy, q[2] = xz, q[3] = wx;
    } else if (r22 >= r33) {
        q[0] = xy, q[1] = 1.0 - r11 + r22 - r33, q[2] = yz, q[3] = wy;
    } else {
        q[0] = xz, q[1] = yz, q[2] = 1.0 - r11 - r22 + r33, q[3] = wz;
    }
    const double norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double length = is_negative(q) ? -norm : norm;
    for (int i = 0; i < 4; i++) {
        q[i] = q[i] / length + 0.0; /* a zero divided by a negative length is -0.0 */
    }
}

/* Document 001, section 2.1.8; the product written out as in Paul, Robot Manipulators (1981). */
int dhgen_pose_from_xyz_rpy(const double xyz[3], const double rpy[3], double T[16])
{
    const int code = pose_at(xyz, rpy, 3, T);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    const double cr = cos(rpy[0]), sr = sin(rpy[0]);
    const double cp = cos(rpy[1]), sp = sin(rpy[1]);
    const double cy = cos(rpy[2]), sy = sin(rpy[2]);
    T[0] = cy * cp, T[1] = cy * sp * sr - sy * cr, T[2] = cy * sp * cr + sy * sr;
    T[4] = sy * cp, T[5] = sy * sp * sr + cy * cr, T[6] = sy * sp * cr - cy * sr;
    T[8] = -sp, T[9] = cp * sr, T[10] = cp * cr;
    return DHGEN_POSE_OK;
}

int dhgen_pose_to_xyz_rpy(const double T[16], double xyz[3], double rpy[3])
{
    const int code = position_of(T, xyz, rpy, 3);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    double cp = hypot(T[0], T[4]);
    if (cp > parallel_tolerance) {
        /* The second row of Rz(-yaw) R is 0, cos(roll), -sin(roll); the factor cp cancels. */
        rpy[0] = angle_of(T[4] * T[2] - T[0] * T[6], T[0] * T[5] - T[4] * T[1]);
        rpy[2] = angle_of(T[4], T[0]);
    } else {
        cp = 0.0;
        rpy[0] = 0.0;
        rpy[2] = angle_of(-T[1], T[5]);
    }
    rpy[1] = angle_of(-T[8], cp);
    return DHGEN_POSE_OK;
}

/* Document 001, eq. (11h), with its 1 replaced by eq. (11c): R is orthonormal to rounding for a
 * quaternion of any length, and no square root is taken. */
int dhgen_pose_from_xyz_quaternion_xyzw(
    const double xyz[3], const double quaternion_xyzw[4], double T[16])
{
    const double *q = quaternion_xyzw;
    const int code = pose_at(xyz, q, 4, T);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    const double largest = fmax(largest_of_three(q), fabs(q[3]));
    if (largest == 0.0) {
        fill_nan(T, 16);
        return DHGEN_POSE_ZERO_QUATERNION;
    }
    /* Scaled first: the squares of very long or short quaternions would leave the range. */
    const double x = q[0] / largest, y = q[1] / largest, z = q[2] / largest, w = q[3] / largest;
    const double k = 2.0 / (x * x + y * y + z * z + w * w);
    T[0] = 1.0 - k * (y * y + z * z), T[1] = k * (x * y - w * z), T[2] = k * (x * z + w * y);
    T[4] = k * (x * y + w * z), T[5] = 1.0 - k * (x * x + z * z), T[6] = k * (y * z - w * x);
    T[8] = k * (x * z - w * y), T[9] = k * (y * z + w * x), T[10] = 1.0 - k * (x * x + y * y);
    return DHGEN_POSE_OK;
}

int dhgen_pose_to_xyz_quaternion_xyzw(const double T[16], double xyz[3], double quaternion_xyzw[4])
{
    const int code = position_of(T, xyz, quaternion_xyzw, 4);
    if (code == DHGEN_POSE_OK) {
        quaternion_xyzw_of(T, quaternion_xyzw);
    }
    return code;
}

/* Scalar first, as document 001, eq. (11a), writes it. */
int dhgen_pose_from_xyz_quaternion_wxyz(
    const double xyz[3], const double quaternion_wxyz[4], double T[16])
{
    const double *q = quaternion_wxyz;
    const double quaternion_xyzw[4] = { q[1], q[2], q[3], q[0] };
    return dhgen_pose_from_xyz_quaternion_xyzw(xyz, quaternion_xyzw, T);
}

int dhgen_pose_to_xyz_quaternion_wxyz(const double T[16], double xyz[3], double quaternion_wxyz[4])
{
    double q[4];
    const int code = dhgen_pose_to_xyz_quaternion_xyzw(T, xyz, q);
    for (int i = 0; i < 4; i++) {
        quaternion_wxyz[i] = q[(i + 3) % 4];
    }
    return code;
}

/* Document 001, eq. (10). */
int dhgen_pose_from_xyz_axis_angle(
    const double xyz[3], const double axis[3], double angle, double T[16])
{
    const double orientation[4] = { axis[0], axis[1], axis[2], angle };
    const int code = pose_at(xyz, orientation, 4, T);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    const double largest = largest_of_three(axis);
    if (largest == 0.0) {
        if (angle == 0.0) {
            return DHGEN_POSE_OK;
        }
        fill_nan(T, 16);
        return DHGEN_POSE_ZERO_AXIS;
    }
    /* Scaled first: the squares of very long or short axes would leave the range. */
    const double vx = axis[0] / largest, vy = axis[1] / largest, vz = axis[2] / largest;
    const double length = sqrt(vx * vx + vy * vy + vz * vz);
    const double x = vx / length, y = vy / length, z = vz / length;
    const double c = cos(angle), s = sin(angle), u = 1.0 - c;
    T[0] = u * x * x + c, T[1] = u * x * y - s * z, T[2] = u * x * z + s * y;
    T[4] = u * x * y + s * z, T[5] = u * y * y + c, T[6] = u * y * z - s * x;
    T[8] = u * x * z - s * y, T[9] = u * y * z + s * x, T[10] = u * z * z + c;
    return DHGEN_POSE_OK;
}

/* From the quaternion (document 001, eq. (11b)): the axis in eq. (11) is divided by sin(angle),
 * which loses it near 0 and pi. */
int dhgen_pose_to_xyz_axis_angle(const double T[16], double xyz[3], double axis[3], double *angle)
{
    double q[4];
    const int code = position_of(T, xyz, axis, 3);
    if (code != DHGEN_POSE_OK) {
        *angle = (double)NAN;
        return code;
    }
    quaternion_xyzw_of(T, q);
    const double largest = largest_of_three(q);
    if (largest == 0.0) {
        axis[0] = axis[1] = 0.0;
        axis[2] = 1.0;
        *angle = 0.0;
        return DHGEN_POSE_OK;
    }
    /* Scaled first: the squares of the sines of tiny angles would underflow. */
    const double x = q[0] / largest, y = q[1] / largest, z = q[2] / largest;
    const double length = sqrt(x * x + y * y + z * z);
    axis[0] = x / length, axis[1] = y / length, axis[2] = z / length;
    *angle = 2.0 * atan2(length * largest, q[3]);
    return DHGEN_POSE_OK;
}

/* Document 001, section 2.1.8, eq. (15). */
int dhgen_pose_from_xyz_euler_zxz(const double xyz[3], const double euler_zxz[3], double T[16])
{
    const int code = pose_at(xyz, euler_zxz, 3, T);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    const double ca = cos(euler_zxz[0]), sa = sin(euler_zxz[0]);
    const double cb = cos(euler_zxz[1]), sb = sin(euler_zxz[1]);
    const double cc = cos(euler_zxz[2]), sc = sin(euler_zxz[2]);
    T[0] = ca * cc - sa * cb * sc, T[1] = -ca * sc - sa * cb * cc, T[2] = sa * sb;
    T[4] = sa * cc + ca * cb * sc, T[5] = -sa * sc + ca * cb * cc, T[6] = -ca * sb;
    T[8] = sb * sc, T[9] = sb * cc, T[10] = cb;
    return DHGEN_POSE_OK;
}

int dhgen_pose_to_xyz_euler_zxz(const double T[16], double xyz[3], double euler_zxz[3])
{
    const int code = position_of(T, xyz, euler_zxz, 3);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    double sb = hypot(T[2], T[6]);
    if (sb > parallel_tolerance) {
        /* The first row of Rz(-a) R is cos(c), -sin(c), 0; the factor sb cancels. */
        euler_zxz[0] = angle_of(T[2], -T[6]);
        euler_zxz[2] = angle_of(T[6] * T[1] - T[2] * T[5], T[2] * T[4] - T[6] * T[0]);
    } else {
        sb = 0.0;
        euler_zxz[0] = angle_of(T[4], T[0]);
        euler_zxz[2] = 0.0;
    }
    euler_zxz[1] = angle_of(sb, T[10]);
    return DHGEN_POSE_OK;
}

/* Document 001, section 2.1.8, eq. (15) with y in place of x, as in Paul, Robot Manipulators
 * (1981). */
int dhgen_pose_from_xyz_euler_zyz(const double xyz[3], const double euler_zyz[3], double T[16])
{
    const int code = pose_at(xyz, euler_zyz, 3, T);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    const double ca = cos(euler_zyz[0]), sa = sin(euler_zyz[0]);
    const double cb = cos(euler_zyz[1]), sb = sin(euler_zyz[1]);
    const double cc = cos(euler_zyz[2]), sc = sin(euler_zyz[2]);
    T[0] = ca * cb * cc - sa * sc, T[1] = -ca * cb * sc - sa * cc, T[2] = ca * sb;
    T[4] = sa * cb * cc + ca * sc, T[5] = -sa * cb * sc + ca * cc, T[6] = sa * sb;
    T[8] = -sb * cc, T[9] = sb * sc, T[10] = cb;
    return DHGEN_POSE_OK;
}

int dhgen_pose_to_xyz_euler_zyz(const double T[16], double xyz[3], double euler_zyz[3])
{
    const int code = position_of(T, xyz, euler_zyz, 3);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    double sb = hypot(T[2], T[6]);
    if (sb > parallel_tolerance) {
        /* The second row of Rz(-a) R is sin(c), cos(c), 0; the factor sb cancels. */
        euler_zyz[0] = angle_of(T[6], T[2]);
        euler_zyz[2] = angle_of(T[2] * T[4] - T[6] * T[0], T[2] * T[5] - T[6] * T[1]);
    } else {
        sb = 0.0;
        euler_zyz[0] = angle_of(-T[1], T[5]);
        euler_zyz[2] = 0.0;
    }
    euler_zyz[1] = angle_of(sb, T[10]);
    return DHGEN_POSE_OK;
}

int dhgen_pose_from_xyz_rotvec(const double xyz[3], const double rotvec[3], double T[16])
{
    const double angle = hypot(hypot(rotvec[0], rotvec[1]), rotvec[2]);
    return dhgen_pose_from_xyz_axis_angle(xyz, rotvec, angle, T);
}

int dhgen_pose_to_xyz_rotvec(const double T[16], double xyz[3], double rotvec[3])
{
    double axis[3], angle;
    const int code = dhgen_pose_to_xyz_axis_angle(T, xyz, axis, &angle);
    for (int i = 0; i < 3; i++) {
        rotvec[i] = axis[i] * angle;
    }
    return code;
}

int dhgen_pose_from_xyz_abc(const double xyz[3], const double abc[3], double T[16])
{
    const double rpy[3] = { abc[2], abc[1], abc[0] };
    return dhgen_pose_from_xyz_rpy(xyz, rpy, T);
}

int dhgen_pose_to_xyz_abc(const double T[16], double xyz[3], double abc[3])
{
    double rpy[3];
    const int code = dhgen_pose_to_xyz_rpy(T, xyz, rpy);
    for (int i = 0; i < 3; i++) {
        abc[i] = rpy[2 - i];
    }
    return code;
}

int dhgen_pose_from_xyz_abc_deg(const double xyz[3], const double abc_deg[3], double T[16])
{
    const double abc[3] = { abc_deg[0] * degree, abc_deg[1] * degree, abc_deg[2] * degree };
    return dhgen_pose_from_xyz_abc(xyz, abc, T);
}

int dhgen_pose_to_xyz_abc_deg(const double T[16], double xyz[3], double abc_deg[3])
{
    const int code = dhgen_pose_to_xyz_abc(T, xyz, abc_deg);
    for (int i = 0; i < 3; i++) {
        abc_deg[i] /= degree;
    }
    return code;
}

int dhgen_pose_from_xyz_wpr(const double xyz[3], const double wpr[3], double T[16])
{
    return dhgen_pose_from_xyz_rpy(xyz, wpr, T);
}

int dhgen_pose_to_xyz_wpr(const double T[16], double xyz[3], double wpr[3])
{
    return dhgen_pose_to_xyz_rpy(T, xyz, wpr);
}

int dhgen_pose_from_xyz_wpr_deg(const double xyz[3], const double wpr_deg[3], double T[16])
{
    const double wpr[3] = { wpr_deg[0] * degree, wpr_deg[1] * degree, wpr_deg[2] * degree };
    return dhgen_pose_from_xyz_wpr(xyz, wpr, T);
}

int dhgen_pose_to_xyz_wpr_deg(const double T[16], double xyz[3], double wpr_deg[3])
{
    const int code = dhgen_pose_to_xyz_wpr(T, xyz, wpr_deg);
    for (int i = 0; i < 3; i++) {
        wpr_deg[i] /= degree;
    }
    return code;
}

/* Checks a pose; refusing it, fills T with NaN. */
static int check_pose(const double given[16], double T[16])
{
    const int finite = all_finite(given, 16);
    if (finite && is_rigid(given)) {
        return DHGEN_POSE_OK;
    }
    fill_nan(T, 16);
    return finite ? DHGEN_POSE_NOT_RIGID : DHGEN_POSE_NOT_FINITE;
}

int dhgen_pose_multiply(const double left[16], const double right[16], double T[16])
{
    const int of_left = check_pose(left, T), of_right = check_pose(right, T);
    if (of_left != DHGEN_POSE_OK || of_right != DHGEN_POSE_OK) {
        return of_left != DHGEN_POSE_OK ? of_left : of_right;
    }
    for (int i = 0; i < 3; i++) {
        const double *row = left + 4 * i;
        for (int j = 0; j < 4; j++) {
            T[4 * i + j] = row[0] * right[j] + row[1] * right[4 + j] + row[2] * right[8 + j];
        }
        T[4 * i + 3] += row[3];
    }
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
    return DHGEN_POSE_OK;
}

int dhgen_pose_inverse(const double T[16], double inverse[16])
{
    const int code = check_pose(T, inverse);
    if (code != DHGEN_POSE_OK) {
        return code;
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            inverse[4 * i + j] = T[4 * j + i];
        }
        inverse[4 * i + 3] = -(T[i] * T[3] + T[4 + i] * T[7] + T[8 + i] * T[11]);
        inverse[12 + i] = 0.0;
    }
    inverse[15] = 1.0;
    return DHGEN_POSE_OK;
}
