/* SPDX-License-Identifier: MIT
 *
 * The functions of arms of one kind, whose tables come at run time. The file that includes this one
 * defines its name (DHGEN_NAME), and before these functions `kind`. */
#ifndef DHGEN_FUNCTIONS_CALIBRATED_H
#define DHGEN_FUNCTIONS_CALIBRATED_H

DHGEN_PUBLIC int DHGEN_NAME(calibrate)(const double *table, dhgen_calibration *arm)
{
    return dhgen_calibrate(&kind, table, arm);
}

DHGEN_PUBLIC int DHGEN_NAME(calibrate_origins)(const double *origins, dhgen_calibration *arm)
{
    return dhgen_calibrate_origins(&kind, origins, arm);
}

DHGEN_PUBLIC void DHGEN_NAME(fk)(
    const dhgen_calibration *arm, const double q[DHGEN_DOF], double T[16])
{
    dhgen_serial_pose(arm, q, T);
}

DHGEN_PUBLIC void DHGEN_NAME(jacobian)(
    const dhgen_calibration *arm, const double q[DHGEN_DOF], double J[6 * DHGEN_DOF])
{
    dhgen_serial_jacobian(arm, q, J);
}

DHGEN_PUBLIC void DHGEN_NAME(joint_velocities)(const dhgen_calibration *arm,
    const double q[DHGEN_DOF], const double twist[6], double velocities[DHGEN_DOF])
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    dhgen_joint_velocities(&own.arm, q, twist, velocities);
}

DHGEN_PUBLIC int DHGEN_NAME(ik)(const dhgen_calibration *arm, const double T[16],
    const double *q_seed, double q[DHGEN_ROWS][DHGEN_DOF], unsigned char status[DHGEN_ROWS])
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    return dhgen_ik(&own.arm, T, dhgen_handed_on(arm), q_seed, &q[0][0], status);
}

DHGEN_PUBLIC int DHGEN_NAME(ik_nearest)(const dhgen_calibration *arm, const double T[16],
    const double q_seed[DHGEN_DOF], double q[DHGEN_DOF])
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    return dhgen_ik_nearest(&own.arm, T, dhgen_handed_on(arm), q_seed, q);
}

DHGEN_PUBLIC void DHGEN_NAME(ik_batch)(
    const dhgen_calibration *arm, size_t n, const double *T, double *q, unsigned char *status)
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    dhgen_ik_each(&own.arm, 0, n, T, dhgen_handed_on(arm), q, status);
}

#endif
