/* SPDX-License-Identifier: MIT
 *
 * Descents: damped least squares from joint values to a pose. */
#ifndef DHGEN_NUMERICAL_DESCENT_H
#define DHGEN_NUMERICAL_DESCENT_H

#include "../least_squares.h"
#include "../tolerances.h"
#include "arm.h"

/* Below this sine the rotation vector of an axis is taken as the axis times the sine. */
#define DHGEN_SMALL_SINE 1e-09
/* Half a turn about an axis that is like no other [rad]: where every axis does. */
#define DHGEN_ANY_TURN_X 1.5079644737231006
#define DHGEN_ANY_TURN_Y 1.8849555921538759
#define DHGEN_ANY_TURN_Z 2.0106192982974678
/* Damping over the square of the miss (the Gauss-Newton step itself near a solution), and what is
 * always added, so that a singular arm has a step: below the square of what counts as singular. */
#define DHGEN_DESCENT_DAMPING 0.1
#define DHGEN_DAMPING_FLOOR 1e-13
/* Where steps get slow at a miss below this [arm sizes, rad] only DHGEN_FINE is added: more keeps
 * them from going on where joints hardly move the tool. Beside singular places the last digits
 * count. */
#define DHGEN_SLOW_MISS 1e-06
/* The longest step of a joint [rad, arm sizes]. */
#define DHGEN_LONGEST_STEP 2.0
/* Steps from a start; 7 to 16 are usual. */
#define DHGEN_DESCENT_STEPS 40
/* A row that was refined misses its pose by no more [arm sizes, rad]. */
#define DHGEN_SOLUTION 1e-10
/* What is left of a generic direction when all that moves the tool is taken away: above this the
 * arm is singular. */
#define DHGEN_SINGULAR_LENGTH 0.0001
/* Solutions closer than this are one [rad, arm sizes]. */
#define DHGEN_SAME_UNITS 1e-06

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct dhgen_descent {
    const struct dhgen_numerical_arm *arm;
    const double *T, *free_joints;
    double q[DHGEN_JOINTS], seed[DHGEN_JOINTS];   /* all joints; the seed in units */
    double e[DHGEN_MOST_EQUATIONS], length;       /* the miss [arm sizes, rad], and its length */
    double A[DHGEN_MOST_EQUATIONS][DHGEN_JOINTS]; /* how u moves the tool */
};

/* A descent towards T, at the joint values that the caller gives, near to a seed. */
DHGEN_FN void dhgen_begin_descent(const struct dhgen_numerical_arm *arm, const double *T,
    const double *free_joints, const double *seed, struct dhgen_descent *d)
{
    d->arm = arm;
    d->T = T;
    d->free_joints = free_joints;
    for (int i = 0; i < dhgen_dof(arm); i++)
        d->q[i] = 0.0;
    for (int i = 0; i < arm->given_joints; i++)
        d->q[arm->given[i]] = free_joints[i];
    for (int j = 0; j < arm->solved; j++)
        d->seed[j] = seed[arm->joint[j]] / arm->unit[j];
}

/* Copies the joints that are solved for. */
DHGEN_FN void dhgen_copy_units(
    const struct dhgen_numerical_arm *arm, const double *from, double *to)
{
    for (int j = 0; j < arm->solved; j++)
        to[j] = from[j];
}

/* Makes a step no longer than it may be. */
DHGEN_FN void dhgen_shorten(const struct dhgen_numerical_arm *arm, double *step)
{
    double longest = DHGEN_LONGEST_STEP;
    for (int j = 0; j < arm->solved; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < arm->solved; j++)
        step[j] *= DHGEN_LONGEST_STEP / longest;
}

/* The rotation vector of an axis times the sine, and the cosine. */
DHGEN_FN void dhgen_rotation_vector(const double axis[3], double cosine, double vector[3])
{
    const double sine = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double scale = sine < DHGEN_SMALL_SINE ? 1.0 : atan2(sine, cosine) / sine;
    const int opposite = sine < DHGEN_SMALL_SINE && cosine < 0.0; /* any axis will do */
    vector[0] = opposite ? DHGEN_ANY_TURN_X : scale * axis[0];
    vector[1] = opposite ? DHGEN_ANY_TURN_Y : scale * axis[1];
    vector[2] = opposite ? DHGEN_ANY_TURN_Z : scale * axis[2];
}

/* The rows of a miss that are the whole rotation; P is the tool's pose, J the Jacobian. */
DHGEN_FN void dhgen_rotation_rows(struct dhgen_descent *d, const double *P, const double *J)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    const int first = arm->coordinates, dof = dhgen_dof(arm);
    double R[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[i][j] = d->T[4 * i] * P[4 * j] + d->T[4 * i + 1] * P[4 * j + 1]
                + d->T[4 * i + 2] * P[4 * j + 2];
    const double axis[3] = { 0.5 * (R[2][1] - R[1][2]), 0.5 * (R[0][2] - R[2][0]),
        0.5 * (R[1][0] - R[0][1]) };
    dhgen_rotation_vector(axis, 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0), d->e + first);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < arm->solved; j++)
            d->A[first + i][j] = arm->unit[j] * J[dof * (3 + i) + arm->joint[j]];
}

/* The rows of a miss that are the tool's z axis: turning about it changes nothing. */
DHGEN_FN void dhgen_axis_rows(struct dhgen_descent *d, const double *P, const double *J)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    const int first = arm->coordinates, dof = dhgen_dof(arm);
    const double z[3] = { P[2], P[6], P[10] }, w[3] = { d->T[2], d->T[6], d->T[10] };
    const double axis[3] = { z[1] * w[2] - z[2] * w[1], z[2] * w[0] - z[0] * w[2],
        z[0] * w[1] - z[1] * w[0] };
    dhgen_rotation_vector(axis, z[0] * w[0] + z[1] * w[1] + z[2] * w[2], d->e + first);
    for (int j = 0; j < arm->solved; j++) {
        const double *const spin = J + 3 * dof + arm->joint[j];
        const double along = z[0] * spin[0] + z[1] * spin[dof] + z[2] * spin[2 * dof];
        for (int i = 0; i < 3; i++)
            d->A[first + i][j] = arm->unit[j] * (spin[dof * i] - along * z[i]);
    }
}

/* The rows of a miss that are yaw, pitch, or the turn about level axes that is missed of both roll
 * and pitch. The tool's x axis is level where yaw is asked for; a pose without one misses none. */
DHGEN_FN void dhgen_angle_rows(struct dhgen_descent *d, const double *P, const double *J)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    const double *const T = d->T;
    double *const e = d->e + arm->coordinates;
    if (arm->directions == DHGEN_YAW)
        e[0] = atan2(P[0] * T[4] - P[4] * T[0], P[0] * T[0] + P[4] * T[4]);
    else if (arm->directions == DHGEN_PITCH)
        e[0] = T[8] - P[8];
    else {
        const double axis[3] = { T[8] * P[4] + T[9] * P[5] + T[10] * P[6],
            -T[8] * P[0] - T[9] * P[1] - T[10] * P[2], 0.0 };
        double turn[3];
        dhgen_rotation_vector(axis, T[8] * P[8] + T[9] * P[9] + T[10] * P[10], turn);
        e[0] = turn[0];
        e[1] = turn[1];
    }
    for (int j = 0; j < arm->solved; j++) {
        const int dof = dhgen_dof(arm), first = arm->coordinates;
        const double *const spin = J + 3 * dof + arm->joint[j];
        if (arm->directions == DHGEN_YAW)
            d->A[first][j] = arm->unit[j] * spin[2 * dof];
        else if (arm->directions == DHGEN_PITCH)
            d->A[first][j] = arm->unit[j] * (spin[0] * P[4] - spin[dof] * P[0]);
        else {
            d->A[first][j] = arm->unit[j] * spin[0];
            d->A[first + 1][j] = arm->unit[j] * spin[dof];
        }
    }
}

/* By how much u misses the pose, and the analytic Jacobian of that, into the descent. */
DHGEN_FN void dhgen_measure_miss(struct dhgen_descent *d, const double *u)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double P[16], J[6 * DHGEN_JOINTS], square = 0.0;
    for (int j = 0; j < arm->solved; j++)
        d->q[arm->joint[j]] = arm->unit[j] * u[j];
    DHGEN_MOTION_OF_DESCENTS(arm, d->q, P, J);
    for (int i = 0; i < arm->coordinates; i++) {
        const int row = arm->coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / arm->size;
        for (int j = 0; j < arm->solved; j++)
            d->A[i][j] = arm->measure[j] * J[dhgen_dof(arm) * row + arm->joint[j]];
    }
    if (arm->directions == DHGEN_ROTATION)
        dhgen_rotation_rows(d, P, J);
    else if (arm->directions == DHGEN_POINTING)
        dhgen_axis_rows(d, P, J);
    else if (arm->directions != DHGEN_COORDINATES)
        dhgen_angle_rows(d, P, J);
    if (arm->arm_angle) {
        const int last = arm->equations - 1;
        double off[4];
        arm->arm_angle_miss(d->T, d->free_joints, d->q, off);
        d->e[last] = off[0];
        for (int j = 0; j < arm->solved; j++)
            d->A[last][j] = j < 3 ? arm->unit[j] * off[1 + j] : 0.0;
    }
    for (int i = 0; i < arm->equations; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* The damped least-squares step for the miss e, with a least damping. */
DHGEN_FN void dhgen_damped_step(const struct dhgen_descent *d, const double *e, double length,
    double least_damping, double *step)
{
    const double damping = DHGEN_DESCENT_DAMPING * fmin(length * length, 1.0) + least_damping;
    dhgen_least_squares(
        d->arm->equations, d->arm->solved, &d->A[0][0], DHGEN_JOINTS, damping, e, step);
}

/* Makes a step, no longer than it may be. Returns what its curvature leaves, half of its square. */
DHGEN_FN double dhgen_make_step(const struct dhgen_numerical_arm *arm, double *step, double *u)
{
    double way = 0.0;
    dhgen_shorten(arm, step);
    for (int j = 0; j < arm->solved; j++) {
        u[j] += step[j];
        way += fabs(step[j]);
    }
    return 0.5 * way * way;
}

/* Refines u by damped least squares; returns by how much it misses the pose then. Near to the pose
 * less damping than usual gains more, where joints hardly move the tool: there a step that is right
 * may be long, and what it leaves, half of its square, far more than was missed. */
DHGEN_FN double dhgen_descend(struct dhgen_descent *d, double *u)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double best[DHGEN_JOINTS], step[DHGEN_JOINTS];
    double least = HUGE_VAL, least_damping = DHGEN_DAMPING_FLOOR;
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    dhgen_copy_units(arm, u, best);     /* compilers can't infer that some miss is finite */
    for (int k = 0; k <= DHGEN_DESCENT_STEPS; k++) {
        dhgen_measure_miss(d, u);
        const int slow = d->length >= fmax(0.5 * last, left);
        const double enough = least_damping < DHGEN_DAMPING_FLOOR ? DHGEN_SOLUTION : DHGEN_EXACT;
        const int stalled = slow && least <= enough;
        if (slow && least <= DHGEN_SLOW_MISS)
            least_damping = DHGEN_FINE;
        if (d->length < least) {
            least = d->length;
            dhgen_copy_units(arm, u, best);
        }
        if (stalled)
            break;
        dhgen_damped_step(d, d->e, d->length, least_damping, step);
        const double curved = dhgen_make_step(arm, step, u);
        last = d->length;
        left = least_damping < DHGEN_DAMPING_FLOOR ? curved : 0.0;
    }
    dhgen_copy_units(arm, best, u);
    return least;
}

/* Start number k; number 0 is the seed. */
DHGEN_FN void dhgen_start(const struct dhgen_descent *d, int k, double *u)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    for (int j = 0; j < arm->solved; j++)
        u[j] = k == 0 ? d->seed[j]
                      : arm->span_low[j] + arm->span_width[j] * fmod(0.5 + k * arm->stride[j], 1.0);
}

/* Leaves of a direction the part that leaves the tool where it is, to first order, one long;
 * returns how long it was. */
DHGEN_FN double dhgen_keep_null_part(const struct dhgen_descent *d, double *along)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double moved[DHGEN_MOST_EQUATIONS], rest[DHGEN_JOINTS], square = 0.0;
    for (int i = 0; i < arm->equations; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < arm->solved; j++)
            moved[i] += d->A[i][j] * along[j];
    }
    dhgen_damped_step(d, moved, 0.0, DHGEN_DAMPING_FLOOR, rest);
    for (int j = 0; j < arm->solved; j++) {
        along[j] -= rest[j];
        square += along[j] * along[j];
    }
    const double length = sqrt(square);
    for (int j = 0; j < arm->solved; j++)
        along[j] /= length;
    return length;
}

/* The null part of a generic direction, as a unit vector; returns the length of that part. */
DHGEN_FN double dhgen_null_direction(const struct dhgen_descent *d, double *along)
{
    dhgen_copy_units(d->arm, d->arm->stride, along);
    return dhgen_keep_null_part(d, along);
}

#endif
