"""ACT (Photoshop colour table) and raw PAL, read only: 256 colours of three bytes.

Four more bytes may say how many of them count, and which is transparent. Only its size identifies such a file.
"""

from __future__ import annotations

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.binary.byte_cursor import ByteCursor
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.format import PaletteFormat

_TABLE, _WITH_COUNT = 768, 772


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a table; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    cursor, collector = ByteCursor(content, path), Collector(path)
    if len(content) not in (_TABLE, _WITH_COUNT):
        raise cursor.fail(
            f"has {len(content):,} bytes; a colour table has {_TABLE} or {_WITH_COUNT}", len(content)
        )
    table = cursor.take(_TABLE, "the table")
    count = 256
    if cursor.left:
        count = cursor.u16("the count of colours") or 256
        transparent = cursor.u16("the transparent colour")
        if count > 256:
            raise cursor.fail(f"{count:,} colours are more than the 256 of the table", _TABLE)
        if transparent < count:
            collector.note(f"The colour {transparent + 1} is marked as transparent, which a paint cannot be.")
    for index in range(count):
        values = [value / 255.0 for value in table[3 * index : 3 * index + 3]]
        place = f"byte {3 * index}"
        collector.add(place, collector.colour(place, "", "RGB", values))
    return collector.finish(columns=16)


FORMAT = PaletteFormat(
    name="act",
    title="Photoshop colour table, or raw PAL",
    endings=(".act", ".pal"),
    models=("RGB",),
    holds="Read only. sRGB in 8 bits, without names, 256 at most.",
    # Known by its size alone; a file of printable characters is a text.
    sniff=lambda head, size: (
        size in (_TABLE, _WITH_COUNT) and not all(9 <= byte < 127 for byte in head[:_TABLE])
    ),
    read=read,
)
