"""The generated car: what it consists of, its proportions, its skin, and that it is closed."""

from __future__ import annotations

import pickle
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from filelock import FileLock
from meshes.car import car
from meshes.car.body import body
from meshes.car.proportions import FRONT_AXLE_Z, REAR_AXLE_Z, WHEEL_RADIUS
from meshes.car.shell import GAP

from brdf_suite.arrays import Floats
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.resources import resource
from brdf_suite.surface.mesh import Mesh, PartGeometry


@pytest.fixture(scope="module")
def mesh(cache_folder: Path) -> Mesh:
    """The car as the code makes it now: once a run for all workers, since that takes many seconds."""
    folder = cache_folder / "tests"
    folder.mkdir(exist_ok=True)
    made = folder / "car.pickle"
    with FileLock(f"{made}.lock"):
        if not made.exists():
            made.write_bytes(pickle.dumps(car()))
        return pickle.loads(made.read_bytes())


def part(mesh: Mesh, name: str) -> PartGeometry:
    (found,) = [each for each in mesh.parts if each.name == name]
    return found


def corners(each: PartGeometry) -> Floats:
    """Return (k, 3, 3) corner positions."""
    return each.positions.astype(np.float64)[each.triangles]


def facings(each: PartGeometry) -> tuple[Floats, Floats]:
    """Return unit face normals (k, 3) and areas (k,)."""
    a, b, c = (corners(each)[:, i] for i in range(3))
    facing = np.cross(b - a, c - a)
    length = np.linalg.norm(facing, axis=1)
    return facing / length[:, None], 0.5 * length


def test_has_the_parts_of_a_car_in_their_materials(mesh: Mesh) -> None:
    materials = {each.name: each.material for each in mesh.parts}
    for name in (
        *(
            "roof",
            "a_pillar",
            "c_pillar",
            "front_wing",
            "rear_wing",
            "sill_panel",
            "bonnet",
            "door",
            "handle",
        ),
        *("tailgate", "front_bumper", "rear_bumper", "mirror_housings"),
    ):
        assert materials[name] == "paint"
    for name in ("windscreen", "side_window", "rear_screen"):
        assert materials[name] == "glass"
    for name in ("headlamp_lens", "tail_panel_lens", "projector_lenses"):
        assert materials[name] == "lens"
    assert materials["shut_lines"] == "gap"
    assert materials["rims"] == materials["projector_cups"] == "chrome"
    assert materials["tyres"] == "rubber"
    assert (materials["daylight"], materials["tail_band"]) == ("lamp", "tail_lamp")
    for name in ("wheel_wells", "underbody", "grille", "intake"):
        assert materials[name] == "cavity"  # no ambient occlusion darkens what the sky does not reach
    for name in (
        *(
            "sill",
            "splitter",
            "diffuser",
            "cowl",
            "grille_mesh",
            "intake_fins",
            "headlamp_housing",
            "reveals",
        ),
        *(
            "lining",
            "carpet",
            "dashboard",
            "console",
            "seats",
            "rear_seats",
            "parcel_shelf",
            "steering_wheel",
        ),
    ):
        assert materials[name] == "trim"
    assert set(materials.values()) == {
        "paint",
        "glass",
        "lens",
        "gap",
        "rubber",
        "chrome",
        "lamp",
        "tail_lamp",
        "trim",
        "cavity",
    }


def test_proportions(mesh: Mesh) -> None:
    low, high = mesh.bounds()
    width, height, length = high - low
    assert low[1] == pytest.approx(0.0, abs=1e-5)
    assert 4.35 < length < 4.65
    assert 1.26 < height < 1.38
    assert 1.98 < width < 2.18  # over the mirrors
    bounds = np.array([part(mesh, name).bounds() for name in ("front_wing", "rear_wing", "roof")])
    body_low, body_high = bounds[:, 0].min(axis=0), bounds[:, 1].max(axis=0)
    assert 1.82 < body_high[0] - body_low[0] < 1.92
    assert 2.7 < FRONT_AXLE_Z - REAR_AXLE_Z < 2.8
    assert 1.8 < height / (2 * WHEEL_RADIUS) < 2.1
    # The paint, and not the mirrors or plastic, is most of what one sees.
    area = {each.name: facings(each)[1].sum() for each in mesh.parts}
    paint = sum(area[each.name] for each in mesh.parts if each.material == "paint")
    assert 8.0 < paint < 16.0


def test_wheels_stand_on_the_ground_flush_with_the_body(mesh: Mesh) -> None:
    tyres = part(mesh, "tyres").positions.astype(np.float64)
    for axle in (FRONT_AXLE_Z, REAR_AXLE_Z):
        wheel = tyres[(np.abs(tyres[:, 2] - axle) < 0.5) & (tyres[:, 0] > 0)]
        assert wheel[:, 1].min() == pytest.approx(0.0, abs=1e-5)
        assert wheel[:, 2].mean() == pytest.approx(axle, abs=1e-3)
        wing = "front_wing" if axle == FRONT_AXLE_Z else "rear_wing"
        body = part(mesh, wing).positions.astype(np.float64)
        lip = body[(np.abs(body[:, 2] - axle) < 0.1) & (body[:, 1] > 0.65) & (body[:, 1] < 0.76)]
        assert -0.010 < lip[:, 0].max() - wheel[:, 0].max() < 0.035


def test_size_suits_interactive_viewing(mesh: Mesh) -> None:
    assert 100_000 < mesh.triangle_count < 200_000
    assert all(len(each.positions) < 65_535 for each in mesh.parts)


def test_is_symmetric(mesh: Mesh) -> None:
    for each in mesh.parts:
        if each.name == "steering_wheel":
            assert each.positions[:, 0].min() > 0.0  # on the left
            continue
        own = np.unique(np.round(each.positions.astype(np.float64), 6), axis=0)
        other = np.unique(np.round(each.positions.astype(np.float64) * [-1.0, 1.0, 1.0], 6) + 0.0, axis=0)
        assert np.array_equal(own + 0.0, other), each.name


def test_no_triangle_is_degenerate(mesh: Mesh) -> None:
    for each in mesh.parts:
        assert facings(each)[1].min() > 5e-11, each.name


def test_normals_agree_with_faces(mesh: Mesh) -> None:
    for each in mesh.parts:
        facing, area = facings(each)
        agreement = np.einsum("ij,ikj->ik", facing, each.normals[each.triangles].astype(np.float64)).mean(
            axis=1
        )
        assert area[agreement <= 0.0].sum() < 1e-5 * area.sum() + 5e-5, each.name
        if each.material == "paint":
            assert np.average(agreement, weights=area) > 0.97, each.name


def test_paint_is_smooth(mesh: Mesh) -> None:
    """Neighbouring points of a panel have nearly the same normal, save on creases and turned-in edges."""
    for name in ("bonnet", "tailgate", "door", "front_wing", "rear_wing", "roof"):
        each = part(mesh, name)
        n = each.normals.astype(np.float64)[each.triangles]
        _, area = facings(each)
        bend = np.degrees(np.arccos(np.clip(np.einsum("kj,kj->k", n[:, 0], n[:, 1]), -1, 1)))
        assert np.average(bend > 15.0, weights=area) < 0.05, name


def test_paint_uvs_are_millimetres(mesh: Mesh) -> None:
    for each in mesh.parts:
        if each.material != "paint":
            continue
        uv = each.uvs.astype(np.float64)[each.triangles]
        one, two = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
        flat = 0.5 * np.abs(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]) * 1e-6
        _, area = facings(each)
        # Pillars lean to all three axes.
        assert (0.74 if each.name.endswith("pillar") else 0.8) < flat.sum() / area.sum() <= 1.0, each.name
        assert np.average(flat / area < 0.5, weights=area) < 0.02, each.name


def test_tyres_have_a_tread_and_walls(mesh: Mesh) -> None:
    tyres = part(mesh, "tyres").positions.astype(np.float64)
    wheel = tyres[(tyres[:, 2] > 0.0) & (tyres[:, 0] > 0.0)]
    radius = np.hypot(wheel[:, 1] - WHEEL_RADIUS, wheel[:, 2] - FRONT_AXLE_Z)
    inwards = wheel[:, 0].max() - wheel[:, 0]
    # Four grooves go round, apart from each other.
    deep = (radius > WHEEL_RADIUS - 0.009) & (radius < WHEEL_RADIUS - 0.0065)
    grooves = inwards[deep & (inwards > 0.052) & (inwards < 0.2)]
    assert len(np.unique(np.round(grooves, 3))) == 4
    # Slots between the blocks of the shoulder: half of its points lie deeper.
    shoulder = radius[(inwards > 0.032) & (inwards < 0.034)]
    assert 0.3 < (shoulder < WHEEL_RADIUS - 0.006).mean() < 0.7
    # The wall is no plane: a guard stands out beside the rim, a ring is cut in.
    wall = inwards[(radius > 0.265) & (radius < 0.31)]
    assert wall.max() - wall.min() > 0.003


def test_lamps_are_deep_behind_their_lenses(mesh: Mesh) -> None:
    for lens, behind, least in (
        ("headlamp_lens", "daylight", 0.010),
        ("headlamp_lens", "headlamp_housing", 0.030),
        ("tail_panel_lens", "tail_band", 0.008),
        ("tail_panel_lens", "tail_panel_housing", 0.025),
    ):
        front, back = (part(mesh, name).positions.astype(np.float64) for name in (lens, behind))
        away = np.linalg.norm(back[::4, None] - front[None], axis=2).min(axis=1)
        assert np.quantile(away, 0.75) > least, behind


def test_gaps_say_how_far_across_they_are(mesh: Mesh) -> None:
    gaps = part(mesh, "shut_lines")
    across = gaps.uvs[:, 0].astype(np.float64)
    assert np.abs(across).max() == pytest.approx(500.0 * GAP, rel=0.05)
    triangle = across[gaps.triangles]
    _, area = facings(gaps)
    # Most of its triangles reach from edge to edge; the rest are where gaps meet.
    wide = (triangle.max(axis=1) > 400.0 * GAP) & (triangle.min(axis=1) < -400.0 * GAP)
    assert area[wide].sum() > 0.7 * area.sum()


def test_windows_show_the_interior_and_not_the_paint_from_inside(mesh: Mesh) -> None:
    panes = [corners(each) for each in mesh.parts if each.material == "glass"]
    opaque = [each for each in mesh.parts if each.material not in ("glass", "lens")]
    painted = np.concatenate([np.full(len(each.triangles), each.material == "paint") for each in opaque])
    triangles = np.concatenate([corners(each) for each in opaque])
    for one, _, direction in rays():
        distance, _ = first_hits(np.concatenate(panes), one, direction)
        glazed = one[np.isfinite(distance)]
        if not len(glazed):
            continue
        start = glazed + (distance[np.isfinite(distance)][:, None] + 0.02) * direction
        inside, _ = first_hits(triangles, start, direction)
        to_paint, cosine = first_hits(triangles[painted], start, direction)
        from_inside = np.isfinite(inside) & (to_paint <= inside) & (cosine > 0.0)
        assert from_inside.mean() < 0.02, f"along {direction}"


def test_the_shipped_car_is_this_one_so_it_is_the_same_every_time(mesh: Mesh) -> None:
    shipped = read_mesh(resource("meshes", "car.glb"))
    assert [each.name for each in shipped.parts] == [each.name for each in mesh.parts]
    for one, two in zip(mesh.parts, shipped.parts, strict=True):
        assert np.array_equal(one.triangles, two.triangles)
        # Another processor rounds the last bit differently.
        np.testing.assert_allclose(two.positions, one.positions, rtol=0.0, atol=1e-6)
        np.testing.assert_allclose(two.normals, one.normals, rtol=0.0, atol=1e-4)
        np.testing.assert_allclose(two.uvs, one.uvs, rtol=0.0, atol=1e-2)


def rays() -> Iterator[tuple[Floats, Floats, Floats]]:
    """Return bundles of lines: (n, 3) ends outside on either side, and the direction (3,) from the first ones."""
    along = np.linspace(-2.0, 1.9, 60)
    up = np.linspace(0.20, 1.15, 24)
    across = np.linspace(-0.8, 0.8, 40)
    z, y = (grid.ravel() for grid in np.meshgrid(along, up))
    ends = (np.stack([np.full_like(z, x), y, z], axis=1) for x in (3.0, -3.0))
    yield *ends, np.array([-1.0, 0.0, 0.0])
    z, x = (grid.ravel() for grid in np.meshgrid(along, across))
    ends = (np.stack([x, np.full_like(x, y), z], axis=1) for y in (3.0, -1.0))
    yield *ends, np.array([0.0, -1.0, 0.0])
    y, x = (grid.ravel() for grid in np.meshgrid(up, across))
    ends = (np.stack([x, y, np.full_like(x, z)], axis=1) for z in (4.0, -4.0))
    yield *ends, np.array([0.0, 0.0, -1.0])


def first_hits(triangles: Floats, origins: Floats, direction: Floats) -> tuple[Floats, Floats]:
    """Return distance (inf where nothing is hit) and the cosine of the first face with the ray, by rasterizing."""
    axis = int(np.argmax(np.abs(direction)))
    others = [k for k in range(3) if k != axis]
    flat = triangles[:, :, others]
    low, high = flat.min(axis=1), flat.max(axis=1)
    facing = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    distance, cosine = np.full(len(origins), np.inf), np.zeros(len(origins))
    for value in np.unique(origins[:, others[0]]):  # the rays of a plane share the triangles that cross it
        plane = np.flatnonzero((low[:, 0] <= value) & (high[:, 0] >= value))
        for number in np.flatnonzero(origins[:, others[0]] == value):
            origin = origins[number]
            point = origin[others]
            near = plane[(low[plane, 1] <= point[1]) & (high[plane, 1] >= point[1])]
            a, b, c = (flat[near, i] for i in range(3))
            area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
            safe = np.where(np.abs(area) < 1e-14, 1.0, area)
            v = ((point - a)[:, 0] * (c - a)[:, 1] - (point - a)[:, 1] * (c - a)[:, 0]) / safe
            w = ((b - a)[:, 0] * (point - a)[:, 1] - (b - a)[:, 1] * (point - a)[:, 0]) / safe
            hit = (np.abs(area) >= 1e-14) & (v >= 0) & (w >= 0) & (v + w <= 1)
            if not hit.any():
                continue
            own = near[hit]
            depth = triangles[own, :, axis]
            at = depth[:, 0] + v[hit] * (depth[:, 1] - depth[:, 0]) + w[hit] * (depth[:, 2] - depth[:, 0])
            along = (at - origin[axis]) * direction[axis]
            along[along < 0.0] = np.inf
            first = int(np.argmin(along))
            if np.isinf(along[first]):
                continue
            distance[number] = along[first]
            cosine[number] = facing[own[first], axis] * direction[axis]
    return distance, cosine


def meets_body(origins: Floats, direction: Floats) -> np.ndarray:
    """Return which of a few lines (n, 3) run deeper than 5 mm in the body; few, so that they stay in the cache."""
    steps = np.linspace(0.0, 8.0, 801)
    # A coordinate that stays is (n, 1): what depends on such alone is computed once a line.
    x, y, z = (origins[:, [k]] + (steps * direction[k] if direction[k] else 0.0) for k in range(3))
    return np.asarray(body(x, y, z).min(axis=1) < -0.005)


def test_nothing_is_seen_through_the_body(mesh: Mesh) -> None:
    """Every ray through the solid that the body is made from hits something, from its outside first."""
    triangles = np.concatenate([corners(each) for each in mesh.parts])
    for one, other, direction in rays():
        solid = np.concatenate([meets_body(ends, direction) for ends in np.array_split(one, len(one) // 10)])
        assert solid.mean() > 0.5
        for origins, along in ((one, direction), (other, -direction)):
            distance, cosine = first_hits(triangles, origins, along)
            assert np.isfinite(distance[solid]).all(), f"along {along}"
            assert (cosine[solid] > 0.0).mean() < 0.004, f"along {along}"
