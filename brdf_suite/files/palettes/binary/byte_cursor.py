"""Cursor over a binary palette, read field by field; truncated data is reported with its offset."""

from __future__ import annotations

import math
import struct

from brdf_suite.errors import FileError, PathLike


class ByteCursor:
    """Sequential reader of big-endian numbers and texts."""

    def __init__(self, content: bytes, path: PathLike, at: int = 0, end: int | None = None) -> None:
        self.content, self.path, self.at = content, path, at
        self.end = len(content) if end is None else end

    @property
    def left(self) -> int:
        """Number of remaining bytes."""
        return self.end - self.at

    def fail(self, reason: str, at: int | None = None) -> FileError:
        """Return the error at an offset (that of the next byte unless said), to be raised."""
        return FileError(self.path, reason, f"byte {self.at if at is None else at}")

    def take(self, count: int, what: str) -> bytes:
        """Return the next bytes; :class:`FileError` where the file ends before."""
        if count > self.left:
            raise self.fail(f"ends within {what}: expected {count:,} bytes, {max(self.left, 0):,} are left")
        found = self.content[self.at : self.at + count]
        self.at += count
        return found

    def u16(self, what: str) -> int:
        """Return the next unsigned number of two bytes."""
        return int.from_bytes(self.take(2, what), "big")

    def u32(self, what: str) -> int:
        """Return the next unsigned number of four bytes."""
        return int.from_bytes(self.take(4, what), "big")

    def words(self, count: int, what: str) -> tuple[int, ...]:
        """Return the next ``count`` numbers of two bytes."""
        return struct.unpack(f">{count}H", self.take(2 * count, what))

    def floats(self, count: int, what: str) -> tuple[float, ...]:
        """Return the next ``count`` numbers of four bytes; :class:`FileError` where one is not finite."""
        start = self.at
        found = struct.unpack(f">{count}f", self.take(4 * count, what))
        for index, value in enumerate(found):
            if not math.isfinite(value):
                raise self.fail(f"expected a finite number for {what}, not {value}", start + 4 * index)
        return found

    def utf16(self, characters: int, what: str) -> str:
        """Return the next text of so many units of UTF-16, without the NUL at its end.

        Half of a surrogate pair becomes U+FFFD.
        """
        return self.take(2 * characters, what).decode("utf-16-be", "replace").removesuffix("\0")

    def counted_utf16(self, what: str) -> str:
        """Return the next text, before which its length stands in four bytes."""
        at = self.at
        length = self.u32(f"the length of {what}")
        if 2 * length > self.left:
            raise self.fail(f"{what} of {length:,} characters goes beyond the end of the file", at)
        return self.utf16(length, what)


def packed_utf16(text: str) -> bytes:
    """Return a text as UTF-16 with its NUL; ``len(…) // 2`` is the count that goes before it."""
    return text.encode("utf-16-be", "replace") + b"\0\0"
