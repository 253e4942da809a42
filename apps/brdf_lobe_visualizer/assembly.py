"""Puts Lobe Visualizer together: window, desk, parts."""

from __future__ import annotations

from brdf_qt.message_bar import message_of
from PySide6.QtCore import QCoreApplication

from brdf_lobe_visualizer.desk import Desk
from brdf_lobe_visualizer.parts import build_parts
from brdf_lobe_visualizer.subjects import Subject
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.scene import default_paint
from brdf_suite.reflectance.build import build_paint


class LobeVisualizer:
    """The program's parts, joined; ``window`` is not yet shown."""

    def __init__(self) -> None:
        self.window = LobeWindow()
        self.desk = Desk(self.window, self.window)
        self.parts = build_parts(self.desk, self.window)
        self.window.add_quit()
        self.window.complete()
        self._closed = False
        app = QCoreApplication.instance()
        if app is not None:
            app.aboutToQuit.connect(self.close)

    @property
    def is_complete(self) -> bool:
        """Whether all that follows by itself is there: files, fits, figures, pictures."""
        return not self.desk.tasks.busy and all(getattr(part, "is_complete", True) for part in self.parts)

    def start(self) -> None:
        """Show the default paint where nothing else was asked for."""
        if not self.desk.subjects:
            try:
                paint = default_paint()
                self.desk.add(Subject("default", paint.name, build_paint(paint), paint=paint))
            except SuiteError as error:
                self.window.show_message(message_of(error, "open"))

    def close(self) -> None:
        """End what runs."""
        if self._closed:
            return
        self._closed = True
        for part in self.parts:
            close = getattr(part, "close", None)
            if close is not None:
                close()
        self.desk.tasks.stop()
