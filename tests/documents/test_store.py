"""Documents through JSON and files and back."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from brdf_suite.documents import cook_torrance as cook_torrance_module
from brdf_suite.documents import paint as paint_module
from brdf_suite.documents import view as view_module
from brdf_suite.documents import view_settings
from brdf_suite.documents.cook_torrance import (
    DISTRIBUTION_NORMS,
    Clearcoat,
    CookTorranceLobe,
    CookTorrancePaint,
)
from brdf_suite.documents.paint import (
    INTERPOLATIONS,
    OUT_OF_PLANE,
    Flakes,
    Gloss,
    Measurement,
    OrangePeel,
    Paint,
    TextureTargets,
    solid_paint,
)
from brdf_suite.documents.parameter import Parameter
from brdf_suite.documents.store import (
    any_paint_from_json,
    load_any_paint,
    load_paint,
    load_view,
    paint_from_json,
    paint_to_json,
    save_paint,
    save_view,
    view_from_json,
    view_to_json,
)
from brdf_suite.documents.view import (
    BACKGROUNDS,
    EXPOSURE_MODES,
    FRESNEL_MODES,
    LOOK_UPS,
    TONE_CURVES,
    Camera,
    View,
)
from brdf_suite.documents.view_settings import (
    COMPARE_BASES,
    COMPARE_MODES,
    ILLUMINANTS,
    LAMP_KINDS,
    LENGTH_UNITS,
    MASK_PROJECTIONS,
    NORMALS_MODES,
    SPARKLE_MODES,
    UP_AXES,
    Compare,
    Lamp,
    Lens,
    LightColour,
    PartMaterial,
    Relief,
    Sparkle,
    SurfaceLook,
    TwoTone,
)
from brdf_suite.errors import DocumentError


def numbers(parameter: Parameter) -> st.SearchStrategy[float]:
    return st.floats(parameter.low, parameter.high, allow_nan=False)


def line(longest: int) -> st.SearchStrategy[str]:
    characters = st.characters(exclude_categories=("Cs", "Cc"))
    return st.text(characters, min_size=1, max_size=longest).filter(lambda text: bool(text.strip()))


P, V = paint_module.PARAMETERS, view_module.PARAMETERS
S = view_settings.PARAMETERS
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
    out_of_plane=st.sampled_from(OUT_OF_PLANE),
    # The highest waves that the steepest slope leaves at the shortest wavelength are 6.9 µm.
    orange_peel=st.none()
    | st.builds(OrangePeel, st.floats(0.0, 6.9), numbers(P["orange_peel.wavelength_mm"])),
    texture=st.none()
    | st.builds(
        TextureTargets,
        *(st.none() | numbers(P[f"texture.{n}"]) for n in ("grade_15", "grade_45", "grade_75", "graininess")),
    ),
)
C = cook_torrance_module.PARAMETERS
lobes = st.builds(
    CookTorranceLobe,
    st.tuples(*[numbers(C["lobes[].ks"])] * 3),
    numbers(C["lobes[].m"]),
    numbers(C["lobes[].r"]),
)
cook_torrance_paints = st.builds(
    CookTorrancePaint,
    name=line(200),
    kd=st.tuples(*[numbers(C["kd"])] * 3),
    lobes=st.lists(lobes, max_size=16).map(tuple),
    d_norm=st.sampled_from(DISTRIBUTION_NORMS),
    clearcoat=st.none()
    | st.builds(Clearcoat, numbers(C["clearcoat.ior"]), numbers(C["clearcoat.roughness"])),
    flakes=st.none() | st.builds(Flakes, numbers(P["flakes.density_per_mm2"])),
    notes=st.just("") | line(80),
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
    turntable_deg_s=numbers(V["turntable_deg_s"]),
    exposure_ev=numbers(V["exposure_ev"]),
    tone_curve=st.sampled_from(TONE_CURVES),
    background=st.sampled_from(BACKGROUNDS),
    fresnel=st.sampled_from(FRESNEL_MODES),
    look_up=st.sampled_from(LOOK_UPS),
    exposure_mode=st.sampled_from(EXPOSURE_MODES),
    background_colour=st.tuples(*[st.floats(0.0, 1.0)] * 3),
    clipping_marks=st.booleans(),
    gamut_marks=st.booleans(),
    light_colour=st.builds(LightColour, illuminant=st.sampled_from(ILLUMINANTS), adapted=st.booleans()),
    lamps=st.lists(
        st.builds(
            Lamp,
            kind=st.sampled_from(LAMP_KINDS),
            position=st.tuples(*[numbers(S["lamp.position"])] * 3),
            azimuth_deg=numbers(S["lamp.azimuth_deg"]),
            elevation_deg=numbers(S["lamp.elevation_deg"]),
            strength=numbers(S["lamp.strength"]),
            temperature_k=numbers(S["lamp.temperature_k"]),
            diameter=numbers(S["lamp.diameter"]),
            angle_deg=numbers(S["lamp.angle_deg"]),
        ),
        max_size=2,
    ).map(tuple),
    lens=st.builds(
        Lens,
        f_number=numbers(S["lens.f_number"]),
        focus_distance=st.none() | numbers(S["lens.focus_distance"]),
        turn_deg=numbers(S["lens.turn_deg"]),
    ),
    sparkle=st.builds(
        Sparkle,
        mode=st.sampled_from(SPARKLE_MODES),
        light_count=st.integers(1, 16),
        strength=st.floats(0, 8),
    ),
    surface_look=st.builds(
        SurfaceLook,
        unit=st.sampled_from(LENGTH_UNITS),
        up=st.sampled_from(UP_AXES),
        scale=numbers(S["surface.scale"]),
        recentre=st.booleans(),
        flip_normals=st.booleans(),
        normals=st.sampled_from(NORMALS_MODES),
        materials=st.sampled_from(
            [(), (PartMaterial("door", "second_paint"), PartMaterial("glas ü", "glass"))]
        ),
        occlusion=st.booleans(),
        ground=st.booleans(),
    ),
    relief=st.builds(
        Relief,
        normal_map=st.sampled_from([None, "/n.png"]),
        normal_strength=numbers(S["relief.normal_strength"]),
        normal_width_mm=numbers(S["relief.normal_width_mm"]),
        orange_peel=numbers(S["relief.orange_peel"]),
        orange_peel_mm=numbers(S["relief.orange_peel_mm"]),
    ),
    two_tone=st.builds(
        TwoTone,
        paint=st.sampled_from([None, "red", "/p.brdfpaint"]),
        mask=st.sampled_from([None, "/m.png"]),
        mask_width_mm=numbers(S["two_tone.mask_width_mm"]),
        projection=st.sampled_from(MASK_PROJECTIONS),
    ),
    compare=st.builds(
        Compare,
        mode=st.sampled_from(COMPARE_MODES),
        paint=st.sampled_from([None, "red"]),
        divider=numbers(S["compare.divider"]),
        rate_hz=numbers(S["compare.rate_hz"]),
        scale_delta_e=numbers(S["compare.scale_delta_e"]),
        basis=st.sampled_from(COMPARE_BASES),
    ),
)
in_one_folder = settings(suppress_health_check=[HealthCheck.function_scoped_fixture])


@in_one_folder
@given(paints)
def test_a_paint_survives_the_file(tmp_path: Path, paint: Paint) -> None:
    path = tmp_path / "a.brdfpaint"
    save_paint(paint, path)
    assert load_paint(path) == paint
    assert paint_from_json(json.loads(json.dumps(paint_to_json(paint)))) == paint


@in_one_folder
@given(cook_torrance_paints)
def test_a_cook_torrance_paint_survives_the_file(tmp_path: Path, paint: CookTorrancePaint) -> None:
    path = tmp_path / "a.brdfpaint"
    save_paint(paint, path)
    assert load_any_paint(path) == paint
    assert any_paint_from_json(json.loads(json.dumps(paint_to_json(paint)))) == paint


def test_any_paint_may_be_aspecular(tmp_path: Path) -> None:
    path = tmp_path / "a.brdfpaint"
    save_paint(solid_paint("white", (95.0, 0.0, 1.0)), path)
    assert load_any_paint(path) == load_paint(path)


def test_a_paint_of_another_kind_is_refused_where_readings_are_wanted(tmp_path: Path) -> None:
    path = tmp_path / "a.brdfpaint"
    save_paint(CookTorrancePaint("fit", (0.1, 0.1, 0.1)), path)
    with pytest.raises(DocumentError, match="kind: holds a Cook-Torrance paint"):
        load_paint(path)


@pytest.mark.parametrize(
    ("fields", "place"),
    [
        ({"kd": [0.1, 0.1]}, "kd"),
        ({"kd": [0.1, 0.1, -0.1]}, r"kd\[2\]"),
        ({"lobes": [{"ks": [0, 0, 0], "m": 0.0, "r": 0.5}]}, r"lobes\[0\]\.m"),
        ({"lobes": [{"ks": [0, 0, 0], "m": 0.1, "r": 1.5}]}, r"lobes\[0\]\.r"),
        ({"lobes": [{"ks": [0, float("nan"), 0], "m": 0.1, "r": 0.5}]}, r"lobes\[0\]\.ks\[1\]"),
        ({"lobes": [{"m": 0.1, "r": 0.5}]}, r"lobes\[0\]"),
        ({"lobes": {}}, "lobes"),
        ({"lobes": [{"ks": [0, 0, 0], "m": 0.1, "r": 0.5}] * 17}, "lobes"),
        ({"d_norm": "half"}, "d_norm"),
        ({"clearcoat": {"ior": 0.5}}, r"clearcoat\.ior"),
        ({"clearcoat": 3}, "clearcoat"),
        ({"flakes": []}, "flakes"),
        ({"gloss": {"gu_20": 90}}, "the top level"),
    ],
)
def test_a_bad_field_of_a_cook_torrance_paint_is_named(fields: dict, place: str) -> None:
    value = {**paint_to_json(CookTorrancePaint("fit", (0.1, 0.1, 0.1))), **fields}
    with pytest.raises(DocumentError, match=f"x, at {place}:"):
        any_paint_from_json(value, "x")


@in_one_folder
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
    assert (value["format"], value["version"], value["kind"]) == ("brdfpaint", 6, "aspecular")
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
