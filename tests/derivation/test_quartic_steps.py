"""The steps of arms that take roots of a quartic, done as they are printed, give all solutions.

The printed elimination gives five values of f, these by printed formulas its coefficients, and they
the printed equation of degree 4, whose roots another program finds.
"""

from __future__ import annotations

import math
import re
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.derivation.notation.names import theta
from dhgen.kinematics.algebra import AngleSum
from dhgen.oracle.arm_angle import given_values
from dhgen.oracle.forward import forward
from dhgen.oracle.problem import task_entries
from dhgen.paul.kind import Kind
from dhgen.program.interpret import interpret
from tests.derivation.reading import name_of, relations_in, worth
from tests.derivation.stories import WITH_STEPS, document, story
from tests.derivation.test_printed_text import (
    FORMATS,
    KEPT,
    Letters,
    at,
    beginning_of,
    constants_of,
    define,
    joint_vector,
    plain,
    signs_of,
    steps_of,
)
from tests.derivation.values import letters_of
from tests.generated.solvers import module
from tests.structures import first_of, quick_first

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from tests.derivation.reading import Nodes

QUARTICS = [
    name for name in WITH_STEPS if re.search(r"^\*\*\d\..*type 9\.", document(name), re.MULTILINE)
]
INSTANCE = re.compile(r"vanish at once, for instance where (.*?) in a pose")
NAMED = [name for name in QUARTICS if INSTANCE.search(document(name))]
FOURTH = str(("sup", ("id", "x"), [("num", 4.0)]))
Values = dict[str, Any]


def angle_of(of: Story, number: int) -> str:
    """The letter of the angle that a step gives, as it is read."""
    unknown = next(u for u in of.steps[number].unknowns if isinstance(u, AngleSum))
    (name,) = plain({theta(unknown).text: 0.0})
    return name


def twists(of: Story) -> Values:
    """The angles of which the constants are the cosines and sines."""
    values = {of.letters[c.name].text: c.value for c in of.algebra.chain.constants}
    names = [text[4:] for text in values if text.startswith("sin ")]
    angles = {each: math.atan2(values[f"sin {each}"], values[f"cos {each}"]) for each in names}
    return plain(angles)


def called(nodes: Nodes, f: Callable[[float], float]) -> Nodes:
    """The values of f in the place of its calls."""
    found: Nodes = []
    left = list(nodes)
    while left:
        node = left.pop(0)
        if node == ("id", "f") and left[:1] == [("op", "(")]:
            end = left.index(("op", ")"))
            node = ("num", f(worth(left[1:end], {"π": math.pi}.__getitem__)))
            left = left[end + 1 :]
        elif node[0] == "frac":
            node = ("frac", called(node[1], f), called(node[2], f))
        found.append(node)
    return found


def coefficients(step: list[Nodes], known: Values, angle: str, of: Story) -> Values:
    """lambda and mu by the printed elimination, and the formulas for these."""
    size = of.algebra.chain.size

    def sides_at(value: float) -> Iterator[list[float]]:
        """Both sides of the equation that the elimination leaves, in P, Q and R."""
        letters = Letters({**known, angle: value}, of.dof)
        for nodes in step:
            for sides, _ in relations_in(nodes):
                try:
                    values = [float(worth(side, letters)) for side in sides]
                except KeyError:
                    continue
                if name_of(sides[0]) is None and "('id', 'R')" in str(sides):
                    yield values
            define(nodes, letters, size, checked=False)

    def f(value: float) -> float:
        ((left, right),) = sides_at(value)
        return left - right

    letters = Letters({}, of.dof)
    for nodes in step:
        if nodes[0][0] == "sub" and nodes[0][1] in {("id", "λ"), ("id", "μ")}:
            define(called(nodes, f), letters, size, checked=False)
    return letters.values


def roots(step: list[Nodes], known: Values, angle: str, of: Story) -> list[float]:
    """The values of the angle by the printed equation of degree 4."""
    letters = coefficients(step, known, angle, of)
    (quartic,) = (
        sides[0] for nodes in step for sides, _ in relations_in(nodes) if FOURTH in str(sides[0])
    )
    places = np.linspace(-1.0, 1.0, 5)
    values = [worth(quartic, Letters({**letters, "x": x}, of.dof)) for x in places]
    found = np.roots(np.polyfit(places, np.array(values, dtype=float), 4))
    real = found[np.abs(found.imag) < 1e-7 * (1.0 + np.abs(found))].real
    return [2.0 * math.atan(x) for x in real.tolist()]


def branches(of: Story, name: str, wished: str, known: Values) -> list[Values]:
    """All letters after the steps, for every root and with the signs that are known."""
    *steps, last = steps_of(name, wished)
    assert len(steps) == len(of.steps)
    size, states = of.algebra.chain.size, [dict(known)]
    for number, step in enumerate(steps):
        angle = angle_of(of, number) if of.steps[number].kind is Kind.CIRCLE else None
        begun, states = states, []
        for state in begun:
            letters = Letters(dict(state), of.dof)
            for nodes in beginning_of(name, wished):
                define(nodes, letters, size, checked=False)
            if angle is not None:
                values = roots(step, letters.values, angle, of)
                states += [{**letters.values, angle: value} for value in values]
                continue
            local = Letters(dict(letters.values), of.dof)
            for nodes in step:
                define(nodes, local, size, checked=False)
            kept = {key: value for key, value in local.values.items() if key[0] in KEPT}
            states.append({**letters.values, **kept})
    for state in states:
        letters = Letters(state, of.dof)
        for nodes in last:
            define(nodes, letters, size, checked=False)
    return states


def misses(of: Story, q: FloatArray, words: str) -> FloatArray:
    """By how much joint values miss what a text says of axes and points."""
    frames = module(of.robot.name).frames(q)
    foot, first = frames[0][:3, 3], frames[0][:3, 2]
    if "the wrist centre lies on axis 1" in words:
        return np.asarray(np.cross(frames[4][:3, 3] - foot, first))
    if "the tool's origin lies on axis 1" in words:
        return np.asarray(np.cross(frames[-1][:3, 3] - foot, first))
    last = frames[-1] if "the tool's z axis" in words else frames[of.dof - 1]
    leaning = np.cross(last[:3, 2], first)
    if "is parallel to axis 1" in words:
        return np.asarray(leaning)
    assert "lies along axis 1" in words
    return np.concatenate([leaning, np.cross(last[:3, 3] - foot, first)])


def brought_there(of: Story, q: FloatArray, words: str) -> FloatArray:
    """Joint values at which it is so, by Newton's steps."""
    for _ in range(60):
        miss, steps = misses(of, q, words), 1e-7 * np.eye(len(q))
        J = np.transpose([(misses(of, q + step, words) - miss) / 1e-7 for step in steps])
        change = np.linalg.lstsq(J, -miss, rcond=1e-6)[0]
        q = q + change * min(1.0, 0.3 / float(np.abs(change).max() + 1e-300))
    return q


def test_most_quartics_say_where_they_vanish() -> None:
    """The torch of the 5R passes axis 1 at a distance that none of its joints changes."""
    assert set(QUARTICS) - set(NAMED) == {"welding_5r"}


@pytest.mark.parametrize("name", first_of(NAMED, count=2))
def test_all_coefficients_vanish_where_the_text_says(name: str) -> None:
    of = story(name)
    said = INSTANCE.search(document(name))
    assert said is not None
    step = steps_of(name, "markdown")[0]
    reached = 0
    for seed in range(12):
        q, _, _ = at(of, seed)
        q = brought_there(of, q, said[1])
        if np.abs(misses(of, q, said[1])).max() > 1e-10:
            continue
        values = plain(letters_of(of, q.tolist()))
        pose = {k: v for k, v in values.items() if re.fullmatch(r"[tp]_\d\d|w_\d?[xyz]", k)}
        known = {**constants_of(of, values), **twists(of), **pose}
        found = coefficients(step, known, angle_of(of, 0), of)
        assert [key for key in found if abs(found[key]) > 1e-9] == []
        assert len(found) == 5
        reached += 1
    assert reached > 1


def test_every_quartic_is_tried() -> None:
    assert len(QUARTICS) > 3


@pytest.mark.parametrize("wished", quick_first(FORMATS))
@pytest.mark.parametrize("name", first_of(QUARTICS, count=2))
def test_the_steps_give_all_solutions_of_a_pose(name: str, wished: str) -> None:
    of = story(name)
    for seed in (5, 6):
        q, T, values = at(of, seed)
        rows = interpret(of.program, T[None], None, given_values(of.robot, q)).q[0]
        rows = rows[~np.isnan(rows).any(axis=1)]
        pose = {k: v for k, v in values.items() if re.fullmatch(r"[tp]_\d\d|w_\d?[xyz]", k)}
        known = {**constants_of(of, values), **twists(of), **pose}
        axes = zip(signs_of(of), of.program.axes, strict=True)
        names = [letter for letter, axis in axes if axis.count == 2]
        found = []
        for chosen in product((1.0, -1.0), repeat=len(names)):
            signs = dict(zip(names, chosen, strict=True))
            for state in branches(of, name, wished, {**known, **signs}):
                row = joint_vector(of, state)
                miss = np.abs(np.asarray(forward(of.robot, row)) - T)[:3]
                if miss[task_entries(of.robot.task).reshape(3, 4)].max() < 1e-7:
                    found.append(row)
        assert len(found) == len(rows) > 0
        for row in rows:
            off = np.remainder(np.array(found) - row + math.pi, 2.0 * math.pi) - math.pi
            assert np.abs(off).max(axis=1).min() < 1e-6
