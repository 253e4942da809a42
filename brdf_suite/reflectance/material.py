"""A material: anything that reflects, with what is known of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes, OrangePeel, Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import ValueRangeError
from brdf_suite.notebook import Shown
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True, eq=False)
class Material(Shown):
    """Anything that reflects: a paint of any kind, measured data, a model.

    :func:`brdf_suite.pipeline.material.load_material` makes one from a name or a file.

    Parameters
    ----------
    name
        What the user calls it.
    reflectance
        f_r in 1/sr, linear Rec. 2020; of designed paints a
        :class:`~brdf_suite.reflectance.designed.paint_reflectance.PaintReflectance`.
    origin
        The name or path by which it was asked for, which distinguishes materials that share a ``name``; empty where
        it comes from neither.
    document
        The paint document that it was built from; None for measured data and models.
    flakes, orange_peel
        What is seen of the base and of the coat from near; None where there are none, or none are known.
    notices
        Sentences for the user about how it was read and built.
    facts
        What a measured file says of itself, for tables and dialogs.
    observer_deg
        2 or 10: the observer through which measured spectra became colour.

    >>> import brdf_suite as bs
    >>> blue = bs.load("blue", bs.Material)
    >>> blue.eval([0.0, 0.0, 1.0], [0.6, 0.0, 0.8]).shape
    (3,)
    """

    name: str
    reflectance: Reflectance
    origin: str = ""
    document: AnyPaint | None = None
    flakes: Flakes | None = None
    orange_peel: OrangePeel | None = None
    notices: tuple[str, ...] = ()
    facts: Mapping[str, object] = field(default_factory=dict)
    observer_deg: int = 10

    @property
    def paint(self) -> Paint | None:
        """The document where it is a paint designed by its readings."""
        return self.document if isinstance(self.document, Paint) else None

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, linear Rec. 2020, without the cosine; 0 below the horizon.

        Parameters
        ----------
        wi, wo
            Unit directions (..., 3) to the light and to the viewer, local frame with z along the normal; they
            broadcast.

        Raises
        ------
        ValueRangeError
            A shape does not fit, or a direction is not finite or not of unit length.

        >>> import brdf_suite as bs
        >>> wi, wo = bs.spherical([0.2, 0.4], 0.0), bs.spherical([0.3, 0.5], 3.0)
        >>> bs.load("blue", bs.Material).eval(wi, wo).shape
        (2, 3)
        """
        light, view = _directions(wi, "wi"), _directions(wo, "wo")
        try:
            np.broadcast_shapes(light.shape, view.shape)
        except ValueError as error:
            raise ValueRangeError("wi and wo", f"{light.shape} and {view.shape} do not broadcast") from error
        return self.reflectance.eval(light, view)


_UNIT = 1e-3


def _directions(given: npt.ArrayLike, place: str) -> Floats:
    """Return directions as numbers, checked as :meth:`Material.eval` wants them."""
    found = np.asarray(given, np.float64)
    if found.ndim == 0 or found.shape[-1] != 3:
        raise ValueRangeError(place, f"expected directions of the shape (..., 3), not {found.shape}")
    lengths = np.linalg.norm(found, axis=-1)
    wrong = ~(np.abs(lengths - 1.0) <= _UNIT)  # also where a length is not finite
    if wrong.any():
        at = tuple(np.argwhere(wrong)[0].tolist())
        raise ValueRangeError(
            f"{place}{list(at) if at else ''}",
            f"expected a direction of length 1, not {lengths[at]:g}; divide by np.linalg.norm({place}, axis=-1, "
            "keepdims=True)",
        )
    return found
