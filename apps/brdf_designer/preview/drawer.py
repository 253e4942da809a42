"""Draws the small picture with the renderer of the suite; imported only where there is an OpenGL context."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from brdf_suite.documents.view import View

if TYPE_CHECKING:
    from brdf_qt.work.angle_fits import AngleFits

    from brdf_designer.preview.scene import PreviewScene
    from brdf_suite.pipeline.lobe_fit import LobeFit
    from brdf_suite.pipeline.picture import SceneRenderer
    from brdf_suite.realtime.camera import Bounds
    from brdf_suite.realtime.gl.context import Context

Grey = tuple[float, float, float]


class PreviewContents:
    """What is to be drawn: the newest scene and fit; a new context draws the same anew."""

    def __init__(self) -> None:
        self.scene: PreviewScene | None = None
        self.fit: LobeFit | None = None


class PreviewDrawer:
    """Draws the contents in one context; what has changed since the last frame is handed over first.

    ``surround`` gives the grey (R = G = B, 0 to 1) that is shown while there is nothing to draw. ``draft``: one sample
    a pixel, for a renderer in software that takes long over several. ``better`` is called when the same contents would
    be drawn with better weights.
    """

    def __init__(
        self,
        context: Context,
        contents: PreviewContents,
        surround: Callable[[], Grey],
        better: Callable[[], None],
    ) -> None:
        self._context, self._contents, self._surround = context, contents, surround
        self._better = better
        self._angle_fits: AngleFits | None = None  # with the renderer
        self._renderer: SceneRenderer | None = None
        self._scene: PreviewScene | None = None
        self._fit: LobeFit | None = None
        self.draft = False
        self.prepared = False
        """Whether all that an edit may ask for is uploaded and compiled, or will be with the next frame."""

    @property
    def bounds(self) -> Bounds | None:
        """The box around the form; ``None`` before the first frame."""
        return None if self._renderer is None else self._renderer.renderer.bounds

    @property
    def drawn(self) -> LobeFit | None:
        """The fit of the last frame."""
        return self._fit

    def draw(self, framebuffer: Any, size: tuple[int, int], view: object) -> bool:
        """Draw one frame; a new paint costs one buffer write. Return whether nothing was uploaded."""
        scene, fit = self._contents.scene, self._contents.fit
        if scene is None or fit is None or not isinstance(view, View):
            framebuffer.clear(*self._surround(), 1.0)
            return False
        if self._renderer is None or self._angle_fits is None:
            # Deferred: with the renderer come its shaders, which the window does not wait for.
            from brdf_qt.work.angle_fits import AngleFits

            from brdf_suite.pipeline.picture import SceneRenderer

            self._angle_fits = AngleFits()
            self._angle_fits.arrived.connect(self._better)
            self._renderer = SceneRenderer(self._context, self._angle_fits.angles)
            self._renderer.renderer.only_needed = not self.prepared
        uploads = scene is not self._scene
        if uploads:
            if self._scene is None or scene.surface is not self._scene.surface:
                self._renderer.set_surface(scene.surface, scene.baked)
            self._renderer.set_environment(scene.light)
            self._scene, self._fit = scene, None
        if fit is not self._fit:
            # This only begins to search on a thread: the view never asks for a fit at several incidences.
            self._angle_fits.angles.prepare(fit, view)
            self._renderer.set_material(fit)
            self._fit = fit
        self._renderer.prepare(view)
        if self.draft:
            self._renderer.renderer.render(view, framebuffer, size, samples=1)
        else:
            self._renderer.draw(view, framebuffer, size)
        return not uploads

    def prepare_edits(self) -> None:
        """Upload what the first picture did without, and compile it with the next frame, so that no edit waits."""
        self.prepared = True
        if self._renderer is not None:
            self._renderer.renderer.only_needed = False

    def release(self) -> None:
        """Give every OpenGL object back."""
        if self._renderer is not None:
            self._renderer.release()
            self._renderer = None
        self._scene = self._fit = None
