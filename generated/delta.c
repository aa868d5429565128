/* delta: Delta, three cranks with parallelograms
 *
 * Inverse kinematics, generated from robots/delta.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/delta.yaml. The formulas and where they come from: delta.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 5c7395f6581d009b
 * SPDX-License-Identifier: MIT
 */
#include "delta.h"

#include "delta_leg.h"

#include "dhgen/assemblies.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

static const int delta_leg_driven[1] = { 0 };
static const int delta_leg_slides[1] = { 0 };
static const int delta_leg_counted[3] = { 0, 1, 2 };
static const char *const delta_leg_names[4] = {
    "shoulder+-elbow+", "shoulder+-elbow-", "shoulder--elbow+", "shoulder--elbow-",
};

static int delta_leg_rows(const double *T, const double *q_seed, double *q, unsigned char *status)
{
    return delta_leg_ik(T, q_seed, (double (*)[DELTA_LEG_DOF])q, status);
}

static const struct dhgen_leg legs[3] = {
    /* joints, rows, drives; those, whether they slide, types, what the platform moves; from the
     * robot's base; in the platform; functions */
    {
        3, 4, 1, delta_leg_driven, delta_leg_slides, "RRR", delta_leg_counted,
        {
            1.0, 0.0, 0.0, -0.164, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.044, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        delta_leg_rows, delta_leg_ik_nearest, delta_leg_ik_batch, delta_leg_fk, delta_leg_jacobian
    },
    {
        3, 4, 1, delta_leg_driven, delta_leg_slides, "RRR", delta_leg_counted,
        {
            -0.5, 0.8660254037844386, 0.0, -0.16399999999999998, 0.0, 0.0, -1.0, 0.0,
                -0.8660254037844386,
            -0.5, 0.0, 0.0,
        },
        {
            -0.5, -0.8660254037844386, 0.0, -0.022, 0.8660254037844386, -0.5, 0.0,
                0.038105117766515297,
            0.0, 0.0, 1.0, 0.0,
        },
        delta_leg_rows, delta_leg_ik_nearest, delta_leg_ik_batch, delta_leg_fk, delta_leg_jacobian
    },
    {
        3, 4, 1, delta_leg_driven, delta_leg_slides, "RRR", delta_leg_counted,
        {
            -0.5, -0.8660254037844386, 0.0, -0.16399999999999998, 0.0, 0.0, -1.0, 0.0,
                0.8660254037844386,
            -0.5, 0.0, 0.0,
        },
        {
            -0.5, 0.8660254037844386, 0.0, -0.022, -0.8660254037844386, -0.5, 0.0,
                -0.038105117766515297,
            0.0, 0.0, 1.0, 0.0,
        },
        delta_leg_rows, delta_leg_ik_nearest, delta_leg_ik_batch, delta_leg_fk, delta_leg_jacobian
    },
};
static const int freedoms[3] = { 0, 1, 2 };
static const struct dhgen_parallel robot = {
    3, 3, 4, 3,
    1, /* alike */
    freedoms, 1.768, DHGEN_COORDINATES, 0, /* planar */
    legs
};

const char *const *const delta_branches[3] = {
    delta_leg_names,
    delta_leg_names,
    delta_leg_names,
};

const int delta_drives[3][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 } };

int delta_ik(const double T[16], const double *q_seed, double q[3][4][3], unsigned char
    status[3][4])
{
    return dhgen_parallel_ik(&robot, T, q_seed, &q[0][0][0], &status[0][0]);
}

int delta_ik_nearest(const double T[16], const double q_seed[3][3], double q[3][3])
{
    return dhgen_parallel_nearest(&robot, T, &q_seed[0][0], &q[0][0]);
}

void delta_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_parallel_batch(&robot, n, T, q, status);
}

void delta_take_drives(const double q[3][3], double drives[3])
{
    dhgen_take_drives(&robot, &q[0][0], drives);
}

int delta_fk(const double drives[3], const double T_seed[16], double T[16], double q[3][3])
{
    return dhgen_parallel_fk(&robot, drives, T_seed, T, &q[0][0]);
}

int delta_assemblies(const double drives[3], double T[2][16])
{
    double poses[16 * DHGEN_MOST_ASSEMBLIES];
    const int count = dhgen_assemblies(&robot, DHGEN_THREE_SPHERES, drives, poses);
    for (int i = 0; i < count * 16; i++)
        T[i / 16][i % 16] = poses[i];
    return count;
}

int delta_velocities(const double T[16], const double q[3][3], double A[9], double B[9])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_platform_rates(&robot, X, &q[0][0], A, B);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}

int delta_singularities(const double T[16], const double q[3][3], double least[2])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_least_values(&robot, X, &q[0][0], least);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}
