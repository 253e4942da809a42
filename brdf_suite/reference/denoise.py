"""Denoising of a traced picture by OptiX; requires an NVIDIA graphics card."""

from __future__ import annotations

from typing import Any

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.reference.mitsuba_modules import mi


def check_denoiser() -> None:
    """Raise :class:`ReferenceUnavailableError` where the variant that was started has no denoiser."""
    if not str(mi.variant()).startswith("cuda"):
        raise ReferenceUnavailableError(
            "The denoiser is OptiX's and needs an NVIDIA graphics card; here paths are traced without one. "
            "Leave --denoise out, and give more samples instead (--spp)."
        )


def denoise_picture(radiance: Floats) -> Floats:
    """Return radiance (h, w, 3) without its noise.

    Raises
    ------
    ReferenceUnavailableError
        There is no NVIDIA graphics card, or its driver has no denoiser.
    """
    check_denoiser()

    rows, columns = radiance.shape[:2]
    try:
        size = mi.ScalarVector2u(columns, rows)
        denoise: Any = mi.OptixDenoiser(input_size=size, albedo=False, normals=False, temporal=False)
        found = denoise(mi.TensorXf(np.ascontiguousarray(radiance, np.float32)))
        return np.maximum(np.array(found, np.float64), 0.0)
    except RuntimeError as error:
        raise ReferenceUnavailableError(
            f"The graphics card's driver has no denoiser that can be used ({error}); leave --denoise out."
        ) from error
