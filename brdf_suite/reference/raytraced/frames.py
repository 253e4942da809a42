"""Sums over pixels of a scene, traced in pieces and in an order that keeps rays coherent."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.numbers import copy_to_device
from brdf_suite.reference.raytraced.tracer import SampleBudget, TracerScene, trace
from brdf_suite.reference.scene.camera import Pinhole

_TILE = 4
_PIECE_RAYS = 6_000_000
"""Rays of a piece, about: some tenths of a second, after which a caller may stop."""


class Film:
    """The pixels of a picture of ``size`` (width, height), in tiles of four by four: neighbours are traced together."""

    def __init__(self, size: tuple[int, int]) -> None:
        self.size = size
        width, height = size
        row, column = np.divmod(np.arange(width * height), width)
        tile = (row // _TILE) * (-(-width // _TILE)) + column // _TILE
        order = np.lexsort((column % _TILE, row % _TILE, tile))
        self._place = order
        self._column, self._row = column[order].astype(np.uint32), row[order].astype(np.uint32)
        self._pieces: dict[int, list[tuple[slice, Any, Any]]] = {}

    def pieces(self, rays_a_pixel: float) -> list[tuple[slice, Any, Any]]:
        """Return where each piece's pixels are in the order, and their columns and rows."""
        count = len(self._place)
        number = min(max(1, round(count * rays_a_pixel / _PIECE_RAYS)), -(-count // 4096))
        if number not in self._pieces:
            edges = [min(count, -(-count * k // number // 16) * 16) for k in range(number)] + [count]
            self._pieces = {
                number: [
                    (
                        slice(a, b),
                        copy_to_device(self._column[a:b], mi.UInt32),
                        copy_to_device(self._row[a:b], mi.UInt32),
                    )
                    for a, b in pairwise(edges)
                    if b > a
                ]
            }
        return self._pieces[number]

    def unordered(self, values: npt.NDArray[Any]) -> Floats:
        """Return values (n, k), in the order of the pieces, as a picture (h, w, k)."""
        width, height = self.size
        found = np.empty(values.shape, np.float64)
        found[self._place] = values
        return found.reshape(height, width, -1)


def trace_samples(
    stage: TracerScene,
    camera: Pinhole,
    deal: SampleBudget,
    film: Film,
    first: int,
    count: int,
    *,
    rays_a_sample: float,
    between: Callable[[float], None] | None = None,
) -> Floats:
    """Return sums (h, w, 7) over ``count`` samples from number ``first`` on: radiance, coverage, darkness.

    Parameters
    ----------
    rays_a_sample
        About how many rays a sample traces: with many, the picture is traced in more pieces.
    between
        Called after each piece with the share that is done; what it raises ends the tracing.

    Raises
    ------
    ReferenceUnavailableError
        The renderer failed, as it does where memory runs out.
    """
    start, number = dr.opaque(mi.UInt32, first), dr.opaque(mi.UInt32, count)
    pieces = film.pieces(rays_a_sample * count)
    values = np.empty((film.size[0] * film.size[1], 7), np.float32)
    for place, column, row in pieces:
        try:
            found = trace(stage, camera, deal, column, row, start, number)
            dr.eval(found.radiance, found.coverage, found.darkness)
            values[place, :3] = np.array(found.radiance).T
            values[place, 3] = np.array(found.coverage)
            values[place, 4:] = np.array(found.darkness).T
        except (MemoryError, RuntimeError) as error:
            if error.__cause__ is not None and not isinstance(error.__cause__, (MemoryError, RuntimeError)):
                raise  # a fault of the program, which Dr.Jit wraps
            raise ReferenceUnavailableError(
                f"The ray tracer failed ({error}); try a smaller picture, or a lower quality."
            ) from error
        if between is not None:
            between(place.stop / len(values))
    return film.unordered(values)
