"""Tristimulus values from reflectance spectra (CIE 15, section 7).

    X = k Σ R(λ) S(λ) x̄(λ),   k = 100 / Σ S(λ) ȳ(λ),

summed at 1 nm from 360 to 780 nm, S the illuminant and x̄, ȳ, z̄ the observer. A measured spectrum has fewer bands:
it is read between them by the cubic through the four nearest bands (Lagrange, as ASTM E2022 does for weighting
tables; a straight line in the first and last step), and held beyond its ends. All of that is linear in R: a set of
bands has one matrix of weights (k, 3), made once.

The weights of a perfect diffuser sum to the white, whatever the bands.
"""

from __future__ import annotations

from functools import cache
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import RELATIVE_TO_WORKING, WORKING_TO_XYZ, xyz_to_lab
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.resources import resource

Observer = Literal[2, 10]
Illuminant = Literal["D65", "A", "F11", "D50", "F2", "LED-B3"]
OBSERVERS: tuple[int, ...] = get_args(Observer)
ILLUMINANTS: tuple[str, ...] = get_args(Illuminant)
"""Of the CIE. D65, D50: daylight. A: incandescent. F11: a three-band fluorescent lamp, close to the TL84 of light
booths. F2: a cool white fluorescent lamp. LED-B3: white of a blue LED with phosphor, 4,100 K."""

DEFAULT_WAVELENGTHS_NM: Floats = np.linspace(400.0, 700.0, 31)
"""The bands of a spectrum whose file does not say otherwise: 400 to 700 nm at 10 nm."""

_LOWEST_NM, _HIGHEST_NM = 100.0, 10_000.0


@cache
def _tables() -> dict[str, Floats]:
    """Return every column of the packaged table by its name, each (421,)."""
    path = resource("colour", "cie.csv")
    lines = [line for line in path.read_text(encoding="ascii").splitlines() if not line.startswith("#")]
    numbers = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
    numbers.flags.writeable = False
    return dict(zip(lines[0].split(","), numbers.T, strict=True))


def table_wavelengths() -> Floats:
    """Return the wavelengths (421,) of the tables: 360 to 780 nm at 1 nm."""
    return _tables()["nm"]


def colour_matching(observer_deg: int = 10) -> Floats:
    """Return x̄, ȳ, z̄ (421, 3) of the CIE 1931 (2°) or 1964 (10°) observer, 360 to 780 nm at 1 nm."""
    if observer_deg not in OBSERVERS:
        raise ValueRangeError("observer_deg", f"expected the 2° or the 10° observer, not {observer_deg!r}")
    return np.stack([_tables()[f"{axis}{observer_deg}"] for axis in "xyz"], axis=-1)


def illuminant_power(illuminant: str = "D65") -> Floats:
    """Return the relative spectral power (421,) of one of :data:`ILLUMINANTS`, 360 to 780 nm at 1 nm."""
    if illuminant not in ILLUMINANTS:
        raise ValueRangeError("illuminant", f"expected one of {', '.join(ILLUMINANTS)}, not {illuminant!r}")
    return _tables()[illuminant]


@cache
def _integrand(illuminant: str, observer_deg: int) -> Floats:
    """Return 100 S x̄ / Σ S ȳ (421, 3), the weights of reflectance per nm."""
    weighted = illuminant_power(illuminant)[:, None] * colour_matching(observer_deg)
    return np.asarray(100.0 * weighted / weighted[:, 1].sum())


def white_xyz(illuminant: str = "D65", observer_deg: int = 10) -> Floats:
    """Return the white (3,), XYZ with Y = 100, of an illuminant for an observer.

    >>> white_xyz("D65", 10).round(1).tolist()
    [94.8, 100.0, 107.3]
    """
    return np.asarray(_integrand(illuminant, observer_deg).sum(axis=0))


def spectrum_weights(
    wavelengths_nm: npt.ArrayLike, illuminant: str = "D65", observer_deg: int = 10
) -> Floats:
    """Return the weights (k, 3) that turn a spectrum of k bands into XYZ: ``values @ weights``.

    Raises
    ------
    ValueRangeError
        The wavelengths are not rising numbers (k,) in nanometres, or illuminant or observer is unknown.
    """
    bands = np.asarray(wavelengths_nm, float)
    if bands.ndim != 1 or bands.size == 0:
        raise ValueRangeError("wavelengths_nm", f"expected a list of wavelengths, not shape {bands.shape}")
    if not np.all((bands >= _LOWEST_NM) & (bands <= _HIGHEST_NM)):
        raise ValueRangeError(
            "wavelengths_nm", f"expected wavelengths from {_LOWEST_NM:g} to {_HIGHEST_NM:g} nm"
        )
    if np.any(np.diff(bands) <= 0.0):
        raise ValueRangeError("wavelengths_nm", "the wavelengths must rise")
    return _weights(bands.tobytes(), illuminant, observer_deg)


@cache
def _weights(bands: bytes, illuminant: str, observer_deg: int) -> Floats:
    weights = _reading(np.frombuffer(bands), table_wavelengths()).T @ _integrand(illuminant, observer_deg)
    weights.flags.writeable = False
    return np.asarray(weights)


def _reading(bands: Floats, at: Floats) -> Floats:
    """Return the matrix (n, k) that interpolates a spectrum of k bands at n wavelengths."""
    count = min(4, len(bands))
    held = np.clip(at, bands[0], bands[-1])
    cell = np.clip(np.searchsorted(bands, held, side="right") - 1, 0, max(len(bands) - 2, 0))
    # Two bands on each side; at an end, or with fewer than four bands, the straight line between two.
    edge = (cell == 0) | (cell >= len(bands) - 2) | (count < 4)
    matrix = np.zeros((len(at), len(bands)))
    rows = np.arange(len(at))
    if len(bands) == 1:
        matrix[:, 0] = 1.0
        return matrix
    share = (held - bands[cell]) / (bands[cell + 1] - bands[cell])
    line = rows[edge]
    matrix[line, cell[line]] = 1.0 - share[line]
    matrix[line, cell[line] + 1] = share[line]
    cubic = rows[~edge]
    nodes = cell[cubic, None] + np.arange(-1, 3)
    points = bands[nodes]
    for j in range(4):
        others = [i for i in range(4) if i != j]
        top = np.prod(held[cubic, None] - points[:, others], axis=1)
        matrix[cubic, nodes[:, j]] = top / np.prod(points[:, [j]] - points[:, others], axis=1)
    return matrix


def spectrum_to_xyz(
    values: npt.ArrayLike,
    wavelengths_nm: npt.ArrayLike = DEFAULT_WAVELENGTHS_NM,
    illuminant: str = "D65",
    observer_deg: int = 10,
) -> Floats:
    """Return XYZ (..., 3), the white's Y = 100, of reflectance factors ``values`` (..., k) at k wavelengths."""
    values = np.asarray(values, float)
    weights = spectrum_weights(wavelengths_nm, illuminant, observer_deg)
    if values.ndim == 0 or values.shape[-1] != len(weights):
        raise ValueRangeError(
            "values", f"expected {len(weights)} values along the last axis, not shape {values.shape}"
        )
    return np.asarray(values @ weights)


def spectrum_to_lab(
    values: npt.ArrayLike,
    wavelengths_nm: npt.ArrayLike = DEFAULT_WAVELENGTHS_NM,
    illuminant: str = "D65",
    observer_deg: int = 10,
) -> Floats:
    """Return L*a*b* (..., 3) under the illuminant, relative to its own white."""
    return xyz_to_lab(
        spectrum_to_xyz(values, wavelengths_nm, illuminant, observer_deg), white_xyz(illuminant, observer_deg)
    )


def spectrum_to_working(
    values: npt.ArrayLike,
    wavelengths_nm: npt.ArrayLike = DEFAULT_WAVELENGTHS_NM,
    observer_deg: int = 10,
    illuminant: str = "D65",
) -> Floats:
    """Return the reflectance factor (..., 3) in the working space of spectra (..., k) under D65.

    Under another illuminant: of the colour that has the same L*a*b* under D65, as the eye that has adapted sees it.
    10°: by CAT16 to the working space's white, as L*a*b* readings are. 2°: that is the working space's own
    observer; only the last digits of the white are matched. A channel below 0 says that the colour lies outside.

    >>> spectrum_to_working([1.0, 1.0, 1.0], [400.0, 550.0, 700.0]).round(12).tolist()
    [1.0, 1.0, 1.0]
    """
    xyz = spectrum_to_xyz(values, wavelengths_nm, illuminant, observer_deg)
    relative = xyz / white_xyz(illuminant, observer_deg)
    if observer_deg == 10:
        return np.asarray(relative @ RELATIVE_TO_WORKING)
    return np.asarray(relative @ (np.linalg.inv(WORKING_TO_XYZ) * WORKING_TO_XYZ.sum(axis=1)).T)
