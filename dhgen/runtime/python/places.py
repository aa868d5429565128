# SPDX-License-Identifier: MIT
"""The places of an arm's numbers in the array that the runtime around closed forms gets.

0 ... JOINTS      the arm's own: sizes, steps, lists of places
JOINTS ...        a record for each joint, then the numbers that descents work on, the coupling,
                  and the numbers of a table that comes at run time
"""

from __future__ import annotations

DOF, ROWS = 0, 1  # joints; branches
DIRECTIONS = 2  # what of the tool's directions counts: the place of its name in NAMES
CUTS = 3  # of an interval by golden section
PER_LENGTH = 4  # what a length counts where it is asked whether a row fits: 1 / size of the arm
MISS_WEIGHTS = 5  # six: what the entries of a miss count in refining, lengths in arm sizes
CLAMPED = 11  # a joint is clamped to a limit if the pose is missed by so much more at most
CLAMPED_AGAIN = 12  # and where no row is inside limits then

# Of the tool's directions: none, its z axis, all, or of the angles yaw, pitch, roll and pitch.
NAMES = ("none", "pointing", "rotation", "yaw", "pitch", "tilt")
_, POINTING, ROTATION, YAW, PITCH, TILT = map(float, range(6))

# Whether a step is taken around the formulas, each under its name in `arm.STEPS`.
RETRIES, CHECKS, KEEPS_LIMITS = range(13, 16)
COMPLETES, ADDS_OTHERS, ASCENDS, EQUATIONS_END_ALL = range(16, 20)
MERGES, REFINES, CLAMPS, CLAMPS_FAR, RANGE_EXCEEDS_A_TURN, FOLLOWS_SEED = range(20, 26)

DESCENTS = 26  # where the numbers of the arm begin that descents work on (numerical/places.py)
COUPLING = 27  # where those of coupled drives begin (coupled_turns.py); 0 where none are
# Where those of a table begin that comes at run time (calibration.py); 0 where none does.
CALIBRATION = 28

# Lists: how many there are, and from the next place on joints or entries of a pose, from 0.
MOST = 16
GIVEN_JOINTS = 29  # whose values the caller gives
CHOOSABLE = GIVEN_JOINTS + 1 + MOST  # that may be free, the last first
TOGETHER = CHOOSABLE + 1 + MOST  # that may have to be chosen together
ENTRIES = TOGETHER + 1 + MOST  # of a pose that count, in sixteen numbers
ROOT_TURNS = ENTRIES + 1 + MOST  # whose values add up to a root of a polynomial, each with its sign

# The record of a joint, and the places of the first one's numbers.
JOINTS = ROOT_TURNS + 1 + MOST
RECORD = 7
LOWEST, HIGHEST = JOINTS, JOINTS + 1  # the limits, with the slack for rounding [rad or length]
TURNS = JOINTS + 2  # 1 for a joint that turns, 0 for one that slides
WEIGHT = JOINTS + 3  # of squared differences: 1, for slides 1 / size^2 of the arm
SLACK = JOINTS + 4  # by what a value may miss its limits [rad or length]
PACE = JOINTS + 5  # what a step of one means in refining; 0 if the caller gives the value
FAN_STEP = JOINTS + 6  # from one value to the next where the joint is free [rad or length]
