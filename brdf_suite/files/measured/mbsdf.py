"""MBSDF, the measured BSDF of NVIDIA's Material Definition Language (``.mbsdf``), read and written.

A line of text, ``NVIDIA ARC MBSDF V1``, then lines ``name="value"``, then ``MBSDF_DATA=`` or
``MBSDF_DATA_REFLECTION=``, and behind its line feed, little-endian: uint32 kind (0 grey, 1 RGB), uint32 n, uint32 m,
and n · n · m float32 or triples of them, f_r in 1/sr, of (θ of one direction, θ of the other, Δφ), Δφ fastest.
``MBSDF_DATA_TRANSMISSION=`` may follow in the same way. Both directions point away from the surface, so the mirror
direction is at Δφ = 180°.

The layout is that of the specification of the language (appendix "MBSDF file format") and of the source of its SDK; no
file of NVIDIA's was at hand. As in the SDK's evaluation, node k stands at k · 90°/n of θ and k · 180°/m of Δφ, and the
two orders of a pair are averaged. Other programs take the centres of those cells, half a cell further. RGB is taken as
linear Rec. 709.
"""

from __future__ import annotations

import struct

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import LONGEST_LINE
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import one_line
from brdf_suite.files.measured.grid_values import check_count, grid_of
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.isotropy import is_isotropic
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.angle_table import AngleTable
from brdf_suite.regular_files import read_bytes

MAGIC = b"NVIDIA ARC MBSDF V1\n"
_REFLECTION = (b"MBSDF_DATA=", b"MBSDF_DATA_REFLECTION=")
_TRANSMISSION = b"MBSDF_DATA_TRANSMISSION="
_HEAD = struct.Struct("<3I")
_LARGEST = 1 << 30
_MOST_ALONG = 4096
_MOST_LINES = 10_000
_THETA, _PHI = 90, 180
"""Nodes that are written: 1° of each angle, 17 MB."""


def read_mbsdf(path: PathLike, options: ReadOptions | None = None) -> AngleTable:
    """Return the reflection of a file; raise :class:`FileError` with the line or the byte of the first fault."""
    del options  # nothing there depends on an observer
    content = read_bytes(path, _LARGEST)
    if not content.startswith(MAGIC):
        raise FileError(path, f"does not begin with {MAGIC.decode().strip()!r}", "byte 0")
    facts: dict[str, object] = {"format": "MBSDF"}
    at, said = len(MAGIC), b""
    for line in range(2, _MOST_LINES):
        end = content.find(b"\n", at, at + LONGEST_LINE)
        if end < 0:
            raise FileError(path, "the text ends before MBSDF_DATA=", f"line {line}")
        said, at = content[at:end].rstrip(b"\r"), end + 1
        if said in (*_REFLECTION, _TRANSMISSION):
            break
        key, _, value = said.decode("ascii", "replace").partition("=")
        if len(facts) < 50 and value:
            facts.setdefault(one_line(key)[:40], one_line(_unquoted(value)))
    else:
        raise FileError(path, f"no MBSDF_DATA= within {_MOST_LINES:,} lines", f"line {_MOST_LINES}")
    if said == _TRANSMISSION:
        raise FileError(path, "holds transmission alone, no reflection", f"byte {at}")
    if at + _HEAD.size > len(content):
        raise FileError(path, "the file ends within the size of the table", f"byte {at}")
    kind, theta, phi = _HEAD.unpack_from(content, at)
    if kind > 1 or not (1 <= theta <= _MOST_ALONG and 1 <= phi <= _MOST_ALONG):
        raise FileError(path, f"kind {kind}, {theta} × {theta} × {phi} nodes are no table", f"byte {at}")
    at += _HEAD.size
    channels = 3 if kind else 1
    shape = (theta, theta, phi, channels)
    count = check_count(path, shape, (len(content) - at) // 4, f"byte {at}")
    rest = content[at + 4 * count :].lstrip(b"\r\n")
    if rest and not rest.startswith(_TRANSMISSION):
        raise FileError(path, "holds more bytes than its table takes", f"byte {at + 4 * count}")
    numbers = np.frombuffer(content, "<f4", count, at).reshape(shape)
    with np.errstate(invalid="ignore", over="ignore"):  # what is no finite number is refused with the table
        both = 0.5 * (numbers + numbers.transpose(1, 0, 2, 3))
    notes = ("Left out: its transmission.",) if rest else ()
    polar, turn = _nodes(theta, phi)
    return grid_of(
        path,
        "spherical",
        (polar, np.zeros(1), polar, turn),
        both[:, None],
        "rgb" if kind else "grey",
        lambda row: f"byte {at + 4 * channels * row}",
        facts=facts,
        notes=notes,
        mirrored=True,
    )


def _nodes(theta: int, phi: int) -> tuple[Floats, Floats]:
    polar, turn = (np.arange(float(count)) for count in (theta, phi))
    return polar * (0.5 * np.pi / theta), turn * (np.pi / phi)


def _unquoted(text: str) -> str:
    if not text.startswith('"'):
        return text
    return text[1:].removesuffix('"').replace('\\"', '"').replace("\\n", " ").replace("\\\\", "\\")


def write_mbsdf(value: Reflectance, path: PathLike) -> tuple[str, ...]:
    """Write an isotropic reflectance at 90 × 90 × 180 nodes, and return notes for the user.

    The table of an ``.mbsdf`` is written with its own nodes, and reads back as it was.

    Raises :class:`FileError`: the reflectance is not isotropic or not finite, or the file cannot be written.
    """

    if not is_isotropic(value):
        reason = "changes when the sample is turned; only isotropic reflectances are written in this format"
        raise FileError(path, f"cannot be written: the reflectance {reason}")
    to_709 = np.linalg.inv(REC709_TO_WORKING).T
    notes: list[str] = []
    if isinstance(value, AngleTable) and _is_own(value):
        table = np.asarray(value.values[:, 0], np.float64)
    else:
        table = _tabulate(value)
        step = 90 / _THETA
        notes.append(
            f"Tabulated every {step:g}°, as an isotropic reflectance; narrower highlights are widened."
        )
    if not np.isfinite(table).all():
        raise FileError(path, "cannot be written: the reflectance gives values that are not finite")
    theta, _, phi, channels = table.shape
    if channels == 3:
        table = table @ to_709
        lost = int(np.count_nonzero((table < -1e-6 * table.max()).any(axis=-1)))
        table = np.maximum(table, 0.0)
        if lost:
            notes.append(f"{lost:,} colours lie outside Rec. 709; their negative channel was written as 0.")
    text = one_line(getattr(value, "facts", {}).get("name", "")).replace("\\", "\\\\").replace('"', '\\"')
    head = MAGIC + (f'name="{text}"\n'.encode("ascii", "replace") if text else b"") + _REFLECTION[1] + b"\n"
    head += _HEAD.pack(1 if channels == 3 else 0, theta, phi)
    write_atomically(path, head + table.astype("<f4").tobytes())
    if getattr(value, "wavelengths_nm", None) is not None:
        notes.append("The spectra were left out: this format holds colours.")
    return tuple(notes)


def _tabulate(value: Reflectance) -> Floats:
    """Return f_r (n, n, m, 3) at the nodes, working space, the mean of both orders of each pair."""
    polar, turn = _nodes(_THETA, _PHI)
    # At the normal itself the azimuth between two directions has no meaning; a hair beside it has.
    polar = np.maximum(polar, 1e-9)
    views = spherical(polar[:, None], turn)
    table = np.stack([value.eval(spherical(angle, 0.0), views) for angle in polar.tolist()])
    return np.asarray(0.5 * (table + table.transpose(1, 0, 2, 3)))


def _is_own(grid: AngleTable) -> bool:
    """Whether the nodes of a table are those of an ``.mbsdf``."""
    if grid.coordinates != "spherical" or not grid.mirrored or grid.wavelengths_nm is not None:
        return False
    polar, turn = _nodes(grid.axes[0].size, grid.axes[3].size)
    return (
        grid.axes[0].size == grid.axes[2].size
        and np.allclose(grid.axes[0], polar)
        and np.allclose(grid.axes[2], polar)
        and np.allclose(grid.axes[3], turn)
    )


FORMAT = MeasuredFormat(
    name="mbsdf",
    title="MBSDF (NVIDIA MDL)",
    endings=(".mbsdf",),
    sniff=lambda head, _size: head.startswith(MAGIC),
    read=read_mbsdf,
    write=write_mbsdf,
)
