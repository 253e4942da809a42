"""An anisotropic reflectance tabulated over the four angles of light and view."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from itertools import product
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Indices, Singles
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.blocks import in_blocks, look_up_above
from brdf_suite.reflectance.half_vector_density import HalfVectorDensity, HalfVectorSampled
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True, eq=False)
class AnisotropicTable(HalfVectorSampled):
    """Values at nodes (θi, φi, θo, φo), looked up linearly along θi, θo, φi and the azimuth *between* the two.

    Linear along φo itself would cut a highlight between two nodes of φi in half: it stands opposite the
    light, and the nodes beside it at the same φo miss it. Along φo - φi it stays where it is.

    Attributes
    ----------
    values
        (n, a, m, a, 3) float32, f_r in 1/sr, working space, without the cosine, finite, not negative. The
        azimuths of light and view are a each, evenly over 2π, the first along x.
    theta_i, theta_o
        (n,) and (m,) polar angles of the nodes, radians, rising, 0 to π/2. Outside them the value of the
        last node is held.
    source, facts
        Where the data come from, and what the reader learned, for the user.

    Raises
    ------
    ValueRangeError
        A shape does not fit, an angle is out of range, or a value is not finite or negative.
    """

    values: Singles
    theta_i: Floats
    theta_o: Floats
    source: str = ""
    facts: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))

    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})
    # Between nodes φi is the reference and φo is not, so even reciprocal nodes give a slightly uneven pair.
    reciprocal: ClassVar[bool] = False

    def __post_init__(self) -> None:
        values = np.ascontiguousarray(self.values, np.float32).view()
        thetas = {}
        for name in ("theta_i", "theta_o"):
            nodes = np.array(getattr(self, name), np.float64)
            if (
                nodes.ndim != 1
                or nodes.size < 2
                or not ((nodes >= 0.0) & (nodes <= np.pi / 2)).all()
                or not (np.diff(nodes) > 0.0).all()
            ):
                raise ValueRangeError(name, "must be two or more angles that rise, from 0 to π/2")
            nodes.flags.writeable = False
            thetas[name] = nodes
        wanted = (thetas["theta_i"].size, -1, thetas["theta_o"].size, -1, 3)
        if values.ndim != 5 or any(w not in (-1, n) for w, n in zip(wanted, values.shape, strict=True)):
            raise ValueRangeError("values", f"has the shape {values.shape}; expected {wanted}")
        if values.shape[1] != values.shape[3] or values.shape[1] < 2:
            raise ValueRangeError(
                "values", f"has {values.shape[1]} and {values.shape[3]} azimuths; as many of both"
            )
        # A NaN is neither.
        if not (values.min() >= 0.0 and values.max() < np.inf):
            at = np.argwhere(~((values >= 0.0) & (values < np.inf)))[0].tolist()
            raise ValueRangeError(f"values{at}", "is not finite or is negative; a reflectance is neither")
        values.flags.writeable = False
        object.__setattr__(self, "values", values)
        for name, nodes in thetas.items():
            object.__setattr__(self, name, nodes)

    @classmethod
    def from_reflectance(
        cls,
        reflectance: Reflectance,
        theta: npt.ArrayLike,
        azimuths: int,
        *,
        source: str = "",
        facts: Mapping[str, Any] | None = None,
    ) -> AnisotropicTable:
        """Tabulate ``reflectance`` at polar angles ``theta`` (radians, below π/2) of light and view."""
        theta = np.asarray(theta, np.float64)
        phi = 2.0 * np.pi * np.arange(azimuths) / azimuths
        w = spherical(theta[:, None], phi[None, :])
        values = np.stack([reflectance.eval(light[:, None, None, :], w[None]) for light in w])
        return cls(values.astype(np.float32), theta, theta, source, facts or {})

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, working space, without the cosine; 0 below the horizon."""

        return in_blocks(partial(look_up_above, self._look_up), wi, wo)

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        return HalfVectorDensity(self, isotropic=False)

    def made_reciprocal(self) -> AnisotropicTable:
        """Return the table with each node the mean of the pair and its swap.

        Raises
        ------
        ValueRangeError
            The polar angles of light and view are not the same.
        """
        if not np.array_equal(self.theta_i, self.theta_o):
            raise ValueRangeError("theta_o", "differs from theta_i, so no node is another's swap")
        return replace(self, values=0.5 * (self.values + self.values.transpose(2, 3, 0, 1, 4)))

    def _look_up(self, i: Floats, o: Floats) -> Singles:
        _, azimuths, polar_o, _, _ = self.values.shape
        rows = self.values.reshape(-1, 3)
        phi_i = np.arctan2(i[1], i[0])
        light, light_share = _between(self.theta_i, i)
        view, view_share = _between(self.theta_o, o)
        turn, turn_share = _around(phi_i, azimuths)
        apart, apart_share = _around(np.arctan2(o[1], o[0]) - phi_i, azimuths)
        total = np.zeros((i.shape[1], 3), np.float32)
        for a, b, c, d in product((0, 1), repeat=4):
            weight = light_share[a] * view_share[b] * turn_share[c] * apart_share[d]
            phi = (turn + c) % azimuths
            row = (((light + a) * azimuths + phi) * polar_o + view + b) * azimuths
            row += (phi + apart + d) % azimuths
            total += weight[:, None] * rows.take(row, axis=0)
        return total


def _between(nodes: Floats, w: Floats) -> tuple[Indices, tuple[Singles, Singles]]:
    """Return the lower of the two nodes about the polar angle of w (3, n), and the shares of both."""
    theta = np.clip(np.arctan2(np.hypot(w[0], w[1]), w[2]), nodes[0], nodes[-1])
    low = np.clip(np.searchsorted(nodes, theta, side="right") - 1, 0, nodes.size - 2)
    share = ((theta - nodes[low]) / (nodes[low + 1] - nodes[low])).astype(np.float32)
    return low, (1.0 - share, share)


def _around(phi: Floats, azimuths: int) -> tuple[Indices, tuple[Singles, Singles]]:
    """Return the lower node (n,), 0 to ``azimuths`` - 1, about azimuths in radians, and the shares of both."""
    place = phi * (azimuths / (2.0 * np.pi))
    floor = np.floor(place)
    share = (place - floor).astype(np.float32)
    return floor.astype(np.intp) % azimuths, (1.0 - share, share)
