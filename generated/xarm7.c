/* xarm7: UFACTORY xArm 7
 *
 * Inverse kinematics, generated from robots/xarm7.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/xarm7.yaml. The formulas and where they come from: xarm7.md.
 */
#include "xarm7.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = XARM7_OK, NONE = XARM7_UNREACHABLE, FREE = XARM7_FREE_JOINT,
    OUT = XARM7_OUT_OF_LIMITS, INVALID = XARM7_INVALID_POSE
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
static const int solved[6] = { 0, 1, 3, 4, 5, 6 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.8295313148071338, 0.8295313148071338, 0.8295313148071338, 0.8295313148071338,
    0.8295313148071338, 0.8295313148071338,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[7], seed[6]; /* all joint values; the seed in units */
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
    double P[16], J[42], square = 0.0;
    for (int j = 0; j < 6; j++)
        d->q[solved[j]] = unit[j] * u[j];
    xarm7_fk(d->q, P);
    xarm7_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 1.2055000000000002;
        for (int j = 0; j < 6; j++)
            d->A[i][j] = measure[j] * J[7 * row + solved[j]];
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
            d->A[3 + i][j] = J[7 * (3 + i) + solved[j]];
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
static int stands_before(const double a[7], const double b[7])
{
    for (int i = 0; i < 7; i++)
        if (fabs(a[i] - b[i]) > 1e-09)
            return a[i] < b[i];
    return 0;
}

/* Rows by the first joint, then by the second and so on. */
static void sorted_rows(
    struct descent *d, const struct kept *kept, double q[16][7], int found[16],
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
            for (int i = 0; i < 7; i++)
                q[row][i] = q[row - 1][i];
        }
        found[k] = 1;
        chosen[row] = kept->chosen[k];
        for (int i = 0; i < 7; i++)
            q[row][i] = d->q[i];
    }
}

/* The general 6R algorithm: all solutions, at most 16, of an arm without three concurrent or
 * parallel axes. M. Raghavan and B. Roth (1993): six equations in the hidden joint and two
 * partners, a determinant of degree 8 in the hidden joint; here it is sampled at 24 angles.
 *
 * The loop J(q1) K0 J(q2) ... K4 J(q6) = P, in units of the arm's size, P = L T R. Everything
 * below that has the type xarm7_lane does XARM7_LANES angles or candidates at once.
 */
/* Lanes: GNU vectors where the compiler has them, plain doubles otherwise. Vectors wider than the
 * machine's are slow: compile for the machine, or set XARM7_LANES to 1, 2, 4 or 8. */
#ifndef XARM7_LANES
#if defined(__GNUC__) && defined(__AVX512F__)
#define XARM7_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define XARM7_LANES 4
#elif defined(__GNUC__) && defined(__SSE2__)
#define XARM7_LANES 2
#else
#define XARM7_LANES 1
#endif
#endif

#if XARM7_LANES > 1 && defined(__SSE2__)
#include <immintrin.h>
#endif

/* Loops of few rounds over lanes: compilers leave them as they are where there are many operations,
 * and what could stay in registers goes through memory. */
#if XARM7_LANES == 1 || defined(__OPTIMIZE_SIZE__)
#define XARM7_UNROLL
#elif defined(__clang__)
#define XARM7_UNROLL _Pragma("clang loop unroll(full)")
#elif __GNUC__ >= 8
#define XARM7_UNROLL _Pragma("GCC unroll 16")
#else
#define XARM7_UNROLL
#endif

#define XARM7_ROOTS 24
#define XARM7_CANDIDATES 144

#if XARM7_LANES > 1
typedef double xarm7_lane __attribute__((vector_size(8 * XARM7_LANES)));
typedef long long xarm7_mask __attribute__((vector_size(8 * XARM7_LANES)));
/* the same where it lies between other doubles */
typedef double xarm7_packed
    __attribute__((vector_size(8 * XARM7_LANES), aligned(8), may_alias));
/* arrays that begin where a lane may, so that no lane crosses the border of two cache lines */
#define XARM7_ALIGNED __attribute__((aligned(8 * XARM7_LANES)))
#define XARM7_LOAD(from) \
    (xarm7_lane)(*(const xarm7_packed *)(from))
#define XARM7_STORE(to, x) \
    (*(xarm7_packed *)(to) = (xarm7_packed)(x))

static inline xarm7_lane xarm7_select(xarm7_mask m, xarm7_lane a, xarm7_lane b)
{
    return (xarm7_lane)((m & (xarm7_mask)a) | (~m & (xarm7_mask)b));
}

static inline xarm7_lane xarm7_abs(xarm7_lane x)
{
    return (xarm7_lane)((xarm7_mask)x & 0x7fffffffffffffffLL);
}

/* the magnitude of the first with the sign of the second */
static inline xarm7_lane xarm7_with_sign(xarm7_lane x, xarm7_lane y)
{
    const xarm7_mask sign = (xarm7_mask)y & (-0x7fffffffffffffffLL - 1);
    return (xarm7_lane)(((xarm7_mask)x & 0x7fffffffffffffffLL) | sign);
}

/* the first, turned round where the second is negative */
static inline xarm7_lane xarm7_facing(xarm7_lane x, xarm7_lane y)
{
    const xarm7_mask sign = (xarm7_mask)y & (-0x7fffffffffffffffLL - 1);
    return (xarm7_lane)((xarm7_mask)x ^ sign);
}

/* by the machine's own instruction: compilers take sqrt of <math.h> one by one, for the sake of
 * errno */
static inline xarm7_lane xarm7_sqrt(xarm7_lane x)
{
#if XARM7_LANES == 8 && defined(__AVX512F__)
    return (xarm7_lane)_mm512_sqrt_pd((__m512d)x);
#elif XARM7_LANES == 4 && defined(__AVX__)
    return (xarm7_lane)_mm256_sqrt_pd((__m256d)x);
#elif XARM7_LANES == 2 && defined(__SSE2__)
    return (xarm7_lane)_mm_sqrt_pd((__m128d)x);
#else
    xarm7_lane r = x;
    for (int k = 0; k < XARM7_LANES; k++) {
        r[k] = sqrt(x[k]);
    }
    return r;
#endif
}
#else
typedef double xarm7_lane;
typedef int xarm7_mask;
#define XARM7_ALIGNED
#define XARM7_LOAD(from) (*(from))
#define XARM7_STORE(to, x) (*(to) = (x))

static inline xarm7_lane xarm7_select(xarm7_mask m, xarm7_lane a, xarm7_lane b)
{
    return m ? a : b;
}

static inline xarm7_lane xarm7_abs(xarm7_lane x)
{
    return fabs(x);
}

static inline xarm7_lane xarm7_with_sign(xarm7_lane x, xarm7_lane y)
{
    return copysign(x, y);
}

static inline xarm7_lane xarm7_facing(xarm7_lane x, xarm7_lane y)
{
    return y < 0.0 ? -x : x;
}

static inline xarm7_lane xarm7_sqrt(xarm7_lane x)
{
    return sqrt(x);
}
#endif

static inline xarm7_lane xarm7_all(double x)
{
    const xarm7_lane zero = {0};
    return zero + x;
}

static inline xarm7_lane xarm7_max(xarm7_lane a, xarm7_lane b)
{
    return xarm7_select(a > b, a, b);
}

static inline xarm7_lane xarm7_min(xarm7_lane a, xarm7_lane b)
{
    return xarm7_select(a < b, a, b);
}

/* the largest of all lanes */
static inline double xarm7_largest(xarm7_lane x)
{
    double each[XARM7_LANES], most;
    XARM7_STORE(each, x);
    most = each[0];
    for (int k = 1; k < XARM7_LANES; k++) {
        most = each[k] > most ? each[k] : most;
    }
    return most;
}

/* The angle of a sine and a cosine with any positive common factor, in (-pi, pi], within 3 ulp:
 * atan of a ratio below tan(pi/8) by a polynomial. */
static inline xarm7_lane xarm7_angle(xarm7_lane y, xarm7_lane x)
{
    static const double odd[] = { -0.3333333333333333, 0.19999999999995513, -0.14285714284665177,
        0.11111111015146682, -0.0909090457366891, 0.07692183087347286, -0.0666450998991572,
        0.05858136252639731, -0.050853834915688644, 0.039229744582632814, -0.01917454359469326 };
    const xarm7_lane ax = xarm7_abs(x), ay = xarm7_abs(y), zero = {0};
    const xarm7_mask steep = ay > ax;
    const xarm7_lane high = xarm7_select(steep, ay, ax), low = xarm7_select(steep, ax, ay);
    const xarm7_mask turned = low > high * 0.41421356237309515;
    const xarm7_lane up = xarm7_select(turned, low - high, low);
    const xarm7_lane down = xarm7_select(turned, low + high, high);
    const xarm7_lane r = up / (down + 1e-300), u = r * r;
    xarm7_lane a = xarm7_all(odd[10]);
    for (int k = 9; k >= 0; k--) {
        a = a * u + odd[k];
    }
    a = r + r * u * a + xarm7_select(turned, zero + 0.7853981633974483, zero);
    a = xarm7_select(steep, 1.5707963267948966 - a, a);
    a = xarm7_select(x < 0.0, 3.141592653589793 - a, a);
    return xarm7_with_sign(a, y + 0.0);
}

/* The loop: K0 ... K4 and the pose, three rows of four. */
typedef struct {
    double link[6][12];
} xarm7_loop;

/* A formulation: the joints phi_1 (hidden) ... phi_6 are, from 0; phi = sign q, -1 reads the loop
 * backwards. */
typedef struct {
    int joint[6];
    double sign;
} xarm7_formulation;

static const xarm7_formulation xarm7_formulations[2] = {
    { { 3, 2, 1, 0, 5, 4 }, -1.0 },
    { { 0, 1, 2, 3, 4, 5 }, 1.0 },
};

/* The constants K0 ... K4 of the loop, L and R, three rows of four; for those with joints inside
 * whose values are given, what stands before, between and behind these. */
static const double xarm7_constant[8][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9230769230769231,
        0.38461538461538464, 0.0, 1.8215640973187067e-10 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.14326909828113846, 0.0, 0.0, -1.0, 0.0,
        0.8823529411764706, 0.47058823529411764, 0.0, 0.7995780151690203 },
    { 0.28, -0.96, 0.0, 0.21149247841501392, 0.0, 0.0, -1.0, -0.4673301538586307, 0.96, 0.28, 0.0,
        0.0 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.7241379310344828,
        0.6896551724137931, 0.0, 0.4673301539754631 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.20739907560698137, 0.0, 0.0, 1.0, 0.0,
        -0.9459459459459459, -0.32432432432432434, 0.0, 0.0 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.26699999993325 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.097 },
};

/* cosine and sine of what is to be added to each joint's angle in the loop */
static const double xarm7_advance[2][6] = {
    { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        },
    { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459 },
};

/* poses close by, for those at which the formulations fail */
static const double xarm7_nudge[10][12] = {
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
static const double xarm7_sample_c[24] XARM7_ALIGNED = {
    1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386,
        0.9659258262890682
};

static const double xarm7_sample_s[24] XARM7_ALIGNED = {
    0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0,
        0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207
};

/* from the samples to a_0, a_1 ... a_8, b_1 ... b_8 and seven numbers that would be zero without
 * rounding: one row for each sample */
static const double xarm7_harmonics[24][24] XARM7_ALIGNED = {
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
static const double xarm7_grid_c[8][128] XARM7_ALIGNED = {
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

static const double xarm7_grid_s[8][128] XARM7_ALIGNED = {
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
static inline void xarm7_compose(const double A[12], const double B[12], double C[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j] +
                           (j == 3 ? A[4 * i + 3] : 0.0);
        }
    }
}

static inline void xarm7_invert(const double A[12], double B[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            B[4 * i + j] = A[4 * j + i];
        }
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11]);
    }
}

/* T, three rows of four, becomes T Rz. */
static inline void xarm7_then_turn(double T[12], double c, double s)
{
    for (int i = 0; i < 12; i += 4) {
        const double x = T[i];
        T[i] = x * c + T[i + 1] * s;
        T[i + 1] = T[i + 1] * c - x * s;
    }
}

static inline void xarm7_copy(const double A[12], double B[12])
{
    for (int i = 0; i < 12; i++) {
        B[i] = A[i];
    }
}

/* A becomes A B. */
static inline void xarm7_then(double A[12], const double B[12])
{
    double C[12];
    xarm7_compose(A, B, C);
    xarm7_copy(C, A);
}

/* The links K0 ... K4 of the loop and its pose P = L T R, in arm sizes. */
static void xarm7_close(const double T[16], const double free_joints[1], xarm7_loop *loop)
{
    double *const P = loop->link[5], right[12];
    const double given_0 = free_joints[0];
    const double c_0 = cos(given_0), s_0 = sin(given_0);
    xarm7_copy(xarm7_constant[0], loop->link[0]);
    xarm7_copy(xarm7_constant[1], loop->link[1]);
    xarm7_then_turn(loop->link[1], c_0, s_0);
    xarm7_then(loop->link[1], xarm7_constant[2]);
    xarm7_copy(xarm7_constant[3], loop->link[2]);
    xarm7_copy(xarm7_constant[4], loop->link[3]);
    xarm7_copy(xarm7_constant[5], loop->link[4]);
    xarm7_copy(xarm7_constant[6], P);
    xarm7_copy(xarm7_constant[7], right);
    xarm7_then(P, T);
    xarm7_then(P, right);
    for (int i = 3; i < 12; i += 4) {
        P[i] *= 2.728935205355018;
    }
}

/* a rigid transform for each lane */
typedef xarm7_lane xarm7_rigid[3][4];

/* T Rz */
static inline void xarm7_turn(xarm7_rigid T, xarm7_lane c, xarm7_lane s)
{
    for (int i = 0; i < 3; i++) {
        const xarm7_lane x = T[i][0];
        T[i][0] = x * c + T[i][1] * s;
        T[i][1] = T[i][1] * c - x * s;
    }
}

/* The motion of a joint: by its cosine and sine, or by a length that stands in the sine's place. */
static inline void xarm7_move(xarm7_rigid T, int joint, xarm7_lane c, xarm7_lane s)
{
    (void)joint;
    xarm7_turn(T, c, s);
}

/* T K, the same K for every lane */
static inline void xarm7_follow(xarm7_rigid T, const double K[12])
{
    for (int i = 0; i < 3; i++) {
        const xarm7_lane x = T[i][0], y = T[i][1], z = T[i][2];
        for (int j = 0; j < 3; j++) {
            T[i][j] = x * K[j] + y * K[4 + j] + z * K[8 + j];
        }
        T[i][3] += x * K[3] + y * K[7] + z * K[11];
    }
}

static inline void xarm7_begin(xarm7_rigid T, const double K[12])
{
    for (int i = 0; i < 12; i++) {
        T[i / 4][i % 4] = xarm7_all(K[i]);
    }
}

/* A cosine and a sine without their common factor, which is told while it has a square. */
static inline void xarm7_to_unit(xarm7_lane *c, xarm7_lane *s)
{
    const xarm7_lane square = *c * *c + *s * *s, factor = 1.0 / xarm7_sqrt(square + 1e-300);
    const xarm7_mask told = (square > 1e-300) & (square < 9.999999999999999e+299);
    *c = xarm7_select(told, *c * factor, xarm7_all(1.0));
    *s = xarm7_select(told, *s * factor, xarm7_all(0.0));
}

/* Reflect `rows` rows of a matrix with `columns` columns so that below the first, `column` becomes
 * zero; row[i] points to the i-th of them. Returns the new diagonal. Sums are of two halves, so
 * that half as many operations wait for each other. */
static inline xarm7_lane xarm7_reflect(xarm7_lane *const *row, int rows, int column, int columns)
{
    xarm7_lane axis[6], half[2], length, factor;
    for (int i = 0; i < 6; i++) {
        axis[i] = half[i % 2] = xarm7_all(0.0); /* compilers don't see that `rows` of them are used
            */
    }
    XARM7_UNROLL
    for (int i = 0; i < rows; i++) {
        axis[i] = row[i][column];
        half[i % 2] += axis[i] * axis[i];
    }
    length = xarm7_with_sign(xarm7_sqrt(half[0] + half[1]), axis[0]);
    axis[0] += length;
    factor = 1.0 / (length * axis[0] + 1e-300);
    XARM7_UNROLL
    for (int j = column + 1; j < columns; j++) {
        xarm7_lane sum;
        half[0] = axis[0] * row[0][j];
        half[1] = axis[1] * row[1][j];
        XARM7_UNROLL
        for (int i = 2; i < rows; i++) {
            half[i % 2] += axis[i] * row[i][j];
        }
        sum = (half[0] + half[1]) * factor;
        XARM7_UNROLL
        for (int i = 0; i < rows; i++) {
            row[i][j] -= axis[i] * sum;
        }
    }
    row[0][column] = -length;
    return -length;
}

/* The features of a point and a direction, at once for several columns: 1, l, p, p.p, p.l, p x l
 * and (p.p) l - 2 (p.l) p, as a rigid motion acts on them. */
static inline void xarm7_act(const double K[12], xarm7_lane x[15])
{
    const double t[3] = {K[3], K[7], K[11]};
    const double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    xarm7_lane u[3], q[3], v[3], w[3], along;
    XARM7_UNROLL
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
    XARM7_UNROLL
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        x[1 + i] = u[i];
        x[4 + i] = q[i] + t[i] * x[0];
        x[9 + i] = v[i] + (t[i1] * u[i2] - t[i2] * u[i1]);
        x[12 + i] = w[i] - 2.0 * (t[i] * x[8] + (t[i1] * v[i2] - t[i2] * v[i1])) + square * u[i];
    }
}

/* What a joint that turns makes of features: the coefficients of 1, cos and sin of its angle. */
static inline void xarm7_cosines(const xarm7_lane x[15], xarm7_lane part[3][15])
{
    static const int vector[4] = {1, 4, 9, 12};
    const xarm7_lane zero = {0};
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
static inline void xarm7_tangents(const xarm7_lane x[15], xarm7_lane part[3][15])
{
    xarm7_cosines(x, part);
    for (int i = 0; i < 15; i++) {
        const xarm7_lane one = part[0][i], cosine = part[1][i];
        part[0][i] = one - cosine;
        part[1][i] = 2.0 * part[2][i];
        part[2][i] = one + cosine;
    }
}

typedef void xarm7_joint_parts(const xarm7_lane x[15], xarm7_lane part[3][15]);

/* Columns of features, 16 places wide, pass a link, and each becomes three by what the joint before
 * it does: column a columns + k of those to come, `width` places wide, is part a of column k. */
static void xarm7_pass(const double K[12], const double from[240], int columns,
                         xarm7_joint_parts *parts, double *to, int width)
{
    /* from the last on, so that what runs over is written again */
    for (int k = (columns - 1) / XARM7_LANES * XARM7_LANES; k >= 0; k -= XARM7_LANES) {
        xarm7_lane x[15], part[3][15];
        for (int i = 0; i < 15; i++) {
            x[i] = XARM7_LOAD(from + 16 * i + k);
        }
        xarm7_act(K, x);
        parts(x, part);
        for (int i = 0; i < 15; i++) {
            for (int a = 0; a < 3; a++) {
                XARM7_STORE(to + width * i + a * columns + k, part[a][i]);
            }
        }
    }
}

/* Reflections that clear the columns of A, one after the other and all that follow in lanes; `axis`
 * and `factor` say how to reflect others. The products of a column with all are summed at once, its
 * own square among them. */
static inline void xarm7_clear(double A[8][8], int rows, int columns, double axis[6][8],
                                 double factor[6])
{
    XARM7_UNROLL
    for (int c = 0; c < columns; c++) {
        const int first = c / XARM7_LANES * XARM7_LANES;
        double product[8], length;
        XARM7_UNROLL
        for (int i = c; i < rows; i++) {
            axis[c][i] = A[i][c];
        }
        XARM7_UNROLL
        for (int j = first; j < columns; j += XARM7_LANES) {
            xarm7_lane sum = xarm7_all(0.0);
            XARM7_UNROLL
            for (int i = c; i < rows; i++) {
                sum += axis[c][i] * XARM7_LOAD(&A[i][j]);
            }
            XARM7_STORE(&product[j], sum);
        }
        length = copysign(sqrt(product[c]), axis[c][c]);
        axis[c][c] += length;
        factor[c] = 1.0 / (length * axis[c][c] + 1e-300);
        XARM7_UNROLL
        for (int j = first; j < columns; j += XARM7_LANES) {
            const xarm7_lane sum = XARM7_LOAD(&product[j]) + length * XARM7_LOAD(&A[c][j]);
            const xarm7_lane part = sum * factor[c];
            XARM7_UNROLL
            for (int i = c; i < rows; i++) {
                XARM7_STORE(&A[i][j], XARM7_LOAD(&A[i][j]) - axis[c][i] * part);
            }
        }
    }
}

static inline void xarm7_mirror(double axis[6][8], const double factor[6], int rows, int columns,
                                  xarm7_lane x[8])
{
    XARM7_UNROLL
    for (int c = 0; c < columns; c++) {
        xarm7_lane sum = axis[c][c] * x[c];
        XARM7_UNROLL
        for (int i = c + 1; i < rows; i++) {
            sum += axis[c][i] * x[i];
        }
        sum *= factor[c];
        XARM7_UNROLL
        for (int i = c; i < rows; i++) {
            x[i] -= axis[c][i] * sum;
        }
    }
}

/* The features of the left side: column 9 a + 3 j + i for 1, c1, s1 (a), the powers x3^2, x3, 1 (i)
 * and x2^2, x2, 1 (j) of the partners' half-angle tangents or lengths. */
static void xarm7_left_side(const xarm7_formulation *form, double link[6][12], double to[15][32])
{
    double x[240] = {0.0}, y[240] = {0.0}, all[600] = {0.0};
    (void)form;
    x[0] = x[48] = 1.0; /* the origin and z */
    xarm7_pass(link[2], x, 1, xarm7_tangents, y, 16);
    xarm7_pass(link[1], y, 3, xarm7_tangents, x, 16);
    xarm7_pass(link[0], x, 9, xarm7_cosines, all, 40);
    for (int k = 0; k < 32; k += XARM7_LANES) {
        xarm7_lane z[15];
        for (int i = 0; i < 15; i++) {
            z[i] = XARM7_LOAD(all + 40 * i + k);
        }
        xarm7_act(link[5], z);
        for (int i = 0; i < 15; i++) {
            XARM7_STORE(&to[i][k], z[i]);
        }
    }
}

/* The six equations of a formulation: index 32 r + 9 a + 3 j + i for equation r, 1, c1, s1 (a), the
 * powers x3^2, x3, 1 (i) and x2^2, x2, 1 (j) of the partners' half-angle tangents or lengths; the
 * left side's features have columns like these. */
static void xarm7_equations(const xarm7_formulation *form, double link[6][12], const double
    (*left)[32],
                         double E[192])
{
    double x[240] = {0.0}, y[240] = {0.0}, right[240] = {0.0};
    double inverse[12], A[8][8] XARM7_ALIGNED = { {0.0} }, still_axis[6][8], still_factor[6],
        pair_axis[6][8], pair_factor[6];
    /* the features that the outer joint of the right side leaves alone, and those that it mixes:
     * the former hold two of the eight monomials, the latter six */
    static const int still[6] = {3, 6, 7, 8, 11, 14}, pair[8] = {1, 2, 4, 5, 9, 10, 12, 13};
    (void)form;
    x[0] = x[48] = 1.0; /* the origin and z */
    xarm7_invert(link[3], inverse);
    xarm7_pass(inverse, x, 1, xarm7_cosines, y, 16);
    xarm7_invert(link[4], inverse);
    xarm7_pass(inverse, y, 3, xarm7_cosines, right, 16);
    for (int i = 0; i < 6; i++) {
        A[i][0] = right[16 * still[i] + 1];
        A[i][1] = right[16 * still[i] + 2];
    }
    xarm7_clear(A, 6, 2, still_axis, still_factor);
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < 6; k++) {
            A[i][k] = right[16 * pair[i] + 3 + k];
        }
    }
    xarm7_clear(A, 8, 6, pair_axis, pair_factor);
    for (int k = 0; k < 32; k += XARM7_LANES) {
        xarm7_lane z[15], alone[8], mixed[8];
        for (int i = 0; i < 15; i++) {
            z[i] = XARM7_LOAD(&left[i][k]);
        }
        for (int i = 0; i < 6; i++) {
            /* the constant column of the right side, times 1 + x2^2 and 1 + x3^2 */
            alone[i] = z[still[i]] - right[16 * still[i]] * z[0];
        }
        for (int i = 0; i < 8; i++) {
            mixed[i] = z[pair[i]];
        }
        xarm7_mirror(still_axis, still_factor, 6, 2, alone);
        xarm7_mirror(pair_axis, pair_factor, 8, 6, mixed);
        for (int r = 0; r < 6; r++) {
            XARM7_STORE(E + 32 * r + k, r < 4 ? alone[2 + r] : mixed[2 + r]);
        }
    }
}

/* The determinant at hidden angles, and the upper triangular factor whose null vectors are
 * (x3, 1) x (x2^2, x2, 1). With A2, A1, A0 the blocks of x3^2, x3, 1 the matrix is
 * [A2 A1 A0 0; 0 A2 A1 A0]; reflections fold it to 9x9 and to 6x6. */
static inline xarm7_lane xarm7_fold(const double *E, xarm7_lane c, xarm7_lane s,
                                        xarm7_lane factor[6][6])
{
    xarm7_lane M[6][9], W[6][9], determinant;
    xarm7_lane *const rows[6] = {M[0], M[1], M[2], M[3], M[4], M[5]};
    xarm7_lane *const last[6] = {factor[0], factor[1], factor[2], factor[3], factor[4], factor[5]};
    const xarm7_lane zero = {0};
    XARM7_UNROLL
    for (int r = 0; r < 6; r++) {
        XARM7_UNROLL
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + 3 * (k % 3) + k / 3;
            M[r][k] = E[at] + E[9 + at] * c + E[18 + at] * s;
        }
    }
    determinant = xarm7_reflect(rows, 6, 0, 9);
    determinant *= xarm7_reflect(rows + 1, 5, 1, 9);
    determinant *= xarm7_reflect(rows + 2, 4, 2, 9);
    /* now M is [R B1 B0; 0 D1 D0]; the other shift has R B1 B0 under D1 D0 0 */
    XARM7_UNROLL
    for (int r = 0; r < 3; r++) {
        XARM7_UNROLL
        for (int k = 0; k < 9; k++) {
            W[r][k] = M[r][k];
            W[3 + r][k] = k < 6 ? M[3 + r][3 + k] : zero;
            if (k < 6) {
                factor[3 + r][k] = M[3 + r][3 + k];
            }
        }
    }
    XARM7_UNROLL
    for (int k = 0; k < 3; k++) {
        xarm7_lane *const four[4] = {W[k], W[3], W[4], W[5]};
        determinant *= xarm7_reflect(four, 4, k, 9);
    }
    XARM7_UNROLL
    for (int r = 0; r < 3; r++) {
        XARM7_UNROLL
        for (int k = 0; k < 6; k++) {
            factor[r][k] = W[3 + r][3 + k];
        }
    }
    determinant *= xarm7_reflect(last, 6, 0, 6);
    determinant *= xarm7_reflect(last + 1, 5, 1, 6);
    determinant *= xarm7_reflect(last + 2, 4, 2, 6);
    determinant *= xarm7_reflect(last + 3, 3, 3, 6);
    determinant *= xarm7_reflect(last + 4, 2, 4, 6);
    return determinant * factor[5][5];
}

/* How far the columns that are cleared first are from depending on each other: the square of the
 * least singular value of A2 over that of the norm of [A2 A1 A0], or a third of it, as det and
 * minors of A2' A2 say. Where x3 is nearly infinite they do depend on each other if the matrix is
 * singular, and the factor does not show it. */
static inline xarm7_lane xarm7_independence(const double *E, xarm7_lane c, xarm7_lane s)
{
    xarm7_lane squares = {0}, A[6][3], G[3][3];
    for (int r = 0; r < 6; r++) {
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + k;
            const xarm7_lane x = E[at] + E[9 + at] * c + E[18 + at] * s;
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
    const xarm7_lane first = G[1][1] * G[2][2] - G[1][2] * G[1][2];
    const xarm7_lane minors = first + G[0][0] * G[2][2] - G[0][2] * G[0][2] + G[0][0] * G[1][1] -
        G[0][1] * G[0][1];
    const xarm7_lane det = G[0][0] * first - G[0][1] * (G[0][1] * G[2][2] - G[1][2] * G[0][2]) +
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
} xarm7_trigonometric;

/* f and f' at the edges of the cells; the first edge stands at the end again */
typedef struct {
    double value[264] XARM7_ALIGNED, slope[264] XARM7_ALIGNED;
} xarm7_grid;

/* The roots by their cosines and sines: `simple` of them change the sign of f, `doubles` touch zero
 * within the rounding of f (two roots, none or one); behind these stand `unseen` places where a
 * closer look shows no root. At `lifted` places f turns back beside zero: no root, unless rounding
 * of what f is made of has lifted it off. `complete` says that no cell was given up. */
typedef struct {
    int simple, doubles, unseen, lifted, complete;
    double c[XARM7_ROOTS + 8], s[XARM7_ROOTS + 8];
    double double_c[XARM7_ROOTS], double_s[XARM7_ROOTS];
    double lifted_c[XARM7_ROOTS], lifted_s[XARM7_ROOTS];
} xarm7_roots;

/* What part of the circle is searched: the cell in its middle, how many it has on both sides, and
 * the value of a parabola over its bend where two complex roots count as a double one. */
typedef struct {
    int middle, reach;
    double lifted;
} xarm7_window;

static void xarm7_fit(const double samples[24], xarm7_trigonometric *f)
{
    double h[24] = {0.0}, most = 0.0, beyond = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    for (int k = 0; k < 24; k++) {
        for (int j = 0; j < 24; j++) {
            h[j] += samples[k] * xarm7_harmonics[k][j];
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
static void xarm7_at(const xarm7_trigonometric *f, double cosine, double sine, double out[3])
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
static void xarm7_fill_grid(const xarm7_trigonometric *f, xarm7_grid *g)
{
    const double *const a = f->a, *const b = f->b;
    for (int i = 0; i < 128; i += XARM7_LANES) {
        /* even multiples, the same half a turn on; odd ones, the opposite there */
        xarm7_lane even = xarm7_all(a[0]), odd = xarm7_all(0.0);
        xarm7_lane even_slope = odd, odd_slope = odd;
        XARM7_UNROLL
        for (int m = 1; m < 9; m += 2) {
            const xarm7_lane c = XARM7_LOAD(&xarm7_grid_c[m - 1][i]), s = XARM7_LOAD(&xarm7_grid_s[m
                - 1][i]);
            odd += a[m] * c + b[m] * s;
            odd_slope += m * b[m] * c - m * a[m] * s;
        }
        XARM7_UNROLL
        for (int m = 2; m < 9; m += 2) {
            const xarm7_lane c = XARM7_LOAD(&xarm7_grid_c[m - 1][i]), s = XARM7_LOAD(&xarm7_grid_s[m
                - 1][i]);
            even += a[m] * c + b[m] * s;
            even_slope += m * b[m] * c - m * a[m] * s;
        }
        XARM7_STORE(&g->value[i], even + odd);
        XARM7_STORE(&g->value[i + 128], even - odd);
        XARM7_STORE(&g->slope[i], even_slope + odd_slope);
        XARM7_STORE(&g->slope[i + 128], even_slope - odd_slope);
    }
    g->value[256] = g->value[0];
    g->slope[256] = g->slope[0];
}

/* Which of 64 cells may have roots: those where the Bernstein coefficients of the cubic through f
 * and f' at both edges are not all of the sign of the first beyond doubt. */
static unsigned long long xarm7_open_cells(const xarm7_grid *g, int from, double doubt)
{
    const double third = 0.02454369260617026 / 3.0;
    unsigned long long bits = 0;
#if XARM7_LANES > 1
    xarm7_mask weight, sum = {0};
    for (int k = 0; k < XARM7_LANES; k++) {
        weight[k] = 1LL << k;
    }
#endif
    for (int i = 0; i < 64; i += XARM7_LANES) {
        const xarm7_lane first = XARM7_LOAD(&g->value[from + i]);
        const xarm7_lane f0 = xarm7_abs(first) - doubt;
        const xarm7_lane f1 = xarm7_facing(XARM7_LOAD(&g->value[from + i + 1]), first) - doubt;
        const xarm7_lane d0 = xarm7_facing(XARM7_LOAD(&g->slope[from + i]), first);
        const xarm7_lane d1 = xarm7_facing(XARM7_LOAD(&g->slope[from + i + 1]), first);
        const xarm7_lane b1 = f0 + third * d0, b2 = f1 - third * d1;
#if XARM7_LANES > 1
        const xarm7_mask signs = (xarm7_mask)f0 | (xarm7_mask)f1 | (xarm7_mask)b1 | (xarm7_mask)b2;
        sum |= ((signs < 0) & weight) << i;
#else
        bits |= (unsigned long long)(f0 < 0.0 || f1 < 0.0 || b1 < 0.0 || b2 < 0.0) << i;
#endif
    }
#if XARM7_LANES > 1
    for (int k = 0; k < XARM7_LANES; k++) {
        bits |= (unsigned long long)sum[k];
    }
#endif
    return bits;
}

static void xarm7_add_angle(double c, double s, double *cosine, double *sine, int *count, int
    *complete)
{
    if (*count == XARM7_ROOTS) {
        *complete = 0;
        return;
    }
    cosine[*count] = c;
    sine[*count] = s;
    *count += 1;
}

/* The same unless it is there: neighbouring cells may be given up together. */
static void xarm7_add_once(double c, double s, double *cosine, double *sine, int *count, int
    *complete)
{
    for (int i = 0; i < *count; i++) {
        const double gap = fabs(s * cosine[i] - c * sine[i]);
        if (gap < 0.02454369260617026 / 64.0 && c * cosine[i] + s * sine[i] > 0.0) {
            return;
        }
    }
    xarm7_add_angle(c, s, cosine, sine, count, complete);
}

static void xarm7_add_simple(xarm7_roots *roots, double c, double s)
{
    xarm7_add_angle(c, s, roots->c, roots->s, &roots->simple, &roots->complete);
}

static void xarm7_add_double(xarm7_roots *roots, double c, double s)
{
    xarm7_add_once(c, s, roots->double_c, roots->double_s, &roots->doubles, &roots->complete);
}

static void xarm7_add_lifted(xarm7_roots *roots, double c, double s)
{
    xarm7_add_once(c, s, roots->lifted_c, roots->lifted_s, &roots->lifted, &roots->complete);
}

/* Parts of the circle: cosine and sine where each begins, its width, f, f', f'' at both ends, and
 * about where what is looked for lies, in parts of the width. */
typedef struct {
    int count;
    double c[48], s[48], width[48], start[48];
    double low[3][48], high[3][48];
} xarm7_parts;

/* Parts where f turns once, and parts where it rises or falls throughout and has a root. */
typedef struct {
    double lifted; /* as of the window */
    xarm7_parts turning, crossing;
} xarm7_waiting;

static void xarm7_add_part(xarm7_parts *parts, double c, double s, double width, const double
    low[3],
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
    xarm7_lane c, s, width, start, low[3], high[3];
} xarm7_spans;

/* Parts from one on; behind the last one it stands again. */
static void xarm7_take_parts(xarm7_parts *parts, int from, xarm7_spans *out)
{
    const int last = parts->count - 1;
    while (parts->count < from + XARM7_LANES) {
        const double low[3] = {parts->low[0][last], parts->low[1][last], parts->low[2][last]};
        const double high[3] = {parts->high[0][last], parts->high[1][last], parts->high[2][last]};
        xarm7_add_part(parts, parts->c[last], parts->s[last], parts->width[last], low, high,
                         parts->start[last]);
    }
    parts->count = last + 1;
    out->c = XARM7_LOAD(parts->c + from);
    out->s = XARM7_LOAD(parts->s + from);
    out->width = XARM7_LOAD(parts->width + from);
    out->start = XARM7_LOAD(parts->start + from);
    for (int i = 0; i < 3; i++) {
        out->low[i] = XARM7_LOAD(parts->low[i] + from);
        out->high[i] = XARM7_LOAD(parts->high[i] + from);
    }
}

/* Where the quintic through f, f', f'' at both ends vanishes (order 0), or its derivative (order
 * 1), in parts of the width. */
static inline xarm7_lane xarm7_on_quintic(int order, const xarm7_spans *part)
{
    const xarm7_lane h = part->width, d = h * part->low[1], s = h * h * part->low[2];
    const xarm7_lane D = part->high[0] - part->low[0] - d - 0.5 * s;
    const xarm7_lane D1 = h * part->high[1] - d - s, D2 = h * h * part->high[2] - s;
    const xarm7_lane c3 = 10.0 * D - 4.0 * D1 + 0.5 * D2, c4 = 7.0 * D1 - 15.0 * D - D2;
    const xarm7_lane c5 = 6.0 * D - 3.0 * D1 + 0.5 * D2;
    const xarm7_mask rising = part->low[order] < 0.0;
    xarm7_lane x = part->start, from = xarm7_all(0.0), to = xarm7_all(1.0);
    for (int i = 0; i < 4; i++) {
        const xarm7_lane f = part->low[0] + x * (d + x * (0.5 * s + x * (c3 + x * (c4 + x * c5))));
        const xarm7_lane f1 = d + x * (s + x * (3.0 * c3 + x * (4.0 * c4 + x * (5.0 * c5))));
        const xarm7_lane f2 = s + x * (6.0 * c3 + x * (12.0 * c4 + x * (20.0 * c5)));
        const xarm7_lane value = order ? f1 : f, slope = order ? f2 : f1;
        const xarm7_mask before = (value < 0.0) == rising;
        from = xarm7_select(before, x, from);
        to = xarm7_select(before, to, x);
        x -= value / slope;
        x = xarm7_select((x >= from) & (x <= to), x, 0.5 * (from + to));
    }
    return x;
}

/* f, f', f'' where cosine and sine are given */
static inline void xarm7_at_all(const xarm7_trigonometric *f, xarm7_lane cosine, xarm7_lane sine,
                                  xarm7_lane out[3])
{
    xarm7_lane c[9], s[9];
    c[1] = cosine;
    s[1] = sine;
    out[0] = xarm7_all(f->a[0]);
    out[1] = out[2] = xarm7_all(0.0);
    for (int m = 1; m < 9; m++) {
        const int less = m / 2, more = m - m / 2;
        if (less) {
            c[m] = c[less] * c[more] - s[less] * s[more];
            s[m] = s[less] * c[more] + c[less] * s[more];
        }
        const xarm7_lane even = f->a[m] * c[m] + f->b[m] * s[m], odd = f->b[m] * c[m] - f->a[m] *
            s[m];
        out[0] += even;
        out[1] += m * odd;
        out[2] -= m * m * even;
    }
}

/* Turn on by a small angle, no larger than a cell. */
static inline void xarm7_turn_on(xarm7_lane x, xarm7_lane *c, xarm7_lane *s)
{
    const xarm7_lane u = x * x, c0 = *c, s0 = *s;
    const xarm7_lane dc = 1.0 - u * (0.5 - u * (1.0 / 24.0 - u * (1.0 / 720.0)));
    const xarm7_lane ds = x * (1.0 - u * (1.0 / 6.0 - u * (1.0 / 120.0 - u * (1.0 / 5040.0))));
    *c = c0 * dc - s0 * ds;
    *s = s0 * dc + c0 * ds;
}

/* Where f (order 0) or f' (order 1) vanishes: from where the quintic says by Newton, with bisection
 * where it leaves. Returns how far that is from where each part begins, with cosine and sine, and
 * f, f', f'' there, as far as an extremum is concerned. */
static inline xarm7_lane xarm7_between(const xarm7_trigonometric *f, int order, double settled,
                                           const xarm7_spans *part, xarm7_lane *c, xarm7_lane *s,
                                           xarm7_lane at[3])
{
    const xarm7_mask rising = part->low[order] < 0.0;
    xarm7_lane from = xarm7_all(0.0), to = part->width, x = part->width * xarm7_on_quintic(order,
        part);
    xarm7_lane step = part->width;
    for (int i = 0; i < 48; i++) {
        const xarm7_mask moving = xarm7_abs(step) >= settled;
        if (i && xarm7_largest(xarm7_abs(step)) < settled) {
            break;
        }
        *c = part->c;
        *s = part->s;
        xarm7_turn_on(x, c, s);
        xarm7_at_all(f, *c, *s, at);
        const xarm7_mask before = (at[order] < 0.0) == rising;
        from = xarm7_select(before, x, from);
        to = xarm7_select(before, to, x);
        step = -at[order] / at[order + 1];
        step = xarm7_select((x + step >= from) & (x + step <= to), step, 0.5 * (from + to) - x);
        step = xarm7_select(moving, step, xarm7_all(0.0));
        x += step;
    }
    xarm7_turn_on(step, c, s);
    at[0] += 0.5 * step * at[1]; /* what a parabola gains where its slope vanishes */
    return x;
}

/* The double root, or the parts with a root, of a part of the circle whose extremum is known. */
static void xarm7_divide(const xarm7_trigonometric *f, const xarm7_parts *parts, int i, double x,
                           double c, double s, const double at[3], xarm7_waiting *waiting,
                           xarm7_roots *roots)
{
    const double bend = fabs(at[2]) * waiting->lifted, near = bend > f->touching ? bend :
        f->touching;
    const double beside = fabs(at[0]);
    const double low[3] = {parts->low[0][i], parts->low[1][i], parts->low[2][i]};
    const double high[3] = {parts->high[0][i], parts->high[1][i], parts->high[2][i]};
    if (beside <= f->rounding) {
        xarm7_add_double(roots, c, s);
        return;
    }
    if (at[0] * at[2] > 0.0 && beside <= near) {
        xarm7_add_lifted(roots, c, s);
        return;
    }
    /* where a parabola with its summit at the extremum has its roots */
    if ((low[0] < 0.0) != (at[0] < 0.0)) {
        xarm7_add_part(&waiting->crossing, parts->c[i], parts->s[i], x, low, at,
                         1.0 - sqrt(at[0] / (at[0] - low[0])));
    }
    if ((high[0] < 0.0) != (at[0] < 0.0)) {
        xarm7_add_part(&waiting->crossing, c, s, parts->width[i] - x, at, high,
                         sqrt(at[0] / (at[0] - high[0])));
    }
}

/* The roots of all parts that wait. */
static void xarm7_solve_parts(const xarm7_trigonometric *f, xarm7_waiting *waiting, xarm7_roots
    *roots)
{
    xarm7_parts *const bent = &waiting->turning, *const crossing = &waiting->crossing;
    double x[XARM7_LANES], c[XARM7_LANES], s[XARM7_LANES], value[3][XARM7_LANES];
    xarm7_spans part;
    xarm7_lane cosine, sine, at[3];
    for (int from = 0; from < bent->count; from += XARM7_LANES) {
        xarm7_take_parts(bent, from, &part);
        XARM7_STORE(x, xarm7_between(f, 1, 1e-07, &part, &cosine, &sine, at));
        XARM7_STORE(c, cosine);
        XARM7_STORE(s, sine);
        for (int i = 0; i < 3; i++) {
            XARM7_STORE(value[i], at[i]);
        }
        for (int k = 0; k < XARM7_LANES && from + k < bent->count; k++) {
            const double extremum[3] = {value[0][k], 0.0, value[2][k]};
            xarm7_divide(f, bent, from + k, x[k], c[k], s[k], extremum, waiting, roots);
        }
    }
    for (int from = 0; from < crossing->count; from += XARM7_LANES) {
        xarm7_take_parts(crossing, from, &part);
        (void)xarm7_between(f, 0, 1e-09, &part, &cosine, &sine, at);
        XARM7_STORE(c, cosine);
        XARM7_STORE(s, sine);
        for (int k = 0; k < XARM7_LANES && from + k < crossing->count; k++) {
            xarm7_add_simple(roots, c[k], s[k]);
        }
    }
    bent->count = crossing->count = 0;
}

/* A part where f has one extremum at most waits for others, to be solved in lanes. */
static void xarm7_few(const xarm7_trigonometric *f, double c, double s, double width, const double
    low[3],
                        const double high[3], xarm7_waiting *waiting, xarm7_roots *roots)
{
    if (low[1] * high[1] < 0.0) {
        xarm7_add_part(&waiting->turning, c, s, width, low, high, low[1] / (low[1] - high[1]));
    } else if ((low[0] < 0.0) != (high[0] < 0.0)) {
        xarm7_add_part(&waiting->crossing, c, s, width, low, high, low[0] / (low[0] - high[0]));
    }
    if (waiting->turning.count == 16 || waiting->crossing.count == 16) {
        xarm7_solve_parts(f, waiting, roots);
    }
}

/* What is known about f in a part of the circle. */
enum { XARM7_ROOTLESS, XARM7_FLAT, XARM7_TAME, XARM7_WILD };

/* Rootless; flat, nothing but rounding; tame, with one extremum at most; or none of these. The
 * Bernstein coefficients of the quintic through f, f', f'' at both ends and their differences bound
 * f, f' and f''. */
static inline void xarm7_kinds(const xarm7_trigonometric *f, const xarm7_spans *part, int
    kind[XARM7_LANES])
{
    const xarm7_lane h = part->width, d0 = h * part->low[1] * 0.2, d1 = h * part->high[1] * 0.2;
    const xarm7_lane s0 = h * h * part->low[2] * 0.05, s1 = h * h * part->high[2] * 0.05;
    const xarm7_lane share = h * (1.0 / 0.02454369260617026), square = share * share;
    const xarm7_lane doubt = f->rounding + f->scale * 2e-09 * square * square * square;
    const xarm7_lane b[6] = {part->low[0],
                           part->low[0] + d0,
                           part->low[0] + 2.0 * d0 + s0,
                           part->high[0] - 2.0 * d1 + s1,
                           part->high[0] - d1,
                           part->high[0]};
    xarm7_lane least[3], most[3];
    double bounds[5][XARM7_LANES];
    least[0] = xarm7_min(b[0], b[5]);
    most[0] = xarm7_max(b[0], b[5]);
    least[1] = most[1] = b[1] - b[0];
    least[2] = most[2] = b[2] - b[1] - least[1];
    for (int i = 1; i < 5; i++) {
        const xarm7_lane first = b[i + 1] - b[i], second = first - (b[i] - b[i - 1]);
        least[0] = xarm7_min(least[0], b[i]);
        most[0] = xarm7_max(most[0], b[i]);
        least[1] = xarm7_min(least[1], first);
        most[1] = xarm7_max(most[1], first);
        least[2] = xarm7_min(least[2], second);
        most[2] = xarm7_max(most[2], second);
    }
    /* what rounding does to f' and f'' shrinks with the width, down to that of the quintic's
     * ends */
    XARM7_STORE(bounds[0], least[0]);
    XARM7_STORE(bounds[1], most[0]);
    XARM7_STORE(bounds[2], xarm7_max(least[1], -most[1]) - doubt * share);
    XARM7_STORE(bounds[3], xarm7_max(least[2], -most[2]) - doubt * square);
    XARM7_STORE(bounds[4], xarm7_max(doubt, xarm7_all(f->touching)));
    for (int k = 0; k < XARM7_LANES; k++) {
        if (bounds[0][k] > bounds[4][k] || bounds[1][k] < -bounds[4][k]) {
            kind[k] = XARM7_ROOTLESS;
        } else if (bounds[0][k] >= -f->rounding && bounds[1][k] <= f->rounding) {
            kind[k] = XARM7_FLAT;
        } else {
            kind[k] = bounds[2][k] > 0.0 || bounds[3][k] > 0.0 ? XARM7_TAME : XARM7_WILD;
        }
    }
}

/* The same of one part. */
static int xarm7_kind(const xarm7_trigonometric *f, const double low[3], const double high[3],
    double h)
{
    xarm7_spans part;
    int kind[XARM7_LANES];
    part.width = xarm7_all(h);
    for (int i = 0; i < 3; i++) {
        part.low[i] = xarm7_all(low[i]);
        part.high[i] = xarm7_all(high[i]);
    }
    xarm7_kinds(f, &part, kind);
    return kind[0];
}

/* The roots of a cell where f may turn more than once: halve it until it does not. */
static void xarm7_many(const xarm7_trigonometric *f, double low, double c, double s, const double
    first[3],
                         const double last[3], int *budget, xarm7_waiting *waiting,
                         xarm7_roots *roots)
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
        const int kind = xarm7_kind(f, at_low, at[top], h);
        if (kind == XARM7_TAME) {
            xarm7_few(f, c, s, h, at_low, at[top], waiting, roots);
        } else if (kind != XARM7_ROOTLESS) {
            const double middle = low + 0.5 * h, cosine = cos(middle), sine = sin(middle);
            if (kind == XARM7_FLAT || depth[top] == 14 || *budget == 0) {
                xarm7_solve_parts(f, waiting, roots); /* of neighbouring double roots the first is
                    kept */
                roots->complete = 0;
                xarm7_add_double(roots, cosine, sine);
            } else {
                *budget -= 1;
                edge[open] = middle;
                edge_c[open] = cosine;
                edge_s[open] = sine;
                depth[top] += 1;
                depth[open] = depth[top];
                xarm7_at(f, cosine, sine, at[open]);
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
static void xarm7_edge(int cell, double *c, double *s)
{
    const int half = cell % 128;
    *c = cell < 128 ? xarm7_grid_c[0][half] : -xarm7_grid_c[0][half];
    *s = cell < 128 ? xarm7_grid_s[0][half] : -xarm7_grid_s[0][half];
}

static int xarm7_lowest(unsigned long long bits)
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
static void xarm7_search_cells(const xarm7_trigonometric *f, const xarm7_grid *g, const int *cell,
    int count,
                                 int *budget, xarm7_waiting *waiting, xarm7_roots *roots)
{
    const double h = 0.02454369260617026;
    double in[8][XARM7_LANES], bend[2][XARM7_LANES];
    int kind[XARM7_LANES];
    xarm7_spans part;
    for (int k = 0; k < XARM7_LANES; k++) {
        const int i = cell[k < count ? k : 0];
        in[0][k] = g->value[i];
        in[1][k] = g->slope[i];
        in[2][k] = g->value[i + 1];
        in[3][k] = g->slope[i + 1];
        xarm7_edge(i, &in[4][k], &in[5][k]);
        xarm7_edge((i + 1) % 256, &in[6][k], &in[7][k]);
    }
    part.width = xarm7_all(h);
    for (int end = 0; end < 2; end++) {
        xarm7_lane at[3], *const to = end ? part.high : part.low;
        xarm7_at_all(f, XARM7_LOAD(in[4 + 2 * end]), XARM7_LOAD(in[5 + 2 * end]), at);
        /* the edges' own values, so that neighbouring cells agree about their signs */
        to[0] = XARM7_LOAD(in[2 * end]);
        to[1] = XARM7_LOAD(in[2 * end + 1]);
        to[2] = at[2];
        XARM7_STORE(bend[end], at[2]);
    }
    xarm7_kinds(f, &part, kind);
    for (int k = 0; k < count; k++) {
        const double low[3] = {in[0][k], in[1][k], bend[0][k]};
        const double high[3] = {in[2][k], in[3][k], bend[1][k]};
        if (kind[k] == XARM7_TAME) {
            xarm7_few(f, in[4][k], in[5][k], h, low, high, waiting, roots);
        } else if (kind[k] != XARM7_ROOTLESS) {
            xarm7_many(f, cell[k] * h, in[4][k], in[5][k], low, high, budget, waiting, roots);
        }
    }
}

static void xarm7_find_roots(const xarm7_trigonometric *f, const xarm7_window *window,
                               xarm7_roots *roots)
{
    xarm7_grid g;
    xarm7_waiting waiting;
    int open[256], count = 0;
    int budget = 100; /* against an f that is next to nothing for long stretches */
    xarm7_fill_grid(f, &g);
    roots->simple = roots->doubles = roots->unseen = roots->lifted = 0;
    roots->complete = 1;
    for (int word = 0; word < 256 / 64; word++) {
        unsigned long long bits =
            xarm7_open_cells(&g, 64 * word, f->rounding + f->scale * 2e-05);
        for (; bits; bits &= bits - 1) {
            const int i = 64 * word + xarm7_lowest(bits);
            const int away = i > window->middle ? i - window->middle : window->middle - i;
            if (away <= window->reach || 256 - away <= window->reach) {
                open[count++] = i;
            }
        }
    }
    waiting.lifted = window->lifted;
    waiting.turning.count = waiting.crossing.count = 0;
    for (int k = 0; k < count; k += XARM7_LANES) {
        xarm7_search_cells(f, &g, open + k, count - k < XARM7_LANES ? count - k : XARM7_LANES,
            &budget,
                             &waiting, roots);
    }
    xarm7_solve_parts(f, &waiting, roots);
}

/* A lens on the circle: e^(i phi) = (w + a) / (1 + conj(a) w) with a = x + i y inside the circle
 * maps the circle of w = e^(i psi) to itself and shows what lies around the direction of a larger.
 * Where all roots lie together, as near the boundary of reach, f drowns in rounding without it. */
typedef struct {
    double x, y;
} xarm7_lens;

/* Cosine and sine of phi from those of psi. Returns |1 + conj(a) w|^2, whose eighth power makes of
 * f a polynomial in psi. */
static inline xarm7_lane xarm7_through(const xarm7_lens *a, xarm7_lane *c, xarm7_lane *s)
{
    const xarm7_lane u = *c + a->x, v = *s + a->y;
    const xarm7_lane d = 1.0 + a->x * *c + a->y * *s, e = a->x * *s - a->y * *c;
    const xarm7_lane square = d * d + e * e;
    *c = (u * d + v * e) / square;
    *s = (v * d - u * e) / square;
    return square;
}

/* The samples of f in phi become those of a polynomial in psi. */
static inline xarm7_lane xarm7_weighted(xarm7_lane f, xarm7_lane square)
{
    const xarm7_lane fourth = square * square, eighth = fourth * fourth;
    return f * (eighth * eighth);
}

/* The lens under which the roots are spread, from samples without one; 0 when they are already. log
 * |f| is a sum over the roots z, and the first harmonic of log |e^(i phi) - z| is -z for z inside
 * the circle, that of its mirror image for z outside. */
static int xarm7_spread(const double samples[24], xarm7_lens *a)
{
    double x = 0.0, y = 0.0, square, part;
    for (int k = 0; k < 12; k++) {
        const double ratio = log((fabs(samples[k]) + 1e-300) / (fabs(samples[k + 12]) + 1e-300));
        x += ratio * xarm7_sample_c[k];
        y += ratio * xarm7_sample_s[k];
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
static void xarm7_behind(const xarm7_lens *a, int count, double *cosine, double *sine)
{
    for (int i = 0; i < count; i += XARM7_LANES) {
        xarm7_lane c = XARM7_LOAD(cosine + i), s = XARM7_LOAD(sine + i);
        (void)xarm7_through(a, &c, &s);
        XARM7_STORE(cosine + i, c);
        XARM7_STORE(sine + i, s);
    }
}

/* Samples of a polynomial through a lens; `of` is what it is made of. */
typedef void (*xarm7_sampler)(const void *of, const xarm7_lens *lens, double samples[24]);

/* Keeps of angles beside which there is no root, as far as f tells, those where what it is made of
 * allows one; returns how many. */
typedef int (*xarm7_keeper)(const void *of, int count, double *cosine, double *sine);

/* What f is made of, and what tells of it; `keep` may be 0, where nothing tells. */
typedef struct {
    xarm7_sampler sample;
    xarm7_keeper keep;
    const void *of;
} xarm7_source;

/* Whether two angles, by their cosines and sines, are as near as a closer look reaches. */
static int xarm7_near(double c, double s, double cosine, double sine)
{
    return c * cosine + s * sine >= 0.9980487804878049;
}

/* Of roots those that are near to an angle, or those that are not, behind `count` that are kept. */
static int xarm7_keep_roots(int near, double cosine, double sine, const double *from_c,
                              const double *from_s, int many, double *c, double *s, int count)
{
    for (int i = 0; i < many && count < XARM7_ROOTS; i++) {
        if (xarm7_near(from_c[i], from_s[i], cosine, sine) == near) {
            c[count] = from_c[i];
            s[count] = from_s[i];
            count++;
        }
    }
    return count;
}

static int xarm7_kept(const xarm7_source *source, int count, double *cosine, double *sine)
{
    return source->keep ? source->keep(source->of, count, cosine, sine) : count;
}

/* The places where f turns back beside zero are double roots where there may be any. */
static void xarm7_take_lifted(const xarm7_source *source, xarm7_roots *roots)
{
    const int count = xarm7_kept(source, roots->lifted, roots->lifted_c, roots->lifted_s);
    for (int i = 0; i < count; i++) {
        xarm7_add_double(roots, roots->lifted_c[i], roots->lifted_s[i]);
    }
}

/* The roots around an angle, through a lens that magnifies what is there, instead of those that
 * were known. Returns 0, and leaves these, where that does not show all. */
static int xarm7_magnify(const xarm7_source *source, double cosine, double sine, xarm7_roots *roots)
{
    const xarm7_lens lens = { 0.8823529411764706 * cosine, 0.8823529411764706 * sine};
    const double turns = atan2(sine, cosine) / 6.283185307179586;
    const int cell = (int)(256.0 * (turns - floor(turns))) % 256;
    const xarm7_window window = {cell, 38, 1.28e-06};
    double samples[24];
    xarm7_trigonometric f;
    xarm7_roots found;
    source->sample(source->of, &lens, samples);
    xarm7_fit(samples, &f);
    if (!(f.noise <= 1e-10)) {
        return 0;
    }
    xarm7_find_roots(&f, &window, &found);
    if (!found.complete) {
        return 0;
    }
    xarm7_behind(&lens, found.simple, found.c, found.s);
    xarm7_behind(&lens, found.doubles, found.double_c, found.double_s);
    xarm7_behind(&lens, found.lifted, found.lifted_c, found.lifted_s);
    xarm7_take_lifted(source, &found);
    roots->simple = xarm7_keep_roots(0, cosine, sine, roots->c, roots->s, roots->simple,
                                       roots->c, roots->s, 0);
    roots->doubles = xarm7_keep_roots(0, cosine, sine, roots->double_c, roots->double_s,
                                        roots->doubles, roots->double_c, roots->double_s, 0);
    roots->simple = xarm7_keep_roots(1, cosine, sine, found.c, found.s, found.simple,
                                       roots->c, roots->s, roots->simple);
    roots->doubles = xarm7_keep_roots(1, cosine, sine, found.double_c, found.double_s,
                                        found.doubles, roots->double_c, roots->double_s,
                                        roots->doubles);
    return 1;
}

/* Whether any root is near to an angle. */
static int xarm7_any_near(const xarm7_roots *roots, double cosine, double sine)
{
    int any = 0;
    for (int i = 0; i < roots->simple; i++) {
        any |= xarm7_near(roots->c[i], roots->s[i], cosine, sine);
    }
    for (int i = 0; i < roots->doubles; i++) {
        any |= xarm7_near(roots->double_c[i], roots->double_s[i], cosine, sine);
    }
    return any;
}

/* Where roots may be double they are replaced by what a closer look shows: values that are computed
 * there have the digits that the fit of f lacks, not those that the equations lack behind f. What
 * was given up stands among them. */
static void xarm7_look_closer(const xarm7_source *source, xarm7_roots *roots)
{
    double c[4], s[4], empty_c[4], empty_s[4];
    int looks = 0, clear = 1, i = 0, empty = 0, emptied[4];
    if (roots->simple == XARM7_ROOTS || roots->doubles == XARM7_ROOTS) {
        return;
    }
    while (i < roots->doubles) {
        int seen = 0;
        for (int k = 0; k < looks; k++) {
            seen |= xarm7_near(roots->double_c[i], roots->double_s[i], c[k], s[k]);
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
        emptied[looks] = xarm7_magnify(source, c[looks], s[looks], roots);
        clear &= emptied[looks];
        emptied[looks] &= !xarm7_any_near(roots, c[looks], s[looks]);
        looks++;
        i = 0;
    }
    for (int k = 0; k < looks; k++) {
        if (emptied[k]) {
            empty_c[empty] = c[k];
            empty_s[empty++] = s[k];
        }
    }
    empty = xarm7_kept(source, empty, empty_c, empty_s);
    for (int k = 0; k < empty && roots->doubles + k < XARM7_ROOTS; k++) {
        roots->double_c[roots->doubles + k] = empty_c[k];
        roots->double_s[roots->doubles + k] = empty_s[k];
        roots->unseen++;
    }
    roots->complete = roots->complete || (clear && i == roots->doubles);
}

/* Whether samples are nothing but rounding of zero, which may be as smooth as a polynomial. */
static int xarm7_is_nothing(const double samples[24])
{
    double most = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    return most <= 1e-26;
}

/* All real roots of a polynomial. Returns 0 where it vanishes identically. */
static int xarm7_real_roots(const xarm7_source *source, xarm7_roots *roots)
{
    const xarm7_window all = {0, 128, 5e-09};
    double samples[24];
    xarm7_trigonometric f;
    xarm7_lens lens = {0.0, 0.0};
    source->sample(source->of, &lens, samples);
    if (xarm7_is_nothing(samples)) {
        return 0;
    }
    if (xarm7_spread(samples, &lens)) {
        source->sample(source->of, &lens, samples);
    }
    xarm7_fit(samples, &f);
    if (!(f.noise <= 1e-06)) {
        return 0;
    }
    xarm7_find_roots(&f, &all, roots);
    xarm7_behind(&lens, roots->simple, roots->c, roots->s);
    xarm7_behind(&lens, roots->doubles, roots->double_c, roots->double_s);
    xarm7_behind(&lens, roots->lifted, roots->lifted_c, roots->lifted_s);
    xarm7_take_lifted(source, roots);
    xarm7_look_closer(source, roots);
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
    int count, groups, group[XARM7_CANDIDATES], regular[XARM7_CANDIDATES];
    double c[XARM7_CANDIDATES], s[XARM7_CANDIDATES], n[6][XARM7_CANDIDATES];
} xarm7_candidates;

/* x = U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal. Returns what was
 * its length: the reciprocal of the square of the smallest singular value, in the end. */
static inline xarm7_lane xarm7_inverse_iteration(xarm7_lane U[6][6], const xarm7_lane inverse[6],
                                             xarm7_lane x[6])
{
    xarm7_lane square = {0};
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
    const xarm7_lane length = xarm7_sqrt(square) + 1e-300;
    for (int i = 0; i < 6; i++) {
        x[i] *= 1.0 / length;
    }
    return length;
}

/* The reciprocals of a diagonal, kept finite. */
static inline void xarm7_reciprocals(xarm7_lane U[6][6], xarm7_lane inverse[6])
{
    xarm7_lane most = xarm7_abs(U[0][0]);
    for (int i = 1; i < 6; i++) {
        most = xarm7_max(most, xarm7_abs(U[i][i]));
    }
    most = most * 1e-15 + 1e-300;
    for (int i = 0; i < 6; i++) {
        const xarm7_lane d = U[i][i];
        inverse[i] = 1.0 / xarm7_select(xarm7_abs(d) > most, d, xarm7_with_sign(most, d));
    }
}

/* One candidate for each simple root, all of one group. */
static void xarm7_null_vectors(const double *E, const xarm7_roots *roots,
                                 xarm7_candidates *out)
{
    static const double start[6] = { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 };
    const int behind = out->count;
    for (int from = 0; from < roots->simple; from += XARM7_LANES) {
        double cs[2][XARM7_LANES];
        xarm7_lane factor[6][6], inverse[6], x[6], c, s;
        for (int k = 0; k < XARM7_LANES; k++) {
            const int i = from + k < roots->simple ? from + k : from;
            cs[0][k] = roots->c[i];
            cs[1][k] = roots->s[i];
        }
        c = XARM7_LOAD(cs[0]);
        s = XARM7_LOAD(cs[1]);
        (void)xarm7_fold(E, c, s, factor);
        xarm7_reciprocals(factor, inverse);
        for (int i = 0; i < 6; i++) {
            x[i] = xarm7_all(start[i]);
        }
        (void)xarm7_inverse_iteration(factor, inverse, x);
        (void)xarm7_inverse_iteration(factor, inverse, x);
        XARM7_STORE(out->c + behind + from, c);
        XARM7_STORE(out->s + behind + from, s);
        for (int i = 0; i < 6; i++) {
            XARM7_STORE(out->n[i] + behind + from, x[i]);
        }
    }
    for (int i = 0; i < roots->simple; i++) {
        out->group[out->count++] = out->groups;
    }
    out->groups++;
}

/* The determinant itself, turned on by small angles: middle - apart, middle, middle + apart. */
static void xarm7_beside(const double *E, double c, double s, double middle, double apart, double
    f[8])
{
    static const double side[8] XARM7_ALIGNED = {-1.0, 0.0, 1.0};
    for (int k = 0; k < 3; k += XARM7_LANES) {
        xarm7_lane cosine = xarm7_all(c), sine = xarm7_all(s), factor[6][6];
        xarm7_turn_on(middle + apart * XARM7_LOAD(side + k), &cosine, &sine);
        XARM7_STORE(f + k, xarm7_fold(E, cosine, sine, factor));
    }
}

/* Two simple roots beside a place where roots may have met, if there are: the determinant itself
 * has digits there that its fit lacks. Each parabola is as wide as the one before says that they
 * are apart. */
static void xarm7_separate(const double *E, double c, double s, xarm7_roots *out)
{
    double middle = 0.0, apart = 0.0001;
    for (int round = 0; round < 3; round++) {
        double f[8], slope, bend, square;
        xarm7_beside(E, c, s, middle, apart, f);
        slope = 0.5 * (f[2] - f[0]);
        bend = 0.5 * (f[2] + f[0]) - f[1];
        square = slope * slope - 4.0 * bend * f[1];
        middle -= 0.5 * slope / bend * apart;
        apart *= sqrt(square) / fabs(bend);
        if (!(apart > 0.0 && fabs(middle) + apart < 0.0001)) {
            return; /* none, or apart so far that they are known */
        }
    }
    for (int sign = -1; sign <= 1 && out->simple < XARM7_ROOTS; sign += 2) {
        const double x = middle + 0.5 * sign * apart;
        out->c[out->simple] = c * cos(x) - s * sin(x);
        out->s[out->simple++] = s * cos(x) + c * sin(x);
    }
}

static void xarm7_add_candidate(xarm7_candidates *out, double c, double s, const double n[6])
{
    if (out->count == XARM7_CANDIDATES) {
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
static void xarm7_split(double n[2][6], int rows, const int *up, const int *down, double c,
                          double s, xarm7_candidates *out)
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
        xarm7_add_candidate(out, c, s, sum);
    }
}

/* Two vectors, orthogonal, at which a factor is smallest. Returns 1 where it is regular, with no
 * singular value that is next to nothing and not two small ones, else 0. */
static inline xarm7_lane xarm7_smallest(xarm7_lane factor[6][6], xarm7_lane x[2][6])
{
    static const double start[2][6] = {
        { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 },
        { -0.31, 0.47, 0.59, 0.67, -0.23, 0.41 },
    };
    xarm7_lane inverse[6], length, second, squares = {0};
    xarm7_reciprocals(factor, inverse);
    for (int i = 0; i < 6; i++) {
        x[0][i] = xarm7_all(start[0][i]);
        x[1][i] = xarm7_all(start[1][i]);
        for (int j = i; j < 6; j++) {
            squares += factor[i][j] * factor[i][j];
        }
    }
    for (int step = 0; step < 4; step++) {
        xarm7_lane along = {0};
        length = xarm7_inverse_iteration(factor, inverse, x[0]);
        second = xarm7_inverse_iteration(factor, inverse, x[1]);
        for (int i = 0; i < 6; i++) {
            along += x[0][i] * x[1][i];
        }
        for (int i = 0; i < 6; i++) {
            x[1][i] -= along * x[0][i];
        }
    }
    return xarm7_select((length * squares < 25000000000000.004) & (second * squares <
        1000000000000.0),
                          xarm7_all(1.0), xarm7_all(0.0));
}

/* Candidates where two roots may have met: the null space may be a plane, which is split where one
 * of the two shifts, x3 or x2, has an eigenvalue. */
static void xarm7_null_plane(const double *E, double c, double s, xarm7_candidates *out)
{
    static const int up_3[3] = {0, 1, 2}, down_3[3] = {3, 4, 5};
    static const int up_2[4] = {0, 1, 3, 4}, down_2[4] = {1, 2, 4, 5};
    xarm7_lane factor[6][6], x[2][6];
    double n[2][6];
    if (out->groups == XARM7_CANDIDATES) {
        return;
    }
    (void)xarm7_fold(E, xarm7_all(c), xarm7_all(s), factor);
    out->regular[out->groups] =
        xarm7_largest(xarm7_smallest(factor, x)) > 0.0 &&
        xarm7_largest(xarm7_independence(E, xarm7_all(c), xarm7_all(s))) > 8.999999999999999e-08;
    for (int r = 0; r < 2; r++) {
        double square = 0.0;
        for (int i = 0; i < 6; i++) {
            n[r][i] = xarm7_largest(x[r][i]);
            square += n[r][i] * n[r][i];
        }
        square = sqrt(square) + 1e-300;
        for (int i = 0; i < 6; i++) {
            n[r][i] /= square;
        }
    }
    xarm7_add_candidate(out, c, s, n[0]);
    xarm7_split(n, 3, up_3, down_3, c, s, out);
    xarm7_split(n, 4, up_2, down_2, c, s, out);
    out->groups++;
}

/* The terms a c + b s + w of five invariants of B = Rz K Rz(phi5) M Rz: l_z, p_z, p.l, p.p / 2 and
 * (p x l)_z; and the 2x5 matrix that solves them for c and s by least squares. */
static void xarm7_invariants(const double K[12], const double M[12], double w[5],
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
static inline void xarm7_partners(const int joint[6], const xarm7_lane n[6], xarm7_lane c[6],
                                    xarm7_lane s[6])
{
    const xarm7_lane up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const xarm7_lane down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5];
    xarm7_lane row[3], sign, top, bottom;
    for (int i = 0; i < 3; i++) {
        row[i] = xarm7_select(up > down, n[i], n[3 + i]);
    }
    sign = xarm7_with_sign(xarm7_all(1.0), row[0] + row[2]);
    c[1] = sign * (row[2] - row[0]);
    s[1] = sign * 2.0 * row[1];
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2];
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2];
    c[2] = bottom * bottom - top * top;
    s[2] = 2.0 * top * bottom;
    xarm7_to_unit(&c[1], &s[1]);
    xarm7_to_unit(&c[2], &s[2]);
    (void)joint;
}

/* phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve` are those of the invariants. */
static inline void xarm7_others(const int joint[6], double link[6][12], const double w[5],
                                  double solve[2][5], xarm7_lane c[6], xarm7_lane s[6])
{
    xarm7_rigid G, C;
    xarm7_lane l[3], q[3], value[5], x, y;
    xarm7_begin(G, link[5]);
    for (int i = 0; i < 3; i++) {
        xarm7_move(G, joint[i], c[i], s[i]);
        xarm7_follow(G, link[i]);
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
    c[4] = s[4] = xarm7_all(0.0);
    for (int i = 0; i < 5; i++) {
        c[4] += solve[0][i] * (value[i] - w[i]);
        s[4] += solve[1][i] * (value[i] - w[i]);
    }
    xarm7_to_unit(&c[4], &s[4]);
    xarm7_begin(C, link[3]);
    xarm7_turn(C, c[4], s[4]);
    xarm7_follow(C, link[4]);
    c[3] = C[0][2] * l[0] + C[1][2] * l[1] + C[0][3] * q[0] + C[1][3] * q[1];
    s[3] = C[0][2] * l[1] - C[1][2] * l[0] + C[0][3] * q[1] - C[1][3] * q[0];
    xarm7_to_unit(&c[3], &s[3]);
    c[5] = s[5] = xarm7_all(0.0);
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
    xarm7_to_unit(&c[5], &s[5]);
}

/* The loop's error at cosines and sines of the joints: translation and rotation vector that are
 * missing. J, when given, takes the rows of the Jacobian with the error as seventh column. Returns
 * the square of the error. */
static inline xarm7_lane xarm7_error(const xarm7_loop *loop, const xarm7_lane c[6],
                                         const xarm7_lane s[6], xarm7_lane J[6][7])
{
    static const double identity[12] = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    const double *const P = loop->link[5];
    xarm7_rigid T;
    xarm7_lane z[6][3], o[6][3], S[3][3], square = {0}, trace;
    xarm7_begin(T, identity);
    XARM7_UNROLL
    for (int k = 0; k < 6; k++) {
        if (k) {
            xarm7_follow(T, loop->link[k - 1]);
        }
        XARM7_UNROLL
        for (int i = 0; i < 3; i++) {
            z[k][i] = T[i][2];
            o[k][i] = T[i][3];
        }
        xarm7_move(T, k, c[k], s[k]);
    }
    XARM7_UNROLL
    for (int i = 0; i < 3; i++) {
        XARM7_UNROLL
        for (int j = 0; j < 3; j++) {
            S[i][j] = P[4 * i] * T[j][0] + P[4 * i + 1] * T[j][1] + P[4 * i + 2] * T[j][2];
        }
        J[i][6] = P[4 * i + 3] - T[i][3];
    }
    J[3][6] = 0.5 * (S[2][1] - S[1][2]);
    J[4][6] = 0.5 * (S[0][2] - S[2][0]);
    J[5][6] = 0.5 * (S[1][0] - S[0][1]);
    XARM7_UNROLL
    for (int i = 0; i < 6; i++) {
        square += J[i][6] * J[i][6];
    }
    XARM7_UNROLL
    for (int k = 0; k < 6; k++) {
        XARM7_UNROLL
        for (int i = 0; i < 3; i++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            J[i][k] = z[k][i1] * (T[i2][3] - o[k][i2]) - z[k][i2] * (T[i1][3] - o[k][i1]);
            J[3 + i][k] = z[k][i];
        }
    }
    /* half a turn away the skew part vanishes too: the trace tells */
    trace = S[0][0] + S[1][1] + S[2][2];
    return xarm7_select(trace < 0.0, square + 1.0, square);
}

/* A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
 * next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
 * largest. */
static inline xarm7_lane xarm7_step(xarm7_lane J[6][7], xarm7_lane x[6])
{
    xarm7_lane *const row[6] = {J[0], J[1], J[2], J[3], J[4], J[5]};
    xarm7_lane most, least;
    const xarm7_lane zero = {0};
    xarm7_reflect(row, 6, 0, 7);
    xarm7_reflect(row + 1, 5, 1, 7);
    xarm7_reflect(row + 2, 4, 2, 7);
    xarm7_reflect(row + 3, 3, 3, 7);
    xarm7_reflect(row + 4, 2, 4, 7);
    most = least = xarm7_abs(J[0][0]);
    for (int i = 1; i < 6; i++) {
        most = xarm7_max(most, xarm7_abs(J[i][i]));
        least = xarm7_min(least, xarm7_abs(J[i][i]));
    }
    least /= most;
    most *= 1e-09;
    for (int i = 5; i >= 0; i--) {
        xarm7_lane sum = J[i][6];
        for (int j = i + 1; j < 6; j++) {
            sum -= J[i][j] * x[j];
        }
        sum /= J[i][i];
        sum = xarm7_max(xarm7_min(sum, zero + 1.0), zero - 1.0);
        x[i] = xarm7_select(xarm7_abs(J[i][i]) > most, sum, zero);
    }
    return least;
}

/* The same damped, for starts far away and for singular solutions: (J' J + d) x = J' error. */
static inline void xarm7_damped_step(xarm7_lane J[6][7], xarm7_lane damping, xarm7_lane x[6])
{
    xarm7_lane A[6][7];
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
        const xarm7_lane pivot = 1.0 / (A[i][i] + 1e-30);
        for (int j = i + 1; j < 6; j++) {
            const xarm7_lane factor = A[i][j] * pivot;
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
        x[i] = xarm7_max(xarm7_min(x[i], xarm7_all(1.0)), xarm7_all(-1.0));
    }
}

/* Newton on the loop; what remains in c and s is the best iterate, and its error is returned. */
static inline xarm7_lane xarm7_polish(const xarm7_loop *loop, xarm7_lane c[6], xarm7_lane s[6],
                                          int steps, int afar)
{
    xarm7_lane J[6][7], x[6], tc[6], ts[6], least, now;
    for (int i = 0; i < 6; i++) {
        tc[i] = c[i];
        ts[i] = s[i];
    }
    least = now = xarm7_error(loop, c, s, J);
    for (int step = 0; step < steps; step++) {
        xarm7_mask better;
        if (xarm7_largest(least) < 1e-29) {
            break;
        }
        if (afar) {
            xarm7_damped_step(J, xarm7_min(now * 0.01, xarm7_all(0.01)), x);
        } else {
            (void)xarm7_step(J, x);
        }
        for (int i = 0; i < 6; i++) {
            /* a turn by 2 atan(x/2), without trigonometry */
            const xarm7_lane u = 0.25 * x[i] * x[i], f = 1.0 / (1.0 + u);
            const xarm7_lane dc = (1.0 - u) * f, ds = x[i] * f, old = tc[i];
            tc[i] = old * dc - ts[i] * ds;
            ts[i] = ts[i] * dc + old * ds;
        }
        now = xarm7_error(loop, tc, ts, J);
        better = now < least;
        for (int i = 0; i < 6; i++) {
            c[i] = xarm7_select(better, tc[i], c[i]);
            s[i] = xarm7_select(better, ts[i], s[i]);
        }
        least = xarm7_select(better, now, least);
    }
    return xarm7_sqrt(least);
}

/* A bit for each solution. */
typedef unsigned long long xarm7_set;

/* The solutions found so far. Where one is singular many candidates come near to it: there is room
 * for more than there are solutions, the last of it for regular ones. */
typedef struct {
    int count;
    xarm7_set singular, nearly_singular; /* where the arm is */
    int doubles; /* roots that met, or may have */
    double q[64][6], residual[64];
} xarm7_found;

/* Whether two joint vectors differ by less than that, modulo turns. */
static int xarm7_alike(const double a[6], const double b[6], double most)
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
static int xarm7_keep(xarm7_found *found, double theta[6], double residual, double pivot)
{
    const int singular = pivot < 1e-06, nearly = pivot < 0.0001;
    const int room = nearly ? 64 - 16 : 64;
    if (!(residual <= 1e-10)) {
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (xarm7_alike(found->q[i], theta, 1e-06)) {
            if (residual < found->residual[i]) {
                found->residual[i] = residual;
                for (int j = 0; j < 6; j++) {
                    found->q[i][j] = theta[j];
                }
            }
            found->singular |= (xarm7_set)singular << i;
            found->nearly_singular |= (xarm7_set)nearly << i;
            return i;
        }
    }
    if (found->count >= room) {
        return -1;
    }
    found->singular |= (xarm7_set)singular << found->count;
    found->nearly_singular |= (xarm7_set)nearly << found->count;
    found->residual[found->count] = residual;
    for (int j = 0; j < 6; j++) {
        found->q[found->count][j] = theta[j];
    }
    return found->count++;
}

/* Polish candidates, given by cosines and sines, and keep what they lead to: the solutions that
 * were met. `place` takes which solution each candidate became, or -1. With `doubtful` candidates
 * singular solutions are marked. */
static xarm7_set xarm7_offer(const xarm7_loop *loop, xarm7_lane c[6], xarm7_lane s[6], int count,
                              int steps, int doubtful, xarm7_found *found,
                              int place[XARM7_LANES])
{
    double residual[XARM7_LANES], theta[6][XARM7_LANES], pivot[XARM7_LANES];
    xarm7_set met = 0;
    XARM7_STORE(residual, xarm7_polish(loop, c, s, steps, steps > 4));
    if (doubtful) {
        xarm7_lane J[6][7], x[6];
        (void)xarm7_error(loop, c, s, J);
        XARM7_STORE(pivot, xarm7_step(J, x));
    } else {
        XARM7_STORE(pivot, xarm7_all(1.0));
    }
    for (int i = 0; i < 6; i++) {
        const double cosine = xarm7_advance[0][i], sine = xarm7_advance[1][i];
        XARM7_STORE(theta[i],
                      xarm7_angle(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] * sine));
    }
    for (int k = 0; k < count; k++) {
        double row[6];
        for (int i = 0; i < 6; i++) {
            /* half a turn is +pi, also when rounding says otherwise */
            row[i] = theta[i][k] < -3.141592653589783 ? 3.141592653589793 : theta[i][k];
        }
        place[k] = xarm7_keep(found, row, residual[k], pivot[k]);
        if (place[k] >= 0) {
            met |= (xarm7_set)1 << place[k];
        }
    }
    return met;
}

static int xarm7_bits(xarm7_set set)
{
    int count = 0;
    for (; set; set &= set - 1) {
        count++;
    }
    return count;
}

/* Whether the number of regular solutions is even. */
static int xarm7_paired(const xarm7_found *found)
{
    return (found->count - xarm7_bits(found->singular)) % 2 == 0;
}

/* The links L0 ... L5 of a formulation. */
static void xarm7_around(const xarm7_formulation *form, const xarm7_loop *loop,
                           double link[6][12])
{
    for (int i = 0; i < 6; i++) {
        const int joint = form->joint[i];
        if (form->sign > 0.0 && joint < 5) {
            xarm7_copy(loop->link[joint], link[i]);
        } else if (form->sign > 0.0) {
            xarm7_invert(loop->link[5], link[i]);
        } else if (joint > 0) {
            xarm7_invert(loop->link[joint - 1], link[i]);
        } else {
            xarm7_copy(loop->link[5], link[i]);
        }
    }
}

/* Roots that nearly meet are tried as one double root too. */
static void xarm7_close_roots(const double *E, const xarm7_roots *roots, xarm7_candidates *out)
{
    for (int i = 0; i < roots->simple; i++) {
        for (int j = 0; j < i; j++) {
            const double c = roots->c[i] + roots->c[j], s = roots->s[i] + roots->s[j];
            const double square = c * c + s * s;
            if (square > 3.999999) {
                const double factor = 1.0 / sqrt(square);
                xarm7_null_plane(E, c * factor, s * factor, out);
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
static int xarm7_settle(const xarm7_formulation *form, const xarm7_loop *loop,
                          double link[6][12], const xarm7_candidates *all,
                          const xarm7_roots *roots, xarm7_found *found)
{
    double w[5], solve[2][5];
    xarm7_set met = 0, of_group[XARM7_CANDIDATES] = {0};
    const int simple = roots->simple, touching = roots->doubles + roots->unseen;
    const int doubted = found->doubles > 0;
    int complete = roots->complete, expected = simple, true_doubles = 0;
    xarm7_invariants(link[3], link[4], w, solve);
    for (int from = 0; from < all->count; from += XARM7_LANES) {
        const int count = all->count - from < XARM7_LANES ? all->count - from : XARM7_LANES;
        xarm7_lane n[6], c[6], s[6], tc[6], ts[6];
        int place[XARM7_LANES];
        c[0] = XARM7_LOAD(all->c + from);
        s[0] = XARM7_LOAD(all->s + from);
        for (int i = 0; i < 6; i++) {
            n[i] = XARM7_LOAD(all->n[i] + from);
        }
        xarm7_partners(form->joint, n, c, s);
        xarm7_others(form->joint, link, w, solve, c, s);
        for (int i = 0; i < 6; i++) {
            tc[form->joint[i]] = c[i];
            ts[form->joint[i]] = form->sign * s[i];
        }
        met |= xarm7_offer(loop, tc, ts, count, 4, doubted || from + count > simple, found, place);
        for (int k = 0; k < count; k++) {
            if (from + k < simple) {
                complete &= place[k] >= 0;
            } else if (place[k] >= 0) {
                of_group[all->group[from + k]] |= (xarm7_set)1 << place[k];
            }
        }
    }
    for (int i = all->groups - touching; i < all->groups; i++) {
        if (of_group[i] || !all->regular[i]) {
            true_doubles++;
            expected += of_group[i] & found->singular ? 1 : 2;
        }
    }
    complete = complete && xarm7_bits(met) >= expected && xarm7_paired(found);
    found->doubles = complete ? true_doubles : found->doubles + roots->doubles;
    return complete;
}

/* Keeps of angles those where the determinant may vanish: where f only comes near to zero it does
 * not. */
static int xarm7_keep_vanishing(const void *equations, int count, double *cosine, double *sine)
{
    int kept = 0;
    for (int from = 0; from < count; from += XARM7_LANES) {
        xarm7_lane factor[6][6], x[2][6];
        double c[XARM7_LANES], s[XARM7_LANES], regular[XARM7_LANES], apart[XARM7_LANES];
        for (int k = 0; k < XARM7_LANES; k++) {
            const int i = from + k < count ? from + k : from;
            c[k] = cosine[i];
            s[k] = sine[i];
        }
        (void)xarm7_fold(equations, XARM7_LOAD(c), XARM7_LOAD(s), factor);
        XARM7_STORE(regular, xarm7_smallest(factor, x));
        XARM7_STORE(apart, xarm7_independence(equations, XARM7_LOAD(c), XARM7_LOAD(s)));
        for (int k = 0; k < XARM7_LANES && from + k < count; k++) {
            if (regular[k] < 1.0 || !(apart[k] > 8.999999999999999e-08)) {
                cosine[kept] = c[k];
                sine[kept++] = s[k];
            }
        }
    }
    return kept;
}

/* The determinant at the sample angles, through a lens. */
static void xarm7_sample(const void *equations, const xarm7_lens *lens, double samples[24])
{
    for (int k = 0; k < 24; k += XARM7_LANES) {
        xarm7_lane factor[6][6];
        xarm7_lane c = XARM7_LOAD(xarm7_sample_c + k), s = XARM7_LOAD(xarm7_sample_s + k);
        const xarm7_lane square = xarm7_through(lens, &c, &s);
        const xarm7_lane determinant = xarm7_fold(equations, c, s, factor);
        XARM7_STORE(samples + k, xarm7_weighted(determinant, square));
    }
}

/* Find what a formulation finds; whether that is certainly everything. */
static int xarm7_attempt(const xarm7_formulation *form, const xarm7_loop *loop,
                           xarm7_found *found)
{
    double link[6][12], E[192];
    const xarm7_source source = { xarm7_sample, xarm7_keep_vanishing, E};
    xarm7_roots roots, beside;
    xarm7_candidates all;
    xarm7_around(form, loop, link);
    double left[15][32];
    xarm7_left_side(form, link, left);
    xarm7_equations(form, link, (const double (*)[32])left, E);
    if (!xarm7_real_roots(&source, &roots)) {
        return 0;
    }
    beside.simple = all.count = all.groups = 0;
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        xarm7_separate(E, roots.double_c[i], roots.double_s[i], &beside);
    }
    xarm7_null_vectors(E, &roots, &all);
    xarm7_null_vectors(E, &beside, &all);
    xarm7_close_roots(E, &roots, &all);
    for (int i = 0; i < roots.doubles + roots.unseen; i++) {
        xarm7_null_plane(E, roots.double_c[i], roots.double_s[i], &all);
    }
    /* lanes behind the last candidate hold the first one */
    for (int k = all.count; k % XARM7_LANES; k++) {
        all.c[k] = all.c[0];
        all.s[k] = all.s[0];
        for (int i = 0; i < 6; i++) {
            all.n[i][k] = all.n[i][0];
        }
    }
    return xarm7_settle(form, loop, link, &all, &roots, found);
}

/* Find what the methods find, one after the other, until that is certainly everything. */
static int xarm7_try(const xarm7_loop *loop, xarm7_found *found)
{
    int complete = 0;
    for (int i = 0; i < 2 && !complete; i++) {
        complete = xarm7_attempt(&xarm7_formulations[i], loop, found);
    }
    return complete;
}

/* Newton from joint angles (count, 6) far from or near to solutions. */
static xarm7_set xarm7_follow_back(const xarm7_loop *loop, double (*start)[6], int count,
                                    xarm7_found *found, int *lost)
{
    xarm7_set met = 0;
    for (int from = 0; from < count; from += XARM7_LANES) {
        const int now = count - from < XARM7_LANES ? count - from : XARM7_LANES;
        double cs[2][6][XARM7_LANES];
        xarm7_lane c[6], s[6];
        int place[XARM7_LANES];
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < XARM7_LANES; k++) {
                const double angle = start[from + (k < now ? k : 0)][i];
                const double cosine = cos(angle), sine = sin(angle);
                cs[0][i][k] = cosine * xarm7_advance[0][i] + sine * xarm7_advance[1][i];
                cs[1][i][k] = sine * xarm7_advance[0][i] - cosine * xarm7_advance[1][i];
            }
            c[i] = XARM7_LOAD(cs[0][i]);
            s[i] = XARM7_LOAD(cs[1][i]);
        }
        met |= xarm7_offer(loop, c, s, now, 40, 1, found, place);
        for (int k = 0; k < now; k++) {
            *lost += place[k] < 0;
        }
    }
    return met;
}

/* Solve poses close by, and follow their solutions back. Where two solutions meet they are on one
 * side only: both sides have to have as many as are found. Around a singular pose none of them has
 * to have all solutions: then all are looked at. */
static int xarm7_from_nearby(const xarm7_loop *loop, xarm7_found *found)
{
    int followed = 0, before = -1;
    for (int n = 0; n < 10; n++) {
        xarm7_loop nearby = *loop;
        xarm7_found other;
        int complete, count = -1, lost = 0;
        xarm7_set met;
        xarm7_then(nearby.link[5], xarm7_nudge[n]);
        other.count = 0;
        other.singular = other.nearly_singular = 0;
        other.doubles = 0;
        complete = xarm7_try(&nearby, &other);
        met = xarm7_follow_back(loop, other.q, other.count, found, &lost);
        if (complete && !lost && met) {
            count = xarm7_bits(met) == other.count ? other.count : -1;
            followed |= (met & found->singular) != 0;
        }
        if (n % 2 && before == found->count && count == found->count && !found->singular &&
            xarm7_paired(found)) {
            return 1;
        }
        before = count;
    }
    return followed && xarm7_paired(found);
}

/* Newton from many starts, the same on every run. */
static void xarm7_from_anywhere(const xarm7_loop *loop, xarm7_found *found)
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
        (void)xarm7_follow_back(loop, start, 8, found, &lost);
    }
}

/* What comes first where there are more than there are rows: 0 for regular solutions, 1 for
 * singular ones or nearly so, 2 for those that lie together with one of these and may be the same,
 * which only its last digits tell. */
static void xarm7_rank(const xarm7_found *found, int rank[64])
{
    for (int i = 0; i < found->count; i++) {
        rank[i] = (int)(found->nearly_singular >> i & 1);
        for (int j = 0; j < i && rank[i] == 1; j++) {
            if (rank[j] == 1 && xarm7_alike(found->q[i], found->q[j], 0.001)) {
                rank[i] = 2;
            }
        }
    }
}

/* Whether solution i comes before solution j: by rank, then by the first angle, angles that agree
 * to rounding by the next. */
static int xarm7_before(const xarm7_found *found, const int *rank, int i, int j)
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
static int xarm7_general(const double T[16], const double free_joints[1], double q[16][6],
                         double residual[16])
{
    xarm7_found found;
    xarm7_loop whole;
    const xarm7_loop *const loop = &whole;
    int rank[64], order[64], certified, inexact = 0;
    xarm7_close(T, free_joints, &whole);
    found.count = 0;
    found.singular = found.nearly_singular = 0;
    found.doubles = 0;
    const double *const P = loop->link[5];
    if (P[3] * P[3] + P[7] * P[7] + P[11] * P[11] > 4.000000004) {
        return 0;
    }
    certified = xarm7_try(loop, &found);
    if (!certified && !xarm7_from_nearby(loop, &found)) {
        xarm7_from_anywhere(loop, &found);
    }
    xarm7_rank(&found, rank);
    for (int i = 0; i < found.count; i++) {
        int j = i;
        for (; j > 0 && xarm7_before(&found, rank, i, order[j - 1]); j--) {
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
    const double T[16], const double free_joints[1], const double seed[7], double q[16][7],
    int found[16], int chosen[16])
{
    static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
    static const double zero[6] = { 3.141592653589793, 3.141592653589793, 0.0, 0.0, 0.0, 0.0 };
    struct descent d = { .T = T };
    struct kept kept = { .count = 0 };
    double angles[16][6], residual[16], u[6];
    const int count = xarm7_general(T, free_joints, angles, residual);
    d.q[2] = free_joints[0];
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
    d1 = 0.267, /* joint offset 1 [m] */
    d3 = 0.293, /* joint offset 3 [m] */
    a3 = 0.0525, /* link length 3 [m] */
    a4 = 0.0775, /* link length 4 [m] */
    d5 = 0.3425, /* joint offset 5 [m] */
    a6 = 0.076, /* link length 6 [m] */
    d7 = 0.097, /* joint offset 7 [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 3.141592653589793; /* offset of joint 2 [rad] */

const char *const xarm7_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[7] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[7] = {
    INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY,
};
#define slack(joint) 1e-09 /* of limits */

void xarm7_fk(const double q[7], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        z3_x = x2_x * s3 - s1 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, y6_x = z3_x * c5 - x4_x * s5,
        y6_y = z3_y * c5 - x4_y * s5, y6_z = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 + z4_x * s6,
        x6_y = x5_y * c6 + z4_y * s6, x6_z = x5_z * c6 + z4_z * s6, z6_x = z4_x * c6 - x5_x * s6,
        z6_y = z4_y * c6 - x5_y * s6, z6_z = z4_z * c6 - x5_z * s6;
    const double c7 = cos(q[6]), s7 = sin(q[6]);
    T[0] = x6_x * c7 + y6_x * s7; T[1] = y6_x * c7 - x6_x * s7; T[2] = z6_x;
    T[3] = x3_x * a3 + z2_x * d3 + x4_x * a4 + z4_x * d5 + x6_x * a6 + z6_x * d7;
    T[4] = x6_y * c7 + y6_y * s7; T[5] = y6_y * c7 - x6_y * s7; T[6] = z6_y;
    T[7] = x3_y * a3 + z2_y * d3 + x4_y * a4 + z4_y * d5 + x6_y * a6 + z6_y * d7;
    T[8] = x6_z * c7 + y6_z * s7; T[9] = y6_z * c7 - x6_z * s7; T[10] = z6_z;
    T[11] = d1 + x3_z * a3 - c2 * d3 + x4_z * a4 + z4_z * d5 + x6_z * a6 + z6_z * d7;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void xarm7_jacobian(const double q[7], double J[42])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        p3_x = x3_x * a3 + z2_x * d3, p3_y = x3_y * a3 + z2_y * d3, p3_z = d1 + x3_z * a3 - c2 * d3,
        z3_x = x2_x * s3 - s1 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        p4_x = p3_x + x4_x * a4, p4_y = p3_y + x4_y * a4, p4_z = p3_z + x4_z * a4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, p5_x = p4_x + z4_x * d5,
        p5_y = p4_y + z4_y * d5, p5_z = p4_z + z4_z * d5, z5_x = x4_x * s5 - z3_x * c5,
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), z6_x = z4_x * c6 - x5_x * s6,
        z6_y = z4_y * c6 - x5_y * s6, z6_z = z4_z * c6 - x5_z * s6,
        p6_x = p5_x + (x5_x * c6 + z4_x * s6) * a6, p6_y = p5_y + (x5_y * c6 + z4_y * s6) * a6,
        p6_z = p5_z + (x5_z * c6 + z4_z * s6) * a6, p7_x = p6_x + z6_x * d7,
        p7_y = p6_y + z6_y * d7, p7_z = p6_z + z6_z * d7, v3 = p7_z - d1, v4 = p7_x - p3_x,
        v5 = p7_y - p3_y, v6 = p7_z - p3_z, v7 = p7_x - p4_x, v8 = p7_y - p4_y, v9 = p7_z - p4_z,
        v10 = p7_x - p5_x, v11 = p7_y - p5_y, v12 = p7_z - p5_z, v13 = p7_x - p6_x,
        v14 = p7_y - p6_y, v15 = p7_z - p6_z;
    J[0] = -p7_y; J[1] = -(c1 * v3); J[2] = z2_y * v3 + c2 * p7_y; J[3] = z3_y * v6 - z3_z * v5;
    J[4] = z4_y * v9 - z4_z * v8; J[5] = z5_y * v12 - z5_z * v11; J[6] = z6_y * v15 - z6_z * v14;
    J[7] = p7_x; J[8] = -(s1 * v3); J[9] = -(c2 * p7_x + z2_x * v3); J[10] = z3_z * v4 - z3_x * v6;
    J[11] = z4_z * v7 - z4_x * v9; J[12] = z5_z * v10 - z5_x * v12; J[13] = z6_z * v13 - z6_x * v15;
    J[14] = 0.0; J[15] = s1 * p7_y + c1 * p7_x; J[16] = z2_x * p7_y - z2_y * p7_x;
    J[17] = z3_x * v5 - z3_y * v4; J[18] = z4_x * v8 - z4_y * v7; J[19] = z5_x * v11 - z5_y * v10;
    J[20] = z6_x * v14 - z6_y * v13;
    J[21] = 0.0; J[22] = s1; J[23] = z2_x; J[24] = z3_x; J[25] = z4_x; J[26] = z5_x; J[27] = z6_x;
    J[28] = 0.0; J[29] = -c1; J[30] = z2_y; J[31] = z3_y; J[32] = z4_y; J[33] = z5_y; J[34] = z6_y;
    J[35] = 1.0; J[36] = 0.0; J[37] = -c2; J[38] = z3_z; J[39] = z4_z; J[40] = z5_z; J[41] = z6_z;
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
    const double T[16], const double free_joints[1], const double seed[7], double q[16][7],
    unsigned char status[16])
{

    /* all joints: the general 6R loop */
    double solution_roots[16][7];
    int solution_found[16], solution_chosen[16];
    all_joints(T, free_joints, seed, solution_roots, solution_found, solution_chosen);

    for (int i1 = 0; i1 < 16; i1++) { /* root1 to root16 */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const double q5 = solution_roots[i1][4];
        const double q6 = solution_roots[i1][5];
        const double q7 = solution_roots[i1][6];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: the general 6R loop */
        if (!found) continue; /* out of reach */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        q[row][5] = q6; q[row][6] = q7;
        status[row] = (chosen) ? FREE : OK;
    }
}

static void take(const double from[7], double to[7])
{
    for (int i = 0; i < 7; i++)
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

int xarm7_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[16][7],
    unsigned char status[16])
{
    const double zeros[7] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = isfinite(free_joints[0]) ? read_pose(T, pose) : 0;
    for (int i = 0; i < 7; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 16; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 7; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, free_joints, seed, q, status);
    for (int row = 0; row < 16; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 7; i++) {
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

int xarm7_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    double all[16][7], found[7], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = xarm7_ik(T, free_joints, q_seed, all, status) >= 0;
    for (int i = 0; i < 7; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 16 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 7; i++) {
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

void xarm7_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)xarm7_ik(
            T + 16 * k, free_joints + k, NULL, (double (*)[7])(q + 112 * k), status + 16 * k);
}
