/* SPDX-License-Identifier: MIT
 *
 * Joint values and their limits. */
#ifndef DHGEN_LIMITS_H
#define DHGEN_LIMITS_H

#include "arm.h"
#include "tolerances.h"

/* Ranges at least this wide leave next to no gap [rad]: near a singular pose rounding crosses
 * it. */
#define DHGEN_NEARLY_A_TURN 6.183185307179587

/* How far a joint value is beyond its limits, whole turns aside; negative below [rad or length]. */
DHGEN_SMALL double dhgen_overshoot(const struct dhgen_arm *arm, int joint, double value)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const double low = of->lowest, high = of->highest;
    if (low <= value && value <= high)
        return 0.0;
    double off = value > high ? value - high : value - low;
    if (of->revolute) {
        const double gap = DHGEN_TURN - (high - low), over = value - high;
        const double rest = over - DHGEN_TURN * floor(over / DHGEN_TURN);
        off = rest >= gap ? 0.0 : rest <= gap - rest ? rest : rest - gap;
    }
    return fabs(off) <= 0.5 * of->slack ? 0.0 : off;
}

/* How far the joint values of a row are beyond their limits, whole turns aside [rad, arm sizes]. */
DHGEN_FN double dhgen_beyond_limits(const struct dhgen_arm *arm, const double *q)
{
    if (arm->beyond)
        return arm->beyond(arm, q);
    double sum = 0.0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        sum += fabs(dhgen_overshoot(arm, i, q[i])) * sqrt(arm->joints[i].weight);
    return sum;
}

/* How far a joint value is past an end of its range: where that is nearly a turn, the value itself:
 * turned it would be across the gap. */
DHGEN_SMALL double dhgen_past_an_end(const struct dhgen_arm *arm, int joint, double value)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const double low = of->lowest, high = of->highest;
    if (!arm->range_exceeds_a_turn || high - low < DHGEN_NEARLY_A_TURN)
        return dhgen_overshoot(arm, joint, value);
    const double off = value - fmin(fmax(value, low), high);
    return fabs(off) <= 0.5 * of->slack ? 0.0 : off;
}

/* How far the joint values of a row are past the ends of their ranges [rad, arm sizes]. */
DHGEN_FN double dhgen_past_ends(const struct dhgen_arm *arm, const double *q)
{
    double sum = 0.0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        sum += fabs(dhgen_past_an_end(arm, i, q[i])) * sqrt(arm->joints[i].weight);
    return sum;
}

/* A joint value moved by whole turns near to another, but inside its limits if it can be. */
DHGEN_SMALL double dhgen_turned(
    const struct dhgen_arm *arm, int joint, double given, double towards)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const double low = of->lowest - DHGEN_LIMIT, high = of->highest + DHGEN_LIMIT;
    if (!of->revolute)
        return given;
    double value = given;
    if (fabs(towards) < DHGEN_FAR_ANGLE)
        value += DHGEN_TURN * floor((towards - given) / DHGEN_TURN + 0.5);
    value -= DHGEN_TURN * ceil(fmax(value - high, 0.0) / DHGEN_TURN);
    value += DHGEN_TURN * ceil(fmax(low - value, 0.0) / DHGEN_TURN);
    return value <= high ? value : given;
}

/* A joint value turned inside its limits, or next to the end that it and the seed are at. */
DHGEN_SMALL double dhgen_at_an_end(
    const struct dhgen_arm *arm, int joint, double value, double seed)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    const double near = value + DHGEN_TURN * floor((seed - value) / DHGEN_TURN + 0.5);
    if (!of->revolute || !(fabs(near - value) > 0.0 || value < of->lowest || of->highest < value))
        return value;
    const double past = fabs(dhgen_past_an_end(arm, joint, near));
    if (0.0 < past && past < DHGEN_DOUBTFUL && fabs(near - seed) < DHGEN_BESIDE_SEED)
        return near;
    const double off = dhgen_overshoot(arm, joint, value);
    if (off == 0.0 || fabs(off) > DHGEN_DOUBTFUL)
        return dhgen_turned(arm, joint, value, value);
    return off + (off > 0.0 ? of->highest : of->lowest);
}

/* Whether a joint value is inside its limits, but for rounding. */
DHGEN_FN int dhgen_inside(const struct dhgen_arm *arm, int joint, double value)
{
    const struct dhgen_joint *const of = arm->joints + joint;
    return of->lowest - of->slack <= value && value <= of->highest + of->slack;
}

#endif
