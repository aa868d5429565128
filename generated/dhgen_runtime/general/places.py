# SPDX-License-Identifier: MIT
"""The places of the loop's numbers in an arm's array, behind the places of numerical/places.py."""

from ..numerical.places import JOINTS, LOOP

# How the arm is solved
MOST = LOOP  # solutions that it may have
CLOSED = LOOP + 1  # polynomials in closed form that are tried first
ELIMINATIONS = LOOP + 2  # formulations with a determinant that are tried after that
WAYS = LOOP + 3  # to solve at a root of a polynomial in closed form
PER_ROOT = LOOP + 4  # solutions at one of its simple roots; at a double one twice as many
HAS_WRIST = LOOP + 5  # whether this is that of an offset wrist, else of four turns
POINTING_LOOP = LOOP + 6  # whether the loop's last joint is the tool's turn about its own axis
SIZE_OF_LOOP = LOOP + 7  # the length that is one in the loop
PER_SIZE = LOOP + 8  # its inverse
REACH = LOOP + 9  # the square of what is out of reach for all links in line [arm sizes]
# What slides
SLIDES = LOOP + 10  # of each of the six joints, whether it does
ANY_SLIDE = LOOP + 16  # whether one of them does
HIDDEN_SLIDE = LOOP + 17  # whether it is hidden in the formulations
ORDER = LOOP + 18  # half the order of the determinant's zero where its length is infinite
LEFT_SLIDE = LOOP + 19  # whether it is a partner of the hidden joint
RIGHT_SLIDE = LOOP + 20  # whether it is on the right side
# Cosine and sine of what is added to each joint's angle in the loop
ADVANCE_C = LOOP + 21
ADVANCE_S = LOOP + 27
# The offset wrist; lengths in arm sizes
SHOULDER = LOOP + 33  # along axis 1 to S, where axes 1 and 2 meet
WRIST = LOOP + 34  # along axis 5 to W, where axes 4 and 5 meet
UPPER_SQUARE = LOOP + 35  # of the distance from S to the elbow
LOWER = LOOP + 36  # from the elbow to W
LOWER_SQUARE = LOOP + 37
BEND_C = LOOP + 38  # cosine and sine of the angle between the lower arm and axis 4
BEND_S = LOOP + 39
FLIP = LOOP + 40  # on which side axis 4 leaves the lower arm
BENT = LOOP + 41  # whether it leaves it at all
# What the turns of joints 1 ... 4 bring into line with axis 3, the elbow, W and axis 5: x and y
SOURCES = LOOP + 42
# Where the lists begin
FORMULATIONS = LOOP + 50
LINKS = LOOP + 51
GIVEN_VALUES = LOOP + 52
SPECIAL = LOOP + 53
LAST = LOOP + 54

if LAST > JOINTS:
    raise AssertionError

# The list of formulations: the joints phi_1 (hidden) ... phi_6 are, and the sign of phi = sign q
FORMULATION_RECORD = 7
FORMULATION_SIGN = 6
# The list of links K0 ... K4, L, R. Each: how many given joints are inside, a rigid transform
# (twelve numbers), then for each of those joints its record: which of the values it is, whether it
# slides, the factor of its angle (1 or -1) or length, and the rigid transform behind it.
LINK_COUNT = 7
LINK_RECORD = 13
INSIDE_RECORD = 15
# The list of values that the caller gives: sign and offset of each, then its shares of all values
GIVEN_RECORD = 2  # and as many more as values are given
# The list of values at which formulations vanish: how many, then for each: which of the given
# values, its kind, the sign of what is ahead there, how near is there, and bit i for formulation i.
SPECIAL_RECORD = 5
LENGTH, SINE_VANISHES, COSINE_VANISHES = 0.0, 1.0, 2.0
