from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles import AngleGrid, AngleWeights
from brdf_suite.fitting.lobes.angles.weights import gloss_lobes
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.geometry.fresnel import fresnel_dielectric

GRID = AngleGrid(8)
EXPONENTS = np.array([4.0, 900.0])


def table(**changes: object) -> AngleWeights:
    rng = np.random.default_rng(4)
    values: dict[str, object] = {
        "grid": GRID,
        "exponents": EXPONENTS,
        "kd": rng.uniform(0.0, 1.0, (8, 3)),
        "kdd": rng.uniform(0.0, 1.0, (8, 2, 3)),
        "kg": rng.uniform(0.0, 1.0, (8, 2, 3)),
        "ior": 1.5,
    }
    return AngleWeights(**(values | changes))  # type: ignore[arg-type]  # the test's own mixture of types


@pytest.mark.parametrize("theta_deg", [0.0, 20.0, 45.0, 63.0, 80.0])
def test_at_the_mirror_it_is_the_weights_of_that_angle(theta_deg: float) -> None:
    """The gloss is narrower across the plane by the cosine, and of the same energy: its peak is higher."""
    weights = table()
    wi, wo = illumination(theta_deg), aspecular_view(theta_deg, 0.0)
    there = weights.at(float(wi[2]))
    expected = there.kd + there.kdd.sum(axis=0) + there.kg.sum(axis=0) / wi[2] ** 2
    np.testing.assert_allclose(weights.eval(wi, wo), expected, rtol=1e-6)
    np.testing.assert_allclose(weights.reflected(wi, wo), wi[2] * expected, rtol=1e-6)


def test_the_stated_sum_away_from_the_mirror() -> None:
    weights = table()
    theta, gamma = 50.0, -20.0
    wi, wo = illumination(theta), aspecular_view(theta, gamma)
    base, gloss = weights.at(float(wi[2])), weights.at(np.cos(np.radians(60.0)))
    lobes = np.cos(np.radians(gamma)) ** EXPONENTS
    t = (1 - fresnel_dielectric(np.cos(np.radians(70.0)), 1.5)) / (
        1 - fresnel_dielectric(np.cos(np.radians(30.0)), 1.5)
    )
    g = np.sqrt(wi[2] / wo[2]) / np.cos(np.radians(60.0))
    expected = t * wi[2] * (base.kd + lobes @ base.kdd) + g * (lobes @ gloss.kg)
    np.testing.assert_allclose(weights.reflected(wi, wo), expected, rtol=1e-9)
    np.testing.assert_allclose(weights.eval(wi, wo), expected / wi[2], rtol=1e-9)
    bare = table(base_under_coat=False)
    expected = wi[2] * (base.kd + lobes @ base.kdd) + g * (lobes @ gloss.kg)
    np.testing.assert_allclose(bare.reflected(wi, wo), expected, rtol=1e-9)


def test_the_normals_side_is_the_lobes_alone() -> None:
    weights = table()
    views = np.stack([aspecular_view(55.0, gamma) for gamma in (0.0, 10.0, 45.0, 100.0)])
    t = weights.passing(np.broadcast_to(illumination(55.0), views.shape), views)
    np.testing.assert_allclose(t, 1.0, rtol=1e-9)


def test_horizon_shapes_and_finiteness() -> None:
    weights = table()
    rng = np.random.default_rng(1)
    directions = rng.normal(size=(500, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    directions = np.concatenate([directions, [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])
    value = weights.eval(directions[:, None], directions[None, :])
    assert value.shape == (503, 503, 3)
    assert np.isfinite(value).all()
    assert (value >= 0.0).all()
    below = directions[:, 2] <= 0.0
    assert (value[below] == 0.0).all()
    assert (value[:, below] == 0.0).all()


def test_texture_holds_every_weight_at_its_texel_centre() -> None:
    weights = table()
    texels = weights.texture()
    assert texels.dtype == np.float32
    assert texels.shape == (5, 8, 4)
    assert texels.flags.c_contiguous
    np.testing.assert_allclose(texels[0, :, :3], weights.kd, rtol=1e-6)
    np.testing.assert_allclose(texels[1:3, :, :3], weights.kdd.transpose(1, 0, 2), rtol=1e-6)
    np.testing.assert_allclose(texels[3:, :, :3], weights.kg.transpose(1, 0, 2), rtol=1e-6)
    np.testing.assert_allclose(texels[:, 0, 3], [0, *EXPONENTS, *EXPONENTS])
    # Linear filtering by hand, at the stated coordinate, is what the value itself gives.
    cosine = 0.31
    place = float(GRID.coordinate(cosine)) * 8 - 0.5
    k, share = int(place), place - int(place)
    mixed = (1 - share) * texels[:, k] + share * texels[:, k + 1]
    there = weights.at(cosine)
    np.testing.assert_allclose(mixed[3:, :3], there.kg, rtol=1e-5)
    # The formula for shaders.
    x = ((cosine - GRID.lowest_cosine) / (1 - GRID.lowest_cosine)) ** (1 / GRID.power)
    assert (x * 7 + 0.5) / 8 == pytest.approx(float(GRID.coordinate(cosine)))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"kd": np.zeros((7, 3))}, "kd have shape"),
        ({"kg": np.full((8, 2, 3), -1e-9)}, "kg hold a negative"),
        ({"kdd": np.full((8, 2, 3), np.nan)}, "kdd hold a negative or not finite"),
        ({"ior": 0.9}, "refractive index"),
    ],
)
def test_refusals(change: dict[str, object], words: str) -> None:
    with pytest.raises(FittingError, match=words):
        table(**change)


@pytest.mark.parametrize("under_coat", [False, True])
def test_a_base_halfway_is_reciprocal_and_looked_up_there(under_coat: bool) -> None:
    weights = table(base_under_coat=under_coat, base_at_halfway=True)
    wi, wo = illumination(70.0), aspecular_view(70.0, 30.0)
    half = np.cos(np.radians(55.0))
    there = weights.at(half)
    lobes = np.cos(np.radians(30.0)) ** EXPONENTS
    passed = 1.0 - fresnel_dielectric(np.array([wi[2], wo[2], half]), weights.ior)
    t = passed[0] * passed[1] / passed[2] ** 2 if under_coat else 1.0
    expected = t * (there.kd + lobes @ there.kdd) + lobes @ there.kg / np.sqrt(wi[2] * wo[2]) / half
    np.testing.assert_allclose(weights.eval(wi, wo), expected, rtol=1e-9)
    np.testing.assert_allclose(weights.eval(wo, wi), expected, rtol=1e-9)


@pytest.mark.parametrize("theta", [30.0, 60.0])
def test_a_gloss_lobe_has_the_energy_of_a_round_one_and_is_narrower_across_the_plane(theta: float) -> None:
    exponent = np.array([800.0])
    view = np.array([-np.sin(np.radians(theta)), 0.0, np.cos(np.radians(theta))])
    mirror, normalward = view * [-1, -1, 1], np.array([-view[2], 0.0, -view[0]])
    offsets = np.linspace(-0.25, 0.25, 401)
    u, v = np.meshgrid(offsets, offsets, indexing="ij")
    light = mirror + u[..., None] * normalward + v[..., None] * np.array([0.0, 1.0, 0.0])
    length = np.linalg.norm(light, axis=-1)
    lobe = gloss_lobes(exponent, light / length[..., None], np.broadcast_to(view, light.shape))[..., 0]
    root = np.sqrt(light[..., 2] / length / view[2])
    energy = (lobe * root / length**3).sum() * (offsets[1] - offsets[0]) ** 2
    assert energy == pytest.approx(2.0 * np.pi / 801.0, rel=0.02)
    along, across = lobe[:, 200], lobe[200]
    widths = [np.count_nonzero(cut > 0.5 * cut.max()) for cut in (along, across)]
    assert widths[1] / widths[0] == pytest.approx(np.cos(np.radians(theta)), rel=0.05)
