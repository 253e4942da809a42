"""Sums in an EXR file: a regular picture with the state from which a render resumes.

Channels ``R G B`` hold the whole picture's radiance, ``A`` the object's coverage, ``object.R`` … its own light and
``ground.R`` … the darkness of its shadow, all as means over the samples. A text attribute holds their number,
and of which scene.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.reference.raytraced.picture import Sums
from brdf_suite.reference.state_file import reading_state, write_state

ATTRIBUTE = "brdfSuiteRaytraced"


def write_sums(
    path: str | os.PathLike[str],
    sums: Sums,
    picture: Floats,
    key: str,
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write sums atomically; ``picture`` (h, w, 3) is their light with the backdrop, ``key`` identifies the scene."""
    planes = {"A": sums.coverage}
    for index, name in enumerate("RGB"):
        planes[name] = picture[..., index]
        planes[f"object.{name}"] = sums.radiance[..., index]
        planes[f"ground.{name}"] = sums.darkness[..., index]
    state = {"key": key, "samples": sums.samples, "seconds": sums.seconds}
    write_state(path, ATTRIBUTE, state, planes, metadata)


def read_sums(path: str | os.PathLike[str], key: str) -> Sums | None:
    """Return the sums of a file that :func:`write_sums` wrote for the same ``key``; None for another scene.

    Raises
    ------
    FileError
        The file cannot be read, or was not written by this program.
    """
    with reading_state(path, ATTRIBUTE) as (state, planes):
        if state["key"] != key:
            return None
        names = [*(f"object.{n}" for n in "RGB"), "A", *(f"ground.{n}" for n in "RGB")]
        samples = int(state["samples"])
        values = np.stack([planes[name] for name in names], axis=-1) * samples
        return Sums(values, samples, float(state["seconds"]))
