"""One uniform buffer per material. A change of weights writes the buffer and makes nothing."""

from __future__ import annotations

import moderngl

from brdf_suite.errors import GraphicsError
from brdf_suite.realtime.context import graphics_errors
from brdf_suite.realtime.gpu_objects import GpuObjects
from brdf_suite.realtime.material_buffer import BLOCK_SIZE, pack
from brdf_suite.realtime.stock_materials import stock_materials
from brdf_suite.realtime.values import MaterialWeights


class MaterialSet:
    """Materials by name. A name that was never set is a stock material, or the stock "neutral" grey."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._buffers: dict[str, moderngl.Buffer] = {}
        self._lobes: dict[str, tuple[int, ...]] = {}
        self._given: dict[str, tuple[float, ...]] = {}
        self._exponents: tuple[float, ...] = ()

    def set_exponents(self, exponents: tuple[float, ...]) -> None:
        """Fit the stock materials to the environment's lobes."""
        if exponents == self._exponents:
            return
        self._exponents = exponents
        for name, weights in stock_materials(exponents).items():
            if name not in self._given:
                self._write(name, weights)

    def set(self, name: str, weights: MaterialWeights) -> None:
        """Write the weights of a material."""
        self._given[name] = weights.exponents
        self._write(name, weights)

    def find(self, name: str) -> tuple[moderngl.Buffer, tuple[int, ...]]:
        """Return a material's buffer and the lobes in it.

        Raises
        ------
        GraphicsError
            Its weights are for other lobes than the environment's.
        """
        if self._given.get(name, self._exponents) != self._exponents:
            raise GraphicsError(
                f"The material {name} was fitted to {_list(self._given[name])}, but the environment was "
                f"filtered for {_list(self._exponents)}; fit it again."
            )
        known = name if name in self._buffers else "neutral"
        return self._buffers[known], self._lobes[known]

    def _write(self, name: str, weights: MaterialWeights) -> None:
        # Room for any number of lobes, so that a change of the lobe set makes no buffer either.
        if name not in self._buffers:
            self._buffers[name] = self._objects.buffer(reserve=BLOCK_SIZE, dynamic=True)
        packed = pack(weights)
        with graphics_errors(self._objects.context, f"writing the weights of {name}"):
            self._buffers[name].write(packed.block)
        self._lobes[name] = packed.lobes
        self._objects.counters.buffer_writes += 1


def _list(exponents: tuple[float, ...]) -> str:
    return f"{len(exponents)} lobes ({', '.join(f'{e:g}' for e in exponents)})"
