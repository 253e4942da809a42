"""Lobe weights that depend on the incidence: a table over N·L, and its reflectance."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.checks import check_ior
from brdf_suite.fitting.lobes.weights import LobeWeights, set_weights
from brdf_suite.geometry.fresnel import fresnel_dielectric

DEFAULT_COUNT = 16
#: The least angles of a fit, and the most: the joint program grows with the square of their number.
FEWEST, MOST = 3, 256
DEFAULT_POWER = 1.5
#: The smallest cosine: 88.3°. Below it weights are held.
LOWEST_COSINE = 0.03
MEASURED_COSINE = math.cos(math.pi / 4.0)
#: Cosine of 89.9°: nothing is divided by a smaller transmission than the one here.
GRAZING = 0.002


@dataclass(frozen=True)
class AngleGrid:
    """K cosines of incidence, rising from ``lowest_cosine`` to 1, one of them cos 45°.

    With x running evenly from 0 to 1 over the K texels of a 1-D texture, the cosine of incidence is

        c(x) = c_0 + (1 - c_0) x^p.

    p = 1 places the fits evenly in the cosine, p > 1 more densely towards grazing, where Fresnel's factors turn fast.
    The power is adjusted until one texel falls on 45° exactly: there paints are measured, and there a multi-angle fit
    must be as true as a single one. Its inverse is one power in a shader, ``x = ((N·L - c_0)/(1 - c_0))^(1/p)``.
    Measurements behind the defaults: docs/method/incidence.md.

    Parameters
    ----------
    count
        K, 3 to 256.
    wanted_power
        The power p asked for, more than 0; ``power`` is the nearest that has a texel at 45°.
    lowest_cosine
        The smallest cosine, between 0 and cos 45°.

    Attributes
    ----------
    cosines
        ``(K,)``, rising.
    measured
        Index of the texel at 45°.

    >>> grid = AngleGrid(16)
    >>> round(float(np.degrees(np.arccos(grid.cosines[grid.measured]))), 6)
    45.0

    Raises
    ------
    FittingError
        A count, power or cosine out of range.
    """

    count: int = DEFAULT_COUNT
    wanted_power: float = DEFAULT_POWER
    lowest_cosine: float = LOWEST_COSINE
    power: float = field(init=False)
    measured: int = field(init=False)
    cosines: Floats = field(init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        if not FEWEST <= self.count <= MOST:
            needed = f"at least {FEWEST} angles of incidence and takes at most {MOST}"
            raise FittingError(f"A fit at several angles needs {needed}, not {self.count}.")
        if not (math.isfinite(self.wanted_power) and self.wanted_power > 0.0):
            power = f"{self.wanted_power:g}"
            raise FittingError(f"The power of the angles' placement is {power}; it must be more than 0.")
        if not 0.0 < self.lowest_cosine < MEASURED_COSINE:
            raise FittingError(
                f"The smallest cosine of incidence is {self.lowest_cosine:g}; it must lie between 0 and cos 45°."
            )
        share = math.log((MEASURED_COSINE - self.lowest_cosine) / (1.0 - self.lowest_cosine))
        last = self.count - 1
        powers = [share / math.log(k / last) for k in range(1, last)]
        nearest = min(range(last - 1), key=lambda k: abs(math.log(powers[k] / self.wanted_power)))
        shares = (np.arange(self.count) / last) ** powers[nearest]
        cosines = self.lowest_cosine + (1.0 - self.lowest_cosine) * shares
        cosines[nearest + 1] = MEASURED_COSINE
        cosines.setflags(write=False)
        object.__setattr__(self, "power", powers[nearest])
        object.__setattr__(self, "measured", nearest + 1)
        object.__setattr__(self, "cosines", cosines)

    def position(self, cosine: npt.ArrayLike) -> Floats:
        """Return x·(K-1) (...), 0 to K-1, of cosines (...): held below the smallest cosine and above 1."""
        share = (np.asarray(cosine, np.float64) - self.lowest_cosine) / (1.0 - self.lowest_cosine)
        return np.asarray((self.count - 1) * np.clip(share, 0.0, 1.0) ** (1.0 / self.power))

    def coordinate(self, cosine: npt.ArrayLike) -> Floats:
        """Return the texture coordinate (...) of cosines (...): (x (K-1) + ½)/K, texel centres at (k + ½)/K."""
        return np.asarray((self.position(cosine) + 0.5) / self.count)

    def shares(self, cosine: npt.ArrayLike) -> tuple[npt.NDArray[np.intp], Floats]:
        """Return the lower texel (...) and the share (...) of the one above it, as linear filtering mixes them."""
        position = self.position(cosine)
        lower = np.minimum(position.astype(np.intp), self.count - 2)
        return lower, position - lower


def leaving(cos_light: Floats, cos_view: Floats, cos_gamma: Floats, ior: float) -> Floats:
    """Return T(N·V) over T of the view at the same γ on the normal's side (...), all cosines (...).

    In the plane of incidence that view has the polar angle θi - γ; the ratio is 1 there, and below 1 beyond the
    mirror direction. Both cosines are held above :data:`GRAZING`, where T itself goes to 0.
    """
    sines = np.sqrt(np.clip((1.0 - cos_light**2) * (1.0 - cos_gamma**2), 0.0, None))
    inner = np.maximum(cos_light * cos_gamma + sines, GRAZING)
    out = 1.0 - fresnel_dielectric(np.maximum(cos_view, GRAZING), ior)
    return np.asarray(out / (1.0 - fresnel_dielectric(inner, ior)))


def crossing(light: Floats, view: Floats, ior: float) -> Floats:
    """Return T(N·L)·T(N·V)/T(cos θd)² (...) for ``light``, ``view`` (..., 3): 1 in the mirror direction."""
    light_cosine, view_cosine, half = light[..., 2], view[..., 2], halfway_cosine(light, view)
    enters, leaves, there = (
        1.0 - fresnel_dielectric(np.maximum(cosine, GRAZING), ior)
        for cosine in (light_cosine, view_cosine, half)
    )
    return np.asarray(enters * leaves / there**2)


def gloss_brdf(grid: AngleGrid, exponents: Floats, kg: Floats, light: Floats, view: Floats) -> Floats:
    """Return the gloss lobes' f_r (n, 3) of a table ``kg`` (K, m, 3) for ``light``, ``view`` (n, 3)."""
    up = light[:, 2] * view[:, 2]
    above = (light[:, 2] > 0.0) & (view[:, 2] > 0.0)
    lobes = gloss_lobes(exponents, light, view)
    value = np.einsum("nm,nmc->nc", lobes, _mixed(grid, kg, halfway_cosine(light, view)))
    return np.where(above[:, None], value / np.sqrt(np.where(above, up, 1.0))[:, None], 0.0)


def gloss_lobes(exponents: Floats, light: Floats, view: Floats) -> Floats:
    """Return cos(2 θh)^E / cos θd (..., m) for ``light``, ``view`` (..., 3), 0 from a right angle on.

    θh is the angle between the normal and the half vector H, θd that between H and the light.
    """
    half = light + view
    angle = np.minimum(2.0 * np.arctan2(np.hypot(half[..., 0], half[..., 1]), half[..., 2]), np.pi / 2.0)
    log_cosine = np.log1p(-np.minimum(2.0 * np.sin(angle / 2.0) ** 2, 1.0 - 1e-16))
    width = np.maximum(halfway_cosine(light, view), GRAZING)
    return np.asarray(np.exp(log_cosine[..., None] * exponents) / width[..., None])


def halfway_cosine(light: Floats, view: Floats) -> Floats:
    """Return cos θd (...), θd half the angle between ``light`` and ``view`` (..., 3)."""
    return np.asarray(np.sqrt(np.clip(0.5 * (1.0 + (light * view).sum(axis=-1)), 0.0, 1.0)))


def _mixed(grid: AngleGrid, table: Floats, cosine: Floats) -> Floats:
    """``table`` (K, ...) at cosines (n,): (n, ...)."""
    lower, share = grid.shares(cosine)
    share = share.reshape(share.shape + (1,) * (table.ndim - 1))
    return np.asarray((1.0 - share) * table[lower] + share * table[lower + 1])


@dataclass(frozen=True, eq=False)
class AngleWeights:
    """Weights of the lobes at K incidences, linear Rec. 2020, ≥ 0: the second way of Fresnel.

    With the weights of the table at the cosines c = N·L and d = L·H, H halfway between light and view::

        f_r·(N·L) ≈ t·(N·L)·(KD(c) + Σ KDD_i(c)·(R·V)^E_i) + g·Σ KG_i(d)·cos(2 θh)^E_i / d

    with θh between N and H. Where the light leaves in the mirror direction c = d = N·V and t = g = 1: a picture, which
    takes its lights to be there, reads one table at N·V, and draws round lobes of the same energy. Away from it the
    lobes alone, even in γ, cannot say what paints do:

    - A base under a coat is darker beyond the mirror direction than at the same γ on the normal's side, because the
      coat lets out less at grazing: ``t = T(N·V)/T(cos(θi - γ))``, T = 1 - F of ``ior``; 1 on the normal's side.
    - A coat's facets reflect by F at the angle d, half of that between light and view, and f_r·√(N·L·N·V) is
      what they have in common: ``g = √(N·L/N·V)``. They reflect where their normals lie about N, which seen from L
      or V is an ellipse about the mirror direction: as wide in the plane of incidence as 2 θh, and narrower by d
      across it. So a lobe's peak is higher by 1/d than that of a round one. The gloss part alone is reciprocal.

    Parameters
    ----------
    grid
        The K cosines of incidence and how they are looked up.
    exponents
        ``(m,)`` lobe exponents E.
    kd, kdd, kg
        ``(K, 3)``, ``(K, m, 3)``, ``(K, m, 3)`` float64, finite and not negative, 1/sr.
    ior
        Refractive index of the coat.
    base_under_coat
        False: nothing is taken from the base for the coat, t = 1.
    base_at_halfway
        KD and KDD are looked up at d, as KG, not at c: a base that depends on the angle between light and view, whose
        samples were taken so. Then t = T(N·L)·T(N·V)/T(d)² under a coat, and the base is reciprocal too.
    time_limited
        The time limit came before the optimum.

    Fresnel's raise (:class:`~brdf_suite.fitting.lobes.weights.RaisedWeights`) is never applied on top:
    it is in the weights already. Raises :class:`FittingError` for a shape that does not fit, or a weight that is
    negative or not finite.
    """

    grid: AngleGrid
    exponents: Floats
    kd: Floats
    kdd: Floats
    kg: Floats
    ior: float
    base_under_coat: bool = True
    base_at_halfway: bool = False
    time_limited: bool = False
    #: Channels of a texel of :meth:`texture`.
    TEXEL: ClassVar[int] = 4

    def __post_init__(self) -> None:
        angles, lobes = self.grid.count, np.asarray(self.exponents).size
        kdd = (angles, lobes, 3)
        set_weights(self, {"exponents": (lobes,), "kd": (angles, 3), "kdd": kdd, "kg": kdd})
        check_ior(self.ior)

    @property
    def cosines(self) -> Floats:
        """``(K,)`` rising cosines of incidence of the table."""
        return self.grid.cosines

    def at(self, n_dot_l: float) -> LobeWeights:
        """Return the weights at one cosine of incidence, as a picture has them at a pixel with this N·V."""
        lower, share = self.grid.shares(float(n_dot_l))
        below, above = (1.0 - float(share)), float(share)
        k = int(lower)
        cosine = min(max(float(n_dot_l), self.grid.lowest_cosine), 1.0)
        return LobeWeights(
            exponents=self.exponents,
            kd=below * self.kd[k] + above * self.kd[k + 1],
            kdd=below * self.kdd[k] + above * self.kdd[k + 1],
            kg=below * self.kg[k] + above * self.kg[k + 1],
            theta_fit_rad=math.acos(cosine),
            ior=self.ior,
            time_limited=self.time_limited,
            base_under_coat=self.base_under_coat,
        )

    def passing(self, light: Floats, view: Floats) -> Floats:
        """Return t (...), see the class, for directions ``light``, ``view`` (..., 3)."""
        if not self.base_under_coat:
            return np.ones(light.shape[:-1])
        if self.base_at_halfway:
            return crossing(light, view, self.ior)
        cos_gamma = light[..., 2] * view[..., 2] - (light[..., :2] * view[..., :2]).sum(axis=-1)
        return leaving(light[..., 2], view[..., 2], cos_gamma, self.ior)

    def _sums(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Return N·L (...), base and gloss as f_r (..., 3), both 0 below the horizon."""
        light, view = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        shape = light.shape[:-1]
        light, view = light.reshape(-1, 3), view.reshape(-1, 3)
        cos_i, cos_o = light[:, 2], view[:, 2]
        above = (cos_i > 0.0) & (cos_o > 0.0)
        cos_gamma = cos_i * cos_o - light[:, 0] * view[:, 0] - light[:, 1] * view[:, 1]
        lobes = np.clip(cos_gamma, 0.0, 1.0)[:, None] ** self.exponents
        place = halfway_cosine(light, view) if self.base_at_halfway else cos_i
        base = _mixed(self.grid, self.kd, place)
        base = base + np.einsum("nm,nmc->nc", lobes, _mixed(self.grid, self.kdd, place))
        base = np.where(above[:, None], base * self.passing(light, view)[:, None], 0.0)
        gloss = gloss_brdf(self.grid, self.exponents, self.kg, light, view)
        return cos_i.reshape(shape), base.reshape((*shape, 3)), gloss.reshape((*shape, 3))

    def reflected(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return ``f_r·(N·L)`` in 1/sr: reflected radiance for light of unit strength (cosine included).

        ``wi``, ``wo``: unit directions ``(..., 3)`` to light and view, local frame with the normal as z; they
        broadcast. Result ``(..., 3)``, 0 where either is at or below the horizon.
        """
        cosine, base, gloss = self._sums(wi, wo)
        return np.asarray(np.maximum(cosine, 0.0)[..., None] * (base + gloss))

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r in 1/sr, **without** the cosine: ``reflected`` over ``N·L``; shapes as there."""
        _, base, gloss = self._sums(wi, wo)
        return base + gloss

    def coat_energy(self) -> Floats:
        """Return ``(K, 3)`` what the gloss lobes reflect of a constant environment, seen at each angle.

        Wide lobes count whole, also what of them lies below the horizon.
        """
        return np.asarray(np.einsum("m,kmc->kc", 2.0 * np.pi / (self.exponents + 1.0), self.kg))

    def texture(self) -> npt.NDArray[np.float32]:
        """Return the table as float32 texels ``(1 + 2m, K, 4)``, C order, for an RGBA32F 1-D texture array.

        K texels wide, one layer per term: layer 0 is KD, layers 1 to m are KDD_i, m + 1 to 2m KG_i (as an image, 1 + 2m
        rows). Red, green, blue are the weight, alpha the lobe's exponent (0 for KD). Linear filtering, clamped to the
        edge, looked up at ``grid.coordinate(N·V)``: texel k has its centre at (k + ½)/K and holds the weights
        of incidence ``cosines[k]``; in a shader

            u = (pow(clamp((NdotV - c0)/(1 - c0), 0, 1), 1/power)·(K - 1) + 0.5)/K

        with c0 and power of ``grid``.
        """
        angles, lobes = self.kg.shape[:2]
        table = np.zeros((1 + 2 * lobes, angles, self.TEXEL), np.float32)
        table[0, :, :3] = self.kd
        table[1 : lobes + 1, :, :3] = self.kdd.transpose(1, 0, 2)
        table[lobes + 1 :, :, :3] = self.kg.transpose(1, 0, 2)
        table[1 : lobes + 1, :, 3] = table[lobes + 1 :, :, 3] = np.asarray(self.exponents)[:, None]
        return table
