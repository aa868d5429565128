/* general_5r1p_pair: Arm on a rail with two parallel axes among five skew or meeting ones
 *
 * Inverse kinematics, generated from robots/general_5r1p_pair.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_5r1p_pair.yaml. The formulas and where they come from:
 * general_5r1p_pair.md.
 */
#include "general_5r1p_pair.h"

#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x101u /* what the general algorithm has to do for the arm */
#ifdef GENERAL_5R1P_PAIR_LANES
#define DHGEN_GENERAL_LANES GENERAL_5R1P_PAIR_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = GENERAL_5R1P_PAIR_OK, NONE = GENERAL_5R1P_PAIR_UNREACHABLE, FREE =
        GENERAL_5R1P_PAIR_FREE_JOINT,
    OUT = GENERAL_5R1P_PAIR_OUT_OF_LIMITS, INVALID = GENERAL_5R1P_PAIR_INVALID_POSE
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

/* The monomials of the left side of the formulation that has the joints 1, 2, 3, 4, 5, 0. */
DHGEN_TABLE double general_5r1p_pair_left_0[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7037463919804376, 1.0802282430953678,
        -0.7037463919804376, -1.0802282430953678, 2.8149855679217506, 1.0802282430953678,
        -0.7037463919804376, -1.0802282430953678, 0.7037463919804376, 0.5149923692075352,
        -1.6706892124357537, -0.5149923692075352, 1.6706892124357537, 2.059969476830141,
        -1.6706892124357537, -0.5149923692075352, 1.6706892124357537, 0.5149923692075352 },
    { 0.4894117647058825, 0.20470588235294118, -0.4894117647058825, -0.20470588235294118,
        1.95764705882353, 0.20470588235294118, -0.4894117647058825, -0.20470588235294118,
        0.4894117647058825, -0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, 0.0, -0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5149923692075352, 1.6706892124357537,
        0.5149923692075352, -1.6706892124357537, -2.059969476830141, 1.6706892124357537,
        0.5149923692075352, -1.6706892124357537, -0.5149923692075352, 0.7037463919804376,
        1.0802282430953678, -0.7037463919804376, -1.0802282430953678, 2.8149855679217506,
        1.0802282430953678, -0.7037463919804376, -1.0802282430953678, 0.7037463919804376 },
    { 0.6897887111965271, 0.0, 0.6897887111965271, 0.0, 0.0, 0.0, 0.6897887111965271, 0.0,
        0.6897887111965271, -0.289645506956246, 0.09393048773347785, -0.4120330528511405,
        -0.5833317782551861, 0.24477509178978896, -0.39547080278823044, -0.7706685614931748,
        -0.09393048773347785, -0.6482810155982803, 0.07293618927270588, -0.1452736063681089,
        -0.016625409820593157, 0.5951254883062957, 0.17912319818659816, 0.30457827557007805,
        -0.5147337177932978, 0.1452736063681089, -0.4251721186999988 },
    { 1.2890444975931001, 0.0178000561401968, 1.2039315854744579, -0.1787278312349001,
        0.17022582423728433, -0.14312771895450652, 0.9021920071718893, -0.0178000561401968,
        0.9873049192905314, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.07293618927270588, 0.1452736063681089,
        0.016625409820593157, -0.5951254883062957, -0.17912319818659816, -0.30457827557007805,
        0.5147337177932978, -0.1452736063681089, 0.4251721186999988, -0.289645506956246,
        0.09393048773347785, -0.4120330528511405, -0.5833317782551861, 0.24477509178978896,
        -0.39547080278823044, -0.7706685614931748, -0.09393048773347785, -0.6482810155982803 },
    { 2.2266583902747783, -0.029714365128469283, 2.095307369490741, -0.0360450270551296,
        0.03433038043219154, -0.02886535614743567, 2.1486397158062776, -0.03689403603616319,
        2.051619075454432, -0.39958840189442735, 0.12958438015147378, -0.5684314969931175,
        -0.8047513510452463, 0.3376861901973803, -0.5455825907422988, -1.063196947584117,
        -0.12958438015147378, -0.8943538524854269, 0.1006211199960115, -0.20041618741505884,
        -0.022936040026522074, 0.8210216871580072, 0.24711432004506728, 0.4201893123278896,
        -0.7101150156120716, 0.20041618741505884, -0.586557855589538 },
    { 0.4645981427921639, -0.17086197044189555, -0.2906895483189768, -0.020642081920801365,
        0.19740473744950288, 0.020642081920801365, 0.3658957740674124, -0.21214613428349827,
        -0.19198717959422534, 0.48543631673339205, 0.7451292476028425, -0.48543631673339205,
        -0.7451292476028425, 1.9417452669335682, 0.7451292476028425, -0.48543631673339205,
        -0.7451292476028425, 0.48543631673339205, 0.3552359226317118, -1.1524225586559993,
        -0.3552359226317118, 1.1524225586559993, 1.420943690526847, -1.1524225586559993,
        -0.3552359226317118, 1.1524225586559993, 0.3552359226317118 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.6281522507265302, 2.0882576983175176,
        0.6281522507265302, -1.7852183187545685, -2.6893819743178407, 1.7852183187545685,
        0.7165387364323903, -1.4821789391916196, -0.7165387364323903, 1.0489163329819662,
        1.418310451502176, -1.0489163329819662, -1.2920440433509472, 4.122009927172982,
        1.2920440433509472, -1.0120886306045245, -1.1657776351997184, 1.0120886306045245 },
    { -0.20049380590318383, 0.5557291530563849, 0.20049380590318383, -1.1243487219949935,
        -0.4702804750652134, 1.1243487219949935, 0.03464643162942291, -1.6929682909336021,
        -0.03464643162942291, 0.3552359226317118, -1.1524225586559993, -0.3552359226317118,
        1.1524225586559993, 1.420943690526847, -1.1524225586559993, -0.3552359226317118,
        1.1524225586559993, 0.3552359226317118, -0.48543631673339205, -0.7451292476028425,
        0.48543631673339205, 0.7451292476028425, -1.9417452669335682, -0.7451292476028425,
        0.48543631673339205, 0.7451292476028425, -0.48543631673339205 },
    { 0.3375907104208886, 0.1412038067625832, -0.3375907104208886, -0.1412038067625832,
        1.3503628416835545, 0.1412038067625832, -0.3375907104208886, -0.1412038067625832,
        0.3375907104208886, -1.0489163329819662, -1.418310451502176, 1.0489163329819662,
        1.2920440433509472, -4.122009927172982, -1.2920440433509472, 1.0120886306045245,
        1.1657776351997184, -1.0120886306045245, -0.6281522507265302, 2.0882576983175176,
        0.6281522507265302, -1.7852183187545685, -2.6893819743178407, 1.7852183187545685,
        0.7165387364323903, -1.4821789391916196, -0.7165387364323903 },
    { -0.6409491082818135, 0.23571731676722843, 0.40102873778649517, 0.028477350169125414,
        -0.2723351188587627, -0.028477350169125414, -0.5047815488524321, 0.2926720171054793,
        0.26486117835711376, 1.1664433549537465, 1.1701657524918851, -1.044415422845674,
        -0.8726304028285092, 3.297994716519871, 1.0428525839644975, -0.27843172537558053,
        -1.5253449489803566, 0.5251992519558788, 0.5888645851808956, -1.9855889432683869,
        -0.5986575136891021, 1.5616578119492568, 2.6569375567064886, -1.7181240289672333,
        -0.23977981510965315, 1.6941456645205215, 0.4032375180713476 },
    { -0.10802254693488578, 0.8652251302485564, -0.32552741972666455, -0.25416056962793865,
        3.647076113851802, 0.31013401598477264, -1.711786040673078, -0.025963789553421407,
        1.3831862859305917, -1.4470612909612355, -1.956669076836501, 1.4470612909612355,
        1.7824747909443994, -5.686631830407883, -1.7824747909443994, 1.3962546242427059,
        1.608280505052298, -1.3962546242427059, -0.866584662927702, 2.880913172737333,
        0.866584662927702, -2.462846886596289, -3.7102106519597498, 2.462846886596289,
        0.9885206630521731, -2.044780600455246, -0.9885206630521731 },
    { 0.27659672795368767, -0.7666713925222026, -0.27659672795368767, 1.5511261117607777,
        0.6487883255922481, -1.5511261117607777, -0.04779743484243644, 2.335580830999353,
        0.04779743484243644, -1.0789400436665708, 3.575445086246639, 1.0887329721747774,
        -3.1515139549275086, -4.61723939064919, 3.307980171945485, 0.7298552735953285,
        -3.2840018074987736, -0.8933129765570229, 1.8361403375287777, 2.19812923924949,
        -1.714112405420705, -1.9005938895861145, 5.976782646819997, 2.0708160707221026,
        -0.9481287079506117, -2.5533084357379616, 1.1948962345309098 },
};

/* The monomials of the left side of the formulation that has the joints 4, 3, 2, 1, 0, 5. */
DHGEN_TABLE double general_5r1p_pair_left_1[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { -0.4629570747217807, -0.19364069952305246, 0.4629570747217807, 0.19364069952305246,
        -1.8518282988871229, -0.19364069952305246, 0.4629570747217807, 0.19364069952305246,
        -0.4629570747217807, 0.18049738664615625, 0.21893536538566974, 0.2262843500801785,
        -0.21893536538566974, -0.09157392686804454, 0.21893536538566974, 0.2262843500801785,
        -0.21893536538566974, 0.18049738664615625, -0.21774374472016395, 0.22988213365495322,
        -0.16966743311444057, -0.22988213365495322, -0.09615262321144676, 0.22988213365495322,
        -0.16966743311444057, -0.22988213365495322, -0.21774374472016395 },
    { -0.15872813990461054, -0.06639109697933228, 0.15872813990461054, 0.06639109697933228,
        -0.6349125596184422, -0.06639109697933228, 0.15872813990461054, 0.06639109697933228,
        -0.15872813990461054, -0.526450711051289, -0.63856148237487, -0.6599960210671872,
        0.63856148237487, 0.26709062003179657, -0.63856148237487, -0.6599960210671872,
        0.63856148237487, -0.526450711051289, 0.6350859221004781, -0.6704895564936135,
        0.494863346583785, 0.6704895564936135, 0.28044515103338635, -0.6704895564936135,
        0.494863346583785, 0.6704895564936135, 0.6350859221004781 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.6713765462205055, 0.7088032454361057,
        -0.5231412521028584, -0.7088032454361057, -0.29647058823529415, 0.7088032454361057,
        -0.5231412521028584, -0.7088032454361057, -0.6713765462205055, -0.5565336088256484,
        -0.6750507099391483, -0.6977100794138836, 0.6750507099391483, 0.28235294117647064,
        -0.6750507099391483, -0.6977100794138836, 0.6750507099391483, -0.5565336088256484 },
    { -0.40383523989993214, 0.029789135464010692, -0.5462752439577305, -0.21094161742872397,
        0.2848800081155966, -0.1513633465007026, 0.07481897992128635, -0.029789135464010692,
        0.21725898397908466, 0.2634221951926038, -0.03368039504814936, 0.25637845872820714,
        -0.11317932291339157, 0.014087472928793235, -0.18054011300969033, 0.21354437432275772,
        0.03368039504814936, 0.22058811078715435, -0.20094108190778867, -0.035364414800556826,
        -0.20833700519540513, -0.11883828905906114, 0.014791846575232895, -0.1895671186601748,
        -0.25331279382112704, 0.035364414800556826, -0.2459168705335106 },
    { -0.1384577965371196, 0.010213417873375095, -0.1872943693569362, -0.07232284026127679,
        0.09767314563963313, -0.05189600451452661, 0.025652221687298176, -0.010213417873375095,
        0.07448879450711475, -0.7683147359784277, 0.09823448555710229, -0.7477705046239375,
        0.33010635849739206, -0.04108846270898026, 0.5265753296115967, -0.6228377584413767,
        -0.09823448555710229, -0.6433819897958668, 0.5860781555643836, 0.1031462098349574,
        0.6076495984865983, 0.34661167642226165, -0.043142885844429275, 0.5529040960921765,
        0.7388289819782872, -0.1031462098349574, 0.7172575390560726 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.6195683358823484, -0.10904027896838353,
        -0.6423724326858324, -0.3664180579321052, 0.04560819360696809, -0.5844986158688723,
        -0.781047780948475, 0.10904027896838353, -0.758243684144991, -0.8122184351771949,
        0.10384788473179385, -0.7905002477453054, 0.34896957898295733, -0.04343637486377914,
        0.5566653484465451, -0.6584284874951696, -0.10384788473179385, -0.6801466749270592 },
    { 1.2258171716766635, -0.06046658449822316, 1.3710288069139935, 0.07756164161069024,
        -0.104748230154149, 0.05565516078518312, 1.0498196255036698, -0.03856010367271605,
        1.0902830305868507, 0.0, 0.0, 0.0, 0.0, 0.0, 6.938893903907228e-18, 6.938893903907228e-18,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 1.0769260362094315, 0.1965278873928969, 0.6049606335844656, -0.03560011229819361,
        0.3404516486447945, 0.03560011229819361, 0.9067002118870342, 0.1253276627965097,
        0.7751864579068628, 0.0, 0.0, -3.469446951953614e-18, 0.0, 0.0, 0.0, -3.469446951953614e-18,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.1896563028813901, -1.0635731154006698, -0.032773651541346004, 0.5256897393776617,
        0.4448599088454724, -1.6014564914236777, -0.1896563028813901, 1.0635731154006698,
        0.032773651541346004, -0.00538561226200731, -0.1634379668865956, 0.19994399226342466,
        0.12966815895878134, -0.48624876976636294, -0.055477348472849145, 0.1105545260738619,
        0.02170754054503489, -0.17036463916706912, -0.05186550423505912, 0.05034143221973431,
        0.2561518032365473, 0.056099422495647096, -0.5440445571189281, 0.021800928514581708,
        0.08661331544972704, 0.08463992620079969, -0.14941393419759458 },
    { 0.06502501813076232, -0.36465363956594393, -0.011236680528461489, 0.18023648207234116,
        0.1525233973184477, -0.5490707970595466, -0.06502501813076232, 0.36465363956594393,
        0.011236680528461489, 0.015708035764187986, 0.47669407008590375, -0.5831699774349886,
        -0.3781987969631122, 1.4182255784852251, 0.16180893304580998, -0.32245070104876383,
        -0.06331365992301842, 0.4968968642372849, 0.1512743873522558, -0.1468291773075584,
        -0.7471094261065963, -0.16362331561230403, 1.5867966249302068, -0.0635860415008633,
        -0.25262217006170384, -0.2468664514189991, 0.4357906414096509 },
    { 1.734723475976807e-18, 0.0, -1.734723475976807e-18, 0.0, 6.938893903907228e-18, 0.0,
        -1.734723475976807e-18, 0.0, 1.734723475976807e-18, -0.15991863805809897,
        0.15521941601084746, 0.7898013933126875, 0.17297321936157853, -1.6774707177833614,
        0.06721952958662693, 0.26705772263665833, 0.2609731057857991, -0.4606929637759167,
        0.016605637807855872, 0.5039337312336697, -0.6164939761455593, -0.39981015678957577,
        1.4992670401129522, 0.17105515779128483, -0.3408764553944075, -0.0669315833471909,
        0.5252909707651298 },
    { 0.30230063643108235, -0.114806279583175, 1.29567752120055, 0.6270442639775676,
        -2.501820711268127, -0.017688374744506314, 0.35034465291309014, 0.22070198895986287,
        -0.8415866869376671, -0.34611564504309544, 0.22646364354284934, 4.4612854485694955e-05,
        0.008152181911015634, -0.26856005299785535, 0.5129457031472596, -0.14968370723294283,
        -0.3531702686249183, -0.1452005947893438, 0.16588334439802221, 0.45011045817861406,
        0.019452434929153453, -0.057028984176771415, 0.08582707570954315, 0.5499270891503336,
        0.281237326570254, -0.23542802562659082, 0.14386054573199536 },
    { 0.10364593249065683, -0.03936215299994572, 0.4442322929830457, 0.21498660479230888,
        -0.857767101006215, -0.0060645856266878795, 0.12011816671305948, 0.07566925335766728,
        -0.2885440069500573, 1.0095039647090285, -0.6605189603333107, -0.00013012082558327281,
        -0.023777197240462265, 0.783300154577078, -1.4960916341795072, 0.4365774794294166,
        1.0300799501560116, 0.4235017348022527, -0.48382642116089813, -1.312822169687624,
        -0.05673626854336423, 0.16633453718224991, -0.25032897081950084, -1.6039540100218062,
        -0.8202755358299075, 0.6866650747442231, -0.4195932583849864 },
    { 0.0, 0.0, -2.168404344971009e-19, 0.0, 0.0, 0.0, 0.0, 0.0, 2.168404344971009e-19,
        0.5114736452272352, 1.38784057938406, 0.059978341031556484, -0.1758393678783785,
        0.26463348343775805, 1.695608524880195, 0.8671484235916166, -0.7259030790153216,
        0.4435700160069857, 1.0671899055495442, -0.6982629009237855, -0.0001375563013309095,
        -0.025135894225631533, 0.8280601634100541, -1.5815825847040506, 0.46152476396824044,
        1.0889416615934981, 0.44770183393380997 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation general_5r1p_pair_formulations[2] = {
    { { 1, 2, 3, 4, 5, 0 }, 1.0, general_5r1p_pair_left_0 },
    { { 4, 3, 2, 1, 0, 5 }, -1.0, general_5r1p_pair_left_1 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double general_5r1p_pair_constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.6897887111965271, 0.0, 0.0, -1.0,
        0.25467491748554627, 0.9230769230769231, 0.38461538461538464, 0.0, 0.0 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.0, 0.76414006216274, 0.4075413664867947,
        -0.5000000000000001, 0.2358545586139572, 0.4411764705882354, 0.23529411764705888,
        0.8660254037844387, -0.25467491774022116 },
    { 0.28, -0.96, 0.0, 0.3419715220762444, -0.96, -0.28, 0.0, 0.0, 0.0, 0.0, -1.0,
        -0.33848222824843144 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, 1.0, 0.08695429723659354,
        -0.7241379310344828, -0.6896551724137931, 0.0, 0.33848222867719313 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9459459459459459,
        0.32432432432432434, 0.0, 0.08695429732354783 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.0 },
    { 1.0, 0.0, 0.0, -0.123, 0.0, 0.7071067811865476, 0.7071067811865476, -0.0, 0.0,
        -0.7071067811865476, 0.7071067811865476, -0.0 },
};

DHGEN_TABLE dhgen_general_arm general_5r1p_pair_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.6842675044380697, 1.4614167610095914, /* the length that is one in the loop, and its inverse
        */
    HUGE_VAL, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, general_5r1p_pair_formulations,
    { { 1.0, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.0, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    general_5r1p_pair_constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 0, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.803, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    1.0, 0.5546311702717693, 0.5546311702717693, 0.5546311702717693, 0.5546311702717693,
    0.5546311702717693,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[6] = {
    -0.33277870216306155, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    0.831946755407654, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
static const double least_u[6] = {
    -0.33277870216306155, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL,
};
static const double most_u[6] = {
    0.4991680532445924, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL,
};
/* How the loop counts the joints: from where, and which way. */
static const double facing[6] = { 1.0, -1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

static const struct dhgen_numerical_arm general_5r1p_pair_descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_WHOLE_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.803, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero,
    0, 0,
    general_5r1p_pair_fk, general_5r1p_pair_jacobian, 0,
};

static void all_joints(
    const double T[16],
    const double seed[6], double q[16][6], int found[16],
    int chosen[16])
{
    dhgen_general_rows(&general_5r1p_pair_general, &general_5r1p_pair_descents, T, 0, seed, q[0],
        found, chosen);
}

static const double
    a1 = 0.472, /* link length 1 [m] */
    d2 = -0.069, /* joint offset 2 [m] */
    d3 = -0.261, /* joint offset 3 [m] */
    a3 = 0.234, /* link length 3 [m] */
    d4 = 0.525, /* joint offset 4 [m] */
    d5 = 0.119, /* joint offset 5 [m] */
    a6 = 0.123, /* link length 6 [m] */
    f1 = 0.5, /* 1 / 2 */
    f2 = 0.8660254037844386, /* 1 / 2 * sqrt3 */
    f3 = -0.2260326303877385, /* 1 / 2 * sqrt3 * d3 [m] */
    f4 = 0.45466333698683026, /* d4 * 1 / 2 * sqrt3 [m] */
    f5 = 0.7071067811865476; /* 1 / 2 * sqrt2 */

const char *const general_5r1p_pair_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = { -0.6, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY };
static const double highest[6] = { 0.9, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 0, 1, 1, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 0.3076157350370323, 1.0, 1.0, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 1.803e-09) /* of limits */

void general_5r1p_pair_fk(const double q[6], double T[16])
{
    const double c2 = cos(-q[1]), s2 = sin(-q[1]), v1 = s2 * f2, y2_z = c2 * f2, z2_x = s2 * f1,
        z3_z = c2 * f1;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = c2 * c3 - v1 * s3, v2 = f1 * s3,
        x3_z = s2 * c3 + y2_z * s3, y3_x = v1 * c3 + c2 * s3, y3_y = f1 * c3,
        y3_z = s2 * s3 - y2_z * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = y3_y * s4 - v2 * c4, x4_z = x3_z * c4 + y3_z * s4, z4_x = y3_x * c4 - x3_x * s4,
        z4_y = y3_y * c4 + v2 * s4, z4_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z2_x * s5,
        x5_y = x4_y * c5 - f2 * s5, x5_z = x4_z * c5 - z3_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 + z4_x * s6,
        x6_y = x5_y * c6 + z4_y * s6, x6_z = x5_z * c6 + z4_z * s6,
        v3 = (z4_x * c6 - x5_x * s6) * f5, v4 = (z4_y * c6 - x5_y * s6) * f5,
        v5 = (z4_z * c6 - x5_z * s6) * f5, v6 = (x4_x * s5 - z2_x * c5) * f5,
        v7 = (f2 * c5 + x4_y * s5) * f5, v8 = (z3_z * c5 + x4_z * s5) * f5;
    T[0] = x6_x; T[1] = v3 + v6; T[2] = v6 - v3;
    T[3] = a1 + x3_x * a3 + z2_x * d3 - z2_x * d4 + z4_x * d5 + x6_x * a6;
    T[4] = x6_y; T[5] = v4 + v7; T[6] = v7 - v4;
    T[7] = f4 - (d2 + v2 * a3 + f3) + z4_y * d5 + x6_y * a6;
    T[8] = x6_z; T[9] = v5 + v8; T[10] = v8 - v5;
    T[11] = q[0] + x3_z * a3 - z3_z * d3 + z3_z * d4 + z4_z * d5 + x6_z * a6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void general_5r1p_pair_jacobian(const double q[6], double J[36])
{
    const double c2 = cos(-q[1]), s2 = sin(-q[1]), v1 = s2 * f2, y2_z = c2 * f2, z2_x = s2 * f1,
        z3_z = c2 * f1;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = c2 * c3 - v1 * s3, v2 = f1 * s3,
        x3_z = s2 * c3 + y2_z * s3, y3_x = v1 * c3 + c2 * s3, y3_y = f1 * c3,
        p3_x = a1 + x3_x * a3 + z2_x * d3, v3 = d2 + v2 * a3 + f3,
        p3_z = q[0] + x3_z * a3 - z3_z * d3, y3_z = s2 * s3 - y2_z * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = y3_y * s4 - v2 * c4, x4_z = x3_z * c4 + y3_z * s4, z4_x = y3_x * c4 - x3_x * s4,
        z4_y = y3_y * c4 + v2 * s4, z4_z = y3_z * c4 - x3_z * s4, p4_x = p3_x - z2_x * d4,
        p4_y = f4 - v3, p4_z = p3_z + z3_z * d4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_y = f2 * c5 + x4_y * s5,
        z5_z = z3_z * c5 + x4_z * s5, p5_x = p4_x + z4_x * d5, p5_y = p4_y + z4_y * d5,
        p5_z = p4_z + z4_z * d5, z5_x = x4_x * s5 - z2_x * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        p6_x = p5_x + ((x4_x * c5 + z2_x * s5) * c6 + z4_x * s6) * a6,
        p6_y = p5_y + ((x4_y * c5 - f2 * s5) * c6 + z4_y * s6) * a6,
        p6_z = p5_z + ((x4_z * c5 - z3_z * s5) * c6 + z4_z * s6) * a6, v4 = p6_x - a1,
        J12 = p6_z - q[0], v5 = d2 + p6_y, v6 = p6_x - p3_x, v7 = v3 + p6_y, v8 = p6_z - p3_z,
        v9 = p6_x - p4_x, v10 = p6_y - p4_y, v11 = p6_z - p4_z, v12 = p6_x - p5_x,
        v13 = p6_y - p5_y, v14 = p6_z - p5_z;
    J[0] = 0.0; J[1] = J12; J[2] = z3_z * v5 - f2 * J12; J[3] = f2 * v8 - z3_z * v7;
    J[4] = z4_y * v11 - z4_z * v10; J[5] = z5_y * v14 - z5_z * v13;
    J[6] = 0.0; J[7] = 0.0; J[8] = -(z3_z * v4 + z2_x * J12); J[9] = z3_z * v6 + z2_x * v8;
    J[10] = z4_z * v9 - z4_x * v11; J[11] = z5_z * v12 - z5_x * v14;
    J[12] = 1.0; J[13] = -v4; J[14] = z2_x * v5 + f2 * v4; J[15] = -(z2_x * v7 + f2 * v6);
    J[16] = z4_x * v10 - z4_y * v9; J[17] = z5_x * v13 - z5_y * v12;
    J[18] = 0.0; J[19] = 0.0; J[20] = z2_x; J[21] = -z2_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = 1.0; J[26] = -f2; J[27] = f2; J[28] = z4_y; J[29] = z5_y;
    J[30] = 0.0; J[31] = 0.0; J[32] = -z3_z; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
static double beyond_limits(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(overshoot(i, values[i])) * sqrt(weight[i]);
    return sum;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[6], double q[16][6], unsigned char status[16])
{

    /* all joints: the general 5R1P loop */
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
        /* all joints: the general 5R1P loop */
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
static double half_way(const double x[6], const double q[6], double half[6])
{
    double most = 0.0;
    for (int i = 0; i < 6; i++) {
        double off = q[i] - x[i];
        off -= revolute[i] ? turn * floor(off / turn + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(weight[i]));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 0.5546, 0.5546, 0.5546, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.803, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    general_5r1p_pair_fk(x, P);
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
static void add_step(const int held[6], double damping, double e[6], double x[6])
{
    double A[6][12] = { { 0.0 } }, square[6] = { 0.0 }, J[36];
    general_5r1p_pair_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[6 * i + j];
        A[i][6 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
            for (int j = 0; j < 12; j++)
                along += A[k][j] * A[i][j] / square[k];
            for (int j = 0; j < 12; j++)
                A[i][j] -= along * A[k][j];
            e[i] -= along * e[k];
        }
        for (int j = 0; j < 12; j++)
            square[i] += A[i][j] * A[i][j];
        for (int j = 0; j < 6; j++)
            x[j] += e[i] / square[i] * A[i][j] * pace[j];
    }
}

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[6])
{
    double x[6], half[6], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[6] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 6 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? overshoot(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 6; i++)
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
    const double T[16], int row, int far, double rows[16][6], const unsigned char status[16])
{
    double x[6], half[6], to[6], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 16; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

int general_5r1p_pair_ik(
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
        (void)stand(pose, row, 0, q, status);
        for (int i = 0; i < 6; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int general_5r1p_pair_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = general_5r1p_pair_ik(T, q_seed, all, status) >= 0;
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

void general_5r1p_pair_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)general_5r1p_pair_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
