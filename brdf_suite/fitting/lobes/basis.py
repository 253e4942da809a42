"""The fixed set of cosine lobes: their exponents.

The set is fixed because one environment map is prefiltered per exponent; an edit changes weights only
(seed paper, sections 3.2 and 4).
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FittingError

FloatArray = NDArray[np.float64]

#: The default set, chosen by measurement (docs/fit.md): octaves from 1 to 16, where the bell of flake tilts
#: of a metallic paint lies (E of about 5 to 8), then factors of 5 to the clearcoat of 90 gloss units.
DEFAULT_EXPONENTS = (1.0, 2.0, 4.0, 8.0, 16.0, 80.0, 400.0, 2_000.0, 10_000.0, 50_000.0)


@dataclass(frozen=True)
class LobeBasis:
    """Exponents of the cosine lobes ``(R·V)^E``, ascending, each ≥ 1 and all different (no unit).

    >>> LobeBasis((4.0, 16.0)).count
    2

    Raises
    ------
    FittingError
        No exponent, one that is not finite or below 1, or two that are equal or out of order.
    """

    exponents: tuple[float, ...]

    def __post_init__(self) -> None:
        values = tuple(float(e) for e in self.exponents)
        object.__setattr__(self, "exponents", values)
        if not values:
            raise FittingError("The lobe basis is empty; give at least one exponent.")
        for value in values:
            if not (math.isfinite(value) and value >= 1.0):
                raise FittingError(f"The lobe exponent {value:g} is not a finite number of at least 1.")
        for lower, upper in itertools.pairwise(values):
            if upper <= lower:
                raise FittingError(
                    f"The lobe exponents must ascend without repeats, but {upper:g} follows {lower:g}."
                )

    @property
    def count(self) -> int:
        """Number of lobes."""
        return len(self.exponents)

    def array(self) -> FloatArray:
        """The exponents as a new array ``(m,)``."""
        return np.array(self.exponents, dtype=np.float64)


def log_spaced(count: int, low: float, high: float) -> LobeBasis:
    """Return ``count`` exponents from ``low`` to ``high`` in equal ratios.

    The paper's search found exponents "distributed somewhat regularly when graphed in log space" (its
    Figure 2). With ``count`` 1 the basis is ``low`` alone.

    >>> log_spaced(3, 2.0, 200.0).exponents
    (2.0, 20.0, 200.0)
    """
    if count < 1:
        raise FittingError(f"A lobe basis needs at least one lobe, not {count}.")
    if count > 1 and not 1.0 <= low < high:
        raise FittingError(f"Exponents from {low:g} to {high:g} do not ascend from at least 1.")
    steps = [low * (high / low) ** (k / max(count - 1, 1)) for k in range(count)]
    return LobeBasis(tuple(float(f"{e:.12g}") for e in steps))


def default_basis() -> LobeBasis:
    """Return the suite's default exponents; docs/fit.md holds the measurements behind them."""
    return LobeBasis(DEFAULT_EXPONENTS)
