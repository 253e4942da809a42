"""Every palette format of the registry: what it holds comes back, what it does not is reported."""

from __future__ import annotations

import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.flat_colours import flat_labs
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.flat_colour import CHANNELS, FlatColour
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, OrangePeel, Paint
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.palettes import FORMATS, format_for, losses, read_content, read_palette, write_palette
from brdf_suite.files.palettes.format import PaletteFormat, ReadPalette
from brdf_suite.files.palettes.text.css import parse_colour

WRITERS = load_module(Path(__file__).parent / "foreign_writers.py").WRITERS
WRITTEN = [known for known in FORMATS if known.write is not None]
NAMES = [known.name for known in FORMATS]
EXACT = {"brdfpalette", "scribus", "kpl", "sbz", "css", "json", "csv", "cxf"}
"""Formats that hold numbers to the last bit."""

METALLIC = Paint(
    'Silver "1" & <2>',
    tuple(
        Measurement(45.0, angle, (100.0 - 0.5 * angle, 0.1, -1.0 / 3.0))
        for angle in (15.0, 25.0, 45.0, 75.0, 110.0)
    ),
    Gloss(92.0, 97.0),
    Flakes(),
    orange_peel=OrangePeel(),
    notes="a\nb",
    source="measured",
)
SPECTRUM = FlatColour(
    "spectrum",
    "spectrum",
    tuple(0.1 + 0.02 * i for i in range(31)),
    wavelengths_nm=tuple(400.0 + 10.0 * i for i in range(31)),
)


def palette() -> Palette:
    """A palette with something of everything."""
    flat = [
        Entry(FlatColour("Red", "RGB", (1.0, 0.2, 0.4)), code="R1", tags=("a", "b;c"), usage="global"),
        Entry(
            FlatColour("Ätna 藍 🎨", "CMYK", (1.0, 0.7, 0.1, 0.0)),
            group=("Inks",),
            usage="spot",
            date="2024-05-31",
        ),
        Entry(
            FlatColour("Lab", "Lab", (60.0, -30.5, 12.25), "", "D50", 2),
            group=("Inks", "Deep / er"),
            notes="n\nm",
        ),
        Entry(FlatColour("Grey", "Gray", (0.25,)), group=("Inks",)),
        Entry(FlatColour("Hue", "HSB", (210.0, 0.5, 0.75))),
        Entry(SPECTRUM, group=("Spectra",)),
        Entry(FlatColour("", "RGB", (0.0, 0.0, 0.0))),
        Entry(METALLIC, group=("Paints",), code="LY7W", tags=("metallic",)),
    ]
    groups = (Group(("Inks",), "notes of it", "#102030"), Group(("Empty",)))
    return Palette("Süd & <Nord>", tuple(flat), groups, "first\nsecond", "#aabbcc", 4)


@pytest.fixture(scope="module")
def full() -> Palette:
    return palette()


def content_of(known: PaletteFormat, full: Palette) -> bytes:
    """A small file of the format, made by hand where it is only read."""
    if known.name == "act":
        return bytes(range(256)) * 3 + struct.pack(">HH", 7, 2)
    if known.name == "acb":

        def text(value: str) -> bytes:
            return struct.pack(">I", len(value)) + value.encode("utf-16-be")

        head = b"8BCB" + struct.pack(">HH", 1, 3000)
        head += text("$$$/colorbook/X/title=My Book^R") + text("MB ") + text(" C") + text("Words")
        colours = text("one") + b"000001" + bytes((128, 200, 60)) + text("") + b"      " + bytes(3)
        colours += text("two") + b"000002" + bytes((255, 128, 128))
        return head + struct.pack(">4H", 3, 7, 3, 7) + colours + b"spflspot"
    if known.write is None:
        return next(next(make()).content for name, make in WRITERS.values() if name == known.name)
    assert known.write is not None
    return known.write(full)


@pytest.fixture(params=FORMATS, ids=NAMES)
def known(request: pytest.FixtureRequest) -> PaletteFormat:
    found: PaletteFormat = request.param
    return found


@pytest.fixture(params=WRITTEN, ids=[known.name for known in WRITTEN])
def written(request: pytest.FixtureRequest) -> PaletteFormat:
    found: PaletteFormat = request.param
    return found


def test_a_file_is_known_by_its_content_alone(known: PaletteFormat, full: Palette, tmp_path: Path) -> None:
    path = tmp_path / "misleading.gpl"
    path.write_bytes(content_of(known, full))
    assert read_palette(path).format.name == known.name


def test_what_was_read_is_written_and_read_again_without_loss(written: PaletteFormat, full: Palette) -> None:
    content = content_of(written, full)
    first = read_content(content, "a", written).palette
    assert len(first) == len(full)
    again = written.write(first)
    assert read_content(again, "a", written).palette == first
    # A palette without a name of its own has that of its file.
    assert losses(first, written, "a") == ()


def test_what_a_format_claims_to_hold_comes_back(written: PaletteFormat, full: Palette) -> None:
    back = read_content(content_of(written, full), "a", written).palette
    by_name = {entry.name: entry for entry in back}
    if written.unique_names:
        by_name[""] = by_name.pop("Colour 7")
    for index, entry in enumerate(full):
        if isinstance(entry.content, FlatColour) and entry.content.model in written.models:
            own = entry.content
            new = by_name[entry.name].content if len(by_name) > 1 else back.entries[index].content
            assert isinstance(new, FlatColour)
            assert new.model == own.model
            close = pytest.approx(own.values, abs=6e-5, rel=1e-5)
            assert new.values == (own.values if written.name in EXACT else close)
    if written.groups != "none":
        assert {group.name for group in back.groups} >= {"Inks", "Empty", "Paints"} or written.name == "csv"
    if written.groups == "nested":
        assert by_name["Lab"].group == ("Inks", "Deep / er")
    paint = next(iter(e for e in back if e.name == METALLIC.name), None)
    if written.paints:
        assert paint is not None
        assert paint.content == METALLIC
        assert (paint.code, paint.tags) == ("LY7W", ("metallic",))
    elif paint is not None:
        assert isinstance(paint.content, FlatColour)


def test_losses_are_reported_before_and_after_writing(
    written: PaletteFormat, full: Palette, tmp_path: Path
) -> None:
    path = tmp_path / f"palette{written.endings[0]}"
    reported = losses(full, written, path)
    done = write_palette(full, path, written)
    assert done.losses == reported
    assert done.size == path.stat().st_size
    assert all(sentence.endswith(".") for sentence in reported)
    words = " ".join(reported)
    assert (reported == ()) == (written.name in ("brdfpalette", "json"))
    assert ("at 45°" in words) == (not written.paints)
    assert ("CMYK are written as" in words or "CMYK is written as" in words) == ("CMYK" not in written.models)
    if written.groups == "none":
        assert "groups of" in words
    assert [item.name for item in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("model", sorted(CHANNELS))
def test_numbers_of_every_model_are_kept_by_those_that_hold_it(written: PaletteFormat, model: str) -> None:
    random = np.random.default_rng(len(model))
    rows = []
    for index in range(40):
        lows = [max(c.low, 0.0 if c.unit or c.low < -10 else c.low) for c in CHANNELS[model]]
        highs = [min(c.high, 1.0 if c.low == -64.0 else 100.0) for c in CHANNELS[model]]
        values = random.uniform(lows, highs)
        rows.append(Entry(FlatColour(f"c{index}", model, tuple(values.tolist()), "", *white_of(model))))  # type: ignore[arg-type]  # sampled words
    own = Palette("p", tuple(rows))
    back = read_content(written.write(own), "a", written).palette
    if model not in written.models:
        assert all(entry.content.model != model for entry in back)
        assert any(f"in {model} are written as" in loss for loss in losses(own, written))
    elif written.name in EXACT:
        assert [entry.content for entry in back] == [entry.content for entry in own]
    else:
        steps = {"ase": 2e-7, "aco": 5.1e-5}.get(written.name, 0.5 / 255.0 + 1e-9)
        for entry, other in zip(own, back, strict=True):
            scale = np.array(
                [c.high if c.high in (360.0,) else 100.0 if model == "Lab" else 1.0 for c in CHANNELS[model]]
            )
            assert np.all(np.abs(np.subtract(entry.content.values, other.content.values)) <= steps * scale)


def white_of(model: str) -> tuple[str, int]:
    return ("D50", 2) if model in ("Lab", "LCh", "XYZ") else ("", 0)


def test_a_paint_of_any_kind_is_read_by_instruments_where_only_readings_go() -> None:
    lobes = (CookTorranceLobe((0.2, 0.2, 0.2), 0.2, 0.5),)
    own = Palette("p", (Entry(CookTorrancePaint("fit", (0.1, 0.05, 0.02), lobes)),))
    for name in ("csv", "cxf"):
        known = next(f for f in FORMATS if f.name == name)
        assert "Only what the virtual instruments read" in losses(own, known)[0]
    back = read_content(next(f for f in FORMATS if f.name == "gpl").write(own), "a").palette
    assert back.entries[0].content.model == "RGB"


@pytest.fixture(scope="module")
def real(shared_data: Path) -> list[tuple[Path, ReadPalette]]:
    """Every palette of another program."""
    paths = sorted((shared_data / "palettes").rglob("*"))
    return [(path, read_palette(path)) for path in paths if path.is_file() and path.suffix != ".xsd"]


def test_every_real_palette_loads_and_comes_back(
    known: PaletteFormat, real: list[tuple[Path, ReadPalette]], tmp_path: Path
) -> None:
    seen = 0
    for path, found in real:
        if found.format is not known:
            continue
        seen += 1
        if known.write is not None:
            again = tmp_path / path.name
            done = write_palette(found.palette, again, known)
            assert done.losses == (), path.name
            assert read_palette(again).palette == found.palette, path.name
    made_here = {"brdfpalette", "acb", "csv", "css", "json", "hex", "scss", "instrument"}
    assert seen > 0 or known.name in made_here


def test_endings_name_formats_and_unknown_ones_are_reported(tmp_path: Path) -> None:
    assert format_for("a.GPL").name == "gpl"
    assert format_for("a.pal").name == "riff"
    with pytest.raises(FileError, match="names no palette format"):
        format_for("a.xyz")
    with pytest.raises(FileError, match=r"\.acb names no palette format that is written"):
        format_for("a.acb")
    other = tmp_path / "a.txt"
    other.write_text(("hello" * 200)[:768], "utf-8")  # as long as a colour table
    with pytest.raises(FileError, match="no palette format that is known"):
        read_palette(other)
    act = next(f for f in FORMATS if f.name == "act")
    with pytest.raises(SuiteError, match="only read"):
        losses(Palette("p"), act)


def test_order_in_groups_is_reported_where_a_file_must_change_it() -> None:
    gray = FlatColour("", "Gray", (0.5,))
    mixed = Palette("p", (Entry(gray, group=("A",)), Entry(gray, group=("B",)), Entry(gray, group=("A",))))
    ase = next(f for f in FORMATS if f.name == "ase")
    assert "The entries of each group stand together there." in losses(mixed, ase)
    assert [e.group for e in read_content(ase.write(mixed), "a").palette] == [("A",), ("A",), ("B",)]
    empty = replace(mixed, entries=(), groups=(Group(("A", "B")),))
    assert [g.path for g in read_content(ase.write(empty), "a").palette.groups] == [("A",), ("A", "B")]


def written_as(name: str, colour: FlatColour) -> tuple[FlatColour, str]:
    """Return what comes back of a colour from a format, and its notices."""
    known, own = next(f for f in FORMATS if f.name == name), Palette("p", (Entry(colour),))
    assert known.write is not None
    back = read_content(known.write(own), "a", known).palette.entries[0].content
    assert isinstance(back, FlatColour)
    return back, " ".join(losses(own, known))


@pytest.mark.parametrize("name", ["ase", "aco", "scribus", "gpl"])
@pytest.mark.parametrize("model", ["RGB", "HSB"])
def test_colours_of_another_space_stay_the_same_colours_where_a_format_knows_none(
    name: str, model: str
) -> None:
    values = (0.6, 0.3, 0.2) if model == "RGB" else (15.0, 2.0 / 3.0, 0.6)
    own = FlatColour("c", model, values, "Adobe RGB (1998)")  # type: ignore[arg-type]  # one of its words
    back, reported = written_as(name, own)
    assert (back.model, back.space) == ("RGB", "")
    # As far as eight bits go.
    assert delta_e_2000(*flat_labs([own, back])) < (0.5 if name == "gpl" else 0.01)
    as_what = "Adobe RGB (1998) is written as sRGB." if model == "RGB" else "HSB is written as RGB."
    assert f"1 colour in {as_what}" in reported
    if name == "scribus":
        assert "rounded" not in reported


def test_spaces_and_whites_that_are_lost_are_reported_beside_rounded_numbers() -> None:
    back, reported = written_as("ase", FlatColour("c", "RGB", (0.7, 0.2, 0.1), "Press 7"))
    assert back.values == pytest.approx((0.7, 0.2, 0.1))
    assert "The numbers of 1 colour are rounded." in reported
    assert "The colour spaces of 1 colour are left out." in reported
    _, reported = written_as("ase", FlatColour("c", "Lab", (60.1, 10.1, 20.1), "", "D65", 10))
    assert "The whites that 1 colour is measured by are left out." in reported


def test_colours_beyond_what_a_format_holds_are_reported_as_such() -> None:
    for name in ("aco", "gpl"):
        _, reported = written_as(name, FlatColour("c", "RGB", (0.7, 0.2, 0.1), "ProPhoto RGB"))
        assert "1 colour is beyond what it holds and brought to the nearest that it does." in reported
        assert "rounded" not in reported
    back, reported = written_as("ase", FlatColour("c", "RGB", (0.7, 0.2, 0.1), "ProPhoto RGB"))
    assert back.values[0] > 1.0
    assert "beyond" not in reported


def test_a_further_model_in_another_space_is_converted_too() -> None:
    others = (FlatColour("", "RGB", (178 / 255, 51 / 255, 26 / 255), "Adobe RGB (1998)"),)
    own = FlatColour("c", "Lab", (45.0, 60.0, 50.0), "", "D50", 2, (), others)
    back, _ = written_as("gpl", own)
    assert tuple(255 * value for value in back.values) == pytest.approx((207, 48, 16), abs=1.01)
    for name in ("css", "kpl"):
        # Those that name the space keep the numbers.
        kept, _ = written_as(name, others[0])
        assert (kept.values, kept.space) == (others[0].values, others[0].space)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("hwb(0 60% 60%)", (0.0, 0.0, 0.5)),
        ("hwb(40 100% 100%)", (40.0, 0.0, 0.5)),
        ("hwb(40 90% 30%)", (40.0, 0.0, 0.75)),
        ("hwb(40 20% 80%)", (40.0, 0.0, 0.2)),
        ("hwb(40 20% 60%)", (40.0, 0.5, 0.4)),
    ],
)
def test_white_and_black_of_hwb_beyond_the_whole_are_a_grey(text: str, wanted: tuple[float, ...]) -> None:
    found = parse_colour(text)
    assert found is not None
    assert found[0].values == pytest.approx(wanted)


@pytest.mark.parametrize("text", ["abc", "YWJj\n!", "ä", "****"])
def test_what_is_no_profile_of_krita_is_left_out_and_reported(text: str) -> None:
    kpl = next(f for f in FORMATS if f.name == "kpl")
    assert kpl.write is not None
    sound = (("kpl.profile:b.icc", "YWJj"), ("kpl.rows", "0"))
    own = Palette("p", columns=16, foreign=(("kpl.profile:a.icc", text), *sound))
    assert read_content(kpl.write(own), "a", kpl).palette.foreign == sound
    assert losses(own, kpl) == ("What another program's file said further of the palette is left out.",)
    assert losses(replace(own, foreign=sound), kpl) == ()


def test_more_colours_than_are_read_of_others_are_written_all_the_same(
    written: PaletteFormat, full: Palette, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("brdf_suite.files.palettes.collecting.MOST_COLOURS", len(full) - 1)
    path = tmp_path / f"a{written.endings[0]}"
    reported = write_palette(full, path, written).losses
    back = "BRDF Suite opens no file of this kind with more than 7 colours, so it cannot read this one back."
    if written.name == "brdfpalette":
        assert reported == ()
        assert len(read_palette(path).palette) == len(full)
    else:
        assert reported[-1] == back
        with pytest.raises(FileError, match="8 colours are more than the 7"):
            read_content(path.read_bytes(), path, written)
    monkeypatch.setattr("brdf_suite.files.palettes.collecting.MOST_COLOURS", len(full))
    assert back not in losses(full, written)


def test_a_palette_beyond_what_a_format_reads_is_refused_before_the_file(
    full: Palette, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("brdf_suite.files.palettes.collecting.MOST_COLOURS", len(full) - 1)
    monkeypatch.setattr("brdf_suite.files.hardened_xml.MOST_ELEMENTS", 40)
    with pytest.raises(
        SuiteError, match="8 entries are too many for CxF3: the file has more than 40 elements"
    ):
        write_palette(full, tmp_path / "a.cxf")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["scribus", "soc"])
def test_equal_and_missing_names_get_a_number_where_a_format_knows_colours_by_name(name: str) -> None:
    known = next(f for f in FORMATS if f.name == name)
    assert known.write is not None
    names = ("Red", "Red", "", "Red (2)", "Red")
    own = Palette(
        "p", tuple(Entry(FlatColour(name, "RGB", (0.2, 0.4, i / 5))) for i, name in enumerate(names))
    )
    back = read_content(known.write(own), "p", known).palette
    assert [entry.name for entry in back] == ["Red", "Red (3)", "Colour 3", "Red (2)", "Red (4)"]
    assert [entry.content.values for entry in back] == [entry.content.values for entry in own]
    found = losses(own, known, "p")
    assert [sentence for sentence in found if "names" in sentence] == [
        "The names of 3 entries got a number: each must be there, and be unique.",
    ]
    assert not any("names" in sentence for sentence in losses(back, known, "p"))
