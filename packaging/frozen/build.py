"""Build the frozen suite: one folder with all that runs, and packages of it for this system.

    python packaging/frozen/build.py [--into dist] [--only folder,deb,archive]

The folder is frozen by PyInstaller in an environment of its own, from the wheel of this checkout. The four programs are
links to one executable, on Windows files that call it. Packages: ``deb``, ``archive`` (extracts itself), ``appimage``
(needs ``appimagetool``) on Linux, ``zip`` on Windows, ``dmg`` on macOS. `packaging/frozen/smoke.py` tests the first
two; docs/development/packages.md says what has been run.
"""

from __future__ import annotations

import argparse
import platform
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
CHECKOUT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(HERE.parent), str(CHECKOUT)]

import desktop  # noqa: E402 - scripts beside, not packages
from entry import PROGRAMS  # noqa: E402
from wheel import build_wheel  # noqa: E402

from brdf_suite.release import __version__  # noqa: E402

PYINSTALLER = "pyinstaller>=6.12"
HOME = Path("opt") / "brdf-suite"
"""Where a package puts the folder, below the root."""
NEEDED = (
    "libegl1", "libgl1", "libxkbcommon-x11-0", "libxcb-cursor0", "libxcb-icccm4", "libxcb-image0",
    "libxcb-keysyms1", "libxcb-render-util0", "libxcb-shape0", "libxcb-xinerama0", "libfontconfig1", "libdbus-1-3",
)  # fmt: skip
"""What the system brings: libraries that belong to its graphics driver or its display server."""
_ARCHIVE_HEAD = """#!/bin/sh
# BRDF Suite {version}: extracts itself. Usage: sh {name} [FOLDER]   (default: ~/.local/opt)
set -eu
target="${{1:-$HOME/.local/opt}}"
mkdir -p "$target"
start=$(awk '/^__ARCHIVE__$/ {{ print NR + 1; exit }}' "$0")
rm -rf "$target/brdf-suite.new"
mkdir "$target/brdf-suite.new"
tail -n +"$start" "$0" | tar -xJ -C "$target/brdf-suite.new"
rm -rf "$target/brdf-suite"
mv "$target/brdf-suite.new/brdf-suite" "$target/brdf-suite"
rmdir "$target/brdf-suite.new"
echo "BRDF Suite {version} is in $target/brdf-suite; start $target/brdf-suite/brdf-suite"
exit 0
__ARCHIVE__
"""


def freeze(into: Path) -> Path:
    """Freeze the wheel of this checkout into ``into/brdf-suite``; return that folder."""
    with tempfile.TemporaryDirectory() as work:
        environment = Path(work, "environment")
        uv = [sys.executable, "-m", "uv"]
        subprocess.run([*uv, "venv", "-q", "--python", sys.executable, str(environment)], check=True)
        python = environment / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
        wheel = build_wheel(Path(work, "wheel"))
        subprocess.run(
            [*uv, "pip", "install", "-q", "--python", str(python), str(wheel), PYINSTALLER], check=True
        )
        subprocess.run(
            [
                *(str(python), "-m", "PyInstaller", "--noconfirm", "--log-level", "WARN"),
                *("--distpath", str(into), "--workpath", str(Path(work, "build")), str(HERE / "suite.spec")),
            ],
            check=True,
            cwd=work,
        )
    folder = into / "brdf-suite"
    for name, program in PROGRAMS.items():
        if sys.platform == "win32":
            call = f'@"%~dp0brdf-suite.exe" {program} %*\r\n'
            (folder / f"{name}.cmd").write_text(call, encoding="ascii", newline="")
        else:
            (folder / name).symlink_to("brdf-suite")
    if sys.platform == "linux":
        desktop.write(folder / "desktop")
    return folder


def folder_size(folder: Path) -> int:
    """Return the bytes of all files below a folder, links not followed."""
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file() and not path.is_symlink())


def build_deb(folder: Path, into: Path) -> Path:
    """Make a Debian package of the frozen folder; return it. Needs ``dpkg-deb``."""
    machine = subprocess.run(
        ["dpkg", "--print-architecture"], check=True, capture_output=True, text=True
    ).stdout.strip()
    made = into / f"brdf-suite_{__version__}_{machine}.deb"
    with tempfile.TemporaryDirectory() as work:
        root = Path(work, "root")
        shutil.copytree(folder, root / HOME, symlinks=True, ignore=shutil.ignore_patterns("desktop"))
        desktop.write(root / "usr")
        (root / "usr" / "bin").mkdir(parents=True)
        for name in ("brdf-suite", *PROGRAMS):
            (root / "usr" / "bin" / name).symlink_to(Path("/") / HOME / name)
        licences = root / "usr" / "share" / "doc" / "brdf-suite"
        licences.mkdir(parents=True)
        shutil.copy(CHECKOUT / "LICENSE", licences / "copyright")
        shutil.copy(CHECKOUT / "THIRD_PARTY.md", licences)
        # What is collected from this system needs its C library.
        needed = (f"libc6 (>= {platform.libc_ver()[1]})", *NEEDED)
        control = root / "DEBIAN"
        control.mkdir()
        (control / "control").write_text(
            f"Package: brdf-suite\nVersion: {__version__}\nArchitecture: {machine}\nSection: graphics\n"
            "Priority: optional\nMaintainer: The BRDF Suite authors <brdf-suite@localhost>\n"
            f"Installed-Size: {folder_size(root) // 1024}\nDepends: {', '.join(needed)}\n"
            "Description: design automotive paint and see it on a car\n"
            " Four programs and a command for colourists, stylists and researchers.\n",
            encoding="utf-8",
        )
        subprocess.run(
            ["dpkg-deb", "--root-owner-group", "-Zxz", "--build", str(root), str(made)],
            check=True,
            stdout=subprocess.DEVNULL,
        )
    return made


def build_archive(folder: Path, into: Path) -> Path:
    """Make a shell script that extracts the frozen folder which it carries; return it."""
    made = into / f"brdf-suite-{__version__}-linux.run"
    with made.open("wb") as file:
        file.write(_ARCHIVE_HEAD.format(version=__version__, name=made.name).encode())
        with tarfile.open(fileobj=file, mode="w|xz") as archive:
            archive.add(folder, "brdf-suite")
    made.chmod(0o755)
    return made


def write_appdir(folder: Path, appdir: Path) -> None:
    """Write the folder that an AppImage holds: the frozen suite, its start, a menu entry with icon, and metadata."""
    shutil.copytree(folder, appdir / HOME, symlinks=True, ignore=shutil.ignore_patterns("desktop"))
    desktop.write(appdir / "usr")
    start = appdir / "AppRun"
    start.write_text(
        f'#!/bin/sh\nexec "$(dirname "$(readlink -f "$0")")/{HOME}/brdf-suite" "$@"\n', encoding="utf-8"
    )
    start.chmod(0o755)
    (appdir / f"{desktop.IDENTITY}.desktop").write_text(desktop.suite_entry(), encoding="utf-8")
    shutil.copy(appdir / "usr/share/icons/hicolor/256x256/apps/brdf-suite.png", appdir / "brdf-suite.png")
    (appdir / ".DirIcon").symlink_to("brdf-suite.png")


def build_appimage(folder: Path, into: Path) -> Path:
    """Make an AppImage of the frozen folder; return it. Needs ``appimagetool``."""
    made = into / f"brdf-suite-{__version__}-{platform.machine()}.AppImage"
    with tempfile.TemporaryDirectory() as work:
        appdir = Path(work, "brdf-suite.AppDir")
        write_appdir(folder, appdir)
        subprocess.run(["appimagetool", "--no-appstream", str(appdir), str(made)], check=True)
    return made


def build_zip(folder: Path, into: Path) -> Path:
    """Make a zip file of the frozen folder, to be extracted anywhere; return it."""
    name = f"brdf-suite-{__version__}-{sys.platform}"
    return Path(shutil.make_archive(str(into / name), "zip", folder.parent, folder.name))


def build_dmg(folder: Path, into: Path) -> Path:
    """Make a disk image of the bundle beside the frozen folder; return it. Needs ``hdiutil``, which macOS has."""
    made = into / f"brdf-suite-{__version__}-{platform.machine()}.dmg"
    with tempfile.TemporaryDirectory() as work:
        shutil.copytree(folder.parent / "BRDF Suite.app", Path(work, "BRDF Suite.app"), symlinks=True)
        Path(work, "Applications").symlink_to("/Applications")
        words = (
            "hdiutil",
            "create",
            "-volname",
            "BRDF Suite",
            "-srcfolder",
            work,
            "-ov",
            "-format",
            "UDZO",
            str(made),
        )
        subprocess.run(words, check=True)
    return made


PACKAGES = {
    "deb": build_deb,
    "archive": build_archive,
    "appimage": build_appimage,
    "zip": build_zip,
    "dmg": build_dmg,
}
USUAL = {"win32": "folder,zip", "darwin": "folder,dmg"}
"""What is built where nothing is named, on systems other than Linux."""


def main() -> None:
    """Build what is asked for, and print where it is and how large."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--into", type=Path, default=CHECKOUT / "dist")
    parser.add_argument("--only", default=USUAL.get(sys.platform, "folder,deb,archive"))
    options = parser.parse_args()
    wanted = options.only.split(",")
    if unknown := set(wanted) - {"folder", *PACKAGES}:
        parser.error(f"{min(unknown)} is none of folder, {', '.join(PACKAGES)}")
    into = options.into.absolute()
    into.mkdir(parents=True, exist_ok=True)
    folder = into / "brdf-suite"
    if "folder" in wanted:
        shutil.rmtree(folder, ignore_errors=True)
        freeze(into)
    print(f"{folder}: {folder_size(folder) / 1e6:.0f} MB")
    for kind, build in PACKAGES.items():
        if kind in wanted:
            made = build(folder, into)
            print(f"{made}: {made.stat().st_size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
