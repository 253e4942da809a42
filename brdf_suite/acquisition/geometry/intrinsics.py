"""Calibration of a camera's intrinsics from photographs of a chessboard, by OpenCV (Zhang 2000).

The lens's distortion is given as many coefficients as the photographs determine: k1 alone, then k2 and the tangential
p1 and p2, then k3, each step taken where it explains more than its own freedom does (Schwarz's criterion). A full model
on a narrow field bends the corners of the picture by what is noise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.session.session import Lens
from brdf_suite.arrays import Floats
from brdf_suite.errors import AcquisitionError, ValueRangeError
from brdf_suite.extras import import_extra
from brdf_suite.progress import Progress, report

_LOW, _HIGH = 1.0, 99.5
# A corner is refined within this share of the distance to the next one, so that no neighbour is drawn in.
_WINDOW_SHARE = 0.35
_LARGEST_WINDOW = 30
_BLUR_PX = 1.0
_REFINEMENTS = 60
_REFINED_PX = 1e-4
_FEWEST = 3
_OUTLYING = 4.0
_OUTLYING_PX = 0.5
_POOR_PX = 2.0
_NAMES = ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3")


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


@dataclass(frozen=True)
class CameraCalibration:
    """Intrinsics found from a board, and how well they explain its photographs.

    Attributes
    ----------
    intrinsics
        Focal lengths, principal point, distortion.
    rms_px
        Root mean square distance of a corner from where the camera should see it.
    photograph_rms_px
        The same of each photograph that was used.
    names, left_out
        The photographs that were used, and (name, reason) of those that were not.
    size
        (width, height) of the photographs.
    standard_errors
        Of fx, fy, cx, cy, k1, k2, p1, p2, k3; 0 where a coefficient was held at 0.
    """

    intrinsics: Lens
    rms_px: float
    photograph_rms_px: tuple[float, ...]
    names: tuple[str, ...]
    left_out: tuple[tuple[str, str], ...]
    size: tuple[int, int]
    standard_errors: tuple[float, ...]

    def to_json(self) -> dict[str, Any]:
        """Return plain values from which :meth:`from_json` makes the same."""
        return asdict(self)

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> CameraCalibration:
        """Make a calibration from what :meth:`to_json` gave; ValueRangeError where something is missing."""
        try:
            width, height = values["size"]
            return cls(
                Lens(**values["intrinsics"]),
                float(values["rms_px"]),
                tuple(float(v) for v in values["photograph_rms_px"]),
                tuple(str(v) for v in values["names"]),
                tuple((str(name), str(reason)) for name, reason in values["left_out"]),
                (int(width), int(height)),
                tuple(float(v) for v in values["standard_errors"]),
            )
        except (KeyError, TypeError, ValueError) as error:
            raise ValueRangeError("intrinsics", f"not a calibration of a camera ({error})") from error


def calibrate_intrinsics(
    photographs: Sequence[tuple[str, npt.NDArray[np.generic]]],
    columns: int,
    rows: int,
    square_m: float,
    progress: Progress | None = None,
) -> CameraCalibration:
    """Return the intrinsics that photographs of a board show.

    Parameters
    ----------
    photographs
        (name, codes (h, w) or (h, w, channels)), all of one size; the board in poses that differ in tilt.
    columns, rows
        Inner corners of the board across and down.
    square_m
        The side of a square; intrinsics do not depend on it.

    Raises
    ------
    ExtraError
        OpenCV is missing or cannot be loaded.
    AcquisitionError
        The board is seen in fewer than three photographs; they differ in size, or contradict
        each other.
    """
    cv2 = opencv()
    if not photographs:
        raise AcquisitionError("There are no photographs of the board.")
    size = (photographs[0][1].shape[1], photographs[0][1].shape[0])
    found: list[tuple[str, Floats]] = []
    left_out: list[tuple[str, str]] = []
    for i, (name, picture) in enumerate(photographs):
        report(progress, 0.8 * i / len(photographs), f"board in {name}")
        if (picture.shape[1], picture.shape[0]) != size:
            seen = f"{name}: the photograph has {picture.shape[1]} × {picture.shape[0]} pixels"
            raise AcquisitionError(f"{seen}, {photographs[0][0]} has {size[0]} × {size[1]}.")
        corners = find_corners(picture, columns, rows)
        if corners is None:
            left_out.append((name, f"no board of {columns} × {rows} inner corners was found in it"))
        else:
            found.append((name, corners))
    report(progress, 0.8, "intrinsics")
    _enough(found, left_out, columns, rows)
    answer = _calibrated(cv2, found, columns, rows, square_m, size)
    limit = max(_OUTLYING_PX, _OUTLYING * float(np.median(answer.photograph_rms_px)))
    good = []
    for pair, rms in zip(found, answer.photograph_rms_px, strict=True):
        if rms <= limit:
            good.append(pair)
        else:
            left_out.append((pair[0], f"its corners lie {rms:.2g} pixels from where the others put them"))
    if len(good) < len(found):
        _enough(good, left_out, columns, rows)
        answer = _calibrated(cv2, good, columns, rows, square_m, size)
    if answer.rms_px > _POOR_PX:
        raise AcquisitionError(
            f"The photographs of the board contradict each other by {answer.rms_px:.2g} pixels: {answer.names[0]} …"
            f" {answer.names[-1]}. Is the board flat, and was focus or zoom changed between them?"
        )
    report(progress, 1.0, "intrinsics")
    return replace(answer, left_out=tuple(left_out))


def _enough(
    found: Sequence[tuple[str, Floats]], left_out: Sequence[tuple[str, str]], columns: int, rows: int
) -> None:
    if len(found) < _FEWEST:
        reasons = "; ".join(f"{name}: {reason}" for name, reason in left_out[:4]) or "there are no more"
        raise AcquisitionError(
            f"The board with {columns} × {rows} inner corners is of use in {len(found)} photographs; {_FEWEST} are"
            f" needed, better ten ({reasons})."
        )


def _calibrated(
    cv2: ModuleType,
    found: Sequence[tuple[str, Floats]],
    columns: int,
    rows: int,
    square_m: float,
    size: tuple[int, int],
) -> CameraCalibration:
    """Return the calibration with as many coefficients of distortion as the corners determine."""
    board = np.zeros((rows * columns, 3), np.float32)
    board[:, :2] = square_m * np.mgrid[0:columns, 0:rows].T.reshape(-1, 2)
    # OpenCV takes single precision, and its own copies of both lists.
    objects = [board] * len(found)
    images = [np.ascontiguousarray(corners, np.float32).reshape(-1, 1, 2) for _, corners in found]
    numbers = 2 * len(found) * len(board)
    one = cv2.CALIB_FIX_K2 | cv2.CALIB_FIX_K3 | cv2.CALIB_ZERO_TANGENT_DIST
    best: tuple[float, Any] | None = None
    for freedom, flags in ((1, one), (4, cv2.CALIB_FIX_K3), (5, 0)):
        try:
            answer = cv2.calibrateCameraExtended(objects, images, size, None, None, flags=flags)
        except cv2.error as error:
            raise AcquisitionError(f"OpenCV cannot calibrate the camera: {error.err}.") from error
        score = numbers * float(np.log(max(answer[0], 1e-9) ** 2)) + freedom * float(np.log(numbers))
        if best is None or score < best[0]:
            best = (score, answer)
    assert best is not None
    rms, matrix, distortion, _, _, deviations, _, errors = best[1]
    lens = Lens(matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], *np.ravel(distortion)[:5].tolist())
    return CameraCalibration(
        lens,
        float(rms),
        tuple(float(v) for v in np.ravel(errors)),
        tuple(name for name, _ in found),
        (),
        size,
        tuple(float(v) for v in np.ravel(deviations)[: len(_NAMES)]),
    )
