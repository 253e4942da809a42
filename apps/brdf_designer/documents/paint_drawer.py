"""The drawer with the paint strip: sample paints, recent files and the paints of a palette, opened by a click."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from brdf_qt.choosing.palettes import PALETTE_ENDINGS, read_palette_sources
from brdf_qt.choosing.sources import Source, SourceModel
from brdf_qt.choosing.strip import PaintStrip
from brdf_qt.choosing.thumbnails import PaintThumbnails
from brdf_qt.program.feature import Feature
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow
from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.paint import Paint
from brdf_suite.pipeline.material import load_document, paint_names

_PALETTE = "palette"


class PaintDrawer(Feature, QObject):
    """Lists the paints, and opens what is taken in a tab of its own."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._tasks = TaskRunner(self, threads=1)
        self._swatches: list[Source] = []
        self.thumbnails = PaintThumbnails(window.pictures, load_document)
        self.model = SourceModel(self)
        self.model.set_thumbnails(self.thumbnails)
        self.strip = PaintStrip(self.model)
        tip = tr("Show or hide the paints to choose from")
        self.drawer = window.add_drawer(
            "paints", tr("Paints"), self.strip, "bottom", "paint_strip", "palette", tip
        )
        self.strip.taken.connect(self.open)
        self.strip.palette_requested.connect(self._ask_palette)
        session.documents.recent_changed.connect(self._list)
        session.documents.front_changed.connect(self._show_present)
        self._list()

    def start(self) -> None:
        self.thumbnails.start()

    @property
    def is_idle(self) -> bool:
        return not self._tasks.busy

    def close(self) -> None:
        self._tasks.stop()
        self.thumbnails.close()

    def open(self, key: str) -> None:
        """Open a listed paint in a tab: by its shipped name, its file, or as a palette holds it."""
        source = self.model.source_at(self.model.row_of(key))
        if source.group == "shipped":
            self._window.shipped_requested.emit(key)
        elif source.group == "recent":
            self._window.open_requested.emit(Path(key))
        else:
            assert isinstance(source.content, Paint)  # only such are listed
            self._session.open_paint(source.content, source.title, clean=True)

    def open_palette(self, path: str) -> None:
        """List the paints of a palette in the place of those of the one before."""
        self._window.dismiss_message(_PALETTE)
        self._tasks.submit(_PALETTE, read_palette_sources, path, self._take_palette, self._not_read)

    def _ask_palette(self) -> None:
        endings = " ".join(f"*{ending}" for ending in PALETTE_ENDINGS)
        path = self._session.documents.ask(tr("Palettes ({endings})").format(endings=endings))
        if path is not None:
            self.open_palette(str(path.absolute()))

    def _take_palette(self, found: list[Source]) -> None:
        designs = []
        for source in found:
            paint = None if source.content is None else to_paint(source.content)
            if isinstance(paint, Paint):
                designs.append(replace(source, content=paint))
        self._swatches = designs
        self._list()
        self.strip.show_group(_PALETTE)
        if len(designs) < len(found):
            text = tr(
                "Not listed, as they have no readings to edit: {count} of {whole} paints of the palette."
            )
            what = text.format(count=len(found) - len(designs), whole=len(found))
            self._window.show_message(Message(_PALETTE, what, severity="warning"))

    def _not_read(self, error: Exception) -> None:
        self._window.show_message(message_of(error, _PALETTE, todo=tr("The list of paints is unchanged.")))

    def _list(self) -> None:
        shipped = [Source(name, title_of(name)) for name in paint_names()]
        recent = [str(path) for path in self._session.documents.front.files.recent()]
        for path in recent:
            self.thumbnails.forget(path)  # it may have been saved anew
        files = [Source(path, title_of(path), "recent") for path in recent]
        self.model.set_sources([*self._swatches, *shipped, *files])
        self._show_present()

    def _show_present(self) -> None:
        path = self._session.documents.front.store.path
        self.model.set_present("" if path is None else str(path))
