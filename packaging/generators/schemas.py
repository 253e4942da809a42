"""Generate ``resources/schemas``: a JSON Schema (draft 2020-12) of each JSON format of the suite.

``.venv/bin/python packaging/generators/schemas.py``. Fields, their types, defaults and allowed words come from the
values that the readers make, ranges of numbers from the declarations by which the readers check them. The lengths of
texts and lists, which the readers have in their checks, stand in the tables below;
``tests/documents/test_schemas.py`` compares every schema with its reader, in both directions.

What no schema can state, since it compares fields with each other, is in ``RULES``, and in the schema's ``$comment``.
"""

from __future__ import annotations

import dataclasses
import json
import re
import types
import typing
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from brdf_suite.acquisition.session import session as rig
from brdf_suite.acquisition.session import values as rig_values
from brdf_suite.documents import (
    cook_torrance,
    factored,
    flat_colour,
    paint,
    palette,
    project,
    studio,
    view,
    view_settings,
)
from brdf_suite.documents.parameter import Parameter
from brdf_suite.documents.reading import MIGRATIONS, VERSIONS
from brdf_suite.files.exports import json_document
from brdf_suite.fitting.lobes import basis

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "schemas"
DRAFT = "https://json-schema.org/draft/2020-12/schema"
Schema = dict[str, Any]

_CONTROLS = "\\u0000-\\u001f\\u007f-\\u009f\\ud800-\\udfff"
_CONTROLS_BUT_LINES = "\\u0000-\\u0008\\u000b-\\u001f\\u007f-\\u009f\\ud800-\\udfff"
_ABSOLUTE = r"^(/|[A-Za-z]:[\\/]|\\\\[^\\/]+[\\/][^\\/]+)"


def text(longest: int, *, lines: bool = False, empty: bool = False) -> Schema:
    """Return the schema of a text, as ``check_text`` checks it."""
    found: Schema = {"type": "string", "maxLength": longest}
    if not empty:
        found["pattern"] = r"\S"
    return found | {"not": {"pattern": f"[{_CONTROLS_BUT_LINES if lines else _CONTROLS}]"}}


def number(parameter: Parameter) -> Schema:
    """Return the schema of a declared number."""
    unit = f", {parameter.unit}" if parameter.unit else ""
    return {
        "type": "number",
        "minimum": parameter.low,
        "maximum": parameter.high,
        "description": f"{parameter.meaning}{unit}" if parameter.meaning else f"{parameter.label}{unit}",
    }


def whole(low: int, high: int) -> Schema:
    """Return the schema of a whole number."""
    return {"type": "integer", "minimum": low, "maximum": high}


def array(items: Schema, least: int = 0, most: int | None = None, **more: object) -> Schema:
    """Return the schema of a list."""
    limits = {"minItems": least} if least else {}
    return {"type": "array", "items": items, **limits, **({} if most is None else {"maxItems": most}), **more}


def nullable(schema: Schema) -> Schema:
    """Return the schema of what may be null."""
    return {"anyOf": [schema, {"type": "null"}]}


def ref(name: str) -> Schema:
    """Return a reference to a definition."""
    return {"$ref": f"#/$defs/{name}"}


def closed(properties: Mapping[str, Schema], required: typing.Iterable[str], **more: object) -> Schema:
    """Return the schema of an object without other fields."""
    return {
        "type": "object",
        "properties": dict(properties),
        "required": list(required),
        "additionalProperties": False,
        **more,
    }


_PATH = text(4096) | {"pattern": _ABSOLUTE}
"""An absolute path, of whatever system."""
_HASH = {"type": "string", "pattern": "^[0-9a-f]{64}$(?!\\n)"}
_COLOUR = {"type": "string", "pattern": "^(#[0-9a-f]{6})?$(?!\\n)"}
_TIME = r"[0-9]{2}:[0-9]{2}(:[0-9]{2}(\.[0-9]+)?)?(Z|[+-][0-9]{2}:[0-9]{2})?"
_DATE = {"type": "string", "pattern": rf"^([0-9]{{4}}-[0-9]{{2}}-[0-9]{{2}}(T{_TIME})?)?$(?!\n)"}
_FOREIGN = array(
    {
        "type": "array",
        "prefixItems": [text(200), text(1_000_000, lines=True, empty=True)],
        "items": False,
        "minItems": 2,
    },
    most=64,
)
_GROUP = array(text(1000, empty=True), most=palette.DEEPEST_GROUP)
_GROUP_ITSELF = _GROUP | {"minItems": 1}
_LABELS = {
    "name": text(200),
    "notes": text(100_000, lines=True, empty=True),
    "source": text(10_000, lines=True, empty=True),
}
_FACTORS = text(1000) | {"description": "words map:projection, as in p:wo q:h p:wi"}
_FILE_NAME = text(1000) | {"pattern": r"\S", "description": "relative to the folder, with / between folders"}
_TIMES = array(number(rig_values.SECONDS), most=rig_values.MOST_EXPOSURES)
_SERIES = array(_FILE_NAME, 1, rig_values.MOST_EXPOSURES)


def _of_model(model: str) -> Schema:
    """Return what the values of a flat colour are in a colour model."""
    fixed: Schema = {"model": {"const": model}}
    if model == "spectrum":
        bands = {"wavelengths_nm": array(number(flat_colour._WAVELENGTH), 2, flat_colour._MOST_BANDS)}
        values = array(number(flat_colour._REFLECTANCE), 2, flat_colour._MOST_BANDS)
        return {
            "properties": fixed | {"values": values} | bands,
            "required": ["model", "values", "wavelengths_nm"],
        }
    channels = [number(one) for one in flat_colour.CHANNELS[model]]
    values = {"type": "array", "prefixItems": channels, "items": False, "minItems": len(channels)}
    return {"properties": fixed | {"values": values, "wavelengths_nm": {"type": "array", "maxItems": 0}}}


P, CT, V, VS, S, R = (
    paint.PARAMETERS,
    cook_torrance.PARAMETERS,
    view.PARAMETERS,
    view_settings.PARAMETERS,
    studio.PARAMETERS,
    rig_values.PARAMETERS,
)


def _vector(parameter: Parameter, count: int = 3) -> Schema:
    return array(number(parameter), count, count)


NUMBERS: dict[type, tuple[Mapping[str, Parameter], str]] = {
    paint.Measurement: (P, ""),
    paint.Gloss: (P, "gloss."),
    paint.Flakes: (P, "flakes."),
    paint.OrangePeel: (P, "orange_peel."),
    paint.TextureTargets: (P, "texture."),
    paint.Paint: (P, ""),
    cook_torrance.CookTorranceLobe: (CT, "lobes[]."),
    cook_torrance.Clearcoat: (CT, "clearcoat."),
    view.Camera: (V, "camera."),
    view.View: (V, ""),
    view_settings.LightColour: (VS, "light_colour."),
    view_settings.Lamp: (VS, "lamp."),
    view_settings.Lens: (VS, "lens."),
    view_settings.Sparkle: (VS, "sparkle."),
    view_settings.SurfaceLook: (VS, "surface."),
    view_settings.Relief: (VS, "relief."),
    view_settings.TwoTone: (VS, "two_tone."),
    view_settings.Compare: (VS, "compare."),
    studio.BoothRoom: (S, ""),
    studio.Backdrop: (S, ""),
    studio.StudioLamp: (S, ""),
    studio.Sky: (S, ""),
    rig.SessionCamera: (R, ""),
    rig.Light: (R, ""),
    rig.WhiteReference: (R, ""),
    rig.Position: (R, ""),
}
"""By which declarations, with what before their names, the numbers of a value are checked."""

_PROJECT_ITEMS = project.MOST_ITEMS
FIELDS: dict[type, dict[str, Schema]] = {
    paint.Measurement: {
        "lab": {
            "type": "array",
            "prefixItems": [number(P[f"lab[{i}]"]) for i in range(3)],
            "items": False,
            "minItems": 3,
        }
    },
    paint.Paint: _LABELS
    | {
        "measurements": array(ref("Measurement"), 3, paint._MOST_MEASUREMENTS),
        "illuminant": {"const": "D65"},
        "observer_deg": {"const": 10},
    },
    cook_torrance.CookTorranceLobe: {"ks": _vector(CT["lobes[].ks"])},
    cook_torrance.CookTorrancePaint: _LABELS
    | {
        "kd": _vector(CT["kd"]),
        "lobes": array(ref("CookTorranceLobe"), most=cook_torrance._MOST_LOBES),
    },
    factored.TextureFile: {"path": text(4096), "sha256": _HASH},
    factored.FactoredPaint: _LABELS
    | {
        "factors": _FACTORS,
        "peak": {"anyOf": [{"const": ""}, _FACTORS]},
        "alpha": _vector(factored.PARAMETERS["alpha"]),
        "largest": {
            "type": "number",
            "minimum": 0.0,
            "maximum": 1e12,
            "description": "the largest sample, 1/sr",
        },
    },
    view.Camera: {"target": nullable(_vector(V["camera.target"]))},
    view.View: {
        "environment": ref("Place"),
        "surface": ref("Place"),
        "environment_layout": {"enum": list(view.ENVIRONMENT_LAYOUTS)},
        "background_colour": _vector(view._ENCODED),
        "lamps": array(ref("Lamp"), most=view_settings.MOST_LAMPS),
    },
    view_settings.Lamp: {"position": _vector(VS["lamp.position"])},
    view_settings.Sparkle: {
        "light_count": whole(int(VS["sparkle.light_count"].low), int(VS["sparkle.light_count"].high))
    },
    view_settings.PartMaterial: {"part": text(1000)},
    view_settings.SurfaceLook: {"materials": array(ref("PartMaterial"), most=10_000)},
    view_settings.Relief: {"normal_map": nullable(ref("File")), "tangent_map": nullable(ref("File"))},
    view_settings.TwoTone: {"paint": nullable(text(4096)), "mask": nullable(ref("File"))},
    view_settings.Compare: {"paint": nullable(text(4096))},
    studio.BoothRoom: {
        **{name: number(S["size"]) for name in ("width_m", "length_m", "height_m")},
        **{name: number(S["albedo"]) for name in ("floor_albedo", "wall_albedo", "ceiling_albedo")},
    },
    studio.StudioLamp: {
        "position_m": _vector(S["position_m"]),
        "size_m": _vector(S["size_m"], 2),
        "facing": nullable(_vector(S["facing"])),
    },
    studio.Studio: {"name": text(200), "lamps": array(ref("StudioLamp"), most=studio.MOST_LAMPS)},
    studio.Sky: {"name": text(200)},
    flat_colour.FlatColour: {
        "name": text(flat_colour.LONGEST_NAME, empty=True),
        "values": {"type": "array", "items": {"type": "number"}},
        "space": text(200, empty=True),
        "illuminant": text(50, empty=True),
        "observer_deg": {"enum": [0, 2, 10]},
        "wavelengths_nm": {"type": "array"},
        "others": array(ref("OtherColour"), most=flat_colour._MOST_OTHERS),
    },
    palette.Group: {
        "path": _GROUP_ITSELF,
        "notes": text(100_000, lines=True, empty=True),
        "colour": _COLOUR,
        "foreign": _FOREIGN,
    },
    palette.Entry: {
        "content": {},  # in a file "paint" or "flat"
        "id": text(64, empty=True),
        "group": _GROUP,
        "code": text(200, empty=True),
        "tags": array(text(50), most=palette.MOST_TAGS, uniqueItems=True),
        "notes": text(100_000, lines=True, empty=True),
        "date": _DATE,
        "foreign": _FOREIGN,
    },
    palette.Palette: {
        "name": text(palette._LONGEST_NAME),
        "entries": array(ref("Entry"), most=palette.MOST_ENTRIES),
        "groups": array(ref("Group"), most=palette.MOST_GROUPS),
        "notes": text(100_000, lines=True, empty=True),
        "colour": _COLOUR,
        "columns": whole(0, 10_000),
        "foreign": _FOREIGN,
    },
    project.NamedView: {"name": text(200), "view": ref("ViewDocument")},
    project.ProjectPicture: {
        "name": text(200),
        "view": text(200),
        "width": whole(1, project.LARGEST_SIDE),
        "height": whole(1, project.LARGEST_SIDE),
        "samples": whole(1, 64),
    },
    project.Project: {
        "name": text(200),
        "notes": text(100_000, lines=True, empty=True),
        "paints": array(ref("PaintDocument"), most=_PROJECT_ITEMS),
        "standard": nullable(ref("PaintDocument")),
        "views": array(ref("NamedView"), most=_PROJECT_ITEMS),
        "lights": array(ref("LightDocument"), most=_PROJECT_ITEMS),
        "source": {"anyOf": [{"const": ""}, ref("File")]},
        "pictures": array(ref("ProjectPicture"), most=_PROJECT_ITEMS),
    },
    rig.Lens: {
        **{name: number(R["focal"]) for name in ("fx", "fy")},
        **{name: number(R["principal"]) for name in ("cx", "cy")},
        **{name: number(R["distortion"]) for name in ("k1", "k2", "p1", "p2", "k3")},
    },
    rig.Board: {
        "columns": whole(3, 100),
        "rows": whole(3, 100),
        "square_m": number(R["board.square_m"]),
        "photographs": array(_FILE_NAME, 1, rig._MOST_BOARDS),
    },
    rig.SessionCamera: {
        "distance_m": number(R["camera.distance_m"]),
        "bit_depth": whole(8, 16),
        "to_working": nullable(array(_vector(R["matrix"]), 3, 3)),
    },
    rig.Sphere: {"radius_m": number(R["sphere.radius_m"]), "centre_m": nullable(_vector(R["coordinate_m"]))},
    rig.Light: {
        "distance_m": number(R["light.distance_m"]),
        "irradiance_rgb": nullable(_vector(R["irradiance"])),
        "profile": array(
            {
                "type": "array",
                "prefixItems": [number(R["profile[][0]"]), number(R["profile[][1]"])],
                "items": False,
                "minItems": 2,
            }
        ),
        "housing_radius_m": number(R["width_m"]),
        "post_radius_m": number(R["width_m"]),
    },
    rig.WhiteReference: {
        "photographs": _SERIES,
        "region": {
            "type": "array",
            "prefixItems": [whole(low, 65_535) for low in (0, 0, 1, 1)],
            "items": False,
            "minItems": 4,
        },
        "reflectance": _vector(R["reflectance"]),
        "centre_m": _vector(R["coordinate_m"]),
        "normal": _vector(R["normal"]),
        "exposures_s": _TIMES,
    },
    rig.FlatField: {"photographs": _SERIES, "exposures_s": _TIMES},
    rig.Position: {"photographs": _SERIES, "mask": nullable(_FILE_NAME)},
    rig.Session: {
        "name": text(200),
        "notes": text(100_000, lines=True, empty=True),
        "date": text(100, empty=True),
        "exposures_s": _TIMES | {"minItems": 1},
        "positions": array(ref("Position"), 1, rig.MOST_POSITIONS),
        "dark": array(_FILE_NAME, most=rig_values.MOST_EXPOSURES),
        "mask": nullable(_FILE_NAME),
    },
}
"""The fields that the values' types and declared numbers do not describe."""

REQUIRED: dict[type, set[str]] = {
    cook_torrance.CookTorrancePaint: {"lobes"},
    view.View: {"camera"},
    rig.SessionCamera: {"bit_depth"},
    project.Project: {"paints", "views", "lights", "pictures"},
}
"""Fields that a file must have although the value has a default."""

RULES: dict[str, tuple[str, ...]] = {
    "brdfpaint": (
        "no two measurements have the same angles",
        "the view of a measurement, illumination_deg - aspecular_deg, is above the horizon",
        "an orange peel is not steeper than 5°",
        "the words of factors and peak name maps and projections",
        "with the paint's folder before it the path of the textures has at most 4096 characters",
    ),
    "brdfview": ("no part of the mesh has two materials",),
    "brdfstudio": (
        "the eye is below the ceiling",
        "a lamp is within the room, and 0.1 m or more from the middle of the scene",
        "something gives light",
        "a strip is at least as long as wide, a ring's band at most half as wide as its diameter",
        "a lamp faces somewhere, and not with a vector of length 0",
        "Preetham's sky has a turbidity of 1.9 or more",
    ),
    "brdfpalette": (
        "no two entries have the same id, no two groups the same path",
        "wavelengths rise, and there are as many as values",
        "a date is one of the calendar",
    ),
    "brdfproject": (
        "no two views have the same name, and a picture's view is one of them",
        "a path project:files/NAME is a collected file",
    ),
    "acquisition_session": (
        "times and angles rise, and a lamp's profile starts at 0°",
        "every position has a photograph for each time, and no file is named twice",
        "names of files stay within the folder",
        "the rows of to_working sum to 1",
        "camera and lamp stand outside the sphere, and the white's normal is no vector of length 0",
        "camera has intrinsics or a board, not both",
    ),
    "paints_json": (),
    "lobe_basis": ("exponents ascend", "there is a result with default_count exponents"),
}
"""What the reader of a format also wants, and no schema can state."""


class _Builder:
    """Makes the definitions that a schema refers to."""

    def __init__(self) -> None:
        self.definitions: dict[str, Schema] = {}

    def fields(self, kind: type) -> tuple[dict[str, Schema], list[str]]:
        """Return the schemas of a value's fields, and which of them a file must have."""
        hints = typing.get_type_hints(kind)
        properties, required = {}, []
        for field in dataclasses.fields(kind):
            own = FIELDS.get(kind, {}).get(field.name)
            schema = own if own is not None else self.of_type(hints[field.name], kind, field.name)
            missing = field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING
            if missing or field.name in REQUIRED.get(kind, ()):
                required.append(field.name)
            elif field.default is not dataclasses.MISSING and not isinstance(field.default, tuple):
                schema = {**schema, "default": field.default}
            properties[field.name] = self.known(schema)
        return properties, required

    def define(self, kind: type) -> Schema:
        """Return a reference to the definition of a value, which is made once."""
        if kind.__name__ not in self.definitions:
            self.definitions[kind.__name__] = {}  # for what refers to itself
            properties, required = self.fields(kind)
            self.definitions[kind.__name__] = closed(properties, required, description=_summary(kind))
        return ref(kind.__name__)

    def of_type(self, hint: Any, kind: type, name: str) -> Schema:
        """Return the schema of a field by its type and its declared number."""
        origin, inner = typing.get_origin(hint), typing.get_args(hint)
        if origin is typing.Literal:
            return {"enum": [word for part in inner for word in (typing.get_args(part) or (part,))]}
        if origin in (typing.Union, types.UnionType):
            (only,) = (one for one in inner if one is not type(None))
            return nullable(self.of_type(only, kind, name))
        if dataclasses.is_dataclass(hint):
            return self.define(typing.cast(type, hint))
        if hint is bool:
            return {"type": "boolean"}
        if hint is float:
            parameters, before = NUMBERS[kind]
            return number(parameters[before + name])
        raise TypeError(f"{kind.__name__}.{name} is described nowhere")

    def known(self, schema: Schema) -> Schema:
        """Return the schema, with the values that it refers to defined."""
        for name in re.findall(r'"#/\$defs/(\w+)"', json.dumps(schema)):
            if name in _NAMED and name not in self.definitions:
                self.define(_NAMED[name])
        return schema


_NAMED = {
    kind.__name__: kind
    for kind in (
        *(paint.Measurement, cook_torrance.CookTorranceLobe, view_settings.Lamp, view_settings.PartMaterial),
        *(studio.StudioLamp, palette.Group, project.NamedView, project.ProjectPicture, rig.Position),
    )
}


def _summary(kind: type) -> str:
    words = " ".join((kind.__doc__ or "").split("\n\n")[0].split())
    return re.sub(r":\w+:`[~.]*(?:\w+\.)*(\w+)`", r"\1", words).replace("``", "")


def _envelope(
    name: str, constants: Mapping[str, object], properties: Mapping[str, Schema], required: list[str]
) -> Schema:
    """Return the object of a document: its format, the versions that need no change, and its fields."""
    newest = lowest = VERSIONS[name]
    while MIGRATIONS.get((name, lowest - 1)) is dict:
        lowest -= 1
    head: dict[str, Schema] = {"format": {"const": name}, "version": whole(lowest, newest)}
    head |= {key: {"const": value} for key, value in constants.items()}
    return closed(head | dict(properties), [*head, *required])


def _paints(builder: _Builder) -> Schema:
    kinds = {
        "aspecular": paint.Paint,
        "cook_torrance": cook_torrance.CookTorrancePaint,
        "factored": factored.FactoredPaint,
    }
    made = [_envelope("brdfpaint", {"kind": word}, *builder.fields(kind)) for word, kind in kinds.items()]
    return {"oneOf": made}


def _view(builder: _Builder) -> Schema:
    properties, required = builder.fields(view.View)
    return _envelope("brdfview", {}, properties, required)


def _lights(builder: _Builder) -> Schema:
    properties, required = builder.fields(studio.Studio)
    either = [
        {"required": [one], "properties": {one: {"type": "object"}, other: {"type": "null"}}}
        for one, other in (("room", "backdrop"), ("backdrop", "room"))
    ]
    made = _envelope("brdfstudio", {"kind": "studio"}, properties, required) | {"oneOf": either}
    return {"oneOf": [made, _envelope("brdfstudio", {"kind": "sky"}, *builder.fields(studio.Sky))]}


def _places(builder: _Builder, *, collected: bool = False) -> None:
    """Define paths of files, which in a project may be collected ones."""
    inside = [text(4096) | {"pattern": f"^project:{project.FILES}/"}] if collected else []
    name = {"type": "string", "pattern": "^[A-Za-z0-9][A-Za-z0-9_\\-]{0,99}$(?!\\n)", "maxLength": 100}
    builder.definitions["File"] = {"anyOf": [_PATH, *inside], "description": "an absolute path"}
    builder.definitions["Place"] = {
        "anyOf": [name, _PATH, *inside],
        "description": "the name of what is shipped, or an absolute path",
    }


def _flat(builder: _Builder) -> None:
    properties, required = builder.fields(flat_colour.FlatColour)
    models = [_of_model(model) for model in flat_colour.MODELS]
    of_other = properties | {"others": {"type": "array", "maxItems": 0}}
    described = _summary(flat_colour.FlatColour)
    builder.definitions["OtherColour"] = closed(of_other, required, oneOf=models, description=described)
    builder.definitions["FlatColour"] = closed(properties, required, oneOf=models, description=described)


def _palette(builder: _Builder) -> Schema:
    _flat(builder)
    builder.definitions["PaintDocument"] = _paints(builder)
    properties, _ = builder.fields(palette.Entry)
    del properties["content"]
    either = [
        {"required": [one], "not": {"required": [other]}}
        for one, other in (("paint", "flat"), ("flat", "paint"))
    ]
    content = {"paint": ref("PaintDocument"), "flat": ref("FlatColour")}
    builder.definitions["Entry"] = closed(
        content | properties, [], oneOf=either, description=_summary(palette.Entry)
    )
    properties, required = builder.fields(palette.Palette)
    return _envelope("brdfpalette", {}, properties, required)


def _project(builder: _Builder) -> Schema:
    _places(builder, collected=True)
    builder.definitions["PaintDocument"] = _paints(builder)
    builder.definitions["ViewDocument"] = _view(builder)
    builder.definitions["LightDocument"] = _lights(builder)
    properties, required = builder.fields(project.Project)
    return _envelope("brdfproject", {}, properties, required)


def _session(builder: _Builder) -> Schema:
    return _envelope(rig.FORMAT, {}, *builder.fields(rig.Session))


def _paints_json(builder: _Builder) -> Schema:
    builder.definitions["PaintDocument"] = _paints(builder)
    item = {
        "type": "object",
        "description": "a paint; original is that of which the paint is what instruments read, and is what is read",
        "anyOf": [
            {"required": ["original"], "properties": {"original": ref("PaintDocument")}},
            {
                "required": ["paint"],
                "properties": {"paint": ref("PaintDocument"), "original": {"type": "null"}},
            },
        ],
    }
    head: dict[str, Schema] = {
        "format": {"const": json_document.NAME},
        "version": {"const": json_document._VERSION},
    }
    return {
        "type": "object",
        "properties": head | {"paints": array(item, 1, json_document._MOST_PAINTS)},
        "required": [*head, "paints"],
    }


def _basis(_builder: _Builder) -> Schema:
    result = {
        "type": "object",
        "properties": {"exponents": array({"type": "number", "minimum": 1}, 1)},
        "required": ["exponents"],
    }
    properties = {
        "format": {"const": basis.STORED_FORMAT},
        "version": {"const": basis.STORED_VERSION},
        "default_count": {"type": "integer", "minimum": 1},
        "results": array(result, 1),
    }
    return {"type": "object", "properties": properties, "required": list(properties)}


def _of_paints(builder: _Builder) -> Schema:
    return _paints(builder)


def _of_view(builder: _Builder) -> Schema:
    _places(builder)
    return _view(builder)


MAKERS: dict[str, tuple[str, typing.Callable[[_Builder], Schema]]] = {
    "brdfpaint": ("a paint, .brdfpaint", _of_paints),
    "brdfview": ("a scene without its paint, .brdfview", _of_view),
    "brdfstudio": ("a studio or a sky, .brdfstudio", _lights),
    "brdfpalette": ("a palette, .brdfpalette", _palette),
    "brdfproject": ("a project, project.json in a .brdfproject", _project),
    "acquisition_session": ("photographs of a sphere, session.json", _session),
    "paints_json": ("exported paints, .json", _paints_json),
    "lobe_basis": ("exponents of lobes, .json of brdf-suite basis", _basis),
}
"""What each format is, and what makes its schema."""


def schema(name: str) -> Schema:
    """Return the schema of a format."""
    title, make = MAKERS[name]
    builder = _Builder()
    body = make(builder)
    rules = "; ".join(RULES[name])
    return {
        "$schema": DRAFT,
        "$id": f"urn:brdf-suite:schema:{name}",
        "title": f"BRDF Suite: {title}",
        **({"$comment": f"The reader also wants: {rules}."} if rules else {}),
        **body,
        **({"$defs": dict(sorted(builder.definitions.items()))} if builder.definitions else {}),
    }


def encoded(name: str) -> str:
    """Return the text of a schema's file."""
    return json.dumps(schema(name), indent=1, ensure_ascii=False) + "\n"


def main() -> None:
    """Write all schemas."""
    FOLDER.mkdir(exist_ok=True)
    for name in MAKERS:
        (FOLDER / f"{name}.schema.json").write_text(encoded(name), encoding="utf-8")


if __name__ == "__main__":
    main()
