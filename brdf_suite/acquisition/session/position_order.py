"""Check of the order of the lamp's positions, from the brightest part of the sphere in each photograph.

As the lamp goes from before the camera (0°) to the right and behind the sphere (180°), the highlight wanders from the
middle to the right and never back. A position whose highlight lies elsewhere shows another lamp than is stated.
"""

from __future__ import annotations

import bisect
import contextlib
from collections.abc import Collection
from pathlib import Path

import numpy as np

from brdf_suite.acquisition.photographs.reading import read_photograph
from brdf_suite.acquisition.session.finding import SessionFinding, Severity
from brdf_suite.acquisition.session.session import Session
from brdf_suite.arrays import AnyArray
from brdf_suite.errors import FileError, PathLike
from brdf_suite.progress import Progress, report

_LEAST_LIGHT = 0.03
"""Of the scale of codes above black, for a highlight to count as seen."""
_BRIGHT = 0.5
_SLACK = 0.012
"""Of the picture's width: how far a highlight may lie back by noise and by the size of pixels."""
_LEAST_POSITIONS = 4
_MOST_DEG = 160.0


class PositionOrder:
    """Check of the order of positions by the highlight's column at each.

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
        smooth = _of_three(_of_three(brightness - black).T).T
        bright = np.where(smooth >= _BRIGHT * smooth.max(), smooth, 0.0)
        return float((bright.sum(axis=0) * np.arange(bright.shape[1])).sum() / bright.sum())
    return None


def _of_three(values: AnyArray) -> AnyArray:
    padded = np.pad(values, ((0, 0), (1, 1)), mode="edge")
    mean: AnyArray = (padded[:, :-2] + padded[:, 1:-1] + padded[:, 2:]) / 3.0
    return mean


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
