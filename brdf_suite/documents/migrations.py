"""Migration of documents of older versions to the current one, one version at a time.

A change of a format adds one to its number in ``VERSIONS`` and registers a function that turns a document of
the version before into the next. Documents from a newer program are refused: guessing could lose data.
"""

from __future__ import annotations

import os
from collections.abc import Callable

from brdf_suite.documents.parameter import describe
from brdf_suite.documents.reading import FieldReader
from brdf_suite.errors import DocumentError

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
    "brdfpaint": 4,
    "brdfview": 4,
    "brdfstudio": 1,
    "brdfpalette": 2,
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
    # Version 2 added how the image of the environment is laid out, with a default.
    ("brdfview", 1): dict,
    # Version 3 gave Fresnel three modes instead of on and off, and added fields with defaults.
    ("brdfview", 2): _fresnel_mode,
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
    version = reader.take("version")
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        reader.fail(f"expected a whole number from 1, not {describe(version)}", "version")
    newest = VERSIONS[expected]
    if version > newest:
        reader.fail(
            f"version {describe(version)} is newer than this program, which knows up to {newest}; update it",
            "version",
        )
    fields = {name: item for name, item in dict(_mapping(value)).items() if name not in ("format", "version")}
    for step in range(version, newest):
        migration = MIGRATIONS.get((expected, step))
        if migration is None:
            raise DocumentError(path, f"version {step} is too old to be read", "version")
        try:
            fields = migration(fields)
        except (LookupError, TypeError, ValueError, AttributeError) as error:
            # A migration sees fields that are not checked yet.
            raise DocumentError(
                path, f"is of version {step} but not as that version was, so it cannot be brought up to date"
            ) from error
    return FieldReader(fields, path)


def _mapping(value: object) -> dict[str, object]:
    # FieldReader has refused everything else.
    assert isinstance(value, dict)
    return value
