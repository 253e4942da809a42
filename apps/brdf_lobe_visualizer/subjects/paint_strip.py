"""The paint strip below the view: a click puts a paint in front, and reads it where it is not shown yet."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from brdf_qt.choosing.sources import Source, SourceModel
from brdf_qt.choosing.strip import PaintStrip
from brdf_qt.choosing.thumbnails import PaintThumbnails, ThumbnailWork
from brdf_qt.program.feature import Feature
from brdf_qt.work.pictures import Pictures
from PySide6.QtCore import QObject

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.sources_control import Sources
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.palettes.swatches.look import Content


class StripControl(Feature, QObject):
    """Lists sample paints, those of Table 1, recent files and opened palettes."""

    def __init__(self, session: LobeSession, window: LobeWindow, sources: Sources) -> None:
        super().__init__(window)
        self._session, self._sources = session, sources
        self._swatches: dict[str, list[Source]] = {}
        self._shipped: list[Source] = []
        self._pictures = Pictures(self)
        self._work = ThumbnailWork(self._pictures, ())
        self.model = SourceModel(self)
        self.strip = PaintStrip(self.model)
        window.add_strip(self.strip)
        self.strip.taken.connect(self.show)
        self.strip.palette_requested.connect(lambda: window.open_requested.emit(None))
        sources.recent_changed.connect(self._list)
        sources.palette_opened.connect(self._add_palette)
        for changed in (session.front_changed, session.subjects_changed):
            changed.connect(self._show_present)

    def fill(
        self, shipped: Sequence[tuple[str, str]], load: Callable[[str], Content | None]
    ) -> PaintThumbnails:
        """List what comes with the program, title and name; return the pictures, of what ``load`` reads."""
        self._shipped = [Source(name, title) for title, name in shipped]
        self._list()
        thumbnails = PaintThumbnails(self._pictures, load)
        self.model.set_thumbnails(thumbnails)
        self._work = ThumbnailWork(self._pictures, (thumbnails,))
        self._work.begin()
        return thumbnails

    def close(self) -> None:
        self._work.close()

    def show(self, key: str) -> None:
        """Put a listed paint in front."""
        present = next((one for one in self._session.subjects if one.material.origin == key), None)
        if present is None:
            self._sources.open(key)
        else:
            self._session.set_front(present.key)

    def _add_palette(self, title: str, entries: Sequence[tuple[str, str]]) -> None:
        self._swatches[title] = [Source(origin, name, "palette") for name, origin in entries]
        self._list()

    def _list(self) -> None:
        swatches = [source for group in self._swatches.values() for source in group]
        files = [Source(str(path), path.name, "recent") for path in self._sources.recent()]
        self.model.set_sources([*swatches, *self._shipped, *files])
        self._show_present()

    def _show_present(self) -> None:
        front = self._session.front
        self.model.set_present("" if front is None else front.material.origin)
