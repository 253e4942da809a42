from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeWeights
from brdf_suite.fitting.lobes.weights import RaisedWeights
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.geometry.fresnel import fresnel_dielectric

COS_45 = np.cos(np.pi / 4)


def weights(scale: float = 1.0, **changes: object) -> LobeWeights:
    reflected = float(fresnel_dielectric(COS_45, 1.5))
    values: dict[str, object] = {
        "exponents": np.array([2.0, 5000.0]),
        "kd": np.array([0.1, 0.2, 0.3]),
        "kdd": np.array([[0.4, 0.5, 0.6], [0.0, 0.0, 0.1]]),
        "kg": np.array([np.zeros(3), scale * np.ones(3) * reflected * 5001.0 / (2.0 * np.pi)]),
        "theta_fit_rad": np.pi / 4,
        "ior": 1.5,
    }
    return LobeWeights(**(values | changes))  # type: ignore[arg-type]  # the test's own mixture of types


def test_nothing_changes_at_the_incidence_of_the_fit() -> None:
    raised = RaisedWeights(weights())
    wo = aspecular_view(45.0, np.array([-15.0, 15.0, 45.0, 110.0]))
    np.testing.assert_allclose(raised.eval(illumination(45.0), wo), weights().eval(illumination(45.0), wo))


@pytest.mark.parametrize("theta", [0.0, 30.0, 60.0, 80.0])
def test_the_mirror_reflects_fresnels_share_and_the_base_loses_it_twice(theta: float) -> None:
    wi, wo = illumination(theta), aspecular_view(theta, 0.0)
    cosine = float(wi[2])
    f, f_fit = fresnel_dielectric(cosine, 1.5), fresnel_dielectric(COS_45, 1.5)
    for angle in ("light", "view"):
        raised = RaisedWeights(weights(), angle)
        base, gloss = raised.gains(cosine)
        assert base == pytest.approx(((1 - f) / (1 - f_fit)) ** 2)
        assert gloss == pytest.approx(f / f_fit)
        assert gloss * weights().coat_energy()[0] == pytest.approx(f)
        w = weights()
        expected = cosine * base * (w.kd + w.kdd.sum(axis=0)) + gloss * w.kg.sum(axis=0)
        np.testing.assert_allclose(raised.reflected(wi, wo), expected, rtol=1e-9)


def test_light_and_view_are_distinguished_away_from_the_mirror() -> None:
    wi, wo = illumination(70.0), aspecular_view(70.0, 60.0)
    by_light, by_view = RaisedWeights(weights()), RaisedWeights(weights(), "view")
    ratio = by_light.gains(wi[2])[0] / by_view.gains(wo[2])[0]
    np.testing.assert_allclose(by_light.eval(wi, wo) / by_view.eval(wi, wo), ratio, rtol=1e-6)
    assert ratio < 0.9


def test_no_more_than_all_light_is_reflected() -> None:
    raised = RaisedWeights(weights(scale=4.0))
    _, gloss = raised.gains(np.linspace(0.0, 1.0, 50))
    assert (gloss * raised.weights.coat_energy().max()).max() <= 1.0 + 1e-12


def test_no_coat_and_a_base_that_gives_nothing() -> None:
    base, gloss = RaisedWeights(weights(ior=1.0)).gains([0.0, 0.3, 1.0])
    assert (base == 1.0).all()
    assert (gloss == 1.0).all()
    base, gloss = RaisedWeights(weights(base_under_coat=False)).gains([0.3])
    assert base[0] == 1.0
    assert gloss[0] > 1.0


def test_the_horizon_is_dark_and_all_is_finite() -> None:
    rng = np.random.default_rng(2)
    directions = rng.normal(size=(200, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    value = RaisedWeights(weights()).eval(directions[:, None], directions[None])
    assert np.isfinite(value).all()
    assert (value[directions[:, 2] <= 0.0] == 0.0).all()


def test_an_unknown_angle_is_refused() -> None:
    with pytest.raises(FittingError, match='not "half"'):
        RaisedWeights(weights(), "half")  # type: ignore[arg-type]  # what is refused
