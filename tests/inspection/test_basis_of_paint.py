"""The error of one reflectance over the number of lobes, against the search's own numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.errors import Cancelled
from brdf_suite.fitting.basis_search.document import load_search
from brdf_suite.fitting.lobes.basis import STORED_NAME
from brdf_suite.inspection.basis_of_paint import errors_over_count
from brdf_suite.pipeline.material import load_document
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.resources import resource


def test_a_shipped_paint_has_the_errors_of_the_stored_search() -> None:
    search = load_search(Path(str(resource("basis", STORED_NAME))))
    few = [result for result in search.results if result.count in (1, 3, 10)]
    paint = build_reflectance(load_document("blue_metallic"))
    fractions: list[float] = []
    found = errors_over_count(
        paint,
        {result.count: result.exponents for result in few},
        lambda fraction, _what: fractions.append(fraction),
    )
    place = search.paints.index("blue_metallic")
    assert found.whole
    assert found.counts == (1, 3, 10)
    np.testing.assert_allclose(found.errors, [result.errors[place] for result in few], rtol=1e-6)
    assert fractions[0] == 0.0
    assert fractions[-1] == 1.0


def test_what_nothing_divides_has_the_error_of_its_colour() -> None:
    found = errors_over_count(Lambertian((0.4, 0.2, 0.1)), {1: (4.0,), 2: (4.0, 60.0)})
    assert not found.whole
    # A matt surface is KD alone, whatever the lobes.
    assert max(found.errors) < 0.2


def test_it_can_be_cancelled() -> None:
    def stop(_fraction: float, _what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        errors_over_count(Lambertian(), {1: (4.0,)}, stop)
