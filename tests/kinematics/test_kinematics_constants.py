from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhgen.kinematics.constants import ConstantTable
from dhgen.kinematics.expressions import multiple_of_pi
from dhgen.kinematics.normal import normal_form
from dhgen.robot.arithmetic import parse
from dhgen.robot.expression import Binary, Call, Expression, Name, Negate, Number, Pi
from tests.kinematics.values import number


def whole(value: int) -> Expression:
    return Number(Fraction(abs(value))) if value >= 0 else Negate(Number(Fraction(-value)))


def times_pi(numerator: int, denominator: int) -> Expression:
    return Binary("/", Binary("*", whole(numerator), Pi()), whole(denominator))


def closed(*angles: Expression, **parameters: float) -> ConstantTable:
    table = ConstantTable(parameters)
    for angle in angles:
        table.cosine_sine(angle, "1", "twist 1")
    table.close()
    return table


@pytest.mark.parametrize("steps", range(-30, 31))
def test_multiples_of_fifteen_degrees_are_exact(steps: int) -> None:
    angle = times_pi(steps, 12)
    table = closed(angle)
    cosine, sine = table.cosine_sine(angle, "1", "twist 1")
    assert {constant.name for constant in table.constants.values()} <= {"sqrt2", "sqrt3"}
    values = {constant.name: constant.value for constant in table.constants.values()}
    assert number(cosine, values) == pytest.approx(math.cos(steps * math.pi / 12), abs=1e-14)
    assert number(sine, values) == pytest.approx(math.sin(steps * math.pi / 12), abs=1e-14)
    normal = normal_form(cosine.ring, table.constants.values(), {})
    assert normal(cosine**2 + sine**2) == cosine.ring.one


@pytest.mark.parametrize(
    ("steps", "cosine", "sine"), [(0, 1, 0), (6, 0, 1), (12, -1, 0), (18, 0, -1), (-6, 0, -1)]
)
def test_right_angles_need_no_constant(steps: int, cosine: int, sine: int) -> None:
    angle = times_pi(steps, 12)
    table = closed(angle)
    assert table.constants == {}
    assert table.cosine_sine(angle, "1", "twist 1") == (cosine, sine)


def test_cosine_of_75_degrees_is_that_of_the_school_book() -> None:
    table = closed(times_pi(5, 12))
    cosine, _ = table.cosine_sine(times_pi(5, 12), "1", "twist 1")
    root2, root3 = cosine.ring.gens
    assert [symbol.name for symbol in cosine.ring.symbols] == ["sqrt2", "sqrt3"]
    assert 4 * cosine == root2 * root3 - root2  # (sqrt 6 - sqrt 2) / 4


@given(st.integers(-720, 720).filter(lambda degrees: degrees % 15))
def test_other_angles_get_a_named_pair_that_says_its_value(degrees: int) -> None:
    angle = times_pi(degrees, 180)
    table = closed(angle)
    assert set(table.constants) == {"ca1", "sa1"}
    cosine, sine = table.cosine_sine(angle, "1", "twist 1")
    values = {constant.name: constant.value for constant in table.constants.values()}
    assert number(cosine, values) == pytest.approx(math.cos(math.radians(degrees)), abs=1e-14)
    assert number(sine, values) == pytest.approx(math.sin(math.radians(degrees)), abs=1e-14)
    assert values["ca1"] >= 0
    assert values["sa1"] >= 0
    assert table.constants["sa1"].cosine == "ca1"


def test_twists_of_one_size_share_their_pair() -> None:
    twenty, minus_twenty, many = (times_pi(degrees, 180) for degrees in (20, -20, 160))
    table = ConstantTable({})
    for name, angle in (("1", twenty), ("2", minus_twenty), ("3", many)):
        table.cosine_sine(angle, name, f"twist {name}")
    assert set(table.constants) == {"ca1", "sa1"}
    table.close()
    cosine, sine = table.cosine_sine(twenty, "1", "twist 1")
    assert table.cosine_sine(minus_twenty, "2", "twist 2") == (cosine, -sine)
    assert table.cosine_sine(many, "3", "twist 3") == (-cosine, sine)


@pytest.mark.parametrize(
    ("angle", "expected"),
    [
        (times_pi(1, 3), Fraction(1, 3)),
        (Binary("-", Pi(), times_pi(1, 4)), Fraction(3, 4)),
        (Binary("/", Negate(Pi()), whole(2)), Fraction(-1, 2)),
        (whole(0), Fraction(0)),
        (whole(1), None),  # one radian
        (Binary("*", Pi(), Pi()), None),
        (Binary("/", Pi(), whole(0)), None),
        (Name("a"), None),
    ],
)
def test_multiples_of_pi(angle: Expression, expected: Fraction | None) -> None:
    assert multiple_of_pi(angle) == expected


def test_lengths_keep_the_names_of_parameters_and_numbers_get_one() -> None:
    table = ConstantTable({"a": 0.5, "b": 0.25})
    cells: list[tuple[Expression, str]] = [
        (Name("a"), "a1"),
        (Binary("-", Name("a"), Binary("*", whole(2), Name("b"))), "a2"),
        (Number(Fraction(3, 10)), "a3"),
        (whole(0), "a4"),
        (Binary("*", Name("a"), Call("cos", Name("b"))), "a5"),
    ]
    for cell, name in cells:
        table.length(cell, name, name)
    ring = table.close()
    a, b, a3, *_ = ring.gens
    found = [table.length(cell, name, name) for cell, name in cells]
    assert found[:4] == [a, a - 2 * b, a3, ring.zero]
    assert table.constants["a3"].value == 0.3
    values = {constant.name: constant.value for constant in table.constants.values()}
    assert number(found[4], values) == pytest.approx(0.5 * math.cos(0.25))


@pytest.mark.parametrize(
    ("cell", "value"),
    [
        ("0.4 + 0.0001", 0.4001),
        ("-(150/2 - 3*0.5)/1000", -0.0735),
        ("0.3**2 + 0.1", 0.19),
        ("sqrt(4)/10", 0.2),
        ("0.1 + 0.2", 0.3),
    ],
)
def test_a_length_of_several_numbers_is_one_number(cell: str, value: float) -> None:
    table = ConstantTable({})
    table.length(parse(cell, {}), "a1", "link length 1")
    (generator,) = table.close().gens
    assert table.length(parse(cell, {}), "a1", "link length 1") == generator
    (constant,) = table.constants.values()
    assert (constant.name, constant.value, constant.meaning) == ("a1", value, "link length 1")


def test_roots_and_parameters_stay_what_they_are() -> None:
    table = ConstantTable({"p": 0.5})
    for cell in ("sqrt(2)/4 + 0.1", "2*p", "0.4 - 0.2*2"):
        table.length(parse(cell, {"p": 0.5}), "a1", "link length 1")
    assert set(table.constants) == {"sqrt2", "p"}


def root(value: int) -> Expression:
    return Call("sqrt", whole(value))


def test_roots_are_those_of_two_and_three() -> None:
    # the entries of a frame that is turned by 15 degrees
    cell = Binary("/", Binary("+", root(6), root(2)), whole(4))
    table = ConstantTable({})
    table.scalar(cell, "z11", "base frame, entry 1,1")
    assert set(table.constants) == {"sqrt2", "sqrt3"}
    root2, root3 = table.close().gens
    assert 4 * table.scalar(cell, "z11", "base frame, entry 1,1") == root2 * root3 + root2


@pytest.mark.parametrize(
    ("cell", "value"),
    [
        (Binary("/", root(15), whole(4)), math.sqrt(15) / 4),
        (Binary("-", whole(1), Binary("/", root(2), root(5))), 1 - math.sqrt(0.4)),
    ],
)
def test_a_name_is_that_of_the_whole_number(cell: Expression, value: float) -> None:
    table = ConstantTable({})
    table.scalar(cell, "e11", "tool frame, entry 1,1")
    table.length(cell, "a2", "link length 2")
    found = {name: constant.meaning for name, constant in table.constants.items()}
    assert found == {"e11": "tool frame, entry 1,1", "a2": "link length 2"}
    assert [constant.value for constant in table.constants.values()] == [pytest.approx(value)] * 2


def test_a_number_beside_a_parameter_is_called_a_part() -> None:
    shared = Binary("/", Name("b"), root(3))
    table = ConstantTable({"a": 0.5, "b": 0.25})
    table.length(Binary("-", Negate(Name("a")), shared), "d4", "joint offset 4")
    table.length(Negate(shared), "d5", "joint offset 5")
    meanings = {name: table.constants[name].meaning for name in ("d4", "d5")}
    assert meanings == {"d4": "part of joint offset 4", "d5": "joint offset 5"}


def test_a_shared_number_means_every_cell_that_has_it() -> None:
    tenth, b = Number(Fraction(1, 10)), Name("b")
    cells: dict[str, Expression] = {
        "link length 1": tenth,
        "link length 2": Binary("+", b, tenth),
        "link length 3": Binary("-", b, tenth),
        "link length 4": tenth,
    }
    table = ConstantTable({"b": 0.3})

    for closing in (table.close, lambda: None):
        lengths = [table.length(cell, f"a{of[-1]}", of) for of, cell in cells.items()]
        closing()
    meanings = {name: each.meaning for name, each in table.constants.items()}
    shared = "link length 1, part of link length 2 and part of link length 3"
    assert meanings == {"a1": shared, "b": "link length 2", "a4": "link length 4"}
    # as the meanings say, by which lengths change where the number does
    values = {"a1": 0.2, "b": 0.3, "a4": 0.1}
    assert [number(each, values) for each in lengths] == pytest.approx([0.2, 0.5, 0.1, 0.1])


def test_a_parameter_never_takes_the_name_of_another_generator() -> None:
    # r2 is the length of a slide, wx a coordinate of a point, sqrt2 a number
    names = ["r2", "wx", "sqrt2", "c1m2", "unit", "r2_"]
    table = ConstantTable({name: 0.5 + place for place, name in enumerate(names)})
    for name in names:
        table.length(Name(name), "a1", "link length 1")
    found = {name: constant.value for name, constant in table.constants.items()}
    expected = [("r2__", 0.5), ("wx_", 1.5), ("sqrt2_", 2.5), ("c1m2_", 3.5), ("unit_", 4.5)]
    assert found == {**dict(expected), "r2_": 5.5}


def test_two_angles_of_one_cell_do_not_share_a_pair() -> None:
    # an entry of a roll-pitch-yaw matrix: cos(20 deg) cos(0.01)
    cell = Binary("*", Call("cos", times_pi(20, 180)), Call("cos", Number(Fraction(1, 100))))
    table = ConstantTable({})
    table.scalar(cell, "e11", "entry")
    table.close()
    values = {constant.name: constant.value for constant in table.constants.values()}
    expected = math.cos(math.radians(20)) * math.cos(0.01)
    assert number(table.scalar(cell, "e11", "entry"), values) == pytest.approx(expected, abs=1e-15)


def test_a_number_never_takes_the_name_of_a_parameter() -> None:
    table = ConstantTable({"a1": 0.5})
    table.length(Number(Fraction(1, 5)), "a1", "link length 1")
    assert table.constants["a1_"].value == 0.2


def test_numbers_of_one_size_that_are_added_to_parameters_cancel() -> None:
    """Heights 0.4, 0.4 + b and 0.4 + b + g are b and g apart; -0.4 - b takes the second back."""
    values = {"b": 0.3, "g": 0.2}
    cells = "0.4", "0.4 + b", "0.4 + b + g", "-0.4 - b"
    table = ConstantTable(values)
    for close in (True, False):
        first, second, third, back = (
            table.length(parse(cell, values), f"p{place}z", f"z of axis {place}")
            for place, cell in enumerate(cells, start=1)
        )
        link = table.length(parse("g + 0.4", values), "a1", "link length 1")
        scaled = table.length(parse("0.4*(b + g)", values), "a2", "link length 2")
        if close:
            ring = table.close()
    p1z, b, g, a1 = ring.gens
    assert [first, second - first, third - second, second + back] == [p1z, b, g, ring.zero]
    assert link == g + a1
    assert scaled == (b + g) * ring.domain(2, 5)
