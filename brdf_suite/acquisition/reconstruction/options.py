"""What a user chooses of a reconstruction, and what it gives."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from brdf_suite.acquisition.reconstruction.coverage import covered_share
from brdf_suite.arrays import Bools
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

if TYPE_CHECKING:
    from brdf_suite.acquisition.reconstruction.calibration import Calibration
    from brdf_suite.acquisition.table.table_from_sums import ParameterizedTable

ResponseChoice = Literal["auto", "linear"]
BINS = (90, 90, 180)


@dataclass(frozen=True, eq=False)
class AcquireOptions:
    """Choices that change the result.

    Attributes
    ----------
    grazing_deg
        Readings whose light or view is further from the normal are left out, degrees, 30 to less than 90.
    refine
        Whether highlights may correct the stated geometry.
    response
        ``auto``: as the session says, recovered where it says ``unknown``; ``linear``: the camera is linear.
    mask
        (rows, columns), True where a pixel may be used, besides the session's own masks; None: no further mask.
    positions
        Which positions of the session to use, rising; None: all.
    compare
        Whether to make the two other layouts of Figure 4 as well.
    bins
        Of the table along (θh, θd, φd); what renders elsewhere wants the usual 90 × 90 × 180.
    """

    grazing_deg: float = 80.0
    refine: bool = True
    response: ResponseChoice = "auto"
    mask: Bools | None = None
    positions: tuple[int, ...] | None = None
    compare: bool = False
    bins: tuple[int, int, int] = BINS

    def __post_init__(self) -> None:
        if not 30.0 <= self.grazing_deg < 90.0:
            raise ValueRangeError("grazing_deg", f"{self.grazing_deg:g}°; 30° to less than 90° are wanted")
        HalfAngleGrid(*self.bins)
        if self.response not in get_args(ResponseChoice):
            raise ValueRangeError("response", f"{self.response!r}; auto or linear are known")

    def to_json(self) -> dict[str, object]:
        """Return what decides the result, for the key of a work file."""
        mask = self.mask
        digest = (
            None if mask is None else hashlib.sha256(repr(mask.shape).encode() + np.packbits(mask).tobytes())
        )
        return {
            "grazing_deg": self.grazing_deg,
            "refine": self.refine,
            "response": self.response,
            "mask": None if digest is None else digest.hexdigest(),
            "compare": self.compare,
            "bins": list(self.bins),
        }


@dataclass(frozen=True)
class LeftOut:
    """A position that gave no readings, and why (a sentence's clause that names the file)."""

    position: int
    reason: str


@dataclass(frozen=True, eq=False)
class Acquired:
    """A reconstructed table and how it came to be.

    Attributes
    ----------
    table
        Half-angle bins with their coverage, working space.
    positions_done, positions_failed
        Which positions gave readings, and which gave none.
    resumed
        How many of the positions were taken up from a work file.
    readings
        How many readings the table is made of.
    calibration
        Response and geometry.
    notices
        What the user should know, each a sentence.
    seconds
        Time by step: ``read`` (decoding, in the background), ``calibrate``, ``merge``, ``samples``,
        ``table`` (readings into bins), ``finish`` (means to centres, holes).
    compared
        The other layouts by name, where they were asked for.
    """

    table: IsotropicTable
    positions_done: tuple[int, ...]
    positions_failed: tuple[LeftOut, ...]
    resumed: int
    readings: int
    calibration: Calibration
    notices: tuple[str, ...] = ()
    seconds: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    compared: Mapping[str, ParameterizedTable] = field(default_factory=lambda: MappingProxyType({}))

    def to_json(self) -> dict[str, Any]:
        """Return what ``brdf-suite acquire --json`` prints."""
        coverage = self.table.coverage
        median = 0.0
        if coverage is not None and (coverage.samples > 0.0).any():
            median = float(np.median(coverage.deviation[coverage.samples > 0.0]))
        return {
            "positions": len(self.positions_done),
            "resumed": self.resumed,
            "left_out": [{"position": one.position, "reason": one.reason} for one in self.positions_failed],
            "readings": self.readings,
            "coverage": {
                "bins": int(np.count_nonzero(self.table.measured_mask())),
                "share_below_75_deg": covered_share(self.table, 75.0),
                "median_deviation": median,
            },
            "calibration": self.calibration.summary(),
            "notices": list(self.notices),
            "seconds": {name: round(value, 3) for name, value in self.seconds.items()},
        }
