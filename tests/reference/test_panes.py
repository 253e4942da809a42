"""What is seen through: panes mirror, hide and pass by the same shares in all three renderers."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import TRANSMITTANCE, Lamp, SurfaceLook
from brdf_suite.files.images.environments import write_exr
from brdf_suite.geometry.fresnel import sheet_reflectance
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import Material
from brdf_suite.realtime.camera import Bounds, matrices
from brdf_suite.reference.variant import Variant
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.tracing.raytraced.picture import Quality, RaytracedSession
from brdf_suite.tracing.reference.scene import build_reference

SIZE = (48, 32)
GLASS = TRANSMITTANCE["glass"]


def board(name: str, material: str, x: tuple[float, float], z: float) -> PartGeometry:
    corners = np.array([[x[0], -1, z], [x[1], -1, z], [x[1], 1, z], [x[0], 1, z]], float)
    facing = np.tile([0.0, 0.0, 1.0], (4, 1))
    return PartGeometry(name, material, corners, facing, 1e3 * corners[:, :2], [[0, 1, 2], [0, 2, 3]])


def glazed() -> Mesh:
    """Two sheets one behind the other, and on the left a board behind both."""
    parts = board("board", "paint", (-1.0, 0.0), -0.2), board("rear", "glass", (-1.0, 1.0), -0.1)
    return Mesh("glazed", (*parts, board("front", "glass", (-1.0, 1.0), 0.1)))


def even(value: float = 1.0) -> Environment:
    return Environment("even", np.full((8, 16, 3), value, np.float32))


def places(view: View, mesh: Mesh, *points: tuple[float, float, float]) -> list[tuple[int, int]]:
    """Row and column at which points are seen."""
    m = matrices(view.camera, Bounds.of(p.positions for p in mesh.parts), SIZE)
    found = []
    for point in points:
        a, b, c = (np.array(point) - m.eye) @ m.view_to_world
        column = (a / -c / m.half_tangents[0] + 1.0) * SIZE[0] / 2
        found.append((int((1.0 - b / -c / m.half_tangents[1]) * SIZE[1] / 2), int(column)))
    return found


def expected(
    view: View, mesh: Mesh, point: tuple[float, float, float], crossings: int
) -> tuple[float, float]:
    """Radiance of two sheets in light of 1 with nothing behind, and what they hide.

    What the second sheet mirrors has crossed the first so many times.
    """
    eye = matrices(view.camera, Bounds.of(p.positions for p in mesh.parts), SIZE).eye
    away = eye - np.array(point)
    mirrored = float(sheet_reflectance(abs(away[2]) / np.linalg.norm(away), 1.52))
    passed = GLASS * (1.0 - mirrored)
    return mirrored + passed**crossings * mirrored, 1.0 - passed**2


@pytest.mark.parametrize("azimuth", [0.0, 40.0, 180.0])
def test_two_sheets_mirror_and_pass_in_real_time(tmp_path, azimuth: float) -> None:
    from brdf_suite.pipeline.picture import OffscreenScene
    from brdf_suite.pipeline.scene import load_environment

    mesh = glazed()
    view = View(camera=Camera(azimuth, 0.0), surface_look=SurfaceLook(occlusion=False, ground=False))
    write_exr(tmp_path / "even.exr", even().radiance)
    with OffscreenScene() as real:
        real.set_environment(load_environment(tmp_path / "even.exr"))
        real.set_surface(mesh)
        drawn = real.renderer.linear_image(view, SIZE)
        alone = next(real.renderer.strips(view, SIZE, transparent=True))
    (where,) = places(view, mesh, (0.5, 0.0, 0.0))
    # Without occlusion, light finds all sheets as if each were alone.
    light, hidden = expected(view, mesh, (0.5, 0.0, 0.0), crossings=1)
    # What is behind has a radiance of 1 too.
    np.testing.assert_allclose(drawn[where][:3], light + 1.0 - hidden, rtol=0.01)
    assert drawn[where][3] == pytest.approx(hidden, abs=0.005)
    assert alone[where][3] == pytest.approx(255 * hidden, abs=1.5)


@pytest.mark.usefixtures("variant")
@pytest.mark.parametrize("azimuth", [0.0, 40.0])
def test_two_sheets_mirror_and_pass_when_traced(azimuth: float) -> None:
    from brdf_suite.reference.passes import trace

    mesh = glazed()
    view = View(camera=Camera(azimuth, 0.0), background="grey", surface_look=SurfaceLook(ground=False))
    black = Material("black", Lambertian(np.zeros(3)))
    made = build_reference(black, view, SIZE, even(), mesh)
    path = trace(made.traced, samples=4096, samples_per_pass=1024)
    session = RaytracedSession()
    session.show(black, view, SIZE, Quality(16, 4, 256), environment=even(), mesh=mesh)
    rays = session.frame().sums
    for x in (0.5, -0.5):
        (row, column) = places(view, mesh, (x, 0.0, 0.0))[0]
        # A few pixels of one plane differ by less than the noise of one.
        near = slice(row - 2, row + 3), slice(column - 1, column + 2)
        light, hidden = expected(view, mesh, (x, 0.0, 0.0), crossings=2)
        for found in (path, rays):
            assert found.radiance[near].mean() == pytest.approx(light, abs=0.006)
            assert found.coverage[near].mean() == pytest.approx(hidden if x > 0.0 else 1.0, abs=0.012)


def test_light_through_a_pane_is_weaker_by_what_it_mirrors_and_keeps(variant: Variant) -> None:
    from brdf_suite.reference.passes import trace

    mesh = Mesh("lit", (board("wall", "paint", (-1.0, 1.0), -0.2), board("pane", "glass", (-1.0, 0.0), 0.1)))
    lamp = Lamp("directional", azimuth_deg=0.0, elevation_deg=0.0, strength=1.0)
    view = View(camera=Camera(60.0, 0.0), background="grey", lamps=(lamp,))
    session = RaytracedSession()
    # So dark that what it and the pane mirror to each other is next to nothing.
    dark = Material("dark", Lambertian(np.full(3, 0.02)))
    session.show(dark, view, SIZE, Quality(1, 1, 256), environment=even(0.0), mesh=mesh)
    rays = session.frame().sums.radiance[..., 1]
    made = build_reference(dark, view, SIZE, even(0.0), mesh, variant=variant)
    path = trace(made.traced, samples=64, samples_per_pass=64).radiance[..., 1]
    # The eye looks past the edge of the pane at what lies in its shade.
    shade, open_place = places(view, mesh, (-0.3, 0.0, -0.2), (0.5, 0.0, -0.2))
    passed = GLASS * (1.0 - float(sheet_reflectance(1.0, 1.52)))
    for seen in (rays, path):
        assert seen[shade] / seen[open_place] == pytest.approx(passed, rel=0.02)
    assert path[shade] == pytest.approx(rays[shade], rel=0.02)


def roof() -> Mesh:
    """A sheet of glass that lies above a ground, and a small post that says where that is."""
    corners = np.array([[-1.0, 0.6, -1.0], [-1.0, 0.6, 1.0], [1.0, 0.6, 1.0], [1.0, 0.6, -1.0]])
    pane = PartGeometry(
        "roof", "glass", corners, np.tile([0.0, 1.0, 0.0], (4, 1)), corners[:, :2], [[0, 1, 2], [0, 2, 3]]
    )
    return Mesh("roof", (pane, board("post", "paint", (-0.01, 0.01), 0.0)))


@pytest.mark.parametrize("lamps", [(), (Lamp("directional", elevation_deg=90.0, strength=5.0),)])
def test_the_ground_below_glass_has_the_light_that_the_glass_passes(
    variant: Variant, tmp_path, lamps: tuple[Lamp, ...]
) -> None:
    from brdf_suite.pipeline.picture import OffscreenScene
    from brdf_suite.pipeline.scene import load_environment
    from brdf_suite.surface.occlusion.bake import bake

    mesh = roof()
    light = even(0.001 if lamps else 1.0)
    camera = Camera(30.0, 12.0, 9.0, (0.0, 0.0, 0.0))
    view = View(camera=camera, lamps=lamps, surface_look=SurfaceLook(ground=True))
    black = Material("black", Lambertian(np.zeros(3)))
    write_exr(tmp_path / "even.exr", light.radiance)
    with OffscreenScene() as real:
        real.set_environment(load_environment(tmp_path / "even.exr"))
        real.set_surface(mesh, bake(mesh))
        drawn = real.renderer.linear_image(view, SIZE)[..., 1]
    made = build_reference(black, view, SIZE, light, mesh, variant=variant)
    assert made.ground is not None
    made.ground.trace(made.traced.scene, 256)
    (row, column), (away, aside) = places(view, mesh, (0.5, -1.0, 0.5), (-4.0, -1.0, -4.0))
    by_grid = made.ground.seen_from(np.array([0.5, 5.0, 0.5]), np.array([[0.0, -1.0, 0.0]]))[0, 1]
    seen = drawn[row - 1 : row + 2, column - 1 : column + 2].mean() / drawn[away, aside]
    session = RaytracedSession()
    session.show(black, view, SIZE, Quality(64, 4, 1024), environment=light, mesh=mesh)
    darkness = session.frame().sums.darkness[row - 1 : row + 2, column - 1 : column + 2, 1].mean()
    if lamps:
        passed = GLASS * (1.0 - float(sheet_reflectance(1.0, 1.52)))
        assert by_grid == pytest.approx(passed, abs=0.01)
    # The shadow in even light is drawn by harmonics of low degree: an edge of the roof is soft by 30°.
    assert seen == pytest.approx(by_grid, abs=0.05 if not lamps else 0.01)
    assert 1.0 - darkness == pytest.approx(by_grid, abs=0.03 if lamps else 0.04)
