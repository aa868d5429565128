"""An arm before it is built: its numbers, its forward model, what is shown of it."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import numpy as np
import pytest

import dhgen
from tests.descriptions.reference import FILES
from tests.library.arms import PLANAR

ROBOTS = Path(__file__).resolve().parents[2] / "robots"


def test_what_it_says_of_itself(arm: dhgen.Arm) -> None:
    assert (arm.name, arm.dof, arm.joint_types, arm.free) == ("two_links", 2, "RR", ())
    assert arm.joint_names == ("joint1", "joint2")
    (low, high), none = arm.joint_limits
    assert (low, high) == pytest.approx((-math.radians(160), math.radians(160)))
    assert none == (-math.inf, math.inf)


def test_fk_of_two_links_is_trigonometry(arm: dhgen.Arm) -> None:
    q1, q2 = 0.3, 1.1
    T = arm.fk([q1, q2])
    turned = q1 + q2 - math.pi / 2
    x, y = 0.4 * math.cos(q1), 0.4 * math.sin(q1)
    tool = [x + 0.3 * math.cos(turned), y + 0.3 * math.sin(turned), 0.0]
    np.testing.assert_allclose(T[:3, 3], tool, atol=1e-15)
    J = arm.jacobian([q1, q2])
    np.testing.assert_allclose(J[:, 1], [-tool[1] + y, tool[0] - x, 0, 0, 0, 1], atol=1e-15)


def test_stacks_of_joint_values(arm: dhgen.Arm) -> None:
    q = np.random.default_rng(2).uniform(-1, 1, (3, 4, 2))
    assert arm.fk(q).shape == (3, 4, 4, 4)
    np.testing.assert_array_equal(arm.fk(q)[2, 1], arm.fk(q[2, 1]))
    assert arm.jacobian(q).shape == (3, 4, 6, 2)
    for wrong in (0.3, [1.0], np.zeros((2, 3))):
        with pytest.raises(ValueError, match=r"^q must hold 2 joint values, with shape \(2,\) or "):
            arm.fk(wrong)


def test_text_for_a_terminal(arm: dhgen.Arm) -> None:
    assert repr(arm) == "<dhgen.Arm two_links: RR; task: [x, y]; standard convention>"
    assert str(arm).splitlines() == [
        "two_links: RR; task: [x, y]; standard convention",
        "joint  theta     d  a   alpha  limits",
        "1      q         0  a1  0      -160 to 160 deg",
        "2      q - pi/2  0  a2  0      none",
        "a1 = 0.4, a2 = 0.3",
    ]


def test_a_table_for_a_notebook(arm: dhgen.Arm) -> None:
    assert arm._repr_markdown_().splitlines() == [
        r"**Two links \| in a plane**: RR; task: \[x, y\]; standard convention",
        "",
        "| joint | theta | d | a | alpha | limits |",
        "|---|---|---|---|---|---|",
        "| 1 | q | 0 | a1 | 0 | -160 to 160 deg |",
        "| 2 | q - pi/2 | 0 | a2 | 0 | none |",
        "",
        "a1 = 0.4, a2 = 0.3",
        "",
        "tool at q = 0: x 0.4, y -0.3, z 0 m; rpy 0, 0, -90 deg",
    ]


def test_axes_slides_and_given_joints_are_shown() -> None:
    puma = str(dhgen.load(ROBOTS / "puma.yaml")).splitlines()
    assert puma[1].split() == ["joint", "type", "direction", "point", "limits"]
    assert puma[4] == "3      revolute  (1, 0, 0)  (0, 0, L2)        none"
    scara = dhgen.load(FILES / "scara.urdf")
    assert "3 j3   0      q   0   0      -0.15 to 0 m" in str(scara)
    assert "the caller gives q7" in repr(dhgen.load(FILES / "panda.urdf"))
    arm_angle = dhgen.load(FILES / "iiwa14.urdf", free="arm_angle")
    assert "the caller gives the arm angle" in repr(arm_angle)
    assert arm_angle.free == "arm_angle"


def test_notes_are_shown_and_nothing_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    arm = dhgen.load(FILES / "panda.urdf")
    (note,) = arm.notes
    assert "left out: panda_hand on panda_link8, with 2 joints of its own" in note
    assert str(arm).endswith(f"\nnote: {note}")
    assert capsys.readouterr() == ("", "")


def test_a_derivation_in_french(arm: dhgen.Arm) -> None:
    derivation = arm.derivation(language="fr")
    assert "# Two links \\| in a plane\u00a0: modèle géométrique inverse\n" in derivation
    assert set(derivation.figures) == {
        f"figures/two_links_{kind}_fr.svg" for kind in ("arm", "postures", "workspace")
    }
    assert all(f"]({path})" in derivation for path in derivation.figures)
    with pytest.raises(ValueError, match="language is 'en' or 'fr', not 'de'"):
        arm.derivation(language="de")  # type: ignore[arg-type]


def test_a_derivation_is_markdown_that_notebooks_show_with_formulas(
    arm: dhgen.Arm, empty_cache: Path
) -> None:
    derivation = arm.derivation()
    assert derivation.count("```math") > 5
    assert "# Two links \\| in a plane: inverse kinematics\n" in derivation
    assert repr(derivation).startswith("<Two links | in a plane: inverse kinematics; ")
    shown = derivation._repr_markdown_()
    assert shown.count("$$") == 2 * derivation.count("```math")
    assert "```math" not in shown
    assert "$`" not in shown
    assert "```text" in shown  # drawings stay what they are
    kinds = ("arm", "postures", "workspace")
    assert set(derivation.figures) == {f"figures/two_links_{kind}.svg" for kind in kinds}
    assert all(f"]({path})" in derivation for path in derivation.figures)
    assert shown.count("](data:image/svg+xml;base64,") == 3
    assert "](figures/" not in shown
    again = pickle.loads(pickle.dumps(derivation))  # noqa: S301
    assert (again, again.figures) == (derivation, derivation.figures)
    assert not empty_cache.exists()


def test_it_can_be_pickled_and_compared(arm: dhgen.Arm) -> None:
    arm.fk([0.0, 0.0])
    again = pickle.loads(pickle.dumps(arm))  # noqa: S301
    assert again == arm
    assert again != dhgen.load({**PLANAR, "name": "other"})
