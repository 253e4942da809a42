"""Normal maps, orange peel and the second paint: where normals point, what lobes lose, which paint is where."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from brdf_suite.arrays import AnyArray
from brdf_suite.documents.paint import OrangePeel
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import PartMaterial, Relief, SurfaceLook, TwoTone
from brdf_suite.errors import ValueRangeError
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.gl.context import Context, draws_in_software
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.relief import textures as relief_textures
from brdf_suite.realtime.relief.textures import ReliefTextures, mask_coordinates
from brdf_suite.realtime.relief.values import MaskImage, PeelTile, SlopeMap
from brdf_suite.realtime.values import MeshPart

SIZE = (96, 64)
MAPPED = Relief(normal_map="/map.png", normal_width_mm=50.0)


def view(relief: Relief | None = None, **fields: Any) -> View:
    return View(
        camera=Camera(azimuth_deg=0.0, elevation_deg=0.0, distance=0.5, target=(0.0, 0.0, 0.0)),
        surface_look=SurfaceLook(occlusion=False),
        background="grey",
        fresnel="off",
        look_up="paper",
        relief=relief or Relief(),
        **fields,
    )


def sheet(scenes: Any, turn_deg: float = 0.0) -> MeshPart:
    """A square that looks along +z, with u and v in millimetres, turned on it by an angle."""
    part = scenes.sheet()
    c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
    flat = part.positions[:, :2] * 1000.0
    return replace(part, uvs=flat @ np.array([[c, -s], [s, c]]))


def up_light(scenes: Any) -> Any:
    """Light that grows with the direction's x, y and z in red, green and blue: a mirror shows where it looks."""
    return scenes.from_function(lambda d: 2.0 + d)


def middle(renderer: Renderer, shown: View) -> AnyArray:
    return renderer.linear_image(shown, SIZE)[32, 48, :3] - 2.0


def constant_slope(u: float, v: float) -> SlopeMap:
    return SlopeMap(np.broadcast_to(np.array([u, v]), (4, 8, 2)))


@pytest.mark.parametrize("turn_deg", [0.0, 90.0, 130.0])
def test_a_slope_leans_the_normal_in_the_plane_of_its_coordinates(
    renderer: Renderer, scenes: Any, turn_deg: float
) -> None:
    renderer.set_environment(up_light(scenes))
    renderer.set_material("paint", scenes.weights(kd=1.0))
    renderer.set_mesh([sheet(scenes, turn_deg)])
    renderer.relief.set_normal_map(constant_slope(0.5, 0.2))
    c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
    # u grows along (c, s): a surface that rises along u leans away from u.
    wanted = np.array([-0.5 * c + 0.2 * s, -0.5 * s - 0.2 * c, 1.0])
    wanted /= np.linalg.norm(wanted)
    assert middle(renderer, view(MAPPED)) == pytest.approx(wanted, abs=0.03)
    assert middle(renderer, view()) == pytest.approx([0, 0, 1], abs=0.03)
    strong = replace(MAPPED, normal_strength=0.0)
    assert middle(renderer, view(strong)) == pytest.approx([0, 0, 1], abs=0.03)


def test_the_map_is_tiled_in_millimetres_from_its_lower_edge(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(up_light(scenes))
    renderer.set_material("paint", scenes.weights(kd=1.0))
    renderer.set_mesh([sheet(scenes)])
    # Twice as wide as high, sloped in the lower half alone.
    slopes = np.zeros((32, 64, 2), np.float32)
    slopes[:16, :, 0] = 1.0
    renderer.relief.set_normal_map(SlopeMap(slopes))
    shown = view(replace(MAPPED, normal_width_mm=160.0))
    light = renderer.linear_image(shown, (200, 200))[..., 0] - 2.0
    # The sheet is 200 mm high, the picture 360 mm: rows of 1.8 mm, the origin in the middle; a tile is 80 mm high.
    for height_mm, leans in ((20, True), (60, False), (-20, False), (-60, True), (90, True)):
        row = round(100 - height_mm / 1.8)
        assert (light[row, 100] < -0.5) == leans, height_mm


def test_orange_peel_is_of_the_coat_alone(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(up_light(scenes))
    renderer.set_mesh([sheet(scenes)])
    slopes = np.broadcast_to(
        np.array([0.8, 0.6]), (16, 16, 2)
    )  # one sides of waves everywhere: mean square 1
    renderer.relief.set_peel(PeelTile(slopes, 4))
    peel = Relief(orange_peel=5.0, orange_peel_mm=4.0)
    renderer.set_material("paint", scenes.weights(kd=1.0))
    assert middle(renderer, view(peel)) == pytest.approx(middle(renderer, view()), abs=2e-3)
    renderer.set_material("paint", scenes.weights(gloss=1.0))
    moved = middle(renderer, view(peel))
    # Both look-ups of the tile lean by tan(5 deg) (.8, .6), one of them turned by 36 degrees, each over root two.
    turn = np.radians(36.0)
    one = np.array([0.8, 0.6])
    other = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]) @ one
    lean = np.array([*(-np.tan(np.radians(5.0)) * (one + other) / np.sqrt(2.0)), 1.0])
    lean /= np.linalg.norm(lean)
    mirror = 2.0 * lean[2] * lean - np.array([0, 0, 1])
    assert moved == pytest.approx(mirror, abs=0.03)


def test_a_paint_brings_its_own_orange_peel_and_the_view_overrides_it(
    renderer: Renderer, scenes: Any
) -> None:
    renderer.set_environment(up_light(scenes))
    renderer.set_mesh([sheet(scenes)])
    renderer.relief.set_peel(PeelTile(np.broadcast_to(np.array([0.8, 0.6]), (16, 16, 2)), 4))
    for name in ("paint", "paint_b"):
        renderer.set_material(name, scenes.weights(gloss=1.0))
    flat = middle(renderer, view())
    by_view = middle(renderer, view(Relief(orange_peel=5.0, orange_peel_mm=1.0)))
    renderer.relief.set_own_peel("paint", OrangePeel(13.92, 1.0))
    assert middle(renderer, view()) == pytest.approx(by_view, abs=4e-3)
    assert np.abs(by_view - flat).max() > 0.05
    slight = Relief(orange_peel=1.0, orange_peel_mm=1.0)
    overridden = middle(renderer, view(slight))
    # The paint that is compared with has a coat of its own.
    compared = renderer.linear_tile(view(), SIZE, (48, 30), (2, 2), materials={"paint": "paint_b"})
    assert compared[0, 0, :3] - 2.0 == pytest.approx(flat, abs=2e-3)
    renderer.relief.set_own_peel("paint", None)
    assert middle(renderer, view(slight)) == pytest.approx(overridden, abs=1e-6)
    assert middle(renderer, view()) == pytest.approx(flat, abs=1e-6)


def test_a_relief_too_fine_to_be_seen_is_gloss(renderer: Renderer, scenes: Any) -> None:
    # A dark world with a bright line: waves far below a pixel smear it, by twice their slopes, and do not sparkle.
    renderer.set_environment(
        scenes.from_function(lambda d: np.repeat(1.0 * (np.abs(d[..., :1]) < 0.02), 3, axis=-1), size=512)
    )
    renderer.set_material("paint", scenes.weights(gloss=1.0))
    renderer.set_mesh([sheet(scenes)])
    wave = np.sin(2 * np.pi * np.arange(64) / 64) * np.sqrt(2.0) * 0.1
    slopes = np.zeros((64, 64, 2), np.float32)
    slopes[..., 0] = wave
    renderer.relief.set_normal_map(SlopeMap(slopes))
    fine = renderer.linear_image(view(replace(MAPPED, normal_width_mm=0.1)), SIZE)[20:44, 30:66, 0]
    plain = renderer.linear_image(view(), SIZE)[20:44, 30:66, 0]
    assert plain.max() > 0.9
    assert fine.max() < 0.6  # the line is spread
    assert fine.min() > 0.02
    neighbours = np.abs(np.diff(fine, axis=1)).max()
    assert neighbours < 0.1  # and smooth


def test_relief_belongs_to_the_paint(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(up_light(scenes))
    renderer.set_material("glass", scenes.weights(kd=1.0))
    renderer.set_mesh([replace(sheet(scenes), material="glass")])
    renderer.relief.set_normal_map(constant_slope(1.0, 0.0))
    assert middle(renderer, view(MAPPED)) == pytest.approx([0, 0, 1], abs=0.03)


def test_without_texture_coordinates_the_surface_stays_plain(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(up_light(scenes))
    renderer.set_material("paint", scenes.weights(kd=1.0))
    renderer.set_mesh([scenes.sheet()])
    renderer.relief.set_normal_map(constant_slope(1.0, 0.0))
    assert middle(renderer, view(MAPPED)) == pytest.approx([0, 0, 1], abs=0.03)


TWO = TwoTone(paint="red", mask="/mask.png", mask_width_mm=200.0)


@pytest.fixture
def two_paints(renderer: Renderer, scenes: Any) -> Renderer:
    renderer.set_environment(scenes.constant())
    renderer.set_material("paint", scenes.weights(kd=0.2))
    renderer.set_material("second_paint", scenes.weights(kd=0.8))
    renderer.set_mesh([sheet(scenes)])
    return renderer


def test_two_paints_are_mixed_by_the_mask(two_paints: Renderer) -> None:
    share = np.tile(np.repeat([0.0, 1.0], 16), (8, 1))  # the right half, one tile from u = 0 to 200
    share[:, 8:16] = 0.5
    two_paints.relief.set_mask(MaskImage(share))
    picture = two_paints.linear_image(view(two_tone=TWO), (200, 200))
    row = picture[100, :, 0]
    # 1.8 mm a pixel: u = -80 is in the tile before, at 120; u = 20 is black, 70 is half.
    for u_mm, wanted in ((-40.0, 0.8), (20.0, 0.2), (75.0, 0.5)):
        assert row[round(100 + u_mm / 1.8)] == pytest.approx(wanted, abs=0.01), u_mm
    assert picture[100, 100, 3] == 1.0  # coverage stays whole
    assert two_paints.linear_image(view(), SIZE)[32, 48, 0] == pytest.approx(0.2, abs=2e-3)


def test_a_mask_over_the_box(two_paints: Renderer) -> None:
    share = np.zeros((8, 8))
    share[4:] = 1.0  # the upper half
    two_paints.relief.set_mask(MaskImage(share))
    column = two_paints.linear_image(view(two_tone=replace(TWO, projection="front")), (200, 200))[:, 100, 0]
    assert column[100 - 30] == pytest.approx(0.8, abs=0.01)
    assert column[100 + 30] == pytest.approx(0.2, abs=0.01)


def test_where_the_box_is_covered() -> None:
    bounds = Bounds((-1.0, 0.0, -2.0), (1.0, 1.5, 3.0))

    def at(projection: str, point: tuple[float, float, float]) -> AnyArray:
        shown = view(two_tone=replace(TWO, projection=projection))  # type: ignore[arg-type] # a choice
        values: Any = mask_coordinates(shown, bounds, 1.0)
        return np.array([np.dot(values["mask_u"], [*point, 1]), np.dot(values["mask_v"], [*point, 1])])

    # Seen from +x the front (+z) is on the left; from the top it is at the lower edge.
    np.testing.assert_allclose(at("side", (1, 0, 3)), [0, 0], atol=1e-6)
    np.testing.assert_allclose(at("side", (1, 1.5, -2)), [1, 1], atol=1e-6)
    np.testing.assert_allclose(at("front", (-1, 0, 3)), [0, 0], atol=1e-6)
    np.testing.assert_allclose(at("front", (1, 1.5, 0)), [1, 1], atol=1e-6)
    np.testing.assert_allclose(at("top", (-1, 1, 3)), [0, 0], atol=1e-6)
    np.testing.assert_allclose(at("top", (1, 1, -2)), [1, 1], atol=1e-6)


def test_a_part_has_the_second_paint_without_a_mask(two_paints: Renderer, scenes: Any) -> None:
    part = sheet(scenes)
    aside = part.positions + np.array([0.3, 0.0, 0.0], np.float32)
    two_paints.set_mesh([part, replace(part, name="lid", positions=aside)])
    worn = SurfaceLook(occlusion=False, materials=(PartMaterial("lid", "second_paint"),))
    for two_tone, wanted in ((TwoTone(paint="red"), 0.8), (TwoTone(), 0.2)):
        shown = replace(
            view(two_tone=two_tone), surface_look=worn, camera=Camera(0.0, 0.0, 2.0, (0.0, 0.0, 0.0))
        )
        picture = two_paints.linear_image(shown, (200, 200))[..., 0]
        assert picture[100, 100] == pytest.approx(0.2, abs=0.01)
        assert picture[100, 142] == pytest.approx(wanted, abs=0.01)


def test_half_a_plan_for_two_tone_is_one_paint(two_paints: Renderer) -> None:
    two_paints.relief.set_mask(MaskImage(np.ones((4, 4))))
    for two_tone in (TwoTone(paint="red"), TwoTone(mask="/mask.png")):
        found = two_paints.linear_image(view(two_tone=two_tone), SIZE)[32, 48, 0]
        assert found == pytest.approx(0.2, abs=2e-3)
    two_paints.relief.set_mask(None)
    assert two_paints.linear_image(view(two_tone=TWO), SIZE)[32, 48, 0] == pytest.approx(0.2, abs=2e-3)


def test_textures_are_given_back(renderer: Renderer) -> None:
    for _ in range(3):
        renderer.relief.set_normal_map(constant_slope(0.1, 0.1))
        renderer.relief.set_mask(MaskImage(np.ones((4, 4))))
        renderer.relief.set_peel(PeelTile(np.zeros((4, 4, 2)), 1))
    assert renderer.counters.live == 3
    renderer.relief.release()
    assert renderer.counters.live == 0


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: SlopeMap(np.zeros((4, 4))), "slopes"),
        (lambda: SlopeMap(np.full((4, 4, 2), np.nan)), "finite"),
        (lambda: MaskImage(np.full((4, 4), 1.5)), "mask"),
        (lambda: PeelTile(np.zeros((4, 4, 2)), 0), "waves"),
    ],
)
def test_what_is_no_image_is_refused(make: Callable[[], object], words: str) -> None:
    with pytest.raises(ValueRangeError, match=words):
        make()


@pytest.mark.parametrize(
    ("name", "anisotropy"),
    [("llvmpipe (LLVM 15.0.6, 256 bits)", 1.0), ("SwiftShader Device", 1.0), ("NVIDIA H100/PCIe/SSE2", 8.0)],
)
def test_in_software_no_texture_is_filtered_along_a_pixels_length(
    context: Context, monkeypatch: pytest.MonkeyPatch, name: str, anisotropy: float
) -> None:
    monkeypatch.setattr(relief_textures, "draws_in_software", lambda _: draws_in_software(Named(name)))
    objects = GpuObjects(context)
    textures = ReliefTextures(objects)
    textures.set_normal_map(constant_slope(0.1, 0.0))
    (made,) = objects.live
    assert made.anisotropy == min(anisotropy, context.max_anisotropy)
    textures.release()


class Named:
    """Stands for a context of this renderer."""

    def __init__(self, name: str) -> None:
        self.info = {"GL_RENDERER": name}
