"""The derivation in a dozen lines, and the steps that were not taken, for the terminal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.notation.matrices import element_of
from dhgen.derivation.notation.names import unknown_symbol
from dhgen.derivation.sections.general import joint_symbol
from dhgen.derivation.sections.nearest import nearest_line
from dhgen.derivation.steps import quoted
from dhgen.derivation.text.blocks import Prose
from dhgen.derivation.text.plain import words
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.words import counted
from dhgen.general.kernel import GeneralKernel
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.mobility import determining_tasks
from dhgen.paul.refusal.unsolved import missed_structure

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.kinematics.chain import Chain
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.step import Step


CHECKED = "every pose is checked: the task asks for more than the arm can choose"
PARALLEL = 1e-9  # of the arm's size, or rad: what is less counts as zero
CHOOSING = "others are taken by their numbers, from step 1 on, in the robot file: steps: [2, 1]"
LONGEST = 62  # characters of an equation; the rest is in the derivation


def summary_text(story: Story, singular: list[Singularity]) -> str:
    """A line for every step, then the branches and the singular places."""
    if story.derivation.whole is not None:
        return "\n".join(_whole(story.derivation.whole, story)) + "\n"
    rows = [_step(story, number) for number in range(1, len(story.steps) + 1)]
    widths = [max(len(row[column]) for row in rows) for column in range(3)]
    lines = [
        "  ".join((*(f"{cell:<{w}}" for cell, w in zip(row[:3], widths, strict=True)), row[3]))
        for row in rows
    ]
    names = ", ".join(story.branch_names) if story.has_branch_words else ""
    lines.append(f"{counted(story.program.rows, 'row')}" + (f": {names}" if names else ""))
    lines += [_singular(each) for each in singular]
    lines += task_remarks(story.algebra.chain)
    return "\n".join(lines) + "\n"


def tool_at_zero(chain: Chain, length_unit: str) -> str:
    """A line with the tool's pose at q = 0, which a new table can be checked by at a glance."""
    T = numeric_arm(chain).pose(np.zeros(chain.dof))
    level = math.hypot(T[0, 0], T[1, 0])
    upright = level < PARALLEL  # then roll and yaw turn about one axis: roll is 0
    roll = 0.0 if upright else math.atan2(T[2, 1], T[2, 2])
    yaw = math.atan2(-T[0, 1], T[1, 1]) if upright else math.atan2(T[1, 0], T[0, 0])
    turns = (math.degrees(angle) for angle in (roll, math.atan2(-T[2, 0], level), yaw))
    angles = (180.0 if turn < -180.0 + 1e-7 else turn for turn in turns)
    x, y, z = (f"{value:.6g}" for value in _rounded(T[:3, 3], PARALLEL * chain.size))
    r, p, w = (f"{value:.6g}" for value in _rounded(angles, 1e-7))
    return f"tool at q = 0: x {x}, y {y}, z {z} {length_unit}; rpy {r}, {p}, {w} deg"


def _rounded(values: Iterable[float], step: float) -> list[float]:
    """Numbers in whole steps, without -0: what rounding leaves of zero is gone."""
    return [round(value / step) * step + 0.0 for value in values]


def _whole(kernel: GeneralKernel | NumericalKernel, story: Story) -> list[str]:
    """Of an arm that is solved as a whole."""
    if isinstance(kernel, GeneralKernel):
        degree = 2 * kernel.degree  # the latter counts cosines and sines
        joint = joint_symbol(kernel, kernel.first.joints[0]).text
        hidden = joint if kernel.hides_a_slide else f"tan({joint}/2)"
        rows = "ascending joint values" if story.nominal is None else "posture"
        return [
            f"no closed form: the {kernel.method} algorithm, up to {kernel.rows} solutions",
            f"a polynomial of degree {degree} in {hidden}; rows by {rows}",
            *missed_structure(story.algebra.chain, story.robot.length_unit),
            *_nearest(story),
            *(task_remarks(story.algebra.chain) if kernel.checked else []),
        ]
    if kernel.redundant:
        return ["numerical, as asked for: the solution near the seed, by damped least squares"]
    found = "by damped least squares, as many as are found from evenly spread starts"
    return [f"numerical, as asked for: up to {kernel.rows} solutions {found}; others may exist"]


def _nearest(story: Story) -> list[str]:
    """What is tried first, where that is the nearest arm with a structure."""
    nominal = story.nominal
    return [] if nominal is None else [nearest_line(nominal, story.robot.length_unit)]


def task_remarks(chain: Chain) -> list[str]:
    """That a task needs more than the arm can choose, and one that needs as much."""
    if not chain.overdetermined:
        return []
    tasks = determining_tasks(chain).items()
    enough = [text for text, task in tasks if task.dimension == chain.dof - chain.given]
    return [CHECKED, *(f"`task: {text}` would ask for as much as it can" for text in enough[:1])]


def _step(story: Story, number: int) -> tuple[str, str, str, str]:
    step = story.steps[number - 1]
    names = ", ".join(unknown_symbol(unknown).text for unknown in step.unknowns)
    equations = ", ".join(show(equation, PLAIN) for equation in quoted(story, number))
    if len(equations) > LONGEST:
        equations = equations[: LONGEST - 1].rstrip() + "…"
    kind = f"type {step.kind.number}"
    return f"{number}. {names}", kind, counted(step.roots, "value"), equations


def _singular(each: Singularity) -> str:
    condition = each.condition
    if each.joints is not None and not isinstance(each.joints, Prose):
        condition = each.joints
    if isinstance(condition, Prose):
        place = f"where {words(condition)}"
    else:
        place = f"at {show(condition, PLAIN)}"
    return f"degenerate {place}: {words(each.meaning)}"


def alternatives_text(derivation: Derivation) -> str:
    """For each step, what is valid there, cheapest first, by the numbers that `steps` takes."""
    lines: list[str] = []
    for place, (step, offers) in enumerate(zip(derivation.steps, derivation.offers, strict=True)):
        numbers: dict[str, int] = {}
        for number, offer in enumerate(offers, start=1):
            if _is(offer, step):
                numbers[_line(offer)] = number
            numbers.setdefault(_line(offer), number)
        lines.append(f"step {place + 1}")
        for line, number in sorted(numbers.items(), key=lambda each: each[1]):
            taken = "   (taken)" if _is(offers[number - 1], step) else ""
            lines.append(f"{number:4}  {line}{taken}")
    if lines:
        lines.append(CHOOSING)
    return "\n".join(lines) + "\n"


def _is(offer: Step, step: Step) -> bool:
    """Whether a step is this offer; what is found out about steps afterwards is left aside."""
    return (offer.kind, offer.unknowns, offer.forms) == (step.kind, step.unknowns, step.forms)


def _line(step: Step) -> str:
    """theta_3, two values: type 8, U_0[1,4] and U_0[2,4]."""
    names = ", ".join(unknown_symbol(unknown).text for unknown in step.unknowns)
    where = " and ".join(show(element_of(origin), PLAIN) for origin in sorted(step.origins))
    return f"{names}: type {step.kind.number}, {counted(step.roots, 'value')}, {where}"
