"""Which value has radius 1: peaks as they are, bodies that are seen under any peak, and nothing that is odd."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_lobe_visualizer.view3d.layers import BODY_RADIUS, PEAK_SHARE, Tops, common_full, full_of, tops_of
from brdf_lobe_visualizer.view3d.section import SpaceOptions

from brdf_suite.geometry.directions import illumination, mirror
from brdf_suite.inspection.lobe_surface.grid import lobe_grid
from brdf_suite.inspection.lobe_surface.surface import RADIUS_KINDS, RadiusScale


@pytest.mark.parametrize("kind", RADIUS_KINDS)
def test_a_body_is_seen_under_any_peak(kind: str) -> None:
    options = SpaceOptions(decades=6.0)
    for peak in np.geomspace(0.1, 1e6, 30):
        scale = RadiusScale(kind, full_of(Tops(float(peak), 0.1, 0.1), kind, options), options.decades)
        assert float(scale.radius(0.1)) >= BODY_RADIUS - 1e-6
        # A peak is cut off only where the body would be shorter else.
        assert float(scale.radius(peak)) <= 1.0 + 1e-6 or float(scale.radius(0.1)) == pytest.approx(
            BODY_RADIUS
        )


def test_it_moves_evenly_with_the_peak() -> None:
    fulls = [full_of(Tops(peak, 0.1, 0.1), "cbrt", SpaceOptions()) for peak in np.geomspace(0.1, 100.0, 400)]
    assert np.all(np.diff(fulls) >= 0.0)
    assert np.max(np.diff(np.log(fulls))) < 0.02


def test_the_other_ways_and_what_is_odd() -> None:
    assert full_of(Tops(9.0, 2.0, 1.0), "cbrt", SpaceOptions(fill="greatest")) == 9.0
    assert full_of(Tops(9.0, 2.0, 1.0), "cbrt", SpaceOptions(fill="body")) == 2.0
    assert full_of(Tops(9.0, 2.0, 1.0), "cbrt", SpaceOptions(fill="value", full=3.0)) == 3.0
    assert full_of(Tops(1e4, 1e-9, 1e-9), "cbrt", SpaceOptions()) == 1e4  # a spike and no body
    for fill in ("auto", "greatest", "body"):
        for peak in (0.0, 1e-40):  # a single's inverse of the latter is none
            scale = RadiusScale("cbrt", full_of(Tops(peak, 0.0, 0.0), "cbrt", SpaceOptions(fill=fill)))
            assert np.isfinite(scale.radius([0.0, peak])).all()


def test_peak_and_body_are_distinguished_and_holes_are_none() -> None:
    grid = lobe_grid(illumination(45.0))
    near = grid.directions @ mirror(illumination(45.0))
    values = np.where(near > np.cos(np.radians(1.0)), 50.0, 0.2).astype(np.float32)
    values[0, 0] = values[-1, -1] = np.nan
    tops = tops_of(grid, values)
    assert (tops.peak, tops.off_mirror, tops.body) == pytest.approx((50.0, 0.2, 0.2))


@pytest.mark.parametrize("theta", [0.0, 45.0, 75.0])
def test_spikes_of_a_sparse_measurement_leave_the_scale_as_it_is(theta: float) -> None:
    grid = lobe_grid(illumination(theta))
    smooth = np.full(grid.shape, 0.3, np.float32)
    spiky = smooth.copy()
    spiky[40::60, 10::30] = 90.0
    assert tops_of(grid, spiky).off_mirror > 10.0 * tops_of(grid, smooth).off_mirror
    both = Tops.most([tops_of(grid, smooth), tops_of(grid, spiky)])
    full = full_of(both, "cbrt", SpaceOptions())
    assert float(RadiusScale("cbrt", full).radius(0.3)) >= BODY_RADIUS - 1e-6


def test_the_body_is_what_all_but_a_share_of_the_directions_stay_below() -> None:
    grid = lobe_grid(illumination(0.0), 400, 720)
    height = grid.directions[..., 2].astype(np.float32)
    # Light from above: the cap above z has the share 1 − z of the hemisphere's solid angle (Archimedes).
    assert tops_of(grid, height).body == pytest.approx(1.0 - PEAK_SHARE, abs=2e-3)
    holed = height.copy()
    holed[:, ::2] = np.nan
    assert tops_of(grid, holed).body == pytest.approx(1.0 - PEAK_SHARE, abs=3e-3)
    assert tops_of(grid, np.full_like(height, np.nan)).body == 0.0


def test_a_bright_panel_leaves_the_bodies_of_the_others_to_be_seen() -> None:
    options, dark, bright = SpaceOptions(), Tops(5.0, 0.2, 0.1), Tops(60.0, 20.0, 2.0)
    scale = RadiusScale("cbrt", common_full([dark, dark, bright], "cbrt", options))
    assert float(scale.radius(dark.body)) > 0.35
    assert float(scale.radius(bright.body)) <= 1.0 + 1e-6
    # Alone, and where another way is chosen, nothing of it holds.
    assert common_full([bright], "cbrt", options) == full_of(bright, "cbrt", options)
    assert common_full([dark, bright], "cbrt", SpaceOptions(fill="greatest")) == 60.0
