"""Documents through JSON and files and back."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from brdf_suite.documents import paint as paint_module
from brdf_suite.documents import view as view_module
from brdf_suite.documents.paint import INTERPOLATIONS, Flakes, Gloss, Measurement, Paint, solid_paint
from brdf_suite.documents.parameter import Parameter
from brdf_suite.documents.store import (
    load_paint,
    load_view,
    paint_from_json,
    paint_to_json,
    save_paint,
    save_view,
    view_from_json,
    view_to_json,
)
from brdf_suite.documents.view import BACKGROUNDS, TONE_CURVES, Camera, View


def numbers(parameter: Parameter) -> st.SearchStrategy[float]:
    return st.floats(parameter.low, parameter.high, allow_nan=False)


def line(longest: int) -> st.SearchStrategy[str]:
    characters = st.characters(exclude_categories=("Cs", "Cc"))
    return st.text(characters, min_size=1, max_size=longest).filter(lambda text: bool(text.strip()))


P, V = paint_module.PARAMETERS, view_module.PARAMETERS
labs = st.tuples(*(numbers(P[f"lab[{i}]"]) for i in range(3)))
measurements = st.lists(
    st.builds(Measurement, st.floats(0.0, 60.0), st.floats(-25.0, 89.0), labs),
    min_size=3,
    max_size=8,
    unique_by=lambda m: (round(m.illumination_deg, 6), round(m.aspecular_deg, 6)),
).map(tuple)
paints = st.builds(
    Paint,
    name=line(200),
    measurements=measurements,
    gloss=st.builds(Gloss, numbers(P["gloss.gu_20"]), st.none() | numbers(P["gloss.gu_60"])),
    flakes=st.none()
    | st.builds(
        Flakes,
        *(numbers(P[f"flakes.{n}"]) for n in ("density_per_mm2", "size_um", "roughness", "colour_spread")),
    ),
    interpolation=st.sampled_from(INTERPOLATIONS),
    near_specular=numbers(P["near_specular"]),
    notes=st.just("") | line(80) | st.just("two\nlines\tand a tab"),
    source=st.just("") | line(80),
)
cameras = st.builds(
    Camera,
    azimuth_deg=numbers(V["camera.azimuth_deg"]),
    elevation_deg=numbers(V["camera.elevation_deg"]),
    distance=st.none() | numbers(V["camera.distance"]),
    target=st.none() | st.tuples(*[numbers(V["camera.target"])] * 3),
    focal_length_mm=numbers(V["camera.focal_length_mm"]),
)
views = st.builds(
    View,
    camera=cameras,
    environment=st.sampled_from(["booth", "/a/ü b.exr"]),
    surface=st.sampled_from(["car", "/x/y.glb"]),
    rotation_deg=numbers(V["rotation_deg"]),
    exposure_ev=numbers(V["exposure_ev"]),
    tone_curve=st.sampled_from(TONE_CURVES),
    background=st.sampled_from(BACKGROUNDS),
    fresnel=st.booleans(),
)
few = settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@few
@given(paints)
def test_a_paint_survives_the_file(tmp_path: Path, paint: Paint) -> None:
    path = tmp_path / "a.brdfpaint"
    save_paint(paint, path)
    assert load_paint(path) == paint
    assert paint_from_json(json.loads(json.dumps(paint_to_json(paint)))) == paint


@few
@given(views)
def test_a_view_survives_the_file(tmp_path: Path, view: View) -> None:
    path = tmp_path / "a.brdfview"
    save_view(view, path)
    assert load_view(path) == view
    assert view_from_json(json.loads(json.dumps(view_to_json(view)))) == view


def test_the_file_is_what_the_format_says(tmp_path: Path) -> None:
    path = tmp_path / "white.brdfpaint"
    save_paint(solid_paint("Weiß", (95.0, 0.0, 1.0)), path)
    text = path.read_text(encoding="utf-8")
    assert "Weiß" in text, "readable, not escaped"
    assert text.endswith("}\n")
    value = json.loads(text)
    assert (value["format"], value["version"], value["kind"]) == ("brdfpaint", 1, "aspecular")
    assert value["measurements"][2] == {
        "illumination_deg": 45.0,
        "aspecular_deg": 110.0,
        "lab": [95.0, 0.0, 1.0],
    }


def test_fields_with_a_default_may_be_left_out() -> None:
    value = {
        "format": "brdfpaint",
        "version": 1,
        "kind": "aspecular",
        "name": "short",
        "measurements": [
            {"illumination_deg": 45, "aspecular_deg": angle, "lab": [50, 0, 0]} for angle in (15, 45, 110)
        ],
        "gloss": {"gu_20": 90},
    }
    assert paint_from_json(value) == solid_paint("short", (50.0, 0.0, 0.0), Gloss(90.0))


def test_saving_keeps_the_mode_and_follows_a_link(tmp_path: Path) -> None:
    real = tmp_path / "real.brdfpaint"
    link = tmp_path / "link.brdfpaint"
    save_paint(solid_paint("one", (50.0, 0.0, 0.0)), real)
    real.chmod(0o640)
    link.symlink_to(real)
    save_paint(solid_paint("two", (50.0, 0.0, 0.0)), link)
    assert link.is_symlink()
    assert load_paint(real).name == "two"
    assert real.stat().st_mode & 0o777 == 0o640


@pytest.mark.skipif(os.name == "nt", reason="modes are POSIX")
def test_a_new_file_obeys_the_umask(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        save_paint(solid_paint("one", (50.0, 0.0, 0.0)), tmp_path / "a.brdfpaint")
    finally:
        os.umask(before)
    assert (tmp_path / "a.brdfpaint").stat().st_mode & 0o777 == 0o640
