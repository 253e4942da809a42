"""SBZ (SwatchBooker): a zip of ``swatchbook.xml``, materials and the book that arranges them, and of profiles.

A material is a colour with several ``values``, each of a model and a colour space; the book holds swatches, which name
a material, spacers, breaks, and groups of these within each other. The format once allowed expressions in place of
numbers: here only numbers are read.
"""

from __future__ import annotations

import json
from dataclasses import replace

from brdf_suite.documents.flat_colour import FlatColour, Model
from brdf_suite.documents.palette import Entry, Group, GroupPath, Palette
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.cxf_specification import number
from brdf_suite.files.hardened_xml import Element, attribute, read_root, text_content
from brdf_suite.files.palettes.archive.zipped import in_part, is_zip, pack_zip, unpack
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import (
    convert_to_flat,
    in_srgb,
    nested_sections,
    scale_text,
    unscale_text,
)
from brdf_suite.files.palettes.format import PaletteFormat

_BOOK = "swatchbook.xml"
_DC = "http://purl.org/dc/elements/1.1/"
_META, _AFTER = "sbz.metadata", "sbz.after"
_OWN_ID = "brdf-suite:"
"""Begins the identifiers that this program makes up where a palette has none."""
_MODELS: dict[str, Model] = {
    "RGB": "RGB",
    "sRGB": "RGB",
    "CMYK": "CMYK",
    "CMY": "CMY",
    "GRAY": "Gray",
    "Lab": "Lab",
    "LCH": "LCh",
    "XYZ": "XYZ",
    "HSV": "HSB",
    "HSL": "HSL",
}
"""Hue is stored as a fraction of the circle there, and the white's Y is 1."""
_NAMES = {model: word for word, model in _MODELS.items() if word != "sRGB"}
_USAGES = ("spot", "global")
_SELDOM_READ, _SHOWN = ("HSB", "HSL", "CMY", "LCh"), "brdf-suite:shown"
_TITLES = ("title", "identifier", "description", "format", "type")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of an SBZ file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    parts = unpack(content, path)
    if _BOOK not in parts:
        raise FileError(path, f"has no part {_BOOK!r}", "byte 0")
    try:
        collector = Collector(path)
        if len(parts) > 1:
            collector.note(f"{len(parts) - 1} parts of the file that are no colours (profiles) are left out.")
        return _Reader(read_root(parts[_BOOK], path, "SwatchBook"), collector).palette()
    except FileError as error:
        raise in_part(error, _BOOK) from error


class _Reader:
    def __init__(self, root: Element, collector: Collector) -> None:
        self._root, self._collector = root, collector
        self._materials: dict[str, Element] = {}
        self._used: set[str] = set()
        self._after: list[tuple[int, str]] = []

    def palette(self) -> tuple[Palette, tuple[str, ...]]:
        root, collector = self._root, self._collector
        materials = root.first("materials")
        for element in materials.children if materials else []:
            self._take_material(element)
        book = root.first("book")
        begin: list[str] = []
        if book is not None:
            self._read_group(book, (), begin)
        left = [name for name in self._materials if name not in self._used]
        for name in left:
            self._add(self._materials[name], name, ())
        if left and book is not None and self._used:
            collector.note(f"{len(left)} colours that the book does not show come at the end.")
        metadata = root.first("metadata")
        title, _, notes, kept = _described(metadata, collector)
        foreign = [(_META, json.dumps(kept, ensure_ascii=False))] if kept else []
        if begin:
            foreign.append((_AFTER, " ".join(begin)))
        columns = book.attributes.get("columns", "") if book is not None else ""
        whole = int(columns) if columns.isascii() and columns.isdecimal() and len(columns) < 5 else 0
        return collector.finish(title, notes=notes, columns=whole, foreign=tuple(foreign))

    def _take_material(self, element: Element) -> None:
        collector, place = self._collector, f"line {element.line}"
        if element.name != "color":
            self._collector.note("{n} material[|s] of another kind (patterns, gradients) [is|are] left out.")
            return
        _, name, _, _ = _described(element.first("metadata"), collector)
        if name in self._materials:
            raise collector.fail(f"two materials are called {name[:80]!r}", place)
        self._materials[name] = element
        collector.check_count(len(self._materials), place)

    def _read_group(self, around: Element, group: GroupPath, before: list[str]) -> None:
        """Read what is in a book or a group; spacers and breaks are recorded with the swatch before them."""
        collector = self._collector
        for element in around.children:
            place = f"line {element.line}"
            if element.name == "swatch":
                name = element.attributes.get("material", "").strip()
                # The reader of a material's name takes the white space away, too.
                if name not in self._materials:
                    collector.note("{n} swatch[|es] of a material that is not in the file [is|are] left out.")
                    continue
                self._used.add(name)
                self._add(self._materials[name], name, group)
                before = []
            elif element.name in ("spacer", "break"):
                self._mark(element.name, group, before)
            elif element.name == "group":
                title, _, notes, _ = _described(element.first("metadata"), collector)
                inner = collector.group(place, group, title, notes)
                self._read_group(element, inner, before)

    def _mark(self, what: str, group: GroupPath, before: list[str]) -> None:
        entries = self._collector.entries
        if not entries or entries[-1].group != group:
            if not entries:
                before.append(what)
            return
        known = dict(entries[-1].foreign)
        marks = f"{known.get(_AFTER, '')} {what}".strip()
        if len(marks) < 1000:
            entries[-1] = replace(entries[-1], foreign=tuple({**known, _AFTER: marks}.items()))

    def _add(self, element: Element, identifier: str, group: GroupPath) -> None:
        collector, place = self._collector, f"line {element.line}"
        title, _, notes, kept = _described(element.first("metadata"), collector)
        own = identifier.startswith(_OWN_ID)
        name = title if title or own else identifier
        colours = [c for c in (self._values(v, collector) for v in element.all("values")) if c is not None]
        if not colours:
            collector.note("{n} colour[|s] without numbers in a known model [is|are] left out.")
            return
        first = colours[0]
        colour = collector.colour(
            place, name, first.model, first.values, space=first.space,
            illuminant=first.illuminant, observer_deg=first.observer_deg, others=tuple(colours[1:17]),
        )  # fmt: skip
        word = element.attributes.get("usage", "").split(",")[0].strip()
        collector.add(
            place,
            colour,
            group=group,
            code="" if own or not title else collector.name(identifier, 200),
            notes=notes,
            usage=word if word in _USAGES else "process",
            foreign=((_META, json.dumps(kept, ensure_ascii=False)),) if kept else (),
        )

    def _values(self, element: Element, collector: Collector) -> FlatColour | None:
        word = element.attributes.get("model", "")
        if element.attributes.get("space") == _SHOWN:
            return None
        if word not in _MODELS:
            collector.note("{n} further number[|s] of a model that is not known [is|are] left out.")
            return None
        model = _MODELS[word]
        texts = element.text.split()[:20]
        values = [number(element, text, collector.path, "a value") for text in texts]
        if model in ("HSB", "HSL") and values:
            values[0] = unscale_text(texts[0], 1, 360)
        elif model == "XYZ":
            values = [unscale_text(text, 1, 100) for text in texts]
        white = ("D50", 2) if model in ("Lab", "LCh", "XYZ") else ("", 0)
        space = "sRGB" if word == "sRGB" else element.attributes.get("space", "")
        return collector.colour(
            f"line {element.line}", "", model, values,
            space=collector.name(space, 200), illuminant=white[0], observer_deg=white[1],
        )  # fmt: skip


def _described(metadata: Element | None, collector: Collector) -> tuple[str, str, str, list[list[str]]]:
    """Return title, identifier, description and further metadata as pairs of name and text."""
    found: dict[str, str] = {}
    kept: list[list[str]] = []
    for child in metadata.children if metadata else []:
        lang = child.attributes.get("lang", "")
        if child.name in found or child.name not in _TITLES or lang:
            if len(kept) < 100 and child.text:
                kept.append([child.name, child.text[:2000], *([lang] if lang else [])])
            continue
        found[child.name] = child.text
    title, identifier = (collector.name(found.get(name, "")) for name in ("title", "identifier"))
    return title.strip(), identifier.strip(), collector.lines(found.get("description", "")), kept


def write(palette: Palette) -> bytes:
    """Return the content of an SBZ file."""
    identifiers = _identifiers(palette)
    materials = "".join(_material(entry, identifiers[entry.id]) for entry in palette)
    columns = f' columns="{palette.columns}"' if palette.columns else ""
    foreign = dict(palette.foreign)
    xml = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<SwatchBook version="0.7"\n    xmlns:dc="{_DC}"\n    xmlns:dcterms="http://purl.org/dc/terms/"\n'
        '    xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">\n'
        "  <metadata>\n"
        "    <dc:format>application/swatchbook</dc:format>\n"
        '    <dc:type rdf:resource="http://purl.org/dc/dcmitype/Dataset" />\n'
        f"    <dc:title>{text_content(palette.name)}</dc:title>\n"
        + _description(palette.notes, "    ")
        + _metadata(foreign, "    ")
        + f"  </metadata>\n  <materials>\n{materials}  </materials>\n  <book{columns}>\n"
        + _marks(foreign.get(_AFTER, ""), "    ")
        + _arranged(palette, identifiers)
        + "  </book>\n</SwatchBook>\n"
    )
    return pack_zip({_BOOK: xml.encode("utf-8")})


def _identifiers(palette: Palette) -> dict[str, str]:
    """Return a material identifier for each entry's id: its code, else its name, else a generated one."""
    found: dict[str, str] = {}
    taken: set[str] = set()
    for entry in palette:
        wanted = (entry.code if entry.code and entry.name else "" if entry.code else entry.name).strip()
        identifier = wanted if wanted and wanted not in taken else f"{_OWN_ID}{entry.id}"
        taken.add(identifier)
        found[entry.id] = identifier
    return found


def _material(entry: Entry, identifier: str) -> str:
    usage = f' usage="{entry.usage}"' if entry.usage in _USAGES else ""
    title = entry.name if identifier != entry.name.strip() else ""
    rows = "".join(_values(colour) for colour in _colours(entry)) + _shown(entry)
    return (
        f"    <color{usage}>\n      <metadata>\n        <dc:identifier>{text_content(identifier)}</dc:identifier>\n"
        + (f"        <dc:title>{text_content(title)}</dc:title>\n" if title else "")
        + _description(entry.notes, "        ")
        + _metadata(dict(entry.foreign), "        ")
        + f"      </metadata>\n{rows}    </color>\n"
    )


def _colours(entry: Entry) -> list[FlatColour]:
    first = convert_to_flat(entry, _NAMES)
    content = entry.content
    if isinstance(content, FlatColour) and first.values == content.values:
        icc = [o for o in content.others if o.model in _NAMES and (o.illuminant in ("", "D50"))]
        return [first, *icc]
    return [first]


def _shown(entry: Entry) -> str:
    """Return RGB numbers beside those of a less common model; this program ignores them."""
    if convert_to_flat(entry, _NAMES).model not in _SELDOM_READ:
        return ""
    numbers = " ".join(repr(value) for value in in_srgb(convert_to_flat(entry, ("RGB",))).values)
    return f'      <values model="RGB" space="{_SHOWN}">{numbers}</values>\n'


def _values(colour: FlatColour) -> str:
    word = _NAMES[colour.model]
    space = f" space={attribute(colour.space)}" if colour.space else ""
    if colour.model == "RGB" and colour.space == "sRGB":
        word, space = "sRGB", ""
    numbers = [repr(value) for value in colour.values]
    if colour.model in ("HSB", "HSL"):
        numbers[0] = scale_text(colour.values[0], 1, 360)
    elif colour.model == "XYZ":
        numbers = [scale_text(value, 1, 100) for value in colour.values]
    return f'      <values model="{word}"{space}>{" ".join(numbers)}</values>\n'


def _description(notes: str, indent: str) -> str:
    return f"{indent}<dc:description>{text_content(notes)}</dc:description>\n" if notes else ""


def _metadata(foreign: dict[str, str], indent: str) -> str:
    """Return another file's metadata under the same names; elements of dc: all of them are texts."""
    rows = []
    try:
        kept = json.loads(foreign.get(_META, "[]"))
    except ValueError:
        return ""
    for row in kept if isinstance(kept, list) else []:
        if isinstance(row, list) and 2 <= len(row) <= 3 and all(isinstance(word, str) for word in row):
            name = "".join(letter for letter in row[0] if letter.isascii() and letter.isalnum())
            lang = f" xml:lang={attribute(row[2])}" if len(row) == 3 else ""
            rows.append(
                f"{indent}<dc:{name or 'source'}{lang}>{text_content(row[1])}</dc:{name or 'source'}>\n"
            )
    return "".join(rows)


def _marks(marks: str, indent: str) -> str:
    return "".join(f"{indent}<{mark} />\n" for mark in marks.split() if mark in ("spacer", "break"))


def _arranged(palette: Palette, identifiers: dict[str, str]) -> str:
    rows: list[str] = []
    for group, entries, ended, begun in nested_sections(palette):
        path = () if group is None else group.path
        rows += [f"{'  ' * (len(one) + 1)}</group>\n" for one in ended]
        rows += [_opening(one, group) for one in begun]
        indent = "  " * (len(path) + 2)
        for entry in entries:
            rows.append(f"{indent}<swatch material={attribute(identifiers[entry.id])} />\n")
            rows.append(_marks(dict(entry.foreign).get(_AFTER, ""), indent))
    return "".join(rows)


def _opening(path: GroupPath, group: Group | None) -> str:
    indent = "  " * (len(path) + 1)
    notes = group.notes if group is not None and group.path == path else ""
    return (
        f"{indent}<group>\n{indent}  <metadata>\n{indent}    <dc:title>{text_content(path[-1])}</dc:title>\n"
        + _description(notes, indent + "    ")
        + f"{indent}  </metadata>\n"
    )


FORMAT = PaletteFormat(
    name="sbz",
    title="SwatchBooker swatch book",
    endings=(".sbz",),
    models=tuple(_NAMES),
    groups="nested",
    holds="Names in any script, codes, notes, groups within groups, several models for one colour with every digit, "
    "spot and global colours, columns.",
    sniff=lambda head, _size: is_zip(head) and _BOOK.encode("ascii") in head,
    read=read,
    write=write,
    order="by groups",
)
