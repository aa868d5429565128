/* SPDX-License-Identifier: MIT
 *
 * Forward kinematics and the Jacobian of arms whose links come at run time: products of these.
 * Included before the rest of the runtime, which calls them by the names defined here. */
#ifndef DHGEN_SERIAL_H
#define DHGEN_SERIAL_H

#ifdef DHGEN_FORWARD
#error "dhgen: serial.h comes before the rest of the runtime"
#endif
#define DHGEN_FORWARD(arm, q, T) dhgen_forward(arm, q, T)
#define DHGEN_RATES(arm, q, J) dhgen_rates(arm, q, J)
#define DHGEN_MOTION_OF_DESCENTS(arm, q, T, J) dhgen_motion_of_descents(arm, q, T, J)

#include "arm.h"
#include "calibration.h"
#include "numerical/arm.h"
#include "rigid.h"

/* What functions of arms whose links come at run time get in place of an arm; hence `arm` comes
 * first. */
struct dhgen_calibrated_arm {
    struct dhgen_arm arm;
    const dhgen_calibration *calibration;
};

/* The arm of descents, likewise. */
struct dhgen_calibrated_descents {
    struct dhgen_numerical_arm arm;
    const dhgen_calibration *calibration;
};

/* The pose of an arm of six turning joints. */
DHGEN_FN void dhgen_serial_pose(const dhgen_calibration *of, const double *q, double *T)
{
    double angle[6];
    for (int i = 0; i < 6; i++)
        angle[i] = of->facing[i] * q[i];
    dhgen_pose_of_links(of->constant, angle, 6, T);
}

/* Its pose, the upper three rows, and its geometric Jacobian, 6 x 6 row by row. */
DHGEN_FN void dhgen_serial_motion(
    const dhgen_calibration *of, const double *q, double *T, double *J)
{
    double axis[6][3], point[6][3];
    dhgen_copy_link(of->constant[0], T);
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 3; k++) {
            axis[i][k] = of->facing[i] * T[4 * k + 2];
            point[i][k] = T[4 * k + 3];
        }
        dhgen_append_turn(T, cos(q[i]), of->facing[i] * sin(q[i]));
        dhgen_append(T, of->constant[i + 1]);
    }
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 3; k++) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            J[6 * k + i] = axis[i][l] * (T[4 * m + 3] - point[i][m])
                - axis[i][m] * (T[4 * l + 3] - point[i][l]);
            J[18 + 6 * k + i] = axis[i][k];
        }
    }
}

/* Its Jacobian alone. */
DHGEN_FN void dhgen_serial_jacobian(const dhgen_calibration *of, const double *q, double *J)
{
    double T[12];
    dhgen_serial_motion(of, q, T, J);
}

/* The pose of joint values. */
DHGEN_INLINE void dhgen_forward(const struct dhgen_arm *arm, const double *q, double *T)
{
    if (arm->fk)
        arm->fk(q, T);
    else
        dhgen_serial_pose(
            ((const struct dhgen_calibrated_arm *)(const void *)arm)->calibration, q, T);
}

/* The Jacobian at joint values. */
DHGEN_INLINE void dhgen_rates(const struct dhgen_arm *arm, const double *q, double *J)
{
    if (arm->jacobian)
        arm->jacobian(q, J);
    else
        dhgen_serial_jacobian(
            ((const struct dhgen_calibrated_arm *)(const void *)arm)->calibration, q, J);
}

/* Pose and Jacobian of joint values, for descents. */
DHGEN_INLINE void dhgen_motion_of_descents(
    const struct dhgen_numerical_arm *arm, const double *q, double *T, double *J)
{
    if (arm->fk) {
        arm->fk(q, T);
        arm->jacobian(q, J);
    } else {
        dhgen_serial_motion(
            ((const struct dhgen_calibrated_descents *)(const void *)arm)->calibration, q, T, J);
    }
}

#endif
