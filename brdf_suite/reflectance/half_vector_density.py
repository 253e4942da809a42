"""A sampling density for a reflectance that is known by its values only: measured tables and scattered samples.

For a view ``wo`` the light's direction is described by the half vector: its azimuth, and its polar angle θh as a
share of the largest one that keeps the light above the horizon. With φ the azimuth from the view, the light
stands on the horizon where

    sinθo cosφ sin 2θh + cosθo cos 2θh = 0,  so that  θh ≤ π/4 + ½ atan2(sinθo cosφ, cosθo).

So the hemisphere of the light is the unit square, without a rest, and the mirror direction is the square's edge
at any view: a highlight stays where it is while the view moves. The edge is fine by a fourth root, as half-angle tables
are (Rusinkiewicz 1998; Matusik et al. 2003), and the map has no singular point there: the density is finite.

On the square the luminance of f_r cosθi, times the map's area, is tabulated at nodes for some views and bilinear in
between (:class:`GridDensity`). A share even in the projected solid angle is mixed in, so that the density is positive
wherever light can come from.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tensor.density import Blend, GridDensity, blend_weights

EVEN_SHARE = 0.03
"""Of the directions: those that follow the cosine alone."""

# Nodes over (polar angle of the view, azimuth of the half vector, its place along the polar angle).
_ISOTROPIC_NODES = (24, 73, 97)
_ANISOTROPIC_NODES = (12, 33, 49)
# Azimuths of the view, the first and the last the same one.
_AZIMUTHS = 17

# The last view (rad below 90°): at the horizon itself there is no reflectance to ask for.
_LAST_BELOW_HORIZON = 0.01

# Where the fourth root begins: the first of 96 steps is then 0.04° wide, a few of the first bins of a MERL table.
_START = 0.02
_STRETCH = (1.0 + _START**4) ** 0.25 - _START

# Directions are worked through in pieces: the interpolation holds a few dozen numbers for each.
_PIECE = 1 << 14


class HalfVectorDensity(mixture.MixtureSampled):
    """Samples directions to the light for any view, with their density.

    Parameters
    ----------
    reflectance
        What is to be sampled; it is evaluated at 170,000 pairs (310,000 where it is anisotropic), when the first
        direction or density is asked for. That keeps 3 MB (5 MB).
    isotropic
        Whether only the azimuth between light and view matters.
    views
        Polar angles, radians, of views that get a node of their own: those that were measured, where they are few.
    """

    def __init__(self, reflectance: Reflectance, *, isotropic: bool, views: npt.ArrayLike = ()) -> None:
        self._reflectance = reflectance
        self._isotropic = isotropic
        count, self._rows, self._columns = _ISOTROPIC_NODES if isotropic else _ANISOTROPIC_NODES
        self._phi_o: Floats = np.zeros(1) if isotropic else np.linspace(-math.pi, math.pi, _AZIMUTHS)
        last = 0.5 * math.pi - _LAST_BELOW_HORIZON
        even = last * np.sin(0.5 * math.pi * np.linspace(0.0, 1.0, count))
        own = np.asarray(views, float)
        self._theta_o: Floats = np.unique(np.concatenate((even, own[(own > 0.0) & (own < last)])))

    @property
    def _parts(self) -> tuple[mixture.MixturePart, mixture.MixturePart]:
        # Made anew each time: kept, they could not be sent to another process with their table.
        return mixture.diffuse(EVEN_SHARE), mixture.MixturePart(1.0 - EVEN_SHARE, self._draw, self._density)

    @cached_property
    def _grid(self) -> GridDensity:
        """The bilinear densities of all views with a node."""
        across, along = np.linspace(0.0, 1.0, self._columns), np.linspace(0.0, 1.0, self._rows)
        square = np.stack(np.meshgrid(across, along), axis=-1).reshape(-1, 2)
        phi, theta = np.meshgrid(self._phi_o, self._theta_o, indexing="ij")
        views = spherical(theta, phi).reshape(-1, 3)
        # All views in one call, which a table works through on several threads.
        wo, place = np.repeat(views, len(square), axis=0), np.tile(square, (len(views), 1))
        wi = self._to_light(place, wo)
        cosine = np.maximum(wi[:, 2], 0.0)
        light = (self._reflectance.eval(wi, wo) @ LUMINANCE * cosine).reshape(len(views), -1)
        # What is black may be sampled in any way.
        light = np.where(light.any(axis=1, keepdims=True), light, cosine.reshape(light.shape))
        grids = light * self._area(place, wi, wo).reshape(light.shape)
        return GridDensity(grids.reshape(len(views), self._rows, self._columns))

    def _draw(self, wo: Floats, u: Floats) -> Floats:
        out = np.empty_like(wo)
        for start in range(0, len(wo), _PIECE):
            piece = slice(start, start + _PIECE)
            square, _ = self._grid.sample(u[piece], self._blend(wo[piece]))
            out[piece] = self._to_light(square, wo[piece])
        return out

    def _density(self, wi: Floats, wo: Floats) -> Floats:
        out = np.zeros(len(wi))
        above = np.flatnonzero((wi[:, 2] > 0.0) & (wo[:, 2] > 0.0))
        for start in range(0, len(above), _PIECE):
            piece = above[start : start + _PIECE]
            light, view = wi[piece], wo[piece]
            square = self._to_square(light, view)
            out[piece] = self._grid.density(square, self._blend(view)) / self._area(square, light, view)
        return out

    def _blend(self, wo: Floats) -> Blend:
        theta, phi = _polar(wo)
        return blend_weights([self._phi_o, self._theta_o], [phi, theta])

    def _to_light(self, square: Floats, wo: Floats) -> Floats:
        """Return the directions to the light (n, 3) at places (n, 2) of the square: (share of θh, azimuth)."""
        _, phi_o = _polar(wo)
        phi = (2.0 * square[:, 1] - 1.0) * math.pi
        phi_h, turn = (phi + phi_o, phi) if self._isotropic else (phi, phi - phi_o)
        share = np.sqrt((_STRETCH * square[:, 0] + _START) ** 4 - _START**4)
        return warps.mirror_at(wo, spherical(share * _largest(wo, turn), phi_h))

    def _to_square(self, wi: Floats, wo: Floats) -> Floats:
        """Return the inverse of :meth:`_to_light`."""
        theta_h, phi_h = _polar(wi + wo)
        _, phi_o = _polar(wo)
        share = theta_h / _largest(wo, phi_h - phi_o)
        s = ((share * share + _START**4) ** 0.25 - _START) / _STRETCH
        t = ((phi_h - phi_o if self._isotropic else phi_h) + math.pi) / (2.0 * math.pi)
        return np.stack((np.clip(s, 0.0, 1.0), t - np.floor(t)), axis=1)

    def _area(self, square: Floats, wi: Floats, wo: Floats) -> Floats:
        """Return the solid angle of the light (n,) per area of the square."""
        total = wi + wo
        theta_h, phi_h = _polar(total)
        largest = _largest(wo, phi_h - _polar(wo)[1])
        # sinθ dθ is ½ sinθ/θ d(θ²), and θ² the fourth power of the place; |wi + wo| is 2 wo·h.
        steps = 4.0 * _STRETCH * (_STRETCH * square[:, 0] + _START) ** 3
        half = np.sinc(theta_h / math.pi) * largest * largest * steps * math.pi
        return np.asarray(2.0 * np.sqrt(np.einsum("ni,ni->n", total, total)) * half)


class HalfVectorSampled(mixture.MixtureSampled):
    """Base of a reflectance that is sampled about as its values are, by a :class:`HalfVectorDensity`."""

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        raise NotImplementedError

    @property
    def _parts(self) -> Sequence[mixture.MixturePart]:
        return self._sampler._parts


def _largest(wo: Floats, turn: Floats) -> Floats:
    """Return θh (n,) that puts the light on the horizon, for half vectors at the azimuth ``turn`` from the view."""
    sine = np.hypot(wo[:, 0], wo[:, 1])
    lean = np.arctan2(sine * np.cos(turn), np.maximum(wo[:, 2], 0.0))
    return np.asarray(0.25 * math.pi + 0.5 * lean)


def _polar(w: Floats) -> tuple[Floats, Floats]:
    return np.arctan2(np.hypot(w[:, 0], w[:, 1]), w[:, 2]), np.arctan2(w[:, 1], w[:, 0])
