"""The programs of arms that are solved as a whole: one statement, a guard, and the rows."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.general.kernel import GeneralKernel
from dhgen.numerical.kernel import numerical_kernel
from dhgen.program.ir import AllJoints, Axis, Failure, Guard, Heading, Program, Variable

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain
    from dhgen.numerical.kernel import NumericalKernel

FOUND, CHOSEN = "found", "chosen"


def whole_program(chain: Chain, kernel: GeneralKernel | NumericalKernel) -> Program:
    """The program of an arm whose joints come all at once, rows by ascending joint values."""
    names = tuple(f"q{joint.number}" for joint in chain.joints)
    if isinstance(kernel, GeneralKernel):
        title, words = f"the {kernel.method} loop", _numbered("root", kernel.rows)
        descent = replace(numerical_kernel(chain, redundant=False), most=kernel.rows)
        statement = AllJoints(0, names, FOUND, CHOSEN, descent, kernel, bool(chain.free))
    else:
        title = "damped least squares"
        words = ("nearest",) if kernel.redundant else _numbered("solution", kernel.rows)
        statement = AllJoints(0, names, FOUND, CHOSEN, kernel, given=bool(chain.free))
    return Program(
        name=chain.name,
        constants=(),
        axes=(Axis("solution", words, 1),),
        body=(
            Heading(f"all joints: {title}"),
            statement,
            Guard(Variable(FOUND), (0,), Failure.REACH),
        ),
        outputs=tuple(Variable(name) for name in names),
        free=((0, CHOSEN),),
    )


def _numbered(word: str, count: int) -> tuple[str, ...]:
    return tuple(f"{word}{number}" for number in range(1, count + 1))
