"""The JSON Schemas of our formats against the readers: what one refuses the other does, but for the rules it states."""

from __future__ import annotations

import importlib.util
import json
import math
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from brdf_suite.acquisition.session.store import session_from_json, session_to_json
from brdf_suite.documents.cook_torrance import Clearcoat, CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint, TextureFile
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, OrangePeel, Paint, TextureTargets
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.documents.palette_store import palette_from_json, palette_to_json
from brdf_suite.documents.project import (
    NamedView,
    Project,
    ProjectPicture,
    project_from_json,
    project_to_json,
)
from brdf_suite.documents.reading import VERSIONS
from brdf_suite.documents.store import any_paint_from_json, paint_to_json, view_from_json, view_to_json
from brdf_suite.documents.studio import (
    Backdrop,
    BoothRoom,
    Sky,
    Studio,
    StudioLamp,
    light_from_json,
    light_to_json,
)
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import (
    Compare,
    Lamp,
    Lens,
    PartMaterial,
    Relief,
    SurfaceLook,
    TwoTone,
)
from brdf_suite.errors import SuiteError
from brdf_suite.files.exports.json_document import import_paints
from brdf_suite.fitting.lobes.basis import stored_bases
from brdf_suite.resources import resource

CHECKOUT = Path(__file__).resolve().parents[2]
FOLDER = CHECKOUT / "resources" / "schemas"
NAMES = sorted(path.name.removesuffix(".schema.json") for path in FOLDER.glob("*.schema.json"))

COLOURS = ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0))
SEA = Paint(
    "Sea",
    tuple(Measurement(45.0, at, lab) for at, lab in zip((15.0, 45.0, 110.0), COLOURS, strict=True)),
    Gloss(90.0, 94.0),
    flakes=Flakes(),
    orange_peel=OrangePeel(),
    texture=TextureTargets(1.0, None, 2.0, 0.03),
    notes="two\nlines",
    source="hand",
)
LOBES = CookTorrancePaint(
    "Lobes",
    (0.1, 0.2, 0.3),
    (CookTorranceLobe((0.1, 0.1, 0.1), 0.2, 0.04),),
    clearcoat=Clearcoat(),
    flakes=Flakes(),
)
TEXTURES = FactoredPaint(
    "Factors",
    TextureFile("/textures/a.exr", "0" * 64),
    "p:wo q:h p:wi",
    (1.0, 1.0, 1.0),
    peak="r:h",
    largest=3.0,
)
SCENE = View(
    camera=Camera(distance=2.0, target=(0.0, 0.5, 0.0)),
    environment="/lights/a.exr",
    lamps=(Lamp(),),
    lens=Lens(2.8, 3.0, 1.0),
    surface_look=SurfaceLook(materials=(PartMaterial("door", "glass"),)),
    relief=Relief(normal_map="/maps/n.png", tangent_map="C:\\maps\\t.png"),
    two_tone=TwoTone(paint="copper", mask="/maps/m.png"),
    compare=Compare("side", "copper"),
)
LAMPS = (
    StudioLamp("box", (1.0, 2.0, 0.5), (1.0, 0.5), facing=(0.0, -1.0, 0.0), colour_temperature_k=5000.0),
    StudioLamp("ring", (-1.0, 1.0, 0.5), (1.0, 0.2)),
)
BOOTH = Studio("Booth", LAMPS, room=BoothRoom())
VOID = Studio("Void", LAMPS, backdrop=Backdrop(0.1, 6500.0), unit="relative")
INK = FlatColour(
    "Ink",
    "CMYK",
    (1.0, 0.5, 0.0, 0.1),
    space="FOGRA39",
    others=(FlatColour("", "Lab", (50.0, 1.0, 2.0), illuminant="D50", observer_deg=2),),
)
BANDS = FlatColour("Bands", "spectrum", (0.1, 0.2, 0.3), wavelengths_nm=(400.0, 500.0, 600.0))
PALETTE = Palette(
    "Summer",
    (
        Entry(
            SEA,
            id="a",
            group=("Dark", "Blue"),
            code="B-1",
            tags=("metallic", "new"),
            notes="text",
            usage="spot",
            date="2024-05-31T10:00:00Z",
            foreign=(("field", "text\nmore"),),
        ),
        Entry(INK, id="b"),
        Entry(BANDS, id="c", date="2024-05-31"),
        Entry(LOBES, id="d"),
    ),
    groups=(Group(("Dark",), notes="text", colour="#00ff00", foreign=(("a", "b"),)),),
    notes="text",
    colour="#123456",
    columns=4,
    foreign=(("a", "b"),),
)
PROJECT = Project(
    "Car",
    (SEA, LOBES),
    standard=SEA,
    views=(NamedView("front", SCENE),),
    lights=(VOID,),
    source="/measured/blue.binary",
    pictures=(ProjectPicture("one", "front"),),
    notes="text",
)
SESSION: dict[str, object] = {
    "format": "brdf-suite acquisition session",
    "version": 1,
    "name": "Ball",
    "camera": {
        "distance_m": 2.0,
        "height_m": 0.1,
        "bit_depth": 12,
        "response": "srgb",
        "tilt_deg": 1.0,
        "to_working": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        "intrinsics": {"fx": 1000.0, "fy": 1000.0, "cx": 100.0, "cy": 90.0, "k1": 0.1},
    },
    "sphere": {"radius_m": 0.05, "centre_m": [0.0, 0.0, 0.0]},
    "light": {
        "distance_m": 0.7,
        "irradiance_rgb": [1.0, 1.0, 1.0],
        "profile": [[0.0, 1.0], [30.0, 0.5]],
        "housing_radius_m": 0.1,
    },
    "exposures_s": [0.01, 0.1],
    "positions": [
        {"angle_deg": 10.0, "photographs": ["a/1.png", "a/2.png"], "mask": "mask.png"},
        {"angle_deg": 20.0, "photographs": ["b/1.png", "b/2.png"]},
    ],
    "white": {
        "photographs": ["w/1.png", "w/2.png"],
        "region": [1, 2, 30, 40],
        "reflectance": [0.9, 0.9, 0.9],
        "centre_m": [0.0, 0.0, 0.1],
        "normal": [0.0, 0.0, 1.0],
    },
    "dark": ["d/1.png", "d/2.png"],
    "flat_field": {"photographs": ["f/1.png"], "exposures_s": [0.02]},
    "mask": "all.png",
    "notes": "text",
    "date": "today",
}


@dataclass(frozen=True)
class Format:
    """A format's samples, its reader, and its writer where there is one; ``rules`` are what no schema states."""

    samples: tuple[dict[str, Any], ...]
    read: Callable[[Any], Any]
    write: Callable[[Any], dict[str, Any]] | None
    rules: str = "(?!)"


PAINT_RULES = (
    "textures.path: 4|same angles as|look from below|would be steeper|factor|map|projection|is a word"
)
VIEW_RULES = "a part is named twice"
STUDIO_RULES = (
    "below the ceiling|outside of the room|from the middle of the scene|nothing gives light|strip is at least|"
    "ring's band|has no direction|Preetham"
)
PALETTE_RULES = (
    f"{PAINT_RULES}|is there twice|wavelengths must rise|as many as wavelengths|expected a date as in"
)
FORMATS = {
    "brdfpaint": Format(
        tuple(map(paint_to_json, (SEA, LOBES, TEXTURES))), any_paint_from_json, paint_to_json, PAINT_RULES
    ),
    "brdfview": Format((view_to_json(SCENE),), view_from_json, view_to_json, VIEW_RULES),
    "brdfstudio": Format(
        tuple(map(light_to_json, (BOOTH, VOID, Sky("Day")))), light_from_json, light_to_json, STUDIO_RULES
    ),
    "brdfpalette": Format((palette_to_json(PALETTE),), palette_from_json, palette_to_json, PALETTE_RULES),
    "brdfproject": Format(
        (project_to_json(PROJECT),),
        lambda value: project_from_json(value, "p.brdfproject", Path("/p"), set()),
        project_to_json,
        f"{PAINT_RULES}|{VIEW_RULES}|{STUDIO_RULES}|name of another view|no view of the project|no collected file",
    ),
    "acquisition_session": Format(
        (SESSION,),
        session_from_json,
        session_to_json,
        "comes after|beyond the one before|starts at 0|photographs|is the file of|outside the folder|write folders|"
        "sums to|inside the sphere|has no direction|exposure|board|intrinsics",
    ),
    "paints_json": Format(
        (
            {
                "format": "brdf-suite-paints",
                "version": 1,
                "paints": [
                    {"paint": paint_to_json(SEA), "flop_index": 12.0},
                    {"paint": paint_to_json(SEA), "original": paint_to_json(LOBES)},
                ],
            },
        ),
        lambda value: import_paints(value, "a.json"),
        None,
        PAINT_RULES,
    ),
}


def validator(name: str) -> Draft202012Validator:
    return Draft202012Validator(json.loads((FOLDER / f"{name}.schema.json").read_text(encoding="utf-8")))


VALIDATORS = {name: validator(name) for name in NAMES}


@pytest.fixture(scope="module")
def generator() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "schemas", CHECKOUT / "packaging" / "generators" / "schemas.py"
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", NAMES)
def test_a_schema_is_what_the_readers_declare_and_is_one_of_the_draft(
    name: str, generator: ModuleType
) -> None:
    text = (FOLDER / f"{name}.schema.json").read_text(encoding="utf-8")
    assert text == generator.encoded(name), "run packaging/generators/schemas.py"
    Draft202012Validator.check_schema(json.loads(text))
    assert json.loads(text)["$schema"] == "https://json-schema.org/draft/2020-12/schema"


def test_every_versioned_format_has_a_schema() -> None:
    formats = {
        json.dumps(schema).split('"format": {"const": "')[1].split('"')[0]
        for schema in (one.schema for one in VALIDATORS.values())
    }
    assert formats >= set(VERSIONS) - {"brdfproject"}
    assert set(FORMATS) | {"lobe_basis"} == set(NAMES)


def test_what_is_shipped_is_valid() -> None:
    for paint in (CHECKOUT / "resources" / "paints").rglob("*.brdfpaint"):
        VALIDATORS["brdfpaint"].validate(json.loads(paint.read_text(encoding="utf-8")))
    VALIDATORS["lobe_basis"].validate(
        json.loads(resource("basis", "search.json").read_text(encoding="utf-8"))
    )


def refusal(known: Format, document: Any) -> str | None:
    """Return what the reader says against a document; None where it takes it."""
    try:
        known.read(document)
    except SuiteError as error:
        return str(error)
    return None


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the path of every value in a document, the document's own first; of a document within it the name alone."""
    yield path
    if isinstance(value, dict):
        within = bool(path) and "format" in value
        for key, item in value.items():
            if not within or key in ("format", "kind", "name"):
                yield from places(item, (*path, key))
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from places(item, (*path, index))


def at(document: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        document = document[key]
    return document


LONG = (50, 64, 100, 200, 1000, 4096, 10_000, 100_000)


def mutants(document: Any, path: tuple[Any, ...]) -> Iterator[Any]:
    """Yield what a value may be replaced by: other types, other words, numbers and lengths about the limits."""
    value = at(document, path)
    yield from (None, True, 1, 0.5, -1.0, 1e300, -1e300, math.inf, 10**400, "", "x", [], {}, [1.0], {"a": 1})
    if isinstance(value, str):
        yield from (f"x{'y' * longest}" for longest in LONG)
        yield from ("y" * longest for longest in LONG)
        yield from (
            " ",
            "a\x07",
            "a\nb",
            "a\n",
            "\ud800",
            "/a/b.exr",
            "a/b.exr",
            "C:\\a\\b",
            "C:a",
            "//a/b",
            "\\a",
        )
        yield from (
            "\\\\host\\share\\x",
            "#12345G",
            "#123456",
            "2024-05-31",
            "31.5.2024",
            "2024-05-31\n",
            "0" * 64,
        )
        yield from (value + "\n", value.upper(), f"{value} ")
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        yield from (0, 2, 10, 0.1, float(value), value * 1.0001, -value, str(value), [value])
    if isinstance(value, list):
        yield value[:-1]
        yield [*value, *value[-1:]]
        yield value * 40
        yield {str(index): item for index, item in enumerate(value)}
    if isinstance(value, dict):
        yield {**value, "unknown": 1}
        for key in value:
            yield {name: item for name, item in value.items() if name != key}
            yield {**value, key: None}


@contextmanager
def changed(document: Any, path: tuple[Any, ...], mutant: Any) -> Iterator[Any]:
    """Give a document with another value at a place, in the body."""
    if not path:
        yield mutant
        return
    holder = at(document, path[:-1])
    before = holder[path[-1]]
    holder[path[-1]] = mutant
    yield document
    holder[path[-1]] = before


def disagreement(name: str, document: Any) -> str | None:
    """Return how schema and reader differ about a document; None where they agree, or the reader states its rule."""
    known = FORMATS[name]
    said, valid = refusal(known, document), VALIDATORS[name].is_valid(document)
    if said is None and not valid:
        error = next(VALIDATORS[name].iter_errors(document))
        return f"the reader takes it, the schema does not: {error.json_path}: {error.message[:300]}"
    if said is not None and valid and not re.search(known.rules, said):
        return f"the schema takes it, the reader does not: {said[:300]}"
    return None


@pytest.mark.parametrize("name", sorted(FORMATS))
def test_schema_and_reader_agree_about_every_change_of_a_document(name: str) -> None:
    tried, wrong = 0, []
    for sample in FORMATS[name].samples:
        document = json.loads(json.dumps(sample))  # without tuples, and of its own
        assert disagreement(name, sample) is None
        assert VALIDATORS[name].is_valid(sample)
        for path in places(sample):
            if path and path[-1] == "version":
                continue  # older ones are read, by being brought up to date, and have no schema
            for mutant in mutants(sample, path):
                tried += 1
                with changed(document, path, mutant) as other:
                    found = disagreement(name, other)
                if found is not None:
                    wrong.append(f"{path} = {str(mutant)[:60]!r}: {found}")
    assert not wrong, "\n".join(wrong)
    assert tried > 300


@pytest.mark.parametrize("name", sorted(FORMATS))
def test_older_versions_that_need_no_change_are_valid_and_newer_ones_are_not(name: str) -> None:
    sample = FORMATS[name].samples[0]
    for version in (0, -1, sample["version"] + 1, "1", True, 1.5, None):
        document = sample | {"version": version}
        assert refusal(FORMATS[name], document) is not None
        assert not VALIDATORS[name].is_valid(document)
    lowest = VALIDATORS[name].schema
    shown = json.dumps(lowest)
    for version in range(1, sample["version"]):
        if VALIDATORS[name].is_valid(sample | {"version": version}):
            assert refusal(FORMATS[name], sample | {"version": version}) is None
    assert f'"{sample["format"]}"' in shown


def strategy(schema: dict[str, Any], root: dict[str, Any]) -> st.SearchStrategy[Any]:
    """Return what draws values that a schema takes, as far as the suite's schemas go."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        return st.deferred(lambda: strategy(root["$defs"][name], root))
    if "const" in schema:
        return st.just(schema["const"])
    if "enum" in schema:
        return st.sampled_from(schema["enum"])
    kind = schema.get("type")
    branches = schema.get("oneOf") or schema.get("anyOf")
    if branches and kind is None:
        return st.one_of([strategy(one, root) for one in branches])
    if kind == "object":
        whole = [_merged(schema, branch) for branch in branches] if branches else [schema]
        return st.one_of([_object(one, root) for one in whole])
    if kind == "array":
        return _array(schema, root)
    if kind == "string":
        return _text(schema)
    if kind == "number":
        low, high = schema.get("minimum", -1e3), schema.get("maximum", 1e3)
        whole = (
            st.integers(math.ceil(low), math.floor(min(high, 1e12)))
            if math.ceil(low) <= high
            else st.nothing()
        )
        return st.floats(low, high) | whole
    if kind == "integer":
        return st.integers(schema["minimum"], min(schema.get("maximum", 1000), 1000))
    return {"boolean": st.booleans(), "null": st.none()}[str(kind)]


def _merged(schema: dict[str, Any], branch: dict[str, Any]) -> dict[str, Any]:
    left_out = branch.get("not", {}).get("required", [])
    properties = {
        name: {**(one if "$ref" in one or "anyOf" in one else {}), **one}
        for name, one in schema.get("properties", {}).items()
        if name not in left_out
    }
    for name, one in branch.get("properties", {}).items():
        before = properties.get(name, {})
        both = next(
            (alike for alike in before.get("anyOf", ()) if one.get("type") == "object" and "$ref" in alike),
            None,
        )
        properties[name] = both or one
    required = {*schema.get("required", ()), *branch.get("required", ())}
    return {"type": "object", "properties": properties, "required": sorted(required)}


def _object(schema: dict[str, Any], root: dict[str, Any]) -> st.SearchStrategy[Any]:
    drawn = {name: strategy(one, root) for name, one in schema["properties"].items()}
    required = {name: drawn[name] for name in schema.get("required", ())}
    optional = {name: one for name, one in drawn.items() if name not in required}
    return st.fixed_dictionaries(required, optional=optional)


def _array(schema: dict[str, Any], root: dict[str, Any]) -> st.SearchStrategy[Any]:
    if "prefixItems" in schema:
        return st.tuples(*(strategy(one, root) for one in schema["prefixItems"])).map(list)
    least = schema.get("minItems", 0)
    most = min(schema.get("maxItems", least + 2), least + 2)
    if "items" not in schema or most == 0:
        return st.just([])
    return st.lists(strategy(schema["items"], root), min_size=least, max_size=most)


def _text(schema: dict[str, Any]) -> st.SearchStrategy[str]:
    pattern = schema.get("pattern", "")
    known = {"^(/": "/a/b.exr", "^project": "project:files/a.exr", "^[0-9a-f]": "0" * 64, "^(#": "#00ff88"}
    known |= {"^[A-Za-z0-9][": "booth", "^([0-9]{4}": "2024-05-31"}
    for start, sample in known.items():
        if pattern.startswith(start):
            return st.just(sample)
    shown = st.characters(exclude_categories=("Cc", "Cs"))
    found = st.text(shown, max_size=min(schema["maxLength"], 20))
    return found.filter(str.strip) if pattern else found


@pytest.mark.parametrize("name", sorted(FORMATS))
@settings(suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much])
@given(data=st.data())
def test_what_a_schema_describes_is_read_and_what_is_written_is_valid(name: str, data: st.DataObject) -> None:
    schema = VALIDATORS[name].schema
    document = data.draw(strategy(schema, schema))
    assert disagreement(name, document) is None
    known = FORMATS[name]
    if known.write is not None and refusal(known, document) is None:
        written = json.loads(json.dumps(known.write(known.read(document))))
        errors = [f"{one.json_path}: {one.message[:200]}" for one in VALIDATORS[name].iter_errors(written)]
        assert errors == []


@pytest.mark.parametrize(
    "change",
    [
        lambda value: value.pop("results"),
        lambda value: value.update(version=2),
        lambda value: value.update(version=True),
        lambda value: value.update(default_count="11"),
        lambda value: value.update(default_count=True),
        lambda value: value["results"][0].update(exponents=[0.5]),
        lambda value: value["results"][0].update(exponents=["1"]),
        lambda value: value["results"][0].update(exponents=[True]),
        lambda value: value["results"][0].pop("exponents"),
    ],
)
def test_a_damaged_basis_is_refused_by_schema_and_reader(
    change: Callable[[Any], object], tmp_path: Path
) -> None:
    document = json.loads(resource("basis", "search.json").read_text(encoding="utf-8"))
    change(document)
    (tmp_path / "basis.json").write_text(json.dumps(document))
    with pytest.raises(SuiteError):
        stored_bases(tmp_path / "basis.json")
    assert not VALIDATORS["lobe_basis"].is_valid(document)
