"""Baked occlusion against cases whose answer is known in closed form."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from meshes.forms.sphere import sphere

from brdf_suite.arrays import AnyArray
from brdf_suite.errors import Cancelled
from brdf_suite.geometry.low_harmonics import low_harmonics
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.occlusion import floor as floor_baking
from brdf_suite.surface.occlusion.bake import bake
from brdf_suite.surface.occlusion.floor import open_floor
from brdf_suite.surface.occlusion.rays import BakedMesh, BakedPart, RayScene


def quad(name: str, corners: list[tuple[float, float, float]]) -> PartGeometry:
    """A square of two triangles, seen from the side from which its corners run counter-clockwise."""
    points = np.array(corners, float)
    normal = np.cross(points[1] - points[0], points[2] - points[0])
    normal /= np.linalg.norm(normal)
    uvs = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    return PartGeometry(
        name, "neutral", points, np.tile(normal, (4, 1)), uvs, np.array([[0, 1, 2], [0, 2, 3]])
    )


def level(name: str, height: float, half: float) -> PartGeometry:
    h = half
    return quad(name, [(-h, height, h), (h, height, h), (h, height, -h), (-h, height, -h)])


def at(part: BakedPart, points: AnyArray) -> AnyArray:
    """The interpolated light (m, 8 or 16) at points that lie on the part."""
    corners = part.positions[part.triangles].astype(float)
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    u, v = b - a, c - a
    uu, uv, vv = (u * u).sum(1), (u * v).sum(1), (v * v).sum(1)
    determinant = uu * vv - uv * uv
    result = np.empty((len(points), part.light.shape[1]))
    for row, point in enumerate(points):
        w = point - a
        wu, wv = (w * u).sum(1), (w * v).sum(1)
        s, t = (wu * vv - wv * uv) / determinant, (wv * uu - wu * uv) / determinant
        off = np.abs(np.einsum("ij,ij->i", w, np.cross(u, v))) / np.sqrt(determinant)
        inside = (s > -1e-6) & (t > -1e-6) & (s + t < 1 + 1e-6) & (off < 1e-4)
        k = int(np.flatnonzero(inside)[0])
        weights = np.array([1 - s[k] - t[k], s[k], t[k]])
        result[row] = weights @ part.light[part.triangles[k]].astype(float)
    return result


def share(part: BakedPart, points: AnyArray, *, floor: bool = False) -> AnyArray:
    return at(part, points)[:, 7 if floor else 3]


@pytest.fixture
def coarse_floor(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bake a floor of few texels, where it is not looked at."""
    monkeypatch.setattr(floor_baking, "_LONG_SIDE", 24)


@pytest.fixture(scope="module")
def ball_on_a_sheet() -> BakedMesh:
    ball = sphere()
    low, high = ball.bounds()
    radius = float(high[1] - low[1]) / 2
    sheet = level("sheet", float(low[1]) - 1e-4 * radius, 20.0 * radius)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(floor_baking, "_LONG_SIDE", 24)  # the sheet hides the floor
        return bake(Mesh("ball", (*ball.parts, sheet)))


@pytest.fixture(scope="module")
def ball_alone() -> BakedMesh:
    return bake(sphere())


def test_a_sheet_under_a_ball(ball_on_a_sheet: BakedMesh) -> None:
    # The form factor of a ball wholly above the horizon: cos(theta) (R/d)^2 = (R/d)^3 where it touches the sheet.
    ball, sheet = ball_on_a_sheet.parts
    radius = float(ball.positions[:, 1].max() - ball.positions[:, 1].min()) / 2
    height = sheet.positions[0, 1]
    for away in (0.5, 1.0, 1.5, 2.0, 3.0):
        around = np.linspace(0, 2 * np.pi, 12, endpoint=False)
        points = np.stack(
            [away * radius * np.cos(around), np.full(12, height), away * radius * np.sin(around)], axis=1
        )
        wanted = 1.0 - (1.0 + away**2) ** -1.5
        assert share(sheet, points).mean() == pytest.approx(wanted, abs=0.06), away


def test_both_sides_of_a_sheet_see_what_is_before_them(coarse_floor: None) -> None:
    """A sheet that looks down, with a ball on its back; and a ball, a solid, which has no back."""
    ball = sphere()
    low, high = ball.bounds()
    radius = float(high[1] - low[1]) / 2
    sheet = level("sheet", float(low[1]) - 1e-4 * radius, 20.0 * radius)
    down = replace(sheet, normals=-sheet.normals, triangles=sheet.triangles[:, ::-1])
    solid, both = bake(Mesh("ball", (*ball.parts, down))).parts
    assert solid.light.shape[1] == 8
    assert both.light.shape[1] == 16
    for away in (1.0, 2.0):
        points = np.array(
            [[away * radius, sheet.positions[0, 1], 0.0], [0.0, sheet.positions[0, 1], away * radius]]
        )
        front, back = at(both, points)[:, 3], at(both, points)[:, 11]
        assert front.mean() == pytest.approx(1.0, abs=0.03)
        assert back.mean() == pytest.approx(1.0 - (1.0 + away**2) ** -1.5, abs=0.06)
        assert (at(both, points)[:, [1, 9]] * [-1.0, 1.0] > 0.3).all()


def test_a_ball_over_a_sheet_and_its_bent_normal(ball_on_a_sheet: BakedMesh) -> None:
    # Tilted by theta, a place sees (1 + cos theta) / 2 of the sky over an endless sheet. The mean direction of that
    # light, from the projected areas of a half sphere cut by a plane:
    ball = ball_on_a_sheet.parts[0]
    centre = (ball.positions.max(axis=0) + ball.positions.min(axis=0)) / 2
    normals = (ball.positions - centre) / np.linalg.norm(ball.positions - centre, axis=1, keepdims=True)
    free = normals[:, 1] > -0.8
    wanted = (1.0 + normals[:, 1]) / 2
    error = ball.light[:, 3].astype(float) - wanted
    assert np.abs(error[free]).max() < 0.1
    assert error[free].std() < 0.02
    assert 0.0 < error[free].mean() < 0.03  # the sheet ends after twenty radii, and light comes from below it
    # The hemisphere's light of direction w adds w cos / pi; over the open half-space that is numbers known by a sum.
    rng = np.random.default_rng(1)
    w = rng.normal(size=(200_000, 3))
    w /= np.linalg.norm(w, axis=1, keepdims=True)
    w = w[w[:, 1] > 0]
    for k in np.flatnonzero(free)[:: len(normals) // 40]:
        cosine = np.maximum(w @ normals[k], 0.0)
        mean = 2.0 * (w * cosine[:, None]).mean(axis=0)  # 2 pi / pi times the mean over the upper half
        assert ball.light[k, :3] == pytest.approx(mean, abs=0.04)


def test_an_open_place_sees_everything(ball_alone: BakedMesh) -> None:
    ball = ball_alone
    light = ball.parts[0].light.astype(float)
    assert light[:, 3] == pytest.approx(1.0, abs=0.015)
    np.testing.assert_allclose(light[:, :3], ball.parts[0].normals * 2 / 3, atol=0.03)


@pytest.mark.usefixtures("coarse_floor")
def test_the_bottom_of_an_open_box() -> None:
    # A square opening parallel to a place under its middle, X = Y = half width / depth = 1/2:
    # F = 4 * 1/(2 pi) * (X/sqrt(1+X^2) atan(Y/sqrt(1+X^2)) + the same with X and Y changed).
    h = 0.5
    bottom = level("bottom", 0.0, h)
    walls = [
        quad("front", [(-h, 1, h), (h, 1, h), (h, 0, h), (-h, 0, h)]),
        quad("back", [(-h, 0, -h), (h, 0, -h), (h, 1, -h), (-h, 1, -h)]),
        quad("left", [(-h, 0, h), (-h, 0, -h), (-h, 1, -h), (-h, 1, h)]),
        quad("right", [(h, 1, h), (h, 1, -h), (h, 0, -h), (h, 0, h)]),
    ]
    baked = bake(Mesh("box", (bottom, *walls)))
    x = 0.5
    root = np.sqrt(1 + x * x)
    wanted = 4 / (2 * np.pi) * 2 * x / root * np.arctan(x / root)
    assert share(baked.parts[0], np.array([[0.0, 0.0, 0.0]]))[0] == pytest.approx(wanted, abs=0.015)
    # Two triangles could not show that the corners are darker than the middle: the bottom was cut.
    assert len(baked.parts[0].triangles) > 50
    corner = share(baked.parts[0], np.array([[0.45, 0.0, 0.45], [-0.45, 0.0, 0.45]]))
    assert corner == pytest.approx(_corner_of_the_box(), abs=0.03)
    # A wall's middle sees light through the opening only, and its mean direction leans up.
    wall = at(baked.parts[4], np.array([[0.5, 0.5, 0.0]]))[0]
    assert wall[1] > 0.0 > wall[0]


def _corner_of_the_box() -> float:
    """The share of the opening at (.45, 0, .45), by a sum over the opening."""
    n = 400
    x, z = np.meshgrid((np.arange(n) + 0.5) / n - 0.5, (np.arange(n) + 0.5) / n - 0.5)
    squared = (x - 0.45) ** 2 + (z - 0.45) ** 2 + 1.0
    return float((1.0 / squared**2).sum() / n**2 / np.pi)


@pytest.mark.usefixtures("coarse_floor")
def test_light_does_not_bleed_along_triangles_that_reach_into_a_body() -> None:
    # A long sheet runs through a closed box; what is outside of it stays bright up to the box.
    box = _closed_box(0.2)
    sheet = level("sheet", 0.1, 1.0)
    baked = bake(Mesh("pierced", (box, sheet)))
    away = np.array([[0.3, 0.1, 0.0], [0.5, 0.1, 0.0], [0.9, 0.1, 0.0]])
    # Beside a wall of height 0.1 at the distance 0.1: 1 - (1 - cos(45 deg)) / 2 for a long one.
    found = share(baked.parts[1], away)
    assert found[0] > 1 - (1 - np.cos(np.pi / 4)) / 2 - 0.06
    assert (found[1:] > 0.95).all()


def _closed_box(half: float) -> PartGeometry:
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float) * half
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    positions, normals, triangles = [], [], []
    for number, face in enumerate(faces):
        points = corners[list(face)]
        positions.append(points)
        outwards = points.mean(axis=0) / np.linalg.norm(points.mean(axis=0))
        normals.append(np.tile(outwards, (4, 1)))
        triangles += [
            [4 * number, 4 * number + 1, 4 * number + 2],
            [4 * number, 4 * number + 2, 4 * number + 3],
        ]
    points = np.concatenate(positions)
    return PartGeometry("box", "paint", points, np.concatenate(normals), points[:, :2], np.array(triangles))


def test_the_floor_under_a_ball(ball_on_a_sheet: BakedMesh, ball_alone: BakedMesh) -> None:
    baked = ball_alone
    ground = baked.ground
    rows, columns = ground.share.shape
    x = ground.low[0] + (np.arange(columns) + 0.5) / columns * (ground.high[0] - ground.low[0])
    z = ground.low[1] + (np.arange(rows) + 0.5) / rows * (ground.high[1] - ground.low[1])
    radius = float(np.ptp(baked.parts[0].positions[:, 1])) / 2
    away = np.hypot(x, z[:, None]) / radius
    wanted = 1 - (1 + away**2) ** -1.5
    inner = (away > 0.3) & (away < 1.5)
    assert np.abs(ground.share - wanted)[inner].max() < 0.06
    assert np.abs((ground.share - wanted)[inner].mean()) < 0.01
    # At the edge it is an open floor, so that no edge is seen.
    np.testing.assert_allclose(ground.transfer[0], np.broadcast_to(open_floor(6), (columns, 49)), atol=0.01)
    # And the ball sees the darkened floor: less light than alone, more than over a black sheet.
    ball, black = baked.parts[0].light.astype(float), ball_on_a_sheet.parts[0].light.astype(float)
    down = (baked.parts[0].normals[:, 1] < -0.3) & (baked.parts[0].normals[:, 1] > -0.8)
    assert (ball[down, 7] < ball[down, 3] - 0.02).all()
    assert (ball[down, 7] > black[: len(ball)][down, 3] + 0.02).all()


def test_the_shadow_falls_away_from_the_light(ball_alone: BakedMesh) -> None:
    ground = ball_alone.ground
    # A light from +x at 45 degrees, as harmonics; the floor left of the ball is darker than the one right of it.
    towards = np.array([np.sqrt(0.5), np.sqrt(0.5), 0.0])
    light = low_harmonics(towards, 6)
    lit = ground.transfer @ light / (open_floor(6) @ light)
    rows, columns = lit.shape
    middle = lit[rows // 2]
    offset = columns // 8
    assert middle[columns // 2 - offset] < middle[columns // 2 + offset] - 0.2


def test_the_same_mesh_gives_the_same_numbers(ball_alone: BakedMesh) -> None:
    one, other = ball_alone, bake(sphere())
    assert np.array_equal(one.parts[0].light, other.parts[0].light)
    assert np.array_equal(one.ground.transfer, other.ground.transfer)


def test_rays_hit_what_a_search_over_all_triangles_hits() -> None:
    rng = np.random.default_rng(0)
    corners = rng.uniform(-1, 1, (300, 1, 3)) + rng.normal(0, 0.15, (300, 3, 3))
    points = rng.uniform(-1.5, 1.5, (200, 3)).astype(np.float32)
    directions = rng.normal(size=(20, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    found = RayScene(corners).leaves(points, directions, np.zeros(200))
    a, b, c = np.moveaxis(corners, 1, 0)
    for k, d in enumerate(directions):
        p = np.cross(d, c - a)
        det = ((b - a) * p).sum(1)
        s = points[:, None] - a
        u = (s * p).sum(2) / det
        q = np.cross(s, b - a)
        v = (q @ d) / det
        t = (q * (c - a)).sum(2) / det
        margin = 1e-4  # rays within rounding of an edge may go either way
        hit = ((u > margin) & (v > margin) & (u + v < 1 - margin) & (t > margin)).any(axis=1)
        near = ((u > -margin) & (v > -margin) & (u + v < 1 + margin) & (t > -margin)).any(axis=1)
        assert (found[hit, k] == 0).all()
        assert (found[~near, k] == 255).all()


@pytest.mark.usefixtures("coarse_floor")
def test_one_triangle() -> None:
    part = PartGeometry(
        "facet", "paint", np.eye(3), np.full((3, 3), 3**-0.5), np.zeros((3, 2)), np.array([[0, 1, 2]])
    )
    light = bake(Mesh("facet", (part,))).parts[0].light
    # It is cut for the sake of its back, which sees the floor.
    assert light[:, 3] == pytest.approx(1.0, abs=3e-3)


@pytest.mark.usefixtures("coarse_floor")
def test_a_cancel_is_heard() -> None:
    reported: list[tuple[float, str]] = []

    def progress(fraction: float, what: str) -> None:
        reported.append((fraction, what))
        if fraction > 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        bake(sphere(), progress)
    fractions = [fraction for fraction, _ in reported]
    assert fractions == sorted(fractions)
    assert fractions[-1] < 0.9
    assert len(fractions) > 5
