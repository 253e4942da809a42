"""First run for a new user: set-up, first picture and first window from an empty home folder, and installed size.

The wheel is built and installed with the locked packages, without extras, into a new environment, and its bytecode is
compiled, as pip does. Each program starts with an empty home folder and empty caches. Times are from process start to
its end, or to `finished_s` of a window. Windows use a separate X server. The set-up runs in fresh clones of the last
commit without a package cache; then the tests of this checkout run once.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.progress import Progress, report

NAME = "first_run"

BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "first_picture_s": ("<=", 6.0, "s", "`brdf-suite render blue -o blue.png`, empty home, median of 3"),
    "second_picture_s": ("<=", 2.0, "s", "the same again in that home, median of 3"),
    "first_window_s": (
        "<=",
        6.0,
        "s",
        "Designer and Viewer with `--size 1280x720 --report-startup`, empty home: process start to the first final "
        "frame, median of 3, the slower of the two",
    ),
    "installed_mb": ("<=", 750.0, "MB", "files of all run-time packages, without extras and bytecode"),
    "cold_set_up": (
        ">=",
        1.0,
        "",
        "1: `packaging/run.py --prepare-only` and `packaging/test.py --prepare-only` pass in fresh clones without a "
        "package cache, for each Python",
    ),
    "tests_s": (
        "<=",
        420.0,
        "s",
        "`python3 packaging/test.py` in a prepared checkout; not measured if it fails",
    ),
}
NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}

_CHECKOUT = Path(__file__).resolve().parents[3]
_PACKAGING = _CHECKOUT / "packaging"
_RUNS = 3
_PYTHONS = ("3.11", "3.12", "3.13")
_OWN = ("PYTHON", "VIRTUAL_ENV", "BRDF_", "NUMBA_", "XDG_", "OPENBLAS_", "QT_")
"""Beginnings of the names of variables that would change what is measured."""


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure and return the figures named in ``BOUNDS``."""
    figures: dict[str, float | None] = {}
    with tempfile.TemporaryDirectory(prefix="brdf-suite-first-run-") as name:
        folder = Path(name)
        report(progress, 0.0, "installing")
        binaries = _installed(folder, figures)
        report(progress, 0.05, "drawing first pictures")
        figures |= _pictures(binaries, folder)
        report(progress, 0.1, "opening first windows")
        figures["first_window_s"] = _windows(binaries, folder)
        report(progress, 0.15, "setting up")
        figures["cold_set_up"] = _set_up(folder)
    report(progress, 0.5, "running the tests")
    figures["tests_s"] = _tests()
    return figures


def _clean(home: Path) -> dict[str, str]:
    """Return the variables of a process whose home folder is ``home``, and who finds nothing outside of it."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(_OWN)}
    places = {
        "HOME": home,
        "XDG_CACHE_HOME": home / "cache",
        "XDG_CONFIG_HOME": home / "config",
        "XDG_DATA_HOME": home / "data",
        "XDG_RUNTIME_DIR": home,
        "NUMBA_CACHE_DIR": home / "numba",
    }
    return kept | {name: str(place) for name, place in places.items()}


def _output(*command: str | Path, home: Path, **more: str) -> str:
    done = subprocess.run(
        [str(word) for word in command],
        cwd=home,
        env=_clean(home) | more,
        check=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        timeout=600,
    )
    return done.stdout


def _seconds(*command: str | Path, home: Path) -> float:
    start = perf_counter()
    _output(*command, home=home)
    return perf_counter() - start


def _installed(folder: Path, figures: dict[str, float | None]) -> Path:
    """Install the wheel without extras; return the folder of its programs."""
    quiet = {"check": True, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    packing = load_module(_PACKAGING / "wheel.py")
    wheel = packing.build_wheel(folder)
    environment = folder / "env"
    uv = [sys.executable, "-m", "uv"]
    subprocess.run([*uv, "venv", "--python", sys.executable, str(environment)], **quiet)
    (binaries,) = (path for path in (environment / "bin", environment / "Scripts") if path.is_dir())
    lock = str(_PACKAGING / "lock.txt")
    subprocess.run(
        [
            *uv,
            "pip",
            "install",
            "--compile-bytecode",
            "--python",
            str(binaries / "python"),
            "-c",
            lock,
            str(wheel),
        ],
        **quiet,
    )
    site_packages = next(environment.rglob("site-packages"))
    sizes = packing.installed_sizes(site_packages)
    figures["installed_mb"] = sum(sizes.values()) / 1e6
    TABLES["installed_mb"] = {package: round(size / 1e6, 1) for package, size in sizes.items()}
    largest = list(TABLES["installed_mb"].items())[:6]
    NOTES["installed_mb"] = ", ".join(f"{package} {size:.0f}" for package, size in largest)
    return binaries


def _pictures(binaries: Path, folder: Path) -> dict[str, float]:
    times: list[tuple[float, float]] = []
    for number in range(_RUNS):
        home = _home(folder / f"picture-{number}")
        command = (binaries / "brdf-suite", "render", "blue", "-o")
        first = _seconds(*command, "blue.png", home=home)
        times.append((first, _seconds(*command, "again.png", home=home)))
    first, second = (median(column) for column in zip(*times, strict=True))
    return {"first_picture_s": first, "second_picture_s": second}


def _windows(binaries: Path, folder: Path) -> float:
    found: dict[str, float] = {}
    with load_module(_PACKAGING / "screenshots" / "screenshots.py").virtual_screen() as display:
        for program in ("brdf-designer", "brdf-viewer"):
            times = []
            for number in range(_RUNS):
                home = _home(folder / f"{program}-{number}")
                words = ("--size", "1280x720", "--report-startup", "--screenshot", "window.png")
                reported = _output(binaries / program, *words, home=home, DISPLAY=display)
                times.append(float(json.loads(reported.splitlines()[-1])["finished_s"]))
            found[program] = median(times)
    NOTES["first_window_s"] = ", ".join(f"{program} {time:.2f} s" for program, time in found.items())
    return max(found.values())


def _home(path: Path) -> Path:
    path.mkdir(mode=0o700)
    return path


def _pythons() -> dict[str, Path]:
    """Return an interpreter of each version that there is: of pyenv, else on the path."""
    found = {}
    for version in _PYTHONS:
        named = shutil.which(f"python{version}")
        own = sorted((Path.home() / ".pyenv" / "versions").glob(f"{version}.*/bin/python"))
        if own or named:
            found[version] = own[-1] if own else Path(str(named))
    return found


def _set_up(folder: Path) -> float:
    """Return 1 where both commands prepare in fresh clones with every Python that there is, else 0."""
    outcomes: dict[str, str] = dict.fromkeys(_PYTHONS, "not on this machine")
    for version, python in _pythons().items():
        clone = folder / f"clone-{version}"
        subprocess.run(["git", "clone", "--quiet", str(_CHECKOUT), str(clone)], check=True)
        caches = {"PIP_NO_CACHE_DIR": "1", "UV_NO_CACHE": "1", "XDG_CACHE_HOME": str(clone / "cache")}
        environment = {k: v for k, v in os.environ.items() if not k.startswith(_OWN)} | caches
        outcomes[version] = "passed"
        for program in ("run.py", "test.py"):
            command = [str(python), str(clone / "packaging" / program), "--prepare-only"]
            done = subprocess.run(
                command, cwd=clone, env=environment, capture_output=True, text=True, check=False
            )
            if done.returncode != 0:
                outcomes[version] = f"{program} failed: {' '.join(done.stderr.split())[-200:]}"
                break
        shutil.rmtree(clone)
    NOTES["cold_set_up"] = "; ".join(f"Python {version} {outcome}" for version, outcome in outcomes.items())
    there = [outcome for outcome in outcomes.values() if not outcome.startswith("not on")]
    return float(bool(there) and all(outcome == "passed" for outcome in there))


def _tests() -> float | None:
    start = perf_counter()
    environment = {name: value for name, value in os.environ.items() if not name.startswith(_OWN)}
    command = [sys.executable, str(_PACKAGING / "test.py")]
    done = subprocess.run(
        command, cwd=_CHECKOUT, env=environment, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        NOTES["tests_s"] = f"not measured: {' '.join(done.stdout.split())[-200:]}"
        return None
    return perf_counter() - start
