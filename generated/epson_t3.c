/* epson_t3: Epson T3
 *
 * Inverse kinematics, generated from robots/epson_t3.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/epson_t3.yaml. The formulas and where they come from: epson_t3.md.
 */
#include "epson_t3.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = EPSON_T3_OK, NONE = EPSON_T3_UNREACHABLE, FREE = EPSON_T3_FREE_JOINT,
    OUT = EPSON_T3_OUT_OF_LIMITS, INVALID = EPSON_T3_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

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

#ifndef EPSON_T3_LIBM
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
 * -DEPSON_T3_SCALAR. With -DEPSON_T3_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(EPSON_T3_SCALAR) && !defined(EPSON_T3_LIBM)
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
#ifdef EPSON_T3_LIBM /* half the time of atan2 */
HELPER double atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
ARCTANGENT(wide)
#endif

MISFIT(wide, wide)

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16])
{
    const wide w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0;
    return misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3 + 0.0 * (T[3] * T[3] * T[3] + T[7]
        * T[7] * T[7] + T[11] * T[11] * T[11]);
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

HELPER four irregularity_four(const double T[16])
{
    const four x = *(const four_at *)T, y = *(const four_at *)(T + 4),
        z = *(const four_at *)(T + 8), x1 = shuffle(x, x, 1, 2, 0, 3),
        y1 = shuffle(y, y, 1, 2, 0, 3), z1 = shuffle(z, z, 1, 2, 0, 3),
        x2 = shuffle(x, x, 2, 0, 1, 3), y2 = shuffle(y, y, 2, 0, 1, 3),
        lengths = x * x + y * y + z * z - 1.0, angles = x * x1 + y * y1 + z * z1,
        mirror = x1 * y2 - x2 * y1 - z,
        last = *(const four_at *)(T + 12) - (four){ 0.0, 0.0, 0.0, 1.0 };
    return (lengths * lengths + 2.0 * angles * angles + mirror * mirror) * (four){ 1.0, 1.0, 1.0,
        0.0 } + last * last;
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
HELPER v centred_##v(v x) \
{ \
    return x + pick_##v(x <= -half_turn, all_##v(turn), only_##v(half_turn < x, -turn)); \
}

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
#define exceeds(x, joint) (abs_wide(x) - high(joint))
#define exceeds_four(x, joint) (abs_four(x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    a1 = 0.225, /* link length 1 [m] */
    a2 = 0.175, /* link length 2 [m] */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    longest2 = 0.16000000000000003, /* square of the longest reach [m^2] */
    shortest2 = 0.002500000000000002, /* square of the shortest reach [m^2] */
    longest2_reach = 0.16000000000003203, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.0024999999999960015, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.1599999999999968, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.002500000000000401, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 1.6000000000000003e-25, /* square of a length that fixes no angle [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 4.000000000000001e-06, /* a pose may be rounded by this [m] */
    k1 = 0.08125, /* a1^2 + a2^2 [m^2] */
    k2 = 12.6984126984127, /* 1 / (2 * a2 * a1) [m^-2] */
    /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
    m1 = 5.0709436649753e-13,
    m4 = 1.0000000000000002e-10; /* pose_slack^2 */
/* coefficients */
static const double m2 = 2.2222222222222223, m3 = 0.04444444444444444;
static const double per_size = 2.5;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T33 = T[10], T34 = T[11]

const char *const epson_t3_branches[2] = {
    "down", "up",
};

static const double lowest[4] = {
    -2.303834612632515, -2.4609142453120048, -0.15, -6.283185307179586,
};
static const double highest[4] = { 2.303834612632515, 2.4609142453120048, 0.0, 6.283185307179586 };
static const int revolute[4] = { 1, 1, 0, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[4] = { 1.0, 1.0, 6.249999999999999, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 4e-10) /* of limits */
/* Of the values of a free joint that are tried, from one to the next. */
static const double fan_step[4] = {
    0.09817477042468103, 0.09817477042468103, 0.0046875, 0.09817477042468103,
};

void epson_t3_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), v1 = x2_y * s4, v2 = x2_y * c4;
    T[0] = x2_x * c4 + v1; T[1] = v2 - x2_x * s4; T[2] = 0.0; T[3] = c1 * a1 + x2_x * a2;
    T[4] = v2 + -x2_x * s4; T[5] = -x2_x * c4 - v1; T[6] = 0.0; T[7] = s1 * a1 + x2_y * a2;
    T[8] = 0.0; T[9] = 0.0; T[10] = -1.0; T[11] = q[2];
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void epson_t3_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), p2_x = p1_x + (c1 * c2 - s1 * s2) * a2,
        p2_y = p1_y + (s1 * c2 + c1 * s2) * a2;
    J[0] = -p2_y; J[1] = p1_y - p2_y; J[2] = 0.0; J[3] = 0.0;
    J[4] = p2_x; J[5] = p2_x - p1_x; J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0; J[10] = 1.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 1.0; J[21] = 1.0; J[22] = 0.0; J[23] = -1.0;
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
static double beyond_limits(const double values[4])
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += fabs(overshoot(i, values[i])) * sqrt(weight[i]);
    return sum;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[8], wide_mask kind[2])
{
    ENTRIES(wide);

    /* theta12m4 */
    const wide angle1 = atan2_wide(T21, T11);

    /* theta2 */
    const wide N2 = T14 * T14 + T24 * T24, D2 = (longest2 - N2) * (N2 - shortest2),
        w2 = sqrt_wide(D2), angle2 = atan2_wide(w2, N2 - k1);

    /* theta1 */
    const wide v1 = m3 + m2 * N2, v2 = T24 * v1, v3 = T14 * v1, v4 = w2 * (m2 * T14),
        v5 = w2 * (m2 * T24), angle3 = atan2_wide(v2 - v4, v3 + v5),
        angle4 = atan2_wide(v2 + v4, v3 - v5);

    /* is the pose one that the arm can take? */
    const wide v6 = 1.0 + T33, v7 = T21 * T21 + T11 * T11 - 1.0;

    /* joint values */
    const wide v8 = angle2 + angle3 - angle1, v9 = angle4 - angle2 - angle1, q3_p = w2 - w2 + T34,
        v10 = maximum_wide(exceeds(angle2, 2), per_size * beyond(T34, 3)),
        excess_p = maximum_wide(v10, exceeds(angle3, 1)),
        excess_m = maximum_wide(v10, exceeds(angle4, 1));

    q[0] = angle3; q[1] = angle2; q[2] = q3_p; q[3] = centred_wide(v8);
    kind[0] = kind_of(q[0], 0.0 < excess_p);
    q[4] = angle4; q[5] = -angle2; q[6] = q3_p; q[7] = centred_wide(v9);
    kind[1] = kind_of(q[4], 0.0 < excess_m);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | ((abs_wide(D2) <= m1) | (m4 < v6 * v6 + T31 * T31 + T23 * T23 + T13 * T13
        + v7 * v7)) | (grazes(excess_p) | grazes(excess_m));
}

#if LANES > 1
/* One regular pose, 1 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[2][4], unsigned char status[2])
{
    const four e1 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta2 */
    const double N2 = T14 * T14 + T24 * T24, D2 = (longest2 - N2) * (N2 - shortest2), w2 = sqrt(D2);

    /* theta1 */
    const double v1 = m3 + m2 * N2, v2 = T24 * v1, v3 = T14 * v1;

    /* is the pose one that the arm can take? */
    const double v4 = 1.0 + T33, v5 = T21 * T21 + T11 * T11 - 1.0;

    /* joint values */
    const double q3 = w2 - w2 + T34;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)) | (unsigned)((fabs(D2) <= m1) | (m4 < v4 *
        v4 + T31 * T31 + T23 * T23 + T13 * T13 + v5 * v5)))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(shuffle(v2 - w2 * (m2 * (e1 * T14)), all_four(T21),
        0, 1, 6, 3), all_four(w2), 0, 1, 2, 7), shuffle(shuffle(v3 + w2 * (m2 * (e1 * T24)),
        all_four(T11), 0, 1, 6, 3), all_four(N2 - k1), 0, 1, 2, 7));
    const four packed1 = angle_four(ratio1), angle3 = shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = shuffle(packed1, packed1, 2, 2, 2, 2),
        angle2 = shuffle(packed1, packed1, 3, 3, 3, 3);
    const four q2 = e1 * angle2, v6 = angle3 + q2 - angle1, q4 = centred_four(v6),
        v7 = maximum_four(exceeds_four(angle2, 2), all_four(per_size * maximum_double(low(3) - T34,
            T34 - high(3)))), excess = maximum_four(v7, exceeds_four(angle3, 1));
    const four_mask outside = 0.0 < excess;
    if (bits_four(grazes_four(excess)))
        return -1;

    store_4(&q[0][0], &q[1][0], &q[0][0], &q[1][0], angle3, q2, all_four(q3), q4);
    const unsigned long long none1 = (bits_four(angle3 != angle3) * 0x81ull & 0x101ull);
    const unsigned long long outside1 = (bits_four(outside) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * NONE + (outside1 & ~none1) * OUT;
    __builtin_memcpy(status + 0, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~(none1 | outside1));
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[8], x[LANES];
    wide_mask kind[2];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 8; i += LANES) {
        const int from = i + LANES <= 8 ? i : 8 - LANES;
        for (int k = 0; k < LANES; k++)
            x[k] = found[from + k];
        transpose(x);
        for (int k = 0; k < LANES; k++)
            *(wide_at *)(q + 8 * k + from) = x[k];
    }
    for (int i = 1; i < 2; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 2 * k, &word, 2);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(const double T[16], double q[2][4], unsigned char status[2])
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
    const double T[16], const double seed[4], double q[2][4], unsigned char status[2])
{
    ENTRIES(double);

    /* theta12m4, type 3: U0[1, 2] and U0[2, 2] */
    const double w12m4 = sqrt(T21 * T21 + T11 * T11);
    const int free12m4 = w12m4 <= free_limit_squared;
    const double v1 = 1.0 / (free12m4 ? 1.0 : w12m4), v2 = seed[0] + seed[1] - seed[3];
    const double c12m4 = free12m4 ? cos(v2) : T11 * v1;
    const double s12m4 = free12m4 ? sin(v2) : T21 * v1;
    const double theta12m4 = atan2(s12m4, c12m4);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double N2 = T14 * T14 + T24 * T24;
    const double K2 = N2 - k1;
    const double D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2 : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v3 = T24 * X1_1, v4 = T14 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabs(1.0 + T33) <= pose_slack && fabs(T31) <= pose_slack && fabs(T23) <= pose_slack &&
        fabs(T21 - s12m4) <= pose_slack && fabs(T11 - c12m4) <= pose_slack && fabs(T13) <=
        pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e1 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v3 - T14 * Y1_1;
        const double C1 = v4 + T24 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1,
            s1 = free1 ? sin(seed[0]) : S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1, s12 = c2 * s1 + s2 * c1;
        if (!(fabs(T14 - (a2 * c12 + a1 * c1)) <= pose_slack1 && fabs(T24 - (a2 * s12 + a1 * s1)) <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = wrap(q2 + q1 - theta12m4);
        const int free1_ = free12m4 || free1;
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = T34; q[row][3] = q4;
        status[row] = (free1_ || free12m4 || free12m4) ? FREE : OK;
    }
}

static void take(const double from[4], double to[4])
{
    for (int i = 0; i < 4; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const double *T;
    double seed[4], start, q[2][4];
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
    for (int i = 0; i < 4; i++) {
        const double value = s->q[s->row][i], moved = fabs(value - other.q[s->row][i]);
        if (moved < 1e-09 && fabs(overshoot(i, value)) > 0.0)
            return 1;
    }
    return 0;
}

/* A free joint took the seed's value, and that puts one beyond its limits: takes the nearest value
 * that keeps all, if there is one; other free joints the seed's, as far as their limits allow. */
static void keep_limits(
    const double T[16], const double seed[4], int row, double q[2][4], unsigned char status[2])
{
    static const int choosable[3] = { 3, 1, 0 };
    struct search search = { .T = T, .row = row };
    for (int i = 0; i < 4; i++)
        search.seed[i] = seed[i] - overshoot(i, seed[i]);
    for (int k = 0; k < 3; k++) {
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
static double half_way(const double x[4], const double q[4], double half[4])
{
    double most = 0.0;
    for (int i = 0; i < 4; i++) {
        double off = q[i] - x[i];
        off -= revolute[i] ? turn * floor(off / turn + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(weight[i]));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 2.5, 2.5, 2.5, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[4] = { 1.0, 1.0, 0.4, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[4], double e[6])
{
    double P[16], square = 0.0;
    epson_t3_fk(x, P);
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
static void add_step(const int held[4], double damping, double e[6], double x[4])
{
    double A[6][10] = { { 0.0 } }, square[6] = { 0.0 }, J[24];
    epson_t3_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 4; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[4 * i + j];
        A[i][4 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 10; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 10; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 10; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 4; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* The same of a value as it stands: it might be turned. */
static double past_an_end(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (high - low < 6.183185307179587)
        return overshoot(joint, value);
    const double off = value - fmin(fmax(value, low), high);
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of all joints. */
static double past_ends(const double values[4])
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += fabs(past_an_end(i, values[i])) * sqrt(weight[i]);
    return sum;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
static double at_an_end(int joint, double value, double seed)
{
    const double near = value + turn * floor((seed - value) / turn + 0.5);
    const double past = fabs(past_an_end(joint, near));
    if (!revolute[joint])
        return value;
    if (0.0 < past && past < 0.01 && fabs(near - seed) < 0.15)
        return near;
    const double off = overshoot(joint, value);
    if (off == 0.0 || fabs(off) > 0.01)
        return turned(joint, value, value);
    return off + (off > 0.0 ? highest : lowest)[joint];
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[4])
{
    double x[4], half[4], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[4] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 4 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? past_an_end(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 4; i++)
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

/* Takes joint values onto ends that they are past or, as two may not stand there, inside. */
static int lead_inside(const double T[16], double enough, double most, double q[4])
{
    double x[4], e[6];
    if (settle(T, enough, most, q))
        return 1;
    int past = 0;
    for (int i = 0; i < 4; i++)
        past += fabs(past_an_end(i, q[i])) > 0.0;
    enough = off_pose(T, q, e) + 1e-14;
    for (double farther = 2.0; past > 1 && farther <= 16.0; farther *= 2.0) {
        for (int i = 0; i < 4; i++)
            x[i] = q[i] - farther * past_an_end(i, q[i]);
        if (!settle(T, enough, most, x) || past_ends(x) > 0.0)
            continue;
        take(x, q);
        return 1;
    }
    return 0;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const double T[16], int row, int far, double rows[2][4], const unsigned char status[2])
{
    double x[4], half[4], to[4], *q = rows[row];
    const double beyond = past_ends(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!lead_inside(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 2; k++)
        if (status[k] != NONE && past_ends(rows[k]) < beyond
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
    const double T[16], const double seed[4], double q[2][4],
    unsigned char status[2])
{
    double x[4], half[4], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    for (int i = 0; i < 4; i++) {
        const double seen = seed[i], past = fabs(past_an_end(i, seen));
        const double here = past <= 0.15 ? seen : turned(i, seen, seen);
        x[i] = here - past_an_end(i, here);
    }
    if (!settle(T, 1e-12, 0.15, x) || (past_ends(x) > 1e-09 && !lead_inside(T, NAN, 0.15, x)))
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
    if (nearest > 1e-06 || past_ends(q[place]) > 0.0)
        take(x, q[place]);
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    const double zeros[4] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 4; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    if (valid == 2 && (count = solve_regular(pose, q, status)) >= 0)
        return count;
    count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++)
        if (status[row] == FREE && beyond_limits(q[row]) > 0.0)
            keep_limits(pose, seed, row, q, status);
    for (int row = 0; row < 2; row++)
        for (int i = 0; i < 4; i++)
            q[row][i] = at_an_end(i, q[row][i], seed[i]);
    stay(pose, seed, q, status);
    /* far where no row is inside */
    for (int n = 0; n < 2 || (n < 2 * 2 && count == 0); n++) {
        const int row = n % 2, far = n >= 2;
        if (status[row] == NONE)
            continue;
        if (stand(pose, row, far, q, status) && far)
            status[row] = FREE;
        for (int i = 0; i < 4; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int epson_t3_ik(const double T[16], const double *q_seed, double q[2][4], unsigned char status[2])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int epson_t3_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[2][4], found[4], least = HUGE_VAL;
    unsigned char status[2];
    int result = -NONE;
    int valid = epson_t3_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 4; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    int past = 0; /* joints past an end and turned */
    for (int i = 0; i < 4 && valid; i++)
        if (fmin(highest[i] - q_seed[i], q_seed[i] - lowest[i]) < 0.15)
            for (int row = 0; row < 2; row++)
                past += status[row] == OK
                    && past_an_end(i, at_an_end(i, all[row][i], q_seed[i])) != 0.0;
    if (past)
        (void)ik_carefully(T, q_seed, all, status);
    for (int row = 0; row < 2 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 4; i++) {
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

void epson_t3_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 8 * k, status + 2 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)epson_t3_ik(T + 16 * i, NULL, (double (*)[4])(q + 8 * i), status + 2 * i);
    }
#endif
    for (; k < n; k++)
        (void)epson_t3_ik(T + 16 * k, NULL, (double (*)[4])(q + 8 * k), status + 2 * k);
}
