"""Items of a batch: the paints of palettes, folders, lists and names, each with the hash of its content.

An item holds either the entry of a palette itself, so that no worker reads the palette again, or the name or the file
of what is loaded where the work is done.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from brdf_suite.documents.palette import Entry
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
    load_material,
    load_palette_file,
    material_of_entry,
)
from brdf_suite.regular_files import is_file, is_folder, open_regular

JOURNAL = "finished.jsonl"
"""Of finished items, in the folder of a batch's results."""
LIGHTS = (".exr", ".hdr", STUDIO_ENDING)


@cache
def paint_endings() -> frozenset[str]:
    """Return the endings of all files that are paints, palettes or measured; looks for plug-ins."""
    measured = (ending for known in MEASURED for ending in known.endings)
    palettes = (ending for known in PALETTES for ending in known.endings)
    return frozenset({PAINT_ENDING, PALETTE_ENDING, *measured, *palettes})


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
        SHA-256 of name and content, hexadecimal.
    entry
        The JSON of a palette's entry; empty where ``source`` itself is loaded.
    fault
        Why there is nothing to work on; empty otherwise.
    notices
        What the reading of its palette left out or changed, with a palette's first item.
    times
        How often the sources hold it; it is done once.
    """

    label: str
    source: str
    key: str
    entry: bytes = b""
    fault: str = ""
    notices: tuple[str, ...] = ()
    times: int = 1


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
        A folder holds nothing. What cannot be loaded is an item that says so when it is worked on.
    """
    return _without_repeats(item for source in sources for item in _paints_of(os.fspath(source), besides))


def list_lights(sources: Iterable[str | os.PathLike[str]], besides: Path | None = None) -> list[BatchItem]:
    """Return the environments of sources: shipped names, files and folders; otherwise as :func:`list_paints`."""
    return _without_repeats(item for source in sources for item in _lights_of(os.fspath(source), besides))


def sources_in(lines: Iterable[str], folder: Path) -> list[str]:
    """Return the sources in the lines of a list: one a line, paths from ``folder`` on; # begins a remark.

    Behind a source a space comes before the #, and no file has the whole as its name.
    """
    sources = []
    for line in lines:
        text = line.strip()
        found = _is_path(folder, text)
        if not found and "#" in text:
            text = re.split(r"(?:^|\s)#", text, maxsplit=1)[0].rstrip()
            found = _is_path(folder, text)
        if text:
            sources.append(str(folder / text) if found else text)
    return sources


def _is_path(folder: Path, text: str) -> bool:
    """Whether a line names a file or a folder, or an entry of a file."""
    names = {text, text.rpartition(ENTRY_MARK)[0]} - {""}
    return any(is_file(str(folder / name)) or is_folder(str(folder / name)) for name in names)


def _without_repeats(items: Iterable[BatchItem]) -> list[BatchItem]:
    kept: dict[str, BatchItem] = {}
    for item in items:
        before = kept.get(item.key)
        if before is None:
            kept[item.key] = item
        else:
            notices = tuple(dict.fromkeys((*before.notices, *item.notices)))
            kept[item.key] = replace(before, notices=notices, times=before.times + 1)
    return list(kept.values())


def _lights_of(source: str, besides: Path | None) -> Iterator[BatchItem]:
    if not source:
        yield _named_item(source)
        return
    for path in _files_of(Path(source), LIGHTS, besides):
        yield _file_item(path) if is_file(path) else _named_item(str(path))


def _paints_of(source: str, besides: Path | None) -> Iterator[BatchItem]:
    # The path without a name is the working folder.
    is_folder_of_files = bool(source) and is_folder(source)
    files = _files_of(Path(source), paint_endings(), besides) if is_folder_of_files else [source]
    for file in map(str, files):
        try:
            yield from _paints_in(file)
        except SuiteError as error:
            yield _bad_item(Path(file), str(error))


def _paints_in(source: str) -> Iterator[BatchItem]:
    """Return the paints of a file, of an entry of a palette, or of a shipped name."""
    file, mark, wanted = source.rpartition(ENTRY_MARK)
    if is_file(source):
        path = Path(source)
        if file_kind(path) == "palette":
            found = load_palette_file(path)
            for index, item in enumerate(_entries(path, found.palette.entries)):
                yield replace(item, notices=tuple(found.notes)) if index == 0 else item
        else:
            yield _file_item(path)
    elif mark and is_file(file):
        entries = load_palette_file(file).palette.entries
        chosen = [entry for entry in entries if entry.id == wanted]
        if not chosen:
            named = [entry.id for entry in entries if entry.content.name == wanted]
            meant = f"; did you mean {ENTRY_MARK}{named[0]}?" if named else ""
            fault = str(FileError(file, f"has no paint with the id {wanted!r}{meant}"))
            yield BatchItem(source, str(Path(file).absolute()), _key(source, b""), fault=fault)
        yield from _entries(Path(file), chosen)
    else:
        yield _named_item(source)


def _files_of(source: Path, endings: Iterable[str], besides: Path | None) -> list[Path]:
    if not is_folder(source):
        return [source]
    below = [*source.rglob("*")]
    # Results of other batches are no sources.
    results = {path.parent for path in below if path.name == JOURNAL} - {source}
    found = sorted(
        path
        for path in below
        if path.suffix.lower() in endings
        and not any(part.startswith(".") for part in path.relative_to(source).parts)
        and results.isdisjoint(path.parents)
        and (besides is None or not path.absolute().is_relative_to(besides.absolute()))
        and is_file(path)
    )
    if not found:
        raise FileError(source, "holds no file that a batch can work on")
    return found


def _entries(path: Path, entries: Iterable[Entry]) -> Iterator[BatchItem]:
    for entry in entries:
        content = json.dumps(entry_to_json(entry), ensure_ascii=False).encode()
        label = f"{path.name}{ENTRY_MARK}{entry.id}"
        yield BatchItem(label, str(path.absolute()), _key(label, content), content)


def _file_item(path: Path) -> BatchItem:
    try:
        return BatchItem(_label(path), str(path.absolute()), _key(path.name, content_hash(path).encode()))
    except FileError as error:
        return _bad_item(path, str(error))


def content_hash(path: Path) -> str:
    """Return the SHA-256 of a file, hexadecimal; raise :class:`FileError` where it cannot be read."""
    with open_regular(path) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _bad_item(path: Path, fault: str) -> BatchItem:
    return BatchItem(_label(path), str(path.absolute()), _key(str(path.absolute()), b""), fault=fault)


def _label(path: Path) -> str:
    """Return the name of a file as text, also where its bytes are none."""
    return os.fsencode(path.name).decode("utf-8", "backslashreplace")


def _named_item(name: str) -> BatchItem:
    return BatchItem(name, name, _key(name, b""))


def _key(label: str, content: bytes) -> str:
    return hashlib.sha256(os.fsencode(label) + b"\0" + content).hexdigest()
