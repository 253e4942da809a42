"""Flakes of the ray tracer: those of the core, and with the mean light of the paint without them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.flakes.visible import FLAKE_WAVINESS, LARGEST_SHARE
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.pipeline.material import load_material
from brdf_suite.reference.variant import Variant
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.raytraced.picture import Quality, RaytracedSession

PLAIN = View(surface="sphere", background="grey", sparkle=Sparkle(mode="off"))
FLAKES = Flakes(density_per_mm2=4.0, size_um=400.0, roughness=0.2, colour_spread=0.3)


def test_flakes_are_those_of_the_core(variant: Variant) -> None:
    """Ratio by ratio: the same places, footprints, slopes and spreads in numpy."""
    import mitsuba as mi

    from brdf_suite.appearance.flakes.tilt import flake_slope
    from brdf_suite.reference.flakes.population import FlakeLayer
    from brdf_suite.reference.flakes.texture import flakes_seen
    from brdf_suite.reference.raytraced.flakes import sparkling
    from tools.evaluation.flake_model import flake_texture_ratio

    rng = np.random.default_rng(7)
    n = 4000
    at = rng.uniform(-300.0, 300.0, (n, 2)).astype(np.float32).astype(float)
    across, down = rng.normal(size=(2, n, 2)) * 10.0 ** rng.uniform(-2.0, 0.3, (n, 1))
    wi, wo = rng.normal(size=(2, n, 3)) * [0.3, 0.3, 0.1] + [0.0, 0.0, 1.0]
    wi, wo = (w / np.linalg.norm(w, axis=1)[:, None] for w in (wi, wo))
    spread = rng.uniform(0.0, 0.2, n)
    layer = FlakeLayer(FLAKES, 1.5)
    two = [mi.Point2f(np.ascontiguousarray(x.T, np.float32)) for x in (at, across, down)]
    seen = flakes_seen(FLAKES, two[0], mi.Vector2f(two[1]), mi.Vector2f(two[2]))
    light, view = (mi.Vector3f(np.ascontiguousarray(w.T, np.float32)) for w in (wi, wo))
    base = mi.Color3f(1e6)  # so bright that flakes have a small share of it, and the sum gives the ratio
    value = np.array(sparkling(layer, seen, light, view, mi.Float(spread.astype(np.float32)), base)).T
    mean = np.array(
        sparkling(layer, replace(seen, contrast=mi.Float(0.0)), light, view, mi.Float(0.0), base)
    ).T
    np.testing.assert_allclose(mean, 1e6, rtol=1e-6)
    slope = flake_slope(wi, wo, 1.5)
    own = np.sqrt((spread / 3.0) ** 2 + FLAKE_WAVINESS**2)
    wanted = flake_texture_ratio(
        at,
        across,
        down,
        slope,
        own,
        density=FLAKES.density_per_mm2,
        size=FLAKES.size_um * 1e-3,
        roughness=FLAKES.roughness,
        colour_spread=FLAKES.colour_spread,
    )
    # Where base is this bright, what flakes add is wanted share times (ratio - 1): the share is read off a dim base.
    dim = mi.Color3f(1e-9)
    ratio = (
        np.array(sparkling(layer, seen, light, view, mi.Float(spread.astype(np.float32)), dim)).T / 1e-9 - 1.0
    )
    ratio = 1.0 + ratio / LARGEST_SHARE
    close = np.abs(ratio - wanted) <= 0.02 * wanted + 0.02
    assert close.mean() > 0.995  # single precision puts a few places in another cell
    assert (np.abs(wanted - 1.0) > 0.2).mean() > 0.1
    assert np.isfinite(value).all()


def test_flakes_keep_the_mean_light_and_stay_where_they_are(variant: Variant, sphere: Mesh) -> None:
    """With and without, over a ball in a small bright light; and from a camera moved by a tenth of a pixel."""
    lamp = Lamp("directional", azimuth_deg=20.0, elevation_deg=30.0, strength=3.0)
    view = replace(PLAIN, camera=Camera(10.0, 10.0), lamps=(lamp,), sparkle=Sparkle(mode="texture"))
    base = load_material("copper")
    size = (160, 120)
    d = direction(ring_angles(8)[:, None], column_angles(16)[None])
    light = Environment("sky", (1.0 + 0.8 * d).astype(np.float32))
    session = RaytracedSession()

    def shown(view: View, flakes: Flakes | None) -> np.ndarray:
        session.show(
            replace(base, flakes=flakes), view, size, Quality(16, 1, 4), environment=light, mesh=sphere
        )
        image = session.frame()
        return np.where((image.sums.coverage == 1.0)[..., None], image.sums.radiance, np.nan)[..., 1]

    fine = Flakes(density_per_mm2=1.0, size_um=500.0, roughness=0.2)
    smooth, sparkling = shown(view, None), shown(view, fine)
    inside = np.isfinite(smooth)
    assert sparkling[inside].mean() / smooth[inside].mean() == pytest.approx(1.0, abs=0.02)
    first = (sparkling / smooth)[inside]
    assert first.std() > 0.05
    moved = replace(view, camera=Camera(10.02, 10.0))
    second = shown(moved, fine) / shown(moved, None)
    both = inside & np.isfinite(second)
    assert np.corrcoef((sparkling / smooth)[both], second[both])[0, 1] > 0.9
    far = replace(view, camera=Camera(10.0, 10.0, distance=3.0))
    distant = shown(far, fine) / shown(far, None)
    assert np.nanstd(distant) < 0.01
    off = replace(view, sparkle=Sparkle(mode="off"))
    np.testing.assert_array_equal(shown(off, fine)[inside], smooth[inside])
