"""BSDF data of LightTools: text, angles about the normal, one block of values per incidence.

After ``Symmetry`` and ``SpectralContent`` (Monochrome or XYZ) stand ``ScatterAzimuth`` and ``ScatterRadial``, each
with a count and that many angles in degrees, then ``DataBegin``. A block names its ``AOI``, ``POI``, ``Side``,
``Wavelength``, ``ScatterType`` and, of colours, its ``TristimulusValue`` (TrisX, TrisY, TrisZ); ``TIS`` and its value
end the head, and a value in 1/sr follows for each azimuth and radial angle, the radial one fastest. ``DataEnd`` ends
the file. ``#`` begins a comment.

The maker's description is not public: the layout, and that the light of an isotropic file comes from azimuth 90°, are
those of a public reader (libbsdf), and were not checked on files of LightTools. Read is the reflection of the front
side; blocks of the back side and of transmission are counted. Several ``POI`` are refused, since what they turn is
not known.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import number_in, numbered_lines
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import check_bands
from brdf_suite.files.measured.grid_values import Meaning, check_axis, grid_of
from brdf_suite.reflectance.tabulated.angle_table import AngleTable

_LARGEST = 256 << 20
_MOST_ANGLES = 10_000
_MOST_BLOCKS = 100_000
_LIGHT_AZIMUTH_DEG = 90.0
_CONTENT = ("monochrome", "xyz")
_TRIS = ("trisx", "trisy", "trisz")
_SAME_DEG = 1e-4


def read_lighttools(path: PathLike, options: ReadOptions | None = None) -> AngleTable:
    """Return the reflection of a file's front side; raise :class:`FileError` with the line of the first fault."""
    return _Reader(path, (options or ReadOptions()).observer_deg).read()


@dataclass
class _Block:
    """A block of values and its head."""

    line: int
    aoi: float = 0.0
    poi: float = 0.0
    side: str = "front"
    wavelength: float = 0.0
    kind: str = "brdf"
    tris: str = ""
    values: Floats | None = None


class _Reader:
    def __init__(self, path: PathLike, observer_deg: int) -> None:
        self._path, self._observer_deg = path, observer_deg
        self._words = self._content()
        self._line = 0

    def _content(self) -> Iterator[tuple[int, str]]:
        for number, text in numbered_lines(self._path, _LARGEST):
            for word in text.split("#", 1)[0].split():
                yield number, word

    def _next(self, wanted: str) -> str:
        found = next(self._words, None)
        if found is None:
            raise FileError(self._path, f"the file ends before {wanted}", f"line {self._line}")
        self._line, word = found
        return word

    def _fail(self, reason: str, line: int | None = None) -> FileError:
        return FileError(self._path, reason, f"line {line or self._line}")

    def _number(self, what: str) -> float:
        return number_in(self._path, self._next(what), self._line, what)

    def _choice(self, key: str, known: tuple[str, ...]) -> str:
        word = self._next(f"the value of {key}")
        if word.lower() not in known:
            raise self._fail(f"{key} is {word[:40]!r}; expected one of {', '.join(known)}")
        return word.lower()

    def read(self) -> AngleTable:
        """Return the table."""
        content = self._head()
        blocks, others = self._blocks()
        if not blocks:
            raise self._fail("holds no reflection (BRDF) of the front side")
        for block in blocks:
            if abs(block.poi - blocks[0].poi) > _SAME_DEG:
                reason = "several planes of incidence (POI); only isotropic files are read"
                raise self._fail(reason, block.line)
        facts: dict[str, object] = {"format": "LightTools BSDF"}
        notes = (f"Left out: {others} blocks of transmission or of the back side.",) if others else ()
        meaning: Meaning
        bands = None
        if content == "xyz":
            meaning, keys, channels = "xyz", [block.tris for block in blocks], list(_TRIS)
        else:
            lengths = sorted({block.wavelength for block in blocks})
            meaning = "spectra" if len(lengths) > 1 else "grey"
            if meaning == "spectra":
                bands = check_bands(self._path, lengths, f"line {blocks[0].line}")
            keys, channels = [repr(block.wavelength) for block in blocks], list(map(repr, lengths))
        incidences = sorted({block.aoi for block in blocks})
        axis = check_axis(self._path, incidences, 90.0, "angles of incidence", f"line {blocks[0].line}")
        shape = (len(incidences), self._azimuth.size, self._radial.size, len(channels))
        if len(blocks) != len(incidences) * len(channels):
            reason = (
                f"{len(blocks)} blocks; {len(incidences)} incidences of {len(channels)} channels are expected"
            )
            raise self._fail(reason, blocks[-1].line)
        numbers = np.empty(shape)
        lines = np.zeros(shape[0], np.int64)
        filled = np.zeros((shape[0], shape[3]), bool)
        place = {incidence: at for at, incidence in enumerate(incidences)}
        for block, key in zip(blocks, keys, strict=True):
            if key not in channels:
                raise self._fail("a block of the content XYZ has no TristimulusValue", block.line)
            at, channel = place[block.aoi], channels.index(key)
            if filled[at, channel] or block.values is None:
                raise self._fail("a block is given twice", block.line)
            numbers[at, ..., channel] = block.values
            lines[at], filled[at, channel] = block.line, True
        per_incidence = shape[1] * shape[2]
        turn = self._azimuth - np.radians(_LIGHT_AZIMUTH_DEG)
        return grid_of(
            self._path,
            "spherical",
            (axis, np.zeros(1), self._radial, turn),
            np.ascontiguousarray(numbers.transpose(0, 2, 1, 3))[:, None],
            meaning,
            lambda row: f"line {lines[row // per_incidence]}",
            facts=facts,
            notes=notes,
            wavelengths_nm=bands,
            observer_deg=self._observer_deg,
        )

    def _head(self) -> str:
        """Read to ``DataBegin``, and return the spectral content."""
        content = "monochrome"
        axes: dict[str, list[float]] = {}
        while (key := self._next("DataBegin").lower()) != "databegin":
            if key == "symmetry":
                self._choice("Symmetry", ("asymmetric", "asymmetrical"))
            elif key == "spectralcontent":
                content = self._choice("SpectralContent", _CONTENT)
            elif key in ("scatterazimuth", "scatterradial"):
                axes[key] = self._angles(key)
            else:
                raise self._fail(f"expected a word of the head, not {key[:40]!r}")
        for key in ("scatterazimuth", "scatterradial"):
            if key not in axes:
                raise self._fail(f"the head has no {key}")
        place = f"line {self._line}"
        self._azimuth = check_axis(self._path, axes["scatterazimuth"], 360.0, "azimuths", place)
        self._radial = check_axis(self._path, axes["scatterradial"], 180.0, "radial angles", place)
        return content

    def _angles(self, key: str) -> list[float]:
        count = self._number(f"the count of {key}")
        if not (count.is_integer() and 1 <= count <= _MOST_ANGLES):
            raise self._fail(f"expected 1 to {_MOST_ANGLES:,} angles, not {count:g}")
        return [self._number(f"an angle of {key}") for _ in range(int(count))]

    def _blocks(self) -> tuple[list[_Block], int]:
        """Return the blocks of the front side's reflection, and how many others there are."""
        found: list[_Block] = []
        others = 0
        block: _Block | None = None
        while (key := self._next("DataEnd").lower()) != "dataend":
            block = block or _Block(self._line)
            if key == "aoi":
                block.aoi = self._number("AOI")
            elif key == "poi":
                block.poi = self._number("POI")
            elif key == "side":
                block.side = self._choice("Side", ("front", "back"))
            elif key == "wavelength":
                block.wavelength = self._number("Wavelength")
            elif key == "scattertype":
                block.kind = self._choice("ScatterType", ("brdf", "btdf"))
            elif key == "tristimulusvalue":
                block.tris = self._choice("TristimulusValue", _TRIS)
            elif key == "tis":
                self._number("TIS")
                block.values = self._values()
                if (block.side, block.kind) == ("front", "brdf"):
                    found.append(block)
                else:
                    others += 1
                block = None
            else:
                raise self._fail(f"expected a word of a block, not {key[:40]!r}")
            if len(found) + others > _MOST_BLOCKS:
                raise self._fail(f"more than {_MOST_BLOCKS:,} blocks")
        if block is not None:
            raise self._fail("the last block has no values", block.line)
        return found, others

    def _values(self) -> Floats:
        shape = (self._azimuth.size, self._radial.size)
        numbers = [self._number("a value") for _ in range(shape[0] * shape[1])]
        return np.array(numbers).reshape(shape)


def _sniff(head: bytes, _size: int) -> bool:
    words = head[:20_000].lower()
    known = all(word in words for word in (b"scatterazimuth", b"scatterradial", b"databegin"))
    return known and b"angleofincidence" not in words and b"\0" not in words


FORMAT = MeasuredFormat(
    name="lighttools",
    title="LightTools BSDF text",
    endings=(".bsdf", ".txt"),
    sniff=_sniff,
    read=read_lighttools,
)
