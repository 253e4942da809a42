"""Flakes: as many, as tilted and as bright as the numbers say, whatever the pixel."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.appearance.flakes import tilt
from brdf_suite.appearance.flakes.footprint import flake_footprint
from tools.evaluation import flake_model as glints

PAINT = {"density": 120.0, "size": 0.02, "roughness": 0.17}


def pixels(n, flakes_per_footprint, seed=1):
    """Places and derivatives: footprints of an area, turned and up to three times longer than wide."""
    rng = np.random.default_rng(seed)
    edge = np.sqrt(flakes_per_footprint / PAINT["density"])
    turn, longer = rng.uniform(0, 2 * np.pi, n), np.sqrt(rng.uniform(1, 3, n))
    along, aside = edge * longer, edge / longer
    across = np.stack([along * np.cos(turn), along * np.sin(turn)], -1)
    down = np.stack([-aside * np.sin(turn), aside * np.cos(turn)], -1)
    return rng.uniform(-2000, 2000, (n, 2)), across, down, rng.normal(0, 0.06, (n, 2))


def glint(at, across, down, slope, spread=0.02, waviness=0.02, colour_spread=0.0):
    field = glints.glint_field(at, across, down, **PAINT, waviness=waviness, colour_spread=colour_spread)
    return glints.glint_ratio(field, *tilt.tilt_place(slope, PAINT["roughness"]), spread)


@pytest.mark.parametrize("flakes", [0.3, 4.0, 100.0, 1e4])
def test_the_mean_is_kept(flakes):
    ratio = glint(*pixels(25000, flakes))[:, 0]
    error = 4 * ratio.std() / np.sqrt(len(ratio))
    assert ratio.mean() == pytest.approx(1.0, abs=error)
    assert ratio.min() >= 0


def test_contrast_falls_with_the_root_of_the_count():
    counts = np.array([0.5, 4.0, 32.0, 256.0, 4000.0])
    scaled = [glint(*pixels(25000, c))[:, 0].std() * np.sqrt(c) for c in counts]
    assert max(scaled) / min(scaled) < 1.4


def test_no_flake_pops_when_the_pixel_grows():
    """Levels change over smoothly: no pixel jumps while a footprint grows by a factor of eight."""
    at, across, down, slope = pixels(200, 2.0)
    growth = np.exp2(np.linspace(0, 3, 700))[:, None, None]
    grown = [
        np.broadcast_to(one, (700, 200, 2)).reshape(-1, 2)
        for one in (at, across * growth, down * growth, slope)
    ]
    series = glint(*grown, 0.05)[:, 0].reshape(700, 200)
    step = np.abs(np.diff(series, axis=0)) / (1 + series[1:])
    assert step.max() < 0.3
    assert series.std(axis=0).mean() > 0.1


def test_the_same_flakes_after_a_small_move_and_a_small_turn_of_the_light():
    at, across, down, slope = pixels(25000, 10.0)
    before = glint(at, across, down, slope)[:, 0]
    moved = glint(at + 0.1 * across, across, down, slope)[:, 0]
    assert np.corrcoef(before, moved)[0, 1] > 0.95
    # A light that turns by 0.1 degrees turns the flakes that mirror it by 0.1 / (2 n).
    turned = glint(at, across, down, slope + np.radians(0.1) / 3.0)[:, 0]
    assert np.corrcoef(before, turned)[0, 1] > 0.95
    elsewhere = glint(at, across, down, slope + 0.2)[:, 0]
    assert abs(np.corrcoef(before, elsewhere)[0, 1]) < 0.1


def test_a_broad_light_hardly_glints_and_keeps_the_mean():
    where = pixels(30000, 10.0)
    contrast = [glint(*where, spread)[:, 0].std() for spread in (0.02, 0.08, 0.3)]
    assert contrast[0] > 3 * contrast[1] > 9 * contrast[2]
    assert glint(*where, 0.3)[:, 0].mean() == pytest.approx(1.0, abs=0.02)


def test_colours_are_even_in_the_mean_and_grey_without_spread():
    where = pixels(25000, 4.0)
    grey = glint(*where, 0.05)
    np.testing.assert_array_equal(grey[:, 0], grey[:, 1])
    coloured = glint(*where, 0.05, colour_spread=0.8)
    assert np.corrcoef(coloured[:, 0], coloured[:, 1])[0, 1] < 0.9
    np.testing.assert_allclose(coloured.mean(0), grey.mean(0), rtol=0.08)


def test_flakes_are_tilted_as_the_bell_says():
    """Even points of the square's disc, taken back to tilts, follow tilt_bell."""
    m = PAINT["roughness"]
    slope = np.linspace(0, 5 * m, 4000)
    place, stretch = tilt.tilt_place(np.stack([slope, 0 * slope], -1), m)
    radius = np.abs(place[:, 0] - 0.5)
    # The area of the disc within a tilt is the share of the bell within it, of a full disc of pi/4.
    bell = tilt.tilt_bell(slope**2, m) / (np.pi * m**2)
    angle = np.arctan(slope)
    ring = bell * 2 * np.pi * np.sin(angle)
    inside = np.concatenate([[0], np.cumsum(0.5 * (ring[1:] + ring[:-1]) * np.diff(angle))])
    np.testing.assert_allclose(4 * radius**2, inside, atol=1e-5)
    # The stretch is the root of the density of points.
    np.testing.assert_allclose(stretch**2, bell * np.pi / 4, rtol=1e-9)


def rows(n, x, y):
    return np.tile([float(x), float(y)], (n, 1))


def test_footprints_hold_all_of_a_flake():
    rng = np.random.default_rng(4)
    n = 400_000
    for size, pixel in ((0.02, 0.001), (0.02, 0.05), (0.001, 0.2)):
        many = flake_footprint(
            rows(n, 0, 0), rows(n, pixel, 0.3 * pixel), rows(n, 0.1 * pixel, 0.5 * pixel), size
        )
        reach = many.reach[0]
        apart = rng.uniform(-1, 1, (n, 2)) * reach
        cover = many.cover(apart[:, 0], apart[:, 1])
        box = 4 * reach.prod()
        assert cover.mean() * box == pytest.approx(1.0, abs=5 * cover.std() * box / np.sqrt(n))


def test_seen_close_a_flake_is_a_disc_of_its_size():
    distance = np.linspace(0, 0.02, 99)
    close = flake_footprint(rows(99, 0, 0), rows(99, 1e-5, 0), rows(99, 0, 1e-5), 0.02)
    cover = close.cover(distance, 0 * distance) / close.height
    assert np.interp(0.5, cover[::-1], distance[::-1]) == pytest.approx(0.01, rel=0.01)


def test_flake_texture_draws_beckmann():
    r = np.random.default_rng(3).random((2, 200_000))
    slopes = glints.beckmann_tilt(*r, 0.17)
    assert (slopes**2).sum(-1).mean() == pytest.approx(0.17**2, rel=0.01)
    # Within the tangent of m lies 1 - 1/e of them.
    assert ((slopes**2).sum(-1) < 0.17**2).mean() == pytest.approx(1 - np.exp(-1), abs=0.005)


@pytest.mark.parametrize("flakes", [0.05, 0.5, 3.0])
def test_flake_texture_keeps_the_mean(flakes):
    at, across, down, slope = pixels(25000, flakes)
    ratio = glints.flake_texture_ratio(at, across, down, slope, 0.03, **PAINT)[:, 0]
    assert ratio.mean() == pytest.approx(1.0, abs=4 * ratio.std() / np.sqrt(len(ratio)))


def test_flake_texture_fades_with_distance():
    contrast = [
        glints.flake_texture_ratio(*pixels(20000, n), 0.03, **PAINT)[:, 0].std()
        for n in (0.3, 2.0, 8.0, 40.0)
    ]
    assert contrast == sorted(contrast, reverse=True)
    assert contrast[0] > 1
    assert contrast[-1] == 0


def test_the_hash_is_even_and_changes_with_every_bit():
    words = glints.scramble(np.arange(1 << 16, dtype=np.uint32))
    assert len(np.unique(words)) == 1 << 16
    bits = (words[:, None] >> np.arange(32, dtype=np.uint32)) & 1
    assert np.abs(bits.mean(0) - 0.5).max() < 0.02
    for bit in range(0, 32, 5):
        other = glints.scramble(np.arange(1 << 16, dtype=np.uint32) ^ np.uint32(1 << bit))
        changed = ((words ^ other)[:, None] >> np.arange(32, dtype=np.uint32)) & 1
        assert np.abs(changed.mean(0) - 0.5).max() < 0.1
