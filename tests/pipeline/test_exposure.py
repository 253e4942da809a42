"""Automatic exposure brings the object's median luminance to 0.18, whatever the light and the paint."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.documents.view import Camera, View
from brdf_suite.files.images.environments import write_exr
from brdf_suite.pipeline.exposure import MIDDLE_GREY, automatic_ev, ev_of, exposed, metered
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment, load_surface

pytestmark = pytest.mark.usefixtures("shared_cache")
SIZE = (240, 160)


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory):
    """A sphere of blue paint, and a function that lights it evenly with a radiance; for all tests, without light."""
    folder = tmp_path_factory.mktemp("lights")
    with OffscreenScene() as scene:

        def light(radiance: float) -> None:
            path = folder / f"{radiance}.exr"
            write_exr(path, np.full((32, 64, 3), radiance, np.float32))
            scene.set_environment(load_environment(path))

        scene.set_surface(load_surface("sphere"))
        scene.set_material(fit_material(load_material("blue")))
        scene.light = light
        yield scene


def median_luminance(scene, view: View) -> float:
    picture = scene.renderer.linear_image(view, SIZE)
    inside = picture[picture[..., 3] > 0.99][:, :3]
    return float(np.median(inside @ LUMINANCE)) * 2.0**view.exposure_ev


@pytest.mark.parametrize("radiance", [0.02, 1.0, 300.0])
def test_the_median_is_middle_grey(scene, radiance: float) -> None:
    scene.light(radiance)
    view = View(surface="sphere", exposure_mode="automatic")
    shown = metered(scene.renderer, view, SIZE)
    assert shown.exposure_mode == "locked"
    assert median_luminance(scene, shown) == pytest.approx(MIDDLE_GREY, rel=0.02)
    brighter = metered(scene.renderer, replace(view, exposure_ev=1.5), SIZE)
    assert brighter.exposure_ev - shown.exposure_ev == pytest.approx(1.5)


def test_pictures_of_the_command_line_are_metered_too(scene) -> None:
    view = View(surface="sphere", exposure_mode="automatic", tone_curve="linear", background="grey")
    scene.light(0.05)
    dim = scene.image(view, SIZE)
    scene.light(20.0)
    bright = scene.image(view, SIZE)
    assert np.abs(dim.astype(int) - bright).max() <= 2
    locked = scene.image(replace(view, exposure_mode="locked"), SIZE)
    assert locked[80, 120].max() > bright[80, 120].max() + 20


def test_without_an_object_in_sight_the_exposure_stays(scene) -> None:
    scene.light(1.0)
    away = View(Camera(distance=1.0, target=(0.0, 500.0, 0.0)), surface="sphere", exposure_mode="automatic")
    assert automatic_ev(scene.renderer, away, SIZE) is None
    assert metered(scene.renderer, replace(away, exposure_ev=0.7), SIZE).exposure_ev == 0.7


def test_a_black_object_has_no_exposure() -> None:
    black = np.zeros((4, 4, 4), np.float32)
    black[..., 3] = 1.0
    assert ev_of(black) is None
    black[..., :3] = 1e-30
    assert ev_of(black) == 20.0


def test_a_locked_view_is_left_alone() -> None:
    view = View(exposure_ev=2.0)
    assert exposed(view, 5.0) is view
    assert exposed(replace(view, exposure_mode="automatic"), None).exposure_ev == 2.0
    assert exposed(replace(view, exposure_mode="automatic", exposure_ev=20.0), 20.0).exposure_ev == 24.0
