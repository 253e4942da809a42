"""Conversion of entries for flat-colour formats: colour models, one angle of a paint, exact decimal text."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from decimal import Context, Decimal
from functools import lru_cache
from itertools import takewhile

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.appearance.colour.colorimetry import (
    WORKING_TO_XYZ,
    lab_to_working,
    working_to_display,
    xyz_to_lab,
)
from brdf_suite.appearance.colour.flat_colours import WHITES, decode_rgb, flat_labs, is_of_other_space
from brdf_suite.appearance.colour.spaces import adapt_xyz, working_to_xyz
from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Lab, Paint
from brdf_suite.documents.palette import Entry, Group, GroupPath, Palette, new_id

_WITH_WHITE = ("Lab", "LCh", "XYZ")
FACE_DEG = 45.0
"""The aspecular angle of the one colour that represents a paint."""


MAIN_DEG = (15.0, 45.0, 110.0)
"""The aspecular angles that show a paint's flop."""


def face_lab(paint: Paint | CookTorrancePaint | FactoredPaint) -> Lab:
    """Return a paint's L*a*b* (D65, 10°) at 45° from the mirror direction; see :func:`lab_at`."""
    return lab_at(paint, FACE_DEG)


def split_angles(palette: Palette) -> Palette:
    """Return a palette in which each paint is three flat colours: those at 15, 45 and 110° (D65, 10°).

    They stand in the paint's place, called after it with the angle; flat colours stay as they are.
    """
    entries: list[Entry] = []
    for entry in palette:
        content = entry.content
        if isinstance(content, FlatColour):
            entries.append(entry)
            continue
        for angle in MAIN_DEG:
            name, lab = f"{content.name} {angle:g}°", lab_at(content, angle)
            flat = FlatColour(name, "Lab", lab, illuminant="D65", observer_deg=10)
            entries.append(replace(entry, content=flat, id=new_id()))
    return replace(palette, entries=tuple(entries))


def lab_at(paint: Paint | CookTorrancePaint | FactoredPaint, aspecular_deg: float) -> Lab:
    """Return a paint's L*a*b* (D65, 10°) at an aspecular angle, under the light of most of its readings.

    Between two readings it lies on the line between them; beyond the last it is the last. A paint of another
    kind is read by the virtual instrument.
    """
    read = as_readings(paint)
    light = read.main_light_deg
    rows = sorted((m.aspecular_deg, m.lab) for m in read.measurements if m.illumination_deg == light)
    angles = [angle for angle, _ in rows]
    lightness, a, b = (float(np.interp(aspecular_deg, angles, [lab[i] for _, lab in rows])) for i in range(3))
    return lightness, a, b


def as_readings(paint: Paint | CookTorrancePaint | FactoredPaint) -> Paint:
    """Return a paint as readings; one of another kind is read by the virtual instruments at six angles.

    Raises :class:`SuiteError`: what is read of it is beyond a paint's range.
    """
    return paint if isinstance(paint, Paint) else _measured(paint)


@lru_cache(maxsize=4096)
def _measured(paint: CookTorrancePaint | FactoredPaint) -> Paint:
    # The instruments load the whole of reflectance, which palettes of flat colours never need.
    from brdf_suite.files.exports.format import paint_of_report
    from brdf_suite.reflectance.designed.build import build_reflectance
    from brdf_suite.reflectance.instruments.spectrophotometer import measure

    found = measure(build_reflectance(paint))
    return paint_of_report(found, paint.name, paint.source, paint.flakes, paint.notes)


def convert_to_flat(entry: Entry, models: Collection[str]) -> FlatColour:
    """Return an entry as a flat colour in one of ``models``, its own numbers where that can be.

    ``models`` must have Lab (which is written as that of D50 and 2°) or RGB (sRGB, not clipped).
    """
    content = entry.content
    if isinstance(content, FlatColour):
        for own in (content, *content.others):
            if own.model in models and (own.model not in _WITH_WHITE or is_icc(own)):
                return own if own is content else replace(own, name=content.name)
        encoded = decode_rgb(content)
        if encoded is not None and "RGB" in models:
            space = content.space if content.model in ("RGB", "HSB", "HSL") else ""
            return FlatColour(content.name, "RGB", encoded, space)
        lab: Lab = tuple(flat_labs([content])[0].tolist())
    else:
        lab = face_lab(content)
    if "Lab" in models:
        return FlatColour(content.name, "Lab", lab_d50(lab), "", "D50", 2)
    red, green, blue = working_to_display(lab_to_working(lab)).tolist()
    return FlatColour(content.name, "RGB", (red, green, blue))


def convert_to_rgb8(entry: Entry) -> tuple[int, int, int]:
    """Return an entry as sRGB of 8 bits, clipped to what a screen can show.

    RGB of another space is taken to sRGB; that of an unknown one keeps its numbers.
    """
    values = in_srgb(convert_to_flat(entry, ("RGB",))).values
    red, green, blue = (round(255.0 * min(1.0, max(0.0, value))) for value in values)
    return red, green, blue


def convert_to_plain(entry: Entry, models: Collection[str]) -> FlatColour:
    """Return :func:`convert_to_flat` for a format that names no colour spaces: what is RGB there is sRGB."""
    return in_srgb(convert_to_flat(entry, models))


def in_srgb(colour: FlatColour) -> FlatColour:
    """Return RGB, HSB or HSL of another known space as sRGB, not clipped; any other colour as it is.

    The look of an unknown space's numbers is undefined, so they are kept.
    """
    if not is_of_other_space(colour):
        return colour
    red, green, blue = working_to_display(lab_to_working(flat_labs([colour])[0])).tolist()
    return FlatColour(colour.name, "RGB", (red, green, blue))


def lab_d50(lab: Lab) -> Lab:
    """Return L*a*b* of D50 and 2°, as colour profiles have it, of that of D65 and 10°."""
    lightness, a, b = labs_d50(lab).tolist()
    return lightness, a, b


def labs_d50(lab: ArrayLike) -> Floats:
    """Return :func:`lab_d50` of many (..., 3)."""
    d65 = 100.0 * WORKING_TO_XYZ.sum(axis=1)
    xyz = adapt_xyz(working_to_xyz(lab_to_working(lab)), d65, WHITES["D50", 2], "Bradford")
    return xyz_to_lab(xyz, WHITES["D50", 2])


def unique_names(palette: Palette) -> list[str]:
    """Return a name for each entry, none twice and none empty: what is there already gets a number.

    >>> from brdf_suite.documents.palette import Palette
    >>> reds = [FlatColour(name, "RGB", (1.0, 0.0, 0.0)) for name in ("Red", "Red", "")]
    >>> unique_names(Palette("p", tuple(map(Entry, reds))))
    ['Red', 'Red (2)', 'Colour 3']
    """
    own = {entry.name for entry in palette}
    taken: set[str] = set()
    numbers: dict[str, int] = {}
    found = []
    for place, entry in enumerate(palette, 1):
        name = entry.name or f"Colour {place}"
        stem, number = name, numbers.get(name, 1)
        while name in taken or (name != entry.name and name in own):
            number += 1
            name = f"{stem} ({number})"
        numbers[stem] = number
        taken.add(name)
        found.append(name)
    return found


def nested_sections(
    palette: Palette,
) -> Iterator[tuple[Group | None, tuple[Entry, ...], list[GroupPath], list[GroupPath]]]:
    """Yield what a file of groups within groups holds: the sections of a palette, and the groups between them.

    Before a section's group and entries there end the groups of the first list, innermost first, and those of the
    second begin. The last one has no entries: what is open ends.
    """
    opened: GroupPath = ()
    for group, entries in (*palette.sections(), (None, ())):
        path = () if group is None else group.path
        shared = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(opened, path, strict=False)))
        ended = [opened[:depth] for depth in range(len(opened), shared, -1)]
        yield group, entries, ended, [path[: depth + 1] for depth in range(shared, len(path))]
        opened = path


def is_icc(colour: FlatColour) -> bool:
    """Return whether a colour's white is that of colour profiles, or it says nothing else."""
    return colour.illuminant in ("", "D50") and colour.observer_deg in (0, 2)


_EXACT = Context(prec=40)
_LONGEST = 60
"""Characters; a longer text is no number that a program wrote, and counts as the number that it is near."""


def scale_text(value: float, up: int, down: int = 1) -> str:
    """Return ``value * up / down``; :func:`unscale_text` of it is ``value``, to the last bit.

    The text has as many digits as that takes, most often no more than the number itself.

    >>> scale_text(0.07, 100), unscale_text("7.0", 100)
    ('7.000000000000001', 0.07)
    """
    product = _EXACT.divide(_EXACT.multiply(Decimal(value), Decimal(up)), Decimal(down))
    short = repr(float(product))
    return short if unscale_text(short, up, down) == value else f"{product:.25g}"


def unscale_text(text: str, up: int, down: int = 1) -> float:
    """Return the number of which a text is ``up / down`` times as much; the text must be a finite number."""
    if len(text) <= _LONGEST:
        try:
            return float(_EXACT.divide(_EXACT.multiply(Decimal(text), Decimal(down)), Decimal(up)))
        except ArithmeticError:
            pass  # an exponent of twenty digits: the number itself is 0
    return float(text) / up * down
