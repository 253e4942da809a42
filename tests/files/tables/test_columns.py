"""Headings of tables: what they are, in the many ways in which they are written."""

from __future__ import annotations

import pytest

from brdf_suite.files.tables.columns import interpret, parse_geometry
from brdf_suite.files.tables.grid import decode, find_separator, parse_number, read_rows


def whats(*headings: str) -> list[str]:
    return [column.what for column in interpret(headings)]


def angles(*headings: str) -> list[float | None]:
    return [column.geometry[1] if column.geometry else None for column in interpret(headings)]


def test_letters_make_models_with_their_neighbours() -> None:
    assert whats("R", "G", "B", "L", "a", "b", "C", "M", "Y", "K") == [
        "RGB.r", "RGB.g", "RGB.b", "Lab.l", "Lab.a", "Lab.b", "CMYK.c", "CMYK.m", "CMYK.y", "CMYK.k",
    ]  # fmt: skip
    assert whats("L*", "C*", "h°") == ["LCh.l", "LCh.c", "LCh.h"]
    assert whats("L", "a", "b", "C", "h") == ["Lab.l", "Lab.a", "Lab.b", "derived", "derived"]
    assert whats("Hue", "Saturation", "Value") == ["HSB.h", "HSB.s", "HSB.b"]
    assert whats("X", "Y", "Z") == ["XYZ.x", "XYZ.y", "XYZ.z"]
    assert whats("x", "y", "z") == ["", "", ""]
    assert whats("b", "name", "r", "g") == ["RGB.b", "name", "RGB.r", "RGB.g"]


@pytest.mark.parametrize(
    "form",
    [
        "L*{}", "L{}", "L_{}", "L* {}°", "L*({}°)", "{}° L*", "45as{} L*", "L* 45as{}", "r45as{}.L", "CIE L {}°",
        "L*(D65/10°) 45as{}",
    ],
)  # fmt: skip
@pytest.mark.parametrize("angle", ["-15", "15", "110"])
def test_an_angle_is_found_in_any_usual_heading(form: str, angle: str) -> None:
    headings = [form.format(angle).replace("L", letter) for letter in "Lab"]
    # A further angle without a sign shows that a hyphen is one.
    more = [form.format("25").replace("L", letter) for letter in "Lab"]
    assert whats(*headings, *more)[:3] == ["Lab.l", "Lab.a", "Lab.b"]
    assert angles(*headings, *more)[:3] == [float(angle)] * 3


def test_a_hyphen_before_every_angle_is_a_mark() -> None:
    assert angles("L-15", "a-15", "b-15", "L-110", "a-110", "b-110") == [15, 15, 15, 110, 110, 110]


def test_differences_gloss_and_effects_are_known_as_such() -> None:
    found = whats(
        "L15", "a15", "b15", "dL15", "ΔE 15°", "dE*", "Si15", "Sa 45°", "Graininess", "G", "G20", "Gloss 60°"
    )
    assert found[3:] == [
        "difference", "difference", "difference", "sparkle intensity", "sparkle area", "graininess", "graininess",
        "gloss 20", "gloss 60",
    ]  # fmt: skip


def test_wavelengths_need_company() -> None:
    assert whats("400", "410", "420") == ["spectrum"] * 3
    assert whats("R400 nm", "R410 nm", "R420 nm") == ["spectrum"] * 3
    assert whats("400", "name") == ["", "name"]
    assert angles("15° 400", "15° 410", "15° 420") == [15.0] * 3


def test_geometries_of_cells() -> None:
    assert parse_geometry("r45as-15") == (45.0, -15.0, 0.0)
    assert parse_geometry("15as-45") == (15.0, -45.0, 0.0)
    assert parse_geometry("45as60az125.3") == (45.0, 60.0, 125.3)
    assert parse_geometry("\u221215°") == (45.0, -15.0, 0.0)
    assert parse_geometry("25") == (45.0, 25.0, 0.0)
    assert parse_geometry("400") is None
    assert parse_geometry("D65") is None


def test_numbers_encodings_and_separators() -> None:
    assert parse_number("1,5") == parse_number("1.5") == 1.5
    assert parse_number("50 %") == 50.0
    assert parse_number("1_0") is None
    assert parse_number("1.234,5") is None
    assert parse_number("nan") is None
    assert decode("Süd".encode("utf-16-le")) == ("Süd", False)
    assert decode("Süd".encode("cp1252")) == ("Süd", True)
    assert decode(bytes(range(256))) is None
    assert find_separator("a;1,5;2\nb;2,5;3") == ";"
    assert find_separator("a,1.5\nb;c,2.5") == ","
    assert [row.cells for row in read_rows('sep=;\n"a;b";1\n\nc;2\n', "x", 10)] == [("a;b", "1"), ("c", "2")]
