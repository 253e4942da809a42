"""MBSDF of NVIDIA's MDL: tables written here byte by byte, written by the suite, and what is refused."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff, write_measured
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.angle_table import AngleTable

_turned = load_module(Path(__file__).parent / "turned_pairs.py")
REC709_TO_2020 = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])
RGB = (1.0, 0.6, 0.3)
MAGIC = b"NVIDIA ARC MBSDF V1\n"
REFLECTION = b"MBSDF_DATA_REFLECTION=\n"
TRANSMISSION = b"MBSDF_DATA_TRANSMISSION=\n" + struct.pack("<3I", 0, 1, 1) + struct.pack("<f", 0.5)


@dataclass(frozen=True)
class Variant:
    """One way to write a file."""

    theta: int = 6
    phi: int = 8
    colour: bool = False
    meta: bytes = b""
    key: bytes = REFLECTION
    tail: bytes = b""
    skew: float = 0.0

    def content(self) -> bytes:
        data = []
        for a in range(self.theta):
            for b in range(self.theta):
                for c in range(self.phi):
                    value = _turned.field(*self.pair(a, b, c)) * (1.0 + self.skew * (a - b))
                    data += [value * share for share in RGB] if self.colour else [value]
        head = struct.pack("<3I", int(self.colour), self.theta, self.phi)
        return MAGIC + self.meta + self.key + head + struct.pack(f"<{len(data)}f", *data) + self.tail

    def pair(self, a: int, b: int, c: int) -> tuple[np.ndarray, np.ndarray]:
        polar = 90.0 / self.theta
        return _turned.spherical_pair(a * polar, 0.0, b * polar, 180.0 * c / self.phi)


VARIANTS = {
    "grey": Variant(),
    "colours": Variant(colour=True),
    "short key": Variant(key=b"MBSDF_DATA=\n"),
    "short key, colours": Variant(colour=True, key=b"MBSDF_DATA=\n"),
    "line feed behind": Variant(tail=b"\n"),
    "carriage return behind": Variant(tail=b"\r\n"),
    "transmission behind": Variant(tail=TRANSMISSION),
    "transmission behind colours": Variant(colour=True, tail=TRANSMISSION),
    "transmission after a line feed": Variant(tail=b"\n" + TRANSMISSION),
    "a name": Variant(meta=b'name="paper"\n'),
    "several entries": Variant(meta=b'name="p"\ndescription="white"\ndate="2015-04-28"\nauthor="a"\n'),
    "escaped quotes": Variant(meta=b'name="a \\"b\\" \\\\ c"\n'),
    "unquoted": Variant(meta=b"name=paper\n"),
    "empty entry": Variant(meta=b"name=\nnote\n"),
    "equal signs": Variant(meta=b'formula="a=b=c"\n'),
    "many entries": Variant(meta=b"".join(b'key%d="x"\n' % index for index in range(400))),
    "carriage returns": Variant(meta=b'name="p"\r\n', key=b"MBSDF_DATA_REFLECTION=\r\n"),
    "one polar angle": Variant(theta=1),
    "one azimuth": Variant(phi=1),
    "many azimuths": Variant(theta=4, phi=90, colour=True),
    "many polar angles": Variant(theta=15, phi=4),
    "two nodes": Variant(theta=2, phi=2, colour=True),
    "uneven orders are averaged": Variant(skew=0.05),
}


def written(tmp_path: Path, content: bytes) -> Path:
    path = tmp_path / "panel.mbsdf"
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("name", VARIANTS)
def test_every_variant_holds_its_values_at_its_nodes(tmp_path: Path, name: str) -> None:
    variant = VARIANTS[name]
    path = written(tmp_path, variant.content())
    assert sniff(path).name == "mbsdf"
    grid = read_measured(path)
    assert isinstance(grid, AngleTable)
    nodes = [
        (a, b, c)
        for a in range(variant.theta)
        for b in range(variant.theta)
        for c in range(variant.phi)
        if a or b or not c
    ]
    wi, wo = (np.array([variant.pair(*node)[side] for node in nodes]) for side in (0, 1))
    expected = np.array([_turned.field(*variant.pair(*node)) for node in nodes])[:, None]
    if variant.theta == 1 or variant.phi == 1:
        expected, wi, wo = expected[:1], wi[:1], wo[:1]
    # Along the normal the azimuth has no meaning, and these values depend on none.
    seen = grid.eval(wi, wo)
    wanted = expected * RGB @ REC709_TO_2020.T if variant.colour else np.repeat(expected, 3, axis=1)
    assert seen == pytest.approx(wanted, rel=1e-3)
    assert any("transmission" in note for note in grid.facts.get("notes", ())) == ("transmission" in name)


def test_the_other_half_of_the_turn_mirrors_the_first(tmp_path: Path) -> None:
    grid = read_measured(written(tmp_path, Variant().content()))
    light, view = _turned.spherical_pair(35.0, 20.0, 50.0, 137.0)
    _, mirrored = _turned.spherical_pair(35.0, 20.0, 50.0, 20.0 - 117.0)
    assert grid.eval(light, view) == pytest.approx(grid.eval(light, mirrored), rel=1e-5)


def test_entries_become_facts(tmp_path: Path) -> None:
    assert (
        read_measured(written(tmp_path, VARIANTS["escaped quotes"].content())).facts["name"] == 'a "b" \\ c'
    )


@pytest.mark.parametrize("name", ["grey", "colours", "many azimuths"])
def test_read_and_written_again_a_table_is_the_same(tmp_path: Path, name: str) -> None:
    content = VARIANTS[name].content()
    path = tmp_path / "again.mbsdf"
    assert not write_measured(read_measured(written(tmp_path, content)), path).notes
    again = path.read_bytes()
    at = content.index(REFLECTION)
    assert again[: len(MAGIC)] == MAGIC
    kept, made = (np.frombuffer(data[data.index(REFLECTION) + 35 :], "<f4") for data in (content, again))
    assert made == pytest.approx(kept, rel=2e-6)
    assert content[at : at + 35] == again[again.index(REFLECTION) :][:35]


def test_a_paint_is_tabulated_and_reads_back(tmp_path: Path) -> None:
    paint = load_material("fine_silver").reflectance
    path = tmp_path / "silver.mbsdf"
    notes = write_measured(paint, path).notes
    assert any("Tabulated every 1°" in note for note in notes)
    assert path.stat().st_size == len(MAGIC) + len(REFLECTION) + 12 + 4 * 3 * 90 * 90 * 180
    grid = read_measured(path)
    wi, wo = _turned.spherical_pair(45.0, 0.0, 20.0, 90.0)
    assert grid.eval(wi, wo) == pytest.approx(paint.eval(wi, wo), rel=2e-3)
    wi, wo = _turned.spherical_pair(40.3, 10.0, 61.7, 76.6)
    assert grid.eval(wi, wo) == pytest.approx(paint.eval(wi, wo), rel=2e-2)


def test_what_turns_with_the_sample_is_not_written(tmp_path: Path) -> None:
    values = np.ones((2, 4, 2, 4, 1), np.float32)
    values[:, 1] = 3.0
    axes = (np.array([0.1, 1.5]), np.radians([0.0, 90.0, 180.0, 270.0]))
    grid = AngleTable("spherical", (*axes, *axes), values)
    with pytest.raises(FileError, match="isotropic"):
        write_measured(grid, tmp_path / "a.mbsdf")


def test_a_matt_white_reads_back_exactly(tmp_path: Path) -> None:
    write_measured(Lambertian(1.0), tmp_path / "white.mbsdf")
    light, view = _turned.spherical_pair(12.3, 0.0, 45.6, 78.9)
    found = read_measured(tmp_path / "white.mbsdf").eval(light, view)
    assert found == pytest.approx([1.0 / np.pi] * 3, rel=1e-6)


@pytest.mark.parametrize(
    ("change", "reason", "place"),
    [
        (lambda data: data[:-1], "cut off", "byte"),
        (lambda data: data[: len(MAGIC) + 5], "ends before MBSDF_DATA", "line 2"),
        (lambda data: data[: len(MAGIC) + len(REFLECTION) + 7], "within the size", "byte"),
        (lambda data: data + b"more", "more bytes", "byte"),
        (lambda data: data.replace(b"_REFLECTION", b"_TRANSMISSION"), "transmission alone", "byte"),
        (
            lambda data: data.replace(struct.pack("<3I", 0, 6, 8), struct.pack("<3I", 2, 6, 8)),
            "no table",
            "byte",
        ),
        (
            lambda data: data.replace(struct.pack("<3I", 0, 6, 8), struct.pack("<3I", 1, 4000, 4000)),
            "more than|cut off",
            "byte",
        ),
        (lambda data: data[:-4] + struct.pack("<f", np.nan), "no finite reflectance", "byte"),
    ],
)
def test_damage_is_refused_with_its_place(tmp_path: Path, change, reason: str, place: str) -> None:
    with pytest.raises(FileError, match=reason) as caught:
        read_measured(written(tmp_path, change(Variant().content())))
    assert (caught.value.place or "").startswith(place)
