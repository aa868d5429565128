"""The other valid steps at every point of a derivation, for `dhgen explain --alternatives`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.elements import element_of
from dhgen.derivation.notation.names import unknown_symbol
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.words import counted

if TYPE_CHECKING:
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.step import Step


def alternatives_text(derivation: Derivation) -> str:
    """For each step, what was taken, and what else would have been valid, cheapest first."""
    lines: list[str] = []
    for number, step in enumerate(derivation.steps, start=1):
        lines.append(f"{number}. {_line(step)}   (taken)")
        others = [_line(other) for other in derivation.alternatives[number - 1]]
        lines += [f"     {line}" for line in dict.fromkeys(others) if line != _line(step)]
    return "\n".join(lines) + "\n"


def _line(step: Step) -> str:
    """theta_3, two values: type 8, U_0[1,4] and U_0[2,4]."""
    names = ", ".join(unknown_symbol(unknown).text for unknown in step.unknowns)
    where = " and ".join(show(element_of(origin), PLAIN) for origin in sorted(step.origins))
    return f"{names}: type {step.kind.value}, {counted(step.roots, 'value')}, {where}"
