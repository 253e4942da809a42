"""Reads one position's photographs at a time, on a thread, for the pages that show them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from brdf_qt.program.translation import tr
from numpy.typing import NDArray
from PySide6.QtCore import QObject

from brdf_designer.acquire.exposures.page import ExposuresPage
from brdf_designer.acquire.plots.tone import LONGEST_SIDE, Tones, tones_of_codes, tones_of_linear
from brdf_designer.acquire.reconstruction.session import ReconstructionSession
from brdf_designer.acquire.session.control import SessionControl
from brdf_designer.acquire.states import Problem, Series, Shot
from brdf_suite.acquisition.photographs.exposure_faults import check_exposures
from brdf_suite.acquisition.session.session import Session
from brdf_suite.errors import FileError
from brdf_suite.progress import Progress, report

_KEPT = 2
"""Positions whose photographs stay in memory: 16 of a megapixel are about 110 MB."""

_BINS = 256
_JUDGED_PIXELS = 40_000
_NOISE_SHARE = 0.004
"""Codes within this share of the full scale above black are within the noise."""


class SeriesControl(QObject):
    """Joins the page of the exposures to the workbench; the session's page shows one of them."""

    def __init__(self, bench: ReconstructionSession, page: ExposuresPage, sessions: SessionControl) -> None:
        super().__init__(bench)
        self._bench, self._page, self._sessions = bench, page, sessions
        self._kept: dict[int, Series] = {}
        page.position_chosen.connect(self.show)
        bench.opened.connect(self._opened)

    def show(self, position: int) -> None:
        """Read a position's photographs, and show them; nothing is read twice."""
        bench = self._bench
        if bench.session is None or bench.folder is None:
            return
        if position in self._kept:
            bench.cancel("series")
            self._page.show_series(self._kept[position])
            return
        bench.run("series", _read_series, (bench.folder, bench.session, position), self._read, beside=True)

    def _opened(self) -> None:
        self._kept.clear()
        session = self._bench.session
        if session is None:
            self._page.show_positions((), 0)
            self._page.show_series(None)
            return
        angles = tuple(position.angle_deg for position in session.positions)
        # The position that stands for all: the highlight is on the sphere, and the flank is lit.
        first = min(range(len(angles)), key=lambda k: abs(angles[k] - 60.0))
        self._page.show_positions(angles, first)
        self.show(first)

    def _read(self, series: Series) -> None:
        self._kept[series.position] = series
        for old in list(self._kept)[:-_KEPT]:
            del self._kept[old]
        self._page.show_series(series)
        if len(self._kept) == 1:
            self._sessions.show_series(series)
        differing = self._page.differing
        text = tr("{count} times differ").format(count=differing) if differing else ""
        worst = bool(differing or series.problems)
        self._bench.window.show_step("exposures", "warning" if worst else "done", text)


def _read_series(request: tuple[Path, Session, int], progress: Progress) -> Series:
    """Read all photographs of a position: ``request`` has the folder, the session and the position's number.

    Files that cannot be read, and photographs that contradict each other (exchanged, saturated everywhere), are
    reported as problems; a position without any gives an empty series.
    """
    from brdf_suite.acquisition.photographs.reading import read_photograph

    folder, session, place = request
    position = session.positions[place]
    shots: list[Shot] = []
    problems: list[Problem] = []
    black: float | None = None
    judged: list[NDArray[np.generic]] = []
    for number, (name, time) in enumerate(zip(position.photographs, session.exposures_s, strict=True)):
        report(progress, number / len(position.photographs), name)
        try:
            found = read_photograph(folder / name)
        except FileError as error:
            problems.append(Problem("error", name, error.reason))
            continue
        # A file of 16 bits holds the 12 of its camera.
        bits = None if found.facts.bits is None else session.camera.bit_depth
        codes = np.asarray(found.codes)
        if black is None:
            # Most of the shortest exposure is black, whatever pedestal the camera adds.
            black = float(np.percentile(codes, 5.0))
        shots.append(_shot(codes, bits, time, found.facts.exposure_s, name, black))
        step = max(1, round((codes.shape[0] * codes.shape[1] / _JUDGED_PIXELS) ** 0.5))
        judged.append(codes[::step, ::step])
    if len({codes.shape for codes in judged}) == 1:
        times, names = [shot.exposure_s for shot in shots], [shot.file for shot in shots]
        found_wrong = check_exposures(np.stack(judged), times, names, session.camera.bit_depth)
        problems += [Problem("error", finding.path, finding.reason) for finding in found_wrong]
    return Series(place, position.angle_deg, tuple(shots), tuple(problems))


def _shot(
    codes: NDArray[np.floating | np.integer],
    bits: int | None,
    time: float,
    exif: float | None,
    name: str,
    black: float,
) -> Shot:
    top = float((1 << bits) - 1) if bits else float(np.nanmax(codes, initial=1.0))
    clipped = np.asarray((codes >= top).any(axis=-1)) if bits else np.zeros(codes.shape[:2], bool)
    low = black + _NOISE_SHARE * top
    dark = float(np.asarray((codes <= low).all(axis=-1)).mean())
    edges = np.linspace(0.0, top + 1.0 if bits else top, _BINS + 1)
    counts = np.stack([np.histogram(codes[..., channel], edges)[0] for channel in range(codes.shape[-1])])
    grey = (
        codes.shape[-1] == 3 and np.array_equal(counts[0], counts[1]) and np.array_equal(counts[0], counts[2])
    )
    step = max(1, -(-max(codes.shape[:2]) // LONGEST_SIDE))
    shown = codes[::step, ::step]
    tones: Tones = (
        tones_of_codes(shown.astype(np.uint16), bits)
        if bits
        else tones_of_linear(shown.astype(np.float32), top)
    )
    return Shot(
        float(time),
        None if exif is None else float(exif),
        name,
        tones,
        float(clipped.mean()),
        dark,
        clipped[::step, ::step],
        (counts[:1] if grey else counts).astype(float),
        edges,
        top,
    )
