"""What edits have in common: words for what they are made to, dates, and adding entries."""

from __future__ import annotations

import uuid
from collections.abc import Callable, Sequence
from dataclasses import replace

from brdf_qt.program.translation import tr

from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.panels.swatch import today
from brdf_color_swatch.session import PaletteSession
from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.palette import Entry, GroupPath, Palette

OWNER = uuid.uuid4().hex
"""This run of the program: a cut or a drag from another one is a copy."""


def add_entries(
    session: PaletteSession,
    name: str,
    entries: Sequence[Entry],
    group: GroupPath | None = None,
    before: str | None = None,
    scope: Scope | None = None,
) -> bool:
    """Add entries as one step to what a scope shows (that in front); select and show them; True where that was done."""
    scope = scope or session.state.scope
    if session.library.palette(scope.palette) is None or not entries:
        return False
    if group is None:
        group = scope.group
    added = as_added(entries, scope.tag)
    return edit_and_reveal(
        session, name, lambda old: edits.add_entries(old, added, group, before), scope.palette
    )


def as_added(entries: Sequence[Entry], tag: str) -> list[Entry]:
    """Return entries as they are put where a tag is shown ("" for none): with the tag, and today where not dated.

    Without the tag they would vanish as they come.
    """
    dated = [entry if entry.date else replace(entry, date=today()) for entry in entries]
    if not tag:
        return dated
    return [replace(entry, tags=tuple(dict.fromkeys((*entry.tags, tag)))) for entry in dated]


def edit_and_reveal(
    session: PaletteSession, name: str, change: Callable[[Palette], Palette], key: str | None = None
) -> bool:
    """Change a palette (that in front), and select and show the entries that came; True where that was done.

    They are shown where the palette still is in front.
    """
    key = session.state.scope.palette if key is None else key
    before = session.library.palette(key)
    known = set() if before is None else set(before.by_id)
    if not session.edit(name, change, key):
        return False
    after = session.library.palette(key)
    if after is not None and session.state.scope.palette == key:
        session.reveal(tuple(id_ for id_ in after.by_id if id_ not in known))
    return True


def with_date(palette: Palette, ids: Sequence[str]) -> Palette:
    """Note when these entries were changed."""
    moment = today()
    return edits.change_entries(palette, ids, lambda entry: replace(entry, date=moment))


def count_words(count: int) -> str:
    """Return how many swatches, in words."""
    return tr("one swatch") if count == 1 else tr("{count} swatches").format(count=count)


def what_words(entries: Sequence[Entry]) -> str:
    """Return which swatch, or how many, in words."""
    return f"“{entries[0].name[:40]}”" if len(entries) == 1 and entries[0].name else count_words(len(entries))
