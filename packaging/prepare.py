"""Prepare what the suite needs on this machine: system libraries and a Python environment of its own.

Standard library only, since it runs before anything is installed. ``run.py`` and ``test.py`` call
:func:`prepare`; it is idempotent, shows what it does, and costs a few milliseconds when all is there.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from pip_progress import PipError, run_pip
from pip_progress import say as _say

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENT = ROOT / ".venv"
LOCK = ROOT / "packaging" / "lock.txt"
STAMP = ENVIRONMENT / "brdf-suite-prepared"
LOG = ENVIRONMENT / "install.log"
PYTHON = ENVIRONMENT / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
MINIMUM = (3, 11)

#: Shared library (as the loader knows it) -> Debian package that holds it.
_LIBRARIES = {
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
#: The same for what only some tests need, which skip without it: not every system's archive has it.
_FOR_SOME_TESTS = {"libLLVM.so.19.1": "libllvm19"}
_DRIVER_PLACES = ("/usr/lib/*/dri/*_dri.so", "/usr/lib*/dri/*_dri.so", "/usr/lib/*/libEGL_nvidia.so.0")
_FONT_PLACES = ("/usr/share/fonts", "/usr/local/share/fonts")


class NotPrepared(SystemExit):
    """Ends the program with a message and exit status 1."""


def _missing_packages(for_tests: bool) -> list[str]:
    """Name the Debian packages of the libraries and programs that this Linux lacks."""
    missing = [package for library, package in _LIBRARIES.items() if not _loads(library)]
    if not any(next(Path("/").glob(place[1:]), None) for place in _DRIVER_PLACES):
        missing.append("libgl1-mesa-dri")
    fonts = (f for place in _FONT_PLACES for kind in ("ttf", "otf") for f in Path(place).rglob(f"*.{kind}"))
    if next(fonts, None) is None:
        missing.append("fonts-dejavu-core")
    if for_tests and shutil.which("Xvfb") is None:
        missing.append("xvfb")
    try:
        import ensurepip  # noqa: F401 - Debian splits it from Python; only its presence is asked
    except ImportError:
        missing.append(f"python{sys.version_info.major}.{sys.version_info.minor}-venv")
    return missing


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def _offered(package: str) -> bool:
    """Whether this system's archive has a package."""
    asked = subprocess.run(["apt-cache", "show", package], capture_output=True, check=False)
    return asked.returncode == 0


def _install_for_some_tests() -> None:
    """Install what is wanted by some tests where that needs no question; a failure costs those tests only."""
    wanted = [package for library, package in _FOR_SOME_TESTS.items() if not _loads(library)]
    prefix = _root_prefix()
    if not wanted or prefix is None or shutil.which("apt-get") is None:
        return
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    if not all(_offered(package) for package in wanted):
        update = [*prefix, "apt-get", "update", "-q"]
        subprocess.run(update, env=quiet, check=False, stdin=subprocess.DEVNULL)
    for package in filter(_offered, wanted):
        _say(f"Installing {package}, which some tests want")
        install = [*prefix, "apt-get", "install", "-y", "--no-install-recommends", package]
        subprocess.run(install, env=quiet, check=False, stdin=subprocess.DEVNULL)


def _install_system_libraries(for_tests: bool) -> None:
    if not sys.platform.startswith("linux"):
        return  # the wheels bring what Windows and macOS need, and both have OpenGL 3.3 of their own
    missing = _missing_packages(for_tests)
    if not missing:
        return
    if shutil.which("apt-get") is None:
        raise NotPrepared(
            "These system libraries are missing (named as Debian names them): "
            + ", ".join(missing)
            + ".\nInstall their counterparts with this system's package manager, then run this again."
        )
    install = ["apt-get", "install", "-y", "--no-install-recommends", *missing]
    prefix = _root_prefix()
    if prefix is None:
        raise NotPrepared(
            "System libraries are missing and may not be installed from here. Run this one line, then "
            "this command again:\n\n    sudo apt-get update && sudo " + " ".join(install) + "\n"
        )
    _say(f"Installing system libraries: {' '.join(missing)}")
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    subprocess.run([*prefix, "apt-get", "update", "-q"], env=quiet, check=False, stdin=subprocess.DEVNULL)
    done = subprocess.run([*prefix, *install], env=quiet, check=False, stdin=subprocess.DEVNULL)
    if done.returncode != 0:
        raise NotPrepared(
            f"The system libraries could not be installed; see above. The line was:\n\n    {' '.join(install)}\n"
        )
    if "-venv" in " ".join(missing):
        _say("Starting again with the new Python modules")
        os.execv(sys.executable, [sys.executable, *sys.argv])


def _root_prefix() -> list[str] | None:
    """Return what to put before a command that needs root; ``None`` where we may not."""
    if os.geteuid() == 0:
        return []
    if (
        shutil.which("sudo")
        and subprocess.run(["sudo", "-n", "true"], capture_output=True, check=False).returncode == 0
    ):
        return ["sudo", "-n"]
    return None


def _fingerprint() -> str:
    """Return what the environment depends on: Python, build settings, lock, place."""
    state = hashlib.sha256()
    for part in (sys.version, sysconfig.get_platform(), str(ROOT)):
        state.update(part.encode())
    for file in (ROOT / "pyproject.toml", LOCK):
        state.update(file.read_bytes())
    return state.hexdigest()


def _installed() -> set[str]:
    """Name what lies in the environment: packages and their records, by one directory listing per folder."""
    folders = [ENVIRONMENT / "Lib" / "site-packages", *ENVIRONMENT.glob("lib/python*/site-packages")]
    return {
        entry.name
        for folder in folders
        if folder.is_dir()
        for entry in os.scandir(folder)
        if entry.name != "__pycache__"
    }


def _noted() -> tuple[str, set[str], set[str]] | None:
    """Return fingerprint, extras and contents that the environment was made with, else ``None``."""
    try:
        first, *contents = STAMP.read_text(encoding="utf-8").splitlines()
        fingerprint, *extras = first.split()
    except (OSError, ValueError):  # ValueError: an empty stamp
        return None
    return fingerprint, set(extras), set(contents)


def _stamped() -> tuple[set[str], set[str]] | None:
    """Return extras and contents of an environment made for this state of the checkout, else ``None``."""
    noted = _noted()
    if noted is None or noted[0] != _fingerprint() or not PYTHON.exists():
        return None
    return noted[1:]


def _write_stamp(extras: set[str]) -> None:
    lines = [" ".join([_fingerprint(), *sorted(extras)]), *sorted(_installed())]
    STAMP.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _check_writable() -> None:
    """Refuse a place where nothing can be written, before anything is taken away."""
    places = [ENVIRONMENT, *ENVIRONMENT.glob("lib/python*/site-packages")] if ENVIRONMENT.exists() else [ROOT]
    for place in places:
        if not os.access(place, os.W_OK):
            raise NotPrepared(
                f"{place} cannot be written to, and the Python environment goes there. Give yourself the "
                "right to write in it, or use a copy of the checkout that is your own."
            )


def _pip(*arguments: str) -> None:
    try:
        run_pip(PYTHON, ["install", "-c", str(LOCK), *arguments], LOG, ROOT)
    except PipError as failure:
        raise NotPrepared(
            f"{failure}\n\nThe Python packages could not be installed; the last lines of pip are above, all "
            f"of them in {LOG}. Run this again to try again."
        ) from failure


def _make_environment() -> None:
    import venv

    _say(f"Making a Python environment in {ENVIRONMENT.name}/ (once; about a minute)")
    STAMP.unlink(missing_ok=True)
    try:
        venv.EnvBuilder(with_pip=True, clear=ENVIRONMENT.exists(), symlinks=os.name != "nt").create(
            ENVIRONMENT
        )
    except subprocess.CalledProcessError as error:
        detail = " ".join(str(error.output or error).split())[-300:]
        raise NotPrepared(f"The Python environment could not be made: {detail}") from error


def _install_environment(extras: set[str]) -> None:
    stamped, noted = _stamped(), _noted()
    if stamped is None and noted is not None:
        # Made anew for other versions, it keeps what it was made for: who tested goes on testing after a run.
        extras = extras | noted[1]
    if stamped is not None and not stamped[1] <= _installed():
        _say("the environment is damaged; mending it")
        extras = extras | stamped[0]
        stamped = None
    have = None if stamped is None else stamped[0]
    if have is not None and extras <= have:
        return
    extras = extras | (have or set())
    try:
        _check_writable()
        if have is None:
            _make_environment()
        LOG.unlink(missing_ok=True)
        _say("Installing Python packages" + (f" with extras {', '.join(sorted(extras))}" if extras else ""))
        _pip("hatchling")
        wanted = f"[{','.join(sorted(extras))}]" if extras else ""
        _pip("--no-build-isolation", "--editable", f".{wanted}")
        _write_stamp(extras)
    except OSError as error:
        place = error.filename or ENVIRONMENT
        raise NotPrepared(
            f"{place} cannot be written ({error.strerror or error}); the Python environment could not be "
            "made. Mend that, then run this again."
        ) from error
    _say("The environment is ready")


def prepare(*extras: str) -> Path:
    """Make sure of the system libraries and the environment with ``extras``; return its Python.

    Exits with a message, and status 1, where something is missing that may not be installed from here; with
    status 130 where the user cancels.
    """
    if sys.version_info < MINIMUM:
        found = ".".join(map(str, sys.version_info[:3]))
        raise NotPrepared(f"BRDF Suite needs Python {MINIMUM[0]}.{MINIMUM[1]} or newer; this is {found}.")
    try:
        _install_system_libraries(for_tests="dev" in extras)
        if "reference" in extras and sys.platform.startswith("linux"):
            _install_for_some_tests()
        _install_environment(set(extras))
    except KeyboardInterrupt:
        print("cancelled; run this again to go on", file=sys.stderr, flush=True)
        raise SystemExit(130) from None
    return PYTHON
