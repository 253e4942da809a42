"""The reference in the window: traced beside it, shown as its own picture, and gone without harm."""

from __future__ import annotations

import os
import signal
from dataclasses import replace

import numpy as np
import pytest
from brdf_viewer.tracing.section import rate_words
from brdf_viewer.tracing.trace_input import lit_part

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle


def choose(viewer, key: str) -> None:
    box = viewer.window.renderer.renderer
    box.activated.emit(box.findData(key))


def wait_picture(viewer, samples: int) -> None:
    viewer.qtbot.waitUntil(lambda: viewer.state.traced is not None and viewer.state.traced.samples >= samples)


def state(viewer) -> str:
    return viewer.window.renderer.state.text()


@pytest.fixture
def saved(tmp_path, monkeypatch):
    path = tmp_path / "blue"
    monkeypatch.setattr("brdf_viewer.controller.ask_target", lambda *_: str(path))
    return path.with_suffix(".exr")


def test_the_reference_refines_restarts_is_compared_saved_and_survived(saved, start, qtbot) -> None:
    pytest.importorskip("mitsuba")
    viewer = start(follow=False, size=(720, 520))
    qtbot.waitUntil(viewer.window.progress.isHidden)  # its strip takes height from the picture
    real = viewer.pixels().astype(int)
    viewer.window.renderer.samples.setValue(8)
    choose(viewer, "reference")
    assert "Real-time picture" in state(viewer)
    assert viewer.window.overlay.mark == state(viewer)
    assert (viewer.pixels() == real).all()
    wait_picture(viewer, 8)
    assert viewer.state.traced.done
    assert "8 samples" in state(viewer)
    assert "noise" in state(viewer)
    traced = viewer.pixels().astype(int)
    # The same place in the window: past the sphere, but for its edge, nothing differs; on it both are one blue.
    outside = viewer.state.traced.pixels[..., 3] == 0.0
    assert 0.2 < outside.mean() < 0.9
    assert (np.abs(traced - real)[outside] > 1).mean() < 0.005
    inside = viewer.state.traced.pixels[..., 3] == 1.0
    assert np.abs(traced - real)[inside].mean() < 12.0
    assert np.abs(traced - real)[inside].max() > 2
    # How it is shown begins nothing anew.
    picture = viewer.state.traced
    viewer.state.change_view(exposure_ev=1.0, background="grey")
    assert viewer.state.traced is picture
    assert viewer.pixels()[inside].mean() > traced[inside].mean() + 10
    # A is the reference, B the same paint in real time.
    viewer.controller.compare.set_mode("blink")
    viewer.controller.compare.close()
    assert viewer.messages() == {}
    assert viewer.window.compare.chooser.list.currentText() == "This paint in real time"
    assert viewer.window.overlay.labels[0].text == f"B  {viewer.state.fit.name}, real-time"
    second = viewer.pixels()
    viewer.controller.compare.flip()
    assert viewer.window.overlay.labels[0].text == f"A  {viewer.state.fit.name}, path-traced"
    assert np.abs(viewer.pixels().astype(int) - second)[inside].max() > 2
    viewer.controller.compare.set_mode("off")
    # What lights it does: the real-time picture is back at once, and says so.
    camera = replace(viewer.view.camera, azimuth_deg=80.0)
    viewer.state.change_view(camera=camera)
    assert viewer.state.traced is None
    assert "Real-time picture" in viewer.window.overlay.mark
    wait_picture(viewer, 8)
    # Saved with its variance; and the process may die without taking anything along.
    viewer.window.commands.save_traced.trigger()
    qtbot.waitUntil(saved.exists)
    qtbot.waitUntil(lambda: "Saved" in viewer.window.status.currentMessage())
    import OpenEXR

    with OpenEXR.File(str(saved), separate_channels=True) as file:
        channels = {name: np.asarray(c.pixels) for name, c in file.channels().items()}
    assert channels["R"].shape == viewer.state.traced.pixels.shape[:2]
    assert (channels["variance.G"][inside] > 0.0).mean() > 0.9
    np.testing.assert_allclose(channels["object.B"], viewer.state.traced.pixels[..., 2], rtol=1e-4, atol=1e-6)
    viewer.window.renderer.samples.setValue(0)  # without end
    assert not viewer.window.renderer.resume.isEnabled()
    wait_picture(viewer, 12)
    viewer.window.renderer.stop.click()
    assert "stopped" in state(viewer)
    assert viewer.window.renderer.resume.isEnabled()
    os.kill(viewer.controller.traced.process_id, signal.SIGKILL)
    qtbot.waitUntil(lambda: "traced" in viewer.messages())
    assert "crashed (signal 9)" in viewer.messages()["traced"]
    assert "The real-time picture continues." in viewer.messages()["traced"]
    assert viewer.state.renderer == "realtime"
    assert viewer.state.traced is None
    assert viewer.window.overlay.mark == ""
    assert viewer.window.renderer.renderer.currentData() == "realtime"
    assert viewer.pixels().std() > 5


def test_only_what_lights_a_picture_begins_it_anew() -> None:
    view = View()
    for fields in (
        {"exposure_ev": 2.0, "tone_curve": "linear"},
        {"background": "grey"},
        {"gamut_marks": True},
    ):
        assert lit_part(replace(view, **fields)) == lit_part(view)
    lit = (
        {"rotation_deg": 5.0},
        {"camera": replace(view.camera, azimuth_deg=1.0)},
        {"sparkle": Sparkle("off")},
    )
    for fields in lit:
        assert lit_part(replace(view, **fields)) != lit_part(view)


def test_a_rate_is_reported_in_what_says_more() -> None:
    assert rate_words(0.25) == "4 frames/s"
    assert rate_words(2.5) == "2.5 s a frame"
    assert rate_words(0.0) == ""
