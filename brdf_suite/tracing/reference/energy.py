"""Energy check before tracing: paints that reflect more than they receive, or that give invalid numbers."""

from __future__ import annotations

import numpy as np

from brdf_suite.errors import UnreachableError
from brdf_suite.geometry.directions import illumination, spherical
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.protocol import Reflectance

ANGLES_DEG = (0.0, 30.0, 60.0, 75.0)
ALLOWED = 1.01
"""Of the light that arrives; the quadrature is sure of half a per cent."""
_AZIMUTHS = 16
_LOOKS = 256


def energy_notices(reflectance: Reflectance, name: str) -> tuple[str, ...]:
    """Return a sentence where a paint sends back more light than it gets; some milliseconds.

    Raises
    ------
    UnreachableError
        It gives numbers that are negative or not finite, in which no path can be traced.
    """
    rng = np.random.default_rng(3)
    wi, wo = (spherical(np.arccos(rng.random(_LOOKS)), rng.uniform(0.0, 6.28, _LOOKS)) for _ in "io")
    values = reflectance.eval(wi, wo)
    if not np.isfinite(values).all() or (values < 0.0).any():
        raise UnreachableError(
            f"{name} reflects amounts that are negative or not finite, so no light can be traced in it; "
            "brdf-suite check says where."
        )
    albedo = directional_albedo(reflectance, illumination(np.array(ANGLES_DEG)), _AZIMUTHS)
    row, channel = np.unravel_index(int(np.argmax(albedo)), albedo.shape)
    largest = float(albedo[row, channel])
    if not np.isfinite(largest):
        raise UnreachableError(f"{name} reflects an endless amount of light at {ANGLES_DEG[row]:g}°.")
    if largest <= ALLOWED:
        return ()
    return (
        f"{name} sends back {100.0 * largest:.0f} % of the {('red', 'green', 'blue')[channel]} light that arrives at "
        f"{ANGLES_DEG[row]:g}°, more than there is. It is traced as it stands; where the surface sees itself, light "
        "grows with each reflection.",
    )
