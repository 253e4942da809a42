"""Draws the viewer state: whatever of it has changed since the last frame is handed to the renderer first."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING, Any

from brdf_qt.work.angle_fits import AngleFits

from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.exposure import automatic_ev, exposed
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.picture import PAINT_MATERIAL, SECOND_MATERIAL, SceneRenderer
from brdf_suite.pipeline.surface_images import SurfaceImages
from brdf_suite.realtime.gl.context import Context
from brdf_suite.realtime.pictures.comparison import ComparedPicture, ComparisonRenderer
from brdf_suite.realtime.pictures.moving import Pace
from brdf_suite.realtime.pictures.probe import PixelProbe
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.pictures.traced_light import TracedLight
from brdf_viewer.scene.viewer_state import LoadedAsset, ViewerState
from brdf_viewer.tracing.trace_input import first_size

if TYPE_CHECKING:
    from brdf_viewer.tracing.process import TracedPicture

Grey = tuple[float, float, float]


class SceneDrawer:
    """Draws one state in one OpenGL context; a new context gets a new drawer, which uploads all that there is.

    Parameters
    ----------
    surround
        Returns the grey (R = G = B, 0…1) that is shown while there is nothing to draw.
    refused
        Called with the kind and the error where the graphics card does not take a new environment or surface;
        the old one is drawn on.
    """

    def __init__(
        self,
        context: Context,
        state: ViewerState,
        surround: Callable[[], Grey],
        refused: Callable[[str, SuiteError], None],
    ) -> None:
        self._state = state
        self._surround = surround
        self._refused = refused
        self.angle_fits = AngleFits(state)
        self.angle_fits.arrived.connect(state.contents_changed)
        self.scene_renderer = SceneRenderer(context, self.angle_fits.angles)
        # The first picture waits for no map and no program that it does not show; see prepare_edits.
        self.renderer.only_needed = True
        self._prepared = True
        self.uploads: dict[str, Callable[[Any], None]] = {
            "environment": self.scene_renderer.set_environment,
            "surface": lambda mesh: self.scene_renderer.set_surface(mesh, self._uploading.baked),
        }
        self._drawn: dict[str, LoadedAsset[Any]] = {}
        self._uploading: Any = None
        self._arrived = False
        self._images: SurfaceImages | None = None
        self._fit: object = None
        self.pace = Pace()
        self._second: LoadedAsset[Any] | None = None
        self._traced_picture: TracedPicture | None = None
        state.contents_changed.connect(self._prepare)
        state.view_changed.connect(self._prepare)
        self._prepare()

    @property
    def renderer(self) -> Renderer:
        """The renderer below, for what draws or reads outside the frames; its context must be current."""
        return self.scene_renderer.renderer

    @cached_property
    def probe(self) -> PixelProbe:
        """Reads single pixels; the context must be current."""
        return PixelProbe(self.renderer)

    @cached_property
    def _traced(self) -> TracedLight:
        return TracedLight(self.renderer)

    @cached_property
    def _comparison(self) -> ComparisonRenderer:
        """Draws the picture with the second paint or picture."""
        return ComparisonRenderer(self.renderer, {PAINT_MATERIAL: SECOND_MATERIAL})

    @cached_property
    def _with_own(self) -> ComparisonRenderer:
        """Draws the traced picture with its own in real time."""
        return ComparisonRenderer(self.renderer, {})

    @property
    def is_complete(self) -> bool:
        """Whether a paint has been drawn on a surface in an environment."""
        return self._fit is not None

    def draw(self, framebuffer: Any, size: tuple[int, int], view: object) -> bool:
        """Draw one frame; a new paint costs one buffer write, and only the newest since the last frame.

        Return whether it was an ordinary one, without an upload. The first one of a large surface is coarse.
        """
        uploads = [self._bring(kind) for kind in self.uploads]
        fit = self._state.drawn_fit
        if fit is None or len(self._drawn) < len(self.uploads) or not isinstance(view, View):
            framebuffer.clear(*self._surround(), 1.0)
            return False
        if fit is not self._fit:
            self.scene_renderer.set_material(fit)
            self._fit = fit
        arrived, self._arrived = self._arrived, False
        uploads += [arrived, self._bring_second(), self._bring_images(), self._bring_traced()]
        self.scene_renderer.prepare(view)
        if view.exposure_mode == "automatic" and self._state.metered_ev is None:
            self.meter(view, size)
        shown = exposed(view, self._state.metered_ev)
        traced = self.traced_light(first_size(shown, size))
        comparison = self._compared()
        if comparison is not None and shown.compare.mode != "off":
            comparison.traced = traced
            comparison.draw(shown, framebuffer, size, show_second=self._state.shows_second)
        elif traced is not None and traced.size == size:
            traced.render(shown, framebuffer, size)
        else:
            if arrived:
                self.pace.arrive(self.renderer.mesh.triangle_count)
            self.scene_renderer.draw(shown, framebuffer, size, self.pace.begin_frame())
        # A frame that compiles, too, says nothing of the time that frames take.
        prepared, self._prepared = self._prepared, True
        return prepared and not any(uploads)

    def traced_light(self, size: tuple[int, int]) -> TracedLight | None:
        """Return what shows the traced picture where there is one of this size on the viewer state."""
        there = self._traced_picture is not None and self._traced.size == size
        return self._traced if there else None

    def meter(self, view: View, size: tuple[int, int]) -> None:
        """Measure the exposure of what is drawn, for the viewer state to show it at; 0 EV where no object is seen."""
        if self._fit is not None:
            self._state.metered_ev = automatic_ev(self.renderer, view, size) or 0.0

    def prepare_edits(self) -> None:
        """Upload what the first picture did without, and compile it with the next frame, so that no edit waits."""
        self.renderer.only_needed = False
        self._prepared = False

    def release(self) -> None:
        self._state.contents_changed.disconnect(self._prepare)
        self._state.view_changed.disconnect(self._prepare)
        self.scene_renderer.release()

    def _prepare(self, *_: object) -> None:
        """Have the weights over the angle fitted that the next frame takes: here, and not in the frame."""
        for fit in self._fits():
            self.angle_fits.angles.prepare(fit, self._state.view)

    @property
    def awaits_weights(self) -> bool:
        """Whether weights over the angle that the view takes are being fitted for a paint that is drawn."""
        return any(self.angle_fits.angles.is_pending(fit, self._state.view) for fit in self._fits())

    def _fits(self) -> list[LobeFit]:
        state = self._state
        second = None if state.drawn_second is None else state.drawn_second.value
        fits = (state.drawn_fit, second, None if state.images is None else state.images.second_paint)
        return [fit for fit in fits if isinstance(fit, LobeFit)]

    def _bring_second(self) -> bool:
        """Bring what is compared with; return whether a picture was uploaded."""
        wanted = self._state.drawn_second
        if wanted is self._second:
            return False
        value = None if wanted is None else wanted.value
        picture = value if isinstance(value, ComparedPicture) else None
        self._second = wanted
        try:
            self._comparison.set_picture(picture)
            if value is not None and not isinstance(value, ComparedPicture):
                self.scene_renderer.set_material(value, SECOND_MATERIAL)
        except SuiteError as error:
            self._second = None
            self._refused("compare", error)
        return picture is not None

    def _compared(self) -> ComparisonRenderer | None:
        """Return what draws two pictures, where there are two."""
        if self._second is not None:
            return self._comparison
        return None if self._state.compared is None else self._with_own

    def _bring_traced(self) -> bool:
        """Bring the newest traced picture; return whether one was uploaded."""
        wanted = self._state.traced
        if wanted is self._traced_picture:
            return False
        self._traced_picture = wanted
        try:
            if wanted is not None:
                self._traced.set_picture(wanted.pixels)
        except SuiteError as error:
            self._traced_picture = None
            self._refused("traced", error)
        return wanted is not None

    def _bring_images(self) -> bool:
        """Upload what lies on the paint; return whether there was something."""
        images = self._state.images
        if images is None or images is self._images:
            return False
        self._images = images
        try:
            self.scene_renderer.set_surface_images(images)
        except SuiteError as error:
            self._refused("images", error)
        return True

    def _bring(self, kind: str) -> bool:
        """Upload the viewer state's environment or surface where it is another than the one drawn; return whether."""
        wanted, drawn = getattr(self._state, kind), self._drawn.get(kind)
        if wanted is None or wanted is drawn:
            return False
        try:
            self._uploading = wanted
            self.uploads[kind](wanted.value)
        except SuiteError as error:
            if drawn is None:
                raise
            self._uploading = drawn
            self.uploads[kind](drawn.value)
            setattr(self._state, kind, drawn)
            self._refused(kind, error)
        else:
            self._drawn[kind] = wanted
            # What was baked for a surface that is shown already is drawn whole.
            if kind == "surface" and (drawn is None or drawn.value is not wanted.value):
                self._arrived = True
        return True
