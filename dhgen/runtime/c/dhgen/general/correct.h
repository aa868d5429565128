/* SPDX-License-Identifier: MIT
 *
 * From joint values that are near all solutions to these: Newton's method, in the frame of joint 3,
 * for arms without slides. There axis 3 is z, and axis 4 is fixed: what is across both twists is
 * four equations in the other joints. */
#ifndef DHGEN_GENERAL_CORRECT_H
#define DHGEN_GENERAL_CORRECT_H

#include "solutions.h"

/* Steps at most, and the longest that is the last one [rad]: the next one would be its square. */
#define DHGEN_CORRECTIONS 8
#define DHGEN_LAST_CORRECTION 1e-07
/* The longest step [rad], to which longer ones are cut: from a row that is near its solution none
 * is, and up to it the series below are right to 1e-15. */
#define DHGEN_LONGEST_CORRECTION 0.25
/* What so short a step may take back [rad, arm sizes]: the loop is two long. */
#define DHGEN_LAST_MISS 1e-05
/* Solutions of which some joint differs by more are not about to meet [rad]. */
#define DHGEN_WELL_APART 0.01
/* The tolerance `exact`: the loop of an exact solution is open by no more [rad, arm sizes]. */
#define DHGEN_LOOP_EXACT 1e-12

/* What the pose's solutions have in common: the way back from joint 3 to joint 1, and the twist of
 * axis 4, velocity of the origin and angular velocity, divided by its largest entry but the last.
 */
typedef struct {
    double back_1[12], back_0[12]; /* the inverses of K1 and K0 */
    double axis_4[6];
    int pivot, other[4]; /* the place of that entry, and of the other ones */
    double per_pivot;
} dhgen_middle;

DHGEN_FN void dhgen_look_from_middle(const dhgen_loop *loop, dhgen_middle *middle)
{
    const double *const K = loop->link[2];
    int others = 0;
    dhgen_invert(loop->link[1], middle->back_1);
    dhgen_invert(loop->link[0], middle->back_0);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        middle->axis_4[i] = K[4 * j + 3] * K[4 * k + 2] - K[4 * k + 3] * K[4 * j + 2];
        middle->axis_4[3 + i] = K[4 * i + 2];
    }
    middle->pivot = 0;
    for (int i = 1; i < 5; i++) {
        if (fabs(middle->axis_4[i]) > fabs(middle->axis_4[middle->pivot])) {
            middle->pivot = i;
        }
    }
    for (int i = 0; i < 5; i++) {
        if (i != middle->pivot) {
            middle->other[others++] = i;
        }
    }
    middle->per_pivot = 1.0 / middle->axis_4[middle->pivot];
    for (int i = 0; i < 6; i++) {
        middle->axis_4[i] *= middle->per_pivot;
    }
}

/* A column of the Jacobian: the twist of the z axis of a frame. */
DHGEN_INLINE void dhgen_twist(dhgen_rigid T, int column, dhgen_lane A[6][5])
{
    DHGEN_UNROLL
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        A[i][column] = T[j][3] * T[k][2] - T[k][3] * T[j][2];
        A[3 + i][column] = T[i][2];
    }
}

/* What the loop misses, as a twist, in the last column of A; its first ones are the twists of
 * joints 1, 2, 5 and 6. Returns the square of the miss. */
DHGEN_INLINE dhgen_lane dhgen_middle_miss(const dhgen_loop *loop, const dhgen_middle *middle,
    const dhgen_lane c[6], const dhgen_lane s[6], dhgen_lane A[6][5])
{
    const double *const B = middle->back_1;
    dhgen_rigid U, W;
    dhgen_lane square, along_x, along_z;
    DHGEN_UNROLL
    for (int j = 0; j < 4; j++) {
        U[0][j] = c[2] * B[j] + s[2] * B[4 + j];
        U[1][j] = c[2] * B[4 + j] - s[2] * B[j];
        U[2][j] = dhgen_lane_all(B[8 + j]);
    }
    dhgen_twist(U, 1, A);
    dhgen_turn(U, c[1], -s[1]);
    dhgen_multiply(U, middle->back_0);
    dhgen_twist(U, 0, A);
    dhgen_turn(U, c[0], -s[0]);
    dhgen_multiply(U, loop->link[5]);
    dhgen_broadcast(W, loop->link[2]);
    dhgen_turn(W, c[3], s[3]);
    dhgen_multiply(W, loop->link[3]);
    dhgen_twist(W, 2, A);
    dhgen_turn(W, c[4], s[4]);
    dhgen_multiply(W, loop->link[4]);
    dhgen_twist(W, 3, A);
    dhgen_turn(W, c[5], s[5]);
    DHGEN_UNROLL
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        A[3 + i][4] = 0.5
            * ((U[k][0] * W[j][0] + U[k][1] * W[j][1] + U[k][2] * W[j][2])
                - (U[j][0] * W[k][0] + U[j][1] * W[k][1] + U[j][2] * W[k][2]));
    }
    DHGEN_UNROLL
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        A[i][4] = U[i][3] - W[i][3] - (A[3 + j][4] * W[k][3] - A[3 + k][4] * W[j][3]);
    }
    square = A[0][4] * A[0][4];
    DHGEN_UNROLL
    for (int i = 1; i < 6; i++) {
        square += A[i][4] * A[i][4];
    }
    /* half a turn away the skew part vanishes, too, but the x or the z axes are apart */
    along_x = U[0][0] * W[0][0] + U[1][0] * W[1][0] + U[2][0] * W[2][0];
    along_z = U[0][2] * W[0][2] + U[1][2] * W[1][2] + U[2][2] * W[2][2];
    return dhgen_lane_select(dhgen_lane_min(along_x, along_z) < 0.0, square + 1.0, square);
}

/* Solves four equations, the last column of M the right side, by minors of two rows. */
DHGEN_INLINE void dhgen_solve_four(dhgen_lane M[4][5], dhgen_lane x[4])
{
    static const int pair[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
    dhgen_lane a[6], b[6], u[4], w[4], per_determinant;
    DHGEN_UNROLL
    for (int k = 0; k < 6; k++) {
        const int i = pair[k][0], j = pair[k][1];
        a[k] = M[0][i] * M[1][j] - M[1][i] * M[0][j];
        b[k] = M[2][i] * M[3][j] - M[3][i] * M[2][j];
    }
    DHGEN_UNROLL
    for (int i = 0; i < 4; i++) {
        u[i] = M[1][i] * M[0][4] - M[0][i] * M[1][4];
        w[i] = M[3][i] * M[2][4] - M[2][i] * M[3][4];
    }
    per_determinant =
        1.0 / (a[0] * b[5] - a[1] * b[4] + a[2] * b[3] + a[3] * b[2] - a[4] * b[1] + a[5] * b[0]);
    x[0] = (u[1] * b[5] - u[2] * b[4] + u[3] * b[3]) + (w[1] * a[5] - w[2] * a[4] + w[3] * a[3]);
    x[1] = (u[2] * b[2] - u[0] * b[5] - u[3] * b[1]) + (w[2] * a[2] - w[0] * a[5] - w[3] * a[1]);
    x[2] = (u[0] * b[4] - u[1] * b[2] + u[3] * b[0]) + (w[0] * a[4] - w[1] * a[2] + w[3] * a[0]);
    x[3] = (u[1] * b[1] - u[0] * b[3] - u[2] * b[0]) + (w[1] * a[1] - w[0] * a[3] - w[2] * a[0]);
    DHGEN_UNROLL
    for (int i = 0; i < 4; i++) {
        x[i] *= per_determinant;
    }
}

/* The step of Newton's method for all joints. */
DHGEN_INLINE void dhgen_correction(const dhgen_middle *middle, dhgen_lane A[6][5], dhgen_lane x[6])
{
    dhgen_lane M[4][5], y[4], *const pivot = A[middle->pivot];
    DHGEN_UNROLL
    for (int i = 0; i < 4; i++) {
        const int row = middle->other[i];
        DHGEN_UNROLL
        for (int j = 0; j < 5; j++) {
            M[i][j] = A[row][j] - pivot[j] * middle->axis_4[row];
        }
    }
    dhgen_solve_four(M, y);
    const dhgen_lane along =
        pivot[4] - (pivot[0] * y[0] + pivot[1] * y[1] + pivot[2] * y[2] + pivot[3] * y[3]);
    x[0] = y[0];
    x[1] = y[1];
    x[2] = A[5][4] - (A[5][0] * y[0] + A[5][1] * y[1] + A[5][2] * y[2] + A[5][3] * y[3])
        - along * middle->axis_4[5];
    x[3] = along * middle->per_pivot;
    x[4] = y[2];
    x[5] = y[3];
}

/* Turns a cosine and a sine by an angle up to DHGEN_LONGEST_CORRECTION, by its series. */
DHGEN_INLINE void dhgen_turn_by(dhgen_lane x, dhgen_lane *c, dhgen_lane *s)
{
    const dhgen_lane u = x * x, old = *c;
    dhgen_lane a = dhgen_lane_all(dhgen_cosine_series[4]), b = dhgen_lane_all(dhgen_sine_series[4]);
    DHGEN_UNROLL
    for (int k = 3; k >= 0; k--) {
        a = a * u + dhgen_cosine_series[k];
        b = b * u + dhgen_sine_series[k];
    }
    a = a * u;
    b = x + b * u * x;
    *c = old + (old * a - *s * b);
    *s = *s + (*s * a + old * b);
}

/* Takes angles of the joints, and their cosines and sines, from near to solutions to these. Returns
 * the misses, no less than they are: those before the last step are taken back by it up to its
 * square. */
DHGEN_INLINE dhgen_lane dhgen_correct_lanes(const dhgen_loop *loop, const dhgen_middle *middle,
    dhgen_lane angle[6], dhgen_lane c[6], dhgen_lane s[6])
{
    const dhgen_lane longest = dhgen_lane_all(DHGEN_LONGEST_CORRECTION);
    const dhgen_lane last = dhgen_lane_all(DHGEN_LAST_CORRECTION);
    dhgen_lane A[6][5], x[6], most, sum, square;
    for (int n = 0;; n++) {
        square = dhgen_middle_miss(loop, middle, c, s, A);
        dhgen_correction(middle, A, x);
        most = sum = dhgen_lane_all(0.0);
        DHGEN_UNROLL
        for (int i = 0; i < 6; i++) {
            x[i] = dhgen_lane_max(-longest, dhgen_lane_min(longest, x[i]));
            angle[i] += x[i];
            most = dhgen_lane_max(most, dhgen_lane_abs(x[i]));
            sum += dhgen_lane_abs(x[i]);
        }
        if (n == DHGEN_CORRECTIONS - 1 || !dhgen_lane_any_above(most, last)) {
            break;
        }
        DHGEN_UNROLL
        for (int i = 0; i < 6; i++) {
            dhgen_turn_by(x[i], &c[i], &s[i]);
        }
    }
    return dhgen_lane_select(
        square <= DHGEN_LAST_MISS * DHGEN_LAST_MISS, sum * sum, dhgen_lane_all(1.0));
}

/* An angle within a turn and a half of zero, in (-pi, pi]: half a turn is +pi, whatever rounding
 * makes of it. */
DHGEN_INLINE dhgen_lane dhgen_lane_wrap(dhgen_lane angle)
{
    const dhgen_lane half = dhgen_lane_all(DHGEN_HALF_TURN), turn = half + half;
    angle = dhgen_lane_select(angle > half, angle - turn, angle);
    angle = dhgen_lane_select(angle < -half, angle + turn, angle);
    return dhgen_lane_select(angle < -DHGEN_ALMOST_PI, half, angle);
}

/* Refines angles of the loop that are near to solutions, and computes by how much it is open
 * there. */
DHGEN_FN void dhgen_correct_angles(
    const dhgen_loop *loop, double (*angle)[6], int count, double *residual)
{
    const double *const cosine = loop->arm->advance[0], *const sine = loop->arm->advance[1];
    dhgen_middle middle;
    dhgen_look_from_middle(loop, &middle);
    for (int from = 0; from < count; from += DHGEN_GENERAL_LANES) {
        const int left = count - from,
                  now = left < DHGEN_GENERAL_LANES ? left : DHGEN_GENERAL_LANES;
        DHGEN_ROWS_IN_ROOM(values, 6, DHGEN_BOARD(0));
        DHGEN_LANES_IN_ROOM(miss, DHGEN_BOARD(6));
        dhgen_lane a[6], c[6], s[6];
        for (int k = DHGEN_FIRST_LANE; k < DHGEN_END_LANE; k++) {
            const double *row = angle[from + (k < now ? k : 0)];
            for (int i = 0; i < 6; i++) {
                values[i][k] = row[i];
            }
        }
        DHGEN_MEET();
        DHGEN_UNROLL
        for (int i = 0; i < 6; i++) {
            a[i] = DHGEN_LOAD(values[i]);
            dhgen_lane x, y;
            dhgen_lane_direction(a[i], &x, &y);
            c[i] = x * cosine[i] + y * sine[i];
            s[i] = y * cosine[i] - x * sine[i];
        }
        DHGEN_STORE(miss, dhgen_correct_lanes(loop, &middle, a, c, s));
        DHGEN_UNROLL
        for (int i = 0; i < 6; i++) {
            DHGEN_STORE(values[i], dhgen_lane_wrap(a[i]));
        }
        for (int k = 0; k < now; k++) {
            residual[from + k] = miss[k];
            for (int i = 0; i < 6; i++) {
                angle[from + k][i] = values[i][k];
            }
        }
    }
}

/* Whether all are exact, and no two of them near one another. */
DHGEN_FN int dhgen_are_apart(
    const dhgen_general_arm *arm, double (*angle)[6], int count, const double *residual)
{
    for (int k = 0; k < count; k++) {
        if (!(residual[k] <= DHGEN_LOOP_EXACT)) {
            return 0;
        }
        for (int i = 0; i < k; i++) {
            if (dhgen_is_close(arm, angle[i], angle[k], DHGEN_WELL_APART)) {
                return 0;
            }
        }
    }
    return 1;
}

#endif
