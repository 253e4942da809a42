"""Palettes as JSON files: ``.brdfpalette``, with their paints inline.

A paint within is the object of a ``.brdfpaint`` file, its format and version with it: each is brought up to date by
its own migrations, whatever the palette's version.
"""

from __future__ import annotations

import os

from brdf_suite.documents.atomic import encode, write_atomically
from brdf_suite.documents.migrations import VERSIONS, open_envelope
from brdf_suite.documents.palette import Group, Palette, Swatch
from brdf_suite.documents.reading import FieldReader, fill, read_json
from brdf_suite.documents.store import any_paint_from_json, paint_to_json
from brdf_suite.errors import DocumentError

PALETTE_ENDING = ".brdfpalette"

_Path = str | os.PathLike[str]


def load_palette(path: _Path) -> Palette:
    """Read a ``.brdfpalette`` file; raise :class:`DocumentError` with the place, or :class:`FileError`."""
    return palette_from_json(read_json(path), path)


def save_palette(palette: Palette, path: _Path) -> None:
    """Write a ``.brdfpalette`` file, whole or not at all; raise :class:`FileError` where that fails."""
    write_atomically(path, encode(palette_to_json(palette)))


def palette_to_json(palette: Palette) -> dict[str, object]:
    """Return the JSON object of a palette; :func:`palette_from_json` is its inverse."""
    return {
        "format": "brdfpalette",
        "version": VERSIONS["brdfpalette"],
        "name": palette.name,
        "notes": palette.notes,
        "swatches": [_swatch_to_json(swatch) for swatch in palette.swatches],
        "groups": [
            {
                "name": group.name,
                "notes": group.notes,
                "swatches": [_swatch_to_json(swatch) for swatch in group.swatches],
            }
            for group in palette.groups
        ],
    }


def palette_from_json(value: object, path: _Path = "the message") -> Palette:
    """Return the palette in a JSON value; ``path`` is what error messages call its origin.

    Raises
    ------
    DocumentError
        A field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    """
    reader = open_envelope(value, "brdfpalette", path)
    name = reader.take("name")
    swatches = _swatches(reader)
    groups = tuple(
        fill(item, Group, taken={"name": item.take("name"), "swatches": _swatches(item)})
        for item in (reader.take_objects("groups") if reader.has("groups") else [])
    )
    return fill(reader, Palette, taken={"name": name, "swatches": swatches, "groups": groups})


def _swatches(reader: FieldReader) -> tuple[Swatch, ...]:
    return tuple(
        fill(item, Swatch, taken={"paint": _paint(item)})
        for item in (reader.take_objects("swatches") if reader.has("swatches") else [])
    )


def _paint(reader: FieldReader) -> object:
    value = reader.take("paint")
    try:
        return any_paint_from_json(value, reader.path)
    except DocumentError as error:
        place = (error.place or "").removeprefix("the top level")
        where = reader.where(f"paint.{place}" if place else "paint")
        raise DocumentError(reader.path, error.reason, where) from error


def _swatch_to_json(swatch: Swatch) -> dict[str, object]:
    return {"paint": paint_to_json(swatch.paint), "tags": list(swatch.tags), "notes": swatch.notes}
