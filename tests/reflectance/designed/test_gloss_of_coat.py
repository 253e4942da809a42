"""Index and roughness of a coat set by hand: the readings that they give, and the coat that those give again."""

from __future__ import annotations

import pickle
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.clearcoat_gloss import gloss_units
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.reflectance.designed.build import DarkerThanCoatError, build_paint, gloss_of_coat

LABS = ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0))
BLUE = Paint(
    "Blue",
    tuple(Measurement(45.0, a, lab) for a, lab in zip((15.0, 45.0, 110.0), LABS, strict=True)),
    Gloss(90.0),
)


@given(st.floats(1.4, 1.65), st.floats(0.003, 0.03))
def test_a_coat_is_found_again_from_its_readings(ior: float, roughness: float) -> None:
    gloss = gloss_of_coat(BLUE, ior, roughness)
    solved = build_paint(replace(BLUE, gloss=gloss))
    # Readings are what is kept; where two coats have the same ones, either is right.
    again = gloss_of_coat(BLUE, solved.ior, solved.roughness)
    assert again.gu_20 == pytest.approx(gloss.gu_20, abs=0.05)
    assert again.gu_60 == pytest.approx(gloss.gu_60, abs=0.5)


def test_a_glossy_coat_over_black_reads_what_the_standards_formula_says() -> None:
    black = replace(BLUE, measurements=tuple(replace(m, lab=(0.0, 0.0, 0.0)) for m in BLUE.measurements))
    gloss = gloss_of_coat(black, 1.53, 0.003)
    assert gloss.gu_20 == pytest.approx(gloss_units(20, 1.53, 0.003))
    # n = 1.53, Beckmann 0.003 reads 89.6 at 20 and 94 at 60 degrees by the standards' apertures.
    assert gloss.gu_20 == pytest.approx(89.6, abs=0.5)
    assert gloss.gu_60 == pytest.approx(94.0, abs=1.0)


def test_a_coat_brighter_than_the_colour_is_refused_with_its_place() -> None:
    dark = replace(BLUE, measurements=tuple(replace(m, lab=(3.0, 0.0, 0.0)) for m in BLUE.measurements))
    with pytest.raises(DarkerThanCoatError, match="At 15°") as caught:
        gloss_of_coat(dark, 1.5, 0.1)
    assert caught.value.measurement == (45.0, 15.0)
    assert caught.value.share > 0.1
    assert isinstance(caught.value, UnreachableError)
    # It can be reported again under a name, and by another process.
    again = type(caught.value)(f"black: {caught.value}")
    assert str(pickle.loads(pickle.dumps(again))).startswith("black: At 15°")
