/* spherical_wrist_general_arm: Spherical wrist on a general arm
 *
 * Inverse kinematics, generated from robots/spherical_wrist_general_arm.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical_wrist_general_arm.yaml. The formulas and where they come
 * from: spherical_wrist_general_arm.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 795e11103922823a
 * SPDX-License-Identifier: MIT
 */
#include "spherical_wrist_general_arm.h"

#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/circle_roots.h"
#include "dhgen/refine.h"
#include "dhgen/retry.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

enum { OK = DHGEN_OK, NONE = DHGEN_UNREACHABLE, FREE = DHGEN_FREE_JOINT, CLOSE = DHGEN_CLOSE };

static void take(const double from[6], double to[6])
{
    for (int i = 0; i < 6; i++)
        to[i] = from[i];
}

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.6097560975609756, 0.6097560975609756, 0.6097560975609756, 0.6097560975609756,
    0.6097560975609756, 0.6097560975609756,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[6], seed[6]; /* all joint values; the seed in units */
    double e[6], length; /* the miss [arm sizes, rad], and its length */
    double A[6][6]; /* how u moves the tool */
};

/* The rotation vector of an axis times the sine, and the cosine. */
static void turn_vector(const double axis[3], double cosine, double vector[3])
{
    const double sine = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double scale = sine < 1e-09 ? 1.0 : atan2(sine, cosine) / sine;
    const int opposite = sine < 1e-09 && cosine < 0.0; /* any axis will do */
    vector[0] = opposite ? 1.5079644737231006 : scale * axis[0];
    vector[1] = opposite ? 1.8849555921538759 : scale * axis[1];
    vector[2] = opposite ? 2.0106192982974678 : scale * axis[2];
}

/* By how much u misses the pose, and the analytic Jacobian of that. */
static void look(struct descent *d, const double u[6])
{
    double P[16], J[36], square = 0.0;
    for (int j = 0; j < 6; j++)
        d->q[solved[j]] = unit[j] * u[j];
    spherical_wrist_general_arm_fk(d->q, P);
    spherical_wrist_general_arm_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 1.64;
        for (int j = 0; j < 6; j++)
            d->A[i][j] = measure[j] * J[6 * row + solved[j]];
    }
    double R[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[i][j] = d->T[4 * i] * P[4 * j] + d->T[4 * i + 1] * P[4 * j + 1]
                + d->T[4 * i + 2] * P[4 * j + 2];
    const double axis[3] = { 0.5 * (R[2][1] - R[1][2]), 0.5 * (R[0][2] - R[2][0]),
        0.5 * (R[1][0] - R[0][1]) };
    turn_vector(axis, 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0), d->e + 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 6; j++)
            d->A[3 + i][j] = J[6 * (3 + i) + solved[j]];
    for (int i = 0; i < 6; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* What is added from start to start, in parts of the range: a direction that is like no other. */
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};

static void copy(const double from[6], double to[6])
{
    for (int j = 0; j < 6; j++)
        to[j] = from[j];
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[6])
{
    for (int j = 0; j < 6; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

/* Makes a step no longer than it may be. */
static void shorten(double step[6])
{
    double longest = 2.0;
    for (int j = 0; j < 6; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < 6; j++)
        step[j] *= 2.0 / longest;
}

/* The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping. The rows of
 * A, each with its share of the damping's root behind it, are made orthonormal one after another
 * (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994):
 * A A' would lose half of the digits. */
static void damped_step(
    const struct descent *d, const double e[6], double length, double little,
    double step[6])
{
    const double damping = 0.1 * fmin(length * length, 1.0) + little;
    double rows[6][12], y[6], sum[12] = { 0.0 };
    for (int i = 0; i < 6; i++) {
        double square = 0.0;
        for (int j = 0; j < 12; j++)
            rows[i][j] = j < 6 ? d->A[i][j] : j == 6 + i ? sqrt(damping) : 0.0;
        y[i] = e[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < 12; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < 12; j++)
                rows[i][j] -= along * rows[k][j];
            y[i] -= along * y[k];
        }
        for (int j = 0; j < 12; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        y[i] *= inverse;
        for (int j = 0; j < 12; j++)
            rows[i][j] *= inverse;
    }
    for (int i = 6 - 1; i >= 0; i--) {
        double missing = y[i];
        for (int j = 0; j < 12; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < 12; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < 6; j++)
        step[j] = sum[j];
}

/* Takes a row as far as steps help, and tells how long another one would be; returns by how much
 * the row misses the pose then. Beside a singular place a step that is right may be long, and what
 * it leaves, half of its square, far more than was missed. */
static double descended(struct descent *d, int steps, double exact, double q[6], double *ahead)
{
    double u[6], best[6], step[6], least = HUGE_VAL;
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    for (int i = 0; i < 6; i++)
        d->q[i] = q[i];
    for (int j = 0; j < 6; j++)
        best[j] = u[j] = q[solved[j]] / unit[j];
    *ahead = HUGE_VAL;
    for (int k = 0; k <= steps; k++) {
        look(d, u);
        damped_step(d, d->e, d->length, 1e-26, step);
        const int slow = !(d->length <= fmax(0.5 * last, left));
        if (d->length < least) {
            least = d->length;
            *ahead = 0.0;
            copy(u, best);
            for (int j = 0; j < 6; j++)
                *ahead = fmax(*ahead, fabs(step[j]));
        }
        if (slow || (least <= 0.001 * exact && *ahead <= 0.0001))
            break;
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 6; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = 0.5 * way * way;
    }
    wrap_angles(best);
    for (int j = 0; j < 6; j++)
        q[solved[j]] = unit[j] * best[j];
    return least;
}

/* The part of a generic direction that leaves the tool where it is, to first order, one long;
 * returns how long it was. */
static double sideways(const struct descent *d, double along[6])
{
    double moved[6], square = 0.0;
    for (int i = 0; i < 6; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < 6; j++)
            moved[i] += d->A[i][j] * stride[j];
    }
    damped_step(d, moved, 0.0, 1e-13, along);
    for (int j = 0; j < 6; j++) {
        along[j] = stride[j] - along[j];
        square += along[j] * along[j];
    }
    const double length = sqrt(square);
    for (int j = 0; j < 6; j++)
        along[j] /= length;
    return length;
}

/* Takes a row as far as steps help, also from both sides of where they get slow: where many
 * solutions meet, joint values between them are singular. A root of four is missed by the fourth
 * power of the way to it. */
static double escaped(struct descent *d, double exact, double q[6])
{
    double ahead, least = descended(d, 72, exact, q, &ahead);
    for (int k = 0; k < 8 && least > exact; k++) {
        double u[6], along[6], end[2][6], miss[2];
        for (int j = 0; j < 6; j++)
            u[j] = q[solved[j]] / unit[j];
        look(d, u);
        if (sideways(d, along) <= 0.0001)
            break;
        double pace = sqrt(sqrt(least));
        for (int side = 0; side < 2; side++) {
            for (int i = 0; i < 6; i++)
                end[side][i] = q[i];
            for (int j = 0; j < 6; j++)
                end[side][solved[j]] += pace * unit[j] * along[j];
            pace = -pace;
            miss[side] = descended(d, 72, exact, end[side], &ahead);
        }
        const int other = miss[1] < miss[0];
        if (!(miss[other] < 0.9 * least))
            break;
        least = miss[other];
        for (int i = 0; i < 6; i++)
            q[i] = end[other][i];
    }
    return least;
}

/* Takes a row to where damped least squares lead, unless it is exact; returns by how much
 * it misses the pose then, `first` being what it misses before. */
static double tightened(struct descent *d, double exact, double first, double q[6], int *moved)
{
    double end[6];
    if (first <= exact)
        return first;
    for (int i = 0; i < 6; i++)
        end[i] = q[i];
    const double least = escaped(d, exact, end);
    for (int i = 0; i < 6; i++) {
        *moved = *moved || q[i] < end[i] || q[i] > end[i];
        q[i] = end[i];
    }
    return least;
}

/* By how much the joint values of two rows differ at most. */
static double gap_between(const double q[6], const double other[6])
{
    double gap[6], widest = 0.0;
    for (int j = 0; j < 6; j++)
        gap[j] = (q[solved[j]] - other[solved[j]]) / unit[j];
    wrap_angles(gap);
    for (int j = 0; j < 6; j++)
        widest = fmax(widest, fabs(gap[j]));
    return widest;
}

/* Whether a row that was moved came to lie on one that missed by less at first. */
static int repeats(double q[8][6], const double first[8], int row)
{
    for (int k = 0; k < 8; k++)
        if ((first[k] < first[row] || (k < row && first[k] <= first[row])) && !isnan(q[k][0])
                && gap_between(q[k], q[row]) < 1e-06)
            return 1;
    return 0;
}

/* What an exact row may miss: far away rounding is more. */
static double exactness(const double T[16])
{
    double distance = 1.0; /* arm sizes */
    for (int i = 0; i < 3; i++)
        distance = fmax(distance, fabs(T[4 * coordinate[i] + 3]) / 1.64);
    return 1e-12 * distance;
}

/* Tightens the rows; ends those that miss the pose then, and all but one of those that have become
 * the same. */
static void tighten(
    const struct dhgen_arm *arm, const double T[16], double q[8][6], unsigned char status[8])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    int moved[8] = { 0 };
    double first[8], miss[8];
    for (int row = 0; row < 8; row++) {
        first[row] = miss[row] = HUGE_VAL;
        if (status[row] == NONE)
            continue;
        first[row] = dhgen_missed_by(arm, T, q[row]);
        miss[row] = tightened(&d, exact, first[row], q[row], &moved[row]);
    }
    const double enough = 10.0 * exact;
    for (int row = 0; row < 8; row++)
        if (miss[row] > enough)
            q[row][0] = DHGEN_NAN;
    for (int row = 0; row < 8; row++) {
        if (!isnan(q[row][0]) && !(moved[row] && repeats(q, first, row)))
            continue;
        status[row] = NONE;
        for (int i = 0; i < 6; i++)
            q[row][i] = DHGEN_NAN;
    }
}


static const double
    d1 = 0.3, /* joint offset 1 [m] */
    a1 = 0.15, /* link length 1 [m] */
    ca1 = 0.3420201433256688, /* cosine of twist 1 */
    sa1 = 0.9396926207859083, /* sine of twist 1 */
    d2 = 0.12, /* joint offset 2 [m] */
    a2 = 0.42, /* link length 2 [m] */
    ca2 = 0.8191520442889918, /* cosine of twist 2 */
    sa2 = 0.573576436351046, /* sine of twist 2 */
    d3 = 0.08, /* joint offset 3 [m] */
    a3 = 0.11, /* link length 3 [m] */
    ca3 = 0.6427876096865394, /* cosine of twist 3 */
    sa3 = 0.766044443118978, /* sine of twist 3 */
    d4 = 0.37, /* joint offset 4 [m] */
    d6 = 0.09, /* joint offset 6 [m] */
    free_limit6 = 1.9456426971135993e-11, /* a length that fixes no angle [m^6] */
    square_rounding = 1e-15, /* squares are rounded by this */
    free_limit_squared2 = 2.6895999999999994e-24, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 2.6895999999999996e-06,
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit_squared = 1e-06, /* square of a length whose direction is good to few digits */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    k1 = 0.43938504177070503, /* sa3 * sa2 */
    k2 = 0.16257246545516085, /* d4 * sa3 * sa2 [m] */
    k3 = 0.1314173917092386, /* 2 * (d2 * d4 * sa3 * sa2 + a3 * a2) [m^2] */
    k4 = 0.06309340799861507, /* a3 * sa2 [m] */
    k5 = -0.22294419500171073, /* 2 * (d2 * a3 * sa2 - d4 * sa3 * a2) [m^2] */
    k6 = 0.4829582968126144, /* d1 * ca1 + (d2 + ca2 * (d3 + d4 * ca3)) [m] */
    k7 = 0.6, /* 2 * d1 [m] */
    /* d1^2 + (a1^2 - (d2 * (d2 + 2 * ca2 * (d3 + d4 * ca3)) + (a2^2 + (d3 * (d3 + 2 * d4 * ca3) +
     * (a3^2 + d4^2))))) [m^2] */
    k8 = -0.33423756740902244,
    k9 = 0.5, /* 1 / 2 */
    /* (d4 * sa3 * sa2 * 2 * (d2 * a3 * sa2 - d4 * sa3 * a2) - a3 * sa2 * 2 * (d2 * d4 * sa3 * sa2 +
     * a3 * a2))^2 [m^6] */
    k10 = 0.001983469418708643,
    /* 1 / (a3 * sa2 * 2 * (d2 * d4 * sa3 * sa2 + a3 * a2) - d4 * sa3 * sa2 * 2 * (d2 * a3 * sa2 -
     * d4 * sa3 * a2)) [m^-3] */
    k11 = 22.453665346937772,
    k12 = 0.28343644395402184, /* d4 * sa3 [m] */
    k13 = 0.6275068715971331, /* sa3 * ca2 */
    k14 = 0.23217754249093925, /* d4 * sa3 * ca2 [m] */
    k15 = 0.0901067248717891, /* a3 * ca2 [m] */
    k16 = 0.18230061071109027, /* sa2 * (d3 + d4 * ca3) [m] */
    k17 = 0.3686878264946124, /* ca3 * sa2 */
    k18 = 0.5265407845183633, /* ca3 * ca2 */
    f1 = 0.04104241719908026, /* d2 * ca1 [m] */
    f2 = 0.19617469496901113, /* sa2 * ca1 */
    f3 = 0.2801664995932356; /* ca2 * ca1 */

const char *const spherical_wrist_general_arm_branches[8] = {
    "root1-noflip", "root1-flip", "root2-noflip", "root2-flip", "root3-noflip", "root3-flip",
    "root4-noflip", "root4-flip",
};

static const struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

void spherical_wrist_general_arm_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f3 - v5 * sa2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v7 = y2_x * c3 - x2_x * s3,
        v8 = y2_y * c3 - x2_y * s3, v9 = y2_z * c3 - x2_z * s3, y3_x = v7 * ca3 - z2_x * sa3,
        y3_y = v8 * ca3 + v6 * sa3, y3_z = v9 * ca3 - z2_z * sa3, z3_x = v7 * sa3 + z2_x * ca3,
        z3_y = v8 * sa3 - v6 * ca3, z3_z = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, y5_x = y3_x * c4 - x3_x * s4,
        y5_y = y3_y * c4 - x3_y * s4, y5_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z5_x = z3_x * c5 - x4_x * s5,
        z5_y = z3_y * c5 - x4_y * s5, z5_z = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = y5_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = y5_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * a2 - v2 * d2 + x3_y * a3 - v6 * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void spherical_wrist_general_arm_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, v1 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, p2_x = p1_x + x2_x * a2 + z1_x * d2,
        p2_y = p1_y + x2_y * a2 - v2 * d2, p2_z = d1 + x2_z * a2 + f1, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f3 - v5 * sa2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v7 = y2_x * c3 - x2_x * s3,
        v8 = y2_y * c3 - x2_y * s3, v9 = y2_z * c3 - x2_z * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 - v6 * d3, p3_z = p2_z + x3_z * a3 + z2_z * d3,
        y3_x = v7 * ca3 - z2_x * sa3, y3_y = v8 * ca3 + v6 * sa3, y3_z = v9 * ca3 - z2_z * sa3,
        z3_x = v7 * sa3 + z2_x * ca3, z3_y = v8 * sa3 - v6 * ca3, z3_z = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), p4_x = p3_x + z3_x * d4, p4_y = p3_y + z3_y * d4,
        p4_z = p3_z + z3_z * d4, z4_x = x3_x * s4 - y3_x * c4, z4_y = x3_y * s4 - y3_y * c4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_x = z3_x * c5 - (x3_x * c4 + y3_x * s4) * s5,
        z5_y = z3_y * c5 - (x3_y * c4 + y3_y * s4) * s5,
        z5_z = z3_z * c5 - (x3_z * c4 + y3_z * s4) * s5, p6_x = p4_x + z5_x * d6,
        p6_y = p4_y + z5_y * d6, p6_z = p4_z + z5_z * d6, v10 = p6_x - p1_x, v11 = p6_y - p1_y,
        v12 = p6_z - d1, v13 = p6_x - p2_x, v14 = p6_y - p2_y, v15 = p6_z - p2_z, v16 = p6_x - p3_x,
        v17 = p6_y - p3_y, v18 = p6_z - p3_z, v19 = p6_x - p4_x, v20 = p6_y - p4_y,
        v21 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = -(v2 * v12 + ca1 * v11); J[2] = -(v6 * v15 + z2_z * v14);
    J[3] = z3_y * v18 - z3_z * v17; J[4] = z4_y * v21 - z4_z * v20; J[5] = z5_y * v21 - z5_z * v20;
    J[6] = p6_x; J[7] = ca1 * v10 - z1_x * v12; J[8] = z2_z * v13 - z2_x * v15;
    J[9] = z3_z * v16 - z3_x * v18; J[10] = z4_z * v19 - z4_x * v21;
    J[11] = z5_z * v19 - z5_x * v21;
    J[12] = 0.0; J[13] = z1_x * v11 + v2 * v10; J[14] = z2_x * v14 + v6 * v13;
    J[15] = z3_x * v17 - z3_y * v16; J[16] = z4_x * v20 - z4_y * v19;
    J[17] = z5_x * v20 - z5_y * v19;
    J[18] = 0.0; J[19] = z1_x; J[20] = z2_x; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -v2; J[26] = -v6; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = ca1; J[32] = z2_z; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints;
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* theta1, type 9: U1 A6^-1 [3, 4] and the squared length of column 4 of U1 A6^-1 */
    const double wz = T34 - T33 * d6;
    const double v1 = wz * ca1 - k6;
    const double wy = T24 - d6 * T23;
    const double R1c1 = wy * sa1;
    const double wx = T14 - d6 * T13;
    const double v2 = sa1 * wx, v3 = wx * wx + (wy * wy + (wz * (wz - k7) + k8));
    const double R2c1 = 2.0 * (wx * a1);
    const double R2s1 = 2.0 * (wy * a1);
    const double v4 = k4 * v3 + k5 * -v1, v5 = k4 * R2c1 - k5 * R1c1, v6 = k4 * R2s1 + k5 * v2,
        v7 = k3 * -v1 + k2 * v3, v8 = k3 * R1c1 - k2 * R2c1, v9 = k3 * v2 + k2 * R2s1,
        v10 = v5 * v5, v11 = v6 * v6, v12 = 2.0 * v4, v13 = v8 * v8, v14 = v9 * v9, v15 = 2.0 * v7,
        v16 = v4 * v4 + k9 * (v10 + v11) + (v7 * v7 + k9 * (v13 + v14)), v17 = v8 * v15 - v5 * v12,
        v18 = v6 * v12 + v9 * v15, v19 = k9 * (v10 - v11) + k9 * (v13 - v14),
        v20 = v5 * v6 - v8 * v9, v21 = v16 - k10;
    const int free1 = fabs(v21) + fabs(v17) + fabs(v18) + fabs(v19) + fabs(v20) <= free_limit6;
    double x1_roots[4];
    int x1_close[4];
    dhgen_circle_roots(free1 ? 1.0 : v21, free1 ? -1.0 : v17, free1 ? 0.0 : -v18, free1 ? 0.0 : v19,
        free1 ? 0.0 : v20, square_rounding * (v16 + k10), moved, x1_roots, x1_close);

    /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double v22 = ca1 * wy, v23 = ca1 * wx, v24 = sa1 * (wz - d1);

    /* theta4, type 2: U4[3, 3] */
    const double v26 = ca1 * T23, v27 = ca1 * T13, v28 = T33 * sa1, v32 = T23 * sa1,
        v33 = sa1 * T13, v34 = T33 * ca1;

    /* theta6, type 3: U4[3, 2] and U4[3, 1] */
    const double v40 = T32 * sa1, v42 = T32 * ca1, v51 = T31 * sa1, v53 = T31 * ca1;

    /* theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1] */
    const double v62 = T21 * sa1, v63 = sa1 * T11, v65 = T22 * sa1, v66 = sa1 * T12;

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x1 = x1_roots[i1];
        /* theta1 */
        if (!(x1 <= 4.0)) continue; /* out of reach */
        const double q1 = free1 ? seed[0] : x1;
        const double c1 = cos(q1), s1 = sin(q1);

        /* theta3, type 3: U1 A6^-1 [3, 4] and the squared length of column 4 of U1 A6^-1 */
        const double Z1_3 = v1 + (v2 * s1 - R1c1 * c1);
        const double Z2_3 = v3 - (R2c1 * c1 + R2s1 * s1);
        const double s3 = (k3 * Z1_3 - k2 * Z2_3) * k11, c3 = (k4 * Z2_3 - k5 * Z1_3) * k11;
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double X1_2 = a2 + (a3 * c3 - s3 * k12);
        const double Y1_2 = c3 * k14 + s3 * k15 - k16;
        const double Z1_2 = v24 - (s1 * v23 - c1 * v22);
        const double Z2_2 = wx * c1 + wy * s1 - a1;
        const double S2 = X1_2 * Z1_2 - Y1_2 * Z2_2;
        const double C2 = X1_2 * Z2_2 - Z1_2 * -Y1_2;
        const double w2 = sqrt(S2 * S2 + C2 * C2);
        const int free2 = w2 <= free_limit_squared2;
        const int near2 = w2 <= near_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
            s2 = free2 ? sin(seed[1]) : S2 * factor2;
        const double q2 = atan2(s2, c2);

        /* theta4 */
        const double v25 = T13 * c1 + T23 * s1, v29 = s1 * v27 - c1 * v26 - v28, v30 = ca2 * v29,
            v31 = ca2 * v25;
        const double Z1_5 = s1 * v33 - c1 * v32 + v34;
        const double v35 = c2 * (c3 * v25 - s3 * v30) - s2 * (c3 * v29 + s3 * v31) + sa2 * (s3 *
            Z1_5),
            v36 = c2 * (c3 * (ca3 * v30) + s3 * (ca3 * v25) + sa3 * (sa2 * v29)) + s2 * (c3 * (ca3 *
                v31) - s3 * (ca3 * v29) + sa3 * (sa2 * v25)) + (sa3 * (ca2 * Z1_5) - c3 * (ca3 *
                (sa2 * Z1_5))), v37 = v35 * v35 + v36 * v36;
        const double w4 = sqrt(v37);
        const int free4 = w4 <= free_limit;
        const int near4 = v37 <= near_limit_squared;
        const double divisor4 = free4 ? 1.0 : w4;

        /* theta6 */
        const double v38 = T12 * c1 + T22 * s1, v39 = T22 * c1 - T12 * s1, v41 = ca1 * v39 + v40,
            v43 = v42 - sa1 * v39, v44 = c2 * v38 + s2 * v41, v45 = c2 * v41 - s2 * v38,
            v46 = ca2 * v45 + sa2 * v43, v47 = c3 * v44 + s3 * v46,
            v48 = ca3 * (c3 * v46 - s3 * v44) - sa3 * (ca2 * v43 - sa2 * v45),
            v49 = T11 * c1 + T21 * s1, v50 = T21 * c1 - T11 * s1, v52 = ca1 * v50 + v51,
            v54 = v53 - sa1 * v50, v55 = c2 * v49 + s2 * v52, v56 = c2 * v52 - s2 * v49,
            v57 = ca2 * v56 + sa2 * v54, v58 = c3 * v55 + s3 * v57,
            v59 = ca3 * (c3 * v57 - s3 * v55) - sa3 * (ca2 * v54 - sa2 * v56);

        /* theta5 */
        const double v60 = sa2 * s3, v61 = c3 * k17 - k13;
        const double Y1_5 = k1 * c3 + k18;
        const double v64 = v53 + (s1 * v63 - c1 * v62), v67 = v42 + (s1 * v66 - c1 * v65),
            v68 = Z1_5 * Y1_5;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta4 */
            if (e2 < 0.0 && free4) continue; /* both signs give the same */
            const double factor4 = e2 / divisor4;
            const double c4 = free4 ? cos(seed[3]) : v35 * factor4,
                s4 = free4 ? sin(seed[3]) : -(v36 * factor4);
            const double q4 = atan2(s4, c4);

            /* theta6 */
            const double c6 = c4 * v48 - s4 * v47, s6 = c4 * v59 - s4 * v58;
            const double q6 = atan2(s6, c6);

            /* theta5 */
            const double Y2_5 = c4 * v60 + s4 * v61;
            const double Z2_5 = c6 * v64 - s6 * v67;
            const double S5 = Z1_5 * Y2_5 - Y1_5 * Z2_5;
            const double v69 = Y2_5 * Z2_5 + v68;
            const double w5 = sqrt(S5 * S5 + v69 * v69);
            const int free5 = w5 <= free_limit_squared;
            const int near5 = w5 <= near_limit_squared;
            const double v70 = 1.0 / (free5 ? 1.0 : w5);
            const double c5 = free5 ? cos(seed[4]) : v69 * v70,
                s5 = free5 ? sin(seed[4]) : -(S5 * v70);
            const double q5 = atan2(s5, c5);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free1 || free2 || free4 || free5) ? DHGEN_FREE_JOINT : (x1_close[i1] ||
                near2 || near4 || near5) ? DHGEN_CLOSE : DHGEN_OK;
        }
    }
}

/* Whether joint values are a solution. Beside a singular place they may miss the pose by next to
 * nothing and be far from any. */
static int solves(struct descent *d, int steps, double exact, double q[6])
{
    double ahead;
    return descended(d, steps, exact, q, &ahead) <= exact && ahead <= 0.0001;
}

/* Whether a solution is none of those. */
static int is_new(double known[16][6], int count, const double q[6])
{
    for (int k = 0; k < count; k++)
        if (gap_between(known[k], q) < 0.001)
            return 0;
    return 1;
}

/* Puts a solution behind those that are known, unless it is one of them; returns how many there
 * are. */
static int keep(double known[16][6], int count, const double q[6])
{
    if (!is_new(known, count, q))
        return count;
    take(q, known[count]);
    return count + 1;
}

/* Whether the row of a root that is moved leads to a solution, and to which. */
static int leads(
    struct descent *d, const double *free_joints, const double seed[6], double angle, int row,
        double exact,
    double end[6])
{
    double q[8][6];
    unsigned char kind[8];
    for (int k = 0; k < 8; k++)
        kind[k] = NONE;
    solve(d->T, free_joints, seed, angle, &q[0][0], kind);
    if (kind[row] == NONE || kind[row] > CLOSE /* lost */)
        return 0;
    take(q[row], end);
    return solves(d, 72, exact, end);
}

/* How far roots are moved: where steps from a row lead nowhere, and to the other solution, as parts
 * of the way to the one that is known. */
static const double beside[18] = { 3.0517578125e-05, -3.0517578125e-05, 3.814697265625e-06,
    -3.814697265625e-06, 4.76837158203125e-07, -4.76837158203125e-07, 5.960464477539063e-08,
    -5.960464477539063e-08, 7.450580596923828e-09, -7.450580596923828e-09, 9.313225746154785e-10,
    -9.313225746154785e-10, 1.1641532182693481e-10, -1.1641532182693481e-10, 1.4551915228366852e-11,
    -1.4551915228366852e-11, 1.8189894035458565e-12, -1.8189894035458565e-12 };
static const double across[5] = { 0.0, -1.0, -2.0, -0.5, -4.0 };

/* Roots that nearly meet: a row of them may stand between two solutions that differ by anything in
 * a joint that is nearly free. Steps from it lead to one; the root of the other is as far from it
 * on the other side. A row may have taken the seed's value for its root, which is one of the two
 * and hides the middle: the roots' own rows have a seed that is turned away. */
static void both_sides(
const double T[16], const double *free_joints, const double seed[6], double q[8][6],
    unsigned char status[8])
{
    struct descent d = { .T = T };
    double known[16][6], own[8][6], away[6];
    unsigned char kind[8];
    int doubtful[8], any = 0, count = 0;
    const double exact = exactness(T);
    for (int row = 0; row < 8; row++) {
        any |= status[row] == CLOSE;
        kind[row] = NONE;
    }
    if (!any)
        return;
    any = 0;
    take(seed, away);
    away[0] += 2.0;
    solve(T, free_joints, away, 0.0, &own[0][0], kind);
    for (int row = 0; row < 8; row++) {
        const int close = status[row] == CLOSE;
        double here[6];
        if (kind[row] == NONE || kind[row] > CLOSE /* lost */)
            take(q[row], own[row]);
        take(own[row], here);
        doubtful[row] = close && !solves(&d, 0, exact, here);
        if (close)
            status[row] = OK;
        any += doubtful[row];
        if (status[row] == NONE || doubtful[row])
            continue;
        take(q[row], known[count]);
        count++;
    }
    if (!any)
        return;
    const int others = count;
    int next = count;
    for (int row = 0; row < 8; row++) {
        if (!doubtful[row])
            continue;
        double end[6], other[6], off = 0.0;
        take(q[row], end);
        /* long steps may lead to solutions of other roots, which are known */
        int found = solves(&d, 72, exact, end) && is_new(known, others, end);
        for (int k = 0; k < 18 && !found; k++)
            found = leads(&d, free_joints, away, beside[k], row, exact, end)
                && is_new(known, others, end);
        if (!found)
            continue;
        status[row] = NONE;
        count = keep(known, count, end);
        off += end[0] - own[row][0];
        off -= 6.283185307179586 * ceil(off / 6.283185307179586 - 0.5);
        for (int k = 0; k < 5; k++) {
            if (!leads(&d, free_joints, away, across[k] * off, row, exact, other)
                    || !is_new(known, others, other) || gap_between(end, other) < 0.001)
                continue;
            count = keep(known, count, other);
            break;
        }
    }
    for (; next < count; next++) { /* whichever roots rounding told apart: the row that was nearest
        */
        int place = -1;
        double least = HUGE_VAL;
        for (int row = 8 - 1; row >= 0; row--) {
            const double gap = isnan(q[row][0]) ? HUGE_VAL : gap_between(q[row], known[next]);
            if (status[row] == NONE && gap <= least) {
                least = gap;
                place = row;
            }
        }
        if (place < 0)
            break;
        take(known[next], q[place]);
        status[place] = OK;
    }
    for (int row = 0; row < 8; row++)
        for (int i = 0; i < 6 && status[row] == NONE; i++)
            q[row][i] = DHGEN_NAN;
}


/* Between which values starts lie. */
static const double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[6])
{
    for (int j = 0; j < 6; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}

/* Takes u to where damped least squares lead; returns by how much that misses the pose. Near to it
 * less damping than usual leads further, where joints hardly move the tool: there a step that is
 * right may be long, and what it leaves, half of its square, far more than was missed. */
static double descend(struct descent *d, double u[6])
{
    double least = HUGE_VAL, little = 1e-13, best[6], step[6];
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    copy(u, best); /* compilers don't know that some miss is finite */
    for (int k = 0; k <= 40; k++) {
        look(d, u);
        const int slow = d->length >= fmax(0.5 * last, left);
        const int stalled = slow && least <= (little < 1e-13 ? 1e-10 : 1e-12);
        if (slow && least <= 1e-06)
            little = 1e-26;
        if (d->length < least) {
            least = d->length;
            copy(u, best);
        }
        if (stalled)
            break;
        damped_step(d, d->e, d->length, little, step);
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 6; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = little < 1e-13 ? 0.5 * way * way : 0.0;
    }
    copy(best, u);
    return least;
}

/* A pose was left without a row after a joint had been chosen: several joints may be free, and few
 * of their values serve. Steps from the seed and from evenly spread starts lead to some that do.
 * What is wrong with values: 1 is that they are beyond limits, 2 that they are not exact, 4 that
 * there are none. */
static void seek(
const double T[16], const double *free_joints, const double seed[6], int begun, double q[8][6],
    unsigned char status[8])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    double found[6] = { 0.0 };
    (void)free_joints;
    int before = 4, chosen = -1;
    for (int row = 8 - 1; row >= 0; row--) {
        int fault = 0, is_open = status[row] == FREE;
        if (status[row] == NONE)
            continue;
        before = fault < before ? fault : before;
        chosen = is_open ? row : chosen;
    }
    if (before == 0 || (before < 4 && chosen < 0))
        return;
    int least = before;
    take(seed, d.q);
    for (int j = 0; j < 6; j++)
        d.seed[j] = seed[solved[j]] / unit[j];
    for (int k = 0; k < 12 && least; k++) {
        double u[6], end[6];
        start_of(&d, k, u);
        if (descend(&d, u) > 0.01)
            continue;
        take(d.q, end);
        for (int j = 0; j < 6; j++)
            end[solved[j]] = unit[j] * u[j];
        const double miss = escaped(&d, exact, end);
        if (miss > 10.0 * exact)
            continue;
        const int fault = 2 * (miss > exact);
        if (fault >= least)
            continue;
        least = fault;
        take(end, found);
    }
    if (least == before)
        return;
    for (int row = 0; row < 8; row++) {
        status[row] = row == begun ? FREE : NONE;
        for (int i = 0; i < 6; i++)
            q[row][i] = row == begun ? found[i] : DHGEN_NAN;
    }
}


/* What follows where roots nearly meet, and where rows miss the pose. */
static void complete(
    const struct dhgen_arm *arm, const double *T, const double *free_joints, const double *seed,
    int begun, double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    both_sides(T, free_joints, seed, q, status);
    tighten(arm, T, q, status);
    if (begun >= 0)
        seek(T, free_joints, seed, begun, q, status);
}

static const int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
static const int choosable[4] = { 4, 3, 1, 0 };
static const struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.6098, 0.6098, 0.6098, 1.0, 1.0, 1.0 }, 0.6097560975609756, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 4, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* winds */
    1, /* follows seed */
    spherical_wrist_general_arm_fk, spherical_wrist_general_arm_jacobian, solve, complete, NULL,
};

int spherical_wrist_general_arm_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    return dhgen_careful_ik(&arm, T, NULL, q_seed, &q[0][0], status);
}

int spherical_wrist_general_arm_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    return dhgen_ik_nearest(&arm, T, NULL, q_seed, q);
}

void spherical_wrist_general_arm_ik_batch(
    size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, NULL, q, status);
}
