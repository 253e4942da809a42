"""Files as other programs and people write them, in many variants of each format, with the colours that are in them.

Nothing here is shared with the readers: each writer follows the format's description, or a habit of people.
"""

from __future__ import annotations

import csv
import io
import itertools
import json
import plistlib
import random
import struct
from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple
from xml.sax.saxutils import quoteattr

NAMES = ("Rosso Corsa", "Süd Blau", "藍 0815", "Grau 7")
RGB = ((212, 0, 0), (0, 72, 255), (17, 34, 51), (120, 120, 122))
CMYK = ((0, 100, 90, 5), (100, 60, 0, 0), (90, 70, 40, 55), (0, 0, 0, 60))
LAB = ((43.25, 66.5, 54.75), (35.5, 20.25, -70.0), (12.5, -1.25, -12.0), (50.0, 0.0, -1.5))
ANGLES = (-15, 15, 25, 45, 75, 110)
Flat = tuple[str, str, tuple[float, ...]]
"""Name, model and numbers, as a palette of this suite has them."""
Reading = dict[tuple[float, float], tuple[float, float, float]]


class Variant(NamedTuple):
    """A file and what is in it: flat colours, or samples with L*a*b* by light and aspecular angle."""

    label: str
    content: bytes
    flat: tuple[Flat, ...] = ()
    samples: tuple[tuple[str, Reading], ...] = ()
    effects: dict[str, float] | None = None


def rgb_flat(names: tuple[str, ...] = NAMES) -> tuple[Flat, ...]:
    """The colours in RGB."""
    return tuple((name, "RGB", tuple(v / 255.0 for v in row)) for name, row in zip(names, RGB, strict=True))


def cmyk_flat(names: tuple[str, ...] = NAMES) -> tuple[Flat, ...]:
    """The colours in CMYK."""
    return tuple((name, "CMYK", tuple(v / 100.0 for v in row)) for name, row in zip(names, CMYK, strict=True))


def lab_flat(names: tuple[str, ...] = NAMES) -> tuple[Flat, ...]:
    """The colours in L*a*b*."""
    return tuple((name, "Lab", row) for name, row in zip(names, LAB, strict=True))


def decimal(value: float, comma: bool) -> str:
    """A number as a spreadsheet of a country writes it."""
    text = f"{value:g}"
    return text.replace(".", ",") if comma else text


def delimited(rows: list[list[str]], separator: str, newline: str = "\r\n") -> str:
    """Rows as CSV."""
    text = io.StringIO(newline="")
    csv.writer(text, delimiter=separator, lineterminator=newline).writerows(rows)
    return text.getvalue()


ENCODINGS: dict[str, Callable[[str], bytes]] = {
    "utf-8": lambda text: text.encode(),
    "utf-8-sig": lambda text: text.encode("utf-8-sig"),
    "utf-16": lambda text: text.encode("utf-16"),
    "utf-16-le": lambda text: text.encode("utf-16-le"),
    "utf-16-be with mark": lambda text: b"\xfe\xff" + text.encode("utf-16-be"),
}


def flat_tables() -> Iterator[Variant]:
    """Tables of plain colours."""
    for (code, encode), (separator, comma) in itertools.product(
        ENCODINGS.items(), ((",", False), (";", True), ("\t", False), (";", False), ("|", False))
    ):
        kinds: list[tuple[str, list[str], list[list[str]], tuple[Flat, ...]]] = [
            ("hex", ["name", "hex"], [["#{:02x}{:02X}{:02x}".format(*row)] for row in RGB], rgb_flat()),
            ("rgb", ["Name", "R", "G", "B"], [[str(v) for v in row] for row in RGB], rgb_flat()),
            (
                "lab",
                ["Color name", "L*", "a*", "b*"],
                [[decimal(v, comma) for v in row] for row in LAB],
                lab_flat(),
            ),
            ("cmyk", ["Farbname", "C", "M", "Y", "K"], [[str(v) for v in row] for row in CMYK], cmyk_flat()),
        ]
        for kind, heading, cells, flat in kinds:
            rows = [heading, *([name, *row] for name, row in zip(NAMES, cells, strict=True))]
            yield Variant(f"{kind} {code} {separator!r}", encode(delimited(rows, separator)), flat)
    plain = [[name, *map(str, row)] for name, row in zip(NAMES, RGB, strict=True)]
    yield Variant("no headings", delimited(plain, ",").encode(), rgb_flat())
    turned = [[*map(str, reversed(row)), name] for name, row in zip(NAMES, RGB, strict=True)]
    yield Variant(
        "b g r order", delimited([["Blue", "Green", "Red", "Title"], *turned], ",").encode(), rgb_flat()
    )
    words = [[name, "RGB({}, {}, {})".format(*row)] for name, row in zip(NAMES, RGB, strict=True)]
    yield Variant("rgb in one cell", delimited([["Swatch", "RGB"], *words], ",").encode(), rgb_flat())
    words = [[name, "/".join(map(str, row))] for name, row in zip(NAMES, CMYK, strict=True)]
    yield Variant("cmyk in one cell", delimited([["Name", "CMYK"], *words], ";").encode(), cmyk_flat())
    parts = [[name, *(f"{v}%" for v in row)] for name, row in zip(NAMES, CMYK, strict=True)]
    heading = ["name", "cyan", "magenta", "yellow", "black"]
    yield Variant("percent signs", delimited([heading, *parts], ",").encode(), cmyk_flat())
    unit = [[name, *(f"{v / 100:g}" for v in row)] for name, row in zip(NAMES, CMYK, strict=True)]
    yield Variant("cmyk to 1", delimited([["name", "C", "M", "Y", "K"], *unit], ",").encode(), cmyk_flat())
    unit = [[name, *(repr(v / 255) for v in row)] for name, row in zip(NAMES, RGB, strict=True)]
    yield Variant("rgb to 1", delimited([["name", "R", "G", "B"], *unit], "\t").encode(), rgb_flat())
    both = [
        [*map(str, row), name, "#{:02x}{:02x}{:02x}".format(*row)]
        for name, row in zip(NAMES, RGB, strict=True)
    ]
    yield Variant("rgb and hex", delimited([["R", "G", "B", "name", "HEX"], *both], ",").encode(), rgb_flat())
    bare = [["{:02x}{:02x}{:02x}".format(*row), name] for name, row in zip(NAMES, RGB, strict=True)]
    yield Variant("bare hex", delimited([["Hex code", "Colour"], *bare], ",").encode(), rgb_flat())
    for heading, form in (
        ("hex", "#FF{:02x}{:02x}{:02x}"),
        ("Hex", "#{:02x}{:02x}{:02x}ff"),
        ("ARGB", "80{:02x}{:02x}{:02x}"),
        ("RGBA", "#{:02x}{:02x}{:02x}80"),
    ):
        rows = [[name, form.format(*row)] for name, row in zip(NAMES, RGB, strict=True)]
        yield Variant(form, delimited([["Name", heading], *rows], ",").encode(), rgb_flat())
    hexes = ["#{:02x}{:02x}{:02x}".format(*row) for row in RGB]
    for heading in ("Hex Color", "Hex Triplet", "Color code", "Colour code", "HTML hex", "Farbcode"):
        rows = [[name, code] for name, code in zip(NAMES, hexes, strict=True)]
        yield Variant(heading, delimited([["Name", heading], *rows], ",").encode(), rgb_flat())
    for heading in ("Color", "CSS"):
        rows = [[name, "rgb({}, {}, {})".format(*row)] for name, row in zip(NAMES, RGB, strict=True)]
        yield Variant(f"functions {heading}", delimited([["Name", heading], *rows], ",").encode(), rgb_flat())
    for channels in (
        "Red (RGB),Green (RGB),Blue (RGB)", "R value,G value,B value", "r-value,g-value,b-value", "Rouge,Vert,Bleu",
        "color_r,color_g,color_b", "Rosso,Verde,Blu", "Rojo,Verde,Azul",
    ):  # fmt: skip
        yield Variant(channels, delimited([["Name", *channels.split(",")], *plain], ",").encode(), rgb_flat())
    rows = [[name, code] for name, code in zip(NAMES, ("d40", "04f", "123", "777"), strict=True)]
    flat = tuple(
        (name, "RGB", tuple(int(2 * digit, 16) / 255.0 for digit in code))
        for name, (_, code) in zip(NAMES, rows, strict=True)
    )
    yield Variant("three digits", delimited([["name", "hex"], *rows], ",").encode(), flat)
    quoted = ('Red "hot"', '"Hot" red', "a", "b")
    rows = [[name, code] for name, code in zip(quoted, hexes, strict=True)]
    yield Variant("quotes", delimited([["name", "hex"], *rows], ",").encode(), rgb_flat(quoted))
    lch = [[name, "50", "20", "120.5"] for name in NAMES]
    flat = tuple((name, "LCh", (50.0, 20.0, 120.5)) for name in NAMES)
    yield Variant("lch", delimited([["name", "L", "C", "h"], *lch], ",").encode(), flat)
    hsl = [[name, "210", "50", "25"] for name in NAMES]
    flat = tuple((name, "HSL", (210.0, 0.5, 0.25)) for name in NAMES)
    yield Variant("hsl", delimited([["name", "Hue", "Saturation", "Lightness"], *hsl], ",").encode(), flat)
    shares = [[name, f"{210 / 360!r}", "0.5", "0.25"] for name in NAMES]
    flat = tuple((name, "HSL", (210.0, 0.5, 0.25)) for name in NAMES)
    yield Variant("hsl in shares", delimited([["name", "H", "S", "L"], *shares], ",").encode(), flat)
    red = [[name, "0.5°", "0.5", "0.25"] for name in NAMES]
    flat = tuple((name, "HSB", (0.5, 0.5, 0.25)) for name in NAMES)
    yield Variant("small hues in degrees", delimited([["name", "H", "S", "V"], *red], ",").encode(), flat)
    hsv = [[name, "210", "0.5", "0.25"] for name in NAMES]
    flat = tuple((name, "HSB", (210.0, 0.5, 0.25)) for name in NAMES)
    yield Variant("hsv", delimited([["name", "H", "S", "V"], *hsv], ",").encode(), flat)
    about = [["Palette of the season"], [], ["Name", "R", "G", "B"], *plain]
    yield Variant("title above", delimited(about, ",").encode(), rgb_flat())
    unit_row = [["Name", "L*", "a*", "b*"], ["", "-", "-", "-"]]
    rows = [[name, *map(str, row)] for name, row in zip(NAMES, LAB, strict=True)]
    yield Variant("row of units", delimited([*unit_row, *rows], ",").encode(), lab_flat())
    yield Variant(
        "sep= line", ("sep=;\r\n" + delimited([["Name", "R", "G", "B"], *plain], ";")).encode(), rgb_flat()
    )
    latin = [[name, *map(str, row)] for name, row in zip(("a", "Süd", "c", "d"), RGB, strict=True)]
    flat = rgb_flat(("a", "Süd", "c", "d"))
    yield Variant("windows-1252", delimited([["Name", "R", "G", "B"], *latin], ";").encode("cp1252"), flat)
    nm = [[name, *(f"{0.1 + 0.01 * i:g}" for i in range(31))] for name in NAMES]
    flat = tuple((name, "spectrum", tuple(float(f"{0.1 + 0.01 * i:g}") for i in range(31))) for name in NAMES)
    yield Variant(
        "spectra", delimited([["name", *(str(400 + 10 * i) for i in range(31))], *nm], ",").encode(), flat
    )
    nm = [[name, *(f"{10 + i:g}" for i in range(31))] for name in NAMES]
    flat = tuple((name, "spectrum", tuple((10 + i) / 100.0 for i in range(31))) for name in NAMES)
    heading = ["name", *(f"R{400 + 10 * i} nm [%]" for i in range(31))]
    yield Variant("spectra in per cent", delimited([heading, *nm], ";").encode(), flat)


def readings(seed: int, angles: tuple[int, ...] = ANGLES) -> Reading:
    """L*a*b* of a metallic at angles, light at 45°, with two decimals."""
    draw = random.Random(seed)
    base = draw.uniform(20.0, 60.0)
    return {
        (45.0, float(angle)): (
            round(base * (1.0 + 1.2 / (1.0 + (abs(angle - 5) / 20.0) ** 2)), 2),
            round(draw.uniform(-20.0, 20.0), 2),
            round(draw.uniform(-30.0, 30.0), 2),
        )
        for angle in angles
    }


SAMPLES = tuple((name, readings(i)) for i, name in enumerate(("Silver 1", "Blau Metallic", "藍 Xirallic")))
HEADINGS: dict[str, Callable[[str, int], str]] = {
    "L*-15": lambda letter, angle: f"{letter}*{angle}",
    "L15": lambda letter, angle: f"{letter}{angle}",
    "15 L": lambda letter, angle: f"{angle} {letter}",
    "L* (15°)": lambda letter, angle: f"{letter}* ({angle}°)",
    "15° L*": lambda letter, angle: f"{angle}° {letter}*",
    "45as15 L*": lambda letter, angle: f"45as{angle} {letter}*",
    "L* r45as15": lambda letter, angle: f"{letter}* r45as{angle}",
    "L*(D65/10) 45as15": lambda letter, angle: f"{letter}*(D65/10°) 45as{angle}",
    "L_15": lambda letter, angle: f"{letter}_{angle}",
    "CIE L 15°": lambda letter, angle: f"CIE {letter} {angle}°",
}


def wide(
    style: str, comma: bool, *, effects: bool = False, interleaved: bool = True, extra: bool = False
) -> list[list[str]]:
    """A row per sample; columns by angle, or by channel with the angles within it."""
    head = HEADINGS[style]
    order = (
        [(a, c) for a in ANGLES for c in range(3)]
        if interleaved
        else [(a, c) for c in range(3) for a in ANGLES]
    )
    rows = [["Sample name", *(head("Lab"[c], a) for a, c in order)]]
    rows[0] += ["Si 15°", "Sa 15°", "G"] if effects else []
    rows[0] += ["dE*15", "C*45", "Remark"] if extra else []
    for name, found in SAMPLES:
        row = [name, *(decimal(found[45.0, float(a)][c], comma) for a, c in order)]
        row += [decimal(4.25, comma), decimal(12.5, comma), decimal(3.75, comma)] if effects else []
        row += ["0.5", "20.1", "ok"] if extra else []
        rows.append(row)
    return rows


EFFECT_VALUES = {"sparkle intensity 15°": 4.25, "sparkle area 15°": 12.5, "graininess": 3.75}


def long(comma: bool, notation: str = "45as{}", *, once: bool = False) -> list[list[str]]:
    """A row per angle; the name in each row or in the first of a sample only."""
    rows = [["Standard name", "Geometry", "L*", "a*", "b*"]]
    for name, found in SAMPLES:
        for index, ((_, angle), lab) in enumerate(found.items()):
            shown = name if index == 0 or not once else ""
            rows.append([shown, notation.format(f"{angle:g}"), *(decimal(v, comma) for v in lab)])
    return rows


def blocks(comma: bool) -> list[list[str]]:
    """A block per sample: columns are angles, rows L*, a* and b*."""
    rows: list[list[str]] = [["Instrument", "Multi-angle"], ["Illuminant", "D65/10°"]]
    for name, found in SAMPLES:
        rows += [[], ["Name", name], ["Angle", *(f"{angle:g}°" for _, angle in found)]]
        for channel, word in enumerate(("L*", "a*", "b*")):
            rows.append([word, *(decimal(lab[channel], comma) for lab in found.values())])
    return rows


def instrument_tables() -> Iterator[Variant]:
    """Text exports of multi-angle instruments."""
    for style, (separator, comma) in itertools.product(HEADINGS, ((",", False), (";", True), ("\t", False))):
        text = delimited(wide(style, comma), separator)
        yield Variant(f"wide {style} {separator!r}", text.encode("utf-8-sig"), samples=SAMPLES)
    for style in ("L*-15", "15° L*", "45as15 L*"):
        rows = wide(style, False, effects=True, extra=True)
        yield Variant(
            f"effects {style}", delimited(rows, ";").encode(), samples=SAMPLES, effects=EFFECT_VALUES
        )
        rows = wide(style, True, interleaved=False)
        yield Variant(f"by channel {style}", delimited(rows, ";").encode("utf-16"), samples=SAMPLES)
    for notation, once, comma in itertools.product(
        ("45as{}", "r45as{}", "{}", "{}°"), (False, True), (False, True)
    ):
        text = delimited(long(comma, notation, once=once), ";" if comma else ",")
        yield Variant(f"long {notation} {once} {comma}", text.encode(), samples=SAMPLES)
    for separator, comma in ((";", True), ("\t", False), (",", False)):
        text = delimited(blocks(comma), separator)
        yield Variant(f"blocks {separator!r}", text.encode(), samples=SAMPLES)
    for line in (
        ["Job", "Season 25", "45"],
        ["D65", "10°"],
        ["Illuminant/Observer", "D65", "10°"],
        ["Day", "15", "25"],
    ):
        yield Variant(f"above: {line}", delimited([line, *long(True)], ";").encode(), samples=SAMPLES)
    upper = ["", *(x for a in ANGLES for x in (f"{a}°", "", ""))]
    lower = ["Name", *(letter for _ in ANGLES for letter in ("L*", "a*", "b*"))]
    rows = [upper, lower, *wide("L15", False)[1:]]
    yield Variant("two rows of headings", delimited(rows, ",").encode(), samples=SAMPLES)
    positive = tuple((name, {k: v for k, v in found.items() if k[1] > 0}) for name, found in SAMPLES)
    rows = [["name", *(f"{c}-{a:g}" for _, a in positive[0][1] for c in "Lab")]]
    rows += [[name, *(f"{v:g}" for lab in found.values() for v in lab)] for name, found in positive]
    yield Variant("hyphens before the angles", delimited(rows, ",").encode(), samples=positive)
    about = [["Instrument:", "MA"], ["Illuminant/Observer:", "D65/10"], ["Date:", "2026-01-31"]]
    yield Variant(
        "lines before", delimited([*about, *wide("45as15 L*", False)], ",").encode(), samples=SAMPLES
    )


def instrument_trees() -> Iterator[Variant]:
    """XML exports of multi-angle instruments, in habits of naming that elements have."""
    declarations = (
        '<?xml version="1.0" encoding="UTF-8"?>\n',
        '<?xml version="1.0" encoding="UTF-16"?>\n',
        "",
    )

    def encode(text: str, declaration: str) -> bytes:
        return (declaration + text).encode("utf-16" if "16" in declaration else "utf-8")

    def channels(lab: tuple[float, ...], style: str) -> str:
        if style == "elements":
            return "".join(f"<{c}>{v:g}</{c}>" for c, v in zip("Lab", lab, strict=True))
        if style == "attributes":
            return "<Lab {}/>".format(" ".join(f'{c}="{v:g}"' for c, v in zip("Lab", lab, strict=True)))
        return "".join(f"<CIE_{c}>{v:g}</CIE_{c}>" for c, v in zip("Lab", lab, strict=True))

    geometries: dict[str, Callable[[float, str], str]] = {
        "attribute": lambda a, inner: f'<Reading Geometry="45as{a:g}">{inner}</Reading>',
        "element": lambda a, inner: f"<Measurement><Angle>{a:g}</Angle>{inner}</Measurement>",
        "value": lambda a, inner: f'<Angle value="{a:g}">{inner}</Angle>',
        "name": lambda a, inner: f'<Geometry Name="r45as{a:g}">{inner}</Geometry>',
    }
    for (where, wrap), style, declaration, named in itertools.product(
        geometries.items(), ("elements", "attributes", "cie"), declarations, ("attribute", "element")
    ):
        body = ""
        for name, found in SAMPLES:
            inner = "".join(wrap(angle, channels(lab, style)) for (_, angle), lab in found.items())
            own = f" Name={quoteattr(name)}" if named == "attribute" else ""
            body += f"<Sample{own}>" + ("" if own else f"<Name>{name}</Name>") + inner + "</Sample>"
        text = f"<Measurements><Illuminant>D65</Illuminant><Observer>10</Observer>{body}</Measurements>"
        yield Variant(
            f"{where} {style} {declaration[30:36]} {named}", encode(text, declaration), samples=SAMPLES
        )
    for style in ("45as15 L*", "15° L*", "L15"):
        rows = wide(style, False)
        cells = [
            "".join(f'<Cell><Data ss:Type="String">{cell}</Data></Cell>' for cell in row) for row in rows
        ]
        text = "".join(f"<Row>{row}</Row>" for row in cells)
        sheet = (
            '<?xml version="1.0"?><Workbook xmlns="urn:schemas-microsoft-com:office:spreadsheet" '
            'xmlns:ss="urn:schemas-microsoft-com:office:spreadsheet"><Worksheet ss:Name="Data"><Table>'
            f"{text}</Table></Worksheet></Workbook>"
        )
        yield Variant(f"worksheet {style}", sheet.encode(), samples=SAMPLES)


class Device(NamedTuple):
    """A multi-angle instrument: what it measures, as it is generally described, and how an export may head it."""

    name: str
    geometries: tuple[tuple[int, int], ...]
    """Light and aspecular angle, in the plane of incidence."""
    outside: tuple[str, ...]
    """Geometries out of the plane, which a paint has no place for."""
    headings: tuple[Callable[[str, str, int], str], ...]
    """The heading of a channel, of a geometry's name and its aspecular angle."""
    effects: dict[str, tuple[str, float]]
    """Quantities by their headings: as the suite names them, and a value."""


_AT_45 = tuple((45, angle) for angle in ANGLES)
_SPARKLE = {
    f"{letter}{angle}": (f"sparkle {word} {angle}°", size + angle / 100)
    for angle in (15, 45, 75)
    for letter, word, size in (("Si", "intensity", 4.0), ("Sa", "area", 12.0))
}
DEVICES = (
    Device(
        "BYK-mac i",
        _AT_45,
        (),
        (
            lambda c, _, a: f"{c}*{a}",
            lambda c, _, a: f"{a}° {c}*",
            lambda c, _, a: f"{c}* ({a}°)",
            lambda c, _, a: f"{a} {c}",
        ),
        {**_SPARKLE, "G": ("graininess", 3.75)},
    ),
    Device(
        "MA-T6",
        _AT_45,
        (),
        (
            lambda c, g, _: f"{g} {c}*",
            lambda c, g, _: f"{c}* r{g}",
            lambda c, g, _: f"{c}_{g}",
            lambda c, g, _: f"{c}*(D65/10°) {g}",
        ),
        {"Sparkle Grade": ("sparkle grade", 5.5), "Coarseness": ("coarseness", 2.25)},
    ),
    Device(
        "MA-T12",
        (*_AT_45, *((15, angle) for angle in (-45, -15, 15, 45))),
        ("45as25az90", "45as25az-90"),
        (
            lambda c, g, _: f"{g} {c}*",
            lambda c, g, _: f"{c}* r{g}",
            lambda c, g, _: f"{c}_{g}",
            lambda c, g, _: f"{c}*(D65/10°) {g}",
        ),
        {"Sparkle Grade": ("sparkle grade", 5.5), "Diffuse coarseness": ("coarseness", 2.25)},
    ),
    Device(
        "CM-M6",
        _AT_45,
        (),
        (
            lambda c, _, a: f"{c}*(D65/10°) as{a}°",
            lambda c, _, a: f"as{a}° {c}*",
            lambda c, _, a: f"{c}* as {a}",
            lambda c, g, _: f"{c}*(D65) {g}",
        ),
        {},
    ),
)


def device_samples(device: Device) -> tuple[tuple[str, Reading], ...]:
    """What a device read of three paints."""
    found = []
    for seed, name in enumerate(("Silver 1", "Blau Metallic", "藍 Xirallic")):
        at_45 = readings(seed)
        at_15 = {
            (15.0, a): (round(0.9 * lab[0], 2), lab[1], lab[2])
            for (_, a), lab in readings(seed + 10, (-45, -15, 15, 45)).items()
        }
        whole = {**at_45, **at_15}
        found.append((name, {(float(light), float(a)): whole[light, a] for light, a in device.geometries}))
    return tuple(found)


def device_tables(device: Device) -> Iterator[Variant]:
    """Text exports of one instrument: a row for a sample, or a row for a geometry."""
    samples = device_samples(device)
    effects = dict(device.effects.values())
    names = [*(f"{light}as{a}" for light, a in device.geometries), *device.outside]
    places = [*(a for _, a in device.geometries), *(25 for _ in device.outside)]
    about = [["Instrument:", device.name], ["Illuminant/Observer:", "D65/10"], []]

    def cells(found: Reading, comma: bool) -> list[list[str]]:
        rows = [*found.values(), *((30.0, 1.0, 2.0) for _ in device.outside)]
        return [[decimal(v, comma) for v in lab] for lab in rows]

    for (number, head), (separator, comma), with_effects, by_channel in itertools.product(
        enumerate(device.headings), ((";", True), ("\t", False), (",", False)), (False, True), (False, True)
    ):
        places_of = [(i, c) for i in range(len(names)) for c in range(3)]
        if by_channel:
            places_of.sort(key=lambda place: place[1])
        rows = [["Sample name", "Date", *(head("Lab"[c], names[i], places[i]) for i, c in places_of)]]
        rows[0] += list(device.effects) if with_effects else []
        for name, found in samples:
            texts = cells(found, comma)
            row = [name, "2026-01-31", *(texts[i][c] for i, c in places_of)]
            row += [decimal(value, comma) for _, value in device.effects.values()] if with_effects else []
            rows.append(row)
        text = delimited([*about, *rows] if number % 2 else rows, separator)
        yield Variant(
            f"{device.name} wide {number} {separator!r} {with_effects} {by_channel}",
            text.encode("utf-16" if separator == "\t" else "utf-8-sig"),
            samples=samples,
            effects=effects if with_effects else None,
        )
    for heading, comma in itertools.product(("Geometry", "Angle", "Winkel"), (False, True)):
        rows = [["Sample", "Instrument", heading, "L*", "a*", "b*"]]
        for name, found in samples:
            for at, row in zip(names, cells(found, comma), strict=True):
                rows.append([name, device.name, at, *row])
        text = delimited(rows, ";" if comma else ",")
        yield Variant(f"{device.name} long {heading} {comma}", text.encode(), samples=samples)


def device_trees(device: Device) -> Iterator[Variant]:
    """XML exports of one instrument."""
    samples = device_samples(device)
    words = {"Sparkle Grade": "SparkleGrade", "Diffuse coarseness": "Coarseness", "G": "Graininess"}
    wraps: tuple[Callable[[str, str], str], ...] = (
        lambda at, inner: f'<Reading Geometry="{at}">{inner}</Reading>',
        lambda at, inner: f"<Measurement><Geometry>{at}</Geometry>{inner}</Measurement>",
        lambda at, inner: f'<Angle Name="{at}">{inner}</Angle>',
    )
    for wrap, as_attributes, with_effects, declared in itertools.product(
        wraps, (False, True), (False, True), ("", '<?xml version="1.0" encoding="utf-8"?>\n')
    ):
        body = ""
        for name, found in samples:
            at_all = {f"{light:g}as{a:g}": lab for (light, a), lab in found.items()}
            at_all |= dict.fromkeys(device.outside, (30.0, 1.0, 2.0))
            inner = ""
            for at, lab in at_all.items():
                parts = list(zip("Lab", lab, strict=True))
                plain = "".join(f"<{c}>{v:g}</{c}>" for c, v in parts)
                keys = " ".join(f'{c}="{v:g}"' for c, v in parts)
                inner += wrap(at, f"<Lab {keys}/>" if as_attributes else plain)
            if with_effects:
                inner += "".join(
                    f"<{words.get(key, key)}>{value:g}</{words.get(key, key)}>"
                    for key, (_, value) in device.effects.items()
                )
            body += f"<Sample Name={quoteattr(name)}>{inner}</Sample>"
        text = (
            f'{declared}<Export Device="{device.name}"><Illuminant>D65</Illuminant><Observer>10</Observer>'
            f"{body}</Export>"
        )
        effects = dict(device.effects.values()) if with_effects else None
        label = f"{device.name} {wraps.index(wrap)} {as_attributes} {with_effects} {bool(declared)}"
        yield Variant(label, text.encode(), samples=samples, effects=effects)


def paint_net() -> Iterator[Variant]:
    """Palettes of paint.net: comments behind a semicolon, and codes of eight digits, opacity first."""
    heads = {
        "full": "; paint.net Palette File\n; Lines that start with a semicolon are comments\n; Colors: 4\n",
        "named": "; Palette Name: Season\n; Description: of 2026\n; Colors: 4\n",
        "short": ";\n",
        "old": "; Paint.NET Palette File\n;\n; a\n\n",
    }
    for (title, head), upper, newline, code in itertools.product(
        heads.items(), (True, False), ("\r\n", "\n"), ("utf-8", "utf-8-sig", "utf-16")
    ):
        codes = ["ff{:02x}{:02x}{:02x}".format(*row) for row in RGB]
        text = head + "\n".join(one.upper() if upper else one for one in codes) + "\n"
        content = text.replace("\n", newline).encode(code)
        yield Variant(f"{title} {upper} {newline!r} {code}", content, rgb_flat(("", "", "", "")))
    clear = head + "\n".join("{:02x}{:02x}{:02x}{:02x}".format(64 * i, *row) for i, row in enumerate(RGB))
    yield Variant("see-through", clear.encode(), rgb_flat(("", "", "", "")))


def hex_lists() -> Iterator[Variant]:
    """Lists of hex codes."""
    codes = ["{:02x}{:02x}{:02x}".format(*row) for row in RGB]
    nameless = rgb_flat(("", "", "", ""))
    for mark, upper, newline in itertools.product(("#", "", "0x"), (False, True), ("\n", "\r\n", "\r")):
        lines = [mark + (code.upper() if upper else code) for code in codes]
        yield Variant(f"{mark} {upper} {newline!r}", (newline.join(lines) + newline).encode(), nameless)
    for form in ("#{0} {1}", "{1}: #{0}", "{1} #{0}", "#{0} - {1}", "{1} = #{0};"):
        text = "\n".join(form.format(code, name) for code, name in zip(codes, NAMES, strict=True))
        yield Variant(form, text.encode("utf-8-sig"), rgb_flat())
    head = "; paint.net Palette File\n; Palette Name: Season\n; Colors: 4\n"
    yield Variant("paint.net", (head + "\n".join(f"FF{code.upper()}" for code in codes)).encode(), nameless)
    numbers = ("100020", "100120", "100220", "100320")
    for form in ("{0} {1}", "{0} #{1}", "{0} - {1}"):
        text = "\n".join(form.format(number, code) for number, code in zip(numbers, codes, strict=True))
        yield Variant(f"numbers {form}", text.encode(), rgb_flat(numbers))
    yield Variant("argb", "\n".join(f"ff{code}" for code in codes).encode(), nameless)
    yield Variant("rgba", "\n".join(f"#{code}ff" for code in codes).encode(), nameless)
    yield Variant("one line", ", ".join(f"#{code}" for code in codes).encode(), nameless)
    yield Variant("utf-16", "\n".join(f"#{code}" for code in codes).encode("utf-16"), nameless)
    yield Variant(
        "comments", ("// season\n# of 2026\n" + "\n".join(f"#{c}" for c in codes)).encode(), nameless
    )


def corel_xml() -> Iterator[Variant]:
    """CorelDRAW's XML, X5 and later."""
    for model, prefix, localized, pages in itertools.product(
        ("RGB", "CMYK", "LAB"),
        ('<?xml version="1.0" encoding="utf-8"?>\n', "", "\ufeff"),
        (False, True),
        (1, 2),
    ):
        rows, texts = [], []
        for index, name in enumerate(NAMES):
            if model == "RGB":
                tints = [value / 255 for value in RGB[index]]
            elif model == "CMYK":
                tints = [value / 100 for value in CMYK[index]]
            else:
                lightness, a, b = LAB[index]
                tints = [lightness / 100, (a + 128) / 255, (b + 128) / 255]
            own = f'resid="{1000 + index}"' if localized else f"name={quoteattr(name)}"
            texts.append(f'<resource id="{1000 + index}"><EN>{name}</EN><DE>x</DE></resource>')
            rows.append(f'<color cs="{model}" tints="{",".join(map(repr, tints))}" {own}/>')
        step = len(rows) // pages
        inner = "".join(f"<page>{''.join(rows[i * step : (i + 1) * step])}</page>" for i in range(pages))
        words = f"<localization>{''.join(texts)}</localization>" if localized else ""
        text = (
            f'{prefix}<palette name="Season" guid="x"><colorspaces/><colors>{inner}</colors>{words}</palette>'
        )
        flat = {"RGB": rgb_flat(), "CMYK": cmyk_flat(), "LAB": lab_flat()}[model]
        yield Variant(f"{model} {prefix!r} {localized} {pages}", text.encode(), flat)
    inks = "".join(
        f'<cs name={quoteattr(name)} fixedID="{i}"><color cs="CMYK" tints="0,1,1,0"/>'
        f'<color cs="RGB" tints="{",".join(str(v / 255) for v in row)}"/></cs>'
        for i, (name, row) in enumerate(zip(NAMES, RGB, strict=True))
    )
    page = "".join(f'<color cs={quoteattr(name)} tints="1"/>' for name in NAMES)
    rows = "".join(f'<color cs="HLS" tints="0.75,0.25,0.5" name={quoteattr(name)}/>' for name in NAMES)
    text = f'<palette name="Season"><colorspaces/><colors><page>{rows}</page></colors></palette>'
    flat = tuple((name, "HSL", (270.0, 0.5, 0.25)) for name in NAMES)
    yield Variant("HLS", text.encode(), flat)
    text = f'<palette name="Inks"><colorspaces>{inks}</colorspaces><colors><page>{page}</page></colors></palette>'
    yield Variant("inks", text.encode(), rgb_flat())


def cpl() -> Iterator[Variant]:
    """CorelDRAW's binary palettes of all kinds."""

    def name_of(text: str, wide_: bool) -> bytes:
        return bytes([len(text)]) + text.encode("utf-16-le" if wide_ else "latin-1")

    def colour(model: str, index: int) -> bytes:
        if model == "RGB":
            red, green, blue = RGB[index]
            return struct.pack("<H6x4B", 5, blue, green, red, 0)
        if model == "CMYK":
            return struct.pack("<H6x4B", 2, *CMYK[index])
        lightness, a, b = map(round, (LAB[index][0] * 2.55, *LAB[index][1:]))
        return struct.pack("<H6x4B", 18, lightness, a + 128, b + 128, 0)

    narrow = ("Rosso", "Süd Blau", "c 0815", "Grau 7")
    kinds = (b"\xcc\xdc", b"\xcc\xbc", b"\xdc\xdc", b"\xcd\xdc", b"\xcd\xbc", b"\xdd\xdc", b"\xcd\xdd")
    for kind, model in itertools.product(kinds, ("RGB", "CMYK", "Lab")):
        wide_ = kind in (b"\xcc\xbc", b"\xcd\xbc", b"\xdd\xdc", b"\xcd\xdd")
        names = NAMES if wide_ else narrow
        for inked in (False, True) if kind in (b"\xcd\xbc", b"\xcd\xdc", b"\xcd\xdd") else (False,):
            rows = b""
            for index, name in enumerate(names):
                record = colour(model, index)
                rows += (struct.pack("<I", 100 + index) + record + record if inked else record) + name_of(
                    name, wide_
                )
                rows += struct.pack("<3I", index, 0, 0) if kind == b"\xcd\xdd" else b""
            count = struct.pack("<H", len(names))
            if kind[:1] == b"\xcc":
                content = kind + count + rows
            elif kind == b"\xdc\xdc":
                content = kind + name_of("Season", False) + count + rows
            else:
                title = name_of("Season", wide_)
                start = 2 + 4 + 3 * 8
                second = start + len(title)
                head = struct.pack("<7I", 3, 0, start, 1, second, 2, second + 2)
                content = kind + head + title + struct.pack("<H", 3 if inked else 5) + count + rows
            flat = {
                "RGB": rgb_flat(names),
                "CMYK": cmyk_flat(names),
                "Lab": tuple(
                    (n, "Lab", (round(L * 2.55) / 2.55, float(round(a)), float(round(b))))
                    for n, (L, a, b) in zip(names, LAB, strict=True)
                ),
            }[model]
            yield Variant(f"{kind.hex()} {model} {inked}", content, flat)


def autocad() -> Iterator[Variant]:
    """AutoCAD's colour books."""
    for prefix, pages, versioned, space in itertools.product(
        ('<?xml version="1.0" encoding="UTF-8"?>\n', "\ufeff", ""), (1, 2, 4), (False, True), ("", "\n  ")
    ):
        entries = [
            f"<colorEntry>{space}<colorName>{name}</colorName>{space}<RGB8><red>{r}</red><green>{g}</green>"
            f"<blue>{b}</blue></RGB8></colorEntry>{space}"
            for name, (r, g, b) in zip(NAMES, RGB, strict=True)
        ]
        step = len(entries) // pages
        page = "<pageColor><RGB8><red>1</red><green>2</green><blue>3</blue></RGB8></pageColor>"
        shown = ["".join(entries[i * step : (i + 1) * step]) for i in range(pages)]
        inner = "".join(f"<colorPage>{page}{one}</colorPage>" for one in shown)
        number = "<majorVersion>1</majorVersion><minorVersion>0</minorVersion>" if versioned else ""
        text = f"{prefix}<colorBook><bookName>Season</bookName>{number}{inner}</colorBook>"
        yield Variant(f"{prefix!r} {pages} {versioned} {space!r}", text.encode(), rgb_flat())


def sketch() -> Iterator[Variant]:
    """Palettes of Sketch."""
    for named, alpha, indent, extra in itertools.product(
        (False, True), (False, True), (None, 2), (False, True)
    ):
        colours = []
        for name, row in zip(NAMES, RGB, strict=True):
            channels = zip(("red", "green", "blue"), (v / 255 for v in row), strict=True)
            item = {**({"name": name} if named else {}), **dict(channels)}
            colours.append({**item, **({"alpha": 1} if alpha else {})})
        document = {"compatibleVersion": "2.0", "pluginVersion": "2.22", "colors": colours}
        document |= {"gradients": [], "images": []} if extra else {}
        flat = rgb_flat() if named else rgb_flat(("", "", "", ""))
        for ascii_ in (True, False):
            text = json.dumps(document, indent=indent, ensure_ascii=ascii_)
            yield Variant(f"{named} {alpha} {indent} {extra} {ascii_}", text.encode(), flat)
    nameless = rgb_flat(("", "", "", ""))
    texts = [dict(zip(("red", "green", "blue"), (repr(v / 255) for v in row), strict=True)) for row in RGB]
    for version, old in (
        ("1.0", ["#{:02X}{:02x}{:02x}".format(*row) for row in RGB]),
        ("1.3", ["#{:02x}{:02x}{:02x}FF".format(*row) for row in RGB]),
        ("1.4", [{**item, "alpha": "1"} for item in texts]),
    ):
        document = {"compatibleVersion": version, "pluginVersion": version, "colors": old}
        yield Variant(f"old {version}", json.dumps(document).encode(), nameless)


def apple() -> Iterator[Variant]:
    """Colour lists of macOS."""
    spaces = ("generic", "srgb id", "profile", "white", "cmyk")
    for space, alpha, nested, order in itertools.product(spaces, (False, True), (False, True), (0, 1)):
        objects: list[object] = ["$null"]

        def put(item: object, objects: list[object] = objects) -> plistlib.UID:
            objects.append(item)
            return plistlib.UID(len(objects) - 1)

        names = put({"NS.objects": [put(name) for name in NAMES]})
        custom = None
        if space == "srgb id":
            custom = put({"NSID": 7})
        elif space == "profile":
            profile = bytes(16) + b"RGB XYZ " + bytes(16) + b"sRGB IEC61966-2.1"
            custom = put({"NSICC": put({"NS.data": profile})})
        colours = []
        for index, row in enumerate(RGB):
            text = " ".join(f"{v / 255:.10g}" for v in row) + (" 1" if alpha else "")
            item: dict[str, object]
            if space == "white":
                item = {"NSColorSpace": 3, "NSWhite": b"0.25" + (b" 1" if alpha else b"")}
            elif space == "cmyk":
                inks = " ".join(f"{v / 100:g}" for v in CMYK[index]) + (" 1" if alpha else "")
                item = {"NSColorSpace": 5, "NSCMYK": inks.encode()}
            else:
                item = {"NSColorSpace": 1, "NSRGB": text.encode() + b"\0"}
            if custom is not None:
                item |= {"NSComponents": text.encode(), "NSCustomColorSpace": custom, "NSRGB": b"0 0 0\0"}
            colours.append(put(item))
        whole = {"NSColors": put({"NS.objects": colours}), "NSKeys": names}
        top = {"root": put(whole)} if nested else whole
        archive = {"$version": 100000, "$archiver": "NSKeyedArchiver", "$top": top, "$objects": objects}
        content = plistlib.dumps(archive, fmt=plistlib.FMT_BINARY, sort_keys=bool(order))
        flat = rgb_flat()
        if space == "white":
            flat = tuple((name, "Gray", (0.25,)) for name in NAMES)
        elif space == "cmyk":
            flat = cmyk_flat()
        yield Variant(f"{space} {alpha} {nested} {order}", content, flat)


def scss() -> Iterator[Variant]:
    """Variables and maps in SCSS, Sass and LESS."""
    names = ("rosso", "sued-blau", "night_7", "grey")
    values = {
        "hex": ["#{:02x}{:02x}{:02x}".format(*row) for row in RGB],
        "rgb": ["rgb({}, {}, {})".format(*row) for row in RGB],
        "rgba": ["rgba({}, {}, {}, 1)".format(*row) for row in RGB],
    }
    ends = (";", " !default;")
    for mark, (kind, shown), end, comments in itertools.product(
        ("$", "@"), values.items(), ends, (False, True)
    ):
        note = "/* season; $x: #111; */\n// @y: #222;\n" if comments else ""
        lines = [f"{mark}{name}: {value}{end}" for name, value in zip(names, shown, strict=True)]
        yield Variant(
            f"{mark} {kind} {end} {comments}", (note + "\n".join(lines) + "\n").encode(), rgb_flat(names)
        )
    for quote, trailing in itertools.product(("", '"', "'"), (False, True)):
        inner = ",\n  ".join(f"{quote}{n}{quote}: {v}" for n, v in zip(names, values["hex"], strict=True))
        text = f"$map: (\n  {inner}{',' if trailing else ''}\n);\n"
        yield Variant(f"map {quote} {trailing}", text.encode(), rgb_flat(names))
    numbered = rgb_flat(("1", "2", "3", "4"))
    for kind, shown in values.items():
        pairs = list(zip(names, shown, strict=True))
        for newline in ("\n", "\r\n"):
            lines = newline.join(f"${name}: {value}" for name, value in pairs) + newline
            yield Variant(f"indented {kind} {newline!r}", lines.encode(), rgb_flat(names))
            body = newline.join(f"  {name}: {value};" for name, value in pairs)
            text = f"@colors: {{{newline}{body}{newline}}}{newline}"
            yield Variant(f"LESS map {kind} {newline!r}", text.encode(), rgb_flat(names))
        for separator, (before, after) in itertools.product((", ", " "), (("", ""), ("(", ")"))):
            text = f"$palette: {before}{separator.join(shown)}{after};\n"
            yield Variant(f"list {kind} {separator!r} {before}", text.encode(), numbered)
    again = "".join(f"$x: {value};\n${name}: $x;\n" for name, value in zip(names, values["hex"], strict=True))
    flat = tuple(one for name, *rest in rgb_flat(names) for one in (("x", *rest), (name, *rest)))
    yield Variant("SCSS set again", again.encode(), flat)
    unset = "".join(f"${name}: {value};\n${name}: red !default;\n" for name, value in pairs)
    yield Variant("SCSS default", unset.encode(), rgb_flat(names))
    later = "".join(f"@{name}: @x-{name};\n@x-{name}: red;\n" for name in names)
    later += "".join(f"@x-{name}: {value};\n" for name, value in pairs)
    flat = (*rgb_flat(names), *rgb_flat(tuple(f"x-{name}" for name in names)))
    yield Variant("LESS set again", later.encode(), flat)
    shared = "".join(
        f".a {{\n${name}: {value} !global; }}\n.b {{ $x-{name}: ${name}; }}\n" for name, value in pairs
    )
    flat = tuple(one for name, *rest in rgb_flat(names) for one in ((name, *rest), (f"x-{name}", *rest)))
    yield Variant("SCSS global", shared.encode(), flat)
    lines = "\n+big\n".join(f"${name}: {value}" for name, value in pairs)
    marks = "/* ; { */\n// ;\n$font: 'a; b'\n$image: url(data:image/png;base64,aGk=)\n"
    yield Variant("Sass with marks in texts", (marks + lines).encode(), rgb_flat(names))
    block = "\n".join(f".a {{ $other: red; color: red; ${name}: {value}; }}" for name, value in pairs)
    flat = tuple(one for entry in rgb_flat(names) for one in (("other", "RGB", (1.0, 0.0, 0.0)), entry))
    yield Variant("within rules", f"{block}\n".encode(), flat)


def scribus() -> Iterator[Variant]:
    """Colours of Scribus, old and new, with its defaults left out."""
    prefixes = ('<?xml version="1.0" encoding="UTF-8"?>\n', "")
    kinds = ("rgb hex", "cmyk hex", "space cmyk", "space rgb", "space lab")

    def of_space(space: str, keys: str, row: tuple[float, ...]) -> str:
        return f'SPACE="{space}" ' + " ".join(f'{c}="{v}"' for c, v in zip(keys, row, strict=True) if v)

    bytes_of = [tuple(round(v * 2.55) for v in row) for row in CMYK]
    for prefix, kind, flags in itertools.product(prefixes, kinds, (False, True)):
        rows = []
        for index, name in enumerate(NAMES):
            keys = {
                "rgb hex": 'RGB="#{:02x}{:02x}{:02x}"'.format(*RGB[index]),
                "cmyk hex": 'CMYK="#{:02x}{:02x}{:02x}{:02x}"'.format(*bytes_of[index]),
                "space cmyk": of_space("CMYK", "CMYK", CMYK[index]),
                "space rgb": of_space("RGB", "RGB", RGB[index]),
                "space lab": of_space("Lab", "LAB", LAB[index]),
            }[kind]
            more = ' Spot="1" Register="0"' if flags else ""
            rows.append(f"<COLOR NAME={quoteattr(name)} {keys}{more}/>")
        in_bytes = tuple(
            (n, "CMYK", tuple(v / 255 for v in row)) for n, row in zip(NAMES, bytes_of, strict=True)
        )
        flat = {"cmyk hex": in_bytes, "space cmyk": cmyk_flat(), "space lab": lab_flat()}.get(
            kind, rgb_flat()
        )
        text = f'{prefix}<SCRIBUSCOLORS Name="Season">\n{"".join(rows)}</SCRIBUSCOLORS>'
        yield Variant(f"{prefix[:5]} {kind} {flags}", text.encode(), flat)
    unknown = '<COLOR NAME="n"/><COLOR NAME="m" SPACE="Munsell" H="1"/>'
    for space in ("cmyk", "Cmyk"):
        rows = [
            f"<COLOR NAME={quoteattr(name)} {of_space(space, 'CMYK', row)}/>"
            for name, row in zip(NAMES, CMYK, strict=True)
        ]
        text = f'<SCRIBUSCOLORS Name="Season">{unknown}{"".join(rows)}</SCRIBUSCOLORS>'
        yield Variant(f"{space} beside unknown", text.encode(), cmyk_flat())


def cxf() -> Iterator[Variant]:
    """CxF3 of multi-angle instruments: prefixes, shapes of specifications, further and damaged parts."""
    for prefix, shared, damaged, custom, twice in itertools.product(("", "cc:"), *[(False, True)] * 4):

        def tag(name: str, inner: str, attributes: str = "", p: str = prefix) -> str:
            return f"<{p}{name} {attributes}>{inner}</{p}{name}>"

        def angle(a: float, tag: Callable[..., str] = tag) -> str:
            inner = tag("IlluminationAngle", "45") + tag("Aspecular", f"{a:g}")
            return tag("BRDFAngle", inner, f'Notation="45as{a:g}"')

        def specification(identity: str, inner: str, tag: Callable[..., str] = tag) -> str:
            light = tag("TristimulusSpec", tag("Illuminant", "D65") + tag("Observer", "10_Degree"))
            geometry = tag("MeasurementSpec", tag("GeometryChoice", tag("MultiAngle", inner)))
            return tag("ColorSpecification", light + geometry, f'Id="{identity}"')

        def which(a: float, shared: bool = shared) -> str:
            identity = "all" if shared else f"s{a:g}".replace("-", "m")
            return f'Name="45as{a:g}" ColorSpecification="{identity}"'

        objects = ""
        for number, (name, found) in enumerate(SAMPLES):
            values = ""
            for (_, a), lab in found.items():
                for shift in (-0.1, 0.1) if twice else (0.0,):
                    three = zip("LAB", (lab[0] + shift, *lab[1:]), strict=True)
                    values += tag("ColorCIELab", "".join(tag(c, repr(v)) for c, v in three), which(a))
                if custom:
                    points = "".join(tag("SpectralPoint", "0.5", f'WL="{400 + 25 * i}"') for i in range(13))
                    values += tag("CustomSpectrum", points, which(a))
            if damaged:
                values += tag("ReflectanceSpectrum", "0.5", which(15))
            effects = tag("TagCollection", tag("Tag", "", 'Name="Graininess" Value="3.75"'), 'Name="Texture"')
            about = f'ObjectType="Standard" Name={quoteattr(name)} Id="o{number}"'
            objects += tag("Object", tag("ColorValues", values) + effects, about)
        specs = "".join(specification(f"s{a:g}".replace("-", "m"), angle(a)) for a in ANGLES)
        if shared:
            specs = specification("all", "".join(angle(a) for a in ANGLES))
        inner = tag("ObjectCollection", objects) + tag("ColorSpecificationCollection", specs)
        space = f'xmlns{":cc" if prefix else ""}="http://colorexchangeformat.com/CxF3-core"'
        text = '<?xml version="1.0" encoding="UTF-8"?>\n' + tag("CxF", tag("Resources", inner), space)
        label = f"{prefix} {shared} {damaged} {custom} {twice}"
        yield Variant(label, text.encode(), samples=SAMPLES, effects={"graininess": 3.75})


WRITERS: dict[str, tuple[str, Callable[[], Iterator[Variant]]]] = {
    "plain tables": ("table", flat_tables),
    "instruments' tables": ("table", instrument_tables),
    "instruments' XML": ("instrument", instrument_trees),
    **{f"{one.name}, tables": ("table", partial(device_tables, one)) for one in DEVICES},
    **{f"{one.name}, XML": ("instrument", partial(device_trees, one)) for one in DEVICES},
    "CxF3 of instruments": ("cxf", cxf),
    "paint.net": ("hex", paint_net),
    "hex lists": ("hex", hex_lists),
    "CorelDRAW XML": ("corel", corel_xml),
    "CorelDRAW CPL": ("cpl", cpl),
    "AutoCAD": ("autocad", autocad),
    "Sketch": ("sketch", sketch),
    "Apple": ("clr", apple),
    "SCSS and LESS": ("scss", scss),
    "Scribus": ("scribus", scribus),
}
"""By a title: the format's name in the registry, and its variants."""
