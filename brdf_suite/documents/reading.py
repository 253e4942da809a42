"""Reader of the fields of a JSON object, brought up to the current version; every error names its place.

A :class:`FieldReader` hands out fields and knows which were asked for; what is remaining is unknown and
refused, so that a misspelt field is never silently ignored.

A change of a format adds one to its number in ``VERSIONS`` and registers a function that turns a document of
the version before into the next. Documents from a newer program are refused: guessing could lose data.
"""

from __future__ import annotations

import functools
import inspect
import json
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import NoReturn, TypeVar

from brdf_suite.documents.parameter import as_whole, describe
from brdf_suite.errors import DocumentError, ValueRangeError
from brdf_suite.regular_files import open_regular, within_memory

LARGEST_FILE = 16 * 1024 * 1024
"""Bytes; a document of ours is a few kilobytes, so more than this is something else."""

_T = TypeVar("_T")
_ABSENT = object()


class FieldReader:
    """The fields of one JSON object at ``place`` of the file ``path``."""

    def __init__(self, value: object, path: str | os.PathLike[str], place: str = "") -> None:
        self.path = path
        self.place = place
        if not isinstance(value, Mapping):
            self.fail(f"expected an object, not {describe(value)}")
        self._fields: dict[str, object] = dict(value)

    def where(self, name: str) -> str:
        """Return the full place of field ``name``."""
        return f"{self.place}.{name}" if self.place and name else self.place or name

    def fail(self, reason: str, name: str = "") -> NoReturn:
        """Raise :class:`DocumentError` about field ``name``, or about the object itself."""
        raise DocumentError(self.path, reason, self.where(name) or "the top level")

    def take(self, name: str) -> object:
        """Return a field that must be there."""
        if name not in self._fields:
            self.fail(f'the field "{name}" is missing')
        return self._fields.pop(name)

    def has(self, name: str) -> bool:
        """Whether a field is there and was not taken yet."""
        return name in self._fields

    def take_or(self, name: str, default: _T) -> object | _T:
        """Return a field, or ``default`` where it is absent."""
        return self._fields.pop(name, default)

    def take_object(self, name: str) -> FieldReader:
        """Return a reader of the object in field ``name``."""
        return FieldReader(self.take(name), self.path, self.where(name))

    def take_objects(self, name: str) -> list[FieldReader]:
        """Return a reader for each object of the list in field ``name``."""
        items = self.take(name)
        if not isinstance(items, list):
            self.fail(f"expected a list, not {describe(items)}", name)
        return [FieldReader(item, self.path, f"{self.where(name)}[{i}]") for i, item in enumerate(items)]

    def finish(self) -> None:
        """Refuse fields that no reader took."""
        if self._fields:
            unknown = next(iter(self._fields))
            self.fail(f"the field {describe(unknown).removeprefix('the text ')} is unknown")

    @contextmanager
    def naming(self) -> Iterator[None]:
        """Turn a range error from inside into a :class:`DocumentError` at this object's place."""
        try:
            yield
        except ValueRangeError as error:
            raise DocumentError(self.path, error.reason, self.where(error.place)) from error


def fill(
    reader: FieldReader,
    kind: Callable[..., _T],
    required: tuple[str, ...] = (),
    taken: dict[str, object] | None = None,
) -> _T:
    """Build ``kind`` from its fields in ``reader`` and those already ``taken``; nothing may be remaining."""
    values = dict(taken or {})
    for name in required:
        values[name] = reader.take(name)
    for name in _fields_of(kind):
        if name not in values:
            found = reader.take_or(name, _ABSENT)
            if found is not _ABSENT:
                values[name] = found
    reader.finish()
    with reader.naming():
        return kind(**values)


@functools.cache
def _fields_of(kind: Callable[..., object]) -> tuple[str, ...]:
    """Return the names that ``kind`` takes; cached, as a palette holds thousands of objects of a few kinds."""
    return tuple(inspect.signature(kind).parameters)


@within_memory
def read_json(path: str | os.PathLike[str], largest: int = LARGEST_FILE) -> object:
    """Return the value in a JSON file of at most ``largest`` bytes.

    NaN and infinities are let through as floats: the field that holds one refuses it by name, which is a
    better place than a line. A key given twice is refused, since one of the two would be lost.

    Raises
    ------
    FileError
        The file cannot be read.
    DocumentError
        It is not UTF-8, not JSON, too large or nested too deep; with line and column where they are known.
    """
    return json_from_bytes(document_bytes(path, largest), path)


def json_from_bytes(
    content: bytes,
    path: str | os.PathLike[str],
    convert: Callable[[dict[str, object]], object] = lambda fields: fields,
) -> object:
    """Return the value in the content of a JSON file; errors as :func:`read_json`.

    ``convert`` is given each object as soon as it has been read, those within it first, and what it returns takes its
    place: of a large file never all is held twice.
    """
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise DocumentError(path, "is not text in UTF-8", f"byte {error.start}") from error

    def unique(pairs: list[tuple[str, object]]) -> object:
        found = dict(pairs)
        if len(found) != len(pairs):
            seen: set[str] = set()
            twice = next(name for name, _ in pairs if name in seen or seen.add(name))  # type: ignore[func-returns-value]  # None
            raise DocumentError(path, "the field is given twice", twice[:80])
        return convert(found)

    try:
        value: object = json.loads(text, object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise DocumentError(path, f"is not valid JSON ({error.msg.lower()})", place) from error
    except RecursionError as error:
        raise DocumentError(path, "is nested too deep to be a document of ours", "the top level") from error
    except ValueError as error:  # an integer of more digits than Python converts
        raise DocumentError(path, f"holds a number that cannot be read ({error})") from error
    return value


def document_bytes(path: str | os.PathLike[str], largest: int) -> bytes:
    """Return the content of a file of at most ``largest`` bytes; errors as :func:`read_json`."""
    with open_regular(path) as file:
        content = file.read(largest + 1)
    if len(content) > largest:
        raise DocumentError(path, f"is larger than {largest // 2**20} MB, too large to be a document of ours")
    return content


Migration = Callable[[dict[str, object]], dict[str, object]]


def _fresnel_mode(fields: dict[str, object]) -> dict[str, object]:
    on = fields.get("fresnel", True)
    if not isinstance(on, bool):
        raise ValueError("fresnel was true or false")
    # The picture stays as it was: lobes were looked up as in the paper, flakes and occlusion not drawn.
    old: dict[str, object] = {
        "look_up": "paper",
        "sparkle": {"mode": "off"},
        "surface_look": {"occlusion": False},
    }
    return {**fields, **old, "fresnel": "raised" if on else "off"}


def _one_list(fields: dict[str, object]) -> dict[str, object]:
    groups = fields.pop("groups", [])
    entries = list(_objects(fields.pop("swatches", [])))
    declared = []
    for group in _objects(groups):
        name = group.pop("name")
        entries += [{**swatch, "group": [name]} for swatch in _objects(group.pop("swatches", []))]
        declared.append({"path": [name], **group})
    return {**fields, "groups": declared, "entries": entries}


def _objects(value: object) -> list[dict[str, object]]:
    if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
        raise ValueError("a list of objects was there")
    return [dict(item) for item in value]


VERSIONS: dict[str, int] = {
    "brdfpaint": 6,
    "brdfview": 8,
    "brdfstudio": 1,
    "brdfpalette": 2,
    "brdfproject": 1,
    "brdf-suite acquisition session": 1,
}
"""The present version of each format."""

MIGRATIONS: dict[tuple[str, int], Migration] = {
    # Version 2 added fields with defaults and the kind "cook_torrance"; what was there kept its meaning.
    ("brdfpaint", 1): dict,
    # Version 3 added the orange peel of an aspecular paint, with a default.
    ("brdfpaint", 2): dict,
    # Version 4 added the kind "factored".
    ("brdfpaint", 3): dict,
    # Version 5 added how light scatters in a rough coat, with a default.
    ("brdfpaint", 4): dict,
    # Version 6 added the targets of an aspecular paint's texture; there were none.
    ("brdfpaint", 5): dict,
    # Version 2 added how the image of the environment is laid out, with a default.
    ("brdfview", 1): dict,
    # Version 3 gave Fresnel three modes instead of on and off, and added fields with defaults.
    ("brdfview", 2): _fresnel_mode,
    # Version 8 added the second paint to the materials of parts, and the axis that is up in a mesh.
    ("brdfview", 7): dict,
    # Version 7 begins in the photo studio; what named no environment was in the light booth.
    ("brdfview", 6): lambda fields: {"environment": "booth", **fields},
    # Version 6 added the extent of lamps, the camera's lens and the turn during an exposure, with defaults.
    ("brdfview", 5): dict,
    # Version 5 added the glare, with a default.
    ("brdfview", 4): dict,
    # Version 4 added the brightness of the environment, the tangent map and how lamps are shaded, with defaults.
    ("brdfview", 3): dict,
    # Version 2 has one list of entries in place of swatches before and in groups, and entries that are no paints.
    ("brdfpalette", 1): _one_list,
}
"""``MIGRATIONS[format, n]`` turns fields of version n (without format and version) into those of n + 1."""


def open_envelope(value: object, expected: str, path: str | os.PathLike[str]) -> FieldReader:
    """Check ``format`` and ``version``, migrate, and return a reader of the remaining fields."""
    reader = FieldReader(value, path)
    found = reader.take("format")
    if found != expected:
        reader.fail(f'expected "{expected}", not {describe(found)}', "format")
    version = as_whole(reader.take("version"))
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        reader.fail(f"expected a whole number from 1, not {describe(version)}", "version")
    newest = VERSIONS[expected]
    if version > newest:
        reader.fail(
            f"version {describe(version)} is newer than this program, which knows up to {newest}; update it",
            "version",
        )
    assert isinstance(value, dict)  # the reader has refused everything else
    fields = {name: item for name, item in value.items() if name not in ("format", "version")}
    for step in range(version, newest):
        migration = MIGRATIONS.get((expected, step))
        if migration is None:
            raise DocumentError(path, f"version {step} is too old to be read", "version")
        try:
            fields = migration(fields)
        except (LookupError, TypeError, ValueError, AttributeError) as error:
            # A migration sees fields that are not checked yet.
            raise DocumentError(
                path,
                f"is of version {step} but not as that version was, so it cannot be brought up to date",
                "version",
            ) from error
    return FieldReader(fields, path)
