"""The general algorithm's C by its functions: what numpy.linalg and definitions say of the same.

These share no formula with the runtime: determinants by LU, null vectors by singular values, roots
of a polynomial by the eigenvalues of its companion matrix.
"""

from __future__ import annotations

import ctypes
import re
import subprocess
import tempfile
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.general import hidden_slide
from dhgen.runtime import c_runtime_files
from dhgen.runtime.python.general import (
    attempts,
    candidates,
    circle,
    equations,
    four_turns,
    loop,
    moebius,
    recover,
    refine,
    roots,
    rows,
    tables,
    wrist,
)
from dhgen.runtime.python.numerical import descent, family, solutions
from dhgen.verify.native import c_compiler
from tests.structures import first_of

if TYPE_CHECKING:
    from types import ModuleType

DRIVER = Path(__file__).with_name("general.c.txt")
BUILDS = ("-DDHGEN_GENERAL_LANES=1", "", "-march=native")
RNG_SEEDS = range(20)


@cache
def library(build: str) -> ctypes.CDLL:
    folder = Path(tempfile.mkdtemp())
    write_files(folder, {"driver.c": DRIVER.read_text("utf-8"), **c_runtime_files()})
    strict = ("-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Werror")
    flags = ("-std=c99", "-O1", "-pedantic-errors", *strict, *build.split(), "-shared", "-fPIC")
    command = [str(c_compiler()), *flags, "driver.c", "-o", "driver.so", "-lm"]
    subprocess.run(command, check=True, cwd=folder)
    found = ctypes.CDLL(str(folder / "driver.so"))
    found.run_newton.restype = found.run_order_of.restype = ctypes.c_double
    return found


def pointer(array: np.ndarray) -> ctypes.c_void_p:
    return array.ctypes.data_as(ctypes.c_void_p)


def blocks(E: np.ndarray, angle: float) -> np.ndarray:
    """The six equations at a hidden angle, (6, 3, 3): by the powers of x3 and of x2, falling."""
    at = np.array([1.0, np.cos(angle), np.sin(angle)])
    # columns 9 a + 3 j + i: powers of x3 (i) and of x2 (j)
    equations = E.reshape(6, 32)[:, :27].reshape(6, 3, 3, 3)
    return np.asarray(np.einsum("rajk,a->rkj", equations, at))


def eliminant(E: np.ndarray, angle: float) -> np.ndarray:
    """The equations and x3 times the equations, by x3^3 ... 1 and x2^2, x2, 1: (12, 12)."""
    M = blocks(E, angle).reshape(6, 9)
    return np.block([[M, np.zeros((6, 3))], [np.zeros((6, 3)), M]])


@pytest.mark.parametrize("build", first_of(BUILDS))
def test_the_determinant_is_that_of_numpy_but_for_a_sign(build: str) -> None:
    signs = set()
    for seed in RNG_SEEDS:
        rng = np.random.default_rng(seed)
        E, angle = rng.normal(size=192), rng.uniform(-np.pi, np.pi)
        found, factor = np.zeros(1), np.zeros((6, 6))
        library(build).run_determinant(
            pointer(E), ctypes.c_double(angle), pointer(found), pointer(factor)
        )
        ratio = found[0] / np.linalg.det(eliminant(E, angle))
        assert abs(abs(ratio) - 1.0) < 1e-9
        signs.add(np.sign(ratio))
    assert len(signs) == 1  # the same everywhere: zeros and changes of sign are the determinant's


@pytest.mark.parametrize("build", BUILDS)
def test_a_null_vector_of_the_factor_is_one_of_the_matrix(build: str) -> None:
    for seed in RNG_SEEDS:
        rng = np.random.default_rng(seed)
        E, angle = rng.normal(size=192), rng.uniform(-np.pi, np.pi)
        x2, x3 = rng.normal(size=2)
        powers = np.kron([x3**2, x3, 1.0], [x2**2, x2, 1.0])
        M = blocks(E, angle).reshape(6, 9)
        # equations that have this solution: what they miss is taken off their constant term
        E.reshape(6, 32)[:, 8] -= M @ powers
        found, factor, vectors, regular = (
            np.zeros(1),
            np.zeros((6, 6)),
            np.zeros((2, 6)),
            np.ones(1),
        )
        own = library(build)
        own.run_determinant(pointer(E), ctypes.c_double(angle), pointer(found), pointer(factor))
        own.run_smallest(pointer(factor), pointer(vectors), pointer(regular))
        assert not regular[0]
        null = np.kron([x3, 1.0], [x2**2, x2, 1.0])
        along = abs(vectors[0] @ null) / np.linalg.norm(null)
        assert abs(along - 1.0) < 1e-9
        _, singular, right = np.linalg.svd(eliminant(E, angle))
        assert singular[-1] < 1e-12 * singular[0]
        full = np.kron([x3**3, x3**2, x3, 1.0], [x2**2, x2, 1.0])
        assert abs(abs(right[-1] @ full) / np.linalg.norm(full) - 1.0) < 1e-9


@pytest.mark.parametrize("build", BUILDS)
def test_the_smallest_vectors_are_the_last_singular_ones(build: str) -> None:
    for seed in RNG_SEEDS:
        rng = np.random.default_rng(seed)
        factor = np.triu(rng.normal(size=(6, 6))) + np.diag(np.full(6, 2.0))
        left, _, right = np.linalg.svd(factor)
        factor = np.linalg.qr(left @ np.diag([9.0, 8.0, 7.0, 6.0, 1e-3, 1e-6]) @ right)[1]
        vectors, regular = np.zeros((2, 6)), np.zeros(1)
        library(build).run_smallest(
            pointer(np.ascontiguousarray(factor)), pointer(vectors), pointer(regular)
        )
        own = np.linalg.svd(factor)[2][-2:]
        assert regular[0] == 0.0  # the smallest is 7e-8 of all
        np.testing.assert_allclose(abs(own[1] @ vectors[0]), 1.0, atol=1e-9)
        unit = vectors[1] / np.linalg.norm(vectors[1])
        np.testing.assert_allclose(np.linalg.norm(own @ unit), 1.0, atol=1e-6)


def trigonometric_roots(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Real roots, sorted, of sum a cos mx + b sin mx by numpy's roots of a polynomial in e^ix."""
    c = (a[1:] - 1j * b[1:]) / 2
    z = np.roots([*c[::-1], a[0], *np.conj(c)])
    return np.sort(np.angle(z[np.abs(np.abs(z) - 1.0) < 1e-7]))


@pytest.mark.parametrize("build", BUILDS)
def test_roots_are_those_of_the_companion_matrix(build: str) -> None:
    counts = set()
    for seed in range(60):
        rng = np.random.default_rng(seed)
        a, b = rng.normal(size=(2, 9))
        a[0] += rng.uniform(-6.0, 6.0)
        b[0] = 0.0
        cosines, sines, complete = np.zeros(24), np.zeros(24), ctypes.c_int()
        coefficients = np.concatenate([a, b])
        count = library(build).run_roots(
            pointer(coefficients), pointer(cosines), pointer(sines), ctypes.byref(complete)
        )
        assert complete.value
        found = np.sort(np.arctan2(sines[:count], cosines[:count]))
        np.testing.assert_allclose(found, trigonometric_roots(a, b), atol=1e-8)
        counts.add(count)
    assert {0, 16} & counts
    assert len(counts) > 4


@pytest.mark.parametrize("build", BUILDS)
def test_steps_solve_the_linear_equations(build: str) -> None:
    for seed in RNG_SEEDS:
        rng = np.random.default_rng(seed)
        J = rng.normal(size=(6, 7))
        J[:, 6] *= 0.1
        exact = np.linalg.solve(J[:, :6], J[:, 6])
        if np.abs(exact).max() > 1.0:  # longer steps are cut
            continue
        x = np.zeros(6)
        pivot = library(build).run_newton(pointer(J), pointer(x))
        np.testing.assert_allclose(x, exact, atol=1e-11)
        assert 0.0 < pivot < 1.0
        A, damping = J[:, :6], 0.03
        library(build).run_damped(pointer(J), ctypes.c_double(damping), pointer(x))
        damped = np.linalg.solve(A.T @ A + damping * np.eye(6), A.T @ J[:, 6])
        np.testing.assert_allclose(x, damped, atol=1e-12)


def monomials(p: np.ndarray, l: np.ndarray) -> np.ndarray:
    last = (p @ p) * l - 2.0 * (p @ l) * p
    return np.concatenate([[1.0], l, p, [p @ p, p @ l], np.cross(p, l), last])


def motion(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return R * np.sign(np.linalg.det(R)), rng.normal(size=3)


@pytest.mark.parametrize("build", BUILDS)
def test_monomials_move_with_the_point_and_the_direction(build: str) -> None:
    for seed in RNG_SEEDS:
        rng = np.random.default_rng(seed)
        R, t = motion(rng)
        p, l = rng.normal(size=(2, 3))
        x = monomials(p, l)
        K = np.ascontiguousarray(np.c_[R, t].ravel())
        library(build).run_act(pointer(K), pointer(x))
        np.testing.assert_allclose(x, monomials(R @ p + t, R @ l), atol=1e-12)


def turn(p: np.ndarray, angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]])


@pytest.mark.parametrize("build", BUILDS)
def test_joints_turn_and_slide_monomials(build: str) -> None:
    ez = np.array([0.0, 0.0, 1.0])
    cosine, sine = hidden_slide.ADVANCE
    for seed in RNG_SEEDS:
        rng = np.random.default_rng(seed)
        p, l = rng.normal(size=(2, 3))
        angle, d = rng.uniform(-3.0, 3.0), rng.normal()
        x, parts = monomials(p, l), np.zeros((3, 15))
        turned = monomials(turn(p, angle), turn(l, angle))
        slid = monomials(p + d * ez, l)
        t = np.tan(angle / 2)
        psi = 2.0 * np.arctan(d / hidden_slide.UNIT)  # with the advance
        c, s = np.cos(psi), np.sin(psi)
        expected = (
            ([1.0, np.cos(angle), np.sin(angle)], turned),
            ([t * t, t, 1.0], (1.0 + t * t) * turned),
            ([1.0, d, d * d], slid),
            ([d * d, d, 1.0], slid),
            ([1.0, c * cosine + s * sine, s * cosine - c * sine], (1.0 + c) * slid),
        )
        for kind, (terms, value) in enumerate(expected):
            library(build).run_in_terms(kind, pointer(x), pointer(parts))
            np.testing.assert_allclose(np.array(terms) @ parts, value, rtol=1e-11, atol=1e-11)


# Where the Python runtime has the numbers of C's macros, with what C makes of them.
SHARED = {
    circle: ("ROOTS DEEPEST OPEN_CELLS SETTLED QUINTIC FOURFOLD", {"CELL_HALVINGS": "HALVINGS"}),
    refine: (
        "STEPS_FROM_AFAR GOOD_ENOUGH RANK SMALLEST_SQUARE",
        {"LOOP_STEPS": "STEPS", "LOOP_DAMPING": "DAMPING"},
    ),
    candidates: (
        "PLACES",
        {
            "SAME_SOLUTION": "SAME",
            "SINGULAR_TOGETHER": "TOGETHER",
            "SINGULAR_PIVOT": "SINGULAR",
            "NEARLY_SINGULAR_PIVOT": "NEARLY_SINGULAR",
            "ALMOST_PI": "ALMOST_PI",
        },
    ),
    attempts: ("BESIDE PARABOLAS", {"CLOSE_PAIR": "CLOSE_SQUARE", "CANDIDATES": "ANGLES"}),
    four_turns: (
        "NEARLY_FLAT ALONG FARTHEST MOVED NO_ANGLE PARALLEL",
        {"ALIGNED_AXES": "ALIGNED"},
    ),
    moebius: ("STRONGEST MEAN_PER_HARMONIC", {}),
    recover: ("SMALLEST PLANE", {}),
    roots: (
        "NOISE CLEAR VANISHING ROUNDING NOISE_FACTOR LOOKS STRENGTH REACH LIFTED_CLOSER",
        {
            "LOOK_COSINE": "NEAR_COSINE",
            "WITHIN_COSINE": "WITHIN_COSINE",
            "ASIDE_COSINE": "ASIDE_COSINE",
            "LIFTED": "LIFTED_BY",
            "INDEPENDENT": "INDEPENDENT",
        },
    ),
    wrist: ("NEARLY_RIGHT BARELY", {}),
    equations: ("", {"HIDDEN_UNIT": "UNIT", "HIDDEN_SQUARE": "SQUARE"}),
    tables: ("SAMPLES CELLS HALF_CELLS WIDTH", {}),
    loop: ("TINY", {}),
    descent: (
        "SOLUTION PULLED_STEPS PULL",
        {
            "SMALL_SINE": "ASIDE",
            "DESCENT_DAMPING": "DAMPING",
            "DAMPING_FLOOR": "FLOOR",
            "SLOW_MISS": "NEARLY",
            "DESCENT_STEPS": "STEPS",
            "PULL_SETTLED": "SETTLED",
        },
    ),
    solutions: (
        "NEIGHBOURS STEPS_ASIDE FEELER FELT TIE",
        {
            "STAYING_PART": "STAYS",
            "SINGULAR_LENGTH": "SINGULAR",
        },
    ),
    family: (
        "WALK_STEP WALK_STEPS WALK_CLOSED LEAST_STEPS LEAST_SETTLED EQUALLY_NEAR MEMBER_TIE",
        {},
    ),
    rows: ("NEARLY_NONE", {"FEW_STARTS": "STARTS", "NEARLY_NONE_IN_DOUBT": "NEARLY_NONE_IN_DOUBT"}),
}


def macros() -> dict[str, float]:
    """Every number of the C, of the two arithmetics double precision."""
    files = c_runtime_files()
    double = [
        text.split("\n#else\n")[0] if "TOLERANCES_H" in text else text for text in files.values()
    ]
    text = "\n".join(double)
    found = re.findall(r"#define DHGEN_(\w+) \(?(-?[\d.]+(?:e[+-]?\d+)?)\)?\n", text)
    return {name: float(value) for name, value in found}


@pytest.mark.parametrize("module", SHARED)
def test_its_numbers_are_those_of_the_runtime_in_python(module: ModuleType) -> None:
    """Both decide alike."""
    same, renamed = SHARED[module]
    for macro, name in {**{each: each for each in same.split()}, **renamed}.items():
        assert macros()[macro] == getattr(module, name), macro


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("dhgen_harmonics", tables.HARMONICS),
        ("dhgen_grid_c", tables.GRID_C),
        ("dhgen_grid_s", tables.GRID_S),
        ("dhgen_sample_c", tables.SAMPLE_C),
        ("dhgen_sample_s", tables.SAMPLE_S),
        ("dhgen_nudge", tables.NUDGES),
        ("dhgen_starts", tables.STARTS),
    ],
)
def test_its_tables_are_those_of_the_runtime_in_python(name: str, expected: np.ndarray) -> None:
    text = "\n".join(c_runtime_files().values())
    found = re.search(rf"DHGEN_TABLE double {name}\[.*?=(.*?);", text, re.DOTALL)
    assert found is not None
    numbers = re.findall(r"-?[\d.]+(?:e[+-]?\d+)?", found[1])
    np.testing.assert_array_equal(np.array(numbers, dtype=float), expected.ravel())


@pytest.mark.parametrize("build", BUILDS)
def test_directions_of_angles_are_within_two_units_in_the_last_place(build: str) -> None:
    source = np.random.default_rng(5)
    quarters = np.arange(-9, 10) * (np.pi / 2.0)
    beside = (quarters[:, None] + np.array([-1e-3, -1e-9, 0.0, 1e-9, 1e-3])).ravel()
    angles = np.concatenate([beside, source.uniform(-15.0, 15.0, 2000), [1e-300, -0.0]])
    found = np.empty((2, len(angles)))
    cosine, sine = ctypes.c_double(), ctypes.c_double()
    for place, angle in enumerate(angles):
        library(build).run_direction(
            ctypes.c_double(angle), ctypes.byref(cosine), ctypes.byref(sine)
        )
        found[:, place] = cosine.value, sine.value
    expected = np.array([np.cos(angles), np.sin(angles)])
    units = np.maximum(np.spacing(np.abs(expected)), 2.0**-56)
    assert np.abs((found - expected) / units).max() <= 2.0
