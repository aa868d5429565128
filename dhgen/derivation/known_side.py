"""A known matrix whose long entries get letters: M = U_0 A_7^-1 ... A_4^-1, or U_3 before a wrist.

Once the joints in it are known, the steps that are left read hardly anything else of the pose. With
letters for its entries most of their equations are a line.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import left_name
from dhgen.derivation.notation.names import letter, pose_letter
from dhgen.derivation.text.formula import Symbol, minus
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.walk import occurs
from dhgen.kinematics.ring import content, primitive

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Matrix
    from dhgen.paul.step import Step

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
        letters: Their letters for a writer of polynomials: with positive first coefficients.
    """

    place: Matrix
    after: int
    symbol: Formula
    entries: tuple[tuple[Polynomial, Symbol], ...]
    letters: Mapping[Polynomial, Formula]

    @property
    def entry(self) -> Symbol:
        """u_ij, any of the letters."""
        own = self.entries[0][1].text[0]
        return Symbol(f"{own}_{{ij}}", f"{own}ᵢⱼ")

    def is_one_joint_before(self, place: Matrix) -> bool:
        """Whether a form is this matrix M with one joint more on its side, M A_3^-1."""
        m, k, *other = place
        return self.place == (m, k + 1, *other)


def find_known_side(story: Story) -> KnownSide | None:
    """The matrix that makes the steps shortest; None where none shortens more than one of them."""
    found = [side for place in _candidates(story) if (side := _known_side(story, *place))]
    return min(found, key=lambda side: _length(story, side), default=None)


def _known_side(story: Story, place: Matrix, after: int) -> KnownSide | None:
    """A matrix with its letters, where more than one step is shorter with them."""
    mixed = place[1] < story.dof
    own = _free_letter(story, "mghkv" if mixed else "ughkv")
    capital = _free_letter(story, "MNV")
    if own is None or capital is None:
        return None
    symbol: Formula = letter(capital, capital) if mixed else left_name(place, story.dof)
    entries = {
        entry: letter(own, own, f"{row + 1}{column + 1}")
        for column in range(3)
        for row in range(3)
        if _is_sum(entry := story.form(place).left.entry(row, column))
    }
    letters = dict(_facing(entry, symbol) for entry, symbol in entries.items())
    users, used = _uses(story, after, letters, set(entries.values()))
    kept = tuple((entry, name) for entry, name in entries.items() if name in used)
    if users < OFTEN or max(len(entry) for entry, _ in kept) < LONG:
        return None
    return KnownSide(place, after, symbol, kept, dict(_facing(*each) for each in kept))


def _length(story: Story, side: KnownSide) -> int:
    """Characters of the steps' equations and of the letters' definitions."""
    texts = [story.written_with(entry, {}) for entry, _ in side.entries]
    for number, step in enumerate(story.steps, start=1):
        known = side.letters if number > side.after else {}
        texts += [story.written_with(each, known) for each in _polynomials(story, number, step)]
    return sum(len(show(text, PLAIN)) for text in texts)


def _polynomials(story: Story, number: int, step: Step) -> list[Polynomial]:
    """The known sides of a step's equations, and its coefficients."""
    quotes = story.quotes[number - 1]
    sides = [each.right if each.joints_left else each.left for each in quotes]
    return [*sides, *(value for _, value in step.coefficients)]


def _candidates(story: Story) -> Iterator[tuple[Matrix, int]]:
    """Matrices from which a step moves one joint, all others known; the step before that one."""
    seen: set[Matrix] = set()
    for number, step in enumerate(story.steps, start=1):
        for origin in step.origins:
            m, k, inverted, shoulder = origin.matrix
            if inverted or shoulder:
                continue
            moved = [*range(1, m + 1), *range(k + 1, story.dof + 1)]
            left = [joint for joint in moved if not story.is_known(joint, number - 1)]
            places = {(m,): (m - 1, k), (k + 1,): (m, k + 1)}
            place = places.get(tuple(left)) if left else None
            if place is None or (*place, False, False) in seen:
                continue
            seen.add((*place, False, False))
            yield (*place, False, False), number - 1


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
        held = {
            name
            for polynomial in _polynomials(story, number, step)
            for name in names
            if occurs(name, story.written_with(polynomial, letters))
        }
        users += bool(held)
        used |= held
    return users, used


def _free_letter(story: Story, wished: str) -> str | None:
    """The first that begins no other letter of the arm."""
    begun = {each.text[0] for each in story.letters.values()} | {pose_letter(story.letters)}
    return next((each for each in wished if each not in begun), None)
