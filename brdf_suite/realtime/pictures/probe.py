"""Geometry of a picture, and the probe of one pixel: its radiance, and the surface point in it.

A tile of two by two pixels is drawn again, with the samples and derivatives of the whole picture, so that no frame
has to be kept, nor read, as a whole.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Singles, triple
from brdf_suite.documents.view import View
from brdf_suite.geometry.directions import angle_between
from brdf_suite.realtime.camera import crop
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import Size, Target
from brdf_suite.realtime.gl.programs import assign, columns
from brdf_suite.realtime.gl.shader_source import compose
from brdf_suite.realtime.pictures.light_pass import AS_THEY_ARE, check_size
from brdf_suite.realtime.pictures.renderer import Renderer


@dataclass(frozen=True, eq=False)
class GeometryPicture:
    """Surface positions and normals at pixel centres, top row first.

    ``positions`` and ``normals`` (h, w, 3): world metres, and unit vectors on the side that is seen, as the shaders
    have them; ``parts`` (h, w): number of the mesh's part, -1 past the surface. ``eye`` (3,): the camera.
    """

    positions: Singles
    normals: Singles
    parts: NDArray[np.int64]
    eye: NDArray[np.float64]


def geometry_picture(renderer: Renderer, view: View, size: Size) -> GeometryPicture:
    """Draw the renderer's mesh as ``view`` sees it and return its geometry; errors as of the renderer."""
    width, height = check_size(size)
    objects, mesh = renderer.objects, renderer.mesh
    camera = renderer.camera_matrices(view, (width, height))
    with graphics_errors(renderer.context, "reading the geometry of a picture"):
        program = objects.program(compose("mesh.vert.glsl"), compose("probe.frag.glsl"))
        target = Target(objects, has_depth=True)
        framebuffer, _ = target.prepare((width, height), "f4")
        places, normals = _draw_geometry(renderer, program, framebuffer, camera.world_to_clip, camera.eye)
        target.release()
        mesh.forget(program)
        objects.release(program)
    return GeometryPicture(
        places[..., :3].copy(),
        normals[..., :3].copy(),
        np.rint(places[..., 3]).astype(np.int64) - 1,
        camera.eye,
    )


def _draw_geometry(
    renderer: Renderer,
    program: moderngl.Program,
    framebuffer: moderngl.Framebuffer,
    world_to_clip: Floats,
    eye: Floats,
) -> tuple[Singles, Singles]:
    """Return (h, w, 4) each, top row first: position and part from 1, normal; 0 past the surface."""
    width, height = framebuffer.size
    found = []
    for as_normal in (False, True):
        _draw_quantity(renderer, program, framebuffer, world_to_clip, eye, as_normal=as_normal)
        read = np.frombuffer(framebuffer.read(components=4, dtype="f4"), np.float32)
        found.append(read.reshape(height, width, 4)[::-1])
    return found[0], found[1]


def _draw_quantity(
    renderer: Renderer,
    program: moderngl.Program,
    framebuffer: moderngl.Framebuffer,
    world_to_clip: Floats,
    eye: Floats,
    *,
    as_normal: bool,
) -> None:
    assign(program, {"world_to_clip": columns(world_to_clip), "eye": tuple(eye.tolist())})
    renderer.objects.bind(framebuffer, framebuffer.size, depth=True)
    framebuffer.clear(0.0, 0.0, 0.0, 0.0, depth=1.0)
    for part, array in enumerate(renderer.mesh.arrays(program)):
        assign(program, {"part": part, "as_normal": as_normal})
        array.render(moderngl.TRIANGLES)


_TILE = (2, 2)
Vector = tuple[float, float, float]


@dataclass(frozen=True)
class SurfacePoint:
    """A point of the surface, in world metres, y up; ``normal`` and ``to_viewer`` are unit vectors."""

    position: Vector
    normal: Vector
    to_viewer: Vector
    part: str
    material: str

    @property
    def view_angle_deg(self) -> float:
        """The angle between the normal and the viewer, 0…90."""
        return float(np.degrees(angle_between(self.normal, self.to_viewer)))

    def aspecular_deg(self, to_light: Vector) -> float | None:
        """The angle between the mirror direction of a light and the viewer; None where it does not reach the surface.

        ``to_light`` is a unit vector. The angle is 0…180 and has no sign: view and light seldom lie in one plane
        with the normal.
        """
        n, light = np.asarray(self.normal), np.asarray(to_light)
        cosine = float(n @ light)
        if cosine <= 0.0:
            return None
        return float(np.degrees(angle_between(2.0 * cosine * n - light, self.to_viewer)))


@dataclass(frozen=True)
class RadianceProbe:
    """``radiance``: mean of the pixel's samples, linear Rec. 2020, before exposure and tone curve.

    ``coverage`` is the object's share of the pixel, ``point`` what is in its middle; None past the surface.
    """

    radiance: Vector
    coverage: float
    point: SurfacePoint | None


class PixelProbe:
    """Reads pixels in the context of a renderer; errors as of the renderer."""

    def __init__(self, renderer: Renderer) -> None:
        self._renderer = renderer
        self._objects = renderer.objects
        self._program: moderngl.Program | None = None
        self._target = Target(self._objects, has_depth=True)
        self._whole = Target(self._objects, has_depth=True)

    def parts(self, view: View, size: Size) -> NDArray[np.int32]:
        """Return which part of the mesh the middle of each pixel of a picture shows, (h, w), top row first; -1 none."""
        width, height = check_size(size)
        camera = self._renderer.camera_matrices(view, (width, height))
        with graphics_errors(self._renderer.context, "looking for the parts in the picture"):
            framebuffer, _ = self._whole.prepare((width, height), "f4")
            program = self._geometry_program()
            _draw_quantity(
                self._renderer, program, framebuffer, camera.world_to_clip, camera.eye, as_normal=False
            )
            read = np.frombuffer(framebuffer.read(components=4, dtype="f4"), np.float32)
        numbers = read.reshape(height, width, 4)[::-1, :, 3]
        return np.rint(numbers).astype(np.int32) - 1

    def at(
        self,
        view: View,
        size: Size,
        pixel: tuple[int, int],
        *,
        materials: Mapping[str, str] = AS_THEY_ARE,
    ) -> RadianceProbe:
        """Return what the pixel (column, row from the top) of a picture of ``size`` shows."""
        width, height = check_size(size)
        column = min(max(pixel[0], 0), width - 1)
        row = height - 1 - min(max(pixel[1], 0), height - 1)
        corner = (column // 2 * 2, row // 2 * 2)
        inside = (1 - (row - corner[1]), column - corner[0])
        tile = self._renderer.linear_tile(view, (width, height), corner, _TILE, materials=materials)
        light = tile[inside]
        places, normals = self._geometry(view, (width, height), corner)
        point = self._point(view, (width, height), places[inside], normals[inside])
        return RadianceProbe(triple(light[:3]), float(light[3]), point)

    def _point(
        self, view: View, size: Size, place: NDArray[np.float32], normal: NDArray[np.float32]
    ) -> SurfacePoint | None:
        part = round(float(place[3])) - 1
        if part < 0:
            return None
        eye = self._renderer.camera_matrices(view, size).eye
        to_viewer = eye - place[:3]
        mesh = self._renderer.mesh
        name = mesh.names[part]
        chosen = view.surface_look.chosen
        return SurfacePoint(
            triple(place[:3]),
            triple(normal[:3]),
            triple(to_viewer / np.linalg.norm(to_viewer)),
            name,
            chosen.get(name, mesh.materials[part]),
        )

    def _geometry(
        self, view: View, size: Size, corner: tuple[int, int]
    ) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Return two tiles (2, 2, 4), top row first: position and part from 1, normal; 0 past the surface."""
        camera = self._renderer.camera_matrices(view, size)
        cropped = crop(size, corner, _TILE) @ camera.world_to_clip
        with graphics_errors(self._renderer.context, "looking for the surface under the cursor"):
            framebuffer, _ = self._target.prepare(_TILE, "f4")
            return _draw_geometry(self._renderer, self._geometry_program(), framebuffer, cropped, camera.eye)

    def _geometry_program(self) -> moderngl.Program:
        if self._program is None:
            self._program = self._objects.program(compose("mesh.vert.glsl"), compose("probe.frag.glsl"))
        return self._program
