"""Unsaved work that earlier runs have left: found, opened again or discarded."""

from __future__ import annotations

from brdf_qt.documents.recovery import Recovered
from brdf_qt.program.translation import tr

from brdf_color_swatch.library.library import Library
from brdf_suite.documents.palette import Palette


class UnsavedWork:
    """Recovers the autosaves of ended runs into a library."""

    def __init__(self, library: Library) -> None:
        self._library = library
        # Finds what earlier runs left, and never writes: its document is always clean.
        self._finder = library.recovery_of(library.empty_store())

    def find(self) -> list[Recovered[Palette]]:
        """Return what ended runs left, newest first."""
        return self._finder.found()

    def recover(self, found: Recovered[Palette]) -> str:
        """Open unsaved work of a run that was ended."""
        item = next((i for i in self._library.items if found.path is not None and i.path == found.path), None)
        if item is None:
            item = self._library.add_item(found.path, found.value.name)
        if item.palette is None:
            # Its file may be being read for the pane that shows it; the recovered work replaces it.
            self._library.tasks.cancel(f"read {item.key}")
            self._library.fill(item, found.value, found.path, clean=False, stamp=found.stamp)
            assert item.palette is not None
            if item.palette.recovery.write():
                item.palette.recovery.drop(found)
            item.run_waiting()
        else:
            # It is open, and perhaps changed: the recovered one comes as a step that can be undone.
            self._library.history.apply(tr("Recover unsaved work"), [(item.palette.store, found.value)])
            item.palette.recovery.drop(found)
        return item.key

    def discard(self, found: Recovered[Palette]) -> None:
        """Delete unsaved work of an earlier run."""
        self._finder.drop(found)

    def close(self) -> None:
        """Stop looking for unsaved work."""
        self._finder.close(keep=False)
