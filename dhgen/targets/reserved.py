"""Names of the emitted code's own variables and functions, in any target: programs get others."""

from __future__ import annotations

from dhgen.program.reserved import Reserved

_SOLVER = """
fk free_joints function half_turn highest i1 i2 i3 i4 i5 i6 ik ik_all ik_batch ik_into J jacobian
joint joint_velocities lowest pose q q_free q_seed R revolute row seed slack solve status T T11 T12
T13 T14 T21 T22 T23 T24 T31 T32 T33 T34 turn turned weight wrap
"""

_C = """
A across after ahead all along angle any arm aside at away base before begun beside best between
branch by choosable chosen CLOSE close complete completion constants coordinate copy count coupled
coupled_highest coupled_lowest coupled_moves coupling d damping descent descents distance doubtful
drive_table drives drives_back e end ended ends enough entries exact exactly exactness facing far
farther fault first formulations found frames FREE G gap general given given_joints given_places
given_shares half held here high i inner inside is_open j joints k kept kind known LANES last leads
least least_u left length links lost low many measure middle miss most most_u motions moved moves n
named nearby nearby_count nearest nearest_angles nearest_arm nearest_links NEARLY nearly next NONE
off other others outer over overshoot own P p pace part past place plane_miss pulled reached
residual rest result right row_kinds rows s search seen served serves settled slope solve_certain
solve_regular solved solves span_low span_width special spin square stands start step steps stride
sum sum_factors sum_highest sum_lowest sum_slacks table there third to together tool top towards
tried turn_moves turned_drives turning turns twist u unit valid value values velocities w way
weights why within worst wrist x xx xy y yy z zero zeros zz
"""

_LANES = """
APART beyond exceeds four from irregularity_four irregularity_wide kind KNOWN
maximum_double MOTION odd SIGNED SIGNED_TWICE size solve_wide TURNS wide within_slack word
"""

_PYTHON = """
AXES BRANCHES calibrated calibrated_by_origins carray DOF FREE_JOINT FREE_JOINTS INVALID_POSE
JOINT_LIMITS JOINT_NAMES JOINT_TYPES math MAX_SOLUTIONS NAME njit NOMINAL np OK OUT_OF_LIMITS room
TABLE types UNREACHABLE Unreachable warm_up
"""

# What else Python needs at file level besides the arm's constants, or has as locals where their
# formulas are.
_BESIDE_CONSTANTS = """
errors first hasattr ImportError METHOD ModuleType os rest sys u v ValueError w work x0 x1 x2 y2 z0
z1 z2
"""
_NUMBERED = r"(given|left_|kind|none|outside|packed|ratio)\d+|x\w+_roots|(dhgen|DHGEN)_\w*[^\W_]"

_VALUES = frozenset(f"{_SOLVER} {_C} {_LANES} {_PYTHON}".split())

RESERVED = Reserved(
    values=_VALUES,
    constants=_VALUES | frozenset(_BESIDE_CONSTANTS.split()),  # these are at file level
    numbered=_NUMBERED,
)
