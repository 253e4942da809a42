"""Scribus XML: colours as layout needs them, with flags for inks of their own and for registration marks.

Older files hold ``RGB="#rrggbb"`` or ``CMYK="#ccmmyykk"`` in bytes; newer ones ``SPACE="RGB"`` with R, G, B from 0 to
255, ``SPACE="CMYK"`` with C, M, Y, K in percent, or ``SPACE="Lab"`` with L, A, B. The newer way counts where both are
there; numbers that it leaves out are 0. Scribus knows a colour by its name, so equal and missing names are written with
a number. A colour is written the old way, so that every program reads it, and the newer way, too, where bytes do not
hold it.
"""

from __future__ import annotations

import re

from brdf_suite.documents.flat_colour import FlatColour, Model
from brdf_suite.documents.palette import Entry, Foreign, Palette, Usage
from brdf_suite.errors import PathLike
from brdf_suite.files.cxf_specification import number
from brdf_suite.files.hardened_xml import Element, attribute, mentions, read_root
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import (
    convert_to_plain,
    convert_to_rgb8,
    scale_text,
    unique_names,
    unscale_text,
)
from brdf_suite.files.palettes.format import PaletteFormat

_ROOT = "SCRIBUSCOLORS"
_HEX = re.compile("#?((?:[0-9a-fA-F]{2})+)")
_REGISTER = "scribus.register"
_TRUE = ("1", "true", "yes")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a Scribus file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    root = read_root(content, path, _ROOT)
    collector.check_count(len(root.children), f"line {root.line}")
    unknown = ""
    for element in root.children:
        if element.name != "COLOR":
            collector.note("{n} element[ that is no colour|s that are no colours] skipped.")
            continue
        place = f"line {element.line}"
        has = element.attributes.get
        foreign: Foreign = ((_REGISTER, "1"),) if has("Register", "0").lower() in _TRUE else ()
        usage: Usage = "spot" if has("Spot", "0").lower() in _TRUE else "process"
        colour = _colour(element, collector, place)
        if colour is None:
            unknown = place
            collector.note("{n} colour[|s] in a model that is not known here [is|are] left out.")
            continue
        collector.add(place, colour, usage=usage, foreign=foreign)
    if unknown and not collector.entries:
        raise collector.fail("holds no colour in RGB, CMYK or Lab", unknown)
    return collector.finish(root.attributes.get("Name", ""))


def _colour(element: Element, collector: Collector, place: str) -> FlatColour | None:
    """Return the colour of an element; None where it names no model that is known here."""
    given = element.attributes
    name = collector.name(given.get("NAME", given.get("Name", "")))
    space = given.get("SPACE", "").upper()

    def numbers(keys: str, scale: int) -> list[float]:
        if any(key not in given for key in keys):
            collector.note("{n} colour[|s] without some of [its|their] numbers; these are 0, as in Scribus.")
        texts = [given.get(key, "0").strip() for key in keys]
        for key, text in zip(keys, texts, strict=True):
            number(element, text, collector.path, key)  # so that invalid numbers are reported with their line
        return [unscale_text(text, scale) for text in texts]

    if space == "CMYK":
        return collector.colour(place, name, "CMYK", numbers("CMYK", 100))
    if space == "RGB":
        return collector.colour(place, name, "RGB", numbers("RGB", 255))
    if space == "LAB":
        return collector.colour(place, name, "Lab", numbers("LAB", 1), illuminant="D50", observer_deg=2)
    models: tuple[Model, ...] = ("CMYK", "RGB")
    for key in models:
        if key in given:
            found = _HEX.fullmatch(given[key].strip())
            values = bytes.fromhex(found[1]) if found else b""
            if len(values) != len(key):
                raise collector.fail(
                    f"expected {len(key)} bytes as in #{'33' * len(key)} for {key}, not {given[key][:40]!r}",
                    place,
                )
            return collector.colour(place, name, key, [value / 255.0 for value in values])
    return None


def write(palette: Palette) -> bytes:
    """Return the content of a Scribus file."""
    names = unique_names(palette)
    rows = "".join(
        f"  <COLOR {_attributes(entry, name)}/>\n" for entry, name in zip(palette, names, strict=True)
    )
    text = f'<?xml version="1.0" encoding="UTF-8"?>\n<{_ROOT} Name={attribute(palette.name)}>\n{rows}</{_ROOT}>\n'
    return text.encode("utf-8")


def _attributes(entry: Entry, name: str) -> str:
    colour = convert_to_plain(entry, ("RGB", "CMYK", "Lab"))
    # In bytes for all readers, and with every digit for those that know how, where bytes are not enough.
    model = "CMYK" if colour.model == "CMYK" else "RGB"
    whole = [round(255.0 * min(1.0, max(0.0, value))) for value in colour.values]
    if colour.model == "Lab":
        whole = list(convert_to_rgb8(entry))
    keys = f'{model}="#{bytes(whole).hex()}"'
    if colour.model == "Lab":
        numbers = " ".join(f'{key}="{v!r}"' for key, v in zip("LAB", colour.values, strict=True))
        keys += f' SPACE="Lab" {numbers}'
    elif any(value != byte / 255.0 for value, byte in zip(colour.values, whole, strict=True)):
        scale = 100 if colour.model == "CMYK" else 255
        pairs = zip(colour.model, colour.values, strict=True)
        numbers = " ".join(f'{key}="{scale_text(v, scale)}"' for key, v in pairs)
        keys += f' SPACE="{colour.model}" {numbers}'
    spot = int(entry.usage == "spot")
    register = int((_REGISTER, "1") in entry.foreign)
    return f'NAME={attribute(name)} {keys} Spot="{spot}" Register="{register}"'


FORMAT = PaletteFormat(
    name="scribus",
    title="Scribus colours (XML)",
    endings=(".xml",),
    models=("RGB", "CMYK", "Lab"),
    holds="Names in any script, RGB, CMYK and Lab with every digit, inks of their own, registration marks.",
    sniff=lambda head, _size: mentions(head, _ROOT),
    read=read,
    write=write,
    unique_names=True,
)
