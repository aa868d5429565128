"""The constants of a robot's programs, with comments on what they are."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from dhgen.printing.comments import plain
from dhgen.program.role import Source

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.program.ir import NamedConstant, Program
    from dhgen.program.role import Role
    from dhgen.targets.module import SolverModule


_WORD = re.compile(r"\w+")


@dataclass(frozen=True, slots=True)
class ConstantText:
    """A constant as it is written.

    Attributes:
        name: Its name.
        value: Its value.
        comment: What it is; empty where its name is enough.
        role: What it is, as data.
        parts: The constants that the comment names, each with its value.
    """

    name: str
    value: str
    comment: str
    role: Role
    parts: tuple[tuple[str, str], ...] = ()


def constant_texts(module: SolverModule, others: tuple[Program, ...] = ()) -> list[ConstantText]:
    """Every constant, of all programs and others, that the files do not define anyway."""
    return texts_of(module, [*module.programs, *others])


def texts_of(module: SolverModule, programs: Iterable[Program]) -> list[ConstantText]:
    """Every constant of some programs that the files do not define anyway."""
    own = [constant.name for constant in module.chain.constants]
    constants = _naming_others(_merged(programs, own))
    unit = module.length_unit
    return [
        ConstantText(c.name, repr(c.value), _comment(c, unit), c.role, _parts(c, unit))
        for c in constants
        if c.role is not Source.FILE
    ]


def made_of(constants: Sequence[ConstantText], above: Sequence[ConstantText]) -> list[str]:
    """What formulas name that is a constant neither here nor above, with its value.

    Whoever checks a coefficient finds every number of its formula. No code needs them.

    Returns:
        A sentence in pieces that must not be broken; empty if there is none.
    """
    known = {each.name for each in (*constants, *above)}
    known |= {name for each in above for name, _ in each.parts}
    roles = {name: text for each in constants for name, text in each.parts if name not in known}
    if not roles:
        return []
    *others, last = roles.values()
    first, *rest = [*(f"{text}," for text in others), f"{last}."]
    return [f"In formulas below, {first}", *rest]


def _merged(programs: Iterable[Program], own: Sequence[str]) -> tuple[NamedConstant, ...]:
    """The constants of several programs, each once: the arm's own in their order come first."""
    places = {name: place for place, name in enumerate(own)}
    merged: dict[str, NamedConstant] = {}
    for program in programs:
        for constant in program.constants:
            merged.setdefault(constant.name, constant)

    def order(constant: NamedConstant) -> tuple[bool, int]:
        return constant.role is not Source.ARM, places.get(constant.name, len(places))

    return tuple(sorted(merged.values(), key=order))


def _naming_others(constants: Iterable[NamedConstant]) -> list[NamedConstant]:
    """Constants whose meanings name earlier constants instead of repeating what these mean."""
    done: list[NamedConstant] = []
    for constant in constants:
        meaning = constant.meaning
        for other in done:
            repeated = rf"(\w?)\({re.escape(other.meaning)}\)"
            if other.meaning:
                meaning = re.sub(repeated, partial(_named, name=other.name), meaning)
        done.append(replace(constant, meaning=meaning))
    return done


def _named(found: re.Match[str], name: str) -> str:
    """A name in place of what was in brackets; a function keeps its brackets."""
    return f"{found[1]}({name})" if found[1] else name


def _parts(constant: NamedConstant, length: str) -> tuple[tuple[str, str], ...]:
    """The parts that its formula still names, since constants may be named for what they mean.

    Behind one that has a formula itself are those that this names.
    """
    words = set(_WORD.findall(constant.meaning))
    found: list[tuple[str, str]] = []
    for part in constant.parts:
        if part.name in words and part.role is not Source.FILE:
            found.append(
                (part.name, f"{part.name} = {_made(part)}{part.value!r}{_unit(part, length)}")
            )
            found += _parts(part, length)
    return tuple(found)


def _made(part: NamedConstant) -> str:
    """The formula of a part, if all that it names are parts themselves."""
    named = {word for word in _WORD.findall(part.meaning) if not word.isdigit()}
    known = {each.name for each in part.parts}
    return f"{part.meaning} = " if named and named <= known else ""


def _comment(constant: NamedConstant, length: str) -> str:
    if not constant.meaning:
        return ""
    return plain(constant.meaning + _unit(constant, length))


def _unit(constant: NamedConstant, length: str) -> str:
    units = {0: "", 1: f" [{length}]"}
    return units.get(constant.power, f" [{length}^{constant.power}]")
