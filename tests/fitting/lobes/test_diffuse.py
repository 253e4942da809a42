"""The diffuse term two ways: inside the program, or measured off-specular and then fixed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeFitter


def test_measured_is_what_the_base_gives_there(make_paint: Callable[..., Any]) -> None:
    paint = make_paint()
    fitter = LobeFitter(time_limit_s=5.0, diffuse="measured")
    samples = fitter.base_samples
    at = samples.gammas_deg.index(110.0)
    wanted = paint.base.eval(samples.light, samples.views[at])
    weights = fitter.fit(paint).weights
    np.testing.assert_allclose(weights.kd, wanted, rtol=1e-12)
    # This paint is a floor and a lobe: what is left after the floor is fitted as well as with the floor.
    joint = LobeFitter(time_limit_s=5.0).fit(paint).weights
    at = samples.gammas_deg.index(45.0)
    for fitted in (weights, joint):
        seen = fitted.kd + samples.cosine_lobes(fitter.basis.array())[at] @ fitted.kdd
        np.testing.assert_allclose(seen, paint.base.eval(samples.light, samples.views[at]), rtol=1e-3)


def test_measured_at_the_normal_as_in_the_paper_takes_too_much_of_a_metallic(
    make_paint: Callable[..., Any],
) -> None:
    paint = make_paint(exponent=3.0)
    normal = LobeFitter(time_limit_s=5.0, diffuse="measured", diffuse_gamma_deg=45.0).fit(paint)
    joint = LobeFitter(time_limit_s=5.0).fit(paint)
    assert (normal.weights.kd > 2.0 * joint.weights.kd).all()
    assert (normal.weights.kdd >= 0.0).all()
    assert (normal.base_error.absolute > joint.base_error.absolute).all()


def test_a_solid_paint_leaves_nothing_to_the_lobes(make_paint: Callable[..., Any]) -> None:
    paint = make_paint(face=(0.0, 0.0, 0.0))
    fit = LobeFitter(time_limit_s=5.0, diffuse="measured").fit(paint)
    np.testing.assert_allclose(fit.weights.kd, [0.02, 0.03, 0.05])
    assert not fit.weights.kdd.any()
    assert not fit.base_error.relative.any()


def test_a_way_or_an_angle_that_there_is_not_is_named() -> None:
    with pytest.raises(FittingError, match="'joint' or 'measured'"):
        LobeFitter(diffuse="guessed")  # type: ignore[arg-type]  # what a caller without types may write
    with pytest.raises(FittingError, match="no sample at 100°"):
        LobeFitter(diffuse="measured", diffuse_gamma_deg=100.0)
