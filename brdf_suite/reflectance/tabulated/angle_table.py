"""A reflectance tabulated on a grid of four angles, linear between its nodes.

The angles are those of one of three coordinate systems:

| coordinates | the four angles |
|---|---|
| ``spherical`` | polar angle and azimuth of the light, polar angle and azimuth of the view |
| ``specular`` | polar angle and azimuth of the light; the view's angle from the mirror direction, and turn about it |
| ``half_difference`` | polar angle and azimuth of the half vector; θd and φd of the light (Rusinkiewicz 1998) |

The turn about the mirror direction is 0 towards the normal. One azimuth of the light, or of the half vector, is an
isotropic table. Beyond the first and the last node of an angle the nearest node holds; azimuths go round.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import product
from types import MappingProxyType
from typing import Any, ClassVar, Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.spectra import spectrum_to_working
from brdf_suite.arrays import Floats, Indices, Singles
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import half_angle_coordinates
from brdf_suite.reflectance.blocks import in_blocks, look_up_above
from brdf_suite.reflectance.half_vector_density import HalfVectorDensity, HalfVectorSampled

Coordinates = Literal["spherical", "specular", "half_difference"]

_TURN = 2.0 * math.pi
_SAME = 1e-6
# Bands of spectra are read out for fewer pairs at a time.
_SPECTRAL_BLOCK = 2048


@dataclass(frozen=True, eq=False)
class AngleTable(HalfVectorSampled):
    """A table of colours or spectra over four angles.

    Attributes
    ----------
    coordinates
        What the angles are.
    axes
        Four rising lists of nodes (n0,), (n1,), (n2,), (n3,), radians.
    values
        (n0, n1, n2, n3, c) float32, f_r in 1/sr without the cosine, finite and not negative: c = 1 for grey, 3 for
        colours of the working space, or as many as there are wavelengths.
    mirrored
        Whether the table is mirror-symmetric about the plane of incidence, and holds one half.
    reciprocal
        Whether φd counts modulo 180°, for ``half_difference`` alone.
    offsets
        Angles (n0,) by which ``specular`` moves the mirror direction away from the normal, or None.
    wavelengths_nm, observer_deg
        Rising bands (c,) of spectra, or None; and the observer, 2 or 10, through which they become colour under D65.
    source, facts
        Where the data come from, and what the reader learned, for the user.

    Raises
    ------
    ValueRangeError
        A shape does not fit, nodes do not rise, or a value is not finite or negative.
    """

    coordinates: Coordinates
    axes: tuple[Floats, Floats, Floats, Floats]
    values: Singles
    mirrored: bool = False
    reciprocal: bool = False
    offsets: Floats | None = None
    wavelengths_nm: Floats | None = None
    observer_deg: int = 10
    source: str = ""
    facts: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))

    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})

    def __post_init__(self) -> None:
        values = np.ascontiguousarray(self.values, np.float32).view()
        axes = tuple(np.array(axis, np.float64) for axis in self.axes)
        for index, axis in enumerate(axes):
            if axis.ndim != 1 or not axis.size or not (np.diff(axis) > 0.0).all():
                raise ValueRangeError(f"axes[{index}]", "must be one or more angles that rise")
        channels = (1, 3) if self.wavelengths_nm is None else (len(self.wavelengths_nm),)
        wanted = tuple(axis.size for axis in axes)
        if values.ndim != 5 or values.shape[:4] != wanted or values.shape[4] not in channels:
            raise ValueRangeError("values", f"has the shape {values.shape}; expected {(*wanted, channels)}")
        if not (values.min() >= 0.0 and values.max() < np.inf):  # a NaN is neither
            at = np.argwhere(~((values >= 0.0) & (values < np.inf)))[0].tolist()
            raise ValueRangeError(f"values{at}", "is not finite or is negative; a reflectance is neither")
        values.flags.writeable = False
        object.__setattr__(self, "values", values)
        object.__setattr__(self, "axes", axes)

    @property
    def isotropic(self) -> bool:
        """Whether there is one azimuth only."""
        return self.axes[1].size == 1

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, working space, without the cosine; 0 below the horizon."""
        if self.wavelengths_nm is None:
            return in_blocks(partial(look_up_above, self._colours), wi, wo)
        return np.maximum(self.eval_spectra(wi, wo) @ self._to_working, 0.0)

    def eval_spectra(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., k) in 1/sr at ``wavelengths_nm``; 0 below the horizon.

        Raises
        ------
        ValueRangeError
            The table holds no spectra.
        """
        if self.wavelengths_nm is None:
            raise ValueRangeError("spectra", "this table holds colours only, no spectra")
        wi, wo = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        light, view = wi.reshape(-1, 3), wo.reshape(-1, 3)
        out = np.empty((len(light), self.values.shape[4]))
        for start in range(0, len(light), _SPECTRAL_BLOCK):
            part = slice(start, start + _SPECTRAL_BLOCK)
            out[part] = look_up_above(self._look_up, light[part], view[part], out.shape[1])
        return out.reshape(*wi.shape[:-1], out.shape[1])

    @cached_property
    def _to_working(self) -> Floats:
        bands = np.asarray(self.wavelengths_nm, np.float64)
        return np.asarray(spectrum_to_working(np.eye(len(bands)), bands, self.observer_deg), np.float64)

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        return HalfVectorDensity(self, isotropic=self.isotropic)

    def _colours(self, i: Floats, o: Floats) -> Singles:
        found = self._look_up(i, o)
        return found if found.shape[1] == 3 else np.repeat(found, 3, axis=1)

    def _look_up(self, i: Floats, o: Floats) -> Singles:
        """Return (n, c) for directions (3, n) above the horizon."""
        first, phi, third, turn = self._angles(i, o)
        shape = self.values.shape
        rows = self.values.reshape(-1, shape[4])
        low0, share0 = _between(self.axes[0], first)
        low1, share1 = _around(self.axes[1], phi)
        low2, share2 = _between(self.axes[2], third)
        total = np.zeros((i.shape[1], shape[4]), np.float32)
        for b in (0, 1) if shape[1] > 1 else (0,):
            node1 = (low1 + b) % shape[1]
            # The azimuth *between* light and view is kept, or a highlight between two nodes would be cut in half.
            seen = turn + self.axes[1][node1] - phi if self.coordinates == "spherical" else turn
            low3, share3 = self._around_last(seen, self.axes[1][node1])
            for a, c, d in product(*((0, 1) if shape[axis] > 1 else (0,) for axis in (0, 2, 3))):
                weight = share0[a] * share1[b] * share2[c] * share3[d]
                row = ((low0 + a) * shape[1] + node1) * shape[2] + low2 + c
                row = row * shape[3] + (low3 + d) % shape[3]
                total += weight[:, None] * rows.take(row, axis=0)
        return total

    def _angles(self, i: Floats, o: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        if self.coordinates == "half_difference":
            return half_angle_coordinates(i.T, o.T)
        theta, phi = np.arctan2(np.hypot(i[0], i[1]), i[2]), np.arctan2(i[1], i[0])
        if self.coordinates == "spherical":
            return theta, phi, np.arctan2(np.hypot(o[0], o[1]), o[2]), np.arctan2(o[1], o[0])
        lean = theta if self.offsets is None else theta + np.interp(theta, self.axes[0], self.offsets)
        c, s = np.cos(phi), np.sin(phi)
        x, y = c * o[0] + s * o[1], c * o[1] - s * o[0]
        c, s = np.cos(lean), np.sin(lean)
        x, z = c * x + s * o[2], c * o[2] - s * x
        return theta, phi, np.arctan2(np.hypot(x, y), z), np.arctan2(y, x)

    def _around_last(self, angle: Floats, plane: Floats) -> tuple[Indices, tuple[Singles, Singles]]:
        """Return the lower node (n,) of the last angle and the shares; the table may hold a part of the turn."""
        axis = self.axes[3]
        if self.reciprocal:
            angle = np.mod(angle, math.pi)
            if self.mirrored:
                angle = np.minimum(angle, math.pi - angle)
                return _between(axis, angle)
            return _around(axis, angle, math.pi)
        if self.mirrored:
            away = np.mod(angle - plane, _TURN) if self.coordinates == "spherical" else np.mod(angle, _TURN)
            return _between(axis, np.minimum(away, _TURN - away))
        return _around(axis, angle)


def _between(nodes: Floats, angle: Floats) -> tuple[Indices, tuple[Singles, Singles]]:
    """Return the lower of the two nodes about angles (n,), and the shares of both."""
    if nodes.size == 1:
        return _alone(len(angle))
    low = np.clip(np.searchsorted(nodes, angle, side="right") - 1, 0, nodes.size - 2)
    share = np.clip((angle - nodes[low]) / (nodes[low + 1] - nodes[low]), 0.0, 1.0).astype(np.float32)
    return low, (1.0 - share, share)


def _around(nodes: Floats, angle: Floats, period: float = _TURN) -> tuple[Indices, tuple[Singles, Singles]]:
    """Return the lower node about azimuths (n,), and the shares; the node after the last is the first."""
    if nodes.size == 1:
        return _alone(len(angle))
    place = nodes[0] + np.mod(angle - nodes[0], period)
    low = np.clip(np.searchsorted(nodes, place, side="right") - 1, 0, nodes.size - 1)
    closed = np.append(nodes, max(nodes[0] + period, nodes[-1] + _SAME))
    share = np.clip((place - nodes[low]) / (closed[low + 1] - nodes[low]), 0.0, 1.0).astype(np.float32)
    return low, (1.0 - share, share)


def _alone(count: int) -> tuple[Indices, tuple[Singles, Singles]]:
    return np.zeros(count, np.intp), (np.ones(count, np.float32), np.zeros(count, np.float32))
