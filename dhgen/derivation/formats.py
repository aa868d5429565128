"""A derivation in the format that is asked for, with the files that belong to it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation import derivation_files, derivation_terminal
from dhgen.derivation.handouts import derivation_html, derivation_latex

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.nominal.nominal import Nominal
    from dhgen.paul.derivation import Derivation
    from dhgen.program.ir import Program
    from dhgen.robot.robot import Robot


def derivation_as(
    wished: str,
    robot: Robot,
    derivation: Derivation,
    program: Program,
    source: str,
    nominal: Nominal | None = None,
) -> tuple[str, Mapping[str, str]]:
    """The document, and texts of files beside it by their paths.

    Args:
        wished: `text`, `markdown`, `latex` or `html`.
        robot: As the user wrote it.
        derivation: The steps.
        program: What computes them.
        source: How the robot file is called.
        nominal: The nearest arm with a structure, where its rows are tried first.

    Raises:
        CommandError: A package is missing that the format needs.
    """
    match wished:
        case "markdown":
            files = derivation_files(robot, derivation, program, source, nominal)
            return files.pop(f"{robot.name}.md"), files
        case "latex":
            return derivation_latex(robot, derivation, program, source, nominal), {}
        case "html":
            return derivation_html(robot, derivation, program, source, nominal), {}
        case _:
            return derivation_terminal(robot, derivation, program, nominal) + "\n", {}
