"""A scene that is traced, whichever renderer does it: it gives ever better pictures until it is closed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View


@dataclass(frozen=True, eq=False)
class TracedFrame:
    """A picture so far.

    ``pixels`` (h, w, 4) float32: the object's radiance of the working space before exposure, weighted by its
    coverage, and that coverage; (h, w, 7) with the darkness of the ground after them. ``samples`` a pixel, of ``of``
    (0: without end). ``noise``: the standard error of the luminance as a share of it, median over the object; None
    where it is not estimated. ``seconds`` were spent.
    """

    pixels: NDArray[np.float32]
    samples: int
    of: int
    noise: float | None
    seconds: float


class Job(Protocol):
    """A scene that is open.

    ``title`` names the renderer, ``notices`` are what it leaves out; ``no_denoiser`` says why it cannot take the noise
    out, empty where it can.
    """

    title: str
    notices: tuple[str, ...]
    no_denoiser: str

    def frames(self) -> Iterator[TracedFrame]:
        """Yield ever better pictures; SuiteError where the renderer fails."""
        ...

    def denoise_picture(self, pixels: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return the pixels of a frame without their noise; SuiteError where that fails."""
        ...

    def save(self, path: Path, view: View) -> None:
        """Write the newest picture as EXR with its variance, in ``view``'s background; FileError."""
        ...


def add_coverage(radiance: NDArray[Any], coverage: NDArray[Any]) -> NDArray[np.float32]:
    """Return (h, w, 4) float32 of radiance and coverage."""
    pixels = np.empty((*coverage.shape, 4), np.float32)
    pixels[..., :3] = radiance
    pixels[..., 3] = coverage
    return pixels
