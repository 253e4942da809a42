"""The error of a basis: that of the fit which the product makes."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeBasis, LobeFitter
from brdf_suite.fitting.basis_search.database import BETWEEN_DEG, Database, reflectances
from brdf_suite.fitting.basis_search.error import BasisError, equation_4
from brdf_suite.reflectance.designed.layers import Layers
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.cosine_lobes import CosineLobes

EXPONENTS = (1.5, 6.0, 30.0, 900.0, 60_000.0)


def test_its_programs_are_those_of_the_fitter(few: Database) -> None:
    fitter = LobeFitter(LobeBasis(EXPONENTS), time_limit_s=1.0)
    ours = BasisError(few).programs(np.array(EXPONENTS))
    for mine, theirs in zip(ours, fitter.programs, strict=True):
        np.testing.assert_array_equal(mine.matrix, theirs.matrix)
        np.testing.assert_array_equal(mine.row_weights, theirs.row_weights)
        np.testing.assert_array_equal(mine.column_scale, theirs.column_scale)
    fitter.close()


def test_the_colours_are_those_of_the_fitted_lobes(few: Database) -> None:
    """Near the mirror direction the base alone counts: there the error is what KD and KDD give."""
    fitter = LobeFitter(LobeBasis(EXPONENTS), time_limit_s=5.0)
    errors = BasisError(few)
    base, coat = errors.layers(EXPONENTS)
    assert base.shape == coat.shape == (len(few.paints),)
    gamma = np.radians(BETWEEN_DEG)
    for index, paint in enumerate(few.paints):
        weights = fitter.fit_samples(paint.base, paint.coat, ior=1.5).weights
        lobes = np.clip(np.cos(gamma), 0.0, None)[:, None] ** weights.exponents
        gloss = (lobes @ weights.kg) / np.cos(np.pi / 4.0)
        gloss[np.array(BETWEEN_DEG) < 10.0] = 0.0
        seen = delta_e_2000(paint.lab, working_to_lab(np.pi * (weights.kd + lobes @ weights.kdd + gloss)))
        units = np.where(np.isin(BETWEEN_DEG, (15.0, 45.0, 110.0)), 0.4, 1.0)
        wanted = np.sqrt((seen**2 / units**2).sum() / (1.0 / units**2).sum())
        assert base[index] == pytest.approx(wanted, rel=1e-3, abs=1e-3)
    fitter.close()


def test_a_paint_that_is_made_of_the_lobes_has_no_error() -> None:
    kdd = np.array([[0.2, 0.1, 0.05], [0.3, 0.3, 0.1]])
    base = CosineLobes(np.array([0.05, 0.02, 0.01]), np.array([3.0, 12.0]), kdd, np.zeros((2, 3)))
    none = CookTorrance(CookTorrancePaint("none", (0.0, 0.0, 0.0)))
    errors = BasisError(reflectances({"lobes": Layers(base, none, 1.0)}))
    assert errors((3.0, 12.0))[0] < 1e-3
    assert errors((3.0, 40.0))[0] > 0.3


def test_it_falls_with_better_lobes_and_is_the_same_twice(few: Database) -> None:
    errors = BasisError(few)
    one, many = errors((5.0,)), errors(EXPONENTS)
    assert equation_4(many) < 0.5 * equation_4(one)
    np.testing.assert_array_equal(errors(EXPONENTS[::-1]), many)
    np.testing.assert_array_equal(BasisError(few)(EXPONENTS), many)


def test_a_coloured_coat_is_fitted_per_channel() -> None:
    lobe = CookTorranceLobe((0.02, 0.05, 0.1), 0.03, 0.1)
    black = CookTorrance(CookTorrancePaint("none", (0.0, 0.0, 0.0)))
    coat = CookTorrance(CookTorrancePaint("coat", (0.0, 0.0, 0.0), (lobe,)))
    grey = CookTorrance(
        CookTorrancePaint("coat", (0.0, 0.0, 0.0), (CookTorranceLobe((0.05,) * 3, 0.03, 0.1),))
    )
    database = reflectances({"blue": Layers(black, coat, 1.5), "grey": Layers(black, grey, 1.5)})
    coloured, plain = BasisError(database).layers((8.0, 500.0, 2_000.0))[1]
    # The same shape in each channel: the shares are those of the grey one, weighed by the channels' energies.
    shares = np.array([0.02, 0.05, 0.1]) / np.mean([0.02, 0.05, 0.1])
    assert coloured == pytest.approx(plain * np.sqrt((shares**2).mean()), rel=1e-3)


@pytest.mark.parametrize("bad", [(), (0.5, 3.0), (np.nan,), (np.inf,)])
def test_bad_exponents_are_refused(few: Database, bad: tuple[float, ...]) -> None:
    with pytest.raises(FittingError, match="at least 1"):
        BasisError(few)(bad)
