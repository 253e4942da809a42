"""BSDF data of Zemax OpticStudio and of instruments that write it: text, angles about the mirror direction.

After ``Source``, ``Symmetry``, ``SpectralContent`` (Monochrome or XYZ) and ``ScatterType`` stand ``SampleRotation``,
``AngleOfIncidence``, ``ScatterAzimuth`` and ``ScatterRadial``, each with a count and that many angles in degrees. Then
comes a block for the light (``Monochrome``, or ``TristimulusX``, ``TristimulusY`` and ``TristimulusZ``), between
``DataBegin`` and ``DataEnd``: for each rotation and incidence a line ``TIS`` and a row of values in 1/sr for each
azimuth. The radial angle is that from the mirror direction, the azimuth turns about it; 0 points to the normal.
``PlaneSymmetrical`` files have azimuths to 180° alone. Layout from the maker's interchange specification, as public
converters follow it (Ansys' own for the direction of azimuth 0). What lies below the surface is passed over.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import number_in, numbered_lines
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import SampleRows, rgb_values, samples
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

_LARGEST = 256 << 20
_WORDS = ("source", "symmetry", "spectralcontent", "scattertype")
_AXES = ("samplerotation", "angleofincidence", "scatterazimuth", "scatterradial")
_BLOCKS = {"monochrome": ("monochrome",), "xyz": ("tristimulusx", "tristimulusy", "tristimulusz")}
_MOST_ANGLES = 10_000
_MOST_DEG = {
    "samplerotation": 360.0,
    "angleofincidence": 90.0,
    "scatterazimuth": 360.0,
    "scatterradial": 180.0,
}


def read_zemax(path: PathLike, options: ReadOptions | None = None) -> ScatteredSamples:
    """Return the samples of a Zemax BSDF file; raise :class:`FileError` with the line of the first fault."""
    del options  # nothing there depends on an observer
    return _Reader(path).read()


class _Reader:
    def __init__(self, path: PathLike) -> None:
        self._path = path
        self._lines = self._content()
        self._line = 0
        self._said: dict[str, str] = {}
        self._axes: dict[str, list[float]] = {}

    def _content(self) -> Iterator[tuple[int, list[str]]]:
        for number, text in numbered_lines(self._path, _LARGEST):
            words = text.split("#", 1)[0].split()
            if words:
                yield number, words

    def _next(self, wanted: str) -> list[str]:
        found = next(self._lines, None)
        if found is None:
            raise FileError(self._path, f"the file ends before {wanted}", f"line {self._line}")
        self._line, words = found
        return words

    def _fail(self, reason: str) -> FileError:
        return FileError(self._path, reason, f"line {self._line}")

    def read(self) -> ScatteredSamples:
        """Return the samples."""
        content = self._head()
        grids: list[Floats] = []
        for block in _BLOCKS[content]:
            if grids:  # the first one ends the head
                words = self._next(f"the block {block}")
                if words[0].lower() != block:
                    raise self._fail(f"expected the block {block}, not {words[0][:40]!r}")
            grids.append(self._block())
        return self._samples(np.stack(grids, axis=-1), "grey" if content == "monochrome" else "xyz")

    def _head(self) -> str:
        """Read to the first block, and return the spectral content."""
        while True:
            words = self._next("the data")
            key = words[0].lower()
            if key in _WORDS and len(words) > 1:
                self._said[key] = words[1].lower()
            elif key in _AXES:
                self._axes[key] = self._axis(key, words)
            elif key in ("monochrome", "tristimulusx"):
                self._said["block"] = key
                break
            else:
                raise self._fail(f"expected a word of the head, not {words[0][:40]!r}")
        missing = [axis for axis in _AXES if axis not in self._axes]
        if missing:
            raise self._fail(f"the head has no {', '.join(missing)}")
        if self._said.get("scattertype", "brdf") != "brdf":
            raise self._fail("holds transmission (BTDF), not reflection")
        content = self._said.get("spectralcontent", "monochrome")
        if content not in _BLOCKS:
            raise self._fail(f"the spectral content {content[:40]!r} is not known; Monochrome and XYZ are")
        return content

    def _axis(self, key: str, words: list[str]) -> list[float]:
        count = int(
            number_in(self._path, words[1] if len(words) > 1 else "", self._line, f"the count of {words[0]}")
        )
        if not 1 <= count <= _MOST_ANGLES:
            raise self._fail(f"expected 1 to {_MOST_ANGLES:,} angles, not {count}")
        found: list[float] = []
        while len(found) < count:
            row = self._next(f"the {count} angles of {words[0]}")
            found += [
                number_in(self._path, word, self._line, "an angle") for word in row[: count - len(found)]
            ]
            if len(row) > count:
                raise self._fail(f"expected {count} angles, not {len(row)}")
        if not all(-_MOST_DEG[key] <= angle <= _MOST_DEG[key] for angle in found):
            raise self._fail(f"an angle of {words[0]} is beyond {_MOST_DEG[key]:g}°")
        return found

    def _block(self) -> Floats:
        """Return the values (rotations, incidences, azimuths, radial angles) of a block."""
        rotations, incidences, azimuths, radial = (self._axes[axis] for axis in _AXES)
        if self._next("DataBegin")[0].lower() != "databegin":
            raise self._fail("expected DataBegin")
        rows = SampleRows(self._path, len(radial))
        for _ in range(len(rotations) * len(incidences)):
            words = self._next("TIS")
            if words[0].lower() != "tis":
                raise self._fail(f"expected TIS, not {words[0][:40]!r}")
            for _ in azimuths:
                row = self._next("a row of values")
                if len(row) != len(radial):
                    raise self._fail(f"expected {len(radial)} values, not {len(row)}")
                rows.add([number_in(self._path, word, self._line, "a value") for word in row], self._line)
        if self._next("DataEnd")[0].lower() != "dataend":
            raise self._fail("expected DataEnd")
        shape = (len(rotations), len(incidences), len(azimuths), len(radial))
        return np.array(rows.table).reshape(shape)

    def _samples(self, values: Floats, meaning: str) -> ScatteredSamples:
        rotation, incidence, azimuth, radial = (
            np.radians(part).ravel()
            for part in np.meshgrid(*(self._axes[axis] for axis in _AXES), indexing="ij")
        )
        wi = np.stack([np.sin(incidence), np.zeros_like(incidence), np.cos(incidence)], axis=-1)
        # About the mirror direction: x towards the normal in the plane of incidence, z along it.
        x, y, z = np.sin(radial) * np.cos(azimuth), np.sin(radial) * np.sin(azimuth), np.cos(radial)
        wo = np.stack(
            [x * np.cos(incidence) - z * np.sin(incidence), y, x * np.sin(incidence) + z * np.cos(incidence)],
            axis=-1,
        )
        turned = len(self._axes["samplerotation"]) > 1
        if turned:
            wi, wo = _turn(wi, -rotation), _turn(wo, -rotation)
        seen = (wo[:, 2] > 1e-9) & (wi[:, 2] > 1e-9)
        numbers = values.reshape(-1, values.shape[-1])[seen]
        rows = SampleRows(self._path, numbers.shape[1])
        for row in numbers.tolist():
            rows.add(row, self._line)
        facts: dict[str, object] = {
            "format": "Zemax BSDF",
            "colour": {"grey": "grey", "xyz": "XYZ"}[meaning],
            "source": self._said.get("source", ""),
            "symmetry": self._said.get("symmetry", ""),
        }
        return samples(
            rows,
            wi[seen],
            wo[seen],
            rgb=rgb_values(numbers, meaning),
            isotropic=not turned,
            observer_deg=10,
            facts=facts,
        )


def _turn(w: Floats, angle: Floats) -> Floats:
    """Return directions turned about the normal."""
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * w[:, 0] - s * w[:, 1], s * w[:, 0] + c * w[:, 1], w[:, 2]], axis=-1)


def _sniff(head: bytes, _size: int) -> bool:
    words = head[:20_000].lower()
    return b"\0" not in words and all(axis.encode() in words for axis in _AXES)


FORMAT = MeasuredFormat(
    name="zemax",
    title="Zemax BSDF text",
    endings=(".bsdf", ".txt"),
    sniff=_sniff,
    read=read_zemax,
)
