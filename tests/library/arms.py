"""What the library's tests load."""

from __future__ import annotations

from typing import Any

PLANAR: dict[str, Any] = {
    "name": "two_links",
    "title": "Two links | in a plane",
    "parameters": {"a1": 0.4, "a2": 0.3},
    "joints": [
        {"theta": "q", "a": "a1", "limits": ["-160 deg", "160 deg"]},
        {"theta": "q - pi/2", "a": "a2"},
    ],
    "task": ["x", "y"],
}
