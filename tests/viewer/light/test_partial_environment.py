"""An environment that is being filtered is shown as soon as its broad lobes are there, and marked until it is whole."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.work import scene_loading as loading
from brdf_viewer.light.environment_section import environment_facts

from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.store import save_paint
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.errors import GraphicsError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.pipeline.scene import PreparedEnvironment, load_environment
from brdf_suite.progress import report


class HeldAfterFirst:
    """Stands before the real loading, and holds it once its first partial result was handed out."""

    def __init__(self) -> None:
        self.go_on = threading.Event()
        self.hold = True

    def __call__(self, key: str, progress, *, layout: str, basis, partial) -> PreparedEnvironment:
        def held(value: PreparedEnvironment) -> None:
            partial(value)
            while self.hold and not self.go_on.wait(0.01):
                report(progress, 0.5, "held")  # raises where it was cancelled

        return load_environment(key, progress, layout=layout, basis=basis, partial=held)


@pytest.fixture
def held(monkeypatch: pytest.MonkeyPatch) -> Iterator[HeldAfterFirst]:
    gate = HeldAfterFirst()
    monkeypatch.setattr(loading, "load_environment", gate)
    yield gate
    gate.go_on.set()


@pytest.fixture
def light(tmp_path: Path) -> Callable[[int], Path]:
    """Write a map of 256 rings that no test has filtered before: a bright lamp in a dim room."""

    def write(seed: int) -> Path:
        pixels = np.random.default_rng(seed).random((256, 512, 3), np.float32) * 0.4
        pixels[40:90, 150:230] = 9.0
        path = tmp_path / f"light{seed}.exr"
        write_exr(path, pixels)
        return path

    return write


def is_partial(viewer) -> bool:
    present = viewer.state.environment
    return present is not None and not present.value.is_final


def test_the_first_picture_comes_early_and_is_near_the_last(start, held, light, tmp_path, qtbot) -> None:
    paint = tmp_path / "matt.brdfpaint"
    save_paint(solid_paint("Matt", (60.0, 20.0, 10.0), Gloss(2.0)), paint)
    view = View(environment=str(light(1)), surface="sphere", sparkle=Sparkle("off"))
    viewer = start(paint=str(paint), view=view, wait=False)
    complete = []
    viewer.controller.picture_complete.connect(lambda: complete.append(True))
    qtbot.waitUntil(lambda: is_partial(viewer) and viewer.controller.drawer is not None, timeout=60_000)
    qtbot.waitUntil(lambda: viewer.state.fit is not None and viewer.state.surface is not None, timeout=60_000)
    assert np.ptp(viewer.pixels()) > 50  # a picture, not the grey of an empty window
    part = viewer.state.environment
    cell = viewer.window.status.cell("environment")
    wanted = part.value.wanted
    assert cell.text() == f"(light1.exr, maps {wanted - 1} of {wanted})"
    assert "Refining reflections" in viewer.window.environment.facts.text()
    qtbot.waitUntil(viewer.window.progress.isVisible, timeout=5000)
    assert not viewer.state.is_complete
    assert complete == []
    held.go_on.set()
    viewer.wait_idle()
    qtbot.waitUntil(lambda: complete == [True], timeout=20_000)
    assert not is_partial(viewer)
    assert cell.text() == "light1.exr"
    assert "Refining reflections" not in viewer.window.environment.facts.text()
    whole = viewer.pixels().astype(int)
    viewer.state.set_environment(part.key, part.value)  # again, in a picture of the same size
    assert np.abs(viewer.pixels() - whole).mean() < 1.0


def test_cancel_brings_the_whole_picture_back(start, held, light, qtbot) -> None:
    held.hold = False
    viewer = start(view=View(environment=str(light(2)), surface="sphere", sparkle=Sparkle("off")))
    before, view, facts = viewer.pixels(), viewer.view, viewer.window.environment.facts.text()
    held.hold = True
    viewer.controller.open_file(str(light(3)))
    qtbot.waitUntil(lambda: is_partial(viewer), timeout=60_000)
    assert viewer.view == view  # it names what is whole
    assert not np.array_equal(viewer.pixels()[:40], before[:40])
    viewer.controller.scene.cancel("environment")
    assert viewer.state.environment.key == view.environment
    assert viewer.state.is_complete
    assert viewer.window.environment.facts.text() == facts
    assert viewer.window.status.cell("environment").text() == "light2.exr"
    qtbot.waitUntil(lambda: viewer.pixels().shape == before.shape, timeout=5000)
    assert np.array_equal(viewer.pixels(), before)


def test_cancel_of_the_first_keeps_what_is_there_and_says_so(start, held, light, qtbot) -> None:
    viewer = start(view=View(environment=str(light(4)), surface="sphere", sparkle=Sparkle("off")), wait=False)
    qtbot.waitUntil(lambda: is_partial(viewer), timeout=60_000)
    viewer.controller.scene.cancel("environment")
    assert is_partial(viewer)
    assert "Select the light again" in viewer.window.environment.facts.text()
    assert "light4.exr, maps" in viewer.window.status.cell("environment").text()
    held.go_on.set()
    with qtbot.waitSignal(viewer.controller.picture_complete, timeout=60_000):
        viewer.controller.scene.open("environment", viewer.view.environment)


def test_a_stale_part_is_dropped(start, held, light, lights, qtbot) -> None:
    held.hold = False
    viewer = start()
    held.hold = True
    seen = []
    viewer.state.contents_changed.connect(lambda: seen.append(viewer.state.environment.key))
    old, loader = str(light(5)), viewer.controller.scene.loader
    viewer.controller.open_file(old)
    generation, part = loader.generation, viewer.state.environment.value
    viewer.controller.open_file(str(lights["bright"]))
    loader.partly_made.emit(generation, old, part)  # as the worker's, posted before it noticed
    held.go_on.set()
    viewer.wait_idle()
    assert viewer.state.environment.key == str(lights["bright"])
    assert old not in seen


def test_a_refused_part_ends_the_loading(start, held, light, qtbot) -> None:
    held.hold = False
    viewer = start()
    held.hold = True
    environment = viewer.state.environment.value
    upload = viewer.controller.drawer.uploads["environment"]

    def refuse(prepared: object) -> None:
        if getattr(prepared, "value", prepared) is not environment:
            raise GraphicsError("The graphics driver failed while making a texture: GL_OUT_OF_MEMORY.")
        upload(prepared)

    viewer.controller.drawer.uploads["environment"] = refuse
    viewer.controller.open_file(str(light(6)))
    qtbot.waitUntil(lambda: "environment" in viewer.messages(), timeout=60_000)
    assert viewer.controller.scene.is_idle
    assert viewer.state.environment.value is environment
    assert viewer.state.is_complete


def test_what_was_repaired_and_what_the_cache_says_is_reported(start, tmp_path, monkeypatch) -> None:
    pixels = np.full((32, 64, 3), 0.5, np.float32)
    pixels[3, 4] = np.nan
    path = tmp_path / "broken.exr"
    write_exr(path, pixels)
    (tmp_path / "no_folder").write_text("a file where the cache's folder should be")
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path / "no_folder"))
    viewer = start(view=View(environment=str(path), surface="sphere", sparkle=Sparkle("off")))
    text = viewer.window.environment.facts.text()
    assert "NaN" in text
    assert "no_folder" in text
    assert text == environment_facts(viewer.state.environment.value, False)
