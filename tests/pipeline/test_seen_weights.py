"""Weights for every angle of the view: what constant light brings back, in the picture too, and who waits for them."""

from __future__ import annotations

import logging
import threading

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.errors import FittingError
from brdf_suite.pipeline.any_fit import fit_any
from brdf_suite.pipeline.paint_angles import PaintAngles
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.seen_weights import SeenWeights, seen_weights
from brdf_suite.realtime.look_up_table import RAMP_COSINES, look_up_table
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps, MeshPart
from brdf_suite.reflectance.albedo import white_furnace

WHITE = CubeFaces(np.ones((6, 32, 32, 3), np.float16))


class Sheen:
    """A reflectance that is dark along the normal and bright at grazing, in three colours; anisotropic if asked."""

    def __init__(self, brushed: float = 0.0, sign: float = 1.0) -> None:
        self.brushed = brushed
        self.sign = sign

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        rise = 0.05 + 0.2 * (1.0 - wi[..., 2]) * (1.0 - wo[..., 2])
        half = wi + wo
        turn = 1.0 + self.brushed * np.cos(2.0 * np.arctan2(half[..., 1], half[..., 0]))
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        value = self.sign * np.where(above, rise * turn, 0.0)
        return value[..., None] * np.array([1.0, 0.5, 0.1])


def directional(reflectance, cosine: float) -> np.ndarray:
    """What constant light of 1 sends to a view (3,)."""
    return white_furnace(reflectance, [-np.sqrt(1.0 - cosine**2), 0.0, cosine])


def returned(weights, exponents, place: int) -> np.ndarray:
    """What the weights bring back of constant light of 1, (3,), by the amplitudes of their look-ups."""
    total = np.pi * weights.kd[place]
    for lobe, exponent in enumerate(exponents):
        for target, part in (("plain", weights.kdd), ("gloss", weights.kg)):
            if part[place, lobe].any():
                total = total + part[place, lobe] * look_up_table().find(target, exponent).amplitude[place]
    return total


@pytest.fixture(scope="module")
def silver():
    return fit_any("table1_polaris_silver", errors=False)


def test_constant_light_comes_back_at_every_angle(silver) -> None:
    exponents = tuple(silver.weights.exponents.tolist())
    for reflectance in (silver.reflectance, Sheen()):
        weights = seen_weights(reflectance, exponents)
        for place in (15, 30, 42, 50, 63):
            wanted = directional(reflectance, float(RAMP_COSINES[place]))
            np.testing.assert_allclose(returned(weights, exponents, place), wanted, rtol=0.01)


def test_what_differs_with_the_azimuth_is_seen_in_its_mean(silver) -> None:
    exponents = tuple(silver.weights.exponents.tolist())
    plain, brushed = (seen_weights(Sheen(b), exponents) for b in (0.0, 0.5))
    np.testing.assert_allclose(brushed.kd, plain.kd, rtol=0.05, atol=1e-3)


def test_the_picture_is_as_bright_as_the_paint_and_the_modes_stay_apart(silver) -> None:
    """A sheet in white light at 70°, where a lobe fitted in the plane at 45° brings back two thirds."""
    n = np.array([[0.0, 0.0, 1.0]] * 3)
    sheet = MeshPart("sheet", "paint", [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], n, [[0, 1, 2]])
    exponents = (1.0, 8.0, 86.5, *(e for e in silver.weights.exponents if e > 100))
    seen = {}
    with OffscreenScene((8, 8)) as scene:
        scene.renderer.set_environment(EnvironmentMaps(exponents, (WHITE,) * len(exponents), WHITE, WHITE))
        scene.renderer.set_mesh([sheet])
        scene.set_paint_fit(silver)
        camera = Camera(70, 0, distance=2.0, target=(0.0, 0.0, 0.0))
        for name, modes in {
            "raised": {},
            "multi_angle": {"fresnel": "multi_angle"},
            "off": {"fresnel": "off"},
            "paper": {"look_up": "paper"},
        }.items():
            picture = scene.renderer.linear_image(View(camera, **modes), (16, 16), 1)
            seen[name] = picture[8, 8, :3].astype(float)
    wanted = directional(silver.reflectance, np.cos(np.radians(70.0)))
    np.testing.assert_allclose(seen["raised"], wanted, rtol=0.05)
    np.testing.assert_array_equal(seen["multi_angle"], seen["raised"])
    assert (seen["off"] < 0.75 * wanted).all()
    assert (seen["paper"] < 0.75 * wanted).all()


def test_designed_paints_and_scattered_samples_keep_their_way(silver) -> None:
    angles = PaintAngles(time_limit_s=1.0)
    assert angles.by_view(fit_any("red", errors=False)) is None
    assert angles.by_view(silver) is not None
    angles.close()


def test_found_once_and_in_a_window_on_a_thread(silver) -> None:
    told = threading.Event()
    angles = PaintAngles(changed=told.set)
    given = angles.by_view(silver)
    assert given is not None
    assert given.weights() is None
    assert told.wait(60.0)
    found = given.weights()
    assert found is not None
    assert given.weights() is found
    angles.close()


def test_what_cannot_be_fitted_is_refused_and_told(caplog: pytest.LogCaptureFixture) -> None:
    exponents = (2.0, 20.0, 1000.0)
    with pytest.raises(FittingError, match=r"red channel is negative .* with the view at"):
        seen_weights(Sheen(sign=-1.0), exponents)
    with caplog.at_level(logging.WARNING):
        assert SeenWeights(Sheen(sign=-1.0), exponents).weights() is None
    assert "one incidence" in caplog.text
