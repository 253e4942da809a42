"""RGL ``.bsdf`` files (Dupuy & Jakob 2018): read into a TensorReflectance, and written from one.

Files with a field ``rgb`` hold linear Rec. 709; those with ``spectra`` and ``wavelengths`` hold spectra. Both
are kept as they are, so that reading and writing again loses nothing.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Singles
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.bounded_reading import MOST_BANDS, read_bytes
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.tensor_file import MAGIC, Arrays, pack, unpack
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

_LARGEST = 2 << 30  # an anisotropic spectral material is about 200 MB

_OWN = {
    "description", "phi_i", "theta_i", "sigma", "ndf", "vndf", "luminance", "rgb", "spectra", "wavelengths",
    "jacobian",
}  # fmt: skip


def read_rgl(path: PathLike, options: ReadOptions | None = None) -> TensorReflectance:
    """Return the material of a ``.bsdf`` file.

    Raises
    ------
    FileError
        The container is damaged, an array is missing or of the wrong shape, or holds numbers that cannot be.
    """
    fields = _Fields(path, unpack(read_bytes(path, _LARGEST), path))
    phi_i = fields.rising("phi_i", -2.0 * math.pi, 2.0 * math.pi)
    theta_i = fields.rising("theta_i", 0.0, 0.5 * math.pi)
    directions = (len(phi_i), len(theta_i))
    vndf = fields.grids("vndf", directions, 4)
    fields.densities("vndf", vndf)
    luminance = fields.grids("luminance", directions, 4)
    fields.densities("luminance", np.maximum(luminance, 0.0))
    ndf, sigma = fields.grids("ndf", (), 2), fields.grids("sigma", (), 2)
    spectral = "spectra" in fields.arrays
    values = fields.grids("spectra" if spectral else "rgb", directions, 5)
    bands = fields.rising("wavelengths", 100.0, 10_000.0) if spectral else None
    channels = 3 if bands is None else len(bands)
    if channels > MOST_BANDS:
        fields.fail("wavelengths", f"{channels} bands are more than the {MOST_BANDS} allowed")
    if values.shape[2] != channels:
        reason = f"{values.shape[2]} channels; expected {channels}"
        fields.fail("spectra" if spectral else "rgb", reason)
    own = _OWN - {"rgb"} if spectral else _OWN  # a file may hold both; the other one is kept
    description = fields.bytes_of("description").tobytes().decode("utf-8", "replace")
    jacobian = fields.bytes_of("jacobian")
    if jacobian.size != 1:
        fields.fail("jacobian", "expected one byte")
    return TensorReflectance(
        phi_i, theta_i, ndf, sigma, vndf, luminance, values, bands,
        jacobian=bool(jacobian[0]),
        description=description,
        observer_deg=(options or ReadOptions()).observer_deg,
        source=str(path),
        other={name: array for name, array in fields.arrays.items() if name not in own},
    )  # fmt: skip


class _Fields:
    """The arrays of one file; errors name the field."""

    def __init__(self, path: PathLike, arrays: Arrays) -> None:
        self.path, self.arrays = path, arrays

    def fail(self, name: str, reason: str) -> None:
        raise FileError(self.path, reason, f"the field {name!r}")

    def take(self, name: str) -> npt.NDArray[np.generic]:
        if name not in self.arrays:
            raise FileError(self.path, f"the field {name!r} is missing", "the list of fields")
        return self.arrays[name]

    def bytes_of(self, name: str) -> npt.NDArray[np.uint8]:
        array = self.take(name)
        if array.ndim != 1 or array.dtype != np.uint8:
            self.fail(name, f"expected bytes, not {array.dtype} of shape {array.shape}")
        return array.astype(np.uint8, copy=False)

    def floats(self, name: str, dimensions: int) -> Singles:
        array = self.take(name)
        if array.ndim != dimensions or array.dtype != np.float32:
            self.fail(name, f"expected float32 of {dimensions} dimensions, not {array.dtype} {array.shape}")
        floats = array.astype(np.float32, copy=False)
        # The sum is finite only if every number is, and needs no array of its own; 1e30 keeps it from overflowing.
        if not (np.isfinite(floats.min()) and np.isfinite(floats.max())):
            self.fail(name, "holds a number that is not finite")
        if max(abs(float(floats.min())), abs(float(floats.max()))) > 1e30:
            self.fail(name, "holds a number over 1e30")
        return floats

    def rising(self, name: str, low: float, high: float) -> Singles:
        axis = self.floats(name, 1)
        slack = 1e-4 * (high - low)
        if axis[0] < low - slack or axis[-1] > high + slack or np.any(np.diff(axis.astype(float)) <= 1e-6):
            self.fail(name, f"expected numbers rising within {low:g} and {high:g}")
        return axis

    def grids(self, name: str, directions: tuple[int, ...], dimensions: int) -> Singles:
        grids = self.floats(name, dimensions)
        if grids.shape[: len(directions)] != directions:
            reason = f"the shape {grids.shape} does not begin with {directions}, the incident directions"
            self.fail(name, reason)
        if min(grids.shape[-2:]) < 2:
            self.fail(name, f"expected grids of at least 2 x 2, not shape {grids.shape}")
        return grids

    def densities(self, name: str, grids: Singles) -> None:
        if grids.min() < 0.0:
            self.fail(name, "a density is negative")
        # What the trapezium rule gives the inner nodes; it is what the warp divides by.
        inner = grids.sum(axis=(-2, -1), dtype=np.float64)
        if not np.all(inner > 1e-30):
            self.fail(name, "the density of an incident direction is zero everywhere")


def write_rgl(value: Reflectance, path: PathLike) -> tuple[str, ...]:
    """Write a reflectance so that Mitsuba's ``measured`` reads it, and return notes for the user.

    A TensorReflectance is written as it is; any other isotropic reflectance is tabulated first
    (:func:`~brdf_suite.reflectance.tensor.tabulate.tabulate`), with its spectra where it has them.

    Raises
    ------
    FileError
        The reflectance is not isotropic or not finite, or the file cannot be written.
    """
    tensor = value if isinstance(value, TensorReflectance) else _tabulated(value, path)
    text = tensor.description.encode("utf-8") or b" "
    arrays: Arrays = {
        "version": np.array([1, 0], np.uint32),
        **tensor.other,
        "description": np.frombuffer(text, np.uint8),
        "phi_i": tensor.phi_i,
        "theta_i": tensor.theta_i,
        "sigma": tensor.sigma,
        "ndf": tensor.ndf,
        "vndf": tensor.vndf,
        "luminance": tensor.luminance,
    }
    if tensor.wavelengths_nm is None:
        arrays["rgb"] = tensor.values
    else:
        arrays["spectra"] = tensor.values
        arrays["wavelengths"] = tensor.wavelengths_nm
    arrays["jacobian"] = np.array([1 if tensor.jacobian else 0], np.uint8)
    write_atomically(path, pack(arrays))
    if tensor is value:
        return ()
    notes = [
        "Tabulated: for a paint, interpolation errs by about 2 in 10,000 in the middle of the hemisphere, and by"
        " percents within some degrees of the horizon."
    ]
    if tensor.wavelengths_nm is None and _leaves_rec_709(tensor):
        notes.append("Some colours lie outside Rec. 709; a renderer may take their negative channel as 0.")
    return tuple(notes)


def _leaves_rec_709(tensor: TensorReflectance) -> bool:
    """Whether a channel is negative where it can be seen (the table also holds continuations that cannot)."""
    theta, phi = np.meshgrid(np.linspace(0.0, 1.4, 12), np.linspace(0.0, math.pi, 9))
    wi, wo = spherical([[[0.2]], [[0.8]]], 0.0), spherical(theta, phi)
    channels = tensor.eval_channels(wi, wo)
    return bool((channels < -1e-3 * np.abs(channels).max(axis=-1, keepdims=True)).any())


def _tabulated(value: Reflectance, path: PathLike) -> TensorReflectance:
    from brdf_suite.reflectance.tensor.tabulate import tabulate  # only writers need it

    try:
        return tabulate(value)
    except ValueRangeError as error:
        raise FileError(path, f"cannot be written: the {error.place} {error.reason}") from error


FORMAT = MeasuredFormat(
    name="rgl",
    title="RGL material (adaptive parameterization)",
    endings=(".bsdf",),
    sniff=lambda head, _size: head.startswith(MAGIC),
    read=read_rgl,
    write=write_rgl,
)
