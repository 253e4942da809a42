"""A drawn scene to a picture file: PNG as a screen shows it, or EXR as radiance, of any size."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.spaces import SPACES, WORKING_SPACE, DisplaySpace
from brdf_suite.documents.store import view_to_json
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.images.environments import write_exr_strips, write_png_strips
from brdf_suite.output.exposures import DEFAULT_EXPOSURES, MOST_EXPOSURES, exposures_of
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.progress import Progress, report
from brdf_suite.realtime.pictures.display import LINEAR, Display
from brdf_suite.realtime.pictures.light_pass import DEFAULT_SAMPLES
from brdf_suite.realtime.pictures.renderer import Renderer

Size = tuple[int, int]

PICTURE_ENDINGS = (".png", ".exr")
COLOUR_SPACES = {"srgb": "sRGB", "display-p3": "Display P3", "rec2020": "Rec. 2020"}
"""Titles of those of a picture: the first two for PNG and EXR, the last, the working space, for EXR alone."""

_BITS = {".png": (8, 16), ".exr": (32, 16)}
_MOST_SAMPLES = 64


@dataclass(frozen=True)
class PictureSettings:
    """What a picture file holds beside what it shows.

    Attributes
    ----------
    bits
        8 or 16 of a PNG, 16 (half floats) or 32 of an EXR; None: 8 and 32.
    colour_space
        One of :data:`COLOUR_SPACES`; None: sRGB for PNG, Rec. 2020 for EXR.
    samples
        Per pixel, as many as the GPU offers at most.
    transparent
        The object alone, before nothing.
    exposures
        Pictures that are averaged where the view's lens blurs.
    """

    bits: int | None = None
    colour_space: str | None = None
    samples: int = DEFAULT_SAMPLES
    transparent: bool = False
    exposures: int = DEFAULT_EXPOSURES

    def __post_init__(self) -> None:
        if not 1 <= self.samples <= _MOST_SAMPLES:
            raise ValueRangeError(
                "samples", f"1 to {_MOST_SAMPLES} samples a pixel are taken, not {self.samples}"
            )
        if not 1 <= self.exposures <= MOST_EXPOSURES:
            raise ValueRangeError(
                "exposures", f"1 to {MOST_EXPOSURES:,} exposures are averaged, not {self.exposures}"
            )
        if self.colour_space is not None and self.colour_space not in COLOUR_SPACES:
            raise ValueRangeError(
                "colour_space", f"one of {', '.join(COLOUR_SPACES)} is wanted, not {self.colour_space!r}"
            )

    def of_file(self, path: Path) -> tuple[int, DisplaySpace]:
        """Return the bits and the colour space that a picture of this name gets; FileError where it cannot."""
        ending = path.suffix.lower()
        if ending not in _BITS:
            known = " or ".join(PICTURE_ENDINGS)
            raise FileError(path, f"pictures are written as PNG or EXR; give a name that ends in {known}")
        bits = _BITS[ending][0] if self.bits is None else self.bits
        if bits not in _BITS[ending]:
            wanted = " or ".join(str(n) for n in sorted(_BITS[ending]))
            raise FileError(path, f"{ending[1:].upper()} has {wanted} bits a channel, not {bits}")
        space = self.colour_space or ("srgb" if ending == ".png" else "rec2020")
        if ending == ".png" and space == "rec2020":
            raise FileError(path, "PNG pictures are written in srgb or display-p3; rec2020 is for EXR")
        return bits, WORKING_SPACE if space == "rec2020" else SPACES[space]


def write_picture(
    renderer: Renderer,
    view: View,
    size: Size,
    path: Path,
    settings: PictureSettings,
    metadata: Mapping[str, str],
    progress: Progress | None = None,
) -> None:
    """Draw the renderer's scene and write it, strip by strip: memory does not grow with the picture.

    A PNG is what a screen of its colour space shows, its ICC profile with it, without the marks of what such a
    screen cannot show. An EXR is the radiance before exposure and tone curve, in the primaries that it states. What
    is written is whole, or the old file stays.

    Raises
    ------
    FileError
        The name, the settings or the folder do not allow it.
    GraphicsError
        The GPU could not draw it.
    Cancelled
        The progress callback asked for it.
    """
    bits, space = settings.of_file(path)
    linear = path.suffix.lower() == ".exr"
    display = LINEAR if linear else Display(space, dithered=bits == 8)
    view = replace(metered(renderer, view, size), clipping_marks=False, gamut_marks=False)
    strips = renderer.strips(
        view,
        size,
        settings.samples,
        display=display,
        transparent=settings.transparent,
        exposures=exposures_of(view, renderer.bounds, size, settings.exposures),
    )
    drawn = _report_strips(strips, size, progress)
    if not linear:
        write_png_strips(path, size, drawn, metadata, space)
        return
    assert space.primaries is not None
    (rx, ry), (gx, gy), (bx, by) = space.primaries
    chromaticities = (rx, ry, gx, gy, bx, by, *space.white_xy)
    channels = 4 if settings.transparent else 3
    matrix = None if space is WORKING_SPACE else space.from_working.T.astype(np.float32)
    converted = (
        strip[..., :channels]
        if matrix is None
        else np.concatenate([strip[..., :3] @ matrix, strip[..., 3:channels]], axis=2)
        for strip in drawn
    )
    # Under the names that EXR readers know.
    known = {"Software": "software", "Title": "paint", "Description": "comments"}
    named = {
        known.get(key, key[:1].lower() + key[1:].replace(" ", "")): text for key, text in metadata.items()
    }
    write_exr_strips(path, size, converted, chromaticities, named, half=bits == 16)


def _report_strips(
    strips: Iterator[NDArray[Any]], size: Size, progress: Progress | None
) -> Iterator[NDArray[Any]]:
    done = 0
    report(progress, 0.0, "drawing")
    for strip in strips:
        done += len(strip)
        report(progress, done / size[1], f"drawing, {done:,} of {size[1]:,} rows")
        yield strip


def picture_metadata(fit: LobeFit, view: View) -> dict[str, str]:
    """Return the text entries of a picture of ``fit`` in ``view``: program, title, what it shows, the view itself."""
    return {
        "Software": "BRDF Suite",
        "Title": fit.name,
        "Description": (
            f"{fit.name} on {Path(view.surface).stem} in {Path(view.environment).stem}, "
            f"{view.exposure_ev:+g} EV, light turned {view.rotation_deg:g}°, tone curve {view.tone_curve}, "
            f"fresnel {view.fresnel.replace('_', ' ')}"
        ),
        "View": json.dumps(view_to_json(view), ensure_ascii=False, separators=(",", ":")),
    }
