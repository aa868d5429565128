/* SPDX-License-Identifier: MIT
 *
 * Joint velocities of a twist: exact where the arm is regular, damped near singular poses. */
#ifndef DHGEN_VELOCITIES_H
#define DHGEN_VELOCITIES_H

#include "arm.h"

/* The joint velocities of a twist of the tool at joint values q, by least squares. */
DHGEN_API void dhgen_joint_velocities(
    const struct dhgen_arm *arm, const double *q, const double *twist, double *velocities);

#ifndef DHGEN_SHARED

#include "refine.h"

/* Damping begins at this singular value of the task's Jacobian, lengths in arm sizes: joints move
 * at most a hundred times as fast as the tool. */
#define DHGEN_DAMPED_BELOW 0.01
/* Through all pairs of rows; six to eight do. */
#define DHGEN_SWEEPS 20
/* Rows are orthogonal if their cosine is not above the second, which is rounding of sums of
 * products, or their product not above the first, which is rounding of zero. */
#define DHGEN_NOTHING 1e-30
#ifndef DHGEN_SINGLE_PRECISION
#define DHGEN_ORTHOGONAL 4e-15
#else
#define DHGEN_ORTHOGONAL 2e-6
#endif

/* Turns two rows until their first `dof` entries are orthogonal. Returns whether it has to. */
DHGEN_FN int dhgen_turn_rows(int dof, double *x, double *y)
{
    double a = 0.0, b = 0.0, c = 0.0;
    for (int j = 0; j < dof; j++) {
        a += x[j] * x[j];
        b += y[j] * y[j];
        c += x[j] * y[j];
    }
    if (!(fabs(c) > fmax(DHGEN_ORTHOGONAL * sqrt(a * b), DHGEN_NOTHING)))
        return 0;
    const double ratio = 0.5 * (b - a) / c;
    const double tangent = copysign(1.0, ratio) / (fabs(ratio) + sqrt(1.0 + ratio * ratio));
    const double cosine = 1.0 / sqrt(1.0 + tangent * tangent), sine = cosine * tangent;
    for (int j = 0; j <= dof; j++) {
        const double before = x[j];
        x[j] = cosine * before - sine * y[j];
        y[j] = sine * before + cosine * y[j];
    }
    return 1;
}

/* Turns pairs of six rows until all are orthogonal in their first `dof` entries, by one-sided
 * Jacobi rotations (M. R. Hestenes, 1958): their lengths are then the singular values. The entry
 * behind those is turned along. */
DHGEN_FN void dhgen_make_orthogonal(int dof, double *rows)
{
    int turned = 1;
    for (int sweep = 0; sweep < DHGEN_SWEEPS && turned; sweep++) {
        turned = 0;
        for (int i = 0; i < 5; i++)
            for (int k = i + 1; k < 6; k++)
                turned |= dhgen_turn_rows(dof, rows + (dof + 1) * i, rows + (dof + 1) * k);
    }
}

DHGEN_API void dhgen_joint_velocities(
    const struct dhgen_arm *arm, const double *q, const double *twist, double *velocities)
{
    const int dof = dhgen_dof(arm), width = dof + 1;
    double J[6 * DHGEN_JOINTS], rows[6 * (DHGEN_JOINTS + 1)];
    DHGEN_RATES(arm, q, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < dof; j++)
            rows[width * i + j] = J[dof * i + j] / sqrt(arm->joints[j].weight);
        rows[width * i + dof] = twist[i];
    }
    dhgen_count_what_counts(arm, q, width, rows);
    for (int k = 0; k < 6 * width; k++)
        rows[k] *= arm->miss_weights[k / width];
    dhgen_make_orthogonal(dof, rows);
    for (int j = 0; j < dof; j++)
        velocities[j] = 0.0;
    for (int i = 0; i < 6; i++) {
        const double *const row = rows + width * i;
        double square = 0.0;
        for (int j = 0; j < dof; j++)
            square += row[j] * row[j];
        const double share = row[dof] / fmax(square, DHGEN_DAMPED_BELOW * DHGEN_DAMPED_BELOW);
        for (int j = 0; j < dof; j++)
            velocities[j] += share * row[j] / sqrt(arm->joints[j].weight);
    }
}

#endif

#endif
