"""BSDF text of LightTools: blocks, channels, order and layout, and what is refused."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff
from brdf_suite.reflectance.tabulated.angle_table import AngleTable

_turned = load_module(Path(__file__).parent / "turned_pairs.py")


@dataclass(frozen=True)
class Variant:
    """One way to write a file."""

    content: str = "Monochrome"
    incidences: tuple[float, ...] = (0.0, 30.0, 60.0)
    azimuths: tuple[float, ...] = tuple(np.linspace(0.0, 360.0, 9))
    radial: tuple[float, ...] = (0.0, 15.0, 45.0, 80.0)
    wavelengths: tuple[float, ...] = (550.0,)
    symmetry: str = "Asymmetric"
    per_line: int = 0
    lower: bool = False
    ends: str = "\n"
    comments: bool = False
    backwards: bool = False
    channel_first: bool = False
    short: bool = False
    others: bool = False
    separator: str = " "
    no_symmetry: bool = False

    def channels(self) -> list[tuple[str, float, float]]:
        """The lines that name a channel, its wavelength, and its scale."""
        if self.content == "XYZ":
            return [
                (f"TristimulusValue Tris{axis}", 0.0, scale)
                for axis, scale in {"X": 0.9, "Y": 1.0, "Z": 0.7}.items()
            ]
        return [(f"Wavelength {length:g}", length, 0.001 * length) for length in self.wavelengths]

    def pair(self, incidence: float, azimuth: float, radial: float) -> tuple[np.ndarray, np.ndarray]:
        return _turned.polar(incidence, 90.0), _turned.polar(radial, azimuth)

    def text(self) -> str:
        def listed(word: str, angles: tuple[float, ...]) -> list[str]:
            return [f"{word} {len(angles)}", self.separator.join(f"{angle:g}" for angle in angles)]

        lines = ["# made here"] if self.comments else []
        if not self.no_symmetry:
            lines.append(f"Symmetry {self.symmetry}")
        lines.append(f"SpectralContent {self.content}")
        lines += (
            listed("ScatterAzimuth", self.azimuths) + listed("ScatterRadial", self.radial) + ["DataBegin"]
        )
        keys = [(incidence, channel) for incidence in self.incidences for channel in self.channels()]
        if self.channel_first:
            keys.sort(key=lambda key: [entry[0] for entry in self.channels()].index(key[1][0]))
        for incidence, (channel, _, scale) in keys[::-1] if self.backwards else keys:
            head = [f"AOI {incidence:g}", "POI 0", "Side Front", channel, "ScatterType BRDF"]
            if self.short:
                head = [head[0], channel]
            lines += [*head, "TIS 0.5"]
            if self.comments:
                lines.append("# values follow")
            values = [
                f"{scale * _turned.field(*self.pair(incidence, azimuth, radial)):.7g}"
                for azimuth in self.azimuths
                for radial in self.radial
            ]
            step = self.per_line or len(self.radial)
            lines += [self.separator.join(values[at : at + step]) for at in range(0, len(values), step)]
        if self.others:
            for kind, side in (("BTDF", "Front"), ("BRDF", "Back")):
                lines += [
                    "AOI 0",
                    "POI 0",
                    f"Side {side}",
                    self.channels()[0][0],
                    f"ScatterType {kind}",
                    "TIS 1",
                ]
                lines.append(" ".join("9" for _ in range(len(self.azimuths) * len(self.radial))))
        lines.append("DataEnd")
        text = self.ends.join(lines) + self.ends
        return text.lower() if self.lower else text


VARIANTS = {
    "plain": Variant(),
    "colours": Variant("XYZ"),
    "colours, channel by channel": Variant("XYZ", channel_first=True),
    "colours backwards": Variant("XYZ", backwards=True),
    "spectra": Variant(wavelengths=(450.0, 550.0, 650.0)),
    "spectra backwards": Variant(wavelengths=(420.0, 480.0, 560.0, 640.0, 700.0), backwards=True),
    "spectra, band by band": Variant(wavelengths=(450.0, 550.0, 650.0), channel_first=True),
    "incidences backwards": Variant(backwards=True),
    "one incidence": Variant(incidences=(45.0,)),
    "many incidences": Variant(incidences=(0.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 75.0, 85.0)),
    "one value a line": Variant(per_line=1),
    "all values in a line": Variant(per_line=1000),
    "uneven lines": Variant(per_line=7),
    "lower case": Variant("XYZ", lower=True),
    "other spelling": Variant(symmetry="Asymmetrical"),
    "without symmetry": Variant(no_symmetry=True),
    "comments": Variant(comments=True),
    "carriage returns": Variant(ends="\r\n", comments=True),
    "tabs": Variant(separator="\t"),
    "short heads": Variant(short=True),
    "transmission and back side": Variant(others=True),
    "colours with transmission": Variant("XYZ", others=True),
    "open turn": Variant(azimuths=(0.0, 60.0, 120.0, 180.0, 240.0, 300.0)),
    "uneven angles": Variant(
        azimuths=(0.0, 10.0, 90.0, 265.0, 275.0, 360.0), radial=(0.0, 1.0, 2.5, 59.0, 61.0, 90.0)
    ),
}


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "panel.bsdf"
    path.write_bytes(text.encode())
    return path


@pytest.mark.parametrize("name", VARIANTS)
def test_every_variant_holds_its_values_at_its_directions(tmp_path: Path, name: str) -> None:
    variant = VARIANTS[name]
    path = written(tmp_path, variant.text())
    assert sniff(path).name == "lighttools"
    grid = read_measured(path)
    assert isinstance(grid, AngleTable)
    pairs = [
        variant.pair(incidence, azimuth, radial)
        for incidence in variant.incidences
        for azimuth in variant.azimuths
        for radial in variant.radial
        if radial < 89.0 and incidence > 0.0
    ]
    wi, wo = (np.array([pair[side] for pair in pairs]) for side in (0, 1))
    expected = np.array([_turned.field(*pair) for pair in pairs])
    if variant.content == "XYZ":
        assert grid.eval(wi, wo) @ (0.2627, 0.6780, 0.0593) == pytest.approx(expected, rel=1e-3)
    elif len(variant.wavelengths) > 1:
        scales = [channel[2] for channel in variant.channels()]
        assert grid.eval_spectra(wi, wo) == pytest.approx(expected[:, None] * scales, rel=1e-4)
        assert grid.wavelengths_nm.tolist() == list(variant.wavelengths)
    else:
        assert grid.eval(wi, wo) == pytest.approx(np.repeat(0.55 * expected[:, None], 3, axis=1), rel=1e-4)
    left_out = [note for note in grid.facts.get("notes", ()) if "Left out: 2 blocks" in note]
    assert bool(left_out) == variant.others


@pytest.mark.parametrize(
    ("old", "new", "reason", "line"),
    [
        ("Symmetry Asymmetric", "Symmetry Rotational", "Rotational", 1),
        ("SpectralContent Monochrome", "SpectralContent Rainbow", "Rainbow", 2),
        ("ScatterAzimuth 9", "ScatterAzimuth -1", "expected 1 to", 3),
        ("ScatterAzimuth 9", "ScatterAzimuth 9e9", "expected 1 to", 3),
        ("ScatterRadial 4", "ScatterRadial 3", "expected a word of the head, not '80'", 6),
        ("0 15 45 80", "0 15 45 15", "rise", 7),
        ("POI 0", "POI 90", "several planes of incidence", 23),
        ("AOI 30", "AOI 0", "3 blocks; 2 incidences", 38),
        ("AOI 60", "AOI 160", "rise from 0 to at most 90", 8),
        ("ScatterType BRDF", "ScatterType BSDF", "BSDF", 12),
        ("TIS 0.5", "TOS 0.5", "expected a word of a block", 13),
        ("DataEnd", "", "ends before DataEnd", 0),
        ("Side Front", "Side Up", "Up", 10),
    ],
)
def test_damage_is_refused_with_the_line(tmp_path: Path, old: str, new: str, reason: str, line: int) -> None:
    text = Variant().text()
    assert old in text
    with pytest.raises(FileError, match=reason) as caught:
        read_measured(written(tmp_path, text.replace(old, new, 1)))
    assert (caught.value.place or "").startswith(f"line {line}" if line else "line ")


def test_a_file_of_transmission_alone_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="no reflection"):
        read_measured(written(tmp_path, Variant().text().replace("BRDF", "BTDF")))
