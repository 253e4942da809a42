"""What a program may say of itself: a log on this machine, and a text to be sent with a report of a fault.

Neither holds names or contents of files. The log has the texts of the program itself and numbers; what is filled into
them is left out, and of an error only its kind and the lines of the suite that it passed. Of what libraries and Qt say,
the log has who said it and how serious it is: their texts may be finished, with contents of a file. Nothing is ever
sent.
"""

from __future__ import annotations

import logging
import os
import platform
import re
from contextlib import suppress
from logging.handlers import RotatingFileHandler
from numbers import Number
from pathlib import Path
from traceback import extract_tb

from PySide6.QtCore import QSettings, qVersion
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext

from brdf_qt.program.settings import settings, state_folder
from brdf_suite import variables
from brdf_suite.errors import FileError
from brdf_suite.processes import OWN_PACKAGES, is_own_module
from brdf_suite.regular_files import read_bytes
from brdf_suite.release import __version__

_LOG_BYTES, _LOGS_KEPT = 1_000_000, 2
_LAST_LINES = 40
_GL_STRINGS = {"vendor": 0x1F00, "renderer": 0x1F01, "version": 0x1F02}
_PACKAGES = ("PySide6_Essentials", "moderngl", "numpy", "scipy", "OpenEXR", "pillow", "trimesh")
_NUMBER = re.compile(r"true|false|[-+]?\d{1,12}(?:\.\d{1,12})?")
_WORDS = ("theme", "language")
"""Settings of one of a few words."""


class PrivateFormatter(logging.Formatter):
    """Lines without what was filled into their texts, but for numbers: names and contents of files come so."""

    def format(self, record: logging.LogRecord) -> str:
        """Return the line of a record."""
        given = record.args if isinstance(record.args, tuple) else ()
        text = str(record.msg) if isinstance(record.msg, str) else type(record.msg).__name__
        with suppress(TypeError, ValueError):  # the text alone then has to do
            text = text % tuple(_shown(value) for value in given) if given else text
        if not is_own_module(record.name):
            text = "…"
        error = record.exc_info[1] if isinstance(record.exc_info, tuple) else None
        where = "" if error is None else f" ({describe_error(error)})"
        when = self.formatTime(record)
        return f"{when} {record.levelname} {record.name}: {' '.join(text.split())}{where}"


def _shown(value: object) -> object:
    if isinstance(value, Number):
        return value
    return type(value).__name__ if isinstance(value, BaseException) else "…"


def describe_error(error: BaseException) -> str:
    """Return the kind of an error, and the lines of the suite that it passed, the last one first; not its text."""
    steps = [
        f"{'/'.join(parts[place:])}:{step.lineno}"
        for step in reversed(extract_tb(error.__traceback__))
        for parts in [Path(step.filename).parts]
        for place in [next((k for k, part in enumerate(parts) if part in OWN_PACKAGES), None)]
        if place is not None
    ]
    return " < ".join([type(error).__name__, *steps])


class _Log(RotatingFileHandler):
    """A log file that never disturbs the program: where it cannot be written, it is left out."""

    def handleError(self, record: logging.LogRecord) -> None:
        """Leave the line out."""


def log_folder() -> Path:
    """Return the system's folder for logs of a program, or one beside its settings where these are in another place."""
    if os.environ.get(variables.SETTINGS):
        return state_folder("log")
    import platformdirs  # 20 ms, which a start with settings in another place saves

    return Path(platformdirs.user_log_dir("brdf-suite", appauthor=False))


def start_log(program: str) -> None:
    """Keep a log from now on: a file of at most 1 MB and two older ones."""
    folder = log_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return  # a program without a log works as well
    name = f"{program.lower().replace(' ', '_')}.log"
    handler = _Log(folder / name, "a", _LOG_BYTES, _LOGS_KEPT, encoding="utf-8", delay=True)
    handler.setFormatter(PrivateFormatter())
    root = logging.getLogger()
    root.addHandler(handler)
    root.setLevel(logging.INFO)


def diagnostics(program: str) -> str:
    """Return a text for a report: versions, system, screens, OpenGL, choices, and the end of the log."""
    from brdf_suite.extras import PACKAGES

    lines = [f"BRDF Suite {program} {__version__}", ""]
    lines.append(
        f"Python {platform.python_version()}, Qt {qVersion()}, {platform.system()} {platform.release()}"
    )
    lines.append(f"processor {platform.machine()}, {os.cpu_count()} cores")
    lines += [f"{name} {_version(name)}" for name in _PACKAGES]
    lines += [f"{package.distribution} {_version(package.distribution)}" for package in PACKAGES.values()]
    lines += ["", f"platform {QGuiApplication.platformName()}"]
    lines += [
        f"screen {screen.size().width()} × {screen.size().height()}, scale {screen.devicePixelRatio():g}, "
        f"{screen.refreshRate():.0f} Hz"
        for screen in QGuiApplication.screens()
    ]
    lines += [f"OpenGL {name}: {text}" for name, text in gl_strings().items()]
    lines += ["", "Settings", *_settings(settings(program))]
    lines += ["", "Log", *_log_end()]
    return "\n".join(lines) + "\n"


def gl_strings() -> dict[str, str]:
    """Return vendor, renderer and version of OpenGL; without a context that says so."""
    context, surface = QOpenGLContext(), QOffscreenSurface()
    surface.create()
    if not context.create() or not context.makeCurrent(surface):
        return {"context": "none"}
    try:
        functions = context.functions()
        return {name: str(functions.glGetString(code)) for name, code in _GL_STRINGS.items()}
    finally:
        context.doneCurrent()


def _version(distribution: str) -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(distribution)
    except PackageNotFoundError:
        return "is not installed"


def _settings(kept: QSettings) -> list[str]:
    """Return choices by their names: numbers, switches and words of the program; no texts that could be names."""
    found = {key: str(kept.value(key)) for key in kept.allKeys()}
    return [
        f"{key} = {text}"
        for key, text in sorted(found.items())
        if key.replace("/", "_").isidentifier() and (_NUMBER.fullmatch(text) or key in _WORDS)
    ]


def _log_end() -> list[str]:
    for handler in logging.getLogger().handlers:
        if isinstance(handler, _Log):
            try:
                text = read_bytes(handler.baseFilename).decode("utf-8", "replace")
            except FileError:  # nothing was written yet
                return []
            return text.splitlines()[-_LAST_LINES:]
    return []
