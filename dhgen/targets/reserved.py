"""Names of the emitted code's own variables and functions, in any target: programs get others."""

from __future__ import annotations

from dhgen.program.reserved import Reserved

_SOLVER = """
fk free_joints half_turn highest i1 i2 i3 i4 i5 i6 ik ik_all ik_batch ik_into J jacobian joint
lowest pose q q_free q_seed R revolute row seed slack solve status T T11 T12 T13 T14 T21 T22 T23 T24
T31 T32 T33 T34 turn turned weight wrap
"""

_C = """
A across add_others arm after ahead all all_joints along angle any aside at away before begun beside
best between beyond_limits both_sides branch by choosable choose_again chosen circle_roots clamped
CLOSE close complete continuum coordinate copy count d damped_step damping descend descended descent
distance doubtful e end ended ends entries enough escaped exact exactly exactness fan_step far
farther fault first found FREE G gap given_joints given_places gap_between given half held here high
i inner inside is_new is_open j join joints k keep keep_limits kept kind known LANES last
lead_inside leads least least_u left length look lose lost low many measure middle miss missed_by
most most_u moved moves n named nearest NEARLY nearly next NONE off other other_values others outer
over overshoot own P p pace part past past_an_end past_ends place plane_miss pulled reached
read_pose repeats residual rest result right rows s search seek seen served serves settle settled
share shorten sideways slope solve_regular solved solves span_low span_width spin square stand
stands start start_of stay step steps stride sum take there third tighten together tightened to told
top towards tried turn_vector turning u unit valid value values w way weights why within worst
wrap_angles x xx xy y yy z zeros zz
"""

_LANES = """
APART beyond ENTRIES exceeds four from grazes irregularity_four irregularity_wide kind KNOWN
maximum_double MOTION odd SIGNED SIGNED_TWICE size solve_wide TURNS wide word
"""

_PYTHON = """
BRANCHES carray DOF FREE_JOINT FREE_JOINTS INVALID_POSE JOINT_LIMITS JOINT_TYPES math MAX_SOLUTIONS
NAME njit np OK OUT_OF_LIMITS room types UNREACHABLE Unreachable warm_up
"""

# What else Python needs at file level beside the arm's constants, or has as locals where their
# formulas are.
_BESIDE_CONSTANTS = """
errors first hasattr ImportError METHOD ModuleType os rest sys u v ValueError w work x0 x1 x2 y2 z0
z1 z2
"""
_NUMBERED = r"(given|kind|none|outside|packed|ratio)\d+|x\w+_roots|(dhgen|DHGEN)_\w*[^\W_]"

_VALUES = frozenset(f"{_SOLVER} {_C} {_LANES} {_PYTHON}".split())

RESERVED = Reserved(
    values=_VALUES,
    constants=_VALUES | frozenset(_BESIDE_CONSTANTS.split()),  # these stand at file level
    numbered=_NUMBERED,
)
