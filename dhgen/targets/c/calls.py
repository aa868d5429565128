"""Prototypes of C functions, and how they call each other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.walk import finds_roots
from dhgen.targets.layout import INDENT, call
from dhgen.targets.solver.calls import Calls

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Prototypes:
    """Functions without their bodies.

    Attributes:
        ik: All solutions of a pose.
        careful: The same of one that is rounded, singular or none.
        nearest: The solution next to a seed.
        batch: All solutions of many poses.
        solve: The programs' rows.
        choose: Another value for a joint whose choice led to no solution.
        keep: Another value for a joint whose choice led beyond limits.
    """

    ik: str
    careful: str
    nearest: str
    batch: str
    solve: str
    choose: str
    keep: str


@dataclass(frozen=True, slots=True)
class CCalls(Calls):
    """How functions are called.

    Attributes:
        search_given: The values that the caller gives, in a search.
        batch: All solutions of pose k.
        tile: Those of poses side by side, from k on.
        tile_again: Those of pose i, which was none of theirs.
    """

    search_given: str
    batch: str
    tile: str
    tile_again: str


def c_prototypes(module: SolverModule) -> Prototypes:
    """The functions of a robot."""
    name, dof, rows = module.name, module.chain.dof, module.solver.rows
    pose, free = "const double T[16]", _free(module)
    table = [f"double q[{rows}][{dof}]", f"unsigned char status[{rows}]"]
    moved = ["double moved"] if finds_roots(module.solver) else []
    batch_free = ["const double *free_joints"] if free else []
    batch = ["size_t n", "const double *T", *batch_free, "double *q", "unsigned char *status"]
    seed = f"const double q_seed[{dof}]"
    inputs = [pose, *free, "const double *q_seed", *table]
    of_a_row = [pose, *free, f"const double seed[{dof}]", "int row", *table]
    solved = [pose, *free, f"const double seed[{dof}]", *moved, *table]
    return Prototypes(
        ik=call(f"int {name}_ik", inputs, ""),
        careful=call("APART int ik_carefully", inputs, ""),
        nearest=call(f"int {name}_ik_nearest", [pose, *free, seed, f"double q[{dof}]"], ""),
        batch=call(f"void {name}_ik_batch", batch, ""),
        solve=call("static void solve", solved, ""),
        choose=call("static void choose_again", of_a_row, ""),
        keep=call("static void keep_limits", of_a_row, ""),
    )


def c_calls(module: SolverModule) -> CCalls:
    """How the functions of a robot are called."""
    name, dof, rows = module.name, module.chain.dof, module.solver.rows
    count, free = module.chain.given, _free(module)
    given = ["free_joints"] if count else []

    def inputs_at(k: str) -> list[str]:
        return [_part("T", 16, k), *(_part(each, count, k) for each in given)]

    def one(k: str) -> list[str]:
        table = f"(double (*)[{dof}])({_part('q', rows * dof, k)})"
        return [*inputs_at(k), "NULL", table, _part("status", rows, k)]

    def tile(k: str) -> list[str]:
        return [*inputs_at(k), _part("q", rows * dof, k), _part("status", rows, k)]

    return CCalls(
        free_parameter="".join(f", {each}" for each in free),
        free_argument="".join(f", {each}" for each in given),
        search_given=", .free_joints = free_joints" if count else "",
        batch=call(f"(void){name}_ik", one("k"), ";", INDENT * 2),
        tile=call("solve_tile", tile("k"), ""),
        tile_again=call(f"(void){name}_ik", one("i"), ";", INDENT * 4),
    )


def _free(module: SolverModule) -> list[str]:
    """The parameter with the values that the caller gives, if there are any."""
    count = module.chain.given
    return [f"const double free_joints[{count}]"] if count else []


def _part(array: str, size: int, place: str) -> str:
    """Where the part of an array begins that is one of several of a size."""
    return f"{array} + {place}" if size == 1 else f"{array} + {size} * {place}"
