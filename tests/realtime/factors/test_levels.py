"""Mip levels of factors: means of light, sized as OpenGL sizes them."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.realtime.factors.levels import cube_faces, levels, radial_levels


def test_levels_halve_down_to_one_texel_and_keep_the_mean_of_light() -> None:
    values = np.random.default_rng(3).uniform(0.1, 5.0, (16, 8, 3))
    for logarithmic in (False, True):
        found = list(
            levels(np.log(values) if logarithmic else values, logarithmic=logarithmic, hemisphere=False)
        )
        assert [one.shape[:2] for one in found] == [(16, 8), (8, 4), (4, 2), (2, 1), (1, 1)]
        last = np.exp(found[-1]) if logarithmic else found[-1]
        np.testing.assert_allclose(last[0, 0], values.mean(axis=(0, 1)), rtol=1e-9)


@pytest.mark.parametrize("size", [1, 2, 3, 7, 33])
def test_uneven_sizes_stay_within_their_values(size: int) -> None:
    line = np.linspace(-30.0, 2.0, size)[None, :, None].repeat(3, axis=-1)
    found = list(levels(line, logarithmic=True, hemisphere=False))
    assert [one.shape[1] for one in found] == [size // 2**k for k in range(len(found))]
    assert all(line.min() - 1e-9 <= one.min() and one.max() <= line.max() + 1e-9 for one in found)


def test_what_lies_beyond_the_horizon_has_no_say() -> None:
    map_ = np.zeros((16, 16, 3))
    along = (2.0 * np.arange(16) + 1.0) / 16 - 1.0
    map_[np.hypot(along[:, None], along) > 1.2] = 50.0
    for one in levels(map_, logarithmic=True, hemisphere=True):
        if len(one) <= 4:
            assert one.max() < 1e-6


def test_a_cube_map_holds_the_map_in_every_direction_above() -> None:
    # Linear in the place of the map, so bilinear between its texels without an error.
    along = (2.0 * np.arange(32) + 1.0) / 32 - 1.0
    map_ = np.stack(np.broadcast_arrays(along[None], along[:, None], 1.0), axis=-1)
    faces = cube_faces(map_)
    assert faces.shape == (6, 32, 32, 3)
    directions = texel_directions(32)
    above = directions[..., 2] > 0.1
    place = directions[..., :2] / (1.0 + directions[..., 2:])
    inside = above & (np.abs(place).max(axis=-1) < 31 / 32)
    np.testing.assert_allclose(faces[inside][:, :2], place[inside], atol=1e-9)


@pytest.mark.parametrize("power", [1.0, 2.0])
def test_a_map_over_a_radius_keeps_the_light_of_its_disc(power: float) -> None:
    values = np.exp(-((np.linspace(0.0, 1.0, 64) / 0.15) ** 2))[:, None] * [1.0, 10.0, 0.1] + 1e-3
    fine = (np.arange(8192) + 0.5) / 8192

    def light(level: np.ndarray) -> np.ndarray:
        held = np.clip(fine * len(level) - 0.5, 0.0, len(level) - 1.0)
        between = np.stack([np.interp(held, np.arange(len(level)), one) for one in level.T], axis=-1)
        return (between * fine[:, None] ** (2.0 * power - 1.0)).mean(axis=0)

    found = [one[0] for one in radial_levels(values, logarithmic=False, power=power)]
    assert [len(one) for one in found] == [64, 32, 16, 8, 4, 2, 1]
    for one in found:
        np.testing.assert_allclose(light(one), light(values), rtol=5e-3)
    logs = [one[0] for one in radial_levels(np.log(values), logarithmic=True, power=power)]
    np.testing.assert_allclose(np.exp(logs[3]), found[3], rtol=0.02)
