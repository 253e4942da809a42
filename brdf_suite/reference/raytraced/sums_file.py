"""Sums in an EXR file: the picture as anyone sees it, and beside it what a render goes on from.

Channels ``R G B`` hold the whole picture's radiance, ``A`` the object's coverage, ``object.R`` … its own light and
``ground.R`` … the darkness of its shadow, all as means over the samples. A text attribute tells how many those were,
and of which scene.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping

import numpy as np

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError
from brdf_suite.files.primaries import REC2020
from brdf_suite.reference.raytraced.picture import Pixels, Sums

ATTRIBUTE = "brdfSuiteRaytraced"


def write_sums(
    path: str | os.PathLike[str],
    sums: Sums,
    picture: Pixels,
    key: str,
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write sums atomically; ``picture`` (h, w, 3) is their light with the backdrop, ``key`` tells the scene."""
    import OpenEXR

    planes = {"A": sums.coverage}
    for index, name in enumerate("RGB"):
        planes[name] = picture[..., index]
        planes[f"object.{name}"] = sums.radiance[..., index]
        planes[f"ground.{name}"] = sums.darkness[..., index]
    header = {
        **(metadata or {}),
        ATTRIBUTE: json.dumps({"key": key, "samples": sums.samples, "seconds": sums.seconds}),
        "compression": OpenEXR.ZIP_COMPRESSION,
        "type": OpenEXR.scanlineimage,
        "chromaticities": REC2020,
    }
    channels = {name: np.ascontiguousarray(plane, np.float32) for name, plane in planes.items()}
    with replacing(path) as temporary:
        try:
            OpenEXR.File(header, channels).write(str(temporary))
        except (RuntimeError, ValueError) as error:
            raise FileError(path, f"cannot be written ({error})") from error


def read_sums(path: str | os.PathLike[str], key: str) -> Sums | None:
    """Return the sums of a file that :func:`write_sums` wrote for the same ``key``; None for another scene.

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
        names = [*(f"object.{n}" for n in "RGB"), "A", *(f"ground.{n}" for n in "RGB")]
        samples = int(state["samples"])
        values = np.stack([planes[name] for name in names], axis=-1) * samples
        return Sums(values, samples, float(state["seconds"]))
    except (RuntimeError, ValueError, KeyError, TypeError, OSError) as error:
        raise FileError(
            path, f"holds no render to go on from ({error}); remove it, or render to another file"
        ) from error
