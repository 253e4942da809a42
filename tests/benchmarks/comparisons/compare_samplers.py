"""How alike the weights of sampled light are: f cosθ / pdf, for measured files and tables.

    python tests/benchmarks/comparisons/compare_samplers.py FILES

Prints for each the time to build the density and the relative standard deviation of the weights'
luminance over 3,000 samples at several views: by ``sample``, by a file's stored density where it has one, and by the
cosine alone. Beside them ∫ pdf, and the z of the mean of 100,000 samples against a fine quadrature.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.files.measured import read_measured
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import SampledReflectance
from brdf_suite.reflectance.registry import MODELS
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

COUNT = 3000
MANY = 100_000
VIEWS_DEG = (0.0, 30.0, 70.0, 85.0)
Draw = Callable[[np.ndarray, np.ndarray], np.ndarray]


def known(paths: list[str]) -> Iterator[tuple[str, SampledReflectance]]:
    """Yield the files, tables of two paints in MERL's bins, and one of brushed metal over four angles."""
    for path in paths:
        yield Path(path).name, read_measured(path)
    for name in ("table1_polaris_silver", "table1_white"):
        yield f"{name}, MERL bins", IsotropicTable.from_reflectance(CookTorrance(TABLE_1[name]))
    polar = np.radians(np.arange(0.0, 90.0, 7.5))
    brushed = AnisotropicTable.from_reflectance(MODELS["poulin_fournier"].default, polar, 48)
    yield "poulin_fournier, 12 x 48 x 12 x 48", brushed


def weights(one: SampledReflectance, sample: Draw, pdf: Draw, wo: np.ndarray, count: int) -> np.ndarray:
    """Return the luminance (count,) of f cosθ / pdf of samples; those below the horizon are 0."""
    wi = sample(wo, np.random.default_rng(1).random((count, 3)))
    density = pdf(wi, wo)
    light = one.eval(wi, wo) @ LUMINANCE * np.maximum(wi[:, 2], 0.0)
    return np.divide(light, density, out=np.zeros(count), where=density > 0.0)


def quadrature(one: SampledReflectance, wo: np.ndarray) -> tuple[float, float]:
    """Return ∫ f cosθ dω (luminance) and ∫ pdf dω by midpoints over the half vector, fine towards the normal."""
    # A retroreflecting peak is 2° wide: it needs this many azimuths.
    count, turns = 2000, 1440
    place = (np.arange(count) + 0.5) / count
    theta, step = 0.5 * np.pi * place**3, 1.5 * np.pi * place**2 / count
    phi = 2.0 * np.pi * (np.arange(turns) + 0.5) / turns
    light = whole = 0.0
    for rows in np.split(np.arange(count), 20):
        half = spherical(theta[rows, None], phi)
        wi, dot = warps.mirror_at(wo, half), np.maximum(half @ wo, 0.0)
        area = 4.0 * dot * (np.sin(theta) * step)[rows, None] * (2.0 * np.pi / turns)
        light += float((area * np.maximum(wi[..., 2], 0.0) * (one.eval(wi, wo) @ LUMINANCE)).sum())
        whole += float((area * one.pdf(wi, wo)).sum())
    return light, whole


def main(paths: list[str]) -> None:
    """Print the table."""
    for name, one in known(paths):
        start = time.perf_counter()
        one.pdf(spherical(0.1, 0.0), spherical(0.2, 0.0))
        print(f"{name}: built in {time.perf_counter() - start:.2f} s")
        for angle in VIEWS_DEG:
            wo = spherical(np.radians(angle), 2.5)
            ways: dict[str, tuple[Draw, Draw]] = {"own": (one.sample, one.pdf)}
            if isinstance(one, TensorReflectance):
                ways["stored"] = one.sample_stored, one.pdf_stored
            ways["cosine"] = (
                lambda _wo, u: warps.cosine_hemisphere(u),
                lambda wi, _wo: warps.cosine_hemisphere_pdf(wi),
            )
            spread = []
            for way, (sample, pdf) in ways.items():
                found = weights(one, sample, pdf, wo, COUNT)
                spread.append(f"{way} {found.std() / found.mean():.3f}")
            light, whole = quadrature(one, wo)
            many = weights(one, one.sample, one.pdf, wo, MANY)
            z = (many.mean() - light) / (many.std() / np.sqrt(MANY))
            worst = many.max() / many.mean()
            print(f"  {angle:3.0f}°  {'  '.join(spread)}  largest {worst:.1f}  ∫pdf {whole:.5f}  z {z:+.1f}")


if __name__ == "__main__":
    main(sys.argv[1:])
