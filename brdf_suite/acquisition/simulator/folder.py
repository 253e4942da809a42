"""Writing of a simulated session as a regular session folder, with the ground truth beside it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from brdf_suite.acquisition.session.session import SESSION_FILE, Session
from brdf_suite.acquisition.session.store import write_session
from brdf_suite.acquisition.simulator.description import TRUTH_FILE
from brdf_suite.acquisition.simulator.rig import Simulator
from brdf_suite.acquisition.simulator.settings import SimulatorSettings
from brdf_suite.acquisition.simulator.writing import write_photograph
from brdf_suite.arrays import Codes
from brdf_suite.documents.atomic import encode, write_atomically
from brdf_suite.errors import FileError
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.protocol import Reflectance


def simulate(
    reflectance: Reflectance,
    folder: str | os.PathLike[str],
    settings: SimulatorSettings | None = None,
    name: str = "paint",
    progress: Progress | None = None,
) -> Session:
    """Photograph a sphere and write session, photographs and ``truth.json`` into a new or empty folder.

    ``session.json`` comes last: a folder without one was not finished.

    Raises
    ------
    FileError
        The folder holds something, or cannot be written.
    """
    target = Path(folder)
    make_empty_folder(target)
    rig = Simulator(reflectance, settings, name)
    session = rig.session
    done, total = 0, len(session.files())
    for files, exposures_s, codes in _series(rig):
        for file, seconds, picture in zip(files, exposures_s, codes, strict=True):
            report(progress, done / total, f"photograph {done + 1:,} of {total:,}")
            path = target / file
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise FileError(path.parent, f"cannot be made ({error.strerror})") from error
            write_photograph(path, picture, seconds)
            done += 1
    write_atomically(target / TRUTH_FILE, encode(rig.truth))
    write_session(session, target)
    report(progress, 1.0, "written")
    return session


def make_empty_folder(folder: Path) -> None:
    """Make the folder where there is none; refuse one that holds anything."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        occupied = any(folder.iterdir())
    except OSError as error:
        raise FileError(folder, f"cannot be made ({error.strerror})") from error
    if occupied:
        raise FileError(folder, f"is not empty; name a new folder for the photographs and {SESSION_FILE}")


def _series(rig: Simulator) -> Iterator[tuple[tuple[str, ...], tuple[float, ...], Codes]]:
    """Yield the names, times and codes (e, h, w, 3) of each series, made one after the other."""
    session = rig.session
    if session.dark:
        yield session.dark, session.exposures_s, rig.dark()
    if session.white is not None:
        yield session.white.photographs, session.exposures_s, rig.white()
    if session.flat_field is not None:
        yield session.flat_field.photographs, session.flat_field.exposures_s, rig.flat_field()
    if session.camera.board is not None:
        for i, file in enumerate(session.camera.board.photographs):
            yield (file,), (1.0,), rig.board(i)[None]
    for k, position in enumerate(session.positions):
        yield position.photographs, session.exposures_s, rig.position(k)
