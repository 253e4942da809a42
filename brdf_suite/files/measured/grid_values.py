"""Conversion of a file's table over four angles to a reflectance."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import numpy as np

from brdf_suite.appearance.colour.colorimetry import clipping_notice
from brdf_suite.arrays import Floats, Reals
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.measured.goniometer_rows import rgb_values
from brdf_suite.reflectance.tabulated.angle_table import AngleTable, Coordinates

Meaning = Literal["grey", "rgb", "xyz", "spectra"]

MOST_NUMBERS = 1 << 27
"""Numbers of a table; a half-angle table of MERL's bins in 31 bands has 45 million."""

_LARGEST_VALUE = 1e12
_CHECKED = 200_000
"""Colours among which those outside the working space are counted."""
_BLOCK = 1 << 16


def check_count(path: PathLike, shape: Sequence[int], held: int, place: str) -> int:
    """Return how many numbers a table of ``shape`` has; raise :class:`FileError` where the file cannot hold them.

    ``held`` is the largest count for which the rest of the file has bytes; Python's integers cannot overflow.
    """
    count = 1
    for extent in shape:
        count *= extent
    if count > MOST_NUMBERS:
        raise FileError(path, f"announces {count:,} values, more than the {MOST_NUMBERS:,} allowed", place)
    if count > held:
        raise FileError(path, f"is cut off: {count:,} values are announced, at most {held:,} follow", place)
    return count


def check_axis(path: PathLike, degrees: Sequence[float], most: float, what: str, place: str) -> Floats:
    """Return nodes in radians; raise :class:`FileError` where they do not rise within 0 to ``most`` degrees."""
    axis = np.asarray(degrees, np.float64)
    if not axis.size or axis[0] < -1e-3 or axis[-1] > most + 1e-3 or (np.diff(axis) < 1e-6).any():
        raise FileError(path, f"expected {what} that rise from 0 to at most {most:g}°", place)
    return np.radians(np.clip(axis, 0.0, most))


def grid_of(
    path: PathLike,
    coordinates: Coordinates,
    axes: tuple[Floats, Floats, Floats, Floats],
    numbers: Reals,
    meaning: Meaning,
    place: Callable[[int], str],
    *,
    facts: Mapping[str, Any],
    notes: Sequence[str] = (),
    wavelengths_nm: Floats | None = None,
    observer_deg: int = 10,
    **more: Any,  # what else an AngleTable takes
) -> AngleTable:
    """Return the table of ``numbers`` (n0, n1, n2, n3, c), f_r in 1/sr.

    Parameters
    ----------
    meaning
        What a row of c numbers is: grey, linear Rec. 709, XYZ with the white's Y = 1, or a spectrum.
    place
        Where in the file the row of that index stands, for messages.
    notes
        Notices of the reader, put before those about the values.

    Raises
    ------
    FileError
        A value is not finite or too large for a reflectance. Negative ones become 0 and are counted in the facts.
    """
    rows = numbers.reshape(-1, numbers.shape[-1])
    if not (rows.min() > -_LARGEST_VALUE and rows.max() < _LARGEST_VALUE):  # a NaN is neither
        wrong = ~(np.abs(rows) < _LARGEST_VALUE).all(axis=1)
        reason = "holds a value that is no finite reflectance"
        raise FileError(path, reason, place(int(np.argmax(wrong))))
    known = dict(facts)
    negative = int(np.count_nonzero(rows < 0.0))
    if negative:
        known["negative values raised to 0"] = negative
    said = list(notes)
    if meaning in ("grey", "spectra"):
        values = np.maximum(rows, 0.0).astype(np.float32, copy=False)
    else:
        values = np.empty((len(rows), 3), np.float32)
        for start in range(0, len(rows), _BLOCK):
            part = slice(start, start + _BLOCK)
            values[part] = np.maximum(rgb_values(rows[part].astype(np.float64), meaning), 0.0)
        some = rows[:: max(1, len(rows) // _CHECKED)]
        said += clipping_notice(rgb_values(some.astype(np.float64), meaning))
    known["nodes"] = " × ".join(str(axis.size) for axis in axes)
    known["colour"] = {"grey": "grey", "rgb": "RGB, taken as Rec. 709", "xyz": "XYZ"}.get(meaning, "")
    if wavelengths_nm is not None:
        known["colour"] = f"{len(wavelengths_nm)} bands, {wavelengths_nm[0]:g} to {wavelengths_nm[-1]:g} nm"
        known["observer_deg"] = observer_deg
    if said:
        known["notes"] = tuple(said)
    try:
        return AngleTable(
            coordinates,
            axes,
            values.reshape(*(axis.size for axis in axes), -1),
            wavelengths_nm=wavelengths_nm,
            observer_deg=observer_deg,
            source=os.fspath(path),
            facts=known,
            **more,
        )
    except ValueRangeError as error:
        raise FileError(path, error.reason, error.place) from error
