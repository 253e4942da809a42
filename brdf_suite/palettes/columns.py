"""The paints of a palette as columns of numbers: what tables show, and what searching and sorting work on.

Readings are taken as they are; an angle that was not read is what the paint's reflectance gives there, which takes a
millisecond a paint and is therefore done apart (:class:`ColumnsWork`, in pieces, on any thread). What was worked out
for a paint once is not worked out again while the paint is the same.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from operator import is_

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.colour.flat_colours import flat_labs
from brdf_suite.appearance.flop.edits import GREY_CHROMA
from brdf_suite.arrays import Bools, Floats, Indices
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import SuiteError
from brdf_suite.palettes.swatches.look import colours_at
from brdf_suite.reflectance.designed.build import build_reflectance

LIGHT_DEG = 45.0
MAIN_ANGLES_DEG = (15.0, 45.0, 110.0)
FACE_DEG = 45.0
_SAME_DEG = 0.5
_MOST_KEPT = 50_000


@dataclass(frozen=True, eq=False)
class Columns:
    """Numbers of entries, a row for each, in their order; NaN where something is not known.

    Attributes
    ----------
    entries
        The entries themselves.
    angles_deg
        (k,) aspecular angles, rising, 15, 45 and 110 among them; light at 45°.
    lab
        (n, k, 3) L*a*b*, D65 and 10°. A flat colour is the same at all angles.
    read
        (n, k) whether it was read there, or a flat colour's own; otherwise it is the reflectance's.
    gloss
        (n,) gloss units at 20°; NaN for what has no reading of it.
    waiting
        (n,) whether angles are still to be worked out.
    """

    entries: tuple[Entry, ...]
    angles_deg: tuple[float, ...]
    lab: Floats
    read: Bools
    gloss: Floats
    waiting: Bools

    def __len__(self) -> int:
        return len(self.entries)

    @staticmethod
    def of(entries: Sequence[Entry], angles_deg: Sequence[float] = MAIN_ANGLES_DEG) -> Columns:
        """Return the columns of entries, everything worked out."""
        work = ColumnsWork(entries, angles_deg)
        work.finish()
        return work.columns

    def at(self, aspecular_deg: float) -> Floats:
        """Return L*a*b* (n, 3) at one of the angles."""
        return self.lab[:, self.angles_deg.index(aspecular_deg)]

    @cached_property
    def main(self) -> Floats:
        """L*a*b* (n, 3, 3) at 15, 45 and 110°."""
        return np.ascontiguousarray(self.lab[:, [self.angles_deg.index(angle) for angle in MAIN_ANGLES_DEG]])

    @cached_property
    def lightness(self) -> Floats:
        """L* (n,) at 45°."""
        return self.main[:, 1, 0]

    @cached_property
    def chroma(self) -> Floats:
        """C*ab (n,) at 45°."""
        return np.hypot(self.main[:, 1, 1], self.main[:, 1, 2])

    @cached_property
    def hue(self) -> Floats:
        """Hue h_ab (n,) at 45°, 0 to 360°; NaN for a grey."""
        hue = np.degrees(np.arctan2(self.main[:, 1, 2], self.main[:, 1, 1])) % 360.0
        return np.where(self.chroma < GREY_CHROMA, np.nan, hue)

    @cached_property
    def flop(self) -> Floats:
        """Flop index (n,) of :func:`~brdf_suite.appearance.flop.travel.flop_index`."""
        near, face, far = self.main[:, :, 0].T
        with np.errstate(invalid="ignore", divide="ignore"):
            index = 2.69 * np.maximum(near - far, 0.0) ** 1.11 / np.where(face > 0.0, face, np.nan) ** 0.86
        return np.where(near <= far, 0.0, index)

    @cached_property
    def travel(self) -> Floats:
        """Length (n,) of the path in a*b* from 15° over 45° to 110°."""
        steps = np.diff(self.main[:, :, 1:], axis=1)
        return np.asarray(np.hypot(steps[..., 0], steps[..., 1]).sum(axis=1))


class ColumnsWork:
    """Columns that are worked out in pieces. ``known`` are older columns: rows whose paint is the same are taken over.

    Readings are there at once. :meth:`step` works out some of what was not read; call it on any one thread at a time,
    and take :attr:`columns` whenever they are wanted.
    """

    def __init__(
        self,
        entries: Sequence[Entry],
        angles_deg: Sequence[float] = MAIN_ANGLES_DEG,
        known: Columns | None = None,
    ) -> None:
        self._entries = tuple(entries)
        self._angles = tuple(sorted({*map(float, angles_deg), *MAIN_ANGLES_DEG}))
        count, angles = len(self._entries), len(self._angles)
        self._lab = np.full((count, angles, 3), np.nan)
        self._read = np.zeros((count, angles), bool)
        self._gloss = np.full(count, np.nan)
        self._waiting = np.zeros(count, bool)
        self.sources: Indices = np.full(count, -1, np.intp)
        """(n,) the row of ``known`` that each row was taken over from, -1 where there is none."""
        if known is not None and known.angles_deg == self._angles:
            self.sources = same_contents(self._entries, known.entries)
            self._take_over(known)
        self._take_readings(np.flatnonzero(self.sources < 0).tolist())
        self._todo = np.flatnonzero(self._waiting).tolist()
        self._place = 0

    @property
    def columns(self) -> Columns:
        """What is known so far; a value of its own."""
        return Columns(
            self._entries,
            self._angles,
            self._lab.copy(),
            self._read.copy(),
            self._gloss.copy(),
            self._waiting.copy(),
        )

    @property
    def left(self) -> int:
        """How many entries still wait."""
        return len(self._todo) - self._place

    def step(self, count: int = 50) -> bool:
        """Work out so many more entries; return whether any are left."""
        for index in self._todo[self._place : self._place + count]:
            content = self._entries[index].content
            missing = ~self._read[index]
            angles = tuple(angle for angle, wanted in zip(self._angles, missing, strict=True) if wanted)
            if not isinstance(content, FlatColour):
                self._lab[index, missing] = _computed(content, angles)
            self._waiting[index] = False
        self._place = min(self._place + count, len(self._todo))
        return self.left > 0

    def finish(self) -> None:
        """Work out all that is left."""
        self.step(self.left)

    def _take_over(self, known: Columns) -> None:
        """Copy the rows of the same paints."""
        rows = self.sources >= 0
        sources = self.sources[rows]
        for own, older in (
            (self._lab, known.lab),
            (self._read, known.read),
            (self._gloss, known.gloss),
            (self._waiting, known.waiting),
        ):
            own[rows] = older[sources]

    def _take_readings(self, rows: Sequence[int]) -> None:
        flat: list[int] = []
        colours: list[FlatColour] = []
        # Of many entries numpy would make an array of tuples in one step, which holds up the thread of a window.
        read_rows, readings = array("q"), array("d")
        for row in rows:
            content = self._entries[row].content
            if isinstance(content, Paint):
                self._gloss[row] = content.gloss.gu_20
                for m in content.measurements:
                    read_rows.append(row)
                    readings.extend((m.illumination_deg, m.aspecular_deg, *m.lab))
            elif isinstance(content, FlatColour):
                flat.append(row)
                colours.append(content)
            self._waiting[row] = True
        if colours:
            self._lab[flat] = flat_labs(colours)[:, None]
            self._read[flat] = True
        if read_rows:
            of, table = np.frombuffer(read_rows, np.int64), np.frombuffer(readings).reshape(-1, 5)
            under = np.abs(table[:, 0] - LIGHT_DEG) <= _SAME_DEG
            for place, angle in enumerate(self._angles):
                off = np.abs(table[:, 1] - angle)
                # The nearest reading comes last, and stays.
                near = np.flatnonzero(under & (off <= _SAME_DEG))
                near = near[np.argsort(-off[near], kind="stable")]
                self._lab[of[near], place] = table[near, 2:]
                self._read[of[near], place] = True
        self._waiting &= ~self._read.all(axis=1)


def same_contents(entries: Sequence[Entry], known: Sequence[Entry]) -> Indices:
    """Return for each of ``entries`` (n,) a place in ``known`` whose entry has the very same content, -1 for none.

    Most edits leave most entries where they were, or shift those behind one place: they are compared there first. Of a
    content that is new in one place and known in another the place may be missed where that is taken already.
    """
    count, before = len(entries), len(known)
    found = np.full(count, -1, np.intp)
    fewer = min(count, before)
    same = np.fromiter(map(is_, entries, known), bool, fewer)
    found[:fewer] = np.where(same, np.arange(fewer), -1)
    if count != before:
        # From the end: behind what was put in or taken out.
        same = np.fromiter(map(is_, reversed(entries), reversed(known)), bool, fewer)
        at_end = np.where(same, np.arange(before - 1, before - 1 - fewer, -1), -1)[::-1]
        found[count - fewer :] = np.where(at_end >= 0, at_end, found[count - fewer :])
    rest = np.flatnonzero(found < 0)
    if len(rest):
        free = np.ones(before, bool)
        free[found[found >= 0]] = False
        # Both hold their contents, so the addresses are theirs alone.
        places = {id(known[place].content): place for place in np.flatnonzero(free).tolist()}
        found[rest] = [places.get(id(entries[row].content), -1) for row in rest.tolist()]
    return found


@lru_cache(maxsize=_MOST_KEPT)
def _computed(paint: AnyPaint, angles_deg: tuple[float, ...]) -> Floats:
    """L*a*b* (k, 3) that the reflectance gives at aspecular angles; NaN where there is no such paint."""
    try:
        reflectance = build_reflectance(paint)
    except SuiteError:
        return np.full((len(angles_deg), 3), np.nan)
    return working_to_lab(colours_at(reflectance, np.array(angles_deg), LIGHT_DEG))


def labs_of(content: object, angles_deg: Sequence[float] = MAIN_ANGLES_DEG) -> Floats:
    """Return L*a*b* (k, 3) of one paint or flat colour at aspecular angles, light at 45°; NaN where not known."""
    entry = Entry(content)  # type: ignore[arg-type]  # the entry checks it
    columns = Columns.of([entry], angles_deg)
    return np.stack([columns.at(float(angle))[0] for angle in angles_deg])
