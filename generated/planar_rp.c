/* planar_rp: Planar arm with a revolute and a prismatic joint
 *
 * Inverse kinematics, generated from robots/planar_rp.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rp.yaml. The formulas and where they come from:
 * planar_rp.md.
 */
#include "planar_rp.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PLANAR_RP_OK, NONE = PLANAR_RP_UNREACHABLE, FREE = PLANAR_RP_FREE_JOINT,
    OUT = PLANAR_RP_OUT_OF_LIMITS, INVALID = PLANAR_RP_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

#ifdef __GNUC__
#define HELPER __attribute__((unused)) static inline
#define APART __attribute__((noinline)) static
#define INLINED __attribute__((always_inline))
#else
#define HELPER static inline
#define APART static
#endif

#define maximum_double(a, b) ((a) > (b) ? (a) : (b))
#define minimum_double(a, b) ((a) < (b) ? (a) : (b))

#ifndef PLANAR_RP_LIBM
/* atan r = r + r^3 (odd[0] + odd[1] r^2 + ...) for |r| up to tan(pi/8) */
static const double odd[11] = {
    -0.3333333333333333, 0.19999999999995513, -0.14285714284665177, 0.11111111015146682,
    -0.0909090457366891, 0.07692183087347286, -0.0666450998991572, 0.05858136252639731,
    -0.050853834915688644, 0.039229744582632814, -0.01917454359469326,
};

/* The angle of y and x, not both zero and not infinite, in [-pi, pi], within 3 ulp: the multiple of
 * pi/4 next to it and a ratio of at most tan(pi/8), then a polynomial in this. In two steps: of
 * several angles all ratios come first. `added` is x + y where m holds, else x: for one pose, which
 * waits for its values, so that the sum doesn't wait for m. */
#define added_four(x, m, y) pick_four(m, (x) + (y), x)
#define added_wide(x, m, y) ((x) + only_wide(m, 1.0) * (y))
#define ARCTANGENT(v) \
typedef struct { v r, known, y; } v##_ratio; \
HELPER v##_ratio ratio_##v(v y, v x) \
{ \
    const v ax = abs_##v(x), ay = abs_##v(y); \
    const v##_mask steep = ay > ax; \
    const v most = maximum_##v(ay, ax), least = minimum_##v(ax, ay); \
    const v##_mask turned = least > most * 0.41421356237309515; \
    const v ahead = all_##v(0.7853981633974483), half = all_##v(1.5707963267948966); \
    const v part = negated_##v(pick_##v(steep, -ahead, ahead), x); \
    const v whole = pick_##v(steep, half, half - 2.0 * part); \
    const v up = added_##v(least, turned, -most), down = added_##v(most, turned, least); \
    return (v##_ratio){ negated_##v(up, part) / down, added_##v(whole, turned, part), y }; \
} \
HELPER v angle_##v(v##_ratio of) \
{ \
    const v r = of.r, u = r * r, u2 = u * u, u4 = u2 * u2; \
    const v p0 = (odd[0] + odd[1] * u) + (odd[2] + odd[3] * u) * u2; \
    const v p4 = (odd[4] + odd[5] * u) + (odd[6] + odd[7] * u) * u2; \
    const v p8 = (odd[8] + odd[9] * u) + odd[10] * u2; \
    const v p = p0 + (p4 + p8 * u4) * u4; \
    return negated_##v((of.known + r) + r * u * p, of.y); \
} \
HELPER v atan2_##v(v y, v x) { return angle_##v(ratio_##v(y, x)); }
#endif

/* Lanes: GNU vectors where compiler and machine have them, plain doubles otherwise and with
 * -DPLANAR_RP_SCALAR. With -DPLANAR_RP_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(PLANAR_RP_SCALAR) && !defined(PLANAR_RP_LIBM)
#include <immintrin.h>
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define LANES 8
#define pick_wide(m, yes, no) _mm512_mask_blend_pd(_mm512_movepi64_mask((__m512i)(m)), no, yes)
#define maximum_wide _mm512_max_pd
#define minimum_wide _mm512_min_pd
#define sqrt_wide _mm512_sqrt_pd
#define bits_wide(m) ((unsigned)_mm512_movepi64_mask((__m512i)(m)))
#else
#define LANES 4
#define pick_wide pick_four
#define maximum_wide maximum_four
#define minimum_wide minimum_four
#define sqrt_wide sqrt_four
#define bits_wide bits_four
#endif
#define pick_four(m, yes, no) _mm256_blendv_pd(no, yes, (__m256d)(m))
#define maximum_four _mm256_max_pd
#define minimum_four _mm256_min_pd
#define sqrt_four _mm256_sqrt_pd
#define bits_four(m) ((unsigned)_mm256_movemask_pd((__m256d)(m)))
#define where_four(truth) ((four_mask)_mm256_set1_epi64x(-(long long)(truth)))
#define shuffle __builtin_shufflevector
#define where_all(mask) (mask)

#define VECTOR(v, lanes) \
typedef double v __attribute__((vector_size(8 * lanes))); \
typedef v v##_at __attribute__((aligned(8), may_alias)); /* in memory */ \
typedef __typeof__((v){ 0 } < (v){ 0 }) v##_mask; \
HELPER v all_##v(double x) { return x - (v){ 0 }; } \
HELPER v only_##v(v##_mask m, double x) { return (v)(m & (v##_mask)all_##v(x)); } \
HELPER v copysign_##v(v x, v y) \
{ \
    const v##_mask sign = (v##_mask)all_##v(-0.0); \
    return (v)((sign & (v##_mask)y) | (~sign & (v##_mask)x)); \
} \
HELPER v signed_##v(double x, v y) { return copysign_##v(all_##v(x), y); } \
HELPER v negated_##v(v x, v where) { return (v)((v##_mask)x ^ (v##_mask)signed_##v(0.0, where)); } \
HELPER v abs_##v(v x) { return copysign_##v(x, all_##v(0.0)); }

VECTOR(four, 4)
VECTOR(wide, LANES)
ARCTANGENT(four)
#else
#define LANES 1
typedef double wide;
typedef int wide_mask;
#define all_wide(x) (x)
#define where_all(truth) (-(truth))
#define pick_wide(m, yes, no) ((m) ? (yes) : (no))
#define only_wide(m, x) ((m) ? (x) : 0.0)
#define copysign_wide copysign
#define signed_wide copysign
#define negated_wide(x, where) ((x) * copysign(1.0, where))
#define abs_wide fabs
#define sqrt_wide sqrt
#define maximum_wide maximum_double
#define minimum_wide minimum_double
#endif
#ifdef PLANAR_RP_LIBM /* half the time of atan2 */
HELPER double atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
ARCTANGENT(wide)
#endif

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16])
{
    return 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7]);
}

#if LANES > 1
/* Writes joint values of four rows. */
HELPER void store_4(
    double *r0, double *r1, double *r2, double *r3, four a, four b, four c, four d)
{
    const four ab0 = shuffle(a, b, 0, 4, 2, 6), ab1 = shuffle(a, b, 1, 5, 3, 7);
    const four cd0 = shuffle(c, d, 0, 4, 2, 6), cd1 = shuffle(c, d, 1, 5, 3, 7);
    *(four_at *)r0 = shuffle(ab0, cd0, 0, 1, 4, 5);
    *(four_at *)r1 = shuffle(ab1, cd1, 0, 1, 4, 5);
    *(four_at *)r2 = shuffle(ab0, cd0, 2, 3, 6, 7);
    *(four_at *)r3 = shuffle(ab1, cd1, 2, 3, 6, 7);
}

typedef double two_at __attribute__((vector_size(16), aligned(8), may_alias)); /* in memory */

HELPER void store_2(double *r0, double *r1, double *r2, double *r3, four a, four b)
{
    const four first = shuffle(a, b, 0, 4, 2, 6);
    const four second = shuffle(a, b, 1, 5, 3, 7);
    *(two_at *)r0 = shuffle(first, first, 0, 1);
    *(two_at *)r1 = shuffle(second, second, 0, 1);
    *(two_at *)r2 = shuffle(first, first, 2, 3);
    *(two_at *)r3 = shuffle(second, second, 2, 3);
}

HELPER four irregularity_four(const double T[16])
{
    return all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7]));
}

/* Rows to columns. */
HELPER void transpose(wide x[LANES])
{
#if LANES == 8
    wide y[8];
    for (int k = 0; k < 8; k += 2) {
        y[k] = shuffle(x[k], x[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        y[k + 1] = shuffle(x[k], x[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int i = 0; i < 4; i++) {
        const int k = i + (i & 2); /* 0, 1, 4, 5 */
        x[k] = shuffle(y[k], y[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        x[k + 2] = shuffle(y[k], y[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (int k = 0; k < 4; k++) {
        y[k] = x[k];
        x[k] = shuffle(y[k], x[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        x[k + 4] = shuffle(y[k], x[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
#else
    double y[16];
    store_4(y, y + 4, y + 8, y + 12, x[0], x[1], x[2], x[3]);
    for (int k = 0; k < 4; k++)
        x[k] = *(const wide_at *)(y + 4 * k);
#endif
}
#endif

/* An angle moved by a whole turn to (-pi, pi] if it is below, above, or either. */
#define TURNS(v) \
HELPER v raised_##v(v x) { return x + only_##v(x <= -half_turn, turn); } \

TURNS(wide)
#if LANES > 1
TURNS(four)
#endif

#define low(joint) (lowest[joint - 1] - slack(joint - 1))
#define high(joint) (highest[joint - 1] + slack(joint - 1))
/* How far a joint is beyond its limits; whether by rounding, perhaps. */
#define grazes(x) (abs_wide((x) - 5e-07) <= 5e-07)
#define grazes_four(x) (abs_four((x) - 5e-07) <= 5e-07)
#define beyond(x, joint) maximum_wide(low(joint) - (x), (x) - high(joint))
#define beyond_four(x, joint) maximum_four(low(joint) - (x), (x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    free_limit1 = 1e-12, /* a length that fixes no angle [m] */
    offset1 = 1.5707963267948966, /* offset of joint 1 [rad] */
    m1 = 9.999999999999999e-09; /* doubt_limit1^2 [m^2] */

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T14 = T[3]; \
    const number T24 = T[7]

const char *const planar_rp_branches[2] = {
    "forward", "backward",
};

static const double lowest[2] = { -INFINITY, 0.0 };
static const double highest[2] = { INFINITY, 1.0 };
static const int revolute[2] = { 1, 0 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[2] = { 1.0, 1.0 };
#define slack(joint) 1e-09 /* of limits */
/* Of the values of a free joint that are tried, from one to the next. */
static const double fan_step[2] = { 0.09817477042468103, 0.03125 };

void planar_rp_fk(const double q[2], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1);
    T[0] = c1; T[1] = 0.0; T[2] = s1; T[3] = s1 * q[1];
    T[4] = s1; T[5] = 0.0; T[6] = -c1; T[7] = -(c1 * q[1]);
    T[8] = 0.0; T[9] = 1.0; T[10] = 0.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rp_jacobian(const double q[2], double J[12])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1);
    J[0] = c1 * q[1]; J[1] = s1;
    J[2] = s1 * q[1]; J[3] = -c1;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 1.0; J[11] = 0.0;
}

/* Copies a pose. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3] * T[3] * T[3]) && isfinite(T[7] * T[7] * T[7])))
        return 0;
    return 1;
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
static double beyond_limits(const double values[2])
{
    double sum = 0.0;
    for (int i = 0; i < 2; i++)
        sum += fabs(overshoot(i, values[i])) * sqrt(weight[i]);
    return sum;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[4], wide_mask kind[2])
{
    ENTRIES(wide);

    /* theta1, r2 */
    const wide v1 = T14 * T14 + T24 * T24, q2_p = sqrt_wide(v1);

    /* joint values */
    const wide angle1 = atan2_wide(T14, -T24), v2 = angle1 - offset1,
        v3 = angle1 - signed_wide(half_turn, T14) - offset1, excess_p = beyond(q2_p, 2),
        excess_m = maximum_wide(low(2) + q2_p, -(high(2) + q2_p));

    q[0] = raised_wide(v2); q[1] = q2_p;
    kind[0] = kind_of(q[0], 0.0 < excess_p);
    q[2] = raised_wide(v3); q[3] = -q2_p;
    kind[1] = kind_of(q[2], 0.0 < excess_m);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | (v1 <= m1) | (grazes(excess_p) | grazes(excess_m));
}

#if LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 1 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[2][2], unsigned char status[2])
{
    const four e1 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1, r2 */
    const double v1 = T14 * T14 + T24 * T24, w2 = sqrt(v1);

    /* joint values */
    const double v2 = copysign(half_turn, T14);
    const four q2 = e1 * w2, excess = beyond_four(q2, 2);
    const four_mask outside = 0.0 < excess;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0) | grazes_four(excess)) | (unsigned)(v1 <=
        m1))
        return -1;

    const four_ratio ratio1 = ratio_four((four){ T14, T14, T14, T14 }, (four){ -T24, -T24, -T24,
        -T24 });
    const four packed1 = angle_four(ratio1), angle1 = shuffle(packed1, packed1, 0, 0, 0, 0);
    const four v3 = angle1 + v2 * (m2 * (e1 - 1.0)) - offset1, q1 = raised_four(v3);

    store_2(&q[0][0], &q[1][0], &q[0][0], &q[1][0], q1, q2);
    const unsigned long long none1 = (bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long outside1 = (bits_four(outside) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * NONE + (outside1 & ~none1) * OUT;
    __builtin_memcpy(status + 0, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~(none1 | outside1));
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[4], x[LANES];
    wide_mask kind[2];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < LANES; k++)
            q[4 * k + i] = found[i][k];
    for (int i = 1; i < 2; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 2 * k, &word, 2);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(const double T[16], double q[2][2], unsigned char status[2])
{
    wide_mask kind[2];
    int count = 0;
    if (solve_wide(T, &q[0][0], kind))
        return -1;
    for (int row = 0; row < 2; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == 0;
    }
    return count;
}
#endif

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[2], double q[2][2], unsigned char status[2])
{
    ENTRIES(double);

    /* theta1, r2, type 4: U0[1, 4] and U0[2, 4] */
    const double w2 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w2 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w2;
    const double v1 = seed[0] + offset1;

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1, r2 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(v1) : -(T24 * factor1), s1 = free1 ? sin(v1) : T14 * factor1;
        const double r2 = w2 * e1;

        /* joint values */
        const double q1 = wrap(atan2(s1, c1) - offset1);
        const int row = i1;
        q[row][0] = q1; q[row][1] = r2;
        status[row] = (free1) ? FREE : OK;
    }
}

static void take(const double from[2], double to[2])
{
    for (int i = 0; i < 2; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const double *T;
    double seed[2], start, q[2][2];
    unsigned char status[2];
    int joint, row;
};

/* Solves with the joint moved: 0 if it serves, else less. */
static double attempt(struct search *s, double moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 2; i++)
        s->status[i] = NONE;
    solve(s->T, s->seed, s->q, s->status);
    if (s->status[s->row] == NONE)
        return -HUGE_VAL;
    return -beyond_limits(s->q[s->row]);
}

/* Golden section for a move that serves, or NaN. */
static double summit(struct search *s, double low, double high)
{
    for (int k = 0; k < 52; k++) {
        const double third = 0.3819660112501051 * (high - low);
        const double left = attempt(s, low + third), right = attempt(s, high - third);
        if (left == 0.0 || right == 0.0)
            return left == 0.0 ? low + third : high - third;
        if (left >= right)
            high -= third;
        else
            low += third;
    }
    return NAN;
}

/* How far a free joint has to be moved from the seed's value until it serves, or NaN: a fan of
 * values, golden section, bisection of the nearest end; of two equally near the lower one. */
static double serving_value(struct search *s)
{
    const double step = fan_step[s->joint];
    if (attempt(s, 0.0) == 0.0)
        return 0.0;
    double nearest = NAN, before, here = -HUGE_VAL, after = attempt(s, -32.0 * step);
    for (int k = -32; k <= 32; k++) {
        before = here;
        here = after;
        after = attempt(s, (double)(k + 1) * step);
        double outer = (double)k * step, inner = k > 0 ? outer - step : k < 0 ? outer + step : 0.0;
        if (here < 0.0 && here >= before && here > after)
            outer = summit(s, outer - step, outer + step);
        else if (here < 0.0 || (k > 0 ? before : after) == 0.0)
            continue;
        if (isnan(outer))
            continue;
        for (int i = 0; i < 52; i++) {
            const double middle = 0.5 * (inner + outer);
            if (attempt(s, middle) == 0.0)
                outer = middle;
            else
                inner = middle;
        }
        if (!(fabs(outer) >= fabs(nearest) - 1e-09))
            nearest = outer;
    }
    return nearest;
}

/* Whether a joint beyond its limits does not move with the one that is searched. */
static int hopeless(struct search *s)
{
    struct search other = *s;
    if (isinf(attempt(s, 0.0)) || isinf(attempt(&other, 0.1)))
        return 0;
    for (int i = 0; i < 2; i++) {
        const double value = s->q[s->row][i], moved = fabs(value - other.q[s->row][i]);
        if (moved < 1e-09 && fabs(overshoot(i, value)) > 0.0)
            return 1;
    }
    return 0;
}

/* A free joint took the seed's value, and that puts one beyond its limits: takes the nearest value
 * that keeps all, if there is one; other free joints the seed's, as far as their limits allow. */
static void keep_limits(
    const double T[16], const double seed[2], int row, double q[2][2], unsigned char status[2])
{
    static const int choosable[1] = { 0 };
    struct search search = { .T = T, .row = row };
    for (int i = 0; i < 2; i++)
        search.seed[i] = seed[i] - overshoot(i, seed[i]);
    for (int k = 0; k < 1; k++) {
        const int joint = search.joint = choosable[k];
        const double inside = search.seed[joint];
        search.start = revolute[joint] ? fmod(seed[joint], turn) : inside;
        const double nearest = hopeless(&search) ? (double)NAN : serving_value(&search);
        /* beside the solution of another row this one has none */
        if (!isnan(nearest) && (fabs(nearest) >= 1e-06 || !isinf(attempt(&search, 0.0)))) {
            attempt(&search, nearest);
            status[row] = search.status[row];
            take(search.q[row], q[row]);
            return;
        }
        search.seed[joint] = inside;
    }
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
static double half_way(const double x[2], const double q[2], double half[2])
{
    double most = 0.0;
    for (int i = 0; i < 2; i++) {
        double off = q[i] - x[i];
        off -= revolute[i] ? turn * floor(off / turn + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(weight[i]));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 1.0, 1.0, 0.0, 0.0, 0.0, 0.0 };
/* What a step of one means for joints; none if given. */
static const double pace[2] = { 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[2], double e[6])
{
    double P[16], square = 0.0;
    planar_rp_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[2], double damping, double e[6], double x[2])
{
    double A[6][8] = { { 0.0 } }, square[6] = { 0.0 }, J[12];
    planar_rp_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 2; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[2 * i + j];
        A[i][2 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 8; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 8; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 8; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 2; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[2])
{
    double x[2], half[2], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[2] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 2 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? overshoot(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 2; i++)
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
    const double T[16], int row, int far, double rows[2][2], const unsigned char status[2])
{
    double x[2], half[2], to[2], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 2; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double seed[2], double q[2][2],
    unsigned char status[2])
{
    double x[2], half[2], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    for (int i = 0; i < 2; i++)
        x[i] = seed[i] - overshoot(i, seed[i]);
    if (!settle(T, 1e-12, 0.15, x) || (beyond_limits(x) > 1e-09 && !settle(T, NAN, 0.15, x)))
        return;
    for (int row = 2 - 1; row >= 0; row--) {
        double between = 1e-06;
        if (status[row] != NONE) {
            const double off = half_way(x, q[row], half);
            between = off < 0.001 ? 0.0 : fmax(off_pose(T, half, e), 1e-12);
            if (off < nearest) {
                nearest = off;
                place = row;
                least = -1.0; /* its own */
            }
        }
        if (between <= 2.0 * least)
            place = row;
        least = fmin(least, between);
    }
    if (least >= 0.0)
        status[place] = FREE;
    if (nearest > 1e-06 || beyond_limits(q[place]) > 0.0)
        take(x, q[place]);
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const double T[16], const double *q_seed, double q[2][2], unsigned char status[2])
{
    const double zeros[2] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 2; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 2; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++)
        if (status[row] == FREE && beyond_limits(q[row]) > 0.0)
            keep_limits(pose, seed, row, q, status);
    stay(pose, seed, q, status);
    /* far where no row is inside */
    for (int n = 0; n < 2 || (n < 2 * 2 && count == 0); n++) {
        const int row = n % 2, far = n >= 2;
        if (status[row] == NONE)
            continue;
        if (stand(pose, row, far, q, status) && far)
            status[row] = FREE;
        for (int i = 0; i < 2; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int planar_rp_ik(const double T[16], const double *q_seed, double q[2][2], unsigned char status[2])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int planar_rp_ik_nearest(const double T[16], const double q_seed[2], double q[2])
{
    double all[2][2], found[2], least = HUGE_VAL;
    unsigned char status[2];
    int result = -NONE;
    int valid = planar_rp_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 2; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 2 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 2; i++) {
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

void planar_rp_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 4 * k, status + 2 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)planar_rp_ik(T + 16 * i, NULL, (double (*)[2])(q + 4 * i), status + 2 * i);
    }
#endif
    for (; k < n; k++)
        (void)planar_rp_ik(T + 16 * k, NULL, (double (*)[2])(q + 4 * k), status + 2 * k);
}
