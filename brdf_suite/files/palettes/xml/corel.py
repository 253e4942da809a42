"""CorelDRAW X5 and later (XML), read only: pages of colours, and inks with their values in several models.

``palette[@name]`` > ``colors`` > ``page`` > ``color[@cs, @tints, @name]`` with numbers from 0 to 1; ``cs`` is RGB,
CMYK, LAB, Gray … or the name of an ink, which ``colorspaces`` > ``cs`` defines by colours in models, with the amount in
``tints``. Texts may be references (``resid``) into ``localization``. Layout from a file of sK1's collection and from
the readers of SwatchBooker and UniConvertor.
"""

from __future__ import annotations

from brdf_suite.documents.flat_colour import FlatColour, Model
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.cxf_specification import number
from brdf_suite.files.hardened_xml import Element, mentions, read_root
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.format import PaletteFormat

_MODELS: dict[str, tuple[Model, str, int]] = {
    "RGB": ("RGB", "", 3),
    "SRGB": ("RGB", "sRGB", 3),
    "ADOBERGB": ("RGB", "Adobe RGB (1998)", 3),
    "CMYK": ("CMYK", "", 4),
    "CMY": ("CMY", "", 3),
    "LAB": ("Lab", "", 3),
    "GRAY": ("Gray", "", 1),
    "GREY": ("Gray", "", 1),
    "HSB": ("HSB", "", 3),
    "HSV": ("HSB", "", 3),
    "HLS": ("HSL", "", 3),
}
_LANGUAGES = ("EN", "DE")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a CorelDRAW file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    root = read_root(content, path, "palette")
    texts = _texts(root)
    inks = _inks(root, collector)
    colours = root.first("colors")
    pages = colours.children if colours is not None else []
    elements = [element for page in pages for element in (page.children if page.name == "page" else [page])]
    collector.check_count(len(elements), f"line {root.line}")
    for element in elements:
        if element.name != "color":
            collector.note("{n} element[ that is no colour|s that are no colours] skipped.")
            continue
        _add(element, texts, inks, collector)
    width = next((page.attributes.get("width", "") for page in pages), "")
    columns = int(width) if width.isascii() and width.isdecimal() and len(width) < 4 else 0
    return collector.finish(_text(root, texts), columns=columns)


def _texts(root: Element) -> dict[str, str]:
    """Return the texts of the file by their references: English where there is one."""
    localization = root.first("localization")
    found = {}
    for resource in localization.children if localization is not None else []:
        by_language = {child.name: child.text for child in resource.children}
        chosen = next((by_language[one] for one in _LANGUAGES if by_language.get(one)), "")
        found[resource.attributes.get("id", "")] = chosen or next(iter(by_language.values()), "")
    return found


def _text(element: Element, texts: dict[str, str]) -> str:
    return element.attributes.get("name", "") or texts.get(element.attributes.get("resid", ""), "")


def _inks(root: Element, collector: Collector) -> dict[str, list[FlatColour]]:
    spaces = root.first("colorspaces")
    found: dict[str, list[FlatColour]] = {}
    for space in spaces.children if spaces is not None else []:
        colours = [
            colour for element in space.all("color") if (colour := _colour(element, collector)) is not None
        ]
        if colours:
            # Those that say how an ink looks come before those of a press.
            colours.sort(
                key=lambda colour: ("Lab", "RGB").index(colour.model) if colour.model in ("Lab", "RGB") else 2
            )
            found.setdefault(space.attributes.get("name", ""), colours)
    return found


def _add(
    element: Element, texts: dict[str, str], inks: dict[str, list[FlatColour]], collector: Collector
) -> None:
    place = f"line {element.line}"
    space = element.attributes.get("cs", "")
    name = collector.name(_text(element, texts))
    ink = inks.get(space) or inks.get(space.removesuffix(" (2)"))
    if ink is not None and space.upper() not in _MODELS:
        amount = element.attributes.get("tints", "1").strip()
        if number(element, amount or "1", collector.path, "tints") != 1.0:
            collector.note("{n} tint[|s] of inks [is|are] left out: only full inks have a colour here.")
            return
        first, *others = ink
        colour = collector.colour(
            place, name or collector.name(space), first.model, first.values, space=first.space,
            illuminant=first.illuminant, observer_deg=first.observer_deg, others=tuple(others[:16]),
        )  # fmt: skip
        collector.add(place, colour, usage="spot")
        return
    found = _colour(element, collector)
    if found is None:
        collector.note("{n} colour[|s] in a model that is not known here [is|are] left out.")
        return
    collector.add(
        place,
        collector.colour(
            place, name, found.model, found.values, space=found.space, illuminant=found.illuminant,
            observer_deg=found.observer_deg,
        ),
    )  # fmt: skip


def _colour(element: Element, collector: Collector) -> FlatColour | None:
    known = _MODELS.get(element.attributes.get("cs", "").upper())
    if known is None:
        return None
    model, space, count = known
    words = element.attributes.get("tints", "").split(",")[:8]
    values = [number(element, word.strip(), collector.path, "tints") for word in words]
    place = f"line {element.line}"
    if len(values) != count:
        raise collector.fail(f"expected {count} numbers of {model} in tints, not {len(values)}", place)
    white = {}
    if model == "Lab":
        values = [100.0 * values[0], 255.0 * values[1] - 128.0, 255.0 * values[2] - 128.0]
        white = {"illuminant": "D50", "observer_deg": 2}
    elif model == "HSB":
        values[0] *= 360.0
    elif model == "HSL":
        values = [360.0 * values[0], values[2], values[1]]
    elif model == "Gray":
        collector.note("A grey of 1 is taken for white, on which readers of this format disagree.")
    return collector.colour(place, "", model, values, space=space, **white)


FORMAT = PaletteFormat(
    name="corel",
    title="CorelDRAW palette (XML)",
    endings=(".xml",),
    models=("RGB", "CMYK", "CMY", "Lab", "Gray", "HSB", "HSL"),
    holds="Read only. Names, RGB, CMYK, Lab, grey, HSB and HLS, inks with their values in several models.",
    sniff=lambda head, _size: mentions(head, "<palette") and mentions(head, "<colors", "<colorspaces"),
    read=read,
)
