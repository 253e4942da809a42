"""Scene to picture: the renderer fed from a fit, a prepared environment and a mesh, in a window or without."""

from __future__ import annotations

from functools import cache, partial
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SECOND_PAINT
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.factored_maps import maps_of
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, LobeFit
from brdf_suite.pipeline.paint_angles import PaintAngles
from brdf_suite.pipeline.scene import PreparedEnvironment
from brdf_suite.pipeline.surface_images import SurfaceImages, orange_peel_tile
from brdf_suite.realtime.factors.values import FactoredMaps
from brdf_suite.realtime.gl.context import Context, create_context, release_context
from brdf_suite.realtime.lights.block import NO_LIGHTS, DistantLights
from brdf_suite.realtime.pictures.captured import CapturedPaint
from brdf_suite.realtime.pictures.moving import WHOLE, Coarseness, Enlarger
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.values import (
    CubeFaces,
    EnvironmentMaps,
    GroundField,
    MaterialWeights,
    MeshPart,
)
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh

Size = tuple[int, int]
PAINT_MATERIAL = "paint"
SECOND_MATERIAL = "paint_b"
"""The paint that the first is compared with."""


class SceneRenderer:
    """Draws paint fits on surfaces in prepared environments, in the OpenGL context it is given.

    ``renderer`` draws them. The same object serves a widget (its context is current in every call) and the command
    line. Setting a paint fit writes one small buffer; setting an environment or a surface uploads.
    """

    def __init__(self, context: Context, angles: PaintAngles | None = None) -> None:
        self.renderer = Renderer(context, make_peel=orange_peel_tile)
        self._enlarger = Enlarger(self.renderer.objects)
        self._view = View()
        self._fits: dict[str, LobeFit] = {}
        self._weights: dict[str, MaterialWeights] = {}
        self._maps: tuple[object, FactoredMaps | None] | None = None
        self._angles = angles or PaintAngles(time_limit_s=PATIENT_TIME_LIMIT_S)

    def set_material(self, fit: LobeFit, material: str = PAINT_MATERIAL, view: View | None = None) -> None:
        """Show this paint or measured reflectance from the next frame on; no allocation, no file, no texture.

        ``material`` is the one that is given it: the surface's paint, or the one that it is compared with. Its weights
        over the angle are those for ``view``, by default the one that was prepared last, see :meth:`prepare`.
        """
        self._view = view or self._view
        self._fits[material] = fit
        if self._angles.waits:
            self._angles.prepare(fit, self._view)
        self._take_weights(material)
        self.renderer.set_flakes(material, fit.flakes)
        self.renderer.factors.set(material, self._factored(fit))
        self.renderer.relief.set_own_peel(material, fit.orange_peel)

    def prepare(self, view: View) -> None:
        """Take what the modes of ``view`` need of weights over the angle; call it before a frame in other modes.

        Without a window that waits for nothing they are fitted here; in one, those are taken that are there by now.
        """
        self._view = view
        for material, fit in self._fits.items():
            if self._angles.waits:
                self._angles.prepare(fit, view)
            self._take_weights(material)

    def _take_weights(self, material: str) -> None:
        weights = self._angles.weights(self._fits[material])
        if weights is not self._weights.get(material):
            self._weights[material] = weights
            self.renderer.set_material(material, weights)

    def _factored(self, fit: LobeFit) -> FactoredMaps | None:
        """The maps by which a factored paint's lamps are shaded, made once: an edit of other paints costs nothing."""
        if fit.material.paint is not None:
            return None
        if self._maps is None or self._maps[0] is not fit.reflectance:
            self._maps = (fit.reflectance, maps_of(fit.reflectance))
        return self._maps[1]

    def swatch(self, fit: LobeFit) -> CapturedPaint:
        """Return this paint as a captured form takes it (:meth:`Renderer.capture`), with the same weights."""
        if self._angles.waits:
            self._angles.prepare(fit, self._view)
        return CapturedPaint(self._angles.weights(fit), fit.flakes)

    def set_environment(self, prepared: PreparedEnvironment) -> None:
        """Show this environment; its maps must have been made for the exponents of the paint's fit."""
        maps = prepared.maps
        self.renderer.set_environment(
            EnvironmentMaps(
                exponents=maps.exponents,
                lobes=tuple(_faces(lobe) for lobe in maps.lobes),
                diffuse=_faces(maps.diffuse),
                through_coat=_faces(maps.through_coat),
                background=_faces(maps.background),
            ),
            cache(partial(_distant, prepared)),
        )

    def set_surface(self, mesh: Mesh, baked: BakedMesh | None = None) -> None:
        """Show this surface, with what was baked for it where that is at hand."""
        self.renderer.set_mesh(mesh_parts(mesh, baked))
        light = None if baked is None else baked.ground
        field = None if light is None else GroundField(light.height, light.low, light.high, light.transfer)
        self.renderer.set_ground(field)

    def set_surface_images(self, images: SurfaceImages) -> None:
        """Lay a normal map, a mask and the second paint on the paint, or take them off, from the next frame on."""
        relief = self.renderer.relief
        relief.set_normal_map(images.normal_map)
        relief.set_tangent_map(images.tangent_map)
        relief.set_mask(images.mask)
        if images.second_paint is not None:
            self.set_material(images.second_paint, SECOND_PAINT)

    def draw(self, view: View, framebuffer: Any, size: Size, coarseness: Coarseness = WHOLE) -> None:
        """Draw one frame into ``framebuffer`` (an object of the context, or its number), ``size`` in pixels.

        ``coarseness``: of a frame that must come soon; left out, the picture is whole.
        """
        self.prepare(view)
        if coarseness is WHOLE:
            self.renderer.render(view, framebuffer, size)
            return

        def coarse(target: Any, small: Size) -> None:
            self.renderer.render(view, target, small, coarseness.samples)

        self._enlarger.draw(coarseness.scale, framebuffer, size, coarse)

    def image(self, view: View, size: Size) -> NDArray[np.uint8]:
        """Return a picture ``(height, width, 3)`` uint8 sRGB, top row first."""
        self.prepare(view)
        return self.renderer.render_image(metered(self.renderer, view, size), size)

    def release(self) -> None:
        """Give every OpenGL object back."""
        self._angles.close()
        self.renderer.release()


def mesh_parts(mesh: Mesh, baked: BakedMesh | None = None) -> list[MeshPart]:
    """Return the parts of a mesh as the renderer takes them, with the light that arrives where it was baked."""
    if baked is None:
        return [MeshPart(p.name, p.material, p.positions, p.normals, p.triangles, p.uvs) for p in mesh.parts]
    return [
        MeshPart(p.name, p.material, b.positions, b.normals, b.triangles, b.uvs, b.light)
        for p, b in zip(mesh.parts, baked.parts, strict=True)
    ]


class OffscreenScene(SceneRenderer):
    """A scene with a windowless context of its own; use it with ``with``."""

    def __init__(self) -> None:
        self._context = create_context()
        try:
            super().__init__(self._context)
            self.renderer.only_needed = True
        except BaseException:
            release_context(self._context)
            raise

    def __enter__(self) -> OffscreenScene:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()
        release_context(self._context)


def gl_renderer_name() -> str:
    """Return the name of the OpenGL renderer that pictures are drawn with; GraphicsError where there is none."""
    context = create_context()
    try:
        return str(context.info["GL_RENDERER"])
    finally:
        release_context(context)


def _distant(prepared: PreparedEnvironment) -> DistantLights:
    """The lights that flakes glint in, and the sun; a draft is not worth a search for them."""
    if not prepared.is_final:
        return NO_LIGHTS
    lights = prepared.glint_lights
    return DistantLights(lights.directions, lights.strengths, lights.spreads)


def _faces(array: FaceArray) -> CubeFaces:
    return CubeFaces(array.faces, array.scale)
