from __future__ import annotations

import json

import pytest

from brdf_suite.errors import FittingError, SuiteError
from brdf_suite.inspection.angle_fit import fit_at_angles, judged_gammas


def test_a_shipped_paint_is_fitted_and_judged() -> None:
    found = fit_at_angles("fine_silver", 12)
    plain = json.loads(json.dumps(found.to_json(), allow_nan=False))
    assert plain["angles"] == 12
    assert len(plain["kg"]) == 12
    assert plain["delta_e_2000_worst"] < 6.0
    at_measured = [
        row["delta_e_2000"]
        for row in plain["errors"]
        if row["illumination_deg"] == 45.0 and row["aspecular_deg"] in (15.0, 45.0, 110.0)
    ]
    assert len(at_measured) == 3
    assert max(at_measured) < 0.2


def test_a_cook_torrance_paint_is_fitted_in_its_two_layers() -> None:
    found = fit_at_angles("table1_white", 8)
    assert not found.weights.base_under_coat
    assert found.weights.kd[0].max() == pytest.approx(found.weights.kd[-1].max(), rel=0.2)


def test_views_below_the_horizon_are_not_judged() -> None:
    assert judged_gammas(10.0) == (-15.0, 15.0, 25.0, 45.0, 75.0)
    assert judged_gammas(80.0) == (15.0, 25.0, 45.0, 75.0, 110.0)


def test_too_few_angles_and_unknown_paints() -> None:
    with pytest.raises(FittingError, match="at least 3"):
        fit_at_angles("blue", 2)
    with pytest.raises(SuiteError, match="nope"):
        fit_at_angles("nope", 8)
