"""MERL's isotropic tables (.binary), read and written.

Layout (Matusik, Pfister, Brand and McMillan, "A Data-Driven Reflectance Model", 2003), little-endian: three int32,
the bins along (θh, θd, φd); then three planes of float64, red, green and blue, each with the place
φd + n_φd·(θd + n_θd·θh). A stored value is f_r·1500 / (1, 1.15, 1.66) of linear Rec. 709; a negative one, in any
channel, is a hole. Met as well: φd over 360° (both orders of a pair apart, or with MERL's own header of 360 above
180 bins), single and half precision, and tables that hold f_r itself. Precision follows from the file's size; where two
fit, a header of 360 above 180 bins and a narrower type, the one counts in which neighbours differ less. The factors are
decided by energy: a surface of more than 0.2 % reflectance, taken without them, would reflect more light than it got.
"""

from __future__ import annotations

import math
import os
import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, WORKING_TO_SRGB
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.measured.format import MeasuredFormat, tabulation_notes
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid, fill_holes
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.regular_files import open_regular

SCALE = np.array([1.0, 1.15, 1.66]) / 1500.0
"""f_r of a stored 1, per channel."""

_HEADER = struct.Struct("<3i")
_LARGEST = 1 << 30
_MOST_ALONG = 4096
# No reflectance is larger: a mirror of the finest bin has 1e8 per steradian.
_LARGEST_VALUE = 1e20
_BLOCK = 1 << 15
# Of the first numbers of a file whose size fits two types.
_TRIED = 1 << 18
_FEWEST_PAIRS = 16

# Taken without factors: real tables of f_r stay below the first albedo, tables with factors above the second.
_SURELY_PLAIN, _DIVIDE, _SURELY_SCALED = 1.5, 3.0, 9.0


def read_merl(
    path: PathLike, *, scale_factors: bool | None = None, average_reciprocal: bool = False
) -> IsotropicTable:
    """Return the table in the file, in the working space, its holes filled from their neighbours.

    Parameters
    ----------
    path
        A file as described above.
    scale_factors
        Whether the stored values carry MERL's factors; ``None``: detect it. What was found is said in the
        ``facts`` of the table.
    average_reciprocal
        Take the mean of a pair and its swap, where the table holds both (φd over 360°).

    Raises
    ------
    FileError
        The file is missing, truncated, of another kind, holds a value that is not finite, or no value.
    """
    grid, planes, notes = _read_planes(path)
    known = planes.min(axis=0) >= 0.0
    if not known.any():
        raise FileError(path, "every bin is negative, which means not measured", "byte 12")
    albedo = stored_albedo(planes, grid)
    found = scale_factors is None
    if scale_factors is None:
        scale_factors = albedo > _DIVIDE
        if _SURELY_PLAIN < albedo < _SURELY_SCALED:
            notes.append(
                f"whether it carries MERL's scale factors is uncertain (its reflectance without them is {albedo:.3g}); "
                f"it was read as {'carrying them' if scale_factors else 'plain f_r'}"
            )
        elif not scale_factors:
            notes.append("it holds plain f_r, without MERL's scale factors, judged by its energy")
    values = _to_working(planes, SCALE if scale_factors else np.ones(3), grid)
    holes = ~known.reshape(grid.shape)
    filled = fill_holes(values, holes, grid)
    missing = int(np.count_nonzero(holes & grid.above_horizon()))
    if missing:
        notes.append(
            f"{missing:,} bins above the horizon were not measured and were filled from their neighbours"
        )
    facts: dict[str, Any] = {
        "format": "MERL",
        "bins": " × ".join(str(n) for n in grid.shape),
        "phi_d_range_deg": 180 if grid.reciprocal else 360,
        "colour": "RGB, Rec. 709",
        "scale_factors": bool(scale_factors),
        "scale_factors_found_by": "energy" if found else "the user",
        "holes": int(np.count_nonzero(holes)),
        "holes_above_horizon": missing,
        "bins_filled": filled,
    }
    if average_reciprocal and not grid.reciprocal:
        notes.append("a pair and its swap were averaged")
    facts["notes"] = tuple(notes)
    table = IsotropicTable(values, holes, grid.reciprocal, os.fspath(path), facts)
    return table.made_reciprocal() if average_reciprocal else table


def write_merl(value: Reflectance, path: PathLike, *, scale_factors: bool = True) -> tuple[str, ...]:
    """Write ``value`` in MERL's layout, 90 × 90 × 180 unless it is a table of other bins; return notes.

    Anything but a table is tabulated first, at the centres of the bins. A table whose holes are known is
    written with them. Rec. 709 is narrower than the working space: negative channels become 0, because a
    negative one would read as a hole; a note states how many.

    Raises :class:`FileError`: the file cannot be written; the old one, if any, is as it was.
    """
    notes: list[str] = []
    if isinstance(value, IsotropicTable):
        table = value
    else:
        table = IsotropicTable.from_reflectance(value)
        notes += tabulation_notes(value)
    if not table.reciprocal:
        table = table.made_reciprocal()
        notes.append("a pair and its swap were averaged: the layout holds φd from 0 to 180°")
    planes = np.empty((3, table.grid.bins), "<f8")
    rows = table.values.reshape(-1, 3)
    matrix = WORKING_TO_SRGB / (SCALE if scale_factors else np.ones(3))[:, None]
    for start in range(0, len(rows), _BLOCK):
        part = slice(start, start + _BLOCK)
        planes[:, part] = matrix @ rows[part].T.astype(np.float64)
    # Rounding of a grey leaves a channel at -1e-17: that is a 0, no lost colour.
    lost = int(np.count_nonzero((planes < -1e-6 * planes.max(axis=0)).any(axis=0)))
    np.maximum(planes, 0.0, out=planes)
    planes[:, np.asarray(table.holes).reshape(-1)] = -1.0
    if lost:
        notes.append(
            f"{lost:,} bins are too saturated for Rec. 709; their negative channels were written as 0"
        )
    with replacing(path) as temporary, temporary.open("wb") as stream:
        stream.write(_HEADER.pack(*table.grid.shape))
        stream.write(planes.data)
    return tuple(notes)


def stored_albedo(planes: Floats, grid: HalfAngleGrid) -> float:
    """Return the mean reflectance (per 1, over channels) at 45° incidence if the stored values were f_r.

    From the nearest bins of 4,096 cosine-weighted views; holes are left out.
    """
    side = 64
    u = (np.arange(side) + 0.5) / side
    views = spherical(np.arcsin(np.sqrt(u))[:, None], 2.0 * np.pi * u[None, :]).reshape(-1, 3)
    lights = np.broadcast_to(spherical(np.pi / 4.0, 0.0), views.shape)
    h, d, p = grid.index_of(np.ascontiguousarray(lights.T), np.ascontiguousarray(views.T))
    h, d, p = (np.minimum(x.astype(np.intp), n - 1) for x, n in zip((h, d, p), grid.shape, strict=True))
    stored = planes[:, (h * grid.theta_d + d) * grid.phi_d + p]
    stored = stored[:, (stored >= 0.0).all(axis=0)]
    # Nothing measured around 45°: all there is then decides.
    stored = stored if stored.size else planes[:, (planes >= 0.0).all(axis=0)]
    return float(np.pi * stored.mean())


def _read_planes(path: PathLike) -> tuple[HalfAngleGrid, Floats, list[str]]:
    """Return the bins, the stored values (3, bins), and notes."""
    with open_regular(path, _LARGEST) as stream:
        size = os.fstat(stream.fileno()).st_size
        layout = _layout_of(path, stream.read(_HEADER.size), size, stream.read(_TRIED))
        stream.seek(_HEADER.size)
        stored = np.fromfile(stream, layout.kind, 3 * layout.grid.bins)
    if stored.size != 3 * layout.grid.bins:
        raise FileError(path, "became shorter while it was read")
    with np.errstate(invalid="ignore"):  # a damaged NaN is refused just below
        planes = stored.astype(np.float64, copy=False).reshape(3, layout.grid.bins)
    # A NaN fails the comparison, as it should.
    if not (planes.max() <= _LARGEST_VALUE and planes.min() >= -_LARGEST_VALUE):
        at = int(np.argmax(~(np.abs(planes.reshape(-1)) <= _LARGEST_VALUE)))
        place = f"byte {_HEADER.size + stored.itemsize * at}"
        raise FileError(path, "holds a value that is no finite reflectance", place)
    return layout.grid, planes, layout.notes


@dataclass(frozen=True)
class _Layout:
    """Bins, type of the stored numbers, and notes."""

    grid: HalfAngleGrid
    kind: str
    notes: list[str]


def _layout_of(path: PathLike, head: bytes, size: int, start: bytes) -> _Layout:
    if len(head) < _HEADER.size:
        raise FileError(path, f"is cut off: {size} bytes are less than a header", "byte 0")
    theta_h, theta_d, phi_d = _HEADER.unpack(head)
    if not all(2 <= n <= _MOST_ALONG for n in (theta_h, theta_d, phi_d)):
        raise FileError(
            path, f"claims {theta_h} × {theta_d} × {phi_d} bins, so it is not a MERL table", "byte 0"
        )
    found = _fitting(theta_h, theta_d, phi_d, size)
    if found and (found[0][1] != phi_d or phi_d in (2 * theta_d, 4 * theta_d)):
        rough = [_roughness(start, kind) for kind, _ in found] if len(found) > 1 else [0.0]
        # Where nothing can be compared, MERL's own type.
        kind, bins = found[int(np.argmin(rough)) if min(rough) < math.inf else -1]
        notes = []
        if bins != phi_d:
            notes.append(f"its header names {phi_d} bins of φd; the file holds {bins}, over 180°")
        if kind != "<f8":
            notes.append(f"it stores {'single' if kind == '<f4' else 'half'} precision")
        return _Layout(HalfAngleGrid(theta_h, theta_d, bins, reciprocal=bins != 4 * theta_d), kind, notes)
    if found:
        raise FileError(
            path,
            f"has {phi_d} bins of φd beside {theta_d} of θd; {2 * theta_d} (over 180°) or {4 * theta_d} are known",
            "byte 8",
        )
    wanted = _HEADER.size + 24 * theta_h * theta_d * phi_d
    state = "cut off" if size < wanted else "too long"
    raise FileError(
        path,
        f"is {state}: {theta_h} × {theta_d} × {phi_d} bins take {wanted:,} bytes, the file has {size:,}",
        f"byte {min(size, wanted)}",
    )


def _fitting(theta_h: int, theta_d: int, phi_d: int, size: int) -> list[tuple[str, int]]:
    """Return the types, narrowest first, and bins of φd for which a file of ``size`` bytes is whole."""
    counts = (phi_d, phi_d // 2) if phi_d == 4 * theta_d else (phi_d,)
    return [
        (kind, bins)
        for kind, width in (("<f2", 2), ("<f4", 4), ("<f8", 8))
        for bins in counts
        if size == _HEADER.size + 3 * width * theta_h * theta_d * bins
    ]


def _roughness(start: bytes, kind: str) -> float:
    """Return the median of |log2| of the ratio of neighbours, of the first numbers; infinite where there are few."""
    width = np.dtype(kind).itemsize
    with np.errstate(invalid="ignore"):  # of bytes that are no numbers of this type
        numbers = np.frombuffer(start[: len(start) // width * width], kind).astype(np.float64)
        usable = (numbers > 0.0) & (numbers < np.inf)
    pairs = usable[:-1] & usable[1:]
    if np.count_nonzero(pairs) < _FEWEST_PAIRS:
        return math.inf
    logs = np.log2(np.where(usable, numbers, 1.0))
    return float(np.median(np.abs(np.diff(logs)[pairs])))


def _to_working(
    planes: Floats, scale: npt.NDArray[np.float64], grid: HalfAngleGrid
) -> npt.NDArray[np.float32]:
    """Return (θh, θd, φd, 3) float32, f_r in the working space; what a hole becomes does not matter."""
    values = np.empty((grid.bins, 3), np.float32)
    matrix = REC709_TO_WORKING * scale
    for start in range(0, grid.bins, _BLOCK):
        part = slice(start, start + _BLOCK)
        values[part] = (matrix @ planes[:, part]).T
    return values.reshape(*grid.shape, 3)


def _sniff(head: bytes, size: int) -> bool:
    if len(head) < _HEADER.size:
        return False
    theta_h, theta_d, phi_d = _HEADER.unpack_from(head)
    if not all(2 <= n <= _MOST_ALONG for n in (theta_h, theta_d, phi_d)):
        return False
    # A cut-off file of the usual size is still one, and its reader says what is wrong.
    usual = (theta_h, theta_d) == (90, 90) and phi_d in (180, 360)
    return usual or bool(_fitting(theta_h, theta_d, phi_d, size))


FORMAT = MeasuredFormat(
    "merl",
    "MERL isotropic table",
    (".binary", ".merl"),
    _sniff,
    lambda path, options: read_merl(
        path, scale_factors=options.scale_factors, average_reciprocal=options.average_reciprocal
    ),
    write_merl,
)
