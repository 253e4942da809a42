"""The colour scale of pictures of differences."""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.colour.colorimetry import display_to_lab
from brdf_suite.appearance.difference.colour_scale import STEPS, scale_table


def test_lightness_rises_evenly_and_nothing_is_clipped() -> None:
    lab = display_to_lab(scale_table())
    np.testing.assert_allclose(lab[:, 0], np.linspace(6.0, 94.0, STEPS + 1), atol=0.05)
    steps = np.linalg.norm(np.diff(lab, axis=0), axis=1)
    assert steps.max() < 4.0 * np.median(steps)
