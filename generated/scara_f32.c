/* scara_f32: SCARA
 *
 * Inverse kinematics, generated from robots/scara.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara.yaml. The formulas and where they come from: scara.md.
 */
#include "scara_f32.h"

#include <math.h>

static const float turn = 6.2831855f;
static const float L1 = 0.4f; /* link length 1 [m] */
static const float L2 = 0.3f; /* link length 2 [m] */
static const float L4 = 0.1f; /* x of the tool frame [m] */
/* square of a length that fixes no angle */
static const float free_limit_squared = 4e-10f;
static const float longest2 = 0.49f; /* square of the longest reach [m^2] */
static const float shortest2 = 0.01f; /* square of the shortest reach [m^2] */
/* the longest, with what rounding adds [m^2] */
static const float longest2_reach = 0.4900011f;
/* the shortest, with what rounding adds [m^2] */
static const float shortest2_reach = 0.00999984f;
/* the longest, where branches merge [m^2] */
static const float longest2_apart = 0.4899999f;
/* the shortest, where branches merge [m^2] */
static const float shortest2_apart = 0.010000016f;
/* square of a length that fixes no angle [m^2] */
static const float free_limit_squared2 = 2.56e-10f;
static const float pose_slack = 1e-05f; /* a pose may be rounded by this */
static const float pose_slack1 = 8e-06f; /* a pose may be rounded by this [m] */
static const float k1 = 0.25f; /* L1^2 + L2^2 [m^2] */
static const float k2 = 4.1666665f; /* 1 / (2 * L2 * L1) [m^-2] */

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

/* The angle moved by whole turns to (-pi, pi]. */
static float wrap(float angle)
{
    return angle - turn * ceilf(angle / turn - 0.5f);
}

void scara_f32_fk(const float q[4], float T[16])
{
    const float c1 = cosf(q[0]);
    const float s1 = sinf(q[0]);
    const float c2 = cosf(q[1]);
    const float s2 = sinf(q[1]);
    const float x2_x = c1 * c2 - s1 * s2;
    const float x2_y = s1 * c2 + c1 * s2;
    const float c4 = cosf(q[3]);
    const float s4 = sinf(q[3]);
    const float T11_ = x2_x * c4 - x2_y * s4;
    const float T21_ = x2_y * c4 + x2_x * s4;
    const float T14_ = c1 * L1 + x2_x * L2 + T11_ * L4;
    const float T24_ = s1 * L1 + x2_y * L2 + T21_ * L4;
    T[0] = T11_; T[1] = -T21_; T[2] = 0.0f; T[3] = T14_;
    T[4] = T21_; T[5] = T11_; T[6] = 0.0f; T[7] = T24_;
    T[8] = 0.0f; T[9] = 0.0f; T[10] = 1.0f; T[11] = q[2];
    T[12] = T[13] = T[14] = 0.0f;
    T[15] = 1.0f;
}

void scara_f32_jacobian(const float q[4], float J[24])
{
    const float c1 = cosf(q[0]);
    const float s1 = sinf(q[0]);
    const float p1_x = c1 * L1;
    const float p1_y = s1 * L1;
    const float c2 = cosf(q[1]);
    const float s2 = sinf(q[1]);
    const float x2_x = c1 * c2 - s1 * s2;
    const float x2_y = s1 * c2 + c1 * s2;
    const float p2_x = p1_x + x2_x * L2;
    const float p2_y = p1_y + x2_y * L2;
    const float c4 = cosf(q[3]);
    const float s4 = sinf(q[3]);
    const float J21 = p2_x + (x2_x * c4 - x2_y * s4) * L4;
    const float v1 = p2_y + (x2_y * c4 + x2_x * s4) * L4;
    const float J22 = J21 - p1_x;
    const float J12 = p1_y - v1;
    const float J24 = J21 - p2_x;
    const float J14 = p2_y - v1;
    J[0] = -v1; J[1] = J12; J[2] = 0.0f; J[3] = J14;
    J[4] = J21; J[5] = J22; J[6] = 0.0f; J[7] = J24;
    J[8] = 0.0f; J[9] = 0.0f; J[10] = 1.0f; J[11] = 0.0f;
    J[12] = 0.0f; J[13] = 0.0f; J[14] = 0.0f; J[15] = 0.0f;
    J[16] = 0.0f; J[17] = 0.0f; J[18] = 0.0f; J[19] = 0.0f;
    J[20] = 1.0f; J[21] = 1.0f; J[22] = 0.0f; J[23] = 1.0f;
}

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
static float misfit(const float T[16])
{
    const float *x = T, *y = T + 4, *z = T + 8;
    const float xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - 1.0f;
    const float yy = y[0] * y[0] + y[1] * y[1] + y[2] * y[2] - 1.0f;
    const float xy = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    const float z0 = x[1] * y[2] - x[2] * y[1] - z[0];
    const float z1 = x[2] * y[0] - x[0] * y[2] - z[1];
    const float z2 = x[0] * y[1] - x[1] * y[0] - z[2];
    return xx * xx + yy * yy + 2.0f * xy * xy + z0 * z0 + z1 * z1 + z2 * z2;
}

/* One step R (3 I - R' R) / 2 towards the nearest rotation (polar decomposition, Higham 1986). */
static void straighten(float T[16])
{
    float R[9], G[9];
    for (int i = 0; i < 9; i++)
        R[i] = T[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            G[3 * i + j] = (i == j ? 1.5f : 0.0f)
                - 0.5f * (R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[4 * i + j] = R[3 * i] * G[j] + R[3 * i + 1] * G[3 + j] + R[3 * i + 2] * G[6 + j];
}

/* Copies a pose; a rotation that is only rounded becomes the nearest one.
 * Returns 0 for what is no pose. */
static int read_pose(const float given[16], float T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7]) && isfinite(T[11])))
        return 0;
    if (!(fabsf(T[12]) + fabsf(T[13]) + fabsf(T[14]) + fabsf(T[15] - 1.0f) <= 1e-06f))
        return 0;
    const float miss = misfit(T);
    if (!(miss <= 1e-09f))
        return 0;
    if (miss > 1e-12f) {
        straighten(T);
        straighten(T);
    }
    return 1;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const float T[16], const float seed[4], float q[2][4], unsigned char status[2])
{
    const float T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const float T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const float T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    /* r3, type 1: U0[3, 4] */
    const float t34 = T34 - L4 * T31;

    /* theta124, type 3: U0[1, 2] and U0[2, 2] */
    const float w124 = sqrtf(T21 * T21 + T11 * T11);
    const int free124 = w124 <= free_limit_squared;
    const float v1 = 1.0f / (free124 ? 1.0f : w124);
    const float v2 = seed[0] + seed[1] + seed[3];
    const float c124 = free124 ? cosf(v2) : T11 * v1;
    const float s124 = free124 ? sinf(v2) : T21 * v1;
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
    const float v3 = t24 * X1_1;
    const float v4 = t14 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabsf(T33 - 1.0f) <= pose_slack && (fabsf(T32) <= pose_slack && (fabsf(T31) <= pose_slack &&
        (fabsf(T23) <= pose_slack && (fabsf(T22 - c124) <= pose_slack && (fabsf(T21 - s124) <=
        pose_slack && (fabsf(T13) <= pose_slack && (fabsf(T11 - c124) <= pose_slack && fabsf(T12 +
        s124) <= pose_slack)))))))))
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
        const float c1 = free1 ? cosf(seed[0]) : C1 * factor1;
        const float s1 = free1 ? sinf(seed[0]) : S1 * factor1;
        const float q1 = atan2f(s1, c1);

        /* is the pose one that the arm can take? */
        const float c12 = c2 * c1 - s2 * s1;
        const float s12 = c2 * s1 + s2 * c1;
        if (!(fabsf(t14 - (L2 * c12 + L1 * c1)) <= pose_slack1 && fabsf(t24 - (L2 * s12 + L1 * s1)) <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const float q4 = wrap(theta124 - (q2 + q1));
        const int free1_ = free124 || free1;
        const int row = i1;
        q[row][0] = q1;
        q[row][1] = q2;
        q[row][2] = t34;
        q[row][3] = q4;
        status[row] = (free1_ || free124 || free124) ? SCARA_F32_FREE_JOINT : SCARA_F32_OK;
    }
}

/* A joint value moved by whole turns, near to another value but inside its limits. */
static float turned(int joint, float given, float towards)
{
    const float low = lowest[joint] - 2e-06f;
    const float high = highest[joint] + 2e-06f;
    float value = given;
    if (!revolute[joint])
        return value;
    value += turn * floorf((towards - value) / turn + 0.5f);
    if (value > high)
        value -= turn * ceilf((value - high) / turn);
    if (value < low)
        value += turn * ceilf((low - value) / turn);
    return value <= high ? value : given;
}

static int inside(int joint, float value)
{
    return lowest[joint] - 2e-06f <= value && value <= highest[joint] + 2e-06f;
}

int scara_f32_ik(const float T[16], const float *q_seed, float q[2][4], unsigned char status[2])
{
    static const float zeros[4] = { 0.0f };
    const float *seed = q_seed ? q_seed : zeros;
    float pose[16];
    const int valid = read_pose(T, pose);
    int count = 0;
    for (int row = 0; row < 2; row++) {
        status[row] = valid ? SCARA_F32_UNREACHABLE : SCARA_F32_INVALID_POSE;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -SCARA_F32_INVALID_POSE;
    solve(pose, seed, q, status);
    for (int row = 0; row < 2; row++) {
        if (status[row] == SCARA_F32_UNREACHABLE)
            continue;
        for (int i = 0; i < 4; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = SCARA_F32_OUT_OF_LIMITS;
        }
        count += status[row] != SCARA_F32_OUT_OF_LIMITS;
    }
    return count;
}

int scara_f32_ik_nearest(const float T[16], const float q_seed[4], float q[4])
{
    float all[2][4], least = HUGE_VALF;
    unsigned char status[2];
    int result = -SCARA_F32_UNREACHABLE;
    for (int i = 0; i < 4; i++)
        q[i] = NAN;
    if (scara_f32_ik(T, q_seed, all, status) < 0)
        return -SCARA_F32_INVALID_POSE;
    for (int row = 0; row < 2; row++) {
        float distance = 0.0f;
        if (status[row] == SCARA_F32_OUT_OF_LIMITS && result < 0)
            result = -SCARA_F32_OUT_OF_LIMITS;
        if (status[row] != SCARA_F32_OK && status[row] != SCARA_F32_FREE_JOINT)
            continue;
        for (int i = 0; i < 4; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const float moved = all[row][i] - q_seed[i];
            distance += weight[i] * moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 4; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void scara_f32_ik_batch(size_t n, const float *T, float *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)scara_f32_ik(T + 16 * k, NULL, (float (*)[4])(q + 8 * k), status + 2 * k);
}
