"""Joins the page of the mask to the session: read, corrected by hand, and kept as it is painted.

It is a picture beside the photographs: white is used, black left out.
"""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.timer import make_timer
from PIL import Image
from PySide6.QtCore import QObject

from brdf_designer.acquire.mask.page import MaskPage
from brdf_designer.acquire.plots.marks import Outline
from brdf_designer.acquire.plots.tone import Tones, tones_of_codes, tones_of_linear
from brdf_designer.acquire.reconstruction.session import ReconstructionSession
from brdf_suite.acquisition.session.session import Session
from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.arrays import Bools
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.progress import Progress
from brdf_suite.regular_files import exists

MASK_FILE = "mask.png"
_MOST_NAMES = 100
_PAUSE_MS = 700
_MOST_CLIPPED = 0.05


class MaskControl(QObject):
    """Shows a picture below the mask, and writes the mask when the hand pauses."""

    def __init__(self, bench: ReconstructionSession, page: MaskPage) -> None:
        super().__init__(bench)
        self._bench, self._page = bench, page
        self._fresh = True
        self._unwritten = False
        self._pause = make_timer(self, self.write_pending, _PAUSE_MS)
        self.undo, self.redo = page.picture.undo, page.picture.redo
        page.mask_edited.connect(self._edited)
        page.position_chosen.connect(self._show_position)
        bench.opened.connect(self._opened)
        bench.found.connect(self._found)
        bench.window.step_shown.connect(self._shown)

    def write_pending(self) -> None:
        """Write the mask where it is not written yet."""
        self._pause.stop()
        bench, history = self._bench, self._page.picture.history
        if not self._unwritten or history is None or bench.session is None or bench.folder is None:
            return
        try:
            session = write_session_mask(bench.folder, bench.session, history.used)
        except SuiteError as error:
            todo = tr("The mask is kept in this window. The next stroke saves it again.")
            bench.say(message_of(error, "mask", todo=todo))
            return
        self._unwritten = False
        bench.window.messages.dismiss("mask")
        bench.edit(session, forget=None)
        self._report()

    def _opened(self) -> None:
        self._pause.stop()
        self._fresh, self._unwritten = True, False
        session = self._bench.session
        angles = () if session is None else tuple(p.angle_deg for p in session.positions)
        self._page.show_positions(angles, len(angles) // 2)
        self._page.show_picture(None)
        self._bench.window.show_step("mask", "todo", "")
        if self._bench.window.step == "mask":
            self._shown("mask")

    def _shown(self, step: str) -> None:
        if step == "mask" and self._fresh and self._bench.session is not None:
            self._show_position(self._page.position.value())

    def _show_position(self, position: int) -> None:
        bench = self._bench
        if bench.session is not None and bench.folder is not None:
            request = (bench.folder, bench.session, position)
            bench.run("mask_picture", _read, request, self._read, beside=True)

    def _read(self, answer: tuple[Tones, Bools]) -> None:
        tones, used = answer
        self._page.show_picture(tones)
        if self._fresh:
            self._fresh = False
            self._page.show_mask(used)
            self._report()

    def _edited(self) -> None:
        self._unwritten = True
        self._bench.invalidate("table")
        self._pause.start()

    def _report(self) -> None:
        session = self._bench.session
        if session is None:
            return
        text = tr("Saved in the folder as {file}.").format(file=session.mask)
        if session.mask is None:
            text = tr("No pixels are excluded. The mask is saved in the folder as {file}.")
            text = text.format(file=MASK_FILE)
        self._page.kept.setText(text)
        self._bench.window.show_step("mask", "done", session.mask or tr("no pixels excluded"))

    def _found(self, key: str) -> None:
        """Draw the sphere's outline below the mask, as soon as it is known."""
        if key != "geometry":
            return
        found = self._bench.results.get("geometry")
        if found is None:
            self._page.picture.show_under()
            return
        around = np.asarray(found.found.geometry.outline(np.linspace(0.0, 2.0 * np.pi, 361)))
        self._page.picture.show_under(Outline(around + 0.5, tr("outline of the sphere"), dashed=True))


def _read(request: tuple[Path, Session, int], _progress: Progress) -> tuple[Tones, Bools]:
    """Read the exposure of a position that is neither clipped nor dark, whole, and the session's mask."""
    from brdf_suite.acquisition.photographs.reading import read_photograph
    from brdf_suite.acquisition.session.series import read_mask

    folder, session, position = request
    names = session.positions[position].photographs
    bits = session.camera.bit_depth
    best = None
    # The longest exposure of which little is clipped, tried from the middle up: as a rule two or three are read.
    for name in names[len(names) // 2 :]:
        found = read_photograph(folder / name)
        whole = found.facts.bits is not None
        clipped = whole and float((found.codes >= (1 << bits) - 1).any(axis=-1).mean()) > _MOST_CLIPPED
        if best is not None and clipped:
            break
        best = found
    assert best is not None
    codes = np.asarray(best.codes)
    tones = tones_of_linear(codes) if best.facts.bits is None else tones_of_codes(codes, bits)
    mask = read_mask(folder, session)
    if mask is None:
        return tones, np.ones(codes.shape[:2], bool)
    if mask.shape != codes.shape[:2]:
        raise FileError(
            folder / str(session.mask),
            f"has {mask.shape[1]}×{mask.shape[0]} pixels, the photographs {codes.shape[1]}×{codes.shape[0]}",
        )
    return tones, mask


def write_session_mask(folder: Path, session: Session, used: Bools) -> Session:
    """Write the mask into the folder and name it in session.json; return the session that names it.

    A mask of another name is left as it is, and so is a ``mask.png`` beside it that the session does not use.

    Raises
    ------
    FileError
        The folder cannot be written.
    """
    name = session.mask or MASK_FILE
    if name != MASK_FILE and not (name.startswith("mask_") and name.endswith(".png")):
        names = [MASK_FILE, *(f"mask_{number}.png" for number in range(2, _MOST_NAMES))]
        name = next((free for free in names if not exists(folder / free)), MASK_FILE)
    stream = io.BytesIO()
    Image.fromarray(np.where(used, 255, 0).astype(np.uint8)).save(stream, "png", optimize=True)
    write_atomically(folder / name, stream.getvalue())
    # Changes that other programs made meanwhile are kept: only the mask's name is changed.
    present = read_session(folder)
    if present.mask != name:
        present = replace(present, mask=name)
        write_session(present, folder)
    return present
