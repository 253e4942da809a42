"""SSDD, "surface scattering distribution data" (``.ssdd``): tables over angles, as text or binary.

Layout from the public specification, version 0.2 (``doc/SsddFileFormatSpecification.md`` of libbsdf). A header that
begins with ``VERSION``, then up to four blocks. A block is text from ``DATA_TYPE`` to ``DATA``, and its values behind:
``DATA ascii`` one colour a line, ``DATA binary`` little-endian float32. The first parameter runs fastest. Angles are in
degrees, both directions point away from the surface.

Read is the block ``brdf``; transmission and the shares of a mirror are left out, with a notice. The specification
leaves the RGB open; it is taken as linear Rec. 709. In the specular system the turn 0 points towards the normal,
which the specification leaves open too: so it is in the source of libbsdf.
"""

from __future__ import annotations

from array import array
from dataclasses import replace

import numpy as np

from brdf_suite.arrays import Floats, Reals
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import LONGEST_LINE, number_in
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import check_bands, one_line
from brdf_suite.files.measured.grid_values import Meaning, check_axis, check_count, grid_of
from brdf_suite.reflectance.tabulated.angle_table import AngleTable, Coordinates
from brdf_suite.regular_files import read_bytes

_LARGEST = 1 << 30
_MOST_ANGLES = 100_000
_MOST_BLOCKS = 4
_MOST_ENTRIES = 1000

_TYPES = ("brdf", "btdf", "specular_reflectance", "specular_transmittance")
_SYSTEMS: dict[str, tuple[Coordinates, tuple[float, float, float, float]]] = {
    "spherical_coordinate_system": ("spherical", (90.0, 360.0, 90.0, 360.0)),
    "specular_coordinate_system": ("specular", (90.0, 360.0, 180.0, 360.0)),
    "half_difference_coordinate_system": ("half_difference", (90.0, 360.0, 90.0, 360.0)),
}
_MODELS: dict[str, tuple[Meaning, int]] = {
    "monochrome": ("grey", 1), "rgb": ("rgb", 3), "xyz": ("xyz", 3), "spectrum": ("spectra", 0),
}  # fmt: skip
_LISTS = tuple(f"PARAM{index}_LIST" for index in range(5))
_LEFT_OUT = {
    "btdf": "transmission (BTDF)",
    "specular_reflectance": "the reflectance of a mirror direction alone (specular_reflectance)",
    "specular_transmittance": "specular transmittance",
}


def read_ssdd(path: PathLike, options: ReadOptions | None = None) -> AngleTable:
    """Return the BRDF of a file; raise :class:`FileError` with the line or byte of the first fault."""
    observer_deg = (options or ReadOptions()).observer_deg
    reader = _Reader(path, read_bytes(path, _LARGEST))
    header = reader.entries("DATA_TYPE")
    if "VERSION" not in header:
        raise FileError(path, "does not begin with VERSION", "line 1")
    found: AngleTable | None = None
    left_out: list[str] = []
    seen: list[str] = []
    while reader.more():
        block = reader.entries("DATA")
        kind = block.word("DATA_TYPE", _TYPES)
        if kind in seen:
            raise block.fail("DATA_TYPE", f"the block {kind} is given twice")
        seen.append(kind)
        table = _Table(block, kind)
        values = reader.values(block, table.shape, keep=kind == "brdf")
        if kind != "brdf":
            left_out.append(_LEFT_OUT[kind])
            continue
        facts: dict[str, object] = {"format": "SSDD", "name": block.text("NAME")}
        facts |= {key.lower(): block.text(key) for key in ("SOURCE_TYPE", "DEVICE") if key in block}
        found = table.grid(values, facts, observer_deg)
    if found is None:
        held = ", ".join(left_out) or "no block"
        raise FileError(path, f"holds no BRDF; it has {held}", "the list of blocks")
    if not left_out:
        return found
    notes = (*found.facts.get("notes", ()), f"Left out: {'; '.join(left_out)}.")
    return replace(found, facts={**found.facts, "notes": notes})


class _Block:
    """Entries of a header or a block by their names, each with its line."""

    def __init__(self, path: PathLike) -> None:
        self.path = path
        self._entries: dict[str, tuple[str, int]] = {}
        self.end = 0
        self.line = 0

    def __contains__(self, key: str) -> bool:
        return key in self._entries

    def add(self, key: str, rest: str, line: int) -> None:
        if not key[:1].isalpha():
            raise FileError(self.path, f"expected an entry, not {key[:40]!r}", f"line {line}")
        if key in self._entries:
            raise FileError(self.path, f"{key[:40]} is given twice", f"line {line}")
        self._entries[key] = (rest, line)

    def text(self, key: str) -> str:
        return one_line(self._entries.get(key, ("", 0))[0])

    def place(self, key: str) -> str:
        return f"line {self._entries[key][1] if key in self._entries else self.line}"

    def fail(self, key: str, reason: str) -> FileError:
        return FileError(self.path, reason, self.place(key))

    def word(self, key: str, known: tuple[str, ...]) -> str:
        found = self.text(key)
        if found not in known:
            names = ", ".join(known)
            if key not in self:
                raise self.fail(key, f"{key} is missing; expected one of {names}")
            raise self.fail(key, f"{key} is {found[:40]!r}; expected one of {names}")
        return found

    def numbers(self, key: str) -> list[float]:
        rest, line = self._entries[key]
        words = rest.split()
        if not 1 <= len(words) <= _MOST_ANGLES:
            raise self.fail(key, f"{key} has {len(words)} numbers; expected 1 to {_MOST_ANGLES:,}")
        return [number_in(self.path, word, line, f"an entry of {key}") for word in words]


class _Table:
    """What the entries of a block say of its values."""

    def __init__(self, block: _Block, kind: str) -> None:
        self._block, self._path = block, block.path
        self.meaning, channels = _MODELS[block.word("COLOR_MODEL", tuple(_MODELS))]
        self.bands: Floats | None = None
        if self.meaning == "spectra":
            if "WAVELENGTH_LIST" not in block:
                raise block.fail("COLOR_MODEL", "the colour model spectrum needs WAVELENGTH_LIST")
            self.bands = check_bands(
                self._path, block.numbers("WAVELENGTH_LIST"), block.place("WAVELENGTH_LIST")
            )
            channels = len(self.bands)
        directional = kind in ("brdf", "btdf")
        system = block.word("PARAM_TYPE", tuple(_SYSTEMS)) if directional else "spherical_coordinate_system"
        self.coordinates, limits = _SYSTEMS[system]
        axes = []
        for index, most in enumerate(limits if directional else limits[:2]):
            key = _LISTS[index]
            if key not in block:
                if index != 1:
                    raise block.fail(key, f"{key} is missing")
                axes.append(np.zeros(1))
                continue
            axes.append(
                check_axis(self._path, block.numbers(key), most, f"angles of {key}", block.place(key))
            )
        while len(axes) < 4:
            axes.append(np.zeros(1))
        self.axes = (axes[0], axes[1], axes[2], axes[3])
        self.shape = (*(axis.size for axis in self.axes), channels)
        self.reductions = self._reductions()
        self.offsets = self._offsets() if directional else None

    def _reductions(self) -> set[str]:
        found = set(self._block.text("REDUCTION_TYPE").split())
        unknown = found - {"bilateral_symmetry", "reciprocity"}
        if unknown:
            name = min(unknown)[:40]
            raise self._block.fail("REDUCTION_TYPE", f"the reduction {name!r} is not known")
        if "reciprocity" in found and self.coordinates != "half_difference":
            reason = "reciprocity is a reduction of the half-difference system alone"
            raise self._block.fail("REDUCTION_TYPE", reason)
        if "bilateral_symmetry" in found and self.coordinates == "spherical" and self.axes[1].size > 1:
            reason = "bilateral symmetry of an anisotropic table in the spherical system is ambiguous"
            raise self._block.fail("REDUCTION_TYPE", reason)
        most = 360.0 / 2 ** len(found)
        if np.degrees(self.axes[3][-1]) > most + 1e-3:
            reason = f"with the reduction {' and '.join(sorted(found))} angles reach at most {most:g}°"
            raise self._block.fail("PARAM3_LIST", reason)
        return found

    def _offsets(self) -> Floats | None:
        if "PARAM4_LIST" not in self._block:
            return None
        found = np.array(self._block.numbers("PARAM4_LIST"))
        if self.coordinates != "specular" or len(found) != self.axes[0].size:
            reason = "PARAM4_LIST wants the specular system, and as many offsets as PARAM0_LIST has angles"
            raise self._block.fail("PARAM4_LIST", reason)
        if (np.abs(found) > 90.0).any():
            raise self._block.fail("PARAM4_LIST", "an offset is beyond 90°")
        return np.asarray(np.radians(found))

    def grid(self, values: _Values, facts: dict[str, object], observer_deg: int) -> AngleTable:
        """Return the table of the values."""
        # The first parameter runs fastest.
        numbers = values.numbers.reshape(*self.shape[3::-1], self.shape[4]).transpose(3, 2, 1, 0, 4)
        stride = np.array([1, *np.cumprod(self.shape[:3])])

        def place(row: int) -> str:
            indices = np.unravel_index(row, self.shape[:4])
            return values.place(int((np.array(indices) * stride).sum()))

        return grid_of(
            self._path,
            self.coordinates,
            self.axes,
            numbers,
            self.meaning,
            place,
            facts=facts,
            wavelengths_nm=self.bands,
            observer_deg=observer_deg,
            mirrored="bilateral_symmetry" in self.reductions,
            reciprocal="reciprocity" in self.reductions,
            offsets=self.offsets,
        )


class _Values:
    """The numbers (n, c) behind DATA, and where each row stands."""

    def __init__(self, numbers: Reals, start: int, lines: array[int] | None) -> None:
        self.numbers, self._start, self._lines = numbers, start, lines

    def place(self, row: int) -> str:
        if self._lines is not None:
            return f"line {self._lines[row]}"
        return f"byte {self._start + 4 * row * self.numbers.shape[1]}"


class _Reader:
    """Position in the bytes of a file whose text and binary parts alternate."""

    def __init__(self, path: PathLike, content: bytes) -> None:
        self._path, self._content = path, content
        self._at, self._line, self._blocks = 0, 0, 0

    def _next(self) -> str | None:
        """Return the next line that is neither empty nor a comment, or None at the end of the file."""
        while self._at < len(self._content):
            end = self._content.find(b"\n", self._at, self._at + LONGEST_LINE + 1)
            if end < 0:
                end = len(self._content)
                if end - self._at > LONGEST_LINE:
                    reason = f"the line is longer than {LONGEST_LINE:,} bytes"
                    raise FileError(self._path, reason, f"line {self._line + 1}")
            text = self._content[self._at : end].decode("utf-8", "replace").strip("\r\n \t\ufeff")
            self._at = end + 1
            self._line += 1
            if text and not text.startswith("#"):
                return text
        return None

    def more(self) -> bool:
        """Whether another block follows."""
        at, line = self._at, self._line
        found = self._next()
        self._at, self._line = at, line
        if found is not None and self._blocks == _MOST_BLOCKS:
            reason = f"has more than {_MOST_BLOCKS} blocks"
            raise FileError(self._path, reason, f"line {line + 1}")
        return found is not None

    def entries(self, last: str) -> _Block:
        """Return the entries to the one called ``last``: before it where a block begins, with it where data do."""
        block = _Block(self._path)
        first = self._line
        while True:
            at, line = self._at, self._line
            text = self._next()
            block.line = self._line
            if text is None:
                raise FileError(self._path, f"the file ends before {last}", f"line {self._line}")
            if self._line - first > _MOST_ENTRIES:
                raise FileError(
                    self._path, f"more than {_MOST_ENTRIES} entries before {last}", f"line {self._line}"
                )
            key, rest = (*text.split(None, 1), "")[:2]
            if key == last == "DATA_TYPE":
                self._at, self._line = at, line
                return block
            block.add(key, rest, self._line)
            if key == last:
                self._blocks += 1
                return block

    def values(self, block: _Block, shape: tuple[int, ...], *, keep: bool) -> _Values:
        """Return the numbers behind DATA, or pass over them."""
        left = len(self._content) - self._at
        channels = shape[-1]
        if block.word("DATA", ("ascii", "binary")) == "binary":
            start = self._at
            count = check_count(self._path, shape, left // 4, f"byte {start}")
            self._at += 4 * count
            numbers = np.frombuffer(self._content, "<f4", count if keep else 0, start)
            return _Values(numbers.reshape(-1, channels), start, None)
        count = check_count(self._path, shape, (left + 1) // 2, f"line {self._line + 1}")
        found, lines = array("d"), array("q")
        for row in range(count // channels):
            text = self._next()
            if text is None:
                reason = f"the file ends after {row:,} of {count // channels:,} colours"
                raise FileError(self._path, reason, f"line {self._line}")
            words = text.split()
            if len(words) != channels:
                reason = f"expected {channels} numbers, not {len(words)}"
                raise FileError(self._path, reason, f"line {self._line}")
            found.extend(number_in(self._path, word, self._line, "a value") for word in words)
            lines.append(self._line)
        return _Values(np.frombuffer(found, np.float64).reshape(-1, channels), 0, lines)


def _sniff(head: bytes, _size: int) -> bool:
    return b"DATA_TYPE" in head and b"COLOR_MODEL" in head and b"PARAM0_LIST" in head


FORMAT = MeasuredFormat(
    name="ssdd",
    title="SSDD (surface scattering distribution data)",
    endings=(".ssdd",),
    sniff=_sniff,
    read=read_ssdd,
)
