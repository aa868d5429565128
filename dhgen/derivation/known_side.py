"""A known matrix whose long entries get letters: M = U_0 A_7^-1 ... A_4^-1, or U_3 before a wrist.

Once the joints in it are known, the steps that are left read nothing else of the pose. With letters
for its entries each of their equations is a line.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import left_name
from dhgen.derivation.notation.names import letter, pose_letter, single
from dhgen.derivation.text.formula import minus
from dhgen.derivation.text.walk import occurs
from dhgen.kinematics.ring import content, primitive

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula, Symbol
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Matrix
    from dhgen.paul.knowledge import Knowledge

LONG = 3  # terms of an entry that is worth a letter; then all that are sums have one
OFTEN = 2  # steps that have to use the letters


@dataclass(frozen=True, slots=True)
class KnownSide:
    """A matrix with a letter for each of its entries that the steps use.

    Attributes:
        place: The form whose known side it is.
        after: The number of the step after which all of it is known.
        symbol: M, or U_m where no joint was moved from the right.
        entries: The used ones, column by column, and their letters.
        letters: The same for a writer of polynomials: with positive first coefficients.
    """

    place: Matrix
    after: int
    symbol: Formula
    entries: tuple[tuple[Polynomial, Symbol], ...]
    letters: Mapping[Polynomial, Formula]


def find_known_side(story: Story) -> KnownSide | None:
    """The first such matrix that shortens more than one step; None where there is none."""
    for place, after in _candidates(story):
        mixed = place[1] < story.dof
        symbol: Formula = letter("M", "M") if mixed else left_name(place, story.dof)
        own = _free_letter(story, "m" if mixed else "u")
        entries = {
            entry: letter(own, own, f"{row + 1}{column + 1}")
            for column in range(3)
            for row in range(3)
            if _is_sum(entry := story.form(place).left.entry(row, column))
        }
        letters = dict(_facing(entry, symbol) for entry, symbol in entries.items())
        users, used = _uses(story, after, letters, set(entries.values()))
        kept = tuple((entry, name) for entry, name in entries.items() if name in used)
        if users >= OFTEN and max(len(entry) for entry, _ in kept) >= LONG:
            known = dict(_facing(*each) for each in kept)
            return KnownSide(place, after, symbol, kept, known)
    return None


def _candidates(story: Story) -> Iterator[tuple[Matrix, int]]:
    """Matrices from which a step moves one joint, all others known; the step before that one."""
    seen: set[Matrix] = set()
    for number, step in enumerate(story.steps, start=1):
        state = story.knowledge[number - 1]
        for origin in step.origins:
            m, k, inverted, shoulder = origin.matrix
            if inverted or shoulder:
                continue
            moved = [*range(1, m + 1), *range(k + 1, story.dof + 1)]
            left = [joint for joint in moved if not _is_known(story, state, joint)]
            places = {(m,): (m - 1, k), (k + 1,): (m, k + 1)}
            place = places.get(tuple(left)) if left else None
            if place is None or (*place, False, False) in seen:
                continue
            seen.add((*place, False, False))
            yield (*place, False, False), number - 1


def _is_known(story: Story, state: Knowledge, joint: int) -> bool:
    if joint in story.algebra.slides:
        return joint in state.slides
    return state.knows(single(joint))


def _is_sum(entry: Polynomial) -> bool:
    return len(entry) > 1 and not any(content(entry)[0])


def _facing(entry: Polynomial, symbol: Symbol) -> tuple[Polynomial, Formula]:
    return (entry, symbol) if primitive(entry)[0] > 0 else (-entry, minus(symbol))


def _uses(
    story: Story, after: int, letters: Mapping[Polynomial, Formula], names: set[Symbol]
) -> tuple[int, set[Symbol]]:
    """How many of the later steps hold letters, and which."""
    users, used = 0, set()
    for number, step in enumerate(story.steps[after:], start=after + 1):
        quotes = story.quotes[number - 1]
        sides = (each.right if each.joints_left else each.left for each in quotes)
        held = {
            name
            for polynomial in (*sides, *(value for _, value in step.coefficients))
            for name in names
            if occurs(name, story.written_with(polynomial, letters))
        }
        users += bool(held)
        used |= held
    return users, used


def _free_letter(story: Story, wished: str) -> str:
    """One that begins no other letter of the arm."""
    begun = {each.text[0] for each in story.letters.values()} | {pose_letter(story.letters)}
    return next(each for each in (wished, "g", "k", "v") if each not in begun)
