"""Texts from files are formulas to no spreadsheet, whichever part of the suite writes the table."""

from __future__ import annotations

import csv
import io
import unicodedata
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.cli.main import main
from brdf_suite.cli.output import print_csv
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.store import save_paint
from brdf_suite.files.palettes import read_palette, write_palette
from brdf_suite.foreign_text import guard_cells, guard_formula, make_visible, unguard_formula
from brdf_suite.inspection.figures.text import figures_csv
from brdf_suite.inspection.slices.values import slices_csv
from brdf_suite.pipeline.material import load_shipped_paint

BEGINNINGS = tuple("=+-@\t\r\n＝＋－＠")
LINK = '=HYPERLINK("http://example.org")'


def cells(text: str) -> list[str]:
    return [cell for row in csv.reader(io.StringIO(text)) for cell in row]


@given(st.text(alphabet="=+-@＝＋－＠;'\t\r\nab1", max_size=8) | st.text(max_size=20))
def test_a_guarded_text_is_no_formula_and_comes_back(text: str) -> None:
    guarded = guard_formula(text)
    assert not [cell for cell in guarded.split(";") if cell.startswith(BEGINNINGS)]
    assert unguard_formula(guarded) == text


@pytest.mark.parametrize("text", ["Blue;=1+1;", ";@a", "Blue;＝1", 'x;"=1+2;', '"=1'])
def test_a_table_that_is_divided_at_semicolons_holds_no_formulas(text: str, tmp_path: Path) -> None:
    notes = f'{text}\n=1;x\n"=2\n- a'
    paint = replace(load_shipped_paint("blue"), name=text, notes=notes)
    palette = Palette(
        "P", (Entry(paint, group=(text, "a"), tags=("a", text[1:], text), code=text, notes=notes),)
    )
    path = tmp_path / "a.csv"
    write_palette(palette, path)
    rows = csv.reader(path.read_text("utf-8-sig").splitlines(), delimiter=";")
    assert not [cell for row in rows for cell in row if cell.startswith(BEGINNINGS)]
    (entry,) = read_palette(path).palette.entries
    assert (entry.content.name, entry.notes, entry.group, entry.tags, entry.code) == (
        text,
        notes,
        (text, "a"),
        ("a", text[1:], text),
        text,
    )


def test_characters_that_are_not_seen_are_shown_by_their_number() -> None:
    formats = [chr(code) for code in range(0x110000) if unicodedata.category(chr(code)) == "Cf"]
    others = "\0\x1b\x7f\x85\ud800\u2028\u2029\u034f\u115f\u3164\uffa0\U000e0002"
    # Of numbers and verses.
    signs = "\u0600\u0601\u0602\u0603\u0604\u0605\u06dd\u070f\u0890\u0891\u08e2\U000110bd\U000110cd"
    for character in {*formats, *others}:
        wanted = character if character in signs else f"[U+{ord(character):04X}]"
        assert make_visible(f"a{character}b") == f"a{wanted}b"
    seen = "Grün 15° ß\t\n❤\ufe0f é 漢"
    assert make_visible(seen) == seen


def test_numbers_are_not_guarded() -> None:
    row = {"a": -1.5, "b": "-1.5", "c": "+2e3", "d": -3, "e": "-inf", "f": "-x"}
    assert guard_cells(row) == {**row, "f": "'-x"}


def test_the_command_writes_no_formulas(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.brdfpaint"
    save_paint(replace(load_shipped_paint("blue"), name=LINK), path)
    assert main(["measure", str(path), "--csv"]) == 0
    found = cells(capsys.readouterr().out)
    assert f"'{LINK}" in found
    assert LINK not in found
    print_csv([{"name": LINK, "value": -0.5}])
    assert cells(capsys.readouterr().out) == ["name", "value", f"'{LINK}", "-0.5"]


def test_tables_of_the_visualizer_hold_no_formulas() -> None:
    assert cells(slices_csv("angle", np.array([-1.0]), [(LINK, np.array([-2.0]))], LINK))[:2] == [
        "angle",
        f"'{LINK}",
    ]
    assert figures_csv([]) == "figure,unit\r\n"


@pytest.mark.parametrize("beginning", BEGINNINGS[:4])
def test_a_palette_comes_back_from_its_table(beginning: str, tmp_path: Path) -> None:
    text = f"{beginning}1+1"
    paint = replace(load_shipped_paint("blue"), name=text, notes=f"\t{text}", source=text)
    palette = Palette("P", (Entry(paint, group=(text,), tags=(text,), code=text, notes=f"\t{text}"),))
    path = tmp_path / "a.csv"
    write_palette(palette, path)
    assert not [
        cell
        for cell in cells(path.read_text("utf-8-sig"))
        if cell.endswith("1+1") and cell.startswith(BEGINNINGS)
    ]
    (entry,) = read_palette(path).palette.entries
    assert (entry.content.name, entry.content.notes, entry.group, entry.tags, entry.code, entry.notes) == (
        text,
        f"\t{text}",
        (text,),
        (text,),
        text,
        f"\t{text}",
    )
