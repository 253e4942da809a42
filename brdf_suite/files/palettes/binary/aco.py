"""ACO (Photoshop colour swatches), versions 1 and 2: sixteen-bit numbers, big-endian.

A version, a count, and so many colours of five words each: the space and four values. In a section of version 2 a
name follows each colour. Files hold version 1 alone, version 2 alone, or most often both, the second with the names
of the first.
"""

from __future__ import annotations

import struct
from collections.abc import Callable

from brdf_suite.documents.flat_colour import Model
from brdf_suite.documents.palette import Entry, Foreign, Palette
from brdf_suite.errors import PathLike, SuiteError
from brdf_suite.files.palettes.binary.byte_cursor import ByteCursor, packed_utf16
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import convert_to_plain
from brdf_suite.files.palettes.format import PaletteFormat

_FULL = 65_535.0
_RGB, _HSB, _CMYK, _LAB, _GRAY, _WIDE_CMYK = 0, 1, 2, 7, 8, 9
_SPACE, _VERSIONS = "aco.space", "aco.versions"
_Words = tuple[int, ...]


def _signed(word: int) -> int:
    return word - 0x10000 if word >= 0x8000 else word


_READ: dict[int, tuple[Model, Callable[[_Words], tuple[float, ...]]]] = {
    _RGB: ("RGB", lambda w: (w[0] / _FULL, w[1] / _FULL, w[2] / _FULL)),
    _HSB: ("HSB", lambda w: (w[0] / _FULL * 360.0, w[1] / _FULL, w[2] / _FULL)),
    # 0 is full ink.
    _CMYK: (
        "CMYK",
        lambda w: (1.0 - w[0] / _FULL, 1.0 - w[1] / _FULL, 1.0 - w[2] / _FULL, 1.0 - w[3] / _FULL),
    ),
    _LAB: ("Lab", lambda w: (w[0] / 100.0, _signed(w[1]) / 100.0, _signed(w[2]) / 100.0)),
    _GRAY: ("Gray", lambda w: (w[0] / 10_000.0,)),
    _WIDE_CMYK: ("CMYK", lambda w: (w[0] / 10_000.0, w[1] / 10_000.0, w[2] / 10_000.0, w[3] / 10_000.0)),
}


def _word(value: float, scale: float, low: float = 0.0, high: float = _FULL) -> int:
    return round(min(high, max(low, value * scale))) & 0xFFFF


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of an ACO file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    cursor, collector = ByteCursor(content, path), Collector(path)
    sections: dict[int, list[tuple[int, _Words, str]]] = {}
    if not content:
        raise cursor.fail("is empty")
    while cursor.left:
        start = cursor.at
        if sections and cursor.left < 4:
            collector.note(f"{cursor.left} bytes behind the last colour are skipped.")
            break
        version = cursor.u16("the version")
        if version not in (1, 2) or version in sections:
            if sections:
                collector.note(f"{len(content) - start:,} bytes behind the last colour are skipped.")
                break
            raise cursor.fail(f"version {version} is not known; 1 and 2 are", start)
        count = cursor.u16("the count of colours")
        collector.check_count(count, f"byte {start + 2}")
        least = 10 if version == 1 else 14
        if least * count > cursor.left:
            raise cursor.fail(
                f"{count:,} colours of version {version} cannot lie in the {cursor.left:,} bytes that follow",
                start + 2,
            )
        sections[version] = [
            (cursor.at, cursor.words(5, "a colour"), cursor.counted_utf16("a name") if version == 2 else "")
            for _ in range(count)
        ]
    if len({tuple(words for _, words, _ in records) for records in sections.values()}) > 1:
        collector.note("The colours of version 1 and 2 in the file differ; those of version 2 count.")
    for at, words, name in sections[max(sections)]:
        _add(collector, at, words, name)
    versions = " ".join(str(version) for version in sections)
    return collector.finish(foreign=() if versions == "1 2" else ((_VERSIONS, versions),))


def _add(collector: Collector, at: int, words: _Words, name: str) -> None:
    space = words[0]
    if space not in _READ:
        raise collector.fail(
            f"the colour space {space} is a maker's own, without numbers that anyone else can read",
            f"byte {at}",
        )
    model, convert = _READ[space]
    white = {"illuminant": "D50", "observer_deg": 2} if model == "Lab" else {}
    colour = collector.colour(f"byte {at}", collector.name(name), model, convert(words[1:]), **white)
    foreign: Foreign = ((_SPACE, str(space)),) if space == _WIDE_CMYK else ()
    collector.add(f"byte {at}", colour, foreign=foreign)


def write(palette: Palette) -> bytes:
    """Return the content of an ACO file: both versions, or those that the file had that the palette came from.

    Raises :class:`SuiteError`: it has more than 65,535 entries.
    """
    entries = palette.entries
    if len(entries) > 0xFFFF:
        raise SuiteError(f"An ACO file holds 65,535 colours, and the palette has {len(entries):,}.")
    versions = dict(palette.foreign).get(_VERSIONS, "1 2").split()
    if any(entry.name for entry in entries) and "2" not in versions:
        versions = ["1", "2"]  # names have come that version 1 cannot hold
    colours = [_packed(entry) for entry in entries]
    content = b""
    if "1" in versions:
        content += struct.pack(">HH", 1, len(entries)) + b"".join(colours)
    if "2" in versions:
        content += struct.pack(">HH", 2, len(entries))
        for entry, colour in zip(entries, colours, strict=True):
            text = packed_utf16(entry.name)
            content += colour + struct.pack(">I", len(text) // 2) + text
    return content


def _packed(entry: Entry) -> bytes:
    colour = convert_to_plain(entry, ("RGB", "HSB", "CMYK", "Lab", "Gray"))
    v, wide = colour.values, (_SPACE, str(_WIDE_CMYK)) in entry.foreign
    words: tuple[int, ...]
    if colour.model == "RGB":
        space, words = _RGB, (*(_word(x, _FULL) for x in v), 0)
    elif colour.model == "HSB":
        space, words = _HSB, (_word(v[0], _FULL / 360.0), _word(v[1], _FULL), _word(v[2], _FULL), 0)
    elif colour.model == "CMYK" and wide:
        space, words = _WIDE_CMYK, tuple(_word(x, 10_000.0) for x in v)
    elif colour.model == "CMYK":
        space, words = _CMYK, tuple(_word(1.0 - x, _FULL) for x in v)
    elif colour.model == "Lab":
        space, words = _LAB, (_word(v[0], 100.0), *(_word(x, 100.0, -32_768.0, 32_767.0) for x in v[1:]), 0)
    else:
        space, words = _GRAY, (_word(v[0], 10_000.0), 0, 0, 0)
    return struct.pack(">5H", space, *words)


def _sniff(head: bytes, size: int) -> bool:
    """Check an ACO header: its count must fit the size and its first colour's space be known."""
    if size < 4 or head[:2] not in (b"\0\1", b"\0\2"):
        return False
    count = int.from_bytes(head[2:4], "big")
    least = (10 if head[1] == 1 else 14) * count
    # A truncated file is still one of this format, as far as its first colour goes.
    return (count == 0 and size == 4) or (
        size >= 6 and int.from_bytes(head[4:6], "big") <= 14 and least <= 2 * size
    )


FORMAT = PaletteFormat(
    name="aco",
    title="Photoshop colour swatches",
    endings=(".aco",),
    models=("RGB", "HSB", "CMYK", "Lab", "Gray"),
    holds="Names in any script, RGB, HSB, CMYK, Lab and Gray in 16 bits; no groups.",
    sniff=_sniff,
    read=read,
    write=write,
)
