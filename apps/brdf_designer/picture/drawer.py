"""Draws the picture with the renderer of the suite; imported only where there is an OpenGL context."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from brdf_qt.work.angle_fits import AngleFits

from brdf_designer.picture.contents import PictureContents
from brdf_suite.documents.view import View
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.picture import SceneRenderer
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.gl.context import Context
from brdf_suite.realtime.pictures.moving import WHOLE, Pace

Grey = tuple[float, float, float]


class PictureDrawer:
    """Draws the contents in one context; what has changed since the last frame is handed over first.

    ``surround`` gives the grey (R = G = B, 0 to 1) that is shown while there is nothing to draw. ``pace``, the same as
    Viewer's, makes frames coarser while something moves. ``better`` is called when the same contents would be drawn
    with better weights.
    """

    def __init__(
        self,
        context: Context,
        contents: PictureContents,
        surround: Callable[[], Grey],
        better: Callable[[], None],
    ) -> None:
        self._contents, self._surround = contents, surround
        self._angle_fits = AngleFits()
        self._angle_fits.arrived.connect(better)
        self._renderer = SceneRenderer(context, self._angle_fits.angles)
        self._renderer.renderer.only_needed = True
        self.pace = Pace()
        self._drawn: dict[str, object] = {}
        self._fit: LobeFit | None = None
        self.is_whole = False
        """Whether the last frame was of full size and samples."""
        self.prepared = False
        """Whether all that an edit may ask for is uploaded and compiled, or will be with the next frame."""

    @property
    def bounds(self) -> Bounds | None:
        """The box around the form; ``None`` before the first frame."""
        return self._renderer.renderer.bounds if self._drawn else None

    @property
    def drawn(self) -> LobeFit | None:
        """The fit of the last frame."""
        return self._fit

    def shows(self, contents: PictureContents) -> bool:
        """Whether the last frame was of these contents."""
        now = (contents.light, contents.form, contents.baked, contents.fit)
        return now == (self._drawn.get("light"), self._drawn.get("form"), self._drawn.get("baked"), self._fit)

    def draw(self, framebuffer: Any, size: tuple[int, int], view: object) -> bool:
        """Draw one frame; a new paint costs one buffer write. Return whether nothing was uploaded."""
        light, form, fit = self._contents.light, self._contents.form, self._contents.fit
        if light is None or form is None or fit is None or not isinstance(view, View):
            framebuffer.clear(*self._surround(), 1.0)
            return False
        wanted: dict[str, object] = {"light": light, "form": form, "baked": self._contents.baked}
        uploads = wanted != self._drawn
        if wanted["light"] is not self._drawn.get("light"):
            self._renderer.set_environment(light)
        if (form, self._contents.baked) != (self._drawn.get("form"), self._drawn.get("baked")):
            self._renderer.set_surface(form, self._contents.baked)
        self._drawn = wanted
        if fit is not self._fit:
            # This only begins to search on a thread: the window waits for no fit at several incidences.
            self._angle_fits.angles.prepare(fit, view)
            self._renderer.set_material(fit)
            self._fit = fit
        coarseness = self.pace.begin_frame()
        self._renderer.draw(view, framebuffer, size, coarseness)
        self.is_whole = coarseness is WHOLE
        return not uploads

    def prepare_edits(self) -> None:
        """Upload what the first picture did without, and compile it with the next frame, so that no edit waits."""
        self.prepared = True
        self._renderer.renderer.only_needed = False

    def release(self) -> None:
        """Give every OpenGL object back."""
        self._renderer.release()
        self._drawn, self._fit = {}, None
