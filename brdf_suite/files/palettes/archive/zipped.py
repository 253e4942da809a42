"""Bounded in-memory reader of zip files; no path in them is ever written to."""

from __future__ import annotations

import io
import zipfile
import zlib

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.palettes.format import LARGEST

MOST_PARTS = 1000
_ENTRY = b"PK\1\2"
_PACKED_BY = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""As all programs write them; each further way would bring a library and errors of its own."""


def unpack(content: bytes, path: PathLike) -> dict[str, bytes]:
    """Return the parts of a zip file by their names.

    Raises
    ------
    FileError
        It is damaged, encrypted, has too many parts, or unpacks to more than :data:`LARGEST` bytes in all.
    """
    # The list of parts alone could be a million long: it is counted before anyone reads it.
    if content.count(_ENTRY) > MOST_PARTS:
        raise FileError(path, f"has more than {MOST_PARTS:,} parts", f"byte {content.index(_ENTRY)}")
    found: dict[str, bytes] = {}
    left = LARGEST
    name = ""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            for part in archive.infolist():
                name = part.filename
                if part.is_dir():
                    continue
                if name in found:
                    raise FileError(path, "the part is there twice", f"part {name[:80]!r}")
                if part.compress_type not in _PACKED_BY:
                    raise FileError(
                        path,
                        f"is packed by a method that palettes do not have ({part.compress_type}); pack it by deflate",
                        f"part {name[:80]!r}",
                    )
                # The stated size may be wrong, so no more than that is unpacked in any case.
                with archive.open(part) as stream:
                    found[name] = stream.read(left + 1)
                left -= len(found[name])
                if left < 0:
                    raise FileError(
                        path, f"unpacks to more than the {LARGEST:,} bytes allowed", f"part {name[:80]!r}"
                    )
    except FileError:
        raise
    except (
        zipfile.BadZipFile,
        zlib.error,
        EOFError,
        NotImplementedError,  # a kind of zip file that is not known
        RuntimeError,  # a password is wanted
        ValueError,
        OverflowError,
        LookupError,
        OSError,  # a place before the beginning
    ) as error:
        place = f"part {name[:80]!r}" if name else "byte 0"
        raise FileError(path, f"is a damaged zip file ({str(error)[:120].rstrip('.')})", place) from error
    return found


def pack_zip(parts: dict[str, bytes], *, stored: str = "") -> bytes:
    """Return a zip file of these parts, the one called ``stored`` as it is; the same parts give the same bytes."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            # The first moment that a zip file can store, so that nothing depends on the clock.
            part = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            part.compress_type = zipfile.ZIP_STORED if name == stored else zipfile.ZIP_DEFLATED
            archive.writestr(part, content)
    return buffer.getvalue()


def in_part(error: FileError, part: str) -> FileError:
    """Return an error of a part's content as one of the whole file."""
    place = f"{part}, {error.place}" if error.place else part
    return FileError(error.path, error.reason, place)


def is_zip(head: bytes) -> bool:
    """Return whether a file begins as a zip file does."""
    return head.startswith((b"PK\3\4", b"PK\5\6"))
