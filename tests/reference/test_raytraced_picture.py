"""Ray-traced pictures against sums by hand, and against the path tracer; shadows, interleaving, flakes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, PartMaterial, Relief, Sparkle, SurfaceLook, TwoTone
from brdf_suite.errors import SuiteError
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.lighting.lights import directional_lights
from brdf_suite.pipeline.material import Material, load_material
from brdf_suite.realtime.camera import Bounds, matrices
from brdf_suite.reference.raytraced.light_set import Strata
from brdf_suite.reference.variant import Variant
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.tracing.raytraced.picture import Quality, RaytracedSession
from brdf_suite.tracing.reference.scene import build_reference

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (40, 32)
PLAIN = View(surface="sphere", background="grey", sparkle=Sparkle(mode="off"))
MATT = Material("matt", Lambertian(np.array([0.2, 0.5, 0.8])))


@pytest.fixture(scope="module")
def session(variant: Variant) -> RaytracedSession:
    """One for all: what is compiled and built is kept, as in a window."""
    return RaytracedSession()


def sky(height: int = 16, contrast: float = 0.8) -> Environment:
    """A smooth light that differs in every direction."""
    d = direction(ring_angles(height)[:, None], column_angles(2 * height)[None])
    return Environment("sky", (1.0 + contrast * d).astype(np.float32))


def black() -> Environment:
    return Environment("black", np.zeros((8, 16, 3), np.float32))


def sphere_hits(view: View, mesh: Mesh) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Which pixels' middles see the ball well inside its outline; there its normals and the directions to the eye."""
    points = mesh.parts[0].positions.astype(float)
    centre, radius = 0.5 * (points.min(0) + points.max(0)), 0.5 * np.ptp(points, axis=0).max()
    m = matrices(view.camera, Bounds.of([mesh.parts[0].positions]), SIZE)
    x, y = np.meshgrid(
        (np.arange(SIZE[0]) + 0.5) * 2 / SIZE[0] - 1, 1 - (np.arange(SIZE[1]) + 0.5) * 2 / SIZE[1]
    )
    ray = np.stack([x * m.half_tangents[0], y * m.half_tangents[1], -np.ones_like(x)], -1) @ m.view_to_world.T
    ray /= np.linalg.norm(ray, axis=-1)[..., None]
    to = m.eye - centre
    inside = (ray @ to) ** 2 - to @ to + radius**2
    along = -ray @ to - np.sqrt(np.maximum(inside, 0.0))
    normal = (to + along[..., None] * ray) / radius
    good = (inside > 0.0) & ((normal * -ray).sum(-1) > 0.35)
    return good, normal, -ray


def local(normal: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Directions (n, 3) in frames of normals (n, 3); isotropic reflectances do not ask which."""
    helper = np.where(np.abs(normal[:, :1]) > 0.7, [[0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0]])
    x = np.cross(helper, normal)
    x /= np.linalg.norm(x, axis=1)[:, None]
    y = np.cross(normal, x)
    return np.stack([(directions * axis).sum(-1) for axis in (x, y, normal)], axis=-1)


def test_a_part_of_the_second_paint_looks_like_that_paint(session, sphere) -> None:
    """With its flakes: coarse silver has them, blue has none."""
    worn = SurfaceLook(materials=(PartMaterial(sphere.parts[0].name, "second_paint"),))
    near = replace(PLAIN, surface_look=worn, sparkle=Sparkle("texture"), camera=Camera(distance=0.2))

    def light(paint: str, view: View) -> np.ndarray:
        session.show(paint, view, SIZE, Quality(12, 2, 1), environment=sky(), mesh=sphere)
        return session.frame().sums.radiance

    for two_tone, like in ((TwoTone(paint="coarse_silver"), "coarse_silver"), (TwoTone(), "blue")):
        wanted = light(like, replace(near, surface_look=SurfaceLook()))
        np.testing.assert_allclose(
            light("blue", replace(near, two_tone=two_tone)), wanted, rtol=1e-4, atol=1e-5
        )


@pytest.mark.parametrize("rotation", [0.0, 130.0])
@pytest.mark.parametrize("model", ["matt", "facets"])
def test_a_ball_has_the_sum_over_the_lights_by_hand(session, sphere, model: str, rotation: float) -> None:
    """Equation 4 in numpy, float64, with the core's reflectance and the ball's own geometry."""
    wide = replace(TABLE_1["table1_polaris_silver"], lobes=TABLE_1["table1_polaris_silver"].lobes[:1])
    reflectance = MATT.reflectance if model == "matt" else CookTorrance(wide)
    environment, count = sky(), 24
    view = replace(PLAIN, rotation_deg=rotation, camera=Camera(40, 20))
    scene = session.show(
        Material(model, reflectance),
        view,
        SIZE,
        Quality(count, 1, 1),
        environment=environment,
        mesh=sphere,
    )
    found = session.frame().sums.radiance
    lights = directional_lights(environment, count).turned(np.radians(rotation))
    spreads = Strata.of(environment, count, np.eye(3)).middles().spreads
    good, normal, eye = sphere_hits(scene.view, sphere)
    n, wo = normal[good], local(normal[good], eye[good])
    wanted = np.zeros((len(n), 3))
    for towards, strength, spread in zip(lights.directions, lights.strengths, spreads, strict=True):
        wi = local(n, np.broadcast_to(towards, n.shape))
        if model == "facets":
            # A light of some extent sees facets of m² + σ²/2.
            lobe = replace(wide.lobes[0], m=float(np.hypot(wide.lobes[0].m, spread / np.sqrt(2.0))))
            reflectance = CookTorrance(replace(wide, lobes=(lobe,)))
        wanted += reflectance.eval(wi, wo) * strength * np.maximum(wi[:, 2:], 0.0)
    assert good.sum() > 200
    # What is left is the mesh's triangles for a ball.
    np.testing.assert_allclose(found[good], wanted, rtol=0.02)
    assert abs(found[good].sum() / wanted.sum() - 1.0) < 1e-3


def floor_and_lid() -> Mesh:
    """A floor of 2 m and a lid of 0.5 m half a metre above its middle."""

    def square(name: str, half: float, height: float, material: str = "paint") -> PartGeometry:
        corners = half * np.array([[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]], float)
        corners[:, 1] = height
        up = np.tile([0.0, 1.0, 0.0], (4, 1))
        return PartGeometry(
            name, material, corners, up, corners[:, [0, 2]] * 1e3, np.array([[0, 1, 2], [0, 2, 3]])
        )

    return Mesh("floor", (square("floor", 1.0, 0.0), square("lid", 0.25, 0.5)))


def test_a_lamps_shadow_lies_where_geometry_puts_it(session) -> None:
    """From above, a lamp at 45° on the right: the lid's shadow is half a metre to the left; both kinds of lamp."""
    view = replace(PLAIN, camera=Camera(0.0, 89.0))
    white = Material("white", Lambertian(np.ones(3)))
    for lamp in (
        Lamp("directional", azimuth_deg=90.0, elevation_deg=45.0, strength=1.0),
        Lamp("point", position=(40.0, 40.5, 0.0), strength=3200.0),
    ):
        scene = session.show(
            white,
            replace(view, lamps=(lamp,)),
            (64, 64),
            Quality(1, 1, 1),
            environment=black(),
            mesh=floor_and_lid(),
        )
        seen = session.frame().sums.radiance[..., 1]
        m = matrices(scene.view.camera, Bounds.of(p.positions for p in floor_and_lid().parts), (64, 64))

        def at(x: float, z: float, m=m, seen=seen) -> float:
            p = np.array([x, 0.0, z]) - m.eye
            a, b, c = p @ m.view_to_world
            column = (a / -c / m.half_tangents[0] + 1.0) * 32
            row = (1.0 - b / -c / m.half_tangents[1]) * 32
            return float(seen[int(row), int(column)])

        # Radiance 1 of a white surface that faces the lamp; here it is met at 45°.
        full = np.sqrt(0.5)
        for x, z in ((0.8, 0.0), (-0.9, 0.0), (-0.5, 0.4), (-0.5, -0.4)):
            assert at(x, z) == pytest.approx(full, rel=0.05)
        for x, z in ((-0.5, 0.0), (-0.65, 0.1), (-0.4, -0.15)):
            assert at(x, z) == 0.0


def test_sharing_lights_out_among_samples_changes_nothing(session, sphere) -> None:
    """32 lights by one sample, by eight and by 32: the same light, but for where in a pixel it was looked at."""
    pictures = []
    for samples in (1, 8, 32):
        session.show(MATT, PLAIN, (160, 128), Quality(32, 1, samples), environment=sky(), mesh=sphere)
        pictures.append(session.frame())
    inside = np.min([p.sums.coverage for p in pictures], axis=0) == 1.0
    one, eight, all_apart = (p.sums.radiance[inside] for p in pictures)
    assert inside.sum() > 4000
    np.testing.assert_allclose(eight.mean(0), one.mean(0), rtol=4e-3)
    np.testing.assert_allclose(all_apart.mean(0), one.mean(0), rtol=4e-3)
    assert np.abs(eight / one - 1.0).max() < 0.1
    assert pictures[1].sums.samples == 8


def blocks(picture: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """Means over squares of four pixels that the object fills, (n, 3)."""
    found = []
    for row in range(0, SIZE[1], 4):
        for column in range(0, SIZE[0], 4):
            here = (slice(row, row + 4), slice(column, column + 4))
            if inside[here].all():
                found.append(picture[here].mean(axis=(0, 1)))
    return np.array(found)


@pytest.mark.parametrize("kind", ["designed", "coat", "table_1", "table", "mirrors"])
def test_the_mean_of_many_rounds_is_the_path_traced_picture(session, sphere, kind: str) -> None:
    """A z-test over squares of a ball, on which there is no light from one place to another."""
    from brdf_suite.reference.passes import trace_pass

    paints = {
        "designed": lambda: replace(load_material("copper"), flakes=None),
        "coat": lambda: Material("coat", CoatLobe(1.5, 0.05)),
        "table_1": lambda: Material("blue", CookTorrance(TABLE_1["table1_blue"])),
        "table": lambda: Material(
            "table",
            IsotropicTable.from_reflectance(CookTorrance(TABLE_1["table1_white"]), HalfAngleGrid(40, 20, 36)),
        ),
        "mirrors": lambda: Material("coat", CoatLobe(1.5, 0.002)),
    }
    paint, environment = paints[kind](), sky(12, 0.9)
    quality = Quality(64, 16, 4, mirror=kind == "mirrors")
    session.show(paint, PLAIN, SIZE, quality, environment=environment, mesh=sphere)
    sums, rounds = [np.zeros((SIZE[1], SIZE[0], 7))], []
    for image in session.passes(rounds=24):
        if image.sums.samples % 4 == 0:
            rounds.append((image.sums.values - sums[-1])[..., :3] / 4)
            sums.append(image.sums.values)
    made = build_reference(Material("x", paint.reflectance), PLAIN, SIZE, environment, sphere)
    passes = [trace_pass(made.traced, 32, seed) for seed in range(12)]
    inside = (np.array(image.sums.coverage) == 1.0) & (np.min([c for _, c in passes], axis=0) == 1.0)
    ours = np.array([blocks(r, inside) for r in rounds[1:]])  # the first has its lights in the middle
    theirs = np.array([blocks(r, inside) for r, _ in passes])
    assert ours.shape[1] >= 10
    variance = ours.var(axis=0, ddof=1) / len(ours) + theirs.var(axis=0, ddof=1) / len(theirs)
    z = (ours.mean(axis=0) - theirs.mean(axis=0)) / np.sqrt(variance + (2e-3 * theirs.mean(axis=0)) ** 2)
    assert np.abs(z).max() < 4.5, z


def test_a_chrome_floor_shows_the_wall_as_the_path_tracer_does(session) -> None:
    """Light from one part to another. The floor ends before the wall, so that it mirrors no light of the lamp to it."""
    from brdf_suite.reference.passes import trace

    floor = floor_and_lid().parts[0]
    floor = replace(floor, positions=floor.positions * [0.8, 1.0, 0.5] + [0.0, 0.0, 0.6])
    corners = np.array([[-1, 0, -1], [1, 0, -1], [1, 1.5, -1], [-1, 1.5, -1]], float)
    back = np.tile([0.0, 0.0, 1.0], (4, 1))
    wall = PartGeometry(
        "wall", "paint", corners, back, corners[:, :2] * 1e3, np.array([[0, 1, 2], [0, 2, 3]])
    )
    mesh = Mesh("corner", (replace(floor, material="chrome"), wall))
    lamp = Lamp("directional", azimuth_deg=0.0, elevation_deg=60.0, strength=1.0)
    view = replace(PLAIN, camera=Camera(10.0, 25.0), lamps=(lamp,))
    session.show(MATT, view, SIZE, Quality(1, 64, 16), environment=black(), mesh=mesh)
    found = session.frame()
    made = build_reference(Material("x", MATT.reflectance), view, SIZE, black(), mesh)
    estimate = trace(made.traced, samples=512, samples_per_pass=128)
    inside = (found.sums.coverage == 1.0) & (estimate.coverage == 1.0)
    ours, theirs = blocks(found.sums.radiance, inside), blocks(estimate.radiance, inside)
    assert len(ours) >= 6
    on_floor = theirs[:, 2] < 0.9 * theirs[:, 2].max()
    assert on_floor.sum() >= 3
    np.testing.assert_allclose(ours, theirs, rtol=0.03)
    dark = replace(view, lamps=())
    session.show(MATT, dark, SIZE, Quality(1, 4, 4), environment=black(), mesh=mesh)
    assert session.frame().sums.radiance.max() == 0.0


def test_the_ground_is_dark_under_the_object_and_open_away_from_it(session, sphere) -> None:
    look = SurfaceLook(ground=True)
    view = replace(
        PLAIN, surface_look=look, background="environment", camera=Camera(20.0, 30.0, distance=1.2)
    )
    session.show(MATT, view, SIZE, Quality(128, 1, 16), environment=sky(16, 0.2), mesh=sphere)
    image = session.frame()
    darkness = image.sums.darkness.mean(axis=-1)
    free = image.sums.coverage == 0.0
    assert darkness[free].max() > 0.4
    assert abs(np.median(darkness[0])) < 0.03
    assert darkness[-3:][free[-3:]].min() > -1e-4
    # What the backdrop loses is what the picture loses.
    behind, whole = image.scene.behind, image.whole()
    np.testing.assert_allclose(whole[free], (behind * (1.0 - image.sums.darkness))[free], rtol=1e-5)
    without = session.show(
        MATT, replace(view, surface_look=SurfaceLook()), SIZE, "fast", environment=sky(), mesh=sphere
    )
    assert without.key != image.scene.key
    assert session.frame().sums.darkness.max() == 0.0


def test_another_camera_or_paint_builds_and_compiles_nothing_anew(session, sphere) -> None:
    import drjit as dr

    view = replace(PLAIN, rotation_deg=11.0)
    args = {"environment": sky(), "mesh": sphere}
    session.show("copper", view, SIZE, "fast", **args)
    session.frame()
    before = session.frame().sums.radiance
    surface = session.tracer_scene(0).surface
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        for paint, other in (
            ("red", view),
            ("copper", replace(view, camera=Camera(70.0, 30.0), rotation_deg=50.0)),
        ):
            session.show(paint, other, SIZE, "fast", **args)
            changed = session.frame().sums.radiance
            assert np.abs(changed - before).max() > 0.01
        kernels = dr.kernel_history()
    assert kernels
    assert [k for k in kernels if not k.get("cache_hit", True)] == []
    assert session.tracer_scene(0).surface is surface
    session.show("copper", view, SIZE, "fast", **args)
    np.testing.assert_array_equal(session.frame().sums.radiance, before)


def test_a_part_may_be_of_another_material_and_a_mesh_without_paint(session, sphere) -> None:
    chrome = Mesh("ball", (replace(sphere.parts[0], material="chrome"),))
    session.show("copper", PLAIN, SIZE, "fast", environment=sky(), mesh=chrome)
    image = session.frame()
    assert image.sums.radiance[image.sums.coverage == 1.0].mean() > 0.3


class TooBright:
    """What no paint can be: it sends back 1.3 times the light."""

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        above = (np.asarray(wi)[..., 2:] > 0.0) & (np.asarray(wo)[..., 2:] > 0.0)
        return np.where(above, np.full(3, 1.3 / np.pi), 0.0)


def test_exposure_backdrop_and_words(session, sphere) -> None:
    relief = Relief(orange_peel=1.0)
    view = replace(PLAIN, exposure_mode="automatic", background="blurred", relief=relief)
    scene = session.show(MATT, view, SIZE, "fast", environment=sky(), mesh=sphere)
    assert any("smooth surface" in notice for notice in scene.notices)
    image = session.frame()
    soft = image.scene.behind
    clear = session.show(
        MATT, replace(view, background="environment"), SIZE, "fast", environment=sky(), mesh=sphere
    ).behind
    # A light that goes with the cosine keeps its mean, and E + 1 of E + 2 of its contrast.
    np.testing.assert_allclose(soft - 1.0, (clear - 1.0) * 61.0 / 62.0, atol=0.01)
    assert np.abs(soft - clear).max() > 0.005
    inside = image.sums.coverage == 1.0
    y = image.sums.radiance[inside] @ [0.2627, 0.678, 0.0593]
    assert 2.0**image.exposed_view.exposure_ev * np.median(y) == pytest.approx(0.18, rel=0.01)
    grey = session.show(
        MATT, replace(view, background="grey", exposure_ev=1.0), SIZE, "fast", environment=sky(), mesh=sphere
    )
    assert grey.key == scene.key  # how it is shown is no part of the light
    assert session.frame().codes()[0, 0].tolist() == [118] * 3
    bright = Material("bright", TooBright())
    assert any(
        "1.30 times the light" in n
        for n in session.show(bright, PLAIN, SIZE, "fast", environment=sky(), mesh=sphere).notices
    )
    with pytest.raises(SuiteError, match="Nothing has been shown"):
        next(RaytracedSession().passes())
