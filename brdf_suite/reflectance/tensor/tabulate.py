"""Conversion of any isotropic reflectance to a TensorReflectance, for RGL's ``.bsdf``.

The stored values are V = f_r cos θo · 4σ/D, so D and σ are ours to choose: whatever they are, reading divides
them out again, and what is left to error is the interpolation of V. So they are chosen to make V flat:

- D(θm) is the reflectance itself along the half angle (a mean over three difference angles), on thousands of
  nodes in √θ: it takes the highlight out of V.
- σ(θi) = cos θi takes the 1/cos θi of a microfacet lobe out.
- the warp of the square depends on θm alone. Its density follows √|V''/V|, which spreads the error of linear
  interpolation evenly over the nodes.

Half vectors for which the view falls below the horizon lie next to ones that count; there V is continued along
the view's elevation, so that the cells at the horizon interpolate between like and like. The luminance table is
the density of f_r cos θo itself, so a renderer samples the reflectance as it is.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, REC709_TO_WORKING
from brdf_suite.appearance.colour.spectra import spectrum_to_working
from brdf_suite.arrays import Floats, Singles
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import from_half_angle_coordinates, spherical
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tensor.density import GridDensity, blend_weights
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

# Nodes of D and σ along √θ: a coat of roughness 0.002 falls by half within 20 of them.
_FINE = 8192
_WARP = 1024

# The last incidence (rad below 90°): at the horizon itself there is no reflectance to ask for.
_LAST_BELOW_HORIZON = 2e-3

# Where the continuation below the horizon takes its slope: the view's z.
_NEAR, _NEARER = 0.04, 0.02

# The even part of the warp's density; the rest goes where V bends.
_EVEN_SHARE = 0.3

_DARKEST = 1e-9

_LARGEST_SHIFT = 0.02


# Any: a reflectance with spectra has eval_spectra and wavelengths_nm beyond the protocol.
def tabulate(
    reflectance: Any, *, incidences: int | None = None, resolution: int | None = None, description: str = ""
) -> TensorReflectance:
    """Return the tensor form of an isotropic reflectance.

    Parameters
    ----------
    reflectance
        A Reflectance; where it has ``eval_spectra`` and ``wavelengths_nm`` its spectra are kept.
    incidences
        Number of polar angles of the light, denser towards the horizon; 72 for RGB, 48 for spectra where None.
    resolution
        Nodes along each side of the square; 192 for RGB (a file of 42 MB), 64 for spectra where None.
    description
        The material's name; the reflectance's own where empty.

    Raises
    ------
    ValueRangeError
        The reflectance is not isotropic, or gives values that are not finite.
    """
    bands = getattr(reflectance, "wavelengths_nm", None)
    evaluate: Callable[[Floats, Floats], Floats]
    if bands is None:
        to_file = np.linalg.inv(REC709_TO_WORKING).T

        def evaluate(wi: Floats, wo: Floats) -> Floats:
            return np.asarray(reflectance.eval(wi, wo) @ to_file)

        brightness = REC709_TO_WORKING.T @ LUMINANCE
    else:
        bands = np.asarray(bands, np.float64)
        evaluate = reflectance.eval_spectra
        brightness = spectrum_to_working(np.eye(len(bands)), bands) @ LUMINANCE
    resolution = resolution or (192 if bands is None else 64)
    incidences = incidences or (72 if bands is None else 48)
    _check_isotropic(reflectance)

    step = np.linspace(0.0, 1.0, incidences)
    theta_i = (0.5 * math.pi - _LAST_BELOW_HORIZON) * np.sin(0.5 * math.pi * step)
    theta_i = theta_i.astype(np.float32).astype(np.float64)
    ndf = _distribution(reflectance)
    sigma = np.maximum(np.cos(_theta(np.linspace(0.0, 1.0, _FINE))), math.cos(theta_i[-1]))
    ndf, sigma = ndf.astype(np.float32).astype(np.float64), sigma.astype(np.float32).astype(np.float64)
    sheet = _Sheet(evaluate, ndf, sigma)
    warp = _warp(sheet, brightness)

    density = GridDensity(warp[None])
    along, around = np.meshgrid(np.linspace(0.0, 1.0, resolution), np.linspace(0.0, 1.0, resolution))
    nodes = np.stack((along.ravel(), around.ravel()), axis=1)
    u, p = density.sample(nodes, blend_weights([np.zeros(1)], [np.zeros(len(nodes))]))
    u[:, 1] = nodes[:, 1]  # the warp is even around; sampling keeps off 0 and 1 by a hair

    channels = len(brightness)
    values = np.empty((1, incidences, channels, resolution, resolution), np.float32)
    luminance = np.empty((1, incidences, resolution, resolution), np.float32)
    for index, theta in enumerate(theta_i.tolist()):
        value, weight = sheet.values(theta, u)
        values[0, index] = value.T.reshape(channels, resolution, resolution)
        light = np.maximum(value @ brightness, 0.0) * weight / p
        floor = 1e-4 * float(light.mean()) or 1.0
        luminance[0, index] = np.maximum(light, floor).reshape(resolution, resolution)
    if not np.isfinite(values).all():
        raise ValueRangeError("reflectance", "gives values that are not finite")
    for axis in (1, 3, 4):
        _centre(values, axis)
    facts = getattr(reflectance, "facts", {})
    return TensorReflectance(
        phi_i=np.zeros(1, np.float32),
        theta_i=theta_i.astype(np.float32),
        ndf=np.repeat(ndf[None].astype(np.float32), 2, axis=0),
        sigma=np.repeat(sigma[None].astype(np.float32), 2, axis=0),
        vndf=np.broadcast_to(warp.astype(np.float32), (1, incidences, *warp.shape)).copy(),
        luminance=luminance,
        values=values,
        wavelengths_nm=None if bands is None else bands.astype(np.float32),
        description=description or str(facts.get("name", "")),
        observer_deg=int(facts.get("observer_deg", 10)),
        source=str(getattr(reflectance, "source", "")),
    )


class _Sheet:
    """V of a reflectance over the half vectors of one incidence."""

    def __init__(self, evaluate: Callable[[Floats, Floats], Floats], ndf: Floats, sigma: Floats) -> None:
        self._evaluate, self._ndf, self._sigma = evaluate, ndf, sigma

    def values(self, theta_i: float, u: Floats) -> tuple[Floats, Floats]:
        """Return V (n, c) at half vectors ``u`` (n, 2), and what turns its luminance into a density on u (n,)."""
        wi = spherical(theta_i, 0.0)
        half = spherical(_theta(u[:, 0]), (2.0 * u[:, 1] - 1.0) * math.pi)
        facing = half @ wi
        wo = 2.0 * facing[:, None] * half - wi
        # Half vectors that face away from the light give views below the horizon too.
        z = np.where(facing > 0.0, wo[:, 2], -np.abs(wo[:, 2]))
        # Continued from two elevations, straight: f_r cos θo is near a line in cos θo there.
        lifted = np.maximum(z, _NEAR)
        first = self._at(wi, theta_i, wo, lifted)
        below = np.flatnonzero(z < _NEAR)
        if below.size:
            second = self._at(wi, theta_i, wo[below], np.full(below.size, _NEARER))
            near = first[below]
            slope = (near - second) / (_NEAR - _NEARER)
            reach = np.maximum(z[below] - _NEAR, -3.0 * _NEAR)[:, None]
            first[below] = near + slope * reach
            above = below[z[below] > 0.0]
            if above.size:
                first[above] = self._at(wi, theta_i, wo[above], z[above])
        sine = np.sin(_theta(u[:, 0]))
        stretch = np.maximum(facing, 0.0) * (2.0 * math.pi**2) * u[:, 0] * sine
        weight = stretch * _along(self._ndf, u[:, 0]) * (z > -_NEAR)
        return first, np.asarray(weight)

    def _at(self, wi: Floats, theta_i: float, wo: Floats, z: Floats) -> Floats:
        """Return V (n, c) at the views of the azimuths of ``wo`` that have the given ``z``."""
        flat = np.hypot(wo[:, 0], wo[:, 1])
        scale = np.sqrt(1.0 - z * z) / np.maximum(flat, 1e-300)
        view = np.stack((wo[:, 0] * scale, wo[:, 1] * scale, z), axis=1)
        view[flat == 0.0] = (0.0, 0.0, 1.0)
        total = view + wi
        theta_m = np.arctan2(np.hypot(total[:, 0], total[:, 1]), total[:, 2])
        normals = _along(self._ndf, np.sqrt(theta_m * (2.0 / math.pi)))
        area = float(_along(self._sigma, np.array([math.sqrt(theta_i * (2.0 / math.pi))]))[0])
        return self._evaluate(wi, view) * (view[:, 2] * 4.0 * area / normals)[:, None]


def _centre(values: Singles, axis: int) -> None:
    """Shift the inner nodes along ``axis`` so that the error of linear interpolation is 0 in the mean.

    Between nodes a step h apart a line misses f by f'' x (h - x)/2, in the mean f'' h²/12, always to the same
    side. Lowering the nodes by that much leaves less than half of the root-mean-square error.
    """
    moved = np.moveaxis(values, axis, 0)
    bend = moved[2:] - 2.0 * moved[1:-1] + moved[:-2]
    bend /= 12.0
    # At a kink the second difference is no derivative; there the nodes stay nearly where they are.
    limit = np.abs(moved[1:-1]) * _LARGEST_SHIFT
    moved[1:-1] -= np.clip(bend, -limit, limit)


def _distribution(reflectance: Reflectance) -> Floats:
    """Return D (n,) on even nodes in √θ: the geometric mean of the luminance at three difference angles."""
    theta = np.minimum(_theta(np.linspace(0.0, 1.0, _FINE)), 0.5 * math.pi - 1e-3)
    logs = []
    for theta_d in (0.0, 0.5, 1.0):
        wi, wo = from_half_angle_coordinates(theta, 0.0, theta_d, 0.5 * math.pi)
        bright = np.maximum(reflectance.eval(wi, wo) @ LUMINANCE, 0.0)
        logs.append(np.log(np.maximum(bright, _DARKEST * max(float(bright.max()), 1e-30))))
    found = np.exp(np.mean(logs, axis=0))
    if not np.isfinite(found).all():
        raise ValueRangeError("reflectance", "gives values that are not finite")
    return np.asarray(found)


def _warp(sheet: _Sheet, brightness: Floats) -> Floats:
    """Return the density (2, n) of nodes along √θm, the same at both ends of the square."""
    u = np.linspace(0.0, 1.0, _WARP)
    wanted, seen = np.zeros(_WARP), np.full(_WARP, 1e-9)
    for theta_i in (0.1, 0.5, 0.9, 1.2, 1.4):
        for around in (0.0, 0.25, 0.5):
            place = np.stack((u, np.full(_WARP, around)), axis=1)
            value, weight = sheet.values(theta_i, place)
            light = np.abs(value @ brightness)
            # Only where the view stands well above the horizon: the continuation below it has a kink.
            real = (weight > 0.0) & (light > 1e-2 * light.max())
            inner = real[2:] & real[1:-1] & real[:-2]
            second = np.abs(light[2:] - 2.0 * light[1:-1] + light[:-2])[inner] / light[1:-1][inner]
            wanted[1:-1][inner] += np.sqrt(second) * (_WARP - 1)
            seen[1:-1][inner] += 1.0
    wanted /= seen
    wanted = np.minimum(wanted, 30.0 * float(np.median(wanted)) + 1e-300)
    # A running mean: the nodes must not crowd at one kink of a table.
    wanted = np.convolve(np.pad(wanted, 8, mode="edge"), np.full(17, 1.0 / 17.0), mode="valid")
    total = float(wanted.mean())
    density = _EVEN_SHARE + (1.0 - _EVEN_SHARE) * wanted / total if total > 0.0 else np.ones(_WARP)
    return np.repeat(density[None], 2, axis=0).astype(np.float32).astype(np.float64)


def _theta(u: Floats) -> Floats:
    return u * u * (0.5 * math.pi)


def _along(nodes: Floats, u: Floats) -> Floats:
    """Return the linear interpolation of ``nodes`` at ``u`` 0…1, as readers do it."""
    return np.interp(u, np.linspace(0.0, 1.0, len(nodes)), nodes)


def _check_isotropic(reflectance: Reflectance) -> None:
    rng = np.random.default_rng(0)
    theta, phi = rng.uniform(0.05, 1.4, (2, 64)), rng.uniform(0.0, 2.0 * math.pi, (2, 64))
    here = reflectance.eval(spherical(theta[0], phi[0]), spherical(theta[1], phi[1]))
    there = reflectance.eval(spherical(theta[0], phi[0] + 1.0), spherical(theta[1], phi[1] + 1.0))
    if not (np.isfinite(here).all() and np.isfinite(there).all()):
        raise ValueRangeError("reflectance", "gives values that are not finite")
    if np.abs(here - there).max() > 1e-3 * np.abs(here).max() + 1e-12:
        reason = "changes when the sample is turned; only isotropic reflectances are written in this format"
        raise ValueRangeError("reflectance", reason)
