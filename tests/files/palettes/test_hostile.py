"""Damaged and hostile palettes: a named error with a place, or a repair that is reported; never anything else."""

from __future__ import annotations

import io
import json
import math
import struct
import zipfile
from pathlib import Path

import pytest

from brdf_suite.errors import FileError
from brdf_suite.files.palettes import FORMATS, find_format, read_content, read_palette
from brdf_suite.files.palettes.collecting import MOST_COLOURS
from brdf_suite.files.palettes.format import PaletteFormat
from tools.attack.readers.palettes import made_file, reader_of
from tools.attack.readers.reader import outcome

NAMES = [known.name for known in FORMATS]


@pytest.fixture(params=FORMATS, ids=NAMES)
def known(request: pytest.FixtureRequest) -> PaletteFormat:
    found: PaletteFormat = request.param
    return found


def refused(content: bytes, name: str) -> FileError:
    """The error of a content read as a format; it must have a place."""
    with pytest.raises(FileError) as caught:
        read_content(content, "bad", find_format(name))
    assert caught.value.place
    assert "bad" in str(caught.value)
    return caught.value


def test_a_file_that_ends_anywhere_is_refused_or_read(known: PaletteFormat, tmp_path: Path) -> None:
    content = made_file(known)
    assert content is not None
    reader = reader_of(known)
    read, step = 0, max(1, len(content) // 800)  # every byte of all but the longest
    for size in range(0, len(content), step):
        path = tmp_path / f"cut{known.endings[0]}"
        path.write_bytes(content[:size])
        result = outcome(reader, path)
        assert result in ("read", "refused"), size
        read += result == "read"
    if known.name not in ("gpl", "css", "csv", "aco", "act", "acb", "hex", "table", "scss"):
        assert read <= 5, "but for white space at its end every part of such a file is needed"


def zipped(parts: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return buffer.getvalue()


def riff(count: int, reported: int | None = None) -> bytes:
    """The head of a RIFF palette of ``count`` colours with room for ``stated``."""
    size = 4 * (count if reported is None else reported) + 4
    return b"RIFF" + struct.pack("<I", size + 12) + b"PAL data" + struct.pack("<IHH", size, 0x300, count)


def ase(colour: bytes) -> bytes:
    """An ASE file of one colour without a name."""
    return b"ASEF" + struct.pack(">HHIHIHH", 1, 0, 1, 1, 4 + len(colour), 1, 0) + colour


KPL_INFINITE = zipped(
    {"colorset.xml": b'<ColorSet>\n<ColorSetEntry><RGB r="inf" g="0" b="0"/></ColorSetEntry></ColorSet>'}
)
SBZ_TWICE = zipped({"swatchbook.xml": b"<SwatchBook><materials><color/>\n<color/></materials></SwatchBook>"})
SBZ_CODE = zipped(
    {
        "swatchbook.xml": b'<SwatchBook><materials><color><values model="RGB">0 0 os.system</values></color>'
        b'</materials><book><swatch material=""/></book></SwatchBook>'
    }
)
CSV_NAN = b"name,L_15,a_15,b_15,L_45,a_45,b_45,L_75,a_75,b_75\nx,1,2,3,4,nan,6,7,8,9\n"
CXF_UNKNOWN = (
    b'<CxF xmlns="http://colorexchangeformat.com/CxF3-core"><Resources><ObjectCollection>\n'
    b'<Object Name="x" Id="a"><ColorValues><ColorCIELab ColorSpecification="no"><L>x</L></ColorCIELab>'
    b"</ColorValues></Object></ObjectCollection></Resources></CxF>"
)
AUTOCAD_LOCKED = b"<colorBook><colorPage><colorEntry><RGB8Encrypt/></colorEntry></colorPage></colorBook>"
BOMB = b"""<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]>"""


@pytest.mark.parametrize(
    ("name", "root", "part"),
    [
        ("soc", b"<color-table>&b;</color-table>", ""),
        ("scribus", b"<SCRIBUSCOLORS>&b;</SCRIBUSCOLORS>", ""),
        ("cxf", b'<CxF xmlns="http://colorexchangeformat.com/CxF3-core">&b;</CxF>', ""),
        ("corel", b"<palette><colors>&b;</colors></palette>", ""),
        ("autocad", b"<colorBook>&b;</colorBook>", ""),
        ("instrument", b"<Export Angle='15'><L>&b;</L></Export>", ""),
        ("kpl", b"<ColorSet>&b;</ColorSet>", "colorset.xml"),
        ("sbz", b"<SwatchBook>&b;</SwatchBook>", "swatchbook.xml"),
    ],
)
def test_entities_are_never_expanded(name: str, root: bytes, part: str) -> None:
    content = BOMB + root
    error = refused(zipped({part: content}) if part else content, name)
    assert "document type" in error.reason
    deep = b"<a>" * 100 + b"</a>" * 100
    assert "nested deeper" in refused(zipped({part: deep}) if part else deep, name).reason


def test_zip_files_unpack_within_bounds_and_write_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("brdf_suite.files.palettes.archive.zipped.LARGEST", 1 << 20)
    large = zipped({"colorset.xml": b" " * (2 << 20)})
    assert len(large) < 10_000
    assert "unpacks to more" in refused(large, "kpl").reason
    assert "more than 1,000 parts" in refused(zipped({f"{i}": b"" for i in range(1001)}), "kpl").reason
    assert "has no part" in refused(zipped({"other.xml": b""}), "sbz").reason
    evil = zipped(
        {"../../evil.icc": b"x", "/etc/evil": b"x", "colorset.xml": b'<ColorSet name="a" version="2.0"/>'}
    )
    palette, notes = find_format("kpl").read(evil, "evil.kpl")
    assert (len(palette), list(tmp_path.iterdir())) == (0, [])
    assert "2 parts of the file without colours are left out." in notes
    twice = io.BytesIO()
    with zipfile.ZipFile(twice, "w") as archive:
        archive.writestr("colorset.xml", b"<a/>")
        with pytest.warns(UserWarning, match="Duplicate name"):
            archive.writestr("colorset.xml", b"<b/>")
    assert "there twice" in refused(twice.getvalue(), "kpl").reason


@pytest.mark.parametrize("method", [zipfile.ZIP_LZMA, zipfile.ZIP_BZIP2])
def test_other_ways_of_packing_are_refused_by_name_however_damaged(method: int) -> None:
    part = b'<ColorSet name="a" version="2.0"/>' * 40
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", method) as archive:
        archive.writestr("colorset.xml", part)
    content = bytearray(buffer.getvalue())
    for spoilt in (None, 60):
        if spoilt is not None:
            content[spoilt : spoilt + 8] = bytes(8)
        error = refused(bytes(content), "kpl")
        assert f"({method})" in error.reason
        assert error.place == "part 'colorset.xml'"


LONG = "n" * 1_000_000
BLACK = {"red": 1 / 255, "green": 2 / 255, "blue": 3 / 255, "alpha": 1}
TINTS = f"{1 / 255!r},{2 / 255!r},{3 / 255!r}"


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("gpl", f"GIMP Palette\n1 2 3 {LONG}\n".encode()),
        ("soc", f'<color-table><color name="{LONG}" color="#010203"/></color-table>'.encode()),
        ("scribus", f'<SCRIBUSCOLORS><COLOR NAME="{LONG}" RGB="#010203"/></SCRIBUSCOLORS>'.encode()),
        ("css", f':root {{ --a: #010203; /* "{LONG[:150_000]}" */ }}'.encode()),
        ("json", json.dumps({LONG: "#010203"}).encode()),
        ("sketch", json.dumps({"colors": [{"name": LONG, **BLACK}]}).encode()),
        ("scss", f"${LONG}: #010203;".encode()),
        (
            "corel",
            f'<palette><colors><color cs="RGB" tints="{TINTS}" name="{LONG}"/></colors></palette>'.encode(),
        ),
        (
            "autocad",
            f"<colorBook><colorPage><colorEntry><colorName>{LONG}</colorName><RGB8><red>1</red><green>2</green>"
            "<blue>3</blue></RGB8></colorEntry></colorPage></colorBook>".encode(),
        ),
        ("aco", struct.pack(">HH5HI", 2, 1, 0, 257, 514, 771, 0, len(LONG)) + LONG.encode("utf-16-be")),
    ],
)
def test_names_of_a_million_characters_are_cut_and_reported(name: str, content: bytes) -> None:
    palette, notes = find_format(name).read(content, "long")
    assert len(palette.entries[0].name) == 1000
    assert any("1 name was cut" in note for note in notes)
    assert palette.entries[0].content.values == pytest.approx((1 / 255, 2 / 255, 3 / 255), abs=1e-4)


def test_a_cell_of_a_million_characters_is_refused() -> None:
    assert "field larger" in refused(f"name,L_45\n{LONG},3\n".encode(), "csv").reason
    document = {"format": "brdfpalette", "version": 2, "name": LONG}
    assert refused(json.dumps(document).encode(), "brdfpalette").place == "name"


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("gpl", b"GIMP Palette\n" + b"1 2 3\n" * (MOST_COLOURS + 10)),
        ("jasc", b"JASC-PAL\n0100\n1000000\n"),
        ("soc", b"<color-table>" + b'<color color="#000000"/>' * (MOST_COLOURS + 1) + b"</color-table>"),
        ("csv", b"name,L_45,a_45,b_45\n" + b"x,1,2,3\n" * (MOST_COLOURS + 1)),
        ("table", b"name,hex\n" + b"x,#010203\n" * (MOST_COLOURS + 1)),
        ("hex", b"#010203\n" * (MOST_COLOURS + 1)),
        ("sketch", b'{"colors":[' + b"{}," * MOST_COLOURS + b"{}]}"),
        ("scss", b"$m: (a: #000, b: hsl(20, 10%, 30%), c: darken(#000, 5%));" * (MOST_COLOURS // 2 + 1)),
        ("scss", b"$l: " + b"#000 " * (MOST_COLOURS + 1)),
        ("scss", b"$l: (" + b"#000, " * (MOST_COLOURS + 1) + b");"),
        ("scss", b"@a0: #000; " + b"".join(b"@a%d: @a%d;" % (i + 1, i) for i in range(MOST_COLOURS))),
        ("cpl", b"\xcc\xdc" + struct.pack("<H", 60_000) + bytes(800_000)),
        ("json", b"[" + b'"#000000",' * MOST_COLOURS + b'"#000000"]'),
        ("ase", b"ASEF" + struct.pack(">HHI", 1, 0, 1_000_000) + bytes(6_000_000)),
        ("aco", struct.pack(">HH", 1, 60_000) + bytes(600_000)),
        ("riff", riff(60_000) + bytes(240_000)),
    ],
)  # fmt: skip
def test_too_many_colours_are_refused(name: str, content: bytes) -> None:
    assert "colours are more than" in refused(content, name).reason


@pytest.mark.parametrize(
    ("name", "content", "place", "words"),
    [
        ("ase", b"ASEF" + struct.pack(">HHI", 1, 0, 5) + bytes(6), "byte 8", "5 blocks cannot lie"),
        ("ase", b"ASEF" + struct.pack(">HHIHI", 1, 0, 1, 1, 99), "byte 12", "beyond the end"),
        ("ase", ase(b"RGB " + struct.pack(">3fH", 0, math.nan, 0, 0)), "byte 30", "finite"),
        ("ase", ase(b"HSV " + bytes(14)), "byte 22", "'HSV '"),
        ("aco", struct.pack(">HH", 1, 3) + bytes(10), "byte 2", "3 colours of version 1"),
        ("aco", struct.pack(">HH5H", 1, 1, 3, 0, 0, 0, 0), "byte 4", "maker's own"),
        ("aco", struct.pack(">HH5HI", 2, 1, 0, 0, 0, 0, 0, 50) + bytes(4), "byte 14", "50 characters"),
        ("acb", b"8BCB" + struct.pack(">HHI", 1, 1, 1 << 31), "byte 8", "beyond the end"),
        ("riff", riff(9, 1) + bytes(4), "byte 22", "9 colours"),
        ("jasc", b"JASC-PAL\n0100\n3\n1 2 3\n", "line 5", "3 colours are said to follow, 1 do"),
        ("jasc", b"JASC-PAL\n0100\n1\n1 2 256\n", "line 4", "from 0 to 255"),
        ("act", bytes(769), "byte 769", "769 bytes"),
        ("act", bytes(768) + struct.pack(">HH", 999, 0), "byte 768", "999 colours"),
        ("gpl", b"GIMP Palette\n1 2\n", "line 2", "three numbers"),
        ("gpl", b"GIMP Palette\n1 2 3 \0\n", "byte 19", "NUL"),
        ("soc", b'<color-table>\n<color color="blue"/></color-table>', "line 2", "#336699"),
        ("scribus", b'<SCRIBUSCOLORS>\n<COLOR SPACE="RGB" R="nan" G="0" B="0"/></SCRIBUSCOLORS>', "line 2", "finite"),
        ("scribus", b'<SCRIBUSCOLORS><COLOR CMYK="#0011"/></SCRIBUSCOLORS>', "line 1", "4 bytes"),
        ("kpl", KPL_INFINITE, "colorset.xml, line 2", "finite"),
        ("sbz", SBZ_TWICE, "swatchbook.xml, line 2", "two materials"),
        ("sbz", SBZ_CODE, "swatchbook.xml, line 1", "finite"),
        ("csv", CSV_NAN, "line 2, column a_45", "finite"),
        ("csv", b"name,model,values\nx,RGB,0 1\n", "line 2", "3 numbers"),
        ("csv", b"name,model,values,observer_deg\nx,Lab,1 2 3,7\n", "line 2, column observer_deg", "nothing, not 7"),
        ("css", b":root {\n --a: #123; /* never ends", "line 2", "does not end"),
        ("scss", b"$a: darken(#123, 5%);\n", "line 1", "no variable that is a colour"),
        ("scss", b"@a: @b;\n@b: @a;", "line 1", "no variable that is a colour"),
        ("scss", b"$a: none;" * 100_001 + b"$b: #123;", "line 1", "more than 100,000 variables"),
        ("sketch", b'{"colors": [{"red": 1}]}', "colors[0]", "red, green and blue"),
        ("hex", b"#010203\nwords\n", "line 2", "expected a hex code"),
        ("hex", b"#01020304\n#05060708\n", "the codes", "nothing says whether"),
        ("cpl", b"\xcc\xdc\x09\0" + bytes(40), "byte 2", "9 colours cannot lie"),
        ("cpl", b"\xdd\xdc" + struct.pack("<I6I", 3, 0, 99_999, 1, 0, 2, 0), "byte 2", "beyond its end"),
        ("corel", b'<palette><colors>\n<color cs="RGB" tints="0,1"/></colors></palette>', "line 2", "3 numbers of RGB"),
        ("autocad", AUTOCAD_LOCKED, "line 1", "encrypted by the book's maker"),
        ("clr", b"\x04\x0bstreamtyped" + bytes(60), "byte 0", "of an old kind"),
        ("instrument", b"<Export><L>1</L></Export>", "line 1", "no element with a colour"),
        ("json", b'{"a": "#123456"', "line 1, column 16", "not valid JSON"),
        ("json", b'{"a": 3}', "the top level", "no colour"),
        ("scribus", b'<SCRIBUSCOLORS>\n<COLOR NAME="n" SPACE="x"/></SCRIBUSCOLORS>', "line 2", "RGB, CMYK or Lab"),
        ("cxf", CXF_UNKNOWN, "line 2", "not in the file"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named_with_its_place(name: str, content: bytes, place: str, words: str) -> None:
    error = refused(content, name)
    assert words in error.reason
    assert error.place == place


def test_repairs_are_reported() -> None:
    gpl = b"GIMP Palette\nName: \xe4\n300 -1 20\tl\xe4\tst\n"
    palette, notes = find_format("gpl").read(gpl, "a")
    assert palette.entries[0].content.values == (1.0, 0.0, 20 / 255)
    assert palette.entries[0].name == "lä st"
    assert len(notes) == 3
    assert any("Latin-1" in note for note in notes)
    ase = find_format("ase")
    assert ase.write is not None
    group = struct.pack(">HIH", 0xC001, 4, 1) + b"\0\0" + struct.pack(">HI", 0xC002, 0)
    twice = b"ASEF" + struct.pack(">HHI", 1, 0, 6) + group + group + struct.pack(">HIHI", 0xC002, 0, 0x77, 0)
    palette, notes = ase.read(twice, "a")
    assert [found.path for found in palette.groups] == [("",), (" (2)",)]
    assert len(notes) == 3
    jasc = b"JASC-PAL\r\n0100\r\n1\r\n1 2 3\r\n4 5 6\r\n"
    assert "1 line beyond the count" in find_format("jasc").read(jasc, "a")[1][0]


def test_tables_as_spreadsheets_and_people_leave_them_are_read() -> None:
    rows = b"a,Lab,1 2 3,D65,10.0,red;\nb,Lab,1 2 3,D65,2,red; red ;;deep\nc,Lab,1 2 3,,,\n"
    table = b"name,model,values,illuminant,observer_deg,tags\n" + rows
    palette, notes = find_format("csv").read(table, "a.csv")
    assert [entry.tags for entry in palette] == [("red",), ("red", "deep"), ()]
    assert [entry.content.observer_deg for entry in palette] == [10, 2, 0]
    assert notes == ("In 2 rows empty or repeated tags were left out.",)


def test_numbers_of_absurd_exponents_are_the_numbers_that_they_are_near() -> None:
    text = b'<SCRIBUSCOLORS><COLOR SPACE="CMYK" C="1e-99999999999999999999" M="100" Y="7" K="0"/></SCRIBUSCOLORS>'
    palette, _ = find_format("scribus").read(text, "a")
    assert palette.entries[0].content.values == (0.0, 1.0, 0.07, 0.0)


def test_files_that_cannot_be_read_are_reported(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="No such file"):
        read_palette(tmp_path / "none.ase")
    with pytest.raises(FileError, match="is a folder"):
        read_palette(tmp_path)
    empty = tmp_path / "empty.kpl"
    empty.write_bytes(b"")
    with pytest.raises(FileError, match="is empty"):
        read_palette(empty)
