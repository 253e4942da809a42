"""Uniform buffer and ramp texture per material, updated in place when weights change."""

from __future__ import annotations

from dataclasses import dataclass, field

import moderngl
import numpy as np

from brdf_suite.documents.view import FresnelMode, LookUp
from brdf_suite.errors import GraphicsError
from brdf_suite.geometry.fresnel import fresnel_dielectric, sheet_reflectance
from brdf_suite.realtime.environment.ladder import Ladder
from brdf_suite.realtime.environment.look_up_table import RAMP_NODES
from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import LookUps
from brdf_suite.realtime.material.ramp import MAX_BROAD, MAX_ROWS, Ramp, make_ramp
from brdf_suite.realtime.material.stock_materials import stock_materials
from brdf_suite.realtime.values import MaterialWeights, WeightsOverAngle

_KINDS = {"none": 0, "dielectric": 1, "metal": 2, "facets": 3, "sheet": 4}


BLOCK_SIZE = (3 + MAX_BROAD) * 16
"""Bytes of the block ``Material`` in material.glsl."""


@dataclass(frozen=True)
class Modes:
    """View settings that the ramps depend on."""

    fresnel: FresnelMode = "raised"
    look_up: LookUp = "shifted"


@dataclass
class MaterialOnGpu:
    """A material on the GPU; ``sharp`` are the exponents that need a map of their own, in binding order.

    ``numbers`` is the ramp that was written, ``transmittance`` what a material that is seen through lets pass.
    """

    buffer: moderngl.Buffer
    ramp: moderngl.Texture
    sharp: tuple[float, ...] = ()
    look_ups: LookUps = field(default=LookUps(0, 1))
    numbers: Ramp | None = None
    transmittance: float = 0.0
    made_for: tuple[MaterialWeights, WeightsOverAngle | None, Modes, Ladder] | None = None


class MaterialSet:
    """Materials by name. A name that was never set is a stock material, or the stock "neutral" grey.

    What is written depends on the view's modes and the environment's exponents: it is computed when a material is
    first drawn with them, for each material that is drawn.
    """

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._weights: dict[str, MaterialWeights] = {}
        self._stock: dict[str, MaterialWeights] = {}
        self._written: dict[str, MaterialOnGpu] = {}
        self._exponents: tuple[float, ...] = ()

    def set_exponents(self, exponents: tuple[float, ...]) -> None:
        """Fit the stock materials to the environment's lobes."""
        if exponents != self._exponents:
            self._exponents = exponents
            self._stock = stock_materials(exponents)

    def set(self, name: str, weights: MaterialWeights) -> None:
        """Take the weights of a material; they are written when it is next drawn."""
        self._weights[name] = weights

    def has(self, name: str) -> bool:
        """Whether weights were set for a material."""
        return name in self._weights

    def find(self, name: str, modes: Modes, ladder: Ladder) -> MaterialOnGpu:
        """Return a material as it is drawn, written where anything has changed.

        Raises
        ------
        GraphicsError
            It has weights on sharp lobes that the environment has no maps of, or on too many.
        """
        weights = self._weights.get(name) or self._stock.get(name) or self._stock["neutral"]
        known = name if name in self._weights or name in self._stock else "neutral"
        if known not in self._written:
            self._written[known] = MaterialOnGpu(
                self._objects.buffer(reserve=BLOCK_SIZE, dynamic=True),
                self._objects.ramp((RAMP_NODES, MAX_ROWS)),
            )
        written = self._written[known]
        table = _table(weights, modes)
        wanted = (weights, table, modes, ladder)
        if written.made_for != wanted:
            self._write(known, written, *wanted)
        if not set(written.sharp) <= set(self._exponents):
            raise GraphicsError(
                f"The material {name} was fitted to {_list(weights.exponents)}, but the environment was "
                f"filtered for {_list(self._exponents)}; fit it again."
            )
        return written

    def _write(
        self,
        name: str,
        written: MaterialOnGpu,
        weights: MaterialWeights,
        over_angle: WeightsOverAngle | None,
        modes: Modes,
        ladder: Ladder,
    ) -> None:
        ramp = make_ramp(weights, modes.fresnel, modes.look_up, ladder, over_angle)
        with graphics_errors(self._objects.context, f"writing the weights of {name}"):
            written.buffer.write(pack(weights, ramp))
            written.ramp.write(ramp.rows, viewport=(0, 0, RAMP_NODES, len(ramp.rows)))
        written.numbers = ramp
        written.transmittance = weights.transmittance
        written.sharp = ramp.sharp
        written.look_ups = LookUps.enough_for(ramp.base + ramp.coat, len(ramp.sharp))
        written.made_for = (weights, over_angle, modes, ladder)
        self._objects.counters.buffer_writes += 1


def _table(weights: MaterialWeights, modes: Modes) -> WeightsOverAngle | None:
    """The weights over the angle that take the place of the single fit in these modes; None: it holds."""
    if weights.by_view is not None and modes.look_up == "shifted" and modes.fresnel != "off":
        return weights.by_view
    return weights.over_angle if modes.fresnel == "multi_angle" else None


def _list(exponents: tuple[float, ...]) -> str:
    return f"{len(exponents)} lobes ({', '.join(f'{e:g}' for e in exponents)})"


def pack(weights: MaterialWeights, ramp: Ramp) -> bytes:
    """Return the block ``Material``: counts of look-ups, coat, the gloss lobes' albedo, the look-ups' directions.

    It holds what does not depend on N·V; the rest is the ramp (:mod:`brdf_suite.realtime.material.ramp`). Its members
    have four components (std140), so that no rule of padding applies.
    """
    block = np.zeros((3 + MAX_BROAD, 4), np.float32)
    counts = (ramp.base, ramp.base + ramp.coat, len(ramp.sharp), 0)
    block[0] = np.array(counts, np.int32).view(np.float32)
    mirrored = sheet_reflectance if weights.coat == "sheet" else fresnel_dielectric
    reflected = float(mirrored(np.cos(weights.theta_fit_rad), weights.ior))
    kind = _KINDS[weights.coat]
    if weights.coat in ("dielectric", "facets", "sheet") and reflected < 1e-6:
        kind = _KINDS["none"]  # no interface: its ratios would be 0/0
    block[1] = (kind, weights.ior, 1.0 / max(reflected, 1e-6), 1.0 / (1.0 - reflected) ** 2)
    solid_angle = 2.0 * np.pi / (np.asarray(weights.exponents) + 1.0)
    albedo = solid_angle @ weights.kg
    block[2, :3] = albedo
    block[2, 3] = 1.0 / max(float(albedo.max()), 1e-6)
    block[3 : 3 + len(ramp.toward_normal)] = ramp.toward_normal
    return block.tobytes()
