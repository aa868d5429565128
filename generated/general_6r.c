/* general_6r: General arm with six revolute joints
 *
 * Inverse kinematics, generated from robots/general_6r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_6r.yaml. The formulas and where they come from:
 * general_6r.md.
 */
#include "general_6r.h"

#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the general algorithm has to do for the arm */
#ifdef GENERAL_6R_LANES
#define DHGEN_GENERAL_LANES GENERAL_6R_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = GENERAL_6R_OK, NONE = GENERAL_6R_UNREACHABLE, FREE = GENERAL_6R_FREE_JOINT,
    OUT = GENERAL_6R_OUT_OF_LIMITS, INVALID = GENERAL_6R_INVALID_POSE
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

/* The monomials of the left side of the formulation that has the joints 3, 2, 1, 0, 5, 4. */
DHGEN_TABLE double general_6r_left_1[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.30950123543011937, -0.25901396578947855, -0.5131601426338478, 0.046225306226263425,
        1.4620315431845567, -0.10698303591974571, -0.4480825787040523, -0.1311282350811972,
        0.21201954899713332, 0.5300777653159212, 1.0188804976320838, -0.4079634937716518,
        -0.948522660052498, 1.9233379602204057, 0.8326944152750232, -0.43998247186478,
        -0.7652390243665459, 0.6037427344167671, -0.4099048047330974, 1.0443456471382615,
        0.2201967463067958, -1.177839050326179, -1.3698199111362692, 1.1944117835603039,
        0.32975158605512067, -1.2699976173322642, -0.3943716192322738 },
    { 0.29476308136201845, -0.24667996741855103, -0.48872394536556935, 0.044024101167869936,
        1.3924109935091018, -0.10188860563785307, -0.42674531305147845, -0.12488403341066401,
        0.20192337999726984, -0.6793403685961031, 0.11569504804956876, 0.44892218328278066,
        -0.26722102956846805, -2.373779402961608, 0.35903325404954656, 0.5557424018524205,
        -0.4636551819992243, -0.717503539172153, -0.13182908127916937, -1.5023461326486223,
        0.16640628871869098, 1.5387578103954216, -0.5584114538696523, -1.4601933448316085,
        0.11656855990824135, 1.4593838315665848, -0.1995677688738012 },
    { 0.21667990612985333, -0.1813340800258518, -0.35926025103247006, 0.03236205180251039,
        1.0235592665595075, -0.07489816364823901, -0.31369984987972116, -0.0918020686698756,
        0.1484335786593825, 0.1669962745876272, -1.612735614832615, -0.027969740303705016,
        1.7183680565973114, 0.4819415806383674, -1.677819162061972, -0.12754862551601262,
        1.723790914661482, 0.11369043097068084, 0.7648350631335933, 0.5520119953106292,
        -0.5408973888430041, -0.4108657514134413, 2.716264955695517, 0.2803174884443172,
        -0.6295859806023434, -0.17125096732594222, 0.834796899701207 },
    { 0.4902909836957804, 0.524013206945935, 0.31391576860693543, -0.706092514743039,
        0.11661432559274983, 0.22905096318582438, 0.7553700003602607, -0.4247371866506799,
        0.6796400134834827, -0.7346813986969543, 0.6140622277019022, -0.09345729953588862,
        -0.4957404143722831, -1.117423852926042, 0.7594402483843676, 0.5190453822177139,
        -0.6786041203539478, 0.041721355137450455, -0.4038194682667984, -0.3907012979451544,
        0.27348000214328344, 1.1484262037912023, -1.5377242184165625, 0.3003378648855655,
        0.36508502051884306, 0.4481209503761149, -0.4580280414297687 },
    { -0.11472715603332277, 0.49906019709136673, -0.2827035513560323, -0.6724690616600373,
        0.11106126246928556, 0.2181437744626899, 0.13772905031380134, -0.40451160633398087,
        0.06560525328829847, 0.18750947767534548, -0.7216903759739207, 0.27587560133915523,
        1.2288904809543775, -0.43129325348725917, -0.2846690865179207, -0.07057100488304008,
        0.8102327003952062, -0.383784785758999, 0.8452425387185433, -0.21007568228054818,
        -0.1139132500483076, -0.3982267855538355, 1.9151113041131058, -0.7939121387925525,
        -0.6515452729067164, 0.2210079174107975, 0.27984879316768163 },
    { 0.06890569265146798, 0.3668584144229851, -0.05457350766892113, -0.4943310148694316,
        0.08164097014901354, 0.16035716669461497, 0.2544858773897673, -0.29735588488178016,
        0.2014677806287926, 0.7943234432496128, 0.10464588669836264, -0.2417981140605195,
        -0.963630074662178, 2.182820732185485, -0.697516261195029, -0.6453919178954033,
        -0.1329051423623272, 0.46249223964158825, -0.5730280814189361, 0.8438488510182509,
        -0.23567011288058304, -1.098656440899022, -0.4087899306536951, 0.6510112112017459,
        0.36485721640404745, -0.9407377275804152, 0.2735424486434977 },
    { 1.4641618578099642, -0.5567987479616532, 0.3247506176826911, -0.9477932746931333,
        0.6898314117016586, 0.04126212526057191, 1.3452352937518837, -1.5516979352560307,
        0.8697343688016201, -0.6539733754533883, 0.782154710697146, -0.1882659220295696,
        -0.9008875262620831, -0.6959460343641213, 0.7138862800640772, 0.43621700916935613,
        -0.8696541920826125, 0.19270897873776394, -0.6688924276330267, -0.2186198970967655,
        0.2618294202384469, 1.0660935133510783, -2.003631092858169, 0.5663892149431278,
        0.5577771384910557, 0.25906373405381716, -0.4756492865179597 },
    { -0.25131316171804513, -0.8970508931597154, 0.16541790062003486, 0.24913285877620028,
        0.7818417000187741, -0.2736419663951957, -0.6623468638495187, -0.3945790026421149,
        0.5403856364342322, 0.34933813143033937, 0.3751478930188825, -0.2534516623704825,
        -0.31598925813019607, 1.2485407388795926, 0.25146040831889405, -0.2882670105790638,
        -0.2032169466471324, 0.3861606775433206, -0.13314676456722277, 0.7224299227190599,
        0.051598249871016084, -0.7823321632183647, -0.420379275521061, 0.7724486287145039,
        0.1049185920639782, -0.8018995041706092, -0.11293874797907287 },
    { 0.525759441254196, -0.405930333339509, 0.17572513719966823, 0.07831122979534118,
        0.0908417046612657, -0.03934960503244915, 0.4330679622678076, -0.4312345973773541,
        0.2572641283888871, -0.16585627871657294, 0.484335722821417, -0.1848772629499546,
        -0.10543201197905294, 0.14011633044438662, 0.1319081653258049, -0.4122756062047583,
        0.1872508498093688, 0.0016579897144355094, 0.2733910194617679, -0.11862971362134009,
        0.08774186305520003, -0.34825038992763563, -0.10510955813438633, 0.28429317477696675,
        0.24371342989056072, -0.47104914618126387, 0.08127787957979216 },
    { 0.45883244500730364, -0.35154291096093176, 0.23681323381421288, 0.06832555228933423,
        -0.11136930512196103, -0.02299571565485531, 0.473093423971562, -0.3929514776510646,
        0.21631671914639528, 0.3596833913590044, 0.5282410772249371, 0.12154980318897254,
        -1.1823121061837918, 0.004902258069689969, 1.0718802173349122, 0.4363904132411398,
        -1.4412327242863028, 0.1362306887497609, -0.49308984461794714, -0.32882041838282017,
        0.37696631369558214, 0.26066054925297466, -1.565398132550095, -0.17445382137323867,
        0.5105284378372998, -0.01152462849768246, -0.5208314631298729 },
    { 0.5797320049376676, -0.4613148875612719, -0.22789822846569024, 0.08643618196764924,
        1.0634015767882263, -0.10070829578037231, -0.003231097032708019, -0.39157615060551476,
        0.3250976685014593, -0.5468515109866903, 0.1872591558366859, 0.21283420678184783,
        0.028820212597015837, -1.1364885153174864, 0.061731402946774205, 0.22726768431997849,
        -0.08029009827367989, -0.43745841581378564, -0.4922965031832708, -0.21288680421923917,
        -0.07762400506659461, 0.841660128471686, -0.4815378203129876, -0.7248699458770727,
        -0.40510838704515445, 1.1379346833734587, -0.2615813763326414 },
    { 0.8662407670091191, 0.46192624964054607, -0.24107184066617732, -0.8000304139429045,
        0.42675927483852955, 0.02406279781740986, 0.5051768855909508, 0.4208916738200609,
        -0.4660103616102644, -0.13811080451930408, -0.1353028050206766, 0.15416813817661418,
        -1.2801729427679764, 0.7891211286825248, -0.4367779219187655, 0.335731473857001,
        -0.44143139551999233, -0.004037861486156133, -0.8795989914612254, 0.3731844820476835,
        -0.18572337742672285, 0.32054708901300355, -0.10972359004192844, -0.3799841010974686,
        0.5187843760826252, -0.22702265927252674, 0.20469343520950978 },
    { 0.6871780650048692, -0.7237649042435191, -0.009859436429033572, -0.44908204411010066,
        1.3983377849134335, -0.3103006863508354, -0.1898863443051389, -0.18009631100694123,
        0.2628512418693924, -1.0130271234469606, 0.6505929035259068, 0.0032249247946468523,
        0.8798566531916838, -1.680971996389789, 0.30332490217883357, 0.5473712447516861,
        -0.32904378766584264, -0.22100980612038634, 0.004106144752295406, -0.31619160668354135,
        -0.007061163907857819, 1.682836538985244, -1.4192775166879599, -0.1562698855649493,
        -0.973215251069877, 1.6864906753204627, -0.5572494451896773 },
    { -0.31229778334207814, 0.43807892572035373, -0.2159176372816724, -0.5397326093695817,
        0.3116840582271355, -0.05812521120967251, -0.5126135417301078, 0.6941327463626533,
        -0.42392627126031185, 0.453911786110994, -0.9965444519571622, 0.11088525229254688,
        1.6501171568074593, -0.7911914870445338, -0.5812342301810187, -1.0166509823293062,
        1.9962071768730427, -0.5279612372978428, 0.7052369208097654, -0.14949894826919213,
        -0.18612175877900788, -1.40764145075492, 2.5579696621197927, -0.4309710904775735,
        -0.5919924200042747, 0.12636221651596277, 0.40531944625522287 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation general_6r_formulations[2] = {
    { { 5, 0, 1, 2, 3, 4 }, 1.0, 0 },
    { { 3, 2, 1, 0, 5, 4 }, -1.0, general_6r_left_1 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double general_6r_constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.625797711755665, 0.1994571100439649,
        0.08310712918498539, -0.9763759861505914, -0.05692061104264318, 0.9012701410620845,
        0.3755292254425352, 0.21607853588096199, -4.005433883479374e-11 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, -0.5099649622239675, -0.863043307915415,
        -0.46028976422155465, -0.20806148517994336, 0.10646134679468323, 0.18358366339406768,
        0.09791128714350275, -0.9781157489708037, 0.05557591778869785 },
    { 0.28, -0.96, 0.0, 0.11282410668671844, -0.7731007280684683, -0.22548771235330328,
        0.5928495220860671, 0.13178733217844682, -0.5691355412026244, -0.1659978661840988,
        -0.8053132584046545, -0.07651018689267303 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, -0.4212099982970823, -0.3274379105158329,
        -0.31184562906269797, 0.8919286509533796, 0.06330373161268073, -0.6458793679317576,
        -0.6151232075540549, -0.45217616214091205, 0.1397447250289724 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.20458771345858281, 0.9360191001495627,
        0.3209208343369929, -0.14449242971052642, -0.046066283414697685, 0.13668202810455202,
        0.04686240963584641, 0.9895059058723948, -0.0067268214344506985 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, 0.026626183228620606 },
    { 1.0, 0.0, 0.0, -0.175, 0.0, 0.1383511173830834, 0.990383243153302, 0.682307145579463, 0.0,
        -0.990383243153302, 0.1383511173830834, 0.09531457306246946 },
};

DHGEN_TABLE dhgen_general_arm general_6r_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.6647515517960572, 1.5043214224895793, /* the length that is one in the loop, and its inverse
        */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, general_6r_formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    general_6r_constants,
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
    0.3459010722933242, 0.3459010722933242, 0.3459010722933242, 0.3459010722933242,
    0.3459010722933242, 0.3459010722933242,
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
static const double zero[6] = { 2.137, -2.341, -1.611, 0.482, 0.126, 1.904 };

static const struct dhgen_numerical_arm general_6r_descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_WHOLE_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 2.8909999999999996, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero,
    0, 0,
    general_6r_fk, general_6r_jacobian, 0,
};

static void all_joints(
    const double T[16],
    const double seed[6], double q[16][6], int found[16],
    int chosen[16])
{
    dhgen_general_rows(&general_6r_general, &general_6r_descents, T, 0, seed, q[0], found, chosen);
}

static const double
    d1 = -0.035, /* joint offset 1 [m] */
    a1 = 0.416, /* link length 1 [m] */
    ca1 = 0.21607853588096199, /* cosine of twist 1 */
    sa1 = 0.9763759861505914, /* sine of twist 1 */
    d2 = -0.257, /* joint offset 2 [m] */
    a2 = -0.339, /* link length 2 [m] */
    ca2 = 0.9781157489708037, /* cosine of twist 2 */
    sa2 = 0.20806148517994336, /* sine of twist 2 */
    d3 = -0.272, /* joint offset 3 [m] */
    a3 = 0.075, /* link length 3 [m] */
    ca3 = 0.8053132584046545, /* cosine of twist 3 */
    sa3 = 0.5928495220860671, /* sine of twist 3 */
    d4 = 0.262, /* joint offset 4 [m] */
    a4 = -0.28, /* link length 4 [m] */
    ca4 = 0.45217616214091205, /* cosine of twist 4 */
    sa4 = 0.8919286509533796, /* sine of twist 4 */
    d5 = -0.167, /* joint offset 5 [m] */
    a5 = -0.136, /* link length 5 [m] */
    ca5 = 0.9895059058723947, /* cosine of twist 5 */
    sa5 = 0.1444924297105264, /* sine of twist 5 */
    d6 = -0.477, /* joint offset 6 [m] */
    a6 = 0.175, /* link length 6 [m] */
    ca6 = 0.13835111738308337, /* cosine of twist 6 */
    sa6 = 0.9903832431533018, /* sine of twist 6 */
    offset1 = 2.137, /* offset of joint 1 [rad] */
    offset2 = -2.341, /* offset of joint 2 [rad] */
    offset3 = -1.611, /* offset of joint 3 [rad] */
    offset4 = 0.482, /* offset of joint 4 [rad] */
    offset5 = 0.126, /* offset of joint 5 [rad] */
    offset6 = 1.904, /* offset of joint 6 [rad] */
    f1 = -0.05553218372140723, /* d2 * ca1 [m] */
    f2 = 0.04495762109090063, /* sa2 * ca1 */
    f3 = 0.2113498189597218; /* ca2 * ca1 */

const char *const general_6r_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void general_6r_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        y2_x = v5 * ca2 + z1_x * sa2, v8 = v6 * ca2 + v3 * sa2, y2_z = f2 - v7 * ca2,
        z2_x = v5 * sa2 - z1_x * ca2, z2_y = v3 * ca2 - v6 * sa2, v9 = v7 * sa2 + f3,
        v10 = q[2] + offset3;
    const double c3 = cos(v10), s3 = sin(v10), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v8 * s3, x3_z = x2_z * c3 + y2_z * s3, v11 = y2_x * c3 - x2_x * s3,
        v12 = v8 * c3 + x2_y * s3, v13 = y2_z * c3 - x2_z * s3, v14 = v11 * ca3 + z2_x * sa3,
        y3_y = v12 * ca3 - z2_y * sa3, y3_z = v9 * sa3 - v13 * ca3, z3_x = v11 * sa3 - z2_x * ca3,
        v15 = v12 * sa3 + z2_y * ca3, z3_z = v13 * sa3 + v9 * ca3, v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 - v14 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v17 = v14 * c4 + x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 - x3_z * s4, y4_x = v17 * ca4 - z3_x * sa4,
        y4_y = v15 * sa4 - v18 * ca4, v20 = v19 * ca4 + z3_z * sa4, v21 = v17 * sa4 + z3_x * ca4,
        z4_y = v18 * sa4 + v15 * ca4, z4_z = v19 * sa4 - z3_z * ca4, v22 = q[4] + offset5;
    const double c5 = cos(v22), s5 = sin(v22), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v20 * s5, v23 = y4_x * c5 - x4_x * s5,
        v24 = y4_y * c5 - x4_y * s5, v25 = v20 * c5 + x4_z * s5, y5_x = v23 * ca5 - v21 * sa5,
        y5_y = v24 * ca5 + z4_y * sa5, y5_z = z4_z * sa5 - v25 * ca5, v26 = v23 * sa5 + v21 * ca5,
        z5_y = z4_y * ca5 - v24 * sa5, z5_z = v25 * sa5 + z4_z * ca5, v27 = q[5] + offset6;
    const double c6 = cos(v27), s6 = sin(v27), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6, v28 = y5_x * c6 - x5_x * s6,
        v29 = y5_y * c6 - x5_y * s6, v30 = y5_z * c6 - x5_z * s6;
    T[0] = x6_x; T[1] = v28 * ca6 - v26 * sa6; T[2] = -(v28 * sa6 + v26 * ca6);
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x *
        a5 - v21 * d5 + x6_x * a6 - v26 * d6;
    T[4] = x6_y; T[5] = v29 * ca6 + z5_y * sa6; T[6] = z5_y * ca6 - v29 * sa6;
    T[7] = s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 + z2_y * d3 + x4_y * a4 - v15 * d4 + x5_y * a5
        + z4_y * d5 + x6_y * a6 + z5_y * d6;
    T[8] = x6_z; T[9] = v30 * ca6 + z5_z * sa6; T[10] = z5_z * ca6 - v30 * sa6;
    T[11] = d1 + x2_z * a2 + f1 + x3_z * a3 - v9 * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z *
        d5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void general_6r_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), p1_x = c1 * a1, p1_y = s1 * a1, v2 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v3 = c1 * sa1, v4 = q[1] + offset2;
    const double c2 = cos(v4), s2 = sin(v4), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + y1_y * s2,
        x2_z = sa1 * s2, v5 = v2 * c2 + c1 * s2, v6 = y1_y * c2 - s1 * s2, v7 = sa1 * c2,
        p2_x = p1_x + x2_x * a2 + z1_x * d2, p2_y = p1_y + x2_y * a2 - v3 * d2,
        p2_z = d1 + x2_z * a2 + f1, y2_x = v5 * ca2 + z1_x * sa2, v8 = v6 * ca2 + v3 * sa2,
        y2_z = f2 - v7 * ca2, z2_x = v5 * sa2 - z1_x * ca2, z2_y = v3 * ca2 - v6 * sa2,
        v9 = v7 * sa2 + f3, v10 = q[2] + offset3;
    const double c3 = cos(v10), s3 = sin(v10), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 - v8 * s3, x3_z = x2_z * c3 + y2_z * s3, v11 = y2_x * c3 - x2_x * s3,
        v12 = v8 * c3 + x2_y * s3, v13 = y2_z * c3 - x2_z * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 + z2_y * d3, p3_z = p2_z + x3_z * a3 - v9 * d3,
        v14 = v11 * ca3 + z2_x * sa3, y3_y = v12 * ca3 - z2_y * sa3, y3_z = v9 * sa3 - v13 * ca3,
        z3_x = v11 * sa3 - z2_x * ca3, v15 = v12 * sa3 + z2_y * ca3, z3_z = v13 * sa3 + v9 * ca3,
        v16 = q[3] + offset4;
    const double c4 = cos(v16), s4 = sin(v16), x4_x = x3_x * c4 - v14 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, v17 = v14 * c4 + x3_x * s4,
        v18 = y3_y * c4 - x3_y * s4, v19 = y3_z * c4 - x3_z * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 - v15 * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, y4_x = v17 * ca4 - z3_x * sa4,
        y4_y = v15 * sa4 - v18 * ca4, v20 = v19 * ca4 + z3_z * sa4, v21 = v17 * sa4 + z3_x * ca4,
        z4_y = v18 * sa4 + v15 * ca4, z4_z = v19 * sa4 - z3_z * ca4, v22 = q[4] + offset5;
    const double c5 = cos(v22), s5 = sin(v22), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v20 * s5, v23 = y4_x * c5 - x4_x * s5,
        v24 = y4_y * c5 - x4_y * s5, v25 = v20 * c5 + x4_z * s5, p5_x = p4_x + x5_x * a5 - v21 * d5,
        p5_y = p4_y + x5_y * a5 + z4_y * d5, p5_z = p4_z + x5_z * a5 + z4_z * d5,
        v26 = v23 * sa5 + v21 * ca5, z5_y = z4_y * ca5 - v24 * sa5, z5_z = v25 * sa5 + z4_z * ca5,
        v27 = q[5] + offset6;
    const double c6 = cos(v27), s6 = sin(v27),
        p6_x = p5_x + (x5_x * c6 + (v23 * ca5 - v21 * sa5) * s6) * a6 - v26 * d6,
        p6_y = p5_y + (x5_y * c6 + (v24 * ca5 + z4_y * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 + (z4_z * sa5 - v25 * ca5) * s6) * a6 + z5_z * d6,
        v28 = p6_x - p1_x, v29 = p6_y - p1_y, v30 = p6_z - d1, v31 = p6_x - p2_x, v32 = p6_y - p2_y,
        v33 = p6_z - p2_z, v34 = p6_x - p3_x, v35 = p6_y - p3_y, v36 = p6_z - p3_z,
        v37 = p6_x - p4_x, v38 = p6_y - p4_y, v39 = p6_z - p4_z, v40 = p6_x - p5_x,
        v41 = p6_y - p5_y, v42 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(v3 * v30 + ca1 * v29); J[2] = z2_y * v33 + v9 * v32;
    J[3] = -(v15 * v36 + z3_z * v35); J[4] = z4_y * v39 - z4_z * v38;
    J[5] = z5_y * v42 - z5_z * v41;
    J[6] = p6_x; J[7] = ca1 * v28 - z1_x * v30; J[8] = -(v9 * v31 + z2_x * v33);
    J[9] = z3_z * v34 - z3_x * v36; J[10] = z4_z * v37 + v21 * v39; J[11] = z5_z * v40 + v26 * v42;
    J[12] = 0.0; J[13] = z1_x * v29 + v3 * v28; J[14] = z2_x * v32 - z2_y * v31;
    J[15] = z3_x * v35 + v15 * v34; J[16] = -(v21 * v38 + z4_y * v37);
    J[17] = -(v26 * v41 + z5_y * v40);
    J[18] = 0.0; J[19] = z1_x; J[20] = z2_x; J[21] = z3_x; J[22] = -v21; J[23] = -v26;
    J[24] = 0.0; J[25] = -v3; J[26] = z2_y; J[27] = -v15; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = ca1; J[32] = -v9; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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

int general_6r_ik(
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

int general_6r_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = general_6r_ik(T, q_seed, all, status) >= 0;
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

void general_6r_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)general_6r_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
