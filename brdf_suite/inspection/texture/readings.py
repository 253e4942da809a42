"""Texture of a fitted paint, as the virtual instrument reads it; a paint without flakes has none."""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.appearance.texture import LIGHTS_DEG, NO_TEXTURE, PaintLight, TextureReadings
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import illumination
from brdf_suite.inspection.texture.camera import measure_texture
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.models.cosine_lobes import lobe_sums

_COLUMNS = 181


def paint_light(weights: LobeWeights) -> PaintLight:
    """Return what the texture instrument sees of a paint beside its flakes, from its lobes."""
    gamma = np.linspace(0.0, 0.5 * math.pi, _COLUMNS)
    base = np.cos(gamma)[:, None] ** weights.exponents @ weights.kdd + weights.kd
    lights = np.array([illumination(light) for light in LIGHTS_DEG])
    eye = np.broadcast_to([0.0, 0.0, 1.0], lights.shape)
    sums = lobe_sums(lights, eye, weights.exponents, weights.kd, weights.kdd, weights.kg)
    return PaintLight(weights.ior, weights.theta_fit_rad, gamma, base, sums.brdf())


def texture_of(material: Material) -> TextureReadings:
    """Return what the instrument reads of a material; zeros where it has no flakes.

    Raises
    ------
    FittingError
        No lobes can be fitted to it.
    """
    flakes = material.flakes
    if flakes is None or flakes.density_per_mm2 <= 0.0:
        return NO_TEXTURE
    return measure_texture(paint_light(fit_material(material).weights), flakes)
