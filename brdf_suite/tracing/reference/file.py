"""A traced picture to a file: PNG as a screen shows it, or EXR as radiance with its variance."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.display_space import WORKING_SPACE, DisplaySpace
from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError
from brdf_suite.files.images.environments import write_png_strips
from brdf_suite.output.picture_file import PictureSettings
from brdf_suite.realtime.pictures.tone_curves import tone_curve
from brdf_suite.reference.denoise import denoise_picture
from brdf_suite.reference.estimate_file import write_estimate
from brdf_suite.reference.passes import Estimate
from brdf_suite.tracing.reference.scene import ReferenceScene


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
    metadata = _metadata(scene, estimate, denoise=denoise)
    if path.suffix.lower() == ".exr":
        write_estimate(path, estimate, picture, scene.key, {"comments": metadata["Description"]})
        return
    light = picture
    if settings.transparent:
        # Straight alpha: the object's own light, not that of the pixel that it shares.
        light = picture / np.maximum(estimate.coverage, 1e-6)[..., None]
    pixels = _codes(light, scene, estimate, space, bits)
    if settings.transparent:
        top = 2**bits - 1
        alpha = np.rint(np.clip(estimate.coverage, 0.0, 1.0) * top).astype(pixels.dtype)
        pixels = np.concatenate((pixels, alpha[..., None]), axis=-1)
    write_png_strips(path, scene.size, iter([pixels]), metadata, space)


def _codes(
    light: Floats, scene: ReferenceScene, estimate: Estimate, space: DisplaySpace, bits: int
) -> NDArray[Any]:
    view = scene.exposed_view(estimate)
    toned = tone_curve(light * 2.0**view.exposure_ev, view.tone_curve)
    codes = np.rint(space.encode(space.of_working(toned)) * (2**bits - 1))
    return np.asarray(codes, np.uint8 if bits == 8 else np.uint16)


def _metadata(scene: ReferenceScene, estimate: Estimate, *, denoise: bool) -> Mapping[str, str]:
    return {
        "Software": "BRDF Suite",
        "Title": scene.name,
        "Description": f"{scene.name} on {scene.surface} in {scene.environment}, path-traced with {estimate.samples} "
        f"samples a pixel{', denoise_picture' if denoise else ''}, {scene.exposed_view(estimate).exposure_ev:+g} EV, "
        f"tone curve {scene.view.tone_curve}",
    }
