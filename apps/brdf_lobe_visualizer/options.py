"""What all views share: channel, radius, cosine, what is shown of each subject, which lobes are switched off."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Channel = Literal["colour", "r", "g", "b", "luminance"]
Radius = Literal["linear", "cbrt", "log"]
Shown = Literal["target", "fit", "both", "side by side", "difference"]
Part = Literal["diffuse", "directional", "gloss"]

CHANNELS: tuple[Channel, ...] = ("colour", "r", "g", "b", "luminance")
RADII: tuple[Radius, ...] = ("linear", "cbrt", "log")
SHOWN: tuple[Shown, ...] = ("target", "fit", "both", "side by side", "difference")
PARTS_OF_FIT: tuple[Part, ...] = ("diffuse", "directional", "gloss")

INCIDENCE_DEG = (45.0, 0.0)
"""Polar angle and azimuth of the light at a first start, and after a reset."""
MOST_THETA_DEG = 89.9


@dataclass(frozen=True)
class Options:
    """The options; the defaults are what a reset goes back to.

    ``lobes_off`` holds ``(part, index)`` of the lobes of a fit that are switched off, the index into its exponents;
    the diffuse part has the index 0.
    """

    channel: Channel = "colour"
    radius: Radius = "cbrt"
    cosine: bool = True
    shown: Shown = "target"
    lobes_off: frozenset[tuple[Part, int]] = frozenset()
