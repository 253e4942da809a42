"""Sphere and light from photographs of a simulated rig that is out of line."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.acquisition.geometry.lens import lens_rays
from brdf_suite.acquisition.geometry.refinement.refinement import (
    Refinement,
    calibrate_geometry,
    format_movement_notice,
    refine,
)
from brdf_suite.acquisition.geometry.sphere.edge import PhotographUnion
from brdf_suite.acquisition.geometry.sphere.highlight import Highlight, find_highlight
from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline, find_outline
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, nominal_geometry, unit
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.errors import AcquisitionError
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

_SIDE = 144
_ANGLES = tuple(float(angle) for angle in range(0, 176, 12))
_PAINT = CookTorrance(TABLE_1["table1_polaris_silver"])


class Rig:
    """A simulated rig with its photographs; the lamp's zero is off by 0.5°, the sphere by 2 pixels and -1."""

    def __init__(
        self, moved: tuple[int, float, float] | None = None, before: Sequence[np.ndarray] = ()
    ) -> None:
        settings = SimulatorSettings(
            size=(_SIDE, _SIDE),
            angles_deg=_ANGLES,
            board=False,
            white=False,
            light_offset_deg=0.5,
            centre_offset_px=(2.0, -1.0),
            light_height_m=0.07,
            moved=moved,
        )
        self.simulator = Simulator(_PAINT, settings)
        self.stated = nominal_geometry(self.simulator.session, (_SIDE, _SIDE))
        # What is known already need not be simulated again.
        self.radiance = [*before, *(self.simulator.radiance(k) for k in range(len(before), len(_ANGLES)))]
        self.union = PhotographUnion((_SIDE, _SIDE))
        for k, angle in enumerate(_ANGLES):
            if 40.0 <= angle <= 150.0:
                self.union.add(k, self.radiance[k])

    def in_camera(self, place: object) -> np.ndarray:
        x, y, z = np.array(place)
        return np.array((x, -y, self.stated.centre_m[2] - z))

    @property
    def centre(self) -> np.ndarray:
        return self.in_camera(self.simulator.truth["sphere_centres_m"][0])

    @property
    def pixel_m(self) -> float:
        """How far the sphere moves for one pixel."""
        return self.stated.centre_m[2] / self.stated.lens.fx

    def find(self, geometry: RigGeometry) -> list[Highlight]:
        found = (find_highlight(picture, geometry, k) for k, picture in enumerate(self.radiance))
        return [highlight for highlight in found if highlight is not None]


@pytest.fixture(scope="module")
def rig() -> Rig:
    return Rig()


@pytest.fixture(scope="module")
def outline(rig: Rig) -> SphereOutline:
    return find_outline(rig.union, rig.stated)


@pytest.fixture(scope="module")
def refinement(rig: Rig, outline: SphereOutline) -> Refinement:
    return calibrate_geometry(outline, rig.find)


def test_the_outline_gives_the_centre_to_a_fraction_of_a_pixel(rig: Rig, outline: SphereOutline) -> None:
    off = (np.array(outline.centre_m) - rig.centre) / rig.pixel_m
    assert np.linalg.norm(off[:2]) < 0.15
    # The distance is that of the sphere's size in the picture: a tenth of a pixel of 61 in radius.
    assert abs(np.linalg.norm(outline.centre_m) / np.linalg.norm(rig.centre) - 1.0) < 0.003
    assert outline.rms_px < 0.1
    assert np.count_nonzero(outline.used) > 12


def test_an_unknown_lens_takes_its_focal_length_from_the_outline(rig: Rig) -> None:
    lens = replace(rig.stated.lens, fx=rig.stated.lens.fx * 1.4, fy=rig.stated.lens.fy * 1.4)
    outline = find_outline(rig.union, replace(rig.stated, lens=lens, lens_known=False))
    assert outline.geometry.lens.fx == pytest.approx(rig.stated.lens.fx, rel=0.004)


def test_arm_and_stand_in_the_picture_do_not_move_the_outline(rig: Rig, outline: SphereOutline) -> None:
    union = PhotographUnion((_SIDE, _SIDE))
    for k in rig.union.positions:
        picture = rig.radiance[k].copy()
        bright = float(np.median(picture[picture > 0.0]))
        picture[118:, 55:92] = bright  # the stand below
        picture[96:106, 100:] = 0.6 * bright  # an arm from the right
        union.add(k, picture)
    found = find_outline(union, rig.stated)
    shift = (np.array(found.centre_m) - outline.centre_m) / rig.pixel_m
    assert np.linalg.norm(shift[:2]) < 0.15
    masked = np.ones((_SIDE, _SIDE), bool)
    masked[90:] = False
    assert np.all(find_outline(rig.union, rig.stated, masked).points[:, 1] < 90.0)


def test_no_sphere_is_reported(rig: Rig) -> None:
    empty = PhotographUnion((_SIDE, _SIDE))
    empty.add(5, np.zeros((_SIDE, _SIDE, 3)))
    with pytest.raises(AcquisitionError, match="No sphere"):
        find_outline(empty, rig.stated)
    noise = PhotographUnion((_SIDE, _SIDE))
    noise.add(5, np.random.default_rng(0).uniform(0.0, 1.0, (_SIDE, _SIDE, 3)))
    with pytest.raises(AcquisitionError, match="sphere"):
        find_outline(noise, rig.stated)


def test_highlights_are_found_to_a_tenth_of_a_pixel(rig: Rig, outline: SphereOutline) -> None:
    true = replace(
        rig.stated,
        centre_m=tuple(rig.centre),
        axis_offset_m=tuple(np.array(rig.simulator.truth["sphere_centres_m"][0])[[0, 2]]),
        angle_offset_deg=0.5,
        # The sphere stands a pixel higher than the axis point that the light's height counts from.
        light_height_m=0.07 - rig.pixel_m,
    )
    found = rig.find(outline.geometry)
    assert len(found) >= 9
    expected = true.highlights([_ANGLES[row.position] for row in found])
    off = np.linalg.norm(np.array([row.pixel for row in found]) - expected, axis=-1)
    assert np.median(off) < 0.1
    assert off.max() < 0.3
    assert all(0.0 < row.sigma_px < 1.0 for row in found)


def test_the_refined_light_stands_where_it_does(rig: Rig, refinement: Refinement) -> None:
    geometry = refinement.geometry
    assert np.linalg.norm((geometry.centre - rig.centre)[:2]) / rig.pixel_m < 0.15
    lights = np.array([rig.in_camera(rig.simulator.lamp(k).place) for k in range(len(_ANGLES))])
    ways = unit(geometry.light(_ANGLES) - geometry.centre)
    off = np.degrees(np.linalg.norm(ways - unit(lights - rig.centre), axis=-1))
    assert off.max() < 0.2
    assert refinement.rms_px < 0.1 < 0.2 < refinement.before_px
    assert refinement.rms_deg < 0.2 < 0.4 < refinement.before_deg
    assert refinement.movements == ()
    assert format_movement_notice(refinement, []) == ""


def test_each_number_says_how_far_it_was_observed(refinement: Refinement) -> None:
    rows = {row.name: row for row in refinement.parameters}
    assert rows["turntable's zero"].observed > 0.9
    assert rows["light's height"].observed > 0.9
    # Parallax between points of the sphere is all that determines the distance.
    assert rows["light's distance"].observed < 0.5
    assert all(0.0 <= row.observed <= 1.0 and row.sigma <= row.stated_sigma * 1.0001 for row in rows.values())
    assert all(row.why for row in rows.values())


def test_a_masked_or_missing_highlight_is_none(rig: Rig, outline: SphereOutline) -> None:
    hidden = np.zeros((_SIDE, _SIDE), bool)
    assert find_highlight(rig.radiance[4], outline.geometry, 4, hidden) is None
    assert find_highlight(np.zeros((_SIDE, _SIDE, 3)), outline.geometry, 4) is None
    with pytest.raises(AcquisitionError, match="needs 4"):
        refine(outline.geometry, outline, rig.find(outline.geometry)[:3])


def test_a_clipped_highlight_keeps_its_place(rig: Rig, outline: SphereOutline) -> None:
    whole = find_highlight(rig.radiance[4], outline.geometry, 4)
    clipped = np.minimum(rig.radiance[4], 0.4 * rig.radiance[4].max())
    found = find_highlight(clipped, outline.geometry, 4)
    assert whole is not None
    assert found is not None
    assert np.linalg.norm(np.subtract(found.pixel, whole.pixel)) < 0.15


def test_a_clipped_broad_highlight_does_not_lean_from_the_outline() -> None:
    angles = (94.0, 101.0, 108.0, 115.0, 120.0)
    settings = SimulatorSettings(size=(_SIDE, _SIDE), angles_deg=angles, board=False, white=False)
    simulator = Simulator(CookTorrance(TABLE_1["table1_blue_matte"]), settings)
    stated = nominal_geometry(simulator.session, (_SIDE, _SIDE))
    masked: list[float] = []
    unmasked: list[float] = []
    for k, expected in enumerate(stated.highlights(angles)):
        picture = simulator.radiance(k).mean(axis=-1)
        x, y = np.round(expected).astype(int)
        top = 0.4 * float(picture[y - 3 : y + 4, x - 3 : x + 4].max())
        cut = np.minimum(picture, top)
        for found, clipped in ((masked, picture > top), (unmasked, None)):
            highlight = find_highlight(cut, stated, k, None, clipped)
            assert highlight is not None
            found.append(highlight.pixel[0] - expected[0])
    # Of a clipped pixel the cosine alone is left, which falls towards the outline.
    assert np.mean(unmasked) < -0.03
    assert abs(np.mean(masked)) < 0.6 * abs(np.mean(unmasked))


def _narrow_spot(geometry: RigGeometry, k: int) -> np.ndarray:
    """A clear coat's peak, 0.7° wide, on an even lobe of a fiftieth of it; pixels are means over their squares."""
    parts, near = 12, 16
    column, row = np.round(geometry.highlights(_ANGLES[k])).astype(int) - near
    normal = geometry.highlight_normals(geometry.light(_ANGLES[k]))[0]
    fine = (np.arange(2 * near * parts) + 0.5) / parts - 0.5
    rays = lens_rays(geometry.lens, np.stack(np.meshgrid(column + fine, row + fine), axis=-1))
    along = rays @ geometry.centre
    rest = along * along - (geometry.centre @ geometry.centre - geometry.radius_m**2)
    normals = unit((along - np.sqrt(np.maximum(rest, 0.0)))[..., None] * rays - geometry.centre)
    cosine = np.maximum(-np.einsum("...i,...i", normals, rays), 1e-3)
    peak = np.exp(-(((normals - normal) ** 2).sum(axis=-1)) / 0.012**2)
    value = np.where(rest > 0.0, (peak + 0.02) / cosine, 0.0)
    picture = np.zeros((_SIDE + 2 * near, _SIDE + 2 * near))
    window = value.reshape(2 * near, parts, 2 * near, parts).mean(axis=(1, 3))
    picture[row : row + 2 * near, column : column + 2 * near] = window
    return picture[:_SIDE, :_SIDE]


def test_next_to_the_outline_a_highlight_says_how_little_it_knows(rig: Rig, outline: SphereOutline) -> None:
    geometry = replace(rig.stated, light_height_m=0.0)
    sigma = []
    for angle in (60.0, 132.0):
        k = _ANGLES.index(angle)
        spot = find_highlight(_narrow_spot(geometry, k), geometry, k)
        assert spot is not None
        off = np.linalg.norm(spot.pixel - geometry.highlights(angle))
        assert off < 2.0 * spot.sigma_px
        sigma.append(spot.sigma_px)
    assert sigma[1] > 2.0 * sigma[0]

    rows = rig.find(outline.geometry)
    without = refine(outline.geometry, outline, rows)
    k = _ANGLES.index(132.0)
    ((x, y),) = without.geometry.highlights([_ANGLES[k]])
    rest = [row for row in rows if row.position != k]
    found = refine(outline.geometry, outline, [*rest, Highlight(k, (x + 0.25, y), 0.3, 1.0, 6)])
    assert not found.outliers.any()
    # A quarter of a pixel is much of a degree there; the others say how well the light is known.
    assert found.residuals_deg[found.positions == k][0] > 0.6
    assert found.rms_deg < without.rms_deg + 0.05
    assert found.rms_px < without.rms_px + 0.02


def test_a_highlight_in_a_wrong_place_is_named_and_left_out(
    rig: Rig, outline: SphereOutline, refinement: Refinement
) -> None:
    rows = rig.find(outline.geometry)
    x, y = rows[4].pixel
    rows[4] = replace(rows[4], pixel=(x + 3.0, y - 2.0))
    found = refine(outline.geometry, outline, rows)
    assert found.positions[found.outliers].tolist() == [rows[4].position]
    shift = np.degrees(
        np.linalg.norm(
            unit(found.geometry.light(_ANGLES) - found.geometry.centre)
            - unit(refinement.geometry.light(_ANGLES) - refinement.geometry.centre),
            axis=-1,
        )
    )
    assert shift.max() < 0.2


def test_a_sphere_that_moves_is_named_with_its_position(rig: Rig) -> None:
    rig = Rig((6, 1.5, 0.5), rig.radiance[:6])
    outline = find_outline(rig.union, rig.stated)
    found = calibrate_geometry(outline, rig.find)
    assert len(found.movements) == 1
    movement = found.movements[0]
    assert (movement.before, movement.after) == (5, 6)
    np.testing.assert_allclose(movement.pixels, (1.5, 0.5), atol=0.5)
    names = [f"p{k:03d}_00.png" for k in range(len(_ANGLES))]
    sentence = format_movement_notice(found, names)
    assert "p005_00.png" in sentence
    assert "p006_00.png" in sentence
    kept = set(range(len(_ANGLES))) - set(found.moved_positions)
    assert kept in (set(range(6)), set(range(6, len(_ANGLES))))
