/* general_6r: General arm with six revolute joints
 *
 * Inverse kinematics, generated from robots/general_6r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_6r.yaml. The formulas and where they come from:
 * general_6r.md.
 */
#include "general_6r.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = GENERAL_6R_OK, NONE = GENERAL_6R_UNREACHABLE, FREE = GENERAL_6R_FREE_JOINT,
    OUT = GENERAL_6R_OUT_OF_LIMITS, INVALID = GENERAL_6R_INVALID_POSE
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
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.3459010722933242, 0.3459010722933242, 0.3459010722933242, 0.3459010722933242,
    0.3459010722933242, 0.3459010722933242,
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
    general_6r_fk(d->q, P);
    general_6r_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 2.8909999999999996;
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
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
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
    wrap_angles(u);
    int k = known_as(d, kept, u, kind >= 0);
    if (k >= 0)
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
 * below that has the type general_6r_lane does GENERAL_6R_LANES angles or candidates at once.
 */
/* Lanes: GNU vectors where the compiler has them, plain doubles otherwise. Vectors wider than the
 * machine's are slow: compile for the machine, or set GENERAL_6R_LANES to 1, 2, 4 or 8. */
#ifndef GENERAL_6R_LANES
#if defined(__GNUC__) && defined(__AVX512F__)
#define GENERAL_6R_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define GENERAL_6R_LANES 4
#elif defined(__GNUC__) && defined(__SSE2__)
#define GENERAL_6R_LANES 2
#else
#define GENERAL_6R_LANES 1
#endif
#endif

#if GENERAL_6R_LANES > 1 && defined(__SSE2__)
#include <immintrin.h>
#endif

/* Loops of few rounds over lanes: compilers leave them as they are where there are many operations,
 * and what could stay in registers goes through memory. */
#if GENERAL_6R_LANES == 1 || defined(__OPTIMIZE_SIZE__)
#define GENERAL_6R_UNROLL
#elif defined(__clang__)
#define GENERAL_6R_UNROLL _Pragma("clang loop unroll(full)")
#elif __GNUC__ >= 8
#define GENERAL_6R_UNROLL _Pragma("GCC unroll 16")
#else
#define GENERAL_6R_UNROLL
#endif

#define GENERAL_6R_ROOTS 24
#define GENERAL_6R_CANDIDATES 144

#if GENERAL_6R_LANES > 1
typedef double general_6r_lane __attribute__((vector_size(8 * GENERAL_6R_LANES)));
typedef long long general_6r_mask __attribute__((vector_size(8 * GENERAL_6R_LANES)));
/* the same where it lies between other doubles */
typedef double general_6r_packed
    __attribute__((vector_size(8 * GENERAL_6R_LANES), aligned(8), may_alias));
/* arrays that begin where a lane may, so that no lane crosses the border of two cache lines */
#define GENERAL_6R_ALIGNED __attribute__((aligned(8 * GENERAL_6R_LANES)))
#define GENERAL_6R_LOAD(from) \
    (general_6r_lane)(*(const general_6r_packed *)(from))
#define GENERAL_6R_STORE(to, x) \
    (*(general_6r_packed *)(to) = (general_6r_packed)(x))

static inline general_6r_lane general_6r_select(general_6r_mask m, general_6r_lane a,
    general_6r_lane b)
{
    return (general_6r_lane)((m & (general_6r_mask)a) | (~m & (general_6r_mask)b));
}

static inline general_6r_lane general_6r_abs(general_6r_lane x)
{
    return (general_6r_lane)((general_6r_mask)x & 0x7fffffffffffffffLL);
}

/* the magnitude of the first with the sign of the second */
static inline general_6r_lane general_6r_with_sign(general_6r_lane x, general_6r_lane y)
{
    const general_6r_mask sign = (general_6r_mask)y & (-0x7fffffffffffffffLL - 1);
    return (general_6r_lane)(((general_6r_mask)x & 0x7fffffffffffffffLL) | sign);
}

/* the first, turned round where the second is negative */
static inline general_6r_lane general_6r_facing(general_6r_lane x, general_6r_lane y)
{
    const general_6r_mask sign = (general_6r_mask)y & (-0x7fffffffffffffffLL - 1);
    return (general_6r_lane)((general_6r_mask)x ^ sign);
}

/* by the machine's own instruction: compilers take sqrt of <math.h> one by one, for the sake of
 * errno */
static inline general_6r_lane general_6r_sqrt(general_6r_lane x)
{
#if GENERAL_6R_LANES == 8 && defined(__AVX512F__)
    return (general_6r_lane)_mm512_sqrt_pd((__m512d)x);
#elif GENERAL_6R_LANES == 4 && defined(__AVX__)
    return (general_6r_lane)_mm256_sqrt_pd((__m256d)x);
#elif GENERAL_6R_LANES == 2 && defined(__SSE2__)
    return (general_6r_lane)_mm_sqrt_pd((__m128d)x);
#else
    general_6r_lane r = x;
    for (int k = 0; k < GENERAL_6R_LANES; k++) {
        r[k] = sqrt(x[k]);
    }
    return r;
#endif
}
#else
typedef double general_6r_lane;
typedef int general_6r_mask;
#define GENERAL_6R_ALIGNED
#define GENERAL_6R_LOAD(from) (*(from))
#define GENERAL_6R_STORE(to, x) (*(to) = (x))

static inline general_6r_lane general_6r_select(general_6r_mask m, general_6r_lane a,
    general_6r_lane b)
{
    return m ? a : b;
}

static inline general_6r_lane general_6r_abs(general_6r_lane x)
{
    return fabs(x);
}

static inline general_6r_lane general_6r_with_sign(general_6r_lane x, general_6r_lane y)
{
    return copysign(x, y);
}

static inline general_6r_lane general_6r_facing(general_6r_lane x, general_6r_lane y)
{
    return y < 0.0 ? -x : x;
}

static inline general_6r_lane general_6r_sqrt(general_6r_lane x)
{
    return sqrt(x);
}
#endif

static inline general_6r_lane general_6r_all(double x)
{
    const general_6r_lane zero = {0};
    return zero + x;
}

static inline general_6r_lane general_6r_max(general_6r_lane a, general_6r_lane b)
{
    return general_6r_select(a > b, a, b);
}

static inline general_6r_lane general_6r_min(general_6r_lane a, general_6r_lane b)
{
    return general_6r_select(a < b, a, b);
}

/* the largest of all lanes */
static inline double general_6r_largest(general_6r_lane x)
{
    double each[GENERAL_6R_LANES], most;
    GENERAL_6R_STORE(each, x);
    most = each[0];
    for (int k = 1; k < GENERAL_6R_LANES; k++) {
        most = each[k] > most ? each[k] : most;
    }
    return most;
}

/* The angle of a sine and a cosine with any positive common factor, in (-pi, pi], within 3 ulp:
 * atan of a ratio below tan(pi/8) by a polynomial. */
static inline general_6r_lane general_6r_angle(general_6r_lane y, general_6r_lane x)
{
    static const double odd[] = { -0.3333333333333333, 0.19999999999995513, -0.14285714284665177,
        0.11111111015146682, -0.0909090457366891, 0.07692183087347286, -0.0666450998991572,
        0.05858136252639731, -0.050853834915688644, 0.039229744582632814, -0.01917454359469326 };
    const general_6r_lane ax = general_6r_abs(x), ay = general_6r_abs(y), zero = {0};
    const general_6r_mask steep = ay > ax;
    const general_6r_lane high = general_6r_select(steep, ay, ax), low = general_6r_select(steep,
        ax, ay);
    const general_6r_mask turned = low > high * 0.41421356237309515;
    const general_6r_lane up = general_6r_select(turned, low - high, low);
    const general_6r_lane down = general_6r_select(turned, low + high, high);
    const general_6r_lane r = up / (down + 1e-300), u = r * r;
    general_6r_lane a = general_6r_all(odd[10]);
    for (int k = 9; k >= 0; k--) {
        a = a * u + odd[k];
    }
    a = r + r * u * a + general_6r_select(turned, zero + 0.7853981633974483, zero);
    a = general_6r_select(steep, 1.5707963267948966 - a, a);
    a = general_6r_select(x < 0.0, 3.141592653589793 - a, a);
    return general_6r_with_sign(a, y + 0.0);
}

/* The loop: K0 ... K4 and the pose, three rows of four. */
typedef struct {
    double link[6][12];
} general_6r_loop;

/* A formulation: the joints phi_1 (hidden) ... phi_6 are, from 0; phi = sign q, -1 reads the loop
 * backwards. */
typedef struct {
    int joint[6];
    double sign;
    const double (*left)[32]; /* the features of the left side if they are constant */
} general_6r_formulation;

/* the features of the left side of the formulation that has the joints 3, 2, 1, 0, 5, 4 */
static const double general_6r_left_1[15][32] GENERAL_6R_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.30950123543011937, -0.25901396578947855, -0.5131601426338478, 0.046225306226263425,
        1.4620315431845567, -0.10698303591974571, -0.4480825787040523, -0.1311282350811972,
        0.21201954899713332, 0.5300777653159212, 1.0188804976320838, -0.4079634937716518,
        -0.948522660052498, 1.9233379602204057, 0.8326944152750232, -0.43998247186478,
        -0.7652390243665459, 0.6037427344167671, -0.4099048047330974, 1.0443456471382615,
        0.2201967463067958, -1.177839050326179, -1.3698199111362692, 1.1944117835603039,
        0.32975158605512067, -1.2699976173322642, -0.3943716192322738 },
    { 0.29476308136201845, -0.24667996741855103, -0.48872394536556935, 0.044024101167869936,
        1.3924109935091018, -0.10188860563785307, -0.42674531305147845, -0.12488403341066401,
        0.20192337999726984, -0.6793403685961031, 0.11569504804956876, 0.44892218328278066,
        -0.26722102956846805, -2.373779402961608, 0.35903325404954656, 0.5557424018524205,
        -0.4636551819992243, -0.717503539172153, -0.13182908127916937, -1.5023461326486223,
        0.16640628871869098, 1.5387578103954216, -0.5584114538696523, -1.4601933448316085,
        0.11656855990824135, 1.4593838315665848, -0.1995677688738012 },
    { 0.21667990612985333, -0.1813340800258518, -0.35926025103247006, 0.03236205180251039,
        1.0235592665595075, -0.07489816364823901, -0.31369984987972116, -0.0918020686698756,
        0.1484335786593825, 0.1669962745876272, -1.612735614832615, -0.027969740303705016,
        1.7183680565973114, 0.4819415806383674, -1.677819162061972, -0.12754862551601262,
        1.723790914661482, 0.11369043097068084, 0.7648350631335933, 0.5520119953106292,
        -0.5408973888430041, -0.4108657514134413, 2.716264955695517, 0.2803174884443172,
        -0.6295859806023434, -0.17125096732594222, 0.834796899701207 },
    { 0.4902909836957804, 0.524013206945935, 0.31391576860693543, -0.706092514743039,
        0.11661432559274983, 0.22905096318582438, 0.7553700003602607, -0.4247371866506799,
        0.6796400134834827, -0.7346813986969543, 0.6140622277019022, -0.09345729953588862,
        -0.4957404143722831, -1.117423852926042, 0.7594402483843676, 0.5190453822177139,
        -0.6786041203539478, 0.041721355137450455, -0.4038194682667984, -0.3907012979451544,
        0.27348000214328344, 1.1484262037912023, -1.5377242184165625, 0.3003378648855655,
        0.36508502051884306, 0.4481209503761149, -0.4580280414297687 },
    { -0.11472715603332277, 0.49906019709136673, -0.2827035513560323, -0.6724690616600373,
        0.11106126246928556, 0.2181437744626899, 0.13772905031380134, -0.40451160633398087,
        0.06560525328829847, 0.18750947767534548, -0.7216903759739207, 0.27587560133915523,
        1.2288904809543775, -0.43129325348725917, -0.2846690865179207, -0.07057100488304008,
        0.8102327003952062, -0.383784785758999, 0.8452425387185433, -0.21007568228054818,
        -0.1139132500483076, -0.3982267855538355, 1.9151113041131058, -0.7939121387925525,
        -0.6515452729067164, 0.2210079174107975, 0.27984879316768163 },
    { 0.06890569265146798, 0.3668584144229851, -0.05457350766892113, -0.4943310148694316,
        0.08164097014901354, 0.16035716669461497, 0.2544858773897673, -0.29735588488178016,
        0.2014677806287926, 0.7943234432496128, 0.10464588669836264, -0.2417981140605195,
        -0.963630074662178, 2.182820732185485, -0.697516261195029, -0.6453919178954033,
        -0.1329051423623272, 0.46249223964158825, -0.5730280814189361, 0.8438488510182509,
        -0.23567011288058304, -1.098656440899022, -0.4087899306536951, 0.6510112112017459,
        0.36485721640404745, -0.9407377275804152, 0.2735424486434977 },
    { 1.4641618578099642, -0.5567987479616532, 0.3247506176826911, -0.9477932746931333,
        0.6898314117016586, 0.04126212526057191, 1.3452352937518837, -1.5516979352560307,
        0.8697343688016201, -0.6539733754533883, 0.782154710697146, -0.1882659220295696,
        -0.9008875262620831, -0.6959460343641213, 0.7138862800640772, 0.43621700916935613,
        -0.8696541920826125, 0.19270897873776394, -0.6688924276330267, -0.2186198970967655,
        0.2618294202384469, 1.0660935133510783, -2.003631092858169, 0.5663892149431278,
        0.5577771384910557, 0.25906373405381716, -0.4756492865179597 },
    { -0.25131316171804513, -0.8970508931597154, 0.16541790062003486, 0.24913285877620028,
        0.7818417000187741, -0.2736419663951957, -0.6623468638495187, -0.3945790026421149,
        0.5403856364342322, 0.34933813143033937, 0.3751478930188825, -0.2534516623704825,
        -0.31598925813019607, 1.2485407388795926, 0.25146040831889405, -0.2882670105790638,
        -0.2032169466471324, 0.3861606775433206, -0.13314676456722277, 0.7224299227190599,
        0.051598249871016084, -0.7823321632183647, -0.420379275521061, 0.7724486287145039,
        0.1049185920639782, -0.8018995041706092, -0.11293874797907287 },
    { 0.525759441254196, -0.405930333339509, 0.17572513719966823, 0.07831122979534118,
        0.0908417046612657, -0.03934960503244915, 0.4330679622678076, -0.4312345973773541,
        0.2572641283888871, -0.16585627871657294, 0.484335722821417, -0.1848772629499546,
        -0.10543201197905294, 0.14011633044438662, 0.1319081653258049, -0.4122756062047583,
        0.1872508498093688, 0.0016579897144355094, 0.2733910194617679, -0.11862971362134009,
        0.08774186305520003, -0.34825038992763563, -0.10510955813438633, 0.28429317477696675,
        0.24371342989056072, -0.47104914618126387, 0.08127787957979216 },
    { 0.45883244500730364, -0.35154291096093176, 0.23681323381421288, 0.06832555228933423,
        -0.11136930512196103, -0.02299571565485531, 0.473093423971562, -0.3929514776510646,
        0.21631671914639528, 0.3596833913590044, 0.5282410772249371, 0.12154980318897254,
        -1.1823121061837918, 0.004902258069689969, 1.0718802173349122, 0.4363904132411398,
        -1.4412327242863028, 0.1362306887497609, -0.49308984461794714, -0.32882041838282017,
        0.37696631369558214, 0.26066054925297466, -1.565398132550095, -0.17445382137323867,
        0.5105284378372998, -0.01152462849768246, -0.5208314631298729 },
    { 0.5797320049376676, -0.4613148875612719, -0.22789822846569024, 0.08643618196764924,
        1.0634015767882263, -0.10070829578037231, -0.003231097032708019, -0.39157615060551476,
        0.3250976685014593, -0.5468515109866903, 0.1872591558366859, 0.21283420678184783,
        0.028820212597015837, -1.1364885153174864, 0.061731402946774205, 0.22726768431997849,
        -0.08029009827367989, -0.43745841581378564, -0.4922965031832708, -0.21288680421923917,
        -0.07762400506659461, 0.841660128471686, -0.4815378203129876, -0.7248699458770727,
        -0.40510838704515445, 1.1379346833734587, -0.2615813763326414 },
    { 0.8662407670091191, 0.46192624964054607, -0.24107184066617732, -0.8000304139429045,
        0.42675927483852955, 0.02406279781740986, 0.5051768855909508, 0.4208916738200609,
        -0.4660103616102644, -0.13811080451930408, -0.1353028050206766, 0.15416813817661418,
        -1.2801729427679764, 0.7891211286825248, -0.4367779219187655, 0.335731473857001,
        -0.44143139551999233, -0.004037861486156133, -0.8795989914612254, 0.3731844820476835,
        -0.18572337742672285, 0.32054708901300355, -0.10972359004192844, -0.3799841010974686,
        0.5187843760826252, -0.22702265927252674, 0.20469343520950978 },
    { 0.6871780650048692, -0.7237649042435191, -0.009859436429033572, -0.44908204411010066,
        1.3983377849134335, -0.3103006863508354, -0.1898863443051389, -0.18009631100694123,
        0.2628512418693924, -1.0130271234469606, 0.6505929035259068, 0.0032249247946468523,
        0.8798566531916838, -1.680971996389789, 0.30332490217883357, 0.5473712447516861,
        -0.32904378766584264, -0.22100980612038634, 0.004106144752295406, -0.31619160668354135,
        -0.007061163907857819, 1.682836538985244, -1.4192775166879599, -0.1562698855649493,
        -0.973215251069877, 1.6864906753204627, -0.5572494451896773 },
    { -0.31229778334207814, 0.43807892572035373, -0.2159176372816724, -0.5397326093695817,
        0.3116840582271355, -0.05812521120967251, -0.5126135417301078, 0.6941327463626533,
        -0.42392627126031185, 0.453911786110994, -0.9965444519571622, 0.11088525229254688,
        1.6501171568074593, -0.7911914870445338, -0.5812342301810187, -1.0166509823293062,
        1.9962071768730427, -0.5279612372978428, 0.7052369208097654, -0.14949894826919213,
        -0.18612175877900788, -1.40764145075492, 2.5579696621197927, -0.4309710904775735,
        -0.5919924200042747, 0.12636221651596277, 0.40531944625522287 },
};

static const general_6r_formulation general_6r_formulations[2] = {
    { { 5, 0, 1, 2, 3, 4 }, 1.0, 0 },
    { { 3, 2, 1, 0, 5, 4 }, -1.0, general_6r_left_1 },
};

/* The constants K0 ... K4 of the loop, L and R, three rows of four; for those with joints inside
 * whose values are given, what stands before, between and behind these. */
static const double general_6r_constant[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.625797711755665, 0.1994571100439649,
        0.08310712918498539, -0.9763759861505914, -0.05692061104264318, 0.9012701410620845,
        0.3755292254425352, 0.21607853588096199, -4.005433883479374e-11 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, -0.5099649622239675, -0.863043307915415,
        -0.46028976422155465, -0.20806148517994336, 0.10646134679468323, 0.18358366339406768,
        0.09791128714350275, -0.9781157489708037, 0.05557591778869785 },
    { 0.28, -0.96, 0.0, 0.11282410668671844, -0.7731007280684683, -0.22548771235330328,
        0.5928495220860671, 0.13178733217844682, -0.5691355412026244, -0.1659978661840988,
        -0.8053132584046545, -0.07651018689267303 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, -0.4212099982970823, -0.3274379105158329,
        -0.31184562906269797, 0.8919286509533796, 0.06330373161268073, -0.6458793679317576,
        -0.6151232075540549, -0.45217616214091205, 0.1397447250289724 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.20458771345858281, 0.9360191001495627,
        0.3209208343369929, -0.14449242971052642, -0.046066283414697685, 0.13668202810455202,
        0.04686240963584641, 0.9895059058723948, -0.0067268214344506985 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, 0.026626183228620606 },
    { 1.0, 0.0, 0.0, -0.175, 0.0, 0.1383511173830834, 0.990383243153302, 0.682307145579463, 0.0,
        -0.990383243153302, 0.1383511173830834, 0.09531457306246946 },
};

/* cosine and sine of what is to be added to each joint's angle in the loop */
static const double general_6r_advance[2][6] = {
    { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        },
    { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459 },
};

/* poses close by, for those at which the formulations fail */
static const double general_6r_nudge[10][12] = {
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
static const double general_6r_sample_c[24] GENERAL_6R_ALIGNED = {
    1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386,
        0.9659258262890682
};

static const double general_6r_sample_s[24] GENERAL_6R_ALIGNED = {
    0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0,
        0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207
};

/* from the samples to a_0, a_1 ... a_8, b_1 ... b_8 and seven numbers that would be zero without
 * rounding: one row for each sample */
static const double general_6r_harmonics[24][24] GENERAL_6R_ALIGNED = {
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
static const double general_6r_grid_c[8][128] GENERAL_6R_ALIGNED = {
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

static const double general_6r_grid_s[8][128] GENERAL_6R_ALIGNED = {
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
static inline void general_6r_compose(const double A[12], const double B[12], double C[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j] +
                           (j == 3 ? A[4 * i + 3] : 0.0);
        }
    }
}

static inline void general_6r_invert(const double A[12], double B[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            B[4 * i + j] = A[4 * j + i];
        }
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11]);
    }
}

static inline void general_6r_copy(const double A[12], double B[12])
{
    for (int i = 0; i < 12; i++) {
        B[i] = A[i];
    }
}

/* A becomes A B. */
static inline void general_6r_then(double A[12], const double B[12])
{
    double C[12];
    general_6r_compose(A, B, C);
    general_6r_copy(C, A);
}

/* The links K0 ... K4 of the loop and its pose P = L T R, in arm sizes. */
static void general_6r_close(const double T[16], general_6r_loop *loop)
{
    double *const P = loop->link[5], right[12];
    general_6r_copy(general_6r_constant[0], loop->link[0]);
    general_6r_copy(general_6r_constant[1], loop->link[1]);
    general_6r_copy(general_6r_constant[2], loop->link[2]);
    general_6r_copy(general_6r_constant[3], loop->link[3]);
    general_6r_copy(general_6r_constant[4], loop->link[4]);
    general_6r_copy(general_6r_constant[5], P);
    general_6r_copy(general_6r_constant[6], right);
    general_6r_then(P, T);
    general_6r_then(P, right);
    for (int i = 3; i < 12; i += 4) {
        P[i] *= 1.5043214224895793;
    }
}

/* a rigid transform for each lane */
typedef general_6r_lane general_6r_rigid[3][4];

/* T Rz */
static inline void general_6r_turn(general_6r_rigid T, general_6r_lane c, general_6r_lane s)
{
    for (int i = 0; i < 3; i++) {
        const general_6r_lane x = T[i][0];
        T[i][0] = x * c + T[i][1] * s;
        T[i][1] = T[i][1] * c - x * s;
    }
}

/* The motion of a joint: by its cosine and sine, or by a length that stands in the sine's place. */
static inline void general_6r_move(general_6r_rigid T, int joint, general_6r_lane c, general_6r_lane
    s)
{
    (void)joint;
    general_6r_turn(T, c, s);
}

/* T K, the same K for every lane */
static inline void general_6r_follow(general_6r_rigid T, const double K[12])
{
    for (int i = 0; i < 3; i++) {
        const general_6r_lane x = T[i][0], y = T[i][1], z = T[i][2];
        for (int j = 0; j < 3; j++) {
            T[i][j] = x * K[j] + y * K[4 + j] + z * K[8 + j];
        }
        T[i][3] += x * K[3] + y * K[7] + z * K[11];
    }
}

static inline void general_6r_begin(general_6r_rigid T, const double K[12])
{
    for (int i = 0; i < 12; i++) {
        T[i / 4][i % 4] = general_6r_all(K[i]);
    }
}

/* A cosine and a sine without their common factor, which is told while it has a square. */
static inline void general_6r_to_unit(general_6r_lane *c, general_6r_lane *s)
{
    const general_6r_lane square = *c * *c + *s * *s, factor = 1.0 / general_6r_sqrt(square +
        1e-300);
    const general_6r_mask told = (square > 1e-300) & (square < 9.999999999999999e+299);
    *c = general_6r_select(told, *c * factor, general_6r_all(1.0));
    *s = general_6r_select(told, *s * factor, general_6r_all(0.0));
}

/* Reflect `rows` rows of a matrix with `columns` columns so that below the first, `column` becomes
 * zero; row[i] points to the i-th of them. Returns the new diagonal. Sums are of two halves, so
 * that half as many operations wait for each other. */
static inline general_6r_lane general_6r_reflect(general_6r_lane *const *row, int rows, int column,
    int columns)
{
    general_6r_lane axis[6], half[2], length, factor;
    for (int i = 0; i < 6; i++) {
        axis[i] = half[i % 2] = general_6r_all(0.0); /* compilers don't see that `rows` of them are
            used */
    }
    GENERAL_6R_UNROLL
    for (int i = 0; i < rows; i++) {
        axis[i] = row[i][column];
        half[i % 2] += axis[i] * axis[i];
    }
    length = general_6r_with_sign(general_6r_sqrt(half[0] + half[1]), axis[0]);
    axis[0] += length;
    factor = 1.0 / (length * axis[0] + 1e-300);
    GENERAL_6R_UNROLL
    for (int j = column + 1; j < columns; j++) {
        general_6r_lane sum;
        half[0] = axis[0] * row[0][j];
        half[1] = axis[1] * row[1][j];
        GENERAL_6R_UNROLL
        for (int i = 2; i < rows; i++) {
            half[i % 2] += axis[i] * row[i][j];
        }
        sum = (half[0] + half[1]) * factor;
        GENERAL_6R_UNROLL
        for (int i = 0; i < rows; i++) {
            row[i][j] -= axis[i] * sum;
        }
    }
    row[0][column] = -length;
    return -length;
}

/* The features of a point and a direction, at once for several columns: 1, l, p, p.p, p.l, p x l
 * and (p.p) l - 2 (p.l) p, as a rigid motion acts on them. */
static inline void general_6r_act(const double K[12], general_6r_lane x[15])
{
    const double t[3] = {K[3], K[7], K[11]};
    const double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    general_6r_lane u[3], q[3], v[3], w[3], along;
    GENERAL_6R_UNROLL
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
    GENERAL_6R_UNROLL
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        x[1 + i] = u[i];
        x[4 + i] = q[i] + t[i] * x[0];
        x[9 + i] = v[i] + (t[i1] * u[i2] - t[i2] * u[i1]);
        x[12 + i] = w[i] - 2.0 * (t[i] * x[8] + (t[i1] * v[i2] - t[i2] * v[i1])) + square * u[i];
    }
}

/* What a joint that turns makes of features: the coefficients of 1, cos and sin of its angle. */
static inline void general_6r_cosines(const general_6r_lane x[15], general_6r_lane part[3][15])
{
    static const int vector[4] = {1, 4, 9, 12};
    const general_6r_lane zero = {0};
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

/* The same by x^2, x and 1 for x = tan(phi/2), times 1 + x^2. */
static inline void general_6r_tangents(const general_6r_lane x[15], general_6r_lane part[3][15])
{
    general_6r_cosines(x, part);
    for (int i = 0; i < 15; i++) {
        const general_6r_lane one = part[0][i], cosine = part[1][i];
        part[0][i] = one - cosine;
        part[1][i] = 2.0 * part[2][i];
        part[2][i] = one + cosine;
    }
}

typedef void general_6r_joint_parts(const general_6r_lane x[15], general_6r_lane part[3][15]);

/* Columns of features, 16 places wide, pass a link, and each becomes three by what the joint before
 * it does: column a columns + k of those to come, `width` places wide, is part a of column k. */
static void general_6r_pass(const double K[12], const double from[240], int columns,
                         general_6r_joint_parts *parts, double *to, int width)
{
    /* from the last on, so that what runs over is written again */
    for (int k = (columns - 1) / GENERAL_6R_LANES * GENERAL_6R_LANES; k >= 0; k -= GENERAL_6R_LANES)
        {
        general_6r_lane x[15], part[3][15];
        for (int i = 0; i < 15; i++) {
            x[i] = GENERAL_6R_LOAD(from + 16 * i + k);
        }
        general_6r_act(K, x);
        parts(x, part);
        for (int i = 0; i < 15; i++) {
            for (int a = 0; a < 3; a++) {
                GENERAL_6R_STORE(to + width * i + a * columns + k, part[a][i]);
            }
        }
    }
}

/* Reflections that clear the columns of A, one after the other and all that follow in lanes; `axis`
 * and `factor` say how to reflect others. The products of a column with all are summed at once, its
 * own square among them. */
static inline void general_6r_clear(double A[8][8], int rows, int columns, double axis[6][8],
                                 double factor[6])
{
    GENERAL_6R_UNROLL
    for (int c = 0; c < columns; c++) {
        const int first = c / GENERAL_6R_LANES * GENERAL_6R_LANES;
        double product[8], length;
        GENERAL_6R_UNROLL
        for (int i = c; i < rows; i++) {
            axis[c][i] = A[i][c];
        }
        GENERAL_6R_UNROLL
        for (int j = first; j < columns; j += GENERAL_6R_LANES) {
            general_6r_lane sum = general_6r_all(0.0);
            GENERAL_6R_UNROLL
            for (int i = c; i < rows; i++) {
                sum += axis[c][i] * GENERAL_6R_LOAD(&A[i][j]);
            }
            GENERAL_6R_STORE(&product[j], sum);
        }
        length = copysign(sqrt(product[c]), axis[c][c]);
        axis[c][c] += length;
        factor[c] = 1.0 / (length * axis[c][c] + 1e-300);
        GENERAL_6R_UNROLL
        for (int j = first; j < columns; j += GENERAL_6R_LANES) {
            const general_6r_lane sum = GENERAL_6R_LOAD(&product[j]) + length *
                GENERAL_6R_LOAD(&A[c][j]);
            const general_6r_lane part = sum * factor[c];
            GENERAL_6R_UNROLL
            for (int i = c; i < rows; i++) {
                GENERAL_6R_STORE(&A[i][j], GENERAL_6R_LOAD(&A[i][j]) - axis[c][i] * part);
            }
        }
    }
}

static inline void general_6r_mirror(double axis[6][8], const double factor[6], int rows, int
    columns,
                                  general_6r_lane x[8])
{
    GENERAL_6R_UNROLL
    for (int c = 0; c < columns; c++) {
        general_6r_lane sum = axis[c][c] * x[c];
        GENERAL_6R_UNROLL
        for (int i = c + 1; i < rows; i++) {
            sum += axis[c][i] * x[i];
        }
        sum *= factor[c];
        GENERAL_6R_UNROLL
        for (int i = c; i < rows; i++) {
            x[i] -= axis[c][i] * sum;
        }
    }
}

/* The features of the left side: column 9 a + 3 j + i for 1, c1, s1 (a), the powers x3^2, x3, 1 (i)
 * and x2^2, x2, 1 (j) of the partners' half-angle tangents or lengths. */
static void general_6r_left_side(const general_6r_formulation *form, double link[6][12], double
    to[15][32])
{
    double x[240] = {0.0}, y[240] = {0.0}, all[600] = {0.0};
    (void)form;
    x[0] = x[48] = 1.0; /* the origin and z */
    general_6r_pass(link[2], x, 1, general_6r_tangents, y, 16);
    general_6r_pass(link[1], y, 3, general_6r_tangents, x, 16);
    general_6r_pass(link[0], x, 9, general_6r_cosines, all, 40);
    for (int k = 0; k < 32; k += GENERAL_6R_LANES) {
        general_6r_lane z[15];
        for (int i = 0; i < 15; i++) {
            z[i] = GENERAL_6R_LOAD(all + 40 * i + k);
        }
        general_6r_act(link[5], z);
        for (int i = 0; i < 15; i++) {
            GENERAL_6R_STORE(&to[i][k], z[i]);
        }
    }
}

/* The six equations of a formulation: index 32 r + 9 a + 3 j + i for equation r, 1, c1, s1 (a), the
 * powers x3^2, x3, 1 (i) and x2^2, x2, 1 (j) of the partners' half-angle tangents or lengths; the
 * left side's features have columns like these. */
static void general_6r_equations(const general_6r_formulation *form, double link[6][12], const
    double (*left)[32],
                         double E[192])
{
    double x[240] = {0.0}, y[240] = {0.0}, right[240] = {0.0};
    double inverse[12], A[8][8] GENERAL_6R_ALIGNED = { {0.0} }, still_axis[6][8], still_factor[6],
        pair_axis[6][8], pair_factor[6];
    /* the features that the outer joint of the right side leaves alone, and those that it mixes:
     * the former hold two of the eight monomials, the latter six */
    static const int still[6] = {3, 6, 7, 8, 11, 14}, pair[8] = {1, 2, 4, 5, 9, 10, 12, 13};
    (void)form;
    x[0] = x[48] = 1.0; /* the origin and z */
    general_6r_invert(link[3], inverse);
    general_6r_pass(inverse, x, 1, general_6r_cosines, y, 16);
    general_6r_invert(link[4], inverse);
    general_6r_pass(inverse, y, 3, general_6r_cosines, right, 16);
    for (int i = 0; i < 6; i++) {
        A[i][0] = right[16 * still[i] + 1];
        A[i][1] = right[16 * still[i] + 2];
    }
    general_6r_clear(A, 6, 2, still_axis, still_factor);
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < 6; k++) {
            A[i][k] = right[16 * pair[i] + 3 + k];
        }
    }
    general_6r_clear(A, 8, 6, pair_axis, pair_factor);
    for (int k = 0; k < 32; k += GENERAL_6R_LANES) {
        general_6r_lane z[15], alone[8], mixed[8];
        for (int i = 0; i < 15; i++) {
            z[i] = GENERAL_6R_LOAD(&left[i][k]);
        }
        for (int i = 0; i < 6; i++) {
            /* the constant column of the right side, times 1 + x2^2 and 1 + x3^2 */
            alone[i] = z[still[i]] - right[16 * still[i]] * z[0];
        }
        for (int i = 0; i < 8; i++) {
            mixed[i] = z[pair[i]];
        }
        general_6r_mirror(still_axis, still_factor, 6, 2, alone);
        general_6r_mirror(pair_axis, pair_factor, 8, 6, mixed);
        for (int r = 0; r < 6; r++) {
            GENERAL_6R_STORE(E + 32 * r + k, r < 4 ? alone[2 + r] : mixed[2 + r]);
        }
    }
}

/* The determinant at hidden angles, and the upper triangular factor whose null vectors are
 * (x3, 1) x (x2^2, x2, 1). With A2, A1, A0 the blocks of x3^2, x3, 1 the matrix is
 * [A2 A1 A0 0; 0 A2 A1 A0]; reflections fold it to 9x9 and to 6x6. */
static inline general_6r_lane general_6r_fold(const double *E, general_6r_lane c, general_6r_lane s,
                                        general_6r_lane factor[6][6])
{
    general_6r_lane M[6][9], W[6][9], determinant;
    general_6r_lane *const rows[6] = {M[0], M[1], M[2], M[3], M[4], M[5]};
    general_6r_lane *const last[6] = {factor[0], factor[1], factor[2], factor[3], factor[4],
        factor[5]};
    const general_6r_lane zero = {0};
    GENERAL_6R_UNROLL
    for (int r = 0; r < 6; r++) {
        GENERAL_6R_UNROLL
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + 3 * (k % 3) + k / 3;
            M[r][k] = E[at] + E[9 + at] * c + E[18 + at] * s;
        }
    }
    determinant = general_6r_reflect(rows, 6, 0, 9);
    determinant *= general_6r_reflect(rows + 1, 5, 1, 9);
    determinant *= general_6r_reflect(rows + 2, 4, 2, 9);
    /* now M is [R B1 B0; 0 D1 D0]; the other shift has R B1 B0 under D1 D0 0 */
    GENERAL_6R_UNROLL
    for (int r = 0; r < 3; r++) {
        GENERAL_6R_UNROLL
        for (int k = 0; k < 9; k++) {
            W[r][k] = M[r][k];
            W[3 + r][k] = k < 6 ? M[3 + r][3 + k] : zero;
            if (k < 6) {
                factor[3 + r][k] = M[3 + r][3 + k];
            }
        }
    }
    GENERAL_6R_UNROLL
    for (int k = 0; k < 3; k++) {
        general_6r_lane *const four[4] = {W[k], W[3], W[4], W[5]};
        determinant *= general_6r_reflect(four, 4, k, 9);
    }
    GENERAL_6R_UNROLL
    for (int r = 0; r < 3; r++) {
        GENERAL_6R_UNROLL
        for (int k = 0; k < 6; k++) {
            factor[r][k] = W[3 + r][3 + k];
        }
    }
    determinant *= general_6r_reflect(last, 6, 0, 6);
    determinant *= general_6r_reflect(last + 1, 5, 1, 6);
    determinant *= general_6r_reflect(last + 2, 4, 2, 6);
    determinant *= general_6r_reflect(last + 3, 3, 3, 6);
    determinant *= general_6r_reflect(last + 4, 2, 4, 6);
    return determinant * factor[5][5];
}

/* How far the columns that are cleared first are from depending on each other: the square of the
 * least singular value of A2 over that of the norm of [A2 A1 A0], or a third of it, as det and
 * minors of A2' A2 say. Where x3 is nearly infinite they do depend on each other if the matrix is
 * singular, and the factor does not show it. */
static inline general_6r_lane general_6r_independence(const double *E, general_6r_lane c,
    general_6r_lane s)
{
    general_6r_lane squares = {0}, A[6][3], G[3][3];
    for (int r = 0; r < 6; r++) {
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + k;
            const general_6r_lane x = E[at] + E[9 + at] * c + E[18 + at] * s;
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
    const general_6r_lane first = G[1][1] * G[2][2] - G[1][2] * G[1][2];
    const general_6r_lane minors = first + G[0][0] * G[2][2] - G[0][2] * G[0][2] + G[0][0] * G[1][1]
        - G[0][1] * G[0][1];
    const general_6r_lane det = G[0][0] * first - G[0][1] * (G[0][1] * G[2][2] - G[1][2] * G[0][2])
        +
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
} general_6r_trigonometric;

/* f and f' at the edges of the cells; the first edge stands at the end again */
typedef struct {
    double value[264] GENERAL_6R_ALIGNED, slope[264] GENERAL_6R_ALIGNED;
} general_6r_grid;

/* The roots by their cosines and sines: `simple` of them change the sign of f, `doubles` touch zero
 * within the rounding of f (two roots, none or one); behind these stand `unseen` places where a
 * closer look shows no root. At `lifted` places f turns back beside zero: no root, unless rounding
 * of what f is made of has lifted it off. `complete` says that no cell was given up. */
typedef struct {
    int simple, doubles, unseen, lifted, complete;
    double c[GENERAL_6R_ROOTS + 8], s[GENERAL_6R_ROOTS + 8];
    double double_c[GENERAL_6R_ROOTS], double_s[GENERAL_6R_ROOTS];
    double lifted_c[GENERAL_6R_ROOTS], lifted_s[GENERAL_6R_ROOTS];
} general_6r_roots;

/* What part of the circle is searched: the cell in its middle, how many it has on both sides, and
 * the value of a parabola over its bend where two complex roots count as a double one. */
typedef struct {
    int middle, reach;
    double lifted;
} general_6r_window;

static void general_6r_fit(const double samples[24], general_6r_trigonometric *f)
{
    double h[24] = {0.0}, most = 0.0, beyond = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    for (int k = 0; k < 24; k++) {
        for (int j = 0; j < 24; j++) {
            h[j] += samples[k] * general_6r_harmonics[k][j];
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
static void general_6r_at(const general_6r_trigonometric *f, double cosine, double sine, double
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
static void general_6r_fill_grid(const general_6r_trigonometric *f, general_6r_grid *g)
{
    const double *const a = f->a, *const b = f->b;
    for (int i = 0; i < 128; i += GENERAL_6R_LANES) {
        /* even multiples, the same half a turn on; odd ones, the opposite there */
        general_6r_lane even = general_6r_all(a[0]), odd = general_6r_all(0.0);
        general_6r_lane even_slope = odd, odd_slope = odd;
        GENERAL_6R_UNROLL
        for (int m = 1; m < 9; m += 2) {
            const general_6r_lane c = GENERAL_6R_LOAD(&general_6r_grid_c[m - 1][i]), s =
                GENERAL_6R_LOAD(&general_6r_grid_s[m - 1][i]);
            odd += a[m] * c + b[m] * s;
            odd_slope += m * b[m] * c - m * a[m] * s;
        }
        GENERAL_6R_UNROLL
        for (int m = 2; m < 9; m += 2) {
            const general_6r_lane c = GENERAL_6R_LOAD(&general_6r_grid_c[m - 1][i]), s =
                GENERAL_6R_LOAD(&general_6r_grid_s[m - 1][i]);
            even += a[m] * c + b[m] * s;
            even_slope += m * b[m] * c - m * a[m] * s;
        }
        GENERAL_6R_STORE(&g->value[i], even + odd);
        GENERAL_6R_STORE(&g->value[i + 128], even - odd);
        GENERAL_6R_STORE(&g->slope[i], even_slope + odd_slope);
        GENERAL_6R_STORE(&g->slope[i + 128], even_slope - odd_slope);
    }
    g->value[256] = g->value[0];
    g->slope[256] = g->slope[0];
}

/* Which of 64 cells may have roots: those where the Bernstein coefficients of the cubic through f
 * and f' at both edges are not all of the sign of the first beyond doubt. */
static unsigned long long general_6r_open_cells(const general_6r_grid *g, int from, double doubt)
{
    const double third = 0.02454369260617026 / 3.0;
    unsigned long long bits = 0;
#if GENERAL_6R_LANES > 1
    general_6r_mask weight, sum = {0};
    for (int k = 0; k < GENERAL_6R_LANES; k++) {
        weight[k] = 1LL << k;
    }
#endif
    for (int i = 0; i < 64; i += GENERAL_6R_LANES) {
        const general_6r_lane first = GENERAL_6R_LOAD(&g->value[from + i]);
        const general_6r_lane f0 = general_6r_abs(first) - doubt;
        const general_6r_lane f1 = general_6r_facing(GENERAL_6R_LOAD(&g->value[from + i + 1]),
            first) - doubt;
        const general_6r_lane d0 = general_6r_facing(GENERAL_6R_LOAD(&g->slope[from + i]), first);
        const general_6r_lane d1 = general_6r_facing(GENERAL_6R_LOAD(&g->slope[from + i + 1]),
            first);
        const general_6r_lane b1 = f0 + third * d0, b2 = f1 - third * d1;
#if GENERAL_6R_LANES > 1
        const general_6r_mask signs = (general_6r_mask)f0 | (general_6r_mask)f1 |
            (general_6r_mask)b1 | (general_6r_mask)b2;
        sum |= ((signs < 0) & weight) << i;
#else
        bits |= (unsigned long long)(f0 < 0.0 || f1 < 0.0 || b1 < 0.0 || b2 < 0.0) << i;
#endif
    }
#if GENERAL_6R_LANES > 1
    for (int k = 0; k < GENERAL_6R_LANES; k++) {
        bits |= (unsigned long long)sum[k];
    }
#endif
    return bits;
}

static void general_6r_add_angle(double c, double s, double *cosine, double *sine, int *count, int
    *complete)
{
    if (*count == GENERAL_6R_ROOTS) {
        *complete = 0;
        return;
    }
    cosine[*count] = c;
    sine[*count] = s;
    *count += 1;
}

/* The same unless it is there: neighbouring cells may be given up together. */
static void general_6r_add_once(double c, double s, double *cosine, double *sine, int *count, int
    *complete)
{
    for (int i = 0; i < *count; i++) {
        const double gap = fabs(s * cosine[i] - c * sine[i]);
        if (gap < 0.02454369260617026 / 64.0 && c * cosine[i] + s * sine[i] > 0.0) {
            return;
        }
    }
    general_6r_add_angle(c, s, cosine, sine, count, complete);
}

static void general_6r_add_simple(general_6r_roots *roots, double c, double s)
{
    general_6r_add_angle(c, s, roots->c, roots->s, &roots->simple, &roots->complete);
}

static void general_6r_add_double(general_6r_roots *roots, double c, double s)
{
    general_6r_add_once(c, s, roots->double_c, roots->double_s, &roots->doubles, &roots->complete);
}

static void general_6r_add_lifted(general_6r_roots *roots, double c, double s)
{
    general_6r_add_once(c, s, roots->lifted_c, roots->lifted_s, &roots->lifted, &roots->complete);
}

/* Parts of the circle: cosine and sine where each begins, its width, f, f', f'' at both ends, and
 * about where what is looked for lies, in parts of the width. */
typedef struct {
    int count;
    double c[48], s[48], width[48], start[48];
    double low[3][48], high[3][48];
} general_6r_parts;

/* Parts where f turns once, and parts where it rises or falls throughout and has a root. */
typedef struct {
    double lifted; /* as of the window */
    general_6r_parts turning, crossing;
} general_6r_waiting;

static void general_6r_add_part(general_6r_parts *parts, double c, double s, double width, const
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
    general_6r_lane c, s, width, start, low[3], high[3];
} general_6r_spans;

/* Parts from one on; behind the last one it stands again. */
static void general_6r_take_parts(general_6r_parts *parts, int from, general_6r_spans *out)
{
    const int last = parts->count - 1;
    while (parts->count < from + GENERAL_6R_LANES) {
        const double low[3] = {parts->low[0][last], parts->low[1][last], parts->low[2][last]};
        const double high[3] = {parts->high[0][last], parts->high[1][last], parts->high[2][last]};
        general_6r_add_part(parts, parts->c[last], parts->s[last], parts->width[last], low, high,
                         parts->start[last]);
    }
    parts->count = last + 1;
    out->c = GENERAL_6R_LOAD(parts->c + from);
    out->s = GENERAL_6R_LOAD(parts->s + from);
    out->width = GENERAL_6R_LOAD(parts->width + from);
    out->start = GENERAL_6R_LOAD(parts->start + from);
    for (int i = 0; i < 3; i++) {
        out->low[i] = GENERAL_6R_LOAD(parts->low[i] + from);
        out->high[i] = GENERAL_6R_LOAD(parts->high[i] + from);
    }
}

/* Where the quintic through f, f', f'' at both ends vanishes (order 0), or its derivative (order
 * 1), in parts of the width. */
static inline general_6r_lane general_6r_on_quintic(int order, const general_6r_spans *part)
{
    const general_6r_lane h = part->width, d = h * part->low[1], s = h * h * part->low[2];
    const general_6r_lane D = part->high[0] - part->low[0] - d - 0.5 * s;
    const general_6r_lane D1 = h * part->high[1] - d - s, D2 = h * h * part->high[2] - s;
    const general_6r_lane c3 = 10.0 * D - 4.0 * D1 + 0.5 * D2, c4 = 7.0 * D1 - 15.0 * D - D2;
    const general_6r_lane c5 = 6.0 * D - 3.0 * D1 + 0.5 * D2;
    const general_6r_mask rising = part->low[order] < 0.0;
    general_6r_lane x = part->start, from = general_6r_all(0.0), to = general_6r_all(1.0);
    for (int i = 0; i < 4; i++) {
        const general_6r_lane f = part->low[0] + x * (d + x * (0.5 * s + x * (c3 + x * (c4 + x *
            c5))));
        const general_6r_lane f1 = d + x * (s + x * (3.0 * c3 + x * (4.0 * c4 + x * (5.0 * c5))));
        const general_6r_lane f2 = s + x * (6.0 * c3 + x * (12.0 * c4 + x * (20.0 * c5)));
        const general_6r_lane value = order ? f1 : f, slope = order ? f2 : f1;
        const general_6r_mask before = (value < 0.0) == rising;
        from = general_6r_select(before, x, from);
        to = general_6r_select(before, to, x);
        x -= value / slope;
        x = general_6r_select((x >= from) & (x <= to), x, 0.5 * (from + to));
    }
    return x;
}

/* f, f', f'' where cosine and sine are given */
static inline void general_6r_at_all(const general_6r_trigonometric *f, general_6r_lane cosine,
    general_6r_lane sine,
                                  general_6r_lane out[3])
{
    general_6r_lane c[9], s[9];
    c[1] = cosine;
    s[1] = sine;
    out[0] = general_6r_all(f->a[0]);
    out[1] = out[2] = general_6r_all(0.0);
    for (int m = 1; m < 9; m++) {
        const int less = m / 2, more = m - m / 2;
        if (less) {
            c[m] = c[less] * c[more] - s[less] * s[more];
            s[m] = s[less] * c[more] + c[less] * s[more];
        }
        const general_6r_lane even = f->a[m] * c[m] + f->b[m] * s[m], odd = f->b[m] * c[m] - f->a[m]
            * s[m];
        out[0] += even;
        out[1] += m * odd;
        out[2] -= m * m * even;
    }
}

/* Turn on by a small angle, no larger than a cell. */
static inline void general_6r_turn_on(general_6r_lane x, general_6r_lane *c, general_6r_lane *s)
{
    const general_6r_lane u = x * x, c0 = *c, s0 = *s;
    const general_6r_lane dc = 1.0 - u * (0.5 - u * (1.0 / 24.0 - u * (1.0 / 720.0)));
    const general_6r_lane ds = x * (1.0 - u * (1.0 / 6.0 - u * (1.0 / 120.0 - u * (1.0 / 5040.0))));
    *c = c0 * dc - s0 * ds;
    *s = s0 * dc + c0 * ds;
}

/* Where f (order 0) or f' (order 1) vanishes: from where the quintic says by Newton, with bisection
 * where it leaves. Returns how far that is from where each part begins, with cosine and sine, and
 * f, f', f'' there, as far as an extremum is concerned. */
static inline general_6r_lane general_6r_between(const general_6r_trigonometric *f, int order,
    double settled,
                                           const general_6r_spans *part, general_6r_lane *c,
                                               general_6r_lane *s,
                                           general_6r_lane at[3])
{
    const general_6r_mask rising = part->low[order] < 0.0;
    general_6r_lane from = general_6r_all(0.0), to = part->width, x = part->width *
        general_6r_on_quintic(order, part);
    general_6r_lane step = part->width;
    for (int i = 0; i < 48; i++) {
        const general_6r_mask moving = general_6r_abs(step) >= settled;
        if (i && general_6r_largest(general_6r_abs(step)) < settled) {
            break;
        }
        *c = part->c;
        *s = part->s;
        general_6r_turn_on(x, c, s);
        general_6r_at_all(f, *c, *s, at);
        const general_6r_mask before = (at[order] < 0.0) == rising;
        from = general_6r_select(before, x, from);
        to = general_6r_select(before, to, x);
        step = -at[order] / at[order + 1];
        step = general_6r_select((x + step >= from) & (x + step <= to), step, 0.5 * (from + to) -
            x);
        step = general_6r_select(moving, step, general_6r_all(0.0));
        x += step;
    }
    general_6r_turn_on(step, c, s);
    at[0] += 0.5 * step * at[1]; /* what a parabola gains where its slope vanishes */
    return x;
}

/* The double root, or the parts with a root, of a part of the circle whose extremum is known. */
static void general_6r_divide(const general_6r_trigonometric *f, const general_6r_parts *parts, int
    i, double x,
                           double c, double s, const double at[3], general_6r_waiting *waiting,
                           general_6r_roots *roots)
{
    const double bend = fabs(at[2]) * waiting->lifted, near = bend > f->touching ? bend :
        f->touching;
    const double beside = fabs(at[0]);
    const double low[3] = {parts->low[0][i], parts->low[1][i], parts->low[2][i]};
    const double high[3] = {parts->high[0][i], parts->high[1][i], parts->high[2][i]};
    if (beside <= f->rounding) {
        general_6r_add_double(roots, c, s);
        return;
    }
    if (at[0] * at[2] > 0.0 && beside <= near) {
        general_6r_add_lifted(roots, c, s);
        return;
    }
    /* where a parabola with its summit at the extremum has its roots */
    if ((low[0] < 0.0) != (at[0] < 0.0)) {
        general_6r_add_part(&waiting->crossing, parts->c[i], parts->s[i], x, low, at,
                         1.0 - sqrt(at[0] / (at[0] - low[0])));
    }
    if ((high[0] < 0.0) != (at[0] < 0.0)) {
        general_6r_add_part(&waiting->crossing, c, s, parts->width[i] - x, at, high,
                         sqrt(at[0] / (at[0] - high[0])));
    }
}

/* The roots of all parts that wait. */
static void general_6r_solve_parts(const general_6r_trigonometric *f, general_6r_waiting *waiting,
    general_6r_roots *roots)
{
    general_6r_parts *const bent = &waiting->turning, *const crossing = &waiting->crossing;
    double x[GENERAL_6R_LANES], c[GENERAL_6R_LANES], s[GENERAL_6R_LANES],
        value[3][GENERAL_6R_LANES];
    general_6r_spans part;
    general_6r_lane cosine, sine, at[3];
    for (int from = 0; from < bent->count; from += GENERAL_6R_LANES) {
        general_6r_take_parts(bent, from, &part);
        GENERAL_6R_STORE(x, general_6r_between(f, 1, 1e-07, &part, &cosine, &sine, at));
        GENERAL_6R_STORE(c, cosine);
        GENERAL_6R_STORE(s, sine);
        for (int i = 0; i < 3; i++) {
            GENERAL_6R_STORE(value[i], at[i]);
        }
        for (int k = 0; k < GENERAL_6R_LANES && from + k < bent->count; k++) {
            const double extremum[3] = {value[0][k], 0.0, value[2][k]};
            general_6r_divide(f, bent, from + k, x[k], c[k], s[k], extremum, waiting, roots);
        }
    }
    for (int from = 0; from < crossing->count; from += GENERAL_6R_LANES) {
        general_6r_take_parts(crossing, from, &part);
        (void)general_6r_between(f, 0, 1e-09, &part, &cosine, &sine, at);
        GENERAL_6R_STORE(c, cosine);
        GENERAL_6R_STORE(s, sine);
        for (int k = 0; k < GENERAL_6R_LANES && from + k < crossing->count; k++) {
            general_6r_add_simple(roots, c[k], s[k]);
        }
    }
    bent->count = crossing->count = 0;
}

/* A part where f has one extremum at most waits for others, to be solved in lanes. */
static void general_6r_few(const general_6r_trigonometric *f, double c, double s, double width,
    const double low[3],
                        const double high[3], general_6r_waiting *waiting, general_6r_roots *roots)
{
    if (low[1] * high[1] < 0.0) {
        general_6r_add_part(&waiting->turning, c, s, width, low, high, low[1] / (low[1] - high[1]));
    } else if ((low[0] < 0.0) != (high[0] < 0.0)) {
        general_6r_add_part(&waiting->crossing, c, s, width, low, high, low[0] / (low[0] -
            high[0]));
    }
    if (waiting->turning.count == 16 || waiting->crossing.count == 16) {
        general_6r_solve_parts(f, waiting, roots);
    }
}

/* What is known about f in a part of the circle. */
enum { GENERAL_6R_ROOTLESS, GENERAL_6R_FLAT, GENERAL_6R_TAME, GENERAL_6R_WILD };

/* Rootless; flat, nothing but rounding; tame, with one extremum at most; or none of these. The
 * Bernstein coefficients of the quintic through f, f', f'' at both ends and their differences bound
 * f, f' and f''. */
static inline void general_6r_kinds(const general_6r_trigonometric *f, const general_6r_spans *part,
    int kind[GENERAL_6R_LANES])
{
    const general_6r_lane h = part->width, d0 = h * part->low[1] * 0.2, d1 = h * part->high[1] *
        0.2;
    const general_6r_lane s0 = h * h * part->low[2] * 0.05, s1 = h * h * part->high[2] * 0.05;
    const general_6r_lane share = h * (1.0 / 0.02454369260617026), square = share * share;
    const general_6r_lane doubt = f->rounding + f->scale * 2e-09 * square * square * square;
    const general_6r_lane b[6] = {part->low[0],
                           part->low[0] + d0,
                           part->low[0] + 2.0 * d0 + s0,
                           part->high[0] - 2.0 * d1 + s1,
                           part->high[0] - d1,
                           part->high[0]};
    general_6r_lane least[3], most[3];
    double bounds[5][GENERAL_6R_LANES];
    least[0] = general_6r_min(b[0], b[5]);
    most[0] = general_6r_max(b[0], b[5]);
    least[1] = most[1] = b[1] - b[0];
    least[2] = most[2] = b[2] - b[1] - least[1];
    for (int i = 1; i < 5; i++) {
        const general_6r_lane first = b[i + 1] - b[i], second = first - (b[i] - b[i - 1]);
        least[0] = general_6r_min(least[0], b[i]);
        most[0] = general_6r_max(most[0], b[i]);
        least[1] = general_6r_min(least[1], first);
        most[1] = general_6r_max(most[1], first);
        least[2] = general_6r_min(least[2], second);
        most[2] = general_6r_max(most[2], second);
    }
    /* what rounding does to f' and f'' shrinks with the width, down to that of the quintic's
     * ends */
    GENERAL_6R_STORE(bounds[0], least[0]);
    GENERAL_6R_STORE(bounds[1], most[0]);
    GENERAL_6R_STORE(bounds[2], general_6r_max(least[1], -most[1]) - doubt * share);
    GENERAL_6R_STORE(bounds[3], general_6r_max(least[2], -most[2]) - doubt * square);
    GENERAL_6R_STORE(bounds[4], general_6r_max(doubt, general_6r_all(f->touching)));
    for (int k = 0; k < GENERAL_6R_LANES; k++) {
        if (bounds[0][k] > bounds[4][k] || bounds[1][k] < -bounds[4][k]) {
            kind[k] = GENERAL_6R_ROOTLESS;
        } else if (bounds[0][k] >= -f->rounding && bounds[1][k] <= f->rounding) {
            kind[k] = GENERAL_6R_FLAT;
        } else {
            kind[k] = bounds[2][k] > 0.0 || bounds[3][k] > 0.0 ? GENERAL_6R_TAME : GENERAL_6R_WILD;
        }
    }
}

/* The same of one part. */
static int general_6r_kind(const general_6r_trigonometric *f, const double low[3], const double
    high[3], double h)
{
    general_6r_spans part;
    int kind[GENERAL_6R_LANES];
    part.width = general_6r_all(h);
    for (int i = 0; i < 3; i++) {
        part.low[i] = general_6r_all(low[i]);
        part.high[i] = general_6r_all(high[i]);
    }
    general_6r_kinds(f, &part, kind);
    return kind[0];
}

/* The roots of a cell where f may turn more than once: halve it until it does not. */
static void general_6r_many(const general_6r_trigonometric *f, double low, double c, double s, const
    double first[3],
                         const double last[3], int *budget, general_6r_waiting *waiting,
                         general_6r_roots *roots)
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
        const int kind = general_6r_kind(f, at_low, at[top], h);
        if (kind == GENERAL_6R_TAME) {
            general_6r_few(f, c, s, h, at_low, at[top], waiting, roots);
        } else if (kind != GENERAL_6R_ROOTLESS) {
            const double middle = low + 0.5 * h, cosine = cos(middle), sine = sin(middle);
            if (kind == GENERAL_6R_FLAT || depth[top] == 14 || *budget == 0) {
                general_6r_solve_parts(f, waiting, roots); /* of neighbouring double roots the first
                    is kept */
                roots->complete = 0;
                general_6r_add_double(roots, cosine, sine);
            } else {
                *budget -= 1;
                edge[open] = middle;
                edge_c[open] = cosine;
                edge_s[open] = sine;
                depth[top] += 1;
                depth[open] = depth[top];
                general_6r_at(f, cosine, sine, at[open]);
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
static void general_6r_edge(int cell, double *c, double *s)
{
    const int half = cell % 128;
    *c = cell < 128 ? general_6r_grid_c[0][half] : -general_6r_grid_c[0][half];
    *s = cell < 128 ? general_6r_grid_s[0][half] : -general_6r_grid_s[0][half];
}

static int general_6r_lowest(unsigned long long bits)
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
static void general_6r_search_cells(const general_6r_trigonometric *f, const general_6r_grid *g,
    const int *cell, int count,
                                 int *budget, general_6r_waiting *waiting, general_6r_roots *roots)
{
    const double h = 0.02454369260617026;
    double in[8][GENERAL_6R_LANES], bend[2][GENERAL_6R_LANES];
    int kind[GENERAL_6R_LANES];
    general_6r_spans part;
    for (int k = 0; k < GENERAL_6R_LANES; k++) {
        const int i = cell[k < count ? k : 0];
        in[0][k] = g->value[i];
        in[1][k] = g->slope[i];
        in[2][k] = g->value[i + 1];
        in[3][k] = g->slope[i + 1];
        general_6r_edge(i, &in[4][k], &in[5][k]);
        general_6r_edge((i + 1) % 256, &in[6][k], &in[7][k]);
    }
    part.width = general_6r_all(h);
    for (int end = 0; end < 2; end++) {
        general_6r_lane at[3], *const to = end ? part.high : part.low;
        general_6r_at_all(f, GENERAL_6R_LOAD(in[4 + 2 * end]), GENERAL_6R_LOAD(in[5 + 2 * end]),
            at);
        /* the edges' own values, so that neighbouring cells agree about their signs */
        to[0] = GENERAL_6R_LOAD(in[2 * end]);
        to[1] = GENERAL_6R_LOAD(in[2 * end + 1]);
        to[2] = at[2];
        GENERAL_6R_STORE(bend[end], at[2]);
    }
    general_6r_kinds(f, &part, kind);
    for (int k = 0; k < count; k++) {
        const double low[3] = {in[0][k], in[1][k], bend[0][k]};
        const double high[3] = {in[2][k], in[3][k], bend[1][k]};
        if (kind[k] == GENERAL_6R_TAME) {
            general_6r_few(f, in[4][k], in[5][k], h, low, high, waiting, roots);
        } else if (kind[k] != GENERAL_6R_ROOTLESS) {
            general_6r_many(f, cell[k] * h, in[4][k], in[5][k], low, high, budget, waiting, roots);
        }
    }
}

static void general_6r_find_roots(const general_6r_trigonometric *f, const general_6r_window
    *window,
                               general_6r_roots *roots)
{
    general_6r_grid g;
    general_6r_waiting waiting;
    int open[256], count = 0;
    int budget = 100; /* against an f that is next to nothing for long stretches */
    general_6r_fill_grid(f, &g);
    roots->simple = roots->doubles = roots->unseen = roots->lifted = 0;
    roots->complete = 1;
    for (int word = 0; word < 256 / 64; word++) {
        unsigned long long bits =
            general_6r_open_cells(&g, 64 * word, f->rounding + f->scale * 2e-05);
        for (; bits; bits &= bits - 1) {
            const int i = 64 * word + general_6r_lowest(bits);
            const int away = i > window->middle ? i - window->middle : window->middle - i;
            if (away <= window->reach || 256 - away <= window->reach) {
                open[count++] = i;
            }
        }
    }
    waiting.lifted = window->lifted;
    waiting.turning.count = waiting.crossing.count = 0;
    for (int k = 0; k < count; k += GENERAL_6R_LANES) {
        general_6r_search_cells(f, &g, open + k, count - k < GENERAL_6R_LANES ? count - k :
            GENERAL_6R_LANES, &budget,
                             &waiting, roots);
    }
    general_6r_solve_parts(f, &waiting, roots);
}

/* A lens on the circle: e^(i phi) = (w + a) / (1 + conj(a) w) with a = x + i y inside the circle
 * maps the circle of w = e^(i psi) to itself and shows what lies around the direction of a larger.
 * Where all roots lie together, as near the boundary of reach, f drowns in rounding without it. */
typedef struct {
    double x, y;
} general_6r_lens;

/* Cosine and sine of phi from those of psi. Returns |1 + conj(a) w|^2, whose eighth power makes of
 * f a polynomial in psi. */
static inline general_6r_lane general_6r_through(const general_6r_lens *a, general_6r_lane *c,
    general_6r_lane *s)
{
    const general_6r_lane u = *c + a->x, v = *s + a->y;
    const general_6r_lane d = 1.0 + a->x * *c + a->y * *s, e = a->x * *s - a->y * *c;
    const general_6r_lane square = d * d + e * e;
    *c = (u * d + v * e) / square;
    *s = (v * d - u * e) / square;
    return square;
}

/* The samples of f in phi become those of a polynomial in psi. */
static inline general_6r_lane general_6r_weighted(general_6r_lane f, general_6r_lane square)
{
    const general_6r_lane fourth = square * square, eighth = fourth * fourth;
    return f * (eighth * eighth);
}

/* The lens under which the roots are spread, from samples without one; 0 when they are already. log
 * |f| is a sum over the roots z, and the first harmonic of log |e^(i phi) - z| is -z for z inside
 * the circle, that of its mirror image for z outside. */
static int general_6r_spread(const double samples[24], general_6r_lens *a)
{
    double x = 0.0, y = 0.0, square, part;
    for (int k = 0; k < 12; k++) {
        const double ratio = log((fabs(samples[k]) + 1e-300) / (fabs(samples[k + 12]) + 1e-300));
        x += ratio * general_6r_sample_c[k];
        y += ratio * general_6r_sample_s[k];
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
static void general_6r_behind(const general_6r_lens *a, int count, double *cosine, double *sine)
{
    for (int i = 0; i < count; i += GENERAL_6R_LANES) {
        general_6r_lane c = GENERAL_6R_LOAD(cosine + i), s = GENERAL_6R_LOAD(sine + i);
        (void)general_6r_through(a, &c, &s);
        GENERAL_6R_STORE(cosine + i, c);
        GENERAL_6R_STORE(sine + i, s);
    }
}

/* Samples of a polynomial through a lens; `of` is what it is made of. */
typedef void (*general_6r_sampler)(const void *of, const general_6r_lens *lens, double samples[24]);

/* Keeps of angles beside which there is no root, as far as f tells, those where what it is made of
 * allows one; returns how many. */
typedef int (*general_6r_keeper)(const void *of, int count, double *cosine, double *sine);

/* What f is made of, and what tells of it; `keep` may be 0, where nothing tells. */
typedef struct {
    general_6r_sampler sample;
    general_6r_keeper keep;
    const void *of;
} general_6r_source;

/* Whether two angles, by their cosines and sines, are as near as a closer look reaches. */
static int general_6r_near(double c, double s, double cosine, double sine)
{
    return c * cosine + s * sine >= 0.9980487804878049;
}

/* Of roots those that are near to an angle, or those that are not, behind `count` that are kept. */
static int general_6r_keep_roots(int near, double cosine, double sine, const double *from_c,
                              const double *from_s, int many, double *c, double *s, int count)
{
    for (int i = 0; i < many && count < GENERAL_6R_ROOTS; i++) {
        if (general_6r_near(from_c[i], from_s[i], cosine, sine) == near) {
            c[count] = from_c[i];
            s[count] = from_s[i];
            count++;
        }
    }
    return count;
}

static int general_6r_kept(const general_6r_source *source, int count, double *cosine, double *sine)
{
    return source->keep ? source->keep(source->of, count, cosine, sine) : count;
}

/* The places where f turns back beside zero are double roots where there may be any. */
static void general_6r_take_lifted(const general_6r_source *source, general_6r_roots *roots)
{
    const int count = general_6r_kept(source, roots->lifted, roots->lifted_c, roots->lifted_s);
    for (int i = 0; i < count; i++) {
        general_6r_add_double(roots, roots->lifted_c[i], roots->lifted_s[i]);
    }
}

/* The roots around an angle, through a lens that magnifies what is there, instead of those that
 * were known. Returns 0, and leaves these, where that does not show all. */
static int general_6r_magnify(const general_6r_source *source, double cosine, double sine,
    general_6r_roots *roots)
{
    const general_6r_lens lens = { 0.8823529411764706 * cosine, 0.8823529411764706 * sine};
    const double turns = atan2(sine, cosine) / 6.283185307179586;
    const int cell = (int)(256.0 * (turns - floor(turns))) % 256;
    const general_6r_window window = {cell, 38, 1.28e-06};
    double samples[24];
    general_6r_trigonometric f;
    general_6r_roots found;
    source->sample(source->of, &lens, samples);
    general_6r_fit(samples, &f);
    if (!(f.noise <= 1e-10)) {
        return 0;
    }
    general_6r_find_roots(&f, &window, &found);
    if (!found.complete) {
        return 0;
    }
    general_6r_behind(&lens, found.simple, found.c, found.s);
    general_6r_behind(&lens, found.doubles, found.double_c, found.double_s);
    general_6r_behind(&lens, found.lifted, found.lifted_c, found.lifted_s);
    general_6r_take_lifted(source, &found);
    roots->simple = general_6r_keep_roots(0, cosine, sine, roots->c, roots->s, roots->simple,
                                       roots->c, roots->s, 0);
    roots->doubles = general_6r_keep_roots(0, cosine, sine, roots->double_c, roots->double_s,
                                        roots->doubles, roots->double_c, roots->double_s, 0);
    roots->simple = general_6r_keep_roots(1, cosine, sine, found.c, found.s, found.simple,
                                       roots->c, roots->s, roots->simple);
    roots->doubles = general_6r_keep_roots(1, cosine, sine, found.double_c, found.double_s,
                                        found.doubles, roots->double_c, roots->double_s,
                                        roots->doubles);
    return 1;
}

/* Whether any root is near to an angle. */
static int general_6r_any_near(const general_6r_roots *roots, double cosine, double sine)
{
    int any = 0;
    for (int i = 0; i < roots->simple; i++) {
        any |= general_6r_near(roots->c[i], roots->s[i], cosine, sine);
    }
    for (int i = 0; i < roots->doubles; i++) {
        any |= general_6r_near(roots->double_c[i], roots->double_s[i], cosine, sine);
    }
    return any;
}

/* Where roots may be double they are replaced by what a closer look shows: values that are computed
 * there have the digits that the fit of f lacks, not those that the equations lack behind f. What
 * was given up stands among them. */
static void general_6r_look_closer(const general_6r_source *source, general_6r_roots *roots)
{
    double c[4], s[4], empty_c[4], empty_s[4];
    int looks = 0, clear = 1, i = 0, empty = 0, emptied[4];
    if (roots->simple == GENERAL_6R_ROOTS || roots->doubles == GENERAL_6R_ROOTS) {
        return;
    }
    while (i < roots->doubles) {
        int seen = 0;
        for (int k = 0; k < looks; k++) {
            seen |= general_6r_near(roots->double_c[i], roots->double_s[i], c[k], s[k]);
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
        emptied[looks] = general_6r_magnify(source, c[looks], s[looks], roots);
        clear &= emptied[looks];
        emptied[looks] &= !general_6r_any_near(roots, c[looks], s[looks]);
        looks++;
        i = 0;
    }
    for (int k = 0; k < looks; k++) {
        if (emptied[k]) {
            empty_c[empty] = c[k];
            empty_s[empty++] = s[k];
        }
    }
    empty = general_6r_kept(source, empty, empty_c, empty_s);
    for (int k = 0; k < empty && roots->doubles + k < GENERAL_6R_ROOTS; k++) {
        roots->double_c[roots->doubles + k] = empty_c[k];
        roots->double_s[roots->doubles + k] = empty_s[k];
        roots->unseen++;
    }
    roots->complete = roots->complete || (clear && i == roots->doubles);
}

/* Whether samples are nothing but rounding of zero, which may be as smooth as a polynomial. */
static int general_6r_is_nothing(const double samples[24])
{
    double most = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    return most <= 1e-26;
}

/* All real roots of a polynomial. Returns 0 where it vanishes identically. */
static int general_6r_real_roots(const general_6r_source *source, general_6r_roots *roots)
{
    const general_6r_window all = {0, 128, 5e-09};
    double samples[24];
    general_6r_trigonometric f;
    general_6r_lens lens = {0.0, 0.0};
    source->sample(source->of, &lens, samples);
    if (general_6r_is_nothing(samples)) {
        return 0;
    }
    if (general_6r_spread(samples, &lens)) {
        source->sample(source->of, &lens, samples);
    }
    general_6r_fit(samples, &f);
    if (!(f.noise <= 1e-06)) {
        return 0;
    }
    general_6r_find_roots(&f, &all, roots);
    general_6r_behind(&lens, roots->simple, roots->c, roots->s);
    general_6r_behind(&lens, roots->doubles, roots->double_c, roots->double_s);
    general_6r_behind(&lens, roots->lifted, roots->lifted_c, roots->lifted_s);
    general_6r_take_lifted(source, roots);
    general_6r_look_closer(source, roots);
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
    int count, groups, group[GENERAL_6R_CANDIDATES], regular[GENERAL_6R_CANDIDATES];
    double c[GENERAL_6R_CANDIDATES], s[GENERAL_6R_CANDIDATES], n[6][GENERAL_6R_CANDIDATES];
} general_6r_candidates;

/* x = U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal. Returns what was
 * its length: the reciprocal of the square of the smallest singular value, in the end. */
static inline general_6r_lane general_6r_inverse_iteration(general_6r_lane U[6][6], const
    general_6r_lane inverse[6],
                                             general_6r_lane x[6])
{
    general_6r_lane square = {0};
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
    const general_6r_lane length = general_6r_sqrt(square) + 1e-300;
    for (int i = 0; i < 6; i++) {
        x[i] *= 1.0 / length;
    }
    return length;
}

/* The reciprocals of a diagonal, kept finite. */
static inline void general_6r_reciprocals(general_6r_lane U[6][6], general_6r_lane inverse[6])
{
    general_6r_lane most = general_6r_abs(U[0][0]);
    for (int i = 1; i < 6; i++) {
        most = general_6r_max(most, general_6r_abs(U[i][i]));
    }
    most = most * 1e-15 + 1e-300;
    for (int i = 0; i < 6; i++) {
        const general_6r_lane d = U[i][i];
        inverse[i] = 1.0 / general_6r_select(general_6r_abs(d) > most, d, general_6r_with_sign(most,
            d));
    }
}

/* One candidate for each simple root, all of one group. */
static void general_6r_null_vectors(const double *E, const general_6r_roots *roots,
                                 general_6r_candidates *out)
{
    static const double start[6] = { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 };
    const int behind = out->count;
    for (int from = 0; from < roots->simple; from += GENERAL_6R_LANES) {
        double cs[2][GENERAL_6R_LANES];
        general_6r_lane factor[6][6], inverse[6], x[6], c, s;
        for (int k = 0; k < GENERAL_6R_LANES; k++) {
            const int i = from + k < roots->simple ? from + k : from;
            cs[0][k] = roots->c[i];
            cs[1][k] = roots->s[i];
        }
        c = GENERAL_6R_LOAD(cs[0]);
        s = GENERAL_6R_LOAD(cs[1]);
        (void)general_6r_fold(E, c, s, factor);
        general_6r_reciprocals(factor, inverse);
        for (int i = 0; i < 6; i++) {
            x[i] = general_6r_all(start[i]);
        }
        (void)general_6r_inverse_iteration(factor, inverse, x);
        (void)general_6r_inverse_iteration(factor, inverse, x);
        GENERAL_6R_STORE(out->c + behind + from, c);
        GENERAL_6R_STORE(out->s + behind + from, s);
        for (int i = 0; i < 6; i++) {
            GENERAL_6R_STORE(out->n[i] + behind + from, x[i]);
        }
    }
    for (int i = 0; i < roots->simple; i++) {
        out->group[out->count++] = out->groups;
    }
    out->groups++;
}

/* The determinant itself, turned on by small angles: middle - apart, middle, middle + apart. */
static void general_6r_beside(const double *E, double c, double s, double middle, double apart,
    double f[8])
{
    static const double side[8] GENERAL_6R_ALIGNED = {-1.0, 0.0, 1.0};
    for (int k = 0; k < 3; k += GENERAL_6R_LANES) {
        general_6r_lane cosine = general_6r_all(c), sine = general_6r_all(s), factor[6][6];
        general_6r_turn_on(middle + apart * GENERAL_6R_LOAD(side + k), &cosine, &sine);
        GENERAL_6R_STORE(f + k, general_6r_fold(E, cosine, sine, factor));
    }
}

/* Two simple roots beside a place where roots may have met, if there are: the determinant itself
 * has digits there that its fit lacks. Each parabola is as wide as the one before says that they
 * are apart. */
static void general_6r_separate(const double *E, double c, double s, general_6r_roots *out)
{
    double middle = 0.0, apart = 0.0001;
    for (int round = 0; round < 3; round++) {
        double f[8], slope, bend, square;
        general_6r_beside(E, c, s, middle, apart, f);
        slope = 0.5 * (f[2] - f[0]);
        bend = 0.5 * (f[2] + f[0]) - f[1];
        square = slope * slope - 4.0 * bend * f[1];
        middle -= 0.5 * slope / bend * apart;
        apart *= sqrt(square) / fabs(bend);
        if (!(apart > 0.0 && fabs(middle) + apart < 0.0001)) {
            return; /* none, or apart so far that they are known */
        }
    }
    for (int sign = -1; sign <= 1 && out->simple < GENERAL_6R_ROOTS; sign += 2) {
        const double x = middle + 0.5 * sign * apart;
        out->c[out->simple] = c * cos(x) - s * sin(x);
        out->s[out->simple++] = s * cos(x) + c * sin(x);
    }
}

static void general_6r_add_candidate(general_6r_candidates *out, double c, double s, const double
    n[6])
{
    if (out->count == GENERAL_6R_CANDIDATES) {
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
static void general_6r_split(double n[2][6], int rows, const int *up, const int *down, double c,
                          double s, general_6r_candidates *out)
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
        general_6r_add_candidate(out, c, s, sum);
    }
}

/* Two vectors, orthogonal, at which a factor is smallest. Returns 1 where it is regular, with no
 * singular value that is next to nothing and not two small ones, else 0. */
static inline general_6r_lane general_6r_smallest(general_6r_lane factor[6][6], general_6r_lane
    x[2][6])
{
    static const double start[2][6] = {
        { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 },
        { -0.31, 0.47, 0.59, 0.67, -0.23, 0.41 },
    };
    general_6r_lane inverse[6], length, second, squares = {0};
    general_6r_reciprocals(factor, inverse);
    for (int i = 0; i < 6; i++) {
        x[0][i] = general_6r_all(start[0][i]);
        x[1][i] = general_6r_all(start[1][i]);
        for (int j = i; j < 6; j++) {
            squares += factor[i][j] * factor[i][j];
        }
    }
    for (int step = 0; step < 4; step++) {
        general_6r_lane along = {0};
        length = general_6r_inverse_iteration(factor, inverse, x[0]);
        second = general_6r_inverse_iteration(factor, inverse, x[1]);
        for (int i = 0; i < 6; i++) {
            along += x[0][i] * x[1][i];
        }
        for (int i = 0; i < 6; i++) {
            x[1][i] -= along * x[0][i];
        }
    }
    return general_6r_select((length * squares < 25000000000000.004) & (second * squares <
        1000000000000.0),
                          general_6r_all(1.0), general_6r_all(0.0));
}

/* Candidates where two roots may have met: the null space may be a plane, which is split where one
 * of the two shifts, x3 or x2, has an eigenvalue. */
static void general_6r_null_plane(const double *E, double c, double s, general_6r_candidates *out)
{
    static const int up_3[3] = {0, 1, 2}, down_3[3] = {3, 4, 5};
    static const int up_2[4] = {0, 1, 3, 4}, down_2[4] = {1, 2, 4, 5};
    general_6r_lane factor[6][6], x[2][6];
    double n[2][6];
    if (out->groups == GENERAL_6R_CANDIDATES) {
        return;
    }
    (void)general_6r_fold(E, general_6r_all(c), general_6r_all(s), factor);
    out->regular[out->groups] =
        general_6r_largest(general_6r_smallest(factor, x)) > 0.0 &&
        general_6r_largest(general_6r_independence(E, general_6r_all(c), general_6r_all(s))) >
            8.999999999999999e-08;
    for (int r = 0; r < 2; r++) {
        double square = 0.0;
        for (int i = 0; i < 6; i++) {
            n[r][i] = general_6r_largest(x[r][i]);
            square += n[r][i] * n[r][i];
        }
        square = sqrt(square) + 1e-300;
        for (int i = 0; i < 6; i++) {
            n[r][i] /= square;
        }
    }
    general_6r_add_candidate(out, c, s, n[0]);
    general_6r_split(n, 3, up_3, down_3, c, s, out);
    general_6r_split(n, 4, up_2, down_2, c, s, out);
    out->groups++;
}

/* The terms a c + b s + w of five invariants of B = Rz K Rz(phi5) M Rz: l_z, p_z, p.l, p.p / 2 and
 * (p x l)_z; and the 2x5 matrix that solves them for c and s by least squares. */
static void general_6r_invariants(const double K[12], const double M[12], double w[5],
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
static inline void general_6r_partners(const int joint[6], const general_6r_lane n[6],
    general_6r_lane c[6],
                                    general_6r_lane s[6])
{
    const general_6r_lane up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const general_6r_lane down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5];
    general_6r_lane row[3], sign, top, bottom;
    for (int i = 0; i < 3; i++) {
        row[i] = general_6r_select(up > down, n[i], n[3 + i]);
    }
    sign = general_6r_with_sign(general_6r_all(1.0), row[0] + row[2]);
    c[1] = sign * (row[2] - row[0]);
    s[1] = sign * 2.0 * row[1];
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2];
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2];
    c[2] = bottom * bottom - top * top;
    s[2] = 2.0 * top * bottom;
    general_6r_to_unit(&c[1], &s[1]);
    general_6r_to_unit(&c[2], &s[2]);
    (void)joint;
}

/* phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve` are those of the invariants. */
static inline void general_6r_others(const int joint[6], double link[6][12], const double w[5],
                                  double solve[2][5], general_6r_lane c[6], general_6r_lane s[6])
{
    general_6r_rigid G, C;
    general_6r_lane l[3], q[3], value[5], x, y;
    general_6r_begin(G, link[5]);
    for (int i = 0; i < 3; i++) {
        general_6r_move(G, joint[i], c[i], s[i]);
        general_6r_follow(G, link[i]);
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
    c[4] = s[4] = general_6r_all(0.0);
    for (int i = 0; i < 5; i++) {
        c[4] += solve[0][i] * (value[i] - w[i]);
        s[4] += solve[1][i] * (value[i] - w[i]);
    }
    general_6r_to_unit(&c[4], &s[4]);
    general_6r_begin(C, link[3]);
    general_6r_turn(C, c[4], s[4]);
    general_6r_follow(C, link[4]);
    c[3] = C[0][2] * l[0] + C[1][2] * l[1] + C[0][3] * q[0] + C[1][3] * q[1];
    s[3] = C[0][2] * l[1] - C[1][2] * l[0] + C[0][3] * q[1] - C[1][3] * q[0];
    general_6r_to_unit(&c[3], &s[3]);
    c[5] = s[5] = general_6r_all(0.0);
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
    general_6r_to_unit(&c[5], &s[5]);
}

/* The loop's error at cosines and sines of the joints: translation and rotation vector that are
 * missing. J, when given, takes the rows of the Jacobian with the error as seventh column. Returns
 * the square of the error. */
static inline general_6r_lane general_6r_error(const general_6r_loop *loop, const general_6r_lane
    c[6],
                                         const general_6r_lane s[6], general_6r_lane J[6][7])
{
    static const double identity[12] = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    const double *const P = loop->link[5];
    general_6r_rigid T;
    general_6r_lane z[6][3], o[6][3], S[3][3], square = {0}, trace;
    general_6r_begin(T, identity);
    GENERAL_6R_UNROLL
    for (int k = 0; k < 6; k++) {
        if (k) {
            general_6r_follow(T, loop->link[k - 1]);
        }
        GENERAL_6R_UNROLL
        for (int i = 0; i < 3; i++) {
            z[k][i] = T[i][2];
            o[k][i] = T[i][3];
        }
        general_6r_move(T, k, c[k], s[k]);
    }
    GENERAL_6R_UNROLL
    for (int i = 0; i < 3; i++) {
        GENERAL_6R_UNROLL
        for (int j = 0; j < 3; j++) {
            S[i][j] = P[4 * i] * T[j][0] + P[4 * i + 1] * T[j][1] + P[4 * i + 2] * T[j][2];
        }
        J[i][6] = P[4 * i + 3] - T[i][3];
    }
    J[3][6] = 0.5 * (S[2][1] - S[1][2]);
    J[4][6] = 0.5 * (S[0][2] - S[2][0]);
    J[5][6] = 0.5 * (S[1][0] - S[0][1]);
    GENERAL_6R_UNROLL
    for (int i = 0; i < 6; i++) {
        square += J[i][6] * J[i][6];
    }
    GENERAL_6R_UNROLL
    for (int k = 0; k < 6; k++) {
        GENERAL_6R_UNROLL
        for (int i = 0; i < 3; i++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            J[i][k] = z[k][i1] * (T[i2][3] - o[k][i2]) - z[k][i2] * (T[i1][3] - o[k][i1]);
            J[3 + i][k] = z[k][i];
        }
    }
    /* half a turn away the skew part vanishes too: the trace tells */
    trace = S[0][0] + S[1][1] + S[2][2];
    return general_6r_select(trace < 0.0, square + 1.0, square);
}

/* A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
 * next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
 * largest. */
static inline general_6r_lane general_6r_step(general_6r_lane J[6][7], general_6r_lane x[6])
{
    general_6r_lane *const row[6] = {J[0], J[1], J[2], J[3], J[4], J[5]};
    general_6r_lane most, least;
    const general_6r_lane zero = {0};
    general_6r_reflect(row, 6, 0, 7);
    general_6r_reflect(row + 1, 5, 1, 7);
    general_6r_reflect(row + 2, 4, 2, 7);
    general_6r_reflect(row + 3, 3, 3, 7);
    general_6r_reflect(row + 4, 2, 4, 7);
    most = least = general_6r_abs(J[0][0]);
    for (int i = 1; i < 6; i++) {
        most = general_6r_max(most, general_6r_abs(J[i][i]));
        least = general_6r_min(least, general_6r_abs(J[i][i]));
    }
    least /= most;
    most *= 1e-09;
    for (int i = 5; i >= 0; i--) {
        general_6r_lane sum = J[i][6];
        for (int j = i + 1; j < 6; j++) {
            sum -= J[i][j] * x[j];
        }
        sum /= J[i][i];
        sum = general_6r_max(general_6r_min(sum, zero + 1.0), zero - 1.0);
        x[i] = general_6r_select(general_6r_abs(J[i][i]) > most, sum, zero);
    }
    return least;
}

/* The same damped, for starts far away and for singular solutions: (J' J + d) x = J' error. */
static inline void general_6r_damped_step(general_6r_lane J[6][7], general_6r_lane damping,
    general_6r_lane x[6])
{
    general_6r_lane A[6][7];
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
        const general_6r_lane pivot = 1.0 / (A[i][i] + 1e-30);
        for (int j = i + 1; j < 6; j++) {
            const general_6r_lane factor = A[i][j] * pivot;
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
        x[i] = general_6r_max(general_6r_min(x[i], general_6r_all(1.0)), general_6r_all(-1.0));
    }
}

/* Newton on the loop; what remains in c and s is the best iterate, and its error is returned. */
static inline general_6r_lane general_6r_polish(const general_6r_loop *loop, general_6r_lane c[6],
    general_6r_lane s[6],
                                          int steps, int afar)
{
    general_6r_lane J[6][7], x[6], tc[6], ts[6], least, now;
    for (int i = 0; i < 6; i++) {
        tc[i] = c[i];
        ts[i] = s[i];
    }
    least = now = general_6r_error(loop, c, s, J);
    for (int step = 0; step < steps; step++) {
        general_6r_mask better;
        if (general_6r_largest(least) < 1e-29) {
            break;
        }
        if (afar) {
            general_6r_damped_step(J, general_6r_min(now * 0.01, general_6r_all(0.01)), x);
        } else {
            (void)general_6r_step(J, x);
        }
        for (int i = 0; i < 6; i++) {
            /* a turn by 2 atan(x/2), without trigonometry */
            const general_6r_lane u = 0.25 * x[i] * x[i], f = 1.0 / (1.0 + u);
            const general_6r_lane dc = (1.0 - u) * f, ds = x[i] * f, old = tc[i];
            tc[i] = old * dc - ts[i] * ds;
            ts[i] = ts[i] * dc + old * ds;
        }
        now = general_6r_error(loop, tc, ts, J);
        better = now < least;
        for (int i = 0; i < 6; i++) {
            c[i] = general_6r_select(better, tc[i], c[i]);
            s[i] = general_6r_select(better, ts[i], s[i]);
        }
        least = general_6r_select(better, now, least);
    }
    return general_6r_sqrt(least);
}

/* A bit for each solution. */
typedef unsigned long long general_6r_set;

/* The solutions found so far. Where one is singular many candidates come near to it: there is room
 * for more than there are solutions, the last of it for regular ones. */
typedef struct {
    int count;
    general_6r_set singular, nearly_singular; /* where the arm is */
    int doubles; /* roots that met, or may have */
    double q[64][6], residual[64];
} general_6r_found;

/* Whether two joint vectors differ by less than that, modulo turns. */
static int general_6r_alike(const double a[6], const double b[6], double most)
{
    for (int j = 0; j < 6; j++) {
        const double gap = fabs(a[j] - b[j]);
        if (!(gap < most || 6.283185307179586 - gap < most)) {
            return 0;
        }
    }
    return 1;
}

/* Add a solution unless it is known or none, and mark it where the arm is singular, or nearly; its
 * place, or -1. */
static int general_6r_keep(general_6r_found *found, double theta[6], double residual, double pivot)
{
    const int singular = pivot < 1e-06, nearly = pivot < 0.0001;
    const int room = nearly ? 64 - 16 : 64;
    if (!(residual <= 1e-10)) {
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (general_6r_alike(found->q[i], theta, 1e-06)) {
            if (residual < found->residual[i]) {
                found->residual[i] = residual;
                for (int j = 0; j < 6; j++) {
                    found->q[i][j] = theta[j];
                }
            }
            found->singular |= (general_6r_set)singular << i;
            found->nearly_singular |= (general_6r_set)nearly << i;
            return i;
        }
    }
    if (found->count >= room) {
        return -1;
    }
    found->singular |= (general_6r_set)singular << found->count;
    found->nearly_singular |= (general_6r_set)nearly << found->count;
    found->residual[found->count] = residual;
    for (int j = 0; j < 6; j++) {
        found->q[found->count][j] = theta[j];
    }
    return found->count++;
}

/* Polish candidates, given by cosines and sines, and keep what they lead to: the solutions that
 * were met. `place` takes which solution each candidate became, or -1. With `doubtful` candidates
 * singular solutions are marked. */
static general_6r_set general_6r_offer(const general_6r_loop *loop, general_6r_lane c[6],
    general_6r_lane s[6], int count,
                              int steps, int doubtful, general_6r_found *found,
                              int place[GENERAL_6R_LANES])
{
    double residual[GENERAL_6R_LANES], theta[6][GENERAL_6R_LANES], pivot[GENERAL_6R_LANES];
    general_6r_set met = 0;
    GENERAL_6R_STORE(residual, general_6r_polish(loop, c, s, steps, steps > 4));
    if (doubtful) {
        general_6r_lane J[6][7], x[6];
        (void)general_6r_error(loop, c, s, J);
        GENERAL_6R_STORE(pivot, general_6r_step(J, x));
    } else {
        GENERAL_6R_STORE(pivot, general_6r_all(1.0));
    }
    for (int i = 0; i < 6; i++) {
        const double cosine = general_6r_advance[0][i], sine = general_6r_advance[1][i];
        GENERAL_6R_STORE(theta[i],
                      general_6r_angle(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] * sine));
    }
    for (int k = 0; k < count; k++) {
        double row[6];
        for (int i = 0; i < 6; i++) {
            /* half a turn is +pi, also when rounding says otherwise */
            row[i] = theta[i][k] < -3.141592653589783 ? 3.141592653589793 : theta[i][k];
        }
        place[k] = general_6r_keep(found, row, residual[k], pivot[k]);
        if (place[k] >= 0) {
            met |= (general_6r_set)1 << place[k];
        }
    }
    return met;
}

static int general_6r_bits(general_6r_set set)
{
    int count = 0;
    for (; set; set &= set - 1) {
        count++;
    }
    return count;
}

/* Whether the number of regular solutions is even. */
static int general_6r_paired(const general_6r_found *found)
{
    return (found->count - general_6r_bits(found->singular)) % 2 == 0;
}

/* The links L0 ... L5 of a formulation. */
static void general_6r_around(const general_6r_formulation *form, const general_6r_loop *loop,
                           double link[6][12])
{
    for (int i = 0; i < 6; i++) {
        const int joint = form->joint[i];
        if (form->sign > 0.0 && joint < 5) {
            general_6r_copy(loop->link[joint], link[i]);
        } else if (form->sign > 0.0) {
            general_6r_invert(loop->link[5], link[i]);
        } else if (joint > 0) {
            general_6r_invert(loop->link[joint - 1], link[i]);
        } else {
            general_6r_copy(loop->link[5], link[i]);
        }
    }
}

/* Roots that nearly meet are tried as one double root too. */
static void general_6r_close_roots(const double *E, const general_6r_roots *roots,
    general_6r_candidates *out)
{
    for (int i = 0; i < roots->simple; i++) {
        for (int j = 0; j < i; j++) {
            const double c = roots->c[i] + roots->c[j], s = roots->s[i] + roots->s[j];
            const double square = c * c + s * s;
            if (square > 3.999999) {
                const double factor = 1.0 / sqrt(square);
                general_6r_null_plane(E, c * factor, s * factor, out);
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
static int general_6r_settle(const general_6r_formulation *form, const general_6r_loop *loop,
                          double link[6][12], const general_6r_candidates *all,
                          const general_6r_roots *roots, general_6r_found *found)
{
    double w[5], solve[2][5];
    general_6r_set met = 0, of_group[GENERAL_6R_CANDIDATES] = {0};
    const int simple = roots->simple, touching = roots->doubles + roots->unseen;
    const int doubted = found->doubles > 0;
    int complete = roots->complete, expected = simple, true_doubles = 0;
    general_6r_invariants(link[3], link[4], w, solve);
    for (int from = 0; from < all->count; from += GENERAL_6R_LANES) {
        const int count = all->count - from < GENERAL_6R_LANES ? all->count - from :
            GENERAL_6R_LANES;
        general_6r_lane n[6], c[6], s[6], tc[6], ts[6];
        int place[GENERAL_6R_LANES];
        c[0] = GENERAL_6R_LOAD(all->c + from);
        s[0] = GENERAL_6R_LOAD(all->s + from);
        for (int i = 0; i < 6; i++) {
            n[i] = GENERAL_6R_LOAD(all->n[i] + from);
        }
        general_6r_partners(form->joint, n, c, s);
        general_6r_others(form->joint, link, w, solve, c, s);
        for (int i = 0; i < 6; i++) {
            tc[form->joint[i]] = c[i];
            ts[form->joint[i]] = form->sign * s[i];
        }
        met |= general_6r_offer(loop, tc, ts, count, 4, doubted || from + count > simple, found,
            place);
        for (int k = 0; k < count; k++) {
            if (from + k < simple) {
                complete &= place[k] >= 0;
            } else if (place[k] >= 0) {
                of_group[all->group[from + k]] |= (general_6r_set)1 << place[k];
            }
        }
    }
    for (int i = all->groups - touching; i < all->groups; i++) {
        if (of_group[i] || !all->regular[i]) {
            true_doubles++;
            expected += of_group[i] & found->singular ? 1 : 2;
        }
    }
    complete = complete && general_6r_bits(met) >= expected && general_6r_paired(found);
    found->doubles = complete ? true_doubles : found->doubles + roots->doubles;
    return complete;
}

/* Keeps of angles those where the determinant may vanish: where f only comes near to zero it does
 * not. */
static int general_6r_keep_vanishing(const void *equations, int count, double *cosine, double *sine)
{
    int kept = 0;
    for (int from = 0; from < count; from += GENERAL_6R_LANES) {
        general_6r_lane factor[6][6], x[2][6];
        double c[GENERAL_6R_LANES], s[GENERAL_6R_LANES], regular[GENERAL_6R_LANES],
            apart[GENERAL_6R_LANES];
        for (int k = 0; k < GENERAL_6R_LANES; k++) {
            const int i = from + k < count ? from + k : from;
            c[k] = cosine[i];
            s[k] = sine[i];
        }
        (void)general_6r_fold(equations, GENERAL_6R_LOAD(c), GENERAL_6R_LOAD(s), factor);
        GENERAL_6R_STORE(regular, general_6r_smallest(factor, x));
        GENERAL_6R_STORE(apart, general_6r_independence(equations, GENERAL_6R_LOAD(c),
            GENERAL_6R_LOAD(s)));
        for (int k = 0; k < GENERAL_6R_LANES && from + k < count; k++) {
            if (regular[k] < 1.0 || !(apart[k] > 8.999999999999999e-08)) {
                cosine[kept] = c[k];
                sine[kept++] = s[k];
            }
        }
    }
    return kept;
}

/* The determinant at the sample angles, through a lens. */
static void general_6r_sample(const void *equations, const general_6r_lens *lens, double
    samples[24])
{
    for (int k = 0; k < 24; k += GENERAL_6R_LANES) {
        general_6r_lane factor[6][6];
        general_6r_lane c = GENERAL_6R_LOAD(general_6r_sample_c + k), s =
            GENERAL_6R_LOAD(general_6r_sample_s + k);
        const general_6r_lane square = general_6r_through(lens, &c, &s);
        const general_6r_lane determinant = general_6r_fold(equations, c, s, factor);
        GENERAL_6R_STORE(samples + k, general_6r_weighted(determinant, square));
    }
}

/* Find what a formulation finds; whether that is certainly everything. */
static int general_6r_attempt(const general_6r_formulation *form, const general_6r_loop *loop,
                           general_6r_found *found)
{
    double link[6][12], E[192];
    const general_6r_source source = { general_6r_sample, general_6r_keep_vanishing, E};
    general_6r_roots roots, beside;
    general_6r_candidates all;
    general_6r_around(form, loop, link);
    if (form->left) {
        general_6r_equations(form, link, form->left, E);
    } else {
        double left[15][32];
        general_6r_left_side(form, link, left);
        general_6r_equations(form, link, (const double (*)[32])left, E);
    }
    if (!general_6r_real_roots(&source, &roots)) {
        return 0;
    }
    beside.simple = all.count = all.groups = 0;
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        general_6r_separate(E, roots.double_c[i], roots.double_s[i], &beside);
    }
    general_6r_null_vectors(E, &roots, &all);
    general_6r_null_vectors(E, &beside, &all);
    general_6r_close_roots(E, &roots, &all);
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        general_6r_null_plane(E, roots.double_c[i], roots.double_s[i], &all);
    }
    /* lanes behind the last candidate hold the first one */
    for (int k = all.count; k % GENERAL_6R_LANES; k++) {
        all.c[k] = all.c[0];
        all.s[k] = all.s[0];
        for (int i = 0; i < 6; i++) {
            all.n[i][k] = all.n[i][0];
        }
    }
    return general_6r_settle(form, loop, link, &all, &roots, found);
}

/* Find what the methods find, one after the other, until that is certainly everything. */
static int general_6r_try(const general_6r_loop *loop, general_6r_found *found)
{
    int complete = 0;
    for (int i = 0; i < 2 && !complete; i++) {
        complete = general_6r_attempt(&general_6r_formulations[i], loop, found);
    }
    return complete;
}

/* Newton from joint angles (count, 6) far from or near to solutions. */
static general_6r_set general_6r_follow_back(const general_6r_loop *loop, double (*start)[6], int
    count,
                                    general_6r_found *found, int *lost)
{
    general_6r_set met = 0;
    for (int from = 0; from < count; from += GENERAL_6R_LANES) {
        const int now = count - from < GENERAL_6R_LANES ? count - from : GENERAL_6R_LANES;
        double cs[2][6][GENERAL_6R_LANES];
        general_6r_lane c[6], s[6];
        int place[GENERAL_6R_LANES];
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < GENERAL_6R_LANES; k++) {
                const double angle = start[from + (k < now ? k : 0)][i];
                const double cosine = cos(angle), sine = sin(angle);
                cs[0][i][k] = cosine * general_6r_advance[0][i] + sine * general_6r_advance[1][i];
                cs[1][i][k] = sine * general_6r_advance[0][i] - cosine * general_6r_advance[1][i];
            }
            c[i] = GENERAL_6R_LOAD(cs[0][i]);
            s[i] = GENERAL_6R_LOAD(cs[1][i]);
        }
        met |= general_6r_offer(loop, c, s, now, 40, 1, found, place);
        for (int k = 0; k < now; k++) {
            *lost += place[k] < 0;
        }
    }
    return met;
}

/* Solve poses close by, and follow their solutions back. Where two solutions meet they are on one
 * side only: both sides have to have as many as are found. Around a singular pose none of them has
 * to have all solutions: then all are looked at. */
static int general_6r_from_nearby(const general_6r_loop *loop, general_6r_found *found)
{
    int followed = 0, before = -1;
    for (int n = 0; n < 10; n++) {
        general_6r_loop nearby = *loop;
        general_6r_found other;
        int complete, count = -1, lost = 0;
        general_6r_set met;
        general_6r_then(nearby.link[5], general_6r_nudge[n]);
        other.count = 0;
        other.singular = other.nearly_singular = 0;
        other.doubles = 0;
        complete = general_6r_try(&nearby, &other);
        met = general_6r_follow_back(loop, other.q, other.count, found, &lost);
        if (complete && !lost && met) {
            count = general_6r_bits(met) == other.count ? other.count : -1;
            followed |= (met & found->singular) != 0;
        }
        if (n % 2 && before == found->count && count == found->count && !found->singular &&
            general_6r_paired(found)) {
            return 1;
        }
        before = count;
    }
    return followed && general_6r_paired(found);
}

/* Newton from many starts, the same on every run. */
static void general_6r_from_anywhere(const general_6r_loop *loop, general_6r_found *found)
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
        (void)general_6r_follow_back(loop, start, 8, found, &lost);
    }
}

/* What comes first where there are more than there are rows: 0 for regular solutions, 1 for
 * singular ones or nearly so, 2 for those that lie together with one of these and may be the same,
 * which only its last digits tell. */
static void general_6r_rank(const general_6r_found *found, int rank[64])
{
    for (int i = 0; i < found->count; i++) {
        rank[i] = (int)(found->nearly_singular >> i & 1);
        for (int j = 0; j < i && rank[i] == 1; j++) {
            if (rank[j] == 1 && general_6r_alike(found->q[i], found->q[j], 0.001)) {
                rank[i] = 2;
            }
        }
    }
}

/* Whether solution i comes before solution j: by rank, then by the first angle, angles that agree
 * to rounding by the next. */
static int general_6r_before(const general_6r_found *found, const int *rank, int i, int j)
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
static int general_6r_general(const double T[16], double q[16][6],
                         double residual[16])
{
    general_6r_found found;
    general_6r_loop whole;
    const general_6r_loop *const loop = &whole;
    int rank[64], order[64], certified, inexact = 0;
    general_6r_close(T, &whole);
    found.count = 0;
    found.singular = found.nearly_singular = 0;
    found.doubles = 0;
    const double *const P = loop->link[5];
    if (P[3] * P[3] + P[7] * P[7] + P[11] * P[11] > 4.000000004) {
        return 0;
    }
    certified = general_6r_try(loop, &found);
    if (!certified && !general_6r_from_nearby(loop, &found)) {
        general_6r_from_anywhere(loop, &found);
    }
    general_6r_rank(&found, rank);
    for (int i = 0; i < found.count; i++) {
        int j = i;
        for (; j > 0 && general_6r_before(&found, rank, i, order[j - 1]); j--) {
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
    static const double zero[6] = { 2.137, -2.341, -1.611, 0.482, 0.126, 1.904 };
    struct descent d = { .T = T };
    struct kept kept = { .count = 0 };
    double angles[16][6], residual[16], u[6];
    const int count = general_6r_general(T, angles, residual);
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
    d1 = -0.035, /* joint offset 1 [m] */
    a1 = 0.416, /* link length 1 [m] */
    ca1 = 0.21607853588096199, /* cosine of twist 1 */
    sa1 = 0.9763759861505914, /* sine of twist 1 */
    d2 = -0.257, /* joint offset 2 [m] */
    a2 = -0.339, /* link length 2 [m] */
    ca2 = 0.9781157489708037, /* cosine of twist 2 */
    sa2 = 0.20806148517994336, /* sine of twist 2 */
    d3 = -0.272, /* joint offset 3 [m] */
    a3 = 0.075, /* link length 3 [m] */
    ca3 = 0.8053132584046545, /* cosine of twist 3 */
    sa3 = 0.5928495220860671, /* sine of twist 3 */
    d4 = 0.262, /* joint offset 4 [m] */
    a4 = -0.28, /* link length 4 [m] */
    ca4 = 0.45217616214091205, /* cosine of twist 4 */
    sa4 = 0.8919286509533796, /* sine of twist 4 */
    d5 = -0.167, /* joint offset 5 [m] */
    a5 = -0.136, /* link length 5 [m] */
    ca5 = 0.9895059058723947, /* cosine of twist 5 */
    sa5 = 0.1444924297105264, /* sine of twist 5 */
    d6 = -0.477, /* joint offset 6 [m] */
    a6 = 0.175, /* link length 6 [m] */
    ca6 = 0.13835111738308337, /* cosine of twist 6 */
    sa6 = 0.9903832431533018, /* sine of twist 6 */
    offset1 = 2.137, /* offset of joint 1 [rad] */
    offset2 = -2.341, /* offset of joint 2 [rad] */
    offset3 = -1.611, /* offset of joint 3 [rad] */
    offset4 = 0.482, /* offset of joint 4 [rad] */
    offset5 = 0.126, /* offset of joint 5 [rad] */
    offset6 = 1.904, /* offset of joint 6 [rad] */
    f1 = -0.05553218372140723, /* d2 * ca1 [m] */
    f2 = 0.04495762109090063, /* sa2 * ca1 */
    f3 = 0.2113498189597218; /* ca2 * ca1 */

const char *const general_6r_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void general_6r_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        y2_x = v5 * ca2 + z1_x * sa2, v8 = v6 * ca2 + v3 * sa2, y2_z = f2 - v7 * ca2,
        z2_x = v5 * sa2 - z1_x * ca2, z2_y = v3 * ca2 - v6 * sa2, v9 = v7 * sa2 + f3,
        v10 = q[2] + offset3;
    const double c3 = cos(v10), s3 = sin(v10), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v8 * s3, x3_z = x2_z * c3 + y2_z * s3, v11 = y2_x * c3 - x2_x * s3,
        v12 = v8 * c3 + x2_y * s3, v13 = y2_z * c3 - x2_z * s3, v14 = v11 * ca3 + z2_x * sa3,
        y3_y = v12 * ca3 - z2_y * sa3, y3_z = v9 * sa3 - v13 * ca3, z3_x = v11 * sa3 - z2_x * ca3,
        v15 = v12 * sa3 + z2_y * ca3, z3_z = v13 * sa3 + v9 * ca3, v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 - v14 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v17 = v14 * c4 + x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 - x3_z * s4, y4_x = v17 * ca4 - z3_x * sa4,
        y4_y = v15 * sa4 - v18 * ca4, v20 = v19 * ca4 + z3_z * sa4, v21 = v17 * sa4 + z3_x * ca4,
        z4_y = v18 * sa4 + v15 * ca4, z4_z = v19 * sa4 - z3_z * ca4, v22 = q[4] + offset5;
    const double c5 = cos(v22), s5 = sin(v22), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v20 * s5, v23 = y4_x * c5 - x4_x * s5,
        v24 = y4_y * c5 - x4_y * s5, v25 = v20 * c5 + x4_z * s5, y5_x = v23 * ca5 - v21 * sa5,
        y5_y = v24 * ca5 + z4_y * sa5, y5_z = z4_z * sa5 - v25 * ca5, v26 = v23 * sa5 + v21 * ca5,
        z5_y = z4_y * ca5 - v24 * sa5, z5_z = v25 * sa5 + z4_z * ca5, v27 = q[5] + offset6;
    const double c6 = cos(v27), s6 = sin(v27), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6, v28 = y5_x * c6 - x5_x * s6,
        v29 = y5_y * c6 - x5_y * s6, v30 = y5_z * c6 - x5_z * s6;
    T[0] = x6_x; T[1] = v28 * ca6 - v26 * sa6; T[2] = -(v28 * sa6 + v26 * ca6);
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x *
        a5 - v21 * d5 + x6_x * a6 - v26 * d6;
    T[4] = x6_y; T[5] = v29 * ca6 + z5_y * sa6; T[6] = z5_y * ca6 - v29 * sa6;
    T[7] = s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 + z2_y * d3 + x4_y * a4 - v15 * d4 + x5_y * a5
        + z4_y * d5 + x6_y * a6 + z5_y * d6;
    T[8] = x6_z; T[9] = v30 * ca6 + z5_z * sa6; T[10] = z5_z * ca6 - v30 * sa6;
    T[11] = d1 + x2_z * a2 + f1 + x3_z * a3 - v9 * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z *
        d5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void general_6r_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), p1_x = c1 * a1, p1_y = s1 * a1, v2 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        p2_x = p1_x + x2_x * a2 + z1_x * d2, p2_y = p1_y + x2_y * a2 - v3 * d2,
        p2_z = d1 + x2_z * a2 + f1, y2_x = v5 * ca2 + z1_x * sa2, v8 = v6 * ca2 + v3 * sa2,
        y2_z = f2 - v7 * ca2, z2_x = v5 * sa2 - z1_x * ca2, z2_y = v3 * ca2 - v6 * sa2,
        v9 = v7 * sa2 + f3, v10 = q[2] + offset3;
    const double c3 = cos(v10), s3 = sin(v10), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v8 * s3, x3_z = x2_z * c3 + y2_z * s3, v11 = y2_x * c3 - x2_x * s3,
        v12 = v8 * c3 + x2_y * s3, v13 = y2_z * c3 - x2_z * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 + z2_y * d3, p3_z = p2_z + x3_z * a3 - v9 * d3,
        v14 = v11 * ca3 + z2_x * sa3, y3_y = v12 * ca3 - z2_y * sa3, y3_z = v9 * sa3 - v13 * ca3,
        z3_x = v11 * sa3 - z2_x * ca3, v15 = v12 * sa3 + z2_y * ca3, z3_z = v13 * sa3 + v9 * ca3,
        v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 - v14 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v17 = v14 * c4 + x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 - x3_z * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 - v15 * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, y4_x = v17 * ca4 - z3_x * sa4,
        y4_y = v15 * sa4 - v18 * ca4, v20 = v19 * ca4 + z3_z * sa4, v21 = v17 * sa4 + z3_x * ca4,
        z4_y = v18 * sa4 + v15 * ca4, z4_z = v19 * sa4 - z3_z * ca4, v22 = q[4] + offset5;
    const double c5 = cos(v22), s5 = sin(v22), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v20 * s5, v23 = y4_x * c5 - x4_x * s5,
        v24 = y4_y * c5 - x4_y * s5, v25 = v20 * c5 + x4_z * s5, p5_x = p4_x + x5_x * a5 - v21 * d5,
        p5_y = p4_y + x5_y * a5 + z4_y * d5, p5_z = p4_z + x5_z * a5 + z4_z * d5,
        v26 = v23 * sa5 + v21 * ca5, z5_y = z4_y * ca5 - v24 * sa5, z5_z = v25 * sa5 + z4_z * ca5,
        v27 = q[5] + offset6;
    const double c6 = cos(v27), s6 = sin(v27),
        p6_x = p5_x + (x5_x * c6 + (v23 * ca5 - v21 * sa5) * s6) * a6 - v26 * d6,
        p6_y = p5_y + (x5_y * c6 + (v24 * ca5 + z4_y * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 + (z4_z * sa5 - v25 * ca5) * s6) * a6 + z5_z * d6,
        v28 = p6_x - p1_x, v29 = p6_y - p1_y, v30 = p6_z - d1, v31 = p6_x - p2_x, v32 = p6_y - p2_y,
        v33 = p6_z - p2_z, v34 = p6_x - p3_x, v35 = p6_y - p3_y, v36 = p6_z - p3_z,
        v37 = p6_x - p4_x, v38 = p6_y - p4_y, v39 = p6_z - p4_z, v40 = p6_x - p5_x,
        v41 = p6_y - p5_y, v42 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(v3 * v30 + ca1 * v29); J[2] = z2_y * v33 + v9 * v32;
    J[3] = -(v15 * v36 + z3_z * v35); J[4] = z4_y * v39 - z4_z * v38;
    J[5] = z5_y * v42 - z5_z * v41;
    J[6] = p6_x; J[7] = ca1 * v28 - z1_x * v30; J[8] = -(v9 * v31 + z2_x * v33);
    J[9] = z3_z * v34 - z3_x * v36; J[10] = z4_z * v37 + v21 * v39; J[11] = z5_z * v40 + v26 * v42;
    J[12] = 0.0; J[13] = z1_x * v29 + v3 * v28; J[14] = z2_x * v32 - z2_y * v31;
    J[15] = z3_x * v35 + v15 * v34; J[16] = -(v21 * v38 + z4_y * v37);
    J[17] = -(v26 * v41 + z5_y * v40);
    J[18] = 0.0; J[19] = z1_x; J[20] = z2_x; J[21] = z3_x; J[22] = -v21; J[23] = -v26;
    J[24] = 0.0; J[25] = -v3; J[26] = z2_y; J[27] = -v15; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = ca1; J[32] = -v9; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
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

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[6], double q[16][6], unsigned char status[16])
{

    /* all joints: the general 6R loop */
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
        /* all joints: the general 6R loop */
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
    double value = given;
    if (fabs(towards) < 100000.0)
        value += turn * floor((towards - given) / turn + 0.5);
    value -= turn * ceil(fmax(value - high, 0.0) / turn);
    value += turn * ceil(fmax(low - value, 0.0) / turn);
    return value <= high ? value : given;
}

int general_6r_ik(
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
        for (int i = 0; i < 6; i++) {
            double *value = &q[row][i];
            if (!(lowest[i] <= *value && *value <= highest[i]))
                *value = turned(i, *value, *value);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int general_6r_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = general_6r_ik(T, q_seed, all, status) >= 0;
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
            distance += moved * moved;
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

void general_6r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)general_6r_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
