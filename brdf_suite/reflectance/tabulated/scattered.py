"""Scattered samples: values at arbitrary direction pairs, as from goniometers.

Between samples the value is a weighted mean of the nearest ones (Franke and Nielson's form of Shepard's method:
weights ((R - r)/(R r))², R the distance of the first neighbour left out), so it passes through every sample, is
continuous except where neighbours lie equally far, and never leaves the range of the samples.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.blocks import BLOCK, in_blocks, look_up_above
from brdf_suite.reflectance.half_vector_density import HalfVectorDensity, HalfVectorSampled

if TYPE_CHECKING:
    from scipy.spatial import cKDTree


NEIGHBOURS = 8
# Below this distance in feature space (1 is 90°) a query is on the sample.
_ON_SAMPLE = 1e-9
# Up to so many polar angles the sampler has nodes at each: there the samples lie close, and peaks stand out.
_MOST_ANGLES = 12


@dataclass(frozen=True, eq=False)
class ScatteredSamples(HalfVectorSampled):
    """Values at n direction pairs.

    Attributes
    ----------
    wi, wo
        (n, 3) unit directions above the horizon, local frame, z along the normal.
    values
        (n, 3) f_r in 1/sr, working space, without the cosine, not negative.
    spectra, wavelengths_nm
        (n, k) f_r per wavelength and (k,) rising nanometres; ``None`` where the data hold colours only.
    isotropic
        Whether only the azimuth between light and view matters, and not its sign.
    source
        Where the data come from, for the user.
    facts
        What the reader learned from the file, for the user.

    The samples are taken as reciprocal: (wi, wo) and (wo, wi) are one place.

    Raises
    ------
    ValueRangeError
        A shape does not fit, a value is not finite or negative, a direction is not of unit length or lies
        below the horizon, or there is no sample.
    """

    wi: Floats
    wo: Floats
    values: Floats
    spectra: Floats | None = None
    wavelengths_nm: Floats | None = None
    isotropic: bool = True
    source: str = ""
    facts: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))

    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})
    reciprocal: ClassVar[bool] = True

    def __post_init__(self) -> None:
        for name in ("wi", "wo"):
            directions = self._keep(name, (None, 3))
            if len(directions) == 0:
                raise ValueRangeError(name, "holds no sample; expected at least one")
            length = np.sqrt(np.einsum("ni,ni->n", directions, directions))
            wrong = np.flatnonzero((np.abs(length - 1.0) > 1e-6) | (directions[:, 2] < 0.0))
            if wrong.size:
                raise ValueRangeError(f"{name}[{wrong[0]}]", "is not a unit direction above the horizon")
        n = len(self.wi)
        if len(self.wo) != n:
            raise ValueRangeError("wo", f"holds {len(self.wo)} directions where wi holds {n}")
        _refuse_negative("values", self._keep("values", (n, 3)))
        if (self.spectra is None) != (self.wavelengths_nm is None):
            raise ValueRangeError("spectra", "spectra and wavelengths_nm come together or not at all")
        if self.wavelengths_nm is not None:
            bands = self._keep("wavelengths_nm", (None,))
            if bands.size == 0 or bands[0] <= 0.0 or (np.diff(bands) <= 0.0).any():
                raise ValueRangeError("wavelengths_nm", "must be positive and rise")
            _refuse_negative("spectra", self._keep("spectra", (n, bands.size)))

    def _keep(self, name: str, shape: tuple[int | None, ...]) -> Floats:
        """Store a field as a read-only float64 array of the wanted shape (``None``: any size)."""
        array = np.array(getattr(self, name), dtype=np.float64, order="C")
        fits = array.ndim == len(shape) and all(
            want is None or have == want for have, want in zip(array.shape, shape, strict=True)
        )
        if not fits:
            raise ValueRangeError(name, f"has the shape {array.shape}; expected {shape}")
        if not np.isfinite(array).all():
            at = np.argwhere(~np.isfinite(array))[0].tolist()
            raise ValueRangeError(f"{name}{at}", "is not a finite number")
        array.flags.writeable = False
        object.__setattr__(self, name, array)
        return array

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, working space, without the cosine; 0 below the horizon."""

        return in_blocks(partial(look_up_above, partial(self._mean, self.values)), wi, wo)

    def nearest_sample_deg(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the angle (...) in degrees from pairs of directions to their nearest samples.

        It is √(Δi² + Δo²) for small angles Δi between the lights and Δo between the views. Samples count as they are
        used: swapped, and, where isotropic, turned about the normal and mirrored to lie nearest.
        """
        light, view = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        pairs = zip(light.reshape(-1, 3), view.reshape(-1, 3), strict=True)
        return np.array([self._nearest_deg(i, o) for i, o in pairs]).reshape(light.shape[:-1])

    def _nearest_deg(self, i: Floats, o: Floats) -> float:
        # The squared chords of both directions add up to 4 - 2 (i·i' + o·o').
        alike = -2.0
        for one, two in ((self.wi, self.wo), (self.wo, self.wi)):
            if self.isotropic:
                # Complex numbers x + iy: |Σ a b*| is the greatest Σ (ax bx + ay by) over all turns, |Σ a b| mirrored.
                a, b = one[:, 0] + 1j * one[:, 1], two[:, 0] + 1j * two[:, 1]
                p, q = complex(i[0], i[1]), complex(o[0], o[1])
                level = np.maximum(np.abs(a * p + b * q), np.abs(a * p.conjugate() + b * q.conjugate()))
            else:
                level = one[:, :2] @ i[:2] + two[:, :2] @ o[:2]
            alike = max(alike, float((level + one[:, 2] * i[2] + two[:, 2] * o[2]).max()))
        return math.degrees(2.0 * math.asin(min(1.0, 0.5 * math.sqrt(max(0.0, 4.0 - 2.0 * alike)))))

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        polar = np.unique(np.arccos(np.minimum(self.wi[:, 2], 1.0)).round(3))
        return HalfVectorDensity(
            self, isotropic=self.isotropic, views=polar if polar.size <= _MOST_ANGLES else ()
        )

    def eval_spectra(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., k) in 1/sr at ``wavelengths_nm``; 0 below the horizon.

        Raises
        ------
        ValueRangeError
            The samples hold no spectra.
        """
        spectra = self.spectra
        if spectra is None:
            raise ValueRangeError("spectra", "these samples hold colours only, no spectra")
        light, view = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        shape = light.shape[:-1]
        light, view = light.reshape(-1, 3), view.reshape(-1, 3)
        result = np.empty((len(light), spectra.shape[1]))
        # In blocks for the memory of n × neighbours × bands.
        for start in range(0, len(light), BLOCK):
            rows = slice(start, start + BLOCK)
            result[rows] = look_up_above(
                partial(self._mean, spectra), light[rows], view[rows], spectra.shape[1]
            )
        return result.reshape(*shape, spectra.shape[1])

    @cached_property
    def _tree(self) -> cKDTree:
        # scipy.spatial takes longer to import than a paint to edit, so only data that need it load it.
        from scipy.spatial import cKDTree

        return cKDTree(self._stored[0])

    @cached_property
    def _stored(self) -> tuple[Floats, npt.NDArray[np.intp]]:
        """Feature points in the tree and the sample that each belongs to."""
        i, o = np.ascontiguousarray(self.wi.T), np.ascontiguousarray(self.wo.T)
        sample = np.arange(len(self.wi))
        if self.isotropic:
            return isotropic_features(i, o), sample
        # The features of a pair and of its swap differ in sign; both represent the sample.
        both = np.concatenate((anisotropic_features(i, o), anisotropic_features(o, i)))
        return both, np.concatenate((sample, sample))

    def _mean(self, values: Floats, i: Floats, o: Floats) -> Floats:
        features = isotropic_features(i, o) if self.isotropic else anisotropic_features(i, o)
        points, sample = self._stored
        k = min(NEIGHBOURS + 1, len(points))
        # A list of ranks asks for the second axis also where there is one neighbour.
        answer = self._tree.query(features, k=list(range(1, k + 1)))
        distance = np.asarray(answer[0], np.float64)
        found = sample[np.asarray(answer[1], np.intp)]
        if k > NEIGHBOURS:
            beyond, distance, found = distance[:, -1:], distance[:, :-1], found[:, :-1]
        else:
            # None is left out, so that all count.
            beyond = 1.5 * distance[:, -1:]
        near = np.maximum(distance, _ON_SAMPLE)
        # Where all neighbours lie equally far the weights would all be 0; the small term makes them equal.
        weight = ((np.maximum(beyond - near, 0.0) + 1e-9 * beyond + 1e-15) / near) ** 2
        weight /= weight.sum(axis=1, keepdims=True)
        mean: Floats = np.einsum("nk,nkc->nc", weight, values[found])
        return mean


def isotropic_features(i: Floats, o: Floats) -> Floats:
    """Return (n, 3) points whose distances say how far apart isotropic pairs (3, n) are.

    (√(θh/90°), θd/90°, |cos θi - cos θo|/2): three numbers that fix an isotropic, mirror-symmetric pair, equal
    for a pair and its swap, and with no φd, which has no meaning at θh = 0. The root spreads the highlight.
    """
    h, d = _half_and_difference(i, o)
    return np.stack((np.sqrt(h), d, 0.5 * np.abs(i[2] - o[2])), axis=-1)


def anisotropic_features(i: Floats, o: Floats) -> Floats:
    """Return (n, 4) points: √(θh/90°) in the azimuth of h as two numbers, and x, y of (wi - wo)/2."""
    h, _ = _half_and_difference(i, o)
    total, difference = i + o, 0.5 * (i - o)
    azimuth = np.arctan2(total[1], total[0])
    spread = np.sqrt(h)
    return np.stack(
        (spread * np.cos(azimuth), spread * np.sin(azimuth), difference[0], difference[1]), axis=-1
    )


def _half_and_difference(i: Floats, o: Floats) -> tuple[Floats, Floats]:
    """Return θh and θd, (n,) each, 1 being 90°."""
    total, difference = i + o, i - o
    theta_h = np.arctan2(np.hypot(total[0], total[1]), total[2])
    theta_d = np.arctan2(
        np.sqrt(np.einsum("cn,cn->n", difference, difference)), np.sqrt(np.einsum("cn,cn->n", total, total))
    )
    return theta_h * (2.0 / np.pi), theta_d * (2.0 / np.pi)


def _refuse_negative(name: str, array: Floats) -> None:
    if (array < 0.0).any():
        at = np.argwhere(array < 0.0)[0].tolist()
        raise ValueRangeError(f"{name}{at}", "is negative; a reflectance is not")
