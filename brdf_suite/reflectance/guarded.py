"""A reflectance of a plug-in: its values checked, its failures named, and a sampler for the path tracers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import PluginError
from brdf_suite.plugins import Plugin
from brdf_suite.reflectance.half_vector_density import HalfVectorDensity, HalfVectorSampled
from brdf_suite.reflectance.isotropy import is_isotropic
from brdf_suite.reflectance.protocol import DeclaredModel, Reflectance

_SUITE = "brdf_suite."


@dataclass(frozen=True, eq=False)
class GuardedReflectance(HalfVectorSampled):
    """The reflectance ``inner`` of a plug-in, with the facts of the file that it was read from."""

    inner: Reflectance
    plugin: Plugin
    facts: dict[str, object]

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon.

        Raises :class:`PluginError`: the plug-in fails, or its values are not of the shape of the directions.
        """
        light, view = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        with self.plugin.blamed():
            found = np.asarray(self.inner.eval(light, view), np.float64)
        if found.shape != light.shape:
            raise PluginError(
                f"The {self.plugin} failed: its values have the shape {found.shape}, the directions {light.shape}."
            )
        above = (light[..., 2:] > 0.0) & (view[..., 2:] > 0.0)
        return np.where(above, found, 0.0)

    @property
    def parameters(self) -> Mapping[str, Parameter]:
        """The declarations of a model's numbers; empty for a measurement."""
        return self.inner.parameters if isinstance(self.inner, DeclaredModel) else {}

    @property
    def reciprocal(self) -> bool | None:
        """Whether light and view may be exchanged; None where nothing is declared."""
        return self.inner.reciprocal if isinstance(self.inner, DeclaredModel) else None

    @property
    def energy_conserving(self) -> bool | None:
        """Whether no more light is reflected than arrives; None where nothing is declared."""
        return self.inner.energy_conserving if isinstance(self.inner, DeclaredModel) else None

    @cached_property
    def isotropic(self) -> bool:
        """Whether only the azimuth between light and view matters, as far as its values show."""
        return is_isotropic(self)

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        return HalfVectorDensity(self, isotropic=self.isotropic)


def is_own(value: Reflectance) -> bool:
    """Return whether a reflectance is of the suite's own classes, which need no guard."""
    return type(value).__module__.startswith(_SUITE)
