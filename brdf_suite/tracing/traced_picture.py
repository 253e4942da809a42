"""What both tracing renderers share: how a scene is read and identified, its facts, and the file that is written."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.glare import WIDEST_DEG, pixel_angle, spread_glare
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import SENSOR_WIDTH_MM, View
from brdf_suite.documents.view_settings import SECOND_PAINT
from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.files.bounded_reading import file_stamp
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.exposure import ev_of, exposed
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.scene import find_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.pictures.tone_curves import to_display
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.optics import load_lit

Size = tuple[int, int]
PAINT = "paint"
_T = TypeVar("_T")


@dataclass(frozen=True, eq=False, kw_only=True)
class SceneFacts:
    """A scene to be traced: ``view`` has its camera placed; what is traced of scenes with one ``key`` may be added."""

    name: str
    environment: str
    surface: str
    renderer: str
    notices: tuple[str, ...]
    view: View
    size: Size
    key: str

    def measure_exposure(self, radiance: Floats, coverage: Floats) -> View:
        """Return the view, its exposure measured where automatic by the object's light (h, w, 3) and share (h, w)."""
        if self.view.exposure_mode == "locked":
            return self.view
        return exposed(self.view, ev_of(np.concatenate((radiance, coverage[..., None]), axis=-1)))

    @staticmethod
    def show(radiance: Floats, view: View) -> NDArray[np.uint8]:
        """Return radiance (h, w, 3) before exposure as the real-time renderer would show it: sRGB codes (h, w, 3)."""
        exposed_light = np.asarray(radiance, float) * 2.0**view.exposure_ev
        if view.glare == "eye":
            angle = pixel_angle(view.camera.focal_length_mm, exposed_light.shape[1], SENSOR_WIDTH_MM)
            if angle < WIDEST_DEG:  # a pixel is wider than glare reaches in pictures of a few pixels alone
                exposed_light = spread_glare(exposed_light, angle)
        return np.asarray(to_display(exposed_light, 0.0, view.tone_curve), np.uint8)

    def file_facts(self, path: Path) -> dict[str, Any]:
        """Return what a :class:`TracedFile` takes from its scene."""
        names = ("environment", "surface", "renderer", "notices")
        facts = {name: getattr(self, name) for name in names}
        return facts | {"path": path, "width": self.size[0], "height": self.size[1], "paint": self.name}


@dataclass(frozen=True, kw_only=True)
class TracedFile:
    """A picture that was written; ``samples`` a pixel, ``resumed_samples`` of them from before."""

    path: Path
    width: int
    height: int
    paint: str
    environment: str
    surface: str
    renderer: str
    samples: int
    seconds: float
    resumed_samples: int
    notices: tuple[str, ...]


class Kept:
    """What was made last under each name; given again where it is made of the same."""

    def __init__(self) -> None:
        self._kept: dict[str, tuple[object, Any]] = {}

    def keep(self, what: str, made_of: object, make: Callable[[], _T]) -> _T:
        """Return what was made last where it is made of the same."""
        if what not in self._kept or self._kept[what][0] != made_of:
            self._kept.pop(what, None)  # before the new one is made: two large ones may not fit
            self._kept[what] = (made_of, make())
        found: _T = self._kept[what][1]
        return found


def load_inputs(
    kept: Kept,
    paint: str | os.PathLike[str] | Material,
    view: View,
    environment: Environment | None,
    mesh: Mesh | None,
    progress: Progress | None,
) -> tuple[Material, Environment, Mesh]:
    """Return the paint, environment and surface of a view, read where they changed; what is given, as it is."""
    asked = paint if isinstance(paint, Material) else os.fspath(paint)
    report(progress, 0.0, "reading the paint")
    lit = (asked, file_stamp(asked), view.light_colour.illuminant)
    material = kept.keep("paint", lit, lambda: load_lit(asked, view))
    environment = environment or kept.keep(
        "environment",
        (view.environment, file_stamp(view.environment), view.environment_layout),
        lambda: read_environment(
            find_environment(view.environment)[1], view.environment_layout, subrange(progress, 0.2, 0.6)
        ),
    )
    look = replace(view.surface_look, materials=(), occlusion=True, ground=False)
    mesh = mesh or kept.keep(
        "loaded",
        (view.surface, file_stamp(view.surface), look),
        lambda: load_shaped(view.surface, view.surface_look, subrange(progress, 0.6, 0.9)),
    )
    return material, environment, mesh


def choose_materials(mesh: Mesh, view: View) -> Mesh:
    """Return the mesh with the materials that the view gives its parts; without a second paint they have the paint."""
    chosen = view.surface_look.chosen
    parts = tuple(replace(p, material=chosen.get(p.name, p.material)) for p in mesh.parts)
    if view.two_tone.paint is None or not view.surface_look.wears_second:
        parts = tuple(replace(p, material=PAINT) if p.material == SECOND_PAINT else p for p in parts)
    return replace(mesh, parts=parts)


def digest_reflectance(reflectance: Reflectance, digest: Any, count: int) -> None:
    """Add a reflectance to a hash: values at some directions differ wherever two pictures could."""
    if isinstance(reflectance, LobeWeights):
        for array in (reflectance.kd, reflectance.kdd, reflectance.kg):
            digest.update(np.asarray(array).tobytes())
        return
    rng = np.random.default_rng(1)
    directions = rng.normal(size=(2, count, 3))
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    directions[..., 2] = np.abs(directions[..., 2])
    digest.update(np.round(reflectance.eval(directions[0], directions[1]), 9).tobytes())


def digest_mesh(mesh: Mesh, digest: Any) -> None:
    """Add positions, triangles and materials of a mesh to a hash."""
    for p in mesh.parts:
        if p.material != PAINT:
            digest.update(p.material.encode())
        digest.update(p.positions.tobytes())
        digest.update(p.triangles.tobytes())


def too_large(size: Size) -> ReferenceUnavailableError:
    """Return the error of a picture that memory does not hold."""
    return ReferenceUnavailableError(
        f"There is not enough memory to trace {size[0]} × {size[1]} pixels; make the picture smaller."
    )
