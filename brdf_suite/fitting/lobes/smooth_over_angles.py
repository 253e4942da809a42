"""Non-negative weights at many angles that vary smoothly between angles and use few columns.

    minimize  Σ_n |A_n x_n - b_n|² + μ Σ_n |S (x_n+1 - x_n)|²,   x ≥ 0

A_n and b_n come as their products only. S counts a column by its own size, so that μ has no unit. The channels are
independent of each other. Each is solved by Newton's method with projection (Bertsekas, 1982): the weights that are
positive or would rise are solved for, a block tridiagonal system, and what comes out negative is set to zero; a step
is shortened until the error falls. Where that does not help, as with columns that are nearly redundant, it goes along
the line to the first weight that would become negative. It ends at the optimum after a few steps.

Each column costs drawing time, and many columns are nearly redundant. So the least useful are dropped one by one, by
what their loss adds to the error when the others take over (the surgeon's rule of Hassibi and Stork, 1993: x² over the
diagonal of the inverse), as long as that is little or there are too many.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solveh_banded

from brdf_suite.arrays import Bools, Floats
from brdf_suite.errors import FittingError

SMOOTHNESS = 1e-3
#: Columns are dropped until the squared error would rise by more than this share.
MOST_RISE = 0.00005
_UNUSED = 1e9
#: Added to the diagonal: columns may be redundant.
_RIDGE = 1e-10
#: A weight of zero whose slope is nearer to zero than this would not rise.
_LEVEL = 1e-9
#: Steps and halvings of a step after which the search ends in any case.
_MOST_STEPS, _MOST_HALVINGS = 60, 4


@dataclass(frozen=True)
class ColumnGroup:
    """Columns of which at most ``most`` are kept."""

    columns: Sequence[int]
    most: int


def chained_weights(
    squares: Floats,
    products: Floats,
    targets: Floats,
    groups: Sequence[ColumnGroup] = (),
    smoothness: float = SMOOTHNESS,
) -> Floats:
    """Return the weights (n, k, c) of k columns at n angles for c channels.

    ``squares`` (n, k, k) is A_nᵀA_n, ``products`` (n, k, c) A_nᵀb_n and ``targets`` (n, c) |b_n|²; the order of the
    angles is that of the chain. Columns of no group are always kept; a column of zeros gets no weight. Raises
    :class:`FittingError` where the numbers are too far apart to be solved.
    """
    try:
        return _chained_weights(squares, products, targets, groups, smoothness)
    except np.linalg.LinAlgError as error:
        raise FittingError("The weights over the angles cannot be solved for.") from error


def _chained_weights(
    squares: Floats, products: Floats, targets: Floats, groups: Sequence[ColumnGroup], smoothness: float
) -> Floats:
    size = np.einsum("nkk->nk", squares).mean(axis=0)
    scale = 1.0 / np.sqrt(np.where(size > 0.0, size, np.inf))
    squares = squares * scale[:, None] * scale
    products = products * scale[:, None]
    kept = np.flatnonzero(size > 0.0)
    problem = _Chain(squares[:, kept][:, :, kept], products[:, kept], smoothness)
    x = problem.solve(np.zeros(problem.products.shape))
    allowed = (1.0 + MOST_RISE) * problem.squared_error(x, targets)
    while True:
        crowded = [g for g in groups if np.isin(kept, g.columns).sum() > g.most]
        columns = [c for g in (crowded or groups) for c in g.columns]
        candidates = np.flatnonzero(np.isin(kept, columns))
        if not candidates.size:
            break
        least = int(candidates[np.argmin(_loss(problem.squares, x)[candidates])])
        fewer = problem.without(least)
        found = fewer.solve(np.delete(x, least, axis=1))
        if not crowded and fewer.squared_error(found, targets) > allowed:
            break
        problem, x, kept = fewer, found, np.delete(kept, least)
    weights = np.zeros(products.shape)
    weights[:, kept] = x * scale[kept, None]
    return weights


@dataclass(frozen=True)
class _Chain:
    """The problem of some columns: ``squares`` (n, k, k), ``products`` (n, k, c) and μ."""

    squares: Floats
    products: Floats
    smoothness: float

    def without(self, column: int) -> _Chain:
        """Return the problem of the other columns."""
        others = np.delete(np.arange(self.squares.shape[1]), column)
        return _Chain(self.squares[:, others][:, :, others], self.products[:, others], self.smoothness)

    def squared_error(self, x: Floats, targets: Floats) -> float:
        """Return Σ |A x - b|² of weights (n, k, c)."""
        return float(targets.sum() - 2.0 * np.vdot(self.products, x) + np.vdot(x, self.squares @ x))

    def solve(self, start: Floats) -> Floats:
        """Return the optimum (n, k, c), searched for from weights ``start`` (n, k, c)."""
        bands = self._bands()
        x = np.empty(start.shape)
        for channel in range(start.shape[2] if start.size else 0):
            x[..., channel] = self._solve(bands, start[..., channel], self.products[..., channel])
        return x

    def _solve(self, bands: Floats, x: Floats, products: Floats) -> Floats:
        slope, error = self._judged(x, products)
        for _ in range(_MOST_STEPS):
            free = (x > 0.0) | (slope < -_LEVEL)
            found = self._solved(bands, free, products)
            following = self._projected(x, found - x, products, error)
            if following is None:
                # A weight of zero that would fall holds the others up: without those the line is free to its first
                # bound.
                while (blocked := free & (x == 0.0) & (found < 0.0)).any():
                    free &= ~blocked
                    found = self._solved(bands, free, products)
                falling = (x > 0.0) & (found < x)
                reach = np.divide(x, x - found, out=np.full(x.shape, np.inf), where=falling)
                first = min(float(reach.min()), 1.0)
                following = np.where(reach <= first, 0.0, np.maximum(x + first * (found - x), 0.0))
            slope, reached = self._judged(following, products)
            is_optimum = bool((found >= 0.0).all()) and not ((slope < -_LEVEL) & ~free).any()
            if reached < error:
                x, error = following, reached
            if is_optimum or reached > error:
                break
        return x

    def _projected(self, x: Floats, step: Floats, products: Floats, error: float) -> Floats | None:
        """Return weights of less error along a step, cut off at zero; None where a few halvings find none."""
        for _ in range(_MOST_HALVINGS):
            following = np.maximum(x + step, 0.0)
            if self._judged(following, products)[1] < error:
                return np.asarray(following)
            step = 0.5 * step
        return None

    def _judged(self, x: Floats, products: Floats) -> tuple[Floats, float]:
        """Return the slope (n, k) of half the error at weights (n, k), and the error but for |b|²."""
        slope = self._times(x) - products
        return slope, float(np.vdot(x, slope - products))

    def _solved(self, bands: Floats, free: Bools, products: Floats) -> Floats:
        """Return the solution (n, k) in which only ``free`` (n, k) weights are not zero, of either sign."""
        rows = np.zeros(free.size + len(bands) - 1)
        rows[: free.size] = free.ravel()
        system = bands * rows[: free.size] * np.lib.stride_tricks.sliding_window_view(rows, free.size)
        system[0] += 1.0 - rows[: free.size]
        wanted = np.where(free, products, 0.0).ravel()
        found = solveh_banded(system, wanted, lower=True, overwrite_ab=True, check_finite=False)
        return np.asarray(found.reshape(free.shape))

    def _times(self, x: Floats) -> Floats:
        """Return the system's product with weights (n, k)."""
        found = np.asarray(np.matmul(self.squares, x[..., None])[..., 0] + _RIDGE * x)
        step = self.smoothness * (x[1:] - x[:-1])
        found[:-1] -= step
        found[1:] += step
        return found

    def _bands(self) -> Floats:
        """Return the system's diagonals (k + 1, n·k) from the main one down, as LAPACK takes them."""
        n, k, _ = self.squares.shape
        bands = np.zeros((k + 1, n, k))
        for below in range(k):
            bands[below, :, : k - below] = np.einsum("nii->ni", self.squares[:, below:, : k - below])
        bands[0] += _RIDGE
        bands[0, 1:] += self.smoothness
        bands[0, :-1] += self.smoothness
        bands[k, :-1] = -self.smoothness
        return bands.reshape(k + 1, n * k)


def _loss(squares: Floats, x: Floats) -> Floats:
    """Return (k,) by how much the squared error rises without each column, the others adjusted."""
    penalty = np.where(x > 0.0, 1e-9, _UNUSED).transpose(0, 2, 1)
    system = squares[:, None] + penalty[..., None] * np.eye(x.shape[1])
    diagonal = np.einsum("nckk->nkc", np.linalg.inv(system))
    return np.asarray((x**2 / np.maximum(diagonal, 1e-300)).sum(axis=(0, 2)))
