/* kuka_kr6_r900_calibrated: KUKA KR 6 R900, calibrated
 *
 * Inverse kinematics, generated from robots/kuka_kr6_r900_calibrated.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr6_r900_calibrated.yaml. The formulas and where they come
 * from: kuka_kr6_r900_calibrated.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 0ecca322e1a10d95
 * SPDX-License-Identifier: MIT
 */
#include "kuka_kr6_r900_calibrated.h"

#if defined(KUKA_KR6_R900_CALIBRATED_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_KR6_R900_CALIBRATED_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef KUKA_KR6_R900_CALIBRATED_LANES
#define DHGEN_GENERAL_LANES KUKA_KR6_R900_CALIBRATED_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"
#include "dhgen/general/near.h"
#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
#include "dhgen/tile.h"
#endif

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

static const double
    d1 = 0.399973, /* joint offset 1 [m] */
    a2 = -0.024911, /* link length 2 [m] */
    ca2 = 2.9999999981991003e-05, /* cosine of twist 2 */
    sa2 = 0.99999999955, /* sine of twist 2 */
    a3 = -0.38922960954671, /* link length 3 [m] */
    ca3 = 0.9999999932995001, /* cosine of twist 3 */
    sa3 = 0.00011576268798709127, /* sine of twist 3 */
    a4 = -0.025036000000003, /* link length 4 [m] */
    ca4 = 6.199999996034639e-05, /* cosine of twist 4 */
    sa4 = 0.999999998078, /* sine of twist 4 */
    a5 = 6.9999999993558e-05, /* link length 5 [m] */
    ca5 = 9.299999986590045e-05, /* cosine of twist 5 */
    sa5 = 0.9999999956755, /* sine of twist 5 */
    a6 = -0.00012899999999461, /* link length 6 [m] */
    ca6 = 4.599999998382906e-05, /* cosine of twist 6 */
    sa6 = 0.999999998942, /* sine of twist 6 */
    ex = 2.6999999541966e-05, /* x of the tool frame [m] */
    ey = -4.9679981739493e-09, /* y of the tool frame [m] */
    ez = 0.089873000000009, /* z of the tool frame [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = -2.1157052436021195, /* offset of joint 2 [rad] */
    offset3 = -1.0259814129576739, /* offset of joint 3 [rad] */
    offset4 = -3.1415816535897934, /* offset of joint 4 [rad] */
    offset5 = 3.141458653589793, /* offset of joint 5 [rad] */
    f1 = -0.2358967394524778, /* ca3 * b3 - d3 * sa3 [m] */
    f2 = 4.899999966903515e-05, /* d3 * ca3 + sa3 * b3 [m] */
    f3 = 1.4699999891886136e-09, /* f2 * ca2 [m] */
    f4 = 3.4728806375279683e-09, /* sa3 * ca2 */
    f5 = 2.9999999780976003e-05, /* ca3 * ca2 */
    f6 = 0.4199969991926858, /* d4 * sa4 [m] */
    f7 = 2.6039813983340643e-05, /* d4 * ca4 [m] */
    f8 = -0.00018999922918564835, /* d5 * sa5 [m] */
    f9 = -1.766992836520009e-08, /* d5 * ca5 [m] */
    f10 = 0.9999999830720003, /* 9999999830720003 / 10000000000000000 */
    f11 = 0.00018399999896174938, /* 9199999948087469 / 50000000000000000000 */
    f12 = 0.00018399999890875743, /* 18399999890875743 / 100000000000000000000 */
    f13 = 0.9999999827840002, /* 4999999913920001 / 5000000000000000 */
    f14 = 2.3999999997695912e-05, /* 2999999999711989 / 125000000000000000000 */
    f15 = 4.4159999746063125e-09, /* 70655999593701 / 16000000000000000000000 */
    f16 = 2.3999999591423935e-05, /* 4799999918284787 / 200000000000000000000 */
    f17 = 0.999999999712; /* 31249999991 / 31250000000 */

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const kuka_kr6_r900_calibrated_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The monomials of the left side of the formulation that has the joints 3, 2, 1, 0, 5, 4. */
DHGEN_TABLE double left_1[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.4587299067064698, 1.1206116377569533, -0.45872990703335026, 1.1206116246460087,
        -1.8349196161550327, -1.120611633521931, -0.45872991339822095, -1.1206116185667547,
        0.45872990833751526, 0.14944020579559608, -0.24465201363970188, -0.14940048170956424,
        -0.24451051826308734, -0.5975634590317728, 0.24451051700065343, -0.14934152278372725,
        0.2443690164737286, 0.1493812492356109, 0.5122722255615991, -0.8388215576648009,
        -0.5122838119470459, -0.8388628240890247, -2.0491464528544863, 0.8388628197609794,
        -0.5123009976508666, 0.8389040685201908, 0.5122894193808579 },
    { 0.43688562543473314, 1.0672491788161462, -0.4368856257460479, 1.0672491663295323,
        -1.7475424915762219, -1.0672491747827915, -0.4368856318078295, -1.0672491605397665,
        0.43688562698810984, -0.15701237909984725, 0.25704862652478655, 0.1569706710757872,
        0.25690006445097, 0.6278422952980295, -0.25690006312456815, 0.15690876756514768,
        -0.2567514956394718, -0.15695047807493895, -0.5378566066417632, 0.8807147821124612,
        0.5378687801136107, 0.8807581395240527, 2.151486893295553, -0.8807581349798521,
        0.5378868366306803, -0.880801473844188, -0.5378746716795799 },
    { 5.891402675969753e-05, 0.0001439185521782125, -5.891402680167832e-05, 0.00014391855049439262,
        -0.00023565610566834858, -0.00014391855163431463, -5.8914027619109574e-05,
        -0.0001439185497136427, 5.891402696917037e-05, 0.742773557157152, -1.2162566008664262,
        -0.7427903630404494, -1.216316457215405, -2.971177704954464, 1.2163164509399182,
        -0.7428152906587854, 1.216376281675359, 0.742798496542538, -0.2167608293042976,
        0.3548641857003745, 0.21670323102089498, 0.35465902325014315, 0.8667571473515044,
        -0.3546590214190012, 0.216617743012983, -0.35445385149831876, -0.21667534472801975 },
    { -1.0170659620801048, -0.050693695437459885, -1.0789846909670073, -1.3077338267121785,
        -0.12383745681536376, -1.206346436462993, -0.33233851024158345, 0.05069369587926948,
        -0.270419782415024, -0.16372174828099478, -0.016512264272966638, -0.15020364701718658,
        0.18245872389253, 0.027020565972337915, 0.21547673706123416, 0.18492933524770708,
        0.01650574892296278, 0.17142687082375474, -0.5610318987780427, -0.05661123388198901,
        -0.5146833133317761, 0.6260759755693003, 0.09270173095677506, 0.7393003428602162,
        0.6346332008936288, 0.05661313350207931, 0.5882800563591902 },
    { -0.9684198359234935, -0.04827970994043799, -1.0273900539110197, -1.245460787344932,
        -0.11794043506225121, -1.1489013680599935, -0.3162984532201397, 0.04827971036120903,
        -0.25732823624246404, 0.17201753253752625, 0.017348946507301465, 0.15781446381395456,
        -0.1917040748026847, -0.028389719956040248, -0.22639512704274067, -0.19429988989408975,
        -0.01734210576135928, -0.18011323896061826, 0.5890514700823485, 0.05943856581088929,
        0.5403880994768431, -0.6573440857835903, -0.09733153233583229, -0.7762232131825851,
        -0.6663286891259362, -0.0594405616859105, -0.6176605284204268 },
    { 0.0001017687818957869, -6.510518904235084e-06, 9.381664797724643e-05, -0.0001679503876575927,
        -1.590426771398973e-05, -0.00015492934992948471, 0.00018970735060682317,
        6.51051896097606e-06, 0.00019765948438918532, -0.8134730601817969, -0.08208394997842297,
        -0.7462695262779031, 0.9077843172067488, 0.13441368211486523, 1.071954972400145,
        0.9201919439350175, 0.08208670535004041, 0.8529817971393067, 0.23747596962503337,
        0.023950798589964892, 0.21786816045220075, -0.26465379363850394, -0.03919294598649643,
        -0.3125459437905412, -0.2682373916927669, -0.023941351601562192, -0.24865225529187843 },
    { 2.690393422190922, 0.3415493639275958, 2.824123041435215, 3.469746934308736,
        0.33417715639043255, 3.227876028196439, 1.1291981528188473, 0.09967845508419546,
        0.9287506160986282, -0.00030431873909678837, -3.0711129486186535e-05,
        -0.00027917466448777213, 0.000339710429606028, 5.029826367315281e-05,
        0.00040113690266356723, 0.00034436406777675773, 3.0715343621883924e-05,
        0.00031920987924217135, 0.0003629750416713698, 3.662069243147476e-05, 0.0003329935745781612,
        -0.0004048924440200314, -5.995445113303137e-05, -0.0004781302939541831,
        -0.000410410866021849, -3.6617157562808536e-05, -0.0003804378826133886 },
    { -1.545349045954237, -1.2101263174054067, 1.5453490398979997, -1.5119932854335405,
        2.1887025070838675, 1.5119932964891527, -0.450997776670052, 1.8138602606631076,
        0.4509977773844163, 0.00013894688502092334, -0.0002275300489377129, -0.00013895973329598458,
        -0.0002275758126419057, -0.0005558513701110294, 0.00022757581146794505,
        -0.00013897879916234898, 0.00022762157038006128, 0.0001389659530888488,
        -0.00016569666890209827, 0.00027130386705504774, 0.00016568589384711346,
        0.0002712654859576871, 0.0006627331377415187, -0.00027126548455778476,
        0.0001656698989291812, -0.00027122709774752527, -0.00016568067660863687 },
    { -5.678080653912203e-05, -0.0003651703703373367, 2.0880303979906652e-05,
        -0.0003538026003898416, -0.00013612885659207885, 0.0003822535790858209,
        4.426017196455979e-05, 0.00016872406855291598, -1.3457087536819119e-05,
        -0.36389584647452944, 2.0460244761063713, 0.43707697821784286, 0.7243511184978733,
        2.00164866421533, -0.7243333307357445, 0.636951646516665, 0.5974124094576707,
        -0.5637781026971428, 0.10625508963991966, -0.5971070135145327, -0.1275375740769271,
        -0.211448230683914, -0.5842044096322061, 0.21150921677844758, -0.18576770437913187,
        -0.17390132523862958, 0.1644592079125301 },
    { 0.0001492076670523534, 0.00014881399852015613, -0.00018339862201550977,
        0.00015964044027912778, -0.0009427850280031085, -0.00013254427402581607,
        -0.00016113208389831606, -0.0003359057060012463, 0.0001904683525392438, 0.3823101353674478,
        -2.1486023298379, -0.45914614526127184, -0.7609206827636913, -2.102577870000438,
        0.7609019936870023, -0.6690031340859193, -0.6268557036474184, 0.5921750966019337,
        -0.1114375460378447, 0.6270325369139359, 0.13379844494830137, 0.22183232584969384,
        0.613000115684854, -0.22189635777140615, 0.19497913499916444, 0.18304321458955722,
        -0.1725909249386242 },
    { -9.835222073949031e-05, -0.000240289511091372, 9.834761015932107e-05, -0.0002402880483340345,
        0.0003933622287242376, 0.00024029170415543124, 9.835061416693594e-05, 0.0002402642776592355,
        -9.834665708583549e-05, 0.1539755409367896, -0.8658560058138759, -0.184845491349178,
        -0.3064635913686592, -0.8467962863179376, 0.30655201868712595, -0.26930745984837334,
        -0.2524804568272451, 0.2383997930656779, 0.5278079338191064, -2.966935816906447,
        -0.6339175486247604, -1.0505640410350063, -2.903003782392406, 1.0505382401436336,
        -0.9237275519006308, -0.8659385256295187, 0.8176289432701858 },
    { -1.9092798849818255, 0.55332955277632, 2.039306176564587, -2.5108414695442907,
        0.23864628922075165, 2.345819508624117, -0.8177648546339923, -0.05976137196621367,
        0.6699631656247926, -0.10381851214487203, -1.0552552272300704, 0.042136975534985965,
        -0.07076202836897302, -1.2990688176135827, -0.0031935038981540237, -0.002081079704091708,
        -0.39516352550010436, -0.01566675878556123, -0.35593693440799223, -3.613642290738181,
        0.14418300211807725, -0.24061771124163087, -4.451446811533638, -0.013434986495402368,
        -0.005754630310729009, -1.3547039058237325, -0.055101006824424384 },
    { -1.8176991469270858, 0.5274995655789054, 1.9415337421602124, -2.3906291121791687,
        0.22634408524491273, 2.23346531465359, -0.7786302201526962, -0.057693354993933244,
        0.6378666795097281, 0.10936535301228617, 1.107115224229406, -0.044615935556923406,
        0.07377727128679368, 1.3633178044915975, 0.003925654532511813, 0.001685088524972421,
        0.41471677556744674, 0.016904465623866057, 0.37337202872474184, 3.7960375655702894,
        -0.15097387823756436, 0.2533143700129056, 4.6756429888378195, 0.013426449082971165,
        0.006639412570457998, 1.4229219025321267, 0.05732414180967793 },
    { 0.00047305767326313197, 0.0006334534368828903, -0.0004563739726009503, 0.00038023239548090035,
        -0.0009868447312004968, -0.00040141373643586193, 0.00010456502315654574,
        -0.0008507517992198442, -0.00012353377586366704, -0.5158465887794254, -5.241021944991575,
        0.2087624551796001, -0.34937780645064576, -6.45577377905848, -0.01898809388257905,
        -0.008776580005998347, -1.9646703214666248, -0.07951126414730525, 0.1507946719550916,
        1.5294662733152968, -0.0613681679849183, 0.10222616586555502, 1.8831392953545496,
        0.005045284962228794, 0.0026553820529865504, 0.5728389473145944, 0.02304591213057472 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 5, 4, 3, 2, 1, 0 }, -1.0, 0 },
    { { 3, 2, 1, 0, 5, 4 }, -1.0, left_1 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, -0.05525440446656575, 2.7692307675684008e-05,
        1.1538461531535004e-05, -0.9999999995500001, -6.41174760047529e-06, 0.9230769226615386,
        0.38461538444230775, 2.9999999981991006e-05, 1.9235245234071069e-19 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, -0.8633394996691172, 0.8823529352642647,
        0.4705882321409412, -0.00011576268798709127, -0.5232360634903338, 0.00010214354822390406,
        5.447655905274883e-05, 0.9999999932995001, 6.411747604001751e-06 },
    { 0.28, -0.96, 0.0, -0.055531663531175224, -5.9519999961932536e-05, -1.735999998889699e-05,
        -0.999999998078, -0.4657918929277785, 0.9599999981548799, 0.27999999946184,
        -6.199999996034639e-05, 6.698296062660318e-05 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.00015526507616328748, 6.734482748910032e-05,
        6.413793094200031e-05, -0.9999999956755, 0.00023237535777633262, 0.7241379279029483,
        0.6896551694313794, 9.299999986590045e-05, 0.465791887413791 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.00028613135465814944,
        4.3513513498216673e-05, 1.4918918913674289e-05, -0.999999998942, -8.696608708753215e-09,
        0.9459459449451351, 0.3243243239811892, 4.599999998382906e-05, -0.00018905671111534863 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.39997300008672054 },
    { 0.9999999830720001, -0.00018399999896174932, 5.1722776507432096e-20, -2.6999999999021673e-05,
        0.00018399999890875734, 0.9999999827840002, -2.3999999997695935e-05, 2.156951903896213e-06,
        4.4159999746063125e-09, 2.3999999591423935e-05, 0.999999999712, -0.08987299605333009 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.4508418874566562, 2.2180725168225184, /* the length that is one in the loop, and its inverse
        */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};


/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.6307522022711981, 0.6307522022711981, 0.6307522022711981, 0.6307522022711981,
    0.6307522022711981, 0.6307522022711981,
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
/* How the loop counts the joints: which way, and from where. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = {
    3.141592653589793, -2.1157052436021195, -1.0259814129576739, -3.1415816535897934,
    3.141458653589793, 0.0,
};

static const struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 1.585408653983645, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero, 0, 0,
    kuka_kr6_r900_calibrated_fk, kuka_kr6_r900_calibrated_jacobian, 0,
};


/* The axes at q = 0: a unit vector along each, and a point of it [m]. */
static const double table[6][6] = {
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.99999999955, 2.999999998203572e-05, 0.024911, 0.0, 0.399973 },
    { 9.899729955984851e-05, 0.9999999910493664, 9.000445467075194e-05, 0.02489051897001,
        -1.365401998e-05, 0.85510699933437 },
    { -9.40120771922738e-05, -0.00015199514761225376, 0.9999999840296021, -0.00014547594582,
        3.782468778e-05, 0.85510465043496 },
    { 8.798272759438208e-05, 0.9999999661161818, 0.00024500341767975844, -0.00025496073555,
        -2.600588783e-05, 1.27510163714764 },
    { -0.00022801621018996365, -0.00019898335173072366, 0.9999999542071157, -0.00038397744841,
        -0.00021599452442, 1.27510156118516 },
};

void kuka_kr6_r900_calibrated_frames(const double q[6], double frames[8][16])
{
    static const double tool[12] = {
        0.9999999370141494, 0.00027199868072050787, -0.00022800968228729382, -0.00037746995097,
        -0.0002720385815250037, 0.9999999476879168, -0.00017498335303891297, -0.00023388510023,
        0.00022796207511845772, 0.000175045369447981, 0.9999999586962047, 1.3649745632246,
    };
    static const struct dhgen_links links = { 6, DHGEN_AXES, joints, &table[0][0], NULL, NULL, tool
        };
    dhgen_frames(&links, q, frames);
}

void kuka_kr6_r900_calibrated_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = s1 * ca2, v3 = c1 * ca2, z2_x = s1 * sa2,
        v4 = c1 * sa2, v5 = q[1] + offset2;
    const double c2 = cos(v5), s2 = sin(v5), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + v3 * s2,
        x2_z = sa2 * s2, v6 = v2 * c2 + c1 * s2, y2_y = v3 * c2 - s1 * s2, y2_z = sa2 * c2,
        v7 = z2_x * sa3 - v6 * ca3, v8 = y2_y * ca3 - v4 * sa3, v9 = y2_z * ca3 + f4,
        z3_x = v6 * sa3 + z2_x * ca3, v10 = y2_y * sa3 + v4 * ca3, z3_z = f5 - y2_z * sa3,
        v11 = q[2] + offset3;
    const double c3 = cos(v11), s3 = sin(v11), x3_x = x2_x * c3 + v7 * s3,
        x3_y = x2_y * c3 + v8 * s3, x3_z = x2_z * c3 + v9 * s3, y3_x = v7 * c3 - x2_x * s3,
        y3_y = v8 * c3 - x2_y * s3, y3_z = v9 * c3 - x2_z * s3, v12 = z3_x * sa4 - y3_x * ca4,
        v13 = y3_y * ca4 + v10 * sa4, v14 = z3_z * sa4 - y3_z * ca4, v15 = y3_x * sa4 + z3_x * ca4,
        z4_y = v10 * ca4 - y3_y * sa4, v16 = y3_z * sa4 + z3_z * ca4, v17 = q[3] + offset4;
    const double c4 = cos(v17), s4 = sin(v17), x4_x = x3_x * c4 + v12 * s4,
        x4_y = x3_y * c4 - v13 * s4, x4_z = x3_z * c4 + v14 * s4, y4_x = v12 * c4 - x3_x * s4,
        v18 = v13 * c4 + x3_y * s4, y4_z = v14 * c4 - x3_z * s4, v19 = y4_x * ca5 - v15 * sa5,
        v20 = z4_y * sa5 - v18 * ca5, v21 = y4_z * ca5 - v16 * sa5, v22 = y4_x * sa5 + v15 * ca5,
        z5_y = v18 * sa5 + z4_y * ca5, v23 = y4_z * sa5 + v16 * ca5, v24 = q[4] + offset5;
    const double c5 = cos(v24), s5 = sin(v24), x5_x = x4_x * c5 + v19 * s5,
        x5_y = x4_y * c5 + v20 * s5, x5_z = x4_z * c5 + v21 * s5, y5_x = v19 * c5 - x4_x * s5,
        y5_y = v20 * c5 - x4_y * s5, y5_z = v21 * c5 - x4_z * s5, v25 = y5_x * ca6 - v22 * sa6,
        v26 = y5_y * ca6 + z5_y * sa6, v27 = y5_z * ca6 - v23 * sa6, v28 = y5_x * sa6 + v22 * ca6,
        z6_y = z5_y * ca6 - y5_y * sa6, v29 = y5_z * sa6 + v23 * ca6;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 + v25 * s6,
        x6_y = x5_y * c6 + v26 * s6, x6_z = x5_z * c6 + v27 * s6, y6_x = v25 * c6 - x5_x * s6,
        y6_y = v26 * c6 - x5_y * s6, y6_z = v27 * c6 - x5_z * s6;
    T[0] = x6_x * f10 - y6_x * f11; T[1] = x6_x * f12 + y6_x * f13 + v28 * f14;
    T[2] = x6_x * f15 + y6_x * f16 - v28 * f17;
    T[3] = c1 * a2 + x2_x * a3 - v6 * f1 + z2_x * f2 + x3_x * a4 - y3_x * f6 - z3_x * f7 + x4_x * a5
        - y4_x * f8 - v15 * f9 + x5_x * a6 + x6_x * ex + y6_x * ey - v28 * ez;
    T[4] = x6_y * f10 - y6_y * f11; T[5] = x6_y * f12 + y6_y * f13 - z6_y * f14;
    T[6] = x6_y * f15 + y6_y * f16 + z6_y * f17;
    T[7] = s1 * a2 + x2_y * a3 + y2_y * f1 - v4 * f2 + x3_y * a4 - y3_y * f6 + v10 * f7 + x4_y * a5
        + v18 * f8 + z4_y * f9 + x5_y * a6 + x6_y * ex + y6_y * ey + z6_y * ez;
    T[8] = x6_z * f10 - y6_z * f11; T[9] = x6_z * f12 + y6_z * f13 + v29 * f14;
    T[10] = x6_z * f15 + y6_z * f16 - v29 * f17;
    T[11] = d1 + x2_z * a3 + y2_z * f1 + f3 + x3_z * a4 - y3_z * f6 - z3_z * f7 + x4_z * a5 - y4_z *
        f8 - v16 * f9 + x5_z * a6 + x6_z * ex + y6_z * ey - v29 * ez;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kuka_kr6_r900_calibrated_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), p2_x = c1 * a2, p2_y = s1 * a2, v2 = s1 * ca2,
        v3 = c1 * ca2, z2_x = s1 * sa2, v4 = c1 * sa2, v5 = q[1] + offset2;
    const double c2 = cos(v5), s2 = sin(v5), x2_x = c1 * c2 - v2 * s2, x2_y = s1 * c2 + v3 * s2,
        x2_z = sa2 * s2, v6 = v2 * c2 + c1 * s2, y2_y = v3 * c2 - s1 * s2, y2_z = sa2 * c2,
        p3_x = p2_x + x2_x * a3 - v6 * f1 + z2_x * f2,
        p3_y = p2_y + x2_y * a3 + y2_y * f1 - v4 * f2, p3_z = d1 + x2_z * a3 + y2_z * f1 + f3,
        v7 = z2_x * sa3 - v6 * ca3, v8 = y2_y * ca3 - v4 * sa3, v9 = y2_z * ca3 + f4,
        z3_x = v6 * sa3 + z2_x * ca3, v10 = y2_y * sa3 + v4 * ca3, z3_z = f5 - y2_z * sa3,
        v11 = q[2] + offset3;
    const double c3 = cos(v11), s3 = sin(v11), x3_x = x2_x * c3 + v7 * s3,
        x3_y = x2_y * c3 + v8 * s3, x3_z = x2_z * c3 + v9 * s3, y3_x = v7 * c3 - x2_x * s3,
        y3_y = v8 * c3 - x2_y * s3, y3_z = v9 * c3 - x2_z * s3,
        p4_x = p3_x + x3_x * a4 - y3_x * f6 - z3_x * f7,
        p4_y = p3_y + x3_y * a4 - y3_y * f6 + v10 * f7,
        p4_z = p3_z + x3_z * a4 - y3_z * f6 - z3_z * f7, v12 = z3_x * sa4 - y3_x * ca4,
        v13 = y3_y * ca4 + v10 * sa4, v14 = z3_z * sa4 - y3_z * ca4, v15 = y3_x * sa4 + z3_x * ca4,
        z4_y = v10 * ca4 - y3_y * sa4, v16 = y3_z * sa4 + z3_z * ca4, v17 = q[3] + offset4;
    const double c4 = cos(v17), s4 = sin(v17), x4_x = x3_x * c4 + v12 * s4,
        x4_y = x3_y * c4 - v13 * s4, x4_z = x3_z * c4 + v14 * s4, y4_x = v12 * c4 - x3_x * s4,
        v18 = v13 * c4 + x3_y * s4, y4_z = v14 * c4 - x3_z * s4,
        p5_x = p4_x + x4_x * a5 - y4_x * f8 - v15 * f9,
        p5_y = p4_y + x4_y * a5 + v18 * f8 + z4_y * f9,
        p5_z = p4_z + x4_z * a5 - y4_z * f8 - v16 * f9, v19 = y4_x * ca5 - v15 * sa5,
        v20 = z4_y * sa5 - v18 * ca5, v21 = y4_z * ca5 - v16 * sa5, v22 = y4_x * sa5 + v15 * ca5,
        z5_y = v18 * sa5 + z4_y * ca5, v23 = y4_z * sa5 + v16 * ca5, v24 = q[4] + offset5;
    const double c5 = cos(v24), s5 = sin(v24), x5_x = x4_x * c5 + v19 * s5,
        x5_y = x4_y * c5 + v20 * s5, x5_z = x4_z * c5 + v21 * s5, y5_x = v19 * c5 - x4_x * s5,
        y5_y = v20 * c5 - x4_y * s5, y5_z = v21 * c5 - x4_z * s5, p6_x = p5_x + x5_x * a6,
        p6_y = p5_y + x5_y * a6, p6_z = p5_z + x5_z * a6, v25 = y5_x * ca6 - v22 * sa6,
        v26 = y5_y * ca6 + z5_y * sa6, v27 = y5_z * ca6 - v23 * sa6, v28 = y5_x * sa6 + v22 * ca6,
        z6_y = z5_y * ca6 - y5_y * sa6, v29 = y5_z * sa6 + v23 * ca6;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        J21 = p6_x + (x5_x * c6 + v25 * s6) * ex + (v25 * c6 - x5_x * s6) * ey - v28 * ez,
        v30 = p6_y + (x5_y * c6 + v26 * s6) * ex + (v26 * c6 - x5_y * s6) * ey + z6_y * ez,
        v31 = p6_z + (x5_z * c6 + v27 * s6) * ex + (v27 * c6 - x5_z * s6) * ey - v29 * ez,
        v32 = v31 - d1, v33 = J21 - p2_x, v34 = v30 - p2_y, v35 = J21 - p3_x, v36 = v30 - p3_y,
        v37 = v31 - p3_z, v38 = J21 - p4_x, v39 = v30 - p4_y, v40 = v31 - p4_z, v41 = J21 - p5_x,
        v42 = v30 - p5_y, v43 = v31 - p5_z, v44 = J21 - p6_x, v45 = v30 - p6_y, v46 = v31 - p6_z;
    J[0] = -v30; J[1] = -(v4 * v32 + ca2 * v34); J[2] = -(v10 * v37 + z3_z * v36);
    J[3] = z4_y * v40 + v16 * v39; J[4] = z5_y * v43 + v23 * v42; J[5] = z6_y * v46 + v29 * v45;
    J[6] = J21; J[7] = ca2 * v33 - z2_x * v32; J[8] = z3_z * v35 - z3_x * v37;
    J[9] = v15 * v40 - v16 * v38; J[10] = v22 * v43 - v23 * v41; J[11] = v28 * v46 - v29 * v44;
    J[12] = 0.0; J[13] = z2_x * v34 + v4 * v33; J[14] = z3_x * v36 + v10 * v35;
    J[15] = -(v15 * v39 + z4_y * v38); J[16] = -(v22 * v42 + z5_y * v41);
    J[17] = -(v28 * v45 + z6_y * v44);
    J[18] = 0.0; J[19] = z2_x; J[20] = z3_x; J[21] = -v15; J[22] = -v22; J[23] = -v28;
    J[24] = 0.0; J[25] = -v4; J[26] = -v10; J[27] = z4_y; J[28] = z5_y; J[29] = z6_y;
    J[30] = 1.0; J[31] = ca2; J[32] = z3_z; J[33] = -v16; J[34] = -v23; J[35] = -v29;
}

#ifndef KUKA_KR6_R900_CALIBRATED_PLAIN
/* The nearest arm with a structure: what follows is its closed form. A pose at which one of its
 * branches may end by what the two arms differ is left to the general algorithm. */
static const double
    near_angle = 0.00038629455388293287, /* the two arms' tools are turned by no more */
    near_length = 0.0005956666016234988, /* and no farther apart [m] */
    near_a1 = -0.02490435840606673, /* link length 1 [m] */
    near_longest3 = 0.7670856262406353, /* square of the longest reach [m^2] */
    near_shortest3 = 0.0011825258020403124, /* square of the shortest reach [m^2] */
    near_k3 = 0.3841340760213378, /* near_a2^2 + (near_a3^2 + near_d4^2) [m^2] */
    near_turn1 = -1.6303690532815094, /* a constant angle [rad] */
    near_m1 = 8.557009921367217e-09, /* doubt_limit1^2 [m^2] */
    /* 1000 * (near_longest3 - longest3_apart) * (longest3_apart - near_shortest3) [m^4] */
    near_m3 = 1.232968722271121e-11,
    near_m10 = 9.999999999999999e-09, /* doubt_limit^2 */
    near1 = 0.0011913332032469975, /* near_length + near_length [m] */
    near2 = 0.5, /* 1 / 2 */
    h1 = 0.0007909463375342454, /* near3 + near_m7 * near1 [m] */
    h2 = 0.0014554514688229327; /* near4 + near_m6 * near1 [m] */
/* coefficients */
static const double near_m4 = 1.0986329373744648, near_m5 = 0.033088711096641035,
near_m6 = 1.1863216740895242, near_m7 = 0.07075613880927151, near_m8 = 0.0021310388171766744,
near_m9 = 0.03572972719663899;

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, w1 = dhgen_sqrt_wide(v1), v2 = 1.0 / v1,
        angle1 = dhgen_atan2_wide(T24, T14);

    /* theta3 */
    const dhgen_wide Z2_3_p = w1 - near_a1, v3 = near_a1 + w1, v4 = T34 * T34,
        N3_p = v4 + Z2_3_p * Z2_3_p, N3_m = v4 + v3 * v3, v5 = near_longest3 - N3_p,
        v6 = near_longest3 - N3_m, v7 = N3_p - near_shortest3, v8 = N3_m - near_shortest3,
        D3_p = v5 * v7, D3_m = v6 * v8, w3_p = dhgen_sqrt_wide(D3_p), w3_m = dhgen_sqrt_wide(D3_m),
        angle2 = dhgen_atan2_wide(w3_p, N3_p - near_k3),
        angle3 = dhgen_atan2_wide(w3_m, N3_m - near_k3), q3__pp = angle2 - near_turn1,
        v9 = near_turn1 + angle2, q3__mp = angle3 - near_turn1, v10 = near_turn1 + angle3;

    /* theta2 */
    const dhgen_wide X1_2_p = near_m5 + near_m4 * N3_p, X1_2_m = near_m5 + near_m4 * N3_m,
        v11 = T34 * X1_2_p, v12 = T34 * X1_2_m, v13 = Z2_3_p * X1_2_p, v14 = v3 * X1_2_m,
        v15 = near_m4 * T34, factor2_p = 1.0 / N3_p, factor2_m = 1.0 / N3_m, v16 = w3_p * v15,
        angle4 = dhgen_atan2_wide(v11 - w3_p * (near_m4 * Z2_3_p), v13 + v16),
        angle5 = dhgen_atan2_wide(v11 - w3_p * (near_m4 * -Z2_3_p), v13 - v16),
        v17 = w3_m * (near_m4 * v3), v18 = w3_m * v15,
        angle6 = dhgen_atan2_wide(v12 + v17, v18 - v14),
        angle7 = dhgen_atan2_wide(v12 - v17, -(v14 + v18));

    /* theta4 */
    const dhgen_wide v19 = near_m7 * T34, v20 = v19 - near_m6 * Z2_3_p, v21 = v19 + near_m6 * v3,
        v22 = near_m8 * factor2_p - near_m7, v23 = near_m8 * factor2_m - near_m7,
        v24 = near_m9 * factor2_p - near_m6, v25 = near_m9 * factor2_m - near_m6,
        v26 = Z2_3_p * v22 + T34 * v24, v27 = T34 * v25 - v3 * v23, v28 = factor2_p * v20,
        v29 = factor2_p * -v20, v30 = factor2_m * v21, c23_pp = v26 + w3_p * v28,
        c23_pm = v26 + w3_p * v29, v31 = w3_m * v30, c23_mp = v27 + v31, c23_mm = v27 - v31,
        v32 = near_m6 * T34, v33 = v32 + near_m7 * Z2_3_p, v34 = v32 - near_m7 * v3,
        v35 = Z2_3_p * -v24 + T34 * v22, v36 = T34 * v23 - v3 * -v25, v37 = factor2_p * v33,
        v38 = factor2_m * v34, v39 = factor2_m * -v34, v40 = w3_p * v37, s23_pp = v35 - v40,
        s23_pm = v35 + v40, s23_mp = v36 - w3_m * v38, s23_mm = v36 - w3_m * v39,
        v41 = T14 * T13 + T24 * T23, v42 = v2 * v41, v43 = w1 * v42,
        c4_pp = s23_pp * T33 + c23_pp * v43, c4_pm = s23_pm * T33 + c23_pm * v43,
        c4_mp = s23_mp * T33 - c23_mp * v43, c4_mm = s23_mm * T33 - c23_mm * v43,
        v44 = T24 * T13 - T14 * T23, v45 = v2 * v44, Y4 = w1 * v45, v46 = Y4 * Y4,
        v47 = v46 + c4_pp * c4_pp, v48 = v46 + c4_pm * c4_pm, v49 = v46 + c4_mp * c4_mp,
        v50 = v46 + c4_mm * c4_mm, angle8 = dhgen_atan2_wide(Y4, c4_pp),
        angle9 = dhgen_atan2_wide(Y4, c4_pm), angle10 = dhgen_atan2_wide(-Y4, c4_mp),
        angle11 = dhgen_atan2_wide(-Y4, c4_mm), v51 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4),
        v52 = dhgen_signed_wide(DHGEN_HALF_TURN, -Y4);

    /* theta5 */
    const dhgen_wide angle12 = dhgen_atan2_wide(dhgen_sqrt_wide(v47), c23_pp * T33 - s23_pp * v43),
        angle13 = dhgen_atan2_wide(dhgen_sqrt_wide(v48), c23_pm * T33 - s23_pm * v43),
        angle14 = dhgen_atan2_wide(dhgen_sqrt_wide(v49), c23_mp * T33 + s23_mp * v43),
        angle15 = dhgen_atan2_wide(dhgen_sqrt_wide(v50), c23_mm * T33 + s23_mm * v43);

    /* theta6 */
    const dhgen_wide v53 = w1 * (v2 * (T14 * T22 - T24 * T12)),
        v54 = w1 * (v2 * (T14 * T12 + T24 * T22)), v55 = w1 * (v2 * (T14 * T21 - T24 * T11)),
        v56 = w1 * (v2 * (T14 * T11 + T24 * T21)),
        v57 = c4_pp * v55 + Y4 * (s23_pp * T31 + c23_pp * v56),
        v58 = c4_pm * v55 + Y4 * (s23_pm * T31 + c23_pm * v56),
        angle16 = dhgen_atan2_wide(v57, c4_pp * v53 + Y4 * (s23_pp * T32 + c23_pp * v54)),
        angle17 = dhgen_atan2_wide(v58, c4_pm * v53 + Y4 * (s23_pm * T32 + c23_pm * v54)),
        angle18 = dhgen_atan2_wide(-(c4_mp * v55 + Y4 * (s23_mp * T31 - c23_mp * v56)), -(c4_mp *
            v53 + Y4 * (s23_mp * T32 - c23_mp * v54))),
        angle19 = dhgen_atan2_wide(-(c4_mm * v55 + Y4 * (s23_mm * T31 - c23_mm * v56)), -(c4_mm *
            v53 + Y4 * (s23_mm * T32 - c23_mm * v54)));

    /* joint values */
    const dhgen_wide q3_ppp = dhgen_lowered_wide(q3__pp),
        q3_pmp = dhgen_only_wide(DHGEN_HALF_TURN < -v9, -DHGEN_TURN) - v9,
        q3_mpp = dhgen_lowered_wide(q3__mp),
        q3_mmp = dhgen_only_wide(DHGEN_HALF_TURN < -v10, -DHGEN_TURN) - v10,
        q1_ppp = angle1 + (w3_p - w3_p),
        q1_mpp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, T24) + (w3_m - w3_m),
        v59 = dhgen_abs_wide(T14), v60 = dhgen_abs_wide(T24),
        v61 = near_length * (near_length + 2.0 * v59) + near_length * (near_length + 2.0 * v60),
        v62 = dhgen_abs_wide(v1), v63 = dhgen_abs_wide(T34),
        v64 = near_length * (near_length + 2.0 * v63), v65 = dhgen_abs_wide(w1),
        v66 = dhgen_abs_wide(Z2_3_p), v67 = dhgen_abs_wide(v3),
        v68 = v64 + near1 * (near1 + 2.0 * v66), v69 = v64 + near1 * (near1 + 2.0 * v67),
        v70 = dhgen_abs_wide(v5), v71 = dhgen_abs_wide(v6), v72 = dhgen_abs_wide(v7),
        v73 = dhgen_abs_wide(v8), v74 = dhgen_abs_wide(N3_p), v75 = dhgen_abs_wide(N3_m),
        v76 = dhgen_abs_wide(v2), v77 = v61 * v76 / (v62 - v61), v78 = near_angle * v60,
        v79 = near_length * (near_angle + dhgen_abs_wide(T13)), v80 = near_angle * v59,
        v81 = near_length * (near_angle + dhgen_abs_wide(T23)), v82 = v78 + v79 + (v80 + v81),
        v83 = v76 * v82 + v77 * (v82 + dhgen_abs_wide(v44)),
        v84 = v65 * v83 + near1 * (v83 + dhgen_abs_wide(v45)),
        v85 = v84 * (v84 + 2.0 * dhgen_abs_wide(Y4)), v86 = dhgen_abs_wide(factor2_p),
        v87 = dhgen_abs_wide(factor2_m), v88 = v68 * v86 / (v74 - v68),
        v89 = v69 * v87 / (v75 - v69), v90 = near_m9 * v88, v91 = near_m9 * v89,
        v92 = near_m8 * v88, v93 = near_m8 * v89, v94 = v92 + dhgen_abs_wide(v22),
        v95 = v93 + dhgen_abs_wide(v23),
        v96 = v67 * v91 + near1 * (v91 + dhgen_abs_wide(-v25)) + (v63 * v93 + near_length * v95),
        v97 = (v68 * v70 + v68 * (v68 + v72)) / D3_p, v98 = (v69 * v71 + v69 * (v69 + v73)) / D3_m,
        v99 = v97 * (1.0 + v97) * (near2 * w3_p), v100 = v98 * (1.0 + v98) * (near2 * w3_m),
        v101 = v86 * h1 + v88 * (h1 + dhgen_abs_wide(v33)),
        v102 = v87 * h1 + v89 * (h1 + dhgen_abs_wide(v34)), v103 = dhgen_abs_wide(w3_p),
        v104 = dhgen_abs_wide(w3_m), v105 = near_angle + dhgen_abs_wide(T33),
        v106 = v66 * v92 + near1 * v94 + (v63 * v90 + near_length * (v90 + dhgen_abs_wide(v24))),
        v107 = v86 * h2 + v88 * (h2 + dhgen_abs_wide(v20)),
        v108 = v87 * h2 + v89 * (h2 + dhgen_abs_wide(v21)), v109 = v79 + v80 + (v78 + v81),
        v110 = v76 * v109 + v77 * (v109 + dhgen_abs_wide(v41)),
        v111 = v65 * v110 + near1 * (v110 + dhgen_abs_wide(v42)), v112 = v111 + dhgen_abs_wide(v43),
        v113 = v105 * (v66 * v90 + near1 * (v90 + dhgen_abs_wide(-v24)) + (v63 * v92 + near_length *
            v94) + (v101 * v103 + v99 * (v101 + dhgen_abs_wide(v37)))), v114 = v103 * v107,
        v115 = near_angle * dhgen_abs_wide(s23_pp) + v113 + (v111 * dhgen_abs_wide(c23_pp) + v112 *
            (v106 + (v114 + v99 * (v107 + dhgen_abs_wide(v28))))),
        v116 = v113 + near_angle * dhgen_abs_wide(s23_pm) + (v111 * dhgen_abs_wide(c23_pm) + v112 *
            (v106 + (v114 + v99 * (v107 + dhgen_abs_wide(v29))))), v117 = v102 * v104,
        v118 = v112 * (v67 * v93 + near1 * v95 + (v63 * v91 + near_length * (v91 +
            dhgen_abs_wide(v25))) + (v104 * v108 + v100 * (v108 + dhgen_abs_wide(v30)))),
        v119 = near_angle * dhgen_abs_wide(s23_mp) + v105 * (v96 + (v117 + v100 * (v102 +
            dhgen_abs_wide(v38)))) + (v111 * dhgen_abs_wide(c23_mp) + v118),
        v120 = near_angle * dhgen_abs_wide(s23_mm) + v105 * (v96 + (v117 + v100 * (v102 +
            dhgen_abs_wide(v39)))) + (v118 + v111 * dhgen_abs_wide(c23_mm));

    q[0] = q1_ppp; q[1] = angle4; q[2] = q3_ppp; q[3] = angle8; q[4] = angle12; q[5] = angle16;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = angle4; q[8] = q3_ppp; q[9] = angle8 - v51; q[10] = -angle12;
    q[11] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, v57);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = angle5; q[14] = q3_pmp; q[15] = angle9; q[16] = angle13;
    q[17] = angle17;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = angle5; q[20] = q3_pmp; q[21] = angle9 - v51; q[22] = -angle13;
    q[23] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, v58);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = angle6; q[26] = q3_mpp; q[27] = angle10; q[28] = angle14;
    q[29] = angle18;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = angle6; q[32] = q3_mpp; q[33] = angle10 - v52; q[34] = -angle14;
    q[35] = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, -(c4_mp * v55 + Y4 * (s23_mp * T31 - c23_mp
        * v56)));
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = angle7; q[38] = q3_mmp; q[39] = angle11; q[40] = angle15;
    q[41] = angle19;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = angle7; q[44] = q3_mmp; q[45] = angle11 - v52; q[46] = -angle15;
    q[47] = angle19 - dhgen_signed_wide(DHGEN_HALF_TURN, -(c4_mm * v55 + Y4 * (s23_mm * T31 - c23_mm
        * v56)));
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v71 <= v69) | (dhgen_abs_wide(D3_m) <= near_m3) | (v70 <= v68) |
        (dhgen_abs_wide(D3_p) <= near_m3) | (v73 <= v69) | (v72 <= v68) | (dhgen_abs_wide(v50) <=
        v85 + v120 * (v120 + 2.0 * dhgen_abs_wide(c4_mm))) | (v50 <= near_m10) |
        (dhgen_abs_wide(v49) <= v85 + v119 * (v119 + 2.0 * dhgen_abs_wide(c4_mp))) | (v49 <=
        near_m10) | (dhgen_abs_wide(v48) <= v85 + v116 * (v116 + 2.0 * dhgen_abs_wide(c4_pm))) |
        (v48 <= near_m10) | (dhgen_abs_wide(v47) <= v85 + v115 * (v115 + 2.0 *
        dhgen_abs_wide(c4_pp))) | (v47 <= near_m10) | (v75 <= v69) | (v1 <= near_m1) | (v62 <= v61)
        | (v74 <= v68));
}

#if DHGEN_LANES > 1
static const double
    near_m2 = 0.5, /* 1 / 2 */
    near3 = 0.0007066522000372067, /* near_m6 * near_length [m] */
    near4 = 4.214706874851931e-05; /* near_m7 * near_length [m] */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, w1 = sqrt(v1), v2 = 1.0 / v1,
        v3 = copysign(DHGEN_HALF_TURN, T24);

    /* theta3 */
    const dhgen_four Z2_3 = e1 * w1 - near_a1;
    const double v4 = T34 * T34;
    const dhgen_four N3 = v4 + Z2_3 * Z2_3, v5 = near_longest3 - N3, v6 = N3 - near_shortest3,
        D3 = v5 * v6, w3 = dhgen_sqrt_four(D3);

    /* theta2 */
    const dhgen_four X1_2 = near_m5 + near_m4 * N3, v7 = T34 * X1_2, v8 = Z2_3 * X1_2,
        v9 = near_m4 * (e2 * T34), factor2 = 1.0 / N3;

    /* theta4 */
    const double v10 = near_m7 * T34;
    const dhgen_four v11 = v10 - near_m6 * Z2_3, v12 = near_m8 * factor2 - near_m7,
        v13 = near_m9 * factor2 - near_m6, v14 = Z2_3 * v12 + T34 * v13, v15 = factor2 * (e2 * v11),
        c23 = v14 + w3 * v15;
    const double v16 = near_m6 * T34;
    const dhgen_four v17 = v16 + near_m7 * Z2_3, v18 = Z2_3 * -v13 + T34 * v12,
        v19 = factor2 * (e2 * v17), s23 = v18 - w3 * v19;
    const double v20 = T14 * T13 + T24 * T23, v21 = v2 * v20, v22 = w1 * v21;
    const dhgen_four c4 = s23 * T33 + e1 * (c23 * v22);
    const double v23 = T24 * T13 - T14 * T23, v24 = v2 * v23, Y4 = w1 * v24, v25 = Y4 * Y4;
    const dhgen_four v26 = v25 + c4 * c4, v27 = e1 * Y4,
        v28 = dhgen_signed_four(DHGEN_HALF_TURN, v27);

    /* theta6 */
    const double v29 = w1 * (v2 * (T14 * T22 - T24 * T12)),
        v30 = w1 * (v2 * (T14 * T12 + T24 * T22)), v31 = w1 * (v2 * (T14 * T21 - T24 * T11)),
        v32 = w1 * (v2 * (T14 * T11 + T24 * T21));
    const dhgen_four v33 = e1 * (c4 * v31 + Y4 * (s23 * T31 + e1 * (c23 * v32)));

    /* joint values */
    const double v34 = fabs(T14), v35 = fabs(T24),
        v36 = near_length * (near_length + 2.0 * v34) + near_length * (near_length + 2.0 * v35),
        v37 = fabs(v1), v38 = fabs(T34), v39 = near_length * (near_length + 2.0 * v38);
    const dhgen_four v40 = dhgen_abs_four(e1);
    const double v41 = fabs(w1);
    const dhgen_four v42 = near1 * v40, v43 = dhgen_abs_four(Z2_3),
        v44 = v39 + v42 * (v42 + 2.0 * v43), v45 = dhgen_abs_four(v5), v46 = dhgen_abs_four(v6),
        v47 = dhgen_abs_four(N3);
    const double v48 = fabs(v2), v49 = v36 * v48 / (v37 - v36), v50 = near_angle * v35,
        v51 = near_length * (near_angle + fabs(T13)), v52 = near_angle * v34,
        v53 = near_length * (near_angle + fabs(T23)), v54 = v50 + v51 + (v52 + v53),
        v55 = v48 * v54 + v49 * (v54 + fabs(v23)), v56 = v41 * v55 + near1 * (v55 + fabs(v24)),
        v57 = v56 * (v56 + 2.0 * fabs(Y4));
    const dhgen_four v58 = dhgen_abs_four(factor2), v59 = v44 * v58 / (v47 - v44),
        v60 = near_m9 * v59, v61 = near_m8 * v59, v62 = v61 + dhgen_abs_four(v12),
        v63 = v43 * v60 + v42 * (v60 + dhgen_abs_four(-v13)) + (v38 * v61 + near_length * v62),
        v64 = (v44 * v45 + v44 * (v44 + v46)) / D3, v65 = v64 * (1.0 + v64) * (near2 * w3),
        v66 = near3 + near_m7 * v42, v67 = dhgen_abs_four(e2), v68 = dhgen_abs_four(v17),
        v69 = v66 * v67, v70 = v58 * v69 + v59 * (v68 + v69), v71 = dhgen_abs_four(w3);
    const double v72 = near_angle + fabs(T33);
    const dhgen_four v73 = v43 * v61 + v42 * v62 + (v38 * v60 + near_length * (v60 +
        dhgen_abs_four(v13))), v74 = near4 + near_m6 * v42, v75 = dhgen_abs_four(v11),
        v76 = v67 * v74, v77 = v58 * v76 + v59 * (v75 + v76);
    const double v78 = v51 + v52 + (v50 + v53), v79 = v48 * v78 + v49 * (v78 + fabs(v20)),
        v80 = v41 * v79 + near1 * (v79 + fabs(v21)), v81 = v80 + fabs(v22);
    const dhgen_four v82 = near_angle * dhgen_abs_four(s23) + v72 * (v63 + (v70 * v71 + v65 * (v70 +
        dhgen_abs_four(v19)))) + v40 * (v80 * dhgen_abs_four(c23) + v81 * (v73 + (v71 * v77 + v65 *
        (v77 + dhgen_abs_four(v15)))));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v45 <= v44) |
        (dhgen_abs_four(D3) <= near_m3) | (v47 <= v44) | (v46 <= v44)) | ((v26 <= near_m10) |
        (dhgen_abs_four(v26) <= v57 + v82 * (v82 + 2.0 * dhgen_abs_four(c4))))) | (unsigned)((v1 <=
        near_m1) | (v37 <= v36)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(w3, dhgen_all_four(T24), 0,
        5, 2, 3), dhgen_shuffle(N3 - near_k3, dhgen_all_four(T14), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(v7 - w3 * (near_m4 * (e2 * Z2_3)), v8 + w3 * v9),
        ratio3 = dhgen_ratio_four(v27, c4),
        ratio4 = dhgen_ratio_four(v33, e1 * (c4 * v29 + Y4 * (s23 * T32 + e1 * (c23 * v30)))),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v26), c23 * T33 - e1 * (s23 * v22));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5);
    const dhgen_four q3_ = e2 * angle2 - near_turn1, q4_m = angle4 - v28,
        q6_m = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, v33), q3_p = dhgen_lowered_four(q3_),
        q1_p = angle1 + v3 * (near_m2 * (e1 - 1.0)) + (w3 - w3);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle3, q3_p, angle4);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle5, angle6);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle3, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle5, q6_m);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
}
#else
static int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_solve_branches(solve_wide, 8, T, free_joints, q, status);
}
#endif

DHGEN_TABLE dhgen_nearest_arm nearest_arm = {
    8, /* rows */
    { 0.9999999999918531, -3.476199999090458e-06, 2.0518553472019946e-06, 8.012948348171926e-06,
        3.4762326676678125e-06, 0.9999999998672079, -1.5921692866943705e-05, 1.0315399224557022e-05,
        -2.051799999940795e-06, 1.5921699999540576e-05, 0.9999999998711449, -0.3999492120037384 },
    { 0.9999999837056532, -0.0001805026000012168, -2.7394549473610155e-06, -2.5780483198822104e-05,
        0.00018050259021021845, 0.999999983703021, -3.57389453691181e-06, -4.246671387497745e-05,
        2.7400999999722193e-06, 3.5733999999637707e-06, 0.9999999999898614, -0.0898696651233072 },
    { 0.0, -2.5967434078241616, 2.596736097794161, 5.3526e-06, -9.5436e-06, 0.0 },
};
#endif

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints;
    (void)moved;
    double nearby[16][6];
#ifdef KUKA_KR6_R900_CALIBRATED_PLAIN
    const int nearby_count = 0;
#else
    const int nearby_count = dhgen_near_solutions(&nearest_arm, solve_regular, T, nearby);
#endif

    /* all joints: the general 6R loop */
    double solution_roots[16][6];
    int solution_found[16], solution_chosen[16];
    dhgen_general_rows(&general, &descents, T, NULL, seed, nearby, nearby_count, solution_roots[0],
        solution_found, solution_chosen);

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
        status[row] = chosen ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

static const int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
static const struct dhgen_arm arm = {
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.6308, 0.6308, 0.6308, 1.0, 1.0, 1.0 }, 0.6307522022711981, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* winds */
    0, /* follows seed */
    NULL, NULL,
    kuka_kr6_r900_calibrated_fk, kuka_kr6_r900_calibrated_jacobian, solve,
    NULL,
};

void kuka_kr6_r900_calibrated_joint_velocities(const double q[6], const double twist[6], double
    velocities[6])
{
    dhgen_joint_velocities(&arm, q, twist, velocities);
}

int kuka_kr6_r900_calibrated_ik(
    const double T[16], const double *q_seed, double q[16][6], unsigned char status[16])
{
    return dhgen_careful_ik(&arm, T, NULL, q_seed, &q[0][0], status);
}

int kuka_kr6_r900_calibrated_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    return dhgen_ik_nearest(&arm, T, NULL, q_seed, q);
}

void kuka_kr6_r900_calibrated_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, NULL, q, status);
}
