"""What singular places leave of two angles is their sum or difference, as the text says."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation.steps import step_blocks
from dhgen.derivation.sums_left import read_off
from dhgen.derivation.text.formula import Relation
from dhgen.derivation.values import letters_of_joints
from dhgen.kinematics.numeric import numeric_arm
from tests.derivation.made import made_for
from tests.derivation.stories import document, story, story_of
from tests.derivation.test_formulas_hold import with_entries, with_pose
from tests.derivation.values import evaluate
from tests.kinematics.values import table

if TYPE_CHECKING:
    from dhgen.derivation.story import Story

COMBINATION = r"\$\\theta_(?:{([\d-]+)}|(\d)) ([+-]) \\theta_(?:{([\d-]+)}|(\d))\$"
WHERE = r" \(\$([cs])_(\d) = (-?1)\$\)"
TOLD = re.compile(f"{COMBINATION}{WHERE}")
ARMS = ["rrprrr", "abb_irb120", "scara_wrist", "ur5", "techman_tm5_900", "wrist_cardan", "puma"]


def terms(text: str) -> dict[int, int]:
    """The joints of 12-4, with signs."""
    return {int(each[-1]): -1 if each[0] == "-" else 1 for each in re.findall(r"-?\d", text)}


SLIDE_BETWEEN = table(
    "theta: q, d: 0.4, alpha: pi/2",
    "theta: q, a: l2",
    "theta: q + pi/2, alpha: pi/2",
    "d: q, limits: [0.1, 0.6]",
    "theta: q, alpha: pi/2",
    "theta: q, d: 0.1",
    parameters="{l2: 0.3}",
)


@pytest.mark.parametrize("name", ARMS)
def test_the_combination_that_is_told_keeps_the_orientation(name: str) -> None:
    check_combinations(document(name), story(name))


def test_a_slide_between_the_axes_changes_nothing() -> None:
    of, text = story_of(SLIDE_BETWEEN), made_for(SLIDE_BETWEEN)
    assert of.program.branches[:2] == ("front-noflip23-noflip3", "front-noflip23-flip3")
    assert "axes 2, 3 and 6 are parallel" in text
    check_combinations(text, of)


def check_combinations(text: str, of: Story) -> None:
    """Turning about one axis is undone about the other: the orientation stays."""
    told = set(TOLD.findall(text))
    assert len(told) == 2
    arm = numeric_arm(of.algebra.chain)
    draw = np.random.default_rng(5)
    for group, single, sign, group_2, single_2, function, joint, one in told:
        before, behind = terms(group or single), terms(group_2 or single_2)
        facing = {"+": 1, "-": -1}[sign]
        middle = {"c": 0.0, "s": math.pi / 2}[function] + (math.pi if one == "-1" else 0.0)
        q = draw.uniform(-3.0, 3.0, arm.chain.dof)
        here = letters_of_joints(of, q.tolist())[f"θ{'₀₁₂₃₄₅₆'[int(joint)]}"]
        facings = [each.sign for each in arm.chain.joints]
        q[int(joint) - 1] += facings[int(joint) - 1] * (middle - here)
        kept, changed = q.copy(), q.copy()
        first, last = min(before), max(behind)
        kept[first - 1] += 0.7 * before[first] * facings[first - 1]
        changed[first - 1] = kept[first - 1]
        turned = 0.7 * behind[last] * facings[last - 1]
        kept[last - 1] -= facing * turned
        changed[last - 1] += facing * turned
        R, same, other = (arm.pose(each[None])[0][:3, :3] for each in (q, kept, changed))
        assert np.allclose(R, same, atol=1e-12)
        assert np.abs(R - other).max() > 0.1


READ = ["rrprrr", "arm_6r", "puma", "stanford", "wrist_cardan", "wrist_zxz", "wrist_zyz"]


@pytest.mark.parametrize("name", READ)
def test_the_combination_is_what_the_entries_of_the_matrix_say(name: str) -> None:
    """Document 004: q4 + q6 = atan2(A_3, A_1) where c5 = 1, q6 - q4 = atan2(A_3, -A_1) else."""
    of = story(name)
    lost = [each for step in range(len(of.steps)) for each in step_blocks(of, step + 1)[1]]
    (left,) = (each for each in lost if each.left is not None)
    assert left.left is not None
    told = read_off(of, left.step, left.left)
    assert told is not None
    relations = [part for part in told.parts if isinstance(part, Relation)]
    draw = np.random.default_rng(3)
    for combination, (between, value) in zip(
        relations[1::2], ((1, 0.0), (-1, math.pi)), strict=True
    ):
        q = draw.uniform(-3.0, 3.0, of.dof)
        middle = value if left.left.by_sine else between * math.pi / 2
        joint = of.algebra.chain.joints[left.left.joint - 1]
        q[joint.number - 1] = joint.sign * (middle - joint.offset)
        letters = with_entries(of, with_pose(of, q.tolist()))
        known, by_entries = (evaluate(side, letters) for side in combination.sides)
        assert math.isclose(math.remainder(known - by_entries, 2 * math.pi), 0.0, abs_tol=1e-9)


def test_the_table_of_the_singular_example_has_them_by_row() -> None:
    """Document 004's table of configurations: four rows, with q4 + q6 or q4 - q6 of each."""
    text = document("rrprrr").split("## Singular configurations")[1].split("## Velocity")[0]
    rows = [line.split(" | ") for line in re.findall(r"^\| (\d .*) \|$", text, re.MULTILINE)]
    rows = [row for row in rows if len(row) == 9]
    assert [row[0] for row in rows] == ["0", "2", "4", "6"]
    for row in rows:
        q4, q5, q6 = (float(re.sub(r"[^-\d.]", "", cell)) for cell in row[5:8])
        assert q5 in {0.0, 180.0}
        sign, value = re.findall(r"4 ([+-]) .*= (-?[\d.]+)", row[8])[0]
        assert sign == ("+" if q5 == 0.0 else "-")
        total = q4 + q6 if sign == "+" else q4 - q6
        assert math.isclose(math.remainder(total - float(value), 360.0), 0.0, abs_tol=1e-2)


def test_rows_that_took_the_seeds_value_are_named_beyond_limits_too() -> None:
    """Rows 0, 1, 4 and 5 of the table have q5 = 0 or 180 degrees and q2 + q3 as in the seed."""
    text = made_for(SLIDE_BETWEEN).split("## Singular configurations")[1].split("## Velocity")[0]
    rows = [line.strip("| ").split(" | ") for line in re.findall(r"^\| \d .*", text, re.MULTILINE)]
    rows = [row for row in rows if len(row) == 10]
    assert [row[0] for row in rows] == ["0", "1", "4", "5"]
    assert "In rows 0, 1, 4 and 5 the seed's value, zero here, is taken" in text
    beyond = [row[0] for row in rows if row[8] == "exceeded"]
    assert f"In rows {', '.join(beyond[:-1])} and {beyond[-1]} it puts a joint beyond" in text
    for row in rows:
        q2, q3, slide, q6 = (float(re.sub(r"[^-\d.]", "", row[place])) for place in (3, 4, 5, 7))
        assert (row[8] == "kept") == (0.1 <= slide <= 0.6)
        assert math.isclose(q2 + q3, 0.0, abs_tol=1e-2)
        sign, value = re.findall(r"([+-]) .*= (-?[\d.]+)", row[9])[0]
        total = 90.0 + q6 if sign == "+" else 90.0 - q6
        assert math.isclose(math.remainder(total - float(value), 360.0), 0.0, abs_tol=1e-2)
