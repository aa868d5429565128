"""Every notation, written and read by Python and C, against rotations from their definitions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from tests.pose import pose_reference as reference
from tests.pose.pose_libraries import NOTATIONS, library, numba_or, read, write

if TYPE_CHECKING:
    from collections.abc import Sequence

each_library = pytest.mark.parametrize("name", ["plain", "c"])
each_notation = pytest.mark.parametrize("notation", NOTATIONS)

XYZ = np.array([0.3, -250.0, 1e-3])
SPECIAL_ANGLES = [
    quarter * np.pi / 4 + offset for quarter in range(-4, 5) for offset in (0.0, 1e-12, -1e-9, 1e-6)
]


def orientations(notation: str) -> list[tuple[Any, ...]]:
    """Arguments of a notation: random ones, then special ones."""
    random = np.random.default_rng(7)
    if notation.startswith("quaternion"):
        ones = [np.array(q) for q in np.ndindex(3, 3, 3, 3)]
        special = [q - 1.0 for q in ones if (q != 1).any()]
        return [(q,) for q in [*random.normal(size=(60, 4)), *special]]
    if notation == "axis_angle":
        axes = [*random.normal(size=(20, 3)), *np.eye(3), -np.eye(3)[1], np.array([0.0, 3.0, -4.0])]
        angles = [*random.uniform(-7, 7, 5), *SPECIAL_ANGLES]
        return [(axis, float(angle)) for axis in axes for angle in angles]
    special = [random.choice(SPECIAL_ANGLES, 3) for _ in range(200)]
    return [(angles,) for angles in [*random.uniform(-7, 7, (60, 3)), *special]]


def alike(found: Any, wanted: Any, tolerance: float) -> None:
    """Compared at once: one by one that took longer than what is compared."""
    np.testing.assert_allclose(np.array(found), np.array(wanted), rtol=0, atol=tolerance)


def flat(arguments: Sequence[Any]) -> Any:
    """Arrays and numbers in a row."""
    return np.concatenate([np.ravel(each) for each in arguments])


@each_library
@each_notation
def test_writing_follows_the_definition(name: str, notation: str) -> None:
    of, asked = library(name), orientations(notation)
    T = np.array([write(of, notation, XYZ, *orientation) for orientation in asked])
    alike(T, defined(notation, asked), 2e-15)
    assert (T[:, :3, 3] == XYZ).all()
    assert (T[:, 3] == [0, 0, 0, 1]).all()


def defined(notation: str, asked: Sequence[tuple[Any, ...]]) -> list[Any]:
    """The poses of orientations by their definition."""
    return [reference.pose(getattr(reference, notation)(*each), XYZ) for each in asked]


@each_library
@each_notation
def test_what_is_read_defines_the_pose_again(name: str, notation: str) -> None:
    of = library(name)
    singular = [R for _, R in reference.singular_rotations()]
    rotations = [*reference.random_rotations(100), *singular]
    T = [reference.pose(R, XYZ) for R in rotations]
    found = [read(of, notation, each) for each in T]
    alike(defined(notation, [tuple(orientation) for _, *orientation in found]), T, 2e-15)
    assert all((xyz == XYZ).all() for xyz, *_ in found)


@pytest.mark.parametrize(("name", "notation"), numba_or("c"))
def test_all_read_and_write_what_plain_python_does(notation: str, name: str) -> None:
    plain, other = library("plain"), library(name)
    found, wanted = [], []
    for R in [
        *reference.random_rotations(100, seed=2),
        *dict(reference.singular_rotations()).values(),
    ]:
        T = reference.pose(R, XYZ)
        expected = read(plain, notation, T)
        found += [flat(read(other, notation, T)), flat(write(other, notation, *expected))]
        wanted += [flat(expected), flat(write(plain, notation, *expected))]
    alike(np.concatenate(found), np.concatenate(wanted), 1e-15)


@each_library
@each_notation
def test_rotations_with_rounding_of_their_own_survive(name: str, notation: str) -> None:
    """A pose out of a chain of products is not the nearest double of any rotation."""
    of = library(name)
    rng = np.random.default_rng(5)
    found, wanted = [], []
    for _ in range(100):
        chain = [
            reference.pose(R) for R in reference.random_rotations(4, seed=int(rng.integers(10**9)))
        ]
        product = chain[0] @ chain[1] @ chain[2] @ chain[3]
        for end in (np.linalg.inv(product), np.eye(4)):
            T = product @ end
            found.append(write(of, notation, *read(of, notation, T)))
            wanted.append(T)
    alike(found, wanted, 1e-14)


@each_library
@each_notation
@pytest.mark.parametrize("digits", ["float32", "six decimals"])
def test_a_rounded_pose_is_read_to_within_its_rounding(
    name: str, notation: str, digits: str
) -> None:
    of, found, wanted = library(name), [], []
    for R in [*reference.random_rotations(50), *dict(reference.singular_rotations()).values()]:
        T = reference.pose(R)
        rounded = T.astype(np.float32) if digits == "float32" else T.round(6)
        found.append(write(of, notation, *read(of, notation, rounded)))
        wanted.append(T)
    alike(found, wanted, 3e-7 if digits == "float32" else 3e-6)


@each_library
def test_away_from_singularities_the_angles_themselves_return(name: str) -> None:
    of = library(name)
    random = np.random.default_rng(3)
    for _ in range(100):
        outer = random.uniform(-np.pi, np.pi, 2)
        rpy = np.array([outer[0], random.uniform(-1.4, 1.4), outer[1]])
        np.testing.assert_allclose(of.to_xyz_rpy(of.from_xyz_rpy(XYZ, rpy))[1], rpy, atol=1e-14)
        euler = np.array([outer[0], random.uniform(0.2, 2.9), outer[1]])
        for notation in ("euler_zxz", "euler_zyz"):
            T = write(of, notation, XYZ, euler)
            np.testing.assert_allclose(read(of, notation, T)[1], euler, atol=1e-14)
