/* puma560_calibrated: PUMA 560 with calibration noise of 1e-3
 *
 * Inverse kinematics, generated from robots/puma560_calibrated.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma560_calibrated.yaml. The formulas and where they come from:
 * puma560_calibrated.md.
 */
#include "puma560_calibrated.h"

#include <math.h>

static const double turn = 6.283185307179586;

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size; between which values starts lie, and what is added
 * from start to start. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double part[6] = {
    0.5843514598369508, 0.5843514598369508, 0.5843514598369508, 0.5843514598369508,
    0.5843514598369508, 0.5843514598369508,
};
static const double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
static const double no_lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double no_highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

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
    puma560_calibrated_fk(d->q, P);
    puma560_calibrated_jacobian(d->q, J);
    d->e[0] = (d->T[3] - P[3]) / 1.7112988821471;
    for (int j = 0; j < 6; j++)
        d->A[0][j] = part[j] * J[0 + solved[j]];
    d->e[1] = (d->T[7] - P[7]) / 1.7112988821471;
    for (int j = 0; j < 6; j++)
        d->A[1][j] = part[j] * J[6 + solved[j]];
    d->e[2] = (d->T[11] - P[11]) / 1.7112988821471;
    for (int j = 0; j < 6; j++)
        d->A[2][j] = part[j] * J[12 + solved[j]];
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

/* The damped least squares step A' (A A' + damping)^-1 e. */
static void damped_step(
    const struct descent *d, const double e[6], double length, double step[6])
{
    double L[6][6], y[6];
    const double damping = 0.1 * fmin(length * length, 1.0) + 1e-13;
    for (int i = 0; i < 6; i++) {
        y[i] = e[i];
        for (int j = 0; j <= i; j++) {
            double sum = i == j ? damping : 0.0;
            for (int k = 0; k < 6; k++)
                sum += d->A[i][k] * d->A[j][k];
            for (int k = 0; k < j; k++)
                sum -= L[i][k] * L[j][k];
            L[i][j] = i == j ? sqrt(fmax(sum, 1e-13)) : sum / L[j][j];
        }
        for (int k = 0; k < i; k++)
            y[i] -= L[i][k] * y[k];
        y[i] /= L[i][i];
    }
    for (int i = 6 - 1; i >= 0; i--) {
        for (int k = i + 1; k < 6; k++)
            y[i] -= L[k][i] * y[k];
        y[i] /= L[i][i];
    }
    for (int j = 0; j < 6; j++) {
        step[j] = 0.0;
        for (int i = 0; i < 6; i++)
            step[j] += d->A[i][j] * y[i];
    }
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

static void copy(const double from[6], double to[6])
{
    for (int j = 0; j < 6; j++)
        to[j] = from[j];
}

/* Takes u to where damped least squares lead; returns by how much that misses the pose. */
static double descend(struct descent *d, double u[6])
{
    double least = HUGE_VAL, best[6], step[6];
    for (int k = 0; k <= 40; k++) {
        look(d, u);
        const int stalled = d->length >= 0.5 * least && least <= 1e-10;
        if (d->length < least) {
            least = d->length;
            copy(u, best);
        }
        if (stalled)
            break;
        damped_step(d, d->e, d->length, step);
        shorten(step);
        for (int j = 0; j < 6; j++)
            u[j] += step[j];
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
        wish[j] = pull * (d->seed[j] - u[j]);
        locked[j] = 0;
    }
    while (beyond) {
        beyond = 0;
        for (int i = 0; i < 6; i++) {
            e[i] = d->e[i];
            for (int j = 0; j < 6; j++)
                e[i] -= d->A[i][j] * wish[j];
        }
        damped_step(d, e, d->length, step);
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

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[6])
{
    for (int j = 0; j < 6; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[6])
{
    for (int j = 0; j < 6; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

static double distance_between(const double a[6], const double b[6])
{
    double most = 0.0;
    for (int j = 0; j < 6; j++)
        most = fmax(most, fabs(a[j] - b[j]));
    return most;
}
/* Whether u is one of a continuum of solutions: 1 if there are others to both sides, 0 if it is a
 * singular solution that stands alone, -1 if it is a regular one. */
static int continuum(struct descent *d, const double u[6])
{
    double along[6], moved[6], square = 0.0;
    look(d, u);
    for (int i = 0; i < 6; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < 6; j++)
            moved[i] += d->A[i][j] * stride[j];
    }
    damped_step(d, moved, 0.0, along);
    for (int j = 0; j < 6; j++) {
        along[j] = stride[j] - along[j]; /* what of it leaves the tool where it is */
        square += along[j] * along[j];
    }
    if (sqrt(square) <= 0.0001)
        return -1;
    for (int side = -1; side <= 1; side += 2) {
        double end[6];
        for (int j = 0; j < 6; j++)
            end[j] = u[j] - side * 0.05 * along[j] / sqrt(square);
        if (descend(d, end) > 1e-10 || distance_between(end, u) <= 0.002)
            return 0;
    }
    return 1;
}

/* The solutions kept so far. */
struct kept {
    double u[16][6];
    int count, singular[16], chosen[16];
};

static int is_known(const struct kept *kept, const double u[6], int singular)
{
    static const double none[6] = { 0.0 };
    for (int k = 0; k < kept->count; k++) {
        double gap[6];
        for (int j = 0; j < 6; j++)
            gap[j] = u[j] - kept->u[k][j];
        wrap_angles(gap);
        const int loose = singular && kept->singular[k];
        if (distance_between(gap, none) < (loose ? 0.001 : 1e-06))
            return 1;
    }
    return 0;
}

/* A solution joins those found before, unless it is one of them. */
static void keep(struct descent *d, struct kept *kept, double u[6])
{
    if (kept->count == 16 || is_known(kept, u, 0))
        return;
    const int kind = continuum(d, u);
    if (kind == 1) {
        double end[6];
        copy(u, end);
        if (pulled(d, end, no_lowest, no_highest) <= 1e-10)
            copy(end, u);
    }
    wrap_angles(u);
    if (is_known(kept, u, kind >= 0))
        return;
    kept->singular[kept->count] = kind >= 0;
    kept->chosen[kept->count] = kind == 1;
    copy(u, kept->u[kept->count++]);
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
 * parallel
 * axes. M. Raghavan and B. Roth (1993): six equations in the hidden joint and two partners, a
 * determinant of degree 8 in the hidden joint; here it is sampled at 24 angles.
 *
 * The loop Rz(q1) K0 Rz(q2) ... K4 Rz(q6) = P, in units of the arm's size, P = L T R. Everything
 * below that has the type puma560_calibrated_lane does PUMA560_CALIBRATED_LANES angles or
 * candidates at once.
 */
/* Lanes: GNU vectors where the compiler has them, plain doubles otherwise. Vectors wider than the
 * machine's are slow: compile for the machine, or set PUMA560_CALIBRATED_LANES to 1, 2, 4 or 8. */
#ifndef PUMA560_CALIBRATED_LANES
#if defined(__GNUC__) && defined(__AVX512F__)
#define PUMA560_CALIBRATED_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define PUMA560_CALIBRATED_LANES 4
#elif defined(__GNUC__) && defined(__SSE2__)
#define PUMA560_CALIBRATED_LANES 2
#else
#define PUMA560_CALIBRATED_LANES 1
#endif
#endif

#define PUMA560_CALIBRATED_ROOTS 24
#define PUMA560_CALIBRATED_CANDIDATES 96

#if PUMA560_CALIBRATED_LANES > 1
typedef double puma560_calibrated_lane __attribute__((vector_size(8 * PUMA560_CALIBRATED_LANES)));
typedef long long puma560_calibrated_mask __attribute__((vector_size(8 *
    PUMA560_CALIBRATED_LANES)));
/* the same where it lies between other doubles */
typedef double puma560_calibrated_packed
    __attribute__((vector_size(8 * PUMA560_CALIBRATED_LANES), aligned(8), may_alias));
#define PUMA560_CALIBRATED_LOAD(from) (puma560_calibrated_lane)(*(const puma560_calibrated_packed *)(from))
#define PUMA560_CALIBRATED_STORE(to, x) (*(puma560_calibrated_packed *)(to) = (puma560_calibrated_packed)(x))

static inline puma560_calibrated_lane puma560_calibrated_select(puma560_calibrated_mask m,
    puma560_calibrated_lane a, puma560_calibrated_lane b)
{
    return (puma560_calibrated_lane)((m & (puma560_calibrated_mask)a) | (~m &
        (puma560_calibrated_mask)b));
}

static inline puma560_calibrated_lane puma560_calibrated_abs(puma560_calibrated_lane x)
{
    return (puma560_calibrated_lane)((puma560_calibrated_mask)x & 0x7fffffffffffffffLL);
}

/* the magnitude of the first with the sign of the second */
static inline puma560_calibrated_lane puma560_calibrated_with_sign(puma560_calibrated_lane x,
    puma560_calibrated_lane y)
{
    const puma560_calibrated_mask sign = (puma560_calibrated_mask)y & (-0x7fffffffffffffffLL - 1);
    return (puma560_calibrated_lane)(((puma560_calibrated_mask)x & 0x7fffffffffffffffLL) | sign);
}

static inline puma560_calibrated_lane puma560_calibrated_sqrt(puma560_calibrated_lane x)
{
    puma560_calibrated_lane r;
    for (int k = 0; k < PUMA560_CALIBRATED_LANES; k++) {
        r[k] = sqrt(x[k]);
    }
    return r;
}
#else
typedef double puma560_calibrated_lane;
typedef int puma560_calibrated_mask;
#define PUMA560_CALIBRATED_LOAD(from) (*(from))
#define PUMA560_CALIBRATED_STORE(to, x) (*(to) = (x))

static inline puma560_calibrated_lane puma560_calibrated_select(puma560_calibrated_mask m,
    puma560_calibrated_lane a, puma560_calibrated_lane b)
{
    return m ? a : b;
}

static inline puma560_calibrated_lane puma560_calibrated_abs(puma560_calibrated_lane x)
{
    return fabs(x);
}

static inline puma560_calibrated_lane puma560_calibrated_with_sign(puma560_calibrated_lane x,
    puma560_calibrated_lane y)
{
    return copysign(x, y);
}

static inline puma560_calibrated_lane puma560_calibrated_sqrt(puma560_calibrated_lane x)
{
    return sqrt(x);
}
#endif

static inline puma560_calibrated_lane puma560_calibrated_all(double x)
{
    const puma560_calibrated_lane zero = {0};
    return zero + x;
}

static inline puma560_calibrated_lane puma560_calibrated_max(puma560_calibrated_lane a,
    puma560_calibrated_lane b)
{
    return puma560_calibrated_select(a > b, a, b);
}

static inline puma560_calibrated_lane puma560_calibrated_min(puma560_calibrated_lane a,
    puma560_calibrated_lane b)
{
    return puma560_calibrated_select(a < b, a, b);
}

/* the largest of all lanes */
static inline double puma560_calibrated_largest(puma560_calibrated_lane x)
{
    double each[PUMA560_CALIBRATED_LANES], most;
    PUMA560_CALIBRATED_STORE(each, x);
    most = each[0];
    for (int k = 1; k < PUMA560_CALIBRATED_LANES; k++) {
        most = each[k] > most ? each[k] : most;
    }
    return most;
}

/* The angle of a sine and a cosine with any positive common factor, in (-pi, pi], within 3 ulp:
 * atan of a ratio below tan(pi/8) by a polynomial. */
static inline puma560_calibrated_lane puma560_calibrated_angle(puma560_calibrated_lane y,
    puma560_calibrated_lane x)
{
    static const double odd[] = { -0.3333333333333333, 0.19999999999995513, -0.14285714284665177,
        0.11111111015146682, -0.0909090457366891, 0.07692183087347286, -0.0666450998991572,
        0.05858136252639731, -0.050853834915688644, 0.039229744582632814, -0.01917454359469326 };
    const puma560_calibrated_lane ax = puma560_calibrated_abs(x), ay = puma560_calibrated_abs(y),
        zero = {0};
    const puma560_calibrated_mask steep = ay > ax;
    const puma560_calibrated_lane high = puma560_calibrated_select(steep, ay, ax), low =
        puma560_calibrated_select(steep, ax, ay);
    const puma560_calibrated_mask turned = low > high * 0.41421356237309515;
    const puma560_calibrated_lane up = puma560_calibrated_select(turned, low - high, low);
    const puma560_calibrated_lane down = puma560_calibrated_select(turned, low + high, high);
    const puma560_calibrated_lane r = up / (down + 1e-300), u = r * r;
    puma560_calibrated_lane a = puma560_calibrated_all(odd[10]);
    for (int k = 9; k >= 0; k--) {
        a = a * u + odd[k];
    }
    a = r + r * u * a + puma560_calibrated_select(turned, zero + 0.7853981633974483, zero);
    a = puma560_calibrated_select(steep, 1.5707963267948966 - a, a);
    a = puma560_calibrated_select(x < 0.0, 3.141592653589793 - a, a);
    return puma560_calibrated_with_sign(a, y + 0.0);
}

/* A formulation: which joint is hidden, and what belongs to it. */
typedef struct {
    int joint[6];       /* the joints phi_1 (hidden) ... phi_6 are, from 0 */
    double sign;        /* phi = sign q; -1 reads the loop backwards */
    int inverted;       /* whether the table multiplies the monomials of the pose's inverse */
    int pose;           /* which of the six links is the pose */
    int each_pose;      /* whether the right side depends on the pose */
    double link[6][12]; /* the links L0 ... L5, three rows of four; zero for the pose */
    const double *table; /* 35 columns of 168, or of 128 for each_pose */
    const double *left; /* for each_pose, 14 rows of 32: the left side's features */
} puma560_calibrated_formulation;

static const double puma560_calibrated_left[12] = {
    1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.6713392129385739
};

static const double puma560_calibrated_right[12] = {
    1.0, 0.0, 0.0, 9.3840846e-05, 0.0, 0.9999988042061223, -0.0015464754525777457,
        -1.8577765638974755e-06, 0.0, 0.0015464754525777457, 0.9999988042061223,
        0.0012012957200730212
};

static const double puma560_calibrated_link[5][12] = {
    { 1.0, 0.0, 0.0, 0.005748047346394125, 0.0, 0.001608544259234068, -0.9999987062918463,
        -0.10776509798954229, 0.0, 0.9999987062918463, 0.001608544259234068, 1.4537379415938628e-09
        },
    { 1.0, 0.0, 0.0, 0.934264777131646, 0.0, 0.9999994314394958, -0.001066358610003491,
        -0.0002301637995154427, 0.0, 0.001066358610003491, 0.9999994314394958, 0.10776495868305999
        },
    { 1.0, 0.0, 0.0, 0.04371101205844448, 0.0, 0.0017412729567630927, 0.9999984839830959,
        0.4683915670885376, 0.0, -0.9999984839830959, 0.0017412729567630927, 0.10776514306515093 },
    { 1.0, 0.0, 0.0, -0.004034857607497308, 0.0, 0.001238887228280428, -0.9999992325789233,
        0.000970397312505304, 0.0, 0.9999992325789233, 0.001238887228280428, 0.46857850599669737 },
    { 1.0, 0.0, 0.0, -0.00013641222461592016, 0.0, 0.0007308690395286796, 0.9999997329151878,
        2.8495176635072937e-07, 0.0, -0.9999997329151878, 0.0007308690395286796,
        -0.0003898806422463197 },
};

/* poses close by, for those at which the formulations fail */
static const double puma560_calibrated_nudge[10][12] = {
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

static const double puma560_calibrated_table_1[] = {
    0.027026388195224498, -0.0005113091354899665, 0.026999270974497853, 0.0014297185916486027,
        -3.028601403784868e-07, 0.0015464165709463361, 0.028289763810817985, -0.0005112641907509123,
        0.028310342308562032, 0.3254712682091267, 8.131281551153496e-07, 0.32547126991117376,
        -0.007796876545074859, 1.1398049991355665e-06, -0.008342524450571195, 0.3227507184632914,
        1.371319472525373e-07, 0.32275071874683636, 0.0013061185405686953, 5.871411270886407e-06,
        0.0013064299301929017, -1.6416069029682615e-05, 3.477548781836608e-09,
        -1.7756016263389284e-05, 0.0012916116105237774, 5.8708952984382e-06, 0.0012913753056770455,
        -0.00021679443237698456, -2.1385069181201795e-07, -0.0002168057448978689,
        6.059889046257915e-06, -9.250281015504696e-10, 6.490919449184419e-06,
        -0.0002143610700597525, -2.1335825250945653e-07, -0.0002143524864089262,
        0.00015470112641668624, -3.579510855442649e-07, 0.00015468212524407467,
        -2.2504402424390305e-06, 2.6322002844083126e-10, -2.3962708673464887e-06,
        0.00015445159804346434, -3.5820156771528156e-07, 0.00015446601815712754,
        -0.0013502857640588588, -2.7760218639248362e-08, -0.0013502872362673303,
        8.731501038998161e-08, -1.7859692753214504e-11, 9.432907653394456e-08,
        -0.0013502137919822693, -2.7756938009415243e-08, -0.0013502126747665375, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        4.630283496895229e-06, -0.00018934239718019764, -4.657832888123769e-06,
        -3.2302085420413774e-05, 4.374270416505575e-06, 3.2302414977474506e-05,
        -3.8114753391540773e-06, -0.000187777626705859, 3.7841415300331533e-06,
        -1.712920018318272e-05, 0.0006722914897191318, 1.722703311511501e-05,
        0.00010629194225942655, -1.6661826114254504e-05, -0.0001062931970900318,
        1.4213403440734692e-05, 0.0006663874154388294, -1.4116392255373726e-05, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -0.020953351123600653, 0.8271572174244983, 0.02107371784409333,
        0.13226106809003849, -0.020300296956814904, -0.13226259701742757, 0.017367384485592864,
        0.8199546029633431, -0.01724801886184455, 0.005865198434989299, -0.2221783641473532,
        -0.005897534418290234, -0.03263390178393175, 0.00584180355266372, 0.032634341610244165,
        -0.004899070791782645, -0.22012388824946955, 0.004867023082352566, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, -1.604797390429149e-05, 8.10926412718758e-08, -1.6182416239162676e-05,
        -8.439758414556258e-06, -4.712632387525098e-08, -8.436529563839364e-06,
        1.624482628182121e-05, -7.98705053718891e-08, 1.6110576994689044e-05,
        5.2766215393790575e-05, -3.0803281114135754e-07, 5.324256278220485e-05,
        3.1334992501549766e-05, 1.5545113902877216e-07, 3.1322694574838796e-05,
        -5.3490416546244964e-05, 3.0368485273743483e-07, -5.301476528067283e-05, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.06566573624047713, -0.0003754389693694831, 0.06625199148331036,
        0.03831146101905288, 0.0001933585098943928, 0.03829647741946022, -0.06655230126723938,
        0.0003700909495251654, -0.06596690061687568, -0.0161873563138296, 0.00010776334095880284,
        -0.016344478797990863, -0.010761603066633665, -4.7848240117067146e-05,
        -0.010757291548826025, 0.016434181258791616, -0.00010632388996543776, 0.016277291996667016,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        1.604797390429149e-05, -8.10926412718758e-08, 1.6182416239162676e-05, 8.439758414556258e-06,
        4.712632387525098e-08, 8.436529563839364e-06, -1.624482628182121e-05, 7.98705053718891e-08,
        -1.6110576994689044e-05, -5.2766215393790575e-05, 3.0803281114135754e-07,
        -5.324256278220485e-05, -3.1334992501549766e-05, -1.5545113902877216e-07,
        -3.1322694574838796e-05, 5.3490416546244964e-05, -3.0368485273743483e-07,
        5.301476528067283e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.06566573624047713,
        0.0003754389693694831, -0.06625199148331036, -0.03831146101905288, -0.0001933585098943928,
        -0.03829647741946022, 0.06655230126723938, -0.0003700909495251654, 0.06596690061687568,
        0.0161873563138296, -0.00010776334095880284, 0.016344478797990863, 0.010761603066633665,
        4.7848240117067146e-05, 0.010757291548826025, -0.016434181258791616, 0.00010632388996543776,
        -0.016277291996667016, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.630283496895229e-06,
        -0.00018934239718019764, -4.657832888123769e-06, -3.2302085420413774e-05,
        4.374270416505575e-06, 3.2302414977474506e-05, -3.8114753391540773e-06,
        -0.000187777626705859, 3.7841415300331533e-06, -1.712920018318272e-05,
        0.0006722914897191318, 1.722703311511501e-05, 0.00010629194225942655,
        -1.6661826114254504e-05, -0.0001062931970900318, 1.4213403440734692e-05,
        0.0006663874154388294, -1.4116392255373726e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.020953351123600653, 0.8271572174244983, 0.02107371784409333, 0.13226106809003849,
        -0.020300296956814904, -0.13226259701742757, 0.017367384485592864, 0.8199546029633431,
        -0.01724801886184455, 0.005865198434989299, -0.2221783641473532, -0.005897534418290234,
        -0.03263390178393175, 0.00584180355266372, 0.032634341610244165, -0.004899070791782645,
        -0.22012388824946955, 0.004867023082352566, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -9.468290389103141e-05, -9.288059597483109e-06, 9.465944556764955e-05, 2.1066543500805946e-06,
        6.460446157161145e-05, -2.267614965258474e-06, -9.387696205081866e-05,
        7.595560522989246e-06, 9.390061668349678e-05, 0.0003361843273546274, 3.435601734211044e-05,
        -0.00033610699365298045, -8.025056945883214e-06, -0.00021258500012390018,
        8.636764974525072e-06, 0.0003331545895968614, -2.832958130873914e-05,
        -0.0003332326561644011, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.4136266051523532,
        0.042026805795071634, -0.41353040456783025, -0.009777386834329507, -0.26452349405198783,
        0.010522905012730583, 0.40992864907266574, -0.03461514210470466, -0.4100257450116151,
        -0.11110104870093038, -0.011762657233837355, 0.111077259907885, 0.002813859113846853,
        0.06526819697751507, -0.00302794296856578, -0.11004989537166536, 0.009766018773681467,
        0.11007393699677832, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        1.712920018318272e-05, -0.0006722914897191318, -1.722703311511501e-05,
        -0.00010629194225942676, 1.6661826114254504e-05, 0.00010629319709003202,
        -1.4213403440734692e-05, -0.0006663874154388294, 1.4116392255373726e-05,
        4.630283496864699e-06, -0.00018934239718020046, -4.657832888093239e-06,
        -3.230208542041394e-05, 4.374270416505543e-06, 3.230241497747467e-05,
        -3.811475339123549e-06, -0.00018777762670586128, 3.784141530002625e-06, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -0.0058651984349893, 0.2221783641473532, 0.005897534418290235,
        0.032633901783932086, -0.005841803552663719, -0.0326343416102445, 0.004899070791782646,
        0.22012388824946955, -0.0048670230823525664, -0.020953351123600663, 0.8271572174244988,
        0.02107371784409334, 0.13226106809003893, -0.020300296956814904, -0.132262597017428,
        0.017367384485592868, 0.8199546029633435, -0.017248018861844554, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, -5.276621539379068e-05, 3.0803281114135754e-07, -5.3242562782204956e-05,
        -3.1334992501549766e-05, -1.5545113902877237e-07, -3.1322694574838796e-05,
        5.349041654624507e-05, -3.0368485273743483e-07, 5.3014765280672936e-05,
        -1.6047973904291567e-05, 8.109264127183108e-08, -1.6182416239162754e-05,
        -8.439758414495199e-06, -4.7126323875233455e-08, -8.436529563778305e-06,
        1.6244826281821294e-05, -7.987050537184439e-08, 1.611057699468913e-05, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.01618735631382974, -0.00010776334095880282, 0.016344478797991002,
        0.010761603066633665, 4.784824011706769e-05, 0.010757291548826025, -0.016434181258791754,
        0.00010632388996543775, -0.016277291996667154, 0.06566573624047724, -0.0003754389693694831,
        0.06625199148331047, 0.038311461019052896, 0.000193358509894393, 0.03829647741946023,
        -0.06655230126723949, 0.0003700909495251654, -0.0659669006168758, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        5.276621539379068e-05, -3.0803281114135754e-07, 5.3242562782204956e-05,
        3.1334992501549766e-05, 1.5545113902877237e-07, 3.1322694574838796e-05,
        -5.349041654624507e-05, 3.0368485273743483e-07, -5.3014765280672936e-05,
        1.6047973904291567e-05, -8.109264127183108e-08, 1.6182416239162754e-05,
        8.439758414495199e-06, 4.7126323875233455e-08, 8.436529563778305e-06,
        -1.6244826281821294e-05, 7.987050537184439e-08, -1.611057699468913e-05, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -0.01618735631382974, 0.00010776334095880282,
        -0.016344478797991002, -0.010761603066633665, -4.784824011706769e-05, -0.010757291548826025,
        0.016434181258791754, -0.00010632388996543775, 0.016277291996667154, -0.06566573624047724,
        0.0003754389693694831, -0.06625199148331047, -0.038311461019052896, -0.000193358509894393,
        -0.03829647741946023, 0.06655230126723949, -0.0003700909495251654, 0.0659669006168758, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.712920018318272e-05, -0.0006722914897191318,
        -1.722703311511501e-05, -0.00010629194225942676, 1.6661826114254504e-05,
        0.00010629319709003202, -1.4213403440734692e-05, -0.0006663874154388294,
        1.4116392255373726e-05, 4.630283496864699e-06, -0.00018934239718020046,
        -4.657832888093239e-06, -3.230208542041394e-05, 4.374270416505543e-06,
        3.230241497747467e-05, -3.811475339123549e-06, -0.00018777762670586128,
        3.784141530002625e-06, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0058651984349893,
        0.2221783641473532, 0.005897534418290235, 0.032633901783932086, -0.005841803552663719,
        -0.0326343416102445, 0.004899070791782646, 0.22012388824946955, -0.0048670230823525664,
        -0.020953351123600663, 0.8271572174244988, 0.02107371784409334, 0.13226106809003893,
        -0.020300296956814904, -0.132262597017428, 0.017367384485592868, 0.8199546029633435,
        -0.017248018861844554, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    -0.0003361843273546274, -3.435601734211044e-05, 0.00033610699365298045, 8.025056945883214e-06,
        0.00021258500012390062, -8.636764974525072e-06, -0.0003331545895968614,
        2.832958130873914e-05, 0.0003332326561644011, -9.468290389103281e-05, -9.28805959742205e-06,
        9.465944556765097e-05, 2.106654350080623e-06, 6.460446157161178e-05,
        -2.2676149652584133e-06, -9.387696205081982e-05, 7.595560522928189e-06,
        9.390061668349795e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.11110104870093038,
        0.011762657233837355, -0.111077259907885, -0.002813859113846853, -0.06526819697751574,
        0.00302794296856578, 0.11004989537166536, -0.009766018773681467, -0.11007393699677832,
        0.41362660515235344, 0.04202680579507165, -0.41353040456783047, -0.009777386834329507,
        -0.2645234940519883, 0.010522905012730583, 0.40992864907266596, -0.03461514210470468,
        -0.4100257450116153, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.010772474896921902, 0.0005870550453868466, -0.010772565497117557, 0.022825214775726514,
        7.4349299256068455e-06, -0.02282521490012529, -0.010770138960775026, 0.00034463507493708636,
        0.01077006136582155, -8.978539380142405e-08, 1.0808009762246701e-05, 9.135440519502609e-08,
        3.842345149932715e-06, 3.901093841840891e-08, -3.842342330714988e-06, 4.521075387293789e-08,
        1.0807994379682758e-05, -4.36396725466094e-08, -0.0011663477502342366,
        0.0047577964928955845, 0.0011661905372211904, 2.001336116889926, 2.5939802885050324e-05,
        -2.0013361148597997, 0.0011710613989896047, -0.00017137034571566585, -0.0011712187350236944,
        4.493554353483455e-06, 2.3730307122103432e-07, -4.49359324473745e-06, 9.518323670794406e-06,
        3.0739747318683707e-09, -9.518323724660023e-06, -4.492548736323183e-06,
        1.3618313769264122e-07, 4.492515268457946e-06, 7.5485717941373565e-06,
        4.1587609957323894e-07, -7.548634626043843e-06, 1.5995942853728873e-05,
        5.2261598784607575e-09, -1.5995942939723006e-05, -7.546953524092594e-06,
        2.4600485670675597e-07, 7.546899806228471e-06, -0.027573040223110284, 1.1157813033492292,
        0.02773612628859062, -1.5082523810799289, -0.027644859597010425, 1.5082502989901687,
        0.022713353938690117, 1.1101421218890921, -0.022551630171049962, 0.011411520598697864,
        1.5718574660139174e-05, 0.011411938835887914, -0.021542634341656264, 2.7099616863449568e-05,
        -0.021542642006336918, -0.01141347008391795, -1.571500880820178e-05, -0.011413220903732054,
        1.9188127580111678e-06, 5.032514525523774e-10, 1.926745560189512e-06,
        1.3501179719387062e-07, 5.509222082075708e-09, 1.3504035566764875e-07,
        -1.923600791555137e-06, -5.708296219989458e-10, -1.9156759986725968e-06, 1.0006634264778085,
        -1.2470555845226715e-06, 1.0006669291234105, 0.00233742365888255, 0.002926124415002563,
        0.002337444264614871, -1.0006688842442888, 1.2540815342964922e-06, -1.0006689908905277,
        4.758710159759049e-06, 6.556291147673569e-09, 4.758879059071984e-06, -8.986111645187725e-06,
        1.1300124674281392e-08, -8.98611486234571e-06, -4.759519987791536e-06,
        -6.554756379989913e-09, -4.759421601127638e-06, 7.997208895446329e-06,
        1.101470558120411e-08, 7.99750527628073e-06, -1.5095539665451489e-05,
        1.8991845051394676e-08, -1.5095545024419834e-05, -7.998576957779835e-06,
        -1.1012235066189355e-08, -7.998399043803474e-06, -0.754753231696212, -0.0005098663072572762,
        -0.7539626474389594, 0.05027376305955669, -0.002205108079123848, 0.05025335746257267,
        0.7535544863376946, 0.0005026192054092337, 0.7543469546305397, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.011411520598697864, -1.5718574660139174e-05, -0.011411938835887914, 0.021542634341656264,
        -2.7099616863449568e-05, 0.021542642006336918, 0.01141347008391795, 1.571500880820178e-05,
        0.011413220903732054, -1.9188127580111678e-06, -5.032514525523774e-10,
        -1.926745560189512e-06, -1.3501179719387062e-07, -5.509222082075708e-09,
        -1.3504035566764875e-07, 1.923600791555137e-06, 5.708296219989458e-10,
        1.9156759986725968e-06, -1.0006634264778085, 1.2470555845226715e-06, -1.0006669291234105,
        -0.00233742365888255, -0.002926124415002563, -0.002337444264614871, 1.0006688842442888,
        -1.2540815342964922e-06, 1.0006689908905277, -4.758710159759049e-06, -6.556291147673569e-09,
        -4.758879059071984e-06, 8.986111645187725e-06, -1.1300124674281392e-08,
        8.98611486234571e-06, 4.759519987791536e-06, 6.554756379989913e-09, 4.759421601127638e-06,
        -7.997208895446329e-06, -1.101470558120411e-08, -7.99750527628073e-06,
        1.5095539665451489e-05, -1.8991845051394676e-08, 1.5095545024419834e-05,
        7.998576957779835e-06, 1.1012235066189355e-08, 7.998399043803474e-06, 0.754753231696212,
        0.0005098663072572762, 0.7539626474389594, -0.05027376305955669, 0.002205108079123848,
        -0.05025335746257267, -0.7535544863376946, -0.0005026192054092337, -0.7543469546305397,
        0.010772474896921902, 0.0005870550453868466, -0.010772565497117557, 0.022825214775726514,
        7.4349299256068455e-06, -0.02282521490012529, -0.010770138960775026, 0.00034463507493708636,
        0.01077006136582155, -8.978539380142405e-08, 1.0808009762246701e-05, 9.135440519502609e-08,
        3.842345149932715e-06, 3.901093841840891e-08, -3.842342330714988e-06, 4.521075387293789e-08,
        1.0807994379682758e-05, -4.36396725466094e-08, -0.0011663477502342366,
        0.0047577964928955845, 0.0011661905372211904, 2.001336116889926, 2.5939802885050324e-05,
        -2.0013361148597997, 0.0011710613989896047, -0.00017137034571566585, -0.0011712187350236944,
        4.493554353483455e-06, 2.3730307122103432e-07, -4.49359324473745e-06, 9.518323670794406e-06,
        3.0739747318683707e-09, -9.518323724660023e-06, -4.492548736323183e-06,
        1.3618313769264122e-07, 4.492515268457946e-06, 7.5485717941373565e-06,
        4.1587609957323894e-07, -7.548634626043843e-06, 1.5995942853728873e-05,
        5.2261598784607575e-09, -1.5995942939723006e-05, -7.546953524092594e-06,
        2.4600485670675597e-07, 7.546899806228471e-06, -0.027573040223110284, 1.1157813033492292,
        0.02773612628859062, -1.5082523810799289, -0.027644859597010425, 1.5082502989901687,
        0.022713353938690117, 1.1101421218890921, -0.022551630171049962, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.00030030180572746185, -0.02154503466017148, -0.00028675309076404737, -1.1999331564249484e-05,
        -0.04565042205394751, -1.943426904336961e-05, 0.0001655421382894678, 0.021540194594041998,
        -0.0001790928465742539, 5.405380245130965e-06, 1.8114021518830853e-07,
        -5.402626606206524e-06, 1.8968434195518862e-08, -7.684685691694188e-06,
        -2.0042494542941833e-08, 5.402617892155828e-06, -8.885086735176778e-08,
        -5.405373582238033e-06, 0.0031104269444639783, 0.0023325379990074132,
        -0.0016473682593898362, 1.4220474908508362e-05, -4.002671162321954, -1.1719320401452315e-05,
        -0.0008172169492981647, -0.002342279843031165, -0.0006458466357900076,
        1.214763090277805e-07, -8.987145206760702e-06, -1.1582670212473536e-07,
        -5.0185384010093525e-09, -1.903664421740501e-05, -8.092516290436015e-09,
        6.526633261114251e-08, 8.985061613886119e-06, -7.091676954528205e-08, 2.126855749581266e-07,
        -1.509720240210741e-05, -2.0319041906528508e-07, -8.400393740684563e-09,
        -3.199188045179951e-05, -1.3626558908089967e-08, 1.1825411942337781e-07,
        1.50938493131573e-05, -1.2775067295428666e-07, 0.5573389109094523, 0.05530880863749436,
        -0.558442112430683, -0.013316191557142877, 3.0165020107920824, 0.01432866108069934,
        0.5556219141277559, -0.04526462885056253, -0.5545199250384811, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.00010097876301820188, -2.3636057803629287e-10, -0.00010097876351193595,
        2.266592293819021e-06, -3.3134719832514955e-10, 2.4252149583585087e-06,
        -0.00010018788518138496, -3.9844984822511136e-11, -0.00010018788526461724,
        0.0003585925221885901, 8.999730927970016e-10, 0.0003585925240685457, -8.630339685769996e-06,
        1.2616467828256771e-09, -9.234315742942203e-06, 0.00035558115380077273,
        1.517148693791854e-10, 0.00035558115411769023, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.44118715303306544, 1.0965571809213852e-06, 0.4411871553236659, -0.010515493220814022,
        1.5372324467992904e-06, -0.011251397758291296, 0.43751800152565967, 1.8485444820717648e-07,
        0.43751800191180246, -0.11852242920984507, -3.1544643955903294e-07, -0.11852242986878175,
        0.0030249903556563732, -4.4221542711526073e-07, 0.0032366879034372263, -0.11746692494672831,
        -5.3177051355048286e-08, -0.11746692505780995, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.0003585925221885901, -8.999730927970016e-10, -0.0003585925240685457, 8.630339685769996e-06,
        -1.2616467828256771e-09, 9.234315742942203e-06, -0.00035558115380077273,
        -1.517148693791854e-10, -0.00035558115411769023, -0.00010097876301820172,
        -2.363605780362925e-10, -0.00010097876351193578, 2.2665922938190177e-06,
        -3.3134719832514903e-10, 2.4252149583585045e-06, -0.0001001878851813848,
        -3.9844984822511084e-11, -0.00010018788526461707, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.11852242920984507, 3.1544643955903283e-07, 0.11852242986878175,
        -0.003024990355656373, 4.422154271152607e-07, -0.003236687903437226, 0.11746692494672831,
        5.3177051355048286e-08, 0.11746692505780995, 0.4411871530330656, 1.0965571809213852e-06,
        0.4411871553236661, -0.010515493220814022, 1.5372324467992904e-06, -0.011251397758291296,
        0.43751800152565984, 1.8485444820717648e-07, 0.4375180019118026, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.00030809873884653455, 8.92196514654745e-11, -0.00030809873866016345, -8.555765777396775e-07,
        1.2507450182361623e-10, -9.154522937423896e-07, -0.0003083972735917903,
        1.50403916255684e-11, -0.0003083972735603724, 5.751403652910615e-06, -2.021962237338042e-12,
        5.751403648686935e-06, 1.9389714069999284e-08, -2.8345315789434985e-12,
        2.0746662171706567e-08, 5.758169269806957e-06, -3.4085656469351785e-13,
        5.758169269094941e-06, -0.0005789035841054131, -1.4560207604861073e-09,
        -0.0005789035871468977, 1.3962588274139264e-05, -2.0411542554962184e-09,
        1.4939730463297617e-05, -0.0005740316441271779, -2.454517821238443e-10,
        -0.0005740316446399026, -1.325465278441438e-07, 3.863278836002627e-14,
        -1.325465277634437e-07, -3.704711721094677e-10, 5.4158211546671696e-14,
        -3.963978130035194e-10, -1.3267579566173937e-07, 6.512604084172491e-15,
        -1.3267579564813517e-07, -2.1349533210260013e-07, 6.16755780206865e-14,
        -2.134953319737659e-07, -5.914412251820468e-10, 8.646124557666601e-14,
        -6.32831987566932e-10, -2.1370170259016062e-07, 1.0397091133262142e-14,
        -2.137017025684421e-07, 0.5977706755476886, 1.4932890170556844e-06, 0.5977706786670229,
        -0.014319974196303082, 2.093399568582634e-06, -0.0153221272828324, 0.5927740335638036,
        2.517343573727009e-07, 0.5927740340896521, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.9998676212654493, 0.0, -0.9998676212654493, 0.0, 0.0, 0.0, -0.9998676212654493, 0.0,
        -0.9998676212654493, 1.344240758050675e-07, 0.0, 1.344240758050675e-07, 0.0, 0.0, 0.0,
        1.344240758050675e-07, 0.0, 1.344240758050675e-07, 0.011481574985606478, 0.0,
        0.011481574985606478, 0.0, 0.0, 0.0, 0.011481574985606478, 0.0, 0.011481574985606478,
        -0.00041707199627312816, 0.0, -0.00041707199627312816, 0.0, 0.0, 0.0,
        -0.00041707199627312816, 0.0, -0.00041707199627312816, -0.0007006383805864105, 0.0,
        -0.0007006383805864105, 0.0, 0.0, 0.0, -0.0007006383805864105, 0.0, -0.0007006383805864105,
        -5.428327208539427e-05, 0.0, -5.428327208539427e-05, 0.0, 0.0, 0.0, -5.428327208539427e-05,
        0.0, -5.428327208539427e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.09520630992319427, -3.7486636612308613, -0.09575188658934726, -0.427740633429085,
        -0.0004331667669350174, 0.427740633429085, -0.07961459267673472, -3.747603816415318,
        0.07906901601058174, -1.2799714632261844e-08, 0.005960815936550277, 1.2873062981151878e-08,
        1.9999963604166315, 5.823575148979661e-11, -1.9999963604166315, 1.0703534961580394e-08,
        0.0010052760414952684, -1.063018661269036e-08, -0.0010932631112732466, 0.04304626016565381,
        0.0010995280200167708, 0.004911395055892574, 4.974095180262625e-06, -0.004911395055892574,
        0.0009142219393098704, 0.04303409083643825, -0.000907957030566346, 3.9713142913068624e-05,
        -0.0015678462096963784, -3.994071778841511e-05, -0.0015798820656535756,
        -1.806856471420847e-07, 0.0015798820656535756, -3.3209413320268236e-05,
        -0.0015639316182697236, 3.298183844492175e-05, 6.671402632457637e-05, -0.002624319162371891,
        -6.709632888516472e-05, 0.0005345215167689883, -3.035334434823437e-07,
        -0.0005345215167689883, -5.5788424485110035e-05, -0.0026256435861326238,
        5.540612192452168e-05, 5.168794264250982e-06, -0.00020352408203655042,
        -5.198413871869381e-06, -2.570910658803411e-05, -2.351682259509991e-08,
        2.570910658803411e-05, -4.322312778534984e-06, -0.00020346038066894556,
        4.2926931709165845e-06, -0.2128986426334782, 0.00013956543367525009, -0.21563842484307807,
        -0.17482056345262215, -0.0006252447718434087, -0.17482088004080104, 0.21484116099160913,
        -0.00011597693667024381, 0.21210215338977165, 0.9999928102306385, -1.8763438316349075e-11,
        0.9999971668064568, 2.3503203998243066e-08, 0.002923470837997116, 2.3503246560950823e-08,
        -0.9999996702530486, 1.5592156596559535e-11, -0.9999989355279136, 0.0024445397031147655,
        -1.6026431480129415e-06, 0.0024760008819373386, 0.0020074811561223383,
        7.179173174492223e-06, 0.002007484791534505, -0.0024668458248187307, 1.3317741935627892e-06,
        -0.002435393540182113, -0.000789531958304066, 5.8216540665644657e-08,
        -0.0007906778485574755, -7.292241476576526e-05, -2.30937377578563e-06,
        -7.292254682331064e-05, 0.0007903470424256945, -4.8377136602825415e-08,
        0.0007892040132259613, 0.00026793940076460805, 9.779784579113492e-08,
        0.00026602136713898856, -0.0001225022131586066, 7.813304551367271e-07,
        -0.00012250243500180292, -0.00026658107904867207, -8.126865133523472e-08,
        -0.00026850008065461343, -1.2801793985098153e-05, 7.577071453040202e-09,
        -1.2950543435457163e-05, -9.491088630323012e-06, -3.7579980078273875e-08,
        -9.491105818040556e-06, 1.2907262728040389e-05, -6.296441123809528e-09,
        1.2758559835038737e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.2128986426334782, -0.00013956543367525009, 0.21563842484307807, 0.17482056345262215,
        0.0006252447718434087, 0.17482088004080104, -0.21484116099160913, 0.00011597693667024381,
        -0.21210215338977165, -0.9999928102306385, 1.8763438316349075e-11, -0.9999971668064568,
        -2.3503203998243066e-08, -0.002923470837997116, -2.3503246560950823e-08, 0.9999996702530486,
        -1.5592156596559535e-11, 0.9999989355279136, -0.0024445397031147655, 1.6026431480129415e-06,
        -0.0024760008819373386, -0.0020074811561223383, -7.179173174492223e-06,
        -0.002007484791534505, 0.0024668458248187307, -1.3317741935627892e-06, 0.002435393540182113,
        0.000789531958304066, -5.8216540665644657e-08, 0.0007906778485574755, 7.292241476576526e-05,
        2.30937377578563e-06, 7.292254682331064e-05, -0.0007903470424256945, 4.8377136602825415e-08,
        -0.0007892040132259613, -0.00026793940076460805, -9.779784579113492e-08,
        -0.00026602136713898856, 0.0001225022131586066, -7.813304551367271e-07,
        0.00012250243500180292, 0.00026658107904867207, 8.126865133523472e-08,
        0.00026850008065461343, 1.2801793985098153e-05, -7.577071453040202e-09,
        1.2950543435457163e-05, 9.491088630323012e-06, 3.7579980078273875e-08,
        9.491105818040556e-06, -1.2907262728040389e-05, 6.296441123809528e-09,
        -1.2758559835038737e-05, 0.09520630992319427, -3.7486636612308613, -0.09575188658934726,
        -0.427740633429085, -0.0004331667669350174, 0.427740633429085, -0.07961459267673472,
        -3.747603816415318, 0.07906901601058174, -1.2799714632261844e-08, 0.005960815936550277,
        1.2873062981151878e-08, 1.9999963604166315, 5.823575148979661e-11, -1.9999963604166315,
        1.0703534961580394e-08, 0.0010052760414952684, -1.063018661269036e-08,
        -0.0010932631112732466, 0.04304626016565381, 0.0010995280200167708, 0.004911395055892574,
        4.974095180262625e-06, -0.004911395055892574, 0.0009142219393098704, 0.04303409083643825,
        -0.000907957030566346, 3.9713142913068624e-05, -0.0015678462096963784,
        -3.994071778841511e-05, -0.0015798820656535756, -1.806856471420847e-07,
        0.0015798820656535756, -3.3209413320268236e-05, -0.0015639316182697236,
        3.298183844492175e-05, 6.671402632457637e-05, -0.002624319162371891, -6.709632888516472e-05,
        0.0005345215167689883, -3.035334434823437e-07, -0.0005345215167689883,
        -5.5788424485110035e-05, -0.0026256435861326238, 5.540612192452168e-05,
        5.168794264250982e-06, -0.00020352408203655042, -5.198413871869381e-06,
        -2.570910658803411e-05, -2.351682259509991e-08, 2.570910658803411e-05,
        -4.322312778534984e-06, -0.00020346038066894556, 4.2926931709165845e-06, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0,
    -1.8744873624609044, -0.1909581455105075, 1.8741752975588268, -0.00034435441273982285,
        0.8554810383721165, 8.881223850292996e-05, -1.873644818048658, 0.15868356630533464,
        1.8739579974385976, 0.003711272744171965, 2.5672770756604736e-08, -0.0022495416003349075,
        4.629565224180642e-11, -3.9999916524959582, -1.1940083694105443e-11,
        -0.00022823083881280725, -2.1333715876357734e-08, -0.001233506611814113,
        0.021524915926799795, 0.00219279054562881, -0.02152133274185171, 3.954254470699682e-06,
        -0.009822787488267098, -1.0198393810576666e-06, 0.021515241679984608,
        -0.0018221784831998886, -0.021518837662701566, -0.0007845001211494954,
        -7.965383942714732e-05, 0.0007833456697989725, -1.4363959717496403e-07,
        0.0031597632873821414, 3.704600170872853e-08, -0.0007813881399571701, 6.619123408651192e-05,
        0.0007825430606101708, -0.001311963703682748, -0.00013381031947102753,
        0.0013123547577733525, -2.4129986106006834e-07, -0.0010690427480128189,
        6.22335013531027e-08, -0.001313016580314011, 0.00011119451671125719, 0.0013126263045490885,
        -0.00010177139369851435, -1.0367205367196526e-05, 0.0001017526339798448,
        -1.8695159122068768e-08, 5.141819944304441e-05, 4.821657192044996e-09,
        -0.00010172075304759947, 8.615003648514323e-06, 0.00010173957328016852, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0002723808388647371, -2.7760937763703118e-05, 0.00027238100453785174,
        -3.341180956486232e-07, -2.3195447753677057e-07, 3.341180956486232e-07,
        0.0002723822160010142, -2.306830624283449e-05, -0.0002723823816748437, 0.001037124837011098,
        0.00010569866176994257, -0.0010371254678326444, -2.897503623686089e-07,
        8.831963023242662e-07, 2.897503623686089e-07, -0.001037130080633384, 8.783473798699013e-05,
        0.0010371307114576522, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.263667432547301,
        0.12878753555061634, -1.2636682011612765, -9.573767932257906e-05, 0.0010761157808251702,
        9.573767932257906e-05, -1.2636738215512808, 0.10702089849225828, 1.2636745901685724,
        -0.3635190205483032, -0.0370467822660965, 0.3635192416553701, 0.0005338036595205727,
        -0.0003095660650631634, -0.0005338036595205727, 0.3635208584721186, -0.03078643145741915,
        -0.3635210795801395, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.378227121073642e-07,
        -3.981500589934711e-07, -1.5787596151222938e-07, 0.0005447635558776372,
        1.581342290304711e-07, 0.0005447637176964009, 1.9183010300614247e-07,
        3.9815149504033626e-07, 1.7501003715306913e-07, -2.561920702622208e-07,
        1.516007207998292e-06, -1.79840163707384e-07, -0.0020742568253112356,
        -6.043994349974694e-07, -0.0020742574414568484, 5.05573879924464e-08,
        -1.5160126759301672e-06, 1.1460136375339266e-07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, -0.00018350173445857624, 0.0018471536577750513, -9.047146893547921e-05,
        -2.52734357846327, -0.0007360442843398137, -2.5273443291955986, -6.705129156084574e-05,
        -0.001847160320085303, 1.098211533085201e-05, 0.00030591796495835514,
        -0.0005313704153339159, 0.0002791570651412132, 0.7270405476700627, 0.00021247777237551468,
        0.727040763633119, -0.00023384315001464458, 0.0005313723318797054, -0.0002562908225672918,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        1.378227121073642e-07, 3.981500589934711e-07, 1.5787596151222938e-07,
        -0.0005447635558776372, -1.581342290304711e-07, -0.0005447637176964009,
        -1.9183010300614247e-07, -3.9815149504033626e-07, -1.7501003715306913e-07,
        2.561920702622208e-07, -1.516007207998292e-06, 1.79840163707384e-07, 0.0020742568253112356,
        6.043994349974694e-07, 0.0020742574414568484, -5.05573879924464e-08, 1.5160126759301672e-06,
        -1.1460136375339266e-07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.00018350173445857624, -0.0018471536577750513, 9.047146893547921e-05, 2.52734357846327,
        0.0007360442843398137, 2.5273443291955986, 6.705129156084574e-05, 0.001847160320085303,
        -1.098211533085201e-05, -0.00030591796495835514, 0.0005313704153339159,
        -0.0002791570651412132, -0.7270405476700627, -0.00021247777237551468, -0.727040763633119,
        0.00023384315001464458, -0.0005313723318797054, 0.0002562908225672918, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -0.0002723808388647371, -2.7760937763703118e-05,
        0.00027238100453785174, -3.341180956486232e-07, -2.3195447753677057e-07,
        3.341180956486232e-07, 0.0002723822160010142, -2.306830624283449e-05,
        -0.0002723823816748437, 0.001037124837011098, 0.00010569866176994257,
        -0.0010371254678326444, -2.897503623686089e-07, 8.831963023242662e-07,
        2.897503623686089e-07, -0.001037130080633384, 8.783473798699013e-05, 0.0010371307114576522,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.263667432547301, 0.12878753555061634,
        -1.2636682011612765, -9.573767932257906e-05, 0.0010761157808251702, 9.573767932257906e-05,
        -1.2636738215512808, 0.10702089849225828, 1.2636745901685724, -0.3635190205483032,
        -0.0370467822660965, 0.3635192416553701, 0.0005338036595205727, -0.0003095660650631634,
        -0.0005338036595205727, 0.3635208584721186, -0.03078643145741915, -0.3635210795801395, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -1.3840917758748375e-05, 0.0005447616979046133, 1.3920012763178524e-05, 2.821736534504289e-07,
        6.683519452159883e-07, 5.1412831120709e-07, -1.1573671731135279e-05, -0.0005447644521775684,
        1.149462837962644e-05, 5.269816414431212e-05, -0.0020742497508416152,
        -5.300047005288571e-05, -1.0744122294480864e-06, 5.790591425605718e-07,
        -1.9576092179826065e-06, 4.406841193847621e-05, 0.0020742602380877137,
        -4.376630270007314e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.06420967521270006,
        -2.5273349586939395, -0.06457782674216121, -0.0013090996329784706, 0.00019093745766250714,
        -0.002385216249905062, 0.05369439097143598, 2.5273477367037596, -0.053326479072270117,
        -0.018470248248042706, 0.727038068022314, 0.018576524353970947, 0.0003765884948235096,
        -0.001067452310716028, 0.0006861548004078431, -0.015446315223404972, -0.7270417438704798,
        0.015340108050291379, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.001037124837011098, -0.00010569866176994257, 0.0010371254678326444,
        2.897503623686092e-07, -8.831963023242662e-07, -2.897503623686092e-07, 0.001037130080633384,
        -8.783473798699013e-05, -0.0010371307114576522, -0.00027238083886473664,
        -2.776093776370327e-05, 0.0002723810045378513, -3.3411809571377466e-07,
        -2.3195447753677023e-07, 3.3411809571377466e-07, 0.0002723822160010138,
        -2.3068306242834487e-05, -0.00027238238167484326, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.36351902054830315, 0.0370467822660965, -0.36351924165537003, -0.0005338036595205727,
        0.00030956606506316335, 0.0005338036595205727, -0.36352085847211857, 0.030786431457419154,
        0.36352107958013946, 1.263667432547301, 0.12878753555061634, -1.2636682011612765,
        -9.573767932257966e-05, 0.0010761157808251702, 9.573767932257966e-05, -1.2636738215512808,
        0.10702089849225828, 1.2636745901685724, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        2.56192070262221e-07, -1.516007207998292e-06, 1.7984016370738417e-07, 0.0020742568253112356,
        6.043994349974694e-07, 0.0020742574414568484, -5.0557387992446556e-08,
        1.5160126759301672e-06, -1.1460136375339282e-07, -1.3782271213993976e-07,
        -3.981500589934705e-07, -1.5787596154480505e-07, 0.0005447635558776364,
        1.5813422903037565e-07, 0.0005447637176964001, 1.918301030387182e-07, 3.981514950403357e-07,
        1.7501003718564485e-07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0003059179649583552,
        0.0005313704153339158, -0.00027915706514121326, -0.7270405476700625,
        -0.00021247777237551463, -0.7270407636331189, 0.00023384315001464463,
        -0.0005313723318797053, 0.00025629082256729184, -0.0001835017344585765,
        0.0018471536577750513, -9.047146893547949e-05, -2.52734357846327, -0.0007360442843398137,
        -2.5273443291955986, -6.705129156084545e-05, -0.001847160320085303, 1.0982115330852308e-05,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -2.56192070262221e-07, 1.516007207998292e-06, -1.7984016370738417e-07,
        -0.0020742568253112356, -6.043994349974694e-07, -0.0020742574414568484,
        5.0557387992446556e-08, -1.5160126759301672e-06, 1.1460136375339282e-07,
        1.3782271213993976e-07, 3.981500589934705e-07, 1.5787596154480505e-07,
        -0.0005447635558776364, -1.5813422903037565e-07, -0.0005447637176964001,
        -1.918301030387182e-07, -3.981514950403357e-07, -1.7501003718564485e-07, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0003059179649583552, -0.0005313704153339158,
        0.00027915706514121326, 0.7270405476700625, 0.00021247777237551463, 0.7270407636331189,
        -0.00023384315001464463, 0.0005313723318797053, -0.00025629082256729184,
        0.0001835017344585765, -0.0018471536577750513, 9.047146893547949e-05, 2.52734357846327,
        0.0007360442843398137, 2.5273443291955986, 6.705129156084545e-05, 0.001847160320085303,
        -1.0982115330852308e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.001037124837011098,
        -0.00010569866176994257, 0.0010371254678326444, 2.897503623686092e-07,
        -8.831963023242662e-07, -2.897503623686092e-07, 0.001037130080633384,
        -8.783473798699013e-05, -0.0010371307114576522, -0.00027238083886473664,
        -2.776093776370327e-05, 0.0002723810045378513, -3.3411809571377466e-07,
        -2.3195447753677023e-07, 3.3411809571377466e-07, 0.0002723822160010138,
        -2.3068306242834487e-05, -0.00027238238167484326, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.36351902054830315, 0.0370467822660965, -0.36351924165537003, -0.0005338036595205727,
        0.00030956606506316335, 0.0005338036595205727, -0.36352085847211857, 0.030786431457419154,
        0.36352107958013946, 1.263667432547301, 0.12878753555061634, -1.2636682011612765,
        -9.573767932257966e-05, 0.0010761157808251702, 9.573767932257966e-05, -1.2636738215512808,
        0.10702089849225828, 1.2636745901685724, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -5.269816414431212e-05, 0.0020742497508416152, 5.300047005288571e-05, 1.0744122294480864e-06,
        -5.790591425605724e-07, 1.9576092179826065e-06, -4.406841193847621e-05,
        -0.0020742602380877137, 4.376630270007314e-05, -1.3840917758748475e-05,
        0.0005447616979046125, 1.3920012763178576e-05, 2.8217365345042847e-07, 6.68351945346291e-07,
        5.141283112070892e-07, -1.1573671731135253e-05, -0.0005447644521775676,
        1.1494628379626462e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.018470248248042706,
        -0.7270380680223139, -0.018576524353970947, -0.0003765884948235095, 0.001067452310716028,
        -0.000686154800407843, 0.015446315223404972, 0.7270417438704797, -0.015340108050291379,
        0.06420967521270006, -2.5273349586939395, -0.06457782674216121, -0.0013090996329784706,
        0.00019093745766250833, -0.002385216249905062, 0.05369439097143598, 2.5273477367037596,
        -0.053326479072270117, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.00010281631442640115, 7.891209628794487e-05, -0.00010281637696346915,
        0.022963009868369952, 8.755646907628237e-08, -0.022963009868369952, -0.00010281683425766779,
        2.024390947798574e-05, 0.00010281689679500562, -2.330099947015658e-06,
        -2.363024314891401e-07, 2.3301013642773027e-06, 3.932113665141555e-07,
        -1.984269958456483e-09, -3.932113665141555e-07, 2.3301117278192556e-06,
        -1.9714037512891348e-07, -2.330113145087015e-06, -0.001677911602013353,
        -0.0001785998831227772, 0.001677912622587496, -0.002548180461474294,
        -1.4288784432122527e-06, 0.002548180461474294, 0.001677920085403545, -0.0001433837701074404,
        -0.0016779211059820911, 4.4520246940553845e-08, 3.308196000995391e-08,
        -4.452027401958042e-08, 9.5782186567045e-06, 3.791261772283603e-11, -9.5782186567045e-06,
        -4.452047203145005e-08, 8.582426086415306e-09, 4.4520499110593454e-08,
        7.107465135815766e-08, 5.5197599660444404e-08, -7.107469458865401e-08,
        1.609106144690919e-05, 6.052585670343898e-11, -1.609106144690919e-05, -7.10750107060515e-08,
        1.4103306355125739e-08, 7.107505393673438e-08, 1.7208593688185645, 0.17538776080342677,
        -1.7208604155152876, 0.0016126868152649024, 0.0014654519659761682, -0.0016126868152649024,
        -1.7208680693493157, 0.14574168619806743, 1.7208691160505547, 0.011481432244567467,
        1.502907540228689e-07, 0.011481489829755859, -0.0002056333378023484, 3.350603023435546e-05,
        -0.00020563339888450433, -0.011481531390975611, -1.5029129609127073e-07,
        -0.011481516610369323, 1.9685472401100638e-07, -3.4060010800747766e-09,
        1.966840398415629e-07, 4.660215960774313e-06, 1.9317197668389744e-09, 4.660217345063657e-06,
        -1.9639407267842265e-07, 3.4060133648329057e-09, -1.965378156185718e-07,
        -0.0012739032938547602, -2.4526710693449383e-06, -0.0012740323709594264,
        0.003355834773734055, -2.747630484668413e-06, 0.00335583577056475, 0.0012742447213425609,
        2.452679915634223e-06, 0.0012741401720359352, 4.789078833030757e-06, 6.507704073335323e-11,
        4.789102972978317e-06, -8.904080086165876e-08, 1.3974920306073154e-08,
        -8.904082731069733e-08, -4.789120512479287e-06, -6.507727545309827e-11,
        -4.789114246362379e-06, 8.045479891453446e-06, 1.0389268477597901e-10,
        8.045520171994532e-06, -1.4214979279750622e-07, 2.3479526498068926e-08,
        -1.4214983502225396e-07, -8.045549174284693e-06, -1.0389305949591416e-10,
        -8.045538877011812e-06, 0.0006216341671470016, 0.0025154495524364905, 0.0007483263628122671,
        -3.441730603482303, -0.000999795493141983, -3.441731625827842, -0.0009628426733959786,
        -0.002515458625155087, -0.0008565763214752451, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.011481432244567467, -1.502907540228689e-07, -0.011481489829755859, 0.0002056333378023484,
        -3.350603023435546e-05, 0.00020563339888450433, 0.011481531390975611,
        1.5029129609127073e-07, 0.011481516610369323, -1.9685472401100638e-07,
        3.4060010800747766e-09, -1.966840398415629e-07, -4.660215960774313e-06,
        -1.9317197668389744e-09, -4.660217345063657e-06, 1.9639407267842265e-07,
        -3.4060133648329057e-09, 1.965378156185718e-07, 0.0012739032938547602,
        2.4526710693449383e-06, 0.0012740323709594264, -0.003355834773734055, 2.747630484668413e-06,
        -0.00335583577056475, -0.0012742447213425609, -2.452679915634223e-06,
        -0.0012741401720359352, -4.789078833030757e-06, -6.507704073335323e-11,
        -4.789102972978317e-06, 8.904080086165876e-08, -1.3974920306073154e-08,
        8.904082731069733e-08, 4.789120512479287e-06, 6.507727545309827e-11, 4.789114246362379e-06,
        -8.045479891453446e-06, -1.0389268477597901e-10, -8.045520171994532e-06,
        1.4214979279750622e-07, -2.3479526498068926e-08, 1.4214983502225396e-07,
        8.045549174284693e-06, 1.0389305949591416e-10, 8.045538877011812e-06,
        -0.0006216341671470016, -0.0025154495524364905, -0.0007483263628122671, 3.441730603482303,
        0.000999795493141983, 3.441731625827842, 0.0009628426733959786, 0.002515458625155087,
        0.0008565763214752451, 0.00010281631442640115, 7.891209628794487e-05,
        -0.00010281637696346915, 0.022963009868369952, 8.755646907628237e-08, -0.022963009868369952,
        -0.00010281683425766779, 2.024390947798574e-05, 0.00010281689679500562,
        -2.330099947015658e-06, -2.363024314891401e-07, 2.3301013642773027e-06,
        3.932113665141555e-07, -1.984269958456483e-09, -3.932113665141555e-07,
        2.3301117278192556e-06, -1.9714037512891348e-07, -2.330113145087015e-06,
        -0.001677911602013353, -0.0001785998831227772, 0.001677912622587496, -0.002548180461474294,
        -1.4288784432122527e-06, 0.002548180461474294, 0.001677920085403545, -0.0001433837701074404,
        -0.0016779211059820911, 4.4520246940553845e-08, 3.308196000995391e-08,
        -4.452027401958042e-08, 9.5782186567045e-06, 3.791261772283603e-11, -9.5782186567045e-06,
        -4.452047203145005e-08, 8.582426086415306e-09, 4.4520499110593454e-08,
        7.107465135815766e-08, 5.5197599660444404e-08, -7.107469458865401e-08,
        1.609106144690919e-05, 6.052585670343898e-11, -1.609106144690919e-05, -7.10750107060515e-08,
        1.4103306355125739e-08, 7.107505393673438e-08, 1.7208593688185645, 0.17538776080342677,
        -1.7208604155152876, 0.0016126868152649024, 0.0014654519659761682, -0.0016126868152649024,
        -1.7208680693493157, 0.14574168619806743, 1.7208691160505547, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    4.783251539108988e-05, -0.00020563263646836534, -3.107955988584045e-05, -1.0651283400449796e-07,
        -0.04592600751435886, -1.9406937110885825e-07, 1.7454283349343814e-06,
        0.00020563367613104995, -1.849847574720316e-05, -1.1766813611560537e-07,
        4.660200066620882e-06, 1.1863423373853382e-07, 2.4138732287279817e-09,
        -7.864215312353874e-07, 4.398144728887469e-09, -9.905298986417979e-08,
        -4.660223628231506e-06, 9.808733286065517e-08, -8.998673723947528e-05,
        0.0033558233283089434, 8.861309924614615e-05, 1.7382369805465237e-06, 0.005096360275950961,
        3.167116533943496e-06, -7.100488388923742e-05, -0.003355840295091797, 7.23788481019688e-05,
        2.003469316159671e-08, -8.904049717870447e-08, -1.3047258040903642e-08,
        -4.612086806139032e-11, -1.9156432215964517e-05, -8.403351524090202e-11,
        7.974750162901555e-10, 8.904094736056238e-08, -7.78494878264935e-09, 3.3468653269672366e-08,
        -1.4214930798078616e-07, -2.1728931693408272e-08, -7.362997384484243e-11,
        -3.218211432871336e-05, -1.3415587757459186e-10, 1.1817584006800535e-09,
        1.4215002667667842e-07, -1.2921544195265667e-08, 0.08744382055090469, -3.4417188651004897,
        -0.08794389450051365, -0.0017827288336352853, -0.0032261052117453066,
        -0.0032481819382124224, 0.07312069753639773, 3.4417362661645248, -0.07262094992026365, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        8.663467614496631e-07, 0.0, 0.00029070463623422055, 0.0, -0.00029070463623422055, 0.0,
        1.4604623938469582e-07, 0.0, 0.0, -3.2987259585090336e-06, 0.0, -0.0011068950361170905, 0.0,
        0.0011068950361170905, 0.0, -5.560897119241006e-07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.004019277539123902, 0.0, -1.3486777661409606, 0.0, 1.3486777661409606,
        0.0, -0.0006775582200482743, 0.0, 0.0, 0.001156224966080563, 0.0, 0.38797393044667544, 0.0,
        -0.38797393044667544, 0.0, 0.00019491307140827237, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.00014535153759595172, 0.0, 0.00014535217078197714, 0.0, 4.249340365420779e-07,
        0.0, -0.00014535253467999495, 0.0, -0.00014535242793932022, -0.0005534445461245329, 0.0,
        -0.0005534469570612059, 0.0, -1.617990623811922e-06, 0.0, 0.0005534483426493916, 0.0,
        0.0005534479362206379, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.6743352619671288,
        0.0, -0.6743381995326434, 0.0, -0.0019714136471462576, 0.0, 0.6743398877794222, 0.0,
        0.6743393925730967, 0.19398592354108044, 0.0, 0.19398676859011085, 0.0,
        0.0005671162678154569, 0.0, -0.1939872542478082, 0.0, -0.1939871117918789, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.00014535153759595172, 0.0, -0.00014535217078197714, 0.0, -4.249340365420779e-07, 0.0,
        0.00014535253467999495, 0.0, 0.00014535242793932022, 0.0005534445461245329, 0.0,
        0.0005534469570612059, 0.0, 1.617990623811922e-06, 0.0, -0.0005534483426493916, 0.0,
        -0.0005534479362206379, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6743352619671288,
        0.0, 0.6743381995326434, 0.0, 0.0019714136471462576, 0.0, -0.6743398877794222, 0.0,
        -0.6743393925730967, -0.19398592354108044, 0.0, -0.19398676859011085, 0.0,
        -0.0005671162678154569, 0.0, 0.1939872542478082, 0.0, 0.1939871117918789, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 8.663467614496631e-07, 0.0, 0.00029070463623422055, 0.0,
        -0.00029070463623422055, 0.0, 1.4604623938469582e-07, 0.0, 0.0, -3.2987259585090336e-06,
        0.0, -0.0011068950361170905, 0.0, 0.0011068950361170905, 0.0, -5.560897119241006e-07, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.004019277539123902, 0.0,
        -1.3486777661409606, 0.0, 1.3486777661409606, 0.0, -0.0006775582200482743, 0.0, 0.0,
        0.001156224966080563, 0.0, 0.38797393044667544, 0.0, -0.38797393044667544, 0.0,
        0.00019491307140827237, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
    5.394064634688754e-07, 0.0, -3.2694006659272546e-07, 0.0, -0.0005814091171828547, 0.0,
        -3.321055659231435e-08, 0.0, -1.7925675697027774e-07, -2.0538590116674882e-06, 0.0,
        1.244866065801942e-06, 0.0, 0.002213789480964475, 0.0, 1.264534364326425e-07, 0.0,
        6.825429998336266e-07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.002502490203173313,
        0.0, 0.0015167862624626029, 0.0, 2.6973548118592254, 0.0, 0.00015407507722419984, 0.0,
        0.0008316331163069642, 0.0007198909809327822, 0.0, -0.0004363336763376529, 0.0,
        -0.7759476536494623, 0.0, -4.4322754326699614e-05, 0.0, -0.000239235773676651, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        3.2987259585090336e-06, 0.0, 0.0011068950361170905, 0.0, -0.0011068950361170905, 0.0,
        5.560897119241006e-07, 0.0, 0.0, 8.663467614496617e-07, 0.0, 0.0002907046362342201, 0.0,
        -0.0002907046362342201, 0.0, 1.4604623938469566e-07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.001156224966080563, 0.0, -0.3879739304466754, 0.0, 0.3879739304466754,
        0.0, -0.00019491307140827242, 0.0, 0.0, -0.004019277539123902, 0.0, -1.3486777661409606,
        0.0, 1.3486777661409606, 0.0, -0.0006775582200482743, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0005534445461245329, 0.0, 0.0005534469570612059, 0.0,
        1.617990623811922e-06, 0.0, -0.0005534483426493916, 0.0, -0.0005534479362206379,
        0.0001453515375959515, 0.0, 0.00014535217078197693, 0.0, 4.2493403654207727e-07, 0.0,
        -0.00014535253467999474, 0.0, -0.00014535242793932, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, -0.1939859235410804, 0.0, -0.19398676859011083, 0.0, -0.0005671162678154568, 0.0,
        0.19398725424780816, 0.0, 0.19398711179187889, -0.6743352619671288, 0.0,
        -0.6743381995326434, 0.0, -0.0019714136471462576, 0.0, 0.6743398877794222, 0.0,
        0.6743393925730967, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0005534445461245329, 0.0, -0.0005534469570612059, 0.0, -1.617990623811922e-06, 0.0,
        0.0005534483426493916, 0.0, 0.0005534479362206379, -0.0001453515375959515, 0.0,
        -0.00014535217078197693, 0.0, -4.2493403654207727e-07, 0.0, 0.00014535253467999474, 0.0,
        0.00014535242793932, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1939859235410804, 0.0,
        0.19398676859011083, 0.0, 0.0005671162678154568, 0.0, -0.19398725424780816, 0.0,
        -0.19398711179187889, 0.6743352619671288, 0.0, 0.6743381995326434, 0.0,
        0.0019714136471462576, 0.0, -0.6743398877794222, 0.0, -0.6743393925730967, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.2987259585090336e-06, 0.0, 0.0011068950361170905, 0.0,
        -0.0011068950361170905, 0.0, 5.560897119241006e-07, 0.0, 0.0, 8.663467614496617e-07, 0.0,
        0.0002907046362342201, 0.0, -0.0002907046362342201, 0.0, 1.4604623938469566e-07, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.001156224966080563, 0.0,
        -0.3879739304466754, 0.0, 0.3879739304466754, 0.0, -0.00019491307140827242, 0.0, 0.0,
        -0.004019277539123902, 0.0, -1.3486777661409606, 0.0, 1.3486777661409606, 0.0,
        -0.0006775582200482743, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
    2.0538590116674882e-06, 0.0, -1.244866065801942e-06, 0.0, -0.002213789480964475, 0.0,
        -1.264534364326425e-07, 0.0, -6.825429998336266e-07, 5.394064634688746e-07, 0.0,
        -3.26940066592725e-07, 0.0, -0.0005814091171828539, 0.0, -3.3210556592314294e-08, 0.0,
        -1.7925675697027748e-07, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0007198909809327822, 0.0, 0.0004363336763376529, 0.0, 0.7759476536494622, 0.0,
        4.432275432669964e-05, 0.0, 0.00023923577367665098, -0.002502490203173313, 0.0,
        0.0015167862624626029, 0.0, 2.6973548118592254, 0.0, 0.00015407507722419984, 0.0,
        0.0008316331163069642, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -3.2702219950110687e-07, 0.0, -0.00010973304660065682, 0.0, 0.00010973304660065682, 0.0,
        -5.512845959339736e-08, 0.0, 0.0, 7.4112208162833e-09, 0.0, 2.4868520866217848e-06, 0.0,
        -2.4868520866217848e-06, 0.0, 1.2493622388067775e-09, 0.0, 0.0, 5.336841198014522e-06, 0.0,
        0.0017907892637730564, 0.0, -0.0017907892637730564, 0.0, 8.996693031542224e-07, 0.0, 0.0,
        -1.4160310217357742e-10, 0.0, -4.75152446326756e-08, 0.0, 4.75152446326756e-08, 0.0,
        -2.38710427254935e-11, 0.0, 0.0, -2.260632366136509e-10, 0.0, -7.58560358161162e-08, 0.0,
        7.58560358161162e-08, 0.0, -3.810908869251274e-11, 0.0, 0.0, -0.005473442799060577, 0.0,
        -1.8366262432691844, 0.0, 1.8366262432691844, 0.0, -0.0009226972072388664, 0.0,
        -5.486622867494584e-05, 0.0, -5.4866467685346694e-05, 0.0, -1.6040097274715576e-07, 0.0,
        5.4866605046892274e-05, 0.0, 5.4866564755207965e-05, 1.243419366290887e-06, 0.0,
        1.2434247829227267e-06, 0.0, 3.6351263919983127e-09, 0.0, -1.243427895912449e-06, 0.0,
        -1.2434269827922696e-06, 0.0008953898237454232, 0.0, 0.0008953937242774237, 0.0,
        2.6176648584241697e-06, 0.0, -0.0008953959659501806, 0.0, -0.0008953953084097412,
        -2.3757494741304013e-08, 0.0, -2.3757598234627294e-08, 0.0, -6.945484241530772e-11, 0.0,
        2.3757657713222338e-08, 0.0, 2.3757640266616267e-08, -3.792781424002678e-08, 0.0,
        -3.7927979462647394e-08, 0.0, -1.1088165607875593e-10, 0.0, 3.792807441765543e-08, 0.0,
        3.792804656490238e-08, -0.9183081904244752, 0.0, -0.9183121907943568, 0.0,
        -0.0026846665167826315, 0.0, 0.9183144898448913, 0.0, 0.9183138154740697, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        5.486622867494584e-05, 0.0, 5.4866467685346694e-05, 0.0, 1.6040097274715576e-07, 0.0,
        -5.4866605046892274e-05, 0.0, -5.4866564755207965e-05, -1.243419366290887e-06, 0.0,
        -1.2434247829227267e-06, 0.0, -3.6351263919983127e-09, 0.0, 1.243427895912449e-06, 0.0,
        1.2434269827922696e-06, -0.0008953898237454232, 0.0, -0.0008953937242774237, 0.0,
        -2.6176648584241697e-06, 0.0, 0.0008953959659501806, 0.0, 0.0008953953084097412,
        2.3757494741304013e-08, 0.0, 2.3757598234627294e-08, 0.0, 6.945484241530772e-11, 0.0,
        -2.3757657713222338e-08, 0.0, -2.3757640266616267e-08, 3.792781424002678e-08, 0.0,
        3.7927979462647394e-08, 0.0, 1.1088165607875593e-10, 0.0, -3.792807441765543e-08, 0.0,
        -3.792804656490238e-08, 0.9183081904244752, 0.0, 0.9183121907943568, 0.0,
        0.0026846665167826315, 0.0, -0.9183144898448913, 0.0, -0.9183138154740697, 0.0,
        -3.2702219950110687e-07, 0.0, -0.00010973304660065682, 0.0, 0.00010973304660065682, 0.0,
        -5.512845959339736e-08, 0.0, 0.0, 7.4112208162833e-09, 0.0, 2.4868520866217848e-06, 0.0,
        -2.4868520866217848e-06, 0.0, 1.2493622388067775e-09, 0.0, 0.0, 5.336841198014522e-06, 0.0,
        0.0017907892637730564, 0.0, -0.0017907892637730564, 0.0, 8.996693031542224e-07, 0.0, 0.0,
        -1.4160310217357742e-10, 0.0, -4.75152446326756e-08, 0.0, 4.75152446326756e-08, 0.0,
        -2.38710427254935e-11, 0.0, 0.0, -2.260632366136509e-10, 0.0, -7.58560358161162e-08, 0.0,
        7.58560358161162e-08, 0.0, -3.810908869251274e-11, 0.0, 0.0, -0.005473442799060577, 0.0,
        -1.8366262432691844, 0.0, 1.8366262432691844, 0.0, -0.0009226972072388664, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0,
    -2.036111819862263e-07, 0.0, 1.2341093017221784e-07, 0.0, 0.00021946603458525334, 0.0,
        1.2536076484318522e-08, 0.0, 6.76645213537416e-08, 4.614388358547078e-09, 0.0,
        -2.7968304783117027e-09, 0.0, -4.973702844842725e-06, 0.0, -2.8410190848461495e-10, 0.0,
        -1.533463813605713e-09, 3.322834186970377e-06, 0.0, -2.0140055856549165e-06, 0.0,
        -0.0035815775709608848, 0.0, -2.045825926956547e-07, 0.0, -1.1042516555618706e-06,
        -8.816519199755696e-11, 0.0, 5.3437872355982487e-11, 0.0, 9.503046388415083e-08, 0.0,
        5.428216561361388e-12, 0.0, 2.929925291126192e-11, -1.407519210645564e-10, 0.0,
        8.531125517103742e-11, 0.0, 1.5171203111224225e-07, 0.0, 8.665913289081556e-12, 0.0,
        4.6774991803235514e-11, -0.003407885334851559, 0.0, 0.002065556002335576, 0.0,
        3.6732515054684183, 0.0, 0.00020981908159826198, 0.0, 0.0011325160423987179, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
};

static const double puma560_calibrated_table_2[] = {
    -0.02747688285921836, 3.5057393963124154e-05, -0.027477105019066857, 0.0, 0.0, 0.0,
        -0.02747688285921836, 3.5057393963124154e-05, -0.027477105019066857, 0.022733172670364597,
        4.796688116399921e-05, 0.02273286586535452, 0.0, 0.0, 0.0, 0.022733172670364597,
        4.796688116399921e-05, 0.02273286586535452, 0.0013428981101278848, -5.8712285472895075e-06,
        0.0013429356527197578, 0.0, 0.0, 0.0, 0.0013428981101278848, -5.8712285472895075e-06,
        0.0013429356527197578, -0.060478869408106685, 0.0004854323785061215, -0.06048197307154881,
        0.0, 0.0, 0.0, -0.060478869408106685, 0.0004854323785061215, -0.06048197307154881,
        0.2900130481746582, 0.00014913127707847797, 0.29001209291458446, 0.0, 0.0, 0.0,
        0.2900130481746582, 0.00014913127707847797, 0.29001209291458446, -0.12953694377055947,
        2.468592479524285e-07, -0.129536944539414, 0.0, 0.0, 0.0, -0.12953694377055947,
        2.468592479524285e-07, -0.129536944539414, 0.00016010306795814224, -3.063031364175116e-08,
        0.00016172594638565993, 0.0, 0.0, 0.0, 0.00016010306795814224, -3.063031364175116e-08,
        0.00016172594638565993, -3.131660114169657e-05, 1.800141489121779e-08,
        -2.9504410024674702e-05, 0.0, 0.0, 0.0, -3.131660114169657e-05, 1.800141489121779e-08,
        -2.9504410024674702e-05, -7.4384438797379845e-06, 3.0394656013839647e-10,
        -7.712291708675266e-06, 0.0, 0.0, 0.0, -7.4384438797379845e-06, 3.0394656013839647e-10,
        -7.712291708675266e-06, 0.0009652863403174763, -1.1202400180551338e-07,
        0.0009879534514787155, 0.0, 0.0, 0.0, 0.0009652863403174763, -1.1202400180551338e-07,
        0.0009879534514787155, -0.0010004999596673475, 2.8815753364020995e-07,
        -0.000993486465424851, 0.0, 0.0, 0.0, -0.0010004999596673475, 2.8815753364020995e-07,
        -0.000993486465424851, 0.000538536872893105, -1.3379899466698159e-07, 0.0005385398952788843,
        0.0, 0.0, 0.0, 0.000538536872893105, -1.3379899466698159e-07, 0.0005385398952788843,
        -0.0003842945979077399, -5.937232377270826e-08, -0.00041175488095712665, 0.0, 0.0, 0.0,
        -0.0003842945979077399, -5.937232377270826e-08, -0.00041175488095712665,
        0.00017299998840291156, 2.1724393038772734e-08, 0.00018447469629397984, 0.0, 0.0, 0.0,
        0.00017299998840291156, 2.1724393038772734e-08, 0.00018447469629397984,
        8.738146195420987e-06, 1.8162710096820578e-09, 9.445218729857769e-06, 0.0, 0.0, 0.0,
        8.738146195420987e-06, 1.8162710096820578e-09, 9.445218729857769e-06,
        -0.0017251749923164889, -2.9680168759433956e-07, -0.001853816731046282, 0.0, 0.0, 0.0,
        -0.0017251749923164889, -2.9680168759433956e-07, -0.001853816731046282,
        0.0031895619863296066, 4.5247169818231484e-07, 0.0034103293446621752, 0.0, 0.0, 0.0,
        0.0031895619863296066, 4.5247169818231484e-07, 0.0034103293446621752,
        -0.0015432773779596083, -2.256130802145546e-07, -0.001651281336038263, 0.0, 0.0, 0.0,
        -0.0015432773779596083, -2.256130802145546e-07, -0.001651281336038263, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -6.138560500088459e-05, 0.5848575817284934, 6.741880529629174e-05, 0.0013544779571804581,
        2.0897259639504634e-07, 0.0005095271085739453, 6.138560500088459e-05, -0.5848575817284934,
        -6.741880529629174e-05, -0.001251488820163851, 0.04381596053646078, 0.0012468652443463648,
        -0.007511885142954001, 2.548808246539943e-06, -0.008104448061380597, 0.001251488820163851,
        -0.04381596053646078, -0.0012468652443463648, -2.2886421767001804e-06, 0.002324443173305336,
        2.441359553610272e-06, 5.4914027061850055e-06, 6.822593550612596e-09, 2.050982263555221e-06,
        2.2886421767001804e-06, -0.002324443173305336, -2.441359553610272e-06,
        -0.00019272045373460751, -0.1876097462178674, 0.0002116288399034839, 0.0002630286451116465,
        6.556323529063453e-07, 0.0005683389003167739, 0.00019272045373460751, 0.1876097462178674,
        -0.0002116288399034839, 0.0010370364204303063, 0.46103013356971256, -0.0010980108749623243,
        0.0012502076922461876, -2.981170926327582e-06, 0.0006427941344922456,
        -0.0010370364204303063, -0.46103013356971256, 0.0010980108749623243, 0.0022313546433753565,
        1.0220462607634042, -0.002380493030166322, 0.001100825316191901, -6.655101723510923e-06,
        -0.0003529108834897624, -0.0022313546433753565, -1.0220462607634042, 0.002380493030166322,
        -0.004305919975513112, -0.000295190052286794, 0.004305894875465074, -1.764471150108422,
        0.0005073943379533003, -1.7644716023540958, 0.004305919975513112, 0.000295190052286794,
        -0.004305894875465074, 0.31494481092734083, -0.0002138641622291344, -0.3149447942218696,
        0.006797101696848834, -0.0008840029886104542, 0.006797227445556978, -0.31494481092734083,
        0.0002138641622291344, 0.3149447942218696, -0.0011694103091641256, -0.0024646625079010804,
        0.0011694103897870523, 2.0012899697406894, 2.529547049791303e-06, 2.0012935789796282,
        0.0011694103091641256, 0.0024646625079010804, -0.0011694103897870523, -0.008409834020482797,
        0.0002566872199707685, 0.008409748970817862, 0.36254427281721074, -0.00013412873437316014,
        0.3625446899477905, 0.008409834020482797, -0.0002566872199707685, -0.008409748970817862,
        -0.03594756668676769, -0.0011102999863474192, 0.03594782085656965, -0.6925124856448308,
        0.0004940621392052387, -0.6925131969876024, 0.03594756668676769, 0.0011102999863474192,
        -0.03594782085656965, -0.023088699135217574, -0.0025893520994560762, 0.023089324645091693,
        -1.3850468417707127, 0.000929779990267377, -1.385048571801402, 0.023088699135217574,
        0.0025893520994560762, -0.023089324645091693, -0.8822357658878434, 0.007302353176571285,
        0.8822363582115053, 0.008627158587614418, 0.0025801518475069857, 0.008617143680977261,
        0.8822357658878434, -0.007302353176571285, -0.8822363582115053, 0.0033994152770873854,
        0.0013160634765129104, -0.0033994310479858996, -0.6298884248343043, -8.429828382121088e-06,
        -0.6298903427809496, -0.0033994152770873854, -0.0013160634765129104, 0.0033994310479858996,
        1.0006468887305853, -1.258205945970097e-05, -1.0006468877447325, 0.0023388347735725156,
        -0.002926062513673001, 0.0023388548067467653, -1.0006468887305853, 1.258205945970097e-05,
        1.0006468877447325, 0.18126895363085793, -0.0023969445965401686, -0.18126888542062874,
        0.016819623583969035, -0.0005241540551897993, 0.01682307660297396, -0.18126895363085793,
        0.0023969445965401686, 0.18126888542062874, -0.3462457661654167, 0.0056538200396580056,
        0.3462454127453032, 0.07189128171115919, 0.0010141921219836924, 0.07188298271295385,
        0.3462457661654167, -0.0056538200396580056, -0.3462454127453032, -0.6924980124085547,
        0.012693364267544381, 0.692497056399948, 0.04616579892119736, 0.002024904128484132,
        0.04614706012567267, 0.6924980124085547, -0.012693364267544381, -0.692497056399948, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -0.0006772389785902291, -1.0448629819752317e-07, -0.00025476355428697263,
        -0.00012277121000176918, 1.169715163456987, 0.00013483761059258348, 0.0006772389785902291,
        1.0448629819752317e-07, 0.00025476355428697263, 0.0037559425714770007,
        -1.2744041232699715e-06, 0.0040522240306902985, -0.002502977640327702, 0.08763192107292156,
        0.0024937304886927295, -0.0037559425714770007, 1.2744041232699715e-06,
        -0.0040522240306902985, -2.7457013530925027e-06, -3.411296775306298e-09,
        -1.0254911317776104e-06, -4.577284353400361e-06, 0.004648886346610672,
        4.882719107220544e-06, 2.7457013530925027e-06, 3.411296775306298e-09,
        1.0254911317776104e-06, -0.00013151432255582325, -3.2781617645317266e-07,
        -0.00028416945015838694, -0.00038544090746921503, -0.3752194924357348,
        0.0004232576798069678, 0.00013151432255582325, 3.2781617645317266e-07,
        0.00028416945015838694, -0.0006251038461230938, 1.490585463163791e-06,
        -0.0003213970672461228, 0.0020740728408606126, 0.9220602671394251, -0.0021960217499246487,
        0.0006251038461230938, -1.490585463163791e-06, 0.0003213970672461228,
        -0.0005504126580959505, 3.3275508617554616e-06, 0.0001764554417448812, 0.004462709286750713,
        2.0440925215268084, -0.004760986060332644, 0.0005504126580959505, -3.3275508617554616e-06,
        -0.0001764554417448812, 0.882235575054211, -0.00025369716897665016, 0.8822358011770479,
        -0.008611839951026224, -0.000590380104573588, 0.008611789750930148, -0.882235575054211,
        0.00025369716897665016, -0.8822358011770479, -0.003398550848424417, 0.0004420014943052271,
        -0.003398613722778489, 0.6298896218546817, -0.0004277283244582688, -0.6298895884437392,
        0.003398550848424417, -0.0004420014943052271, 0.003398613722778489, -1.0006449848703447,
        -1.2647735248956514e-06, -1.0006467894898141, -0.002338820618328251, -0.004929325015802161,
        0.0023388207795741046, 1.0006449848703447, 1.2647735248956514e-06, 1.0006467894898141,
        -0.18127213640860537, 6.706436718658007e-05, -0.18127234497389524, -0.016819668040965595,
        0.000513374439941537, 0.016819497941635723, 0.18127213640860537, -6.706436718658007e-05,
        0.18127234497389524, 0.3462562428224154, -0.00024703106960261934, 0.3462565984938012,
        -0.07189513337353538, -0.0022205999726948385, 0.0718956417131393, -0.3462562428224154,
        0.00024703106960261934, -0.3462565984938012, 0.6925234208853563, -0.0004648899951336885,
        0.692524285900701, -0.04617739827043515, -0.0051787041989121525, 0.046178649290183386,
        -0.6925234208853563, 0.0004648899951336885, -0.692524285900701, -0.004313579293807209,
        -0.0012900759237534929, -0.004308571840488631, -1.7644715317756867, 0.01460470635314257,
        1.7644727164230105, 0.004313579293807209, 0.0012900759237534929, 0.004308571840488631,
        0.31494421241715215, 4.214914191060544e-06, 0.3149451713904748, 0.006798830554174771,
        0.002632126953025821, -0.006798862095971799, -0.31494421241715215, -4.214914191060544e-06,
        -0.3149451713904748, -0.0011694173867862578, 0.0014630312568365005, -0.0011694274033733827,
        2.0012937774611705, -2.516411891940194e-05, -2.001293775489465, 0.0011694173867862578,
        -0.0014630312568365005, 0.0011694274033733827, -0.008409811791984518,
        0.00026207702759489966, -0.00841153830148698, 0.36253790726171586, -0.004793889193080337,
        -0.3625377708412575, 0.008409811791984518, -0.00026207702759489966, 0.00841153830148698,
        -0.035945640855579594, -0.0005070960609918462, -0.03594149135647692, -0.6924915323308334,
        0.011307640079316011, 0.6924908254906064, 0.035945640855579594, 0.0005070960609918462,
        0.03594149135647692, -0.02308289946059868, -0.001012452064242066, -0.023073530062836335,
        -1.3849960248171094, 0.025386728535088762, 1.384994112799896, 0.02308289946059868,
        0.001012452064242066, 0.023073530062836335, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.2924283833036665, 0.0001288043683107616, -0.29242904586249485, 0.0, 0.0, 0.0,
        0.2924283833036665, 0.0001288043683107616, -0.29242904586249485, 0.021910563334382998,
        0.0024983538005456463, -0.02190519231723193, 0.0, 0.0, 0.0, 0.021910563334382998,
        0.0024983538005456463, -0.02190519231723193, 0.001162220034987996, 4.730000499939664e-06,
        -0.0011622225020049566, 0.0, 0.0, 0.0, 0.001162220034987996, 4.730000499939664e-06,
        -0.0011622225020049566, -0.09380496514638399, 0.0004043491619736147, 0.09380471959168611,
        0.0, 0.0, 0.0, -0.09380496514638399, 0.0004043491619736147, 0.09380471959168611,
        0.230514628975399, -0.0021350467760378592, -0.2305154057177238, 0.0, 0.0, 0.0,
        0.230514628975399, -0.0021350467760378592, -0.2305154057177238, 0.5110227228420882,
        -0.0046118464728352945, -0.5110232795395916, 0.0, 0.0, 0.0, 0.5110227228420882,
        -0.0046118464728352945, -0.5110232795395916, 0.0004974423881171828, 0.00861163169038539,
        0.0007926326878293347, 0.0, 0.0, 0.0, 0.0004974423881171828, 0.00861163169038539,
        0.0007926326878293347, -0.00010903894862185423, -0.6298894503388348, 0.00010482522251027607,
        0.0, 0.0, 0.0, -0.00010903894862185423, -0.6298894503388348, 0.00010482522251027607,
        -0.00196384601528652, 0.0023388203992311084, 0.0005008158320280003, 0.0, 0.0, 0.0,
        -0.00196384601528652, 0.0023388203992311084, 0.0005008158320280003, -2.697175799161027e-06,
        0.01681963650277637, -0.0002593846069755942, 0.0, 0.0, 0.0, -2.697175799161027e-06,
        0.01681963650277637, -0.0002593846069755942, -0.00030159443778841167, 0.07189522619515522,
        0.0008087060732440878, 0.0, 0.0, 0.0, -0.00030159443778841167, 0.07189522619515522,
        0.0008087060732440878, -0.0007884316931209488, 0.0461776963396415, 0.0018009216523608338,
        0.0, 0.0, 0.0, -0.0007884316931209488, 0.0461776963396415, 0.0018009216523608338,
        0.003524323566632049, 1.7644716499469553, -0.003778027889935645, 0.0, 0.0, 0.0,
        0.003524323566632049, 1.7644716499469553, -0.003778027889935645, 0.0008790321718945419,
        -0.0067988432298863935, -0.0004370309628835905, 0.0, 0.0, 0.0, 0.0008790321718945419,
        -0.0067988432298863935, -0.0004370309628835905, -6.923418882242599e-06, -2.0012932417708265,
        5.65863688754671e-06, 0.0, 0.0, 0.0, -6.923418882242599e-06, -2.0012932417708265,
        5.65863688754671e-06, -0.0011649399430641498, -0.36253775224763696, 0.0012320040648699717,
        0.0, 0.0, 0.0, -0.0011649399430641498, -0.36253775224763696, 0.0012320040648699717,
        0.0027033950629119508, 0.692491018928303, -0.002950423561363726, 0.0, 0.0, 0.0,
        0.0027033950629119508, 0.692491018928303, -0.002950423561363726, 0.006114239209291335,
        1.384994761519078, -0.006579121862893559, 0.0, 0.0, 0.0, 0.006114239209291335,
        1.384994761519078, -0.006579121862893559, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0005274187317887179, 0.2569982650549172, -0.0005643290154742776, 0.00013816129084177726,
        -1.5958492548994105e-06, -0.00023750285944067138, -0.0005274187317887179,
        -0.2569982650549172, 0.0005643290154742776, 0.0007316828474859824, 0.35163500103255724,
        -0.00078288812299255, 0.0001820255266540679, -2.2139060609833303e-06,
        -0.00033197274428459477, -0.0007316828474859824, -0.35163500103255724, 0.00078288812299255,
        -8.952074860202624e-05, -0.043040727231093236, 9.578566872619076e-05,
        -2.230709499229724e-05, 2.7086944650234924e-07, 4.060717495171275e-05,
        8.952074860202624e-05, 0.043040727231093236, -9.578566872619076e-05, 0.0074003133750042815,
        3.5586014736788867, -0.007918208644114428, 0.0018452198621894686, -2.2391666950224442e-05,
        -0.0033565234200765943, -0.0074003133750042815, -3.5586014736788867, 0.007918208644114428,
        0.002279755048250264, 1.0932496863908319, -0.0024392988803002284, 0.0005624932627236694,
        -6.898020824487481e-06, -0.0010355514337913256, -0.002279755048250264, -1.0932496863908319,
        0.0024392988803002284, 8.966526648256398e-07, 0.0018096602231495293, -9.594030038473216e-07,
        2.9388554216457935e-06, -2.713067247749537e-09, 2.9360616331268904e-07,
        -8.966526648256398e-07, -0.0018096602231495293, 9.594030038473216e-07, -0.00594817424620634,
        -0.0002493925984535085, 0.00594817424620634, 0.20130332200252335, 1.738934559309622e-05,
        0.20130368654918115, 0.00594817424620634, 0.0002493925984535085, -0.00594817424620634,
        -0.00664244285169175, 0.00010421253142302345, 0.00664244285169175, -0.08411768793394135,
        1.9419023308560372e-05, -0.08411784026536685, 0.00664244285169175, -0.00010421253142302345,
        -0.00664244285169175, 0.001003744348659303, 6.421594639592331e-06, -0.001003744348659303,
        -0.0051833468255254355, -2.9344226721478592e-06, -0.005183356212214849,
        -0.001003744348659303, -6.421594639592331e-06, 0.001003744348659303, -0.08308191700249948,
        -0.0011683166978441566, 0.08308191700249948, 0.94303533418972, 0.0002428880035272731,
        0.9430370419627256, 0.08308191700249948, 0.0011683166978441566, -0.08308191700249948,
        -0.025709079919826554, 0.0020049950724099317, 0.025709079919826554, -1.6183807024651937,
        7.515988219267877e-05, -1.6183836332428392, 0.025709079919826554, -0.0020049950724099317,
        -0.025709079919826554, -1.0053647440216658e-05, -0.0009808851417306072,
        1.0053647440216658e-05, 0.7917453796051475, 2.939159859356447e-08, 0.7917468134023102,
        1.0053647440216658e-05, 0.0009808851417306072, -1.0053647440216658e-05, 0.10065185626284352,
        -1.4738234210423193e-05, -0.10065185626284352, 0.011896325413853466, -0.0002942533020544127,
        0.011896346957291628, -0.10065185626284352, 1.4738234210423193e-05, 0.10065185626284352,
        -0.0420589255600246, -1.645847522708707e-05, 0.0420589255600246, 0.01328485993110375,
        0.00012295826611065364, 0.013284883989083712, 0.0420589255600246, 1.645847522708707e-05,
        -0.0420589255600246, -0.0025916784405411487, 2.487052108025335e-06, 0.0025916784405411487,
        -0.002007484802850753, 7.5767101304219816e-06, -0.0020074884382695235,
        0.0025916784405411487, -2.487052108025335e-06, -0.0025916784405411487, 0.4715185818267644,
        -0.0002058582517509023, -0.4715185818267644, 0.1661635116521455, -0.0013784733320786095,
        0.16616381256299095, -0.4715185818267644, 0.0002058582517509023, 0.4715185818267644,
        -0.80919192104065, -6.370130152702785e-05, 0.80919192104065, 0.05141806008996544,
        0.002365653288501388, 0.051418153204583567, 0.80919192104065, 6.370130152702785e-05,
        -0.80919192104065, 0.3958734577852066, -2.491067082263727e-08, -0.3958734577852066,
        2.0107255872884417e-05, -0.001157326615465485, 2.0107292285760535e-05, -0.3958734577852066,
        2.491067082263727e-08, 0.3958734577852066, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -6.908064542088863e-05, 7.979246274497052e-07, 0.00011875142972033569, 0.0010548374635774359,
        0.5139965301098344, -0.0011286580309485552, 6.908064542088863e-05, -7.979246274497052e-07,
        -0.00011875142972033569, -9.101276332703395e-05, 1.1069530304916652e-06,
        0.00016598637214229739, 0.0014633656949719649, 0.7032700020651145, -0.0015657762459851,
        9.101276332703395e-05, -1.1069530304916652e-06, -0.00016598637214229739,
        1.115354749614862e-05, -1.3543472325117462e-07, -2.0303587475856375e-05,
        -0.0001790414972040525, -0.08608145446218647, 0.00019157133745238152,
        -1.115354749614862e-05, 1.3543472325117462e-07, 2.0303587475856375e-05,
        -0.0009226099310947343, 1.1195833475112221e-05, 0.0016782617100382972, 0.014800626750008563,
        7.117202947357773, -0.015836417288228856, 0.0009226099310947343, -1.1195833475112221e-05,
        -0.0016782617100382972, -0.0002812466313618347, 3.4490104122437405e-06,
        0.0005177757168956628, 0.004559510096500528, 2.1864993727816637, -0.004878597760600457,
        0.0002812466313618347, -3.4490104122437405e-06, -0.0005177757168956628,
        -1.4694277108228967e-06, 1.3565336238747684e-09, -1.4680308165634452e-07,
        1.7933053296512796e-06, 0.0036193204462990586, -1.9188060076946433e-06,
        1.4694277108228967e-06, -1.3565336238747684e-09, 1.4680308165634452e-07,
        -0.10065166100126167, -8.69467279654811e-06, -0.10065184327459058, -0.01189634849241268,
        -0.000498785196907017, 0.01189634849241268, 0.10065166100126167, 8.69467279654811e-06,
        0.10065184327459058, 0.042058843966970676, -9.709511654280186e-06, 0.042058920132683426,
        -0.0132848857033835, 0.0002084250628460469, 0.0132848857033835, -0.042058843966970676,
        9.709511654280186e-06, -0.042058920132683426, 0.0025916734127627177, 1.4672113360739296e-06,
        0.0025916781061074245, 0.002007488697318606, 1.2843189279184662e-05, -0.002007488697318606,
        -0.0025916734127627177, -1.4672113360739296e-06, -0.0025916781061074245, -0.47151766709486,
        -0.00012144400176363654, -0.4715185209813628, -0.16616383400499896, -0.002336633395688313,
        0.16616383400499896, 0.47151766709486, 0.00012144400176363654, 0.4715185209813628,
        0.8091903512325969, -3.757994109633939e-05, 0.8091918166214196, -0.05141815983965311,
        0.004009990144819863, 0.05141815983965311, -0.8091903512325969, 3.757994109633939e-05,
        -0.8091918166214196, -0.39587268980257373, -1.4695799296782235e-08, -0.3958734067011551,
        -2.0107294880433316e-05, -0.0019617702834612144, 2.0107294880433316e-05,
        0.39587268980257373, 1.4695799296782235e-08, 0.3958734067011551, -0.005948162706926733,
        0.00014712665102720635, -0.005948173478645814, 0.20130371252568705, -2.9476468420846386e-05,
        -0.20130371252568705, 0.005948162706926733, -0.00014712665102720635, 0.005948173478645814,
        -0.006642429965551875, -6.147913305532682e-05, -0.006642441994541856, -0.0841178511200492,
        -3.291695045417414e-05, 0.0841178511200492, 0.006642429965551875, 6.147913305532682e-05,
        0.006642441994541856, 0.0010037424014253764, -3.7883550652109908e-06, 0.0010037442191347618,
        -0.0051833568810822975, 4.97410421605067e-06, 0.0051833568810822975, -0.0010037424014253764,
        3.7883550652109908e-06, -0.0010037442191347618, -0.08308175582607275, 0.0006892366660393047,
        -0.08308190628149548, 0.9430371636535289, -0.0004117165035018046, -0.9430371636535289,
        0.08308175582607275, -0.0006892366660393047, 0.08308190628149548, -0.02570903004498272,
        -0.001182826644250694, -0.025709076602291783, -1.6183838420813, -0.0001274026030540557,
        1.6183838420813, 0.02570903004498272, 0.001182826644250694, 0.025709076602291783,
        -1.0053627936442208e-05, 0.0005786633077327425, -1.0053646142880268e-05, 0.7917469155704132,
        -4.982134164527454e-08, -0.7917469155704132, 1.0053627936442208e-05, -0.0005786633077327425,
        1.0053646142880268e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.1284990778077233, -0.0010917474556737536, -0.12849911860686053, 0.0, 0.0, 0.0,
        0.1284990778077233, -0.0010917474556737536, -0.12849911860686053, 0.17581742747463153,
        -0.0015145705659596294, -0.17581747964155747, 0.0, 0.0, 0.0, 0.17581742747463153,
        -0.0015145705659596294, -0.17581747964155747, -0.02152035466812192, 0.00018530636783568736,
        0.02152036106744676, 0.0, 0.0, 0.0, -0.02152035466812192, 0.00018530636783568736,
        0.02152036106744676, 1.7792999968401875, -0.015318517927774136, -1.779300526390293, 0.0,
        0.0, 0.0, 1.7792999968401875, -0.015318517927774136, -1.779300526390293, 0.5466246170003802,
        -0.004719052668162861, -0.5466247774000644, 0.0, 0.0, 0.0, 0.5466246170003802,
        -0.004719052668162861, -0.5466247774000644, 0.0009048292137420318, -1.8560551729486817e-06,
        -0.0009048305260747367, 0.0, 0.0, 0.0, 0.0009048292137420318, -1.8560551729486817e-06,
        -0.0009048305260747367, -0.00019825953498182327, 0.011896345315078678, 5.11329968627099e-05,
        0.0, 0.0, 0.0, -0.00019825953498182327, 0.011896345315078678, 5.11329968627099e-05,
        8.284579473219169e-05, 0.013284882155192296, -2.1366708857247353e-05, 0.0, 0.0, 0.0,
        8.284579473219169e-05, 0.013284882155192296, -2.1366708857247353e-05,
        5.1049725412147005e-06, -0.002007488161148864, -1.316620383267233e-06, 0.0, 0.0, 0.0,
        5.1049725412147005e-06, -0.002007488161148864, -1.316620383267233e-06,
        -0.0009287762614545355, 0.16616378962516257, 0.0002395401243499752, 0.0, 0.0, 0.0,
        -0.0009287762614545355, 0.16616378962516257, 0.0002395401243499752, 0.0015939101367153981,
        0.05141814610664354, -0.0004110844001908011, 0.0, 0.0, 0.0, 0.0015939101367153981,
        0.05141814610664354, -0.0004110844001908011, -0.0007797738717027036, 2.0107289510080242e-05,
        0.0002011110080483798, 0.0, 0.0, 0.0, -0.0007797738717027036, 2.0107289510080242e-05,
        0.0002011110080483798, -1.1716448199068814e-05, -0.2013036587605228, 3.021782074995863e-06,
        0.0, 0.0, 0.0, -1.1716448199068814e-05, -0.2013036587605228, 3.021782074995863e-06,
        -1.30839875171373e-05, 0.08411782865344873, 3.374483314141003e-06, 0.0, 0.0, 0.0,
        -1.30839875171373e-05, 0.08411782865344873, 3.374483314141003e-06, 1.9771308269382583e-06,
        0.0051833554966863975, -5.099206168332317e-07, 0.0, 0.0, 0.0, 1.9771308269382583e-06,
        0.0051833554966863975, -5.099206168332317e-07, -0.00016365105266711986, -0.9430369117826249,
        4.220714410216992e-05, 0.0, 0.0, 0.0, -0.00016365105266711986, -0.9430369117826249,
        4.220714410216992e-05, -5.064059838503912e-05, 1.6183834098355554, 1.3060686128338587e-05,
        0.0, 0.0, 0.0, -5.064059838503912e-05, 1.6183834098355554, 1.3060686128338587e-05,
        -1.9803226094145774e-08, -0.791746704106837, 5.107438075229659e-09, 0.0, 0.0, 0.0,
        -1.9803226094145774e-08, -0.791746704106837, 5.107438075229659e-09, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    -0.06764475066198009, 0.0, -0.06764475066198009, 0.0, 0.0, 0.0, -0.06764475066198009, 0.0,
        -0.06764475066198009, -0.09384290090338356, 0.0, -0.09384290090338356, 0.0, 0.0, 0.0,
        -0.09384290090338356, 0.0, -0.09384290090338356, 0.011481595842681831, 0.0,
        0.011481595842681831, 0.0, 0.0, 0.0, 0.011481595842681831, 0.0, 0.011481595842681831,
        -0.9491364695655453, 0.0, -0.9491364695655453, 0.0, 0.0, 0.0, -0.9491364695655453, 0.0,
        -0.9491364695655453, -0.2923928418057341, 0.0, -0.2923928418057341, 0.0, 0.0, 0.0,
        -0.2923928418057341, 0.0, -0.2923928418057341, -0.00011500131164629951, 0.0,
        -0.00011500131164629951, 0.0, 0.0, 0.0, -0.00011500131164629951, 0.0,
        -0.00011500131164629951, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.022113900921573913, -3.913791954836347e-08, 0.02211390100332919, 0.0, 0.0, 0.0,
        0.022113900921573913, -3.913791954836347e-08, 0.02211390100332919, -0.016949569109092157,
        3.25655496960586e-07, -0.016949569789354572, 0.0, 0.0, 0.0, -0.016949569109092157,
        3.25655496960586e-07, -0.016949569789354572, 0.0005597640347014024, -8.26254564646056e-10,
        0.0005597640364273672, 0.0, 0.0, 0.0, 0.0005597640347014024, -8.26254564646056e-10,
        0.0005597640364273672, 0.06930619807322996, -1.2160414617676816e-07, 0.0693061983272491,
        0.0, 0.0, 0.0, 0.06930619807322996, -1.2160414617676816e-07, 0.0693061983272491,
        -0.22349304125132258, 2.9930134706046905e-07, -0.22349304187653374, 0.0, 0.0, 0.0,
        -0.22349304125132258, 2.9930134706046905e-07, -0.22349304187653374, -0.5466457576523094,
        8.012418083671449e-07, -0.546645759326025, 0.0, 0.0, 0.0, -0.5466457576523094,
        8.012418083671449e-07, -0.546645759326025, -8.849750361959236e-05, 2.3694411451978758e-08,
        -8.819526264268186e-05, 0.0, 0.0, 0.0, -8.849750361959236e-05, 2.3694411451978758e-08,
        -8.819526264268186e-05, 6.700182535448741e-05, -1.6610555152311568e-08,
        6.700858266728404e-05, 0.0, 0.0, 0.0, 6.700182535448741e-05, -1.6610555152311568e-08,
        6.700858266728404e-05, -2.3658698832268865e-06, 5.878661683581622e-10,
        -2.3658711112216905e-06, 0.0, 0.0, 0.0, -2.3658698832268865e-06, 5.878661683581622e-10,
        -2.3658711112216905e-06, -0.0002895882535275426, 7.17952022872509e-08,
        -0.0002896169618688086, 0.0, 0.0, 0.0, -0.0002895882535275426, 7.17952022872509e-08,
        -0.0002896169618688086, 0.000939076841586382, -2.332235222680574e-07, 0.0009390979399265798,
        0.0, 0.0, 0.0, 0.000939076841586382, -2.332235222680574e-07, 0.0009390979399265798,
        0.00229424918748874, -5.700700146993213e-07, 0.0022942503783091235, 0.0, 0.0, 0.0,
        0.00229424918748874, -5.700700146993213e-07, 0.0022942503783091235, 0.0002675131771572742,
        3.851221790178917e-08, 0.0002861290442705495, 0.0, 0.0, 0.0, 0.0002675131771572742,
        3.851221790178917e-08, 0.0002861290442705495, -0.0001917130248807626,
        -2.8039254072620587e-08, -0.00020513200085672906, 0.0, 0.0, 0.0, -0.0001917130248807626,
        -2.8039254072620587e-08, -0.00020513200085672906, 6.780392869628427e-06,
        9.912078969922537e-10, 7.2549043142044746e-06, 0.0, 0.0, 0.0, 6.780392869628427e-06,
        9.912078969922537e-10, 7.2549043142044746e-06, 0.0008286247537478138,
        1.2119068105773424e-07, 0.0008866242680917408, 0.0, 0.0, 0.0, 0.0008286247537478138,
        1.2119068105773424e-07, 0.0008866242680917408, -0.0026903719026535313,
        -3.933389885069578e-07, -0.002878659077935025, 0.0, 0.0, 0.0, -0.0026903719026535313,
        -3.933389885069578e-07, -0.002878659077935025, -0.0065751337139396075,
        -9.612015979531437e-07, -0.007035280530926797, 0.0, 0.0, 0.0, -0.0065751337139396075,
        -9.612015979531437e-07, -0.007035280530926797, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -1.951381726818856e-07, 0.03649875186924328, 1.9513827396753275e-07, 7.077516660302337e-05,
        4.0697143167658576e-10, 1.7345275339494068e-05, 1.951381726818856e-07, -0.03649875186924328,
        -1.9513827396753275e-07, 1.6236892337154725e-06, -1.9372002813559688,
        -1.6236900764845346e-06, -0.003806506865946825, -3.3862935322258703e-09,
        -0.0009741761371082098, -1.6236892337154725e-06, 1.9372002813559688, 1.6236900764845346e-06,
        -4.119631492314215e-09, -0.00015648655997743988, 4.1196336305915996e-09,
        -3.318535584521447e-07, 8.59171890033128e-12, -1.0476370356035959e-07,
        4.119631492314215e-09, 0.00015648655997743988, -4.1196336305915996e-09,
        -6.06307416165857e-07, 0.1138972437266142, 6.063077308671693e-07, 0.0002208746216662008,
        1.2644875874460609e-09, 5.414347518393559e-05, 6.06307416165857e-07, -0.1138972437266142,
        -6.063077308671693e-07, 1.492289795180208e-06, 0.24371629326185001, -1.4922905697469447e-06,
        0.0004886154174460046, -3.112252749291142e-09, 0.00013296463363269125,
        -1.492289795180208e-06, -0.24371629326185001, 1.4922905697469447e-06, 3.994920122616278e-06,
        0.14744922416429423, -3.9949221961627516e-06, 0.0003133373780517784, -8.331626454169777e-09,
        9.940771555210035e-05, -3.994920122616278e-06, -0.14744922416429423, 3.9949221961627516e-06,
        0.9068211287902572, 0.0005493080005266717, -0.9068210899035669, 0.003499182462392422,
        -0.0026516743746432102, 0.003498426906781168, -0.9068211287902572, -0.0005493080005266717,
        0.9068210899035669, 0.06731593369384761, -0.00040369378781108807, -0.06731596172475166,
        0.005527635997616969, -0.00019681008281101828, 0.005528192871097459, -0.06731593369384761,
        0.00040369378781108807, 0.06731596172475166, -0.0016296303234249274, 1.719213912441152e-05,
        0.0016296313146320638, -0.0025481039943347746, 4.764189301947721e-06,
        -0.0025481279490071704, 0.0016296303234249274, -1.719213912441152e-05,
        -0.0016296313146320638, -0.2908748311563547, 0.0016889945365969699, 0.29087495231156235,
        0.02119415041368715, 0.0008504232276456245, 0.02119182513642391, 0.2908748311563547,
        -0.0016889945365969699, -0.29087495231156235, 0.7128633267009158, -0.005577888057539618,
        -0.7128637200140676, 0.007142056711797177, -0.002084081711194407, 0.007149743676251646,
        -0.7128633267009158, 0.005577888057539618, 0.7128637200140676, 1.5802974085477652,
        -0.0136122401173336, -1.5802983697486255, 0.0014563255814761956, -0.004619965583283896,
        0.0014750829714720896, -1.5802974085477652, 0.0136122401173336, 1.5802983697486255,
        0.0017490676888161933, 0.0024235908120744786, -0.00174906832026812, -1.813638390532072,
        -4.2345082892720156e-05, -1.813641856162635, -0.0017490676888161933, -0.0024235908120744786,
        0.00174906832026812, 0.0027642009890368993, 3.2783430573929024e-05, -0.0027642010030797114,
        -0.1346318701603225, 1.875686907571017e-05, -0.1346319741596045, -0.0027642009890368993,
        -3.2783430573929024e-05, 0.0027642010030797114, -0.0012740678245360547,
        6.93879746197656e-07, 0.0012740678245360547, 0.003259263644351813, 2.7756842731697454e-06,
        0.00325926461249663, 0.0012740678245360547, -6.93879746197656e-07, -0.0012740678245360547,
        0.010595463573661656, -0.0001415176058912456, -0.01059546351400633, 0.581749674571854,
        -0.0001469745827608478, 0.5817501238148248, -0.010595463573661656, 0.0001415176058912456,
        0.01059546351400633, 0.0035763346683993546, -0.00011185831097288286, -0.003576334711453825,
        -1.4257275870382067, 0.00036611892078625824, -1.4257282102084208, -0.0035763346683993546,
        0.00011185831097288286, 0.003576334711453825, 0.0007411156334613886, -0.0006728743009981498,
        -0.0007411156334613886, -3.160597723855737, 0.0009181267542930972, -3.1605986626924314,
        -0.0007411156334613886, 0.0006728743009981498, 0.0007411156334613886, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -3.5387583301511684e-05, -2.0348571583829288e-10, -8.672637669747034e-06,
        -3.902763453637712e-07, 0.07299750373848655, 3.902765479350655e-07, 3.5387583301511684e-05,
        2.0348571583829288e-10, 8.672637669747034e-06, 0.0019032534329734125,
        1.6931467661129352e-09, 0.0004870880685541049, 3.247378467430945e-06, -3.8744005627119376,
        -3.2473801529690692e-06, -0.0019032534329734125, -1.6931467661129352e-09,
        -0.0004870880685541049, 1.6592677922607235e-07, -4.29585945016564e-12,
        5.2381851780179794e-08, -8.23926298462843e-09, -0.00031297311995487977,
        8.239267261183199e-09, -1.6592677922607235e-07, 4.29585945016564e-12,
        -5.2381851780179794e-08, -0.0001104373108331004, -6.322437937230304e-10,
        -2.7071737591967794e-05, -1.212614832331714e-06, 0.2277944874532284, 1.2126154617343385e-06,
        0.0001104373108331004, 6.322437937230304e-10, 2.7071737591967794e-05,
        -0.0002443077087230023, 1.556126374645571e-09, -6.648231681634562e-05,
        2.984579590360416e-06, 0.48743258652370003, -2.9845811394938893e-06, 0.0002443077087230023,
        -1.556126374645571e-09, 6.648231681634562e-05, -0.0001566686890258892,
        4.165813227084888e-09, -4.9703857776050176e-05, 7.989840245232556e-06, 0.29489844832858847,
        -7.989844392325503e-06, 0.0001566686890258892, -4.165813227084888e-09,
        4.9703857776050176e-05, -0.001749591231196211, 0.0013258371873216051, -0.001749213453390584,
        1.8136422575805144, 0.0010986160010533434, -1.8136421798071338, 0.001749591231196211,
        -0.0013258371873216051, 0.001749213453390584, -0.0027638179988084847, 9.840504140550914e-05,
        -0.0027640964355487296, 0.13463186738769523, -0.0008073875756221761, -0.1346319234495033,
        0.0027638179988084847, -9.840504140550914e-05, 0.0027640964355487296, 0.0012740519971673873,
        -2.3820946509738604e-06, 0.0012740639745035852, -0.003259260646849855,
        3.438427824882304e-05, 0.0032592626292641275, -0.0012740519971673873,
        2.3820946509738604e-06, -0.0012740639745035852, -0.010597075206843574,
        -0.00042521161382281223, -0.010595912568211956, -0.5817496623127094, 0.0033779890731939397,
        0.5817499046231247, 0.010597075206843574, 0.00042521161382281223, 0.010595912568211956,
        -0.0035710283558985883, 0.0010420408555972035, -0.003574871838125823, 1.4257266534018316,
        -0.011155776115079235, -1.4257274400281352, 0.0035710283558985883, -0.0010420408555972035,
        0.003574871838125823, -0.0007281627907380978, 0.002309982791641948, -0.0007375414857360448,
        3.1605948170955305, -0.0272244802346672, -3.160596739497251, 0.0007281627907380978,
        -0.002309982791641948, 0.0007375414857360448, 0.906819195266036, 2.1172541446360078e-05,
        0.9068209280813175, 0.0034981353776323866, 0.004847181624148957, -0.00349813664053624,
        -0.906819195266036, -2.1172541446360078e-05, -0.9068209280813175, 0.06731593508016125,
        -9.378434537855086e-06, 0.06731598707980226, 0.005528401978073799, 6.556686114785805e-05,
        -0.005528402006159423, -0.06731593508016125, 9.378434537855086e-06, -0.06731598707980226,
        -0.0016296318221759064, -1.3878421365848727e-06, -0.001629632306248315,
        -0.0025481356490721094, 1.387759492395312e-06, 0.0025481356490721094, 0.0016296318221759064,
        1.3878421365848727e-06, 0.001629632306248315, -0.290874837285927, 7.34872913804239e-05,
        -0.2908750619074124, 0.02119092714732331, -0.0002830352117824912, -0.02119092702801266,
        0.290874837285927, -7.34872913804239e-05, 0.2908750619074124, 0.7128637935191033,
        -0.00018305946039312912, 0.7128641051042104, 0.007152669336798709, -0.00022371662194576572,
        -0.00715266942290765, -0.7128637935191033, 0.00018305946039312912, -0.7128641051042104,
        1.5802988619278684, -0.0004590633771465486, 1.5802993313462157, 0.0014822312669227772,
        -0.0013457486019962995, -0.0014822312669227772, -1.5802988619278684, 0.0004590633771465486,
        -1.5802993313462157, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0182493549208144, 3.902764021649082e-07, -0.018249387171561902, 0.0, 0.0, 0.0,
        0.0182493549208144, 3.902764021649082e-07, -0.018249387171561902, -0.9685990081453345,
        -3.2473789400570505e-06, 0.9686007555758492, 0.0, 0.0, 0.0, -0.9685990081453345,
        -3.2473789400570505e-06, 0.9686007555758492, -7.824318012735773e-05, 8.239264183777471e-09,
        7.824333865878254e-05, 0.0, 0.0, 0.0, -7.824318012735773e-05, 8.239264183777471e-09,
        7.824333865878254e-05, 0.05694855628286329, 1.2126150088166641e-06, -0.05694865693465027,
        0.0, 0.0, 0.0, 0.05694855628286329, 1.2126150088166641e-06, -0.05694865693465027,
        0.1218580008058063, -2.9845800247385587e-06, -0.12185822758187342, 0.0, 0.0, 0.0,
        0.1218580008058063, -2.9845800247385587e-06, -0.12185822758187342, 0.0737245177648763,
        -7.98984140808041e-06, -0.0737246676035724, 0.0, 0.0, 0.0, 0.0737245177648763,
        -7.98984140808041e-06, -0.0737246676035724, 0.00026406742270663715, -1.8136417340766344,
        -0.000285240448425722, 0.0, 0.0, 0.0, 0.00026406742270663715, -1.8136417340766344,
        -0.000285240448425722, -0.00019715745272184699, -0.13463185945552603,
        0.00020653623940890205, 0.0, 0.0, 0.0, -0.00019715745272184699, -0.13463185945552603,
        0.00020653623940890205, 9.289981662685109e-06, 0.003259260767556811, -7.902153299620343e-06,
        0.0, 0.0, 0.0, 9.289981662685109e-06, 0.003259260767556811, -7.902153299620343e-06,
        0.0008077526749048255, 0.5817496280704033, -0.0008812414630602462, 0.0, 0.0, 0.0,
        0.0008077526749048255, 0.5817496280704033, -0.0008812414630602462, -0.002697411187852331,
        -1.4257266659095227, 0.0028804755503739543, 0.0, 0.0, 0.0, -0.002697411187852331,
        -1.4257266659095227, 0.0028804755503739543, -0.006576580774880715, -3.1605949341483903,
        0.007035656123476813, 0.0, 0.0, 0.0, -0.006576580774880715, -3.1605949341483903,
        0.007035656123476813, 0.0018747131254754944, -0.0034981214690243973, -0.0005488770674420753,
        0.0, 0.0, 0.0, 0.0018747131254754944, -0.0034981214690243973, -0.0005488770674420753,
        6.559422691343964e-05, -0.005528410323078486, 3.281082558848971e-05, 0.0, 0.0, 0.0,
        6.559422691343964e-05, -0.005528410323078486, 3.281082558848971e-05, -8.441077970086208e-07,
        0.0025481353153095016, -1.537988082324699e-06, 0.0, 0.0, 0.0, -8.441077970086208e-07,
        0.0025481353153095016, -1.537988082324699e-06, -0.0002833645706890199, -0.02119087903784387,
        -0.00014184709116949417, 0.0, 0.0, 0.0, -0.0002833645706890199, -0.02119087903784387,
        -0.00014184709116949417, 0.00046509135034315525, -0.007152805082750774,
        0.000576949918919671, 0.0, 0.0, 0.0, 0.00046509135034315525, -0.007152805082750774,
        0.000576949918919671, 0.0008185545795099077, -0.0014825671781034913, 0.00149142940330604,
        0.0, 0.0, 0.0, 0.0008185545795099077, -0.0014825671781034913, 0.00149142940330604, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.00014345459015333673, 0.0, 2.82570667022382e-07, 0.0, 7.287762997968285e-08, 0.0,
        -0.00014345459015333673, 0.0, 0.0, -0.0011936448433323913, 0.0, -2.3511901515855064e-06,
        0.0, -6.063940312160947e-07, 0.0, 0.0011936448433323913, 0.0, 0.0, 3.028520966403281e-06,
        0.0, 5.965450033025236e-09, 0.0, 1.538545613209966e-09, 0.0, -3.028520966403281e-06, 0.0,
        0.0, 0.00044572305201808214, 0.0, 8.779660517058178e-07, 0.0, 2.2643569385732318e-07, 0.0,
        -0.00044572305201808214, 0.0, 0.0, -0.001097047379379585, 0.0, -2.1609166316330316e-06, 0.0,
        -5.573207026638074e-07, 0.0, 0.001097047379379585, 0.0, 0.0, -0.0029368401938429903, 0.0,
        -5.784861199807714e-06, 0.0, -1.4919700563612202e-06, 0.0, 0.0029368401938429903, 0.0,
        0.0005539993831609802, -8.453406249241471e-05, -0.0005539993831609802, 0.0682337315045229,
        -1.619603988281386e-06, 0.06823385507118103, -0.0005539993831609802, 8.453406249241471e-05,
        0.0005539993831609802, 1.232035043029797e-05, 6.0935147203955465e-05,
        -1.232035043029797e-05, -0.04918529112304712, -3.6018250742594525e-08, -0.04918538019427214,
        -1.232035043029797e-05, -6.0935147203955465e-05, 1.232035043029797e-05, 0.0,
        -2.1547415197331026e-06, 0.0, 0.0017392522018246654, 0.0, 0.0017392553514923952, 0.0,
        2.1547415197331026e-06, 0.0, -5.2338130969872825e-05, -0.000263373967622893,
        5.2338130969872825e-05, 0.21258872532801718, 1.5300927805070876e-07, 0.21258911031177466,
        5.2338130969872825e-05, 0.000263373967622893, -5.2338130969872825e-05,
        3.7773500947558926e-05, 0.0008550061309684805, -3.7773500947558926e-05, -0.6901390641252944,
        -1.1042992942871224e-07, -0.6901403139203138, -3.7773500947558926e-05,
        -0.0008550061309684805, 3.7773500947558926e-05, 0.0, 0.0020895121984279646, 0.0,
        -1.6866007632811029, 0.0, -1.68660381760065, 0.0, -0.0020895121984279646, 0.0,
        0.03411693193808599, 1.372685520546747e-06, -0.03411693193808599, -0.0011079966168375908,
        -9.974003710901694e-05, -0.0011079986233442868, -0.03411693193808599,
        -1.372685520546747e-06, 0.03411693193808599, -0.024592693270610786, 3.052704959207086e-08,
        0.024592693270610786, -2.4640653058375428e-05, 7.18961524404589e-05, -2.464069768092626e-05,
        0.024592693270610786, -3.052704959207086e-08, -0.024592693270610786, 0.0008696277879641546,
        0.0, -0.0008696277879641546, 0.0, -2.5423361045472475e-06, 0.0, -0.0008696277879641546, 0.0,
        0.0008696277879641546, 0.10629456887228363, -1.2968208402128755e-07, -0.10629456887228363,
        0.00010467605887093752, -0.00031074963783520406, 0.00010467624843217789,
        -0.10629456887228363, 1.2968208402128755e-07, 0.10629456887228363, -0.3450702014884868,
        9.359421578273879e-08, 0.3450702014884868, -7.55468553362004e-05, 0.001008804506927433,
        -7.554699214642959e-05, 0.3450702014884868, -9.359421578273879e-08, -0.3450702014884868,
        -0.8433020176211687, 0.0, 0.8433020176211687, 0.0, 0.0024653733426055245, 0.0,
        0.8433020176211687, 0.0, -0.8433020176211687, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -1.41285333511191e-07, 0.0, -3.6438814989841425e-08, 0.0, 0.00028690918030667347, 0.0,
        1.41285333511191e-07, 0.0, 3.6438814989841425e-08, 1.1755950757927532e-06, 0.0,
        3.0319701560804735e-07, 0.0, -0.0023872896866647827, 0.0, -1.1755950757927532e-06, 0.0,
        -3.0319701560804735e-07, -2.982725016512618e-09, 0.0, -7.69272806604983e-10, 0.0,
        6.057041932806562e-06, 0.0, 2.982725016512618e-09, 0.0, 7.69272806604983e-10,
        -4.389830258529089e-07, 0.0, -1.1321784692866159e-07, 0.0, 0.0008914461040361643, 0.0,
        4.389830258529089e-07, 0.0, 1.1321784692866159e-07, 1.0804583158165158e-06, 0.0,
        2.786603513319037e-07, 0.0, -0.00219409475875917, 0.0, -1.0804583158165158e-06, 0.0,
        -2.786603513319037e-07, 2.892430599903857e-06, 0.0, 7.459850281806101e-07, 0.0,
        -0.005873680387685981, 0.0, -2.892430599903857e-06, 0.0, -7.459850281806101e-07,
        -0.03411686575226145, 8.09801994140693e-07, -0.034116927535590515, 0.0011079987663219603,
        -0.00016906812498482943, -0.0011079987663219603, 0.03411686575226145, -8.09801994140693e-07,
        0.034116927535590515, 0.02459264556152356, 1.8009125371297262e-08, 0.02459269009713607,
        2.464070086059594e-05, 0.00012187029440791093, -2.464070086059594e-05, -0.02459264556152356,
        -1.8009125371297262e-08, -0.02459269009713607, -0.0008696261009123327, 0.0,
        -0.0008696276757461976, 0.0, -4.309483039466205e-06, 0.0, 0.0008696261009123327, 0.0,
        0.0008696276757461976, -0.10629436266400859, -7.650463902535438e-08, -0.10629455515588733,
        -0.00010467626193974565, -0.000526747935245786, 0.00010467626193974565, 0.10629436266400859,
        7.650463902535438e-08, 0.10629455515588733, 0.3450695320626472, 5.521496471435612e-08,
        0.3450701569601569, 7.554700189511785e-05, 0.001710012261936961, -7.554700189511785e-05,
        -0.3450695320626472, -5.521496471435612e-08, -0.3450701569601569, 0.8433003816405514, 0.0,
        0.843301908800325, 0.0, 0.004179024396855929, 0.0, -0.8433003816405514, 0.0,
        -0.843301908800325, 0.0005539983084187954, 4.987001855450847e-05, 0.0005539993116721434,
        0.06823386387617197, 2.745371041093494e-06, -0.06823386387617197, -0.0005539983084187954,
        -4.987001855450847e-05, -0.0005539993116721434, 1.2320326529187714e-05,
        -3.594807622022945e-05, 1.232034884046313e-05, -0.04918538654122157, 6.105409918414172e-08,
        0.04918538654122157, -1.2320326529187714e-05, 3.594807622022945e-05, -1.232034884046313e-05,
        0.0, 1.2711680522736238e-06, 0.0, 0.0017392555759283093, 0.0, -0.0017392555759283093, 0.0,
        -1.2711680522736238e-06, 0.0, -5.233802943546876e-05, 0.00015537481891760203,
        -5.2338124216088945e-05, 0.21258913774456725, -2.593641680425751e-07, -0.21258913774456725,
        5.233802943546876e-05, -0.00015537481891760203, 5.2338124216088945e-05,
        3.77734276681002e-05, -0.0005044022534637165, 3.777349607321479e-05, -0.6901404029769737,
        1.8718843156547758e-07, 0.6901404029769737, -3.77734276681002e-05, 0.0005044022534637165,
        -3.777349607321479e-05, 0.0, -0.0012326866713027623, 0.0, -1.6866040352423375, 0.0,
        1.6866040352423375, 0.0, 0.0012326866713027623, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    7.172721097284102e-05, 0.0, -7.172734086595342e-05, 0.0, 0.0, 0.0, 7.172721097284102e-05, 0.0,
        -7.172734086595342e-05, -0.0005968217218621692, 0.0, 0.0005968228026658133, 0.0, 0.0, 0.0,
        -0.0005968217218621692, 0.0, 0.0005968228026658133, 1.5142587076557751e-06, 0.0,
        -1.5142614498755526e-06, 0.0, 0.0, 0.0, 1.5142587076557751e-06, 0.0,
        -1.5142614498755526e-06, 0.0002228612646927976, 0.0, -0.0002228616682794269, 0.0, 0.0, 0.0,
        0.0002228612646927976, 0.0, -0.0002228616682794269, -0.0005485230465184357, 0.0,
        0.0005485240398564558, 0.0, 0.0, 0.0, -0.0005485230465184357, 0.0, 0.0005485240398564558,
        -0.0014684183751257664, 0.0, 0.0014684210343318123, 0.0, 0.0, 0.0, -0.0014684183751257664,
        0.0, 0.0014684210343318123, -6.720201009892782e-05, -0.001107998470392318,
        1.7332029815722685e-05, 0.0, 0.0, 0.0, -6.720201009892782e-05, -0.001107998470392318,
        1.7332029815722685e-05, 4.84415897810106e-05, -2.4640694279438978e-05,
        -1.249354114809251e-05, 0.0, 0.0, 0.0, 4.84415897810106e-05, -2.4640694279438978e-05,
        -1.249354114809251e-05, -1.7129540104934185e-06, 0.0, 4.417869337409499e-07, 0.0, 0.0, 0.0,
        -1.7129540104934185e-06, 0.0, 4.417869337409499e-07, -0.00020937429847969877,
        0.00010467623398230589, 5.399959880000757e-05, 0.0, 0.0, 0.0, -0.00020937429847969877,
        0.00010467623398230589, 5.399959880000757e-05, 0.0006797038844920624,
        -7.554698171766105e-05, -0.00017530201811726616, 0.0, 0.0, 0.0, 0.0006797038844920624,
        -7.554698171766105e-05, -0.00017530201811726616, 0.0016610986828320107, 0.0,
        -0.00042841295751898086, 0.0, 0.0, 0.0, 0.0016610986828320107, 0.0, -0.00042841295751898086,
        1.0912432633024337e-06, -0.06823384565194325, -2.8144189062085894e-07, 0.0, 0.0, 0.0,
        1.0912432633024337e-06, -0.06823384565194325, -2.8144189062085894e-07,
        2.4268076494737218e-08, 0.04918537340455185, -6.2589649440223375e-09, 0.0, 0.0, 0.0,
        2.4268076494737218e-08, 0.04918537340455185, -6.2589649440223375e-09, 0.0,
        -0.0017392551113995605, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0017392551113995605, 0.0,
        -1.0309331484962721e-07, -0.21258908096523735, 2.6588734535545278e-08, 0.0, 0.0, 0.0,
        -1.0309331484962721e-07, -0.21258908096523735, 2.6588734535545278e-08,
        7.440455656318685e-08, 0.6901402186509538, -1.91896342219584e-08, 0.0, 0.0, 0.0,
        7.440455656318685e-08, 0.6901402186509538, -1.91896342219584e-08, 0.0, 1.6866035847760155,
        0.0, 0.0, 0.0, 0.0, 0.0, 1.6866035847760155, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
};

static const puma560_calibrated_formulation puma560_calibrated_formulations[2] = {
    {
        { 5, 4, 3, 2, 1, 0 }, -1.0, 0, 5, 0,
        {
            { 1.0, 0.0, 0.0, 0.00013641222461592016, 0.0, 0.0007308690395286796,
                -0.9999997329151878, -0.00038988074637754544, 0.0, 0.9999997329151878,
                0.0007308690395286796, 2.849520478517137e-16 },
            { 1.0, 0.0, 0.0, 0.004034857607497308, 0.0, 0.001238887228280428, 0.9999992325789233,
                -0.4685793486125126, 0.0, -0.9999992325789233, 0.001238887228280428,
                0.00038988064127592125 },
            { 1.0, 0.0, 0.0, -0.04371101205844448, 0.0, 0.0017412729567630927, -0.9999984839830959,
                0.10694938212242522, 0.0, 0.9999984839830959, 0.0017412729567630927,
                -0.46857850552830516 },
            { 1.0, 0.0, 0.0, -0.934264777131646, 0.0, 0.9999994314394958, 0.001066358610003491,
                0.0001152475771050453, 0.0, -0.001066358610003491, 0.9999994314394958,
                -0.10776514284931007 },
            { 1.0, 0.0, 0.0, -0.005748047346394125, 0.0, 0.001608544259234068, 0.9999987062918463,
                0.00017334347598081415, 0.0, -0.9999987062918463, 0.001608544259234068,
                -0.10776495857529474 },
            { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
        },
        puma560_calibrated_table_1, 0,
    },
    {
        { 3, 4, 5, 0, 1, 2 }, 1.0, 1, 2, 0,
        {
            { 1.0, 0.0, 0.0, -0.004034857607497308, 0.0, 0.001238887228280428, -0.9999992325789233,
                0.000970397312505304, 0.0, 0.9999992325789233, 0.001238887228280428,
                0.46857850599669737 },
            { 1.0, 0.0, 0.0, -0.00013641222461592016, 0.0, 0.0007308690395286796,
                0.9999997329151878, 2.8495176635072937e-07, 0.0, -0.9999997329151878,
                0.0007308690395286796, -0.0003898806422463197 },
            { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
            { 1.0, 0.0, 0.0, 0.005748047346394125, 0.0, 0.001608544259234068, -0.9999987062918463,
                -0.10776509798954229, 0.0, 0.9999987062918463, 0.001608544259234068,
                1.4537379415938628e-09 },
            { 1.0, 0.0, 0.0, 0.934264777131646, 0.0, 0.9999994314394958, -0.001066358610003491,
                -0.0002301637995154427, 0.0, 0.001066358610003491, 0.9999994314394958,
                0.10776495868305999 },
            { 1.0, 0.0, 0.0, 0.04371101205844448, 0.0, 0.0017412729567630927, 0.9999984839830959,
                0.4683915670885376, 0.0, -0.9999984839830959, 0.0017412729567630927,
                0.10776514306515093 },
        },
        puma560_calibrated_table_2, 0,
    },
};

/* cosines and sines of the 24 angles at which the determinant is sampled */
static const double puma560_calibrated_sample_c[24] = {
    1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386,
        0.9659258262890682
};

static const double puma560_calibrated_sample_s[24] = {
    0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0,
        0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207
};

/* from the samples to a_0, a_1 ... a_8, b_1 ... b_8 and seven numbers that would be zero without
 * rounding: one row for each sample */
static const double puma560_calibrated_harmonics[24][24] = {
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
static const double puma560_calibrated_grid_c[8][128] = {
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

static const double puma560_calibrated_grid_s[8][128] = {
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
static inline void puma560_calibrated_compose(const double A[12], const double B[12], double C[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j] +
                           (j == 3 ? A[4 * i + 3] : 0.0);
        }
    }
}

static inline void puma560_calibrated_invert(const double A[12], double B[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            B[4 * i + j] = A[4 * j + i];
        }
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11]);
    }
}

/* 1; R row by row; t; t.t; R't; [t]xR; (t.t - 2 t t') R */
static inline void puma560_calibrated_monomials(const double A[12], double m[35])
{
    const double t[3] = {A[3], A[7], A[11]};
    const double square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    m[0] = 1.0;
    m[13] = square;
    for (int j = 0; j < 3; j++) {
        const double back = A[j] * t[0] + A[4 + j] * t[1] + A[8 + j] * t[2];
        m[10 + j] = t[j];
        m[14 + j] = back;
        for (int i = 0; i < 3; i++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            m[1 + 3 * i + j] = A[4 * i + j];
            m[17 + 3 * i + j] = t[i1] * A[4 * i2 + j] - t[i2] * A[4 * i1 + j];
            m[26 + 3 * i + j] = square * A[4 * i + j] - 2.0 * (t[i] * back);
        }
    }
}

/* A constant matrix times the monomials; `rows` is a multiple of eight. */
static inline void puma560_calibrated_times(const double *table, const double m[35], int rows,
    double *out)
{
    for (int i = 0; i < rows; i += 8) {
        puma560_calibrated_lane sum[8 / PUMA560_CALIBRATED_LANES];
        for (int k = 0; k < 8 / PUMA560_CALIBRATED_LANES; k++) {
            sum[k] = PUMA560_CALIBRATED_LOAD(table + i + PUMA560_CALIBRATED_LANES * k);
        }
        for (int j = 1; j < 35; j++) {
            for (int k = 0; k < 8 / PUMA560_CALIBRATED_LANES; k++) {
                sum[k] += m[j] * PUMA560_CALIBRATED_LOAD(table + rows * j + i +
                    PUMA560_CALIBRATED_LANES * k);
            }
        }
        for (int k = 0; k < 8 / PUMA560_CALIBRATED_LANES; k++) {
            PUMA560_CALIBRATED_STORE(out + i + PUMA560_CALIBRATED_LANES * k, sum[k]);
        }
    }
}

/* Reflections that clear the eight columns of the right side; what they leave in the last six of
 * the 14 rows annihilates it. Rows of 40: eight columns of the right side, 32 of the left. */
static void puma560_calibrated_clear_right(double work[14][40])
{
    for (int c = 0; c < 8; c++) {
        double axis[14], square = 0.0, length, factor;
        for (int i = c; i < 14; i++) {
            axis[i] = work[i][c];
            square += axis[i] * axis[i];
        }
        length = copysign(sqrt(square), axis[c]);
        axis[c] += length;
        factor = 1.0 / (length * axis[c] + 1e-300);
        for (int k = 0; k < 40; k += PUMA560_CALIBRATED_LANES) {
            puma560_calibrated_lane sum = {0};
            for (int i = c; i < 14; i++) {
                sum += axis[i] * PUMA560_CALIBRATED_LOAD(&work[i][k]);
            }
            sum *= factor;
            for (int i = c; i < 14; i++) {
                PUMA560_CALIBRATED_STORE(&work[i][k], PUMA560_CALIBRATED_LOAD(&work[i][k]) - axis[i]
                    * sum);
            }
        }
    }
}

/* The six equations of a pose: index ((a 6 + r) 3 + i) 3 + j for 1, c1, s1 (a), equation r, the
 * powers x3^2, x3, 1 (i) and x2^2, x2, 1 (j) of the partners' half-angle tangents. */
static void puma560_calibrated_equations(const puma560_calibrated_formulation *form, const double
    P[12],
                              double E[168])
{
    double inverse[12], m[35], right[128], work[14][40];
    puma560_calibrated_invert(P, inverse);
    puma560_calibrated_monomials(form->inverted ? inverse : P, m);
    if (!form->each_pose) {
        puma560_calibrated_times(form->table, m, 168, E);
        return;
    }
    puma560_calibrated_times(form->table, m, 128, right);
    for (int i = 0; i < 14; i++) {
        for (int k = 0; k < 8; k++) {
            work[i][k] = right[14 * (k + 1) + i];
        }
        for (int k = 0; k < 32; k++) {
            work[i][8 + k] = form->left[32 * i + k];
        }
        work[i][8] -= right[i]; /* 1 = (1 + x2^2)(1 + x3^2) over itself */
        work[i][10] -= right[i];
        work[i][14] -= right[i];
        work[i][16] -= right[i];
    }
    puma560_calibrated_clear_right(work);
    for (int a = 0; a < 3; a++) {
        for (int r = 0; r < 6; r++) {
            for (int k = 0; k < 9; k++) {
                E[9 * (6 * a + r) + k] = work[8 + r][8 + 9 * a + k];
            }
        }
    }
}

/* Reflect `rows` rows of a matrix with `columns` columns so that below the first, `column` becomes
 * zero; row[i] points to the i-th of them. Returns the new diagonal. */
static inline puma560_calibrated_lane puma560_calibrated_reflect(puma560_calibrated_lane *const
    *row, int rows, int column, int columns)
{
    puma560_calibrated_lane axis[6], square = {0}, length, factor;
    for (int i = 0; i < rows; i++) {
        axis[i] = row[i][column];
        square += axis[i] * axis[i];
    }
    length = puma560_calibrated_with_sign(puma560_calibrated_sqrt(square), axis[0]);
    axis[0] += length;
    factor = 1.0 / (length * axis[0] + 1e-300);
    for (int j = column + 1; j < columns; j++) {
        puma560_calibrated_lane sum = axis[0] * row[0][j];
        for (int i = 1; i < rows; i++) {
            sum += axis[i] * row[i][j];
        }
        sum *= factor;
        for (int i = 0; i < rows; i++) {
            row[i][j] -= axis[i] * sum;
        }
    }
    row[0][column] = -length;
    return -length;
}

/* The determinant at hidden angles, and the upper triangular factor whose null vectors are
 * (x3, 1) x (x2^2, x2, 1). With A2, A1, A0 the blocks of x3^2, x3, 1 the matrix is
 * [A2 A1 A0 0; 0 A2 A1 A0]; reflections fold it to 9x9 and to 6x6. */
static inline puma560_calibrated_lane puma560_calibrated_fold(const double *E,
    puma560_calibrated_lane c, puma560_calibrated_lane s,
                                        puma560_calibrated_lane factor[6][6])
{
    puma560_calibrated_lane M[6][9], W[6][9], determinant;
    puma560_calibrated_lane *const rows[6] = {M[0], M[1], M[2], M[3], M[4], M[5]};
    puma560_calibrated_lane *const last[6] = {factor[0], factor[1], factor[2], factor[3], factor[4],
        factor[5]};
    const puma560_calibrated_lane zero = {0};
    for (int r = 0; r < 6; r++) {
        for (int k = 0; k < 9; k++) {
            const int at = 9 * r + k;
            M[r][k] = E[at] + E[54 + at] * c + E[108 + at] * s;
        }
    }
    determinant = puma560_calibrated_reflect(rows, 6, 0, 9);
    determinant *= puma560_calibrated_reflect(rows + 1, 5, 1, 9);
    determinant *= puma560_calibrated_reflect(rows + 2, 4, 2, 9);
    /* now M is [R B1 B0; 0 D1 D0]; the other shift has R B1 B0 under D1 D0 0 */
    for (int r = 0; r < 3; r++) {
        for (int k = 0; k < 9; k++) {
            W[r][k] = M[r][k];
            W[3 + r][k] = k < 6 ? M[3 + r][3 + k] : zero;
            if (k < 6) {
                factor[3 + r][k] = M[3 + r][3 + k];
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        puma560_calibrated_lane *const four[4] = {W[k], W[3], W[4], W[5]};
        determinant *= puma560_calibrated_reflect(four, 4, k, 9);
    }
    for (int r = 0; r < 3; r++) {
        for (int k = 0; k < 6; k++) {
            factor[r][k] = W[3 + r][3 + k];
        }
    }
    determinant *= puma560_calibrated_reflect(last, 6, 0, 6);
    determinant *= puma560_calibrated_reflect(last + 1, 5, 1, 6);
    determinant *= puma560_calibrated_reflect(last + 2, 4, 2, 6);
    determinant *= puma560_calibrated_reflect(last + 3, 3, 3, 6);
    determinant *= puma560_calibrated_reflect(last + 4, 2, 4, 6);
    return determinant * factor[5][5];
}

/* f(x) = sum a_m cos mx + b_m sin mx, m = 0 ... 8, and where it vanishes. */
typedef struct {
    double a[9], b[9];
    double scale;    /* the largest sample */
    double noise;    /* the harmonics beyond the eighth, over scale */
    double rounding; /* how far f may be from what it stands for */
} puma560_calibrated_trigonometric;

/* f, f', f'' at the edges of the cells; the first edge stands at the end again */
typedef struct {
    double value[264], slope[264], bend[264];
} puma560_calibrated_grid;

/* The roots by their cosines and sines: `simple` of them change the sign of f, `doubles` touch zero
 * within the rounding of f, or nearly (two roots, none or one). `complete` says that no cell was
 * given
 * up. */
typedef struct {
    int simple, doubles, complete;
    double c[PUMA560_CALIBRATED_ROOTS + 8], s[PUMA560_CALIBRATED_ROOTS + 8];
    double double_c[PUMA560_CALIBRATED_ROOTS], double_s[PUMA560_CALIBRATED_ROOTS];
} puma560_calibrated_roots;

static void puma560_calibrated_fit(const double samples[24], puma560_calibrated_trigonometric *f)
{
    double h[24] = {0.0}, most = 0.0, beyond = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    for (int k = 0; k < 24; k++) {
        for (int j = 0; j < 24; j++) {
            h[j] += samples[k] * puma560_calibrated_harmonics[k][j];
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
    f->rounding = most * (3e-15 + 8.0 * f->noise);
}

/* f, f', f'' where the cosine and sine are given */
static void puma560_calibrated_at(const puma560_calibrated_trigonometric *f, double cosine, double
    sine, double out[3])
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

static void puma560_calibrated_fill_grid(const puma560_calibrated_trigonometric *f,
    puma560_calibrated_grid *g)
{
    for (int i = 0; i < 128; i += PUMA560_CALIBRATED_LANES) {
        /* [0]: even multiples, the same half a turn on; [1]: odd ones, the opposite there */
        puma560_calibrated_lane value[2], slope[2], bend[2];
        value[0] = puma560_calibrated_all(f->a[0]);
        value[1] = slope[0] = slope[1] = bend[0] = bend[1] = puma560_calibrated_all(0.0);
        for (int m = 1; m < 9; m++) {
            const puma560_calibrated_lane c = PUMA560_CALIBRATED_LOAD(&puma560_calibrated_grid_c[m -
                1][i]);
            const puma560_calibrated_lane s = PUMA560_CALIBRATED_LOAD(&puma560_calibrated_grid_s[m -
                1][i]);
            const double ma = m * f->a[m], mb = m * f->b[m];
            value[m % 2] += f->a[m] * c + f->b[m] * s;
            slope[m % 2] += mb * c - ma * s;
            bend[m % 2] -= m * ma * c + m * mb * s;
        }
        PUMA560_CALIBRATED_STORE(&g->value[i], value[0] + value[1]);
        PUMA560_CALIBRATED_STORE(&g->slope[i], slope[0] + slope[1]);
        PUMA560_CALIBRATED_STORE(&g->bend[i], bend[0] + bend[1]);
        PUMA560_CALIBRATED_STORE(&g->value[i + 128], value[0] - value[1]);
        PUMA560_CALIBRATED_STORE(&g->slope[i + 128], slope[0] - slope[1]);
        PUMA560_CALIBRATED_STORE(&g->bend[i + 128], bend[0] - bend[1]);
    }
    g->value[256] = g->value[0];
    g->slope[256] = g->slope[0];
    g->bend[256] = g->bend[0];
}

/* Which of 64 cells may have roots: those where the Bernstein coefficients of the quintic through
 * f, f', f'' at both edges are not all of one sign beyond doubt. */
static unsigned long long puma560_calibrated_open_cells(const puma560_calibrated_grid *g, int from,
    double doubt)
{
    const double h = 0.02454369260617026;
    unsigned long long bits = 0;
#if PUMA560_CALIBRATED_LANES > 1
    puma560_calibrated_mask weight, sum = {0};
    for (int k = 0; k < PUMA560_CALIBRATED_LANES; k++) {
        weight[k] = 1LL << k;
    }
#endif
    for (int i = 0; i < 64; i += PUMA560_CALIBRATED_LANES) {
        const puma560_calibrated_lane f0 = PUMA560_CALIBRATED_LOAD(&g->value[from + i]);
        const puma560_calibrated_lane f1 = PUMA560_CALIBRATED_LOAD(&g->value[from + i + 1]);
        const puma560_calibrated_lane d0 = PUMA560_CALIBRATED_LOAD(&g->slope[from + i]) * (h / 5.0);
        const puma560_calibrated_lane d1 = PUMA560_CALIBRATED_LOAD(&g->slope[from + i + 1]) * (h /
            5.0);
        const puma560_calibrated_lane s0 = PUMA560_CALIBRATED_LOAD(&g->bend[from + i]) * (h * h /
            20.0);
        const puma560_calibrated_lane s1 = PUMA560_CALIBRATED_LOAD(&g->bend[from + i + 1]) * (h * h
            / 20.0);
        const puma560_calibrated_lane b1 = f0 + d0, b2 = f0 + 2.0 * d0 + s0;
        const puma560_calibrated_lane b3 = f1 - 2.0 * d1 + s1, b4 = f1 - d1;
        const puma560_calibrated_lane least = puma560_calibrated_min(
            puma560_calibrated_min(puma560_calibrated_min(f0, f1), puma560_calibrated_min(b1, b2)),
                puma560_calibrated_min(b3, b4));
        const puma560_calibrated_lane most = puma560_calibrated_max(
            puma560_calibrated_max(puma560_calibrated_max(f0, f1), puma560_calibrated_max(b1, b2)),
                puma560_calibrated_max(b3, b4));
        const puma560_calibrated_mask open = (least <= doubt) & (most >= -doubt);
#if PUMA560_CALIBRATED_LANES > 1
        sum |= (open & weight) << i;
#else
        bits |= (unsigned long long)(open != 0) << i;
#endif
    }
#if PUMA560_CALIBRATED_LANES > 1
    for (int k = 0; k < PUMA560_CALIBRATED_LANES; k++) {
        bits |= (unsigned long long)sum[k];
    }
#endif
    return bits;
}

static void puma560_calibrated_add_root(puma560_calibrated_roots *roots, double x, int twice)
{
    const double c = cos(x), s = sin(x);
    int *const count = twice ? &roots->doubles : &roots->simple;
    if (twice) {
        for (int i = 0; i < roots->doubles; i++) {
            const double gap = fabs(s * roots->double_c[i] - c * roots->double_s[i]);
            if (gap < 0.02454369260617026 / 64.0 && c * roots->double_c[i] + s * roots->double_s[i]
                > 0.0) {
                return; /* neighbouring cells that were given up together */
            }
        }
    }
    if (*count == PUMA560_CALIBRATED_ROOTS) {
        roots->complete = 0;
        return;
    }
    (twice ? roots->double_c : roots->c)[*count] = c;
    (twice ? roots->double_s : roots->s)[*count] = s;
    *count += 1;
}

/* Where f (order 0) or f' (order 1) vanishes between two angles at which it has unlike signs:
 * Newton,
 * with bisection where it leaves. `rising` says that it is negative at the lower one. */
static double puma560_calibrated_between(const puma560_calibrated_trigonometric *f, int order,
    double low, double high,
                              int rising)
{
    double x = 0.5 * (low + high);
    for (int i = 0; i < 48; i++) {
        double at[3], step;
        puma560_calibrated_at(f, cos(x), sin(x), at);
        if ((at[order] < 0.0) == rising) {
            low = x;
        } else {
            high = x;
        }
        step = fabs(at[order + 1]) > 0.0 ? -at[order] / at[order + 1] : high - low;
        if (fabs(step) < 1e-15) {
            break;
        }
        x = x + step > low && x + step < high ? x + step : 0.5 * (low + high);
    }
    return x;
}

/* The roots of a cell where f has one extremum at most. */
static void puma560_calibrated_few(const puma560_calibrated_trigonometric *f, double low, const
    double at_low[3],
                        double high, const double at_high[3], puma560_calibrated_roots *roots)
{
    double x, at[3];
    if (at_low[1] * at_high[1] >= 0.0) {
        if ((at_low[0] < 0.0) != (at_high[0] < 0.0)) {
            puma560_calibrated_add_root(roots, puma560_calibrated_between(f, 0, low, high, at_low[0]
                < 0.0), 0);
        }
        return;
    }
    x = puma560_calibrated_between(f, 1, low, high, at_low[1] < 0.0);
    puma560_calibrated_at(f, cos(x), sin(x), at);
    if (fabs(at[0]) <= f->rounding ||
        (at[0] * at[2] > 0.0 && fabs(at[0]) <= fabs(at[2]) * 5e-09)) {
        puma560_calibrated_add_root(roots, x, 1);
        return;
    }
    if ((at_low[0] < 0.0) != (at[0] < 0.0)) {
        puma560_calibrated_add_root(roots, puma560_calibrated_between(f, 0, low, x, at_low[0] <
            0.0), 0);
    }
    if ((at_high[0] < 0.0) != (at[0] < 0.0)) {
        puma560_calibrated_add_root(roots, puma560_calibrated_between(f, 0, x, high, at[0] < 0.0),
            0);
    }
}

/* What is known about f between two angles. */
enum { PUMA560_CALIBRATED_ROOTLESS, PUMA560_CALIBRATED_FLAT, PUMA560_CALIBRATED_TAME,
    PUMA560_CALIBRATED_WILD };

/* Rootless; flat, nothing but rounding; tame, with one extremum at most; or none of these. The
 * Bernstein coefficients of the quintic through f, f', f'' at both ends and their differences bound
 * f, f' and f''. */
static int puma560_calibrated_kind(const puma560_calibrated_trigonometric *f, const double low[3],
    const double high[3],
                        double h)
{
    const double part = h / 0.02454369260617026, square = part * part;
    const double doubt = f->rounding + f->scale * 2e-09 * square * square * square;
    const double b[6] = {low[0],
                         low[0] + h * low[1] / 5.0,
                         low[0] + 2.0 * h * low[1] / 5.0 + h * h * low[2] / 20.0,
                         high[0] - 2.0 * h * high[1] / 5.0 + h * h * high[2] / 20.0,
                         high[0] - h * high[1] / 5.0,
                         high[0]};
    double least[3] = {b[5], HUGE_VAL, HUGE_VAL}, most[3] = {b[5], -HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 5; i++) {
        const double first = b[i + 1] - b[i];
        least[0] = b[i] < least[0] ? b[i] : least[0];
        most[0] = b[i] > most[0] ? b[i] : most[0];
        least[1] = first < least[1] ? first : least[1];
        most[1] = first > most[1] ? first : most[1];
        if (i < 4) {
            const double second = b[i + 2] - b[i + 1] - first;
            least[2] = second < least[2] ? second : least[2];
            most[2] = second > most[2] ? second : most[2];
        }
    }
    if (least[0] > doubt || most[0] < -doubt) {
        return PUMA560_CALIBRATED_ROOTLESS;
    }
    if (least[0] >= -f->rounding && most[0] <= f->rounding) {
        return PUMA560_CALIBRATED_FLAT;
    }
    /* what rounding does to f' and f'' shrinks with the width, down to that of the quintic's ends
     * */
    return least[1] > doubt * part || most[1] < -doubt * part || least[2] > doubt * square ||
                   most[2] < -doubt * square
               ? PUMA560_CALIBRATED_TAME
               : PUMA560_CALIBRATED_WILD;
}

/* The roots of a cell where f may turn more than once: halve it until it does not. */
static void puma560_calibrated_many(const puma560_calibrated_trigonometric *f, double low, double
    high,
                         const double first[3], const double last[3], int *budget,
                         puma560_calibrated_roots *roots)
{
    double edge[16], at[16][3]; /* the upper edges still to come */
    double at_low[3];
    int depth[16], open = 1;
    edge[0] = high;
    depth[0] = 0;
    for (int i = 0; i < 3; i++) {
        at_low[i] = first[i];
        at[0][i] = last[i];
    }
    while (open > 0) {
        const int top = open - 1;
        const double h = edge[top] - low;
        const int kind = puma560_calibrated_kind(f, at_low, at[top], h);
        if (kind != PUMA560_CALIBRATED_ROOTLESS) {
            if (kind == PUMA560_CALIBRATED_TAME) {
                puma560_calibrated_few(f, low, at_low, edge[top], at[top], roots);
            } else if (kind == PUMA560_CALIBRATED_FLAT || depth[top] == 14 || *budget == 0) {
                roots->complete = 0;
                puma560_calibrated_add_root(roots, low + 0.5 * h, 1);
            } else {
                *budget -= 1;
                edge[open] = low + 0.5 * h;
                depth[top] += 1;
                depth[open] = depth[top];
                puma560_calibrated_at(f, cos(edge[open]), sin(edge[open]), at[open]);
                open++;
                continue;
            }
        }
        low = edge[top];
        for (int i = 0; i < 3; i++) {
            at_low[i] = at[top][i];
        }
        open--;
    }
}

/* Roots of cells where f rises or falls throughout: `cell` has their numbers. First on the quintic,
 * then one step of Newton on f itself. */
static void puma560_calibrated_refine(const puma560_calibrated_trigonometric *f, const
    puma560_calibrated_grid *g, const int *cell,
                           int count, double *cosine, double *sine)
{
    const double h = 0.02454369260617026;
    for (int from = 0; from < count; from += PUMA560_CALIBRATED_LANES) {
        double in[8][PUMA560_CALIBRATED_LANES];
        puma560_calibrated_lane c, s, low, high, x, value, slope, cm, sm;
        for (int k = 0; k < PUMA560_CALIBRATED_LANES; k++) {
            const int i = cell[from + k < count ? from + k : count - 1];
            const int half = i % 128;
            in[0][k] = g->value[i];
            in[1][k] = g->value[i + 1];
            in[2][k] = h * g->slope[i];
            in[3][k] = h * g->slope[i + 1];
            in[4][k] = h * h * g->bend[i];
            in[5][k] = h * h * g->bend[i + 1];
            in[6][k] = i < 128 ? puma560_calibrated_grid_c[0][half] :
                -puma560_calibrated_grid_c[0][half];
            in[7][k] = i < 128 ? puma560_calibrated_grid_s[0][half] :
                -puma560_calibrated_grid_s[0][half];
        }
        const puma560_calibrated_lane f0 = PUMA560_CALIBRATED_LOAD(in[0]), f1 =
            PUMA560_CALIBRATED_LOAD(in[1]), d0 = PUMA560_CALIBRATED_LOAD(in[2]);
        const puma560_calibrated_lane s0 = PUMA560_CALIBRATED_LOAD(in[4]);
        const puma560_calibrated_lane D = f1 - f0 - d0 - 0.5 * s0, D1 =
            PUMA560_CALIBRATED_LOAD(in[3]) - d0 - s0;
        const puma560_calibrated_lane D2 = PUMA560_CALIBRATED_LOAD(in[5]) - s0;
        const puma560_calibrated_lane q3 = 10.0 * D - 4.0 * D1 + 0.5 * D2, q4 = 7.0 * D1 - 15.0 * D
            - D2;
        const puma560_calibrated_lane q5 = 6.0 * D - 3.0 * D1 + 0.5 * D2;
        const puma560_calibrated_lane rising =
            puma560_calibrated_with_sign(puma560_calibrated_all(1.0), f1 - f0);
        low = puma560_calibrated_all(0.0);
        high = puma560_calibrated_all(1.0);
        x = f0 / (f0 - f1);
        for (int i = 0; i < 4; i++) {
            value = f0 + x * (d0 + x * (0.5 * s0 + x * (q3 + x * (q4 + x * q5))));
            slope = d0 + x * (s0 + x * (3.0 * q3 + x * (4.0 * q4 + x * (5.0 * q5))));
            low = puma560_calibrated_select(value * rising < 0.0, x, low);
            high = puma560_calibrated_select(value * rising < 0.0, high, x);
            x = x - value / slope;
            x = puma560_calibrated_select((x >= low) & (x <= high), x, 0.5 * (low + high));
        }
        x *= h;
        for (int i = 0; i < 2; i++) {
            const puma560_calibrated_lane u = x * x, c0 = i ? c : PUMA560_CALIBRATED_LOAD(in[6]),
                s_0 = i ? s : PUMA560_CALIBRATED_LOAD(in[7]);
            const puma560_calibrated_lane dc = 1.0 - u * (0.5 - u * (1.0 / 24.0 - u * (1.0 /
                720.0)));
            const puma560_calibrated_lane ds =
                x * (1.0 - u * (1.0 / 6.0 - u * (1.0 / 120.0 - u * (1.0 / 5040.0))));
            c = c0 * dc - s_0 * ds;
            s = s_0 * dc + c0 * ds;
            if (i) {
                break;
            }
            value = puma560_calibrated_all(f->a[0]);
            slope = puma560_calibrated_all(0.0);
            cm = c;
            sm = s;
            for (int m = 1; m < 9; m++) {
                const puma560_calibrated_lane next = cm * c - sm * s;
                value += f->a[m] * cm + f->b[m] * sm;
                slope += m * (f->b[m] * cm - f->a[m] * sm);
                sm = sm * c + cm * s;
                cm = next;
            }
            x = puma560_calibrated_max(puma560_calibrated_min(-value / slope,
                puma560_calibrated_all(1e-3 * h)), puma560_calibrated_all(-1e-3 * h));
        }
        PUMA560_CALIBRATED_STORE(cosine + from, c);
        PUMA560_CALIBRATED_STORE(sine + from, s);
    }
}

static int puma560_calibrated_lowest(unsigned long long bits)
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

static void puma560_calibrated_find_roots(const puma560_calibrated_trigonometric *f,
    puma560_calibrated_roots *roots)
{
    puma560_calibrated_grid g;
    int plain[PUMA560_CALIBRATED_ROOTS], special[256], plains = 0, specials = 0;
    int budget = 100; /* against an f that is next to nothing for long stretches */
    const double h = 0.02454369260617026;
    puma560_calibrated_fill_grid(f, &g);
    roots->doubles = 0;
    roots->complete = 1;
    for (int word = 0; word < 256 / 64; word++) {
        unsigned long long bits =
            puma560_calibrated_open_cells(&g, 64 * word, f->rounding + f->scale * 2e-09);
        for (; bits; bits &= bits - 1) {
            const int i = 64 * word + puma560_calibrated_lowest(bits);
            const double low[3] = {g.value[i], g.slope[i], g.bend[i]};
            const double high[3] = {g.value[i + 1], g.slope[i + 1], g.bend[i + 1]};
            if (low[1] * high[1] > 0.0 && plains < PUMA560_CALIBRATED_ROOTS &&
                puma560_calibrated_kind(f, low, high, h) == PUMA560_CALIBRATED_TAME) {
                if ((low[0] < 0.0) != (high[0] < 0.0)) {
                    plain[plains++] = i;
                }
            } else {
                special[specials++] = i;
            }
        }
    }
    puma560_calibrated_refine(f, &g, plain, plains, roots->c, roots->s);
    roots->simple = plains;
    for (int k = 0; k < specials; k++) {
        const int i = special[k];
        /* the edges' own values, so that neighbouring cells agree about their signs */
        const double low[3] = {g.value[i], g.slope[i], g.bend[i]};
        const double high[3] = {g.value[i + 1], g.slope[i + 1], g.bend[i + 1]};
        if (puma560_calibrated_kind(f, low, high, h) == PUMA560_CALIBRATED_TAME) {
            puma560_calibrated_few(f, i * h, low, (i + 1) * h, high, roots);
        } else {
            puma560_calibrated_many(f, i * h, (i + 1) * h, low, high, &budget, roots);
        }
    }
}

/* Candidates: the hidden angle and a null vector, (x3, 1) x (x2^2, x2, 1) times anything. The
 * simple
 * roots come first, one candidate each; after them those of roots that may be double, `group` being
 * the same for all that belong to one such root. */
typedef struct {
    int count, groups, group[PUMA560_CALIBRATED_CANDIDATES];
    double c[PUMA560_CALIBRATED_CANDIDATES], s[PUMA560_CALIBRATED_CANDIDATES],
        n[6][PUMA560_CALIBRATED_CANDIDATES];
} puma560_calibrated_candidates;

/* a rigid transform for each lane */
typedef puma560_calibrated_lane puma560_calibrated_rigid[3][4];

/* x = U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal */
static inline void puma560_calibrated_inverse_iteration(puma560_calibrated_lane U[6][6], const
    puma560_calibrated_lane inverse[6],
                                             puma560_calibrated_lane x[6])
{
    puma560_calibrated_lane square = {0};
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
    square = 1.0 / puma560_calibrated_sqrt(square);
    for (int i = 0; i < 6; i++) {
        x[i] *= square;
    }
}

/* The reciprocals of a diagonal, kept finite. */
static inline void puma560_calibrated_reciprocals(puma560_calibrated_lane U[6][6],
    puma560_calibrated_lane inverse[6])
{
    puma560_calibrated_lane most = puma560_calibrated_abs(U[0][0]);
    for (int i = 1; i < 6; i++) {
        most = puma560_calibrated_max(most, puma560_calibrated_abs(U[i][i]));
    }
    most = most * 1e-15 + 1e-300;
    for (int i = 0; i < 6; i++) {
        const puma560_calibrated_lane d = U[i][i];
        inverse[i] = 1.0 / puma560_calibrated_select(puma560_calibrated_abs(d) > most, d,
            puma560_calibrated_with_sign(most, d));
    }
}

/* One candidate for each simple root. */
static void puma560_calibrated_null_vectors(const double *E, const puma560_calibrated_roots *roots,
                                 puma560_calibrated_candidates *out)
{
    static const double start[6] = { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 };
    for (int from = 0; from < roots->simple; from += PUMA560_CALIBRATED_LANES) {
        double cs[2][PUMA560_CALIBRATED_LANES];
        puma560_calibrated_lane factor[6][6], inverse[6], x[6], c, s;
        for (int k = 0; k < PUMA560_CALIBRATED_LANES; k++) {
            const int i = from + k < roots->simple ? from + k : from;
            cs[0][k] = roots->c[i];
            cs[1][k] = roots->s[i];
        }
        c = PUMA560_CALIBRATED_LOAD(cs[0]);
        s = PUMA560_CALIBRATED_LOAD(cs[1]);
        (void)puma560_calibrated_fold(E, c, s, factor);
        puma560_calibrated_reciprocals(factor, inverse);
        for (int i = 0; i < 6; i++) {
            x[i] = puma560_calibrated_all(start[i]);
        }
        puma560_calibrated_inverse_iteration(factor, inverse, x);
        puma560_calibrated_inverse_iteration(factor, inverse, x);
        PUMA560_CALIBRATED_STORE(out->c + from, c);
        PUMA560_CALIBRATED_STORE(out->s + from, s);
        for (int i = 0; i < 6; i++) {
            PUMA560_CALIBRATED_STORE(out->n[i] + from, x[i]);
        }
    }
    out->count = roots->simple;
    out->groups = 0;
}

static void puma560_calibrated_add_candidate(puma560_calibrated_candidates *out, double c, double s,
    const double n[6])
{
    if (out->count == PUMA560_CALIBRATED_CANDIDATES) {
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
static void puma560_calibrated_split(double n[2][6], int rows, const int *up, const int *down,
    double c,
                          double s, puma560_calibrated_candidates *out)
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
        puma560_calibrated_add_candidate(out, c, s, sum);
    }
}

/* Candidates where two roots may have met: the null space may be a plane, which is split where one
 * of the two shifts, x3 or x2, has an eigenvalue. */
static void puma560_calibrated_null_plane(const double *E, double c, double s,
    puma560_calibrated_candidates *out)
{
    static const int up_3[3] = {0, 1, 2}, down_3[3] = {3, 4, 5};
    static const int up_2[4] = {0, 1, 3, 4}, down_2[4] = {1, 2, 4, 5};
    static const double start[2][6] = {
        { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 },
        { -0.31, 0.47, 0.59, 0.67, -0.23, 0.41 },
    };
    puma560_calibrated_lane factor[6][6], inverse[6], x[2][6];
    double n[2][6];
    (void)puma560_calibrated_fold(E, puma560_calibrated_all(c), puma560_calibrated_all(s), factor);
    puma560_calibrated_reciprocals(factor, inverse);
    for (int i = 0; i < 6; i++) {
        x[0][i] = puma560_calibrated_all(start[0][i]);
        x[1][i] = puma560_calibrated_all(start[1][i]);
    }
    for (int step = 0; step < 4; step++) {
        puma560_calibrated_lane along = {0};
        puma560_calibrated_inverse_iteration(factor, inverse, x[0]);
        puma560_calibrated_inverse_iteration(factor, inverse, x[1]);
        for (int i = 0; i < 6; i++) {
            along += x[0][i] * x[1][i];
        }
        for (int i = 0; i < 6; i++) {
            x[1][i] -= along * x[0][i];
        }
    }
    for (int r = 0; r < 2; r++) {
        double length = 0.0;
        for (int i = 0; i < 6; i++) {
            n[r][i] = puma560_calibrated_largest(x[r][i]);
            length += n[r][i] * n[r][i];
        }
        length = sqrt(length) + 1e-300;
        for (int i = 0; i < 6; i++) {
            n[r][i] /= length;
        }
    }
    puma560_calibrated_add_candidate(out, c, s, n[0]);
    puma560_calibrated_split(n, 3, up_3, down_3, c, s, out);
    puma560_calibrated_split(n, 4, up_2, down_2, c, s, out);
    out->groups++;
}

/* T Rz */
static inline void puma560_calibrated_turn(puma560_calibrated_rigid T, puma560_calibrated_lane c,
    puma560_calibrated_lane s)
{
    for (int i = 0; i < 3; i++) {
        const puma560_calibrated_lane x = T[i][0];
        T[i][0] = x * c + T[i][1] * s;
        T[i][1] = T[i][1] * c - x * s;
    }
}

/* T K, the same K for every lane */
static inline void puma560_calibrated_follow(puma560_calibrated_rigid T, const double K[12])
{
    for (int i = 0; i < 3; i++) {
        const puma560_calibrated_lane x = T[i][0], y = T[i][1], z = T[i][2];
        for (int j = 0; j < 3; j++) {
            T[i][j] = x * K[j] + y * K[4 + j] + z * K[8 + j];
        }
        T[i][3] += x * K[3] + y * K[7] + z * K[11];
    }
}

static inline void puma560_calibrated_begin(puma560_calibrated_rigid T, const double K[12])
{
    for (int i = 0; i < 12; i++) {
        T[i / 4][i % 4] = puma560_calibrated_all(K[i]);
    }
}

/* The terms a c + b s + w of five invariants of B = Rz K Rz(phi5) M Rz: l_z, p_z, p.l, p.p / 2 and
 * (p x l)_z; and the 2x5 matrix that solves them for c and s by least squares. */
static void puma560_calibrated_invariants(const double K[12], const double M[12], double w[5],
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

static inline void puma560_calibrated_to_unit(puma560_calibrated_lane *c, puma560_calibrated_lane
    *s)
{
    const puma560_calibrated_lane square = *c * *c + *s * *s, factor = 1.0 /
        puma560_calibrated_sqrt(square + 1e-300);
    *c = puma560_calibrated_select(square > 1e-300, *c * factor, puma560_calibrated_all(1.0));
    *s = puma560_calibrated_select(square > 1e-300, *s * factor, puma560_calibrated_all(0.0));
}

/* phi_2 and phi_3 from the null vector */
static inline void puma560_calibrated_partners(const puma560_calibrated_lane n[6],
    puma560_calibrated_lane c[6], puma560_calibrated_lane s[6])
{
    const puma560_calibrated_lane up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const puma560_calibrated_lane down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5];
    puma560_calibrated_lane row[3], sign, top, bottom;
    for (int i = 0; i < 3; i++) {
        row[i] = puma560_calibrated_select(up > down, n[i], n[3 + i]);
    }
    sign = puma560_calibrated_with_sign(puma560_calibrated_all(1.0), row[0] + row[2]);
    c[1] = sign * (row[2] - row[0]);
    s[1] = sign * 2.0 * row[1];
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2];
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2];
    c[2] = bottom * bottom - top * top;
    s[2] = 2.0 * top * bottom;
    puma560_calibrated_to_unit(&c[1], &s[1]);
    puma560_calibrated_to_unit(&c[2], &s[2]);
}

/* phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve` are those of the invariants. */
static inline void puma560_calibrated_others(double link[6][12], const double w[5], double
    solve[2][5],
                                  puma560_calibrated_lane c[6], puma560_calibrated_lane s[6])
{
    puma560_calibrated_rigid G, C;
    puma560_calibrated_lane l[3], q[3], value[5], x, y;
    puma560_calibrated_begin(G, link[5]);
    for (int i = 0; i < 3; i++) {
        puma560_calibrated_turn(G, c[i], s[i]);
        puma560_calibrated_follow(G, link[i]);
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
    c[4] = s[4] = puma560_calibrated_all(0.0);
    for (int i = 0; i < 5; i++) {
        c[4] += solve[0][i] * (value[i] - w[i]);
        s[4] += solve[1][i] * (value[i] - w[i]);
    }
    puma560_calibrated_to_unit(&c[4], &s[4]);
    puma560_calibrated_begin(C, link[3]);
    puma560_calibrated_turn(C, c[4], s[4]);
    puma560_calibrated_follow(C, link[4]);
    c[3] = C[0][2] * l[0] + C[1][2] * l[1] + C[0][3] * q[0] + C[1][3] * q[1];
    s[3] = C[0][2] * l[1] - C[1][2] * l[0] + C[0][3] * q[1] - C[1][3] * q[0];
    puma560_calibrated_to_unit(&c[3], &s[3]);
    c[5] = s[5] = puma560_calibrated_all(0.0);
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
    puma560_calibrated_to_unit(&c[5], &s[5]);
}

/* The loop's error at cosines and sines of the joints: translation and rotation vector that are
 * missing. J, when given, takes the rows of the Jacobian with the error as seventh column. Returns
 * the square of the error. */
static inline puma560_calibrated_lane puma560_calibrated_error(const double P[12], const
    puma560_calibrated_lane c[6],
                                         const puma560_calibrated_lane s[6], puma560_calibrated_lane
                                             J[6][7])
{
    static const double identity[12] = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    puma560_calibrated_rigid T;
    puma560_calibrated_lane z[6][3], o[6][3], S[3][3], square = {0}, trace;
    puma560_calibrated_begin(T, identity);
    for (int k = 0; k < 6; k++) {
        if (k) {
            puma560_calibrated_follow(T, puma560_calibrated_link[k - 1]);
        }
        for (int i = 0; i < 3; i++) {
            z[k][i] = T[i][2];
            o[k][i] = T[i][3];
        }
        puma560_calibrated_turn(T, c[k], s[k]);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            S[i][j] = P[4 * i] * T[j][0] + P[4 * i + 1] * T[j][1] + P[4 * i + 2] * T[j][2];
        }
        J[i][6] = P[4 * i + 3] - T[i][3];
    }
    J[3][6] = 0.5 * (S[2][1] - S[1][2]);
    J[4][6] = 0.5 * (S[0][2] - S[2][0]);
    J[5][6] = 0.5 * (S[1][0] - S[0][1]);
    for (int i = 0; i < 6; i++) {
        square += J[i][6] * J[i][6];
    }
    for (int k = 0; k < 6; k++) {
        for (int i = 0; i < 3; i++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            J[i][k] = z[k][i1] * (T[i2][3] - o[k][i2]) - z[k][i2] * (T[i1][3] - o[k][i1]);
            J[3 + i][k] = z[k][i];
        }
    }
    /* half a turn away the skew part vanishes too: the trace tells */
    trace = S[0][0] + S[1][1] + S[2][2];
    return puma560_calibrated_select(trace < 0.0, square + 1.0, square);
}

/* A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
 * next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
 * largest. */
static inline puma560_calibrated_lane puma560_calibrated_step(puma560_calibrated_lane J[6][7],
    puma560_calibrated_lane x[6])
{
    puma560_calibrated_lane *const row[6] = {J[0], J[1], J[2], J[3], J[4], J[5]};
    puma560_calibrated_lane most, least;
    const puma560_calibrated_lane zero = {0};
    puma560_calibrated_reflect(row, 6, 0, 7);
    puma560_calibrated_reflect(row + 1, 5, 1, 7);
    puma560_calibrated_reflect(row + 2, 4, 2, 7);
    puma560_calibrated_reflect(row + 3, 3, 3, 7);
    puma560_calibrated_reflect(row + 4, 2, 4, 7);
    most = least = puma560_calibrated_abs(J[0][0]);
    for (int i = 1; i < 6; i++) {
        most = puma560_calibrated_max(most, puma560_calibrated_abs(J[i][i]));
        least = puma560_calibrated_min(least, puma560_calibrated_abs(J[i][i]));
    }
    least /= most;
    most *= 1e-09;
    for (int i = 5; i >= 0; i--) {
        puma560_calibrated_lane sum = J[i][6];
        for (int j = i + 1; j < 6; j++) {
            sum -= J[i][j] * x[j];
        }
        sum /= J[i][i];
        sum = puma560_calibrated_max(puma560_calibrated_min(sum, zero + 1.0), zero - 1.0);
        x[i] = puma560_calibrated_select(puma560_calibrated_abs(J[i][i]) > most, sum, zero);
    }
    return least;
}

/* The same damped, for starts far away and for singular solutions: (J' J + d) x = J' error. */
static inline void puma560_calibrated_damped_step(puma560_calibrated_lane J[6][7],
    puma560_calibrated_lane damping, puma560_calibrated_lane x[6])
{
    puma560_calibrated_lane A[6][7];
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
        const puma560_calibrated_lane pivot = 1.0 / (A[i][i] + 1e-30);
        for (int j = i + 1; j < 6; j++) {
            const puma560_calibrated_lane factor = A[i][j] * pivot;
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
        x[i] = puma560_calibrated_max(puma560_calibrated_min(x[i], puma560_calibrated_all(1.0)),
            puma560_calibrated_all(-1.0));
    }
}

/* Newton on the loop; what remains in c and s is the best iterate, and its error is returned. */
static inline puma560_calibrated_lane puma560_calibrated_polish(const double P[12],
    puma560_calibrated_lane c[6], puma560_calibrated_lane s[6],
                                          int steps, int afar)
{
    puma560_calibrated_lane J[6][7], x[6], tc[6], ts[6], least, now;
    for (int i = 0; i < 6; i++) {
        tc[i] = c[i];
        ts[i] = s[i];
    }
    least = now = puma560_calibrated_error(P, c, s, J);
    for (int step = 0; step < steps; step++) {
        puma560_calibrated_mask better;
        if (puma560_calibrated_largest(least) < 1e-29) {
            break;
        }
        if (afar) {
            puma560_calibrated_damped_step(J, puma560_calibrated_min(now * 0.01,
                puma560_calibrated_all(0.01)), x);
        } else {
            (void)puma560_calibrated_step(J, x);
        }
        for (int i = 0; i < 6; i++) {
            /* a turn by 2 atan(x/2), without trigonometry */
            const puma560_calibrated_lane u = 0.25 * x[i] * x[i], f = 1.0 / (1.0 + u);
            const puma560_calibrated_lane dc = (1.0 - u) * f, ds = x[i] * f, old = tc[i];
            tc[i] = old * dc - ts[i] * ds;
            ts[i] = ts[i] * dc + old * ds;
        }
        now = puma560_calibrated_error(P, tc, ts, J);
        better = now < least;
        for (int i = 0; i < 6; i++) {
            c[i] = puma560_calibrated_select(better, tc[i], c[i]);
            s[i] = puma560_calibrated_select(better, ts[i], s[i]);
        }
        least = puma560_calibrated_select(better, now, least);
    }
    return puma560_calibrated_sqrt(least);
}

/* The solutions found so far. */
typedef struct {
    int count;
    unsigned singular; /* bit i: the arm is singular at solution i */
    int doubles; /* roots that met */
    double q[16][6], residual[16];
} puma560_calibrated_found;

/* The largest difference of two joint vectors, modulo turns. */
static double puma560_calibrated_gap(const double a[6], const double b[6])
{
    double most = 0.0;
    for (int j = 0; j < 6; j++) {
        double gap = fabs(a[j] - b[j]);
        gap = gap > 3.141592653589793 ? 6.283185307179586 - gap : gap;
        most = gap > most ? gap : most;
    }
    return most;
}

/* Add a solution unless it is known or none; its place, or -1. */
static int puma560_calibrated_keep(puma560_calibrated_found *found, double theta[6], double
    residual)
{
    if (!(residual <= 1e-10)) {
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (puma560_calibrated_gap(found->q[i], theta) < 1e-06) {
            if (residual < found->residual[i]) {
                found->residual[i] = residual;
                for (int j = 0; j < 6; j++) {
                    found->q[i][j] = theta[j];
                }
            }
            return i;
        }
    }
    if (found->count == 16) {
        return -1;
    }
    found->residual[found->count] = residual;
    for (int j = 0; j < 6; j++) {
        found->q[found->count][j] = theta[j];
    }
    return found->count++;
}

/* Polish candidates, given by cosines and sines, and keep what they lead to; bit i of the answer:
 * the
 * i-th solution was met. `place` takes which solution each candidate became, or -1. With `doubtful`
 * candidates singular solutions are marked. */
static unsigned puma560_calibrated_offer(const double P[12], puma560_calibrated_lane c[6],
    puma560_calibrated_lane s[6], int count,
                              int steps, int doubtful, puma560_calibrated_found *found,
                              int place[PUMA560_CALIBRATED_LANES])
{
    double residual[PUMA560_CALIBRATED_LANES], theta[6][PUMA560_CALIBRATED_LANES],
        pivot[PUMA560_CALIBRATED_LANES] = {0.0};
    unsigned met = 0;
    PUMA560_CALIBRATED_STORE(residual, puma560_calibrated_polish(P, c, s, steps, steps > 4));
    if (doubtful) {
        puma560_calibrated_lane J[6][7], x[6];
        (void)puma560_calibrated_error(P, c, s, J);
        PUMA560_CALIBRATED_STORE(pivot, puma560_calibrated_step(J, x));
    }
    for (int i = 0; i < 6; i++) {
        PUMA560_CALIBRATED_STORE(theta[i], puma560_calibrated_angle(s[i], c[i]));
    }
    for (int k = 0; k < count; k++) {
        double row[6];
        for (int i = 0; i < 6; i++) {
            /* half a turn is +pi, also when rounding says otherwise */
            row[i] = theta[i][k] < -3.141592653589783 ? 3.141592653589793 : theta[i][k];
        }
        place[k] = puma560_calibrated_keep(found, row, residual[k]);
        if (place[k] >= 0) {
            met |= 1u << place[k];
            if (doubtful && pivot[k] < 1e-06) {
                found->singular |= 1u << place[k];
            }
        }
    }
    return met;
}

/* Roots that nearly meet are tried as one double root too. */
static void puma560_calibrated_close_roots(const double *E, const puma560_calibrated_roots *roots,
    puma560_calibrated_candidates *out)
{
    for (int i = 0; i < roots->simple; i++) {
        for (int j = 0; j < i; j++) {
            const double c = roots->c[i] + roots->c[j], s = roots->s[i] + roots->s[j];
            const double square = c * c + s * s;
            if (square > 3.999999) {
                const double factor = 1.0 / sqrt(square);
                puma560_calibrated_null_plane(E, c * factor, s * factor, out);
            }
        }
    }
}

static int puma560_calibrated_bits(unsigned set)
{
    int count = 0;
    for (; set; set &= set - 1) {
        count++;
    }
    return count;
}

/* Whether the number of regular solutions is even. */
static int puma560_calibrated_paired(const puma560_calibrated_found *found)
{
    return (found->count - puma560_calibrated_bits(found->singular)) % 2 == 0;
}

/* Polish all candidates of a formulation. The certificate: every simple root leads to a solution,
 * there
 * is another one for each of them and two more for each double root, or a singular one; and regular
 * solutions come in pairs. */
static int puma560_calibrated_settle(const puma560_calibrated_formulation *form, const double P[12],
                          const puma560_calibrated_candidates *all, int simple, int doubles,
                          puma560_calibrated_found *found)
{
    double link[6][12], w[5], solve[2][5];
    unsigned met = 0, of_group[PUMA560_CALIBRATED_CANDIDATES] = {0};
    int complete = 1, expected = simple;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 12; j++) {
            link[i][j] = form->link[i][j];
        }
    }
    if (form->sign > 0.0) {
        puma560_calibrated_invert(P, link[form->pose]);
    } else {
        for (int j = 0; j < 12; j++) {
            link[form->pose][j] = P[j];
        }
    }
    puma560_calibrated_invariants(link[3], link[4], w, solve);
    for (int from = 0; from < all->count; from += PUMA560_CALIBRATED_LANES) {
        const int count = all->count - from < PUMA560_CALIBRATED_LANES ? all->count - from :
            PUMA560_CALIBRATED_LANES;
        puma560_calibrated_lane n[6], c[6], s[6], tc[6], ts[6];
        int place[PUMA560_CALIBRATED_LANES];
        c[0] = PUMA560_CALIBRATED_LOAD(all->c + from);
        s[0] = PUMA560_CALIBRATED_LOAD(all->s + from);
        for (int i = 0; i < 6; i++) {
            n[i] = PUMA560_CALIBRATED_LOAD(all->n[i] + from);
        }
        puma560_calibrated_partners(n, c, s);
        puma560_calibrated_others(link, w, solve, c, s);
        for (int i = 0; i < 6; i++) {
            tc[form->joint[i]] = c[i];
            ts[form->joint[i]] = form->sign * s[i];
        }
        met |= puma560_calibrated_offer(P, tc, ts, count, 4, from + count > simple, found, place);
        for (int k = 0; k < count; k++) {
            if (from + k < simple) {
                complete &= place[k] >= 0;
            } else if (place[k] >= 0) {
                of_group[all->group[from + k]] |= 1u << place[k];
            }
        }
    }
    for (int i = all->groups - doubles; i < all->groups; i++) {
        expected += of_group[i] & found->singular ? 1 : 2;
    }
    return complete && puma560_calibrated_bits(met) >= expected && puma560_calibrated_paired(found);
}

/* Find what a formulation finds; whether that is certainly everything. */
static int puma560_calibrated_attempt(const puma560_calibrated_formulation *form, const double
    P[12],
                           puma560_calibrated_found *found)
{
    double E[168], samples[24];
    puma560_calibrated_trigonometric f;
    puma560_calibrated_roots roots;
    puma560_calibrated_candidates all;
    puma560_calibrated_equations(form, P, E);
    for (int k = 0; k < 24; k += PUMA560_CALIBRATED_LANES) {
        puma560_calibrated_lane factor[6][6];
        PUMA560_CALIBRATED_STORE(samples + k, puma560_calibrated_fold(E,
            PUMA560_CALIBRATED_LOAD(puma560_calibrated_sample_c + k),
                                   PUMA560_CALIBRATED_LOAD(puma560_calibrated_sample_s + k),
                                       factor));
    }
    puma560_calibrated_fit(samples, &f);
    if (!(f.noise <= 1e-06)) {
        return 0;
    }
    puma560_calibrated_find_roots(&f, &roots);
    puma560_calibrated_null_vectors(E, &roots, &all);
    puma560_calibrated_close_roots(E, &roots, &all);
    for (int i = 0; i < roots.doubles; i++) {
        puma560_calibrated_null_plane(E, roots.double_c[i], roots.double_s[i], &all);
    }
    found->doubles += roots.doubles;
    return puma560_calibrated_settle(form, P, &all, roots.simple, roots.doubles, found) &&
        roots.complete;
}

/* Find what the methods find, one after the other, until that is certainly everything. */
static int puma560_calibrated_try(const double P[12], puma560_calibrated_found *found)
{
    int complete = 0;
    for (int i = 0; i < 2 && !complete; i++) {
        complete = puma560_calibrated_attempt(&puma560_calibrated_formulations[i], P, found);
    }
    return complete;
}

/* Newton from joint angles (count, 6) far from or near to solutions. */
static unsigned puma560_calibrated_follow_back(const double P[12], double (*start)[6], int count,
                                    puma560_calibrated_found *found, int *lost)
{
    unsigned met = 0;
    for (int from = 0; from < count; from += PUMA560_CALIBRATED_LANES) {
        const int now = count - from < PUMA560_CALIBRATED_LANES ? count - from :
            PUMA560_CALIBRATED_LANES;
        double cs[2][6][PUMA560_CALIBRATED_LANES];
        puma560_calibrated_lane c[6], s[6];
        int place[PUMA560_CALIBRATED_LANES];
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < PUMA560_CALIBRATED_LANES; k++) {
                const double angle = start[from + (k < now ? k : 0)][i];
                cs[0][i][k] = cos(angle);
                cs[1][i][k] = sin(angle);
            }
            c[i] = PUMA560_CALIBRATED_LOAD(cs[0][i]);
            s[i] = PUMA560_CALIBRATED_LOAD(cs[1][i]);
        }
        met |= puma560_calibrated_offer(P, c, s, now, 40, 1, found, place);
        for (int k = 0; k < now; k++) {
            *lost += place[k] < 0;
        }
    }
    return met;
}

/* Solve poses close by, and follow their solutions back. Where two solutions meet they are on one
 * side
 * only: both sides have to have as many as are found. Around a singular pose none of them has to
 * have
 * all solutions: then all are looked at. */
static int puma560_calibrated_from_nearby(const double P[12], puma560_calibrated_found *found)
{
    int followed = 0, before = -1;
    for (int n = 0; n < 10; n++) {
        double nearby[12];
        puma560_calibrated_found other;
        int complete, count = -1, lost = 0;
        unsigned met;
        puma560_calibrated_compose(P, puma560_calibrated_nudge[n], nearby);
        other.count = 0;
        other.singular = 0;
        other.doubles = 0;
        complete = puma560_calibrated_try(nearby, &other);
        met = puma560_calibrated_follow_back(P, other.q, other.count, found, &lost);
        if (complete && !lost && met) {
            count = puma560_calibrated_bits(met) == other.count ? other.count : -1;
            followed |= (met & found->singular) != 0;
        }
        if (n % 2 && before == found->count && count == found->count && !found->singular &&
            puma560_calibrated_paired(found)) {
            return 1;
        }
        before = count;
    }
    return followed && puma560_calibrated_paired(found);
}

/* Newton from many starts, the same on every run. */
static void puma560_calibrated_from_anywhere(const double P[12], puma560_calibrated_found *found)
{
    unsigned long long seed = 1;
    for (int batch = 0; batch < 8; batch++) {
        double start[8][6];
        int lost = 0;
        for (int i = 0; i < 48; i++) {
            seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
            start[i / 6][i % 6] = ((double)(seed >> 33) / 4294967296.0 - 0.25) * 4.0 *
                3.141592653589793;
        }
        (void)puma560_calibrated_follow_back(P, start, 8, found, &lost);
    }
}

/* Singular solutions are known less well: those that lie together become one. */
static void puma560_calibrated_merge(puma560_calibrated_found *found)
{
    const unsigned singular = found->singular;
    unsigned kept = 0;
    int count = 0;
    for (int i = 0; i < found->count; i++) {
        int known = 0;
        for (int j = 0; j < count && singular >> i & 1u; j++) {
            known |= (kept >> j & 1u) && puma560_calibrated_gap(found->q[i], found->q[j]) < 0.001;
        }
        if (!known) {
            kept |= (singular >> i & 1u) << count;
            found->residual[count] = found->residual[i];
            for (int j = 0; j < 6; j++) {
                found->q[count][j] = found->q[i][j];
            }
            count++;
        }
    }
    found->count = count;
    found->singular = kept;
}

/* Whether row a comes before row b: by the first angle, angles that agree to rounding by the next.
 * */
static int puma560_calibrated_before(const double a[6], const double b[6])
{
    for (int i = 0; i < 6; i++) {
        if (fabs(a[i] - b[i]) > 1e-09) {
            return a[i] < b[i];
        }
    }
    return 0;
}

/* All solutions of a rigid T = C0 Rz(q1) C1 ... Rz(q6) C6, at most 16.
 *
 * T: row by row. q: the angles, in (-pi, pi], rows in the order of q1, rows whose
 * q1 agree to 1e-09 rad in the order of q2, and so on. residual: by how much the loop stays
 * open, in radians and arm sizes. Returns how many; -1 - count when it is not certain that these
 * are
 * all: for want of a certificate, or because roots met or the arm is singular at a solution. */
static int puma560_calibrated_general(const double T[16], double q[16][6], double residual[16])
{
    puma560_calibrated_found found;
    double P[12], half[12];
    int order[16], complete;
    puma560_calibrated_compose(puma560_calibrated_left, T, half);
    puma560_calibrated_compose(half, puma560_calibrated_right, P);
    for (int i = 0; i < 3; i++) {
        P[4 * i + 3] *= 2.1654294481353777;
    }
    found.count = 0;
    found.singular = 0;
    found.doubles = 0;
    if (P[3] * P[3] + P[7] * P[7] + P[11] * P[11] > 4.0000000039999986) {
        return 0;
    }
    complete = puma560_calibrated_try(P, &found) || puma560_calibrated_from_nearby(P, &found);
    if (!complete) {
        puma560_calibrated_from_anywhere(P, &found);
    }
    puma560_calibrated_merge(&found);
    for (int i = 0; i < found.count; i++) {
        int j = i;
        for (; j > 0 && puma560_calibrated_before(found.q[i], found.q[order[j - 1]]); j--) {
            order[j] = order[j - 1];
        }
        order[j] = i;
    }
    for (int i = 0; i < found.count; i++) {
        for (int j = 0; j < 6; j++) {
            q[i][j] = found.q[order[i]][j];
        }
        residual[i] = found.residual[order[i]];
    }
    return complete && !found.singular && !found.doubles ? found.count : -1 - found.count;
}

/* All solutions. Where it is not certain that these are all, the seed and evenly spread starts are
 * followed too; singular solutions out of a continuum go to the seed. */
static void all_joints(
    const double T[16], const double seed[6], double q[16][6], int found[16], int chosen[16])
{
    static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
    static const double zero[6] = {
        0.0004277699642, 0.0006617156617, -0.0018179220006, 8.90468712e-05, 0.0009695294734,
        -0.0022050175347,
    };
    struct descent d = { .T = T };
    struct kept kept = { .count = 0 };
    double angles[16][6], residual[16], u[6];
    const int count = puma560_calibrated_general(T, angles, residual);
    for (int j = 0; j < 6; j++)
        u[j] = d.seed[j] = seed[j];
    if (count < 0 && descend(&d, u) <= 1e-10)
        keep(&d, &kept, u);
    for (int k = 0; k < (count < 0 ? -1 - count : count); k++) {
        for (int j = 0; j < 6; j++)
            u[j] = facing[j] * (angles[k][j] - zero[j]);
        if (count < 0) {
            keep(&d, &kept, u);
            continue;
        }
        wrap_angles(u);
        kept.singular[k] = kept.chosen[k] = 0;
        copy(u, kept.u[kept.count++]);
    }
    for (int k = 1; count < 0 && k < 12; k++) {
        start_of(&d, k, u);
        if (descend(&d, u) <= 1e-10)
            keep(&d, &kept, u);
    }
    sorted_rows(&d, &kept, q, found, chosen);
}

static const double d1 = 0.6712591624431; /* joint offset 1 [m] */
static const double a1 = 0.0026544606897; /* link length 1 [m] */
static const double ca1 = 0.0016085442592340678; /* cosine of twist 1 */
static const double sa1 = 0.9999987062918462; /* sine of twist 1 */
static const double d2 = -0.000143425944; /* joint offset 2 [m] */
static const double a2 = 0.4314454936115; /* link length 2 [m] */
static const double ca2 = 0.9999994314394958; /* cosine of twist 2 */
static const double sa2 = 0.001066358610003491; /* sine of twist 2 */
static const double d3 = 0.1490653237899; /* joint offset 3 [m] */
static const double a3 = 0.0201858398555; /* link length 3 [m] */
static const double ca3 = 0.0017412729567630927; /* cosine of twist 3 */
static const double sa3 = 0.9999984839830959; /* sine of twist 3 */
static const double d4 = 0.432695688237; /* joint offset 4 [m] */
static const double a4 = -0.001863305965; /* link length 4 [m] */
static const double ca4 = 0.001238887228280428; /* cosine of twist 4 */
static const double sa4 = 0.9999992325789233; /* sine of twist 4 */
static const double d5 = -0.00062817974; /* joint offset 5 [m] */
static const double a5 = -6.29954602e-05; /* link length 5 [m] */
static const double ca5 = 0.0007308690395286796; /* cosine of twist 5 */
static const double sa5 = 0.9999997329151878; /* sine of twist 5 */
static const double d6 = -0.0012011655652; /* joint offset 6 [m] */
static const double a6 = -9.3840846e-05; /* link length 6 [m] */
static const double ca6 = 0.9999988042061223; /* cosine of twist 6 */
static const double sa6 = 0.0015464754525777457; /* sine of twist 6 */
static const double offset1 = 0.0004277699642; /* offset of joint 1 [rad] */
static const double offset2 = 0.0006617156617; /* offset of joint 2 [rad] */
static const double offset3 = -0.0018179220006; /* offset of joint 3 [rad] */
static const double offset4 = 8.90468712e-05; /* offset of joint 4 [rad] */
static const double offset5 = 0.0009695294734; /* offset of joint 5 [rad] */
static const double offset6 = -0.0022050175347; /* offset of joint 6 [rad] */
static const double f1 = -2.3070697884642687e-07; /* d2 * ca1 [m] */
static const double f2 = 1.7152850204059354e-06; /* sa2 * ca1 */
static const double f3 = 0.0016085433446793326; /* ca2 * ca1 */
static const double g1 = -2.3070697884642687e-07; /* d2 * ca1 [m] */
static const double g2 = 1.7152850204059354e-06; /* sa2 * ca1 */
static const double g3 = 0.0016085433446793326; /* ca2 * ca1 */

const char *const puma560_calibrated_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

void puma560_calibrated_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1);
    const double s1 = sin(v1);
    const double v2 = s1 * ca1;
    const double y1_y = c1 * ca1;
    const double z1_x = s1 * sa1;
    const double v3 = c1 * sa1;
    const double v4 = q[1] + offset2;
    const double c2 = cos(v4);
    const double s2 = sin(v4);
    const double x2_x = c1 * c2 - v2 * s2;
    const double x2_y = s1 * c2 + y1_y * s2;
    const double x2_z = sa1 * s2;
    const double v5 = v2 * c2 + c1 * s2;
    const double v6 = y1_y * c2 - s1 * s2;
    const double v7 = sa1 * c2;
    const double y2_x = z1_x * sa2 - v5 * ca2;
    const double y2_y = v6 * ca2 - v3 * sa2;
    const double y2_z = v7 * ca2 + f2;
    const double z2_x = v5 * sa2 + z1_x * ca2;
    const double v8 = v6 * sa2 + v3 * ca2;
    const double z2_z = f3 - v7 * sa2;
    const double v9 = q[2] + offset3;
    const double c3 = cos(v9);
    const double s3 = sin(v9);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 + y2_y * s3;
    const double x3_z = x2_z * c3 + y2_z * s3;
    const double v10 = y2_x * c3 - x2_x * s3;
    const double v11 = y2_y * c3 - x2_y * s3;
    const double v12 = y2_z * c3 - x2_z * s3;
    const double y3_x = v10 * ca3 - z2_x * sa3;
    const double y3_y = v11 * ca3 + v8 * sa3;
    const double y3_z = v12 * ca3 - z2_z * sa3;
    const double z3_x = v10 * sa3 + z2_x * ca3;
    const double z3_y = v11 * sa3 - v8 * ca3;
    const double z3_z = v12 * sa3 + z2_z * ca3;
    const double v13 = q[3] + offset4;
    const double c4 = cos(v13);
    const double s4 = sin(v13);
    const double x4_x = x3_x * c4 + y3_x * s4;
    const double x4_y = x3_y * c4 + y3_y * s4;
    const double x4_z = x3_z * c4 + y3_z * s4;
    const double v14 = y3_x * c4 - x3_x * s4;
    const double v15 = y3_y * c4 - x3_y * s4;
    const double v16 = y3_z * c4 - x3_z * s4;
    const double y4_x = v14 * ca4 + z3_x * sa4;
    const double y4_y = v15 * ca4 + z3_y * sa4;
    const double y4_z = v16 * ca4 + z3_z * sa4;
    const double z4_x = z3_x * ca4 - v14 * sa4;
    const double z4_y = z3_y * ca4 - v15 * sa4;
    const double z4_z = z3_z * ca4 - v16 * sa4;
    const double v17 = q[4] + offset5;
    const double c5 = cos(v17);
    const double s5 = sin(v17);
    const double x5_x = x4_x * c5 + y4_x * s5;
    const double x5_y = x4_y * c5 + y4_y * s5;
    const double x5_z = x4_z * c5 + y4_z * s5;
    const double v18 = y4_x * c5 - x4_x * s5;
    const double v19 = y4_y * c5 - x4_y * s5;
    const double v20 = y4_z * c5 - x4_z * s5;
    const double y5_x = v18 * ca5 - z4_x * sa5;
    const double y5_y = v19 * ca5 - z4_y * sa5;
    const double y5_z = v20 * ca5 - z4_z * sa5;
    const double z5_x = v18 * sa5 + z4_x * ca5;
    const double z5_y = v19 * sa5 + z4_y * ca5;
    const double z5_z = v20 * sa5 + z4_z * ca5;
    const double v21 = q[5] + offset6;
    const double c6 = cos(v21);
    const double s6 = sin(v21);
    const double T11_ = x5_x * c6 + y5_x * s6;
    const double T21_ = x5_y * c6 + y5_y * s6;
    const double T31_ = x5_z * c6 + y5_z * s6;
    const double v22 = y5_x * c6 - x5_x * s6;
    const double v23 = y5_y * c6 - x5_y * s6;
    const double v24 = y5_z * c6 - x5_z * s6;
    const double T14_ = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x *
        d4 + x5_x * a5 + z4_x * d5 + T11_ * a6 + z5_x * d6;
    const double T24_ = s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 - v8 * d3 + x4_y * a4 + z3_y * d4
        + x5_y * a5 + z4_y * d5 + T21_ * a6 + z5_y * d6;
    const double T34_ = d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z *
        a5 + z4_z * d5 + T31_ * a6 + z5_z * d6;
    const double T12_ = v22 * ca6 - z5_x * sa6;
    const double T22_ = v23 * ca6 - z5_y * sa6;
    const double T32_ = v24 * ca6 - z5_z * sa6;
    const double T13_ = v22 * sa6 + z5_x * ca6;
    const double T23_ = v23 * sa6 + z5_y * ca6;
    const double T33_ = v24 * sa6 + z5_z * ca6;
    T[0] = T11_; T[1] = T12_; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void puma560_calibrated_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1);
    const double s1 = sin(v1);
    const double p1_x = c1 * a1;
    const double p1_y = s1 * a1;
    const double v2 = s1 * ca1;
    const double y1_y = c1 * ca1;
    const double J42 = s1 * sa1;
    const double v3 = c1 * sa1;
    const double v4 = q[1] + offset2;
    const double c2 = cos(v4);
    const double s2 = sin(v4);
    const double x2_x = c1 * c2 - v2 * s2;
    const double x2_y = s1 * c2 + y1_y * s2;
    const double x2_z = sa1 * s2;
    const double v5 = v2 * c2 + c1 * s2;
    const double v6 = y1_y * c2 - s1 * s2;
    const double v7 = sa1 * c2;
    const double p2_x = p1_x + x2_x * a2 + J42 * d2;
    const double p2_y = p1_y + x2_y * a2 - v3 * d2;
    const double p2_z = d1 + x2_z * a2 + g1;
    const double y2_x = J42 * sa2 - v5 * ca2;
    const double y2_y = v6 * ca2 - v3 * sa2;
    const double y2_z = v7 * ca2 + g2;
    const double J43 = v5 * sa2 + J42 * ca2;
    const double v8 = v6 * sa2 + v3 * ca2;
    const double J63 = g3 - v7 * sa2;
    const double v9 = q[2] + offset3;
    const double c3 = cos(v9);
    const double s3 = sin(v9);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 + y2_y * s3;
    const double x3_z = x2_z * c3 + y2_z * s3;
    const double v10 = y2_x * c3 - x2_x * s3;
    const double v11 = y2_y * c3 - x2_y * s3;
    const double v12 = y2_z * c3 - x2_z * s3;
    const double p3_x = p2_x + x3_x * a3 + J43 * d3;
    const double p3_y = p2_y + x3_y * a3 - v8 * d3;
    const double p3_z = p2_z + x3_z * a3 + J63 * d3;
    const double y3_x = v10 * ca3 - J43 * sa3;
    const double y3_y = v11 * ca3 + v8 * sa3;
    const double y3_z = v12 * ca3 - J63 * sa3;
    const double J44 = v10 * sa3 + J43 * ca3;
    const double J54 = v11 * sa3 - v8 * ca3;
    const double J64 = v12 * sa3 + J63 * ca3;
    const double v13 = q[3] + offset4;
    const double c4 = cos(v13);
    const double s4 = sin(v13);
    const double x4_x = x3_x * c4 + y3_x * s4;
    const double x4_y = x3_y * c4 + y3_y * s4;
    const double x4_z = x3_z * c4 + y3_z * s4;
    const double v14 = y3_x * c4 - x3_x * s4;
    const double v15 = y3_y * c4 - x3_y * s4;
    const double v16 = y3_z * c4 - x3_z * s4;
    const double p4_x = p3_x + x4_x * a4 + J44 * d4;
    const double p4_y = p3_y + x4_y * a4 + J54 * d4;
    const double p4_z = p3_z + x4_z * a4 + J64 * d4;
    const double y4_x = v14 * ca4 + J44 * sa4;
    const double y4_y = v15 * ca4 + J54 * sa4;
    const double y4_z = v16 * ca4 + J64 * sa4;
    const double J45 = J44 * ca4 - v14 * sa4;
    const double J55 = J54 * ca4 - v15 * sa4;
    const double J65 = J64 * ca4 - v16 * sa4;
    const double v17 = q[4] + offset5;
    const double c5 = cos(v17);
    const double s5 = sin(v17);
    const double x5_x = x4_x * c5 + y4_x * s5;
    const double x5_y = x4_y * c5 + y4_y * s5;
    const double x5_z = x4_z * c5 + y4_z * s5;
    const double v18 = y4_x * c5 - x4_x * s5;
    const double v19 = y4_y * c5 - x4_y * s5;
    const double v20 = y4_z * c5 - x4_z * s5;
    const double p5_x = p4_x + x5_x * a5 + J45 * d5;
    const double p5_y = p4_y + x5_y * a5 + J55 * d5;
    const double p5_z = p4_z + x5_z * a5 + J65 * d5;
    const double J46 = v18 * sa5 + J45 * ca5;
    const double J56 = v19 * sa5 + J55 * ca5;
    const double J66 = v20 * sa5 + J65 * ca5;
    const double v21 = q[5] + offset6;
    const double c6 = cos(v21);
    const double s6 = sin(v21);
    const double J21 = p5_x + (x5_x * c6 + (v18 * ca5 - J45 * sa5) * s6) * a6 + J46 * d6;
    const double p6_y = p5_y + (x5_y * c6 + (v19 * ca5 - J55 * sa5) * s6) * a6 + J56 * d6;
    const double p6_z = p5_z + (x5_z * c6 + (v20 * ca5 - J65 * sa5) * s6) * a6 + J66 * d6;
    const double v22 = J21 - p1_x;
    const double v23 = p6_y - p1_y;
    const double v24 = p6_z - d1;
    const double J22 = ca1 * v22 - J42 * v24;
    const double J32 = J42 * v23 + v3 * v22;
    const double v25 = J21 - p2_x;
    const double v26 = p6_y - p2_y;
    const double v27 = p6_z - p2_z;
    const double J23 = J63 * v25 - J43 * v27;
    const double J33 = J43 * v26 + v8 * v25;
    const double v28 = J21 - p3_x;
    const double v29 = p6_y - p3_y;
    const double v30 = p6_z - p3_z;
    const double J14 = J54 * v30 - J64 * v29;
    const double J24 = J64 * v28 - J44 * v30;
    const double J34 = J44 * v29 - J54 * v28;
    const double v31 = J21 - p4_x;
    const double v32 = p6_y - p4_y;
    const double v33 = p6_z - p4_z;
    const double J15 = J55 * v33 - J65 * v32;
    const double J25 = J65 * v31 - J45 * v33;
    const double J35 = J45 * v32 - J55 * v31;
    const double v34 = J21 - p5_x;
    const double v35 = p6_y - p5_y;
    const double v36 = p6_z - p5_z;
    const double J16 = J56 * v36 - J66 * v35;
    const double J26 = J66 * v34 - J46 * v36;
    const double J36 = J46 * v35 - J56 * v34;
    J[0] = -p6_y; J[1] = -(v3 * v24 + ca1 * v23); J[2] = -(v8 * v27 + J63 * v26); J[3] = J14;
    J[4] = J15; J[5] = J16;
    J[6] = J21; J[7] = J22; J[8] = J23; J[9] = J24; J[10] = J25; J[11] = J26;
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = J35; J[17] = J36;
    J[18] = 0.0; J[19] = J42; J[20] = J43; J[21] = J44; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = -v3; J[26] = -v8; J[27] = J54; J[28] = J55; J[29] = J56;
    J[30] = 1.0; J[31] = ca1; J[32] = J63; J[33] = J64; J[34] = J65; J[35] = J66;
}

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
static double misfit(const double T[16])
{
    const double *x = T, *y = T + 4, *z = T + 8;
    const double xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0;
    const double yy = y[0] * y[0] + y[1] * y[1] + y[2] * y[2] - 1.0;
    const double xy = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    const double z0 = x[1] * y[2] - x[2] * y[1] - z[0];
    const double z1 = x[2] * y[0] - x[0] * y[2] - z[1];
    const double z2 = x[0] * y[1] - x[1] * y[0] - z[2];
    return xx * xx + yy * yy + 2.0 * xy * xy + z0 * z0 + z1 * z1 + z2 * z2;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(double T[16])
{
    double R[9], G[9];
    for (int i = 0; i < 9; i++)
        R[i] = T[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[3 * i + j] = (i == j ? 1.5 : 0.0)
                - 0.5 * (R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[4 * i + j] = R[3 * i] * G[j] + R[3 * i + 1] * G[3 + j] + R[3 * i + 2] * G[6 + j];
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    if (!(fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= 1e-09))
        return 0;
    const double miss = misfit(T);
    if (!(miss <= 1e-09))
        return 0;
    if (miss > 1e-24) {
        straighten(T);
        straighten(T);
    }
    return 1;
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
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = q3;
        q[row][3] = q4;
        q[row][4] = q5;
        q[row][5] = q6;
        status[row] = (chosen) ? PUMA560_CALIBRATED_FREE_JOINT : PUMA560_CALIBRATED_OK;
    }
}

/* A joint value moved by whole turns, near to another value but inside its limits. */
static double turned(int joint, double given, double towards)
{
    const double low = lowest[joint] - 1e-09;
    const double high = highest[joint] + 1e-09;
    double value = given;
    value += turn * floor((towards - value) / turn + 0.5);
    if (value > high)
        value -= turn * ceil((value - high) / turn);
    if (value < low)
        value += turn * ceil((low - value) / turn);
    return value <= high ? value : given;
}

static int inside(int joint, double value)
{
    return lowest[joint] - 1e-09 <= value && value <= highest[joint] + 1e-09;
}

int puma560_calibrated_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    const int valid = read_pose(T, pose);
    for (int row = 0; row < 16; row++) {
        status[row] = valid ? PUMA560_CALIBRATED_UNREACHABLE : PUMA560_CALIBRATED_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -PUMA560_CALIBRATED_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 16; row++) {
        if (status[row] == PUMA560_CALIBRATED_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = PUMA560_CALIBRATED_OUT_OF_LIMITS;
        }
        count += status[row] != PUMA560_CALIBRATED_OUT_OF_LIMITS;
    }
    return count;
}

int puma560_calibrated_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -PUMA560_CALIBRATED_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    for (int i = 0; i < 6; i++)
        if (!isfinite(q_seed[i]))
            return -PUMA560_CALIBRATED_INVALID_POSE;
    if (puma560_calibrated_ik(T, q_seed, all, status) < 0)
        return -PUMA560_CALIBRATED_INVALID_POSE;
    for (int row = 0; row < 16; row++) {
        double distance = 0.0;
        if (status[row] == PUMA560_CALIBRATED_OUT_OF_LIMITS && result < 0)
            result = -PUMA560_CALIBRATED_OUT_OF_LIMITS;
        if (status[row] != PUMA560_CALIBRATED_OK && status[row] != PUMA560_CALIBRATED_FREE_JOINT)
            continue;
        for (int i = 0; i < 6; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 6; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void puma560_calibrated_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)puma560_calibrated_ik(
            T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
