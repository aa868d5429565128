/* planar_rr: Planar arm with two revolute joints
 *
 * Inverse kinematics, generated from robots/planar_rr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rr.yaml. The formulas and where they come from:
 * planar_rr.md.
 */
#include "planar_rr.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PLANAR_RR_OK, NONE = PLANAR_RR_UNREACHABLE, FREE = PLANAR_RR_FREE_JOINT,
    OUT = PLANAR_RR_OUT_OF_LIMITS, INVALID = PLANAR_RR_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

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

#ifndef PLANAR_RR_LIBM
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
 * -DPLANAR_RR_SCALAR. With -DPLANAR_RR_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(PLANAR_RR_SCALAR) && !defined(PLANAR_RR_LIBM)
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
#ifdef PLANAR_RR_LIBM /* half the time of atan2 */
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
    return 0.0 * (T[3] + T[7]);
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
    return all_four(0.0 * (T[3] + T[7]));
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


/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double
    a1 = 0.4, /* link length 1 [m] */
    a2 = 0.3, /* link length 2 [m] */
    longest2 = 0.48999999999999994, /* square of the longest reach [m^2] */
    shortest2 = 0.010000000000000007, /* square of the shortest reach [m^2] */
    longest2_reach = 0.490000000000098, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.009999999999986006, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.48999999999999017, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000000000001405, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 4.899999999999999e-25, /* square of a length that fixes no angle [m^2] */
    k1 = 0.25, /* a1^2 + a2^2 [m^2] */
    k2 = 4.166666666666667, /* 1 / (2 * a2 * a1) [m^-2] */
    /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
    m1 = 4.689582056016565e-12;
/* coefficients */
static const double m2 = 1.25, m3 = 0.08750000000000001;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T14 = T[3]; \
    const number T24 = T[7]

const char *const planar_rr_branches[2] = {
    "down", "up",
};

static const double lowest[2] = { -INFINITY, -INFINITY };
static const double highest[2] = { INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void planar_rr_fk(const double q[2], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    T[0] = x2_x; T[1] = -x2_y; T[2] = 0.0; T[3] = c1 * a1 + x2_x * a2;
    T[4] = x2_y; T[5] = x2_x; T[6] = 0.0; T[7] = s1 * a1 + x2_y * a2;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rr_jacobian(const double q[2], double J[12])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), p2_x = p1_x + (c1 * c2 - s1 * s2) * a2,
        p2_y = p1_y + (s1 * c2 + c1 * s2) * a2;
    J[0] = -p2_y; J[1] = p1_y - p2_y;
    J[2] = p2_x; J[3] = p2_x - p1_x;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 1.0; J[11] = 1.0;
}

/* Copies a pose. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7])))
        return 0;
    return 1;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[4], wide_mask kind[2])
{
    ENTRIES(wide);

    /* theta2 */
    const wide N2 = T14 * T14 + T24 * T24, D2 = (longest2 - N2) * (N2 - shortest2),
        w2 = sqrt_wide(D2), angle1 = atan2_wide(w2, N2 - k1);

    /* theta1 */
    const wide v1 = m3 + m2 * N2, v2 = T24 * v1, v3 = T14 * v1, v4 = w2 * (m2 * T14),
        v5 = w2 * (m2 * T24);

    q[0] = atan2_wide(v2 - v4, v3 + v5); q[1] = angle1;
    kind[0] = kind_of(q[0], 0);
    q[2] = atan2_wide(v2 + v4, v3 - v5); q[3] = -angle1;
    kind[1] = kind_of(q[2], 0);
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0) | (abs_wide(D2) <= m1);
}

#if LANES > 1
/* One regular pose, 1 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[2][2], unsigned char status[2])
{
    const four e1 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta2 */
    const double N2 = T14 * T14 + T24 * T24, D2 = (longest2 - N2) * (N2 - shortest2), w2 = sqrt(D2);

    /* theta1 */
    const double v1 = m3 + m2 * N2, v2 = T24 * v1, v3 = T14 * v1;

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)) | (unsigned)(fabs(D2) <= m1))
        return -1;

    const four_ratio ratio1 = ratio_four(shuffle(v2 - w2 * (m2 * (e1 * T14)), all_four(w2), 0, 1, 6,
        3), shuffle(v3 + w2 * (m2 * (e1 * T24)), all_four(N2 - k1), 0, 1, 6, 3));
    const four packed1 = angle_four(ratio1), angle2 = shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = shuffle(packed1, packed1, 2, 2, 2, 2);
    const four q2 = e1 * angle1;

    store_2(&q[0][0], &q[1][0], &q[0][0], &q[1][0], angle2, q2);
    const unsigned long long none1 = (bits_four(angle2 != angle2) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * NONE;
    __builtin_memcpy(status + 0, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
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
    const double v1 = T24 * X1_1, v2 = T14 * X1_1;

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e1 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e1 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v1 - T14 * Y1_1;
        const double C1 = v2 + T24 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1,
            s1 = free1 ? sin(seed[0]) : S1 * factor1;
        const double q1 = atan2(s1, c1);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2;
        status[row] = (free1) ? FREE : OK;
    }
}

static void take(const double from[2], double to[2])
{
    for (int i = 0; i < 2; i++)
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

/* How far joint values are from others, whole turns aside [rad, arm sizes]; half is the middle. */
static double half_way(const double x[2], const double q[2], double half[2])
{
    double most = 0.0;
    for (int i = 0; i < 2; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 1.429, 1.429, 0.0, 0.0, 0.0, 0.0 };
/* What a step of one means for joints; none if given. */
static const double pace[2] = { 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[2], double e[6])
{
    double P[16], square = 0.0;
    planar_rr_fk(x, P);
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
    planar_rr_jacobian(x, J);
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
 * returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[2])
{
    double x[2], half[2], e[6], last = HUGE_VAL;
    int settled = 0, lost = 0, held[2] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e);
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

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const double T[16], const double seed[2], double q[2][2],
    unsigned char status[2])
{
    double x[2], half[2], e[6], least = HUGE_VAL, nearest = 0.001;
    int place = 0;
    take(seed, x);
    if (!settle(T, 1e-12, 0.15, x))
        return;
    for (int row = 2 - 1; row >= 0; row--) {
        double between = 1e-06;
        if (status[row] != NONE) {
            const double off = half_way(x, q[row], half);
            between = fmax(off_pose(T, half, e), 1e-12);
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
    if (nearest > 1e-06)
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
    stay(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == NONE)
            continue;
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

int planar_rr_ik(const double T[16], const double *q_seed, double q[2][2], unsigned char status[2])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int planar_rr_ik_nearest(const double T[16], const double q_seed[2], double q[2])
{
    double all[2][2], found[2], least = HUGE_VAL;
    unsigned char status[2];
    int result = -NONE;
    int valid = planar_rr_ik(T, q_seed, all, status) >= 0;
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

void planar_rr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 4 * k, status + 2 * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)planar_rr_ik(T + 16 * i, NULL, (double (*)[2])(q + 4 * i), status + 2 * i);
    }
#endif
    for (; k < n; k++)
        (void)planar_rr_ik(T + 16 * k, NULL, (double (*)[2])(q + 4 * k), status + 2 * k);
}
