"""Profiles of a made-up monitor by tables, each kind that ICC.1 has, written from the monitor's own formula.

The channels have three exponents, and each takes some light from the others, so that no matrix describes the screen;
black is not dark. Nothing here is shared with the reader.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

WHITE = np.array([0.9642, 1.0, 0.8249])
EXPONENTS = np.array([2.2, 2.0, 2.4])
_TAKEN = 0.12
# Columns: red, green and blue, XYZ for D50; nearly those of Display P3.
_COLOURS = np.array([[0.5151, 0.2920, 0.1571], [0.2412, 0.6922, 0.0666], [-0.0011, 0.0419, 0.7841]])
_COLOURS = _COLOURS * (WHITE / _COLOURS.sum(axis=1))[:, None]


@dataclass(frozen=True)
class Screen:
    """The monitor; ``black`` is the share of white that it gives at the codes 0."""

    black: float = 0.0

    def xyz(self, codes: Array) -> Array:
        """XYZ (..., 3), white being D50 with Y = 1, of codes 0…1."""
        light = np.asarray(codes, float) ** EXPONENTS
        others = (light.sum(axis=-1, keepdims=True) - light) / 2.0
        light = light * (1.0 - _TAKEN * others) / (1.0 - _TAKEN)
        return self.black * WHITE + (1.0 - self.black) * light @ _COLOURS.T

    def codes(self, xyz: Array) -> Array:
        """Codes (..., 3) that give XYZ, each channel's light being clipped to what there is."""
        light = (np.asarray(xyz, float) - self.black * WHITE) / (1.0 - self.black) @ np.linalg.inv(_COLOURS).T
        wanted = np.clip(light, 0.0, 1.0)
        light = wanted
        for _ in range(30):
            others = (light.sum(axis=-1, keepdims=True) - light) / 2.0
            light = np.clip(wanted * (1.0 - _TAKEN) / (1.0 - _TAKEN * others), 0.0, 1.0)
        return light ** (1.0 / EXPONENTS)


def xyz_to_lab(xyz: Array) -> Array:
    t = np.asarray(xyz, float) / WHITE
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack(
        (116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])), axis=-1
    )


def lab_to_xyz(lab: Array) -> Array:
    fy = (lab[..., 0] + 16) / 116
    f = np.stack((fy + lab[..., 1] / 500, fy, fy - lab[..., 2] / 200), axis=-1)
    return WHITE * np.where(f > 6 / 29, f**3, 3 * (6 / 29) ** 2 * (f - 4 / 29))


_XYZ_FULL = 1.0 + 32767.0 / 32768.0


def _lab_scale(kind: str) -> tuple[Array, Array]:
    """What L*, a*, b* of 0 are, and how much of the whole one of them is: numbers 0…1 = (lab + start) / length."""
    if kind == "lut16":  # of version 2: the top is FF00h
        return np.array([0.0, 128.0, 128.0]), np.array([100.0, 255.0, 255.0]) * 65535 / 65280
    return np.array([0.0, 128.0, 128.0]), np.array([100.0, 255.0, 255.0])


def profile(kind: str, space: str, screen: Screen = Screen(), points: int = 25) -> bytes:
    """A profile with A2B0 and B2A0 of a kind, ``lut8``, ``lut16`` or ``mAB``, by way of ``Lab`` or ``XYZ``."""
    start, length = _lab_scale(kind)
    grid = np.linspace(0.0, 1.0, points)
    cube = np.stack(np.meshgrid(grid, grid, grid, indexing="ij"), axis=-1)
    if space == "Lab":
        shape, unshape = np.array([1.0]), np.array([1.0])
        towards = (xyz_to_lab(screen.xyz(cube)) + start) / length
        back = screen.codes(lab_to_xyz(cube * length - start))
    else:  # of light, equal steps are too coarse in the dark: the tables' own curves are powers
        shape, unshape = np.array([2.2]), np.array([1 / 2.2])
        towards = screen.xyz(cube ** (1 / 2.2)) / _XYZ_FULL
        back = screen.codes(cube**2.2 * _XYZ_FULL)
    writer = _modern if kind == "mAB" else _classic
    tags = {
        b"desc": _description("Table screen"),
        b"cprt": b"text\0\0\0\0none\0",
        b"wtpt": b"XYZ \0\0\0\0" + _fixed(WHITE),
        b"A2B0": writer(kind, towards, float(shape[0]), forwards=True),
        b"B2A0": writer(kind, back, float(unshape[0]), forwards=False),
    }
    return assemble(tags, space, 4 if kind == "mAB" else 2)


def _fixed(values: Array) -> bytes:
    return np.rint(np.ravel(values) * 65536).astype(">i4").tobytes()


def _description(text: str) -> bytes:
    return b"desc\0\0\0\0" + struct.pack(">I", len(text) + 1) + text.encode() + b"\0" * 80


def _classic(kind: str, table: Array, exponent: float, *, forwards: bool) -> bytes:
    """lut8Type or lut16Type."""
    n = len(table)
    top, form, steps = (255, ">u1", 256) if kind == "lut8" else (65535, ">u2", 1024)
    head = (b"mft1" if kind == "lut8" else b"mft2") + struct.pack(">I4B", 0, 3, 3, n, 0) + _fixed(np.eye(3))
    if kind == "lut16":
        head += struct.pack(">HH", steps, steps)
    line = np.linspace(0.0, 1.0, steps)
    parts = [np.tile(line**exponent, 3), np.ravel(table), np.tile(line, 3)]
    numbers = b"".join(np.rint(top * np.clip(part, 0.0, 1.0)).astype(form).tobytes() for part in parts)
    return head + numbers


def _modern(_kind: str, table: Array, exponent: float, *, forwards: bool) -> bytes:
    """lutAToBType or lutBToAType: curves, table, curves, matrix (here none moves anything), curves."""
    line = b"curv\0\0\0\0" + struct.pack(">I", 0)
    power = b"para\0\0\0\0" + struct.pack(">HH", 0, 0) + _fixed(np.array([exponent]))
    a_curves = (power if forwards else line) * 3
    b_curves = (line if forwards else power) * 3
    matrix = _fixed(np.eye(3)) + _fixed(np.zeros(3))
    clut = bytes([len(table)] * 3) + bytes(13) + b"\2\0\0\0"
    clut += np.rint(65535 * np.clip(table, 0.0, 1.0)).astype(">u2").tobytes()
    parts, places, at = b"", [], 32
    for part in (b_curves, matrix, line * 3, clut, a_curves):
        places.append(at)
        padded = part + b"\0" * (-len(part) % 4)
        parts += padded
        at += len(padded)
    return (
        (b"mAB " if forwards else b"mBA ")
        + struct.pack(">I2BH", 0, 3, 3, 0)
        + struct.pack(">5I", *places)
        + parts
    )


def assemble(tags: dict[bytes, bytes], space: str, version: int, kind: bytes = b"mntr") -> bytes:
    at = 132 + 12 * len(tags)
    index, data = b"", b""
    for name, content in tags.items():
        index += name + struct.pack(">II", at + len(data), len(content))
        data += content + b"\0" * (-len(content) % 4)
    kinds = (kind, b"RGB ", space.encode().ljust(4))
    header = struct.pack(">I4sBBH4s4s4s", at + len(data), b"none", version, 0x20, 0, *kinds)
    header += bytes(12) + b"acsp" + bytes(28) + _fixed(WHITE)
    return header.ljust(128, b"\0") + struct.pack(">I", len(tags)) + index + data
