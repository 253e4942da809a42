"""Colours in SCSS, Sass and LESS, read only: variables, and the pairs of maps.

``$name: #336699;`` and ``@name: #336699;`` are entries; ``$map: ("red": #d40000, …)`` is a group. A value may be a
variable that was set before. Functions that make colours of others (``darken``, ``mix``) are not computed, and are
left out with a notice.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import GroupPath, Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_text
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.text.css import parse_colour

# Every branch takes at least one character and none can be taken in two ways, so the time is that of the length.
_TOKEN = re.compile(
    r"/\*.*?(?:\*/|\Z)|//[^\n]*|(?P<open>\()|(?P<close>\))|(?P<end>[;{}])|(?P<comma>,)"
    r"|(?P<key>(?:--|[$@])?[\w-]+|\"[^\"\n]*\"|'[^'\n]*')\s*:"
    r"|(?P<word>#[\w-]+|[$@]?[\w.%+-]+(?:\([^()\n]*\))?|\"[^\"\n]*\"|'[^'\n]*'|!\w+)|\s+|.",
    re.DOTALL,
)
_SNIFF = re.compile(rb"(?m)^\s*[$@][A-Za-z0-9_\x80-\xff-]+\s*:")
_RULES = (
    "@import",
    "@use",
    "@media",
    "@include",
    "@mixin",
    "@forward",
    "@charset",
    "@font-face",
    "@supports",
)
_DEEPEST = 16


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a style sheet; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    text = decode_text(content, path, collector).replace("\r\n", "\n")
    known: dict[str, tuple[FlatColour, float]] = {}
    groups: dict[tuple[str, ...], GroupPath] = {}
    for line, path_of_names, value in _pairs(text):
        place = f"line {line}"
        found = parse_colour(value) or known.get(value.lstrip("$@").replace("_", "-"))
        if found is None:
            collector.note("{n} value[ that is no colour|s that are no colours] known here skipped.")
            continue
        colour, opacity = found
        if opacity != 1.0:
            collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
        *around, name = path_of_names
        if not around:
            known.setdefault(name.replace("_", "-"), found)
        key = tuple(around)
        if key and key not in groups:
            groups[key] = collector.declare(place, around[:_DEEPEST])
        checked = replace(colour, name=collector.name(name))
        collector.add(place, checked, group=groups.get(key, ()))
    if not collector.entries:
        raise collector.fail("holds no variable that is a colour", "line 1")
    return collector.finish()


def _pairs(text: str) -> Iterator[tuple[int, list[str], str]]:
    """Yield the line, the names from the outside in, and the value of each setting."""
    names: list[str] = []  # of the maps that are open
    key, words = "", list[str]()
    line = start = 1
    reached = 0
    for token in _TOKEN.finditer(text):
        line += text.count("\n", reached, token.start())
        reached = token.start()
        kind = token.lastgroup
        if kind == "open":
            if key and not words and len(names) < _DEEPEST:
                names.append(key)
                key = ""
            elif key:
                words.append("(")
        elif kind in ("close", "comma", "end"):
            if key and words and words[0] != "(":
                yield start, [*names, key], " ".join(words)
            key, words = "", []
            if kind == "close" and names:
                names.pop()
            elif kind == "end":
                names = []
        elif kind == "key":
            variable = token["key"].startswith(("$", "@", "--"))
            if names or variable:
                key, words, start = token["key"].lstrip("$@-").strip("\"'"), [], line
                if token["key"] in _RULES:
                    key = ""
        elif kind == "word" and key and not token["word"].startswith("!"):
            words.append(token["word"].strip("\"'"))
    if key and words:
        yield start, [*names, key], " ".join(words)


FORMAT = PaletteFormat(
    name="scss",
    title="SCSS, Sass and LESS variables",
    endings=(".scss", ".less", ".sass"),
    models=("RGB", "HSL", "HSB", "Lab", "LCh", "XYZ", "CMYK"),
    holds="Read only. Variables and maps of colours as CSS writes them, maps as groups.",
    sniff=lambda head, _size: (
        b"\0" not in head and not head.lstrip().startswith((b"<", b"{", b"[")) and bool(_SNIFF.search(head))
    ),
    read=read,
    groups="nested",
)
