"""Scene to picture file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.documents.view import Camera, View
from brdf_suite.output.still import render_to_file

pytestmark = pytest.mark.usefixtures("shared_cache")


@pytest.mark.parametrize("azimuth", [35.0, 200.0])
def test_the_object_fills_the_picture_and_stands_in_its_middle(tmp_path: Path, azimuth: float) -> None:
    size = (320, 180)
    view = View(Camera(azimuth_deg=azimuth, elevation_deg=20.0), surface="speed_form", background="grey")
    out = tmp_path / "out.png"
    picture = render_to_file("solid_black", view, size, out)
    assert (picture.width, picture.height, picture.surface) == (*size, "speed_form")
    with Image.open(out) as image:
        codes = np.asarray(image.convert("RGB"), int)
    seen = np.abs(codes - codes[0, 0]).max(axis=-1) > 6
    places = [np.flatnonzero(seen.any(axis=axis)) for axis in (0, 1)]
    extents = [place[-1] - place[0] + 1 for place in places]
    for place, whole in zip(places, size, strict=True):
        assert abs((place[0] + place[-1]) / 2 - (whole - 1) / 2) <= 1.5
    assert max(extent / whole for extent, whole in zip(extents, size, strict=True)) == pytest.approx(
        1 / 1.18, abs=0.03
    )
