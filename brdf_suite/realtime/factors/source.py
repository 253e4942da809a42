"""Shader source of the sums and products of a factored material, inserted in factors.glsl.

What depends on the view alone is looked up once a pixel, the rest once a light. Materials with the same terms share a
program; their maps and scales are uniforms.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from brdf_suite.geometry.factor_projections import PROJECTIONS
from brdf_suite.realtime.factors.values import FactoredMaps
from brdf_suite.realtime.gl.programs import Features

Layout = Literal["parabolic", "cube"]
"""How maps over directions lie in textures."""

# Projection: the place in a flat map, and the direction in a cube map, in the words of factors.glsl.
_PLACES = {
    "wi": ("disc_place(wi)", "wi"),
    "wo": ("disc_place(wo)", "wo"),
    "h": ("disc_place(h)", "h"),
    "|wi|": ("vec2(disc_radius(cos_light), 0.5)", ""),
    "|wo|": ("vec2(disc_radius(cos_view), 0.5)", ""),
    "|h|": ("vec2(half_radius, 0.5)", ""),
    "sqrt|h|": ("vec2(half_root, 0.5)", ""),
    "wi.wo": ("vec2(0.5 * cos_across + 0.5, 0.5)", ""),
    "w.h": ("vec2(cos_half, 0.5)", ""),
    "w.h,h.n": ("vec2(cos_half, cos_facet)", ""),
    "wi.n,wo.n": ("vec2(min(cos_light, cos_view), max(cos_light, cos_view))", ""),
}
_OF_VIEW = ("wo", "|wo|")
_UNEVEN = ("sqrt|h|",)


@dataclass(frozen=True)
class Slots:
    """Texture units of the maps: indices among the flat ones and among the cube maps."""

    flat: tuple[str, ...]
    cubes: tuple[str, ...]

    @classmethod
    def of(cls, maps: FactoredMaps, layout: Layout) -> Slots:
        """Give every map of a material its slot, in the order of their names."""
        directional = {name for name in maps.maps if maps.form(name) == "hemisphere"}
        cubes = sorted(directional) if layout == "cube" else []
        return cls(tuple(sorted(set(maps.maps) - set(cubes))), tuple(cubes))


def shader_words(maps: FactoredMaps, slots: Slots) -> Features:
    """Return the words, some with values (``NAME=value``), that make a surface program one for these terms."""
    seen, lit = [], []
    for number, term in enumerate(maps.terms):
        sums = {True: [f"factor_alphas[{number}]"], False: []}
        gains: dict[bool, list[str]] = {True: [], False: []}
        for name, projection in term.factors:
            of_view = projection in _OF_VIEW
            target = sums if maps.maps[name].logarithmic else gains
            target[of_view].append(_look_up(name, projection, slots))
        seen.append(f"vec3 log_{number} = {' + '.join(sums[True])};")
        seen.append(f"vec3 gain_{number} = {' * '.join(gains[True]) or 'vec3(1.0)'};")
        exponent = " + ".join([f"log_{number}", *sums[False]])
        product = " * ".join([f"exp(min({exponent}, factor_limit))", f"gain_{number}", *gains[False]])
        lit.append(f"f += {product};")
    words = {
        "FACTORS",
        f"FACTOR_TERMS={len(maps.terms)}",
        f"FACTOR_FLAT={len(slots.flat)}",
        f"FACTOR_CUBES={len(slots.cubes)}",
        f"FACTORS_OF_VIEW={' '.join(seen)}",
        f"FACTORS_OF_LIGHT={' '.join(lit)}",
    }
    if maps.has_directions:
        words.add("FACTOR_FRAME")
    if maps.coat is not None:
        words.add("FACTORS_COATED")
    return frozenset(words)


def _look_up(name: str, projection: str, slots: Slots) -> str:
    flat, cube = _PLACES[projection]
    if name in slots.cubes:
        return f"CUBE_FACTOR({slots.cubes.index(name)}, {cube})"
    kind = "FINE" if projection in _UNEVEN else "FLAT"
    return f"{kind}_FACTOR({slots.flat.index(name)}, {flat})"


def texels_per_radian(projection: str, size: int, *, cube: bool = False) -> float:
    """Return how many texels of a map of ``size`` a normal passes that turns by a radian, about; 0: it is at none."""
    if projection in ("w.h", "wi.wo"):
        return 0.0
    if cube:
        return 0.5 * size
    # Of a parabolic place 0.5 (s + 1) it is (1 + r²)/4 to 1/2, of a radius twice as much.
    # Of the root of a radius, which is finer towards the middle, it is that of a radius over four, over the root.
    if projection in _UNEVEN:
        return 0.25 * size
    if projection == "|h|":
        return 0.5 * size
    return (0.35 if PROJECTIONS[projection].hemisphere else 0.7) * size
