"""From photographs of a painted sphere to readings of its reflectance (Günther et al. 2005, section 3).

:class:`Acquisition` holds a session and takes the steps one by one, each leaving its results for the next and for
pictures of them; :func:`~brdf_suite.acquisition.reconstruction.table.reconstruct` makes the table. Everything is
deterministic: resumed after a crash, a table comes out the same to the last bit.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.geometry.intrinsics import CameraCalibration, calibrate_intrinsics
from brdf_suite.acquisition.geometry.refinement.refinement import Refinement
from brdf_suite.acquisition.geometry.sphere.highlight import Highlight
from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry
from brdf_suite.acquisition.photographs.exposure_faults import exposure_faults
from brdf_suite.acquisition.radiance.sensor_maps import black_codes
from brdf_suite.acquisition.reconstruction.geometry import find_geometry
from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.reconstruction.photographs import (
    Calibration,
    FolderSource,
    PhotographSource,
    SessionPhotographs,
)
from brdf_suite.acquisition.response.fit import ResponseFit, calibrate_response
from brdf_suite.acquisition.response.response import Response, srgb_response
from brdf_suite.acquisition.response.samples import ResponseSamples, spread
from brdf_suite.acquisition.session.series import PhotographSeries
from brdf_suite.acquisition.session.store import read_session, session_path
from brdf_suite.acquisition.table.samples import PositionSamples, SphereSampler
from brdf_suite.errors import AcquisitionError
from brdf_suite.progress import Progress, report, subrange

RESPONSE_POSITIONS = 8
"""Spread over the arc; each holds millions of pixels, and all codes are seen in a few."""


class Acquisition(SessionPhotographs):
    """The calibration of one session, step by step, and the readings of its positions.

    Attributes
    ----------
    response_fit
        How the response was recovered, where it was.
    union, outline, highlights, refinement, geometry
        What the geometry was found on: a picture (rows, columns), the sphere's edge, the highlights.
    left_out
        Positions that give no readings, and why: they show another light than stated, or the sphere has moved.
    """

    def __init__(self, source: PhotographSource, options: AcquireOptions | None = None) -> None:
        super().__init__(source, options)
        self.response_fit: ResponseFit | None = None
        self.union: npt.NDArray[np.float32] | None = None
        self.outline: SphereOutline | None = None
        self.highlights: tuple[Highlight, ...] = ()
        self.refinement: Refinement | None = None
        self.geometry: RigGeometry | None = None
        self.left_out: Mapping[int, str] = {}
        self._figures: dict[str, Any] = {}

    @classmethod
    def open(cls, folder: Path, options: AcquireOptions | None = None) -> Acquisition:
        """Return the session in ``folder`` (or that file ``session.json``); photographs may be missing still.

        Raises
        ------
        FileError
            ``session.json`` is missing, or is no session; the message names the field.
        """
        return cls(FolderSource(session_path(folder).parent, read_session(folder)), options)

    def calibrate_response(self, progress: Progress | None = None) -> Response | None:
        """Recover the camera's response; None for photographs that are linear already.

        Raises
        ------
        FittingError
            The photographs do not determine it.
        FileError
            No photograph can be read.
        """
        self.response_fit = None
        camera = self.session.camera
        kind = "linear" if self.options.response == "linear" else camera.response
        dark = self.series("dark")
        samples = self._response_samples(subrange(progress, 0.0, 0.6))
        if samples is None:
            self._figures["response"] = "photographs are linear (float files)"
            self.set_response(None)
            return None
        with self.clock.step("calibrate"):
            fit = calibrate_response(
                samples,
                None if dark is None else black_codes(dark.codes),
                linear=kind == "linear",
                known=srgb_response(camera.bit_depth) if kind == "srgb" else None,
                progress=subrange(progress, 0.6, 1.0),
            )
        self.response_fit = fit
        found = "linear" if fit.response.linear else "recovered"
        self._figures |= {
            "response": "sRGB, as the session states" if kind == "srgb" else found,
            "response_pixels": int(fit.pixels.min()),
            "largest_time_error": float(np.abs(np.expm1(fit.time_residuals)).max()),
        }
        self.set_response(fit.response)
        return self.response

    def _response_samples(self, progress: Progress | None) -> ResponseSamples | None:
        """Return pixels of some positions, those that have the same photographs; None for float files."""
        chosen, mask = self.positions, self.mask(None)
        places = [chosen[place] for place in spread(len(chosen), RESPONSE_POSITIONS)]
        # Codes of one exposure stand in one column, so positions that lack different photographs may not be mixed.
        by_times: dict[tuple[float, ...], ResponseSamples] = {}
        counts: Counter[tuple[float, ...]] = Counter()
        for n, k in enumerate(places):
            report(progress, n / len(places), "reading for the response")
            stack = self.readable(k)
            if stack is None and not by_times and n == len(places) - 1:
                # None of those: the first one that can be read at all, or the reason of the last.
                *others, last = chosen
                found = (again for k in others if (again := self.readable(k)) is not None)
                stack = next(found, None) or self.stack(last)
            if stack is None:
                continue
            if stack.codes.dtype == np.float32:
                return None
            times = tuple(float(time) for time in stack.exposures_s)
            if times not in by_times:
                by_times[times] = ResponseSamples(times, self.session.camera.bit_depth)
            by_times[times].add(stack.codes, mask)
            counts[times] += 1
        return by_times[max(by_times, key=lambda times: (counts[times], len(times)))]

    def calibrate_intrinsics(self, progress: Progress | None = None) -> CameraCalibration | None:
        """Find the lens from the board's photographs; None where there is no board: what the session states holds."""
        board = self.session.camera.board
        if board is None:
            return None
        with self.clock.step("read"):
            pictures = self.source.board()
        with self.clock.step("calibrate"):
            size = (board.columns, board.rows, board.square_m)
            self.intrinsics = calibrate_intrinsics(pictures, *size, progress)
        for name, reason in self.intrinsics.left_out:
            self.notice(f"{name}: {reason}.")
        self._figures["lens_rms_px"] = self.intrinsics.rms_px
        return self.intrinsics

    def calibrate_geometry(self, progress: Progress | None = None) -> RigGeometry:
        """Find the sphere by its outline, and correct it and the light by the highlights.

        Raises
        ------
        AcquisitionError
            No sphere is seen.
        """
        found = find_geometry(self, progress)
        self.union, self.outline, self.highlights = found.union, found.outline, found.highlights
        self.refinement, self.geometry = found.refinement, found.geometry
        self.left_out = found.left_out
        self._figures |= found.figures
        for sentence in found.notices:
            self.notice(sentence)
        return self.geometry

    @property
    def calibration(self) -> Calibration:
        """Return response and geometry as one value; raises AcquisitionError where a step was not taken."""
        if not self._response_known or self.geometry is None:
            raise AcquisitionError("Response and geometry come first; one of them was not calibrated yet.")
        return Calibration(
            self.response, self.intrinsics, self.geometry, dict(self._figures), self.left_out, self.notices
        )

    def take_calibration(self, calibration: Calibration) -> None:
        """Take a calibration that was kept, as if its steps had been taken."""
        self.intrinsics = calibration.intrinsics
        self.geometry = calibration.geometry
        self.left_out = calibration.left_out
        self.notices = calibration.notices
        self._figures = dict(calibration.figures)
        self.set_response(calibration.response)

    def calibrate(self, progress: Progress | None = None) -> Calibration:
        """Take all steps before the table."""
        self.calibrate_response(subrange(progress, 0.0, 0.3))
        self.calibrate_intrinsics(subrange(progress, 0.3, 0.35))
        self.calibrate_geometry(subrange(progress, 0.35, 1.0))
        return self.calibration

    def sampler(self) -> SphereSampler:
        """Return what turns radiance into readings, for the geometry and the mask that hold now."""
        return SphereSampler(self.calibration.geometry, self.mask(None), self.options.grazing_deg)

    def checked_samples(
        self, k: int, sampler: SphereSampler, stack: PhotographSeries
    ) -> tuple[PositionSamples, tuple[str, ...]]:
        """Return the readings of photographs that were read, and what was found wrong with these.

        Photographs that contradict the others, by their times or their order, are left out; where the others
        contradict each other too, FileError is raised.
        """
        findings = [f"{one.path}: {one.reason}" for one in stack.findings]
        for again in (False, True):
            merged = self.merged_stack(stack, k, sampler.box)
            with self.clock.step("samples"):
                found = sampler.samples(k, merged.radiance, merged.variance, merged.good)
            # Where light and camera see nothing in common, as near 180°, there is nothing to be contradicted.
            faults = exposure_faults(merged, stack.exposures_s, stack.names) if len(found) else []
            bad = [fault for fault in faults if fault.fatal]
            if bad and (again or len(stack.names) - len(bad) < 2):
                raise bad[0].error()
            findings += [f"{fault.name}: {fault.reason}" for fault in faults]
            if not bad:
                break
            wrong = {fault.name for fault in bad}
            stack = stack.part([i for i, name in enumerate(stack.names) if name not in wrong])
        return found, tuple(findings)
