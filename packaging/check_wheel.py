"""Build what would be published, install the wheel in a fresh environment, and render with it: ``check_wheel.py``.

Proves that what a user installs is complete: resources, shaders and schemas inside, made from the source archive alone,
no file of the checkout needed; and that a package index would take both files (``twine check --strict``).
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import venv
import zipfile
from pathlib import Path

from installer import Installer, InstallError
from wheel import build_release, installed_sizes, size_lines

ROOT = Path(__file__).resolve().parent.parent
LOCK = ROOT / "packaging" / "lock.txt"
NEEDED = (
    "brdf_suite/_resources/basis/search.json",
    "brdf_suite/_resources/paints/blue.brdfpaint",
    "brdf_suite/_resources/paints/cook_torrance/table1_blue.brdfpaint",
    "brdf_suite/_resources/meshes/speed_form.glb",
    "brdf_suite/_resources/environments/booth.exr",
    "brdf_suite/_resources/environments/street.exr",
    "brdf_suite/_resources/occlusion/",
    "brdf_suite/_resources/lobe_maps/",
    "brdf_suite/_resources/thumbnails/environments/street.jpg",
    "brdf_suite/_resources/thumbnails/meshes/car.jpg",
    "brdf_suite/_resources/colour/cie.csv",
    "brdf_suite/_documents/start/first_paint.md",
    "brdf_suite/_resources/schemas/brdfpaint.schema.json",
    "brdf_suite/_documents/images/designer.png",
    "brdf_suite/realtime/shaders/",
    "brdf_suite/__main__.py",
    "brdf_designer/__main__.py",
    "brdf_designer/command_line.py",
    "brdf_viewer/__main__.py",
    "brdf_viewer/command_line.py",
    "brdf_lobe_visualizer/__main__.py",
    "brdf_lobe_visualizer/command_line.py",
    "brdf_lobe_visualizer/view3d/shaders/",
    "brdf_color_swatch/__main__.py",
    "brdf_color_swatch/command_line.py",
    "brdf_qt/gl/shaders/",
)
_SPREAD = """
import sys
from PIL import Image
print(max(high - low for low, high in Image.open(sys.argv[1]).convert("RGB").getextrema()))
"""


def _run(*command: str | Path, cwd: Path, **more: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(c) for c in command], cwd=cwd, check=True, text=True, **more)  # type: ignore[call-overload, no-any-return] # keyword arguments go through


def main() -> int:
    """Return 0 when the installed wheel renders a picture that is not empty."""
    with tempfile.TemporaryDirectory(prefix="brdf-suite-wheel-") as scratch:
        folder = Path(scratch)
        archive, wheel = build_release(folder)
        names = zipfile.ZipFile(wheel).namelist()
        missing = [n for n in NEEDED if not any(name.startswith(n) for name in names)]
        if missing:
            print(f"{wheel.name} lacks {', '.join(missing)}", file=sys.stderr)
            return 1
        for built in (archive, wheel):
            print(f"{built.name}: {built.stat().st_size / 1e6:.1f} MB", flush=True)
        checked = subprocess.run(
            [sys.executable, "-m", "twine", "--no-color", "check", "--strict", str(archive), str(wheel)],
            check=False,
        )
        if checked.returncode:
            return 1

        venv.create(folder / "env", with_pip=True)
        binaries = folder / "env" / "bin"
        try:
            Installer(binaries / "python", LOCK, folder / "install.log", folder).install(str(wheel))
        except InstallError as failure:
            print(f"{failure}\n{wheel.name} could not be installed", file=sys.stderr)
            return 1
        (site_packages,) = (folder / "env").glob("lib/python*/site-packages")
        print("\n".join(size_lines(installed_sizes(site_packages))), flush=True)
        clean = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "VIRTUAL_ENV"))}
        clean["BRDF_SUITE_CACHE"] = str(folder / "cache")
        picture = folder / "wheel.png"
        done = _run(
            binaries / "brdf-suite", "render", "blue", "-o", picture, "--size", "320x240", "--json",
            cwd=folder, env=clean, stdout=subprocess.PIPE,
        )  # fmt: skip
        answer = json.loads(done.stdout)
        spread = _run(
            binaries / "python", "-c", _SPREAD, picture, cwd=folder, env=clean, stdout=subprocess.PIPE,
        )  # fmt: skip
        if int(spread.stdout) < 50:
            print(f"the picture is empty: its channels span {spread.stdout.strip()} of 255", file=sys.stderr)
            return 1
        print(f"rendered {answer['output']} with the installed wheel: {answer['width']}x{answer['height']}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
