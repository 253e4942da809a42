"""The photographs of a session as radiance: read position by position, corrected and merged."""

from __future__ import annotations

from typing import TYPE_CHECKING

from brdf_suite.acquisition.reconstruction.calibration import Corrections, corrections
from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.reconstruction.source import PhotographSource, SeriesKind, Stack
from brdf_suite.acquisition.reconstruction.work_file import StepClock
from brdf_suite.acquisition.session.session import Session
from brdf_suite.arrays import Bools
from brdf_suite.errors import AcquisitionError, FileError, ValueRangeError
from brdf_suite.progress import Progress

if TYPE_CHECKING:
    from brdf_suite.acquisition.geometry.intrinsics import CameraCalibration
    from brdf_suite.acquisition.radiance.merge import MergedRadiance
    from brdf_suite.acquisition.response.response import Response
    from brdf_suite.acquisition.session.finding import SessionFinding


class SessionPhotographs:
    """What the calibration steps read of a session: stacks, series and masks, and radiance once there is a response.

    Attributes
    ----------
    source, session
        The photographs, and what they show.
    options
        May be set between the steps: a new mask takes part in the table without calibrating again.
    response
        The camera's response; None: float photographs.
    intrinsics
        The camera's lens from the board; None: what the session states holds, if anything.
    notices
        What the user should know, each a sentence.
    clock
        The seconds of each step.
    """

    def __init__(self, source: PhotographSource, options: AcquireOptions | None = None) -> None:
        self.source = source
        self.session: Session = source.session
        self.options = options or AcquireOptions()
        self.response: Response | None = None
        self.intrinsics: CameraCalibration | None = None
        self.notices: tuple[str, ...] = ()
        self.clock = StepClock()
        self._response_known = False
        self._corrections: Corrections | None = None

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

    def set_response(self, response: Response | None) -> None:
        """Take a response; None: the photographs are linear already."""
        self.response = response
        self._response_known = True
        with self.clock.step("calibrate"):
            self._corrections = corrections(self.series, response)

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
        """Read a position; None where it cannot be read, which is reported when the table reaches it."""
        try:
            return self.stack(k)
        except FileError:
            return None

    def notice(self, sentence: str) -> None:
        """Add a notice for the user, once."""
        if sentence not in self.notices:
            self.notices = (*self.notices, sentence)
