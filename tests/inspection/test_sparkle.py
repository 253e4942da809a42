"""Our own sparkle figure, against flakes that are strewn and counted, and against those that the Viewer draws."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.flakes.footprint import flake_footprint
from brdf_suite.appearance.flakes.glints import spots
from brdf_suite.appearance.flakes.tilt import flake_slope, tilt_place
from brdf_suite.documents.paint import Flakes
from brdf_suite.inspection.sparkle import ANGLES_DEG, CROWDED, sparkle
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint
from tools.evaluation.flake_model import glint_field, glint_ratio

ROUGHNESS = 0.16
SLOPE = flake_slope([-0.7071, 0.0, 0.7071], [0.5, 0.0, 0.866], 1.5)


def peaks(image: np.ndarray, contrast: float) -> np.ndarray:
    """Return the values of the places that are higher than the contrast and than all eight beside them."""
    inner = image[1:-1, 1:-1]
    rows, columns = image.shape
    beside = [
        image[1 + i : rows - 1 + i, 1 + j : columns - 1 + j]
        for i in (-1, 0, 1)
        for j in (-1, 0, 1)
        if (i, j) != (0, 0)
    ]
    return inner[(inner > contrast) & np.all([inner > other for other in beside], axis=0)]


def test_the_closed_form_counts_flakes_that_are_strewn_one_by_one() -> None:
    density, size, share, spread, pixel, contrast, side = 120.0, 0.02, 0.15, 0.01, 0.145, 0.5, 40.0
    _, stretch = tilt_place(SLOPE, ROUGHNESS)
    per_square = 4.0 / np.pi * density
    reach2 = 8.0 * (float(stretch) * spread) ** 2
    rng = np.random.default_rng(7)
    # Only flakes that mirror any light to the eye: v = d² / 8σ² is even on 0 to 1 among them.
    count = rng.poisson(per_square * np.pi * reach2 * side**2)
    at, bell = rng.uniform(0.0, side, (count, 2)), (1.0 - rng.uniform(size=count)) ** 2
    area = 3.0 * rng.uniform(size=count) ** 2
    step = pixel / 5.0
    cells = round(side / step)
    image = np.zeros((cells, cells))
    reach = math.ceil(3.0 * pixel / step)
    offsets = np.arange(-reach, reach + 1)
    for (x, y), weight in zip(at, bell * area, strict=True):
        i, j = round(x / step), round(y / step)
        rows, columns = (i + offsets), (j + offsets)
        inside = np.ix_((rows >= 0) & (rows < cells), (columns >= 0) & (columns < cells))
        dx, dy = np.meshgrid(rows * step - x, columns * step - y, indexing="ij")
        footprint = flake_footprint(
            np.zeros((dx.size, 2)),
            np.tile([pixel, 0.0], (dx.size, 1)),
            np.tile([0.0, pixel], (dx.size, 1)),
            size,
        )
        stamp = footprint.cover(dx.ravel(), dy.ravel()).reshape(dx.shape)
        rows, columns = rows[(rows >= 0) & (rows < cells)], columns[(columns >= 0) & (columns < cells)]
        image[np.ix_(rows, columns)] += weight * stamp[inside]
    image *= share * 3.0 / (np.pi * reach2 * per_square)
    assert image.mean() == pytest.approx(share, rel=0.1), "the mean of all flakes is what they send"
    found = spots(
        density=density,
        size=size,
        stretch=float(stretch),
        spread=spread,
        share=share,
        footprint=pixel,
        contrast=contrast,
    )
    found_peaks = peaks(image, contrast)
    assert len(found_peaks) / side**2 == pytest.approx(found.per_mm2, rel=0.12)
    assert found_peaks.mean() == pytest.approx(found.mean_contrast, rel=0.12)
    assert 0.0 < found.per_footprint < CROWDED


def test_the_viewers_own_flakes_are_counted_alike_from_near() -> None:
    density, size, share, spread, pixel = 120.0, 0.02, 0.02, 0.01, 0.05
    side = 700
    along = np.arange(side) * (pixel / 2.0)
    at = np.stack([grid.ravel() for grid in np.meshgrid(along, along)], axis=-1)
    across, down = np.tile([pixel, 0.0], (len(at), 1)), np.tile([0.0, pixel], (len(at), 1))
    field = glint_field(at, across, down, density=density, size=size, roughness=ROUGHNESS, waviness=spread)
    place, stretch = tilt_place(SLOPE, ROUGHNESS)
    ratio = glint_ratio(field, np.broadcast_to(place, at.shape), np.full(len(at), stretch), spread)[:, 0]
    found_peaks = peaks((share * (ratio - 1.0)).reshape(side, side), 0.5)
    found = spots(
        density=density,
        size=size,
        stretch=float(stretch),
        spread=spread,
        share=share,
        footprint=pixel,
        contrast=0.5,
    )
    # Some 220 spots; a flake's peak lies between the places where it is drawn.
    assert len(found_peaks) / (side * pixel / 2.0) ** 2 == pytest.approx(found.per_mm2, rel=0.2)
    assert found_peaks.mean() == pytest.approx(found.mean_contrast, rel=0.25)


def test_spots_follow_the_flakes() -> None:
    fitter = PaintFitter(time_limit_s=60.0)
    paint = load_shipped_paint("blue")
    weights = fitter.fit(paint).weights
    fitter.close()
    flakes = paint.flakes
    assert flakes is not None
    near, face, far = sparkle(weights, flakes)
    assert [row.aspecular_deg for row in (near, face, far)] == list(ANGLES_DEG)
    assert near.spots_per_mm2 > face.spots_per_mm2 > far.spots_per_mm2 > 0.0
    coarse = sparkle(weights, replace(flakes, size_um=40.0, density_per_mm2=27.5))[0]
    assert coarse.mean_contrast > near.mean_contrast
    none = sparkle(weights, None)
    assert all(row.spots_per_mm2 == 0.0 and not row.crowded for row in none)
    crowded = sparkle(weights, Flakes(100_000.0, 40.0, 0.17))
    assert all(math.isfinite(row.mean_contrast) for row in crowded)
    assert sparkle(weights, Flakes(0.0))[0].spots_per_mm2 == 0.0


def test_a_higher_contrast_has_fewer_spots_and_all_of_them_pass_it() -> None:
    fields = {
        "density": 100.0,
        "size": 0.02,
        "stretch": 2.0,
        "spread": 0.01,
        "share": 0.2,
        "footprint": 0.145,
    }
    counts = []
    for contrast in (0.1, 0.5, 2.0, 1e6):
        found = spots(contrast=contrast, **fields)
        counts.append(found.per_mm2)
        assert found.mean_contrast == 0.0 or found.mean_contrast > contrast
    assert counts == sorted(counts, reverse=True)
    assert counts[-1] == 0.0
