from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeBasis, default_basis, log_spaced


def test_default_reaches_from_broad_to_the_coat() -> None:
    basis = default_basis()
    assert basis.count <= 11
    assert basis.exponents[0] <= 2.0
    # A coat of 90 gloss units is about E = 125,000; above 116,000 the prefilter's bandlimit ends.
    assert 4e4 <= basis.exponents[-1] <= 116_000.0


def test_log_spacing_has_equal_ratios() -> None:
    exponents = log_spaced(7, 2.0, 20_000.0).array()
    assert exponents[0] == 2.0
    assert exponents[-1] == pytest.approx(20_000.0)
    np.testing.assert_allclose(np.diff(np.log(exponents)), np.log(1e4) / 6, rtol=1e-9)


@pytest.mark.parametrize(
    ("exponents", "word"),
    [
        ((), "empty"),
        ((2.0, 2.0), "repeats"),
        ((4.0, 2.0), "ascend"),
        ((0.5, 2.0), "0.5"),
        ((2.0, np.nan), "nan"),
    ],
)
def test_bad_bases_are_refused_by_name(exponents: tuple[float, ...], word: str) -> None:
    with pytest.raises(FittingError, match=word):
        LobeBasis(exponents)
