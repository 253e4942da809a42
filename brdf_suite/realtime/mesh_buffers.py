"""The parts of a mesh on the GPU, and the material that each is drawn with."""

from __future__ import annotations

from collections.abc import Sequence

import moderngl
import numpy as np

from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.gpu_objects import GpuObjects
from brdf_suite.realtime.values import MeshPart

_ATTRIBUTES = (("position", 3), ("normal", 3), ("uv", 2))


class MeshBuffers:
    """Positions, normals and texture coordinates interleaved, 32-bit indices; a vertex array per part and program."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._buffers: list[tuple[moderngl.Buffer, moderngl.Buffer]] = []
        self._arrays: dict[moderngl.Program, list[moderngl.VertexArray]] = {}
        self.materials: tuple[str, ...] = ()
        self.bounds = Bounds.of([])
        self.triangle_count = 0
        self.generation = 0

    def load(self, parts: Sequence[MeshPart]) -> None:
        """Replace the mesh; an empty sequence draws the background only."""
        self.release()
        self.generation += 1
        for part in parts:
            uvs = np.zeros((len(part.positions), 2), np.float32) if part.uvs is None else part.uvs
            vertices = np.concatenate([part.positions, part.normals, uvs], axis=1)
            self._buffers.append(
                (self._objects.buffer(vertices.tobytes()), self._objects.buffer(part.triangles.tobytes()))
            )
        self.materials = tuple(part.material for part in parts)
        self.bounds = Bounds.of(part.positions for part in parts)
        self.triangle_count = sum(len(part.triangles) for part in parts)

    def arrays(self, program: moderngl.Program) -> list[moderngl.VertexArray]:
        """Return one vertex array per part for ``program``; made at the first call, kept until the next mesh."""
        if program not in self._arrays:
            # A compiler drops the attributes that a program does not read; their bytes are then stepped over.
            known = [(name, count) for name, count in _ATTRIBUTES if name in program]
            layout = " ".join(
                f"{count}f" if name in program else f"{4 * count}x" for name, count in _ATTRIBUTES
            )
            names = [name for name, _ in known]
            self._arrays[program] = [
                self._objects.vertex_array(program, [(vertices, layout, *names)], indices)
                for vertices, indices in self._buffers
            ]
        return self._arrays[program]

    def release(self) -> None:
        """Give buffers and vertex arrays back."""
        for arrays in self._arrays.values():
            for array in arrays:
                self._objects.release(array)
        self._arrays = {}
        for pair in self._buffers:
            for buffer in pair:
                self._objects.release(buffer)
        self._buffers = []
        self.materials = ()
