/* SPDX-License-Identifier: MIT
 *
 * Roots and extrema of a trigonometric polynomial in parts of the circle. */
#ifndef DHGEN_GENERAL_CIRCLE_PARTS_H
#define DHGEN_GENERAL_CIRCLE_PARTS_H

#include "circle.h"

/* Parts of the circle that wait at most to be solved together, twice as many as there are lanes at
 * most, and with the two halves of as many others. */
#define DHGEN_WAITING 16
#define DHGEN_PARTS 48
/* Steps on a quintic from a start that is nearly right; the function itself corrects the rest. */
#define DHGEN_QUINTIC_STEPS 4
/* Steps on the function itself, at most. */
#define DHGEN_CAREFUL_STEPS 48
/* The step after one of this size is rounding [rad]. */
#define DHGEN_SETTLED 1e-09
/* The step after one of this size is rounding where f turns, and with it the value there by a
 * parabola [rad]. */
#define DHGEN_SETTLED_EXTREMUM 1e-07

/* Parts of the circle: cosine and sine where each begins, its width, f, f', f'' at both ends, and
 * about where what is looked for lies, in parts of the width. */
typedef struct {
    int count;
    DHGEN_MEMBER(c, DHGEN_PARTS);
    DHGEN_MEMBER(s, DHGEN_PARTS);
    DHGEN_MEMBER(width, DHGEN_PARTS);
    DHGEN_MEMBER(start, DHGEN_PARTS);
    DHGEN_MEMBER_ROWS(low, 3, DHGEN_PARTS);
    DHGEN_MEMBER_ROWS(high, 3, DHGEN_PARTS);
} dhgen_parts;

/* Parts where f turns once, and parts where it rises or falls throughout and has a root. */
typedef struct {
    double lifted; /* as of the window */
    dhgen_parts turning, crossing;
} dhgen_waiting;

/* Adds a part. */
DHGEN_FN void dhgen_add_part(dhgen_parts *parts, double c, double s, double width,
    const double low[3], const double high[3], double start)
{
    const int n = parts->count++;
    parts->c[n] = c;
    parts->s[n] = s;
    parts->width[n] = width;
    parts->start[n] = start;
    for (int i = 0; i < 3; i++) {
        parts->low[i][n] = low[i];
        parts->high[i][n] = high[i];
    }
}

/* Parts as they lie in lanes. */
typedef struct {
    dhgen_lane c, s, width, start, low[3], high[3];
} dhgen_spans;

/* Parts from one on, in lanes; behind the last one it comes again. */
DHGEN_FN void dhgen_load_parts(dhgen_parts *parts, int from, dhgen_spans *out)
{
    const int last = parts->count - 1, left = parts->count - from;
    while (DHGEN_LANES_BEHIND && parts->count < from + DHGEN_GENERAL_LANES) {
        const double low[3] = { parts->low[0][last], parts->low[1][last], parts->low[2][last] };
        const double high[3] = { parts->high[0][last], parts->high[1][last], parts->high[2][last] };
        dhgen_add_part(parts, parts->c[last], parts->s[last], parts->width[last], low, high,
            parts->start[last]);
    }
    parts->count = last + 1;
    out->c = DHGEN_LOAD_SOME(parts->c + from, left);
    out->s = DHGEN_LOAD_SOME(parts->s + from, left);
    out->width = DHGEN_LOAD_SOME(parts->width + from, left);
    out->start = DHGEN_LOAD_SOME(parts->start + from, left);
    for (int i = 0; i < 3; i++) {
        out->low[i] = DHGEN_LOAD_SOME(parts->low[i] + from, left);
        out->high[i] = DHGEN_LOAD_SOME(parts->high[i] + from, left);
    }
}

/* Where the quintic through f, f', f'' at both ends vanishes (order 0), or its derivative (order
 * 1), in parts of the width. */
DHGEN_INLINE dhgen_lane dhgen_root_of_quintic(int order, const dhgen_spans *part)
{
    const dhgen_lane h = part->width, d = h * part->low[1], s = h * h * part->low[2];
    const dhgen_lane D = part->high[0] - part->low[0] - d - 0.5 * s;
    const dhgen_lane D1 = h * part->high[1] - d - s, D2 = h * h * part->high[2] - s;
    const dhgen_lane c3 = 10.0 * D - 4.0 * D1 + 0.5 * D2, c4 = 7.0 * D1 - 15.0 * D - D2;
    const dhgen_lane c5 = 6.0 * D - 3.0 * D1 + 0.5 * D2;
    const dhgen_mask rising = part->low[order] < 0.0;
    dhgen_lane x = part->start, from = dhgen_lane_all(0.0), to = dhgen_lane_all(1.0);
    for (int i = 0; i < DHGEN_QUINTIC_STEPS; i++) {
        const dhgen_lane f = part->low[0] + x * (d + x * (0.5 * s + x * (c3 + x * (c4 + x * c5))));
        const dhgen_lane f1 = d + x * (s + x * (3.0 * c3 + x * (4.0 * c4 + x * (5.0 * c5))));
        const dhgen_lane f2 = s + x * (6.0 * c3 + x * (12.0 * c4 + x * (20.0 * c5)));
        const dhgen_lane value = order ? f1 : f, slope = order ? f2 : f1;
        const dhgen_mask before = (value < 0.0) == rising;
        from = dhgen_lane_select(before, x, from);
        to = dhgen_lane_select(before, to, x);
        x -= value / slope;
        x = dhgen_lane_select((x >= from) & (x <= to), x, 0.5 * (from + to));
    }
    return x;
}

/* f, f', f'' at angles, by their cosines and sines. */
DHGEN_INLINE void dhgen_evaluate_lanes(
    const dhgen_trigonometric *f, dhgen_lane cosine, dhgen_lane sine, dhgen_lane out[3])
{
    dhgen_lane c[9], s[9];
    c[1] = cosine;
    s[1] = sine;
    out[0] = dhgen_lane_all(f->a[0]);
    out[1] = out[2] = dhgen_lane_all(0.0);
    for (int m = 1; m < 9; m++) {
        const int less = m / 2, more = m - m / 2;
        if (less) {
            c[m] = c[less] * c[more] - s[less] * s[more];
            s[m] = s[less] * c[more] + c[less] * s[more];
        }
        const dhgen_lane even = f->a[m] * c[m] + f->b[m] * s[m],
                         odd = f->b[m] * c[m] - f->a[m] * s[m];
        out[0] += even;
        out[1] += m * odd;
        out[2] -= m * m * even;
    }
}

/* Turns a cosine and a sine on by a small angle, no larger than a cell. */
DHGEN_INLINE void dhgen_turn_slightly(dhgen_lane x, dhgen_lane *c, dhgen_lane *s)
{
    const dhgen_lane u = x * x, c0 = *c, s0 = *s;
    const dhgen_lane dc = 1.0 - u * (0.5 - u * (1.0 / 24.0 - u * (1.0 / 720.0)));
    const dhgen_lane ds = x * (1.0 - u * (1.0 / 6.0 - u * (1.0 / 120.0 - u * (1.0 / 5040.0))));
    *c = c0 * dc - s0 * ds;
    *s = s0 * dc + c0 * ds;
}

/* Where f (order 0) or f' (order 1) vanishes: by Newton's method from the root of the quintic, with
 * bisection where that leaves the interval. Returns how far that is from where each part begins,
 * with cosine and sine, and f, f', f'' there, as far as an extremum is concerned. */
DHGEN_INLINE dhgen_lane dhgen_root_between(const dhgen_trigonometric *f, int order, double settled,
    const dhgen_spans *part, dhgen_lane *c, dhgen_lane *s, dhgen_lane at[3])
{
    const dhgen_mask rising = part->low[order] < 0.0;
    dhgen_lane from = dhgen_lane_all(0.0), to = part->width,
               x = part->width * dhgen_root_of_quintic(order, part);
    dhgen_lane step = part->width;
    for (int i = 0; i < DHGEN_CAREFUL_STEPS; i++) {
        const dhgen_mask moving = dhgen_lane_abs(step) >= settled;
        if (i && dhgen_lane_largest(dhgen_lane_abs(step)) < settled) {
            break;
        }
        *c = part->c;
        *s = part->s;
        dhgen_turn_slightly(x, c, s);
        dhgen_evaluate_lanes(f, *c, *s, at);
        const dhgen_mask before = (at[order] < 0.0) == rising;
        from = dhgen_lane_select(before, x, from);
        to = dhgen_lane_select(before, to, x);
        step = -at[order] / at[order + 1];
        step =
            dhgen_lane_select((x + step >= from) & (x + step <= to), step, 0.5 * (from + to) - x);
        step = dhgen_lane_select(moving, step, dhgen_lane_all(0.0));
        x += step;
    }
    dhgen_turn_slightly(step, c, s);
    at[0] += 0.5 * step * at[1]; /* what a parabola gains where its slope vanishes */
    return x;
}

/* The double root, or the parts with a root, of a part of the circle whose extremum is known. */
DHGEN_FN void dhgen_split_at_extremum(const dhgen_trigonometric *f, const dhgen_parts *parts, int i,
    double x, double c, double s, const double at[3], dhgen_waiting *waiting, dhgen_roots *roots)
{
    const double bend = fabs(at[2]) * waiting->lifted,
                 near = bend > f->touching ? bend : f->touching;
    const double beside = fabs(at[0]);
    const double low[3] = { parts->low[0][i], parts->low[1][i], parts->low[2][i] };
    const double high[3] = { parts->high[0][i], parts->high[1][i], parts->high[2][i] };
    if (beside <= f->rounding) {
        dhgen_add_double(roots, c, s);
        return;
    }
    if (at[0] * at[2] > 0.0 && beside <= near) {
        dhgen_add_lifted(roots, c, s);
        return;
    }
    /* where a parabola with its summit at the extremum has its roots */
    if ((low[0] < 0.0) != (at[0] < 0.0)) {
        dhgen_add_part(&waiting->crossing, parts->c[i], parts->s[i], x, low, at,
            1.0 - sqrt(at[0] / (at[0] - low[0])));
    }
    if ((high[0] < 0.0) != (at[0] < 0.0)) {
        dhgen_add_part(&waiting->crossing, c, s, parts->width[i] - x, at, high,
            sqrt(at[0] / (at[0] - high[0])));
    }
}

/* The roots of all parts that wait. */
DHGEN_FN void dhgen_solve_parts(
    const dhgen_trigonometric *f, dhgen_waiting *waiting, dhgen_roots *roots)
{
    dhgen_parts *const bent = &waiting->turning, *const crossing = &waiting->crossing;
    DHGEN_LANES_IN_ROOM(x, DHGEN_BOARD(0));
    DHGEN_LANES_IN_ROOM(c, DHGEN_BOARD(1));
    DHGEN_LANES_IN_ROOM(s, DHGEN_BOARD(2));
    DHGEN_ROWS_IN_ROOM(value, 3, DHGEN_BOARD(3));
    dhgen_spans part;
    dhgen_lane cosine, sine, at[3];
    for (int from = 0; from < bent->count; from += DHGEN_GENERAL_LANES) {
        dhgen_load_parts(bent, from, &part);
        DHGEN_STORE(x, dhgen_root_between(f, 1, DHGEN_SETTLED_EXTREMUM, &part, &cosine, &sine, at));
        DHGEN_STORE(c, cosine);
        DHGEN_STORE(s, sine);
        for (int i = 0; i < 3; i++) {
            DHGEN_STORE(value[i], at[i]);
        }
        for (int k = 0; k < DHGEN_GENERAL_LANES && from + k < bent->count; k++) {
            const double extremum[3] = { value[0][k], 0.0, value[2][k] };
            dhgen_split_at_extremum(f, bent, from + k, x[k], c[k], s[k], extremum, waiting, roots);
        }
    }
    for (int from = 0; from < crossing->count; from += DHGEN_GENERAL_LANES) {
        dhgen_load_parts(crossing, from, &part);
        (void)dhgen_root_between(f, 0, DHGEN_SETTLED, &part, &cosine, &sine, at);
        DHGEN_STORE(c, cosine);
        DHGEN_STORE(s, sine);
        for (int k = 0; k < DHGEN_GENERAL_LANES && from + k < crossing->count; k++) {
            dhgen_add_simple(roots, c[k], s[k]);
        }
    }
    DHGEN_MEET(); /* the next part takes the place of the first one */
    bent->count = crossing->count = 0;
}

/* A part where f has one extremum at most waits for others, to be solved in lanes. */
DHGEN_FN void dhgen_enqueue_part(const dhgen_trigonometric *f, double c, double s, double width,
    const double low[3], const double high[3], dhgen_waiting *waiting, dhgen_roots *roots)
{
    if (low[1] * high[1] < 0.0) {
        dhgen_add_part(&waiting->turning, c, s, width, low, high, low[1] / (low[1] - high[1]));
    } else if ((low[0] < 0.0) != (high[0] < 0.0)) {
        dhgen_add_part(&waiting->crossing, c, s, width, low, high, low[0] / (low[0] - high[0]));
    }
    if (waiting->turning.count == DHGEN_WAITING || waiting->crossing.count == DHGEN_WAITING) {
        dhgen_solve_parts(f, waiting, roots);
    }
}

#endif
