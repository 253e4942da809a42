"""Palettes in order: by hue, along a path through the colours, by lightness, flop, gloss, name, code or date.

Every order is stable: what is alike stays as it was. What a paint has not (no date, no gloss, a grey no hue) stands at
the end, whichever way the order runs.

The *hue path* goes once round the hues and, within each band of them, up or down in lightness by turns, so that one
paint looks like the next; greys come first, from dark to light. How many bands there are is tried out, and the shortest
path (in ΔE*ab at 45°) is taken; then stretches of it are turned round as long as that makes it shorter (2-opt, Croes
1958, within stretches of thirty).
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from heapq import merge
from typing import Literal, get_args

import numpy as np

from brdf_suite.arrays import Floats, Indices
from brdf_suite.documents.parameter import check_choice
from brdf_suite.palettes.columns import Columns

By = Literal["hue path", "hue", "lightness", "chroma", "flop", "gloss", "travel", "name", "code", "date"]
ORDERS: tuple[str, ...] = get_args(By)
GREY_BELOW = 4.0
"""C*ab at 45° of what stands with the greys: so little that a hue is hardly seen."""


_BANDS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192)
_LONGEST_TURN = 30
_ROUNDS = 60
_RUN = 5_000
_DIGITS = re.compile(r"(\d+)")


def ordered(columns: Columns, by: By, *, descending: bool = False) -> Indices:
    """Return the places (n,) of the entries in an order; see the module."""
    check_choice(by, "by", ORDERS)
    if by == "hue path":
        path = hue_path(columns.main[:, 1])
        unknown = ~np.isfinite(columns.main[path, 1]).all(axis=1)
        known = path[~unknown]
        return np.concatenate([known[::-1] if descending else known, path[unknown]])
    if by in ("name", "code", "date"):
        return _by_text(columns, by, descending)
    values = columns.hue if by == "hue" else getattr(columns, by)
    if by == "hue":
        # Greys stand behind all hues, from dark to light.
        greys = ~(columns.chroma >= GREY_BELOW)
        values = np.where(greys, np.nan, values)
        ranks = np.where(descending, -values, values)
        return np.lexsort((np.where(greys, columns.lightness, 0.0), ranks, np.isnan(ranks)))
    ranks = -values if descending else values
    return np.asarray(np.argsort(ranks, kind="stable"))


def _by_text(columns: Columns, by: str, descending: bool) -> Indices:
    texts = [getattr(entry, by) for entry in columns.entries]
    there = [place for place, text in enumerate(texts) if text]
    keys: Callable[[int], object] = (
        (lambda place: texts[place]) if by == "date" else (lambda place: natural(texts[place]))
    )
    # In runs: one sort of a hundred thousand keys would hold up all other threads from its beginning to its end. Turned
    # round as a whole, a stable order would turn equals round as well.
    runs = [
        sorted(there[start : start + _RUN], key=keys, reverse=descending)  # type: ignore[arg-type]  # keys are of one kind
        for start in range(0, len(there), _RUN)
    ]
    there = list(merge(*runs, key=keys, reverse=descending))  # type: ignore[arg-type]
    return np.array(there + [place for place, text in enumerate(texts) if not text], np.intp)


def natural(text: str) -> tuple[tuple[int, int, str], ...]:
    """Return a key by which names sort as people count: "Blue 2" before "Blue 10", letter case apart.

    >>> sorted(["Blue 10", "blue 2", "Äther", "Azur"], key=natural)
    ['Äther', 'Azur', 'blue 2', 'Blue 10']
    """
    folded = unicodedata.normalize("NFKD", text).casefold()
    base = "".join(letter for letter in folded if not unicodedata.combining(letter)) or folded
    parts: list[tuple[int, int, str]] = []
    for part in _DIGITS.split(base):
        if part.isdecimal():
            parts.append((0, int(part[:300]), part))
        elif part:
            parts.append((1, 0, part))
    return tuple(parts)


def hue_path(lab: Floats) -> Indices:
    """Return the places (n,) of L*a*b* (n, 3) along the hue path; what is not known stands at the end."""
    known = np.flatnonzero(np.isfinite(lab).all(axis=1))
    unknown = np.setdiff1d(np.arange(len(lab)), known)
    chroma = np.hypot(lab[known, 1], lab[known, 2])
    greys = known[chroma < GREY_BELOW]
    greys = greys[np.argsort(lab[greys, 0], kind="stable")]
    coloured = known[chroma >= GREY_BELOW]
    if len(coloured) > 2:
        hue = np.degrees(np.arctan2(lab[coloured, 2], lab[coloured, 1])) % 360.0
        paths = [coloured[_serpentine(hue, lab[coloured, 0], bands)] for bands in _BANDS if bands <= len(hue)]
        coloured = min(paths, key=lambda path: path_length(lab[path]))
        coloured = coloured[_shortened(lab[coloured])]
    return np.concatenate([greys, coloured, unknown]).astype(np.intp)


def path_length(lab: Floats) -> float:
    """Return the sum of ΔE*ab from each colour (n, 3) to the next."""
    return float(np.sqrt((np.diff(lab, axis=0) ** 2).sum(axis=1)).sum())


def _serpentine(hue: Floats, lightness: Floats, bands: int) -> Indices:
    """Bands of as many colours each, by hue; within them up and down in lightness by turns."""
    by_hue = np.argsort(hue, kind="stable")
    band = np.empty(len(hue), np.intp)
    band[by_hue] = np.arange(len(hue)) * bands // len(hue)
    way = np.where(band % 2 == 0, lightness, -lightness)
    return np.lexsort((hue, way, band))


def _shortened(lab: Floats) -> Indices:
    """The order (n,) of a path whose stretches are turned round while that makes it shorter; its ends stay."""
    path = np.arange(len(lab))
    for _ in range(_ROUNDS):
        place = lab[path]
        gains, firsts, lasts = [], [], []
        steps = _distance(place[:-1], place[1:])
        for length in range(2, min(_LONGEST_TURN, len(path) - 2) + 1):
            # Between i and i + length + 1 lie the places that would be turned round.
            i = np.arange(len(path) - length - 1)
            gain = (
                steps[i]
                + steps[i + length]
                - _distance(place[i], place[i + length])
                - _distance(place[i + 1], place[i + length + 1])
            )
            better = np.flatnonzero(gain > 1e-9)
            gains.append(gain[better])
            firsts.append(better + 1)
            lasts.append(better + length)
        if not gains or not sum(map(len, gains)):
            break
        gain, first, last = np.concatenate(gains), np.concatenate(firsts), np.concatenate(lasts)
        # The best first; of those that touch one another only one can be done in a round.
        taken = np.zeros(len(path) + 1, bool)
        for pick in np.lexsort((first, -gain)).tolist():
            low, high = int(first[pick]), int(last[pick])
            if not taken[low - 1 : high + 2].any():
                taken[low - 1 : high + 2] = True
                path[low : high + 1] = path[low : high + 1][::-1]
    return path


def _distance(one: Floats, other: Floats) -> Floats:
    return np.asarray(np.sqrt(((one - other) ** 2).sum(axis=-1)))
