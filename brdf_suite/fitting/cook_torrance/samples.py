"""Samples of a fit: checked, and thinned evenly over θh and θd.

Most bins of a table, and most samples of a gonioreflectometer, lie far from the peak; and θd alone determines the
lobes' Fresnel reflectance from their weight (section 4.2 of Günther et al. 2005 samples its table by θh for that
reason). So where there are more than a fit needs, they are taken by turns from the cells of a grid over √θh and θd.

Values of 0 or less have no logarithm. A few are left out. Many are no accident: the colour is outside of the working
space, so that a channel was cut at 0 (of Cayman nine tenths of the red ones), or the reading drowned in noise. Left
out, they would leave that channel to the few bright samples. So then a floor is added to the values and to the fit
alike: a hundredth of the sample's brightest channel, and a fiftieth of what the brightest channel is in the median.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Floats, Indices
from brdf_suite.errors import FittingError

CELLS = (60, 30)
"""Cells along √θh and along θd."""
FLOOR_SHARE, FLOOR_DARK = 0.01, 0.02
"""Of the sample's brightest channel, and of its median over the samples."""
_MANY = 1e-3


@dataclass(frozen=True)
class Floor:
    """Offset added to every value, and to the fit, before the logarithm.

    ``share`` of a sample's brightest channel, and ``dark``, 1/sr.
    """

    share: float = 0.0
    dark: float = 0.0

    @classmethod
    def of(cls, values: Floats) -> Floor:
        """Return the floor that values (n, 3) need: none, unless more than a thousandth are 0 or less."""
        seen = values[(values > 0.0).any(axis=1)]
        if np.count_nonzero(seen <= 0.0) <= _MANY * seen.size:
            return cls()
        return cls(FLOOR_SHARE, FLOOR_DARK * float(np.median(seen.max(axis=1))))

    def at(self, values: Floats) -> Floats:
        """Return what is added (n,) to values (n, 3), 1/sr."""
        return np.asarray(self.share * np.maximum(values.max(axis=1), 0.0) + self.dark)


@dataclass(frozen=True, eq=False)
class LobeSamples:
    """Samples of a fit.

    ``wi``, ``wo`` (n, 3) unit directions; ``logs`` (3, n) natural logarithms of f_r in 1/sr and what is added to it,
    ``added`` (n,) by the ``floor``; 0 where ``known`` (3, n) is false; ``weights`` (n,) > 0 with mean 1.
    ``left_out``: how many were not finite, beyond the grazing angle, of no weight or black; ``black``: how many values
    (of one channel) of the others are not positive, and ``black_share`` which share.
    """

    wi: Floats
    wo: Floats
    logs: Floats
    known: Bools
    weights: Floats
    added: Floats
    floor: Floor
    left_out: int
    black: int
    black_share: float

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
            self.added[at],
            self.floor,
            self.left_out,
            self.black,
            self.black_share,
        )

    def fewer(self, most: int, seed: int) -> LobeSamples:
        """Return at most ``most`` of them, spread over θh and θd."""
        if len(self) <= most:
            return self
        return self.part(spread(*half_and_difference(self.wi, self.wo), most, seed))


def check_samples(
    wi: npt.ArrayLike,
    wo: npt.ArrayLike,
    values: npt.ArrayLike,
    weights: npt.ArrayLike | None = None,
    grazing_deg: float = 90.0,
    floor: Floor | None = None,
) -> LobeSamples:
    """Return the samples that a fit of logarithms can use.

    Parameters
    ----------
    wi, wo
        (n, 3) unit directions, local frame.
    values
        (n, 3) f_r in 1/sr. Samples that are not finite are left out; negative values are taken for 0.
    weights
        (n,) how much each counts, at least 0; all alike if left out.
    floor
        What is added; what the values themselves need, if left out.

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
            "expected (n, 3) of each."
        )
    share = np.ones(len(light)) if weights is None else np.asarray(weights, np.float64)
    if share.shape != (len(light),) or not np.all(np.isfinite(share)) or np.any(share < 0.0):
        raise FittingError(f"The weights must be {len(light)} finite numbers, none negative.")
    lowest = max(np.cos(np.radians(grazing_deg)), 1e-6)
    seen = (light[:, 2] >= lowest) & (view[:, 2] >= lowest) & (share > 0.0)
    seen &= np.isfinite(data).all(axis=1)
    found = np.maximum(data[seen], 0.0)
    floor = Floor.of(data[seen]) if floor is None else floor
    raised = found + floor.at(found)[:, None]
    # A channel of nothing at all is none, whatever the floor.
    known = (raised > 0.0) & (found > 0.0).any(axis=0)
    used = known.any(axis=1)
    count = int(used.sum())
    if count == 0:
        raise FittingError(
            f"None of the {len(light):,} samples can be fitted: they are black, not finite, without weight, or seen "
            f"at more than {grazing_deg:g}° from the normal."
        )
    kept = known[used].T
    logs = np.zeros(kept.shape)
    np.log(raised[used].T, out=logs, where=kept)
    chosen = share[seen][used]
    black = int(np.count_nonzero(found[used] <= 0.0))
    return LobeSamples(
        light[seen][used],
        view[seen][used],
        logs,
        np.ascontiguousarray(kept),
        chosen / chosen.mean(),
        floor.at(found[used]),
        floor,
        len(light) - count,
        black,
        black / (3 * count),
    )


def even_weights(wi: Floats, wo: Floats) -> Floats:
    """Return weights (n,) with mean 1 by which samples count alike all over √θh and θd.

    Each counts by how few share its cell, up to thirty times as much as where they are dense: what is measured at equal
    steps of the view has few samples in the peak, and a sum of logarithms would leave it out.
    """
    theta_h, theta_d = half_and_difference(wi, wo)
    row = np.minimum(np.sqrt(theta_h * (2.0 / np.pi)) * (CELLS[0] / 3), CELLS[0] / 3 - 1).astype(np.intp)
    column = np.minimum(theta_d * (2.0 / np.pi) * (CELLS[1] / 3), CELLS[1] / 3 - 1).astype(np.intp)
    cell = row * CELLS[1] + column
    share = 1.0 / np.bincount(cell)[cell]
    share = np.minimum(share, 30.0 * float(share.min()))
    return np.asarray(share / share.mean())


def half_and_difference(wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
    """Return θh and θd (n,), radians, exact also where they are tiny."""
    total, apart = wi + wo, wi - wo
    theta_h = np.arctan2(np.hypot(total[:, 0], total[:, 1]), total[:, 2])
    lengths = [np.sqrt(np.einsum("nk,nk->n", v, v)) for v in (apart, total)]
    return np.asarray(theta_h), np.asarray(np.arctan2(*lengths))


def spread(theta_h: Floats, theta_d: Floats, most: int, seed: int) -> Indices:
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
        raise FittingError(f"The directions {name} have the shape {found.shape}; expected (n, 3).")
    length = np.einsum("nk,nk->n", found, found)
    # A NaN fails the comparison, as it should.
    wrong = np.flatnonzero(~(np.abs(length - 1.0) < 1e-4))
    if wrong.size:
        raise FittingError(f"The direction {name}[{wrong[0]}] is not of unit length.")
    return found
