/* planar_rrrr: Planar arm with four links, one joint too many twice over
 *
 * Inverse kinematics, generated from robots/planar_rrrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rrrr.yaml. The formulas and where they come from:
 * planar_rrrr.md.
 */
#include "planar_rrrr.h"

#define DHGEN_DOF 4
#define DHGEN_ROWS 1
#include "dhgen/numerical.h"

#include <math.h>

/* What rows hold. */
enum {
    OK = PLANAR_RRRR_OK, NONE = PLANAR_RRRR_UNREACHABLE, FREE = PLANAR_RRRR_FREE_JOINT,
    OUT = PLANAR_RRRR_OUT_OF_LIMITS, INVALID = PLANAR_RRRR_INVALID_POSE
};

static const double turn = 6.283185307179586;
#define half_turn (0.5 * turn)

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and the same over the arm's size. */
static const int solved[4] = { 0, 1, 2, 3 };
static const int turning[4] = { 1, 1, 1, 1 };
static const double unit[4] = { 1.0, 1.0, 1.0, 1.0 };
static const double measure[4] = { 1.0, 1.0, 1.0, 1.0 };
/* Rows of the translation that count. */
static const int coordinate[2] = { 0, 1 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[4] = {
    -2.0943951023931953, -2.0943951023931953, -2.0943951023931953, -2.0943951023931953,
};
static const double span_width[4] = {
    4.1887902047863905, 4.1887902047863905, 4.1887902047863905, 4.1887902047863905,
};
static const double stride[4] = {
    0.8566748838545029, 0.733891856627126, 0.6287067210378086, 0.53859725722361,
};
static const double least_u[4] = {
    -2.0943951023931953, -2.0943951023931953, -2.0943951023931953, -2.0943951023931953,
};
static const double most_u[4] = {
    2.0943951023931953, 2.0943951023931953, 2.0943951023931953, 2.0943951023931953,
};

static const struct dhgen_numerical_arm planar_rrrr_descents = {
    4, 1, /* joints; solutions that are kept */
    4, 2, /* joints that are solved for; equations */
    2, DHGEN_NO_DIRECTION, 0, /* coordinates, directions, arm angle */
    1, 1, 0, /* families of solutions, limits, more entries than joints */
    24, 1.0, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, 0, 0,
    0, 0,
    planar_rrrr_fk, planar_rrrr_jacobian, 0,
};

static void all_joints(
    const double T[16],
    const double seed[4], double q[1][4], int found[1],
    int chosen[1])
{
    dhgen_numerical_rows(&planar_rrrr_descents, T, 0, seed, q[0], found, chosen);
}

static const double
    a = 0.25; /* link length 1 [m] */

const char *const planar_rrrr_branches[1] = {
    "nearest",
};

static const double lowest[4] = {
    -2.0943951023931953, -2.0943951023931953, -2.0943951023931953, -2.0943951023931953,
};
static const double highest[4] = {
    2.0943951023931953, 2.0943951023931953, 2.0943951023931953, 2.0943951023931953,
};
#define slack(joint) 1e-09 /* of limits */

void planar_rrrr_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - x3_y * s4,
        x4_y = x3_y * c4 + x3_x * s4;
    T[0] = x4_x; T[1] = -x4_y; T[2] = 0.0; T[3] = c1 * a + a * x2_x + a * x3_x + a * x4_x;
    T[4] = x4_y; T[5] = x4_x; T[6] = 0.0; T[7] = s1 * a + a * x2_y + a * x3_y + a * x4_y;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void planar_rrrr_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a, p1_y = s1 * a;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2,
        p2_x = p1_x + a * x2_x, p2_y = p1_y + a * x2_y;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3, p3_x = p2_x + a * x3_x, p3_y = p2_y + a * x3_y;
    const double c4 = cos(q[3]), s4 = sin(q[3]), p4_x = p3_x + a * (x3_x * c4 - x3_y * s4),
        p4_y = p3_y + a * (x3_y * c4 + x3_x * s4);
    J[0] = -p4_y; J[1] = p1_y - p4_y; J[2] = p2_y - p4_y; J[3] = p3_y - p4_y;
    J[4] = p4_x; J[5] = p4_x - p1_x; J[6] = p4_x - p2_x; J[7] = p4_x - p3_x;
    J[8] = 0.0; J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 1.0; J[21] = 1.0; J[22] = 1.0; J[23] = 1.0;
}

/* Copies a pose. Returns 0 for what is no pose. */
static int read_pose(const double given[16], double T[16])
{
    for (int i = 0; i < 16; i++)
        T[i] = given[i];
    if (!(isfinite(T[3]) && isfinite(T[7])))
        return 0;
    return 1;
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
static double beyond_limits(const double values[4])
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += fabs(overshoot(i, values[i]));
    return sum;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double T[16], const double seed[4], double q[1][4], unsigned char status[1])
{

    /* all joints: damped least squares */
    double solution_roots[1][4];
    int solution_found[1], solution_chosen[1];
    all_joints(T, seed, solution_roots, solution_found, solution_chosen);

    for (int i1 = 0; i1 < 1; i1++) { /* nearest */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: damped least squares */
        if (!found) continue; /* out of reach */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
        status[row] = (chosen) ? FREE : OK;
    }
}

static void take(const double from[4], double to[4])
{
    for (int i = 0; i < 4; i++)
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
static double half_way(const double x[4], const double q[4], double half[4])
{
    double most = 0.0;
    for (int i = 0; i < 4; i++) {
        double off = q[i] - x[i];
        off -= turn * floor(off / turn + 0.5);
        most = fmax(most, fabs(off));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What the entries of a miss count: lengths in arm sizes. */
static const double weights[6] = { 1.0, 1.0, 0.0, 0.0, 0.0, 0.0 };
/* What a step of one means for joints; none if given. */
static const double pace[4] = { 1.0, 1.0, 1.0, 1.0 };

/* By how much joint values miss the pose, into e (0 half a turn away, too), and its length. */
static double off_pose(const double T[16], const double x[4], double e[6])
{
    double P[16], square = 0.0;
    planar_rrrr_fk(x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    return sqrt(square);
}

/* Adds the damped least-squares step for e: modified Gram-Schmidt, twice where singular. */
static void add_step(const int held[4], double damping, double e[6], double x[4])
{
    double A[6][10] = { { 0.0 } }, square[6] = { 0.0 }, J[24];
    planar_rrrr_jacobian(x, J);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 4; j++)
            A[i][j] = held[j] ? 0.0 : pace[j] * weights[i] * J[4 * i + j];
        A[i][4 + i] = sqrt(damping + 1e-26);
        for (int n = 0; n < 2 * i; n++) {
            const int k = n % i;
            double along = 0.0;
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

/* Takes joint values to some not farther than most that miss the pose by less than enough;
 * if that is NaN, to some inside their limits that miss it hardly more. Returns if it can.
 * Goes on while that gains, first by short steps. */
static int settle(const double T[16], double enough, double most, double q[4])
{
    double x[4], half[4], e[6], last = HUGE_VAL;
    const int stands = isnan(enough);
    int moves = 0, settled = 0, lost = 0, held[4] = { 0 };
    take(q, x);
    for (int k = 0; k < 20; k++) {
        double miss = off_pose(T, x, e), past = 0.0;
        int worst = 0;
        enough = isnan(enough) ? miss + 1e-14 : enough;
        for (int i = 0; i < 4 && stands && miss < enough; i++) {
            const double off = pace[i] > 0.0 ? overshoot(i, x[i]) : 0.0;
            worst = fabs(off) > fabs(past) ? i : worst;
            past = worst == i ? off : past;
        }
        /* one by one: others may follow it inside, or the first the second */
        if (fabs(past) > 0.0) {
            moves++;
            for (int i = 0; i < 4; i++)
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
    const double T[16], int row, int far, double rows[1][4], const unsigned char status[1])
{
    double x[4], half[4], to[4], *q = rows[row];
    const double beyond = beyond_limits(q);
    if (!(0.0 < beyond && (far || beyond < 0.01)))
        return 0;
    take(q, x);
    if (!settle(T, NAN, far ? HUGE_VAL : 1.5, x))
        return 0;
    const double off = half_way(q, x, half);
    for (int k = 0; k < 1; k++)
        if (status[k] != NONE && beyond_limits(rows[k]) < beyond
            && half_way(rows[k], x, to) < off)
            return 0;
    if (off >= 0.001 && !settle(T, 1e-12, 0.25 * off, half))
        return 0;
    take(x, q);
    return 1;
}

int planar_rrrr_ik(
    const double T[16], const double *q_seed, double q[1][4], unsigned char status[1])
{
    const double zeros[4] = { 0.0 }, *seed = q_seed ? q_seed : zeros;
    double pose[16];
    int count = 0;
    int valid = read_pose(T, pose);
    for (int i = 0; i < 4; i++)
        valid = isfinite(seed[i]) ? valid : 0;
    for (int row = 0; row < 1; row++) {
        status[row] = valid ? NONE : INVALID;
        for (int i = 0; i < 4; i++)
            q[row][i] = NAN;
    }
    if (!valid)
        return -INVALID;
    solve(pose, seed, q, status);
    for (int row = 0; row < 1; row++) {
        if (status[row] == NONE)
            continue;
        (void)stand(pose, row, 0, q, status);
        for (int i = 0; i < 4; i++) {
            double *value = &q[row][i];
            *value = turned(i, *value, 0.0);
            if (!(lowest[i] - slack(i) <= *value && *value <= highest[i] + slack(i)))
                status[row] = OUT;
        }
        count += status[row] != OUT;
    }
    return count;
}

int planar_rrrr_ik_nearest(const double T[16], const double q_seed[4], double q[4])
{
    double all[1][4], found[4], least = HUGE_VAL;
    unsigned char status[1];
    int result = -NONE;
    int valid = planar_rrrr_ik(T, q_seed, all, status) >= 0;
    for (int i = 0; i < 4; i++) {
        found[i] = NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    for (int row = 0; row < 1 && valid; row++) {
        double distance = 0.0;
        if (status[row] == OUT && result < 0)
            result = -OUT;
        if (status[row] != OK && status[row] != FREE)
            continue;
        for (int i = 0; i < 4; i++) {
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

void planar_rrrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
    size_t k = 0;
    for (; k < n; k++)
        (void)planar_rrrr_ik(T + 16 * k, NULL, (double (*)[4])(q + 4 * k), status + k);
}
