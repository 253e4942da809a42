"""Where the photographs of a reconstruction come from: a session's folder, or anything that gives the same."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Protocol

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.photographs.reading import read_photograph
from brdf_suite.acquisition.session.check import check_session
from brdf_suite.acquisition.session.finding import SessionFinding, exposures_lost
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
from brdf_suite.progress import Progress

_PIECE = 1 << 20


@dataclass(frozen=True, eq=False)
class Stack:
    """One series of exposures.

    Attributes
    ----------
    codes
        (exposures, rows, columns, 3) uint8, uint16, or float32 for photographs that are linear already.
    exposures_s
        (exposures,) seconds.
    names
        (exposures,) the files, as the session names them.
    findings
        What is wrong with photographs that were left out, each a sentence's clause that names its file.
    """

    codes: AnyArray
    exposures_s: npt.NDArray[np.float64]
    names: tuple[str, ...]
    findings: tuple[str, ...] = ()

    def without(self, names: set[str]) -> Stack:
        """Return the stack without the photographs of these names."""
        kept = [i for i, name in enumerate(self.names) if name not in names]
        return replace(
            self,
            codes=self.codes[kept],
            exposures_s=self.exposures_s[kept],
            names=tuple(self.names[i] for i in kept),
        )


class PhotographSource(Protocol):
    """Photographs of one session."""

    @property
    def session(self) -> Session:
        """Return what the photographs show."""
        ...

    def position(self, k: int) -> Stack:
        """Return the photographs of position ``k``; raises :class:`FileError` where there are none."""
        ...

    def series(self, kind: SeriesKind) -> Stack | None:
        """Return the dark, white or flat-field photographs; None where the session has none."""
        ...

    def board(self) -> list[tuple[str, AnyArray]]:
        """Return names and grey pictures (rows, columns) of the calibration board."""
        ...

    def mask(self, k: int | None) -> Bools | None:
        """Return which pixels (rows, columns) may be used, at one position or at all; None: all of them."""
        ...

    def digest(self, k: int | None) -> str:
        """Return a hash of what position ``k`` holds; of None: the session and all that belongs to no position."""
        ...

    def findings(self, progress: Progress | None) -> tuple[SessionFinding, ...]:
        """Return what is wrong with the files, without decoding them."""
        ...


@dataclass(frozen=True)
class FolderSource:
    """The photographs in a session's folder."""

    folder: Path
    session: Session

    @cached_property
    def _checked(self) -> tuple[SessionFinding, ...]:
        return self.findings(None)

    def position(self, k: int) -> Stack:
        """Read one position; photographs that cannot be read or contradict the session are skipped and reported."""
        for finding in self._checked:
            if finding.severity == "position" and finding.position == k:
                raise finding.error()
        lost = exposures_lost(self._checked, k)
        found = read_position(self.folder, self.session, k, leave_out=lost)
        skipped = [one for one in self._checked if one.position == k and one.severity == "exposure"]
        return _stack(found, skipped)

    def series(self, kind: SeriesKind) -> Stack | None:
        """Read a calibration series."""
        found = read_calibration(self.folder, self.session, kind)
        return None if found is None else _stack(found, [])

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
            found.update(f"\0{name}\0".encode())
            try:
                with (self.folder / name).open("rb") as stream:
                    while piece := stream.read(_PIECE):
                        found.update(piece)
            except OSError:
                # A file that is missing now and there later changes the hash, which is all that is asked here.
                found.update(b"missing")
        return found.hexdigest()

    def findings(self, progress: Progress | None) -> tuple[SessionFinding, ...]:
        """Check the folder."""
        found = check_session(self.folder, self.session, progress)
        # What is read afterwards goes by it, without another look at every file.
        self.__dict__["_checked"] = found
        return found


def _stack(found: PhotographSeries, skipped: list[SessionFinding]) -> Stack:
    findings = tuple(f"{one.path}: {one.reason}" for one in (*skipped, *found.findings))
    return Stack(found.codes, np.asarray(found.exposures_s, float), found.names, findings)
