"""The renderers that trace, behind one face: a scene is opened, and gives ever better pictures until it is closed.

Only the process that traces imports this: Mitsuba can end a process, and holds the interpreter while it renders.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lens
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reference.raytraced.picture import write_sums
from brdf_viewer.tracing.job import Job, TracedFrame, add_coverage
from brdf_viewer.tracing.request import TraceRequest
from brdf_viewer.tracing.scene_files import read_environment_file, read_surface_file

if TYPE_CHECKING:  # Mitsuba comes with them, which is optional
    from brdf_suite.tracing.raytraced.picture import RaytracedImage, RaytracedSession
    from brdf_suite.tracing.reference.live import LiveReference


class Engines:
    """Opens requests; what is the same as in the last one is not read again."""

    def __init__(self) -> None:
        self._read: dict[str, tuple[object, Any]] = {}
        self._reference: LiveReference | None = None
        self._raytraced: RaytracedSession | None = None

    def open(self, request: TraceRequest, progress: Progress | None = None) -> Job:
        """Return the scene of a request, ready to be traced.

        Raises
        ------
        SuiteError
            The renderer cannot run here, or what is asked for cannot be read.
        """
        report(progress, 0.0, "reading the light")
        scene = {
            "environment": self._kept("light", request.environment, read_environment_file),
            "mesh": self._kept("surface", request.surface, read_surface_file),
            "progress": subrange(progress, 0.3, 1.0),
        }
        # With the plainest background: the window draws what is behind the object, of any kind.
        view = replace(request.view, background="environment", lens=Lens())
        open_scene = self._open_raytraced if request.renderer == "raytraced" else self._open_reference
        return open_scene(request, view, scene, progress)

    def _open_reference(
        self, request: TraceRequest, view: View, scene: dict[str, Any], progress: Progress | None
    ) -> Job:
        # Here, because Mitsuba comes with it, which is optional.
        from brdf_suite.tracing.reference.live import LiveReference
        from brdf_viewer.tracing.reference_job import ReferenceJob

        if self._reference is None:
            report(progress, 0.2, "starting the path tracer")
            self._reference = LiveReference()
        look = view.surface_look
        view = replace(view, surface_look=replace(look, ground=False))
        self._reference.show(request.paint, view, request.size, **scene)
        return ReferenceJob(self._reference, grounded=look.ground)

    def _open_raytraced(
        self, request: TraceRequest, view: View, scene: dict[str, Any], progress: Progress | None
    ) -> Job:
        if self._raytraced is None:
            report(progress, 0.2, "starting the ray tracer")
            from brdf_suite.tracing.raytraced.picture import RaytracedSession

            self._raytraced = RaytracedSession()
        self._raytraced.show(request.paint, view, request.size, quality=request.quality, **scene)
        return RaytracedJob(self._raytraced)

    def _kept(self, kind: str, key: object, read: Any) -> Any:
        known = self._read.get(kind)
        if known is None or known[0] != key:
            self._read[kind] = known = (key, read(key))
        return known[1]


class RaytracedJob:
    """The ray tracer: one picture of the preset's samples, in passes."""

    def __init__(self, session: RaytracedSession) -> None:
        self._session = session
        self._newest: RaytracedImage | None = None
        self.title = session.scene.renderer
        self.notices = session.scene.notices
        self.no_denoiser = "The ray tracer uses the same lights in each pixel: there is no noise to remove."

    def frames(self) -> Iterator[TracedFrame]:
        """Yield ever better pictures until the preset's samples are there."""
        grounded = self._session.scene.view.surface_look.ground
        for image in self._session.passes():
            self._newest, sums = image, image.sums
            pixels = add_coverage(sums.radiance, sums.coverage)
            if grounded:
                pixels = np.concatenate([pixels, sums.darkness.astype(np.float32)], axis=-1)
            yield TracedFrame(pixels, sums.samples, image.scene.quality.samples, None, sums.seconds)

    def denoise_picture(self, pixels: NDArray[np.float32]) -> NDArray[np.float32]:
        return pixels

    def save(self, path: Path, view: View) -> None:
        """Write radiance, and what it adds up from: lights and samples are a preset's, so no variance is known."""
        if self._newest is None:
            raise SuiteError("There is no picture yet.")
        scene = self._newest.scene
        shown = replace(scene, view=replace(view, camera=scene.view.camera))
        write_sums(path, self._newest.sums, replace(self._newest, scene=shown).whole(), scene.key)
