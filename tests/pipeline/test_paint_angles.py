"""Weights over the incidence: fitted when a picture asks, in the background where a window waits."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.fitting.lobes.angles import AngleFitter
from brdf_suite.pipeline.lobe_fit import PaintFitter, fit_material
from brdf_suite.pipeline.material import default_paint, load_material, load_shipped_paint
from brdf_suite.pipeline.paint_angles import PaintAngles, at_ramp
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.realtime.environment.look_up_table import RAMP_COSINES, look_up_table
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps, MeshPart

WHITE = CubeFaces(np.ones((6, 32, 32, 3), np.float16))


@pytest.fixture(scope="module")
def fitter():
    fitter = PaintFitter(time_limit_s=1.0)
    yield fitter
    fitter.close()


def test_the_ramp_has_what_the_table_says(fitter):
    weights = AngleFitter(time_limit_s=1.0).fit(fitter.fit(default_paint()).reflectance).weights
    ramp = at_ramp(weights)
    for k in (0, 9, 30, 63):
        at = weights.at(RAMP_COSINES[k])
        np.testing.assert_allclose(ramp.kd[k], at.kd, rtol=1e-12, atol=1e-15)
        np.testing.assert_allclose(ramp.kdd[k], at.kdd, rtol=1e-12, atol=1e-15)
        # The coat of a glossy paint is as narrow as its lobes: round ones have its energy, but for the last degrees.
        np.testing.assert_allclose(ramp.kg[k], at.kg, rtol=0.1 if k < 9 else 0.01, atol=1e-15)


def test_asked_once_and_only_by_its_mode(fitter, monkeypatch):
    asked = []
    fit_at_once = AngleFitter.fit
    monkeypatch.setattr(AngleFitter, "fit", lambda self, layers: asked.append(1) or fit_at_once(self, layers))
    fits = [fitter.fit(load_shipped_paint(name)) for name in ("satin_white", "blue")]
    n = np.array([[0.0, 0.0, 1.0]] * 3)
    sheet = MeshPart("sheet", "paint", [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], n, [[0, 1, 2]])
    exponents = (1.0, 8.0, *(e for e in fits[0].weights.exponents if e > 100))
    with OffscreenScene() as scene:
        scene.renderer.set_environment(
            EnvironmentMaps(exponents, (WHITE,) * len(exponents), WHITE, WHITE, WHITE)
        )
        scene.renderer.set_mesh([sheet])
        view = View(Camera(70, 5, distance=2.0, target=(0.0, 0.0, 0.0)))
        pictures = {}
        for fit in fits:
            scene.set_material(fit)
            for mode in ("off", "raised", "multi_angle", "raised", "multi_angle"):
                shown = View(view.camera, fresnel=mode)
                scene.prepare(shown)
                pictures[mode] = scene.renderer.linear_image(shown, (16, 16), 1)[8, 8, :3]
            assert len(asked) == 1 + fits.index(fit)
        apart = {name: float(pictures[name].mean()) for name in ("off", "raised", "multi_angle")}
        # At 70° a coat reflects three times as much as at 45°: both ways know it, and they agree.
        assert apart["multi_angle"] == pytest.approx(apart["raised"], rel=0.02)
        assert apart["off"] != pytest.approx(apart["raised"], rel=0.01)


def test_on_a_thread_where_a_caller_waits(fitter):
    called = threading.Event()
    angles = PaintAngles(
        time_limit_s=30.0, changed=called.set
    )  # nothing comes late, however busy the machine
    asked = angles.of(fitter.fit(default_paint()))
    assert asked.weights() is None
    assert called.wait(60)
    weights = asked.weights()
    assert weights is not None
    assert asked.weights() is weights
    assert angles.of(fitter.fit(default_paint())).weights() is not None  # the fitter is kept
    angles.close()


def test_a_fit_whose_solver_is_being_set_up_is_pending_in_its_mode_only(fitter):
    called = threading.Event()
    angles = PaintAngles(time_limit_s=30.0, changed=called.set)
    fit, view = fitter.fit(default_paint()), View(fresnel="multi_angle")
    assert not angles.is_pending(fit, view)
    angles.prepare(fit, view)
    assert angles.is_pending(fit, view)
    assert not angles.is_pending(fit, View(fresnel="raised"))
    assert called.wait(60)
    angles.prepare(fit, view)
    assert not angles.is_pending(fit, view)
    assert angles.weights(fit).over_angle is not None
    angles.close()


def test_facet_lobes_and_what_nothing_divides():
    angles = PaintAngles(time_limit_s=1.0)
    fit = fit_material(load_material("table1_blue"))
    assert angles.of(fit).weights().kg.max() > 0

    class Measured:
        reflectance = object()
        weights = fit.weights

    assert angles.of(Measured()) is None
    angles.close()


@pytest.mark.parametrize("name", ["satin_blue", "satin_graphite"])
def test_the_table_draws_the_energy_of_the_coat_up_to_grazing(name: str) -> None:
    """A picture draws round lobes, of which half is below the horizon where the fitted ones are narrow."""
    reflectance = load_material(name).reflectance
    fitter = AngleFitter(time_limit_s=10.0)
    fit = fitter.fit(reflectance)
    drawn = at_ramp(fit.weights)
    wanted = fitter.sample(reflectance).rings[..., 0] * fitter.coat_samples.solid_angle
    fitter.close()
    for k, cosine in enumerate(fitter.grid.cosines):
        node = int(np.argmin(np.abs(RAMP_COSINES - cosine)))
        amplitudes = [look_up_table().find("gloss", e).amplitude[node] for e in fit.weights.exponents]
        assert drawn.kg[node, :, 0] @ amplitudes == pytest.approx(wanted[k].sum(), rel=0.08)
