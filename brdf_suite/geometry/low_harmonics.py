"""Real spherical harmonics of low degree about the y axis: soft light and its shadows in a few numbers.

Number l² + l + m belongs to degree l and order m, -l ≤ m ≤ l; negative orders go with sin(|m|φ), the others with
cos(mφ), φ = atan2(x, z). They are orthonormal over the sphere. A turn about y mixes each ±m pair alone.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.arrays import Floats


def low_harmonics(directions: Floats, degree: int) -> Floats:
    """Return Y_lm at unit directions (..., 3), world axes, as (..., (degree + 1)²).

    >>> float(low_harmonics(np.array([0.0, 1.0, 0.0]), 0)[0])  # 1 / sqrt(4 π)
    0.28209479177387814
    """
    x, y, z = np.moveaxis(np.asarray(directions, np.float64), -1, 0)
    result = np.empty((*x.shape, (degree + 1) ** 2))
    # sinᵐθ e^{imφ} is a polynomial, (z + ix)ᵐ, so no angle and no division at the pole is needed.
    power = np.ones_like(x, np.complex128)
    diagonal = 1.0
    for m in range(degree + 1):
        if m:
            power = power * (z + 1j * x)
            diagonal *= 2 * m - 1
        # Associated Legendre functions without the sine and the sign, upwards in l.
        older, old = np.zeros_like(y), np.full_like(y, diagonal)
        for degree_l in range(m, degree + 1):
            if degree_l > m:
                upper = ((2 * degree_l - 1) * y * old - (degree_l + m - 1) * older) / (degree_l - m)
                older, old = old, upper
            scale = math.sqrt(
                (2 * degree_l + 1)
                / (4 * math.pi)
                * math.factorial(degree_l - m)
                / math.factorial(degree_l + m)
            )
            middle = degree_l * degree_l + degree_l
            if m == 0:
                result[..., middle] = scale * old
            else:
                both = math.sqrt(2.0) * scale * old
                result[..., middle + m] = both * power.real
                result[..., middle - m] = both * power.imag
    return result


def rotate_harmonics(coefficients: Floats, angle: Floats | float) -> Floats:
    """Return the coefficients (..., (degree + 1)²) of a function turned about y by ``angle`` (...), radians.

    Positive is counter-clockwise seen from above: what was at φ comes to φ + angle.
    """
    degree = math.isqrt(coefficients.shape[-1]) - 1
    result = np.array(coefficients, np.float64)
    for m in range(1, degree + 1):
        cosine, sine = np.cos(m * np.asarray(angle)), np.sin(m * np.asarray(angle))
        for degree_l in range(m, degree + 1):
            middle = degree_l * degree_l + degree_l
            even, odd = coefficients[..., middle + m], coefficients[..., middle - m]
            result[..., middle + m] = cosine * even - sine * odd
            result[..., middle - m] = cosine * odd + sine * even
    return result
