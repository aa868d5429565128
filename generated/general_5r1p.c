/* general_5r1p: General arm with five revolute joints and a slide
 *
 * Inverse kinematics, generated from robots/general_5r1p.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_5r1p.yaml. The formulas and where they come from:
 * general_5r1p.md.
 */
#include "general_5r1p.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = GENERAL_5R1P_OK, NONE = GENERAL_5R1P_UNREACHABLE, FREE = GENERAL_5R1P_FREE_JOINT,
    OUT = GENERAL_5R1P_OUT_OF_LIMITS, INVALID = GENERAL_5R1P_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
#define MISFIT(name, number) \
static inline number misfit_##name(const number T[16]) \
{ \
    const number x0 = T[0], x1 = T[1], x2 = T[2]; \
    const number y0 = T[4], y1 = T[5], y2 = T[6]; \
    const number xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0; \
    const number yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0; \
    const number xy = x0 * y0 + x1 * y1 + x2 * y2; \
    const number zx = x1 * y2 - x2 * y1 - T[8]; \
    const number zy = x2 * y0 - x0 * y2 - T[9]; \
    const number zz = x0 * y1 - x1 * y0 - T[10]; \
    return xx * xx + yy * yy + 2.0 * xy * xy + zx * zx + zy * zy + zz * zz; \
}
MISFIT(one, double)

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 0, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 2.651, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.37721614485099964, 0.37721614485099964, 1.0, 0.37721614485099964, 0.37721614485099964,
    0.37721614485099964,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[6], seed[6]; /* all joint values; the seed in units */
    double e[6], length; /* the miss [arm sizes, rad], and its length */
    double A[6][6]; /* how u moves the tool */
};

/* The rotation vector of an axis times the sine, and the cosine. */
static void turn_vector(const double axis[3], double cosine, double vector[3])
{
    const double sine = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double scale = sine < 1e-09 ? 1.0 : atan2(sine, cosine) / sine;
    const int opposite = sine < 1e-09 && cosine < 0.0; /* any axis will do */
    vector[0] = opposite ? 1.5079644737231006 : scale * axis[0];
    vector[1] = opposite ? 1.8849555921538759 : scale * axis[1];
    vector[2] = opposite ? 2.0106192982974678 : scale * axis[2];
}

/* By how much u misses the pose, and the analytic Jacobian of that. */
static void look(struct descent *d, const double u[6])
{
    double P[16], J[36], square = 0.0;
    for (int j = 0; j < 6; j++)
        d->q[solved[j]] = unit[j] * u[j];
    general_5r1p_fk(d->q, P);
    general_5r1p_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 2.651;
        for (int j = 0; j < 6; j++)
            d->A[i][j] = measure[j] * J[6 * row + solved[j]];
    }
    double R[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[i][j] = d->T[4 * i] * P[4 * j] + d->T[4 * i + 1] * P[4 * j + 1]
                + d->T[4 * i + 2] * P[4 * j + 2];
    const double axis[3] = { 0.5 * (R[2][1] - R[1][2]), 0.5 * (R[0][2] - R[2][0]),
        0.5 * (R[1][0] - R[0][1]) };
    turn_vector(axis, 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0), d->e + 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 6; j++)
            d->A[3 + i][j] = J[6 * (3 + i) + solved[j]];
    for (int i = 0; i < 6; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* What is added from start to start, in parts of the range: a direction that is like no other. */
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};

static void copy(const double from[6], double to[6])
{
    for (int j = 0; j < 6; j++)
        to[j] = from[j];
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[6])
{
    for (int j = 0; j < 6; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

/* Makes a step no longer than it may be. */
static void shorten(double step[6])
{
    double longest = 2.0;
    for (int j = 0; j < 6; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < 6; j++)
        step[j] *= 2.0 / longest;
}

/* The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping. The rows of
 * A, each with its share of the damping's root behind it, are made orthonormal one after another
 * (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994):
 * A A' would lose half of the digits. */
static void damped_step(
    const struct descent *d, const double e[6], double length, double little,
    double step[6])
{
    const double damping = 0.1 * fmin(length * length, 1.0) + little;
    double rows[6][12], y[6], sum[12] = { 0.0 };
    for (int i = 0; i < 6; i++) {
        double square = 0.0;
        for (int j = 0; j < 12; j++)
            rows[i][j] = j < 6 ? d->A[i][j] : j == 6 + i ? sqrt(damping) : 0.0;
        y[i] = e[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < 12; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < 12; j++)
                rows[i][j] -= along * rows[k][j];
            y[i] -= along * y[k];
        }
        for (int j = 0; j < 12; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        y[i] *= inverse;
        for (int j = 0; j < 12; j++)
            rows[i][j] *= inverse;
    }
    for (int i = 6 - 1; i >= 0; i--) {
        double missing = y[i];
        for (int j = 0; j < 12; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < 12; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < 6; j++)
        step[j] = sum[j];
}


/* Takes u to where damped least squares lead; returns by how much that misses the pose. Near to it
 * less damping than usual leads further, where joints hardly move the tool: there a step that is
 * right may be long, and what it leaves, half of its square, far more than was missed. */
static double descend(struct descent *d, double u[6])
{
    double least = HUGE_VAL, little = 1e-13, best[6], step[6];
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    copy(u, best); /* compilers don't know that some miss is finite */
    for (int k = 0; k <= 40; k++) {
        look(d, u);
        const int slow = d->length >= fmax(0.5 * last, left);
        const int stalled = slow && least <= (little < 1e-13 ? 1e-10 : 1e-12);
        if (slow && least <= 1e-06)
            little = 1e-26;
        if (d->length < least) {
            least = d->length;
            copy(u, best);
        }
        if (stalled)
            break;
        damped_step(d, d->e, d->length, little, step);
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 6; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = little < 1e-13 ? 0.5 * way * way : 0.0;
    }
    copy(best, u);
    return least;
}

/* A step with a pull; joints that it would take beyond a limit are put there, and locked. */
static void limited_step(
    struct descent *d, const double u[6], double pull, const double low[6],
    const double high[6], double step[6])
{
    double e[6], wish[6], fixed[6];
    int locked[6], beyond = 1;
    for (int j = 0; j < 6; j++) {
        wish[j] = pull * (fmin(fmax(d->seed[j], low[j]), high[j]) - u[j]);
        locked[j] = 0;
    }
    while (beyond) {
        beyond = 0;
        for (int i = 0; i < 6; i++) {
            e[i] = d->e[i];
            for (int j = 0; j < 6; j++)
                e[i] -= d->A[i][j] * wish[j];
        }
        damped_step(d, e, d->length, 1e-13, step);
        for (int j = 0; j < 6; j++)
            step[j] += wish[j];
        shorten(step);
        for (int j = 0; j < 6; j++) {
            const double end = u[j] + step[j];
            if (locked[j]) {
                step[j] = fixed[j];
            } else if (end < low[j] || end > high[j]) {
                step[j] = fixed[j] = (end < low[j] ? low[j] : high[j]) - u[j];
                beyond = locked[j] = 1;
                wish[j] = 0.0;
                for (int i = 0; i < 6; i++) {
                    d->e[i] -= d->A[i][j] * fixed[j];
                    d->A[i][j] = 0.0;
                }
            }
        }
    }
}

/* Takes u to a solution on the way to the seed; returns by how much it misses the pose. */
static double pulled(
    struct descent *d, double u[6], const double low[6],
    const double high[6])
{
    double least = HUGE_VAL, pull = 0.5, best[6], step[6];
    copy(u, best); /* compilers don't know that some miss is finite */
    for (int k = 1; k <= 60 + 40; k++) {
        look(d, u);
        if (pull == 0.0) {
            if (d->length >= 0.5 * least && least <= 1e-10)
                break;
            if (d->length < least) {
                least = d->length;
                copy(u, best);
            }
        }
        limited_step(d, u, pull, low, high, step);
        double longest = 0.0;
        for (int j = 0; j < 6; j++) {
            longest = fmax(longest, fabs(step[j]));
            u[j] += step[j];
        }
        if (k >= 60 || longest < 1e-09)
            pull = 0.0;
    }
    copy(best, u);
    return least;
}

/* Between which values starts lie. */
static const double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -0.30177291588079974, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 6.283185307179586, 0.6035458317615995, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[6])
{
    for (int j = 0; j < 6; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}
static const double no_lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double no_highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

static const double least_u[6] = {
    -INFINITY, -INFINITY, -0.30177291588079974, -INFINITY, -INFINITY, -INFINITY,
};
static const double most_u[6] = {
    INFINITY, INFINITY, 0.30177291588079974, INFINITY, INFINITY, INFINITY,
};

static double distance_between(const double a[6], const double b[6])
{
    double most = 0.0;
    for (int j = 0; j < 6; j++)
        most = fmax(most, fabs(a[j] - b[j]));
    return most;
}

/* The part of a generic direction that leaves the tool where it is, to first order, one long;
 * returns how long it was. */
static double sideways(const struct descent *d, double along[6])
{
    double moved[6], square = 0.0;
    for (int i = 0; i < 6; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < 6; j++)
            moved[i] += d->A[i][j] * stride[j];
    }
    damped_step(d, moved, 0.0, 1e-13, along);
    for (int j = 0; j < 6; j++) {
        along[j] = stride[j] - along[j];
        square += along[j] * along[j];
    }
    const double length = sqrt(square);
    for (int j = 0; j < 6; j++)
        along[j] /= length;
    return length;
}

/* Whether u is one of a continuum of solutions: 1 if there are others to both sides, that miss the
 * pose by no more than `enough`, 0 if it is a singular solution that stands alone, -1 if it is a
 * regular one. */
static int continuum(struct descent *d, const double u[6], double enough)
{
    double along[6], end[2][6];
    look(d, u);
    if (sideways(d, along) <= 0.0001)
        return -1;
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j < 6; j++)
            end[side][j] = u[j] + (1 - 2 * side) * 0.05 * along[j];
        if (descend(d, end[side]) > enough || distance_between(end[side], u) <= 0.01)
            return 0;
    }
    return distance_between(end[0], end[1]) > 0.01;
}

/* The solutions kept so far. */
struct kept {
    double u[16][6];
    int count, singular[16], chosen[16];
};

/* Whether solutions lie all along the way from one to another: where many roots meet, joint values
 * beside the solution miss the pose by next to nothing. */
static int solves_between(
    struct descent *d, const double u[6], const double way[6], double length)
{
    static const double part[] = { 0.25, 0.5, 0.75 };
    for (int i = 0; i < 3; i++) {
        double start[6], end[6], step[6];
        for (int j = 0; j < 6; j++)
            start[j] = end[j] = u[j] + part[i] * way[j];
        look(d, end);
        for (int k = 0; k < 4 && d->length > 1e-10; k++) {
            damped_step(d, d->e, d->length, 1e-13, step);
            for (int j = 0; j < 6; j++)
                end[j] += step[j];
            look(d, end);
        }
        if (d->length > 1e-10 || distance_between(start, end) > 0.0625 * length)
            return 0;
    }
    return 1;
}

/* Whether a solution is taken for one that is known; loosely where both are singular. */
static int taken_for(
    struct descent *d, const double known[6], const double u[6], int loose)
{
    static const double none[6] = { 0.0 };
    double gap[6];
    for (int j = 0; j < 6; j++)
        gap[j] = u[j] - known[j];
    wrap_angles(gap);
    const double length = distance_between(gap, none);
    if (length < 1e-06)
        return 1;
    return loose && length < 0.1 && solves_between(d, known, gap, length);
}

/* Which of those kept a solution is; -1 for none. */
static int known_as(
    struct descent *d, const struct kept *kept, const double u[6], int singular)
{
    for (int k = 0; k < kept->count; k++)
        if (taken_for(d, kept->u[k], u, singular && kept->singular[k]))
            return k;
    return -1;
}

/* The nearest values inside the limits, whole turns aside, but next to the seed's where they are
 * just beyond an end there; returns how far one was beyond. */
static double clamped(const struct descent *d, const double u[6], double inside[6])
{
    double most = 0.0;
    for (int j = 0; j < 6; j++) {
        const double middle = 0.5 * (least_u[j] + most_u[j]), seen = d->seed[j];
        double near = u[j];
        if (turning[j] && isfinite(middle)) {
            near -= 6.283185307179586 * floor((near - seen) / 6.283185307179586 + 0.5);
            const double past = fmax(least_u[j] - near, near - most_u[j]);
            if (past >= 0.01 || fabs(near - seen) >= 0.15)
                near -= 6.283185307179586 * ceil((near - middle) / 6.283185307179586 - 0.5);
        }
        inside[j] = fmin(fmax(near, least_u[j]), most_u[j]);
        most = fmax(most, fabs(inside[j] - near));
    }
    return most;
}

/* Takes joint values on a way from u to a solution that keeps all limits and is as exact as a row
 * has to be, farther on if steps lead back; returns if it can. */
static int leads_inside(struct descent *d, const double u[6], double end[6])
{
    double way[6], start[6], inside[6];
    copy(end, start);
    for (int j = 0; j < 6; j++)
        way[j] = start[j] - u[j];
    wrap_angles(way);
    for (int k = 0; k < 5; k++) {
        static const double farther_on[] = { 0.0, 1.0, 3.0, 7.0, 15.0 };
        for (int j = 0; j < 6; j++)
            end[j] = start[j] + farther_on[k] * way[j];
        if (descend(d, end) <= 1e-11 && clamped(d, end, inside) <= 1e-09)
            return 1;
    }
    return 0;
}

/* Instead of one that is beyond a limit a solution that keeps all of them, if the way to the seed
 * inside the limits leads to one, from there or from the seed; where it stands alone to one that is
 * taken for it and as exact as a row has to be. */
static void move_inside(
    struct descent *d, const struct kept *kept, int alone, double enough, double u[6])
{
    double end[6];
    if (clamped(d, u, end) <= 1e-09)
        return;
    for (int from_seed = 0; from_seed < 2; from_seed++) {
        (void)clamped(d, from_seed ? d->seed : u, end);
        if (pulled(d, end, least_u, most_u) > enough)
            continue;
        if (alone && !leads_inside(d, u, end))
            continue;
        if (known_as(d, kept, end, 1) < 0 && (!alone || taken_for(d, u, end, 1))) {
            copy(end, u);
            return;
        }
    }
}

/* Of two solutions that are taken for one that inside the limits is kept if it is as exact
 * as a row has to be. */
static int takes_place(struct descent *d, const double u[6], const double known[6])
{
    double end[6];
    if (clamped(d, known, end) <= 1e-09 || clamped(d, u, end) > 1e-09)
        return 0;
    look(d, u);
    return d->length <= 1e-11;
}

/* A solution joins those found before, unless it is one of them. */
static void keep(struct descent *d, struct kept *kept, double u[6])
{
    if (kept->count == 16 || known_as(d, kept, u, 0) >= 0)
        return;
    const double enough = 1e-10;
    const int kind = continuum(d, u, enough);
    if (kind == 1) {
        double end[6];
        copy(u, end);
        (void)pulled(d, end, no_lowest, no_highest);
        if (descend(d, end) <= enough)
            copy(end, u);
    }
    if (kind >= 0)
        move_inside(d, kept, !kind, enough, u);
    wrap_angles(u);
    int k = known_as(d, kept, u, kind >= 0);
    if (k >= 0 && !takes_place(d, u, kept->u[k]))
        return;
    k = k < 0 ? kept->count++ : k;
    kept->singular[k] = kind >= 0;
    kept->chosen[k] = kind == 1;
    copy(u, kept->u[k]);
}

/* Whether a row of joint values stands before another. */
static int stands_before(const double a[6], const double b[6])
{
    for (int i = 0; i < 6; i++)
        if (fabs(a[i] - b[i]) > 1e-09)
            return a[i] < b[i];
    return 0;
}

/* Rows by the first joint, then by the second and so on. */
static void sorted_rows(
    struct descent *d, const struct kept *kept, double q[16][6], int found[16],
    int chosen[16])
{
    for (int row = 0; row < 16; row++)
        found[row] = chosen[row] = 0;
    for (int k = 0; k < kept->count; k++) {
        int row = k;
        for (int j = 0; j < 6; j++)
            d->q[solved[j]] = unit[j] * kept->u[k][j];
        for (; row > 0 && stands_before(d->q, q[row - 1]); row--) {
            chosen[row] = chosen[row - 1];
            for (int i = 0; i < 6; i++)
                q[row][i] = q[row - 1][i];
        }
        found[k] = 1;
        chosen[row] = kept->chosen[k];
        for (int i = 0; i < 6; i++)
            q[row][i] = d->q[i];
    }
}

/* The general 6R algorithm: all solutions, at most 16, of an arm without three concurrent or
 * parallel axes. M. Raghavan and B. Roth (1993): six equations in the hidden joint and two
 * partners, a determinant of degree 8 in the hidden joint; here it is sampled at 24 angles.
 *
 * The loop J(q1) K0 J(q2) ... K4 J(q6) = P, in units of the arm's size, P = L T R. Everything
 * below that has the type general_5r1p_lane does GENERAL_5R1P_LANES angles or candidates at once.
 */
/* Lanes: GNU vectors where the compiler has them, plain doubles otherwise. Vectors wider than the
 * machine's are slow: compile for the machine, or set GENERAL_5R1P_LANES to 1, 2, 4 or 8. */
#ifndef GENERAL_5R1P_LANES
#if defined(__GNUC__) && defined(__AVX512F__)
#define GENERAL_5R1P_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define GENERAL_5R1P_LANES 4
#elif defined(__GNUC__) && defined(__SSE2__)
#define GENERAL_5R1P_LANES 2
#else
#define GENERAL_5R1P_LANES 1
#endif
#endif

#if GENERAL_5R1P_LANES > 1 && defined(__SSE2__)
#include <immintrin.h>
#endif

/* Loops of few rounds over lanes: compilers leave them as they are where there are many operations,
 * and what could stay in registers goes through memory. */
#if GENERAL_5R1P_LANES == 1 || defined(__OPTIMIZE_SIZE__)
#define GENERAL_5R1P_UNROLL
#elif defined(__clang__)
#define GENERAL_5R1P_UNROLL _Pragma("clang loop unroll(full)")
#elif __GNUC__ >= 8
#define GENERAL_5R1P_UNROLL _Pragma("GCC unroll 16")
#else
#define GENERAL_5R1P_UNROLL
#endif

#define GENERAL_5R1P_ROOTS 24
#define GENERAL_5R1P_CANDIDATES 144

#if GENERAL_5R1P_LANES > 1
typedef double general_5r1p_lane __attribute__((vector_size(8 * GENERAL_5R1P_LANES)));
typedef long long general_5r1p_mask __attribute__((vector_size(8 * GENERAL_5R1P_LANES)));
/* the same where it lies between other doubles */
typedef double general_5r1p_packed
    __attribute__((vector_size(8 * GENERAL_5R1P_LANES), aligned(8), may_alias));
/* arrays that begin where a lane may, so that no lane crosses the border of two cache lines */
#define GENERAL_5R1P_ALIGNED __attribute__((aligned(8 * GENERAL_5R1P_LANES)))
#define GENERAL_5R1P_LOAD(from) \
    (general_5r1p_lane)(*(const general_5r1p_packed *)(from))
#define GENERAL_5R1P_STORE(to, x) \
    (*(general_5r1p_packed *)(to) = (general_5r1p_packed)(x))

static inline general_5r1p_lane general_5r1p_select(general_5r1p_mask m, general_5r1p_lane a,
    general_5r1p_lane b)
{
    return (general_5r1p_lane)((m & (general_5r1p_mask)a) | (~m & (general_5r1p_mask)b));
}

static inline general_5r1p_lane general_5r1p_abs(general_5r1p_lane x)
{
    return (general_5r1p_lane)((general_5r1p_mask)x & 0x7fffffffffffffffLL);
}

/* the magnitude of the first with the sign of the second */
static inline general_5r1p_lane general_5r1p_with_sign(general_5r1p_lane x, general_5r1p_lane y)
{
    const general_5r1p_mask sign = (general_5r1p_mask)y & (-0x7fffffffffffffffLL - 1);
    return (general_5r1p_lane)(((general_5r1p_mask)x & 0x7fffffffffffffffLL) | sign);
}

/* the first, turned round where the second is negative */
static inline general_5r1p_lane general_5r1p_facing(general_5r1p_lane x, general_5r1p_lane y)
{
    const general_5r1p_mask sign = (general_5r1p_mask)y & (-0x7fffffffffffffffLL - 1);
    return (general_5r1p_lane)((general_5r1p_mask)x ^ sign);
}

/* by the machine's own instruction: compilers take sqrt of <math.h> one by one, for the sake of
 * errno */
static inline general_5r1p_lane general_5r1p_sqrt(general_5r1p_lane x)
{
#if GENERAL_5R1P_LANES == 8 && defined(__AVX512F__)
    return (general_5r1p_lane)_mm512_sqrt_pd((__m512d)x);
#elif GENERAL_5R1P_LANES == 4 && defined(__AVX__)
    return (general_5r1p_lane)_mm256_sqrt_pd((__m256d)x);
#elif GENERAL_5R1P_LANES == 2 && defined(__SSE2__)
    return (general_5r1p_lane)_mm_sqrt_pd((__m128d)x);
#else
    general_5r1p_lane r = x;
    for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
        r[k] = sqrt(x[k]);
    }
    return r;
#endif
}
#else
typedef double general_5r1p_lane;
typedef int general_5r1p_mask;
#define GENERAL_5R1P_ALIGNED
#define GENERAL_5R1P_LOAD(from) (*(from))
#define GENERAL_5R1P_STORE(to, x) (*(to) = (x))

static inline general_5r1p_lane general_5r1p_select(general_5r1p_mask m, general_5r1p_lane a,
    general_5r1p_lane b)
{
    return m ? a : b;
}

static inline general_5r1p_lane general_5r1p_abs(general_5r1p_lane x)
{
    return fabs(x);
}

static inline general_5r1p_lane general_5r1p_with_sign(general_5r1p_lane x, general_5r1p_lane y)
{
    return copysign(x, y);
}

static inline general_5r1p_lane general_5r1p_facing(general_5r1p_lane x, general_5r1p_lane y)
{
    return y < 0.0 ? -x : x;
}

static inline general_5r1p_lane general_5r1p_sqrt(general_5r1p_lane x)
{
    return sqrt(x);
}
#endif

static inline general_5r1p_lane general_5r1p_all(double x)
{
    const general_5r1p_lane zero = {0};
    return zero + x;
}

static inline general_5r1p_lane general_5r1p_max(general_5r1p_lane a, general_5r1p_lane b)
{
    return general_5r1p_select(a > b, a, b);
}

static inline general_5r1p_lane general_5r1p_min(general_5r1p_lane a, general_5r1p_lane b)
{
    return general_5r1p_select(a < b, a, b);
}

/* the largest of all lanes */
static inline double general_5r1p_largest(general_5r1p_lane x)
{
    double each[GENERAL_5R1P_LANES], most;
    GENERAL_5R1P_STORE(each, x);
    most = each[0];
    for (int k = 1; k < GENERAL_5R1P_LANES; k++) {
        most = each[k] > most ? each[k] : most;
    }
    return most;
}

/* The angle of a sine and a cosine with any positive common factor, in (-pi, pi], within 3 ulp:
 * atan of a ratio below tan(pi/8) by a polynomial. */
static inline general_5r1p_lane general_5r1p_angle(general_5r1p_lane y, general_5r1p_lane x)
{
    static const double odd[] = { -0.3333333333333333, 0.19999999999995513, -0.14285714284665177,
        0.11111111015146682, -0.0909090457366891, 0.07692183087347286, -0.0666450998991572,
        0.05858136252639731, -0.050853834915688644, 0.039229744582632814, -0.01917454359469326 };
    const general_5r1p_lane ax = general_5r1p_abs(x), ay = general_5r1p_abs(y), zero = {0};
    const general_5r1p_mask steep = ay > ax;
    const general_5r1p_lane high = general_5r1p_select(steep, ay, ax), low =
        general_5r1p_select(steep, ax, ay);
    const general_5r1p_mask turned = low > high * 0.41421356237309515;
    const general_5r1p_lane up = general_5r1p_select(turned, low - high, low);
    const general_5r1p_lane down = general_5r1p_select(turned, low + high, high);
    const general_5r1p_lane r = up / (down + 1e-300), u = r * r;
    general_5r1p_lane a = general_5r1p_all(odd[10]);
    for (int k = 9; k >= 0; k--) {
        a = a * u + odd[k];
    }
    a = r + r * u * a + general_5r1p_select(turned, zero + 0.7853981633974483, zero);
    a = general_5r1p_select(steep, 1.5707963267948966 - a, a);
    a = general_5r1p_select(x < 0.0, 3.141592653589793 - a, a);
    return general_5r1p_with_sign(a, y + 0.0);
}

/* The loop: K0 ... K4 and the pose, three rows of four. */
typedef struct {
    double link[6][12];
} general_5r1p_loop;

/* A formulation: the joints phi_1 (hidden) ... phi_6 are, from 0; phi = sign q, -1 reads the loop
 * backwards. */
typedef struct {
    int joint[6];
    double sign;
    const double (*left)[32]; /* the features of the left side if they are constant */
} general_5r1p_formulation;

/* the features of the left side of the formulation that has the joints 4, 3, 2, 1, 0, 5 */
static const double general_5r1p_left_0[15][32] GENERAL_5R1P_ALIGNED = {
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.24870905112736552, 0.0, 0.0, 0.12651414447293255, 0.0, 0.0, 0.22655250811483657,
        0.0, 0.0, -0.011018598099059251, 0.0, 0.0, -0.7447882002747499, 0.0, 0.0,
        0.5791513659701044, 0.0, 0.0, 0.5532900721397139, 0.0, 0.0, -0.5667701303839322, 0.0, 0.0,
        -0.27024825455573015 },
    { 0.0, 0.0, 0.0852716746722396, 0.0, 0.0, 0.043376278105005446, 0.0, 0.0, 0.07767514563937254,
        0.0, 0.0, -0.577176621049957, 0.0, 0.0, 0.6179481405423801, 0.0, 0.0, 0.2616460938450305,
        0.0, 0.0, -0.031047852087247113, 0.0, 0.0, -0.7574440333671859, 0.0, 0.0, 0.6141087655071972
        },
    { 0.0, 0.0, -0.7701080629195963, 0.0, 0.0, -0.3917411219669915, 0.0, 0.0, -0.7015020659000695,
        0.0, 0.0, -0.06746746935694649, 0.0, 0.0, -0.1721084353721203, 0.0, 0.0,
        0.21601018778130363, 0.0, 0.0, 0.17524910203633978, 0.0, 0.0, -0.2669097915318116, 0.0, 0.0,
        -0.0192792476907648 },
    { 0.0, 0.19217576904021408, 0.24376673655014983, 0.0, 0.14976378815403782, 0.055231423748198595,
        0.0, 0.23585687391847515, 0.15443448870960408, 0.0, 0.1338856641476146, -0.3350884568599391,
        0.0, -1.128139758764325, -0.044289869394788406, 0.0, 0.37778915039245686,
        0.44070006447298443, 0.0, 0.7281684082626478, -0.37525203731809514, 0.0,
        -0.17617963630193884, -0.8111788652500196, 0.0, -0.4732537514966397, -0.47664199660469087 },
    { 0.0, 0.06588883509950197, -0.5813900928516845, 0.0, 0.05134758450995583, 0.018936488142239517,
        0.0, 0.08086521391490577, -0.6120182921113002, 0.0, -0.7648467683582046, 0.403553859980258,
        0.0, 0.22376282435196687, 0.8483342314627487, 0.0, 0.480671953738187, 0.4819864360545578,
        0.0, 0.11403629403524808, -0.3365342353018067, 0.0, -1.171413477331292,
        -0.01757698209186534, 0.0, 0.41108318790851184, 0.47687403547602225 },
    { 0.0, -0.5950571905799006, -0.13794987231646266, 0.0, -0.4637318194412772,
        -0.17101977013789732, 0.0, -0.7303123045836065, 0.13866042404748177, 0.0,
        -0.0414502715304995, -0.06353370526067828, 0.0, -0.3395600575691541, 0.07962984957513124,
        0.0, 0.1752316201858067, 0.19569446509516134, 0.0, 0.24779137998150283,
        -0.15845232875643966, 0.0, -0.1866047974793041, -0.2639192528370955, 0.0,
        -0.10732096389343028, -0.10113039304509593 },
    { 1.0, -0.5205198187136566, 0.6956433527164206, 0.0, 0.03215780955882437, 0.7563533020685526,
        1.0, 0.6362579095779857, 0.8824669094148053, 0.0, 0.966058529516632, -0.6150823383608972,
        0.0, -0.7165083400155249, -1.0299888842109166, 0.0, -0.42307732630052225,
        -0.39958029753981555, 0.0, 0.15404175146783905, 0.252084368618516, 0.0, 1.3276871267026962,
        -0.30222342851855094, 0.0, -0.6791166041687385, -0.7589767579423011 },
    { 0.0, 0.9544456308244855, -0.1076559941303642, 0.0, 0.0, 0.2220739197828016, 0.0,
        0.9544456308244855, 0.313792247610572, 0.0, 0.0, 0.34218593038739636, 0.0, 0.0,
        -0.5170811791253253, 0.0, 0.0, -0.04073918616723497, 0.0, 0.0, 0.1287490376094572, 0.0, 0.0,
        0.3390309234933357, 0.0, 0.0, -0.4202547175133888 },
    { 0.0, 0.02767814824338979, 0.39559948783266374, 0.0, -0.053832139347681295, 0.1922691946452119,
        0.0, 0.05798137004843953, 0.4714729158333487, 0.0, 0.2446507457262468, -0.3457589788513976,
        0.0, 0.24330819313532998, -0.7301101922285044, 0.0, -0.14225243836211948,
        -0.5217972212326437, 0.0, -0.11587814389355179, 0.1665080845469617, 0.0,
        0.38889794128929117, 0.22344659030160924, 0.0, 0.16689263323989523, -0.40002613264379866 },
    { 0.0, 0.009489650826305072, 0.13150982961084587, 0.0, -0.018456733490633585,
        0.06382291405921185, 0.0, 0.019879326873750696, 0.15789099281084162, 0.0,
        0.11231968060592441, -0.2558893909398016, 0.0, -0.41455620610499194, -0.003300690354548122,
        0.0, -0.16918982387995027, 0.4004330286486142, 0.0, 0.259478454498484, -0.4474393443919885,
        0.0, 0.24024501784375302, -0.8184358088968569, 0.0, -0.15438954922707288,
        -0.39177204631889057 },
    { 0.0, -0.08570321438765292, 0.36323519726072173, 0.0, 0.16668699578058557, 0.21253315932851868,
        0.0, -0.17953476309377064, -0.013185651901215734, 0.0, 0.09144761038354196,
        -0.2760436165725572, 0.0, 0.032674697380081955, -0.5944021468368006, 0.0,
        -0.0646747787531495, 0.31989461632650085, 0.0, -0.008692002044931455, 0.3658096735225257,
        0.0, 0.1521975143621911, -0.5648461084541366, 0.0, 0.03680347525684355, -0.2156175472821148
        },
    { -0.11813359509417001, -0.6556766283396306, 0.4616011547252208, -0.15936864204575796,
        -0.017481933079677464, 0.33297412689926253, -0.22367261750798376, -0.512917104313085,
        -0.09250555017925008, -0.2665917724505097, 0.7829578259673093, -0.39961721624036184,
        1.4087079271492478, 0.20976496983567083, -0.5068368624126304, -0.14200704195984548,
        -0.7864854730974481, 0.1565625406762441, -0.8367042394016948, 0.5739269618879299,
        0.30402249721322505, -0.230462362166667, 1.6807372384351678, -0.20656062613022766,
        0.6331416962187989, 1.0793012273549571, 0.01850354160907547 },
    { -0.04050294688942972, 1.0454647355675089, 0.012968656458864625, -0.0546406772728313,
        -0.007779175655078227, 0.40813099044861034, -0.07668775457416585, 1.0954158797120113,
        0.3873617828997886, 0.8828326915694746, -0.5973042812143853, 0.03081882281349993,
        0.19080924045501668, -1.5579038644691439, -0.7319791806190185, -0.655904398365533,
        -1.0815213916813768, -0.1524969064650376, -0.24873073728196488, 0.6792908144564235,
        0.07714439889019778, 1.4786569172883526, 0.1859476622176225, -0.030201918992694088,
        -0.17060433970216304, -0.7623410606837816, -0.33070886563520074 },
    { 0.3657914083597624, 0.49925474349848703, -0.4804440872255769, 0.493472495913041,
        0.7416417400659627, -0.7753873452273587, 0.6925847105942989, -0.3298026562950181,
        -0.7764420408903903, 0.01165659176060114, -0.18925671671456168, 0.5074760139580224,
        0.4760747913266595, -0.24396652282800818, 0.8831426297480226, -0.11848792075597424,
        -0.10880895118704931, 0.35941126059490164, -0.29775769792229073, 0.2991973760149577,
        -0.0708161912589207, 0.08929847575820803, -0.06178505820155644, 0.23199618774012268,
        0.18558480247714898, 0.11070064098139087, 0.6954237268885941 },
};

/* the features of the left side of the formulation that has the joints 3, 2, 1, 0, 5, 4 */
static const double general_5r1p_left_1[15][32] GENERAL_5R1P_ALIGNED = {
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.12077263550238015, -0.19250983049270745, 0.11488165253823089,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.12386093604119919, -1.80377222040283, -0.11651359831946617,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.8594571839909242, 0.04528965847612587, 0.8695383694961355
        },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.11502155762131444, -0.18334269570734044, 0.10941109765545799,
        -0.0, -0.0, -0.0, -0.0, -0.0, -0.0, 0.8494819454593607, 0.10693146430901368,
        -0.8601888994148241, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.19647198937935156, -1.8086005265510094,
        -0.18997145204784183 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3890399898528032, 0.6201241050169165, -0.37006360548342754,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.28960454235575217, -0.5283438892702257, -0.2904892153706974,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.20871991847262153, -0.5206618947838805, 0.2137714127224597
        },
    { 0.0, 0.0, 0.0, 0.21738130116461452, 0.0, 0.21738130116461452, -0.34531030238518584,
        -0.10368477239969981, -0.42973014286140104, 0.0, 0.0, 0.0, -0.5495447761950757, 0.0,
        -0.5495447761950757, 0.4673843320080865, 0.10432640928815357, -0.32536674928722836, 0.0,
        0.0, 0.0, -0.28877535077690186, 0.0, -0.28877535077690186, -0.4432753361452154,
        -0.7596891890715296, -0.4221343835301784 },
    { 0.0, 0.0, 0.0, 0.20702981063296622, 0.0, 0.20702981063296622, 0.25823630858671537,
        -0.0987474022854284, 0.17783646051412944, 0.0, 0.0, 0.0, 0.3353203676037254, 0.0,
        0.3353203676037254, 0.40407316573952273, 0.7513071275045836, 0.4498321326403618, 0.0, 0.0,
        0.0, -0.5254772442023238, 0.0, -0.5254772442023238, 0.5050593168741961, 0.1685057103974908,
        -0.2899181375247866 },
    { 0.0, 0.0, 0.0, -0.700241564220929, 0.0, -0.700241564220929, -0.18130399908531547,
        0.3339955498567758, 0.0906342073273016, 0.0, 0.0, 0.0, -0.0714602629262648, 0.0,
        -0.0714602629262648, 0.26455985289433587, 0.2545144305017762, 0.031988980754549354, 0.0,
        0.0, 0.0, -0.2450066157471936, 0.0, -0.2450066157471936, 0.011713908177640469,
        -0.18601654877744095, -0.2167620810081511 },
    { 1.0, 0.0, 1.0, -0.06980993031443444, -0.20090294438586964, 0.4145836890961123,
        0.6705114889310473, 0.738852810916113, 0.5337441258969509, 0.0, 0.0, 0.0,
        0.5786227964205345, 0.0, 0.5786227964205345, -0.21002404324690793, 0.2236906224174515,
        0.4454314997234631, 0.0, 0.0, 0.0, 0.016880958292714944, 0.0, 0.016880958292714944,
        0.5627368311471909, 0.6791366808305508, 0.2203995882681725 },
    { 0.0, 0.0, 0.0, -0.12640232387595318, 0.5508233780105449, 0.10310741696177382,
        0.4192280417897504, -0.1542560832251843, -0.42177465843733974, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.12409016284601762, 0.7462655774932121, -0.1292318037666097, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.38535737727688574, -0.3882872256521799, -0.3880756958366243 },
    { 0.0, 0.0, 0.0, 0.15781450477608033, -0.16952311661666142, -0.15887627540145766,
        -0.02810701179045348, -0.11350502133408474, -0.1788820069836507, 0.0, 0.0, 0.0,
        0.7770329014884426, 0.16033344610082545, -0.7787512661227827, 0.4164315884935167,
        0.19127243112828446, -0.1436634851932712, 0.0, 0.0, 0.0, -0.13824609635124002,
        -1.7450310744087272, 0.13249759470612732, 0.17955771958406036, -0.147863871272993,
        0.18623859184948577 },
    { 0.0, 0.0, 0.0, 0.15029952835817173, -0.16145058725396325, -0.15131073847757873,
        0.0536480837756194, 0.020082980404183104, -0.24685796150039147, 0.0, 0.0, 0.0,
        0.07273815060205735, 1.7324711288326626, -0.06684140639731662, -0.1362358374056878,
        -0.1961070754475417, -0.25212353502104035, 0.0, 0.0, 0.0, 0.7891347045905631,
        0.3077111968791556, -0.7903688282385748, 0.2547869990518521, 0.09394879736130263,
        -0.010444617452681451 },
    { 0.0, 0.0, 0.0, -0.5083614602042982, 0.5460779363969562, 0.511781698833724, 0.4178916795072798,
        0.8874229891335501, 0.26484103329769204, 0.0, 0.0, 0.0, 0.26272560516011556,
        0.5619870098695715, -0.2615156491402768, -0.3302785510719178, 0.42386165600367487,
        0.3030932726175973, 0.0, 0.0, 0.0, 0.19039471371262542, -0.45074692911050374,
        -0.19254413932431647, 0.2660828129218096, 0.7938243338255819, -0.0858790782048065 },
    { -0.06581763223360872, -0.4319872357403486, 0.07005440362048522, -0.05307463179130399,
        0.23547440742889345, 0.11016188802256002, 0.06653871377586804, -0.554845930001894,
        -0.43717545186532847, -0.015066537528697133, -1.198368000419189, -0.0031893135628455194,
        0.4464478066965865, -0.9928612361793451, -0.3221190094456863, -0.19776667536397807,
        -0.5066794641614392, -0.3965490439940179, -0.932460934823512, 0.36341808687835214,
        0.9290881304978085, 0.020484296563562723, 0.5422579943501633, 0.3746106587590728,
        -0.006436479062752493, -0.483036205477223, -0.20019595340244822 },
    { -0.06268345927010355, -0.41141641499080817, 0.06671847963855736, 0.3080372824910819,
        -0.6482735807356891, -0.2277293988833682, -0.5723377225227512, -0.6674414515770604,
        -0.058478640261587334, 0.9342524928754603, -0.26247313088942975, -0.9293369333314092,
        -0.3562369244009089, -0.7449745532368224, -0.049705651730583916, 0.1908579214660936,
        -0.1540770883709623, 0.015034218423113616, 0.06362889975714059, -1.2297102251126175,
        -0.08161024940405603, 0.3930526351886492, -0.4314485175347455, -0.2997061753949928,
        -0.5554867307083976, -0.9576344911862428, -0.18381421628374486 },
    { 0.2120156678686873, 1.3915429526720364, -0.22566340761124348, 0.6994352727713892,
        -0.25236970216123533, -0.9493543053981358, 0.28638875647571893, 0.08498597995375859,
        -0.24218991144753305, 0.27153905575841913, -0.4496199224330919, -0.2757530491192246,
        0.5054745660038631, 1.1334961059198734, -0.5824231479713695, -0.06435031134536345,
        -0.1275703884890932, -0.2694749720693336, -0.27065872966347754, -0.25075115134227904,
        0.2642954112989377, 0.7692132140246999, -0.590559561449677, -0.6230899587648827,
        0.20889009735527928, -0.12877584124517621, -0.0799662696647502 },
};

static const general_5r1p_formulation general_5r1p_formulations[2] = {
    { { 4, 3, 2, 1, 0, 5 }, -1.0, general_5r1p_left_0 },
    { { 3, 2, 1, 0, 5, 4 }, -1.0, general_5r1p_left_1 },
};

/* Whether a joint is a slide, whose length stands in the sine's place. */
static inline int general_5r1p_slides(int joint)
{
    return joint == 2;
}

/* The constants K0 ... K4 of the loop, L and R, three rows of four; for those with joints inside
 * whose values are given, what stands before, between and behind these. */
static const double general_5r1p_constant[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.43936788242416075, -0.011264649500846345,
        -0.004693603958685977, -0.9999255361043152, 0.058795324397600594, 0.9230081871732141,
        0.38458674465550585, -0.01220337029258354, -4.6235725321515234e-10 },
    { 0.6145349462240683, -0.7888895992909156, 0.0, -0.00632184003488001, 0.7529522312460936,
        0.5865401944125223, 0.29838488198977153, 0.060080385216903724, -0.235392729987378,
        -0.18336793740765922, 0.9544456308244855, -0.058790946321855296 },
    { 0.28, -0.96, 0.0, 0.3650862620143206, -0.7314004443085399, -0.21332512958999084,
        0.647723536048123, -0.13871905921788164, -0.6218145946061981, -0.18136259009347447,
        -0.7618754628213957, -0.038185682994733766 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.4251437423456807, 0.6655569082924576,
        0.633863722183293, 0.3940187603707805, 0.13757420646323018, -0.2853239299236686,
        -0.27173707611777964, 0.9191023971657748, -0.0607588648632754 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.629023083470561, 0.8952109992393914,
        0.3069294854535056, 0.323096824187513, 0.0047942638808703055, -0.305632130988188,
        -0.10478815919595016, 0.9463659134816423, -0.0016367997061155746 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, 0.29254598344443916 },
    { 1.0, 0.0, 0.0, -0.357, 0.0, -0.7427737668732654, 0.6695424790443845, -0.018486934316693265,
        0.0, -0.6695424790443845, -0.7427737668732654, 0.020508944943937776 },
};

/* cosine and sine of what is to be added to each joint's angle in the loop */
static const double general_5r1p_advance[2][6] = {
    { 0.6, 0.38461538461538464, 1.0, 0.28, 0.6896551724137931, 0.32432432432432434 },
    { 0.8, 0.9230769230769231, 0.0, 0.96, 0.7241379310344828, 0.9459459459459459 },
};

/* poses close by, for those at which the formulations fail */
static const double general_5r1p_nudge[10][12] = {
    { 0.9999995580001719, -0.000580303174204035, -0.00073976191215864, 0.0005300000000000001,
        0.0005796963744401407, 0.9999994956001963, -0.0008202142808546233, 0.00071,
        0.0007402375119735841, 0.0008197850810216249, 0.9999993900002373, -0.00047 },
    { 0.9999995580001719, 0.0005796963744401407, 0.0007402375119735841, -0.0005300000000000001,
        -0.000580303174204035, 0.9999994956001963, 0.0008197850810216249, -0.00071,
        -0.00073976191215864, -0.0008202142808546233, 0.9999993900002373, 0.00047 },
    { 0.9999949420151998, -0.0018617746051811336, 0.002578708850722032, -0.00183,
        0.0018582142158804597, 0.9999973180080597, 0.001382395245764047, 0.00087,
        -0.0025812756430085644, -0.0013775964601848774, 0.999995719612863, 0.00201 },
    { 0.9999949420151998, 0.0018582142158804597, -0.0025812756430085644, 0.00183,
        -0.0018617746051811336, 0.9999973180080597, -0.0013775964601848774, -0.00087,
        0.002578708850722032, 0.001382395245764047, 0.999995719612863, -0.00201 },
    { 0.9999377228865443, 0.009025321676340304, 0.00656459573098787, 0.0059, -0.008973844062327714,
        0.9999290832869896, -0.007829337110224942, -0.0043, -0.0066347924773686754,
        0.007769939863287338, 0.9999478024193579, 0.0031 },
    { 0.9999377228865443, -0.008973844062327714, -0.0066347924773686754, -0.0059,
        0.009025321676340304, 0.9999290832869896, 0.007769939863287338, 0.0043, 0.00656459573098787,
        -0.007829337110224942, 0.9999478024193579, -0.0031 },
    { 0.9996484117295773, 0.020763800426894047, 0.01648992172102878, 0.011099999999999999,
        -0.021220469326757335, 0.9993821115042827, 0.028019401970663643, 0.0183,
        -0.015897943517502292, -0.028359474555668215, 0.9994713580662733, 0.017099999999999997 },
    { 0.9996484117295773, -0.021220469326757335, -0.015897943517502292, -0.011099999999999999,
        0.020763800426894047, 0.9993821115042827, -0.028359474555668215, -0.0183,
        0.01648992172102878, 0.028019401970663643, 0.9994713580662733, -0.017099999999999997 },
    { 0.999472790696877, -0.013504055448103867, 0.029525940172180323, -0.0153, 0.014085964965612287,
        0.9997088653063301, -0.01959005408153817, -0.0201, -0.02925279897008453,
        0.019995627381619797, 0.9993720271440617, 0.012299999999999998 },
    { 0.999472790696877, 0.014085964965612287, -0.02925279897008453, 0.0153, -0.013504055448103867,
        0.9997088653063301, 0.019995627381619797, 0.0201, 0.029525940172180323,
        -0.01959005408153817, 0.9993720271440617, -0.012299999999999998 },
};

/* cosines and sines of the 24 angles at which the determinant is sampled */
static const double general_5r1p_sample_c[24] GENERAL_5R1P_ALIGNED = {
    1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386,
        0.9659258262890682
};

static const double general_5r1p_sample_s[24] GENERAL_5R1P_ALIGNED = {
    0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0,
        0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207
};

/* from the samples to a_0, a_1 ... a_8, b_1 ... b_8 and seven numbers that would be zero without
 * rounding: one row for each sample */
static const double general_5r1p_harmonics[24][24] GENERAL_5R1P_ALIGNED = {
    { 0.041666666666666664, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333,
        0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333,
        0.08333333333333333, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.08333333333333333,
        0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.0, 0.0, 0.0 },
    { 0.041666666666666664, 0.08049381885742235, 0.07216878364870322, 0.05892556509887897,
        0.041666666666666664, 0.02156825375854339, -0.0, -0.02156825375854339,
        -0.041666666666666664, 0.02156825375854339, 0.041666666666666664, 0.05892556509887897,
        0.07216878364870322, 0.08049381885742235, 0.08333333333333333, 0.08049381885742235,
        0.07216878364870322, -0.05892556509887897, -0.07216878364870322, -0.08049381885742235,
        -0.08333333333333333, 0.05892556509887897, 0.041666666666666664, 0.02156825375854339 },
    { 0.041666666666666664, 0.07216878364870322, 0.041666666666666664, -0.0, -0.041666666666666664,
        -0.07216878364870322, -0.08333333333333333, -0.07216878364870322, -0.041666666666666664,
        0.041666666666666664, 0.07216878364870322, 0.08333333333333333, 0.07216878364870322,
        0.041666666666666664, -0.0, -0.041666666666666664, -0.07216878364870322, 0.0,
        0.041666666666666664, 0.07216878364870322, 0.08333333333333333, -0.08333333333333333,
        -0.07216878364870322, -0.041666666666666664 },
    { 0.041666666666666664, 0.05892556509887897, -0.0, -0.05892556509887897, -0.08333333333333333,
        -0.05892556509887897, 0.0, 0.05892556509887897, 0.08333333333333333, 0.05892556509887897,
        0.08333333333333333, 0.05892556509887897, -0.0, -0.05892556509887897, -0.08333333333333333,
        -0.05892556509887897, 0.0, 0.05892556509887897, -0.0, -0.05892556509887897,
        -0.08333333333333333, 0.05892556509887897, 0.08333333333333333, 0.05892556509887897 },
    { 0.041666666666666664, 0.041666666666666664, -0.041666666666666664, -0.08333333333333333,
        -0.041666666666666664, 0.041666666666666664, 0.08333333333333333, 0.041666666666666664,
        -0.041666666666666664, 0.07216878364870322, 0.07216878364870322, -0.0, -0.07216878364870322,
        -0.07216878364870322, 0.0, 0.07216878364870322, 0.07216878364870322, -0.08333333333333333,
        -0.041666666666666664, 0.041666666666666664, 0.08333333333333333, -0.0,
        -0.07216878364870322, -0.07216878364870322 },
    { 0.041666666666666664, 0.02156825375854339, -0.07216878364870322, -0.05892556509887897,
        0.041666666666666664, 0.08049381885742235, -0.0, -0.08049381885742235,
        -0.041666666666666664, 0.08049381885742235, 0.041666666666666664, -0.05892556509887897,
        -0.07216878364870322, 0.02156825375854339, 0.08333333333333333, 0.02156825375854339,
        -0.07216878364870322, 0.05892556509887897, 0.07216878364870322, -0.02156825375854339,
        -0.08333333333333333, -0.05892556509887897, 0.041666666666666664, 0.08049381885742235 },
    { 0.041666666666666664, -0.0, -0.08333333333333333, 0.0, 0.08333333333333333, -0.0,
        -0.08333333333333333, 0.0, 0.08333333333333333, 0.08333333333333333, -0.0,
        -0.08333333333333333, 0.0, 0.08333333333333333, -0.0, -0.08333333333333333, 0.0, -0.0,
        -0.08333333333333333, 0.0, 0.08333333333333333, 0.08333333333333333, -0.0,
        -0.08333333333333333 },
    { 0.041666666666666664, -0.02156825375854339, -0.07216878364870322, 0.05892556509887897,
        0.041666666666666664, -0.08049381885742235, 0.0, 0.08049381885742235, -0.041666666666666664,
        0.08049381885742235, -0.041666666666666664, -0.05892556509887897, 0.07216878364870322,
        0.02156825375854339, -0.08333333333333333, 0.02156825375854339, 0.07216878364870322,
        -0.05892556509887897, 0.07216878364870322, 0.02156825375854339, -0.08333333333333333,
        -0.05892556509887897, -0.041666666666666664, 0.08049381885742235 },
    { 0.041666666666666664, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333,
        -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, -0.041666666666666664,
        -0.041666666666666664, 0.07216878364870322, -0.07216878364870322, 0.0, 0.07216878364870322,
        -0.07216878364870322, 0.0, 0.07216878364870322, -0.07216878364870322, 0.08333333333333333,
        -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, 0.0, 0.07216878364870322,
        -0.07216878364870322 },
    { 0.041666666666666664, -0.05892556509887897, 0.0, 0.05892556509887897, -0.08333333333333333,
        0.05892556509887897, -0.0, -0.05892556509887897, 0.08333333333333333, 0.05892556509887897,
        -0.08333333333333333, 0.05892556509887897, -0.0, -0.05892556509887897, 0.08333333333333333,
        -0.05892556509887897, 0.0, -0.05892556509887897, 0.0, 0.05892556509887897,
        -0.08333333333333333, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897 },
    { 0.041666666666666664, -0.07216878364870322, 0.041666666666666664, -0.0, -0.041666666666666664,
        0.07216878364870322, -0.08333333333333333, 0.07216878364870322, -0.041666666666666664,
        0.041666666666666664, -0.07216878364870322, 0.08333333333333333, -0.07216878364870322,
        0.041666666666666664, -0.0, -0.041666666666666664, 0.07216878364870322, 0.0,
        0.041666666666666664, -0.07216878364870322, 0.08333333333333333, -0.08333333333333333,
        0.07216878364870322, -0.041666666666666664 },
    { 0.041666666666666664, -0.08049381885742235, 0.07216878364870322, -0.05892556509887897,
        0.041666666666666664, -0.02156825375854339, 0.0, 0.02156825375854339, -0.041666666666666664,
        0.02156825375854339, -0.041666666666666664, 0.05892556509887897, -0.07216878364870322,
        0.08049381885742235, -0.08333333333333333, 0.08049381885742235, -0.07216878364870322,
        0.05892556509887897, -0.07216878364870322, 0.08049381885742235, -0.08333333333333333,
        0.05892556509887897, -0.041666666666666664, 0.02156825375854339 },
    { 0.041666666666666664, -0.08333333333333333, 0.08333333333333333, -0.08333333333333333,
        0.08333333333333333, -0.08333333333333333, 0.08333333333333333, -0.08333333333333333,
        0.08333333333333333, -0.0, 0.0, -0.0, 0.0, -0.0, 0.0, -0.0, 0.0, -0.08333333333333333,
        0.08333333333333333, -0.08333333333333333, 0.08333333333333333, -0.0, 0.0, -0.0 },
    { 0.041666666666666664, -0.08049381885742235, 0.07216878364870322, -0.05892556509887897,
        0.041666666666666664, -0.02156825375854339, -0.0, 0.02156825375854339,
        -0.041666666666666664, -0.02156825375854339, 0.041666666666666664, -0.05892556509887897,
        0.07216878364870322, -0.08049381885742235, 0.08333333333333333, -0.08049381885742235,
        0.07216878364870322, 0.05892556509887897, -0.07216878364870322, 0.08049381885742235,
        -0.08333333333333333, -0.05892556509887897, 0.041666666666666664, -0.02156825375854339 },
    { 0.041666666666666664, -0.07216878364870322, 0.041666666666666664, 0.0, -0.041666666666666664,
        0.07216878364870322, -0.08333333333333333, 0.07216878364870322, -0.041666666666666664,
        -0.041666666666666664, 0.07216878364870322, -0.08333333333333333, 0.07216878364870322,
        -0.041666666666666664, -0.0, 0.041666666666666664, -0.07216878364870322, -0.0,
        0.041666666666666664, -0.07216878364870322, 0.08333333333333333, 0.08333333333333333,
        -0.07216878364870322, 0.041666666666666664 },
    { 0.041666666666666664, -0.05892556509887897, -0.0, 0.05892556509887897, -0.08333333333333333,
        0.05892556509887897, 0.0, -0.05892556509887897, 0.08333333333333333, -0.05892556509887897,
        0.08333333333333333, -0.05892556509887897, -0.0, 0.05892556509887897, -0.08333333333333333,
        0.05892556509887897, 0.0, -0.05892556509887897, -0.0, 0.05892556509887897,
        -0.08333333333333333, -0.05892556509887897, 0.08333333333333333, -0.05892556509887897 },
    { 0.041666666666666664, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333,
        -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, -0.041666666666666664,
        -0.041666666666666664, -0.07216878364870322, 0.07216878364870322, 0.0, -0.07216878364870322,
        0.07216878364870322, 0.0, -0.07216878364870322, 0.07216878364870322, 0.08333333333333333,
        -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, 0.0,
        -0.07216878364870322, 0.07216878364870322 },
    { 0.041666666666666664, -0.02156825375854339, -0.07216878364870322, 0.05892556509887897,
        0.041666666666666664, -0.08049381885742235, -0.0, 0.08049381885742235,
        -0.041666666666666664, -0.08049381885742235, 0.041666666666666664, 0.05892556509887897,
        -0.07216878364870322, -0.02156825375854339, 0.08333333333333333, -0.02156825375854339,
        -0.07216878364870322, -0.05892556509887897, 0.07216878364870322, 0.02156825375854339,
        -0.08333333333333333, 0.05892556509887897, 0.041666666666666664, -0.08049381885742235 },
    { 0.041666666666666664, 0.0, -0.08333333333333333, -0.0, 0.08333333333333333, 0.0,
        -0.08333333333333333, -0.0, 0.08333333333333333, -0.08333333333333333, -0.0,
        0.08333333333333333, 0.0, -0.08333333333333333, -0.0, 0.08333333333333333, 0.0, 0.0,
        -0.08333333333333333, -0.0, 0.08333333333333333, -0.08333333333333333, -0.0,
        0.08333333333333333 },
    { 0.041666666666666664, 0.02156825375854339, -0.07216878364870322, -0.05892556509887897,
        0.041666666666666664, 0.08049381885742235, 0.0, -0.08049381885742235, -0.041666666666666664,
        -0.08049381885742235, -0.041666666666666664, 0.05892556509887897, 0.07216878364870322,
        -0.02156825375854339, -0.08333333333333333, -0.02156825375854339, 0.07216878364870322,
        0.05892556509887897, 0.07216878364870322, -0.02156825375854339, -0.08333333333333333,
        0.05892556509887897, -0.041666666666666664, -0.08049381885742235 },
    { 0.041666666666666664, 0.041666666666666664, -0.041666666666666664, -0.08333333333333333,
        -0.041666666666666664, 0.041666666666666664, 0.08333333333333333, 0.041666666666666664,
        -0.041666666666666664, -0.07216878364870322, -0.07216878364870322, -0.0,
        0.07216878364870322, 0.07216878364870322, 0.0, -0.07216878364870322, -0.07216878364870322,
        -0.08333333333333333, -0.041666666666666664, 0.041666666666666664, 0.08333333333333333,
        -0.0, 0.07216878364870322, 0.07216878364870322 },
    { 0.041666666666666664, 0.05892556509887897, 0.0, -0.05892556509887897, -0.08333333333333333,
        -0.05892556509887897, -0.0, 0.05892556509887897, 0.08333333333333333, -0.05892556509887897,
        -0.08333333333333333, -0.05892556509887897, -0.0, 0.05892556509887897, 0.08333333333333333,
        0.05892556509887897, 0.0, 0.05892556509887897, 0.0, -0.05892556509887897,
        -0.08333333333333333, -0.05892556509887897, -0.08333333333333333, -0.05892556509887897 },
    { 0.041666666666666664, 0.07216878364870322, 0.041666666666666664, 0.0, -0.041666666666666664,
        -0.07216878364870322, -0.08333333333333333, -0.07216878364870322, -0.041666666666666664,
        -0.041666666666666664, -0.07216878364870322, -0.08333333333333333, -0.07216878364870322,
        -0.041666666666666664, -0.0, 0.041666666666666664, 0.07216878364870322, -0.0,
        0.041666666666666664, 0.07216878364870322, 0.08333333333333333, 0.08333333333333333,
        0.07216878364870322, 0.041666666666666664 },
    { 0.041666666666666664, 0.08049381885742235, 0.07216878364870322, 0.05892556509887897,
        0.041666666666666664, 0.02156825375854339, 0.0, -0.02156825375854339, -0.041666666666666664,
        -0.02156825375854339, -0.041666666666666664, -0.05892556509887897, -0.07216878364870322,
        -0.08049381885742235, -0.08333333333333333, -0.08049381885742235, -0.07216878364870322,
        -0.05892556509887897, -0.07216878364870322, -0.08049381885742235, -0.08333333333333333,
        -0.05892556509887897, -0.041666666666666664, -0.02156825375854339 },
};

/* cosines and sines of m phi, m = 1 ... 8, at 128 angles of half the circle */
static const double general_5r1p_grid_c[8][128] GENERAL_5R1P_ALIGNED = {
    { 1.0, 0.9996988186962042, 0.9987954562051724, 0.9972904566786902, 0.9951847266721969,
        0.99247953459871, 0.989176509964781, 0.9852776423889412, 0.9807852804032304,
        0.9757021300385286, 0.970031253194544, 0.9637760657954398, 0.9569403357322088,
        0.9495281805930367, 0.9415440651830208, 0.9329927988347388, 0.9238795325112867,
        0.9142097557035307, 0.9039892931234433, 0.8932243011955153, 0.881921264348355,
        0.8700869911087115, 0.8577286100002721, 0.8448535652497071, 0.8314696123025452,
        0.8175848131515837, 0.8032075314806449, 0.7883464276266062, 0.773010453362737,
        0.7572088465064846, 0.7409511253549591, 0.7242470829514669, 0.7071067811865476,
        0.6895405447370669, 0.6715589548470184, 0.6531728429537768, 0.6343932841636455,
        0.6152315905806268, 0.5956993044924334, 0.5758081914178453, 0.5555702330196022,
        0.5349976198870973, 0.5141027441932218, 0.49289819222978404, 0.47139673682599764,
        0.4496113296546066, 0.4275550934302821, 0.40524131400498986, 0.3826834323650898,
        0.35989503653498817, 0.33688985339222005, 0.31368174039889146, 0.2902846772544624,
        0.26671275747489837, 0.2429801799032639, 0.2191012401568698, 0.19509032201612828,
        0.17096188876030122, 0.14673047445536175, 0.1224106751992162, 0.0980171403295606,
        0.07356456359966743, 0.049067674327418015, 0.024541228522912288, 0.0, -0.024541228522912288,
        -0.049067674327418015, -0.07356456359966743, -0.0980171403295606, -0.1224106751992162,
        -0.14673047445536175, -0.17096188876030122, -0.19509032201612828, -0.2191012401568698,
        -0.2429801799032639, -0.26671275747489837, -0.2902846772544624, -0.31368174039889146,
        -0.33688985339222005, -0.35989503653498817, -0.3826834323650898, -0.40524131400498986,
        -0.4275550934302821, -0.4496113296546066, -0.47139673682599764, -0.49289819222978404,
        -0.5141027441932218, -0.5349976198870973, -0.5555702330196022, -0.5758081914178453,
        -0.5956993044924334, -0.6152315905806268, -0.6343932841636455, -0.6531728429537768,
        -0.6715589548470184, -0.6895405447370669, -0.7071067811865476, -0.7242470829514669,
        -0.7409511253549591, -0.7572088465064846, -0.773010453362737, -0.7883464276266062,
        -0.8032075314806449, -0.8175848131515837, -0.8314696123025452, -0.8448535652497071,
        -0.8577286100002721, -0.8700869911087115, -0.881921264348355, -0.8932243011955153,
        -0.9039892931234433, -0.9142097557035307, -0.9238795325112867, -0.9329927988347388,
        -0.9415440651830208, -0.9495281805930367, -0.9569403357322088, -0.9637760657954398,
        -0.970031253194544, -0.9757021300385286, -0.9807852804032304, -0.9852776423889412,
        -0.989176509964781, -0.99247953459871, -0.9951847266721969, -0.9972904566786902,
        -0.9987954562051724, -0.9996988186962042 },
    { 1.0, 0.9987954562051724, 0.9951847266721969, 0.989176509964781, 0.9807852804032304,
        0.970031253194544, 0.9569403357322088, 0.9415440651830208, 0.9238795325112867,
        0.9039892931234433, 0.881921264348355, 0.8577286100002721, 0.8314696123025452,
        0.8032075314806449, 0.773010453362737, 0.7409511253549591, 0.7071067811865476,
        0.6715589548470184, 0.6343932841636455, 0.5956993044924334, 0.5555702330196022,
        0.5141027441932218, 0.47139673682599764, 0.4275550934302821, 0.3826834323650898,
        0.33688985339222005, 0.2902846772544624, 0.2429801799032639, 0.19509032201612828,
        0.14673047445536175, 0.0980171403295606, 0.049067674327418015, 0.0, -0.049067674327418015,
        -0.0980171403295606, -0.14673047445536175, -0.19509032201612828, -0.2429801799032639,
        -0.2902846772544624, -0.33688985339222005, -0.3826834323650898, -0.4275550934302821,
        -0.47139673682599764, -0.5141027441932218, -0.5555702330196022, -0.5956993044924334,
        -0.6343932841636455, -0.6715589548470184, -0.7071067811865476, -0.7409511253549591,
        -0.773010453362737, -0.8032075314806449, -0.8314696123025452, -0.8577286100002721,
        -0.881921264348355, -0.9039892931234433, -0.9238795325112867, -0.9415440651830208,
        -0.9569403357322088, -0.970031253194544, -0.9807852804032304, -0.989176509964781,
        -0.9951847266721969, -0.9987954562051724, -1.0, -0.9987954562051724, -0.9951847266721969,
        -0.989176509964781, -0.9807852804032304, -0.970031253194544, -0.9569403357322088,
        -0.9415440651830208, -0.9238795325112867, -0.9039892931234433, -0.881921264348355,
        -0.8577286100002721, -0.8314696123025452, -0.8032075314806449, -0.773010453362737,
        -0.7409511253549591, -0.7071067811865476, -0.6715589548470184, -0.6343932841636455,
        -0.5956993044924334, -0.5555702330196022, -0.5141027441932218, -0.47139673682599764,
        -0.4275550934302821, -0.3826834323650898, -0.33688985339222005, -0.2902846772544624,
        -0.2429801799032639, -0.19509032201612828, -0.14673047445536175, -0.0980171403295606,
        -0.049067674327418015, 0.0, 0.049067674327418015, 0.0980171403295606, 0.14673047445536175,
        0.19509032201612828, 0.2429801799032639, 0.2902846772544624, 0.33688985339222005,
        0.3826834323650898, 0.4275550934302821, 0.47139673682599764, 0.5141027441932218,
        0.5555702330196022, 0.5956993044924334, 0.6343932841636455, 0.6715589548470184,
        0.7071067811865476, 0.7409511253549591, 0.773010453362737, 0.8032075314806449,
        0.8314696123025452, 0.8577286100002721, 0.881921264348355, 0.9039892931234433,
        0.9238795325112867, 0.9415440651830208, 0.9569403357322088, 0.970031253194544,
        0.9807852804032304, 0.989176509964781, 0.9951847266721969, 0.9987954562051724 },
    { 1.0, 0.9972904566786902, 0.989176509964781, 0.9757021300385286, 0.9569403357322088,
        0.9329927988347388, 0.9039892931234433, 0.8700869911087115, 0.8314696123025452,
        0.7883464276266062, 0.7409511253549591, 0.6895405447370669, 0.6343932841636455,
        0.5758081914178453, 0.5141027441932218, 0.4496113296546066, 0.3826834323650898,
        0.31368174039889146, 0.2429801799032639, 0.17096188876030122, 0.0980171403295606,
        0.024541228522912288, -0.049067674327418015, -0.1224106751992162, -0.19509032201612828,
        -0.26671275747489837, -0.33688985339222005, -0.40524131400498986, -0.47139673682599764,
        -0.5349976198870973, -0.5956993044924334, -0.6531728429537768, -0.7071067811865476,
        -0.7572088465064846, -0.8032075314806449, -0.8448535652497071, -0.881921264348355,
        -0.9142097557035307, -0.9415440651830208, -0.9637760657954398, -0.9807852804032304,
        -0.99247953459871, -0.9987954562051724, -0.9996988186962042, -0.9951847266721969,
        -0.9852776423889412, -0.970031253194544, -0.9495281805930367, -0.9238795325112867,
        -0.8932243011955153, -0.8577286100002721, -0.8175848131515837, -0.773010453362737,
        -0.7242470829514669, -0.6715589548470184, -0.6152315905806268, -0.5555702330196022,
        -0.49289819222978404, -0.4275550934302821, -0.35989503653498817, -0.2902846772544624,
        -0.2191012401568698, -0.14673047445536175, -0.07356456359966743, 0.0, 0.07356456359966743,
        0.14673047445536175, 0.2191012401568698, 0.2902846772544624, 0.35989503653498817,
        0.4275550934302821, 0.49289819222978404, 0.5555702330196022, 0.6152315905806268,
        0.6715589548470184, 0.7242470829514669, 0.773010453362737, 0.8175848131515837,
        0.8577286100002721, 0.8932243011955153, 0.9238795325112867, 0.9495281805930367,
        0.970031253194544, 0.9852776423889412, 0.9951847266721969, 0.9996988186962042,
        0.9987954562051724, 0.99247953459871, 0.9807852804032304, 0.9637760657954398,
        0.9415440651830208, 0.9142097557035307, 0.881921264348355, 0.8448535652497071,
        0.8032075314806449, 0.7572088465064846, 0.7071067811865476, 0.6531728429537768,
        0.5956993044924334, 0.5349976198870973, 0.47139673682599764, 0.40524131400498986,
        0.33688985339222005, 0.26671275747489837, 0.19509032201612828, 0.1224106751992162,
        0.049067674327418015, -0.024541228522912288, -0.0980171403295606, -0.17096188876030122,
        -0.2429801799032639, -0.31368174039889146, -0.3826834323650898, -0.4496113296546066,
        -0.5141027441932218, -0.5758081914178453, -0.6343932841636455, -0.6895405447370669,
        -0.7409511253549591, -0.7883464276266062, -0.8314696123025452, -0.8700869911087115,
        -0.9039892931234433, -0.9329927988347388, -0.9569403357322088, -0.9757021300385286,
        -0.989176509964781, -0.9972904566786902 },
    { 1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867,
        0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476,
        0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898,
        0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606,
        -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764,
        -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737,
        -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088,
        -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304,
        -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452,
        -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022,
        -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828,
        -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624,
        0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455,
        0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355,
        0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0,
        0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867,
        0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476,
        0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898,
        0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606,
        -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764,
        -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737,
        -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088,
        -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304,
        -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452,
        -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022,
        -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828,
        -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624,
        0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455,
        0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355,
        0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969 },
    { 1.0, 0.99247953459871, 0.970031253194544, 0.9329927988347388, 0.881921264348355,
        0.8175848131515837, 0.7409511253549591, 0.6531728429537768, 0.5555702330196022,
        0.4496113296546066, 0.33688985339222005, 0.2191012401568698, 0.0980171403295606,
        -0.024541228522912288, -0.14673047445536175, -0.26671275747489837, -0.3826834323650898,
        -0.49289819222978404, -0.5956993044924334, -0.6895405447370669, -0.773010453362737,
        -0.8448535652497071, -0.9039892931234433, -0.9495281805930367, -0.9807852804032304,
        -0.9972904566786902, -0.9987954562051724, -0.9852776423889412, -0.9569403357322088,
        -0.9142097557035307, -0.8577286100002721, -0.7883464276266062, -0.7071067811865476,
        -0.6152315905806268, -0.5141027441932218, -0.40524131400498986, -0.2902846772544624,
        -0.17096188876030122, -0.049067674327418015, 0.07356456359966743, 0.19509032201612828,
        0.31368174039889146, 0.4275550934302821, 0.5349976198870973, 0.6343932841636455,
        0.7242470829514669, 0.8032075314806449, 0.8700869911087115, 0.9238795325112867,
        0.9637760657954398, 0.989176509964781, 0.9996988186962042, 0.9951847266721969,
        0.9757021300385286, 0.9415440651830208, 0.8932243011955153, 0.8314696123025452,
        0.7572088465064846, 0.6715589548470184, 0.5758081914178453, 0.47139673682599764,
        0.35989503653498817, 0.2429801799032639, 0.1224106751992162, 0.0, -0.1224106751992162,
        -0.2429801799032639, -0.35989503653498817, -0.47139673682599764, -0.5758081914178453,
        -0.6715589548470184, -0.7572088465064846, -0.8314696123025452, -0.8932243011955153,
        -0.9415440651830208, -0.9757021300385286, -0.9951847266721969, -0.9996988186962042,
        -0.989176509964781, -0.9637760657954398, -0.9238795325112867, -0.8700869911087115,
        -0.8032075314806449, -0.7242470829514669, -0.6343932841636455, -0.5349976198870973,
        -0.4275550934302821, -0.31368174039889146, -0.19509032201612828, -0.07356456359966743,
        0.049067674327418015, 0.17096188876030122, 0.2902846772544624, 0.40524131400498986,
        0.5141027441932218, 0.6152315905806268, 0.7071067811865476, 0.7883464276266062,
        0.8577286100002721, 0.9142097557035307, 0.9569403357322088, 0.9852776423889412,
        0.9987954562051724, 0.9972904566786902, 0.9807852804032304, 0.9495281805930367,
        0.9039892931234433, 0.8448535652497071, 0.773010453362737, 0.6895405447370669,
        0.5956993044924334, 0.49289819222978404, 0.3826834323650898, 0.26671275747489837,
        0.14673047445536175, 0.024541228522912288, -0.0980171403295606, -0.2191012401568698,
        -0.33688985339222005, -0.4496113296546066, -0.5555702330196022, -0.6531728429537768,
        -0.7409511253549591, -0.8175848131515837, -0.881921264348355, -0.9329927988347388,
        -0.970031253194544, -0.99247953459871 },
    { 1.0, 0.989176509964781, 0.9569403357322088, 0.9039892931234433, 0.8314696123025452,
        0.7409511253549591, 0.6343932841636455, 0.5141027441932218, 0.3826834323650898,
        0.2429801799032639, 0.0980171403295606, -0.049067674327418015, -0.19509032201612828,
        -0.33688985339222005, -0.47139673682599764, -0.5956993044924334, -0.7071067811865476,
        -0.8032075314806449, -0.881921264348355, -0.9415440651830208, -0.9807852804032304,
        -0.9987954562051724, -0.9951847266721969, -0.970031253194544, -0.9238795325112867,
        -0.8577286100002721, -0.773010453362737, -0.6715589548470184, -0.5555702330196022,
        -0.4275550934302821, -0.2902846772544624, -0.14673047445536175, 0.0, 0.14673047445536175,
        0.2902846772544624, 0.4275550934302821, 0.5555702330196022, 0.6715589548470184,
        0.773010453362737, 0.8577286100002721, 0.9238795325112867, 0.970031253194544,
        0.9951847266721969, 0.9987954562051724, 0.9807852804032304, 0.9415440651830208,
        0.881921264348355, 0.8032075314806449, 0.7071067811865476, 0.5956993044924334,
        0.47139673682599764, 0.33688985339222005, 0.19509032201612828, 0.049067674327418015,
        -0.0980171403295606, -0.2429801799032639, -0.3826834323650898, -0.5141027441932218,
        -0.6343932841636455, -0.7409511253549591, -0.8314696123025452, -0.9039892931234433,
        -0.9569403357322088, -0.989176509964781, -1.0, -0.989176509964781, -0.9569403357322088,
        -0.9039892931234433, -0.8314696123025452, -0.7409511253549591, -0.6343932841636455,
        -0.5141027441932218, -0.3826834323650898, -0.2429801799032639, -0.0980171403295606,
        0.049067674327418015, 0.19509032201612828, 0.33688985339222005, 0.47139673682599764,
        0.5956993044924334, 0.7071067811865476, 0.8032075314806449, 0.881921264348355,
        0.9415440651830208, 0.9807852804032304, 0.9987954562051724, 0.9951847266721969,
        0.970031253194544, 0.9238795325112867, 0.8577286100002721, 0.773010453362737,
        0.6715589548470184, 0.5555702330196022, 0.4275550934302821, 0.2902846772544624,
        0.14673047445536175, 0.0, -0.14673047445536175, -0.2902846772544624, -0.4275550934302821,
        -0.5555702330196022, -0.6715589548470184, -0.773010453362737, -0.8577286100002721,
        -0.9238795325112867, -0.970031253194544, -0.9951847266721969, -0.9987954562051724,
        -0.9807852804032304, -0.9415440651830208, -0.881921264348355, -0.8032075314806449,
        -0.7071067811865476, -0.5956993044924334, -0.47139673682599764, -0.33688985339222005,
        -0.19509032201612828, -0.049067674327418015, 0.0980171403295606, 0.2429801799032639,
        0.3826834323650898, 0.5141027441932218, 0.6343932841636455, 0.7409511253549591,
        0.8314696123025452, 0.9039892931234433, 0.9569403357322088, 0.989176509964781 },
    { 1.0, 0.9852776423889412, 0.9415440651830208, 0.8700869911087115, 0.773010453362737,
        0.6531728429537768, 0.5141027441932218, 0.35989503653498817, 0.19509032201612828,
        0.024541228522912288, -0.14673047445536175, -0.31368174039889146, -0.47139673682599764,
        -0.6152315905806268, -0.7409511253549591, -0.8448535652497071, -0.9238795325112867,
        -0.9757021300385286, -0.9987954562051724, -0.99247953459871, -0.9569403357322088,
        -0.8932243011955153, -0.8032075314806449, -0.6895405447370669, -0.5555702330196022,
        -0.40524131400498986, -0.2429801799032639, -0.07356456359966743, 0.0980171403295606,
        0.26671275747489837, 0.4275550934302821, 0.5758081914178453, 0.7071067811865476,
        0.8175848131515837, 0.9039892931234433, 0.9637760657954398, 0.9951847266721969,
        0.9972904566786902, 0.970031253194544, 0.9142097557035307, 0.8314696123025452,
        0.7242470829514669, 0.5956993044924334, 0.4496113296546066, 0.2902846772544624,
        0.1224106751992162, -0.049067674327418015, -0.2191012401568698, -0.3826834323650898,
        -0.5349976198870973, -0.6715589548470184, -0.7883464276266062, -0.881921264348355,
        -0.9495281805930367, -0.989176509964781, -0.9996988186962042, -0.9807852804032304,
        -0.9329927988347388, -0.8577286100002721, -0.7572088465064846, -0.6343932841636455,
        -0.49289819222978404, -0.33688985339222005, -0.17096188876030122, 0.0, 0.17096188876030122,
        0.33688985339222005, 0.49289819222978404, 0.6343932841636455, 0.7572088465064846,
        0.8577286100002721, 0.9329927988347388, 0.9807852804032304, 0.9996988186962042,
        0.989176509964781, 0.9495281805930367, 0.881921264348355, 0.7883464276266062,
        0.6715589548470184, 0.5349976198870973, 0.3826834323650898, 0.2191012401568698,
        0.049067674327418015, -0.1224106751992162, -0.2902846772544624, -0.4496113296546066,
        -0.5956993044924334, -0.7242470829514669, -0.8314696123025452, -0.9142097557035307,
        -0.970031253194544, -0.9972904566786902, -0.9951847266721969, -0.9637760657954398,
        -0.9039892931234433, -0.8175848131515837, -0.7071067811865476, -0.5758081914178453,
        -0.4275550934302821, -0.26671275747489837, -0.0980171403295606, 0.07356456359966743,
        0.2429801799032639, 0.40524131400498986, 0.5555702330196022, 0.6895405447370669,
        0.8032075314806449, 0.8932243011955153, 0.9569403357322088, 0.99247953459871,
        0.9987954562051724, 0.9757021300385286, 0.9238795325112867, 0.8448535652497071,
        0.7409511253549591, 0.6152315905806268, 0.47139673682599764, 0.31368174039889146,
        0.14673047445536175, -0.024541228522912288, -0.19509032201612828, -0.35989503653498817,
        -0.5141027441932218, -0.6531728429537768, -0.773010453362737, -0.8700869911087115,
        -0.9415440651830208, -0.9852776423889412 },
    { 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476,
        0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828,
        -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452,
        -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867,
        -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898,
        -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022,
        0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0,
        0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476,
        0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828,
        -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452,
        -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867,
        -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898,
        -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022,
        0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0,
        0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476,
        0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828,
        -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452,
        -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867,
        -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898,
        -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022,
        0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0,
        0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476,
        0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828,
        -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452,
        -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867,
        -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898,
        -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022,
        0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304 },
};

static const double general_5r1p_grid_s[8][128] GENERAL_5R1P_ALIGNED = {
    { 0.0, 0.024541228522912288, 0.049067674327418015, 0.07356456359966743, 0.0980171403295606,
        0.1224106751992162, 0.14673047445536175, 0.17096188876030122, 0.19509032201612828,
        0.2191012401568698, 0.2429801799032639, 0.26671275747489837, 0.2902846772544624,
        0.31368174039889146, 0.33688985339222005, 0.35989503653498817, 0.3826834323650898,
        0.40524131400498986, 0.4275550934302821, 0.4496113296546066, 0.47139673682599764,
        0.49289819222978404, 0.5141027441932218, 0.5349976198870973, 0.5555702330196022,
        0.5758081914178453, 0.5956993044924334, 0.6152315905806268, 0.6343932841636455,
        0.6531728429537768, 0.6715589548470184, 0.6895405447370669, 0.7071067811865476,
        0.7242470829514669, 0.7409511253549591, 0.7572088465064846, 0.773010453362737,
        0.7883464276266062, 0.8032075314806449, 0.8175848131515837, 0.8314696123025452,
        0.8448535652497071, 0.8577286100002721, 0.8700869911087115, 0.881921264348355,
        0.8932243011955153, 0.9039892931234433, 0.9142097557035307, 0.9238795325112867,
        0.9329927988347388, 0.9415440651830208, 0.9495281805930367, 0.9569403357322088,
        0.9637760657954398, 0.970031253194544, 0.9757021300385286, 0.9807852804032304,
        0.9852776423889412, 0.989176509964781, 0.99247953459871, 0.9951847266721969,
        0.9972904566786902, 0.9987954562051724, 0.9996988186962042, 1.0, 0.9996988186962042,
        0.9987954562051724, 0.9972904566786902, 0.9951847266721969, 0.99247953459871,
        0.989176509964781, 0.9852776423889412, 0.9807852804032304, 0.9757021300385286,
        0.970031253194544, 0.9637760657954398, 0.9569403357322088, 0.9495281805930367,
        0.9415440651830208, 0.9329927988347388, 0.9238795325112867, 0.9142097557035307,
        0.9039892931234433, 0.8932243011955153, 0.881921264348355, 0.8700869911087115,
        0.8577286100002721, 0.8448535652497071, 0.8314696123025452, 0.8175848131515837,
        0.8032075314806449, 0.7883464276266062, 0.773010453362737, 0.7572088465064846,
        0.7409511253549591, 0.7242470829514669, 0.7071067811865476, 0.6895405447370669,
        0.6715589548470184, 0.6531728429537768, 0.6343932841636455, 0.6152315905806268,
        0.5956993044924334, 0.5758081914178453, 0.5555702330196022, 0.5349976198870973,
        0.5141027441932218, 0.49289819222978404, 0.47139673682599764, 0.4496113296546066,
        0.4275550934302821, 0.40524131400498986, 0.3826834323650898, 0.35989503653498817,
        0.33688985339222005, 0.31368174039889146, 0.2902846772544624, 0.26671275747489837,
        0.2429801799032639, 0.2191012401568698, 0.19509032201612828, 0.17096188876030122,
        0.14673047445536175, 0.1224106751992162, 0.0980171403295606, 0.07356456359966743,
        0.049067674327418015, 0.024541228522912288 },
    { 0.0, 0.049067674327418015, 0.0980171403295606, 0.14673047445536175, 0.19509032201612828,
        0.2429801799032639, 0.2902846772544624, 0.33688985339222005, 0.3826834323650898,
        0.4275550934302821, 0.47139673682599764, 0.5141027441932218, 0.5555702330196022,
        0.5956993044924334, 0.6343932841636455, 0.6715589548470184, 0.7071067811865476,
        0.7409511253549591, 0.773010453362737, 0.8032075314806449, 0.8314696123025452,
        0.8577286100002721, 0.881921264348355, 0.9039892931234433, 0.9238795325112867,
        0.9415440651830208, 0.9569403357322088, 0.970031253194544, 0.9807852804032304,
        0.989176509964781, 0.9951847266721969, 0.9987954562051724, 1.0, 0.9987954562051724,
        0.9951847266721969, 0.989176509964781, 0.9807852804032304, 0.970031253194544,
        0.9569403357322088, 0.9415440651830208, 0.9238795325112867, 0.9039892931234433,
        0.881921264348355, 0.8577286100002721, 0.8314696123025452, 0.8032075314806449,
        0.773010453362737, 0.7409511253549591, 0.7071067811865476, 0.6715589548470184,
        0.6343932841636455, 0.5956993044924334, 0.5555702330196022, 0.5141027441932218,
        0.47139673682599764, 0.4275550934302821, 0.3826834323650898, 0.33688985339222005,
        0.2902846772544624, 0.2429801799032639, 0.19509032201612828, 0.14673047445536175,
        0.0980171403295606, 0.049067674327418015, 0.0, -0.049067674327418015, -0.0980171403295606,
        -0.14673047445536175, -0.19509032201612828, -0.2429801799032639, -0.2902846772544624,
        -0.33688985339222005, -0.3826834323650898, -0.4275550934302821, -0.47139673682599764,
        -0.5141027441932218, -0.5555702330196022, -0.5956993044924334, -0.6343932841636455,
        -0.6715589548470184, -0.7071067811865476, -0.7409511253549591, -0.773010453362737,
        -0.8032075314806449, -0.8314696123025452, -0.8577286100002721, -0.881921264348355,
        -0.9039892931234433, -0.9238795325112867, -0.9415440651830208, -0.9569403357322088,
        -0.970031253194544, -0.9807852804032304, -0.989176509964781, -0.9951847266721969,
        -0.9987954562051724, -1.0, -0.9987954562051724, -0.9951847266721969, -0.989176509964781,
        -0.9807852804032304, -0.970031253194544, -0.9569403357322088, -0.9415440651830208,
        -0.9238795325112867, -0.9039892931234433, -0.881921264348355, -0.8577286100002721,
        -0.8314696123025452, -0.8032075314806449, -0.773010453362737, -0.7409511253549591,
        -0.7071067811865476, -0.6715589548470184, -0.6343932841636455, -0.5956993044924334,
        -0.5555702330196022, -0.5141027441932218, -0.47139673682599764, -0.4275550934302821,
        -0.3826834323650898, -0.33688985339222005, -0.2902846772544624, -0.2429801799032639,
        -0.19509032201612828, -0.14673047445536175, -0.0980171403295606, -0.049067674327418015 },
    { 0.0, 0.07356456359966743, 0.14673047445536175, 0.2191012401568698, 0.2902846772544624,
        0.35989503653498817, 0.4275550934302821, 0.49289819222978404, 0.5555702330196022,
        0.6152315905806268, 0.6715589548470184, 0.7242470829514669, 0.773010453362737,
        0.8175848131515837, 0.8577286100002721, 0.8932243011955153, 0.9238795325112867,
        0.9495281805930367, 0.970031253194544, 0.9852776423889412, 0.9951847266721969,
        0.9996988186962042, 0.9987954562051724, 0.99247953459871, 0.9807852804032304,
        0.9637760657954398, 0.9415440651830208, 0.9142097557035307, 0.881921264348355,
        0.8448535652497071, 0.8032075314806449, 0.7572088465064846, 0.7071067811865476,
        0.6531728429537768, 0.5956993044924334, 0.5349976198870973, 0.47139673682599764,
        0.40524131400498986, 0.33688985339222005, 0.26671275747489837, 0.19509032201612828,
        0.1224106751992162, 0.049067674327418015, -0.024541228522912288, -0.0980171403295606,
        -0.17096188876030122, -0.2429801799032639, -0.31368174039889146, -0.3826834323650898,
        -0.4496113296546066, -0.5141027441932218, -0.5758081914178453, -0.6343932841636455,
        -0.6895405447370669, -0.7409511253549591, -0.7883464276266062, -0.8314696123025452,
        -0.8700869911087115, -0.9039892931234433, -0.9329927988347388, -0.9569403357322088,
        -0.9757021300385286, -0.989176509964781, -0.9972904566786902, -1.0, -0.9972904566786902,
        -0.989176509964781, -0.9757021300385286, -0.9569403357322088, -0.9329927988347388,
        -0.9039892931234433, -0.8700869911087115, -0.8314696123025452, -0.7883464276266062,
        -0.7409511253549591, -0.6895405447370669, -0.6343932841636455, -0.5758081914178453,
        -0.5141027441932218, -0.4496113296546066, -0.3826834323650898, -0.31368174039889146,
        -0.2429801799032639, -0.17096188876030122, -0.0980171403295606, -0.024541228522912288,
        0.049067674327418015, 0.1224106751992162, 0.19509032201612828, 0.26671275747489837,
        0.33688985339222005, 0.40524131400498986, 0.47139673682599764, 0.5349976198870973,
        0.5956993044924334, 0.6531728429537768, 0.7071067811865476, 0.7572088465064846,
        0.8032075314806449, 0.8448535652497071, 0.881921264348355, 0.9142097557035307,
        0.9415440651830208, 0.9637760657954398, 0.9807852804032304, 0.99247953459871,
        0.9987954562051724, 0.9996988186962042, 0.9951847266721969, 0.9852776423889412,
        0.970031253194544, 0.9495281805930367, 0.9238795325112867, 0.8932243011955153,
        0.8577286100002721, 0.8175848131515837, 0.773010453362737, 0.7242470829514669,
        0.6715589548470184, 0.6152315905806268, 0.5555702330196022, 0.49289819222978404,
        0.4275550934302821, 0.35989503653498817, 0.2902846772544624, 0.2191012401568698,
        0.14673047445536175, 0.07356456359966743 },
    { 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898,
        0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476,
        0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867,
        0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969,
        0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355,
        0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455,
        0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624,
        0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828,
        -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022,
        -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452,
        -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304,
        -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088,
        -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737,
        -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764,
        -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606, 0.0,
        0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898,
        0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476,
        0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867,
        0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969,
        0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355,
        0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455,
        0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624,
        0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828,
        -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022,
        -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452,
        -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304,
        -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088,
        -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737,
        -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764,
        -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606 },
    { 0.0, 0.1224106751992162, 0.2429801799032639, 0.35989503653498817, 0.47139673682599764,
        0.5758081914178453, 0.6715589548470184, 0.7572088465064846, 0.8314696123025452,
        0.8932243011955153, 0.9415440651830208, 0.9757021300385286, 0.9951847266721969,
        0.9996988186962042, 0.989176509964781, 0.9637760657954398, 0.9238795325112867,
        0.8700869911087115, 0.8032075314806449, 0.7242470829514669, 0.6343932841636455,
        0.5349976198870973, 0.4275550934302821, 0.31368174039889146, 0.19509032201612828,
        0.07356456359966743, -0.049067674327418015, -0.17096188876030122, -0.2902846772544624,
        -0.40524131400498986, -0.5141027441932218, -0.6152315905806268, -0.7071067811865476,
        -0.7883464276266062, -0.8577286100002721, -0.9142097557035307, -0.9569403357322088,
        -0.9852776423889412, -0.9987954562051724, -0.9972904566786902, -0.9807852804032304,
        -0.9495281805930367, -0.9039892931234433, -0.8448535652497071, -0.773010453362737,
        -0.6895405447370669, -0.5956993044924334, -0.49289819222978404, -0.3826834323650898,
        -0.26671275747489837, -0.14673047445536175, -0.024541228522912288, 0.0980171403295606,
        0.2191012401568698, 0.33688985339222005, 0.4496113296546066, 0.5555702330196022,
        0.6531728429537768, 0.7409511253549591, 0.8175848131515837, 0.881921264348355,
        0.9329927988347388, 0.970031253194544, 0.99247953459871, 1.0, 0.99247953459871,
        0.970031253194544, 0.9329927988347388, 0.881921264348355, 0.8175848131515837,
        0.7409511253549591, 0.6531728429537768, 0.5555702330196022, 0.4496113296546066,
        0.33688985339222005, 0.2191012401568698, 0.0980171403295606, -0.024541228522912288,
        -0.14673047445536175, -0.26671275747489837, -0.3826834323650898, -0.49289819222978404,
        -0.5956993044924334, -0.6895405447370669, -0.773010453362737, -0.8448535652497071,
        -0.9039892931234433, -0.9495281805930367, -0.9807852804032304, -0.9972904566786902,
        -0.9987954562051724, -0.9852776423889412, -0.9569403357322088, -0.9142097557035307,
        -0.8577286100002721, -0.7883464276266062, -0.7071067811865476, -0.6152315905806268,
        -0.5141027441932218, -0.40524131400498986, -0.2902846772544624, -0.17096188876030122,
        -0.049067674327418015, 0.07356456359966743, 0.19509032201612828, 0.31368174039889146,
        0.4275550934302821, 0.5349976198870973, 0.6343932841636455, 0.7242470829514669,
        0.8032075314806449, 0.8700869911087115, 0.9238795325112867, 0.9637760657954398,
        0.989176509964781, 0.9996988186962042, 0.9951847266721969, 0.9757021300385286,
        0.9415440651830208, 0.8932243011955153, 0.8314696123025452, 0.7572088465064846,
        0.6715589548470184, 0.5758081914178453, 0.47139673682599764, 0.35989503653498817,
        0.2429801799032639, 0.1224106751992162 },
    { 0.0, 0.14673047445536175, 0.2902846772544624, 0.4275550934302821, 0.5555702330196022,
        0.6715589548470184, 0.773010453362737, 0.8577286100002721, 0.9238795325112867,
        0.970031253194544, 0.9951847266721969, 0.9987954562051724, 0.9807852804032304,
        0.9415440651830208, 0.881921264348355, 0.8032075314806449, 0.7071067811865476,
        0.5956993044924334, 0.47139673682599764, 0.33688985339222005, 0.19509032201612828,
        0.049067674327418015, -0.0980171403295606, -0.2429801799032639, -0.3826834323650898,
        -0.5141027441932218, -0.6343932841636455, -0.7409511253549591, -0.8314696123025452,
        -0.9039892931234433, -0.9569403357322088, -0.989176509964781, -1.0, -0.989176509964781,
        -0.9569403357322088, -0.9039892931234433, -0.8314696123025452, -0.7409511253549591,
        -0.6343932841636455, -0.5141027441932218, -0.3826834323650898, -0.2429801799032639,
        -0.0980171403295606, 0.049067674327418015, 0.19509032201612828, 0.33688985339222005,
        0.47139673682599764, 0.5956993044924334, 0.7071067811865476, 0.8032075314806449,
        0.881921264348355, 0.9415440651830208, 0.9807852804032304, 0.9987954562051724,
        0.9951847266721969, 0.970031253194544, 0.9238795325112867, 0.8577286100002721,
        0.773010453362737, 0.6715589548470184, 0.5555702330196022, 0.4275550934302821,
        0.2902846772544624, 0.14673047445536175, 0.0, -0.14673047445536175, -0.2902846772544624,
        -0.4275550934302821, -0.5555702330196022, -0.6715589548470184, -0.773010453362737,
        -0.8577286100002721, -0.9238795325112867, -0.970031253194544, -0.9951847266721969,
        -0.9987954562051724, -0.9807852804032304, -0.9415440651830208, -0.881921264348355,
        -0.8032075314806449, -0.7071067811865476, -0.5956993044924334, -0.47139673682599764,
        -0.33688985339222005, -0.19509032201612828, -0.049067674327418015, 0.0980171403295606,
        0.2429801799032639, 0.3826834323650898, 0.5141027441932218, 0.6343932841636455,
        0.7409511253549591, 0.8314696123025452, 0.9039892931234433, 0.9569403357322088,
        0.989176509964781, 1.0, 0.989176509964781, 0.9569403357322088, 0.9039892931234433,
        0.8314696123025452, 0.7409511253549591, 0.6343932841636455, 0.5141027441932218,
        0.3826834323650898, 0.2429801799032639, 0.0980171403295606, -0.049067674327418015,
        -0.19509032201612828, -0.33688985339222005, -0.47139673682599764, -0.5956993044924334,
        -0.7071067811865476, -0.8032075314806449, -0.881921264348355, -0.9415440651830208,
        -0.9807852804032304, -0.9987954562051724, -0.9951847266721969, -0.970031253194544,
        -0.9238795325112867, -0.8577286100002721, -0.773010453362737, -0.6715589548470184,
        -0.5555702330196022, -0.4275550934302821, -0.2902846772544624, -0.14673047445536175 },
    { 0.0, 0.17096188876030122, 0.33688985339222005, 0.49289819222978404, 0.6343932841636455,
        0.7572088465064846, 0.8577286100002721, 0.9329927988347388, 0.9807852804032304,
        0.9996988186962042, 0.989176509964781, 0.9495281805930367, 0.881921264348355,
        0.7883464276266062, 0.6715589548470184, 0.5349976198870973, 0.3826834323650898,
        0.2191012401568698, 0.049067674327418015, -0.1224106751992162, -0.2902846772544624,
        -0.4496113296546066, -0.5956993044924334, -0.7242470829514669, -0.8314696123025452,
        -0.9142097557035307, -0.970031253194544, -0.9972904566786902, -0.9951847266721969,
        -0.9637760657954398, -0.9039892931234433, -0.8175848131515837, -0.7071067811865476,
        -0.5758081914178453, -0.4275550934302821, -0.26671275747489837, -0.0980171403295606,
        0.07356456359966743, 0.2429801799032639, 0.40524131400498986, 0.5555702330196022,
        0.6895405447370669, 0.8032075314806449, 0.8932243011955153, 0.9569403357322088,
        0.99247953459871, 0.9987954562051724, 0.9757021300385286, 0.9238795325112867,
        0.8448535652497071, 0.7409511253549591, 0.6152315905806268, 0.47139673682599764,
        0.31368174039889146, 0.14673047445536175, -0.024541228522912288, -0.19509032201612828,
        -0.35989503653498817, -0.5141027441932218, -0.6531728429537768, -0.773010453362737,
        -0.8700869911087115, -0.9415440651830208, -0.9852776423889412, -1.0, -0.9852776423889412,
        -0.9415440651830208, -0.8700869911087115, -0.773010453362737, -0.6531728429537768,
        -0.5141027441932218, -0.35989503653498817, -0.19509032201612828, -0.024541228522912288,
        0.14673047445536175, 0.31368174039889146, 0.47139673682599764, 0.6152315905806268,
        0.7409511253549591, 0.8448535652497071, 0.9238795325112867, 0.9757021300385286,
        0.9987954562051724, 0.99247953459871, 0.9569403357322088, 0.8932243011955153,
        0.8032075314806449, 0.6895405447370669, 0.5555702330196022, 0.40524131400498986,
        0.2429801799032639, 0.07356456359966743, -0.0980171403295606, -0.26671275747489837,
        -0.4275550934302821, -0.5758081914178453, -0.7071067811865476, -0.8175848131515837,
        -0.9039892931234433, -0.9637760657954398, -0.9951847266721969, -0.9972904566786902,
        -0.970031253194544, -0.9142097557035307, -0.8314696123025452, -0.7242470829514669,
        -0.5956993044924334, -0.4496113296546066, -0.2902846772544624, -0.1224106751992162,
        0.049067674327418015, 0.2191012401568698, 0.3826834323650898, 0.5349976198870973,
        0.6715589548470184, 0.7883464276266062, 0.881921264348355, 0.9495281805930367,
        0.989176509964781, 0.9996988186962042, 0.9807852804032304, 0.9329927988347388,
        0.8577286100002721, 0.7572088465064846, 0.6343932841636455, 0.49289819222978404,
        0.33688985339222005, 0.17096188876030122 },
    { 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476,
        0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304,
        0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022,
        0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898,
        -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867,
        -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452,
        -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0,
        0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476,
        0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304,
        0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022,
        0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898,
        -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867,
        -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452,
        -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0,
        0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476,
        0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304,
        0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022,
        0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898,
        -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867,
        -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452,
        -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0,
        0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476,
        0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304,
        0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022,
        0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898,
        -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867,
        -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452,
        -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828 },
};

/* C = A B for rigid transforms, three rows of four. */
static inline void general_5r1p_compose(const double A[12], const double B[12], double C[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j] +
                           (j == 3 ? A[4 * i + 3] : 0.0);
        }
    }
}

static inline void general_5r1p_invert(const double A[12], double B[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            B[4 * i + j] = A[4 * j + i];
        }
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11]);
    }
}

static inline void general_5r1p_copy(const double A[12], double B[12])
{
    for (int i = 0; i < 12; i++) {
        B[i] = A[i];
    }
}

/* A becomes A B. */
static inline void general_5r1p_then(double A[12], const double B[12])
{
    double C[12];
    general_5r1p_compose(A, B, C);
    general_5r1p_copy(C, A);
}

/* The links K0 ... K4 of the loop and its pose P = L T R, in arm sizes. */
static void general_5r1p_close(const double T[16], general_5r1p_loop *loop)
{
    double *const P = loop->link[5], right[12];
    general_5r1p_copy(general_5r1p_constant[0], loop->link[0]);
    general_5r1p_copy(general_5r1p_constant[1], loop->link[1]);
    general_5r1p_copy(general_5r1p_constant[2], loop->link[2]);
    general_5r1p_copy(general_5r1p_constant[3], loop->link[3]);
    general_5r1p_copy(general_5r1p_constant[4], loop->link[4]);
    general_5r1p_copy(general_5r1p_constant[5], P);
    general_5r1p_copy(general_5r1p_constant[6], right);
    general_5r1p_then(P, T);
    general_5r1p_then(P, right);
    for (int i = 3; i < 12; i += 4) {
        P[i] *= 1.5804600087200025;
    }
}

/* a rigid transform for each lane */
typedef general_5r1p_lane general_5r1p_rigid[3][4];

/* T Rz */
static inline void general_5r1p_turn(general_5r1p_rigid T, general_5r1p_lane c, general_5r1p_lane s)
{
    for (int i = 0; i < 3; i++) {
        const general_5r1p_lane x = T[i][0];
        T[i][0] = x * c + T[i][1] * s;
        T[i][1] = T[i][1] * c - x * s;
    }
}

/* T Tz */
static inline void general_5r1p_slide(general_5r1p_rigid T, general_5r1p_lane d)
{
    for (int i = 0; i < 3; i++) {
        T[i][3] += T[i][2] * d;
    }
}

/* The motion of a joint: by its cosine and sine, or by a length that stands in the sine's place. */
static inline void general_5r1p_move(general_5r1p_rigid T, int joint, general_5r1p_lane c,
    general_5r1p_lane s)
{
    if (general_5r1p_slides(joint)) {
        general_5r1p_slide(T, s);
        return;
    }
    general_5r1p_turn(T, c, s);
}

/* T K, the same K for every lane */
static inline void general_5r1p_follow(general_5r1p_rigid T, const double K[12])
{
    for (int i = 0; i < 3; i++) {
        const general_5r1p_lane x = T[i][0], y = T[i][1], z = T[i][2];
        for (int j = 0; j < 3; j++) {
            T[i][j] = x * K[j] + y * K[4 + j] + z * K[8 + j];
        }
        T[i][3] += x * K[3] + y * K[7] + z * K[11];
    }
}

static inline void general_5r1p_begin(general_5r1p_rigid T, const double K[12])
{
    for (int i = 0; i < 12; i++) {
        T[i / 4][i % 4] = general_5r1p_all(K[i]);
    }
}

/* A cosine and a sine without their common factor, which is told while it has a square. */
static inline void general_5r1p_to_unit(general_5r1p_lane *c, general_5r1p_lane *s)
{
    const general_5r1p_lane square = *c * *c + *s * *s, factor = 1.0 / general_5r1p_sqrt(square +
        1e-300);
    const general_5r1p_mask told = (square > 1e-300) & (square < 9.999999999999999e+299);
    *c = general_5r1p_select(told, *c * factor, general_5r1p_all(1.0));
    *s = general_5r1p_select(told, *s * factor, general_5r1p_all(0.0));
}

/* Reflect `rows` rows of a matrix with `columns` columns so that below the first, `column` becomes
 * zero; row[i] points to the i-th of them. Returns the new diagonal. Sums are of two halves, so
 * that half as many operations wait for each other. */
static inline general_5r1p_lane general_5r1p_reflect(general_5r1p_lane *const *row, int rows, int
    column, int columns)
{
    general_5r1p_lane axis[6], half[2], length, factor;
    for (int i = 0; i < 6; i++) {
        axis[i] = half[i % 2] = general_5r1p_all(0.0); /* compilers don't see that `rows` of them
            are used */
    }
    GENERAL_5R1P_UNROLL
    for (int i = 0; i < rows; i++) {
        axis[i] = row[i][column];
        half[i % 2] += axis[i] * axis[i];
    }
    length = general_5r1p_with_sign(general_5r1p_sqrt(half[0] + half[1]), axis[0]);
    axis[0] += length;
    factor = 1.0 / (length * axis[0] + 1e-300);
    GENERAL_5R1P_UNROLL
    for (int j = column + 1; j < columns; j++) {
        general_5r1p_lane sum;
        half[0] = axis[0] * row[0][j];
        half[1] = axis[1] * row[1][j];
        GENERAL_5R1P_UNROLL
        for (int i = 2; i < rows; i++) {
            half[i % 2] += axis[i] * row[i][j];
        }
        sum = (half[0] + half[1]) * factor;
        GENERAL_5R1P_UNROLL
        for (int i = 0; i < rows; i++) {
            row[i][j] -= axis[i] * sum;
        }
    }
    row[0][column] = -length;
    return -length;
}

/* The features of a point and a direction, at once for several columns: 1, l, p, p.p, p.l, p x l
 * and (p.p) l - 2 (p.l) p, as a rigid motion acts on them. */
static inline void general_5r1p_act(const double K[12], general_5r1p_lane x[15])
{
    const double t[3] = {K[3], K[7], K[11]};
    const double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    general_5r1p_lane u[3], q[3], v[3], w[3], along;
    GENERAL_5R1P_UNROLL
    for (int i = 0; i < 3; i++) {
        const double *const row = K + 4 * i;
        u[i] = row[0] * x[1] + row[1] * x[2] + row[2] * x[3];
        q[i] = row[0] * x[4] + row[1] * x[5] + row[2] * x[6];
        v[i] = row[0] * x[9] + row[1] * x[10] + row[2] * x[11];
        w[i] = row[0] * x[12] + row[1] * x[13] + row[2] * x[14];
    }
    along = t[0] * u[0] + t[1] * u[1] + t[2] * u[2];
    x[7] += 2.0 * (t[0] * q[0] + t[1] * q[1] + t[2] * q[2]) + square * x[0];
    x[8] += along;
    GENERAL_5R1P_UNROLL
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        x[1 + i] = u[i];
        x[4 + i] = q[i] + t[i] * x[0];
        x[9 + i] = v[i] + (t[i1] * u[i2] - t[i2] * u[i1]);
        x[12 + i] = w[i] - 2.0 * (t[i] * x[8] + (t[i1] * v[i2] - t[i2] * v[i1])) + square * u[i];
    }
}

/* What a joint that turns makes of features: the coefficients of 1, cos and sin of its angle. */
static inline void general_5r1p_cosines(const general_5r1p_lane x[15], general_5r1p_lane
    part[3][15])
{
    static const int vector[4] = {1, 4, 9, 12};
    const general_5r1p_lane zero = {0};
    for (int i = 0; i < 15; i++) {
        part[0][i] = x[i];
        part[1][i] = part[2][i] = zero;
    }
    for (int i = 0; i < 4; i++) {
        const int at = vector[i];
        part[0][at] = part[0][at + 1] = zero;
        part[1][at] = part[2][at + 1] = x[at];
        part[1][at + 1] = x[at + 1];
        part[2][at] = -x[at + 1];
    }
}

typedef void general_5r1p_joint_parts(const general_5r1p_lane x[15], general_5r1p_lane part[3][15]);

/* Columns of features, 16 places wide, pass a link, and each becomes three by what the joint before
 * it does: column a columns + k of those to come, `width` places wide, is part a of column k. */
static void general_5r1p_pass(const double K[12], const double from[240], int columns,
                         general_5r1p_joint_parts *parts, double *to, int width)
{
    /* from the last on, so that what runs over is written again */
    for (int k = (columns - 1) / GENERAL_5R1P_LANES * GENERAL_5R1P_LANES; k >= 0; k -=
        GENERAL_5R1P_LANES) {
        general_5r1p_lane x[15], part[3][15];
        for (int i = 0; i < 15; i++) {
            x[i] = GENERAL_5R1P_LOAD(from + 16 * i + k);
        }
        general_5r1p_act(K, x);
        parts(x, part);
        for (int i = 0; i < 15; i++) {
            for (int a = 0; a < 3; a++) {
                GENERAL_5R1P_STORE(to + width * i + a * columns + k, part[a][i]);
            }
        }
    }
}

/* Reflections that clear the columns of A, one after the other and all that follow in lanes; `axis`
 * and `factor` say how to reflect others. The products of a column with all are summed at once, its
 * own square among them. */
static inline void general_5r1p_clear(double A[8][8], int rows, int columns, double axis[6][8],
                                 double factor[6])
{
    GENERAL_5R1P_UNROLL
    for (int c = 0; c < columns; c++) {
        const int first = c / GENERAL_5R1P_LANES * GENERAL_5R1P_LANES;
        double product[8], length;
        GENERAL_5R1P_UNROLL
        for (int i = c; i < rows; i++) {
            axis[c][i] = A[i][c];
        }
        GENERAL_5R1P_UNROLL
        for (int j = first; j < columns; j += GENERAL_5R1P_LANES) {
            general_5r1p_lane sum = general_5r1p_all(0.0);
            GENERAL_5R1P_UNROLL
            for (int i = c; i < rows; i++) {
                sum += axis[c][i] * GENERAL_5R1P_LOAD(&A[i][j]);
            }
            GENERAL_5R1P_STORE(&product[j], sum);
        }
        length = copysign(sqrt(product[c]), axis[c][c]);
        axis[c][c] += length;
        factor[c] = 1.0 / (length * axis[c][c] + 1e-300);
        GENERAL_5R1P_UNROLL
        for (int j = first; j < columns; j += GENERAL_5R1P_LANES) {
            const general_5r1p_lane sum = GENERAL_5R1P_LOAD(&product[j]) + length *
                GENERAL_5R1P_LOAD(&A[c][j]);
            const general_5r1p_lane part = sum * factor[c];
            GENERAL_5R1P_UNROLL
            for (int i = c; i < rows; i++) {
                GENERAL_5R1P_STORE(&A[i][j], GENERAL_5R1P_LOAD(&A[i][j]) - axis[c][i] * part);
            }
        }
    }
}

static inline void general_5r1p_mirror(double axis[6][8], const double factor[6], int rows, int
    columns,
                                  general_5r1p_lane x[8])
{
    GENERAL_5R1P_UNROLL
    for (int c = 0; c < columns; c++) {
        general_5r1p_lane sum = axis[c][c] * x[c];
        GENERAL_5R1P_UNROLL
        for (int i = c + 1; i < rows; i++) {
            sum += axis[c][i] * x[i];
        }
        sum *= factor[c];
        GENERAL_5R1P_UNROLL
        for (int i = c; i < rows; i++) {
            x[i] -= axis[c][i] * sum;
        }
    }
}

/* The six equations of a formulation: index 32 r + 9 a + 3 j + i for equation r, 1, c1, s1 (a), the
 * powers x3^2, x3, 1 (i) and x2^2, x2, 1 (j) of the partners' half-angle tangents or lengths; the
 * left side's features have columns like these. */
static void general_5r1p_equations(const general_5r1p_formulation *form, double link[6][12], const
    double (*left)[32],
                         double E[192])
{
    double x[240] = {0.0}, y[240] = {0.0}, right[240] = {0.0};
    double inverse[12], A[8][8] GENERAL_5R1P_ALIGNED = { {0.0} }, still_axis[6][8], still_factor[6],
        pair_axis[6][8], pair_factor[6];
    /* the features that the outer joint of the right side leaves alone, and those that it mixes:
     * the former hold two of the eight monomials, the latter six */
    static const int still[6] = {3, 6, 7, 8, 11, 14}, pair[8] = {1, 2, 4, 5, 9, 10, 12, 13};
    (void)form;
    x[0] = x[48] = 1.0; /* the origin and z */
    general_5r1p_invert(link[3], inverse);
    general_5r1p_pass(inverse, x, 1, general_5r1p_cosines, y, 16);
    general_5r1p_invert(link[4], inverse);
    general_5r1p_pass(inverse, y, 3, general_5r1p_cosines, right, 16);
    for (int i = 0; i < 6; i++) {
        A[i][0] = right[16 * still[i] + 1];
        A[i][1] = right[16 * still[i] + 2];
    }
    general_5r1p_clear(A, 6, 2, still_axis, still_factor);
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < 6; k++) {
            A[i][k] = right[16 * pair[i] + 3 + k];
        }
    }
    general_5r1p_clear(A, 8, 6, pair_axis, pair_factor);
    for (int k = 0; k < 32; k += GENERAL_5R1P_LANES) {
        general_5r1p_lane z[15], alone[8], mixed[8];
        for (int i = 0; i < 15; i++) {
            z[i] = GENERAL_5R1P_LOAD(&left[i][k]);
        }
        for (int i = 0; i < 6; i++) {
            /* the constant column of the right side, times 1 + x2^2 and 1 + x3^2 */
            alone[i] = z[still[i]] - right[16 * still[i]] * z[0];
        }
        for (int i = 0; i < 8; i++) {
            mixed[i] = z[pair[i]];
        }
        general_5r1p_mirror(still_axis, still_factor, 6, 2, alone);
        general_5r1p_mirror(pair_axis, pair_factor, 8, 6, mixed);
        for (int r = 0; r < 6; r++) {
            GENERAL_5R1P_STORE(E + 32 * r + k, r < 4 ? alone[2 + r] : mixed[2 + r]);
        }
    }
}

/* The determinant at hidden angles, and the upper triangular factor whose null vectors are
 * (x3, 1) x (x2^2, x2, 1). With A2, A1, A0 the blocks of x3^2, x3, 1 the matrix is
 * [A2 A1 A0 0; 0 A2 A1 A0]; reflections fold it to 9x9 and to 6x6. */
static inline general_5r1p_lane general_5r1p_fold(const double *E, general_5r1p_lane c,
    general_5r1p_lane s,
                                        general_5r1p_lane factor[6][6])
{
    general_5r1p_lane M[6][9], W[6][9], determinant;
    general_5r1p_lane *const rows[6] = {M[0], M[1], M[2], M[3], M[4], M[5]};
    general_5r1p_lane *const last[6] = {factor[0], factor[1], factor[2], factor[3], factor[4],
        factor[5]};
    const general_5r1p_lane zero = {0};
    GENERAL_5R1P_UNROLL
    for (int r = 0; r < 6; r++) {
        GENERAL_5R1P_UNROLL
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + 3 * (k % 3) + k / 3;
            M[r][k] = E[at] + E[9 + at] * c + E[18 + at] * s;
        }
    }
    determinant = general_5r1p_reflect(rows, 6, 0, 9);
    determinant *= general_5r1p_reflect(rows + 1, 5, 1, 9);
    determinant *= general_5r1p_reflect(rows + 2, 4, 2, 9);
    /* now M is [R B1 B0; 0 D1 D0]; the other shift has R B1 B0 under D1 D0 0 */
    GENERAL_5R1P_UNROLL
    for (int r = 0; r < 3; r++) {
        GENERAL_5R1P_UNROLL
        for (int k = 0; k < 9; k++) {
            W[r][k] = M[r][k];
            W[3 + r][k] = k < 6 ? M[3 + r][3 + k] : zero;
            if (k < 6) {
                factor[3 + r][k] = M[3 + r][3 + k];
            }
        }
    }
    GENERAL_5R1P_UNROLL
    for (int k = 0; k < 3; k++) {
        general_5r1p_lane *const four[4] = {W[k], W[3], W[4], W[5]};
        determinant *= general_5r1p_reflect(four, 4, k, 9);
    }
    GENERAL_5R1P_UNROLL
    for (int r = 0; r < 3; r++) {
        GENERAL_5R1P_UNROLL
        for (int k = 0; k < 6; k++) {
            factor[r][k] = W[3 + r][3 + k];
        }
    }
    determinant *= general_5r1p_reflect(last, 6, 0, 6);
    determinant *= general_5r1p_reflect(last + 1, 5, 1, 6);
    determinant *= general_5r1p_reflect(last + 2, 4, 2, 6);
    determinant *= general_5r1p_reflect(last + 3, 3, 3, 6);
    determinant *= general_5r1p_reflect(last + 4, 2, 4, 6);
    return determinant * factor[5][5];
}

/* How far the columns that are cleared first are from depending on each other: the square of the
 * least singular value of A2 over that of the norm of [A2 A1 A0], or a third of it, as det and
 * minors of A2' A2 say. Where x3 is nearly infinite they do depend on each other if the matrix is
 * singular, and the factor does not show it. */
static inline general_5r1p_lane general_5r1p_independence(const double *E, general_5r1p_lane c,
    general_5r1p_lane s)
{
    general_5r1p_lane squares = {0}, A[6][3], G[3][3];
    for (int r = 0; r < 6; r++) {
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + k;
            const general_5r1p_lane x = E[at] + E[9 + at] * c + E[18 + at] * s;
            squares += x * x;
            if (k % 3 == 0) {
                A[r][k / 3] = x;
            }
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int j = i; j < 3; j++) {
            G[i][j] = A[0][i] * A[0][j];
            for (int r = 1; r < 6; r++) {
                G[i][j] += A[r][i] * A[r][j];
            }
        }
    }
    const general_5r1p_lane first = G[1][1] * G[2][2] - G[1][2] * G[1][2];
    const general_5r1p_lane minors = first + G[0][0] * G[2][2] - G[0][2] * G[0][2] + G[0][0] *
        G[1][1] - G[0][1] * G[0][1];
    const general_5r1p_lane det = G[0][0] * first - G[0][1] * (G[0][1] * G[2][2] - G[1][2] *
        G[0][2]) +
                         G[0][2] * (G[0][1] * G[1][2] - G[1][1] * G[0][2]);
    return det / (minors * squares + 1e-300);
}

/* f(x) = sum a_m cos mx + b_m sin mx, m = 0 ... 8, and where it vanishes. */
typedef struct {
    double a[9], b[9];
    double scale;    /* the largest sample */
    double noise;    /* the harmonics beyond the eighth, over scale */
    double rounding; /* how far f may be from what it stands for */
    double touching; /* how far an extremum may be lifted for roots to meet there */
} general_5r1p_trigonometric;

/* f and f' at the edges of the cells; the first edge stands at the end again */
typedef struct {
    double value[264] GENERAL_5R1P_ALIGNED, slope[264] GENERAL_5R1P_ALIGNED;
} general_5r1p_grid;

/* The roots by their cosines and sines: `simple` of them change the sign of f, `doubles` touch zero
 * within the rounding of f (two roots, none or one); behind these stand `unseen` places where a
 * closer look shows no root. At `lifted` places f turns back beside zero: no root, unless rounding
 * of what f is made of has lifted it off. `complete` says that no cell was given up. */
typedef struct {
    int simple, doubles, unseen, lifted, complete;
    double c[GENERAL_5R1P_ROOTS + 8], s[GENERAL_5R1P_ROOTS + 8];
    double double_c[GENERAL_5R1P_ROOTS], double_s[GENERAL_5R1P_ROOTS];
    double lifted_c[GENERAL_5R1P_ROOTS], lifted_s[GENERAL_5R1P_ROOTS];
} general_5r1p_roots;

/* What part of the circle is searched: the cell in its middle, how many it has on both sides, and
 * the value of a parabola over its bend where two complex roots count as a double one. */
typedef struct {
    int middle, reach;
    double lifted;
} general_5r1p_window;

static void general_5r1p_fit(const double samples[24], general_5r1p_trigonometric *f)
{
    double h[24] = {0.0}, most = 0.0, beyond = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    for (int k = 0; k < 24; k++) {
        for (int j = 0; j < 24; j++) {
            h[j] += samples[k] * general_5r1p_harmonics[k][j];
        }
    }
    for (int j = 17; j < 24; j++) {
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
    f->rounding = most * (3e-15 + 64.0 * f->noise);
    f->touching = f->rounding + most * 2e-09;
}

/* f, f', f'' where the cosine and sine are given */
static void general_5r1p_at(const general_5r1p_trigonometric *f, double cosine, double sine, double
    out[3])
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
static void general_5r1p_fill_grid(const general_5r1p_trigonometric *f, general_5r1p_grid *g)
{
    const double *const a = f->a, *const b = f->b;
    for (int i = 0; i < 128; i += GENERAL_5R1P_LANES) {
        /* even multiples, the same half a turn on; odd ones, the opposite there */
        general_5r1p_lane even = general_5r1p_all(a[0]), odd = general_5r1p_all(0.0);
        general_5r1p_lane even_slope = odd, odd_slope = odd;
        GENERAL_5R1P_UNROLL
        for (int m = 1; m < 9; m += 2) {
            const general_5r1p_lane c = GENERAL_5R1P_LOAD(&general_5r1p_grid_c[m - 1][i]), s =
                GENERAL_5R1P_LOAD(&general_5r1p_grid_s[m - 1][i]);
            odd += a[m] * c + b[m] * s;
            odd_slope += m * b[m] * c - m * a[m] * s;
        }
        GENERAL_5R1P_UNROLL
        for (int m = 2; m < 9; m += 2) {
            const general_5r1p_lane c = GENERAL_5R1P_LOAD(&general_5r1p_grid_c[m - 1][i]), s =
                GENERAL_5R1P_LOAD(&general_5r1p_grid_s[m - 1][i]);
            even += a[m] * c + b[m] * s;
            even_slope += m * b[m] * c - m * a[m] * s;
        }
        GENERAL_5R1P_STORE(&g->value[i], even + odd);
        GENERAL_5R1P_STORE(&g->value[i + 128], even - odd);
        GENERAL_5R1P_STORE(&g->slope[i], even_slope + odd_slope);
        GENERAL_5R1P_STORE(&g->slope[i + 128], even_slope - odd_slope);
    }
    g->value[256] = g->value[0];
    g->slope[256] = g->slope[0];
}

/* Which of 64 cells may have roots: those where the Bernstein coefficients of the cubic through f
 * and f' at both edges are not all of the sign of the first beyond doubt. */
static unsigned long long general_5r1p_open_cells(const general_5r1p_grid *g, int from, double
    doubt)
{
    const double third = 0.02454369260617026 / 3.0;
    unsigned long long bits = 0;
#if GENERAL_5R1P_LANES > 1
    general_5r1p_mask weight, sum = {0};
    for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
        weight[k] = 1LL << k;
    }
#endif
    for (int i = 0; i < 64; i += GENERAL_5R1P_LANES) {
        const general_5r1p_lane first = GENERAL_5R1P_LOAD(&g->value[from + i]);
        const general_5r1p_lane f0 = general_5r1p_abs(first) - doubt;
        const general_5r1p_lane f1 = general_5r1p_facing(GENERAL_5R1P_LOAD(&g->value[from + i + 1]),
            first) - doubt;
        const general_5r1p_lane d0 = general_5r1p_facing(GENERAL_5R1P_LOAD(&g->slope[from + i]),
            first);
        const general_5r1p_lane d1 = general_5r1p_facing(GENERAL_5R1P_LOAD(&g->slope[from + i + 1]),
            first);
        const general_5r1p_lane b1 = f0 + third * d0, b2 = f1 - third * d1;
#if GENERAL_5R1P_LANES > 1
        const general_5r1p_mask signs = (general_5r1p_mask)f0 | (general_5r1p_mask)f1 |
            (general_5r1p_mask)b1 | (general_5r1p_mask)b2;
        sum |= ((signs < 0) & weight) << i;
#else
        bits |= (unsigned long long)(f0 < 0.0 || f1 < 0.0 || b1 < 0.0 || b2 < 0.0) << i;
#endif
    }
#if GENERAL_5R1P_LANES > 1
    for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
        bits |= (unsigned long long)sum[k];
    }
#endif
    return bits;
}

static void general_5r1p_add_angle(double c, double s, double *cosine, double *sine, int *count, int
    *complete)
{
    if (*count == GENERAL_5R1P_ROOTS) {
        *complete = 0;
        return;
    }
    cosine[*count] = c;
    sine[*count] = s;
    *count += 1;
}

/* The same unless it is there: neighbouring cells may be given up together. */
static void general_5r1p_add_once(double c, double s, double *cosine, double *sine, int *count, int
    *complete)
{
    for (int i = 0; i < *count; i++) {
        const double gap = fabs(s * cosine[i] - c * sine[i]);
        if (gap < 0.02454369260617026 / 64.0 && c * cosine[i] + s * sine[i] > 0.0) {
            return;
        }
    }
    general_5r1p_add_angle(c, s, cosine, sine, count, complete);
}

static void general_5r1p_add_simple(general_5r1p_roots *roots, double c, double s)
{
    general_5r1p_add_angle(c, s, roots->c, roots->s, &roots->simple, &roots->complete);
}

static void general_5r1p_add_double(general_5r1p_roots *roots, double c, double s)
{
    general_5r1p_add_once(c, s, roots->double_c, roots->double_s, &roots->doubles,
        &roots->complete);
}

static void general_5r1p_add_lifted(general_5r1p_roots *roots, double c, double s)
{
    general_5r1p_add_once(c, s, roots->lifted_c, roots->lifted_s, &roots->lifted, &roots->complete);
}

/* Parts of the circle: cosine and sine where each begins, its width, f, f', f'' at both ends, and
 * about where what is looked for lies, in parts of the width. */
typedef struct {
    int count;
    double c[48], s[48], width[48], start[48];
    double low[3][48], high[3][48];
} general_5r1p_parts;

/* Parts where f turns once, and parts where it rises or falls throughout and has a root. */
typedef struct {
    double lifted; /* as of the window */
    general_5r1p_parts turning, crossing;
} general_5r1p_waiting;

static void general_5r1p_add_part(general_5r1p_parts *parts, double c, double s, double width, const
    double low[3],
                             const double high[3], double start)
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
    general_5r1p_lane c, s, width, start, low[3], high[3];
} general_5r1p_spans;

/* Parts from one on; behind the last one it stands again. */
static void general_5r1p_take_parts(general_5r1p_parts *parts, int from, general_5r1p_spans *out)
{
    const int last = parts->count - 1;
    while (parts->count < from + GENERAL_5R1P_LANES) {
        const double low[3] = {parts->low[0][last], parts->low[1][last], parts->low[2][last]};
        const double high[3] = {parts->high[0][last], parts->high[1][last], parts->high[2][last]};
        general_5r1p_add_part(parts, parts->c[last], parts->s[last], parts->width[last], low, high,
                         parts->start[last]);
    }
    parts->count = last + 1;
    out->c = GENERAL_5R1P_LOAD(parts->c + from);
    out->s = GENERAL_5R1P_LOAD(parts->s + from);
    out->width = GENERAL_5R1P_LOAD(parts->width + from);
    out->start = GENERAL_5R1P_LOAD(parts->start + from);
    for (int i = 0; i < 3; i++) {
        out->low[i] = GENERAL_5R1P_LOAD(parts->low[i] + from);
        out->high[i] = GENERAL_5R1P_LOAD(parts->high[i] + from);
    }
}

/* Where the quintic through f, f', f'' at both ends vanishes (order 0), or its derivative (order
 * 1), in parts of the width. */
static inline general_5r1p_lane general_5r1p_on_quintic(int order, const general_5r1p_spans *part)
{
    const general_5r1p_lane h = part->width, d = h * part->low[1], s = h * h * part->low[2];
    const general_5r1p_lane D = part->high[0] - part->low[0] - d - 0.5 * s;
    const general_5r1p_lane D1 = h * part->high[1] - d - s, D2 = h * h * part->high[2] - s;
    const general_5r1p_lane c3 = 10.0 * D - 4.0 * D1 + 0.5 * D2, c4 = 7.0 * D1 - 15.0 * D - D2;
    const general_5r1p_lane c5 = 6.0 * D - 3.0 * D1 + 0.5 * D2;
    const general_5r1p_mask rising = part->low[order] < 0.0;
    general_5r1p_lane x = part->start, from = general_5r1p_all(0.0), to = general_5r1p_all(1.0);
    for (int i = 0; i < 4; i++) {
        const general_5r1p_lane f = part->low[0] + x * (d + x * (0.5 * s + x * (c3 + x * (c4 + x *
            c5))));
        const general_5r1p_lane f1 = d + x * (s + x * (3.0 * c3 + x * (4.0 * c4 + x * (5.0 * c5))));
        const general_5r1p_lane f2 = s + x * (6.0 * c3 + x * (12.0 * c4 + x * (20.0 * c5)));
        const general_5r1p_lane value = order ? f1 : f, slope = order ? f2 : f1;
        const general_5r1p_mask before = (value < 0.0) == rising;
        from = general_5r1p_select(before, x, from);
        to = general_5r1p_select(before, to, x);
        x -= value / slope;
        x = general_5r1p_select((x >= from) & (x <= to), x, 0.5 * (from + to));
    }
    return x;
}

/* f, f', f'' where cosine and sine are given */
static inline void general_5r1p_at_all(const general_5r1p_trigonometric *f, general_5r1p_lane
    cosine, general_5r1p_lane sine,
                                  general_5r1p_lane out[3])
{
    general_5r1p_lane c[9], s[9];
    c[1] = cosine;
    s[1] = sine;
    out[0] = general_5r1p_all(f->a[0]);
    out[1] = out[2] = general_5r1p_all(0.0);
    for (int m = 1; m < 9; m++) {
        const int less = m / 2, more = m - m / 2;
        if (less) {
            c[m] = c[less] * c[more] - s[less] * s[more];
            s[m] = s[less] * c[more] + c[less] * s[more];
        }
        const general_5r1p_lane even = f->a[m] * c[m] + f->b[m] * s[m], odd = f->b[m] * c[m] -
            f->a[m] * s[m];
        out[0] += even;
        out[1] += m * odd;
        out[2] -= m * m * even;
    }
}

/* Turn on by a small angle, no larger than a cell. */
static inline void general_5r1p_turn_on(general_5r1p_lane x, general_5r1p_lane *c, general_5r1p_lane
    *s)
{
    const general_5r1p_lane u = x * x, c0 = *c, s0 = *s;
    const general_5r1p_lane dc = 1.0 - u * (0.5 - u * (1.0 / 24.0 - u * (1.0 / 720.0)));
    const general_5r1p_lane ds = x * (1.0 - u * (1.0 / 6.0 - u * (1.0 / 120.0 - u * (1.0 /
        5040.0))));
    *c = c0 * dc - s0 * ds;
    *s = s0 * dc + c0 * ds;
}

/* Where f (order 0) or f' (order 1) vanishes: from where the quintic says by Newton, with bisection
 * where it leaves. Returns how far that is from where each part begins, with cosine and sine, and
 * f, f', f'' there, as far as an extremum is concerned. */
static inline general_5r1p_lane general_5r1p_between(const general_5r1p_trigonometric *f, int order,
    double settled,
                                           const general_5r1p_spans *part, general_5r1p_lane *c,
                                               general_5r1p_lane *s,
                                           general_5r1p_lane at[3])
{
    const general_5r1p_mask rising = part->low[order] < 0.0;
    general_5r1p_lane from = general_5r1p_all(0.0), to = part->width, x = part->width *
        general_5r1p_on_quintic(order, part);
    general_5r1p_lane step = part->width;
    for (int i = 0; i < 48; i++) {
        const general_5r1p_mask moving = general_5r1p_abs(step) >= settled;
        if (i && general_5r1p_largest(general_5r1p_abs(step)) < settled) {
            break;
        }
        *c = part->c;
        *s = part->s;
        general_5r1p_turn_on(x, c, s);
        general_5r1p_at_all(f, *c, *s, at);
        const general_5r1p_mask before = (at[order] < 0.0) == rising;
        from = general_5r1p_select(before, x, from);
        to = general_5r1p_select(before, to, x);
        step = -at[order] / at[order + 1];
        step = general_5r1p_select((x + step >= from) & (x + step <= to), step, 0.5 * (from + to) -
            x);
        step = general_5r1p_select(moving, step, general_5r1p_all(0.0));
        x += step;
    }
    general_5r1p_turn_on(step, c, s);
    at[0] += 0.5 * step * at[1]; /* what a parabola gains where its slope vanishes */
    return x;
}

/* The double root, or the parts with a root, of a part of the circle whose extremum is known. */
static void general_5r1p_divide(const general_5r1p_trigonometric *f, const general_5r1p_parts
    *parts, int i, double x,
                           double c, double s, const double at[3], general_5r1p_waiting *waiting,
                           general_5r1p_roots *roots)
{
    const double bend = fabs(at[2]) * waiting->lifted, near = bend > f->touching ? bend :
        f->touching;
    const double beside = fabs(at[0]);
    const double low[3] = {parts->low[0][i], parts->low[1][i], parts->low[2][i]};
    const double high[3] = {parts->high[0][i], parts->high[1][i], parts->high[2][i]};
    if (beside <= f->rounding) {
        general_5r1p_add_double(roots, c, s);
        return;
    }
    if (at[0] * at[2] > 0.0 && beside <= near) {
        general_5r1p_add_lifted(roots, c, s);
        return;
    }
    /* where a parabola with its summit at the extremum has its roots */
    if ((low[0] < 0.0) != (at[0] < 0.0)) {
        general_5r1p_add_part(&waiting->crossing, parts->c[i], parts->s[i], x, low, at,
                         1.0 - sqrt(at[0] / (at[0] - low[0])));
    }
    if ((high[0] < 0.0) != (at[0] < 0.0)) {
        general_5r1p_add_part(&waiting->crossing, c, s, parts->width[i] - x, at, high,
                         sqrt(at[0] / (at[0] - high[0])));
    }
}

/* The roots of all parts that wait. */
static void general_5r1p_solve_parts(const general_5r1p_trigonometric *f, general_5r1p_waiting
    *waiting, general_5r1p_roots *roots)
{
    general_5r1p_parts *const bent = &waiting->turning, *const crossing = &waiting->crossing;
    double x[GENERAL_5R1P_LANES], c[GENERAL_5R1P_LANES], s[GENERAL_5R1P_LANES],
        value[3][GENERAL_5R1P_LANES];
    general_5r1p_spans part;
    general_5r1p_lane cosine, sine, at[3];
    for (int from = 0; from < bent->count; from += GENERAL_5R1P_LANES) {
        general_5r1p_take_parts(bent, from, &part);
        GENERAL_5R1P_STORE(x, general_5r1p_between(f, 1, 1e-07, &part, &cosine, &sine, at));
        GENERAL_5R1P_STORE(c, cosine);
        GENERAL_5R1P_STORE(s, sine);
        for (int i = 0; i < 3; i++) {
            GENERAL_5R1P_STORE(value[i], at[i]);
        }
        for (int k = 0; k < GENERAL_5R1P_LANES && from + k < bent->count; k++) {
            const double extremum[3] = {value[0][k], 0.0, value[2][k]};
            general_5r1p_divide(f, bent, from + k, x[k], c[k], s[k], extremum, waiting, roots);
        }
    }
    for (int from = 0; from < crossing->count; from += GENERAL_5R1P_LANES) {
        general_5r1p_take_parts(crossing, from, &part);
        (void)general_5r1p_between(f, 0, 1e-09, &part, &cosine, &sine, at);
        GENERAL_5R1P_STORE(c, cosine);
        GENERAL_5R1P_STORE(s, sine);
        for (int k = 0; k < GENERAL_5R1P_LANES && from + k < crossing->count; k++) {
            general_5r1p_add_simple(roots, c[k], s[k]);
        }
    }
    bent->count = crossing->count = 0;
}

/* A part where f has one extremum at most waits for others, to be solved in lanes. */
static void general_5r1p_few(const general_5r1p_trigonometric *f, double c, double s, double width,
    const double low[3],
                        const double high[3], general_5r1p_waiting *waiting, general_5r1p_roots
                            *roots)
{
    if (low[1] * high[1] < 0.0) {
        general_5r1p_add_part(&waiting->turning, c, s, width, low, high, low[1] / (low[1] -
            high[1]));
    } else if ((low[0] < 0.0) != (high[0] < 0.0)) {
        general_5r1p_add_part(&waiting->crossing, c, s, width, low, high, low[0] / (low[0] -
            high[0]));
    }
    if (waiting->turning.count == 16 || waiting->crossing.count == 16) {
        general_5r1p_solve_parts(f, waiting, roots);
    }
}

/* What is known about f in a part of the circle. */
enum { GENERAL_5R1P_ROOTLESS, GENERAL_5R1P_FLAT, GENERAL_5R1P_TAME, GENERAL_5R1P_WILD };

/* Rootless; flat, nothing but rounding; tame, with one extremum at most; or none of these. The
 * Bernstein coefficients of the quintic through f, f', f'' at both ends and their differences bound
 * f, f' and f''. */
static inline void general_5r1p_kinds(const general_5r1p_trigonometric *f, const general_5r1p_spans
    *part, int kind[GENERAL_5R1P_LANES])
{
    const general_5r1p_lane h = part->width, d0 = h * part->low[1] * 0.2, d1 = h * part->high[1] *
        0.2;
    const general_5r1p_lane s0 = h * h * part->low[2] * 0.05, s1 = h * h * part->high[2] * 0.05;
    const general_5r1p_lane share = h * (1.0 / 0.02454369260617026), square = share * share;
    const general_5r1p_lane doubt = f->rounding + f->scale * 2e-09 * square * square * square;
    const general_5r1p_lane b[6] = {part->low[0],
                           part->low[0] + d0,
                           part->low[0] + 2.0 * d0 + s0,
                           part->high[0] - 2.0 * d1 + s1,
                           part->high[0] - d1,
                           part->high[0]};
    general_5r1p_lane least[3], most[3];
    double bounds[5][GENERAL_5R1P_LANES];
    least[0] = general_5r1p_min(b[0], b[5]);
    most[0] = general_5r1p_max(b[0], b[5]);
    least[1] = most[1] = b[1] - b[0];
    least[2] = most[2] = b[2] - b[1] - least[1];
    for (int i = 1; i < 5; i++) {
        const general_5r1p_lane first = b[i + 1] - b[i], second = first - (b[i] - b[i - 1]);
        least[0] = general_5r1p_min(least[0], b[i]);
        most[0] = general_5r1p_max(most[0], b[i]);
        least[1] = general_5r1p_min(least[1], first);
        most[1] = general_5r1p_max(most[1], first);
        least[2] = general_5r1p_min(least[2], second);
        most[2] = general_5r1p_max(most[2], second);
    }
    /* what rounding does to f' and f'' shrinks with the width, down to that of the quintic's
     * ends */
    GENERAL_5R1P_STORE(bounds[0], least[0]);
    GENERAL_5R1P_STORE(bounds[1], most[0]);
    GENERAL_5R1P_STORE(bounds[2], general_5r1p_max(least[1], -most[1]) - doubt * share);
    GENERAL_5R1P_STORE(bounds[3], general_5r1p_max(least[2], -most[2]) - doubt * square);
    GENERAL_5R1P_STORE(bounds[4], general_5r1p_max(doubt, general_5r1p_all(f->touching)));
    for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
        if (bounds[0][k] > bounds[4][k] || bounds[1][k] < -bounds[4][k]) {
            kind[k] = GENERAL_5R1P_ROOTLESS;
        } else if (bounds[0][k] >= -f->rounding && bounds[1][k] <= f->rounding) {
            kind[k] = GENERAL_5R1P_FLAT;
        } else {
            kind[k] = bounds[2][k] > 0.0 || bounds[3][k] > 0.0 ? GENERAL_5R1P_TAME :
                GENERAL_5R1P_WILD;
        }
    }
}

/* The same of one part. */
static int general_5r1p_kind(const general_5r1p_trigonometric *f, const double low[3], const double
    high[3], double h)
{
    general_5r1p_spans part;
    int kind[GENERAL_5R1P_LANES];
    part.width = general_5r1p_all(h);
    for (int i = 0; i < 3; i++) {
        part.low[i] = general_5r1p_all(low[i]);
        part.high[i] = general_5r1p_all(high[i]);
    }
    general_5r1p_kinds(f, &part, kind);
    return kind[0];
}

/* The roots of a cell where f may turn more than once: halve it until it does not. */
static void general_5r1p_many(const general_5r1p_trigonometric *f, double low, double c, double s,
    const double first[3],
                         const double last[3], int *budget, general_5r1p_waiting *waiting,
                         general_5r1p_roots *roots)
{
    /* the upper edges still to come */
    double edge[16], edge_c[16], edge_s[16], at[16][3];
    double at_low[3];
    int depth[16], open = 1;
    edge[0] = low + 0.02454369260617026;
    edge_c[0] = edge_s[0] = 0.0; /* nothing begins there */
    depth[0] = 0;
    for (int i = 0; i < 3; i++) {
        at_low[i] = first[i];
        at[0][i] = last[i];
    }
    while (open > 0) {
        const int top = open - 1;
        const double h = edge[top] - low;
        const int kind = general_5r1p_kind(f, at_low, at[top], h);
        if (kind == GENERAL_5R1P_TAME) {
            general_5r1p_few(f, c, s, h, at_low, at[top], waiting, roots);
        } else if (kind != GENERAL_5R1P_ROOTLESS) {
            const double middle = low + 0.5 * h, cosine = cos(middle), sine = sin(middle);
            if (kind == GENERAL_5R1P_FLAT || depth[top] == 14 || *budget == 0) {
                general_5r1p_solve_parts(f, waiting, roots); /* of neighbouring double roots the
                    first is kept */
                roots->complete = 0;
                general_5r1p_add_double(roots, cosine, sine);
            } else {
                *budget -= 1;
                edge[open] = middle;
                edge_c[open] = cosine;
                edge_s[open] = sine;
                depth[top] += 1;
                depth[open] = depth[top];
                general_5r1p_at(f, cosine, sine, at[open]);
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
static void general_5r1p_edge(int cell, double *c, double *s)
{
    const int half = cell % 128;
    *c = cell < 128 ? general_5r1p_grid_c[0][half] : -general_5r1p_grid_c[0][half];
    *s = cell < 128 ? general_5r1p_grid_s[0][half] : -general_5r1p_grid_s[0][half];
}

static int general_5r1p_lowest(unsigned long long bits)
{
#ifdef __GNUC__
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
static void general_5r1p_search_cells(const general_5r1p_trigonometric *f, const general_5r1p_grid
    *g, const int *cell, int count,
                                 int *budget, general_5r1p_waiting *waiting, general_5r1p_roots
                                     *roots)
{
    const double h = 0.02454369260617026;
    double in[8][GENERAL_5R1P_LANES], bend[2][GENERAL_5R1P_LANES];
    int kind[GENERAL_5R1P_LANES];
    general_5r1p_spans part;
    for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
        const int i = cell[k < count ? k : 0];
        in[0][k] = g->value[i];
        in[1][k] = g->slope[i];
        in[2][k] = g->value[i + 1];
        in[3][k] = g->slope[i + 1];
        general_5r1p_edge(i, &in[4][k], &in[5][k]);
        general_5r1p_edge((i + 1) % 256, &in[6][k], &in[7][k]);
    }
    part.width = general_5r1p_all(h);
    for (int end = 0; end < 2; end++) {
        general_5r1p_lane at[3], *const to = end ? part.high : part.low;
        general_5r1p_at_all(f, GENERAL_5R1P_LOAD(in[4 + 2 * end]), GENERAL_5R1P_LOAD(in[5 + 2 *
            end]), at);
        /* the edges' own values, so that neighbouring cells agree about their signs */
        to[0] = GENERAL_5R1P_LOAD(in[2 * end]);
        to[1] = GENERAL_5R1P_LOAD(in[2 * end + 1]);
        to[2] = at[2];
        GENERAL_5R1P_STORE(bend[end], at[2]);
    }
    general_5r1p_kinds(f, &part, kind);
    for (int k = 0; k < count; k++) {
        const double low[3] = {in[0][k], in[1][k], bend[0][k]};
        const double high[3] = {in[2][k], in[3][k], bend[1][k]};
        if (kind[k] == GENERAL_5R1P_TAME) {
            general_5r1p_few(f, in[4][k], in[5][k], h, low, high, waiting, roots);
        } else if (kind[k] != GENERAL_5R1P_ROOTLESS) {
            general_5r1p_many(f, cell[k] * h, in[4][k], in[5][k], low, high, budget, waiting,
                roots);
        }
    }
}

static void general_5r1p_find_roots(const general_5r1p_trigonometric *f, const general_5r1p_window
    *window,
                               general_5r1p_roots *roots)
{
    general_5r1p_grid g;
    general_5r1p_waiting waiting;
    int open[256], count = 0;
    int budget = 100; /* against an f that is next to nothing for long stretches */
    general_5r1p_fill_grid(f, &g);
    roots->simple = roots->doubles = roots->unseen = roots->lifted = 0;
    roots->complete = 1;
    for (int word = 0; word < 256 / 64; word++) {
        unsigned long long bits =
            general_5r1p_open_cells(&g, 64 * word, f->rounding + f->scale * 2e-05);
        for (; bits; bits &= bits - 1) {
            const int i = 64 * word + general_5r1p_lowest(bits);
            const int away = i > window->middle ? i - window->middle : window->middle - i;
            if (away <= window->reach || 256 - away <= window->reach) {
                open[count++] = i;
            }
        }
    }
    waiting.lifted = window->lifted;
    waiting.turning.count = waiting.crossing.count = 0;
    for (int k = 0; k < count; k += GENERAL_5R1P_LANES) {
        general_5r1p_search_cells(f, &g, open + k, count - k < GENERAL_5R1P_LANES ? count - k :
            GENERAL_5R1P_LANES, &budget,
                             &waiting, roots);
    }
    general_5r1p_solve_parts(f, &waiting, roots);
}

/* A lens on the circle: e^(i phi) = (w + a) / (1 + conj(a) w) with a = x + i y inside the circle
 * maps the circle of w = e^(i psi) to itself and shows what lies around the direction of a larger.
 * Where all roots lie together, as near the boundary of reach, f drowns in rounding without it. */
typedef struct {
    double x, y;
} general_5r1p_lens;

/* Cosine and sine of phi from those of psi. Returns |1 + conj(a) w|^2, whose eighth power makes of
 * f a polynomial in psi. */
static inline general_5r1p_lane general_5r1p_through(const general_5r1p_lens *a, general_5r1p_lane
    *c, general_5r1p_lane *s)
{
    const general_5r1p_lane u = *c + a->x, v = *s + a->y;
    const general_5r1p_lane d = 1.0 + a->x * *c + a->y * *s, e = a->x * *s - a->y * *c;
    const general_5r1p_lane square = d * d + e * e;
    *c = (u * d + v * e) / square;
    *s = (v * d - u * e) / square;
    return square;
}

/* The samples of f in phi become those of a polynomial in psi. */
static inline general_5r1p_lane general_5r1p_weighted(general_5r1p_lane f, general_5r1p_lane square)
{
    const general_5r1p_lane fourth = square * square, eighth = fourth * fourth;
    return f * (eighth * eighth);
}

/* The lens under which the roots are spread, from samples without one; 0 when they are already. log
 * |f| is a sum over the roots z, and the first harmonic of log |e^(i phi) - z| is -z for z inside
 * the circle, that of its mirror image for z outside. */
static int general_5r1p_spread(const double samples[24], general_5r1p_lens *a)
{
    double x = 0.0, y = 0.0, square, part;
    for (int k = 0; k < 12; k++) {
        const double ratio = log((fabs(samples[k]) + 1e-300) / (fabs(samples[k + 12]) + 1e-300));
        x += ratio * general_5r1p_sample_c[k];
        y += ratio * general_5r1p_sample_s[k];
    }
    x *= -0.005208333333333333;
    y *= -0.005208333333333333;
    square = x * x + y * y;
    if (!(square > 0.12249999999999998)) {
        return 0;
    }
    part = fmin(1.0, 0.9 / sqrt(square));
    a->x = part * x;
    a->y = part * y;
    return 1;
}

/* Roots as they are without the lens. */
static void general_5r1p_behind(const general_5r1p_lens *a, int count, double *cosine, double *sine)
{
    for (int i = 0; i < count; i += GENERAL_5R1P_LANES) {
        general_5r1p_lane c = GENERAL_5R1P_LOAD(cosine + i), s = GENERAL_5R1P_LOAD(sine + i);
        (void)general_5r1p_through(a, &c, &s);
        GENERAL_5R1P_STORE(cosine + i, c);
        GENERAL_5R1P_STORE(sine + i, s);
    }
}

/* Samples of a polynomial through a lens; `of` is what it is made of. */
typedef void (*general_5r1p_sampler)(const void *of, const general_5r1p_lens *lens, double
    samples[24]);

/* Keeps of angles beside which there is no root, as far as f tells, those where what it is made of
 * allows one; returns how many. */
typedef int (*general_5r1p_keeper)(const void *of, int count, double *cosine, double *sine);

/* What f is made of, and what tells of it; `keep` may be 0, where nothing tells. */
typedef struct {
    general_5r1p_sampler sample;
    general_5r1p_keeper keep;
    const void *of;
} general_5r1p_source;

/* Whether two angles, by their cosines and sines, are as near as a closer look reaches. */
static int general_5r1p_near(double c, double s, double cosine, double sine)
{
    return c * cosine + s * sine >= 0.9980487804878049;
}

/* Of roots those that are near to an angle, or those that are not, behind `count` that are kept. */
static int general_5r1p_keep_roots(int near, double cosine, double sine, const double *from_c,
                              const double *from_s, int many, double *c, double *s, int count)
{
    for (int i = 0; i < many && count < GENERAL_5R1P_ROOTS; i++) {
        if (general_5r1p_near(from_c[i], from_s[i], cosine, sine) == near) {
            c[count] = from_c[i];
            s[count] = from_s[i];
            count++;
        }
    }
    return count;
}

static int general_5r1p_kept(const general_5r1p_source *source, int count, double *cosine, double
    *sine)
{
    return source->keep ? source->keep(source->of, count, cosine, sine) : count;
}

/* The places where f turns back beside zero are double roots where there may be any. */
static void general_5r1p_take_lifted(const general_5r1p_source *source, general_5r1p_roots *roots)
{
    const int count = general_5r1p_kept(source, roots->lifted, roots->lifted_c, roots->lifted_s);
    for (int i = 0; i < count; i++) {
        general_5r1p_add_double(roots, roots->lifted_c[i], roots->lifted_s[i]);
    }
}

/* The roots around an angle, through a lens that magnifies what is there, instead of those that
 * were known. Returns 0, and leaves these, where that does not show all. */
static int general_5r1p_magnify(const general_5r1p_source *source, double cosine, double sine,
    general_5r1p_roots *roots)
{
    const general_5r1p_lens lens = { 0.8823529411764706 * cosine, 0.8823529411764706 * sine};
    const double turns = atan2(sine, cosine) / 6.283185307179586;
    const int cell = (int)(256.0 * (turns - floor(turns))) % 256;
    const general_5r1p_window window = {cell, 38, 1.28e-06};
    double samples[24];
    general_5r1p_trigonometric f;
    general_5r1p_roots found;
    source->sample(source->of, &lens, samples);
    general_5r1p_fit(samples, &f);
    if (!(f.noise <= 1e-10)) {
        return 0;
    }
    general_5r1p_find_roots(&f, &window, &found);
    if (!found.complete) {
        return 0;
    }
    general_5r1p_behind(&lens, found.simple, found.c, found.s);
    general_5r1p_behind(&lens, found.doubles, found.double_c, found.double_s);
    general_5r1p_behind(&lens, found.lifted, found.lifted_c, found.lifted_s);
    general_5r1p_take_lifted(source, &found);
    roots->simple = general_5r1p_keep_roots(0, cosine, sine, roots->c, roots->s, roots->simple,
                                       roots->c, roots->s, 0);
    roots->doubles = general_5r1p_keep_roots(0, cosine, sine, roots->double_c, roots->double_s,
                                        roots->doubles, roots->double_c, roots->double_s, 0);
    roots->simple = general_5r1p_keep_roots(1, cosine, sine, found.c, found.s, found.simple,
                                       roots->c, roots->s, roots->simple);
    roots->doubles = general_5r1p_keep_roots(1, cosine, sine, found.double_c, found.double_s,
                                        found.doubles, roots->double_c, roots->double_s,
                                        roots->doubles);
    return 1;
}

/* Whether any root is near to an angle. */
static int general_5r1p_any_near(const general_5r1p_roots *roots, double cosine, double sine)
{
    int any = 0;
    for (int i = 0; i < roots->simple; i++) {
        any |= general_5r1p_near(roots->c[i], roots->s[i], cosine, sine);
    }
    for (int i = 0; i < roots->doubles; i++) {
        any |= general_5r1p_near(roots->double_c[i], roots->double_s[i], cosine, sine);
    }
    return any;
}

/* Where roots may be double they are replaced by what a closer look shows: values that are computed
 * there have the digits that the fit of f lacks, not those that the equations lack behind f. What
 * was given up stands among them. */
static void general_5r1p_look_closer(const general_5r1p_source *source, general_5r1p_roots *roots)
{
    double c[4], s[4], empty_c[4], empty_s[4];
    int looks = 0, clear = 1, i = 0, empty = 0, emptied[4];
    if (roots->simple == GENERAL_5R1P_ROOTS || roots->doubles == GENERAL_5R1P_ROOTS) {
        return;
    }
    while (i < roots->doubles) {
        int seen = 0;
        for (int k = 0; k < looks; k++) {
            seen |= general_5r1p_near(roots->double_c[i], roots->double_s[i], c[k], s[k]);
        }
        if (seen) {
            i++;
            continue;
        }
        if (looks == 4) {
            break;
        }
        c[looks] = roots->double_c[i];
        s[looks] = roots->double_s[i];
        emptied[looks] = general_5r1p_magnify(source, c[looks], s[looks], roots);
        clear &= emptied[looks];
        emptied[looks] &= !general_5r1p_any_near(roots, c[looks], s[looks]);
        looks++;
        i = 0;
    }
    for (int k = 0; k < looks; k++) {
        if (emptied[k]) {
            empty_c[empty] = c[k];
            empty_s[empty++] = s[k];
        }
    }
    empty = general_5r1p_kept(source, empty, empty_c, empty_s);
    for (int k = 0; k < empty && roots->doubles + k < GENERAL_5R1P_ROOTS; k++) {
        roots->double_c[roots->doubles + k] = empty_c[k];
        roots->double_s[roots->doubles + k] = empty_s[k];
        roots->unseen++;
    }
    roots->complete = roots->complete || (clear && i == roots->doubles);
}

/* Whether samples are nothing but rounding of zero, which may be as smooth as a polynomial. */
static int general_5r1p_is_nothing(const double samples[24])
{
    double most = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    return most <= 1e-26;
}

/* All real roots of a polynomial. Returns 0 where it vanishes identically. */
static int general_5r1p_real_roots(const general_5r1p_source *source, general_5r1p_roots *roots)
{
    const general_5r1p_window all = {0, 128, 5e-09};
    double samples[24];
    general_5r1p_trigonometric f;
    general_5r1p_lens lens = {0.0, 0.0};
    source->sample(source->of, &lens, samples);
    if (general_5r1p_is_nothing(samples)) {
        return 0;
    }
    if (general_5r1p_spread(samples, &lens)) {
        source->sample(source->of, &lens, samples);
    }
    general_5r1p_fit(samples, &f);
    if (!(f.noise <= 1e-06)) {
        return 0;
    }
    general_5r1p_find_roots(&f, &all, roots);
    general_5r1p_behind(&lens, roots->simple, roots->c, roots->s);
    general_5r1p_behind(&lens, roots->doubles, roots->double_c, roots->double_s);
    general_5r1p_behind(&lens, roots->lifted, roots->lifted_c, roots->lifted_s);
    general_5r1p_take_lifted(source, roots);
    general_5r1p_look_closer(source, roots);
    /* where f nearly vanishes identically it does not tell what there is not */
    roots->complete &= f.noise <= 1e-10;
    return 1;
}

/* Candidates: the hidden angle and a null vector, (x3, 1) x (x2^2, x2, 1) times anything. The
 * simple roots come first, one candidate each; after them those of roots that may be double,
 * `group` being the same for all that belong to one such root, which is none where the matrix is
 * regular: it has no singular value that is next to nothing, and not two small ones, as where so
 * many roots crowd that the determinant does not tell. */
typedef struct {
    int count, groups, group[GENERAL_5R1P_CANDIDATES], regular[GENERAL_5R1P_CANDIDATES];
    double c[GENERAL_5R1P_CANDIDATES], s[GENERAL_5R1P_CANDIDATES], n[6][GENERAL_5R1P_CANDIDATES];
} general_5r1p_candidates;

/* x = U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal. Returns what was
 * its length: the reciprocal of the square of the smallest singular value, in the end. */
static inline general_5r1p_lane general_5r1p_inverse_iteration(general_5r1p_lane U[6][6], const
    general_5r1p_lane inverse[6],
                                             general_5r1p_lane x[6])
{
    general_5r1p_lane square = {0};
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < i; j++) {
            x[i] -= U[j][i] * x[j];
        }
        x[i] *= inverse[i];
    }
    for (int i = 5; i >= 0; i--) {
        for (int j = i + 1; j < 6; j++) {
            x[i] -= U[i][j] * x[j];
        }
        x[i] *= inverse[i];
        square += x[i] * x[i];
    }
    const general_5r1p_lane length = general_5r1p_sqrt(square) + 1e-300;
    for (int i = 0; i < 6; i++) {
        x[i] *= 1.0 / length;
    }
    return length;
}

/* The reciprocals of a diagonal, kept finite. */
static inline void general_5r1p_reciprocals(general_5r1p_lane U[6][6], general_5r1p_lane inverse[6])
{
    general_5r1p_lane most = general_5r1p_abs(U[0][0]);
    for (int i = 1; i < 6; i++) {
        most = general_5r1p_max(most, general_5r1p_abs(U[i][i]));
    }
    most = most * 1e-15 + 1e-300;
    for (int i = 0; i < 6; i++) {
        const general_5r1p_lane d = U[i][i];
        inverse[i] = 1.0 / general_5r1p_select(general_5r1p_abs(d) > most, d,
            general_5r1p_with_sign(most, d));
    }
}

/* One candidate for each simple root, all of one group. */
static void general_5r1p_null_vectors(const double *E, const general_5r1p_roots *roots,
                                 general_5r1p_candidates *out)
{
    static const double start[6] = { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 };
    const int behind = out->count;
    for (int from = 0; from < roots->simple; from += GENERAL_5R1P_LANES) {
        double cs[2][GENERAL_5R1P_LANES];
        general_5r1p_lane factor[6][6], inverse[6], x[6], c, s;
        for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
            const int i = from + k < roots->simple ? from + k : from;
            cs[0][k] = roots->c[i];
            cs[1][k] = roots->s[i];
        }
        c = GENERAL_5R1P_LOAD(cs[0]);
        s = GENERAL_5R1P_LOAD(cs[1]);
        (void)general_5r1p_fold(E, c, s, factor);
        general_5r1p_reciprocals(factor, inverse);
        for (int i = 0; i < 6; i++) {
            x[i] = general_5r1p_all(start[i]);
        }
        (void)general_5r1p_inverse_iteration(factor, inverse, x);
        (void)general_5r1p_inverse_iteration(factor, inverse, x);
        GENERAL_5R1P_STORE(out->c + behind + from, c);
        GENERAL_5R1P_STORE(out->s + behind + from, s);
        for (int i = 0; i < 6; i++) {
            GENERAL_5R1P_STORE(out->n[i] + behind + from, x[i]);
        }
    }
    for (int i = 0; i < roots->simple; i++) {
        out->group[out->count++] = out->groups;
    }
    out->groups++;
}

/* The determinant itself, turned on by small angles: middle - apart, middle, middle + apart. */
static void general_5r1p_beside(const double *E, double c, double s, double middle, double apart,
    double f[8])
{
    static const double side[8] GENERAL_5R1P_ALIGNED = {-1.0, 0.0, 1.0};
    for (int k = 0; k < 3; k += GENERAL_5R1P_LANES) {
        general_5r1p_lane cosine = general_5r1p_all(c), sine = general_5r1p_all(s), factor[6][6];
        general_5r1p_turn_on(middle + apart * GENERAL_5R1P_LOAD(side + k), &cosine, &sine);
        GENERAL_5R1P_STORE(f + k, general_5r1p_fold(E, cosine, sine, factor));
    }
}

/* Two simple roots beside a place where roots may have met, if there are: the determinant itself
 * has digits there that its fit lacks. Each parabola is as wide as the one before says that they
 * are apart. */
static void general_5r1p_separate(const double *E, double c, double s, general_5r1p_roots *out)
{
    double middle = 0.0, apart = 0.0001;
    for (int round = 0; round < 3; round++) {
        double f[8], slope, bend, square;
        general_5r1p_beside(E, c, s, middle, apart, f);
        slope = 0.5 * (f[2] - f[0]);
        bend = 0.5 * (f[2] + f[0]) - f[1];
        square = slope * slope - 4.0 * bend * f[1];
        middle -= 0.5 * slope / bend * apart;
        apart *= sqrt(square) / fabs(bend);
        if (!(apart > 0.0 && fabs(middle) + apart < 0.0001)) {
            return; /* none, or apart so far that they are known */
        }
    }
    for (int sign = -1; sign <= 1 && out->simple < GENERAL_5R1P_ROOTS; sign += 2) {
        const double x = middle + 0.5 * sign * apart;
        out->c[out->simple] = c * cos(x) - s * sin(x);
        out->s[out->simple++] = s * cos(x) + c * sin(x);
    }
}

static void general_5r1p_add_candidate(general_5r1p_candidates *out, double c, double s, const
    double n[6])
{
    if (out->count == GENERAL_5R1P_CANDIDATES) {
        return;
    }
    out->group[out->count] = out->groups;
    out->c[out->count] = c;
    out->s[out->count] = s;
    for (int i = 0; i < 6; i++) {
        out->n[i][out->count] = n[i];
    }
    out->count++;
}

/* Vectors w of the plane with up w = x down w for some x (least squares): their sums of the two
 * null vectors become candidates. The shift's rows are n[up[i]] and n[down[i]]. */
static void general_5r1p_split(double n[2][6], int rows, const int *up, const int *down, double c,
                          double s, general_5r1p_candidates *out)
{
    double A[2][2] = { {0.0} }, G[2][2] = { {0.0} }, H[2][2] = { {0.0} };
    double M[2][2], det, det_h, half, spread;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            for (int k = 0; k < rows; k++) {
                A[i][j] += n[i][down[k]] * n[j][up[k]];
                G[i][j] += n[i][down[k]] * n[j][down[k]];
                H[i][j] += n[i][up[k]] * n[j][up[k]];
            }
        }
    }
    det = G[0][0] * G[1][1] - G[0][1] * G[0][1];
    det_h = H[0][0] * H[1][1] - H[0][1] * H[0][1];
    if (det < det_h) { /* 1/x is the better unknown */
        const double swap = A[0][1];
        A[0][1] = A[1][0];
        A[1][0] = swap;
        det = det_h;
        G[0][0] = H[0][0];
        G[0][1] = H[0][1];
        G[1][1] = H[1][1];
    }
    if (det < 1e-24) {
        return;
    }
    for (int j = 0; j < 2; j++) {
        M[0][j] = (G[1][1] * A[0][j] - G[0][1] * A[1][j]) / det;
        M[1][j] = (G[0][0] * A[1][j] - G[0][1] * A[0][j]) / det;
    }
    half = 0.5 * (M[0][0] - M[1][1]);
    spread = half * half + M[0][1] * M[1][0];
    spread = spread > 0.0 ? sqrt(spread) : 0.0;
    for (int sign = -1; sign <= 1; sign += 2) {
        /* (M - x) w = 0 from the longer of its rows */
        const double x = 0.5 * (M[0][0] + M[1][1]) + sign * spread;
        const double a = M[0][0] - x, d = M[1][1] - x;
        const int upper = fabs(a) + fabs(M[0][1]) > fabs(d) + fabs(M[1][0]);
        const double w0 = upper ? M[0][1] : d, w1 = upper ? -a : -M[1][0];
        double sum[6];
        for (int i = 0; i < 6; i++) {
            sum[i] = w0 * n[0][i] + w1 * n[1][i];
        }
        general_5r1p_add_candidate(out, c, s, sum);
    }
}

/* Two vectors, orthogonal, at which a factor is smallest. Returns 1 where it is regular, with no
 * singular value that is next to nothing and not two small ones, else 0. */
static inline general_5r1p_lane general_5r1p_smallest(general_5r1p_lane factor[6][6],
    general_5r1p_lane x[2][6])
{
    static const double start[2][6] = {
        { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 },
        { -0.31, 0.47, 0.59, 0.67, -0.23, 0.41 },
    };
    general_5r1p_lane inverse[6], length, second, squares = {0};
    general_5r1p_reciprocals(factor, inverse);
    for (int i = 0; i < 6; i++) {
        x[0][i] = general_5r1p_all(start[0][i]);
        x[1][i] = general_5r1p_all(start[1][i]);
        for (int j = i; j < 6; j++) {
            squares += factor[i][j] * factor[i][j];
        }
    }
    for (int step = 0; step < 4; step++) {
        general_5r1p_lane along = {0};
        length = general_5r1p_inverse_iteration(factor, inverse, x[0]);
        second = general_5r1p_inverse_iteration(factor, inverse, x[1]);
        for (int i = 0; i < 6; i++) {
            along += x[0][i] * x[1][i];
        }
        for (int i = 0; i < 6; i++) {
            x[1][i] -= along * x[0][i];
        }
    }
    return general_5r1p_select((length * squares < 25000000000000.004) & (second * squares <
        1000000000000.0),
                          general_5r1p_all(1.0), general_5r1p_all(0.0));
}

/* Candidates where two roots may have met: the null space may be a plane, which is split where one
 * of the two shifts, x3 or x2, has an eigenvalue. */
static void general_5r1p_null_plane(const double *E, double c, double s, general_5r1p_candidates
    *out)
{
    static const int up_3[3] = {0, 1, 2}, down_3[3] = {3, 4, 5};
    static const int up_2[4] = {0, 1, 3, 4}, down_2[4] = {1, 2, 4, 5};
    general_5r1p_lane factor[6][6], x[2][6];
    double n[2][6];
    if (out->groups == GENERAL_5R1P_CANDIDATES) {
        return;
    }
    (void)general_5r1p_fold(E, general_5r1p_all(c), general_5r1p_all(s), factor);
    out->regular[out->groups] =
        general_5r1p_largest(general_5r1p_smallest(factor, x)) > 0.0 &&
        general_5r1p_largest(general_5r1p_independence(E, general_5r1p_all(c), general_5r1p_all(s)))
            > 8.999999999999999e-08;
    for (int r = 0; r < 2; r++) {
        double square = 0.0;
        for (int i = 0; i < 6; i++) {
            n[r][i] = general_5r1p_largest(x[r][i]);
            square += n[r][i] * n[r][i];
        }
        square = sqrt(square) + 1e-300;
        for (int i = 0; i < 6; i++) {
            n[r][i] /= square;
        }
    }
    general_5r1p_add_candidate(out, c, s, n[0]);
    general_5r1p_split(n, 3, up_3, down_3, c, s, out);
    general_5r1p_split(n, 4, up_2, down_2, c, s, out);
    out->groups++;
}

/* The terms a c + b s + w of five invariants of B = Rz K Rz(phi5) M Rz: l_z, p_z, p.l, p.p / 2 and
 * (p x l)_z; and the 2x5 matrix that solves them for c and s by least squares. */
static void general_5r1p_invariants(const double K[12], const double M[12], double w[5],
                               double solve[2][5])
{
    const double t[3] = {K[3], K[7], K[11]};
    const double e[3] = {M[2], M[6], M[10]}, u[3] = {M[3], M[7], M[11]};
    const double v[3] = {u[1] * e[2] - u[2] * e[1], u[2] * e[0] - u[0] * e[2],
                         u[0] * e[1] - u[1] * e[0]};
    double foot[3], side[3], a[5], b[5], aa = 0.0, ab = 0.0, bb = 0.0, det;
    const double *const axis = K + 8;
    for (int j = 0; j < 3; j++) {
        foot[j] = K[j] * t[0] + K[4 + j] * t[1] + K[8 + j] * t[2];
        side[j] = K[4 + j] * t[0] - K[j] * t[1]; /* K' (z x t) */
    }
    const double *const left[5] = {axis, axis, foot, foot, axis};
    const double *const right[5] = {e, u, e, u, v};
    for (int i = 0; i < 5; i++) {
        a[i] = left[i][0] * right[i][0] + left[i][1] * right[i][1];
        b[i] = left[i][1] * right[i][0] - left[i][0] * right[i][1];
        w[i] = left[i][2] * right[i][2];
    }
    a[4] += side[0] * e[0] + side[1] * e[1];
    b[4] += side[1] * e[0] - side[0] * e[1];
    w[4] += side[2] * e[2];
    w[1] += t[2];
    w[2] += u[0] * e[0] + u[1] * e[1] + u[2] * e[2];
    w[3] += 0.5 * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + u[0] * u[0] + u[1] * u[1] + u[2] *
        u[2]);
    for (int i = 0; i < 5; i++) {
        aa += a[i] * a[i];
        ab += a[i] * b[i];
        bb += b[i] * b[i];
    }
    det = aa * bb - ab * ab + 1e-300;
    for (int i = 0; i < 5; i++) {
        solve[0][i] = (bb * a[i] - ab * b[i]) / det;
        solve[1][i] = (aa * b[i] - ab * a[i]) / det;
    }
}

/* phi_2 and phi_3 from the null vector */
static inline void general_5r1p_partners(const int joint[6], const general_5r1p_lane n[6],
    general_5r1p_lane c[6],
                                    general_5r1p_lane s[6])
{
    const general_5r1p_lane up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const general_5r1p_lane down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5];
    general_5r1p_lane row[3], sign, top, bottom;
    for (int i = 0; i < 3; i++) {
        row[i] = general_5r1p_select(up > down, n[i], n[3 + i]);
    }
    sign = general_5r1p_with_sign(general_5r1p_all(1.0), row[0] + row[2]);
    c[1] = sign * (row[2] - row[0]);
    s[1] = sign * 2.0 * row[1];
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2];
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2];
    c[2] = bottom * bottom - top * top;
    s[2] = 2.0 * top * bottom;
    general_5r1p_to_unit(&c[1], &s[1]);
    general_5r1p_to_unit(&c[2], &s[2]);
    if (general_5r1p_slides(joint[1])) { /* x^2 over x and x over 1, by least squares */
        s[1] = row[1] * (row[0] + row[2]) / (row[1] * row[1] + row[2] * row[2] + 1e-300);
    }
    if (general_5r1p_slides(joint[2])) {
        s[2] = top * bottom / (bottom * bottom + 1e-300);
    }
}

/* phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve` are those of the invariants. */
static inline void general_5r1p_others(const int joint[6], double link[6][12], const double w[5],
                                  double solve[2][5], general_5r1p_lane c[6], general_5r1p_lane
                                      s[6])
{
    general_5r1p_rigid G, C;
    general_5r1p_lane l[3], q[3], value[5], x, y;
    general_5r1p_begin(G, link[5]);
    for (int i = 0; i < 3; i++) {
        general_5r1p_move(G, joint[i], c[i], s[i]);
        general_5r1p_follow(G, link[i]);
    }
    /* B is the inverse of G; l and q are its third and fourth column */
    for (int j = 0; j < 3; j++) {
        l[j] = G[2][j];
        q[j] = -(G[0][j] * G[0][3] + G[1][j] * G[1][3] + G[2][j] * G[2][3]);
    }
    value[0] = l[2];
    value[1] = q[2];
    value[2] = -G[2][3]; /* q.l */
    value[3] = 0.5 * (G[0][3] * G[0][3] + G[1][3] * G[1][3] + G[2][3] * G[2][3]);
    value[4] = q[0] * l[1] - q[1] * l[0];
    c[4] = s[4] = general_5r1p_all(0.0);
    for (int i = 0; i < 5; i++) {
        c[4] += solve[0][i] * (value[i] - w[i]);
        s[4] += solve[1][i] * (value[i] - w[i]);
    }
    general_5r1p_to_unit(&c[4], &s[4]);
    general_5r1p_begin(C, link[3]);
    general_5r1p_turn(C, c[4], s[4]);
    general_5r1p_follow(C, link[4]);
    c[3] = C[0][2] * l[0] + C[1][2] * l[1] + C[0][3] * q[0] + C[1][3] * q[1];
    s[3] = C[0][2] * l[1] - C[1][2] * l[0] + C[0][3] * q[1] - C[1][3] * q[0];
    general_5r1p_to_unit(&c[3], &s[3]);
    c[5] = s[5] = general_5r1p_all(0.0);
    for (int i = 0; i < 2; i++) {
        /* columns of Rz(phi_4) C against columns of B */
        for (int j = 0; j < 2; j++) {
            x = c[3] * C[0][j] - s[3] * C[1][j];
            y = s[3] * C[0][j] + c[3] * C[1][j];
            value[0] = x * G[i][0] + y * G[i][1] + C[2][j] * G[i][2];
            if (i == j) {
                c[5] += value[0];
            } else {
                s[5] += i ? -value[0] : value[0];
            }
        }
    }
    general_5r1p_to_unit(&c[5], &s[5]);
}

/* The loop's error at cosines and sines of the joints: translation and rotation vector that are
 * missing. J, when given, takes the rows of the Jacobian with the error as seventh column. Returns
 * the square of the error. */
static inline general_5r1p_lane general_5r1p_error(const general_5r1p_loop *loop, const
    general_5r1p_lane c[6],
                                         const general_5r1p_lane s[6], general_5r1p_lane J[6][7])
{
    static const double identity[12] = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    const double *const P = loop->link[5];
    general_5r1p_rigid T;
    general_5r1p_lane z[6][3], o[6][3], S[3][3], square = {0}, trace;
    general_5r1p_begin(T, identity);
    GENERAL_5R1P_UNROLL
    for (int k = 0; k < 6; k++) {
        if (k) {
            general_5r1p_follow(T, loop->link[k - 1]);
        }
        GENERAL_5R1P_UNROLL
        for (int i = 0; i < 3; i++) {
            z[k][i] = T[i][2];
            o[k][i] = T[i][3];
        }
        general_5r1p_move(T, k, c[k], s[k]);
    }
    GENERAL_5R1P_UNROLL
    for (int i = 0; i < 3; i++) {
        GENERAL_5R1P_UNROLL
        for (int j = 0; j < 3; j++) {
            S[i][j] = P[4 * i] * T[j][0] + P[4 * i + 1] * T[j][1] + P[4 * i + 2] * T[j][2];
        }
        J[i][6] = P[4 * i + 3] - T[i][3];
    }
    J[3][6] = 0.5 * (S[2][1] - S[1][2]);
    J[4][6] = 0.5 * (S[0][2] - S[2][0]);
    J[5][6] = 0.5 * (S[1][0] - S[0][1]);
    GENERAL_5R1P_UNROLL
    for (int i = 0; i < 6; i++) {
        square += J[i][6] * J[i][6];
    }
    GENERAL_5R1P_UNROLL
    for (int k = 0; k < 6; k++) {
        GENERAL_5R1P_UNROLL
        for (int i = 0; i < 3; i++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            J[i][k] = z[k][i1] * (T[i2][3] - o[k][i2]) - z[k][i2] * (T[i1][3] - o[k][i1]);
            J[3 + i][k] = z[k][i];
        }
    }
    GENERAL_5R1P_UNROLL
    for (int i = 0; i < 3; i++) {
        J[i][2] = z[2][i];
        J[3 + i][2] = general_5r1p_all(0.0);
    }
    /* half a turn away the skew part vanishes too: the trace tells */
    trace = S[0][0] + S[1][1] + S[2][2];
    return general_5r1p_select(trace < 0.0, square + 1.0, square);
}

/* A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
 * next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
 * largest. */
static inline general_5r1p_lane general_5r1p_step(general_5r1p_lane J[6][7], general_5r1p_lane x[6])
{
    general_5r1p_lane *const row[6] = {J[0], J[1], J[2], J[3], J[4], J[5]};
    general_5r1p_lane most, least;
    const general_5r1p_lane zero = {0};
    general_5r1p_reflect(row, 6, 0, 7);
    general_5r1p_reflect(row + 1, 5, 1, 7);
    general_5r1p_reflect(row + 2, 4, 2, 7);
    general_5r1p_reflect(row + 3, 3, 3, 7);
    general_5r1p_reflect(row + 4, 2, 4, 7);
    most = least = general_5r1p_abs(J[0][0]);
    for (int i = 1; i < 6; i++) {
        most = general_5r1p_max(most, general_5r1p_abs(J[i][i]));
        least = general_5r1p_min(least, general_5r1p_abs(J[i][i]));
    }
    least /= most;
    most *= 1e-09;
    for (int i = 5; i >= 0; i--) {
        general_5r1p_lane sum = J[i][6];
        for (int j = i + 1; j < 6; j++) {
            sum -= J[i][j] * x[j];
        }
        sum /= J[i][i];
        sum = general_5r1p_max(general_5r1p_min(sum, zero + 1.0), zero - 1.0);
        x[i] = general_5r1p_select(general_5r1p_abs(J[i][i]) > most, sum, zero);
    }
    return least;
}

/* The same damped, for starts far away and for singular solutions: (J' J + d) x = J' error. */
static inline void general_5r1p_damped_step(general_5r1p_lane J[6][7], general_5r1p_lane damping,
    general_5r1p_lane x[6])
{
    general_5r1p_lane A[6][7];
    for (int i = 0; i < 6; i++) {
        for (int j = i; j < 7; j++) {
            A[i][j] = J[0][i] * J[0][j];
            for (int k = 1; k < 6; k++) {
                A[i][j] += J[k][i] * J[k][j];
            }
        }
        A[i][i] += damping;
    }
    for (int i = 0; i < 6; i++) {
        const general_5r1p_lane pivot = 1.0 / (A[i][i] + 1e-30);
        for (int j = i + 1; j < 6; j++) {
            const general_5r1p_lane factor = A[i][j] * pivot;
            for (int k = j; k < 7; k++) {
                A[j][k] -= factor * A[i][k];
            }
        }
    }
    for (int i = 5; i >= 0; i--) {
        x[i] = A[i][6];
        for (int j = i + 1; j < 6; j++) {
            x[i] -= A[i][j] * x[j];
        }
        x[i] /= A[i][i] + 1e-30;
        x[i] = general_5r1p_max(general_5r1p_min(x[i], general_5r1p_all(1.0)),
            general_5r1p_all(-1.0));
    }
}

/* Newton on the loop; what remains in c and s is the best iterate, and its error is returned. */
static inline general_5r1p_lane general_5r1p_polish(const general_5r1p_loop *loop, general_5r1p_lane
    c[6], general_5r1p_lane s[6],
                                          int steps, int afar)
{
    general_5r1p_lane J[6][7], x[6], tc[6], ts[6], least, now;
    for (int i = 0; i < 6; i++) {
        tc[i] = c[i];
        ts[i] = s[i];
    }
    least = now = general_5r1p_error(loop, c, s, J);
    for (int step = 0; step < steps; step++) {
        general_5r1p_mask better;
        if (general_5r1p_largest(least) < 1e-29) {
            break;
        }
        if (afar) {
            general_5r1p_damped_step(J, general_5r1p_min(now * 0.01, general_5r1p_all(0.01)), x);
        } else {
            (void)general_5r1p_step(J, x);
        }
        const general_5r1p_lane length_2 = ts[2];
        for (int i = 0; i < 6; i++) {
            /* a turn by 2 atan(x/2), without trigonometry */
            const general_5r1p_lane u = 0.25 * x[i] * x[i], f = 1.0 / (1.0 + u);
            const general_5r1p_lane dc = (1.0 - u) * f, ds = x[i] * f, old = tc[i];
            tc[i] = old * dc - ts[i] * ds;
            ts[i] = ts[i] * dc + old * ds;
        }
        ts[2] = length_2 + x[2];
        now = general_5r1p_error(loop, tc, ts, J);
        better = now < least;
        for (int i = 0; i < 6; i++) {
            c[i] = general_5r1p_select(better, tc[i], c[i]);
            s[i] = general_5r1p_select(better, ts[i], s[i]);
        }
        least = general_5r1p_select(better, now, least);
    }
    return general_5r1p_sqrt(least);
}

/* A bit for each solution. */
typedef unsigned long long general_5r1p_set;

/* The solutions found so far. Where one is singular many candidates come near to it: there is room
 * for more than there are solutions, the last of it for regular ones. */
typedef struct {
    int count;
    general_5r1p_set singular, nearly_singular; /* where the arm is */
    int doubles; /* roots that met, or may have */
    double q[64][6], residual[64];
} general_5r1p_found;

/* Whether two joint vectors differ by less than that, modulo turns. */
static int general_5r1p_alike(const double a[6], const double b[6], double most)
{
    for (int j = 0; j < 6; j++) {
        const double gap = fabs(a[j] - b[j]);
        if (general_5r1p_slides(j) ? gap < most : gap < most || 6.283185307179586 - gap < most) {
            continue;
        }
        return 0;
    }
    return 1;
}

/* Add a solution unless it is known or none, and mark it where the arm is singular, or nearly; its
 * place, or -1. */
static int general_5r1p_keep(general_5r1p_found *found, double theta[6], double residual, double
    pivot)
{
    const int singular = pivot < 1e-06, nearly = pivot < 0.0001;
    const int room = nearly ? 64 - 16 : 64;
    if (!(residual <= 1e-10)) {
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (general_5r1p_alike(found->q[i], theta, 1e-06)) {
            if (residual < found->residual[i]) {
                found->residual[i] = residual;
                for (int j = 0; j < 6; j++) {
                    found->q[i][j] = theta[j];
                }
            }
            found->singular |= (general_5r1p_set)singular << i;
            found->nearly_singular |= (general_5r1p_set)nearly << i;
            return i;
        }
    }
    if (found->count >= room) {
        return -1;
    }
    found->singular |= (general_5r1p_set)singular << found->count;
    found->nearly_singular |= (general_5r1p_set)nearly << found->count;
    found->residual[found->count] = residual;
    for (int j = 0; j < 6; j++) {
        found->q[found->count][j] = theta[j];
    }
    return found->count++;
}

/* Polish candidates, given by cosines and sines, and keep what they lead to: the solutions that
 * were met. `place` takes which solution each candidate became, or -1. With `doubtful` candidates
 * singular solutions are marked. */
static general_5r1p_set general_5r1p_offer(const general_5r1p_loop *loop, general_5r1p_lane c[6],
    general_5r1p_lane s[6], int count,
                              int steps, int doubtful, general_5r1p_found *found,
                              int place[GENERAL_5R1P_LANES])
{
    double residual[GENERAL_5R1P_LANES], theta[6][GENERAL_5R1P_LANES], pivot[GENERAL_5R1P_LANES];
    double length_2[GENERAL_5R1P_LANES];
    general_5r1p_set met = 0;
    GENERAL_5R1P_STORE(residual, general_5r1p_polish(loop, c, s, steps, steps > 4));
    if (doubtful) {
        general_5r1p_lane J[6][7], x[6];
        (void)general_5r1p_error(loop, c, s, J);
        GENERAL_5R1P_STORE(pivot, general_5r1p_step(J, x));
    } else {
        GENERAL_5R1P_STORE(pivot, general_5r1p_all(1.0));
    }
    for (int i = 0; i < 6; i++) {
        const double cosine = general_5r1p_advance[0][i], sine = general_5r1p_advance[1][i];
        GENERAL_5R1P_STORE(theta[i],
                      general_5r1p_angle(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] * sine));
    }
    GENERAL_5R1P_STORE(length_2, s[2]);
    for (int k = 0; k < count; k++) {
        double row[6];
        for (int i = 0; i < 6; i++) {
            /* half a turn is +pi, also when rounding says otherwise */
            row[i] = theta[i][k] < -3.141592653589783 ? 3.141592653589793 : theta[i][k];
        }
        row[2] = length_2[k];
        place[k] = general_5r1p_keep(found, row, residual[k], pivot[k]);
        if (place[k] >= 0) {
            met |= (general_5r1p_set)1 << place[k];
        }
    }
    return met;
}

static int general_5r1p_bits(general_5r1p_set set)
{
    int count = 0;
    for (; set; set &= set - 1) {
        count++;
    }
    return count;
}

/* Whether the number of regular solutions is even. */
static int general_5r1p_paired(const general_5r1p_found *found)
{
    return (found->count - general_5r1p_bits(found->singular)) % 2 == 0;
}

/* The links L0 ... L5 of a formulation. */
static void general_5r1p_around(const general_5r1p_formulation *form, const general_5r1p_loop *loop,
                           double link[6][12])
{
    for (int i = 0; i < 6; i++) {
        const int joint = form->joint[i];
        if (form->sign > 0.0 && joint < 5) {
            general_5r1p_copy(loop->link[joint], link[i]);
        } else if (form->sign > 0.0) {
            general_5r1p_invert(loop->link[5], link[i]);
        } else if (joint > 0) {
            general_5r1p_invert(loop->link[joint - 1], link[i]);
        } else {
            general_5r1p_copy(loop->link[5], link[i]);
        }
    }
}

/* Roots that nearly meet are tried as one double root too. */
static void general_5r1p_close_roots(const double *E, const general_5r1p_roots *roots,
    general_5r1p_candidates *out)
{
    for (int i = 0; i < roots->simple; i++) {
        for (int j = 0; j < i; j++) {
            const double c = roots->c[i] + roots->c[j], s = roots->s[i] + roots->s[j];
            const double square = c * c + s * s;
            if (square > 3.999999) {
                const double factor = 1.0 / sqrt(square);
                general_5r1p_null_plane(E, c * factor, s * factor, out);
            }
        }
    }
}

/* Polish all candidates of a formulation. The certificate: every simple root leads to a solution,
 * there is another one for each of them and two more for each double root, or a singular one; and
 * regular solutions come in pairs. Where the determinant only comes near to zero there is no root;
 * where it nearly vanishes all around, rounding of the equations may lift it off a double root,
 * which nothing but they tell. What an attempt before took for double roots is none then; whether
 * the arm is singular there is looked at. */
static int general_5r1p_settle(const general_5r1p_formulation *form, const general_5r1p_loop *loop,
                          double link[6][12], const general_5r1p_candidates *all,
                          const general_5r1p_roots *roots, general_5r1p_found *found)
{
    double w[5], solve[2][5];
    general_5r1p_set met = 0, of_group[GENERAL_5R1P_CANDIDATES] = {0};
    const int simple = roots->simple, touching = roots->doubles + roots->unseen;
    const int doubted = found->doubles > 0;
    int complete = roots->complete, expected = simple, true_doubles = 0;
    general_5r1p_invariants(link[3], link[4], w, solve);
    for (int from = 0; from < all->count; from += GENERAL_5R1P_LANES) {
        const int count = all->count - from < GENERAL_5R1P_LANES ? all->count - from :
            GENERAL_5R1P_LANES;
        general_5r1p_lane n[6], c[6], s[6], tc[6], ts[6];
        int place[GENERAL_5R1P_LANES];
        c[0] = GENERAL_5R1P_LOAD(all->c + from);
        s[0] = GENERAL_5R1P_LOAD(all->s + from);
        for (int i = 0; i < 6; i++) {
            n[i] = GENERAL_5R1P_LOAD(all->n[i] + from);
        }
        general_5r1p_partners(form->joint, n, c, s);
        general_5r1p_others(form->joint, link, w, solve, c, s);
        for (int i = 0; i < 6; i++) {
            tc[form->joint[i]] = c[i];
            ts[form->joint[i]] = form->sign * s[i];
        }
        met |= general_5r1p_offer(loop, tc, ts, count, 4, doubted || from + count > simple, found,
            place);
        for (int k = 0; k < count; k++) {
            if (from + k < simple) {
                complete &= place[k] >= 0;
            } else if (place[k] >= 0) {
                of_group[all->group[from + k]] |= (general_5r1p_set)1 << place[k];
            }
        }
    }
    for (int i = all->groups - touching; i < all->groups; i++) {
        if (of_group[i] || !all->regular[i]) {
            true_doubles++;
            expected += of_group[i] & found->singular ? 1 : 2;
        }
    }
    complete = complete && general_5r1p_bits(met) >= expected && general_5r1p_paired(found);
    found->doubles = complete ? true_doubles : found->doubles + roots->doubles;
    return complete;
}

/* Keeps of angles those where the determinant may vanish: where f only comes near to zero it does
 * not. */
static int general_5r1p_keep_vanishing(const void *equations, int count, double *cosine, double
    *sine)
{
    int kept = 0;
    for (int from = 0; from < count; from += GENERAL_5R1P_LANES) {
        general_5r1p_lane factor[6][6], x[2][6];
        double c[GENERAL_5R1P_LANES], s[GENERAL_5R1P_LANES], regular[GENERAL_5R1P_LANES],
            apart[GENERAL_5R1P_LANES];
        for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
            const int i = from + k < count ? from + k : from;
            c[k] = cosine[i];
            s[k] = sine[i];
        }
        (void)general_5r1p_fold(equations, GENERAL_5R1P_LOAD(c), GENERAL_5R1P_LOAD(s), factor);
        GENERAL_5R1P_STORE(regular, general_5r1p_smallest(factor, x));
        GENERAL_5R1P_STORE(apart, general_5r1p_independence(equations, GENERAL_5R1P_LOAD(c),
            GENERAL_5R1P_LOAD(s)));
        for (int k = 0; k < GENERAL_5R1P_LANES && from + k < count; k++) {
            if (regular[k] < 1.0 || !(apart[k] > 8.999999999999999e-08)) {
                cosine[kept] = c[k];
                sine[kept++] = s[k];
            }
        }
    }
    return kept;
}

/* The determinant at the sample angles, through a lens. */
static void general_5r1p_sample(const void *equations, const general_5r1p_lens *lens, double
    samples[24])
{
    for (int k = 0; k < 24; k += GENERAL_5R1P_LANES) {
        general_5r1p_lane factor[6][6];
        general_5r1p_lane c = GENERAL_5R1P_LOAD(general_5r1p_sample_c + k), s =
            GENERAL_5R1P_LOAD(general_5r1p_sample_s + k);
        const general_5r1p_lane square = general_5r1p_through(lens, &c, &s);
        const general_5r1p_lane determinant = general_5r1p_fold(equations, c, s, factor);
        GENERAL_5R1P_STORE(samples + k, general_5r1p_weighted(determinant, square));
    }
}

/* Find what a formulation finds; whether that is certainly everything. */
static int general_5r1p_attempt(const general_5r1p_formulation *form, const general_5r1p_loop *loop,
                           general_5r1p_found *found)
{
    double link[6][12], E[192];
    const general_5r1p_source source = { general_5r1p_sample, general_5r1p_keep_vanishing, E};
    general_5r1p_roots roots, beside;
    general_5r1p_candidates all;
    general_5r1p_around(form, loop, link);
    general_5r1p_equations(form, link, form->left, E);
    if (!general_5r1p_real_roots(&source, &roots)) {
        return 0;
    }
    beside.simple = all.count = all.groups = 0;
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        general_5r1p_separate(E, roots.double_c[i], roots.double_s[i], &beside);
    }
    general_5r1p_null_vectors(E, &roots, &all);
    general_5r1p_null_vectors(E, &beside, &all);
    general_5r1p_close_roots(E, &roots, &all);
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        general_5r1p_null_plane(E, roots.double_c[i], roots.double_s[i], &all);
    }
    /* lanes behind the last candidate hold the first one */
    for (int k = all.count; k % GENERAL_5R1P_LANES; k++) {
        all.c[k] = all.c[0];
        all.s[k] = all.s[0];
        for (int i = 0; i < 6; i++) {
            all.n[i][k] = all.n[i][0];
        }
    }
    return general_5r1p_settle(form, loop, link, &all, &roots, found);
}

/* Find what the methods find, one after the other, until that is certainly everything. */
static int general_5r1p_try(const general_5r1p_loop *loop, general_5r1p_found *found)
{
    int complete = 0;
    for (int i = 0; i < 2 && !complete; i++) {
        complete = general_5r1p_attempt(&general_5r1p_formulations[i], loop, found);
    }
    return complete;
}

/* Newton from joint angles (count, 6) far from or near to solutions. */
static general_5r1p_set general_5r1p_follow_back(const general_5r1p_loop *loop, double (*start)[6],
    int count,
                                    general_5r1p_found *found, int *lost)
{
    general_5r1p_set met = 0;
    for (int from = 0; from < count; from += GENERAL_5R1P_LANES) {
        const int now = count - from < GENERAL_5R1P_LANES ? count - from : GENERAL_5R1P_LANES;
        double cs[2][6][GENERAL_5R1P_LANES];
        general_5r1p_lane c[6], s[6];
        int place[GENERAL_5R1P_LANES];
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < GENERAL_5R1P_LANES; k++) {
                const double angle = start[from + (k < now ? k : 0)][i];
                const double cosine = cos(angle), sine = general_5r1p_slides(i) ? angle :
                    sin(angle);
                cs[0][i][k] = cosine * general_5r1p_advance[0][i] + sine *
                    general_5r1p_advance[1][i];
                cs[1][i][k] = sine * general_5r1p_advance[0][i] - cosine *
                    general_5r1p_advance[1][i];
            }
            c[i] = GENERAL_5R1P_LOAD(cs[0][i]);
            s[i] = GENERAL_5R1P_LOAD(cs[1][i]);
        }
        met |= general_5r1p_offer(loop, c, s, now, 40, 1, found, place);
        for (int k = 0; k < now; k++) {
            *lost += place[k] < 0;
        }
    }
    return met;
}

/* Solve poses close by, and follow their solutions back. Where two solutions meet they are on one
 * side only: both sides have to have as many as are found. Around a singular pose none of them has
 * to have all solutions: then all are looked at. */
static int general_5r1p_from_nearby(const general_5r1p_loop *loop, general_5r1p_found *found)
{
    int followed = 0, before = -1;
    for (int n = 0; n < 10; n++) {
        general_5r1p_loop nearby = *loop;
        general_5r1p_found other;
        int complete, count = -1, lost = 0;
        general_5r1p_set met;
        general_5r1p_then(nearby.link[5], general_5r1p_nudge[n]);
        other.count = 0;
        other.singular = other.nearly_singular = 0;
        other.doubles = 0;
        complete = general_5r1p_try(&nearby, &other);
        met = general_5r1p_follow_back(loop, other.q, other.count, found, &lost);
        if (complete && !lost && met) {
            count = general_5r1p_bits(met) == other.count ? other.count : -1;
            followed |= (met & found->singular) != 0;
        }
        if (n % 2 && before == found->count && count == found->count && !found->singular &&
            general_5r1p_paired(found)) {
            return 1;
        }
        before = count;
    }
    return followed && general_5r1p_paired(found);
}

/* Newton from many starts, the same on every run. */
static void general_5r1p_from_anywhere(const general_5r1p_loop *loop, general_5r1p_found *found)
{
    unsigned long long seed = 1;
    for (int batch = 0; batch < 16; batch++) {
        double start[8][6];
        int lost = 0;
        for (int i = 0; i < 48; i++) {
            seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
            start[i / 6][i % 6] = ((double)(seed >> 33) / 4294967296.0 - 0.25) * 4.0 *
                3.141592653589793;
        }
        (void)general_5r1p_follow_back(loop, start, 8, found, &lost);
    }
}

/* What comes first where there are more than there are rows: 0 for regular solutions, 1 for
 * singular ones or nearly so, 2 for those that lie together with one of these and may be the same,
 * which only its last digits tell. */
static void general_5r1p_rank(const general_5r1p_found *found, int rank[64])
{
    for (int i = 0; i < found->count; i++) {
        rank[i] = (int)(found->nearly_singular >> i & 1);
        for (int j = 0; j < i && rank[i] == 1; j++) {
            if (rank[j] == 1 && general_5r1p_alike(found->q[i], found->q[j], 0.001)) {
                rank[i] = 2;
            }
        }
    }
}

/* Whether solution i comes before solution j: by rank, then by the first angle, angles that agree
 * to rounding by the next. */
static int general_5r1p_before(const general_5r1p_found *found, const int *rank, int i, int j)
{
    const double *const a = found->q[i], *const b = found->q[j];
    if (rank[i] != rank[j]) {
        return rank[i] < rank[j];
    }
    for (int k = 0; k < 6; k++) {
        if (fabs(a[k] - b[k]) > 1e-09) {
            return a[k] < b[k];
        }
    }
    return 0;
}

/* All solutions of a rigid T = C0 J(q1) C1 ... J(q6) C6, at most 16.
 *
 * T: row by row. q: the angles, in (-pi, pi], or length, rows in the order of q1, rows whose q1
 * agree to 1e-09 in the order of q2, and so on, singular ones and nearly singular ones last.
 * residual: by how much the loop stays open, in radians and arm sizes. Returns how many; -1 - count
 * when it is not certain that these are all: for want of a certificate of its own (where every
 * polynomial vanishes identically there may be a continuum, which poses close by do not have), or
 * because roots met or the arm is singular at a solution, or nearly, so that steps did not make it
 * exact. */
static int general_5r1p_general(const double T[16], double q[16][6],
                         double residual[16])
{
    general_5r1p_found found;
    general_5r1p_loop whole;
    const general_5r1p_loop *const loop = &whole;
    int rank[64], order[64], certified, inexact = 0;
    general_5r1p_close(T, &whole);
    found.count = 0;
    found.singular = found.nearly_singular = 0;
    found.doubles = 0;
    certified = general_5r1p_try(loop, &found);
    if (!certified && !general_5r1p_from_nearby(loop, &found)) {
        general_5r1p_from_anywhere(loop, &found);
    }
    general_5r1p_rank(&found, rank);
    for (int i = 0; i < found.count; i++) {
        int j = i;
        for (; j > 0 && general_5r1p_before(&found, rank, i, order[j - 1]); j--) {
            order[j] = order[j - 1];
        }
        order[j] = i;
    }
    if (found.count > 16) {
        certified = 0;
        found.count = 16;
    }
    for (int i = 0; i < found.count; i++) {
        for (int j = 0; j < 6; j++) {
            q[i][j] = found.q[order[i]][j];
        }
        q[i][2] *= 0.6327271772032304;
        residual[i] = found.residual[order[i]];
        inexact |= residual[i] > 1e-12;
    }
    return certified && !found.singular && !found.doubles && !inexact ? found.count : -1 -
        found.count;
}

/* A solution that is exact and unlike all others needs no descent. */
static void add_regular(struct kept *kept, double u[6])
{
    wrap_angles(u);
    kept->singular[kept->count] = kept->chosen[kept->count] = 0;
    copy(u, kept->u[kept->count++]);
}

/* All solutions. Where it is not certain that these are all, the seed and evenly spread starts are
 * followed too; singular solutions out of a continuum go to the seed. */
static void all_joints(
    const double T[16], const double seed[6], double q[16][6],
    int found[16], int chosen[16])
{
    static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
    static const double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    struct descent d = { .T = T };
    struct kept kept = { .count = 0 };
    double angles[16][6], residual[16], u[6];
    const int count = general_5r1p_general(T, angles, residual);
    for (int j = 0; j < 6; j++)
        u[j] = d.seed[j] = seed[solved[j]] / unit[j];
    if (count < 0 && descend(&d, u) <= 1e-10)
        keep(&d, &kept, u);
    const int many = count < 0 ? -1 - count : count;
    for (int k = 0; k < many; k++) {
        for (int j = 0; j < 6; j++)
            u[j] = facing[j] * (angles[k][j] - zero[j]) / unit[j];
        if (count < 0) {
            (void)descend(&d, u); /* where solutions meet it is exact that tells them apart */
            keep(&d, &kept, u);
        } else {
            add_regular(&kept, u);
        }
    }
    for (int k = 1; count < 0 && k < 12; k++) {
        start_of(&d, k, u);
        if (descend(&d, u) <= 1e-10)
            keep(&d, &kept, u);
    }
    sorted_rows(&d, &kept, q, found, chosen);
}

static const double
    d1 = -0.293, /* joint offset 1 [m] */
    a1 = 0.278, /* link length 1 [m] */
    ca1 = 0.012203370292583539, /* cosine of twist 1 */
    sa1 = 0.9999255361043151, /* sine of twist 1 */
    d2 = -0.196, /* joint offset 2 [m] */
    a2 = -0.004, /* link length 2 [m] */
    ca2 = 0.9544456308244855, /* cosine of twist 2 */
    sa2 = 0.29838488198977153, /* sine of twist 2 */
    cat3 = 0.6145349462240683, /* cosine of the angle of joint 3 */
    sat3 = 0.7888895992909156, /* sine of the angle of joint 3 */
    a3 = 0.231, /* link length 3 [m] */
    ca3 = 0.7618754628213957, /* cosine of twist 3 */
    sa3 = 0.647723536048123, /* sine of twist 3 */
    d4 = -0.377, /* joint offset 4 [m] */
    a4 = 0.269, /* link length 4 [m] */
    ca4 = 0.9191023971657747, /* cosine of twist 4 */
    sa4 = 0.39401876037078043, /* sine of twist 4 */
    d5 = 0.211, /* joint offset 5 [m] */
    a5 = -0.398, /* link length 5 [m] */
    ca5 = 0.9463659134816423, /* cosine of twist 5 */
    sa5 = 0.323096824187513, /* sine of twist 5 */
    d6 = 0.037, /* joint offset 6 [m] */
    a6 = 0.357, /* link length 6 [m] */
    ca6 = 0.7427737668732654, /* cosine of twist 6 */
    sa6 = 0.6695424790443845, /* sine of twist 6 */
    f1 = -0.002391860577346374, /* ca1 * d2 [m] */
    f2 = 0.003641301204630023, /* ca1 * sa2 */
    f3 = 0.011647453457089682; /* ca1 * ca2 */

const char *const general_5r1p_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = { -INFINITY, -INFINITY, -0.8, -INFINITY, -INFINITY, -INFINITY };
static const double highest[6] = { INFINITY, INFINITY, 0.8, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 1, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 1.0, 0.14229201993625035, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 2.651e-09) /* of limits */

void general_5r1p_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), y1_x = s1 * ca1, v1 = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 + y1_x * s2,
        x2_y = s1 * c2 - v1 * s2, x2_z = sa1 * s2, v3 = y1_x * c2 - c1 * s2, v4 = v1 * c2 + s1 * s2,
        v5 = sa1 * c2, y2_x = v3 * ca2 - z1_x * sa2, y2_y = v2 * sa2 - v4 * ca2,
        y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2, v6 = v4 * sa2 + v2 * ca2,
        z2_z = v5 * sa2 - f3, x3_x = x2_x * cat3 + y2_x * sat3, x3_y = x2_y * cat3 + y2_y * sat3,
        x3_z = x2_z * cat3 + y2_z * sat3, v7 = y2_x * cat3 - x2_x * sat3,
        v8 = y2_y * cat3 - x2_y * sat3, v9 = y2_z * cat3 - x2_z * sat3, v10 = v7 * ca3 + z2_x * sa3,
        y3_y = v6 * sa3 - v8 * ca3, v11 = v9 * ca3 + z2_z * sa3, z3_x = v7 * sa3 - z2_x * ca3,
        z3_y = v8 * sa3 + v6 * ca3, z3_z = v9 * sa3 - z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v10 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 - v11 * s4, v12 = v10 * c4 + x3_x * s4,
        v13 = y3_y * c4 - x3_y * s4, v14 = v11 * c4 + x3_z * s4, v15 = v12 * ca4 + z3_x * sa4,
        y4_y = v13 * ca4 - z3_y * sa4, v16 = v14 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v12 * sa4,
        z4_y = v13 * sa4 + z3_y * ca4, z4_z = z3_z * ca4 - v14 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v15 * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v16 * s5, v17 = v15 * c5 + x4_x * s5,
        v18 = y4_y * c5 - x4_y * s5, v19 = v16 * c5 + x4_z * s5, v20 = v17 * ca5 + z4_x * sa5,
        y5_y = v18 * ca5 - z4_y * sa5, v21 = v19 * ca5 + z4_z * sa5, z5_x = z4_x * ca5 - v17 * sa5,
        z5_y = v18 * sa5 + z4_y * ca5, z5_z = z4_z * ca5 - v19 * sa5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 - v20 * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 - v21 * s6, v22 = v20 * c6 + x5_x * s6,
        v23 = y5_y * c6 - x5_y * s6, v24 = v21 * c6 + x5_z * s6;
    T[0] = x6_x; T[1] = v22 * ca6 + z5_x * sa6; T[2] = v22 * sa6 - z5_x * ca6;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + x5_x
        * a5 + z4_x * d5 + x6_x * a6 + z5_x * d6;
    T[4] = x6_y; T[5] = z5_y * sa6 - v23 * ca6; T[6] = -(v23 * sa6 + z5_y * ca6);
    T[7] = s1 * a1 + x2_y * a2 - v2 * d2 - v6 * q[2] + x3_y * a3 + x4_y * a4 + z3_y * d4 + x5_y * a5
        + z4_y * d5 + x6_y * a6 + z5_y * d6;
    T[8] = x6_z; T[9] = v24 * ca6 + z5_z * sa6; T[10] = v24 * sa6 - z5_z * ca6;
    T[11] = d1 + x2_z * a2 - f1 + z2_z * q[2] + x3_z * a3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z
        * d5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void general_5r1p_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, y1_x = s1 * ca1,
        v1 = c1 * ca1, z1_x = s1 * sa1, v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 + y1_x * s2,
        x2_y = s1 * c2 - v1 * s2, x2_z = sa1 * s2, v3 = y1_x * c2 - c1 * s2, v4 = v1 * c2 + s1 * s2,
        v5 = sa1 * c2, y2_x = v3 * ca2 - z1_x * sa2, y2_y = v2 * sa2 - v4 * ca2,
        y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2, v6 = v4 * sa2 + v2 * ca2,
        z2_z = v5 * sa2 - f3, x3_x = x2_x * cat3 + y2_x * sat3, x3_y = x2_y * cat3 + y2_y * sat3,
        x3_z = x2_z * cat3 + y2_z * sat3, v7 = y2_x * cat3 - x2_x * sat3,
        v8 = y2_y * cat3 - x2_y * sat3, v9 = y2_z * cat3 - x2_z * sat3,
        p3_x = p1_x + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3,
        p3_y = p1_y + x2_y * a2 - v2 * d2 - v6 * q[2] + x3_y * a3,
        p3_z = d1 + x2_z * a2 - f1 + z2_z * q[2] + x3_z * a3, v10 = v7 * ca3 + z2_x * sa3,
        y3_y = v6 * sa3 - v8 * ca3, v11 = v9 * ca3 + z2_z * sa3, z3_x = v7 * sa3 - z2_x * ca3,
        z3_y = v8 * sa3 + v6 * ca3, z3_z = v9 * sa3 - z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v10 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 - v11 * s4, v12 = v10 * c4 + x3_x * s4,
        v13 = y3_y * c4 - x3_y * s4, v14 = v11 * c4 + x3_z * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 + z3_y * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, v15 = v12 * ca4 + z3_x * sa4,
        y4_y = v13 * ca4 - z3_y * sa4, v16 = v14 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v12 * sa4,
        z4_y = v13 * sa4 + z3_y * ca4, z4_z = z3_z * ca4 - v14 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v15 * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v16 * s5, v17 = v15 * c5 + x4_x * s5,
        v18 = y4_y * c5 - x4_y * s5, v19 = v16 * c5 + x4_z * s5,
        p5_x = p4_x + x5_x * a5 + z4_x * d5, p5_y = p4_y + x5_y * a5 + z4_y * d5,
        p5_z = p4_z + x5_z * a5 + z4_z * d5, z5_x = z4_x * ca5 - v17 * sa5,
        z5_y = v18 * sa5 + z4_y * ca5, z5_z = z4_z * ca5 - v19 * sa5;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        p6_x = p5_x + (x5_x * c6 - (v17 * ca5 + z4_x * sa5) * s6) * a6 + z5_x * d6,
        p6_y = p5_y + (x5_y * c6 + (v18 * ca5 - z4_y * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 - (v19 * ca5 + z4_z * sa5) * s6) * a6 + z5_z * d6,
        v20 = p6_x - p1_x, v21 = p6_y - p1_y, v22 = p6_z - d1, v23 = p6_x - p3_x, v24 = p6_y - p3_y,
        v25 = p6_z - p3_z, v26 = p6_x - p4_x, v27 = p6_y - p4_y, v28 = p6_z - p4_z,
        v29 = p6_x - p5_x, v30 = p6_y - p5_y, v31 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = ca1 * v21 - v2 * v22; J[2] = z2_x; J[3] = z3_y * v25 - z3_z * v24;
    J[4] = z4_y * v28 - z4_z * v27; J[5] = z5_y * v31 - z5_z * v30;
    J[6] = p6_x; J[7] = -(ca1 * v20 + z1_x * v22); J[8] = -v6; J[9] = z3_z * v23 - z3_x * v25;
    J[10] = z4_z * v26 - z4_x * v28; J[11] = z5_z * v29 - z5_x * v31;
    J[12] = 0.0; J[13] = z1_x * v21 + v2 * v20; J[14] = z2_z; J[15] = z3_x * v24 - z3_y * v23;
    J[16] = z4_x * v27 - z4_y * v26; J[17] = z5_x * v30 - z5_y * v29;
    J[18] = 0.0; J[19] = z1_x; J[20] = 0.0; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -v2; J[26] = 0.0; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = -ca1; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(double T[16])
{
    double G[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[i][j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (T[i] * T[j] + T[4 + i] * T[4 + j] + T[8 + i] * T[8 + j]);
    for (double *row = T; row < T + 12; row += 4) {
        const double x = row[0], y = row[1], z = row[2];
        for (int j = 0; j < 3; j++)
            row[j] = x * G[0][j] + y * G[1][j] + z * G[2][j];
    }
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose, and 2 for what was rounded. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3] * T[3] * T[3]) && isfinite(T[7] * T[7] * T[7]) && isfinite(T[11] * T[11] *
        T[11])))
        return 0;
    if (!(fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= 1e-09))
        return 0;
    const double miss = misfit_one(T);
    if (!(miss <= 1e-09))
        return 0;
    if (miss <= 1e-24)
        return 1;
    straighten(T);
    straighten(T);
    return 2;
}

/* How far a joint value is beyond its limits, whole turns aside; negative below. */
static double overshoot(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (low <= value && value <= high)
        return 0.0;
    double off = value > high ? value - high : value - low;
    const double gap = turn - (high - low), over = value - high;
    const double rest = over - turn * floor(over / turn);
    if (revolute[joint])
        off = rest >= gap ? 0.0 : rest <= gap - rest ? rest : rest - gap;
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of a row. */
static double beyond_limits(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(overshoot(i, values[i])) * sqrt(weight[i]);
    return sum;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[6], double q[16][6], unsigned char status[16])
{

    /* all joints: the general 5R1P loop */
    double solution_roots[16][6];
    int solution_found[16], solution_chosen[16];
    all_joints(T, seed, solution_roots, solution_found, solution_chosen);

    for (int i1 = 0; i1 < 16; i1++) { /* root1 to root16 */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const double q5 = solution_roots[i1][4];
        const double q6 = solution_roots[i1][5];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: the general 5R1P loop */
        if (!found) continue; /* out of reach */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        q[row][5] = q6;
        status[row] = (chosen) ? FREE : OK;
    }
}

static void take(const double from[6], double to[6])
{
    for (int i = 0; i < 6; i++)
        to[i] = from[i];
}

/* A joint value moved by whole turns, near to another but inside its limits. */
static double turned(int joint, double given, double towards)
{
    const double low = lowest[joint] - 1e-09, high = highest[joint] + 1e-09;
    if (!revolute[joint])
        return given;
    double value = given;
    if (fabs(towards) < 100000.0)
        value += turn * floor((towards - given) / turn + 0.5);
    value -= turn * ceil(fmax(value - high, 0.0) / turn);
    value += turn * ceil(fmax(low - value, 0.0) / turn);
    return value <= high ? value : given;
}

/* How far joint values are from others, whole turns aside [rad, arm sizes]; half is the middle. */
static double half_way(const double x[6], const double q[6], double half[6])
{
    double most = 0.0;
    for (int i = 0; i < 6; i++) {
        double off = q[i] - x[i];
        off -= revolute[i] ? turn * floor(off / turn + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(weight[i]));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.3772, 0.3772, 0.3772, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 2.651, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    general_5r1p_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    for (int i = 0; i < 9; i++) {
        const int j = (i / 3 + 1) % 3 * 4 + i % 3, k = (i / 3 + 2) % 3 * 4 + i % 3;
        e[3 + i / 3] += 0.5 * (P[j] * T[k] - P[k] * T[j]);
        square += 0.5 * (P[j] - T[j]) * (P[j] - T[j]);
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[6], double damping, double e[6], double x[6])
{
    double A[6][12] = { { 0.0 } }, square[6] = { 0.0 }, J[36];
    general_5r1p_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[6 * i + j];
        A[i][6 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 12; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 12; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 12; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 6; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[6])
{
    double x[6], half[6], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[6] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 6 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? overshoot(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 6; i++)
                held[i] = i == worst || (held[i] && moves != 2);
            last = HUGE_VAL;
            x[worst] -= past;
            miss = off_pose(T, x, e);
        }
        if (miss < enough) {
            take(x, q);
            settled = 1;
            enough = 0.5 * miss;
        } else if (settled || (miss > fmax(0.7 * last, 100.0 * enough) && ++lost == 4)) {
            break;
        }
        last = miss;
        add_step(held, (lost == 0 && miss > 100.0 * enough ? 0.003 : 0.1 * miss) * miss, e, x);
        if (!(half_way(x, q, half) <= most))
            break; /* another solution */
    }
    return settled;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[16][6], const unsigned char status[16])
{
    double x[6], half[6], to[6], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 16; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

int general_5r1p_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16])
{
    const double zeros[6] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 6; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 16; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 16; row++) {
        if (status[row] == NONE)
            continue;
        (void)stand(pose, row, 0, q, status);
        for (int i = 0; i < 6; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int general_5r1p_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = general_5r1p_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 16 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
        }
        if (distance < least || result < 0) {
            least = distance;
            result = status[row];
            take(all[row], found);
        }
    }
    take(found, q);
    return valid ? result : -INVALID;
}

void general_5r1p_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)general_5r1p_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
