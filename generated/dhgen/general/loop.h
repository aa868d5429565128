/* SPDX-License-Identifier: MIT
 *
 * The arm as a loop of six joints: its links at given joint values and at a pose. */
#ifndef DHGEN_GENERAL_LOOP_H
#define DHGEN_GENERAL_LOOP_H

#include "../rigid.h"
#include "arm.h"

/* The loop at a pose: K0 ... K4 and the pose P = L T R, three rows of four, lengths in arm sizes.
 */
typedef struct {
    const dhgen_general_arm *arm;
    double link[6][12];
    unsigned useless; /* bit i: formulation i vanishes at the values that are given */
} dhgen_loop;

/* A joint whose value the caller gives, with the cosine and sine of its angle. */
typedef struct {
    double value, cosine, sine;
} dhgen_given_value;

/* A link at given values. */
DHGEN_FN void dhgen_make_link(
    const dhgen_general_arm *arm, int number, const dhgen_given_value *value, double K[12])
{
    const dhgen_general_link *const link = &arm->link[number];
    dhgen_copy_link(arm->constant[link->constant], K);
    for (int i = 0; i < link->motions; i++) {
        const dhgen_given_motion *const motion = &arm->motion[link->motion + i];
        const dhgen_given_value *const own = &value[motion->place];
        if (arm->given[motion->place].slides) {
            dhgen_append_slide(K, motion->factor * own->value);
        } else {
            dhgen_append_turn(K, own->cosine, motion->factor * own->sine);
        }
        dhgen_append(K, arm->constant[link->constant + 1 + i]);
    }
}

/* Whether a joint has a value at which formulations vanish. */
DHGEN_INLINE int dhgen_is_special(const dhgen_general_arm *arm, const dhgen_special_value *special,
    const dhgen_given_value *value)
{
    const dhgen_given_value *const own = &value[special->place];
    if (arm->given[special->place].slides) {
        return fabs(own->value) <= special->within;
    }
    const double across = special->across ? own->sine : own->cosine;
    const double along = special->across ? own->cosine : own->sine;
    return fabs(across) <= special->within && special->sign * along > 0.0;
}

/* The links of the loop and its pose, at a pose T of the tool and at the joint values that the
 * caller gives. */
DHGEN_FN void dhgen_close_loop(
    const dhgen_general_arm *arm, const double T[16], const double *free_joints, dhgen_loop *loop)
{
    double *const P = loop->link[5], right[12];
    dhgen_given_value value[DHGEN_MOST_GIVEN] = { { 0.0, 0.0, 0.0 } };
    for (int i = 0; i < arm->given_joints; i++) {
        const dhgen_given_joint *const given = &arm->given[i];
        value[i].value = given->sign * free_joints[i] + given->offset;
        for (int k = 0; given->shares && k < arm->given_joints; k++) {
            if (fabs(given->shares[k]) > 0.0) { /* an offset of -0.0 keeps its sign */
                value[i].value += given->shares[k] * free_joints[k];
            }
        }
        value[i].cosine = given->slides ? 1.0 : cos(value[i].value);
        value[i].sine = given->slides ? 0.0 : sin(value[i].value);
    }
    loop->arm = arm;
    for (int i = 0; i < 6; i++) {
        dhgen_make_link(arm, i, value, loop->link[i]);
    }
    dhgen_make_link(arm, 6, value, right);
    dhgen_append(P, T);
    dhgen_append(P, right);
    for (int i = 3; i < 12; i += 4) {
        P[i] *= arm->per_size;
    }
    loop->useless = 0;
    for (int i = 0; i < arm->special_values; i++) {
        if (dhgen_is_special(arm, &arm->special[i], value)) {
            loop->useless |= arm->special[i].formulations;
        }
    }
}

#endif
