"""How colours in CMYK look through the ICC profile of a press (littleCMS, as Pillow has it).

The numbers of the inks stay; beside them stands the L*a*b* (D50, 2°) that the profile gives, by which they are shown
and converted. The intent is relative colorimetric, so bare paper is white, as colour profiles connect. Pillow passes 8
bits each way, so L* is right to 0.2 and a*, b* to 0.5.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from io import BytesIO

import numpy as np

from brdf_suite.appearance.colour.flat_colours import measured_look
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import read_bytes, within_memory

LARGEST_PROFILE = 16 << 20
_DEVICE = slice(16, 20)
_SIGNATURE = slice(36, 40)
_MOST_OTHERS = 16


@within_memory
def read_profile(path: PathLike) -> bytes:
    """Return the content of a CMYK profile; raise :class:`FileError` where it is none, or cannot be read."""
    profile = read_bytes(path, LARGEST_PROFILE)
    labs_through([], profile, path)
    return profile


def is_cmyk_profile(profile: bytes) -> bool:
    """Return whether the content of a file is an ICC profile of a device in CMYK."""
    return profile[_SIGNATURE] == b"acsp" and profile[_DEVICE] == b"CMYK"


def labs_through(inks: Sequence[Sequence[float]], profile: bytes, path: PathLike) -> list[tuple[float, ...]]:
    """Return L*a*b* (D50, 2°) of inks (n, 4), 0 to 1; raise :class:`FileError` for a profile that is none of CMYK."""
    # 25 ms at the start of each program, and few palettes need it.
    from PIL import Image, ImageCms

    if not is_cmyk_profile(profile):
        raise FileError(path, "is no ICC profile of a device in CMYK", "byte 16")
    codes = np.rint(255.0 * np.array([*inks, (0.0, 0.0, 0.0, 0.0)])).astype(np.uint8)
    picture = Image.frombytes("CMYK", (len(codes), 1), codes.tobytes())
    try:
        transform = ImageCms.buildTransform(
            ImageCms.ImageCmsProfile(BytesIO(profile)),
            ImageCms.createProfile("LAB"),
            "CMYK",
            "LAB",
            renderingIntent=ImageCms.Intent.RELATIVE_COLORIMETRIC,
        )
        made = ImageCms.applyTransform(picture, transform)
    except (ImageCms.PyCMSError, OSError, ValueError) as error:
        raise FileError(path, f"is no profile that can be used ({str(error)[:80]})", "byte 0") from error
    assert made is not None  # only where it is done in place
    lab = np.frombuffer(made.tobytes(), np.uint8).reshape(-1, 3)[:-1]
    lightness, a, b = lab[:, 0] * (100.0 / 255.0), lab[:, 1].view(np.int8), lab[:, 2].view(np.int8)
    return [tuple(map(float, row)) for row in zip(lightness, a, b, strict=True)]


def seen_through(palette: Palette, profiles: Mapping[str, bytes], path: PathLike) -> tuple[Palette, int]:
    """Return a palette in which colours in CMYK have the look that profiles give, and of how many that is.

    ``profiles`` are by the names of colour spaces; the one under an empty name is for all others. Colours that have a
    look of their own keep it. Raises :class:`FileError`: a profile is none of CMYK.
    """
    entries = list(palette.entries)
    waiting: dict[bytes, list[int]] = {}
    for index, entry in enumerate(entries):
        content = entry.content
        if (
            not isinstance(content, FlatColour)
            or content.model != "CMYK"
            or len(content.others) >= _MOST_OTHERS
        ):
            continue
        profile = profiles.get(content.space, profiles.get(""))
        if profile is not None and measured_look(content) is None:
            waiting.setdefault(profile, []).append(index)
    for profile, indices in waiting.items():
        labs = labs_through([_inks(entries[index]) for index in indices], profile, path)
        for index, lab in zip(indices, labs, strict=True):
            content = entries[index].content
            assert isinstance(content, FlatColour)  # as above
            look = FlatColour("", "Lab", lab, illuminant="D50", observer_deg=2)
            entries[index] = replace(entries[index], content=replace(content, others=(look, *content.others)))
    count = sum(map(len, waiting.values()))
    return (replace(palette, entries=tuple(entries)) if count else palette), count


def _inks(entry: Entry) -> tuple[float, ...]:
    assert isinstance(entry.content, FlatColour)
    return entry.content.values


def profile_note(count: int, name: str) -> str:
    """Return the notice about colours that are seen through a profile."""
    shown = "colour is" if count == 1 else "colours are"
    return f"{count:,} CMYK {shown} shown through the profile {name}; the numbers of the inks are kept as they are."
