"""The shipped path-traced environments, and their generator at a size that takes seconds."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from environments.solids import bar, box, quad
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.lighting.lights import directional_lights
from brdf_suite.lighting.procedural.panorama import horizontal_illuminance, solid_angles
from brdf_suite.lighting.statistics import environment_statistics
from brdf_suite.pipeline.environments import read_environment, read_environment_file
from brdf_suite.pipeline.scene import environment_names, find_environment, narrowed


def directions_at(rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Unit directions (n, 3) at places 0…1 down and across a map."""
    theta, phi = np.pi * rows, 2.0 * np.pi * (columns - 0.5)
    return np.stack([-np.sin(theta) * np.sin(phi), np.cos(theta), np.sin(theta) * np.cos(phi)], axis=-1)


NAMES = ("photo_studio", "street", "light_tunnel")


@pytest.fixture(scope="module", params=NAMES)
def shipped(request):
    return read_environment_file(find_environment(request.param)[1])


def test_they_are_offered_first() -> None:
    assert environment_names() == [*NAMES, "booth", "overcast", "sunny"]


def test_a_shipped_map_is_whole(shipped) -> None:
    path = find_environment(shipped.environment.name)[1]
    radiance = shipped.environment.radiance
    assert (shipped.image_width, shipped.image_height) == (2048, 1024)
    assert path.stat().st_size <= 4_000_000
    assert np.isfinite(radiance).all()
    assert radiance.min() >= 0.0
    assert not shipped.environment.notes  # nothing had to be repaired
    # A white card that lies flat is 1; at the sun's edge half floats and compression take a little.
    assert horizontal_illuminance(radiance) / np.pi == pytest.approx(1.0, rel=0.01)


def test_a_shipped_map_has_no_seam(shipped) -> None:
    luminance = np.log(np.maximum(shipped.environment.radiance @ LUMINANCE, 1e-3))
    steps = np.abs(np.diff(luminance, axis=1, append=luminance[:, :1])).mean(axis=0)
    assert steps[-1] < 3.0 * np.median(steps)


def test_the_street_has_a_sun_and_a_sky() -> None:
    environment = read_environment(find_environment("street")[1])
    facts = environment_statistics(environment)
    assert facts.sun_elevation_deg == pytest.approx(40.0, abs=0.3)
    assert facts.sun_azimuth_deg == pytest.approx(24.0, abs=0.4)
    disc = environment.radiance @ LUMINANCE > 10_000.0
    areas = np.broadcast_to(solid_angles(1024), disc.shape)
    across = 2.0 * np.degrees(np.sqrt(areas[disc].sum() / np.pi))
    assert 0.4 < across < 0.75  # pixels are .18° wide
    beam = float((environment.radiance @ LUMINANCE * areas)[disc].sum()) * np.sin(np.radians(40.0)) / np.pi
    assert 0.6 < beam < 0.9  # of the white card's light; the rest is the sky's, .1 to .4 on a clear day
    first = directional_lights(environment, 16).directions[0]
    assert np.degrees(np.arcsin(first[1])) == pytest.approx(40.0, abs=1.0)


def test_the_generator_makes_the_shipped_light(tmp_path: Path) -> None:
    """At 32 rows blocks of pixels agree with the shipped map; a second call starts from the kept sums."""
    pytest.importorskip("mitsuba")
    from environments.scenes import trace

    name = "photo_studio"
    (*_, first) = trace(name, 32, 4, kept=tmp_path)
    (*_, last) = trace(name, 32, 16, kept=tmp_path)
    assert first.samples == 4
    assert 16 <= last.samples <= 20
    assert last.noise < 0.75 * first.noise
    assert last.most_noise <= first.most_noise
    environment = read_environment(find_environment(name)[1])
    small = narrowed(environment, 8).radiance @ LUMINANCE
    made = narrowed(replace(environment, radiance=last.environment.radiance), 8).radiance @ LUMINANCE
    assert np.median(np.abs(made / small - 1.0)) < 0.06
    last.write(tmp_path / "small.exr")
    written = read_environment(tmp_path / "small.exr")
    np.testing.assert_allclose(
        written.radiance, np.maximum(last.environment.radiance, 1e-3), rtol=0.05, atol=2e-3
    )
    assert "noise of a pixel below" in last.comment


@pytest.mark.parametrize("lamps", ["sky", "panel"])
def test_chosen_samples_bring_the_light_of_plain_paths(lamps: str) -> None:
    """Directions and places that are chosen for little noise have the mean of Mitsuba's own integrator."""
    pytest.importorskip("mitsuba")
    from environments import stage as built
    from environments import tracing

    from brdf_suite.reference.mitsuba_modules import mi
    from brdf_suite.reference.variant import start

    start()
    stage = built.Stage()
    stage.material("wall", built.matt())
    stage.material("pane", built.glazed())
    stage.add("wall", quad((-20, 0, 20), (40, 0, 0), (0, 0, -40), (0.3, 0.3, 0.3)))
    stage.add("wall", bar((3.0, 4.0), (0.0, 6.0), (-9.0, 9.0), (0.5, 0.4, 0.3)))
    stage.add("pane", bar((-4.0, -3.0), (0.0, 3.0), (-3.0, 3.0), (0.1, 0.1, 0.1)))
    emitters = {}
    if lamps == "sky":
        dome = np.full((64, 128, 3), 0.5, np.float32)
        dome[20:23, 20:24] = 200.0
        emitters["sky"] = {"type": "envmap", "bitmap": mi.Bitmap(dome)}
    else:
        stage.lamp(
            quad((-1, 4, -2), (0, 0, 4), (2, 0, 0)).moved(y=-8.0).turned(180.0, "x"),
            built.colour_of((5, 5, 5)),
        )
        middle, along, across = (
            np.array([0.0, 4.0, 0.0]),
            np.array([0.0, 0.0, 2.0]),
            np.array([1.0, 0.0, 0.0]),
        )
        stage.panels.append(built.Panel(middle, along, across))
    scene = mi.load_dict({"type": "scene", **stage.objects(), **emitters})
    light = tracing.Light(lamps, scene, 4, 1e9, tuple(stage.panels), directions=3 if lamps == "sky" else 0)
    made = (
        tracing.trace_pass(
            light, (0.0, 0.9, 0.0), 16, np.arange(512, dtype=np.uint32), np.zeros(512, np.uint32), 512, 0, 0
        ).reshape(16, 32, 3)
        / 512.0
    )
    camera = mi.load_dict({"type": "independent"})
    camera.seed(5, 16 * 32 * 2048)
    place = np.repeat(np.arange(16 * 32), 2048)
    random = np.random.default_rng(6)
    toward = directions_at(
        (place // 32 + random.random(place.size)) / 16, (place % 32 + random.random(place.size)) / 32
    )
    rays = mi.RayDifferential3f(mi.Point3f(0.0, 0.9, 0.0), mi.Vector3f(toward.T.astype(np.float32)))
    integrator = mi.load_dict({"type": "path", "max_depth": 4, "rr_depth": 99})
    found, _, _ = integrator.sample(scene, camera, rays)
    plain = np.array(found).T.reshape(16, 32, 2048, 3).mean(axis=2)
    assert plain[8:].mean() > 0.01
    assert made[8:].mean() == pytest.approx(plain[8:].mean(), rel=0.03)
    assert np.median(np.abs(made / np.maximum(plain, 1e-9) - 1.0)) < 0.08


@given(st.floats(1.0, 2.5), st.integers(0, 2**31))
def test_light_beyond_half_floats_stays_on_the_disc(factor: float, seed: int) -> None:
    pytest.importorskip("mitsuba")
    from environments import scenes

    random = np.random.default_rng(seed)
    pixels = random.uniform(0.0, 2.0, (16, 32, 3))
    pixels[4:8, 8:12] = random.uniform(21_000.0, 22_000.0, (4, 4, 3)) * factor
    pixels[5, 9] = 66_000.0 * min(factor, 1.2)
    result = scenes.within_half(pixels)
    assert result.max() <= 65_504.0
    areas = solid_angles(16)[..., None]
    np.testing.assert_allclose((result * areas).sum((0, 1)), (pixels * areas).sum((0, 1)), rtol=1e-6)
    assert np.array_equal(result[pixels < 10.0], pixels[pixels < 10.0])


@given(st.tuples(*[st.floats(0.2, 3.0)] * 3), st.floats(0.0, 0.08))
def test_a_box_with_cut_edges_is_closed_and_faces_outwards(
    size: tuple[float, float, float], bevel: float
) -> None:
    made = box(size, bevel=bevel)
    a, b, c = (made.points[made.faces[:, i]] for i in range(3))
    areas = 0.5 * np.cross(b - a, c - a)
    np.testing.assert_allclose(areas.sum(axis=0), 0.0, atol=1e-9)
    volume = float((areas * a).sum() / 3.0)
    x, y, z = size
    # Each of the twelve edges loses a prism of half a square, more where three meet.
    least = x * y * z - 2.0 * bevel**2 * (x + y + z)
    assert least - 1e-9 <= volume <= x * y * z + 1e-9
    assert made.points[:, 1].min() == pytest.approx(0.0, abs=1e-9)
