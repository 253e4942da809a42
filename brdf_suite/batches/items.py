"""Items of a batch: the paints of palettes, folders, lists and names, each with the hash of its content.

An item holds either the entry of a palette itself, so that no worker reads the palette again, or the name or the file
of what is loaded where the work is done.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, entry_from_json, entry_to_json
from brdf_suite.documents.store import PAINT_ENDING
from brdf_suite.documents.studio import STUDIO_ENDING
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.measured import FORMATS as MEASURED
from brdf_suite.files.palettes import FORMATS as PALETTES
from brdf_suite.pipeline.material import (
    ENTRY_MARK,
    Material,
    file_kind,
    is_file,
    load_material,
    load_palette_file,
    material_of_entry,
)
from brdf_suite.regular_files import open_regular

_BLOCK = 1 << 20
LIGHTS = (".exr", ".hdr", STUDIO_ENDING)
_PAINTS = frozenset(
    {
        PAINT_ENDING,
        PALETTE_ENDING,
        *(end for known in MEASURED for end in known.endings),
        *(end for known in PALETTES for end in known.endings),
    }
)


@dataclass(frozen=True)
class BatchItem:
    """One thing that a batch works on.

    Attributes
    ----------
    label
        What a person knows it by: a name, the name of a file, or ``FILE#ID``.
    source
        A shipped name, or the absolute path of a file.
    key
        SHA-256 of label and content, hexadecimal.
    entry
        The JSON of a palette's entry; empty where ``source`` itself is loaded.
    fault
        Why there is nothing to work on; empty otherwise.
    """

    label: str
    source: str
    key: str
    entry: bytes = b""
    fault: str = ""


def load_item(item: BatchItem) -> Material:
    """Return what an item stands for; raise :class:`SuiteError` as :func:`load_material`."""
    if item.fault:
        raise SuiteError(item.fault)
    if item.entry:
        return material_of_entry(entry_from_json(json.loads(item.entry), item.source), item.label)
    return load_material(item.source)


def list_paints(sources: Iterable[str | os.PathLike[str]], besides: Path | None = None) -> list[BatchItem]:
    """Return the paints of sources, in their order; what is there twice, once.

    Parameters
    ----------
    sources
        Names, paints, measured files, palettes of any format, ``PALETTE#ID``, and folders, with all that lies below
        them.
    besides
        A folder that is not looked into: that of the results.

    Raises
    ------
    FileError
        A source is not there, or a folder holds nothing.
    """
    return _without_repeats(item for source in sources for item in _paints_of(os.fspath(source), besides))


def list_lights(sources: Iterable[str | os.PathLike[str]], besides: Path | None = None) -> list[BatchItem]:
    """Return the environments of sources: shipped names, files and folders; otherwise as :func:`list_paints`."""
    return _without_repeats(
        _file_item(path) if path.is_file() else _named_item(str(path))
        for source in sources
        for path in _files_of(Path(source), LIGHTS, besides)
    )


def read_list(lines: Iterable[str], folder: Path) -> list[str]:
    """Return the sources in the lines of a list: one a line, paths from ``folder`` on; # begins a remark."""
    sources = []
    for line in lines:
        text = line.strip()
        if text and not text.startswith("#"):
            path = folder / text.partition(ENTRY_MARK)[0]
            sources.append(str(folder / text) if path.exists() else text)
    return sources


def _without_repeats(items: Iterator[BatchItem] | Iterable[BatchItem]) -> list[BatchItem]:
    return list({item.key: item for item in items}.values())


def _paints_of(source: str, besides: Path | None) -> Iterator[BatchItem]:
    if not Path(source).is_dir():
        if not is_file(source):
            yield _named_item(source)
        elif file_kind(source) == "palette":
            yield from _entries(Path(source), load_palette_file(source).palette)
        else:
            yield _file_item(Path(source))
        return
    for path in _files_of(Path(source), _PAINTS, besides):
        try:
            if file_kind(path) == "palette":
                yield from _entries(path, load_palette_file(path).palette)
                continue
        except SuiteError as error:
            yield BatchItem(path.name, str(path.absolute()), _key(path.name, b""), fault=str(error))
            continue
        yield _file_item(path)


def _files_of(source: Path, endings: Iterable[str], besides: Path | None) -> list[Path]:
    if not source.is_dir():
        return [source]
    found = sorted(
        path
        for path in source.rglob("*")
        if path.suffix.lower() in endings
        and not any(part.startswith(".") for part in path.relative_to(source).parts)
        and (besides is None or not path.absolute().is_relative_to(besides.absolute()))
        and path.is_file()
    )
    if not found:
        raise FileError(source, "holds no file that a batch can work on")
    return found


def _entries(path: Path, palette: Palette) -> Iterator[BatchItem]:
    for entry in palette.entries:
        content = json.dumps(entry_to_json(entry), ensure_ascii=False).encode()
        label = f"{path.name}{ENTRY_MARK}{entry.id}"
        yield BatchItem(label, str(path.absolute()), _key(label, content), content)


def _file_item(path: Path) -> BatchItem:
    try:
        with open_regular(path) as file:
            digest = hashlib.sha256(f"{path.name}\0".encode())
            while block := file.read(_BLOCK):
                digest.update(block)
    except FileError as error:
        return BatchItem(path.name, str(path.absolute()), _key(path.name, b""), fault=str(error))
    return BatchItem(path.name, str(path.absolute()), digest.hexdigest())


def _named_item(name: str) -> BatchItem:
    return BatchItem(name, name, _key(name, b""))


def _key(label: str, content: bytes) -> str:
    return hashlib.sha256(f"{label}\0".encode() + content).hexdigest()
