"""Swatches through the clipboard: whole to our own windows, as text and colour to others, and back from them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from brdf_color_swatch.editing.transfer import can_take, entries_of_text, read_data, source_of
from brdf_qt.choosing.drag import MIME, PAINT_MIME, carry
from PySide6.QtCore import QMimeData, QUrl
from PySide6.QtGui import QColor

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.store import paint_to_json, save_paint
from brdf_suite.errors import SuiteError

RED = Entry(
    solid_paint("Réd\u4e00", (50.0, 60.0, 40.0)), id="r", group=("A", "B"), tags=("x",), notes="two\nlines"
)
INK = Entry(FlatColour("Ink", "CMYK", (0.1, 0.2, 0.3, 0.4)), id="i", usage="spot", code="7")


def test_all_of_an_entry_comes_through() -> None:
    carried = read_data(carry([RED, INK], ["#aa3322", "#101010"], "p1", "me"))
    assert carried.entries == (RED, INK)
    assert (carried.source, carried.owner, carried.ids) == ("p1", "me", ("r", "i"))


def test_the_name_of_the_palettes_file_may_be_no_text() -> None:
    source = "/palettes/\udcff.brdfpalette"
    data = carry([RED], ["#aa3322"], source, "me")
    assert read_data(data).source == source
    assert source_of(data) == ("me", source)


def test_other_programs_get_text_a_colour_and_the_paint() -> None:
    data = carry([RED], ["#aa3322"], "p1", "me")
    assert data.text() == "#aa3322\tRéd\u4e00"
    assert QColor(data.colorData()).name() == "#aa3322"
    assert json.loads(data.data(PAINT_MIME).data())["name"] == "Réd\u4e00"
    flat = carry([INK], ["#101010"], "p1", "me")
    assert not flat.hasFormat(PAINT_MIME)


def test_the_table_for_other_programs_is_no_formula_and_comes_back() -> None:
    entries = [
        Entry(FlatColour(name, "RGB", (1.0, 0.0, 0.0), space="sRGB"), id=name, code=code)
        for name, code in (("=1+1", "@7"), ("-Blue", "-7"), ("Red", "+a"))
    ]
    data = carry(entries, ["#ff0000"] * 3, "p1", "me")
    assert data.text().splitlines() == ["#ff0000\t'=1+1\t'@7", "#ff0000\t'-Blue\t-7", "#ff0000\tRed\t'+a"]
    assert [entry.name for entry in entries_of_text(data.text())] == ["=1+1 @7", "Blue -7", "Red +a"]


@pytest.mark.parametrize(
    ("text", "name", "model", "values"),
    [
        ("#ff8000  Sunset, deep", "Sunset deep", "RGB", (1.0, 128 / 255, 0.0)),
        ("--brand: #08f;", "brand", "RGB", (0.0, 136 / 255, 1.0)),
        ("Sea rgb(0, 51, 255)", "Sea", "RGB", (0.0, 0.2, 1.0)),
        ("Grey L* 50.5 a* -1 b* 2", "Grey", "Lab", (50.5, -1.0, 2.0)),
        ("lab(29.2% 39.3 20.1)", "lab(29.2% 39.3 20.1)", "Lab", (29.2, 39.3, 20.1)),
        ("Rose CIELab(60, 30, 5)", "Rose", "Lab", (60.0, 30.0, 5.0)),
        ("Coral: L60 a30 b5", "Coral", "Lab", (60.0, 30.0, 5.0)),
    ],
)
def test_text_of_other_programs(text: str, name: str, model: str, values: tuple[float, ...]) -> None:
    (entry,) = entries_of_text(text)
    assert entry.content.model == model
    assert entry.content.values == pytest.approx(values)
    assert name in entry.name


def test_every_line_is_a_colour_and_what_is_none_is_left_out() -> None:
    found = entries_of_text("#112233 one\nno colour here\n#445566 two\n\x00#778899\n")
    assert [entry.name for entry in found] == ["one", "two", "#778899"]
    assert len({entry.id for entry in found}) == 3


@pytest.mark.parametrize("text", ["RAL 090 80 20", "Steel 45 10 20", "oklab(0.6 0.1 0.1)", "Model_L 1 2 3"])
def test_the_end_of_a_word_is_no_lightness(text: str) -> None:
    assert entries_of_text(text) == []


def test_a_paint_as_text_as_a_file_and_a_colour(tmp_path: Path) -> None:
    assert entries_of_text(json.dumps(paint_to_json(RED.content)))[0].content == RED.content
    save_paint(RED.content, tmp_path / "red.brdfpaint")
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(tmp_path / name)) for name in ("red.brdfpaint", "all.ase")])
    carried = read_data(data)
    assert carried.paints == (tmp_path / "red.brdfpaint",)
    assert carried.files == (tmp_path / "all.ase",)
    colour = QMimeData()
    colour.setColorData(QColor("#336699"))
    assert can_take(colour)
    assert read_data(colour).entries[0].content.values == pytest.approx((0.2, 0.4, 0.6), abs=1e-4)


@pytest.mark.parametrize("content", [b"{", b"[]", b'{"owner": 1}', b"\xff", b"[" * 100_000])
def test_what_only_says_that_it_is_ours_is_refused(content: bytes) -> None:
    data = QMimeData()
    data.setData(MIME, content)
    with pytest.raises(SuiteError):
        read_data(data)


def test_a_text_that_is_too_long_is_refused() -> None:
    data = QMimeData()
    data.setText("#112233 one\n" * 300_000)
    assert len(read_data(data).entries) == 100_000
    data.setText("#112233 one\n" * 400_000)
    with pytest.raises(SuiteError, match="has 4,800,000 characters; at most 4,000,000 are read"):
        read_data(data)


def test_nothing_is_nothing() -> None:
    assert read_data(QMimeData()).entries == ()
    assert entries_of_text("just words") == []
