"""How long prefiltering takes, how exact it is, and what the cache saves; a map of 1024×512 with a strong sun."""

from __future__ import annotations

import tempfile
from statistics import median
from time import perf_counter

import numpy as np

from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.lighting.cache import MapCache
from brdf_suite.lighting.cubemap import texel_directions
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.face_array import FaceArray
from brdf_suite.lighting.latlong import column_angles, direction, fejer_weights, ring_angles
from brdf_suite.lighting.lobe_filter import LobeFilter
from brdf_suite.lighting.prefilter import Ready, background_size, face_size, prefilter
from brdf_suite.lighting.zonal import BROAD_BANDLIMIT, lobe_bandlimit
from brdf_suite.progress import Progress, part, report

NAME = "prefilter"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "first_light_s": ("<=", 1.0, "s", "diffuse map and broad lobes ready, 1024×512, median of 3"),
    "default_1k_s": ("<=", 3.0, "s", "whole default lobe set, pixels to packed maps, 1024×512, median of 3"),
    "error_max": ("<=", 1e-6, "", "against a float64 double sum, 2,000 directions, of the map's maximum"),
    "error_rms": ("", None, "", "the same, root mean square; n = 5, 80, 640 and 5,120"),
    "cache_hit_ms": ("<=", 150.0, "ms", "maps from the cache, checksum included, median of 5"),
}

ERROR_EXPONENTS = (5.0, 80.0, 640.0, 5120.0)
DIRECTIONS = 500  # for each exponent: 2,000 in all


def bench_map() -> np.ndarray:
    """Return radiance (512, 1024, 3): noise, lamps and a sun of 10⁵ times the sky."""
    rng = np.random.default_rng(1977)
    pixels = rng.random((512, 1024, 3)).astype(np.float32)
    for row, column in rng.integers(0, [500, 1000], size=(24, 2)):
        pixels[row : row + 6, column : column + 12] += np.float32(40.0)
    pixels[130:132, 700:702] = 1e5
    return pixels


def double_sum(radiance: np.ndarray, wanted: np.ndarray, exponent: float) -> np.ndarray:
    """Return the defining integral along wanted (n, 3) as a sum over all texels, float64."""
    height, width = radiance.shape[:2]
    towards = direction(ring_angles(height)[:, None], column_angles(width)[None, :]).reshape(-1, 3)
    weights = np.repeat(fejer_weights(height) * (2.0 * np.pi / width), width)
    flux = radiance.reshape(-1, 3).astype(np.float64) * weights[:, None]
    values = []
    for way in wanted:
        cosine = towards @ way
        seen = np.flatnonzero(cosine > (1e-18 ** (1.0 / exponent)))
        values.append(cosine[seen] ** exponent @ flux[seen])
    return np.array(values) * (exponent + 1.0) / (2.0 * np.pi)


def errors(environment: Environment, progress: Progress | None) -> tuple[float, float]:
    """Return the largest and the RMS error of the unpacked maps over random texels and the brightest one."""
    lobe_filter = LobeFilter(environment.radiance)
    rng = np.random.default_rng(3)
    found = []
    for index, exponent in enumerate(ERROR_EXPONENTS):
        report(progress, index / len(ERROR_EXPONENTS), f"checking exponent {exponent:g}")
        size = face_size(exponent)
        got = lobe_filter.lobe(exponent, size)
        brightest = np.unravel_index(got.max(axis=3).argmax(), got.shape[:3])
        at = tuple(np.vstack([rng.integers(0, [6, size, size], size=(DIRECTIONS, 3)), brightest]).T)
        truth = double_sum(environment.radiance, texel_directions(size)[at], exponent)
        found.append((got[at] - truth).ravel() / got.max())
    every = np.concatenate(found)
    return float(np.abs(every).max()), float(np.sqrt(np.mean(every**2)))


def _clock(times: dict[float | None, float]) -> Ready:
    """Return a listener that notes when each map is ready."""

    def note(exponent: float | None, _: FaceArray) -> None:
        times[exponent] = perf_counter()

    return note


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure and return the figures named in ``BOUNDS``."""
    environment = Environment("bench", bench_map())
    exponents = default_basis().exponents
    broad = [e for e in (1.0, *exponents) if lobe_bandlimit(e) <= BROAD_BANDLIMIT]
    first, whole = [], []
    prefilter(environment, [5.0])  # imports and first use of the threads stay out of the figures
    for repeat in range(3):
        ready: dict[float | None, float] = {}
        start = perf_counter()
        prefilter(
            environment,
            exponents,
            part(progress, 0.2 * repeat, 0.2 * (repeat + 1)),
            _clock(ready),
        )
        whole.append(perf_counter() - start)
        first.append(ready[max(broad)] - start)
    error_max, error_rms = errors(environment, part(progress, 0.6, 0.95))
    hits = []
    with tempfile.TemporaryDirectory() as folder:
        cache = MapCache(folder)
        cache.get_or_compute(environment, exponents)
        for _ in range(5):
            start = perf_counter()
            cache.get_or_compute(environment, exponents)
            hits.append(perf_counter() - start)
    report(progress, 1.0, "done")
    return {
        "first_light_s": median(first),
        "default_1k_s": median(whole),
        "error_max": error_max,
        "error_rms": error_rms,
        "cache_hit_ms": 1e3 * median(hits),
    }
