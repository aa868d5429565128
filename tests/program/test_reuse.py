"""Constants that forward programs have under the names of the solver's."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import pytest

from dhgen.kinematics.build import build_chain
from dhgen.program.ir import Apply, Let, NamedConstant, Program, Variable
from dhgen.program.lowering.forward import forward_program, jacobian_program
from dhgen.program.lowering.programs import reusing
from tests.derivation.stories import story
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.program.ir import Expression

ARMS = first_of(["wrist_oblique", "puma560", "concurrent_345"], count=2)


def formulas(*programs: Program) -> list[tuple[float, int, str]]:
    """What constants are made of, in any order, each name once."""
    named = {c.name: c for program in programs for c in program.constants if "*" in c.meaning}
    return [(c.value, c.power, "".join(sorted(c.meaning))) for c in named.values()]


@pytest.mark.parametrize("name", ARMS)
def test_nothing_is_made_twice(name: str) -> None:
    chain, solver = build_chain(story(name).robot), story(name).program
    forward = reusing(forward_program(chain), solver)
    jacobian = reusing(jacobian_program(chain), solver, forward)
    counted = Counter(formulas(solver, forward, jacobian))
    once = Counter(formulas(solver))
    assert {each: n for each, n in counted.items() if n > max(once[each], 1)} == {}


def in_numbers(program: Program) -> list[object]:
    """Its values, with constants as the numbers that they are."""
    numbers = {constant.name: constant.value for constant in program.constants}

    def told(expression: Expression) -> object:
        match expression:
            case Variable(name):
                return numbers.get(name, name)
            case Apply(operator, operands):
                return operator, *map(told, operands)
            case _:
                return expression

    lets = [(each.name, each.expression) for each in program.body if isinstance(each, Let)]
    return [*((name, told(value)) for name, value in lets), *map(told, program.outputs)]


@pytest.mark.parametrize("name", ARMS)
def test_the_same_is_computed(name: str) -> None:
    chain, solver = build_chain(story(name).robot), story(name).program
    for program in (forward_program(chain), jacobian_program(chain)):
        assert in_numbers(reusing(program, solver)) == in_numbers(program)


def test_fractions_are_formulas() -> None:
    """What entries of a matrix are written with: an arm that stands askew has dozens."""
    program = Program("arm", (NamedConstant("f1", 0.4, "2 / 5"),), (), (), (), ())
    solver = Program("arm", (NamedConstant("k1", 0.4, "2 / 5"),), (), (), (), ())
    assert reusing(program, solver).constants == solver.constants


def test_equal_numbers_of_other_meanings_stay() -> None:
    two = tuple(NamedConstant(name, 0.25, of) for name, of in (("k1", "a2 * a2"), ("k2", "a3^2")))
    program = Program("arm", (NamedConstant("f1", 0.25, "a3 * a3"),), (), (), (), ())
    assert reusing(program, Program("arm", two, (), (), (), ())) == program
