"""Time and accuracy of prefiltering, and time saved by the cache; maps with a strong sun."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter
from types import ModuleType

import numpy as np

from brdf_suite.errors import SuiteError
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray, pack_faces
from brdf_suite.lighting.filter.harmonics import BROAD_BANDLIMIT, lobe_bandlimit, lobe_coefficients
from brdf_suite.lighting.filter.kernels.compilation import compile_now
from brdf_suite.lighting.filter.lobe_filter import LobeFilter
from brdf_suite.lighting.filter.lobe_maps import Ready, face_size, prefilter
from brdf_suite.lighting.latlong import angles, fejer_weights
from brdf_suite.progress import Progress, report

NAME = "prefilter"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "first_light_s": ("<=", 0.3, "s", "diffuse map and broad lobes ready, 1024×512, median of 5"),
    "default_1k_s": ("<=", 1.5, "s", "whole default lobe set, pixels to packed maps, 1024×512, median of 5"),
    "default_2k_s": ("<=", 2.0, "s", "the same, 2048×1024, median of 3"),
    "default_4k_s": ("<=", 4.0, "s", "the same, 4096×2048"),
    "default_8k_s": ("<=", 10.0, "s", "the same, 8192×4096, in a separate process"),
    "peak_memory_mb": ("<=", 2048.0, "MB", "peak memory of that process, including its 403 MB of pixels"),
    "ratio_to_ducc0": (
        "<=",
        1.0,
        "",
        "time of default_1k_s over the same work with ducc0, interleaved, median of 5",
    ),
    "ducc0_1k_s": ("", None, "s", "the same work with ducc0, positions of texels given"),
    "error_max": (
        "<=",
        1e-6,
        "",
        "n = 5 … 5,120, against a float64 double sum, 2,040 directions, relative to the maximum",
    ),
    "error_rms": ("", None, "", "the same, root mean square"),
    "error_diffuse": ("<=", 2e-4, "", "n = 1, the same"),
    "constant_deviation": ("<=", 1e-4, "", "constant light, every exponent, largest deviation"),
    "sun_local_error": (
        "<=",
        1e-3,
        "",
        "sky beside a one-texel sun of 10⁵ times its radiance, relative to the value there",
    ),
    "negatives": ("<=", 0.0, "", "values below 0 in the same maps, before packing"),
    "lookup_error": ("<=", 0.01, "", "look-ups of packed maps as in a shader, relative to the lobe's peak"),
    "lookup_error_2k": (
        "<=",
        0.01,
        "",
        "the same, n = 50,000, filtered from 2048×1024; its map is limited to 2,048 texels",
    ),
    "lookup_error_4k": ("", None, "", "the same, n = 116,000, filtered from 4096×2048"),
    "cache_hit_ms": (
        "<=",
        150.0,
        "ms",
        "open environment to textures uploaded, maps in the cache, median of 5",
    ),
}


def bench_map(rings: int = 512) -> np.ndarray:
    """Return radiance (rings, 2·rings, 3): noise, lamps and a sun of 10⁵ times the sky."""
    rng = np.random.default_rng(1977)
    pixels = rng.random((rings, 2 * rings, 3), dtype=np.float32)
    scale = rings / 512.0
    for row, column in rng.integers(0, [500, 1000], size=(24, 2)):
        top, left = int(row * scale), int(column * scale)
        pixels[top : top + int(6 * scale), left : left + int(12 * scale)] += np.float32(40.0)
    top, left = int(130 * scale), int(700 * scale)
    pixels[top : top + int(2 * scale), left : left + int(2 * scale)] = 1e5
    return pixels


def with_ducc0(environment: Environment, exponents: list[float], positions: dict[int, np.ndarray]) -> float:
    """Return the time of the same work with ducc0: pixels to packed maps of the same bandlimits and sizes."""
    import ducc0

    height, width = environment.radiance.shape[:2]
    start = perf_counter()
    limit = max(lobe_bandlimit(e) for e in exponents)
    weights = fejer_weights(height) * (2.0 * np.pi / width)
    weighted = (environment.radiance * weights[:, None, None]).transpose(2, 0, 1).astype(np.float64)
    transform = ducc0.sht.adjoint_synthesis_2d
    alm = [transform(map=plane[None], spin=0, lmax=limit, geometry="F1", nthreads=2)[0] for plane in weighted]
    for exponent in exponents:
        sharpest = lobe_bandlimit(exponent)
        gains = lobe_coefficients(exponent, sharpest)
        place = [m * (2 * limit + 1 - m) // 2 + np.arange(m, sharpest + 1) for m in range(sharpest + 1)]
        of_term = np.concatenate([gains[m:] for m in range(sharpest + 1)])
        size = face_size(exponent)
        faces = np.empty((6, size, size, 3))
        for channel in range(3):
            values = ducc0.sht.synthesis_general(
                alm=(alm[channel][np.concatenate(place)] * of_term)[None],
                spin=0,
                lmax=sharpest,
                loc=positions[size],
                epsilon=1e-6,
                nthreads=2,
            )
            faces[..., channel] = values.reshape(6, size, size)
        pack_faces(faces)
    return perf_counter() - start


def _clock(times: dict[float | None, float]) -> Ready:
    """Return a listener that notes when each map is ready."""

    def note(exponent: float | None, _: FaceArray) -> None:
        times[exponent] = perf_counter()

    return note


def _once(rings: int) -> float:
    """Return the time of the default set on a map of so many rings."""
    environment = Environment("bench", bench_map(rings))
    start = perf_counter()
    prefilter(environment, default_basis().exponents)
    return perf_counter() - start


def _large() -> tuple[float, float]:
    """Return time (s) and most memory (MB) of a process that filters a map of 8192×4096."""
    done = subprocess.run(
        [sys.executable, __file__, "4096"], capture_output=True, text=True, check=False, timeout=900.0
    )
    if done.returncode != 0:
        raise SuiteError(f"The filter of a map of 8192×4096 failed: {done.stderr.strip()[-400:]}")
    seconds, memory = done.stdout.split()
    return float(seconds), float(memory)


def _cache_hits() -> float:
    from brdf_suite.lighting.lobe_map_cache import MapCache
    from brdf_suite.pipeline.scene import load_environment
    from brdf_suite.realtime.environment.textures import EnvironmentTextures
    from brdf_suite.realtime.gl.context import create_context
    from brdf_suite.realtime.gl.objects import GpuObjects
    from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps

    def faces(item: FaceArray) -> CubeFaces:
        return CubeFaces(item.faces, item.scale)

    context = create_context()
    textures = EnvironmentTextures(GpuObjects(context))
    hits = []
    with tempfile.TemporaryDirectory() as folder:
        cache = MapCache(folder)
        load_environment("sunny", cache=cache)
        for _ in range(5):
            start = perf_counter()
            maps = load_environment("sunny", cache=cache).maps
            lobes = tuple(faces(item) for item in maps.lobes)
            others = (faces(item) for item in (maps.diffuse, maps.through_coat, maps.background))
            textures.load(EnvironmentMaps(maps.exponents, lobes, *others))
            context.finish()
            hits.append(perf_counter() - start)
    textures.release()
    return 1e3 * median(hits)


def _accuracy() -> ModuleType:
    """Load the module beside this file."""
    path = Path(__file__).resolve().parent / "parts" / "prefilter_accuracy.py"
    spec = importlib.util.spec_from_file_location("brdf_suite_prefilter_accuracy", path)
    if spec is None or spec.loader is None:
        raise SuiteError(f"{path} cannot be imported.")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _speed(progress: Progress | None) -> dict[str, float | None]:
    environment = Environment("bench", bench_map())
    exponents = default_basis().exponents
    sharpest = LobeFilter(environment.radiance).largest_exponent
    filtered = sorted({1.0, *(e for e in exponents if e <= sharpest)})
    broad = [e for e in filtered if lobe_bandlimit(e) <= BROAD_BANDLIMIT]
    positions = {}
    for size in {face_size(e) for e in filtered}:
        theta, phi = angles(texel_directions(size))
        positions[size] = np.stack([theta.ravel(), phi.ravel() % (2.0 * np.pi)], axis=-1)
    first, whole, peer = [], [], []
    prefilter(environment, exponents)  # imports and first use of the threads stay out of the figures
    with_ducc0(environment, filtered, positions)
    for repeat in range(5):
        report(progress, 0.02 * repeat, "filtering 1024×512")
        ready: dict[float | None, float] = {}
        start = perf_counter()
        prefilter(environment, exponents, None, _clock(ready))
        whole.append(perf_counter() - start)
        first.append(ready[max(broad)] - start)
        peer.append(with_ducc0(environment, filtered, positions))
    return {
        "first_light_s": median(first),
        "default_1k_s": median(whole),
        "ratio_to_ducc0": median(a / b for a, b in zip(whole, peer, strict=True)),
        "ducc0_1k_s": median(peer),
    }


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure and return the figures named in ``BOUNDS``."""
    if compile_now() is None:
        raise SuiteError("The filter's kernels cannot be compiled here; install the extra `speed`.")
    figures = _speed(progress)
    report(progress, 0.1, "filtering larger maps")
    figures["default_2k_s"] = median(_once(1024) for _ in range(3))
    figures["default_4k_s"] = _once(2048)
    figures["default_8k_s"], figures["peak_memory_mb"] = _large()
    accuracy = _accuracy()
    exponents = default_basis().exponents
    report(progress, 0.3, "checking against the double sum")
    found = accuracy.errors(bench_map(), [1.0, *accuracy.ERROR_EXPONENTS])
    figures["error_diffuse"] = float(np.abs(found.pop(1.0)).max())
    rest = np.concatenate([item.ravel() for item in found.values()])
    figures["error_max"] = float(np.abs(rest).max())
    figures["error_rms"] = float(np.sqrt(np.mean(rest**2)))
    report(progress, 0.7, "checking constant light")
    figures["constant_deviation"] = accuracy.constant_deviation((*exponents, *accuracy.ERROR_EXPONENTS))
    report(progress, 0.75, "checking the sky beside a sun")
    figures["sun_local_error"], figures["negatives"] = accuracy.beside_a_sun(exponents)
    report(progress, 0.85, "looking up packed maps")
    figures["lookup_error"] = max(accuracy.look_up_error((*exponents, *accuracy.WORST_EXPONENTS)).values())
    for key, (exponent, rings) in zip(("lookup_error_2k", "lookup_error_4k"), accuracy.SHARP, strict=True):
        figures[key] = accuracy.sharp_look_up_error(exponent, rings)
    report(progress, 0.95, "opening an environment from the cache")
    figures["cache_hit_ms"] = _cache_hits()
    report(progress, 1.0, "done")
    return figures


if __name__ == "__main__":
    import resource

    prefilter(Environment("small", bench_map(16)), [5.0])  # the kernels are loaded
    elapsed = _once(int(sys.argv[1]))
    print(elapsed, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0)
