"""Studios and skies as documents: kept as they are, refused with their place; Views with a layout."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import pytest

from brdf_suite.documents.store import load_view, save_view, view_from_json
from brdf_suite.documents.studio import (
    Backdrop,
    BoothRoom,
    Sky,
    Studio,
    StudioLamp,
    light_from_json,
    light_to_json,
    load_light,
    save_light,
)
from brdf_suite.documents.view import View
from brdf_suite.errors import DocumentError, FileError

STUDIO = Studio(
    "Mine",
    (
        StudioLamp("box", (0.0, 2.0, 0.0), (1.0, 2.0), (0.0, -1.0, 0.0), colour_temperature_k=3200.0),
        StudioLamp("ring", (1.0, 1.0, 1.0), (1.0, 0.1), roll_deg=5.0),
    ),
    room=BoothRoom(),
    unit="relative",
)
SKY = Sky("Evening", "preetham", 4.0, 12.0, -30.0, 0.1, False)


@pytest.mark.parametrize(
    "light", [STUDIO, SKY, Studio("Void", STUDIO.lamps, backdrop=Backdrop(0.0)), Sky("plain")]
)
def test_what_is_saved_is_what_is_read(tmp_path: Path, light: Studio | Sky) -> None:
    save_light(light, tmp_path / "a.brdfstudio")
    assert load_light(tmp_path / "a.brdfstudio") == light
    assert list(tmp_path.iterdir()) == [tmp_path / "a.brdfstudio"]


def changed(path: tuple[str | int, ...], value: object, light: Studio | Sky = STUDIO) -> dict[str, object]:
    document = copy.deepcopy(light_to_json(light))
    target = document
    for step in path[:-1]:
        target = target[step]  # type: ignore[index, assignment] - a path into JSON
    target[path[-1]] = value  # type: ignore[index] - the same
    return document


@pytest.mark.parametrize(
    ("document", "place", "words"),
    [
        (changed(("lamps", 1, "shape"), "disc"), "lamps[1].shape", "box, strip, ring"),
        (changed(("lamps", 1, "size_m"), [1.0, 0.6]), "lamps[1].size_m", "half as wide"),
        (changed(("lamps", 0, "size_m"), [1.0]), "lamps[0].size_m", "2 numbers"),
        (changed(("lamps", 0, "position_m", 1), float("nan")), "lamps[0].position_m[1]", "finite"),
        (changed(("lamps", 0, "position_m"), [0, 9, 0]), "lamps[0].position_m", "outside of the room"),
        (changed(("lamps", 0, "position_m"), [0, 0, 0.01]), "lamps[0].position_m", "0.1 m or more"),
        (changed(("lamps", 0, "facing"), [0, 0, 0]), "lamps[0].facing", "no direction"),
        (
            changed(("lamps", 0, "colour_temperature_k"), 500),
            "lamps[0].colour_temperature_k",
            "1000 to 25000",
        ),
        (changed(("lamps", 0, "luminence"), 5), "lamps[0]", "luminence"),
        (changed(("lamps",), []), "lamps", "nothing gives light"),
        (changed(("lamps",), [light_to_json(STUDIO)["lamps"][0]] * 65), "lamps", "64"),  # type: ignore[index]
        (changed(("backdrop",), {"luminance": 1.0}), "room", "only one"),
        (changed(("room",), None), "room", "only one"),
        (changed(("room", "eye_height_m"), 5.0), "room.eye_height_m", "below the ceiling"),
        (changed(("room", "wall_albedo"), 1.2), "room.wall_albedo", "0.95"),
        (changed(("unit",), "cd"), "unit", "kcd/m2"),
        (changed(("kind",), "moon"), "kind", "studio"),
        (changed(("version",), 2), "version", "newer"),
        (changed(("model",), "perez", SKY), "model", "hosek_wilkie"),
        (changed(("turbidity",), 1.8, SKY), "turbidity", "1.9"),
        (changed(("turbidity",), 40, SKY), "turbidity", "10"),
        (changed(("sun_elevation_deg",), -5, SKY), "sun_elevation_deg", "range"),
        (changed(("sun_disc",), 1, SKY), "sun_disc", "true or false"),
    ],
)
def test_a_fault_is_refused_with_its_place(document: dict[str, object], place: str, words: str) -> None:
    with pytest.raises(DocumentError) as caught:
        light_from_json(document, "x.brdfstudio")
    assert caught.value.place == place
    assert words in str(caught.value)


def test_a_file_that_is_no_document_is_refused(tmp_path: Path) -> None:
    for content in (b"", b"{", b"\x76\x2f\x31\x01", b"[1]", json.dumps({"format": "brdfpaint"}).encode()):
        (tmp_path / "x.brdfstudio").write_bytes(content)
        with pytest.raises(DocumentError):
            load_light(tmp_path / "x.brdfstudio")
    with pytest.raises(FileError):
        load_light(tmp_path / "none.brdfstudio")


def test_a_view_keeps_the_layout_and_older_ones_are_read(tmp_path: Path) -> None:
    view = View(environment="/maps/ball.hdr", environment_layout="mirror_ball")
    save_view(view, tmp_path / "v.brdfview")
    assert load_view(tmp_path / "v.brdfview") == view
    first = json.loads((tmp_path / "v.brdfview").read_text())
    kept = ("format", "camera", "environment", "surface", "rotation_deg", "exposure_ev", "tone_curve")
    old = view_from_json({**{name: first[name] for name in kept}, "version": 1, "fresnel": True})
    assert old.environment_layout == "auto"
    with pytest.raises(DocumentError, match="environment_layout"):
        view_from_json({**first, "environment_layout": "ball"})
