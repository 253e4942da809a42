"""Names from files are plain text all over the Viewer, and a wheel that passes over its fields changes nothing."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
from brdf_qt.link.link import LiveLink
from brdf_qt.window.dialogs import Answer
from PIL import Image

from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import paint_to_json, save_paint
from brdf_suite.documents.studio import Backdrop, Studio, StudioLamp, save_light
from brdf_suite.pipeline.material import load_document, load_shipped_paint


def open_and_wait(viewer, kind: str, path: Path) -> None:
    viewer.controller.scene.open(kind, str(path))
    viewer.qtbot.waitUntil(lambda: getattr(viewer.view, kind) == str(path))
    viewer.wait_idle()


def test_names_are_plain_text_in_the_whole_window(start, lights, walks, qtbot, tmp_path: Path) -> None:
    chosen: list[str] = []
    viewer = start(ask=lambda _window, _kind: chosen.pop())
    copper = replace(load_shipped_paint("copper"), name=walks.HOSTILE)
    paint = tmp_path / f"{walks.HOSTILE_FILE}.brdfpaint"
    save_paint(copper, paint)
    viewer.controller.paint.open(str(paint))
    viewer.wait_idle()
    viewer.controller.compare.freeze()
    lobes = tmp_path / f"{walks.HOSTILE_FILE} lobes.brdfpaint"
    save_paint(replace(load_document("table1_blue"), name=walks.HOSTILE), lobes)
    viewer.controller.paint.open(str(lobes))
    viewer.wait_idle()
    palette = tmp_path / f"{walks.HOSTILE_FILE}.brdfpalette"
    save_palette(Palette(walks.HOSTILE, (Entry(copper),)), palette)
    viewer.controller.paint.open_palette(str(palette))
    viewer.wait_idle()
    light = tmp_path / f"{walks.HOSTILE_FILE}.exr"
    shutil.copy(lights["dim"], light)
    open_and_wait(viewer, "environment", light)
    mesh = tmp_path / f"{walks.HOSTILE_FILE}.obj"
    mesh.write_text(
        f"o {walks.HOSTILE}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl {walks.HOSTILE}\n"
        "f 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"
    )
    open_and_wait(viewer, "surface", mesh)
    normals = tmp_path / f"{walks.HOSTILE_FILE}.png"
    Image.fromarray(np.full((4, 4, 3), (128, 128, 255), np.uint8)).save(normals)
    chosen.append(str(normals))
    viewer.window.relief.normal_map.open.click()
    for missing in ("none.brdfpaint", "none.exr", "none.obj"):  # reported in messages, with their names
        viewer.controller.open_file(str(tmp_path / f"{walks.HOSTILE_FILE} {missing}"))
        viewer.wait_idle()
    viewer.wait_idle()
    viewer.controller.export.dialog.open_for("picture")
    designer = LiveLink("designer")
    designer.start()
    try:
        qtbot.waitUntil(lambda: "designer" in viewer.controller.link.peers)
        designer.publish("paint", paint_to_json(copper))
        qtbot.waitUntil(lambda: viewer.controller.paint.of_designer is not None)
        wrong, seen = walks.drawn_as_html()
    finally:
        designer.close()
    assert wrong == []
    assert seen > 10


class Discard:
    """Gives up unsaved changes."""

    def unsaved(self, name: str) -> Answer:
        return Answer.DISCARD


def test_a_wheel_changes_nothing_in_the_window(start, walks, tmp_path: Path) -> None:
    path = tmp_path / f"{walks.HOSTILE_FILE}.brdfstudio"
    lamp = StudioLamp("box", (0.0, 2.0, 2.0), (1.0, 1.0))
    save_light(Studio(walks.HOSTILE, (lamp,), None, Backdrop(luminance=0.2)), path)
    viewer = start(dialogs=Discard())
    viewer.controller.open_file(str(path))
    viewer.wait_idle()
    viewer.window.environment.edit.click()
    viewer.wait_idle()
    assert walks.drawn_as_html()[0] == []
    view, light = viewer.view, viewer.controller.studio.store.value
    changed, count = walks.changed_by_wheel(viewer.window)
    assert changed == []
    assert count > 40
    viewer.controller.export.dialog.open_for("turntable")
    changed, count = walks.changed_by_wheel(viewer.controller.export.dialog)
    assert changed == []
    assert count > 5
    assert (viewer.view, viewer.controller.studio.store.value) == (view, light)
