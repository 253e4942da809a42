"""Prepare what the suite needs on this machine: system libraries and a Python environment of its own.

Standard library only, since it runs before anything is installed. ``run.py`` and ``test.py`` call
:func:`prepare`. It shows what it does, changes nothing when everything is there (a few milliseconds), and needs
the network only when packages change.

Third-party packages are installed with build isolation, in the versions of ``lock.txt``; only the project itself,
whose build tool is one of them, is installed without.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any

from installer import Installer, InstallError
from report import NotPrepared, report
from system_libraries import install_optional_libraries, install_system_libraries

ROOT = Path(__file__).resolve().parent.parent
MINIMUM = (3, 11)
NEWEST_TESTED = (3, 14)


class Checkout:
    """A copy of the project's source and the Python environment ``.venv`` that belongs to it."""

    def __init__(self, root: Path = ROOT) -> None:
        self.root = root
        self.environment = root / ".venv"
        self._former = root / ".venv.former"
        self._unfinished = root / ".venv.unfinished"
        self._stamp = self.environment / "brdf-suite-prepared"
        self._lock = root / "packaging" / "lock.txt"
        self._log = root / ".venv" / "install.log"
        self.python = self.program("python")

    def program(self, name: str) -> Path:
        """Return the path of a program of the environment."""
        return self.environment / (f"Scripts/{name}.exe" if os.name == "nt" else f"bin/{name}")

    def declared_extras(self) -> list[str]:
        """Return the names of the extras that the project declares."""
        return sorted(self._project()["project"].get("optional-dependencies", {}))

    def install(self, extras: Collection[str] = ()) -> None:
        """Make the environment hold the project, its dependencies and ``extras``, beside those that it has.

        A failed renewal puts the former environment back.

        Raises
        ------
        NotPrepared
            An extra is unknown, the folder cannot be written to, or the packages cannot be installed.
        """
        unknown = sorted(set(extras) - set(self.declared_extras()))
        if unknown:
            raise NotPrepared(
                f"{', '.join(unknown)}: no such extra; there are {', '.join(self.declared_extras())}."
            )
        if self._is_complete(extras):
            return
        try:
            with self._exclusive():
                if not self._is_complete(extras):  # another process may have installed it meanwhile
                    self._install_missing(set(extras))
        except OSError as error:
            raise NotPrepared(
                f"{error.filename or self.environment} cannot be written ({error.strerror or error}), and the "
                "Python environment goes there. Correct that, or use a copy of the project in a folder of your "
                "own; then run this command again."
            ) from error

    def _install_missing(self, extras: set[str]) -> None:
        self._restore_interrupted()
        recorded = self._recorded()
        wanted = self._state(recorded["extras"])
        extras |= recorded["extras"]
        damaged = not set(recorded["contents"]) <= self._contents()
        if damaged:
            report("The environment is damaged; making it again")
        if damaged or recorded["packages"] != wanted["packages"] or not self.python.exists():
            self._renew(extras)
        else:  # the packages are right: an extra more, or another version of the project itself
            self._fill(extras, with_packages=not extras <= recorded["extras"])
        report("The environment is ready")

    def _renew(self, extras: set[str]) -> None:
        """Make the environment from nothing; the former one stays aside until the new one is complete."""
        if self.environment.exists() or self.environment.is_symlink():
            _remove(self._former)
            self.environment.replace(self._former)
        try:
            self._make_environment()
            self._fill(extras, with_packages=True)
        except BaseException:
            self._restore_interrupted()
            raise
        _remove(self._former)

    def _restore_interrupted(self) -> None:
        """Put the former environment back where a renewal ended early, and keep the log of the failure."""
        if self._stamp.exists() or not self._former.exists():
            return
        log = self._log.read_bytes() if self._log.exists() else b""
        if self.environment.exists():
            _remove(self._unfinished)
            self.environment.replace(self._unfinished)  # works even while something still writes into it
        self._former.replace(self.environment)
        if log:
            self._log.write_bytes(log)
        with contextlib.suppress(OSError):  # what is left of it is removed the next time
            _remove(self._unfinished)

    def _make_environment(self) -> None:
        import venv  # Debian ships it in a package that may have been installed a moment ago

        report(f"Making a Python environment in {self.environment.name} (once; about half a minute)")
        try:
            venv.EnvBuilder(with_pip=True, symlinks=os.name != "nt").create(self.environment)
        except subprocess.CalledProcessError as error:
            detail = " ".join(str(error.output or error).split())[-300:]
            raise NotPrepared(f"The Python environment could not be made: {detail}") from error

    def _fill(self, extras: set[str], with_packages: bool) -> None:
        project = self._project()
        installer = Installer(self.python, self._lock, self._log, self.root)
        try:
            if with_packages:
                report("Installing packages" + (f" for {', '.join(sorted(extras))}" if extras else ""))
                _report_unavailable(self._requirements(project, extras))
                installer.install(*project["build-system"]["requires"], *self._requirements(project, extras))
            installer.install("--no-build-isolation", "--no-deps", "--editable", ".")
            self._compile(extras)
        except InstallError as failure:
            newer = sys.version_info[:2] > NEWEST_TESTED
            hint = (
                f" This is Python {_version(sys.version_info)}, newer than the newest tested one; packages may "
                f"not be published for it yet. Use Python {_version(MINIMUM)} to {_version(NEWEST_TESTED)}."
            )
            raise NotPrepared(
                f"{failure}\n\nThe Python packages could not be installed. The last lines of the installer are "
                f"above, all of them in {self._log}.{hint if newer else ''} Run this command again to retry."
            ) from failure
        state = {**self._state(extras), "contents": sorted(self._contents())}
        self._stamp.write_text(json.dumps({**state, "extras": sorted(extras)}, indent=0), encoding="utf-8")

    def _compile(self, extras: set[str]) -> None:
        """Compile the project's own bytecode, and the filter's kernels where numba is there, before the first start.

        A failure costs time at the first start and nothing else.
        """
        folders = [str(self.root / name) for name in ("brdf_suite", "apps")]
        steps = [["-P", "-m", "compileall", "-q", "-j", "0", *folders]]
        if "speed" in extras:
            report("Compiling the filter of environments")
            steps.append(["-P", "-m", "brdf_suite.lighting.filter.kernels.compilation"])
        for step in steps:
            with self._log.open("a", encoding="utf-8") as log:
                command = [str(self.python), *step]
                subprocess.run(command, stdout=log, stderr=log, stdin=subprocess.DEVNULL, check=False)

    def _is_complete(self, extras: Collection[str]) -> bool:
        recorded = self._recorded()
        wanted = self._state(recorded["extras"])
        return (
            set(extras) <= recorded["extras"]
            and all(recorded[part] == wanted[part] for part in wanted)
            and set(recorded["contents"]) <= self._contents()
            and self.python.exists()
        )

    def _recorded(self) -> dict[str, Any]:
        """Return what the environment was made from; empty values where that is unknown."""
        record: dict[str, Any] = {"packages": "", "project": "", "extras": [], "contents": []}
        with contextlib.suppress(OSError, ValueError):
            found = json.loads(self._stamp.read_text(encoding="utf-8"))
            if isinstance(found, dict) and record.keys() <= found.keys():
                record = found
        return {**record, "extras": set(record["extras"])}

    def _state(self, extras: Collection[str]) -> dict[str, str]:
        """Return digests of what decides about the packages, and about the project's own installation."""
        project = self._project()
        machine = [sys.version, sysconfig.get_platform(), str(self.root)]
        needed = [project["build-system"], self._requirements(project, sorted(extras))]
        lock = self._lock.read_text(encoding="utf-8")
        return {
            "packages": _digest([machine, needed, lock]),
            "project": _digest([project["project"], project.get("tool", {}).get("hatch")]),
        }

    def _project(self) -> dict[str, Any]:
        import tomllib  # from Python 3.11 on: older ones are refused with a sentence before

        return tomllib.loads((self.root / "pyproject.toml").read_text(encoding="utf-8"))

    @staticmethod
    def _requirements(project: dict[str, Any], extras: Collection[str]) -> list[str]:
        optional = project["project"].get("optional-dependencies", {})
        named = [optional.get(extra, []) for extra in sorted(extras)]
        return [*project["project"].get("dependencies", []), *(line for lines in named for line in lines)]

    def _contents(self) -> set[str]:
        """Return the names of the packages and their records, by one directory listing per folder."""
        folders = [
            self.environment / "Lib/site-packages",
            *self.environment.glob("lib/python*/site-packages"),
        ]
        present = (folder for folder in folders if folder.is_dir())
        return {entry.name for folder in present for entry in os.scandir(folder)} - {"__pycache__"}

    @contextlib.contextmanager
    def _exclusive(self) -> Iterator[None]:
        """Let one process at a time install (not on Windows, where files in use are protected anyway)."""
        if os.name == "nt":
            yield
            return
        import fcntl

        folder = os.open(self.root, os.O_RDONLY)
        try:
            with contextlib.suppress(OSError):  # some network file systems have no locks
                fcntl.flock(folder, fcntl.LOCK_EX)
            yield
        finally:
            os.close(folder)


def prepare(*extras: str) -> Path:
    """Install the system libraries and the environment with ``extras``; return the environment's Python.

    Exits with a message and status 1 where something cannot be installed, with status 130 where the user cancels.
    """
    if sys.version_info < MINIMUM:
        raise NotPrepared(
            f"BRDF Suite needs Python {_version(MINIMUM)} or newer; this is {_version(sys.version_info[:3])}."
        )
    checkout = Checkout()
    try:
        install_system_libraries(for_tests="dev" in extras)
        if "reference" in extras:
            install_optional_libraries()
        checkout.install(extras)
    except KeyboardInterrupt:
        print("cancelled; run this command again to continue", file=sys.stderr, flush=True)
        raise SystemExit(130) from None
    return checkout.python


def _remove(place: Path) -> None:
    """Remove a folder, or a file or link in its place; nothing needs to be there."""
    if place.is_dir() and not place.is_symlink():
        shutil.rmtree(place)
    else:
        place.unlink(missing_ok=True)


def _report_unavailable(requirements: list[str]) -> None:
    """Name the packages that are declared for older versions of Python than this one."""
    for line in requirements:
        limit = re.search(r"python_version\s*<\s*['\"](\d+)\.(\d+)['\"]", line)
        if limit and sys.version_info[:2] >= (int(limit[1]), int(limit[2])):
            name = re.split(r"[^A-Za-z0-9._-]", line, maxsplit=1)[0]
            report(
                f"{name} is not published for Python {_version(sys.version_info[:2])}; continuing without it"
            )


def _digest(parts: Any) -> str:
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def _version(numbers: tuple[Any, ...]) -> str:
    return ".".join(map(str, numbers))
