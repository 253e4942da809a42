"""The paints that the arrow keys go through: those of the open palette, or the shipped ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from brdf_qt.program.translation import tr

from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.store import AnyPaint
from brdf_suite.pipeline.material import ENTRY_MARK

_MARK = "palette:"


@dataclass(frozen=True)
class OpenPalette:
    """A palette and the file that it was read from."""

    path: str
    palette: Palette

    @property
    def keys(self) -> tuple[str, ...]:
        """The swatches' keys, in their order; no path and no shipped name looks like one.

        >>> OpenPalette("/a.brdfpalette", Palette("Empty")).keys
        ()
        """
        return tuple(f"{_MARK}{number}" for number in range(len(self.palette)))

    @property
    def paints(self) -> dict[str, AnyPaint]:
        return dict(zip(self.keys, (to_paint(entry.content) for entry in self.palette), strict=True))

    def name_of(self, key: str) -> str:
        """Return the name by which a swatch is loaded from the palette's file; any other key as it is.

        >>> OpenPalette("/a.brdfpalette", Palette("Empty")).name_of("blue")
        'blue'
        """
        if key not in self.keys:
            return key
        return f"{self.path}{ENTRY_MARK}{self.palette.entries[self.keys.index(key)].id}"

    def words(self, key: str) -> str:
        """Return which of the palette's paints this is, as in ``Summer, 3 of 12``; empty for none of them.

        >>> OpenPalette("/a.brdfpalette", Palette("Empty")).words("blue")
        ''
        """
        keys = self.keys
        if key not in keys:
            return ""
        name = self.palette.name or Path(self.path).stem
        text = tr("{name}, {number} of {count}")
        return text.format(name=name, number=keys.index(key) + 1, count=len(keys))


def is_swatch(key: str) -> bool:
    """Return whether a key stands for a paint of the open palette."""
    return key.startswith(_MARK)


def stepped(keys: Sequence[str], present: str, step: int) -> str | None:
    """Return the key that is ``step`` on from the present one, round and round; None where there are no keys.

    From a paint that is none of them the first step leads to the first, or backwards to the last.

    >>> stepped(["a", "b", "c"], "c", 1), stepped(["a", "b", "c"], "x", -1), stepped([], "a", 1)
    ('a', 'c', None)
    """
    if not keys:
        return None
    if present not in keys:
        return keys[0] if step > 0 else keys[-1]
    return keys[(list(keys).index(present) + step) % len(keys)]
