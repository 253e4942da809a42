"""The photographs of a session as radiance: where they come from, how they are corrected and merged."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from brdf_suite.acquisition.geometry.intrinsics import CameraCalibration
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry
from brdf_suite.acquisition.photographs.reading import read_photograph
from brdf_suite.acquisition.radiance.merge import Dark, MergedRadiance, merge
from brdf_suite.acquisition.radiance.sensor_maps import dark_model, flat_field
from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.reconstruction.work_file import StepClock
from brdf_suite.acquisition.response.response import Response
from brdf_suite.acquisition.session.check import check_session
from brdf_suite.acquisition.session.finding import SessionFinding
from brdf_suite.acquisition.session.series import (
    PhotographSeries,
    SeriesKind,
    read_calibration,
    read_mask,
    read_position,
)
from brdf_suite.acquisition.session.session import Session
from brdf_suite.acquisition.session.store import session_to_json
from brdf_suite.arrays import AnyArray, Bools
from brdf_suite.errors import AcquisitionError, FileError, ValueRangeError
from brdf_suite.progress import Progress
from brdf_suite.regular_files import open_regular

_PIECE = 1 << 20


class PhotographSource(Protocol):
    """Photographs of one session."""

    @property
    def session(self) -> Session:
        """Return what the photographs show."""

    def position(self, k: int) -> PhotographSeries:
        """Return the photographs of position ``k``; raises :class:`FileError` where there are none."""

    def series(self, kind: SeriesKind) -> PhotographSeries | None:
        """Return the dark, white or flat-field photographs; None where the session has none."""

    def board(self) -> list[tuple[str, AnyArray]]:
        """Return names and grey pictures (rows, columns) of the calibration board."""

    def mask(self, k: int | None) -> Bools | None:
        """Return which pixels (rows, columns) may be used, at one position or at all; None: all of them."""

    def digest(self, k: int | None) -> str:
        """Return a hash of what position ``k`` holds; of None: the session and all that belongs to no position."""

    def findings(self, progress: Progress | None) -> tuple[SessionFinding, ...]:
        """Return what is wrong with the files, without decoding them."""


@dataclass(frozen=True)
class FolderSource:
    """The photographs in a session's folder."""

    folder: Path
    session: Session

    @cached_property
    def _checked(self) -> tuple[SessionFinding, ...]:
        return self.findings(None)

    def position(self, k: int) -> PhotographSeries:
        """Read one position; photographs that cannot be read or contradict the session are skipped and reported."""
        for finding in self._checked:
            if finding.severity == "position" and finding.position == k:
                raise finding.error()
        skipped = [one for one in self._checked if one.position == k and one.severity == "exposure"]
        lost = [one.exposure for one in skipped if one.exposure is not None]
        found = read_position(self.folder, self.session, k, leave_out=lost)
        return replace(found, findings=(*skipped, *found.findings))

    def series(self, kind: SeriesKind) -> PhotographSeries | None:
        """Read a calibration series."""
        return read_calibration(self.folder, self.session, kind)

    def board(self) -> list[tuple[str, AnyArray]]:
        """Read the board's photographs as grey pictures; those that the check found unreadable are left out."""
        board = self.session.camera.board
        lost = {finding.place for finding in self._checked}
        found = []
        for k, name in enumerate(() if board is None else board.photographs):
            if f"camera.board.photographs[{k}]" in lost:
                continue
            codes = read_photograph(self.folder / name).codes
            found.append((name, np.ascontiguousarray(codes[..., 1])))
        return found

    def mask(self, k: int | None) -> Bools | None:
        """Read the masks."""
        return read_mask(self.folder, self.session, k)

    def digest(self, k: int | None) -> str:
        """Hash the content of the files, and what the session says of them."""
        session = self.session
        found = hashlib.sha256()
        if k is None:
            found.update(json.dumps(session_to_json(session), sort_keys=True).encode())
            positions = {name for position in session.positions for name in position.photographs}
            names = [name for _, name in session.files() if name not in positions]
        else:
            position = session.positions[k]
            names = [*position.photographs, *([position.mask] if position.mask else [])]
        for name in names:
            found.update(f"\0{name}\0".encode("utf-8", "surrogatepass"))
            try:
                with open_regular(self.folder / name) as stream:
                    while piece := stream.read(_PIECE):
                        found.update(piece)
            except FileError:
                # A file that is missing now and there later changes the hash, which is all that is asked here.
                found.update(b"missing")
        return found.hexdigest()

    def findings(self, progress: Progress | None) -> tuple[SessionFinding, ...]:
        """Check the folder."""
        found = check_session(self.folder, self.session, progress)
        # What is read afterwards goes by it, without another look at every file.
        self.__dict__["_checked"] = found
        return found


@dataclass(frozen=True, eq=False)
class Calibration:
    """Response of the camera and geometry of the rig: what turns a stack of photographs into readings.

    ``response`` is None for photographs that are linear already (float files); ``figures`` are what the steps
    measured, plain values. Positions ``left_out`` give no readings, for the reason that stands beside them.
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
            "geometry": asdict(self.geometry),
            "figures": dict(self.figures),
            "left_out": [[k, reason] for k, reason in self.left_out.items()],
            "notices": list(self.notices),
        }

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> Calibration:
        """Return what :meth:`to_json` gave."""
        response, intrinsics = values["response"], values["intrinsics"]
        return cls(
            None if response is None else Response.from_json(response),
            None if intrinsics is None else CameraCalibration.from_json(intrinsics),
            RigGeometry.from_json(values["geometry"]),
            dict(values["figures"]),
            {int(k): str(reason) for k, reason in values["left_out"]},
            tuple(values["notices"]),
        )


@dataclass(frozen=True, eq=False)
class Corrections:
    """What is taken off each photograph: dark and flat field, full pictures or None."""

    dark: Dark | None = None
    flat: np.ndarray | None = None

    def merged(
        self,
        stack: PhotographSeries,
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


def corrections(
    series: Callable[[SeriesKind], PhotographSeries | None], response: Response | None
) -> Corrections:
    """Return dark and flat field of photographs that ``series`` reads; the same give the same, bit for bit."""
    dark_stack = series("dark")
    dark = None
    if dark_stack is not None and response is not None:
        dark = dark_model(dark_stack.codes, dark_stack.exposures_s, response)
    flat_stack = series("flat_field")
    if flat_stack is None:
        return Corrections(dark)
    return Corrections(dark, flat_field(Corrections(dark).merged(flat_stack, response, None)))


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

    def stack(self, k: int) -> PhotographSeries:
        """Read the photographs of position ``k``; raises FileError where none can be read."""
        with self.clock.step("read"):
            return self.source.position(k)

    def series(self, kind: SeriesKind) -> PhotographSeries | None:
        """Read a calibration series; None where the session has none."""
        with self.clock.step("read"):
            found = self.source.series(kind)
        for finding in () if found is None else found.findings:
            self.notice(f"{finding.path}: {finding.reason}.")
        return found

    def mask(self, k: int | None) -> Bools | None:
        """Return which pixels (rows, columns) may be used at position ``k``, or at all; None: all."""
        given, chosen = self.source.mask(k), self.options.mask
        if given is None or chosen is None:
            return chosen if given is None else given
        if given.shape != chosen.shape:
            reason = f"has the shape {chosen.shape}; that of the session has {given.shape}"
            raise ValueRangeError("mask", reason)
        return given & chosen

    def set_response(self, response: Response | None) -> None:
        """Take a response; None: the photographs are linear already."""
        self.response = response
        self._response_known = True
        with self.clock.step("calibrate"):
            self._corrections = corrections(self.series, response)

    def merged_stack(
        self, stack: PhotographSeries, k: int | None, box: tuple[slice, slice] | None = None
    ) -> MergedRadiance:
        """Return the radiance of photographs that were read, of the pixels in ``box`` (rows, columns) alone if given.

        ``k`` is the position whose mask holds; None: no mask at all.
        """
        if not self._response_known or self._corrections is None:
            raise AcquisitionError("The response comes first; it was not calibrated yet.")
        mask = None if k is None else self.mask(k)
        with self.clock.step("merge"):
            return self._corrections.merged(stack, self.response, mask, box)

    def readable(self, k: int) -> PhotographSeries | None:
        """Read a position; None where it cannot be read, which is reported when the table reaches it."""
        try:
            return self.stack(k)
        except FileError:
            return None

    def notice(self, sentence: str) -> None:
        """Add a notice for the user, once."""
        if sentence not in self.notices:
            self.notices = (*self.notices, sentence)
