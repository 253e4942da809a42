"""Where a program keeps what it remembers: one plain INI file per program, and a state folder beside it.

The environment variable ``BRDF_SUITE_SETTINGS`` names another folder, so that tests and trials never touch
what a user has set.
"""

from __future__ import annotations

import os
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSettings

from brdf_suite import variables

ORGANISATION = "BRDF Suite"
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
    """Return, and make, the folder ``kind`` (``autosave``, ``log``) beside the settings file of a program."""
    file = Path(settings(program).fileName())
    folder = file.with_suffix("") / kind
    folder.mkdir(parents=True, exist_ok=True)
    return folder
