"""Make the pictures of docs/guides/researcher.md: the real window, on an X server without a screen.

Run ``.venv/bin/python packaging/screenshots/lobes.py [NAME …]``; they are written to docs/images/. ``--theme``,
``--size``, ``--scale`` and ``--into`` make them elsewhere in another look. Settings are fresh ones for every picture.
Measured data are read from the folder that ``BRDF_SUITE_SHARED`` names; a picture whose data are not there is left out,
and said so.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from screenshots import IMAGES, virtual_screen

SHARED = "BRDF_SUITE_SHARED"
MOST_BYTES = 300_000
SIZE = "1400x900"

PICTURES: dict[str, list[str]] = {
    "lobes_blue_metallic": [
        "blue_metallic", "--show", "target,fit", "--set", "fill=body", "--plots", "polar,curves,unrolled",
    ],
    "lobes_cayman": [
        "cayman.brdf", "--show", "fit", "--incidence", "40,0", "--radius", "log",
        "--set", "camera=plane", "--set", "fill=body", "--set", "decades=4", "--plots", "polar,curves,half_angle",
    ],
}  # fmt: skip
"""Names of the pictures, and what the program is started with."""
THEMES = {"lobes_cayman": "light"}
MEASURED = {"cayman.brdf": Path("data", "brdf", "cayman.brdf")}


def arguments(name: str) -> list[str] | None:
    """Return what the program is started with for a picture, None where its data are not there."""
    found = []
    for word in PICTURES[name]:
        if word in MEASURED:
            path = Path(os.environ.get(SHARED, "")) / MEASURED[word]
            if not os.environ.get(SHARED) or not path.is_file():
                return None
            word = str(path)
        found.append(word)
    return found


def take(name: str, path: Path, display: str, look: argparse.Namespace) -> None:
    """Run the program for a picture, and save it."""
    wanted = arguments(name)
    if wanted is None:
        print(f"{name}: left out; {SHARED} names no folder with its data.")
        return
    with tempfile.TemporaryDirectory() as scratch:
        environment = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "QT_SCALE_FACTOR": str(look.scale),
            "BRDF_SUITE_SETTINGS": scratch,
            "BRDF_SUITE_LINK": f"pictures-{os.getpid()}",
        }
        theme = look.theme or THEMES.get(name, "dark")
        command = [
            sys.executable,
            "-m",
            "brdf_lobe_visualizer",
            *wanted,
            "--theme",
            theme,
            "--size",
            look.size,
        ]
        subprocess.run([*command, "--screenshot", str(path)], env=environment, check=True, timeout=300)
    smaller(path)
    print(f"{path} ({path.stat().st_size:,} bytes)")


def smaller(path: Path) -> None:
    """Pack a picture as well as PNG can; with 256 colours where it is still larger than a document should hold."""
    from PIL import Image

    with Image.open(path) as picture:
        rgb = picture.convert("RGB")
    rgb.save(path, optimize=True)
    if path.stat().st_size > MOST_BYTES:
        rgb.quantize(256, dither=Image.Dither.FLOYDSTEINBERG).save(path, optimize=True)


def main() -> int:
    """Make the pictures named in the arguments, or all."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(PICTURES))
    parser.add_argument(
        "--theme", choices=("dark", "booth", "light"), help="of all pictures (default: each its own)"
    )
    parser.add_argument("--size", default=SIZE, metavar="WxH")
    parser.add_argument("--scale", type=float, default=1.0, help="QT_SCALE_FACTOR")
    parser.add_argument("--into", type=Path, default=IMAGES, metavar="FOLDER")
    look = parser.parse_args()
    unknown = set(look.names) - set(PICTURES)
    if unknown:
        raise SystemExit(
            f"There is no picture {', '.join(sorted(unknown))}; there are {', '.join(PICTURES)}."
        )
    look.into.mkdir(parents=True, exist_ok=True)
    with virtual_screen() as display:
        for name in look.names or PICTURES:
            take(name, look.into / f"{name}.png", display, look)
    return 0


if __name__ == "__main__":
    sys.exit(main())
