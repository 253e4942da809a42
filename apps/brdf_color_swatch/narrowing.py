"""From all the rows of a palette to those that a pane shows, in its order and under its headings."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from brdf_qt.translation import tr

from brdf_color_swatch.grid_layout import Part
from brdf_color_swatch.model import Shown
from brdf_color_swatch.rows import Rows, group_title
from brdf_color_swatch.view_state import PaneState


def narrowed(rows: Rows, state: PaneState) -> Shown:
    """Return what a pane of that state shows of ``rows``."""
    places = [place for place in range(len(rows)) if _in_scope(rows, place, state)]
    places = [place for place in places if _has_text(rows, place, state.text)]
    if state.keeps_order:
        places, parts = by_group(rows, places)
    else:
        parts = (Part("", 0, len(places)),)
    return Shown(rows, tuple(places), parts)


def by_group(rows: Rows, places: Sequence[int]) -> tuple[list[int], tuple[Part, ...]]:
    """Return places and headings, group by group in the order in which the groups come; those of none first."""
    members: dict[tuple[str, ...], list[int]] = {(): []}
    for place in places:
        members.setdefault(rows.entries[place].group, []).append(place)
    ordered: list[int] = []
    parts: list[Part] = []
    for path, inside in members.items():
        if inside:
            title = group_title(path) if path else (tr("In no group") if len(members) > 1 else "")
            parts.append(Part(title, len(ordered), len(inside)))
            ordered.extend(inside)
    return ordered, tuple(parts)


def _in_scope(rows: Rows, place: int, state: PaneState) -> bool:
    entry, scope = rows.entries[place], state.scope
    if scope.group and entry.group[: len(scope.group)] != scope.group:
        return False
    return not scope.tag or scope.tag in entry.tags


def _has_text(rows: Rows, place: int, text: str) -> bool:
    words = text.casefold().split()
    if not words:
        return True
    entry = rows.entries[place]
    told = " ".join((entry.name, entry.code, *entry.tags, entry.notes, *entry.group)).casefold()
    return all(word in told for word in words)


def order_of(values: np.ndarray, *, descending: bool) -> np.ndarray:
    """Return the order of values, stable; what is NaN comes last either way."""
    missing = ~np.isfinite(values)
    keys = np.where(missing, np.inf, -values if descending else values)
    return np.argsort(keys, kind="stable")
