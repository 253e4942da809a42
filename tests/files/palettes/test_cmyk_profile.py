"""Colours in CMYK through the profile of a press: made here, with colours that are known."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from PIL import Image

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_display
from brdf_suite.appearance.colour.flat_colours import display_notes, flat_labs
from brdf_suite.arrays import Floats
from brdf_suite.cli.main import main
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import FileError
from brdf_suite.files.palettes import find_format, read_palette, write_palette
from brdf_suite.files.palettes.conversions import convert_to_rgb8, labs_d50
from brdf_suite.reports.contact_sheet.document import sheet_items

INKS = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 1.0, 0.0), (0.0, 0.0, 0.0, 0.0), (1.0, 1.0, 0.0, 1.0))


@pytest.fixture
def profile(tmp_path: Path, press_profile: ModuleType) -> Path:
    path = tmp_path / "press.icc"
    path.write_bytes(press_profile.press())
    return path


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "inks.ase"
    write_palette(
        Palette("p", tuple(Entry(FlatColour(str(i), "CMYK", row)) for i, row in enumerate(INKS))), path
    )
    return path


def test_inks_look_as_the_profile_says_and_keep_their_numbers(
    file: Path, profile: Path, press_profile: ModuleType
) -> None:
    read = read_palette(file, cmyk_profile=profile)
    colours = [entry.content for entry in read.palette if isinstance(entry.content, FlatColour)]
    assert [colour.values for colour in colours] == list(INKS)
    shown = labs_d50(flat_labs(colours))
    assert np.abs(shown - [press_profile.look(*row) for row in INKS]).max() < 0.6
    assert read.notes == (
        "4 CMYK colours are shown through the profile press.icc; the numbers of the inks are kept as they are.",
    )
    assert display_notes(colours) == ()
    plain = [entry.content for entry in read_palette(file).palette if isinstance(entry.content, FlatColour)]
    assert "without a profile" in display_notes(plain)[0]
    # What becomes RGB is what is shown.
    wanted = np.rint(255 * np.clip(working_to_display(lab_to_working(flat_labs(colours[1:2])[0])), 0, 1))
    assert convert_to_rgb8(Entry(colours[1])) == tuple(wanted.astype(int))


def test_the_command_takes_a_profile(file: Path, profile: Path, tmp_path: Path) -> None:
    plain, through = tmp_path / "plain.hex", tmp_path / "through.hex"
    assert main(["palette", "convert", str(file), "-o", str(plain)]) == 0
    assert main(["palette", "convert", str(file), "-o", str(through), "--cmyk-profile", str(profile)]) == 0
    assert plain.read_text().splitlines()[0] == "#00ffff 0"
    assert through.read_text().splitlines()[0] != "#00ffff 0"
    again = tmp_path / "again.ase"
    assert main(["palette", "convert", str(file), "-o", str(again), "--cmyk-profile", str(profile)]) == 0
    assert again.read_bytes() == file.read_bytes()


def test_find_and_sheet_take_a_profile(
    file: Path, profile: Path, press_profile: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    solid = tmp_path / "cyan.brdfpaint"
    lab = flat_labs(
        [FlatColour("", "Lab", press_profile.look(1, 0, 0, 0), illuminant="D50", observer_deg=2)]
    )[0]
    save_paint(solid_paint("Cyan of the press", tuple(lab)), solid)
    differences = []
    for words in ([], ["--cmyk-profile", str(profile)]):
        assert main(["palette", "find", str(solid), "--in", str(file), "--count", "1", "--json", *words]) == 0
        made = json.loads(capsys.readouterr().out)
        differences.append(made["found"][0]["delta_e_2000"])
    assert differences[1] < 1.0 < differences[0]
    assert "through the profile press.icc" in " ".join(made["messages"])
    entry = f"{file}#{read_palette(file).palette.entries[0].id}"
    words = ["--count", "1", "--json", "--cmyk-profile", str(profile)]
    assert main(["palette", "find", entry, "--in", str(file), *words]) == 0
    assert json.loads(capsys.readouterr().out)["found"][0]["delta_e_2000"] < 1e-6
    sheets = []
    through = ["--cmyk-profile", str(profile)]
    for name, source, more in (
        ("plain.png", str(file), []),
        ("seen.png", str(file), through),
        ("plain_entry.png", entry, []),
        ("seen_entry.png", entry, through),
    ):
        out = tmp_path / name
        words = ["--form", "chips", "--columns", "1", "--size", "60x40"]
        assert main(["sheet", source, "-o", str(out), *words, *more]) == 0
        with Image.open(out) as sheet:
            sheets.append(np.asarray(sheet.convert("RGB")).astype(int))
    seen = display_rgb(lab)
    rows = [np.abs(sheet - seen).max(axis=-1).min(axis=1) for sheet in sheets]
    assert [bool((row <= 2).any()) for row in rows] == [False, True, False, True]
    with pytest.raises(FileError, match=r"no ICC profile"):
        sheet_items(file, cmyk_profile=file)


def display_rgb(lab: Floats) -> Floats:
    return np.rint(255 * np.clip(working_to_display(lab_to_working(lab)), 0, 1))


def test_a_profile_in_a_file_is_used_for_the_colours_that_name_it(
    tmp_path: Path, press_profile: ModuleType
) -> None:
    xml = '<ColorSet version="2.0" name="p" columns="2" rows="2">' + "".join(
        f'<ColorSetEntry name="{i}" id="" spot="false" bitdepth="U8"><CMYK c="{c}" m="{m}" y="{y}" k="{k}" '
        f'space="{"Press 7" if i else "other"}"/></ColorSetEntry>'
        for i, (c, m, y, k) in enumerate(INKS)
    )
    names = '<Profiles><Profile filename="a.icc" name="Press 7" colorModelId="CMYKA" colorDepthId="U8"/></Profiles>'
    buffer = BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr("mimetype", "krita/x-colorset")
        archive.writestr("colorset.xml", xml + "</ColorSet>")
        archive.writestr("profiles.xml", names)
        archive.writestr("a.icc", press_profile.press())
    path = tmp_path / "a.kpl"
    path.write_bytes(buffer.getvalue())
    read = read_palette(path)
    colours = [entry.content for entry in read.palette if isinstance(entry.content, FlatColour)]
    assert [len(colour.others) for colour in colours] == [0, 1, 1, 1]
    assert (
        np.abs(labs_d50(flat_labs(colours[1:])) - [press_profile.look(*row) for row in INKS[1:]]).max() < 0.6
    )
    assert "3 CMYK colours are shown through the profile in the file" in " ".join(read.notes)
    # The profile goes along, so nothing is lost.
    again = tmp_path / "b.kpl"
    assert write_palette(read.palette, again, find_format("kpl")).losses == ()
    assert read_palette(again).palette == read.palette


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda _press: b"no profile", "no ICC profile of a device in CMYK"),
        (lambda press: press[:16] + b"RGB " + press[20:], "no ICC profile of a device in CMYK"),
        (lambda press: press[:400], "no profile that can be used"),
    ],
)
def test_other_profiles_are_refused_by_name(
    file: Path, tmp_path: Path, press_profile: ModuleType, change: Callable[[bytes], bytes], reason: str
) -> None:
    path = tmp_path / "bad.icc"
    path.write_bytes(change(press_profile.press()))
    with pytest.raises(FileError, match=reason) as caught:
        read_palette(file, cmyk_profile=path)
    assert "bad.icc" in str(caught.value)
