"""Camera of a session: its position, its code depth and response, and its lens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from brdf_suite.acquisition.geometry.lens import Lens
from brdf_suite.acquisition.session.values import (
    PARAMETERS,
    Matrix,
    check_numbers,
    check_series,
    check_whole,
    set_numbers,
)
from brdf_suite.documents.parameter import check_choice, describe
from brdf_suite.errors import ValueRangeError

ResponseKind = Literal["unknown", "linear", "srgb"]
RESPONSES: tuple[str, ...] = get_args(ResponseKind)

_MOST_BOARDS = 500
# A matrix between camera and working space keeps white; what does not is one for another purpose.
_WHITE_KEPT = 0.02


@dataclass(frozen=True)
class Board:
    """A chessboard photographed for the intrinsics: inner corners across and down, and the side of a square."""

    columns: int
    rows: int
    square_m: float
    photographs: tuple[str, ...]

    def __post_init__(self) -> None:
        for name in ("columns", "rows"):
            check_whole(getattr(self, name), name, 3, 100)
        set_numbers(self, PARAMETERS["board.square_m"], "square_m")
        files = check_series(self.photographs, "photographs", 1, _MOST_BOARDS)
        object.__setattr__(self, "photographs", files)


@dataclass(frozen=True)
class SessionCamera:
    """The camera of a session: its position, and the meaning of its codes.

    Attributes
    ----------
    distance_m, height_m
        Of its centre of projection: level distance to the turntable's axis, and height above the sphere's centre.
    bit_depth
        8 to 16: codes are 0 … 2^bits - 1 as they stand in the file. Float pictures know none.
    response
        ``unknown``: the curve is recovered from the exposures; ``linear``; or ``srgb``, the curve of IEC 61966-2-1.
    tilt_deg
        Of the optical axis, positive upwards.
    to_working
        (3, 3) from the channels' reflectance to linear Rec. 2020; rows sum to 1. ``None``: the channels are taken so.
    intrinsics, board
        Known values, or photographs of a board to recover them from; with neither, the focal length follows from the
        outline of the sphere and the distance.
    """

    distance_m: float
    height_m: float = 0.0
    bit_depth: int = 12
    response: ResponseKind = "unknown"
    tilt_deg: float = 0.0
    to_working: Matrix | None = None
    intrinsics: Lens | None = None
    board: Board | None = None

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS["camera.distance_m"], "distance_m")
        set_numbers(self, PARAMETERS["height_m"], "height_m")
        set_numbers(self, PARAMETERS["tilt_deg"], "tilt_deg")
        check_whole(self.bit_depth, "bit_depth", 8, 16)
        check_choice(self.response, "response", RESPONSES)
        if self.to_working is not None:
            if not isinstance(self.to_working, (tuple, list)) or len(self.to_working) != 3:
                raise ValueRangeError(
                    "to_working", f"expected three rows of three numbers, not {describe(self.to_working)}"
                )
            rows = [
                check_numbers(row, f"to_working[{i}]", PARAMETERS["matrix"], 3)
                for i, row in enumerate(self.to_working)
            ]
            for i, row in enumerate(rows):
                if abs(sum(row) - 1.0) > _WHITE_KEPT:
                    raise ValueRangeError(
                        f"to_working[{i}]",
                        f"the row sums to {sum(row):g}, not to 1, so that white would change",
                    )
            object.__setattr__(self, "to_working", tuple(rows))
