"""The samples of a fit: checked, and few enough, spread over θh and over θd.

Most bins of a table, and most samples of a gonioreflectometer, lie far from the peak; and θd alone tells the lobes'
Fresnel reflectance from their weight (section 4.2 of Günther et al. 2005 samples its table by θh for that reason).
So where there are more than a fit needs, they are taken by turns from the cells of a grid over √θh and θd.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.errors import FittingError
from brdf_suite.geometry.directions import Floats

Bools = npt.NDArray[np.bool_]
Places = npt.NDArray[np.intp]

CELLS = (60, 30)
"""Cells along √θh and along θd."""


@dataclass(frozen=True, eq=False)
class LobeSamples:
    """What a fit looks at.

    ``wi``, ``wo`` (n, 3) unit directions; ``logs`` (3, n) natural logarithms of f_r in 1/sr, 0 where ``known`` (3, n)
    is false; ``weights`` (n,) > 0 with mean 1; ``left_out``: how many were not finite, beyond the grazing angle, of no
    weight or black in every channel; ``black``: how many values (of one channel) were not positive.
    """

    wi: Floats
    wo: Floats
    logs: Floats
    known: Bools
    weights: Floats
    left_out: int
    black: int

    def __len__(self) -> int:
        return len(self.wi)

    @property
    def channels(self) -> Bools:
        """Return (3,): in which channels there is anything."""
        return np.asarray(self.known.any(axis=1))

    def part(self, keep: npt.ArrayLike) -> LobeSamples:
        """Return some of them: a mask (n,) or indices."""
        at = np.asarray(keep)
        return LobeSamples(
            self.wi[at],
            self.wo[at],
            self.logs[:, at],
            self.known[:, at],
            self.weights[at],
            self.left_out,
            self.black,
        )

    def fewer(self, most: int, seed: int) -> LobeSamples:
        """Return at most ``most`` of them, spread over θh and θd."""
        if len(self) <= most:
            return self
        return self.part(spread(*half_and_difference(self.wi, self.wo), most, seed))


def checked_samples(
    wi: npt.ArrayLike,
    wo: npt.ArrayLike,
    values: npt.ArrayLike,
    weights: npt.ArrayLike | None = None,
    grazing_deg: float = 90.0,
) -> LobeSamples:
    """Return the samples that a fit of logarithms can use.

    Parameters
    ----------
    wi, wo
        (n, 3) unit directions, local frame.
    values
        (n, 3) f_r in 1/sr. Not finite ones, and those of 0 or less, have no logarithm and are left out.
    weights
        (n,) how much each counts, at least 0; all alike if left out.

    Raises
    ------
    FittingError
        A shape does not fit, directions are not finite unit vectors, weights are negative or not finite, or nothing
        is left.
    """
    light, view = _directions("wi", wi), _directions("wo", wo)
    data = np.asarray(values, np.float64)
    if len(light) != len(view) or data.shape != (len(light), 3):
        raise FittingError(
            f"The samples do not fit together: wi {light.shape}, wo {view.shape}, values {data.shape}; "
            "(n, 3) of each is wanted."
        )
    share = np.ones(len(light)) if weights is None else np.asarray(weights, np.float64)
    if share.shape != (len(light),) or not np.all(np.isfinite(share)) or np.any(share < 0.0):
        raise FittingError(f"The weights must be {len(light)} finite numbers, none negative.")
    lowest = max(np.cos(np.radians(grazing_deg)), 1e-6)
    seen = (light[:, 2] >= lowest) & (view[:, 2] >= lowest) & (share > 0.0)
    known = np.isfinite(data) & (data > 0.0)
    used = seen & known.any(axis=1) & np.isfinite(data).all(axis=1)
    count = int(used.sum())
    if count == 0:
        raise FittingError(
            f"None of the {len(light):,} samples can be fitted: they are black, not finite, without weight, or seen "
            f"at more than {grazing_deg:g}° from the normal."
        )
    kept = known[used].T
    logs = np.zeros(kept.shape)
    np.log(data[used].T, out=logs, where=kept)
    chosen = share[used]
    return LobeSamples(
        light[used],
        view[used],
        logs,
        np.ascontiguousarray(kept),
        chosen / chosen.mean(),
        len(light) - count,
        int(np.count_nonzero(~kept)),
    )


def half_and_difference(wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
    """Return θh and θd (n,), radians, exact also where they are tiny."""
    total, apart = wi + wo, wi - wo
    theta_h = np.arctan2(np.hypot(total[:, 0], total[:, 1]), total[:, 2])
    lengths = [np.sqrt(np.einsum("nk,nk->n", v, v)) for v in (apart, total)]
    return np.asarray(theta_h), np.asarray(np.arctan2(*lengths))


def spread(theta_h: Floats, theta_d: Floats, most: int, seed: int) -> Places:
    """Return places, rising, of at most ``most`` pairs taken by turns from the cells over √θh and θd (radians)."""
    rng = np.random.default_rng(seed)
    # Ranking a million by cell takes longer than the fit; a few times as many as wanted fill the cells as well.
    chosen = np.arange(len(theta_h))
    if len(chosen) > 40 * most:
        chosen = rng.choice(len(chosen), 40 * most, replace=False)
    row = np.minimum(np.sqrt(theta_h[chosen] * (2.0 / np.pi)) * CELLS[0], CELLS[0] - 1).astype(np.intp)
    column = np.minimum(theta_d[chosen] * (2.0 / np.pi) * CELLS[1], CELLS[1] - 1).astype(np.intp)
    cell = row * CELLS[1] + column
    order = np.lexsort((rng.random(len(chosen)), cell))
    ordered = cell[order]
    first = np.searchsorted(ordered, ordered)
    turn = np.arange(len(order)) - first
    best = np.lexsort((rng.random(len(order)), turn))[:most]
    return np.sort(chosen[order[best]])


def _directions(name: str, value: npt.ArrayLike) -> Floats:
    found = np.asarray(value, np.float64)
    if found.ndim != 2 or found.shape[1] != 3:
        raise FittingError(f"The directions {name} have the shape {found.shape}; (n, 3) is wanted.")
    length = np.einsum("nk,nk->n", found, found)
    # A NaN fails the comparison, as it should.
    wrong = np.flatnonzero(~(np.abs(length - 1.0) < 1e-4))
    if wrong.size:
        raise FittingError(f"The direction {name}[{wrong[0]}] is not of unit length.")
    return found
