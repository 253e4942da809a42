"""Finding paints in a palette: by the nearest colour at every angle, by ranges of their numbers, by words.

The difference of two paints is ΔE00 at each angle, and one number of them: their mean (what the whole paint differs by)
or the worst. The nearest of ten thousand are found exactly, with a bound that spares most of the formula:

    ΔE00² ≥ (ΔL*/S_L)² + (1 - √3/2) (Δa*² + Δb*²) / (1 + 0.0675 C̄)²,

for |R_T| ≤ √3, x² + y² + R_T x y ≥ (1 - |R_T|/2) (x² + y²); a* is only ever stretched, by at most 1.5, so that the
chord ΔC'² + ΔH'² is at least Δa*² + Δb*², and S_C and S_H are at most 1 + 0.045 · 1.5 C̄, C̄ being the mean chroma.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Bools, Floats, Indices
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.parameter import check_choice
from brdf_suite.errors import ValueRangeError
from brdf_suite.palettes.columns import Columns

Combine = Literal["mean", "worst"]
COMBINATIONS: tuple[str, ...] = get_args(Combine)
_PLANE = 1.0 - 0.5 * 3.0**0.5
_STRETCHED = 0.045 * 1.5
_ROUNDING = 1e-9
_FIRST = 64


@dataclass(frozen=True, eq=False)
class Nearest:
    """The nearest entries, the nearest first: their places (m,), ΔE00 (m,) and that at each angle (m, k).

    ``compared`` is for how many entries the whole formula was worked out.
    """

    indices: Indices
    delta_e: Floats
    per_angle: Floats
    compared: int


def nearest(
    columns: Columns,
    lab: npt.ArrayLike,
    count: int = 20,
    combine: Combine = "mean",
    among: Bools | None = None,
) -> Nearest:
    """Return the ``count`` entries nearest to L*a*b* (k, 3) at the columns' angles; equal ones by their order.

    The answer is the one that comparing with every entry gives. An angle at which the wanted colour is not known (NaN)
    does not count; an entry that is not known at one that counts is not found. ``among`` (n,) leaves others out.

    Raises :class:`ValueRangeError`: the colour is known at none of the angles, or its shape is another.
    """
    check_choice(combine, "combine", COMBINATIONS)
    wanted = np.asarray(lab, float)
    if wanted.shape != (len(columns.angles_deg), 3):
        raise ValueRangeError("lab", f"a colour at each of {len(columns.angles_deg)} angles is wanted")
    known = np.isfinite(wanted).all(axis=1)
    if not known.any():
        raise ValueRangeError("lab", "the colour is known at none of the angles")
    wanted, labs = wanted[known], columns.lab[:, known]
    able = np.isfinite(labs).all(axis=(1, 2))
    if among is not None:
        able &= among
    places = np.flatnonzero(able)
    count = min(max(0, int(count)), len(places))
    whole = places.size
    if count and whole > 4 * _FIRST:
        places = _worth_comparing(wanted, labs, places, count, combine)
    per_angle = np.full((len(places), known.size), np.nan)
    per_angle[:, known] = delta_e_2000(wanted, labs[places])
    combined = _combined(per_angle[:, known], combine)
    order = np.lexsort((places, combined))[:count]
    return Nearest(places[order], combined[order], per_angle[order], len(places))


def _worth_comparing(wanted: Floats, labs: Floats, places: Indices, count: int, combine: Combine) -> Indices:
    """The places that may be among the nearest: none of the others can be."""
    bound = _combined(lower_bound(wanted, labs[places]), combine)
    first = np.argpartition(bound, min(len(places) - 1, max(count, _FIRST)))[: max(count, _FIRST)]
    exact = _combined(delta_e_2000(wanted, labs[places[first]]), combine)
    reached = float(np.partition(exact, count - 1)[count - 1])
    return np.asarray(places[bound <= reached * (1.0 + _ROUNDING) + _ROUNDING])


def _combined(differences: Floats, combine: Combine) -> Floats:
    return np.asarray(differences.mean(axis=-1) if combine == "mean" else differences.max(axis=-1))


def lower_bound(lab1: npt.ArrayLike, lab2: npt.ArrayLike) -> Floats:
    """Return a number (...) that ΔE00 between L*a*b* (..., 3) is never below, at a fifth of its price."""
    first, second = np.asarray(lab1, float), np.asarray(lab2, float)
    difference = second - first
    middle = (0.5 * (first[..., 0] + second[..., 0]) - 50.0) ** 2
    s_l = 1.0 + 0.015 * middle / np.sqrt(20.0 + middle)
    mean_chroma = 0.5 * (np.hypot(first[..., 1], first[..., 2]) + np.hypot(second[..., 1], second[..., 2]))
    plane = difference[..., 1] ** 2 + difference[..., 2] ** 2
    squared = (difference[..., 0] / s_l) ** 2 + _PLANE * plane / (1.0 + _STRETCHED * mean_chroma) ** 2
    return np.asarray(np.sqrt(squared))


Range = tuple[float, float]


@dataclass(frozen=True)
class Filter:
    """What entries are shown; what is left at its default says nothing.

    Attributes
    ----------
    text
        Words that must all be in name, code, notes or tags, in any script and letter case.
    tags
        Tags that an entry must all have.
    hue
        From and to, degrees, growing; (330, 30) goes over 0. A grey has no hue and is left out.
    chroma, lightness, flop, gloss
        Lowest and highest: at 45°, the flop index, gloss units at 20°. What is not known is left out.
    group
        The path of a group: what is in it, and in those within.
    """

    text: str = ""
    tags: tuple[str, ...] = ()
    hue: Range | None = None
    chroma: Range | None = None
    lightness: Range | None = None
    flop: Range | None = None
    gloss: Range | None = None
    group: tuple[str, ...] = ()


def matching(columns: Columns, wanted: Filter, texts: Texts | None = None) -> Bools:
    """Return which entries (n,) a filter shows; ``texts`` of the same entries spare their folding."""
    shown = np.ones(len(columns), bool)
    for values, limits in (
        (
            (columns.chroma, wanted.chroma),
            (columns.lightness, wanted.lightness),
            (columns.flop, wanted.flop),
            (columns.gloss, wanted.gloss),
        )
        if len(columns)
        else ()
    ):
        if limits is not None:
            with np.errstate(invalid="ignore"):
                shown &= (values >= limits[0]) & (values <= limits[1])
    if wanted.hue is not None:
        shown &= in_hue_range(columns.hue, *wanted.hue)
    if wanted.tags:
        asked = {_folded(tag) for tag in wanted.tags}
        # Many entries have the same tags, or the same group: each is looked at once.
        has = {
            tags: asked <= {_folded(tag) for tag in tags}
            for tags in {entry.tags for entry in columns.entries}
        }
        shown &= np.fromiter((has[entry.tags] for entry in columns.entries), bool, len(columns))
    if wanted.group:
        depth = len(wanted.group)
        inside = {path: path[:depth] == wanted.group for path in {entry.group for entry in columns.entries}}
        shown &= np.fromiter((inside[entry.group] for entry in columns.entries), bool, len(columns))
    if wanted.text.strip():
        shown &= (texts or Texts(columns.entries)).matching(wanted.text)
    return shown


def in_hue_range(hue: npt.ArrayLike, low_deg: float, high_deg: float) -> Bools:
    """Return which hues lie on the way from ``low_deg`` up to ``high_deg``, over 360° where need be; a turn is all.

    >>> in_hue_range([350.0, 10.0, 180.0, float("nan")], 330.0, 30.0).tolist()
    [True, True, False, False]
    """
    hue = np.asarray(hue, float)
    if high_deg - low_deg >= 360.0:
        return np.asarray(np.isfinite(hue))
    width = (high_deg - low_deg) % 360.0
    with np.errstate(invalid="ignore"):
        return np.asarray((hue - low_deg) % 360.0 <= width)


class Texts:
    """The words of entries, folded once: what is typed is then looked for in a moment."""

    def __init__(self, entries: Sequence[Entry]) -> None:
        self._whole = [
            "\n".join(_folded(part) for part in (entry.name, entry.code, *entry.tags, entry.notes) if part)
            for entry in entries
        ]
        self._plain = [text if text.isascii() else _without_accents(text) for text in self._whole]

    def matching(self, text: str) -> Bools:
        """Return which entries (n,) have all words of ``text``.

        Letter case and forms of letters do not count; accents count where they are typed.
        """
        shown = np.ones(len(self._whole), bool)
        for word in _folded(text).split():
            accented = _without_accents(word) != word
            pool = self._whole if accented else self._plain
            shown &= np.fromiter((word in item for item in pool), bool, len(pool))
        return shown


def _folded(text: str) -> str:
    """Text for comparing: compatible forms of letters made one, no letter case (Unicode, section 5.18)."""
    if text.isascii():
        return text.lower()
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFKC", text).casefold())


def _without_accents(text: str) -> str:
    # The combining accents of Latin, Greek and Cyrillic; marks of other scripts are letters there.
    apart = unicodedata.normalize("NFD", text)
    return unicodedata.normalize("NFC", "".join(c for c in apart if not "\u0300" <= c <= "\u036f"))
