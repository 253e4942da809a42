"""Edits of palettes as pure functions; unchanged entries keep their identity.

An id or a group that is not there raises :class:`ValueRangeError`, so that a stale selection is reported and not
guessed.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace

from brdf_suite.documents.palette import Entry, Group, GroupPath, Palette, check_path, new_id
from brdf_suite.errors import ValueRangeError


def add_entries(
    palette: Palette, entries: Iterable[Entry], group: GroupPath | None = None, before: str | None = None
) -> Palette:
    """Return the palette with further entries, before the entry of id ``before`` or at the end.

    ``group`` puts them all in one group; None leaves each in its own. An id that is taken, or empty, becomes a new
    one: an entry that is copied is another entry.
    """
    taken = set(palette.by_id)
    fresh = []
    for entry in entries:
        id_ = new_id() if not entry.id or entry.id in taken else entry.id
        taken.add(id_)
        fresh.append(replace(entry, id=id_, group=entry.group if group is None else group))
    place = len(palette) if before is None else _place(palette, before)
    items = palette.entries
    return replace(palette, entries=(*items[:place], *fresh, *items[place:]))


def remove_entries(palette: Palette, ids: Collection[str]) -> Palette:
    """Return the palette without the entries of these ids; their groups stay."""
    gone = _known(palette, ids)
    return replace(palette, entries=tuple(entry for entry in palette.entries if entry.id not in gone))


def move_entries(
    palette: Palette, ids: Collection[str], group: GroupPath | None = None, before: str | None = None
) -> Palette:
    """Return the palette with entries moved before the entry of id ``before``, or to the end, in their order.

    ``group`` puts them in a group, ``()`` in none; None leaves each in its own.
    """
    wanted = _known(palette, ids)
    if before is not None and before in wanted:
        # Dropped on one of themselves: they come together there.
        later = palette.entries[_place(palette, before) :]
        before = next((entry.id for entry in later if entry.id not in wanted), None)
    chosen = [
        entry if group is None or entry.group == group else replace(entry, group=group)
        for entry in palette.entries
        if entry.id in wanted
    ]
    rest = [entry for entry in palette.entries if entry.id not in wanted]
    place = len(rest) if before is None else [entry.id for entry in rest].index(_checked(palette, before))
    return replace(palette, entries=(*rest[:place], *chosen, *rest[place:]))


def change_entries(palette: Palette, ids: Collection[str], change: Callable[[Entry], Entry]) -> Palette:
    """Return the palette with ``change`` made to the entries of these ids; their ids stay."""
    places = sorted(_place(palette, id_) for id_ in _known(palette, ids))
    entries = palette.entries
    return palette.with_entries(
        {place: replace(change(entries[place]), id=entries[place].id) for place in places}
    )


def rename_entry(palette: Palette, id_: str, name: str) -> Palette:
    """Return the palette with an entry, paint or colour, under another name."""
    return change_entries(
        palette, (id_,), lambda entry: replace(entry, content=replace(entry.content, name=name))
    )


def tag_entries(
    palette: Palette, ids: Collection[str], add: Sequence[str] = (), drop: Collection[str] = ()
) -> Palette:
    """Return the palette with tags given to entries, and others taken from them."""

    def change(entry: Entry) -> Entry:
        kept = [tag for tag in entry.tags if tag not in drop]
        return replace(entry, tags=tuple(dict.fromkeys((*kept, *add))))

    return change_entries(palette, ids, change)


def reorder_entries(palette: Palette, ids: Sequence[str]) -> Palette:
    """Return the palette with these entries in this order, in the places that they have among all others."""
    places = sorted(_place(palette, id_) for id_ in ids)
    if len(set(places)) != len(places):
        raise ValueRangeError("ids", "an entry is named twice")
    items = list(palette.entries)
    for place, id_ in zip(places, ids, strict=True):
        items[place] = palette.entry(id_)
    return replace(palette, entries=tuple(items))


def with_group(palette: Palette, group: Group, before: GroupPath | None = None) -> Palette:
    """Return the palette with a further group, empty, before another or at the end."""
    if any(known.path == group.path for known in palette.groups):
        raise ValueRangeError("path", f"the group {'/'.join(group.path)!r} is there already")
    place = len(palette.groups) if before is None else _group_place(palette, before)
    return replace(palette, groups=(*palette.groups[:place], group, *palette.groups[place:]))


def change_group(palette: Palette, path: GroupPath, change: Callable[[Group], Group]) -> Palette:
    """Return the palette with notes, colour or whatever else of a group changed; its path stays."""
    place = _group_place(palette, path)
    group = replace(change(palette.groups[place]), path=path)
    return replace(palette, groups=(*palette.groups[:place], group, *palette.groups[place + 1 :]))


def remove_group(palette: Palette, path: GroupPath, *, keep_entries: bool = False) -> Palette:
    """Return the palette without a group and those in it; its entries go with it, or move to the group around it."""
    _group_place(palette, path)
    groups = tuple(group for group in palette.groups if not _inside(group.path, path))
    if keep_entries:
        entries = tuple(
            replace(entry, group=path[:-1]) if _inside(entry.group, path) else entry
            for entry in palette.entries
        )
    else:
        entries = tuple(entry for entry in palette.entries if not _inside(entry.group, path))
    return replace(palette, groups=groups, entries=entries)


def rename_group(palette: Palette, path: GroupPath, name: str) -> Palette:
    """Return the palette with a group under another name, all that is in it with it."""
    return move_group(palette, path, (*path[:-1], name))


def move_group(palette: Palette, path: GroupPath, to: GroupPath, before: GroupPath | None = None) -> Palette:
    """Return the palette with a group, all that is in it with it, at another path and before another group.

    Where there is a group at ``to`` already the two become one, and its notes and colour stay.
    """
    to = check_path(to, "to")
    place = _group_place(palette, path)
    if not to or (_inside(to, path) and to != path):
        raise ValueRangeError("to", "a group cannot go into itself")
    there = {group.path for group in palette.groups if not _inside(group.path, path)}

    def new_path(old: GroupPath) -> GroupPath:
        return (*to, *old[len(path) :]) if _inside(old, path) else old

    travelling = [
        replace(group, path=new_path(group.path)) for group in palette.groups if _inside(group.path, path)
    ]
    travelling = [group for group in travelling if group.path not in there]
    rest = [group for group in palette.groups if not _inside(group.path, path)]
    if before is not None:
        place = next((i for i, group in enumerate(rest) if group.path == before), len(rest))
    else:
        place = sum(not _inside(group.path, path) for group in palette.groups[:place])
    entries = tuple(
        replace(entry, group=new_path(entry.group)) if _inside(entry.group, path) else entry
        for entry in palette.entries
    )
    return replace(palette, groups=(*rest[:place], *travelling, *rest[place:]), entries=entries)


def _inside(path: GroupPath, around: GroupPath) -> bool:
    return path[: len(around)] == around


def _known(palette: Palette, ids: Collection[str]) -> set[str]:
    for id_ in ids:
        _checked(palette, id_)
    return set(ids)


def _checked(palette: Palette, id_: str) -> str:
    if id_ not in palette.by_id:
        raise ValueRangeError("id", f"no entry has the id {id_!r}")
    return id_


def _place(palette: Palette, id_: str) -> int:
    return palette.by_id[_checked(palette, id_)]


def _group_place(palette: Palette, path: GroupPath) -> int:
    for place, group in enumerate(palette.groups):
        if group.path == path:
            return place
    raise ValueRangeError("path", f"there is no group {'/'.join(path)!r}")
