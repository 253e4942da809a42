"""Weights for every angle of the view: what constant light brings back, in the picture too, and who waits for them."""

from __future__ import annotations

import logging
import threading
from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.errors import FittingError
from brdf_suite.files.measured.goniometer_rows import as_samples
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.lobe_maps import prefilter
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import Material, load_material
from brdf_suite.pipeline.paint_angles import PaintAngles
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_surface, prepare_environment
from brdf_suite.pipeline.seen_queue import SeenQueue, SeenWeights
from brdf_suite.pipeline.seen_weights import seen_weights
from brdf_suite.realtime.environment.ladder import Ladder
from brdf_suite.realtime.environment.look_up_table import RAMP_COSINES, look_up_table
from brdf_suite.realtime.material.ramp import make_ramp
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps, MeshPart
from brdf_suite.reflectance.albedo import white_furnace
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.ggx import Ggx
from brdf_suite.reflectance.models.lambertian import Lambertian

WHITE = CubeFaces(np.ones((6, 32, 32, 3), np.float16))


class Sheen:
    """A reflectance that is dark along the normal and bright at grazing, in three colours; anisotropic if asked."""

    def __init__(self, brushed: float = 0.0, sign: float = 1.0) -> None:
        self.brushed = brushed
        self.sign = sign

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        rise = 0.05 + 0.2 * (1.0 - wi[..., 2]) * (1.0 - wo[..., 2])
        half = wi + wo
        turn = 1.0 + self.brushed * np.cos(2.0 * np.arctan2(half[..., 1], half[..., 0]))
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        value = self.sign * np.where(above, rise * turn, 0.0)
        return value[..., None] * np.array([1.0, 0.5, 0.1])


class Tape:
    """A reflectance that sends light back to where it comes from, yellow on grey; reciprocal."""

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        back = np.maximum((wi * wo).sum(axis=-1), 0.0) ** 30
        return np.where(above, 1.0, 0.0)[..., None] * (0.05 + back[..., None] * np.array([0.6, 0.4, 0.0]))


def directional(reflectance, cosine: float) -> np.ndarray:
    """What constant light of 1 sends to a view (3,)."""
    return white_furnace(reflectance, [-np.sqrt(1.0 - cosine**2), 0.0, cosine])


def returned(weights, exponents, place: int) -> np.ndarray:
    """What the weights bring back of constant light of 1, (3,), by the amplitudes of their look-ups."""
    total = np.pi * weights.kd[place]
    for lobe, exponent in enumerate(exponents):
        for target, part in (
            ("plain", weights.kdd),
            ("gloss", weights.kg),
            *(("plain", t) for t in weights.turned),
        ):
            if part[place, lobe].any():
                total = total + part[place, lobe] * look_up_table().find(target, exponent).amplitude[place]
    return total


@pytest.fixture(scope="module")
def silver():
    return fit_material(load_material("table1_polaris_silver"))


def test_constant_light_comes_back_at_every_angle(silver) -> None:
    exponents = tuple(silver.weights.exponents.tolist())
    for reflectance in (silver.reflectance, Sheen()):
        weights = seen_weights(reflectance, exponents)
        for place in (15, 30, 42, 50, 63):
            wanted = directional(reflectance, float(RAMP_COSINES[place]))
            np.testing.assert_allclose(returned(weights, exponents, place), wanted, rtol=0.01)


def test_what_differs_with_the_azimuth_is_seen_in_its_mean(silver) -> None:
    exponents = tuple(silver.weights.exponents.tolist())
    plain, brushed = (seen_weights(Sheen(b), exponents) for b in (0.0, 0.5))
    np.testing.assert_allclose(brushed.kd, plain.kd, rtol=0.05, atol=1e-3)


def test_the_picture_is_as_bright_as_the_paint_and_the_modes_stay_apart(silver) -> None:
    """A sheet in white light at 70°, where a lobe fitted in the plane at 45° brings back two thirds."""
    n = np.array([[0.0, 0.0, 1.0]] * 3)
    sheet = MeshPart("sheet", "paint", [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], n, [[0, 1, 2]])
    exponents = (1.0, 8.0, 86.5, *(e for e in silver.weights.exponents if e > 100))
    seen = {}
    with OffscreenScene() as scene:
        scene.renderer.set_environment(
            EnvironmentMaps(exponents, (WHITE,) * len(exponents), WHITE, WHITE, WHITE)
        )
        scene.renderer.set_mesh([sheet])
        scene.set_material(silver)
        camera = Camera(70, 0, distance=2.0, target=(0.0, 0.0, 0.0))
        for name, modes in {
            "raised": {},
            "multi_angle": {"fresnel": "multi_angle"},
            "off": {"fresnel": "off"},
            "paper": {"look_up": "paper"},
        }.items():
            picture = scene.renderer.linear_image(View(camera, **modes), (16, 16), 1)
            seen[name] = picture[8, 8, :3].astype(float)
    wanted = directional(silver.reflectance, np.cos(np.radians(70.0)))
    np.testing.assert_allclose(seen["raised"], wanted, rtol=0.05)
    np.testing.assert_array_equal(seen["multi_angle"], seen["raised"])
    assert (seen["off"] < 0.75 * wanted).all()
    assert (seen["paper"] < 0.75 * wanted).all()


def test_designed_paints_read_under_one_light_keep_their_way(silver) -> None:
    angles = PaintAngles(time_limit_s=1.0)
    assert angles.by_view(fit_material(load_material("red"))) is None
    assert angles.by_view(silver) is not None
    shift = fit_material(load_material("gold_green_shift"))
    assert angles.by_view(shift) is not None
    assert angles.by_view(replace(shift)) is angles.by_view(shift)  # of one reflectance there is one search
    angles.close()


def lamps(directions: np.ndarray) -> np.ndarray:
    """Radiance (..., 3) of coloured lamps about 25° wide in grey surroundings, for world directions (..., 3)."""
    total = np.full(directions.shape, 0.15)
    for towards, colour in (
        ((0.3, 0.9, 0.3), (4.0, 4.0, 4.0)),
        ((-0.9, 0.2, 0.4), (2.0, 1.4, 0.8)),
        ((0.7, -0.1, 0.7), (0.8, 1.4, 2.0)),
    ):
        axis = np.array(towards) / np.linalg.norm(towards)
        total += np.exp(12.0 * (directions @ axis - 1.0))[..., None] * colour
    return total


def gathered(reflectance, normal: np.ndarray, view: np.ndarray) -> np.ndarray:
    """The light of :func:`lamps` that a surface sends to ``view`` (3,), by quadrature on rings about the mirror."""
    edges = np.concatenate(([0.0], np.geomspace(2e-3, 0.5, 9), np.linspace(0.5, np.pi, 17)[1:]))
    x, w = np.polynomial.legendre.leggauss(4)
    half = 0.5 * np.diff(edges)
    gamma = (edges[:-1, None] + half[:, None] * (1.0 + x)).ravel()
    area = (half[:, None] * w).ravel() * np.sin(gamma) * 2.0 * np.pi / 24
    mirrored = 2.0 * (normal @ view) * normal - view
    first = np.cross(mirrored, normal + 0.01 * view[[1, 2, 0]])
    first /= np.linalg.norm(first)
    second = np.cross(mirrored, first)
    phi = (np.arange(24) + 0.5) * 2.0 * np.pi / 24
    around = np.cos(phi)[:, None] * first + np.sin(phi)[:, None] * second
    lights = np.cos(gamma)[:, None, None] * mirrored + np.sin(gamma)[:, None, None] * around
    across = np.cross(normal, view)
    across /= np.linalg.norm(across)
    frame = np.stack((np.cross(across, normal), across, normal))  # world to local
    local = lights @ frame.T
    values = reflectance.eval(local, frame @ view) * np.maximum(local[..., 2:], 0.0) * lamps(lights)
    return np.asarray(np.einsum("gpc,g->c", values, area))


@pytest.fixture(scope="module")
def sphere():
    """The scene of a sphere in the light of :func:`lamps`."""
    radiance = lamps(direction(ring_angles(64)[:, None], column_angles(128)[None, :])).astype(np.float32)
    with OffscreenScene() as scene:
        scene.set_environment(prepare_environment("lamps", Environment("lamps", radiance), prefilter))
        scene.set_surface(load_surface("sphere"))
        yield scene


def sphere_error(fit, scene) -> float:
    """Mean ΔE00 between the picture of a small sphere and what its reflectance gathers there."""
    size = (24, 24)
    scene.set_material(fit)
    view = View(Camera(20, 15), sparkle=Sparkle(mode="off"))
    picture = scene.renderer.linear_image(view, size, 1)[..., :3].astype(float)
    camera = scene.renderer.camera_matrices(view, size)
    centre, radius = (
        np.array(scene.renderer.bounds.centre),
        0.5 * np.ptp([scene.renderer.bounds.minimum, scene.renderer.bounds.maximum], axis=0).max(),
    )
    at = (np.arange(size[0]) + 0.5) / size[0] * 2.0 - 1.0
    x, y = np.meshgrid(at * camera.half_tangents[0], -at * camera.half_tangents[1])
    rays = np.stack((x, y, -np.ones_like(x)), axis=-1) @ camera.view_to_world.T
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    eye = camera.eye - centre
    along = rays @ eye
    root = along**2 - (eye @ eye - radius**2)
    hit = root > (0.25 * radius) ** 2  # N·V over .25: at the rim a pixel is many angles
    normals = (eye + (-along - np.sqrt(np.where(hit, root, 0.0)))[..., None] * rays) / radius
    wanted = np.array(
        [gathered(fit.reflectance, n, -v) for n, v in zip(normals[hit], rays[hit], strict=True)]
    )
    assert len(wanted) > 200
    exposure = 0.18 / np.median(wanted.mean(axis=-1))
    return float(
        delta_e_2000(working_to_lab(exposure * picture[hit]), working_to_lab(exposure * wanted)).mean()
    )


def test_a_paint_read_under_two_lights_looks_as_its_reflectance(sphere) -> None:
    """Fitted at one incidence alone, as designed paints are, gold-green misses by 7.6 and teal-violet by 6.1."""
    for paint in ("gold_green_shift", "teal_violet_shift"):
        assert sphere_error(fit_material(load_material(paint)), sphere) < 0.8


def test_scattered_samples_look_as_their_reflectance(silver, sphere) -> None:
    """Fitted at one incidence alone they miss by 3.5."""
    assert sphere_error(fit_material(Material("scattered", as_samples(silver.reflectance))), sphere) < 2.0


def test_what_sends_light_back_looks_as_its_reflectance(sphere) -> None:
    """With lobes about the mirror direction alone it misses by 4.9."""
    assert sphere_error(fit_material(Material("tape", Tape())), sphere) < 0.5


def test_facet_lobes_near_the_rim_and_dark_bases_look_as_their_reflectance(sphere) -> None:
    """Without lobes beside the mirror direction Opel Titan misses by .64, whose lobes are wide.

    And where all light counts as one, the dark base of Blue Matte is given up for its bright reflection: .52.
    """
    for paint, most in (("table1_opel_titan", 0.4), ("table1_blue_matte", 0.43)):
        assert sphere_error(fit_material(load_material(paint)), sphere) < most


@pytest.mark.parametrize("slope", [0.03, 0.02])
def test_a_polished_surface_without_a_base_keeps_its_peak(slope: float) -> None:
    """Away from the mirror direction it has nothing but the last of its peak, which must not count as a base does."""
    lobe = CookTorranceLobe(ks=(0.1, 0.1, 0.1), m=slope, r=0.5)
    polished = CookTorrance(CookTorrancePaint("polished", (0.0, 0.0, 0.0), (lobe,)))
    exponents = default_basis().exponents
    weights = seen_weights(polished, exponents)
    place = 54
    cosine = float(RAMP_COSINES[place])
    sine = np.sqrt(1.0 - cosine**2)
    true = polished.eval([sine, 0.0, cosine], [-sine, 0.0, cosine])[0] * cosine
    at = [look_up_table().find("gloss", e) for e in exponents]
    peaks = [f.amplitude[place] * (f.exponent[place] + 1.0) / (2.0 * np.pi) for f in at]
    assert float(np.dot(weights.kg[place, :, 0], peaks)) == pytest.approx(true, rel=0.2)


class DarkAtGrazing:
    """A grey sheet that is black where it is seen at more than 89.4°."""

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        seen = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.01)
        return np.where(seen, 0.3, 0.0)[..., None] * np.ones(3)


def test_an_angle_that_is_black_leaves_the_others_alone() -> None:
    weights = seen_weights(DarkAtGrazing(), default_basis().exponents)
    for place in (15, 33, 63):
        np.testing.assert_allclose(
            returned(weights, default_basis().exponents, place), 0.3 * np.pi, rtol=0.02
        )


def test_found_once_and_in_a_window_on_a_thread(silver) -> None:
    called = threading.Event()
    angles = PaintAngles(changed=called.set)
    given = angles.by_view(silver)
    assert given is not None
    assert given.weights() is None
    assert called.wait(60.0)
    found = given.weights()
    assert found is not None
    assert given.weights() is found
    angles.close()


def test_what_cannot_be_fitted_is_refused_and_reported(caplog: pytest.LogCaptureFixture) -> None:
    exponents = (2.0, 20.0, 1000.0)
    with pytest.raises(FittingError, match=r"red channel is negative .* with the view at"):
        seen_weights(Sheen(sign=-1.0), exponents)
    with caplog.at_level(logging.WARNING):
        assert SeenWeights(Sheen(sign=-1.0), exponents).weights() is None
    assert "one incidence" in caplog.text


def test_of_many_edits_the_newest_comes_first_and_those_no_longer_shown_never(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    found: list[float] = []
    begun, go_on, done = threading.Event(), threading.Event(), threading.Semaphore(0)

    def find(self: SeenWeights) -> None:
        begun.set()
        assert go_on.wait(60.0)
        found.append(self.exponents[-1])

    monkeypatch.setattr(SeenWeights, "find", find)
    queue = SeenQueue(done.release)
    first, *steps = (SeenWeights(Sheen(), (2.0, 20.0, 100.0 + n)) for n in range(10))
    queue.add(first)
    assert begun.wait(60.0)
    for step in steps:
        queue.add(step)
    shown = [steps[2], steps[-1]]
    del step, steps
    go_on.set()
    for _ in range(3):
        assert done.acquire(timeout=60.0)
    assert found == [first.exponents[-1], *(weights.exponents[-1] for weights in reversed(shown))]
    queue.close()


WHITE_BODIES = {
    "matt, glossy coat": lambda: Material("white", Coated(Lambertian(1.0), 1.5, 0.002)),
    "matt, matte coat": lambda: Material("white", Coated(Lambertian(1.0), 1.5, 0.6)),
    "metal": lambda: Material("white", Ggx(0.0, 1.0, 0.6)),
    "designed, glossy": lambda: load_material("solid_white"),
    "designed, satin": lambda: load_material("satin_white"),
    "designed, matte": lambda: load_material("matte_white"),
}


@pytest.mark.parametrize("name", WHITE_BODIES)
def test_constant_light_comes_back_in_real_time(name: str) -> None:
    """Every map of constant light is 1, so a pixel is the sum of its ramp's rows: within 2 % to 85°."""
    fit = fit_material(WHITE_BODIES[name]())
    angles = PaintAngles()
    angles.prepare(fit, View())
    weights = angles.weights(fit)
    ramp = make_ramp(weights, "raised", "shifted", Ladder((1.0, 8.0, 64.0)), weights.by_view)
    angles.close()
    for degrees in (0.0, 45.0, 70.0, 80.0, 85.0):
        cosine = float(np.cos(np.radians(degrees)))
        at = np.sqrt(RAMP_COSINES)
        found = [np.interp(np.sqrt(cosine), at, row) for row in ramp.rows[:, :, :3].sum(axis=0).T]
        np.testing.assert_allclose(found, directional(fit.reflectance, cosine), rtol=0.02)
