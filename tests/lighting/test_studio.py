"""Studios drawn from their description."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.documents.studio import Backdrop, BoothRoom, Studio, StudioLamp
from brdf_suite.errors import Cancelled
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.lighting.procedural import booth, studio
from brdf_suite.lighting.procedural.lamps import LampSurface
from brdf_suite.lighting.procedural.panorama import centres, directions, solid_angles
from brdf_suite.lighting.procedural.studio import EXAMPLE
from brdf_suite.resources import resource

VOID = Backdrop(luminance=0.0)
SHAPES = {
    "box": (StudioLamp("box", (0.0, 0.0, 5.0), (0.8, 0.5), softness_m=1e-4), 0.4 * 0.9),
    "strip": (StudioLamp("strip", (0.0, 0.0, 5.0), (0.8, 0.3), softness_m=1e-4), 0.5 * 0.3 + np.pi * 0.15**2),
    "ring": (StudioLamp("ring", (0.0, 0.0, 5.0), (0.8, 0.1), softness_m=1e-4), np.pi * (0.4**2 - 0.3**2)),
}


def test_the_shipped_booth_is_the_description_to_the_last_bit() -> None:
    shipped = read_environment_image(resource("environments", "booth.exr")).pixels
    made = booth().stored()
    assert made.dtype == np.float16
    np.testing.assert_array_equal(made.astype(np.float32), shipped)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_lamp_gives_the_light_of_its_area(shape: str) -> None:
    """Far lamps: seen flux and light on a card are both luminance times area over the square of the distance."""
    lamp, area = SHAPES[shape]
    surface = LampSurface.of(lamp)
    toward = directions(
        (np.arange(800) + 0.5) / 800 * 0.08 + 0.46, (np.arange(800) + 0.5) / 800 * 0.08 + 0.46
    )
    covered, bright = surface.seen(toward)
    pixel = (0.08 * np.pi / 800) * (0.08 * 2.0 * np.pi / 800)
    seen = float((covered * bright * pixel).sum())
    assert seen == pytest.approx(lamp.luminance * area / 25.0, rel=2e-2)
    on_card = surface.illuminance(np.array([[0.0, 0.0, -40.0]]), np.array([[0.0, 0.0, 1.0]]))[0]
    assert on_card == pytest.approx(lamp.luminance * area / 45.0**2, rel=2e-2)


def test_shapes_are_what_they_are_called() -> None:
    middle = np.array([[0.0, 0.0, 1.0]])
    assert LampSurface.of(SHAPES["box"][0]).seen(middle)[0][0] == 1.0
    assert LampSurface.of(SHAPES["ring"][0]).seen(middle)[0][0] == 0.0, "a ring has a hole"
    corner = np.array([[0.39, 0.14, 5.0]]) / np.linalg.norm([0.39, 0.14, 5.0])
    assert LampSurface.of(SHAPES["box"][0]).seen(corner)[0][0] == 1.0
    assert LampSurface.of(SHAPES["strip"][0]).seen(corner)[0][0] == 0.0, "a strip has round ends"


def test_a_lamp_turned_away_is_dark_and_lights_the_other_side() -> None:
    away = LampSurface.of(StudioLamp("box", (0.0, 0.0, 3.0), (1.0, 1.0), facing=(0.0, 0.0, 1.0)))
    covered, bright = away.seen(np.array([[0.0, 0.0, 1.0]]))
    assert covered[0] == 1.0
    assert bright[0] == 0.0
    wall, towards = np.array([[0.0, 0.0, 6.0]]), np.array([[0.0, 0.0, -1.0]])
    assert away.illuminance(wall, towards)[0] > 0.1
    assert away.illuminance(-wall, -towards)[0] == 0.0


def test_the_nearer_lamp_is_in_front_whatever_the_order() -> None:
    near = StudioLamp("box", (0.0, 0.0, 2.0), (0.5, 0.5), luminance=1.0)
    far = StudioLamp("box", (0.0, 0.0, 4.0), (3.0, 3.0), luminance=9.0)
    for lamps in ((near, far), (far, near)):
        made = studio(Studio("two", lamps, backdrop=Backdrop(0.1)), height=32, samples=1)
        middle, beside = made.radiance[16, 32] @ LUMINANCE, made.radiance[16, 30] @ LUMINANCE
        assert beside / middle == pytest.approx(9.0, rel=0.2)


def test_colour_temperature_colours_the_lamp_and_the_walls() -> None:
    warm = StudioLamp("box", (0.0, 2.5, 0.0), (2.0, 2.0), colour_temperature_k=2800.0)
    made = studio(Studio("warm", (warm,), room=BoothRoom()), height=32, samples=1).radiance.astype(float)
    ratio = made / (made @ LUMINANCE)[..., None]
    np.testing.assert_allclose(ratio, np.broadcast_to(lamp_colour(2800.0), ratio.shape), rtol=1e-5)


def test_relative_luminances_give_the_same_picture_without_a_scale() -> None:
    twice = dataclasses.replace(
        EXAMPLE,
        lamps=tuple(dataclasses.replace(lamp, luminance=2.0 * lamp.luminance) for lamp in EXAMPLE.lamps),
        backdrop=Backdrop(0.3),
        unit="relative",
    )
    first, second = (studio(one, height=32, samples=2) for one in (EXAMPLE, twice))
    np.testing.assert_allclose(second.radiance, first.radiance, rtol=1e-6)
    assert second.white_luminance is None
    assert "cd/m²" in first.comment
    assert "cd/m²" not in second.comment


def test_a_lamp_below_gives_a_picture_too() -> None:
    below = Studio("below", (StudioLamp("ring", (0.0, -2.0, 0.0), (1.0, 0.2)),), backdrop=VOID)
    made = studio(below, height=64, samples=2).radiance
    mean = float((made @ LUMINANCE * solid_angles(64)).sum()) / (4.0 * np.pi)
    assert mean == pytest.approx(1.0, rel=1e-4)
    assert made[:32].max() == 0.0


@settings(max_examples=settings.default.max_examples // 2)
@given(
    st.sampled_from(["box", "strip", "ring"]),
    st.tuples(*[st.floats(-3.0, 3.0)] * 3).filter(lambda p: sum(v * v for v in p) > 0.2),
    st.one_of(
        st.none(), st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda p: sum(v * v for v in p) > 0.1)
    ),
    st.floats(-180.0, 180.0),
)
def test_any_lamp_is_drawn_whole(
    shape: str, position: tuple[float, ...], facing: tuple[float, ...] | None, roll: float
) -> None:
    """Nothing of a lamp lies outside of the cone to which drawing is limited."""
    lamp = StudioLamp(shape, position, (1.0, 0.4), facing, roll)  # type: ignore[arg-type] - drawn by hypothesis
    surface = LampSurface.of(lamp)
    toward = directions(centres(96), centres(192))
    covered, bright = surface.seen(toward)
    assert np.isfinite(covered).all()
    assert np.isfinite(bright).all()
    middle = surface.centre / np.linalg.norm(surface.centre)
    assert (toward @ middle)[covered > 0.0].min(initial=1.0) >= surface.cone_cosine()


def test_drawing_can_be_cancelled() -> None:
    def stop(_fraction: float, _what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        studio(EXAMPLE, height=32, progress=stop)
