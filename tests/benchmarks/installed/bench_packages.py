"""The frozen suite: its size, the start of Designer, and the smoke tests of folder, Debian package and archive.

They are built from this checkout (`packaging/frozen/build.py`) and tested (`packaging/frozen/smoke.py`). The package is
installed and removed, which needs root and the packages that `docs/development/packages.md` names.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.progress import Progress, report

NAME = "packages"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "folder_mb": ("<=", 550.0, "MB", "the frozen folder on disk"),
    "deb_mb": ("", None, "MB", "the Debian package"),
    "archive_mb": ("", None, "MB", "the archive that extracts itself"),
    "designer_ready_s": (
        "<=",
        2.0,
        "s",
        "frozen Designer with a paint: process start to a usable window, median of 3",
    ),
    "folder_passes": (">=", 1.0, "", "1: the smoke test of the folder passes"),
    "deb_passes": (">=", 1.0, "", "1: that of the Debian package, installed and removed, with `xdg-open`"),
    "archive_passes": (">=", 1.0, "", "1: that of the archive"),
}
NOTES: dict[str, str] = {}

_FROZEN = Path(__file__).resolve().parents[3] / "packaging" / "frozen"


def run(progress: Progress | None) -> dict[str, float | None]:
    """Build, measure and test."""
    figures: dict[str, float | None] = dict.fromkeys(BOUNDS)
    with tempfile.TemporaryDirectory(prefix="brdf-suite-packages-") as name:
        into = Path(name)
        report(progress, 0.0, "building")
        subprocess.run(
            [sys.executable, str(_FROZEN / "build.py"), "--into", name], check=True, stdout=subprocess.DEVNULL
        )
        folder, (deb,), (archive,) = into / "brdf-suite", into.glob("*.deb"), into.glob("*.run")
        figures["folder_mb"] = load_module(_FROZEN / "build.py").folder_size(folder) / 1e6
        figures["deb_mb"], figures["archive_mb"] = (one.stat().st_size / 1e6 for one in (deb, archive))
        for share, key, built in ((0.5, "folder", folder), (0.7, "deb", deb), (0.85, "archive", archive)):
            report(progress, share, f"testing {built.name}")
            measured = into / "figures.json"
            command = [sys.executable, str(_FROZEN / "smoke.py"), str(built), "--figures", str(measured)]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            figures[f"{key}_passes"] = float(done.returncode == 0)
            if done.returncode:
                NOTES[f"{key}_passes"] = done.stderr.strip()[-300:]
            elif key == "folder":
                figures["designer_ready_s"] = json.loads(measured.read_text(encoding="utf-8"))[
                    "designer_ready_s"
                ]
    return figures
