"""Take the picture of the start page in docs/start/first_paint.md, with recent work that is made up.

Run ``.venv/bin/python packaging/screenshots/start_page.py``; it is written to docs/images/start_page.png. Settings are
fresh ones. The page in other looks, and the tour, are among the states of states.py.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from brdf_qt.documents.recent_files import RecentFiles, recent_projects
from brdf_qt.program.application import create_application
from brdf_qt.start.page import StartWindow
from PySide6.QtTest import QTest
from screenshots import IMAGES, virtual_screen
from states import RECENT

_DRIVE = "--drive"
_SETTLE_MS = 400


def take() -> None:
    """Take the picture in this process."""
    app = create_application("Designer", theme_name="dark", language="en")
    with tempfile.TemporaryDirectory() as work:
        for name in RECENT:
            file = Path(work) / name
            file.touch()
            (recent_projects() if file.suffix == ".brdfproject" else RecentFiles()).add(file)
        page = StartWindow("Designer")
        page.show()
        QTest.qWait(_SETTLE_MS)
        page.grab().save(str(IMAGES / "start_page.png"))
    del app


def main() -> int:
    """Take the picture in a process that has a virtual screen."""
    if _DRIVE in sys.argv:
        take()
        return 0
    with virtual_screen() as display, tempfile.TemporaryDirectory() as scratch:
        environment = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "BRDF_SUITE_SETTINGS": scratch,
            "BRDF_SUITE_LINK": f"screenshots-{os.getpid()}",
        }
        subprocess.run([sys.executable, __file__, _DRIVE], env=environment, check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
