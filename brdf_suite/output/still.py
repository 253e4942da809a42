"""A paint by name or file, in a view, to a picture file: all that is loaded for it, and what came of it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path
from time import perf_counter

import numpy as np

from brdf_suite.documents.atomic import check_target
from brdf_suite.documents.view import View
from brdf_suite.errors import PathLike
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps
from brdf_suite.output.exposures import focused
from brdf_suite.output.picture_file import PictureSettings, picture_metadata, write_picture
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material, refit_under
from brdf_suite.pipeline.material import Material, load_material, under_illuminant
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import PreparedEnvironment, find_environment, load_environment
from brdf_suite.pipeline.surface import bake_or_explain, load_shaped
from brdf_suite.pipeline.surface_images import ImageRequest, load_surface_images
from brdf_suite.progress import Progress, report, stage, subrange
from brdf_suite.realtime.camera import compose
from brdf_suite.realtime.environment.textures import MIPMAPPED_FROM
from brdf_suite.surface.mesh import Mesh

_ROWS = 32


def with_smaller_maps(prepared: PreparedEnvironment, largest_face: int) -> PreparedEnvironment:
    """Return the environment with faces of at most ``largest_face`` texels, where halving leaves mip levels.

    A sharp lobe's map is far finer than the pixels of a small picture. What is left after a halving is what its next
    mip level would be, so a picture whose pixels ask for that level or a coarser one is the same.
    """
    made: dict[int, FaceArray] = {}

    def smaller(maps: FaceArray) -> FaceArray:
        # One map may serve several lobes, and goes to the graphics card once.
        known = id(maps.faces)
        if known not in made:
            made[known] = _halved(maps, largest_face)
        return FaceArray(made[known].faces, maps.scale)

    maps = prepared.maps
    return replace(
        prepared,
        maps=LobeMaps(
            maps.exponents,
            tuple(smaller(lobe) for lobe in maps.lobes),
            smaller(maps.diffuse),
            smaller(maps.through_coat),
            smaller(maps.background),
        ),
    )


def _halved(maps: FaceArray, largest_face: int) -> FaceArray:
    faces = maps.faces
    while faces.shape[1] > largest_face and faces.shape[1] % 2 == 0 and faces.shape[1] // 2 >= MIPMAPPED_FROM:
        half = faces.shape[1] // 2
        smaller = np.empty((6, half, half, 3), np.float16)
        for face, first in product(range(6), range(0, half, _ROWS)):
            # A few rows at a time: large maps shall not need much memory beside them.
            rows = faces[face, 2 * first : 2 * (first + _ROWS)].astype(np.float32)
            pairs = rows[0::2] + rows[1::2]
            smaller[face, first : first + _ROWS] = 0.25 * (pairs[:, 0::2] + pairs[:, 1::2])
        faces = smaller
    # The maps of a file share its bytes: a view of one of them would keep all.
    return FaceArray(faces if faces is not maps.faces else faces.copy(), maps.scale)


Size = tuple[int, int]


@dataclass(frozen=True)
class StillPicture:
    """A picture that was written, and what it shows. Times: fit and draw in ms, environment maps in s.

    ``delta_e_2000_worst`` is over a designed paint's own readings, over the usual aspecular angles of anything
    else that the fit looked at, and None where there is no such angle.
    """

    path: Path
    width: int
    height: int
    paint: str
    environment: str
    surface: str
    renderer: str
    fit_ms: float
    maps_s: float
    draw_ms: float
    time_limited: bool
    delta_e_2000_worst: float | None
    notices: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class LoadedScene:
    """A windowless scene with the light and the surface of a view; paints are shown in it one after the other."""

    scene: OffscreenScene
    prepared: PreparedEnvironment
    mesh: Mesh
    maps_s: float

    def composed(self, view: View, size: Size) -> View:
        """Return the view with the whole object in the middle of the picture, unless its camera is placed."""
        return replace(view, camera=compose(view.camera, self.scene.renderer.bounds, size))


@contextmanager
def loaded_scene(
    view: View,
    progress: Progress | None = None,
    *,
    columns: int | None = None,
    largest_face: int | None = None,
    fitting: FitSettings | None = None,
    environment: Environment | None = None,
) -> Iterator[LoadedScene]:
    """Load surface and environment of a view into a windowless scene, which goes with the block.

    An ``environment`` in memory takes the place of the view's. The light is filtered for the
    exponents of ``fitting``, and a second paint fitted as it says; the paints that are shown must be fitted so too.
    Where only small pictures are drawn, ``columns`` is how wide the light needs to be before it is filtered, and
    ``largest_face``, in texels, how fine its maps after that.
    Errors as :func:`render_to_file`.
    """
    mesh = load_shaped(view.surface, view.surface_look)
    with OffscreenScene() as scene:  # before the maps: without OpenGL they would be made for nothing
        start = perf_counter()
        source = environment or view.environment
        name = environment.name if environment else Path(find_environment(view.environment)[0]).stem
        light = stage(progress, 0.0, 0.6, f"preparing the light ({name})")
        prepared = load_environment(
            source,
            light,
            layout=view.environment_layout,
            columns=columns,
            basis=None if fitting is None else fitting.basis,
        )
        if largest_face is not None:
            prepared = with_smaller_maps(prepared, largest_face)
        maps_s = perf_counter() - start
        scene.set_environment(prepared)
        scene.prepare(view)
        scene.set_surface_images(load_surface_images(ImageRequest.of(view), settings=fitting))
        mesh, baked = bake_or_explain(mesh, view.surface_look, subrange(progress, 0.6, 1.0))
        scene.set_surface(mesh, baked)
        yield LoadedScene(scene, prepared, mesh, maps_s)


def render_to_file(
    paint: PathLike | Material | LobeFit,
    view: View,
    size: Size,
    path: PathLike,
    settings: PictureSettings | None = None,
    *,
    fitting: FitSettings | None = None,
    environment: Environment | None = None,
    progress: Progress | None = None,
) -> StillPicture:
    """Render a paint or measured file (by name or path), a material or a fit in a view; write it as PNG or EXR.

    ``fitting`` says how its lobes are fitted; left out: with the default basis and settings, or as a given fit was.
    ``environment``, one in memory, takes the place of the view's.

    Raises
    ------
    FileError
        The paint, environment or mesh cannot be read, or the picture not written.
    UnreachableError
        No such paint can have the gloss or colour that the document asks for.
    FittingError
        No lobes can be fitted to what was measured.
    GraphicsError
        There is no OpenGL 3.3.
    Cancelled
        The progress callback asked for it.
    """
    settings = settings or PictureSettings()
    target = Path(path)
    settings.of_file(target)
    check_target(target)
    if isinstance(paint, LobeFit):
        fit = refit_under(paint, view.light_colour)
        fitting = fitting or fit.settings
    else:
        material = paint if isinstance(paint, Material) else load_material(paint)
        fit = fit_material(under_illuminant(material, view.light_colour), fitting)
    with loaded_scene(view, subrange(progress, 0.0, 0.8), fitting=fitting, environment=environment) as loaded:
        loaded.scene.set_material(fit)
        start = perf_counter()
        # The metadata give the exposure that was measured, where it is automatic.
        shown = metered(loaded.scene.renderer, loaded.composed(view, size), size)
        shown = focused(shown, loaded.mesh, size)
        write_picture(
            loaded.scene.renderer,
            shown,
            size,
            target,
            settings,
            picture_metadata(fit, shown),
            stage(progress, 0.8, 1.0, "drawing"),
        )
        draw_ms = (perf_counter() - start) * 1e3
        renderer = str(loaded.scene.renderer.context.info["GL_RENDERER"])
    report(progress, 1.0, "written")
    return StillPicture(
        path=target,
        width=size[0],
        height=size[1],
        paint=fit.name,
        environment=loaded.prepared.environment.name,
        surface=loaded.mesh.name,
        renderer=renderer,
        fit_ms=fit.fit_seconds * 1e3,
        maps_s=loaded.maps_s,
        draw_ms=draw_ms,
        time_limited=fit.time_limited,
        delta_e_2000_worst=fit.worst_delta_e,
        notices=(*fit.notices, *loaded.prepared.environment.notes, *loaded.mesh.notes),
    )
