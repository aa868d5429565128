/* scara_f32: SCARA
 *
 * Inverse kinematics, generated from robots/scara.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara.yaml. The formulas and where they come from: scara.md.
 */
#include "scara_f32.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = SCARA_F32_OK, NONE = SCARA_F32_UNREACHABLE, FREE = SCARA_F32_FREE_JOINT,
    OUT = SCARA_F32_OUT_OF_LIMITS, INVALID = SCARA_F32_INVALID_POSE
};

static const float turn = 6.2831855f;
#define half_turn (0.5f * turn)

/* The angle moved by whole turns to (-pi, pi]. */
static float wrap(float angle)
{
    return angle - turn * ceilf(angle / turn - 0.5f);
}

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
#define MISFIT(name, number) \
static inline number misfit_##name(const number T[16]) \
{ \
    const number x0 = T[0], x1 = T[1], x2 = T[2]; \
    const number y0 = T[4], y1 = T[5], y2 = T[6]; \
    const number xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0f; \
    const number yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0f; \
    const number xy = x0 * y0 + x1 * y1 + x2 * y2; \
    const number zx = x1 * y2 - x2 * y1 - T[8]; \
    const number zy = x2 * y0 - x0 * y2 - T[9]; \
    const number zz = x0 * y1 - x1 * y0 - T[10]; \
    return xx * xx + yy * yy + 2.0f * xy * xy + zx * zx + zy * zy + zz * zz; \
}
MISFIT(one, float)

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

#ifndef SCARA_F32_LIBM
/* atan r = r + r^3 (odd[0] + odd[1] r^2 + ...) for |r| up to tan(pi/8) */
static const float odd[11] = {
    -0.33333334f, 0.2f, -0.14285715f, 0.11111111f,
    -0.09090905f, 0.07692183f, -0.0666451f, 0.058581363f,
    -0.050853834f, 0.039229743f, -0.019174544f,
};

/* The angle of y and x, not both zero and not infinite, in [-pi, pi], within 3 ulp: the multiple of
 * pi/4 next to it and a ratio of at most tan(pi/8), then a polynomial in this. In two steps: of
 * several angles all ratios come first. `added` is x + y where m holds, else x: for one pose, which
 * waits for its values, so that the sum doesn't wait for m. */
#define added_four(x, m, y) pick_four(m, (x) + (y), x)
#define added_wide(x, m, y) ((x) + only_wide(m, 1.0f) * (y))
#define ARCTANGENT(v) \
typedef struct { v r, known, y; } v##_ratio; \
HELPER v##_ratio ratio_##v(v y, v x) \
{ \
    const v ax = abs_##v(x), ay = abs_##v(y); \
    const v##_mask steep = ay > ax; \
    const v most = maximum_##v(ay, ax), least = minimum_##v(ax, ay); \
    const v##_mask turned = least > most * 0.41421357f; \
    const v ahead = all_##v(0.7853982f), half = all_##v(1.5707964f); \
    const v part = negated_##v(pick_##v(steep, -ahead, ahead), x); \
    const v whole = pick_##v(steep, half, half - 2.0f * part); \
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

#define LANES 1
typedef float wide;
typedef int wide_mask;
#define all_wide(x) (x)
#define where_all(truth) (-(truth))
#define pick_wide(m, yes, no) ((m) ? (yes) : (no))
#define only_wide(m, x) ((m) ? (x) : 0.0f)
#define copysign_wide copysignf
#define signed_wide copysignf
#define negated_wide(x, where) ((x) * copysignf(1.0f, where))
#define abs_wide fabsf
#define sqrt_wide sqrtf
#define maximum_wide maximum_double
#define minimum_wide minimum_double
#ifdef SCARA_F32_LIBM /* half the time of atan2 */
HELPER float atan2_wide(float y, float x)
{
    return atanf(y / x) + copysignf(1.5707964f - copysignf(1.5707964f, x), y);
}
#else
ARCTANGENT(wide)
#endif

MISFIT(wide, wide)

/* How far T is from a pose in full precision, as a sum of squares; NaN if it is not finite. */
HELPER wide irregularity_wide(const wide T[16])
{
    const wide w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0f;
    return misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3 + 0.0f * (T[3] * T[3] * T[3] +
        T[7]
        * T[7] * T[7] + T[11] * T[11] * T[11]);
}

/* An angle moved by a whole turn to (-pi, pi] if it is below, above, or either. */
#define TURNS(v) \
HELPER v centred_##v(v x) \
{ \
    return x + pick_##v(x <= -half_turn, all_##v(turn), only_##v(half_turn < x, -turn)); \
}

TURNS(wide)

#define low(joint) (lowest[joint - 1] - slack(joint - 1))
#define high(joint) (highest[joint - 1] + slack(joint - 1))
/* How far a joint is beyond its limits; whether by rounding, perhaps. */
#define grazes(x) (abs_wide((x) - 0.005f) <= 0.005f)
#define beyond(x, joint) maximum_wide(low(joint) - (x), (x) - high(joint))
#define exceeds(x, joint) (abs_wide(x) - high(joint))

/* The status of rows in lanes. */
#define kind_of(x, outside) \
    ((where_all((x) != (x)) & NONE) \
        | (where_all(((x) == (x)) & (outside)) & OUT))
static const float
    L1 = 0.4f, /* link length 1 [m] */
    L2 = 0.3f, /* link length 2 [m] */
    L4 = 0.1f, /* x of the tool frame [m] */
    free_limit_squared = 4e-10f, /* square of a length that fixes no angle */
    longest2 = 0.49f, /* square of the longest reach [m^2] */
    shortest2 = 0.01f, /* square of the shortest reach [m^2] */
    longest2_reach = 0.49000448f, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.00999936f, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.4899999f, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000016f, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 2.56e-10f, /* square of a length that fixes no angle [m^2] */
    pose_slack = 1e-05f, /* a pose may be rounded by this */
    pose_slack1 = 8e-06f, /* a pose may be rounded by this [m] */
    k1 = 0.25f, /* L1^2 + L2^2 [m^2] */
    k2 = 4.1666665f, /* 1 / (2 * L2 * L1) [m^-2] */
    /* -1 * (longest2 - longest2_reach) * (longest2_reach - shortest2) [m^4] */
    m1 = 2.150425e-06f,
    m4 = 1e-10f; /* pose_slack^2 */
/* coefficients */
static const float m2 = 1.25f, m3 = 0.0875f;
static const float per_size = 1.25f;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T33 = T[10], T34 = T[11]

const char *const scara_f32_branches[2] = {
    "down", "up",
};

static const float lowest[4] = {
    -2.268928f, -2.5307274f, -0.2f, -6.2831855f,
};
static const float highest[4] = { 2.268928f, 2.5307274f, 0.0f, 6.2831855f };
static const int revolute[4] = { 1, 1, 0, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const float weight[4] = { 1.0f, 1.0f, 1.5625f, 1.0f };
#define slack(joint) (revolute[joint] ? 2e-06f : 1.6e-06f) /* of limits */
/* Of the values of a free joint that are tried, from one to the next. */
static const float fan_step[4] = {
    0.09817477f, 0.09817477f, 0.00625f, 0.09817477f,
};

void scara_f32_fk(const float q[4], float T[16])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]);
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 *
        s2;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), x4_x = x2_x * c4 - x2_y * s4,
        x4_y = x2_y * c4 + x2_x * s4;
    T[0] = x4_x; T[1] = -x4_y; T[2] = 0.0f; T[3] = c1 * L1 + x2_x * L2 + x4_x * L4;
    T[4] = x4_y; T[5] = x4_x; T[6] = 0.0f; T[7] = s1 * L1 + x2_y * L2 + x4_y * L4;
    T[8] = 0.0f; T[9] = 0.0f; T[10] = 1.0f; T[11] = q[2];
    T[12] = T[13] = T[14] = 0.0f;
    T[15] = 1.0f;
}

void scara_f32_jacobian(const float q[4], float J[24])
{
    const float c1 = cosf(q[0]), s1 = sinf(q[0]), p1_x = c1 * L1, p1_y = s1 * L1;
    const float c2 = cosf(q[1]), s2 = sinf(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 *
        s2,
        p2_x = p1_x + x2_x * L2, p2_y = p1_y + x2_y * L2;
    const float c4 = cosf(q[3]), s4 = sinf(q[3]), J21 = p2_x + (x2_x * c4 - x2_y * s4) * L4,
        v1 = p2_y + (x2_y * c4 + x2_x * s4) * L4;
    J[0] = -v1; J[1] = p1_y - v1; J[2] = 0.0f; J[3] = p2_y - v1;
    J[4] = J21; J[5] = J21 - p1_x; J[6] = 0.0f; J[7] = J21 - p2_x;
    J[8] = 0.0f; J[9] = 0.0f; J[10] = 1.0f; J[11] = 0.0f;
    J[12] = 0.0f; J[13] = 0.0f; J[14] = 0.0f; J[15] = 0.0f;
    J[16] = 0.0f; J[17] = 0.0f; J[18] = 0.0f; J[19] = 0.0f;
    J[20] = 1.0f; J[21] = 1.0f; J[22] = 0.0f; J[23] = 1.0f;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(float T[16])
{
    float G[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[i][j] = (i == j ? 1.5f : 0.0f)
                - 0.5f * (T[i] * T[j] + T[4 + i] * T[4 + j] + T[8 + i] * T[8 + j]);
    for (float *row = T; row < T + 12; row += 4) {
        const float x = row[0], y = row[1], z = row[2];
        for (int j = 0; j < 3; j++)
            row[j] = x * G[0][j] + y * G[1][j] + z * G[2][j];
    }
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose, and 2 for what was rounded. */
static int read_pose(const float given[16], float T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3] * T[3] * T[3]) && isfinite(T[7] * T[7] * T[7]) && isfinite(T[11] * T[11] *
        T[11])))
        return 0;
    if (!(fabsf(T[12]) + fabsf(T[13]) + fabsf(T[14]) + fabsf(T[15] - 1.0f) <= 1e-06f))
        return 0;
    const float miss = misfit_one(T);
    if (!(miss <= 1e-09f))
        return 0;
    if (miss <= 1e-12f)
        return 1;
    straighten(T);
    straighten(T);
    return 2;
}

/* How far a joint value is beyond its limits, whole turns aside; negative below. */
static float overshoot(int joint, float value)
{
    const float low = lowest[joint], high = highest[joint];
    if (low <= value && value <= high)
        return 0.0f;
    float off = value > high ? value - high : value - low;
    const float gap = turn - (high - low), over = value - high;
    const float rest = over - turn * floorf(over / turn);
    if (revolute[joint])
        off = rest >= gap ? 0.0f : rest <= gap - rest ? rest : rest - gap;
    return fabsf(off) <= 0.5f * slack(joint) ? 0.0f : off;
}

/* The same of a row. */
static float beyond_limits(const float values[4])
{
    float sum = 0.0f;
    for (int i = 0; i < 4; i++)
        sum += fabsf(overshoot(i, values[i])) * sqrtf(weight[i]);
    return sum;
}

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
HELPER wide_mask solve_wide(const wide T[16], wide q[8], wide_mask kind[2])
{
    ENTRIES(wide);

    /* r3 */
    const wide t34 = T34 - L4 * T31;

    /* theta124 */
    const wide angle1 = atan2_wide(T21, T11);

    /* theta2 */
    const wide t14 = T14 - L4 * T11, t24 = T24 - L4 * T21, N2 = t14 * t14 + t24 * t24,
        D2 = (longest2 - N2) * (N2 - shortest2), w2 = sqrt_wide(D2),
        angle2 = atan2_wide(w2, N2 - k1);

    /* theta1 */
    const wide v1 = m3 + m2 * N2, v2 = t24 * v1, v3 = t14 * v1,
        angle3 = atan2_wide(v2 - w2 * (m2 * t14), v3 + w2 * (m2 * t24)),
        angle4 = atan2_wide(v2 - w2 * (m2 * -t14), v3 + w2 * (m2 * -t24));

    /* is the pose one that the arm can take? */
    const wide v4 = T33 - 1.0f, v5 = T21 * T21 + T11 * T11 - 1.0f;

    /* joint values */
    const wide v6 = angle1 - (angle2 + angle3), v7 = angle1 - (angle4 - angle2),
        q3_p = t34 + (w2 - w2), v8 = maximum_wide(exceeds(angle2, 2), per_size * beyond(t34, 3)),
        excess_p = maximum_wide(v8, exceeds(angle3, 1)),
        excess_m = maximum_wide(v8, exceeds(angle4, 1));

    q[0] = angle3; q[1] = angle2; q[2] = q3_p; q[3] = centred_wide(v6);
    kind[0] = kind_of(q[0], 0.0f < excess_p);
    q[4] = angle4; q[5] = -angle2; q[6] = q3_p; q[7] = centred_wide(v7);
    kind[1] = kind_of(q[4], 0.0f < excess_m);
    const wide_mask exact = irregularity_wide(T) <= 1e-12f;
    return (exact == 0) | ((abs_wide(D2) <= m1) | (m4 < v4 * v4 + T31 * T31 + T23 * T23 + T13 * T13
        + v5 * v5)) | (grazes(excess_p) | grazes(excess_m));
}

HELPER int solve_regular(const float T[16], float q[2][4], unsigned char status[2])
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

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const float T[16], const float seed[4], float q[2][4], unsigned char status[2])
{
    ENTRIES(float);

    /* r3, type 1: U0[3, 4] */
    const float t34 = T34 - L4 * T31;

    /* theta124, type 3: U0[1, 2] and U0[2, 2] */
    const float w124 = sqrtf(T21 * T21 + T11 * T11);
    const int free124 = w124 <= free_limit_squared;
    const float v1 = 1.0f / (free124 ? 1.0f : w124), v2 = seed[0] + seed[1] + seed[3];
    const float c124 = free124 ? cosf(v2) : T11 * v1, s124 = free124 ? sinf(v2) : T21 * v1;
    const float theta124 = atan2f(s124, c124);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const float t14 = T14 - L4 * T11;
    const float t24 = T24 - L4 * T21;
    const float N2 = t14 * t14 + t24 * t24;
    const float K2 = N2 - k1;
    const float D2 = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const float w2 = sqrtf(apart2 ? D2 : 0.0f);
    const float c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const float X1_1 = L1 + L2 * c2;
    const float v3 = t24 * X1_1, v4 = t14 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabsf(T33 - 1.0f) <= pose_slack && fabsf(T31) <= pose_slack && fabsf(T23) <= pose_slack &&
        fabsf(T21 - s124) <= pose_slack && fabsf(T11 - c124) <= pose_slack && fabsf(T13) <=
        pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* down, up */
        const float e1 = i1 == 0 ? 1.0f : -1.0f;
        /* theta2 */
        if (e1 < 0.0f && !apart2) continue; /* both signs give the same */
        const float s2 = w2 * e1 * k2;
        const float q2 = atan2f(s2, c2);

        /* theta1 */
        const float Y1_1 = L2 * s2;
        const float S1 = v3 - t14 * Y1_1;
        const float C1 = v4 + t24 * Y1_1;
        const float w1 = sqrtf(S1 * S1 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const float factor1 = 1.0f / (free1 ? 1.0f : w1);
        const float c1 = free1 ? cosf(seed[0]) : C1 * factor1,
            s1 = free1 ? sinf(seed[0]) : S1 * factor1;
        const float q1 = atan2f(s1, c1);

        /* is the pose one that the arm can take? */
        const float c12 = c2 * c1 - s2 * s1, s12 = c2 * s1 + s2 * c1;
        if (!(fabsf(t14 - (L2 * c12 + L1 * c1)) <= pose_slack1 && fabsf(t24 - (L2 * s12 + L1 * s1))
            <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const float q4 = wrap(theta124 - (q2 + q1));
        const int free1_ = free124 || free1;
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = t34; q[row][3] = q4;
        status[row] = (free1_ || free124 || free124) ? FREE : OK;
    }
}

static void take(const float from[4], float to[4])
{
    for (int i = 0; i < 4; i++)
        to[i] = from[i];
}

/* A row that another value of a free joint may serve, and what solving again needs. */
struct search {
    const float *T;
    float seed[4], start, q[2][4];
    unsigned char status[2];
    int joint, row;
};

/* Solves with the joint moved: 0 if it serves, else less. */
static float attempt(struct search *s, float moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < 2; i++)
        s->status[i] = NONE;
    solve(s->T, s->seed, s->q, s->status);
    if (s->status[s->row] == NONE)
        return -HUGE_VALF;
    return -beyond_limits(s->q[s->row]);
}

/* Golden section for a move that serves, or NaN. */
static float summit(struct search *s, float low, float high)
{
    for (int k = 0; k < 52; k++) {
        const float third = 0.38196602f * (high - low);
        const float left = attempt(s, low + third), right = attempt(s, high - third);
        if (left == 0.0f || right == 0.0f)
            return left == 0.0f ? low + third : high - third;
        if (left >= right)
            high -= third;
        else
            low += third;
    }
    return NAN;
}

/* How far a free joint has to be moved from the seed's value until it serves, or NaN: a fan of
 * values, golden section, bisection of the nearest end; of two equally near the lower one. */
static float serving_value(struct search *s)
{
    const float step = fan_step[s->joint];
    if (attempt(s, 0.0f) == 0.0f)
        return 0.0f;
    float nearest = NAN, before, here = -HUGE_VALF, after = attempt(s, -32.0f * step);
    for (int k = -32; k <= 32; k++) {
        before = here;
        here = after;
        after = attempt(s, (float)(k + 1) * step);
        float outer = (float)k * step, inner = k > 0 ? outer - step : k < 0 ? outer + step : 0.0f;
        if (here < 0.0f && here >= before && here > after)
            outer = summit(s, outer - step, outer + step);
        else if (here < 0.0f || (k > 0 ? before : after) == 0.0f)
            continue;
        if (isnan(outer))
            continue;
        for (int i = 0; i < 52; i++) {
            const float middle = 0.5f * (inner + outer);
            if (attempt(s, middle) == 0.0f)
                outer = middle;
            else
                inner = middle;
        }
        if (!(fabsf(outer) >= fabsf(nearest) - 2e-06f))
            nearest = outer;
    }
    return nearest;
}

/* Whether a joint beyond its limits does not move with the one that is searched. */
static int hopeless(struct search *s)
{
    struct search other = *s;
    if (isinf(attempt(s, 0.0f)) || isinf(attempt(&other, 0.1f)))
        return 0;
    for (int i = 0; i < 4; i++) {
        const float value = s->q[s->row][i], moved = fabsf(value - other.q[s->row][i]);
        if (moved < 2e-06f && fabsf(overshoot(i, value)) > 0.0f)
            return 1;
    }
    return 0;
}

/* A free joint took the seed's value, and that puts one beyond its limits: takes the nearest value
 * that keeps all, if there is one; other free joints the seed's, as far as their limits allow. */
static void keep_limits(
    const float T[16], const float seed[4], int row, float q[2][4], unsigned char status[2])
{
    static const int choosable[3] = { 3, 1, 0 };
    struct search search = { .T = T, .row = row };
    for (int i = 0; i < 4; i++)
        search.seed[i] = seed[i] - overshoot(i, seed[i]);
    for (int k = 0; k < 3; k++) {
        const int joint = search.joint = choosable[k];
        const float inside = search.seed[joint];
        search.start = revolute[joint] ? fmodf(seed[joint], turn) : inside;
        const float nearest = hopeless(&search) ? (float)NAN : serving_value(&search);
        /* beside the solution of another row this one has none */
        if (!isnan(nearest) && (fabsf(nearest) >= 0.003f || !isinf(attempt(&search, 0.0f)))) {
            attempt(&search, nearest);
            status[row] = search.status[row];
            take(search.q[row], q[row]);
            return;
        }
        search.seed[joint] = inside;
    }
}

/* A joint value moved by whole turns, near to another but inside its limits. */
static float turned(int joint, float given, float towards)
{
    const float low = lowest[joint] - 2e-06f, high = highest[joint] + 2e-06f;
    if (!revolute[joint])
        return given;
    float value = given;
    if (fabsf(towards) < 100.0f)
        value += turn * floorf((towards - given) / turn + 0.5f);
    value -= turn * ceilf(fmaxf(value - high, 0.0f) / turn);
    value += turn * ceilf(fmaxf(low - value, 0.0f) / turn);
    return value <= high ? value : given;
}

/* How far joint values are from others, whole turns aside [rad, arm sizes]; half is the middle. */
static float half_way(const float x[4], const float q[4], float half[4])
{
    float most = 0.0f;
    for (int i = 0; i < 4; i++) {
        float off = q[i] - x[i];
        off -= revolute[i] ? turn * floorf(off / turn + 0.5f) : 0.0f;
        most = fmaxf(most, fabsf(off) * sqrtf(weight[i]));
        half[i] = x[i] + 0.5f * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const float weights[6] = { 1.25f, 1.25f, 1.25f, 1.0f, 1.0f, 1.0f };
/* What a step of one means for joints; none if given. */
static const float pace[4] = { 1.0f, 1.0f, 0.8f, 1.0f };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static float off_pose(const float T[16], const float x[4], float e[6])
{
    float P[16], square = 0.0f;
    scara_f32_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0f ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0f;
        e[3 + i] = 0.0f;
        square += e[i] * e[i];
    }
    for (int i = 0; i < 9; i++) {
        const int j = (i / 3 + 1) % 3 * 4 + i % 3, k = (i / 3 + 2) % 3 * 4 + i % 3;
        e[3 + i / 3] += 0.5f * (P[j] * T[k] - P[k] * T[j]);
        square += 0.5f * (P[j] - T[j]) * (P[j] - T[j]);
    }
    return sqrtf(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[4], float damping, float e[6], float x[4])
{
    float A[6][10] = { { 0.0f } }, square[6] = { 0.0f }, J[24];
    scara_f32_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 4; j++)
            A[i][j] = held[j] ? 0.0f : pace[j] * weights[i] * J[4 * i + j];
        A[i][4 + i] = sqrtf(damping + 1e-10f);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            float along = 0.0f;
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
static float past_an_end(int joint, float value)
{
    const float low = lowest[joint], high = highest[joint];
    if (high - low < 6.183185f)
        return overshoot(joint, value);
    const float off = value - fminf(fmaxf(value, low), high);
    return fabsf(off) <= 0.5f * slack(joint) ? 0.0f : off;
}

/* The same of all joints. */
static float past_ends(const float values[4])
{
    float sum = 0.0f;
    for (int i = 0; i < 4; i++)
        sum += fabsf(past_an_end(i, values[i])) * sqrtf(weight[i]);
    return sum;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
static float at_an_end(int joint, float value, float seed)
{
    const float near = value + turn * floorf((seed - value) / turn + 0.5f);
    const float past = fabsf(past_an_end(joint, near));
    if (!revolute[joint])
        return value;
    if (0.0f < past && past < 0.01f && fabsf(near - seed) < 0.15f)
        return near;
    const float off = overshoot(joint, value);
    if (off == 0.0f || fabsf(off) > 0.01f)
        return turned(joint, value, value);
    return off + (off > 0.0f ? highest : lowest)[joint];
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const float T[16], float enough, float most, float q[4])
{
    float x[4], half[4], e[6], last = HUGE_VALF;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[4] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        float miss = off_pose(T, x, e), past = 0.0f;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-06f : enough;
        for (int i = 0; i < 4 && stands && miss < enough; i++) {
            const float off = pace[i] > 0.0f ? past_an_end(i, x[i]) : 0.0f;
            worst = fabsf(off) > fabsf(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabsf(past) > 0.0f) {
            moves++;
            for (int i = 0; i < 4; i++)
                held[i] = i == worst || (held[i] && moves != 2);
            last = HUGE_VALF;
            x[worst] -= past;
            miss = off_pose(T, x, e);
        }
        if (miss < enough) {
            take(x, q);
            settled = 1;
            enough = 0.5f * miss;
        } else if (settled || (miss > fmaxf(0.7f * last, 100.0f * enough) && ++lost == 4)) {
            break;
        }
        last = miss;
        add_step(held, (lost == 0 && miss > 100.0f * enough ? 0.003f : 0.1f * miss) * miss, e, x);
        if (!(half_way(x, q, half) <= most))
            break; /* another solution */
    }
    return settled;
}

/* Takes joint values onto ends that they are past or, as two may not stand there, inside. */
static int lead_inside(const float T[16], float enough, float most, float q[4])
{
    float x[4], e[6];
    if (settle(T, enough, most, q))
        return 1;
    int past = 0;
    for (int i = 0; i < 4; i++)
        past += fabsf(past_an_end(i, q[i])) > 0.0f;
    enough = off_pose(T, q, e) + 1e-06f;
    for (float farther = 2.0f; past > 1 && farther <= 16.0f; farther *= 2.0f) {
        for (int i = 0; i < 4; i++)
            x[i] = q[i] - farther * past_an_end(i, q[i]);
        if (!settle(T, enough, most, x) || past_ends(x) > 0.0f)
            continue;
        take(x, q);
        return 1;
    }
    return 0;
}

/* Puts a row's joints just beyond their limits, or far, on them if it can: half way is a solution,
 * too, and no row that is less far beyond is nearer. */
static int stand(
    const float T[16], int row, int far, float rows[2][4], const unsigned char status[2])
{
    float x[4], half[4], to[4], *q = rows[row];
    const float beyond = past_ends(q);
    if (!(0.0f < beyond && (far || beyond < 0.01f)))
        return 0;
    take(q, x);
    if (!lead_inside(T, NAN, far ? HUGE_VALF : 1.5f, x))
        return 0;
    const float off = half_way(q, x, half);
    for (int k = 0; k < 2; k++)
        if (status[k] != NONE && past_ends(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.03f && !settle(T, 5e-05f, 0.25f * off, half))
        return 0;
    take(x, q);
    return 1;
}

/* Where rounding can't tell solutions apart the one next to the seed gets a row: its own, one as
 * good, one left, or any. */
static void stay(
    const float T[16], const float seed[4], float q[2][4],
    unsigned char status[2])
{
    float x[4], half[4], e[6], least = HUGE_VALF, nearest = 0.03f;
    int place = 0;
    for (int i = 0; i < 4; i++) {
        const float seen = seed[i], past = fabsf(past_an_end(i, seen));
        const float here = past <= 0.15f ? seen : turned(i, seen, seen);
        x[i] = here - past_an_end(i, here);
    }
    if (!settle(T, 5e-05f, 0.15f, x) || (past_ends(x) > 2e-06f && !lead_inside(T, NAN, 0.15f, x)))
        return;
    for (int row = 2 - 1; row >= 0; row--) {
        float between = 0.0005f;
        if (status[row] != NONE) {
            const float off = half_way(x, q[row], half);
            between = off < 0.03f ? 0.0f : fmaxf(off_pose(T, half, e), 5e-05f);
            if (off < nearest) {
                nearest = off;
                place = row;
                least = -1.0f; /* its own */
            }
        }
        if (between <= 2.0f * least)
            place = row;
        least = fminf(least, between);
    }
    if (least >= 0.0f)
        status[place] = FREE;
    if (nearest > 0.003f || past_ends(q[place]) > 0.0f)
        take(x, q[place]);
}

/* A pose that is rounded, singular or none; regular ones need no stack for it. */
APART int ik_carefully(
    const float T[16], const float *q_seed, float q[2][4], unsigned char status[2])
{
    const float zeros[4] = { 0.0f }, *seed = q_seed ? q_seed : zeros;
    float pose[16];
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
        if (status[row] == FREE && beyond_limits(q[row]) > 0.0f)
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
            float *value = &q[row][i];
            *value = turned(i, *value, 0.0f);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int scara_f32_ik(const float T[16], const float *q_seed, float q[2][4], unsigned char status[2])
{
    const int count = solve_regular(T, q, status);
    return count < 0 ? ik_carefully(T, q_seed, q, status) : count;
}

int scara_f32_ik_nearest(const float T[16], const float q_seed[4], float q[4])
{
    float all[2][4], found[4], least = HUGE_VALF;
    unsigned char status[2];
    int result = -NONE;
    int valid = scara_f32_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 4; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    int past = 0; /* joints past an end and turned */
    for (int i = 0; i < 4 && valid; i++)
        if (fminf(highest[i] - q_seed[i], q_seed[i] - lowest[i]) < 0.15f)
            for (int row = 0; row < 2; row++)
                past += status[row] == OK
                    && past_an_end(i, at_an_end(i, all[row][i], q_seed[i])) != 0.0f;
    if (past)
        (void)ik_carefully(T, q_seed, all, status);
    for (int row = 0; row < 2 && valid; row++) {
        float distance = 0.0f;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 4; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const float moved = all[row][i] - q_seed[i];
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

void scara_f32_ik_batch(size_t n, const float *T, float *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)scara_f32_ik(T + 16 * k, NULL, (float (*)[4])(q + 8 * k), status + 2 * k);
}
