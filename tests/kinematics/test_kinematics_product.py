"""Reduced products against what the documents print."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.kinematics.product import product, reversed_elements
from tests.kinematics.values import algebra_of, joint_values, matrix, table
from tests.robots.cases import robot


def whole(name: str) -> tuple[str, ...]:
    algebra = algebra_of(robot(name))
    elements = algebra.lifted(tuple(e for link in algebra.chain.links for e in link))
    forward = product(elements, algebra)
    return tuple(str(forward.entry(row, column)) for row in range(3) for column in range(4))


def test_planar_arm_as_printed_in_document_000() -> None:
    # T with c123, s123 and a1 c1 + a2 c12 + a3 c123 in the fourth column
    assert whole("planar_rrr") == (
        *("c123", "-s123", "0", "c1*a1 + c12*a2 + c123*a3"),
        *("s123", "c123", "0", "s1*a1 + s12*a2 + s123*a3"),
        *("0", "0", "1", "0"),
    )


def test_scara_as_printed_in_document_003() -> None:
    assert whole("scara_rrp") == (
        *("c12", "-s12", "0", "c1*a1 + c12*a2"),
        *("s12", "c12", "0", "s1*a1 + s12*a2"),
        *("0", "0", "1", "r3 + d1"),
    )


def test_the_wrist_of_document_004() -> None:
    # T36 = Rz(q4) Ry(q5) Rz(q6), column 4 zero
    algebra = algebra_of(robot("rrprrr"))
    wrist = algebra.lifted(tuple(e for link in algebra.chain.links[3:] for e in link))
    entries = [
        product(wrist, algebra).entry(row, column) for row in range(3) for column in range(4)
    ]
    c4, s4, c5, s5, c6, s6 = (
        algebra.generator(name) for name in ("c4", "s4", "c5", "s5", "c6", "s6")
    )
    assert entries == [
        *(c4 * c5 * c6 - s4 * s6, -c4 * c5 * s6 - s4 * c6, c4 * s5, 0),
        *(s4 * c5 * c6 + c4 * s6, -s4 * c5 * s6 + c4 * c6, s4 * s5, 0),
        *(-s5 * c6, s5 * s6, c5, 0),
    ]


ANTIPARALLEL = table(
    "{theta: q, d: 0, a: a1, alpha: pi}"[1:-1],
    "{theta: q, d: 0, a: a2, alpha: 0}"[1:-1],
    "{theta: q, d: 0, a: a3, alpha: 0}"[1:-1],
    parameters="{a1: 0.5, a2: 0.25, a3: 0.125}",
)


def test_antiparallel_axes_reduce_to_differences() -> None:
    algebra = algebra_of(ANTIPARALLEL)
    assert [angle.suffix for angle in algebra.angles] == ["1", "1m2", "1m2m3", "2", "23", "3"]
    elements = algebra.lifted(tuple(e for link in algebra.chain.links for e in link))
    forward = product(elements, algebra)
    # by hand: Rz(t1) Tx(a1) Rx(pi) Rz(t2) Tx(a2) Rz(t3) Tx(a3) in the plane
    assert [str(entry) for entry in forward.translation] == [
        "c1*a1 + c1m2*a2 + c1m2m3*a3",
        "s1*a1 + s1m2*a2 + s1m2m3*a3",
        "0",
    ]
    assert [str(row[0]) for row in forward.rotation] == ["c1m2m3", "s1m2m3", "0"]
    assert [str(row[2]) for row in forward.rotation] == ["0", "0", "-1"]


def test_names_of_sums_stay_apart_beyond_nine_joints() -> None:
    planar = table(*["theta: q, a: 0.1"] * 12, free="[1, 2, 3, 4, 5, 6]")
    suffixes = [angle.suffix for angle in algebra_of(planar).angles]
    assert len(set(suffixes)) == len(suffixes) == 12 * 13 // 2
    assert {"9_10", "12", "_12", "_11_12"} <= set(suffixes)


@pytest.mark.parametrize("name", ["puma560", "ur5", "stanford", "puma", "scara"])
def test_every_stretch_times_its_inverse_is_nothing(name: str) -> None:
    algebra = algebra_of(robot(name))
    links = [algebra.lifted(link) for link in algebra.chain.links]
    q = np.random.default_rng(4).uniform(-1, 1, len(links))
    values = joint_values(algebra, q)
    for start in range(len(links)):
        for end in range(start + 1, len(links) + 1):
            stretch = [element for link in links[start:end] for element in link]
            there = matrix(product(stretch, algebra), values)
            back = matrix(product(reversed_elements(stretch, algebra), algebra), values)
            np.testing.assert_allclose(there @ back, np.eye(4), atol=1e-14)
