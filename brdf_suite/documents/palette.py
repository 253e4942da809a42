"""Palette: paints and flat colours in order, in nested groups.

All values are frozen; an edit (:mod:`brdf_suite.documents.palette_edits`) makes a new one. A bad value raises
:class:`ValueRangeError` whose ``place`` names the field (``entries[3].tags[2]``).
"""

from __future__ import annotations

import re
import secrets
from collections.abc import Iterator, Mapping
from copy import copy
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cached_property
from typing import Literal, get_args

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.parameter import as_whole, check_choice, check_items, check_text, describe
from brdf_suite.errors import ValueRangeError
from brdf_suite.notebook import Shown

MOST_ENTRIES = 100_000
MOST_GROUPS = 10_000
DEEPEST_GROUP = 32
MOST_TAGS = 50

Usage = Literal["process", "global", "spot"]
USAGES: tuple[str, ...] = get_args(Usage)
"""Kinds of colour in layout programs: process (mixed from inks), global (shared by its users), spot ink."""

GroupPath = tuple[str, ...]
"""The names of groups from the outside in; empty for what is in none."""

Foreign = tuple[tuple[str, str], ...]
"""Fields of another program's file that are not interpreted, by name, kept so that they can be written back."""

_LONGEST_NAME = 1000
_COLOUR = re.compile("#[0-9a-f]{6}")
_DATE = re.compile(r"\d{4}-\d\d-\d\d(T\d\d:\d\d(:\d\d(\.\d+)?)?(Z|[+-]\d\d:\d\d)?)?")


@dataclass(frozen=True, slots=True)
class Entry:
    """A paint or a flat colour in a palette.

    Attributes
    ----------
    content
        The paint, of any kind, or the flat colour.
    id
        Unique in its palette, and the same for as long as the entry lives; a palette fills in what is empty.
    group
        The group that it is in.
    code
        The maker's number.
    tags, notes
        Short words to search by, none twice; the user's own text.
    usage
        ``process``, ``global`` or ``spot``, as layout programs distinguish colours.
    date
        ISO 8601, a day or a moment, or empty.
    foreign
        Pairs of a name and a text: fields of another program's file, kept to be written back.

    >>> import brdf_suite as bs
    >>> bs.Entry(bs.load("blue", bs.Paint), code="B-12", tags=("metallic",)).name
    'Blue'
    """

    content: Paint | CookTorrancePaint | FactoredPaint | FlatColour
    id: str = ""
    group: GroupPath = ()
    code: str = ""
    tags: tuple[str, ...] = ()
    notes: str = ""
    usage: Usage = "process"
    date: str = ""
    foreign: Foreign = ()

    def __post_init__(self) -> None:
        if not isinstance(self.content, (Paint, CookTorrancePaint, FactoredPaint, FlatColour)):
            raise ValueRangeError(
                "content", f"expected a paint or a flat colour, not {describe(self.content)}"
            )
        # Most fields of most entries have their default, and a file may hold a hundred thousand entries.
        check_text(self.id, "id", longest=64, lines=False, empty=True)
        if self.group != ():
            _set(self, "group", check_path(self.group, "group"))
        if self.code != "":
            check_text(self.code, "code", longest=200, lines=False, empty=True)
        if self.tags != ():
            _set(self, "tags", self._checked_tags())
        if self.notes != "":
            check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)
        if self.usage != "process":
            check_choice(self.usage, "usage", USAGES)
        if self.date != "":
            _check_date(self.date)
        if self.foreign != ():
            _set(self, "foreign", _checked_foreign(self.foreign))

    def _checked_tags(self) -> tuple[str, ...]:
        tags: tuple[str, ...] = check_items(self.tags, "tags", str, MOST_TAGS)
        for index, tag in enumerate(tags):
            check_text(tag, f"tags[{index}]", longest=50, lines=False, empty=False)
            if tag in tags[:index]:
                raise ValueRangeError(f"tags[{index}]", f"the tag {tag!r} is there twice")
        return tags

    @property
    def name(self) -> str:
        """The paint's or the colour's; only a flat colour's may be empty."""
        return self.content.name

    @property
    def is_flat(self) -> bool:
        """Whether it is a colour and no paint."""
        return isinstance(self.content, FlatColour)


@dataclass(frozen=True)
class Group:
    """A palette group: its path and notes; ``colour`` (``#rrggbb`` or empty) marks it visually."""

    path: GroupPath
    notes: str = ""
    colour: str = ""
    foreign: Foreign = ()

    def __post_init__(self) -> None:
        _set(self, "path", check_path(self.path, "path"))
        if not self.path:
            raise ValueRangeError("path", "a group has a name")
        check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)
        _check_colour(self.colour)
        _set(self, "foreign", _checked_foreign(self.foreign))

    @property
    def name(self) -> str:
        """The last name of its path; some programs leave it empty."""
        return self.path[-1]


@dataclass(frozen=True)
class Palette(Shown):
    """Entries in the user's order, and the groups that they are in; a group may be empty.

    Groups that entries are in but that are not declared are added, those around a group before it. ``columns`` is how
    many stand in a row (0: not said), ``colour`` a mark (``#rrggbb`` or empty), ``notes`` the user's text, and
    ``foreign`` what another program's file said, as in an :class:`Entry`. Entries without an id get their number.

    >>> import brdf_suite as bs
    >>> palette = bs.Palette("Summer", (bs.Entry(bs.load("blue", bs.Paint), group=("Dark",)),))
    >>> [(entry.id, entry.name) for entry in palette], [group.name for group in palette.groups]
    ([('1', 'Blue')], ['Dark'])
    """

    name: str
    entries: tuple[Entry, ...] = ()
    groups: tuple[Group, ...] = ()
    notes: str = ""
    colour: str = ""
    columns: int = 0
    foreign: Foreign = ()

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=_LONGEST_NAME, lines=False, empty=False)
        entries = check_items(self.entries, "entries", Entry, MOST_ENTRIES)
        _set(self, "entries", _with_ids(entries))
        _set(
            self, "groups", _all_groups(check_items(self.groups, "groups", Group, MOST_GROUPS), self.entries)
        )
        check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)
        _check_colour(self.colour)
        _set(self, "columns", as_whole(self.columns))
        if (
            isinstance(self.columns, bool)
            or not isinstance(self.columns, int)
            or not 0 <= self.columns <= 10_000
        ):
            raise ValueRangeError(
                "columns", f"expected a whole number from 0 to 10,000, not {describe(self.columns)}"
            )
        _set(self, "foreign", _checked_foreign(self.foreign))

    def __len__(self) -> int:
        """Return the number of entries."""
        return len(self.entries)

    def __iter__(self) -> Iterator[Entry]:
        """Yield the entries in their order."""
        return iter(self.entries)

    @cached_property
    def by_id(self) -> Mapping[str, int]:
        """Where each entry stands, by its id."""
        return {entry.id: index for index, entry in enumerate(self.entries)}

    def entry(self, id_: str) -> Entry:
        """Return the entry whose id is ``id_``; :class:`KeyError` where there is none.

        >>> import brdf_suite as bs
        >>> bs.Palette("Mine", (bs.Entry(bs.load("blue", bs.Paint), id="b"),)).entry("b").name
        'Blue'
        """
        return self.entries[self.by_id[id_]]

    def with_entries(self, changed: Mapping[int, Entry]) -> Palette:
        """Return the palette with other entries in some places; the rest is not checked once more.

        ``changed`` has them by their places. Raises :class:`ValueRangeError` where one has another id than the entry
        whose place it takes.

        >>> import brdf_suite as bs
        >>> mine = bs.Palette("Mine", (bs.Entry(bs.load("blue", bs.Paint), id="b"),))
        >>> mine.with_entries({0: bs.Entry(bs.load("blue", bs.Paint), id="b", code="B-12")}).entries[0].code
        'B-12'
        """
        entries = list(self.entries)
        for place, entry in changed.items():
            if entry.id != entries[place].id:
                raise ValueRangeError(f"entries[{place}].id", f"expected the id {entries[place].id!r}")
            entries[place] = entry
        made = copy(self)  # with the places by id, which stay
        _set(made, "entries", tuple(entries))
        _set(made, "groups", _all_groups(self.groups, tuple(changed.values())))
        return made

    def sections(self) -> list[tuple[Group | None, tuple[Entry, ...]]]:
        """Return the palette in the order of a file with groups: each group once, with the entries directly in it.

        What is in no group is a section without one, as many as there are runs of it. A group stands where its first
        entry does, or the first of those within it, and these follow it; an empty one stands behind the group that was
        declared before it.

        >>> import brdf_suite as bs
        >>> blue = bs.load("blue", bs.Paint)
        >>> mine = bs.Palette("Mine", (bs.Entry(blue), bs.Entry(blue, group=("Dark",))))
        >>> [(group and group.name, len(entries)) for group, entries in mine.sections()]
        [(None, 1), ('Dark', 1)]
        """
        members: dict[GroupPath, list[Entry]] = {group.path: [] for group in self.groups}
        first: dict[GroupPath, int] = {}
        runs: list[tuple[int, list[Entry]]] = []
        for index, entry in enumerate(self.entries):
            if entry.group:
                members[entry.group].append(entry)
                for depth in range(1, len(entry.group) + 1):
                    first.setdefault(entry.group[:depth], index)
            elif index and not self.entries[index - 1].group:
                runs[-1][1].append(entry)
            else:
                runs.append((index, [entry]))
        within: dict[GroupPath, list[Group]] = {}
        for group in self.groups:
            within.setdefault(group.path[:-1], []).append(group)
        found: list[tuple[Group | None, list[Entry]]] = []

        def placed(around: GroupPath) -> list[tuple[int, Group]]:
            items, place = [], -1
            for group in within.get(around, ()):
                place = first.get(group.path, place)
                items.append((place, group))
            return sorted(items, key=lambda item: item[0])

        def append_items(group: Group) -> None:
            found.append((group, members[group.path]))
            for _, inner in placed(group.path):
                append_items(inner)

        outermost: list[tuple[int, Group | list[Entry]]] = [*runs, *placed(())]
        for _, item in sorted(outermost, key=lambda pair: pair[0]):
            if isinstance(item, Group):
                append_items(item)
            elif found and found[-1][0] is None:
                found[-1][1].extend(item)
            else:
                found.append((None, item))
        return [(group, tuple(entries)) for group, entries in found]


def new_id() -> str:
    """Return an id that no other entry has, in whatever palette."""
    return secrets.token_hex(8)


def check_path(value: object, place: str) -> GroupPath:
    """Return the path of a group, checked."""
    names = check_items(value, place, str, DEEPEST_GROUP)
    for index, name in enumerate(names):
        check_text(name, f"{place}[{index}]", longest=_LONGEST_NAME, lines=False, empty=True)
    return names


def _set(value: object, name: str, item: object) -> None:
    object.__setattr__(value, name, item)  # frozen values are changed only while they are made


def _with_ids(entries: tuple[Entry, ...]) -> tuple[Entry, ...]:
    """Return the entries, each with an id; those without get their number, or the next free one."""
    taken = {entry.id for entry in entries}
    if len(taken) == len(entries) and "" not in taken:
        return entries
    seen: set[str] = set()
    filled = []
    for index, entry in enumerate(entries):
        if entry.id in seen:
            raise ValueRangeError(f"entries[{index}].id", f"the id {entry.id!r} is there twice")
        if not entry.id:
            number = index + 1
            while str(number) in taken:
                number += len(entries)
            taken.add(str(number))
            entry = replace(entry, id=str(number))
        seen.add(entry.id)
        filled.append(entry)
    return tuple(filled)


def _all_groups(groups: tuple[Group, ...], entries: tuple[Entry, ...]) -> tuple[Group, ...]:
    declared: dict[GroupPath, Group] = {}
    for index, group in enumerate(groups):
        if group.path in declared:
            raise ValueRangeError(
                f"groups[{index}].path", f"the group {'/'.join(group.path)!r} is there twice"
            )
        declared[group.path] = group
    found: dict[GroupPath, Group] = {}
    for path in (*declared, *dict.fromkeys(entry.group for entry in entries)):
        for depth in range(1, len(path) + 1):
            around = path[:depth]
            if around not in found:
                found[around] = declared.get(around) or Group(around)
    if len(found) > MOST_GROUPS:
        raise ValueRangeError("groups", f"{len(found)} are more than the {MOST_GROUPS} allowed")
    # Unchanged groups stay the same object, so that a comparison of palettes is quick.
    return groups if list(found.values()) == list(groups) else tuple(found.values())


def _checked_foreign(value: object) -> Foreign:
    pairs = check_items(value, "foreign", (tuple, list), 64)
    found = []
    for index, pair in enumerate(pairs):
        if len(pair) != 2:
            raise ValueRangeError(f"foreign[{index}]", "expected a name and a text")
        check_text(pair[0], f"foreign[{index}][0]", longest=200, lines=False, empty=False)
        check_text(pair[1], f"foreign[{index}][1]", longest=1_000_000, lines=True, empty=True)
        found.append((pair[0], pair[1]))
    return tuple(found)


def _check_colour(value: object) -> None:
    if value != "" and (not isinstance(value, str) or not _COLOUR.fullmatch(value)):
        raise ValueRangeError("colour", f"expected #rrggbb in lower case, not {describe(value)}")


def _check_date(value: object) -> None:
    if isinstance(value, str) and _DATE.fullmatch(value):
        try:
            datetime.fromisoformat(value)
        except ValueError:
            pass
        else:
            return
    raise ValueRangeError("date", f"expected a date as in 2024-05-31, not {describe(value)}")
