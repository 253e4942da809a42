"""What a scene is made of besides its paint, by packaged name or by file: environment with its maps, surface, view."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from brdf_suite.documents.studio import LightDocument
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.lighting.environment import SMALL_COLUMNS, Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps, PartialMaps, Ready, prefilter
from brdf_suite.lighting.lights.glinting import GlintLights, glint_lights
from brdf_suite.lighting.lobe_map_cache import MapCache
from brdf_suite.pipeline.environments import AUTOMATIC, draw_light, read_environment
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.environment.ladder import BROADEST_SHARP
from brdf_suite.regular_files import exists
from brdf_suite.resources import check_exists, packaged_name, resource, resource_names
from brdf_suite.surface.mesh import Mesh

STACK_RATIO = 1.35
"""Between neighbouring slices of the stack: a mixture of the two errs by .5 % of the lobe's peak at most."""

STACK_EXPONENTS: tuple[float, ...] = tuple(float(STACK_RATIO**i) for i in range(16))
"""1 (the diffuse map) to 90.2: the broad lobes of the default basis, and what they are looked up as."""

_READING_SHARE, _DRAWING_SHARE = 0.1, 0.3
_WORD = re.compile(r"[A-Za-z0-9][A-Za-z0-9_\-]{0,99}")  # what a View takes for the name of a packaged one


_STUDIO, _STUDIO_EV = "photo_studio", 0.5
_ORDER = ("photo_studio", "street", "light_tunnel", "booth", "overcast", "sunny")


def environment_names() -> list[str]:
    """Names of the shipped environments: the traced scenes first, then the plain lights."""
    shipped = resource_names("environments", ".exr")
    return sorted(shipped, key=lambda name: (_ORDER.index(name) if name in _ORDER else len(_ORDER), name))


def surface_names() -> list[str]:
    """Names of the shipped surfaces, sorted."""
    return resource_names("meshes", ".glb")


def name_in_view(name_or_path: str | os.PathLike[str], shipped: list[str]) -> str:
    """Return what a View holds for a shipped name (in any letter case) or a file: the name, the absolute path.

    A word that is neither stays as it was typed: the function that opens it raises the error.
    """
    text = os.fspath(name_or_path)
    name = packaged_name(text, shipped)
    if name is None and _WORD.fullmatch(text) and not exists(text):
        return text
    return name or str(Path(text).absolute())


def default_view(environment: str = View.environment) -> View:
    """The view that a new user sees first, or sees first in another environment.

    The studio is a backdrop: it is shown out of focus, and exposed for the object before it.
    """
    view = View(environment=environment, glare="eye", surface_look=SurfaceLook(ground=True))
    return replace(view, background="blurred", exposure_ev=_STUDIO_EV) if environment == _STUDIO else view


def in_environment(view: View, environment: str) -> View:
    """Return the view in another environment: background and exposure follow where they were as one begins with."""
    before, after = default_view(view.environment), default_view(environment)
    background = after.background if view.background == before.background else view.background
    ev = after.exposure_ev if view.exposure_ev == before.exposure_ev else view.exposure_ev
    return replace(view, environment=environment, background=background, exposure_ev=ev)


def find_environment(name_or_path: str | os.PathLike[str]) -> tuple[str, Path]:
    """Return an environment's name, as the user knows it, and its file.

    Raises :class:`SuiteError` about what the user typed where it names no environment.
    """
    name = os.fspath(name_or_path)
    shipped = packaged_name(name, environment_names())
    if shipped is None:
        check_exists(name, "environment", environment_names())
        return name, Path(name)
    return shipped, resource("environments", shipped + ".exr")


def find_surface(name_or_path: str | os.PathLike[str]) -> Path:
    """Return the file of a surface; raise :class:`SuiteError` about what the user typed where it names none."""
    name = os.fspath(name_or_path)
    shipped = packaged_name(name, surface_names())
    if shipped is None:
        check_exists(name, "surface", surface_names())
        return Path(name)
    return resource("meshes", shipped + ".glb")


@dataclass(frozen=True, eq=False)
class PreparedEnvironment:
    """An environment with its prefiltered maps, ready to be shown.

    ``name`` is what the user called it; ``notices`` say what went wrong with the cache, which costs only time.
    ``missing`` counts the maps, of ``wanted``, that are still being filtered; the nearest ones stand in for them.
    A ``draft`` is a rougher picture of a light that is being edited.
    """

    name: str
    environment: Environment
    maps: LobeMaps
    from_cache: bool
    notices: tuple[str, ...] = ()
    missing: int = 0
    wanted: int = 0
    draft: bool = False

    @cached_property
    def glint_lights(self) -> GlintLights:
        """Its lights in which single flakes glint; found at the first call, in about a tenth of a second."""
        return glint_lights(self.environment)

    @property
    def is_final(self) -> bool:
        """Whether every lobe has its own map, and the light is as it will stay."""
        return self.missing == 0 and not self.draft

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
            "notes": [*self.environment.notes, *self.notices],
        }


Partial = Callable[[PreparedEnvironment], None]
"""Called with an environment whose sharp maps are still being filtered."""


def load_environment(
    source: str | os.PathLike[str] | Environment,
    progress: Progress | None = None,
    *,
    layout: str = AUTOMATIC,
    columns: int | None = None,
    basis: LobeBasis | None = None,
    cache: MapCache | None = None,
    partial: Partial | None = None,
) -> PreparedEnvironment:
    """Read an environment and prefilter it for ``basis``, or take its maps from the cache.

    Parameters
    ----------
    source
        A packaged name (``photo_studio``, ``street``, ``booth`` …), an ``.exr`` or ``.hdr`` file, or a ``.brdfstudio``
        file, which is drawn; or an environment in memory.
    layout
        How the image is laid out, where its shape does not determine it; see :func:`read_environment`.
    columns
        A wider light is averaged to about so many columns, for small pictures; see :func:`narrowed`.
    partial
        Called, on the same thread, as soon as there is something to show: the diffuse map, the broad lobes and the
        background; then after each sharper map. Where the maps of small pictures came with the programs, it is called
        with those at once, and not again. Never where the maps come from the cache.

    Raises
    ------
    FileError
        There is no such environment, or its file cannot be read; the message says why.
    Cancelled
        The progress callback asked for it.
    """
    if isinstance(source, Environment):
        name, environment = source.name, source
    else:
        name, path = find_environment(source)
        report(progress, 0.0, f"reading {path.name}")
        environment = read_environment(path, layout, subrange(progress, 0.0, _READING_SHARE))
    if columns is not None:
        environment = narrowed(environment, columns)
    store = cache or MapCache()
    before = len(store.notices)
    if partial is not None:
        small = _shipped_small(name, environment, store, map_exponents(basis))
        if small is not None:
            partial(small)
            partial = None
    prepared = prepare_environment(
        name, environment, store.get_or_compute, subrange(progress, _READING_SHARE, 1.0), basis, partial
    )
    return replace(prepared, notices=tuple(store.notices[before:]))


def _shipped_small(
    name: str, environment: Environment, store: MapCache, exponents: tuple[float, ...]
) -> PreparedEnvironment | None:
    """Return an environment with the maps of small pictures that came with the programs; None where it needs none."""
    if store.holds(environment, exponents):
        return None
    small = narrowed(environment, SMALL_COLUMNS)
    maps = None if small is environment else store.shipped(small, exponents)
    count = len(exponents)
    if maps is None:
        return None
    return PreparedEnvironment(name, environment, maps, True, missing=count, wanted=count)


def narrowed(environment: Environment, columns: int) -> Environment:
    """Return a lat-long light of at most ``columns`` columns: the mean of whole blocks, so no light is lost.

    Rows of a lat-long image differ in solid angle by cos(elevation); within a block of a few rows that is the same
    to below a percent, except at the poles, whose rows hold next to nothing. An image that cannot be divided into
    whole blocks stays as it is.
    """
    rows, width = environment.radiance.shape[:2]
    block = width // columns
    if block < 2 or rows % block or width % block:
        return environment
    split = environment.radiance.reshape(rows // block, block, width // block, block, 3)
    return replace(environment, radiance=split.mean((1, 3)).astype(np.float32))


Filter = Callable[[Environment, Sequence[float], Progress | None, Ready | None], LobeMaps]
"""What makes the maps: :func:`brdf_suite.lighting.filter.lobe_maps.prefilter`, or a cache before it."""


def map_exponents(basis: LobeBasis | None = None) -> tuple[float, ...]:
    """Return the exponents, rising: the stack's, and those of ``basis`` that are too sharp for it.

    >>> from brdf_suite.fitting.lobes.basis import LobeBasis
    >>> map_exponents(LobeBasis((3.0, 500.0)))[-2:]
    (90.15..., 500.0)
    """
    sharp = tuple(sorted(e for e in (basis or default_basis()).exponents if e > BROADEST_SHARP))
    return STACK_EXPONENTS + sharp


def prepare_environment(
    name: str,
    environment: Environment,
    make: Filter,
    progress: Progress | None = None,
    basis: LobeBasis | None = None,
    partial: Partial | None = None,
) -> PreparedEnvironment:
    """Have an environment's maps made for ``basis``; ``partial`` as for :func:`load_environment`."""
    exponents = map_exponents(basis)
    so_far = PartialMaps(environment, exponents)

    def ready(exponent: float | None, faces: FaceArray) -> None:
        so_far.add(exponent, faces)
        maps = so_far.maps() if partial is not None and so_far.made < so_far.wanted else None
        if partial is not None and maps is not None:
            missing = so_far.wanted - so_far.made
            partial(
                PreparedEnvironment(name, environment, maps, False, missing=missing, wanted=so_far.wanted)
            )

    maps = make(environment, exponents, progress, ready)
    return PreparedEnvironment(name, environment, maps, so_far.made == 0, wanted=so_far.wanted)


def prepare_light(
    light: LightDocument,
    progress: Progress | None = None,
    partial: Partial | None = None,
    *,
    draft: bool = False,
    basis: LobeBasis | None = None,
) -> PreparedEnvironment:
    """Draw and filter a light that is in no file yet, past the cache: its versions would drive out what is used.

    A draft never says that it is final; ``basis`` and ``partial`` as for :func:`load_environment`.
    """
    made = draw_light(light, subrange(progress, 0.0, _DRAWING_SHARE), draft=draft)

    def hand_out(value: PreparedEnvironment) -> None:
        if partial is not None:
            partial(replace(value, draft=draft))

    environment = Environment(light.name, made.radiance, (made.comment.rstrip("."),))
    prepared = prepare_environment(
        light.name, environment, prefilter, subrange(progress, _DRAWING_SHARE, 1.0), basis, hand_out
    )
    return replace(prepared, draft=draft)


def load_surface(name_or_path: str | os.PathLike[str], look: SurfaceLook | None = None) -> Mesh:
    """Return a surface by packaged name or by file, in the unit, axis and fineness of ``look`` (see :func:`read_mesh`).

    Raises :class:`FileError`: there is no such surface, or its file cannot be read; the message says why.
    """
    look = look or SurfaceLook()
    return read_mesh(find_surface(name_or_path), look.unit, look.up, look.tessellation_mm)
