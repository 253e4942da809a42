"""ALTA: a header of ``#KEY values`` lines, then rows of inputs and outputs, as text or binary.

``#DIM nx ny`` counts the columns; ``#PARAM_IN`` names the coordinates
(:mod:`brdf_suite.files.measured.alta_coordinates`) and ``#PARAM_OUT`` what the values are (default 1/sr); ``#VS`` says
how many columns of intervals follow the outputs, which are skipped. Angles are in radians. L is the light, V the view.
The projected coordinates are (θ cos Δφ, θ sin Δφ), with Δφ = 0 on the light's own side. The cosine of
``INV_STERADIAN_COSINE_FACTOR`` is that of the output direction, the view.

Binary files (``#FORMAT binary``, ``#VERSION 0``) name ``#PRECISION ieee754-double``, ``#ENDIAN`` and ``#SAMPLE_COUNT``;
behind ``#BEGIN_STREAM`` stand the rows, with ny columns of intervals for ``#VS 1`` and 2 ny for ``#VS 2``, and
``#END_STREAM`` (layout from ``data_storage.cpp`` of ALTA).
"""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import MOST_SAMPLES, number_in, numbered_lines
from brdf_suite.files.measured.alta_coordinates import SYSTEMS, AltaSystem
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import (
    SampleRows,
    angles,
    as_samples,
    columns,
    one_azimuth,
    one_line,
    rgb_values,
    samples,
    sampling_notes,
)
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.regular_files import open_regular, read_bytes

_LARGEST = 256 << 20
# Of values stored with the cosine nothing can be recovered at a view closer to the horizon than this.
_LEAST_COSINE = 1e-3

# The rounding of a file may put a direction this far below the horizon.
_BELOW = 1e-3
_HEAD = 1 << 16
_BEGIN = b"#BEGIN_STREAM"
_OUTPUTS = {"INV_STERADIAN", "INV_STERADIAN_COSINE_FACTOR", "RGB_COLOR", "XYZ_COLOR"}


class _Header:
    """The keys of the header, complete before the first row."""

    def __init__(self, path: PathLike) -> None:
        self.path = path
        self.inputs, self.outputs = 0, 0
        self.intervals = 0
        self.param_in, self.param_out = "", "INV_STERADIAN"
        self.name = ""
        self.others: dict[str, str] = {}

    def take(self, text: str, number: int) -> None:
        """Keep a line of the header."""
        key, _, rest = text[1:].partition(" ")
        words = rest.split()
        if key == "DIM":
            self.inputs, self.outputs = (self._small(word, number) for word in (*words, "", "")[:2])
        elif key == "VS":
            self.intervals = sum(self._small(word, number) for word in words)
        elif key == "PARAM_IN" and words:
            self.param_in = words[0]
        elif key == "PARAM_OUT" and words:
            self.param_out = words[0]
        elif key == "SAMPLE":
            self.name = rest.strip().strip('"')[:500]
        elif key == "FUNC":
            reason = f"is a function that ALTA fitted ({(*words, '')[0][:60]}), not data; export its samples from ALTA"
            raise FileError(self.path, reason, f"line {number}")
        elif key and words and len(self.others) < 50:
            self.others[key] = words[0]

    def _small(self, word: str, number: int) -> int:
        value = number_in(self.path, word, number, "a number of columns")
        if value != int(value) or not 0 <= value <= 64:
            raise FileError(self.path, f"{word[:20]} is no number of columns", f"line {number}")
        return int(value)

    def check(self, number: int) -> AltaSystem:
        """Return the coordinates; raise :class:`FileError` where the header describes no columns that are known."""
        place = f"the header, before line {number}"
        if self.param_in not in SYSTEMS:
            known = ", ".join(sorted(SYSTEMS))
            found = self.param_in[:60] or "nothing"
            raise FileError(self.path, f"PARAM_IN is {found}; expected one of {known}", place)
        if self.param_out not in _OUTPUTS:
            known = ", ".join(sorted(_OUTPUTS))
            raise FileError(self.path, f"PARAM_OUT is {self.param_out[:60]}; expected one of {known}", place)
        system = SYSTEMS[self.param_in]
        if self.inputs != system.inputs:
            reason = f"{self.param_in} has {system.inputs} inputs; DIM says {self.inputs}"
            raise FileError(self.path, reason, place)
        wanted_outputs = (3,) if self.param_out.endswith("COLOR") else (1, 3)
        if self.outputs not in wanted_outputs:
            raise FileError(self.path, f"{self.outputs} outputs; {wanted_outputs} are known", place)
        return system


class _BinaryRows(SampleRows):
    """Rows of a binary file, by their first byte."""

    def place(self, row: int) -> str:
        return f"byte {self._lines[row]}"


def read_alta(path: PathLike, options: ReadOptions | None = None) -> ScatteredSamples:
    """Return the samples of an ALTA file; one output is grey, three are Rec. 709 (or XYZ where it says so).

    Raises :class:`FileError`: with the line, or the byte, of the first fault.
    """
    with open_regular(path, _LARGEST) as stream:
        binary = _BEGIN in stream.read(_HEAD)
    header, rows = _read_binary(path) if binary else _read_text(path)
    system = SYSTEMS[header.param_in]
    facts: dict[str, object] = {
        "format": "ALTA binary" if binary else "ALTA text",
        "name": header.name,
        "coordinates": header.param_in,
    }
    wi, wo, kept = _directions(rows, system, header.param_in)
    if not kept.all():
        facts["rows below the horizon left out"] = int(np.count_nonzero(~kept))
        rows, wi, wo = rows.only(kept), wi[kept], wo[kept]
    numbers = rows.table[:, header.inputs :]
    if header.param_out == "INV_STERADIAN_COSINE_FACTOR":
        kept = wo[:, 2] >= _LEAST_COSINE
        if not kept.all():
            facts["rows with the view on the horizon left out"] = int(np.count_nonzero(~kept))
            rows, wi, wo, numbers = rows.only(kept), wi[kept], wo[kept], numbers[kept]
        numbers = numbers / wo[:, 2:]
    if not kept.any():
        raise FileError(path, "holds no samples with light and view above the horizon", "the table")
    meaning = "grey" if header.outputs == 1 else "xyz" if header.param_out == "XYZ_COLOR" else "rgb"
    turning = system.anisotropic and not one_azimuth(np.arctan2(wi[:, 1], wi[:, 0]))
    return samples(
        rows,
        wi,
        wo,
        rgb=rgb_values(numbers, meaning),
        isotropic=not turning,
        observer_deg=(options or ReadOptions()).observer_deg,
        facts=facts | {"colour": {"grey": "grey", "rgb": "RGB, Rec. 709", "xyz": "XYZ"}[meaning]},
    )


def _read_text(path: PathLike) -> tuple[_Header, SampleRows]:
    header = _Header(path)
    rows: SampleRows | None = None
    number = 0
    for number, text in numbered_lines(path, _LARGEST):
        words = text.split()
        if not words:
            continue
        if words[0].startswith("#"):
            if rows is None:
                header.take(text.strip(), number)
            continue
        if rows is None:
            header.check(number)
            rows = SampleRows(path, header.inputs + header.outputs)
        wanted = rows.width + header.intervals
        if len(words) != wanted:
            raise FileError(path, f"expected {wanted} numbers, not {len(words)}", f"line {number}")
        found = [number_in(path, word, number, "a coordinate or a value") for word in words]
        rows.add(found[: rows.width], number)
    if rows is None:
        raise FileError(path, "the file ends before the first row", f"line {number}")
    return header, rows


def _read_binary(path: PathLike) -> tuple[_Header, SampleRows]:
    content = read_bytes(path, _LARGEST)
    head, _, _ = content.partition(_BEGIN)
    header = _Header(path)
    lines = head.decode("utf-8", "replace").splitlines()
    for number, text in enumerate(lines, 1):
        if text.strip().startswith("#"):
            header.take(text.strip(), number)
    last = len(lines) + 1
    header.check(last)
    place = f"the header, before line {last}"
    for key, known in (("FORMAT", "binary"), ("VERSION", "0"), ("PRECISION", "ieee754-double")):
        if header.others.get(key, known) != known:
            raise FileError(path, f"{key} is {header.others[key][:40]}; {known} is known", place)
    order = header.others.get("ENDIAN", "little")
    if order not in ("little", "big"):
        raise FileError(path, f"ENDIAN is {order[:40]}; expected little or big", place)
    count = number_in(path, header.others.get("SAMPLE_COUNT", ""), last, "SAMPLE_COUNT")
    if not (count.is_integer() and 1 <= count <= MOST_SAMPLES):
        reason = f"SAMPLE_COUNT is {count:g}; expected 1 to {MOST_SAMPLES:,}"
        raise FileError(path, reason, place)
    if header.intervals > 2:
        raise FileError(path, f"VS is {header.intervals}; expected 0, 1 or 2", place)
    start = content.find(b"\n", len(head)) + 1
    width = header.inputs + header.outputs * (1 + header.intervals)
    needed = int(count) * width
    if start == 0 or start + 8 * needed > len(content):
        reason = f"is cut off: {int(count):,} rows of {width} numbers take {8 * needed:,} bytes"
        raise FileError(path, reason, f"byte {start or len(content)}")
    tail = content[start + 8 * needed :].strip()
    if tail not in (b"", b"#END_STREAM"):
        raise FileError(path, "holds more bytes than its rows take", f"byte {start + 8 * needed}")
    table = np.frombuffer(content, "<f8" if order == "little" else ">f8", needed, start).reshape(-1, width)
    wrong = np.flatnonzero(~np.isfinite(table).all(axis=1))
    if wrong.size:
        raise FileError(
            path, "holds a number that is not finite", f"byte {start + 8 * width * int(wrong[0])}"
        )
    rows = _BinaryRows(path, header.inputs + header.outputs)
    rows.extend(table[:, : rows.width], start + 8 * width * np.arange(len(table)))
    return header, rows


def _directions(rows: SampleRows, system: AltaSystem, name: str) -> tuple[Floats, Floats, np.ndarray]:
    """Return light and view (n, 3), unit and above the horizon, and which rows (n,) have such a pair."""
    with np.errstate(invalid="ignore", over="ignore"):
        pair = system.pair(np.asarray(rows.table[:, : system.inputs]))
        lengths = [np.sqrt(np.einsum("ni,ni->n", w, w)) for w in pair]
    # A NaN fails each comparison: there the coordinates stand for no pair.
    unit = [np.abs(length - 1.0) <= 1e-3 for length in lengths]
    above = [w[:, 2] >= -_BELOW for w in pair]
    kept = unit[0] & unit[1] & above[0] & above[1]
    if not system.gridded and not kept.all():
        at = int(np.argmin(kept))
        numbers = ", ".join(f"{number:.6g}" for number in rows.table[at, : system.inputs])
        reason = f"{name} ({numbers}) gives no pair of directions above the surface"
        raise FileError(rows.path, reason, rows.place(at))
    found = []
    for w, length in zip(pair, lengths, strict=True):
        w = np.where(kept[:, None], w / np.where(kept, length, 1.0)[:, None], (0.0, 0.0, 1.0))
        w[:, 2] = np.maximum(w[:, 2], 0.0)
        found.append(w / np.sqrt(np.einsum("ni,ni->n", w, w))[:, None])
    return found[0], found[1], kept


def write_alta(value: Reflectance, path: PathLike) -> tuple[str, ...]:
    """Write RGB samples, and return notes for the user (Rec. 709, as readers of ALTA expect), grey ones in one column.

    Raises :class:`FileError`: the file cannot be written.
    """
    scattered = as_samples(value)
    theta_i, phi_i = angles(scattered.wi)
    theta_o, phi_o = angles(scattered.wo)
    grey = bool(np.all(scattered.values == scattered.values[:, :1]))
    values = scattered.values[:, :1] if grey else scattered.values @ np.linalg.inv(REC709_TO_WORKING).T
    if scattered.isotropic:
        turn = phi_o - phi_i
        inputs = np.column_stack((theta_i, theta_o * np.cos(turn), theta_o * np.sin(turn)))
        param = "ISOTROPIC_TL_TV_PROJ_DPHI"
    else:
        inputs = np.column_stack((theta_i, phi_i, theta_o, phi_o))
        param = "SPHERICAL_TL_PL_TV_PV"
    header = (
        f'#SAMPLE "{one_line(scattered.facts.get("name", ""))}"\n'
        f"#DIM {inputs.shape[1]} {values.shape[1]}\n#VS 0\n#PARAM_IN {param}\n"
        f"#PARAM_OUT {'INV_STERADIAN' if grey else 'RGB_COLOR'}\n"
    )
    write_atomically(path, (header + columns(np.column_stack((inputs, values)), "\t")).encode())
    left_out = () if scattered.spectra is None else ("The spectra were left out: this format holds colours.",)
    return (*sampling_notes(value, scattered), *left_out)


FORMAT = MeasuredFormat(
    name="alta",
    title="ALTA (text, binary)",
    endings=(".alta", ".dat"),
    sniff=lambda head, _size: b"#PARAM_IN" in head or head.startswith(b"#DIM") or b"\n#DIM" in head,
    read=read_alta,
    write=write_alta,
)
