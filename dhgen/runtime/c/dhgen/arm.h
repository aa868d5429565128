/* SPDX-License-Identifier: MIT
 *
 * An arm as the runtime sees it: a table of numbers, of what has to be done around the formulas of
 * its solver, and of the robot's own functions. */
#ifndef DHGEN_ARM_H
#define DHGEN_ARM_H

#include "interface.h"

/* Sizes of arrays, and bounds of loops: constants where a robot's file brings the runtime along,
 * else the most that the compiled runtime takes, and the arm's own. */
#define DHGEN_MOST_JOINTS 16
#define DHGEN_MOST_ROWS 16
#if defined(DHGEN_DOF) && !defined(DHGEN_SHARED)
#define DHGEN_JOINTS DHGEN_DOF
#define DHGEN_BRANCHES DHGEN_ROWS
#define dhgen_dof(arm) ((void)(arm), DHGEN_DOF)
#define dhgen_rows(arm) ((void)(arm), DHGEN_ROWS)
#else
#define DHGEN_JOINTS DHGEN_MOST_JOINTS
#define DHGEN_BRANCHES DHGEN_MOST_ROWS
#define dhgen_dof(arm) ((arm)->dof)
#define dhgen_rows(arm) ((arm)->rows)
#endif
#ifdef DHGEN_DOF
#if DHGEN_DOF > DHGEN_MOST_JOINTS || (defined(DHGEN_SHARED) && DHGEN_ROWS > DHGEN_MOST_ROWS)
#error "dhgen: more joints or rows than the runtime has room for"
#endif
#endif

struct dhgen_joint {
    double lowest, highest; /* limits, infinite where it has none [rad or length] */
    double slack;           /* a value may miss its limits by this [rad or length] */
    double weight;          /* of its squared differences: lengths count in arm sizes */
    double pace;            /* what a step of one means in refining; 0 if the caller gives it */
    double fan_step;        /* from one value to the next where it is free [rad or length] */
    int revolute;           /* whether it turns */
};

/* What of a pose is checked, besides that it is finite. */
enum {
    DHGEN_COORDINATES, /* nothing: coordinates count */
    DHGEN_POINTING,    /* the tool's z axis */
    DHGEN_ROTATION,    /* the rotation */
    DHGEN_POSE,        /* the rotation and the last row */
    DHGEN_YAW,         /* the direction of the tool's x axis, seen from above */
    DHGEN_PITCH,       /* how steep it is */
    DHGEN_TILT         /* roll and pitch: the third row */
};

struct dhgen_numerical_arm;

/* A joint whose value is a part of a root, and its sign there. */
struct dhgen_root_turn {
    int joint;
    double sign;
};

/* What an arm needs whose rows may miss their pose, or whose roots may nearly meet. */
struct dhgen_completion {
    const struct dhgen_numerical_arm *descents; /* the arm as least squares read it */
    const struct dhgen_root_turn *turns;        /* joints whose values add up to a root of a */
    int turn_count;                             /* polynomial; none where there is no such root */
    int adds_others;       /* a joint may have one of a few values: all of them are rows */
    int ascends;           /* rows are the roots of a polynomial, in their order */
    int equations_end_all; /* rows of a pose that has solutions, where it is not regular */
    double (*arm_angle)(const double *q); /* where the caller gives it, or NULL */
};

struct dhgen_arm {
    int dof, rows; /* joints; branches */
    int given;     /* values that the caller gives */
    int task;      /* DHGEN_POSE ... */
    const struct dhgen_joint *joints;
    const int *given_joints; /* the joints whose values the caller gives, from 0 */
    int given_joint_count;   /* as many as `given`, none where that is an arm angle */

    /* By how much joint values miss a pose: what its entries count, lengths in arm sizes, to few
     * digits in refining; and for whether a row fits, the places of the entries that do. */
    double miss_weights[6];
    double per_length;
    double clamped[2]; /* a joint is clamped if the pose is missed by so much more; and where no row
                        * is inside limits then [arm sizes, rad] */
    const int *entries;
    int entry_count;

    /* What the solver's rows need. */
    int slides;           /* joints slide: also squares of lengths have to be finite */
    int retries, checks;  /* other values of free joints may reach; may meet the pose */
    int keeps_limits;     /* other values of free joints may keep limits */
    const int *choosable; /* joints that may be free, from 0, the last first */
    int choosable_count;  /* how many */
    const int *together;  /* joints that may have to be chosen together, from 0 */
    int together_count;   /* how many */
    int cuts;             /* of an interval by golden section */
    int merges, refines;  /* branches that meet may come out apart; rows need refining */
    int clamps, clamps_far, range_exceeds_a_turn; /* onto limits; from far away */
    int follows_seed;                             /* where solutions differ by less than rounding */

    /* For `complete`, which works on all rows where roots of polynomials nearly meet or rows miss
     * the pose: dhgen_complete_rows, or both are NULL. `begun` is the first row that was not simply
     * out of reach, or negative. */
    const struct dhgen_completion *completion;
    void (*complete)(const struct dhgen_arm *arm, const double *T, const double *free_joints,
        const double *seed, int begun, double *q, unsigned char *status);

    /* Of coupled drives; how far a row is beyond all limits then. Both may be NULL. */
    const struct dhgen_coupling *coupling;
    double (*beyond)(const struct dhgen_arm *arm, const double *q);

    /* The robot's own functions. `regular` solves regular poses, how many rows are OK, or -1 where
     * the pose needs care; it may be NULL. `solve` fills the rows of branches that have a solution,
     * roots of polynomials being moved by an angle. */
    void (*fk)(const double *q, double *T);
    void (*jacobian)(const double *q, double *J);
    void (*solve)(const double *T, const double *free_joints, const double *seed, double moved,
        double *q, unsigned char *status);
    int (*regular)(const double *T, const double *free_joints, double *q, unsigned char *status);
};

/* The pose of joint values, and the Jacobian there: of arms whose links come at run time, too,
 * where `serial.h` is included before. */
#ifndef DHGEN_FORWARD
#define DHGEN_FORWARD(arm, q, T) (arm)->fk(q, T)
#define DHGEN_RATES(arm, q, J) (arm)->jacobian(q, J)
#endif

/* Entries of a pose by their names. */
#define DHGEN_ENTRIES(number) \
    DHGEN_UNUSED const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    DHGEN_UNUSED const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    DHGEN_UNUSED const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

/* Copies the joint values of a row. */
DHGEN_FN void dhgen_copy_row(const struct dhgen_arm *arm, const double *from, double *to)
{
    for (int i = 0; i < dhgen_dof(arm); i++)
        to[i] = from[i];
}

/* Empties a row: it has no solution. */
DHGEN_FN void dhgen_empty_row(const struct dhgen_arm *arm, double *q, unsigned char *status)
{
    *status = DHGEN_UNREACHABLE;
    for (int i = 0; i < dhgen_dof(arm); i++)
        q[i] = DHGEN_NAN;
}

/* Whether joint values move a joint in refining: whether none of the caller's. */
DHGEN_FN int dhgen_moves(const struct dhgen_arm *arm, int joint)
{
    return arm->joints[joint].pace > 0.0;
}

#endif
