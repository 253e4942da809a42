"""Draw the pictures of docs/use/colour_editing.md: Designer with six angles in LCh, and with a paint that cannot be.

Run ``.venv/bin/python packaging/screenshots/colour_editing.py``; they are written to docs/images/. The windows are
real ones, on an X server without a screen, with fresh settings.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
import uuid
from collections.abc import Callable
from pathlib import Path

from screenshots import IMAGES, virtual_screen

SIZE = (1440, 900)
INSIDE = "BRDF_SUITE_PICTURES_INSIDE"


def outside() -> int:
    """Start this file again where there is a screen to draw on."""
    with virtual_screen() as display, tempfile.TemporaryDirectory() as scratch:
        environment = {
            **os.environ,
            INSIDE: "1",
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "BRDF_SUITE_SETTINGS": scratch,
            "BRDF_SUITE_LINK": f"pictures-{uuid.uuid4().hex[:8]}",
        }
        return subprocess.run([sys.executable, __file__], env=environment, check=False).returncode


def inside() -> int:
    """Draw the pictures in one window."""
    from brdf_designer.assembly import Designer
    from brdf_designer.colour.nearest_offer import KEY
    from brdf_qt.program import theme
    from brdf_qt.program.application import create_application

    app = create_application("Designer")
    theme.apply(app, "dark", remember=False)
    designer = Designer()
    window = designer.window
    window.resize(*SIZE)
    window.show()

    def wait(seconds: float, until: Callable[[], bool] = lambda: False) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end and not until():
            app.processEvents()
            time.sleep(0.01)

    def shoot(name: str) -> None:
        wait(8.0)  # the small pictures are drawn by a process of their own
        file = Path(IMAGES) / f"{name}.png"
        window.grab().save(str(file))
        sys.stdout.write(f"{file}\n")

    head = window.editors.head
    wait(6.0)
    head.choose_set("six")
    head.spaces.buttons["lch"].click()
    head.modes.buttons["all"].click()
    shoot("colour_six_angles")
    designer.session.undo()
    head.spaces.buttons["lab"].click()
    head.modes.buttons["one"].click()
    window.editors.editors[2].fields[0].setValue(45.0)
    wait(30.0, lambda: KEY in window.messages.shown())
    shoot("colour_nearest")
    designer.close()
    return 0


if __name__ == "__main__":
    raise SystemExit(inside() if INSIDE in os.environ else outside())
