"""Palettes: every registered format, a small palette in each, by content and by the format's own reader."""

from __future__ import annotations

import plistlib
import struct
from pathlib import Path

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, Paint
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.documents.palette_store import encode_palette, palette_from_bytes
from brdf_suite.files.palettes import FORMATS, read_content, read_palette
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.regular_files import read_bytes
from tools.attack.readers.reader import Reader, WrongValueError


def small_palette() -> Palette:
    """Something of everything, short: most damage then falls on structure."""
    metallic = Paint(
        "Silver",
        tuple(Measurement(45.0, angle, (120.0 - angle, 0.5, -1.5)) for angle in (15.0, 45.0, 110.0)),
        Gloss(92.0),
        Flakes(),
    )
    spectrum = FlatColour("s", "spectrum", (0.1, 0.2, 0.3, 0.4), wavelengths_nm=(400.0, 500.0, 600.0, 700.0))
    ink, lab = (1.0, 0.7, 0.1, 0.0), (60.0, -30.5, 12.25)
    entries = (
        Entry(FlatColour("Red", "RGB", (1.0, 0.2, 0.4)), code="R1", tags=("a",), usage="global"),
        Entry(FlatColour("Ätna 藍", "CMYK", ink), group=("Inks",), usage="spot", date="2024-05-31"),
        Entry(FlatColour("Lab", "Lab", lab, "", "D50", 2), group=("Inks", "Deep"), notes="n"),
        Entry(FlatColour("Grey", "Gray", (0.25,))),
        Entry(spectrum, group=("Spectra",)),
        Entry(metallic, group=("Paints",)),
    )
    return Palette("Small", entries, (Group(("Empty",)),), "notes", "#aabbcc", 4)


TABLE = (
    "Instrument;MA\nIlluminant;D65/10°\n\nName;L*-15;a*-15;b*-15;L*15;a*15;b*15;45as45 L*;45as45 a*;45as45 b*;Si15;G;"
    "G20\n"
    "Silver;130,5;0,1;-1,2;128,1;0,2;-1;61;0;-1,5;4,2;3,1;92\nSilver;130,4;0,1;-1,2;128;0,2;-1;61,1;0;-1,5;4,3;3;92\n"
    "Blue;40;1;-30;38;1;-28;20;2;-20;;;\n"
)
TREE = (
    '<Export><Illuminant>D65</Illuminant><Sample Name="Silver"><Reading Geometry="45as15"><L>120</L><a>1</a><b>2</b>'
    '</Reading><Angle value="45"><Lab L="60" a="0" b="1"/></Angle><Angle value="110"><Spectrum start="400" step="50">'
    "0.1 0.1 0.2 0.1 0.1 0.1 0.1</Spectrum></Angle><Graininess>3.2</Graininess></Sample></Export>"
)
_COREL = (
    '<palette name="Season" resid="2"><colorspaces><cs name="Ink"><color cs="CMYK" tints="0,1,1,0"/><color cs="LAB" '
    'tints="0.5,0.6,0.4"/></cs></colorspaces><colors><page width="3"><color cs="RGB" tints="0.1,0.7,0.6" name="A"/>'
    '<color cs="Ink" tints="1"/><color cs="Gray" tints="0.5" resid="1"/></page></colors><localization><resource id="1">'
    "<EN>Grey</EN></resource></localization></palette>"
)
_AUTOCAD = (
    "<colorBook><bookName>Season</bookName><colorPage><colorEntry><colorName>A</colorName><RGB8><red>208</red>"
    "<green>94</green><blue>52</blue></RGB8></colorEntry><colorEntry><colorName>B</colorName><RGB8Encrypt><encrypt>x"
    "</encrypt></RGB8Encrypt></colorEntry></colorPage></colorBook>"
)
_SCSS = (
    '$red: #d40000 !default; // of 2026\n$alias: $red;\n@night: rgba(1, 2, 3, 0.5);\n/* maps */\n$map: ("a": #fff, b: '
    "(c: hsl(20, 10%, 30%), d: darken($red, 5%)));\n"
)


def _cpl() -> bytes:
    """A palette of inks of CorelDRAW 12."""
    name = bytes([2]) + "Ab".encode("utf-16-le")
    head = b"\xcd\xbc" + struct.pack("<I6I", 3, 0, 30, 1, 35, 2, 37) + name + struct.pack("<2H", 3, 2)
    first = struct.pack("<IH6x4BH6x4B", 7, 5, 1, 2, 3, 0, 2, 10, 20, 30, 40)
    second = struct.pack("<IH6x4BH6x4B", 8, 18, 100, 130, 120, 0, 6, 90, 0, 120, 130)
    return head + first + name + second + name


def _clr() -> bytes:
    """A colour list of macOS."""
    uid = plistlib.UID
    colour = {"NSColorSpace": 1, "NSRGB": b"0.1 0.2 0.3\0", "NSComponents": b"0.1 0.2 0.3 1"}
    colour |= {"NSCustomColorSpace": uid(7)}
    objects = ["$null", {"NS.objects": [uid(2), uid(3)]}, "red", "grey", {"NS.objects": [uid(5), uid(6)]}, colour,
               {"NSColorSpace": 3, "NSWhite": b"0.5 0.5"}, {"NSID": 7}]  # fmt: skip
    top = {"NSColors": uid(4), "NSKeys": uid(1)}
    return plistlib.dumps({"$objects": objects, "$top": top, "$version": 1}, fmt=plistlib.FMT_BINARY)


def _acb() -> bytes:
    def text(value: str) -> bytes:
        return struct.pack(">I", len(value)) + value.encode("utf-16-be")

    words = (text("$$$/a/b=Book^R"), text("MB "), text(" C"), text("Words"))
    rows = text("one") + b"000001" + bytes((128, 200, 60)) + text("") + b"      " + bytes(3)
    head = b"8BCB" + struct.pack(">HH", 1, 3000) + b"".join(words)
    return head + struct.pack(">4H", 2, 7, 3, 7) + rows + b"spflspot"


_BY_HAND = {
    "table": TABLE.encode(),
    "instrument": TREE.encode(),
    "corel": _COREL.encode(),
    "autocad": _AUTOCAD.encode(),
    "scss": _SCSS.encode(),
    "cpl": _cpl(),
    "clr": _clr(),
    "acb": _acb(),
    "act": bytes(range(256)) * 3 + struct.pack(">HH", 7, 2),
}


def made_file(known: PaletteFormat) -> bytes | None:
    """Return the small palette in a format, by hand in those that are only read; None where neither is possible."""
    if known.name in _BY_HAND:
        return _BY_HAND[known.name]
    return None if known.write is None else known.write(small_palette())


def reader_of(known: PaletteFormat) -> Reader:
    """Return the reader of a format: what is read by content or by the format comes back from our own format."""

    def read(path: Path) -> None:
        palette = read_content(read_bytes(path), path, known).palette
        if palette_from_bytes(encode_palette(palette), "again") != palette:
            raise WrongValueError("what was read does not come back")
        read_palette(path)

    def make(folder: Path) -> list[Path]:
        content = made_file(known)
        if content is None:
            return []
        path = folder / f"made{known.endings[0]}"
        path.write_bytes(content)
        return [path]

    return Reader(f"palette:{known.name}", read, make, has_place=True)


READERS = [reader_of(known) for known in FORMATS]
