"""Names of the emitted code's own variables and functions, in any target: programs get others.

A name is here if it would hide a value or a constant of a program, or be hidden by one, be it only
to a compiler that warns of that. What the headers have that C includes before a robot's constants
is not here: nothing there is hidden by what follows. Tests hold these lists to what is emitted.
"""

from __future__ import annotations

from dhgen.program.reserved import Reserved

# Tables, functions, their arguments and variables, macros and theirs.
_C = """
arm arm_of_kind base choosable completion constants coordinate count coupled coupled_highest
coupled_lowest coupled_moves coupling descents drive_table drives drives_back entries exact facing
formulations found frames free_joints general given given_joints given_places given_shares i J
joints kind KNOWN least_u left links measure most_u MOTION motions moved n nearest_angles
nearest_arm nearest_links number off origins own plane_miss q q_seed row row_kinds rows seed SIGNED
SIGNED_TWICE signs solve solve_certain solve_regular solve_wide solved span_low span_width special
status stride sum_factors sum_highest sum_lowest sum_slacks T T11 T12 T13 T14 T21 T22 T23 T24 T31
T32 T33 T34 table together tool turn_moves turned_drives turning turns twist unit velocities wrist
zero
"""

# Functions that formulas are in, their arguments and variables, and what they name at file level.
_PYTHON = """
arm_angle end fk FREE_JOINT half_turn jacobian k kept OK OUT_OF_LIMITS pose q_free turn UNREACHABLE
w
"""

# What Python has at file level besides, or looks up there later, and what others look for in a
# robot's module.
_BESIDE_CONSTANTS = """
AXES BRANCHES calibrated calibrated_by_origins compile DOF exec FREE_JOINTS globals ik ik_all
ik_batch ik_into import_module INVALID_POSE JOINT_LIMITS JOINT_NAMES JOINT_TYPES joint_velocities
LEGS MAX_SOLUTIONS METHOD ModuleSpec NAME NOMINAL TABLE Unreachable warm_up
"""
_NUMBERED = r"(given|i|left_|kind|none|outside|packed|ratio)\d+|x\w+_roots|(dhgen|DHGEN)_\w*[^\W_]"

_VALUES = frozenset(f"{_C} {_PYTHON}".split())

RESERVED = Reserved(
    values=_VALUES,
    constants=_VALUES | frozenset(_BESIDE_CONSTANTS.split()),  # these are at file level
    numbered=_NUMBERED,
)
