"""Material names for files that allow letters, digits and underscores only."""

from __future__ import annotations

import re
from collections.abc import Sequence

_NOT_A_NAME = re.compile(r"[^A-Za-z0-9_]+")


def material_name(name: str) -> str:
    """Return a paint's name as that of a material.

    >>> material_name("Blue, 2nd try")
    'Blue_2nd_try'
    """
    return _NOT_A_NAME.sub("_", name).strip("_") or "paint"


def material_names(names: Sequence[str]) -> list[str]:
    """Return a material's name for each paint, no two alike.

    >>> material_names(["blue", "blue"])
    ['blue', 'blue_2']
    """
    found: list[str] = []
    for name in names:
        wanted = base = material_name(name)
        number = 1
        while wanted in found:
            number += 1
            wanted = f"{base}_{number}"
        found.append(wanted)
    return found
