"""Detection of a chessboard's inner corners in a photograph with subpixel accuracy, by OpenCV."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.extras import import_extra

_LOW, _HIGH = 1.0, 99.5
# A corner is refined within this share of the distance to the next one, so that no neighbour is drawn in.
_WINDOW_SHARE = 0.35
_LARGEST_WINDOW = 30
_BLUR_PX = 1.0
_REFINEMENTS = 60
_REFINED_PX = 1e-4


def opencv() -> ModuleType:
    """Return OpenCV's module; :class:`ExtraError` where it is missing or cannot be loaded."""
    return import_extra(
        "cv2",
        purpose="the calibration by photographs of a board",
        instead="a session whose session.json states the camera's intrinsics needs no board",
    )


def find_corners(picture: npt.NDArray[np.generic], columns: int, rows: int) -> Floats | None:
    """Return (rows·columns, 2) the pixel (x, y) of each inner corner, row by row, or None where no board is seen.

    ``picture`` is (h, w) or (h, w, channels), whole codes or floats; a pixel's centre lies at whole numbers.
    """
    cv2 = opencv()
    grey = _grey(picture)
    codes = np.asarray(np.rint(grey), np.uint8)
    found, corners = cv2.findChessboardCornersSB(codes, (columns, rows), flags=cv2.CALIB_CB_NORMALIZE_IMAGE)
    if not found:  # the slower search, which finds boards in poor light as well
        flags = cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_EXHAUSTIVE
        found, corners = cv2.findChessboardCornersSB(codes, (columns, rows), flags=flags)
    if not found:
        return None
    corners = np.ascontiguousarray(corners, np.float32).reshape(-1, 1, 2)
    apart = np.linalg.norm(np.diff(corners.reshape(rows, columns, 2), axis=1), axis=-1)
    window = int(np.clip(_WINDOW_SHARE * float(apart.min()), 2, _LARGEST_WINDOW))
    criteria = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, _REFINEMENTS, _REFINED_PX)
    # Smoothed a little, noise weighs less against the edges: a third of the error is gone.
    smooth = cv2.GaussianBlur(grey, (0, 0), _BLUR_PX)
    refined = cv2.cornerSubPix(smooth, corners, (window, window), (-1, -1), criteria)
    return np.asarray(refined, float).reshape(-1, 2)


def _grey(picture: npt.NDArray[np.generic]) -> npt.NDArray[np.float32]:
    """Return the picture from 0 to 255, stretched between its black and white."""
    values = np.asarray(picture, float)
    if values.ndim == 3:
        values = values.mean(axis=-1)
    low, high = np.percentile(values, (_LOW, _HIGH))
    scaled = (values - low) / max(float(high - low), 1e-12)
    return np.asarray(255.0 * np.clip(scaled, 0.0, 1.0), np.float32)
