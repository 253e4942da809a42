"""Textures of factored materials' maps, and the shader source of their sums and products, inserted in factors.glsl.

What depends on the view alone is looked up once a pixel, the rest once a light. Materials with the same terms share a
program; their maps and scales are uniforms. The textures are mip-mapped, parabolic or cube maps.

Textures of 8 bits hold a map stretched over their range; its lowest value goes into α, so only the span costs the
shader something. A cube map is sampled from the parabolic one: seams and corners are the graphics card's affair then,
and its coarser levels are means of logarithms, since moderngl writes no level of a cube map.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.geometry.factor_words import PROJECTIONS
from brdf_suite.realtime.factors.levels import cube_faces, levels, radial_levels
from brdf_suite.realtime.factors.values import FactoredMaps
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import FIRST_CUBE_FACTOR_UNIT, FIRST_FACTOR_UNIT, Features

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


Store = Literal["8-bit", "half", "float"]
_DTYPES = {"8-bit": "f1", "half": "f2", "float": "f4"}
_LOWEST_LOG = -80.0
_ROOM = 8.0
"""How far beyond the ceiling's logarithm f is exponentiated: bent softly, it is the ceiling by then."""


@dataclass(frozen=True, eq=False)
class _Factored:
    words: Features
    flat: tuple[moderngl.Texture, ...]
    cubes: tuple[moderngl.TextureCube, ...]
    uniforms: dict[str, object]


class FactorTextures:
    """Factor textures by material; a material without factors is shaded with its lobes alone.

    Parameters
    ----------
    layout
        Layout of maps over directions; ``parabolic`` is more accurate and faster (docs/method/factorization.md).
    store
        Of what numbers the textures are.
    """

    def __init__(self, objects: GpuObjects, layout: Layout = "parabolic", store: Store = "float") -> None:
        self._objects = objects
        self.layout: Layout = layout
        self.store: Store = store
        self._materials: dict[str, _Factored] = {}

    def set(self, material: str, maps: FactoredMaps | None) -> None:
        """Give a material its factors from the next frame on, or none."""
        self._give_back(material)
        if maps is not None:
            with graphics_errors(self._objects.context, f"writing the factors of {material}"):
                self._materials[material] = self._made(maps)

    def features(self, material: str, *, has_uv: bool = False) -> Features:
        """Return the words of the shader of a material, on a part with texture coordinates or without.

        None where it has no factors.
        """
        found = self._materials.get(material)
        if found is None:
            return frozenset()
        return found.words | {"HAS_UV"} if has_uv and "FACTOR_FRAME" in found.words else found.words

    def made(self, material: str) -> object:
        """Return the identity of a material's factors: the same object until they change."""
        return self._materials.get(material)

    def use(self, material: str) -> dict[str, object]:
        """Bind a material's maps and return the uniforms of factors.glsl."""
        found = self._materials[material]
        for unit, flat in enumerate(found.flat):
            flat.use(FIRST_FACTOR_UNIT + unit)
        for unit, cube in enumerate(found.cubes):
            cube.use(FIRST_CUBE_FACTOR_UNIT + unit)
        return found.uniforms

    def release(self) -> None:
        """Give all textures back."""
        for material in list(self._materials):
            self._give_back(material)

    def _give_back(self, material: str) -> None:
        found = self._materials.pop(material, None)
        if found is not None:
            for texture in (*found.flat, *found.cubes):
                self._objects.release(texture)

    def _made(self, maps: FactoredMaps) -> _Factored:
        slots = Slots.of(maps, self.layout)
        flat = [self._flat(maps, name) for name in slots.flat]
        cubes = [self._cube(maps, name) for name in slots.cubes]
        stretch = dict(zip((*slots.flat, *slots.cubes), (s for _, s in (*flat, *cubes)), strict=True))
        alphas = []
        for term in maps.terms:
            log = np.log(np.maximum(term.alpha, np.exp(_LOWEST_LOG)))
            for name, _ in term.factors:
                if maps.maps[name].logarithmic:
                    log = log + stretch[name][0]
            alphas.append(tuple(np.maximum(log, _LOWEST_LOG).tolist()))
        uniforms: dict[str, object] = {
            "factor_alphas": tuple(alphas),
            "factor_limit": float(np.log(maps.ceiling)) + _ROOM,
            "factor_ceiling": 1.0 / maps.ceiling,
        }
        if maps.coat is not None:
            coat = maps.coat
            uniforms["factor_coat"] = (coat.ior, coat.spread, coat.inner, coat.even)
            uniforms["factor_albedo"] = coat.albedo
        if flat:
            uniforms["factor_spans"] = tuple(tuple(stretch[name][1].tolist()) for name in slots.flat)
            uniforms["factor_levels"] = tuple(_level(maps, name, cube=False) for name in slots.flat)
        if cubes:
            uniforms["factor_cube_spans"] = tuple(tuple(stretch[name][1].tolist()) for name in slots.cubes)
            uniforms["factor_cube_levels"] = tuple(_level(maps, name, cube=True) for name in slots.cubes)
        words = shader_words(maps, slots)
        if self.store == "8-bit":
            words |= {"FACTOR_SPANS"}
        return _Factored(words, tuple(t for t, _ in flat), tuple(t for t, _ in cubes), uniforms)

    def _flat(self, maps: FactoredMaps, name: str) -> tuple[moderngl.Texture, tuple[Floats, Floats]]:
        """Return a map's texture, and lowest value and span (3,) by which its texels are to be read."""
        one = maps.maps[name]
        image = one.values if one.values.ndim == 3 else one.values[None]
        power = maps.radial_power(name)
        if power is None:
            hemisphere = maps.form(name) == "hemisphere"
            finer = levels(image, logarithmic=one.logarithmic, hemisphere=hemisphere)
        else:
            finer = radial_levels(one.values, logarithmic=one.logarithmic, power=power)
        low, span = self._stretch(image, one.logarithmic)
        texture = self._objects.texture((image.shape[1], image.shape[0]), _DTYPES[self.store])
        texture.build_mipmaps()  # makes room for the levels, which are then our own
        for level, texels in enumerate(finer):
            texture.write(self._texels((texels - low) / span), level=level)
        texture.repeat_x = texture.repeat_y = False
        texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
        self._objects.counters.texture_uploads += 1
        return texture, (low, span)

    def _cube(self, maps: FactoredMaps, name: str) -> tuple[moderngl.TextureCube, tuple[Floats, Floats]]:
        one = maps.maps[name]
        low, span = self._stretch(one.values, one.logarithmic)
        faces = cube_faces(one.values)
        texture = self._objects.cube(faces.shape[1], 4, _DTYPES[self.store])
        for face in range(6):
            texture.write(face, self._texels((faces[face] - low) / span))
        texture.build_mipmaps()
        texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
        self._objects.counters.texture_uploads += 6
        return texture, (low, span)

    def _stretch(self, values: NDArray[np.float32], logarithmic: bool) -> tuple[Floats, Floats]:
        """Return what a texture of 8 bits is stretched over; wider numbers are kept as they are."""
        if self.store != "8-bit":
            return np.zeros(3), np.ones(3)
        flat = values.reshape(-1, 3).astype(np.float64)
        # A value that is no logarithm has no place for an offset: it is a factor of the product.
        low = flat.min(axis=0) if logarithmic else np.zeros(3)
        return low, np.maximum(flat.max(axis=0) - low, 1e-6)

    def _texels(self, values: Floats) -> bytes:
        pixels = np.concatenate([values, np.ones((*values.shape[:2], 1))], axis=-1)
        if self.store == "8-bit":
            return bytes(np.rint(255.0 * np.clip(pixels, 0.0, 1.0)).astype(np.uint8).tobytes())
        if self.store == "half":
            return bytes(np.clip(pixels, -6e4, 6e4).astype(np.float16).tobytes())
        return bytes(pixels.astype(np.float32).tobytes())


def _level(maps: FactoredMaps, name: str, *, cube: bool) -> float:
    """Return log2 of the texels of a map in a radian, of the projection that passes most."""
    size = max(maps.maps[name].values.shape[:-1])
    read = {p for term in maps.terms for m, p in term.factors if m == name}
    return float(np.log2(max(max(texels_per_radian(p, size, cube=cube) for p in read), 1e-6)))
