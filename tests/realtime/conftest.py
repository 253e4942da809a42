"""A real OpenGL context, and small scenes whose right answer is known."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import moderngl
import numpy as np
import pytest

from brdf_suite.arrays import Floats
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import View
from brdf_suite.realtime.camera import CameraMatrices
from brdf_suite.realtime.gl.context import create_context, release_context
from brdf_suite.realtime.gl.shader_source import SHADERS, compile_program, compose
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps, MaterialWeights, MeshPart

BALL = load_module(Path(__file__).resolve().parents[1] / "benchmarks" / "parts" / "ball.py")
EXPONENTS = (8.0, 200.0, 20000.0)


@pytest.fixture(scope="session")
def session_context() -> Iterator[moderngl.Context]:
    context = create_context()
    yield context
    release_context(context)


@pytest.fixture
def context(session_context: moderngl.Context) -> Iterator[moderngl.Context]:
    """The context, current, and free of errors after the test."""
    with session_context:
        session_context.clear_errors()
        yield session_context
        assert session_context.error == "GL_NO_ERROR"


@pytest.fixture
def renderer(context: moderngl.Context) -> Iterator[Renderer]:
    """A renderer that compiles and uploads what its pictures show, as for a still picture."""
    renderer = Renderer(context)
    renderer.only_needed = True
    yield renderer
    renderer.release()
    assert renderer.counters.live == 0


@pytest.fixture
def prepared(renderer: Renderer) -> None:
    """Let the renderer compile and upload all that an edit may ask for, as in a window."""
    renderer.only_needed = False


@dataclass(frozen=True)
class Scenes:
    """Builders of small scenes."""

    exponents: tuple[float, ...] = EXPONENTS

    @staticmethod
    def directions(size: int) -> Floats:
        """Directions of the texels, written out from table 3.10 of the OpenGL 3.3 specification."""
        a = (np.arange(size) + 0.5) / size * 2 - 1
        s, t = np.meshgrid(a, a)
        one = np.ones_like(s)
        major = [(one, -t, -s), (-one, -t, s), (s, one, t), (s, -one, -t), (s, -t, one), (-s, -t, -one)]
        d = np.stack([np.stack(face, -1) for face in major])
        return d / np.linalg.norm(d, axis=-1, keepdims=True)

    @staticmethod
    def cube(radiance: Floats, scale: float = 1.0) -> CubeFaces:
        return CubeFaces((radiance / scale).astype(np.float16), scale)

    def constant(
        self, value: float = 1.0, size: int = 8, exponents: tuple[float, ...] | None = None
    ) -> EnvironmentMaps:
        """Constant radiance, each map stored at another scale."""
        exponents = exponents or self.exponents
        faces = np.full((6, size, size, 3), value)
        maps = [self.cube(faces, 0.5 + i) for i in range(len(exponents) + 3)]
        return EnvironmentMaps(exponents, tuple(maps[3:]), *maps[:3])

    def from_function(self, radiance: Callable[[Floats], Floats], size: int = 64) -> EnvironmentMaps:
        """The same picture in every map: a mirror in each lobe."""
        faces = self.cube(radiance(self.directions(size)))
        return EnvironmentMaps(self.exponents, (faces,) * len(self.exponents), faces, faces, faces)

    @staticmethod
    def sphere(
        material: str = "paint", radius: float = 0.1, centre: tuple[float, ...] = (0, 0, 0), rings: int = 96
    ) -> MeshPart:
        return BALL.ball(radius, rings, name=f"{material} sphere", material=material, centre=centre)

    @staticmethod
    def sheet(material: str = "paint", half: float = 0.1, centre: tuple[float, ...] = (0, 0, 0)) -> MeshPart:
        """A square that looks along +z."""
        corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * half + np.asarray(centre)
        normals = np.tile([0.0, 0.0, 1.0], (4, 1))
        return MeshPart(f"{material} sheet", material, corners, normals, np.array([[0, 1, 2], [0, 2, 3]]))

    def weights(
        self, kd: float = 0.0, gloss: float = 0.0, directional: float = 0.0, **others: object
    ) -> MaterialWeights:
        """Albedos: of the base, of the sharpest gloss lobe, of the broadest directional-diffuse lobe."""
        m = len(self.exponents)
        kdd, kg = np.zeros((m, 3)), np.zeros((m, 3))
        kdd[0] = directional * (self.exponents[0] + 1) / (2 * np.pi)
        kg[-1] = gloss * (self.exponents[-1] + 1) / (2 * np.pi)
        return MaterialWeights(self.exponents, np.full(3, kd / np.pi), kdd, kg, **others)  # type: ignore[arg-type]

    @staticmethod
    def rays(camera: CameraMatrices, size: tuple[int, int]) -> Floats:
        """Unit directions (h, w, 3) from the eye through the pixel centres, top row first."""
        x = (np.arange(size[0]) + 0.5) / size[0] * 2 - 1
        y = 1 - (np.arange(size[1]) + 0.5) / size[1] * 2
        gx, gy = np.meshgrid(x * camera.half_tangents[0], y * camera.half_tangents[1])
        d = np.stack([gx, gy, -np.ones_like(gx)], -1) @ camera.view_to_world.T
        return d / np.linalg.norm(d, axis=-1, keepdims=True)

    def sphere_normals(
        self, renderer: Renderer, view: View, size: tuple[int, int], radius: float = 0.1
    ) -> tuple[Floats, Floats]:
        """Normals (h, w, 3), NaN off the sphere, and directions to the viewer: the exact sphere at the origin."""
        camera = renderer.camera_matrices(view, size)
        d = self.rays(camera, size)
        b = d @ camera.eye
        root = b * b - (camera.eye @ camera.eye - radius**2)
        t = -b - np.sqrt(np.where(root > 0, root, np.nan))
        return (camera.eye + t[..., None] * d) / radius, -d


@pytest.fixture
def scenes() -> Scenes:
    return Scenes()


@pytest.fixture
def evaluate(context: moderngl.Context, tmp_path: Path) -> Callable[..., Floats]:
    """Evaluate a GLSL expression of ``vec4 x`` for many x (n, 4) with float32 output."""

    def run(include: str, expression: str, x: Floats, **uniforms: object) -> Floats:
        declared = "".join(
            f"uniform {'float' if isinstance(v, float) else 'int'} {k};\n" for k, v in uniforms.items()
        )
        (tmp_path / "probe.frag.glsl").write_text(
            f'#include "{include}"\n{declared}uniform sampler2D points;\nout vec4 fragment;\n'
            "void main() { vec4 x = texelFetch(points, ivec2(gl_FragCoord.xy), 0);\n"
            f"fragment = {expression}; }}\n"
        )
        program = compile_program(
            context, compose("screen.vert.glsl"), compose("probe.frag.glsl", None, (tmp_path, SHADERS))
        )
        size = (len(x), 1)
        points = context.texture(size, 4, np.asarray(x, np.float32).tobytes(), dtype="f4")
        points.filter = (moderngl.NEAREST, moderngl.NEAREST)
        out = context.texture(size, 4, dtype="f4")
        framebuffer = context.framebuffer([out])
        array = context.vertex_array(program, [])
        framebuffer.use()
        context.enable_only(moderngl.NOTHING)
        points.use(0)
        for name, value in uniforms.items():
            program[name] = value
        array.render(moderngl.TRIANGLES, vertices=3)
        result = np.frombuffer(out.read(), np.float32).reshape(-1, 4).astype(np.float64)
        context.detect_framebuffer(0).use()
        for made in (array, framebuffer, out, points, program):
            made.release()
        return result

    return run
