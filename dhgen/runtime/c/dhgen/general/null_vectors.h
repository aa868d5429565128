/* SPDX-License-Identifier: MIT
 *
 * Candidates: hidden angles with a null vector of the determinant's matrix. */
#ifndef DHGEN_GENERAL_NULL_VECTORS_H
#define DHGEN_GENERAL_NULL_VECTORS_H

#include "circle_cells.h"
#include "determinant.h"

/* Room for candidates: roots, the middles of close pairs, double roots, and what may be on both
 * sides of them. */
#define DHGEN_CANDIDATES 144
/* And with lanes behind the last one. */
#define DHGEN_CANDIDATES_IN_LANES \
    ((DHGEN_CANDIDATES + DHGEN_GENERAL_LANES - 1) / DHGEN_GENERAL_LANES * DHGEN_GENERAL_LANES)
/* As near to a double root simple ones are looked for [rad], at eight places at a time, and how
 * often: each parabola shows where to look next. */
#define DHGEN_BESIDE 0.0001
#define DHGEN_PARABOLAS 4
/* From 3e-5 rad to the digits that the determinant has. */
#define DHGEN_BRACKET_STEPS 8
/* Of the largest diagonal: none is taken as smaller. */
#define DHGEN_SMALLEST 1e-15
/* Below this determinant the rows of a shift don't span a plane. */
#define DHGEN_PLANE 1e-24
/* A matrix is not singular when its smallest singular value is more than 2e-7 of all, and the one
 * before that more than 1e-6: where two are small, so many roots crowd that the determinant,
 * sampled, does not show whether they are real. The squares of their inverses. */
#define DHGEN_REGULAR 25000000000000.004
#define DHGEN_ALONE 1000000000000.0
/* Nor does it show whether the matrix is singular where the columns that are cleared first nearly
 * depend on each other: where their least singular value is below 3e-4 of all; its square. */
#define DHGEN_INDEPENDENT 8.999999999999999e-08

/* Starts of the iteration to null vectors: anything that no null vector is orthogonal to. */
DHGEN_TABLE double dhgen_starts[2][6] = {
    { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 },
    { -0.31, 0.47, 0.59, 0.67, -0.23, 0.41 },
};

/* The rows of the two shifts: by x3 and by x2. */
DHGEN_TABLE int dhgen_up_3[3] = { 0, 1, 2 };
DHGEN_TABLE int dhgen_down_3[3] = { 3, 4, 5 };
DHGEN_TABLE int dhgen_up_2[4] = { 0, 1, 3, 4 };
DHGEN_TABLE int dhgen_down_2[4] = { 1, 2, 4, 5 };

/* Candidates: the hidden angle and a null vector, (x3, 1) x (x2^2, x2, 1) times anything. The
 * simple roots come first, one candidate each; after them those of roots that may be double,
 * `group` being the same for all that belong to one such root, which is none where the matrix is
 * regular: it has no singular value that is next to nothing, and not two small ones, as where so
 * many roots crowd that the determinant does not show it. */
typedef struct {
    int count, groups, group[DHGEN_CANDIDATES], regular[DHGEN_CANDIDATES];
    DHGEN_MEMBER(c, DHGEN_CANDIDATES_IN_LANES);
    DHGEN_MEMBER(s, DHGEN_CANDIDATES_IN_LANES);
    DHGEN_MEMBER_ROWS(n, 6, DHGEN_CANDIDATES_IN_LANES);
} dhgen_candidates;

/* x = U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal. Returns what was
 * its length: the reciprocal of the square of the smallest singular value, in the end. */
DHGEN_INLINE dhgen_lane dhgen_inverse_iteration(
    dhgen_lane U[6][6], const dhgen_lane inverse[6], dhgen_lane x[6])
{
    dhgen_lane square = { 0 };
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < i; j++) {
            x[i] -= U[j][i] * x[j];
        }
        x[i] *= inverse[i];
    }
    for (int i = 5; i >= 0; i--) {
        for (int j = i + 1; j < 6; j++) {
            x[i] -= U[i][j] * x[j];
        }
        x[i] *= inverse[i];
        square += x[i] * x[i];
    }
    const dhgen_lane length = dhgen_lane_sqrt(square) + DHGEN_TINY;
    for (int i = 0; i < 6; i++) {
        x[i] *= 1.0 / length;
    }
    return length;
}

/* The reciprocals of a diagonal, kept finite. */
DHGEN_INLINE void dhgen_reciprocals(dhgen_lane U[6][6], dhgen_lane inverse[6])
{
    dhgen_lane most = dhgen_lane_abs(U[0][0]);
    for (int i = 1; i < 6; i++) {
        most = dhgen_lane_max(most, dhgen_lane_abs(U[i][i]));
    }
    most = most * DHGEN_SMALLEST + DHGEN_TINY;
    for (int i = 0; i < 6; i++) {
        const dhgen_lane d = U[i][i];
        inverse[i] =
            1.0 / dhgen_lane_select(dhgen_lane_abs(d) > most, d, dhgen_lane_with_sign(most, d));
    }
}

/* One candidate for each simple root, all of one group. */
DHGEN_FN void dhgen_null_vectors(const double *E, const dhgen_roots *roots, dhgen_candidates *out)
{
    const int behind = out->count;
    for (int from = 0; from < roots->simple; from += DHGEN_GENERAL_LANES) {
        const dhgen_lane c = dhgen_lane_from(roots->c, from, roots->simple);
        const dhgen_lane s = dhgen_lane_from(roots->s, from, roots->simple);
        dhgen_lane factor[6][6], inverse[6], x[6];
        (void)dhgen_determinant(E, c, s, factor);
        dhgen_reciprocals(factor, inverse);
        for (int i = 0; i < 6; i++) {
            x[i] = dhgen_lane_all(dhgen_starts[0][i]);
        }
        (void)dhgen_inverse_iteration(factor, inverse, x);
        (void)dhgen_inverse_iteration(factor, inverse, x);
        DHGEN_STORE(out->c + behind + from, c);
        DHGEN_STORE(out->s + behind + from, s);
        for (int i = 0; i < 6; i++) {
            DHGEN_STORE(out->n[i] + behind + from, x[i]);
        }
    }
    for (int i = 0; i < roots->simple; i++) {
        out->group[out->count++] = out->groups;
    }
    out->groups++;
}

/* The determinant itself, turned on from an angle by small ones. */
DHGEN_FN void dhgen_determinant_near(
    const double *E, double c, double s, const double angle[8], double f[8])
{
    for (int k = 0; k < 8; k += DHGEN_GENERAL_LANES) {
        dhgen_lane cosine = dhgen_lane_all(c), sine = dhgen_lane_all(s), factor[6][6];
        dhgen_turn_slightly(DHGEN_LOAD_SOME(angle + k, 8 - k), &cosine, &sine);
        DHGEN_SPREAD(f + k, dhgen_determinant(E, cosine, sine, factor), 8 - k);
    }
}

/* The roots in brackets, by the line between their ends; an end that is kept twice has its value
 * halved. */
DHGEN_FN void dhgen_close_brackets(
    const double *E, double c, double s, double x[2][8], double f[2][8], double root[8])
{
    double value[8] DHGEN_ALIGNED;
    int moved[8] = { -1, -1, -1, -1, -1, -1, -1, -1 };
    for (int step = 0; step < DHGEN_BRACKET_STEPS; step++) {
        for (int k = 0; k < 8; k++) {
            const double part = f[0][k] / (f[0][k] - f[1][k]);
            root[k] = x[0][k] + (part > 0.0 && part < 1.0 ? part : 0.5) * (x[1][k] - x[0][k]);
        }
        dhgen_determinant_near(E, c, s, root, value);
        for (int k = 0; k < 8; k++) {
            const int end = (value[k] < 0.0) != (f[0][k] < 0.0);
            x[end][k] = root[k];
            f[end][k] = value[k];
            f[!end][k] *= moved[k] == end ? 0.5 : 1.0;
            moved[k] = end;
        }
    }
}

/* Adds a bracket wherever neighbouring values have unlike signs; returns how many there are. */
DHGEN_FN int dhgen_add_brackets(
    const double x[8], const double f[8], double ends[2][8], double values[2][8], int count)
{
    for (int k = 0; k < 7 && count < 8; k++) {
        if ((f[k] < 0.0) != (f[k + 1] < 0.0)) {
            for (int end = 0; end < 2; end++) {
                ends[end][count] = x[k + end];
                values[end][count] = f[k + end];
            }
            count++;
        }
    }
    return count;
}

/* Of eight values the one nearest to zero whose neighbours are farther from it on the same side; 0
 * where there is none. */
DHGEN_FN int dhgen_turning_back(const double f[8])
{
    int least = 0;
    for (int k = 1; k < 7; k++) {
        const double size = fabs(f[k]), before = f[k] < 0.0 ? -f[k - 1] : f[k - 1],
                     behind = f[k] < 0.0 ? -f[k + 1] : f[k + 1];
        if (size <= before && size <= behind && (!least || size < fabs(f[least]))) {
            least = k;
        }
    }
    return least;
}

/* Simple roots beside a place where roots may have met, if there are: the determinant itself has
 * digits there that its fit lacks, and between values of unlike signs there is a root. Where it
 * turns back, between values that are alike, the next ones are taken about where a parabola has its
 * roots, or turns. Returns how many there are. */
DHGEN_FN int dhgen_separate(const double *E, double c, double s, dhgen_roots *out)
{
    double x[8] DHGEN_ALIGNED, f[8] DHGEN_ALIGNED, root[8] DHGEN_ALIGNED;
    double ends[2][8] = { { 0.0 } }, values[2][8] = { { 0.0 } };
    int count = 0, known = 0;
    for (int k = 0; k < 8; k++) {
        x[k] = DHGEN_BESIDE * (2 * k - 7) / 7.0;
    }
    for (int round = 0; round < DHGEN_PARABOLAS && count == known; round++) {
        dhgen_determinant_near(E, c, s, x, f);
        count = dhgen_add_brackets(x, f, ends, values, count);
        known = round ? known : count;
        const int least = dhgen_turning_back(f);
        const double low = x[least ? least - 1 : 0], high = x[least + 1];
        if (!least || !(low < x[least] && x[least] < high)) {
            break;
        }
        const double a = (f[least] - f[least - 1]) / (x[least] - low),
                     b = (f[least + 1] - f[least]) / (high - x[least]);
        const double bend = (b - a) / (high - low), slope = a + bend * (x[least] - low);
        if (!(fabs(bend) > 0.0)) {
            break;
        }
        const double square = slope * slope - 4.0 * bend * f[least];
        const double middle = x[least] - 0.5 * slope / bend;
        double reach = 0.75 * fmin(middle - low, high - middle);
        if (square > 0.0) {
            reach = fmin(reach, sqrt(square) / fabs(bend));
        }
        x[0] = low;
        x[7] = high;
        for (int k = 1; k < 7; k++) {
            x[k] = middle + reach * (2 * k - 7) / 5.0;
        }
    }
    if (count) {
        dhgen_close_brackets(E, c, s, ends, values, root);
    }
    count = count < DHGEN_ROOTS - out->simple ? count : DHGEN_ROOTS - out->simple;
    for (int k = 0; k < count; k++) {
        out->c[out->simple] = c * cos(root[k]) - s * sin(root[k]);
        out->s[out->simple++] = s * cos(root[k]) + c * sin(root[k]);
    }
    return count;
}

/* Adds a candidate while there is room. */
DHGEN_FN void dhgen_add_candidate(dhgen_candidates *out, double c, double s, const double n[6])
{
    if (out->count == DHGEN_CANDIDATES) {
        return;
    }
    out->group[out->count] = out->groups;
    out->c[out->count] = c;
    out->s[out->count] = s;
    for (int i = 0; i < 6; i++) {
        out->n[i][out->count] = n[i];
    }
    out->count++;
}

/* Vectors w of the plane with up w = x down w for some x (least squares): their sums of the two
 * null vectors become candidates. The shift's rows are n[up[i]] and n[down[i]]. */
DHGEN_FN void dhgen_split_plane(double n[2][6], int rows, const int *up, const int *down, double c,
    double s, dhgen_candidates *out)
{
    double A[2][2] = { { 0.0 } }, G[2][2] = { { 0.0 } }, H[2][2] = { { 0.0 } };
    double M[2][2], det, det_h, half, spread;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            for (int k = 0; k < rows; k++) {
                A[i][j] += n[i][down[k]] * n[j][up[k]];
                G[i][j] += n[i][down[k]] * n[j][down[k]];
                H[i][j] += n[i][up[k]] * n[j][up[k]];
            }
        }
    }
    det = G[0][0] * G[1][1] - G[0][1] * G[0][1];
    det_h = H[0][0] * H[1][1] - H[0][1] * H[0][1];
    if (det < det_h) { /* 1/x is the better unknown */
        const double swap = A[0][1];
        A[0][1] = A[1][0];
        A[1][0] = swap;
        det = det_h;
        G[0][0] = H[0][0];
        G[0][1] = H[0][1];
        G[1][1] = H[1][1];
    }
    if (det < DHGEN_PLANE) {
        return;
    }
    for (int j = 0; j < 2; j++) {
        M[0][j] = (G[1][1] * A[0][j] - G[0][1] * A[1][j]) / det;
        M[1][j] = (G[0][0] * A[1][j] - G[0][1] * A[0][j]) / det;
    }
    half = 0.5 * (M[0][0] - M[1][1]);
    spread = half * half + M[0][1] * M[1][0];
    spread = spread > 0.0 ? sqrt(spread) : 0.0;
    for (int sign = -1; sign <= 1; sign += 2) {
        /* (M - x) w = 0 from the longer of its rows */
        const double x = 0.5 * (M[0][0] + M[1][1]) + sign * spread;
        const double a = M[0][0] - x, d = M[1][1] - x;
        const int upper = fabs(a) + fabs(M[0][1]) > fabs(d) + fabs(M[1][0]);
        const double w0 = upper ? M[0][1] : d, w1 = upper ? -a : -M[1][0];
        double sum[6];
        for (int i = 0; i < 6; i++) {
            sum[i] = w0 * n[0][i] + w1 * n[1][i];
        }
        dhgen_add_candidate(out, c, s, sum);
    }
}

/* Two vectors, orthogonal, at which a factor is smallest. Returns 1 where it is regular, with no
 * singular value that is next to nothing and not two small ones, else 0. */
DHGEN_INLINE dhgen_lane dhgen_smallest_vectors(dhgen_lane factor[6][6], dhgen_lane x[2][6])
{
    dhgen_lane inverse[6], length, second, squares = { 0 };
    dhgen_reciprocals(factor, inverse);
    for (int i = 0; i < 6; i++) {
        x[0][i] = dhgen_lane_all(dhgen_starts[0][i]);
        x[1][i] = dhgen_lane_all(dhgen_starts[1][i]);
        for (int j = i; j < 6; j++) {
            squares += factor[i][j] * factor[i][j];
        }
    }
    for (int step = 0; step < 4; step++) {
        dhgen_lane along = { 0 };
        length = dhgen_inverse_iteration(factor, inverse, x[0]);
        second = dhgen_inverse_iteration(factor, inverse, x[1]);
        for (int i = 0; i < 6; i++) {
            along += x[0][i] * x[1][i];
        }
        for (int i = 0; i < 6; i++) {
            x[1][i] -= along * x[0][i];
        }
    }
    return dhgen_lane_select((length * squares < DHGEN_REGULAR) & (second * squares < DHGEN_ALONE),
        dhgen_lane_all(1.0), dhgen_lane_all(0.0));
}

/* Candidates where two roots may have met: the null space may be a plane, which is split where one
 * of the two shifts, x3 or x2, has an eigenvalue. */
DHGEN_FN void dhgen_null_plane(const double *E, double c, double s, dhgen_candidates *out)
{
    dhgen_lane factor[6][6], x[2][6];
    double n[2][6];
    if (out->groups == DHGEN_CANDIDATES) {
        return;
    }
    (void)dhgen_determinant(E, dhgen_lane_all(c), dhgen_lane_all(s), factor);
    out->regular[out->groups] = dhgen_lane_largest(dhgen_smallest_vectors(factor, x)) > 0.0
        && dhgen_lane_largest(dhgen_independence(E, dhgen_lane_all(c), dhgen_lane_all(s)))
            > DHGEN_INDEPENDENT;
    for (int r = 0; r < 2; r++) {
        double square = 0.0;
        for (int i = 0; i < 6; i++) {
            n[r][i] = dhgen_lane_largest(x[r][i]);
            square += n[r][i] * n[r][i];
        }
        square = sqrt(square) + DHGEN_TINY;
        for (int i = 0; i < 6; i++) {
            n[r][i] /= square;
        }
    }
    dhgen_add_candidate(out, c, s, n[0]);
    dhgen_split_plane(n, 3, dhgen_up_3, dhgen_down_3, c, s, out);
    dhgen_split_plane(n, 4, dhgen_up_2, dhgen_down_2, c, s, out);
    out->groups++;
}

#endif
