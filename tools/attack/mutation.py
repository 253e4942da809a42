"""Damage to files: of bytes anywhere, and of the structure of JSON, XML, zip files, tables and chunked binaries.

:func:`mutate` is deterministic: the same content and the same generator give the same damage. Structured damage keeps
the rest of a file intact (lengths, checksums), so that it reaches what lies behind the first checks.
"""

from __future__ import annotations

import copy
import hashlib
import io
import json
import random
import re
import struct
import zipfile
import zlib
from collections.abc import Callable
from typing import Any

WORDS = [
    b"nan", b"-inf", b"1e999", b"-1", b"0", b"1e-320", b"9" * 40, b"1_0", b"0x10", b"", b"\xff\xfe", b"\0", b"#",
    b"\n", b"\r", b",", b"{", b"[" * 3000, b"true", b"null", b'"', b"1.5708", b"-3.2", b"99999999", b"\xe2\x80\xae",
    b"../" * 9, b"<img src='/etc/hostname'>", b"=1+1", b"%s%n", b"1e308", "\u0661".encode(), b"\x1b[2J",
]  # fmt: skip
INTEGERS = [
    0, 1, 2, 3, 0x7F, 0xFF, 0x100, 0x7FFF, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 1 << 33, (1 << 63) - 1,
    1 << 63, (1 << 64) - 1,
]  # fmt: skip
FLOATS = [float("nan"), float("inf"), float("-inf"), -1.0, 0.0, 3e38, 1e-45, 1e30]
VALUES: list[Any] = [
    None, True, False, 0, -1, 1, 2, 3, 1e308, -1e308, 1e-320, 0.5, 1 << 31, 1 << 53, 1 << 64, 10**400, "", "\0", "nan",
    "../../etc/passwd", "/dev/zero", "data:,x", "x" * 3000, "\u202e\u200b", "<b>", [], {}, [[]], [None], {"": {}},
    float("nan"), float("inf"), -0.0, "1", 255, 256, 65536,
]  # fmt: skip
_NUMBER = re.compile(rb"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")
_ATTRIBUTE = re.compile(rb"""=\s*"([^"]*)"|=\s*'([^']*)'|>([^<>]+)<""")
_ELEMENT = re.compile(rb"<(\w[\w:.-]*)[^<>]*?(?:/>|>[^<]*</\1>)")
_DOCTYPE = b'<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>'

_UNFIT = (
    ValueError, LookupError, ArithmeticError, TypeError, struct.error, zlib.error, zipfile.BadZipFile, RecursionError,
    RuntimeError,
)  # fmt: skip

Random = random.Random


def mutate(content: bytes, rng: Random) -> bytes:
    """Return damaged content: three in five times within its structure, otherwise anywhere."""
    structured = _structured(content) if rng.random() < 0.6 else None
    if structured is not None:
        try:
            return structured(content, rng)
        except _UNFIT:
            pass  # content of this kind that is damaged already, or too small for this kind of damage
    return restamp(mutate_bytes(content, rng)) if rng.random() < 0.8 else mutate_bytes(content, rng)


def mutate_bytes(content: bytes, rng: Random) -> bytes:
    """Return content with one to four kinds of damage, half of it within the first 2,600 bytes."""
    data = bytearray(content)
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        if not data:
            break
        at = rng.randrange(len(data) if rng.random() < 0.5 else min(len(data), 2600))
        kind = rng.randrange(10)
        if kind == 0:
            data[at] ^= 1 << rng.randrange(8)
        elif kind == 1:
            data[at] = rng.randrange(256)
        elif kind == 2:
            del data[at:]
        elif kind == 3:
            del data[at : at + rng.choice((1, 2, 4, 8, 100))]
        elif kind == 4:
            data[at:at] = data[at : at + rng.choice((1, 8, 100, 2000))]
        elif kind == 5:
            word = rng.choice(WORDS)
            data[at : at + rng.choice((0, 1, len(word)))] = word
        elif kind == 6:
            width = rng.choice((1, 2, 4, 8))
            order = rng.choice("<>")
            packed = struct.pack(f"{order}Q", rng.choice(INTEGERS))
            data[at : at + width] = packed[:width] if order == "<" else packed[-width:]
        elif kind == 7:
            aligned = at - at % 4
            data[aligned : aligned + 4] = struct.pack("<f", rng.choice(FLOATS))
        elif kind == 8:
            # A whole word of a text, so that numbers become other numbers.
            end = min((data.find(mark, at) for mark in (b" ", b",", b"\n", b"\t")), default=-1)
            data[at : end if end > at else at + 1] = rng.choice(WORDS)
        else:
            other = rng.randrange(len(data))
            data[at : at + 16] = data[other : other + 16]
    return bytes(data)


def splice(first: bytes, second: bytes, rng: Random) -> bytes:
    """Return the beginning of one file with the end of another, or one with blocks of the other in it."""
    at, other = rng.randrange(len(first) + 1), rng.randrange(len(second) + 1)
    if rng.random() < 0.5:
        return restamp(first[:at] + second[at if rng.random() < 0.5 else other :])
    data = bytearray(first)
    for _ in range(rng.choice((1, 1, 2, 4))):
        length = rng.choice((1, 4, 16, 64, 256, 4096))
        data[at : at + length] = second[other : other + length]
        at, other = rng.randrange(len(data) + 1), rng.randrange(len(second) + 1)
    return restamp(bytes(data))


def restamp(data: bytes) -> bytes:
    """Return one of our own array files with its first checksum made right; other content as it is."""
    if data.startswith(b"BRDFTABL") and len(data) >= 48:
        return data[:16] + hashlib.sha256(data[48:]).digest() + data[48:]
    if data.startswith(b"BRDF") and len(data) >= 48:
        (length,) = struct.unpack_from("<I", data, 8)
        return data[:16] + hashlib.sha256(data[:16] + data[48 : 48 + length]).digest() + data[48:]
    return data


def _structured(content: bytes) -> Callable[[bytes, Random], bytes] | None:
    """Return what damages the structure of such content; None where none is known."""
    for start, change in _STARTS.items():
        if content.startswith(start):
            return change
    head = content[:256].lstrip(b"\xef\xbb\xbf \t\r\n")
    if head[:1] in (b"{", b"["):
        return mutate_json
    if head[:1] == b"<":
        return mutate_xml
    if content[:4096].isascii() and b"\0" not in content[:4096]:
        return mutate_table
    return mutate_lengths


def mutate_json(content: bytes, rng: Random) -> bytes:
    """Return JSON with values replaced, removed, repeated, exchanged or nested deeply."""
    value = json.loads(content)
    for _ in range(rng.choice((1, 1, 2, 3))):
        value = _mutate_value(value, rng)
    text = json.dumps(value)
    kind = rng.randrange(40)
    if kind == 0:
        text = "[" * 5000 + text
    elif kind == 1:
        text = text.replace(": ", ": " + '{"a":' * rng.choice((70, 3000)), 1)
    elif kind == 2:
        text = text.replace("{", '{"name": 1, "name": 2, ', 1)
    return text.encode("utf-8", "surrogatepass")


def _mutate_value(value: Any, rng: Random) -> Any:
    """Return a JSON value with one place changed, at a random depth."""
    if isinstance(value, dict | list) and value and rng.random() < 0.92:
        keys = list(value) if isinstance(value, dict) else list(range(len(value)))
        key = rng.choice(keys)
        kind = rng.randrange(10)
        if kind < 6:
            value[key] = _mutate_value(value[key], rng)
        elif kind == 6:
            del value[key]
        elif kind == 7:
            value[key] = value[rng.choice(keys)]
            value = copy.deepcopy(value)
        elif kind == 8 and isinstance(value, dict):
            value[rng.choice(("", "x", f"{key}s", "__class__"))] = value.pop(key)
        elif isinstance(value, list):
            value[key:key] = [copy.deepcopy(value[key]) for _ in range(rng.choice((1, 3, 300)))]
        return value
    if isinstance(value, int | float) and not isinstance(value, bool) and rng.random() < 0.5:
        return rng.choice(
            (-value, value + 1, value * 1e6, value * 1e-6, int(value) if value == value else 0, 1 - value)
        )
    return copy.deepcopy(rng.choice(VALUES))


def mutate_xml(content: bytes, rng: Random) -> bytes:
    """Return XML with values replaced, elements removed, repeated, nested or exchanged, or a document type."""
    data = content
    for _ in range(rng.choice((1, 1, 2, 4))):
        kind = rng.randrange(8)
        if kind < 4:
            places = [
                match.span(index)
                for match in _ATTRIBUTE.finditer(data)
                for index in (1, 2, 3)
                if match[index]
            ]
            start, end = rng.choice(places)
            data = data[:start] + rng.choice(WORDS) + data[end:]
        elif kind < 7:
            start, end = rng.choice([match.span() for match in _ELEMENT.finditer(data)])
            element = data[start:end]
            nested = b"<a>" * rng.choice((3, 90, 3000))
            new = (b"", element * rng.choice((2, 50)), nested + element + nested.replace(b"<", b"</"))[
                kind - 4
            ]
            data = data[:start] + new + data[end:]
        else:
            root = re.search(rb"<\w", data)
            at = root.start() if root else 0
            data = data[:at] + rng.choice((_DOCTYPE, b"<!--", b"<![CDATA[", b"<?x ?>", b"&b;")) + data[at:]
    return data


def mutate_table(content: bytes, rng: Random) -> bytes:
    """Return a text with numbers replaced, and cells and lines removed, repeated or exchanged."""
    mark = next((one for one in (b"\t", b";", b",", b" ") if one in content), b" ")
    lines = content.split(b"\n")
    for _ in range(rng.choice((1, 1, 2, 4))):
        row = rng.randrange(len(lines) if rng.random() < 0.5 else min(len(lines), 30))
        cells = lines[row].split(mark)
        column = rng.randrange(len(cells))
        kind = rng.randrange(8)
        if kind < 3:
            number = rng.choice((*WORDS, b"0", b"-0.0", b"1e30", b"-90", b"4294967296", b"90.0001"))
            found = [match.span() for match in _NUMBER.finditer(lines[row])]
            start, end = rng.choice(found) if found else (0, 0)
            lines[row] = lines[row][:start] + number + lines[row][end:]
            continue
        if kind == 3:
            del cells[column]
        elif kind == 4:
            cells[column:column] = [cells[column]] * rng.choice((1, 2, 500))
        elif kind == 5:
            cells[column] = rng.choice(WORDS)
        elif kind == 6:
            lines[row:row] = [lines[row]] * rng.choice((1, 3, 200))
            continue
        else:
            del lines[row]
            if not lines:
                return b""
            continue
        lines[row] = mark.join(cells)
    return b"\n".join(lines)


def mutate_lengths(content: bytes, rng: Random) -> bytes:
    """Return a binary file with numbers changed that may be lengths, counts or offsets: below its own size."""
    data = bytearray(content)
    reach = min(len(data), 4096)
    for _ in range(rng.choice((1, 1, 2, 3))):
        width, order = rng.choice((2, 4, 4, 8)), rng.choice(("little", "big"))
        offset = rng.randrange(max(1, reach - width))
        found = [
            at
            for at in range(offset, max(offset + 1, min(offset + 256, reach - width)))
            if 0 < int.from_bytes(data[at : at + width], order) <= len(data)  # type: ignore[arg-type]  # one of two words
        ]
        at = rng.choice(found or [offset])
        old = int.from_bytes(data[at : at + width], order)  # type: ignore[arg-type]  # one of two words
        new = rng.choice((*INTEGERS, old + 1, old - 1, old * 2, len(data), len(data) + 1, old ^ 0x80))
        data[at : at + width] = (new & ((1 << 8 * width) - 1)).to_bytes(width, order)  # type: ignore[arg-type]  # one of two words
    return restamp(bytes(data))


def mutate_zip(content: bytes, rng: Random) -> bytes:
    """Return a zip file with a damaged part, or with parts renamed, removed, repeated or packed in another way."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        parts = [(info.filename, archive.read(info), info.compress_type) for info in archive.infolist()]
    kind = rng.randrange(10)
    place = rng.randrange(len(parts))
    name, inside, method = parts[place]
    if kind < 6:
        parts[place] = (name, mutate(inside, rng), method)
    elif kind == 6:
        parts[place] = (rng.choice(("../../x", "/etc/x", "a\0b", name.upper(), "x" * 300)), inside, method)
    elif kind == 7:
        del parts[place]
    elif kind == 8:
        parts += [(f"{name}{number}", inside, method) for number in range(rng.choice((1, 40)))]
    else:
        parts[place] = (name, inside + bytes(rng.choice((1 << 12, 1 << 22))), rng.choice((0, 8, 12, 14)))
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as archive:
        for name, inside, method in parts:
            info = zipfile.ZipInfo(name or "x")
            info.compress_type = method
            archive.writestr(info, inside)
    return made.getvalue()


def mutate_png(content: bytes, rng: Random) -> bytes:
    """Return a PNG with chunks changed, removed, repeated or exchanged, their checksums right."""
    chunks, at = [], 8
    while at + 12 <= len(content):
        (length,) = struct.unpack_from(">I", content, at)
        chunks.append((content[at + 4 : at + 8], content[at + 8 : at + 8 + length]))
        at += 12 + length
    place = rng.randrange(len(chunks)) if rng.random() < 0.6 else 0
    name, data = chunks[place]
    kind = rng.randrange(6)
    if kind < 3:
        if name == b"IDAT" and rng.random() < 0.7:
            data = zlib.compress(mutate_bytes(zlib.decompress(data), rng), 1)
        else:
            data = mutate_lengths(data, rng) if name == b"IHDR" else mutate_bytes(data, rng)
        chunks[place] = (name, data)
    elif kind == 3:
        del chunks[place]
    elif kind == 4:
        chunks[place:place] = [(name, data)] * rng.choice((1, 2, 50))
    else:
        extra = rng.choice((b"iCCP", b"tEXt", b"eXIf", b"PLTE", b"tRNS", b"acTL", b"gAMA", b"zTXt"))
        chunks.insert(rng.randrange(len(chunks) + 1), (extra, rng.randbytes(rng.choice((0, 1, 4, 30)))))
    return content[:8] + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in chunks
    )


def mutate_tiff(content: bytes, rng: Random) -> bytes:
    """Return a TIFF whose directory has changed tags, types, counts or values."""
    order = "<" if content.startswith(b"II") else ">"
    data = bytearray(content)
    (start,) = struct.unpack_from(f"{order}I", data, 4)
    (count,) = struct.unpack_from(f"{order}H", data, start)
    for _ in range(rng.choice((1, 1, 2))):
        entry = start + 2 + 12 * rng.randrange(count)
        tag, kind, number, value = struct.unpack_from(f"{order}HHII", data, entry)
        where = rng.randrange(5)
        wide = rng.choice((*INTEGERS, start, entry, value + 1, len(data), number * 2)) & 0xFFFFFFFF
        if where == 0:
            tag = rng.choice((256, 257, 258, 259, 262, 273, 277, 278, 279, 320, 322, 324, 330, 338, 339, 700))
        elif where == 1:
            kind = rng.choice((0, 1, 2, 3, 4, 5, 7, 11, 12, 13, 16, 99))
        elif where == 2:
            number = wide
        elif where == 3:
            value = wide
        else:
            struct.pack_into(f"{order}I", data, start + 2 + 12 * count, wide)  # the next directory
        struct.pack_into(f"{order}HHII", data, entry, tag, kind, number, value)
    return bytes(data)


def mutate_exr(content: bytes, rng: Random) -> bytes:
    """Return an OpenEXR file whose header has changed attributes."""
    data = bytearray(content)
    found, at = [], 8
    while at < len(data) and data[at]:
        name_end = data.index(0, at)
        type_end = data.index(0, name_end + 1)
        (size,) = struct.unpack_from("<I", data, type_end + 1)
        found.append((at, name_end, type_end, size))
        at = type_end + 5 + size
    for _ in range(rng.choice((1, 1, 2))):
        begin, name_end, type_end, size = rng.choice(found)
        value = type_end + 5
        kind = rng.randrange(6)
        if kind < 3 and size:
            width = min(size, rng.choice((1, 4)))
            place = value + rng.randrange(0, max(1, size - width + 1), width)
            new = struct.pack("<Q", rng.choice(INTEGERS))[:width]
            data[place : place + width] = (
                new if rng.random() < 0.7 else struct.pack("<f", rng.choice(FLOATS))[:width]
            )
        elif kind == 3:
            struct.pack_into(
                "<I", data, type_end + 1, rng.choice((0, 1, size + 1, size * 2, 0x7FFFFFFF, 0xFFFFFFFF))
            )
        elif kind == 4:
            letter = rng.randrange(begin, type_end)
            data[letter] = rng.choice(b"axZ\0\xff") if letter != name_end else 0
        else:
            bits = rng.choice((0x200, 0x400, 0x800, 0x1000, 1))
            struct.pack_into("<I", data, 4, struct.unpack_from("<I", data, 4)[0] ^ bits)
    return bytes(data)


def mutate_glb(content: bytes, rng: Random) -> bytes:
    """Return a binary glTF file with a damaged document or buffer, its lengths right."""
    (length,) = struct.unpack_from("<I", content, 12)
    document, rest = content[20 : 20 + length], content[20 + length :]
    if rng.random() < 0.8:
        document = mutate_json(document, rng)
        document += b" " * (-len(document) % 4)
    elif rest:
        data = mutate_bytes(rest[8:], rng)
        rest = struct.pack("<I", len(data)) + rest[4:8] + data
    body = struct.pack("<I", len(document)) + b"JSON" + document + rest
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def mutate_arrays(content: bytes, rng: Random) -> bytes:
    """Return one of our own array files with a damaged header, its length and checksum right."""
    (length,) = struct.unpack_from("<I", content, 8)
    if rng.random() < 0.3:
        return mutate_lengths(content, rng)
    header = mutate_json(content[48 : 48 + length], rng)
    header += b" " * (-(48 + len(header)) % 64)
    return restamp(
        content[:8] + struct.pack("<I", len(header)) + content[12:48] + header + content[48 + length :]
    )


_STARTS: dict[bytes, Callable[[bytes, Random], bytes]] = {
    b"PK\x03\x04": mutate_zip,
    b"\x89PNG": mutate_png,
    b"II*\0": mutate_tiff,
    b"MM\0*": mutate_tiff,
    b"\x76\x2f\x31\x01": mutate_exr,
    b"glTF": mutate_glb,
    b"BRDF": mutate_arrays,
}
