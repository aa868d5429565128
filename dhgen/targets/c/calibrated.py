"""The header and the source of arms of one kind, whose tables come at run time."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.kinematics.neighbours import EXACT, axis_triples
from dhgen.printing.templates import named, render
from dhgen.program.walk import general_kernel
from dhgen.targets.c.descents import c_descents
from dhgen.targets.c.files import LONGEST, CRuntime, brought_along
from dhgen.targets.c.fitting import fitted
from dhgen.targets.c.nearest import flats_within
from dhgen.targets.c.regular import regular_values
from dhgen.targets.c.runtime import in_one_file, in_one_header
from dhgen.targets.c.table import c_table
from dhgen.targets.c.texts import c_comments, c_tables
from dhgen.targets.general.numbers import row, rows
from dhgen.targets.general.table import general_table
from dhgen.targets.module import made_text
from dhgen.targets.solver.common import common_of
from dhgen.targets.solver.nearest import APART

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.targets.calibrated import Kind


@dataclass(frozen=True, slots=True)
class CKind:
    """What the templates name of a kind of arms.

    Attributes:
        table: The rows of the data sheet's table.
        modified: Its convention.
        base: The constant transform before it.
        tool: The constant transform behind it.
        facing: How joints count.
        length: The size of the arm.
        parallel: Which three axes side by side are parallel in it, as bits.
        meeting: Which meet.
        rows: How many rows its closed form has.
        formulations: Of the general algorithm, which hold no links.
    """

    table: Sequence[str]
    modified: int
    base: str
    tool: str
    facing: str
    length: str
    parallel: str
    meeting: str
    rows: int
    formulations: Sequence[str]


def kind_files(kind: Kind, *, single_file: bool = False) -> dict[str, str]:
    """The header and the source by their names.

    Args:
        kind: The kind.
        single_file: Whether they hold what they need of the runtime.
    """
    values = _values(kind)
    header = fitted(render("c/calibrated.h.jinja", **values))
    source = fitted(render("c/calibrated.c.jinja", **values))
    if single_file:
        header, source = in_one_header(header), in_one_file(source, vectors=True)
    return {f"{kind.module.name}.h": header, f"{kind.module.name}.c": source}


def _values(kind: Kind) -> dict[str, object]:
    """What the templates name."""
    module, nominal = kind.module, kind.nominal
    kernel, descents = general_kernel(module.solver), c_descents(module)
    assert kernel is not None
    assert descents is not None
    own = replace(module, chain=nominal.chain, solver=nominal.solver)
    flats = flats_within(kind.regular, own, LONGEST)
    common = common_of(module)
    lines = brought_along(module, regular=True, first=["serial"], last=["calibrated"])
    return {
        **named(common),
        "given": replace(common.given, count=APART),
        "comments": replace(
            c_comments(module),
            made_h=made_text(nominal, "c/calibrated.h.jinja", " * "),
            made_c=made_text(nominal, "c/calibrated.c.jinja", " * "),
        ),
        "tables": c_tables(module, flats.programs),
        "table": c_table(module, has_functions=False),
        "general": general_table(kernel),
        "descents": render(
            "c/descents.c.jinja", descents=replace(descents, functions="0, 0, 0, 0,")
        ),
        "regular": replace(regular_values(own, flats), rows=nominal.solver.rows),
        "runtime": CRuntime(lines),
        "convention": kind.table.convention,
        "kind": _kind(kind, kernel),
    }


def _kind(kind: Kind, kernel: GeneralKernel) -> CKind:
    chain, table = kind.nominal.chain, kind.table
    triples = axis_triples(chain)
    return CKind(
        table=rows(table.rows),
        modified=int(table.convention == "modified"),
        base=row(table.base),
        tool=row(table.tool),
        facing=row(float(joint.sign) for joint in chain.joints),
        length=repr(chain.size),
        parallel=_bits(each.tilt < EXACT for each in triples),
        meeting=_bits(each.miss < EXACT * chain.size for each in triples),
        rows=kind.nominal.solver.rows,
        formulations=[
            f"{{ {row(each.joints)} }}, {float(each.sign)!r}, 0" for each in kernel.formulations
        ],
    )


def _bits(flags: Iterable[bool]) -> str:
    return f"{sum(flag << place for place, flag in enumerate(flags)):#x}u"
