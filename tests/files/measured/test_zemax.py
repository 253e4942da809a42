"""BSDF text of Zemax: directions, blocks, symmetry, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

INCIDENCES = (0.0, 20.0, 45.0, 60.0)
AZIMUTHS = (0.0, 45.0, 90.0, 135.0, 180.0)
RADIAL = (0.0, 5.0, 15.0, 30.0, 60.0, 100.0)
Field = Callable[[np.ndarray, np.ndarray], float]


def about_the_mirror(incidence: float, azimuth: float, radial: float) -> tuple[np.ndarray, np.ndarray]:
    """Light and view of a grid's point, by turning the view out of the mirror direction step by step."""
    light = spherical(np.radians(incidence), 0.0)
    mirror = spherical(np.radians(incidence), np.pi)
    # In the plane of incidence, square to the mirror direction, on the normal's side.
    up = np.array([np.cos(np.radians(incidence)), 0.0, np.sin(np.radians(incidence))])
    aside = np.cross(mirror, up)
    around = np.cos(np.radians(azimuth)) * up + np.sin(np.radians(azimuth)) * aside
    return light, np.cos(np.radians(radial)) * mirror + np.sin(np.radians(radial)) * around


def lobe(light: np.ndarray, view: np.ndarray) -> float:
    """A reflectance that depends on every angle."""
    half = (light + view) / np.linalg.norm(light + view)
    return float(0.1 + max(half[2], 0.0) ** 20 + 0.05 * view[2] + 0.02 * abs(view[1]))


def document(
    field: Field = lobe, content: str = "Monochrome", blocks: tuple[str, ...] = ("Monochrome",)
) -> str:
    def row(angles: tuple[float, ...]) -> str:
        return " ".join(f"{angle:g}" for angle in angles)

    lines = [
        "# made here", "Source  Measured", "Symmetry  PlaneSymmetrical", f"SpectralContent  {content}",
        "ScatterType  BRDF", "SampleRotation  1", "0", f"AngleOfIncidence  {len(INCIDENCES)}", row(INCIDENCES),
        f"ScatterAzimuth {len(AZIMUTHS)}", row(AZIMUTHS), f"ScatterRadial {len(RADIAL)}", row(RADIAL), "",
    ]  # fmt: skip
    for scale, block in enumerate(blocks, 1):
        lines += [block, "DataBegin"]
        for incidence in INCIDENCES:
            lines.append("TIS 0.5")
            for azimuth in AZIMUTHS:
                points = [about_the_mirror(incidence, azimuth, radial) for radial in RADIAL]
                lines.append(
                    "\t".join(repr(scale * field(*point) if point[1][2] > 0 else 0.0) for point in points)
                )
        lines.append("DataEnd")
    return "\n".join(lines) + "\n"


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "panel.bsdf"
    path.write_text(text, "utf-8")
    return path


def test_values_stand_at_their_directions(tmp_path: Path) -> None:
    path = written(tmp_path, document())
    assert sniff(path).name == "zemax"
    value = read_measured(path)
    assert isinstance(value, ScatteredSamples)
    above = [
        point
        for incidence in INCIDENCES
        for azimuth in AZIMUTHS
        for radial in RADIAL
        if (point := about_the_mirror(incidence, azimuth, radial))[1][2] > 1e-6
    ]
    assert len(value.wi) == len(above)
    for light, view, found, (wi, wo) in zip(value.wi, value.wo, value.values, above, strict=True):
        assert light == pytest.approx(wi, abs=1e-9)
        assert view == pytest.approx(wo, abs=1e-9) or view == pytest.approx(wo * (1, -1, 1), abs=1e-9)
        assert found == pytest.approx([lobe(wi, wo)] * 3)


def test_tristimulus_blocks_make_a_colour(tmp_path: Path) -> None:
    grey = read_measured(written(tmp_path, document()))
    names = ("TristimulusX", "TristimulusY", "TristimulusZ")
    coloured = read_measured(written(tmp_path, document(content="XYZ", blocks=names)))
    light, view = (part[None] for part in about_the_mirror(45.0, 0.0, 15.0))
    red, green, blue = coloured.eval(light, view)[0]
    assert blue > green > 0.0
    # The Y of the working space is that of the second block, twice the grey.
    assert 0.2627 * red + 0.6780 * green + 0.0593 * blue == pytest.approx(
        2 * grey.eval(light, view)[0, 0], rel=0.02
    )


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("ScatterType  BRDF", "ScatterType  BTDF", "transmission"),
        ("SpectralContent  Monochrome", "SpectralContent  Rainbow", "spectral content"),
        ("AngleOfIncidence  4", "AngleOfIncidence  -1", "expected 1 to"),
        ("0 20 45 60", "0 20 45 600", "beyond 90°"),
        ("0 20 45 60", "0 20 45 60 70", "expected 4 angles, not 5"),
        ("TIS 0.5", "TOS 0.5", "expected TIS"),
        ("DataEnd", "", "ends before DataEnd"),
        ("ScatterRadial 6", "ScatterRadial 5", "expected 5 angles, not 6"),
    ],
)
def test_damage_is_refused_with_the_line(tmp_path: Path, old: str, new: str, reason: str) -> None:
    with pytest.raises(FileError, match=reason) as caught:
        read_measured(written(tmp_path, document().replace(old, new, 1)))
    assert (caught.value.place or "").startswith("line ")


def test_a_row_that_is_too_short_is_refused(tmp_path: Path) -> None:
    text = document()
    last = text.splitlines()[-2]
    with pytest.raises(FileError, match="expected 6 values, not 5"):
        read_measured(written(tmp_path, text.replace(last, last.rpartition("\t")[0])))


def varied(**changes: object) -> str:
    """The document, changed: words of the head replaced, lines cut, spelled, or separated in other ways."""
    text = document()
    for old, new in changes.get("words", {}).items():
        assert old in text
        text = text.replace(old, new)
    if "each_line" in changes:
        text = "\n".join(changes["each_line"](line) for line in text.splitlines()) + "\n"
    return text.replace("\n", changes.get("ends", "\n"))


VARIANTS = {
    "plain": varied(),
    "carriage returns": varied(ends="\r\n"),
    "tabs": varied(each_line=lambda line: "\t".join(line.split())),
    "wide spaces": varied(each_line=lambda line: "    ".join(line.split())),
    "leading spaces": varied(each_line=lambda line: "  " + line),
    "lower case": varied(each_line=str.lower),
    "upper case": varied(each_line=str.upper),
    "comments": varied(each_line=lambda line: line + "\n# and so on"),
    "comments behind": varied(each_line=lambda line: line + " # said here"),
    "blank lines": varied(each_line=lambda line: line + "\n"),
    "asymmetrical": varied(words={"PlaneSymmetrical": "Asymmetrical"}),
    "asymmetrical in 4D": varied(words={"PlaneSymmetrical": "Asymmetrical4D"}),
    "spelled ASymmetrical": varied(words={"PlaneSymmetrical": "ASymmetrical"}),
    "without source": varied(words={"Source  Measured\n": ""}),
    "another source": varied(words={"Source  Measured": "Source  Simulated"}),
    "without scatter type": varied(words={"ScatterType  BRDF\n": ""}),
    "turned once": varied(words={"SampleRotation  1\n0\n": "SampleRotation  1\n90\n"}),
    "angles over lines": varied(words={"0 20 45 60": "0 20\n45\n60", "0 45 90 135 180": "0\n45 90\n135 180"}),
    "angles with decimals": varied(words={"0 20 45 60": "0.000 2.0E+01 4.5E+1 60.0"}),
    "without a blank line": varied(words={"100\n\nMonochrome": "100\nMonochrome"}),
    "a dark TIS": varied(words={"TIS 0.5": "TIS 0"}),
    "a byte order mark": "\ufeff" + varied(),
    "a long comment": "# " + 3000 * "x" + "\n" + varied(),
}


@pytest.mark.parametrize("name", VARIANTS)
def test_every_variant_holds_the_same_values(tmp_path: Path, name: str) -> None:
    path = written(tmp_path, VARIANTS[name])
    assert sniff(path).name == "zemax"
    value = read_measured(path)
    plain = read_measured(written(tmp_path, VARIANTS["plain"]))
    assert np.array_equal(value.wi, plain.wi)
    assert np.array_equal(value.wo, plain.wo)
    assert value.values == pytest.approx(plain.values, rel=1e-12)
    assert len(value.values) > 60
