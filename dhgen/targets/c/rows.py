"""C that writes the rows of one pose out of lanes: joint values, statuses, and how many are OK."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.layout import INDENT, wrapped

if TYPE_CHECKING:
    from dhgen.program.ir import Expression
    from dhgen.targets.c.lanes import LaneText

WORD = 8  # rows whose statuses fill a machine word


def store_places(count: int) -> list[tuple[int, int]]:
    """From which of a row's joint values on how many are written: four, then two, then one.

    Three that are left are written with the one before them once more.
    """
    full, left = divmod(count, 4)
    places = [(4 * place, 4) for place in range(full)]
    if full and left == 3:
        return [*places, (count - 4, 4)]
    sizes = [2] * (left // 2) + [1] * (left % 2)
    return places + [(4 * full + sum(sizes[:k]), size) for k, size in enumerate(sizes)]


def stores(text: LaneText, group: tuple[Expression, ...], rows: list[int]) -> list[str]:
    """Statements that write the joint values of four rows.

    Args:
        text: Prints expressions.
        group: The joint values.
        rows: The row of each lane.
    """
    lines = []
    for place, size in store_places(len(group)):
        parts = ", ".join(text.vector(value) for value in group[place : place + size])
        where = ", ".join(_from("q", len(group) * row + place) for row in rows)
        lines += wrapped(f"{INDENT}dhgen_store_{size}({where}, {parts});", INDENT)
    return lines


def _from(array: str, place: int) -> str:
    """An array from a place on."""
    return f"{array} + {place}" if place else array


def status_lines(
    count: int, rows: list[list[int]], nones: list[str], outsides: list[str]
) -> list[str]:
    """Statements that write the statuses and return how many rows are OK.

    Bits of lanes become bytes of a word: the product with a sum of powers of two has each bit in
    its byte, among others, which are masked off.

    Args:
        count: How many rows there are.
        rows: For each group the row of each lane; several lanes may belong to one row.
        nones: For each group the mask of lanes without a solution.
        outsides: For each group the mask of lanes outside the limits; empty without limits.
    """
    lines: list[str] = []
    oks = []
    for first in range(0, count, WORD):
        none, outside = f"none{first // WORD + 1}", f"outside{first // WORD + 1}"
        lines += _word(none, first, rows, nones)
        word = f"{none} * DHGEN_UNREACHABLE"
        fine = f"~{none}"
        if outsides:
            lines += _word(outside, first, rows, outsides)
            word = f"{word} + ({outside} & ~{none}) * DHGEN_OUT_OF_LIMITS"
            fine = f"~({none} | {outside})"
        status = f"kind{first // WORD + 1}"
        lines += wrapped(f"{INDENT}const unsigned long long {status} = {word};", INDENT)
        size = min(WORD, count - first)
        lines.append(f"{INDENT}__builtin_memcpy({_from('status', first)}, &{status}, {size});")
        bytes_ = sum(1 << WORD * byte for byte in range(size))
        oks.append(f"__builtin_popcountll({bytes_:#x}ull & {fine})")
    return [*lines, *wrapped(f"{INDENT}return {' + '.join(oks)};", INDENT)]


def _word(name: str, first: int, rows: list[list[int]], masks: list[str]) -> list[str]:
    """A word with a byte for each row, from the first: 1 where the mask of its lane is set."""
    places: dict[str, dict[int, int]] = {}  # of a mask the lane of each byte
    for group, mask in zip(rows, masks, strict=True):
        for lane, row in enumerate(group):
            if first <= row < first + WORD:
                places.setdefault(mask, {}).setdefault(row - first, lane)
    parts = []
    for mask, lanes in places.items():
        moved = max(0, *(lane - WORD * byte for byte, lane in lanes.items()))
        factor = sum(1 << (WORD * byte - lane + moved) for byte, lane in lanes.items())
        bits = sum(1 << WORD * byte for byte in lanes)
        product = f"dhgen_bits_four({mask}) * {factor:#x}ull" + (f" >> {moved}" if moved else "")
        parts.append(f"({product} & {bits:#x}ull)")
    return wrapped(f"{INDENT}const unsigned long long {name} = {' | '.join(parts)};", INDENT)
