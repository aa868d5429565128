/* kinova_jaco2: Kinova Jaco2 with 6 joints
 *
 * Inverse kinematics, generated from robots/kinova_jaco2.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_jaco2.yaml. The formulas and where they come from:
 * kinova_jaco2.md.
 */
#include "kinova_jaco2.h"

#define DHGEN_TRAITS 0x0u /* what the general algorithm has to do for the arm */
#ifdef KINOVA_JACO2_LANES
#define DHGEN_GENERAL_LANES KINOVA_JACO2_LANES
#endif
#include "dhgen/general.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = KINOVA_JACO2_OK, NONE = KINOVA_JACO2_UNREACHABLE, FREE = KINOVA_JACO2_FREE_JOINT,
    OUT = KINOVA_JACO2_OUT_OF_LIMITS, INVALID = KINOVA_JACO2_INVALID_POSE
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

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.8045774017520156, 0.8045774017520156, 0.8045774017520156, 0.8045774017520156,
    0.8045774017520156, 0.8045774017520156,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };

/* A descent towards a pose: u are the joints that are solved for, in units. */
struct descent {
    const double *T;
    double q[6], seed[6]; /* all joint values; the seed in units */
    double e[6], length; /* the miss [arm sizes, rad], and its length */
    double A[6][6]; /* how u moves the tool */
};

/* The rotation vector of an axis times the sine, and the cosine. */
static void turn_vector(const double axis[3], double cosine, double vector[3])
{
    const double sine = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double scale = sine < 1e-09 ? 1.0 : atan2(sine, cosine) / sine;
    const int opposite = sine < 1e-09 && cosine < 0.0; /* any axis will do */
    vector[0] = opposite ? 1.5079644737231006 : scale * axis[0];
    vector[1] = opposite ? 1.8849555921538759 : scale * axis[1];
    vector[2] = opposite ? 2.0106192982974678 : scale * axis[2];
}

/* By how much u misses the pose, and the analytic Jacobian of that. */
static void look(struct descent *d, const double u[6])
{
    double P[16], J[36], square = 0.0;
    for (int j = 0; j < 6; j++)
        d->q[solved[j]] = unit[j] * u[j];
    kinova_jaco2_fk(d->q, P);
    kinova_jaco2_jacobian(d->q, J);
    for (int i = 0; i < 3; i++) {
        const int row = coordinate[i];
        d->e[i] = (d->T[4 * row + 3] - P[4 * row + 3]) / 1.2428885000031569;
        for (int j = 0; j < 6; j++)
            d->A[i][j] = measure[j] * J[6 * row + solved[j]];
    }
    double R[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[i][j] = d->T[4 * i] * P[4 * j] + d->T[4 * i + 1] * P[4 * j + 1]
                + d->T[4 * i + 2] * P[4 * j + 2];
    const double axis[3] = { 0.5 * (R[2][1] - R[1][2]), 0.5 * (R[0][2] - R[2][0]),
        0.5 * (R[1][0] - R[0][1]) };
    turn_vector(axis, 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0), d->e + 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 6; j++)
            d->A[3 + i][j] = J[6 * (3 + i) + solved[j]];
    for (int i = 0; i < 6; i++)
        square += d->e[i] * d->e[i];
    d->length = sqrt(square);
}

/* What is added from start to start, in parts of the range: a direction that is like no other. */
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};

static void copy(const double from[6], double to[6])
{
    for (int j = 0; j < 6; j++)
        to[j] = from[j];
}

/* Moves angles by whole turns to (-pi, pi]. */
static void wrap_angles(double u[6])
{
    for (int j = 0; j < 6; j++)
        if (turning[j])
            u[j] -= 6.283185307179586 * ceil(u[j] / 6.283185307179586 - 0.5);
}

/* Makes a step no longer than it may be. */
static void shorten(double step[6])
{
    double longest = 2.0;
    for (int j = 0; j < 6; j++)
        longest = fmax(longest, fabs(step[j]));
    for (int j = 0; j < 6; j++)
        step[j] *= 2.0 / longest;
}

/* The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping. The rows of
 * A, each with its share of the damping's root behind it, are made orthonormal one after another
 * (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994):
 * A A' would lose half of the digits. */
static void damped_step(
    const struct descent *d, const double e[6], double length, double little,
    double step[6])
{
    const double damping = 0.1 * fmin(length * length, 1.0) + little;
    double rows[6][12], y[6], sum[12] = { 0.0 };
    for (int i = 0; i < 6; i++) {
        double square = 0.0;
        for (int j = 0; j < 12; j++)
            rows[i][j] = j < 6 ? d->A[i][j] : j == 6 + i ? sqrt(damping) : 0.0;
        y[i] = e[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < 12; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < 12; j++)
                rows[i][j] -= along * rows[k][j];
            y[i] -= along * y[k];
        }
        for (int j = 0; j < 12; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        y[i] *= inverse;
        for (int j = 0; j < 12; j++)
            rows[i][j] *= inverse;
    }
    for (int i = 6 - 1; i >= 0; i--) {
        double missing = y[i];
        for (int j = 0; j < 12; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < 12; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < 6; j++)
        step[j] = sum[j];
}


/* Takes u to where damped least squares lead; returns by how much that misses the pose. Near to it
 * less damping than usual leads further, where joints hardly move the tool: there a step that is
 * right may be long, and what it leaves, half of its square, far more than was missed. */
static double descend(struct descent *d, double u[6])
{
    double least = HUGE_VAL, little = 1e-13, best[6], step[6];
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    copy(u, best); /* compilers don't know that some miss is finite */
    for (int k = 0; k <= 40; k++) {
        look(d, u);
        const int slow = d->length >= fmax(0.5 * last, left);
        const int stalled = slow && least <= (little < 1e-13 ? 1e-10 : 1e-12);
        if (slow && least <= 1e-06)
            little = 1e-26;
        if (d->length < least) {
            least = d->length;
            copy(u, best);
        }
        if (stalled)
            break;
        damped_step(d, d->e, d->length, little, step);
        shorten(step);
        double way = 0.0;
        for (int j = 0; j < 6; j++) {
            u[j] += step[j];
            way += fabs(step[j]);
        }
        last = d->length;
        left = little < 1e-13 ? 0.5 * way * way : 0.0;
    }
    copy(best, u);
    return least;
}

/* A step with a pull; joints that it would take beyond a limit are put there, and locked. */
static void limited_step(
    struct descent *d, const double u[6], double pull, const double low[6],
    const double high[6], double step[6])
{
    double e[6], wish[6], fixed[6];
    int locked[6], beyond = 1;
    for (int j = 0; j < 6; j++) {
        wish[j] = pull * (fmin(fmax(d->seed[j], low[j]), high[j]) - u[j]);
        locked[j] = 0;
    }
    while (beyond) {
        beyond = 0;
        for (int i = 0; i < 6; i++) {
            e[i] = d->e[i];
            for (int j = 0; j < 6; j++)
                e[i] -= d->A[i][j] * wish[j];
        }
        damped_step(d, e, d->length, 1e-13, step);
        for (int j = 0; j < 6; j++)
            step[j] += wish[j];
        shorten(step);
        for (int j = 0; j < 6; j++) {
            const double end = u[j] + step[j];
            if (locked[j]) {
                step[j] = fixed[j];
            } else if (end < low[j] || end > high[j]) {
                step[j] = fixed[j] = (end < low[j] ? low[j] : high[j]) - u[j];
                beyond = locked[j] = 1;
                wish[j] = 0.0;
                for (int i = 0; i < 6; i++) {
                    d->e[i] -= d->A[i][j] * fixed[j];
                    d->A[i][j] = 0.0;
                }
            }
        }
    }
}

/* Takes u to a solution on the way to the seed; returns by how much it misses the pose. */
static double pulled(
    struct descent *d, double u[6], const double low[6],
    const double high[6])
{
    double least = HUGE_VAL, pull = 0.5, best[6], step[6];
    copy(u, best); /* compilers don't know that some miss is finite */
    for (int k = 1; k <= 60 + 40; k++) {
        look(d, u);
        if (pull == 0.0) {
            if (d->length >= 0.5 * least && least <= 1e-10)
                break;
            if (d->length < least) {
                least = d->length;
                copy(u, best);
            }
        }
        limited_step(d, u, pull, low, high, step);
        double longest = 0.0;
        for (int j = 0; j < 6; j++) {
            longest = fmax(longest, fabs(step[j]));
            u[j] += step[j];
        }
        if (k >= 60 || longest < 1e-09)
            pull = 0.0;
    }
    copy(best, u);
    return least;
}

/* Between which values starts lie. */
static const double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};

/* Start number k; number 0 is the seed. */
static void start_of(const struct descent *d, int k, double u[6])
{
    for (int j = 0; j < 6; j++)
        u[j] = k == 0 ? d->seed[j] : span_low[j] + span_width[j] * fmod(0.5 + k * stride[j], 1.0);
}
static const double no_lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double no_highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };

static double distance_between(const double a[6], const double b[6])
{
    double most = 0.0;
    for (int j = 0; j < 6; j++)
        most = fmax(most, fabs(a[j] - b[j]));
    return most;
}

/* The part of a generic direction that leaves the tool where it is, to first order, one long;
 * returns how long it was. */
static double sideways(const struct descent *d, double along[6])
{
    double moved[6], square = 0.0;
    for (int i = 0; i < 6; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < 6; j++)
            moved[i] += d->A[i][j] * stride[j];
    }
    damped_step(d, moved, 0.0, 1e-13, along);
    for (int j = 0; j < 6; j++) {
        along[j] = stride[j] - along[j];
        square += along[j] * along[j];
    }
    const double length = sqrt(square);
    for (int j = 0; j < 6; j++)
        along[j] /= length;
    return length;
}

/* Whether u is one of a continuum of solutions: 1 if there are others to both sides, that miss the
 * pose by no more than `enough`, 0 if it is a singular solution that stands alone, -1 if it is a
 * regular one. */
static int continuum(struct descent *d, const double u[6], double enough)
{
    double along[6], end[2][6];
    look(d, u);
    if (sideways(d, along) <= 0.0001)
        return -1;
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j < 6; j++)
            end[side][j] = u[j] + (1 - 2 * side) * 0.05 * along[j];
        if (descend(d, end[side]) > enough || distance_between(end[side], u) <= 0.01)
            return 0;
    }
    return distance_between(end[0], end[1]) > 0.01;
}

/* The solutions kept so far. */
struct kept {
    double u[16][6];
    int count, singular[16], chosen[16];
};

/* Whether solutions lie all along the way from one to another: where many roots meet, joint values
 * beside the solution miss the pose by next to nothing. */
static int solves_between(
    struct descent *d, const double u[6], const double way[6], double length)
{
    static const double part[] = { 0.25, 0.5, 0.75 };
    for (int i = 0; i < 3; i++) {
        double start[6], end[6], step[6];
        for (int j = 0; j < 6; j++)
            start[j] = end[j] = u[j] + part[i] * way[j];
        look(d, end);
        for (int k = 0; k < 4 && d->length > 1e-10; k++) {
            damped_step(d, d->e, d->length, 1e-13, step);
            for (int j = 0; j < 6; j++)
                end[j] += step[j];
            look(d, end);
        }
        if (d->length > 1e-10 || distance_between(start, end) > 0.0625 * length)
            return 0;
    }
    return 1;
}

/* Whether a solution is taken for one that is known; loosely where both are singular. */
static int taken_for(
    struct descent *d, const double known[6], const double u[6], int loose)
{
    static const double none[6] = { 0.0 };
    double gap[6];
    for (int j = 0; j < 6; j++)
        gap[j] = u[j] - known[j];
    wrap_angles(gap);
    const double length = distance_between(gap, none);
    if (length < 1e-06)
        return 1;
    return loose && length < 0.1 && solves_between(d, known, gap, length);
}

/* Which of those kept a solution is; -1 for none. */
static int known_as(
    struct descent *d, const struct kept *kept, const double u[6], int singular)
{
    for (int k = 0; k < kept->count; k++)
        if (taken_for(d, kept->u[k], u, singular && kept->singular[k]))
            return k;
    return -1;
}

/* A solution joins those found before, unless it is one of them. */
static void keep(struct descent *d, struct kept *kept, double u[6])
{
    if (kept->count == 16 || known_as(d, kept, u, 0) >= 0)
        return;
    const double enough = 1e-10;
    const int kind = continuum(d, u, enough);
    if (kind == 1) {
        double end[6];
        copy(u, end);
        (void)pulled(d, end, no_lowest, no_highest);
        if (descend(d, end) <= enough)
            copy(end, u);
    }
    wrap_angles(u);
    int k = known_as(d, kept, u, kind >= 0);
    if (k >= 0)
        return;
    k = k < 0 ? kept->count++ : k;
    kept->singular[k] = kind >= 0;
    kept->chosen[k] = kind == 1;
    copy(u, kept->u[k]);
}

/* Whether a row of joint values stands before another. */
static int stands_before(const double a[6], const double b[6])
{
    for (int i = 0; i < 6; i++)
        if (fabs(a[i] - b[i]) > 1e-09)
            return a[i] < b[i];
    return 0;
}

/* Rows by the first joint, then by the second and so on. */
static void sorted_rows(
    struct descent *d, const struct kept *kept, double q[16][6], int found[16],
    int chosen[16])
{
    for (int row = 0; row < 16; row++)
        found[row] = chosen[row] = 0;
    for (int k = 0; k < kept->count; k++) {
        int row = k;
        for (int j = 0; j < 6; j++)
            d->q[solved[j]] = unit[j] * kept->u[k][j];
        for (; row > 0 && stands_before(d->q, q[row - 1]); row--) {
            chosen[row] = chosen[row - 1];
            for (int i = 0; i < 6; i++)
                q[row][i] = q[row - 1][i];
        }
        found[k] = 1;
        chosen[row] = kept->chosen[k];
        for (int i = 0; i < 6; i++)
            q[row][i] = d->q[i];
    }
}

/* The monomials of the left side of the formulation that has the joints 4, 3, 2, 1, 0, 5. */
DHGEN_TABLE double kinova_jaco2_left_0[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { -0.19864864864864867, 0.0, -0.19864864864864867, 1.3621621621621622, 0.0, 1.3621621621621622,
        0.19864864864864867, 0.0, 0.19864864864864867, -0.035526561043802474, 0.0,
        -0.035526561043802474, -0.6051444547996274, 0.0, -0.6051444547996274, 0.035526561043802474,
        0.0, 0.035526561043802474, 0.5552376514445481, 0.0, 0.5552376514445481, 0.2001118359739049,
        0.0, 0.2001118359739049, -0.5552376514445481, 0.0, -0.5552376514445481 },
    { -0.06810810810810812, 0.0, -0.06810810810810812, 0.4670270270270271, 0.0, 0.4670270270270271,
        0.06810810810810812, 0.0, 0.06810810810810812, -0.8192544268406339, 0.0,
        -0.8192544268406339, 0.11914259086672882, 0.0, 0.11914259086672882, 0.8192544268406339, 0.0,
        0.8192544268406339, -0.4424603914259087, 0.0, -0.4424603914259087, -1.059981360671016, 0.0,
        -1.059981360671016, 0.4424603914259087, 0.0, 0.4424603914259087 },
    { -0.12124355652982145, 0.0, -0.12124355652982145, 0.8313843876330613, 0.0, 0.8313843876330613,
        0.12124355652982145, 0.0, 0.12124355652982145, 0.5184207244723399, 0.0, 0.5184207244723399,
        0.9245567759022836, 0.0, 0.9245567759022836, -0.5184207244723399, 0.0, -0.5184207244723399,
        -0.6611656013719819, 0.0, -0.6611656013719819, 0.26757198682443356, 0.0,
        0.26757198682443356, 0.6611656013719819, 0.0, 0.6611656013719819 },
    { 0.5175803960627718, 1.7651910441527094, 0.42660013165755706, -0.2320377962461728,
        0.7796287406113428, 0.18376419874654337, 1.2233439164149225, -0.9078217808004659,
        -0.2932431879653189, 0.9653940397493814, -0.085238147738441, -0.3047246776281696,
        -0.026458419934057398, 0.139429733014799, 0.04790410434050191, 0.6474700480943608,
        1.1022554808183436, 0.010681265947094717, 0.1086008808269921, 0.30404190861962566,
        0.011381245790531347, 0.5775527734156825, -2.1791199380437236, -0.5846445268743033,
        0.2329940879439003, -0.08864371930453002, -0.07365788198544343 },
    { 0.1774561357929504, 0.6052083579952147, 0.146262902282591, -0.07955581585583067,
        0.2673012824953176, 0.06300486814167201, 0.41943219991368774, -0.3112531819887312,
        -0.10054052158810935, -0.8405028882779149, -0.4025911602721262, 0.19588630918213146,
        -0.8595235338674214, 3.2152964612798822, 0.855301245481849, -0.80719049049933,
        -0.6363883411300995, 0.1045068771697972, 1.39167782953459, -0.3422958652796111,
        -0.47122517326040964, -0.4442863122061126, 1.736507346435097, 0.4818509392259391,
        0.821321732855661, 1.7377382525287794, 0.06777025955846974 },
    { 0.20105596557916958, 1.0773697259134083, 0.14552691513985866, -0.14162234607488944,
        0.4758399411604951, 0.1121589558773746, 0.6318128816649606, -0.5540815009225748,
        -0.293823489753541, -1.1095778091644475, 0.3658104925174216, 0.3892305772674087,
        0.5261842604863943, -2.0346259553069435, -0.5589495823439754, -0.6073958485830274,
        -1.4484757856019044, -0.07620681048147841, -0.9597042978140802, -0.30586689753942514,
        0.24606162010858593, -0.6967015831380801, 2.5948513047520585, 0.6872191127296845,
        -0.8431180428207684, -0.8309316601992817, 0.08261333501664087 },
    { 3.209397319591355, 2.1756665104175843, 0.5072876095050051, -0.09928613359271617,
        0.3335935978763443, 0.07863045194133403, 3.5113848935993763, 1.0319170319844044,
        0.1992754616819972, 0.254858793933468, -0.08402296816065889, -0.08940232461849582,
        -0.12085919969444998, 0.4673329916950478, 0.1283850625429088, 0.13951267962598848,
        0.3327002295028977, 0.01750393316125475, 0.22043436508328054, 0.07025453101821755,
        -0.05651786401659659, 0.16002530308696286, -0.5960110850304353, -0.157847275595936,
        0.19365568215414894, 0.19085659339113314, -0.018975447013506536 },
    { -0.060219138230214804, 0.0, -0.060219138230214804, 0.2914262602802285, 0.0,
        0.2914262602802285, 0.024780187684851913, 0.0, 0.024780187684851913, -0.05953799701916784,
        0.0, -0.05953799701916784, -0.10618066749501362, 0.0, -0.10618066749501362,
        0.05953799701916784, 0.0, 0.05953799701916784, 0.07593152384817832, 0.0,
        0.07593152384817832, -0.030729288784086643, 0.0, -0.030729288784086643,
        -0.07593152384817832, 0.0, -0.07593152384817832 },
    { -1.3525825199363661, 0.09098026440521478, 0.41260852421634303, -0.605775003044472,
        -0.4158019949927162, 0.17385373756687084, 0.9238978882602443, 1.5165871043802412,
        0.016076107459778617, 0.28304724239076756, 1.270118717377551, 0.19780909465232657,
        -0.05768322246924412, -0.07436252427455936, 0.0817465105455549, -0.7915559089307188,
        0.6367887821472661, 0.3106995718876247, -0.2624642051738343, 0.09721963503646058,
        0.041577703445791335, 1.8621780479371692, 1.162197300289986, -0.3169418901065545,
        0.15476511051628647, 0.3066519699293436, 0.06612139121175645 },
    { -0.438247001574311, 0.03119323351035936, 0.1669613564209036, -0.3825210983438371,
        -0.1425606839975027, -0.11521981584851954, 0.2912694135710692, 0.5199727215017971,
        -0.019983768417661876, 0.06199670825904066, -1.036389197460046, -0.34059445201308547,
        -2.8966479529697597, -1.7148247793492706, 0.3186485083101221, 0.4574930424420721,
        -0.9116973676691271, -0.1788952986880273, 0.6576513148550879, 1.8629030027949995,
        0.3153554495754769, -1.519444382248331, -0.9261372514320517, 0.21706296418676624,
        -1.3553725084796724, 0.7535514732971913, 0.3823657440491072 },
    { -0.8207635178781412, 0.055529050439310904, 0.25660620803526707, -0.4024658526177524,
        -0.25378130195226406, 0.07337408854274265, 0.5591194053827243, 0.9256363714185017,
        0.005037904460149623, -0.6504415490473767, -1.4988083864318562, -0.2846310565299552,
        1.7831492974693661, 1.0851338428303698, -0.2514766578375779, 1.1917741955896182,
        -0.5311890381015492, -0.2567015900122862, -0.05848083304908326, -1.2057659179226659,
        -0.36434773058850833, -2.4098609641759925, -1.3839206958677646, 0.18499034057606595,
        0.6268801119184366, -0.9257313778374092, -0.20405154828084499 },
    { -0.46930495126029614, -0.2267614152879361, -0.08250225026331298, 4.113752507916471,
        1.995138519413756, 0.43940816606964306, 0.5647607464372602, 0.1305484400965642,
        0.053469015831855905, 0.013255589609130997, 0.1393230426350107, 0.013834786511179534,
        -2.051039197093711, -1.0015645929346333, -0.161205424121958, -0.02529831647425586,
        0.15622250000057636, 0.04494556107467614, 1.6726676080777225, 0.962606987637144,
        0.2294783197056835, 0.9288984168129023, 0.38512349793806305, 0.020806573561205105,
        -1.7369502010067823, -0.6685171513564095, -0.15529697820205024 },
    { -0.5060913805254129, -0.054393032340861736, 0.07963385970885398, 1.2411651948339288,
        0.5773152118023418, 0.18151301798018263, 0.42877995509107064, 0.4340524514529858,
        0.02045101512394784, -2.7267688653116617, -1.7531233732222598, -0.36849998663782335,
        1.0055552805472177, 0.697094407541998, -0.02707502001974871, 2.8762799206566294,
        0.9366646068942608, 0.1712420264037373, -1.2943823122720848, -1.1005654687955468,
        -0.2995708272724161, -4.107585588789992, -1.9751119326798032, -0.2560418865661934,
        1.5898294954061643, 0.33619047847509276, 0.06825200745282795 },
    { -0.3649039113780892, -0.13402899264619741, -0.043978343121850304, 2.546037901589445,
        1.1977307772754189, 0.34090506497406164, 0.39441990926634735, 0.15257377817261833,
        0.038722868148069294, 1.5232233969769124, 1.3104443083207689, 0.33803488778560215,
        3.878262710505427, 1.885144927432027, 0.16996307583839707, -1.848590667658864,
        -0.3568646070845167, -0.06242212785760466, -2.294787458484115, -1.6474444979870524,
        -0.3210136139921397, 1.5975733921299862, 0.9770036412270335, -0.012840974830493176,
        2.482820684938327, 0.66244495677164, 0.08073815124627656 },
};

/* The monomials of the left side of the formulation that has the joints 1, 2, 3, 4, 5, 0. */
DHGEN_TABLE double kinova_jaco2_left_1[15][32] DHGEN_ALIGNED = {
    { 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.8751337795442238, -0.48277977260743377,
        -0.7801111551098345, 0.8374744602688303, 0.09216704749778276, 1.1534757659755142,
        -0.8751337795442238, 0.48277977260743377, 0.7801111551098345, 0.41873723013441516,
        0.04608352374889138, 0.5767378829877571, -1.7502675590884476, 0.9655595452148675,
        1.560222310219669, -0.41873723013441516, -0.04608352374889138, -0.5767378829877571 },
    { 0.24248711305964285, 1.6627687752661222, -0.24248711305964285, 0.0, 0.0, 0.0,
        0.24248711305964285, 1.6627687752661222, -0.24248711305964285, -0.0, 0.0, 0.0, 0.0, -0.0,
        -0.0, 0.0, 0.0, 0.0, 0.0, -0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.41873723013441516, -0.04608352374889138,
        -0.5767378829877571, 1.7502675590884476, -0.9655595452148675, -1.560222310219669,
        0.41873723013441516, 0.04608352374889138, 0.5767378829877571, 0.8751337795442238,
        -0.48277977260743377, -0.7801111551098345, 0.8374744602688303, 0.09216704749778276,
        1.1534757659755142, -0.8751337795442238, 0.48277977260743377, 0.7801111551098345 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3605835738732836, 0.0014474924109784866,
        0.36554640499663843, -1.3535215582298836, -0.0002763394602777109, -1.3544690078079786,
        0.4947914092848092, -0.0014474924109784866, 0.48982857816145436, -1.703210758904653,
        -0.00013816973013885546, -1.7036844836937006, 0.1342078354115256, -0.002894984821956973,
        0.12428217316481593, -0.3496892006747696, 0.00013816973013885546, -0.349215475885722 },
    { -0.027306248852271432, -0.004985389446642787, -0.025852176930333953, 0.0, 0.0, 0.0,
        -0.027306248852271432, -0.004985389446642787, -0.025852176930333953, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, -0.0, 0.0, -0.0, 0.0 },
    { 7.472013737079356e-10, 0.0, 7.472013737079356e-10, 0.0, 0.0, 0.0, 7.472013737079356e-10, 0.0,
        7.472013737079356e-10, 1.703210758904653, 0.00013816973013885546, 1.7036844836937006,
        -0.1342078354115256, 0.002894984821956973, -0.12428217316481593, 0.3496892006747696,
        -0.00013816973013885546, 0.349215475885722, 0.3605835738732836, 0.0014474924109784866,
        0.36554640499663843, -1.3535215582298836, -0.0002763394602777109, -1.3544690078079786,
        0.4947914092848092, -0.0014474924109784866, 0.48982857816145436 },
    { 3.031693034222176, 0.001786812884976091, 3.036833329236675, -1.4332837399665646,
        0.005706740362797548, -1.4137177730084016, 0.3678467069969891, -0.0012567819751826013,
        0.3625518196338005, 2.5452828375353843e-09, 2.064812243292151e-13, 2.545990773161656e-09,
        -2.005605579637209e-10, 4.326273271659747e-12, -1.8572762103231599e-10,
        5.225765022300356e-10, -2.064812243292151e-13, 5.218685666037638e-10, 5.388570834692688e-10,
        2.1631366358298736e-12, 5.462735519349712e-10, -2.022706335305349e-09,
        -4.129624486584302e-13, -2.0241222065578926e-09, 7.394176414329896e-10,
        -2.1631366358298736e-12, 7.320011729672872e-10 },
    { -0.4042603031262545, -0.29797638721907294, -1.261477390902626, 2.1547394518268157,
        -0.95167988232099, -1.1081630018451492, -0.29320220224763277, 0.2095862166854551,
        0.5897953519343772, -3.12881033579091e-10, -3.443367225047391e-11, -4.3093933843785873e-10,
        1.3078023245073233e-09, -7.214674185813585e-10, -1.1658002534859055e-09,
        3.12881033579091e-10, 3.443367225047391e-11, 4.3093933843785873e-10, 6.539011622536616e-10,
        -3.6073370929067927e-10, -5.829001267429527e-10, 6.25762067158182e-10,
        6.886734450094783e-11, 8.618786768757175e-10, -6.539011622536616e-10,
        3.6073370929067927e-10, 5.829001267429527e-10 },
    { -1.8118670398463663e-10, -1.2424231130375083e-09, 1.8118670398463663e-10, 0.0, 0.0, 0.0,
        -1.8118670398463663e-10, -1.2424231130375083e-09, 1.8118670398463663e-10,
        -0.4015725168491515, -2.828733235647441, 0.4280314618088194, -0.015249570967602339,
        0.2400946454119543, 0.010198317838938454, -0.09622926774952022, -0.5847647158863076,
        0.06977032278985235, -0.11133349060852446, -0.5910980838635538, 0.1088078640441925,
        0.30534324909963134, 2.2439685197611334, -0.35826113901896706, -0.09608391964092211,
        -0.8311927292755081, 0.09860954620525406 },
    { 1.6415270357562814, -0.8049317052355047, -1.1182388107654484, 0.11105810087862175,
        0.507562603904528, 1.8512727428370033, -0.5132124160705341, 0.14674817708548527,
        -0.010075808920299134, 6.539011622536616e-10, -3.6073370929067927e-10,
        -5.829001267429527e-10, 6.25762067158182e-10, 6.886734450094783e-11, 8.618786768757175e-10,
        -6.539011622536616e-10, 3.6073370929067927e-10, 5.829001267429527e-10, 3.12881033579091e-10,
        3.443367225047391e-11, 4.3093933843785873e-10, -1.3078023245073233e-09,
        7.214674185813585e-10, 1.1658002534859055e-09, -3.12881033579091e-10,
        -3.443367225047391e-11, -4.3093933843785873e-10 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.11133349060852446, 0.5910980838635538,
        -0.1088078640441925, -0.30534324909963134, -2.2439685197611334, 0.35826113901896706,
        0.09608391964092211, 0.8311927292755081, -0.09860954620525406, -0.4015725168491515,
        -2.828733235647441, 0.4280314618088194, -0.015249570967602339, 0.2400946454119543,
        0.010198317838938454, -0.09622926774952022, -0.5847647158863076, 0.06977032278985235 },
    { 2.453102512191618e-09, -1.2028921517860805e-09, -1.6710991510749426e-09,
        1.6596553107580131e-10, 7.585029497604803e-10, 2.7665470731117332e-09,
        -7.669460445837435e-10, 2.1930087901481998e-10, -1.505731653293237e-11, 2.944676233209473,
        -1.2460152646556801, -1.4468105058888785, -1.3636269044270435, 0.8510971396218721,
        1.9986765983755308, -0.031767217276139674, -0.029562933047802453, -0.2949665184868047,
        -0.10759825159739118, -0.874685587275956, -2.546862089531812, 1.5420174042424661,
        -0.3030949065749194, 0.46042859693199367, -0.35909039868209847, 0.1302356854540166,
        0.2028339600729437 },
    { 0.7130688266750441, 5.021133767733684, -0.8016168202563666, -0.2298771329330401,
        -2.4123248226594063, 0.2855114894752131, 0.07318558143098042, 0.6198618374941549,
        -0.05741915649572844, 6.001110724660782e-10, 4.227266719058123e-09, -6.396513925075313e-10,
        2.278900075089824e-11, -3.587980977434639e-10, -1.5240394197529915e-11,
        1.438052821067005e-10, 8.738739980123596e-10, -1.0426496206524751e-10,
        1.6637707424477805e-10, 8.833386005179517e-10, -1.6260277096809388e-10,
        -4.5630579035937783e-10, -3.3533927210457634e-09, 5.353864304422837e-10,
        1.435880734938798e-10, 1.2421366982614159e-09, -1.4736237677056395e-10 },
    { 6.041277076630476e-10, 4.4529673172523806e-10, 1.8851552787678895e-09,
        -3.2200485567753618e-09, 1.4221930308009003e-09, 1.65604183454201e-09,
        4.3816217658724636e-10, -3.132062180352422e-10, -8.81391794343844e-10, 0.10759825159739118,
        0.874685587275956, 2.546862089531812, -1.5420174042424661, 0.3030949065749194,
        -0.46042859693199367, 0.35909039868209847, -0.1302356854540166, -0.2028339600729437,
        2.944676233209473, -1.2460152646556801, -1.4468105058888785, -1.3636269044270435,
        0.8510971396218721, 1.9986765983755308, -0.031767217276139674, -0.029562933047802453,
        -0.2949665184868047 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation kinova_jaco2_formulations[2] = {
    { { 4, 3, 2, 1, 0, 5 }, -1.0, kinova_jaco2_left_0 },
    { { 1, 2, 3, 4, 5, 0 }, 1.0, kinova_jaco2_left_1 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double kinova_jaco2_constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, -0.008859737618621246,
        0.9230769230769231, 0.38461538461538464, 0.0, 7.472013737079356e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 1.1119874781055206, -0.8823529411764706,
        -0.47058823529411764, 0.0, 0.0, 0.0, 0.0, -1.0, 0.008859737627480985 },
    { 0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.3400374515881446, 0.96, 0.28, 0.0,
        -0.00885973764520046 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.36206896551724144, 0.34482758620689663,
        -0.8660254037844387, 0.0025965570034597847, 0.627121844119766, 0.597258899161682,
        0.5000000000000001, -0.34003745192818213 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.4729729729729731, 0.1621621621621622,
        -0.8660254037844387, -0.09945863557349463, 0.8192132197960906, 0.28087310393008824,
        0.5000000000000001, -0.1722674102944599 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.2754999997245 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, -0.25394150957778494 },
};

DHGEN_TABLE dhgen_general_arm kinova_jaco2_general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.3687091878934751, 2.7121645807451724, /* the length that is one in the loop, and its inverse
        */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, kinova_jaco2_formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    kinova_jaco2_constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};

/* A solution that is exact and unlike all others needs no descent. */
static void add_regular(struct kept *kept, double u[6])
{
    wrap_angles(u);
    kept->singular[kept->count] = kept->chosen[kept->count] = 0;
    copy(u, kept->u[kept->count++]);
}

/* All solutions. Where it is not certain that these are all, the seed and evenly spread starts are
 * followed too; singular solutions out of a continuum go to the seed. */
static void all_joints(
    const double T[16], const double seed[6], double q[16][6],
    int found[16], int chosen[16])
{
    static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
    static const double zero[6] = {
        0.0, -1.5707963267948966, 1.5707963267948966, 0.0, 3.141592653589793, 1.7453292519943295,
    };
    struct descent d = { .T = T };
    struct kept kept = { .count = 0 };
    double angles[16][6], residual[16], u[6];
    const int count = dhgen_general_solutions(&kinova_jaco2_general, T, 0, angles, residual);
    for (int j = 0; j < 6; j++)
        u[j] = d.seed[j] = seed[solved[j]] / unit[j];
    if (count < 0 && descend(&d, u) <= 1e-10)
        keep(&d, &kept, u);
    const int many = count < 0 ? -1 - count : count;
    for (int k = 0; k < many; k++) {
        for (int j = 0; j < 6; j++)
            u[j] = facing[j] * (angles[k][j] - zero[j]) / unit[j];
        if (count < 0) {
            (void)descend(&d, u); /* where solutions meet it is exact that tells them apart */
            keep(&d, &kept, u);
        } else {
            add_regular(&kept, u);
        }
    }
    for (int k = 1; count < 0 && k < 12; k++) {
        start_of(&d, k, u);
        if (descend(&d, u) <= 1e-10)
            keep(&d, &kept, u);
    }
    sorted_rows(&d, &kept, q, found, chosen);
}

static const double
    D1 = 0.2755, /* joint offset 1 [m] */
    D2 = 0.41, /* link length 2 [m] */
    e2 = 0.0098, /* joint offset 3 [m] */
    d5 = -0.08579425000157839, /* joint offset 5 [m] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    offset6 = 1.7453292519943295, /* offset of joint 6 [rad] */
    f1 = 0.2501971250007892, /* D3 + d4 [m] */
    f2 = 0.5, /* 1 / 2 */
    f3 = 0.8660254037844386, /* 1 / 2 * sqrt3 */
    f4 = 0.2115971250007892, /* D6 + d6 [m] */
    g1 = 0.2501971250007892, /* D3 + d4 [m] */
    g4 = 0.2115971250007892; /* D6 + d6 [m] */

const char *const kinova_jaco2_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const double lowest[6] = {
    -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
};
static const double highest[6] = { INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY };
#define slack(joint) 1e-09 /* of limits */

void kinova_jaco2_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, v2 = q[2] + offset3;
    const double c3 = cos(v2), s3 = sin(v2), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = s2 * c3 - c2 * s3, z3_z = c2 * c3 + s2 * s3,
        z3_x = x2_x * s3 - y2_x * c3, z3_y = x2_y * s3 - y2_y * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, v3 = s1 * c4 + x3_x * s4,
        v4 = c1 * c4 - x3_y * s4, v5 = x3_z * s4, y4_x = z3_x * f3 - v3 * f2,
        y4_y = v4 * f2 + z3_y * f3, y4_z = z3_z * f3 - v5 * f2, z4_x = v3 * f3 + z3_x * f2,
        z4_y = z3_y * f2 - v4 * f3, z4_z = v5 * f3 + z3_z * f2, v6 = q[4] + offset5;
    const double c5 = cos(v6), s5 = sin(v6), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v7 = y4_x * c5 - x4_x * s5,
        v8 = y4_y * c5 - x4_y * s5, v9 = y4_z * c5 - x4_z * s5, y5_x = f2 * v7 + f3 * z4_x,
        y5_y = f2 * v8 + f3 * z4_y, y5_z = f2 * v9 + f3 * z4_z, z5_x = f2 * z4_x - f3 * v7,
        z5_y = f2 * z4_y - f3 * v8, z5_z = f2 * z4_z - f3 * v9, v10 = q[5] + offset6;
    const double c6 = cos(v10), s6 = sin(v10);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = x5_x * s6 - y5_x * c6; T[2] = -z5_x;
    T[3] = x2_x * D2 + s1 * e2 - z3_x * f1 + z4_x * d5 - z5_x * f4;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = x5_y * s6 - y5_y * c6; T[6] = -z5_y;
    T[7] = x2_y * D2 - c1 * e2 - z3_y * f1 + z4_y * d5 - z5_y * f4;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = x5_z * s6 - y5_z * c6; T[10] = -z5_z;
    T[11] = D1 + s2 * D2 - z3_z * f1 + z4_z * d5 - z5_z * f4;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kinova_jaco2_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, p2_x = x2_x * D2, p2_y = x2_y * D2, p2_z = D1 + s2 * D2,
        v2 = q[2] + offset3;
    const double c3 = cos(v2), s3 = sin(v2), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = s2 * c3 - c2 * s3, z3_z = c2 * c3 + s2 * s3,
        p3_x = p2_x + s1 * e2, p3_y = p2_y - c1 * e2, z3_x = x2_x * s3 - y2_x * c3,
        z3_y = x2_y * s3 - y2_y * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), v3 = s1 * c4 + x3_x * s4, v4 = c1 * c4 - x3_y * s4,
        v5 = x3_z * s4, p4_x = p3_x - z3_x * g1, p4_y = p3_y - z3_y * g1, p4_z = p2_z - z3_z * g1,
        z4_x = v3 * f3 + z3_x * f2, z4_y = z3_y * f2 - v4 * f3, z4_z = v5 * f3 + z3_z * f2,
        v6 = q[4] + offset5;
    const double c5 = cos(v6), s5 = sin(v6), p5_x = p4_x + z4_x * d5, p5_y = p4_y + z4_y * d5,
        p5_z = p4_z + z4_z * d5,
        z5_x = f2 * z4_x - f3 * ((z3_x * f3 - v3 * f2) * c5 - (x3_x * c4 - s1 * s4) * s5),
        z5_y = f2 * z4_y - f3 * ((v4 * f2 + z3_y * f3) * c5 - (x3_y * c4 + c1 * s4) * s5),
        z5_z = f2 * z4_z - f3 * ((z3_z * f3 - v5 * f2) * c5 - x3_z * c4 * s5),
        p6_x = p5_x - z5_x * g4, p6_y = p5_y - z5_y * g4, p6_z = p5_z - z5_z * g4, v7 = p6_z - D1,
        v8 = p6_z - p2_z, v9 = p6_x - p3_x, v10 = p6_y - p3_y, v11 = p6_x - p4_x, v12 = p6_y - p4_y,
        v13 = p6_z - p4_z, v14 = p6_x - p5_x, v15 = p6_y - p5_y, v16 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(c1 * v7); J[2] = c1 * v8; J[3] = z3_y * v8 - z3_z * v10;
    J[4] = z4_y * v13 - z4_z * v12; J[5] = z5_y * v16 - z5_z * v15;
    J[6] = p6_x; J[7] = -(s1 * v7); J[8] = s1 * v8; J[9] = z3_z * v9 - z3_x * v8;
    J[10] = z4_z * v11 - z4_x * v13; J[11] = z5_z * v14 - z5_x * v16;
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x));
    J[15] = z3_x * v10 - z3_y * v9; J[16] = z4_x * v12 - z4_y * v11;
    J[17] = z5_x * v15 - z5_y * v14;
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

int kinova_jaco2_ik(
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

int kinova_jaco2_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    double all[16][6], found[6], least = HUGE_VAL;
    unsigned char status[16];
    int result = -NONE;
    int valid = kinova_jaco2_ik(T, q_seed, all, status) >= 0;
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

void kinova_jaco2_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)kinova_jaco2_ik(T + 16 * k, NULL, (double (*)[6])(q + 96 * k), status + 16 * k);
}
