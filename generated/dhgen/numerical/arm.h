/* SPDX-License-Identifier: MIT
 *
 * An arm as the numerical solver reads it: what joints have to meet, and from where to start. */
#ifndef DHGEN_NUMERICAL_ARM_H
#define DHGEN_NUMERICAL_ARM_H

#include "../arm.h"

/* Values closer than this don't decide which of two rows comes first [rad, arm sizes], and an angle
 * as close to -pi comes where pi does: where solutions meet they are known to 1e-8, and rounding,
 * which differs between machines, decides the rest. */
#define DHGEN_TIE 1e-06

/* Drives of which one moves more than its own joint. */
struct dhgen_drives {
    int turned; /* how many turn; 0 where whole turns are each drive's own */
    const int
        *place; /* of these among the joints solved for, each before the joints that it moves */
    const double *moves; /* what a whole turn of each moves, in units */
    const double *back;  /* of each that is solved for, what it has of every joint's angle or length
                          * in the loop of the general algorithm */
};

struct dhgen_numerical_arm {
    int dof, rows;              /* joints; solutions that are kept */
    int solved, equations;      /* joints that are solved for; numbers that are to vanish */
    int coordinates;            /* how many rows of the translation count */
    int directions;             /* what counts of them: DHGEN_COORDINATES for nothing */
    int arm_angle;              /* whether the caller gives it: the last equation */
    int redundant;              /* whether solutions are families, of which the nearest is kept */
    int limited;                /* whether joints that are solved for have limits */
    int checked;                /* whether the task names more than the joints can choose */
    int starts;                 /* in a round */
    double size, residual;      /* the arm's; what counts as a solution [arm sizes, rad] */
    const int *joint, *turning; /* the joints that are solved for, and whether they turn */
    const int *coordinate;      /* the rows of the translation that count */
    const double *unit;         /* what a step of one means for them [rad or length] */
    const double *measure;      /* what it moves [arm sizes] */
    const double *span_low;     /* between which values starts lie, in units */
    const double *span_width;
    const double *stride;        /* from start to start, in parts of that */
    const double *lowest;        /* limits in units; 0 where descents have none */
    const double *highest;       /* likewise */
    const double *facing, *zero; /* how the loop of the general algorithm counts the joints, or 0 */
    int given_joints;            /* joints whose values the caller gives */
    const int *given;
    void (*fk)(const double *q, double *T);
    void (*jacobian)(const double *q, double *J);
    /* By how much joint values miss the arm angle, and how fast joints 1, 2 and 3 change that. */
    void (*arm_angle_miss)(
        const double *T, const double *free_joints, const double *q, double *off);
    const struct dhgen_drives *drives; /* 0 where every drive moves its own joint alone */
};

/* Moves angles by whole turns to (-pi, pi], and what such a turn moves besides. */
DHGEN_FN void dhgen_wrap_units(const struct dhgen_numerical_arm *arm, double *u)
{
    const struct dhgen_drives *const drives = arm->drives;
    const int together = drives && drives->turned;
    for (int k = 0; together && k < drives->turned; k++) {
        const double turns = ceil(u[drives->place[k]] / DHGEN_TURN - 0.5);
        for (int j = 0; j < arm->solved; j++)
            u[j] -= turns * drives->moves[arm->solved * k + j];
    }
    for (int j = 0; j < arm->solved && !together; j++)
        if (arm->turning[j])
            u[j] -= DHGEN_TURN * ceil(u[j] / DHGEN_TURN - 0.5);
}

/* A solution of the loop in units, of drives that move more than their own joint: by what they have
 * of all joints, also of those among the joint values that are given. */
DHGEN_FN void dhgen_to_drives(
    const struct dhgen_numerical_arm *arm, const double *given, const double *angles, double *u)
{
    const int dof = dhgen_dof(arm);
    double inner[DHGEN_JOINTS];
    for (int i = 0; i < dof; i++)
        inner[i] = given[i];
    for (int j = 0; j < arm->solved; j++)
        inner[arm->joint[j]] = angles[j] - arm->zero[j];
    for (int j = 0; j < arm->solved; j++) {
        double value = 0.0;
        for (int i = 0; i < dof; i++)
            value += arm->drives->back[dof * j + i] * inner[i];
        u[j] = value / arm->unit[j];
    }
}

/* A joint value as it counts where rows are put in order. */
DHGEN_INLINE double dhgen_order_of(double value, int turns)
{
    return turns && value < DHGEN_TIE - DHGEN_HALF_TURN ? value + DHGEN_TURN : value;
}

/* Puts rows in order by one value more. `order` holds their places, `first` whether each begins a
 * block: rows of one block agree so far. They are sorted by the value, and the block ends wherever
 * it rises by more than `tie`. Returns whether each row is a block by now. */
DHGEN_FN int dhgen_order_blocks(
    const double *value, double tie, int count, int *order, unsigned char *first)
{
    int single = 1;
    for (int i = 1; i < count; i++) {
        const int row = order[i];
        int place = i;
        for (; place > 0 && !first[place] && value[row] < value[order[place - 1]]; place--)
            order[place] = order[place - 1];
        order[place] = row;
    }
    for (int i = 1; i < count; i++) {
        first[i] |= value[order[i]] - value[order[i - 1]] > tie;
        single &= first[i];
    }
    return single;
}

/* As in ../arm.h. */
#ifndef DHGEN_MOTION_OF_DESCENTS
#define DHGEN_MOTION_OF_DESCENTS(arm, q, T, J) ((arm)->fk(q, T), (arm)->jacobian(q, J))
#endif

#endif
