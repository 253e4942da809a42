"""ALTA files: every coordinate system, as text and binary, against the definitions of the coordinates."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff

_turned = load_module(Path(__file__).parent / "turned_pairs.py")

Vector = np.ndarray
N = np.array([0.0, 0.0, 1.0])


def unit(w: Vector) -> Vector:
    return w / np.linalg.norm(w)


def angle(u: Vector, v: Vector) -> float:
    return float(np.arccos(np.clip(unit(u) @ unit(v), -1.0, 1.0)))


def azimuth(w: Vector) -> float:
    return float(np.arctan2(w[1], w[0]))


def between(v: Vector, w: Vector) -> float:
    """The azimuth between, 0 to π."""
    return float(abs((azimuth(v) - azimuth(w) + np.pi) % (2.0 * np.pi) - np.pi))


def difference(light: Vector, view: Vector) -> tuple[float, float, float, float]:
    """The half-angle coordinates of the view, by turning it back."""
    half = unit(light + view)
    theta, phi = angle(half, N), azimuth(half) if np.hypot(half[0], half[1]) > 1e-12 else 0.0
    back = _turned.turn(_turned.turn(view, N, -np.degrees(phi)), (0.0, 1.0, 0.0), -np.degrees(theta))
    return theta, phi, angle(half, view), azimuth(back)


def turned_angles(theta: float, across: float) -> tuple[float, float]:
    """(θ cos φ, θ sin |φ|)."""
    return theta * np.cos(across), theta * np.sin(across)


def about_light(light: Vector, view: Vector) -> float:
    """The angle at the light between the normal and the view."""
    to_normal, to_view = N - (N @ light) * light, view - (view @ light) * light
    return angle(to_normal, to_view)


def mirrored(w: Vector) -> Vector:
    return w * (-1.0, -1.0, 1.0)


def projected(w: Vector) -> float:
    return float(np.hypot(w[0], w[1]))


def isotropic(*values: float) -> list[float]:
    return list(values)


# Coordinates of a pair (L, V), by their definitions.
DEFINED: dict[str, Callable[[Vector, Vector], list[float]]] = {
    "COS_TH": lambda light, view: [unit(light + view)[2]],
    "COS_TK": lambda light, view: [unit(light + mirrored(view))[2]],
    "COS_TLV": lambda light, view: [light @ view],
    "COS_TLR": lambda light, view: [mirrored(light) @ view],
    "COS_TH_TD": lambda light, view: [unit(light + view)[2], unit(light + view) @ view],
    "RUSIN_TH_TD": lambda light, view: list(difference(light, view)[::2]),
    "ISOTROPIC_TV_PROJ_DPHI": lambda _light, view: [angle(view, N) * c for c in unit(view[:2])],
    "ISOTROPIC_TV_TL": lambda light, view: [angle(view, N), angle(light, N)],
    "STARK_2D": lambda light, view: [projected(light + view) / 2, np.linalg.norm(light - view) / 2],
    "NEUMANN_2D": lambda light, view: [projected(light + view) / 2, projected(light - view) / 2],
    "RUSIN_TH_TD_PD": lambda light, view: [difference(light, view)[index] for index in (0, 2, 3)],
    "ISOTROPIC_TV_TL_DPHI": lambda light, view: [angle(view, N), angle(light, N), between(light, view)],
    "ISOTROPIC_TL_TV_PROJ_DPHI": lambda light, view: [
        angle(light, N), *turned_angles(angle(view, N), between(light, view))
    ],
    "RUSIN_VH": lambda light, view: unit(light + view).tolist(),
    "SCHLICK_VH": lambda light, view: unit(light + mirrored(view)).tolist(),
    "SCHLICK_TL_TK_PROJ_DPHI": lambda light, view: [
        angle(light, N),
        *turned_angles(angle(view + mirrored(light), N), between(view + mirrored(light), light)),
    ],
    "RETRO_TL_TVL_PROJ_DPHI": lambda light, view: [
        angle(light, N), *turned_angles(angle(light, view), about_light(light, view))
    ],
    "STARK_3D": lambda light, view: [
        projected(light + view) / 2, np.linalg.norm(light - view) / 2, between(light - view, light + view)
    ],
    "NEUMANN_3D": lambda light, view: [
        projected(light + view) / 2, projected(light - view) / 2, between(light - view, light + view)
    ],
    "RUSIN_TH_PH_TD_PD": lambda light, view: list(difference(light, view)),
    "SPHERICAL_TL_PL_TV_PV": lambda light, view: [
        angle(light, N), azimuth(light), angle(view, N), azimuth(view)
    ],
    "STEREOGRAPHIC": lambda light, view: [*(view[:2] / (1 + view[2])), *(light[:2] / (1 + light[2]))],
    "CARTESIAN": lambda light, view: [*view, *light],
}  # fmt: skip

PAIRS = [
    (_turned.polar(a, 0.0), _turned.polar(b, c))
    for a, b, c in itertools.product((15.0, 40.0, 65.0), (10.0, 35.0, 60.0), (20.0, 95.0, 160.0))
]
# Where one number or two stand for a pair, these are the pairs that they stand for.
ONLY: dict[str, list[tuple[Vector, Vector]]] = {
    "COS_TH": [(_turned.polar(a, 0.0), _turned.polar(a, 0.0)) for a in (5.0, 30.0, 70.0)],
    "COS_TK": [(_turned.polar(a, 0.0), _turned.polar(a, 180.0)) for a in (5.0, 30.0, 70.0)],
    "COS_TLV": [(N, _turned.polar(a, 0.0)) for a in (5.0, 30.0, 70.0)],
    "COS_TLR": [(N, _turned.polar(a, 180.0)) for a in (5.0, 30.0, 70.0)],
    "ISOTROPIC_TV_PROJ_DPHI": [(N, _turned.polar(a, b)) for a in (5.0, 70.0) for b in (20.0, 200.0)],
    "RUSIN_VH": [(_turned.polar(a, b),) * 2 for a in (5.0, 70.0) for b in (20.0, 200.0)],
    "SCHLICK_VH": [(_turned.polar(a, b), _turned.polar(a, b + 180.0)) for a in (5.0, 70.0) for b in (20.0, 200.0)],
    "ISOTROPIC_TV_TL": [(_turned.polar(a, 0.0), _turned.polar(b, 0.0)) for a in (5.0, 70.0) for b in (20.0, 60.0)],
}  # fmt: skip


@dataclass(frozen=True)
class Variant:
    """One way to write a file."""

    system: str
    binary: bool = False
    output: str = "INV_STERADIAN"
    outputs: int = 1
    intervals: int = 0
    endian: str = "<"
    begin: tuple[str, ...] = ()
    end: bytes = b"\n#END_STREAM\n"
    says_endian: bool = True

    def rows(self) -> list[tuple[list[float], list[float]]]:
        """Inputs and outputs."""
        return [
            (
                [float(x) for x in DEFINED[self.system](light, view)],
                [(0.5 + 0.1 * k) for k in range(self.outputs)],
            )
            for light, view in ONLY.get(self.system, PAIRS)
        ]

    def content(self) -> bytes:
        rows = self.rows()
        lines = [
            *self.begin, f"#DIM {len(rows[0][0])} {self.outputs}", f"#PARAM_IN  {self.system}",
            f"#PARAM_OUT {self.output}",
        ]  # fmt: skip
        if not self.binary:
            lines.append(f"#VS {self.intervals}")
            extra = [0.25] * self.intervals
            lines += ["\t".join(f"{x:.16g}" for x in (*inputs, *found, *extra)) for inputs, found in rows]
            return ("\n".join(lines) + "\n").encode()
        lines += ["#FORMAT binary", "#VERSION 0", "#PRECISION ieee754-double", f"#SAMPLE_COUNT {len(rows)}"]
        lines.append(f"#VS {self.intervals}")
        if self.says_endian:
            lines.append(f"#ENDIAN {'little' if self.endian == '<' else 'big'}")
        data = b""
        for inputs, found in rows:
            numbers = [*inputs, *found, *[0.25] * (self.intervals * self.outputs)]
            data += struct.pack(f"{self.endian}{len(numbers)}d", *numbers)
        return "\n".join((*lines, "#BEGIN_STREAM", "")).encode() + data + self.end


HEADER = ("# made here", "#ALTA BEGIN HEADER", '#SAMPLE "a tape"', "#ORIGIN nowhere")
VARIANTS = {
    **{
        f"{name} {'binary' if binary else 'text'}": Variant(name, binary)
        for name in DEFINED
        for binary in (False, True)
    },
    **{f"intervals {kind} of {n}": Variant("RUSIN_TH_TD_PD", True, outputs=n, intervals=kind, output=output)
       for kind in (1, 2) for n, output in ((1, "INV_STERADIAN"), (3, "RGB_COLOR"))},
    "big-endian": Variant("STARK_3D", True, endian=">"),
    "big-endian colours": Variant("CARTESIAN", True, "RGB_COLOR", 3, endian=">"),
    "without endian": Variant("NEUMANN_3D", True, says_endian=False),
    "without an end": Variant("RUSIN_TH_TD", True, end=b""),
    "a line feed for an end": Variant("RUSIN_TH_TD", True, end=b"\n"),
    "a header": Variant("SPHERICAL_TL_PL_TV_PV", True, begin=HEADER),
    "a header of text": Variant("RETRO_TL_TVL_PROJ_DPHI", begin=HEADER),
    "colours": Variant("RUSIN_TH_TD_PD", True, "RGB_COLOR", 3),
    "XYZ": Variant("RUSIN_TH_TD_PD", True, "XYZ_COLOR", 3),
    "three of one unit": Variant("RUSIN_TH_TD_PD", True, outputs=3),
    "with the cosine": Variant("RUSIN_TH_TD_PD", True, "INV_STERADIAN_COSINE_FACTOR"),
    "with the cosine, retro": Variant("RETRO_TL_TVL_PROJ_DPHI", False, "INV_STERADIAN_COSINE_FACTOR"),
}  # fmt: skip


def written(tmp_path: Path, content: bytes) -> Path:
    path = tmp_path / "a.alta"
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("name", VARIANTS)
def test_every_variant_gives_the_pairs_of_its_coordinates(tmp_path: Path, name: str) -> None:
    variant = VARIANTS[name]
    path = written(tmp_path, variant.content())
    assert sniff(path).name == "alta"
    value = read_measured(path)
    rows = variant.rows()
    assert len(value.wi) == len(rows)
    assert value.facts["format"] == ("ALTA binary" if variant.binary else "ALTA text")
    for light, view, (inputs, _) in zip(value.wi, value.wo, rows, strict=True):
        found = np.array(DEFINED[variant.system](light, view))
        wanted = np.array(inputs)
        # In isotropic systems a pair and its mirror image are the same.
        assert np.abs(found) == pytest.approx(np.abs(wanted), abs=1e-7)
    stored = np.array([found for _, found in rows])
    if variant.output == "INV_STERADIAN_COSINE_FACTOR":
        stored = stored / value.wo[:, 2:]
    if variant.outputs == 1:
        assert value.values == pytest.approx(np.repeat(stored, 3, axis=1))
    elif variant.output == "XYZ_COLOR":
        assert value.values @ (0.2627, 0.6780, 0.0593) == pytest.approx(stored[:, 1], rel=1e-4)
    else:
        matrix = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])
        assert value.values == pytest.approx(stored @ matrix.T, rel=1e-3)


def test_rows_of_a_regular_table_below_the_horizon_are_left_out(tmp_path: Path) -> None:
    text = "#DIM 3 1\n#PARAM_IN RUSIN_TH_TD_PD\n0.1 0.2 0.3 1\n1.4 1.4 0.0 0\n1.2 0.1 0.3 2\n"
    value = read_measured(written(tmp_path, text.encode()))
    assert value.values[:, 0].tolist() == [1.0, 2.0]
    assert value.facts["rows below the horizon left out"] == 1


def test_a_fitted_function_is_called_what_it_is(tmp_path: Path) -> None:
    text = "#ALTA FUNC HEADER\n#DIM 3 3\n#PARAM_IN RUSIN_TH_TD_PD\n#FUNC nonlinear_function_diffuse\nkd 0.5\n"
    with pytest.raises(FileError, match="a function that ALTA fitted") as caught:
        read_measured(written(tmp_path, text.encode()))
    assert caught.value.place == "line 4"


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        (b"#VERSION 0", b"#VERSION 1", "VERSION is 1"),
        (b"ieee754-double", b"ieee754-float", "PRECISION is ieee754-float"),
        (b"#ENDIAN little", b"#ENDIAN middle", "ENDIAN is middle"),
        (b"#SAMPLE_COUNT 27", b"#SAMPLE_COUNT 28", "cut off|more bytes"),
        (b"#SAMPLE_COUNT 27", b"#SAMPLE_COUNT 26", "more bytes"),
        (b"#SAMPLE_COUNT 27", b"#SAMPLE_COUNT 99999999999", "SAMPLE_COUNT"),
        (b"#SAMPLE_COUNT 27", b"#SAMPLE_COUNT -1", "SAMPLE_COUNT"),
        (b"#SAMPLE_COUNT 27\n", b"", "SAMPLE_COUNT"),
        (b"#VS 0", b"#VS 2", "cut off"),
        (b"#VS 0", b"#VS 7", "VS is 7"),
        (b"RUSIN_TH_TD_PD", b"RUSIN_TH_TD_XX", "PARAM_IN is RUSIN_TH_TD_XX"),
        (b"#PARAM_OUT INV_STERADIAN", b"#PARAM_OUT ENERGY", "PARAM_OUT is ENERGY"),
        (b"#DIM 3 1", b"#DIM 3 2", "outputs"),
    ],
)
def test_damaged_binary_files_are_refused_with_the_place(
    tmp_path: Path, old: bytes, new: bytes, reason: str
) -> None:
    content = Variant("RUSIN_TH_TD_PD", True).content()
    assert old in content
    with pytest.raises(FileError, match=reason) as caught:
        read_measured(written(tmp_path, content.replace(old, new, 1)))
    assert caught.value.place


def test_a_number_that_is_none_is_named_by_its_byte(tmp_path: Path) -> None:
    content = Variant("CARTESIAN", True, end=b"").content()[:-8] + struct.pack("<d", np.nan)
    with pytest.raises(FileError, match="not finite") as caught:
        read_measured(written(tmp_path, content))
    assert caught.value.place == f"byte {len(content) - 7 * 8}"
