"""Find and install the system libraries that the programs load and no Python package brings (Linux only).

Standard library only, since it runs before anything is installed.
"""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import sys
from pathlib import Path

from report import NotPrepared, report

#: Shared library (as the loader knows it) -> Debian package that holds it.
LIBRARIES = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libdbus-1.so.3": "libdbus-1-3",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-xinerama.so.0": "libxcb-xinerama0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
}
#: The same for libraries that some tests use; these tests skip without them, since not every archive has them.
OPTIONAL_LIBRARIES = {"libLLVM.so.19.1": "libllvm19"}
_DRIVERS = ("/usr/lib/*/dri/*_dri.so", "/usr/lib*/dri/*_dri.so", "/usr/lib/*/libEGL_nvidia.so.0")
_FONTS = ("/usr/share/fonts", "/usr/local/share/fonts")


def missing_packages(for_tests: bool) -> list[str]:
    """Return the Debian packages of the libraries and programs that this Linux system lacks."""
    missing = [package for library, package in LIBRARIES.items() if not _loads(library)]
    if not any(next(Path("/").glob(pattern[1:]), None) for pattern in _DRIVERS):
        missing.append("libgl1-mesa-dri")
    fonts = (font for folder in _FONTS for kind in ("ttf", "otf") for font in Path(folder).rglob(f"*.{kind}"))
    if next(fonts, None) is None:
        missing.append("fonts-dejavu-core")
    if for_tests and shutil.which("Xvfb") is None:
        missing.append("xvfb")
    try:
        import ensurepip  # noqa: F401 - Debian ships it in a package of its own; only its presence matters
    except ImportError:
        missing.append(f"python{sys.version_info.major}.{sys.version_info.minor}-venv")
    return missing


def install_system_libraries(for_tests: bool) -> None:
    """Install the required libraries.

    Raises
    ------
    NotPrepared
        Libraries are missing and cannot be installed from here; the message holds the command to run.
    """
    if not sys.platform.startswith("linux"):
        return  # Windows and macOS have OpenGL 3.3, and the wheels bring the rest.
    missing = missing_packages(for_tests)
    if not missing:
        return
    if shutil.which("apt-get") is None:
        raise NotPrepared(
            "These system libraries are missing (Debian package names): "
            + ", ".join(missing)
            + ".\nInstall them with this system's package manager, then run this command again."
        )
    install = ["apt-get", "install", "-y", "--no-install-recommends", *missing]
    prefix = root_prefix()
    if prefix is None:
        raise NotPrepared(
            "System libraries are missing, and installing them needs root. Run this line, then this command "
            "again:\n\n    sudo apt-get update && sudo " + " ".join(install) + "\n"
        )
    report(f"Installing system libraries: {' '.join(missing)}")
    _apt_get(prefix, ["apt-get", "update", "-q"])
    if _apt_get(prefix, install) != 0:
        raise NotPrepared(
            f"The system libraries could not be installed; see above. The command was:\n\n    {' '.join(install)}\n"
        )
    if any(package.endswith("-venv") for package in missing):
        report("Restarting with the new Python modules")
        os.execv(sys.executable, [sys.executable, *sys.argv])


def install_optional_libraries() -> None:
    """Install the libraries that only some tests need, where no password is needed; failures are ignored."""
    if not sys.platform.startswith("linux"):
        return
    wanted = [package for library, package in OPTIONAL_LIBRARIES.items() if not _loads(library)]
    prefix = root_prefix()
    if not wanted or prefix is None or shutil.which("apt-get") is None:
        return
    if not all(_is_available(package) for package in wanted):
        _apt_get(prefix, ["apt-get", "update", "-q"])
    for package in filter(_is_available, wanted):
        report(f"Installing {package}, which some tests need")
        _apt_get(prefix, ["apt-get", "install", "-y", "--no-install-recommends", package])


def root_prefix() -> list[str] | None:
    """Return the words to put before a command that needs root; ``None`` where root cannot be had."""
    if os.geteuid() == 0:
        return []
    if (
        shutil.which("sudo")
        and subprocess.run(["sudo", "-n", "true"], capture_output=True, check=False).returncode == 0
    ):
        return ["sudo", "-n"]
    return None


def _apt_get(prefix: list[str], command: list[str]) -> int:
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    return subprocess.run([*prefix, *command], env=quiet, check=False, stdin=subprocess.DEVNULL).returncode


def _is_available(package: str) -> bool:
    shown = subprocess.run(["apt-cache", "show", package], capture_output=True, check=False)
    return shown.returncode == 0


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True
