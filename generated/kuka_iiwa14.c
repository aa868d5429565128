/* kuka_iiwa14: KUKA LBR iiwa 14 R820
 *
 * Inverse kinematics, generated from robots/kuka_iiwa14.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_iiwa14.yaml. The formulas and where they come from:
 * kuka_iiwa14.md.
 */
#include "kuka_iiwa14.h"

#include <math.h>

static const double turn = 6.283185307179586;
static const double d1 = 0.36; /* joint offset 1 [m] */
static const double d3 = 0.42; /* joint offset 3 [m] */
static const double d5 = 0.4; /* joint offset 5 [m] */
static const double d7 = 0.126; /* joint offset 7 [m] */
/* rounding at the boundary of the workspace [m^2] */
static const double reach_slack2 = 1.7056360000000002e-13;
/* nearer to that boundary two branches are one [m^2] */
static const double merge_slack2 = 1.705636e-14;
/* square of a length that fixes no angle [m^2] */
static const double free_limit_squared2 = 1.705636e-24;
/* rounding at the boundary of the workspace [m] */
static const double reach_slack1 = 1.3060000000000002e-13;
static const double merge_slack1 = 1.306e-14; /* nearer to that boundary two branches are one [m] */
static const double offset1 = 3.141592653589793; /* offset of joint 1 [rad] */
static const double offset2 = 3.141592653589793; /* offset of joint 2 [rad] */
static const double free_limit = 1e-12; /* a length that fixes no angle */
static const double offset4 = 3.141592653589793; /* offset of joint 4 [rad] */
static const double offset6 = 3.141592653589793; /* offset of joint 6 [rad] */
static const double k1 = 0.336; /* 2 * d5 * d3 [m^2] */
static const double k2 = 0.72; /* 2 * d1 [m] */
static const double k3 = -0.2068; /* d1^2 - (d3^2 + d5^2) [m^2] */
static const double k4 = 0.11289600000000001; /* (2 * d5 * d3)^2 [m^4] */
static const double k5 = 8.857709750566894; /* 1 / ((2 * d5 * d3)^2) [m^-4] */

const char *const kuka_iiwa14_branches[8] = {
    "noflip4-left-noflip5", "noflip4-left-flip5", "noflip4-right-noflip5", "noflip4-right-flip5",
    "flip4-left-noflip5", "flip4-left-flip5", "flip4-right-noflip5", "flip4-right-flip5",
};

static const double lowest[7] = {
    -2.9670597283903604, -2.0943951023931953, -2.9670597283903604, -2.0943951023931953,
    -2.9670597283903604, -2.0943951023931953, -3.0543261909900767,
};
static const double highest[7] = {
    2.9670597283903604, 2.0943951023931953, 2.9670597283903604, 2.0943951023931953,
    2.9670597283903604, 2.0943951023931953, 3.0543261909900767,
};

/* The angle moved by whole turns to (-pi, pi]. */
static double wrap(double angle)
{
    return angle - turn * ceil(angle / turn - 0.5);
}

void kuka_iiwa14_fk(const double q[7], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1);
    const double s1 = sin(v1);
    const double v2 = q[1] + offset2;
    const double c2 = cos(v2);
    const double s2 = sin(v2);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double z2_x = c1 * s2;
    const double z2_y = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + s1 * s3;
    const double x3_y = x2_y * c3 - c1 * s3;
    const double x3_z = s2 * c3;
    const double z3_y = c1 * c3 + x2_y * s3;
    const double z3_z = s2 * s3;
    const double z3_x = x2_x * s3 - s1 * c3;
    const double v3 = q[3] + offset4;
    const double c4 = cos(v3);
    const double s4 = sin(v3);
    const double x4_x = x3_x * c4 + z2_x * s4;
    const double x4_y = x3_y * c4 + z2_y * s4;
    const double x4_z = x3_z * c4 - c2 * s4;
    const double z4_z = c2 * c4 + x3_z * s4;
    const double z4_x = x3_x * s4 - z2_x * c4;
    const double z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double x5_x = x4_x * c5 + z3_x * s5;
    const double x5_y = x4_y * c5 + z3_y * s5;
    const double x5_z = x4_z * c5 + z3_z * s5;
    const double z5_x = x4_x * s5 - z3_x * c5;
    const double z5_y = x4_y * s5 - z3_y * c5;
    const double z5_z = x4_z * s5 - z3_z * c5;
    const double v4 = q[5] + offset6;
    const double c6 = cos(v4);
    const double s6 = sin(v4);
    const double x6_x = x5_x * c6 + z4_x * s6;
    const double x6_y = x5_y * c6 + z4_y * s6;
    const double x6_z = x5_z * c6 + z4_z * s6;
    const double T13_ = x5_x * s6 - z4_x * c6;
    const double T23_ = x5_y * s6 - z4_y * c6;
    const double T33_ = x5_z * s6 - z4_z * c6;
    const double c7 = cos(q[6]);
    const double s7 = sin(q[6]);
    const double T11_ = x6_x * c7 + z5_x * s7;
    const double T21_ = x6_y * c7 + z5_y * s7;
    const double T31_ = x6_z * c7 + z5_z * s7;
    const double T12_ = z5_x * c7 - x6_x * s7;
    const double T22_ = z5_y * c7 - x6_y * s7;
    const double T32_ = z5_z * c7 - x6_z * s7;
    const double T14_ = z2_x * d3 + z4_x * d5 + T13_ * d7;
    const double T24_ = z2_y * d3 + z4_y * d5 + T23_ * d7;
    const double T34_ = d1 - c2 * d3 + z4_z * d5 + T33_ * d7;
    T[0] = T11_; T[1] = T12_; T[2] = T13_; T[3] = T14_;
    T[4] = T21_; T[5] = T22_; T[6] = T23_; T[7] = T24_;
    T[8] = T31_; T[9] = T32_; T[10] = T33_; T[11] = T34_;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kuka_iiwa14_jacobian(const double q[7], double J[42])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1);
    const double s1 = sin(v1);
    const double v2 = q[1] + offset2;
    const double c2 = cos(v2);
    const double s2 = sin(v2);
    const double x2_x = c1 * c2;
    const double x2_y = s1 * c2;
    const double J43 = c1 * s2;
    const double J53 = s1 * s2;
    const double c3 = cos(q[2]);
    const double s3 = sin(q[2]);
    const double x3_x = x2_x * c3 + s1 * s3;
    const double x3_y = x2_y * c3 - c1 * s3;
    const double x3_z = s2 * c3;
    const double J54 = c1 * c3 + x2_y * s3;
    const double J64 = s2 * s3;
    const double p3_x = J43 * d3;
    const double p3_y = J53 * d3;
    const double p3_z = d1 - c2 * d3;
    const double J44 = x2_x * s3 - s1 * c3;
    const double v3 = q[3] + offset4;
    const double c4 = cos(v3);
    const double s4 = sin(v3);
    const double x4_x = x3_x * c4 + J43 * s4;
    const double x4_y = x3_y * c4 + J53 * s4;
    const double x4_z = x3_z * c4 - c2 * s4;
    const double J65 = c2 * c4 + x3_z * s4;
    const double J45 = x3_x * s4 - J43 * c4;
    const double J55 = x3_y * s4 - J53 * c4;
    const double c5 = cos(q[4]);
    const double s5 = sin(q[4]);
    const double p5_x = p3_x + J45 * d5;
    const double p5_y = p3_y + J55 * d5;
    const double p5_z = p3_z + J65 * d5;
    const double J46 = x4_x * s5 - J44 * c5;
    const double J56 = x4_y * s5 - J54 * c5;
    const double J66 = x4_z * s5 - J64 * c5;
    const double v4 = q[5] + offset6;
    const double c6 = cos(v4);
    const double s6 = sin(v4);
    const double J47 = (x4_x * c5 + J44 * s5) * s6 - J45 * c6;
    const double J57 = (x4_y * c5 + J54 * s5) * s6 - J55 * c6;
    const double J67 = (x4_z * c5 + J64 * s5) * s6 - J65 * c6;
    const double J21 = p5_x + J47 * d7;
    const double p7_y = p5_y + J57 * d7;
    const double p7_z = p5_z + J67 * d7;
    const double v5 = p7_z - d1;
    const double J32 = s1 * p7_y + c1 * J21;
    const double J13 = J53 * v5 + c2 * p7_y;
    const double J33 = J43 * p7_y - J53 * J21;
    const double v6 = J21 - p3_x;
    const double v7 = p7_y - p3_y;
    const double v8 = p7_z - p3_z;
    const double J14 = J54 * v8 - J64 * v7;
    const double J24 = J64 * v6 - J44 * v8;
    const double J34 = J44 * v7 - J54 * v6;
    const double J15 = J55 * v8 - J65 * v7;
    const double J25 = J65 * v6 - J45 * v8;
    const double J35 = J45 * v7 - J55 * v6;
    const double v9 = J21 - p5_x;
    const double v10 = p7_y - p5_y;
    const double v11 = p7_z - p5_z;
    const double J16 = J56 * v11 - J66 * v10;
    const double J26 = J66 * v9 - J46 * v11;
    const double J36 = J46 * v10 - J56 * v9;
    const double J17 = J57 * v11 - J67 * v10;
    const double J27 = J67 * v9 - J47 * v11;
    const double J37 = J47 * v10 - J57 * v9;
    J[0] = -p7_y; J[1] = -(c1 * v5); J[2] = J13; J[3] = J14; J[4] = J15; J[5] = J16; J[6] = J17;
    J[7] = J21; J[8] = -(s1 * v5); J[9] = -(c2 * J21 + J43 * v5); J[10] = J24; J[11] = J25;
    J[12] = J26; J[13] = J27;
    J[14] = 0.0; J[15] = J32; J[16] = J33; J[17] = J34; J[18] = J35; J[19] = J36; J[20] = J37;
    J[21] = 0.0; J[22] = s1; J[23] = J43; J[24] = J44; J[25] = J45; J[26] = J46; J[27] = J47;
    J[28] = 0.0; J[29] = -c1; J[30] = J53; J[31] = J54; J[32] = J55; J[33] = J56; J[34] = J57;
    J[35] = 1.0; J[36] = 0.0; J[37] = -c2; J[38] = J64; J[39] = J65; J[40] = J66; J[41] = J67;
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
    const double T[16], const double free_joints[1], const double seed[7], double q[8][7],
    unsigned char status[8])
{
    const double T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3];
    const double T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7];
    const double T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11];

    const double c3 = cos(free_joints[0]);
    const double s3 = sin(free_joints[0]);

    /* theta4, type 2: the squared length of column 4 of U1 A7^-1 */
    const double wx = T14 - T13 * d7;
    const double wy = T24 - d7 * T23;
    const double wz = T34 - d7 * T33;
    const double v1 = wy * wy;
    const double Z4 = wx * wx + (v1 + (wz * (wz - k2) + k3));
    const double D4 = k4 - Z4 * Z4;
    const double v2 = 2.0 * fabs(Z4);
    const int apart4 = merge_slack2 * (v2 + merge_slack2) < D4;
    if (!(-(reach_slack2 * (v2 + reach_slack2)) <= D4)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4 : 0.0);
    const double v3 = k5 * (k1 * Z4);

    /* theta1, type 2: U1 A7^-1 [3, 4] */
    const double N1 = v1 + -wx * -wx;
    const int free1 = N1 <= free_limit_squared2;
    const double inverse1 = 1.0 / (free1 ? 1.0 : N1);
    const double v8 = seed[0] + offset1;

    /* theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4] */
    const double X2_2 = d3 + d5 * v3;
    const double Z1_2 = wz - d1;
    const double v11 = X2_2 * Z1_2;
    const double v13 = seed[1] + offset2;

    /* theta5, type 2: U5[3, 3] */
    const double v14 = c3 * T13;
    const double v15 = v3 * v14;
    const double v16 = c3 * T23;
    const double v17 = v3 * v16;
    const double v21 = c3 * T33;
    const double v22 = v3 * v21;
    const double v25 = s3 * T33;

    /* theta6, type 3: U5[2, 3] and U5[1, 3] */
    const double v28 = T33 * v3;
    const double v29 = T13 * v3;
    const double v30 = T23 * v3;

    /* theta7, type 3: U5[3, 2] and U5[3, 1] */
    const double v32 = s3 * T32;
    const double v35 = v3 * (c3 * T12);
    const double v36 = v3 * (c3 * T22);
    const double v40 = v3 * (c3 * T32);
    const double v42 = s3 * T31;
    const double v45 = v3 * (c3 * T11);
    const double v46 = v3 * (c3 * T21);
    const double v50 = v3 * (c3 * T31);

    for (int i1 = 0; i1 < 2; i1++) { /* noflip4, flip4 */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e1 < 0.0 && !apart4) continue; /* both signs give the same */
        const double v4 = k5 * (k1 * (w4 * e1));

        /* theta1 */
        const double Z1 = d5 * (s3 * v4);
        const double D1 = N1 - Z1 * Z1;
        const double v5 = 2.0 * fabs(Z1);
        const int apart1 = merge_slack1 * (v5 + merge_slack1) < D1;
        if (!(-(reach_slack1 * (v5 + reach_slack1)) <= D1)) continue; /* out of reach */
        const double w1 = sqrt(apart1 ? D1 : 0.0);
        const double v6 = -wx * Z1;
        const double v7 = wy * Z1;

        /* theta2 */
        const double v9 = d5 * (c3 * v4);
        const double v10 = v9 * Z1_2;

        /* theta5 */
        const double v18 = T33 * v4;
        const double v19 = T13 * v4;
        const double v20 = T23 * v4;

        /* theta6 */
        const double v26 = v4 * v14;
        const double v27 = v4 * v16;
        const double v31 = v4 * v21;

        /* theta7 */
        const double v37 = T32 * v4;
        const double v38 = T12 * v4;
        const double v39 = T22 * v4;
        const double v47 = T31 * v4;
        const double v48 = T11 * v4;
        const double v49 = T21 * v4;

        /* joint values */
        const double q4 = wrap(atan2(-v4, -v3) - offset4);

        for (int i2 = 0; i2 < 2; i2++) { /* left, right */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta1 */
            if (e2 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
            const double root1 = w1 * e2;
            const double c1 = free1 ? cos(v8) : inverse1 * (v7 - -wx * root1);
            const double s1 = free1 ? sin(v8) : inverse1 * (v6 + wy * root1);

            /* theta2 */
            const double S2 = root1 * X2_2 - v10;
            const double v12 = root1 * v9 + v11;
            const double w2 = sqrt(S2 * S2 + v12 * v12);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v13) : -(v12 * factor2);
            const double s2 = free2 ? sin(v13) : S2 * factor2;

            /* theta5 */
            const double v23 = T13 * s1 - T23 * c1;
            const double v24 = s3 * v23;
            const double X5 = v3 * v24 - (c2 * (v18 - (c1 * v15 + s1 * v17)) - s2 * (c1 * v19 + s1 *
                v20 + v22));
            const double Y5 = c2 * (s3 * (T13 * c1 + T23 * s1)) + s2 * v25 - c3 * v23;
            const double w5 = sqrt(X5 * X5 + Y5 * Y5);
            const int free5 = w5 <= free_limit;
            const double divisor5 = free5 ? 1.0 : w5;

            /* theta6 */
            const double c6 = v4 * v24 - (s2 * (c1 * v29 + s1 * v30 - v31) - c2 * (c1 * v26 + s1 *
                v27 + v28));

            /* theta7 */
            const double v33 = T12 * s1 - T22 * c1;
            const double v34 = c3 * v33 - (c2 * (s3 * (T12 * c1 + T22 * s1)) + s2 * v32);
            const double v41 = c2 * (v37 - (c1 * v35 + s1 * v36)) - s2 * (c1 * v38 + s1 * v39 + v40)
                - v3 * (s3 * v33);
            const double v43 = T11 * s1 - T21 * c1;
            const double v44 = c3 * v43 - (c2 * (s3 * (T11 * c1 + T21 * s1)) + s2 * v42);
            const double v51 = c2 * (v47 - (c1 * v45 + s1 * v46)) - s2 * (c1 * v48 + s1 * v49 + v50)
                - v3 * (s3 * v43);

            /* joint values */
            const double q1 = wrap(atan2(s1, c1) - offset1);
            const double q2 = wrap(atan2(s2, c2) - offset2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip5, flip5 */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta5 */
                if (e3 < 0.0 && free5) continue; /* both signs give the same */
                const double factor5 = e3 / divisor5;
                const double c5 = free5 ? cos(seed[4]) : -(X5 * factor5);
                const double s5 = free5 ? sin(seed[4]) : Y5 * factor5;
                const double q5 = atan2(s5, c5);
                const double s6 = w5 * e3;

                /* theta7 */
                const double c7 = c5 * v34 + s5 * v41;
                const double s7 = c5 * v44 + s5 * v51;
                const double q7 = atan2(s7, c7);

                /* joint values */
                const double q6 = wrap(atan2(s6, c6) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1;
                q[row][1] = q2;
                q[row][2] = free_joints[0];
                q[row][3] = q4;
                q[row][4] = q5;
                q[row][5] = q6;
                q[row][6] = q7;
                status[row] = (free1 || free2 || free5) ? KUKA_IIWA14_FREE_JOINT : KUKA_IIWA14_OK;
            }
        }
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

int kuka_iiwa14_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[8][7],
    unsigned char status[8])
{
    static const double zeros[7] = { 0.0 };
    const double *seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = read_pose(T, pose) && isfinite(free_joints[0]);
    int count = 0;
    for (int row = 0; row < 8; row++) {
        status[row] = valid ? KUKA_IIWA14_UNREACHABLE : KUKA_IIWA14_INVALID_POSE;
        for (int i = 0; i < 7; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -KUKA_IIWA14_INVALID_POSE;
    solve(pose, free_joints, seed, q, status);
    for (int row = 0; row < 8; row++) {
        if (status[row] == KUKA_IIWA14_UNREACHABLE)
            continue;
        for (int i = 0; i < 7; i++) {
            q[row][i] = turned(i, q[row][i], q[row][i]);
            if (!inside(i, q[row][i]))
                status[row] = KUKA_IIWA14_OUT_OF_LIMITS;
        }
        count += status[row] != KUKA_IIWA14_OUT_OF_LIMITS;
    }
    return count;
}

int kuka_iiwa14_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    double all[8][7], least = HUGE_VAL;
    unsigned char status[8];
    int result = -KUKA_IIWA14_UNREACHABLE;
    for (int i = 0; i < 7; i++)
        q[i] = NAN;
    if (kuka_iiwa14_ik(T, free_joints, q_seed, all, status) < 0)
        return -KUKA_IIWA14_INVALID_POSE;
    for (int row = 0; row < 8; row++) {
        double distance = 0.0;
        if (status[row] == KUKA_IIWA14_OUT_OF_LIMITS && result < 0)
            result = -KUKA_IIWA14_OUT_OF_LIMITS;
        if (status[row] != KUKA_IIWA14_OK && status[row] != KUKA_IIWA14_FREE_JOINT)
            continue;
        for (int i = 0; i < 7; i++) {
            all[row][i] = turned(i, all[row][i], q_seed[i]);
            const double moved = all[row][i] - q_seed[i];
            distance += moved * moved;
        }
        if (distance < least) {
            least = distance;
            result = status[row];
            for (int i = 0; i < 7; i++)
                q[i] = all[row][i];
        }
    }
    return result;
}

void kuka_iiwa14_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    for (size_t k = 0; k < n; k++)
        (void)kuka_iiwa14_ik(
            T + 16 * k, free_joints + 1 * k, NULL, (double (*)[7])(q + 56 * k), status + 8 * k);
}
