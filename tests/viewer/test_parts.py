"""The parts that need no window."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.choosing.picker import SourceChooser
from brdf_qt.choosing.sources import Source
from brdf_qt.documents.recent_files import MOST_RECENT, RecentFiles
from brdf_qt.fields.choices import SliderField
from brdf_qt.program.names import title_of
from brdf_qt.window.view_titles import PRESETS
from brdf_viewer.camera.section import look_from, signed_deg
from brdf_viewer.compare import frozen_paints
from brdf_viewer.compare.frozen_paints import freeze, touch
from brdf_viewer.documents.file_kinds import kind_of
from brdf_viewer.paint.patches import PaintPatches
from brdf_viewer.scene.viewer_state import ViewerState
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.documents.factor_textures import write_textures
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import load_any_paint
from brdf_suite.documents.view import Camera, View
from brdf_suite.fitting.metrics import AngleError
from brdf_suite.output.turning import turned

RED, GREY = solid_paint("red", (45.0, 60.0, 40.0)), solid_paint("grey", (50.0, 0.0, 0.0))


@given(st.floats(-1e6, 1e6))
def test_signed_deg_is_the_same_angle_within_half_a_turn(angle) -> None:
    signed = signed_deg(angle)
    assert -180.0 <= signed <= 180.0
    assert (signed - angle + 180.0) % 360.0 == pytest.approx(180.0, abs=1e-6)


@given(st.floats(-170, 170), st.floats(-400, 400))
@settings(max_examples=settings.default.max_examples // 2)
def test_the_turntable_turns_camera_and_light_together(rotation, degrees) -> None:
    view = View(camera=Camera(azimuth_deg=10.0, distance=2.0), rotation_deg=rotation)
    after = turned(view, degrees)
    assert dataclasses.replace(after, camera=view.camera, rotation_deg=rotation) == view
    by_camera = after.camera.azimuth_deg - view.camera.azimuth_deg
    by_light = after.rotation_deg - rotation
    assert (by_camera - by_light + 180.0) % 360.0 == pytest.approx(180.0, abs=1e-6)
    assert (by_camera + degrees + 180.0) % 360.0 == pytest.approx(180.0, abs=1e-6)


def test_presets_frame_the_surface_and_keep_the_lens() -> None:
    camera = Camera(distance=3.0, target=(1.0, 2.0, 3.0), focal_length_mm=85.0)
    for preset in PRESETS:
        seen = look_from(camera, preset)
        assert (seen.distance, seen.target, seen.focal_length_mm) == (None, None, 85.0)


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("a.EXR", "environment"),
        ("b.hdr", "environment"),
        ("c.glb", "surface"),
        ("d.brdfpaint", "paint"),
        ("f.BSDF", "paint"),
        ("g.brdfpalette", "palette"),
        ("h.brdfview", "view"),
        ("e.doc", None),
    ],
)
def test_a_files_kind(path, kind) -> None:
    assert kind_of(path) == kind


def test_the_state_reports_only_changes(qtbot) -> None:
    state = ViewerState(View())
    seen = []
    state.view_changed.connect(lambda old, new: seen.append((old.exposure_ev, new.exposure_ev)))
    state.change_view(exposure_ev=0.0)
    state.change_view(exposure_ev=1.0)
    assert seen == [(0.0, 1.0)]


def test_recent_files_are_newest_first_once_and_present(qapp, tmp_path) -> None:
    recent = RecentFiles("recent/environment")
    files = [tmp_path / f"{n}.exr" for n in range(MOST_RECENT + 3)]
    for file in files:
        file.touch()
        recent.add(str(file))
    recent.add(str(files[5]))
    files[7].unlink()
    paths = recent.paths()
    assert paths[0] == str(files[5])
    assert len(paths) == len(set(paths)) == MOST_RECENT - 1
    assert str(files[7]) not in paths
    recent.clear()
    assert recent.paths() == []


def test_a_chooser_keeps_its_choice_and_adds_what_it_does_not_know(qtbot) -> None:
    chooser = SourceChooser("open")
    qtbot.addWidget(chooser)
    chosen = []
    chooser.chosen.connect(chosen.append)
    chooser.set_sources([Source("a", "A"), Source("b", "B")], [])
    chooser.show_source("b", "B")
    chooser.set_sources([Source("a", "A"), Source("b", "B")], [Source("/x/c.exr", "c.exr")])
    assert chooser.list.currentData() == "b"
    chooser.show_source("/y/d.exr", "d.exr")
    assert chooser.list.currentText() == "d.exr"
    assert chosen == []
    chooser.list.activated.emit(0)
    assert chosen == ["a"]


def test_titles() -> None:
    assert title_of("booth") == "Light booth"
    assert title_of("/a/b/studio.hdr") == "studio.hdr"
    assert title_of("blue_metallic") == "Blue metallic"


def test_slider_and_number_are_one_value(qtbot) -> None:
    field = SliderField("Exposure", "EV", -8.0, 8.0, 0.1, 2, 0.0)
    qtbot.addWidget(field)
    edits = []
    field.edited.connect(edits.append)
    field.set_value(1.5)
    assert (field.slider.value(), edits) == (15, [])
    field.slider.setValue(-20)
    field.number.setValue(0.25)
    assert edits == pytest.approx([-2.0, 0.25])
    assert field.slider.value() in (2, 3)


def test_patches_are_ordered_and_thinned_and_show_the_colours(qtbot) -> None:
    patches = PaintPatches()
    qtbot.addWidget(patches)
    patches.resize(300, 90)
    row = [AngleError(45.0, angle, (50.0, 0.0, 0.0), (50.0, 0.0, 0.0), 0.0) for angle in (110.0, 15.0, 45.0)]
    patches.set_patches(row)
    assert [p.aspecular_deg for p in patches.patches] == [15.0, 45.0, 110.0]
    colour = patches.grab().toImage().pixelColor(10, 10)
    assert abs(colour.red() - 119) <= 1
    assert colour.red() == colour.green() == colour.blue()
    patches.set_patches(
        [AngleError(45.0, float(a), (50.0, 0.0, 0.0), (50.0, 0.0, 0.0), 0.0) for a in range(30)]
    )
    assert len(patches.patches) == 6
    assert (patches.patches[0].aspecular_deg, patches.patches[-1].aspecular_deg) == (0.0, 29.0)


def test_patches_name_the_light_where_there_are_two(qtbot) -> None:
    patches = PaintPatches()
    qtbot.addWidget(patches)
    grey = (50.0, 0.0, 0.0)
    one = [AngleError(45.0, angle, grey, grey, 0.0) for angle in (110.0, 15.0, 45.0)]
    patches.set_patches(one)
    assert not patches.names_lights
    height = patches.minimumHeight()
    second = [AngleError(15.0, angle, grey, grey, 0.0) for angle in (45.0, 15.0)]
    patches.set_patches([*one, *second])
    shown = [(patch.illumination_deg, patch.aspecular_deg) for patch in patches.patches]
    assert shown == [(15.0, 15.0), (15.0, 45.0), (45.0, 15.0), (45.0, 45.0), (45.0, 110.0)]
    assert patches.minimumHeight() > height
    assert "Light 15°, aspecular 45°" in patches.accessibleDescription()
    patches.resize(240, patches.minimumHeight())
    patches.show()
    assert not patches.grab().isNull()
    patches.set_patches(one)
    assert patches.minimumHeight() == height


def test_a_frozen_paint_on_show_is_kept_however_old_it_is(qapp, monkeypatch) -> None:
    monkeypatch.setattr(frozen_paints, "MOST_KEPT", 2)
    keys = []
    for number in range(5):
        paint = solid_paint(f"red {number}", (50.0, 10.0 * number, 0.0))
        keys.append(freeze(paint, "", used=keys[:1]))
        os.utime(keys[-1], (1e9 + number, 1e9 + number))
    assert [Path(key).exists() for key in keys] == [True, False, False, True, True]
    touch(keys[3])  # it is looked at again, and so the fourth goes before it
    freeze(solid_paint("green", (50.0, -10.0, 0.0)), "", used=keys[:1])
    assert [Path(key).exists() for key in keys] == [True, False, False, True, False]


def test_a_frozen_factored_paint_takes_its_textures_along_and_away(qapp, monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setattr(frozen_paints, "MOST_KEPT", 1)
    maps = {"p": np.full((4, 3), 0.5, np.float32), "q": np.ones((4, 3), np.float32)}
    textures = write_textures(maps, tmp_path / "satin.brdfpaint")
    first = Path(freeze(FactoredPaint("satin", textures, "p:|wo| q:|h| p:|wi|", (0.1, 0.2, 0.3)), ""))
    copies = list(first.parent.glob("satin-*.exr"))
    assert len(copies) == 1
    assert load_any_paint(first).textures.path == str(copies[0])
    os.utime(first, (1e9, 1e9))
    freeze(solid_paint("green", (50.0, -10.0, 0.0)), "")
    assert not first.exists()
    assert not copies[0].exists()
    assert Path(textures.path).exists()
