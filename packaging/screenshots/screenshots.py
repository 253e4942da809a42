"""Make the pictures of the documents: the windows, for real, on an X server without a screen; and renders.

Run ``.venv/bin/python packaging/screenshots/screenshots.py [NAME …]``; they are written to docs/images/. Settings
and cache are fresh ones, so that no user's choices show.
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

from brdf_viewer.light.section import with_preset

from brdf_suite.documents.store import save_view
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Compare, SurfaceLook

ROOT = Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"

LARGE = ["--size", "1440x900"]

PROGRAMS = {
    "designer": ["brdf_designer", "blue", "--theme", "dark", *LARGE],
    "designer_booth": ["brdf_designer", "fine_silver", "--theme", "booth", *LARGE],
    "designer_light_small": ["brdf_designer", "copper", "--theme", "light", "--size", "900x600"],
    "viewer": ["brdf_viewer", "blue", "--theme", "dark", *LARGE],
    "viewer_car": ["brdf_viewer", "red", "--surface", "car", "--environment", "sunny", "--theme", "booth", *LARGE],
    "viewer_light_small": ["brdf_viewer", "fine_silver", "--surface", "panel", "--theme", "light", "--size", "900x600"],
}  # fmt: skip
COMPARED = View(Camera(azimuth_deg=35.0, elevation_deg=12.0), "overcast", "speed_form")


def compared(mode: str, second: str = "candy_red", **fields: float) -> View:
    """Return a view that compares with a second paint."""
    return dataclasses.replace(COMPARED, compare=Compare(mode, second, **fields))


def traced(mode: str, **fields: float) -> View:
    """Return a view on the ground whose traced picture is compared with its own in real time."""
    look = dataclasses.replace(COMPARED.surface_look, ground=True)
    return dataclasses.replace(COMPARED, surface_look=look, compare=Compare(mode, None, **fields))


VIEWS = {
    "viewer_side": (compared("side"), ["blue", "--theme", "dark"]),
    "viewer_swipe": (compared("swipe", divider=0.45), ["blue", "--theme", "booth"]),
    "viewer_difference": (
        compared("difference", "silver_metallic_2", scale_delta_e=10.0),
        ["silver_metallic", "--theme", "light"],
    ),
    "viewer_figures": (COMPARED, ["copper", "--theme", "dark"]),
    "viewer_reference": (
        traced("swipe", divider=0.5),
        ["blue", "--theme", "light", "--renderer", "reference", "--spp", "192"],
    ),
    "viewer_reference_difference": (
        traced("difference", scale_delta_e=5.0),
        ["blue", "--theme", "dark", "--renderer", "reference", "--spp", "192"],
    ),
    "viewer_raytraced": (
        dataclasses.replace(traced("off"), environment="sunny"),
        ["copper", "--theme", "dark", "--renderer", "raytraced", "--quality", "medium"],
    ),
}
"""Pictures of the Viewer in a view, and what it is started with beside it."""
FIGURES = {"viewer_figures"}
LAMPS_ALONE = dataclasses.replace(
    with_preset(View(Camera(azimuth_deg=35.0, elevation_deg=12.0), surface="speed_form"), "three"),
    background="grey",
    surface_look=SurfaceLook(occlusion=False),
)
MEASURED = (
    Path(os.environ.get("BRDF_SUITE_SHARED", ROOT.parent / "shared")) / "data" / "brdf" / "krylon_blue.brdf"
)
"""What viewer_lamps shows, factored; without that file there is no such picture."""

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
    "render_speed_form": ["blue", "--environment", "booth", "--mesh", "speed_form"],
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
    "render_overcast": ["red", "--environment", "overcast", "--mesh", "car", "--azimuth", "215"],
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
    known = [*PROGRAMS, *VIEWS, "viewer_lamps", *RENDERS]
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
            "BRDF_SUITE_CACHE": f"{scratch}/cache",
            "BRDF_SUITE_LINK": f"screenshots-{os.getpid()}",
        }
        for name, command in PROGRAMS.items():
            if name in wanted:
                run(
                    [sys.executable, "-m", *command, "--screenshot", str(IMAGES / f"{name}.png")], environment
                )
        views = dict(VIEWS)
        if "viewer_lamps" in wanted and MEASURED.is_file():
            factored = f"{scratch}/krylon_blue.brdfpaint"
            command = ["factorize", str(MEASURED), "-o", factored]
            run([sys.executable, "-m", "brdf_suite.cli.main", *command], environment)
            views["viewer_lamps"] = (LAMPS_ALONE, [factored, "--theme", "dark"])
        for name, (view, command) in views.items():
            if name in wanted:
                file, folder = Path(scratch) / f"{name}.brdfview", Path(scratch) / name
                save_view(view, file)
                folder.mkdir()
                (folder / "Viewer.ini").write_text(f"[General]\nfigures={str(name in FIGURES).lower()}\n")
                run(
                    [sys.executable, "-m", "brdf_viewer", *command, "--view", str(file), "--size", "960x620",
                     "--screenshot", str(IMAGES / f"{name}.png")],
                    environment | {"BRDF_SUITE_SETTINGS": str(folder)},
                )  # fmt: skip
        for name, command in RENDERS.items():
            if name in wanted:
                output = ["-o", str(IMAGES / f"{name}.png")]
                run([sys.executable, "-m", "brdf_suite.cli.main", "render", *command, *output], environment)
    return 0


def run(command: list[str], environment: dict[str, str]) -> None:
    """Run one program and say which picture came of it."""
    subprocess.run(command, env=environment, check=True, timeout=300)
    print(command[-1], flush=True)


if __name__ == "__main__":
    sys.exit(main())
