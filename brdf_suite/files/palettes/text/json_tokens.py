"""JSON palettes: design tokens (Design Tokens Format Module 2025), and common plain colour lists.

Written are tokens: ``{"name": {"$type": "color", "$value": {"colorSpace", "components", "hex"}}}``, groups as objects
within each other. What a token cannot say (the paint itself, code, tags …) stands in its ``$extensions`` under this
program's name, so the file comes back whole; where another program has changed the value since, the value counts.

Read are also objects of names and colours, nested ones as groups, lists of colours, and lists of objects with a name
and a colour.
"""

from __future__ import annotations

import json
import re
from dataclasses import replace
from typing import Any

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, GroupPath, Palette
from brdf_suite.documents.palette_store import entry_from_json, entry_to_json
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_text
from brdf_suite.files.palettes.conversions import convert_to_rgb8
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.text.css import convert_to_css, parse_colour, space_word

_OURS = "brdf-suite"
_MODELS = ("RGB", "HSL", "Lab", "LCh", "XYZ")
_SPACES = {"Lab": "lab", "LCh": "lch", "HSL": "hsl"}
_VALUES = ("$value", "value", "hex", "color", "colour", "rgb")
_DEEPEST = 30
_FORBIDDEN = re.compile(r"[{}.$\x00-\x1f]")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a JSON file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    text = decode_text(content, path, collector)
    try:
        value = json.loads(text)
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise collector.fail(f"is not valid JSON ({error.msg.lower()})", place) from error
    except (RecursionError, ValueError) as error:  # too deep; a number of too many digits
        raise collector.fail(f"is not JSON that can be read ({str(error)[:80]})", "line 1") from error
    reader = _Reader(collector)
    reader.walk(value, (), "$")
    reader.sort()
    about = reader.about
    if not collector.entries and not about:
        raise collector.fail("holds no colour", "the top level")
    return collector.finish(
        _text(about.get("name")),
        notes=collector.lines(_text(about.get("notes"))),
        colour=_text(about.get("colour")),
        columns=about["columns"] if type(about.get("columns")) is int else 0,
        foreign=reader.foreign(),
    )


def _text(value: object) -> str:
    return value if isinstance(value, str) else ""


class _Reader:
    def __init__(self, collector: Collector) -> None:
        self._collector = collector
        self.about: dict[str, Any] = {}
        self._places: list[int] = []

    def sort(self) -> None:
        """Bring the entries into the order that this program said they have, where it said so of all."""
        entries = self._collector.entries
        if self._places and len(self._places) == len(entries):
            pairs = sorted(zip(self._places, range(len(entries)), strict=True))
            entries[:] = [
                replace(entries[index], id=str(number)) for number, (_, index) in enumerate(pairs, 1)
            ]

    def foreign(self) -> tuple[tuple[str, str], ...]:
        value = self.about.get("foreign")
        return tuple(
            (pair[0], pair[1])
            for pair in (value if isinstance(value, list) else [])
            if isinstance(pair, list) and len(pair) == 2 and all(isinstance(word, str) for word in pair)
        )

    def walk(self, value: object, group: GroupPath, place: str) -> None:
        """Read what is below a place of the file: a group."""
        collector = self._collector
        if len(group) > _DEEPEST:
            raise collector.fail(f"is nested deeper than {_DEEPEST} groups", place[:200])
        if isinstance(value, dict):
            if not group:
                self.about = _ours(value)
            for key, item in value.items():
                self._item(key, item, group, f"{place}.{key[:60]}")
        elif isinstance(value, list):
            for index, item in enumerate(value):
                self._item("", item, group, f"{place}[{index}]")
        else:
            raise collector.fail("expected an object or a list", place)

    def _item(self, key: str, item: object, group: GroupPath, place: str) -> None:
        collector = self._collector
        if key.startswith("$"):
            return
        if isinstance(item, dict):
            if any(name in item and _colour(item[name]) for name in _VALUES):
                self._token(key, item, group, place)
                return
            if any(name in item for name in _VALUES) and "$value" in item:
                collector.note("{n} token[ that is no colour|s that are no colours] known here skipped.")
                return
            self.walk(item, self._group(key, item, group, place) if key else group, place)
        elif isinstance(item, str) and (found := _colour(item)):
            self._add(found[0], found[1], collector.name(key), group, place)
        elif isinstance(item, list):
            if any(isinstance(inner, (dict, list)) for inner in item):
                self.walk(item, self._group(key, {}, group, place) if key else group, place)
            else:
                self._row(key, item, group, place)
        else:
            collector.note("{n} value[ that is no colour|s that are no colours] skipped.")

    def _row(self, key: str, items: list[object], group: GroupPath, place: str) -> None:
        """A list of colours under one name, as in ``"grey": ["#f8f9fa", "#f1f3f5"]``."""
        for index, item in enumerate(items):
            found = _colour(item) if isinstance(item, str) else None
            if found is None:
                self._collector.note("{n} value[ that is no colour|s that are no colours] skipped.")
            else:
                name = self._collector.name(f"{key} {index}" if key else "")
                self._add(found[0], found[1], name, group, f"{place}[{index}]")

    def _group(self, key: str, item: dict[str, Any], group: GroupPath, place: str) -> GroupPath:
        ours = _ours(item)
        name = ours["name"] if isinstance(ours.get("name"), str) else key
        notes = self._collector.lines(_text(item.get("$description")))
        return self._collector.group(place, group, name, notes, _text(ours.get("colour")))

    def _token(self, key: str, item: dict[str, Any], group: GroupPath, place: str) -> None:
        collector = self._collector
        value = next(item[name] for name in _VALUES if name in item and _colour(item[name]))
        found = _colour(value)
        assert found is not None  # it was found a line above
        ours = _ours(item)
        if "entry" in ours:
            try:
                where = f"{place[:200]}.$extensions.{_OURS}.entry"
                entry = entry_from_json(ours["entry"], collector.path, where)
            except FileError as error:
                raise collector.fail(error.reason, error.place or place) from error
            if json.loads(json.dumps(_value(entry))) == value:
                collector.check_count(len(collector.entries) + 1, place)
                collector.entries.append(replace(entry, id=str(len(collector.entries) + 1), group=group))
                if type(ours.get("place")) is int:
                    self._places.append(ours["place"])
                return
            collector.note("{n} colour[ was|s were] changed by another program, and [is|are] flat now.")
        label = _text(item.get("name")) or key
        notes = collector.lines(_text(item.get("$description")))
        self._add(found[0], found[1], collector.name(label), group, place, notes)

    def _add(
        self, colour: FlatColour, opacity: float, name: str, group: GroupPath, place: str, notes: str = ""
    ) -> None:
        if opacity != 1.0:
            self._collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
        self._collector.add(place[:200], replace(colour, name=name), group=group, notes=notes)


def _ours(item: dict[str, Any]) -> dict[str, Any]:
    extensions = item.get("$extensions")
    ours = extensions.get(_OURS) if isinstance(extensions, dict) else None
    return ours if isinstance(ours, dict) else {}


def _colour(value: object) -> tuple[FlatColour, float] | None:
    """The colour in a text of CSS, in three numbers from 0 to 255, or in a token's value."""
    if isinstance(value, str):
        return parse_colour(value)
    if isinstance(value, dict) and isinstance(value.get("components"), list):
        space, items, alpha = value.get("colorSpace"), value["components"], value.get("alpha", 1)
        if not isinstance(space, str) or len(items) != 3 or not all(map(_is_number, (*items, alpha))):
            return None
        words = " ".join("none" if item == "none" else repr(float(item)) for item in items)
        if space in ("hsl", "hwb"):
            hue, *shares = words.split()
            found = parse_colour(f"{space}({hue} {' '.join(f'{share}%' for share in shares)})")
        elif space in ("lab", "lch", "oklab", "oklch"):
            found = parse_colour(f"{space}({words})")
        else:
            found = parse_colour(f"color({space} {words})")
        return None if found is None else (found[0], float(alpha))
    if (
        isinstance(value, list)
        and len(value) == 3
        and all(type(item) is int and 0 <= item <= 255 for item in value)
    ):
        return parse_colour(f"rgb({value[0]} {value[1]} {value[2]})")
    return None


def _is_number(value: object) -> bool:
    return value == "none" or (
        isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e6
    )


def write(palette: Palette) -> bytes:
    """Return a file of design tokens."""
    about: dict[str, object] = {"name": palette.name}
    about |= {"colour": palette.colour} if palette.colour else {}
    about |= {"columns": palette.columns} if palette.columns else {}
    about |= {"notes": palette.notes} if palette.notes else {}
    about |= {"foreign": [list(pair) for pair in palette.foreign]} if palette.foreign else {}
    top: dict[str, Any] = {"$extensions": {_OURS: about}}
    places: dict[GroupPath, dict[str, Any]] = {(): top}
    sections = palette.sections()
    in_groups = [entry.id for _, section in sections for entry in section]
    # Objects keep groups together; where entries stand otherwise, each says which it is.
    mixed = in_groups != [entry.id for entry in palette]
    for group, entries in sections:
        if group is not None:
            around = places[group.path[:-1]]
            ours = {"name": group.name, **({"colour": group.colour} if group.colour else {})}
            inner: dict[str, Any] = {"$extensions": {_OURS: ours}}
            if group.notes:
                inner["$description"] = group.notes
            around[_key(group.name or "group", around)] = inner
            places[group.path] = inner
        target = places[() if group is None else group.path]
        for entry in entries:
            target[_key(entry.name or "colour", target, entry.id)] = _token(
                entry, palette.by_id[entry.id] if mixed else None
            )
    return (json.dumps(top, ensure_ascii=False, indent=1) + "\n").encode("utf-8", "replace")


def _key(name: str, target: dict[str, Any], id_: str = "") -> str:
    """A name that a token can have and that is free."""
    word = _FORBIDDEN.sub("_", name)
    found = word if word not in target else f"{word} ({id_})"
    number = 1
    while found in target:
        number += 1
        found = f"{word} ({number})"
    return found


def _token(entry: Entry, place: int | None) -> dict[str, Any]:
    own = entry_to_json(replace(entry, group=(), id=""))
    del own["id"]
    ours = {"entry": own} if place is None else {"entry": own, "place": place}
    token = {"$type": "color", "$value": _value(entry), "$extensions": {_OURS: ours}}
    return {**token, "$description": entry.notes} if entry.notes else token


def _value(entry: Entry) -> dict[str, Any]:
    colour = convert_to_css(entry, _MODELS)
    values = list(colour.values)
    if colour.model == "RGB":
        space = space_word(colour)  # of an unknown one the extension knows better
    elif colour.model == "XYZ":
        space = "xyz-d65" if colour.illuminant == "D65" else "xyz-d50"
        values = [value / 100.0 for value in values]
    else:
        space = _SPACES[colour.model]
        if colour.model == "HSL":
            values = [values[0], 100.0 * values[1], 100.0 * values[2]]
    return {"colorSpace": space, "components": values, "hex": f"#{bytes(convert_to_rgb8(entry)).hex()}"}


def _sniff(head: bytes, _size: int) -> bool:
    start = head.removeprefix(b"\xef\xbb\xbf").lstrip()
    # A word behind the bracket is the section of a settings file.
    if not re.match(rb'\{|\[\s*(?:[\[\]{"\d-]|$)', start) or b"\0" in head:
        return False
    # Documents of this program have a format of their own; what is left must speak of a colour somewhere.
    return not re.match(rb'\{\s*"format"\s*:', start)


FORMAT = PaletteFormat(
    name="json",
    title="JSON design tokens",
    endings=(".json", ".tokens"),
    models=("RGB", "HSL", "Lab", "LCh", "XYZ", "CMYK", "CMY", "Gray", "HSB", "spectrum"),
    groups="nested",
    paints=True,
    holds="Everything: for other programs names, groups and one colour, and all else as an extension of this program.",
    sniff=_sniff,
    read=read,
    write=write,
)
