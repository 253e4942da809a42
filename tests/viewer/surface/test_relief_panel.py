"""The Relief section: orange peel, a normal map, and a second paint with its mask."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.documents.paint import OrangePeel
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook
from brdf_suite.pipeline.lobe_fit import PaintFitter


@pytest.fixture
def images(tmp_path: Path) -> dict[str, str]:
    normals = np.zeros((16, 16, 3), np.uint8)
    normals[..., 2] = 255
    normals[..., 0] = np.where(np.arange(16) < 8, 200, 55)
    normals[..., 1] = 128
    Image.fromarray(normals).save(tmp_path / "normals.png")
    Image.fromarray(np.repeat([[0], [255]], 8, axis=0).repeat(16, axis=1).astype(np.uint8)).save(
        tmp_path / "mask.png"
    )
    (tmp_path / "broken.png").write_bytes(b"no image")
    return {name: str(tmp_path / f"{name}.png") for name in ("normals", "mask", "broken")}


@pytest.fixture
def asked() -> list[str]:
    return []


@pytest.fixture
def ball(start, lights, asked):
    look = SurfaceLook(occlusion=False)
    view = View(environment=str(lights["dim"]), surface="sphere", surface_look=look, sparkle=Sparkle("off"))
    return start(view=view, ask=lambda _window, _kind: asked.pop())


def section(viewer):
    return viewer.window.relief


def wait_images(viewer, qtbot) -> None:
    qtbot.waitUntil(lambda: viewer.controller.relief.is_idle)


def test_orange_peel_is_seen_and_its_height_reported(ball) -> None:
    before = ball.pixels()
    section(ball).orange_peel.edited.emit(2.0)
    assert ball.view.relief.orange_peel == 2.0
    assert "µm" in section(ball).peel_facts.text()
    assert not np.array_equal(ball.pixels(), before)
    section(ball).orange_peel_mm.edited.emit(10.0)
    assert ball.view.relief.orange_peel_mm == 10.0
    section(ball).orange_peel.edited.emit(0.0)
    assert np.array_equal(ball.pixels(), before)


def test_a_paint_brings_its_own_orange_peel(ball, qtbot) -> None:
    state = ball.controller.state
    smooth, before = ball.pixels(), state.paint
    fitter = PaintFitter(time_limit_s=60.0)
    waved = replace(before, orange_peel=OrangePeel(14.0, 2.5))
    state.set_fit(fitter.fit(waved))
    fitter.close()
    own = ball.pixels()
    assert not np.array_equal(own, smooth)
    assert "The paint's own: 14 µm" in section(ball).peel_facts.text()
    # What the view sets takes its place.
    section(ball).orange_peel.edited.emit(1.0)
    assert not np.array_equal(ball.pixels(), own)
    assert "instead of the paint's own" in section(ball).peel_facts.text()
    section(ball).orange_peel.edited.emit(0.0)
    assert np.array_equal(ball.pixels(), own)


def test_a_normal_map_is_opened_and_taken_away(ball, images, asked, qtbot) -> None:
    before = ball.pixels()
    asked.append(images["normals"])
    section(ball).normal_map.open.click()
    assert ball.view.relief.normal_map == images["normals"]
    assert section(ball).normal_map.name.text() == "normals.png"
    wait_images(ball, qtbot)
    mapped = ball.pixels()
    assert not np.array_equal(mapped, before)
    section(ball).normal_width_mm.edited.emit(20.0)
    assert not np.array_equal(ball.pixels(), mapped)
    section(ball).normal_map.clear.click()
    assert ball.view.relief.normal_map is None
    assert np.array_equal(ball.pixels(), before)


@pytest.mark.usefixtures("four_samples")
def test_two_tone_wants_a_paint_and_a_mask(ball, images, asked, qtbot) -> None:
    before = ball.pixels().astype(int)
    own = section(ball)
    own.paint.chosen.emit("red")
    assert ball.view.two_tone.paint == "red"
    assert "mask" in own.two_tone_facts.text()
    asked.append(images["mask"])
    own.mask_file.open.click()
    own.projection.activated.emit(own.projection.findData("front"))
    assert not own.mask_width_mm.isEnabled()
    wait_images(ball, qtbot)
    after = ball.pixels().astype(int)
    columns = slice(before.shape[1] // 2 - 30, before.shape[1] // 2 + 30)
    rows = np.abs(after - before)[:, columns].max(axis=(1, 2))
    middle = len(rows) // 2
    # White is the lower half of the image: the second paint is in the lower half of the picture.
    assert rows[: middle - 20].max() <= 8  # at its rim a pixel sees much of the mask
    red = after[middle + 40 : middle + 80, :, 0] - after[middle + 40 : middle + 80, :, 2]
    assert red.max() > 15
    own.paint.chosen.emit("")
    assert ball.view.two_tone.paint is None
    assert np.array_equal(ball.pixels(), before)


def test_what_cannot_be_read_is_reported_and_the_picture_stays(ball, images, asked, qtbot) -> None:
    before = ball.pixels()
    asked.append(images["broken"])
    section(ball).normal_map.open.click()
    qtbot.waitUntil(lambda: "images" in ball.messages())
    assert "broken.png" in ball.messages()["images"]
    assert not ball.window.picture.failure
    section(ball).normal_map.clear.click()
    assert "images" not in ball.messages()
    qtbot.waitUntil(lambda: ball.pixels().shape == before.shape)
    assert np.array_equal(ball.pixels(), before)
