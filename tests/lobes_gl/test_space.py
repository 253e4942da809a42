"""What is seen: the lobe where the mirror direction is, spikes, holes, nothing; gestures; pictures of any size."""

from __future__ import annotations

import threading
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest
import trimesh
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial, SamplePoints
from brdf_lobe_visualizer.view3d.camera import Camera, format_camera, parse_camera
from brdf_qt.program import theme
from PIL import Image
from PySide6.QtCore import QCoreApplication, QPoint, QPointF, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import mirror, spherical
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.cosine_lobes import CosineLobes
from brdf_suite.reflectance.registry import MODELS

RED = (0.9, 0.15, 0.1)


def shown(space, *subjects: PlottedMaterial) -> QImage:
    """Put subjects in the session and return the picture of the view, without the frame about the lobes."""
    space.state.set(hemisphere=False, labels=False, arrows=False, rings=False, colouring="line")
    space.session.set_subjects(subjects)
    return picture(space)


def picture(space) -> QImage:
    settle(space)
    return space.view.grabFramebuffer()


def settle(space) -> None:
    """Draw what was asked for; what took long once comes from another thread."""
    space.draw_now()
    while not space.is_idle:
        QCoreApplication.processEvents()


def pixels(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_RGB32)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine() // 4, 4)
    return rows[:, : image.width(), 2::-1].astype(int)


def red_of(image: QImage) -> np.ndarray:
    """Where a lobe in RED is: the ground is grey."""
    rgb = pixels(image)
    seen = rgb[..., 0] - rgb[..., 1] > 25
    seen[:30] = False  # the sign of the legend beside the title
    return seen


def spot(space, place) -> tuple[int, int]:
    """Row and column of a place of the local frame in a picture of the view."""
    at = space.view.project(tuple(float(value) for value in place), space.view.rooms()[0])
    return round(at.y()), round(at.x())


def lobe(exponent: float = 60.0, kd: float = 0.02, kg: float = 1.0) -> CosineLobes:
    return CosineLobes((kd,) * 3, (exponent,), ((0.0,) * 3,), ((kg,) * 3,))


def fit(reflectance: CosineLobes) -> LobeFit:
    weights = LobeWeights(
        reflectance.exponents, np.array(reflectance.kd), reflectance.kdd, reflectance.kg, 0.7, 1.5
    )
    return LobeFit(Material("fit", weights), "measured", weights, {}, (), 0.001)


@pytest.mark.parametrize(("theta", "phi"), [(50.0, 0.0), (30.0, 180.0), (65.0, 20.0)])
def test_the_lobe_is_where_the_mirror_direction_is(space, program, theta: float, phi: float) -> None:
    program.session.set_incidence(theta, phi)
    seen = red_of(shown(space, PlottedMaterial("a", "A", Material("A", lobe()), RED)))
    top = mirror(program.session.light)
    # Along the mirror direction up to just below radius 1; not past it, and not towards the light.
    for reach in (0.3, 0.6, 0.93):
        assert seen[spot(space, reach * top)], reach
    assert not seen[spot(space, 1.08 * top)]
    assert not seen[spot(space, 0.7 * program.session.light)]


def test_a_spike_of_exponent_1e5_is_seen_up_to_its_tip(space, program) -> None:
    seen = red_of(shown(space, PlottedMaterial("a", "A", Material("A", lobe(1e5, kd=0.0)), RED)))
    top = mirror(program.session.light)
    for reach in (0.2, 0.5, 0.85):
        row, column = spot(space, reach * top)
        assert seen[row - 1 : row + 2, column - 1 : column + 2].any(), reach


def test_holes_and_zero_are_a_picture_and_a_note(space, program) -> None:
    class Holed:
        def eval(self, wi, wo):
            value = np.full((*np.broadcast_shapes(np.shape(wi), np.shape(wo))[:-1], 3), 0.3)
            value[np.asarray(wo)[..., 0] > 0.0] = np.nan
            return value

    seen = red_of(shown(space, PlottedMaterial("a", "A", Material("A", Holed()), RED)))
    # Matt is a hemisphere: half of it is left out, and its inside shows.
    assert seen[spot(space, 0.9 * spherical(np.radians(45.0), np.pi))]
    assert not seen[spot(space, 0.97 * spherical(np.radians(60.0), 0.0))]
    assert "holes" in space.view.scene.panels[0].note
    seen = red_of(shown(space, PlottedMaterial("a", "A", Material("A", lobe(kd=0.0, kg=0.0)), RED)))
    assert not seen.any()
    assert "zero" in space.view.scene.panels[0].note
    assert program.window.messages.shown() == {} or not list(program.window.messages.shown())
    program.session.set_subjects(())
    assert not red_of(picture(space)).any()
    assert space.view.scene.panels == ()


def test_a_model_that_fails_is_reported_and_ends_nothing(space, program) -> None:
    class Broken:
        def eval(self, wi, wo):
            raise ZeroDivisionError("nothing to divide by")

    shown(space, PlottedMaterial("a", "A", Material("A", Broken()), RED))
    assert "space a" in list(program.window.messages.shown())
    assert "No values in any direction" in space.view.scene.panels[0].note


def test_brushed_metal_turns_with_the_azimuth(space, program) -> None:
    subject = PlottedMaterial(
        "a", "A", Material("A", MODELS["poulin_fournier"].default), RED, isotropic=False
    )
    space.go_to("top")
    shown(space, subject)
    pictures = []
    for phi in (0.0, 90.0):
        program.session.set_incidence(45.0, phi)
        space.go_to("top")
        settle(space)
        # Of a size of its own: messages take room from the view.
        pictures.append(red_of(space.picture(260, 220)))
    # The camera turns with the plane of incidence: an isotropic lobe would give one picture twice.
    assert (pictures[0] ^ pictures[1]).sum() > 0.1 * pictures[0].sum()


def test_what_is_slow_follows_a_drag_and_holds_nothing_up(space, program, qtbot) -> None:
    class Slow:
        def __init__(self) -> None:
            self.threads: list[bool] = []
            self.may = threading.Event()
            self.may.set()

        def eval(self, wi, wo):
            here = threading.current_thread() is threading.main_thread()
            self.threads.append(here)
            if not here:
                self.may.wait()
            shape = np.broadcast_shapes(np.shape(wi), np.shape(wo))[:-1]
            cosine = np.broadcast_to(np.asarray(wi)[..., 2], shape)
            return np.repeat(cosine[..., None], 3, axis=-1)

    model = Slow()
    shown(space, PlottedMaterial("slow", "A", Material("A", model), RED))
    kept = space.values.kept["slow"]
    kept.seconds = 1.0  # as after a long evaluation
    model.may.clear()
    model.threads.clear()
    for theta in (50.0, 55.0, 60.0):
        program.session.set_incidence(theta, 0.0)
        space.draw_now()
    assert (panel := space.view.scene.panels[0]).layers, "the lobes of before stay"
    assert "Outdated" in panel.note
    space.session.set_subjects((PlottedMaterial("slow", "A", Material("A", Slow()), RED),))
    space.draw_now()
    assert space.view.scene.panels[0].layers, "of what is edited, too"
    assert not any(model.threads)
    model.may.set()
    qtbot.waitUntil(lambda: space.is_idle)
    assert (panel := space.view.scene.panels[0]).note == ""
    light = np.cos(np.radians(60.0))
    assert panel.layers[0].surface.values[3, 3] == pytest.approx(light * light, rel=1e-5)


def test_target_and_fit_over_one_another_beside_and_their_difference(space, program) -> None:
    target, other = lobe(60.0), lobe(20.0, kg=0.8)
    subject = PlottedMaterial("a", "A", Material("A", target), RED, fit=fit(other))
    shown(space, subject)
    for what, panels, layers in (("fit", 1, 1), ("both", 1, 2), ("side by side", 2, 1), ("difference", 1, 1)):
        program.session.set_options(shown=what)
        image = picture(space)
        scene = space.view.scene
        assert len(scene.panels) == panels
        assert len(scene.panels[0].layers) == layers
        assert np.ptp(pixels(image)) > 20
    surface = space.view.scene.panels[0].layers[0].surface
    grid = space.view.scene.panels[0].layers[0].grid
    wanted = (other.eval(grid.wi, grid.directions) - target.eval(grid.wi, grid.directions))[..., 0] * grid.wi[
        2
    ]
    np.testing.assert_allclose(surface.values, wanted, atol=1e-5 * np.abs(wanted).max())
    assert space.view.scene.bar is not None
    # Against a reference instead of the fit.
    program.session.add(PlottedMaterial("b", "B", Material("B", lobe(kd=0.2, kg=0.0)), RED))
    program.session.set_reference("b")
    settle(space)
    assert [panel.title for panel in space.view.scene.panels] == ["A"]
    assert "minus B" in space.view.scene.panels[0].caption


def test_lobes_alone_stacked_and_switched_off(space, program) -> None:
    weights = LobeWeights(
        np.array([8.0, 900.0]),
        np.full(3, 0.05),
        np.full((2, 3), 0.2),
        np.array([[0.0] * 3, [3.0] * 3]),
        0.7,
        1.5,
    )
    shown(
        space,
        PlottedMaterial(
            "a",
            "A",
            Material("A", lobe()),
            RED,
            fit=LobeFit(Material("fit", weights), "measured", weights, {}, (), 0.001),
        ),
    )
    program.session.set_options(shown="fit")
    for view, panels, layers in (("apart", 4, 1), ("stacked", 1, 4), ("parts", 1, 3), ("sum", 1, 1)):
        space.state.set(lobes=view)
        picture(space)
        scene = space.view.scene
        assert (len(scene.panels), len(scene.panels[0].layers)) == (panels, layers), view
    before = scene.panels[0].layers[0].surface.values
    switch = space.parts.switches["gloss", 1]
    switch.click()
    assert ("gloss", 1) in program.session.options.lobes_off
    settle(space)
    after = space.view.scene.panels[0].layers[0].surface.values
    assert after[0, 0] == pytest.approx(before[0, 0] - 3.0, rel=1e-5)
    space.parts.reset.click()
    assert program.session.options.lobes_off == frozenset()
    assert switch.isChecked()


def test_samples_lie_on_the_surface_at_their_incidence(space, program) -> None:
    model = lobe(20.0)
    wi = spherical(np.radians([45.0, 45.5, 70.0]), np.radians([10.0, 200.0, 0.0]))
    wo = spherical(np.radians([40.0, 20.0, 10.0]), np.radians([190.0, 30.0, 180.0]))
    samples = SamplePoints(wi, wo, model.eval(wi, wo))
    shown(space, PlottedMaterial("a", "A", Material("A", model), RED, samples=samples))
    points = space.view.scene.panels[0].points
    # Two lie near this incidence; of an isotropic reflectance what is not in its plane stands on both sides.
    assert len(points.places) == 3
    np.testing.assert_allclose(points.places[1] * [1.0, -1.0, 1.0], points.places[2], atol=1e-6)
    light = program.session.light
    scale = space.view.scene.scale
    for place in points.places[:1]:
        view = place / np.linalg.norm(place)
        value = model.eval(light, view)[0] * light[2]
        assert np.linalg.norm(place) == pytest.approx(float(scale.radius(value)), rel=1e-5)
    program.session.set_incidence(10.0, 0.0)
    settle(space)
    assert space.view.scene.panels[0].points is None
    assert "nearest is at 45" in space.view.scene.panels[0].note


def test_a_sample_behind_a_lobe_is_seen_faintly(space, program) -> None:
    behind = spherical(np.radians(60.0), np.radians(70.0))
    samples = SamplePoints(program.session.light[None], behind[None], np.array([[0.0, 0.0, 0.01]]), False)
    with_it = pixels(
        shown(space, PlottedMaterial("a", "A", Material("A", lobe(kd=0.3, kg=0.0)), RED, samples=samples))
    )
    at = spot(space, space.view.scene.panels[0].points.places[0])
    space.state.set(samples=False)
    without = pixels(picture(space))
    # Bluer than the lobe before it, and not as blue as one that nothing hides.
    assert 20 < with_it[at][2] - without[at][2] < 150


def test_the_body_of_a_coated_paint_is_seen_at_once(space, program) -> None:
    assert red_of(shown(space, PlottedMaterial("a", "A", Material("A", lobe(1e5, kg=1500.0)), RED)))[
        spot(space, (0.15, 0.0, 0.42))
    ]
    assert "cut off" in space.view.scene.panels[0].caption
    space.state.set(fill="greatest")
    assert not red_of(picture(space))[spot(space, (0.15, 0.0, 0.42))]


def test_the_light_is_dragged_by_its_handle_and_turned_by_alt(space, program) -> None:
    view, session = space.view, program.session
    shown(space, PlottedMaterial("a", "A", Material("A", lobe()), RED))
    space.state.set(arrows=True)
    space.go_to("top")
    settle(space)
    at = view.project(tuple(1.18 * session.light), view.rooms()[0]).toPoint()
    to = view.project(tuple(1.18 * spherical(np.radians(20.0), np.pi)), view.rooms()[0]).toPoint()
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    camera = space.camera
    QTest.mousePress(view, left, none, at)
    QTest.mouseMove(view, to)
    QTest.mouseRelease(view, left, none, to)
    assert session.incidence[0] == pytest.approx(20.0, abs=1.0)
    assert abs(session.incidence[1]) < 1.0
    assert space.camera == camera, "the camera stays"
    settle(space)
    QTest.mouseDClick(view, left, none, view.project(tuple(1.18 * session.light), view.rooms()[0]).toPoint())
    QTest.mouseRelease(view, left, none, to)
    assert session.incidence == (45.0, 0.0)
    QTest.mousePress(view, left, Qt.KeyboardModifier.AltModifier, QPoint(40, 200))
    QTest.mouseMove(view, QPoint(80, 200))
    QTest.mouseRelease(view, left, Qt.KeyboardModifier.AltModifier, QPoint(80, 200))
    assert session.incidence == pytest.approx((45.0, 14.0), abs=0.5)
    QTest.mousePress(view, left, none, QPoint(40, 200))
    QTest.mouseMove(view, QPoint(60, 200))
    QTest.mouseRelease(view, left, none, QPoint(60, 200))
    assert space.camera.azimuth_deg == pytest.approx(camera.azimuth_deg - 7.0, abs=0.5)


def test_numbers_presets_frame_and_reset(space, program) -> None:
    space.incidence.theta.setValue(60.0)
    assert program.session.incidence == (60.0, 0.0)
    assert space.incidence.theta_slider.value() == 600
    space.go_to("mirror")
    eye = np.array(space.camera.eye()) - np.array(space.camera.centre)
    np.testing.assert_allclose(eye / np.linalg.norm(eye), mirror(program.session.light), atol=1e-6)
    space.set_camera(space.camera.zoom(0.1, 0.2, 0.1).pan(0.3, 0.2))
    QTest.keyClick(space.view, Qt.Key.Key_F)
    assert space.camera.centre == (0.0, 0.0, 0.42)
    space.incidence.reset.click()
    assert program.session.incidence == (45.0, 0.0)
    assert parse_camera(format_camera(space.camera)) == space.camera
    assert parse_camera("1 2 nonsense") == parse_camera("0 0 -1 0 0 0") == Camera()
    space.reset_view()
    assert space.camera == Camera()
    space.state.set(fill="value", full=2.5, colouring="values", decades=3.0)
    space.surface.reset.click()
    assert (space.state.options.fill, space.state.options.colouring) == ("auto", "light")


def test_the_sweep_moves_the_light(space, program) -> None:
    space.state.set(speed=10.0)
    space.sweep.advance(1.5)
    assert program.session.incidence[0] == pytest.approx(60.0)
    space.state.set(sweep="azimuth")
    space.sweep.advance(1.0)
    assert program.session.incidence == pytest.approx((60.0, 10.0))
    space.incidence.run.click()
    assert space.sweep.running
    space.incidence.run.click()
    assert not space.sweep.running


def test_what_is_under_the_cursor_is_read(space, program) -> None:
    from brdf_lobe_visualizer.view3d.view import words_of

    shown(space, PlottedMaterial("a", "A", Material("A", lobe(5.0)), RED))
    at = space.view.project((0.0, 0.0, 0.2), space.view.rooms()[0])
    probe = space.view.probe_at(at)
    assert probe is not None
    assert "θo" in words_of(probe)
    assert "1/sr" in words_of(probe)
    before = pixels(space.view.grabFramebuffer())
    space.view.set_probe(probe, words_of(probe))
    row, column = round(at.y()), round(at.x())
    changed = (pixels(space.view.grabFramebuffer()) != before).any(axis=-1)
    assert changed[row - 6 : row + 7, column - 6 : column + 7].any()
    assert not changed[-40:].any()
    assert space.view.probe_at(QPointF(3.0, 3.0)) is None


def test_pictures_and_surfaces_are_written_and_read_back(space, program, tmp_path: Path) -> None:
    space.go_to("three_quarters")
    program.session.set_subjects(
        [PlottedMaterial("a", "A <b>", Material("A <b>", lobe()), RED, fit=fit(lobe(30.0)))]
    )
    program.session.set_options(shown="both")
    space.state.set(colouring="values")
    section = space.save.section
    assert all(field.parentWidget() is not None for field in (section.width_, section.height_, section.size_))
    section.width_.setValue(700)
    section.height_.setValue(500)
    for kind in ("png", "svg", "obj", "ply"):
        space.save.ask_path = lambda _parent, _title, suggested, _filters: tmp_path / suggested.name
        section.buttons[kind].click()
    names = sorted(file.name for file in tmp_path.iterdir() if file.is_file())
    assert names == ["A _b_.obj", "A _b_.ply", "A _b_.png", "A _b_.svg"]
    with Image.open(tmp_path / "A _b_.png") as image:
        assert image.size == (700, 500)
        drawn = np.asarray(image.convert("RGB")).astype(int)
    assert np.ptp(drawn, axis=(0, 1)).min() > 80
    # In several parts, joined: a picture larger than a part is the same picture.
    # Letters are set to whole pixels, each size in its own way; all else matches far better than displaced by 2 %.
    small = pixels(space.picture(350, 250))

    def apart(rows: int) -> float:
        halved = np.roll(drawn, rows, axis=0).reshape(250, 2, 350, 2, 3).mean(axis=(1, 3))
        return float(np.abs(halved - small).mean())

    assert apart(0) < 0.75 * apart(10)
    root = ElementTree.parse(tmp_path / "A _b_.svg").getroot()
    tags = [element.tag.rsplit("}")[-1] for element in root.iter()]
    assert tags.count("polygon") > 500
    assert tags.count("text") > 10
    for ending in ("obj", "ply"):
        mesh = trimesh.load(tmp_path / f"A _b_.{ending}", process=False)
        assert np.linalg.norm(mesh.vertices, axis=1).max() == pytest.approx(100.0, rel=1e-3)
    space.save.ask_path = lambda *_: tmp_path / "missing" / "a.png"
    section.buttons["png"].click()
    assert "export" in list(program.window.messages.shown())


def test_every_theme_draws_its_own_ground(space, program, qapp) -> None:
    grounds = []
    try:
        for name in ("dark", "booth", "light"):
            theme.apply(qapp, name, remember=False)
            QCoreApplication.processEvents()
            image = pixels(shown(space, PlottedMaterial("a", "A", Material("A", lobe()), RED)))
            grounds.append(int(image[-5, 5, 0]))
            assert np.ptp(image[-5, 5]) == 0
    finally:
        theme.apply(qapp, "dark", remember=False)
    assert grounds == sorted(set(grounds))
