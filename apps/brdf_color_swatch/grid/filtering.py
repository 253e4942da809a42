"""Filtering, sorting and grouping: the rows of a palette that a pane shows."""

from __future__ import annotations

import math

import numpy as np
from brdf_qt.program.translation import decimal, tr

from brdf_color_swatch.grid.layout import Part
from brdf_color_swatch.grid.model import VisibleRows
from brdf_color_swatch.grid.rows import ANGLES_DEG, Rows, group_title
from brdf_color_swatch.grid.view_state import PaneState
from brdf_suite.palettes.duplicates import duplicates
from brdf_suite.palettes.order import ORDERS, natural, ordered
from brdf_suite.palettes.search import Filter, matching, nearest
from brdf_suite.progress import Progress

MOST_NEAREST = 500
_MANY = 400
"""From so many on, a path through the colours and duplicates are worked out in the background."""
_MANY_TEXTS = 5_000
"""From so many on, orders by a text and the first search are worked out in the background."""
_TEXT_ORDERS = ("name", "code", "tags", "date")
_ORDERS = {"hue": "hue path"}


def is_slow(rows: Rows, state: PaneState) -> bool:
    """Whether :func:`filter_and_sort` would block the window: a slow order or search that is not yet cached."""
    if len(rows) < _MANY:
        return False
    slow = state.sort == "hue" or (len(rows) >= _MANY_TEXTS and state.sort in _TEXT_ORDERS)
    if slow and _order_key(state) not in rows.kept:
        return True
    if len(rows) >= _MANY_TEXTS and state.text.strip() and not rows.has_texts:
        return True
    return state.duplicates is not None and ("alike", state.duplicates) not in rows.kept


def filter_and_sort(rows: Rows, state: PaneState, progress: Progress | None = None) -> VisibleRows:
    """Return what a pane of that state shows of ``rows``."""
    inside = matching(rows.columns, filter_of(state), rows.texts if state.text.strip() else None)
    if state.near is not None:
        return _nearest(rows, state, inside)
    if state.duplicates is not None:
        return _duplicates(rows, state, inside, progress)
    if state.sort in ("own", "nearest"):
        places, parts = by_group(rows, np.flatnonzero(inside))
        return VisibleRows(rows, tuple(places.tolist()), parts)
    order = _order(rows, state)
    places = order[inside[order]].tolist()
    return VisibleRows(rows, tuple(places), (Part("", 0, len(places)),))


def filter_of(state: PaneState) -> Filter:
    """Return the filter of a pane's state."""
    ranges, scope = {key: (low, high) for key, low, high in state.ranges}, state.scope
    return Filter(text=state.text, tags=(scope.tag,) if scope.tag else (), group=scope.group, **ranges)


def by_group(rows: Rows, places: np.ndarray) -> tuple[np.ndarray, tuple[Part, ...]]:
    """Return places and headings, group by group in the order in which the groups come; those of none first."""
    of, paths = rows.groups
    found, first, inverse, counts = np.unique(
        of[places], return_index=True, return_inverse=True, return_counts=True
    )
    without = np.array([not paths[group] for group in found.tolist()], bool)
    order = np.lexsort((first, ~without))
    rank = np.empty(len(order), np.intp)
    rank[order] = np.arange(len(order))
    parts: list[Part] = []
    start = 0
    for group, count in zip(found[order].tolist(), counts[order].tolist(), strict=True):
        path = paths[group]
        title = group_title(path) if path else (tr("Ungrouped") if len(found) > 1 else "")
        parts.append(Part(title, start, count))
        start += count
    return places[np.argsort(rank[inverse], kind="stable")], tuple(parts)


def _nearest(rows: Rows, state: PaneState, inside: np.ndarray) -> VisibleRows:
    assert state.near is not None
    found = nearest(rows.columns, np.asarray(state.near.lab), MOST_NEAREST, among=inside)
    places = found.indices.tolist()
    figures = dict(zip(places, found.delta_e.tolist(), strict=True))
    return VisibleRows(rows, tuple(places), (Part("", 0, len(places)),), figures)


def _duplicates(rows: Rows, state: PaneState, inside: np.ndarray, progress: Progress | None) -> VisibleRows:
    assert state.duplicates is not None
    key = ("alike", state.duplicates)
    if key not in rows.kept:
        rows.kept[key] = duplicates(rows.columns, state.duplicates, progress)
    places: list[int] = []
    parts: list[Part] = []
    for group in rows.kept[key]:
        members = [place for place in group.indices if inside[place]]
        if len(members) < 2:
            continue
        title = tr("{count} similar, differences up to ΔE00 {widest}")
        if math.isnan(group.widest):  # not worked out of a group that large
            title = tr("{count} similar")
        title = title.format(count=len(members), widest=decimal(f"{group.widest:.2f}"))
        if group.chained:
            title = tr("{title}, by steps").format(title=title)
        parts.append(Part(title, len(places), len(members)))
        places.extend(members)
    return VisibleRows(rows, tuple(places), tuple(parts))


def _order_key(state: PaneState) -> tuple[str, str, bool]:
    return ("order", state.sort, state.descending)


def _order(rows: Rows, state: PaneState) -> np.ndarray:
    key = _order_key(state)
    if key not in rows.kept:
        rows.kept[key] = _compute_order(rows, state.sort, descending=state.descending)
    return np.asarray(rows.kept[key])


def _compute_order(rows: Rows, sort: str, *, descending: bool) -> np.ndarray:
    by = _ORDERS.get(sort, sort)
    if by in ORDERS:
        return ordered(rows.columns, by, descending=descending)  # type: ignore[arg-type]  # it is one of them
    if sort == "tags":
        keys = [natural(", ".join(entry.tags)) for entry in rows.entries]
        places = sorted((p for p, key in enumerate(keys) if key), key=lambda p: keys[p], reverse=descending)
        return np.array([*places, *(p for p, key in enumerate(keys) if not key)], int)
    axis, _, angle = sort.partition("_")
    values = rows.lab[:, ANGLES_DEG.index(float(angle)), "Lab".index(axis)]
    return np.argsort(-values if descending else values, kind="stable")
