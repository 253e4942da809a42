"""An estimate in an EXR file: its radiance as the picture, its variance beside it, and all that going on needs.

Channels ``R G B`` hold the whole picture's radiance, ``A`` the object's coverage; ``variance.R`` … the variance of the
mean; ``object.R`` … and ``squares.R`` … what the passes have added up, from which a render goes on. Text attributes
tell the samples and what was rendered.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError
from brdf_suite.files.primaries import REC2020
from brdf_suite.reference.passes import Estimate

ATTRIBUTE = "brdfSuiteReference"
_VERSION = 2
"""1, untold: the squares of passes, all of one size, were not multiplied by their samples."""


def write_estimate(
    path: str | os.PathLike[str],
    estimate: Estimate,
    picture: npt.NDArray[np.float64],
    key: str,
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write an estimate atomically; ``picture`` (h, w, 3) is its light with the backdrop, ``key`` tells the scene."""
    import OpenEXR

    state = {
        "version": _VERSION,
        "key": key,
        "samples": estimate.samples,
        "passes": estimate.passes,
        "seconds": estimate.seconds,
    }
    variance = np.minimum(estimate.variance, np.finfo(np.float32).max)
    channels = {"A": _plane(estimate.coverage)}
    for index, name in enumerate("RGB"):
        channels[name] = _plane(picture[..., index])
        channels[f"variance.{name}"] = _plane(variance[..., index])
        channels[f"object.{name}"] = _plane(estimate.radiance[..., index])
        channels[f"squares.{name}"] = _plane(estimate.squares[..., index])
    header = {
        **(metadata or {}),
        ATTRIBUTE: json.dumps(state),
        "compression": OpenEXR.ZIP_COMPRESSION,
        "type": OpenEXR.scanlineimage,
        "chromaticities": REC2020,
    }
    with replacing(path) as temporary:
        try:
            OpenEXR.File(header, channels).write(str(temporary))
        except (RuntimeError, ValueError) as error:
            raise FileError(path, f"cannot be written ({error})") from error


def read_estimate(path: str | os.PathLike[str], key: str) -> Estimate | None:
    """Return the estimate of a file that :func:`write_estimate` wrote for the same ``key``; None for another scene.

    Raises
    ------
    FileError
        The file cannot be read, or is none of ours.
    """
    import OpenEXR

    try:
        with OpenEXR.File(os.fspath(path), separate_channels=True) as file:
            header, channels = file.header(), file.channels()
            state = json.loads(header[ATTRIBUTE])
            planes = {name: np.asarray(channel.pixels, np.float64) for name, channel in channels.items()}
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
    except (RuntimeError, ValueError, KeyError, TypeError, OSError) as error:
        raise FileError(
            path, f"holds no render to go on from ({error}); remove it, or render to another file"
        ) from error


def _plane(values: npt.NDArray[np.float64]) -> npt.NDArray[np.float32]:
    return np.ascontiguousarray(values, np.float32)
