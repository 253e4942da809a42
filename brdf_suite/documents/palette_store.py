"""Palettes as ``.brdfpalette`` JSON files, with their paints inline.

A paint within is the object of a ``.brdfpaint`` file, its format and version with it: each is brought up to date by
its own migrations, whatever the palette's version. An entry is a line of the file, so that two versions of a palette
can be compared line by line; fields that have their default are left out.
"""

from __future__ import annotations

import dataclasses
import gc
import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import MOST_ENTRIES, Entry, Group, Palette
from brdf_suite.documents.parameter import describe
from brdf_suite.documents.reading import (
    VERSIONS,
    FieldReader,
    document_bytes,
    fill,
    json_from_bytes,
    open_envelope,
)
from brdf_suite.documents.store import any_paint_from_json, paint_to_json, quick_paint
from brdf_suite.errors import DocumentError, PathLike, ValueRangeError
from brdf_suite.regular_files import within_memory

PALETTE_ENDING = ".brdfpalette"
LARGEST_PALETTE = 128 << 20
"""Bytes; ten thousand paints of six readings have eight million."""


@within_memory
def load_palette(path: PathLike) -> Palette:
    """Read a ``.brdfpalette`` file; raise :class:`DocumentError` with the place, or :class:`FileError`."""
    return palette_from_bytes(document_bytes(path, LARGEST_PALETTE), path)


def palette_from_bytes(content: bytes, path: PathLike) -> Palette:
    """Return the palette in the content of a ``.brdfpalette`` file; errors as :func:`load_palette`."""
    with without_collection():
        value = json_from_bytes(content, path, _as_entry())
        if isinstance(value, dict) and value.get("version") != VERSIONS["brdfpalette"]:
            # What older versions held is brought up to date as JSON.
            value = json_from_bytes(content, path)
        return palette_from_json(value, path)


def save_palette(palette: Palette, path: PathLike) -> None:
    """Write a ``.brdfpalette`` file, whole or not at all; raise :class:`FileError` where that fails."""
    write_atomically(path, encode_palette(palette))


def encode_palette(palette: Palette) -> bytes:
    """Return the bytes of a palette's file: an entry and a group per line."""
    with without_collection():
        document = palette_to_json(palette)
        rows = []
        for name, value in document.items():
            if name in ("groups", "entries") and isinstance(value, list) and value:
                lines = ",\n    ".join(_compact(item) for item in value)
                rows.append(f'  "{name}": [\n    {lines}\n  ]')
            else:
                rows.append(f'  "{name}": {_compact(value)}')
        return ("{\n" + ",\n".join(rows) + "\n}\n").encode("utf-8")


def _compact(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))


@contextmanager
def without_collection() -> Iterator[None]:
    """Hold the collector of cycles: half a million new objects make it look through all of them again and again."""
    running = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if running:
            gc.enable()


def palette_to_json(palette: Palette) -> dict[str, object]:
    """Return the JSON object of a palette; :func:`palette_from_json` is its inverse."""
    return {
        "format": "brdfpalette",
        "version": VERSIONS["brdfpalette"],
        "name": palette.name,
        **_changed(palette, ("notes", "colour", "columns", "foreign")),
        "groups": [
            {"path": list(group.path), **_changed(group, ("notes", "colour", "foreign"))}
            for group in palette.groups
        ],
        "entries": [entry_to_json(entry) for entry in palette.entries],
    }


def entry_to_json(entry: Entry) -> dict[str, object]:
    """Return the JSON object of an entry; for palettes, the clipboard and drags."""
    content = entry.content
    kind = "flat" if isinstance(content, FlatColour) else "paint"
    inside = flat_to_json(content) if isinstance(content, FlatColour) else paint_to_json(content)
    return {
        "id": entry.id,
        kind: inside,
        **_changed(entry, ("group", "code", "tags", "notes", "usage", "date", "foreign")),
    }


def flat_to_json(colour: FlatColour) -> dict[str, object]:
    """Return the JSON object of a flat colour."""
    return {
        "name": colour.name,
        "model": colour.model,
        "values": list(colour.values),
        **_changed(colour, ("space", "illuminant", "observer_deg", "wavelengths_nm")),
        **({"others": [flat_to_json(other) for other in colour.others]} if colour.others else {}),
    }


_DEFAULTS: dict[type, dict[str, object]] = {
    kind: {field.name: field.default for field in dataclasses.fields(kind)}
    for kind in (Palette, Group, Entry, FlatColour)
}


def _changed(value: Any, names: tuple[str, ...]) -> dict[str, object]:
    """Return the named fields that differ from their default."""
    defaults = _DEFAULTS[type(value)]
    found = {name: getattr(value, name) for name in names}
    return {
        name: _lists(item) if isinstance(item, tuple) else item
        for name, item in found.items()
        if item != defaults[name]
    }


def _lists(value: tuple[Any, ...]) -> list[Any]:
    return [_lists(item) if isinstance(item, tuple) else item for item in value]


def palette_from_json(value: object, path: PathLike = "the message") -> Palette:
    """Return the palette in a JSON value; ``path`` is what error messages call its origin.

    Raises :class:`DocumentError`: a field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    """
    reader = open_envelope(value, "brdfpalette", path)
    name = reader.take("name")
    groups = tuple(
        fill(item, Group, required=("path",))
        for item in (reader.take_objects("groups") if reader.has("groups") else [])
    )
    items = reader.take_or("entries", [])
    if not isinstance(items, list):
        reader.fail(f"expected a list, not {describe(items)}", "entries")
    if len(items) > MOST_ENTRIES:
        reader.fail(f"{len(items)} are more than the {MOST_ENTRIES} allowed", "entries")
    entries = tuple(
        item
        if isinstance(item, Entry)
        else _quick_entry(item) or entry_from_json(item, path, f"entries[{index}]")
        for index, item in enumerate(items)
    )
    return fill(reader, Palette, taken={"name": name, "groups": groups, "entries": entries})


_ENTRY_FIELDS = {field.name for field in dataclasses.fields(Entry)} - {"content"} | {"paint"}


def _quick_entry(value: object, shared: dict[tuple[str, ...], tuple[str, ...]] | None = None) -> Entry | None:
    """Return the paint entry in a JSON object, or None where the regular reader must parse it for error places."""
    if type(value) is not dict or not value.keys() <= _ENTRY_FIELDS:
        return None
    paint = quick_paint(value.get("paint"))
    if paint is None:
        return None
    try:
        entry = Entry(paint, **{name: item for name, item in value.items() if name != "paint"})
    except ValueRangeError:
        return None
    if shared is not None:
        for name in ("group", "tags"):
            words = getattr(entry, name)
            object.__setattr__(entry, name, shared.setdefault(words, words))  # equal, and still being made
    return entry


def _as_entry() -> Callable[[dict[str, object]], object]:
    """Return a function that makes entries of the JSON objects that are sound ones; others it returns as they are.

    Entries of one group, or with the same tags, share the tuples of them.
    """
    shared: dict[tuple[str, ...], tuple[str, ...]] = {}

    def convert(fields: dict[str, object]) -> object:
        if "paint" not in fields:
            return fields
        entry = _quick_entry(fields, shared)
        return fields if entry is None else entry

    return convert


def entry_from_json(value: object, path: PathLike = "the message", place: str = "") -> Entry:
    """Return the entry in a JSON value; errors as :func:`palette_from_json`."""
    reader = FieldReader(value, path, place)
    if reader.has("flat") == reader.has("paint"):
        reader.fail('expected one of "paint" and "flat"')
    content = _flat(reader.take_object("flat")) if reader.has("flat") else _paint(reader)
    return fill(reader, Entry, taken={"content": content})


def flat_from_json(value: object, path: PathLike = "the message", place: str = "") -> FlatColour:
    """Return the flat colour in a JSON value; errors as :func:`palette_from_json`."""
    return _flat(FieldReader(value, path, place))


def _flat(reader: FieldReader) -> FlatColour:
    others = tuple(_flat(item) for item in reader.take_objects("others")) if reader.has("others") else ()
    return fill(reader, FlatColour, required=("name", "model", "values"), taken={"others": others})


def _paint(reader: FieldReader) -> object:
    value = reader.take("paint")
    quick = quick_paint(value)
    if quick is not None:
        return quick
    try:
        return any_paint_from_json(value, reader.path)
    except DocumentError as error:
        place = (error.place or "").removeprefix("the top level")
        where = reader.where(f"paint.{place}" if place else "paint")
        raise DocumentError(reader.path, error.reason, where) from error
