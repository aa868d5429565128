/* kinova_gen3_lite: Kinova Gen3 lite
 *
 * Inverse kinematics, generated from robots/kinova_gen3_lite.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_gen3_lite.yaml. The formulas and where they come from:
 * kinova_gen3_lite.md.
 */
#include "kinova_gen3_lite.h"

#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the general algorithm has to do for the arm */
#ifdef KINOVA_GEN3_LITE_LANES
#define DHGEN_GENERAL_LANES KINOVA_GEN3_LITE_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = KINOVA_GEN3_LITE_OK, NONE = KINOVA_GEN3_LITE_UNREACHABLE, FREE =
        KINOVA_GEN3_LITE_FREE_JOINT,
    OUT = KINOVA_GEN3_LITE_OUT_OF_LIMITS, INVALID = KINOVA_GEN3_LITE_INVALID_POSE
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

/* The monomials of the left side of the formulation that has the joints 4, 3, 2, 1, 0, 5. */
DHGEN_TABLE double kinova_gen3_lite_left_0[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { -0.2648648648648649, 0.0, -0.2648648648648649, 1.816216216216216, 0.0, 1.816216216216216,
        0.2648648648648649, 0.0, 0.2648648648648649, 0.2147250698974837, 0.0, 0.2147250698974837,
        0.12525629077353218, 0.0, 0.12525629077353218, -0.2147250698974837, 0.0,
        -0.2147250698974837, 0.2254613233923579, 0.0, 0.2254613233923579, 0.13151910531220878, 0.0,
        0.13151910531220878, -0.2254613233923579, 0.0, -0.2254613233923579 },
    { -0.09081081081081083, 0.0, -0.09081081081081083, 0.6227027027027027, 0.0, 0.6227027027027027,
        0.09081081081081083, 0.0, 0.09081081081081083, -0.6262814538676608, 0.0,
        -0.6262814538676608, -0.3653308480894688, 0.0, -0.3653308480894688, 0.6262814538676608, 0.0,
        0.6262814538676608, -0.6575955265610438, 0.0, -0.6575955265610438, -0.38359739049394226,
        0.0, -0.38359739049394226, 0.6575955265610438, 0.0, 0.6575955265610438 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6951724137931035, 0.0, 0.6951724137931035,
        0.4055172413793104, 0.0, 0.4055172413793104, -0.6951724137931035, 0.0, -0.6951724137931035,
        -0.6620689655172414, 0.0, -0.6620689655172414, -0.3862068965517242, 0.0,
        -0.3862068965517242, 0.6620689655172414, 0.0, 0.6620689655172414 },
    { -0.6134198882306965, 1.6020569940569918, 0.24101050859969908, -0.29243897506961625,
        0.9345332465332453, 0.20597875641478122, 0.2284017267125356, -1.6020569940569918,
        -0.6260286701178601, -0.03284771149862473, 0.3314600677359294, -0.3882465619043712,
        0.1990514163412569, -0.7576230119678385, -0.20501419004159036, 0.036300420537540685,
        0.1104866892453098, -0.4369508983965363, -0.037946916480375396, -0.09443981295015766,
        0.4185209482302474, 0.20900398715831972, -0.7955041625662304, -0.21526489954366984,
        0.0346586221575983, -0.32646186036530817, 0.3673813949134741 },
    { -0.21031539025052456, 0.5492766836766829, 0.08263217437703968, -0.10026479145243986,
        0.3204113988113984, 0.07062128791363928, 0.07830916344429792, -0.5492766836766829,
        -0.21463840118326633, 0.09580582520432214, -0.9667585308964607, 1.132385805554416,
        -0.5805666309953326, 2.2097337849061955, 0.5979580542879718, -0.10587622656782698,
        -0.32225284363215356, 1.2744401203232307, 0.1106785064010949, 0.2754494544379598,
        -1.220686099004888, -0.6095949625450992, 2.320220474151505, 0.6278559570023703,
        -0.1010876479596617, 0.9521804260654821, -1.0715290684976326 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.11700299248115748, -0.2911894232629861,
        1.290439590376596, 0.6444289604048191, -2.452804501245877, -0.6637334402596486,
        0.10686408498592809, -1.0065907361263668, 1.1327593009832118, 0.10128044378742626,
        -1.0220018755191156, 1.1970935658718111, -0.6137418670522087, 2.3360042869008355,
        0.6321270859615702, -0.1119262966574171, -0.3406672918397052, 1.3472652700559868 },
    { 0.4444639511965145, -2.335387463840295, 3.1631814833607677, 0.1258298933387088,
        -0.4021085722406259, -0.08862801185629186, 0.0822471023879374, -0.9567295018724338,
        3.5362488809350503, 0.0, 0.0, -1.3877787807814457e-17, 0.0, 2.7755575615628914e-17, 0.0,
        -8.673617379884035e-19, 0.0, 0.0, -8.673617379884035e-19, 0.0, -1.3877787807814457e-17,
        -6.938893903907228e-18, 0.0, 0.0, -8.673617379884035e-19, 0.0, 0.0 },
    { 0.033180395566675236, 0.0, 0.033180395566675236, -0.39073843134643077, 0.0,
        -0.39073843134643077, -0.08078498024270048, 0.0, -0.08078498024270048,
        3.469446951953614e-18, 0.0, 3.469446951953614e-18, -1.734723475976807e-18, 0.0,
        -1.734723475976807e-18, -3.469446951953614e-18, 0.0, -3.469446951953614e-18, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { -0.006675237475237518, -0.8544303968303956, 1.595381756581754, -0.0038938885272218593,
        -0.49841773148439744, 0.9306393580060234, 0.006675237475237518, 0.8544303968303956,
        -1.595381756581754, -0.15683059411280081, 0.3553988504057465, 0.17462947362312858,
        -0.02360863791981028, 0.4040656063828473, -0.7812316498876489, -0.06414278437781877,
        0.47325131893407696, 0.046343904867491, 0.14844065207513463, -0.4564678647106228,
        0.05400083912497699, 0.02880545826752722, 0.42426888670198953, -0.7666987042987031,
        0.0620101845825983, -0.3327227727558758, -0.2644516757827099 },
    { -0.0022886528486528637, -0.2929475646275642, 0.54698803082803, -0.0013350474950474948,
        -0.17088607936607914, 0.31907635131635087, 0.0022886528486528637, 0.2929475646275642,
        -0.54698803082803, 0.4574225661623357, -1.036579980350094, -0.509335964734125,
        0.06885852726611331, -1.1785246852833045, 2.278592312172309, 0.1870831211019714,
        -1.3803163468910578, -0.13516972253018206, -0.4329519018858093, 1.3313646054059831,
        -0.15750244744784953, -0.0840159199469544, -1.2374509195474694, 2.236204554204551,
        -0.18086303836591172, 0.970441420537971, 0.7713173876995705 },
    { 0.0, 0.0, 0.0, 6.938893903907228e-18, 0.0, 6.938893903907228e-18, 0.0, 0.0, 0.0,
        0.4576920105649984, -1.4074425828577535, 0.1665025873020124, 0.08881682965820893,
        1.3081624006644677, -2.363987671587668, 0.19119806912967807, -1.0258952159972836,
        -0.8153926669966889, 0.48356099851446915, -1.095813122084385, -0.5384408770046465,
        0.07279330025274836, -1.245868953013779, 2.408797587153584, 0.1977735851649412,
        -1.4591915667134039, -0.14289370667476392 },
    { -0.0770158552910483, 0.5122483154508201, -0.8538092841555198, 0.3139477499674406,
        -2.9451100423368386, 5.943171174202404, 0.058687225619249495, -0.5122483154508201,
        0.835480654483721, 0.09761735310955215, -0.5234621887348847, 0.7049787141158445,
        0.0438118025585656, -0.06955992622313265, 0.08737692230497701, -0.011795457297261494,
        0.22328513917807058, -0.8299194275216658, 0.10272761803567143, -0.5202724475294971,
        0.6854017021382811, 0.04330096830155684, -0.4188202438062285, 0.7373861964201748,
        -0.012943748337089517, 0.1629590697414569, -0.7379295550811195 },
    { -0.026405436099787995, 0.17562799386885258, -0.292734611710464, 0.10763922856026535,
        -1.0097520145154877, 2.037658688297967, 0.020121334498028404, -0.17562799386885258,
        0.28645051010870437, -0.28471727990286044, 1.5267647171434136, -2.056187916171213,
        -0.12778442412914967, 0.2028831181508035, -0.2548493567228497, 0.0344034171170127,
        -0.6512483226027058, 2.420598330271525, -0.2996222192707083, 1.5174613052943664,
        -1.99908829790332, -0.12629449087954076, 1.221559044434833, -2.1507097395588435,
        0.03775259931651109, -0.47529728674591587, 2.152294535653265 },
    { -5.421010862427522e-20, 0.0, 0.0, -5.421010862427522e-20, 0.0, 0.0, 5.421010862427522e-20,
        0.0, 0.0, 0.3167434889433202, -1.6041733798826159, 2.1133219149263667, 0.13351131892980025,
        -1.2913624184025378, 2.273607438962206, -0.039909890706026026, 0.5024571317028252,
        -2.2752827948334513, -0.3009868387544525, 1.6140084152658944, -2.173684368523854,
        -0.13508639122224392, 0.21447643918799225, -0.26941217710701243, 0.03636932666655627,
        -0.6884625124657175, 2.55891823485847 },
};

/* The monomials of the left side of the formulation that has the joints 1, 2, 3, 4, 5, 0. */
DHGEN_TABLE double kinova_gen3_lite_left_1[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.955656108597285, -0.5574660633484163,
        -0.955656108597285, -0.18244343891402715, 0.10642533936651588, 0.18244343891402715,
        -0.955656108597285, 0.5574660633484163, 0.955656108597285, -0.09122171945701357,
        0.05321266968325794, 0.09122171945701357, -1.91131221719457, 1.1149321266968326,
        1.91131221719457, 0.09122171945701357, -0.05321266968325794, -0.09122171945701357 },
    { 0.28, 1.92, -0.28, 0.0, 0.0, 0.0, 0.28, 1.92, -0.28, 0.0, 0.0, 0.0, 0.0, -0.0, -0.0, 0.0, 0.0,
        0.0, 0.0, -0.0, -0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.09122171945701357, -0.05321266968325794,
        -0.09122171945701357, 1.91131221719457, -1.1149321266968326, -1.91131221719457,
        -0.09122171945701357, 0.05321266968325794, 0.09122171945701357, 0.955656108597285,
        -0.5574660633484163, -0.955656108597285, -0.18244343891402715, 0.10642533936651588,
        0.18244343891402715, -0.955656108597285, 0.5574660633484163, 0.955656108597285 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5648607084072147, -0.056724847659562115,
        0.37037551643157307, 1.7229878456982535, 0.010829289098643675, 1.7601168368936033,
        0.2041364293078708, 0.056724847659562115, 0.3986216212835123, -0.06130264240897576,
        0.005414644549321838, -0.042738146811300864, -0.3607242790993439, 0.11344969531912423,
        0.028246104851939347, -1.7842904881072292, -0.005414644549321838, -1.8028549837049042 },
    { -0.007212094598673564, 0.19536921557553077, -0.06419478247487004, 0.0, 0.0, 0.0,
        -0.007212094598673564, 0.19536921557553077, -0.06419478247487004, 0.0, 0.0, 0.0, 0.0, -0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 8.684862539046195e-10, 0.0, 8.684862539046195e-10, 0.0, 0.0, 0.0, 8.684862539046195e-10, 0.0,
        8.684862539046195e-10, 0.06130264240897576, -0.005414644549321838, 0.042738146811300864,
        0.3607242790993439, -0.11344969531912423, -0.028246104851939347, 1.7842904881072292,
        0.005414644549321838, 1.8028549837049042, 0.5648607084072147, -0.056724847659562115,
        0.37037551643157307, 1.7229878456982535, 0.010829289098643675, 1.7601168368936033,
        0.2041364293078708, 0.056724847659562115, 0.3986216212835123 },
    { 0.32287764817712344, -0.06756518183249949, 0.14312554246181455, 1.9907229731759972,
        -0.20105428601978595, 1.301393992536731, 3.2254162420290013, 0.03966377071138635,
        3.4133062593213017, 1.0648100452045164e-10, -9.40508872173118e-12, 7.42349860459447e-11,
        6.265681556948673e-10, -1.970590017886533e-10, -4.90627075805158e-11,
        3.0992635237877852e-09, 9.40508872173118e-12, 3.1315095422622923e-09, 9.811475212449831e-10,
        -9.852950089432665e-11, 6.433320896072916e-10, 2.9927825192673336e-09,
        1.881017744346236e-11, 3.0572745562163474e-09, 3.545793655501158e-10, 9.852950089432665e-11,
        6.923947971878071e-10 },
    { 0.543385332456121, -0.3319999743466405, -0.33987573289827644, 1.6936031080031058,
        -0.987935146335145, -1.6936031080031058, -0.3598696584788686, 0.1948987703654368,
        0.5633792580367132, 7.922480940595987e-11, -4.621447215347661e-11, -7.922480940595987e-11,
        1.6599483875534447e-09, -9.683032260728428e-10, -1.6599483875534447e-09,
        -7.922480940595987e-11, 4.621447215347661e-11, 7.922480940595987e-11, 8.299741937767224e-10,
        -4.841516130364214e-10, -8.299741937767224e-10, -1.5844961881191973e-10,
        9.242894430695321e-11, 1.5844961881191973e-10, -8.299741937767224e-10,
        4.841516130364214e-10, 8.299741937767224e-10 },
    { -2.431761510932935e-10, -1.6674936074968695e-09, 2.431761510932935e-10, 0.0, 0.0, 0.0,
        -2.431761510932935e-10, -1.6674936074968695e-09, 2.431761510932935e-10,
        -0.01782263954469082, -0.09797928237005174, 0.01782263954469082, -0.114787362665824,
        -0.2793721366193156, 0.114787362665824, -0.49894343699984656, -3.445559528221062,
        0.49894343699984656, -0.165053280613024, -0.8779233205161397, 0.165053280613024,
        -0.48112079745515585, -3.34758024585101, 0.48112079745515585, -0.05026591794719996,
        -0.5985511838968243, 0.05026591794719996 },
    { 0.007056679616679773, -0.004116396443063108, -0.007056679616679773, -0.9032549909349896,
        0.5268987447120773, 0.9032549909349896, -1.686546428386426, 0.9838187498920818,
        1.686546428386426, 8.299741937767224e-10, -4.841516130364214e-10, -8.299741937767224e-10,
        -1.5844961881191973e-10, 9.242894430695321e-11, 1.5844961881191973e-10,
        -8.299741937767224e-10, 4.841516130364214e-10, 8.299741937767224e-10,
        -7.922480940595987e-11, 4.621447215347661e-11, 7.922480940595987e-11,
        -1.6599483875534447e-09, 9.683032260728428e-10, 1.6599483875534447e-09,
        7.922480940595987e-11, -4.621447215347661e-11, -7.922480940595987e-11 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.165053280613024, 0.8779233205161397,
        -0.165053280613024, 0.48112079745515585, 3.34758024585101, -0.48112079745515585,
        0.05026591794719996, 0.5985511838968243, -0.05026591794719996, -0.01782263954469082,
        -0.09797928237005174, 0.01782263954469082, -0.114787362665824, -0.2793721366193156,
        0.114787362665824, -0.49894343699984656, -3.445559528221062, 0.49894343699984656 },
    { 1.2257258490590605e-11, -7.150067452844359e-12, -1.2257258490590605e-11,
        -1.5689290867955604e-09, 9.15208633964077e-10, 1.5689290867955604e-09,
        -2.9294847792510855e-09, 1.7088661212298e-09, 2.9294847792510855e-09, -0.3053140508485159,
        0.1921519715900586, 0.11498450123958392, -1.9422526880411088, 1.1853150689988452,
        1.2334074488687863, -2.9354637202676765, 1.7214103953248474, 2.812796670761557,
        0.037168459210726194, -0.023244834568709464, -0.015995159858825502, -0.19904791012360654,
        0.11111573081238212, 0.2667104102264191, -0.9899960016020204, 0.5236000999305273,
        1.720014540126243 },
    { 0.09824363433200492, 0.38389647082908385, -0.08371164937309185, 0.5818312841443313,
        3.089886923533232, -0.5818312841443313, 0.8979257197278367, 6.3473312030058535,
        -0.8833937347689237, 3.095743490572173e-11, 1.7018731981165835e-10, -3.095743490572173e-11,
        1.9938249319446494e-10, 4.85261720755678e-10, -1.9938249319446494e-10,
        8.666510330205846e-10, 5.984842174540157e-09, -8.666510330205846e-10,
        2.8669301074854633e-10, 1.5249286717011338e-09, -2.8669301074854633e-10,
        8.35693598114863e-10, 5.814654854728497e-09, -8.35693598114863e-10, 8.731051755408135e-11,
        1.039666950945456e-09, -8.731051755408135e-11 },
    { -9.438453836230657e-10, 5.766748280334872e-10, 5.903548041158223e-10, -2.9417420377416764e-09,
        1.7160161886826444e-09, 2.9417420377416764e-09, 6.250837031724948e-10,
        -3.385338059305898e-10, -9.785742826797381e-10, -0.037168459210726194, 0.023244834568709464,
        0.015995159858825502, 0.19904791012360654, -0.11111573081238212, -0.2667104102264191,
        0.9899960016020204, -0.5236000999305273, -1.720014540126243, -0.3053140508485159,
        0.1921519715900586, 0.11498450123958392, -1.9422526880411088, 1.1853150689988452,
        1.2334074488687863, -2.9354637202676765, 1.7214103953248474, 2.812796670761557 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation kinova_gen3_lite_formulations[2] = {
    { { 4, 3, 2, 1, 0, 5 }, -1.0, kinova_gen3_lite_left_0 },
    { { 1, 2, 3, 4, 5, 0 }, 1.0, kinova_gen3_lite_left_1 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double kinova_gen3_lite_constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, -0.01190114619875918,
        0.9230769230769231, 0.38461538461538464, 0.0, 8.684862539046195e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.999696279029611, -0.8823529411764706,
        -0.47058823529411764, 0.0, 0.0, 0.0, 0.0, -1.0, 0.01190114621066032 },
    { 0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, -0.4373671218567712, 0.96, 0.28, 0.0,
        -0.011901146127352304 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, -0.10175479977892228,
        0.7241379310344828, 0.6896551724137931, 0.0, 0.4373671222941383 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9459459459459459,
        0.32432432432432434, 0.0, 0.10175479988067708 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.24324999975674996 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.105 },
};

DHGEN_TABLE dhgen_general_arm kinova_gen3_lite_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.28008506770855596, 3.5703438536771817, /* the length that is one in the loop, and its inverse
        */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, kinova_gen3_lite_formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    kinova_gen3_lite_constants,
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
    1.02014792144861, 1.02014792144861, 1.02014792144861, 1.02014792144861, 1.02014792144861,
    1.02014792144861,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[6] = { -2.76, -2.76, -2.76, -2.67, -2.67, -2.67 };
static const double span_width[6] = { 5.52, 5.52, 5.52, 5.34, 5.34, 5.34 };
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
static const double least_u[6] = { -2.76, -2.76, -2.76, -2.67, -2.67, -2.67 };
static const double most_u[6] = { 2.76, 2.76, 2.76, 2.67, 2.67, 2.67 };
/* How the loop counts the joints: from where, and which way. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = {
    0.0, 1.5707963267948966, 1.5707963267948966, 1.5707963267948966, 3.141592653589793,
    1.5707963267948966,
};

static const struct dhgen_numerical_arm kinova_gen3_lite_descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_WHOLE_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 0.9802500000000001, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero,
    0, 0,
    kinova_gen3_lite_fk, kinova_gen3_lite_jacobian, 0,
};

static void all_joints(
    const double T[16],
    const double seed[6], double q[16][6], int found[16],
    int chosen[16])
{
    dhgen_general_rows(&kinova_gen3_lite_general, &kinova_gen3_lite_descents, T, 0, seed, q[0],
        found, chosen);
}

static const double
    d1 = 0.24325, /* joint offset 1 [m] */
    d2 = 0.03, /* joint offset 2 [m] */
    a2 = 0.28, /* link length 2 [m] */
    d3 = 0.02, /* joint offset 3 [m] */
    d4 = 0.245, /* joint offset 4 [m] */
    d5 = 0.057, /* joint offset 5 [m] */
    d6 = 0.105, /* joint offset 6 [m] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset4 = 1.5707963267948966, /* offset of joint 4 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    offset6 = 1.5707963267948966; /* offset of joint 6 [rad] */

const char *const kinova_gen3_lite_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = { -2.76, -2.76, -2.76, -2.67, -2.67, -2.67 };
static const double highest[6] = { 2.76, 2.76, 2.76, 2.67, 2.67, 2.67 };
#define slack(joint) 1e-09 /* of limits */

void kinova_gen3_lite_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, v2 = q[2] + offset3;
    const double c3 = cos(v2), s3 = sin(v2), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = s2 * c3 - c2 * s3, z3_z = c2 * c3 + s2 * s3,
        z3_x = x2_x * s3 - y2_x * c3, z3_y = x2_y * s3 - y2_y * c3, v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3), x4_x = x3_x * c4 - s1 * s4, x4_y = x3_y * c4 + c1 * s4,
        x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4, z4_y = x3_y * s4 - c1 * c4,
        v4 = q[4] + offset5;
    const double c5 = cos(v4), s5 = sin(v4), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z5_x = x4_x * s5 - z3_x * c5,
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5, v5 = q[5] + offset6;
    const double c6 = cos(v5), s6 = sin(v5);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = x2_x * a2 + s1 * d2 - s1 * d3 + z3_x * d4 + z4_x * d5 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = x2_y * a2 - c1 * d2 + c1 * d3 + z3_y * d4 + z4_y * d5 + z5_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = z4_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + s2 * a2 + z3_z * d4 + z4_z * d5 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kinova_gen3_lite_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, p2_z = d1 + s2 * a2, p2_x = x2_x * a2 + s1 * d2, p2_y = x2_y * a2 - c1 * d2,
        v2 = q[2] + offset3;
    const double c3 = cos(v2), s3 = sin(v2), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = s2 * c3 - c2 * s3, z3_z = c2 * c3 + s2 * s3,
        p3_x = p2_x - s1 * d3, p3_y = p2_y + c1 * d3, z3_x = x2_x * s3 - y2_x * c3,
        z3_y = x2_y * s3 - y2_y * c3, v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p3_x + z3_x * d4, p4_y = p3_y + z3_y * d4, p4_z = p2_z + z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4, v4 = q[4] + offset5;
    const double c5 = cos(v4), s5 = sin(v4), p5_x = p4_x + z4_x * d5, p5_y = p4_y + z4_y * d5,
        p5_z = p4_z + z4_z * d5, z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        p6_x = p5_x + z5_x * d6, p6_y = p5_y + z5_y * d6, p6_z = p5_z + z5_z * d6, v5 = p6_z - d1,
        v6 = p6_z - p2_z, v7 = p6_x - p3_x, v8 = p6_y - p3_y, v9 = p6_x - p4_x, v10 = p6_y - p4_y,
        v11 = p6_z - p4_z, v12 = p6_x - p5_x, v13 = p6_y - p5_y, v14 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(c1 * v5); J[2] = c1 * v6; J[3] = z3_y * v6 - z3_z * v8;
    J[4] = z4_y * v11 - z4_z * v10; J[5] = z5_y * v14 - z5_z * v13;
    J[6] = p6_x; J[7] = -(s1 * v5); J[8] = s1 * v6; J[9] = z3_z * v7 - z3_x * v6;
    J[10] = z4_z * v9 - z4_x * v11; J[11] = z5_z * v12 - z5_x * v14;
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x));
    J[15] = z3_x * v8 - z3_y * v7; J[16] = z4_x * v10 - z4_y * v9; J[17] = z5_x * v13 - z5_y * v12;
    J[18] = 0.0; J[19] = s1; J[20] = -s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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

/* How far a joint value is beyond its limits, whole turns aside; negative below. */
static double overshoot(int joint, double value)
{
    const double low = lowest[joint], high = highest[joint];
    if (low <= value && value <= high)
        return 0.0;
    const double gap = turn - (high - low), over = value - high;
    const double rest = over - turn * floor(over / turn);
    const double off = rest >= gap ? 0.0 : rest <= gap - rest ? rest : rest - gap;
    return fabs(off) <= 0.5 * slack(joint) ? 0.0 : off;
}

/* The same of a row. */
static double beyond_limits(const double values[6])
{
    double sum = 0.0;
    for (int i = 0; i < 6; i++)
        sum += fabs(overshoot(i, values[i]));
    return sum;
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

/* How far joint values are from others, whole turns aside [rad, arm sizes]; half is the middle. */
static double half_way(const double x[6], const double q[6], double half[6])
{
    double most = 0.0;
    for (int i = 0; i < 6; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 1.02, 1.02, 1.02, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    kinova_gen3_lite_fk(x, P);
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
    kinova_gen3_lite_jacobian(x, J);
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

int kinova_gen3_lite_ik(
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

int kinova_gen3_lite_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = kinova_gen3_lite_ik(T, q_seed, all, status) >= 0;
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

void kinova_gen3_lite_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)kinova_gen3_lite_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
