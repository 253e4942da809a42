"""Protocol of all reflectances."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol, TypeGuard, runtime_checkable

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter


@runtime_checkable
class Reflectance(Protocol):
    """A BRDF of the working space, linear RGB with the primaries of Rec. 2020."""

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine, never negative; 0 below the horizon.

        Parameters
        ----------
        wi, wo
            Unit directions (..., 3) to the light and to the viewer, local frame with z along the normal;
            they broadcast.
        """
        ...


class SampledReflectance(Reflectance, Protocol):
    """A reflectance that can be path-traced: every model, every measured table, every designed paint."""

    def sample(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return directions (..., 3) to the light for views ``wo`` and ``u`` (..., 3), even in [0, 1).

        Some may lie below the horizon, where the light is lost.
        """
        ...

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle; 0 where either direction is below the horizon."""
        ...


@runtime_checkable
class DeclaredModel(Reflectance, Protocol):
    """A model: a frozen dataclass that declares its numbers and says what it keeps."""

    @property
    def parameters(self) -> Mapping[str, Parameter]:
        """The declarations of its numbers and colours, by field."""
        ...

    @property
    def reciprocal(self) -> bool:
        """Whether light and view may be exchanged."""
        ...

    @property
    def energy_conserving(self) -> bool:
        """Whether no more light is reflected than arrives."""
        ...


class Layered(Protocol):
    """A reflectance of two layers: f_r = base + coat."""

    @property
    def base(self) -> Reflectance:
        """The base: pigment, flakes and wide lobes, seen from outside."""
        ...

    @property
    def coat(self) -> Reflectance:
        """The coat: the specular reflection of the first surface."""
        ...

    @property
    def ior(self) -> float:
        """Refractive index of the coat, at least 1; 1 where there is none."""
        ...

    @property
    def base_under_coat(self) -> bool:
        """Whether light for the base crosses the coat, so that T² applies."""
        ...


@runtime_checkable
class SpectralReflectance(Protocol):
    """A reflectance with optional spectra; ``wavelengths_nm`` is ``None`` without them."""

    @property
    def wavelengths_nm(self) -> npt.NDArray[np.floating] | None:
        """Return the bands (k,), nanometres."""
        ...

    def eval_spectra(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., k) in 1/sr, without the cosine."""
        ...


def has_spectra(reflectance: object) -> TypeGuard[SpectralReflectance]:
    """Return whether the reflectance can be recomputed under any light."""
    return isinstance(reflectance, SpectralReflectance) and reflectance.wavelengths_nm is not None
