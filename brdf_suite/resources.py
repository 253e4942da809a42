"""Locations of the packaged resources: paints, environments, meshes, tables.

A wheel holds them inside ``brdf_suite``; a checkout (and an editable install) has them in ``resources/`` at
its top. Both are found, and nothing else in the suite knows the difference.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from brdf_suite.errors import FileError, SuiteError, did_you_mean
from brdf_suite.regular_files import exists

_PACKAGE = Path(__file__).resolve().parent
_FEW = 12
SCHEMA_ENDING = ".schema.json"
_CANDIDATES = (_PACKAGE / "_resources", _PACKAGE.parent / "resources")


def resource_root() -> Path:
    """Return the folder of packaged resources; raise :class:`FileError` where the install is damaged."""
    for candidate in _CANDIDATES:
        if candidate.is_dir():
            return candidate
    raise FileError(_CANDIDATES[0], "the packaged resources are missing; install brdf-suite again")


def resource(kind: str, name: str) -> Path:
    """Return the path of resource ``name`` (with its ending) in folder ``kind``.

    >>> resource("paints", "blue.brdfpaint").name
    'blue.brdfpaint'

    Raises
    ------
    FileError
        There is no such file; the message lists what there is.
    """
    folder = resource_root() / kind
    path = folder / name
    if not path.is_file() or path.parent != folder:
        known = ", ".join(sorted(p.name for p in folder.glob("*"))) if folder.is_dir() else "none"
        raise FileError(path, f"there is no such {kind.rstrip('s')} among the packaged ones ({known})")
    return path


def resource_names(kind: str, ending: str) -> list[str]:
    """Return the names, without ``ending`` and sorted, of the packaged files of a kind."""
    folder = resource_root() / kind
    return sorted(p.name.removesuffix(ending) for p in folder.glob(f"*{ending}"))


def schema_names() -> list[str]:
    """Return the names of the JSON Schemas of the suite's own formats."""
    return resource_names("schemas", SCHEMA_ENDING)


def packaged_name(text: str, names: Sequence[str]) -> str | None:
    """Return which of the packaged ``names`` is ``text``, in any letter case; a file of just that name goes first.

    A name in its own letter case is never a file. Raises :class:`FileError` where the file system refuses to look.
    """
    if text in names:
        return text
    name = {name.casefold(): name for name in names}.get(text.casefold())
    return None if name is None or exists(text) else name


def check_exists(asked: str, kind: str, names: Sequence[str]) -> None:
    """Raise an error about what the user typed where it is no file; ``names`` are the packaged ones of ``kind``."""
    if not asked:
        raise SuiteError(
            f"The name of the {kind} is empty; give a file or a shipped one ({_few(kind, names)})."
        )
    if not exists(asked):
        if Path(asked).suffix or Path(asked).is_absolute():
            # A file was meant: the names of what is shipped are no help.
            raise FileError(asked, "there is no such file")
        near = did_you_mean(asked, names) or f" ({_few(kind, names)})"
        raise FileError(asked, f"there is no such file, nor a shipped {kind} of that name{near}")


def _few(kind: str, names: Sequence[str]) -> str:
    """Return the names for a message, of many the command that lists them."""
    return ", ".join(names) if len(names) <= _FEW else f"`brdf-suite list {kind}s` names all {len(names)}"


def document_root() -> Path:
    """Return the folder of the documents; raise :class:`FileError` where the install is damaged."""
    for candidate in (_PACKAGE / "_documents", _PACKAGE.parent / "docs"):
        if candidate.is_dir():
            return candidate
    raise FileError(_PACKAGE / "_documents", "the documents are missing; install brdf-suite again")
