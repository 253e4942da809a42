"""A traced picture in the place of the drawn surface: it must look as the same light, drawn, looks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Compare
from brdf_suite.errors import ValueRangeError
from brdf_suite.realtime.pictures.comparison import ComparisonRenderer
from brdf_suite.realtime.pictures.display import LINEAR, SRGB
from brdf_suite.realtime.pictures.traced_light import TracedLight

SIZE = (61, 40)
VIEW = View(camera=Camera(azimuth_deg=20.0), exposure_ev=0.5)


class Stand:
    """A sphere; the light that is drawn of it stands for what a tracer gives."""

    def __init__(self, renderer, scenes, context) -> None:
        renderer.set_environment(
            scenes.from_function(lambda d: 0.3 + 0.25 * np.stack([d[..., 0], d[..., 1], -d[..., 0]], -1))
        )
        renderer.set_mesh([scenes.sphere(rings=24)])
        renderer.set_material("paint", scenes.weights(kd=0.7, gloss=0.05))
        self.renderer = renderer
        self.light = renderer.render_image(VIEW, SIZE, 1, display=LINEAR, transparent=True)
        self.traced = TracedLight(renderer)
        self.traced.set_picture(self.light)
        self.target = context.simple_framebuffer(SIZE, 4)

    def shown(self, draw) -> np.ndarray:
        self.target.clear(1.0, 0.0, 1.0)
        draw()
        flat = np.frombuffer(self.target.read(components=3, alignment=1), np.uint8)
        return flat.reshape(SIZE[1], SIZE[0], 3)[::-1].astype(int)

    def of_tracer(self, view: View) -> np.ndarray:
        return self.shown(lambda: self.traced.render(view, self.target, SIZE))

    def of_renderer(self, view: View) -> np.ndarray:
        return self.shown(lambda: self.renderer.render(view, self.target, SIZE, 1))


@pytest.fixture
def stand(renderer, scenes, context):
    stand = Stand(renderer, scenes, context)
    yield stand
    # moderngl goes back to the last used framebuffer by its number, even when it is gone.
    context.detect_framebuffer(0).use()
    stand.target.release()


@pytest.mark.parametrize(
    "fields",
    [
        {},
        {"tone_curve": "linear", "exposure_ev": 2.5, "clipping_marks": True},
        {"background": "grey"},
        {"background": "blurred", "gamut_marks": True, "mark_style": "colour"},
        {"background": "colour", "background_colour": (0.2, 0.4, 0.9), "exposure_ev": -1.0},
    ],
)
def test_the_same_light_looks_the_same_traced_or_drawn(stand, fields) -> None:
    view = replace(VIEW, **fields)
    # Half floats, blended: a code of 8 bits is the most that a rounding makes.
    assert np.abs(stand.of_tracer(view) - stand.of_renderer(view)).max() <= 1


def test_its_light_is_read_back_with_the_background(stand) -> None:
    whole = stand.renderer.render_image(VIEW, SIZE, 1, display=LINEAR)
    assert whole[0, 0, 3] == 0.0
    for pixel in ((30, 20), (0, 0), (SIZE[0] - 1, 3), (25, 31)):
        found = stand.traced.pixel(VIEW, SIZE, pixel)
        np.testing.assert_allclose(found, whole[pixel[1], pixel[0]], rtol=2e-3, atol=1e-4)


def test_what_a_screen_cannot_show_is_counted_in_it(stand) -> None:
    view = replace(VIEW, exposure_ev=1.5, tone_curve="linear")
    counted = stand.traced.count_unshowable(view, SIZE)
    assert counted == stand.renderer.count_unshowable(view, SIZE, SRGB)
    assert 0 < counted.too_bright < counted.pixels


def test_a_picture_that_is_written_over_makes_no_object(stand) -> None:
    dark = np.zeros((SIZE[1], SIZE[0], 4), np.float32)
    dark[..., 3] = 1.0
    stand.of_tracer(VIEW)
    made = stand.renderer.counters.live
    stand.traced.set_picture(dark)
    assert stand.of_tracer(VIEW).max() <= 1
    assert stand.renderer.counters.live == made
    stand.traced.set_picture(dark[:10])
    assert stand.traced.size == (SIZE[0], 10)
    stand.traced.set_picture(None)
    assert stand.traced.size is None
    with pytest.raises(ValueRangeError, match=r"\(h, w, 4\)"):
        stand.traced.set_picture(dark[..., :3])


def test_the_traced_shadow_on_the_ground_darkens_the_background_alone(stand) -> None:
    without = stand.traced.pixel(VIEW, SIZE, (2, 3))
    inside = stand.traced.pixel(VIEW, SIZE, (30, 20))
    darkness = np.zeros((SIZE[1], SIZE[0], 3), np.float32)
    darkness[3, 2] = (0.5, 0.25, 0.0)
    stand.traced.set_picture(np.concatenate([stand.light, darkness], axis=-1))
    found = stand.traced.pixel(VIEW, SIZE, (2, 3))
    np.testing.assert_allclose(found[:3], without[:3] * (0.5, 0.75, 1.0), rtol=5e-3)
    assert found[3] == 0.0
    np.testing.assert_allclose(stand.traced.pixel(VIEW, SIZE, (30, 20)), inside, rtol=2e-3)
    stand.traced.set_picture(stand.light)
    np.testing.assert_allclose(stand.traced.pixel(VIEW, SIZE, (2, 3)), without, rtol=2e-3)


def test_it_is_compared_with_what_is_drawn(stand) -> None:
    comparison = ComparisonRenderer(stand.renderer, {})
    comparison.traced = stand.traced
    stand.traced.set_picture(stand.light * np.array([0.5, 0.5, 0.5, 1.0], np.float32))

    def drawn(mode: str, **options) -> np.ndarray:
        view = replace(VIEW, compare=Compare(mode, None, divider=0.5))
        return stand.shown(lambda: comparison.draw(view, stand.target, SIZE, samples=1, **options))

    traced, real = stand.of_tracer(VIEW), stand.of_renderer(VIEW)
    assert np.abs(traced - real).max() > 20
    assert (drawn("blink") == traced).all()
    assert (drawn("blink", show_second=True) == real).all()
    swipe = drawn("swipe")
    assert (swipe[:, :30] == traced[:, :30]).all()
    assert (swipe[:, 31:] == real[:, 31:]).all()
    view = replace(VIEW, compare=Compare("difference", None))
    apart = comparison.differences(view, SIZE, 1)
    assert apart[0, 0] == pytest.approx(0.0, abs=0.01)  # the background is one and the same
    assert apart[20, 30] > 5.0
