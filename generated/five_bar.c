/* five_bar: Planar five-bar linkage (RR legs)
 *
 * Inverse kinematics, generated from robots/five_bar.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/five_bar.yaml. The formulas and where they come from: five_bar.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 40b6e59fdafffcd2
 * SPDX-License-Identifier: MIT
 */
#include "five_bar.h"

#include "five_bar_leg.h"

#include "dhgen/assemblies.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

static const int five_bar_leg_driven[1] = { 0 };
static const int five_bar_leg_slides[1] = { 0 };
static const int five_bar_leg_counted[2] = { 0, 1 };
static const char *const five_bar_leg_names[2] = { "right", "left" };

static int five_bar_leg_rows(const double *T, const double *q_seed, double *q, unsigned char
    *status)
{
    return five_bar_leg_ik(T, q_seed, (double (*)[FIVE_BAR_LEG_DOF])q, status);
}

static const struct dhgen_leg legs[2] = {
    /* joints, rows, drives; those, whether they slide, types, what the platform moves; from the
     * robot's base; in the platform; functions */
    {
        2, 2, 1, five_bar_leg_driven, five_bar_leg_slides, "RR", five_bar_leg_counted,
        {
            1.0, 0.0, 0.0, 0.1, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        five_bar_leg_rows, five_bar_leg_ik_nearest, five_bar_leg_ik_batch, five_bar_leg_fk,
            five_bar_leg_jacobian
    },
    {
        2, 2, 1, five_bar_leg_driven, five_bar_leg_slides, "RR", five_bar_leg_counted,
        {
            1.0, 0.0, 0.0, -0.1, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        five_bar_leg_rows, five_bar_leg_ik_nearest, five_bar_leg_ik_batch, five_bar_leg_fk,
            five_bar_leg_jacobian
    },
};
static const int freedoms[2] = { 0, 1 };
static const struct dhgen_parallel robot = {
    2, 2, 2, 2,
    1, /* alike */
    freedoms, 0.5, DHGEN_COORDINATES, 1, /* planar */
    legs
};

const char *const *const five_bar_branches[2] = {
    five_bar_leg_names,
    five_bar_leg_names,
};

const int five_bar_drives[2][2] = { { 0, 0 }, { 1, 0 } };

int five_bar_ik(const double T[16], const double *q_seed, double q[2][2][2], unsigned char
    status[2][2])
{
    return dhgen_parallel_ik(&robot, T, q_seed, &q[0][0][0], &status[0][0]);
}

int five_bar_ik_nearest(const double T[16], const double q_seed[2][2], double q[2][2])
{
    return dhgen_parallel_nearest(&robot, T, &q_seed[0][0], &q[0][0]);
}

void five_bar_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_parallel_batch(&robot, n, T, q, status);
}

void five_bar_take_drives(const double q[2][2], double drives[2])
{
    dhgen_take_drives(&robot, &q[0][0], drives);
}

int five_bar_fk(const double drives[2], const double T_seed[16], double T[16], double q[2][2])
{
    return dhgen_parallel_fk(&robot, drives, T_seed, T, &q[0][0]);
}

int five_bar_assemblies(const double drives[2], double T[2][16])
{
    double poses[16 * DHGEN_MOST_ASSEMBLIES];
    const int count = dhgen_assemblies(&robot, DHGEN_TWO_CIRCLES, drives, poses);
    for (int i = 0; i < count * 16; i++)
        T[i / 16][i % 16] = poses[i];
    return count;
}

int five_bar_velocities(const double T[16], const double q[2][2], double A[4], double B[4])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_platform_rates(&robot, X, &q[0][0], A, B);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}

int five_bar_singularities(const double T[16], const double q[2][2], double least[2])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_least_values(&robot, X, &q[0][0], least);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}
