"""Bins of an isotropic half-angle table: bin of a direction pair, centre of a bin.

Axes (Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation", 1998): θh non-linear, bin k
from (k/n)²·π/2 to ((k+1)/n)²·π/2, so that highlights get fine bins; θd linear over [0, π/2); φd linear over
[0, π) where the table is reciprocal - swapping ``wi`` and ``wo`` turns φd by π - and over [0, 2π) where it is not.
A bin's value belongs to its centre in index space, k + ½.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Floats, Singles
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import from_half_angle_coordinates

_HALF_PI = 0.5 * np.pi
_MAX_BINS = 1 << 26


@dataclass(frozen=True)
class HalfAngleGrid:
    """Numbers of bins along (θh, θd, φd), each at least 2; ``reciprocal``: φd covers [0, π) instead of [0, 2π).

    >>> HalfAngleGrid().shape
    (90, 90, 180)
    """

    theta_h: int = 90
    theta_d: int = 90
    phi_d: int = 180
    reciprocal: bool = True

    def __post_init__(self) -> None:
        if min(self.shape) < 2 or self.bins > _MAX_BINS:
            raise ValueRangeError(
                "grid", f"{self.shape} bins; 2 along each axis to {_MAX_BINS:,} in all are held"
            )

    @property
    def shape(self) -> tuple[int, int, int]:
        """Return the numbers of bins along (θh, θd, φd)."""
        return self.theta_h, self.theta_d, self.phi_d

    @property
    def bins(self) -> int:
        """Return the number of bins in all."""
        return self.theta_h * self.theta_d * self.phi_d

    @property
    def period(self) -> float:
        """Return the range of φd, radians: π or 2π."""
        return np.pi if self.reciprocal else 2.0 * np.pi

    def angles(self, h: npt.ArrayLike, d: npt.ArrayLike, p: npt.ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Return (θh, θd, φd), radians, at places in index space (bin k spans k to k + 1)."""
        theta_h = _HALF_PI * (np.asarray(h, float) / self.theta_h) ** 2
        theta_d = _HALF_PI * np.asarray(d, float) / self.theta_d
        return theta_h, theta_d, self.period * np.asarray(p, float) / self.phi_d

    def centres(self) -> tuple[Floats, Floats, Floats]:
        """Return the centres along each axis, radians, 1-D."""
        return self.angles(*(np.arange(n) + 0.5 for n in self.shape))

    def pairs(self, h: int) -> tuple[Floats, Floats]:
        """Return ``wi`` and ``wo`` (θd, φd, 3) at the centres of the bins of one θh."""
        theta_h, theta_d, phi_d = self.centres()
        return from_half_angle_coordinates(theta_h[h], 0.0, theta_d[:, None], phi_d[None, :])

    def above_horizon(self) -> npt.NDArray[np.bool_]:
        """Return (θh, θd, φd): whether both directions at a bin's centre are above the horizon."""
        return self._above(*self.centres())

    def reached(self) -> npt.NDArray[np.bool_]:
        """Return (θh, θd, φd): whether a trilinear look-up of directions above the horizon can touch a bin.

        These are the bins above the horizon and a rim of one bin beside them.
        """
        h, d, p = (np.arange(n, dtype=float) for n in self.shape)
        theta_h, theta_d, _ = self.angles(np.maximum(h - 0.5, 0.0), np.maximum(d - 0.5, 0.0), 0.0)
        # A look-up within one step of the centre; the one nearest to |cos φd| = 0 lies deepest above.
        steps = np.stack([p - 0.5, p + 0.0, p + 0.5, p + 1.0, p + 1.5])
        _, _, phi = self.angles(0.0, 0.0, steps)
        nearest = np.abs(np.cos(phi)).min(axis=0)
        return self._above(theta_h, theta_d, np.arccos(nearest))

    def _above(self, theta_h: Floats, theta_d: Floats, phi_d: Floats) -> npt.NDArray[np.bool_]:
        # z of the two directions is cos θh cos θd ∓ sin θh sin θd cos φd; float32 serves a yes or no.
        along = np.outer(np.cos(theta_h), np.cos(theta_d)).astype(np.float32)
        across = np.outer(np.sin(theta_h), np.sin(theta_d)).astype(np.float32)
        ahead = np.abs(np.cos(phi_d)).astype(np.float32)
        return np.asarray(along[:, :, None] > across[:, :, None] * ahead)

    def index_of(self, i: Floats, o: Floats) -> tuple[Floats, Floats, Floats]:
        """Return places in index space, (n,) each, of directions (3, n); φd within [0, bins).

        In closed form, without a rotation: with S = wi + wo and D = wi - wo, tan θh = |S_xy|/S_z,
        tan θd = |D|/|S| and tan φd = (S_x D_y - S_y D_x) / (-D_z |S|); every term is a difference of inputs,
        so a half vector close to the normal keeps its digits. For h = z exactly, φd has no meaning and is 0.
        """
        total, difference = i + o, i - o
        flat = total[0] * total[0] + total[1] * total[1]
        length = np.sqrt(flat + total[2] * total[2])
        apart = np.sqrt(difference[0] ** 2 + difference[1] ** 2 + difference[2] ** 2)
        h = np.sqrt(np.arctan2(np.sqrt(flat), total[2]) / _HALF_PI) * self.theta_h
        d = np.arctan2(apart, length) * (self.theta_d / _HALF_PI)
        turn = total[0] * difference[1] - total[1] * difference[0]
        ahead = -difference[2] * length
        if self.reciprocal:
            # Swapping turns both signs: folding them first makes a pair and its swap equal to the last bit.
            ahead = np.where(turn < 0.0, -ahead, ahead)
            turn = np.abs(turn)
        p = np.arctan2(turn, ahead) * (self.phi_d / self.period)
        p[p < 0.0] += self.phi_d
        # Under reciprocity φd = π is φd = 0; a tiny negative angle also rounds up to a whole turn.
        p[p >= self.phi_d] = 0.0
        return h, d, p


def trilinear(values: Singles, grid: HalfAngleGrid, i: Floats, o: Floats) -> Singles:
    """Return (n, c) between the values (θh, θd, φd, c) for directions (3, n) above the horizon.

    Along θh and θd the first and the last centre's value is held outwards; φd goes round, and where the
    table is reciprocal the bin before the first is the last, because φd + π is the same pair swapped.
    """
    h, d, p = grid.index_of(i, o)
    rows = values.reshape(-1, values.shape[3])
    h_low, h_part = _within(h, grid.theta_h)
    d_low, d_part = _within(d, grid.theta_d)
    p -= 0.5
    floor = np.floor(p)
    p_part = (p - floor).astype(np.float32)[:, None]
    p_low = floor.astype(np.intp)
    p_low[p_low < 0] += grid.phi_d
    p_high = p_low + 1
    p_high[p_high == grid.phi_d] = 0
    start = (h_low * grid.theta_d + d_low) * grid.phi_d
    p_low += start
    p_high += start

    def along_phi(offset: int) -> Singles:
        low = rows.take(p_low + offset, axis=0)
        high = rows.take(p_high + offset, axis=0)
        high -= low
        high *= p_part
        low += high
        return low

    def along_d(offset: int) -> Singles:
        low, high = along_phi(offset), along_phi(offset + grid.phi_d)
        high -= low
        high *= d_part
        low += high
        return low

    low, high = along_d(0), along_d(grid.theta_d * grid.phi_d)
    high -= low
    high *= h_part
    low += high
    # a + t(b - a) in single precision can miss 0 from below by a rounding.
    return np.maximum(low, 0.0, out=low)


def _within(place: Floats, bins: int) -> tuple[npt.NDArray[np.intp], Singles]:
    """Return the lower of two neighbouring bins and the share of the upper one, (n,) and (n, 1)."""
    between = np.clip(place - 0.5, 0.0, bins - 1.0)
    low = np.minimum(between.astype(np.intp), bins - 2)
    return low, (between - low).astype(np.float32)[:, None]


Step = tuple[int, int, int]

BIN_STEPS = (1.0, 0.2, 0.03)
"""How far one bin along (θh, θd, φd) counts: by trial on tabulated paints with bins taken out."""

PHI_REACH = 1.0 / 6.0
"""How far along φd the nearest measured bin may be, of the whole line (of 180°: 30°)."""


def fill_holes(
    values: npt.NDArray[np.float32],
    holes: Bools,
    grid: HalfAngleGrid,
    bin_steps: tuple[float, float, float] = BIN_STEPS,
) -> int:
    """Fill ``values`` (θh, θd, φd, c) in place where ``holes`` (θh, θd, φd) is set; return how many were.

    After Guenther, Chen, Goesele, Wald and Seidel, "Efficient Acquisition and Realistic Rendering of Car Paint" (2005),
    section 4.1. A reflectance changes least along φd, so a hole with measured bins near it on its own line of φd gets
    their mean, weighted inversely by distance. The other holes are filled from their rim inwards: all that lie beside
    a known bin at once, each with the mean of its known neighbours among the 26 around it, then those beside them, so
    the result hangs on no order of the bins. A neighbour (a, b, c) bins away weighs 1/((a·s)² + (b·t)² + (c·u)²).

    Holes that no look-up of directions above the horizon touches become 0 and count as not filled; so do
    all of them where nothing is known.
    """
    if values.shape[:3] != grid.shape or holes.shape != grid.shape or not values.flags.c_contiguous:
        raise ValueError(f"values and holes must be contiguous arrays of {grid.shape} bins")
    rows = values.reshape(-1, values.shape[3])
    rows[holes.reshape(-1)] = 0.0
    have, wanted = ~holes, holes & grid.reached()
    filled = _fill_along_phi(rows, have.reshape(-1), wanted.reshape(-1), grid)
    # With a margin of one bin all round, along φd a copy of the other end, a neighbour is a fixed way off.
    known, missing = np.pad(have, 1), np.pad(wanted & ~have, 1)
    table = np.pad(values, ((1, 1), (1, 1), (1, 1), (0, 0)))
    _copy_ends(known, table)
    far = np.array(known.strides)
    one = (-1, 0, 1)
    ways = [
        (
            int(far @ step),
            np.float32(1.0 / sum((bins * size) ** 2 for bins, size in zip(step, bin_steps, strict=True))),
        )
        for step in product(one, one, one)
        if any(step)
    ]
    flat, is_known, is_missing = table.reshape(-1, rows.shape[1]), known.reshape(-1), missing.reshape(-1)
    beside = known
    for axis in range(3):
        beside = beside | np.roll(beside, 1, axis) | np.roll(beside, -1, axis)
    rim = np.flatnonzero(beside & missing)
    while rim.size:
        total = np.zeros((rim.size, rows.shape[1]), np.float32)
        weight = np.zeros(rim.size, np.float32)
        beside = np.zeros(known.shape, np.bool_)
        for way, share in ways:  # what is not known is 0
            near = rim + way
            total += share * flat.take(near, axis=0)
            weight += share * is_known.take(near)
            beside.reshape(-1)[near] = True
        flat[rim] = total / weight[:, None]
        is_known[rim], is_missing[rim] = True, False
        filled += rim.size
        _copy_ends(known, table)
        beside[:, :, 1] |= beside[:, :, -1]
        beside[:, :, -2] |= beside[:, :, 0]
        rim = np.flatnonzero(beside & missing)
    values[...] = table[1:-1, 1:-1, 1:-1]
    return filled


def _copy_ends(*tables: npt.NDArray[np.generic]) -> None:
    """Write the bins at either end of φd into the margin at the other."""
    for table in tables:
        table[:, :, 0], table[:, :, -1] = table[:, :, -2], table[:, :, 1]


def _fill_along_phi(rows: npt.NDArray[np.float32], known: Bools, wanted: Bools, grid: HalfAngleGrid) -> int:
    """Fill what lies near a known bin of its line; marks it as known and returns how many were."""
    n = grid.phi_d
    known_lines, wanted_lines = known.reshape(-1, n), wanted.reshape(-1, n)
    lines = np.flatnonzero(wanted_lines.any(axis=1) & known_lines.any(axis=1))
    if not lines.size:
        return 0
    # Twice round, so that the nearest known bin on either side lies in the array.
    twice = np.tile(known_lines[lines], 2)
    place = np.arange(2 * n, dtype=np.int32)
    last = np.maximum.accumulate(np.where(twice, place, -1), axis=1)[:, n:]
    following = np.minimum.accumulate(np.where(twice, place, 3 * n)[:, ::-1], axis=1)[:, ::-1][:, :n]
    back, ahead = place[n:] - last, following - place[:n]
    near = np.minimum(back, ahead) <= max(1, int(PHI_REACH * n))
    line, p = np.nonzero(near & wanted_lines[lines])
    back, ahead = back[line, p], ahead[line, p]
    start = lines[line] * n
    share = (back / (back + ahead)).astype(np.float32)[:, None]
    before, after = rows.take(start + (p - back) % n, axis=0), rows.take(start + (p + ahead) % n, axis=0)
    rows[start + p] = before + share * (after - before)
    known[start + p] = True
    return int(p.size)
