"""Photographs of a simulated rig, taken as the reconstruction asks for them; nothing is written."""

from __future__ import annotations

import hashlib
from dataclasses import asdict
from functools import cached_property

import numpy as np

from brdf_suite.acquisition.session.finding import SessionFinding
from brdf_suite.acquisition.session.series import PhotographSeries, SeriesKind
from brdf_suite.acquisition.session.session import Session
from brdf_suite.acquisition.simulator import Simulator
from brdf_suite.arrays import AnyArray, Bools
from brdf_suite.progress import Progress


class SimulatorSource:
    """A source that gives what the folder of a simulated rig would."""

    def __init__(self, simulator: Simulator) -> None:
        self.simulator = simulator

    @cached_property
    def session(self) -> Session:
        """Return the session that the reconstruction gets."""
        return self.simulator.session

    def position(self, k: int) -> PhotographSeries:
        """Take the photographs of one position."""
        codes = self.simulator.position(k)
        return PhotographSeries(codes, self.session.exposures_s, self.session.positions[k].photographs)

    def series(self, kind: SeriesKind) -> PhotographSeries | None:
        """Take a calibration series."""
        session, every = self.session, self.session.exposures_s
        if kind == "dark":
            return PhotographSeries(self.simulator.dark(), every, session.dark) if session.dark else None
        if kind == "white":
            given = session.white
            return (
                None if given is None else PhotographSeries(self.simulator.white(), every, given.photographs)
            )
        flat = session.flat_field
        if flat is None:
            return None
        return PhotographSeries(self.simulator.flat_field(), flat.exposures_s or every, flat.photographs)

    def board(self) -> list[tuple[str, AnyArray]]:
        """Take the board's photographs."""
        board = self.session.camera.board
        names = () if board is None else board.photographs
        return [(name, np.ascontiguousarray(self.simulator.board(i)[..., 1])) for i, name in enumerate(names)]

    def mask(self, k: int | None) -> Bools | None:
        """Return None: every pixel may be used."""
        del k
        return None

    def digest(self, k: int | None) -> str:
        """Return a hash of the settings, which decide the photographs."""
        settings = repr(
            (self.simulator.name, repr(self.simulator.reflectance), asdict(self.simulator.settings), k)
        )
        return hashlib.sha256(settings.encode()).hexdigest()

    def findings(self, progress: Progress | None) -> tuple[SessionFinding, ...]:
        """Return nothing: no file can be wrong."""
        del progress
        return ()
