"""The whole shader against closed forms: furnace, Fresnel, lobe integrals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB
from brdf_suite.documents.view import Camera, View
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.realtime.values import EnvironmentMaps, MaterialWeights, MeshPart

SIZE = (160, 160)
VIEW = View(Camera(azimuth_deg=20, elevation_deg=10), tone_curve="linear")
CODE = 1.0  # dither and rounding move a code by less than one


def codes(linear):
    c = np.clip(linear, 0, 1)
    return 255 * np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


def linear(codes_):
    c = codes_ / 255
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def draw(renderer, scenes, maps, weights, view=VIEW):
    """Return the picture, cos θ per pixel (NaN off the sphere and at its rim), normals, to viewer."""
    renderer.set_environment(maps)
    renderer.set_mesh([scenes.sphere(rings=200)])
    renderer.set_material("paint", weights)
    image = renderer.render_image(view, SIZE).astype(float)
    n, v = scenes.sphere_normals(renderer, view, SIZE)
    cos = (n * v).sum(-1)
    # Pixels at the rim are partly background.
    inner = np.isfinite(cos)
    for axis in (0, 1):
        inner = inner & np.roll(inner, 1, axis) & np.roll(inner, -1, axis)
    cos[~inner] = np.nan
    return image, cos, n, v


@pytest.mark.parametrize("albedo", [1.0, 0.5, 0.18])
def test_furnace(renderer, scenes, albedo):
    """A base of albedo a in a white room looks like a, to 0.5 %, everywhere."""
    image, cos, _, _ = draw(renderer, scenes, scenes.constant(), scenes.weights(kd=albedo, ior=1.0))
    inside = image[np.isfinite(cos)]
    assert len(inside) > 5000
    assert linear(inside).mean() == pytest.approx(albedo, rel=0.005)
    assert np.abs(inside - codes(albedo)).max() <= CODE


@pytest.mark.parametrize("ior", [1.33, 1.5, 1.7])
def test_mirror_coat_reflects_fresnel(renderer, scenes, ior):
    """A coat fitted at 45° reflects F(θ) of constant surroundings at every angle, and F(45°) with Fresnel off."""
    fit = float(fresnel_dielectric(np.cos(np.pi / 4), ior))
    weights = scenes.weights(gloss=fit, ior=ior)
    image, cos, _, _ = draw(renderer, scenes, scenes.constant(), weights)
    seen = np.isfinite(cos)
    expected = codes(fresnel_dielectric(cos[seen], ior))
    difference = np.abs(image[seen].mean(-1) - expected)
    assert np.nanmin(cos) < 0.25
    assert difference[cos[seen] > 0.4].max() <= CODE + 0.1
    # Between two vertices a position lies inside the sphere: at the rim, where F is steep, that shows.
    assert difference.max() <= 2.5

    flat = renderer.render_image(View(VIEW.camera, tone_curve="linear", fresnel="off"), SIZE)
    assert np.abs(flat[seen] - codes(fit)).max() <= CODE


@pytest.mark.parametrize("look_up", ["paper", "shifted"])
def test_base_is_dimmed_by_the_coat(renderer, scenes, look_up):
    """In the paper's form all light crosses the coat as the view does, in the shifted one each from where it comes.

    There the diffuse base is also that of the aspecular model, whose reading at γ under light at 45° has left the coat
    at the view of that γ: its mean over the light from all sides, in relation to that of the readings near 45°.
    """
    view = replace(VIEW, look_up=look_up)
    image, cos, _, _ = draw(renderer, scenes, scenes.constant(), scenes.weights(kd=0.6, ior=1.5), view)
    seen = np.isfinite(cos) & (cos > 0.25)
    at_fit = 1 - fresnel_dielectric(np.cos(np.pi / 4), 1.5)
    t = (1 - fresnel_dielectric(cos[seen], 1.5)) / at_fit
    c, weights = np.polynomial.legendre.leggauss(60)
    c, weights = (c + 1) / 2, weights / 2
    into = t if look_up == "paper" else 2 * (c * (1 - fresnel_dielectric(c, 1.5))) @ weights / at_fit
    if look_up == "shifted":
        cosines = np.linspace(0.25, 1.0, 16)
        into = into * np.interp(cos[seen], cosines, [lost_by_readings(cosine) for cosine in cosines])
    assert np.abs(image[seen].mean(-1) - codes(0.6 * t * into)).max() <= CODE + 0.5


def lost_by_readings(cosine: float, ior: float = 1.5) -> float:
    """Mean of T(45°)/T(45° - γ) over the light that crosses the coat to a base seen at ``cosine``, over that at 15°."""
    c, weights = np.polynomial.legendre.leggauss(40)
    c, weights = (c + 1) / 2, weights / 2
    phi = (np.arange(60) + 0.5) * np.pi / 60
    along = np.sqrt(1 - c * c)[:, None] * np.cos(phi) * np.sqrt(1 - cosine * cosine) + c[:, None] * cosine
    gamma = np.minimum(np.arccos(np.clip(along, -1, 1)), np.radians(110))
    left = 1 / (1 - fresnel_dielectric(np.cos(np.pi / 4 - gamma), ior))
    light = weights * c * (1 - fresnel_dielectric(c, ior))
    at_15 = 1 / (1 - fresnel_dielectric(np.cos(np.radians(30)), ior))
    return float((light @ left.mean(axis=1)) / light.sum() / at_15)


@pytest.mark.parametrize("ior", [2.4, 38.0])
def test_facet_lobes_follow_fresnel_and_leave_the_base(renderer, scenes, ior):
    base = scenes.weights(kd=0.3, ior=ior, coat="facets")
    image, cos, _, _ = draw(renderer, scenes, scenes.constant(), base)
    seen = np.isfinite(cos) & (cos > 0.25)
    assert np.abs(image[seen].mean(-1) - codes(0.3)).max() <= CODE
    gloss = scenes.weights(gloss=0.2, ior=ior, coat="facets")
    image, _, _, _ = draw(renderer, scenes, scenes.constant(), gloss)
    gain = fresnel_dielectric(cos[seen], ior) / fresnel_dielectric(np.cos(np.pi / 4), ior)
    assert np.abs(image[seen].mean(-1) - codes(0.2 * gain)).max() <= CODE + 0.5


def test_metal_rises_to_one(renderer, scenes):
    image, cos, _, _ = draw(
        renderer, scenes, scenes.constant(), scenes.weights(gloss=0.55, coat="metal", ior=1.0)
    )
    seen = np.isfinite(cos)
    expected = 0.55 + 0.45 * (1 - cos[seen]) ** 5
    assert np.abs(image[seen].mean(-1) - codes(expected)).max() <= CODE + 0.5
    assert image[seen].max() <= 255


def test_imprecise_coat_never_reflects_more_than_it_receives(renderer, scenes):
    """A fit whose gloss is twice F(θ_fit) would reflect 2 at grazing."""
    weights = scenes.weights(gloss=0.1, ior=1.5)
    view = View(VIEW.camera, tone_curve="linear", exposure_ev=-1)
    image, cos, _, _ = draw(renderer, scenes, scenes.constant(), weights, view)
    assert image[np.isfinite(cos)].max() <= np.ceil(codes(0.5))


def test_lobes_against_quadrature(renderer, scenes):
    """Each term, with its colour, against a direct sum over the sphere of the unnormalised lobe sum."""
    exponents = (3.0, 12.0, 40.0)
    rng = np.random.default_rng(4)
    kd, kdd, kg = rng.uniform(0, 0.06, 3), rng.uniform(0, 0.1, (3, 3)), rng.uniform(0, 0.1, (3, 3))

    def light(d):
        return np.stack(
            [1.2 + d[..., 0] + 0.3 * d[..., 1] ** 2, 1 + 0.8 * d[..., 1], 1.1 - 0.9 * d[..., 2]], -1
        )

    omega = scenes.directions(24).reshape(-1, 3)
    solid = np.abs(omega).max(-1) ** 3  # solid angle of a cube's texel ∝ its largest component cubed
    solid *= 4 * np.pi / solid.sum()
    radiance = light(omega) * solid[:, None]

    def integral(axis, e):
        return (np.maximum(axis @ omega.T, 0) ** e) @ radiance

    def prefiltered(e, size):
        return scenes.cube((e + 1) / (2 * np.pi) * integral(scenes.directions(size), e), 2.0)

    maps = EnvironmentMaps(
        exponents,
        tuple(prefiltered(e, 24) for e in exponents),
        *(prefiltered(1.0, size) for size in (16, 16, 4)),
    )
    weights = MaterialWeights(exponents, kd, kdd, kg, coat="none")
    image, cos, n, v = draw(renderer, scenes, maps, weights, replace(VIEW, look_up="paper"))
    rows, columns = np.nonzero(np.isfinite(cos) & (cos > 0.3))
    pick = rng.choice(len(rows), 60, replace=False)
    for row, column in zip(rows[pick], columns[pick], strict=True):
        normal, c = n[row, column], cos[row, column]
        r = 2 * c * normal - v[row, column]
        expected = kd * integral(normal, 1.0)
        for i, e in enumerate(exponents):
            expected = expected + (c * kdd[i] + kg[i]) * integral(r, e)
        # Maps are Rec. 2020, pictures sRGB.
        assert np.abs(image[row, column] - codes(WORKING_TO_SRGB @ expected)).max() <= 2.0
        assert expected.min() > 0.05
        assert expected.max() < 0.98


def centre_of_sheet(renderer, scenes, azimuth, view=VIEW):
    renderer.set_mesh([scenes.sheet()])
    camera = Camera(
        azimuth_deg=azimuth, elevation_deg=0, distance=1.0, target=(0.0, 0.0, 0.0), focal_length_mm=1200
    )
    return renderer.render_image(replace(view, camera=camera), (51, 51))[25, 25].astype(float)


def test_fresnel_towards_grazing(renderer, scenes):
    """A flat mirror coat, from normal incidence to 88°: F(θ), 4 % to 71 % of the surroundings."""
    renderer.set_environment(scenes.constant())
    renderer.set_material("paint", scenes.weights(gloss=float(fresnel_dielectric(np.cos(np.pi / 4), 1.5))))
    for angle in (0.0, 20.0, 45.0, 60.0, 75.0, 85.0, 88.0):
        expected = codes(fresnel_dielectric(np.cos(np.radians(angle)), 1.5))
        assert np.abs(centre_of_sheet(renderer, scenes, angle) - expected).max() <= CODE, angle


def test_thin_sheet_is_the_same_from_both_sides(renderer, scenes):
    """Normals that look away are turned to the viewer."""
    renderer.set_environment(scenes.constant())
    renderer.set_material("paint", scenes.weights(gloss=0.05, kd=0.3))
    front, behind = (centre_of_sheet(renderer, scenes, azimuth) for azimuth in (30.0, 150.0))
    assert np.abs(front - behind).max() <= 1
    assert 100 < front.min() < 200


def test_an_edge_rounded_within_a_pixel_does_not_glint(renderer, scenes):
    """A coated black rod thinner than half a pixel, before black in a white room.

    Seen whole, a cylinder shows the mean of F over its turn, .06; its area is .42 of a row of pixels. Shaded at the
    pixels' middles alone it showed seven times as much, in single bright dots.
    """
    fit = float(fresnel_dielectric(np.cos(np.pi / 4), 1.5))
    angle = np.linspace(0.0, 2.0 * np.pi, 25)
    normals = np.repeat(np.stack([0.0 * angle, np.cos(angle), np.sin(angle)], -1), 2, axis=0)
    ends = np.tile([[-0.1, 0.0, 0.0], [0.1, 0.0, 0.0]], (25, 1))
    i = np.arange(0, 48, 2)
    triangles = np.concatenate([np.stack([i, i + 1, i + 2], -1), np.stack([i + 1, i + 3, i + 2], -1)])
    renderer.set_environment(scenes.constant())
    renderer.set_mesh(
        [
            MeshPart("rod", "paint", ends + 0.001 * normals, normals, triangles.astype(np.uint32)),
            scenes.sheet("wall", half=0.3, centre=(0.0, 0.0, -0.01)),
        ]
    )
    renderer.set_material("paint", scenes.weights(gloss=fit, ior=1.5))
    renderer.set_material("wall", scenes.weights(ior=1.0, coat="none"))
    light = []
    for tilt in np.arange(3.0, 20.0):
        camera = Camera(azimuth_deg=tilt, elevation_deg=tilt, distance=0.6, target=(0.0, 0.0, 0.0))
        image = renderer.render_image(View(camera, tone_curve="linear"), (90, 90))
        light.append(linear(image[30:60, 30:60].astype(float)).mean(-1).sum())
    seen_whole = 30 * 0.42 * 0.06
    assert 0.5 * seen_whole < np.mean(light) < 3.0 * seen_whole
