"""What differs from place to place: flakes, relief, two paints; as in the core and in the real-time picture."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from brdf_suite.appearance.flakes.tilt import flake_slope, tilt_place
from brdf_suite.documents.paint import Flakes, OrangePeel
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Relief, Sparkle, TwoTone
from brdf_suite.files.images.environments import write_exr, write_png
from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material, load_shipped_paint, material_of
from brdf_suite.reflectance.designed.build import build_paint
from tools.evaluation.flake_model import flake_texture_ratio
from tools.evaluation.visible_flake_part import visible_flake_part

pytestmark = pytest.mark.usefixtures("variant")
FLAKES = Flakes(120.0, 20.0, 0.17, 0.3)
IOR = 1.5


def vectors(rows: np.ndarray, kind: str = "Vector3f"):
    import mitsuba as mi

    return getattr(mi, kind)(np.ascontiguousarray(rows.T, np.float32))


def pixels(rng: np.random.Generator, n: int, smallest: float, largest: float):
    """Places in millimetres and how they change from pixel to pixel, as single precision holds them."""
    at = rng.random((n, 2)) * 50.0
    width = 10.0 ** rng.uniform(math.log10(smallest), math.log10(largest), (n, 1))
    across, down = (rng.normal(size=(n, 2)) * width for _ in "ab")
    return [rows.astype(np.float32).astype(float) for rows in (at, across, down)]


def placed(at, across, down):
    import mitsuba as mi

    return SimpleNamespace(
        uv=vectors(at, "Point2f"),
        across=vectors(across, "Vector2f"),
        down=vectors(down, "Vector2f"),
        seen=mi.Bool(True),
    )


def test_another_address_of_an_image_compiles_nothing_anew(variant) -> None:
    """Numpy puts an array wherever there is room; Dr.Jit reads pairs by other instructions from an odd address."""
    import drjit as dr

    from brdf_suite.reference.scene.place import look_up, texture

    memory = np.zeros(64, np.float32)
    first = -memory.ctypes.data % 64 // 4
    where = vectors(np.random.default_rng(1).random((50, 2)), "Point2f")
    dr.eval(where)
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        for start in (first, first + 4):
            dr.eval(look_up(texture(memory[start : start + 32].reshape(4, 4, 2)), where))
        programs = [kernel["hash"] for kernel in dr.kernel_history([dr.KernelType.JIT])]
    assert len(programs) == 2
    assert programs[0] == programs[1]


def straight(direction, *, back=False):
    return direction


@pytest.mark.parametrize("density", [3200.0, 800.0])
def test_a_place_shows_one_flake_of_the_population(variant, density) -> None:
    """Mean and second moment of what places send, over many flakes: by their tilts and brightnesses."""
    from brdf_suite.appearance.flakes.visible import flake_coverage
    from brdf_suite.reference.flakes import population

    flakes = Flakes(density, 20.0, 0.17)
    rng = np.random.default_rng(5)
    at, across, down = pixels(rng, 1_000_000, 0.002, 0.01)
    there = population.FlakeLayer(flakes, IOR, waviness=0.03).at(placed(at * 40.0, across, down), straight)
    view = vectors(np.array([[0.0, 0.0, 1.0]]))
    for theta in (0.0, 0.5):
        ratio = np.array(there.ratio(vectors(spherical(theta, 0.4)[None]), view), float)[0]
        _, stretch = tilt_place(flake_slope(spherical(theta, 0.4), spherical(0.0, 0.0), IOR), 0.17)
        # Of the bell the integral of the square is 9 / (40 pi sigma^2); brightnesses have 25/16.
        second = 25.0 / 16.0 / flake_coverage(flakes) * 9.0 / 160.0 / (float(stretch) * 0.03) ** 2
        assert ratio.mean() == pytest.approx(1.0, abs=4.5 * math.sqrt(second / 1_000_000))
        assert (ratio**2).mean() == pytest.approx(second, rel=0.05)
    # Flakes are of their size: places farther apart show others.
    moved = population.FlakeLayer(flakes, IOR, waviness=0.03).at(
        placed(at * 40.0 + 0.002, across * 0.0, down * 0.0), straight
    )
    still = population.FlakeLayer(flakes, IOR, waviness=0.03).at(
        placed(at * 40.0, across * 0.0, down * 0.0), straight
    )
    same = (np.array(moved.slope) == np.array(still.slope)).all(axis=0).mean()
    assert 0.7 < same < 0.95


def test_the_flake_texture_is_that_of_the_core(variant) -> None:
    from brdf_suite.appearance.flakes.footprint import PIXEL_REACH
    from brdf_suite.reference.flakes.texture import flakes_seen, seen_ratio

    rng = np.random.default_rng(8)
    at, across, down = pixels(rng, 20_000, 0.003, 0.3)
    slope = (rng.normal(size=(len(at), 2)) * 0.1).astype(np.float32).astype(float)
    known = {"density": 120.0, "size": 0.02, "roughness": 0.17, "colour_spread": 0.3}
    wanted = flake_texture_ratio(at, across, down, slope, np.full(len(at), 0.01), **known)
    place = placed(at, across, down)
    seen = flakes_seen(FLAKES, place.uv, place.across, place.down, PIXEL_REACH)
    found = np.array(seen_ratio(FLAKES, seen, vectors(slope, "Vector2f"), 0.01**2)).T
    assert np.abs(found - wanted).max() < 1e-3 * wanted.max()
    assert np.quantile(np.abs(found - wanted), 0.99) < 1e-3
    assert wanted.std() > 1.0


def test_visible_flakes_send_as_much_as_in_the_core(variant) -> None:
    from brdf_suite.reference.flakes.population import FlakeLayer

    rng = np.random.default_rng(3)
    wi, wo = (
        spherical(np.arccos(rng.random(5000) * 0.95 + 0.05), rng.uniform(0, 2 * np.pi, 5000)) for _ in "ab"
    )
    base = rng.random((5000, 3)).astype(np.float32)
    wanted = visible_flake_part(FLAKES, wi, wo, base.astype(float), IOR, 2.0)
    found = FlakeLayer(FLAKES, IOR, 2.0).visible_part(vectors(base, "Color3f"), vectors(wi), vectors(wo))
    np.testing.assert_allclose(np.array(found).T, wanted, rtol=1e-4, atol=1e-6)
    back = visible_flake_part(FLAKES, wo, wi, base.astype(float), IOR, 2.0)
    np.testing.assert_allclose(back, wanted, rtol=1e-12)
    assert (wanted <= 0.9 * base + 1e-9).all()


def test_visible_flakes_agree_with_the_real_time_share_at_the_mirror_direction() -> None:
    from brdf_suite.realtime.lights.block import visible_flake_lobe

    theta = math.radians(45.0)
    base = np.full((1, 3), 0.5)
    wanted = visible_flake_lobe(FLAKES, np.zeros(1), base, theta, IOR)
    found = visible_flake_part(FLAKES, spherical(theta, 0.0), spherical(theta, math.pi), base[0], IOR)
    np.testing.assert_allclose(found, wanted[0], rtol=1e-9)


def test_in_a_white_furnace_a_paint_with_flakes_has_the_albedo_of_the_smooth_one(variant) -> None:
    """A place and a direction for each sample: a z-test of the whole, samplers, flakes and all."""
    import mitsuba as mi

    from brdf_suite.reference.bsdfs import terms
    from brdf_suite.reference.bsdfs.placed import LayeredPaintBsdf
    from brdf_suite.reference.bsdfs.translate import divide
    from brdf_suite.reference.flakes.population import FlakeLayer
    from brdf_suite.reflectance.albedo import directional_albedo

    model = build_paint(load_shipped_paint("coarse_silver"))
    parts = divide(model)
    paint = LayeredPaintBsdf(
        parts.base, parts.coat, flakes=FlakeLayer(Flakes(3200.0, 20.0, 0.17, 0.3), parts.ior)
    )
    rng = np.random.default_rng(7)
    places = placed(*pixels(rng, 300_000, 0.02, 2.0))
    up = mi.Frame3f(mi.Normal3f(0.0, 0.0, 1.0))
    place = SimpleNamespace(
        **vars(places),
        along_u=up.s,
        along_v=up.t,
        to_world=lambda direction: direction,
        from_world=lambda direction: direction,
        frame=up,
    )
    count = 300_000
    view = spherical(0.6, 1.0)
    views = vectors(np.broadcast_to(view, (count, 3)))
    local = paint.at(place, views)
    choice = mi.Float(rng.random(count).astype(np.float32))
    light = terms.sample(local.samplers, views, choice, mi.Point2f(rng.random((2, count)).astype(np.float32)))
    pdf = np.array(terms.pdf(local.samplers, light, views), float)
    value = np.array(local.reflected(light, views), float).T
    sound = (np.array(light.z) > 0.0) & (pdf > 0.0)
    weights = np.where(sound[:, None], value / np.maximum(pdf, 1e-30)[:, None], 0.0)
    assert value.min() >= 0.0
    smooth = np.array(
        LayeredPaintBsdf(parts.base, parts.coat).at(place, views).reflected(light, views), float
    ).T
    assert np.median(np.abs(value / np.maximum(smooth, 1e-9) - 1.0)[sound]) > 0.02
    error = weights.std(axis=0) / math.sqrt(count)
    wanted = directional_albedo(model, view)
    assert np.all(np.abs(weights.mean(axis=0) - wanted) < 4.5 * error + 2e-3 * wanted)
    assert np.all(error < 0.02 * wanted)


@pytest.fixture(scope="module")
def leaning_paint(variant):
    """Copper with a steep relief, at 100,000 samples of one place that leans by some 20°."""
    import mitsuba as mi

    from brdf_suite.reference.bsdfs.placed import LayeredPaintBsdf
    from brdf_suite.reference.bsdfs.translate import divide
    from brdf_suite.reference.scene.place import Slopes, texture

    parts = divide(build_paint(load_shipped_paint("copper")))
    slopes = np.full((4, 4, 2), (0.3, -0.2), np.float32)
    paint = LayeredPaintBsdf(parts.base, parts.coat, shape=Slopes(texture(slopes), (1.0, 1.0), 1.0))
    place = SimpleNamespace(
        uv=mi.Point2f(0.1, 0.2), along_u=mi.Vector3f(1.0, 0.0, 0.0), along_v=mi.Vector3f(0.0, 1.0, 0.0)
    )
    return paint, place


@pytest.mark.parametrize("theta_deg", [20.0, 65.0])
def test_a_leaning_surface_is_drawn_as_its_density_says(leaning_paint, chi_square, theta_deg: float) -> None:
    import mitsuba as mi

    from brdf_suite.reference.bsdfs import terms

    paint, place = leaning_paint
    count = 100_000
    rng = np.random.default_rng(5)
    view = spherical(np.full(count, math.radians(theta_deg)), math.pi)
    local = paint.at(place, vectors(view))
    choice, u = mi.Float(rng.random(count).astype(np.float32)), rng.random((2, count)).astype(np.float32)
    drawn = np.array(terms.sample(local.samplers, vectors(view), choice, mi.Point2f(u)), float).T

    def density(light: np.ndarray) -> np.ndarray:
        views = vectors(np.broadcast_to(view[0], light.shape))
        return np.array(terms.pdf(paint.at(place, views).samplers, vectors(light), views), float)

    # The coat's lobe leans, so the panels of the test need not follow it: it is about the mirror of the leaning normal.
    broad = drawn[np.linalg.norm(drawn - coat_direction(view[0]), axis=1) > 0.05]
    assert len(broad) > 0.3 * count
    mass = sphere_mass(
        lambda light: density(light) * (np.linalg.norm(light - coat_direction(view[0]), axis=1) > 0.05)
    )
    share = (broad[:, 2] > 0.0).mean() * len(broad) / count
    assert share == pytest.approx(mass, abs=0.01)


def coat_direction(view: np.ndarray) -> np.ndarray:
    """Where the leaning coat mirrors a view to, folded above the horizon."""
    n = np.array([-0.3, 0.2, 1.0])
    n /= np.linalg.norm(n)
    light = 2.0 * (n @ view) * n - view
    return np.array([light[0], light[1], abs(light[2])])


def sphere_mass(density) -> float:
    """The integral over the upper hemisphere, by midpoints even in cosine and azimuth."""
    z, phi = np.meshgrid(
        (np.arange(400) + 0.5) / 400, 2 * np.pi * (np.arange(800) + 0.5) / 800, indexing="ij"
    )
    light = np.stack([np.sqrt(1 - z * z) * np.cos(phi), np.sqrt(1 - z * z) * np.sin(phi), z], -1).reshape(
        -1, 3
    )
    return float(density(light).mean() * 2.0 * np.pi)


def test_what_leans_reflects_all_that_it_would(leaning_paint) -> None:
    """In a white furnace, what comes from below the surface's horizon is made up for: the albedo is the flat one's."""
    import mitsuba as mi

    from brdf_suite.reference.bsdfs import terms
    from brdf_suite.reflectance.albedo import directional_albedo

    paint, place = leaning_paint
    count = 200_000
    rng = np.random.default_rng(6)
    view = spherical(0.5, 2.0)
    views = vectors(np.broadcast_to(view, (count, 3)))
    local = paint.at(place, views)
    choice = mi.Float(rng.random(count).astype(np.float32))
    light = terms.sample(local.samplers, views, choice, mi.Point2f(rng.random((2, count)).astype(np.float32)))
    pdf = np.array(terms.pdf(local.samplers, light, views), float)
    value = np.array(local.reflected(light, views), float).T
    weights = np.where(
        (np.array(light.z) > 0.0)[:, None] & (pdf > 0)[:, None], value / np.maximum(pdf, 1e-30)[:, None], 0
    )
    n = np.array([-0.3, 0.2, 1.0]) / np.linalg.norm([-0.3, 0.2, 1.0])
    wanted = directional_albedo(
        build_paint(load_shipped_paint("copper")), spherical(math.acos(n @ view), 0.0)
    )
    error = weights.std(axis=0) / math.sqrt(count)
    assert np.all(np.abs(weights.mean(axis=0) - wanted) < 4.5 * error + 3e-3 * wanted)


SIZE = (64, 48)


@pytest.fixture(scope="module")
def pictures(variant, tmp_path_factory):
    """Return radiance of both renderers inside the object, for a view of a sphere in a lamp and soft light."""
    from brdf_suite.output.still import loaded_scene
    from brdf_suite.reference.passes import trace
    from brdf_suite.tracing.reference.live import LiveReference

    live = LiveReference()
    folder = tmp_path_factory.mktemp("placed")
    light = folder / "soft.exr"
    write_exr(light, np.full((16, 32, 3), 0.3, np.float32))

    def both(paint: str, samples: int, **changes):
        view = View(environment=str(light), surface="sphere", background="grey", **changes)
        live.show(paint, view, SIZE)
        # Passes of one size: each other size is compiled anew.
        estimate = trace(live.scene.traced, samples=samples, samples_per_pass=16)
        with loaded_scene(view) as loaded:
            loaded.scene.set_material(fit_material(load_material(paint)))
            drawn = loaded.scene.renderer.linear_image(loaded.composed(view, SIZE), SIZE)
        inside = (estimate.coverage > 0.999) & (drawn[..., 3] > 0.999)
        y = np.array([0.2627, 0.678, 0.0593])
        return drawn[..., :3] @ y, estimate.radiance @ y, inside, live.scene.notices

    return both, folder


def test_flakes_have_the_contrast_of_the_real_time_picture(pictures) -> None:
    both, _ = pictures
    near = {"camera": Camera(35.0, 10.0, 0.16, (0.0, 0.1, 0.0), 400.0)}
    drawn, traced, inside, notices = both("coarse_silver", 512, **near)
    smooth, mean, _, _ = both("coarse_silver", 512, **near, sparkle=Sparkle("off"))
    sparkles, found = (drawn - smooth)[inside], (traced - mean)[inside]
    assert sparkles.std() > 0.01
    assert sparkles.std() == pytest.approx(found.std(), rel=0.35)
    assert not any("flakes" in notice for notice in notices)


def test_flakes_add_no_light_to_a_picture(variant) -> None:
    from tools.evaluation.reference_flakes import sparkle_energy

    found = sparkle_energy("blue", samples=8, size=(64, 48))
    assert 0.0 < found.error < 0.06
    # Neighbouring pixels share flakes, which the error does not know.
    assert abs(found.ratio - 1.0) < 4.5 * found.error + 0.002


def test_relief_and_two_tone_are_those_of_the_real_time_picture(pictures) -> None:
    both, folder = pictures
    mask = np.zeros((16, 16, 3), np.uint8)
    mask[:, 8:] = 255
    write_png(folder / "mask.png", mask)
    drawn, traced, inside, _ = both(
        "solid_white", 16, two_tone=TwoTone("solid_black", str(folder / "mask.png"), 150.0, "front")
    )
    assert traced[inside].std() > 0.05
    assert np.corrcoef(drawn[inside], traced[inside])[0, 1] > 0.95
    from brdf_suite.documents.view_settings import Lamp

    lamps = (Lamp("directional", azimuth_deg=60.0, elevation_deg=40.0, strength=2.0),)
    x, y = np.meshgrid(np.arange(64), np.arange(64))
    slopes = np.stack([0.3 * np.sin(x * np.pi / 32), 0.2 * np.cos(y * np.pi / 32), -np.ones((64, 64))], -1)
    normals = -slopes / np.linalg.norm(slopes, axis=-1)[..., None]
    write_png(folder / "normals.png", np.uint8(np.round((normals + 1.0) * 127.5)))
    relief = Relief(str(folder / "normals.png"), 1.0, 60.0)
    drawn, traced, inside, _ = both("matte_grey", 16, relief=relief, lamps=lamps, sparkle=Sparkle("off"))
    plain, _, _, _ = both("matte_grey", 16, lamps=lamps, sparkle=Sparkle("off"))
    shapes = (drawn - plain)[inside]
    assert shapes.std() > 0.02
    assert np.corrcoef(shapes, (traced - plain)[inside])[0, 1] > 0.9


def test_orange_peel_of_the_paint_or_of_the_view_moves_reflections(variant, tmp_path) -> None:
    """Black paint before stripes of light: they waver by the slope, whichever of the two asks for it."""
    from brdf_suite.tracing.reference.live import LiveReference

    pixels = np.full((32, 64, 3), 0.1, np.float32)
    pixels[:, np.arange(64) % 4 < 2] = 2.0
    write_exr(tmp_path / "stripes.exr", pixels)
    near = Camera(35.0, 10.0, 0.5, None, 200.0)
    view = View(environment=str(tmp_path / "stripes.exr"), surface="sphere", background="grey", camera=near)
    paint = load_shipped_paint("solid_black")
    live = LiveReference()

    def traced(worn, shown):
        live.show(material_of(worn), shown, (48, 40))
        for _ in range(2):
            estimate = live.step()
        return estimate.radiance[..., 1]

    smooth = traced(paint, view)
    peel = OrangePeel(20.0, 8.0)
    own = traced(replace(paint, orange_peel=peel), view)
    # A slope asked for by the view goes before the paint's own.
    asked = traced(
        replace(paint, orange_peel=OrangePeel(0.1, 5.0)),
        replace(view, relief=Relief(orange_peel=peel.slope_deg, orange_peel_mm=8.0)),
    )
    np.testing.assert_allclose(own, asked, rtol=1e-3, atol=1e-4)
    assert np.abs(own - smooth).mean() > 0.03 * smooth.mean()
