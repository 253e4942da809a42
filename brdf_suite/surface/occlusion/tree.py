"""The tree of boxes around the triangles of a mesh, and the light that places see past them."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.progress import Progress, report

Float32 = NDArray[np.float32]

_PLACES_AT_ONCE = 2048
"""Places in one step of a thread: about 30 ms, so that a cancel is heard soon."""


@dataclass(frozen=True, eq=False)
class Ground:
    """A level floor at ``height`` (m) and the light that it sees: ``share`` (rows along z, columns along x), 0…1.

    ``low`` and ``high`` are the lowest and highest (x, z) of the texels' outer edges, metres.
    """

    height: float
    low: tuple[float, float]
    high: tuple[float, float]
    share: Float32

    @property
    def frame(self) -> NDArray[np.float64]:
        """(4,): lowest x and z, and texels per metre along x and z."""
        rows, columns = self.share.shape
        (x0, z0), (x1, z1) = self.low, self.high
        return np.array([x0, z0, columns / (x1 - x0), rows / (z1 - z0)])


NO_GROUND = Ground(-np.inf, (0.0, 0.0), (1.0, 1.0), np.ones((1, 1), np.float32))


@dataclass(frozen=True, eq=False)
class TriangleTree:
    """Triangles sorted into nested boxes; the arrays are those of :mod:`.compiled_tree`."""

    boxes: Float32
    children: NDArray[np.int32]
    corners: Float32

    @staticmethod
    def of(triangles: NDArray[Any]) -> TriangleTree:
        """Build from corners (k, 3, 3), metres, k ≥ 1."""
        from brdf_suite.surface.occlusion import compiled_tree  # numba takes half a second to import

        points = np.ascontiguousarray(triangles, np.float32)
        count = len(points)
        order = np.arange(count, dtype=np.int32)
        boxes, children = np.empty((count, 12), np.float32), np.empty((count, 4), np.int32)
        nodes = compiled_tree.build(points.min(axis=1), points.max(axis=1), order, boxes, children)
        first, second, third = np.moveaxis(points[order], 1, 0)
        corners = np.concatenate([first, second - first, third - first], axis=1)
        return TriangleTree(boxes[:nodes].copy(), children[:nodes].copy(), corners)

    def gather(
        self,
        points: Float32,
        normals: Float32,
        planes: Float32,
        rays: int,
        ground: Ground = NO_GROUND,
        progress: Progress | None = None,
        what: str = "occlusion",
    ) -> Float32:
        """Return what each place sees, (n, 9): see :func:`.compiled_rays.gather`.

        Raises
        ------
        Cancelled
            ``progress`` asked for it; what runs ends within some hundredths of a second.
        """
        from brdf_suite.surface.occlusion import compiled_rays

        count = len(points)
        result = np.empty((count, 9), np.float32)
        frame, floor = ground.frame, float(ground.height)

        def step(first: int) -> int:
            end = min(first + _PLACES_AT_ONCE, count)
            compiled_rays.gather(
                self.boxes,
                self.children,
                self.corners,
                points[first:end],
                normals[first:end],
                planes[first:end],
                first,
                rays,
                ground.share,
                frame,
                floor,
                result[first:end],
            )
            return end - first

        _in_threads(step, count, progress, what)
        return result

    def leaves(
        self,
        points: Float32,
        directions: NDArray[np.float64],
        turns: NDArray[np.float64],
        progress: Progress | None = None,
        what: str = "occlusion",
    ) -> NDArray[np.uint8]:
        """Return (n, m): 1 where the ray from a point along a direction, turned for that point, hits nothing."""
        from brdf_suite.surface.occlusion import compiled_rays

        result = np.empty((len(points), len(directions)), np.uint8)

        def step(first: int) -> int:
            part = slice(first, min(first + _PLACES_AT_ONCE, len(points)))
            tree = (self.boxes, self.children, self.corners)
            compiled_rays.leaves(*tree, points[part], directions, turns[part], result[part])
            return part.stop - part.start

        _in_threads(step, len(points), progress, what)
        return result


def _in_threads(step: Callable[[int], int], count: int, progress: Progress | None, what: str) -> None:
    """Run ``step(first)`` for all firsts on as many threads as there are processors."""
    done = 0
    with ThreadPoolExecutor(max(1, os.cpu_count() or 1)) as threads:
        steps = [threads.submit(step, first) for first in range(0, count, _PLACES_AT_ONCE)]
        try:
            for waiting in steps:
                done += waiting.result()
                report(progress, done / count, what)
        except BaseException:
            threads.shutdown(cancel_futures=True)
            raise
