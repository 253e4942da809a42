"""Pictures of anything that reflects, and environments as the lobes see them."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal, TypeAlias, cast, get_args

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.bounded_reading import most_made_bytes
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.files.images.pictures import read_rgb
from brdf_suite.library.subjects import Subject, material_for
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.lobe_maps import LobeMaps
from brdf_suite.lighting.filter.lobe_maps import prefilter as filter_environment
from brdf_suite.output.still import render_to_file
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.scene import (
    default_view,
    environment_names,
    find_environment,
    find_surface,
    in_environment,
    map_exponents,
    name_in_view,
    surface_names,
)
from brdf_suite.progress import Progress

RendererName = Literal["realtime", "reference", "raytraced"]
SMALLEST, LARGEST = 1, 65_536
_PNG = ".png"
_NO_WORD = re.compile(r"[^A-Za-z0-9_\-]+")

Light: TypeAlias = Environment | str | os.PathLike[str] | npt.ArrayLike
"""An environment; its shipped name or file; or radiance (h, w, 3), a latitude-longitude map."""


@dataclass(frozen=True, eq=False)
class Rendering:
    """A picture that was rendered; notebooks show it, and ``numpy.asarray`` makes an array of it.

    Attributes
    ----------
    path
        The file that was written; None where it is in memory alone.
    content
        The bytes of the PNG or EXR.
    notices
        Sentences about what was drawn.

    >>> import brdf_suite as bs
    >>> picture = bs.render("blue", size=(32, 24), surface="sphere", environment="overcast")
    >>> picture.pixels.shape, str(picture.pixels.dtype), picture.notices
    ((24, 32, 3), 'uint8', ())
    """

    path: Path | None
    content: bytes
    ending: str
    notices: tuple[str, ...] = ()

    @cached_property
    def pixels(self) -> NDArray[Any]:
        """The picture (h, w, 3), top row first: uint8, sRGB; of an EXR float32, radiance, linear Rec. 2020."""
        if self.ending == _PNG:
            return read_rgb(
                self.path or "the picture", ("PNG",), content=self.content, most_bytes=most_made_bytes()
            )
        with TemporaryDirectory() as folder:
            file = Path(folder, "picture.exr")
            file.write_bytes(self.content)
            return read_environment_image(file).pixels

    def __array__(self, dtype: npt.DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return :attr:`pixels`."""
        return np.array(self.pixels, dtype=dtype, copy=copy)

    def save(self, path: PathLike) -> None:
        """Write ``path``, of the :attr:`ending` that the picture has, whole or not at all.

        Raises :class:`FileError`: it has another ending, or the disk refuses.

        >>> import brdf_suite as bs, tempfile, pathlib
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "blue.png"
        >>> bs.render("blue", size=(32, 24), surface="sphere", environment="overcast").save(file)
        >>> file.read_bytes()[1:4]
        b'PNG'
        """
        if Path(path).suffix.lower() != self.ending:
            raise FileError(
                path, f"this picture is {self.ending[1:].upper()}; give a name that ends in {self.ending}"
            )
        write_atomically(path, self.content)

    def _repr_png_(self) -> bytes | None:
        return self.content if self.ending == _PNG else None


def render(
    subject: Subject,
    path: PathLike | None = None,
    *,
    size: tuple[int, int] = (640, 360),
    environment: Light | None = None,
    surface: PathLike | None = None,
    view: View | None = None,
    exposure_ev: float | None = None,
    azimuth_deg: float | None = None,
    elevation_deg: float | None = None,
    rotation_deg: float | None = None,
    renderer: RendererName = "realtime",
    samples: int | None = None,
    progress: Progress | None = None,
) -> Rendering:
    """Render a subject on a surface in an environment, to an array and, where a path is given, to a file.

    Parameters
    ----------
    subject
        A name, a file, a paint, a material, a fit, :func:`samples`, or anything with ``eval``. A lobe fit is drawn as
        it is; of all else lobes are fitted.
    path
        A ``.png``, as a screen shows it, or an ``.exr``, radiance before exposure and tone curve; None: no file.
    size
        (width, height) in pixels, each 1 to 65,536.
    environment
        One of ``names("environments")``; an ``.exr``, ``.hdr`` or ``.brdfstudio`` file; an :class:`Environment`; or
        radiance (h, w, 3), as of :func:`prefilter`. Default: the photo studio.
    surface
        One of ``names("surfaces")``, or a ``.glb``, ``.gltf``, ``.obj``, ``.stl`` or ``.ply`` mesh in metres; default:
        the speed form.
    view
        Everything else of the scene, which the other arguments change; ``load("x.brdfview", View)`` reads one.
    exposure_ev
        +1 doubles the light.
    azimuth_deg, elevation_deg
        Of the camera about the object, degrees; the elevation is -90 to 90.
    rotation_deg
        Of the light about the vertical, degrees, counter-clockwise seen from above.
    renderer
        ``realtime`` (OpenGL 3.3); ``reference``, path-traced, of the extra ``reference``; or ``raytraced``, the
        car-paint ray tracer of Günther et al. 2005.
    samples
        A pixel, of the two that trace; 1 to 1,000,000.

    Raises
    ------
    SuiteError
        As :func:`load`; the environment or the surface is not there, a number is out of its range, there is no OpenGL
        3.3, or the picture cannot be written.

    >>> import brdf_suite as bs
    >>> bs.render("blue", size=(32, 24), surface="sphere", environment="overcast").pixels.shape
    (24, 32, 3)

    Light that is made in memory, even over the sphere:

    >>> import numpy as np
    >>> bs.render("blue", size=(32, 24), surface="sphere", environment=np.ones((32, 64, 3))).pixels.shape
    (24, 32, 3)
    """
    if renderer not in get_args(RendererName):
        expected = ", ".join(get_args(RendererName))
        raise ValueRangeError("renderer", f"expected one of {expected}, not {renderer!r}")
    if renderer == "realtime" and samples is not None:
        raise ValueRangeError("samples", "are for renderer='reference' and 'raytraced'")
    for number, side in enumerate(size):
        if not SMALLEST <= side <= LARGEST:
            raise ValueRangeError(f"size[{number}]", f"expected {SMALLEST} to {LARGEST:,} pixels, not {side}")
    light = _in_memory(environment)
    seen = _view(view, environment, light, surface)
    camera = seen.camera
    camera = camera if azimuth_deg is None else replace(camera, azimuth_deg=azimuth_deg)
    camera = camera if elevation_deg is None else replace(camera, elevation_deg=elevation_deg)
    seen = replace(
        seen,
        camera=camera,
        exposure_ev=seen.exposure_ev if exposure_ev is None else exposure_ev,
        rotation_deg=seen.rotation_deg if rotation_deg is None else rotation_deg,
    )
    if path is not None:
        notices = _rendered(subject, seen, light, size, Path(path), renderer, samples, progress)
        return Rendering(Path(path), Path(path).read_bytes(), Path(path).suffix.lower(), notices)
    with TemporaryDirectory() as folder:
        file = Path(folder, "picture.png")
        notices = _rendered(subject, seen, light, size, file, renderer, samples, progress)
        return Rendering(None, file.read_bytes(), _PNG, notices)


def _rendered(
    subject: Subject,
    view: View,
    light: Environment | None,
    size: tuple[int, int],
    path: Path,
    renderer: RendererName,
    samples: int | None,
    progress: Progress | None,
) -> tuple[str, ...]:
    """Write a picture, and return what is to be said of it."""
    if renderer == "realtime":
        drawn = subject if isinstance(subject, LobeFit) else material_for(subject)
        return render_to_file(drawn, view, size, path, environment=light, progress=progress).notices
    material = material_for(subject)
    if renderer == "reference":
        from brdf_suite.tracing.reference.picture import render_reference  # Mitsuba is optional

        return render_reference(
            material, view, size, path, samples=samples, environment=light, progress=progress
        ).notices
    from brdf_suite.tracing.raytraced.file import render_raytraced  # for its own kernels

    return render_raytraced(
        material, view, size, path, samples=samples, environment=light, progress=progress
    ).notices


def _in_memory(environment: Light | None) -> Environment | None:
    """Return an environment that is no name and no file."""
    if environment is None or isinstance(environment, (Environment, str, os.PathLike)):
        return environment if isinstance(environment, Environment) else None
    return Environment("light", np.asarray(environment))


def _view(
    view: View | None, environment: Light | None, light: Environment | None, surface: PathLike | None
) -> View:
    """Return the view with an environment and a surface; errors as of what finds these."""
    seen = default_view() if view is None else view
    if light is not None:
        # A view holds a word: the name under which a program that reads the picture's view says that it is missing.
        seen = in_environment(seen, _NO_WORD.sub("_", light.name)[:100].strip("_-") or "light")
    elif environment is not None:
        named = cast(PathLike, environment)
        find_environment(named)
        seen = in_environment(seen, name_in_view(named, environment_names()))
    if surface is not None:
        find_surface(surface)
        seen = replace(seen, surface=name_in_view(surface, surface_names()))
    return seen


def prefilter(
    environment: Light,
    exponents: Sequence[float] | None = None,
    *,
    progress: Progress | None = None,
) -> LobeMaps:
    """Filter an environment with cosine lobes: one cube map for each exponent.

    Parameters
    ----------
    environment
        An :class:`Environment`; a shipped name, or an ``.exr``, ``.hdr`` or ``.brdfstudio`` file; or radiance
        (h, w, 3), a latitude-longitude map, linear Rec. 2020, row 0 up, finite, not negative.
    exponents
        Numbers above 0, in any order; left out, those that pictures are drawn with.
    progress
        Called with a share, 0 to 1, and a sentence; it may raise ``brdf_suite.errors.Cancelled``.

    Returns
    -------
    LobeMaps
        ``lobes`` has a map for each of ``exponents``, unit gain, and ``diffuse`` irradiance over π;
        ``radiance()`` of a map is (6, n, n, 3), faces +x, -x, +y, -y, +z, -z.

    Raises
    ------
    SuiteError
        There is no such environment, its values are not as above, or an exponent is not above 0.

    >>> import brdf_suite as bs, numpy as np
    >>> maps = bs.prefilter(np.ones((64, 128, 3), np.float32), [20.0])
    >>> maps.lobes[0].radiance().shape, float(maps.lobes[0].radiance().max().round(3))
    ((6, 64, 64, 3), 1.0)
    """
    light = _in_memory(environment)
    if light is None:
        light = read_environment(find_environment(cast(PathLike, environment))[1])
    return filter_environment(light, map_exponents() if exponents is None else exponents, progress)
