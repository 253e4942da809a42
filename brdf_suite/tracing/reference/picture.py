"""A paint by name or file, in a view, to a path-traced picture: in passes, within a budget, and to be gone on from."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

from brdf_suite.documents.view import View
from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.output.picture_file import PictureSettings, check_target
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reference.denoise import check_denoiser
from brdf_suite.reference.estimate_file import read_estimate, write_estimate
from brdf_suite.reference.passes import Estimate, refine, trace
from brdf_suite.reference.variant import start
from brdf_suite.tracing.reference.file import check_settings, write_reference
from brdf_suite.tracing.reference.scene import ReferenceScene, Size, prepare_reference
from brdf_suite.tracing.traced_picture import TracedFile, scene_facts

DEFAULT_SAMPLES = 256
_KEEP_EVERY_S = 20.0


@dataclass(frozen=True, kw_only=True)
class ReferencePicture(TracedFile):
    """A path-traced picture that was written."""

    noise: float


def render_reference(
    paint: str | os.PathLike[str],
    view: View,
    size: Size,
    path: Path,
    *,
    samples: int | None = None,
    seconds: float | None = None,
    fresh: bool = False,
    settings: PictureSettings | None = None,
    denoise: bool = False,
    progress: Progress | None = None,
) -> ReferencePicture:
    """Path-trace a picture and write it as PNG (as a screen shows it) or EXR (radiance with its variance).

    What is traced is kept in ``<path>.part.exr`` every few seconds and when the progress callback cancels; the same
    call goes on from there, unless it is to begin ``fresh``. Errors as :func:`prepare_reference`.

    Parameters
    ----------
    samples, seconds
        The budget per pixel and in time, whichever is spent first; 256 samples where neither is given.
    settings
        Bits, colours and transparency of the file, as of a drawn picture.
    denoise
        Take the noise out, where there is an NVIDIA graphics card; an EXR keeps the noisy light beside.
    """
    settings = settings or PictureSettings()
    check_settings(path, settings)
    check_target(path)
    if denoise:
        _check_denoiser()
    try:
        scene = prepare_reference(paint, view, size, progress=subrange(progress, 0.0, 0.05))
    except MemoryError as error:
        raise _too_large(size) from error
    state = path.with_name(path.name + ".part.exr")
    begun = None if fresh or not state.exists() else read_estimate(state, scene.key)
    if samples is None and seconds is None:
        samples = DEFAULT_SAMPLES
    last = perf_counter()

    def keep(estimate: Estimate) -> None:
        nonlocal last
        if perf_counter() - last >= _KEEP_EVERY_S:
            write_estimate(state, estimate, scene.whole(estimate), scene.key)
            last = perf_counter()

    newest: list[Estimate] = []

    def kept(estimate: Estimate) -> None:
        newest[:] = [estimate]
        keep(estimate)

    try:
        estimate = trace(
            scene.traced,
            samples=samples,
            seconds=seconds,
            estimate=begun,
            progress=subrange(progress, 0.05, 0.98),
            kept=kept,
        )
    except BaseException as error:
        if newest:  # cancelled, or out of memory: what is there is not lost
            write_estimate(state, newest[0], scene.whole(newest[0]), scene.key)
        if isinstance(error, MemoryError):
            raise _too_large(size) from error
        raise
    write_reference(path, scene, estimate, settings, denoise=denoise)
    state.unlink(missing_ok=True)
    report(progress, 1.0, "written")
    return ReferencePicture(
        **scene_facts(scene, path),
        samples=estimate.samples,
        seconds=estimate.seconds,
        noise=estimate.noise,
        resumed_samples=0 if begun is None else begun.samples,
    )


def refined(scene: ReferenceScene, estimate: Estimate | None = None) -> Iterator[Estimate]:
    """Yield ever better estimates of a scene, without end: for a window that refines while it is idle."""
    return refine(scene.traced, estimate)


def _too_large(size: Size) -> ReferenceUnavailableError:
    return ReferenceUnavailableError(
        f"There is not enough memory to trace {size[0]} × {size[1]} pixels; make the picture smaller."
    )


def _check_denoiser() -> None:
    """Before the work, not after it."""
    start(scalar=True)
    check_denoiser()
