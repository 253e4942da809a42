"""A sphere in a MaterialX surface, drawn by the shader that MaterialX itself generates.

Vertex and pixel shader are those of MaterialX's GLSL generator, as its viewer uses them: the light of an environment is
summed over directions that are drawn from each lobe, each with the mean light of its share of the sphere, and a matt
layer looks up the environment's irradiance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import moderngl
import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.realtime.gl.context import create_context, release_context

DIRECTIONS = 1024
_IRRADIANCE_ROWS = 32


@dataclass(frozen=True)
class GeneratedShader:
    """Sources of a surface's vertex and pixel shader in GLSL 4.0."""

    vertex: str
    pixel: str


def generate_shader(path: Path, *, environment: bool) -> GeneratedShader:
    """Return the shader of the only material of a ``.mtlx`` file, in an environment or under a directional lamp.

    ``ImportError`` where MaterialX is missing.
    """
    import MaterialX
    from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenShader

    library, document = MaterialX.createDocument(), MaterialX.createDocument()
    folders = MaterialX.getDefaultDataSearchPath()
    MaterialX.loadLibraries(MaterialX.getDefaultDataLibraryFolders(), folders, library)
    MaterialX.readFromXmlFile(document, str(path))
    document.importLibrary(library)
    generator = PyMaterialXGenGlsl.GlslShaderGenerator.create()
    colours = PyMaterialXGenShader.DefaultColorManagementSystem.create(generator.getTarget())
    colours.loadLibrary(document)
    generator.setColorManagementSystem(colours)
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(folders)
    methods, options = PyMaterialXGenShader.HwSpecularEnvironmentMethod, context.getOptions()
    options.hwMaxActiveLightSources = 1
    if environment:
        options.hwSpecularEnvironmentMethod = methods.SPECULAR_ENVIRONMENT_FIS
    else:
        options.hwSpecularEnvironmentMethod = methods.SPECULAR_ENVIRONMENT_NONE
        light = document.getNodeDef("ND_directional_light")
        PyMaterialXGenShader.HwShaderGenerator.bindLightShader(light, 1, context)
    (element,) = PyMaterialXGenShader.findRenderableElements(document)
    shader = generator.generate("paint", element, context)
    pixel = shader.getSourceCode(PyMaterialXGenShader.PIXEL_STAGE)
    if "u_refractionTwoSided" in pixel and "bool u_refractionTwoSided" not in pixel:
        # Without an environment, the generator leaves this one to the program that draws.
        head = "#version 400\n"
        pixel = pixel.replace(head, head + "const bool u_refractionTwoSided = false;\n", 1)
    return GeneratedShader(shader.getSourceCode(PyMaterialXGenShader.VERTEX_STAGE), pixel)


def draw_sphere(
    path: Path,
    light: Floats,
    irradiance: Floats,
    size: int,
    *,
    radius: float,
    distance: float,
    width: float,
    directions: int = DIRECTIONS,
) -> Floats:
    """Draw a sphere about the origin in the material of a ``.mtlx`` file.

    Parameters
    ----------
    path
        The file; it holds one material.
    light
        Latitude-longitude map (rows, 2 rows, 3), linear Rec. 709, y up, laid out as the suite's.
    irradiance
        What :func:`irradiance_of` returns of it.
    size
        Pixels of the square picture's side.
    radius, distance, width
        Of the sphere, of the camera on +z from the origin, and what it sees across there, metres.
    directions
        Summed over per lobe and pixel.

    Returns
    -------
    Floats
        Radiance and coverage (size, size, 4), linear Rec. 709.
    """
    shader = generate_shader(path, environment=True)
    context = create_context()
    try:
        program: Any = context.program(vertex_shader=shader.vertex, fragment_shader=shader.pixel)
        values = {
            "u_viewProjectionMatrix": _projection(distance, width).T.astype(np.float32).tobytes(),
            "u_viewPosition": np.array([0.0, 0.0, distance], np.float32).tobytes(),
            "u_envRadianceMips": np.array([len(light).bit_length() + 1], np.int32).tobytes(),
            "u_envRadianceSamples": np.array([directions], np.int32).tobytes(),
        }
        for name, value in values.items():
            if name in program:
                program[name].write(value)
        for place, (name, picture) in enumerate(
            {"u_envRadiance": light, "u_envIrradiance": irradiance}.items()
        ):
            texture = context.texture(
                picture.shape[1::-1], 3, np.ascontiguousarray(picture, np.float32).tobytes(), dtype="f4"
            )
            texture.build_mipmaps()
            texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
            texture.repeat_y = False
            texture.use(place)
            if name in program:
                program[name].value = place
        vertices = context.buffer(_sphere(radius).astype(np.float32).tobytes())
        inputs = [name for name in ("i_position", "i_normal", "i_tangent") if name in program]
        layout = " ".join(
            "3f" if f"i_{name}" in inputs else "3x4" for name in ("position", "normal", "tangent")
        )
        mesh = context.vertex_array(program, [(vertices, layout, *inputs)])
        whole = (size, size)
        target = context.framebuffer(
            [context.renderbuffer(whole, 4, dtype="f4")], context.depth_renderbuffer(whole)
        )
        target.use()
        target.clear()
        context.enable(moderngl.DEPTH_TEST)
        mesh.render(moderngl.TRIANGLES)
        found = np.frombuffer(target.read(components=4, dtype="f4"), np.float32).reshape(size, size, 4)
    finally:
        release_context(context)
    return np.asarray(found[::-1], float)


def _projection(distance: float, width: float) -> Floats:
    """Return view and projection (4, 4) of a camera on +z that looks at the origin."""
    near, far = 0.5 * distance, 2.0 * distance
    across = 2.0 * distance / width
    project = np.zeros((4, 4))
    project[0, 0] = project[1, 1] = across
    project[2, 2:] = -(far + near) / (far - near), -2.0 * far * near / (far - near)
    project[3, 2] = -1.0
    view = np.eye(4)
    view[2, 3] = -distance
    return np.asarray(project @ view)


def _sphere(radius: float, rows: int = 128) -> Floats:
    """Return position, normal and tangent (triangles * 3, 9) of a sphere."""
    theta, phi = np.meshgrid(
        np.linspace(0.0, math.pi, rows + 1), np.linspace(0.0, 2.0 * math.pi, 2 * rows + 1), indexing="ij"
    )
    normal = np.stack((np.sin(theta) * np.sin(phi), np.cos(theta), np.sin(theta) * np.cos(phi)), axis=-1)
    tangent = np.stack((np.cos(phi), np.zeros_like(phi), -np.sin(phi)), axis=-1)
    corners = np.concatenate((radius * normal, normal, tangent), axis=-1)
    first, right, below, last = corners[:-1, :-1], corners[:-1, 1:], corners[1:, :-1], corners[1:, 1:]
    return np.asarray(np.stack((first, below, right, right, below, last), axis=2).reshape(-1, 9))


def irradiance_of(light: Floats) -> Floats:
    """Return the irradiance over π (k, 2 k, 3) of a map (rows, 2 rows, 3), in its layout; it takes seconds."""
    directions, solid = _texels(len(light))
    normals, _ = _texels(_IRRADIANCE_ROWS)
    weighted = (light * solid[:, None, None]).reshape(-1, 3)
    towards = directions.reshape(-1, 3).T
    rows = [np.maximum(line @ towards, 0.0) @ weighted / math.pi for line in normals]
    return np.stack(rows)


def _texels(rows: int) -> tuple[Floats, Floats]:
    """Return the direction of each texel (rows, 2 rows, 3), and the solid angle of those of a row (rows,)."""
    theta = (np.arange(rows) + 0.5) / rows * math.pi
    phi = ((np.arange(2 * rows) + 0.5) / (2 * rows) - 0.5) * 2.0 * math.pi
    down, turn = np.meshgrid(theta, phi, indexing="ij")
    # The centre column looks along +z and u grows towards -x.
    directions = np.stack((-np.sin(down) * np.sin(turn), np.cos(down), np.sin(down) * np.cos(turn)), axis=-1)
    edges = np.cos(np.arange(rows + 1) / rows * math.pi)
    return directions, (edges[:-1] - edges[1:]) * math.pi / rows
