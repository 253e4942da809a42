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
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, TypeVar

from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.errors import ValueRangeError

_Item = TypeVar("_Item", Entry, Group)
_Value = TypeVar("_Value", Entry, Group, Palette)
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
    """Return the palette with the changes of both sides since ``base``; entries are known by their ids.

    A file that holds no ids is given those of ``base`` first (:func:`with_ids_of`).
    """
    if theirs == base or ours == theirs:
        return Merge(ours, (), ())
    conflicts: list[str] = []
    taken: list[str] = []
    if ours == base:
        merged = theirs
        _append_changes(base.entries, theirs.entries, _entry_key, _entry_words, taken)
        _append_changes(base.groups, theirs.groups, _group_key, _group_words, taken)
        return Merge(merged, (), tuple(taken))
    others = _apart(base, ours, theirs)
    entries = _items(base.entries, ours.entries, others, _entry_key, _entry_words, conflicts, taken)
    groups = _items(base.groups, ours.groups, theirs.groups, _group_key, _group_words, conflicts, taken)
    own: dict[str, Any] = {}
    for name in (field.name for field in fields(Palette)):
        if name not in ("entries", "groups"):
            old, mine, other = (getattr(side, name) for side in (base, ours, theirs))
            own[name] = _field(name, old, mine, other, f"the palette {ours.name}", conflicts)
    return Merge(Palette(entries=tuple(entries), groups=tuple(groups), **own), tuple(conflicts), tuple(taken))


def with_ids_of(base: Palette, theirs: Palette) -> Palette:
    """Return ``theirs``, read from a file without ids, with the ids of the entries of ``base`` that it has still.

    The same colour in the same group first, then the same colour, then the same name, code and group; each in order.
    """
    rules: tuple[Callable[[Entry], Hashable], ...] = (
        lambda entry: (entry.content, entry.group, entry.code),
        lambda entry: entry.content,
        lambda entry: (entry.name, entry.code, entry.group) if entry.name or entry.code else entry,
    )
    found: dict[int, str] = {}
    left = list(base.entries)
    for rule in rules:
        waiting: dict[Hashable, list[Entry]] = {}
        for entry in reversed(left):
            waiting.setdefault(rule(entry), []).append(entry)
        for place, entry in enumerate(theirs.entries):
            if place not in found and waiting.get(rule(entry)):
                found[place] = waiting[rule(entry)].pop().id
        left = [entry for rest in waiting.values() for entry in rest]
        left.sort(key=lambda entry: base.by_id[entry.id])
    used = {entry.id for entry in base.entries}
    entries = []
    for place, entry in enumerate(theirs.entries):
        name = found.get(place) or _free(entry.id, used)
        used.add(name)
        entries.append(entry if entry.id == name else replace(entry, id=name))
    return replace(theirs, entries=tuple(entries))


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


def _entry_key(entry: Entry) -> Hashable:
    return entry.id


def _group_key(group: Group) -> Hashable:
    return group.path


def _entry_words(entry: Entry) -> str:
    return f"the entry {entry.name or entry.code or entry.id}"


def _group_words(group: Group) -> str:
    return f"the group {' / '.join(group.path)}"


def _append_changes(
    before: Sequence[_Item],
    after: Sequence[_Item],
    key: Callable[[_Item], Hashable],
    words: Callable[[_Item], str],
    taken: list[str],
) -> None:
    """Append to ``taken`` what has changed from one state to the other."""
    old, new = {key(item): item for item in before}, {key(item): item for item in after}
    taken += [_sentence(f"{words(item)} is new") for name, item in new.items() if name not in old]
    taken += [_sentence(f"{words(item)} is removed") for name, item in old.items() if name not in new]
    taken += [
        _sentence(f"{words(item)} is changed")
        for name, item in new.items()
        if name in old and old[name] != item
    ]


def _items(
    base: Sequence[_Item],
    ours: Sequence[_Item],
    theirs: Sequence[_Item],
    key: Callable[[_Item], Hashable],
    words: Callable[[_Item], str],
    conflicts: list[str],
    taken: list[str],
) -> list[_Item]:
    old: dict[Hashable, _Item]
    own: dict[Hashable, _Item]
    other: dict[Hashable, _Item]
    old, own, other = ({key(item): item for item in side} for side in (base, ours, theirs))
    kept: dict[Hashable, _Item] = {}
    for name in dict.fromkeys((*own, *other)):
        found = _one(old.get(name), own.get(name), other.get(name), words, conflicts, taken)
        if found is not None:
            kept[name] = found
    taken += [
        _sentence(f"{words(item)} is removed")
        for name, item in old.items()
        if name in own and own[name] == item and name not in other
    ]
    return [kept[name] for name in _order(list(old), list(own), list(other), kept)]


def _one(
    base: _Item | None,
    ours: _Item | None,
    theirs: _Item | None,
    words: Callable[[_Item], str],
    conflicts: list[str],
    taken: list[str],
) -> _Item | None:
    """What becomes of one entry or group; None: it is gone."""
    if ours is not None and theirs is not None:
        if ours == theirs or theirs == base:
            return ours
        if ours == base:
            taken.append(_sentence(f"{words(theirs)} is changed"))
            return theirs
        return _both(base, ours, theirs, words(ours), conflicts, taken)
    there = ours if ours is not None else theirs
    if base is None:
        if there is theirs and there is not None:
            taken.append(_sentence(f"{words(there)} is new"))
        return there
    if there == base or there is None:
        return None
    where = "here and was changed in the file" if there is theirs else "in the file and was changed here"
    conflicts.append(_sentence(f"{words(there)} was removed {where}; it is kept as it was changed"))
    return there


def _both(
    base: _Value | None, ours: _Value, theirs: _Value, subject: str, conflicts: list[str], taken: list[str]
) -> _Value:
    """Both sides have changed it, or both have added it: field by field."""
    values: dict[str, Any] = {}
    for field in fields(ours):
        old = None if base is None else getattr(base, field.name)
        mine, other = getattr(ours, field.name), getattr(theirs, field.name)
        if field.name == "tags":
            values["tags"] = _tags(old or (), mine, other)
        elif field.name == "content":
            values["content"] = _content(old, mine, other, subject, conflicts)
        else:
            values[field.name] = _field(field.name, old, mine, other, subject, conflicts)
    merged = type(ours)(**values)
    if merged != ours:
        taken.append(_sentence(f"{subject} is changed"))
    return merged


def _content(base: Any, ours: Any, theirs: Any, subject: str, conflicts: list[str]) -> Any:
    """The paint or colour; of two of one kind a new name and new readings go together."""
    if ours != theirs and base not in (ours, theirs) and type(base) is type(ours) is type(theirs):
        if "name" in ours.__dataclass_fields__ and theirs == replace(ours, name=theirs.name):
            # The names alone have met: the colour is the same.
            conflicts.append(
                _sentence(
                    f"the name of {subject} was changed here and in the file: here {ours.name}, "
                    f"in the file {theirs.name}; it stays as it is here"
                )
            )
            return ours
        changed: dict[str, object] = {}
        for name in ours.__dataclass_fields__:
            old, mine, other = (getattr(side, name) for side in (base, ours, theirs))
            if mine == old and other != old:
                changed[name] = other
            elif mine not in (old, other) and other != old:
                break
        else:
            # The two halves may make no paint: then they collide as any others.
            with contextlib.suppress(ValueRangeError):
                return replace(ours, **changed)
    return _field("content", base, ours, theirs, subject, conflicts)


def _field(name: str, base: object, ours: object, theirs: object, subject: str, conflicts: list[str]) -> Any:
    if ours == theirs or theirs == base:
        return ours
    if ours == base:
        return theirs
    conflicts.append(
        _sentence(
            f"{_WORDS.get(name, name)} of {subject} was changed here and in the file; it stays as it is here"
        )
    )
    return ours


def _tags(base: tuple[str, ...], ours: tuple[str, ...], theirs: tuple[str, ...]) -> tuple[str, ...]:
    """Tags that either added, without those that either removed, in our order."""
    gone = (set(base) - set(ours)) | (set(base) - set(theirs))
    return tuple(tag for tag in dict.fromkeys((*ours, *theirs)) if tag not in gone)


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
