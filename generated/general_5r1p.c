/* general_5r1p: General arm with five revolute joints and a slide
 *
 * Inverse kinematics, generated from robots/general_5r1p.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_5r1p.yaml. The formulas and where they come from:
 * general_5r1p.md.
 */
#include "general_5r1p.h"

#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x84u /* what the general algorithm has to do for the arm */
#ifdef GENERAL_5R1P_LANES
#define DHGEN_GENERAL_LANES GENERAL_5R1P_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = GENERAL_5R1P_OK, NONE = GENERAL_5R1P_UNREACHABLE, FREE = GENERAL_5R1P_FREE_JOINT,
    OUT = GENERAL_5R1P_OUT_OF_LIMITS, INVALID = GENERAL_5R1P_INVALID_POSE
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
DHGEN_TABLE double general_5r1p_left_0[15][32] DHGEN_ALIGNED = {
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.24870905112736552, 0.0, 0.0, 0.12651414447293255, 0.0, 0.0, 0.22655250811483657,
        0.0, 0.0, -0.011018598099059251, 0.0, 0.0, -0.7447882002747499, 0.0, 0.0,
        0.5791513659701044, 0.0, 0.0, 0.5532900721397139, 0.0, 0.0, -0.5667701303839322, 0.0, 0.0,
        -0.27024825455573015 },
    { 0.0, 0.0, 0.0852716746722396, 0.0, 0.0, 0.043376278105005446, 0.0, 0.0, 0.07767514563937254,
        0.0, 0.0, -0.577176621049957, 0.0, 0.0, 0.6179481405423801, 0.0, 0.0, 0.2616460938450305,
        0.0, 0.0, -0.031047852087247113, 0.0, 0.0, -0.7574440333671859, 0.0, 0.0, 0.6141087655071972
        },
    { 0.0, 0.0, -0.7701080629195963, 0.0, 0.0, -0.3917411219669915, 0.0, 0.0, -0.7015020659000695,
        0.0, 0.0, -0.06746746935694649, 0.0, 0.0, -0.1721084353721203, 0.0, 0.0,
        0.21601018778130363, 0.0, 0.0, 0.17524910203633978, 0.0, 0.0, -0.2669097915318116, 0.0, 0.0,
        -0.0192792476907648 },
    { 0.0, 0.19217576904021408, 0.24376673655014983, 0.0, 0.14976378815403782, 0.055231423748198595,
        0.0, 0.23585687391847515, 0.15443448870960408, 0.0, 0.1338856641476146, -0.3350884568599391,
        0.0, -1.128139758764325, -0.044289869394788406, 0.0, 0.37778915039245686,
        0.44070006447298443, 0.0, 0.7281684082626478, -0.37525203731809514, 0.0,
        -0.17617963630193884, -0.8111788652500196, 0.0, -0.4732537514966397, -0.47664199660469087 },
    { 0.0, 0.06588883509950197, -0.5813900928516845, 0.0, 0.05134758450995583, 0.018936488142239517,
        0.0, 0.08086521391490577, -0.6120182921113002, 0.0, -0.7648467683582046, 0.403553859980258,
        0.0, 0.22376282435196687, 0.8483342314627487, 0.0, 0.480671953738187, 0.4819864360545578,
        0.0, 0.11403629403524808, -0.3365342353018067, 0.0, -1.171413477331292,
        -0.01757698209186534, 0.0, 0.41108318790851184, 0.47687403547602225 },
    { 0.0, -0.5950571905799006, -0.13794987231646266, 0.0, -0.4637318194412772,
        -0.17101977013789732, 0.0, -0.7303123045836065, 0.13866042404748177, 0.0,
        -0.0414502715304995, -0.06353370526067828, 0.0, -0.3395600575691541, 0.07962984957513124,
        0.0, 0.1752316201858067, 0.19569446509516134, 0.0, 0.24779137998150283,
        -0.15845232875643966, 0.0, -0.1866047974793041, -0.2639192528370955, 0.0,
        -0.10732096389343028, -0.10113039304509593 },
    { 1.0, -0.5205198187136566, 0.6956433527164206, 0.0, 0.03215780955882437, 0.7563533020685526,
        1.0, 0.6362579095779857, 0.8824669094148053, 0.0, 0.966058529516632, -0.6150823383608972,
        0.0, -0.7165083400155249, -1.0299888842109166, 0.0, -0.42307732630052225,
        -0.39958029753981555, 0.0, 0.15404175146783905, 0.252084368618516, 0.0, 1.3276871267026962,
        -0.30222342851855094, 0.0, -0.6791166041687385, -0.7589767579423011 },
    { 0.0, 0.9544456308244855, -0.1076559941303642, 0.0, 0.0, 0.2220739197828016, 0.0,
        0.9544456308244855, 0.313792247610572, 0.0, 0.0, 0.34218593038739636, 0.0, 0.0,
        -0.5170811791253253, 0.0, 0.0, -0.04073918616723497, 0.0, 0.0, 0.1287490376094572, 0.0, 0.0,
        0.3390309234933357, 0.0, 0.0, -0.4202547175133888 },
    { 0.0, 0.02767814824338979, 0.39559948783266374, 0.0, -0.053832139347681295, 0.1922691946452119,
        0.0, 0.05798137004843953, 0.4714729158333487, 0.0, 0.2446507457262468, -0.3457589788513976,
        0.0, 0.24330819313532998, -0.7301101922285044, 0.0, -0.14225243836211948,
        -0.5217972212326437, 0.0, -0.11587814389355179, 0.1665080845469617, 0.0,
        0.38889794128929117, 0.22344659030160924, 0.0, 0.16689263323989523, -0.40002613264379866 },
    { 0.0, 0.009489650826305072, 0.13150982961084587, 0.0, -0.018456733490633585,
        0.06382291405921185, 0.0, 0.019879326873750696, 0.15789099281084162, 0.0,
        0.11231968060592441, -0.2558893909398016, 0.0, -0.41455620610499194, -0.003300690354548122,
        0.0, -0.16918982387995027, 0.4004330286486142, 0.0, 0.259478454498484, -0.4474393443919885,
        0.0, 0.24024501784375302, -0.8184358088968569, 0.0, -0.15438954922707288,
        -0.39177204631889057 },
    { 0.0, -0.08570321438765292, 0.36323519726072173, 0.0, 0.16668699578058557, 0.21253315932851868,
        0.0, -0.17953476309377064, -0.013185651901215734, 0.0, 0.09144761038354196,
        -0.2760436165725572, 0.0, 0.032674697380081955, -0.5944021468368006, 0.0,
        -0.0646747787531495, 0.31989461632650085, 0.0, -0.008692002044931455, 0.3658096735225257,
        0.0, 0.1521975143621911, -0.5648461084541366, 0.0, 0.03680347525684355, -0.2156175472821148
        },
    { -0.11813359509417001, -0.6556766283396306, 0.4616011547252208, -0.15936864204575796,
        -0.017481933079677464, 0.33297412689926253, -0.22367261750798376, -0.512917104313085,
        -0.09250555017925008, -0.2665917724505097, 0.7829578259673093, -0.39961721624036184,
        1.4087079271492478, 0.20976496983567083, -0.5068368624126304, -0.14200704195984548,
        -0.7864854730974481, 0.1565625406762441, -0.8367042394016948, 0.5739269618879299,
        0.30402249721322505, -0.230462362166667, 1.6807372384351678, -0.20656062613022766,
        0.6331416962187989, 1.0793012273549571, 0.01850354160907547 },
    { -0.04050294688942972, 1.0454647355675089, 0.012968656458864625, -0.0546406772728313,
        -0.007779175655078227, 0.40813099044861034, -0.07668775457416585, 1.0954158797120113,
        0.3873617828997886, 0.8828326915694746, -0.5973042812143853, 0.03081882281349993,
        0.19080924045501668, -1.5579038644691439, -0.7319791806190185, -0.655904398365533,
        -1.0815213916813768, -0.1524969064650376, -0.24873073728196488, 0.6792908144564235,
        0.07714439889019778, 1.4786569172883526, 0.1859476622176225, -0.030201918992694088,
        -0.17060433970216304, -0.7623410606837816, -0.33070886563520074 },
    { 0.3657914083597624, 0.49925474349848703, -0.4804440872255769, 0.493472495913041,
        0.7416417400659627, -0.7753873452273587, 0.6925847105942989, -0.3298026562950181,
        -0.7764420408903903, 0.01165659176060114, -0.18925671671456168, 0.5074760139580224,
        0.4760747913266595, -0.24396652282800818, 0.8831426297480226, -0.11848792075597424,
        -0.10880895118704931, 0.35941126059490164, -0.29775769792229073, 0.2991973760149577,
        -0.0708161912589207, 0.08929847575820803, -0.06178505820155644, 0.23199618774012268,
        0.18558480247714898, 0.11070064098139087, 0.6954237268885941 },
};

/* The monomials of the left side of the formulation that has the joints 3, 2, 1, 0, 5, 4. */
DHGEN_TABLE double general_5r1p_left_1[15][32] DHGEN_ALIGNED = {
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.12077263550238015, -0.19250983049270745, 0.11488165253823089,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.12386093604119919, -1.80377222040283, -0.11651359831946617,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.8594571839909242, 0.04528965847612587, 0.8695383694961355
        },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.11502155762131444, -0.18334269570734044, 0.10941109765545799,
        -0.0, -0.0, -0.0, -0.0, -0.0, -0.0, 0.8494819454593607, 0.10693146430901368,
        -0.8601888994148241, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.19647198937935156, -1.8086005265510094,
        -0.18997145204784183 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3890399898528032, 0.6201241050169165, -0.37006360548342754,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.28960454235575217, -0.5283438892702257, -0.2904892153706974,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.20871991847262153, -0.5206618947838805, 0.2137714127224597
        },
    { 0.0, 0.0, 0.0, 0.21738130116461452, 0.0, 0.21738130116461452, -0.34531030238518584,
        -0.10368477239969981, -0.42973014286140104, 0.0, 0.0, 0.0, -0.5495447761950757, 0.0,
        -0.5495447761950757, 0.4673843320080865, 0.10432640928815357, -0.32536674928722836, 0.0,
        0.0, 0.0, -0.28877535077690186, 0.0, -0.28877535077690186, -0.4432753361452154,
        -0.7596891890715296, -0.4221343835301784 },
    { 0.0, 0.0, 0.0, 0.20702981063296622, 0.0, 0.20702981063296622, 0.25823630858671537,
        -0.0987474022854284, 0.17783646051412944, 0.0, 0.0, 0.0, 0.3353203676037254, 0.0,
        0.3353203676037254, 0.40407316573952273, 0.7513071275045836, 0.4498321326403618, 0.0, 0.0,
        0.0, -0.5254772442023238, 0.0, -0.5254772442023238, 0.5050593168741961, 0.1685057103974908,
        -0.2899181375247866 },
    { 0.0, 0.0, 0.0, -0.700241564220929, 0.0, -0.700241564220929, -0.18130399908531547,
        0.3339955498567758, 0.0906342073273016, 0.0, 0.0, 0.0, -0.0714602629262648, 0.0,
        -0.0714602629262648, 0.26455985289433587, 0.2545144305017762, 0.031988980754549354, 0.0,
        0.0, 0.0, -0.2450066157471936, 0.0, -0.2450066157471936, 0.011713908177640469,
        -0.18601654877744095, -0.2167620810081511 },
    { 1.0, 0.0, 1.0, -0.06980993031443444, -0.20090294438586964, 0.4145836890961123,
        0.6705114889310473, 0.738852810916113, 0.5337441258969509, 0.0, 0.0, 0.0,
        0.5786227964205345, 0.0, 0.5786227964205345, -0.21002404324690793, 0.2236906224174515,
        0.4454314997234631, 0.0, 0.0, 0.0, 0.016880958292714944, 0.0, 0.016880958292714944,
        0.5627368311471909, 0.6791366808305508, 0.2203995882681725 },
    { 0.0, 0.0, 0.0, -0.12640232387595318, 0.5508233780105449, 0.10310741696177382,
        0.4192280417897504, -0.1542560832251843, -0.42177465843733974, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.12409016284601762, 0.7462655774932121, -0.1292318037666097, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.38535737727688574, -0.3882872256521799, -0.3880756958366243 },
    { 0.0, 0.0, 0.0, 0.15781450477608033, -0.16952311661666142, -0.15887627540145766,
        -0.02810701179045348, -0.11350502133408474, -0.1788820069836507, 0.0, 0.0, 0.0,
        0.7770329014884426, 0.16033344610082545, -0.7787512661227827, 0.4164315884935167,
        0.19127243112828446, -0.1436634851932712, 0.0, 0.0, 0.0, -0.13824609635124002,
        -1.7450310744087272, 0.13249759470612732, 0.17955771958406036, -0.147863871272993,
        0.18623859184948577 },
    { 0.0, 0.0, 0.0, 0.15029952835817173, -0.16145058725396325, -0.15131073847757873,
        0.0536480837756194, 0.020082980404183104, -0.24685796150039147, 0.0, 0.0, 0.0,
        0.07273815060205735, 1.7324711288326626, -0.06684140639731662, -0.1362358374056878,
        -0.1961070754475417, -0.25212353502104035, 0.0, 0.0, 0.0, 0.7891347045905631,
        0.3077111968791556, -0.7903688282385748, 0.2547869990518521, 0.09394879736130263,
        -0.010444617452681451 },
    { 0.0, 0.0, 0.0, -0.5083614602042982, 0.5460779363969562, 0.511781698833724, 0.4178916795072798,
        0.8874229891335501, 0.26484103329769204, 0.0, 0.0, 0.0, 0.26272560516011556,
        0.5619870098695715, -0.2615156491402768, -0.3302785510719178, 0.42386165600367487,
        0.3030932726175973, 0.0, 0.0, 0.0, 0.19039471371262542, -0.45074692911050374,
        -0.19254413932431647, 0.2660828129218096, 0.7938243338255819, -0.0858790782048065 },
    { -0.06581763223360872, -0.4319872357403486, 0.07005440362048522, -0.05307463179130399,
        0.23547440742889345, 0.11016188802256002, 0.06653871377586804, -0.554845930001894,
        -0.43717545186532847, -0.015066537528697133, -1.198368000419189, -0.0031893135628455194,
        0.4464478066965865, -0.9928612361793451, -0.3221190094456863, -0.19776667536397807,
        -0.5066794641614392, -0.3965490439940179, -0.932460934823512, 0.36341808687835214,
        0.9290881304978085, 0.020484296563562723, 0.5422579943501633, 0.3746106587590728,
        -0.006436479062752493, -0.483036205477223, -0.20019595340244822 },
    { -0.06268345927010355, -0.41141641499080817, 0.06671847963855736, 0.3080372824910819,
        -0.6482735807356891, -0.2277293988833682, -0.5723377225227512, -0.6674414515770604,
        -0.058478640261587334, 0.9342524928754603, -0.26247313088942975, -0.9293369333314092,
        -0.3562369244009089, -0.7449745532368224, -0.049705651730583916, 0.1908579214660936,
        -0.1540770883709623, 0.015034218423113616, 0.06362889975714059, -1.2297102251126175,
        -0.08161024940405603, 0.3930526351886492, -0.4314485175347455, -0.2997061753949928,
        -0.5554867307083976, -0.9576344911862428, -0.18381421628374486 },
    { 0.2120156678686873, 1.3915429526720364, -0.22566340761124348, 0.6994352727713892,
        -0.25236970216123533, -0.9493543053981358, 0.28638875647571893, 0.08498597995375859,
        -0.24218991144753305, 0.27153905575841913, -0.4496199224330919, -0.2757530491192246,
        0.5054745660038631, 1.1334961059198734, -0.5824231479713695, -0.06435031134536345,
        -0.1275703884890932, -0.2694749720693336, -0.27065872966347754, -0.25075115134227904,
        0.2642954112989377, 0.7692132140246999, -0.590559561449677, -0.6230899587648827,
        0.20889009735527928, -0.12877584124517621, -0.0799662696647502 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation general_5r1p_formulations[2] = {
    { { 4, 3, 2, 1, 0, 5 }, -1.0, general_5r1p_left_0 },
    { { 3, 2, 1, 0, 5, 4 }, -1.0, general_5r1p_left_1 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double general_5r1p_constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.43936788242416075, -0.011264649500846345,
        -0.004693603958685977, -0.9999255361043152, 0.058795324397600594, 0.9230081871732141,
        0.38458674465550585, -0.01220337029258354, -4.6235725321515234e-10 },
    { 0.6145349462240683, -0.7888895992909156, 0.0, -0.00632184003488001, 0.7529522312460936,
        0.5865401944125223, 0.29838488198977153, 0.060080385216903724, -0.235392729987378,
        -0.18336793740765922, 0.9544456308244855, -0.058790946321855296 },
    { 0.28, -0.96, 0.0, 0.3650862620143206, -0.7314004443085399, -0.21332512958999084,
        0.647723536048123, -0.13871905921788164, -0.6218145946061981, -0.18136259009347447,
        -0.7618754628213957, -0.038185682994733766 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.4251437423456807, 0.6655569082924576,
        0.633863722183293, 0.3940187603707805, 0.13757420646323018, -0.2853239299236686,
        -0.27173707611777964, 0.9191023971657748, -0.0607588648632754 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, -0.629023083470561, 0.8952109992393914,
        0.3069294854535056, 0.323096824187513, 0.0047942638808703055, -0.305632130988188,
        -0.10478815919595016, 0.9463659134816423, -0.0016367997061155746 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, 0.29254598344443916 },
    { 1.0, 0.0, 0.0, -0.357, 0.0, -0.7427737668732654, 0.6695424790443845, -0.018486934316693265,
        0.0, -0.6695424790443845, -0.7427737668732654, 0.020508944943937776 },
};

DHGEN_TABLE dhgen_general_arm general_5r1p_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.6327271772032304, 1.5804600087200025, /* the length that is one in the loop, and its inverse
        */
    HUGE_VAL, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, general_5r1p_formulations,
    { { 0.6, 0.38461538461538464, 1.0, 0.28, 0.6896551724137931, 0.32432432432432434 }, /* cosines
        and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.0, 0.96, 0.7241379310344828, 0.9459459459459459 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    general_5r1p_constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 0, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 2.651, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.37721614485099964, 0.37721614485099964, 1.0, 0.37721614485099964, 0.37721614485099964,
    0.37721614485099964,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -0.30177291588079974, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 6.283185307179586, 0.6035458317615995, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
static const double least_u[6] = {
    -HUGE_VAL, -HUGE_VAL, -0.30177291588079974, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL,
};
static const double most_u[6] = {
    HUGE_VAL, HUGE_VAL, 0.30177291588079974, HUGE_VAL, HUGE_VAL, HUGE_VAL,
};
/* How the loop counts the joints: from where, and which way. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

static const struct dhgen_numerical_arm general_5r1p_descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_WHOLE_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 2.651, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero,
    0, 0,
    general_5r1p_fk, general_5r1p_jacobian, 0,
};

static void all_joints(
    const double T[16],
    const double seed[6], double q[16][6], int found[16],
    int chosen[16])
{
    dhgen_general_rows(&general_5r1p_general, &general_5r1p_descents, T, 0, seed, q[0], found,
        chosen);
}

static const double
    d1 = -0.293, /* joint offset 1 [m] */
    a1 = 0.278, /* link length 1 [m] */
    ca1 = 0.012203370292583539, /* cosine of twist 1 */
    sa1 = 0.9999255361043151, /* sine of twist 1 */
    d2 = -0.196, /* joint offset 2 [m] */
    a2 = -0.004, /* link length 2 [m] */
    ca2 = 0.9544456308244855, /* cosine of twist 2 */
    sa2 = 0.29838488198977153, /* sine of twist 2 */
    cat3 = 0.6145349462240683, /* cosine of the angle of joint 3 */
    sat3 = 0.7888895992909156, /* sine of the angle of joint 3 */
    a3 = 0.231, /* link length 3 [m] */
    ca3 = 0.7618754628213957, /* cosine of twist 3 */
    sa3 = 0.647723536048123, /* sine of twist 3 */
    d4 = -0.377, /* joint offset 4 [m] */
    a4 = 0.269, /* link length 4 [m] */
    ca4 = 0.9191023971657747, /* cosine of twist 4 */
    sa4 = 0.39401876037078043, /* sine of twist 4 */
    d5 = 0.211, /* joint offset 5 [m] */
    a5 = -0.398, /* link length 5 [m] */
    ca5 = 0.9463659134816423, /* cosine of twist 5 */
    sa5 = 0.323096824187513, /* sine of twist 5 */
    d6 = 0.037, /* joint offset 6 [m] */
    a6 = 0.357, /* link length 6 [m] */
    ca6 = 0.7427737668732654, /* cosine of twist 6 */
    sa6 = 0.6695424790443845, /* sine of twist 6 */
    f1 = -0.002391860577346374, /* ca1 * d2 [m] */
    f2 = 0.003641301204630023, /* ca1 * sa2 */
    f3 = 0.011647453457089682; /* ca1 * ca2 */

const char *const general_5r1p_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = { -INFINITY, -INFINITY, -0.8, -INFINITY, -INFINITY, -INFINITY };
static const double highest[6] = { INFINITY, INFINITY, 0.8, INFINITY, INFINITY, INFINITY };
static const int revolute[6] = { 1, 1, 0, 1, 1, 1 };
/* Of squared differences of joint values: lengths count in arm sizes. */
static const double weight[6] = { 1.0, 1.0, 0.14229201993625035, 1.0, 1.0, 1.0 };
#define slack(joint) (revolute[joint] ? 1e-09 : 2.651e-09) /* of limits */

void general_5r1p_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), y1_x = s1 * ca1, v1 = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 + y1_x * s2,
        x2_y = s1 * c2 - v1 * s2, x2_z = sa1 * s2, v3 = y1_x * c2 - c1 * s2, v4 = v1 * c2 + s1 * s2,
        v5 = sa1 * c2, y2_x = v3 * ca2 - z1_x * sa2, y2_y = v2 * sa2 - v4 * ca2,
        y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2, v6 = v4 * sa2 + v2 * ca2,
        z2_z = v5 * sa2 - f3, x3_x = x2_x * cat3 + y2_x * sat3, x3_y = x2_y * cat3 + y2_y * sat3,
        x3_z = x2_z * cat3 + y2_z * sat3, v7 = y2_x * cat3 - x2_x * sat3,
        v8 = y2_y * cat3 - x2_y * sat3, v9 = y2_z * cat3 - x2_z * sat3, v10 = v7 * ca3 + z2_x * sa3,
        y3_y = v6 * sa3 - v8 * ca3, v11 = v9 * ca3 + z2_z * sa3, z3_x = v7 * sa3 - z2_x * ca3,
        z3_y = v8 * sa3 + v6 * ca3, z3_z = v9 * sa3 - z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v10 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 - v11 * s4, v12 = v10 * c4 + x3_x * s4,
        v13 = y3_y * c4 - x3_y * s4, v14 = v11 * c4 + x3_z * s4, v15 = v12 * ca4 + z3_x * sa4,
        y4_y = v13 * ca4 - z3_y * sa4, v16 = v14 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v12 * sa4,
        z4_y = v13 * sa4 + z3_y * ca4, z4_z = z3_z * ca4 - v14 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v15 * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v16 * s5, v17 = v15 * c5 + x4_x * s5,
        v18 = y4_y * c5 - x4_y * s5, v19 = v16 * c5 + x4_z * s5, v20 = v17 * ca5 + z4_x * sa5,
        y5_y = v18 * ca5 - z4_y * sa5, v21 = v19 * ca5 + z4_z * sa5, z5_x = z4_x * ca5 - v17 * sa5,
        z5_y = v18 * sa5 + z4_y * ca5, z5_z = z4_z * ca5 - v19 * sa5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 - v20 * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 - v21 * s6, v22 = v20 * c6 + x5_x * s6,
        v23 = y5_y * c6 - x5_y * s6, v24 = v21 * c6 + x5_z * s6;
    T[0] = x6_x; T[1] = v22 * ca6 + z5_x * sa6; T[2] = v22 * sa6 - z5_x * ca6;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + x5_x
        * a5 + z4_x * d5 + x6_x * a6 + z5_x * d6;
    T[4] = x6_y; T[5] = z5_y * sa6 - v23 * ca6; T[6] = -(v23 * sa6 + z5_y * ca6);
    T[7] = s1 * a1 + x2_y * a2 - v2 * d2 - v6 * q[2] + x3_y * a3 + x4_y * a4 + z3_y * d4 + x5_y * a5
        + z4_y * d5 + x6_y * a6 + z5_y * d6;
    T[8] = x6_z; T[9] = v24 * ca6 + z5_z * sa6; T[10] = v24 * sa6 - z5_z * ca6;
    T[11] = d1 + x2_z * a2 - f1 + z2_z * q[2] + x3_z * a3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z
        * d5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void general_5r1p_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, y1_x = s1 * ca1,
        v1 = c1 * ca1, z1_x = s1 * sa1, v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 + y1_x * s2,
        x2_y = s1 * c2 - v1 * s2, x2_z = sa1 * s2, v3 = y1_x * c2 - c1 * s2, v4 = v1 * c2 + s1 * s2,
        v5 = sa1 * c2, y2_x = v3 * ca2 - z1_x * sa2, y2_y = v2 * sa2 - v4 * ca2,
        y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2, v6 = v4 * sa2 + v2 * ca2,
        z2_z = v5 * sa2 - f3, x3_x = x2_x * cat3 + y2_x * sat3, x3_y = x2_y * cat3 + y2_y * sat3,
        x3_z = x2_z * cat3 + y2_z * sat3, v7 = y2_x * cat3 - x2_x * sat3,
        v8 = y2_y * cat3 - x2_y * sat3, v9 = y2_z * cat3 - x2_z * sat3,
        p3_x = p1_x + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3,
        p3_y = p1_y + x2_y * a2 - v2 * d2 - v6 * q[2] + x3_y * a3,
        p3_z = d1 + x2_z * a2 - f1 + z2_z * q[2] + x3_z * a3, v10 = v7 * ca3 + z2_x * sa3,
        y3_y = v6 * sa3 - v8 * ca3, v11 = v9 * ca3 + z2_z * sa3, z3_x = v7 * sa3 - z2_x * ca3,
        z3_y = v8 * sa3 + v6 * ca3, z3_z = v9 * sa3 - z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v10 * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 - v11 * s4, v12 = v10 * c4 + x3_x * s4,
        v13 = y3_y * c4 - x3_y * s4, v14 = v11 * c4 + x3_z * s4,
        p4_x = p3_x + x4_x * a4 + z3_x * d4, p4_y = p3_y + x4_y * a4 + z3_y * d4,
        p4_z = p3_z + x4_z * a4 + z3_z * d4, v15 = v12 * ca4 + z3_x * sa4,
        y4_y = v13 * ca4 - z3_y * sa4, v16 = v14 * ca4 + z3_z * sa4, z4_x = z3_x * ca4 - v12 * sa4,
        z4_y = v13 * sa4 + z3_y * ca4, z4_z = z3_z * ca4 - v14 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v15 * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 - v16 * s5, v17 = v15 * c5 + x4_x * s5,
        v18 = y4_y * c5 - x4_y * s5, v19 = v16 * c5 + x4_z * s5,
        p5_x = p4_x + x5_x * a5 + z4_x * d5, p5_y = p4_y + x5_y * a5 + z4_y * d5,
        p5_z = p4_z + x5_z * a5 + z4_z * d5, z5_x = z4_x * ca5 - v17 * sa5,
        z5_y = v18 * sa5 + z4_y * ca5, z5_z = z4_z * ca5 - v19 * sa5;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        p6_x = p5_x + (x5_x * c6 - (v17 * ca5 + z4_x * sa5) * s6) * a6 + z5_x * d6,
        p6_y = p5_y + (x5_y * c6 + (v18 * ca5 - z4_y * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 - (v19 * ca5 + z4_z * sa5) * s6) * a6 + z5_z * d6,
        v20 = p6_x - p1_x, v21 = p6_y - p1_y, v22 = p6_z - d1, v23 = p6_x - p3_x, v24 = p6_y - p3_y,
        v25 = p6_z - p3_z, v26 = p6_x - p4_x, v27 = p6_y - p4_y, v28 = p6_z - p4_z,
        v29 = p6_x - p5_x, v30 = p6_y - p5_y, v31 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = ca1 * v21 - v2 * v22; J[2] = z2_x; J[3] = z3_y * v25 - z3_z * v24;
    J[4] = z4_y * v28 - z4_z * v27; J[5] = z5_y * v31 - z5_z * v30;
    J[6] = p6_x; J[7] = -(ca1 * v20 + z1_x * v22); J[8] = -v6; J[9] = z3_z * v23 - z3_x * v25;
    J[10] = z4_z * v26 - z4_x * v28; J[11] = z5_z * v29 - z5_x * v31;
    J[12] = 0.0; J[13] = z1_x * v21 + v2 * v20; J[14] = z2_z; J[15] = z3_x * v24 - z3_y * v23;
    J[16] = z4_x * v27 - z4_y * v26; J[17] = z5_x * v30 - z5_y * v29;
    J[18] = 0.0; J[19] = z1_x; J[20] = 0.0; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -v2; J[26] = 0.0; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = -ca1; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
static const double weights[6] = { 0.3772, 0.3772, 0.3772, 1.0, 1.0, 1.0 };
/* What a step of one means for joints; none if given. */
static const double pace[6] = { 1.0, 1.0, 2.651, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[6], double e[6])
{
    double P[16], square = 0.0;
    general_5r1p_fk(x, P);
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
    general_5r1p_jacobian(x, J);
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

int general_5r1p_ik(
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

int general_5r1p_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = general_5r1p_ik(T, q_seed, all, status) >= 0;
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

void general_5r1p_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)general_5r1p_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
