"""No value takes a name that something else has, in any program or target."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from dhgen.program.building.builder import Builder
from dhgen.program.ir import Let
from dhgen.program.reserved import NOTHING
from dhgen.program.role import Source
from dhgen.runtime import c_runtime_files
from dhgen.targets.reserved import RESERVED
from tests.derivation.stories import NAMES, story
from tests.program.emitted_names import (
    OF_THE_RUNTIME,
    in_printers,
    in_python_templates,
    of_arrays,
    of_c_templates,
    of_generated_c,
    of_helpers,
    of_python_files,
    of_python_functions,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.ir import Program


def names(program: Program) -> list[str]:
    """Every name that a program gives."""
    lets = [s.name for s in program.body if isinstance(s, Let)]
    return lets + [c.name for c in program.constants] + [axis.name for axis in program.axes]


@pytest.mark.parametrize("robot", NAMES)
def test_names_are_unique_and_free(robot: str) -> None:
    given = names(story(robot).program)
    assert len(given) == len(set(given))
    assert not RESERVED.values & set(given)
    assert all(re.fullmatch(r"[A-Za-z]\w*", name) for name in given)


def test_the_same_wish_twice() -> None:
    builder = Builder(RESERVED.with_own({"taken"}))
    nodes = [
        builder.name(builder.apply("sqrt", builder.pose(1, column)), "taken") for column in (1, 2)
    ]
    program = builder.finish("t", {"q1": nodes[0], "q2": nodes[1]}, [])
    given = names(program)
    assert len(set(given)) == 2
    assert "taken" not in given


@pytest.mark.parametrize("name", ["status", "row", "turn", "solve", "e1", "T11", "k1"])
def test_a_constant_of_a_name_in_use(name: str) -> None:
    builder = Builder(RESERVED.with_own({name, name + "_"}))
    nodes = [
        builder.constant(each, value, "a test", role=Source.ARM)
        for each, value in ((name, 1.5), (name + "_", 2.5), (name, 1.5))
    ]
    assert nodes[0] == nodes[2]
    nodes = [builder.mul(node, builder.pose(2, column)) for column, node in enumerate(nodes[:2], 1)]
    sign = builder.sign(("left", "right"), 1)
    squares = builder.mul(builder.add(*nodes), builder.mul(sign, builder.pose(1, 1)))
    program = builder.finish("t", {"q1": squares}, [])
    assert sorted(c.value for c in program.constants) == [1.5, 2.5]
    given = names(program)
    assert len(given) == len(set(given))
    assert not RESERVED.values & set(given)


def test_what_emitted_code_has_of_its_own_is_reserved() -> None:
    """A constant of such a name would be hidden by it, or hide it, and a value likewise."""
    assert {"solve", "kind", "own", "given_shares"} <= of_c_templates()
    assert not _not_reserved(of_c_templates())
    used = (of_generated_c() | of_python_functions()) & (in_printers() | in_python_templates())
    assert {"entries", "joints", "half_turn", "kept"} <= used
    of_programs = {name for robot in NAMES for name in names(story(robot).program)}
    assert not _not_reserved(used) - of_programs


def test_what_is_at_file_level_is_kept_from_constants() -> None:
    used = of_python_files() | of_helpers()
    assert {"METHOD", "globals", "exec", "LEGS"} <= used
    assert not {name for name in used if not RESERVED.is_kept_from_constants(name)}


def test_no_name_is_reserved_that_nothing_has() -> None:
    used = of_c_templates() | of_generated_c() | of_arrays() | of_python_functions()
    assert not RESERVED.values - used
    assert not RESERVED.constants - used - of_python_files() - of_helpers()


def _not_reserved(used: Iterable[str]) -> set[str]:
    """Those of names that are free; of `outside1` the printers have only the word."""
    kept = RESERVED.is_kept_from_constants
    return {
        name
        for name in used
        if name not in RESERVED.values and not kept(name) and not kept(f"{name}1")
    }


# Names of <math.h>, which the compiler for GPUs does not have: there the runtime defines them.
STANDARD = {"HUGE_VAL", "HUGE_VALF", "INFINITY", "NAN"}


def test_the_runtime_has_names_of_its_own() -> None:
    """Functions, types, values and macros begin with its prefix, which no constant does."""
    found: set[str] = set()
    for text in c_runtime_files().values():
        code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
        found |= set(re.findall(r"#define (\w+)", code))
        found |= set(re.findall(r"^[A-Z]\w+ [\w ]*?\*?(\w+)\(", code, re.MULTILINE))
        types = re.sub(r"__attribute__.*?(?=;)|__typeof__\(.*\)", "", code)
        found |= set(
            re.findall(r"^typedef [\w *]*?(?:\(\*)?(\w+)\)?\s*[(;](?!\*)", types, re.MULTILINE)
        )
        found |= set(re.findall(r"^struct (\w+) \{", code, re.MULTILINE))
        for values in re.findall(r"^enum \{(.*?)\}", code, re.DOTALL | re.MULTILINE):
            found |= set(re.findall(r"^\s*(\w+)", values, re.MULTILINE))
    assert {"dhgen_turned", "dhgen_four", "dhgen_arm", "DHGEN_OK", "DHGEN_FN"} <= found
    assert {name for name in found if not OF_THE_RUNTIME.match(name)} == STANDARD
    builder = Builder(RESERVED)
    length = builder.constant("dhgen_four", 0.4, "a length", role=Source.ARM)
    program = builder.finish("t", {"q1": builder.mul(length, builder.pose(1, 1))}, [])
    assert [constant.name for constant in program.constants] == ["dhgen_four_"]


def test_a_tolerance_of_a_name_that_the_arm_has() -> None:
    builder = Builder(RESERVED.with_own({"free_limit"}))
    own = builder.constant("free_limit", 0.4, "link length", role=Source.ARM)
    limit = builder.constant("free_limit", 1e-12, "a tolerance")
    product = [builder.mul(node, builder.pose(1, 1)) for node in (own, limit)]
    program = builder.finish("t", {"q1": product[0], "q2": product[1]}, [])
    assert {c.name: c.value for c in program.constants} == {"free_limit": 0.4, "free_limit_": 1e-12}


def test_which_names_are_kept_is_for_the_targets_to_say() -> None:
    for reserved, value, constant in ((NOTHING, "row", "globals"), (RESERVED, "row_", "globals_")):
        builder = Builder(reserved)
        length = builder.constant("globals", 0.4, "a length")
        node = builder.name(builder.mul(length, builder.pose(1, 1)), "row")
        program = builder.finish("t", {"q1": builder.apply("sqrt", node)}, [])
        assert names(program) == [value, "q1", constant]
