"""The calibrations of a reconstruction, as one value: what turns a stack of photographs into readings."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from brdf_suite.acquisition.geometry.intrinsics import CameraCalibration
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry
from brdf_suite.acquisition.radiance.dark_frame import dark_model
from brdf_suite.acquisition.radiance.flat_field import flat_field
from brdf_suite.acquisition.radiance.merge import merge
from brdf_suite.acquisition.response.response import Response

if TYPE_CHECKING:
    from brdf_suite.acquisition.radiance.dark_frame import Dark
    from brdf_suite.acquisition.radiance.merge import MergedRadiance
    from brdf_suite.acquisition.reconstruction.source import SeriesKind, Stack
    from brdf_suite.arrays import Bools


@dataclass(frozen=True, eq=False)
class Calibration:
    """Response of the camera and geometry of the rig; ``figures`` are what the steps measured, plain values.
    Positions ``left_out`` give no
    readings, for the reason that stands beside them.

    ``response`` is None for photographs that are linear already (float files).
    """

    response: Response | None
    intrinsics: CameraCalibration | None
    geometry: RigGeometry
    figures: Mapping[str, Any]
    left_out: Mapping[int, str] = field(default_factory=dict)
    notices: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Return everything, exact to the last bit."""
        return {
            "response": None if self.response is None else self.response.to_json(),
            "intrinsics": None if self.intrinsics is None else self.intrinsics.to_json(),
            "geometry": self.geometry.to_json(),
            "figures": dict(self.figures),
            "left_out": [[k, reason] for k, reason in self.left_out.items()],
            "notices": list(self.notices),
        }

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> Calibration:
        """Return what :meth:`to_json` gave."""
        response, intrinsics = values["response"], None
        if values["intrinsics"] is not None:
            intrinsics = CameraCalibration.from_json(values["intrinsics"])
        return cls(
            None if response is None else Response.from_json(response),
            intrinsics,
            RigGeometry.from_json(values["geometry"]),
            dict(values["figures"]),
            {int(k): str(reason) for k, reason in values["left_out"]},
            tuple(values["notices"]),
        )

    def summary(self) -> dict[str, Any]:
        """Return the figures, for people."""
        return dict(self.figures)


@dataclass(frozen=True, eq=False)
class Corrections:
    """What is taken off each photograph: dark and flat field, full pictures or None."""

    dark: Dark | None = None
    flat: np.ndarray | None = None

    def merged(
        self,
        stack: Stack,
        response: Response | None,
        mask: Bools | None,
        box: tuple[slice, slice] | None = None,
    ) -> MergedRadiance:
        """Return the radiance of a stack, of the pixels in ``box`` (rows, columns) where it is given."""
        if self.dark is not None and self.dark.hot.any():
            mask = ~self.dark.hot if mask is None else mask & ~self.dark.hot
        if box is None:
            return merge(stack.codes, stack.exposures_s, response, dark=self.dark, flat=self.flat, mask=mask)
        rows, columns = box
        return merge(
            np.ascontiguousarray(stack.codes[:, rows, columns]),
            stack.exposures_s,
            response,
            dark=None if self.dark is None else self.dark.cropped(rows, columns),
            flat=None if self.flat is None else self.flat[rows, columns],
            mask=None if mask is None else mask[rows, columns],
        )


def corrections(series: Callable[[SeriesKind], Stack | None], response: Response | None) -> Corrections:
    """Return dark and flat field of photographs that ``series`` reads; the same give the same, bit for bit."""
    dark_stack = series("dark")
    dark = None
    if dark_stack is not None and response is not None:
        dark = dark_model(dark_stack.codes, dark_stack.exposures_s, response)
    flat_stack = series("flat_field")
    if flat_stack is None:
        return Corrections(dark)
    return Corrections(dark, flat_field(Corrections(dark).merged(flat_stack, response, None)))
