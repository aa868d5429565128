/* parallel_3rpr: Planar platform on three cylinders (3-RPR)
 *
 * Inverse kinematics, generated from robots/parallel_3rpr.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/parallel_3rpr.yaml. The formulas and where they come from:
 * parallel_3rpr.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 579cae9c21aa4644
 * SPDX-License-Identifier: MIT
 */
#include "parallel_3rpr.h"

#include "parallel_3rpr_leg.h"

#include "dhgen/assemblies.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

static const int parallel_3rpr_leg_driven[1] = { 1 };
static const int parallel_3rpr_leg_slides[1] = { 1 };
static const int parallel_3rpr_leg_counted[2] = { 0, 1 };
static const char *const parallel_3rpr_leg_names[2] = { "forward", "backward" };

static int parallel_3rpr_leg_rows(const double *T, const double *q_seed, double *q, unsigned char
    *status)
{
    return parallel_3rpr_leg_ik(T, q_seed, (double (*)[PARALLEL_3RPR_LEG_DOF])q, status);
}

static const struct dhgen_leg legs[3] = {
    /* joints, rows, drives; those, whether they slide, types, what the platform moves; from the
     * robot's base; in the platform; functions */
    {
        2, 2, 1, parallel_3rpr_leg_driven, parallel_3rpr_leg_slides, "RP",
            parallel_3rpr_leg_counted,
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, -0.2, 0.0, 1.0, 0.0, -0.1, 0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rpr_leg_rows, parallel_3rpr_leg_ik_nearest, parallel_3rpr_leg_ik_batch,
            parallel_3rpr_leg_fk, parallel_3rpr_leg_jacobian
    },
    {
        2, 2, 1, parallel_3rpr_leg_driven, parallel_3rpr_leg_slides, "RP",
            parallel_3rpr_leg_counted,
        {
            1.0, 0.0, 0.0, -1.2, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, -0.1, 0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rpr_leg_rows, parallel_3rpr_leg_ik_nearest, parallel_3rpr_leg_ik_batch,
            parallel_3rpr_leg_fk, parallel_3rpr_leg_jacobian
    },
    {
        2, 2, 1, parallel_3rpr_leg_driven, parallel_3rpr_leg_slides, "RP",
            parallel_3rpr_leg_counted,
        {
            1.0, 0.0, 0.0, -0.5, 0.0, 1.0, 0.0, -1.1, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.25, 0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rpr_leg_rows, parallel_3rpr_leg_ik_nearest, parallel_3rpr_leg_ik_batch,
            parallel_3rpr_leg_fk, parallel_3rpr_leg_jacobian
    },
};
static const int freedoms[3] = { 0, 1, 5 };
static const struct dhgen_parallel robot = {
    3, 2, 2, 3,
    1, /* alike */
    freedoms, 1.6, DHGEN_YAW, 1, /* planar */
    legs
};

const char *const *const parallel_3rpr_branches[3] = {
    parallel_3rpr_leg_names,
    parallel_3rpr_leg_names,
    parallel_3rpr_leg_names,
};

const int parallel_3rpr_drives[3][2] = { { 0, 1 }, { 1, 1 }, { 2, 1 } };

int parallel_3rpr_ik(const double T[16], const double *q_seed, double q[3][2][2], unsigned char
    status[3][2])
{
    return dhgen_parallel_ik(&robot, T, q_seed, &q[0][0][0], &status[0][0]);
}

int parallel_3rpr_ik_nearest(const double T[16], const double q_seed[3][2], double q[3][2])
{
    return dhgen_parallel_nearest(&robot, T, &q_seed[0][0], &q[0][0]);
}

void parallel_3rpr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_parallel_batch(&robot, n, T, q, status);
}

void parallel_3rpr_take_drives(const double q[3][2], double drives[3])
{
    dhgen_take_drives(&robot, &q[0][0], drives);
}

int parallel_3rpr_fk(const double drives[3], const double T_seed[16], double T[16], double q[3][2])
{
    return dhgen_parallel_fk(&robot, drives, T_seed, T, &q[0][0]);
}

int parallel_3rpr_assemblies(const double drives[3], double T[6][16])
{
    double poses[16 * DHGEN_MOST_ASSEMBLIES];
    const int count = dhgen_assemblies(&robot, DHGEN_THREE_CIRCLES, drives, poses);
    for (int i = 0; i < count * 16; i++)
        T[i / 16][i % 16] = poses[i];
    return count;
}

int parallel_3rpr_velocities(const double T[16], const double q[3][2], double A[9], double B[9])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_platform_rates(&robot, X, &q[0][0], A, B);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}

int parallel_3rpr_singularities(const double T[16], const double q[3][2], double least[2])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_least_values(&robot, X, &q[0][0], least);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}
