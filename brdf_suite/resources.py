"""Locations of the packaged resources: paints, environments, meshes, tables.

A wheel holds them inside ``brdf_suite``; a checkout (and an editable install) has them in ``resources/`` at
its top. Both are found, and nothing else in the suite knows the difference.
"""

from __future__ import annotations

from pathlib import Path

from brdf_suite.errors import FileError

_PACKAGE = Path(__file__).resolve().parent
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
