"""BRDF JSON of the BiRD project (metrology institutes): lists of equal length, one entry per reading.

Readings of one geometry and wavelength under several polarizations, or at several places of the sample, are
averaged: s and p in equal parts are unpolarized light. Geometries read at the same wavelengths become spectra.
Angles follow Nicodemus: both directions point away from the surface.
"""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.parameter import describe
from brdf_suite.documents.reading import read_json
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import MOST_SAMPLES
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import (
    SampleRows,
    angles,
    as_samples,
    check_bands,
    directions,
    one_azimuth,
    one_line,
    rgb_values,
    samples,
    sampling_notes,
)
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

_GEOMETRY = ("theta_i", "phi_i", "theta_r", "phi_r")
_LENGTHS = ("nm", "μm", "µm", "um")  # the Greek letter and the micro sign: files use both
_UNITS = {
    **dict.fromkeys(_GEOMETRY, ("rad", "deg", "°")),
    **dict.fromkeys(("wavelength_i", "wavelength_r"), _LENGTHS),
    "BRDF": ("1/sr", "sr^-1"),
}
_POLARIZATIONS = ("sp", "inStokes")
_SAME_ANGLE = 1e-7  # radians: closer readings are one geometry
_SAME_BAND = 1e-3  # nm


def read_bird(path: PathLike, options: ReadOptions | None = None) -> ScatteredSamples:
    """Return the samples of a BiRD file: spectral where it names wavelengths, else grey.

    Raises
    ------
    FileError
        It is not JSON, does not follow the schema, or the lists do not fit together; with the JSON path.
    """
    document = _validated(path)
    data, metadata = document["data"], document["metadata"]
    values = _numbers(path, data["BRDF"]["values"], "BRDF", None)
    count = len(values)
    table = np.column_stack([_numbers(path, data[name]["values"], name, count) for name in _GEOMETRY])
    table = np.where([data[name]["unit"] == "rad" for name in _GEOMETRY], table, np.radians(table))
    bands = _bands(path, data, count)
    keys = np.round(table / _SAME_ANGLE)
    _, first, group = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    # In the order of the file, not that of the numbers.
    order = np.argsort(first)
    first, group = first[order], np.argsort(order)[group.reshape(-1)]
    facts: dict[str, object] = {"format": "BiRD JSON", "name": _name(metadata), "readings": count}
    polarization = data.get("polarization_i", data.get("polarization_r"))
    if polarization is not None:
        facts["polarization"] = "readings of several polarizations averaged"

    rows = _Entries(path, len(_GEOMETRY))
    for index, row in enumerate(table[first].tolist()):
        rows.add(row, index)
    at = rows.table
    common: dict[str, Any] = {
        "rows": rows,
        "wi": directions(rows, at[:, 0], at[:, 1]),
        "wo": directions(rows, at[:, 2], at[:, 3]),
        "isotropic": one_azimuth(at[:, 1]),
        "observer_deg": (options or ReadOptions()).observer_deg,
        "facts": facts,
    }
    if bands is None:
        mean = np.bincount(group, values) / np.bincount(group)
        return samples(**common, rgb=rgb_values(mean[:, None], "grey"))
    _, named, band = np.unique(np.round(bands / _SAME_BAND), return_index=True, return_inverse=True)
    wavelengths = check_bands(path, bands[named].tolist(), "data.wavelength_i.values")
    if len(first) * len(wavelengths) > count:
        missing = (
            f"{len(first)} geometries times {len(wavelengths)} wavelengths are more than {count} readings"
        )
        raise FileError(path, f"not every geometry was read at every wavelength ({missing})", "data")
    cell = group * len(wavelengths) + band.reshape(-1)
    size = len(first) * len(wavelengths)
    readings = np.bincount(cell, minlength=size)
    if not readings.all():
        raise FileError(path, "not every geometry was read at every wavelength", "data.wavelength_i.values")
    spectra = (np.bincount(cell, values, size) / readings).reshape(len(first), -1)
    return samples(**common, spectra=spectra, wavelengths_nm=wavelengths)


class _Entries(SampleRows):
    """Rows stored as JSON lists."""

    def place(self, row: int) -> str:
        return f"data, entry {self._lines[row]}"


def _validated(path: PathLike) -> dict[str, Any]:
    """Return the document after a check of what the reader relies on (BRDF JSON schema 1.0 of the BiRD project).

    The check is looser than the published schema where real files are (it asks for fields that the example of the
    project lacks), and as strict where a wrong file would be misread: units, notations, and that axes are lists.
    """
    try:
        document = read_json(path)
    except FileError as error:
        raise FileError(path, error.reason, error.place or "the JSON text") from error
    top = _object(path, document, "", ("metadata", "data"))
    kind = _object(path, top["metadata"], "metadata").get("type", "BRDF")
    if kind != "BRDF":
        raise _fault(path, "metadata.type", kind, "'BRDF'")
    data = _object(path, top["data"], "data", (*_GEOMETRY, "BRDF"))
    for name, units in _UNITS.items():
        if name in data:
            axis = _object(path, data[name], f"data.{name}", ("unit", "values"))
            if axis["unit"] not in units:
                raise _fault(path, f"data.{name}.unit", axis["unit"], " or ".join(map(repr, units)))
            _check_list(path, axis["values"], f"data.{name}.values")
    for name in ("polarization_i", "polarization_r"):
        if name in data:
            axis = _object(path, data[name], f"data.{name}", ("values",))
            if axis.get("notation", "sp") not in _POLARIZATIONS:
                expected = " or ".join(map(repr, _POLARIZATIONS))
                raise _fault(path, f"data.{name}.notation", axis["notation"], expected)
            _check_list(path, axis["values"], f"data.{name}.values")
    return top


def _object(path: PathLike, value: object, place: str, required: tuple[str, ...] = ()) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise _fault(path, place, value, "an object")
    for name in required:
        if name not in value:
            raise FileError(
                path,
                f"does not follow the BRDF schema: {name!r} is a required property",
                place or "the top level",
            )
    return value


def _check_list(path: PathLike, value: object, place: str) -> None:
    if not isinstance(value, list) or not 1 <= len(value) <= MOST_SAMPLES:
        raise _fault(path, place, value, f"a list of 1 to {MOST_SAMPLES} entries")


def _fault(path: PathLike, place: str, value: object, expected: str) -> FileError:
    reason = f"does not follow the BRDF schema: {describe(value)} where {expected} is expected"
    return FileError(path, reason, place or "the top level")


def _numbers(path: PathLike, values: list[Any], name: str, count: int | None) -> Floats:
    if count is not None and len(values) != count:
        reason = f"has {len(values)} entries where BRDF has {count}"
        raise FileError(path, reason, f"data.{name}.values")
    numbers = np.empty(len(values))
    for index, value in enumerate(values):
        # An int of JSON may be too large for a float.
        number = float(value) if isinstance(value, (int, float)) and abs(value) < 1e300 else math.nan
        if isinstance(value, bool) or not math.isfinite(number):
            reason = f"expected a finite number, not {describe(value)}"
            raise FileError(path, reason, f"data.{name}.values[{index}]")
        numbers[index] = number
    return numbers


def _bands(path: PathLike, data: dict[str, Any], count: int) -> npt.NDArray[np.float64] | None:
    name = "wavelength_i" if "wavelength_i" in data else "wavelength_r"
    if name not in data:
        return None
    numbers = _numbers(path, data[name]["values"], name, count)
    return numbers if data[name]["unit"] == "nm" else numbers * 1000.0


def _name(metadata: dict[str, Any]) -> str:
    sample = metadata.get("sample")
    name = sample.get("name") if isinstance(sample, dict) else None
    return one_line(name if isinstance(name, str) else metadata.get("description", ""))


def write_bird(value: Reflectance, path: PathLike) -> tuple[str, ...]:
    """Write samples, spectra or grey values, and return notes for the user.

    Raises
    ------
    FileError
        The samples hold colours without spectra, which this format has no place for; or the disk refuses.
    """
    scattered = as_samples(value)
    geometry = np.degrees(np.column_stack((*angles(scattered.wi), *angles(scattered.wo))))
    geometry[:, 1::2] %= 360.0
    data: dict[str, Any] = {}
    if scattered.spectra is not None and scattered.wavelengths_nm is not None:
        bands = scattered.wavelengths_nm
        geometry = np.repeat(geometry, len(bands), axis=0)
        values = scattered.spectra.ravel()
        named = np.tile(bands, len(scattered.wi)).tolist()
        data["wavelength_i"] = {"unit": "nm", "values": named}
    elif np.allclose(scattered.values, scattered.values[:, :1], rtol=1e-9, atol=0.0):
        values = scattered.values[:, 0]
    else:
        raise FileError(
            path, "this format holds spectra or grey values, and the reflectance has colours only"
        )
    for name, column in zip(_GEOMETRY, geometry.T, strict=True):
        data[name] = {"unit": "deg", "values": column.tolist()}
    data["BRDF"] = {"unit": "sr^-1", "values": values.tolist()}
    metadata = {
        "type": "BRDF",
        "description": one_line(scattered.facts.get("name", "")),
        "sample": {"name": one_line(scattered.facts.get("name", ""))},
    }
    text = json.dumps({"metadata": metadata, "data": data}, ensure_ascii=False, indent=1)
    write_atomically(path, text.encode())
    return sampling_notes(value, scattered)


FORMAT = MeasuredFormat(
    name="bird",
    title="BiRD JSON",
    endings=(".json",),
    sniff=lambda head, _size: (
        head.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"{")
        and b'"metadata"' in head
        and b'"brdfp' not in head
    ),
    read=read_bird,
    write=write_bird,
)
