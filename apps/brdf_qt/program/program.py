"""What the four programs are: a window, a session, and features that are started and ended together."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from PySide6.QtCore import QCoreApplication, QObject, Qt, Signal

from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import tr
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.message_bar import Message
from brdf_suite.plugins import on_problem

SomeFeature = TypeVar("SomeFeature", bound=Feature)


class Program(QObject):
    """A program; its window is not yet shown. A subclass makes window, session and features, and joins them.

    Signals
    -------
    reached(milestone)
        ``ready``: the window is painted; ``complete``: what the start shows is there. A program may have others.
        ``--report-startup`` prints when each was reached, as ``ready_s``.
    start_failed(text)
        What was asked for cannot be shown: a run without a user ends.
    """

    reached = Signal(str)
    start_failed = Signal(str)
    patience_s = 180.0
    """A picture of the window is taken without what has not come by then."""
    is_complete_when_started = True
    """Whether the start shows all that it is to show at once; otherwise the program reports ``complete`` itself."""
    window: SuiteWindow
    _plugin_failed = Signal(str)

    def __init__(self, window: SuiteWindow, features: Sequence[Feature] = ()) -> None:
        super().__init__(window)
        self.window = window
        self.features = list(features)
        self._awaits_paint = self.closed = False
        # Plug-ins are loaded and used on any thread.
        self._plugin_failed.connect(self._show_plugin, Qt.ConnectionType.QueuedConnection)
        self._forget_plugins = on_problem(self._plugin_failed.emit)
        app = QCoreApplication.instance()
        if app is not None:
            app.aboutToQuit.connect(self.close)

    @property
    def is_idle(self) -> bool:
        """Whether all that follows by itself is there, and no work is pending."""
        return all(feature.is_idle for feature in self.features)

    def feature(self, kind: type[SomeFeature]) -> SomeFeature:
        return next(feature for feature in self.features if isinstance(feature, kind))

    def start_when_painted(self) -> None:
        """Call :meth:`start` once the window is painted; another call does nothing."""
        if not self._awaits_paint:
            self._awaits_paint = True
            self.window.first_painted.connect(self._painted)

    def start(self) -> None:
        """Begin what can wait until the window is painted."""
        for feature in self.features:
            feature.start()

    def do(self, action: str) -> bool:
        """Do what a run without a user asks for: ``KEY=VALUE`` sets an option, another word is a command's key.

        False where no feature has the option, or there is no such command that is enabled.
        """
        key, found, value = action.partition("=")
        if found:
            return any(feature.run_script(key, value) for feature in self.features)
        command = self.window.command(key)
        if command is None or not command.isEnabled():
            return False
        command.trigger()
        return True

    def close(self) -> None:
        """End every feature, the last one first. The end of the application calls it too; only the first call acts."""
        if not self.closed:
            self.closed = True
            self._forget_plugins()
            for feature in reversed(self.features):
                feature.close()

    def _show_plugin(self, sentence: str) -> None:
        todo = tr("Everything else works without it. `brdf-suite list plugins` lists all.")
        self.window.show_message(Message(f"plug-in {sentence}", sentence, todo=todo, severity="warning"))

    def _painted(self) -> None:
        self.reached.emit("ready")
        self.start()
        if self.is_complete_when_started:
            self.reached.emit("complete")
