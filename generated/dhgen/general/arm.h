/* SPDX-License-Identifier: MIT
 *
 * An arm as the general algorithm reads it: everything that does not depend on the pose. */
#ifndef DHGEN_GENERAL_ARM_H
#define DHGEN_GENERAL_ARM_H

#include "../interface.h"
#include "lanes.h"

/* Room for refined candidates: many come near to a singular solution; the last of it is for regular
 * ones. */
#define DHGEN_PLACES 64

/* A formulation: the joints phi_1 (hidden) ... phi_6 are, from 0; phi = sign q, -1 reads the loop
 * backwards. */
typedef struct {
    int joint[6];
    double sign;
    const double (*left)[32]; /* the monomials of the left side if they are constant, or 0 */
} dhgen_formulation;

/* A joint whose value the caller gives: its angle or length is sign q + offset, and what the other
 * given values add. An offset of -0.0 leaves every value as it is. */
typedef struct {
    int slides;
    double sign, offset;
    const double *shares; /* of each given value; 0 where the joint's own is all */
} dhgen_given_joint;

/* A joint of these inside a link: `factor` is 1, or -1 where its motion is undone; of a slide in
 * arm sizes the same over the arm's size. */
typedef struct {
    int place; /* which of the joints that the caller gives */
    double factor;
} dhgen_given_motion;

/* A link: the constant that it begins with, and the motions in it, each with the next constant
 * behind. */
typedef struct {
    int constant, motion, motions;
} dhgen_general_link;

/* A value of a joint that the caller gives, at which formulations vanish: a length of zero, or an
 * angle whose sine
 * (`across` 1) or cosine (`across` 0) is zero and whose other one has this sign. */
typedef struct {
    int place, across;
    double sign, within;   /* how little next to nothing is */
    unsigned formulations; /* bit i: formulation i is not tried there */
} dhgen_special_value;

/* An offset wrist; lengths in arm sizes. */
typedef struct {
    double shoulder;            /* along axis 1 to S, where axes 1 and 2 meet */
    double wrist_5;             /* along axis 5 to W, where axes 4 and 5 meet */
    double upper_square;        /* of the distance from S to the elbow */
    double lower, lower_square; /* from the elbow to W */
    double cosine, sine;        /* of the angle between the lower arm and axis 4 */
    double flip;                /* on which side axis 4 leaves the lower arm */
    int bent, per_root;         /* whether it leaves it at all; solutions at a simple root */
    double sources[8]; /* what the turns of joints 1 ... 4 bring into line with axis 3, the elbow, W
                          and axis 5 */
} dhgen_wrist;

/* Joints whose values the caller gives, at most. */
#define DHGEN_MOST_GIVEN 16

/* What an arm is like: bits 0 to 5 are the joints of its loop that slide. */
#define DHGEN_ANY_SLIDE 0x3fu
#define DHGEN_HIDDEN_SLIDE 0x40u /* the joint that is hidden slides */
#define DHGEN_LEFT_SLIDE 0x80u   /* one of its partners does */
#define DHGEN_RIGHT_SLIDE 0x100u /* one on the right side does */
#define DHGEN_OFFSET_WRIST 0x200u
#define DHGEN_FOUR_TURNS 0x400u /* and two slides */

/* An arm without three concurrent or parallel axes, in a loop of six joints: J(q1) K0 J(q2) ... K4
 * J(q6) = L T R. */
typedef struct {
    unsigned traits;       /* what it is like */
    int most;              /* solutions that it may have */
    double size, per_size; /* the length that is one in the loop, and its inverse */
    double reach;       /* the square of what is out of reach for all links in line, or HUGE_VAL */
    int infinite_order; /* half the order of the determinant's zero where a hidden length is
                           infinite */
    int formulations;   /* how many there are */
    const dhgen_formulation *formulation; /* in the order in which they are tried */
    double advance[2][6]; /* cosines and sines of what is added to the joints' angles in the loop */
    dhgen_general_link link[7];   /* K0 ... K4, L and R */
    const double (*constant)[12]; /* what they consist of, three rows of four */
    const dhgen_given_motion *motion;
    int given_joints, special_values;
    const dhgen_given_joint *given;
    const dhgen_special_value *special;
    const dhgen_wrist *wrist;
} dhgen_general_arm;

/* Traits that the robot's file fixes before it includes this leave out what the arm does not need.
 */
#if defined(DHGEN_TRAITS) && !defined(DHGEN_SHARED)
#define DHGEN_TRAITS_OF(arm) ((void)(arm), DHGEN_TRAITS)
#define DHGEN_MAY_HAVE(trait) ((DHGEN_TRAITS & (trait)) != 0)
#define DHGEN_MAY_LACK(trait) ((DHGEN_TRAITS & (trait)) == 0)
#else
#define DHGEN_TRAITS_OF(arm) ((arm)->traits)
#define DHGEN_MAY_HAVE(trait) 1
#define DHGEN_MAY_LACK(trait) 1
#endif

/* Whether an arm has one of these traits. */
DHGEN_INLINE int dhgen_has(const dhgen_general_arm *arm, unsigned traits)
{
    return (DHGEN_TRAITS_OF(arm) & traits) != 0u;
}

/* Whether a joint of the loop is a slide, whose length replaces the sine. */
DHGEN_INLINE int dhgen_is_slide(const dhgen_general_arm *arm, int joint)
{
    return (int)(DHGEN_TRAITS_OF(arm) >> joint & 1u);
}

DHGEN_TABLE double dhgen_identity[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0,
    0.0 };

#endif
