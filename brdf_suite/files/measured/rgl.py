"""RGL ``.bsdf`` files (Dupuy & Jakob 2018): read into a TensorReflectance, and written from one.

Files with a field ``rgb`` hold linear Rec. 709; those with ``spectra`` and ``wavelengths`` hold spectra. Both
are kept as they are, so that reading and writing again loses nothing.

The container holds named arrays, little-endian, each at its offset: ``tensor_file\\0``, two bytes of version (1, 0),
u32 number of fields; for each field u16 length of the name, the name, u16 number of dimensions, u8 type, u64 offset,
u64 per dimension. The arrays are in C order.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Singles
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.bounded_reading import MOST_BANDS
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance
from brdf_suite.regular_files import read_bytes

MAGIC = b"tensor_file\0"
_VERSION = (1, 0)

_KINDS = ("<u1", "<i1", "<u2", "<i2", "<u4", "<i4", "<u8", "<i8", "<f2", "<f4", "<f8")
_TYPES = dict(enumerate(_KINDS, start=1))
_CODES = {np.dtype(kind): code for code, kind in _TYPES.items()}

_MOST_FIELDS = 256
_MOST_DIMENSIONS = 16
_ALIGNMENT = 8

Arrays = dict[str, npt.NDArray[np.generic]]


def unpack(content: bytes, path: PathLike) -> Arrays:
    """Return the arrays of a tensor file, as read-only views into ``content``.

    Raises :class:`FileError`: the header is damaged, or an array lies outside the file; with the byte offset.
    """
    place = 0

    def take(layout: str, what: str) -> tuple[int, ...]:
        nonlocal place
        size = struct.calcsize(layout)
        if place + size > len(content):
            raise FileError(path, f"the file ends within {what}", f"byte {place}")
        found: tuple[int, ...] = struct.unpack_from(layout, content, place)
        place += size
        return found

    if not content.startswith(MAGIC):
        raise FileError(path, 'does not begin with "tensor_file"', "byte 0")
    place = len(MAGIC)
    version = take("<BB", "the version")
    if version[0] != _VERSION[0]:
        raise FileError(
            path, f"has version {version[0]}.{version[1]}; only 1.x is known", f"byte {len(MAGIC)}"
        )
    (count,) = take("<I", "the number of fields")
    if count > _MOST_FIELDS:
        raise FileError(
            path, f"names {count} fields, more than the {_MOST_FIELDS} allowed", f"byte {place - 4}"
        )
    arrays: Arrays = {}
    for _ in range(count):
        start = place
        (length,) = take("<H", "the name of a field")
        if place + length > len(content):
            raise FileError(path, "the file ends within the name of a field", f"byte {place}")
        name = content[place : place + length].decode("ascii", "replace")
        place += length
        shown = repr(name[:40])
        dimensions, kind, offset = take("<HBQ", f"the field {shown}")
        if kind not in _TYPES:
            raise FileError(path, f"the field {shown} has the unknown type {kind}", f"byte {start}")
        if dimensions > _MOST_DIMENSIONS:
            raise FileError(path, f"the field {shown} has {dimensions} dimensions", f"byte {start}")
        shape = take(f"<{dimensions}Q", f"the field {shown}")
        dtype = np.dtype(_TYPES[kind])
        size = dtype.itemsize
        for extent in shape:  # Python's integers: no overflow can make this small again
            size *= extent
        if 0 in shape or offset + size > len(content):
            reason = f"the field {shown} of shape {shape} does not fit into the file"
            raise FileError(path, reason, f"byte {start}")
        if name in arrays:
            raise FileError(path, f"the field {shown} is given twice", f"byte {start}")
        flat = np.frombuffer(content, dtype, size // dtype.itemsize, offset)
        arrays[name] = flat.reshape(shape)
    return arrays


def pack(arrays: Mapping[str, npt.NDArray[np.generic]]) -> bytes:
    """Return the content of a tensor file with ``arrays``, each beginning at a multiple of 8 bytes."""
    held = {name: np.ascontiguousarray(array) for name, array in arrays.items()}
    place = len(MAGIC) + 2 + 4
    place += sum(2 + len(name) + 2 + 1 + 8 + 8 * array.ndim for name, array in held.items())
    header = [MAGIC, struct.pack("<BBI", *_VERSION, len(held))]
    body: list[bytes] = []
    for name, array in held.items():
        gap = -place % _ALIGNMENT
        little = array.astype(array.dtype.newbyteorder("<"), copy=False)
        offset = place + gap
        header.append(struct.pack("<H", len(name)) + name.encode("ascii"))
        header.append(struct.pack("<HBQ", array.ndim, _CODES[little.dtype], offset))
        header.append(struct.pack(f"<{array.ndim}Q", *array.shape))
        body += [b"\0" * gap, little.tobytes()]
        place = offset + array.nbytes
    return b"".join(header + body)


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

    Raises :class:`FileError`: the reflectance is not isotropic or not finite, or the file cannot be written.
    """
    from brdf_suite.reflectance.tensor.tabulate import tabulate  # only writers need it

    try:
        tensor = value if isinstance(value, TensorReflectance) else tabulate(value)
    except ValueRangeError as error:
        raise FileError(path, f"cannot be written: the {error.place} {error.reason}") from error
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


FORMAT = MeasuredFormat(
    name="rgl",
    title="RGL material (adaptive parameterization)",
    endings=(".bsdf",),
    # A polarimetric file is of the same container, and has other fields.
    sniff=lambda head, _size: head.startswith(MAGIC) and b"wvls" not in head[:4096],
    read=read_rgl,
    write=write_rgl,
)
