from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeWeights

UP = np.array([0.0, 0.0, 1.0])


def weights(**changes: object) -> LobeWeights:
    values: dict[str, object] = {
        "exponents": np.array([2.0, 100.0]),
        "kd": np.array([0.1, 0.2, 0.3]),
        "kdd": np.array([[0.4, 0.5, 0.6], [0.0, 0.0, 0.1]]),
        "kg": np.array([[0.0, 0.0, 0.0], [7.0, 8.0, 9.0]]),
        "theta_fit_rad": np.pi / 4,
        "ior": 1.5,
    }
    return LobeWeights(**(values | changes))  # type: ignore[arg-type]  # the test's own mixture of types


def test_eval_is_the_stated_sum_over_the_cosine() -> None:
    theta, gamma = np.radians(60.0), np.radians(20.0)
    wi = np.array([-np.sin(theta), 0.0, np.cos(theta)])
    wo = np.array([np.sin(theta - gamma), 0.0, np.cos(theta - gamma)])
    red = 0.1 * 0.5 + 0.5 * 0.4 * np.cos(gamma) ** 2 + 7.0 * np.cos(gamma) ** 100
    lobes = weights()
    assert lobes.reflected(wi, wo)[0] == pytest.approx(red, rel=1e-12)
    assert lobes.eval(wi, wo)[0] == pytest.approx(red / 0.5, rel=1e-12)


def test_negative_dots_and_the_horizon_are_zero() -> None:
    lobes = weights()
    light = np.array([-np.sin(1.2), 0.0, np.cos(1.2)])
    # More than 90° from the mirror direction: only the diffuse part is left.
    np.testing.assert_allclose(lobes.eval(light, light), lobes.kd)
    below = np.array([0.6, 0.0, -0.8])
    assert not lobes.eval(UP, below).any()
    assert not lobes.eval(below, UP).any()
    assert not lobes.eval(np.array([1.0, 0.0, 0.0]), UP).any()


def test_directions_broadcast() -> None:
    views = np.tile(UP, (4, 5, 1))
    assert weights().eval(UP, views).shape == (4, 5, 3)


@given(
    st.floats(0.0, 1.6),
    st.floats(0.0, 6.3),
    st.floats(0.0, 1.6),
    st.floats(0.0, 6.3),
    st.floats(1.0, 60_000.0),
)
def test_reflected_is_finite_and_never_negative(a: float, b: float, c: float, d: float, top: float) -> None:
    wi = np.array([np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)])
    wo = np.array([np.sin(c) * np.cos(d), np.sin(c) * np.sin(d), np.cos(c)])
    value = weights(exponents=np.array([1.0, top])).reflected(wi, wo)
    assert np.isfinite(value).all()
    assert (value >= 0.0).all()


@pytest.mark.parametrize("bad", [np.nan, np.inf, -1e-9])
@pytest.mark.parametrize("field", ["kd", "kdd", "kg"])
def test_bad_weights_are_refused(field: str, bad: float) -> None:
    values = np.array(getattr(weights(), field))
    values.flat[1] = bad
    with pytest.raises(FittingError, match=field):
        weights(**{field: values})


def test_wrong_shape_is_refused() -> None:
    with pytest.raises(FittingError, match="kdd"):
        weights(kdd=np.zeros((3, 3)))


def test_weights_cannot_be_changed_from_outside() -> None:
    kd = np.array([0.1, 0.2, 0.3])
    lobes = weights(kd=kd)
    kd[0] = -1.0
    assert lobes.kd[0] == 0.1
    with pytest.raises(ValueError, match="read-only"):
        lobes.kd[0] = 1.0


def test_energy_of_gloss_lobes() -> None:
    assert weights().coat_energy()[0] == pytest.approx(7.0 * 2 * np.pi / 101)
