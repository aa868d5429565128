"""The module of arms of one kind, whose tables come at run time."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.general.runtime_loop import runtime_loop
from dhgen.kinematics.neighbours import EXACT, axis_triples
from dhgen.printing.templates import named, render
from dhgen.program.regular.flatten import flatten
from dhgen.program.walk import general_kernel
from dhgen.runtime.python import INTERFACE
from dhgen.runtime.python.frames import IDENTITY
from dhgen.runtime.python.general.arm import Formulation
from dhgen.targets.constants import texts_of
from dhgen.targets.layout import INDENT
from dhgen.targets.module import made_text
from dhgen.targets.python.formulas import formulas_of
from dhgen.targets.python.literal import fields_of
from dhgen.targets.python.single_file import in_one_file
from dhgen.targets.python.table import arm_fields
from dhgen.targets.python.texts import constant_lines, python_comments, python_tables
from dhgen.targets.solver.common import common_of
from dhgen.targets.solver.nearest import APART

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.calibrated import Kind

TEMPLATE = "python/calibrated.py.jinja"
MODULES = {Formulation.__module__: "_loops"}


@dataclass(frozen=True, slots=True)
class PythonKind:
    """What the template names of a kind of arms.

    Attributes:
        table: The rows of the data sheet's table.
        constants: Of the nominal arm's closed form, as lines.
        arm: Fields of what is done around rows, as lines.
        fields: The other fields of the kind, as lines.
    """

    table: Sequence[str]
    constants: Sequence[str]
    arm: Sequence[str]
    fields: Sequence[str]


def kind_module(kind: Kind, *, single_file: bool = False) -> dict[str, str]:
    """The module by its name.

    Args:
        kind: The kind.
        single_file: Whether it holds what it needs of the runtime.
    """
    module, nominal, flat = kind.module, kind.nominal, flatten(kind.regular)
    own = replace(module, chain=nominal.chain, solver=nominal.solver)
    text = render(
        TEMPLATE,
        **named(common_of(module)),
        comments=replace(python_comments(module), made=made_text(nominal, TEMPLATE, "")),
        tables=python_tables(module, None),
        regular=formulas_of(flat, APART),
        convention=kind.table.convention,
        kind=PythonKind(
            table=[repr(row) for row in kind.table.rows],
            constants=constant_lines(texts_of(own, [flat.program])),
            arm=arm_fields(module, INDENT * 2),
            fields=_fields(kind),
        ),
        interface=INTERFACE,
    )
    return {f"{module.name}.py": in_one_file(text) if single_file else text}


def _fields(kind: Kind) -> list[str]:
    """What arms of a kind have in common besides what is done around their rows."""
    chain, table, kernel = kind.nominal.chain, kind.table, general_kernel(kind.module.solver)
    assert kernel is not None
    loop, triples = runtime_loop(kernel), axis_triples(chain)
    within = EXACT * chain.size
    fields: dict[str, object] = {
        "convention": table.convention,
        "facing": tuple(float(joint.sign) for joint in chain.joints),
        "reach": loop.reach,
        "advances": loop.advances,
        "formulations": loop.formulations,
    }
    places = {
        "base": table.base if table.base != IDENTITY else (),
        "tool": table.tool if table.tool != IDENTITY else (),
        "parallel": tuple(place for place, each in enumerate(triples) if each.tilt < EXACT),
        "meeting": tuple(place for place, each in enumerate(triples) if each.miss < within),
    }
    fields |= {name: value for name, value in places.items() if value}
    return fields_of(fields.items(), MODULES, INDENT)
