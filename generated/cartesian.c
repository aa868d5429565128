/* cartesian: Cartesian arm
 *
 * Inverse kinematics, generated from robots/cartesian.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from:
 * cartesian.md.
 */
#include "cartesian.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = CARTESIAN_OK, NONE = CARTESIAN_UNREACHABLE, FREE = CARTESIAN_FREE_JOINT,
    OUT = CARTESIAN_OUT_OF_LIMITS, INVALID = CARTESIAN_INVALID_POSE
};


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

#ifndef CARTESIAN_LIBM
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
 * -DCARTESIAN_SCALAR. With -DCARTESIAN_LIBM the arctangents are those of <math.h>, too. */
#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && \
    !defined(CARTESIAN_SCALAR) && !defined(CARTESIAN_LIBM)
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
#ifdef CARTESIAN_LIBM /* half the time of atan2 */
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
    return 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] * T[11]);
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

HELPER void store_1(double *r0, double *r1, double *r2, double *r3, four a)
{
    *r0 = a[0];
    *r1 = a[1];
    *r2 = a[2];
    *r3 = a[3];
}

HELPER four irregularity_four(const double T[16])
{
    return all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] * T[11]));
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

#define low(joint) (lowest[joint - 1] - slack(joint - 1))
#define high(joint) (highest[joint - 1] + slack(joint - 1))
#define beyond(x, joint) maximum_wide(low(joint) - (x), (x) - high(joint))
#define beyond_four(x, joint) maximum_four(low(joint) - (x), (x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const double per_size = 0.8333333333333334;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T14 = T[3]; \
    const number T24 = T[7]; \
    const number T34 = T[11]

const char *const cartesian_branches[1] = {
    "only",
};

static const double lowest[3] = { 0.0, 0.0, 0.0 };
static const double highest[3] = { 0.8, 0.6, 1.2 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[3] = { 0.6944444444444444, 0.6944444444444444, 0.6944444444444444 };
#define slack(joint) 1.2e-09 /* of limits */

void cartesian_fk(const double q[3], double T[16])
{
    T[0] = 0.0; T[1] = 0.0; T[2] = 1.0; T[3] = q[2];
    T[4] = 0.0; T[5] = -1.0; T[6] = 0.0; T[7] = q[1];
    T[8] = 1.0; T[9] = 0.0; T[10] = 0.0; T[11] = q[0];
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void cartesian_jacobian(const double q[3], double J[18])
{
    (void)q;
    J[0] = 0.0; J[1] = 0.0; J[2] = 1.0;
    J[3] = 0.0; J[4] = 1.0; J[5] = 0.0;
    J[6] = 1.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
}

/* Copies a pose. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3] * T[3] * T[3]) && isfinite(T[7] * T[7] * T[7]) && isfinite(T[11] * T[11] *
        T[11])))
        return 0;
    return 1;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[3], wide_mask kind[1])
{
    ENTRIES(wide);

    q[0] = T34; q[1] = T24; q[2] = T14;
    kind[0] = kind_of(q[0], 0.0 < maximum_wide(per_size * beyond(T14, 3), maximum_wide(per_size *
        beyond(T34, 1), per_size * beyond(T24, 2))));
    const wide_mask exact = irregularity_wide(T) <= 1e-24;
    return (exact == 0);
}

#if LANES > 1
/* One regular pose, 0 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
INLINED
HELPER int solve_regular(const double T[16], double q[1][3], unsigned char status[1])
{
    ENTRIES(double);

    /* joint values */
    const int outside = 0.0 < maximum_double(per_size * maximum_double(low(3) - T14, T14 - high(3)),
        maximum_double(per_size * maximum_double(low(1) - T34, T34 - high(1)), per_size *
        maximum_double(low(2) - T24, T24 - high(2))));

    if (bits_four(((irregularity_four(T) <= 1e-24) == 0)))
        return -1;


    store_2(&q[0][0], &q[0][0], &q[0][0], &q[0][0], all_four(T34), all_four(T24));
    store_1(&q[0][2], &q[0][2], &q[0][2], &q[0][2], all_four(T14));
    const unsigned long long none1 = (bits_four(all_four(T34) != all_four(T34)) * 0x1ull & 0x1ull);
    const unsigned long long outside1 = (bits_four(where_four(outside)) * 0x1ull & 0x1ull);
    const unsigned long long kind1 = none1 * NONE + (outside1 & ~none1) * OUT;
    __builtin_memcpy(status + 0, &kind1, 1);
    return __builtin_popcountll(0x1ull & ~(none1 | outside1));
}

/* Solves LANES poses of a batch. Returns a bit for each that has to be left to `solve`. */
HELPER unsigned solve_tile(const double *T, double *q, unsigned char *status)
{
    wide pose[16], found[3], x[LANES];
    wide_mask kind[1];
    for (int i = 0; i < 16; i += LANES) {
        for (int k = 0; k < LANES; k++)
            x[k] = *(const wide_at *)(T + 16 * k + i);
        transpose(x);
        for (int k = 0; k < LANES; k++)
            pose[i + k] = x[k];
    }
    const wide_mask left = solve_wide(pose, found, kind);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < LANES; k++)
            q[3 * k + i] = found[i][k];
    for (int i = 1; i < 1; i++)
        kind[0] |= kind[i] << 8 * i;
    for (int k = 0; k < LANES; k++) {
        const long long word = kind[0][k];
        __builtin_memcpy(status + 1 * k, &word, 1);
    }
    return bits_wide(left);
}
#else
HELPER int solve_regular(const double T[16], double q[1][3], unsigned char status[1])
{
    wide_mask kind[1];
    int count = 0;
    if (solve_wide(T, &q[0][0], kind))
        return -1;
    for (int row = 0; row < 1; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == 0;
    }
    return count;
}
#endif

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[3], double q[1][3], unsigned char status[1])
{
    (void)seed;
    ENTRIES(double);

    const int row = 0;
    q[row][0] = T34; q[row][1] = T24; q[row][2] = T14;
    status[row] = OK;
}

static void take(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const double T[16], const double *q_seed, double q[1][3], unsigned char status[1])
{
    const double zeros[3] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 3; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 1; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 3; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 1; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 3; i++) {
            double *value = &q[row][i];
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int cartesian_ik(const double T[16], const double *q_seed, double q[1][3], unsigned char status[1])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int cartesian_ik_nearest(const double T[16], const double q_seed[3], double q[3])
{
    double all[1][3], found[3], least = HUGE_VAL;
    unsigned char status[1];
    int result = -NONE;
    int valid = cartesian_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 3; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 1 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 3; i++) {
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

void cartesian_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
#if LANES > 1
    for (; k + LANES <= n; k += LANES) {
        unsigned left = solve_tile(T + 16 * k, q + 3 * k, status + k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                (void)cartesian_ik(T + 16 * i, NULL, (double (*)[3])(q + 3 * i), status + i);
    }
#endif
    for (; k < n; k++)
        (void)cartesian_ik(T + 16 * k, NULL, (double (*)[3])(q + 3 * k), status + k);
}
