"""Polarimetric BRDFs (``.pbsdf``, Baek et al. 2020): their intensity, the element (0, 0) of the Mueller matrices.

A tensor file (see :mod:`brdf_suite.files.measured.rgl`) with float32 ``theta_h``, ``theta_d`` and ``phi_d`` (1, n),
radians, uint16 ``wvls`` (k,), nanometres, and float32 ``M`` (φd, θd, θh, k, 4, 4), 1/sr, isotropic, in half-angle
coordinates with the light as the first direction. The layout is that of Mitsuba's ``measured_polarized``, which is the
test's oracle; no file of the data set was at hand. NaN stands where a direction lies below the horizon; such nodes take
the value of the nearest measured one along θd, so that the cells across the horizon interpolate between like and like.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Bools, Floats, Singles
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import check_bands
from brdf_suite.files.measured.grid_values import check_count, grid_of
from brdf_suite.files.measured.rgl import MAGIC, Arrays, unpack
from brdf_suite.reflectance.tabulated.angle_table import AngleTable
from brdf_suite.regular_files import read_bytes

_LARGEST = 4 << 30  # the published materials have 361 × 91 × 91 nodes in 5 bands: 0.96 GB
_AXES = {"phi_d": 2.0 * np.pi, "theta_d": 0.5 * np.pi, "theta_h": 0.5 * np.pi}
_SLACK = 1e-3


def read_polarized(path: PathLike, options: ReadOptions | None = None) -> AngleTable:
    """Return the intensity of a file's Mueller matrices; raise :class:`FileError` with the field of the first fault."""
    arrays = unpack(read_bytes(path, _LARGEST), path)
    axes = {name: _axis(path, arrays, name, most) for name, most in _AXES.items()}
    bands = _field(path, arrays, "wvls", np.uint16, 1)
    wavelengths = check_bands(path, bands.astype(float).tolist(), "the field 'wvls'")
    matrices = _field(path, arrays, "M", np.float32, 6)
    shape = (*(axis.size for axis in axes.values()), bands.size, 4, 4)
    if matrices.shape != shape:
        raise FileError(path, f"expected the shape {shape}, not {matrices.shape}", "the field 'M'")
    check_count(path, shape[:4], matrices.size, "the field 'M'")
    # (φd, θd, θh, k) of the file to (θh, one azimuth, θd, φd, k).
    intensity = _fill(path, np.ascontiguousarray(matrices[..., 0, 0].transpose(2, 1, 0, 3)))
    phi = axes["phi_d"]
    if phi.size > 1 and phi[-1] - phi[0] > 2.0 * np.pi - 1e-4:  # both ends of the turn; they are one azimuth
        phi, intensity = phi[:-1], intensity[:, :, :-1]
    return grid_of(
        path,
        "half_difference",
        (axes["theta_h"], np.zeros(1), axes["theta_d"], phi),
        np.ascontiguousarray(intensity[:, None]),
        "spectra",
        lambda _row: "the field 'M'",
        facts={"format": "polarimetric BRDF (pBSDF)"},
        notes=("The polarization was left out; the reflectance is that of unpolarized light.",),
        wavelengths_nm=wavelengths,
        observer_deg=(options or ReadOptions()).observer_deg,
    )


def _field(path: PathLike, arrays: Arrays, name: str, kind: type, dimensions: int) -> Singles:
    if name not in arrays:
        raise FileError(path, f"the field {name!r} is missing", "the list of fields")
    found = arrays[name]
    if found.dtype != kind or found.ndim != dimensions:
        expected = f"{np.dtype(kind)} of {dimensions} dimensions"
        reason = f"expected {expected}, not {found.dtype} of the shape {found.shape}"
        raise FileError(path, reason, f"the field {name!r}")
    return found  # type: ignore[return-value] # as just checked


def _axis(path: PathLike, arrays: Arrays, name: str, most: float) -> Floats:
    with np.errstate(invalid="ignore"):  # a signalling NaN is refused below, as any other
        axis = _field(path, arrays, name, np.float32, 2).astype(np.float64)
    least = -most if name == "phi_d" else 0.0
    place = f"the field {name!r}"
    if axis.shape[0] != 1:
        raise FileError(path, f"expected the shape (1, n), not {axis.shape}", place)
    axis = axis[0]
    # A NaN fails the comparison, as it should.
    rising = axis[0] >= least - _SLACK and axis[-1] <= most + _SLACK and (np.diff(axis) > 1e-6).all()
    if not rising or axis[-1] - axis[0] > 2.0 * np.pi + _SLACK:
        raise FileError(path, f"expected angles that rise within {least:.5g} to {most:.5g}", place)
    return np.asarray(axis)


def _fill(path: PathLike, values: Singles) -> Singles:
    """Return values (θh, θd, φd, k) with NaN replaced along θd, then along θh; infinite ones are refused later."""
    known: Bools = np.asarray(~np.isnan(values).any(axis=-1))
    if not known.any():
        raise FileError(path, "holds NaN alone", "the field 'M'")
    for axis in (1, 0):
        for step in (1, -1):
            values, known = _carry(values, known, axis, step)
    values[~known] = 0.0
    return values


def _carry(values: Singles, known: Bools, axis: int, step: int) -> tuple[Singles, Bools]:
    """Carry known values along an axis to unknown ones behind them."""
    count = values.shape[axis]
    order = range(1, count) if step > 0 else range(count - 2, -1, -1)
    for index in order:
        here, before = ([slice(None)] * axis + [place] for place in (index, index - step))
        gap = ~known[tuple(here)] & known[tuple(before)]
        values[tuple(here)][gap] = values[tuple(before)][gap]
        known[tuple(here)] |= gap
    return values, known


FORMAT = MeasuredFormat(
    name="pbsdf",
    title="Polarimetric BRDF (intensity)",
    endings=(".pbsdf",),
    sniff=lambda head, _size: head.startswith(MAGIC) and b"wvls" in head[:4096] and b"theta_d" in head[:4096],
    read=read_polarized,
)
