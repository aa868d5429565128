"""Why no order of equations solves an arm: how far it went, what was in the way."""

from __future__ import annotations

import math
from collections import Counter
from typing import TYPE_CHECKING

from dhgen.general.arm import is_general
from dhgen.kinematics.neighbours import EXACT, axis_triples, missed_point, short_number
from dhgen.paul.form import unknown_name
from dhgen.paul.types import CLOSED

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.neighbours import Triple
    from dhgen.paul.form import Form, Unknown
    from dhgen.paul.knowledge import Knowledge
    from dhgen.paul.search import Search
    from dhgen.paul.step import EquationType, View


MOST_GROUPS = 3
MOST_REASONS = 5  # lines for one group
PLACES_SHOWN = 3
NO_PAIR = "no two of these are in the same row or column"
NO_PASSIVE = "the general algorithm for six joints would solve the arm without passive row{} {}"
NUMERICAL = "--numerical would give the solutions that damped least squares finds from many starts"
NEARLY_PARALLEL = math.radians(5.0)
NEARLY_CONCURRENT = 0.15  # of the arm's size


def refusal(search: Search, chain: Chain) -> str:
    """Why an arm is not solved, in at most 25 lines."""
    state = search.deepest
    open_joints = chain.named(state.open_joints)
    lines = [
        f"no order of equations solves for every joint; still unknown: {open_joints}",
        *_nearest(search, state),
        *missed_structure(chain),
        *held_back(chain),
        NUMERICAL,
    ]
    return "\n".join(lines)


def held_back(chain: Chain) -> list[str]:
    """What keeps the general algorithm from an arm of the kind that it solves."""
    if not is_general(chain) or not chain.passive:
        return []
    rows = ", ".join(row.label for row in chain.passive)
    return [NO_PASSIVE.format("s" * (len(chain.passive) > 1), rows)]


def _nearest(search: Search, state: Knowledge) -> list[str]:
    """The forms with the fewest unknowns by what they hold, and why no type takes them."""
    fewest = (search.forms(state, most) for most in range(1, state.missing + 1))
    by_unknowns: dict[tuple[Unknown, ...], list[Form]] = {}
    for form in next(filter(None, fewest), []):
        by_unknowns.setdefault(form.unknowns, []).append(form)
    by_reasons: dict[tuple[str, ...], list[str]] = {}
    for unknowns, alike in list(by_unknowns.items())[:MOST_GROUPS]:
        what = f"  {', '.join(map(unknown_name, unknowns))} in {_places(alike)}"
        by_reasons.setdefault(_reasons(search, alike, search.view(state)), []).append(what)
    lines = [_known(state)]
    for reasons, held in by_reasons.items():
        lines += [*held, *reasons]
    left = len(by_unknowns) - MOST_GROUPS
    return [*lines, f"  and {left} more sets of as few unknowns"] if left > 0 else lines


def _known(state: Knowledge) -> str:
    algebra = state.runs.algebra
    names = [unknown_name(angle) for angle in algebra.angles if state.knows(angle)]
    names += [name for joint, name in algebra.slides.items() if joint in state.slides]
    if not names:
        return "no equation can be solved first; those with the fewest unknowns contain"
    return f"with {', '.join(names)} known, the equations with the fewest unknowns contain"


def _places(forms: Sequence[Form]) -> str:
    shown = ", ".join(form.equation.origin.name for form in forms[:PLACES_SHOWN])
    left = len(forms) - PLACES_SHOWN
    return f"{shown} and {left} more" if left > 0 else shown


def _reasons(search: Search, forms: list[Form], view: View) -> tuple[str, ...]:
    """One line for each reason, with the types that give it; the usual one of each type."""
    singles = [(form,) for form in forms]
    pairs = [group for group, _ in search.groups(forms) if len(group) == 2]
    types_of: dict[str, list[str]] = {}
    for equation_type in CLOSED:
        groups: Sequence[tuple[Form, ...]] = singles if equation_type.arity == 1 else pairs
        offers = (equation_type.steps(group, view) for group in groups)
        reasons = Counter(offer for offer in offers if isinstance(offer, str))
        usual = max(reasons, key=reasons.__getitem__, default=NO_PAIR)
        types_of.setdefault(usual, []).append(_number(equation_type))
    return tuple(
        f"    type {numbers[0]}: {reason}"
        if len(numbers) == 1 and numbers[0].isdigit()
        else f"    types {', '.join(numbers)}: {reason}"
        for reason, numbers in list(types_of.items())[:MOST_REASONS]
    )


def _number(equation_type: EquationType) -> str:
    return equation_type.name.removeprefix("types ").removeprefix("type ")


def missed_structure(chain: Chain, unit: str = "") -> list[str]:
    """Which three axes are parallel or concurrent, and which nearly are; `unit` is of lengths."""
    texts = (_describe(triple, chain.size, unit) for triple in axis_triples(chain))
    described = [text for text in texts if text]
    if not described:
        return ["no three consecutive axes are parallel or meet in one point, not even nearly"]
    head = "three axes that are parallel or meet in one point can allow a closed form:"
    return [head, *(f"  {text}" for text in described)]


def _describe(triple: Triple, size: float, unit: str) -> str:
    """By how much three axes miss being parallel or concurrent; empty where that is much."""
    axes = "axes " + ", ".join(map(str, triple.joints))
    if triple.tilt < EXACT:
        return f"{axes} are parallel"
    if triple.miss < EXACT * size:
        return f"{axes} meet in one point"
    if triple.miss < NEARLY_CONCURRENT * size:
        return missed_point(triple, unit)
    if triple.tilt < NEARLY_PARALLEL:
        return f"{axes} are {short_number(math.degrees(triple.tilt), 3)} deg from parallel"
    return ""
