"""ALTA text: a header of ``#KEY values`` lines, then columns of inputs and outputs.

``#DIM nx ny`` counts the columns; ``#PARAM_IN`` names the coordinates and ``#PARAM_OUT`` what the values are
(default 1/sr); ``#VS`` says how many columns of intervals follow each output, which are skipped. Angles are in
radians. L is the light, V the view. The projected coordinates are (θ cos Δφ, θ sin Δφ), with Δφ = 0 on the
light's own side. The cosine of ``INV_STERADIAN_COSINE_FACTOR`` is that of the output direction, the view.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import number_in, numbered_lines
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import (
    SampleRows,
    angles,
    as_samples,
    columns,
    directions,
    one_azimuth,
    one_line,
    rgb_values,
    samples,
    sampling_notes,
)
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

_LARGEST = 256 << 20
# Of values stored with the cosine nothing can be recovered at a view closer to the horizon than this.
_LEAST_COSINE = 1e-3

_Pair = tuple[Floats, Floats]


def _projected(rows: SampleRows, x: Floats) -> _Pair:
    zero = np.zeros(len(x))
    wo = directions(rows, np.hypot(x[:, 1], x[:, 2]), np.arctan2(x[:, 2], x[:, 1]))
    return directions(rows, x[:, 0], zero), wo


def _half_angles(rows: SampleRows, theta_h: Floats, phi_h: Floats, theta_d: Floats, phi_d: Floats) -> _Pair:
    pair = from_half_angle_coordinates(theta_h, phi_h, theta_d, phi_d)
    return _unit(rows, pair[0]), _unit(rows, pair[1])


def _unit(rows: SampleRows, w: Floats) -> Floats:
    length = np.sqrt(np.einsum("ni,ni->n", w, w))
    wrong = np.flatnonzero((np.abs(length - 1.0) > 1e-3) | (w[:, 2] < -1e-3))
    if wrong.size:
        at = int(wrong[0])
        reason = "the coordinates give no direction above the surface"
        raise FileError(rows.path, reason, rows.place(at))
    w = w / length[:, None]
    w[:, 2] = np.maximum(w[:, 2], 0.0)
    w /= np.sqrt(np.einsum("ni,ni->n", w, w))[:, None]
    return w


_INPUTS: dict[str, tuple[int, Callable[[SampleRows, Floats], _Pair]]] = {
    "ISOTROPIC_TL_TV_PROJ_DPHI": (3, _projected),
    "ISOTROPIC_TV_TL_DPHI": (
        3, lambda rows, x: (directions(rows, x[:, 1], x[:, 2]), directions(rows, x[:, 0], 0.0 * x[:, 0]))
    ),
    "ISOTROPIC_TV_TL": (
        2, lambda rows, x: (directions(rows, x[:, 1], 0.0 * x[:, 0]), directions(rows, x[:, 0], 0.0 * x[:, 0]))
    ),
    "SPHERICAL_TL_PL_TV_PV": (
        4, lambda rows, x: (directions(rows, x[:, 0], x[:, 1]), directions(rows, x[:, 2], x[:, 3]))
    ),
    "CARTESIAN": (6, lambda rows, x: (_unit(rows, x[:, 3:]), _unit(rows, x[:, :3]))),
    "RUSIN_TH_TD_PD": (3, lambda rows, x: _half_angles(rows, x[:, 0], 0.0 * x[:, 0], x[:, 1], x[:, 2])),
    "RUSIN_TH_PH_TD_PD": (4, lambda rows, x: _half_angles(rows, x[:, 0], x[:, 1], x[:, 2], x[:, 3])),
    "RUSIN_TH_TD": (
        2,
        lambda rows, x: _half_angles(
            rows, x[:, 0], 0.0 * x[:, 0], x[:, 1], np.full(len(x), 0.5 * math.pi)
        ),
    ),
}  # fmt: skip
_ANISOTROPIC = {"SPHERICAL_TL_PL_TV_PV", "CARTESIAN", "RUSIN_TH_PH_TD_PD"}
_OUTPUTS = {"INV_STERADIAN", "INV_STERADIAN_COSINE_FACTOR", "RGB_COLOR", "XYZ_COLOR"}


class _Header:
    """The keys of the header, complete before the first row."""

    def __init__(self, path: PathLike) -> None:
        self.path = path
        self.inputs, self.outputs, self.intervals = 0, 0, 0
        self.param_in, self.param_out = "", "INV_STERADIAN"
        self.name = ""

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

    def _small(self, word: str, number: int) -> int:
        value = number_in(self.path, word, number, "a number of columns")
        if value != int(value) or not 0 <= value <= 64:
            raise FileError(self.path, f"{word[:20]} is no number of columns", f"line {number}")
        return int(value)

    def check(self, number: int) -> None:
        """Raise :class:`FileError` where the header does not describe columns that are known."""
        place = f"the header, before line {number}"
        if self.param_in not in _INPUTS:
            known = ", ".join(sorted(_INPUTS))
            found = self.param_in[:60] or "nothing"
            raise FileError(self.path, f"PARAM_IN is {found}; expected one of {known}", place)
        if self.param_out not in _OUTPUTS:
            known = ", ".join(sorted(_OUTPUTS))
            raise FileError(self.path, f"PARAM_OUT is {self.param_out[:60]}; expected one of {known}", place)
        if self.inputs != _INPUTS[self.param_in][0]:
            wanted = _INPUTS[self.param_in][0]
            raise FileError(self.path, f"{self.param_in} has {wanted} inputs; DIM says {self.inputs}", place)
        wanted_outputs = (3,) if self.param_out.endswith("COLOR") else (1, 3)
        if self.outputs not in wanted_outputs:
            raise FileError(self.path, f"{self.outputs} outputs; {wanted_outputs} are known", place)


def read_alta(path: PathLike, options: ReadOptions | None = None) -> ScatteredSamples:
    """Return the samples of an ALTA file; one output is grey, three are Rec. 709 (or XYZ where it says so).

    Raises :class:`FileError`: with the line of the first fault.
    """
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
    table = rows.table
    wi, wo = _INPUTS[header.param_in][1](rows, table[:, : header.inputs])
    numbers = table[:, header.inputs :]
    facts: dict[str, object] = {
        "format": "ALTA text",
        "name": header.name,
        "coordinates": header.param_in,
    }
    if header.param_out == "INV_STERADIAN_COSINE_FACTOR":
        kept = wo[:, 2] >= _LEAST_COSINE
        if not kept.all():
            facts["rows with the view on the horizon left out"] = int(np.count_nonzero(~kept))
            rows, wi, wo, numbers = rows.only(kept), wi[kept], wo[kept], numbers[kept]
        numbers = numbers / wo[:, 2:]
    meaning = "grey" if header.outputs == 1 else "xyz" if header.param_out == "XYZ_COLOR" else "rgb"
    turning = header.param_in in _ANISOTROPIC and not one_azimuth(np.arctan2(wi[:, 1], wi[:, 0]))
    return samples(
        rows,
        wi,
        wo,
        rgb=rgb_values(numbers, meaning),
        isotropic=not turning,
        observer_deg=(options or ReadOptions()).observer_deg,
        facts=facts | {"colour": {"grey": "grey", "rgb": "RGB, Rec. 709", "xyz": "XYZ"}[meaning]},
    )


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
    title="ALTA text",
    endings=(".alta", ".dat"),
    sniff=lambda head, _size: b"#PARAM_IN" in head or head.startswith(b"#DIM") or b"\n#DIM" in head,
    read=read_alta,
    write=write_alta,
)
