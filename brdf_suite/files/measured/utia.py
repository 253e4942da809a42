"""UTIA's anisotropic tables (.bin), read.

Layout (Filip and Vávra, "Template-Based Sampling of Anisotropic BRDFs", 2014), as other readers have it: float64,
little-endian, no header; three planes R, G, B of 288 × 288, a row per light and a column per view, each
θ-major: θ of 0, 15 … 75°, φ of 0, 7.5 … 352.5°. The file does not state its scale nor whether the values
were passed through the sRGB curve - readers differ; they are taken as f_r in linear Rec. 709, and where that sends
back more light than came in, the ``facts`` say so.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, srgb_decode
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.measured.format import MeasuredFormat
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable
from brdf_suite.regular_files import read_bytes

_POLAR, _AZIMUTHS = 6, 48
_SIZE = 8 * 3 * (_POLAR * _AZIMUTHS) ** 2
_LARGEST_VALUE = 1e6


def read_utia(path: PathLike, *, srgb_encoded: bool = False) -> AnisotropicTable:
    """Return the table in the file, in the working space.

    Parameters
    ----------
    path
        A file of exactly 1,990,656 bytes.
    srgb_encoded
        Take the stored values as passed through the sRGB curve, and undo it.

    Raises
    ------
    FileError
        The file is missing, of another size, holds a value that is no finite reflectance, or only negative ones.
    """
    data = read_bytes(path, 4 * _SIZE)
    if len(data) != _SIZE:
        state = "cut off" if len(data) < _SIZE else "too long"
        at = f"byte {min(len(data), _SIZE)}"
        raise FileError(path, f"is {state}: expected {_SIZE:,} bytes, found {len(data):,}", at)
    stored = np.frombuffer(data, "<f8")
    wrong = ~(np.abs(stored) <= _LARGEST_VALUE)
    if wrong.any():
        raise FileError(
            path, "holds a value that is no finite reflectance", f"byte {8 * int(wrong.argmax())}"
        )
    notes = []
    negative = int(np.count_nonzero(stored < 0.0))
    if negative == stored.size:
        raise FileError(path, "every value is negative, which no reflectance is", "byte 0")
    if negative:
        notes.append(f"{negative:,} negative values became 0")
    rgb = np.maximum(stored, 0.0).reshape(3, _POLAR, _AZIMUTHS, _POLAR, _AZIMUTHS)
    if srgb_encoded:
        rgb = srgb_decode(rgb)
    values = np.moveaxis(rgb, 0, -1) @ REC709_TO_WORKING.T
    theta = np.radians(15.0 * np.arange(_POLAR))
    facts: dict[str, Any] = {
        "format": "UTIA",
        "nodes": f"θ {_POLAR} × φ {_AZIMUTHS}, of light and of view",
        "colour": "RGB, Rec. 709" + (", sRGB-encoded" if srgb_encoded else ", taken as linear"),
    }
    table = AnisotropicTable(values.astype(np.float32), theta, theta, os.fspath(path))
    # The largest channel's reflectance at 45° incidence, by cosine-weighted views on a 64 × 64 grid.
    u = (np.arange(64) + 0.5) / 64
    views = spherical(np.arcsin(np.sqrt(u))[:, None], 2.0 * np.pi * u[None, :])
    albedo = float(np.pi * table.eval(spherical(np.pi / 4.0, 0.0), views).mean(axis=(0, 1)).max())
    facts["albedo_45"] = albedo
    if albedo > 1.0:
        notes.append(
            f"it reflects {albedo:.3g} of the light that falls on it at 45°, so its values are not f_r as they stand"
        )
    facts["notes"] = tuple(notes)
    return AnisotropicTable(table.values, theta, theta, table.source, facts)


FORMAT = MeasuredFormat(
    "utia",
    "UTIA anisotropic table",
    (".bin",),
    lambda _, size: size == _SIZE,
    lambda path, options: read_utia(path, srgb_encoded=options.srgb_encoded),
)
