"""Take the pictures of the assistant "Acquire…" in docs/guides/acquisition.md: the real window, on a simulated session.

Run ``.venv/bin/python packaging/screenshots/acquire.py``; pictures are written to docs/images/ as ``acquire_*.png``.
``--theme``, ``--size``, ``--scale`` and ``--into`` make them elsewhere in another look. Settings are fresh ones. The
session has 61 positions of 288 pixels and 12 exposures, with an arm, half a degree and a pixel out of
line; with its reconstruction it takes some minutes. ``--session`` names a folder where one is kept, or is to be kept.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from lobes import smaller
from screenshots import IMAGES, virtual_screen

PAINT = "table1_polaris_silver"
NAME = "Polaris Silver"
POSITIONS, PIXELS, EXPOSURES = 61, 288, 12
PAGES = ("geometry", "fit")
_PATIENCE_S = 900
_TURN_S = 0.02


def simulate_session(folder: Path) -> None:
    """Write the session; nothing where there is one."""
    from brdf_suite.acquisition.session.session import SESSION_FILE
    from brdf_suite.acquisition.simulator import SimulatorSettings, simulate
    from brdf_suite.pipeline.material import load_material

    if (folder / SESSION_FILE).exists():
        return
    settings = SimulatorSettings(
        size=(PIXELS, PIXELS),
        angles_deg=tuple(180.0 * k / (POSITIONS - 1) for k in range(POSITIONS)),
        exposures=EXPOSURES,
        light_offset_deg=0.5,
        centre_offset_px=(1.0, 0.0),
        arm=True,
        board=False,
    )
    simulate(load_material(PAINT).reflectance, folder, settings, NAME)


def drive(options: argparse.Namespace) -> int:
    """Go through the steps, in the process that has the screen."""
    import numpy as np
    from brdf_designer.acquire.control import AcquireControl
    from brdf_designer.assembly import Designer
    from brdf_qt.program.application import create_application

    app = create_application("Designer", theme_name=options.theme, language=options.language)
    designer = Designer()
    designer.window.show()
    wait(lambda: designer.window.plot.is_built)
    control = designer.feature(AcquireControl)
    assistant = control.open()
    assistant.window.resize(*(int(part) for part in options.size.split("x")))
    assistant.sessions.open(options.session)
    wait(lambda: assistant.bench.is_quiet and assistant.bench.session is not None)
    assistant.window.show_page("mask")
    wait(lambda: assistant.window.mask_page.picture.history is not None)
    used = np.ones((PIXELS, PIXELS), bool)
    history = assistant.window.mask_page.picture.history
    if history.used.all():
        # The post of the arm, as a hand would paint it out.
        history.dab((0.66 * PIXELS, 0.97 * PIXELS), (0.66 * PIXELS, 0.8 * PIXELS), 0.05 * PIXELS, use=False)
        used = history.used.copy()
        assistant.window.mask_page.show_mask(np.ones_like(used))
        assistant.window.mask_page.picture.put(used)
        assistant.write_pending()
    # What a kept session has found before has no pictures: these two are found again in any case.
    for find in (
        assistant.reconstruction.find_response,
        assistant.reconstruction.find_geometry,
        assistant.do_all,
    ):
        find()
        wait(lambda: assistant.bench.is_quiet and not assistant._chain)
    if "fit" not in assistant.bench.results:
        messages = assistant.window.messages.shown()
        raise SystemExit(f"A step failed: {[message.what for message in messages.values()]}")
    assistant.window.exposures.choose(EXPOSURES - 4)
    for page in PAGES:
        assistant.window.show_page(page)
        wait(lambda: assistant.bench.is_quiet)
        wait(lambda: True)
        path = options.into / f"acquire_{page}.png"
        if not assistant.window.grab().toImage().save(str(path)):
            raise SystemExit(f"{path} cannot be written.")
        smaller(path)
        print(f"{path} ({path.stat().st_size:,} bytes)", flush=True)
    designer.close()
    app.exit(0)
    return 0


def wait(until: Callable[[], bool]) -> None:
    """Let the program run until it is so."""
    from time import monotonic, sleep

    from PySide6.QtCore import QCoreApplication

    end = monotonic() + _PATIENCE_S
    while True:
        QCoreApplication.processEvents()
        sleep(
            _TURN_S
        )  # the steps' threads run meanwhile, as they do in the program's own loop; QTest.qWait holds them
        if until():
            return
        if monotonic() > end:
            raise SystemExit("A step was not done in time.")


def main() -> int:
    """Take the pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--theme", default="dark")
    parser.add_argument("--language", default="en")
    parser.add_argument("--size", default="1280x820")
    parser.add_argument("--scale", default="1", help="device pixels per pixel")
    parser.add_argument("--into", type=Path, default=IMAGES)
    parser.add_argument("--session", type=Path, help="folder of the photographs (default: a temporary one)")
    parser.add_argument("--drive", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.drive:
        return drive(options)
    options.into.mkdir(parents=True, exist_ok=True)
    with virtual_screen() as display, tempfile.TemporaryDirectory() as scratch:
        session = (options.session or Path(scratch) / "polaris_silver").absolute()
        simulate_session(session)
        environment: dict[str, Any] = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "QT_SCALE_FACTOR": options.scale,
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "BRDF_SUITE_SETTINGS": f"{scratch}/settings",
            "BRDF_SUITE_CACHE": os.environ.get("BRDF_SUITE_CACHE", f"{scratch}/cache"),
            "BRDF_SUITE_LINK": f"screenshots-{os.getpid()}",
        }
        command = [sys.executable, __file__, "--drive", "--theme", options.theme, "--size", options.size]
        command += ["--language", options.language, "--session", str(session)]
        subprocess.run(
            [*command, "--into", str(options.into.absolute())], env=environment, check=True, timeout=3000
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
