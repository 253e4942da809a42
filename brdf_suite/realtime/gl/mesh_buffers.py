"""GPU buffers of a mesh's parts, with the material of each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.geometry.closed_surface import is_closed_outward
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.values import MeshPart

_ATTRIBUTES = (("position", 3, "f", 4), ("normal", 3, "f", 4), ("uv", 2, "f", 4))
_LIGHT_ATTRIBUTES = (("light_alone", 4, "f2", 2), ("light_grounded", 4, "f2", 2))
_GAP_ATTRIBUTES = (("across", 4, "f", 4),)
_BACK_ATTRIBUTES = (("back_alone", 4, "f2", 2), ("back_grounded", 4, "f2", 2))
_Attributes = tuple[tuple[str, int, str, int], ...]


class MeshBuffers:
    """Positions, normals and texture coordinates interleaved, 32-bit indices; a vertex array per part and program.

    Where the light that arrives is known, it stands in a buffer of its own, in half floats; ``hides_nothing`` says that
    none of it is hidden by the mesh itself, as on a ball. ``middles`` (n, 3) are the middles of the parts' boxes,
    metres; ``gaps`` has half the width, metres, of the parts that are gaps.
    """

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._buffers: list[tuple[moderngl.Buffer, moderngl.Buffer, moderngl.Buffer | None]] = []
        self._arrays: dict[moderngl.Program, list[moderngl.VertexArray]] = {}
        self.names: tuple[str, ...] = ()
        self.materials: tuple[str, ...] = ()
        self.middles: NDArray[np.float64] = np.zeros((0, 3))
        self.gaps: dict[int, float] = {}
        self._across: dict[int, moderngl.Buffer] = {}
        self._lines: dict[int, moderngl.VertexArray] = {}
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
            triangles = in_clusters(part.positions, part.triangles)
            self._buffers.append((buffer(vertices.tobytes()), buffer(triangles.tobytes()), light))
            if (
                part.material == "gap"
                and part.uvs is not None
                and np.abs(part.uvs[:, 0]).max(initial=0.0) > 0.0
            ):
                across = across_gap(part.positions, part.triangles, part.uvs[:, 0])
                self._across[len(self._buffers) - 1] = buffer(across.tobytes())
                self.gaps[len(self._buffers) - 1] = 1e-3 * float(np.abs(part.uvs[:, 0]).max())
        boxes = [0.5 * (p.positions.min(axis=0) + p.positions.max(axis=0)) for p in parts]
        self.middles = np.array(boxes, np.float64).reshape(-1, 3)
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

    def line(self, program: moderngl.Program, part: int) -> moderngl.VertexArray:
        """Return the vertex array by which ``program``, one and always the same, draws a gap as a line."""
        if part not in self._lines:
            vertices, indices, _ = self._buffers[part]
            content = [
                _described(program, vertices, _ATTRIBUTES),
                _described(program, self._across[part], _GAP_ATTRIBUTES),
            ]
            self._lines[part] = self._objects.vertex_array(program, content, indices)
        return self._lines[part]

    def side_words(self, part: int) -> frozenset[str]:
        """Return the word of programs for a part whose back is lit by itself."""
        return frozenset({"TWO_SIDED"}) if self.two_sided[part] else frozenset()

    def forget(self, program: moderngl.Program) -> None:
        """Give back the vertex arrays of a program that goes."""
        for array in self._arrays.pop(program, []):
            self._objects.release(array)

    def release(self) -> None:
        """Give buffers and vertex arrays back."""
        lines, across = list(self._lines.values()), list(self._across.values())
        for kept in (*self._arrays.values(), lines, *self._buffers, across):
            for made in kept:
                self._objects.release(made)
        self._arrays, self._buffers = {}, []
        self._across, self._lines, self.gaps = {}, {}, {}
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


_CELLS = 1024
_BITS = np.arange(10)
_SPREAD_BITS = (((np.arange(_CELLS)[:, None] >> _BITS) & 1) << 3 * _BITS).sum(axis=1)
"""By a number below 1,024: its bits, with room for two more between each."""


def in_clusters(positions: NDArray[Any], triangles: NDArray[Any]) -> NDArray[Any]:
    """Return ``triangles`` (k, 3) along a curve that fills space (Morton 1966), so that neighbours follow each other.

    The corners that they share are then worked out once; a software renderer takes most of its time for them in a small
    picture.
    """
    low = positions.min(axis=0)
    step = float((positions.max(axis=0) - low).max()) / (_CELLS - 1) or 1.0
    x, y, z = ((positions - low) / step).astype(np.intp).T
    along = _SPREAD_BITS[x] | _SPREAD_BITS[y] << 1 | _SPREAD_BITS[z] << 2
    return triangles[np.argsort(along[triangles[:, 0]], kind="stable")]


def across_gap(
    positions: NDArray[Any], triangles: NDArray[Any], across_mm: NDArray[Any]
) -> NDArray[np.float32]:
    """Return (n, 4): at each point of a gap the unit direction across it, and how far across the point lies, mm.

    ``across_mm`` (n,) is the signed distance from the gap's middle; it grows along the direction.
    """
    p, u = positions.astype(np.float64)[triangles], across_mm.astype(np.float64)[triangles]
    normal = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
    # Twice the area times the gradient of u in the triangle's plane.
    opposite = np.roll(p, 1, axis=1) - np.roll(p, -1, axis=1)
    grown = (np.cross(normal[:, None], opposite) * u[..., None]).sum(axis=1)
    total = np.zeros((len(positions), 3))
    for corner in range(3):
        np.add.at(total, triangles[:, corner], grown)
    total /= np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-30)
    return np.concatenate([total, across_mm[:, None]], axis=1).astype(np.float32)


_ALL = 0.98
"""Of the light: less, and something is in the way of some of it; baking is right to a hundredth."""


def _sees_all(part: MeshPart) -> bool:
    """Whether nothing of the mesh is in the way of any light that arrives at a part, as far as is known."""
    return part.light is not None and bool((part.light[:, 3::8] > _ALL).all())


def _light(part: MeshPart) -> NDArray[np.float16]:
    """Return the light that arrives, (n, 8) or (n, 16); that of an open place where it is not known."""
    if part.light is not None:
        return part.light
    # Seen through the cosine, the mean direction of uniform light is two thirds as long as the normal.
    one = np.concatenate([part.normals * (2.0 / 3.0), np.ones((len(part.normals), 1))], axis=1)
    return np.concatenate([one, one], axis=1).astype(np.float16)
