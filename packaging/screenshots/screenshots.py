"""Make the pictures of the documents: the windows, for real, on an X server without a screen; and renders.

Run ``.venv/bin/python packaging/screenshots/screenshots.py [NAME …]``; they are written to docs/images/. Settings
and cache are fresh ones, so that no user's choices show; with a cache that ``BRDF_SUITE_CACHE`` names and that has the
swatches already, the strips of paints show them.
"""

from __future__ import annotations

import dataclasses
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from brdf_suite.documents.store import save_view
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Compare

ROOT = Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"

LARGE = ["--size", "1440x900"]

PROGRAMS = {
    "designer": ["brdf_designer", "blue", "--theme", "dark", *LARGE],
    "viewer": ["brdf_viewer", "blue", "--theme", "dark", *LARGE],
}  # fmt: skip
COMPARED = View(Camera(azimuth_deg=35.0, elevation_deg=12.0), "overcast", "speed_form")


def compared(mode: str, second: str = "candy_red", **fields: float) -> View:
    """Return a view that compares with a second paint."""
    return dataclasses.replace(COMPARED, compare=Compare(mode, second, **fields))


VIEWS = {"viewer_side": (compared("side"), ["blue", "--theme", "dark"])}
"""Pictures of the Viewer in a view, and what it is started with beside it."""

RENDERS = {
    "render_street": [
        "blue",
        "--environment",
        "street",
        "--mesh",
        "car",
        "--rotation",
        "185",
        "--azimuth",
        "38",
        "--elevation",
        "4.5",
        "--f-stop",
        "2",
        "--automatic-exposure",
        "--exposure",
        "-0.35",
        "--size",
        "1280x720",
    ],
    "render_car": [
        "gold_metallic",
        "--environment",
        "sunny",
        "--mesh",
        "car",
        "--rotation",
        "100",
        "--azimuth",
        "40",
        "--elevation",
        "9",
        "--automatic-exposure",
    ],
}


@contextmanager
def virtual_screen(size: tuple[int, int] = (1920, 1200)) -> Iterator[str]:
    """Run an X server of its own, ``size`` pixels large, and yield its display; it stays as it is between programs."""
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{size[0]}x{size[1]}x24",
         "-nolisten", "tcp", "-noreset"],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    )  # fmt: skip
    os.close(writing)
    try:
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            raise SystemExit("Xvfb did not start; install it (on Debian: apt-get install xvfb).")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


def main() -> int:
    """Make the pictures named in the arguments, or all."""
    known = [*PROGRAMS, *VIEWS, *RENDERS]
    wanted = set(sys.argv[1:]) or set(known)
    unknown = wanted - set(known)
    if unknown:
        raise SystemExit(f"There is no picture {', '.join(sorted(unknown))}; there are {', '.join(known)}.")
    IMAGES.mkdir(parents=True, exist_ok=True)
    with virtual_screen() as display, tempfile.TemporaryDirectory() as scratch:
        environment = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "XDG_CONFIG_HOME": f"{scratch}/config",
            "XDG_DATA_HOME": f"{scratch}/data",
            "BRDF_SUITE_CACHE": os.environ.get("BRDF_SUITE_CACHE", f"{scratch}/cache"),
            "BRDF_SUITE_LINK": f"screenshots-{os.getpid()}",
        }
        for name, command in PROGRAMS.items():
            if name in wanted:
                run(
                    [sys.executable, "-m", *command, "--screenshot", str(IMAGES / f"{name}.png")], environment
                )
        for name, (view, command) in VIEWS.items():
            if name in wanted:
                file = Path(scratch) / f"{name}.brdfview"
                save_view(view, file)
                run(
                    [sys.executable, "-m", "brdf_viewer", *command, "--view", str(file), "--size", "1280x720",
                     "--screenshot", str(IMAGES / f"{name}.png")],
                    environment | {"BRDF_SUITE_SETTINGS": f"{scratch}/{name}"},
                )  # fmt: skip
        for name, command in RENDERS.items():
            if name in wanted:
                output = ["-o", str(IMAGES / f"{name}.png")]
                run([sys.executable, "-m", "brdf_suite", "render", *command, *output], environment)
    return 0


def run(command: list[str], environment: dict[str, str]) -> None:
    """Run one program and say which picture came of it."""
    subprocess.run(command, env=environment, check=True, timeout=300)
    print(command[-1], flush=True)


if __name__ == "__main__":
    sys.exit(main())
