"""Check of a folder against its session: missing, truncated or inconsistent files.

Every file is opened once: that it is there and whole, its size and depth, and the exposure time in its EXIF data.
Then one photograph of each position is unpacked, to see that the highlight goes the way of the lamp.
"""

from __future__ import annotations

import bisect
import contextlib
import math
import re
from collections import Counter
from collections.abc import Collection
from pathlib import Path

import numpy as np
from scipy.ndimage import uniform_filter

from brdf_suite.acquisition.photographs.reading import PhotographFacts, photograph_facts, read_photograph
from brdf_suite.acquisition.session.finding import SessionFinding, Severity
from brdf_suite.acquisition.session.series import MASK_FILE
from brdf_suite.acquisition.session.session import Session
from brdf_suite.arrays import AnyArray
from brdf_suite.errors import FileError, PathLike
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.regular_files import is_file

_LEAST_LIGHT = 0.03
"""Of the scale of codes above black, for a highlight to count as seen."""
_BRIGHT = 0.5
_SLACK = 0.012
"""Of the picture's width: how far a highlight may lie back by noise and by the size of pixels."""
_LEAST_POSITIONS = 4
_MOST_DEG = 160.0
LEAST_EXPOSURES = 4
"""Of a position, from which a response curve can be recovered."""
_SAME_TIME = 0.20
"""Cameras record nominal times: 1/3 s is 0.3 s, and 1/60 s is 1/64 s."""
_OTHER_TIME = 0.01
"""Within this share EXIF's time is another exposure's of the session, so that the files were exchanged."""


class PositionOrder:
    """Check of the order of positions by the highlight's column at each, from the brightest part of the sphere there.

    As the lamp goes from before the camera (0°) to the right and behind the sphere (180°), the highlight wanders from
    the middle to the right and never back. A position whose highlight lies elsewhere shows another lamp than is stated.
    Angles from 0° to 160° and, mirrored, from -160° to 0° are looked at; what else there is, is left alone: a lamp
    behind the sphere lights its rim on both sides, whose middle wanders back.
    """

    def __init__(self, session: Session, folder: PathLike = ".") -> None:
        self._session, self._folder = session, Path(folder)
        self._columns: dict[int, float] = {}
        self._width = 1

    def add(self, position: int, codes: AnyArray) -> bool:
        """Take photographs (e, h, w, 3) of a position, shortest exposure first; say whether they show a highlight."""
        column = highlight_column(codes, self._session.camera.bit_depth)
        self._width = codes.shape[2]
        if column is not None:
            self._columns[position] = column
        return column is not None

    def findings(self) -> tuple[SessionFinding, ...]:
        """Return the positions that are out of order; each is left out."""
        angles = {k: self._session.positions[k].angle_deg for k in self._columns}
        order = sorted((k for k in angles if abs(angles[k]) <= _MOST_DEG), key=lambda k: angles[k])
        if len(order) < _LEAST_POSITIONS:
            return ()
        columns = [self._columns[k] for k in order]
        slack = _SLACK * self._width
        rising, falling = _longest_rise(columns, slack), _longest_rise([-c for c in columns], slack)
        # Where the lamp moves by less than the slack at a time, a rise passes for a fall step by step.
        fell = columns[falling[0]] - columns[falling[-1]] > 2.0 * slack
        if fell and len(falling) > len(rising) and len(falling) > 0.6 * len(order):
            reason = (
                "and the others show the highlight go to the left as the angles grow: they are mirrored, "
                "or the angles have the wrong sign"
            )
            return (self._finding("fatal", order[0], reason),)
        found = []
        for at in sorted(set(range(len(order))) - set(rising)):
            reason = f"shows the highlight at column {columns[at]:.0f}, {self._between(at, order, columns, rising)}"
            reason += ": does it belong to another position?"
            found.append(self._finding("position", order[at], reason))
        return tuple(found)

    def _between(self, at: int, order: list[int], columns: list[float], rising: list[int]) -> str:
        """Describe where this highlight would fit, in angles."""
        angles = [self._session.positions[order[i]].angle_deg for i in rising]
        place = bisect.bisect([columns[i] for i in rising], columns[at])
        if place == 0:
            return f"before that of {angles[0]:g}°"
        if place == len(angles):
            return f"beyond that of {angles[-1]:g}°"
        return f"between those of {angles[place - 1]:g}° and {angles[place]:g}°"

    def _finding(self, severity: Severity, position: int, reason: str) -> SessionFinding:
        path = str(self._folder / self._session.positions[position].photographs[0])
        where = f"positions[{position}]"
        return SessionFinding(severity, path, reason, where, position if severity == "position" else None)


def check_positions(
    folder: PathLike,
    session: Session,
    leave_out: Collection[tuple[int, int]] = (),
    progress: Progress | None = None,
) -> tuple[SessionFinding, ...]:
    """Return which positions of a folder are out of order.

    Of each position only the shortest exposures are unpacked, until one shows a highlight; those in ``leave_out``,
    (position, exposure), and those that cannot be read, are skipped.
    """
    order = PositionOrder(session, folder)
    for k, position in enumerate(session.positions):
        report(progress, k / len(session.positions), f"position {k + 1:,} of {len(session.positions):,}")
        for exposure, name in enumerate(position.photographs):
            if (k, exposure) in leave_out:
                continue
            with contextlib.suppress(FileError):  # reported where files are checked
                if order.add(k, read_photograph(Path(folder) / name).codes[None]):
                    break
    return order.findings()


def highlight_column(codes: AnyArray, bit_depth: int) -> float | None:
    """Return the column of the brightest part, in the shortest exposure that shows one; None where none does."""
    full = 1.0 if codes.dtype.kind == "f" else float((1 << bit_depth) - 1)
    for picture in codes:
        brightness = picture.max(axis=-1).astype(float)
        # Most of a row through the whole picture is background.
        black = float(np.percentile(brightness, 10.0))
        top = float(brightness.max())
        if codes.dtype.kind != "f" and top - black < _LEAST_LIGHT * full:
            continue
        if top <= black:
            continue
        # A hot pixel is alone, a highlight is not: a mean of three columns and rows keeps it below.
        smooth = uniform_filter(brightness - black, 3, mode="nearest")
        bright = np.where(smooth >= _BRIGHT * smooth.max(), smooth, 0.0)
        return float((bright.sum(axis=0) * np.arange(bright.shape[1])).sum() / bright.sum())
    return None


def _longest_rise(values: list[float], slack: float) -> list[int]:
    """Return the indices of a longest part that never falls by more than ``slack`` from one to the next."""
    best = [1] * len(values)
    before = [-1] * len(values)
    for i, value in enumerate(values):
        for k in range(i):
            if values[k] <= value + slack and best[k] + 1 > best[i]:
                best[i], before[i] = best[k] + 1, k
    at = int(np.argmax(best))
    chain = []
    while at >= 0:
        chain.append(at)
        at = before[at]
    return chain[::-1]


def check_session(
    folder: PathLike, session: Session, progress: Progress | None = None, *, pictures: bool = True
) -> tuple[SessionFinding, ...]:
    """Return what is wrong with the files of a session; nothing is raised but :class:`Cancelled`.

    A position without any usable photograph is reported, and a folder without any position is fatal. ``pictures``:
    whether photographs are unpacked to check the order of the positions.
    """
    check = _Check(Path(folder), session)
    check.read_headers(subrange(progress, 0.0, 0.5) if pictures else progress)
    check.sizes()
    check.depths()
    check.floats()
    check.calibrations()
    check.times()
    check.curve()
    if pictures:
        found = [(finding.position, finding.exposure) for finding in check.findings]
        lost = {(k, exposure) for k, exposure in found if k is not None and exposure is not None}
        check.findings += check_positions(folder, session, lost, subrange(progress, 0.5, 1.0))
    check.summarize()
    report(progress, 1.0, "checked")
    return tuple(check.findings)


def _indices(place: str) -> tuple[int | None, int | None]:
    found = re.fullmatch(r"positions\[(\d+)\]\.(?:photographs\[(\d+)\]|mask)", place)
    if found is None:
        return None, None
    return int(found[1]), None if found[2] is None else int(found[2])


def _severity_of_loss(place: str) -> Severity:
    """Return the extent of a loss at a file: a photograph alone, its position, a minor part, or everything."""
    if place.endswith("].mask"):
        return "position"
    if place == "mask":
        return "fatal"
    return "exposure" if place.startswith("positions[") else "warning"


class _Check:
    """The files read so far, by their places in the session, and what was found wrong."""

    def __init__(self, folder: Path, session: Session) -> None:
        self.folder = folder
        self.session = session
        self.names: dict[str, str] = {}
        self.facts: dict[str, PhotographFacts] = {}
        self.findings: list[SessionFinding] = []

    def add(self, severity: Severity, place: str, reason: str) -> None:
        path = str(self.folder / self.names[place])
        self.findings.append(SessionFinding(severity, path, reason, place, *_indices(place)))

    def leave_out(self, place: str, reason: str) -> None:
        self.add(_severity_of_loss(place), place, reason)
        del self.facts[place]

    def read_headers(self, progress: Progress | None) -> None:
        files = self.session.files()
        if self.session.mask is None and is_file(self.folder / MASK_FILE):
            files += (("mask", MASK_FILE),)
        self.names = dict(files)
        for i, (place, name) in enumerate(files):
            if i % 16 == 0:
                report(progress, i / len(files), f"file {i + 1:,} of {len(files):,}")
            try:
                self.facts[place] = photograph_facts(self.folder / name)
            except FileError as error:
                self.add(_severity_of_loss(place), place, error.reason)

    def sizes(self) -> None:
        """Check that all photographs of the sphere, and those compared pixel by pixel, have one size."""
        compared = {k: facts for k, facts in self.facts.items() if not k.startswith("camera.board")}
        sizes = Counter((facts.width, facts.height) for facts in compared.values())
        if len(sizes) < 2:
            return
        (width, height), _ = sizes.most_common(1)[0]
        for place, facts in compared.items():
            if (facts.width, facts.height) != (width, height):
                size = f"{facts.width} × {facts.height}"
                self.leave_out(place, f"is {size} pixels, and the others are {width} × {height}")

    def depths(self) -> None:
        bits = self.session.camera.bit_depth
        for place, facts in list(self.facts.items()):
            if facts.bits is not None and facts.bits < bits and not place.endswith("mask"):
                stated = f"session.json says {bits}; correct camera.bit_depth"
                self.leave_out(place, f"has {facts.bits} bits a channel, and {stated}")

    def floats(self) -> None:
        """Check for mixed units: floats and codes differ, so files unlike most positions are left out."""
        kinds = {
            place: facts.bits is None
            for place, facts in self.facts.items()
            if not place.endswith("mask") and not place.startswith("camera.board")
        }
        counts = Counter(kind for place, kind in kinds.items() if place.startswith("positions["))
        if not counts:
            return
        (most, _), *_ = counts.most_common(1)
        for place, floats in kinds.items():
            if floats != most:
                own, others = ("floats", "whole codes") if floats else ("whole codes", "floats")
                self.leave_out(
                    place, f"holds {own}, and the other photographs hold {others}, in another unit"
                )
        if most and "dark[0]" in self.facts:
            self.add("warning", "dark[0]", "is not taken off: of floats black is taken to be 0")

    def calibrations(self) -> None:
        """Check that the calibration files named in session.json exist, at least in part, and are suitable."""
        session = self.session
        fields = {
            "dark": session.dark,
            "white": session.white.photographs if session.white else (),
            "flat_field": session.flat_field.photographs if session.flat_field else (),
            "camera.board": session.camera.board.photographs if session.camera.board else (),
        }
        for name, files in fields.items():
            start = f"{name}[" if name == "dark" else f"{name}.photographs["
            if not files or any(place.startswith(start) for place in self.facts):
                continue
            own = [finding for finding in self.findings if finding.place.startswith(start)]
            self.findings = [finding for finding in self.findings if finding not in own]
            reason = (
                f"{own[0].reason}; none of the {len(files)} photographs of {name} can be used: "
                f"bring them, or take {name} out of session.json"
            )
            self.add("fatal", own[0].place, reason)
        white = next((place for place in self.facts if place.startswith("white.")), None)
        if session.white is not None and white is not None:
            left, top, width, height = session.white.region
            facts = self.facts[white]
            if left + width > facts.width or top + height > facts.height:
                reason = (
                    f"has {facts.width} × {facts.height} pixels, and the region {left}, {top}, {width}, {height} "
                    "(left, top, width, height) goes beyond them"
                )
                path = str(self.folder / self.names[white])
                self.findings.append(SessionFinding("fatal", path, reason, "white.region"))

    def times(self) -> None:
        """Compare EXIF with the session: nominal times may differ a little, another exposure's time may not."""
        every = self.session.exposures_s
        for place, facts in list(self.facts.items()):
            position, exposure = _indices(place)
            if exposure is None and place.startswith("dark["):
                exposure = int(place[5:-1])
            if exposure is None or facts.exposure_s is None:
                continue
            stated, recorded = every[exposure], facts.exposure_s
            off = [abs(math.log(recorded / time)) for time in every]
            other = off.index(min(off))
            if off[exposure] <= math.log1p(_SAME_TIME) and other == exposure:
                continue
            reason = f"was exposed for {recorded:g} s as its EXIF says, and session.json says {stated:g} s"
            if other != exposure and off[other] <= _OTHER_TIME:
                reason += f"; that is the time of exposure {other}, so that files may have been exchanged"
            else:
                reason += "; correct exposures_s"
            self.add("exposure" if position is not None else "warning", place, reason)

    def curve(self) -> None:
        """Check the curve: a JPEG picture is never linear, so its curve must be stated or recovered."""
        jpegs = [
            place
            for place, facts in self.facts.items()
            if facts.kind == "jpeg" and place.startswith("positions[") and not place.endswith("mask")
        ]
        if not jpegs:
            return
        response, count = self.session.camera.response, len(self.session.exposures_s)
        if response == "linear":
            reason = (
                "is a JPEG, whose codes are never linear; set camera.response to unknown, or write linear TIFF from "
                "the raw files"
            )
            self.add("fatal", jpegs[0], reason)
        elif response == "unknown" and count < LEAST_EXPOSURES:
            reason = (
                f"is a JPEG with an unknown curve, and {count} exposures do not determine it; "
                f"take {LEAST_EXPOSURES} or more, or set camera.response to srgb where the camera applies just that"
            )
            self.add("fatal", jpegs[0], reason)
        elif response == "unknown":
            reason = (
                "is a JPEG with an unknown curve: it is recovered from the exposures, to 8 bits, and holds only if "
                "the camera treated all photographs alike (no automatic contrast)"
            )
            self.add("warning", jpegs[0], reason)

    def summarize(self) -> None:
        """Report a position that is lost as a whole once instead of each of its photographs."""
        reasons = {(f.position, f.exposure): f.reason for f in self.findings if f.severity == "exposure"}
        lost = {f.position for f in self.findings if f.severity == "position"}
        for i, position in enumerate(self.session.positions):
            count = len(position.photographs)
            if i in lost or not all((i, k) in reasons for k in range(count)):
                continue
            lost.add(i)
            path = str(self.folder / position.photographs[0])
            reason = (
                f"{reasons[i, 0]}; none of the {count} photographs at {position.angle_deg:g}° can be used"
            )
            self.findings = [f for f in self.findings if (f.severity, f.position) != ("exposure", i)]
            self.findings.append(SessionFinding("position", path, reason, f"positions[{i}]", i))
        if len(lost) == len(self.session.positions):
            reason = "none of its photographs can be used; see the files named before"
            self.findings.append(SessionFinding("fatal", str(self.folder), reason))
