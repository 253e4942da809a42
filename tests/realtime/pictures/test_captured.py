"""A form drawn once and shaded with many paints gives the pictures that each of them gives alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Relief
from brdf_suite.errors import ValueRangeError
from brdf_suite.realtime.lights.block import DistantLights
from brdf_suite.realtime.pictures.captured import CapturedPaint, unique_places
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.realtime.pictures.renderer import Renderer

SIZE = (40, 36)
VIEW = View(camera=Camera(20.0, 15.0), background="colour")


@pytest.fixture
def scene(renderer: Renderer, scenes) -> Renderer:
    """A finely meshed sphere before a sheet of another material, in a light with a sharp edge and one lamp afar."""
    renderer.set_mesh([scenes.sphere(rings=64), scenes.sheet("trim", 0.07, (0.0, 0.0, 0.12))])
    light = scenes.from_function(lambda d: np.where(d[..., :1] > 0.2, [3.0, 2.0, 1.0], [0.1, 0.2, 0.4]))
    lights = DistantLights(np.array([[0.0, 0.6, 0.8]]), np.array([[40.0, 40.0, 40.0]]), np.array([0.02]))
    renderer.set_environment(light, lambda: lights)
    return renderer


def swatches(scenes) -> list[CapturedPaint]:
    """Paints of different kinds and numbers of look-ups; the last sparkles."""
    base = scenes.weights(kd=0.3, gloss=0.05, directional=0.4)
    return [
        CapturedPaint(base),
        CapturedPaint(scenes.weights(kd=0.6)),
        CapturedPaint(scenes.weights(kd=0.05, gloss=0.9, coat="metal")),
        CapturedPaint(base, Flakes(4.0, 400.0, 0.2)),
    ]


@pytest.mark.parametrize("samples", [4, 1])
def test_pictures_are_those_that_the_renderer_draws_one_by_one(scene: Renderer, scenes, samples: int) -> None:
    paints = swatches(scenes)
    form = scene.capture(VIEW, SIZE, samples)
    pictures = form.draw(paints)
    assert pictures.shape == (len(paints), SIZE[1], SIZE[0], 3)
    for picture, paint in zip(pictures, paints, strict=True):
        scene.set_material("paint", paint.weights)
        scene.set_flakes("paint", paint.flakes)
        alone = scene.render_image(VIEW, SIZE, samples)
        # A driver may compile the same sums into other roundings; here they are the same.
        assert np.abs(picture.astype(int) - alone).max() <= 1
        assert np.abs(picture.astype(int) - alone).mean() < 0.01
    # Flakes are seen, and paints differ.
    assert np.abs(pictures[3].astype(int) - pictures[0]).max() > 8
    assert len({picture.tobytes() for picture in pictures}) == len(paints)
    form.release()


def test_paint_behind_a_pane_and_beside_a_gap_is_what_the_renderer_draws(renderer: Renderer, scenes) -> None:
    gap = replace(
        scenes.sheet("gap", 0.05, (0.0, 0.03, 0.13)), uvs=np.array([[-50, 0], [50, 0], [50, 9], [-50, 9]])
    )
    paint = replace(scenes.sheet("paint", 0.09, (0.02, 0.0, 0.12)), uvs=np.zeros((4, 2)))
    pane = scenes.sheet("glass", 0.05, (0.03, 0.0, 0.16))
    renderer.set_mesh([scenes.sphere(rings=32), paint, gap, pane])
    renderer.set_environment(scenes.constant())
    form = renderer.capture(VIEW, SIZE, 4)
    for weights in (scenes.weights(kd=0.7), scenes.weights(kd=0.1, gloss=0.05)):
        (picture,) = form.draw([CapturedPaint(weights)])
        renderer.set_material("paint", weights)
        alone = renderer.render_image(VIEW, SIZE, 4)
        assert np.abs(picture.astype(int) - alone).max() <= 1
    form.release()


def test_a_batch_of_any_number_is_drawn(scene: Renderer, scenes) -> None:
    form = scene.capture(VIEW, (8, 8))
    kds = np.linspace(0.05, 0.9, form.most + 3)
    pictures = form.draw([CapturedPaint(scenes.weights(kd=float(kd))) for kd in kds])
    middle = pictures[:, 2, 5].sum(axis=-1)
    assert len(pictures) == len(kds)
    assert (np.diff(middle.astype(int)) >= 0).all()
    assert middle[-1] > middle[0] + 100
    assert form.draw([]).shape == (0, 8, 8, 3)
    form.release()


def test_a_form_without_the_paint_is_what_is_there(scene: Renderer, scenes) -> None:
    scene.set_mesh([scenes.sheet("trim")])
    form = scene.capture(VIEW, SIZE)
    assert form.places == 0
    (picture,) = form.draw([CapturedPaint(scenes.weights(kd=0.5))])
    assert (picture == scene.render_image(VIEW, SIZE)).all()
    form.release()


@pytest.mark.parametrize(
    ("view", "size"),
    [
        (replace(VIEW, lamps=(Lamp(),)), SIZE),
        (replace(VIEW, relief=Relief(orange_peel=0.3)), SIZE),
        (VIEW, (513, 8)),
    ],
)
def test_what_belongs_to_one_picture_is_refused(scene: Renderer, view: View, size: tuple[int, int]) -> None:
    with pytest.raises(ValueRangeError):
        scene.capture(view, size)


def test_radiance_is_not_drawn_in_batches(scene: Renderer) -> None:
    form = scene.capture(VIEW, (8, 8))
    with pytest.raises(ValueRangeError, match="8 bits"):
        form.draw([], LINEAR)
    form.release()


def test_samples_of_one_fragment_share_a_place() -> None:
    places = np.zeros((8, 1, 2, 4, 4), np.float32)
    places[0, 0, 0, :, 3] = [1.0, 1.0, 1.0, 2.0]
    places[1, 0, 0, :, 0] = [0.5, 0.7, 0.5, 0.5]
    rows, index = unique_places(places)
    assert index[0].tolist() == [[0.0, 1.0, 0.0, -1.0], [-1.0] * 4]
    assert rows.shape == (2, 8, 4)
    assert rows[:, 1, 0].tolist() == pytest.approx([0.5, 0.7])
