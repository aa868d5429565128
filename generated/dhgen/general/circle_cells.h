/* SPDX-License-Identifier: MIT
 *
 * The roots of a trigonometric polynomial, cell by cell. */
#ifndef DHGEN_GENERAL_CIRCLE_CELLS_H
#define DHGEN_GENERAL_CIRCLE_CELLS_H

#include "circle_parts.h"

/* How often a cell is halved before its roots count as one of higher multiplicity. */
#define DHGEN_DEEPEST 14
/* Parts of a cell that wait at most to be halved. */
#define DHGEN_OPEN_CELLS 16
/* Halvings of all cells together: f may be next to nothing for long stretches. */
#define DHGEN_CELL_HALVINGS 100
/* The quintic through f, f', f'' at both ends of a cell misses f by at most WIDTH^6 8^6 / 46080
 * = 1.3e-9 of its largest value. */
#define DHGEN_QUINTIC 2e-09
/* The cubic through f and f' at both ends differs from the quintic in Bernstein coefficients by at
 * most WIDTH^4 8^4 / 240 = 6e-6: cells that it excludes have no root, nor one that is lifted
 * off. */
#define DHGEN_CUBIC 2e-05

/* What is known about f in a part of the circle. */
enum { DHGEN_ROOTLESS, DHGEN_FLAT, DHGEN_TAME, DHGEN_WILD };

/* Classifies parts: rootless; flat, nothing but rounding; tame, with one extremum at most; or none
 * of these. The Bernstein coefficients of the quintic through f, f', f'' at both ends and their
 * differences bound f, f' and f''. */
DHGEN_INLINE void dhgen_classify_lanes(
    const dhgen_trigonometric *f, const dhgen_spans *part, int kind[DHGEN_GENERAL_LANES])
{
    const dhgen_lane h = part->width, d0 = h * part->low[1] * 0.2, d1 = h * part->high[1] * 0.2;
    const dhgen_lane s0 = h * h * part->low[2] * 0.05, s1 = h * h * part->high[2] * 0.05;
    const dhgen_lane share = h * (1.0 / DHGEN_WIDTH), square = share * share;
    const dhgen_lane doubt = f->rounding + f->scale * DHGEN_QUINTIC * square * square * square;
    const dhgen_lane b[6] = { part->low[0], part->low[0] + d0, part->low[0] + 2.0 * d0 + s0,
        part->high[0] - 2.0 * d1 + s1, part->high[0] - d1, part->high[0] };
    dhgen_lane least[3], most[3];
    DHGEN_ROWS_IN_ROOM(bounds, 5, DHGEN_BOARD(0));
    least[0] = dhgen_lane_min(b[0], b[5]);
    most[0] = dhgen_lane_max(b[0], b[5]);
    least[1] = most[1] = b[1] - b[0];
    least[2] = most[2] = b[2] - b[1] - least[1];
    for (int i = 1; i < 5; i++) {
        const dhgen_lane first = b[i + 1] - b[i], second = first - (b[i] - b[i - 1]);
        least[0] = dhgen_lane_min(least[0], b[i]);
        most[0] = dhgen_lane_max(most[0], b[i]);
        least[1] = dhgen_lane_min(least[1], first);
        most[1] = dhgen_lane_max(most[1], first);
        least[2] = dhgen_lane_min(least[2], second);
        most[2] = dhgen_lane_max(most[2], second);
    }
    /* rounding of f' and f'' shrinks with the width, down to that of the quintic's ends */
    DHGEN_STORE(bounds[0], least[0]);
    DHGEN_STORE(bounds[1], most[0]);
    DHGEN_STORE(bounds[2], dhgen_lane_max(least[1], -most[1]) - doubt * share);
    DHGEN_STORE(bounds[3], dhgen_lane_max(least[2], -most[2]) - doubt * square);
    DHGEN_STORE(bounds[4], dhgen_lane_max(doubt, dhgen_lane_all(f->touching)));
    for (int k = DHGEN_FIRST_LANE; k < DHGEN_END_LANE; k++) {
        if (bounds[0][k] > bounds[4][k] || bounds[1][k] < -bounds[4][k]) {
            kind[k] = DHGEN_ROOTLESS;
        } else if (bounds[0][k] >= -f->rounding && bounds[1][k] <= f->rounding) {
            kind[k] = DHGEN_FLAT;
        } else {
            kind[k] = bounds[2][k] > 0.0 || bounds[3][k] > 0.0 ? DHGEN_TAME : DHGEN_WILD;
        }
    }
    DHGEN_MEET();
}

/* What is known about f in one part. */
DHGEN_FN int dhgen_classify(
    const dhgen_trigonometric *f, const double low[3], const double high[3], double h)
{
    dhgen_spans part;
    DHGEN_KINDS_IN_ROOM(kind, DHGEN_BOARD(5));
    part.width = dhgen_lane_all(h);
    for (int i = 0; i < 3; i++) {
        part.low[i] = dhgen_lane_all(low[i]);
        part.high[i] = dhgen_lane_all(high[i]);
    }
    dhgen_classify_lanes(f, &part, kind);
    return kind[0];
}

/* The roots of a cell where f may turn more than once: halve it until it does not. A part that is
 * given up puts both its ends among the double roots: a closer look that shows one of them need not
 * reach to the other. */
DHGEN_FN void dhgen_halve_cell(const dhgen_trigonometric *f, double low, double c, double s,
    const double first[3], const double last[3], int *budget, dhgen_waiting *waiting,
    dhgen_roots *roots)
{
    /* the upper edges still to come */
    double edge[DHGEN_OPEN_CELLS], edge_c[DHGEN_OPEN_CELLS], edge_s[DHGEN_OPEN_CELLS],
        at[DHGEN_OPEN_CELLS][3];
    double at_low[3];
    int depth[DHGEN_OPEN_CELLS], open = 1;
    edge[0] = low + DHGEN_WIDTH;
    edge_c[0] = edge_s[0] = 0.0; /* nothing begins there */
    depth[0] = 0;
    for (int i = 0; i < 3; i++) {
        at_low[i] = first[i];
        at[0][i] = last[i];
    }
    while (open > 0) {
        const int top = open - 1;
        const double h = edge[top] - low;
        const int kind = dhgen_classify(f, at_low, at[top], h);
        if (kind == DHGEN_TAME) {
            dhgen_enqueue_part(f, c, s, h, at_low, at[top], waiting, roots);
        } else if (kind != DHGEN_ROOTLESS) {
            if (kind == DHGEN_FLAT || depth[top] == DHGEN_DEEPEST || *budget == 0) {
                dhgen_solve_parts(
                    f, waiting, roots); /* of neighbouring double roots the first is kept */
                roots->complete = 0;
                dhgen_add_double(roots, c, s);
                dhgen_add_double(roots, cos(edge[top]), sin(edge[top]));
            } else {
                const double middle = low + 0.5 * h, cosine = cos(middle), sine = sin(middle);
                *budget -= 1;
                edge[open] = middle;
                edge_c[open] = cosine;
                edge_s[open] = sine;
                depth[top] += 1;
                depth[open] = depth[top];
                dhgen_evaluate(f, cosine, sine, at[open]);
                open++;
                continue;
            }
        }
        low = edge[top];
        c = edge_c[top];
        s = edge_s[top];
        for (int i = 0; i < 3; i++) {
            at_low[i] = at[top][i];
        }
        open--;
    }
}

/* Cosine and sine of the angle where a cell begins. */
DHGEN_FN void dhgen_cell_edge(int cell, double *c, double *s)
{
    const int half = cell % DHGEN_HALF_CELLS;
    *c = cell < DHGEN_HALF_CELLS ? dhgen_grid_c[0][half] : -dhgen_grid_c[0][half];
    *s = cell < DHGEN_HALF_CELLS ? dhgen_grid_s[0][half] : -dhgen_grid_s[0][half];
}

/* The number of the lowest bit that is set. */
DHGEN_FN int dhgen_lowest_bit(unsigned long long bits)
{
#if defined(__CUDA_ARCH__)
    return __ffsll((long long)bits) - 1;
#elif defined(__GNUC__)
    return __builtin_ctzll(bits);
#else
    int i = 0;
    while (!(bits >> i & 1)) {
        i++;
    }
    return i;
#endif
}

/* The roots of some cells that are open. */
DHGEN_FN void dhgen_search_cells(const dhgen_trigonometric *f, const dhgen_grid *g, const int *cell,
    int count, int *budget, dhgen_waiting *waiting, dhgen_roots *roots)
{
    const double h = DHGEN_WIDTH;
    DHGEN_ROWS_IN_ROOM(in, 8, DHGEN_CELL_BOARD(0));
    DHGEN_ROWS_IN_ROOM(bend, 2, DHGEN_CELL_BOARD(8));
    DHGEN_KINDS_IN_ROOM(kind, DHGEN_CELL_BOARD(10));
    dhgen_spans part;
    for (int k = DHGEN_FIRST_LANE; k < DHGEN_END_LANE; k++) {
        const int i = cell[k < count ? k : 0];
        in[0][k] = g->value[i];
        in[1][k] = g->slope[i];
        in[2][k] = g->value[i + 1];
        in[3][k] = g->slope[i + 1];
        dhgen_cell_edge(i, &in[4][k], &in[5][k]);
        dhgen_cell_edge((i + 1) % DHGEN_CELLS, &in[6][k], &in[7][k]);
    }
    DHGEN_MEET();
    part.width = dhgen_lane_all(h);
    for (int end = 0; end < 2; end++) {
        dhgen_lane at[3], *const to = end ? part.high : part.low;
        dhgen_evaluate_lanes(f, DHGEN_LOAD(in[4 + 2 * end]), DHGEN_LOAD(in[5 + 2 * end]), at);
        /* the edges' own values, so that neighbouring cells agree about their signs */
        to[0] = DHGEN_LOAD(in[2 * end]);
        to[1] = DHGEN_LOAD(in[2 * end + 1]);
        to[2] = at[2];
        DHGEN_STORE(bend[end], at[2]);
    }
    dhgen_classify_lanes(f, &part, kind);
    for (int k = 0; k < count; k++) {
        const double low[3] = { in[0][k], in[1][k], bend[0][k] };
        const double high[3] = { in[2][k], in[3][k], bend[1][k] };
        if (kind[k] == DHGEN_TAME) {
            dhgen_enqueue_part(f, in[4][k], in[5][k], h, low, high, waiting, roots);
        } else if (kind[k] != DHGEN_ROOTLESS) {
            dhgen_halve_cell(f, cell[k] * h, in[4][k], in[5][k], low, high, budget, waiting, roots);
        }
    }
}

/* The roots of f in a window of the circle. */
DHGEN_FN void dhgen_find_roots(
    const dhgen_trigonometric *f, const dhgen_window *window, dhgen_roots *roots)
{
    dhgen_grid g;
    dhgen_waiting waiting;
    int open[DHGEN_CELLS], count = 0;
    int budget = DHGEN_CELL_HALVINGS; /* against an f that is next to nothing for long stretches */
    DHGEN_PLACE_GRID(&g);
    DHGEN_PLACE_PARTS(&waiting.turning, DHGEN_ROOM_TURNING, DHGEN_WAITING);
    DHGEN_PLACE_PARTS(&waiting.crossing, DHGEN_ROOM_CROSSING, DHGEN_PARTS);
    dhgen_fill_grid(f, &g);
    roots->simple = roots->doubles = roots->unseen = roots->lifted = 0;
    roots->complete = 1;
    for (int word = 0; word < DHGEN_CELLS / 64; word++) {
        unsigned long long bits =
            dhgen_open_cells(&g, 64 * word, f->rounding + f->scale * DHGEN_CUBIC);
        for (; bits; bits &= bits - 1) {
            const int i = 64 * word + dhgen_lowest_bit(bits);
            const int away = i > window->middle ? i - window->middle : window->middle - i;
            if (away <= window->reach || DHGEN_CELLS - away <= window->reach) {
                open[count++] = i;
            }
        }
    }
    waiting.lifted = window->lifted;
    waiting.turning.count = waiting.crossing.count = 0;
    for (int k = 0; k < count; k += DHGEN_GENERAL_LANES) {
        dhgen_search_cells(f, &g, open + k,
            count - k < DHGEN_GENERAL_LANES ? count - k : DHGEN_GENERAL_LANES, &budget, &waiting,
            roots);
    }
    dhgen_solve_parts(f, &waiting, roots);
}

#endif
