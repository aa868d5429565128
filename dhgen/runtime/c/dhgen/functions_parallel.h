/* SPDX-License-Identifier: MIT
 *
 * The functions of a robot that stands on legs. The file that includes this one defines its name
 * (DHGEN_NAME), how many legs, rows, joints and drives there are (see drives.h; DHGEN_DRIVES of the
 * platform, DHGEN_ASSEMBLIES and DHGEN_ELIMINATION where its poses at given drives are found), and
 * before these functions `robot`, `lanes` and `solve_driven`. */
#ifndef DHGEN_FUNCTIONS_PARALLEL_H
#define DHGEN_FUNCTIONS_PARALLEL_H

DHGEN_PUBLIC int DHGEN_NAME(ik)(const double T[16], const double *q_seed,
    double q[DHGEN_LEGS][DHGEN_LEG_ROWS][DHGEN_LEG_JOINTS],
    unsigned char status[DHGEN_LEGS][DHGEN_LEG_ROWS])
{
    return dhgen_parallel_ik(&robot, T, q_seed, &q[0][0][0], &status[0][0]);
}

DHGEN_PUBLIC int DHGEN_NAME(ik_nearest)(
    const double T[16], const double *q_seed, double q[DHGEN_LEGS][DHGEN_LEG_JOINTS])
{
    return dhgen_parallel_nearest(&robot, T, q_seed, &q[0][0]);
}

DHGEN_PUBLIC void DHGEN_NAME(ik_batch)(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_parallel_batch(&robot, n, T, q, status);
}

DHGEN_FN int dhgen_drives_of_pose(const double *T, double *q, unsigned char *status)
{
    return dhgen_parallel_drives(&robot, &lanes, solve_driven, T, q, status);
}

DHGEN_PUBLIC int DHGEN_NAME(ik_drives)(const double T[16],
    double q[DHGEN_LEGS][DHGEN_LEG_ROWS][DHGEN_LEG_DRIVES],
    unsigned char status[DHGEN_LEGS][DHGEN_LEG_ROWS])
{
    return dhgen_drives_of_pose(T, &q[0][0][0], &status[0][0]);
}

DHGEN_PUBLIC void DHGEN_NAME(ik_drives_batch)(
    size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_parallel_drives_batch(
        &robot, &lanes, solve_driven, dhgen_drives_of_pose, n, T, q, status);
}

DHGEN_PUBLIC void DHGEN_NAME(take_drives)(const double *q, double drives[DHGEN_DRIVES])
{
    dhgen_take_drives(&robot, q, drives);
}

DHGEN_PUBLIC int DHGEN_NAME(fk)(const double drives[DHGEN_DRIVES], const double T_seed[16],
    double T[16], double q[DHGEN_LEGS][DHGEN_LEG_JOINTS])
{
    return dhgen_parallel_fk(&robot, drives, T_seed, T, &q[0][0]);
}

#ifdef DHGEN_ASSEMBLIES
DHGEN_PUBLIC int DHGEN_NAME(assemblies)(
    const double drives[DHGEN_DRIVES], double T[DHGEN_ASSEMBLIES][16])
{
    return dhgen_assemblies(&robot, DHGEN_ELIMINATION, drives, &T[0][0]);
}
#endif

DHGEN_PUBLIC int DHGEN_NAME(velocities)(const double T[16], const double *q,
    double A[DHGEN_DRIVES * DHGEN_DRIVES], double B[DHGEN_DRIVES * DHGEN_DRIVES])
{
    return dhgen_parallel_velocities(&robot, T, q, A, B);
}

DHGEN_PUBLIC int DHGEN_NAME(singularities)(const double T[16], const double *q, double least[2])
{
    return dhgen_parallel_singularities(&robot, T, q, least);
}

#endif
