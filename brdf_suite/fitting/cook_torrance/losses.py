"""Loss functions of a residual, and their weights in iteratively reweighted least squares.

For x = log(fit/measured) and a width δ, ``cost`` is c with c(x) = x²/2 near 0, and ``weight`` is c'(x)/x. The parabola
that touches c at x and has this curvature lies above c everywhere, so that a step that lowers it lowers c.

- ``linear``: x²/2.
- ``smooth``: δ²(√(1 + (x/δ)²) - 1), for small δ δ|x|: the paper's |x|, with a derivative at 0.
- ``cauchy``: δ²/2 log(1 + (x/δ)²), whose pull fades for outliers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from brdf_suite.arrays import Floats


@dataclass(frozen=True)
class Cost:
    """A loss function of width ``delta`` > 0 in natural logarithms."""

    kind: Literal["linear", "smooth", "cauchy"]
    delta: float = 1.0

    def __call__(self, x: Floats) -> tuple[Floats, Floats]:
        """Return the cost and the weight of residuals, of their shape."""
        if self.kind == "linear":
            return 0.5 * x * x, np.ones_like(x)
        square = self.delta * self.delta
        z = x * x / square
        if self.kind == "smooth":
            root = np.sqrt(1.0 + z)
            # z / (1 + root) is root - 1 without its cancellation.
            return square * z / (1.0 + root), 1.0 / root
        return 0.5 * square * np.log1p(z), 1.0 / (1.0 + z)
