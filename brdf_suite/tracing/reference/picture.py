"""A paint by name or file, in a view, to a path-traced picture: in passes, within a budget, and to be gone on from."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

import numpy as np

from brdf_suite.appearance.colour.spaces import WORKING_SPACE, DisplaySpace
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import check_target
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.environments import write_png_strips
from brdf_suite.lighting.environment import Environment
from brdf_suite.output.picture_file import PictureSettings
from brdf_suite.pipeline.material import Material
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.pictures.tone_curves import tone_curve
from brdf_suite.reference.estimate_file import read_estimate, write_estimate
from brdf_suite.reference.passes import Estimate, check_denoiser, denoise_picture, trace
from brdf_suite.reference.variant import start
from brdf_suite.regular_files import exists
from brdf_suite.tracing.reference.scene import ReferenceScene, prepare_reference
from brdf_suite.tracing.traced_picture import Size, TracedFile, too_large


def check_settings(path: Path, settings: PictureSettings) -> tuple[int, DisplaySpace]:
    """Return bits and colour space of a traced picture's file; :class:`FileError` where it cannot be so."""
    bits, space = settings.of_file(path)
    if path.suffix.lower() == ".exr" and (bits != 32 or space is not WORKING_SPACE):
        raise FileError(
            path,
            "the EXR of a traced picture holds what a render goes on from, in 32 bits and Rec. 2020; leave out --bits "
            "and --colour-space",
        )
    return bits, space


def write_reference(
    path: Path, scene: ReferenceScene, estimate: Estimate, settings: PictureSettings, *, denoise: bool = False
) -> None:
    """Write a traced picture, whole or not at all.

    ``settings`` are those of a drawn one; transparent is the object alone, its share of each pixel as alpha.

    Raises
    ------
    FileError
        The name, the settings or the folder do not allow it.
    ReferenceUnavailableError
        ``denoise`` is asked for where there is no denoiser.
    """
    bits, space = check_settings(path, settings)
    picture: Floats = estimate.radiance if settings.transparent else scene.whole(estimate)
    if denoise:
        picture = denoise_picture(picture)
    view = scene.exposed_view(estimate)
    metadata = {
        "Software": "BRDF Suite",
        "Title": scene.name,
        "Description": f"{scene.name} on {scene.surface} in {scene.environment}, path-traced with {estimate.samples} "
        f"samples a pixel{', denoised' if denoise else ''}, {view.exposure_ev:+g} EV, tone curve {view.tone_curve}",
    }
    if path.suffix.lower() == ".exr":
        write_estimate(path, estimate, picture, scene.key, {"comments": metadata["Description"]})
        return
    light = picture
    if settings.transparent:
        # Straight alpha: the object's own light, not that of the pixel that it shares.
        light = picture / np.maximum(estimate.coverage, 1e-6)[..., None]
    toned = tone_curve(light * 2.0**view.exposure_ev, view.tone_curve)
    top = 2**bits - 1
    kind = np.uint8 if bits == 8 else np.uint16
    pixels = np.asarray(np.rint(space.encode(space.of_working(toned)) * top), kind)
    if settings.transparent:
        alpha = np.rint(np.clip(estimate.coverage, 0.0, 1.0) * top).astype(pixels.dtype)
        pixels = np.concatenate((pixels, alpha[..., None]), axis=-1)
    write_png_strips(path, scene.size, iter([pixels]), metadata, space)


DEFAULT_SAMPLES = 256
_KEEP_EVERY_S = 20.0


@dataclass(frozen=True, kw_only=True)
class ReferencePicture(TracedFile):
    """A path-traced picture that was written."""

    noise: float


def render_reference(
    paint: PathLike | Material,
    view: View,
    size: Size,
    path: PathLike,
    *,
    samples: int | None = None,
    seconds: float | None = None,
    fresh: bool = False,
    settings: PictureSettings | None = None,
    denoise: bool = False,
    environment: Environment | None = None,
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
    environment
        One in memory, in place of the view's.
    """
    settings, path = settings or PictureSettings(), Path(path)
    check_settings(path, settings)
    check_target(path)
    if denoise:  # checked before the work, not after it
        start(scalar=True)
        check_denoiser()
    try:
        scene = prepare_reference(
            paint, view, size, environment=environment, progress=subrange(progress, 0.0, 0.05)
        )
    except MemoryError as error:
        raise too_large(size) from error
    state = path.with_name(path.name + ".part.exr")
    begun = None if fresh or not exists(state) else read_estimate(state, scene.key)
    if samples is None and seconds is None:
        samples = DEFAULT_SAMPLES
    last = perf_counter()
    newest: list[Estimate] = []

    def kept(estimate: Estimate) -> None:
        nonlocal last
        newest[:] = [estimate]
        if perf_counter() - last >= _KEEP_EVERY_S:
            write_estimate(state, estimate, scene.whole(estimate), scene.key)
            last = perf_counter()

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
            raise too_large(size) from error
        raise
    write_reference(path, scene, estimate, settings, denoise=denoise)
    state.unlink(missing_ok=True)
    report(progress, 1.0, "written")
    return ReferencePicture(
        **scene.file_facts(path),
        samples=estimate.samples,
        seconds=estimate.seconds,
        noise=estimate.noise,
        resumed_samples=0 if begun is None else begun.samples,
    )
