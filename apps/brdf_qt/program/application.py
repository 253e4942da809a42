"""Start of a program: the surface format, the application object, the theme, errors and signals.

No error of ours ends a program or hides in a console: it is written to a log beside the settings and shown in
the window through :class:`ErrorRelay`.
"""

from __future__ import annotations

import atexit
import ctypes
import logging
import os
import signal
import socket
import sys
import time
from functools import cache
from pathlib import Path
from types import TracebackType
from typing import Any

from PySide6.QtCore import (
    QEvent,
    QMessageLogContext,
    QObject,
    QSocketNotifier,
    Qt,
    QTimer,
    QtMsgType,
    Signal,
    qInstallMessageHandler,
)
from PySide6.QtGui import QColorSpace, QFileOpenEvent, QFont, QGuiApplication, QIcon, QSurfaceFormat
from PySide6.QtWidgets import QApplication

from brdf_qt.program import theme, translation
from brdf_qt.program.diagnostics import start_log
from brdf_qt.program.settings import ORGANISATION
from brdf_qt.program.suite import MEMBERS
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import end_all_tasks
from brdf_suite.errors import Cancelled
from brdf_suite.foreign_text import make_visible
from brdf_suite.resources import resource
from brdf_suite.screen import screen_missing

log = logging.getLogger("brdf_qt")
_STARTED = time.monotonic()
_SCALE = "QT_SCALE_FACTOR"


class ErrorRelay(QObject):
    """Carries errors from wherever they happen to the window that shows them."""

    reported = Signal(Message)

    def report(self, error: BaseException, key: str = "fault") -> None:
        """Log ``error`` with its traceback and hand its message on; from any thread."""
        log.error("%s", error, exc_info=(type(error), error, error.__traceback__))
        self.reported.emit(message_of(error, key))


@cache
def error_relay() -> ErrorRelay:
    """Return the relay of this process."""
    return ErrorRelay()


class SuiteApplication(QApplication):
    """The application object; ``file_opened(Path)`` when macOS opens a file with the program that runs."""

    file_opened = Signal(Path)

    def event(self, event: QEvent) -> bool:
        """Take the files that are opened."""
        if isinstance(event, QFileOpenEvent) and event.file():
            self.file_opened.emit(Path(event.file()))
            return True
        return super().event(event)


def declared_colour_space(platform: str) -> QColorSpace:
    """Return what windows are declared to be in on a platform that manages colour; of others an invalid one."""
    if platform == "cocoa" or platform.startswith("wayland"):
        return QColorSpace(QColorSpace.NamedColorSpace.SRgb)
    return QColorSpace()


def surface_format(samples: int = 4) -> QSurfaceFormat:
    """Return OpenGL 3.3 core with ``samples`` per pixel, what every GL surface of the suite uses.

    Where the window system manages colour (macOS, Wayland), it declares sRGB; which one it is is not known before the
    application object.
    """
    form = QSurfaceFormat()
    form.setVersion(3, 3)
    form.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    form.setSamples(samples)
    form.setDepthBufferSize(24)
    form.setSwapInterval(1)
    # So that a reset of the driver is reported, instead of frames that stay black.
    form.setOption(QSurfaceFormat.FormatOption.ResetNotification)
    form.setColorSpace(declared_colour_space(QGuiApplication.platformName()))
    return form


def create_application(
    name: str, argv: list[str] | None = None, theme_name: str | None = None, language: str | None = None
) -> SuiteApplication:
    """Make the application object of program ``name`` ("Designer"), with theme, language, log and error handling.

    ``theme_name`` and ``language`` (ISO 639 code) override what is remembered for this run only. Call once, before
    any widget.
    """
    missing = screen_missing()
    if missing is not None:
        sys.exit(f"{name} cannot open a window: {missing}. `brdf-suite render` needs none.")
    _check_scale()
    QSurfaceFormat.setDefaultFormat(surface_format())
    QGuiApplication.setHighDpiScaleFactorRoundingPolicy(Qt.HighDpiScaleFactorRoundingPolicy.PassThrough)
    app = SuiteApplication([name, *(argv or [])])
    QSurfaceFormat.setDefaultFormat(surface_format())  # with the colours of the platform, which is known now
    app.setOrganizationName(ORGANISATION)
    app.setApplicationName(name)
    app.setApplicationDisplayName(f"BRDF Suite {name}")
    command = next((one.command for one in MEMBERS.values() if one.name == name), "brdf-suite")
    app.setDesktopFileName(command)
    app.setWindowIcon(QIcon(str(resource("icons/suite", f"{command}.png"))))
    app.setStyle("Fusion")
    font = app.font()
    font.setFeature(QFont.Tag("tnum"), 1)  # digits of equal width: a number does not jump while it changes
    app.setFont(font)
    theme.apply(app, theme_name or theme.current(), remember=False)
    theme.follow_changes(app)
    translation.install(app, language)
    start_log(name)
    sys.excepthook = _unhandled
    qInstallMessageHandler(_qt_message)
    # Libraries of Qt also report when they are unloaded, after the interpreter has ended: the process would die of it.
    atexit.register(qInstallMessageHandler, None)
    _quit_on_signals(app)
    _end_with_x_server()
    return app


def end_application(status: int, patience_ms: int = 30_000) -> int:
    """End what would use Qt's objects while they are destroyed, after the event loop; return ``status``.

    Documents are closed or kept by then: from here on a signal ends the process at once, and so does work in the
    background that does not end in time.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)
    signal.set_wakeup_fd(-1)
    if QGuiApplication.platformName() == "offscreen":
        # Its clipboard outlives the interpreter, and would then have to destroy what Python has made.
        QGuiApplication.clipboard().clear()
    if not end_all_tasks(patience_ms):
        log.warning("Work in the background does not end; the program ends without it.")
        os._exit(status)
    return status


def _check_scale() -> None:
    """Ignore a scale of the user's by which nothing can be drawn: with one below zero no window would ever be shown."""
    text = os.environ.get(_SCALE)
    try:
        good = text is None or 0.0 < float(text) < 100.0
    except ValueError:
        good = False
    if not good:
        log.warning("%s is %.40r, which is no scale; it is ignored.", _SCALE, text)
        del os.environ[_SCALE]


def process_age_s() -> float:
    """Return the seconds since the system started this process; off Linux, since this module was imported."""
    stat = Path("/proc/self/stat")
    if stat.exists():
        ticks = int(stat.read_text().rpartition(")")[2].split()[19])
        return time.clock_gettime(time.CLOCK_BOOTTIME) - ticks / os.sysconf("SC_CLK_TCK")
    return time.monotonic() - _STARTED


def _unhandled(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
    if issubclass(kind, KeyboardInterrupt):
        QApplication.exit(0)
    elif not issubclass(kind, Cancelled):
        sys.__excepthook__(kind, error, trace)
        error_relay().report(error)


_LEVELS = {
    QtMsgType.QtDebugMsg: logging.DEBUG,
    QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING,
    QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}


def _qt_message(kind: QtMsgType, context: QMessageLogContext, text: str) -> None:
    logging.getLogger("qt").log(_LEVELS[kind], "%s: %s", context.category or "default", text)
    if kind in (QtMsgType.QtCriticalMsg, QtMsgType.QtFatalMsg):
        sys.stderr.write(f"{make_visible(text)}\n")


def _quit_on_signals(app: QApplication) -> None:
    """End the event loop on Ctrl+C and on SIGTERM; unsaved work stays in the autosave and is offered again.

    A Python handler runs only when the interpreter does, and Qt's loop sleeps in C++. The wake-up descriptor
    makes the loop stir at once, without a timer that polls.
    """
    reader, writer = socket.socketpair()
    reader.setblocking(False)
    writer.setblocking(False)
    notifier = QSocketNotifier(reader.fileno(), QSocketNotifier.Type.Read, app)
    notifier.activated.connect(lambda: reader.recv(64))
    signal.set_wakeup_fd(writer.fileno(), warn_on_full_buffer=False)
    for number in (signal.SIGINT, signal.SIGTERM):
        # Queued, so that a signal that comes before the event loop ends it as soon as it runs.
        signal.signal(number, lambda *_: QTimer.singleShot(0, app, lambda: app.exit(0)))
    app.setProperty("signal_sockets", (reader, writer))


def _end_with_x_server() -> None:
    """End the process at once where Xlib finds that the server is gone; unsaved work stays in the autosave.

    Xlib would call ``exit`` of C, which destroys what threads still use: the process breaks down, or never ends.
    """
    if QGuiApplication.platformName() != "xcb":
        return
    try:
        x11 = ctypes.CDLL("libX11.so.6")  # by its own name, as Qt's plug-in has loaded it
    except OSError:
        return
    x11.XSetIOErrorHandler(_x_server_gone())


@cache
def _x_server_gone() -> Any:
    def end(_display: int) -> None:
        try:
            os.write(2, b"The connection to the X server broke.\n")
        finally:
            os._exit(1)

    return ctypes.CFUNCTYPE(None, ctypes.c_void_p)(end)
