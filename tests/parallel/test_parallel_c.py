"""The committed C of parallel robots: without warnings as C99 and as C++14, and sanitized."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from typing import TYPE_CHECKING

import pytest

from tests.parallel.made import GENERATED, NAMES, written
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

WARNINGS = (
    *("-pedantic-errors", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion"),
    *("-Wcast-qual", "-Wundef", "-Werror", f"-I{GENERATED}"),
)
COMPILERS = [name for name in ("gcc", "clang", "g++", "clang++") if shutil.which(name)]
# Poses of a robot at random, most of them out of reach; every function is called.
DRIVER = """\
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "{name}.h"
int main(void)
{{
    static double q[{upper}_LEGS][{upper}_ROWS][{upper}_JOINTS];
    static double nearest[{upper}_LEGS][{upper}_JOINTS];
    static unsigned char status[{upper}_LEGS][{upper}_ROWS];
    static double driven[{upper}_LEGS * {upper}_ROWS * {upper}_DOF];
    double drives[{upper}_DOF], A[36], B[36], least[2], found[16];
    int modes = 0, closed = 0;
    for (int k = 0; k < 3000; k++) {{
        double T[16] = {{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }};
        for (int i = 3; i < 12; i += 4)
            T[i] = 2.0 * rand() / RAND_MAX - 1.0;
        T[0] = k == 7 ? NAN : T[0];
        T[3] = k == 8 ? INFINITY : T[3];
        {name}_ik_drives_batch(1, T, driven, &status[0][0]);
        if ({name}_ik(T, NULL, q, status) <= 0)
            continue;
        modes++;
        {name}_ik_batch(1, T, &q[0][0][0], &status[0][0]);
        for (int i = 0; i < {upper}_LEGS; i++)
            for (int j = 0; j < {upper}_JOINTS; j++)
                nearest[i][j] = 0.1;
        if ({name}_ik_nearest(T, nearest[0], nearest) < 0)
            continue;
        {name}_take_drives(nearest[0], drives);
        closed += {name}_fk(drives, T, found, nearest) >= 0;
        {name}_velocities(T, nearest[0], A, B);
        {name}_singularities(T, nearest[0], least);
        {all}
    }}
    return modes > 5 && closed > 5 ? 0 : 1;
}}
"""
ALL = "double poses[6][16]; modes += {name}_assemblies(drives, poses) < 0;"


def told(*command: str) -> str:
    """What a command says, and its exit status if that is not 0."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return f"{done.returncode or ''}{done.stderr}{done.stdout}"


@pytest.mark.parametrize("compiler", COMPILERS)
def test_there_are_no_warnings(compiler: str) -> None:
    """Some warnings take what is inlined: of every robot by one compiler."""
    standard = ("-x", "c++", "-std=c++14") if compiler.endswith("++") else ("-std=c99",)
    for place, name in enumerate(NAMES):
        optimised = COMPILERS[place % len(COMPILERS)] == compiler
        how = ("-O2", "-c", "-o", os.devnull) if optimised else ("-fsyntax-only",)
        assert told(compiler, *standard, *WARNINGS, *how, str(GENERATED / f"{name}.c")) == ""


@pytest.mark.skipif(platform.machine() != "x86_64", reason="vectors of x86")
@pytest.mark.parametrize("compiler", [name for name in COMPILERS if not name.endswith("++")])
def test_there_are_none_where_a_chain_has_fewer_legs_than_there_are_lanes(compiler: str) -> None:
    path = written("unequal_five_bar") / "unequal_five_bar.c"
    for vectors in ("-mavx2", "-mavx512f"):
        how = ("-std=c99", "-O2", vectors, "-c", "-o", os.devnull)
        assert told(compiler, *WARNINGS, *how, str(path)) == ""


@pytest.mark.skipif(not shutil.which("gcc"), reason="no gcc")
@pytest.mark.parametrize("name", first_of(["parallel_3rpr", "delta", "stewart"]))
def test_sanitizers_find_nothing(name: str, tmp_path: Path) -> None:
    has_all = "_assemblies(" in (GENERATED / f"{name}.h").read_text(encoding="utf-8")
    every = ALL.format(name=name) if has_all else ""
    driver = tmp_path / "driver.c"
    driver.write_text(DRIVER.format(name=name, upper=name.upper(), all=every), encoding="utf-8")
    sources = (str(driver), *(str(GENERATED / f"{each}.c") for each in (name, f"{name}_leg")))
    flags = (
        "-std=c99",
        "-pedantic-errors",
        "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all",
    )
    program = str(tmp_path / "driver")
    assert told("gcc", *flags, f"-I{GENERATED}", *sources, "-o", program, "-lm") == ""
    assert told(program) == ""
