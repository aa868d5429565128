/* SPDX-License-Identifier: MIT
 *
 * Arms of one kind, each with its own table or origins, from which its numbers are computed
 * once. */
#ifndef DHGEN_CALIBRATE_H
#define DHGEN_CALIBRATE_H

#include "serial.h"
#include "general.h"
#include "general/near.h"

/* Parallel axes leave a common slide of their frames open: this much weight on the slides closes
 * it. */
#define DHGEN_RIDGE 1e-09

/* Deviations above this are of another arm [rad, arm sizes]. */
#define DHGEN_MOST_DEVIATION 0.05
/* Three axes that miss being parallel, or meeting, by less have a closed form of their own: the
 * general algorithm has no certificate there [rad, arm sizes]. */
#define DHGEN_LEAST_MISS 1e-09
/* Numbers above this leave less than eleven digits of where links are: no calibration has
 * them [rad, arm sizes]. */
#define DHGEN_MOST_NUMBER 1e5
/* Poses are left whose rows may end within what the tools differ by, or within so many times that
 * part of it by which two links side by side differ: beside a wrist that is missed by one length a
 * row has a second solution at 0.95 of the distance. */
#define DHGEN_MARGIN_SIDE_BY_SIDE 1.5
/* What bounds of deviations are enlarged by for rounding [rad, arm sizes]. */
#define DHGEN_ROUNDED_DEVIATION 1e-10

/* The square of the sine of an angle from which axes are far from parallel. */
#define DHGEN_FAR_FROM_PARALLEL 1e-4
/* Rounds in which a frame's place on its axis and the zero of the joint before it are found: each
 * changes the other by as much as axes miss being parallel. */
#define DHGEN_FITS 3

/* What is wrong with a table, or with origins. */
enum { DHGEN_TAKEN, DHGEN_NOT_FINITE, DHGEN_ANOTHER_ARM, DHGEN_NO_MISS };

/* What calibrated arms of a kind have in common. */
typedef struct {
    int modified;                               /* the convention of tables */
    double base[12], tool[12];                  /* Z and E */
    double facing[6];                           /* how joints count */
    const double *nominal;                      /* the table of the data sheet */
    double length;                              /* the size of the arm */
    unsigned parallel, meeting;                 /* bit i: axes i, i + 1, i + 2 are so nominally */
    const struct dhgen_arm *arm;                /* without its functions */
    const struct dhgen_numerical_arm *descents; /* likewise */
    const dhgen_general_arm *general;           /* without links */
    dhgen_nearest_rows *nearest;                /* regular poses of the nominal arm, given by how
                                                   much the calibrated arm may be away */
    dhgen_solve_wide *nearest_wide;             /* rows of several poses */
    int nearest_rows;
} dhgen_kind;

/* Moves a frame along its z (or x) axis and turns it about that axis. */
DHGEN_FN void dhgen_append_screw_z(double theta, double d, double *T)
{
    dhgen_append_slide(T, d);
    dhgen_append_turn(T, cos(theta), sin(theta));
}

DHGEN_FN void dhgen_append_screw_x(double alpha, double a, double *T)
{
    const double c = cos(alpha), s = sin(alpha);
    for (int i = 0; i < 12; i += 4) {
        const double y = T[i + 1];
        T[i + 3] += T[i] * a;
        T[i + 1] = y * c + T[i + 2] * s;
        T[i + 2] = T[i + 2] * c - y * s;
    }
}

/* C0 ... C6 of a table. */
DHGEN_FN void dhgen_constants_of(
    const dhgen_kind *kind, const double *table, double (*constant)[12])
{
    for (int k = 0; k < 7; k++) {
        double *const C = constant[k];
        const int row = kind->modified ? k : k - 1;
        dhgen_copy_link(k ? dhgen_identity : kind->base, C);
        if (k)
            dhgen_append_screw_z(0.0, table[4 * (k - 1) + 1], C);
        if (row >= 0 && row < 6)
            dhgen_append_screw_x(table[4 * row + 3], table[4 * row + 2], C);
        if (k < 6)
            dhgen_append_screw_z(table[4 * k], 0.0, C);
        else
            dhgen_append(C, kind->tool);
    }
}

/* C0 ... C6 of origins: x, y, z, roll, pitch, yaw of each joint's frame in the one before, and of
 * one behind the last joint; between base and tool. */
DHGEN_FN void dhgen_constants_of_origins(
    const dhgen_kind *kind, const double *origins, double (*constant)[12])
{
    for (int k = 0; k < 7; k++) {
        const double *const at = &origins[6 * k];
        const double cr = cos(at[3]), sr = sin(at[3]), cp = cos(at[4]), sp = sin(at[4]),
                     cy = cos(at[5]), sy = sin(at[5]);
        /* Rz(yaw) Ry(pitch) Rx(roll) */
        const double origin[12] = { cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, at[0],
            sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, at[1], -sp, cp * sr, cp * cr,
            at[2] };
        dhgen_copy_link(k ? origin : kind->base, constant[k]);
        if (k == 0)
            dhgen_append(constant[k], origin);
        if (k == 6)
            dhgen_append(constant[k], kind->tool);
    }
}

/* Solves a positive definite system of six equations; the solution takes the place of b. */
DHGEN_FN void dhgen_solve_normal(double A[6][6], double b[6])
{
    for (int i = 0; i < 6; i++)
        for (int j = i + 1; j < 6; j++) {
            const double factor = A[j][i] / A[i][i];
            for (int k = i; k < 6; k++)
                A[j][k] -= factor * A[i][k];
            b[j] -= factor * b[i];
        }
    for (int i = 5; i >= 0; i--) {
        for (int k = i + 1; k < 6; k++)
            b[i] -= A[i][k] * b[k];
        b[i] /= A[i][i];
    }
}

/* How far each frame moves along its axis so that the squares of the links add up least. */
DHGEN_FN void dhgen_shifts(const dhgen_calibration *of, double shift[6])
{
    double normal[6][6] = { { 0.0 } };
    for (int i = 0; i < 6; i++) {
        normal[i][i] = DHGEN_RIDGE;
        shift[i] = 0.0;
    }
    for (int i = 0; i < 5; i++) {
        const double *const K = of->constant[i + 1];
        /* the link's vector becomes t - s z + s' z' */
        for (int k = 0; k < 3; k++) {
            const double along[2] = { k == 2 ? -1.0 : 0.0, K[4 * k + 2] };
            for (int a = 0; a < 2; a++) {
                shift[i + a] -= along[a] * K[4 * k + 3];
                for (int b = 0; b < 2; b++)
                    normal[i + a][i + b] += along[a] * along[b];
            }
        }
    }
    dhgen_solve_normal(normal, shift);
}

/* The arm as a loop of six joints with the shortest links, in arm sizes. */
DHGEN_FN void dhgen_make_loop(const dhgen_kind *kind, dhgen_calibration *of)
{
    const double(*const advance)[6] = kind->general->advance;
    double shift[6], total = 0.0, last[12];
    dhgen_shifts(of, shift);
    for (int i = 0; i < 5; i++) {
        double *const K = of->loop[i];
        dhgen_copy_link(dhgen_identity, K);
        dhgen_append_slide(K, -shift[i]);
        dhgen_append(K, of->constant[i + 1]);
        dhgen_append_slide(K, shift[i + 1]);
        dhgen_append_turn(K, advance[0][i + 1], advance[1][i + 1]);
        total += dhgen_length_of(K);
    }
    of->size = 0.5 * total;
    for (int i = 0; i < 5; i++)
        for (int k = 3; k < 12; k += 4)
            of->loop[i][k] /= of->size;
    dhgen_copy_link(of->constant[0], last);
    dhgen_append_slide(last, shift[0]);
    dhgen_append_turn(last, advance[0][0], advance[1][0]);
    dhgen_invert(last, of->loop[5]);
    dhgen_copy_link(dhgen_identity, last);
    dhgen_append_slide(last, -shift[5]);
    dhgen_append(last, of->constant[6]);
    dhgen_invert(last, of->loop[6]);
}

/* The angle of the rotation between two, by its chord, which has all digits of a small one. */
DHGEN_FN double dhgen_turned_between(const double A[12], const double B[12])
{
    double square = 0.0;
    for (int i = 0; i < 12; i++)
        square += i % 4 == 3 ? 0.0 : (A[i] - B[i]) * (A[i] - B[i]);
    return 2.0 * asin(fmin(sqrt(0.125 * square), 1.0));
}

DHGEN_FN double dhgen_moved_between(const double A[12], const double B[12])
{
    double square = 0.0;
    for (int i = 3; i < 12; i += 4)
        square += (A[i] - B[i]) * (A[i] - B[i]);
    return sqrt(square);
}

/* The angle about z by which a nominal link N is to be turned so that the axis behind it is placed
 * as behind C: from the directions of the axes if they are far from parallel, else from where they
 * are. */
DHGEN_FN double dhgen_turn_before(const double N[12], const double C[12])
{
    const int column = N[2] * N[2] + N[6] * N[6] > DHGEN_FAR_FROM_PARALLEL ? 2 : 3;
    return atan2(N[column] * C[4 + column] - N[4 + column] * C[column],
        N[column] * C[column] + N[4 + column] * C[4 + column]);
}

/* A nominal constant with other zeros of the joints at its ends, N becomes Rz(before) N Rz(behind),
 * and the frame behind C elsewhere on its axis, C becomes C Tz(along), so that the two are as near
 * to each other as these can take them. */
DHGEN_FN void dhgen_fit_constant(
    double N[12], double C[12], double *before, double *behind, double *along)
{
    double turned[12], cosine = 0.0, sine = 0.0;
    *along = *before = 0.0;
    for (int n = 0; n < DHGEN_FITS; n++) {
        double further = 0.0;
        *before = n ? dhgen_turn_before(N, C) : 0.0;
        dhgen_copy_link(dhgen_identity, turned);
        dhgen_append_turn(turned, cos(*before), sin(*before));
        dhgen_append(turned, N);
        for (int i = 0; i < 12; i += 4)
            further += C[i + 2] * (turned[i + 3] - C[i + 3]);
        dhgen_append_slide(C, further);
        *along += further;
    }
    for (int i = 0; i < 12; i += 4) {
        cosine += turned[i] * C[i] + turned[i + 1] * C[i + 1];
        sine += turned[i + 1] * C[i] - turned[i] * C[i + 1];
    }
    *behind = atan2(sine, cosine);
    dhgen_append_turn(turned, cos(*behind), sin(*behind));
    dhgen_copy_link(turned, N);
}

/* How far from the foot of the common normal on the z axis a line's own point is, and how far the
 * lines are apart; a point of the line and its direction. */
DHGEN_FN double dhgen_foot_on_axis(const double p[3], const double u[3], double *apart)
{
    const double square = u[0] * u[0] + u[1] * u[1]; /* of the normal (-u[1], u[0], 0) */
    *apart = fabs(p[1] * u[0] - p[0] * u[1]) / sqrt(square);
    return p[2] - u[2] * (p[0] * u[0] + p[1] * u[1]) / square;
}

/* How far an arm's frame on axis 1 is from where the nominal one has it, along that axis: as far as
 * the feet of the common normals with axis 2 are apart, or, where the two are parallel in one of
 * the arms, as links are. */
DHGEN_FN double dhgen_shift_of_first(const double N[12], const double C[12])
{
    const double p[3] = { N[3], N[7], N[11] }, u[3] = { N[2], N[6], N[10] };
    const double r[3] = { C[3], C[7], C[11] }, v[3] = { C[2], C[6], C[10] };
    double apart;
    if (fmin(u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]) <= DHGEN_FAR_FROM_PARALLEL)
        return C[11] - N[11];
    return dhgen_foot_on_axis(r, v, &apart) - dhgen_foot_on_axis(p, u, &apart);
}

/* The nominal arm as near to the calibrated one as other zeros of its joints, another base and
 * another tool can take it, and frames of the latter elsewhere on their axes: common normals of
 * axes that are nearly parallel may be far away. What is left between constants adds up to how far
 * the tools may be apart: a rotation counts at the length of what is behind it. */
DHGEN_FN void dhgen_find_nearest(const dhgen_kind *kind, dhgen_calibration *of)
{
    double(*const nominal)[12] = of->nominal, slid[12], length;
    double most[2] = { 0.0, 0.0 }, behind[2] = { 0.0, 0.0 };
    dhgen_constants_of(kind, kind->nominal, nominal);
    /* along axis 1 the base takes up what is missed */
    double shift = dhgen_shift_of_first(nominal[1], of->constant[1]);
    dhgen_append_slide(of->constant[0], shift);
    dhgen_invert(of->constant[0], slid);
    dhgen_compose(nominal[0], slid, of->left);
    of->more[0] = 0.0;
    for (int k = 1; k < 7; k++) {
        double before, along;
        dhgen_copy_link(dhgen_identity, slid);
        dhgen_append_slide(slid, -shift);
        dhgen_append(slid, of->constant[k]);
        if (k < 6) {
            dhgen_fit_constant(nominal[k], slid, &before, &of->more[k], &along);
            of->more[k - 1] += before;
            shift = along;
        }
        dhgen_copy_link(slid, of->constant[k]);
    }
    dhgen_invert(of->constant[6], slid);
    dhgen_compose(slid, nominal[6], of->right);
    of->turned = DHGEN_ROUNDED_DEVIATION;
    of->moved = DHGEN_ROUNDED_DEVIATION * kind->length;
    length = dhgen_length_of(nominal[6]);
    for (int k = 5; k > 0; k--) {
        const double turned = dhgen_turned_between(nominal[k], of->constant[k]);
        const double moved = dhgen_moved_between(nominal[k], of->constant[k]) + turned * length;
        of->turned += turned;
        of->moved += moved;
        most[0] = fmax(most[0], turned + behind[0]);
        most[1] = fmax(most[1], moved + behind[1]);
        behind[0] = turned;
        behind[1] = moved;
        length += dhgen_length_of(nominal[k]);
    }
    of->margin =
        fmax(1.0, DHGEN_MARGIN_SIDE_BY_SIDE * fmax(most[0] / of->turned, most[1] / of->moved));
}

/* By how much an axis misses being parallel to the next one [rad]. */
DHGEN_FN double dhgen_tilt(const double C[12])
{
    return atan2(sqrt(C[2] * C[2] + C[6] * C[6]), fabs(C[10]));
}

/* By how much the axes before and behind the one between two links miss a point of it. */
DHGEN_FN double dhgen_missed_point(const double before[12], const double behind[12])
{
    double back[12], apart[2];
    dhgen_invert(before, back);
    const double p[3] = { back[3], back[7], back[11] }, u[3] = { back[2], back[6], back[10] };
    const double r[3] = { behind[3], behind[7], behind[11] },
                 v[3] = { behind[2], behind[6], behind[10] };
    const double feet = dhgen_foot_on_axis(p, u, &apart[0]) - dhgen_foot_on_axis(r, v, &apart[1]);
    return fmax(fabs(feet), fmax(apart[0], apart[1]));
}

/* The least of what three axes miss being parallel [rad], or meeting [arm sizes], where the nominal
 * arm's are. */
DHGEN_FN double dhgen_least_miss(const dhgen_kind *kind, const dhgen_calibration *of)
{
    double least = HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        const double *const before = of->constant[i + 1], *const behind = of->constant[i + 2];
        if (kind->parallel >> i & 1u)
            least = fmin(least, fmax(dhgen_tilt(before), dhgen_tilt(behind)));
        if (kind->meeting >> i & 1u)
            least = fmin(least, dhgen_missed_point(before, behind) / kind->length);
    }
    return least;
}

/* An arm of which nothing is known: its poses are NaN, and no pose has a solution. */
DHGEN_FN void dhgen_no_arm(dhgen_calibration *of)
{
    for (int i = 0; i < 12; i++) {
        for (int k = 0; k < 7; k++)
            of->constant[k][i] = of->loop[k][i] = of->nominal[k][i] = DHGEN_NAN;
        of->left[i] = of->right[i] = DHGEN_NAN;
    }
    for (int i = 0; i < 6; i++)
        of->facing[i] = of->more[i] = DHGEN_NAN;
    of->turned = of->moved = of->size = of->margin = DHGEN_NAN;
}

/* Returns DHGEN_NOT_FINITE where one of the numbers, row by row, is not, DHGEN_ANOTHER_ARM where
 * one is larger than those of calibrations, else DHGEN_TAKEN; bit i of `lengths`: column i holds
 * lengths. */
DHGEN_FN int dhgen_fault_of_numbers(
    const dhgen_kind *kind, const double *number, int rows, int columns, unsigned lengths)
{
    int fault = DHGEN_TAKEN;
    for (int i = 0; i < rows * columns; i++) {
        const double unit = lengths >> i % columns & 1u ? kind->length : 1.0;
        if (!isfinite(number[i]))
            return DHGEN_NOT_FINITE;
        if (fabs(number[i]) > DHGEN_MOST_NUMBER * unit)
            fault = DHGEN_ANOTHER_ARM;
    }
    return fault;
}

/* Works out what an arm's constants make of it, whose numbers have a fault, or none (DHGEN_TAKEN):
 * returns that, or what is wrong with the constants. Of numbers that are not finite nothing is
 * made. */
DHGEN_FN int dhgen_work_out(const dhgen_kind *kind, int fault, dhgen_calibration *of)
{
    if (fault == DHGEN_NOT_FINITE) {
        dhgen_no_arm(of);
        return fault;
    }
    for (int i = 0; i < 6; i++)
        of->facing[i] = kind->facing[i];
    dhgen_find_nearest(kind, of);
    dhgen_make_loop(kind, of);
    if (fault != DHGEN_TAKEN)
        return fault;
    if (!(of->turned <= DHGEN_MOST_DEVIATION && of->moved <= DHGEN_MOST_DEVIATION * kind->length))
        return DHGEN_ANOTHER_ARM;
    return dhgen_least_miss(kind, of) < DHGEN_LEAST_MISS ? DHGEN_NO_MISS : DHGEN_TAKEN;
}

/* Works out what a table makes of an arm. Returns DHGEN_TAKEN, or what is wrong with it. */
DHGEN_FN int dhgen_calibrate(const dhgen_kind *kind, const double *table, dhgen_calibration *of)
{
    dhgen_constants_of(kind, table, of->constant);
    const int fault = dhgen_fault_of_numbers(kind, table, 6, 4, 0x6u); /* d and a are lengths */
    return dhgen_work_out(kind, fault, of);
}

/* Works out what origins, seven rows of six, make of an arm. Returns the like. */
DHGEN_FN int dhgen_calibrate_origins(
    const dhgen_kind *kind, const double *origins, dhgen_calibration *of)
{
    dhgen_constants_of_origins(kind, origins, of->constant);
    const int fault = dhgen_fault_of_numbers(kind, origins, 7, 6, 0x7u); /* x, y, z are lengths */
    return dhgen_work_out(kind, fault, of);
}

#endif
