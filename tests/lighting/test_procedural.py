"""Generated environments: upright, neutral where they say so, and with the luminances of the world."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.lighting.procedural import ProceduralEnvironment, booth, overcast, sunny
from brdf_suite.lighting.procedural.daylight import SUN, overcast_sky
from brdf_suite.lighting.procedural.lamps import LampSurface
from brdf_suite.lighting.procedural.panorama import (
    centres,
    colour_from_chromaticity,
    directions,
    horizontal_illuminance,
    solid_angles,
)
from brdf_suite.lighting.procedural.preetham import sky_radiance, zenith
from brdf_suite.lighting.procedural.studio import BOOTH
from brdf_suite.lighting.procedural.sun import SOLID_ANGLE, Sun, add_disc
from brdf_suite.resources import resource

MAKERS = {"booth": booth, "sunny": sunny, "overcast": overcast}


@pytest.fixture(scope="module")
def small() -> dict[str, ProceduralEnvironment]:
    return {name: make(height=64, samples=4) for name, make in MAKERS.items()}


def test_directions_follow_the_conventions() -> None:
    toward = directions(np.array([0.0, 0.5, 1.0]), np.array([0.25, 0.5, 0.75]))
    np.testing.assert_allclose(toward[0], [[0.0, 1.0, 0.0]] * 3, atol=1e-12)
    np.testing.assert_allclose(toward[1], [[1, 0, 0], [0, 0, 1], [-1, 0, 0]], atol=1e-12)
    np.testing.assert_allclose(toward[2], [[0.0, -1.0, 0.0]] * 3, atol=1e-12)


def test_solid_angles_fill_the_sphere() -> None:
    assert solid_angles(64).sum() * 128 == pytest.approx(4.0 * np.pi)
    assert horizontal_illuminance(np.ones((64, 128, 3))) == pytest.approx(np.pi, rel=1e-3)


def test_d65_is_white_in_the_working_space() -> None:
    np.testing.assert_allclose(colour_from_chromaticity(0.3127, 0.3290), 1.0, atol=1e-3)
    assert colour_from_chromaticity(0.35, 0.36) @ LUMINANCE == pytest.approx(1.0)


@pytest.mark.parametrize("name", MAKERS)
def test_every_environment_is_upright_positive_and_exposed_for_a_white_card(
    small: dict[str, ProceduralEnvironment], name: str
) -> None:
    environment = small[name]
    pixels = environment.radiance
    assert environment.name == name
    assert pixels.shape == (64, 128, 3)
    assert np.isfinite(pixels).all()
    assert pixels.min() > 0.0
    assert horizontal_illuminance(pixels) == pytest.approx(np.pi, rel=1e-3)
    above, below = horizontal_illuminance(pixels), horizontal_illuminance(pixels[::-1])
    assert 3.0 < above / below < 9.0, "light comes from above; the ground gives back 10 to 30 %"
    assert f"{environment.white_luminance:,.0f} cd/m²" in environment.comment
    np.testing.assert_array_equal(pixels, MAKERS[name](height=64, samples=4).radiance)


def test_the_overcast_sky_is_the_standard_one() -> None:
    toward = directions(centres(256), centres(8))
    sky = overcast_sky(toward) * (toward[..., 1:2] > 0)
    illuminance = (sky[..., 0] * np.maximum(toward[..., 1], 0.0) * solid_angles(256)).sum() * (512 / 8)
    assert illuminance == pytest.approx(15.0, rel=1e-3)
    top, level = overcast_sky(np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]))
    np.testing.assert_allclose(top / level, 3.0)
    assert np.ptp(top) == 0.0


def test_the_overcast_day_is_neutral_above_and_as_bright_as_it_says(
    small: dict[str, ProceduralEnvironment],
) -> None:
    pixels = small["overcast"].radiance
    assert np.ptp(pixels[:25], axis=-1).max() < 1e-6, "white above the skyline"
    assert small["overcast"].white_luminance * np.pi == pytest.approx(15_000.0, rel=0.03)
    assert np.ptp(pixels[29:32], axis=-1).max() > 0.01, "something stands on the horizon"


@settings(max_examples=settings.default.max_examples // 2)
@given(
    height=st.floats(8.0, 80.0),
    azimuth=st.floats(-180.0, 180.0),
    rows=st.sampled_from([32, 64, 256]),
)
def test_the_disc_gives_the_same_light_on_every_map(height: float, azimuth: float, rows: int) -> None:
    sun = Sun(height, azimuth)
    picture = add_disc(np.zeros((rows, 2 * rows, 3)), sun)
    toward = directions(centres(rows), centres(2 * rows))
    luminance = picture @ LUMINANCE * solid_angles(rows)
    assert luminance.sum() == pytest.approx(sun.normal_illuminance, rel=1e-9)
    middle = (toward * luminance[..., None]).sum(axis=(0, 1))
    apart = np.degrees(np.arccos(min(1.0, float(middle / np.linalg.norm(middle) @ sun.direction))))
    assert apart < 0.75 * 180.0 / rows


def test_the_sun_is_as_wide_and_bright_as_ours() -> None:
    assert pytest.approx(6.72e-5, rel=0.01) == SOLID_ANGLE
    assert 80.0 < SUN.normal_illuminance < 110.0
    assert 1.0e6 < SUN.radiance @ LUMINANCE < 2.0e6, "kcd/m²"
    assert SUN.colour[0] > SUN.colour[1] > SUN.colour[2], "warmer than D65"


def test_the_clear_sky_follows_its_formulas() -> None:
    sun = Sun(30.0, 0.0)
    toward = np.array(
        [[0.0, 1.0, 0.0], [0.3, 0.5, 0.4], [-0.3, 0.5, 0.4], [0.0, 0.3, -1.0], [0.0, 0.55, 0.9]]
    )
    toward /= np.linalg.norm(toward, axis=1, keepdims=True)
    sky = sky_radiance(toward, sun.direction, 3.0)
    expected = zenith(3.0, np.radians(60.0))
    assert sky[0] @ LUMINANCE == pytest.approx(expected[0])
    # χ = (4/9 - 3/120)·(π - 2π/3); Y = (4.0453·3 - 4.971)·tan χ - 0.2155·3 + 2.4192, by hand.
    assert expected[0] == pytest.approx(7.1649 * np.tan(0.419444 * np.pi / 3.0) + 1.7727)
    np.testing.assert_allclose(sky[1], sky[2], rtol=1e-12)
    assert sky[3][2] > sky[3][0], "blue away from the sun"
    assert sky[4] @ LUMINANCE > 3.0 * (sky[3] @ LUMINANCE), "bright beside the sun"


def test_the_sun_outshines_the_sky_and_stands_where_it_should() -> None:
    pixels = sunny(height=256, samples=1).radiance.astype(np.float64)
    luminance = pixels @ LUMINANCE
    row, column = np.unravel_index(luminance.argmax(), luminance.shape)
    toward = directions(centres(256)[[row]], centres(512)[[column]])[0, 0]
    assert np.degrees(np.arccos(toward @ SUN.direction)) < 0.7
    away = directions(centres(256), centres(512)) @ SUN.direction < np.cos(np.radians(1.5))
    sky = luminance[:110][away[:110]]
    assert SUN.radiance @ LUMINANCE > 1e5 * np.median(sky) * sunny(height=32, samples=1).white_luminance / 1e3
    assert luminance.max() > 1e4 * np.median(sky)
    assert 60.0 < horizontal_illuminance(pixels) * 28.0 < 120.0


def test_the_booth_is_neutral_and_lit_like_one(small: dict[str, ProceduralEnvironment]) -> None:
    environment = small["booth"]
    assert np.ptp(environment.radiance, axis=-1).max() == 0.0
    assert 1.0 < environment.white_luminance * np.pi / 1000.0 < 10.0, "kilolux on the card"
    for lamp in BOOTH.lamps:
        box = LampSurface.of(lamp)
        middle = box.centre / np.linalg.norm(box.centre)
        covered, luminance = box.seen(middle[None])
        assert covered[0] == 1.0
        assert luminance[0] == pytest.approx(lamp.luminance)
        assert box.seen(-middle[None])[0][0] == 0.0


def test_a_box_lights_a_card_by_the_form_factor() -> None:
    """A card far below a small box: E = L·A·cos·cos/d²."""
    lamp = BOOTH.lamps[0]
    box = LampSurface.of(lamp)
    place = np.array([[0.0, -40.0, 0.6]])
    area = 4.0 * 0.75 * 1.9
    expected = 0.9 * lamp.luminance * area / 42.6**2
    assert box.illuminance(place, np.array([[0.0, 1.0, 0.0]]))[0] == pytest.approx(expected, rel=2e-3)
    assert box.illuminance(place, np.array([[0.0, -1.0, 0.0]]))[0] == 0.0


@pytest.mark.parametrize("name", MAKERS)
def test_the_packaged_file_is_what_the_code_makes(small: dict[str, ProceduralEnvironment], name: str) -> None:
    path = resource("environments", f"{name}.exr")
    assert path.stat().st_size < 4 << 20
    image = read_environment_image(path)
    assert not image.notes
    assert image.pixels.shape == (512, 1024, 3)
    blocks = image.pixels.reshape(64, 8, 128, 8, 3).astype(np.float64).mean(axis=(1, 3))
    made = small[name].radiance.astype(np.float64)
    calm = (np.abs(blocks - made) <= 0.02 * made + 1e-3).all(axis=-1)
    assert calm.mean() > 0.93, "the same but for edges"
    assert (blocks * solid_angles(64)[..., None]).sum() == pytest.approx(
        (made * solid_angles(64)[..., None]).sum(), rel=2e-2
    )


def test_half_precision_holds_the_sun_and_full_is_used_where_it_does_not() -> None:
    day = sunny(height=512, samples=1)
    stored = day.stored()
    assert stored.dtype == np.float16
    assert float(stored.max()) == pytest.approx(float(day.radiance.max()), rel=1e-3)
    brighter = ProceduralEnvironment("bright", day.radiance * np.float32(10.0), 1.0, "")
    assert brighter.stored().dtype == np.float32
