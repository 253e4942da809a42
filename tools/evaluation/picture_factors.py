"""Image as a product of functions of one variable: the two-dimensional example of the paper's Figure 2.

f(x, y) ≈ Π_k p_k(π_k(x, y)), π one of x, y, x - y, x + y (McCool, Ang and Ahmad 2001, section 3.3). It is the same
factorization as of a reflectance, with pixels in place of pairs of directions, and shows what it can do and cannot.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.fitting.homomorphic.product_fit import BIAS, factorize
from brdf_suite.geometry.factor_words import Factor, Projection


def _along(name: str, x: float, y: float, offset: float) -> Projection:
    def places(wi: Floats, _wo: Floats) -> Floats:
        return (offset + x * wi[:, 0] + y * wi[:, 1])[:, None]

    return Projection(name, 1, f"{name} of a picture", places)


PLANE_PROJECTIONS: Mapping[str, Projection] = MappingProxyType(
    {
        "x": _along("x", 1.0, 0.0, 0.0),
        "y": _along("y", 0.0, 1.0, 0.0),
        "x-y": _along("x-y", 0.5, -0.5, 0.5),
        "x+y": _along("x+y", 0.5, 0.5, 0.0),
    }
)
"""Places in [0, 1] of pixels, whose x and y are shares of width and height from the upper left."""


def factor_picture(
    picture: npt.ArrayLike, projections: Sequence[str], *, smooth: float = 0.01, bias: float = BIAS
) -> tuple[Floats, dict[str, Floats]]:
    """Return the approximation (h, w) of a picture (h, w), and its factors (n,) by projection, n the larger side.

    The factors are normalized: the mean of the logarithm is 0, and the first takes the scale.

    Raises
    ------
    ValueRangeError
        The picture is not (h, w), or a projection is not known.
    FittingError
        It is black, or nothing in it is finite.
    """
    values = np.asarray(picture, np.float64)
    if values.ndim != 2 or min(values.shape) < 2:
        raise ValueRangeError("picture", f"expected (h, w) of at least 2 by 2, not {values.shape}")
    if unknown := set(projections) - set(PLANE_PROJECTIONS):
        raise ValueRangeError("projections", f"{min(unknown)!r} is none of {', '.join(PLANE_PROJECTIONS)}")
    height, width = values.shape
    size = max(height, width)
    x, y = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)
    # Pixels stand where pairs of directions stand otherwise; a third coordinate over 0 is above the horizon.
    pixels = np.stack((x.ravel(), y.ravel(), np.ones(values.size)), axis=-1)
    up = np.broadcast_to(np.array([0.0, 0.0, 1.0]), pixels.shape)
    found = factorize(
        pixels,
        up,
        np.repeat(values.reshape(-1, 1), 3, axis=1),
        factors=tuple(
            Factor(f"f{number}", PLANE_PROJECTIONS[name]) for number, name in enumerate(projections)
        ),
        resolution=size,
        smooth=smooth,
        bias=bias,
        keep_mean=False,
    ).product
    shown = found.eval(pixels, up)[:, 0].reshape(height, width)
    factors = {name: np.exp(found.logs[f"f{number}"][:, 0]) for number, name in enumerate(projections)}
    factors[projections[0]] = factors[projections[0]] * found.alpha[0]
    return shown, factors
