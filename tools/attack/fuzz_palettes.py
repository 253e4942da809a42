"""Cut off palettes of every format at every byte, and damage them in many ways: no crash, no hang, no flood of memory.

    python tools/attack/fuzz_palettes.py [--mutations 100000] [--seed 0] [--formats ase aco …] [FILE...]

Without files, a small palette of each format is damaged, made here. Each mutation is read twice, by its content and by
the reader of the undamaged file's format. What may come out: a palette that can be written as one of this program's
own and read again, or a FileError that names a place. Each reading has 2 s and 4 times the file plus 200 MB of memory.
"""

from __future__ import annotations

import argparse
import plistlib
import random
import struct
import sys
import time
import warnings
import zipfile
from collections import Counter
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, Paint
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.documents.palette_store import encode_palette, palette_from_bytes
from brdf_suite.errors import FileError
from brdf_suite.files.palettes import FORMATS, read_content
from brdf_suite.files.palettes.archive.zipped import pack_zip
from brdf_suite.files.palettes.format import PaletteFormat

sys.path.insert(0, str(Path(__file__).parent))
import fuzz_measured

_SIZES = [0, 1, 2, 3, 0xFF, 0x100, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF]


def small_palette() -> Palette:
    """Something of everything, short: most damage then falls on structure."""
    metallic = Paint(
        "Silver",
        tuple(Measurement(45.0, angle, (120.0 - angle, 0.5, -1.5)) for angle in (15.0, 45.0, 110.0)),
        Gloss(92.0),
        Flakes(),
    )
    spectrum = FlatColour("s", "spectrum", (0.1, 0.2, 0.3, 0.4), wavelengths_nm=(400.0, 500.0, 600.0, 700.0))
    entries = (
        Entry(FlatColour("Red", "RGB", (1.0, 0.2, 0.4)), code="R1", tags=("a",), usage="global"),
        Entry(
            FlatColour("Ätna 藍", "CMYK", (1.0, 0.7, 0.1, 0.0)),
            group=("Inks",),
            usage="spot",
            date="2024-05-31",
        ),
        Entry(
            FlatColour("Lab", "Lab", (60.0, -30.5, 12.25), "", "D50", 2), group=("Inks", "Deep"), notes="n"
        ),
        Entry(FlatColour("Grey", "Gray", (0.25,))),
        Entry(spectrum, group=("Spectra",)),
        Entry(metallic, group=("Paints",)),
    )
    return Palette("Small", entries, (Group(("Empty",)),), "notes", "#aabbcc", 4)


_TABLE = (
    "Instrument;MA\nIlluminant;D65/10°\n\nName;L*-15;a*-15;b*-15;L*15;a*15;b*15;45as45 L*;45as45 a*;45as45 b*;Si15;G;"
    "G20\n"
    "Silver;130,5;0,1;-1,2;128,1;0,2;-1;61;0;-1,5;4,2;3,1;92\nSilver;130,4;0,1;-1,2;128;0,2;-1;61,1;0;-1,5;4,3;3;92\n"
    "Blue;40;1;-30;38;1;-28;20;2;-20;;;\n"
)
_TREE = (
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


def made_file(known: PaletteFormat) -> bytes:
    """The small palette in a format; by hand in those that are only read."""
    by_hand = {"table": _TABLE, "instrument": _TREE, "corel": _COREL, "autocad": _AUTOCAD, "scss": _SCSS}
    if known.name in by_hand:
        return by_hand[known.name].encode()
    if known.name in ("cpl", "clr"):
        return _cpl() if known.name == "cpl" else _clr()
    if known.name == "act":
        return bytes(range(256)) * 3 + struct.pack(">HH", 7, 2)
    if known.name == "acb":

        def text(value: str) -> bytes:
            return struct.pack(">I", len(value)) + value.encode("utf-16-be")

        head = (
            b"8BCB"
            + struct.pack(">HH", 1, 3000)
            + text("$$$/a/b=Book^R")
            + text("MB ")
            + text(" C")
            + text("Words")
        )
        rows = text("one") + b"000001" + bytes((128, 200, 60)) + text("") + b"      " + bytes(3)
        return head + struct.pack(">4H", 2, 7, 3, 7) + rows + b"spflspot"
    assert known.write is not None  # all others are written
    return known.write(small_palette())


def mutate(content: bytes, random_: random.Random) -> bytes:
    """Return damaged content; of a zip file most often a damaged part in a sound zip file."""
    if content.startswith(b"PK") and random_.random() < 0.7:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            parts = {name: archive.read(name) for name in archive.namelist()}
        name = random_.choice(list(parts))
        parts[name] = fuzz_measured.mutate(parts[name], random_)
        return pack_zip(parts, stored="mimetype")
    if random_.random() < 0.3 and len(content) > 8:
        # A count or a length, of two or four bytes in either order.
        at = random_.randrange(min(len(content) - 4, 200))
        number, width = random_.choice(_SIZES), random_.choice((2, 4))
        order = "big" if random_.random() < 0.7 else "little"
        return content[:at] + (number & (1 << 8 * width) - 1).to_bytes(width, order) + content[at + width :]  # type: ignore[arg-type]  # one of two words
    return fuzz_measured.mutate(content, random_)


def outcome(content: bytes, known: PaletteFormat | None) -> str:
    """Read and write again; return ``read`` or ``refused``, or what went wrong, beginning with ``FAULT``."""
    try:
        with fuzz_measured.limits(len(content)), warnings.catch_warnings():
            warnings.simplefilter("error")
            palette = read_content(content, "damaged", known).palette
            if palette_from_bytes(encode_palette(palette), "again") != palette:
                return "FAULT: what was read does not come back"
    except FileError as error:
        return "refused" if error.place else f"FAULT: no place in {error}"
    except fuzz_measured.TooLong:
        return f"FAULT: over {fuzz_measured.SECONDS} s"
    except MemoryError:
        return "FAULT: too much memory"
    except (Exception, RecursionError) as error:  # noqa: BLE001 - finding these is what this program is for
        return f"FAULT: {type(error).__name__}: {error}"[:300]
    return "read"


def fuzz(
    content: bytes,
    name: str,
    known: PaletteFormat,
    mutations: int,
    seed: int,
    keep: Path | None = None,
    *,
    cut: bool = False,
) -> tuple[Counter[str], float]:
    """Return the outcomes of all mutations of one file, and the longest reading in seconds.

    Faulty content is kept in ``keep``. With ``cut`` the file is first read cut off at every byte.
    """
    counts: Counter[str] = Counter()
    longest = 0.0
    outcome(content, known)  # imports and caches are not what is limited

    def take(damaged: bytes, reader: PaletteFormat | None, index: int) -> None:
        nonlocal longest
        start = time.perf_counter()
        result = outcome(damaged, reader)
        longest = max(longest, time.perf_counter() - start)
        counts[result] += 1
        if result.startswith("FAULT") and keep is not None:
            keep.mkdir(parents=True, exist_ok=True)
            (keep / f"{known.name}-{seed}-{index}").write_bytes(damaged)

    for size in range(len(content) if cut else 0):
        take(content[:size], known, -size)
    for index in range(mutations):
        damaged = mutate(content, random.Random(f"{seed} {name} {index}"))
        for reader in (None, known):
            take(damaged, reader, index)
    return counts, longest


def samples(files: list[Path], names: list[str]) -> list[tuple[str, bytes, PaletteFormat]]:
    """What is to be damaged: the files, or one of each format."""
    if files:
        contents = [(path.name, path.read_bytes()) for path in files]
        return [(name, content, read_content(content, name).format) for name, content in contents]
    return [(f"made.{f.name}", made_file(f), f) for f in FORMATS if not names or f.name in names]


def main(report: Callable[[str], None] = print) -> int:
    """Damage, read and report."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("--formats", nargs="*", default=[], choices=[known.name for known in FORMATS])
    parser.add_argument("--mutations", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=Path, help="folder for what made a fault")
    arguments = parser.parse_args()
    faults = 0
    for name, content, known in samples(arguments.files, arguments.formats):
        counts, longest = fuzz(
            content, name, known, arguments.mutations, arguments.seed, arguments.keep, cut=True
        )
        report(
            f"{name}: {arguments.mutations} mutations, each read twice, and {len(content)} beginnings:"
            f" {counts['read']} read, {counts['refused']} refused; the longest took {longest:.2f} s"
        )
        faults += fuzz_measured.reported(counts)
        sys.stdout.flush()
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
