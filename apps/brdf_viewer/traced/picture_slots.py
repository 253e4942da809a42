"""Pictures from the process that traces to the window: in files that both map, taken in turns.

The tracer writes into a slot that is free and reports it; the window copies the picture and gives the slot back. A
picture is never written over while it is read, and a window that is busy blocks nothing: the tracer goes on
refining and hands over what it has when a slot is free again.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Singles

SLOTS = 2


def slot_file(folder: Path, slot: int) -> Path:
    """Return where a slot's picture lies."""
    return folder / f"picture-{slot}.f32"


class SlotWriter:
    """The tracer's side."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._free = list(range(SLOTS))

    @property
    def is_free(self) -> bool:
        return bool(self._free)

    def put(self, pixels: NDArray[Any]) -> int:
        """Write (h, w, channels) into a free slot and return its number; OSError where the disk is full."""
        slot = self._free[0]
        np.ascontiguousarray(pixels, np.float32).tofile(slot_file(self._folder, slot))
        self._free.pop(0)
        return slot

    def give_back(self, slot: int) -> None:
        """The window has taken what was in the slot."""
        if slot not in self._free:
            self._free.append(slot)


def take(folder: Path, slot: int, size: tuple[int, int]) -> Singles:
    """Return the picture (h, w, channels) of a slot; ValueError where the file is another size's. The window's side."""
    width, height = size
    found = np.fromfile(slot_file(folder, slot), np.float32)
    return found.reshape(height, width, -1)
