"""SSDD tables: systems, colour models, reductions, text and binary, and what is refused."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff
from brdf_suite.reflectance.tabulated.angle_table import AngleTable

_turned = load_module(Path(__file__).parent / "turned_pairs.py")
PAIRS, specular_pair = _turned.PAIRS, _turned.specular_pair
SPHERICAL, SPECULAR, HALF = PAIRS
SYMMETRIC, SWAPPED = "bilateral_symmetry", "reciprocity"
REC709_TO_2020 = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])


@dataclass(frozen=True)
class Variant:
    """One way to write a file."""

    system: str = SPHERICAL
    model: str = "monochrome"
    binary: bool = False
    reductions: tuple[str, ...] = ()
    azimuths: tuple[float, ...] = ()
    ends: str = "\n"
    comments: bool = False
    header: Sequence[str] = ("VERSION 0.2",)
    more: Sequence[str] = ()
    before: Sequence[str] = ()
    after: Sequence[str] = ()
    offsets: tuple[float, ...] = ()
    axes: dict[int, tuple[float, ...]] = field(default_factory=dict)

    def nodes(self) -> list[tuple[float, ...]]:
        last = 360.0 / 2 ** len(self.reductions)
        found = {
            0: (0.0, 20.0, 45.0, 70.0),
            1: self.azimuths or (0.0,),
            2: (0.0, 10.0, 35.0, 60.0),
            3: tuple(np.linspace(0.0, last, 9)),
        }
        return [(found | self.axes)[index] for index in range(4)]

    def scales(self) -> list[float]:
        return {"monochrome": [1.0], "rgb": [1.0, 0.7, 0.4], "xyz": [0.9, 1.0, 0.8]}.get(
            self.model, [0.4, 0.5, 0.6, 0.7, 0.8]
        )

    def value(self, angles: Sequence[float]) -> float:
        light, view = self.pair(angles)
        return (_turned.brushed if self.azimuths else _turned.field)(light, view)

    def pair(self, angles: Sequence[float]) -> tuple[np.ndarray, np.ndarray]:
        if self.offsets:
            offset = self.offsets[self.nodes()[0].index(angles[0])]
            return specular_pair(*angles, offset)
        return PAIRS[self.system](*angles)

    def content(self) -> bytes:
        nodes = self.nodes()
        lines = [*self.header, "", *self.before, "DATA_TYPE brdf", f"COLOR_MODEL {self.model}"]
        if self.model == "spectrum":
            lines.append("WAVELENGTH_LIST 420 490 560 630 700")
        lines.append(f"PARAM_TYPE {self.system}")
        if self.reductions:
            lines.append("REDUCTION_TYPE " + " ".join(self.reductions))
        for index, axis in enumerate(nodes):
            if index != 1 or self.azimuths:
                lines.append(f"PARAM{index}_LIST " + " ".join(f"{angle:g}" for angle in axis))
        if self.offsets:
            lines.append("PARAM4_LIST " + " ".join(f"{angle:g}" for angle in self.offsets))
        lines += [*self.more, "DATA " + ("binary" if self.binary else "ascii")]
        data = b""
        for angles in itertools.product(*reversed(nodes)):
            colour = [scale * self.value(angles[::-1]) for scale in self.scales()]
            if self.binary:
                data += struct.pack(f"<{len(colour)}f", *colour)
            else:
                if self.comments and angles[3] == nodes[0][0]:
                    lines.append(f"# PARAM2: {angles[1]:g}")
                lines.append(" ".join(f"{number:.7g}" for number in colour))
        tail = self.ends.join(("", *self.after, ""))
        return self.ends.join(lines).encode() + self.ends.encode() + data + tail.encode()


BTDF = [
    "DATA_TYPE btdf", "COLOR_MODEL monochrome", "PARAM_TYPE spherical_coordinate_system", "PARAM0_LIST 0",
    "PARAM2_LIST 0 90", "PARAM3_LIST 0", "DATA ascii", "0.1", "0.2",
]  # fmt: skip
MIRROR = [
    "DATA_TYPE specular_reflectance", "COLOR_MODEL spectrum", "WAVELENGTH_LIST 400 500", "PARAM0_LIST 0 90",
    "DATA ascii", "0.05 0.06", "1 1",
]  # fmt: skip

VARIANTS = {
    **{
        f"{system.split('_')[0]} {model} {'binary' if binary else 'text'}": Variant(system, model, binary)
        for system, model, binary in itertools.product(
            PAIRS, ("monochrome", "rgb", "xyz", "spectrum"), (False, True)
        )
    },
    "mirrored": Variant(reductions=(SYMMETRIC,)),
    "mirrored specular": Variant(SPECULAR, "rgb", reductions=(SYMMETRIC,)),
    "reciprocal": Variant(HALF, reductions=(SWAPPED,)),
    "reciprocal and mirrored": Variant(HALF, "rgb", True, (SYMMETRIC, SWAPPED)),
    "anisotropic": Variant(azimuths=(0.0, 90.0, 180.0, 270.0, 360.0)),
    "anisotropic specular binary": Variant(SPECULAR, binary=True, azimuths=(0.0, 45.0, 90.0, 200.0)),
    "anisotropic half": Variant(HALF, azimuths=(0.0, 60.0, 120.0, 180.0, 240.0, 300.0)),
    "offsets": Variant(SPECULAR, offsets=(0.0, -2.0, -5.0, -10.0)),
    "carriage returns": Variant(ends="\r\n", comments=True),
    "carriage returns before binary": Variant(ends="\r\n", binary=True),
    "comments": Variant(comments=True, header=("# made here", "VERSION 0.2")),
    "all of the header": Variant(
        header=("VERSION 0.1", "SOFTWARE BSDFProcessor-1.3.0", "API libbsdf-1.0.0", "DATE 2020-01-16")
    ),
    "all of the meta-data": Variant(
        more=(
            "NAME metallic paint, größer",
            "SOURCE_TYPE measured",
            "DEVICE GCMS-4",
            "CREATION_DATE 2020-01-16",
            "MEASUREMENT_DATE 2019-12-26",
        )
    ),
    "transmission behind": Variant(binary=True, after=("", *BTDF)),
    "transmission before": Variant(before=(*BTDF, "")),
    "mirror behind": Variant(after=MIRROR),
    "one azimuth of the view": Variant(axes={3: (0.0,)}),
    "open turn": Variant(axes={3: tuple(np.arange(0.0, 360.0, 30.0))}),
}


def written(tmp_path: Path, content: bytes) -> Path:
    path = tmp_path / "panel.ssdd"
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("name", VARIANTS)
def test_every_variant_holds_its_values_at_its_directions(tmp_path: Path, name: str) -> None:
    variant = VARIANTS[name]
    path = written(tmp_path, variant.content())
    assert sniff(path).name == "ssdd"
    grid = read_measured(path)
    assert isinstance(grid, AngleTable)
    assert grid.isotropic == (not variant.azimuths)
    kept = []
    for angles in itertools.product(*variant.nodes()):
        light, view = variant.pair(angles)
        # Along the normal there is no azimuth, and between opposite directions no half vector.
        if min(light[2], view[2]) > 0.02 and not (angles[0] == 0.0 < angles[1]):
            kept.append((light, view, variant.value(angles)))
    assert len(kept) > 10
    wi, wo = (np.array([pair[side] for pair in kept]) for side in (0, 1))
    expected = np.array([pair[2] for pair in kept])[:, None] * variant.scales()
    found = grid.eval_spectra(wi, wo) if variant.model == "spectrum" else grid.eval(wi, wo)
    if variant.model == "rgb":
        expected = expected @ REC709_TO_2020.T
    elif variant.model == "xyz":
        found, expected = found @ (0.2627, 0.6780, 0.0593), expected[:, 1]  # Y of Rec. 2020
    elif variant.model == "monochrome":
        expected = np.repeat(expected, 3, axis=1)
    assert found == pytest.approx(expected, rel=1e-3, abs=1e-6)


def test_between_its_nodes_a_table_is_linear(tmp_path: Path) -> None:
    grid = read_measured(written(tmp_path, Variant(SPECULAR, axes={3: (0.0, 180.0)}).content()))
    light, near = specular_pair(45.0, 0.0, 10.0, 0.0)
    _, far = specular_pair(45.0, 0.0, 35.0, 0.0)
    _, middle = specular_pair(45.0, 0.0, 22.5, 0.0)
    expected = 0.5 * (grid.eval(light, near) + grid.eval(light, far))
    assert grid.eval(light, middle) == pytest.approx(expected, rel=1e-5)


def test_the_light_turns_with_its_highlight(tmp_path: Path) -> None:
    variant = replace(VARIANTS["anisotropic"], axes={3: tuple(np.linspace(0.0, 360.0, 37))})
    grid = read_measured(written(tmp_path, variant.content()))
    light, view = PAIRS[SPHERICAL](45.0, 45.0, 35.0, 225.0)  # between two azimuths of the light
    beside = [PAIRS[SPHERICAL](45.0, phi, 35.0, phi + 180.0) for phi in (0.0, 90.0)]
    expected = np.mean([grid.eval(*pair) for pair in beside], axis=0)
    assert grid.eval(light, view) == pytest.approx(expected, rel=1e-5)


def test_facts_and_what_was_left_out(tmp_path: Path) -> None:
    facts = read_measured(written(tmp_path, VARIANTS["all of the meta-data"].content())).facts
    assert facts["name"] == "metallic paint, größer"
    assert facts["device"] == "GCMS-4"
    assert "notes" not in facts
    (note,) = read_measured(written(tmp_path, VARIANTS["transmission behind"].content())).facts["notes"]
    assert "transmission (BTDF)" in note


def test_a_negative_value_becomes_0_and_is_counted(tmp_path: Path) -> None:
    content = Variant().content().splitlines()
    content[-2] = b"-0.25"
    found = read_measured(written(tmp_path, b"\n".join(content)))
    assert found.facts["negative values raised to 0"] == 1
    assert found.values.min() == 0.0


@pytest.mark.parametrize(
    ("old", "new", "reason", "place"),
    [
        ("VERSION 0.2\n", "DATE 2020\n", "VERSION", "line 1"),
        ("COLOR_MODEL monochrome", "COLOR_MODEL cmyk", "expected one of monochrome, rgb", "line 4"),
        ("PARAM_TYPE spherical", "PARAM_TYPE distorted_spherical", "PARAM_TYPE", "line 5"),
        ("PARAM2_LIST 0 10", "PARAM2_LIST 10 10", "rise", "line 7"),
        ("PARAM2_LIST 0 10 35 60", "PARAM2_LIST 0 10 35 96", "at most 90", "line 7"),
        ("PARAM2_LIST 0 10 35 60", "PARAM2_LIST 0 10 35", "expected an entry", "line 118"),
        ("PARAM3_LIST", "PARAM2_LIST", "given twice", "line 8"),
        ("DATA ascii", "DATA ascii\nnan", "finite number", "line 10"),
        ("DATA ascii", "DATA ascii\n0.1 0.2", "expected 1 numbers, not 2", "line 10"),
        ("DATA ascii", "DATA hex", "expected one of ascii, binary", "line 9"),
        ("PARAM0_LIST 0 20", "PARAM0_LIST 20 0", "rise", "line 6"),
        ("DATA_TYPE brdf", "DATA_TYPE btdf", "holds no BRDF", "the list of blocks"),
        ("PARAM_TYPE", "REDUCTION_TYPE reciprocity\nPARAM_TYPE", "half-difference", "line"),
        ("PARAM_TYPE", "REDUCTION_TYPE bilateral_symmetry\nPARAM_TYPE", "at most 180", "line"),
        ("PARAM_TYPE", "REDUCTION_TYPE magic\nPARAM_TYPE", "magic", "line"),
    ],
)
def test_damage_is_refused_with_its_place(
    tmp_path: Path, old: str, new: str, reason: str, place: str
) -> None:
    content = Variant().content().decode()
    assert old in content
    with pytest.raises(FileError, match=reason) as caught:
        read_measured(written(tmp_path, content.replace(old, new, 1).encode()))
    assert (caught.value.place or "").startswith(place)


def test_sizes_beyond_the_file_are_refused_before_memory_is_taken(tmp_path: Path) -> None:
    many = " ".join(f"{angle:.3f}" for angle in np.linspace(0.0, 90.0, 5000))
    for axis, mode in itertools.product((0, 2), ("ascii", "binary")):
        content = Variant(binary=mode == "binary").content().decode("latin-1")
        lines = content.split("\n")
        for index, line in enumerate(lines):
            if line.startswith((f"PARAM{axis}_LIST", "PARAM0_LIST")):
                lines[index] = line.split()[0] + " " + many
        with pytest.raises(FileError, match=r"cut off|more than"):
            read_measured(written(tmp_path, "\n".join(lines).encode("latin-1")))


def test_a_truncated_file_is_refused(tmp_path: Path) -> None:
    for variant in (Variant(), Variant(binary=True)):
        with pytest.raises(FileError, match=r"cut off|ends after"):
            read_measured(written(tmp_path, variant.content()[:-40]))
