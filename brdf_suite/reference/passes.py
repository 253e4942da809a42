"""Progressive path tracing: passes of a few samples, their mean and its variance, until a budget is spent.

Passes have seeds of their own that follow from their number, so that a render that resumes from a file's passes is
the render that was never interrupted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.progress import Progress, report
from brdf_suite.reference.mitsuba_modules import mi
from brdf_suite.reference.scene.scene import TracedScene


@dataclass(frozen=True, eq=False)
class Estimate:
    """Estimate from the passes so far.

    ``radiance`` (h, w, 3) of the working space and ``coverage`` (h, w) are means over all samples; ``squares``
    (h, w, 3) is the sum over the passes of their samples times the squared deviation of their radiance from it
    (West 1979). ``samples`` are per pixel, in ``passes`` passes, which may be of different sizes.
    """

    radiance: Floats
    coverage: Floats
    squares: Floats
    samples: int
    passes: int
    seconds: float = 0.0

    @property
    def variance(self) -> Floats:
        """(h, w, 3): the variance of ``radiance``; infinite while there is one pass only."""
        if self.passes < 2:
            return np.full(self.squares.shape, np.inf)
        # Of a pass of n samples the variance is σ²/n, so the squares are σ² for each pass but one.
        return self.squares / ((self.passes - 1) * self.samples)

    @property
    def noise(self) -> float:
        """The median over the object's pixels of the standard error of the luminance, as a share of the luminance."""
        y = np.array([0.2627, 0.678, 0.0593])
        luminance = (self.radiance @ y)[self.coverage > 0.0]
        if not len(luminance):
            return 0.0
        # The channels' errors go together, as those of one light do.
        error = (np.sqrt(self.variance) @ y)[self.coverage > 0.0]
        return float(np.median(error / np.maximum(luminance, 1e-3 * luminance.mean() + 1e-30)))

    def with_pass(self, radiance: Floats, coverage: Floats, samples: int, seconds: float) -> Estimate:
        """Return the estimate with one pass of ``samples`` more."""
        share = samples / (self.samples + samples)
        away = radiance - self.radiance
        mean = self.radiance + share * away
        return Estimate(
            mean,
            self.coverage + share * (coverage - self.coverage),
            self.squares + samples * away * (radiance - mean),
            self.samples + samples,
            self.passes + 1,
            self.seconds + seconds,
        )

    @staticmethod
    def nothing(size: tuple[int, int]) -> Estimate:
        """Return the estimate before the first pass."""
        shape = (size[1], size[0])
        return Estimate(np.zeros((*shape, 3)), np.zeros(shape), np.zeros((*shape, 3)), 0, 0)


def trace_pass(scene: TracedScene, samples: int, seed: int) -> tuple[Floats, Floats]:
    """Return radiance (h, w, 3) and coverage (h, w) of ``samples`` per pixel.

    Raises
    ------
    ReferenceUnavailableError
        The renderer failed, as it does where memory runs out.
    """
    try:
        image = np.array(mi.render(scene.scene, spp=samples, seed=seed), np.float64)
    except (MemoryError, RuntimeError) as error:
        raise ReferenceUnavailableError(
            f"The reference renderer failed ({error}); try a smaller picture, or fewer samples in a pass."
        ) from error
    return image[..., :3], image[..., 3]


_MOVING_SAMPLES = 4


def step(
    scene: TracedScene, estimate: Estimate | None = None, *, samples: int = 4, first_seed: int = 0
) -> Estimate:
    """Return ``estimate`` with one pass of ``samples`` per pixel more. Errors as :func:`trace_pass`."""
    found = estimate or Estimate.nothing(scene.size)
    start = perf_counter()
    if scene.moments is not None:
        scene.go_to(scene.moments(first_seed + found.passes))
    radiance, coverage = trace_pass(scene, samples, seed=first_seed + found.passes)
    return found.with_pass(radiance, coverage, samples, perf_counter() - start)


def pass_size(size: tuple[int, int], most: int = 4_000_000) -> int:
    """Return samples a pixel of a pass: 4 to 16, a power of two, at most ``most`` in all where 4 are not more.

    The samples of one pass are spread over their pixel together (multi-jittered): in 16 the error is that of twice as
    many single ones. More would be long to wait for.

    >>> pass_size((320, 240)), pass_size((1920, 1080))
    (16, 4)
    """
    samples = 16
    while samples > 4 and samples * size[0] * size[1] > most:
        samples //= 2
    return samples


def refine(
    scene: TracedScene,
    estimate: Estimate | None = None,
    *,
    samples_per_pass: int = 4,
    samples: int = 0,
    first_seed: int = 0,
) -> Iterator[Estimate]:
    """Yield ever better estimates, resuming from ``estimate``; without end, or up to ``samples`` a pixel."""
    found = estimate or Estimate.nothing(scene.size)
    while not samples or found.samples < samples:
        wanted = min(samples_per_pass, samples - found.samples) if samples else samples_per_pass
        found = step(scene, found, samples=wanted, first_seed=first_seed)
        yield found


def trace(
    scene: TracedScene,
    *,
    samples: int | None = None,
    seconds: float | None = None,
    samples_per_pass: int | None = None,
    estimate: Estimate | None = None,
    first_seed: int = 0,
    progress: Progress | None = None,
    kept: Callable[[Estimate], Any] | None = None,
) -> Estimate:
    """Return the estimate of ``samples`` per pixel, or of ``seconds``, whichever is spent first.

    Parameters
    ----------
    samples_per_pass
        Left out: :func:`pass_size`.
    estimate
        From where to go on; its passes count towards ``samples``.
    first_seed
        Of the first pass; the others follow. Estimates whose seeds differ are independent.
    kept
        Called after every pass, so that what is there can be kept.

    Raises
    ------
    Cancelled
        The progress callback asked for it; what was traced has been handed to ``kept``.
    """
    start = perf_counter()
    found = estimate or Estimate.nothing(scene.size)
    before = found.samples
    report(progress, 0.0, "tracing")
    if samples is not None and before >= samples:
        return found
    # Where something moves, each pass is of one moment: better many of them.
    size = samples_per_pass or (pass_size(scene.size) if scene.moments is None else _MOVING_SAMPLES)
    for newest in refine(scene, found, samples_per_pass=size, samples=samples or 0, first_seed=first_seed):
        found = newest
        if kept is not None:
            kept(found)
        spent = perf_counter() - start
        shares = []
        if samples is not None:
            shares.append((found.samples - before) / (samples - before))
        if seconds is not None:
            shares.append(spent / seconds)
        share = max(shares, default=0.0)
        if share >= 1.0:
            break
        left = spent * (1.0 - share) / share
        report(progress, share, f"{found.samples} samples, {left:.0f} s left")
    return found


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
