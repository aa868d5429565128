"""From a Robot to its Chain: DH rows of either convention, base and tool, or reference axes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.kinematics.axes import exact_axes
from dhgen.kinematics.chain import (
    Chain,
    ChainJoint,
    Element,
    Fixed,
    Passive,
    Slide,
    Turn,
    arm_size,
)
from dhgen.kinematics.common_normals import table_of_axes
from dhgen.kinematics.constants import ConstantTable
from dhgen.kinematics.drives import Share, SumLimit
from dhgen.kinematics.normal import NormalForm, normal_form
from dhgen.kinematics.transform import (
    compose,
    identity,
    read_frame,
    rotation_x,
    rotation_z,
    translation,
)
from dhgen.robot.expression import ZERO, evaluate, to_text
from dhgen.robot.passive import followed, why_apart
from dhgen.robot.robot import Convention, DhTable, JointKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import DhRow, Frame, Robot
    from dhgen.robot.robot import SumLimit as SumOfFile


@dataclass(frozen=True, slots=True)
class _RowCells:
    """The constants of one row as ring elements."""

    theta: tuple[Polynomial, Polynomial]  # cosine and sine
    d: Polynomial
    a: Polynomial
    alpha: tuple[Polynomial, Polynomial]  # cosine and sine
    b: Polynomial


def build_chain(robot: Robot) -> Chain:
    """The exact chain of a robot, whichever way it was written."""
    if isinstance(robot.geometry, DhTable):
        chain = _chain_of_rows(robot, robot.geometry)
    else:
        exact = exact_axes(robot, robot.geometry)
        chain = exact or _chain_of_rows(*table_of_axes(robot, robot.geometry))
    return replace(chain, sums=tuple(_sum(each, chain.dof) for each in robot.sums))


def _sum(limit: SumOfFile, dof: int) -> SumLimit:
    factors = [0.0] * dof
    for coupling in limit.of:
        factors[coupling.joint - 1] += coupling.value
    return SumLimit(tuple(factors), *limit.limits, limit.kind is JointKind.REVOLUTE)


def _chain_of_rows(robot: Robot, geometry: DhTable) -> Chain:
    table = ConstantTable({parameter.name: parameter.value for parameter in robot.parameters})
    _read(robot, geometry, table)
    ring = table.close()
    cells, base, tool = _read(robot, geometry, table)
    constants = tuple(table.constants.values())
    normal = normal_form(ring, constants, {})
    joints = tuple(
        _joint(number, row, table.parameters) for number, row in enumerate(geometry.driven, start=1)
    )
    return Chain(
        name=robot.name,
        joints=joints,
        links=_links(geometry, cells, table.parameters, normal),
        base=base,
        tool=tool,
        constants=constants,
        ring=ring,
        task=robot.task,
        free=robot.free,
        size=arm_size(_lengths(geometry, robot.tool, table.parameters), joints),
        arm_angle=robot.arm_angle,
    )


def _read(
    robot: Robot, geometry: DhTable, table: ConstantTable
) -> tuple[list[_RowCells], Transform, Transform]:
    rows = zip(geometry.labels, geometry.rows, strict=True)
    cells = [
        _row_cells(label, row, _offset(place, geometry.rows), table)
        for place, (label, row) in enumerate(rows)
    ]
    base = read_frame(robot.base, table, "z", "base frame")
    tool = read_frame(robot.tool, table, "e", "tool frame")
    return cells, base, tool


def _links(
    geometry: DhTable, cells: list[_RowCells], parameters: dict[str, float], normal: NormalForm
) -> tuple[tuple[Element, ...], ...]:
    """The link of every joint; passive rows are in those of the joints beside them."""
    modified = geometry.convention is Convention.MODIFIED
    links: list[tuple[Element, ...]] = []
    waiting: tuple[Element, ...] = ()
    passive = 0
    rows = enumerate(zip(geometry.labels, geometry.rows, cells, strict=True))
    for place, (label, row, row_cells) in rows:
        if row.sign:
            number = len(links) + 1
            move = Turn(number) if row.kind is JointKind.REVOLUTE else Slide(number)
            links.append((*waiting, *_link(move, row_cells, geometry.convention, normal)))
            waiting = ()
            continue
        motion = _passive(passive, label, (place, geometry), parameters)
        passive += 1
        waiting = (*waiting, *_link(motion, row_cells, geometry.convention, normal))
        if links and (not modified or len(links) == len(geometry.driven)):
            links[-1], waiting = (*links[-1], *waiting), ()
    return tuple(links)


def _passive(
    number: int, label: str, of: tuple[int, DhTable], parameters: dict[str, float]
) -> Passive:
    """A passive row by its place in a table."""
    place, geometry = of
    row, apart = geometry.rows[place], why_apart(place, geometry.rows)
    turns = row.kind is JointKind.REVOLUTE
    if apart:
        own = len(geometry.driven) + 1 + number
        offset = evaluate(row.offset, parameters)
        return Passive(number, label, ((own, 1),), turns, _shares(row), offset, apart=apart)
    found = followed(row, geometry.driven)
    terms = tuple((joint, int(times)) for joint, times in found.terms)
    constant = evaluate(row.offset, parameters) - evaluate(found.offset, parameters)
    return Passive(number, label, terms, turns, _shares(row), constant)


def _offset(place: int, rows: Sequence[DhRow]) -> Expression:
    """The constant part of a passive row's angle or length, which is in its link.

    A joint's offset is the joint's own; so is that of a row which is no sum of joints' values.
    """
    row = rows[place]
    if row.sign or why_apart(place, rows):
        return ZERO
    return followed(row, [each for each in rows if each.sign]).offset


def _row_cells(label: str, row: DhRow, offset: Expression, table: ConstantTable) -> _RowCells:
    revolute = row.kind is JointKind.REVOLUTE
    still = offset if revolute else row.theta
    fixed = row.d if revolute else offset
    return _RowCells(
        theta=table.cosine_sine(still, f"t{label}", f"the angle of joint {label}"),
        d=table.length(fixed, f"d{label}", f"joint offset {label}"),
        a=table.length(row.a, f"a{label}", f"link length {label}"),
        alpha=table.cosine_sine(row.alpha, label, f"twist {label}"),
        b=table.length(row.b, f"b{label}", f"shift along y of link {label}"),
    )


def _link(
    move: Turn | Slide | Passive, cells: _RowCells, convention: Convention, normal: NormalForm
) -> tuple[Element, ...]:
    ring = cells.a.ring
    along_x = compose(
        translation(ring, (cells.a, ring.zero, ring.zero)),
        rotation_x(ring, *cells.alpha),
        normal,
    )
    along_z = compose(
        rotation_z(ring, *cells.theta),
        translation(ring, (ring.zero, ring.zero, cells.d)),
        normal,
    )
    parts: tuple[Element, ...]
    if convention is Convention.MODIFIED:
        along_y = translation(ring, (ring.zero, cells.b, ring.zero))
        parts = (Fixed(compose(compose(along_x, along_y, normal), along_z, normal)), move)
    elif isinstance(move, Turn) or (isinstance(move, Passive) and move.turns):
        parts = (move, Fixed(compose(along_z, along_x, normal)))
    else:
        parts = (Fixed(along_z), move, Fixed(along_x))
    nothing = Fixed(identity(ring))
    return tuple(part for part in parts if part != nothing)


def _joint(number: int, row: DhRow, parameters: dict[str, float]) -> ChainJoint:
    added = evaluate(row.offset, parameters)
    return ChainJoint(number, row.kind, row.sign, added, row.limits, row.name, _shares(row))


def _shares(row: DhRow) -> tuple[Share, ...]:
    return tuple(
        Share(coupling.joint, coupling.value, to_text(coupling.factor))
        for coupling in row.couplings
    )


def _lengths(geometry: DhTable, tool: Frame, parameters: dict[str, float]) -> list[float]:
    lengths = [
        evaluate(cell, parameters) for row in geometry.rows for cell in (row.a, row.b, row.d)
    ]
    return lengths + [evaluate(cell, parameters) for cell in tool.xyz]
