"""What is on show: the view and what it refers to, loaded. The one place where the Viewer's state lives."""

from __future__ import annotations

import dataclasses
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from brdf_suite.documents.view import View
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.exposure import exposed
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.scene import PreparedEnvironment
from brdf_suite.pipeline.surface_images import SurfaceImages
from brdf_suite.realtime.camera import Bounds
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh
from brdf_viewer.documents.view_history import ViewHistory

if TYPE_CHECKING:
    from pathlib import Path

    from brdf_qt.documents.recovery import KeptHistory
    from brdf_qt.documents.stamp import FileStamp

    from brdf_suite.documents.store import AnyPaint
    from brdf_suite.lighting.statistics import EnvironmentStatistics
    from brdf_suite.realtime.pictures.comparison import ComparedPicture
    from brdf_viewer.tracing.process import TracedPicture
    from brdf_viewer.tracing.request import Renderer

T = TypeVar("T")


@dataclasses.dataclass(frozen=True, eq=False)
class LoadedAsset(Generic[T]):
    """Something that stands on the viewer state, and the shipped name or path that it came from."""

    key: str
    value: T


@dataclasses.dataclass(frozen=True, eq=False)
class LoadedSurface(LoadedAsset[Mesh]):
    """A surface; ``baked`` is the occlusion that was baked for it, None until it is there."""

    baked: BakedMesh | None = None

    @cached_property
    def bounds(self) -> Bounds:
        """Its box in metres."""
        return Bounds.of([part.positions for part in self.value.parts])


@dataclasses.dataclass(frozen=True)
class RealTimePicture:
    """The paint on show as it is drawn in real time: what its traced picture is compared with."""

    name = "real-time"


OWN_KEY = ""
"""The key of what a traced picture is compared with where nothing else is chosen: its own paint in real time."""
_OWN = LoadedAsset(OWN_KEY, RealTimePicture())


class ViewerState(QObject):
    """Holds frozen values and reports their changes.

    Signals
    -------
    view_changed(old, new)
        Two :class:`View` that differ.
    contents_changed()
        A new paint fit, environment or surface is to be drawn.
    traced_changed()
        Another renderer was chosen, or there is a traced picture now, or none any more.
    """

    view_changed = Signal(object, object)
    contents_changed = Signal()
    traced_changed = Signal()

    def __init__(self, view: View, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.history = ViewHistory(view, self)
        self.history.changed.connect(self.view_changed)
        self.fit: LobeFit | None = None
        self.relit: LobeFit | None = None
        self.paint_key = ""
        self.second: LoadedAsset[LobeFit | ComparedPicture] | None = None
        self.second_relit: LoadedAsset[LobeFit | ComparedPicture] | None = None
        self.shows_second = False
        self.renderer: Renderer = "realtime"
        self.traced: TracedPicture | None = None
        self.metered_ev: float | None = None
        self.light_figures: EnvironmentStatistics | None = None
        self.edited_light = ""
        """The title of a light that is shown and edited, and in no file as it is: the view names another."""
        self._environment: LoadedAsset[PreparedEnvironment] | None = None
        self._whole_environment: LoadedAsset[PreparedEnvironment] | None = None
        self.surface: LoadedSurface | None = None
        self.images: SurfaceImages | None = None
        self.fitting = FitSettings()
        """How all lobes of this run are fitted; the environment is filtered for their exponents."""
        self.fit_words: tuple[str, ...] = ()
        """The options of the suite's command that say the same."""

    @property
    def view(self) -> View:
        return self.history.value

    @property
    def paint(self) -> AnyPaint | None:
        """The document of the paint on show; None of measured data, models, and where there is no paint yet."""
        return None if self.fit is None else self.fit.material.document

    @property
    def drawn_fit(self) -> LobeFit | None:
        """The fit that is drawn: of a paint with spectra, the one for the view's lamp, once it is there."""
        return self.fit if self.relit is None else self.relit

    @property
    def drawn_second(self) -> LoadedAsset[LobeFit | ComparedPicture] | None:
        """What is compared with, as it is drawn: see :attr:`drawn_fit`."""
        return self.second if self.second_relit is None else self.second_relit

    @property
    def compared(self) -> LoadedAsset[LobeFit | ComparedPicture] | LoadedAsset[RealTimePicture] | None:
        """What the picture is compared with: the second paint or picture, or the traced one's own in real time."""
        if self.second is not None or self.renderer == "realtime":
            return self.second
        return _OWN

    @property
    def exposed_view(self) -> View:
        """The view at the exposure at which it is shown: what was measured, where it is automatic."""
        return exposed(self.view, self.metered_ev)

    @property
    def is_complete(self) -> bool:
        """Whether there is all that a picture needs, with every map of the environment."""
        whole = self.environment is not None and self.environment.value.is_final
        return whole and None not in (self.fit, self.surface)

    @property
    def environment(self) -> LoadedAsset[PreparedEnvironment] | None:
        """The light, maybe one of which sharp maps are still missing."""
        return self._environment

    @environment.setter
    def environment(self, environment: LoadedAsset[PreparedEnvironment] | None) -> None:
        self._environment = environment
        if environment is None or environment.value.is_final:
            self._whole_environment = environment

    @property
    def bounds(self) -> Bounds:
        """The surface's box in metres; a unit box while there is none."""
        return Bounds.of([]) if self.surface is None else self.surface.bounds

    def set_view(self, view: View) -> None:
        """Take ``view``, as a step that can be undone; nothing is emitted where it is equal."""
        self.history.set(view)

    def restore(self, kept: KeptHistory[View], path: Path | None, stamp: FileStamp | None) -> None:
        """Take a view with its undo history, and the file that holds it."""
        old = self.view
        self.history.end()
        self.history.restore(kept.states, kept.place, path, saved=kept.saved, stamp=stamp)
        if self.view != old:
            self.view_changed.emit(old, self.view)

    def change_view(self, **fields: Any) -> None:
        self.set_view(dataclasses.replace(self.view, **fields))

    def change_part(self, part: str, **fields: Any) -> None:
        """Replace fields of a part of the view, as of ``compare``."""
        self.change_view(**{part: dataclasses.replace(getattr(self.view, part), **fields)})

    def step_view(self, **fields: Any) -> None:
        """Replace fields of the view: a step of its own, also close after another change of them."""
        self.history.end()
        self.change_view(**fields)
        self.history.end()

    def follow_view(self, **fields: Any) -> None:
        """Replace fields of the view, to be undone with the step before: what follows from it, or goes on by itself."""
        self.history.amend(dataclasses.replace(self.view, **fields))

    def set_fit(self, fit: LobeFit, key: str = "") -> None:
        """Draw this paint from the next frame on; ``key`` is where it is from."""
        if fit is not self.fit:
            self.relit = None
        self.fit, self.paint_key = fit, key
        self.contents_changed.emit()

    def set_relit(self, fit: LobeFit, *, second: bool = False) -> None:
        """Draw the paint, or the ``second`` one, as its spectra look under the view's lamp, from the next frame on."""
        if not second:
            self.relit = fit
        elif self.second is not None:
            self.second_relit = LoadedAsset(self.second.key, fit)
        self.contents_changed.emit()

    def set_second(self, key: str | None, value: LobeFit | ComparedPicture | None = None) -> None:
        """Compare with this paint or picture from the next frame on; None: with nothing."""
        if value is None and self.second is None:
            return
        self.second = None if key is None or value is None else LoadedAsset(key, value)
        self.second_relit = None
        self.contents_changed.emit()

    def set_renderer(self, renderer: Renderer) -> None:
        """Have the picture made by this renderer; the real-time one is shown until another's is there."""
        self.renderer = renderer
        self.traced_changed.emit()

    def set_traced(self, picture: TracedPicture | None) -> None:
        """Show this traced picture of the present scene from the next frame on; None: the real-time one."""
        was, self.traced = self.traced, picture
        if (was is None) is not (picture is None):
            self.traced_changed.emit()

    def set_environment(self, key: str, environment: PreparedEnvironment) -> None:
        """Light with this environment from the next frame on; one of which maps are missing may be taken back."""
        self.environment = LoadedAsset(key, environment)
        self.contents_changed.emit()

    def take_partial_back(self) -> None:
        """Light again with the last whole environment; where there is none, what is shown stays."""
        if self._whole_environment not in (None, self._environment):
            self._environment = self._whole_environment
            self.contents_changed.emit()

    def set_surface(self, key: str, surface: Mesh) -> None:
        """Draw this surface from the next frame on."""
        self.surface = LoadedSurface(key, surface)
        self.contents_changed.emit()

    def set_images(self, images: SurfaceImages) -> None:
        """Lay these on the paint from the next frame on."""
        self.images = images
        self.contents_changed.emit()

    def set_baked(self, baked: BakedMesh) -> None:
        """Draw the surface with what was baked for it from the next frame on."""
        if self.surface is not None:
            self.surface = dataclasses.replace(self.surface, baked=baked)
            self.contents_changed.emit()
