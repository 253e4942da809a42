"""A palette that two have changed since they had it in common: both changes together, and where they collide.

Three values are compared: what both started from (``base``), what this program has (``ours``), and what the file holds
now (``theirs``). What only one side has changed is taken from it, field by field: a new name from the one and a tag
from the other are both kept. Where both changed the same field to different values ours stays, and the conflict is
reported in words. What one side removed and the other changed is kept and reported. So:

    merge(base, ours, base) = ours,  merge(base, base, theirs) = theirs,  merge(base, x, x) = x.

The order follows the side that moved something; where both did, ours holds and their new entries stand behind the
one that they follow in their own order.
"""

from __future__ import annotations

import contextlib
from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, TypeVar

from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.errors import ValueRangeError

_Item = TypeVar("_Item", Entry, Group)
_WORDS = {
    "content": "the colour",
    "name": "the name",
    "group": "the group",
    "code": "the code",
    "notes": "the notes",
    "colour": "the mark",
    "usage": "the usage",
    "date": "the date",
    "columns": "the number of columns",
    "foreign": "what another program keeps in it",
    "path": "the place",
}


@dataclass(frozen=True)
class Merge:
    """Both changes together. ``conflicts`` and ``taken`` (what came from theirs) are sentences for the user."""

    palette: Palette
    conflicts: tuple[str, ...]
    taken: tuple[str, ...]


def merge(base: Palette, ours: Palette, theirs: Palette) -> Merge:
    """Return the palette with the changes of both sides since ``base``; entries are known by their ids."""
    if theirs == base or ours == theirs:
        return Merge(ours, (), ())
    merger = _Merger()
    if ours == base:
        merger.note_changes(base.entries, theirs.entries)
        merger.note_changes(base.groups, theirs.groups)
        return Merge(theirs, (), tuple(merger.taken))
    own: dict[str, Any] = {
        "entries": tuple(merger.items(base.entries, ours.entries, _apart(base, ours, theirs))),
        "groups": tuple(merger.items(base.groups, ours.groups, theirs.groups)),
    }
    for name in (field.name for field in fields(Palette) if field.name not in own):
        old, mine, other = (getattr(side, name) for side in (base, ours, theirs))
        own[name] = merger.field(name, old, mine, other, f"the palette {ours.name}")
    return Merge(Palette(**own), tuple(merger.conflicts), tuple(merger.taken))


def _free(name: str, used: set[str]) -> str:
    """A name that is not used: this one, or it with a number behind."""
    number, free = 1, name
    while free in used:
        number += 1
        free = f"{name[:50]}-{number}"
    return free


def _apart(base: Palette, ours: Palette, theirs: Palette) -> tuple[Entry, ...]:
    """Their entries; what both sides added under one id but is not the same gets another id there."""
    used = {*base.by_id, *ours.by_id, *theirs.by_id}
    found = []
    for entry in theirs.entries:
        place = ours.by_id.get(entry.id)
        if place is not None and entry.id not in base.by_id and ours.entries[place] != entry:
            free = _free(entry.id, used)
            used.add(free)
            entry = replace(entry, id=free)
        found.append(entry)
    return tuple(found)


def _by_key(items: Sequence[_Item]) -> dict[Hashable, _Item]:
    return {item.id if isinstance(item, Entry) else item.path: item for item in items}


def _words(item: Entry | Group) -> str:
    if isinstance(item, Group):
        return f"the group {' / '.join(item.path)}"
    return f"the entry {item.name or item.code or item.id}"


class _Merger:
    """Puts the changes of both sides together, and gathers the sentences about them."""

    def __init__(self) -> None:
        self.conflicts: list[str] = []
        self.taken: list[str] = []

    def note_changes(self, before: Sequence[_Item], after: Sequence[_Item]) -> None:
        """Note what has changed from one state to the other."""
        old, new = _by_key(before), _by_key(after)
        self._take("new", (item for name, item in new.items() if name not in old))
        self._take("removed", (item for name, item in old.items() if name not in new))
        self._take("changed", (item for name, item in new.items() if name in old and old[name] != item))

    def items(self, base: Sequence[_Item], ours: Sequence[_Item], theirs: Sequence[_Item]) -> list[_Item]:
        """Return what becomes of the entries or groups of all sides, in order."""
        old: dict[Hashable, _Item] = _by_key(base)
        own: dict[Hashable, _Item] = _by_key(ours)
        other: dict[Hashable, _Item] = _by_key(theirs)
        kept: dict[Hashable, _Item] = {}
        for name in dict.fromkeys((*own, *other)):
            found = self._one(old.get(name), own.get(name), other.get(name))
            if found is not None:
                kept[name] = found
        gone = (item for name, item in old.items() if own.get(name) == item and name not in other)
        self._take("removed", gone)
        return [kept[name] for name in _order(list(old), list(own), list(other), kept)]

    def _take(self, what: str, items: Iterable[Entry | Group]) -> None:
        self.taken += [_sentence(f"{_words(item)} is {what}") for item in items]

    def _one(self, base: _Item | None, ours: _Item | None, theirs: _Item | None) -> _Item | None:
        """What becomes of one entry or group; None: it is gone."""
        if ours is not None and theirs is not None:
            if ours == theirs or theirs == base:
                return ours
            if ours == base:
                self._take("changed", [theirs])
                return theirs
            return self._both(base, ours, theirs)
        there = ours if ours is not None else theirs
        if there is None or there == base:
            return None
        if base is None:
            self._take("new", [there] if there is theirs else [])
            return there
        where = "here and was changed in the file" if there is theirs else "in the file and was changed here"
        self.conflicts.append(_sentence(f"{_words(there)} was removed {where}; it is kept as it was changed"))
        return there

    def _both(self, base: _Item | None, ours: _Item, theirs: _Item) -> _Item:
        """Both sides have changed it, or both have added it: field by field."""
        values: dict[str, Any] = {}
        for name in (field.name for field in fields(ours)):
            old = None if base is None else getattr(base, name)
            mine: Any = getattr(ours, name)
            other: Any = getattr(theirs, name)
            if name == "tags":
                # Those that either added, without those that either removed, in our order.
                gone = set(old or ()) - (set(mine) & set(other))
                values[name] = tuple(tag for tag in dict.fromkeys((*mine, *other)) if tag not in gone)
            else:
                combine = self._content if name == "content" else self.field
                values[name] = combine(name, old, mine, other, _words(ours))
        merged = type(ours)(**values)
        if merged != ours:
            self._take("changed", [ours])
        return merged

    def _content(self, name: str, base: Any, ours: Any, theirs: Any, subject: str) -> Any:
        """The paint or colour; of two of one kind a new name and new readings go together."""
        if ours != theirs and base not in (ours, theirs) and type(base) is type(ours) is type(theirs):
            if "name" in ours.__dataclass_fields__ and theirs == replace(ours, name=theirs.name):
                # The names alone have met: the colour is the same.
                self.conflicts.append(
                    _sentence(
                        f"the name of {subject} was changed here and in the file: here {ours.name}, "
                        f"in the file {theirs.name}; it stays as it is here"
                    )
                )
                return ours
            changed: dict[str, object] = {}
            for part in ours.__dataclass_fields__:
                old, mine, other = (getattr(side, part) for side in (base, ours, theirs))
                if mine == old and other != old:
                    changed[part] = other
                elif mine not in (old, other) and other != old:
                    break
            else:
                # The two halves may make no paint: then they collide as any others.
                with contextlib.suppress(ValueRangeError):
                    return replace(ours, **changed)
        return self.field(name, base, ours, theirs, subject)

    def field(self, name: str, base: object, ours: object, theirs: object, subject: str) -> Any:
        """Return the value of the side that changed a field; where both did, ours, and note the conflict."""
        if ours == theirs or theirs == base:
            return ours
        if ours == base:
            return theirs
        what = f"{_WORDS.get(name, name)} of {subject} was changed here and in the file"
        self.conflicts.append(_sentence(f"{what}; it stays as it is here"))
        return ours


def _order(
    base: list[Hashable], ours: list[Hashable], theirs: list[Hashable], kept: Mapping[Hashable, object]
) -> list[Hashable]:
    """The order of all that is kept."""
    common = set(base) & set(ours) & set(theirs)
    lines = [[name for name in side if name in common] for side in (base, ours, theirs)]
    # Theirs leads where they alone have moved something.
    lead, rest = (theirs, ours) if lines[1] == lines[0] and lines[2] != lines[0] else (ours, theirs)
    found = [name for name in lead if name in kept]
    there = set(found)
    before: Hashable | None = None
    after: dict[Hashable | None, list[Hashable]] = {}
    for name in rest:
        if name not in kept:
            continue
        if name not in there:
            after.setdefault(before, []).append(name)
        else:
            before = name
    result = list(after.get(None, ()))
    for name in found:
        result.append(name)
        result += after.get(name, ())
    return result


def _sentence(text: str) -> str:
    return f"{text[0].upper()}{text[1:]}."
