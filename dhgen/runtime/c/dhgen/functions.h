/* SPDX-License-Identifier: MIT
 *
 * A robot's public functions, whose caller may give values besides the pose. */
#ifndef DHGEN_FUNCTIONS_H
#define DHGEN_FUNCTIONS_H

#ifndef DHGEN_DO /* coupled drives have others */
#define DHGEN_DO(function) dhgen_##function
#endif

#ifdef DHGEN_CALLER_GIVES
#define DHGEN_AND_GIVEN , const double free_joints[DHGEN_CALLER_GIVES]
#define DHGEN_AND_MANY_GIVEN , const double *free_joints
#define DHGEN_GIVEN_VALUES free_joints
#else
#define DHGEN_AND_GIVEN
#define DHGEN_AND_MANY_GIVEN
#define DHGEN_GIVEN_VALUES NULL
#endif

#ifdef DHGEN_FRAMES
DHGEN_PUBLIC void DHGEN_NAME(frames)(const double q[DHGEN_DOF], double frames[DHGEN_FRAMES][16])
{
    dhgen_frames(&links, q, frames);
}
#endif

DHGEN_PUBLIC void DHGEN_NAME(joint_velocities)(
    const double q[DHGEN_DOF], const double twist[6], double velocities[DHGEN_DOF])
{
    dhgen_joint_velocities(&arm, q, twist, velocities);
}

DHGEN_PUBLIC int DHGEN_NAME(ik)(const double T[16] DHGEN_AND_GIVEN, const double *q_seed,
    double q[DHGEN_ROWS][DHGEN_DOF], unsigned char status[DHGEN_ROWS])
{
#ifdef DHGEN_SOLVE_WIDE
    const int count = solve_regular(T, DHGEN_GIVEN_VALUES, &q[0][0], status);
    if (count >= 0)
        return count;
    return dhgen_careful_ik(&arm, T, DHGEN_GIVEN_VALUES, q_seed, &q[0][0], status);
#else
    return DHGEN_DO(ik)(&arm, T, DHGEN_GIVEN_VALUES, q_seed, &q[0][0], status);
#endif
}

DHGEN_PUBLIC int DHGEN_NAME(ik_nearest)(
    const double T[16] DHGEN_AND_GIVEN, const double q_seed[DHGEN_DOF], double q[DHGEN_DOF])
{
    return DHGEN_DO(ik_nearest)(&arm, T, DHGEN_GIVEN_VALUES, q_seed, q);
}

DHGEN_PUBLIC void DHGEN_NAME(ik_batch)(
    size_t n, const double *T DHGEN_AND_MANY_GIVEN, double *q, unsigned char *status)
{
#ifdef DHGEN_SOLVE_WIDE
    dhgen_ik_batch(&arm, DHGEN_SOLVE_WIDE, arm.given, n, T, DHGEN_GIVEN_VALUES, q, status);
#else
    DHGEN_DO(ik_each)(&arm, 0, n, T, DHGEN_GIVEN_VALUES, q, status);
#endif
}

#endif
