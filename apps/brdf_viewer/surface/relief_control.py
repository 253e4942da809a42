"""Relief and two-tone paint: what the view names is loaded in the background and laid on the paint."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from brdf_qt.choosing.sources import Source
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import tr
from brdf_qt.work.tasks import TaskRunner

from brdf_suite.documents.view import View
from brdf_suite.pipeline.material import paint_names
from brdf_suite.pipeline.surface_images import ImageRequest, SurfaceImages, load_surface_images
from brdf_viewer.documents.file_kinds import AskFile
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

IMAGES = "images"
_CLOSING_MS = 60_000


class ReliefControl(ViewerFeature):
    """Wires the section to the viewer state; an image that cannot be read is reported, and what was shown stays."""

    def __init__(self, state: ViewerState, window: ViewerWindow, ask: AskFile) -> None:
        super().__init__(state, window)
        self._ask = ask
        self._section = window.relief
        self._runner = TaskRunner(self, threads=1)
        self._request = ImageRequest()
        section = self._section
        paints = [Source(name, title_of(name)) for name in paint_names()]
        section.paint.set_sources([Source("", tr("No second paint")), *paints], [])
        section.edited.connect(lambda part, field, value: state.change_part(part, **{field: value}))
        section.browse_requested.connect(self._browse)
        window.busy_cancelled.connect(self._cancelled)
        state.view_changed.connect(lambda _old, new: self._show(new))
        state.contents_changed.connect(self._show_own_peel)
        self._show(state.view)

    @property
    def is_idle(self) -> bool:
        return not self._runner.busy

    def refused(self, error: Exception) -> None:
        """The graphics card, or the disk, did not give the images."""
        todo = tr("The picture is unchanged. Open another file in the inspector.")
        self._report(error, IMAGES, todo)

    def close(self) -> None:
        self._runner.stop(_CLOSING_MS)

    def _browse(self, part: str, kind: str) -> None:
        path = self._ask(self._window, kind)
        if path:
            self._state.change_part(part, **{kind: str(Path(path).absolute())})

    def _show(self, view: View) -> None:
        paint = view.two_tone.paint
        self._section.set_relief(view.relief)
        self._section.set_two_tone(view.two_tone, tr("No second paint") if paint is None else title_of(paint))
        request = ImageRequest.of(view)
        if request == self._request:
            return
        self._request = request
        if request == ImageRequest():
            self._window.messages.dismiss(IMAGES)
            self._cancelled(IMAGES)
            self._state.set_images(SurfaceImages(request))
            return
        loaded = self._state.set_images
        load = partial(load_surface_images, settings=self._state.fitting)
        self._run(self._runner, IMAGES, load, request, loaded, self.refused)

    def _show_own_peel(self) -> None:
        fit = self._state.fit
        self._section.set_own_peel(None if fit is None else fit.orange_peel)

    def _cancelled(self, kind: str) -> None:
        if kind == IMAGES:
            self._runner.cancel(IMAGES)
            self._window.set_idle(IMAGES)
