# SPDX-License-Identifier: MIT
"""The places of an arm's and its task's numbers in the array that every function gets first.

0 ... LOOP        sizes, the task, where the lists begin
LOOP ... JOINTS   the general algorithm's numbers of its loop (general/places.py)
JOINTS ...        a record for each joint that is solved for, then the lists
"""

# Sizes
DOF = 0  # joints of the arm
SOLVED = 1  # joints that are solved for
EQUATIONS = 2  # numbers that measure the miss of a pose
ROWS = 3  # solutions that are kept
GIVEN = 4  # joints whose values the caller gives
SIZE = 5  # of the arm: a step of one, for lengths [file's unit]
RESIDUAL = 6  # what counts as a solution [arm sizes, rad]
# The task
COORDINATES = 7  # coordinates of the tool's origin that count
COORDINATE = 8  # which rows of the translation they are: three places
DIRECTIONS = 11  # what of the tool's directions counts: the place of its name in NAMES
REDUNDANT = 12  # whether every pose has infinitely many solutions
LIMITED = 13  # whether a joint that is solved for has limits
CHECKED = 14  # whether the task names more than the joints can choose
ARM_ANGLE = 15  # whether the caller gives it: the last equation
# Where the lists begin
FREE = 16  # places of the joints whose values the caller gives
CHAIN = 17  # the forward model
DRIVES = 18  # how drives hang together
LINKS = 19  # how many records CHAIN has: of joints and, without values of their own, passive rows

LOOP = 20
JOINTS = 100

# The record of a joint that is solved for, and the places of the first one's numbers. A value in
# units is a value in radians or arm sizes.
RECORD = 11
PLACE = JOINTS  # of the joint in the arm, from 0
TURNS = JOINTS + 1  # 1 where it turns, 0 where it slides
UNIT = JOINTS + 2  # 1 rad, or the arm's size
LOWEST = JOINTS + 3  # its limits, in units
HIGHEST = JOINTS + 4
SPAN_LOW = JOINTS + 5  # between which values starts lie, in units
SPAN_WIDTH = JOINTS + 6
STRIDE = JOINTS + 7  # from start to start, in parts of that: a direction that is like no other
MEASURE = JOINTS + 8  # what a unit moves, in arm sizes
FACING = JOINTS + 9  # the joint's sign in the loop of the general algorithm
ZERO = JOINTS + 10  # and what is added to its value there

# The forward model: a rigid transform (twelve numbers), then a record a joint or passive row
BASE = 12
CHAIN_RECORD = 15
JOINT_TURNS = 0  # 1 where it turns, 0 where it slides
JOINT_SIGN = 1  # of its value; 0 for a passive row, which has none
JOINT_OFFSET = 2  # what is added to that
JOINT_AFTER = 3  # the rigid transform behind it
# Behind the records: how many shares there are of joints' values in others, and for each its record
SHARE_RECORD = 3
# The place of the record that is moved, the joint whose value moves it, and the factor.
SHARE_OF, SHARE_FROM, SHARE_FACTOR = 0, 1, 2

# How drives hang together: how many turn, each before those that its turns move, or none where
# turns are each drive's own; for each its place among the joints that are solved for and what a
# turn moves, in units; whether a drive moves more than its own joint, and if so what each that is
# solved for has of every joint's angle or length.
