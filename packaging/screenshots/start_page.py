"""Take the pictures of the start page and of the tour: in both themes, on 1280 x 720 and at 200 %.

    python packaging/screenshots/start_page.py [FOLDER]

``start_page.png`` goes to ``docs/images``; with FOLDER all of them go there. Each is taken by a process of its own on a
virtual screen: ``--one`` is what such a process is called with.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from brdf_designer.assembly import Designer
from brdf_qt.documents.recent_files import RecentFiles, recent_projects
from brdf_qt.program.application import create_application
from brdf_qt.start.page import StartWindow
from PySide6.QtTest import QTest
from screenshots import IMAGES, virtual_screen

PICTURES = {
    "start_page": ("dark", 1.0, None),
    "start_page_light": ("light", 1.0, None),
    "start_page_720": ("dark", 1.0, (1203, 662)),
    "start_page_light_720": ("light", 1.0, (1203, 662)),
    "start_page_200": ("dark", 2.0, (902, 496)),
    "start_page_light_200": ("light", 2.0, (902, 496)),
}
"""Theme, scale of the screen, and the size that the page takes on a smaller screen, in logical pixels."""
TOURS = {"tour": ("dark", 1.0, (1280, 720)), "tour_light": ("light", 1.0, (1280, 720))}
"""The same for the window under the tour; each makes a picture of every step."""
_STEPS = 3
_SETTLE_MS = 400


def take(name: str, folder: Path) -> None:
    """Take one picture in this process."""
    theme, _scale, size = {**PICTURES, **TOURS}[name]
    app = create_application("Designer", theme_name=theme, language="en")
    if name in PICTURES:
        with tempfile.TemporaryDirectory() as work:
            for recent, file in (
                (recent_projects(), "spring_collection.brdfproject"),
                (RecentFiles(), "red_metallic.brdfpaint"),
                (RecentFiles(), "polaris_silver.binary"),
            ):
                (Path(work) / file).touch()
                recent.add(Path(work) / file)
            page = StartWindow("Designer")
            if size is not None:
                page.resize(*size)
            page.show()
            QTest.qWait(_SETTLE_MS)
            page.grab().save(str(folder / f"{name}.png"))
        return
    designer = Designer()
    designer.window.resize(*(size or (1280, 720)))
    designer.window.show()
    while not designer.is_idle:
        app.processEvents()
    designer.window.start.start_tour()
    for step in range(_STEPS):
        QTest.qWait(_SETTLE_MS)
        designer.window.grab().save(str(folder / f"{name}_{step + 1}.png"))
        tour = designer.window.start.tour
        if tour is not None and tour.callout is not None:
            tour.callout.next.click()
    designer.close()


def main() -> int:
    """Take all pictures, each in a process."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path)
    parser.add_argument("--one", metavar="NAME", help=argparse.SUPPRESS)
    options = parser.parse_args()
    folder = options.folder or IMAGES
    folder.mkdir(parents=True, exist_ok=True)
    if options.one is not None:
        take(options.one, folder)
        return 0
    wanted = {**PICTURES, **TOURS} if options.folder else {"start_page": PICTURES["start_page"]}
    with virtual_screen() as display:
        for name, (_theme, scale, _size) in wanted.items():
            with tempfile.TemporaryDirectory() as scratch:
                environment = {
                    **os.environ,
                    "DISPLAY": display,
                    "QT_QPA_PLATFORM": "xcb",
                    "QT_SCALE_FACTOR": str(scale),
                    "BRDF_SUITE_SETTINGS": scratch,
                    "BRDF_SUITE_LINK": f"screenshots-{os.getpid()}",
                }
                command = [sys.executable, __file__, str(folder), "--one", name]
                subprocess.run(command, env=environment, check=True)
            print(name, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
