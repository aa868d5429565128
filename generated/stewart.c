/* stewart: Stewart platform, six cylinders (6-UPS)
 *
 * Inverse kinematics, generated from robots/stewart.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/stewart.yaml. The formulas and where they come from: stewart.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: c0c1552918eb38b7
 * SPDX-License-Identifier: MIT
 */
#include "stewart.h"

#include "stewart_leg.h"

#include "dhgen/platform.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

static const int stewart_leg_driven[1] = { 2 };
static const int stewart_leg_slides[1] = { 1 };
static const int stewart_leg_counted[3] = { 0, 1, 2 };
static const char *const stewart_leg_names[4] = {
    "back-forward", "back-backward", "front-forward", "front-backward",
};

static int stewart_leg_rows(const double *T, const double *q_seed, double *q, unsigned char *status)
{
    return stewart_leg_ik(T, q_seed, (double (*)[STEWART_LEG_DOF])q, status);
}

static const struct dhgen_leg legs[6] = {
    /* joints, rows, drives; those, whether they slide, types, what the platform moves; from the
     * robot's base; in the platform; functions */
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            1.0, 0.0, 0.0, -0.492403876506104, 0.0, 1.0, 0.0, 0.08682408883346517, 0.0, 0.0, 1.0,
                0.0,
        },
        {
            1.0, 0.0, 0.0, 0.1928362829059618, 0.0, 1.0, 0.0, -0.2298133329356934, 0.0, 0.0, 1.0,
                0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, 0.8660254037844386, 0.0, -0.49240387650610395, -0.8660254037844386, -0.5, 0.0,
            0.08682408883346515, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, -0.8660254037844386, 0.0, 0.10260604299770058, 0.8660254037844386, -0.5, 0.0,
            0.2819077862357725, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, -0.8660254037844386, 0.0, -0.492403876506104, 0.8660254037844386, -0.5, 0.0,
            0.08682408883346512, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, 0.8660254037844386, 0.0, -0.2954423259036624, -0.8660254037844386, -0.5, 0.0,
            -0.05209445330007911, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            1.0, 0.0, 0.0, -0.492403876506104, 0.0, 1.0, 0.0, -0.08682408883346517, 0.0, 0.0, 1.0,
                0.0,
        },
        {
            1.0, 0.0, 0.0, 0.1928362829059618, 0.0, 1.0, 0.0, 0.2298133329356934, 0.0, 0.0, 1.0,
                0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, 0.8660254037844386, 0.0, -0.492403876506104, -0.8660254037844386, -0.5, 0.0,
            -0.08682408883346512, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, -0.8660254037844386, 0.0, -0.2954423259036624, 0.8660254037844386, -0.5, 0.0,
            0.05209445330007911, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, -0.8660254037844386, 0.0, -0.49240387650610395, 0.8660254037844386, -0.5, 0.0,
            -0.08682408883346515, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, 0.8660254037844386, 0.0, 0.10260604299770058, -0.8660254037844386, -0.5, 0.0,
            -0.2819077862357725, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
};
static const int freedoms[6] = { 0, 1, 2, 3, 4, 5 };
static const struct dhgen_parallel robot = {
    6, 3, 4, 6,
    1, /* alike */
    freedoms, 0.75, DHGEN_POSE, 0, /* planar */
    legs
};

const char *const *const stewart_branches[6] = {
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
};

const int stewart_drives[6][2] = { { 0, 2 }, { 1, 2 }, { 2, 2 }, { 3, 2 }, { 4, 2 }, { 5, 2 } };

int stewart_ik(const double T[16], const double *q_seed, double q[6][4][3], unsigned char
    status[6][4])
{
    return dhgen_parallel_ik(&robot, T, q_seed, &q[0][0][0], &status[0][0]);
}

int stewart_ik_nearest(const double T[16], const double q_seed[6][3], double q[6][3])
{
    return dhgen_parallel_nearest(&robot, T, &q_seed[0][0], &q[0][0]);
}

void stewart_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_parallel_batch(&robot, n, T, q, status);
}

void stewart_take_drives(const double q[6][3], double drives[6])
{
    dhgen_take_drives(&robot, &q[0][0], drives);
}

int stewart_fk(const double drives[6], const double T_seed[16], double T[16], double q[6][3])
{
    return dhgen_parallel_fk(&robot, drives, T_seed, T, &q[0][0]);
}

int stewart_velocities(const double T[16], const double q[6][3], double A[36], double B[36])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_platform_rates(&robot, X, &q[0][0], A, B);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}

int stewart_singularities(const double T[16], const double q[6][3], double least[2])
{
    double X[12];
    const int valid = dhgen_read_platform(&robot, T, X);
    dhgen_least_values(&robot, X, &q[0][0], least);
    return valid ? DHGEN_OK : -DHGEN_INVALID_POSE;
}
