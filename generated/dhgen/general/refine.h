/* SPDX-License-Identifier: MIT
 *
 * Newton's method on the loop, in lanes. */
#ifndef DHGEN_GENERAL_REFINE_H
#define DHGEN_GENERAL_REFINE_H

#include "loop.h"
#include "motions.h"

/* Singular values below this part of the largest count as zero: Newton then moves in the rest only,
 * instead of leaping along a direction that the pose does not determine. */
#define DHGEN_RANK 1e-09
/* Damping of steps from afar, in the square of the error, and at most. */
#define DHGEN_LOOP_DAMPING 0.01
/* Added to damped squares that are divided by. */
#define DHGEN_SMALLEST_SQUARE 1e-30
/* The square of an error that is rounding: steps end. */
#define DHGEN_GOOD_ENOUGH 1e-29

/* The loop's error at cosines and sines of the joints: translation and rotation vector that are
 * missing. J, when given, takes the rows of the Jacobian with the error as seventh column. Returns
 * the square of the error. */
DHGEN_INLINE dhgen_lane dhgen_loop_error(
    const dhgen_loop *loop, const dhgen_lane c[6], const dhgen_lane s[6], dhgen_lane J[6][7])
{
    const double *const P = loop->link[5];
    dhgen_rigid T;
    dhgen_lane z[6][3], o[6][3], S[3][3], square = { 0 }, trace;
    dhgen_broadcast(T, dhgen_identity);
    DHGEN_UNROLL
    for (int k = 0; k < 6; k++) {
        if (k) {
            dhgen_multiply(T, loop->link[k - 1]);
        }
        DHGEN_UNROLL
        for (int i = 0; i < 3; i++) {
            z[k][i] = T[i][2];
            o[k][i] = T[i][3];
        }
        dhgen_move(loop->arm, T, k, c[k], s[k]);
    }
    DHGEN_UNROLL
    for (int i = 0; i < 3; i++) {
        DHGEN_UNROLL
        for (int j = 0; j < 3; j++) {
            S[i][j] = P[4 * i] * T[j][0] + P[4 * i + 1] * T[j][1] + P[4 * i + 2] * T[j][2];
        }
        J[i][6] = P[4 * i + 3] - T[i][3];
    }
    J[3][6] = 0.5 * (S[2][1] - S[1][2]);
    J[4][6] = 0.5 * (S[0][2] - S[2][0]);
    J[5][6] = 0.5 * (S[1][0] - S[0][1]);
    DHGEN_UNROLL
    for (int i = 0; i < 6; i++) {
        square += J[i][6] * J[i][6];
    }
    DHGEN_UNROLL
    for (int k = 0; k < 6; k++) {
        DHGEN_UNROLL
        for (int i = 0; i < 3; i++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            J[i][k] = z[k][i1] * (T[i2][3] - o[k][i2]) - z[k][i2] * (T[i1][3] - o[k][i1]);
            J[3 + i][k] = z[k][i];
        }
    }
    if (dhgen_has(loop->arm, DHGEN_ANY_SLIDE)) {
        for (int k = 0; k < 6; k++) {
            for (int i = 0; i < 3 && dhgen_is_slide(loop->arm, k); i++) {
                J[i][k] = z[k][i];
                J[3 + i][k] = dhgen_lane_all(0.0);
            }
        }
    }
    /* half a turn away the skew part vanishes, too, but the trace is negative */
    trace = S[0][0] + S[1][1] + S[2][2];
    return dhgen_lane_select(trace < 0.0, square + 1.0, square);
}

/* A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
 * next to nothing the step is zero instead of leaping. Returns the smallest diagonal over the
 * largest. */
DHGEN_INLINE dhgen_lane dhgen_newton_step(dhgen_lane J[6][7], dhgen_lane x[6])
{
    dhgen_lane *const row[6] = { J[0], J[1], J[2], J[3], J[4], J[5] };
    dhgen_lane most, least;
    const dhgen_lane zero = { 0 };
    dhgen_reflect(row, 6, 0, 7);
    dhgen_reflect(row + 1, 5, 1, 7);
    dhgen_reflect(row + 2, 4, 2, 7);
    dhgen_reflect(row + 3, 3, 3, 7);
    dhgen_reflect(row + 4, 2, 4, 7);
    most = least = dhgen_lane_abs(J[0][0]);
    for (int i = 1; i < 6; i++) {
        most = dhgen_lane_max(most, dhgen_lane_abs(J[i][i]));
        least = dhgen_lane_min(least, dhgen_lane_abs(J[i][i]));
    }
    least /= most;
    most *= DHGEN_RANK;
    for (int i = 5; i >= 0; i--) {
        dhgen_lane sum = J[i][6];
        for (int j = i + 1; j < 6; j++) {
            sum -= J[i][j] * x[j];
        }
        sum /= J[i][i];
        sum = dhgen_lane_max(dhgen_lane_min(sum, zero + 1.0), zero - 1.0);
        x[i] = dhgen_lane_select(dhgen_lane_abs(J[i][i]) > most, sum, zero);
    }
    return least;
}

/* A damped step of Newton, for starts far away and for singular solutions: (J' J + d) x = J' error.
 */
DHGEN_INLINE void dhgen_damped_newton_step(dhgen_lane J[6][7], dhgen_lane damping, dhgen_lane x[6])
{
    dhgen_lane A[6][7];
    for (int i = 0; i < 6; i++) {
        for (int j = i; j < 7; j++) {
            A[i][j] = J[0][i] * J[0][j];
            for (int k = 1; k < 6; k++) {
                A[i][j] += J[k][i] * J[k][j];
            }
        }
        A[i][i] += damping;
    }
    for (int i = 0; i < 6; i++) {
        const dhgen_lane pivot = 1.0 / (A[i][i] + DHGEN_SMALLEST_SQUARE);
        for (int j = i + 1; j < 6; j++) {
            const dhgen_lane factor = A[i][j] * pivot;
            for (int k = j; k < 7; k++) {
                A[j][k] -= factor * A[i][k];
            }
        }
    }
    for (int i = 5; i >= 0; i--) {
        x[i] = A[i][6];
        for (int j = i + 1; j < 6; j++) {
            x[i] -= A[i][j] * x[j];
        }
        x[i] /= A[i][i] + DHGEN_SMALLEST_SQUARE;
        x[i] = dhgen_lane_max(dhgen_lane_min(x[i], dhgen_lane_all(1.0)), dhgen_lane_all(-1.0));
    }
}

/* Newton on the loop; what remains in c and s is the best iterate, and its error is returned. */
DHGEN_INLINE dhgen_lane dhgen_refine_lanes(
    const dhgen_loop *loop, dhgen_lane c[6], dhgen_lane s[6], int steps, int afar)
{
    dhgen_lane J[6][7], x[6], tc[6], ts[6], least, now;
    for (int i = 0; i < 6; i++) {
        tc[i] = c[i];
        ts[i] = s[i];
    }
    least = now = dhgen_loop_error(loop, c, s, J);
    for (int step = 0; step < steps; step++) {
        dhgen_mask better;
        if (dhgen_lane_largest(least) < DHGEN_GOOD_ENOUGH) {
            break;
        }
        if (afar) {
            dhgen_damped_newton_step(
                J, dhgen_lane_min(now * DHGEN_LOOP_DAMPING, dhgen_lane_all(DHGEN_LOOP_DAMPING)), x);
        } else {
            (void)dhgen_newton_step(J, x);
        }
        for (int i = 0; i < 6; i++) {
            if (dhgen_is_slide(loop->arm, i)) {
                ts[i] += x[i];
                continue;
            }
            /* a turn by 2 atan(x/2), without trigonometry */
            const dhgen_lane u = 0.25 * x[i] * x[i], f = 1.0 / (1.0 + u);
            const dhgen_lane dc = (1.0 - u) * f, ds = x[i] * f, old = tc[i];
            tc[i] = old * dc - ts[i] * ds;
            ts[i] = ts[i] * dc + old * ds;
        }
        now = dhgen_loop_error(loop, tc, ts, J);
        better = now < least;
        for (int i = 0; i < 6; i++) {
            c[i] = dhgen_lane_select(better, tc[i], c[i]);
            s[i] = dhgen_lane_select(better, ts[i], s[i]);
        }
        least = dhgen_lane_select(better, now, least);
    }
    return dhgen_lane_sqrt(least);
}

#endif
