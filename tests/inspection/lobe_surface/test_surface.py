"""The reflected distribution as a surface: its directions, its points against ``eval``, holes, zero and spikes."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, WORKING_TO_XYZ, srgb_decode
from brdf_suite.appearance.difference.cam02ucs import xyz_to_cam02ucs
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import spherical
from brdf_suite.inspection.lobe_surface.colour import (
    CHANNELS,
    difference_map,
    light_codes,
    scalar_of,
    value_map,
)
from brdf_suite.inspection.lobe_surface.grid import HORIZON_Z, lobe_grid
from brdf_suite.inspection.lobe_surface.occlusion import hidden, met, radius_along, value_along
from brdf_suite.inspection.lobe_surface.parts import FitOnGrid, LobeSource, fit_lobes
from brdf_suite.inspection.lobe_surface.surface import (
    COLOURINGS,
    RADIUS_KINDS,
    RadiusScale,
    difference_surface,
    greatest,
    grid_faces,
    lobe_surface,
)
from brdf_suite.reflectance.models.cosine_lobes import CosineLobes
from brdf_suite.reflectance.registry import MODELS
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

LIGHT = spherical(np.radians(40.0), np.radians(200.0))


def solid_angle(grid) -> float:
    """Area of the grid's triangles over that of the hemisphere."""
    points = grid.directions.reshape(-1, 3)
    a, b, c = (points[grid_faces(*grid.shape)[:, i]] for i in range(3))
    return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=-1).sum() / (2.0 * np.pi))


@settings(max_examples=settings.default.max_examples // 4)
@given(st.floats(0.0, 88.0), st.floats(-180.0, 180.0))
def test_the_grid_covers_the_hemisphere_without_a_seam(theta: float, phi: float) -> None:
    grid = lobe_grid(spherical(np.radians(theta), np.radians(phi)), 64, 128)
    directions = grid.directions
    assert np.allclose(np.linalg.norm(directions, axis=-1), 1.0, atol=1e-12)
    assert np.allclose(directions[0], grid.mirror, atol=1e-12)
    assert np.array_equal(directions[:, 0], directions[:, -1])
    assert directions[..., 2].min() >= 0.99 * HORIZON_Z
    assert np.allclose(directions[-1, :, 2], HORIZON_Z, rtol=1e-6)
    assert solid_angle(grid) == pytest.approx(1.0, abs=0.01)
    steps = (
        np.linalg.norm(np.diff(directions, axis=0), axis=-1),
        np.linalg.norm(np.diff(directions, axis=1), axis=-1),
    )
    assert np.degrees(max(step.max() for step in steps)) < 9.0


def test_rows_lie_close_about_the_mirror_direction() -> None:
    grid = lobe_grid(LIGHT)
    assert grid.shape == (128, 257)
    cosine = np.clip(grid.directions @ grid.mirror, -1.0, 1.0)
    assert np.allclose(np.arccos(cosine)[5:-1], grid.gamma[5:-1], atol=1e-7)
    half_width = np.sqrt(2.0 * np.log(2.0) / 1e5)
    assert (grid.gamma[:, 0] < half_width).sum() >= 12


@pytest.mark.parametrize("name", sorted(MODELS))
def test_points_are_those_that_eval_gives(name: str) -> None:
    model = MODELS[name].default
    grid = lobe_grid(LIGHT, 24, 32)
    values = LobeSource(model).brdf(grid)
    expected = model.eval(LIGHT, grid.directions)
    # Single precision, and the two sides of the plane of incidence are one within rounding.
    np.testing.assert_allclose(values, expected, rtol=3e-6, atol=1e-7 * expected.max())
    scale = RadiusScale("linear", float(expected.max()))
    surface = lobe_surface(grid, values, scale)
    luminance = scalar_of(expected.astype(np.float32), "colour")
    wanted = grid.directions * (luminance / scale.full)[..., None]
    np.testing.assert_allclose(surface.points, wanted, atol=2e-6)


@pytest.mark.parametrize("reciprocal", [True, False])
def test_a_table_is_looked_up_as_its_eval_does(reciprocal: bool) -> None:
    size = HalfAngleGrid(12, 10, 16, reciprocal)
    table = IsotropicTable(
        np.random.default_rng(3).random((*size.shape, 3), np.float32), reciprocal=reciprocal
    )
    grid = lobe_grid(LIGHT, 20, 24)
    values = LobeSource(table).brdf(grid)
    np.testing.assert_array_equal(values[:, :-1], table.eval(LIGHT, grid.directions)[:, :-1].astype("f4"))


def test_only_what_is_even_is_worked_out_on_one_side() -> None:
    assert LobeSource(MODELS["cook_torrance"].default).symmetric
    assert LobeSource(MODELS["aspecular"].default).symmetric
    assert not LobeSource(MODELS["poulin_fournier"].default).symmetric


def test_an_anisotropic_surface_turns_with_the_azimuth_and_an_isotropic_one_does_not() -> None:
    def shape_at(name: str, phi: float) -> np.ndarray:
        grid = lobe_grid(spherical(np.radians(40.0), np.radians(phi)), 16, 32)
        return LobeSource(MODELS[name].default).brdf(grid)

    brushed = shape_at("poulin_fournier", 0.0), shape_at("poulin_fournier", 90.0)
    assert np.abs(brushed[0] - brushed[1]).max() > 0.2 * brushed[0].max()
    np.testing.assert_allclose(
        shape_at("cook_torrance", 0.0), shape_at("cook_torrance", 90.0), rtol=1e-4, atol=1e-9
    )


def test_a_spike_of_exponent_1e5_is_seen() -> None:
    spike = CosineLobes((0.02,) * 3, (1e5,), ((0.0,) * 3,), ((1000.0,) * 3,))
    grid = lobe_grid(LIGHT)
    values = LobeSource(spike).brdf(grid)
    surface = lobe_surface(grid, values, RadiusScale("linear", greatest(values)))
    radius = np.linalg.norm(surface.points, axis=-1)
    assert radius[0] == pytest.approx(1.0, abs=1e-3)
    assert ((radius[:, 0] > 0.1) & (radius[:, 0] < 0.9)).sum() > 8, "its flank has points"
    # The flank falls from 1 to nothing over a few thousandths: its normals stand square to the spike.
    flank = (radius > 0.2) & (radius < 0.8)
    assert np.abs(surface.normals[flank] @ grid.mirror).max() < 0.02


def test_normals_of_a_surface_with_a_formula() -> None:
    grid = lobe_grid(LIGHT)
    d = grid.directions
    radius = 1.0 + 0.3 * d[..., 0] + 0.2 * d[..., 1] * d[..., 2]
    surface = difference_surface(grid, radius.astype(np.float32), RadiusScale("linear", 1.0))
    slope = np.stack((np.full_like(radius, 0.3), 0.2 * d[..., 2], 0.2 * d[..., 1]), axis=-1)
    slope -= np.einsum("jki,jki->jk", slope, d)[..., None] * d
    wanted = radius[..., None] * d - slope
    wanted /= np.linalg.norm(wanted, axis=-1, keepdims=True)
    cosine = np.einsum("jki,jki->jk", wanted, surface.normals)
    # The first rows lie within 0.05° of the mirror direction.
    assert np.degrees(np.arccos(np.clip(cosine[10:], -1.0, 1.0))).max() < 2.0
    assert np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))).max() < 15.0


class Holed:
    """Matt, but not a number where x > 0, and infinite at one place more."""

    def eval(self, wi, wo):
        value = np.full((*np.broadcast_shapes(np.shape(wi), np.shape(wo))[:-1], 3), 0.3)
        value[np.asarray(wo)[..., 0] > 0.2] = np.nan
        value[np.asarray(wo)[..., 1] > 0.9] = np.inf
        return value


@pytest.mark.parametrize("colouring", COLOURINGS)
@pytest.mark.parametrize("kind", RADIUS_KINDS)
def test_holes_are_left_out(kind, colouring) -> None:
    grid = lobe_grid(LIGHT, 32, 48)
    values = LobeSource(Holed()).brdf(grid)
    hole = np.isnan(values).any(axis=-1)
    expected = (grid.directions[..., 0] > 0.2) | (grid.directions[..., 1] > 0.9)
    assert np.array_equal(hole, expected)
    surface = lobe_surface(grid, values, RadiusScale(kind, 0.3), colouring=colouring)
    assert surface.holes == hole[:, :-1].sum()
    assert not hole.reshape(-1)[surface.faces].any()
    assert 0 < len(surface.faces) < len(grid_faces(*surface.shape))
    assert np.isfinite(surface.points).all()
    assert np.isfinite(surface.normals).all()
    beside = ~hole & (np.roll(hole, 1, axis=0) | np.roll(hole, -1, axis=0))
    d = grid.directions[beside]
    assert np.abs(np.einsum("ni,ni->n", surface.normals[beside], d)).min() > 0.9, "a sphere, up to its rim"


def test_what_was_not_measured_is_a_hole() -> None:
    grid = lobe_grid(LIGHT, 16, 24)
    source = LobeSource(MODELS["lambertian"].default, lambda wi, wo: np.asarray(wo)[..., 2] > 0.5)
    assert np.array_equal(np.isnan(source.brdf(grid)[..., 0]), grid.directions[..., 2] <= 0.5)


@pytest.mark.parametrize("kind", RADIUS_KINDS)
def test_a_brdf_of_zero_gives_a_surface_of_nothing_and_says_so(kind) -> None:
    grid = lobe_grid(LIGHT, 16, 24)
    zero = CosineLobes((0.0,) * 3, (10.0,), ((0.0,) * 3,), ((0.0,) * 3,))
    values = LobeSource(zero).brdf(grid)
    for surface in (
        lobe_surface(grid, values, RadiusScale(kind, 1.0)),
        difference_surface(grid, values[..., 0], RadiusScale(kind, 1.0)),
    ):
        assert surface.dark
        assert surface.holes == 0
        assert np.array_equal(surface.points, np.zeros_like(surface.points))
        assert np.isfinite(surface.normals).all()


@settings(max_examples=settings.default.max_examples // 2)
@given(st.sampled_from(RADIUS_KINDS), st.floats(1e-3, 1e4), st.floats(1.0, 8.0), st.floats(0.05, 1.5))
def test_the_scale_and_its_inverse(kind, full: float, decades: float, radius: float) -> None:
    scale = RadiusScale(kind, full, decades)
    assert float(scale.radius(scale.value(radius))) == pytest.approx(radius, abs=1e-5)
    assert float(scale.radius(full)) == pytest.approx(1.0, abs=1e-6)
    assert float(scale.radius(0.0)) == 0.0


def test_parts_add_up_to_the_fit() -> None:
    draws = np.random.default_rng(5)
    weights = LobeWeights(
        np.array([3.0, 40.0, 1e5]), draws.random(3), draws.random((3, 3)), draws.random((3, 3)), 0.7, 1.5
    )
    grid = lobe_grid(LIGHT, 24, 32)
    fit = FitOnGrid(weights, grid)
    lobes = fit_lobes(weights)
    assert [lobe.part for lobe in lobes] == ["diffuse"] + ["directional"] * 3 + ["gloss"] * 3
    expected = weights.eval(LIGHT, grid.directions)
    np.testing.assert_allclose(fit.brdf(), expected, rtol=1e-5)
    np.testing.assert_allclose(sum(fit.brdf([lobe]) for lobe in lobes), expected, rtol=1e-5)
    # Without one, what is left is the fit whose weight there is 0.
    kdd = weights.kdd.copy()
    kdd[1] = 0.0
    less = LobeWeights(weights.exponents, weights.kd, kdd, weights.kg, 0.7, 1.5)
    rest = [lobe for lobe in lobes if lobe.key != ("directional", 1)]
    np.testing.assert_allclose(fit.brdf(rest), less.eval(LIGHT, grid.directions), rtol=1e-5)


def test_channels_and_the_colour_of_light() -> None:
    values = np.array([[[0.2, 0.1, 0.05], [0.002, 0.001, 0.0005], [0.0, 0.0, 0.0]]], np.float32)
    assert [float(scalar_of(values, c)[0, 0]) for c in CHANNELS[1:4]] == pytest.approx([0.2, 0.1, 0.05])
    assert scalar_of(values, "luminance")[0, 0] == pytest.approx(0.2627 * 0.2 + 0.678 * 0.1 + 0.0593 * 0.05)
    codes = light_codes(values)[0]
    assert np.array_equal(codes[0], codes[1]), "as bright, however much light there is"
    assert codes[0, 0] > codes[0, 1] > codes[0, 2]
    assert codes[2].tolist() == [128, 128, 128]


def test_maps_are_even_and_the_middle_of_differences_is_grey() -> None:
    for codes in (value_map(), difference_map()):
        # Over eight entries the rounding to whole codes is small.
        working = srgb_decode(codes[::8] / 255.0) @ np.linalg.inv(WORKING_TO_SRGB).T
        white = 100.0 * WORKING_TO_XYZ.sum(axis=1)
        uniform = xyz_to_cam02ucs(100.0 * working @ WORKING_TO_XYZ.T, white)
        steps = np.linalg.norm(np.diff(uniform, axis=0), axis=-1)
        assert steps[1:-1].max() < 1.5 * steps[1:-1].min()
    middle = difference_map()[127:129].astype(int)
    assert np.ptp(middle, axis=1).max() <= 2
    luma = value_map() @ np.array([0.2126, 0.7152, 0.0722])
    assert np.all(np.diff(luma) > -1.0)
    assert luma[-1] > luma[0] + 150.0


def test_what_no_grid_or_scale_can_be() -> None:
    with pytest.raises(ValueError, match="columns even"):
        lobe_grid(LIGHT, 16, 31)
    for fields in ({"full": 0.0}, {"full": np.inf}, {"decades": 0.5}, {"kind": "square"}):
        with pytest.raises(ValueError, match=next(iter(fields))):
            RadiusScale(**fields)


def test_what_a_lobe_hides_and_where_a_ray_meets_it() -> None:
    grid = lobe_grid(LIGHT)
    values = LobeSource(MODELS["cook_torrance"].default).brdf(grid)
    surface = lobe_surface(grid, values, RadiusScale("cbrt", greatest(values)))
    some = grid.directions[3::9, 5::17].reshape(-1, 3)
    radius = np.linalg.norm(surface.points, axis=-1)[3::9, 5::17].reshape(-1)
    np.testing.assert_allclose(radius_along(surface, grid, some), radius, rtol=2e-3, atol=1e-4)
    assert radius_along(surface, grid, [0.0, 0.6, -0.8]) == 0.0
    # From the side of the light: what lies beyond the body is hidden, what lies before it and beside it is not.
    eye = np.array([0.0, 0.0, 6.0])
    body = 0.5 * float(radius_along(surface, grid, [0.0, 0.0, 1.0]))
    below, beside = [0.0, 0.0, 0.3 * body], [0.0, 0.9, 0.0]
    assert hidden(surface, grid, eye, [below, beside]).tolist() == [True, False]
    point = met(surface, grid, eye, [0.0, 0.0, -1.0])
    assert point is not None
    assert float(np.linalg.norm(point)) == pytest.approx(2.0 * body, abs=2e-3)
    nearest = values @ np.array([0.2627, 0.678, 0.0593])
    at = np.unravel_index(np.argmax(grid.directions[..., 2]), grid.shape)
    assert value_along(surface, grid, point / np.linalg.norm(point)) == pytest.approx(nearest[at], rel=0.02)
    assert met(surface, grid, eye, [0.6, 0.0, -0.8]) is None


@pytest.mark.parametrize("value", [1e37, 1e-42, np.inf])
def test_values_at_the_ends_of_single_precision_make_a_surface(value: float) -> None:
    class Even:
        def eval(self, wi, wo):
            return np.full(np.broadcast_shapes(np.shape(wi), np.shape(wo)), value)

    grid = lobe_grid(LIGHT)
    values = LobeSource(Even()).brdf(grid)
    made = lobe_surface(grid, values, RadiusScale("cbrt", 1.0))
    assert (made.holes == 0) == np.isfinite(value)
    assert np.isfinite(made.points).all()
