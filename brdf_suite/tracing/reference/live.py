"""A path-traced picture that follows what is edited: what changed is changed in place, and tracing begins anew.

    live = LiveReference()
    live.show("blue", View(), (640, 360))
    while not enough:
        estimate = live.step()        # one pass more
        picture = live.codes()        # (360, 640, 3) uint8, as a screen shows it

Another paint, camera, turn of the light or size costs some hundredths of a second: nothing is compiled anew, for the
numbers of a paint are read from memory. Another light, surface or set of lamps is read and built anew. To be
able to stop within a pass, run this in a process of its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.files.bounded_reading import file_stamp
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.scene import find_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.pipeline.surface_images import ImageRequest
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reference.passes import Estimate, pass_size, step
from brdf_suite.reference.variant import start
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.optics import Dress, load_dress, load_lit
from brdf_suite.tracing.reference.scene import ReferenceScene, Size, build_reference

Change = Literal["nothing", "shown", "light"]
_T = TypeVar("_T")

PASSES = (1, 1, 2, 4)
"""Samples a pixel of the first passes: a picture at once, and its noise soon."""
LATER_SAMPLES = 500_000
"""Of all pixels together in a pass after these, where 4 a pixel are not more: some tenths of a second."""


@dataclass(frozen=True, eq=False)
class _Loaded:
    """What is read for a scene."""

    paint: Material
    environment: Environment
    mesh: Mesh
    dress: Dress


class LiveReference:
    """One path-traced scene and its newest estimate; for one thread.

    Raises
    ------
    ExtraError
        Mitsuba is missing or cannot be loaded; the message says how to install it.
    ReferenceUnavailableError
        LLVM is missing; the message says what to install.
    """

    def __init__(self) -> None:
        start()
        self._scene: ReferenceScene | None = None
        self._estimate: Estimate | None = None
        self._structure: tuple[object, ...] = ()
        self._kept: dict[str, tuple[object, Any]] = {}

    @property
    def scene(self) -> ReferenceScene:
        """The scene that was shown last: its name, notices, and view with the camera placed."""
        if self._scene is None:
            raise SuiteError("Nothing has been shown to the path tracer yet.")
        return self._scene

    @property
    def estimate(self) -> Estimate | None:
        """What the passes so far give; None before the first."""
        return self._estimate

    def show(
        self,
        paint: str | os.PathLike[str] | Material,
        view: View,
        size: Size,
        progress: Progress | None = None,
        *,
        environment: Environment | None = None,
        mesh: Mesh | None = None,
    ) -> Change:
        """Show a material, loaded or by name or file, in a view, ``size`` in pixels.

        ``environment`` and ``mesh``, where they are given, take the place of those that the view names: a light that
        is being edited is in no file.

        Returns ``light`` where tracing begins anew, ``shown`` where only how it is shown changes (exposure, tone
        curve, backdrop), else ``nothing``. Where it raises, the last scene stays as it was.

        Raises
        ------
        FileError
            The paint, environment or surface cannot be read.
        UnreachableError
            No such paint can be.
        """
        loaded = self._load(paint, view, environment, mesh, progress)
        report(progress, 0.9, "building the scene")
        structure = _structure(loaded, view)
        before = self._scene
        made = build_reference(
            loaded.paint,
            view,
            size,
            loaded.environment,
            loaded.mesh,
            dress=loaded.dress,
            kept=before if structure == self._structure else None,
        )
        self._scene, self._structure = made, structure
        report(progress, 1.0, "ready")
        if before is None or before.key != made.key:
            self._estimate = None
            return "light"
        return "nothing" if replace(before.view, camera=made.view.camera) == made.view else "shown"

    def step(self) -> Estimate:
        """Trace one pass more and return the estimate; the first passes are of few samples.

        Raises
        ------
        ReferenceUnavailableError
            The renderer failed, as it does where memory runs out.
        """
        done = 0 if self._estimate is None else self._estimate.passes
        samples = PASSES[done] if done < len(PASSES) else pass_size(self.scene.size, LATER_SAMPLES)
        self._estimate = step(self.scene.traced, self._estimate, samples=samples)
        return self._estimate

    def codes(self) -> NDArray[np.uint8]:
        """Return the picture (h, w, 3), sRGB, as a screen shows it; :class:`SuiteError` before the first pass."""
        return self.scene.codes(self._newest())

    def whole(self) -> NDArray[np.float64]:
        """Return the radiance (h, w, 3) with the backdrop; :class:`SuiteError` before the first pass."""
        return self.scene.whole(self._newest())

    def _newest(self) -> Estimate:
        if self._estimate is None:
            raise SuiteError("Nothing has been traced yet.")
        return self._estimate

    def _load(
        self,
        paint: str | os.PathLike[str] | Material,
        view: View,
        environment: Environment | None,
        mesh: Mesh | None,
        progress: Progress | None,
    ) -> _Loaded:
        asked = paint if isinstance(paint, Material) else os.fspath(paint)
        illuminant = view.light_colour.illuminant
        report(progress, 0.0, "reading the paint")
        material = self._keep("paint", (asked, file_stamp(asked), illuminant), lambda: load_lit(asked, view))
        light = (view.environment, file_stamp(view.environment), view.environment_layout)
        environment = environment or self._keep(
            "environment",
            light,
            lambda: read_environment(
                find_environment(view.environment)[1], view.environment_layout, subrange(progress, 0.2, 0.6)
            ),
        )
        look = replace(view.surface_look, materials=(), occlusion=True, ground=False)
        mesh = mesh or self._keep(
            "surface",
            (view.surface, file_stamp(view.surface), look),
            lambda: load_shaped(view.surface, view.surface_look, subrange(progress, 0.6, 0.9)),
        )
        request = ImageRequest.of(view)
        files = (request.normal_map, request.mask, request.second_paint)
        dress = self._keep("dress", (request, *map(file_stamp, files)), lambda: load_dress(view))
        return _Loaded(material, environment, mesh, dress)

    def _keep(self, what: str, asked: object, load: Callable[[], _T]) -> _T:
        """Return what was loaded last where the same is asked for again."""
        if what not in self._kept or self._kept[what][0] != asked:
            self._kept[what] = (asked, load())
        found: _T = self._kept[what][1]
        return found


def _structure(loaded: _Loaded, view: View) -> tuple[object, ...]:
    """What a scene must be built anew for; the rest of it is changed in place."""
    return (
        id(loaded.mesh),
        loaded.environment.radiance.shape,
        view.lamps,
        view.surface_look.materials,
        # The ground's shadow is that of one light.
        view.surface_look.ground and (view.rotation_deg, view.light_colour, id(loaded.environment)),
    )
