"""Places and normals of a picture, read back from the graphics card for shading and comparison elsewhere."""

from __future__ import annotations

from dataclasses import dataclass

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Singles
from brdf_suite.documents.view import View
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.programs import assign
from brdf_suite.realtime.gl.shader_source import compose
from brdf_suite.realtime.gl.view_uniforms import columns
from brdf_suite.realtime.pictures.offscreen import Size, check_size
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
    found = []
    with graphics_errors(renderer.context, "reading the geometry of a picture"):
        program = objects.program(compose("mesh.vert.glsl"), compose("probe.frag.glsl"))
        texture, depth = objects.texture((width, height), "f4"), objects.depth((width, height), 0)
        framebuffer = objects.framebuffer(texture, depth)
        assign(program, {"world_to_clip": columns(camera.world_to_clip), "eye": tuple(camera.eye.tolist())})
        framebuffer.use()
        renderer.context.viewport = (0, 0, width, height)
        renderer.context.scissor = None
        renderer.context.enable_only(moderngl.DEPTH_TEST)
        renderer.context.depth_func = "<="
        for as_normal in (False, True):
            framebuffer.clear(0.0, 0.0, 0.0, 0.0, depth=1.0)
            for part, array in enumerate(mesh.arrays(program)):
                assign(program, {"part": part, "as_normal": as_normal})
                array.render(moderngl.TRIANGLES)
            read = np.frombuffer(framebuffer.read(components=4, dtype="f4"), np.float32)
            found.append(read.reshape(height, width, 4)[::-1])
        for made in (framebuffer, texture, depth):
            objects.release(made)
        mesh.forget(program)
        objects.release(program)
    places, normals = found
    return GeometryPicture(
        places[..., :3].copy(),
        normals[..., :3].copy(),
        np.rint(places[..., 3]).astype(np.int64) - 1,
        camera.eye,
    )
