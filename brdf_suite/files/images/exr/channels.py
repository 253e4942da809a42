"""Selection of the light channels in an OpenEXR file and their conversion to RGB."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.exr.header import ExrChannel, ExrHeader
from brdf_suite.files.images.primaries import Chromaticities, rgb_to_xyz


@dataclass(frozen=True)
class ExrLight:
    """The part and channels of the light: ``rgb``, ``grey`` (Y alone) or ``chroma`` (Y, RY, BY)."""

    header: ExrHeader
    kind: Literal["rgb", "grey", "chroma"]
    channels: tuple[ExrChannel, ...]
    notes: tuple[str, ...]


def choose_light(path: PathLike, headers: Sequence[ExrHeader]) -> ExrLight:
    """Return the first part that holds R, G and B (also in a layer), or else Y with or without its chroma.

    Raises
    ------
    FileError
        No part does, or what does is deep, of integers, or stored at reduced resolution.
    """
    flat = [header for header in headers if not header.deep]
    if not flat:
        raise FileError(path, "holds deep data only; flatten it to an ordinary image first", "headers")
    for find in (_rgb, _luminance):
        for header in flat:
            light = find(header)
            if light is not None:
                _check(path, light)
                return light
    known = _shown(", ".join(channel.name for header in flat for channel in header.channels))
    wanted = "R, G and B, or Y with or without RY and BY"
    raise FileError(path, f"has the channels {known}; expected {wanted}", "channels")


def _shown(text: str) -> str:
    """Return a text of the file as it can stand in a message: short, and of characters that show."""
    seen = "".join(character if character.isprintable() else "\ufffd" for character in text)
    return seen if len(seen) <= 200 else f"{seen[:200]}…"


def _part_note(header: ExrHeader) -> tuple[str, ...]:
    if header.parts == 1:
        return ()
    called = f" ({header.name!r})" if header.name else ""
    return (f"part {header.part + 1} of {header.parts}{called} was read",)


def _rgb(header: ExrHeader) -> ExrLight | None:
    by_name = {channel.name: channel for channel in header.channels}
    for prefix in ["", *sorted({name[:-1] for name in by_name if name.endswith(".R")})]:
        names = [prefix + letter for letter in "RGB"]
        if all(name in by_name for name in names):
            layer = (f"layer {prefix.rstrip('.')!r} was read",) if prefix else ()
            channels = tuple(by_name[name] for name in names)
            return ExrLight(header, "rgb", channels, _part_note(header) + layer)
    return None


def _luminance(header: ExrHeader) -> ExrLight | None:
    by_name = {channel.name: channel for channel in header.channels}
    if "Y" not in by_name:
        return None
    if "RY" in by_name and "BY" in by_name:
        note = "stored as luminance and chroma"
        return ExrLight(
            header, "chroma", (by_name["Y"], by_name["RY"], by_name["BY"]), (*_part_note(header), note)
        )
    note = "one channel, Y: the light is taken as neutral"
    return ExrLight(header, "grey", (by_name["Y"],), (*_part_note(header), note))


def _check(path: PathLike, light: ExrLight) -> None:
    for channel in light.channels:
        if channel.kind == "uint":
            raise FileError(path, "holds integers, not radiance", f"channel {_shown(channel.name)}")
        allowed = ((1, 1), (2, 2)) if channel.name in ("RY", "BY") else ((1, 1),)
        if (channel.x_sampling, channel.y_sampling) not in allowed:
            raise FileError(
                path, "is stored at reduced resolution, which is not read", f"channel {_shown(channel.name)}"
            )


def to_rgb(
    light: ExrLight, planes: Mapping[str, NDArray[np.floating]], chromaticities: Chromaticities
) -> NDArray[np.float32]:
    """Return pixels (h, w, 3) float32 of the planes by channel name.

    Luminance and chroma are RY = (R - Y)/Y, BY = (B - Y)/Y with the Y of the file's primaries ("Luminance/Chroma
    Images", technical introduction to OpenEXR); chroma at half resolution is interpolated linearly.
    """
    first = planes[light.channels[0].name].astype(np.float32)
    if light.kind == "grey":
        return np.repeat(first[..., None], 3, axis=2)
    if light.kind == "rgb":
        rest = [planes[channel.name].astype(np.float32) for channel in light.channels[1:]]
        return np.stack([first, *rest], axis=2)
    shape = first.shape
    weights = rgb_to_xyz(chromaticities)[1].astype(np.float32)
    with np.errstate(
        invalid="ignore", over="ignore"
    ):  # what is not finite is repaired, and reported with all else
        red = (_full(planes["RY"], shape) + 1.0) * first
        blue = (_full(planes["BY"], shape) + 1.0) * first
        green = (first - weights[0] * red - weights[2] * blue) / weights[1]
    return np.stack([red, green, blue], axis=2).astype(np.float32)


def _full(plane: NDArray[np.floating], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return a plane at full resolution; samples of one at half lie on even rows and columns."""
    values = plane.astype(np.float32)
    for axis in (0, 1):
        if values.shape[axis] == shape[axis]:
            continue
        at = np.minimum(np.arange(shape[axis]) / 2.0, values.shape[axis] - 1.0)
        low = at.astype(np.int64)
        high = np.minimum(low + 1, values.shape[axis] - 1)
        part = (at - low).astype(np.float32)
        part = part[:, None] if axis == 0 else part[None, :]
        values = np.take(values, low, axis) * (1.0 - part) + np.take(values, high, axis) * part
    return values
