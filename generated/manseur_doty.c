/* manseur_doty: Arm with 16 real solutions
 *
 * Inverse kinematics, generated from robots/manseur_doty.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/manseur_doty.yaml. The formulas and where they come from:
 * manseur_doty.md.
 */
#include "manseur_doty.h"

#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the general algorithm has to do for the arm */
#ifdef MANSEUR_DOTY_LANES
#define DHGEN_GENERAL_LANES MANSEUR_DOTY_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = MANSEUR_DOTY_OK, NONE = MANSEUR_DOTY_UNREACHABLE, FREE = MANSEUR_DOTY_FREE_JOINT,
    OUT = MANSEUR_DOTY_OUT_OF_LIMITS, INVALID = MANSEUR_DOTY_INVALID_POSE
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

/* The monomials of the left side of the formulation that has the joints 2, 3, 4, 5, 0, 1. */
DHGEN_TABLE double manseur_doty_left_0[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.4175503608665452, 0.49473811076092117,
        -0.4175503608665452, 0.4725631775131589, -1.6278526213400133, -0.4725631775131589,
        -0.39631010962441515, -0.45013358315244806, 0.39631010962441515, -0.7573301240873739,
        -0.8739226723481909, 0.7573301240873739, -0.886055957837173, 3.052223665012525,
        0.886055957837173, 0.7686582580831766, 0.8977117537393765, -0.7686582580831766 },
    { -0.008762824931332168, 0.030185567165599742, 0.008762824931332168, 0.030183125392774925,
        0.03504185527067891, -0.030183125392774925, 0.008762824931332168, -0.030185567165599742,
        -0.008762824931332168, 0.7572147790412647, 0.8737895696922527, -0.7572147790412647,
        0.8859210072230859, -3.0517587965645663, -0.8859210072230859, -0.7685411877073907,
        -0.8975750278911175, 0.7685411877073907, 0.41748676592413464, 0.4946627597503344,
        -0.41748676592413464, 0.4724912038523125, -1.627604691501102, -0.4724912038523125,
        -0.3962497496751482, -0.45006502562746303, 0.3962497496751482 },
    { 0.502021904093082, -1.729329984719921, -0.502021904093082, -1.729190095648476,
        -2.0075465439278197, 1.729190095648476, -0.502021904093082, 1.729329984719921,
        0.502021904093082, 0.013217233132771206, 0.015252053672577575, -0.013217233132771206,
        0.015463808702350885, -0.053268647939293666, -0.015463808702350885, -0.013414936331441963,
        -0.015667230389786166, 0.013414936331441963, 0.007287258605877346, 0.008634370589013384,
        -0.007287258605877346, 0.008247364641253805, -0.028409945567623288, -0.008247364641253805,
        -0.006916565108369677, -0.007855914244247279, 0.006916565108369677 },
    { 0.6953580640433468, 0.0, 0.6953580640433468, 0.0, 0.0, 0.0, 0.6953580640433468, 0.0,
        0.6953580640433468, -0.1374354761873909, 0.0, -0.1374354761873909, -0.9424146938563946, 0.0,
        -0.9424146938563946, 0.1374354761873909, 0.0, 0.1374354761873909, 0.25769151785135797, 0.0,
        0.25769151785135797, 1.76702755098074, 0.0, 1.76702755098074, -0.25769151785135797, 0.0,
        -0.25769151785135797 },
    { 0.015048232725877613, 0.0, 0.015048232725877613, -0.010193964104626769, 0.0,
        -0.010193964104626769, -0.019902501347128454, 0.0, -0.019902501347128454,
        -0.2576522701850323, 0.0, -0.2576522701850323, -1.7667584241259355, 0.0,
        -1.7667584241259355, 0.2576522701850323, 0.0, 0.2576522701850323, -0.1374145440986839, 0.0,
        -0.1374145440986839, -0.9422711595338323, 0.0, -0.9422711595338323, 0.1374145440986839, 0.0,
        0.1374145440986839 },
    { -0.9084581138591411, 0.0, -0.9084581138591411, 0.5840118124194066, 0.0, 0.5840118124194066,
        1.0938681001502528, 0.0, 1.0938681001502528, -0.004497337104982398, 0.0,
        -0.004497337104982398, -0.030838883005593586, 0.0, -0.030838883005593586,
        0.004497337104982398, 0.0, 0.004497337104982398, -0.0023985797893239457, 0.0,
        -0.0023985797893239457, -0.016447404269649912, 0.0, -0.016447404269649912,
        0.0023985797893239457, 0.0, 0.0023985797893239457 },
    { 1.3943388596621829, 0.0, 1.3943388596621829, 0.10833110637460869, 0.0, 0.10833110637460869,
        1.7657597958036981, 0.0, 1.7657597958036981, -0.19071687118570732, 0.0,
        -0.19071687118570732, -1.307772830987707, 0.0, -1.307772830987707, 0.19071687118570732, 0.0,
        0.19071687118570732, 0.35859807641068864, 0.0, 0.35859807641068864, 2.458958238244722, 0.0,
        2.458958238244722, -0.35859807641068864, 0.0, -0.35859807641068864 },
    { -0.7087415190058218, 1.2782810678357894, 0.7087415190058218, -0.16037781446369773,
        -0.18619463988344825, 0.16037781446369773, -0.8018639304676557, 1.599062645447025,
        0.8018639304676557, 0.2897344521090147, 0.3433132717934823, -0.2897344521090147,
        0.32788393926034326, -1.1294716884820695, -0.32788393926034326, -0.2749557094840808,
        -0.312277912281121, 0.2749557094840808, -0.5269533401218027, -0.6080893412577341,
        0.5269533401218027, -0.6165083832055321, 2.1237050101121633, 0.6165083832055321,
        0.5348132694937, 0.6245951929387185, -0.5348132694937 },
    { -0.0004061169629149695, 0.0013989633431254163, 0.0004061169629149695, 0.0013988501780934181,
        0.001624030144268848, -0.0013988501780934181, 0.0004061169629149695, -0.0013989633431254163,
        -0.0004061169629149695, 0.5587103133043643, 1.2397322919790106, -0.5587103133043643,
        -0.07885844772648563, 0.28999017890475054, 0.07885844772648563, 0.7115631870232071,
        1.427842058708889, -0.7115631870232071, 0.3103727708827452, 0.6872178236750158,
        -0.3103727708827452, -0.05002553486923625, 0.1379292669774681, 0.05002553486923625,
        0.3645764883952727, 0.7301756208088214, -0.3645764883952727 },
    { -0.34914632733916195, 1.202374719463507, 0.34914632733916195, 1.2019856052617963,
        1.3950802670389195, -1.2019856052617963, 0.34914632733916195, -1.202374719463507,
        -0.34914632733916195, -0.31952210347170523, -0.6977257794056658, 0.31952210347170523,
        0.03925836086227607, -0.10084449669265927, -0.03925836086227607, -0.3551871830829677,
        -0.7191637223591473, 0.3551871830829677, 0.5535686556003837, 1.2335518319915106,
        -0.5535686556003837, -0.0845688009751665, 0.3096580109626984, 0.0845688009751665,
        0.7162534512974577, 1.4330745924939559, -0.7162534512974577 },
    { -0.0025786763196232678, 0.028370489332696997, 0.0025786763196232678, 0.045088363023979665,
        0.07497723174807887, -0.045088363023979665, 0.0025786763196232678, -0.028370489332696997,
        -0.0025786763196232678, 0.5214563308312348, 0.5960031215359919, -0.5214563308312348,
        0.617287551959425, -2.1257887571796137, -0.617287551959425, -0.5410945518952818,
        -0.6372433857704906, 0.5410945518952818, 0.29944116361708806, 0.3648972953523557,
        -0.29944116361708806, 0.3264577312675165, -1.1242386380081282, -0.3264577312675165,
        -0.26249534245201067, -0.2873110709056934, 0.26249534245201067 },
    { 0.9856639475261181, -1.777714155826987, -0.9856639475261181, 0.2230790056195141,
        0.2590257728100694, -0.2230790056195141, 1.115159414232296, -2.223854152284278,
        -1.115159414232296, -0.01554413770485677, 0.5637436036390754, 0.01554413770485677,
        -1.1317866337739297, 1.7127540769783467, 1.1317866337739297, -0.09699401631368762,
        -0.8000737270780187, 0.09699401631368762, 0.042141042842510246, -1.031669065412678,
        -0.042141042842510246, 2.127271073635935, -3.2138639251264767, -2.127271073635935,
        0.20022534273118064, 1.540638475117429, -0.20022534273118064 },
    { 0.014000112517891846, 0.013881642222257436, -0.014000112517891846, 0.06502990505895369,
        0.15418053046177416, -0.06502990505895369, -0.021332997150361473, 8.575707768471164e-05,
        0.021332997150361473, 0.6835475044608418, 1.8609733773658306, -0.6835475044608418,
        -1.2679472220019177, 0.25518707149698017, 1.2679472220019177, -0.9531284007471286,
        -2.427093259567033, 0.9531284007471286, 0.4000523365180866, 1.0701621548525908,
        -0.4000523365180866, -0.6786027981952021, 0.15243525406168212, 0.6786027981952021,
        -0.46116043273605123, -1.1984891569103164, 0.46116043273605123 },
    { -0.5876500002054882, -0.08856321606194606, 0.5876500002054882, -1.8196735380223927,
        -4.816674364208902, 1.8196735380223927, 0.8677313358836443, -0.44492504237263697,
        -0.8677313358836443, 0.44273358366231497, 0.9863481115253225, -0.44273358366231497,
        -0.09158642983171082, 0.19583480021828445, 0.09158642983171082, 0.48931146188026065,
        0.9709464841140858, -0.48931146188026065, -0.770645024105946, -1.7068104413238285,
        0.770645024105946, 0.0979223025364333, -0.40091784376840706, -0.0979223025364333,
        -0.9983725843072296, -2.00812653634384, 0.9983725843072296 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation manseur_doty_formulations[2] = {
    { { 2, 3, 4, 5, 0, 1 }, 1.0, manseur_doty_left_0 },
    { { 5, 4, 3, 2, 1, 0 }, -1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double manseur_doty_constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.20860741921300402, 0.0, 0.0, -1.0,
        -0.046345438382874284, 0.9230769230769231, 0.38461538461538464, 0.0, 0.0 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.6953580640433468, 0.882218554549757,
        0.47051656242653705, -0.01745240643728351, -0.0016179252730085187, 0.015399182150544274,
        0.008212897146956947, 0.9998476951563913, 0.046345438429219725 },
    { 0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.96, 0.28, 0.0, 0.04636661657662248 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 1.0430370960650202, 0.7240276413201454,
        0.6895501345906148, -0.01745240643728351, 0.0, 0.01263794948906737, 0.012036142370540353,
        0.9998476951563913, 0.0 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9459459459459459,
        0.32432432432432434, 0.0, 0.0 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.0 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 0.9998476951563913, 0.01745240643728351, -0.0, 0.0,
        -0.01745240643728351, 0.9998476951563913, -0.0 },
};

DHGEN_TABLE dhgen_general_arm manseur_doty_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    1.438108007528137, 0.6953580640433468, /* the length that is one in the loop, and its inverse */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, manseur_doty_formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    manseur_doty_constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.3333333333333333, 0.3333333333333333, 0.3333333333333333, 0.3333333333333333,
    0.3333333333333333, 0.3333333333333333,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
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
/* How the loop counts the joints: from where, and which way. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

static const struct dhgen_numerical_arm manseur_doty_descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_WHOLE_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 3.0, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero,
    0, 0,
    manseur_doty_fk, manseur_doty_jacobian, 0,
};

static void all_joints(
    const double T[16],
    const double seed[6], double q[16][6], int found[16],
    int chosen[16])
{
    dhgen_general_rows(&manseur_doty_general, &manseur_doty_descents, T, 0, seed, q[0], found,
        chosen);
}

static const double
    a1 = 0.3, /* link length 1 [m] */
    a2 = 1.0, /* link length 2 [m] */
    ca2 = 0.9998476951563913, /* cosine of twist 2 */
    sa2 = 0.01745240643728351, /* sine of twist 2 */
    d3 = 0.2, /* joint offset 3 [m] */
    a4 = 1.5; /* link length 4 [m] */

const char *const manseur_doty_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void manseur_doty_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, y2_z = c2 * ca2, y2_x = s1 * sa2 - v1 * ca2, v3 = v2 * ca2 + c1 * sa2,
        v4 = c2 * sa2, z2_x = v1 * sa2 + s1 * ca2, z2_y = v2 * sa2 - c1 * ca2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v3 * s3, x3_z = s2 * c3 + y2_z * s3, z3_y = v3 * c3 + x2_y * s3,
        z3_x = x2_x * s3 - y2_x * c3, z3_z = s2 * s3 - y2_z * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - v4 * s4, v5 = z2_x * c4 - x3_x * s4,
        v6 = z2_y * c4 - x3_y * s4, v7 = v4 * c4 + x3_z * s4, y4_x = ca2 * v5 + sa2 * z3_x,
        y4_y = ca2 * v6 + sa2 * z3_y, y4_z = sa2 * z3_z - ca2 * v7, z4_x = ca2 * z3_x - sa2 * v5,
        z4_y = ca2 * z3_y - sa2 * v6, z4_z = sa2 * v7 + ca2 * z3_z;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, z5_x = x4_x * s5 - y4_x * c5,
        z5_y = x4_y * s5 - y4_y * c5, z5_z = x4_z * s5 - y4_z * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), v8 = z4_x * c6 - x5_x * s6,
        v9 = z4_y * c6 - x5_y * s6, v10 = z4_z * c6 - x5_z * s6;
    T[0] = x5_x * c6 + z4_x * s6; T[1] = ca2 * v8 + sa2 * z5_x; T[2] = ca2 * z5_x - sa2 * v8;
    T[3] = c1 * a1 + x2_x * a2 + z2_x * d3 + x4_x * a4;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = ca2 * v9 + sa2 * z5_y; T[6] = ca2 * z5_y - sa2 * v9;
    T[7] = s1 * a1 + x2_y * a2 + z2_y * d3 + x4_y * a4;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = ca2 * v10 + sa2 * z5_z; T[10] = ca2 * z5_z - sa2 * v10;
    T[11] = s2 * a2 - v4 * d3 + x4_z * a4;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void manseur_doty_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = s2 * a2,
        y2_z = c2 * ca2, y2_x = s1 * sa2 - v1 * ca2, v3 = v2 * ca2 + c1 * sa2, v4 = c2 * sa2,
        z2_x = v1 * sa2 + s1 * ca2, z2_y = v2 * sa2 - c1 * ca2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v3 * s3, x3_z = s2 * c3 + y2_z * s3, z3_y = v3 * c3 + x2_y * s3,
        p3_x = p2_x + z2_x * d3, p3_y = p2_y + z2_y * d3, p3_z = p2_z - v4 * d3,
        z3_x = x2_x * s3 - y2_x * c3, z3_z = s2 * s3 - y2_z * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - v4 * s4, v5 = z2_x * c4 - x3_x * s4,
        v6 = z2_y * c4 - x3_y * s4, v7 = v4 * c4 + x3_z * s4, p4_x = p3_x + x4_x * a4,
        p4_y = p3_y + x4_y * a4, p4_z = p3_z + x4_z * a4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v8 = p4_x - p2_x, v9 = p4_y - p2_y,
        v10 = p4_z - p2_z, v11 = p4_x - p3_x, v12 = p4_y - p3_y, v13 = p4_z - p3_z;
    J[0] = -p4_y; J[1] = -(c1 * p4_z); J[2] = z2_y * v10 + v4 * v9; J[3] = z3_y * v13 - z3_z * v12;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = p4_x; J[7] = -(s1 * p4_z); J[8] = -(v4 * v8 + z2_x * v10);
    J[9] = z3_z * v11 - z3_x * v13; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = s1 * (p4_y - p1_y) + c1 * (p4_x - p1_x); J[14] = z2_x * v9 - z2_y * v8;
    J[15] = z3_x * v12 - z3_y * v11; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = z2_x; J[21] = z3_x; J[22] = ca2 * z3_x - sa2 * v5;
    J[23] = x4_x * s5 - (ca2 * v5 + sa2 * z3_x) * c5;
    J[24] = 0.0; J[25] = -c1; J[26] = z2_y; J[27] = z3_y; J[28] = ca2 * z3_y - sa2 * v6;
    J[29] = x4_y * s5 - (ca2 * v6 + sa2 * z3_y) * c5;
    J[30] = 1.0; J[31] = 0.0; J[32] = -v4; J[33] = z3_z; J[34] = sa2 * v7 + ca2 * z3_z;
    J[35] = x4_z * s5 - (sa2 * z3_z - ca2 * v7) * c5;
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
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        q[row][5] = q6;
        status[row] = (chosen) ? FREE : OK;
    }
}

static void take(const double from[6], double to[6])
{
    for (int i = 0; i < 6; i++)
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

int manseur_doty_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16])
{
    const double zeros[6] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 6; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 16; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 6; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 16; row++) {
        if (status[row] == NONE)
            continue;
        for (int i = 0; i < 6; i++) {
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

int manseur_doty_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = manseur_doty_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 6; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 16 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 6; i++) {
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

void manseur_doty_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)manseur_doty_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
