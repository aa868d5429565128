"""Names of the emitted code's own variables and functions, in any target: programs get others."""

from __future__ import annotations

from dhgen.program.reserved import Reserved

_SOLVER = """
J R T fk free_joints highest i1 i2 i3 i4 i5 i6 ik ik_all ik_batch ik_into jacobian joint
half_turn lowest pose q q_free q_seed revolute row seed solve status turn turned weight wrap
T11 T12 T13 T14 T21 T22 T23 T24 T31 T32 T33 T34
"""

_C = """
all_joints chosen clamped continuum coordinate copy damped_step descend descent distance_between
keep kept known_as limited_step look least_u most_u nearest_solution no_highest no_lowest measure
move_inside pulled shorten solved solves_between sorted_rows span_low span_width stands_before
start_of stride turn_vector turning unit wrap_angles G LANES LOST NEARLY after all angle attempt
before choose_again circle_roots CLOSE across ahead beside both_sides close descended doubtful end
enough_beside exactness gap_between is_new known leads solves count distance found given here high i
ik_carefully nearly residual serving_digits serving_value solve_regular enough ended inner j k last
least left length lose lost low middle misfit_one misfit_wide miss missed_by moved n others named
nearest off outer reached read_pose repeats result right serves sum tighten tightened values search
served square start step straighten summit third towards valid value way why x xx xy y yy z zz zeros
exact exactly beyond_limits choosable fan_step gap here hopeless inside keep_limits over overshoot
shortfall within begun fault seek take settle P e p s w weights tried held slope A add_step half
half_way between most low high off_pose pace stands place settled share stay along spin part to bend
rest other d u any next steps past past_an_end past_ends at_an_end seen stand plane_miss escaped
sideways damping is_open there top add_others aside by ends far farther first join kind lead_inside
branch other_values own moves rows tell_once told worst joints serving serving_in_turn best at
"""

_LANES = """
APART ARCTANGENT EACH ENTRIES HELPER INLINED KNOWN SIGNED SIGNED_TWICE UNROLLED VECTOR abs_double
cos_double sin_double sqrt_double beyond bits_four bits_wide four four_at four_mask from
irregularity_four irregularity_wide kind kind_of odd size solve_tile solve_wide store_1 store_2
store_4 transpose two_at wide wide_at wide_mask word abs_four all_four atan2_four copysign_four
cos_four maximum_four pick_four sin_four minimum_four sqrt_four where_four wrap_four abs_wide
added_four added_wide all_wide atan2_wide copysign_wide cos_wide maximum_wide pick_wide sin_wide
minimum_wide sqrt_wide where_wide wrap_wide maximum_double only_four only_wide minimum_double
signed_four signed_wide angle_four angle_wide beyond_four compare_four exceeds exceeds_four
four_ratio negated_four negated_wide ratio_four ratio_wide shuffle where_all wide_ratio MOTION TURNS
raised_four raised_wide lowered_four lowered_wide centred_four centred_wide
"""

_PYTHON = """
BRANCHES DOF FREE_JOINT FREE_JOINTS INVALID_POSE JOINT_LIMITS JOINT_TYPES MAX_SOLUTIONS NAME OK
OUT_OF_LIMITS UNREACHABLE Unreachable carray cgutils intrinsic math njit np room types warm_up
"""

# What else Python needs at file level beside the arm's constants, or has as locals where their
# formulas are.
_BESIDE_CONSTANTS = """
ImportError METHOD ModuleType ThreadPoolExecutor ValueError config errors first hasattr
normalize_signature os rest sys u v w work x0 x1 x2 y2 z0 z1 z2
"""
_NUMBERED = r"(given|kind|none|outside|packed|ratio)\d+|x\w+_roots"

_VALUES = frozenset(f"{_SOLVER} {_C} {_LANES} {_PYTHON}".split())

RESERVED = Reserved(
    values=_VALUES,
    constants=_VALUES | frozenset(_BESIDE_CONSTANTS.split()),  # these stand at file level
    numbered=_NUMBERED,
)
