"""Parameter vector of the lobes, with log f_r and its Jacobian.

The vector is log kd (3), then for each lobe log a (3), log m and e = 1/n. The weight is held as a = ks r, the height
at normal incidence: ks and r themselves are distinguished only by the rise towards grazing, so that their product is
known well where neither is; with a the Jacobian's columns stay apart. A coat has log m and e alone: it is colourless,
and its facets are a whole surface (ks = ¼).

    f = kd/π + Σ a (F(c; e)/r) S(m) / π,     d f/d log a = term,  d f/d log m = term · d log S,
    d f/d e = term · (F'/F - r'/r),          r'/r = -4/(1 - e²).

A lobe of weight ks is ks F D G / (π cosθi cosθo), as equation 1 of Günther et al. 2005 has it. Below a coat everything
is multiplied by T(θi) T(θo), T = 1 - F.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Indices
from brdf_suite.fitting.cook_torrance.settings import ModelName
from brdf_suite.reflectance.models.half_vector_terms import HalfVectorTerms

_TINY = 1e-300
LEAST_WEIGHT = 1e-9
"""kd, or a, below which a fit cannot be distinguished from one without; it becomes 0."""
MOST_KD, MOST_HEIGHT = 10.0, 10.0
LEAST_M, MOST_M = 1e-3, 1.0
LEAST_R = 4e-3
LEAST_COAT_INDEX, MOST_COAT_INDEX = 1.05, 3.0
MOST_COAT_M = 0.2
"""A coat is smooth; rougher, it would take the part of a lobe."""
# What no value can fall below: the logarithm of a black model stays finite.
_FLOOR = 1e-30
# The solver starts a little inside of its bounds.
_NEARLY_NONE = 1.5
_REVIVED = 1e-3
_CHANNELS = ("red", "green", "blue")


@dataclass(frozen=True, eq=False)
class Terms:
    """Precomputed terms of n direction pairs above the horizon, (n,) each, shared by all lobes."""

    cos_i: Floats
    cos_o: Floats
    cos_d: Floats
    tan2_h: Floats
    log_grooves: Floats
    """log of G / (cosθi cosθo cos⁴θh) with the grooves of Cook and Torrance."""

    @classmethod
    def of(cls, wi: Floats, wo: Floats) -> Terms:
        """Return the terms of directions (n, 3) above the horizon."""
        found = HalfVectorTerms.of(wi, wo)
        low = np.minimum(found.cos_i, found.cos_o)
        grooves = np.minimum(1.0, 2.0 * found.cos_h * low / found.cos_d)
        shared = grooves * (1.0 + found.tan2_h) ** 2 / np.maximum(found.cos_i * found.cos_o, _TINY)
        logs = np.log(np.maximum(shared, _TINY))
        return cls(found.cos_i, found.cos_o, np.minimum(found.cos_d, 1.0), found.tan2_h, logs)


Shape = Callable[[Terms, float], tuple[Floats, Floats]]
"""``(terms, log m) -> log(D G/(cosθi cosθo)), its derivative by log m``, (n,) each."""


def beckmann(terms: Terms, log_m: float) -> tuple[Floats, Floats]:
    """Return the logarithm of Beckmann's facets in grooves, and its derivative by log m.

    D = exp(-tan²θh/m²) / (m² cos⁴θh) and the grooves G of Cook and Torrance 1982, as in
    :mod:`brdf_suite.reflectance.models.cook_torrance`.
    """
    steep = terms.tan2_h * math.exp(-2.0 * log_m)
    return terms.log_grooves - steep - 2.0 * log_m, 2.0 * steep - 2.0


def ggx(terms: Terms, log_m: float) -> tuple[Floats, Floats]:
    """Return the logarithm of GGX facets with Smith's shadowing, correlated by height, and its derivative by log m.

    D = m² / (cos⁴θh (m² + tan²θh)²), as in :mod:`brdf_suite.reflectance.models.ggx`, and
    G / (cosθi cosθo) = 2 / (cosθo √(m² + (1-m²)cos²θi) + the same swapped).
    """
    m2 = math.exp(2.0 * log_m)
    t, ci, co = terms.tan2_h, terms.cos_i, terms.cos_o
    far = m2 + t
    root_i = np.sqrt(m2 + (1.0 - m2) * ci * ci)
    root_o = np.sqrt(m2 + (1.0 - m2) * co * co)
    seen = co * root_i + ci * root_o
    slope = co * (1.0 - ci * ci) / root_i + ci * (1.0 - co * co) / root_o
    value = 2.0 * (log_m + np.log1p(t) - np.log(far)) + math.log(2.0) - np.log(np.maximum(seen, _TINY))
    return value, 2.0 - 4.0 * m2 / far - m2 * slope / np.maximum(seen, _TINY)


def fresnel(cosine: Floats, e: float) -> tuple[Floats, Floats]:
    """Return F (n,) and dF/de (n,) of a clear dielectric at ``cosine`` (n,), 0 to 1, for e = 1/n, 0 to 1.

    e goes from 1 (r = 0) to 0 (r = 1, F = 1 everywhere); with c = wo·h, s² = 1 - c² and t = √(1 - e² s²),

        A = (t - e c)/(t + e c),   B = (c t - e s²)/(c t + e s²),   F = A² (1 + B²)/2,
        dt/de = -e s²/t,           dA/de = -2c / (t (t + e c)²),    dB/de = -2 c s² / (t (c t + e s²)²),

    which is the form of Cook and Torrance with g = t/e, and finite at both ends, where n and its derivatives are not.
    """
    c = cosine
    s2 = 1.0 - c * c
    t = np.sqrt(np.maximum(1.0 - e * e * s2, _TINY))
    across = t + e * c
    along = np.maximum(c * t + e * s2, _TINY)
    a = (t - e * c) / across
    b = (c * t - e * s2) / along
    d_a = -2.0 * c / (t * across * across)
    d_b = -2.0 * c * s2 / (t * along * along)
    whole = 1.0 + b * b
    return 0.5 * a * a * whole, a * (d_a * whole + a * b * d_b)


def reflectance_from_inverse_index(e: float) -> float:
    """Return r, F along the normal, of e = 1/n.

    >>> round(reflectance_from_inverse_index(1.0 / 1.5), 9)
    0.04
    """
    return ((1.0 - e) / (1.0 + e)) ** 2


def inverse_index(r: float) -> float:
    """Return e = 1/n of a reflectance ``r`` along the normal, 0 to 1.

    >>> round(1.0 / inverse_index(0.04), 9)
    1.5
    """
    root = math.sqrt(r)
    return (1.0 - root) / (1.0 + root)


Vector = Floats


@dataclass(frozen=True)
class LobeModel:
    """``lobes`` of one kind over a diffuse part; with ``coat`` the last of them is a clearcoat."""

    name: ModelName
    lobes: int

    @property
    def coat(self) -> bool:
        """Whether the last lobe is a colourless coat over all the rest."""
        return self.name == "ggx-clearcoat"

    @property
    def shape(self) -> Shape:
        """The facets of every lobe."""
        return beckmann if self.name == "cook-torrance" else ggx

    @property
    def size(self) -> int:
        """The number of parameters."""
        return 3 + 5 * self.lobes - (3 if self.coat else 0)

    def weights_at(self, lobe: int) -> slice:
        """Return where log a (3) of a lobe stands; empty for a coat."""
        start = 3 + 5 * lobe
        return slice(start, start if self._is_coat(lobe) else start + 3)

    def m_at(self, lobe: int) -> int:
        """Return where log m of a lobe stands; e follows it."""
        return int(self.weights_at(lobe).stop)

    def _is_coat(self, lobe: int) -> bool:
        return self.coat and lobe == self.lobes - 1

    def bounds(self) -> tuple[Vector, Vector]:
        """Return the plausible range (p,), (p,): m and r within (0, 1], weights positive."""
        low, high = np.empty(self.size), np.empty(self.size)
        low[:3], high[:3] = math.log(LEAST_WEIGHT), math.log(MOST_KD)
        for lobe in range(self.lobes):
            at, m = self.weights_at(lobe), self.m_at(lobe)
            low[at], high[at] = math.log(LEAST_WEIGHT), math.log(MOST_HEIGHT)
            low[m], high[m] = math.log(LEAST_M), math.log(MOST_M)
            if self._is_coat(lobe):
                high[m] = math.log(MOST_COAT_M)
                low[m + 1], high[m + 1] = 1.0 / MOST_COAT_INDEX, 1.0 / LEAST_COAT_INDEX
            else:
                low[m + 1], high[m + 1] = 0.0, inverse_index(LEAST_R)
        return low, high

    def vector(self, kd: npt.ArrayLike, ks: npt.ArrayLike, m: npt.ArrayLike, r: npt.ArrayLike) -> Vector:
        """Return the vector of kd (3,), ks (N, 3), m (N,) and r (N,), within the bounds."""
        weights, slopes, reflected = np.asarray(ks, float), np.asarray(m, float), np.asarray(r, float)
        x = np.empty(self.size)
        x[:3] = np.log(np.maximum(np.asarray(kd, float), LEAST_WEIGHT))
        for lobe in range(self.lobes):
            place = self.m_at(lobe)
            if not self._is_coat(lobe):
                x[self.weights_at(lobe)] = np.log(np.maximum(weights[lobe] * reflected[lobe], LEAST_WEIGHT))
            x[place] = math.log(slopes[lobe])
            x[place + 1] = inverse_index(float(reflected[lobe]))
        return np.clip(x, *self.bounds())

    def values(self, x: Vector) -> tuple[Floats, Floats, Floats, Floats]:
        """Return kd (3,), ks (N, 3), m (N,) and r (N,) of a vector; what stands at the least weight is 0."""
        kd = _weight(x[:3])
        ks, m, r = np.empty((self.lobes, 3)), np.empty(self.lobes), np.empty(self.lobes)
        for lobe in range(self.lobes):
            place = self.m_at(lobe)
            m[lobe], r[lobe] = math.exp(x[place]), reflectance_from_inverse_index(float(x[place + 1]))
            ks[lobe] = 0.25 if self._is_coat(lobe) else _weight(x[self.weights_at(lobe)]) / r[lobe]
        return kd, ks, m, r

    def named(self, parameter: int, values: Floats) -> tuple[str, Floats]:
        """Return the name of a parameter of the vector, as ``ks·r 2 red``, and what its ``values`` (k,) stand for."""
        if parameter < 3:
            return f"kd {_CHANNELS[parameter]}", np.exp(values)
        lobe = next(k for k in range(self.lobes) if parameter <= self.m_at(k) + 1)
        if parameter < self.m_at(lobe):
            channel = _CHANNELS[parameter - self.weights_at(lobe).start]
            return f"ks·r {lobe + 1} {channel}", np.exp(values)
        if parameter == self.m_at(lobe):
            return f"m {lobe + 1}", np.exp(values)
        reflected = [reflectance_from_inverse_index(float(e)) for e in values]
        return f"r {lobe + 1}", np.asarray(reflected)

    def sorted(self, x: Vector) -> Vector:
        """Return the vector with its lobes by falling m: the sharp one last.

        Lobes without weight stand first, and a coat stays last.
        """
        count = self.lobes - (1 if self.coat else 0)
        fall = [-x[self.m_at(lobe)] - (100.0 if self.dead(x, lobe) else 0.0) for lobe in range(count)]
        order = np.argsort(fall, kind="stable")
        y = x.copy()
        for new, old in enumerate(order.tolist()):
            y[3 + 5 * new : 8 + 5 * new] = x[3 + 5 * old : 8 + 5 * old]
        return y

    def dead(self, x: Vector, lobe: int) -> bool:
        """Whether a lobe has no weight in any channel."""
        return not self._is_coat(lobe) and not _weight(x[self.weights_at(lobe)]).any()

    def without(self, x: Vector, lobe: int) -> Vector:
        """Return the vector with a lobe's weights at their bound, where no step brings them back, and m and r 1."""
        y = x.copy()
        y[self.weights_at(lobe)] = math.log(LEAST_WEIGHT)
        y[self.m_at(lobe) : self.m_at(lobe) + 2] = 0.0
        return y

    def searched(self, x: Vector, channels: npt.ArrayLike) -> Indices:
        """Return the parameters that a search may move: not those of a lobe without weight, nor of unknown channels."""
        known = np.asarray(channels, np.bool_)
        moved = np.ones(self.size, np.bool_)
        moved[:3] = known
        for lobe in range(self.lobes):
            at, place = self.weights_at(lobe), self.m_at(lobe)
            if self.dead(x, lobe):
                moved[at.start : place + 2] = False
            elif not self._is_coat(lobe):
                moved[at] = known
        return np.flatnonzero(moved)

    def revived(self, x: Vector, channels: npt.ArrayLike) -> Vector:
        """Return the vector with weights that fell to nothing raised again, from where a search feels their slope.

        Lobes without any weight stay so; weights of unknown channels are nothing.
        """
        y = x.copy()
        known = np.asarray(channels, np.bool_)
        for at in (slice(0, 3), *(self.weights_at(k) for k in range(self.lobes) if not self.dead(x, k))):
            if at.start < at.stop:
                least = max(float(y[at].max()), math.log(_REVIVED)) + math.log(_REVIVED)
                y[at] = np.where(known, np.maximum(y[at], least), math.log(LEAST_WEIGHT))
        return y

    def parts(self, x: Vector, terms: Terms) -> Floats:
        """Return (1 + N, 3, n) f_r in 1/sr of the diffuse part and of each lobe."""
        return self._evaluate(x, terms, None)

    def columns(self, channel: int) -> Indices:
        """Return which parameters (q,) a channel hangs on, in the order of the slopes of :meth:`logs`."""
        own = [channel]
        for lobe in range(self.lobes):
            place = self.m_at(lobe)
            weights = self.weights_at(lobe)
            own += [place, place + 1] if self._is_coat(lobe) else [weights.start + channel, place, place + 1]
        return np.array(own)

    def logs(
        self, x: Vector, terms: Terms, slopes: bool = True, added: Floats | float = 0.0
    ) -> tuple[Floats, Floats | None]:
        """Return log(f_r + added) (3, n), and where asked for its derivatives (3, q, n) by each channel's columns."""
        count = 1 + 3 * self.lobes - (1 if self.coat else 0)
        found = np.empty((3, count, len(terms.cos_d))) if slopes else None
        total = np.maximum(self._evaluate(x, terms, found).sum(axis=0) + added, _FLOOR)
        if found is not None:
            found /= total[:, None, :]
        return np.log(total), found

    def _evaluate(self, x: Vector, terms: Terms, slopes: Floats | None) -> Floats:
        """Return the parts; fill in the derivatives of their sum."""
        parts = np.empty((1 + self.lobes, 3, len(terms.cos_d)))
        parts[0] = (np.exp(x[:3]) / math.pi)[:, None]
        for lobe in range(self.lobes):
            place = self.m_at(lobe)
            e = float(x[place + 1])
            shape, by_m = self.shape(terms, float(x[place]))
            share, by_e = fresnel(terms.cos_d, e)
            share = np.maximum(share, 1e-30)
            by_e = by_e / share
            if self._is_coat(lobe):
                parts[1 + lobe] = 0.25 / math.pi * share * np.exp(shape)
            else:
                by_e += 4.0 / (1.0 - e * e)
                heights = np.exp(x[self.weights_at(lobe)]) / (math.pi * reflectance_from_inverse_index(e))
                parts[1 + lobe] = heights[:, None] * (share * np.exp(shape))
            if slopes is not None:
                at = 1 + 3 * lobe
                if not self._is_coat(lobe):
                    slopes[:, at] = parts[1 + lobe]
                    at += 1
                np.multiply(parts[1 + lobe], by_m, out=slopes[:, at])
                np.multiply(parts[1 + lobe], by_e, out=slopes[:, at + 1])
        if slopes is not None:
            slopes[:, 0] = parts[0]
        if self.coat:
            # T(θi) T(θo) (n,) of the coat, and its derivative by e.
            (f_i, d_i), (f_o, d_o) = (fresnel(cosine, float(x[-1])) for cosine in (terms.cos_i, terms.cos_o))
            through, by_e = (1.0 - f_i) * (1.0 - f_o), -d_i * (1.0 - f_o) - d_o * (1.0 - f_i)
            if slopes is not None:
                slopes[:, :-2] *= through
                slopes[:, -1] += parts[:-1].sum(axis=0) * by_e
            parts[:-1] *= through
        return parts


def _weight(logs: Floats) -> Floats:
    """Return the weights of the logarithms; 0 at the bound."""
    return np.asarray(np.where(logs <= math.log(_NEARLY_NONE * LEAST_WEIGHT), 0.0, np.exp(logs)))
