"""Pictures of paints for palettes: the renderer's own, their keys, the flat forms, and the process that draws them."""

from __future__ import annotations

import base64
import io
import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_display
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Flakes, Gloss, OrangePeel, solid_paint
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.palette_store import entry_to_json
from brdf_suite.documents.view_settings import LightColour
from brdf_suite.errors import GraphicsError, ValueRangeError
from brdf_suite.lighting.environment import SMALL_COLUMNS
from brdf_suite.output.still import loaded_scene
from brdf_suite.palettes.swatches.look import Form, SwatchLook, swatch_key
from brdf_suite.palettes.swatches.pictures import SwatchPainter
from brdf_suite.palettes.swatches.process import serve
from brdf_suite.palettes.swatches.store import SwatchStore
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_shipped_paint, material_of
from brdf_suite.realtime.pictures.captured import CapturedForm, CapturedPaint

SIZE = 24
IMPOSSIBLE = replace(solid_paint("black", (0.0, 0.0, 0.0)), gloss=Gloss(150.0))


def codes_of(lab: tuple[float, float, float]) -> list[int]:
    encoded = np.clip(working_to_display(lab_to_working(lab)), 0.0, 1.0)
    return np.rint(255.0 * encoded).astype(int).tolist()


@pytest.mark.parametrize("form", ["sphere", "speed_form"])
def test_pictures_are_those_of_the_viewer_and_the_command(shared_cache: Path, form: Form) -> None:
    # Flakes are tested where a form is captured; here they would have more shaders compiled than all else takes.
    blue = replace(load_shipped_paint("blue"), flakes=None)
    contents = [
        blue,
        replace(blue, orange_peel=OrangePeel(2.0, 4.0)),
        IMPOSSIBLE,
        FlatColour("ink", "RGB", (0.9, 0.2, 0.1)),
    ]
    look = SwatchLook(form, size=SIZE)
    with SwatchPainter() as painter:
        pictures = painter.draw(contents, look)
    assert [picture.key for picture in pictures] == [swatch_key(content, look) for content in contents]
    assert pictures[2].pixels is None
    assert pictures[2].problem
    size = (SIZE, SIZE)
    with loaded_scene(look.view(), columns=SMALL_COLUMNS) as loaded:
        view = loaded.composed(look.view(), size)
        for place in (0, 1):
            picture, content = pictures[place].pixels, contents[place]
            assert picture is not None
            loaded.scene.set_material(fit_material(material_of(content)))  # type: ignore[arg-type]
            alone = loaded.scene.image(view, size)
            assert np.abs(picture.astype(int) - alone).max() <= 1
    ink = pictures[3].pixels
    assert ink is not None
    middle = ink[SIZE // 2, SIZE // 2].astype(int)
    assert middle[0] > 2 * middle[1] > 0


def test_the_key_follows_what_is_seen() -> None:
    paint = load_shipped_paint("red")
    look = SwatchLook()
    key = swatch_key(paint, look)
    assert len(key) == 64
    assert swatch_key(replace(paint, name="other", notes="n", source="s"), look) == key
    others = [
        swatch_key(paint.with_lab(45.0, (40.0, 1.0, 2.0)), look),
        swatch_key(replace(paint, gloss=Gloss(80.0)), look),
        swatch_key(replace(paint, flakes=Flakes(density_per_mm2=3.0)), look),
        swatch_key(replace(paint, near_specular=2.0), look),
        swatch_key(paint, SwatchLook("panel")),
        swatch_key(paint, SwatchLook(environment="sunny")),
        swatch_key(paint, SwatchLook(size=97)),
        swatch_key(paint, SwatchLook(light_colour=LightColour("A", False))),
        swatch_key(paint, SwatchLook("chips")),
        swatch_key(paint, SwatchLook("chips", angles_deg=(15.0,))),
    ]
    assert len({key, *others}) == len(others) + 1
    # The angles are those of the chips alone, and these stand in no light.
    assert swatch_key(paint, SwatchLook(angles_deg=(15.0,))) == key
    assert swatch_key(paint, SwatchLook("chips", "sunny")) == others[8]


def test_a_file_of_light_that_has_changed_makes_other_keys(tmp_path: Path) -> None:
    light = tmp_path / "light.exr"
    light.write_bytes(b"one")
    paint = load_shipped_paint("red")
    before = swatch_key(paint, SwatchLook(environment=str(light)))
    light.write_bytes(b"another")
    assert swatch_key(paint, SwatchLook(environment=str(light))) != before


@pytest.mark.parametrize(
    "wrong",
    [
        {"form": "cube"},
        {"size": 15},
        {"size": 513},
        {"size": 20.5},
        {"angles_deg": ()},
        {"angles_deg": (170.0,)},
    ],
)
def test_looks_that_cannot_be_are_refused(wrong: dict[str, object]) -> None:
    with pytest.raises(ValueRangeError):
        SwatchLook(**wrong)  # type: ignore[arg-type]


def test_chips_show_the_readings_and_the_strip_runs_between_them() -> None:
    blue = load_shipped_paint("blue")
    with SwatchPainter() as painter:
        (chips,) = painter.draw([blue], SwatchLook("chips", size=30, angles_deg=(15.0, 45.0, 110.0)))
        (strip,) = painter.draw([blue], SwatchLook("flop_strip", size=20))
        (tinted,) = painter.draw([blue], SwatchLook("chips", size=16, light_colour=LightColour("A", False)))
        (refused,) = painter.draw([IMPOSSIBLE], SwatchLook("flop_strip"))
    assert chips.pixels is not None
    assert strip.pixels is not None
    assert tinted.pixels is not None
    for place, angle in enumerate((15.0, 45.0, 110.0)):
        band = chips.pixels[:, 10 * place : 10 * place + 10]
        assert (band == codes_of(blue.lab_at(angle))).all()
    for column, angle in ((0, 15.0), (-1, 110.0)):
        assert strip.pixels[7, column] == pytest.approx(codes_of(blue.lab_at(angle)), abs=2)
    assert (strip.pixels[0] == strip.pixels[-1]).all()
    # In the light of a lamp to eyes used to day, red gains and blue loses.
    middle, plain = tinted.pixels[8, 8].astype(int), chips.pixels[8, 15].astype(int)
    assert middle[0] > plain[0]
    assert middle[2] < plain[2]
    assert refused.pixels is None
    assert refused.problem


def request(name: int, look: SwatchLook, contents: list[object]) -> str:
    items = [
        {"key": str(place)}
        | {k: v for k, v in entry_to_json(Entry(content)).items() if k in ("paint", "flat")}  # type: ignore[arg-type]
        for place, content in enumerate(contents)
    ]
    return json.dumps({"id": name, "look": look.to_json(), "items": items}) + "\n"


def test_the_process_answers_every_item_and_keeps_what_it_drew(own_cache: None) -> None:
    look = SwatchLook("chips", size=16)
    contents = [load_shipped_paint("red"), FlatColour("ink", "Lab", (50.0, 10.0, 0.0))]
    broken = json.dumps({"id": 3, "look": {**look.to_json(), "form": "cube"}, "items": [{"key": "z"}]}) + "\n"
    spoilt = (
        json.dumps({"id": 4, "look": look.to_json(), "items": [{"key": "y", "flat": {"name": 5}}]}) + "\n"
    )
    run = subprocess.run(
        [sys.executable, "-m", "brdf_suite.palettes.swatches.process"],
        input=request(1, look, contents) + broken + spoilt,
        capture_output=True,
        text=True,
        check=True,
    )
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    assert [(answer["id"], answer.get("key"), answer.get("done")) for answer in answers] == [
        (1, "0", None),
        (1, "1", None),
        (1, None, True),
        (3, "z", None),
        (3, None, True),
        (4, "y", None),
        (4, None, True),
    ]
    with SwatchPainter() as painter:
        drawn = painter.draw(contents, look)
    for answer, picture in zip(answers, drawn, strict=False):
        assert picture.pixels is not None
        assert base64.b64decode(answer["picture"]) == picture.pixels.tobytes()
    assert "form" in answers[3]["refused"]
    assert "model" in answers[5]["refused"]
    kept = SwatchStore().get([picture.key for picture in drawn])
    assert all((kept[picture.key] == picture.pixels).all() for picture in drawn)


def test_what_is_kept_is_not_drawn_again(tmp_path: Path) -> None:
    look = SwatchLook("sphere", "/nowhere/light.exr", 16)
    paint = load_shipped_paint("red")
    store = SwatchStore(tmp_path)
    picture = np.arange(16 * 16 * 3, dtype=np.uint16).astype(np.uint8).reshape(16, 16, 3)
    store.put({swatch_key(paint, look): picture})
    out = io.StringIO()
    serve(io.StringIO(request(1, look, [paint]) + request(2, look, [load_shipped_paint("blue")])), out, store)
    answers = [json.loads(line) for line in out.getvalue().splitlines()]
    assert base64.b64decode(answers[0]["picture"]) == picture.tobytes()
    assert answers[1] == {"id": 1, "done": True}
    # The other one would have to be drawn, in a light that is not there.
    assert answers[2]["id"] == 2
    assert "light.exr" in answers[2]["failed"]


def test_a_machine_without_graphics_is_reported_and_flat_forms_are_drawn(
    monkeypatch: pytest.MonkeyPatch, own_cache: None
) -> None:
    def none() -> None:
        raise GraphicsError("No OpenGL 3.3 context could be made.")

    monkeypatch.setattr("brdf_suite.pipeline.picture.create_context", none)
    red = load_shipped_paint("red")
    out = io.StringIO()
    lines = request(1, SwatchLook("flop_strip", size=16), [red]) + request(2, SwatchLook(size=16), [red])
    serve(io.StringIO(lines + request(3, SwatchLook("chips", size=16), [red])), out)
    answers = [json.loads(line) for line in out.getvalue().splitlines()]
    assert "picture" in answers[0]
    assert answers[1] == {"id": 1, "done": True}
    assert answers[2:] == [{"id": 2, "unavailable": "No OpenGL 3.3 context could be made."}]


def test_a_paint_that_the_renderer_does_not_take_costs_no_other_its_picture(
    monkeypatch: pytest.MonkeyPatch, shared_cache: Path
) -> None:
    shade = CapturedForm._shade

    def refusing(self: CapturedForm, number: int, swatch: CapturedPaint, *more: object) -> None:
        if swatch.flakes is not None and swatch.flakes.density_per_mm2 == 77.0:
            raise GraphicsError("too many lobes")
        shade(self, number, swatch, *more)  # type: ignore[arg-type]

    monkeypatch.setattr(CapturedForm, "_shade", refusing)
    red, odd = (replace(load_shipped_paint("solid_red"), flakes=flakes) for flakes in (None, Flakes(77.0)))
    with SwatchPainter() as painter:
        pictures = painter.draw([red, odd, red], SwatchLook("sphere", size=SIZE))
        assert [picture.problem for picture in pictures] == ["", "too many lobes", ""]
        first, last = pictures[0].pixels, pictures[2].pixels
        assert first is not None
        assert last is not None
        assert (first == last).all()
        with pytest.raises(GraphicsError, match="too many lobes"):
            painter.draw([odd], SwatchLook("sphere", size=SIZE))
