"""CSS custom properties: ``--name: colour;`` in a rule for the whole page.

A name that CSS cannot hold is made of letters, digits and hyphens; the name itself follows in a comment, as JSON has
texts. A comment with a list of texts begins a group, an empty list ends it. Files of others without such comments give
the properties' own names.
"""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Collection
from functools import cache

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_PRIMARIES, primaries_to_xyz, srgb_encode
from brdf_suite.appearance.colour.spaces import oklab_to_srgb
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, GroupPath, Palette
from brdf_suite.errors import PathLike, ValueRangeError
from brdf_suite.files.palettes.collecting import Collector, decode_text
from brdf_suite.files.palettes.conversions import convert_to_flat, in_srgb, scale_text, unscale_text
from brdf_suite.files.palettes.format import PaletteFormat

_HEX = re.compile("#([0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})")
_FUNCTION = re.compile(r"([a-z-]+)\(([^()]{1,200})\)")
_NUMBER = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?)(%|deg|turn|rad|grad)?")
_ANGLES = {"deg": 1.0, "turn": 360.0, "rad": 57.29577951308232, "grad": 0.9}
SPACES = {
    "srgb": "",
    "display-p3": "Display P3",
    "a98-rgb": "Adobe RGB (1998)",
    "prophoto-rgb": "ProPhoto RGB",
    "rec2020": "Rec. 2020",
}
"""RGB spaces of CSS and what palettes call them; sRGB is what RGB is anyway."""


def parse_colour(text: str) -> tuple[FlatColour, float] | None:
    """Return the colour in a CSS value and its opacity, or None where it is none that is known here.

    >>> parse_colour("rgb(51 102 153)")[0].values == parse_colour("#336699")[0].values
    True
    """
    text = text.strip().lower()
    if len(text) > 300:
        return None
    try:
        return _hex(text) or _function(text) or _hex(_names().get(text, ""))
    except ValueRangeError:
        return None


def _hex(text: str) -> tuple[FlatColour, float] | None:
    found = _HEX.fullmatch(text)
    if found is None:
        return None
    digits = found[1] if len(found[1]) > 4 else "".join(2 * digit for digit in found[1])
    values = [value / 255.0 for value in bytes.fromhex(digits)]
    return FlatColour("", "RGB", tuple(values[:3])), values[3] if len(values) == 4 else 1.0


@cache
def _names() -> dict[str, str]:
    # The 148 names of CSS; an import that files without names need not wait for.
    from PIL import ImageColor

    return {key: value for key, value in ImageColor.colormap.items() if isinstance(value, str)}


def _function(text: str) -> tuple[FlatColour, float] | None:
    found = _FUNCTION.fullmatch(text)
    if found is None:
        return None
    kind = found[1]
    body, _, opacity = found[2].partition("/")
    words = body.replace(",", " ").split()
    space = words.pop(0) if kind == "color" and words else ""
    numbers = [_number(word) for word in words]
    alpha = _number(opacity.strip()) if opacity.strip() else None
    if any(number is None for number in numbers) or (opacity.strip() and alpha is None):
        return None
    values = [number for number in numbers if number is not None]
    wanted = 4 if kind == "device-cmyk" else 3
    if alpha is None and len(values) == wanted + 1 and kind in ("rgb", "rgba", "hsl", "hsla"):
        alpha = values.pop()
    if len(values) != wanted:
        return None
    colour = _built(kind, space, values)
    return None if colour is None else (colour, 1.0 if alpha is None else _plain(alpha, 1.0))


_Number = tuple[str, str]
"""The digits and the unit."""


def _number(word: str) -> _Number | None:
    if word == "none":
        return "0", ""
    found = _NUMBER.fullmatch(word)
    return None if found is None else (found[1], found[2] or "")


def _plain(number: _Number, full: float) -> float:
    """Return a number whose 100 % is ``full``."""
    text, unit = number
    return unscale_text(text, 100) * full if unit == "%" else float(text)


def _hue(number: _Number) -> float:
    text, unit = number
    degrees = float(text) * _ANGLES.get(unit, 1.0)
    return degrees if 0.0 <= degrees <= 360.0 else degrees % 360.0


def _built(kind: str, space: str, v: list[_Number]) -> FlatColour | None:
    if kind in ("rgb", "rgba"):
        numbers = tuple(unscale_text(text, 100 if unit == "%" else 255) for text, unit in v)
        return FlatColour("", "RGB", numbers)
    if kind in ("hsl", "hsla"):
        return FlatColour("", "HSL", (_hue(v[0]), unscale_text(v[1][0], 100), unscale_text(v[2][0], 100)))
    if kind == "hwb":
        white, black = unscale_text(v[1][0], 100), unscale_text(v[2][0], 100)
        if white + black > 1.0:
            # CSS Color 4, section 8: a grey in their proportion.
            return FlatColour("", "HSB", (_hue(v[0]), 0.0, white / (white + black)))
        bright = 1.0 - black
        saturation = 0.0 if bright <= 0.0 else max(0.0, 1.0 - white / bright)
        return FlatColour("", "HSB", (_hue(v[0]), saturation, bright))
    if kind == "lab":
        values = (_plain(v[0], 100.0), _plain(v[1], 125.0), _plain(v[2], 125.0))
        return FlatColour("", "Lab", values, "", "D50", 2)
    if kind == "lch":
        values = (_plain(v[0], 100.0), _plain(v[1], 150.0), _hue(v[2]))
        return FlatColour("", "LCh", values, "", "D50", 2)
    if kind == "device-cmyk":
        return FlatColour("", "CMYK", tuple(_plain(x, 1.0) for x in v))
    if kind == "oklab":
        return _oklab(_plain(v[0], 1.0), _plain(v[1], 0.4), _plain(v[2], 0.4))
    if kind == "oklch":
        chroma, hue = _plain(v[1], 0.4), np.radians(_hue(v[2]))
        return _oklab(_plain(v[0], 1.0), chroma * float(np.cos(hue)), chroma * float(np.sin(hue)))
    if kind == "color" and space in SPACES:
        return FlatColour("", "RGB", tuple(_plain(x, 1.0) for x in v), SPACES[space])
    if kind == "color" and space == "srgb-linear":
        return FlatColour("", "RGB", tuple(srgb_encode([_plain(x, 1.0) for x in v]).tolist()))
    if kind == "color" and space in ("xyz", "xyz-d65", "xyz-d50"):
        xyz = tuple(100.0 * _plain(x, 1.0) if x[1] == "%" else unscale_text(x[0], 1, 100) for x in v)
        return FlatColour("", "XYZ", xyz, "", "D50" if space == "xyz-d50" else "D65", 2)
    return None


def _oklab(lightness: float, a: float, b: float) -> FlatColour:
    """Convert Oklab to XYZ of D65, which includes colours beyond sRGB."""
    xyz = 100.0 * primaries_to_xyz(REC709_PRIMARIES) @ oklab_to_srgb(lightness, a, b)
    return FlatColour("", "XYZ", tuple(xyz.tolist()), "", "D65", 2)


def convert_to_css(entry: Entry, models: Collection[str]) -> FlatColour:
    """Return :func:`convert_to_flat`, where RGB of a space that CSS does not name becomes sRGB."""
    colour = convert_to_flat(entry, models)
    return colour if colour.model == "RGB" and colour.space in SPACES.values() else in_srgb(colour)


def space_word(colour: FlatColour) -> str:
    """Return what CSS calls the space of a colour in RGB; the numbers of an unknown one go as sRGB."""
    return next((word for word, name in SPACES.items() if name == colour.space), "srgb")


def format_css(colour: FlatColour) -> str:
    """Return a colour in RGB, HSL, CMYK, or Lab, LCh or XYZ of a white that CSS knows, as CSS writes it.

    The numbers have every digit; eight-bit sRGB is written as hex.
    """
    v = [repr(value) for value in colour.values]
    if colour.model == "RGB":
        word = space_word(colour)
        whole = [round(255.0 * value) for value in colour.values]
        exact = all(
            x == byte / 255.0 and 0 <= byte <= 255 for x, byte in zip(colour.values, whole, strict=True)
        )
        return f"#{bytes(whole).hex()}" if exact and word == "srgb" else f"color({word} {' '.join(v)})"
    if colour.model == "HSL":
        return f"hsl({v[0]} {scale_text(colour.values[1], 100)}% {scale_text(colour.values[2], 100)}%)"
    if colour.model == "CMYK":
        return f"device-cmyk({' '.join(v)})"
    if colour.model == "XYZ":
        light = "xyz-d65" if colour.illuminant == "D65" else "xyz-d50"
        return f"color({light} {' '.join(scale_text(value, 1, 100) for value in colour.values)})"
    return f"{colour.model.lower()}({' '.join(v)})"


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


FORMAT = PaletteFormat(
    name="css",
    title="CSS custom properties",
    endings=(".css",),
    models=_MODELS,
    groups="nested",
    holds="Names in any script, groups within groups, RGB of several spaces, HSL, CMYK, Lab, LCh and XYZ with every "
    "digit, notes of the palette.",
    sniff=lambda head, _size: (
        b"\0" not in head and not head.lstrip().startswith((b"<", b"{", b"[")) and bool(_SNIFF.search(head))
    ),
    read=read,
    write=write,
    order="by groups",
)
