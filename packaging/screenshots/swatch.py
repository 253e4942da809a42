"""Make the pictures of docs/guides/palettes.md: the real program with 200 paints, on an X server without a screen.

Run ``.venv/bin/python packaging/screenshots/swatch.py [NAME …]``; pictures are written to docs/images/. Settings and
cache are fresh ones. ``--size``, ``--theme``, ``--scale`` and ``--into`` make them elsewhere in another look.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

import example_palette
from screenshots import IMAGES, run, virtual_screen

from brdf_suite.documents.palette_store import save_palette

ACTIONS: dict[str, tuple[str, list[str]]] = {
    "swatch_groups": ("dark", ["--swatch-size", "72", "--do", "select=175"]),
    "swatch_map": ("dark", ["--do", "map=space", "--do", "group=Metallic", "--do", "select=4,12,25"]),
}  # fmt: skip
"""The theme of each picture, and what is done before it is taken."""


def main() -> int:
    """Make the pictures named in the arguments, or all."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", choices=[[], *ACTIONS])
    parser.add_argument("--size", default="1280x740")
    parser.add_argument("--theme")
    parser.add_argument("--scale", default="1")
    parser.add_argument("--into", type=Path, default=IMAGES)
    options = parser.parse_args()
    options.into.mkdir(parents=True, exist_ok=True)
    with virtual_screen() as display, tempfile.TemporaryDirectory() as scratch:
        environment = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "QT_SCALE_FACTOR": options.scale,
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "BRDF_SUITE_LINK": f"screenshots-{os.getpid()}",
        }
        environment.setdefault("BRDF_SUITE_CACHE", f"{scratch}/cache")
        file = Path(scratch) / "two_hundred.brdfpalette"
        save_palette(example_palette.palette(), file)
        for name in options.names or ACTIONS:
            theme, actions = ACTIONS[name]
            command = [
                sys.executable,
                "-m",
                "brdf_color_swatch",
                str(file),
                "--theme",
                options.theme or theme,
            ]
            command += ["--size", options.size, *actions, "--screenshot", str(options.into / f"{name}.png")]
            # Each begins as a first start does.
            run(command, environment | {"BRDF_SUITE_SETTINGS": f"{scratch}/{name}"})
    return 0


if __name__ == "__main__":
    sys.exit(main())
