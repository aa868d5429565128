"""The table of an arm that least squares work on, as C writes it."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from dhgen.program.walk import descents, whole_arm
from dhgen.runtime.plain import plain
from dhgen.runtime.python.numerical.arm import strides
from dhgen.targets.c.table import c_directions
from dhgen.targets.layout import c_array

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Descents:
    """Definitions of arrays, empty where the arm has none, and entries of tables.

    Attributes:
        joints: Places of the joints that are solved for.
        turning: Which of them turn.
        unit: What a step of one means for them.
        measure: What it moves, in arm sizes.
        coordinate: Rows of the coordinates that the task names.
        span_low: Where the ranges begin in which descents start.
        span_width: How wide these are.
        stride: From one start to the next, in parts of a range.
        least: Bounds of descents.
        most: The upper ones.
        facing: Which way the loop of the general algorithm counts the joints.
        zero: And from where.
        given: Joints whose values the caller gives.
        arm_angle: Whether the caller gives that.
        sizes: Joints, and rows.
        equations: Joints that are solved for, and equations.
        kinds: What these are.
        flags: Whether solutions are families, joints have limits, and the pose is checked.
        numbers: Starts, size, and what counts as a solution.
        places: Arrays by their names, 0 for none.
        bounds: More of them.
        functions: Functions by their names, 0 for none.
        drives: How drives hang together, where one moves more than its own joint.
        turns: The joints whose values add up to the root of a polynomial.
        completion: Entries of the table for rows that may miss their pose.
    """

    joints: str
    turning: str
    unit: str
    measure: str
    coordinate: str
    span_low: str
    span_width: str
    stride: str
    least: str
    most: str
    facing: str
    zero: str
    given: str
    arm_angle: bool
    sizes: str
    equations: str
    kinds: str
    flags: str
    numbers: str
    places: str
    bounds: str
    functions: str
    drives: tuple[str, ...]
    turns: str
    completion: str


def c_descents(module: SolverModule) -> Descents | None:
    """The table of a robot, where it is solved by descents or its rows may miss their pose."""
    whole = whole_arm(module.solver)
    kernel = descents(module.solver)
    if kernel is None:
        return None
    chain, name = kernel.arm.chain, module.name
    in_loop = chain.solved if whole is not None and whole.general is not None else ()
    units, count = kernel.units, len(kernel.solved)
    bounds = (kernel.lowest, kernel.highest) if kernel.bounded else ((), ())
    words = (int(kernel.redundant), int(kernel.limited), int(kernel.checked))
    search = plain("numerical.search")
    starts = search.REDUNDANT_STARTS if kernel.redundant else search.STARTS
    given = f"{len(chain.free)}, {'given_places' if chain.free else '0'}"
    return Descents(
        joints=_places("solved", kernel.solved),
        turning=_places("turning", map(int, kernel.turns)),
        unit=_numbers("unit", units),
        measure=_numbers("measure", (unit / chain.size for unit in units if kernel.position)),
        coordinate=_places("coordinate", kernel.position),
        span_low=_numbers("span_low", (low for low, _ in kernel.spans)),
        span_width=_numbers("span_width", (high - low for low, high in kernel.spans)),
        stride=_numbers("stride", strides(count)),
        least=_numbers("least_u", bounds[0]),
        most=_numbers("most_u", bounds[1]),
        facing=_numbers("facing", (float(joint.sign) for joint in in_loop)),
        zero=_numbers("zero", (joint.offset for joint in in_loop)),
        given=_places("given_places", (number - 1 for number in chain.free)),
        arm_angle=kernel.elbow,
        sizes=f"{chain.dof}, {module.solver.rows}",
        equations=f"{count}, {kernel.equations}",
        kinds=f"{len(kernel.position)}, {c_directions(kernel.directions)}, {int(kernel.elbow)}",
        flags=", ".join(map(str, words)),
        numbers=f"{starts}, {chain.size!r}, {kernel.residual!r}",
        places=("coordinate, unit, measure," if kernel.position else "0, unit, 0,")
        + " span_low, span_width, stride,",
        bounds=("least_u, most_u," if kernel.bounded else "0, 0,")
        + (" facing, zero," if in_loop else " 0, 0,")
        + f" {given},",
        functions=f"{name}_fk, {name}_jacobian, {'plane_miss' if kernel.elbow else '0'},"
        + (" 0," if kernel.back is None else " &drive_table,"),
        drives=_drives(kernel),
        turns=_turns(module),
        completion="" if module.solver.completion is None else _completion(module, kernel),
    )


def _drives(kernel: NumericalKernel) -> tuple[str, ...]:
    """Arrays, and a table of them; empty where every drive moves its own joint alone."""
    if kernel.back is None:
        return ()
    turned = kernel.turned
    table = f"{len(turned)}, {'turned_drives, turn_moves' if turned else '0, 0'}, drives_back"
    arrays = (
        _places("turned_drives", (place for place, _ in turned)),
        _numbers("turn_moves", (x for _, moves in turned for x in moves.tolist())),
        _numbers("drives_back", kernel.back.ravel().tolist()),
        f"DHGEN_TABLE struct dhgen_drives drive_table = {{ {table} }};",
    )
    return tuple(filter(None, arrays))


def _turns(module: SolverModule) -> str:
    turning = module.policy.root_turns
    entries = [f"{{ {joint - 1}, {float(sign)!r} }}" for joint, sign in turning]
    head = f"DHGEN_TABLE struct dhgen_root_turn turns[{len(entries)}]"
    return c_array(head, entries) if entries else ""


def _completion(module: SolverModule, kernel: NumericalKernel) -> str:
    """What `dhgen_complete_rows` does."""
    policy = module.policy
    turns = len(policy.root_turns)
    flags = f"{int(policy.adds_others)}, /* adds others */ {int(policy.ascends)}, /* ascends */"
    flags += f" {int(policy.equations_end_all)}, /* equations end all */"
    arm_angle = f"{module.name}_arm_angle" if kernel.elbow else "0"
    return f"&descents, {'turns' if turns else '0'}, {turns}, {flags} {arm_angle}"


def _places(name: str, places: Iterable[int]) -> str:
    """Defines an array of integers, where it has any."""
    return _array("int", name, [str(int(place)) for place in places])


def _numbers(name: str, values: Iterable[float]) -> str:
    """Defines an array of numbers, where it has any."""
    words = {inf: "HUGE_VAL", -inf: "-HUGE_VAL"}
    return _array("double", name, [words.get(value, repr(value)) for value in values])


def _array(kind: str, name: str, texts: list[str]) -> str:
    return c_array(f"DHGEN_TABLE {kind} {name}[{len(texts)}]", texts) if texts else ""
