"""The camera's model, there and back, and against OpenCV's."""

from dataclasses import asdict

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.acquisition.geometry.lens import lens_pixels, lens_rays
from brdf_suite.acquisition.session.session import Lens
from brdf_suite.errors import ValueRangeError

_SMALL = st.floats(-0.15, 0.15)


@settings(max_examples=settings.default.max_examples // 2)
@given(k1=_SMALL, k2=_SMALL, p1=st.floats(-0.01, 0.01), p2=st.floats(-0.01, 0.01), k3=_SMALL)
def test_rays_lead_back_to_their_pixels(k1: float, k2: float, p1: float, p2: float, k3: float) -> None:
    lens = Lens(900.0, 880.0, 310.0, 250.0, k1, k2, p1, p2, k3)
    pixels = np.stack(np.meshgrid(np.linspace(0, 640, 7), np.linspace(0, 480, 5)), axis=-1)
    rays = lens_rays(lens, pixels)
    np.testing.assert_allclose(np.linalg.norm(rays, axis=-1), 1.0, rtol=1e-12)
    np.testing.assert_allclose(lens_pixels(lens, 3.7 * rays), pixels, atol=1e-7)


def test_distortion_is_that_of_opencv() -> None:
    cv2 = pytest.importorskip("cv2")
    lens = Lens(900.0, 880.0, 310.0, 250.0, -0.21, 0.11, 0.003, -0.002, 0.04)
    points = np.random.default_rng(4).uniform((-0.5, -0.4, 1.5), (0.5, 0.4, 2.5), (20, 3))
    matrix = np.array(((lens.fx, 0.0, lens.cx), (0.0, lens.fy, lens.cy), (0.0, 0.0, 1.0)))
    expected, _ = cv2.projectPoints(
        points, np.zeros(3), np.zeros(3), matrix, np.array((lens.k1, lens.k2, lens.p1, lens.p2, lens.k3))
    )
    np.testing.assert_allclose(lens_pixels(lens, points), expected[:, 0], atol=1e-8)


def test_a_lens_is_read_back_from_its_numbers() -> None:
    lens = Lens(1000.0, 1001.0, 320.0, 240.0, k1=0.1, p2=0.002)
    assert Lens(**asdict(lens)) == lens


def test_numbers_that_are_none_are_refused() -> None:
    with pytest.raises(ValueRangeError, match="k1"):
        Lens(900.0, 900.0, 1.0, 1.0, float("nan"))
    with pytest.raises(ValueRangeError, match="fx"):
        Lens(0.0, 900.0, 1.0, 1.0)
