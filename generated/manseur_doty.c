/* manseur_doty: Arm with 16 real solutions
 *
 * Inverse kinematics, generated from robots/manseur_doty.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/manseur_doty.yaml. The formulas and where they come from:
 * manseur_doty.md.
 */
#include "manseur_doty.h"

#include <math.h>

static const double turn = 6.283185307179586;

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size; between which values starts lie, and what is added
 * from start to start. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double part[6] = {
    0.3333333333333333, 0.3333333333333333, 0.3333333333333333, 0.3333333333333333,
    0.3333333333333333, 0.3333333333333333,
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
    manseur_doty_fk(d->q, P);
    manseur_doty_jacobian(d->q, J);
    d->e[0] = (d->T[3] - P[3]) / 3.0;
    for (int j = 0; j < 6; j++)
        d->A[0][j] = part[j] * J[0 + solved[j]];
    d->e[1] = (d->T[7] - P[7]) / 3.0;
    for (int j = 0; j < 6; j++)
        d->A[1][j] = part[j] * J[6 + solved[j]];
    d->e[2] = (d->T[11] - P[11]) / 3.0;
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
 * below that has the type manseur_doty_lane does MANSEUR_DOTY_LANES angles or candidates at once.
 */
/* Lanes: GNU vectors where the compiler has them, plain doubles otherwise. Vectors wider than the
 * machine's are slow: compile for the machine, or set MANSEUR_DOTY_LANES to 1, 2, 4 or 8. */
#ifndef MANSEUR_DOTY_LANES
#if defined(__GNUC__) && defined(__AVX512F__)
#define MANSEUR_DOTY_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define MANSEUR_DOTY_LANES 4
#elif defined(__GNUC__) && defined(__SSE2__)
#define MANSEUR_DOTY_LANES 2
#else
#define MANSEUR_DOTY_LANES 1
#endif
#endif

#define MANSEUR_DOTY_ROOTS 24
#define MANSEUR_DOTY_CANDIDATES 96

#if MANSEUR_DOTY_LANES > 1
typedef double manseur_doty_lane __attribute__((vector_size(8 * MANSEUR_DOTY_LANES)));
typedef long long manseur_doty_mask __attribute__((vector_size(8 * MANSEUR_DOTY_LANES)));
/* the same where it lies between other doubles */
typedef double manseur_doty_packed
    __attribute__((vector_size(8 * MANSEUR_DOTY_LANES), aligned(8), may_alias));
#define MANSEUR_DOTY_LOAD(from) (manseur_doty_lane)(*(const manseur_doty_packed *)(from))
#define MANSEUR_DOTY_STORE(to, x) (*(manseur_doty_packed *)(to) = (manseur_doty_packed)(x))

static inline manseur_doty_lane manseur_doty_select(manseur_doty_mask m, manseur_doty_lane a,
    manseur_doty_lane b)
{
    return (manseur_doty_lane)((m & (manseur_doty_mask)a) | (~m & (manseur_doty_mask)b));
}

static inline manseur_doty_lane manseur_doty_abs(manseur_doty_lane x)
{
    return (manseur_doty_lane)((manseur_doty_mask)x & 0x7fffffffffffffffLL);
}

/* the magnitude of the first with the sign of the second */
static inline manseur_doty_lane manseur_doty_with_sign(manseur_doty_lane x, manseur_doty_lane y)
{
    const manseur_doty_mask sign = (manseur_doty_mask)y & (-0x7fffffffffffffffLL - 1);
    return (manseur_doty_lane)(((manseur_doty_mask)x & 0x7fffffffffffffffLL) | sign);
}

static inline manseur_doty_lane manseur_doty_sqrt(manseur_doty_lane x)
{
    manseur_doty_lane r;
    for (int k = 0; k < MANSEUR_DOTY_LANES; k++) {
        r[k] = sqrt(x[k]);
    }
    return r;
}
#else
typedef double manseur_doty_lane;
typedef int manseur_doty_mask;
#define MANSEUR_DOTY_LOAD(from) (*(from))
#define MANSEUR_DOTY_STORE(to, x) (*(to) = (x))

static inline manseur_doty_lane manseur_doty_select(manseur_doty_mask m, manseur_doty_lane a,
    manseur_doty_lane b)
{
    return m ? a : b;
}

static inline manseur_doty_lane manseur_doty_abs(manseur_doty_lane x)
{
    return fabs(x);
}

static inline manseur_doty_lane manseur_doty_with_sign(manseur_doty_lane x, manseur_doty_lane y)
{
    return copysign(x, y);
}

static inline manseur_doty_lane manseur_doty_sqrt(manseur_doty_lane x)
{
    return sqrt(x);
}
#endif

static inline manseur_doty_lane manseur_doty_all(double x)
{
    const manseur_doty_lane zero = {0};
    return zero + x;
}

static inline manseur_doty_lane manseur_doty_max(manseur_doty_lane a, manseur_doty_lane b)
{
    return manseur_doty_select(a > b, a, b);
}

static inline manseur_doty_lane manseur_doty_min(manseur_doty_lane a, manseur_doty_lane b)
{
    return manseur_doty_select(a < b, a, b);
}

/* the largest of all lanes */
static inline double manseur_doty_largest(manseur_doty_lane x)
{
    double each[MANSEUR_DOTY_LANES], most;
    MANSEUR_DOTY_STORE(each, x);
    most = each[0];
    for (int k = 1; k < MANSEUR_DOTY_LANES; k++) {
        most = each[k] > most ? each[k] : most;
    }
    return most;
}

/* The angle of a sine and a cosine with any positive common factor, in (-pi, pi], within 3 ulp:
 * atan of a ratio below tan(pi/8) by a polynomial. */
static inline manseur_doty_lane manseur_doty_angle(manseur_doty_lane y, manseur_doty_lane x)
{
    static const double odd[] = { -0.3333333333333333, 0.19999999999995513, -0.14285714284665177,
        0.11111111015146682, -0.0909090457366891, 0.07692183087347286, -0.0666450998991572,
        0.05858136252639731, -0.050853834915688644, 0.039229744582632814, -0.01917454359469326 };
    const manseur_doty_lane ax = manseur_doty_abs(x), ay = manseur_doty_abs(y), zero = {0};
    const manseur_doty_mask steep = ay > ax;
    const manseur_doty_lane high = manseur_doty_select(steep, ay, ax), low =
        manseur_doty_select(steep, ax, ay);
    const manseur_doty_mask turned = low > high * 0.41421356237309515;
    const manseur_doty_lane up = manseur_doty_select(turned, low - high, low);
    const manseur_doty_lane down = manseur_doty_select(turned, low + high, high);
    const manseur_doty_lane r = up / (down + 1e-300), u = r * r;
    manseur_doty_lane a = manseur_doty_all(odd[10]);
    for (int k = 9; k >= 0; k--) {
        a = a * u + odd[k];
    }
    a = r + r * u * a + manseur_doty_select(turned, zero + 0.7853981633974483, zero);
    a = manseur_doty_select(steep, 1.5707963267948966 - a, a);
    a = manseur_doty_select(x < 0.0, 3.141592653589793 - a, a);
    return manseur_doty_with_sign(a, y + 0.0);
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
} manseur_doty_formulation;

static const double manseur_doty_left[12] = {
    1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.0
};

static const double manseur_doty_right[12] = {
    1.0, 0.0, 0.0, -0.0, 0.0, 0.9998476951563913, 0.01745240643728351, -0.0, 0.0,
        -0.01745240643728351, 0.9998476951563913, -0.0
};

static const double manseur_doty_link[5][12] = {
    { 1.0, 0.0, 0.0, 0.20860741921300402, 0.0, 0.0, -1.0, -0.046345438382874284, 0.0, 1.0, 0.0, 0.0
        },
    { 1.0, 0.0, 0.0, 0.6953580640433468, 0.0, 0.9998476951563913, -0.01745240643728351,
        -0.0016179252730085187, 0.0, 0.01745240643728351, 0.9998476951563913, 0.046345438429219725
        },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.04636661657662248 },
    { 1.0, 0.0, 0.0, 1.0430370960650202, 0.0, 0.9998476951563913, -0.01745240643728351, 0.0, 0.0,
        0.01745240643728351, 0.9998476951563913, 0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0 },
};

/* poses close by, for those at which the formulations fail */
static const double manseur_doty_nudge[10][12] = {
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

static const double manseur_doty_table_1[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, -0.046345438382874284, 0.0456649550096108, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -0.20860741921300402, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, -0.0, 0.0, 0.0, -0.0, -0.20860741921300402, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0,
        0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.20860741921300402, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.019336004586693406, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.046345438382874284, 0.0, -0.041369155691809205, 0.0, 0.0, -0.0, 1.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0, 0.046345438382874284, 0.0, 0.0, -0.0, -0.041369155691809205, 0.0, 0.0, 0.0, -1.0,
        0.0, 0.0, 0.0, 0.0, 0.046345438382874284, 0.0, 0.0, 0.0, 0.0, 0.0, -0.041369155691809205,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.20860741921300402, 0.0,
        0.019336004586693406, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
        0.20860741921300402, 0.0, 0.0, -0.0, 0.019336004586693406, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.046345438382874284, 0.0,
        0.0, 0.0, 0.0, 0.0, -0.041369155691809205, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.20860741921300402, 0.0, 0.019336004586693406, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0, 0.20860741921300402, 0.0, 0.0, -0.0, 0.019336004586693406, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.20860741921300402, 0.0, 0.0, 0.0, 0.0, 0.0, 0.019336004586693406,
        -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.046345438382874284, 0.0,
        0.041369155691809205, 0.0, 0.0, -0.0, -1.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
        -0.046345438382874284, 0.0, 0.0, -0.0, 0.041369155691809205, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.20860741921300402, 0.0, 0.0, 0.0, 0.0, 1.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.046345438382874284, 0.0, 0.0, 0.0, 0.0456649550096108, 0.0,
        -1.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.046345438382874284, 0.0,
        -0.0456649550096108, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0,
        0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0,
        0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.41721483842600804, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, -0.0, 1.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, -1.0, 0.09269087676574857, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.09269087676574857, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.41721483842600804, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, -1.0, 0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.09269087676574857, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.41721483842600804, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.41721483842600804, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.09269087676574857, 0.0,
        -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 1.0, 0.0, -0.09269087676574857, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.41721483842600804, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.41721483842600804, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.41721483842600804, 0.0,
        -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.41721483842600804, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -0.09269087676574857, 0.0, -0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, 0.0, 0.0, -0.0, -1.0, 0.0, 0.09269087676574857, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.41721483842600804, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -0.09269087676574857, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, -0.0, -0.09269087676574857, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -1.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, -1.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, -0.0, 0.0, 0.0,
        0.0, 0.0,
};

static const double manseur_doty_left_1[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.9996953903127825, 0.0, -2.0, 0.0, 2.0, 0.0,
        1.9996953903127825, 0.0, 0.01745240643728351, 0.0, 0.01745240643728351, 0.0, 0.0, 0.0,
        -0.01745240643728351, 0.0, -0.01745240643728351, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.017449748351250485, 0.0, -0.017449748351250485, 0.0, -0.06980962574913405, 0.0,
        -0.017449748351250485, 0.0, 0.017449748351250485, -0.017449748351250485, 0.0,
        -0.017449748351250485, 0.0, 0.0, 0.0, 0.017449748351250485, 0.0, 0.017449748351250485, 0.0,
        -1.9993908270190959, 0.0, -1.9996953903127825, 0.0, 1.9996953903127825, 0.0,
        1.9993908270190959, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.9996954135095479, 0.0, 0.9996954135095479, 0.0, 3.999390780625565, 0.0, 0.9996954135095479,
        0.0, -0.9996954135095479, -0.00030458649045213493, 0.0, -0.00030458649045213493, 0.0, 0.0,
        0.0, 0.00030458649045213493, 0.0, 0.00030458649045213493, 0.0, -0.03489949670250097, 0.0,
        -0.03490481287456702, 0.0, 0.03490481287456702, 0.0, 0.03489949670250097, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
    0.6953580640433468, 0.0, 0.6953580640433468, 0.0, 0.0, 0.0, 0.6953580640433468, 0.0,
        0.6953580640433468, -1.0430370960650202, 0.0, 1.0430370960650202, 0.0, 0.0, 0.0,
        -1.0430370960650202, 0.0, 1.0430370960650202, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -0.0024271343106254213, -0.036407014659381315, -0.0024271343106254213, 0.0, 0.0, 0.0,
        -0.0024271343106254213, -0.036407014659381315, -0.0024271343106254213, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -1.0428782364632259, 0.0, 1.0428782364632259, 0.0, 0.0, 0.0,
        -1.0428782364632259, 0.0, 1.0428782364632259, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.09270499314555583, 2.0857564729264517, 0.09270499314555583, 0.0, 0.0, 0.0,
        0.09270499314555583, 2.0857564729264517, 0.09270499314555583, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.018203507329690657, 0.0, 0.018203507329690657, 0.0, 0.0, 0.0,
        -0.018203507329690657, 0.0, 0.018203507329690657, 0.0, 0.0, 0.0, 0.0, 0.0,
    1.5800493277329404, 0.38689680848074526, 1.5800493277329404, 0.0, 0.0, 0.0, 1.5800493277329404,
        0.38689680848074526, 1.5800493277329404, -1.4505685116903335, 0.0, 1.4505685116903335, 0.0,
        0.0, 0.0, -1.4505685116903335, 0.0, 1.4505685116903335, 0.0016872990546007575, 0.0,
        -0.0016872990546007575, 0.0, 0.0, 0.0, 0.0016872990546007575, 0.0, -0.0016872990546007575,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -0.09271910933998134, 0.0, 0.09271910933998134, 2.0860741921300403, 0.37093293224215984,
        2.0860741921300403, 0.09271910933998134, 0.0, -0.09271910933998134, 1.4116194425505347e-05,
        -1.390504315284301, 1.4116194425505347e-05, -1.3907161280866935, 0.0, 1.3907161280866935,
        -1.4116194425505347e-05, 1.390504315284301, -1.4116194425505347e-05, 0.012135671553127106,
        0.001617432474019083, 0.012135671553127106, 0.0016176788543440029, 0.0,
        -0.0016176788543440029, -0.012135671553127106, -0.001617432474019083, -0.012135671553127106,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0008087162370095415, 0.0, -0.0008087162370095415, 0.0, -0.0032353577086880058, 0.0,
        -0.0008087162370095415, 0.0, 0.0008087162370095415, 0.0016184180736158798,
        0.036407014659381315, 0.0016184180736158798, 0.0, 0.0, 0.0, -0.0016184180736158798,
        -0.036407014659381315, -0.0016184180736158798, 1.0428782364632259, 0.18543821867996269,
        1.0428782364632259, 0.18546646612107992, 0.0, -0.18546646612107992, -1.0428782364632259,
        -0.18543821867996269, -1.0428782364632259, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.6948285723625104, 0.0, -0.6948285723625104, 0.0, -2.781008630568602, 0.0, -0.6948285723625104,
        0.0, 0.6948285723625104, -1.0425076043841839, -0.1853817474521461, -1.0425076043841839,
        -0.18540998629111166, 0.0, 0.18540998629111166, 1.0425076043841839, 0.1853817474521461,
        1.0425076043841839, 0.0016179252191418224, 0.0606691161578456, 0.0016179252191418224,
        0.02427134310625421, 0.0, -0.02427134310625421, -0.0016179252191418224, -0.0606691161578456,
        -0.0016179252191418224, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0303345580789228, 0.0, -0.0303345580789228, 0.0, -0.04854268621250842, 0.0,
        -0.0303345580789228, 0.0, 0.0303345580789228, -0.030334558078922796, -0.004853529292627648,
        -0.030334558078922796, -0.0048542686212508426, 0.0, 0.0048542686212508426,
        0.030334558078922796, 0.004853529292627648, 0.030334558078922796, 4.235933446691078e-05,
        -1.3896571447250208, 4.235933446691078e-05, -1.390504315284301, 0.0, 1.390504315284301,
        -4.235933446691078e-05, 1.3896571447250208, -4.235933446691078e-05, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.12897540816982778, 0.0, -0.12897540816982778, -2.901137023380667, -0.5158624113076604,
        -2.901137023380667, -0.12897540816982778, 0.0, 0.12897540816982778, -0.1934385727306732,
        -1.22582057969435, -0.1934385727306732, 3.1256982285255637, 0.0, -3.1256982285255637,
        0.1934385727306732, 1.22582057969435, 0.1934385727306732, 0.010698388904455099,
        0.004502890923184304, 0.010698388904455099, -0.00224973207280101, 0.0, 0.00224973207280101,
        -0.010698388904455099, -0.004502890923184304, -0.010698388904455099, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.052433435183687184, 0.0, -0.052433435183687184, 0.010126364492458056, 0.04339342324623507,
        0.010126364492458056, -0.052433435183687184, 0.0, 0.052433435183687184,
        -0.05288345012294693, -0.013500105554294664, -0.05288345012294693, -0.006750909661638704,
        0.0, 0.006750909661638704, 0.05288345012294693, 0.013500105554294664, 0.05288345012294693,
        -0.1933011297163273, -3.158244633510953, -0.1933011297163273, 1.1914332447533793, 0.0,
        -1.1914332447533793, 0.1933011297163273, 3.158244633510953, 0.1933011297163273, 0.0, 0.0,
        0.0, 0.0, 0.0,
    -1.561935193689679, 0.0, 1.561935193689679, -0.38677898736507266, -2.4516254540932954,
        -0.38677898736507266, 1.561935193689679, 0.0, -1.561935193689679, 1.449642809155307,
        0.2576366566057394, 1.449642809155307, 0.25785265824338177, 0.0, -0.25785265824338177,
        -1.449642809155307, -0.2576366566057394, -1.449642809155307, -0.007312485795347584,
        -0.10606692542632784, -0.007312485795347584, 0.020496473762124358, 0.0,
        -0.020496473762124358, 0.007312485795347584, 0.10606692542632784, 0.007312485795347584, 0.0,
        0.0, 0.0, 0.0, 0.0,
};

static const double manseur_doty_table_2[] = {
    -0.5465467864164482, 0.0, -0.5465467864164482, 0.16531728798979636, 0.0, 0.16531728798979636,
        -0.5465467864164482, 0.0, -0.5465467864164482, 0.1390979702340159, 0.0, 0.1390979702340159,
        -2.086043303458515, 0.0, -2.086043303458515, 0.1390979702340159, 0.0, 0.1390979702340159,
        0.22747155768593263, 0.0, 0.22747155768593263, -0.06715081336336311, 0.0,
        -0.06715081336336311, 0.22747155768593263, 0.0, 0.22747155768593263, -0.0018236072181007654,
        0.0, -0.0018236072181007654, 0.004915335723794579, 0.0, 0.004915335723794579,
        -0.0018236072181007654, 0.0, -0.0018236072181007654, -0.0007783053226145743, 0.0,
        -0.0007783053226145743, -0.005473901141588409, 0.0, -0.005473901141588409,
        -0.0007783053226145743, 0.0, -0.0007783053226145743, 0.005210271688760573, 0.0,
        0.005210271688760573, 8.49337536154124e-05, 0.0, 8.49337536154124e-05, 0.005210271688760573,
        0.0, 0.005210271688760573, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0015139941089176337, -0.002421437711436514, 0.0015139941089176337, 0.0067919053705344686,
        0.0, -0.0067919053705344686, -0.0015139941089176337, 0.002421437711436514,
        0.0015139941089176337, -0.00032130839536084684, 0.0028448922385006063,
        0.00032130839536084684, -0.006153511437045444, 0.0, 0.006153511437045444,
        -0.00032130839536084684, -0.0028448922385006063, 0.00032130839536084684, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.28664554346278354, 1.0386035615388982, -0.28664554346278354,
        -2.5977618655922803, 0.0, 2.5977618655922803, 0.28664554346278354, -1.0386035615388982,
        -0.28664554346278354, 0.3341187315792694, -0.2246640372147663, -0.3341187315792694,
        0.2174754295876255, 0.0, -0.2174754295876255, 0.3341187315792694, 0.2246640372147663,
        -0.3341187315792694, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.113317623637811e-05,
        0.0, 2.113317623637811e-05, 0.0, 0.0, 0.0, -2.113317623637811e-05, 0.0,
        -2.113317623637811e-05, -2.4828889368405178e-05, 0.0, -2.4828889368405178e-05, 0.0, 0.0,
        0.0, 2.4828889368405178e-05, 0.0, 2.4828889368405178e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, -0.009064446300669746, 0.0, -0.009064446300669746, 0.0, 0.0, 0.0,
        0.009064446300669746, 0.0, 0.009064446300669746, 0.001960762678309621, 0.0,
        0.001960762678309621, 0.0, 0.0, 0.0, -0.001960762678309621, 0.0, -0.001960762678309621, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -2.113317623637811e-05, 0.0, -2.113317623637811e-05, 0.0, 0.0, 0.0, 2.113317623637811e-05,
        0.0, 2.113317623637811e-05, 2.4828889368405178e-05, 0.0, 2.4828889368405178e-05, 0.0, 0.0,
        0.0, -2.4828889368405178e-05, 0.0, -2.4828889368405178e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.009064446300669746, 0.0, 0.009064446300669746, 0.0, 0.0, 0.0,
        -0.009064446300669746, 0.0, -0.009064446300669746, -0.001960762678309621, 0.0,
        -0.001960762678309621, 0.0, 0.0, 0.0, 0.001960762678309621, 0.0, 0.001960762678309621, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0015139941089176337, -0.002421437711436514,
        0.0015139941089176337, 0.0067919053705344686, 0.0, -0.0067919053705344686,
        -0.0015139941089176337, 0.002421437711436514, 0.0015139941089176337,
        -0.00032130839536084684, 0.0028448922385006063, 0.00032130839536084684,
        -0.006153511437045444, 0.0, 0.006153511437045444, -0.00032130839536084684,
        -0.0028448922385006063, 0.00032130839536084684, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.28664554346278354, 1.0386035615388982, -0.28664554346278354, -2.5977618655922803, 0.0,
        2.5977618655922803, 0.28664554346278354, -1.0386035615388982, -0.28664554346278354,
        0.3341187315792694, -0.2246640372147663, -0.3341187315792694, 0.2174754295876255, 0.0,
        -0.2174754295876255, 0.3341187315792694, 0.2246640372147663, -0.3341187315792694, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.001210718855718257, -0.0030279882178352673, -0.001210718855718257, 0.0, 0.013583810741068937,
        0.0, -0.001210718855718257, -0.0030279882178352673, 0.001210718855718257,
        -0.0014224461192503032, -0.0006426167907216937, 0.0014224461192503032, 0.0,
        -0.012307022874090887, 0.0, 0.0014224461192503032, -0.0006426167907216937,
        -0.0014224461192503032, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5193017807694491,
        0.5732910869255671, 0.5193017807694491, 0.0, -5.195523731184561, 0.0, 0.5193017807694491,
        0.5732910869255671, -0.5193017807694491, 0.11233201860738315, 0.6682374631585388,
        -0.11233201860738315, 0.0, 0.434950859175251, 0.0, -0.11233201860738315, 0.6682374631585388,
        0.11233201860738315, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
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
        0.00032130839536084624, -0.0028448922385006107, -0.00032130839536084624,
        0.006153511437045452, 0.0, -0.006153511437045452, 0.00032130839536084624,
        0.0028448922385006107, -0.00032130839536084624, -0.001513994108917632,
        -0.002421437711436511, 0.001513994108917632, 0.006791905370534463, 0.0,
        -0.006791905370534463, -0.001513994108917632, 0.002421437711436511, 0.001513994108917632,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.3341187315792695, 0.22466403721476633,
        0.3341187315792695, -0.21747542958762553, 0.0, 0.21747542958762553, -0.3341187315792695,
        -0.22466403721476633, 0.3341187315792695, 0.2866455434627834, 1.038603561538898,
        -0.2866455434627834, -2.5977618655922807, 0.0, 2.5977618655922807, 0.2866455434627834,
        -1.038603561538898, -0.2866455434627834, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        2.482888936840521e-05, 0.0, 2.482888936840521e-05, 0.0, 0.0, 0.0, -2.482888936840521e-05,
        0.0, -2.482888936840521e-05, 2.1133176236312693e-05, 0.0, 2.1133176236312693e-05, 0.0, 0.0,
        0.0, -2.1133176236312693e-05, 0.0, -2.1133176236312693e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, -0.001960762678309618, 0.0, -0.001960762678309618, 0.0, 0.0, 0.0,
        0.001960762678309618, 0.0, 0.001960762678309618, -0.009064446300669746, 0.0,
        -0.009064446300669746, 0.0, 0.0, 0.0, 0.009064446300669746, 0.0, 0.009064446300669746, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -2.482888936840521e-05, 0.0, -2.482888936840521e-05, 0.0, 0.0, 0.0, 2.482888936840521e-05,
        0.0, 2.482888936840521e-05, -2.1133176236312693e-05, 0.0, -2.1133176236312693e-05, 0.0, 0.0,
        0.0, 2.1133176236312693e-05, 0.0, 2.1133176236312693e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.001960762678309618, 0.0, 0.001960762678309618, 0.0, 0.0, 0.0,
        -0.001960762678309618, 0.0, -0.001960762678309618, 0.009064446300669746, 0.0,
        0.009064446300669746, 0.0, 0.0, 0.0, -0.009064446300669746, 0.0, -0.009064446300669746, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.00032130839536084624, -0.0028448922385006107,
        -0.00032130839536084624, 0.006153511437045452, 0.0, -0.006153511437045452,
        0.00032130839536084624, 0.0028448922385006107, -0.00032130839536084624,
        -0.001513994108917632, -0.002421437711436511, 0.001513994108917632, 0.006791905370534463,
        0.0, -0.006791905370534463, -0.001513994108917632, 0.002421437711436511,
        0.001513994108917632, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.3341187315792695,
        0.22466403721476633, 0.3341187315792695, -0.21747542958762553, 0.0, 0.21747542958762553,
        -0.3341187315792695, -0.22466403721476633, 0.3341187315792695, 0.2866455434627834,
        1.038603561538898, -0.2866455434627834, -2.5977618655922807, 0.0, 2.5977618655922807,
        0.2866455434627834, -1.038603561538898, -0.2866455434627834, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0014224461192503053, 0.0006426167907216925, -0.0014224461192503053, 0.0, 0.012307022874090905,
        0.0, -0.0014224461192503053, 0.0006426167907216925, 0.0014224461192503053,
        0.0012107188557182555, -0.003027988217835264, -0.0012107188557182555, 0.0,
        0.013583810741068927, 0.0, -0.0012107188557182555, -0.003027988217835264,
        0.0012107188557182555, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.11233201860738316,
        -0.668237463158539, 0.11233201860738316, 0.0, -0.43495085917525106, 0.0,
        0.11233201860738316, -0.668237463158539, -0.11233201860738316, -0.519301780769449,
        0.5732910869255669, 0.519301780769449, 0.0, -5.1955237311845615, 0.0, 0.519301780769449,
        0.5732910869255669, -0.519301780769449, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0004653894193068934, -0.7671346477890785, 0.0004653894193068934, -0.7599175614243648,
        0.0, 0.7599175614243648, -0.0004653894193068934, 0.7671346477890785, 0.0004653894193068934,
        0.005323670548944666, -0.0014736645570412852, -0.005323670548944666, 0.0005850087575884179,
        0.0, -0.0005850087575884179, 0.005323670548944666, 0.0014736645570412852,
        -0.005323670548944666, -0.003481483082644112, -1.8741687546184642, 0.003481483082644112,
        -1.8213812044971238, 0.0, 1.8213812044971238, -0.003481483082644112, 1.8741687546184642,
        0.003481483082644112, -1.2665630304169335e-05, -0.002139653432090664,
        1.2665630304169335e-05, -0.002123889428472894, 0.0, 0.002123889428472894,
        -1.2665630304169335e-05, 0.002139653432090664, 1.2665630304169335e-05,
        1.3876772673744232e-05, -0.0016418975219879305, -1.3876772673744232e-05,
        -0.0016207391336466295, 0.0, 0.0016207391336466295, 1.3876772673744232e-05,
        0.0016418975219879305, -1.3876772673744232e-05, 0.2852036263078656, 2.0936273804289915,
        -0.2852036263078656, -2.1846169904930446, 0.0, 2.1846169904930446, 0.2852036263078656,
        -2.0936273804289915, -0.2852036263078656, 0.3688017953158006, 0.0, 0.3688017953158006, 0.0,
        0.0, 0.0, -0.3688017953158006, 0.0, -0.3688017953158006, -2.890082487236679e-06, 0.0,
        -2.890082487236679e-06, 0.0, 0.0, 0.0, 2.890082487236679e-06, 0.0, 2.890082487236679e-06,
        -0.15905376145518146, 0.0, -0.15905376145518146, 0.0, 0.0, 0.0, 0.15905376145518146, 0.0,
        0.15905376145518146, 0.0010301621466655482, 0.0, 0.0010301621466655482, 0.0, 0.0, 0.0,
        -0.0010301621466655482, 0.0, -0.0010301621466655482, 0.0007873591140173928, 0.0,
        0.0007873591140173928, 0.0, 0.0, 0.0, -0.0007873591140173928, 0.0, -0.0007873591140173928,
        -0.006832468222028647, 0.0, -0.006832468222028647, 0.0, 0.0, 0.0, 0.006832468222028647, 0.0,
        0.006832468222028647, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.3688017953158006, 0.0, -0.3688017953158006, 0.0, 0.0, 0.0, 0.3688017953158006, 0.0,
        0.3688017953158006, 2.890082487236679e-06, 0.0, 2.890082487236679e-06, 0.0, 0.0, 0.0,
        -2.890082487236679e-06, 0.0, -2.890082487236679e-06, 0.15905376145518146, 0.0,
        0.15905376145518146, 0.0, 0.0, 0.0, -0.15905376145518146, 0.0, -0.15905376145518146,
        -0.0010301621466655482, 0.0, -0.0010301621466655482, 0.0, 0.0, 0.0, 0.0010301621466655482,
        0.0, 0.0010301621466655482, -0.0007873591140173928, 0.0, -0.0007873591140173928, 0.0, 0.0,
        0.0, 0.0007873591140173928, 0.0, 0.0007873591140173928, 0.006832468222028647, 0.0,
        0.006832468222028647, 0.0, 0.0, 0.0, -0.006832468222028647, 0.0, -0.006832468222028647,
        -0.0004653894193068934, -0.7671346477890785, 0.0004653894193068934, -0.7599175614243648,
        0.0, 0.7599175614243648, -0.0004653894193068934, 0.7671346477890785, 0.0004653894193068934,
        0.005323670548944666, -0.0014736645570412852, -0.005323670548944666, 0.0005850087575884179,
        0.0, -0.0005850087575884179, 0.005323670548944666, 0.0014736645570412852,
        -0.005323670548944666, -0.003481483082644112, -1.8741687546184642, 0.003481483082644112,
        -1.8213812044971238, 0.0, 1.8213812044971238, -0.003481483082644112, 1.8741687546184642,
        0.003481483082644112, -1.2665630304169335e-05, -0.002139653432090664,
        1.2665630304169335e-05, -0.002123889428472894, 0.0, 0.002123889428472894,
        -1.2665630304169335e-05, 0.002139653432090664, 1.2665630304169335e-05,
        1.3876772673744232e-05, -0.0016418975219879305, -1.3876772673744232e-05,
        -0.0016207391336466295, 0.0, 0.0016207391336466295, 1.3876772673744232e-05,
        0.0016418975219879305, -1.3876772673744232e-05, 0.2852036263078656, 2.0936273804289915,
        -0.2852036263078656, -2.1846169904930446, 0.0, 2.1846169904930446, 0.2852036263078656,
        -2.0936273804289915, -0.2852036263078656, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.38356732389453924, -0.0009307788386137868, -0.38356732389453924, 0.0, -1.5198351228487297,
        0.0, -0.38356732389453924, -0.0009307788386137868, 0.38356732389453924,
        0.0007368322785206426, 0.010647341097889331, -0.0007368322785206426, 0.0,
        0.0011700175151768358, 0.0, -0.0007368322785206426, 0.010647341097889331,
        0.0007368322785206426, 0.9370843773092321, -0.006962966165288224, -0.9370843773092321, 0.0,
        -3.6427624089942476, 0.0, -0.9370843773092321, -0.006962966165288224, 0.9370843773092321,
        0.001069826716045332, -2.533126060833867e-05, -0.001069826716045332, 0.0,
        -0.004247778856945788, 0.0, -0.001069826716045332, -2.533126060833867e-05,
        0.001069826716045332, 0.0008209487609939653, 2.7753545347488464e-05, -0.0008209487609939653,
        0.0, -0.003241478267293259, 0.0, -0.0008209487609939653, 2.7753545347488464e-05,
        0.0008209487609939653, -1.0468136902144958, 0.5704072526157312, 1.0468136902144958, 0.0,
        -4.369233980986089, 0.0, 1.0468136902144958, 0.5704072526157312, -1.0468136902144958, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0,
    -0.00145152470092325, 0.0, -0.00145152470092325, 0.008833541941701615, 0.0,
        0.008833541941701615, -0.00145152470092325, 0.0, -0.00145152470092325,
        -0.00030805078416963345, 0.0, -0.00030805078416963345, -0.008627533063171999, 0.0,
        -0.008627533063171999, -0.00030805078416963345, 0.0, -0.00030805078416963345, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.27481816758405575, 0.0, 0.27481816758405575,
        -3.4864758399287195, 0.0, -3.4864758399287195, 0.27481816758405575, 0.0,
        0.27481816758405575, 0.32033254889952767, 0.0, 0.32033254889952767, 0.42392901566384295,
        0.0, 0.42392901566384295, 0.32033254889952767, 0.0, 0.32033254889952767, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.000308050784169633, 0.0, 0.000308050784169633, 0.008627533063172012, 0.0,
        0.008627533063172012, 0.000308050784169633, 0.0, 0.000308050784169633,
        -0.0014515247009232483, 0.0, -0.0014515247009232483, 0.008833541941701604, 0.0,
        0.008833541941701604, -0.0014515247009232483, 0.0, -0.0014515247009232483, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.3203325488995278, 0.0, -0.3203325488995278,
        -0.423929015663843, 0.0, -0.423929015663843, -0.3203325488995278, 0.0, -0.3203325488995278,
        0.27481816758405564, 0.0, 0.27481816758405564, -3.4864758399287195, 0.0,
        -3.4864758399287195, 0.27481816758405564, 0.0, 0.27481816758405564, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.00044618683368274204, 0.0, -0.00044618683368274204, 0.019149084697762796, 0.0,
        0.019149084697762796, -0.00044618683368274204, 0.0, -0.00044618683368274204,
        0.005104008830586024, 0.0, 0.005104008830586024, 0.001973417818365964, 0.0,
        0.001973417818365964, 0.005104008830586024, 0.0, 0.005104008830586024,
        -0.003337832466149493, 0.0, -0.003337832466149493, 0.04501312900452749, 0.0,
        0.04501312900452749, -0.003337832466149493, 0.0, -0.003337832466149493,
        -1.2143029573877967e-05, 0.0, -1.2143029573877967e-05, 4.927508445302486e-05, 0.0,
        4.927508445302486e-05, -1.2143029573877967e-05, 0.0, -1.2143029573877967e-05,
        1.3304198600506142e-05, 0.0, 1.3304198600506142e-05, 4.639426739318813e-05, 0.0,
        4.639426739318813e-05, 1.3304198600506142e-05, 0.0, 1.3304198600506142e-05,
        0.2734357458462693, 0.0, 0.2734357458462693, -4.101641258490155, 0.0, -4.101641258490155,
        0.2734357458462693, 0.0, 0.2734357458462693, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.8551507984861226, 0.0, -0.8551507984861226, 0.0, 0.0, 0.0, -0.8551507984861226, 0.0,
        -0.8551507984861226, 5.108009056543896e-05, 0.0, 5.108009056543896e-05, 0.0, 0.0, 0.0,
        5.108009056543896e-05, 0.0, 5.108009056543896e-05, 0.34711394665964646, 0.0,
        0.34711394665964646, 0.0, 0.0, 0.0, 0.34711394665964646, 0.0, 0.34711394665964646,
        -0.002388759859289512, 0.0, -0.002388759859289512, 0.0, 0.0, 0.0, -0.002388759859289512,
        0.0, -0.002388759859289512, -0.001825547127307441, 0.0, -0.001825547127307441, 0.0, 0.0,
        0.0, -0.001825547127307441, 0.0, -0.001825547127307441, 0.0046636268356846765, 0.0,
        0.0046636268356846765, 0.0, 0.0, 0.0, 0.0046636268356846765, 0.0, 0.0046636268356846765,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -1.7839080111012973, 0.15847193737373974, 1.7839080111012973, 0.15849607709397412, 0.0,
        -0.15849607709397412, -1.7839080111012973, -0.15847193737373974, 1.7839080111012973,
        0.00010655685866022738, -1.9996657806592548, -0.00010655685866022738, -1.9999703858360915,
        0.0, 1.9999703858360915, 0.00010655685866022738, 1.9996657806592548,
        -0.00010655685866022738, 0.7241054458550918, -0.064370276208326, -0.7241054458550918,
        -0.06438008160658659, 0.0, 0.06438008160658659, 0.7241054458550918, 0.064370276208326,
        -0.7241054458550918, -0.004983130293660037, 0.004711804702725089, 0.004983130293660037,
        0.00471252244271873, 0.0, -0.00471252244271873, -0.004983130293660037,
        -0.004711804702725089, 0.004983130293660037, -0.0038082267487931855, -0.0052472414074043,
        0.0038082267487931855, -0.005248040709423801, 0.0, 0.005248040709423801,
        -0.0038082267487931855, 0.0052472414074043, 0.0038082267487931855, 0.009728671583646887,
        8.141687204963721e-05, -0.009728671583646887, 8.142927412249765e-05, 0.0,
        -8.142927412249765e-05, 0.009728671583646887, -8.141687204963721e-05, -0.009728671583646887,
        -0.001383068978079529, 0.0, -0.001383068978079529, 0.0, 0.0, 0.0, 0.001383068978079529, 0.0,
        0.001383068978079529, 0.017452148018071097, 0.0, 0.017452148018071097, 0.0, 0.0, 0.0,
        -0.017452148018071097, 0.0, -0.017452148018071097, 0.0005617936753318149, 0.0,
        0.0005617936753318149, 0.0, 0.0, 0.0, -0.0005617936753318149, 0.0, -0.0005617936753318149,
        -4.112242850757369e-05, 0.0, -4.112242850757369e-05, 0.0, 0.0, 0.0, 4.112242850757369e-05,
        0.0, 4.112242850757369e-05, 4.579546973013693e-05, 0.0, 4.579546973013693e-05, 0.0, 0.0,
        0.0, -4.579546973013693e-05, 0.0, -4.579546973013693e-05, -7.105683939394015e-07, 0.0,
        -7.105683939394015e-07, 0.0, 0.0, 0.0, 7.105683939394015e-07, 0.0, 7.105683939394015e-07,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.001383068978079529, 0.0, 0.001383068978079529, 0.0, 0.0, 0.0, -0.001383068978079529, 0.0,
        -0.001383068978079529, -0.017452148018071097, 0.0, -0.017452148018071097, 0.0, 0.0, 0.0,
        0.017452148018071097, 0.0, 0.017452148018071097, -0.0005617936753318149, 0.0,
        -0.0005617936753318149, 0.0, 0.0, 0.0, 0.0005617936753318149, 0.0, 0.0005617936753318149,
        4.112242850757369e-05, 0.0, 4.112242850757369e-05, 0.0, 0.0, 0.0, -4.112242850757369e-05,
        0.0, -4.112242850757369e-05, -4.579546973013693e-05, 0.0, -4.579546973013693e-05, 0.0, 0.0,
        0.0, 4.579546973013693e-05, 0.0, 4.579546973013693e-05, 7.105683939394015e-07, 0.0,
        7.105683939394015e-07, 0.0, 0.0, 0.0, -7.105683939394015e-07, 0.0, -7.105683939394015e-07,
        -1.7839080111012973, 0.15847193737373974, 1.7839080111012973, 0.15849607709397412, 0.0,
        -0.15849607709397412, -1.7839080111012973, -0.15847193737373974, 1.7839080111012973,
        0.00010655685866022738, -1.9996657806592548, -0.00010655685866022738, -1.9999703858360915,
        0.0, 1.9999703858360915, 0.00010655685866022738, 1.9996657806592548,
        -0.00010655685866022738, 0.7241054458550918, -0.064370276208326, -0.7241054458550918,
        -0.06438008160658659, 0.0, 0.06438008160658659, 0.7241054458550918, 0.064370276208326,
        -0.7241054458550918, -0.004983130293660037, 0.004711804702725089, 0.004983130293660037,
        0.00471252244271873, 0.0, -0.00471252244271873, -0.004983130293660037,
        -0.004711804702725089, 0.004983130293660037, -0.0038082267487931855, -0.0052472414074043,
        0.0038082267487931855, -0.005248040709423801, 0.0, 0.005248040709423801,
        -0.0038082267487931855, 0.0052472414074043, 0.0038082267487931855, 0.009728671583646887,
        8.141687204963721e-05, -0.009728671583646887, 8.142927412249765e-05, 0.0,
        -8.142927412249765e-05, 0.009728671583646887, -8.141687204963721e-05, -0.009728671583646887,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    -0.07923596868686987, -3.5678160222025945, 0.07923596868686987, 0.0, 0.31699215418794824, 0.0,
        0.07923596868686987, -3.5678160222025945, -0.07923596868686987, 0.9998328903296274,
        0.00021311371732045476, -0.9998328903296274, 0.0, -3.999940771672183, 0.0,
        -0.9998328903296274, 0.00021311371732045476, 0.9998328903296274, 0.032185138104163,
        1.4482108917101837, -0.032185138104163, 0.0, -0.12876016321317318, 0.0, -0.032185138104163,
        1.4482108917101837, 0.032185138104163, -0.0023559023513625445, -0.009966260587320074,
        0.0023559023513625445, 0.0, 0.00942504488543746, 0.0, 0.0023559023513625445,
        -0.009966260587320074, -0.0023559023513625445, 0.00262362070370215, -0.007616453497586371,
        -0.00262362070370215, 0.0, -0.010496081418847602, 0.0, -0.00262362070370215,
        -0.007616453497586371, 0.00262362070370215, -4.0708436024818604e-05, 0.019457343167293775,
        4.0708436024818604e-05, 0.0, 0.0001628585482449953, 0.0, 4.0708436024818604e-05,
        0.019457343167293775, -4.0708436024818604e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.0001541665642473645, 0.0, 2.6190258729102966e-18, 0.0, -2.6190258729102966e-18, 0.0,
        0.0001541665642473645, 0.0, 0.0, 0.00015057121356957932, 0.0, 8.046812998915853e-21, 0.0,
        -8.046812998915853e-21, 0.0, -0.00015057121356957932, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.060847393392205414, 0.0, -4.336808689942018e-18, 0.0,
        4.336808689942018e-18, 0.0, -0.060847393392205414, 0.0, 0.0, -0.0073985814819229195, 0.0,
        -5.204170427930421e-18, 0.0, 5.204170427930421e-18, 0.0, 0.0073985814819229195, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0044160982752388354, 0.0, -0.0044160982752388354,
        0.0, 0.0, 0.0, 0.0044160982752388354, 0.0, 0.0044160982752388354, 0.004313109524049042, 0.0,
        0.004313109524049042, 0.0, 0.0, 0.0, -0.004313109524049042, 0.0, -0.004313109524049042, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.7429724163855869, 0.0, 1.7429724163855869, 0.0,
        0.0, 0.0, -1.7429724163855869, 0.0, -1.7429724163855869, -0.21193222461070552, 0.0,
        -0.21193222461070552, 0.0, 0.0, 0.0, 0.21193222461070552, 0.0, 0.21193222461070552, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0044160982752388354, 0.0, 0.0044160982752388354, 0.0, 0.0, 0.0, -0.0044160982752388354,
        0.0, -0.0044160982752388354, -0.004313109524049042, 0.0, -0.004313109524049042, 0.0, 0.0,
        0.0, 0.004313109524049042, 0.0, 0.004313109524049042, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, -1.7429724163855869, 0.0, -1.7429724163855869, 0.0, 0.0, 0.0, 1.7429724163855869,
        0.0, 1.7429724163855869, 0.21193222461070552, 0.0, 0.21193222461070552, 0.0, 0.0, 0.0,
        -0.21193222461070552, 0.0, -0.21193222461070552, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, -0.0001541665642473645, 0.0, 2.6190258729102966e-18, 0.0, -2.6190258729102966e-18,
        0.0, 0.0001541665642473645, 0.0, 0.0, 0.00015057121356957932, 0.0, 8.046812998915853e-21,
        0.0, -8.046812998915853e-21, 0.0, -0.00015057121356957932, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.060847393392205414, 0.0, -4.336808689942018e-18, 0.0,
        4.336808689942018e-18, 0.0, -0.060847393392205414, 0.0, 0.0, -0.0073985814819229195, 0.0,
        -5.204170427930421e-18, 0.0, 5.204170427930421e-18, 0.0, 0.0073985814819229195, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    7.708328212368225e-05, 0.0, -7.708328212368225e-05, 0.0, 5.238051745820593e-18, 0.0,
        -7.708328212368225e-05, 0.0, 7.708328212368225e-05, -7.528560678478966e-05, 0.0,
        7.528560678478966e-05, 0.0, 1.6093625997831706e-20, 0.0, 7.528560678478966e-05, 0.0,
        -7.528560678478966e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.030423696696102707,
        0.0, 0.030423696696102707, 0.0, -8.673617379884035e-18, 0.0, 0.030423696696102707, 0.0,
        -0.030423696696102707, 0.0036992907409614598, 0.0, -0.0036992907409614598, 0.0,
        -1.0408340855860843e-17, 0.0, -0.0036992907409614598, 0.0, 0.0036992907409614598, 0.0, 0.0,
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
        -0.00015057121356957953, 0.0, 6.776263578034403e-21, 0.0, -6.776263578034403e-21, 0.0,
        0.00015057121356957953, 0.0, 0.0, -0.000154166564247239, 0.0, 1.2798667833012478e-16, 0.0,
        -1.2798667833012478e-16, 0.0, 0.000154166564247239, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0073985814819229135, 0.0, -1.734723475976807e-18, 0.0,
        1.734723475976807e-18, 0.0, -0.0073985814819229135, 0.0, 0.0, 0.06084739339220542, 0.0,
        2.168404344971009e-18, 0.0, -2.168404344971009e-18, 0.0, -0.06084739339220542, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.004313109524049048, 0.0, -0.004313109524049048,
        0.0, 0.0, 0.0, 0.004313109524049048, 0.0, 0.004313109524049048, -0.004416098275238832, 0.0,
        -0.004416098275238832, 0.0, 0.0, 0.0, 0.004416098275238832, 0.0, 0.004416098275238832, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.21193222461070554, 0.0, 0.21193222461070554, 0.0,
        0.0, 0.0, -0.21193222461070554, 0.0, -0.21193222461070554, 1.7429724163855869, 0.0,
        1.7429724163855869, 0.0, 0.0, 0.0, -1.7429724163855869, 0.0, -1.7429724163855869, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.004313109524049048, 0.0, 0.004313109524049048, 0.0, 0.0, 0.0, -0.004313109524049048, 0.0,
        -0.004313109524049048, 0.004416098275238832, 0.0, 0.004416098275238832, 0.0, 0.0, 0.0,
        -0.004416098275238832, 0.0, -0.004416098275238832, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, -0.21193222461070554, 0.0, -0.21193222461070554, 0.0, 0.0, 0.0, 0.21193222461070554,
        0.0, 0.21193222461070554, -1.7429724163855869, 0.0, -1.7429724163855869, 0.0, 0.0, 0.0,
        1.7429724163855869, 0.0, 1.7429724163855869, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, -0.00015057121356957953, 0.0, 6.776263578034403e-21, 0.0, -6.776263578034403e-21, 0.0,
        0.00015057121356957953, 0.0, 0.0, -0.000154166564247239, 0.0, 1.2798667833012478e-16, 0.0,
        -1.2798667833012478e-16, 0.0, 0.000154166564247239, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0073985814819229135, 0.0, -1.734723475976807e-18, 0.0,
        1.734723475976807e-18, 0.0, -0.0073985814819229135, 0.0, 0.0, 0.06084739339220542, 0.0,
        2.168404344971009e-18, 0.0, -2.168404344971009e-18, 0.0, -0.06084739339220542, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    7.528560678478977e-05, 0.0, -7.528560678478977e-05, 0.0, 1.3552527156068805e-20, 0.0,
        -7.528560678478977e-05, 0.0, 7.528560678478977e-05, 7.70832821236195e-05, 0.0,
        -7.70832821236195e-05, 0.0, 2.5597335666024956e-16, 0.0, -7.70832821236195e-05, 0.0,
        7.70832821236195e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0036992907409614567,
        0.0, 0.0036992907409614567, 0.0, -3.469446951953614e-18, 0.0, 0.0036992907409614567, 0.0,
        -0.0036992907409614567, -0.03042369669610271, 0.0, 0.03042369669610271, 0.0,
        4.336808689942018e-18, 0.0, 0.03042369669610271, 0.0, -0.03042369669610271, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.6944539204055694, 0.0, -0.6942254566961334, 0.0, 0.6942254566961334, 0.0,
        0.6944539204055694, 0.0, 0.0, -4.24687256957719e-06, 0.0, 3.0198616662710954e-05, 0.0,
        -3.0198616662710954e-05, 0.0, 4.24687256957719e-06, 0.0, 0.0, 0.3354578751690574, 0.0,
        0.3362946819003916, 0.0, -0.3362946819003916, 0.0, -0.3354578751690574, 0.0, 0.0,
        -0.0019397750275905942, 0.0, -0.001939210409927697, 0.0, 0.001939210409927697, 0.0,
        0.0019397750275905942, 0.0, 0.0, -0.001482624573737283, 0.0, -0.0014820406040888046, 0.0,
        0.0014820406040888046, 0.0, 0.001482624573737283, 0.0, 0.0, 0.04965476325561913, 0.0,
        -0.02193208741062519, 0.0, 0.02193208741062519, 0.0, -0.04965476325561913, 0.0,
        -0.0035151316850214834, 0.0, -0.0035151316850214834, 0.0, 0.0, 0.0, 0.0035151316850214834,
        0.0, 0.0035151316850214834, -0.0009868221479028022, 0.0, -0.0009868221479028022, 0.0, 0.0,
        0.0, 0.0009868221479028022, 0.0, 0.0009868221479028022, -0.025437712379088363, 0.0,
        -0.025437712379088363, 0.0, 0.0, 0.0, 0.025437712379088363, 0.0, 0.025437712379088363,
        -7.711845688762049e-06, 0.0, -7.711845688762049e-06, 0.0, 0.0, 0.0, 7.711845688762049e-06,
        0.0, 7.711845688762049e-06, -1.0261013171216732e-05, 0.0, -1.0261013171216732e-05, 0.0, 0.0,
        0.0, 1.0261013171216732e-05, 0.0, 1.0261013171216732e-05, 2.050699663181625, 0.0,
        2.050699663181625, 0.0, 0.0, 0.0, -2.050699663181625, 0.0, -2.050699663181625, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0035151316850214834, 0.0, 0.0035151316850214834, 0.0, 0.0, 0.0, -0.0035151316850214834,
        0.0, -0.0035151316850214834, 0.0009868221479028022, 0.0, 0.0009868221479028022, 0.0, 0.0,
        0.0, -0.0009868221479028022, 0.0, -0.0009868221479028022, 0.025437712379088363, 0.0,
        0.025437712379088363, 0.0, 0.0, 0.0, -0.025437712379088363, 0.0, -0.025437712379088363,
        7.711845688762049e-06, 0.0, 7.711845688762049e-06, 0.0, 0.0, 0.0, -7.711845688762049e-06,
        0.0, -7.711845688762049e-06, 1.0261013171216732e-05, 0.0, 1.0261013171216732e-05, 0.0, 0.0,
        0.0, -1.0261013171216732e-05, 0.0, -1.0261013171216732e-05, -2.050699663181625, 0.0,
        -2.050699663181625, 0.0, 0.0, 0.0, 2.050699663181625, 0.0, 2.050699663181625, 0.0,
        -0.6944539204055694, 0.0, -0.6942254566961334, 0.0, 0.6942254566961334, 0.0,
        0.6944539204055694, 0.0, 0.0, -4.24687256957719e-06, 0.0, 3.0198616662710954e-05, 0.0,
        -3.0198616662710954e-05, 0.0, 4.24687256957719e-06, 0.0, 0.0, 0.3354578751690574, 0.0,
        0.3362946819003916, 0.0, -0.3362946819003916, 0.0, -0.3354578751690574, 0.0, 0.0,
        -0.0019397750275905942, 0.0, -0.001939210409927697, 0.0, 0.001939210409927697, 0.0,
        0.0019397750275905942, 0.0, 0.0, -0.001482624573737283, 0.0, -0.0014820406040888046, 0.0,
        0.0014820406040888046, 0.0, 0.001482624573737283, 0.0, 0.0, 0.04965476325561913, 0.0,
        -0.02193208741062519, 0.0, 0.02193208741062519, 0.0, -0.04965476325561913, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0,
    0.3472269602027847, 0.0, -0.3472269602027847, 0.0, -1.388450913392267, 0.0, -0.3472269602027847,
        0.0, 0.3472269602027847, 2.123436284788595e-06, 0.0, -2.123436284788595e-06, 0.0,
        6.039723332542191e-05, 0.0, -2.123436284788595e-06, 0.0, 2.123436284788595e-06,
        -0.1677289375845287, 0.0, 0.1677289375845287, 0.0, 0.6725893638007832, 0.0,
        0.1677289375845287, 0.0, -0.1677289375845287, 0.0009698875137952971, 0.0,
        -0.0009698875137952971, 0.0, -0.003878420819855394, 0.0, -0.0009698875137952971, 0.0,
        0.0009698875137952971, 0.0007413122868686415, 0.0, -0.0007413122868686415, 0.0,
        -0.002964081208177609, 0.0, -0.0007413122868686415, 0.0, 0.0007413122868686415,
        -0.024827381627809564, 0.0, 0.024827381627809564, 0.0, -0.04386417482125038, 0.0,
        0.024827381627809564, 0.0, -0.024827381627809564, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.004233884194434776, 0.0, -0.004234529133732246, 0.0, 0.004234529133732246, 0.0,
        0.004233884194434776, 0.0, 0.0, 0.004135144895920532, 0.0, 0.004135774794453802, 0.0,
        -0.004135774794453802, 0.0, -0.004135144895920532, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 1.6710550592698523, 0.0, 1.6713096078182927, 0.0, -1.6713096078182927, 0.0,
        -1.6710550592698523, 0.0, 0.0, -0.20318761951060485, 0.0, -0.20321857068323115, 0.0,
        0.20321857068323115, 0.0, 0.20318761951060485, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 3.695136175620661e-05, 0.0, 3.695136175620661e-05, 0.0, 0.0, 0.0,
        -3.695136175620661e-05, 0.0, -3.695136175620661e-05, -3.608961132294021e-05, 0.0,
        -3.608961132294021e-05, 0.0, 0.0, 0.0, 3.608961132294021e-05, 0.0, 3.608961132294021e-05,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.014584187279090877, 0.0,
        -0.014584187279090877, 0.0, 0.0, 0.0, 0.014584187279090877, 0.0, 0.014584187279090877,
        0.0017733265455837888, 0.0, 0.0017733265455837888, 0.0, 0.0, 0.0, -0.0017733265455837888,
        0.0, -0.0017733265455837888, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -3.695136175620661e-05, 0.0, -3.695136175620661e-05, 0.0, 0.0, 0.0, 3.695136175620661e-05,
        0.0, 3.695136175620661e-05, 3.608961132294021e-05, 0.0, 3.608961132294021e-05, 0.0, 0.0,
        0.0, -3.608961132294021e-05, 0.0, -3.608961132294021e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.014584187279090877, 0.0, 0.014584187279090877, 0.0, 0.0, 0.0,
        -0.014584187279090877, 0.0, -0.014584187279090877, -0.0017733265455837888, 0.0,
        -0.0017733265455837888, 0.0, 0.0, 0.0, 0.0017733265455837888, 0.0, 0.0017733265455837888,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.004233884194434776, 0.0,
        -0.004234529133732246, 0.0, 0.004234529133732246, 0.0, 0.004233884194434776, 0.0, 0.0,
        0.004135144895920532, 0.0, 0.004135774794453802, 0.0, -0.004135774794453802, 0.0,
        -0.004135144895920532, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        1.6710550592698523, 0.0, 1.6713096078182927, 0.0, -1.6713096078182927, 0.0,
        -1.6710550592698523, 0.0, 0.0, -0.20318761951060485, 0.0, -0.20321857068323115, 0.0,
        0.20321857068323115, 0.0, 0.20318761951060485, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.002116942097217388, 0.0, -0.002116942097217388, 0.0, -0.008469058267464491, 0.0,
        -0.002116942097217388, 0.0, 0.002116942097217388, -0.002067572447960266, 0.0,
        0.002067572447960266, 0.0, 0.008271549588907605, 0.0, 0.002067572447960266, 0.0,
        -0.002067572447960266, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.8355275296349262,
        0.0, 0.8355275296349262, 0.0, 3.3426192156365855, 0.0, 0.8355275296349262, 0.0,
        -0.8355275296349262, 0.10159380975530242, 0.0, -0.10159380975530242, 0.0,
        -0.4064371413664623, 0.0, -0.10159380975530242, 0.0, 0.10159380975530242, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.004135144895920538, 0.0, -0.004135774794453808, 0.0, 0.004135774794453808, 0.0,
        0.004135144895920538, 0.0, 0.0, -0.0042338841944347715, 0.0, -0.004234529133732241, 0.0,
        0.004234529133732241, 0.0, 0.0042338841944347715, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.20318761951060488, 0.0, 0.20321857068323118, 0.0, -0.20321857068323118,
        0.0, -0.20318761951060488, 0.0, 0.0, 1.6710550592698523, 0.0, 1.6713096078182927, 0.0,
        -1.6713096078182927, 0.0, -1.6710550592698523, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 3.608961132294027e-05, 0.0, 3.608961132294027e-05, 0.0, 0.0, 0.0,
        -3.608961132294027e-05, 0.0, -3.608961132294027e-05, 3.695136175620657e-05, 0.0,
        3.695136175620657e-05, 0.0, 0.0, 0.0, -3.695136175620657e-05, 0.0, -3.695136175620657e-05,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.001773326545583789, 0.0,
        -0.001773326545583789, 0.0, 0.0, 0.0, 0.001773326545583789, 0.0, 0.001773326545583789,
        -0.014584187279090877, 0.0, -0.014584187279090877, 0.0, 0.0, 0.0, 0.014584187279090877, 0.0,
        0.014584187279090877, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -3.608961132294027e-05, 0.0, -3.608961132294027e-05, 0.0, 0.0, 0.0, 3.608961132294027e-05,
        0.0, 3.608961132294027e-05, -3.695136175620657e-05, 0.0, -3.695136175620657e-05, 0.0, 0.0,
        0.0, 3.695136175620657e-05, 0.0, 3.695136175620657e-05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.001773326545583789, 0.0, 0.001773326545583789, 0.0, 0.0, 0.0,
        -0.001773326545583789, 0.0, -0.001773326545583789, 0.014584187279090877, 0.0,
        0.014584187279090877, 0.0, 0.0, 0.0, -0.014584187279090877, 0.0, -0.014584187279090877, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.004135144895920538, 0.0,
        -0.004135774794453808, 0.0, 0.004135774794453808, 0.0, 0.004135144895920538, 0.0, 0.0,
        -0.0042338841944347715, 0.0, -0.004234529133732241, 0.0, 0.004234529133732241, 0.0,
        0.0042338841944347715, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.20318761951060488, 0.0, 0.20321857068323118, 0.0, -0.20321857068323118, 0.0,
        -0.20318761951060488, 0.0, 0.0, 1.6710550592698523, 0.0, 1.6713096078182927, 0.0,
        -1.6713096078182927, 0.0, -1.6710550592698523, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.002067572447960269, 0.0, -0.002067572447960269, 0.0, -0.008271549588907617, 0.0,
        -0.002067572447960269, 0.0, 0.002067572447960269, 0.0021169420972173857, 0.0,
        -0.0021169420972173857, 0.0, -0.008469058267464483, 0.0, -0.0021169420972173857, 0.0,
        0.0021169420972173857, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.10159380975530244,
        0.0, 0.10159380975530244, 0.0, 0.40643714136646236, 0.0, 0.10159380975530244, 0.0,
        -0.10159380975530244, -0.8355275296349262, 0.0, 0.8355275296349262, 0.0, 3.3426192156365855,
        0.0, 0.8355275296349262, 0.0, -0.8355275296349262, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -0.009178085933685302, 0.0, -0.009179484013562396, 0.0, 0.009179484013562396, 0.0,
        0.009178085933685302, 0.0, 0.0, -0.0009458519091591177, 0.0, -0.0009459959889302663, 0.0,
        0.0009459959889302663, 0.0, 0.0009458519091591177, 0.0, 0.0, -0.021574627334322798, 0.0,
        -0.021577913755102672, 0.0, 0.021577913755102672, 0.0, 0.021574627334322798, 0.0, 0.0,
        -2.361736692053483e-05, 0.0, -2.3620964507840085e-05, 0.0, 2.3620964507840085e-05, 0.0,
        2.361736692053483e-05, 0.0, 0.0, -2.2236601889112872e-05, 0.0, -2.2239989147181794e-05, 0.0,
        2.2239989147181794e-05, 0.0, 2.2236601889112872e-05, 0.0, 0.0, 1.965901584004686, 0.0,
        1.9662010459474923, 0.0, -1.9662010459474923, 0.0, -1.965901584004686, 0.0,
        8.010204294461873e-05, 0.0, 8.010204294461873e-05, 0.0, 0.0, 0.0, -8.010204294461873e-05,
        0.0, -8.010204294461873e-05, 8.254953243425481e-06, 0.0, 8.254953243425481e-06, 0.0, 0.0,
        0.0, -8.254953243425481e-06, 0.0, -8.254953243425481e-06, 0.00018829326046135116, 0.0,
        0.00018829326046135116, 0.0, 0.0, 0.0, -0.00018829326046135116, 0.0,
        -0.00018829326046135116, 2.0612133651573684e-07, 0.0, 2.0612133651573684e-07, 0.0, 0.0, 0.0,
        -2.0612133651573684e-07, 0.0, -2.0612133651573684e-07, 1.9407066487869548e-07, 0.0,
        1.9407066487869548e-07, 0.0, 0.0, 0.0, -1.9407066487869548e-07, 0.0,
        -1.9407066487869548e-07, -0.017157469895643793, 0.0, -0.017157469895643793, 0.0, 0.0, 0.0,
        0.017157469895643793, 0.0, 0.017157469895643793, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        -8.010204294461873e-05, 0.0, -8.010204294461873e-05, 0.0, 0.0, 0.0, 8.010204294461873e-05,
        0.0, 8.010204294461873e-05, -8.254953243425481e-06, 0.0, -8.254953243425481e-06, 0.0, 0.0,
        0.0, 8.254953243425481e-06, 0.0, 8.254953243425481e-06, -0.00018829326046135116, 0.0,
        -0.00018829326046135116, 0.0, 0.0, 0.0, 0.00018829326046135116, 0.0, 0.00018829326046135116,
        -2.0612133651573684e-07, 0.0, -2.0612133651573684e-07, 0.0, 0.0, 0.0,
        2.0612133651573684e-07, 0.0, 2.0612133651573684e-07, -1.9407066487869548e-07, 0.0,
        -1.9407066487869548e-07, 0.0, 0.0, 0.0, 1.9407066487869548e-07, 0.0, 1.9407066487869548e-07,
        0.017157469895643793, 0.0, 0.017157469895643793, 0.0, 0.0, 0.0, -0.017157469895643793, 0.0,
        -0.017157469895643793, 0.0, -0.009178085933685302, 0.0, -0.009179484013562396, 0.0,
        0.009179484013562396, 0.0, 0.009178085933685302, 0.0, 0.0, -0.0009458519091591177, 0.0,
        -0.0009459959889302663, 0.0, 0.0009459959889302663, 0.0, 0.0009458519091591177, 0.0, 0.0,
        -0.021574627334322798, 0.0, -0.021577913755102672, 0.0, 0.021577913755102672, 0.0,
        0.021574627334322798, 0.0, 0.0, -2.361736692053483e-05, 0.0, -2.3620964507840085e-05, 0.0,
        2.3620964507840085e-05, 0.0, 2.361736692053483e-05, 0.0, 0.0, -2.2236601889112872e-05, 0.0,
        -2.2239989147181794e-05, 0.0, 2.2239989147181794e-05, 0.0, 2.2236601889112872e-05, 0.0, 0.0,
        1.965901584004686, 0.0, 1.9662010459474923, 0.0, -1.9662010459474923, 0.0,
        -1.965901584004686, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.004589042966842651, 0.0, -0.004589042966842651, 0.0, -0.018358968027124792, 0.0,
        -0.004589042966842651, 0.0, 0.004589042966842651, 0.00047292595457955886, 0.0,
        -0.00047292595457955886, 0.0, -0.0018919919778605325, 0.0, -0.00047292595457955886, 0.0,
        0.00047292595457955886, 0.010787313667161399, 0.0, -0.010787313667161399, 0.0,
        -0.043155827510205344, 0.0, -0.010787313667161399, 0.0, 0.010787313667161399,
        1.1808683460267415e-05, 0.0, -1.1808683460267415e-05, 0.0, -4.724192901568017e-05, 0.0,
        -1.1808683460267415e-05, 0.0, 1.1808683460267415e-05, 1.1118300944556436e-05, 0.0,
        -1.1118300944556436e-05, 0.0, -4.447997829436359e-05, 0.0, -1.1118300944556436e-05, 0.0,
        1.1118300944556436e-05, -0.982950792002343, 0.0, 0.982950792002343, 0.0, 3.9324020918949847,
        0.0, 0.982950792002343, 0.0, -0.982950792002343, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
};

static const manseur_doty_formulation manseur_doty_formulations[2] = {
    {
        { 2, 3, 4, 5, 0, 1 }, 1.0, 0, 3, 1,
        {
            { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.04636661657662248 },
            { 1.0, 0.0, 0.0, 1.0430370960650202, 0.0, 0.9998476951563913, -0.01745240643728351, 0.0,
                0.0, 0.01745240643728351, 0.9998476951563913, 0.0 },
            { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0 },
            { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
            { 1.0, 0.0, 0.0, 0.20860741921300402, 0.0, 0.0, -1.0, -0.046345438382874284, 0.0, 1.0,
                0.0, 0.0 },
            { 1.0, 0.0, 0.0, 0.6953580640433468, 0.0, 0.9998476951563913, -0.01745240643728351,
                -0.0016179252730085187, 0.0, 0.01745240643728351, 0.9998476951563913,
                0.046345438429219725 },
        },
        manseur_doty_table_1, manseur_doty_left_1,
    },
    {
        { 5, 4, 3, 2, 1, 0 }, -1.0, 0, 5, 0,
        {
            { 1.0, 0.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.0, 0.0, -1.0, 0.0, -0.0 },
            { 1.0, 0.0, 0.0, -1.0430370960650202, 0.0, 0.9998476951563913, 0.01745240643728351,
                -0.0, 0.0, -0.01745240643728351, 0.9998476951563913, -0.0 },
            { 1.0, 0.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.04636661657662248, 0.0, -1.0, 0.0, -0.0 },
            { 1.0, 0.0, 0.0, -0.6953580640433468, 0.0, 0.9998476951563913, 0.01745240643728351,
                0.0008088394271720014, 0.0, -0.01745240643728351, 0.9998476951563913,
                -0.04636661648391748 },
            { 1.0, 0.0, 0.0, -0.20860741921300402, 0.0, 0.0, 1.0, -0.0, 0.0, -1.0, 0.0,
                -0.046345438382874284 },
            { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
        },
        manseur_doty_table_2, 0,
    },
};

/* cosines and sines of the 24 angles at which the determinant is sampled */
static const double manseur_doty_sample_c[24] = {
    1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386,
        0.9659258262890682
};

static const double manseur_doty_sample_s[24] = {
    0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0,
        0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0,
        -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682,
        -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5,
        -0.2588190451025207
};

/* from the samples to a_0, a_1 ... a_8, b_1 ... b_8 and seven numbers that would be zero without
 * rounding: one row for each sample */
static const double manseur_doty_harmonics[24][24] = {
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
static const double manseur_doty_grid_c[8][128] = {
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

static const double manseur_doty_grid_s[8][128] = {
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
static inline void manseur_doty_compose(const double A[12], const double B[12], double C[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = A[4 * i] * B[j] + A[4 * i + 1] * B[4 + j] + A[4 * i + 2] * B[8 + j] +
                           (j == 3 ? A[4 * i + 3] : 0.0);
        }
    }
}

static inline void manseur_doty_invert(const double A[12], double B[12])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            B[4 * i + j] = A[4 * j + i];
        }
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11]);
    }
}

/* 1; R row by row; t; t.t; R't; [t]xR; (t.t - 2 t t') R */
static inline void manseur_doty_monomials(const double A[12], double m[35])
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
static inline void manseur_doty_times(const double *table, const double m[35], int rows, double
    *out)
{
    for (int i = 0; i < rows; i += 8) {
        manseur_doty_lane sum[8 / MANSEUR_DOTY_LANES];
        for (int k = 0; k < 8 / MANSEUR_DOTY_LANES; k++) {
            sum[k] = MANSEUR_DOTY_LOAD(table + i + MANSEUR_DOTY_LANES * k);
        }
        for (int j = 1; j < 35; j++) {
            for (int k = 0; k < 8 / MANSEUR_DOTY_LANES; k++) {
                sum[k] += m[j] * MANSEUR_DOTY_LOAD(table + rows * j + i + MANSEUR_DOTY_LANES * k);
            }
        }
        for (int k = 0; k < 8 / MANSEUR_DOTY_LANES; k++) {
            MANSEUR_DOTY_STORE(out + i + MANSEUR_DOTY_LANES * k, sum[k]);
        }
    }
}

/* Reflections that clear the eight columns of the right side; what they leave in the last six of
 * the 14 rows annihilates it. Rows of 40: eight columns of the right side, 32 of the left. */
static void manseur_doty_clear_right(double work[14][40])
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
        for (int k = 0; k < 40; k += MANSEUR_DOTY_LANES) {
            manseur_doty_lane sum = {0};
            for (int i = c; i < 14; i++) {
                sum += axis[i] * MANSEUR_DOTY_LOAD(&work[i][k]);
            }
            sum *= factor;
            for (int i = c; i < 14; i++) {
                MANSEUR_DOTY_STORE(&work[i][k], MANSEUR_DOTY_LOAD(&work[i][k]) - axis[i] * sum);
            }
        }
    }
}

/* The six equations of a pose: index ((a 6 + r) 3 + i) 3 + j for 1, c1, s1 (a), equation r, the
 * powers x3^2, x3, 1 (i) and x2^2, x2, 1 (j) of the partners' half-angle tangents. */
static void manseur_doty_equations(const manseur_doty_formulation *form, const double P[12],
                              double E[168])
{
    double inverse[12], m[35], right[128], work[14][40];
    manseur_doty_invert(P, inverse);
    manseur_doty_monomials(form->inverted ? inverse : P, m);
    if (!form->each_pose) {
        manseur_doty_times(form->table, m, 168, E);
        return;
    }
    manseur_doty_times(form->table, m, 128, right);
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
    manseur_doty_clear_right(work);
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
static inline manseur_doty_lane manseur_doty_reflect(manseur_doty_lane *const *row, int rows, int
    column, int columns)
{
    manseur_doty_lane axis[6], square = {0}, length, factor;
    for (int i = 0; i < rows; i++) {
        axis[i] = row[i][column];
        square += axis[i] * axis[i];
    }
    length = manseur_doty_with_sign(manseur_doty_sqrt(square), axis[0]);
    axis[0] += length;
    factor = 1.0 / (length * axis[0] + 1e-300);
    for (int j = column + 1; j < columns; j++) {
        manseur_doty_lane sum = axis[0] * row[0][j];
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
static inline manseur_doty_lane manseur_doty_fold(const double *E, manseur_doty_lane c,
    manseur_doty_lane s,
                                        manseur_doty_lane factor[6][6])
{
    manseur_doty_lane M[6][9], W[6][9], determinant;
    manseur_doty_lane *const rows[6] = {M[0], M[1], M[2], M[3], M[4], M[5]};
    manseur_doty_lane *const last[6] = {factor[0], factor[1], factor[2], factor[3], factor[4],
        factor[5]};
    const manseur_doty_lane zero = {0};
    for (int r = 0; r < 6; r++) {
        for (int k = 0; k < 9; k++) {
            const int at = 9 * r + k;
            M[r][k] = E[at] + E[54 + at] * c + E[108 + at] * s;
        }
    }
    determinant = manseur_doty_reflect(rows, 6, 0, 9);
    determinant *= manseur_doty_reflect(rows + 1, 5, 1, 9);
    determinant *= manseur_doty_reflect(rows + 2, 4, 2, 9);
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
        manseur_doty_lane *const four[4] = {W[k], W[3], W[4], W[5]};
        determinant *= manseur_doty_reflect(four, 4, k, 9);
    }
    for (int r = 0; r < 3; r++) {
        for (int k = 0; k < 6; k++) {
            factor[r][k] = W[3 + r][3 + k];
        }
    }
    determinant *= manseur_doty_reflect(last, 6, 0, 6);
    determinant *= manseur_doty_reflect(last + 1, 5, 1, 6);
    determinant *= manseur_doty_reflect(last + 2, 4, 2, 6);
    determinant *= manseur_doty_reflect(last + 3, 3, 3, 6);
    determinant *= manseur_doty_reflect(last + 4, 2, 4, 6);
    return determinant * factor[5][5];
}

/* f(x) = sum a_m cos mx + b_m sin mx, m = 0 ... 8, and where it vanishes. */
typedef struct {
    double a[9], b[9];
    double scale;    /* the largest sample */
    double noise;    /* the harmonics beyond the eighth, over scale */
    double rounding; /* how far f may be from what it stands for */
} manseur_doty_trigonometric;

/* f, f', f'' at the edges of the cells; the first edge stands at the end again */
typedef struct {
    double value[264], slope[264], bend[264];
} manseur_doty_grid;

/* The roots by their cosines and sines: `simple` of them change the sign of f, `doubles` touch zero
 * within the rounding of f, or nearly (two roots, none or one). `complete` says that no cell was
 * given
 * up. */
typedef struct {
    int simple, doubles, complete;
    double c[MANSEUR_DOTY_ROOTS + 8], s[MANSEUR_DOTY_ROOTS + 8];
    double double_c[MANSEUR_DOTY_ROOTS], double_s[MANSEUR_DOTY_ROOTS];
} manseur_doty_roots;

static void manseur_doty_fit(const double samples[24], manseur_doty_trigonometric *f)
{
    double h[24] = {0.0}, most = 0.0, beyond = 0.0;
    for (int k = 0; k < 24; k++) {
        most = fabs(samples[k]) > most ? fabs(samples[k]) : most;
    }
    for (int k = 0; k < 24; k++) {
        for (int j = 0; j < 24; j++) {
            h[j] += samples[k] * manseur_doty_harmonics[k][j];
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
static void manseur_doty_at(const manseur_doty_trigonometric *f, double cosine, double sine, double
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

static void manseur_doty_fill_grid(const manseur_doty_trigonometric *f, manseur_doty_grid *g)
{
    for (int i = 0; i < 128; i += MANSEUR_DOTY_LANES) {
        /* [0]: even multiples, the same half a turn on; [1]: odd ones, the opposite there */
        manseur_doty_lane value[2], slope[2], bend[2];
        value[0] = manseur_doty_all(f->a[0]);
        value[1] = slope[0] = slope[1] = bend[0] = bend[1] = manseur_doty_all(0.0);
        for (int m = 1; m < 9; m++) {
            const manseur_doty_lane c = MANSEUR_DOTY_LOAD(&manseur_doty_grid_c[m - 1][i]);
            const manseur_doty_lane s = MANSEUR_DOTY_LOAD(&manseur_doty_grid_s[m - 1][i]);
            const double ma = m * f->a[m], mb = m * f->b[m];
            value[m % 2] += f->a[m] * c + f->b[m] * s;
            slope[m % 2] += mb * c - ma * s;
            bend[m % 2] -= m * ma * c + m * mb * s;
        }
        MANSEUR_DOTY_STORE(&g->value[i], value[0] + value[1]);
        MANSEUR_DOTY_STORE(&g->slope[i], slope[0] + slope[1]);
        MANSEUR_DOTY_STORE(&g->bend[i], bend[0] + bend[1]);
        MANSEUR_DOTY_STORE(&g->value[i + 128], value[0] - value[1]);
        MANSEUR_DOTY_STORE(&g->slope[i + 128], slope[0] - slope[1]);
        MANSEUR_DOTY_STORE(&g->bend[i + 128], bend[0] - bend[1]);
    }
    g->value[256] = g->value[0];
    g->slope[256] = g->slope[0];
    g->bend[256] = g->bend[0];
}

/* Which of 64 cells may have roots: those where the Bernstein coefficients of the quintic through
 * f, f', f'' at both edges are not all of one sign beyond doubt. */
static unsigned long long manseur_doty_open_cells(const manseur_doty_grid *g, int from, double
    doubt)
{
    const double h = 0.02454369260617026;
    unsigned long long bits = 0;
#if MANSEUR_DOTY_LANES > 1
    manseur_doty_mask weight, sum = {0};
    for (int k = 0; k < MANSEUR_DOTY_LANES; k++) {
        weight[k] = 1LL << k;
    }
#endif
    for (int i = 0; i < 64; i += MANSEUR_DOTY_LANES) {
        const manseur_doty_lane f0 = MANSEUR_DOTY_LOAD(&g->value[from + i]);
        const manseur_doty_lane f1 = MANSEUR_DOTY_LOAD(&g->value[from + i + 1]);
        const manseur_doty_lane d0 = MANSEUR_DOTY_LOAD(&g->slope[from + i]) * (h / 5.0);
        const manseur_doty_lane d1 = MANSEUR_DOTY_LOAD(&g->slope[from + i + 1]) * (h / 5.0);
        const manseur_doty_lane s0 = MANSEUR_DOTY_LOAD(&g->bend[from + i]) * (h * h / 20.0);
        const manseur_doty_lane s1 = MANSEUR_DOTY_LOAD(&g->bend[from + i + 1]) * (h * h / 20.0);
        const manseur_doty_lane b1 = f0 + d0, b2 = f0 + 2.0 * d0 + s0;
        const manseur_doty_lane b3 = f1 - 2.0 * d1 + s1, b4 = f1 - d1;
        const manseur_doty_lane least = manseur_doty_min(
            manseur_doty_min(manseur_doty_min(f0, f1), manseur_doty_min(b1, b2)),
                manseur_doty_min(b3, b4));
        const manseur_doty_lane most = manseur_doty_max(
            manseur_doty_max(manseur_doty_max(f0, f1), manseur_doty_max(b1, b2)),
                manseur_doty_max(b3, b4));
        const manseur_doty_mask open = (least <= doubt) & (most >= -doubt);
#if MANSEUR_DOTY_LANES > 1
        sum |= (open & weight) << i;
#else
        bits |= (unsigned long long)(open != 0) << i;
#endif
    }
#if MANSEUR_DOTY_LANES > 1
    for (int k = 0; k < MANSEUR_DOTY_LANES; k++) {
        bits |= (unsigned long long)sum[k];
    }
#endif
    return bits;
}

static void manseur_doty_add_root(manseur_doty_roots *roots, double x, int twice)
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
    if (*count == MANSEUR_DOTY_ROOTS) {
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
static double manseur_doty_between(const manseur_doty_trigonometric *f, int order, double low,
    double high,
                              int rising)
{
    double x = 0.5 * (low + high);
    for (int i = 0; i < 48; i++) {
        double at[3], step;
        manseur_doty_at(f, cos(x), sin(x), at);
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
static void manseur_doty_few(const manseur_doty_trigonometric *f, double low, const double
    at_low[3],
                        double high, const double at_high[3], manseur_doty_roots *roots)
{
    double x, at[3];
    if (at_low[1] * at_high[1] >= 0.0) {
        if ((at_low[0] < 0.0) != (at_high[0] < 0.0)) {
            manseur_doty_add_root(roots, manseur_doty_between(f, 0, low, high, at_low[0] < 0.0), 0);
        }
        return;
    }
    x = manseur_doty_between(f, 1, low, high, at_low[1] < 0.0);
    manseur_doty_at(f, cos(x), sin(x), at);
    if (fabs(at[0]) <= f->rounding ||
        (at[0] * at[2] > 0.0 && fabs(at[0]) <= fabs(at[2]) * 5e-09)) {
        manseur_doty_add_root(roots, x, 1);
        return;
    }
    if ((at_low[0] < 0.0) != (at[0] < 0.0)) {
        manseur_doty_add_root(roots, manseur_doty_between(f, 0, low, x, at_low[0] < 0.0), 0);
    }
    if ((at_high[0] < 0.0) != (at[0] < 0.0)) {
        manseur_doty_add_root(roots, manseur_doty_between(f, 0, x, high, at[0] < 0.0), 0);
    }
}

/* What is known about f between two angles. */
enum { MANSEUR_DOTY_ROOTLESS, MANSEUR_DOTY_FLAT, MANSEUR_DOTY_TAME, MANSEUR_DOTY_WILD };

/* Rootless; flat, nothing but rounding; tame, with one extremum at most; or none of these. The
 * Bernstein coefficients of the quintic through f, f', f'' at both ends and their differences bound
 * f, f' and f''. */
static int manseur_doty_kind(const manseur_doty_trigonometric *f, const double low[3], const double
    high[3],
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
        return MANSEUR_DOTY_ROOTLESS;
    }
    if (least[0] >= -f->rounding && most[0] <= f->rounding) {
        return MANSEUR_DOTY_FLAT;
    }
    /* what rounding does to f' and f'' shrinks with the width, down to that of the quintic's ends
     * */
    return least[1] > doubt * part || most[1] < -doubt * part || least[2] > doubt * square ||
                   most[2] < -doubt * square
               ? MANSEUR_DOTY_TAME
               : MANSEUR_DOTY_WILD;
}

/* The roots of a cell where f may turn more than once: halve it until it does not. */
static void manseur_doty_many(const manseur_doty_trigonometric *f, double low, double high,
                         const double first[3], const double last[3], int *budget,
                         manseur_doty_roots *roots)
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
        const int kind = manseur_doty_kind(f, at_low, at[top], h);
        if (kind != MANSEUR_DOTY_ROOTLESS) {
            if (kind == MANSEUR_DOTY_TAME) {
                manseur_doty_few(f, low, at_low, edge[top], at[top], roots);
            } else if (kind == MANSEUR_DOTY_FLAT || depth[top] == 14 || *budget == 0) {
                roots->complete = 0;
                manseur_doty_add_root(roots, low + 0.5 * h, 1);
            } else {
                *budget -= 1;
                edge[open] = low + 0.5 * h;
                depth[top] += 1;
                depth[open] = depth[top];
                manseur_doty_at(f, cos(edge[open]), sin(edge[open]), at[open]);
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
static void manseur_doty_refine(const manseur_doty_trigonometric *f, const manseur_doty_grid *g,
    const int *cell,
                           int count, double *cosine, double *sine)
{
    const double h = 0.02454369260617026;
    for (int from = 0; from < count; from += MANSEUR_DOTY_LANES) {
        double in[8][MANSEUR_DOTY_LANES];
        manseur_doty_lane c, s, low, high, x, value, slope, cm, sm;
        for (int k = 0; k < MANSEUR_DOTY_LANES; k++) {
            const int i = cell[from + k < count ? from + k : count - 1];
            const int half = i % 128;
            in[0][k] = g->value[i];
            in[1][k] = g->value[i + 1];
            in[2][k] = h * g->slope[i];
            in[3][k] = h * g->slope[i + 1];
            in[4][k] = h * h * g->bend[i];
            in[5][k] = h * h * g->bend[i + 1];
            in[6][k] = i < 128 ? manseur_doty_grid_c[0][half] : -manseur_doty_grid_c[0][half];
            in[7][k] = i < 128 ? manseur_doty_grid_s[0][half] : -manseur_doty_grid_s[0][half];
        }
        const manseur_doty_lane f0 = MANSEUR_DOTY_LOAD(in[0]), f1 = MANSEUR_DOTY_LOAD(in[1]), d0 =
            MANSEUR_DOTY_LOAD(in[2]);
        const manseur_doty_lane s0 = MANSEUR_DOTY_LOAD(in[4]);
        const manseur_doty_lane D = f1 - f0 - d0 - 0.5 * s0, D1 = MANSEUR_DOTY_LOAD(in[3]) - d0 -
            s0;
        const manseur_doty_lane D2 = MANSEUR_DOTY_LOAD(in[5]) - s0;
        const manseur_doty_lane q3 = 10.0 * D - 4.0 * D1 + 0.5 * D2, q4 = 7.0 * D1 - 15.0 * D - D2;
        const manseur_doty_lane q5 = 6.0 * D - 3.0 * D1 + 0.5 * D2;
        const manseur_doty_lane rising = manseur_doty_with_sign(manseur_doty_all(1.0), f1 - f0);
        low = manseur_doty_all(0.0);
        high = manseur_doty_all(1.0);
        x = f0 / (f0 - f1);
        for (int i = 0; i < 4; i++) {
            value = f0 + x * (d0 + x * (0.5 * s0 + x * (q3 + x * (q4 + x * q5))));
            slope = d0 + x * (s0 + x * (3.0 * q3 + x * (4.0 * q4 + x * (5.0 * q5))));
            low = manseur_doty_select(value * rising < 0.0, x, low);
            high = manseur_doty_select(value * rising < 0.0, high, x);
            x = x - value / slope;
            x = manseur_doty_select((x >= low) & (x <= high), x, 0.5 * (low + high));
        }
        x *= h;
        for (int i = 0; i < 2; i++) {
            const manseur_doty_lane u = x * x, c0 = i ? c : MANSEUR_DOTY_LOAD(in[6]), s_0 = i ? s :
                MANSEUR_DOTY_LOAD(in[7]);
            const manseur_doty_lane dc = 1.0 - u * (0.5 - u * (1.0 / 24.0 - u * (1.0 / 720.0)));
            const manseur_doty_lane ds =
                x * (1.0 - u * (1.0 / 6.0 - u * (1.0 / 120.0 - u * (1.0 / 5040.0))));
            c = c0 * dc - s_0 * ds;
            s = s_0 * dc + c0 * ds;
            if (i) {
                break;
            }
            value = manseur_doty_all(f->a[0]);
            slope = manseur_doty_all(0.0);
            cm = c;
            sm = s;
            for (int m = 1; m < 9; m++) {
                const manseur_doty_lane next = cm * c - sm * s;
                value += f->a[m] * cm + f->b[m] * sm;
                slope += m * (f->b[m] * cm - f->a[m] * sm);
                sm = sm * c + cm * s;
                cm = next;
            }
            x = manseur_doty_max(manseur_doty_min(-value / slope, manseur_doty_all(1e-3 * h)),
                manseur_doty_all(-1e-3 * h));
        }
        MANSEUR_DOTY_STORE(cosine + from, c);
        MANSEUR_DOTY_STORE(sine + from, s);
    }
}

static int manseur_doty_lowest(unsigned long long bits)
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

static void manseur_doty_find_roots(const manseur_doty_trigonometric *f, manseur_doty_roots *roots)
{
    manseur_doty_grid g;
    int plain[MANSEUR_DOTY_ROOTS], special[256], plains = 0, specials = 0;
    int budget = 100; /* against an f that is next to nothing for long stretches */
    const double h = 0.02454369260617026;
    manseur_doty_fill_grid(f, &g);
    roots->doubles = 0;
    roots->complete = 1;
    for (int word = 0; word < 256 / 64; word++) {
        unsigned long long bits =
            manseur_doty_open_cells(&g, 64 * word, f->rounding + f->scale * 2e-09);
        for (; bits; bits &= bits - 1) {
            const int i = 64 * word + manseur_doty_lowest(bits);
            const double low[3] = {g.value[i], g.slope[i], g.bend[i]};
            const double high[3] = {g.value[i + 1], g.slope[i + 1], g.bend[i + 1]};
            if (low[1] * high[1] > 0.0 && plains < MANSEUR_DOTY_ROOTS &&
                manseur_doty_kind(f, low, high, h) == MANSEUR_DOTY_TAME) {
                if ((low[0] < 0.0) != (high[0] < 0.0)) {
                    plain[plains++] = i;
                }
            } else {
                special[specials++] = i;
            }
        }
    }
    manseur_doty_refine(f, &g, plain, plains, roots->c, roots->s);
    roots->simple = plains;
    for (int k = 0; k < specials; k++) {
        const int i = special[k];
        /* the edges' own values, so that neighbouring cells agree about their signs */
        const double low[3] = {g.value[i], g.slope[i], g.bend[i]};
        const double high[3] = {g.value[i + 1], g.slope[i + 1], g.bend[i + 1]};
        if (manseur_doty_kind(f, low, high, h) == MANSEUR_DOTY_TAME) {
            manseur_doty_few(f, i * h, low, (i + 1) * h, high, roots);
        } else {
            manseur_doty_many(f, i * h, (i + 1) * h, low, high, &budget, roots);
        }
    }
}

/* Candidates: the hidden angle and a null vector, (x3, 1) x (x2^2, x2, 1) times anything. The
 * simple
 * roots come first, one candidate each; after them those of roots that may be double, `group` being
 * the same for all that belong to one such root. */
typedef struct {
    int count, groups, group[MANSEUR_DOTY_CANDIDATES];
    double c[MANSEUR_DOTY_CANDIDATES], s[MANSEUR_DOTY_CANDIDATES], n[6][MANSEUR_DOTY_CANDIDATES];
} manseur_doty_candidates;

/* a rigid transform for each lane */
typedef manseur_doty_lane manseur_doty_rigid[3][4];

/* x = U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal */
static inline void manseur_doty_inverse_iteration(manseur_doty_lane U[6][6], const manseur_doty_lane
    inverse[6],
                                             manseur_doty_lane x[6])
{
    manseur_doty_lane square = {0};
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
    square = 1.0 / manseur_doty_sqrt(square);
    for (int i = 0; i < 6; i++) {
        x[i] *= square;
    }
}

/* The reciprocals of a diagonal, kept finite. */
static inline void manseur_doty_reciprocals(manseur_doty_lane U[6][6], manseur_doty_lane inverse[6])
{
    manseur_doty_lane most = manseur_doty_abs(U[0][0]);
    for (int i = 1; i < 6; i++) {
        most = manseur_doty_max(most, manseur_doty_abs(U[i][i]));
    }
    most = most * 1e-15 + 1e-300;
    for (int i = 0; i < 6; i++) {
        const manseur_doty_lane d = U[i][i];
        inverse[i] = 1.0 / manseur_doty_select(manseur_doty_abs(d) > most, d,
            manseur_doty_with_sign(most, d));
    }
}

/* One candidate for each simple root. */
static void manseur_doty_null_vectors(const double *E, const manseur_doty_roots *roots,
                                 manseur_doty_candidates *out)
{
    static const double start[6] = { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 };
    for (int from = 0; from < roots->simple; from += MANSEUR_DOTY_LANES) {
        double cs[2][MANSEUR_DOTY_LANES];
        manseur_doty_lane factor[6][6], inverse[6], x[6], c, s;
        for (int k = 0; k < MANSEUR_DOTY_LANES; k++) {
            const int i = from + k < roots->simple ? from + k : from;
            cs[0][k] = roots->c[i];
            cs[1][k] = roots->s[i];
        }
        c = MANSEUR_DOTY_LOAD(cs[0]);
        s = MANSEUR_DOTY_LOAD(cs[1]);
        (void)manseur_doty_fold(E, c, s, factor);
        manseur_doty_reciprocals(factor, inverse);
        for (int i = 0; i < 6; i++) {
            x[i] = manseur_doty_all(start[i]);
        }
        manseur_doty_inverse_iteration(factor, inverse, x);
        manseur_doty_inverse_iteration(factor, inverse, x);
        MANSEUR_DOTY_STORE(out->c + from, c);
        MANSEUR_DOTY_STORE(out->s + from, s);
        for (int i = 0; i < 6; i++) {
            MANSEUR_DOTY_STORE(out->n[i] + from, x[i]);
        }
    }
    out->count = roots->simple;
    out->groups = 0;
}

static void manseur_doty_add_candidate(manseur_doty_candidates *out, double c, double s, const
    double n[6])
{
    if (out->count == MANSEUR_DOTY_CANDIDATES) {
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
static void manseur_doty_split(double n[2][6], int rows, const int *up, const int *down, double c,
                          double s, manseur_doty_candidates *out)
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
        manseur_doty_add_candidate(out, c, s, sum);
    }
}

/* Candidates where two roots may have met: the null space may be a plane, which is split where one
 * of the two shifts, x3 or x2, has an eigenvalue. */
static void manseur_doty_null_plane(const double *E, double c, double s, manseur_doty_candidates
    *out)
{
    static const int up_3[3] = {0, 1, 2}, down_3[3] = {3, 4, 5};
    static const int up_2[4] = {0, 1, 3, 4}, down_2[4] = {1, 2, 4, 5};
    static const double start[2][6] = {
        { 0.61, -0.37, 0.53, 0.29, 0.71, -0.43 },
        { -0.31, 0.47, 0.59, 0.67, -0.23, 0.41 },
    };
    manseur_doty_lane factor[6][6], inverse[6], x[2][6];
    double n[2][6];
    (void)manseur_doty_fold(E, manseur_doty_all(c), manseur_doty_all(s), factor);
    manseur_doty_reciprocals(factor, inverse);
    for (int i = 0; i < 6; i++) {
        x[0][i] = manseur_doty_all(start[0][i]);
        x[1][i] = manseur_doty_all(start[1][i]);
    }
    for (int step = 0; step < 4; step++) {
        manseur_doty_lane along = {0};
        manseur_doty_inverse_iteration(factor, inverse, x[0]);
        manseur_doty_inverse_iteration(factor, inverse, x[1]);
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
            n[r][i] = manseur_doty_largest(x[r][i]);
            length += n[r][i] * n[r][i];
        }
        length = sqrt(length) + 1e-300;
        for (int i = 0; i < 6; i++) {
            n[r][i] /= length;
        }
    }
    manseur_doty_add_candidate(out, c, s, n[0]);
    manseur_doty_split(n, 3, up_3, down_3, c, s, out);
    manseur_doty_split(n, 4, up_2, down_2, c, s, out);
    out->groups++;
}

/* T Rz */
static inline void manseur_doty_turn(manseur_doty_rigid T, manseur_doty_lane c, manseur_doty_lane s)
{
    for (int i = 0; i < 3; i++) {
        const manseur_doty_lane x = T[i][0];
        T[i][0] = x * c + T[i][1] * s;
        T[i][1] = T[i][1] * c - x * s;
    }
}

/* T K, the same K for every lane */
static inline void manseur_doty_follow(manseur_doty_rigid T, const double K[12])
{
    for (int i = 0; i < 3; i++) {
        const manseur_doty_lane x = T[i][0], y = T[i][1], z = T[i][2];
        for (int j = 0; j < 3; j++) {
            T[i][j] = x * K[j] + y * K[4 + j] + z * K[8 + j];
        }
        T[i][3] += x * K[3] + y * K[7] + z * K[11];
    }
}

static inline void manseur_doty_begin(manseur_doty_rigid T, const double K[12])
{
    for (int i = 0; i < 12; i++) {
        T[i / 4][i % 4] = manseur_doty_all(K[i]);
    }
}

/* The terms a c + b s + w of five invariants of B = Rz K Rz(phi5) M Rz: l_z, p_z, p.l, p.p / 2 and
 * (p x l)_z; and the 2x5 matrix that solves them for c and s by least squares. */
static void manseur_doty_invariants(const double K[12], const double M[12], double w[5],
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

static inline void manseur_doty_to_unit(manseur_doty_lane *c, manseur_doty_lane *s)
{
    const manseur_doty_lane square = *c * *c + *s * *s, factor = 1.0 / manseur_doty_sqrt(square +
        1e-300);
    *c = manseur_doty_select(square > 1e-300, *c * factor, manseur_doty_all(1.0));
    *s = manseur_doty_select(square > 1e-300, *s * factor, manseur_doty_all(0.0));
}

/* phi_2 and phi_3 from the null vector */
static inline void manseur_doty_partners(const manseur_doty_lane n[6], manseur_doty_lane c[6],
    manseur_doty_lane s[6])
{
    const manseur_doty_lane up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const manseur_doty_lane down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5];
    manseur_doty_lane row[3], sign, top, bottom;
    for (int i = 0; i < 3; i++) {
        row[i] = manseur_doty_select(up > down, n[i], n[3 + i]);
    }
    sign = manseur_doty_with_sign(manseur_doty_all(1.0), row[0] + row[2]);
    c[1] = sign * (row[2] - row[0]);
    s[1] = sign * 2.0 * row[1];
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2];
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2];
    c[2] = bottom * bottom - top * top;
    s[2] = 2.0 * top * bottom;
    manseur_doty_to_unit(&c[1], &s[1]);
    manseur_doty_to_unit(&c[2], &s[2]);
}

/* phi_4, phi_5, phi_6 from phi_1, phi_2, phi_3; `w` and `solve` are those of the invariants. */
static inline void manseur_doty_others(double link[6][12], const double w[5], double solve[2][5],
                                  manseur_doty_lane c[6], manseur_doty_lane s[6])
{
    manseur_doty_rigid G, C;
    manseur_doty_lane l[3], q[3], value[5], x, y;
    manseur_doty_begin(G, link[5]);
    for (int i = 0; i < 3; i++) {
        manseur_doty_turn(G, c[i], s[i]);
        manseur_doty_follow(G, link[i]);
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
    c[4] = s[4] = manseur_doty_all(0.0);
    for (int i = 0; i < 5; i++) {
        c[4] += solve[0][i] * (value[i] - w[i]);
        s[4] += solve[1][i] * (value[i] - w[i]);
    }
    manseur_doty_to_unit(&c[4], &s[4]);
    manseur_doty_begin(C, link[3]);
    manseur_doty_turn(C, c[4], s[4]);
    manseur_doty_follow(C, link[4]);
    c[3] = C[0][2] * l[0] + C[1][2] * l[1] + C[0][3] * q[0] + C[1][3] * q[1];
    s[3] = C[0][2] * l[1] - C[1][2] * l[0] + C[0][3] * q[1] - C[1][3] * q[0];
    manseur_doty_to_unit(&c[3], &s[3]);
    c[5] = s[5] = manseur_doty_all(0.0);
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
    manseur_doty_to_unit(&c[5], &s[5]);
}

/* The loop's error at cosines and sines of the joints: translation and rotation vector that are
 * missing. J, when given, takes the rows of the Jacobian with the error as seventh column. Returns
 * the square of the error. */
static inline manseur_doty_lane manseur_doty_error(const double P[12], const manseur_doty_lane c[6],
                                         const manseur_doty_lane s[6], manseur_doty_lane J[6][7])
{
    static const double identity[12] = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    manseur_doty_rigid T;
    manseur_doty_lane z[6][3], o[6][3], S[3][3], square = {0}, trace;
    manseur_doty_begin(T, identity);
    for (int k = 0; k < 6; k++) {
        if (k) {
            manseur_doty_follow(T, manseur_doty_link[k - 1]);
        }
        for (int i = 0; i < 3; i++) {
            z[k][i] = T[i][2];
            o[k][i] = T[i][3];
        }
        manseur_doty_turn(T, c[k], s[k]);
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
    return manseur_doty_select(trace < 0.0, square + 1.0, square);
}

/* A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
 * next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
 * largest. */
static inline manseur_doty_lane manseur_doty_step(manseur_doty_lane J[6][7], manseur_doty_lane x[6])
{
    manseur_doty_lane *const row[6] = {J[0], J[1], J[2], J[3], J[4], J[5]};
    manseur_doty_lane most, least;
    const manseur_doty_lane zero = {0};
    manseur_doty_reflect(row, 6, 0, 7);
    manseur_doty_reflect(row + 1, 5, 1, 7);
    manseur_doty_reflect(row + 2, 4, 2, 7);
    manseur_doty_reflect(row + 3, 3, 3, 7);
    manseur_doty_reflect(row + 4, 2, 4, 7);
    most = least = manseur_doty_abs(J[0][0]);
    for (int i = 1; i < 6; i++) {
        most = manseur_doty_max(most, manseur_doty_abs(J[i][i]));
        least = manseur_doty_min(least, manseur_doty_abs(J[i][i]));
    }
    least /= most;
    most *= 1e-09;
    for (int i = 5; i >= 0; i--) {
        manseur_doty_lane sum = J[i][6];
        for (int j = i + 1; j < 6; j++) {
            sum -= J[i][j] * x[j];
        }
        sum /= J[i][i];
        sum = manseur_doty_max(manseur_doty_min(sum, zero + 1.0), zero - 1.0);
        x[i] = manseur_doty_select(manseur_doty_abs(J[i][i]) > most, sum, zero);
    }
    return least;
}

/* The same damped, for starts far away and for singular solutions: (J' J + d) x = J' error. */
static inline void manseur_doty_damped_step(manseur_doty_lane J[6][7], manseur_doty_lane damping,
    manseur_doty_lane x[6])
{
    manseur_doty_lane A[6][7];
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
        const manseur_doty_lane pivot = 1.0 / (A[i][i] + 1e-30);
        for (int j = i + 1; j < 6; j++) {
            const manseur_doty_lane factor = A[i][j] * pivot;
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
        x[i] = manseur_doty_max(manseur_doty_min(x[i], manseur_doty_all(1.0)),
            manseur_doty_all(-1.0));
    }
}

/* Newton on the loop; what remains in c and s is the best iterate, and its error is returned. */
static inline manseur_doty_lane manseur_doty_polish(const double P[12], manseur_doty_lane c[6],
    manseur_doty_lane s[6],
                                          int steps, int afar)
{
    manseur_doty_lane J[6][7], x[6], tc[6], ts[6], least, now;
    for (int i = 0; i < 6; i++) {
        tc[i] = c[i];
        ts[i] = s[i];
    }
    least = now = manseur_doty_error(P, c, s, J);
    for (int step = 0; step < steps; step++) {
        manseur_doty_mask better;
        if (manseur_doty_largest(least) < 1e-29) {
            break;
        }
        if (afar) {
            manseur_doty_damped_step(J, manseur_doty_min(now * 0.01, manseur_doty_all(0.01)), x);
        } else {
            (void)manseur_doty_step(J, x);
        }
        for (int i = 0; i < 6; i++) {
            /* a turn by 2 atan(x/2), without trigonometry */
            const manseur_doty_lane u = 0.25 * x[i] * x[i], f = 1.0 / (1.0 + u);
            const manseur_doty_lane dc = (1.0 - u) * f, ds = x[i] * f, old = tc[i];
            tc[i] = old * dc - ts[i] * ds;
            ts[i] = ts[i] * dc + old * ds;
        }
        now = manseur_doty_error(P, tc, ts, J);
        better = now < least;
        for (int i = 0; i < 6; i++) {
            c[i] = manseur_doty_select(better, tc[i], c[i]);
            s[i] = manseur_doty_select(better, ts[i], s[i]);
        }
        least = manseur_doty_select(better, now, least);
    }
    return manseur_doty_sqrt(least);
}

/* The solutions found so far. */
typedef struct {
    int count;
    unsigned singular; /* bit i: the arm is singular at solution i */
    int doubles; /* roots that met */
    double q[16][6], residual[16];
} manseur_doty_found;

/* The largest difference of two joint vectors, modulo turns. */
static double manseur_doty_gap(const double a[6], const double b[6])
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
static int manseur_doty_keep(manseur_doty_found *found, double theta[6], double residual)
{
    if (!(residual <= 1e-10)) {
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (manseur_doty_gap(found->q[i], theta) < 1e-06) {
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
static unsigned manseur_doty_offer(const double P[12], manseur_doty_lane c[6], manseur_doty_lane
    s[6], int count,
                              int steps, int doubtful, manseur_doty_found *found,
                              int place[MANSEUR_DOTY_LANES])
{
    double residual[MANSEUR_DOTY_LANES], theta[6][MANSEUR_DOTY_LANES], pivot[MANSEUR_DOTY_LANES] =
        {0.0};
    unsigned met = 0;
    MANSEUR_DOTY_STORE(residual, manseur_doty_polish(P, c, s, steps, steps > 4));
    if (doubtful) {
        manseur_doty_lane J[6][7], x[6];
        (void)manseur_doty_error(P, c, s, J);
        MANSEUR_DOTY_STORE(pivot, manseur_doty_step(J, x));
    }
    for (int i = 0; i < 6; i++) {
        MANSEUR_DOTY_STORE(theta[i], manseur_doty_angle(s[i], c[i]));
    }
    for (int k = 0; k < count; k++) {
        double row[6];
        for (int i = 0; i < 6; i++) {
            /* half a turn is +pi, also when rounding says otherwise */
            row[i] = theta[i][k] < -3.141592653589783 ? 3.141592653589793 : theta[i][k];
        }
        place[k] = manseur_doty_keep(found, row, residual[k]);
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
static void manseur_doty_close_roots(const double *E, const manseur_doty_roots *roots,
    manseur_doty_candidates *out)
{
    for (int i = 0; i < roots->simple; i++) {
        for (int j = 0; j < i; j++) {
            const double c = roots->c[i] + roots->c[j], s = roots->s[i] + roots->s[j];
            const double square = c * c + s * s;
            if (square > 3.999999) {
                const double factor = 1.0 / sqrt(square);
                manseur_doty_null_plane(E, c * factor, s * factor, out);
            }
        }
    }
}

static int manseur_doty_bits(unsigned set)
{
    int count = 0;
    for (; set; set &= set - 1) {
        count++;
    }
    return count;
}

/* Whether the number of regular solutions is even. */
static int manseur_doty_paired(const manseur_doty_found *found)
{
    return (found->count - manseur_doty_bits(found->singular)) % 2 == 0;
}

/* Polish all candidates of a formulation. The certificate: every simple root leads to a solution,
 * there
 * is another one for each of them and two more for each double root, or a singular one; and regular
 * solutions come in pairs. */
static int manseur_doty_settle(const manseur_doty_formulation *form, const double P[12],
                          const manseur_doty_candidates *all, int simple, int doubles,
                          manseur_doty_found *found)
{
    double link[6][12], w[5], solve[2][5];
    unsigned met = 0, of_group[MANSEUR_DOTY_CANDIDATES] = {0};
    int complete = 1, expected = simple;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 12; j++) {
            link[i][j] = form->link[i][j];
        }
    }
    if (form->sign > 0.0) {
        manseur_doty_invert(P, link[form->pose]);
    } else {
        for (int j = 0; j < 12; j++) {
            link[form->pose][j] = P[j];
        }
    }
    manseur_doty_invariants(link[3], link[4], w, solve);
    for (int from = 0; from < all->count; from += MANSEUR_DOTY_LANES) {
        const int count = all->count - from < MANSEUR_DOTY_LANES ? all->count - from :
            MANSEUR_DOTY_LANES;
        manseur_doty_lane n[6], c[6], s[6], tc[6], ts[6];
        int place[MANSEUR_DOTY_LANES];
        c[0] = MANSEUR_DOTY_LOAD(all->c + from);
        s[0] = MANSEUR_DOTY_LOAD(all->s + from);
        for (int i = 0; i < 6; i++) {
            n[i] = MANSEUR_DOTY_LOAD(all->n[i] + from);
        }
        manseur_doty_partners(n, c, s);
        manseur_doty_others(link, w, solve, c, s);
        for (int i = 0; i < 6; i++) {
            tc[form->joint[i]] = c[i];
            ts[form->joint[i]] = form->sign * s[i];
        }
        met |= manseur_doty_offer(P, tc, ts, count, 4, from + count > simple, found, place);
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
    return complete && manseur_doty_bits(met) >= expected && manseur_doty_paired(found);
}

/* Find what a formulation finds; whether that is certainly everything. */
static int manseur_doty_attempt(const manseur_doty_formulation *form, const double P[12],
                           manseur_doty_found *found)
{
    double E[168], samples[24];
    manseur_doty_trigonometric f;
    manseur_doty_roots roots;
    manseur_doty_candidates all;
    manseur_doty_equations(form, P, E);
    for (int k = 0; k < 24; k += MANSEUR_DOTY_LANES) {
        manseur_doty_lane factor[6][6];
        MANSEUR_DOTY_STORE(samples + k, manseur_doty_fold(E, MANSEUR_DOTY_LOAD(manseur_doty_sample_c
            + k),
                                   MANSEUR_DOTY_LOAD(manseur_doty_sample_s + k), factor));
    }
    manseur_doty_fit(samples, &f);
    if (!(f.noise <= 1e-06)) {
        return 0;
    }
    manseur_doty_find_roots(&f, &roots);
    manseur_doty_null_vectors(E, &roots, &all);
    manseur_doty_close_roots(E, &roots, &all);
    for (int i = 0; i < roots.doubles; i++) {
        manseur_doty_null_plane(E, roots.double_c[i], roots.double_s[i], &all);
    }
    found->doubles += roots.doubles;
    return manseur_doty_settle(form, P, &all, roots.simple, roots.doubles, found) && roots.complete;
}

/* Find what the methods find, one after the other, until that is certainly everything. */
static int manseur_doty_try(const double P[12], manseur_doty_found *found)
{
    int complete = 0;
    for (int i = 0; i < 2 && !complete; i++) {
        complete = manseur_doty_attempt(&manseur_doty_formulations[i], P, found);
    }
    return complete;
}

/* Newton from joint angles (count, 6) far from or near to solutions. */
static unsigned manseur_doty_follow_back(const double P[12], double (*start)[6], int count,
                                    manseur_doty_found *found, int *lost)
{
    unsigned met = 0;
    for (int from = 0; from < count; from += MANSEUR_DOTY_LANES) {
        const int now = count - from < MANSEUR_DOTY_LANES ? count - from : MANSEUR_DOTY_LANES;
        double cs[2][6][MANSEUR_DOTY_LANES];
        manseur_doty_lane c[6], s[6];
        int place[MANSEUR_DOTY_LANES];
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < MANSEUR_DOTY_LANES; k++) {
                const double angle = start[from + (k < now ? k : 0)][i];
                cs[0][i][k] = cos(angle);
                cs[1][i][k] = sin(angle);
            }
            c[i] = MANSEUR_DOTY_LOAD(cs[0][i]);
            s[i] = MANSEUR_DOTY_LOAD(cs[1][i]);
        }
        met |= manseur_doty_offer(P, c, s, now, 40, 1, found, place);
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
static int manseur_doty_from_nearby(const double P[12], manseur_doty_found *found)
{
    int followed = 0, before = -1;
    for (int n = 0; n < 10; n++) {
        double nearby[12];
        manseur_doty_found other;
        int complete, count = -1, lost = 0;
        unsigned met;
        manseur_doty_compose(P, manseur_doty_nudge[n], nearby);
        other.count = 0;
        other.singular = 0;
        other.doubles = 0;
        complete = manseur_doty_try(nearby, &other);
        met = manseur_doty_follow_back(P, other.q, other.count, found, &lost);
        if (complete && !lost && met) {
            count = manseur_doty_bits(met) == other.count ? other.count : -1;
            followed |= (met & found->singular) != 0;
        }
        if (n % 2 && before == found->count && count == found->count && !found->singular &&
            manseur_doty_paired(found)) {
            return 1;
        }
        before = count;
    }
    return followed && manseur_doty_paired(found);
}

/* Newton from many starts, the same on every run. */
static void manseur_doty_from_anywhere(const double P[12], manseur_doty_found *found)
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
        (void)manseur_doty_follow_back(P, start, 8, found, &lost);
    }
}

/* Singular solutions are known less well: those that lie together become one. */
static void manseur_doty_merge(manseur_doty_found *found)
{
    const unsigned singular = found->singular;
    unsigned kept = 0;
    int count = 0;
    for (int i = 0; i < found->count; i++) {
        int known = 0;
        for (int j = 0; j < count && singular >> i & 1u; j++) {
            known |= (kept >> j & 1u) && manseur_doty_gap(found->q[i], found->q[j]) < 0.001;
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
static int manseur_doty_before(const double a[6], const double b[6])
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
static int manseur_doty_general(const double T[16], double q[16][6], double residual[16])
{
    manseur_doty_found found;
    double P[12], half[12];
    int order[16], complete;
    manseur_doty_compose(manseur_doty_left, T, half);
    manseur_doty_compose(half, manseur_doty_right, P);
    for (int i = 0; i < 3; i++) {
        P[4 * i + 3] *= 0.6953580640433468;
    }
    found.count = 0;
    found.singular = 0;
    found.doubles = 0;
    if (P[3] * P[3] + P[7] * P[7] + P[11] * P[11] > 4.000000004) {
        return 0;
    }
    complete = manseur_doty_try(P, &found) || manseur_doty_from_nearby(P, &found);
    if (!complete) {
        manseur_doty_from_anywhere(P, &found);
    }
    manseur_doty_merge(&found);
    for (int i = 0; i < found.count; i++) {
        int j = i;
        for (; j > 0 && manseur_doty_before(found.q[i], found.q[order[j - 1]]); j--) {
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
    static const double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    struct descent d = { .T = T };
    struct kept kept = { .count = 0 };
    double angles[16][6], residual[16], u[6];
    const int count = manseur_doty_general(T, angles, residual);
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

static const double a1 = 0.3; /* link length 1 [m] */
static const double a2 = 1.0; /* link length 2 [m] */
static const double ca2 = 0.9998476951563913; /* cosine of twist 2 */
static const double sa2 = 0.01745240643728351; /* sine of twist 2 */
static const double d3 = 0.2; /* joint offset 3 [m] */
static const double a4 = 1.5; /* link length 4 [m] */

const char *const manseur_doty_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

void manseur_doty_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double y2_z = c2 * ca2;
    const double y2_x = s1 * sa2 - v1 * ca2;
    const double v3 = v2 * ca2 + c1 * sa2;
    const double v4 = c2 * sa2;
    const double z2_x = v1 * sa2 + s1 * ca2;
    const double z2_y = v2 * sa2 - c1 * ca2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 - v3 * s3;
    const double x3_z = s2 * c3 + y2_z * s3;
    const double z3_y = v3 * c3 + x2_y * s3;
    const double z3_x = x2_x * s3 - y2_x * c3;
    const double z3_z = s2 * s3 - y2_z * c3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 + z2_x * s4;
    const double x4_y = x3_y * c4 + z2_y * s4;
    const double x4_z = x3_z * c4 - v4 * s4;
    const double v5 = z2_x * c4 - x3_x * s4;
    const double v6 = z2_y * c4 - x3_y * s4;
    const double v7 = v4 * c4 + x3_z * s4;
    const double T14_ = c1 * a1 + x2_x * a2 + z2_x * d3 + x4_x * a4;
    const double T24_ = s1 * a1 + x2_y * a2 + z2_y * d3 + x4_y * a4;
    const double T34_ = s2 * a2 - v4 * d3 + x4_z * a4;
    const double y4_x = ca2 * v5 + sa2 * z3_x;
    const double y4_y = ca2 * v6 + sa2 * z3_y;
    const double y4_z = sa2 * z3_z - ca2 * v7;
    const double z4_x = ca2 * z3_x - sa2 * v5;
    const double z4_y = ca2 * z3_y - sa2 * v6;
    const double z4_z = sa2 * v7 + ca2 * z3_z;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 + y4_x * s5;
    const double x5_y = x4_y * c5 + y4_y * s5;
    const double x5_z = x4_z * c5 + y4_z * s5;
    const double z5_x = x4_x * s5 - y4_x * c5;
    const double z5_y = x4_y * s5 - y4_y * c5;
    const double z5_z = x4_z * s5 - y4_z * c5;
    const double c6 = cos(q[5]);
    const double s6 = sin(q[5]);
    const double T11_ = x5_x * c6 + z4_x * s6;
    const double T21_ = x5_y * c6 + z4_y * s6;
    const double T31_ = x5_z * c6 + z4_z * s6;
    const double v8 = z4_x * c6 - x5_x * s6;
    const double v9 = z4_y * c6 - x5_y * s6;
    const double v10 = z4_z * c6 - x5_z * s6;
    const double T12_ = ca2 * v8 + sa2 * z5_x;
    const double T22_ = ca2 * v9 + sa2 * z5_y;
    const double T32_ = ca2 * v10 + sa2 * z5_z;
    const double T13_ = ca2 * z5_x - sa2 * v8;
    const double T23_ = ca2 * z5_y - sa2 * v9;
    const double T33_ = ca2 * z5_z - sa2 * v10;
    T[0] = T11_; T[1] = T12_; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void manseur_doty_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]);
    const double s1 = sin(q[0]);
    const double p1_x = c1 * a1;
    const double p1_y = s1 * a1;
    const double c2 = cos(q[1]);
    const double s2 = sin(q[1]);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double v1 = c1 * s2;
    const double v2 = s1 * s2;
    const double p2_x = p1_x + x2_x * a2;
    const double p2_y = p1_y + x2_y * a2;
    const double p2_z = s2 * a2;
    const double y2_z = c2 * ca2;
    const double y2_x = s1 * sa2 - v1 * ca2;
    const double v3 = v2 * ca2 + c1 * sa2;
    const double v4 = c2 * sa2;
    const double J43 = v1 * sa2 + s1 * ca2;
    const double J53 = v2 * sa2 - c1 * ca2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + y2_x * s3;
    const double x3_y = x2_y * c3 - v3 * s3;
    const double x3_z = s2 * c3 + y2_z * s3;
    const double J54 = v3 * c3 + x2_y * s3;
    const double p3_x = p2_x + J43 * d3;
    const double p3_y = p2_y + J53 * d3;
    const double p3_z = p2_z - v4 * d3;
    const double J44 = x2_x * s3 - y2_x * c3;
    const double J64 = s2 * s3 - y2_z * c3;
    const double c4 = cos(q[3]);
    const double s4 = sin(q[3]);
    const double x4_x = x3_x * c4 + J43 * s4;
    const double x4_y = x3_y * c4 + J53 * s4;
    const double x4_z = x3_z * c4 - v4 * s4;
    const double v5 = J43 * c4 - x3_x * s4;
    const double v6 = J53 * c4 - x3_y * s4;
    const double v7 = v4 * c4 + x3_z * s4;
    const double J21 = p3_x + x4_x * a4;
    const double p4_y = p3_y + x4_y * a4;
    const double p4_z = p3_z + x4_z * a4;
    const double J45 = ca2 * J44 - sa2 * v5;
    const double J55 = ca2 * J54 - sa2 * v6;
    const double J65 = sa2 * v7 + ca2 * J64;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double J46 = x4_x * s5 - (ca2 * v5 + sa2 * J44) * c5;
    const double J56 = x4_y * s5 - (ca2 * v6 + sa2 * J54) * c5;
    const double J66 = x4_z * s5 - (sa2 * J64 - ca2 * v7) * c5;
    const double J32 = s1 * (p4_y - p1_y) + c1 * (J21 - p1_x);
    const double v8 = J21 - p2_x;
    const double v9 = p4_y - p2_y;
    const double v10 = p4_z - p2_z;
    const double J13 = J53 * v10 + v4 * v9;
    const double J33 = J43 * v9 - J53 * v8;
    const double v11 = J21 - p3_x;
    const double v12 = p4_y - p3_y;
    const double v13 = p4_z - p3_z;
    const double J14 = J54 * v13 - J64 * v12;
    const double J24 = J64 * v11 - J44 * v13;
    const double J34 = J44 * v12 - J54 * v11;
    J[0] = -p4_y; J[1] = -(c1 * p4_z); J[2] = J13; J[3] = J14; J[4] = 0.0; J[5] = 0.0;
    J[6] = J21; J[7] = -(s1 * p4_z); J[8] = -(v4 * v8 + J43 * v10); J[9] = J24; J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0; J[13] = J32; J[14] = J33; J[15] = J34; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = J43; J[21] = J44; J[22] = J45; J[23] = J46;
    J[24] = 0.0; J[25] = -c1; J[26] = J53; J[27] = J54; J[28] = J55; J[29] = J56;
    J[30] = 1.0; J[31] = 0.0; J[32] = -v4; J[33] = J64; J[34] = J65; J[35] = J66;
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
        status[row] = (chosen) ? MANSEUR_DOTY_FREE_JOINT : MANSEUR_DOTY_OK;
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

int manseur_doty_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16])
{
    static const double zeros[6] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    const int valid = read_pose(T, pose);
    for (int row = 0; row < 16; row++) {
        status[row] = valid ? MANSEUR_DOTY_UNREACHABLE : MANSEUR_DOTY_INVALID_POSE;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -MANSEUR_DOTY_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 16; row++) {
        if (status[row] == MANSEUR_DOTY_UNREACHABLE)
            continue;
        for (int i = 0; i < 6; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = MANSEUR_DOTY_OUT_OF_LIMITS;
        }
        count += status[row] != MANSEUR_DOTY_OUT_OF_LIMITS;
    }
    return count;
}

int manseur_doty_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -MANSEUR_DOTY_UNREACHABLE;
    for (int i = 0; i < 6; i++)
        q[i] = NAN;
    for (int i = 0; i < 6; i++)
        if (!isfinite(q_seed[i]))
            return -MANSEUR_DOTY_INVALID_POSE;
    if (manseur_doty_ik(T, q_seed, all, status) < 0)
        return -MANSEUR_DOTY_INVALID_POSE;
    for (int row = 0; row < 16; row++) {
        double distance = 0.0;
        if (status[row] == MANSEUR_DOTY_OUT_OF_LIMITS && result < 0)
            result = -MANSEUR_DOTY_OUT_OF_LIMITS;
        if (status[row] != MANSEUR_DOTY_OK && status[row] != MANSEUR_DOTY_FREE_JOINT)
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

void manseur_doty_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)manseur_doty_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
