"""Paints and views as JSON files: ``.brdfpaint`` and ``.brdfview``.

Each file is ``{"format": ..., "version": ..., fields}`` with the fields named as in the values. Fields with a
default may be left out; unknown ones are refused. The same JSON travels between the programs.
"""

from __future__ import annotations

import dataclasses
import inspect
import json
import os
from collections.abc import Callable
from typing import TypeVar

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.migrations import VERSIONS, open_envelope
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, Paint
from brdf_suite.documents.reading import FieldReader, read_json
from brdf_suite.documents.view import Camera, View

PAINT_ENDING = ".brdfpaint"
VIEW_ENDING = ".brdfview"

_Path = str | os.PathLike[str]
_T = TypeVar("_T")
_ABSENT = object()


def load_paint(path: _Path) -> Paint:
    """Read a ``.brdfpaint`` file; raise :class:`DocumentError` or :class:`FileError` with the place."""
    return paint_from_json(read_json(path), path)


def save_paint(paint: Paint, path: _Path) -> None:
    """Write a ``.brdfpaint`` file, whole or not at all; raise :class:`FileError` where that fails."""
    write_atomically(path, _encode(paint_to_json(paint)))


def load_view(path: _Path) -> View:
    """Read a ``.brdfview`` file; raise :class:`DocumentError` or :class:`FileError` with the place."""
    return view_from_json(read_json(path), path)


def save_view(view: View, path: _Path) -> None:
    """Write a ``.brdfview`` file, whole or not at all; raise :class:`FileError` where that fails."""
    write_atomically(path, _encode(view_to_json(view)))


def paint_to_json(paint: Paint) -> dict[str, object]:
    """Return the JSON object of a paint; :func:`paint_from_json` is its inverse."""
    fields = dataclasses.asdict(paint)
    fields["measurements"] = [{**item, "lab": list(item["lab"])} for item in fields["measurements"]]
    return {"format": "brdfpaint", "version": VERSIONS["brdfpaint"], "kind": "aspecular", **fields}


def paint_from_json(value: object, path: _Path = "the message") -> Paint:
    """Return the paint in a JSON value; ``path`` is what error messages call its origin.

    Raises
    ------
    DocumentError
        A field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    """
    reader = open_envelope(value, "brdfpaint", path)
    kind = reader.take("kind")
    if kind != "aspecular":
        reader.fail('the only kind known to this version is "aspecular"', "kind")
    name = reader.take("name")
    measurements = tuple(_measurement(item) for item in reader.take_objects("measurements"))
    gloss = _plain(reader.take_object("gloss"), Gloss, required=("gu_20",))
    flakes_value = reader.take_or("flakes", None)
    flakes = None
    if flakes_value is not None:
        flakes = _plain(FieldReader(flakes_value, path, "flakes"), Flakes)
    return _plain(
        reader, Paint, taken={"name": name, "measurements": measurements, "gloss": gloss, "flakes": flakes}
    )


def view_to_json(view: View) -> dict[str, object]:
    """Return the JSON object of a view; :func:`view_from_json` is its inverse."""
    fields = dataclasses.asdict(view)
    target = fields["camera"]["target"]
    fields["camera"]["target"] = None if target is None else list(target)
    return {"format": "brdfview", "version": VERSIONS["brdfview"], **fields}


def view_from_json(value: object, path: _Path = "the message") -> View:
    """Return the view in a JSON value; errors as :func:`paint_from_json`."""
    reader = open_envelope(value, "brdfview", path)
    camera = _plain(reader.take_object("camera"), Camera)
    return _plain(reader, View, taken={"camera": camera})


def _measurement(reader: FieldReader) -> Measurement:
    return _plain(reader, Measurement, required=("illumination_deg", "aspecular_deg", "lab"))


def _plain(
    reader: FieldReader,
    kind: Callable[..., _T],
    required: tuple[str, ...] = (),
    taken: dict[str, object] | None = None,
) -> _T:
    """Build ``kind`` from its fields in ``reader`` and those already ``taken``; nothing may be left over."""
    values = dict(taken or {})
    for name in required:
        values[name] = reader.take(name)
    for name in inspect.signature(kind).parameters:
        if name not in values:
            found = reader.take_or(name, _ABSENT)
            if found is not _ABSENT:
                values[name] = found
    reader.finish()
    with reader.naming():
        return kind(**values)


def _encode(value: dict[str, object]) -> bytes:
    return (json.dumps(value, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode("utf-8")
