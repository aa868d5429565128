/* SPDX-License-Identifier: MIT
 *
 * All roots of a trigonometric polynomial that is given by samples. */
#ifndef DHGEN_GENERAL_ROOTS_H
#define DHGEN_GENERAL_ROOTS_H

#include "circle_cells.h"
#include "moebius.h"

/* Closer looks at most. */
#define DHGEN_LOOKS 4
/* How far a closer look reaches to both sides is nearly 1/16 rad; its cosine, from half the
 * tangent. */
#define DHGEN_LOOK_COSINE 0.9980487804878049
/* Double roots between 15/256 rad and that have a look of their own: what a look shows of them may
 * end in the middle of one, where two simple roots are. */
#define DHGEN_WITHIN_COSINE 0.9982848583483567
/* In its middle a map of this strength magnifies 16 times. */
#define DHGEN_STRENGTH 0.8823529411764706
/* How far a closer look reaches, in cells: 1/16 rad becomes 0.93 rad. */
#define DHGEN_REACH 38
/* An extremum beside zero may be a double root that rounding has lifted off, also that of the
 * equations behind f, which f does not show: when a complex pair is 1e-4 rad near to the circle; of
 * a closer look, 16 times as much. The value of a parabola over its bend. */
#define DHGEN_LIFTED 5e-09
#define DHGEN_LIFTED_CLOSER 1.28e-06
/* Samples that are no larger are rounding of zero, also where that is as smooth as a polynomial and
 * its harmonics don't show it; elsewhere the largest are above 1e-20, even of arms that nearly have
 * double roots at every pose. */
#define DHGEN_VANISHING 1e-26
/* Harmonics beyond the eighth above this: f vanishes identically at this pose. */
#define DHGEN_NOISE 1e-06
/* f may nearly vanish identically: a look with more noise than this does not show what there is
 * not. */
#define DHGEN_CLEAR 1e-10

/* Samples a polynomial through a Moebius map; `of` is what the polynomial is made of. */
typedef void (*dhgen_sampler)(
    const void *of, const dhgen_moebius *map, double samples[DHGEN_SAMPLES]);

/* Keeps of angles beside which there is no root, as far as f shows, those where what it is made of
 * allows one; returns how many. */
typedef int (*dhgen_keeper)(const void *of, int count, double *cosine, double *sine);

/* What f is made of, how it is sampled, and what shows that it has no root; `keep` may be 0, where
 * nothing does. */
typedef struct {
    dhgen_sampler sample;
    dhgen_keeper keep;
    const void *of;
} dhgen_source;

/* Whether two angles, by their cosines and sines, are as near as `reach`, the cosine of the angle
 * between them: that to which a closer look reaches, or shows double roots whole. */
DHGEN_FN int dhgen_is_near(double c, double s, double cosine, double sine, double reach)
{
    return c * cosine + s * sine >= reach;
}

/* Of roots those that are near to an angle, or those that are not, behind `count` that are kept. */
DHGEN_FN int dhgen_select_roots(int near, double cosine, double sine, double reach,
    const double *from_c, const double *from_s, int many, double *c, double *s, int count)
{
    for (int i = 0; i < many && count < DHGEN_ROOTS; i++) {
        if (dhgen_is_near(from_c[i], from_s[i], cosine, sine, reach) == near) {
            c[count] = from_c[i];
            s[count] = from_s[i];
            count++;
        }
    }
    return count;
}

/* Keeps of angles those where there may be a root; returns how many. */
DHGEN_FN int dhgen_keep_possible(
    const dhgen_source *source, int count, double *cosine, double *sine)
{
    return source->keep ? source->keep(source->of, count, cosine, sine) : count;
}

/* Adds the places where f turns back beside zero to the double roots where there may be any. */
DHGEN_FN void dhgen_take_lifted(const dhgen_source *source, dhgen_roots *roots)
{
    const int count = dhgen_keep_possible(source, roots->lifted, roots->lifted_c, roots->lifted_s);
    for (int i = 0; i < count; i++) {
        dhgen_add_double(roots, roots->lifted_c[i], roots->lifted_s[i]);
    }
}

/* The roots around an angle, through a map that magnifies what is there, instead of those that were
 * known. Returns 0, and leaves these, where that does not show all. */
DHGEN_FN int dhgen_magnify(
    const dhgen_source *source, double cosine, double sine, dhgen_roots *roots)
{
    const dhgen_moebius map = { DHGEN_STRENGTH * cosine, DHGEN_STRENGTH * sine };
    const double turns = atan2(sine, cosine) / DHGEN_TURN;
    const int cell = (int)(DHGEN_CELLS * (turns - floor(turns))) % DHGEN_CELLS;
    const dhgen_window window = { cell, DHGEN_REACH, DHGEN_LIFTED_CLOSER };
    double samples[DHGEN_SAMPLES];
    dhgen_trigonometric f;
    dhgen_roots found;
    source->sample(source->of, &map, samples);
    dhgen_fit(samples, &f);
    if (!(f.noise <= DHGEN_CLEAR)) {
        return 0;
    }
    dhgen_find_roots(&f, &window, &found);
    if (!found.complete) {
        return 0;
    }
    dhgen_undo_moebius(&map, found.simple, found.c, found.s);
    dhgen_undo_moebius(&map, found.doubles, found.double_c, found.double_s);
    dhgen_undo_moebius(&map, found.lifted, found.lifted_c, found.lifted_s);
    dhgen_take_lifted(source, &found);
    roots->simple = dhgen_select_roots(0, cosine, sine, DHGEN_LOOK_COSINE, roots->c, roots->s,
        roots->simple, roots->c, roots->s, 0);
    roots->doubles = dhgen_select_roots(0, cosine, sine, DHGEN_WITHIN_COSINE, roots->double_c,
        roots->double_s, roots->doubles, roots->double_c, roots->double_s, 0);
    roots->simple = dhgen_select_roots(1, cosine, sine, DHGEN_LOOK_COSINE, found.c, found.s,
        found.simple, roots->c, roots->s, roots->simple);
    roots->doubles = dhgen_select_roots(1, cosine, sine, DHGEN_WITHIN_COSINE, found.double_c,
        found.double_s, found.doubles, roots->double_c, roots->double_s, roots->doubles);
    return 1;
}

/* Whether any root is near to an angle. */
DHGEN_FN int dhgen_any_near(const dhgen_roots *roots, double cosine, double sine)
{
    int any = 0;
    for (int i = 0; i < roots->simple; i++) {
        any |= dhgen_is_near(roots->c[i], roots->s[i], cosine, sine, DHGEN_LOOK_COSINE);
    }
    for (int i = 0; i < roots->doubles; i++) {
        any |= dhgen_is_near(
            roots->double_c[i], roots->double_s[i], cosine, sine, DHGEN_WITHIN_COSINE);
    }
    return any;
}

/* Where roots may be double they are replaced by what a closer look shows: values that are computed
 * there have the digits that the fit of f lacks, not those that the equations lack behind f. What
 * was given up stands among them. */
DHGEN_FN void dhgen_look_closer(const dhgen_source *source, dhgen_roots *roots)
{
    double c[DHGEN_LOOKS], s[DHGEN_LOOKS], empty_c[DHGEN_LOOKS], empty_s[DHGEN_LOOKS];
    int looks = 0, clear = 1, i = 0, empty = 0, emptied[DHGEN_LOOKS];
    if (roots->simple == DHGEN_ROOTS || roots->doubles == DHGEN_ROOTS) {
        return;
    }
    while (i < roots->doubles) {
        int seen = 0;
        for (int k = 0; k < looks; k++) {
            seen |= dhgen_is_near(
                roots->double_c[i], roots->double_s[i], c[k], s[k], DHGEN_WITHIN_COSINE);
        }
        if (seen) {
            i++;
            continue;
        }
        if (looks == DHGEN_LOOKS) {
            break;
        }
        c[looks] = roots->double_c[i];
        s[looks] = roots->double_s[i];
        emptied[looks] = dhgen_magnify(source, c[looks], s[looks], roots);
        clear &= emptied[looks];
        emptied[looks] &= !dhgen_any_near(roots, c[looks], s[looks]);
        looks++;
        i = 0;
    }
    for (int k = 0; k < looks; k++) {
        if (emptied[k]) {
            empty_c[empty] = c[k];
            empty_s[empty++] = s[k];
        }
    }
    empty = dhgen_keep_possible(source, empty, empty_c, empty_s);
    for (int k = 0; k < empty && roots->doubles + k < DHGEN_ROOTS; k++) {
        roots->double_c[roots->doubles + k] = empty_c[k];
        roots->double_s[roots->doubles + k] = empty_s[k];
        roots->unseen++;
    }
    roots->complete = roots->complete || (clear && i == roots->doubles);
}

/* Whether samples are nothing but rounding of zero, which may be as smooth as a polynomial. */
DHGEN_FN int dhgen_is_only_rounding(const double samples[DHGEN_SAMPLES])
{
    double most = 0.0;
    for (int k = 0; k < DHGEN_SAMPLES; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    return most <= DHGEN_VANISHING;
}

/* All real roots of a polynomial. Returns 0 where it vanishes identically. */
DHGEN_FN int dhgen_real_roots(const dhgen_source *source, dhgen_roots *roots)
{
    const dhgen_window all = { 0, DHGEN_HALF_CELLS, DHGEN_LIFTED };
    double samples[DHGEN_SAMPLES];
    dhgen_trigonometric f;
    dhgen_moebius map = { 0.0, 0.0 };
    source->sample(source->of, &map, samples);
    if (dhgen_is_only_rounding(samples)) {
        return 0;
    }
    if (dhgen_spreading_moebius(samples, &map)) {
        source->sample(source->of, &map, samples);
    }
    dhgen_fit(samples, &f);
    if (!(f.noise <= DHGEN_NOISE)) {
        return 0;
    }
    dhgen_find_roots(&f, &all, roots);
    dhgen_undo_moebius(&map, roots->simple, roots->c, roots->s);
    dhgen_undo_moebius(&map, roots->doubles, roots->double_c, roots->double_s);
    dhgen_undo_moebius(&map, roots->lifted, roots->lifted_c, roots->lifted_s);
    dhgen_take_lifted(source, roots);
    dhgen_look_closer(source, roots);
    /* where f nearly vanishes identically it does not tell what there is not */
    roots->complete &= f.noise <= DHGEN_CLEAR;
    return 1;
}

#endif
