"""A fit over a lobe grid, whole and in its parts: diffuse, directional-diffuse and gloss, lobe by lobe.

    f_r = KD + Σ KDD_i (R·V)^E_i + Σ KG_i (R·V)^E_i / (N·L)

All lobes share R·V, so each costs one exponential a point: (R·V)^E = exp(E ln(R·V)).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Singles
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.inspection.lobe_surface.grid import LobeGrid

FitPart = Literal["diffuse", "directional", "gloss"]
FIT_PARTS: tuple[FitPart, ...] = ("diffuse", "directional", "gloss")
PART_CODES: dict[FitPart, tuple[int, int, int]] = {
    "diffuse": (0, 158, 115),
    "directional": (86, 180, 233),
    "gloss": (230, 159, 0),
}
"""The parts' colours, sRGB codes: three of Okabe and Ito's."""

_LEAST = 1e-300


@dataclass(frozen=True)
class FitLobe:
    """One lobe of a fit: its part, its place among the exponents (0 for diffuse), exponent and weight.

    ``exponent`` is None for the diffuse part, which has none. ``weight`` is linear Rec. 2020; in 1/sr, of the gloss
    without the cosine's share (see :class:`LobeWeights`).
    """

    part: FitPart
    index: int
    exponent: float | None
    weight: tuple[float, float, float]

    @property
    def key(self) -> tuple[FitPart, int]:
        """Part and index."""
        return self.part, self.index


def fit_lobes(weights: LobeWeights) -> tuple[FitLobe, ...]:
    """Return the lobes of a fit that have any weight, diffuse first, then by part and rising exponent."""
    rows: list[FitLobe] = [FitLobe("diffuse", 0, None, _triple(weights.kd))]
    order = np.argsort(weights.exponents, kind="stable").tolist()
    tables: tuple[tuple[FitPart, npt.NDArray[np.float64]], ...] = (
        ("directional", weights.kdd),
        ("gloss", weights.kg),
    )
    for part, table in tables:
        rows += [FitLobe(part, i, float(weights.exponents[i]), _triple(table[i])) for i in order]
    return tuple(row for row in rows if any(row.weight))


@dataclass(frozen=True, eq=False)
class FitOnGrid:
    """The values of a fit at a grid's directions; powers are kept, so that lobes can be switched for nothing."""

    weights: LobeWeights
    grid: LobeGrid

    @cached_property
    def _logarithm(self) -> npt.NDArray[np.float64]:
        cosine = self.grid.directions @ self.grid.mirror
        return np.asarray(np.log(np.clip(cosine, _LEAST, 1.0)))

    @cached_property
    def _powers(self) -> dict[float, Singles]:
        return {}

    def _power(self, exponent: float) -> Singles:
        if exponent not in self._powers:
            self._powers[exponent] = np.exp(exponent * self._logarithm).astype(np.float32)
        return self._powers[exponent]

    def brdf(self, lobes: Iterable[FitLobe] | None = None) -> Singles:
        """Return f_r (rows, columns, 3), 1/sr, of some lobes, or of all; the light's cosine is not in it."""
        lobes = fit_lobes(self.weights) if lobes is None else lobes
        total = np.zeros((*self.grid.shape, 3), np.float32)
        cosine = float(self.grid.wi[2])
        # What shares an exponent shares its power.
        by_exponent: dict[float | None, npt.NDArray[np.float64]] = {}
        for lobe in lobes:
            weight = np.array(lobe.weight) / (cosine if lobe.part == "gloss" else 1.0)
            by_exponent[lobe.exponent] = by_exponent.get(lobe.exponent, np.zeros(3)) + weight
        for exponent, weight in by_exponent.items():
            single = weight.astype(np.float32)
            total += single if exponent is None else self._power(exponent)[..., None] * single
        return total


def _triple(row: npt.NDArray[np.float64]) -> tuple[float, float, float]:
    return float(row[0]), float(row[1]), float(row[2])
