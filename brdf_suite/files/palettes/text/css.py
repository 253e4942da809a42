"""CSS custom properties: ``--name: colour;`` in a rule for the whole page.

A name that CSS cannot hold is made of letters, digits and hyphens; the name itself follows in a comment, as JSON has
texts. A comment with a list of texts begins a group, an empty list ends it. Files of others without such comments give
the properties' own names.
"""

from __future__ import annotations

import json
import re
import unicodedata

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, GroupPath, Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_text
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.text.css_colour import convert_to_css, format_css, parse_colour

# Every branch takes at least one character and none can be taken in two ways, so the time is that of the length.
_TOKEN = re.compile(
    r"/\*(?P<comment>.*?)(?P<closed>\*/|\Z)|--(?P<name>[\w-]+)\s*:(?P<value>[^;{}/]*(?:/(?!\*)[^;{}/]*)*)",
    re.DOTALL,
)
_SNIFF = re.compile(rb"(?:^|[\s{;/])--[A-Za-z0-9_\x80-\xff-]+\s*:")
_MODELS = ("RGB", "HSL", "CMYK", "Lab", "LCh", "XYZ")
_LONGEST_PROPERTY = 100


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a style sheet; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    text = decode_text(content, path, collector).replace("\r\n", "\n")
    line, reached = 1, 0
    group: GroupPath = ()
    name = ""
    notes: list[str] = []
    waiting: tuple[str, FlatColour, str] | None = None

    def settle(label: str | None) -> None:
        nonlocal waiting
        if waiting is not None:
            place, colour, property_ = waiting
            colour = collector.colour(
                place, collector.name(property_ if label is None else label), colour.model, colour.values,
                space=colour.space, illuminant=colour.illuminant, observer_deg=colour.observer_deg,
            )  # fmt: skip
            collector.add(place, colour, group=group)
        waiting = None

    for token in _TOKEN.finditer(text):
        line += text.count("\n", reached, token.start())
        reached = token.start()
        place = f"line {line}"
        if token["comment"] is not None:
            if token["closed"] != "*/":
                raise collector.fail("a comment does not end", place)
            said = _said(token["comment"])
            if isinstance(said, str):
                settle(said)
            elif isinstance(said, list):
                settle(None)
                group = collector.declare(place, [word for word in said[:32] if isinstance(word, str)])
            elif isinstance(said, dict):
                name = str(said.get("palette", ""))
                notes.append(collector.lines(str(said.get("notes", ""))))
            continue
        settle(None)
        found = parse_colour(token["value"])
        if found is None:
            collector.note(
                "{n} custom propert[y that is no colour|ies that are no colours] known here skipped."
            )
            continue
        if found[1] != 1.0:
            collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
        waiting = (place, found[0], token["name"])
    settle(None)
    if not collector.entries and not name:
        raise collector.fail("holds no custom property that is a colour", "line 1")
    return collector.finish(name, notes="\n".join(notes).strip())


def _said(comment: str) -> object:
    """Return the content of a comment written by this program; None for others."""
    text = comment.strip()
    if not text.startswith(('"', "[", "{")) or len(text) > 200_000:
        return None
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return None


def write(palette: Palette) -> bytes:
    """Return a style sheet with a property for each entry."""
    rows = [f"/* {_json({'palette': palette.name, 'notes': palette.notes})} */\n", ":root {\n"]
    taken: set[str] = set()
    for group, entries in palette.sections():
        rows.append(f"  /* {_json(list(group.path) if group else [])} */\n")
        for entry in entries:
            colour = format_css(convert_to_css(entry, _MODELS))
            rows.append(f"  --{_property(entry, taken)}: {colour}; /* {_json(entry.name)} */\n")
    return "".join((*rows, "}\n")).encode("utf-8", "replace")


def _json(value: object) -> str:
    """Return JSON text that cannot end a comment."""
    return json.dumps(value, ensure_ascii=False).replace("*/", "*\\u002f").replace("/*", "\\u002f*")


def _property(entry: Entry, taken: set[str]) -> str:
    """Return a unique name that is valid in CSS."""
    plain = unicodedata.normalize("NFKC", entry.name).casefold()
    word = re.sub(r"[^\w]+", "-", plain).strip("-_")[:_LONGEST_PROPERTY] or "colour"
    if word in taken:
        # The entry's own id is in no other's name but by chance, so ten thousand of one name need no search.
        word = f"{word}-{entry.id}"
    while word in taken:
        word += "-"
    taken.add(word)
    return word


def _sniff(head: bytes, _size: int) -> bool:
    return (
        b"\0" not in head and not head.lstrip().startswith((b"<", b"{", b"[")) and bool(_SNIFF.search(head))
    )


FORMAT = PaletteFormat(
    name="css",
    title="CSS custom properties",
    endings=(".css",),
    models=_MODELS,
    groups="nested",
    holds="Names in any script, groups within groups, RGB of several spaces, HSL, CMYK, Lab, LCh and XYZ with every "
    "digit, notes of the palette.",
    sniff=_sniff,
    read=read,
    write=write,
    order="by groups",
)
