"""An ICC profile of a made-up press in CMYK, with colours that are known."""

from __future__ import annotations

import struct
from itertools import product


def look(c: float, m: float, y: float, k: float) -> tuple[int, int, int]:
    """L*a*b* of full and missing inks on this press."""
    lightness = 100 - 30 * c - 35 * m - 8 * y
    return round(lightness * (1 - 0.8 * k)), round(-30 * c + 60 * m), round(-35 * c - 5 * m + 80 * y)


def press(darker: float = 1.0) -> bytes:
    """A profile of a press, ICC.1 version 2: a table of 8 bits with two steps for each ink.

    ``darker`` is what L* is multiplied by.
    """

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
        corners += bytes((round(darker * lightness * 2.55), a + 128, b + 128))
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
