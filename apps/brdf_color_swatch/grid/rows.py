"""What a list of swatches is made of: the entries of a palette with their figures and colours, worked out once each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from operator import is_not
from typing import Any

import numpy as np
from brdf_qt.program.translation import decimal, tr

from brdf_color_swatch.grid.tile import Tile
from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, lab_to_working, srgb_encode
from brdf_suite.appearance.colour.flat_colours import display_notes
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, GroupPath
from brdf_suite.palettes.columns import MAIN_ANGLES_DEG, Columns, ColumnsWork
from brdf_suite.palettes.search import Texts
from brdf_suite.progress import Progress

ANGLES_DEG = MAIN_ANGLES_DEG
"""The angles that quality control of flake finishes reads, from the face to the flop."""

GROUP_SIGN = " › "


def group_title(path: Sequence[str]) -> str:
    """Return a group's path as people read it."""
    return GROUP_SIGN.join(name or tr("(no name)") for name in path)


@dataclass(frozen=True, eq=False)
class Rows:
    """Entries and their figures: ``columns``, and ``codes`` (n, 3, 3), the sRGB of L*a*b* at 15, 45 and 110°.

    ``kept`` holds orders and the like that were worked out once.
    """

    columns: Columns
    codes: np.ndarray
    kept: dict[Hashable, Any] = field(default_factory=dict)

    @staticmethod
    def empty() -> Rows:
        return Rows(Columns.of(()), np.zeros((0, 3, 3), np.uint8))

    @property
    def entries(self) -> tuple[Entry, ...]:
        return self.columns.entries

    @property
    def lab(self) -> np.ndarray:
        """L*a*b* (n, 3, 3) at :data:`ANGLES_DEG`; NaN where it is not known."""
        return self.columns.main

    @cached_property
    def notes(self) -> tuple[str, ...]:
        """What is to be known of how the flat colours are shown, sentences."""
        return display_notes([e.content for e in self.entries if isinstance(e.content, FlatColour)])

    @cached_property
    def inks(self) -> int:
        """How many colours are in CMYK."""
        return sum(isinstance(e.content, FlatColour) and e.content.model == "CMYK" for e in self.entries)

    @cached_property
    def groups(self) -> tuple[np.ndarray, tuple[GroupPath, ...]]:
        """Which group each entry is in: (n,) places in the paths of the groups, in the order in which they come."""
        places: dict[GroupPath, int] = {}
        of = [places.setdefault(entry.group, len(places)) for entry in self.entries]
        return np.array(of, np.intp), tuple(places)

    @cached_property
    def tag_counts(self) -> Counter[str]:
        """How many entries have each tag."""
        found: Counter[str] = Counter()
        # Many entries have the same tags: the sets of them are counted first.
        for tags, count in Counter(entry.tags for entry in self.entries).items():
            for tag in tags:
                found[tag] += count
        return found

    @cached_property
    def has_codes(self) -> bool:
        return any(entry.code for entry in self.entries)

    @cached_property
    def texts(self) -> Texts:
        """The words to search by, folded once."""
        return Texts(self.entries)

    @property
    def has_texts(self) -> bool:
        """Whether the words to search by are folded already."""
        return "texts" in vars(self)

    @cached_property
    def ids(self) -> tuple[str, ...]:
        return tuple([entry.id for entry in self.entries])

    def __len__(self) -> int:
        return len(self.entries)

    def name(self, place: int) -> str:
        """Return a name that is never empty."""
        return self.entries[place].name or self.entries[place].code or tr("(no name)")

    def tile(self, place: int, picture: object, delta_e: float | None) -> Tile:
        """Return what the grid shows of a row; ``picture`` a QPixmap or None."""
        entry = self.entries[place]
        below = decimal(f"ΔE00 {delta_e:.2f}") if delta_e is not None else entry.code
        name, spot = self.name(place), entry.usage == "spot"
        return Tile(name, below, self.codes[place], ANGLES_DEG, entry.is_flat, picture, spot)  # type: ignore[arg-type]  # rows know no pixmaps

    def text(self, place: int, key: str) -> str:
        """Return what a column of the list shows."""
        entry = self.entries[place]
        if key == "name":
            return entry.name
        if key == "code":
            return entry.code
        if key == "tags":
            return ", ".join(entry.tags)
        if key == "date":
            return entry.date[:10]
        if key == "gloss":
            return _number(self.columns.gloss[place], 0)
        if key == "flop":
            return _number(self.columns.flop[place], 1)
        axis, _, angle = key.partition("_")
        value = self.lab[place, ANGLES_DEG.index(float(angle)), "Lab".index(axis) if axis != "L" else 0]
        return _number(value, 1)

    def describe(self, place: int, delta_e: float | None = None) -> str:
        """Return the tool tip of a row: figures with their units."""
        entry = self.entries[place]
        lines = [self.name(place)[:200]]
        if entry.code:
            lines.append(tr("Code {code}").format(code=entry.code))
        lines += [
            decimal(f"{angle:g}°: L* {lab[0]:.1f}  a* {lab[1]:.1f}  b* {lab[2]:.1f}")
            for angle, lab in zip(ANGLES_DEG, self.lab[place], strict=True)
            if np.isfinite(lab[0]) and not entry.is_flat
        ]
        if isinstance(entry.content, FlatColour):
            lab = self.lab[place, 1]
            lines.append(tr("Flat colour, {model}").format(model=entry.content.model))
            lines.append(decimal(f"L* {lab[0]:.1f}  a* {lab[1]:.1f}  b* {lab[2]:.1f}"))
        else:
            flop, gloss = _number(self.columns.flop[place], 1), _number(self.columns.gloss[place], 0)
            if flop:
                lines.append(tr("Flop {flop}").format(flop=flop))
            if gloss:
                lines.append(tr("Gloss 20°: {gloss} GU").format(gloss=gloss))
        if delta_e is not None:
            lines.append(tr("ΔE00 to the search target: {value}").format(value=f"{delta_e:.2f}"))
        if entry.tags:
            lines.append(tr("Tags: {tags}").format(tags=", ".join(entry.tags)))
        if entry.group:
            lines.append(tr("Group: {group}").format(group=group_title(entry.group)[:200]))
        return "\n".join(lines).replace("* -", "* −")

    def describe_aloud(self, place: int) -> str:
        """Return what a screen reader says of a row."""
        lab = self.lab[place, 1]
        name = self.name(place)[:200]
        if not np.isfinite(lab[0]):
            return name
        flop = _number(self.columns.flop[place], 1) or "0"
        return tr("{name}, L* {L}, a* {a}, b* {b} at 45°, flop {flop}").format(
            name=name, L=f"{lab[0]:.0f}", a=f"{lab[1]:.0f}", b=f"{lab[2]:.0f}", flop=flop
        )


def _number(value: float, decimals: int) -> str:
    return decimal(f"{value:.{decimals}f}").replace("-", "−") if np.isfinite(value) else ""


_STEP = 25


def rows_of(entries: Sequence[Entry], before: Rows | None = None) -> Rows:
    """Return the rows of entries, with what is read; what ``before`` has of the same contents is taken from it."""
    work = ColumnsWork(entries, known=None if before is None else before.columns)
    columns = work.columns
    codes = np.empty((len(columns), 3, 3), np.uint8)
    kept = work.sources >= 0
    if before is not None:
        codes[kept] = before.codes[work.sources[kept]]
    codes[~kept] = codes_of(columns.main[~kept])
    rows = Rows(columns, codes)
    if before is not None:
        _take_over_counts(rows, before)
    return rows


_MOST_CHANGED = 2_000
_DECIDED_BY: dict[str, Callable[[Entry], object]] = {
    "groups": lambda entry: entry.group,
    "ids": lambda entry: entry.id,
    "has_codes": lambda entry: bool(entry.code),
    "notes": lambda entry: entry.content if entry.is_flat else None,
}
"""What is worked out from all entries, by what of an entry it depends on."""


def _take_over_counts(rows: Rows, before: Rows) -> None:
    """Keep what ``before`` has worked out from all of its entries, where few of them were replaced since."""
    if len(rows) != len(before):
        return
    replaced = np.fromiter(map(is_not, rows.entries, before.entries), bool, len(rows))
    if np.count_nonzero(replaced) > _MOST_CHANGED:
        return
    changes = [(before.entries[place], rows.entries[place]) for place in np.flatnonzero(replaced).tolist()]
    known, own = vars(before), vars(rows)
    for name, decided_by in _DECIDED_BY.items():
        if name in known and all(decided_by(old) == decided_by(new) for old, new in changes):
            own[name] = known[name]
    if "tag_counts" in known:
        counts = before.tag_counts.copy()
        for old, new in changes:
            counts.subtract(old.tags)
            counts.update(new.tags)
        own["tag_counts"] = +counts


def finish_rows(rows: Rows, progress: Progress) -> Rows:
    """Return rows with what was not read worked out from the reflectances: a millisecond a paint, for a thread."""
    work = ColumnsWork(rows.entries, known=rows.columns)
    whole = max(1, work.left)
    while work.step(_STEP):
        progress(1.0 - work.left / whole, "")
    columns = work.columns
    finished = Rows(columns, codes_of(columns.main))
    _take_over_counts(finished, rows)
    return finished


def codes_of(lab: np.ndarray) -> np.ndarray:
    """Return sRGB codes (..., 3) of L*a*b* (D65, 10°), clipped to what a screen shows; mid grey where it is NaN."""
    linear = lab_to_working(np.nan_to_num(lab)) @ WORKING_TO_SRGB.T
    codes = np.rint(255.0 * srgb_encode(np.clip(linear, 0.0, 1.0))).astype(np.uint8)
    codes[~np.isfinite(lab).all(axis=-1)] = 119
    return codes
