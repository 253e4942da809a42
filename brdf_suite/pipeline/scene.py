"""What a scene is made of, by packaged name or by file: paint, environment with its maps, surface, view."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import AnyPaint, load_any_paint, load_paint
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError
from brdf_suite.fitting.basis import LobeBasis, default_basis
from brdf_suite.lighting.cache import MapCache
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.prefilter import LobeMaps
from brdf_suite.progress import Progress, part, report
from brdf_suite.resources import resource, resource_names
from brdf_suite.surface.mesh import Mesh

_PAINT_ENDING = ".brdfpaint"
_READING_SHARE = 0.1


def paint_names() -> list[str]:
    """Names of the shipped paints, sorted."""
    return resource_names("paints", _PAINT_ENDING)


def environment_names() -> list[str]:
    """Names of the shipped environments, sorted."""
    return resource_names("environments", ".exr")


def surface_names() -> list[str]:
    """Names of the shipped surfaces, sorted."""
    return resource_names("meshes", ".glb")


def name_in_view(name_or_path: str | os.PathLike[str], shipped: list[str]) -> str:
    """Return what a View holds for a shipped name or a file: the name as it is, the file by its absolute path."""
    text = os.fspath(name_or_path)
    return text if text in shipped else str(Path(text).absolute())


def default_paint_name() -> str:
    """The paint that a new user sees first."""
    return "blue"


def default_view() -> View:
    """The view that a new user sees first."""
    return View()


def load_shipped_paint(name: str) -> Paint:
    """Return the packaged paint ``name``; :class:`FileError` where there is none."""
    return load_paint(resource("paints", name + _PAINT_ENDING))


def default_paint() -> Paint:
    """Return the paint that a new user sees first."""
    return load_shipped_paint(default_paint_name())


def find_paint(name_or_path: str | os.PathLike[str]) -> Paint:
    """Return a paint of aspecular readings by packaged name or by file.

    Raises
    ------
    FileError
        It is neither; the message lists the shipped paints.
    DocumentError
        The file is no valid paint, or one of another kind; the message says where.
    """
    if os.fspath(name_or_path) in paint_names():
        return load_shipped_paint(os.fspath(name_or_path))
    _refuse_missing_paint(name_or_path, paint_names())
    return load_paint(name_or_path)


def find_any_paint(name_or_path: str | os.PathLike[str]) -> AnyPaint:
    """Return a paint of any kind by packaged name, by its name in Table 1, or by file; errors as :func:`find_paint`."""
    from brdf_suite.reflectance.models.table_1 import TABLE_1

    name = os.fspath(name_or_path)
    if name in TABLE_1:
        return TABLE_1[name]
    if name in paint_names():
        return load_shipped_paint(name)
    _refuse_missing_paint(name_or_path, [*paint_names(), *TABLE_1])
    return load_any_paint(name_or_path)


def _refuse_missing_paint(name_or_path: str | os.PathLike[str], shipped: list[str]) -> None:
    if not Path(name_or_path).exists():
        raise FileError(
            name_or_path, f"there is no such file, nor a shipped paint of that name ({', '.join(shipped)})"
        )


@dataclass(frozen=True, eq=False)
class PreparedEnvironment:
    """An environment with its prefiltered maps, ready to be shown. ``name`` is what the user called it."""

    name: str
    environment: Environment
    maps: LobeMaps
    from_cache: bool

    def to_json(self) -> dict[str, object]:
        """Return what it is, as plain values."""
        rows, columns = self.environment.radiance.shape[:2]
        return {
            "environment": self.name,
            "width": columns,
            "height": rows,
            "exponents": [float(e) for e in self.maps.exponents],
            "face_sizes": [int(lobe.faces.shape[1]) for lobe in self.maps.lobes],
            "from_cache": self.from_cache,
            "notes": list(self.environment.notes),
        }


def load_environment(
    name_or_path: str | os.PathLike[str],
    progress: Progress | None = None,
    *,
    basis: LobeBasis | None = None,
    cache: MapCache | None = None,
) -> PreparedEnvironment:
    """Read an environment and prefilter it for ``basis``, or take its maps from the cache.

    Parameters
    ----------
    name_or_path
        A packaged name (``booth``, ``sunny``, ``overcast``) or an ``.exr`` or ``.hdr`` lat-long file.

    Raises
    ------
    FileError
        There is no such environment, or its file cannot be read; the message says why.
    Cancelled
        The progress callback asked for it.
    """
    from brdf_suite.files.images import read_environment_image

    name = os.fspath(name_or_path)
    path = resource("environments", name + ".exr") if name in environment_names() else Path(name)
    if not path.exists():
        raise FileError(
            name,
            f"there is no such file, nor a shipped environment of that name ({', '.join(environment_names())})",
        )
    report(progress, 0.0, f"reading {path.name}")
    image = read_environment_image(path)
    environment = Environment(path.stem, image.pixels, image.notes)
    exponents = (basis or default_basis()).exponents
    store = cache or MapCache()
    filtered: list[float | None] = []
    maps = store.get_or_compute(
        environment,
        exponents,
        part(progress, _READING_SHARE, 1.0),
        ready=lambda exponent, _faces: filtered.append(exponent),
    )
    return PreparedEnvironment(name, environment, maps, from_cache=not filtered)


def load_surface(name_or_path: str | os.PathLike[str]) -> Mesh:
    """Return a surface by packaged name or by file.

    Raises
    ------
    FileError
        There is no such surface, or its file cannot be read; the message says why.
    """
    name = os.fspath(name_or_path)
    path = resource("meshes", name + ".glb") if name in surface_names() else Path(name)
    if not path.exists():
        raise FileError(
            name, f"there is no such file, nor a shipped surface of that name ({', '.join(surface_names())})"
        )
    from brdf_suite.files.meshes import read_mesh

    return read_mesh(path)
