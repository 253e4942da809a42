"""Draw what docs/method/environments.md shows: skies of three models, and studios, as maps.

python packaging/pictures/light.py [--output docs/images/environments.png]
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.studio import Sky
from brdf_suite.files.images.png import write_png
from brdf_suite.lighting.procedural import BOOTH, ProceduralEnvironment, sky, studio
from brdf_suite.lighting.procedural.studio import EXAMPLE
from brdf_suite.realtime.pictures.tone_curves import to_display

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
_GAP = 6

SKIES = (
    (Sky("clear", "hosek_wilkie", 2.5, 40.0), Sky("clear", "preetham", 2.5, 40.0)),
    (Sky("hazy", "hosek_wilkie", 6.0, 12.0), Sky("hazy", "preetham", 6.0, 12.0)),
)
"""Left Hošek-Wilkie, right Preetham; above turbidity 2.5 and a sun at 40°, below 6 and 12°."""


def tile(made: ProceduralEnvironment, exposure_ev: float) -> NDArray[np.uint8]:
    """Return a map as it is shown, with a white edge."""
    picture = np.asarray(to_display(made.radiance, exposure_ev), np.uint8)
    return np.pad(picture, ((_GAP, 0), (_GAP, 0), (0, 0)), constant_values=255)


def main() -> int:
    """Write the picture."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=IMAGES / "environments.png")
    output = parser.parse_args().output
    rows = [[tile(sky(one, 160), -0.7) for one in pair] for pair in SKIES]
    rows.append([tile(studio(one, 160), -1.0) for one in (BOOTH, EXAMPLE)])
    picture = np.concatenate([np.concatenate(row, axis=1) for row in rows])
    write_png(output, np.ascontiguousarray(picture), {"Title": "Skies and studios from a description"})
    print(f"{output.name}: {output.stat().st_size / 1024:,.0f} KiB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
