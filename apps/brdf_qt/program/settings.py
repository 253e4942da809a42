"""Where a program keeps what it remembers: one plain INI file per program, and a state folder beside it.

The environment variable ``BRDF_SUITE_SETTINGS`` names another folder, so that tests and trials never touch
what a user has set.
"""

from __future__ import annotations

import atexit
import logging
import os
import shutil
import tempfile
from functools import cache
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSettings

from brdf_suite import variables
from brdf_suite.documents.atomic import make_folder
from brdf_suite.errors import FileError

ORGANISATION = "BRDF Suite"
_log = logging.getLogger(__name__)
SHARED = "shared"
"""The settings that all programs have in common."""


def settings(program: str = "") -> QSettings:
    """Return the settings of a program, by default the running one; cheap to call, all of them share one state."""
    name = program or QCoreApplication.applicationName() or SHARED
    folder = os.environ.get(variables.SETTINGS)
    if folder:
        return QSettings(str(Path(folder) / f"{name}.ini"), QSettings.Format.IniFormat)
    return QSettings(QSettings.Format.IniFormat, QSettings.Scope.UserScope, ORGANISATION, name)


def state_folder(kind: str, program: str = "") -> Path:
    """Return, and make, the folder ``kind`` (``autosave``, ``log``) beside the settings file of a program.

    Where it cannot be made, as without a home folder, it is one in the system's temporary folder, for this run.
    """
    file = Path(settings(program).fileName())
    folder = file.with_suffix("") / kind
    try:
        make_folder(folder)
    except FileError as error:
        folder = _temporary_state(file.parent, error.reason) / file.stem / kind
        folder.mkdir(parents=True, exist_ok=True)
    return folder


@cache
def _temporary_state(wanted: Path, reason: str) -> Path:
    folder = Path(tempfile.mkdtemp(prefix="brdf-suite-state-"))
    _log.warning("Settings cannot be kept in %s (%s); unsaved work is kept in %s.", wanted, reason, folder)
    atexit.register(shutil.rmtree, folder, ignore_errors=True)  # not after a crash: the work would be gone
    return folder
