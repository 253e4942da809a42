"""Glare of a drawn frame: light above white, spread by a sum of Gaussians that a pyramid of pictures makes.

:mod:`brdf_suite.appearance.glare` has what the eye spreads. Here the light above white, averaged over blocks of 2×2
pixels, is halved again and again, and each level, blurred and drawn out to the size of the first, is about a Gaussian
of the variance 4^l - 1/4 blocks. The levels' shares are those that come nearest to the eye's; the first has none,
whose blocks would be seen.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import moderngl

from brdf_suite.appearance.glare import WHITE, WIDEST_DEG, gaussian_shares, pixel_angle
from brdf_suite.documents.view import SENSOR_WIDTH_MM, View
from brdf_suite.realtime.gl.objects import GpuObjects, Size, Target
from brdf_suite.realtime.gl.programs import assign
from brdf_suite.realtime.pictures.display import Display

_BLOCK = 2
_LIGHT_UNIT, _OTHER_UNIT = 0, 1


@dataclass(frozen=True, eq=False)
class Veil:
    """The light that is spread over a picture: a texture that covers ``size`` pixels of it, more than all; and which
    share of the light above white is missing where that came from.
    """

    texture: moderngl.Texture
    size: tuple[float, float]
    share: float


def glares(view: View, display: Display) -> bool:
    """Whether a picture of the view shows glare: none of numbers does, and none with marks of the screen's limits."""
    marked = view.clipping_marks or view.gamut_marks
    return view.glare == "eye" and not display.linear and not marked


class GlarePass:
    """Spreads light above white; keeps its pyramid while the size stays."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._levels: list[tuple[Target, Target]] = []

    def spread(
        self,
        light: moderngl.Texture,
        view: View,
        region: tuple[int, int, int, int] | None = None,
        *,
        whole: Size | None = None,
    ) -> Veil | None:
        """Return the veil of ``light``, exposed radiance, or of the part in ``region`` alone; None of a few pixels.

        ``whole``: the size in pixels of the picture that ``light`` is a smaller version of, where it is one.
        """
        width, height = light.size
        sizes = _sizes((-(-width // _BLOCK), -(-height // _BLOCK)))
        if len(sizes) < 2:
            return None
        texel = pixel_angle(view.camera.focal_length_mm, width, SENSOR_WIDTH_MM) * _BLOCK
        spreads = [texel * math.sqrt(4.0**level - 0.25) for level in range(1, len(sizes))]
        spreads = spreads[: max(1, sum(spread <= WIDEST_DEG for spread in spreads))]
        shares = (0.0, *gaussian_shares(tuple(spreads)))
        while len(self._levels) < len(shares):
            self._levels.append((Target(self._objects), Target(self._objects)))
        left, lower, wide, high = region or (0, 0, width, height)
        self._draw_excess(light, sizes[0], (left, lower, min(left + wide, width), min(lower + high, height)))
        for level in range(1, len(shares)):
            self._halve(level, sizes)
        texture = self._add(sizes, shares)
        texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        texture.repeat_x = texture.repeat_y = False
        shown = whole or light.size
        covered = (_BLOCK * sizes[0][0] * shown[0] / width, _BLOCK * sizes[0][1] * shown[1] / height)
        return Veil(texture, covered, sum(shares))

    def _draw_excess(self, light: moderngl.Texture, size: Size, region: tuple[int, int, int, int]) -> None:
        framebuffer, _ = self._levels[0][0].prepare(size, "f4")
        program, screen = self._objects.screen("glare_excess.frag.glsl", {"SAMPLES": str(light.samples)})
        assign(program, {"light": _LIGHT_UNIT, "region": region, "white": WHITE})
        self._objects.bind(framebuffer, size)
        light.use(_LIGHT_UNIT)
        screen.render(moderngl.TRIANGLES, vertices=3)

    def _halve(self, level: int, sizes: list[Size]) -> None:
        _, finer = self._levels[level - 1][0].prepare(sizes[level - 1], "f4")
        framebuffer, _ = self._levels[level][0].prepare(sizes[level], "f4")
        program, screen = self._objects.screen("glare_halve.frag.glsl")
        assign(program, {"finer": _LIGHT_UNIT})
        self._objects.bind(framebuffer, sizes[level])
        finer.use(_LIGHT_UNIT)
        screen.render(moderngl.TRIANGLES, vertices=3)

    def _add(self, sizes: list[Size], shares: tuple[float, ...]) -> moderngl.Texture:
        program, screen = self._objects.screen("glare_add.frag.glsl")
        coarser: moderngl.Texture | None = None
        for level in reversed(range(len(shares))):
            _, own = self._levels[level][0].prepare(sizes[level], "f4")
            framebuffer, texture = self._levels[level][1].prepare(sizes[level], "f4")
            values = {"own": _LIGHT_UNIT, "coarser": _OTHER_UNIT, "share": shares[level]}
            assign(program, values | {"has_coarser": coarser is not None})
            self._objects.bind(framebuffer, sizes[level])
            own.use(_LIGHT_UNIT)
            (coarser or own).use(_OTHER_UNIT)
            screen.render(moderngl.TRIANGLES, vertices=3)
            coarser = texture
        assert coarser is not None
        return coarser


def _sizes(size: Size) -> list[Size]:
    """Return the sizes of the levels, halved and rounded up until one texel is left."""
    found = [size]
    while max(found[-1]) > 1:
        found.append((-(-found[-1][0] // 2), -(-found[-1][1] // 2)))
    return found
