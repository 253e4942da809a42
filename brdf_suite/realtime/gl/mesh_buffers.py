"""GPU buffers of a mesh's parts, with the material of each."""

from __future__ import annotations

from collections.abc import Sequence

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.geometry.closed_surface import is_closed_outward
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.values import MeshPart

_ATTRIBUTES = (("position", 3, "f", 4), ("normal", 3, "f", 4), ("uv", 2, "f", 4))
_LIGHT_ATTRIBUTES = (("light_alone", 4, "f2", 2), ("light_grounded", 4, "f2", 2))
_BACK_ATTRIBUTES = (("back_alone", 4, "f2", 2), ("back_grounded", 4, "f2", 2))
_Attributes = tuple[tuple[str, int, str, int], ...]


class MeshBuffers:
    """Positions, normals and texture coordinates interleaved, 32-bit indices; a vertex array per part and program.

    Where the light that arrives is known, it stands in a buffer of its own, in half floats; ``hides_nothing`` says that
    none of it is hidden by the mesh itself, as on a ball.
    """

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._buffers: list[tuple[moderngl.Buffer, moderngl.Buffer, moderngl.Buffer | None]] = []
        self._arrays: dict[moderngl.Program, list[moderngl.VertexArray]] = {}
        self.names: tuple[str, ...] = ()
        self.materials: tuple[str, ...] = ()
        self.has_uv: tuple[bool, ...] = ()
        self.closed: tuple[bool, ...] = ()
        self.two_sided: tuple[bool, ...] = ()
        self.bounds = Bounds.of([])
        self.triangle_count = 0
        self.generation = 0
        self.knows_light = False
        self.hides_nothing = False

    def load(self, parts: Sequence[MeshPart]) -> None:
        """Replace the mesh; an empty sequence draws the background only."""
        self.release()
        self.generation += 1
        self.knows_light = any(part.light is not None for part in parts)
        self.hides_nothing = bool(parts) and all(_sees_all(part) for part in parts)
        for part in parts:
            uvs = np.zeros((len(part.positions), 2), np.float32) if part.uvs is None else part.uvs
            vertices = np.concatenate([part.positions, part.normals, uvs], axis=1)
            light = self._objects.buffer(_light(part).tobytes()) if self.knows_light else None
            buffer = self._objects.buffer
            self._buffers.append((buffer(vertices.tobytes()), buffer(part.triangles.tobytes()), light))
        self.names = tuple(part.name for part in parts)
        self.materials = tuple(part.material for part in parts)
        self.has_uv = tuple(part.uvs is not None for part in parts)
        self.closed = tuple(is_closed_outward(part.positions, part.triangles) for part in parts)
        self.two_sided = tuple(part.light is not None and part.light.shape[1] == 16 for part in parts)
        self.bounds = Bounds.of(part.positions for part in parts)
        self.triangle_count = sum(len(part.triangles) for part in parts)

    def arrays(self, program: moderngl.Program) -> list[moderngl.VertexArray]:
        """Return one vertex array per part for ``program``; made at the first call, kept until the next mesh."""
        if program not in self._arrays:
            self._arrays[program] = []
            for (vertices, indices, light), two_sided in zip(self._buffers, self.two_sided, strict=True):
                content = [_described(program, vertices, _ATTRIBUTES)]
                lit = _LIGHT_ATTRIBUTES + _BACK_ATTRIBUTES if two_sided else _LIGHT_ATTRIBUTES
                if light is not None and any(name in program for name, *_ in lit):
                    content.append(_described(program, light, lit))
                self._arrays[program].append(self._objects.vertex_array(program, content, indices))
        return self._arrays[program]

    def side_words(self, part: int) -> frozenset[str]:
        """Return the word of programs for a part whose back is lit by itself."""
        return frozenset({"TWO_SIDED"}) if self.two_sided[part] else frozenset()

    def forget(self, program: moderngl.Program) -> None:
        """Give back the vertex arrays of a program that goes."""
        for array in self._arrays.pop(program, []):
            self._objects.release(array)

    def release(self) -> None:
        """Give buffers and vertex arrays back."""
        for kept in (*self._arrays.values(), *self._buffers):
            for made in kept:
                self._objects.release(made)
        self._arrays, self._buffers = {}, []
        self.names = self.materials = ()
        self.has_uv = self.closed = self.two_sided = ()


def _described(
    program: moderngl.Program, buffer: moderngl.Buffer, attributes: _Attributes
) -> tuple[object, ...]:
    """Return a buffer as moderngl wants it: with its layout and the names of the attributes in it."""
    # A compiler drops the attributes that a program does not read; their bytes are then stepped over.
    layout = " ".join(
        f"{count}{kind}" if name in program else f"{size * count}x" for name, count, kind, size in attributes
    )
    return (buffer, layout, *(name for name, *_ in attributes if name in program))


_ALL = 0.98
"""Of the light: less, and something is in the way of some of it; baking is right to a hundredth."""


def _sees_all(part: MeshPart) -> bool:
    """Whether nothing of the mesh is in the way of any light that arrives at a part, as far as is known."""
    return part.light is not None and bool((part.light[:, 3] > _ALL).all())


def _light(part: MeshPart) -> NDArray[np.float16]:
    """Return the light that arrives, (n, 8) or (n, 16); that of an open place where it is not known."""
    if part.light is not None:
        return part.light
    # Seen through the cosine, the mean direction of uniform light is two thirds as long as the normal.
    one = np.concatenate([part.normals * (2.0 / 3.0), np.ones((len(part.normals), 1))], axis=1)
    return np.concatenate([one, one], axis=1).astype(np.float16)
