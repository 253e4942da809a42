"""Import of optional packages, with the installation hint for missing ones.

The extras and the versions that they need are those of ``[project.optional-dependencies]``, read from the metadata of
the installed project.
"""

from __future__ import annotations

import os
import re
import shlex
import sys
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import PackageNotFoundError, requires, version
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType

from brdf_suite.errors import ExtraError, MissingExtraError


@dataclass(frozen=True)
class _Package:
    """An optional package: its display name, its name in package indexes, and its extra."""

    title: str
    distribution: str
    extra: str


PACKAGES = {
    "mitsuba": _Package("Mitsuba", "mitsuba", "reference"),
    "drjit": _Package("Dr.Jit", "drjit", "reference"),
    "flip_evaluator": _Package("FLIP", "flip-evaluator", "reference"),
    "cv2": _Package("OpenCV", "opencv-python-headless", "acquisition"),
    "rawpy": _Package("rawpy", "rawpy", "acquisition"),
    "numba": _Package("numba", "numba", "acquisition"),
    "DracoPy": _Package("DracoPy", "dracopy", "meshes"),
    "assimp_py": _Package("Assimp (assimp-py)", "assimp-py", "meshes"),
    "cascadio": _Package("Open CASCADE (cascadio)", "cascadio", "meshes"),
    "pxr": _Package("OpenUSD (usd-core)", "usd-core", "meshes"),
    "dask": _Package("Dask", "dask", "batches"),
    "dask_jobqueue": _Package("Dask-Jobqueue", "dask-jobqueue", "batches"),
    "distributed": _Package("Dask", "distributed", "batches"),
    "pyarrow": _Package("Arrow (pyarrow)", "pyarrow", "batches"),
    "imageio_ffmpeg": _Package("ffmpeg (imageio-ffmpeg)", "imageio-ffmpeg", "video"),
}
"""The optional modules, by the name that they are imported by."""

_SYSTEM_LIBRARY = re.compile(r"(\S+): cannot open shared object file")


def import_extra(name: str, *, purpose: str, instead: str = "") -> ModuleType:
    """Return an optional module.

    Parameters
    ----------
    name
        One of :data:`PACKAGES`.
    purpose
        What the module is needed for: a noun in the singular, as in "path tracing".
    instead
        What works without it, as a main clause: "a folder of PNG pictures needs nothing more".

    Raises
    ------
    MissingExtraError
        The package is not installed; the message has the command that installs it here.
    ExtraError
        It is installed, but too old or cannot be loaded.
    """
    loaded = sys.modules.get(name)
    # Another thread may be in the middle of the import, for which import_module waits.
    if loaded is not None and not getattr(loaded.__spec__, "_initializing", False):
        return loaded
    check_extra(name, purpose=purpose, instead=instead)
    try:
        module = import_module(name)
    except Exception as error:  # libraries fail to load with errors of many kinds
        library = _SYSTEM_LIBRARY.search(str(error))
        if library is not None:
            way = f"install the system library {library[1]} with the package manager of this system"
        else:
            way = _sentence_end(name, " again", instead, again=True)
        reason = " ".join(str(error).split()).rstrip(".") or type(error).__name__
        raise ExtraError(
            f"{purpose} needs {PACKAGES[name].title}, which is installed but cannot be loaded ({reason}); {way}"
        ) from error
    _leave_working_folder(module)
    return module


def _leave_working_folder(module: ModuleType) -> None:
    """Let a library load no code of the working folder.

    Mitsuba looks for the libraries of its plug-ins there first. numba reads settings there when it is imported, which
    may name a folder of compiled code; they are dropped.
    """
    if module.__name__ == "mitsuba":
        places = module.file_resolver()
        places.clear()
        places.append(str(Path(str(module.__file__)).parent))
    elif module.__name__ == "numba":
        settings = import_module("numba.core.config")
        settings._config_fname = os.devnull  # type: ignore[attr-defined]  # there is no public way
        settings.reload_config()


def check_extra(name: str, *, purpose: str, instead: str = "") -> None:
    """Raise as :func:`import_extra` where a package is missing or too old, without importing it."""
    package = PACKAGES[name]
    if not _is_there(name):
        if _is_frozen():
            raise MissingExtraError(
                f"{purpose} needs {package.title}, which this build of BRDF Suite does not contain"
                + (f"; {instead}" if instead else "")
            )
        if not _is_published(package):
            version_here = ".".join(map(str, sys.version_info[:2]))
            raise MissingExtraError(
                f"{purpose} needs {package.title}, which is not published for Python {version_here}"
                + (f"; {instead}" if instead else "")
            )
        raise MissingExtraError(
            f"{purpose} needs {package.title}, which is not installed; {_sentence_end(name, '', instead)}"
        )
    oldest, found = _oldest_version(package), _installed_version(package)
    if found and _numbers(found) < _numbers(oldest):
        raise ExtraError(
            f"{purpose} needs {package.title} {oldest} or later, and {found} is installed; "
            + _sentence_end(name, " in a newer version", instead)
        )


def requirements(extra: str) -> list[str]:
    """Return what an extra consists of, as package installers take it: ``["imageio-ffmpeg>=0.6"]``."""
    return [what for what, condition in _declared(extra) if _is_for_this_python(condition)]


def _declared(extra: str) -> list[tuple[str, str]]:
    """Return the requirements of an extra with their conditions, for any version of Python."""
    marker = re.compile(rf"extra *== *[\"']{re.escape(extra)}[\"']")
    try:
        lines = [line.partition(";") for line in requires("brdf-suite") or ()]
    except PackageNotFoundError:  # the source itself, on PYTHONPATH
        return []
    return [(what.strip(), condition) for what, _, condition in lines if marker.search(condition)]


def _is_published(package: _Package) -> bool:
    """Whether the extra has the package for this version of Python."""
    named = [
        condition for what, condition in _declared(package.extra) if what.startswith(package.distribution)
    ]
    return not named or any(map(_is_for_this_python, named))


def _is_for_this_python(condition: str) -> bool:
    """Whether a requirement's marker allows this version of Python: some packages are not published for new ones."""
    limit = re.search(r"python_version *< *[\"'](\d+)\.(\d+)", condition)
    return limit is None or sys.version_info[:2] < (int(limit[1]), int(limit[2]))


def install_command(extra: str, *, again: bool = False) -> str:
    """Return the command line that adds an extra to the environment in which this process runs.

    ``again``: also where it is installed already. The program of a checkout mends what it finds incomplete anyway.
    """
    checkout = Path(__file__).resolve().parent.parent
    run = checkout / "packaging" / "run.py"
    if run.is_file() and Path(sys.prefix).resolve() == (checkout / ".venv").resolve():
        return _command_line(["python" if os.name == "nt" else "python3", str(run), "--with", extra])
    if find_spec("pip") is not None:
        pip = [sys.executable, "-m", "pip", "install", *(["--force-reinstall"] if again else [])]
        return _command_line([*pip, *requirements(extra)])
    uv = ["uv", "pip", "install", "--python", sys.executable, *(["--reinstall"] if again else [])]
    return _command_line([*uv, *requirements(extra)])


def _sentence_end(name: str, how: str, instead: str, *, again: bool = False) -> str:
    if _is_frozen():
        return instead or "install BRDF Suite again"
    command = f"`{install_command(PACKAGES[name].extra, again=again)}` installs it{how}"
    return f"{command}, and {instead}" if instead else command


def _is_there(name: str) -> bool:
    try:
        spec = find_spec(name)
    except (ImportError, ValueError):  # ValueError: a stand-in without a specification
        return False
    return (
        spec is not None and spec.origin is not None
    )  # no origin: a folder that an uninstalled package left


def _is_frozen() -> bool:
    return bool(getattr(sys, "frozen", False))  # set by the programs that make one file of a Python program


def _oldest_version(package: _Package) -> str:
    """Return the oldest version that the extra allows, "" where it states none."""
    for line in requirements(package.extra):
        stated = re.fullmatch(rf"{re.escape(package.distribution)} *>= *([\d.]+).*", line)
        if stated is not None:
            return stated[1]
    return ""


def _installed_version(package: _Package) -> str:
    """Return the version that is installed; "" where the module came in another package, as OpenCV's may."""
    try:
        return version(package.distribution)
    except PackageNotFoundError:
        return ""


def _numbers(text: str) -> tuple[int, ...]:
    """Return the leading numbers of a version.

    >>> _numbers("3.10.1rc2"), _numbers("3.7") < _numbers("3.10"), _numbers("")
    ((3, 10, 1), True, ())
    """
    leading = re.match(r"\d+(?:\.\d+)*", text)
    return tuple(int(number) for number in leading[0].split(".")) if leading else ()


def _command_line(words: list[str]) -> str:
    if os.name == "nt":  # neither of its shells knows single quotes as POSIX does
        return " ".join(word if re.fullmatch(r"[\w.\\/:-]+", word) else f'"{word}"' for word in words)
    return shlex.join(words)
