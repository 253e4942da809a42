"""Reflectances known by their values: half-angle tables, and files of RGL by Mitsuba's own plug-in ``measured``."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import nnls

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.files.measured.rgl import write_rgl
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.reference.bsdfs.directions import TINY, Colour, Real, Vector
from brdf_suite.reference.bsdfs.terms import Diffuse, Facets, Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

SLOPES = (0.004, 0.012, 0.035, 0.1, 0.25, 0.6)
LEAST_MATT = 0.08
_VIEWS_DEG = (15.0, 45.0, 70.0)
_PER_PART = 400


def fitted_samplers(reflectance: Reflectance, seed: int = 1) -> tuple[Sampler, ...]:
    """Return samplers whose mixture follows f_r cosθ of ``reflectance`` for views of some polar angles.

    The shares are non-negative least squares of the luminance over directions drawn from all parts, each weighed by one
    over the density, so that bright and dim parts of the light count alike. Some matt is always in it.
    """
    rng = np.random.default_rng(seed)
    rows, wanted = [], []
    for theta_deg in _VIEWS_DEG:
        view = spherical(math.radians(theta_deg), 0.0)[None]
        drawn = [warps.cosine_hemisphere(rng.random((_PER_PART, 2)))]
        drawn += [warps.mirror_at(view, warps.beckmann_normal(rng.random((_PER_PART, 2)), m)) for m in SLOPES]
        light = np.concatenate(drawn)
        light = light[light[:, 2] > 1e-3]
        views = np.broadcast_to(view, light.shape)
        half = warps.half_vector(light, views)
        parts = [warps.cosine_hemisphere_pdf(light)]
        parts += [warps.mirrored_pdf(warps.beckmann_normal_pdf(half, m), views, half) for m in SLOPES]
        densities = np.stack(parts, axis=1)
        value = reflectance.eval(light, views) @ LUMINANCE * light[:, 2]
        weight = 1.0 / np.sqrt(densities.mean(axis=1) * (densities.mean(axis=1) + value.mean()))
        rows.append(densities * weight[:, None])
        wanted.append(value * weight)
    shares, _ = nnls(np.concatenate(rows), np.concatenate(wanted))
    total = float(shares.sum()) or 1.0
    facets = [
        Facets(float(share) / total, slope)
        for share, slope in zip(shares[1:], SLOPES, strict=True)
        if share > 1e-3 * total
    ]
    return (Diffuse(max(float(shares[0]) / total, LEAST_MATT)), *facets)


@dataclass(frozen=True, eq=False)
class HalfAngleTable:
    """Trilinear between the centres of bins (θh, θd, φd), as ``trilinear`` of the measured tables."""

    table: IsotropicTable
    values: Any
    samplers: Sequence[Sampler]

    @classmethod
    def of(cls, table: IsotropicTable, samplers: Sequence[Sampler]) -> HalfAngleTable:
        """Return the counterpart; ``samplers`` are those that suit its values."""
        values = mi.Float(np.ascontiguousarray(table.values, np.float32).ravel())
        dr.eval(values)
        return cls(table, values, samplers)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        grid = self.table.grid
        total, apart = light + view, light - view
        flat = total.x * total.x + total.y * total.y
        length = dr.sqrt(flat + total.z * total.z)
        h = dr.sqrt(dr.atan2(dr.sqrt(flat), total.z) / (0.5 * math.pi)) * grid.theta_h
        along_d = dr.atan2(dr.norm(apart), length) * (grid.theta_d / (0.5 * math.pi))
        turn = total.x * apart.y - total.y * apart.x
        ahead = -apart.z * length
        if grid.reciprocal:
            ahead = dr.select(turn < 0.0, -ahead, ahead)
            turn = dr.abs(turn)
        phi = dr.atan2(turn, dr.select(dr.abs(ahead) + dr.abs(turn) < TINY, 1.0, ahead))
        phi = dr.select(phi < 0.0, phi + 2.0 * math.pi, phi)
        p = phi * (grid.phi_d / grid.period) - 0.5
        p = dr.select(p < 0.0, p + grid.phi_d, p)
        i, u = _within(h, grid.theta_h)
        j, v = _within(along_d, grid.theta_d)
        k = dr.minimum(mi.UInt32(p), grid.phi_d - 1)
        w = p - mi.Float(k)
        after = dr.select(k + 1 >= grid.phi_d, mi.UInt32(0), k + 1)
        colour = mi.Color3f(0.0)
        for di, su in ((0, 1.0 - u), (1, u)):
            for dj, sv in ((0, 1.0 - v), (1, v)):
                row = ((i + di) * grid.theta_d + (j + dj)) * grid.phi_d
                first = dr.gather(mi.Color3f, self.values, row + k)
                second = dr.gather(mi.Color3f, self.values, row + after)
                colour += su * sv * dr.fma(w, second - first, first)
        return dr.maximum(colour, 0.0)


def _within(place: Real, bins: int) -> tuple[Any, Real]:
    between = dr.clip(place - 0.5, 0.0, bins - 1.0)
    low = dr.minimum(mi.UInt32(between), bins - 2)
    return low, between - mi.Float(low)


@dataclass(frozen=True, eq=False)
class MeasuredTerm:
    """Term of a :class:`~brdf_suite.reflectance.tensor.tensor_reflectance.TensorReflectance`.

    The file's incident direction is the light's to us and the view's to Mitsuba, and measured values are not quite the
    same the other way round. So the plug-in is asked with the two exchanged. Spectra become colours before: both are
    linear.
    """

    plug_in: Any
    samplers: Sequence[Sampler]

    @classmethod
    def of(cls, material: TensorReflectance) -> MeasuredTerm:
        """Return the counterpart of a material."""
        # Outside of the working space a channel is negative, and what that leaves of a sum is cut off at the end.
        colours = np.einsum("picab,cj->pijab", material.values, material.to_working)
        table = replace(material, values=np.ascontiguousarray(colours, np.float32), wavelengths_nm=None)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "material.bsdf"
            write_rgl(table, path)
            plug_in = mi.load_dict({"type": "measured", "filename": str(path)})
        return cls(plug_in, fitted_samplers(material))

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        si: Any = dr.zeros(mi.SurfaceInteraction3f)
        si.wi = light
        return dr.maximum(self.plug_in.eval(mi.BSDFContext(), si, view) / view.z, 0.0)
