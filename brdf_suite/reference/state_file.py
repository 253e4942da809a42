"""EXR file of a picture with the state of its render: extra planes and a text."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import numpy as np
import OpenEXR

from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import replacing
from brdf_suite.documents.exr_writing import write_by_library
from brdf_suite.errors import FileError
from brdf_suite.files.images.primaries import REC2020
from brdf_suite.regular_files import check_regular


def write_state(
    path: str | os.PathLike[str],
    attribute: str,
    state: Mapping[str, object],
    planes: Mapping[str, Floats],
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write planes (h, w) in single precision, and the state under the name ``attribute``, whole or not at all."""
    header = {
        **(metadata or {}),
        attribute: json.dumps(state),
        "compression": OpenEXR.ZIP_COMPRESSION,
        "type": OpenEXR.scanlineimage,
        "chromaticities": REC2020,
    }
    channels = {name: np.ascontiguousarray(plane, np.float32) for name, plane in planes.items()}
    with replacing(path) as temporary:
        write_by_library(OpenEXR.File(header, channels), temporary, path)


@contextmanager
def reading_state(
    path: str | os.PathLike[str], attribute: str
) -> Iterator[tuple[dict[str, Any], dict[str, Floats]]]:
    """Yield state and planes of a file that :func:`write_state` wrote.

    Raises
    ------
    FileError
        The file cannot be read, or what the block looks for is not in it: it was not written by this program.
    """
    try:
        check_regular(path)
        with OpenEXR.File(os.fspath(path), separate_channels=True) as file:
            header, channels = file.header(), file.channels()
            state = json.loads(header[attribute])
            with np.errstate(invalid="ignore"):  # of numbers that are none
                planes = {name: np.asarray(channel.pixels, np.float64) for name, channel in channels.items()}
        if not all(np.isfinite(plane).all() for plane in planes.values()):
            raise ValueError("it holds numbers that are not finite")
        yield state, planes
    except (RuntimeError, ValueError, KeyError, TypeError, OSError, MemoryError) as error:
        raise FileError(
            path, f"holds no render to resume from ({error}); remove it, or render to another file"
        ) from error
