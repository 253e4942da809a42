"""ASTM E1392-style text: ``KEY value`` lines, ``NUM_POINTS n``, ``VARS a,b,...``, then comma-separated rows.

The first four variables are θi, φi, θs, φs in radians; the rest are RGB (Rec. 709), XYZ (Y = 1), one value per
wavelength (named ``550nm``), or a single value. Values are f_r in 1/sr.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import MOST_BANDS, number_in, numbered_lines
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import (
    SampleRows,
    angles,
    as_samples,
    check_bands,
    columns,
    directions,
    one_azimuth,
    one_line,
    rgb_values,
    samples,
    sampling_notes,
)
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

_LARGEST = 256 << 20
_ANGLES = (("theta_i",), ("phi_i",), ("theta_s", "theta_r", "theta_o"), ("phi_s", "phi_r", "phi_o"))
_COLOURS: dict[tuple[str, ...], str] = {("r", "g", "b"): "rgb", ("x", "y", "z"): "xyz"}


def read_astm(path: PathLike, options: ReadOptions | None = None) -> ScatteredSamples:
    """Return the samples of an ASTM file; raise :class:`FileError` with the line of the first fault."""
    announced: int | None = None
    meaning, bands = "", np.empty(0)
    facts: dict[str, object] = {"format": "ASTM text", "name": ""}
    rows: SampleRows | None = None
    number = 0
    for number, text in numbered_lines(path, _LARGEST):
        line = text.strip()
        if not line or line.startswith("#"):
            continue
        if rows is None:
            key, _, rest = line.partition(" ")
            if key == "NUM_POINTS":
                announced = int(number_in(path, rest.strip(), number, "NUM_POINTS"))
            elif key == "SAMPLE_NAME":
                facts["name"] = rest.strip().strip('"')[:500]
            elif key == "VARS":
                names = [name.strip() for name in rest.split(",")]
                meaning, bands = _columns(path, names, number)
                rows = SampleRows(path, len(names))
            continue
        words = line.split(",")
        if len(words) != rows.width:
            reason = f"expected {rows.width} numbers, not {len(words)}"
            raise FileError(path, reason, f"line {number}")
        rows.add([number_in(path, word.strip(), number, "an angle or a value") for word in words], number)
    if rows is None:
        raise FileError(path, "the file ends before the line VARS", f"line {number}")
    if announced is not None and announced != len(rows):
        reason = f"NUM_POINTS announces {announced} samples, the file holds {len(rows)}"
        raise FileError(path, reason, f"line {number}")
    table = rows.table
    spectral = meaning == "spectra"
    return samples(
        rows,
        directions(rows, table[:, 0], table[:, 1]),
        directions(rows, table[:, 2], table[:, 3]),
        spectra=table[:, 4:] if spectral else None,
        wavelengths_nm=bands if spectral else None,
        rgb=None if spectral else rgb_values(table[:, 4:], meaning),
        isotropic=not len(table) or one_azimuth(table[:, 1]),
        observer_deg=(options or ReadOptions()).observer_deg,
        facts={**facts, "colour": {"grey": "grey", "rgb": "RGB, Rec. 709", "xyz": "XYZ"}.get(meaning, "")},
    )


def _columns(path: PathLike, names: list[str], number: int) -> tuple[str, Floats]:
    """Return what the value columns mean, and the wavelengths where they are spectra."""
    lower = [name.lower() for name in names]
    if len(names) > 4 + MOST_BANDS:
        raise FileError(path, f"{len(names)} variables are too many", f"line {number}")
    if len(names) < 5 or any(lower[i] not in known for i, known in enumerate(_ANGLES)):
        wanted = "theta_i, phi_i, theta_s, phi_s and at least one value"
        raise FileError(path, f"VARS must name {wanted}", f"line {number}")
    values = lower[4:]
    if tuple(values) in _COLOURS:
        return _COLOURS[tuple(values)], np.empty(0)
    if all(name.endswith("nm") for name in values):
        bands = [number_in(path, name[:-2].strip(), number, "a wavelength") for name in values]
        return "spectra", check_bands(path, bands, f"line {number}")
    if len(values) == 1:
        return "grey", np.empty(0)
    reason = "the value columns must be R,G,B or X,Y,Z, wavelengths like 550nm, or one alone"
    raise FileError(path, reason, f"line {number}")


def write_astm(value: Reflectance, path: PathLike) -> tuple[str, ...]:
    """Write samples, and return notes for the user.

    Spectra where there are any, else Rec. 709 RGB, or one column where all is grey.

    Raises :class:`FileError`: the file cannot be written.
    """
    scattered = as_samples(value)
    if scattered.spectra is not None and scattered.wavelengths_nm is not None:
        values, names = scattered.spectra, [f"{band!r}nm" for band in scattered.wavelengths_nm.tolist()]
    elif bool(np.all(scattered.values == scattered.values[:, :1])):
        values, names = scattered.values[:, :1], ["BRDF"]
    else:
        values, names = scattered.values @ np.linalg.inv(REC709_TO_WORKING).T, ["R", "G", "B"]
    table = np.column_stack((*angles(scattered.wi), *angles(scattered.wo), values))
    header = (
        f'SAMPLE_NAME "{one_line(scattered.facts.get("name", ""))}"\nMEAS_NAME BRDF\n'
        f"NUM_POINTS {len(table)}\nVARS {','.join(('theta_i', 'phi_i', 'theta_s', 'phi_s', *names))}\n"
    )
    write_atomically(path, (header + columns(table, ",")).encode())
    return sampling_notes(value, scattered)


FORMAT = MeasuredFormat(
    name="astm",
    title="ASTM E1392-style text",
    endings=(".astm",),
    sniff=lambda head, _size: head.startswith(b"VARS ") or b"\nVARS " in head,
    read=read_astm,
    write=write_astm,
)
