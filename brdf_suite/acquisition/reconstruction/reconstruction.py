"""The road from photographs of a painted sphere to a table of its reflectance (Günther et al. 2005, section 3).

:class:`Acquisition` holds a session and takes the steps one by one, each leaving what it found for the next and for
pictures of it; :func:`acquire` takes them all. Photographs are read one position at a time, the next one while this
one is reckoned, so that memory does not hang on the number of positions. Everything is deterministic: taken up again
after a kill, a table comes out the same to the last bit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.photographs.exposure_faults import exposure_faults
from brdf_suite.acquisition.reconstruction.calibration import Calibration, Corrections, corrections
from brdf_suite.acquisition.reconstruction.geometry import find_geometry
from brdf_suite.acquisition.reconstruction.options import Acquired, AcquireOptions
from brdf_suite.acquisition.reconstruction.response import find_response
from brdf_suite.acquisition.reconstruction.source import (
    Bools,
    FolderSource,
    PhotographSource,
    SeriesKind,
    Stack,
)
from brdf_suite.acquisition.reconstruction.work_file import StepClock
from brdf_suite.acquisition.session.session import Session
from brdf_suite.errors import AcquisitionError, FileError, ValueRangeError
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

if TYPE_CHECKING:
    from brdf_suite.acquisition.geometry.intrinsics import CameraCalibration
    from brdf_suite.acquisition.geometry.refinement.refinement import Refinement
    from brdf_suite.acquisition.geometry.sphere.highlight import Highlight
    from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline
    from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry
    from brdf_suite.acquisition.radiance.merge import MergedRadiance
    from brdf_suite.acquisition.response.fit import ResponseFit
    from brdf_suite.acquisition.response.response import Response
    from brdf_suite.acquisition.session.finding import SessionFinding
    from brdf_suite.acquisition.table.samples import PositionSamples, SphereSampler

Partial = Callable[[int, int, Callable[[], IsotropicTable]], None]


class Acquisition:
    """One session on its way to a table.

    Attributes
    ----------
    source, session
        The photographs, and what they show.
    options
        May be set between the steps: a new mask takes part in the table without calibrating again.
    response, response_fit
        The camera's response (None: float photographs), and how it was recovered, where it was.
    intrinsics
        The camera's lens from the board; None: what the session states holds, if anything.
    union, outline, highlights, refinement, geometry
        What the geometry was found on: a picture (rows, columns), the sphere's edge, the highlights.
    left_out
        Positions that give no readings, and why: they show another light than stated, or the sphere has moved.
    notices
        What the user should know, each a sentence.
    """

    def __init__(self, source: PhotographSource, options: AcquireOptions | None = None) -> None:
        self.source = source
        self.session: Session = source.session
        self.options = options or AcquireOptions()
        self.response: Response | None = None
        self.response_fit: ResponseFit | None = None
        self.intrinsics: CameraCalibration | None = None
        self.union: npt.NDArray[np.float32] | None = None
        self.outline: SphereOutline | None = None
        self.highlights: tuple[Highlight, ...] = ()
        self.refinement: Refinement | None = None
        self.geometry: RigGeometry | None = None
        self.left_out: Mapping[int, str] = {}
        self.notices: tuple[str, ...] = ()
        self.clock = StepClock()
        self._figures: dict[str, Any] = {}
        self._response_known = False
        self._corrections: Corrections | None = None

    @classmethod
    def open(cls, folder: Path, options: AcquireOptions | None = None) -> Acquisition:
        """Return the session in ``folder`` (or that file ``session.json``); photographs may be missing still.

        Raises
        ------
        FileError
            ``session.json`` is missing, or is no session; the message names the field.
        """
        from brdf_suite.acquisition.session.store import read_session, session_path

        return cls(FolderSource(session_path(folder).parent, read_session(folder)), options)

    @property
    def positions(self) -> tuple[int, ...]:
        """Return which positions are used, rising.

        Raises
        ------
        ValueRangeError
            The options name one that the session has not.
        """
        every = range(len(self.session.positions))
        chosen = self.options.positions
        if chosen is None:
            return tuple(every)
        for k in chosen:
            if k not in every:
                raise ValueRangeError("positions", f"{k}; the session has positions 0 to {len(every) - 1}")
        if not chosen:
            raise ValueRangeError("positions", "none is asked for")
        return tuple(sorted(set(chosen)))

    def check(self, progress: Progress | None = None) -> tuple[SessionFinding, ...]:
        """Return what is wrong with the files, without decoding them (:mod:`~brdf_suite.acquisition.session.check`)."""
        return self.source.findings(progress)

    def stack(self, k: int) -> Stack:
        """Read the photographs of position ``k``; raises FileError where none can be read."""
        with self.clock.step("read"):
            return self.source.position(k)

    def series(self, kind: SeriesKind) -> Stack | None:
        """Read a calibration series; None where the session has none."""
        with self.clock.step("read"):
            found = self.source.series(kind)
        for finding in () if found is None else found.findings:
            self.notice(f"{finding}.")
        return found

    def mask(self, k: int | None) -> Bools | None:
        """Return which pixels (rows, columns) may be used at position ``k``, or at all; None: all."""
        given, chosen = self.source.mask(k), self.options.mask
        if given is None or chosen is None:
            return chosen if given is None else given
        if given.shape != chosen.shape:
            raise ValueRangeError(
                "mask", f"has the shape {chosen.shape}; that of the session has {given.shape}"
            )
        return given & chosen

    def calibrate_response(self, progress: Progress | None = None) -> Response | None:
        """Recover the camera's response; None for photographs that are linear already.

        Raises
        ------
        FittingError
            The photographs do not tell it.
        FileError
            No photograph can be read.
        """
        self.response_fit = None
        found = find_response(self, progress)
        self.response_fit = found.fit
        self._figures |= found.figures
        self.set_response(found.response)
        return self.response

    def set_response(self, response: Response | None) -> None:
        """Take a response; None: the photographs are linear already."""
        self.response = response
        self._response_known = True
        with self.clock.step("calibrate"):
            self._corrections = corrections(self.series, response)

    def calibrate_intrinsics(self, progress: Progress | None = None) -> CameraCalibration | None:
        """Find the lens from the board's photographs; None where there is no board: what the session states holds."""
        board = self.session.camera.board
        if board is None:
            return None
        from brdf_suite.acquisition.geometry.intrinsics import calibrate_intrinsics

        with self.clock.step("read"):
            pictures = self.source.board()
        with self.clock.step("calibrate"):
            self.intrinsics = calibrate_intrinsics(
                pictures, board.columns, board.rows, board.square_m, progress
            )
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

    def set_geometry(self, geometry: RigGeometry) -> None:
        """Take a geometry that was corrected by hand."""
        self.geometry = geometry

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

    def merged(self, k: int, progress: Progress | None = None) -> MergedRadiance:
        """Return the radiance of position ``k``, whole picture."""
        report(progress, 0.0, "reading")
        stack = self.stack(k)
        report(progress, 0.7, "merging")
        return self.merged_stack(stack, k)

    def sampler(self) -> SphereSampler:
        """Return what turns radiance into readings, for the geometry and the mask that hold now."""
        from brdf_suite.acquisition.table.samples import SphereSampler

        return SphereSampler(self.calibration.geometry, self.mask(None), self.options.grazing_deg)

    def samples(
        self, k: int, sampler: SphereSampler | None = None, stack: Stack | None = None
    ) -> PositionSamples:
        """Return the readings of position ``k``.

        Raises
        ------
        FileError
            Its photographs cannot be read, or contradict each other; the message names one.
        """
        return self.checked_samples(k, sampler or self.sampler(), stack or self.stack(k))[0]

    def checked_samples(
        self, k: int, sampler: SphereSampler, stack: Stack
    ) -> tuple[PositionSamples, tuple[str, ...]]:
        """Return the readings of photographs that were read, and what was found wrong with these.

        Photographs that contradict the others, by their times or their order, are left out; where the others
        contradict each other too, FileError is raised.
        """
        told: list[str] = list(stack.findings)
        for again in (False, True):
            merged = self.merged_stack(stack, k, sampler.box)
            with self.clock.step("samples"):
                found = sampler.samples(k, merged.radiance, merged.variance, merged.good)
            # Where light and camera see nothing in common, as near 180°, there is nothing to be contradicted.
            faults = exposure_faults(merged, stack.exposures_s, stack.names) if len(found) else []
            bad = [fault for fault in faults if fault.fatal]
            if bad and (again or len(stack.names) - len(bad) < 2):
                raise bad[0].error()
            told += [f"{fault.name}: {fault.reason}" for fault in faults]
            if not bad:
                break
            stack = stack.without({fault.name for fault in bad})
        return found, tuple(told)

    def table(
        self,
        progress: Progress | None = None,
        work: Path | None = None,
        partial: Partial | None = None,
        restart: bool = False,
    ) -> Acquired:
        """Return the table; see :func:`brdf_suite.acquisition.reconstruction.table.reconstruct`."""
        from brdf_suite.acquisition.reconstruction.table import reconstruct

        return reconstruct(self, progress, work, partial, restart)

    @staticmethod
    def write(found: Acquired, path: Path, overwrite: bool = False) -> tuple[str, ...]:
        """Write a table, ``.brdftable`` or ``.binary``, and return notes; an existing file is left as it is."""
        from brdf_suite.acquisition.reconstruction.output import write_acquired

        return write_acquired(found, path, overwrite=overwrite)

    def merged_stack(
        self, stack: Stack, k: int | None, box: tuple[slice, slice] | None = None
    ) -> MergedRadiance:
        """Return the radiance of photographs that were read, of the pixels in ``box`` (rows, columns) alone if given.

        ``k`` is the position whose mask holds; None: no mask at all.
        """
        if not self._response_known or self._corrections is None:
            raise AcquisitionError("The response comes first; it was not calibrated yet.")
        mask = None if k is None else self.mask(k)
        with self.clock.step("merge"):
            return self._corrections.merged(stack, self.response, mask, box)

    def readable(self, k: int) -> Stack | None:
        """Read a position, or None: what cannot be read is told when its turn in the table comes."""
        try:
            return self.stack(k)
        except FileError:
            return None

    def notice(self, sentence: str) -> None:
        """Tell the user something, once."""
        if sentence not in self.notices:
            self.notices = (*self.notices, sentence)
