/* scara_f32: SCARA
 *
 * Inverse kinematics, generated from robots/scara.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara.yaml. The formulas and where they come from: scara.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: e1d13fa0a171f34b
 * SPDX-License-Identifier: MIT
 */
#include "scara_f32.h"

#define DHGEN_SINGLE_PRECISION
#define DHGEN_SCALAR
#if defined(SCARA_F32_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 2
#undef DHGEN_SHARED /* the whole runtime is in this file */
/* What robots' public functions do: all solutions of a pose, the one nearest to a seed, and all of
 * many poses. */

/* An arm as the runtime sees it: a table of numbers, of what has to be done around the formulas of
 * its solver, and of the robot's own functions. */

/* What a robot's file and the runtime agree on: the number of their interface, statuses, and the
 * marks of functions and tables. */

#ifdef __CUDACC_RTC__ /* its functions are built in, without headers, but not their constants */
#ifndef NAN
#define NAN __builtin_bit_cast(float, 0x7fc00000u)
#define INFINITY __builtin_bit_cast(float, 0x7f800000u)
#define HUGE_VALF INFINITY
#endif
#else
#include <math.h>
#include <stddef.h>
#endif

/* NaN and infinity mark what is no solution and no limit: a compiler that assumes that they don't
 * exist makes solutions of poses that are out of reach. */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "dhgen needs NaN and infinity: compile without -ffast-math and -ffinite-math-only"
#endif

/* A robot's file names the interface that it was generated for. */
#define DHGEN_INTERFACE 1

/* Marks. DHGEN_INLINE marks what is called in the fast path, DHGEN_FN all other functions of the
 * runtime, DHGEN_SMALL functions that kernels of CUDA call, too, DHGEN_APART functions that must
 * not be inlined, for their stack and code, DHGEN_TABLE constant tables, DHGEN_PUBLIC a robot's
 * public functions, DHGEN_API what robots' files call: with -DDHGEN_SHARED that is compiled once
 * for all of them, in dhgen.c, and their files have its declarations only.
 *
 * In CUDA functions are for both sides, and tables are where they are read. What is not called in
 * the fast path is a call there: inlined it compiles for minutes. */
#if defined(__GNUC__) || defined(__CUDACC__)
#define DHGEN_UNUSED __attribute__((unused))
#else
#define DHGEN_UNUSED
#endif
#ifndef DHGEN_PUBLIC
#ifdef __CUDACC__
#define DHGEN_PUBLIC __host__ __device__
#else
#define DHGEN_PUBLIC
#endif
#endif
#if defined(__CUDACC__)
#define DHGEN_NOINLINE __noinline__
#define DHGEN_ALWAYS
#define DHGEN_FN DHGEN_PUBLIC DHGEN_NOINLINE DHGEN_UNUSED static
#ifdef __CUDA_ARCH__
#define DHGEN_TABLE __device__ static const
#endif
#elif defined(__GNUC__)
#define DHGEN_NOINLINE __attribute__((noinline))
#define DHGEN_ALWAYS __attribute__((always_inline))
#else
#define DHGEN_NOINLINE
#define DHGEN_ALWAYS
#endif
#ifndef DHGEN_FN
#define DHGEN_FN DHGEN_UNUSED static
#endif
#ifndef DHGEN_SMALL
#ifdef __CUDACC__
#define DHGEN_SMALL DHGEN_PUBLIC DHGEN_UNUSED static inline
#else
#define DHGEN_SMALL DHGEN_FN
#endif
#endif
#ifndef DHGEN_INLINE
#define DHGEN_INLINE DHGEN_PUBLIC DHGEN_UNUSED static inline
#endif
#ifndef DHGEN_APART
#define DHGEN_APART DHGEN_PUBLIC DHGEN_NOINLINE DHGEN_UNUSED static
#endif
#ifndef DHGEN_TABLE
#define DHGEN_TABLE static const
#endif
#ifndef DHGEN_API
#if defined(DHGEN_SHARED) && defined(__cplusplus)
#define DHGEN_API extern "C"
#elif defined(DHGEN_SHARED)
#define DHGEN_API
#else
#define DHGEN_API DHGEN_APART
#endif
#endif

/* The mask of all 8 lanes: g++ 12 warns inside its own headers of what has none, and makes the same
 * of both. */
#define DHGEN_EACH (__mmask8)0xff

/* What is no solution. */
#define DHGEN_NAN ((float)NAN)

#define DHGEN_TURN 6.2831855f
#define DHGEN_HALF_TURN 3.1415927f

/* The statuses of rows. The last three are a solver's notes to the runtime: no caller sees them. */
enum {
    DHGEN_OK,
    DHGEN_UNREACHABLE,
    DHGEN_FREE_JOINT,
    DHGEN_OUT_OF_LIMITS,
    DHGEN_INVALID_POSE,
    DHGEN_CLOSE = 64,  /* roots nearly meet: the row may lie between two solutions */
    DHGEN_LOST = 128,  /* + j: the row was lost after joint j had been chosen freely */
    DHGEN_NEARLY = 192 /* + j: the same, joint j is nearly free, and q[1] of the row is its angle */
};

/* Notes why a row is lost, and how far it is from a solution: negative out of reach, positive where
 * it misses the pose. */
DHGEN_INLINE void dhgen_lose(int why, float off, float *q, unsigned char *status)
{
    *status = (unsigned char)why;
    q[0] = off;
}

/* The angle moved by whole turns to (-pi, pi]. */
DHGEN_INLINE float dhgen_wrap(float angle)
{
    return angle - DHGEN_TURN * ceilf(angle / DHGEN_TURN - 0.5f);
}

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
    float lowest, highest; /* limits, infinite where it has none [rad or length] */
    float slack;           /* a value may miss its limits by this [rad or length] */
    float weight;          /* of its squared differences: lengths count in arm sizes */
    float pace;            /* what a step of one means in refining; 0 if the caller gives it */
    float fan_step;        /* from one value to the next where it is free [rad or length] */
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
    float sign;
};

/* What an arm needs whose rows may miss their pose, or whose roots may nearly meet. */
struct dhgen_completion {
    const struct dhgen_numerical_arm *descents; /* the arm as least squares read it */
    const struct dhgen_root_turn *turns;        /* joints whose values add up to a root of a */
    int turn_count;                             /* polynomial; none where there is no such root */
    int adds_others;       /* a joint may have one of a few values: all of them are rows */
    int ascends;           /* rows are the roots of a polynomial, in their order */
    int equations_end_all; /* rows of a pose that has solutions, where it is not regular */
    float (*arm_angle)(const float *q); /* where the caller gives it, or NULL */
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
    float miss_weights[6];
    float per_length;
    float clamped[2]; /* a joint is clamped if the pose is missed by so much more; and where no row
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
    void (*complete)(const struct dhgen_arm *arm, const float *T, const float *free_joints,
        const float *seed, int begun, float *q, unsigned char *status);

    /* Of coupled drives; how far a row is beyond all limits then. Both may be NULL. */
    const struct dhgen_coupling *coupling;
    float (*beyond)(const struct dhgen_arm *arm, const float *q);

    /* The robot's own functions. `regular` solves regular poses, how many rows are OK, or -1 where
     * the pose needs care; it may be NULL. `solve` fills the rows of branches that have a solution,
     * roots of polynomials being moved by an angle. */
    void (*fk)(const float *q, float *T);
    void (*jacobian)(const float *q, float *J);
    void (*solve)(const float *T, const float *free_joints, const float *seed, float moved,
        float *q, unsigned char *status);
    int (*regular)(const float *T, const float *free_joints, float *q, unsigned char *status);
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
DHGEN_FN void dhgen_copy_row(const struct dhgen_arm *arm, const float *from, float *to)
{
    for (int i = 0; i < dhgen_dof(arm); i++)
        to[i] = from[i];
}

/* Empties a row: it has no solution. */
DHGEN_FN void dhgen_empty_row(const struct dhgen_arm *arm, float *q, unsigned char *status)
{
    *status = DHGEN_UNREACHABLE;
    for (int i = 0; i < dhgen_dof(arm); i++)
        q[i] = DHGEN_NAN;
}

/* Whether joint values move a joint in refining: whether none of the caller's. */
DHGEN_FN int dhgen_moves(const struct dhgen_arm *arm, int joint)
{
    return arm->joints[joint].pace > 0.0f;
}

#define DHGEN_SOLVE_REGULAR NULL /* tile.h has one */

/* All solutions of any pose: also of one that is rounded, singular or none. Returns how many rows
 * are inside limits, or -DHGEN_INVALID_POSE. */
DHGEN_API int dhgen_careful_ik(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *q_seed, float *q, unsigned char *status);

/* Of all solutions of a pose, of which there were `count`, that nearest to a seed, with angles
 * moved by whole turns. Returns its status, or minus what is wrong. */
DHGEN_API int dhgen_nearest_row(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *q_seed, int count, float *rows, unsigned char *status,
    float *q);

/* All solutions: regular poses take no other way. */
DHGEN_INLINE int dhgen_ik(const struct dhgen_arm *arm, const float *T, const float *free_joints,
    const float *q_seed, float *q, unsigned char *status)
{
    const int count = arm->regular ? arm->regular(T, free_joints, q, status) : -1;
    return count < 0 ? dhgen_careful_ik(arm, T, free_joints, q_seed, q, status) : count;
}

/* The solution nearest to a seed. */
DHGEN_INLINE int dhgen_ik_nearest(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *q_seed, float *q)
{
    float rows[DHGEN_BRANCHES * DHGEN_JOINTS];
    unsigned char status[DHGEN_BRANCHES];
    const int count = dhgen_ik(arm, T, free_joints, q_seed, rows, status);
    return dhgen_nearest_row(arm, T, free_joints, q_seed, count, rows, status, q);
}

/* All solutions of poses of a batch, from number k on, one after another. */
DHGEN_INLINE void dhgen_ik_each(const struct dhgen_arm *arm, size_t k, size_t n, const float *T,
    const float *free_joints, float *q, unsigned char *status)
{
    const size_t rows = (size_t)dhgen_rows(arm), size = rows * (size_t)dhgen_dof(arm);
    for (; k < n; k++) {
        const float *const given = free_joints ? free_joints + (size_t)arm->given * k : NULL;
        (void)dhgen_ik(arm, T + 16 * k, given, NULL, q + size * k, status + rows * k);
    }
}

#ifndef DHGEN_SHARED

/* Rows whose joints are beyond their limits, onto them. Beside a singular pose a joint is known
 * from the pose to rounding over what is left of the least singular value: if it is beyond a limit
 * by no more than that, it may as well be on it. */

/* Damped least-squares steps that take joint values to a solution next to them. */

/* Damped least squares: of a few equations that may have no solution, or many. */


/* Equations, at most. */
#define DHGEN_MOST_EQUATIONS 7
/* Sums of products are four, which compilers work out at once; rows are as long as whole fours, and
 * zero from where they end. */
#define DHGEN_AT_ONCE 4
#define DHGEN_LONGEST_ROW \
    ((DHGEN_MOST_EQUATIONS + DHGEN_JOINTS + DHGEN_AT_ONCE - 1) / DHGEN_AT_ONCE * DHGEN_AT_ONCE)

/* The inner product of two rows. */
DHGEN_INLINE float dhgen_product_of_rows(int width, const float *a, const float *b)
{
    float sum[DHGEN_AT_ONCE] = { 0.0f };
    for (int j = 0; j < width; j += DHGEN_AT_ONCE)
        for (int k = 0; k < DHGEN_AT_ONCE; k++)
            sum[k] += a[j + k] * b[j + k];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* Adds a multiple of a row to another one. */
DHGEN_INLINE void dhgen_add_to_row(int width, float factor, const float *a, float *to)
{
    for (int j = 0; j < width; j += DHGEN_AT_ONCE)
        for (int k = 0; k < DHGEN_AT_ONCE; k++)
            to[j + k] += factor * a[j + k];
}

/* x = A' (A A' + damping)^-1 y, the rows of A `stride` numbers apart. These, each with its share of
 * the damping's root behind it, are made orthonormal one after another (modified Gram-Schmidt; used
 * as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994): A A' would lose half of the
 * digits. */
DHGEN_FN void dhgen_least_squares(int equations, int unknowns, const float *A, int stride,
    float damping, const float *y, float *x)
{
    const int width = unknowns + equations;
    float rows[DHGEN_MOST_EQUATIONS][DHGEN_LONGEST_ROW] = { { 0.0f } };
    float right[DHGEN_MOST_EQUATIONS], sum[DHGEN_LONGEST_ROW] = { 0.0f };
    for (int i = 0; i < equations; i++) {
        for (int j = 0; j < unknowns; j++)
            rows[i][j] = A[stride * i + j];
        rows[i][unknowns + i] = sqrtf(damping);
        right[i] = y[i];
    }
    for (int k = 0; k < equations; k++) {
        const int end = unknowns + k + 1; /* of this row: its share of the damping is the last */
        float along[DHGEN_MOST_EQUATIONS];
        for (int i = k; i < equations; i++)
            along[i] = dhgen_product_of_rows(end, rows[k], rows[i]);
        const float per_square = 1.0f / along[k], inverse = sqrtf(per_square);
        for (int i = k + 1; i < equations; i++) {
            const float factor = -along[i] * per_square;
            dhgen_add_to_row(end, factor, rows[k], rows[i]);
            right[i] += factor * right[k];
        }
        right[k] *= inverse;
        for (int j = 0; j < end; j++)
            rows[k][j] *= inverse;
    }
    for (int i = equations - 1; i >= 0; i--) {
        const float missing = right[i] - dhgen_product_of_rows(width, rows[i], sum);
        dhgen_add_to_row(width, missing, rows[i], sum);
    }
    for (int j = 0; j < unknowns; j++)
        x[j] = sum[j];
}
/* Joint values and their limits. */

/* What the runtime takes for rounding. dhgen/tolerances.py has the same numbers, which the
 * compiler decides by, and the reasons at length. Lengths are relative to the size of the arm; a
 * pose is rounded to a few 1e-16 of it, in single precision to a few 1e-8. */

/* Seeds that are nearer to a value are beside it [rad, arm sizes]: a step may be longer than the
 * whole way. */
#define DHGEN_BESIDE_SEED 0.15f

/* Of the tool's x axis, the length of what is seen from above, below which it has no yaw there: as
 * much as a pose of six digits rounds it by. */
#define DHGEN_NO_YAW 1e-06f


#define DHGEN_LAST_ROW 1e-06f
#define DHGEN_ORTHONORMAL 1e-12f
#define DHGEN_ROUNDED 1e-09f
#define DHGEN_LIMIT 2e-06f
#define DHGEN_NEAR_LIMIT 0.005f
#define DHGEN_EXACT 5e-05f
#define DHGEN_PROMISED 5e-05f
#define DHGEN_FREE 2e-05f
#define DHGEN_MERGE 1e-07f
#define DHGEN_DOUBTFUL 0.01f
#define DHGEN_APART_BY 0.003f
#define DHGEN_FAR_ANGLE 100.0f
#define DHGEN_FINE 1e-10f
#define DHGEN_TOGETHER 0.03f
#define DHGEN_FAMILY 0.0005f


/* Ranges at least this wide leave next to no gap [rad]: near a singular pose rounding crosses
 * it. */
#define DHGEN_NEARLY_A_TURN 6.183185f

/* How far a joint value is beyond its limits, whole turns aside; negative below [rad or length]. */
DHGEN_SMALL float dhgen_overshoot(const struct dhgen_arm *arm, int joint, float value)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const float low = of->lowest, high = of->highest;
    if (low <= value && value <= high)
        return 0.0f;
    float off = value > high ? value - high : value - low;
    if (of->revolute) {
        const float gap = DHGEN_TURN - (high - low), over = value - high;
        const float rest = over - DHGEN_TURN * floorf(over / DHGEN_TURN);
        off = rest >= gap ? 0.0f : rest <= gap - rest ? rest : rest - gap;
    }
    return fabsf(off) <= 0.5f * of->slack ? 0.0f : off;
}

/* How far the joint values of a row are beyond their limits, whole turns aside [rad, arm sizes]. */
DHGEN_FN float dhgen_beyond_limits(const struct dhgen_arm *arm, const float *q)
{
    if (arm->beyond)
        return arm->beyond(arm, q);
    float sum = 0.0f;
    for (int i = 0; i < dhgen_dof(arm); i++)
        sum += fabsf(dhgen_overshoot(arm, i, q[i])) * sqrtf(arm->joints[i].weight);
    return sum;
}

/* How far a joint value is past an end of its range: where that is nearly a turn, the value itself:
 * turned it would be across the gap. */
DHGEN_SMALL float dhgen_past_an_end(const struct dhgen_arm *arm, int joint, float value)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const float low = of->lowest, high = of->highest;
    if (!arm->range_exceeds_a_turn || high - low < DHGEN_NEARLY_A_TURN)
        return dhgen_overshoot(arm, joint, value);
    const float off = value - fminf(fmaxf(value, low), high);
    return fabsf(off) <= 0.5f * of->slack ? 0.0f : off;
}

/* How far the joint values of a row are past the ends of their ranges [rad, arm sizes]. */
DHGEN_FN float dhgen_past_ends(const struct dhgen_arm *arm, const float *q)
{
    float sum = 0.0f;
    for (int i = 0; i < dhgen_dof(arm); i++)
        sum += fabsf(dhgen_past_an_end(arm, i, q[i])) * sqrtf(arm->joints[i].weight);
    return sum;
}

/* A joint value moved by whole turns near to another, but inside its limits if it can be. */
DHGEN_SMALL float dhgen_turned(
    const struct dhgen_arm *arm, int joint, float given, float towards)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const float low = of->lowest - DHGEN_LIMIT, high = of->highest + DHGEN_LIMIT;
    if (!of->revolute)
        return given;
    float value = given;
    if (fabsf(towards) < DHGEN_FAR_ANGLE)
        value += DHGEN_TURN * floorf((towards - given) / DHGEN_TURN + 0.5f);
    value -= DHGEN_TURN * ceilf(fmaxf(value - high, 0.0f) / DHGEN_TURN);
    value += DHGEN_TURN * ceilf(fmaxf(low - value, 0.0f) / DHGEN_TURN);
    return value <= high ? value : given;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
DHGEN_SMALL float dhgen_at_an_end(
    const struct dhgen_arm *arm, int joint, float value, float seed)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const float near = value + DHGEN_TURN * floorf((seed - value) / DHGEN_TURN + 0.5f);
    if (!of->revolute || !(fabsf(near - value) > 0.0f || value < of->lowest || of->highest < value))
        return value;
    const float past = fabsf(dhgen_past_an_end(arm, joint, near));
    if (0.0f < past && past < DHGEN_DOUBTFUL && fabsf(near - seed) < DHGEN_BESIDE_SEED)
        return near;
    const float off = dhgen_overshoot(arm, joint, value);
    if (off == 0.0f || fabsf(off) > DHGEN_DOUBTFUL)
        return dhgen_turned(arm, joint, value, value);
    return off + (off > 0.0f ? of->highest : of->lowest);
}

/* Whether a joint value is inside its limits, but for rounding. */
DHGEN_FN int dhgen_inside(const struct dhgen_arm *arm, int joint, float value)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    return of->lowest - of->slack <= value && value <= of->highest + of->slack;
}

/* Where two things are singular the Jacobian has rows as small as the joints are near. Damped by
 * the square of the miss a step is then longer than the way; damped by the miss it is not, and
 * gains where roots meet, because the miss is as small as the square of such rows. */
#define DHGEN_CAUTIOUS 0.003f
#define DHGEN_DAMPING 0.1f
/* Steps: what is right ends after two or three, where roots meet after twelve. */
#define DHGEN_STEPS 20
/* A step is in vain if it leaves more of the miss; where n roots meet (1 - 1/n)^n is left. Near
 * places where two things are singular some make it worse before it gets better: after so many it
 * fails. */
#define DHGEN_SLOW 0.7f
#define DHGEN_IN_VAIN 4
/* Nearer than so many times what is enough rounding decides what a step leaves. */
#define DHGEN_NEAR_ENOUGH 100.0f
/* Two joints that are past the ends of their ranges can be refined inside, though perhaps not onto
 * the ends: they are put inside as far as they are past, times this, then twice as far, up to
 * that. */
#define DHGEN_NEXT_INSIDE 2.0f
#define DHGEN_FARTHEST_INSIDE 16.0f

/* How far joint values are from others, whole turns aside [rad, arm sizes]; `half` is the middle.
 */
DHGEN_FN float dhgen_half_way(
    const struct dhgen_arm *arm, const float *x, const float *q, float *half)
{
    float most = 0.0f;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        float off = q[i] - x[i];
        off -= arm->joints[i].revolute ? DHGEN_TURN * floorf(off / DHGEN_TURN + 0.5f) : 0.0f;
        most = fmaxf(most, fabsf(off) * sqrtf(arm->joints[i].weight));
        half[i] = x[i] + 0.5f * off;
    }
    return most;
}

/* What is missed of yaw, pitch or tilt, as turns about the base's axes, into e. Returns its square.
 * A pose without a yaw misses none. */
DHGEN_FN float dhgen_miss_of_angles(
    const struct dhgen_arm *arm, const float *T, const float *P, float *e)
{
    float square = 0.0f;
    if (arm->task == DHGEN_YAW) {
        const float level = T[0] * T[0] + T[4] * T[4];
        e[5] = P[0] * T[4] - P[4] * T[0];
        return level * ((P[0] - T[0]) * (P[0] - T[0]) + (P[4] - T[4]) * (P[4] - T[4]));
    }
    if (arm->task == DHGEN_PITCH) {
        e[3] = T[8] - P[8];
        return e[3] * e[3];
    }
    for (int i = 0; i < 3; i++) {
        e[3] += T[8 + i] * P[4 + i];
        e[4] -= T[8 + i] * P[i];
        square += (P[8 + i] - T[8 + i]) * (P[8 + i] - T[8 + i]);
    }
    return square;
}

/* By how much joint values miss a pose, into e, whose angles are 0 half a turn away, too. Returns
 * the length of the miss, which differs between the two [arm sizes, rad]. */
DHGEN_FN float dhgen_miss(const struct dhgen_arm *arm, const float *T, const float *x, float *e)
{
    const float *const weights = arm->miss_weights;
    float P[16], square = 0.0f;
    DHGEN_FORWARD(arm, x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0f ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0f;
        e[3 + i] = 0.0f;
        square += e[i] * e[i];
    }
    if (arm->task == DHGEN_POINTING) {
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3 * 4 + 2, k = (i + 2) % 3 * 4 + 2;
            e[3 + i] = P[j] * T[k] - P[k] * T[j];
            square += (P[j] - T[j]) * (P[j] - T[j]);
        }
    } else if (arm->task > DHGEN_POSE) {
        square += dhgen_miss_of_angles(arm, T, P, e);
    } else if (arm->task != DHGEN_COORDINATES) {
        for (int i = 0; i < 9; i++) {
            const int j = (i / 3 + 1) % 3 * 4 + i % 3, k = (i / 3 + 2) % 3 * 4 + i % 3;
            e[3 + i / 3] += 0.5f * (P[j] * T[k] - P[k] * T[j]);
            square += 0.5f * (P[j] - T[j]) * (P[j] - T[j]);
        }
    }
    return sqrtf(square);
}

/* Takes out of `width` columns J at joint values x, spins below, what changes no direction that
 * counts. Of a pitch its rate comes first; else turns that don't count about the base's axes have
 * no weight. */
DHGEN_FN void dhgen_count_what_counts(
    const struct dhgen_arm *arm, const float *x, int width, float *J)
{
    float P[16];
    if (arm->task != DHGEN_POINTING && arm->task != DHGEN_PITCH)
        return;
    DHGEN_FORWARD(arm, x, P);
    for (int j = 0; j < width; j++) {
        float *spin = J + 3 * width + j;
        if (arm->task == DHGEN_PITCH) {
            spin[0] = spin[0] * P[4] - spin[width] * P[0];
            continue;
        }
        const float along = P[2] * spin[0] + P[6] * spin[width] + P[10] * spin[2 * width];
        for (int i = 0; i < 3; i++)
            spin[width * i] -= along * P[4 * i + 2];
    }
}

/* Adds the damped least-squares step for the miss e to joint values of which some are held. */
DHGEN_FN void dhgen_add_step(
    const struct dhgen_arm *arm, const int *held, float damping, const float *e, float *x)
{
    const int dof = dhgen_dof(arm);
    float J[6 * DHGEN_JOINTS], step[DHGEN_JOINTS];
    DHGEN_RATES(arm, x, J);
    dhgen_count_what_counts(arm, x, dof, J);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < dof; j++)
            J[dof * i + j] *= held[j] ? 0.0f : arm->joints[j].pace * arm->miss_weights[i];
    dhgen_least_squares(6, dof, J, dof, damping + DHGEN_FINE, e, step);
    for (int j = 0; j < dof; j++)
        x[j] += step[j] * arm->joints[j].pace;
}

/* Where the joint that is farthest past an end of its range is, or -1; `past` is how far. */
DHGEN_FN int dhgen_farthest_past(const struct dhgen_arm *arm, const float *x, float *past)
{
    int worst = -1;
    *past = 0.0f;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        const float off = dhgen_moves(arm, i) ? dhgen_past_an_end(arm, i, x[i]) : 0.0f;
        if (fabsf(off) > fabsf(*past)) {
            worst = i;
            *past = off;
        }
    }
    return worst;
}

/* Takes joint values to some not farther than `most` that miss the pose by less than `enough`; if
 * that is negative, to some inside their limits that miss it by less than so much more. Returns
 * whether it can. Goes on while that gains, first by short steps. */
DHGEN_FN int dhgen_refine(
    const struct dhgen_arm *arm, const float *T, float enough, float most, float *q)
{
    float x[DHGEN_JOINTS], half[DHGEN_JOINTS], e[6], last = HUGE_VALF;
    const int clamps = enough <= 0.0f;
    int moves = 0, refined = 0, lost = 0, held[DHGEN_JOINTS] = { 0 };
    dhgen_copy_row(arm, q, x);
    for (int k = 0; k < DHGEN_STEPS; k++) {
        float miss = dhgen_miss(arm, T, x, e), past = 0.0f;
        if (clamps && k == 0)
            enough = miss - enough;
        const int worst = clamps && miss < enough ? dhgen_farthest_past(arm, x, &past) : -1;
        if (worst >= 0) { /* one by one: others may follow it inside, or the first the second */
            moves++;
            for (int i = 0; i < dhgen_dof(arm); i++)
                held[i] = i == worst || (held[i] && moves != 2);
            last = HUGE_VALF;
            x[worst] -= past;
            miss = dhgen_miss(arm, T, x, e);
        }
        if (miss < enough) {
            dhgen_copy_row(arm, x, q);
            refined = 1;
            enough = 0.5f * miss;
        } else if (refined
            || (miss > fmaxf(DHGEN_SLOW * last, DHGEN_NEAR_ENOUGH * enough)
                && ++lost == DHGEN_IN_VAIN)) {
            break;
        }
        last = miss;
        const int cautious = lost == 0 && miss > DHGEN_NEAR_ENOUGH * enough;
        dhgen_add_step(arm, held, (cautious ? DHGEN_CAUTIOUS : DHGEN_DAMPING * miss) * miss, e, x);
        if (!(dhgen_half_way(arm, x, q, half) <= most))
            break; /* another solution */
    }
    return refined;
}

/* Clamps joint values to the ends of ranges that they are past or, as two may not be there at once,
 * takes them inside; the pose is missed by less than `more` more than before. Returns whether it
 * can. */
DHGEN_FN int dhgen_refine_inside(
    const struct dhgen_arm *arm, const float *T, float more, float most, float *q)
{
    float x[DHGEN_JOINTS], e[6];
    if (dhgen_refine(arm, T, -more, most, q))
        return 1;
    if (!arm->range_exceeds_a_turn)
        return 0;
    int past = 0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        past += dhgen_moves(arm, i) && fabsf(dhgen_past_an_end(arm, i, q[i])) > 0.0f;
    const float enough = dhgen_miss(arm, T, q, e) + more;
    float farther = DHGEN_NEXT_INSIDE;
    while (past > 1 && farther <= DHGEN_FARTHEST_INSIDE) {
        for (int i = 0; i < dhgen_dof(arm); i++)
            x[i] = q[i] - (dhgen_moves(arm, i) ? farther : 0.0f) * dhgen_past_an_end(arm, i, q[i]);
        if (dhgen_refine(arm, T, enough, most, x) && !(dhgen_past_ends(arm, x) > 0.0f)) {
            dhgen_copy_row(arm, x, q);
            return 1;
        }
        farther *= 2.0f;
    }
    return 0;
}

/* A joint that moves by more on its way to a limit reaches another solution [rad, arm sizes]: a
 * nearly straight wrist turns far for next to nothing. */
#define DHGEN_MOST_CLAMPED 1.5f
/* Steps from half way to the same solution go no farther than so many times the whole way. */
#define DHGEN_HALF_WAY_ASIDE 0.25f

/* Clamps the joints of a row that exceed their limits, by little, or as an arm may `again`. Returns
 * whether it can: the result must be the same solution, so the middle must also solve the pose, and
 * no row with a smaller violation may lie closer. */
DHGEN_FN int dhgen_clamp_to_limits(const struct dhgen_arm *arm, const float *T, int row, int again,
    float *rows, const unsigned char *status)
{
    float x[DHGEN_JOINTS], half[DHGEN_JOINTS], to[DHGEN_JOINTS];
    float *const q = rows + dhgen_dof(arm) * row;
    const float beyond = dhgen_past_ends(arm, q);
    const int far = again && arm->clamps_far;
    if (!(0.0f < beyond && (far || beyond < DHGEN_DOUBTFUL)))
        return 0;
    dhgen_copy_row(arm, q, x);
    const float most = far ? HUGE_VALF : DHGEN_MOST_CLAMPED;
    if (!dhgen_refine_inside(arm, T, arm->clamped[again], most, x))
        return 0;
    const float off = dhgen_half_way(arm, q, x, half);
    for (int k = 0; k < dhgen_rows(arm); k++) {
        const float *const other = rows + dhgen_dof(arm) * k;
        if (status[k] != DHGEN_UNREACHABLE && dhgen_past_ends(arm, other) < beyond
            && dhgen_half_way(arm, other, x, to) < off)
            return 0;
    }
    if (off >= DHGEN_TOGETHER
        && !dhgen_refine(arm, T, DHGEN_EXACT, DHGEN_HALF_WAY_ASIDE * off, half))
        return 0;
    dhgen_copy_row(arm, x, q);
    return 1;
}
/* Rows that are one solution: branches that meet come out apart by rounding where one root follows
 * another. */


/* The damping of steps that leave singular directions alone, and how many are made. */
#define DHGEN_SINGULAR 1e-13f
#define DHGEN_STEPS_TO_DOUBLE 3

/* Whether two rows are one solution: half way between them the arm is singular, and solves the
 * pose. */
DHGEN_FN int dhgen_are_duplicates(
    const struct dhgen_arm *arm, const float *T, const float *q, const float *other)
{
    const int held[DHGEN_JOINTS] = { 0 };
    float half[DHGEN_JOINTS], e[6];
    if (!(dhgen_half_way(arm, q, other, half) < DHGEN_TOGETHER) || isnan(half[0]))
        return 0;
    for (int i = 0; i < DHGEN_STEPS_TO_DOUBLE; i++) {
        dhgen_miss(arm, T, half, e);
        dhgen_add_step(arm, held, DHGEN_SINGULAR, e, half);
    }
    return dhgen_miss(arm, T, half, e) <= DHGEN_MERGE;
}

/* Empties rows that differ from earlier ones by rounding alone. Where roots follow roots each row
 * is refined first, and emptied if no solution is found. */
DHGEN_FN void dhgen_remove_duplicates(
    const struct dhgen_arm *arm, const float *T, float *q, unsigned char *status)
{
    const int dof = dhgen_dof(arm);
    for (int row = 0; row < dhgen_rows(arm); row++) {
        float *const values = q + dof * row, e[6];
        int ends = arm->refines && dhgen_miss(arm, T, values, e) > DHGEN_PROMISED
            && !dhgen_refine(arm, T, DHGEN_EXACT, DHGEN_BESIDE_SEED, values);
        for (int k = 0; k <= row; k++) {
            if (k > 0)
                ends = dhgen_are_duplicates(arm, T, q + dof * (k - 1), values);
            if (ends)
                dhgen_empty_row(arm, values, status + row);
        }
    }
}
/* Where the seed solves the pose with other joint values than the rows, and the solutions differ by
 * less than rounding, the arm may as well go on with the seed's. */


/* Misses half way to two rows whose ratio is below this are equal but for rounding, which differs
 * between languages. The first row is taken. */
#define DHGEN_ALIKE 2.0f

/* Takes joint values to the solution next to the seed that keeps the caller's values and, where
 * joints are clamped or coupled, limits. Returns whether there is one. */
DHGEN_FN int dhgen_beside_seed(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *seed, float *x)
{
    for (int i = 0; i < dhgen_dof(arm); i++) {
        float here = seed[i];
        if (arm->range_exceeds_a_turn
            && !(fabsf(dhgen_past_an_end(arm, i, here)) <= DHGEN_BESIDE_SEED))
            here = dhgen_turned(arm, i, here, here);
        x[i] = arm->clamps ? here - dhgen_past_an_end(arm, i, here) : here;
    }
    for (int k = 0; k < arm->given_joint_count; k++)
        x[arm->given_joints[k]] = free_joints[k];
    if (!dhgen_refine(arm, T, DHGEN_EXACT, DHGEN_BESIDE_SEED, x))
        return 0;
    return (!(arm->clamps && dhgen_past_ends(arm, x) > DHGEN_LIMIT)
               || dhgen_refine_inside(arm, T, arm->clamped[0], DHGEN_BESIDE_SEED, x))
        && !(arm->beyond && arm->beyond(arm, x) > DHGEN_LIMIT);
}

/* Gives the solution next to the seed a row: its own, one as good, one left, or any. */
DHGEN_FN void dhgen_follow_seed(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *seed, float *q, unsigned char *status)
{
    const int dof = dhgen_dof(arm);
    float x[DHGEN_JOINTS], half[DHGEN_JOINTS], e[6], least = HUGE_VALF, nearest = DHGEN_TOGETHER;
    int place = 0;
    if (!dhgen_beside_seed(arm, T, free_joints, seed, x))
        return;
    for (int row = dhgen_rows(arm) - 1; row >= 0; row--) {
        float between = DHGEN_FAMILY;
        if (status[row] != DHGEN_UNREACHABLE) {
            const float off = dhgen_half_way(arm, x, q + dof * row, half);
            between = 0.0f;
            if (!(arm->clamps && off < DHGEN_TOGETHER))
                between = fmaxf(dhgen_miss(arm, T, half, e), DHGEN_EXACT);
            if (off < nearest) {
                nearest = off;
                place = row;
                least = -1.0f; /* its own */
            }
        }
        if (between <= DHGEN_ALIKE * least)
            place = row;
        least = fminf(least, between);
    }
    if (least >= 0.0f)
        status[place] = DHGEN_FREE_JOINT;
    if (nearest > DHGEN_APART_BY || (arm->clamps && dhgen_past_ends(arm, q + dof * place) > 0.0f))
        dhgen_copy_row(arm, x, q + dof * place);
}
/* Reading poses: refuses what is no pose, and replaces a rotation that is only rounded by the
 * nearest one. */


/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
DHGEN_SMALL float dhgen_misfit(const float *T)
{
    const float x0 = T[0], x1 = T[1], x2 = T[2];
    const float y0 = T[4], y1 = T[5], y2 = T[6];
    const float xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0f;
    const float yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0f;
    const float xy = x0 * y0 + x1 * y1 + x2 * y2;
    const float zx = x1 * y2 - x2 * y1 - T[8];
    const float zy = x2 * y0 - x0 * y2 - T[9];
    const float zz = x0 * y1 - x1 * y0 - T[10];
    return xx * xx + yy * yy + 2.0f * xy * xy + zx * zx + zy * zy + zz * zz;
}

/* Takes one step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, N. J.
 * Higham, Computing the polar decomposition, 1986). */
DHGEN_SMALL void dhgen_straighten(float *T)
{
    float G[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[i][j] = (i == j ? 1.5f : 0.0f)
                - 0.5f * (T[i] * T[j] + T[4 + i] * T[4 + j] + T[8 + i] * T[8 + j]);
    for (float *row = T; row < T + 12; row += 4) {
        const float x = row[0], y = row[1], z = row[2];
        for (int j = 0; j < 3; j++)
            row[j] = x * G[0][j] + y * G[1][j] + z * G[2][j];
    }
}

/* Whether a number may be used: it is finite, and where a joint slides so are its square and sums
 * of those, as its cube is. */
DHGEN_SMALL int dhgen_usable(const struct dhgen_arm *arm, float number)
{
    return isfinite(arm->slides ? number * number * number : number) != 0;
}

/* Makes three entries one long: a column or a row. Returns 0 where they are none, 1 where they
 * were, 2 where they are now. */
DHGEN_SMALL int dhgen_read_unit(float *x, float *y, float *z)
{
    const float square = *x * *x + *y * *y + *z * *z;
    const float miss = (square - 1.0f) * (square - 1.0f);
    if (!(miss <= DHGEN_ROUNDED))
        return 0;
    if (miss <= DHGEN_ORTHONORMAL)
        return 1;
    const float length = sqrtf(square);
    *x /= length;
    *y /= length;
    *z /= length;
    return 2;
}

/* Makes the tool's x axis level, or zero where it is too steep to have a yaw, which is free then.
 * Returns 0 where it is no direction, 1 where it was level, 2 where it is now. */
DHGEN_SMALL int dhgen_read_yaw(float *T)
{
    const float square = T[0] * T[0] + T[4] * T[4];
    T[8] = 0.0f;
    if ((square - 1.0f) * (square - 1.0f) <= DHGEN_ORTHONORMAL)
        return 1;
    if (!isfinite(square))
        return 0;
    const float length = sqrtf(square);
    T[0] = length < DHGEN_NO_YAW ? 0.0f : T[0] / length;
    T[4] = length < DHGEN_NO_YAW ? 0.0f : T[4] / length;
    return 2;
}

/* Makes the sine of the pitch one at most. Returns 0 where it is none, 1 where it was, 2 where it
 * is now. */
DHGEN_SMALL int dhgen_read_pitch(float *T)
{
    const float over = fabsf(T[8]) - 1.0f;
    if (over <= 0.0f)
        return 1;
    if (!(over * over <= DHGEN_ROUNDED))
        return 0;
    if (over * over <= DHGEN_ORTHONORMAL)
        return 1;
    T[8] = T[8] < 0.0f ? -1.0f : 1.0f;
    return 2;
}

/* Makes the rotation one. Returns 0 where it is none, 1 where it was, 2 where it is now. */
DHGEN_SMALL int dhgen_read_rotation(float *T)
{
    const float miss = dhgen_misfit(T);
    if (!(miss <= DHGEN_ROUNDED))
        return 0;
    if (miss <= DHGEN_ORTHONORMAL)
        return 1;
    dhgen_straighten(T);
    dhgen_straighten(T);
    return 2;
}

/* Copies a pose; directions that are only rounded are put right. Returns 0 for what is no pose, 1
 * for what was one, 2 for what was rounded. */
DHGEN_SMALL int dhgen_read_pose(const struct dhgen_arm *arm, const float *given, float *T)
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    for (int i = 0; i < 3; i++)
        if (arm->miss_weights[i] > 0.0f && !dhgen_usable(arm, T[4 * i + 3]))
            return 0;
    if (arm->task == DHGEN_POSE
        && !(fabsf(T[12]) + fabsf(T[13]) + fabsf(T[14]) + fabsf(T[15] - 1.0f) <= DHGEN_LAST_ROW))
        return 0;
    switch (arm->task) {
    case DHGEN_COORDINATES:
        return 1;
    case DHGEN_POINTING:
        return dhgen_read_unit(T + 2, T + 6, T + 10);
    case DHGEN_YAW:
        return dhgen_read_yaw(T);
    case DHGEN_PITCH:
        return dhgen_read_pitch(T);
    case DHGEN_TILT:
        return dhgen_read_unit(T + 8, T + 9, T + 10);
    default:
        return dhgen_read_rotation(T);
    }
}
/* Other values of free joints, where the seed's, which the solver took, give no solution, or one
 * beyond limits. */


/* Values of a free joint that are tried to each side of the first. */
#define DHGEN_HALF_FAN 32
/* How far a joint is moved whose angle has few digits [rad]: from rounding, doubled again and
 * again. */
#define DHGEN_LEAST_MOVE 1e-15f
#define DHGEN_MOST_MOVE 0.1f
/* Halvings until an interval of a turn is as small as rounding. */
#define DHGEN_HALVINGS 52
/* Where golden section cuts an interval: (3 - root of 5) / 2. */
#define DHGEN_GOLDEN 0.38196602f
/* Turns of joints that may have to be chosen together. */
#define DHGEN_TURNS_TOGETHER 12
/* How far a joint is moved to see which others move with it [rad or length]. */
#define DHGEN_ELSEWHERE 0.1f

/* A row that another value of a free joint may solve, and what solving again needs. */
struct dhgen_search {
    const struct dhgen_arm *arm;
    const float *T, *free_joints;
    float seed[DHGEN_JOINTS], start, q[DHGEN_BRANCHES * DHGEN_JOINTS];
    unsigned char status[DHGEN_BRANCHES];
    int joint, row;
    int within;      /* whether limits count */
    float best, at; /* where the arm came nearest */
    float by;       /* how far roots are moved */
};

/* Makes a search ready for a row. */
DHGEN_FN void dhgen_start_search(struct dhgen_search *s, const struct dhgen_arm *arm,
    const float *T, const float *free_joints, int row)
{
    s->arm = arm;
    s->T = T;
    s->free_joints = free_joints;
    s->joint = 0;
    s->row = row;
    s->within = 0;
    s->start = s->at = s->by = 0.0f;
    s->best = -HUGE_VALF;
    for (int i = 0; i < dhgen_dof(arm); i++)
        s->seed[i] = 0.0f;
    for (int i = 0; i < dhgen_dof(arm) * dhgen_rows(arm); i++)
        s->q[i] = 0.0f;
}

/* The joint values of the row that is searched. */
DHGEN_FN float *dhgen_found_row(struct dhgen_search *s)
{
    return s->q + dhgen_dof(s->arm) * s->row;
}

/* By how much joint values miss the entries of a pose that count: the root of the sum of squares.
 */
DHGEN_FN float dhgen_missed_by(const struct dhgen_arm *arm, const float *T, const float *q)
{
    float reached[16], sum = 0.0f;
    DHGEN_FORWARD(arm, q, reached);
    for (int k = 0; k < arm->entry_count; k++) {
        const int i = arm->entries[k];
        const float off = (reached[i] - T[i]) * (i % 4 == 3 ? arm->per_length : 1.0f);
        sum += off * off;
    }
    return sqrtf(sum);
}

/* How far the row is from a solution: 0 if it is solved, else less. One that misses the pose, be it
 * by less than is allowed, is nearer than any out of reach. */
DHGEN_FN float dhgen_shortfall(struct dhgen_search *s)
{
    const float *const q = dhgen_found_row(s);
    const int status = s->status[s->row], ended = status >= DHGEN_LOST;
    if (status == DHGEN_UNREACHABLE)
        return -HUGE_VALF;
    if (!s->arm->checks)
        return ended ? q[0] : 0.0f;
    if (ended && q[0] < 0.0f)
        return q[0] - 1.0f;
    const float miss = ended ? q[0] : dhgen_missed_by(s->arm, s->T, q);
    return miss <= DHGEN_FREE ? 0.0f : -miss / (1.0f + miss);
}

/* Solves with the joint moved. Returns 0 if that solves the row, else less. */
DHGEN_FN float dhgen_attempt(struct dhgen_search *s, float moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < dhgen_rows(s->arm); i++)
        s->status[i] = DHGEN_UNREACHABLE;
    s->arm->solve(s->T, s->free_joints, s->seed, s->by, s->q, s->status);
    const float result = dhgen_shortfall(s);
    if (result > s->best) {
        s->best = result;
        s->at = s->seed[s->joint];
    }
    if (result == 0.0f && s->within)
        return -dhgen_beyond_limits(s->arm, dhgen_found_row(s));
    return result;
}

/* Whether the row was solved, as exactly as poses may be rounded. */
DHGEN_FN int dhgen_works(struct dhgen_search *s)
{
    const int status = s->status[s->row];
    if (s->within && dhgen_beyond_limits(s->arm, dhgen_found_row(s)) > 0.0f)
        return 0;
    return status != DHGEN_UNREACHABLE && status < DHGEN_LOST;
}

/* A move between two that works, by golden section, or NaN. */
DHGEN_FN float dhgen_summit(struct dhgen_search *s, float low, float high)
{
    for (int k = 0; k < s->arm->cuts; k++) {
        const float third = DHGEN_GOLDEN * (high - low);
        const float left = dhgen_attempt(s, low + third), right = dhgen_attempt(s, high - third);
        if (left == 0.0f || right == 0.0f)
            return left == 0.0f ? low + third : high - third;
        if (left >= right)
            high -= third;
        else
            low += third;
    }
    /* where branches meet this one has no solution of its own */
    if (!s->arm->retries || isinf(dhgen_attempt(s, low - DHGEN_LIMIT))
        || isinf(dhgen_attempt(s, high + DHGEN_LIMIT)))
        return DHGEN_NAN;
    dhgen_attempt(s, low);
    return dhgen_works(s) ? low : DHGEN_NAN;
}

/* The end of the values that work, between a move that may not and one that does, by bisection. */
DHGEN_FN float dhgen_nearest_end(struct dhgen_search *s, float inner, float outer)
{
    for (int i = 0; i < DHGEN_HALVINGS; i++) {
        const float middle = 0.5f * (inner + outer);
        if (dhgen_attempt(s, middle) == 0.0f)
            outer = middle;
        else
            inner = middle;
    }
    return outer;
}

/* How far a free joint has to be moved from the seed's value until it works, or NaN: a fan of
 * values, golden section, bisection of the nearest end; of two equally near the lower one. One that
 * is exact comes before all others. */
DHGEN_FN float dhgen_working_value(struct dhgen_search *s)
{
    const float step = s->arm->joints[s->joint].fan_step;
    if (dhgen_attempt(s, 0.0f) == 0.0f)
        return 0.0f;
    float nearest = DHGEN_NAN, before, here = -HUGE_VALF;
    float after = dhgen_attempt(s, -(float)DHGEN_HALF_FAN * step);
    int exactly = 0;
    for (int k = -DHGEN_HALF_FAN; k <= DHGEN_HALF_FAN; k++) {
        before = here;
        here = after;
        after = dhgen_attempt(s, (float)(k + 1) * step);
        float outer = (float)k * step, inner = 0.0f;
        if (k != 0)
            inner = k > 0 ? outer - step : outer + step;
        if (here < 0.0f && here >= before && here > after)
            outer = dhgen_summit(s, outer - step, outer + step);
        else if (here < 0.0f || (k > 0 ? before : after) == 0.0f)
            continue;
        if (isnan(outer))
            continue;
        if (s->arm->checks) {
            const int exact = !(dhgen_attempt(s, outer) < 0.0f);
            if (exact < exactly)
                continue;
            if (exact > exactly)
                nearest = DHGEN_NAN;
            exactly = exact;
        }
        outer = dhgen_nearest_end(s, inner, outer);
        if (!(fabsf(outer) >= fabsf(nearest) - DHGEN_LIMIT))
            nearest = outer;
    }
    return nearest;
}

/* How far a joint has to be moved whose angle had few digits, so that the arm could not reach, or
 * NaN: the nearest that works, also where the arm just reaches (an elbow is stretched). While it is
 * right up to rounding of what it was taken from, `solve` takes it as its own. */
DHGEN_FN float dhgen_working_digits(struct dhgen_search *s)
{
    float before[2] = { -HUGE_VALF, -HUGE_VALF };
    int past[2] = { 0, 0 };
    float moved = DHGEN_LEAST_MOVE;
    while (moved < DHGEN_MOST_MOVE) {
        for (int way = 0; way < 2; way++) {
            const float there = way ? -moved : moved, here = dhgen_attempt(s, there);
            if (here == 0.0f)
                return there;
            if (here < 2.0f * before[way] && !past[way]++) {
                const float top = dhgen_summit(s, 0.25f * there, there);
                if (!isnan(top))
                    return top;
            }
            before[way] = here;
        }
        moved *= 2.0f;
    }
    return DHGEN_NAN;
}

/* How far the last of several free joints has to be moved where none works alone, or NaN: in turn
 * each goes to where the arm came nearest. */
DHGEN_FN float dhgen_working_together(struct dhgen_search *s)
{
    const struct dhgen_arm *const arm = s->arm;
    float working = DHGEN_NAN, before = -HUGE_VALF;
    for (int k = 0; k < DHGEN_TURNS_TOGETHER && isnan(working) && s->best > before; k++) {
        before = s->best;
        s->seed[s->joint] = s->at;
        s->joint = arm->together[k % arm->together_count];
        s->start = s->at = s->seed[s->joint];
        working = dhgen_working_value(s);
    }
    return working;
}

/* Where the values of a joint begin that are tried: angles in the first turn, slides inside their
 * strokes, as they are tried as far as these. */
DHGEN_FN float dhgen_first_value(const struct dhgen_arm *arm, int joint, float value)
{
    if (arm->joints[joint].revolute)
        return fmodf(value, DHGEN_TURN);
    return arm->keeps_limits ? value - dhgen_overshoot(arm, joint, value) : value;
}

/* Retries a row that was lost after a joint had been chosen: another value of this joint, if one
 * works. */
DHGEN_FN void dhgen_retry_free_joint(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *seed, int row, float *q, unsigned char *status)
{
    const int nearly = status[row] > DHGEN_NEARLY;
    float *const values = q + dhgen_dof(arm) * row;
    struct dhgen_search lost;
    dhgen_start_search(&lost, arm, T, free_joints, row);
    lost.joint = status[row] - (nearly ? DHGEN_NEARLY : DHGEN_LOST) - 1;
    dhgen_copy_row(arm, seed, lost.seed);
    lost.start = dhgen_first_value(arm, lost.joint, nearly ? values[1] : seed[lost.joint]);
    float nearest = nearly ? dhgen_working_digits(&lost) : dhgen_working_value(&lost);
    if (isnan(nearest) && !nearly && arm->together_count > 0)
        nearest = dhgen_working_together(&lost);
    dhgen_attempt(&lost, isnan(nearest) ? 0.0f : nearest);
    const int works = !isnan(nearest) && dhgen_works(&lost);
    status[row] = DHGEN_UNREACHABLE;
    if (works)
        status[row] = lost.status[row];
    for (int i = 0; i < dhgen_dof(arm); i++)
        values[i] = works ? dhgen_found_row(&lost)[i] : DHGEN_NAN;
}

/* Whether a joint beyond its limits does not move with the one that is searched. */
DHGEN_FN int dhgen_is_hopeless(struct dhgen_search *s)
{
    struct dhgen_search other = *s;
    dhgen_attempt(s, 0.0f);
    dhgen_attempt(&other, DHGEN_ELSEWHERE);
    if (dhgen_shortfall(s) < 0.0f || dhgen_shortfall(&other) < 0.0f)
        return 0;
    for (int i = 0; i < dhgen_dof(s->arm); i++) {
        const float value = dhgen_found_row(s)[i];
        const float moved = fabsf(value - dhgen_found_row(&other)[i]);
        if (moved < DHGEN_LIMIT && fabsf(dhgen_overshoot(s->arm, i, value)) > 0.0f)
            return 1;
    }
    return 0;
}

/* Retries a row where a free joint took the seed's value, and that puts one beyond its limits: the
 * nearest value that keeps all limits, if there is one. Other free joints take the seed's value as
 * far as their limits allow. */
DHGEN_FN void dhgen_keep_limits(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *seed, int row, float *q, unsigned char *status)
{
    struct dhgen_search search;
    dhgen_start_search(&search, arm, T, free_joints, row);
    search.within = 1;
    for (int i = 0; i < dhgen_dof(arm); i++)
        search.seed[i] = seed[i] - dhgen_overshoot(arm, i, seed[i]);
    for (int k = 0; k < arm->choosable_count; k++) {
        const int joint = search.joint = arm->choosable[k];
        const float inside = search.seed[joint];
        search.start = arm->joints[joint].revolute ? fmodf(seed[joint], DHGEN_TURN) : inside;
        const float nearest =
            dhgen_is_hopeless(&search) ? DHGEN_NAN : dhgen_working_value(&search);
        /* beside the solution of another row this one has none */
        if (!isnan(nearest)
            && (fabsf(nearest) >= DHGEN_APART_BY || !isinf(dhgen_attempt(&search, 0.0f)))) {
            dhgen_attempt(&search, nearest);
            status[row] = search.status[row];
            dhgen_copy_row(arm, dhgen_found_row(&search), q + dhgen_dof(arm) * row);
            return;
        }
        search.seed[joint] = inside;
    }
}

/* Whether a pose and what else the caller gives can be used: 0 if not, 2 if the pose was rounded.
 */
DHGEN_FN int dhgen_read_input(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *seed, float *pose)
{
    for (int k = 0; k < arm->given; k++)
        if (!dhgen_usable(arm, free_joints[k]))
            return 0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        if (!isfinite(seed[i]))
            return 0;
    return dhgen_read_pose(arm, T, pose);
}

/* The rows of a pose, before any of them is clamped to limits. */
DHGEN_FN void dhgen_solve_rows(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *seed, float *q, unsigned char *status)
{
    arm->solve(T, free_joints, seed, 0.0f, q, status);
    int begun = -1;
    for (int row = dhgen_rows(arm) - 1; row >= 0; row--)
        begun = status[row] == DHGEN_UNREACHABLE ? begun : row;
    for (int row = 0; row < dhgen_rows(arm) && arm->retries; row++)
        if (status[row] >= DHGEN_LOST)
            dhgen_retry_free_joint(arm, T, free_joints, seed, row, q, status);
    for (int row = 0; row < dhgen_rows(arm) && arm->keeps_limits; row++)
        if (status[row] == DHGEN_FREE_JOINT
            && dhgen_beyond_limits(arm, q + dhgen_dof(arm) * row) > 0.0f)
            dhgen_keep_limits(arm, T, free_joints, seed, row, q, status);
    if (arm->complete)
        arm->complete(arm, T, free_joints, seed, begun, q, status);
    if (arm->merges)
        dhgen_remove_duplicates(arm, T, q, status);
    for (int row = 0; row < dhgen_rows(arm) && arm->range_exceeds_a_turn; row++)
        for (int i = 0; i < dhgen_dof(arm); i++) {
            float *const value = q + dhgen_dof(arm) * row + i;
            *value = dhgen_at_an_end(arm, i, *value, seed[i]);
        }
    if (arm->follows_seed)
        dhgen_follow_seed(arm, T, free_joints, seed, q, status);
}

/* Turns the joints of a row inside their limits. Returns whether all are. */
DHGEN_FN int dhgen_turn_inside(const struct dhgen_arm *arm, float *q)
{
    int inside = 1;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        const struct dhgen_joint *const of = arm->joints + i;
        if (arm->clamps || arm->follows_seed)
            q[i] = dhgen_turned(arm, i, q[i], dhgen_moves(arm, i) ? 0.0f : q[i]);
        else if (!(of->lowest <= q[i] && q[i] <= of->highest))
            q[i] = dhgen_turned(arm, i, q[i], q[i]);
        inside &= dhgen_inside(arm, i, q[i]);
    }
    return inside;
}

/* Clamps rows to limits, and again where none is inside, and marks the rows that are not inside.
 * Returns how many are. */
DHGEN_FN int dhgen_end_rows(
    const struct dhgen_arm *arm, const float *T, float *q, unsigned char *status)
{
    const int rows = dhgen_rows(arm);
    const int twice = arm->clamps_far || arm->clamped[1] > arm->clamped[0];
    int count = 0;
    for (int n = 0; n < rows || (twice && n < 2 * rows && count == 0); n++) {
        const int row = n % rows, again = n >= rows;
        if (status[row] == DHGEN_UNREACHABLE)
            continue;
        if (arm->clamps && dhgen_clamp_to_limits(arm, T, row, again, q, status) && again)
            status[row] = DHGEN_FREE_JOINT;
        if (!dhgen_turn_inside(arm, q + dhgen_dof(arm) * row))
            status[row] = DHGEN_OUT_OF_LIMITS;
        count += status[row] != DHGEN_OUT_OF_LIMITS;
    }
    return count;
}

DHGEN_API int dhgen_careful_ik(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *q_seed, float *q, unsigned char *status)
{
    const float zeros[DHGEN_JOINTS] = { 0.0f }, *const seed = q_seed ? q_seed : zeros;
    float pose[16];
    const int valid = dhgen_read_input(arm, T, free_joints, seed, pose);
    if (valid == 2 && arm->regular) {
        const int count = arm->regular(pose, free_joints, q, status);
        if (count >= 0)
            return count;
    }
    for (int row = 0; row < dhgen_rows(arm); row++) {
        status[row] = valid ? DHGEN_UNREACHABLE : DHGEN_INVALID_POSE;
        for (int i = 0; i < dhgen_dof(arm); i++)
            q[dhgen_dof(arm) * row + i] = DHGEN_NAN;
    }
    if (!valid)
        return -DHGEN_INVALID_POSE;
    dhgen_solve_rows(arm, pose, free_joints, seed, q, status);
    return dhgen_end_rows(arm, pose, q, status);
}

/* Whether a row of a regular pose has a joint past an end of its range that was turned although the
 * seed is at that end. */
DHGEN_FN int dhgen_turned_away(const struct dhgen_arm *arm, const float *q_seed,
    const float *rows, const unsigned char *status)
{
    int past = 0;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        const struct dhgen_joint *const of = arm->joints + i;
        if (!(fminf(of->highest - q_seed[i], q_seed[i] - of->lowest) < DHGEN_BESIDE_SEED))
            continue;
        for (int row = 0; row < dhgen_rows(arm); row++)
            if (status[row] == DHGEN_OK) {
                const float value = rows[dhgen_dof(arm) * row + i];
                const float there = dhgen_at_an_end(arm, i, value, q_seed[i]);
                past += dhgen_past_an_end(arm, i, there) != 0.0f;
            }
    }
    return past > 0;
}

/* How far a row is from a seed, squared, after its angles have been turned near to it [rad, arm
 * sizes]. */
DHGEN_FN float dhgen_distance(const struct dhgen_arm *arm, const float *q_seed, float *q)
{
    float distance = 0.0f;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        q[i] = dhgen_turned(arm, i, q[i], q_seed[i]);
        const float moved = q[i] - q_seed[i];
        distance += arm->joints[i].weight * moved * moved;
    }
    return distance;
}

DHGEN_API int dhgen_nearest_row(const struct dhgen_arm *arm, const float *T,
    const float *free_joints, const float *q_seed, int count, float *rows, unsigned char *status,
    float *q)
{
    float found[DHGEN_JOINTS], least = HUGE_VALF;
    int result = -DHGEN_UNREACHABLE, valid = count >= 0;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        found[i] = DHGEN_NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    if (valid && arm->range_exceeds_a_turn && arm->regular
        && dhgen_turned_away(arm, q_seed, rows, status))
        (void)dhgen_careful_ik(arm, T, free_joints, q_seed, rows, status);
    for (int row = 0; row < dhgen_rows(arm) && valid; row++) {
        float *const values = rows + dhgen_dof(arm) * row;
        if (status[row] == DHGEN_OUT_OF_LIMITS && result < 0)
            result = -DHGEN_OUT_OF_LIMITS;
        if (status[row] != DHGEN_OK && status[row] != DHGEN_FREE_JOINT)
            continue;
        const float distance = dhgen_distance(arm, q_seed, values);
        if (distance < least || result < 0) {
            least = distance;
            result = status[row];
            dhgen_copy_row(arm, values, found);
        }
    }
    dhgen_copy_row(arm, found, q);
    return valid ? result : -DHGEN_INVALID_POSE;
}

#endif
/* Joint velocities of a twist: exact where the arm is regular, damped near singular poses. */


/* The joint velocities of a twist of the tool at joint values q, by least squares. */
DHGEN_API void dhgen_joint_velocities(
    const struct dhgen_arm *arm, const float *q, const float *twist, float *velocities);

#ifndef DHGEN_SHARED


/* Damping begins at this singular value of the task's Jacobian, lengths in arm sizes: joints move
 * at most a hundred times as fast as the tool. */
#define DHGEN_DAMPED_BELOW 0.01f
/* Through all pairs of rows; six to eight do. */
#define DHGEN_SWEEPS 20
/* Rows are orthogonal if their cosine is not above the second, which is rounding of sums of
 * products, or their product not above the first, which is rounding of zero. */
#define DHGEN_NOTHING 1e-30f
#define DHGEN_ORTHOGONAL 2e-06f

/* Turns two rows until their first `dof` entries are orthogonal. Returns whether it has to. */
DHGEN_FN int dhgen_turn_rows(int dof, float *x, float *y)
{
    float a = 0.0f, b = 0.0f, c = 0.0f;
    for (int j = 0; j < dof; j++) {
        a += x[j] * x[j];
        b += y[j] * y[j];
        c += x[j] * y[j];
    }
    if (!(fabsf(c) > fmaxf(DHGEN_ORTHOGONAL * sqrtf(a * b), DHGEN_NOTHING)))
        return 0;
    const float ratio = 0.5f * (b - a) / c;
    const float tangent = copysignf(1.0f, ratio) / (fabsf(ratio) + sqrtf(1.0f + ratio * ratio));
    const float cosine = 1.0f / sqrtf(1.0f + tangent * tangent), sine = cosine * tangent;
    for (int j = 0; j <= dof; j++) {
        const float before = x[j];
        x[j] = cosine * before - sine * y[j];
        y[j] = sine * before + cosine * y[j];
    }
    return 1;
}

/* Turns pairs of six rows until all are orthogonal in their first `dof` entries, by one-sided
 * Jacobi rotations (M. R. Hestenes, 1958): their lengths are then the singular values. The entry
 * behind those is turned along. */
DHGEN_FN void dhgen_make_orthogonal(int dof, float *rows)
{
    int turned = 1;
    for (int sweep = 0; sweep < DHGEN_SWEEPS && turned; sweep++) {
        turned = 0;
        for (int i = 0; i < 5; i++)
            for (int k = i + 1; k < 6; k++)
                turned |= dhgen_turn_rows(dof, rows + (dof + 1) * i, rows + (dof + 1) * k);
    }
}

DHGEN_API void dhgen_joint_velocities(
    const struct dhgen_arm *arm, const float *q, const float *twist, float *velocities)
{
    const int dof = dhgen_dof(arm), width = dof + 1;
    float J[6 * DHGEN_JOINTS], rows[6 * (DHGEN_JOINTS + 1)];
    DHGEN_RATES(arm, q, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < dof; j++)
            rows[width * i + j] = J[dof * i + j] / sqrtf(arm->joints[j].weight);
        rows[width * i + dof] = twist[i];
    }
    dhgen_count_what_counts(arm, q, width, rows);
    for (int k = 0; k < 6 * width; k++)
        rows[k] *= arm->miss_weights[k / width];
    dhgen_make_orthogonal(dof, rows);
    for (int j = 0; j < dof; j++)
        velocities[j] = 0.0f;
    for (int i = 0; i < 6; i++) {
        const float *const row = rows + width * i;
        float square = 0.0f;
        for (int j = 0; j < dof; j++)
            square += row[j] * row[j];
        const float share = row[dof] / fmaxf(square, DHGEN_DAMPED_BELOW * DHGEN_DAMPED_BELOW);
        for (int j = 0; j < dof; j++)
            velocities[j] += share * row[j] / sqrtf(arm->joints[j].weight);
    }
}

#endif
#ifndef SCARA_F32_PLAIN
/* A robot's function for DHGEN_LANES poses, at work: on one pose where lanes are single numbers,
 * and on the poses of a batch side by side. */

/* Lanes: what the fast path computes with. `dhgen_wide` holds one number of each of DHGEN_LANES
 * poses, `dhgen_four` one of each of four branches of one pose. They are GNU vectors where compiler
 * and machine have them; with -DDHGEN_SCALAR and elsewhere `dhgen_wide` is a number, and there is
 * no `dhgen_four`. With -DDHGEN_LIBM the arctangents are those of <math.h>, too. */

/* atan r = r + r^3 (a[0] + a[1] r^2 ...), |r| <= tan(pi/8) */


DHGEN_UNUSED DHGEN_TABLE float dhgen_arctangent[11] = {
    -0.33333334f,
    0.2f,
    -0.14285715f,
    0.11111111f,
    -0.09090905f,
    0.07692183f,
    -0.0666451f,
    0.058581363f,
    -0.050853834f,
    0.039229743f,
    -0.019174544f,
};
/* Quotients in the fast path: in C what is written. In CUDA a division's rare cases cost more than
 * all else, registers and branches, so there they are left out: what is divided by must be neither
 * subnormal nor above 1e307. Poses at which it is are left to the careful functions. */


/* The quotient of a and b, from an estimate of 1 / b that is right to six digits: within one of the
 * last place. */
DHGEN_INLINE float dhgen_quotient_by(float estimate, float a, float b)
{
    const float off = fmaf(-b, estimate, 1.0f);
    const float inverse = fmaf(estimate, fmaf(off, off, off), estimate), first = a * inverse;
    return fmaf(fmaf(-b, first, a), inverse, first);
}

#ifdef __CUDA_ARCH__
DHGEN_INLINE float dhgen_quotient(float a, float b)
{
    return __fdividef(a, b); /* within two of the last place */
}
#define DHGEN_QUOTIENT(a, b) dhgen_quotient(a, b)
#else
#define DHGEN_QUOTIENT(a, b) ((a) / (b))
#endif

#if defined(__clang__) || defined(__CUDACC__)
#define DHGEN_UNROLLED _Pragma("unroll")
#define DHGEN_WRITTEN_OUT _Pragma("unroll")
#elif defined(__GNUC__) && __GNUC__ >= 8
#define DHGEN_UNROLLED _Pragma("GCC unroll 2")
#define DHGEN_WRITTEN_OUT _Pragma("GCC unroll 16") /* short loops also without -O3 */
#else
#define DHGEN_UNROLLED
#define DHGEN_WRITTEN_OUT
#endif

/* The ends of a joint's range, with the slack of its limits. */
DHGEN_INLINE float dhgen_low(const struct dhgen_joint *joint)
{
    return joint->lowest - joint->slack;
}

DHGEN_INLINE float dhgen_high(const struct dhgen_joint *joint)
{
    return joint->highest + joint->slack;
}

/* Numbers among lanes, by names like those of lanes. */
typedef float dhgen_double;
#define dhgen_sqrt_double sqrtf
#define dhgen_abs_double fabsf
#define dhgen_sin_double sinf
#define dhgen_cos_double cosf

DHGEN_INLINE float dhgen_maximum_double(float a, float b)
{
    return a > b ? a : b;
}

#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) \
    && !defined(DHGEN_SCALAR) && !defined(DHGEN_LIBM) && !defined(__CUDACC__)
#else
/* Lanes that are single numbers. */

#define DHGEN_LANES 1
typedef float dhgen_wide;
typedef dhgen_wide dhgen_wide_at; /* in memory */
typedef int dhgen_wide_mask;

/* Only what is chosen is computed: a function's arguments all would be. */
#define dhgen_pick_wide(m, yes, no) ((m) ? (yes) : (no))
#define dhgen_only_wide(m, x) ((m) ? (x) : 0.0f)

#define dhgen_copysign_wide copysignf
#define dhgen_signed_wide copysignf
#define dhgen_abs_wide fabsf
#define dhgen_sqrt_wide sqrtf
#define dhgen_sin_wide sinf
#define dhgen_cos_wide cosf
#define dhgen_wrap_wide dhgen_wrap
#define dhgen_maximum_wide dhgen_maximum_double

DHGEN_INLINE float dhgen_all_wide(float x)
{
    return x;
}

DHGEN_INLINE int dhgen_where_wide(int truth)
{
    return truth;
}

DHGEN_INLINE unsigned dhgen_bits_wide(int m)
{
    return m != 0;
}

DHGEN_INLINE float dhgen_minimum_wide(float a, float b)
{
    return a < b ? a : b;
}

DHGEN_INLINE float dhgen_negated_wide(float x, float where)
{
    return x * copysignf(1.0f, where);
}

/* The status of a row: whether it has no solution, or one beyond limits. */
DHGEN_INLINE int dhgen_kind_wide(float x)
{
    return -(x != x) & DHGEN_UNREACHABLE;
}

DHGEN_INLINE int dhgen_kind_within_wide(float x, int outside)
{
    return (-(x != x) & DHGEN_UNREACHABLE) | (-((x == x) & outside) & DHGEN_OUT_OF_LIMITS);
}

#define DHGEN_OF(name) dhgen_##name##_wide
#define DHGEN_VECTOR dhgen_wide
#define DHGEN_MASK dhgen_wide_mask
#define DHGEN_ADDED(x, m, y) ((x) + dhgen_only_wide(m, 1.0f) * (y))
/* Angles of lanes moved by a whole turn, and joint values and their limits, written once for all
 * types, and included for each type by a file that defines DHGEN_VECTOR, DHGEN_MASK, and DHGEN_OF
 * for names. */

/* An angle moved to (-pi, pi] that may be below. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(raised)(DHGEN_VECTOR x)
{
    return x + DHGEN_OF(only)(x <= -DHGEN_HALF_TURN, DHGEN_TURN);
}

/* An angle moved to (-pi, pi] that may be above. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(lowered)(DHGEN_VECTOR x)
{
    return x - DHGEN_OF(only)(DHGEN_HALF_TURN < x, DHGEN_TURN);
}

/* An angle moved to (-pi, pi] that may be either. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(centred)(DHGEN_VECTOR x)
{
    return x
        + DHGEN_OF(pick)(x <= -DHGEN_HALF_TURN, DHGEN_OF(all)(DHGEN_TURN),
            DHGEN_OF(only)(DHGEN_HALF_TURN < x, -DHGEN_TURN));
}

/* How far a joint is beyond its limits; negative inside. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(beyond)(DHGEN_VECTOR x, const struct dhgen_joint *joint)
{
    return DHGEN_OF(maximum)(dhgen_low(joint) - x, x - dhgen_high(joint));
}

/* How far a joint is beyond its limits where these are alike on both sides. */
DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(exceeds)(DHGEN_VECTOR x, const struct dhgen_joint *joint)
{
    return DHGEN_OF(abs)(x) - dhgen_high(joint);
}

/* Whether a joint that is so far beyond its limits may be so by rounding. */
DHGEN_INLINE DHGEN_MASK DHGEN_OF(within_slack)(DHGEN_VECTOR x)
{
    return DHGEN_OF(abs)(x - DHGEN_NEAR_LIMIT) <= DHGEN_NEAR_LIMIT;
}
#ifdef DHGEN_LIBM /* half the time of atan2 */
DHGEN_INLINE float dhgen_atan2_wide(float y, float x)
{
    return atanf(y / x) + copysignf(1.5707964f - copysignf(1.5707964f, x), y);
}
#else
/* The arctangent of lanes, written once for all types, and included for each type by a file that
 * defines DHGEN_VECTOR, DHGEN_MASK, DHGEN_OF for names, and DHGEN_ADDED(x, m, y) for x + y where m
 * holds, else x.
 *
 * The angle of y and x, not both zero and not infinite, in [-pi, pi], within 3 ulp: the multiple of
 * pi/4 next to it and a ratio of at most tan(pi/8), then a polynomial in this. In two steps: of
 * several angles all ratios come first. */

typedef struct {
    DHGEN_VECTOR r, known, y;
} DHGEN_OF(direction);

DHGEN_INLINE DHGEN_OF(direction) DHGEN_OF(ratio)(DHGEN_VECTOR y, DHGEN_VECTOR x)
{
    const DHGEN_VECTOR ax = DHGEN_OF(abs)(x), ay = DHGEN_OF(abs)(y);
    const DHGEN_MASK steep = ay > ax;
    const DHGEN_VECTOR most = DHGEN_OF(maximum)(ay, ax), least = DHGEN_OF(minimum)(ax, ay);
    const DHGEN_MASK turned = least > most * 0.41421357f;
    const DHGEN_VECTOR ahead = DHGEN_OF(all)(0.7853982f);
    const DHGEN_VECTOR half = DHGEN_OF(all)(1.5707964f);
    const DHGEN_VECTOR part = DHGEN_OF(negated)(DHGEN_OF(pick)(steep, -ahead, ahead), x);
    const DHGEN_VECTOR whole = DHGEN_OF(pick)(steep, half, half - 2.0f * part);
    const DHGEN_VECTOR up = DHGEN_ADDED(least, turned, -most);
    const DHGEN_VECTOR down = DHGEN_ADDED(most, turned, least);
    DHGEN_OF(direction) of;
    of.r = DHGEN_QUOTIENT(DHGEN_OF(negated)(up, part), down);
    of.known = DHGEN_ADDED(whole, turned, part);
    of.y = y;
    return of;
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(angle)(DHGEN_OF(direction) of)
{
    const float *const odd = dhgen_arctangent;
    const DHGEN_VECTOR r = of.r, u = r * r, u2 = u * u, u4 = u2 * u2;
    const DHGEN_VECTOR p0 = (odd[0] + odd[1] * u) + (odd[2] + odd[3] * u) * u2;
    const DHGEN_VECTOR p4 = (odd[4] + odd[5] * u) + (odd[6] + odd[7] * u) * u2;
    const DHGEN_VECTOR p8 = (odd[8] + odd[9] * u) + odd[10] * u2;
    const DHGEN_VECTOR p = p0 + (p4 + p8 * u4) * u4;
    return DHGEN_OF(negated)((of.known + r) + r * u * p, of.y);
}

DHGEN_INLINE DHGEN_VECTOR DHGEN_OF(atan2)(DHGEN_VECTOR y, DHGEN_VECTOR x)
{
    return DHGEN_OF(angle)(DHGEN_OF(ratio)(y, x));
}
#endif
#undef DHGEN_OF
#undef DHGEN_VECTOR
#undef DHGEN_MASK
#undef DHGEN_ADDED
#endif

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
DHGEN_INLINE dhgen_wide dhgen_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide x0 = T[0], x1 = T[1], x2 = T[2];
    const dhgen_wide y0 = T[4], y1 = T[5], y2 = T[6];
    const dhgen_wide xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0f;
    const dhgen_wide yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0f;
    const dhgen_wide xy = x0 * y0 + x1 * y1 + x2 * y2;
    const dhgen_wide zx = x1 * y2 - x2 * y1 - T[8];
    const dhgen_wide zy = x2 * y0 - x0 * y2 - T[9];
    const dhgen_wide zz = x0 * y1 - x1 * y0 - T[10];
    return xx * xx + yy * yy + 2.0f * xy * xy + zx * zx + zy * zy + zz * zz;
}

/* How far the whole of a pose is from one, as a sum of squares; NaN if it is not finite. */
DHGEN_INLINE dhgen_wide dhgen_pose_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0f;
    return dhgen_misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3;
}

/* How far the tool's z axis is from one long. */
DHGEN_INLINE dhgen_wide dhgen_approach_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide zz = T[2] * T[2] + T[6] * T[6] + T[10] * T[10] - 1.0f;
    return zz * zz;
}

/* By how much the sine of the pitch is above one; NaN if it is not finite. */
DHGEN_INLINE dhgen_wide dhgen_pitch_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide over = dhgen_maximum_wide(dhgen_abs_wide(T[8]), 0.0f * T[8] + 1.0f) - 1.0f;
    return over * over + 0.0f * T[8];
}

/* How far the third row is from one long. */
DHGEN_INLINE dhgen_wide dhgen_tilt_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide zz = T[8] * T[8] + T[9] * T[9] + T[10] * T[10] - 1.0f;
    return zz * zz;
}

#undef DHGEN_SOLVE_REGULAR
#define DHGEN_SOLVE_REGULAR solve_regular

/* Joint values, NaN without a solution, statuses, and whether a pose needs care. */
typedef dhgen_wide_mask dhgen_solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind);


/* One regular pose of an arm with at most DHGEN_ROWS rows. Returns how many rows are OK, or -1 if
 * it needs care. */
DHGEN_ALWAYS
DHGEN_INLINE int dhgen_solve_branches(dhgen_solve_wide *solve_wide, int rows, const float *T,
    const float *free_joints, float *q, unsigned char *status)
{
    dhgen_wide_mask kind[DHGEN_ROWS];
    int count = 0;
    if (solve_wide(T, free_joints, q, kind))
        return -1;
    for (int row = 0; row < rows; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == DHGEN_OK;
    }
    return count;
}

/* All solutions of the poses of a batch. */
DHGEN_INLINE void dhgen_ik_batch(const struct dhgen_arm *arm, dhgen_solve_wide *solve_wide,
    int given, size_t n, const float *T, const float *free_joints, float *q,
    unsigned char *status)
{
    (void)solve_wide;
    (void)given;
    dhgen_ik_each(arm, 0, n, T, free_joints, q, status);
}

#endif

static const float
    L1 = 0.4f, /* link length 1 [m] */
    L2 = 0.3f, /* link length 2 [m] */
    L4 = 0.1f, /* x of the tool frame [m] */
    free_limit = 2e-05f, /* a length that fixes no angle */
    longest2 = 0.49f, /* square of the longest reach [m^2] */
    shortest2 = 0.01f, /* square of the shortest reach [m^2] */
    longest2_reach = 0.49000448f, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.00999936f, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.4899999f, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000016f, /* the shortest, where branches merge [m^2] */
    pose_slack = 1e-05f, /* a pose may be rounded by this */
    pose_slack1 = 8e-06f, /* a pose may be rounded by this [m] */
    k1 = 0.25f, /* L1^2 + L2^2 [m^2] */
    k2 = 4.1666665f; /* 1 / (2 * L2 * L1) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const scara_f32_branches[2] = {
    "right", "left",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.268928f, 2.268928f, 2e-06f, 1.0f, 1.0f, 0.09817477f, 1 },
    { -2.5307274f, 2.5307274f, 2e-06f, 1.0f, 1.0f, 0.09817477f, 1 },
    { -0.2f, 0.0f, 1.6e-06f, 1.5625f, 0.8f, 0.00625f, 0 },
    { -6.2831855f, 6.2831855f, 2e-06f, 1.0f, 1.0f, 0.09817477f, 1 },
};

DHGEN_PUBLIC void scara_f32_fk(const float q[4], float T[16])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]);
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 *
        s2;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), x4_x = x2_x * c4 - x2_y * s4,
        x4_y = x2_y * c4 + x2_x * s4;
    T[0] = x4_x; T[1] = -x4_y; T[2] = 0.0f; T[3] = c1 * L1 + x2_x * L2 + x4_x * L4;
    T[4] = x4_y; T[5] = x4_x; T[6] = 0.0f; T[7] = s1 * L1 + x2_y * L2 + x4_y * L4;
    T[8] = 0.0f; T[9] = 0.0f; T[10] = 1.0f; T[11] = q[2];
    T[12] = T[13] = T[14] = 0.0f; T[15] = 1.0f;
}

DHGEN_PUBLIC void scara_f32_jacobian(const float q[4], float J[24])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]), p1_x = c1 * L1, p1_y = s1 * L1;
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 *
        s2,
        p2_x = p1_x + x2_x * L2, p2_y = p1_y + x2_y * L2;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), J21 = p2_x + (x2_x * c4 - x2_y * s4) * L4,
        v1 = p2_y + (x2_y * c4 + x2_x * s4) * L4;
    J[0] = -v1; J[1] = p1_y - v1; J[2] = 0.0f; J[3] = p2_y - v1;
    J[4] = J21; J[5] = J21 - p1_x; J[6] = 0.0f; J[7] = J21 - p2_x;
    J[8] = 0.0f; J[9] = 0.0f; J[10] = 1.0f; J[11] = 0.0f;
    J[12] = 0.0f; J[13] = 0.0f; J[14] = 0.0f; J[15] = 0.0f;
    J[16] = 0.0f; J[17] = 0.0f; J[18] = 0.0f; J[19] = 0.0f;
    J[20] = 1.0f; J[21] = 1.0f; J[22] = 0.0f; J[23] = 1.0f;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const float *T, const float *free_joints, const float *seed, float moved,
    float *rows, unsigned char *status)
{
    float (*const q)[4] = (float (*)[4])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(float);

    /* r3, type 1: U0[3, 4] */
    const float t34 = T34 - L4 * T31;

    /* theta124, type 3: U0[2, 1] and U0[1, 1] */
    const float w124 = sqrtf(T21 * T21 + T11 * T11);
    const int short124 = w124 <= free_limit;
    const float v1 = 1.0f / (short124 ? 1.0f : w124);
    const float c124 = T11 * v1, s124 = T21 * v1;
    const float theta124 = atan2f(s124, c124);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const float t14 = T14 - L4 * T11;
    const float t24 = T24 - L4 * T21;
    const float N2 = t14 * t14 + t24 * t24;
    const float K2 = N2 - k1;
    const float D2_squared = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const float w2 = sqrtf(apart2 ? D2_squared : 0.0f);
    const float c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const float X1_1 = L1 + L2 * c2;
    const float v2 = t24 * X1_1, v3 = t14 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabsf(T33 - 1.0f) <= pose_slack && fabsf(T31) <= pose_slack && fabsf(T23) <= pose_slack &&
        fabsf(T21 - s124) <= pose_slack && fabsf(T11 - c124) <= pose_slack && fabsf(T13) <=
        pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const float e2 = i1 == 0 ? 1.0f : -1.0f;
        /* theta2 */
        if (e2 < 0.0f && !apart2) continue; /* both signs give the same */
        const float s2 = w2 * e2 * k2;
        const float q2 = atan2f(s2, c2);

        /* theta1 */
        const float Y1_1 = L2 * s2;
        const float S1 = v2 - t14 * Y1_1;
        const float C1 = v3 + t24 * Y1_1;
        const float w1 = sqrtf(S1 * S1 + C1 * C1);
        const float factor1 = 1.0f / w1;
        const float c1 = C1 * factor1, s1 = S1 * factor1;
        const float q1 = atan2f(s1, c1);

        /* is the pose one that the arm can take? */
        const float c12 = c2 * c1 - s2 * s1, s12 = c2 * s1 + s2 * c1;
        if (!(fabsf(t14 - (L2 * c12 + L1 * c1)) <= pose_slack1 && fabsf(t24 - (L2 * s12 + L1 * s1))
            <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const float q4 = dhgen_wrap(theta124 - (q2 + q1));
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = t34; q[row][3] = q4;
        status[row] = DHGEN_OK;
    }
}

#ifndef SCARA_F32_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const float
    per_size = 1.25f, /* slides beyond limits count in the arm's size [m^-1] */
    /* -1 * (longest2 - longest2_reach) * (longest2_reach - shortest2) [m^4] */
    m1 = 2.150425e-06f,
    m2 = 1.25f, /* L2 * k2 [m^-1] */
    m3 = 0.0875f, /* L1 - L2 * k1 * k2 [m] */
    m4 = 1e-10f; /* pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* r3 */
    const dhgen_wide t34 = T34 - L4 * T31;

    /* theta124 */
    const dhgen_wide angle1 = dhgen_atan2_wide(T21, T11);

    /* theta2 */
    const dhgen_wide t14 = T14 - L4 * T11, t24 = T24 - L4 * T21, N2 = t14 * t14 + t24 * t24,
        D2_squared = (longest2 - N2) * (N2 - shortest2), w2 = dhgen_sqrt_wide(D2_squared),
        angle2 = dhgen_atan2_wide(w2, N2 - k1);

    /* theta1 */
    const dhgen_wide v1 = m3 + m2 * N2, v2 = t24 * v1, v3 = t14 * v1,
        angle3 = dhgen_atan2_wide(v2 - w2 * (m2 * t14), v3 + w2 * (m2 * t24)),
        angle4 = dhgen_atan2_wide(v2 - w2 * (m2 * -t14), v3 + w2 * (m2 * -t24));

    /* is the pose one that the arm can take? */
    const dhgen_wide v4 = T33 - 1.0f, v5 = T21 * T21 + T11 * T11 - 1.0f;

    /* joint values */
    const dhgen_wide v6 = angle1 - (angle2 + angle3), v7 = angle1 - (angle4 - angle2),
        q3_p = t34 + (w2 - w2),
        v8 = dhgen_maximum_wide(dhgen_exceeds_wide(angle2, joints + 1), per_size *
            dhgen_beyond_wide(t34, joints + 2)),
        excess_p = dhgen_maximum_wide(v8, dhgen_exceeds_wide(angle3, joints)),
        excess_m = dhgen_maximum_wide(v8, dhgen_exceeds_wide(angle4, joints));

    q[0] = angle3; q[1] = angle2; q[2] = q3_p; q[3] = dhgen_centred_wide(v6);
    kind[0] = dhgen_kind_within_wide(q[0], 0.0f < excess_p);
    q[4] = angle4; q[5] = -angle2; q[6] = q3_p; q[7] = dhgen_centred_wide(v7);
    kind[1] = dhgen_kind_within_wide(q[4], 0.0f < excess_m);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0f * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D2_squared) <= m1) | (m4 < v4 * v4 + T31 * T31 + T23 *
        T23 + T13 * T13 + v5 * v5)) | (dhgen_within_slack_wide(excess_p) |
        dhgen_within_slack_wide(excess_m));
}

/* One regular pose where lanes are single numbers. */

#if DHGEN_LANES == 1

#ifndef DHGEN_REGULAR_ROWS
#define DHGEN_REGULAR_ROWS DHGEN_ROWS
#endif

DHGEN_FN int DHGEN_SOLVE_REGULAR(
    const float *T, const float *free_joints, float *q, unsigned char *status)
{
    return dhgen_solve_branches(solve_wide, DHGEN_REGULAR_ROWS, T, free_joints, q, status);
}

#endif
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.25f, 1.25f, 1.25f, 1.0f, 1.0f, 1.0f }, 1.25f, { 1e-06f, 1e-06f }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */ 1, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, scara_f32_fk, scara_f32_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) scara_f32_##function
/* A robot's public functions, whose caller may give values besides the pose. */

#ifndef DHGEN_DO /* coupled drives have others */
#define DHGEN_DO(function) dhgen_##function
#endif

#define DHGEN_AND_GIVEN
#define DHGEN_AND_MANY_GIVEN
#define DHGEN_GIVEN_VALUES NULL
DHGEN_PUBLIC void DHGEN_NAME(joint_velocities)(
    const float q[DHGEN_DOF], const float twist[6], float velocities[DHGEN_DOF])
{
    dhgen_joint_velocities(&arm, q, twist, velocities);
}

DHGEN_PUBLIC int DHGEN_NAME(ik)(const float T[16] DHGEN_AND_GIVEN, const float *q_seed,
    float q[DHGEN_ROWS][DHGEN_DOF], unsigned char status[DHGEN_ROWS])
{
#ifdef DHGEN_SOLVE_WIDE
    const int count = solve_regular(T, DHGEN_GIVEN_VALUES, &q[0][0], status);
    if (count >= 0)
        return count;
    return dhgen_careful_ik(&arm, T, DHGEN_GIVEN_VALUES, q_seed, &q[0][0], status);
#else
    return DHGEN_DO(ik)(&arm, T, DHGEN_GIVEN_VALUES, q_seed, &q[0][0], status);
#endif
}

DHGEN_PUBLIC int DHGEN_NAME(ik_nearest)(
    const float T[16] DHGEN_AND_GIVEN, const float q_seed[DHGEN_DOF], float q[DHGEN_DOF])
{
    return DHGEN_DO(ik_nearest)(&arm, T, DHGEN_GIVEN_VALUES, q_seed, q);
}

DHGEN_PUBLIC void DHGEN_NAME(ik_batch)(
    size_t n, const float *T DHGEN_AND_MANY_GIVEN, float *q, unsigned char *status)
{
#ifdef DHGEN_SOLVE_WIDE
    dhgen_ik_batch(&arm, DHGEN_SOLVE_WIDE, arm.given, n, T, DHGEN_GIVEN_VALUES, q, status);
#else
    DHGEN_DO(ik_each)(&arm, 0, n, T, DHGEN_GIVEN_VALUES, q, status);
#endif
}
