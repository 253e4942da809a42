"""Maps of a factored paint in one EXR: one part per map, 32-bit floats, linear Rec. 2020.

A map over one axis is a single row. The file is known by the SHA-256 of its bytes, and named after it, so that two
paints of one folder never take each other's maps, and a file that was changed is not taken for the one that was meant.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import re
import tempfile
from collections.abc import Mapping
from functools import lru_cache
from glob import escape
from pathlib import Path

import numpy as np
import OpenEXR
from numpy.typing import NDArray

from brdf_suite.documents.atomic import remove_unfinished, write_atomically
from brdf_suite.documents.exr_writing import write_by_library
from brdf_suite.documents.factored import FactoredPaint, TextureFile
from brdf_suite.errors import DocumentError, FileError
from brdf_suite.regular_files import read_bytes

LARGEST_FILE = 256 * 1024 * 1024
LARGEST_MAP = 2048
_REC2020 = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
_DIGITS = 16
"""Of the hash, in the file's name."""
_DAMAGE = (OSError, RuntimeError, ValueError, TypeError, IndexError, KeyError, MemoryError)

Maps = Mapping[str, NDArray[np.float32]]


def write_textures(maps: Maps, beside: str | os.PathLike[str]) -> TextureFile:
    """Write maps (n, 3) or (n, n, 3) by name into an EXR in the folder of the document ``beside``, named by its hash.

    A file of that content that is already there is left as it is.

    Raises :class:`FileError`: it cannot be written.
    """
    images = {
        name: np.atleast_3d(values) if values.ndim == 3 else values[None] for name, values in maps.items()
    }
    width = max(image.shape[1] for image in images.values())
    height = max(image.shape[0] for image in images.values())
    # All parts of a file share the window that is displayed; each has its own of data.
    window = (np.zeros(2, np.int32), np.array([width - 1, height - 1], np.int32))
    parts = []
    for name, image in images.items():
        header = {
            "name": name,
            "type": OpenEXR.scanlineimage,
            "compression": OpenEXR.ZIP_COMPRESSION,
            "displayWindow": window,
            "chromaticities": _REC2020,
        }
        channels = {key: np.ascontiguousarray(image[..., i], np.float32) for i, key in enumerate("RGB")}
        parts.append(OpenEXR.Part(header, channels, name))
    document = Path(beside)
    # The name is known only when the content is.
    try:
        with tempfile.TemporaryDirectory() as folder:
            made = Path(folder) / "maps.exr"
            write_by_library(OpenEXR.File(parts), made, beside)
            content = made.read_bytes()
    except OSError as error:  # a temporary folder that is full, or not there
        raise FileError(beside, f"its textures cannot be written ({error.strerror or error})") from error
    digest = hashlib.sha256(content).hexdigest()
    target = _target(document, digest)
    _write(target, document, content)
    return TextureFile(str(target.absolute()), digest)


def save_beside(textures: TextureFile, beside: str | os.PathLike[str]) -> TextureFile:
    """Return the textures as a document at ``beside`` names them: a copy in its folder, by its name alone.

    Raises
    ------
    FileError, DocumentError
        They cannot be read, are not the ones that are meant, or cannot be written.
    """
    source, document = Path(textures.path), Path(beside)
    if source.is_absolute() and source.parent == document.absolute().parent:
        return TextureFile(source.name, textures.sha256)
    content = _checked(textures, beside)
    target = _target(document, textures.sha256)
    _write(target, document, content)
    return TextureFile(target.name, textures.sha256)


def read_textures(paint: FactoredPaint) -> Maps:
    """Return the maps that the paint names: (n, 3) or (n, n, 3), finite, over 0 or at least not below it.

    Raises
    ------
    FileError
        The file is not there, or cannot be read.
    DocumentError
        It is not the one that is meant, or lacks a map, or holds what is none; the place names it.
    """
    found = _read(paint.textures)
    wanted: dict[str, NDArray[np.float32]] = {}
    for factor in (factor for term in paint.terms for factor in term):
        name, axes = factor.name, factor.projection.axes
        if name not in found:
            raise DocumentError(
                paint.textures.path, f"lacks the map {name!r} that the paint reads", f"part {name}"
            )
        image = found[name]
        values = image[0] if axes == 1 and image.shape[0] == 1 else image
        square = values.ndim == axes + 1 and len(set(values.shape[:-1])) == 1
        if not square or not 2 <= len(values) <= LARGEST_MAP:
            raise DocumentError(
                paint.textures.path,
                f"is {image.shape[1]} × {image.shape[0]} texels, which {factor.projection.name} does not read",
                f"part {name}",
            )
        if not np.isfinite(values).all() or values.min() < 0.0 or (paint.logarithmic and values.min() <= 0.0):
            raise DocumentError(paint.textures.path, "holds a number that is no factor", f"part {name}")
        wanted[name] = values
    return wanted


@lru_cache(maxsize=8)
def _read(textures: TextureFile) -> Maps:
    """Return every part (h, w, 3) by its name. Kept: a paint is built again and again from the same file."""
    _checked(textures, textures.path)

    printed = io.StringIO()
    try:
        # The library prints what it cannot decode, and hands out what was in memory; the hash has excluded damage, and
        # what was made so on purpose is refused.
        with contextlib.redirect_stdout(printed):
            parts = OpenEXR.File(textures.path, separate_channels=True).parts
            found = {
                part.name(): np.stack(
                    [np.asarray(part.channels[key].pixels, np.float32) for key in "RGB"], axis=-1
                )
                for part in parts
            }
    except _DAMAGE as error:
        raise FileError(textures.path, f"holds no maps ({error})") from error
    if printed.getvalue():
        raise FileError(textures.path, "holds no maps that can be decoded")
    for values in found.values():
        values.flags.writeable = False
    return found


def _checked(textures: TextureFile, reported_path: str | os.PathLike[str]) -> bytes:
    """Return the file's bytes, which are those that are meant."""
    path = Path(textures.path)
    try:
        content = read_bytes(path, LARGEST_FILE)
    except FileError as error:
        raise FileError(path, f"the textures of the paint cannot be read: it {error.reason}") from error
    if hashlib.sha256(content).hexdigest() != textures.sha256:
        raise DocumentError(
            reported_path,
            f"the maps in {path.name} are not those that the paint was saved with; factor it again, or bring them back",
            "textures.sha256",
        )
    return content


def _write(target: Path, document: Path, content: bytes) -> None:
    """Write the textures of a document; what killed writers left of others of them goes."""
    remove_unfinished(target, f"{escape(_stem(document))}-{'[0-9a-f]' * _DIGITS}")
    write_atomically(target, content)


def _target(document: Path, digest: str) -> Path:
    return document.with_name(f"{_stem(document)}-{digest[:_DIGITS]}.exr")


def _stem(document: Path) -> str:
    """Return the document's name without the hash of an earlier copy."""
    return re.sub(rf"-[0-9a-f]{{{_DIGITS}}}$", "", document.stem)[:80] or "textures"
