"""KPL (Krita palette): a zip of ``colorset.xml`` with colours, groups and places, ``profiles.xml`` and profiles.

A colour is ``ColorSetEntry`` with one element for its model (numbers from 0 to 1) and a ``Position`` in its group's
grid. In version 1.0 Lab is scaled to 0…1 (L* by 100, a* and b* by 255 around 128/255); in 2.0 it is not. Lab is that of
colour profiles: D50, 2°. The profiles of a file are kept as they are and go back into it.
"""

from __future__ import annotations

import base64
import contextlib
import re

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Foreign, GroupPath, Palette
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.cxf_specification import number
from brdf_suite.files.hardened_xml import Element, attribute, parse_xml, read_root
from brdf_suite.files.palettes.archive.zipped import in_part, is_zip, pack_zip, unpack
from brdf_suite.files.palettes.cmyk_profile import is_cmyk_profile, profile_note, seen_through
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import convert_to_flat
from brdf_suite.files.palettes.format import PaletteFormat

_MIMETYPES = (b"krita/x-colorset", b"application/x-krita-palette")
_COLOURS, _PROFILES = "colorset.xml", "profiles.xml"
_CHANNELS = {"RGB": "rgb", "sRGB": "rgb", "CMYK": "cmyk", "Lab": "Lab", "Gray": "g", "XYZ": "xyz"}
_DEPTH, _PLACE, _ROWS, _KEPT, _LIST, _READONLY = (
    "kpl.bitdepth", "kpl.position", "kpl.rows", "kpl.profile:", "kpl.profiles", "kpl.readonly",
)  # fmt: skip
_SPACES = {"RGB": "sRGB-elle-V2-srgbtrc.icc", "Lab": "Lab identity built-in"}
"""The profiles that Krita takes for colours of no other, and has with it; Lab without one it leaves out."""
_MOST_KEPT, _LARGEST_KEPT = 16, 700_000
_FILE = re.compile(r"[^/\\:\x00-\x1f]{1,150}\.ic[cm]", re.IGNORECASE)


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a KPL file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    parts = unpack(content, path)
    if _COLOURS not in parts:
        raise FileError(path, f"has no part {_COLOURS!r}", "byte 0")
    try:
        collector = Collector(path)
        root = read_root(parts[_COLOURS], path, "ColorSet")
        palette, notes = _Reader(root, collector).palette(_kept_profiles(parts, collector))
        return _seen_through_own(palette, notes, parts, path)
    except FileError as error:
        raise in_part(error, _COLOURS) from error


def _seen_through_own(
    palette: Palette, notes: tuple[str, ...], parts: dict[str, bytes], path: PathLike
) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette with its colours in CMYK as the file's own profiles show them."""
    profiles = {name: parts[file] for name, file in _profile_names(parts, path).items() if file in parts}
    profiles = {name: data for name, data in profiles.items() if is_cmyk_profile(data)}
    if not profiles:
        return palette, notes
    try:
        seen, count = seen_through(palette, profiles, path)
    except FileError as error:
        return palette, (*notes, f"A profile in the file {error.reason}.")
    return seen, (*notes, profile_note(count, "in the file")) if count else notes


def _profile_names(parts: dict[str, bytes], path: PathLike) -> dict[str, str]:
    """Return the files of profiles by the names of their colour spaces."""
    names = {name: name for name in parts if _FILE.fullmatch(name)}
    try:
        root = parse_xml(parts.get(_PROFILES, b""), path)
    except FileError:
        return names
    return names | {
        element.attributes.get("name", ""): element.attributes.get("filename", "")
        for element in root.all("Profile")
    }


def _kept_profiles(parts: dict[str, bytes], collector: Collector) -> list[tuple[str, str]]:
    kept = []
    for name, data in parts.items():
        if name in (_COLOURS, "mimetype"):
            continue
        if name == _PROFILES:
            text = data.decode("utf-8", "replace")
            if "<Profile " in text:
                kept.append((_LIST, collector.lines(text)))
        elif _FILE.fullmatch(name) and len(kept) < _MOST_KEPT and len(data) <= _LARGEST_KEPT:
            kept.append((_KEPT + name, base64.b64encode(data).decode("ascii")))
        else:
            collector.note("{n} part[|s] of the file without colours [is|are] left out.")
    return kept


class _Reader:
    def __init__(self, root: Element, collector: Collector) -> None:
        self._root, self._collector = root, collector
        self._scaled = root.attributes.get("version", "1.0").strip() == "1.0"
        self._columns = self._whole(root, "columns", 0)

    def palette(self, kept: list[tuple[str, str]]) -> tuple[Palette, tuple[str, ...]]:
        root, collector = self._root, self._collector
        collector.check_count(
            sum(element.name == "ColorSetEntry" for element in root.walk()), f"line {root.line}"
        )
        self._entries(root, ())
        for element in root.children:
            if element.name == "Group":
                rows = element.attributes.get("rows", "")
                foreign: Foreign = ((_ROWS, rows[:20]),) if rows.isdecimal() else ()
                group = collector.group(
                    f"line {element.line}", (), element.attributes.get("name", ""), foreign=foreign
                )
                self._entries(element, group)
        has = root.attributes.get
        if has("rows", "").isdecimal():
            kept.append((_ROWS, has("rows", "")[:20]))
        if has("readonly", "false").lower() in ("true", "1"):
            kept.append((_READONLY, "true"))
        return collector.finish(
            has("name", ""),
            notes=collector.lines(has("comment", "")),
            columns=min(self._columns, 10_000),
            foreign=tuple(kept),
        )

    def _whole(self, element: Element, name: str, otherwise: int) -> int:
        text = element.attributes.get(name, "").strip()
        if not text:
            return otherwise
        if not re.fullmatch(r"\d{1,9}", text, re.ASCII):
            raise self._collector.fail(
                f"expected a whole number for {name}, not {text[:40]!r}", f"line {element.line}"
            )
        return int(text)

    def _entries(self, around: Element, group: GroupPath) -> None:
        items = []
        for element in around.all("ColorSetEntry"):
            place = element.first("Position")
            at = (self._whole(place, "row", 0), self._whole(place, "column", 0)) if place else None
            items.append((at, element))
        if all(at is not None for at, _ in items):
            items.sort(key=lambda item: item[0] or (0, 0))
        for index, (at, element) in enumerate(items):
            self._entry(element, group, index, at)

    def _entry(self, element: Element, group: GroupPath, index: int, at: tuple[int, int] | None) -> None:
        collector, place = self._collector, f"line {element.line}"
        has = element.attributes.get
        colour = self._colour(element, collector.name(has("name", "")))
        if colour is None:
            return
        foreign = []
        if has("bitdepth", "U8") != "U8":
            foreign.append((_DEPTH, collector.name(has("bitdepth", ""), 20)))
        if at is not None and (not self._columns or at != divmod(index, self._columns)):
            foreign.append((_PLACE, f"{at[0]} {at[1]}"))
        collector.add(
            place,
            colour,
            group=group,
            code=collector.name(has("id", ""), 200),
            usage="spot" if has("spot", "false").lower() in ("true", "1") else "process",
            foreign=tuple(foreign),
        )

    def _colour(self, entry: Element, name: str) -> FlatColour | None:
        collector = self._collector
        known = [child for child in entry.children if child.name in _CHANNELS]
        if not known:
            collector.note("{n} entr[y|ies] without a colour of a known model [is|are] left out.")
            return None
        element, place = known[0], f"line {known[0].line}"
        given = element.attributes
        values = []
        for channel in _CHANNELS[element.name]:
            if channel not in given:
                raise collector.fail(f"{element.name} has no {channel!r}", place)
            values.append(number(element, given[channel].strip(), collector.path, channel))
        space = collector.name(given.get("space", ""), 200)
        if space == _SPACES.get(element.name):
            space = ""  # what its numbers are where nothing is said
        model = "RGB" if element.name == "sRGB" else element.name
        if model == "Lab" and self._scaled:
            values = [100.0 * values[0], *(255.0 * value - 128.0 for value in values[1:])]
        elif model == "XYZ":
            values = [100.0 * value for value in values]
        white = {"illuminant": "D50", "observer_deg": 2} if model in ("Lab", "XYZ") else {}
        return collector.colour(place, name, model, values, space=space, **white)  # type: ignore[arg-type]  # a model


def write(palette: Palette) -> bytes:
    """Return the content of a KPL file, version 2.0."""
    foreign = dict(palette.foreign)
    columns = palette.columns or 16
    own: list[Entry] = []
    groups = []
    for group, entries in palette.sections():
        if group is None:
            own += entries
            continue
        text, used = _group(entries, columns)
        used = max(used, _rows(dict(group.foreign)))
        name = " / ".join(group.path)
        groups.append(f'  <Group name={attribute(name)} rows="{used}">\n{text}  </Group>\n')
    text, rows = _group(own, columns)
    rows = max(rows, _rows(foreign))
    readonly = "true" if foreign.get(_READONLY) == "true" else "false"
    xml = (
        f'<ColorSet version="2.0" name={attribute(palette.name)} comment={attribute(palette.notes)} '
        f'columns="{columns}" rows="{rows}" readonly="{readonly}">\n{text}{"".join(groups)}</ColorSet>\n'
    )
    parts = {
        "mimetype": _MIMETYPES[0],
        _COLOURS: xml.encode("utf-8"),
        _PROFILES: foreign.get(_LIST, "<Profiles/>\n").encode("utf-8"),
    }
    for key, value in palette.foreign:
        name = key.removeprefix(_KEPT)
        if key.startswith(_KEPT) and _FILE.fullmatch(name):
            with contextlib.suppress(ValueError):  # where a palette says something else there, it is left out
                parts[name] = base64.b64decode(value, validate=True)
    return pack_zip(parts, stored="mimetype")


def _rows(foreign: dict[str, str]) -> int:
    text = foreign.get(_ROWS, "")
    return int(text) if re.fullmatch(r"\d{1,5}", text, re.ASCII) else 0


def _group(entries: list[Entry] | tuple[Entry, ...], columns: int) -> tuple[str, int]:
    """The entries of one grid and how many rows it needs; the places of the file where none is there twice."""
    places = [divmod(index, columns) for index in range(len(entries))]
    kept = [_place(entry) or place for entry, place in zip(entries, places, strict=True)]
    in_order = sorted(kept) == kept and len(set(kept)) == len(kept)
    if in_order and all(column < columns for _, column in kept):
        places = kept
    text = "".join(_entry(entry, place) for entry, place in zip(entries, places, strict=True))
    return text, max((row + 1 for row, _ in places), default=0)


def _place(entry: Entry) -> tuple[int, int] | None:
    words = dict(entry.foreign).get(_PLACE, "").split()
    if len(words) == 2 and all(re.fullmatch(r"\d{1,9}", word, re.ASCII) for word in words):
        return int(words[0]), int(words[1])
    return None


def _entry(entry: Entry, place: tuple[int, int]) -> str:
    colour = convert_to_flat(entry, ("RGB", "CMYK", "Lab", "Gray"))
    space = colour.space or _SPACES.get(colour.model, "")
    values = zip(_CHANNELS[colour.model], colour.values, strict=True)
    numbers = " ".join(f'{channel}="{value!r}"' for channel, value in values)
    depth = dict(entry.foreign).get(_DEPTH, "U8")
    return (
        f"  <ColorSetEntry name={attribute(entry.name)} id={attribute(entry.code)} "
        f'spot="{"true" if entry.usage == "spot" else "false"}" bitdepth={attribute(depth)}>\n'
        f"    <{colour.model} {numbers} space={attribute(space)}/>\n"
        f'    <Position row="{place[0]}" column="{place[1]}"/>\n'
        "  </ColorSetEntry>\n"
    )


FORMAT = PaletteFormat(
    name="kpl",
    title="Krita palette",
    endings=(".kpl",),
    models=("RGB", "CMYK", "Lab", "Gray"),
    groups="flat",
    holds="Names in any script, codes, groups, columns, RGB, CMYK, Lab and Gray with every digit, their profiles, "
    "inks of their own, comments.",
    sniff=lambda head, _size: (
        is_zip(head) and (any(mime in head[:200] for mime in _MIMETYPES) or _COLOURS.encode("ascii") in head)
    ),
    read=read,
    write=write,
    order="none first",
)
