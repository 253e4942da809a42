"""Read and write ``session.json``, the description of a folder of photographs."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from brdf_suite.acquisition.session.session import (
    FORMAT,
    SESSION_FILE,
    Board,
    FlatField,
    Lens,
    Light,
    Position,
    Session,
    SessionCamera,
    Sphere,
    WhiteReference,
)
from brdf_suite.documents.atomic import encode, write_atomically
from brdf_suite.documents.reading import VERSIONS, FieldReader, fill, open_envelope, read_json
from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import exists, is_folder

_T = TypeVar("_T")


def session_path(folder: PathLike) -> Path:
    """Return the path of a folder's ``session.json``; the file itself may be given as well."""
    path = Path(folder)
    return path if path.name == SESSION_FILE and not is_folder(path) else path / SESSION_FILE


def read_session(folder: PathLike) -> Session:
    """Read the session of a folder.

    Raises
    ------
    DocumentError
        The file's content is not valid; ``place`` names the field.
    FileError
        There is no folder, no ``session.json`` in it, or it cannot be read.
    """
    path = session_path(folder)
    if not is_folder(path.parent):
        raise FileError(path.parent, "is not a folder; expected a folder of photographs with a session.json")
    if not exists(path):
        command = f"brdf-suite acquire --template {path.parent}"
        raise FileError(path.parent, f"holds no {SESSION_FILE}; {command} writes one to fill in")
    return session_from_json(read_json(path), path)


def write_session(session: Session, folder: PathLike) -> Path:
    """Write ``session.json`` into a folder, whole or not at all, and return its path."""
    path = session_path(folder)
    write_atomically(path, encode(session_to_json(session)))
    return path


def session_to_json(session: Session) -> dict[str, object]:
    """Return the JSON object of a session; :func:`session_from_json` is its inverse."""
    return {"format": FORMAT, "version": VERSIONS[FORMAT], **_fields(session)}


def _fields(value: object) -> dict[str, object]:
    """Return the fields of a value as JSON data; absent ones are left out."""
    found = {
        field.name: getattr(value, field.name)
        for field in dataclasses.fields(value)  # type: ignore[arg-type]  # only dataclasses come here
    }
    return {name: _plain(item) for name, item in found.items() if item is not None and item not in ((), "")}


def _plain(value: object) -> object:
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    return _fields(value) if dataclasses.is_dataclass(value) else value


def session_from_json(value: object, path: PathLike = "the message") -> Session:
    """Return the session in a JSON value; ``path`` is what error messages call its origin.

    Raises
    ------
    DocumentError
        A field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    """
    reader = open_envelope(value, FORMAT, path)
    taken: dict[str, object] = {name: reader.take(name) for name in ("name", "exposures_s")}
    taken["camera"] = _camera(reader.take_object("camera"))
    taken["sphere"] = fill(reader.take_object("sphere"), Sphere, required=("radius_m",))
    taken["light"] = fill(reader.take_object("light"), Light, required=("distance_m",))
    needed, given = ("angle_deg", "photographs"), reader.take_objects("positions")
    taken["positions"] = tuple(fill(item, Position, required=needed) for item in given)
    taken["white"] = _optional(reader, "white", WhiteReference, ("photographs", "region"))
    taken["flat_field"] = _optional(reader, "flat_field", FlatField, ("photographs",))
    return fill(reader, Session, taken=taken)


def _camera(reader: FieldReader) -> SessionCamera:
    parts = {
        "intrinsics": _optional(reader, "intrinsics", Lens, ("fx", "fy", "cx", "cy")),
        "board": _optional(reader, "board", Board, ("columns", "rows", "square_m", "photographs")),
    }
    return fill(reader, SessionCamera, required=("distance_m", "bit_depth"), taken={**parts})


def _optional(
    reader: FieldReader, name: str, kind: Callable[..., _T], required: tuple[str, ...]
) -> _T | None:
    """Return the object in field ``name``, or None where it is absent or null."""
    value = reader.take_or(name, None)
    if value is None:
        return None
    return fill(FieldReader(value, reader.path, reader.where(name)), kind, required=required)
