"""Draw docs/images/prefiltered.png: an environment and its maps for every lobe of the default basis.

    python packaging/plots/prefiltered.py [ENVIRONMENT]

Needs matplotlib (the dev dependencies). Like Figure 5 of the paper: what each lobe sees of the light.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
from matplotlib import pyplot as plt

from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import prefilter
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.pipeline.scene import load_environment

TARGET = Path(__file__).resolve().parents[2] / "docs" / "images" / "prefiltered.png"
ROWS = 110
SHARP = "the environment"
TO_709 = np.array([[1.6605, -0.5876, -0.0728], [-0.1246, 1.1329, -0.0083], [-0.0182, -0.1006, 1.1187]])


def unrolled(packed: FaceArray) -> np.ndarray:
    """Return a cube map as a lat-long picture (ROWS, 2·ROWS, 3), radiance: the nearest texels, averaged 3×3."""
    fine = 3 * ROWS
    wanted = direction(ring_angles(fine)[:, None], column_angles(2 * fine)[None, :])
    axis = np.abs(wanted).argmax(axis=-1)
    major = np.take_along_axis(wanted, axis[..., None], -1)[..., 0]
    face = 2 * axis + (major < 0.0)
    x, y, z = wanted[..., 0], wanted[..., 1], wanted[..., 2]
    s = np.choose(face, [-z, z, x, x, x, -x]) / np.abs(major)
    t = np.choose(face, [-y, -y, z, -z, -y, -y]) / np.abs(major)
    i, j = (np.clip((0.5 * (v + 1.0) * packed.size).astype(int), 0, packed.size - 1) for v in (s, t))
    return packed.radiance()[face, j, i].reshape(ROWS, 3, 2 * ROWS, 3, 3).mean(axis=(1, 3))


def shown(radiance: np.ndarray, exposure: float) -> np.ndarray:
    """Return display values 0…1: a filmic shoulder and the sRGB curve, the same for all pictures."""
    linear = np.maximum(radiance * exposure @ TO_709.T, 0.0)
    linear = linear / (1.0 + linear)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def main(name: str) -> None:
    """Filter, lay out and save."""
    prepared = load_environment(name)
    maps = prefilter(prepared.environment, default_basis().exponents)
    tiles = [(SHARP, unrolled(maps.background)), ("diffuse, n = 1", unrolled(maps.diffuse))]
    for exponent, item in zip(maps.exponents, maps.lobes, strict=True):
        digits = 1 if exponent < 100.0 else 0
        if item is maps.background:
            # Lobes sharper than this environment's texels read the environment itself: the first of them is named.
            if tiles[0][0] == SHARP:
                tiles[0] = (f"{SHARP}, n = {exponent:,.{digits}f} and above", tiles[0][1])
        elif item is not maps.diffuse:
            tiles.append((f"n = {exponent:,.{digits}f}, faces of {item.size}²", unrolled(item)))
    exposure = 1.0 / float(np.mean(tiles[1][1]))
    columns = 5
    rows = -(-len(tiles) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(2.5 * columns, 1.5 * rows))
    for place, axis in enumerate(np.ravel(axes)):
        axis.axis("off")
        if place < len(tiles):
            title, picture = tiles[place]
            axis.imshow(shown(picture, exposure))
            axis.set_title(title, fontsize=8)
    figure.tight_layout(pad=0.6)
    figure.savefig(TARGET, dpi=80)
    print(f"{TARGET}: {TARGET.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "sunny")
