"""What the view shows, as plain values: panels side by side, each with surfaces over one another, points and words."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Singles
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
