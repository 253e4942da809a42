"""The same paint in three lights at once: that of the picture, and two more beside it, which follow all its changes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import tr
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QWidget

from brdf_designer.picture.contents import PictureContents
from brdf_suite.documents.view import View

if TYPE_CHECKING:
    from brdf_qt.gl.surface import GlSurface

    from brdf_designer.picture.drawer import PictureDrawer
    from brdf_designer.picture.scene import PictureScene
    from brdf_suite.fitting.lobes.basis import LobeBasis
    from brdf_suite.pipeline.scene import PreparedEnvironment

LIGHTS = ("photo_studio", "street", "sunny")
"""Indoors, outdoors without sun, and in the sun: a paint that holds in these holds. The two beside are of these."""
MakeSurface: TypeAlias = (
    "Callable[[PictureContents, Callable[[PictureDrawer], None], Callable[[], None]], GlSurface]"
)
"""Makes the widget that draws contents; called are the others with its drawer, and where it would draw better."""
_ENVIRONMENT = "environment"
_MARGIN = 8
_CLOSING_MS = 60_000


def lights_beside(present: str) -> tuple[str, str]:
    """Return the two lights that are shown beside the present one.

    >>> lights_beside("street"), lights_beside("booth")
    (('photo_studio', 'sunny'), ('photo_studio', 'street'))
    """
    first, second, *_ = (name for name in LIGHTS if name != present)
    return first, second


class LightName(PlainLabel):
    """The name of a light, at the lower left over the picture in it."""

    def __init__(self, over: QWidget) -> None:
        super().__init__("", over)
        self.setAutoFillBackground(True)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setMargin(4)

    def show_light(self, name: str, high: int) -> None:
        """Show the title of a light, ``high`` being the height of the picture."""
        self.setText(title_of(name))
        self.adjustSize()
        self.move(_MARGIN, high - self.height() - _MARGIN)
        self.raise_()


class LightPane(QWidget):
    """One picture beside the first, in a light of its own; ``loader`` is that of the first.

    Signals: ``moved(fraction, light)`` while that is prepared and ``ended()`` after it, ``failed(error)``;
    ``canvas_made(canvas)`` for each widget that has the mouse.
    """

    moved = Signal(float, str)
    ended = Signal()
    failed = Signal(object)
    canvas_made = Signal(QWidget)

    def __init__(self, make_surface: MakeSurface, loader: PictureScene) -> None:
        super().__init__()
        self.light = ""
        """The light that is shown, or on its way."""
        self._contents, self._view = PictureContents(), View()
        self._drawer: PictureDrawer | None = None
        self._is_loading = self._whole = False
        self._tasks = TaskRunner(self, threads=1)
        self._loader = loader.another(self._tasks, self)
        self._loader.loaded.connect(lambda _kind, name, value: self._take(name, value))
        self._loader.partly_loaded.connect(self._take)
        self._loader.failed.connect(lambda _kind, _key, error: self.failed.emit(error))
        self._loader.moved.connect(lambda _kind, fraction, _what: self.moved.emit(fraction, self.light))
        self._loader.ended.connect(self._end)
        self.surface = make_surface(self._contents, self._take_drawer, self._draw)
        self.surface.frame_drawn.connect(self._time)
        self.surface.canvas_changed.connect(self.canvas_made)
        described(self.surface, spoken=tr("The paint in another light"))
        fill_column(self, self.surface, grows=self.surface, spacing=0)
        self._name = LightName(self)

    @property
    def is_idle(self) -> bool:
        """Whether the picture is in its light, of the newest paint, and whole."""
        shown = self._drawer is not None and self._drawer.shows(self._contents)
        return bool(self.surface.failure) or (shown and self._whole and not self._is_loading)

    def show_light(self, name: str, basis: LobeBasis | None) -> None:
        """Show another light; the old one stays until it is there."""
        if name != self.light:
            self.light, self._is_loading = name, True
            self._loader.load(_ENVIRONMENT, name, basis=basis)

    def follow(self, view: View, contents: PictureContents, *, coarse: bool) -> None:
        """Draw what the first picture shows, from where it is seen, in the light of this one."""
        self._view, own = view, self._contents
        own.form, own.baked, own.fit = contents.form, contents.baked, contents.fit
        if self._drawer is not None:
            if coarse:
                self._drawer.pace.move()
            else:
                self._drawer.pace.rest()
        self._draw()

    def rest(self) -> None:
        """Draw whole: nothing moves any more."""
        if self._drawer is not None and self._drawer.pace.rest():
            self.surface.redraw()

    def close_light(self) -> None:
        """End the loading and free the picture."""
        self._loader.stop()
        self._tasks.stop(_CLOSING_MS)
        self.surface.release()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._name.show_light(self.light, self.height())

    def _take(self, name: str, light: PreparedEnvironment) -> None:
        self._contents.light = light
        self._name.show_light(name, self.height())
        self._draw()

    def _end(self, _kind: str) -> None:
        self._is_loading = False
        self.ended.emit()

    def _take_drawer(self, drawer: PictureDrawer) -> None:
        self._drawer = drawer

    def _draw(self) -> None:
        self._whole = False
        if self._contents.light is not None:
            self.surface.set_view(self._loader.in_light(self._view, self.light))

    def _time(self, milliseconds: float, typical: bool) -> None:
        if self._drawer is not None:
            self._whole = self._drawer.is_whole
            if typical:
                self._drawer.pace.end_frame(milliseconds)


class ThreeLights(QObject):
    """Two panes beside the first picture, made when they are first asked for."""

    def __init__(self, make: Callable[[], LightPane], show: Callable[[tuple[LightPane, ...]], None]) -> None:
        super().__init__()
        self._make, self._show = make, show
        self.panes: tuple[LightPane, ...] = ()
        self.is_on = False

    @property
    def is_idle(self) -> bool:
        """Whether nothing is to come in the panes that are shown."""
        return not self.is_on or all(pane.is_idle for pane in self.panes)

    def set_on(self, on: bool) -> None:
        """Show the panes, or hide them."""
        self.is_on = on
        if on and not self.panes:
            self.panes = (self._make(), self._make())
        self._show(self.panes if on else ())

    def follow(self, view: View, contents: PictureContents, basis: LobeBasis | None, *, coarse: bool) -> None:
        """Let the panes follow the first picture, in the two lights that it is not in."""
        if not self.is_on:
            return
        for pane, light in zip(self.panes, lights_beside(view.environment), strict=True):
            pane.show_light(light, basis)
            pane.follow(view, contents, coarse=coarse)

    def rest(self) -> None:
        """Draw whole: nothing moves any more."""
        for pane in self.panes if self.is_on else ():
            pane.rest()

    def close(self) -> None:
        """Free the pictures."""
        for pane in self.panes:
            pane.close_light()
