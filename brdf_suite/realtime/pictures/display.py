"""Output of the finishing pass: codes of a screen or a picture file, or radiance."""

from __future__ import annotations

from dataclasses import dataclass

from brdf_suite.appearance.colour.spaces import DISPLAY_P3_SPACE, SRGB_SPACE, DisplaySpace


@dataclass(frozen=True, eq=False)
class Display:
    """Output encoding of the finished picture.

    Attributes
    ----------
    space
        Whose colours and codes.
    dithered
        To 8 bits, with a dither of half a step either way; otherwise exact, for 16 bits.
    linear
        Instead of codes the averaged radiance of the working space, exposure divided out, and in alpha the
        object's share of the pixel. Takes a framebuffer of floats.
    """

    space: DisplaySpace = SRGB_SPACE
    dithered: bool = True
    linear: bool = False


SRGB = Display()
DISPLAY_P3 = Display(DISPLAY_P3_SPACE)
LINEAR = Display(dithered=False, linear=True)


@dataclass(frozen=True)
class Unshowable:
    """Counts of object pixels outside a screen's range: clipped highlights, out of gamut."""

    pixels: int
    too_bright: int
    too_colourful: int
