"""Conversion between goniometer rows and scattered samples."""

from __future__ import annotations

import math
from array import array
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, WORKING_TO_XYZ, clipping_notice
from brdf_suite.appearance.colour.spectra import spectrum_to_working
from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.bounded_reading import MOST_BANDS, MOST_SAMPLES
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

# A polar angle this little over 90° is the rounding of the file, not transmission.
_HORIZON_SLACK = 1e-3

# Closer bands than this (nm) are a damaged list, and would make the weights between them overflow.
_CLOSEST_BANDS_NM = 1e-3

# What a spectrum must cover for its colour to be measured rather than guessed.
_VISIBLE_NM = (420.0, 680.0)

# No measurement of a reflectance reaches this (1/sr); a mirror seen through a pinhole has 1e7.
_LARGEST_VALUE = 1e12


class SampleRows:
    """Numbers of a file's rows, with the line of each."""

    def __init__(self, path: PathLike, width: int) -> None:
        self.path, self.width = path, width
        self._numbers = array("d")
        self._lines = array("q")

    def add(self, numbers: Sequence[float], line: int) -> None:
        """Keep a row of ``width`` numbers; raise :class:`FileError` beyond the allowed number of rows."""
        if len(self._lines) >= MOST_SAMPLES:
            raise FileError(self.path, f"has more than {MOST_SAMPLES:,} rows of samples", f"line {line}")
        self._numbers.extend(numbers)
        self._lines.append(line)

    def __len__(self) -> int:
        return len(self._lines)

    @property
    def table(self) -> Floats:
        """The rows (n, width)."""
        return np.frombuffer(self._numbers, np.float64).reshape(-1, self.width)

    def extend(self, table: Floats, lines: npt.NDArray[np.int64]) -> None:
        """Keep the rows of ``table`` (n, ``width``), each with what :meth:`place` names; errors as :meth:`add`."""
        if len(self._lines) + len(table) > MOST_SAMPLES:
            raise FileError(
                self.path, f"has more than {MOST_SAMPLES:,} rows of samples", "the number of rows"
            )
        self._numbers.frombytes(np.ascontiguousarray(table, np.float64).tobytes())
        self._lines.frombytes(lines.astype(np.int64).tobytes())

    def only(self, kept: npt.NDArray[np.bool_]) -> SampleRows:
        """Return the rows where ``kept`` (n,) is true."""
        found = type(self)(self.path, self.width)
        found._numbers.frombytes(self.table[kept].tobytes())
        found._lines.frombytes(np.frombuffer(self._lines, np.int64)[kept].tobytes())
        return found

    def place(self, row: int) -> str:
        """Where the row stands in the file."""
        return f"line {self._lines[row]}"


def directions(rows: SampleRows, theta: Floats, phi: Floats) -> Floats:
    """Return unit directions (n, 3); refuse polar angles below the horizon, naming the line."""
    wrong = np.flatnonzero((np.abs(theta) > 0.5 * math.pi + _HORIZON_SLACK) | (np.abs(phi) > 8.0 * math.pi))
    if wrong.size:
        at = int(wrong[0])
        reason = (
            f"the direction θ = {math.degrees(theta[at]):.6g}°, φ = {math.degrees(phi[at]):.6g}° does not lie"
            " above the surface"
        )
        raise FileError(rows.path, reason, rows.place(at))
    return spherical(np.clip(theta, -0.5 * math.pi, 0.5 * math.pi), phi)


def check_bands(path: PathLike, bands: Sequence[float], place: str) -> Floats:
    """Return wavelengths (k,) in nanometres that rise, or raise :class:`FileError`."""
    found = np.asarray(bands, np.float64)
    if not 1 <= len(found) <= MOST_BANDS:
        raise FileError(path, f"{len(found)} wavelengths are named; expected 1 to {MOST_BANDS}", place)
    if found[0] < 100.0 or found[-1] > 10_000.0 or np.any(np.diff(found) < _CLOSEST_BANDS_NM):
        raise FileError(path, "the wavelengths do not rise from at least 100 to at most 10,000 nm", place)
    return found


def samples(
    rows: SampleRows,
    wi: Floats,
    wo: Floats,
    *,
    spectra: Floats | None = None,
    wavelengths_nm: Floats | None = None,
    rgb: Floats | None = None,
    isotropic: bool,
    observer_deg: int,
    facts: Mapping[str, Any],
) -> ScatteredSamples:
    """Return the samples of a file, either spectra (n, k) or working-space values ``rgb`` (n, 3).

    Negative values, the noise of dark readings, become 0; ``facts`` then says how many. Colours outside the working
    space are counted in a notice, with the largest difference that their negative channel makes at 0.

    Raises :class:`FileError`: there is no row, or a value is beyond what a reflectance can be.
    """
    if len(rows) == 0:
        raise FileError(rows.path, "holds no samples", "the end of the file")
    raw = spectra if spectra is not None else rgb
    assert raw is not None  # one of the two is always given
    wrong = np.flatnonzero(~(np.abs(raw) < _LARGEST_VALUE).all(axis=1))
    if wrong.size:
        raise FileError(rows.path, "a value is too large for a reflectance", rows.place(int(wrong[0])))
    known = dict(facts)
    known["samples"] = len(rows)
    negative = int(np.count_nonzero(raw < 0.0))
    if negative:
        known["negative values raised to 0"] = negative
    notes: list[str] = []
    if spectra is None:
        colours = raw
    else:
        assert wavelengths_nm is not None  # spectra never come without
        spectra = np.maximum(spectra, 0.0)
        known["colour"] = f"{len(wavelengths_nm)} bands, {wavelengths_nm[0]:g} to {wavelengths_nm[-1]:g} nm"
        known["observer_deg"] = observer_deg
        first, last = float(wavelengths_nm[0]), float(wavelengths_nm[-1])
        if first > _VISIBLE_NM[0] or last < _VISIBLE_NM[1]:
            notes.append(
                f"The spectra reach from {first:g} to {last:g} nm only; beyond, their last value is held, and"
                " colours are as good as that guess."
            )
        colours = spectrum_to_working(spectra, wavelengths_nm, observer_deg)
    values = np.maximum(colours, 0.0)
    notes += clipping_notice(colours)
    if notes:
        known["notes"] = tuple(notes)
    try:
        return ScatteredSamples(
            wi, wo, values, spectra, wavelengths_nm, isotropic=isotropic, source=str(rows.path), facts=known
        )
    except ValueRangeError as error:
        raise FileError(rows.path, error.reason, error.place) from error


def sampling_notes(value: object, scattered: ScatteredSamples) -> tuple[str, ...]:
    """Return notices about losses where ``value`` had to be sampled for writing; none where it was not."""
    if scattered is value:
        return ()
    return (f"Read at {len(scattered.wi):,} pairs of directions, as an isotropic reflectance.",)


def rgb_values(numbers: Floats, meaning: str) -> Floats:
    """Return working-space values (n, 3) of a file's columns: ``grey``, ``rgb`` (Rec. 709) or ``xyz`` (Y = 1)."""
    if meaning == "grey":
        return np.repeat(numbers, 3, axis=1)
    if meaning == "rgb":
        return numbers @ REC709_TO_WORKING.T
    return numbers @ np.linalg.inv(WORKING_TO_XYZ).T


def one_azimuth(phi: Floats) -> bool:
    """Whether all incident azimuths agree, so that the sample was taken as isotropic."""
    return bool(np.ptp(phi) < 1e-6)


def as_samples(value: Reflectance) -> ScatteredSamples:
    """Return scattered samples of any reflectance, as a goniometer would take them.

    Scattered ones come back as they are. Others are read as isotropic at 9 incidences (0 to 80°), each at
    polar angles 0 to 85° in 5° steps and azimuths 0 to 180° in 10° steps, and densely about the mirror.
    """
    if isinstance(value, ScatteredSamples):
        return value
    theta_i, theta_o, phi = (
        part.ravel()
        for part in np.meshgrid(
            np.radians(np.arange(0.0, 81.0, 10.0)),
            np.radians(np.arange(0.0, 86.0, 5.0)),
            np.radians(np.arange(0.0, 181.0, 10.0)),
            indexing="ij",
        )
    )
    near_i, near_o, near_phi = (
        part.ravel()
        for part in np.meshgrid(
            np.radians(np.arange(0.0, 81.0, 10.0)),
            np.radians([-4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0]),
            np.radians([180.0, 178.0, 175.0]),
            indexing="ij",
        )
    )
    theta_i = np.concatenate((theta_i, near_i))
    theta_o = np.concatenate((theta_o, np.clip(near_i + near_o, 0.0, np.radians(89.0))))
    phi = np.concatenate((phi, near_phi))
    wi, wo = spherical(theta_i, np.zeros_like(theta_i)), spherical(theta_o, phi)
    bands = getattr(value, "wavelengths_nm", None)
    spectra = None if bands is None else value.eval_spectra(wi, wo)  # type: ignore[attr-defined] # as bands say
    return ScatteredSamples(
        wi,
        wo,
        value.eval(wi, wo),
        spectra,
        None if bands is None else np.asarray(bands, np.float64),
        source=str(getattr(value, "source", "")),
        facts=dict(getattr(value, "facts", {})),
    )


def angles(w: Floats) -> tuple[Floats, Floats]:
    """Return (θ, φ), each (n,), radians."""
    return np.arctan2(np.hypot(w[:, 0], w[:, 1]), w[:, 2]), np.arctan2(w[:, 1], w[:, 0])


def columns(table: npt.ArrayLike, separator: str) -> str:
    """Return rows of numbers as text; each is the shortest that reads back as the same number."""
    rows = np.asarray(table, np.float64).tolist()
    return "".join(separator.join(map(repr, row)) + "\n" for row in rows)


def one_line(text: object) -> str:
    """Return a text that stays within one line of a header."""
    return " ".join(str(text).split())[:500]
