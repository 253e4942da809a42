"""The shader that MaterialX generates of a document, run by OpenGL at one point."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.realtime.gl.context import create_context, release_context
from tools.evaluation.materialx_picture import generate_shader

_ONE_POINT = """#version 400
out VertexData { %s } vd;
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
    vec3 normalWorld = vec3(0.0, 0.0, 1.0), tangentWorld = vec3(1.0, 0.0, 0.0);
    vec3 bitangentWorld = vec3(0.0, 1.0, 0.0);
    vec3 positionWorld = vec3(1e-3 * corner, 0.0);  // not all the same: a derivative divides by its change
    %s
}
"""
"""To be completed with what the pixel's shader takes, and its values."""

ANGLES = np.array([(45.0, 15.0), (45.0, 45.0), (45.0, 75.0), (45.0, 110.0), (20.0, 30.0), (65.0, 60.0)])
"""Of the light, and of the view from the mirror direction, degrees."""


class Shader:
    """A program that shades one point."""

    def __init__(self, gl: Any, path: Path) -> None:
        pytest.importorskip("MaterialX")
        source = generate_shader(path, environment=False).pixel
        taken = re.findall(r"vec3 (\w+);", source[source.index("in VertexData") :].split("}")[0])
        declared = " ".join(f"vec3 {name};" for name in taken)
        vertex = _ONE_POINT % (declared, " ".join(f"vd.{name} = {name};" for name in taken))
        self._gl = gl
        self.program = gl.program(vertex_shader=vertex, fragment_shader=source)
        self._target = gl.framebuffer([gl.texture((2, 2), 4, dtype="f4")])
        self._points = gl.vertex_array(self.program, [])
        self.program["u_numActiveLightSources"].value = 1
        self.program["u_lightData[0].type"].value = 1
        self.program["u_lightData[0].color"].value = (1.0, 1.0, 1.0)
        self.program["u_lightData[0].intensity"].value = 1.0
        members = {name: self.program[name] for name in self.program if "[" not in name}
        self._defaults = {name: member.value for name, member in members.items() if hasattr(member, "value")}

    def set(self, inputs: dict[str, Any]) -> None:
        """Give the shader these inputs, and the others their defaults."""
        for name, value in (self._defaults | inputs).items():
            self.program[name].value = value

    def shade(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Directions (n, 3) to light and view, and the light (n, 3) that is reflected."""
        wi, wo = illumination(ANGLES[:, 0]), aspecular_view(ANGLES[:, 0], ANGLES[:, 1])
        found = []
        for to_light, to_view in zip(wi, wo, strict=True):
            self.program["u_viewPosition"].value = tuple(1e3 * to_view)
            self.program["u_lightData[0].direction"].value = tuple(-to_light)
            self._target.use()
            self._points.render(self._gl.TRIANGLES, vertices=3)
            found.append(np.frombuffer(self._target.read(components=3, dtype="f4"), np.float32)[:3])
        return wi, wo, np.array(found)


@contextmanager
def open_shader(path: Path) -> Iterator[Shader]:
    """Yield the shader that MaterialX generates of a document."""
    gl = create_context()
    try:
        yield Shader(gl, path)
    finally:
        release_context(gl)


def shade(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Directions (n, 3) to light and view, and the light (n, 3) that MaterialX's shader of the file reflects."""
    with open_shader(path) as shader:
        return shader.shade()
