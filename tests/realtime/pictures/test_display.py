"""What the finishing pass writes: other screens, radiance, marks, transparency, and what it counts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import srgb_decode, srgb_encode
from brdf_suite.appearance.colour.spaces import (
    DISPLAY_P3_SPACE,
    SRGB_SPACE,
    DisplaySpace,
    inverse_codes,
)
from brdf_suite.documents.view import Camera, View
from brdf_suite.realtime.pictures.display import DISPLAY_P3, LINEAR, SRGB, Display
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.pictures.strips import draw_strips
from brdf_suite.realtime.pictures.tone_curves import TONE_CURVE_NUMBERS, tone_curve

SIZE = (96, 64)
VIEW = View(Camera(20, 10), background="grey", tone_curve="linear", fresnel="off")


def lit(renderer: Renderer, scenes, radiance, kd: float = 1.0) -> None:
    """A matt sheet that fills the middle of the picture with this radiance of the working space."""
    colour = np.asarray(radiance, float)
    renderer.set_environment(scenes.from_function(lambda d: colour * np.ones((*d.shape[:-1], 3))))
    renderer.set_mesh([scenes.sheet()])
    renderer.set_material("paint", scenes.weights(kd=kd))


def middle(picture: np.ndarray) -> np.ndarray:
    return picture[picture.shape[0] // 2, picture.shape[1] // 2]


@pytest.mark.parametrize("kind", list(TONE_CURVE_NUMBERS))
def test_every_curve_reaches_the_picture(renderer, scenes, kind):
    radiance = np.array([0.5, 0.3, 0.2])
    lit(renderer, scenes, radiance)
    view = replace(VIEW, tone_curve=kind, exposure_ev=0.5)
    got = middle(renderer.render_image(view, SIZE, display=Display(SRGB_SPACE, dithered=False)))
    drawn = middle(renderer.linear_image(view, SIZE))[:3]
    wanted = SRGB_SPACE.encode(SRGB_SPACE.of_working(tone_curve(drawn * 2.0**0.5, kind)))
    np.testing.assert_allclose(got / 65535, wanted, atol=6e-4)  # the light is held in half floats


def test_radiance_comes_back_whatever_the_exposure(renderer, scenes):
    lit(renderer, scenes, [30.0, 2.0, 0.001])
    for ev in (-6.0, 0.0, 9.0):
        got = renderer.linear_image(replace(VIEW, exposure_ev=ev), SIZE)
        assert got.dtype == np.float32
        np.testing.assert_allclose(middle(got), [30.0, 2.0, 0.001, 1.0], rtol=2e-3)
        assert got[0, 0, 3] == 0.0
        assert 0.0 < got[..., 3].mean() < 1.0


def test_display_p3_shows_what_srgb_cannot(renderer, scenes):
    inside_p3 = np.linalg.inv(DISPLAY_P3_SPACE.from_working) @ np.array([0.6, 0.02, 0.02])
    lit(renderer, scenes, np.maximum(inside_p3, 0.0))
    got = middle(renderer.render_image(VIEW, SIZE, display=replace(DISPLAY_P3, dithered=False))) / 65535
    np.testing.assert_allclose(got, srgb_encode([0.6, 0.02, 0.02]), atol=2e-3)
    assert middle(renderer.render_image(VIEW, SIZE))[1] == 0
    counted = [renderer.count_unshowable(VIEW, SIZE, display) for display in (SRGB, DISPLAY_P3)]
    assert counted[0].too_colourful == counted[0].pixels > 500
    assert counted[1].too_colourful == 0


def test_a_monitors_codes_are_those_of_its_table(renderer, scenes):
    rng = np.random.default_rng(4)
    gammas = np.array([1.8, 2.2, 2.6])
    curves = np.linspace(0, 1, 4096)[:, None] ** gammas
    space = DisplaySpace("monitor", SRGB_SPACE.from_working, None, inverse_codes(curves))
    for radiance in rng.random((5, 3)) ** 2:
        lit(renderer, scenes, radiance)
        drawn = middle(renderer.linear_image(VIEW, SIZE))[:3]
        got = middle(renderer.render_image(VIEW, SIZE, display=Display(space, dithered=False))) / 65535
        np.testing.assert_allclose(got, np.clip(space.of_working(drawn), 0, 1) ** (1 / gammas), atol=1.5e-3)


def test_codes_of_a_table_of_three_dimensions_are_numpys(renderer, scenes):
    """Any table: its cells have nothing in common, so each picture is one tetrahedron's mixture."""
    rng = np.random.default_rng(11)
    tables = [rng.random((n, n, n, 3)).astype(np.float32) for n in (5, 2)]
    for number, radiance in enumerate(rng.random((12, 3)) ** 2):
        space = DisplaySpace("monitor", DISPLAY_P3_SPACE.from_working, table=tables[number % 2])
        lit(renderer, scenes, radiance)
        drawn = middle(renderer.linear_image(VIEW, SIZE))[:3]
        got = middle(renderer.render_image(VIEW, SIZE, display=Display(space, dithered=False))) / 65535
        # The light is held in half floats; a cell's values differ by up to 1 in a quarter of the range.
        np.testing.assert_allclose(got, space.encode(space.of_working(drawn)), atol=4e-3)


def test_table_look_up_is_the_twin_of_numpy(context, renderer, scenes, evaluate):
    # Through the shader's own function: the table of a renderer is bound by name here.
    x = np.tile(np.linspace(0.0, 1.0, 257)[:, None], 4)
    got = evaluate("transfer.glsl", "vec4(device_encode(x.rgb), 1.0)", x)
    np.testing.assert_allclose(got[:, 0], srgb_encode(x[:, 0]), atol=2e-6)


def test_marks(renderer, scenes):
    lit(renderer, scenes, [2.0, 2.0, 2.0])
    assert (
        renderer.count_unshowable(VIEW, SIZE).too_bright == renderer.count_unshowable(VIEW, SIZE).pixels > 500
    )
    plain = renderer.render_image(VIEW, SIZE)
    assert np.array_equal(renderer.render_image(replace(VIEW, gamut_marks=True), SIZE), plain)
    zebra = renderer.render_image(replace(VIEW, clipping_marks=True), SIZE)
    around = zebra[24:40, 40:56]
    assert set(np.unique(around)) == {0, 255}
    assert 0.4 < (around == 0).mean() < 0.6
    colour = renderer.render_image(replace(VIEW, clipping_marks=True, mark_style="colour"), SIZE)
    assert np.abs(middle(colour).astype(int) - [213, 94, 0]).max() <= 1
    assert np.array_equal(colour[0], plain[0])  # the backdrop can be shown

    lit(renderer, scenes, [0.0, 0.4, 0.0])
    assert np.array_equal(
        renderer.render_image(replace(VIEW, clipping_marks=True), SIZE), renderer.render_image(VIEW, SIZE)
    )
    colour = renderer.render_image(replace(VIEW, gamut_marks=True, mark_style="colour"), SIZE)
    assert np.abs(middle(colour).astype(int) - [0, 114, 178]).max() <= 1


def test_nothing_is_counted_where_the_screen_shows_all(renderer, scenes):
    lit(renderer, scenes, [0.4, 0.4, 0.4])
    counted = renderer.count_unshowable(VIEW, SIZE)
    assert (counted.too_bright, counted.too_colourful) == (0, 0)
    assert counted.pixels == (renderer.linear_image(VIEW, SIZE, 1)[..., 3] > 0.5).sum()
    # A size beyond the GPU's limits is counted in a smaller picture of the same shape.
    assert 0 < renderer.count_unshowable(VIEW, (40_000, 20_000)).pixels <= 2048 * 1024


def test_transparent_pictures_show_the_object_alone(renderer, scenes):
    lit(renderer, scenes, [0.5, 0.5, 0.5])
    picture = renderer.render_image(VIEW, SIZE, display=Display(dithered=False), transparent=True)
    assert picture.shape == (SIZE[1], SIZE[0], 4)
    assert picture[0, 0].tolist() == [0, 0, 0, 0]
    rim = (picture[..., 3] > 0) & (picture[..., 3] < 65535)
    assert rim.any()
    # The colour is not multiplied by its share: at the rim it is that of the middle.
    assert np.abs(picture[rim][:, :3].astype(int) - middle(picture)[:3].astype(int)).max() < 80
    light = renderer.render_image(VIEW, SIZE, display=LINEAR, transparent=True)
    np.testing.assert_allclose(light[..., :3], light[..., 3:] * 0.5 * np.ones(3), atol=2e-3)


def test_strips_are_the_picture_in_bounded_pieces(renderer, scenes):
    lit(renderer, scenes, [0.7, 0.2, 0.4])
    whole = renderer.render_image(VIEW, (130, 101))
    strips = list(renderer.strips(VIEW, (130, 101), largest_tile=32))
    assert [len(strip) for strip in strips] == [5, 32, 32, 32]
    # Another projection rounds otherwise: a sample on the sheet's edge may fall on the other side.
    assert (np.abs(np.concatenate(strips).astype(int) - whole).max(axis=-1) > 1).mean() < 1e-3
    wide = next(renderer.strips(VIEW, (60_000, 3000), display=LINEAR))
    assert wide.nbytes <= 64 << 20
    assert wide.shape[1:] == (60_000, 4)


def test_odd_sizes_of_tiles_and_strips_cover_the_picture():
    class Target:
        def prepare(self, size, dtype):
            self.size = size
            return self, None

        def read(self, viewport, components, dtype, alignment):
            _, _, w, h = viewport
            x, y = np.meshgrid(np.arange(w) + self.corner[0], np.arange(h) + self.corner[1])
            return np.stack([x % 251, y % 251, x * 0], -1).astype(np.uint8).tobytes()

    target = Target()
    for size, limit in (((7, 5), 2), ((64, 33), 32), ((65, 64), 32), ((2, 1), 2048)):

        def draw(framebuffer, tile, corner):
            framebuffer.corner = corner

        picture = np.concatenate(list(draw_strips(draw, target, size, limit, SRGB, 3)))
        x, y = np.meshgrid(np.arange(size[0]), np.arange(size[1])[::-1])
        assert np.array_equal(picture[..., 0], x % 251)
        assert np.array_equal(picture[..., 1], y % 251)


def test_light_from_elsewhere_is_finished_like_our_own(context, renderer, scenes):
    lit(renderer, scenes, [0.3, 0.3, 0.3])
    view = replace(VIEW, tone_curve="characteristic", exposure_ev=1.0)
    values = np.random.default_rng(0).random((8, 8, 4)).astype(np.float32)
    light = context.texture((8, 8), 4, values.tobytes(), dtype="f4")
    out = context.texture((8, 8), 4, dtype="f4")
    framebuffer = context.framebuffer([out])
    renderer.finish(view, light, framebuffer, (8, 8), display=Display(dithered=False))
    got = np.frombuffer(framebuffer.read(components=3, dtype="f4"), np.float32).reshape(8, 8, 3)
    wanted = np.clip(SRGB_SPACE.of_working(tone_curve(values[..., :3], "characteristic")), 0, 1)
    np.testing.assert_allclose(srgb_decode(got), wanted, atol=1e-5)
    context.detect_framebuffer(0).use()
    for made in (framebuffer, out, light):
        made.release()
