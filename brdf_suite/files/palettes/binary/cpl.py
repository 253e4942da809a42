"""CPL (CorelDRAW 7 to X4), read only: colours in the model of their own, with names.

The first two bytes say which of seven kinds it is (``CC DC`` and ``CC BC``: version 7, ``DC DC``: 8 to 11, ``CD DC``:
10, ``CD BC`` and ``DD DC``: 12 to X4, ``CD DD``: X4). Kinds from 10 on begin with a table of places: 0 the name, 1 the
kind of palette, 2 the count of colours, 5 columns and rows. A colour is its model (u16), ten bytes of which the last
four are the numbers, and a name (u8 characters, in UTF-16 or Latin-1 by the kind). In palettes of inks a number of four
bytes goes before it and a second model follows. All numbers are little-endian. Layout from the readers of SwatchBooker
and of UniConvertor. Those two disagree on whether a grey of 255 is white; it is white here, and the notice says so.
"""

from __future__ import annotations

import struct

from brdf_suite.documents.flat_colour import Model
from brdf_suite.documents.palette import Palette, Usage
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.binary.byte_cursor import ByteCursor
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.format import PaletteFormat

_KINDS = {
    b"\xcc\xdc": "7", b"\xcc\xbc": "7 wide", b"\xdc\xdc": "8", b"\xcd\xdc": "10", b"\xcd\xbc": "12 inks",
    b"\xdd\xdc": "12", b"\xcd\xdd": "X4 inks",
}  # fmt: skip
_NARROW = ("7", "8", "10")
_OF_INKS = (3, 8, 9, 10, 11, *range(16, 19), *range(20, 24), *range(26, 33), 35, 36, 37)
"""Kinds of palettes of a maker's inks."""
_ENDS_INKS = 38
_EMPTY = ("NONASSIGNED", "UNASSIGNED")
_LEAST_RECORD = 13


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a CPL file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    cursor, collector = ByteCursor(content, path), Collector(path)
    kind = _KINDS.get(cursor.take(2, "the signature"), "")
    if not kind:
        raise cursor.fail("does not begin as a CorelDRAW palette", 0)
    name, columns, sort = "", 0, -1
    if kind == "8":
        name = _text(cursor, wide=False, what="the palette's name")
    elif not kind.startswith("7"):
        name, sort, columns = _head(cursor, kind)
    at = cursor.at
    count = _u16(cursor, "the count of colours")
    inks = kind in ("10", "12 inks", "X4 inks") and 0 <= sort < _ENDS_INKS and sort not in (5, 16)
    if count * _LEAST_RECORD > cursor.left:
        raise cursor.fail(f"{count:,} colours cannot lie in the {cursor.left:,} bytes that follow", at)
    collector.check_count(count, f"byte {at}")
    usage: Usage = "spot" if sort in _OF_INKS else "process"
    wide = kind not in _NARROW or (kind == "10" and sort == 16)
    for _ in range(count):
        _read_colour(cursor, collector, inks=inks, wide=wide, rows=kind == "X4 inks", usage=usage)
    if cursor.left:
        collector.note("The bytes behind the last colour are skipped.")
    return collector.finish(name, columns=columns)


def _head(cursor: ByteCursor, kind: str) -> tuple[str, int, int]:
    """Return the name, the kind of palette and the columns; the cursor stands at the count of colours then."""
    start = cursor.at
    (size,) = struct.unpack("<I", cursor.take(4, "the count of headers"))
    if not 3 <= size <= 64:
        raise cursor.fail(f"expected 3 to 64 headers, not {size:,}", start)
    places = dict(struct.unpack("<2I", cursor.take(8, "a header")) for _ in range(size))
    for wanted in (0, 1, 2):
        if not 0 < places.get(wanted, 0) < len(cursor.content):
            raise cursor.fail(f"has no header {wanted}, or one beyond its end", start)
    cursor.at = places[0]
    name = _text(cursor, wide=kind != "10", what="the palette's name")
    cursor.at = places[1]
    sort = _u16(cursor, "the kind of palette")
    columns = 0
    if 0 < places.get(5, 0) < len(cursor.content):
        cursor.at = places[5]
        columns = _u16(cursor, "the columns")
    cursor.at = places[2]
    return name, sort, columns if columns < 1000 else 0


def _read_colour(
    cursor: ByteCursor, collector: Collector, *, inks: bool, wide: bool, rows: bool, usage: Usage
) -> None:
    start = cursor.at
    number = struct.unpack("<I", cursor.take(4, "a colour's number"))[0] if inks else 0
    found = [_values(*struct.unpack("<H6x4s", cursor.take(12, "a colour"))) for _ in range(2 if inks else 1)]
    name = _text(cursor, wide=wide, what="a name")
    if rows:
        cursor.take(12, "a colour's place")
    if any(word in name for word in _EMPTY):
        collector.note("{n} empty slot[|s] skipped.")
        return
    known = [one for one in found if one is not None]
    if not known:
        collector.note(
            "{n} colour[|s] in a model that is not known here (YIQ, Hexachrome, registration) skipped."
        )
        return
    place = f"byte {start}"
    colours = []
    for model, values in known[:1] if known[0] == known[-1] else known:
        white = {"illuminant": "D50", "observer_deg": 2} if model == "Lab" else {}
        colours.append(collector.colour(place, "", model, values, **white))
        if model == "Gray":
            collector.note("A grey of 255 is taken for white, on which readers of this format disagree.")
    first = colours[0]
    label = collector.name(name)
    whole = collector.colour(
        place, label, first.model, first.values, illuminant=first.illuminant, observer_deg=first.observer_deg,
        others=tuple(colours[1:]),
    )  # fmt: skip
    collector.add(place, whole, code=str(number) if number else "", usage=usage)


def _values(model: int, raw: bytes) -> tuple[Model, tuple[float, ...]] | None:
    """Return a colour of four bytes as a model and its numbers; None for a model that has no place here."""
    if model == 2:
        return "CMYK", tuple(min(byte, 100) / 100.0 for byte in raw)
    if model in (3, 17):
        return "CMYK", tuple(byte / 255.0 for byte in raw)
    if model == 4:
        return "CMY", tuple(byte / 255.0 for byte in raw[:3])
    if model in (5, 21):
        return "RGB", tuple(byte / 255.0 for byte in raw[2::-1])
    if model in (6, 7):
        hue = float(min(raw[0] + 256 * raw[1], 360))
        second, third = raw[2] / 255.0, raw[3] / 255.0
        return ("HSB", (hue, second, third)) if model == 6 else ("HSL", (hue, third, second))
    if model == 9:
        return "Gray", (raw[0] / 255.0,)
    if model == 12:
        signed = struct.unpack("2b", raw[1:3])
        return "Lab", (raw[0] * 100.0 / 255.0, float(signed[0]), float(signed[1]))
    if model == 18:
        return "Lab", (raw[0] * 100.0 / 255.0, raw[1] - 128.0, raw[2] - 128.0)
    return None


def _u16(cursor: ByteCursor, what: str) -> int:
    return int.from_bytes(cursor.take(2, what), "little")


def _text(cursor: ByteCursor, *, wide: bool, what: str) -> str:
    length = cursor.take(1, f"the length of {what}")[0]
    raw = cursor.take(2 * length if wide else length, what)
    return raw.decode("utf-16-le", "replace") if wide else raw.decode("latin-1")


FORMAT = PaletteFormat(
    name="cpl",
    title="CorelDRAW palette (CPL)",
    endings=(".cpl",),
    models=("RGB", "CMYK", "CMY", "Gray", "HSB", "HSL", "Lab"),
    holds="Read only. Names, numbers of inks, RGB, CMYK, Lab, HSB, HSL, CMY and grey in 8 bits, columns.",
    sniff=lambda head, size: head[:2] in _KINDS and size > 4 and _is_likely(head),
    read=read,
)


def _is_likely(head: bytes) -> bool:
    """Return whether what follows the two bytes of the signature fits it."""
    kind = _KINDS[head[:2]]
    if kind.startswith("7") or kind == "8":
        at = 2 if kind != "8" else 3 + (head[2] if len(head) > 2 else 0)
        return len(head) >= at + 4 and head[at + 2] <= 21 and head[at + 3] == 0
    return len(head) >= 30 and 3 <= int.from_bytes(head[2:6], "little") <= 64
