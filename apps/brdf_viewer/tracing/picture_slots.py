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


def put(folder: Path, slot: int, pixels: NDArray[Any]) -> None:
    """Write (h, w, channels) into a free slot; OSError where the disk is full. The tracer's side."""
    np.ascontiguousarray(pixels, np.float32).tofile(slot_file(folder, slot))


def take(folder: Path, slot: int, size: tuple[int, int]) -> Singles:
    """Return the picture (h, w, channels) of a slot; ValueError where the file is another size's. The window's side."""
    width, height = size
    found = np.fromfile(slot_file(folder, slot), np.float32)
    return found.reshape(height, width, -1)
