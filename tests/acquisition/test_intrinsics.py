"""A camera's intrinsics come back from photographs of a board; where they cannot, the reason is reported."""

from __future__ import annotations

import sys
from functools import cache

import numpy as np
import pytest

from brdf_suite.acquisition.geometry.intrinsics import CameraCalibration, calibrate_intrinsics, find_corners
from brdf_suite.acquisition.geometry.lens import lens_pixels, lens_rays
from brdf_suite.acquisition.session.session import Lens
from brdf_suite.errors import AcquisitionError, Cancelled, MissingExtraError, ValueRangeError

cv2 = pytest.importorskip("cv2")

COLUMNS, ROWS, SQUARE = 7, 5, 0.02
WIDTH, HEIGHT = 320, 240
TRUE = Lens(420.0, 418.0, 158.5, 121.0, -0.12, 0.0, 0.0, 0.0, 0.0)
MIDDLE = np.array([0.003, -0.002, 0.3])
POSES = [(0.0, 0.0), (0.5, 0.2), (-0.5, 0.3), (0.3, -0.6), (-0.2, 0.5), (0.6, 0.6)]


def board_axes(tilt: float, turn: float) -> np.ndarray:
    a, b = np.cos(tilt), np.sin(tilt)
    c, d = np.cos(turn), np.sin(turn)
    return np.array([[1, 0, 0], [0, a, -b], [0, b, a]]) @ np.array([[c, 0, d], [0, 1, 0], [-d, 0, c]])


FINE = 4
"""Rays each way in a pixel."""


@cache
def rays() -> np.ndarray:
    """Return the directions (h, w, 3) of all rays of the lens, which all photographs share."""
    x, y = np.meshgrid(np.arange(WIDTH * FINE), np.arange(HEIGHT * FINE))
    return lens_rays(TRUE, np.stack(((x + 0.5) / FINE - 0.5, (y + 0.5) / FINE - 0.5), axis=-1))


def photograph(tilt: float, turn: float, seed: int) -> np.ndarray:
    """Return (h, w, 3) 12-bit codes of the board, drawn by its own ray casting, with noise and rounding."""
    axes = board_axes(tilt, turn)
    # Along the board's axes; the third one is its normal.
    along, middle = rays() @ axes, MIDDLE @ axes
    reach = middle[2] / along[..., 2]
    u = (reach * along[..., 0] - middle[0]) / SQUARE + 0.5 * (COLUMNS + 1)
    v = (reach * along[..., 1] - middle[1]) / SQUARE + 0.5 * (ROWS + 1)
    inside = (u > 0) & (u < COLUMNS + 1) & (v > 0) & (v < ROWS + 1)
    dark = inside & ((np.floor(u) + np.floor(v)) % 2 == 0)
    light = np.where(dark, 0.04, 0.7).reshape(HEIGHT, FINE, WIDTH, FINE).mean(axis=(1, 3))
    noise = 0.004 * np.random.default_rng(seed).standard_normal((HEIGHT, WIDTH, 3))
    return np.rint(4095 * np.clip(light[..., None] + noise, 0, 1)).astype(np.uint16)


@pytest.fixture(scope="module")
def board() -> list[tuple[str, np.ndarray]]:
    return [(f"board/{i}.png", photograph(tilt, turn, i)) for i, (tilt, turn) in enumerate(POSES)]


@pytest.fixture(scope="module")
def found(board: list[tuple[str, np.ndarray]]) -> CameraCalibration:
    return calibrate_intrinsics(board, COLUMNS, ROWS, SQUARE)


def test_the_lens_comes_back(found: CameraCalibration) -> None:
    lens = found.intrinsics
    errors = dict(zip(("fx", "fy", "cx", "cy", "k1"), found.standard_errors, strict=False))
    for name, error in errors.items():
        assert abs(getattr(lens, name) - getattr(TRUE, name)) < max(
            5.0 * error, 0.002 * abs(getattr(TRUE, name))
        )
    assert lens.fx == pytest.approx(TRUE.fx, rel=0.005)
    assert found.rms_px < 0.1
    assert found.size == (WIDTH, HEIGHT)
    assert len(found.names) == len(POSES)
    assert not found.left_out


def test_coefficients_that_the_board_does_not_determine_are_held_at_0(found: CameraCalibration) -> None:
    assert found.intrinsics.k1 != 0.0
    assert found.intrinsics.k3 == 0.0


def test_the_calibration_is_kept_as_json(found: CameraCalibration) -> None:
    assert CameraCalibration.from_json(found.to_json()) == found
    with pytest.raises(ValueRangeError, match="not a calibration"):
        CameraCalibration.from_json({"rms_px": 0.1})


def test_corners_are_found_to_a_tenth_of_a_pixel(board: list[tuple[str, np.ndarray]]) -> None:
    corners = find_corners(board[5][1], COLUMNS, ROWS)
    assert corners is not None
    steps = np.stack(np.meshgrid(np.arange(COLUMNS), np.arange(ROWS)), axis=-1).reshape(-1, 2)
    place = (steps - np.array([(COLUMNS - 1) / 2, (ROWS - 1) / 2])) * SQUARE
    points = MIDDLE + place @ board_axes(*POSES[5])[:, :2].T
    # Which corner comes first, a board that looks the same from two sides does not show.
    apart = np.linalg.norm(lens_pixels(TRUE, points)[:, None] - corners, axis=-1).min(axis=0)
    assert np.sqrt(np.mean(apart**2)) < 0.1


def test_photographs_without_the_board_are_reported(board: list[tuple[str, np.ndarray]]) -> None:
    empty = ("board/wall.png", np.full((HEIGHT, WIDTH, 3), 900, np.uint16))
    found = calibrate_intrinsics([*board[:4], empty], COLUMNS, ROWS, SQUARE)
    assert [name for name, _ in found.left_out] == ["board/wall.png"]
    with pytest.raises(AcquisitionError, match=r"in 2 photographs.*board/wall\.png: no board of 7 × 5"):
        calibrate_intrinsics([*board[:2], empty], COLUMNS, ROWS, SQUARE)


def test_photographs_of_different_sizes_are_refused(board: list[tuple[str, np.ndarray]]) -> None:
    with pytest.raises(AcquisitionError, match=r"board/0\.png"):
        calibrate_intrinsics([board[0], ("small.png", board[1][1][:200])], COLUMNS, ROWS, SQUARE)


def test_no_photographs_at_all() -> None:
    with pytest.raises(AcquisitionError, match="no photographs"):
        calibrate_intrinsics([], COLUMNS, ROWS, SQUARE)


def test_the_search_can_be_cancelled(board: list[tuple[str, np.ndarray]]) -> None:
    def stop(fraction: float, what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        calibrate_intrinsics(board, COLUMNS, ROWS, SQUARE, stop)


def test_without_opencv_the_way_to_install_it_is_reported(
    board: list[tuple[str, np.ndarray]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "cv2", None)
    with pytest.raises(
        MissingExtraError, match=r"needs OpenCV, which is not installed; `.*acquisition` installs it"
    ):
        calibrate_intrinsics(board, COLUMNS, ROWS, SQUARE)
