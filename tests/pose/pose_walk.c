/* Every pose helper over a grid of singular, near-singular and broken inputs, for the sanitizers.
 * Exits with 1 and a line number where a code or a round trip is wrong. */
#include "dhgen_pose.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define EXPECT(condition)                                                                          \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            printf("line %d: %s\n", __LINE__, #condition);                                         \
            return 1;                                                                              \
        }                                                                                          \
    } while (0)

static const double half_turn = 3.14159265358979323846;

static double distance(const double A[16], const double B[16])
{
    double largest = 0.0;
    for (int i = 0; i < 16; i++) {
        largest = fmax(largest, fabs(A[i] - B[i]));
    }
    return largest;
}

static int reads_and_writes(const double T[16])
{
    double xyz[3], v[3], q[4], angle, again[16];
    EXPECT(dhgen_pose_to_xyz_rpy(T, xyz, v) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_rpy(xyz, v, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_quaternion_xyzw(T, xyz, q) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_quaternion_xyzw(xyz, q, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_quaternion_wxyz(T, xyz, q) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_quaternion_wxyz(xyz, q, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_axis_angle(T, xyz, v, &angle) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_axis_angle(xyz, v, angle, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_euler_zxz(T, xyz, v) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_euler_zxz(xyz, v, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_euler_zyz(T, xyz, v) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_euler_zyz(xyz, v, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_rotvec(T, xyz, v) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_rotvec(xyz, v, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_abc_deg(T, xyz, v) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_abc_deg(xyz, v, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    EXPECT(dhgen_pose_to_xyz_wpr_deg(T, xyz, v) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_from_xyz_wpr_deg(xyz, v, again) == DHGEN_POSE_OK);
    EXPECT(distance(T, again) <= 4e-15);
    double inverse[16];
    EXPECT(dhgen_pose_inverse(T, inverse) == DHGEN_POSE_OK);
    EXPECT(dhgen_pose_multiply(T, inverse, again) == DHGEN_POSE_OK);
    EXPECT(fabs(again[0] - 1.0) + fabs(again[5] - 1.0) + fabs(again[10] - 1.0) <= 4e-15);
    return 0;
}

static int walks(const double v[3])
{
    const double xyz[3] = {1.0, -2.0, 1e300};
    const double q[4] = {v[0], v[1], v[2], 1e-9};
    double T[16];
    EXPECT(dhgen_pose_from_xyz_rpy(xyz, v, T) == DHGEN_POSE_OK);
    EXPECT(reads_and_writes(T) == 0);
    EXPECT(dhgen_pose_from_xyz_euler_zxz(xyz, v, T) == DHGEN_POSE_OK);
    EXPECT(reads_and_writes(T) == 0);
    EXPECT(dhgen_pose_from_xyz_euler_zyz(xyz, v, T) == DHGEN_POSE_OK);
    EXPECT(reads_and_writes(T) == 0);
    EXPECT(dhgen_pose_from_xyz_quaternion_xyzw(xyz, q, T) == DHGEN_POSE_OK);
    EXPECT(reads_and_writes(T) == 0);
    const double q_axis[3] = {v[0], v[1], 1.0};
    EXPECT(dhgen_pose_from_xyz_axis_angle(xyz, q_axis, v[2], T) == DHGEN_POSE_OK);
    EXPECT(reads_and_writes(T) == 0);
    return 0;
}

static int refuses(double bad, int code)
{
    const double zeros[4] = {0.0, 0.0, 0.0, 0.0}, unit[4] = {1.0, 0.0, 0.0, 0.0};
    double xyz[3], v[3], q[4], angle, T[16], broken[16];
    for (int i = 0; i < 16; i++) {
        EXPECT(dhgen_pose_from_xyz_rpy(zeros, zeros, T) == DHGEN_POSE_OK);
        memcpy(broken, T, sizeof broken);
        broken[i] = bad;
        if (code == DHGEN_POSE_NOT_RIGID && i % 4 == 3 && i < 12) {
            continue; /* a position may be any finite number */
        }
        EXPECT(dhgen_pose_to_xyz_rpy(broken, xyz, v) == code);
        EXPECT(isnan(xyz[0]) && isnan(v[2]));
        EXPECT(dhgen_pose_to_xyz_quaternion_xyzw(broken, xyz, q) == code);
        EXPECT(dhgen_pose_to_xyz_quaternion_wxyz(broken, xyz, q) == code);
        EXPECT(isnan(xyz[2]) && isnan(q[0]) && isnan(q[3]));
        EXPECT(dhgen_pose_to_xyz_axis_angle(broken, xyz, v, &angle) == code);
        EXPECT(isnan(v[0]) && isnan(angle));
        EXPECT(dhgen_pose_to_xyz_euler_zxz(broken, xyz, v) == code);
        EXPECT(dhgen_pose_to_xyz_euler_zyz(broken, xyz, v) == code);
    }
    EXPECT(dhgen_pose_from_xyz_quaternion_xyzw(zeros, zeros, T) == DHGEN_POSE_ZERO_QUATERNION);
    EXPECT(dhgen_pose_from_xyz_axis_angle(zeros, zeros, 1.0, T) == DHGEN_POSE_ZERO_AXIS);
    EXPECT(isnan(T[0]) && isnan(T[15]));
    if (code == DHGEN_POSE_NOT_FINITE) {
        const double vector[4] = {0.0, bad, 0.0, 0.0};
        EXPECT(dhgen_pose_from_xyz_rpy(vector, zeros, T) == code);
        EXPECT(dhgen_pose_from_xyz_rpy(zeros, vector, T) == code);
        EXPECT(dhgen_pose_from_xyz_quaternion_wxyz(zeros, vector, T) == code);
        EXPECT(dhgen_pose_from_xyz_axis_angle(zeros, unit, bad, T) == code);
        EXPECT(dhgen_pose_from_xyz_euler_zxz(zeros, vector, T) == code);
        EXPECT(dhgen_pose_from_xyz_euler_zyz(zeros, vector, T) == code);
        EXPECT(isnan(T[0]) && isnan(T[15]));
    }
    return 0;
}

int main(void)
{
    const double offsets[] = {0.0, 1e-16, 1e-12, -1e-9, 1e-6, 0.3};
    double grid[54];
    int count = 0;
    for (int eighth = -4; eighth <= 4; eighth++) {
        for (size_t k = 0; k < sizeof offsets / sizeof offsets[0]; k++) {
            grid[count++] = eighth * half_turn / 4.0 + offsets[k];
        }
    }
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            for (int k = 0; k < count; k += 5) {
                const double v[3] = {grid[i], grid[j], grid[k]};
                if (walks(v) != 0) {
                    printf("at %.17g %.17g %.17g\n", v[0], v[1], v[2]);
                    return 1;
                }
            }
        }
    }
    EXPECT(refuses((double)NAN, DHGEN_POSE_NOT_FINITE) == 0);
    EXPECT(refuses((double)INFINITY, DHGEN_POSE_NOT_FINITE) == 0);
    EXPECT(refuses(1.7e308, DHGEN_POSE_NOT_RIGID) == 0);
    EXPECT(refuses(-1e200, DHGEN_POSE_NOT_RIGID) == 0);
    EXPECT(refuses(0.5, DHGEN_POSE_NOT_RIGID) == 0);
    return 0;
}
