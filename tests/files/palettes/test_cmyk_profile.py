"""Colours in CMYK through the profile of a press: made here, with colours that are known."""

from __future__ import annotations

import struct
import zipfile
from io import BytesIO
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_display
from brdf_suite.appearance.colour.flat_colours import display_notes, flat_labs
from brdf_suite.cli.main import main
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import FileError
from brdf_suite.files.palettes import find_format, read_palette, write_palette
from brdf_suite.files.palettes.conversions import convert_to_rgb8, labs_d50


def look(c: float, m: float, y: float, k: float) -> tuple[int, int, int]:
    """L*a*b* of full and missing inks on this press."""
    lightness = 100 - 30 * c - 35 * m - 8 * y
    return round(lightness * (1 - 0.8 * k)), round(-30 * c + 60 * m), round(-35 * c - 5 * m + 80 * y)


def press() -> bytes:
    """A profile of a press, ICC.1 version 2: a table of 8 bits with two steps for each ink."""

    def text(kind: bytes, value: bytes) -> bytes:
        if kind == b"desc":
            return (
                b"desc\0\0\0\0"
                + struct.pack(">I", len(value) + 1)
                + value
                + b"\0"
                + bytes(4 + 4 + 2 + 1 + 67)
            )
        return b"text\0\0\0\0" + value + b"\0"

    straight = bytes(range(256))
    corners = b""
    for inks in product((0, 1), repeat=4):
        lightness, a, b = look(*inks)
        corners += bytes((round(lightness * 2.55), a + 128, b + 128))
    unit = b"".join(struct.pack(">i", 65536 if i in (0, 4, 8) else 0) for i in range(9))
    table = b"mft1\0\0\0\0" + bytes((4, 3, 2, 0)) + unit + 4 * straight + corners + 3 * straight
    white = b"XYZ \0\0\0\0" + struct.pack(">3i", *(round(65536 * v) for v in (0.9642, 1.0, 0.8249)))
    tags = {
        b"desc": text(b"desc", b"Press 7"), b"cprt": text(b"text", b"none"), b"wtpt": white, b"A2B0": table,
        b"A2B1": table,
    }  # fmt: skip
    start, entries, data = 132 + 12 * len(tags), b"", b""
    for name, content in tags.items():
        entries += struct.pack(">4sII", name, start + len(data), len(content))
        data += content + b"\0" * (-len(content) % 4)
    head = struct.pack(
        ">I4sI4s4s4s6H4s4sI4s4sQI3i48x", start + len(data), b"\0\0\0\0", 0x02400000, b"prtr", b"CMYK", b"Lab ",
        *(2026, 1, 1, 0, 0, 0), b"acsp", b"\0\0\0\0", 0, b"\0\0\0\0", b"\0\0\0\0", 0, 0,
        *(round(65536 * v) for v in (0.9642, 1.0, 0.8249)),
    )  # fmt: skip
    return head + struct.pack(">I", len(tags)) + entries + data


INKS = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 1.0, 0.0), (0.0, 0.0, 0.0, 0.0), (1.0, 1.0, 0.0, 1.0))


@pytest.fixture
def profile(tmp_path: Path) -> Path:
    path = tmp_path / "press.icc"
    path.write_bytes(press())
    return path


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "inks.ase"
    write_palette(
        Palette("p", tuple(Entry(FlatColour(str(i), "CMYK", row)) for i, row in enumerate(INKS))), path
    )
    return path


def test_inks_look_as_the_profile_says_and_keep_their_numbers(file: Path, profile: Path) -> None:
    read = read_palette(file, cmyk_profile=profile)
    colours = [entry.content for entry in read.palette if isinstance(entry.content, FlatColour)]
    assert [colour.values for colour in colours] == list(INKS)
    shown = labs_d50(flat_labs(colours))
    assert np.abs(shown - [look(*row) for row in INKS]).max() < 0.6
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


def test_a_profile_in_a_file_is_used_for_the_colours_that_name_it(tmp_path: Path) -> None:
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
        archive.writestr("a.icc", press())
    path = tmp_path / "a.kpl"
    path.write_bytes(buffer.getvalue())
    read = read_palette(path)
    colours = [entry.content for entry in read.palette if isinstance(entry.content, FlatColour)]
    assert [len(colour.others) for colour in colours] == [0, 1, 1, 1]
    assert np.abs(labs_d50(flat_labs(colours[1:])) - [look(*row) for row in INKS[1:]]).max() < 0.6
    assert "3 CMYK colours are shown through the profile in the file" in " ".join(read.notes)
    # The profile goes along, so nothing is lost.
    again = tmp_path / "b.kpl"
    assert write_palette(read.palette, again, find_format("kpl")).losses == ()
    assert read_palette(again).palette == read.palette


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"no profile", "no ICC profile of a device in CMYK"),
        (press()[:16] + b"RGB " + press()[20:], "no ICC profile of a device in CMYK"),
        (press()[:400], "no profile that can be used"),
    ],
)
def test_other_profiles_are_refused_by_name(file: Path, tmp_path: Path, content: bytes, reason: str) -> None:
    path = tmp_path / "bad.icc"
    path.write_bytes(content)
    with pytest.raises(FileError, match=reason) as caught:
        read_palette(file, cmyk_profile=path)
    assert "bad.icc" in str(caught.value)
