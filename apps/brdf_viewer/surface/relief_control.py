"""Relief and two-tone paint: what the view names is loaded in the background and laid on the paint."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.tasks import TaskRunner

from brdf_suite.documents.view import View
from brdf_suite.pipeline.material import paint_names
from brdf_suite.pipeline.surface_images import ImageRequest, SurfaceImages, load_surface_images
from brdf_viewer.documents.file_kinds import AskFile
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.fields.source_chooser import Source, title_of
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
        section.paint.set_sources(
            [Source("", tr("None")), *(Source(name, title_of(name, {})) for name in paint_names())], []
        )
        section.relief_edited.connect(lambda field, value: self._change("relief", field, value))
        section.two_tone_edited.connect(lambda field, value: self._change("two_tone", field, value))
        section.browse_requested.connect(self._browse)
        section.paint.browse_requested.connect(self._browse_paint)
        window.busy_cancelled.connect(self._cancelled)
        state.view_changed.connect(lambda _old, new: self._show(new))
        state.contents_changed.connect(self._show_own_peel)
        self._show(state.view)

    @property
    def is_idle(self) -> bool:
        """Whether no images are being loaded."""
        return not self._runner.busy

    def refused(self, error: Exception) -> None:
        """The graphics card did not take the images."""
        self._report(error)

    def close(self) -> None:
        """End what runs."""
        self._runner.stop(_CLOSING_MS)

    def _change(self, group: str, field: str, value: Any) -> None:
        old = getattr(self._state.view, group)
        self._state.change_view(**{group: dataclasses.replace(old, **{field: value})})

    def _browse(self, kind: str) -> None:
        path = self._ask(self._window, kind)
        if path:
            self._change("relief" if kind.endswith("_map") else "two_tone", kind, str(Path(path).absolute()))

    def _browse_paint(self) -> None:
        path = self._ask(self._window, "paint")
        if path:
            self._change("two_tone", "paint", str(Path(path).absolute()))

    def _show(self, view: View) -> None:
        paint = view.two_tone.paint
        self._section.set_relief(view.relief)
        self._section.set_two_tone(view.two_tone, tr("None") if paint is None else title_of(paint, {}))
        request = ImageRequest.of(view)
        if request == self._request:
            return
        self._request = request
        self._window.messages.dismiss(IMAGES)
        if request == ImageRequest():
            self._runner.cancel(IMAGES)
            self._window.set_idle(IMAGES)
            self._state.set_images(SurfaceImages(request))
            return
        self._runner.submit(
            IMAGES,
            load_surface_images,
            request,
            done=self._loaded,
            failed=self._failed,
            progress=lambda fraction, what: self._window.set_busy(IMAGES, fraction, what),
        )

    def _show_own_peel(self) -> None:
        fit = self._state.fit
        self._section.set_own_peel(None if fit is None else fit.orange_peel)

    def _loaded(self, images: SurfaceImages) -> None:
        self._window.set_idle(IMAGES)
        self._state.set_images(images)

    def _failed(self, error: Exception) -> None:
        self._window.set_idle(IMAGES)
        self._report(error)

    def _report(self, error: Exception) -> None:
        todo = tr("The picture is unchanged. Open another file in the inspector.")
        self._window.messages.show_message(message_of(error, IMAGES, todo=todo))

    def _cancelled(self, kind: str) -> None:
        if kind == IMAGES:
            self._runner.cancel(IMAGES)
            self._window.set_idle(IMAGES)
