"""Sketch palettes (``.sketchpalette``): colours as red, green, blue and alpha from 0 to 1, in newer ones with names.

Files of the layouts before 1.4 have hex codes, or the components as texts.
"""

from __future__ import annotations

import json
from typing import Any

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_text
from brdf_suite.files.palettes.conversions import convert_to_plain
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.text.css import parse_colour
from brdf_suite.files.tables.grid import parse_number

_KEYS = ("red", "green", "blue")
_VERSION = "1.4"
"""The layout's own version: plug-ins of a lower version refuse a file, and from 1.4 on colours are numbers."""


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a Sketch file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    try:
        value = json.loads(decode_text(content, path, collector))
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise collector.fail(f"is not valid JSON ({error.msg.lower()})", place) from error
    except (RecursionError, ValueError) as error:
        raise collector.fail(f"is not JSON that can be read ({str(error)[:80]})", "line 1") from error
    colours = value.get("colors") if isinstance(value, dict) else None
    if not isinstance(colours, list):
        raise collector.fail("has no list of colours", "colors")
    collector.check_count(len(colours), "colors")
    for index, item in enumerate(colours):
        _add(item, collector, f"colors[{index}]")
    for key in ("gradients", "images"):
        kept = value.get(key)
        if isinstance(kept, list) and kept:
            collector.note(f"{len(kept)} {key} are left out.")
    return collector.finish()


def _add(item: Any, collector: Collector, place: str) -> None:
    found = parse_colour(item) if isinstance(item, str) else None
    alpha: float | None
    if found is not None:
        values, alpha = list(found[0].values), found[1]
    else:
        given = item if isinstance(item, dict) else {}
        read_ = [_number(given.get(key)) for key in _KEYS]
        values = [value for value in read_ if value is not None]
        alpha = _number(given.get("alpha", 1))
    if len(values) < len(_KEYS):
        raise collector.fail("expected red, green and blue as numbers, or a hex code", place)
    if alpha != 1:
        collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
    name = item.get("name") if isinstance(item, dict) else ""
    label = collector.name(name if isinstance(name, str) else "")
    collector.add(place, collector.colour(place, label, "RGB", values))


def _number(value: Any) -> float | None:
    """Return a component, which old versions write as a text."""
    return value if type(value) in (int, float) else parse_number(value) if isinstance(value, str) else None


def write(palette: Palette) -> bytes:
    """Return the content of a Sketch palette, with names."""
    colours = []
    for entry in palette:
        values = convert_to_plain(entry, ("RGB",)).values
        held = [min(1.0, max(0.0, value)) for value in values]
        colours.append({"name": entry.name, **dict(zip(_KEYS, held, strict=True)), "alpha": 1})
    document = {"compatibleVersion": _VERSION, "pluginVersion": "2.22", "colors": colours}
    return json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode("utf-8", "replace")


FORMAT = PaletteFormat(
    name="sketch",
    title="Sketch palette",
    endings=(".sketchpalette",),
    models=("RGB",),
    holds="Names in any script, sRGB with every digit.",
    sniff=lambda head, _size: (
        head.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"{")
        and b'"colors"' in head
        and (
            b'"compatibleVersion"' in head or (b'"red"' in head and b'"alpha"' in head and b'"$' not in head)
        )
    ),
    read=read,
    write=write,
)
