"""Draw docs/images/glare.png: a black ball in the sun and a coarse silver from near, without glare and with it.

    python packaging/pictures/glare.py [folder]

Rendered off screen with the programs' own renderer, in a packaged environment, at a fixed size.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.documents.view import Camera, View
from brdf_suite.files.images.png import write_png
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment, load_surface

SIZE = (480, 300)
SEEN = (
    ("solid_black", View(Camera(35.0, 12.0), "booth", exposure_mode="automatic")),
    ("coarse_silver", View(Camera(50.0, 36.0, 0.17, (0.0, 0.1, 0.0)), "booth", exposure_ev=-3.0)),
)


def main() -> int:
    """Write the picture."""
    folder = (
        Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "docs" / "images"
    )
    rows = []
    with OffscreenScene() as scene:
        scene.set_surface(load_surface("sphere"))
        scene.set_environment(load_environment("sunny"))
        for paint, view in SEEN:
            view = replace(view, environment="sunny", surface="sphere")
            scene.set_material(fit_material(load_material(paint)), view=view)
            row = [scene.image(replace(view, glare=glare), SIZE) for glare in ("off", "eye")]
            rows.append(np.concatenate(row, axis=1))
    path = folder / "glare.png"
    write_png(path, np.ascontiguousarray(np.concatenate(rows)), {"Title": "Without glare, and with it"})
    print(f"{path.name}: {path.stat().st_size / 1024:,.0f} KiB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
