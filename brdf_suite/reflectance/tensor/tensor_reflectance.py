"""A reflectance measured in the adaptive parameterization of Dupuy & Jakob (2018), as RGL publishes it.

For each incident direction the square is warped by the density of visible normals, so that a coarse grid of
values follows the highlight. With u_m the half vector in the square and s its place before the warp:

    f_r(wi, wo) · cos θo = V(s; wi) · D(u_m) / (4 σ(wi))

where V are the stored values, D the distribution of normals and σ the projected area of the microsurface seen
from wi. The last factor is left out where the file says so. Polar angles enter as u = √(2θ/π), azimuths as
(φ + π)/2π. The values hold the cosine of the reflected direction; ``eval`` takes it out again.

Values are RGB of Rec. 709, or spectra; both go to the working space on reading them out, where negative ones
(the interpolation of a measurement makes some) become 0.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, clipping_notice
from brdf_suite.appearance.colour.spectra import spectrum_to_working
from brdf_suite.arrays import Floats, Singles
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.half_vector_density import HalfVectorDensity, HalfVectorSampled
from brdf_suite.reflectance.tensor.density import Blend, GridDensity, bilinear, blend_weights, cells

# Directions are worked through in pieces: the interpolation holds a few dozen numbers for each.
_PIECE = 1 << 14

# The half vector at the normal: the map from the square to directions has no area there.
_SMALLEST_JACOBIAN = 1e-6


@dataclass(frozen=True, eq=False)
class TensorReflectance(HalfVectorSampled):
    """The arrays of one measured material; all angles in radians.

    Parameters
    ----------
    phi_i, theta_i
        Incident directions (p,), (t,), increasing. Up to two azimuths: an isotropic material, whose half
        vectors are relative to the azimuth of ``wi``.
    ndf, sigma
        (rows over φ, columns over θ): D of the half vector and σ of the incident direction, 1/sr and 1.
    vndf, luminance
        (p, t, ny, nx): the densities that warp the square, and that of the values on it.
    values
        (p, t, c, m, m): RGB of Rec. 709 (c = 3), or spectra at ``wavelengths_nm`` (c,).
    jacobian
        Whether the factor D/(4σ) is applied.
    observer_deg
        2 or 10: the observer through which spectra become colour.
    other
        Further fields of the file (its version, the mask of valid values), kept for writing.
    """

    phi_i: Singles
    theta_i: Singles
    ndf: Singles
    sigma: Singles
    vndf: Singles
    luminance: Singles
    values: Singles
    wavelengths_nm: Singles | None = None
    jacobian: bool = True
    description: str = ""
    observer_deg: int = 10
    source: str = ""
    other: Mapping[str, npt.NDArray[np.generic]] = field(default_factory=dict)

    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})
    # Measured for light from wi; noise and interpolation make the swapped pair differ by some percent.
    reciprocal: ClassVar[bool] = False
    energy_conserving: ClassVar[bool] = False

    @property
    def isotropic(self) -> bool:
        """Whether only the azimuth between the directions counts."""
        return len(self.phi_i) <= 2

    @property
    def facts(self) -> dict[str, object]:
        """Facts of the measurement, for tables and dialogs."""
        facts: dict[str, object] = {
            "name": self.description,
            "kind": "isotropic" if self.isotropic else "anisotropic",
            "incident directions": len(self.phi_i) * len(self.theta_i),
            "values per incident direction": f"{self.values.shape[3]} x {self.values.shape[4]}",
        }
        if self.wavelengths_nm is None:
            facts["colour"] = "RGB, Rec. 709"
        else:
            low, high = float(self.wavelengths_nm[0]), float(self.wavelengths_nm[-1])
            facts["colour"] = f"{len(self.wavelengths_nm)} bands, {low:g} to {high:g} nm"
            facts["observer_deg"] = self.observer_deg
            if self._clipping:
                facts["notes"] = self._clipping
        return facts

    @cached_property
    def _clipping(self) -> tuple[str, ...]:
        theta, phi = np.meshgrid(np.linspace(0.0, 1.4, 12), np.linspace(0.0, math.pi, 9))
        channels = self.eval_spectra(spherical([[[0.2]], [[0.8]]], 0.0), spherical(theta, phi))
        return clipping_notice(channels.reshape(-1, channels.shape[-1]) @ self.to_working, " on a test grid")

    @cached_property
    def _visible(self) -> GridDensity:
        return GridDensity(self.vndf)

    @cached_property
    def _brightness(self) -> GridDensity:
        return GridDensity(np.maximum(self.luminance, 0.0))

    @cached_property
    def to_working(self) -> Floats:
        """Return the matrix (c, 3) from the stored channels to the working space; both conversions are linear."""
        if self.wavelengths_nm is None:
            return np.ascontiguousarray(REC709_TO_WORKING.T)
        bands = np.asarray(self.wavelengths_nm, np.float64)
        return np.asarray(spectrum_to_working(np.eye(len(bands)), bands, self.observer_deg), np.float64)

    @cached_property
    def _reduction(self) -> int:
        """How often the measured range of azimuths fits into a turn: 2 and 4 are mirrored or turned copies."""
        if self.isotropic:
            return 0
        return round(2.0 * math.pi / float(self.phi_i[-1] - self.phi_i[0]))

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3), working space, 1/sr, without the cosine, never negative; 0 below the horizon."""
        # Made before the threads of in_blocks would each make their own.
        to_working, _ = self.to_working, self._visible
        return in_blocks(lambda i, o: np.maximum(self.eval_channels(i, o) @ to_working, 0.0), wi, wo)

    def eval_spectra(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., k) at ``wavelengths_nm``, 1/sr, never negative.

        Raises
        ------
        ValueRangeError
            The material was measured in RGB.
        """
        if self.wavelengths_nm is None:
            raise ValueRangeError("spectra", "this material was measured in RGB, it has no spectra")
        return np.maximum(self.eval_channels(wi, wo), 0.0)

    def eval_channels(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., c) in the file's own channels, 1/sr; interpolation may leave it below 0."""
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        shape = wi.shape[:-1]
        wi, wo = wi.reshape(-1, 3), wo.reshape(-1, 3)
        out = np.zeros((len(wi), self.values.shape[2]))
        seen = np.flatnonzero((wi[:, 2] > 0.0) & (wo[:, 2] > 0.0))
        for start in range(0, len(seen), _PIECE):
            piece = seen[start : start + _PIECE]
            out[piece] = self._piece(wi[piece], wo[piece])
        return out.reshape(*shape, out.shape[1])

    def _piece(self, wi: Floats, wo: Floats) -> Floats:
        wi, wo, _ = self._reduce(wi, wo)
        u_i, u_m, blend, _ = self._coordinates(wi, wo)
        place, _ = self._visible.invert(u_m, blend)
        out = self._values_at(place, blend)
        factor = 1.0 / wo[:, 2]
        if self.jacobian:
            single = [(np.zeros(len(wi), np.intp), np.ones(len(wi)))]
            area = 4.0 * bilinear(self.sigma[None], u_i, single)
            normals = bilinear(self.ndf[None], u_m, single)
            factor *= np.divide(normals, area, out=np.zeros_like(area), where=area > 0.0)
        return out * factor[:, None]

    def _values_at(self, place: Floats, blend: Blend) -> Floats:
        """Return V (n, c): :func:`bilinear` for all channels, whose places and weights are the same."""
        channels, ny, nx = self.values.shape[2:]
        column, x = cells(nx, place[:, 0])
        row, y = cells(ny, place[:, 1])
        corner = row * nx + column
        flat = self.values.reshape(-1)
        total = np.zeros((channels, len(place)))
        for grid, weight in blend:
            first = grid * (channels * ny * nx) + corner
            for step, share in (
                (0, (1.0 - x) * (1.0 - y)),
                (1, x * (1.0 - y)),
                (nx, (1.0 - x) * y),
                (nx + 1, x * y),
            ):
                at, part = first + step, weight * share
                for channel in range(channels):
                    total[channel] += part * flat[at + channel * (ny * nx)]
        return total.T

    def _reduce(self, wi: Floats, wo: Floats) -> tuple[Floats, Floats, Floats]:
        """Turn or mirror both directions into the measured range of azimuths; also return the signs (n, 2)."""
        signs = np.ones((len(wi), 2))
        if self._reduction >= 2:
            signs[:, 1] = -np.copysign(1.0, wi[:, 1])
            signs[:, 0] = -np.copysign(1.0, wi[:, 0]) if self._reduction == 4 else signs[:, 1]
            wi, wo = wi.copy(), wo.copy()
            wi[:, :2] *= signs
            wo[:, :2] *= signs
        return wi, wo, signs

    def _coordinates(self, wi: Floats, wo: Floats) -> tuple[Floats, Floats, Blend, Floats]:
        """Return u of the incident direction and of the half vector, the blend, and the half vector."""
        half = wi + wo
        half = half / np.sqrt(np.einsum("ni,ni->n", half, half))[:, None]
        theta_i, phi_i = _polar(wi)
        theta_m, phi_m = _polar(half)
        polar_i, polar_m = (np.sqrt(theta * (2.0 / math.pi)) for theta in (theta_i, theta_m))
        turn_m = phi_m - phi_i if self.isotropic else phi_m
        turn_i, turn_m = ((phi + math.pi) * (0.5 / math.pi) for phi in (phi_i, turn_m))
        u_i = np.stack((polar_i, turn_i), axis=1)
        u_m = np.stack((polar_m, turn_m - np.floor(turn_m)), axis=1)
        return u_i, u_m, self._blend(phi_i, theta_i), half

    def _blend(self, phi_i: Floats, theta_i: Floats) -> Blend:
        axes = [np.asarray(self.phi_i, np.float64), np.asarray(self.theta_i, np.float64)]
        return blend_weights(axes, [phi_i, theta_i])

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        return HalfVectorDensity(self, isotropic=self.isotropic)

    def sample_stored(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return a direction to the light (..., 3) for the view ``wo`` and uniform ``u`` (..., 2), as the file has it.

        It follows the file's own luminance with ``wo`` as the incident direction, as other readers do; its density
        is :meth:`pdf_stored`. Some directions fall below the horizon, where ``eval`` is 0; and where the stored
        luminance is 0 none are drawn, though ``eval`` need not be 0 there. :meth:`sample` has neither fault.
        """
        wo, u = np.asarray(wo, float), np.asarray(u, float)
        shape = np.broadcast_shapes(wo.shape[:-1], u.shape[:-1])
        wo = np.broadcast_to(wo, (*shape, 3)).reshape(-1, 3)
        u = np.broadcast_to(u[..., :2], (*shape, 2)).reshape(-1, 2)
        turned, _, signs = self._reduce(wo, wo)
        theta, phi = _polar(turned)
        blend = self._blend(phi, theta)
        place, _ = self._brightness.sample(u[:, ::-1], blend)
        u_m, _ = self._visible.sample(place, blend)
        phi_m = (2.0 * u_m[:, 1] - 1.0) * math.pi + (phi if self.isotropic else 0.0)
        half = spherical(u_m[:, 0] ** 2 * (0.5 * math.pi), phi_m)
        wi = 2.0 * np.einsum("ni,ni->n", half, turned)[:, None] * half - turned
        wi[:, :2] *= signs
        return np.asarray(wi.reshape(*shape, 3))

    def pdf_stored(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...), 1/sr, of :meth:`sample_stored` giving ``wi`` for the view ``wo``."""
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        shape = wi.shape[:-1]
        wi, wo = wi.reshape(-1, 3), wo.reshape(-1, 3)
        out = np.zeros(len(wi))
        seen = np.flatnonzero((wi[:, 2] > 0.0) & (wo[:, 2] > 0.0))
        if seen.size:
            view, light, _ = self._reduce(wo[seen], wi[seen])
            _, u_m, blend, half = self._coordinates(view, light)
            place, density = self._visible.invert(u_m, blend)
            density = density * self._brightness.density(place, blend)
            sine = np.hypot(half[:, 0], half[:, 1])
            # dω_m = 2π² u sin θm du; the reflection stretches it by 4 cos of the angle to the half vector.
            area = np.maximum(2.0 * math.pi**2 * u_m[:, 0] * sine, _SMALLEST_JACOBIAN)
            out[seen] = density / (area * 4.0 * np.einsum("ni,ni->n", view, half))
        return np.asarray(out.reshape(shape))


def _polar(w: Floats) -> tuple[Floats, Floats]:
    return np.arctan2(np.hypot(w[:, 0], w[:, 1]), w[:, 2]), np.arctan2(w[:, 1], w[:, 0])
