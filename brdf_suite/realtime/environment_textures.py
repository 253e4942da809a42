"""The maps of one environment on the GPU: a seamless cube map per lobe, the diffuse map, the background.

A map that serves several purposes (the background is the map of the lobes too sharp to be filtered) is uploaded
once. A new environment of the same sizes is written into the textures that are there.
"""

from __future__ import annotations

import math

import moderngl
import numpy as np

from brdf_suite.realtime.context import graphics_errors
from brdf_suite.realtime.gpu_objects import GpuObjects
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps

_SEAMLESS = 0x884F  # GL_TEXTURE_CUBE_MAP_SEAMLESS, core since OpenGL 3.2

MIPMAPPED_FROM = 256
"""Faces this large get mip levels: a tightly curved surface squeezes a sharp lobe's map into few pixels."""


class EnvironmentTextures:
    """A texture unit for each distinct map: 0 diffuse, then background and lobes."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._textures: list[moderngl.TextureCube] = []
        self._units: list[int] = []  # of the diffuse map, the background, and each lobe
        self._scales: list[float] = []
        self.exponents: tuple[float, ...] = ()

    def load(self, maps: EnvironmentMaps) -> None:
        """Write all maps; :class:`GraphicsError` where the GPU's memory or size limit is exceeded."""
        all_faces = (maps.diffuse, maps.background, *maps.lobes)
        # The same numbers under another scale are the same texture: scales are uniforms.
        distinct = {id(faces.faces): faces for faces in all_faces}
        unit_of = {identity: unit for unit, identity in enumerate(distinct)}
        sizes = [faces.size for faces in distinct.values()]
        if sizes != [texture.size[0] for texture in self._textures]:
            self.release()
            self._textures = [self._objects.cube(size) for size in sizes]
        with graphics_errors(self._objects.context, "loading the environment's maps"):
            for texture, faces in zip(self._textures, distinct.values(), strict=True):
                self._write(texture, faces)
        self._units = [unit_of[id(faces.faces)] for faces in all_faces]
        self._scales = [faces.scale for faces in all_faces]
        self.exponents = maps.exponents

    def bind(self) -> None:
        """Bind every map to its unit and switch filtering across the edges of faces on."""
        self._objects.context.enable_direct(_SEAMLESS)
        for unit, texture in enumerate(self._textures):
            texture.use(unit)

    def uniforms(self) -> dict[str, object]:
        """Return the units and scales of the two maps by the names of environment.glsl."""
        return {
            "diffuse_map": self._units[0],
            "background_map": self._units[1],
            "diffuse_scale": self._scales[0],
            "background_scale": self._scales[1],
        }

    def lobe_uniforms(self, lobes: tuple[int, ...], look_ups: int) -> dict[str, object]:
        """Return the maps of some lobes by the names of lobes.glsl, filled up with any map to ``look_ups``."""
        places = [2 + lobe for lobe in lobes] + [2] * (look_ups - len(lobes))
        return {
            "lobe_maps": tuple(self._units[place] for place in places),
            "lobe_exponents": tuple(self.exponents[place - 2] for place in places),
            "lobe_scales": tuple(self._scales[place] for place in places),
            # A face of F texels is 2 wide at distance 1: F / 2 texels per radian in its middle.
            "lobe_levels": tuple(
                math.log2(self._textures[self._units[place]].size[0] / 2) for place in places
            ),
        }

    def release(self) -> None:
        """Give the textures back."""
        for texture in self._textures:
            self._objects.release(texture)
        self._textures = []

    def _write(self, texture: moderngl.TextureCube, faces: CubeFaces) -> None:
        for face in range(6):
            texture.write(face, np.ascontiguousarray(faces.faces[face]))
        self._objects.counters.texture_uploads += 6
        if faces.size >= MIPMAPPED_FROM:
            texture.build_mipmaps()
            texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
        else:
            texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
