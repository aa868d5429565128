/* welding_5r: Welding arm with five joints, its torch tilted aside
 *
 * Inverse kinematics, generated from robots/welding_5r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/welding_5r.yaml. The formulas and where they come from:
 * welding_5r.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: dff39f8558c8a949
 * SPDX-License-Identifier: MIT
 */
#include "welding_5r.h"

#define DHGEN_DOF 5
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/circle_roots.h"
#include "dhgen/refine.h"
#include "dhgen/retry.h"

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

enum { OK = DHGEN_OK, NONE = DHGEN_UNREACHABLE, FREE = DHGEN_FREE_JOINT, CLOSE = DHGEN_CLOSE };

static void take(const double from[5], double to[5])
{
    for (int i = 0; i < 5; i++)
        to[i] = from[i];
}

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[5] = { 0, 1, 2, 3, 4 };
static const int turning[5] = { 1, 1, 1, 1, 1 };
static const double unit[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[5] = { 0.625, 0.625, 0.625, 0.625, 0.625 };
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[5], seed[5]; /* all joint values; the seed in units */
    double e[6], length; /* the miss [arm sizes, rad], and its length */
    double A[6][5]; /* how u moves the tool */
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
static void look(struct descent *d, const double u[5])
{
    double P[16], J[30], square = 0.0;
    for (int j = 0; j < 5; j++)
        d->q[solved[j]] = unit[j] * u[j];
    welding_5r_fk(d->q, P);
    welding_5r_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 1.6;
        for (int j = 0; j < 5; j++)
            d->A[i][j] = measure[j] * J[5 * row + solved[j]];
    }
    const double z[3] = { P[2], P[6], P[10] }, w[3] = { d->T[2], d->T[6], d->T[10] };
    const double axis[3] = { z[1] * w[2] - z[2] * w[1], z[2] * w[0] - z[0] * w[2],
        z[0] * w[1] - z[1] * w[0] };
    turn_vector(axis, z[0] * w[0] + z[1] * w[1] + z[2] * w[2], d->e + 3);
    for (int j = 0; j < 5; j++) {
        const double *spin = J + 15 + solved[j]; /* turning about z changes nothing */
        const double along = z[0] * spin[0] + z[1] * spin[5] + z[2] * spin[10];
        for (int i = 0; i < 3; i++)
            d->A[3 + i][j] = spin[5 * i] - along * z[i];
    }
    for (int i = 0; i < 6; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* What is added from start to start, in parts of the range: a direction that is like no other. */
static const double stride[5] = {
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
};

static void copy(const double from[5], double to[5])
{
    for (int j = 0; j < 5; j++)
        to[j] = from[j];
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[5])
{
    for (int j = 0; j < 5; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

/* Makes a step no longer than it may be. */
static void shorten(double step[5])
{
    double longest = 2.0;
    for (int j = 0; j < 5; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < 5; j++)
        step[j] *= 2.0 / longest;
}

/* The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping. The rows of
 * A, each with its share of the damping's root behind it, are made orthonormal one after another
 * (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994):
 * A A' would lose half of the digits. */
static void damped_step(
    const struct descent *d, const double e[6], double length, double little,
    double step[5])
{
    const double damping = 0.1 * fmin(length * length, 1.0) + little;
    double rows[6][11], y[6], sum[11] = { 0.0 };
    for (int i = 0; i < 6; i++) {
        double square = 0.0;
        for (int j = 0; j < 11; j++)
            rows[i][j] = j < 5 ? d->A[i][j] : j == 5 + i ? sqrt(damping) : 0.0;
        y[i] = e[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < 11; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < 11; j++)
                rows[i][j] -= along * rows[k][j];
            y[i] -= along * y[k];
        }
        for (int j = 0; j < 11; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        y[i] *= inverse;
        for (int j = 0; j < 11; j++)
            rows[i][j] *= inverse;
    }
    for (int i = 6 - 1; i >= 0; i--) {
        double missing = y[i];
        for (int j = 0; j < 11; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < 11; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < 5; j++)
        step[j] = sum[j];
}

/* Takes a row as far as steps help, and tells how long another one would be; returns by how much
 * the row misses the pose then. Beside a singular place a step that is right may be long, and what
 * it leaves, half of its square, far more than was missed. */
static double descended(struct descent *d, int steps, double exact, double q[5], double *ahead)
{
    double u[5], best[5], step[5], least = HUGE_VAL;
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    for (int i = 0; i < 5; i++)
        d->q[i] = q[i];
    for (int j = 0; j < 5; j++)
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
            for (int j = 0; j < 5; j++)
                *ahead = fmax(*ahead, fabs(step[j]));
        }
        if (slow || (least <= 0.001 * exact && *ahead <= 0.0001))
            break;
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 5; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = 0.5 * way * way;
    }
    wrap_angles(best);
    for (int j = 0; j < 5; j++)
        q[solved[j]] = unit[j] * best[j];
    return least;
}

/* The part of a generic direction that leaves the tool where it is, to first order, one long;
 * returns how long it was. */
static double sideways(const struct descent *d, double along[5])
{
    double moved[6], square = 0.0;
    for (int i = 0; i < 6; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < 5; j++)
            moved[i] += d->A[i][j] * stride[j];
    }
    damped_step(d, moved, 0.0, 1e-13, along);
    for (int j = 0; j < 5; j++) {
        along[j] = stride[j] - along[j];
        square += along[j] * along[j];
    }
    const double length = sqrt(square);
    for (int j = 0; j < 5; j++)
        along[j] /= length;
    return length;
}

/* Takes a row as far as steps help, also from both sides of where they get slow: where many
 * solutions meet, joint values between them are singular. A root of four is missed by the fourth
 * power of the way to it. */
static double escaped(struct descent *d, double exact, double q[5])
{
    double ahead, least = descended(d, 72, exact, q, &ahead);
    for (int k = 0; k < 8 && least > exact; k++) {
        double u[5], along[5], end[2][5], miss[2];
        for (int j = 0; j < 5; j++)
            u[j] = q[solved[j]] / unit[j];
        look(d, u);
        if (sideways(d, along) <= 0.0001)
            break;
        double pace = sqrt(sqrt(least));
        for (int side = 0; side < 2; side++) {
            for (int i = 0; i < 5; i++)
                end[side][i] = q[i];
            for (int j = 0; j < 5; j++)
                end[side][solved[j]] += pace * unit[j] * along[j];
            pace = -pace;
            miss[side] = descended(d, 72, exact, end[side], &ahead);
        }
        const int other = miss[1] < miss[0];
        if (!(miss[other] < 0.9 * least))
            break;
        least = miss[other];
        for (int i = 0; i < 5; i++)
            q[i] = end[other][i];
    }
    return least;
}

/* Takes a row to where damped least squares lead, unless it is exact; returns by how much
 * it misses the pose then, `first` being what it misses before. */
static double tightened(struct descent *d, double exact, double first, double q[5], int *moved)
{
    double end[5];
    if (first <= exact)
        return first;
    for (int i = 0; i < 5; i++)
        end[i] = q[i];
    const double least = escaped(d, exact, end);
    for (int i = 0; i < 5; i++) {
        *moved = *moved || q[i] < end[i] || q[i] > end[i];
        q[i] = end[i];
    }
    return least;
}

/* By how much the joint values of two rows differ at most. */
static double gap_between(const double q[5], const double other[5])
{
    double gap[5], widest = 0.0;
    for (int j = 0; j < 5; j++)
        gap[j] = (q[solved[j]] - other[solved[j]]) / unit[j];
    wrap_angles(gap);
    for (int j = 0; j < 5; j++)
        widest = fmax(widest, fabs(gap[j]));
    return widest;
}

/* Whether a row that was moved came to lie on one that missed by less at first. */
static int repeats(double q[8][5], const double first[8], int row)
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
        distance = fmax(distance, fabs(T[4 * coordinate[i] + 3]) / 1.6);
    return 1e-12 * distance;
}

/* Tightens the rows; ends those that miss the pose then, and all but one of those that have become
 * the same. */
static void tighten(
    const struct dhgen_arm *arm, const double T[16], double q[8][5], unsigned char status[8])
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
        for (int i = 0; i < 5; i++)
            q[row][i] = DHGEN_NAN;
    }
}


static const double
    d1 = 0.3, /* joint offset 1 [m] */
    a1 = 0.08, /* link length 1 [m] */
    L2 = 0.5, /* link length 2 [m] */
    L3 = 0.45, /* link length 3 [m] */
    d4 = 0.03, /* joint offset 4 [m] */
    d5 = 0.12, /* joint offset 5 [m] */
    ex = 0.02, /* x of the tool frame [m] */
    ez = 0.1, /* z of the tool frame [m] */
    free_limit2 = 2.5600000000000004e-12, /* a length that fixes no angle [m^2] */
    square_rounding = 1e-15, /* squares are rounded by this */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    double_root = 1e-13, /* a polynomial's value at a root, relative to its coefficients */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    near_limit_squared = 1e-06, /* square of a length whose direction is good to few digits */
    longest3 = 0.9025, /* square of the longest reach [m^2] */
    shortest3 = 0.0024999999999999988, /* square of the shortest reach [m^2] */
    longest3_reach = 0.902530400256, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0024984002559999986, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.9024999999999695, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.002500000000001599, /* the shortest, where branches merge [m^2] */
    longest3_clear = 0.9024999999696, /* the longest, where blurred branches do [m^2] */
    shortest3_clear = 0.002500000001599999, /* the shortest, where blurred branches do [m^2] */
    free_limit_squared2 = 2.5600000000000005e-24, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 2.5600000000000005e-06,
    k1 = 0.5, /* 1 / 2 */
    k2 = 0.06, /* d4 * 2 [m] */
    k3 = 0.0009, /* d4^2 [m^2] */
    k4 = 0.0004, /* ex^2 [m^2] */
    k5 = -50.0, /* -1 / ex [m^-1] */
    k6 = 0.4525, /* L2^2 + L3^2 [m^2] */
    k7 = 2.2222222222222223; /* 1 / (2 * L3 * L2) [m^-2] */

const char *const welding_5r_branches[8] = {
    "root1-down", "root1-up", "root2-down", "root2-up", "root3-down", "root3-up", "root4-down",
    "root4-up",
};

static const struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

void welding_5r_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v3 * s4,
        x4_y = x3_y * c4 - v4 * s4, x4_z = x3_z * c4 + y3_z * s4, z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, x5_z = x4_z * c5, z5_y = c1 * c5 + x4_y * s5, z5_z = x4_z * s5,
        z5_x = x4_x * s5 - s1 * c5;
    T[0] = x5_x; T[1] = z4_x; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * L2 + x3_x * L3 + s1 * d4 + z4_x * d5 + x5_x * ex + z5_x * ez;
    T[4] = x5_y; T[5] = z4_y; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * L2 + x3_y * L3 - c1 * d4 + z4_y * d5 + x5_y * ex + z5_y * ez;
    T[8] = x5_z; T[9] = z4_z; T[10] = z5_z;
    T[11] = d1 + s2 * L2 + x3_z * L3 + z4_z * d5 + x5_z * ex + z5_z * ez;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void welding_5r_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = p1_x + x2_x * L2, p2_y = p1_y + x2_y * L2, p2_z = d1 + s2 * L2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * L3,
        p3_y = p2_y + x3_y * L3, p3_z = p2_z + x3_z * L3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v3 * s4,
        x4_y = x3_y * c4 - v4 * s4, x4_z = x3_z * c4 + y3_z * s4, z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, p4_x = p3_x + s1 * d4, p4_y = p3_y - c1 * d4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]),
        J21 = p4_x + z4_x * d5 + (x4_x * c5 + s1 * s5) * ex + (x4_x * s5 - s1 * c5) * ez,
        v5 = p4_y + z4_y * d5 + (x4_y * c5 - c1 * s5) * ex + (c1 * c5 + x4_y * s5) * ez,
        v6 = p3_z + z4_z * d5 + x4_z * c5 * ex + x4_z * s5 * ez, v7 = v6 - d1, v8 = v6 - p2_z,
        v9 = v6 - p3_z, v10 = J21 - p4_x, v11 = v5 - p4_y;
    J[0] = -v5; J[1] = -(c1 * v7); J[2] = -(c1 * v8); J[3] = -(c1 * v9);
    J[4] = z4_y * v9 - z4_z * v11;
    J[5] = J21; J[6] = -(s1 * v7); J[7] = -(s1 * v8); J[8] = -(s1 * v9);
    J[9] = z4_z * v10 - z4_x * v9;
    J[10] = 0.0; J[11] = s1 * (v5 - p1_y) + c1 * (J21 - p1_x);
    J[12] = s1 * (v5 - p2_y) + c1 * (J21 - p2_x); J[13] = s1 * (v5 - p3_y) + c1 * (J21 - p3_x);
    J[14] = z4_x * v11 - z4_y * v10;
    J[15] = 0.0; J[16] = s1; J[17] = s1; J[18] = s1; J[19] = z4_x;
    J[20] = 0.0; J[21] = -c1; J[22] = -c1; J[23] = -c1; J[24] = z4_y;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = z4_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    (void)free_joints;
    const double T13 = T[2], T14 = T[3];
    const double T23 = T[6], T24 = T[7];
    const double T33 = T[10], T34 = T[11];

    /* theta1, type 9: U1[3, 4] and U1[3, 3] */
    const double v1 = ex * T23, v2 = ex * T13, v3 = ez * T23 - T24, v4 = T14 - ez * T13,
        v5 = v1 * v1, v6 = v2 * v2, v7 = v3 * v3, v8 = v4 * v4, v9 = v3 * k2, v10 = v4 * k2,
        v11 = k1 * (v5 + v6) + (k3 + k1 * (v7 + v8)), v12 = k1 * (v5 - v6) + k1 * (v7 - v8),
        v13 = v3 * v4 - v1 * v2, v14 = v11 - k4,
        v15 = fabs(v14) + fabs(v9) + fabs(v10) + fabs(v12) + fabs(v13);
    const int free1 = v15 <= free_limit2;
    const double v16 = square_rounding * (v11 + k4);
    double x1_roots[4];
    int x1_close[4];
    dhgen_circle_roots(free1 ? 1.0 : v14, free1 ? -1.0 : -v9, free1 ? 0.0 : -v10, free1 ? 0.0 : v12,
        free1 ? 0.0 : v13, v16, moved, x1_roots, x1_close);
    const double v19 = cos(seed[0]) * cos(seed[0]) - sin(seed[0]) * sin(seed[0]),
        v20 = 2.0 * (cos(seed[0]) * sin(seed[0])), v21 = 2.0 * v13, v22 = 2.0 * v12,
        v24 = v15 * near_limit,
        v25 = v19 * v21 + (v9 * sin(seed[0]) - v10 * cos(seed[0])) - v20 * v22;
    const int v26 = fabs(v14 + (v13 * v20 + (v12 * v19 - (v9 * cos(seed[0]) + v10 * sin(seed[0])))))
        <= v16 + v15 * double_root;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v28 = seed[1] + seed[2] + seed[3];

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v30 = T34 - d1;

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x1 = x1_roots[i1];
        /* theta1 */
        if (!(x1 <= 4.0)) continue; /* out of reach */
        const double v17 = cos(x1), v18 = sin(x1),
            v23 = (v17 * v17 - v18 * v18) * v21 + (v9 * v18 - v10 * v17) - 2.0 * (v17 * v18) * v22;
        const int near1 = fabs(v23) <= v24;
        const int same1 = -(double_root * (v15 * v15)) <= v23 * v25 && 0.0 < v17 * cos(seed[0]) +
            v18 * sin(seed[0]) && fabs(v17 * sin(seed[0]) - v18 * cos(seed[0])) <= near_limit &&
            near1 && v26;
        const double v27 = same1 ? seed[0] : x1;
        const double q1 = free1 ? seed[0] : v27;
        const double c1 = cos(q1), s1 = sin(q1);

        /* theta5, type 3: U1[3, 4] and U1[3, 3] */
        const double Z2_5 = T13 * s1 - T23 * c1;
        const double s5 = (d4 - (T14 * s1 - T24 * c1) + ez * Z2_5) * k5, c5 = ex * Z2_5 * k5;
        const double q5 = atan2(s5, c5);

        /* theta234 */
        const double S234 = s5 * T33;
        const double C234 = s5 * (T13 * c1 + T23 * s1);
        const double w234 = sqrt(S234 * S234 + C234 * C234);
        const int free234 = w234 <= free_limit_squared;
        const int near234 = w234 <= near_limit_squared;
        const double factor234 = 1.0 / (free234 ? 1.0 : w234);
        const double c234 = free234 ? cos(v28) : C234 * factor234,
            s234 = free234 ? sin(v28) : S234 * factor234;
        const double theta234 = atan2(s234, c234);

        /* theta3 */
        const double v29 = ex * c5 + ez * s5;
        const double Z1_3 = c234 * d5 - s234 * v29 + v30;
        const double Z2_3 = T14 * c1 + T24 * s1 - a1 - (c234 * v29 + s234 * d5);
        const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
        const double K3 = N3 - k6;
        const double D3 = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
            if (near1) dhgen_lose(DHGEN_NEARLY + 1, D3, q[2 * i1], &status[2 * i1]);
            if (near1) q[2 * i1][1] = v27;
            if (free1) dhgen_lose(DHGEN_LOST + 1, D3, q[2 * i1], &status[2 * i1]);
            if (free234) dhgen_lose(DHGEN_LOST + 2, D3, q[2 * i1], &status[2 * i1]);
            if (free234) dhgen_lose(DHGEN_LOST + 3, D3, q[2 * i1], &status[2 * i1]);
            if (free234) dhgen_lose(DHGEN_LOST + 4, D3, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w3 = sqrt(apart3 ? D3 : 0.0);
        const double c3 = K3 * k7;

        /* theta2, type 3: U1[2, 4] and U1[1, 4] */
        const double X1_2 = L2 + L3 * c3;
        const double v31 = Z1_3 * X1_2, v32 = Z2_3 * X1_2;

        for (int i2 = 0; i2 < 2; i2++) { /* down, up */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e2 < 0.0 && (!apart3 || (near1 && !(shortest3_clear < N3 && N3 < longest3_clear))))
                continue; /* both signs give the same */
            const double s3 = w3 * e2 * k7;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double Y1_2 = L3 * s3;
            const double S2 = v31 - Z2_3 * Y1_2;
            const double C2 = v32 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const int near2 = w2 <= near_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* joint values */
            const double q4 = dhgen_wrap(theta234 - (q3 + q2));
            const int free2_ = free234 || free2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            status[row] = (free1 || free2_ || free234 || free234) ? DHGEN_FREE_JOINT : (x1_close[i1]
                || near1 || near234 || near2) ? DHGEN_CLOSE : DHGEN_OK;
        }
    }
}

/* Whether joint values are a solution. Beside a singular place they may miss the pose by next to
 * nothing and be far from any. */
static int solves(struct descent *d, int steps, double exact, double q[5])
{
    double ahead;
    return descended(d, steps, exact, q, &ahead) <= exact && ahead <= 0.0001;
}

/* Whether a solution is none of those. */
static int is_new(double known[16][5], int count, const double q[5])
{
    for (int k = 0; k < count; k++)
        if (gap_between(known[k], q) < 0.001)
            return 0;
    return 1;
}

/* Puts a solution behind those that are known, unless it is one of them; returns how many there
 * are. */
static int keep(double known[16][5], int count, const double q[5])
{
    if (!is_new(known, count, q))
        return count;
    take(q, known[count]);
    return count + 1;
}

/* Whether the row of a root that is moved leads to a solution, and to which. */
static int leads(
    struct descent *d, const double *free_joints, const double seed[5], double angle, int row,
        double exact,
    double end[5])
{
    double q[8][5];
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
const double T[16], const double *free_joints, const double seed[5], double q[8][5],
    unsigned char status[8])
{
    struct descent d = { .T = T };
    double known[16][5], own[8][5], away[5];
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
        double here[5];
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
        double end[5], other[5], off = 0.0;
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
        for (int i = 0; i < 5 && status[row] == NONE; i++)
            q[row][i] = DHGEN_NAN;
}


/* Between which values starts lie. */
static const double span_low[5] = {
    -2.9670597283903604, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793,
};
static const double span_width[5] = {
    5.934119456780721, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
};

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[5])
{
    for (int j = 0; j < 5; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}

/* Takes u to where damped least squares lead; returns by how much that misses the pose. Near to it
 * less damping than usual leads further, where joints hardly move the tool: there a step that is
 * right may be long, and what it leaves, half of its square, far more than was missed. */
static double descend(struct descent *d, double u[5])
{
    double least = HUGE_VAL, little = 1e-13, best[5], step[5];
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
        for (int j = 0; j < 5; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = little < 1e-13 ? 0.5 * way * way : 0.0;
    }
    copy(best, u);
    return least;
}

/* A pose was left without a row after a joint had been chosen, or with
 * none inside the limits: several joints may be free, and few of their values serve. Steps
 * from the seed and from evenly spread starts lead to some that do. What is wrong with values: 1 is
 * that they are beyond limits, 2 that they are not exact, 4 that there are none. */
static void seek(
const struct dhgen_arm *arm, const double T[16], const double *free_joints, const double seed[5],
    int begun, double q[8][5],
    unsigned char status[8])
{
    struct descent d = { .T = T };
    const double exact = exactness(T);
    double found[5] = { 0.0 };
    (void)free_joints;
    int before = 4, chosen = -1;
    for (int row = 8 - 1; row >= 0; row--) {
        int fault = 0, is_open = status[row] == FREE;
        if (status[row] == NONE)
            continue;
        fault += dhgen_beyond_limits(arm, q[row]) > 0.0;
        before = fault < before ? fault : before;
        chosen = is_open ? row : chosen;
    }
    if (before == 0 || (before < 4 && chosen < 0))
        return;
    int least = before;
    take(seed, d.q);
    for (int j = 0; j < 5; j++)
        d.seed[j] = seed[solved[j]] / unit[j];
    for (int k = 0; k < 12 && least; k++) {
        double u[5], end[5];
        start_of(&d, k, u);
        if (descend(&d, u) > 0.01)
            continue;
        take(d.q, end);
        for (int j = 0; j < 5; j++)
            end[solved[j]] = unit[j] * u[j];
        const double miss = escaped(&d, exact, end);
        if (miss > 10.0 * exact)
            continue;
        if (dhgen_beyond_limits(arm, end) > 0.0)
            (void)dhgen_refine(arm, T, DHGEN_NAN, HUGE_VAL, end);
        const int fault = 2 * (miss > exact) + (dhgen_beyond_limits(arm, end) > 0.0);
        if (fault >= least)
            continue;
        least = fault;
        take(end, found);
    }
    if (least == before)
        return;
    if (before < 4 && before / 2 == least / 2) { /* other rows are no less exact */
        take(found, q[chosen]);
        return;
    }
    for (int row = 0; row < 8; row++) {
        status[row] = row == begun ? FREE : NONE;
        for (int i = 0; i < 5; i++)
            q[row][i] = row == begun ? found[i] : DHGEN_NAN;
    }
}


/* What follows where roots nearly meet, and where rows miss the pose. */
static void complete(
    const struct dhgen_arm *arm, const double *T, const double *free_joints, const double *seed,
    int begun, double *rows, unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    both_sides(T, free_joints, seed, q, status);
    tighten(arm, T, q, status);
    if (begun >= 0)
        seek(arm, T, free_joints, seed, begun, q, status);
}

static const int entries[6] = { 2, 3, 6, 7, 10, 11 };
static const int choosable[4] = { 3, 2, 1, 0 };
static const struct dhgen_arm arm = {
    5, 8, 0, DHGEN_POINTING, joints, NULL, 0,
    { 0.625, 0.625, 0.625, 1.0, 1.0, 1.0 }, 0.625, entries, 6,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 4, NULL, 0, 52,
    1, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* winds */
    1, /* follows seed */
    welding_5r_fk, welding_5r_jacobian, solve, complete, NULL,
};

int welding_5r_ik(
    const double T[16], const double *q_seed, double q[8][5], unsigned char status[8])
{
    return dhgen_careful_ik(&arm, T, NULL, q_seed, &q[0][0], status);
}

int welding_5r_ik_nearest(const double T[16], const double q_seed[5], double q[5])
{
    return dhgen_ik_nearest(&arm, T, NULL, q_seed, q);
}

void welding_5r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, NULL, q, status);
}
