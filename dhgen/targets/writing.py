"""What differs between languages where parts of a solver have templates of their own."""

from __future__ import annotations

from dataclasses import dataclass
from textwrap import indent
from typing import TYPE_CHECKING

from dhgen.printing.templates import render
from dhgen.targets.general.algorithm import c_algorithm, python_algorithm
from dhgen.targets.layout import INDENT, c_array, python_array
from dhgen.targets.numerical.arrays import c_arrays, python_arrays

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.general.algorithm import CAlgorithm, PythonAlgorithm
    from dhgen.targets.numerical.arrays import Arrays


@dataclass(frozen=True, slots=True)
class Writing:
    """How a language writes such parts.

    Attributes:
        path: Of a template, but for its name.
        array: Defines an array by its name and its entries, inside a function where that may be.
        arrays: Those of damped least squares.
        algorithm: What it alone writes of the general algorithm.
        between: What stands between two functions.
    """

    path: str
    array: Callable[[str, Sequence[str]], str]
    arrays: Callable[[NumericalKernel], Arrays]
    algorithm: Callable[[GeneralKernel, str], CAlgorithm | PythonAlgorithm]
    between: str

    def filled(self, template: str, **values: object) -> str:
        """A template, by its name without an ending, with its values."""
        return render(self.path.format(template), **values)


def _inside(name: str, entries: Sequence[str]) -> str:
    return indent(c_array(f"static const double {name}[{len(entries)}]", entries), INDENT)


def _outside(name: str, entries: Sequence[str]) -> str:
    return python_array(f"_{name.upper()} = np.array", entries)


IN_C = Writing("c/{}.c.jinja", _inside, c_arrays, c_algorithm, "\n")
IN_PYTHON = Writing(
    "python/{}.py.jinja",
    _outside,
    python_arrays,
    lambda kernel, _: python_algorithm(kernel),  # its functions need no arm's name
    "\n\n",
)
