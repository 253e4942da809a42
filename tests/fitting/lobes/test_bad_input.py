"""Whatever comes in: weights that are finite and not negative, or an error that says what was wrong."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeBasis, LobeFitter

ANY = st.one_of(
    st.floats(0.0, 10.0),
    st.floats(0.0, 1e90),
    st.sampled_from([0.0, 5e-324, 1e-300, -1e-9, 1e300, np.nan, np.inf]),
)
SOUND = st.one_of(st.floats(0.0, 10.0), st.floats(0.0, 1e90), st.sampled_from([0.0, 5e-324, 1e-300]))


def shapes(fitter: LobeFitter) -> tuple[tuple[int, int], tuple[int, int]]:
    return (fitter.base_samples.gamma_rad.size, 3), (fitter.coat_samples.gamma_rad.size, 3)


@pytest.fixture(scope="module", params=["absolute", "relative", "measured", "hurried"])
def any_fitter(request: pytest.FixtureRequest) -> Iterator[LobeFitter]:
    if request.param == "hurried":
        made = LobeFitter(time_limit_s=1e-6)
        # Its thread must not come to an optimum: whether it does before the next example is a matter of the load.
        with made.solver.background.lock:
            yield made
    elif request.param == "measured":
        made = LobeFitter(time_limit_s=60.0, diffuse="measured")
        yield made
    else:
        made = LobeFitter(time_limit_s=60.0, weighting=request.param)
        yield made
    made.close()


# On a busy machine the drawing of some hundred numbers is slow; that is no fault of what is tested.
@settings(max_examples=settings.default.max_examples // 2)
@given(data=st.data())
def test_any_samples_give_sound_weights_or_a_named_error(any_fitter: LobeFitter, data: st.DataObject) -> None:
    values = data.draw(st.sampled_from([ANY, SOUND]))
    base, coat = (data.draw(arrays(np.float64, shape, elements=values)) for shape in shapes(any_fitter))
    sound = all(((a >= 0.0) & (a <= 1e100)).all() for a in (base, coat))
    if not sound:
        with pytest.raises(FittingError, match=r"cannot be fitted: its (red|green|blue) channel .*°"):
            any_fitter.fit_samples(base, coat, ior=1.5)
        return
    fit = any_fitter.fit_samples(base, coat, ior=1.5)
    for values in (fit.weights.kd, fit.weights.kdd, fit.weights.kg):
        assert np.isfinite(values).all()
        assert (values >= 0.0).all()
    for error in (fit.base_error, fit.coat_error):
        assert (error.relative >= 0.0).all()
    if any_fitter.diffuse == "joint":
        assert (fit.base_error.relative <= 1.0 + 1e-9).all()  # never worse than no weights at all


def test_a_paint_brighter_than_any_reflectance_is_named(fitter: LobeFitter) -> None:
    base, coat = (np.full(shape, 1e200) for shape in shapes(fitter))
    with pytest.raises(FittingError, match="beyond any reflectance"):
        fitter.fit_samples(base, coat, ior=1.5)


def test_a_paint_that_no_lobe_sum_follows_is_answered_as_near_as_they_come(fitter: LobeFitter) -> None:
    """Bright in one direction alone: every lobe that is bright there is bright beside it too."""
    base, coat = (np.zeros(shape) for shape in shapes(fitter))
    base[fitter.base_samples.gammas_deg.index(110.0)] = 1.0
    fit = fitter.fit_samples(base, coat, ior=1.5)
    assert not fit.time_limited
    assert (fit.base_error.relative <= 1.0).all()
    assert not fit.weights.kg.any()


def test_one_dark_channel_beside_two(fitter: LobeFitter) -> None:
    base, coat = (np.ones(shape) for shape in shapes(fitter))
    base[:, 0] = 0.0
    coat[:, 2] = 0.0
    weights = fitter.fit_samples(base, coat, ior=1.5).weights
    assert weights.kd[0] == 0.0
    assert (weights.kd[1:] > 0.0).all()
    assert not weights.kg[:, 2].any()


def test_duplicate_exponents_are_named() -> None:
    with pytest.raises(FittingError, match="16 follows 16"):
        LobeBasis((4.0, 16.0, 16.0))


def test_exponents_that_are_nearly_one_still_fit() -> None:
    fitter = LobeFitter(LobeBasis((4.0, 16.0, 16.0 + 1e-12, 16.0 + 1e-6, 200.0)), time_limit_s=60.0)
    base, coat = (np.ones(shape) for shape in shapes(fitter))
    weights = fitter.fit_samples(base * np.linspace(1.0, 0.1, len(base))[:, None], coat, ior=1.5).weights
    assert np.isfinite(weights.kdd).all()


@pytest.mark.parametrize("ior", [np.nan, np.inf, 0.5, -1.5])
def test_an_index_that_no_coat_has_is_refused(fitter: LobeFitter, ior: float) -> None:
    base, coat = (np.ones(shape) for shape in shapes(fitter))
    with pytest.raises(FittingError, match="refractive index"):
        fitter.fit_samples(base, coat, ior=ior)
    weights = fitter.fit_samples(base, coat, ior=1.0).weights
    with pytest.raises(FittingError, match="refractive index"):
        replace(weights, ior=ior)


def test_a_fit_that_is_refused_leaves_the_one_before_it_in_work() -> None:
    fitter = LobeFitter(time_limit_s=1e-6)
    base, coat = (np.ones(shape) for shape in shapes(fitter))
    with fitter.solver.background.lock:  # it cannot come to its end meanwhile
        fit = fitter.fit_samples(base, coat, ior=1.5)
        for bad in ({"ior": np.nan}, {"ior": 1.5, "base": -base}):
            with pytest.raises(FittingError):
                fitter.fit_samples(**{"base": base, "coat": coat, **bad})
        assert fit.exact is not None
        assert not fit.exact.cancelled()
    assert not fit.exact.result(timeout=250.0).time_limited
    fitter.close()
