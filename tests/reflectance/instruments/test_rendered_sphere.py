"""The virtual sphere in its light: against sums over the light's map, and what its differences say."""

from __future__ import annotations

import math

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.instruments.rendered_sphere import (
    SUN_SHARE,
    exposure,
    light_map,
    rendered_sphere,
    sphere_difference,
    sun_direction,
)
from brdf_suite.reflectance.models.lambertian import Lambertian


def _directions(height: int) -> tuple[np.ndarray, np.ndarray]:
    theta = (np.arange(height) + 0.5) / height * math.pi
    phi = ((np.arange(2 * height) + 0.5) / (2 * height) - 0.5) * 2.0 * math.pi
    theta, phi = np.meshgrid(theta, phi, indexing="ij")
    where = np.stack((-np.sin(theta) * np.sin(phi), np.cos(theta), np.sin(theta) * np.cos(phi)), axis=-1)
    return where.reshape(-1, 3), (np.sin(theta) * (math.pi / height) ** 2).ravel()


def test_the_sun_gives_its_share_of_the_skys_illuminance() -> None:
    where, solid = _directions(128)
    light = light_map(128).ravel() * solid
    down = float(light @ where[:, 1].clip(0.0))
    sky = 7.0 * math.pi / 9.0
    # The horizon is softened over a few degrees.
    assert down == pytest.approx(sky * (1.0 + SUN_SHARE * sun_direction()[1]), rel=0.01)
    brightest = where[int(np.argmax(light_map(128)))]
    assert brightest @ sun_direction() > math.cos(math.radians(6.0))


def test_a_white_matt_sphere_is_as_bright_as_the_map_says() -> None:
    where, solid = _directions(64)
    light = light_map(64).ravel() * solid
    points = np.random.default_rng(1).normal(size=(4000, 3))
    normals = points / np.linalg.norm(points, axis=-1, keepdims=True)
    # Even on the disc that the viewer sees: normals towards the viewer count by their cosine.
    seen = normals[normals[:, 2] > 0.0]
    of_normal = (where @ seen.T).clip(0.0).T @ light / math.pi
    mean = float(of_normal @ seen[:, 2] / seen[:, 2].sum())
    found = rendered_sphere().pixels(Lambertian((1.0, 1.0, 1.0))).mean(axis=0)
    assert found == pytest.approx([mean] * 3, rel=0.03)


def test_more_directions_hardly_change_a_metallic_paint() -> None:
    paint = build_paint(load_shipped_paint("silver_metallic"))
    few, many = rendered_sphere().pixels(paint), rendered_sphere(sky=2048).pixels(paint)
    assert np.median(np.abs(few / many - 1.0)) < 0.01
    assert np.median((few * exposure(few)) @ [0.2627, 0.678, 0.0593]) == pytest.approx(0.18)


def test_a_paint_differs_from_others_and_not_from_itself() -> None:
    white, grey = Lambertian((0.8, 0.8, 0.8)), Lambertian((0.7, 0.7, 0.7))
    assert sphere_difference(white, white) == 0.0
    assert 1.0 < sphere_difference(white, grey) < 6.0


def test_too_few_directions_are_refused() -> None:
    with pytest.raises(ValueRangeError, match="too few"):
        rendered_sphere((-180.0, 45.0), 200, 1)
