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
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.files.bounded_reading import file_stamp
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.surface_images import ImageRequest
from brdf_suite.progress import Progress, report
from brdf_suite.reference.passes import Estimate, pass_size, step
from brdf_suite.reference.variant import start
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.optics import load_dress
from brdf_suite.tracing.reference.scene import ReferenceScene, build_reference
from brdf_suite.tracing.traced_picture import Kept, Size, load_inputs

Change = Literal["nothing", "shown", "light"]

PASSES = (1, 1, 2, 4)
"""Samples a pixel of the first passes: a picture at once, and its noise soon."""
LATER_SAMPLES = 500_000
"""Of all pixels together in a pass after these, where 4 a pixel are not more: some tenths of a second."""


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
        self._kept = Kept()

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
        material, light, surface = load_inputs(self._kept, paint, view, environment, mesh, progress)
        request = ImageRequest.of(view)
        files = (request.normal_map, request.mask, request.second_paint)
        dress = self._kept.keep("dress", (request, *map(file_stamp, files)), lambda: load_dress(view))
        report(progress, 0.9, "building the scene")
        # What a scene must be built anew for; the rest of it is changed in place.
        structure = (
            surface,
            light.radiance.shape,
            view.lamps,
            view.surface_look.materials,
            view.two_tone.paint is None,
            # The ground's shadow is that of one light.
            view.surface_look.ground and (view.rotation_deg, view.light_colour, light),
        )
        before = self._scene
        kept = before if structure == self._structure else None
        made = build_reference(material, view, size, light, surface, dress=dress, kept=kept)
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
        if self._estimate is None:
            raise SuiteError("Nothing has been traced yet.")
        return self.scene.codes(self._estimate)
