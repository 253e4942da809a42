"""Anything that reflects as a product of textures: f_r = α p(ωo) q(h) p(ωi), by homomorphic factorization."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np

from brdf_suite.fitting.homomorphic.accuracy import Accuracy, accuracy
from brdf_suite.fitting.homomorphic.factorize import (
    BIAS,
    DEFAULT_RESOLUTION,
    DEFAULT_SMOOTHNESS,
    factorize,
)
from brdf_suite.fitting.homomorphic.samples import DEFAULT_PAIRS, DEFAULT_SEED, samples_of
from brdf_suite.geometry.directions import Floats
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, RADIAL_FACTORS
from brdf_suite.pipeline.measuring import load_measurable
from brdf_suite.pipeline.reflectance_figures import is_isotropic
from brdf_suite.progress import Progress, part, report
from brdf_suite.reflectance.factored import Factored


@dataclass(frozen=True, eq=False)
class FactoredFit:
    """A product of textures beside what it came from.

    ``radial``: whether the maps were fitted as functions of the radius alone. ``accuracy``: over the samples that were
    factored, of the textures as they are looked up, bilinear in the factors. ``compression``: samples over texels.
    ``left_out``, ``raised``: samples that took no part, and negative ones that were taken for 0.
    """

    name: str
    value: Factored
    accuracy: Accuracy
    compression: float
    samples: int
    left_out: int
    raised: int
    solver: str
    radial: bool

    def to_json(self) -> dict[str, object]:
        """Return the figures by their names."""
        return {
            "name": self.name,
            "resolution": len(self.value.p),
            "samples": self.samples,
            "left_out": self.left_out,
            "raised": self.raised,
            "solver": self.solver,
            "radial": self.radial,
            "compression": self.compression,
            "accuracy": self.accuracy.to_json(),
        }


def factor_any(
    name_or_path: str | os.PathLike[str],
    *,
    resolution: int = DEFAULT_RESOLUTION,
    smooth: float = DEFAULT_SMOOTHNESS,
    bias: float = BIAS,
    pairs: int = DEFAULT_PAIRS,
    seed: int = DEFAULT_SEED,
    progress: Progress | None = None,
) -> FactoredFit:
    """Factor a paint by name or file, or a measured file.

    The maps of an isotropic reflectance are radially symmetric; they are fitted as such, with one number a ring, and
    take the same textures. Measured samples and the measured bins of tables are taken as they are; of models and
    paints ``pairs`` directions even over both hemispheres are drawn from ``seed``.

    Raises
    ------
    SuiteError
        There is nothing of that name, it cannot be read, or there is nothing to factor; the message says why.
    """
    report(progress, 0.0, "reading")
    item = load_measurable(name_or_path)
    samples = samples_of(item.reflectance, pairs, seed)
    radial = is_isotropic(item.reflectance)
    found = factorize(
        samples.wi,
        samples.wo,
        samples.values,
        factors=RADIAL_FACTORS if radial else DEFAULT_FACTORS,
        resolution=resolution,
        smooth=smooth,
        bias=bias,
        # A coat's peak holds energy that no map of so few texels does; a mean that kept it would brighten all the rest.
        keep_mean=False,
        progress=part(progress, 0.1, 0.95),
    )
    logs = found.product.logs
    maps = {name: np.exp(_round(log) if radial else log) for name, log in logs.items()}
    # Each map over its largest value, and α with what that takes (equation 20).
    tops = {name: values.reshape(-1, 3).max(axis=0) for name, values in maps.items()}
    value = Factored(
        (maps["p"] / tops["p"]).astype(np.float32),
        (maps["q"] / tops["q"]).astype(np.float32),
        found.product.alpha * tops["p"] ** 2 * tops["q"],
        source=f"homomorphic factorization of {item.name}",
        facts={
            "format": "product of textures",
            "resolution": resolution,
            "smoothness": smooth,
            "bias": bias,
            "samples": found.used,
        },
    )
    keep = np.isfinite(samples.values).all(axis=1)
    near = accuracy(np.maximum(samples.values[keep], 0.0), value.eval(samples.wi[keep], samples.wo[keep]))
    ratio = found.used / (len(value.p) ** 2 + len(value.q) ** 2)
    counts = (found.used, found.left_out, found.raised)
    return FactoredFit(item.name, value, near, ratio, *counts, found.solver, radial)


def _round(log: Floats) -> Floats:
    """Return the map (n, n, 3) of which ``log`` (n, 3) holds the values from the middle to the horizon and beyond."""
    size = len(log)
    along = (2.0 * np.arange(size) + 1.0) / size - 1.0
    radius = np.minimum(np.hypot(along[:, None], along), 1.0)
    at = (np.arange(size) + 0.5) / size
    return np.stack([np.interp(radius, at, log[:, channel]) for channel in range(3)], axis=-1)
