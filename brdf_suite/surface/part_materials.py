"""Which of our materials the parts of a foreign mesh are made of: by their names, else by look and area.

A part's name decides first, since makers of cars name tyres and panes. Where no name says anything, the file's own
material does: what lets light through is glass, a bright metal chrome, a dark rough one trim. Of the rest the look with
the largest area is the paint; a glossy one of another colour is the second paint, and all else stays neutral. A file
without looks is painted as a whole: who opens a mesh here wants to see paint on it.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.documents.view_settings import MATERIALS, Material
from brdf_suite.surface.normals import triangle_areas
from brdf_suite.surface.repair import ForeignLook, RawPart

# In order: the first row with a word that a name begins a word with decides. Paint comes first, since
# "metallic paint" is no metal; trim before glass, since a window trim is no window; lamps before the lenses of them.
_ROWS: tuple[tuple[Material, tuple[str, ...]], ...] = (
    ("paint", ("paint", "carpaint", "lacquer", "body", "bodywork", "coachwork")),
    ("trim", ("trim", "plastic", "bumper", "grille", "grill", "dashboard", "carpet", "interior")),
    ("glass", ("glass", "window", "windscreen", "windshield")),
    ("rubber", ("rubber", "tire", "tyre", "wheel")),
    ("tail_lamp", ("taillight", "taillamp", "brakelight")),
    ("lamp", ("lamp", "headlamp", "headlight", "bulb")),
    ("lens", ("lens",)),
    ("chrome", ("chrome", "metal", "steel", "alumin", "rim")),
    (
        "neutral",
        (
            *("calibration", "floor", "ground", "backdrop", "background", "pedestal", "plinth"),
            *("seat", "leather", "fabric", "upholstery"),
        ),
    ),
)
_WHOLE_WORDS = frozenset({"rim", "rims", "body", "grill", "metal", "metals", "seat", "seats"})
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")

_CLEAR, _CLEAREST = 0.35, 0.85
"""Shares of the light that pass: a pane, and one without a tint to speak of."""
_METAL, _MIRROR, _BRIGHT = 0.7, 0.35, 0.35
_DARK, _MATT, _TYRE = 0.04, 0.35, 0.85
_GREY = 0.12
"""Of a colour's largest channel: what its channels may differ by."""
_SAME = 0.08
"""What the square roots of two colours' channels may differ by that are one paint."""
_SECOND_SHARE = 0.1
"""Of the paint's area: a glossy look below it is no second paint."""


def named_material(material: str, part: str) -> Material | None:
    """Return the material that names say; the material's name counts before the part's own. None: they say nothing.

    A material that has the name of one of ours is that: our own files pass through the hands of other programs.

    >>> named_material("window_trim", "Body"), named_material("Material.001", "FrontTyre")
    ('trim', 'rubber')
    """
    if material in MATERIALS:
        return material
    for name in (material, part):
        words = [word.lower() for word in _WORD.findall(name)]
        for result, starts in _ROWS:
            if any(
                word in (start, start + "s") if start in _WHOLE_WORDS else word.startswith(start)
                for word in words
                for start in starts
            ):
                return result
    return None


@dataclass
class _Group:
    """Parts of one look, and their area where it is asked for."""

    look: ForeignLook
    parts: list[int]
    area: float = 0.0


def guess_materials(parts: Sequence[RawPart]) -> list[RawPart]:
    """Return the parts with their materials guessed, as the module says."""
    words: list[Material | None] = [named_material(part.look.name, part.name) for part in parts]
    looks = {part.look for part in parts}
    groups: dict[object, _Group] = {}
    for number, part in enumerate(parts):
        if words[number] is None and len(looks) > 1:
            words[number] = _stock_material(part.look)
        if words[number] is None:
            group = groups.setdefault(part.look, _Group(part.look, []))
            group.parts.append(number)
    for found, group in zip(_paints(parts, words, list(groups.values())), groups.values(), strict=True):
        for number in group.parts:
            words[number] = found
    return [replace(part, material=word or "paint") for part, word in zip(parts, words, strict=True)]


def _paints(
    parts: Sequence[RawPart], words: Sequence[Material | None], groups: list[_Group]
) -> list[Material]:
    """Return paint, second paint or neutral for each group of parts that neither name nor look has sorted."""
    named = any(word == "paint" for word in words)
    if len(groups) <= (0 if named else 1):
        return ["paint"] * len(groups)  # whatever their areas are
    for group in groups:
        group.area = sum(_area(parts[number]) for number in group.parts)
    by_name: dict[ForeignLook, float] = defaultdict(float)
    for part, word in zip(parts, words, strict=True):
        if word == "paint":
            by_name[part.look] += _area(part)
    if by_name:
        paint = max(by_name, key=lambda look: by_name[look])
        area = sum(by_name.values())
    else:
        largest = max(groups, key=lambda group: group.area)
        paint, area = largest.look, largest.area
    found: list[Material] = []
    for group in groups:
        look = group.look
        if look == paint or look.colour is None or _same_colour(look, paint):
            found.append("paint")
        elif (look.roughness is None or look.roughness <= _MATT) and group.area >= _SECOND_SHARE * area:
            found.append("second_paint")
        else:
            found.append("neutral")
    return found


def _stock_material(look: ForeignLook) -> Material | None:
    """Return glass, lens, chrome, rubber or trim where a look is one of them; None where it could be a paint."""
    if look.passing >= _CLEAR:
        return (
            "lens"
            if look.passing >= _CLEAREST and (look.colour is None or min(look.colour) > 0.5)
            else "glass"
        )
    if look.colour is None:
        return None
    low, high = min(look.colour), max(look.colour)
    grey = high - low <= max(_GREY * high, 0.01)
    rough = 0.5 if look.roughness is None else look.roughness
    if (look.metallic or 0.0) >= _METAL:
        return "chrome" if grey and low >= _BRIGHT and rough <= _MIRROR else None
    if grey and high <= _DARK and rough >= _MATT:
        return "rubber" if rough >= _TYRE else "trim"
    return None


def _same_colour(look: ForeignLook, paint: ForeignLook) -> bool:
    if look.colour is None or paint.colour is None:
        return look.colour is paint.colour
    return bool(np.abs(np.sqrt(look.colour) - np.sqrt(paint.colour)).max() <= _SAME)


def _area(part: RawPart) -> float:
    """Return the area of the triangles that can be drawn, in the file's unit."""
    triangles = part.triangles
    if not 0 <= triangles.min(initial=0) <= triangles.max(initial=0) < len(part.positions):
        triangles = triangles[((triangles >= 0) & (triangles < len(part.positions))).all(axis=1)]
    with np.errstate(all="ignore"):
        sizes = triangle_areas(part.positions, triangles)
    return float(sizes[np.isfinite(sizes)].sum())
