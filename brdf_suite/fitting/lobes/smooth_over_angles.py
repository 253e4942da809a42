"""Non-negative weights at many angles that vary smoothly between angles and use few columns.

    minimize  Σ_n |A_n x_n - b_n|² + μ Σ_n |S (x_n+1 - x_n)|²,   x ≥ 0

A_n and b_n come as their products only. S counts a column by its own size, so that μ has no unit. Solved by gradient
steps with momentum (Nesterov's, begun again where they lead uphill), all angles and channels at once: a step is some
50 µs for 20 angles and 20 columns.

Each column costs drawing time, and many columns are nearly redundant. So the least useful are dropped one by one, by
what their loss adds to the error when the others take over (the surgeon's rule of Hassibi and Stork, 1993: x² over the
diagonal of the inverse), as long as that is little or there are too many.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats

SMOOTHNESS = 1e-3
#: Steps for all columns, and for those that are left after one was dropped.
STEPS, FEWER_STEPS = 1500, 250
#: Columns are dropped until the squared error would rise by more than this share.
MOST_RISE = 0.00005
_UNUSED = 1e9


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
    angles is that of the chain. Columns of no group are always kept; a column of zeros gets no weight.
    """
    size = np.einsum("nkk->nk", squares).mean(axis=0)
    scale = 1.0 / np.sqrt(np.where(size > 0.0, size, np.inf))
    squares = squares * scale[:, None] * scale
    products = products * scale[:, None]
    x = np.zeros(products.shape)
    kept = size > 0.0
    x = _descend(squares, products, x, kept, smoothness, STEPS)
    allowed = (1.0 + MOST_RISE) * _squared_error(squares, products, targets, x)
    while True:
        crowded = [g for g in groups if np.count_nonzero(kept[list(g.columns)]) > g.most]
        candidates = [c for g in (crowded or groups) for c in g.columns if kept[c]]
        if not candidates:
            break
        least = candidates[int(np.argmin(_loss(squares, x, kept)[candidates]))]
        fewer = kept.copy()
        fewer[least] = False
        found = _descend(squares, products, np.where(fewer[:, None], x, 0.0), fewer, smoothness, FEWER_STEPS)
        if not crowded and _squared_error(squares, products, targets, found) > allowed:
            break
        x, kept = found, fewer
    return x * scale[:, None]


def _descend(
    squares: Floats,
    products: Floats,
    x: Floats,
    kept: NDArray[np.bool_],
    smoothness: float,
    steps: int,
) -> Floats:
    largest = float(np.linalg.eigvalsh(squares)[:, -1].max()) + 4.0 * smoothness
    rate = np.where(kept, 1.0 / largest if largest > 0.0 else 0.0, 0.0)[:, None]
    ahead, momentum = x, 1.0
    for _ in range(steps):
        slope = squares @ ahead - products
        if len(ahead) > 1:
            # np.diff takes four times as long for so few numbers.
            step = smoothness * (ahead[1:] - ahead[:-1])
            slope[:-1] -= step
            slope[1:] += step
        following = np.maximum(ahead - rate * slope, 0.0)
        if float(np.vdot(ahead - following, following - x)) > 0.0:  # uphill: without momentum again
            momentum = 1.0
        longer = 0.5 * (1.0 + np.sqrt(1.0 + 4.0 * momentum * momentum))
        ahead = following + (momentum - 1.0) / longer * (following - x)
        x, momentum = following, longer
    return x


def _loss(squares: Floats, x: Floats, kept: NDArray[np.bool_]) -> Floats:
    """Return (k,) by how much the squared error rises without each column, the others adjusted."""
    used = (x > 0.0) & kept[:, None]
    penalty = np.where(used, 1e-9, _UNUSED).transpose(0, 2, 1)
    system = squares[:, None] + penalty[..., None] * np.eye(x.shape[1])
    diagonal = np.einsum("nckk->nkc", np.linalg.inv(system))
    return np.asarray((x**2 / np.maximum(diagonal, 1e-300)).sum(axis=(0, 2)))


def _squared_error(squares: Floats, products: Floats, targets: Floats, x: Floats) -> float:
    return float(targets.sum() - 2.0 * np.vdot(products, x) + np.vdot(x, squares @ x))
