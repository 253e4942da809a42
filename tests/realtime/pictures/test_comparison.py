"""Two paints in one frame, and a paint beside a picture."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import (
    REC709_TO_WORKING,
    srgb_decode,
    srgb_encode,
    working_to_lab,
)
from brdf_suite.appearance.difference.colour_scale import STEPS, scale_table
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Compare
from brdf_suite.realtime.pictures.comparison import ComparedPicture, ComparisonRenderer
from brdf_suite.realtime.pictures.display import DISPLAY_P3, LINEAR

SIZE = (61, 40)
SECOND = {"paint": "paint_b"}
VIEW = View(camera=Camera(azimuth_deg=20.0), exposure_ev=0.5)


def comparing(mode: str, **fields) -> View:
    return replace(VIEW, compare=Compare(mode, "b", **fields))


class Stand:
    """A sphere, two paints on it, and somewhere to draw."""

    def __init__(self, renderer, scenes, context) -> None:
        renderer.set_environment(
            scenes.from_function(lambda d: 0.3 + 0.25 * np.stack([d[..., 0], d[..., 1], -d[..., 0]], -1))
        )
        renderer.set_mesh([scenes.sphere(rings=24)])
        renderer.set_material("paint", scenes.weights(kd=0.7, gloss=0.05))
        renderer.set_material("paint_b", scenes.weights(kd=0.5, gloss=0.08))
        self.renderer = renderer
        self.comparison = ComparisonRenderer(renderer, SECOND)
        self.target = context.simple_framebuffer(SIZE, 4)

    def pixels(self) -> np.ndarray:
        flat = np.frombuffer(self.target.read(components=3, alignment=1), np.uint8)
        return flat.reshape(SIZE[1], SIZE[0], 3)[::-1].copy()

    def drawn(self, view: View, **options) -> np.ndarray:
        self.target.clear(1.0, 0.0, 1.0)
        self.comparison.draw(view, self.target, SIZE, **options)
        return self.pixels()

    def alone(self, second: bool) -> np.ndarray:
        self.renderer.render(VIEW, self.target, SIZE, materials=SECOND if second else {})
        return self.pixels()

    def lab(self, second: bool) -> np.ndarray:
        """L*a*b* of the exposed light of one paint's picture, (h, w, 3)."""
        weights = SECOND if second else {}
        light = self.renderer.context.texture(SIZE, 4, dtype="f4")
        framebuffer = self.renderer.context.framebuffer([light])
        self.renderer.render(VIEW, framebuffer, SIZE, materials=weights, display=LINEAR)
        rows = np.frombuffer(light.read(), np.float32).reshape(SIZE[1], SIZE[0], 4)[::-1, :, :3]
        self.renderer.context.detect_framebuffer(0).use()
        framebuffer.release()
        light.release()
        return working_to_lab(rows.astype(float) * 2.0**VIEW.exposure_ev)


@pytest.fixture
def stand(renderer, scenes, context):
    stand = Stand(renderer, scenes, context)
    yield stand
    # moderngl goes back to the last used framebuffer by its number, even when it is gone.
    context.detect_framebuffer(0).use()
    stand.target.release()


def test_off_is_the_first_alone(stand) -> None:
    assert (stand.drawn(comparing("off")) == stand.alone(False)).all()


@pytest.mark.parametrize("share", [0.0, 0.37, 1.0])
def test_a_swipe_shows_the_first_left_of_the_divider(stand, share) -> None:
    first, second = stand.alone(False), stand.alone(True)
    assert np.abs(first.astype(int) - second).max() > 20
    split = round(share * SIZE[0])
    swiped = stand.drawn(comparing("swipe", divider=share))
    assert (swiped[:, :split] == first[:, :split]).all()
    assert (swiped[:, split:] == second[:, split:]).all()


def test_a_blink_shows_one_and_then_the_other(stand) -> None:
    assert (stand.drawn(comparing("blink")) == stand.alone(False)).all()
    assert (stand.drawn(comparing("blink"), show_second=True) == stand.alone(True)).all()


def test_side_by_side_each_has_a_picture_of_its_own(stand, context) -> None:
    both = stand.drawn(comparing("side"))
    for size, part, weights in (((30, 40), np.s_[:, :30], {}), ((31, 40), np.s_[:, 30:], SECOND)):
        half = context.simple_framebuffer(size, 4)
        stand.renderer.render(VIEW, half, size, materials=weights)
        pixels = np.frombuffer(half.read(components=3, alignment=1), np.uint8)
        assert (both[part] == pixels.reshape(size[1], size[0], 3)[::-1]).all()
        context.detect_framebuffer(0).use()
        half.release()


def test_the_difference_of_the_light_is_that_of_its_colours(stand) -> None:
    wanted = delta_e_2000(stand.lab(False), stand.lab(True))
    view = comparing("difference", scale_delta_e=12.0)
    got = stand.comparison.differences(view, SIZE)
    # Half floats: 11 bits of each channel.
    np.testing.assert_allclose(got, wanted, atol=0.05)
    assert wanted.max() > 5.0
    background = np.s_[:4, :4]
    assert (got[background] == 0.0).all()
    shown = stand.drawn(view)
    along = np.linspace(0.0, 1.0, STEPS + 1)
    scale = np.stack([np.interp(got / 12.0, along, channel) for channel in scale_table().T], axis=-1)
    np.testing.assert_allclose(shown / 255.0, scale, atol=0.02)


def test_the_difference_of_the_pictures_is_that_of_what_is_shown(stand) -> None:
    first, second = (
        working_to_lab(srgb_decode(stand.alone(which) / 255.0) @ REC709_TO_WORKING.T)
        for which in (False, True)
    )
    got = stand.comparison.differences(comparing("difference", basis="picture"), SIZE)
    np.testing.assert_allclose(got, delta_e_2000(first, second), atol=0.01)


def test_the_difference_of_the_pictures_is_the_same_on_any_monitor(stand) -> None:
    view = comparing("difference", basis="picture")
    expected = stand.comparison.differences(view, SIZE)
    stand.renderer.screen = DISPLAY_P3
    marked = replace(view, clipping_marks=True, gamut_marks=True)
    assert np.abs(stand.comparison.differences(marked, SIZE) - expected).max() < 1e-3


def test_a_shown_picture_takes_the_place_of_the_second(stand) -> None:
    own = stand.alone(True)
    stand.comparison.set_picture(ComparedPicture(own, is_light=False))
    assert not stand.comparison.compares_light(comparing("difference"))
    assert (stand.drawn(comparing("blink"), show_second=True) == own).all()
    swiped = stand.drawn(comparing("swipe", divider=0.5))
    assert (swiped[:, :30] == stand.alone(False)[:, :30]).all()
    assert (swiped[:, 31:] == own[:, 31:]).all()
    by_paint = stand.comparison.differences(comparing("difference", basis="picture"), SIZE)
    stand.comparison.set_picture(None)
    np.testing.assert_allclose(
        stand.comparison.differences(comparing("difference", basis="picture"), SIZE), by_paint, atol=1e-4
    )


def test_a_shown_picture_has_its_colours_on_any_monitor(stand) -> None:
    codes = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    codes[:20], codes[20:, :30], codes[20:, 30:] = (255, 0, 0), (90, 160, 40), (128, 128, 128)
    stand.comparison.set_picture(ComparedPicture(codes, is_light=False))
    stand.renderer.screen = DISPLAY_P3
    view = replace(comparing("blink"), exposure_ev=2.0, tone_curve="aces", clipping_marks=True)
    shown = stand.drawn(view, show_second=True).astype(int)
    linear = srgb_decode(codes / 255.0) @ REC709_TO_WORKING.T @ DISPLAY_P3.space.from_working.T
    expected = 255.0 * srgb_encode(np.clip(linear, 0.0, 1.0))
    assert np.abs(shown - expected).max() < 1.6  # half floats, and the dither
    assert abs(shown[0, 0, 0] - 255) > 15  # a red of sRGB is not the screen's own
    side = stand.drawn(replace(view, compare=Compare("side", "b"))).astype(int)
    assert np.abs(side[14, 40] - expected[0, 0]).max() < 1.6


def test_a_picture_of_light_is_exposed_and_shown_as_the_paint_is(stand) -> None:
    light = stand.renderer.linear_image(VIEW, SIZE)[..., :3]
    stand.comparison.set_picture(ComparedPicture(light, is_light=True))
    shown = stand.drawn(comparing("blink"), show_second=True)
    # The curve after the average of the samples, and not before it: the same but for the object's edge.
    near = np.abs(shown.astype(int) - stand.alone(False)).max(axis=-1) <= 2
    assert near.mean() > 0.9
    assert stand.comparison.compares_light(comparing("difference"))
    assert stand.comparison.differences(comparing("difference"), SIZE).max() < 0.2


@pytest.mark.parametrize("height", [20, 60])
def test_a_picture_of_another_height_fits_by_its_width(stand, height) -> None:
    rows = np.zeros((height, SIZE[0], 3), np.uint8)
    rows[:] = np.linspace(40, 240, height).astype(np.uint8)[:, None, None]
    stand.comparison.set_picture(ComparedPicture(rows, is_light=False))
    shown = stand.drawn(comparing("blink"), show_second=True)
    shift = (SIZE[1] - height) // 2
    inside = np.arange(SIZE[1]) - shift
    kept = (inside >= 0) & (inside < height)
    np.testing.assert_array_equal(shown[kept][:, 0, 0], rows[inside[kept], 0, 0])
    assert (shown[~kept] == 0).all()


def test_frames_make_no_objects_once_a_mode_was_drawn(stand) -> None:
    modes = ("off", "side", "swipe", "blink", "difference")
    counters = stand.renderer.counters
    for mode in modes:
        stand.drawn(comparing(mode), show_second=True)
    made = counters.total_created
    for divider in (0.2, 0.6):
        for mode in ("swipe", "difference", "difference"):
            stand.drawn(comparing(mode, divider=divider))
    assert counters.total_created == made
