"""The options of an import."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Wishes:
    """The options of an import.

    Attributes:
        base: The base link, or None for the usual one.
        tip: The tip link, or None for the usual one.
        snap: What is nearer to an exact value is taken as that [rad, and arm sizes]; None for
            `DEFAULT` and `NEGLIGIBLE`.
        as_axes: Whether the file is to hold axes in place of a table.
        free: Joints, from 1, whose values are to be given, in ascending order, or `ARM_ANGLE`; None
            for the usual ones.
    """

    base: str | None = None
    tip: str | None = None
    snap: float | None = None
    as_axes: bool = False
    free: tuple[int, ...] | str | None = None
