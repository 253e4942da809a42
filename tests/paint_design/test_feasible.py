"""The nearest paint that can be: what is offered is what the whole road gives, and nothing nearer is at hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.documents.paint import Gloss, Lab, Measurement, Paint
from brdf_suite.errors import Cancelled, UnreachableError
from brdf_suite.paint_design.angle_sets import at_geometries
from brdf_suite.paint_design.feasible import (
    TOLERANCE_DELTA_E,
    Feasible,
    is_feasible,
    judged,
    nearest_feasible,
    nearest_reachable,
)
from brdf_suite.paint_design.feasible_colours import nearest_in_cone
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint

BLUE = ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0))


@pytest.fixture(scope="module")
def fitter():
    made = PaintFitter(time_limit_s=60.0)
    yield made
    made.close()


def paint(*labs: Lab, gloss: Gloss | None = None) -> Paint:
    readings = tuple(Measurement(45.0, a, lab) for a, lab in zip((15.0, 45.0, 110.0), labs, strict=True))
    return Paint("Asked", readings, gloss or Gloss(90.0))


def checked(found: Feasible | None, fitter: PaintFitter) -> Feasible:
    assert found is not None
    again = fitter.fit(found.paint)
    assert is_feasible(again)
    assert max(again.readings[index].delta_e_2000 for index in judged(again)) <= TOLERANCE_DELTA_E
    labs = [np.array([m.lab for m in item.measurements]) for item in (found.asked, found.paint)]
    assert found.delta_e == pytest.approx(delta_e_2000(*labs).tolist())
    return found


def test_a_paint_that_can_be_is_its_own_nearest(fitter: PaintFitter) -> None:
    blue = load_shipped_paint("blue")
    found = checked(nearest_feasible(blue, fitter), fitter)
    assert found.paint == blue
    assert found.worst_delta_e == 0.0
    assert not found.gloss_changed


@pytest.mark.parametrize(
    "labs",
    [
        ((30.0, 0.0, 0.0), (40.0, 0.0, 0.0), (60.0, 0.0, 0.0)),  # lighter away from the mirror direction
        ((50.0, 0.0, 0.0), (90.0, 0.0, 0.0), (50.0, 0.0, 0.0)),  # lightest at the face
        ((60.0, 30.0, 20.0), (40.0, -20.0, 20.0), (30.0, 20.0, -30.0)),  # a hue that no lobes turn to
        ((62.0, -4.0, -120.0), (25.0, 4.0, -100.0), (9.0, 8.0, -60.0)),  # more saturated than light can be
    ],
)
def test_what_no_lobes_give_is_offered_as_near_as_they_come(
    labs: tuple[Lab, ...], fitter: PaintFitter
) -> None:
    asked = paint(*labs)
    fit = fitter.fit(asked)
    assert not is_feasible(fit)
    found = checked(nearest_feasible(asked, fitter), fitter)
    rows = np.array([row.fitted for row in fit.readings])
    given_by_fit = float((delta_e_2000(np.array(labs), rows) ** 2).sum())
    assert sum(d * d for d in found.delta_e) < 0.95 * given_by_fit, "nearer than what the fit gives anyway"
    assert not found.gloss_changed


@pytest.mark.parametrize(
    ("gloss", "low", "high"),
    [(Gloss(199.0), 130.0, 198.9), (Gloss(90.0, 60.0), 70.0, 90.0), (Gloss(0.0), 0.1, 5.0)],
)
def test_a_gloss_that_no_coat_gives_goes_to_the_end_of_what_can_be(
    gloss: Gloss, low: float, high: float, fitter: PaintFitter
) -> None:
    asked = paint(*BLUE, gloss=gloss)
    with pytest.raises(UnreachableError):
        build_paint(asked)
    found = checked(nearest_feasible(asked, fitter), fitter)
    assert found.gloss_changed
    assert low <= found.paint.gloss.gu_20 <= high
    assert (found.paint.gloss.gu_60 is None) == (gloss.gu_60 is None)
    # Nothing between the offered reading and the asked one can be, to the tenth that is shown.
    step = 0.1 if gloss.gu_20 > found.paint.gloss.gu_20 else -0.1
    beyond = Gloss(max(found.paint.gloss.gu_20 + 2 * step, 0.0), found.paint.gloss.gu_60)
    if gloss.gu_60 is None:
        with pytest.raises(UnreachableError):
            build_paint(paint(*BLUE, gloss=beyond))


def test_a_colour_darker_than_its_coat_is_lifted_to_it() -> None:
    asked = paint((4.0, 0.0, 0.0), (3.0, 0.0, 0.0), (3.0, 0.0, 0.0), gloss=Gloss(5.0))
    with pytest.raises(UnreachableError, match="coat"):
        build_paint(asked)
    found = nearest_reachable(asked)
    assert found is not None
    build_paint(found)
    assert found.gloss == asked.gloss
    assert found.lab_at(15.0)[0] > 4.0
    assert found.lab_at(110.0) == asked.lab_at(110.0)


@pytest.mark.parametrize("gloss", [10.0, 3.0])
def test_a_dark_satin_paint_is_offered_the_nearest_coat_and_keeps_its_colour(
    gloss: float, fitter: PaintFitter
) -> None:
    asked = paint(*[(6.0, 0.0, 0.0)] * 3, gloss=Gloss(gloss))
    found = checked(nearest_feasible(asked, fitter), fitter)
    assert found.worst_delta_e <= 3.0
    assert gloss < found.paint.gloss.gu_20 < 15.0
    # A duller coat, beyond the tenths that are searched, is too much for colours as dark as these.
    duller = Gloss(round(0.5 * (gloss + found.paint.gloss.gu_20), 1))
    labs = [m.lab for m in found.paint.measurements]
    try:
        fit = fitter.fit(paint(*labs, gloss=duller))
    except UnreachableError:
        return
    assert not is_feasible(fit)


def test_six_angles_with_one_reading_out_of_line(fitter: PaintFitter) -> None:
    six = at_geometries(paint(*BLUE), GEOMETRY_SETS["six"].geometries)
    found = checked(nearest_feasible(six.with_lab(25.0, (80.0, 0.0, 0.0)), fitter), fitter)
    assert len(found.delta_e) == 6


def test_readings_under_a_second_light_are_left_alone(fitter: PaintFitter) -> None:
    shift = load_shipped_paint("teal_violet_shift")
    fit = fitter.fit(shift)
    assert {fit.readings[index].illumination_deg for index in judged(fit)} == {45.0}
    assert len(judged(fit)) < len(fit.readings)
    asked = shift.with_lab(110.0, (95.0, 0.0, 0.0), 45.0)
    found = checked(nearest_feasible(asked, fitter), fitter)
    for before, after in zip(asked.measurements, found.paint.measurements, strict=True):
        assert before.illumination_deg == 45.0 or before == after
    assert found.worst_delta_e > 1.0


def test_it_can_be_stopped(fitter: PaintFitter) -> None:
    def stop(_fraction: float, _what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        nearest_feasible(paint(*BLUE), fitter, progress=stop)


@settings(max_examples=settings.default.max_examples // 2)
@example([(5.0, 0.0, 0.0), (5.0, 2.0, 0.0), (34.0, 29.0, 14.0)])
@given(st.lists(st.tuples(st.floats(5, 90), st.floats(-60, 60), st.floats(-60, 60)), min_size=3, max_size=3))
def test_the_nearest_of_the_cone_is_in_it_and_no_neighbour_is_nearer(asked: list[Lab]) -> None:
    angles = np.radians([15.0, 45.0, 110.0])
    columns = np.stack(
        [np.ones(3), *(np.clip(np.cos(angles), 0, None) ** e for e in (2.0, 10.0, 60.0))], axis=1
    )
    share = np.array([0.01, 0.0, 0.0])
    found = nearest_in_cone(columns, share, asked)
    value = float((delta_e_2000(np.array(asked), found) ** 2).sum())
    rng = np.random.default_rng(1)
    from scipy.optimize import nnls

    from brdf_suite.appearance.colour.colorimetry import lab_to_working

    x = np.stack([nnls(columns, lab_to_working(found)[:, c] - share)[0] for c in range(3)], axis=1)
    assert working_to_lab(share[:, None] + columns @ x) == pytest.approx(found, abs=0.02)
    for size in (1e-3, 1e-2, 0.1):
        near = np.maximum(x + size * rng.normal(size=(200, *x.shape)) * np.maximum(x, 0.02), 0.0)
        labs = working_to_lab(share[:, None] + columns @ near)
        values = (delta_e_2000(np.array(asked), labs) ** 2).sum(axis=-1)
        assert values.min() >= value * 0.97 - 1e-3
