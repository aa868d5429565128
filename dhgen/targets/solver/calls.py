"""How functions are called, as far as every language has to say it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Calls:
    """How the values that the caller gives are handed on.

    Attributes:
        free_parameter: They among parameters.
        free_argument: They among arguments.
    """

    free_parameter: str
    free_argument: str
