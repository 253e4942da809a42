"""Pictures of a sphere in an environment, integrated from any reflectance itself, without lobes or a path tracer.

The radiance of each pixel, ∫ f_r L cosθi dω, is estimated from directions drawn by the environment's luminance and
by cosine lobes about the mirror direction, weighted by the balance heuristic (Veach and Guibas 1995). Every
reflectance gets the same directions, so that most of the sampling noise cancels where two pictures are compared.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, display_to_lab, srgb_encode
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.geometry.directions import mirror
from brdf_suite.geometry.warps import cosine_lobe, cosine_lobe_pdf
from brdf_suite.lighting import latlong
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.exposure import ev_of
from brdf_suite.realtime.pictures.tone_curves import display_light
from brdf_suite.reflectance.protocol import Reflectance

PIXELS = 48
"""Along the sphere's diameter."""
_RIM = 0.97
"""Of the radius: beyond, a pixel sees a view so low that it covers many angles."""
_FROM_LIGHT = 256
_EXPONENTS, _FROM_LOBE = (2.0, 12.0, 80.0, 600.0, 6e3, 6e4), 32
# Texels darker than this share of the mean are drawn as often as if they had it: a lobe may look there alone.
_LEAST_LIGHT = 0.05


@dataclass(frozen=True, eq=False)
class SphereLight:
    """Light on the p pixels of a sphere that the camera sees from far away along its axis.

    ``wi`` (p, s, 3) and ``wo`` (p, 1, 3): unit directions in each pixel's frame, z along the normal, x along the
    parallel; some lie below the horizon. ``share`` (p, s, 3): L cosθi over number and density of the directions.
    """

    wi: Floats
    wo: Floats
    share: Floats

    def radiance(self, reflectance: Reflectance) -> Floats:
        """Return what a sphere of this reflectance sends to the camera (p, 3), working space."""
        return np.asarray((reflectance.eval(self.wi, self.wo) * self.share).sum(axis=1))


def sphere_light(environment: Environment, pixels: int = PIXELS, seed: int = 0) -> SphereLight:
    """Return the light of an environment on a sphere ``pixels`` wide; the camera stands at +z of the world."""
    rng = np.random.default_rng(seed)
    edge = (np.arange(pixels) + 0.5) / pixels * 2.0 - 1.0
    x, y = (flat.ravel() for flat in np.meshgrid(edge, -edge))
    inside = x * x + y * y < _RIM * _RIM
    x, y = x[inside], y[inside]
    normal = np.stack((x, y, np.sqrt(1.0 - x * x - y * y)), axis=-1)
    along = np.cross((0.0, 1.0, 0.0), normal)
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    frames = np.stack((along, np.cross(normal, along), normal), axis=1)
    wo = frames[:, None, :, 2]
    light = _LightDensity(environment.radiance)
    drawn = np.broadcast_to(light.draw(_FROM_LIGHT, rng), (len(x), _FROM_LIGHT, 3))
    local = [np.einsum("pij,psj->psi", frames, drawn)]
    for exponent in _EXPONENTS:
        u = rng.random((len(x), _FROM_LOBE, 2))
        u[..., 0] = (np.arange(_FROM_LOBE) + u[..., 0]) / _FROM_LOBE
        local.append(cosine_lobe(u, mirror(wo), exponent))
    wi = np.concatenate(local, axis=1)
    world = np.einsum("pij,psi->psj", frames, wi)
    density = _FROM_LIGHT * light.density(world)
    for exponent in _EXPONENTS:
        density += _FROM_LOBE * cosine_lobe_pdf(wi, mirror(wo), exponent)
    lit = latlong.sample(environment.radiance, world) * np.maximum(wi[..., 2:], 0.0)
    return SphereLight(wi, wo, lit / density[..., None])


class _LightDensity:
    """Density of directions that follows the luminance of a latitude-longitude map (h, w, 3), never 0."""

    def __init__(self, radiance: npt.NDArray[np.floating[Any]]) -> None:
        height, width = radiance.shape[:2]
        luminance = radiance.astype(np.float64) @ LUMINANCE
        area = np.sin(latlong.ring_angles(height))[:, None] * np.ones(width)
        mean = float((luminance * area).sum() / area.sum())
        weights = np.maximum(luminance, max(_LEAST_LIGHT * mean, 1e-30)) * area
        self._shares = weights / weights.sum()

    def draw(self, count: int, rng: np.random.Generator) -> Floats:
        """Return unit directions (count, 3), spread over the map by their share of it."""
        height, width = self._shares.shape
        wanted = (np.arange(count) + rng.random(count)) / count
        at = np.minimum(np.searchsorted(np.cumsum(self._shares.ravel()), wanted), height * width - 1)
        row, column = np.divmod(at, width)
        theta = (row + rng.random(count)) * (np.pi / height)
        return latlong.direction(theta, (column + rng.random(count)) * (2.0 * np.pi / width) - np.pi)

    def density(self, directions: Floats) -> Floats:
        """Return the density (...) per steradian of :meth:`draw` at directions (..., 3)."""
        height, width = self._shares.shape
        theta, phi = latlong.angles(directions)
        row = np.clip(theta * (height / np.pi), 0, height - 1).astype(np.intp)
        column = ((phi + np.pi) * (width / (2.0 * np.pi))).astype(np.intp) % width
        texel = (np.pi / height) * (2.0 * np.pi / width) * np.maximum(np.sin(theta), 1e-9)
        return np.asarray(self._shares[row, column] / texel)


def picture_differences(test: Floats, reference: Floats) -> Floats:
    """Return ΔE00 (p,) between two pictures' radiances (p, 3), seen through one exposure and the default tone curve.

    The exposure brings the median luminance of ``reference`` to 0.18.
    """
    ev = ev_of(np.concatenate((reference, np.ones((len(reference), 1))), axis=-1)) or 0.0
    labs = (display_to_lab(srgb_encode(display_light(p, ev, View().tone_curve))) for p in (test, reference))
    return delta_e_2000(*labs)
