"""Names of the emitted code's own variables and functions, in any target: programs get others."""

from __future__ import annotations

from dhgen.program.reserved import Reserved

_SOLVER = """
fk free_joints half_turn highest i1 i2 i3 i4 i5 i6 ik ik_all ik_batch ik_into J jacobian joint
lowest pose q q_free q_seed R revolute row seed slack solve status T T11 T12 T13 T14 T21 T22 T23 T24
T31 T32 T33 T34 turn turned weight wrap
"""

_C = """
A across add_others arm add_regular add_step after ahead all all_joints along angle any aside at
at_an_end attempt away before begun bend beside best between beyond_limits both_sides branch by
choosable choose_again chosen circle_roots clamped CLOSE close complete continuum coordinate copy
count d damped_step damping descend descended descent distance distance_between doubtful e end ended
ends entries enough enough_beside escaped exact exactly exactness fan_step far farther fault first
found FREE G gap given_joints given_places gap_between given half half_way held here high hopeless
i ik_carefully
inner inside INVALID is_new is_open j join joints k keep keep_limits kept kind known known_as LANES
last lead_inside leads least least_u left length limited_step look lose LOST lost low many measure
middle misfit_one misfit_wide miss missed_by most most_u move_inside moved moves n named nearest
nearest_solution NEARLY nearly next no_highest no_lowest NONE off off_pose other other_values others
OUT outer over overshoot own P p pace part past past_an_end past_ends place plane_miss pulled
reached read_pose repeats residual rest result right rows s search seek seen served serves serving
serving_digits serving_in_turn serving_value settle settled share shorten shortfall sideways slope
solve_regular solved solves solves_between sorted_rows span_low span_width spin square stand stands
stands_before start start_of stay step steps straighten stride sum summit take tell_once there third
tighten together tightened to told top towards tried turn_vector turning u unit valid value values w
way weights why within worst wrap_angles x xx xy y yy z zeros zz
"""

_LANES = """
abs_double abs_four abs_wide added_four added_wide all_four all_wide angle_four angle_wide APART
ARCTANGENT atan2_four atan2_wide beyond beyond_four bits_four bits_wide centred_four centred_wide
copysign_four copysign_wide cos_double cos_four cos_wide EACH ENTRIES exceeds exceeds_four four
four_at four_mask four_ratio from grazes grazes_four HELPER INLINED irregularity_four
irregularity_wide kind kind_of KNOWN lowered_four lowered_wide maximum_double maximum_four
maximum_wide minimum_double minimum_four minimum_wide MOTION negated_four negated_wide odd only_four
only_wide pick_four pick_wide raised_four raised_wide ratio_four ratio_wide shuffle SIGNED
signed_four SIGNED_TWICE signed_wide sin_double sin_four sin_wide size solve_tile solve_wide
sqrt_double sqrt_four sqrt_wide store_1 store_2 store_4 transpose TURNS two_at UNROLLED VECTOR
where_all where_four where_wide wide wide_at wide_mask wide_ratio word wrap_four wrap_wide
"""

_PYTHON = """
BRANCHES carray cgutils DOF FREE_JOINT FREE_JOINTS intrinsic INVALID_POSE JOINT_LIMITS JOINT_TYPES
math MAX_SOLUTIONS NAME njit np OK OUT_OF_LIMITS room types UNREACHABLE Unreachable warm_up
"""

# What else Python needs at file level beside the arm's constants, or has as locals where their
# formulas are.
_BESIDE_CONSTANTS = """
config errors first hasattr ImportError METHOD ModuleType normalize_signature os rest sys
ThreadPoolExecutor u v ValueError w work x0 x1 x2 y2 z0 z1 z2
"""
_NUMBERED = r"(given|kind|none|outside|packed|ratio)\d+|x\w+_roots|(dhgen|DHGEN)_\w*[^\W_]"

_VALUES = frozenset(f"{_SOLVER} {_C} {_LANES} {_PYTHON}".split())

RESERVED = Reserved(
    values=_VALUES,
    constants=_VALUES | frozenset(_BESIDE_CONSTANTS.split()),  # these stand at file level
    numbered=_NUMBERED,
)
