"""Which value has radius 1: peaks as they are, bodies that are seen under any peak, and nothing that is odd."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_lobe_visualizer.view3d.layers import BODY_RADIUS, full_of, tops_of
from brdf_lobe_visualizer.view3d.section import SpaceOptions

from brdf_suite.geometry.directions import illumination, mirror
from brdf_suite.inspection.lobe_surface.grid import lobe_grid
from brdf_suite.inspection.lobe_surface.surface import RADIUS_KINDS, RadiusScale


@pytest.mark.parametrize("kind", RADIUS_KINDS)
def test_a_body_is_seen_under_any_peak(kind: str) -> None:
    options = SpaceOptions(decades=6.0)
    for peak in np.geomspace(0.1, 1e6, 30):
        scale = RadiusScale(kind, full_of(float(peak), 0.1, kind, options), options.decades)
        assert float(scale.radius(0.1)) >= BODY_RADIUS - 1e-6
        # A peak is cut off only where the body would be shorter else.
        assert float(scale.radius(peak)) <= 1.0 + 1e-6 or float(scale.radius(0.1)) == pytest.approx(
            BODY_RADIUS
        )


def test_it_moves_evenly_with_the_peak() -> None:
    fulls = [full_of(peak, 0.1, "cbrt", SpaceOptions()) for peak in np.geomspace(0.1, 100.0, 400)]
    assert np.all(np.diff(fulls) >= 0.0)
    assert np.max(np.diff(np.log(fulls))) < 0.02


def test_the_other_ways_and_what_is_odd() -> None:
    assert full_of(9.0, 2.0, "cbrt", SpaceOptions(fill="greatest")) == 9.0
    assert full_of(9.0, 2.0, "cbrt", SpaceOptions(fill="body")) == 2.0
    assert full_of(9.0, 2.0, "cbrt", SpaceOptions(fill="value", full=3.0)) == 3.0
    assert full_of(1e4, 1e-9, "cbrt", SpaceOptions()) == 1e4  # a spike and no body
    for fill in ("auto", "greatest", "body"):
        for peak in (0.0, 1e-40):  # a single's inverse of the latter is none
            scale = RadiusScale("cbrt", full_of(peak, 0.0, "cbrt", SpaceOptions(fill=fill)))
            assert np.isfinite(scale.radius([0.0, peak])).all()


def test_peak_and_body_are_distinguished_and_holes_are_none() -> None:
    grid = lobe_grid(illumination(45.0))
    near = grid.directions @ mirror(illumination(45.0))
    values = np.where(near > np.cos(np.radians(1.0)), 50.0, 0.2).astype(np.float32)
    values[0, 0] = values[-1, -1] = np.nan
    assert tops_of(grid, values) == pytest.approx((50.0, 0.2))
