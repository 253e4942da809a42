"""How exact prefiltered maps are: against a brute-force sum, under constant light, beside a sun, as looked up.

``python tests/benchmarks/parts/prefilter_accuracy.py FILE…`` prints the errors of the filter
(docs/method/prefilter.md) for environments, and without a file that of look-ups.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

import numpy as np

from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.harmonics import lobe_bandlimit
from brdf_suite.lighting.filter.lobe_filter import LobeFilter
from brdf_suite.lighting.filter.lobe_maps import face_size
from brdf_suite.lighting.filter.texel_values import pack_lobe
from brdf_suite.lighting.latlong import angles, column_angles, direction, fejer_weights, ring_angles

ERROR_EXPONENTS = (5.0, 20.0, 80.0, 320.0, 1280.0, 5120.0)
DIRECTIONS = 340  # for each exponent: 2,040 in all
LOCAL_DIRECTIONS = 60
WORST_EXPONENTS = (108.0, 1742.0)  # just below those that get the next larger faces
LOOK_UP_EXPONENTS = (1.0, 5.0, 20.0, *WORST_EXPONENTS, 5120.0, 10673.0)
SHARP = ((50_000.0, 1024), (116_000.0, 2048))
"""Exponents whose maps are held to 2,048 texels, each with the rings of a map that they are filtered from."""

PLACES = (
    (0.0, 0.0, 1.0),
    (1.0, 0.0, 1.0),
    (1.0, 0.7, 1.0),
    (-1.0, -1.0, 0.9),
    (1.0, 1.0, 1.0),
    (-0.95, 0.97, -1.0),
    (0.0, 1.0, 0.02),
)
SHARP_PLACES = (PLACES[0], PLACES[2], PLACES[4], PLACES[6])


def double_sum(radiance: np.ndarray, wanted: np.ndarray, exponent: float) -> np.ndarray:
    """Return the defining integral along wanted (n, 3) as a sum over all texels, float64.

    P_E(R) = (E+1)/(2π) · Σ_texels L · max(0, R·ω)^E · weight,   weight = Fejér ring weight × longitude step
    """
    height, width = radiance.shape[:2]
    towards = direction(ring_angles(height)[:, None], column_angles(width)[None, :]).reshape(-1, 3)
    weights = np.repeat(fejer_weights(height) * (2.0 * np.pi / width), width)
    flux = radiance.reshape(-1, 3).astype(np.float64) * weights[:, None]
    total = np.zeros((len(wanted), 3))
    for start in range(0, len(flux), 4096):  # a block of texels at a time, only to bound the memory
        texels = slice(start, start + 4096)
        # cosδ ** exponent by way of the logarithm: numpy's own power is ten times as slow.
        cosine = np.maximum(wanted @ towards[texels].T, 1e-200)
        total += np.exp(np.maximum(exponent * np.log(cosine), -700.0)) @ flux[texels]
    return total * (exponent + 1.0) / (2.0 * np.pi)


def errors(
    radiance: np.ndarray, exponents: Sequence[float], count: int = DIRECTIONS
) -> dict[float, np.ndarray]:
    """Return, for each exponent, errors (n, 3) of the unpacked map over its largest value: at random texels and
    the brightest.
    """
    lobe_filter = LobeFilter(radiance)
    rng = np.random.default_rng(3)
    found = {}
    for exponent in exponents:
        size = face_size(exponent)
        got = lobe_filter.lobe(exponent, size)
        brightest = np.unravel_index(got.max(axis=3).argmax(), got.shape[:3])
        at = tuple(np.vstack([rng.integers(0, [6, size, size], size=(count, 3)), brightest]).T)
        truth = double_sum(radiance, texel_directions(size)[at], exponent)
        found[exponent] = (got[at] - truth) / got.max()
    return found


def usable(lobe_filter: LobeFilter, exponents: Sequence[float]) -> list[float]:
    """Return the exponents, 1 among them, that the map can be filtered with."""
    return sorted({1.0, *(e for e in exponents if e <= lobe_filter.largest_exponent)})


def constant_deviation(exponents: Sequence[float], rings: int = 512) -> float:
    """Return the largest deviation from 1 of maps of light that is 1 everywhere."""
    lobe_filter = LobeFilter(np.ones((rings, 2 * rings, 3), dtype=np.float32))
    maps = [lobe_filter.lobe(e, face_size(e)) for e in usable(lobe_filter, exponents)]
    return max(float(np.abs(item - 1.0).max()) for item in (*maps, lobe_filter.background(rings)))


def beside_a_sun(exponents: Sequence[float]) -> tuple[float, int]:
    """Return the largest error over the value there, and how many values are negative, with a one-texel sun
    10⁵ times as bright as the sky of 1.
    """
    radiance = np.ones((512, 1024, 3), dtype=np.float32)
    radiance[140, 400] = 1e5
    lobe_filter = LobeFilter(radiance)
    rng = np.random.default_rng(4)
    worst, negatives = 0.0, 0
    sun = direction(ring_angles(512)[140], column_angles(1024)[400])
    for exponent in usable(lobe_filter, exponents):
        size = face_size(exponent)
        got = lobe_filter.lobe(exponent, size)
        negatives += int((got < 0.0).sum())
        places = texel_directions(size)
        # Random texels, and as many where the lobe about the sun falls to the sky's own value.
        near = np.argwhere((places @ sun) > 1e-8 ** (1.0 / exponent))
        near = near[rng.integers(0, len(near), LOCAL_DIRECTIONS)]
        anywhere = rng.integers(0, [6, size, size], size=(LOCAL_DIRECTIONS, 3))
        at = tuple(np.vstack([anywhere, near]).T)
        truth = double_sum(radiance, places[at], exponent)
        worst = max(worst, float((np.abs(got[at] - truth) / truth).max()))
    return worst, negatives


def look_up(packed: FaceArray, wanted: np.ndarray) -> np.ndarray:
    """Return radiance (n, 3) as OpenGL samples a seamless cube map along wanted (n, 3): bilinear on the face of the
    major axis, texels beyond an edge from the next face, those beyond a corner the mean of the three.
    """
    size = packed.size
    faces = packed.radiance()
    padded = np.empty((6, size + 2, size + 2, faces.shape[3]), dtype=np.float64)
    padded[:, 1:-1, 1:-1] = faces
    line = (2.0 * np.arange(size) + 1.0) / size - 1.0
    out = np.full(size, 1.0 + 1e-9)
    for face in range(6):
        for edge, s, t in (
            ((0, slice(1, -1)), line, -out),
            ((-1, slice(1, -1)), line, out),
            ((slice(1, -1), 0), -out, line),
            ((slice(1, -1), -1), out, line),
        ):
            there, i, j = _place(_direction(np.full(size, face), s, t), size)
            padded[(face, *edge)] = faces[
                there,
                np.clip(np.rint(j), 0, size - 1).astype(int),
                np.clip(np.rint(i), 0, size - 1).astype(int),
            ]
        for j, i in ((0, 0), (0, -1), (-1, 0), (-1, -1)):
            inner = padded[face, 1 if j == 0 else -2, 1 if i == 0 else -2]
            beside = padded[face, j, 1 if i == 0 else -2] + padded[face, 1 if j == 0 else -2, i]
            padded[face, j, i] = (inner + beside) / 3.0
    face, i, j = _place(wanted, size)
    i, j = i + 1.0, j + 1.0
    i_0, j_0 = np.floor(i).astype(int), np.floor(j).astype(int)
    u, v = (i - i_0)[:, None], (j - j_0)[:, None]
    above = padded[face, j_0, i_0] * (1.0 - u) + padded[face, j_0, i_0 + 1] * u
    below = padded[face, j_0 + 1, i_0] * (1.0 - u) + padded[face, j_0 + 1, i_0 + 1] * u
    return above * (1.0 - v) + below * v


def _direction(face: np.ndarray, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Return directions of face coordinates (OpenGL 3.3, table 3.19 read backwards)."""
    one = np.ones_like(s)
    table = [(one, -t, -s), (-one, -t, s), (s, one, t), (s, -one, -t), (s, -t, one), (-s, -t, -one)]
    return np.stack([np.choose(face, [row[axis] for row in table]) for axis in range(3)], axis=-1)


def _place(wanted: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return face, column and row (in texels, 0 at the first centre) of directions."""
    x, y, z = wanted.T
    axis = np.abs(wanted).argmax(axis=1)
    major = np.take_along_axis(wanted, axis[:, None], 1)[:, 0]
    face = 2 * axis + (major < 0.0)
    s = np.choose(face, [-z, z, x, x, x, -x]) / np.abs(major)
    t = np.choose(face, [-y, -y, z, -z, -y, -y]) / np.abs(major)
    return face, 0.5 * (s + 1.0) * size - 0.5, 0.5 * (t + 1.0) * size - 0.5


def look_up_error(
    exponents: Sequence[float], rings: int = 512, places: Sequence[tuple[float, float, float]] = PLACES
) -> dict[float, float]:
    """Return, for each exponent, the largest error over the lobe's peak of packed maps of one-texel lights (in the
    middle of a face, along an edge, by a corner and by a pole), looked up at random directions about each, a third
    of them on an edge of the cube where one is near.
    """
    rng = np.random.default_rng(5)
    found: dict[float, float] = {}
    theta, phi = ring_angles(rings), column_angles(2 * rings)
    for place in places:
        polar, around = angles(np.array(place))
        row, column = int(np.abs(theta - polar).argmin()), int(np.abs(phi - around).argmin())
        radiance = np.zeros((rings, 2 * rings, 3), dtype=np.float32)
        radiance[row, column] = 1.0
        sun = direction(theta[row], phi[column])
        flux = fejer_weights(rings)[row] * np.pi / rings
        lobe_filter = LobeFilter(radiance)
        lobe_filter.analyse(max(lobe_bandlimit(e) for e in usable(lobe_filter, exponents)))
        for exponent in usable(lobe_filter, exponents):
            packed = pack_lobe(lobe_filter.lobe(exponent, face_size(exponent)))
            one_channel = FaceArray(packed.faces[..., :1], packed.scale)  # all three are equal, and large
            wanted = sun + rng.normal(scale=min(1.0, exponent**-0.5), size=(20_000, 3))
            share = wanted[: len(wanted) // 3]
            largest = np.abs(share).max(axis=1, keepdims=True)
            share[:] = np.where(np.abs(share) > 0.93 * largest, np.copysign(largest, share), share)
            wanted /= np.linalg.norm(wanted, axis=1, keepdims=True)
            peak = flux * (exponent + 1.0) / (2.0 * np.pi)
            truth = peak * np.maximum(wanted @ sun, 0.0) ** exponent
            error = float(np.abs(look_up(one_channel, wanted)[:, 0] - truth).max() / peak)
            found[exponent] = max(found.get(exponent, 0.0), error)
    return found


def sharp_look_up_error(exponent: float, rings: int) -> float:
    """Return the error of :func:`look_up_error` for one sharp lobe, at four of the places."""
    return look_up_error([exponent], rings, SHARP_PLACES)[exponent]


def print_look_ups() -> None:
    """Print a row for each exponent: its map's size and what look-ups of it err by."""
    print("| n | face | map | error of the lobe's peak |")
    print("|---|---|---|---|")
    rows = [(exponent, 512, error) for exponent, error in look_up_error(LOOK_UP_EXPONENTS).items()]
    rows += [(exponent, rings, sharp_look_up_error(exponent, rings)) for exponent, rings in SHARP]
    for exponent, rings, error in rows:
        print(
            f"| {exponent:,.0f} | {face_size(exponent)} | {2 * rings}×{rings} | {100.0 * error:.2f} % |",
            flush=True,
        )


def main(files: Sequence[str]) -> None:
    """Print a row for each environment file: largest errors over the map's largest value; without one, look-ups."""
    if not files:
        print_look_ups()
        return
    from pathlib import Path

    from brdf_suite.files.images.environments import read_environment_image

    print("| map | size | n = 1 | n = 5 … 5,120 | RMS | constant light |")
    print("|---|---|---|---|---|---|")
    for name in files:
        radiance = read_environment_image(name).pixels
        height, width = radiance.shape[:2]
        sharpest = LobeFilter(radiance).largest_exponent
        found = errors(radiance, [1.0, *(e for e in ERROR_EXPONENTS if e <= sharpest)])
        diffuse = np.abs(found.pop(1.0)).max()
        rest = np.concatenate([item.ravel() for item in found.values()])
        deviation = constant_deviation(ERROR_EXPONENTS, height)
        print(
            f"| {Path(name).name} | {width}×{height} | {diffuse:.1e} | {np.abs(rest).max():.1e} | "
            f"{np.sqrt(np.mean(rest**2)):.1e} | {deviation:.1e} |",
            flush=True,
        )


if __name__ == "__main__":
    main(sys.argv[1:])
