"""Paints kept together: a palette of swatches in groups, each a paint with notes and tags.

All values are frozen; an edit makes a new one. A bad value raises :class:`ValueRangeError` whose ``place`` names the
field (``groups[1].swatches[0].tags[2]``).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.parameter import check_text, describe
from brdf_suite.errors import ValueRangeError

MOST_SWATCHES = 5000
"""A file of ours holds 16 MB, some ten thousand paints of three readings."""

MOST_TAGS = 50
_MOST_GROUPS = 500


@dataclass(frozen=True)
class Swatch:
    """A paint in a palette. ``tags`` are short words to search by, none twice; ``notes`` are the user's own."""

    paint: Paint | CookTorrancePaint
    tags: tuple[str, ...] = ()
    notes: str = ""

    def __post_init__(self) -> None:
        if not isinstance(self.paint, (Paint, CookTorrancePaint)):
            raise ValueRangeError("paint", f"a paint is wanted, not {describe(self.paint)}")
        tags = _items(self.tags, "tags", str, MOST_TAGS)
        for index, tag in enumerate(tags):
            check_text(tag, f"tags[{index}]", longest=50, lines=False, empty=False)
            if tag in tags[:index]:
                raise ValueRangeError(f"tags[{index}]", f"the tag {tag!r} is there twice")
        object.__setattr__(self, "tags", tags)
        check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)

    @property
    def name(self) -> str:
        """The paint's."""
        return self.paint.name


@dataclass(frozen=True)
class Group:
    """Swatches under a name, in the user's order."""

    name: str
    swatches: tuple[Swatch, ...] = ()
    notes: str = ""

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=200, lines=False, empty=False)
        object.__setattr__(self, "swatches", _items(self.swatches, "swatches", Swatch, MOST_SWATCHES))
        check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)


@dataclass(frozen=True)
class Palette:
    """Swatches before all groups, then groups of them.

    >>> palette = Palette("Summer", (Swatch(solid_paint("white", (95.0, 0.0, 1.0))),))
    >>> [swatch.name for swatch in palette]
    ['white']
    """

    name: str
    swatches: tuple[Swatch, ...] = ()
    groups: tuple[Group, ...] = ()
    notes: str = ""

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=200, lines=False, empty=False)
        object.__setattr__(self, "swatches", _items(self.swatches, "swatches", Swatch, MOST_SWATCHES))
        object.__setattr__(self, "groups", _items(self.groups, "groups", Group, _MOST_GROUPS))
        names = [group.name for group in self.groups]
        for index, name in enumerate(names):
            if name in names[:index]:
                raise ValueRangeError(f"groups[{index}].name", f"the group {name!r} is there twice")
        if len(self) > MOST_SWATCHES:
            raise ValueRangeError(
                "groups", f"{len(self)} swatches in all are more than the {MOST_SWATCHES} allowed"
            )
        check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)

    def __len__(self) -> int:
        """Return the number of swatches in all."""
        return len(self.swatches) + sum(len(group.swatches) for group in self.groups)

    def __iter__(self) -> Iterator[Swatch]:
        """Yield all swatches in order: those before the groups, then group by group."""
        yield from self.swatches
        for group in self.groups:
            yield from group.swatches


def _items(value: object, place: str, kind: type, most: int) -> tuple[Any, ...]:
    if not isinstance(value, (tuple, list)):
        raise ValueRangeError(place, f"a list is wanted, not {describe(value)}")
    if len(value) > most:
        raise ValueRangeError(place, f"{len(value)} are more than the {most} allowed")
    for index, item in enumerate(value):
        if not isinstance(item, kind):
            raise ValueRangeError(
                f"{place}[{index}]", f"a {kind.__name__.lower()} is wanted, not {describe(item)}"
            )
    return tuple(value)
