/* SPDX-License-Identifier: MIT
 *
 * A trigonometric polynomial on the circle, by cells in which it may have roots. */
#ifndef DHGEN_GENERAL_CIRCLE_H
#define DHGEN_GENERAL_CIRCLE_H

#include "circle_cosines.h"
#include "circle_sines.h"
#include "circle_tables.h"

/* More than 16 roots of a kind come from rounding. */
#define DHGEN_ROOTS 24
/* Rounding of f in its largest value, at least this; more when the harmonics beyond the eighth are
 * larger. These show only part of an error that all samples share: where four roots meet, down to a
 * thirtieth. */
#define DHGEN_ROUNDING 3e-15
#define DHGEN_NOISE_FACTOR 64.0
/* Where four roots meet the bend is next to nothing, too, and rounding of the equations, which no
 * harmonic shows, lifts f by up to this part of its largest value. */
#define DHGEN_FOURFOLD 2e-09

/* A trigonometric polynomial f(x) = sum a_m cos mx + b_m sin mx, m = 0 ... 8. */
typedef struct {
    double a[9], b[9];
    double scale;    /* the largest sample */
    double noise;    /* the harmonics beyond the eighth, over scale */
    double rounding; /* how far f may be from the polynomial */
    double touching; /* how far an extremum may be lifted for roots to meet there */
} dhgen_trigonometric;

/* f and f' at the edges of the cells; the first edge comes again at the end. */
typedef struct {
    DHGEN_MEMBER(value, DHGEN_EDGES_IN_LANES) DHGEN_ALIGNED;
    DHGEN_MEMBER(slope, DHGEN_EDGES_IN_LANES) DHGEN_ALIGNED;
} dhgen_grid;

/* The roots by their cosines and sines: `simple` of them change the sign of f, `doubles` touch zero
 * within the rounding of f (two roots, none or one); then come `unseen` places where a closer look
 * shows no root. At `lifted` places f turns back beside zero: no root, unless rounding of what f is
 * made of has lifted it off. `complete`: no cell was given up. */
typedef struct {
    int simple, doubles, unseen, lifted, complete;
    double c[DHGEN_ROOTS + 8], s[DHGEN_ROOTS + 8];
    double double_c[DHGEN_ROOTS], double_s[DHGEN_ROOTS];
    double lifted_c[DHGEN_ROOTS], lifted_s[DHGEN_ROOTS];
} dhgen_roots;

/* What part of the circle is searched: the cell in its middle, how many it has on both sides, and
 * the value of a parabola over its bend where two complex roots count as a double one. */
typedef struct {
    int middle, reach;
    double lifted;
} dhgen_window;

/* The polynomial through samples. */
DHGEN_FN void dhgen_fit(const double samples[DHGEN_SAMPLES], dhgen_trigonometric *f)
{
    DHGEN_IN_ROOM(h, DHGEN_SAMPLES, DHGEN_ROOM_HARMONICS);
    dhgen_lane sum[DHGEN_SAMPLE_LANES];
    double most = 0.0, beyond = 0.0;
    DHGEN_UNROLL
    for (int j = 0; j < DHGEN_SAMPLE_LANES; j++) {
        sum[j] = dhgen_lane_all(0.0);
    }
    for (int k = 0; k < DHGEN_SAMPLES; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    for (int k = 0; k < DHGEN_SAMPLES; k++) {
        DHGEN_UNROLL
        for (int j = 0; j < DHGEN_SAMPLE_LANES; j++) {
            const int at = j * DHGEN_GENERAL_LANES;
            sum[j] += samples[k] * DHGEN_LOAD_SOME(&dhgen_harmonics[k][at], DHGEN_SAMPLES - at);
        }
    }
    DHGEN_UNROLL
    for (int j = 0; j < DHGEN_SAMPLE_LANES; j++) {
        const int at = j * DHGEN_GENERAL_LANES;
        DHGEN_STORE_SOME(h + at, sum[j], DHGEN_SAMPLES - at);
    }
    for (int j = DHGEN_HARMONICS; j < DHGEN_SAMPLES; j++) {
        beyond = fabs(h[j]) > beyond ? fabs(h[j]) : beyond;
    }
    f->a[0] = h[0];
    f->b[0] = 0.0;
    for (int m = 1; m < 9; m++) {
        f->a[m] = h[m];
        f->b[m] = h[8 + m];
    }
    f->scale = most;
    f->noise = most > 0.0 ? beyond / most : 1.0;
    f->rounding = most * (DHGEN_ROUNDING + DHGEN_NOISE_FACTOR * f->noise);
    f->touching = f->rounding + most * DHGEN_FOURFOLD;
}

/* f, f', f'' at an angle, by its cosine and sine. */
DHGEN_FN void dhgen_evaluate(
    const dhgen_trigonometric *f, double cosine, double sine, double out[3])
{
    double c = 1.0, s = 0.0;
    out[0] = out[1] = out[2] = 0.0;
    for (int m = 0; m < 9; m++) {
        const double even = f->a[m] * c + f->b[m] * s, odd = f->b[m] * c - f->a[m] * s;
        const double next = c * cosine - s * sine;
        out[0] += even;
        out[1] += m * odd;
        out[2] -= m * m * even;
        s = s * cosine + c * sine;
        c = next;
    }
}

/* f and f' at the edges of the cells. */
DHGEN_FN void dhgen_fill_grid(const dhgen_trigonometric *f, dhgen_grid *g)
{
    const double *const a = f->a, *const b = f->b;
    for (int i = 0; i < DHGEN_HALF_CELLS; i += DHGEN_GENERAL_LANES) {
        /* sums of even multiples, equal half a turn on, and of odd ones, opposite there */
        dhgen_lane even = dhgen_lane_all(a[0]), odd = dhgen_lane_all(0.0);
        dhgen_lane even_slope = odd, odd_slope = odd;
        DHGEN_UNROLL
        for (int m = 1; m < 9; m += 2) {
            const dhgen_lane c = DHGEN_LOAD(&dhgen_grid_c[m - 1][i]),
                             s = DHGEN_LOAD(&dhgen_grid_s[m - 1][i]);
            odd += a[m] * c + b[m] * s;
            odd_slope += m * b[m] * c - m * a[m] * s;
        }
        DHGEN_UNROLL
        for (int m = 2; m < 9; m += 2) {
            const dhgen_lane c = DHGEN_LOAD(&dhgen_grid_c[m - 1][i]),
                             s = DHGEN_LOAD(&dhgen_grid_s[m - 1][i]);
            even += a[m] * c + b[m] * s;
            even_slope += m * b[m] * c - m * a[m] * s;
        }
        DHGEN_STORE(&g->value[i], even + odd);
        DHGEN_STORE(&g->value[i + DHGEN_HALF_CELLS], even - odd);
        DHGEN_STORE(&g->slope[i], even_slope + odd_slope);
        DHGEN_STORE(&g->slope[i + DHGEN_HALF_CELLS], even_slope - odd_slope);
    }
    g->value[DHGEN_CELLS] = g->value[0];
    g->slope[DHGEN_CELLS] = g->slope[0];
}

/* Which of 64 cells may have roots: those where the Bernstein coefficients of the cubic through f
 * and f' at both edges are not all of the sign of the first beyond doubt. */
DHGEN_FN unsigned long long dhgen_open_cells(const dhgen_grid *g, int from, double doubt)
{
    const double third = DHGEN_WIDTH / 3.0;
    dhgen_lane_bits bits = { 0 };
    for (int i = 0; i < 64; i += DHGEN_GENERAL_LANES) {
        const dhgen_lane first = DHGEN_LOAD(&g->value[from + i]);
        const dhgen_lane f0 = dhgen_lane_abs(first) - doubt;
        const dhgen_lane f1 = dhgen_lane_facing(DHGEN_LOAD(&g->value[from + i + 1]), first) - doubt;
        const dhgen_lane d0 = dhgen_lane_facing(DHGEN_LOAD(&g->slope[from + i]), first);
        const dhgen_lane d1 = dhgen_lane_facing(DHGEN_LOAD(&g->slope[from + i + 1]), first);
        const dhgen_lane b1 = f0 + third * d0, b2 = f1 - third * d1;
        dhgen_lane_add_bits(&bits, dhgen_lane_any_negative(f0, f1, b1, b2), i);
    }
    return dhgen_lane_all_bits(bits);
}

/* Adds an angle; where there is no room the roots are not complete. */
DHGEN_FN void dhgen_add_angle(
    double c, double s, double *cosine, double *sine, int *count, int *complete)
{
    if (*count == DHGEN_ROOTS) {
        *complete = 0;
        return;
    }
    cosine[*count] = c;
    sine[*count] = s;
    *count += 1;
}

/* Adds an angle unless it is there: neighbouring cells may be given up together. */
DHGEN_FN void dhgen_add_distinct(
    double c, double s, double *cosine, double *sine, int *count, int *complete)
{
    for (int i = 0; i < *count; i++) {
        const double gap = fabs(s * cosine[i] - c * sine[i]);
        if (gap < DHGEN_WIDTH / 64.0 && c * cosine[i] + s * sine[i] > 0.0) {
            return;
        }
    }
    dhgen_add_angle(c, s, cosine, sine, count, complete);
}

/* Adds a root that changes the sign of f. */
DHGEN_FN void dhgen_add_simple(dhgen_roots *roots, double c, double s)
{
    dhgen_add_angle(c, s, roots->c, roots->s, &roots->simple, &roots->complete);
}

/* Adds a root that touches zero. */
DHGEN_FN void dhgen_add_double(dhgen_roots *roots, double c, double s)
{
    dhgen_add_distinct(c, s, roots->double_c, roots->double_s, &roots->doubles, &roots->complete);
}

/* Adds a root that is lifted off zero. */
DHGEN_FN void dhgen_add_lifted(dhgen_roots *roots, double c, double s)
{
    dhgen_add_distinct(c, s, roots->lifted_c, roots->lifted_s, &roots->lifted, &roots->complete);
}

#endif
