"""What is chosen together of an arm's drives, as the runtime takes it, in both languages."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.turns import coupled_turns
from dhgen.runtime.python.coupled import Coupling
from dhgen.targets.layout import c_array
from dhgen.targets.python.literal import literal

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.module import SolverModule

NO_LIMITS = (-math.inf, math.inf)


def runtime_coupling(module: SolverModule) -> Coupling | None:
    """What the runtime gets; None where every drive's whole turns are its own."""
    chain, turns = module.chain, coupled_turns(module.chain)
    if turns is None:
        return None
    angle = module.precision.tolerances.limit
    length = float(f"{angle * chain.size:.4g}")
    slacks = [angle if turns else length for turns in chain.turning]
    of_sums = tuple(angle if each.turns else length for each in chain.sums)
    limits = [joint.limits or NO_LIMITS for joint in chain.joints]
    return Coupling(
        drives=tuple(drive - 1 for drive in turns.drives),
        moves=turns.moves,
        limits=tuple((a - s, b + s) for (a, b), s in zip(limits, slacks, strict=True)),
        factors=tuple(each.factors for each in chain.sums),
        sums=tuple(
            (each.lowest - slack, each.highest + slack)
            for each, slack in zip(chain.sums, of_sums, strict=True)
        ),
        slacks=of_sums,
    )


@dataclass(frozen=True, slots=True)
class CCoupling:
    """What is chosen together, as C writes it.

    Attributes:
        arrays: Definitions.
        entries: Of the table.
    """

    arrays: tuple[str, ...]
    entries: str


def c_coupling(module: SolverModule) -> CCoupling | None:
    """The table of a robot; None where every drive's whole turns are its own."""
    turns = runtime_coupling(module)
    if turns is None:
        return None
    numbers = {
        "coupled_moves": [x for move in turns.moves for x in move],
        "coupled_lowest": [low for low, _ in turns.limits],
        "coupled_highest": [high for _, high in turns.limits],
        "sum_factors": [x for row in turns.factors for x in row],
        "sum_lowest": [low for low, _ in turns.sums],
        "sum_highest": [high for _, high in turns.sums],
        "sum_slacks": list(turns.slacks),
    }
    drives = [str(drive) for drive in turns.drives]
    arrays = [c_array(f"DHGEN_TABLE int coupled[{len(drives)}]", drives)] if drives else []
    arrays += [
        c_array(f"DHGEN_TABLE double {name}[{len(values)}]", map(_number, values))
        for name, values in numbers.items()
        if values
    ]
    names = {name: name if values else "NULL" for name, values in numbers.items()}
    own = f"{len(drives)}, {'coupled' if drives else 'NULL'}, {names['coupled_moves']}"
    limits = "coupled_lowest, coupled_highest"
    sums = ", ".join(names[f"sum_{each}"] for each in ("factors", "lowest", "highest", "slacks"))
    return CCoupling(tuple(arrays), f"{own}, {limits}, {len(turns.sums)}, {sums}")


def _number(value: float) -> str:
    if math.isinf(value):
        return "HUGE_VAL" if value > 0.0 else "-HUGE_VAL"
    return repr(value)


def coupling_fields(module: SolverModule) -> Sequence[str]:
    """The fields as Python writes them, none where every drive's whole turns are its own."""
    turns = runtime_coupling(module)
    if turns is None:
        return ()
    return tuple(
        line
        for name in Coupling.__slots__
        for line in f"{name}={literal(getattr(turns, name), {})},".splitlines()
    )
