"""Draw docs/images/texture_readings.png: what the texture instrument's camera sees of three paints.

    python packaging/pictures/texture_readings.py [folder]

Rows: fine silver, blue, coarse silver. Columns: directed light from 15, 45 and 75°, diffuse light. Luminance over the
mean of the picture, which is a mid grey, on 10 × 10 mm.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from brdf_suite.appearance.texture import LIGHTS_DEG, PIXEL_MM, grain, speckle
from brdf_suite.files.images.png import write_png
from brdf_suite.inspection.texture.camera import grain_picture, sparkle_picture
from brdf_suite.inspection.texture.readings import paint_light
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material

PAINTS = ("fine_silver", "blue", "coarse_silver")
SIDE = round(10.0 / PIXEL_MM)
MEAN = 0.2
GAP = 4


def main() -> int:
    """Write the picture."""
    folder = (
        Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "docs" / "images"
    )
    rows = []
    for name in PAINTS:
        material = load_material(name)
        assert material.flakes is not None, name
        light = paint_light(fit_material(material).weights)
        seen = [speckle(light, material.flakes, angle) for angle in LIGHTS_DEG]
        pictures = [(one.share, sparkle_picture(one, np.random.default_rng(1))) for one in seen]
        diffuse = grain(light, material.flakes)
        pictures.append((diffuse.share, grain_picture(diffuse, np.random.default_rng(1))))
        tiles = []
        for share, picture in pictures:
            light_seen = MEAN * (1.0 + share * (picture[:SIDE, :SIDE] - 1.0))
            tiles += [np.clip(light_seen, 0.0, 1.0) ** (1.0 / 2.2), np.ones((SIDE, GAP))]
        rows += [np.concatenate(tiles[:-1], axis=1), np.ones((GAP, 4 * SIDE + 3 * GAP))]
    grey = np.rint(255.0 * np.concatenate(rows[:-1])).astype(np.uint8)
    path = folder / "texture_readings.png"
    write_png(path, np.ascontiguousarray(np.repeat(grey[..., None], 3, axis=-1)), {"Title": "Texture"})
    print(f"{path.name}: {path.stat().st_size / 1024:,.0f} KiB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
