"""A palette's file that another program has written: noticed, reported, and reloaded or merged at the user's choice."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, Severity, message_of

from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.library.loading import Read
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Palette
from brdf_suite.palettes.merge import Merge, merge

_MOST_LISTED = 6


class ChangedFiles(SwatchFeature):
    """Offers to reload or merge; nothing is taken, and nothing overwritten, unasked."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        session.library.changed_outside.connect(self._offer)

    def _offer(self, key: str) -> None:
        item = self._session.library.item(key)
        if item is None or item.palette is None or item.path is None:
            return
        what = tr("“{name}” was changed by another program.").format(name=item.path.name)
        reload_it = (
            tr("Reload"),
            lambda: self._session.loader.reread(
                key,
                lambda read: self._session.loader.adopt_file(key, read.palette, read, tr("Reload from disk")),
            ),
        )
        if item.palette.store.is_clean:
            todo = tr("Reload loads the current file. It can be undone.")
            actions: tuple[tuple[str, Callable[[], None]], ...] = (reload_it, (tr("Keep Mine"), lambda: None))
        else:
            todo = tr(
                "You have unsaved changes. Merge combines both versions; Reload discards yours. Both can be undone."
            )
            merge = (
                tr("Merge"),
                lambda: self._session.loader.reread(key, lambda read: self._merge(key, read)),
            )
            actions = (merge, reload_it, (tr("Keep Mine"), lambda: None))
        self._window.show_message(
            Message(
                f"outside {key}", what, where=str(item.path), todo=todo, severity="warning", actions=actions
            )
        )

    def _merge(self, key: str, read: Read) -> None:
        item = self._session.library.item(key)
        if item is None or item.palette is None:
            return
        opened = item.palette
        mine = opened.store.value
        self._session.library.tasks.submit(
            f"merge {key}",
            lambda request, _progress: merge(*request),
            (opened.base, mine, read.palette),
            lambda merged: self._take(key, mine, merged, read),
            lambda error: self._window.show_message(message_of(error, f"outside {key}")),
        )

    def _take(self, key: str, mine: Palette, merged: object, read: Read) -> None:
        item = self._session.library.item(key)
        if item is None or item.palette is None or not isinstance(merged, Merge):
            return
        if item.palette.store.value is not mine:
            # An edit came while it was merged: it is merged as well.
            self._merge(key, read)
            return
        self._session.loader.adopt_file(key, merged.palette, read, tr("Merge with file"))
        changes = [*merged.conflicts, *merged.taken]
        if not changes:
            return
        more = len(changes) - _MOST_LISTED
        lines = changes[:_MOST_LISTED] + ([tr("{count} more").format(count=more)] if more > 0 else [])
        if merged.conflicts:
            what = tr("File merged with {count} conflicts; your version was kept.")
            if len(merged.conflicts) == 1:
                what = tr("File merged with 1 conflict; your version was kept.")
            what = what.format(count=len(merged.conflicts))
        else:
            what = tr("File merged with your changes.")
        undo = (tr("Undo"), self._session.library.history.undo)
        severity: Severity = "warning" if merged.conflicts else "info"
        message = Message("merged", what, todo="\n".join(lines), severity=severity, actions=(undo,))
        self._window.show_message(message)
