"""Estimate in an EXR file: radiance as the picture, its variance, and the state needed to resume.

Channels ``R G B`` hold the whole picture's radiance, ``A`` the object's coverage; ``variance.R`` … the variance of the
mean; ``object.R`` … and ``squares.R`` … what the passes have added up, from which a render goes on. Text attributes
record the samples and what was rendered.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.passes import Estimate
from brdf_suite.reference.state_file import reading_state, write_state

ATTRIBUTE = "brdfSuiteReference"
_VERSION = 2
"""1, without a number in the file: the squares of passes, all of one size, were not multiplied by their samples."""


def write_estimate(
    path: str | os.PathLike[str],
    estimate: Estimate,
    picture: npt.NDArray[np.float64],
    key: str,
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write an estimate atomically; ``picture`` (h, w, 3) is its light with the backdrop, ``key`` names the scene."""
    state = {
        "version": _VERSION,
        "key": key,
        "samples": estimate.samples,
        "passes": estimate.passes,
        "seconds": estimate.seconds,
    }
    variance = np.minimum(estimate.variance, np.finfo(np.float32).max)
    planes = {"A": estimate.coverage}
    for index, name in enumerate("RGB"):
        planes[name] = picture[..., index]
        planes[f"variance.{name}"] = variance[..., index]
        planes[f"object.{name}"] = estimate.radiance[..., index]
        planes[f"squares.{name}"] = estimate.squares[..., index]
    write_state(path, ATTRIBUTE, state, planes, metadata)


def read_estimate(path: str | os.PathLike[str], key: str) -> Estimate | None:
    """Return the estimate of a file that :func:`write_estimate` wrote for the same ``key``; None for another scene.

    Raises
    ------
    FileError
        The file cannot be read, or was not written by this program.
    """
    with reading_state(path, ATTRIBUTE) as (state, planes):
        if state["key"] != key:
            return None
        samples, passes = int(state["samples"]), int(state["passes"])
        squares = np.stack([planes[f"squares.{name}"] for name in "RGB"], axis=-1)
        if state.get("version", 1) < _VERSION:
            squares = squares * (samples / max(passes, 1))
        return Estimate(
            np.stack([planes[f"object.{name}"] for name in "RGB"], axis=-1),
            planes["A"],
            squares,
            samples,
            passes,
            float(state["seconds"]),
        )
