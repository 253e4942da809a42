"""ACB (Adobe colour book), read only: pages of a manufacturer's spot or process colours.

``8BCB``, version, number of the book; title, prefix, postfix and description; how many colours, how many on a page, the
key colour of a page, the space (0 RGB, 2 CMYK, 7 Lab). A colour is a name, a code of six bytes, and a byte per channel.
Texts may be keys of a dictionary (``$$$/colorbook/…=text``); ``^R`` and ``^C`` mean ® and ©. A blank name is an empty
place on a page. The last bytes may say whether the colours are inks of their own.
"""

from __future__ import annotations

from brdf_suite.documents.palette import Foreign, Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.binary.byte_cursor import ByteCursor
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.format import PaletteFormat

_CHANNELS = {0: 3, 2: 4, 7: 3}


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a colour book; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    cursor, collector = ByteCursor(content, path), Collector(path)
    cursor.take(4, "the signature")
    version, book = cursor.u16("the version"), cursor.u16("the number of the book")
    if version != 1:
        raise cursor.fail(f"version {version} is not known; 1 is", 4)
    title, prefix, postfix, description = (
        _text(cursor, what) for what in ("the title", "the prefix", "the postfix", "the description")
    )
    at = cursor.at
    count, per_page, key, space = cursor.words(4, "the counts")
    if space not in _CHANNELS:
        raise cursor.fail(f"the colour space {space} is not known; 0, 2 and 7 are", at + 6)
    if (10 + _CHANNELS[space]) * count > cursor.left:
        raise cursor.fail(f"{count:,} colours cannot lie in the {cursor.left:,} bytes that follow", at)
    records = []
    for _ in range(count):
        start = cursor.at
        name = _text(cursor, "a name")
        code = cursor.take(6, "a code").decode("latin-1").strip(" \0")
        records.append((start, name, code, cursor.take(_CHANNELS[space], "a colour")))
    tail = cursor.take(min(8, cursor.left), "the tail")
    usage = "spot" if tail == b"spflspot" else "process"
    if cursor.left or tail not in (b"", b"spflspot", b"spflproc"):
        collector.note("The bytes behind the last colour are skipped.")
    for start, name, code, channels in records:
        if not name.strip():
            collector.note("{n} empty slot[|s] skipped.")
            continue
        place = f"byte {start}"
        whole = collector.name(f"{prefix}{name}{postfix}")
        if space == 7:
            lab = (channels[0] * 100.0 / 255.0, channels[1] - 128.0, channels[2] - 128.0)
            colour = collector.colour(place, whole, "Lab", lab, illuminant="D50", observer_deg=2)
        elif space == 2:
            colour = collector.colour(place, whole, "CMYK", [1.0 - ink / 255.0 for ink in channels])
        else:
            colour = collector.colour(place, whole, "RGB", [value / 255.0 for value in channels])
        collector.add(place, colour, code=collector.name(code), usage=usage)
    foreign: Foreign = (("acb.book", str(book)), ("acb.page", f"{per_page} {key}"))
    return collector.finish(title, notes=collector.lines(description), foreign=foreign)


def _text(cursor: ByteCursor, what: str) -> str:
    text = cursor.counted_utf16(what)
    if text.startswith("$$$") and "=" in text:
        text = text.partition("=")[2]
    return text.replace("^R", "®").replace("^C", "©")


FORMAT = PaletteFormat(
    name="acb",
    title="Adobe colour book",
    endings=(".acb",),
    models=("RGB", "CMYK", "Lab"),
    holds="Read only. Names, codes, RGB, CMYK or Lab in 8 bits, spot or process.",
    sniff=lambda head, _size: head.startswith(b"8BCB"),
    read=read,
)
