"""What the view shows, as plain values: panels with surfaces, points and words; and the frame about the lobes."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Literal

import numpy as np
import numpy.typing as npt
from brdf_qt.gl.segments import Rgba, Segments, polyline, segments
from brdf_qt.program.translation import decimal

from brdf_suite.arrays import Floats, Singles, triple
from brdf_suite.geometry.directions import mirror, spherical
from brdf_suite.inspection.lobe_surface.grid import LobeGrid
from brdf_suite.inspection.lobe_surface.surface import LobeSurface, RadiusScale

Style = Literal["solid", "glass", "lines"]

CUT = 1.15
"""The radius at which what is longer than the scale ends."""


@dataclass(frozen=True, eq=False)
class Layer:
    """A surface and how it is drawn: ``solid``, ``glass`` or ``lines``; with ``ink`` in the theme's colour of text.

    With the ``grid`` of its directions it hides labels that lie behind it, and its values can be read.
    """

    surface: LobeSurface
    style: Style = "solid"
    opacity: float = 1.0
    ink: bool = False
    grid: LobeGrid | None = None


@dataclass(frozen=True, eq=False)
class Probe:
    """A point (3,) of a lobe that is looked at; ``room`` is the top left of its panel."""

    place: Floats
    surface: LobeSurface
    grid: LobeGrid
    room: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Points:
    """Measured samples: places (n, 3) where their values lie, and colours (n, 4), 0 to 1."""

    places: Singles
    colours: Singles


@dataclass(frozen=True, eq=False)
class Panel:
    """One picture beside others, all from the same camera.

    ``title`` and ``caption`` stand above it, ``colour`` is the line of the legend beside the title (None: no line),
    ``note`` is what must be known to read the picture right.
    """

    title: str = ""
    caption: str = ""
    layers: tuple[Layer, ...] = ()
    points: Points | None = None
    note: str = ""
    colour: tuple[float, float, float] | None = None


@dataclass(frozen=True, eq=False)
class Bar:
    """A scale bar: codes (n, 3) from its lower end to its upper, places 0 to 1 with words, and what it measures."""

    codes: npt.NDArray[np.uint8]
    ticks: tuple[tuple[float, str], ...]
    title: str


@dataclass(frozen=True)
class FrameOptions:
    """Which of the frame is drawn: hemisphere, labels of angles, arrows, rings of values on the ground."""

    hemisphere: bool = True
    labels: bool = True
    arrows: bool = True
    rings: bool = True


@dataclass(frozen=True, eq=False)
class Scene:
    """All of the picture. ``light`` (3,) is the direction to the light; ``quantity`` what a radius means."""

    panels: tuple[Panel, ...] = ()
    light: Floats | None = None
    scale: RadiusScale = field(default_factory=RadiusScale)
    bar: Bar | None = None
    quantity: str = ""
    frame: FrameOptions = FrameOptions()


LIGHT_REACH = 1.18
"""How far from the middle the arrow's handle for the light is; the hemisphere's radius is 1."""
_MIRROR_REACH = 1.14
_LIGHT_CODES = (0.95, 0.78, 0.25)
_MIRROR_CODES = (0.87, 0.45, 0.70)
_TURN = np.radians(np.arange(0.0, 361.0, 3.0))
_CIRCLE = np.column_stack((np.cos(_TURN), np.sin(_TURN), np.zeros_like(_TURN)))
_ARC = np.radians(np.arange(0.0, 91.0, 3.0))


@dataclass(frozen=True)
class Label:
    """Words at a place of the local frame; ``strong`` ones are of arrows, the others of the grid."""

    place: tuple[float, float, float]
    text: str
    colour: Rgba | None = None
    strong: bool = False


@dataclass(frozen=True, eq=False)
class Frame:
    """Segments behind what is see-through, those before it, and labels; ``handle`` is where the light is dragged."""

    behind: Segments
    before: Segments
    labels: tuple[Label, ...]
    handle: Floats | None


def frame_of(light: Floats | None, scale: RadiusScale, options: FrameOptions, ink: Rgba) -> Frame:
    """Return the frame for light from ``light`` (3,), in lines of the colour ``ink``."""
    red, green, blue, _ = ink
    faint: Rgba = (red, green, blue, 0.20)
    soft: Rgba = (red, green, blue, 0.38)
    rows, labels = [], []
    azimuth = np.arctan2(-light[1], -light[0]) if light is not None and np.hypot(*light[:2]) > 1e-9 else 0.0
    rows.append(polyline(_CIRCLE, 1.4, soft))
    if options.hemisphere:
        rows += [_hemisphere(faint), _plane_of_incidence(float(azimuth), soft)]
    if options.labels:
        labels += _angles(float(azimuth), options.hemisphere)
    if options.rings:
        beside = spherical(np.pi / 2, azimuth + np.radians(62.0))
        for radius, text in rings_of(scale):
            flat = _CIRCLE * radius
            rows.append(polyline(flat, 1.0, faint))
            if options.labels:
                labels.append(Label(triple(radius * beside), text))
    before = [rows[0][:0]]
    if light is not None and options.arrows:
        before, words = _arrows(light, ink)
        labels += words
    handle = None if light is None else LIGHT_REACH * light
    return Frame(np.concatenate(rows), np.concatenate(before), tuple(labels), handle)


@lru_cache(4)
def _hemisphere(colour: Rgba) -> Segments:
    """The grid of angles, which is the same for every light."""
    circles = [np.sin(t) * _CIRCLE + (0.0, 0.0, np.cos(t)) for t in np.radians((30.0, 60.0))]
    arcs = [spherical(_ARC, np.full_like(_ARC, phi)) for phi in np.radians(np.arange(0.0, 360.0, 30.0))]
    return np.concatenate([polyline(points, 1.0, colour) for points in (*circles, *arcs)])


@lru_cache(4)
def _plane_of_incidence(azimuth: float, colour: Rgba) -> Segments:
    """The light's side and the mirror's, which stand out."""
    arcs = [spherical(_ARC, np.full_like(_ARC, side)) for side in (azimuth, azimuth + np.pi)]
    return np.concatenate([polyline(points, 1.5, colour) for points in arcs])


def rings_of(scale: RadiusScale) -> list[tuple[float, str]]:
    """Return radii up to 1 and the values that they stand for, as words: round ones, few enough to be read."""
    full = scale.full
    if scale.kind == "log":
        top = np.floor(np.log10(full) + 1e-9)
        step = max(1.0, np.ceil(scale.decades / 4.0))
        values = [10.0 ** (top - k * step) for k in range(8)]
    else:
        shares = (1.0, 0.75, 0.5, 0.25) if scale.kind == "linear" else (1.0, 0.3, 0.1, 0.01)
        values = [_round(full * share) for share in shares]
    rows: list[tuple[float, str]] = []
    for value in values:
        radius = float(scale.radius(value))
        if 0.08 < radius <= 1.001 and all(abs(radius - other) > 0.07 for other, _ in rows):
            rows.append((radius, decimal(f"{value:.3g}")))
    return rows


def _round(value: float) -> float:
    """The value with one digit, or two where the first is 1, rounded down."""
    power = 10.0 ** np.floor(np.log10(value))
    digits = value / power
    step = 0.5 if digits < 2.0 else 1.0
    return float(np.floor(digits / step + 1e-9) * step * power)


@lru_cache(4)
def _angles(azimuth: float, hemisphere: bool) -> list[Label]:
    # At azimuth 0 of the incidence the light stands at 180° of the frame.
    at = [(1.09 * spherical(np.pi / 2, np.radians(phi)), (phi + 180) % 360) for phi in range(0, 360, 30)]
    if hemisphere:
        sides = (azimuth, azimuth + np.pi)
        at += [(1.07 * spherical(np.radians(theta), side), theta) for theta in (30, 60) for side in sides]
    return [Label(triple(place), f"{angle}°") for place, angle in at]


def _arrows(light: Floats, ink: Rgba) -> tuple[list[Segments], list[Label]]:
    top = mirror(light)
    gold: Rgba = (*_LIGHT_CODES, 1.0)
    rose: Rgba = (*_MIRROR_CODES, 1.0)
    normal = np.array([0.0, 0.0, 1.0])
    # The light comes in: its arrow points to the middle. The others go out.
    # Within the hemisphere they are thin: what they would cover is what is looked at.
    # The mirror direction's has no line within: it would look like a spike.
    rows = [
        *_arrow(LIGHT_REACH * light, 0.98 * light, gold, 0.0 * light),
        *_arrow(top, _MIRROR_REACH * top, rose, top),
        *_arrow(normal, _MIRROR_REACH * normal, (*ink[:3], 0.85), 0.0 * normal),
    ]
    labels = [
        Label(triple(1.12 * LIGHT_REACH * light), "L", gold, True),
        Label(triple(1.07 * _MIRROR_REACH * top), "R", rose, True),
        Label(triple(1.07 * _MIRROR_REACH * normal), "N", (*ink[:3], 1.0), True),
    ]
    return rows, labels


def _arrow(start: Floats, end: Floats, colour: Rgba, foot: Floats) -> list[Segments]:
    """Shaft and head from ``start`` to ``end``, and a thin line to ``foot`` from whichever is nearer to it."""
    along = end - start
    neck = end - along / float(np.linalg.norm(along)) * 0.085
    inner = min((start, end), key=lambda place: float(np.linalg.norm(place - foot)))
    return [
        segments(start, neck, (2.4, 2.4), colour),
        segments(neck, end, (11.0, 0.5), colour),
        segments(inner, foot, (1.2, 1.2), (*colour[:3], 0.4)),
    ]
