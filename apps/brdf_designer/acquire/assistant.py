"""The parts of the assistant, joined; and all steps one after the other."""

from __future__ import annotations

from PySide6.QtCore import QObject

from brdf_designer.acquire.exposures.control import SeriesControl
from brdf_designer.acquire.fit.control import FitControl
from brdf_designer.acquire.mask.control import MaskControl
from brdf_designer.acquire.reconstruction.control import ReconstructionController
from brdf_designer.acquire.reconstruction.session import ReconstructionSession, no_session
from brdf_designer.acquire.session.control import SessionControl, sample_folder
from brdf_designer.acquire.window import AcquireWindow
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow

CHAIN = ("response", "geometry", "table", "fit")


class Assistant(QObject):
    """The window, its state and its controls."""

    def __init__(self, paint_session: PaintSession, host: DesignerWindow) -> None:
        super().__init__(host)
        self.window = AcquireWindow(host)
        dialogs = paint_session.documents.dialogs.over(self.window)
        self.bench = ReconstructionSession(self.window, host.progress, self)
        self.sessions = SessionControl(self.bench, self.window.session, dialogs)
        self.series = SeriesControl(self.bench, self.window.exposures, self.sessions)
        self.mask = MaskControl(self.bench, self.window.mask_page)
        self.reconstruction = ReconstructionController(self.bench, dialogs)
        self.fit = FitControl(self.bench, self.window.fit, paint_session, dialogs)
        self._chain: list[str] = []
        self._tries = False
        """Whether the steps begin by themselves once the simulated photographs are open."""
        self.window.session.sample_requested.connect(self.try_sample)
        self.window.all_requested.connect(self.do_all)
        self.window.undo_requested.connect(lambda: self._step(back=True))
        self.window.redo_requested.connect(lambda: self._step(back=False))
        self.window.hidden.connect(self.write_pending)
        self.bench.ended.connect(self._ended)

    def do_all(self) -> None:
        """Do every step that is not done yet, and show the page of each."""
        if self.bench.session is None:
            self.bench.say(no_session())
            return
        self._chain = [key for key in CHAIN if key not in self.bench.results]
        if self._chain:
            self._next()
        else:
            self._offer()

    def try_sample(self) -> None:
        """Open photographs of a simulated rig and do every step with them; it ends with the paint that is offered."""
        self._tries = True
        self.sessions.open_sample()

    def write_pending(self) -> None:
        """Write what was typed or painted and is not yet written."""
        self.sessions.write_pending()
        self.mask.write_pending()

    def close(self) -> None:
        """Write what is not yet written, and end the threads."""
        self.write_pending()
        self._chain = []
        self.bench.close()

    def _next(self) -> None:
        if not self._chain:
            return
        self.write_pending()
        key = self._chain.pop(0)
        pages = {"table": "reconstruction"}
        self.window.show_page(pages.get(key, key))
        {
            "response": self.reconstruction.find_response,
            "geometry": self.reconstruction.find_geometry,
            "table": self.reconstruction.find_table,
            "fit": self.fit.find,
        }[key]()

    def _offer(self) -> None:
        """Show what came of the steps, with the keyboard where it is opened as a paint."""
        page = self.window.fit
        self.window.show_page("fit")
        if page.open.isEnabled():
            page.open.setFocus()
            page.side.bring_in_sight(page.result)

    def _ended(self, key: str, done: bool) -> None:
        if key in ("make", "open"):
            begins = self._tries and done and key == "open"
            self._tries = self._tries and done and not begins
            if begins and self.bench.folder == sample_folder():
                self.do_all()
        elif key in CHAIN and done and key == "fit" and not self._chain:
            self._offer()
        elif key in CHAIN and done:
            self._next()
        elif key in CHAIN:
            self._chain = []

    def _step(self, *, back: bool) -> None:
        """Undo or redo what belongs to the page that is shown."""
        owners: dict[str, MaskControl | SessionControl] = {"mask": self.mask, "session": self.sessions}
        owner = owners.get(self.window.step)
        if owner is not None:
            (owner.undo if back else owner.redo)()
