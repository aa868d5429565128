/* general_rpprrr: General arm with an oblique cross slide on its first axis
 *
 * Inverse kinematics, generated from robots/general_rpprrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_rpprrr.yaml. The formulas and where they come from:
 * general_rpprrr.md.
 */
#include "general_rpprrr.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = GENERAL_RPPRRR_OK, NONE = GENERAL_RPPRRR_UNREACHABLE, FREE = GENERAL_RPPRRR_FREE_JOINT,
    OUT = GENERAL_RPPRRR_OUT_OF_LIMITS, INVALID = GENERAL_RPPRRR_INVALID_POSE
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
static const int turning[6] = { 1, 0, 0, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.44, 1.44, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.6944444444444444, 1.0, 1.0, 0.6944444444444444, 0.6944444444444444, 0.6944444444444444,
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
    general_rpprrr_fk(d->q, P);
    general_rpprrr_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 1.44;
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
    -3.141592653589793, -0.5555555555555556, 0.0, -3.141592653589793, -3.141592653589793,
    -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 1.1111111111111112, 0.625, 6.283185307179586, 6.283185307179586,
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
    -INFINITY, -0.5555555555555556, 0.0, -INFINITY, -INFINITY, -INFINITY,
};
static const double most_u[6] = {
    INFINITY, 0.5555555555555556, 0.625, INFINITY, INFINITY, INFINITY,
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
    double u[8][6];
    int count, singular[8], chosen[8];
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
    if (kept->count == 8 || known_as(d, kept, u, 0) >= 0)
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
    struct descent *d, const struct kept *kept, double q[8][6], int found[8],
    int chosen[8])
{
    for (int row = 0; row < 8; row++)
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

/* All solutions, at most 8, of an arm with four turns and two slides. The directions give three
 * turns by the fourth, and the slides a determinant that has to vanish: the product over both
 * branches is of degree 4 in the hidden turn; here it is sampled at 24 angles.
 *
 * The loop J(q1) K0 J(q2) ... K4 J(q6) = P, in units of the arm's size, P = L T R. Everything below
 * that has the type general_rpprrr_lane does GENERAL_RPPRRR_LANES angles or candidates at once.
 */
/* Lanes: GNU vectors where the compiler has them, plain doubles otherwise. Vectors wider than the
 * machine's are slow: compile for the machine, or set GENERAL_RPPRRR_LANES to 1, 2, 4 or 8. */
#ifndef GENERAL_RPPRRR_LANES
#if defined(__GNUC__) && defined(__AVX512F__)
#define GENERAL_RPPRRR_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define GENERAL_RPPRRR_LANES 4
#elif defined(__GNUC__) && defined(__SSE2__)
#define GENERAL_RPPRRR_LANES 2
#else
#define GENERAL_RPPRRR_LANES 1
#endif
#endif

#if GENERAL_RPPRRR_LANES > 1 && defined(__SSE2__)
#include <immintrin.h>
#endif

/* Loops of few rounds over lanes: compilers leave them as they are where there are many operations,
 * and what could stay in registers goes through memory. */
#if GENERAL_RPPRRR_LANES == 1 || defined(__OPTIMIZE_SIZE__)
#define GENERAL_RPPRRR_UNROLL
#elif defined(__clang__)
#define GENERAL_RPPRRR_UNROLL _Pragma("clang loop unroll(full)")
#elif __GNUC__ >= 8
#define GENERAL_RPPRRR_UNROLL _Pragma("GCC unroll 16")
#else
#define GENERAL_RPPRRR_UNROLL
#endif

#define GENERAL_RPPRRR_ROOTS 24
#define GENERAL_RPPRRR_CANDIDATES 144

#if GENERAL_RPPRRR_LANES > 1
typedef double general_rpprrr_lane __attribute__((vector_size(8 * GENERAL_RPPRRR_LANES)));
typedef long long general_rpprrr_mask __attribute__((vector_size(8 * GENERAL_RPPRRR_LANES)));
/* the same where it lies between other doubles */
typedef double general_rpprrr_packed
    __attribute__((vector_size(8 * GENERAL_RPPRRR_LANES), aligned(8), may_alias));
/* arrays that begin where a lane may, so that no lane crosses the border of two cache lines */
#define GENERAL_RPPRRR_ALIGNED __attribute__((aligned(8 * GENERAL_RPPRRR_LANES)))
#define GENERAL_RPPRRR_LOAD(from) \
    (general_rpprrr_lane)(*(const general_rpprrr_packed *)(from))
#define GENERAL_RPPRRR_STORE(to, x) \
    (*(general_rpprrr_packed *)(to) = (general_rpprrr_packed)(x))

static inline general_rpprrr_lane general_rpprrr_select(general_rpprrr_mask m, general_rpprrr_lane
    a, general_rpprrr_lane b)
{
    return (general_rpprrr_lane)((m & (general_rpprrr_mask)a) | (~m & (general_rpprrr_mask)b));
}

static inline general_rpprrr_lane general_rpprrr_abs(general_rpprrr_lane x)
{
    return (general_rpprrr_lane)((general_rpprrr_mask)x & 0x7fffffffffffffffLL);
}

/* the magnitude of the first with the sign of the second */
static inline general_rpprrr_lane general_rpprrr_with_sign(general_rpprrr_lane x,
    general_rpprrr_lane y)
{
    const general_rpprrr_mask sign = (general_rpprrr_mask)y & (-0x7fffffffffffffffLL - 1);
    return (general_rpprrr_lane)(((general_rpprrr_mask)x & 0x7fffffffffffffffLL) | sign);
}

/* the first, turned round where the second is negative */
static inline general_rpprrr_lane general_rpprrr_facing(general_rpprrr_lane x, general_rpprrr_lane
    y)
{
    const general_rpprrr_mask sign = (general_rpprrr_mask)y & (-0x7fffffffffffffffLL - 1);
    return (general_rpprrr_lane)((general_rpprrr_mask)x ^ sign);
}

/* by the machine's own instruction: compilers take sqrt of <math.h> one by one, for the sake of
 * errno */
static inline general_rpprrr_lane general_rpprrr_sqrt(general_rpprrr_lane x)
{
#if GENERAL_RPPRRR_LANES == 8 && defined(__AVX512F__)
    return (general_rpprrr_lane)_mm512_sqrt_pd((__m512d)x);
#elif GENERAL_RPPRRR_LANES == 4 && defined(__AVX__)
    return (general_rpprrr_lane)_mm256_sqrt_pd((__m256d)x);
#elif GENERAL_RPPRRR_LANES == 2 && defined(__SSE2__)
    return (general_rpprrr_lane)_mm_sqrt_pd((__m128d)x);
#else
    general_rpprrr_lane r = x;
    for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
        r[k] = sqrt(x[k]);
    }
    return r;
#endif
}
#else
typedef double general_rpprrr_lane;
typedef int general_rpprrr_mask;
#define GENERAL_RPPRRR_ALIGNED
#define GENERAL_RPPRRR_LOAD(from) (*(from))
#define GENERAL_RPPRRR_STORE(to, x) (*(to) = (x))

static inline general_rpprrr_lane general_rpprrr_select(general_rpprrr_mask m, general_rpprrr_lane
    a, general_rpprrr_lane b)
{
    return m ? a : b;
}

static inline general_rpprrr_lane general_rpprrr_abs(general_rpprrr_lane x)
{
    return fabs(x);
}

static inline general_rpprrr_lane general_rpprrr_with_sign(general_rpprrr_lane x,
    general_rpprrr_lane y)
{
    return copysign(x, y);
}

static inline general_rpprrr_lane general_rpprrr_facing(general_rpprrr_lane x, general_rpprrr_lane
    y)
{
    return y < 0.0 ? -x : x;
}

static inline general_rpprrr_lane general_rpprrr_sqrt(general_rpprrr_lane x)
{
    return sqrt(x);
}
#endif

static inline general_rpprrr_lane general_rpprrr_all(double x)
{
    const general_rpprrr_lane zero = {0};
    return zero + x;
}

static inline general_rpprrr_lane general_rpprrr_max(general_rpprrr_lane a, general_rpprrr_lane b)
{
    return general_rpprrr_select(a > b, a, b);
}

static inline general_rpprrr_lane general_rpprrr_min(general_rpprrr_lane a, general_rpprrr_lane b)
{
    return general_rpprrr_select(a < b, a, b);
}

/* the largest of all lanes */
static inline double general_rpprrr_largest(general_rpprrr_lane x)
{
    double each[GENERAL_RPPRRR_LANES], most;
    GENERAL_RPPRRR_STORE(each, x);
    most = each[0];
    for (int k = 1; k < GENERAL_RPPRRR_LANES; k++) {
        most = each[k] > most ? each[k] : most;
    }
    return most;
}

/* The angle of a sine and a cosine with any positive common factor, in (-pi, pi], within 3 ulp:
 * atan of a ratio below tan(pi/8) by a polynomial. */
static inline general_rpprrr_lane general_rpprrr_angle(general_rpprrr_lane y, general_rpprrr_lane x)
{
    static const double odd[] = { -0.3333333333333333, 0.19999999999995513, -0.14285714284665177,
        0.11111111015146682, -0.0909090457366891, 0.07692183087347286, -0.0666450998991572,
        0.05858136252639731, -0.050853834915688644, 0.039229744582632814, -0.01917454359469326 };
    const general_rpprrr_lane ax = general_rpprrr_abs(x), ay = general_rpprrr_abs(y), zero = {0};
    const general_rpprrr_mask steep = ay > ax;
    const general_rpprrr_lane high = general_rpprrr_select(steep, ay, ax), low =
        general_rpprrr_select(steep, ax, ay);
    const general_rpprrr_mask turned = low > high * 0.41421356237309515;
    const general_rpprrr_lane up = general_rpprrr_select(turned, low - high, low);
    const general_rpprrr_lane down = general_rpprrr_select(turned, low + high, high);
    const general_rpprrr_lane r = up / (down + 1e-300), u = r * r;
    general_rpprrr_lane a = general_rpprrr_all(odd[10]);
    for (int k = 9; k >= 0; k--) {
        a = a * u + odd[k];
    }
    a = r + r * u * a + general_rpprrr_select(turned, zero + 0.7853981633974483, zero);
    a = general_rpprrr_select(steep, 1.5707963267948966 - a, a);
    a = general_rpprrr_select(x < 0.0, 3.141592653589793 - a, a);
    return general_rpprrr_with_sign(a, y + 0.0);
}

/* The loop: K0 ... K4 and the pose, three rows of four. */
typedef struct {
    double link[6][12];
} general_rpprrr_loop;

/* A formulation: the joints phi_1 (hidden) ... phi_6 are, from 0; phi = sign q, -1 reads the loop
 * backwards. */
typedef struct {
    int joint[6];
    double sign;
} general_rpprrr_formulation;

static const general_rpprrr_formulation general_rpprrr_formulations[2] = {
    { { 0, 1, 2, 3, 4, 5 }, 1.0 },
    { { 5, 0, 1, 2, 3, 4 }, 1.0 },
};

/* Whether a joint is a slide, whose length stands in the sine's place. */
static inline int general_rpprrr_slides(int joint)
{
    return joint == 1 || joint == 2;
}

/* The constants K0 ... K4 of the loop, L and R, three rows of four; for those with joints inside
 * whose values are given, what stands before, between and behind these. */
static const double general_rpprrr_constant[7][12] = {
    { 0.9800665778412416, -0.19866933079506124, 0.0, 0.30725200439388645, 0.06139219947677201,
        0.302857228171841, -0.9510565162951536, -0.018302540677770086, 0.1889457616406404,
        0.9320987052590043, 0.3090169943749475, 1.5422069881142466e-09 },
    { 0.8775825618903728, 0.479425538604203, 0.0, 0.0, -0.16397319142739547, 0.30015091359785295,
        -0.9396926207859084, -0.10069829274999541, -0.45051264084267917, 0.8246578575387761,
        0.3420201433256689, 0.01740675107216298 },
    { 0.28, -0.96, 0.0, 0.3687024052726637, 0.735402665394219, 0.2144924440733139,
        0.6427876096865394, 0.17431437873429476, -0.6170761052990777, -0.17998053071223105,
        0.7660444431189781, 0.10057890222660615 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.6145040087877729, 0.3060339136742996,
        0.29146087016599964, -0.9063077870366499, -0.06460811427924738, 0.6562918457851603,
        0.6250398531287241, 0.42261826174069944, 0.18909503225749508 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.49160320703021826, 0.608042333487267,
        0.2084716571956344, 0.766044443118978, -0.11619000069250957, -0.7246366353828171,
        -0.24844684641696585, 0.6427876096865394, 0.13846985098478687 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.5019354973539834 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.16936510476171932 },
};

/* cosine and sine of what is to be added to each joint's angle in the loop */
static const double general_rpprrr_advance[2][6] = {
    { 0.6, 1.0, 1.0, 0.28, 0.6896551724137931, 0.32432432432432434 },
    { 0.8, 0.0, 0.0, 0.96, 0.7241379310344828, 0.9459459459459459 },
};

/* poses close by, for those at which the formulations fail */
static const double general_rpprrr_nudge[10][12] = {
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
static const double general_rpprrr_sample_c[24] GENERAL_RPPRRR_ALIGNED = {
    1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386,
        0.9659258262890682
};

static const double general_rpprrr_sample_s[24] GENERAL_RPPRRR_ALIGNED = {
    0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0,
        0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207
};

/* from the samples to a_0, a_1 ... a_8, b_1 ... b_8 and seven numbers that would be zero without
 * rounding: one row for each sample */
static const double general_rpprrr_harmonics[24][24] GENERAL_RPPRRR_ALIGNED = {
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
static const double general_rpprrr_grid_c[8][128] GENERAL_RPPRRR_ALIGNED = {
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

static const double general_rpprrr_grid_s[8][128] GENERAL_RPPRRR_ALIGNED = {
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
static inline void general_rpprrr_compose(const double A[12], const double B[12], double C[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j] +
                           (j == 3 ? A[4 * i + 3] : 0.0);
        }
    }
}

static inline void general_rpprrr_invert(const double A[12], double B[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            B[4 * i + j] = A[4 * j + i];
        }
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11]);
    }
}

static inline void general_rpprrr_copy(const double A[12], double B[12])
{
    for (int i = 0; i < 12; i++) {
        B[i] = A[i];
    }
}

/* A becomes A B. */
static inline void general_rpprrr_then(double A[12], const double B[12])
{
    double C[12];
    general_rpprrr_compose(A, B, C);
    general_rpprrr_copy(C, A);
}

/* The links K0 ... K4 of the loop and its pose P = L T R, in arm sizes. */
static void general_rpprrr_close(const double T[16], general_rpprrr_loop *loop)
{
    double *const P = loop->link[5], right[12];
    general_rpprrr_copy(general_rpprrr_constant[0], loop->link[0]);
    general_rpprrr_copy(general_rpprrr_constant[1], loop->link[1]);
    general_rpprrr_copy(general_rpprrr_constant[2], loop->link[2]);
    general_rpprrr_copy(general_rpprrr_constant[3], loop->link[3]);
    general_rpprrr_copy(general_rpprrr_constant[4], loop->link[4]);
    general_rpprrr_copy(general_rpprrr_constant[5], P);
    general_rpprrr_copy(general_rpprrr_constant[6], right);
    general_rpprrr_then(P, T);
    general_rpprrr_then(P, right);
    for (int i = 3; i < 12; i += 4) {
        P[i] *= 3.072520043938864;
    }
}

/* a rigid transform for each lane */
typedef general_rpprrr_lane general_rpprrr_rigid[3][4];

/* T Rz */
static inline void general_rpprrr_turn(general_rpprrr_rigid T, general_rpprrr_lane c,
    general_rpprrr_lane s)
{
    for (int i = 0; i < 3; i++) {
        const general_rpprrr_lane x = T[i][0];
        T[i][0] = x * c + T[i][1] * s;
        T[i][1] = T[i][1] * c - x * s;
    }
}

/* T Tz */
static inline void general_rpprrr_slide(general_rpprrr_rigid T, general_rpprrr_lane d)
{
    for (int i = 0; i < 3; i++) {
        T[i][3] += T[i][2] * d;
    }
}

/* The motion of a joint: by its cosine and sine, or by a length that stands in the sine's place. */
static inline void general_rpprrr_move(general_rpprrr_rigid T, int joint, general_rpprrr_lane c,
    general_rpprrr_lane s)
{
    if (general_rpprrr_slides(joint)) {
        general_rpprrr_slide(T, s);
        return;
    }
    general_rpprrr_turn(T, c, s);
}

/* T K, the same K for every lane */
static inline void general_rpprrr_follow(general_rpprrr_rigid T, const double K[12])
{
    for (int i = 0; i < 3; i++) {
        const general_rpprrr_lane x = T[i][0], y = T[i][1], z = T[i][2];
        for (int j = 0; j < 3; j++) {
            T[i][j] = x * K[j] + y * K[4 + j] + z * K[8 + j];
        }
        T[i][3] += x * K[3] + y * K[7] + z * K[11];
    }
}

static inline void general_rpprrr_begin(general_rpprrr_rigid T, const double K[12])
{
    for (int i = 0; i < 12; i++) {
        T[i / 4][i % 4] = general_rpprrr_all(K[i]);
    }
}

/* A cosine and a sine without their common factor, which is told while it has a square. */
static inline void general_rpprrr_to_unit(general_rpprrr_lane *c, general_rpprrr_lane *s)
{
    const general_rpprrr_lane square = *c * *c + *s * *s, factor = 1.0 / general_rpprrr_sqrt(square
        + 1e-300);
    const general_rpprrr_mask told = (square > 1e-300) & (square < 9.999999999999999e+299);
    *c = general_rpprrr_select(told, *c * factor, general_rpprrr_all(1.0));
    *s = general_rpprrr_select(told, *s * factor, general_rpprrr_all(0.0));
}

/* Reflect `rows` rows of a matrix with `columns` columns so that below the first, `column` becomes
 * zero; row[i] points to the i-th of them. Returns the new diagonal. Sums are of two halves, so
 * that half as many operations wait for each other. */
static inline general_rpprrr_lane general_rpprrr_reflect(general_rpprrr_lane *const *row, int rows,
    int column, int columns)
{
    general_rpprrr_lane axis[6], half[2], length, factor;
    for (int i = 0; i < 6; i++) {
        axis[i] = half[i % 2] = general_rpprrr_all(0.0); /* compilers don't see that `rows` of them
            are used */
    }
    GENERAL_RPPRRR_UNROLL
    for (int i = 0; i < rows; i++) {
        axis[i] = row[i][column];
        half[i % 2] += axis[i] * axis[i];
    }
    length = general_rpprrr_with_sign(general_rpprrr_sqrt(half[0] + half[1]), axis[0]);
    axis[0] += length;
    factor = 1.0 / (length * axis[0] + 1e-300);
    GENERAL_RPPRRR_UNROLL
    for (int j = column + 1; j < columns; j++) {
        general_rpprrr_lane sum;
        half[0] = axis[0] * row[0][j];
        half[1] = axis[1] * row[1][j];
        GENERAL_RPPRRR_UNROLL
        for (int i = 2; i < rows; i++) {
            half[i % 2] += axis[i] * row[i][j];
        }
        sum = (half[0] + half[1]) * factor;
        GENERAL_RPPRRR_UNROLL
        for (int i = 0; i < rows; i++) {
            row[i][j] -= axis[i] * sum;
        }
    }
    row[0][column] = -length;
    return -length;
}

/* f(x) = sum a_m cos mx + b_m sin mx, m = 0 ... 8, and where it vanishes. */
typedef struct {
    double a[9], b[9];
    double scale;    /* the largest sample */
    double noise;    /* the harmonics beyond the eighth, over scale */
    double rounding; /* how far f may be from what it stands for */
    double touching; /* how far an extremum may be lifted for roots to meet there */
} general_rpprrr_trigonometric;

/* f and f' at the edges of the cells; the first edge stands at the end again */
typedef struct {
    double value[264] GENERAL_RPPRRR_ALIGNED, slope[264] GENERAL_RPPRRR_ALIGNED;
} general_rpprrr_grid;

/* The roots by their cosines and sines: `simple` of them change the sign of f, `doubles` touch zero
 * within the rounding of f (two roots, none or one); behind these stand `unseen` places where a
 * closer look shows no root. At `lifted` places f turns back beside zero: no root, unless rounding
 * of what f is made of has lifted it off. `complete` says that no cell was given up. */
typedef struct {
    int simple, doubles, unseen, lifted, complete;
    double c[GENERAL_RPPRRR_ROOTS + 8], s[GENERAL_RPPRRR_ROOTS + 8];
    double double_c[GENERAL_RPPRRR_ROOTS], double_s[GENERAL_RPPRRR_ROOTS];
    double lifted_c[GENERAL_RPPRRR_ROOTS], lifted_s[GENERAL_RPPRRR_ROOTS];
} general_rpprrr_roots;

/* What part of the circle is searched: the cell in its middle, how many it has on both sides, and
 * the value of a parabola over its bend where two complex roots count as a double one. */
typedef struct {
    int middle, reach;
    double lifted;
} general_rpprrr_window;

static void general_rpprrr_fit(const double samples[24], general_rpprrr_trigonometric *f)
{
    double h[24] = {0.0}, most = 0.0, beyond = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    for (int k = 0; k < 24; k++) {
        for (int j = 0; j < 24; j++) {
            h[j] += samples[k] * general_rpprrr_harmonics[k][j];
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
static void general_rpprrr_at(const general_rpprrr_trigonometric *f, double cosine, double sine,
    double out[3])
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
static void general_rpprrr_fill_grid(const general_rpprrr_trigonometric *f, general_rpprrr_grid *g)
{
    const double *const a = f->a, *const b = f->b;
    for (int i = 0; i < 128; i += GENERAL_RPPRRR_LANES) {
        /* even multiples, the same half a turn on; odd ones, the opposite there */
        general_rpprrr_lane even = general_rpprrr_all(a[0]), odd = general_rpprrr_all(0.0);
        general_rpprrr_lane even_slope = odd, odd_slope = odd;
        GENERAL_RPPRRR_UNROLL
        for (int m = 1; m < 9; m += 2) {
            const general_rpprrr_lane c = GENERAL_RPPRRR_LOAD(&general_rpprrr_grid_c[m - 1][i]), s =
                GENERAL_RPPRRR_LOAD(&general_rpprrr_grid_s[m - 1][i]);
            odd += a[m] * c + b[m] * s;
            odd_slope += m * b[m] * c - m * a[m] * s;
        }
        GENERAL_RPPRRR_UNROLL
        for (int m = 2; m < 9; m += 2) {
            const general_rpprrr_lane c = GENERAL_RPPRRR_LOAD(&general_rpprrr_grid_c[m - 1][i]), s =
                GENERAL_RPPRRR_LOAD(&general_rpprrr_grid_s[m - 1][i]);
            even += a[m] * c + b[m] * s;
            even_slope += m * b[m] * c - m * a[m] * s;
        }
        GENERAL_RPPRRR_STORE(&g->value[i], even + odd);
        GENERAL_RPPRRR_STORE(&g->value[i + 128], even - odd);
        GENERAL_RPPRRR_STORE(&g->slope[i], even_slope + odd_slope);
        GENERAL_RPPRRR_STORE(&g->slope[i + 128], even_slope - odd_slope);
    }
    g->value[256] = g->value[0];
    g->slope[256] = g->slope[0];
}

/* Which of 64 cells may have roots: those where the Bernstein coefficients of the cubic through f
 * and f' at both edges are not all of the sign of the first beyond doubt. */
static unsigned long long general_rpprrr_open_cells(const general_rpprrr_grid *g, int from, double
    doubt)
{
    const double third = 0.02454369260617026 / 3.0;
    unsigned long long bits = 0;
#if GENERAL_RPPRRR_LANES > 1
    general_rpprrr_mask weight, sum = {0};
    for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
        weight[k] = 1LL << k;
    }
#endif
    for (int i = 0; i < 64; i += GENERAL_RPPRRR_LANES) {
        const general_rpprrr_lane first = GENERAL_RPPRRR_LOAD(&g->value[from + i]);
        const general_rpprrr_lane f0 = general_rpprrr_abs(first) - doubt;
        const general_rpprrr_lane f1 = general_rpprrr_facing(GENERAL_RPPRRR_LOAD(&g->value[from + i
            + 1]), first) - doubt;
        const general_rpprrr_lane d0 = general_rpprrr_facing(GENERAL_RPPRRR_LOAD(&g->slope[from +
            i]), first);
        const general_rpprrr_lane d1 = general_rpprrr_facing(GENERAL_RPPRRR_LOAD(&g->slope[from + i
            + 1]), first);
        const general_rpprrr_lane b1 = f0 + third * d0, b2 = f1 - third * d1;
#if GENERAL_RPPRRR_LANES > 1
        const general_rpprrr_mask signs = (general_rpprrr_mask)f0 | (general_rpprrr_mask)f1 |
            (general_rpprrr_mask)b1 | (general_rpprrr_mask)b2;
        sum |= ((signs < 0) & weight) << i;
#else
        bits |= (unsigned long long)(f0 < 0.0 || f1 < 0.0 || b1 < 0.0 || b2 < 0.0) << i;
#endif
    }
#if GENERAL_RPPRRR_LANES > 1
    for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
        bits |= (unsigned long long)sum[k];
    }
#endif
    return bits;
}

static void general_rpprrr_add_angle(double c, double s, double *cosine, double *sine, int *count,
    int *complete)
{
    if (*count == GENERAL_RPPRRR_ROOTS) {
        *complete = 0;
        return;
    }
    cosine[*count] = c;
    sine[*count] = s;
    *count += 1;
}

/* The same unless it is there: neighbouring cells may be given up together. */
static void general_rpprrr_add_once(double c, double s, double *cosine, double *sine, int *count,
    int *complete)
{
    for (int i = 0; i < *count; i++) {
        const double gap = fabs(s * cosine[i] - c * sine[i]);
        if (gap < 0.02454369260617026 / 64.0 && c * cosine[i] + s * sine[i] > 0.0) {
            return;
        }
    }
    general_rpprrr_add_angle(c, s, cosine, sine, count, complete);
}

static void general_rpprrr_add_simple(general_rpprrr_roots *roots, double c, double s)
{
    general_rpprrr_add_angle(c, s, roots->c, roots->s, &roots->simple, &roots->complete);
}

static void general_rpprrr_add_double(general_rpprrr_roots *roots, double c, double s)
{
    general_rpprrr_add_once(c, s, roots->double_c, roots->double_s, &roots->doubles,
        &roots->complete);
}

static void general_rpprrr_add_lifted(general_rpprrr_roots *roots, double c, double s)
{
    general_rpprrr_add_once(c, s, roots->lifted_c, roots->lifted_s, &roots->lifted,
        &roots->complete);
}

/* Parts of the circle: cosine and sine where each begins, its width, f, f', f'' at both ends, and
 * about where what is looked for lies, in parts of the width. */
typedef struct {
    int count;
    double c[48], s[48], width[48], start[48];
    double low[3][48], high[3][48];
} general_rpprrr_parts;

/* Parts where f turns once, and parts where it rises or falls throughout and has a root. */
typedef struct {
    double lifted; /* as of the window */
    general_rpprrr_parts turning, crossing;
} general_rpprrr_waiting;

static void general_rpprrr_add_part(general_rpprrr_parts *parts, double c, double s, double width,
    const double low[3],
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
    general_rpprrr_lane c, s, width, start, low[3], high[3];
} general_rpprrr_spans;

/* Parts from one on; behind the last one it stands again. */
static void general_rpprrr_take_parts(general_rpprrr_parts *parts, int from, general_rpprrr_spans
    *out)
{
    const int last = parts->count - 1;
    while (parts->count < from + GENERAL_RPPRRR_LANES) {
        const double low[3] = {parts->low[0][last], parts->low[1][last], parts->low[2][last]};
        const double high[3] = {parts->high[0][last], parts->high[1][last], parts->high[2][last]};
        general_rpprrr_add_part(parts, parts->c[last], parts->s[last], parts->width[last], low,
            high,
                         parts->start[last]);
    }
    parts->count = last + 1;
    out->c = GENERAL_RPPRRR_LOAD(parts->c + from);
    out->s = GENERAL_RPPRRR_LOAD(parts->s + from);
    out->width = GENERAL_RPPRRR_LOAD(parts->width + from);
    out->start = GENERAL_RPPRRR_LOAD(parts->start + from);
    for (int i = 0; i < 3; i++) {
        out->low[i] = GENERAL_RPPRRR_LOAD(parts->low[i] + from);
        out->high[i] = GENERAL_RPPRRR_LOAD(parts->high[i] + from);
    }
}

/* Where the quintic through f, f', f'' at both ends vanishes (order 0), or its derivative (order
 * 1), in parts of the width. */
static inline general_rpprrr_lane general_rpprrr_on_quintic(int order, const general_rpprrr_spans
    *part)
{
    const general_rpprrr_lane h = part->width, d = h * part->low[1], s = h * h * part->low[2];
    const general_rpprrr_lane D = part->high[0] - part->low[0] - d - 0.5 * s;
    const general_rpprrr_lane D1 = h * part->high[1] - d - s, D2 = h * h * part->high[2] - s;
    const general_rpprrr_lane c3 = 10.0 * D - 4.0 * D1 + 0.5 * D2, c4 = 7.0 * D1 - 15.0 * D - D2;
    const general_rpprrr_lane c5 = 6.0 * D - 3.0 * D1 + 0.5 * D2;
    const general_rpprrr_mask rising = part->low[order] < 0.0;
    general_rpprrr_lane x = part->start, from = general_rpprrr_all(0.0), to =
        general_rpprrr_all(1.0);
    for (int i = 0; i < 4; i++) {
        const general_rpprrr_lane f = part->low[0] + x * (d + x * (0.5 * s + x * (c3 + x * (c4 + x *
            c5))));
        const general_rpprrr_lane f1 = d + x * (s + x * (3.0 * c3 + x * (4.0 * c4 + x * (5.0 *
            c5))));
        const general_rpprrr_lane f2 = s + x * (6.0 * c3 + x * (12.0 * c4 + x * (20.0 * c5)));
        const general_rpprrr_lane value = order ? f1 : f, slope = order ? f2 : f1;
        const general_rpprrr_mask before = (value < 0.0) == rising;
        from = general_rpprrr_select(before, x, from);
        to = general_rpprrr_select(before, to, x);
        x -= value / slope;
        x = general_rpprrr_select((x >= from) & (x <= to), x, 0.5 * (from + to));
    }
    return x;
}

/* f, f', f'' where cosine and sine are given */
static inline void general_rpprrr_at_all(const general_rpprrr_trigonometric *f, general_rpprrr_lane
    cosine, general_rpprrr_lane sine,
                                  general_rpprrr_lane out[3])
{
    general_rpprrr_lane c[9], s[9];
    c[1] = cosine;
    s[1] = sine;
    out[0] = general_rpprrr_all(f->a[0]);
    out[1] = out[2] = general_rpprrr_all(0.0);
    for (int m = 1; m < 9; m++) {
        const int less = m / 2, more = m - m / 2;
        if (less) {
            c[m] = c[less] * c[more] - s[less] * s[more];
            s[m] = s[less] * c[more] + c[less] * s[more];
        }
        const general_rpprrr_lane even = f->a[m] * c[m] + f->b[m] * s[m], odd = f->b[m] * c[m] -
            f->a[m] * s[m];
        out[0] += even;
        out[1] += m * odd;
        out[2] -= m * m * even;
    }
}

/* Turn on by a small angle, no larger than a cell. */
static inline void general_rpprrr_turn_on(general_rpprrr_lane x, general_rpprrr_lane *c,
    general_rpprrr_lane *s)
{
    const general_rpprrr_lane u = x * x, c0 = *c, s0 = *s;
    const general_rpprrr_lane dc = 1.0 - u * (0.5 - u * (1.0 / 24.0 - u * (1.0 / 720.0)));
    const general_rpprrr_lane ds = x * (1.0 - u * (1.0 / 6.0 - u * (1.0 / 120.0 - u * (1.0 /
        5040.0))));
    *c = c0 * dc - s0 * ds;
    *s = s0 * dc + c0 * ds;
}

/* Where f (order 0) or f' (order 1) vanishes: from where the quintic says by Newton, with bisection
 * where it leaves. Returns how far that is from where each part begins, with cosine and sine, and
 * f, f', f'' there, as far as an extremum is concerned. */
static inline general_rpprrr_lane general_rpprrr_between(const general_rpprrr_trigonometric *f, int
    order, double settled,
                                           const general_rpprrr_spans *part, general_rpprrr_lane *c,
                                               general_rpprrr_lane *s,
                                           general_rpprrr_lane at[3])
{
    const general_rpprrr_mask rising = part->low[order] < 0.0;
    general_rpprrr_lane from = general_rpprrr_all(0.0), to = part->width, x = part->width *
        general_rpprrr_on_quintic(order, part);
    general_rpprrr_lane step = part->width;
    for (int i = 0; i < 48; i++) {
        const general_rpprrr_mask moving = general_rpprrr_abs(step) >= settled;
        if (i && general_rpprrr_largest(general_rpprrr_abs(step)) < settled) {
            break;
        }
        *c = part->c;
        *s = part->s;
        general_rpprrr_turn_on(x, c, s);
        general_rpprrr_at_all(f, *c, *s, at);
        const general_rpprrr_mask before = (at[order] < 0.0) == rising;
        from = general_rpprrr_select(before, x, from);
        to = general_rpprrr_select(before, to, x);
        step = -at[order] / at[order + 1];
        step = general_rpprrr_select((x + step >= from) & (x + step <= to), step, 0.5 * (from + to)
            - x);
        step = general_rpprrr_select(moving, step, general_rpprrr_all(0.0));
        x += step;
    }
    general_rpprrr_turn_on(step, c, s);
    at[0] += 0.5 * step * at[1]; /* what a parabola gains where its slope vanishes */
    return x;
}

/* The double root, or the parts with a root, of a part of the circle whose extremum is known. */
static void general_rpprrr_divide(const general_rpprrr_trigonometric *f, const general_rpprrr_parts
    *parts, int i, double x,
                           double c, double s, const double at[3], general_rpprrr_waiting *waiting,
                           general_rpprrr_roots *roots)
{
    const double bend = fabs(at[2]) * waiting->lifted, near = bend > f->touching ? bend :
        f->touching;
    const double beside = fabs(at[0]);
    const double low[3] = {parts->low[0][i], parts->low[1][i], parts->low[2][i]};
    const double high[3] = {parts->high[0][i], parts->high[1][i], parts->high[2][i]};
    if (beside <= f->rounding) {
        general_rpprrr_add_double(roots, c, s);
        return;
    }
    if (at[0] * at[2] > 0.0 && beside <= near) {
        general_rpprrr_add_lifted(roots, c, s);
        return;
    }
    /* where a parabola with its summit at the extremum has its roots */
    if ((low[0] < 0.0) != (at[0] < 0.0)) {
        general_rpprrr_add_part(&waiting->crossing, parts->c[i], parts->s[i], x, low, at,
                         1.0 - sqrt(at[0] / (at[0] - low[0])));
    }
    if ((high[0] < 0.0) != (at[0] < 0.0)) {
        general_rpprrr_add_part(&waiting->crossing, c, s, parts->width[i] - x, at, high,
                         sqrt(at[0] / (at[0] - high[0])));
    }
}

/* The roots of all parts that wait. */
static void general_rpprrr_solve_parts(const general_rpprrr_trigonometric *f, general_rpprrr_waiting
    *waiting, general_rpprrr_roots *roots)
{
    general_rpprrr_parts *const bent = &waiting->turning, *const crossing = &waiting->crossing;
    double x[GENERAL_RPPRRR_LANES], c[GENERAL_RPPRRR_LANES], s[GENERAL_RPPRRR_LANES],
        value[3][GENERAL_RPPRRR_LANES];
    general_rpprrr_spans part;
    general_rpprrr_lane cosine, sine, at[3];
    for (int from = 0; from < bent->count; from += GENERAL_RPPRRR_LANES) {
        general_rpprrr_take_parts(bent, from, &part);
        GENERAL_RPPRRR_STORE(x, general_rpprrr_between(f, 1, 1e-07, &part, &cosine, &sine, at));
        GENERAL_RPPRRR_STORE(c, cosine);
        GENERAL_RPPRRR_STORE(s, sine);
        for (int i = 0; i < 3; i++) {
            GENERAL_RPPRRR_STORE(value[i], at[i]);
        }
        for (int k = 0; k < GENERAL_RPPRRR_LANES && from + k < bent->count; k++) {
            const double extremum[3] = {value[0][k], 0.0, value[2][k]};
            general_rpprrr_divide(f, bent, from + k, x[k], c[k], s[k], extremum, waiting, roots);
        }
    }
    for (int from = 0; from < crossing->count; from += GENERAL_RPPRRR_LANES) {
        general_rpprrr_take_parts(crossing, from, &part);
        (void)general_rpprrr_between(f, 0, 1e-09, &part, &cosine, &sine, at);
        GENERAL_RPPRRR_STORE(c, cosine);
        GENERAL_RPPRRR_STORE(s, sine);
        for (int k = 0; k < GENERAL_RPPRRR_LANES && from + k < crossing->count; k++) {
            general_rpprrr_add_simple(roots, c[k], s[k]);
        }
    }
    bent->count = crossing->count = 0;
}

/* A part where f has one extremum at most waits for others, to be solved in lanes. */
static void general_rpprrr_few(const general_rpprrr_trigonometric *f, double c, double s, double
    width, const double low[3],
                        const double high[3], general_rpprrr_waiting *waiting, general_rpprrr_roots
                            *roots)
{
    if (low[1] * high[1] < 0.0) {
        general_rpprrr_add_part(&waiting->turning, c, s, width, low, high, low[1] / (low[1] -
            high[1]));
    } else if ((low[0] < 0.0) != (high[0] < 0.0)) {
        general_rpprrr_add_part(&waiting->crossing, c, s, width, low, high, low[0] / (low[0] -
            high[0]));
    }
    if (waiting->turning.count == 16 || waiting->crossing.count == 16) {
        general_rpprrr_solve_parts(f, waiting, roots);
    }
}

/* What is known about f in a part of the circle. */
enum { GENERAL_RPPRRR_ROOTLESS, GENERAL_RPPRRR_FLAT, GENERAL_RPPRRR_TAME, GENERAL_RPPRRR_WILD };

/* Rootless; flat, nothing but rounding; tame, with one extremum at most; or none of these. The
 * Bernstein coefficients of the quintic through f, f', f'' at both ends and their differences bound
 * f, f' and f''. */
static inline void general_rpprrr_kinds(const general_rpprrr_trigonometric *f, const
    general_rpprrr_spans *part, int kind[GENERAL_RPPRRR_LANES])
{
    const general_rpprrr_lane h = part->width, d0 = h * part->low[1] * 0.2, d1 = h * part->high[1] *
        0.2;
    const general_rpprrr_lane s0 = h * h * part->low[2] * 0.05, s1 = h * h * part->high[2] * 0.05;
    const general_rpprrr_lane share = h * (1.0 / 0.02454369260617026), square = share * share;
    const general_rpprrr_lane doubt = f->rounding + f->scale * 2e-09 * square * square * square;
    const general_rpprrr_lane b[6] = {part->low[0],
                           part->low[0] + d0,
                           part->low[0] + 2.0 * d0 + s0,
                           part->high[0] - 2.0 * d1 + s1,
                           part->high[0] - d1,
                           part->high[0]};
    general_rpprrr_lane least[3], most[3];
    double bounds[5][GENERAL_RPPRRR_LANES];
    least[0] = general_rpprrr_min(b[0], b[5]);
    most[0] = general_rpprrr_max(b[0], b[5]);
    least[1] = most[1] = b[1] - b[0];
    least[2] = most[2] = b[2] - b[1] - least[1];
    for (int i = 1; i < 5; i++) {
        const general_rpprrr_lane first = b[i + 1] - b[i], second = first - (b[i] - b[i - 1]);
        least[0] = general_rpprrr_min(least[0], b[i]);
        most[0] = general_rpprrr_max(most[0], b[i]);
        least[1] = general_rpprrr_min(least[1], first);
        most[1] = general_rpprrr_max(most[1], first);
        least[2] = general_rpprrr_min(least[2], second);
        most[2] = general_rpprrr_max(most[2], second);
    }
    /* what rounding does to f' and f'' shrinks with the width, down to that of the quintic's
     * ends */
    GENERAL_RPPRRR_STORE(bounds[0], least[0]);
    GENERAL_RPPRRR_STORE(bounds[1], most[0]);
    GENERAL_RPPRRR_STORE(bounds[2], general_rpprrr_max(least[1], -most[1]) - doubt * share);
    GENERAL_RPPRRR_STORE(bounds[3], general_rpprrr_max(least[2], -most[2]) - doubt * square);
    GENERAL_RPPRRR_STORE(bounds[4], general_rpprrr_max(doubt, general_rpprrr_all(f->touching)));
    for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
        if (bounds[0][k] > bounds[4][k] || bounds[1][k] < -bounds[4][k]) {
            kind[k] = GENERAL_RPPRRR_ROOTLESS;
        } else if (bounds[0][k] >= -f->rounding && bounds[1][k] <= f->rounding) {
            kind[k] = GENERAL_RPPRRR_FLAT;
        } else {
            kind[k] = bounds[2][k] > 0.0 || bounds[3][k] > 0.0 ? GENERAL_RPPRRR_TAME :
                GENERAL_RPPRRR_WILD;
        }
    }
}

/* The same of one part. */
static int general_rpprrr_kind(const general_rpprrr_trigonometric *f, const double low[3], const
    double high[3], double h)
{
    general_rpprrr_spans part;
    int kind[GENERAL_RPPRRR_LANES];
    part.width = general_rpprrr_all(h);
    for (int i = 0; i < 3; i++) {
        part.low[i] = general_rpprrr_all(low[i]);
        part.high[i] = general_rpprrr_all(high[i]);
    }
    general_rpprrr_kinds(f, &part, kind);
    return kind[0];
}

/* The roots of a cell where f may turn more than once: halve it until it does not. */
static void general_rpprrr_many(const general_rpprrr_trigonometric *f, double low, double c, double
    s, const double first[3],
                         const double last[3], int *budget, general_rpprrr_waiting *waiting,
                         general_rpprrr_roots *roots)
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
        const int kind = general_rpprrr_kind(f, at_low, at[top], h);
        if (kind == GENERAL_RPPRRR_TAME) {
            general_rpprrr_few(f, c, s, h, at_low, at[top], waiting, roots);
        } else if (kind != GENERAL_RPPRRR_ROOTLESS) {
            const double middle = low + 0.5 * h, cosine = cos(middle), sine = sin(middle);
            if (kind == GENERAL_RPPRRR_FLAT || depth[top] == 14 || *budget == 0) {
                general_rpprrr_solve_parts(f, waiting, roots); /* of neighbouring double roots the
                    first is kept */
                roots->complete = 0;
                general_rpprrr_add_double(roots, cosine, sine);
            } else {
                *budget -= 1;
                edge[open] = middle;
                edge_c[open] = cosine;
                edge_s[open] = sine;
                depth[top] += 1;
                depth[open] = depth[top];
                general_rpprrr_at(f, cosine, sine, at[open]);
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
static void general_rpprrr_edge(int cell, double *c, double *s)
{
    const int half = cell % 128;
    *c = cell < 128 ? general_rpprrr_grid_c[0][half] : -general_rpprrr_grid_c[0][half];
    *s = cell < 128 ? general_rpprrr_grid_s[0][half] : -general_rpprrr_grid_s[0][half];
}

static int general_rpprrr_lowest(unsigned long long bits)
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
static void general_rpprrr_search_cells(const general_rpprrr_trigonometric *f, const
    general_rpprrr_grid *g, const int *cell, int count,
                                 int *budget, general_rpprrr_waiting *waiting, general_rpprrr_roots
                                     *roots)
{
    const double h = 0.02454369260617026;
    double in[8][GENERAL_RPPRRR_LANES], bend[2][GENERAL_RPPRRR_LANES];
    int kind[GENERAL_RPPRRR_LANES];
    general_rpprrr_spans part;
    for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
        const int i = cell[k < count ? k : 0];
        in[0][k] = g->value[i];
        in[1][k] = g->slope[i];
        in[2][k] = g->value[i + 1];
        in[3][k] = g->slope[i + 1];
        general_rpprrr_edge(i, &in[4][k], &in[5][k]);
        general_rpprrr_edge((i + 1) % 256, &in[6][k], &in[7][k]);
    }
    part.width = general_rpprrr_all(h);
    for (int end = 0; end < 2; end++) {
        general_rpprrr_lane at[3], *const to = end ? part.high : part.low;
        general_rpprrr_at_all(f, GENERAL_RPPRRR_LOAD(in[4 + 2 * end]), GENERAL_RPPRRR_LOAD(in[5 + 2
            * end]), at);
        /* the edges' own values, so that neighbouring cells agree about their signs */
        to[0] = GENERAL_RPPRRR_LOAD(in[2 * end]);
        to[1] = GENERAL_RPPRRR_LOAD(in[2 * end + 1]);
        to[2] = at[2];
        GENERAL_RPPRRR_STORE(bend[end], at[2]);
    }
    general_rpprrr_kinds(f, &part, kind);
    for (int k = 0; k < count; k++) {
        const double low[3] = {in[0][k], in[1][k], bend[0][k]};
        const double high[3] = {in[2][k], in[3][k], bend[1][k]};
        if (kind[k] == GENERAL_RPPRRR_TAME) {
            general_rpprrr_few(f, in[4][k], in[5][k], h, low, high, waiting, roots);
        } else if (kind[k] != GENERAL_RPPRRR_ROOTLESS) {
            general_rpprrr_many(f, cell[k] * h, in[4][k], in[5][k], low, high, budget, waiting,
                roots);
        }
    }
}

static void general_rpprrr_find_roots(const general_rpprrr_trigonometric *f, const
    general_rpprrr_window *window,
                               general_rpprrr_roots *roots)
{
    general_rpprrr_grid g;
    general_rpprrr_waiting waiting;
    int open[256], count = 0;
    int budget = 100; /* against an f that is next to nothing for long stretches */
    general_rpprrr_fill_grid(f, &g);
    roots->simple = roots->doubles = roots->unseen = roots->lifted = 0;
    roots->complete = 1;
    for (int word = 0; word < 256 / 64; word++) {
        unsigned long long bits =
            general_rpprrr_open_cells(&g, 64 * word, f->rounding + f->scale * 2e-05);
        for (; bits; bits &= bits - 1) {
            const int i = 64 * word + general_rpprrr_lowest(bits);
            const int away = i > window->middle ? i - window->middle : window->middle - i;
            if (away <= window->reach || 256 - away <= window->reach) {
                open[count++] = i;
            }
        }
    }
    waiting.lifted = window->lifted;
    waiting.turning.count = waiting.crossing.count = 0;
    for (int k = 0; k < count; k += GENERAL_RPPRRR_LANES) {
        general_rpprrr_search_cells(f, &g, open + k, count - k < GENERAL_RPPRRR_LANES ? count - k :
            GENERAL_RPPRRR_LANES, &budget,
                             &waiting, roots);
    }
    general_rpprrr_solve_parts(f, &waiting, roots);
}

/* A lens on the circle: e^(i phi) = (w + a) / (1 + conj(a) w) with a = x + i y inside the circle
 * maps the circle of w = e^(i psi) to itself and shows what lies around the direction of a larger.
 * Where all roots lie together, as near the boundary of reach, f drowns in rounding without it. */
typedef struct {
    double x, y;
} general_rpprrr_lens;

/* Cosine and sine of phi from those of psi. Returns |1 + conj(a) w|^2, whose eighth power makes of
 * f a polynomial in psi. */
static inline general_rpprrr_lane general_rpprrr_through(const general_rpprrr_lens *a,
    general_rpprrr_lane *c, general_rpprrr_lane *s)
{
    const general_rpprrr_lane u = *c + a->x, v = *s + a->y;
    const general_rpprrr_lane d = 1.0 + a->x * *c + a->y * *s, e = a->x * *s - a->y * *c;
    const general_rpprrr_lane square = d * d + e * e;
    *c = (u * d + v * e) / square;
    *s = (v * d - u * e) / square;
    return square;
}

/* The samples of f in phi become those of a polynomial in psi. */
static inline general_rpprrr_lane general_rpprrr_weighted(general_rpprrr_lane f, general_rpprrr_lane
    square)
{
    const general_rpprrr_lane fourth = square * square, eighth = fourth * fourth;
    return f * (eighth * eighth);
}

/* The lens under which the roots are spread, from samples without one; 0 when they are already. log
 * |f| is a sum over the roots z, and the first harmonic of log |e^(i phi) - z| is -z for z inside
 * the circle, that of its mirror image for z outside. */
static int general_rpprrr_spread(const double samples[24], general_rpprrr_lens *a)
{
    double x = 0.0, y = 0.0, square, part;
    for (int k = 0; k < 12; k++) {
        const double ratio = log((fabs(samples[k]) + 1e-300) / (fabs(samples[k + 12]) + 1e-300));
        x += ratio * general_rpprrr_sample_c[k];
        y += ratio * general_rpprrr_sample_s[k];
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
static void general_rpprrr_behind(const general_rpprrr_lens *a, int count, double *cosine, double
    *sine)
{
    for (int i = 0; i < count; i += GENERAL_RPPRRR_LANES) {
        general_rpprrr_lane c = GENERAL_RPPRRR_LOAD(cosine + i), s = GENERAL_RPPRRR_LOAD(sine + i);
        (void)general_rpprrr_through(a, &c, &s);
        GENERAL_RPPRRR_STORE(cosine + i, c);
        GENERAL_RPPRRR_STORE(sine + i, s);
    }
}

/* Samples of a polynomial through a lens; `of` is what it is made of. */
typedef void (*general_rpprrr_sampler)(const void *of, const general_rpprrr_lens *lens, double
    samples[24]);

/* Keeps of angles beside which there is no root, as far as f tells, those where what it is made of
 * allows one; returns how many. */
typedef int (*general_rpprrr_keeper)(const void *of, int count, double *cosine, double *sine);

/* What f is made of, and what tells of it; `keep` may be 0, where nothing tells. */
typedef struct {
    general_rpprrr_sampler sample;
    general_rpprrr_keeper keep;
    const void *of;
} general_rpprrr_source;

/* Whether two angles, by their cosines and sines, are as near as a closer look reaches. */
static int general_rpprrr_near(double c, double s, double cosine, double sine)
{
    return c * cosine + s * sine >= 0.9980487804878049;
}

/* Of roots those that are near to an angle, or those that are not, behind `count` that are kept. */
static int general_rpprrr_keep_roots(int near, double cosine, double sine, const double *from_c,
                              const double *from_s, int many, double *c, double *s, int count)
{
    for (int i = 0; i < many && count < GENERAL_RPPRRR_ROOTS; i++) {
        if (general_rpprrr_near(from_c[i], from_s[i], cosine, sine) == near) {
            c[count] = from_c[i];
            s[count] = from_s[i];
            count++;
        }
    }
    return count;
}

static int general_rpprrr_kept(const general_rpprrr_source *source, int count, double *cosine,
    double *sine)
{
    return source->keep ? source->keep(source->of, count, cosine, sine) : count;
}

/* The places where f turns back beside zero are double roots where there may be any. */
static void general_rpprrr_take_lifted(const general_rpprrr_source *source, general_rpprrr_roots
    *roots)
{
    const int count = general_rpprrr_kept(source, roots->lifted, roots->lifted_c, roots->lifted_s);
    for (int i = 0; i < count; i++) {
        general_rpprrr_add_double(roots, roots->lifted_c[i], roots->lifted_s[i]);
    }
}

/* The roots around an angle, through a lens that magnifies what is there, instead of those that
 * were known. Returns 0, and leaves these, where that does not show all. */
static int general_rpprrr_magnify(const general_rpprrr_source *source, double cosine, double sine,
    general_rpprrr_roots *roots)
{
    const general_rpprrr_lens lens = { 0.8823529411764706 * cosine, 0.8823529411764706 * sine};
    const double turns = atan2(sine, cosine) / 6.283185307179586;
    const int cell = (int)(256.0 * (turns - floor(turns))) % 256;
    const general_rpprrr_window window = {cell, 38, 1.28e-06};
    double samples[24];
    general_rpprrr_trigonometric f;
    general_rpprrr_roots found;
    source->sample(source->of, &lens, samples);
    general_rpprrr_fit(samples, &f);
    if (!(f.noise <= 1e-10)) {
        return 0;
    }
    general_rpprrr_find_roots(&f, &window, &found);
    if (!found.complete) {
        return 0;
    }
    general_rpprrr_behind(&lens, found.simple, found.c, found.s);
    general_rpprrr_behind(&lens, found.doubles, found.double_c, found.double_s);
    general_rpprrr_behind(&lens, found.lifted, found.lifted_c, found.lifted_s);
    general_rpprrr_take_lifted(source, &found);
    roots->simple = general_rpprrr_keep_roots(0, cosine, sine, roots->c, roots->s, roots->simple,
                                       roots->c, roots->s, 0);
    roots->doubles = general_rpprrr_keep_roots(0, cosine, sine, roots->double_c, roots->double_s,
                                        roots->doubles, roots->double_c, roots->double_s, 0);
    roots->simple = general_rpprrr_keep_roots(1, cosine, sine, found.c, found.s, found.simple,
                                       roots->c, roots->s, roots->simple);
    roots->doubles = general_rpprrr_keep_roots(1, cosine, sine, found.double_c, found.double_s,
                                        found.doubles, roots->double_c, roots->double_s,
                                        roots->doubles);
    return 1;
}

/* Whether any root is near to an angle. */
static int general_rpprrr_any_near(const general_rpprrr_roots *roots, double cosine, double sine)
{
    int any = 0;
    for (int i = 0; i < roots->simple; i++) {
        any |= general_rpprrr_near(roots->c[i], roots->s[i], cosine, sine);
    }
    for (int i = 0; i < roots->doubles; i++) {
        any |= general_rpprrr_near(roots->double_c[i], roots->double_s[i], cosine, sine);
    }
    return any;
}

/* Where roots may be double they are replaced by what a closer look shows: values that are computed
 * there have the digits that the fit of f lacks, not those that the equations lack behind f. What
 * was given up stands among them. */
static void general_rpprrr_look_closer(const general_rpprrr_source *source, general_rpprrr_roots
    *roots)
{
    double c[4], s[4], empty_c[4], empty_s[4];
    int looks = 0, clear = 1, i = 0, empty = 0, emptied[4];
    if (roots->simple == GENERAL_RPPRRR_ROOTS || roots->doubles == GENERAL_RPPRRR_ROOTS) {
        return;
    }
    while (i < roots->doubles) {
        int seen = 0;
        for (int k = 0; k < looks; k++) {
            seen |= general_rpprrr_near(roots->double_c[i], roots->double_s[i], c[k], s[k]);
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
        emptied[looks] = general_rpprrr_magnify(source, c[looks], s[looks], roots);
        clear &= emptied[looks];
        emptied[looks] &= !general_rpprrr_any_near(roots, c[looks], s[looks]);
        looks++;
        i = 0;
    }
    for (int k = 0; k < looks; k++) {
        if (emptied[k]) {
            empty_c[empty] = c[k];
            empty_s[empty++] = s[k];
        }
    }
    empty = general_rpprrr_kept(source, empty, empty_c, empty_s);
    for (int k = 0; k < empty && roots->doubles + k < GENERAL_RPPRRR_ROOTS; k++) {
        roots->double_c[roots->doubles + k] = empty_c[k];
        roots->double_s[roots->doubles + k] = empty_s[k];
        roots->unseen++;
    }
    roots->complete = roots->complete || (clear && i == roots->doubles);
}

/* Whether samples are nothing but rounding of zero, which may be as smooth as a polynomial. */
static int general_rpprrr_is_nothing(const double samples[24])
{
    double most = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    return most <= 1e-26;
}

/* All real roots of a polynomial. Returns 0 where it vanishes identically. */
static int general_rpprrr_real_roots(const general_rpprrr_source *source, general_rpprrr_roots
    *roots)
{
    const general_rpprrr_window all = {0, 128, 5e-09};
    double samples[24];
    general_rpprrr_trigonometric f;
    general_rpprrr_lens lens = {0.0, 0.0};
    source->sample(source->of, &lens, samples);
    if (general_rpprrr_is_nothing(samples)) {
        return 0;
    }
    if (general_rpprrr_spread(samples, &lens)) {
        source->sample(source->of, &lens, samples);
    }
    general_rpprrr_fit(samples, &f);
    if (!(f.noise <= 1e-06)) {
        return 0;
    }
    general_rpprrr_find_roots(&f, &all, roots);
    general_rpprrr_behind(&lens, roots->simple, roots->c, roots->s);
    general_rpprrr_behind(&lens, roots->doubles, roots->double_c, roots->double_s);
    general_rpprrr_behind(&lens, roots->lifted, roots->lifted_c, roots->lifted_s);
    general_rpprrr_take_lifted(source, roots);
    general_rpprrr_look_closer(source, roots);
    /* where f nearly vanishes identically it does not tell what there is not */
    roots->complete &= f.noise <= 1e-10;
    return 1;
}

/* The loop's error at cosines and sines of the joints: translation and rotation vector that are
 * missing. J, when given, takes the rows of the Jacobian with the error as seventh column. Returns
 * the square of the error. */
static inline general_rpprrr_lane general_rpprrr_error(const general_rpprrr_loop *loop, const
    general_rpprrr_lane c[6],
                                         const general_rpprrr_lane s[6], general_rpprrr_lane
                                             J[6][7])
{
    static const double identity[12] = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    const double *const P = loop->link[5];
    general_rpprrr_rigid T;
    general_rpprrr_lane z[6][3], o[6][3], S[3][3], square = {0}, trace;
    general_rpprrr_begin(T, identity);
    GENERAL_RPPRRR_UNROLL
    for (int k = 0; k < 6; k++) {
        if (k) {
            general_rpprrr_follow(T, loop->link[k - 1]);
        }
        GENERAL_RPPRRR_UNROLL
        for (int i = 0; i < 3; i++) {
            z[k][i] = T[i][2];
            o[k][i] = T[i][3];
        }
        general_rpprrr_move(T, k, c[k], s[k]);
    }
    GENERAL_RPPRRR_UNROLL
    for (int i = 0; i < 3; i++) {
        GENERAL_RPPRRR_UNROLL
        for (int j = 0; j < 3; j++) {
            S[i][j] = P[4 * i] * T[j][0] + P[4 * i + 1] * T[j][1] + P[4 * i + 2] * T[j][2];
        }
        J[i][6] = P[4 * i + 3] - T[i][3];
    }
    J[3][6] = 0.5 * (S[2][1] - S[1][2]);
    J[4][6] = 0.5 * (S[0][2] - S[2][0]);
    J[5][6] = 0.5 * (S[1][0] - S[0][1]);
    GENERAL_RPPRRR_UNROLL
    for (int i = 0; i < 6; i++) {
        square += J[i][6] * J[i][6];
    }
    GENERAL_RPPRRR_UNROLL
    for (int k = 0; k < 6; k++) {
        GENERAL_RPPRRR_UNROLL
        for (int i = 0; i < 3; i++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            J[i][k] = z[k][i1] * (T[i2][3] - o[k][i2]) - z[k][i2] * (T[i1][3] - o[k][i1]);
            J[3 + i][k] = z[k][i];
        }
    }
    GENERAL_RPPRRR_UNROLL
    for (int i = 0; i < 3; i++) {
        J[i][1] = z[1][i];
        J[3 + i][1] = general_rpprrr_all(0.0);
        J[i][2] = z[2][i];
        J[3 + i][2] = general_rpprrr_all(0.0);
    }
    /* half a turn away the skew part vanishes too: the trace tells */
    trace = S[0][0] + S[1][1] + S[2][2];
    return general_rpprrr_select(trace < 0.0, square + 1.0, square);
}

/* A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
 * next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
 * largest. */
static inline general_rpprrr_lane general_rpprrr_step(general_rpprrr_lane J[6][7],
    general_rpprrr_lane x[6])
{
    general_rpprrr_lane *const row[6] = {J[0], J[1], J[2], J[3], J[4], J[5]};
    general_rpprrr_lane most, least;
    const general_rpprrr_lane zero = {0};
    general_rpprrr_reflect(row, 6, 0, 7);
    general_rpprrr_reflect(row + 1, 5, 1, 7);
    general_rpprrr_reflect(row + 2, 4, 2, 7);
    general_rpprrr_reflect(row + 3, 3, 3, 7);
    general_rpprrr_reflect(row + 4, 2, 4, 7);
    most = least = general_rpprrr_abs(J[0][0]);
    for (int i = 1; i < 6; i++) {
        most = general_rpprrr_max(most, general_rpprrr_abs(J[i][i]));
        least = general_rpprrr_min(least, general_rpprrr_abs(J[i][i]));
    }
    least /= most;
    most *= 1e-09;
    for (int i = 5; i >= 0; i--) {
        general_rpprrr_lane sum = J[i][6];
        for (int j = i + 1; j < 6; j++) {
            sum -= J[i][j] * x[j];
        }
        sum /= J[i][i];
        sum = general_rpprrr_max(general_rpprrr_min(sum, zero + 1.0), zero - 1.0);
        x[i] = general_rpprrr_select(general_rpprrr_abs(J[i][i]) > most, sum, zero);
    }
    return least;
}

/* The same damped, for starts far away and for singular solutions: (J' J + d) x = J' error. */
static inline void general_rpprrr_damped_step(general_rpprrr_lane J[6][7], general_rpprrr_lane
    damping, general_rpprrr_lane x[6])
{
    general_rpprrr_lane A[6][7];
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
        const general_rpprrr_lane pivot = 1.0 / (A[i][i] + 1e-30);
        for (int j = i + 1; j < 6; j++) {
            const general_rpprrr_lane factor = A[i][j] * pivot;
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
        x[i] = general_rpprrr_max(general_rpprrr_min(x[i], general_rpprrr_all(1.0)),
            general_rpprrr_all(-1.0));
    }
}

/* Newton on the loop; what remains in c and s is the best iterate, and its error is returned. */
static inline general_rpprrr_lane general_rpprrr_polish(const general_rpprrr_loop *loop,
    general_rpprrr_lane c[6], general_rpprrr_lane s[6],
                                          int steps, int afar)
{
    general_rpprrr_lane J[6][7], x[6], tc[6], ts[6], least, now;
    for (int i = 0; i < 6; i++) {
        tc[i] = c[i];
        ts[i] = s[i];
    }
    least = now = general_rpprrr_error(loop, c, s, J);
    for (int step = 0; step < steps; step++) {
        general_rpprrr_mask better;
        if (general_rpprrr_largest(least) < 1e-29) {
            break;
        }
        if (afar) {
            general_rpprrr_damped_step(J, general_rpprrr_min(now * 0.01, general_rpprrr_all(0.01)),
                x);
        } else {
            (void)general_rpprrr_step(J, x);
        }
        const general_rpprrr_lane length_1 = ts[1];
        const general_rpprrr_lane length_2 = ts[2];
        for (int i = 0; i < 6; i++) {
            /* a turn by 2 atan(x/2), without trigonometry */
            const general_rpprrr_lane u = 0.25 * x[i] * x[i], f = 1.0 / (1.0 + u);
            const general_rpprrr_lane dc = (1.0 - u) * f, ds = x[i] * f, old = tc[i];
            tc[i] = old * dc - ts[i] * ds;
            ts[i] = ts[i] * dc + old * ds;
        }
        ts[1] = length_1 + x[1];
        ts[2] = length_2 + x[2];
        now = general_rpprrr_error(loop, tc, ts, J);
        better = now < least;
        for (int i = 0; i < 6; i++) {
            c[i] = general_rpprrr_select(better, tc[i], c[i]);
            s[i] = general_rpprrr_select(better, ts[i], s[i]);
        }
        least = general_rpprrr_select(better, now, least);
    }
    return general_rpprrr_sqrt(least);
}

/* A bit for each solution. */
typedef unsigned long long general_rpprrr_set;

/* The solutions found so far. Where one is singular many candidates come near to it: there is room
 * for more than there are solutions, the last of it for regular ones. */
typedef struct {
    int count;
    general_rpprrr_set singular, nearly_singular; /* where the arm is */
    int doubles; /* roots that met, or may have */
    double q[64][6], residual[64];
} general_rpprrr_found;

/* Whether two joint vectors differ by less than that, modulo turns. */
static int general_rpprrr_alike(const double a[6], const double b[6], double most)
{
    for (int j = 0; j < 6; j++) {
        const double gap = fabs(a[j] - b[j]);
        if (general_rpprrr_slides(j) ? gap < most : gap < most || 6.283185307179586 - gap < most) {
            continue;
        }
        return 0;
    }
    return 1;
}

/* Add a solution unless it is known or none, and mark it where the arm is singular, or nearly; its
 * place, or -1. */
static int general_rpprrr_keep(general_rpprrr_found *found, double theta[6], double residual, double
    pivot)
{
    const int singular = pivot < 1e-06, nearly = pivot < 0.0001;
    const int room = nearly ? 64 - 8 : 64;
    if (!(residual <= 1e-10)) {
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (general_rpprrr_alike(found->q[i], theta, 1e-06)) {
            if (residual < found->residual[i]) {
                found->residual[i] = residual;
                for (int j = 0; j < 6; j++) {
                    found->q[i][j] = theta[j];
                }
            }
            found->singular |= (general_rpprrr_set)singular << i;
            found->nearly_singular |= (general_rpprrr_set)nearly << i;
            return i;
        }
    }
    if (found->count >= room) {
        return -1;
    }
    found->singular |= (general_rpprrr_set)singular << found->count;
    found->nearly_singular |= (general_rpprrr_set)nearly << found->count;
    found->residual[found->count] = residual;
    for (int j = 0; j < 6; j++) {
        found->q[found->count][j] = theta[j];
    }
    return found->count++;
}

/* Polish candidates, given by cosines and sines, and keep what they lead to: the solutions that
 * were met. `place` takes which solution each candidate became, or -1. With `doubtful` candidates
 * singular solutions are marked. */
static general_rpprrr_set general_rpprrr_offer(const general_rpprrr_loop *loop, general_rpprrr_lane
    c[6], general_rpprrr_lane s[6], int count,
                              int steps, int doubtful, general_rpprrr_found *found,
                              int place[GENERAL_RPPRRR_LANES])
{
    double residual[GENERAL_RPPRRR_LANES], theta[6][GENERAL_RPPRRR_LANES],
        pivot[GENERAL_RPPRRR_LANES];
    double length_1[GENERAL_RPPRRR_LANES];
    double length_2[GENERAL_RPPRRR_LANES];
    general_rpprrr_set met = 0;
    GENERAL_RPPRRR_STORE(residual, general_rpprrr_polish(loop, c, s, steps, steps > 4));
    if (doubtful) {
        general_rpprrr_lane J[6][7], x[6];
        (void)general_rpprrr_error(loop, c, s, J);
        GENERAL_RPPRRR_STORE(pivot, general_rpprrr_step(J, x));
    } else {
        GENERAL_RPPRRR_STORE(pivot, general_rpprrr_all(1.0));
    }
    for (int i = 0; i < 6; i++) {
        const double cosine = general_rpprrr_advance[0][i], sine = general_rpprrr_advance[1][i];
        GENERAL_RPPRRR_STORE(theta[i],
                      general_rpprrr_angle(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] *
                          sine));
    }
    GENERAL_RPPRRR_STORE(length_1, s[1]);
    GENERAL_RPPRRR_STORE(length_2, s[2]);
    for (int k = 0; k < count; k++) {
        double row[6];
        for (int i = 0; i < 6; i++) {
            /* half a turn is +pi, also when rounding says otherwise */
            row[i] = theta[i][k] < -3.141592653589783 ? 3.141592653589793 : theta[i][k];
        }
        row[1] = length_1[k];
        row[2] = length_2[k];
        place[k] = general_rpprrr_keep(found, row, residual[k], pivot[k]);
        if (place[k] >= 0) {
            met |= (general_rpprrr_set)1 << place[k];
        }
    }
    return met;
}

static int general_rpprrr_bits(general_rpprrr_set set)
{
    int count = 0;
    for (; set; set &= set - 1) {
        count++;
    }
    return count;
}

/* Whether the number of regular solutions is even. */
static int general_rpprrr_paired(const general_rpprrr_found *found)
{
    return (found->count - general_rpprrr_bits(found->singular)) % 2 == 0;
}

/* The links L0 ... L5 of a formulation. */
static void general_rpprrr_around(const general_rpprrr_formulation *form, const general_rpprrr_loop
    *loop,
                           double link[6][12])
{
    for (int i = 0; i < 6; i++) {
        const int joint = form->joint[i];
        if (form->sign > 0.0 && joint < 5) {
            general_rpprrr_copy(loop->link[joint], link[i]);
        } else if (form->sign > 0.0) {
            general_rpprrr_invert(loop->link[5], link[i]);
        } else if (joint > 0) {
            general_rpprrr_invert(loop->link[joint - 1], link[i]);
        } else {
            general_rpprrr_copy(loop->link[5], link[i]);
        }
    }
}

/* Ways to solve at roots of the hidden angle, by its cosine and sine: two signs that choose among
 * square roots; `group` is the number of the root, and `far` how many more ways it has that lead to
 * infinity. */
typedef struct {
    int count, group[GENERAL_RPPRRR_CANDIDATES], far[2 * GENERAL_RPPRRR_ROOTS];
    double c[GENERAL_RPPRRR_CANDIDATES], s[GENERAL_RPPRRR_CANDIDATES],
        sign[2][GENERAL_RPPRRR_CANDIDATES];
    int aligned; /* whether a root does not tell all turns */
} general_rpprrr_ways;

/* Four turns and two slides: J(phi1) L0 J(phi2) L1 ... J(phi6) L5 = 1 with phi1 a turn. Slides
 * leave directions alone, Rz(phi1) A Rz Rz B Rz C Rz D = 1 for the rotations between the turns:
 * with phi1 given, Rz N Rz = M = A' Rz(-phi1) D', N = B Rz C. Both have the same entry zz, which
 * gives the middle turn, a square root; what turns N's third column and row to those of M are the
 * others. The translation is linear in the slides' lengths: the determinant of it and of their
 * directions is zero. Numbers x + y sqrt(delta), with delta the discriminant, are pairs of x and
 * y. */
typedef struct {
    const general_rpprrr_formulation *form;
    double link[6][12];
    double between[4][12]; /* A, B, C, D; what is no rotation means nothing */
} general_rpprrr_setting;

typedef general_rpprrr_lane general_rpprrr_pair[2];

/* What the hidden turn fixes: delta, what the polynomial is multiplied by, cosines and sines of the
 * other turns, the directions of the slides, the translation and their determinant. */
typedef struct {
    general_rpprrr_lane delta, w;
    general_rpprrr_pair c[3], s[3], direction[2][3], translation[3], determinant;
} general_rpprrr_both;

static void general_rpprrr_prepare(general_rpprrr_setting *set, int which, const general_rpprrr_loop
    *loop)
{
    int number = -1;
    set->form = &general_rpprrr_formulations[which];
    general_rpprrr_around(set->form, loop, set->link);
    for (int i = 0; i < 6; i++) {
        if (general_rpprrr_slides(set->form->joint[i])) {
            general_rpprrr_then(set->between[number], set->link[i]);
        } else {
            general_rpprrr_copy(set->link[i], set->between[++number]);
        }
    }
}

/* Whether every solution has a root. Where the third turn's axis is parallel to the one before or
 * behind it, the entry zz does not give this turn, and roots tell nothing. */
static int general_rpprrr_tells_all(const general_rpprrr_setting *set)
{
    const double *const B = set->between[1], *const C = set->between[2];
    return (B[8] * B[8] + B[9] * B[9]) * (C[2] * C[2] + C[6] * C[6]) > 1e-18;
}

/* out += sign a b */
static inline void general_rpprrr_add_product(const general_rpprrr_pair a, const general_rpprrr_pair
    b, general_rpprrr_lane delta, double sign,
                                       general_rpprrr_pair out)
{
    out[0] += sign * (a[0] * b[0] + delta * a[1] * b[1]);
    out[1] += sign * (a[0] * b[1] + a[1] * b[0]);
}

/* The first two entries of R v; R's entries lie `row` apart from row to row, and `entry` in a
 * row. */
static inline void general_rpprrr_rotated(const double *R, int row, int entry, general_rpprrr_pair
    v[3], general_rpprrr_pair out[2])
{
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            const double *const r = R + row * i;
            out[i][k] = r[0] * v[0][k] + r[entry] * v[1][k] + r[2 * entry] * v[2][k];
        }
    }
}

/* Cosine and sine of the turn that takes the plane vector v to (x, y), both as long as sqrt(w). */
static inline void general_rpprrr_turn_between(general_rpprrr_pair v[2], general_rpprrr_lane x,
    general_rpprrr_lane y, general_rpprrr_lane w,
                                        general_rpprrr_pair c, general_rpprrr_pair s)
{
    for (int k = 0; k < 2; k++) {
        c[k] = (x * v[0][k] + y * v[1][k]) / w;
        s[k] = (y * v[0][k] - x * v[1][k]) / w;
    }
}

/* The other turns. */
static inline void general_rpprrr_linkage(const general_rpprrr_setting *set, general_rpprrr_lane c,
    general_rpprrr_lane s, general_rpprrr_both *out)
{
    const double *const A = set->between[0], *const B = set->between[1], *const C = set->between[2];
    const double *const D = set->between[3];
    const double b = B[8] * C[2] + B[9] * C[6], a = B[9] * C[2] - B[8] * C[6];
    const double q = a * a + b * b + 1e-300;
    general_rpprrr_lane M[3][3], k;
    general_rpprrr_pair v[3], turned[2];
    for (int j = 0; j < 3; j++) {
        const general_rpprrr_lane x = c * D[4 * j] + s * D[4 * j + 1], y = c * D[4 * j + 1] - s *
            D[4 * j];
        for (int i = 0; i < 3; i++) {
            M[i][j] = A[i] * x + A[4 + i] * y + A[8 + i] * D[4 * j + 2];
        }
    }
    k = M[2][2] - B[10] * C[10];
    out->delta = a * a + b * b - k * k;
    out->w = M[0][2] * M[0][2] + M[1][2] * M[1][2] + 1e-300;
    out->c[1][0] = b * k / q;
    out->c[1][1] = general_rpprrr_all(-a / q);
    out->s[1][0] = a * k / q;
    out->s[1][1] = general_rpprrr_all(b / q);
    v[2][1] = general_rpprrr_all(0.0);
    for (int i = 0; i < 2; i++) { /* the third column of B Rz C */
        v[0][i] = C[2] * out->c[1][i] - C[6] * out->s[1][i];
        v[1][i] = C[2] * out->s[1][i] + C[6] * out->c[1][i];
    }
    v[2][0] = general_rpprrr_all(C[10]);
    general_rpprrr_rotated(B, 4, 1, v, turned);
    general_rpprrr_turn_between(turned, M[0][2], M[1][2], out->w, out->c[0], out->s[0]);
    for (int i = 0; i < 2; i++) { /* its third row */
        v[0][i] = B[8] * out->c[1][i] + B[9] * out->s[1][i];
        v[1][i] = B[9] * out->c[1][i] - B[8] * out->s[1][i];
    }
    v[2][0] = general_rpprrr_all(B[10]);
    general_rpprrr_rotated(C, 1, 4, v, turned);
    general_rpprrr_turn_between(turned, M[2][0], M[2][1], out->w, out->c[2], out->s[2]);
    for (int i = 0; i < 2; i++) {
        out->s[2][i] = -out->s[2][i];
    }
}

/* T Rz for the turn with this cosine and sine */
static inline void general_rpprrr_turn_pair(general_rpprrr_rigid T[2], const general_rpprrr_pair c,
    const general_rpprrr_pair s, general_rpprrr_lane delta)
{
    for (int i = 0; i < 3; i++) {
        const general_rpprrr_pair x = {T[0][i][0], T[1][i][0]}, y = {T[0][i][1], T[1][i][1]};
        general_rpprrr_pair first = {x[0] * 0.0, x[0] * 0.0}, second = {x[0] * 0.0, x[0] * 0.0};
        general_rpprrr_add_product(x, c, delta, 1.0, first);
        general_rpprrr_add_product(y, s, delta, 1.0, first);
        general_rpprrr_add_product(y, c, delta, 1.0, second);
        general_rpprrr_add_product(x, s, delta, -1.0, second);
        for (int k = 0; k < 2; k++) {
            T[k][i][0] = first[k];
            T[k][i][1] = second[k];
        }
    }
}

/* Once around the loop. */
static inline void general_rpprrr_around_once(const general_rpprrr_setting *set, general_rpprrr_lane
    c, general_rpprrr_lane s, general_rpprrr_both *out)
{
    static const double identity[12] = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    static const double zero[12] = {0.0};
    general_rpprrr_rigid T[2];
    int angle = 0, slide = 0;
    general_rpprrr_linkage(set, c, s, out);
    general_rpprrr_begin(T[0], identity);
    general_rpprrr_begin(T[1], zero);
    general_rpprrr_turn(T[0], c, s);
    general_rpprrr_follow(T[0], set->link[0]);
    for (int i = 1; i < 6; i++) {
        if (general_rpprrr_slides(set->form->joint[i])) {
            for (int j = 0; j < 3; j++) {
                out->direction[slide][j][0] = T[0][j][2];
                out->direction[slide][j][1] = T[1][j][2];
            }
            slide++;
        } else {
            general_rpprrr_turn_pair(T, out->c[angle], out->s[angle], out->delta);
            angle++;
        }
        general_rpprrr_follow(T[0], set->link[i]);
        general_rpprrr_follow(T[1], set->link[i]);
    }
    out->determinant[0] = out->determinant[1] = general_rpprrr_all(0.0);
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        general_rpprrr_pair normal = { general_rpprrr_all(0.0), general_rpprrr_all(0.0)};
        out->translation[i][0] = T[0][i][3];
        out->translation[i][1] = T[1][i][3];
        general_rpprrr_add_product(out->direction[0][i1], out->direction[1][i2], out->delta, 1.0,
            normal);
        general_rpprrr_add_product(out->direction[0][i2], out->direction[1][i1], out->delta, -1.0,
            normal);
        general_rpprrr_add_product(normal, out->translation[i], out->delta, 1.0, out->determinant);
    }
}

/* The polynomial of the hidden turn, of degree 4: the product over both branches. */
static inline general_rpprrr_lane general_rpprrr_closed_polynomial(const general_rpprrr_setting
    *set, general_rpprrr_lane c, general_rpprrr_lane s)
{
    general_rpprrr_both at;
    general_rpprrr_around_once(set, c, s, &at);
    return at.w * (at.determinant[0] * at.determinant[0] - at.determinant[1] * at.determinant[1] *
        at.delta);
}

static inline general_rpprrr_lane general_rpprrr_root(general_rpprrr_lane delta)
{
    return general_rpprrr_sqrt(general_rpprrr_max(delta, general_rpprrr_all(0.0)));
}

/* The larger components of a x b, on one of the branches, in magnitude. */
static inline double general_rpprrr_across(general_rpprrr_pair a[3], general_rpprrr_pair b[3],
    double root, int lane)
{
    double most = 0.0, u[3], v[3];
    for (int i = 0; i < 3; i++) {
        double each[4][GENERAL_RPPRRR_LANES];
        GENERAL_RPPRRR_STORE(each[0], a[i][0]);
        GENERAL_RPPRRR_STORE(each[1], a[i][1]);
        GENERAL_RPPRRR_STORE(each[2], b[i][0]);
        GENERAL_RPPRRR_STORE(each[3], b[i][1]);
        u[i] = each[0][lane] + root * each[1][lane];
        v[i] = each[2][lane] + root * each[3][lane];
    }
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        const double x = fabs(u[i1] * v[i2] - u[i2] * v[i1]);
        most = x > most ? x : most;
    }
    return most;
}

/* At every root the better branch, and the other one where its determinant is small, too: a double
 * root may be one of each. Where the slides are parallel and the translation is not along them,
 * they would have to reach too far. Where the second and the fourth turn are parallel the root does
 * not tell them. */
static void general_rpprrr_find_ways(const general_rpprrr_setting *set, const double *c, const
    double *s, int count, int group,
                              general_rpprrr_ways *out)
{
    for (int from = 0; from < count; from += GENERAL_RPPRRR_LANES) {
        double in[2][GENERAL_RPPRRR_LANES], U[GENERAL_RPPRRR_LANES], V[GENERAL_RPPRRR_LANES],
            root[GENERAL_RPPRRR_LANES], w[GENERAL_RPPRRR_LANES];
        general_rpprrr_both at;
        for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
            const int i = from + k < count ? from + k : from;
            in[0][k] = c[i];
            in[1][k] = s[i];
        }
        general_rpprrr_around_once(set, GENERAL_RPPRRR_LOAD(in[0]), GENERAL_RPPRRR_LOAD(in[1]),
            &at);
        GENERAL_RPPRRR_STORE(U, at.determinant[0]);
        GENERAL_RPPRRR_STORE(V, at.determinant[1] * general_rpprrr_root(at.delta));
        GENERAL_RPPRRR_STORE(root, general_rpprrr_root(at.delta));
        GENERAL_RPPRRR_STORE(w, at.w);
        for (int k = 0; k < GENERAL_RPPRRR_LANES && from + k < count; k++) {
            out->aligned |= w[k] <= 1e-06;
            const double better = (U[k] < 0.0) == (V[k] < 0.0) ? -1.0 : 1.0;
            const double moved = sqrt(1e-14 / (fabs(U[k]) + fabs(V[k]) + 1e-300));
            const int ways = fabs(U[k] - better * V[k]) < 0.01 ? 2 : 1;
            for (int way = 0; way < ways && out->count < GENERAL_RPPRRR_CANDIDATES; way++) {
                const double x = (way ? -better : better) * root[k];
                const double across = general_rpprrr_across(at.direction[0], at.translation, x, k);
                if (across > 1e-06 && across > moved &&
                    across > 10000.0 * general_rpprrr_across(at.direction[0], at.direction[1], x,
                        k)) {
                    out->far[group + from + k]++;
                    continue;
                }
                out->group[out->count] = group + from + k;
                out->c[out->count] = in[0][k];
                out->s[out->count] = in[1][k];
                out->sign[0][out->count] = way ? -better : better;
                out->sign[1][out->count] = 1.0;
                out->count++;
            }
        }
    }
}

/* The cosines and sines of all turns and the lengths of the slides, on the branch with this
 * sign. */
static inline void general_rpprrr_way_joints(const general_rpprrr_setting *set, general_rpprrr_lane
    c1, general_rpprrr_lane s1, general_rpprrr_lane sign,
                                      general_rpprrr_lane unused, general_rpprrr_lane c[6],
                                          general_rpprrr_lane s[6])
{
    general_rpprrr_both at;
    general_rpprrr_lane root, u[3], v[3], p[3], square = general_rpprrr_all(1e-30), length[2];
    int angle = 0, slide = 0;
    (void)unused;
    general_rpprrr_around_once(set, c1, s1, &at);
    root = sign * general_rpprrr_root(at.delta);
    for (int i = 0; i < 3; i++) {
        u[i] = at.direction[0][i][0] + root * at.direction[0][i][1];
        v[i] = at.direction[1][i][0] + root * at.direction[1][i][1];
        p[i] = at.translation[i][0] + root * at.translation[i][1];
    }
    /* p + d u + e v = 0 times v and u; their scalar products would lose digits of the sine */
    length[0] = length[1] = general_rpprrr_all(0.0);
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        const general_rpprrr_lane normal = u[i1] * v[i2] - u[i2] * v[i1];
        square += normal * normal;
        length[0] += normal * (v[i1] * p[i2] - v[i2] * p[i1]);
        length[1] += normal * (p[i1] * u[i2] - p[i2] * u[i1]);
    }
    square = 1.0 / square;
    c[set->form->joint[0]] = c1;
    s[set->form->joint[0]] = s1;
    for (int i = 1; i < 6; i++) {
        const int joint = set->form->joint[i];
        if (general_rpprrr_slides(joint)) {
            c[joint] = general_rpprrr_all(1.0);
            s[joint] = square * length[slide++];
        } else {
            c[joint] = at.c[angle][0] + root * at.c[angle][1];
            s[joint] = at.s[angle][0] + root * at.s[angle][1];
            general_rpprrr_to_unit(&c[joint], &s[joint]);
            angle++;
        }
    }
}

/* Polish the ways; the certificate is that of the formulations, with 1 solution(s) a root. */
static int general_rpprrr_settle_ways(const general_rpprrr_loop *loop, const general_rpprrr_setting
    *set, const general_rpprrr_ways *ways,
                               int simple, int doubles, general_rpprrr_found *found)
{
    general_rpprrr_set met = 0, of_group[2 * GENERAL_RPPRRR_ROOTS] = {0};
    int complete = 1, expected = 0;
    for (int from = 0; from < ways->count; from += GENERAL_RPPRRR_LANES) {
        const int count = ways->count - from < GENERAL_RPPRRR_LANES ? ways->count - from :
            GENERAL_RPPRRR_LANES;
        double in[4][GENERAL_RPPRRR_LANES];
        general_rpprrr_lane c[6], s[6];
        int place[GENERAL_RPPRRR_LANES];
        for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
            const int i = k < count ? from + k : from;
            in[0][k] = ways->c[i];
            in[1][k] = ways->s[i];
            in[2][k] = ways->sign[0][i];
            in[3][k] = ways->sign[1][i];
        }
        general_rpprrr_way_joints(set, GENERAL_RPPRRR_LOAD(in[0]), GENERAL_RPPRRR_LOAD(in[1]),
            GENERAL_RPPRRR_LOAD(in[2]), GENERAL_RPPRRR_LOAD(in[3]), c, s);
        met |= general_rpprrr_offer(loop, c, s, count, 4, doubles > 0, found, place);
        for (int k = 0; k < count; k++) {
            if (place[k] >= 0) {
                of_group[ways->group[from + k]] |= (general_rpprrr_set)1 << place[k];
            }
        }
    }
    for (int i = 0; i < simple + doubles; i++) {
        if (ways->far[i] && !of_group[i]) {
            continue;
        }
        complete &= general_rpprrr_bits(of_group[i]) >= 1;
        expected += i < simple || of_group[i] & found->singular ? 1 : 2;
        expected -= ways->far[i];
    }
    return complete && general_rpprrr_bits(met) >= expected && general_rpprrr_paired(found);
}

/* The polynomial at the sample angles, through a lens. */
static void general_rpprrr_sample_closed(const void *setting, const general_rpprrr_lens *lens,
    double samples[24])
{
    for (int k = 0; k < 24; k += GENERAL_RPPRRR_LANES) {
        general_rpprrr_lane c = GENERAL_RPPRRR_LOAD(general_rpprrr_sample_c + k), s =
            GENERAL_RPPRRR_LOAD(general_rpprrr_sample_s + k);
        const general_rpprrr_lane square = general_rpprrr_through(lens, &c, &s);
        GENERAL_RPPRRR_STORE(samples + k,
            general_rpprrr_weighted(general_rpprrr_closed_polynomial(setting, c, s), square));
    }
}

/* Find what a polynomial in closed form finds; whether that is certainly everything. */
static int general_rpprrr_attempt_closed(int which, const general_rpprrr_loop *loop,
    general_rpprrr_found *found)
{
    general_rpprrr_setting set;
    const general_rpprrr_source source = { general_rpprrr_sample_closed, 0, &set};
    general_rpprrr_roots roots;
    general_rpprrr_ways ways;
    general_rpprrr_prepare(&set, which, loop);
    if (!general_rpprrr_real_roots(&source, &roots)) {
        return 0;
    }
    ways.count = 0;
    ways.aligned = 0;
    for (int i = 0; i < 2 * GENERAL_RPPRRR_ROOTS; i++) {
        ways.far[i] = 0;
    }
    general_rpprrr_find_ways(&set, roots.c, roots.s, roots.simple, 0, &ways);
    general_rpprrr_find_ways(&set, roots.double_c, roots.double_s, roots.doubles, roots.simple,
        &ways);
    found->doubles += roots.doubles;
    return general_rpprrr_settle_ways(loop, &set, &ways, roots.simple, roots.doubles, found) &&
        roots.complete &&
           general_rpprrr_tells_all(&set) && !ways.aligned;
}

/* Find what the methods find, one after the other, until that is certainly everything. */
static int general_rpprrr_try(const general_rpprrr_loop *loop, general_rpprrr_found *found)
{
    int complete = 0;
    for (int i = 0; i < 2 && !complete; i++) {
        complete = general_rpprrr_attempt_closed(i, loop, found);
    }
    return complete;
}

/* Newton from joint angles (count, 6) far from or near to solutions. */
static general_rpprrr_set general_rpprrr_follow_back(const general_rpprrr_loop *loop, double
    (*start)[6], int count,
                                    general_rpprrr_found *found, int *lost)
{
    general_rpprrr_set met = 0;
    for (int from = 0; from < count; from += GENERAL_RPPRRR_LANES) {
        const int now = count - from < GENERAL_RPPRRR_LANES ? count - from : GENERAL_RPPRRR_LANES;
        double cs[2][6][GENERAL_RPPRRR_LANES];
        general_rpprrr_lane c[6], s[6];
        int place[GENERAL_RPPRRR_LANES];
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < GENERAL_RPPRRR_LANES; k++) {
                const double angle = start[from + (k < now ? k : 0)][i];
                const double cosine = cos(angle), sine = general_rpprrr_slides(i) ? angle :
                    sin(angle);
                cs[0][i][k] = cosine * general_rpprrr_advance[0][i] + sine *
                    general_rpprrr_advance[1][i];
                cs[1][i][k] = sine * general_rpprrr_advance[0][i] - cosine *
                    general_rpprrr_advance[1][i];
            }
            c[i] = GENERAL_RPPRRR_LOAD(cs[0][i]);
            s[i] = GENERAL_RPPRRR_LOAD(cs[1][i]);
        }
        met |= general_rpprrr_offer(loop, c, s, now, 40, 1, found, place);
        for (int k = 0; k < now; k++) {
            *lost += place[k] < 0;
        }
    }
    return met;
}

/* Solve poses close by, and follow their solutions back. Where two solutions meet they are on one
 * side only: both sides have to have as many as are found. Around a singular pose none of them has
 * to have all solutions: then all are looked at. */
static int general_rpprrr_from_nearby(const general_rpprrr_loop *loop, general_rpprrr_found *found)
{
    int followed = 0, before = -1;
    for (int n = 0; n < 10; n++) {
        general_rpprrr_loop nearby = *loop;
        general_rpprrr_found other;
        int complete, count = -1, lost = 0;
        general_rpprrr_set met;
        general_rpprrr_then(nearby.link[5], general_rpprrr_nudge[n]);
        other.count = 0;
        other.singular = other.nearly_singular = 0;
        other.doubles = 0;
        complete = general_rpprrr_try(&nearby, &other);
        met = general_rpprrr_follow_back(loop, other.q, other.count, found, &lost);
        if (complete && !lost && met) {
            count = general_rpprrr_bits(met) == other.count ? other.count : -1;
            followed |= (met & found->singular) != 0;
        }
        if (n % 2 && before == found->count && count == found->count && !found->singular &&
            general_rpprrr_paired(found)) {
            return 1;
        }
        before = count;
    }
    return followed && general_rpprrr_paired(found);
}

/* Newton from many starts, the same on every run. */
static void general_rpprrr_from_anywhere(const general_rpprrr_loop *loop, general_rpprrr_found
    *found)
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
        (void)general_rpprrr_follow_back(loop, start, 8, found, &lost);
    }
}

/* What comes first where there are more than there are rows: 0 for regular solutions, 1 for
 * singular ones or nearly so, 2 for those that lie together with one of these and may be the same,
 * which only its last digits tell. */
static void general_rpprrr_rank(const general_rpprrr_found *found, int rank[64])
{
    for (int i = 0; i < found->count; i++) {
        rank[i] = (int)(found->nearly_singular >> i & 1);
        for (int j = 0; j < i && rank[i] == 1; j++) {
            if (rank[j] == 1 && general_rpprrr_alike(found->q[i], found->q[j], 0.001)) {
                rank[i] = 2;
            }
        }
    }
}

/* Whether solution i comes before solution j: by rank, then by the first angle, angles that agree
 * to rounding by the next. */
static int general_rpprrr_before(const general_rpprrr_found *found, const int *rank, int i, int j)
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

/* All solutions of a rigid T = C0 J(q1) C1 ... J(q6) C6, at most 8.
 *
 * T: row by row. q: the angles, in (-pi, pi], or length, rows in the order of q1, rows whose q1
 * agree to 1e-09 in the order of q2, and so on, singular ones and nearly singular ones last.
 * residual: by how much the loop stays open, in radians and arm sizes. Returns how many; -1 - count
 * when it is not certain that these are all: for want of a certificate of its own (where every
 * polynomial vanishes identically there may be a continuum, which poses close by do not have), or
 * because roots met or the arm is singular at a solution, or nearly, so that steps did not make it
 * exact. */
static int general_rpprrr_general(const double T[16], double q[8][6],
                         double residual[8])
{
    general_rpprrr_found found;
    general_rpprrr_loop whole;
    const general_rpprrr_loop *const loop = &whole;
    int rank[64], order[64], certified, inexact = 0;
    general_rpprrr_close(T, &whole);
    found.count = 0;
    found.singular = found.nearly_singular = 0;
    found.doubles = 0;
    certified = general_rpprrr_try(loop, &found);
    if (!certified && !general_rpprrr_from_nearby(loop, &found)) {
        general_rpprrr_from_anywhere(loop, &found);
    }
    general_rpprrr_rank(&found, rank);
    for (int i = 0; i < found.count; i++) {
        int j = i;
        for (; j > 0 && general_rpprrr_before(&found, rank, i, order[j - 1]); j--) {
            order[j] = order[j - 1];
        }
        order[j] = i;
    }
    if (found.count > 8) {
        certified = 0;
        found.count = 8;
    }
    for (int i = 0; i < found.count; i++) {
        for (int j = 0; j < 6; j++) {
            q[i][j] = found.q[order[i]][j];
        }
        q[i][1] *= 0.32546573682169855;
        q[i][2] *= 0.32546573682169855;
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
    const double T[16], const double seed[6], double q[8][6],
    int found[8], int chosen[8])
{
    static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
    static const double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    struct descent d = { .T = T };
    struct kept kept = { .count = 0 };
    double angles[8][6], residual[8], u[6];
    const int count = general_rpprrr_general(T, angles, residual);
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
    d1 = 0.5, /* joint offset 1 [m] */
    a1 = 0.1, /* link length 1 [m] */
    ca1 = 0.30901699437494745, /* cosine of twist 1 */
    sa1 = 0.9510565162951535, /* sine of twist 1 */
    cat2 = 0.9800665778412416, /* cosine of the angle of joint 2 */
    sat2 = 0.19866933079506122, /* sine of the angle of joint 2 */
    ca2 = 0.3420201433256688, /* cosine of twist 2 */
    sa2 = 0.9396926207859083, /* sine of twist 2 */
    cat3 = 0.8775825618903728, /* cosine of the angle of joint 3 */
    sat3 = 0.479425538604203, /* sine of the angle of joint 3 */
    a3 = 0.12, /* link length 3 [m] */
    ca3 = 0.766044443118978, /* cosine of twist 3 */
    sa3 = 0.6427876096865393, /* sine of twist 3 */
    d4 = 0.14, /* joint offset 4 [m] */
    a4 = 0.2, /* link length 4 [m] */
    ca4 = 0.42261826174069944, /* cosine of twist 4 */
    sa4 = 0.9063077870366499, /* sine of twist 4 */
    d5 = 0.1, /* joint offset 5 [m] */
    a5 = 0.16, /* link length 5 [m] */
    ca5 = 0.6427876096865394, /* cosine of twist 5 */
    sa5 = 0.766044443118978, /* sine of twist 5 */
    d6 = 0.12, /* joint offset 6 [m] */
    f1 = -0.7701962384697986, /* ca2 * ca1 - sa2 * cat2 * sa1 */
    f2 = -0.12623975606886617, /* cat3 * sat2 * sa1 - sat3 * (ca2 * cat2 * sa1 + sa2 * ca1) */
    f3 = -0.015148770728263941, /* a3 * f2 [m] */
    /* ca3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) - sa3 * f1 */
    f4 = 0.9739951538781595,
    /* d4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1) [m] */
    f5 = -0.02633971333380174,
    /* sa4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1) */
    f6 = -0.17051348073383996,
    /* ca4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1) */
    f7 = -0.0795117418848544,
    /* sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1 */
    g5 = -0.18814080952715528;

const char *const general_rpprrr_branches[8] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8",
};

static const double lowest[6] = { -INFINITY, -0.8, 0.0, -INFINITY, -INFINITY, -INFINITY };
static const double highest[6] = { INFINITY, 0.8, 0.9, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 0, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 0.4822530864197531, 0.4822530864197531, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 1.44e-09) /* of limits */

void general_rpprrr_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1, x2_x = c1 * cat2 - v1 * sat2, x2_y = s1 * cat2 + y1_y * sat2,
        v3 = c1 * sat2 + v1 * cat2, v4 = y1_y * cat2 - s1 * sat2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, z2_x = v3 * sa2 + z1_x * ca2, v5 = v4 * sa2 + v2 * ca2,
        x3_x = x2_x * cat3 - y2_x * sat3, x3_y = x2_y * cat3 - y2_y * sat3,
        v6 = x2_x * sat3 + y2_x * cat3, v7 = x2_y * sat3 + y2_y * cat3,
        y3_x = v6 * ca3 - z2_x * sa3, y3_y = v7 * ca3 + v5 * sa3, z3_x = v6 * sa3 + z2_x * ca3,
        z3_y = v7 * sa3 - v5 * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = f2 * c4 + f4 * s4, v8 = y3_x * c4 - x3_x * s4,
        v9 = y3_y * c4 - x3_y * s4, v10 = f4 * c4 - f2 * s4, y4_x = v8 * ca4 + z3_x * sa4,
        y4_y = v9 * ca4 + z3_y * sa4, y4_z = v10 * ca4 + f6, z4_x = z3_x * ca4 - v8 * sa4,
        z4_y = z3_y * ca4 - v9 * sa4, z4_z = f7 - v10 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v11 = y4_x * c5 - x4_x * s5,
        v12 = y4_y * c5 - x4_y * s5, v13 = y4_z * c5 - x4_z * s5, y5_x = v11 * ca5 - z4_x * sa5,
        y5_y = v12 * ca5 - z4_y * sa5, y5_z = v13 * ca5 - z4_z * sa5, z5_x = v11 * sa5 + z4_x * ca5,
        z5_y = v12 * sa5 + z4_y * ca5, z5_z = v13 * sa5 + z4_z * ca5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = y5_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + z1_x * q[1] + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + x5_x * a5 +
        z4_x * d5 + z5_x * d6;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = y5_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 - v2 * q[1] - v5 * q[2] + x3_y * a3 + x4_y * a4 + z3_y * d4 + x5_y * a5 + z4_y *
        d5 + z5_y * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + ca1 * q[1] + f1 * q[2] + f3 + x4_z * a4 + f5 + x5_z * a5 + z4_z * d5 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void general_rpprrr_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1, x2_x = c1 * cat2 - v1 * sat2, x2_y = s1 * cat2 + y1_y * sat2,
        v3 = c1 * sat2 + v1 * cat2, v4 = y1_y * cat2 - s1 * sat2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, z2_x = v3 * sa2 + z1_x * ca2, v5 = v4 * sa2 + v2 * ca2,
        x3_x = x2_x * cat3 - y2_x * sat3, x3_y = x2_y * cat3 - y2_y * sat3,
        v6 = x2_x * sat3 + y2_x * cat3, v7 = x2_y * sat3 + y2_y * cat3,
        p3_x = c1 * a1 + z1_x * q[1] + z2_x * q[2] + x3_x * a3,
        p3_y = s1 * a1 - v2 * q[1] - v5 * q[2] + x3_y * a3, p3_z = d1 + ca1 * q[1] + f1 * q[2] + f3,
        y3_x = v6 * ca3 - z2_x * sa3, y3_y = v7 * ca3 + v5 * sa3, z3_x = v6 * sa3 + z2_x * ca3,
        z3_y = v7 * sa3 - v5 * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = f2 * c4 + f4 * s4, v8 = y3_x * c4 - x3_x * s4,
        v9 = y3_y * c4 - x3_y * s4, v10 = f4 * c4 - f2 * s4, p4_x = p3_x + x4_x * a4 + z3_x * d4,
        p4_y = p3_y + x4_y * a4 + z3_y * d4, p4_z = p3_z + x4_z * a4 + f5,
        y4_x = v8 * ca4 + z3_x * sa4, y4_y = v9 * ca4 + z3_y * sa4, y4_z = v10 * ca4 + f6,
        z4_x = z3_x * ca4 - v8 * sa4, z4_y = z3_y * ca4 - v9 * sa4, z4_z = f7 - v10 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]),
        p5_x = p4_x + (x4_x * c5 + y4_x * s5) * a5 + z4_x * d5,
        p5_y = p4_y + (x4_y * c5 + y4_y * s5) * a5 + z4_y * d5,
        p5_z = p4_z + (x4_z * c5 + y4_z * s5) * a5 + z4_z * d5,
        z5_x = (y4_x * c5 - x4_x * s5) * sa5 + z4_x * ca5,
        z5_y = (y4_y * c5 - x4_y * s5) * sa5 + z4_y * ca5,
        z5_z = (y4_z * c5 - x4_z * s5) * sa5 + z4_z * ca5, p6_x = p5_x + z5_x * d6,
        p6_y = p5_y + z5_y * d6, p6_z = p5_z + z5_z * d6, v11 = p6_x - p3_x, v12 = p6_y - p3_y,
        v13 = p6_z - p3_z, v14 = p6_x - p4_x, v15 = p6_y - p4_y, v16 = p6_z - p4_z,
        v17 = p6_x - p5_x, v18 = p6_y - p5_y, v19 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = z1_x; J[2] = z2_x; J[3] = z3_y * v13 - g5 * v12;
    J[4] = z4_y * v16 - z4_z * v15; J[5] = z5_y * v19 - z5_z * v18;
    J[6] = p6_x; J[7] = -v2; J[8] = -v5; J[9] = g5 * v11 - z3_x * v13;
    J[10] = z4_z * v14 - z4_x * v16; J[11] = z5_z * v17 - z5_x * v19;
    J[12] = 0.0; J[13] = ca1; J[14] = f1; J[15] = z3_x * v12 - z3_y * v11;
    J[16] = z4_x * v15 - z4_y * v14; J[17] = z5_x * v18 - z5_y * v17;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = g5; J[34] = z4_z; J[35] = z5_z;
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
    const double T[16], const double seed[6], double q[8][6], unsigned char status[8])
{

    /* all joints: the general 4R2P loop */
    double solution_roots[8][6];
    int solution_found[8], solution_chosen[8];
    all_joints(T, seed, solution_roots, solution_found, solution_chosen);

    for (int i1 = 0; i1 < 8; i1++) { /* root1 to root8 */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const double q5 = solution_roots[i1][4];
        const double q6 = solution_roots[i1][5];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: the general 4R2P loop */
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
static const double weights[6] = { 0.6944, 0.6944, 0.6944, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.44, 1.44, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    general_rpprrr_fk(x, P);
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
    general_rpprrr_jacobian(x, J);
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
    const double T[16], int row, int far, double rows[8][6], const unsigned char status[8])
{
    double x[6], half[6], to[6], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 8; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

int general_rpprrr_ik(
    const double T[16], const double *q_seed, double q[8][6], unsigned char status[8])
{
    const double zeros[6] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 6; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 8; row++) {
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

int general_rpprrr_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[8][6], found[6], least = HUGE_VAL;
    unsigned char status[8];
    int result = -NONE;
    int valid = general_rpprrr_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 8 && valid; row++) {
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

void general_rpprrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)general_rpprrr_ik(T + 16 * k, NULL, (double (*)[6])(q + 48 * k), status + 8 * k);
}
