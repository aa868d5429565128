"""A wrist's two ways to turn: rows of one pose hold the values that the text relates."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import interpret
from tests.derivation.stories import NAMES, WITH_STEPS, document, story
from tests.structures import those_in

SENTENCE = re.compile(
    r"differ in noflip and flip alone .* where one has \$\\theta_(\d)\$, \$\\theta_(\d)\$, "
    r"\$\\theta_(\d)\$, the other has \$\\theta_\1 \+ \\pi\$, \$-\\theta_\2\$, "
    r"\$\\theta_\3 \+ \\pi\$"
)
TOLD = {name: found for name in WITH_STEPS if (found := SENTENCE.search(document(name)))}
ROUNDING = 1e-7  # [rad] where a wrist is nearly stretched
EACH = those_in(set(NAMES), sorted(TOLD))


@pytest.mark.parametrize("name", EACH)
def test_rows_that_differ_in_the_flip_alone_are_so_related(name: str) -> None:
    of = story(name)
    first, middle, last = (int(joint) - 1 for joint in TOLD[name].groups())
    arm = numeric_arm(of.algebra.chain)
    chain = arm.chain
    reach = [math.pi if turns else chain.size for turns in chain.turning]
    q = np.random.default_rng(8).uniform(-0.9, 0.9, (20, chain.dof)) * reach
    found = interpret(of.program, arm.pose(q), q, given_values(arm, q)).q
    names = of.program.branches
    compared = 0
    for one, word in enumerate(names):
        if "noflip" not in word:
            continue
        other = names.index(word.replace("noflip", "flip"))
        both = ~np.isnan(found[:, [one, other], 0]).any(axis=1)
        angles, others = (chain.drives.values(found[both, row]) for row in (one, other))
        change = others - angles
        change[:, [first, last]] -= math.pi
        change[:, middle] += 2.0 * angles[:, middle]
        turning = np.array(chain.turning)
        change[:, turning] = np.abs(np.remainder(change[:, turning] + 1.0, 2.0 * math.pi) - 1.0)
        assert np.abs(change).max(initial=0.0) < ROUNDING
        compared += int(both.sum())
    assert compared >= len(q)
