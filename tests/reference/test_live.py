"""A traced picture that follows an edit: what is changed in place is what a new scene would be."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, LightColour, PartMaterial, SurfaceLook, TwoTone
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.pipeline.material import load_shipped_paint, material_of

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (24, 20)


@pytest.fixture(scope="module")
def light(tmp_path_factory: pytest.TempPathFactory) -> Path:
    d = direction(ring_angles(16)[:, None], column_angles(32)[None])
    path = tmp_path_factory.mktemp("light") / "soft.exr"
    write_exr(path, np.asarray(1.0 + 0.8 * d, np.float32))
    return path


@pytest.fixture(scope="module")
def live(variant):
    from brdf_suite.tracing.reference.live import LiveReference

    return LiveReference()


def fresh(paint, view, size):
    """What a scene that is built anew gives."""
    from brdf_suite.tracing.reference.live import LiveReference

    other = LiveReference()
    other.show(paint, view, size)
    return other.step()


def test_every_change_gives_what_a_new_scene_gives(live, light) -> None:
    view = View(environment=str(light), surface="sphere", background="grey")
    copper = load_shipped_paint("copper")
    chrome = SurfaceLook(materials=(PartMaterial("sphere", "chrome"),))
    live.show("copper", view, SIZE)
    steps = [
        ("blue", view, SIZE),
        (
            material_of(replace(copper, near_specular=1.5)),
            replace(view, camera=Camera(120.0, 30.0), rotation_deg=50.0),
            SIZE,
        ),
        ("copper", replace(view, light_colour=LightColour("A", adapted=False)), (30, 16)),
        ("copper", replace(view, lamps=(Lamp(),), surface_look=chrome), SIZE),
    ]
    for paint, shown, size in steps:
        assert live.show(paint, shown, size) == "light"
        found = live.step()
        assert found.samples == 1
        wanted = fresh(paint, shown, size)
        assert found.radiance.shape == (size[1], size[0], 3)
        np.testing.assert_allclose(found.radiance, wanted.radiance, rtol=1e-4, atol=1e-5)


def test_a_part_of_the_second_paint_looks_like_that_paint(live, light) -> None:
    worn = SurfaceLook(materials=(PartMaterial("sphere", "second_paint"),))
    view = View(environment=str(light), surface="sphere", background="grey", surface_look=worn)
    two = TwoTone(paint="copper")
    for first, shown, like in (
        ("blue", replace(view, two_tone=two), "copper"),
        ("blue", view, "blue"),  # without a second paint it is the first
        ("copper", replace(view, two_tone=TwoTone(paint="blue")), "blue"),
    ):
        live.show(first, shown, SIZE)
        wanted = fresh(like, replace(shown, surface_look=SurfaceLook()), SIZE)
        np.testing.assert_allclose(live.step().radiance, wanted.radiance, rtol=1e-4, atol=1e-5)


def test_what_changes_no_light_keeps_the_estimate(live, light) -> None:
    view = View(environment=str(light), surface="sphere", background="grey")
    live.show("blue", view, SIZE)
    assert live.show("copper", view, SIZE) == "light"
    for _ in range(5):
        estimate = live.step()
    assert (estimate.samples, estimate.passes) == (24, 5)
    assert 0.0 < estimate.noise < 1.0
    assert live.show("copper", view, SIZE) == "nothing"
    before = live.codes()
    assert live.show("copper", replace(view, exposure_ev=-2.0), SIZE) == "shown"
    inside = estimate.coverage == 1.0
    assert live.codes()[inside].mean() < before[inside].mean() - 5.0
    assert live.estimate is estimate


def test_a_scene_that_cannot_be_leaves_the_last_one(live, light, tmp_path: Path) -> None:
    view = View(environment=str(light), surface="sphere", background="grey")
    live.show("copper", view, SIZE)
    estimate = live.step()
    with pytest.raises(FileError):
        live.show("no_such_paint", view, SIZE)
    with pytest.raises(FileError):
        live.show("copper", replace(view, environment=str(tmp_path / "none.exr")), SIZE)
    assert live.estimate is estimate
    assert live.step().passes == estimate.passes + 1
    assert live.scene.name == "Copper"


def test_a_file_that_was_written_anew_is_read_anew(live, tmp_path: Path) -> None:
    path = tmp_path / "light.exr"
    view = View(environment=str(path), surface="sphere", background="grey")
    means = []
    for value in (1.0, 2.0):
        write_exr(path, np.full((8, 16, 3), value, np.float32))
        path.touch()
        live.show("copper", view, SIZE)
        means.append(live.step().radiance.mean())
    assert means[1] == pytest.approx(2.0 * means[0], rel=0.01)


def test_without_a_scene_there_is_nothing_to_see(variant) -> None:
    from brdf_suite.tracing.reference.live import LiveReference

    empty = LiveReference()
    for ask in (empty.step, empty.codes, lambda: empty.scene):
        with pytest.raises(SuiteError):
            ask()
