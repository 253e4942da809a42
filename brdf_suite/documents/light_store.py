"""Studios and skies as ``.brdfstudio`` JSON files, with the field ``kind`` for the type."""

from __future__ import annotations

import dataclasses

from brdf_suite.documents.atomic import encode, write_atomically
from brdf_suite.documents.migrations import VERSIONS, open_envelope
from brdf_suite.documents.reading import FieldReader, fill, read_json
from brdf_suite.documents.studio import Backdrop, BoothRoom, Sky, Studio, StudioLamp
from brdf_suite.errors import PathLike

STUDIO_ENDING = ".brdfstudio"
LightDocument = Studio | Sky


def load_light(path: PathLike) -> LightDocument:
    """Read a ``.brdfstudio`` file; raise :class:`DocumentError` with the place, or :class:`FileError`."""
    return light_from_json(read_json(path), path)


def save_light(light: LightDocument, path: PathLike) -> None:
    """Write a ``.brdfstudio`` file, whole or not at all; raise :class:`FileError` where that fails."""
    write_atomically(path, encode(light_to_json(light)))


def light_to_json(light: LightDocument) -> dict[str, object]:
    """Return the JSON object of a studio or a sky; :func:`light_from_json` is its inverse."""
    fields = dataclasses.asdict(light)
    kind = "sky" if isinstance(light, Sky) else "studio"
    if kind == "studio":
        fields = {
            name: fields[name] for name in ("name", "unit", "room", "backdrop") if fields[name] is not None
        } | {"lamps": [_lamp_to_json(lamp) for lamp in fields["lamps"]]}
    return {"format": "brdfstudio", "version": VERSIONS["brdfstudio"], "kind": kind, **fields}


def light_from_json(value: object, path: PathLike = "the message") -> LightDocument:
    """Return the studio or sky in a JSON value; ``path`` is what error messages call its origin.

    Raises
    ------
    DocumentError
        A field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    """
    reader = open_envelope(value, "brdfstudio", path)
    kind = reader.take("kind")
    if kind == "sky":
        return fill(reader, Sky, required=("name",))
    if kind != "studio":
        reader.fail('the kinds known to this version are "studio" and "sky"', "kind")
    name = reader.take("name")
    lamps = tuple(
        fill(item, StudioLamp, required=("shape", "position_m", "size_m"))
        for item in reader.take_objects("lamps")
    )
    room, backdrop = (reader.take_or(part, None) for part in ("room", "backdrop"))
    taken = {
        "name": name,
        "lamps": lamps,
        "room": None if room is None else fill(FieldReader(room, path, "room"), BoothRoom),
        "backdrop": None if backdrop is None else fill(FieldReader(backdrop, path, "backdrop"), Backdrop),
    }
    return fill(reader, Studio, taken=taken)


def _lamp_to_json(lamp: dict[str, object]) -> dict[str, object]:
    return {name: list(value) if isinstance(value, tuple) else value for name, value in lamp.items()}
