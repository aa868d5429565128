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
/* A look replaces what is known within 15/256 rad, so that it shows both roots of a pair that ends
 * beyond; what it shows farther away, less magnified, is new where nothing known is within 1/512
 * rad of it. The cosines. */
#define DHGEN_WITHIN_COSINE 0.9982848583483567
#define DHGEN_ASIDE_COSINE 0.9999980926531862
/* In its middle a map of this strength magnifies 16 times. */
#define DHGEN_STRENGTH 0.8823529411764706
/* How far a closer look reaches, in cells: 1/16 rad becomes 0.93 rad. */
#define DHGEN_REACH 38
/* An extremum close to zero may be a double root that rounding has lifted off, also that of the
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

/* Of angles near which f shows no root keeps those where what f is made of allows one; returns how
 * many. */
typedef int (*dhgen_keeper)(const void *of, int count, double *cosine, double *sine);

/* What f is made of, how it is sampled, and what shows that it has no root; `keep` may be 0, where
 * nothing does. */
typedef struct {
    dhgen_sampler sample;
    dhgen_keeper keep;
    const void *of;
} dhgen_source;

/* Whether any of some angles, by their cosines and sines, is as near to one as `reach`, the cosine
 * of the angle between them. */
DHGEN_FN int dhgen_any_near(
    const double *c, const double *s, int many, double cosine, double sine, double reach)
{
    int any = 0;
    for (int i = 0; i < many; i++) {
        any |= c[i] * cosine + s[i] * sine >= reach;
    }
    return any;
}

/* Removes what is within a look of roots; returns how many are left. */
DHGEN_FN int dhgen_remove_within(double cosine, double sine, double *c, double *s, int many)
{
    int count = 0;
    for (int i = 0; i < many; i++) {
        if (c[i] * cosine + s[i] * sine < DHGEN_WITHIN_COSINE) {
            c[count] = c[i];
            s[count++] = s[i];
        }
    }
    return count;
}

/* Adds the roots of one kind that a look shows, unless they are among the first `simple` and
 * `doubles` known ones; returns how many there are. */
DHGEN_FN int dhgen_add_shown(double cosine, double sine, const dhgen_roots *known, int simple,
    int doubles, const double *from_c, const double *from_s, int many, double *c, double *s,
    int count)
{
    for (int i = 0; i < many && count < DHGEN_ROOTS; i++) {
        const double near = from_c[i] * cosine + from_s[i] * sine;
        const int is_new = near >= DHGEN_LOOK_COSINE
            && !dhgen_any_near(known->c, known->s, simple, from_c[i], from_s[i], DHGEN_ASIDE_COSINE)
            && !dhgen_any_near(known->double_c, known->double_s, doubles, from_c[i], from_s[i],
                DHGEN_ASIDE_COSINE);
        if (near >= DHGEN_WITHIN_COSINE || is_new) {
            c[count] = from_c[i];
            s[count++] = from_s[i];
        }
    }
    return count;
}

/* Keeps the angles where there may be a root; returns how many. */
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

/* Replaces the known roots around an angle by the roots that a map shows which magnifies what is
 * there. Returns 0, and leaves these, where that does not show all. */
DHGEN_FN int dhgen_magnify(
    const dhgen_source *source, double cosine, double sine, dhgen_roots *roots)
{
    const dhgen_moebius map = { DHGEN_STRENGTH * cosine, DHGEN_STRENGTH * sine };
    const double turns = atan2(sine, cosine) / DHGEN_TURN;
    const int cell = (int)(DHGEN_CELLS * (turns - floor(turns))) % DHGEN_CELLS;
    const dhgen_window window = { cell, DHGEN_REACH, DHGEN_LIFTED_CLOSER };
    DHGEN_IN_ROOM(samples, DHGEN_SAMPLES, DHGEN_ROOM_SAMPLES);
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
    const int simple = dhgen_remove_within(cosine, sine, roots->c, roots->s, roots->simple),
              doubles = dhgen_remove_within(
                  cosine, sine, roots->double_c, roots->double_s, roots->doubles);
    roots->simple = dhgen_add_shown(cosine, sine, roots, simple, doubles, found.c, found.s,
        found.simple, roots->c, roots->s, simple);
    roots->doubles = dhgen_add_shown(cosine, sine, roots, simple, doubles, found.double_c,
        found.double_s, found.doubles, roots->double_c, roots->double_s, doubles);
    return 1;
}

/* Whether any root is within a look. */
DHGEN_FN int dhgen_shows_any(const dhgen_roots *roots, double cosine, double sine)
{
    return dhgen_any_near(roots->c, roots->s, roots->simple, cosine, sine, DHGEN_WITHIN_COSINE)
        || dhgen_any_near(
            roots->double_c, roots->double_s, roots->doubles, cosine, sine, DHGEN_WITHIN_COSINE);
}

/* Where roots may be double they are replaced by what a closer look shows: values that are computed
 * there have the digits that the fit of f lacks, not those that the equations lack behind f. Cells
 * that were given up are among them. */
DHGEN_FN void dhgen_look_closer(const dhgen_source *source, dhgen_roots *roots)
{
    double c[DHGEN_LOOKS], s[DHGEN_LOOKS], empty_c[DHGEN_LOOKS], empty_s[DHGEN_LOOKS];
    int looks = 0, clear = 1, i = 0, empty = 0, emptied[DHGEN_LOOKS];
    if (roots->simple == DHGEN_ROOTS || roots->doubles == DHGEN_ROOTS) {
        return;
    }
    while (i < roots->doubles) {
        const int seen = dhgen_any_near(
            c, s, looks, roots->double_c[i], roots->double_s[i], DHGEN_WITHIN_COSINE);
        if (seen) {
            i++;
            continue;
        }
        if (looks >= DHGEN_LOOKS) {
            break;
        }
        c[looks] = roots->double_c[i];
        s[looks] = roots->double_s[i];
        emptied[looks] = dhgen_magnify(source, c[looks], s[looks], roots);
        clear &= emptied[looks];
        emptied[looks] &= !dhgen_shows_any(roots, c[looks], s[looks]);
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
    DHGEN_IN_ROOM(samples, DHGEN_SAMPLES, DHGEN_ROOM_SAMPLES);
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
    /* where f nearly vanishes identically it can't exclude roots */
    roots->complete &= f.noise <= DHGEN_CLEAR;
    return 1;
}

#endif
