"""The window: plots side by side with their buttons, an empty session, odd reflectances, no 3-D view."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_lobe_visualizer.assembly import PARTS, LobeVisualizer
from brdf_lobe_visualizer.plot_row import PlotRow
from brdf_lobe_visualizer.statistics.panel import Numbers
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_qt.window.command_palette import commands
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtWidgets import QApplication, QLabel, QWidget

from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.registry import MODELS


class Holed:
    """Matt, with no number where the view leans to +x."""

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        value = np.full(wi.shape, 0.2)
        value[wo[..., 0] > 0.0] = np.nan
        return value


def spike() -> LobeWeights:
    none = np.zeros((1, 3))
    return LobeWeights(np.array([1e5]), np.zeros(3), none, np.full((1, 3), 1e4), 0.7, 1.0)


ODD = {
    "nothing": lambda: Lambertian((0.0, 0.0, 0.0)),
    "one hot spike": spike,
    "holes": Holed,
    "anisotropic": lambda: MODELS["lafortune"].default,
}


def plot_row(qtbot, *keys: str) -> PlotRow:
    row = PlotRow()
    qtbot.addWidget(row)
    for key in keys:
        row.add(key, key.capitalize(), QWidget())
    row.resize(900, 300)
    row.show()
    return row


def test_three_plots_are_shown_first_and_the_choice_is_remembered(qtbot) -> None:
    row = plot_row(qtbot, "a", "b", "c", "d")
    assert row.shown() == ("a", "b", "c")
    assert not row.plots["d"].isVisible()
    row.set_shown("d", True)
    row.set_shown("a", False)
    row.set_shown("b", False, remember=False)
    assert plot_row(qtbot, "a", "b", "c", "d").shown() == ("b", "c", "d")


def test_plots_that_are_shown_are_as_wide_as_each_other(qtbot) -> None:
    row = plot_row(qtbot, "a", "b", "c")
    row.set_shown("b", False)
    widths = [row.plots[key].width() for key in ("a", "c")]
    assert abs(widths[0] - widths[1]) <= 2
    assert sum(widths) > 800


def test_without_a_plot_the_row_is_its_buttons(qtbot) -> None:
    row = plot_row(qtbot, "a")
    row.buttons["a"].click()
    assert row.shown() == ()
    assert row.maximumHeight() < 60
    row.buttons["a"].click()
    assert row.plots["a"].isVisible()


def test_the_layout_goes_back_with_its_plots(program) -> None:
    window = program.window
    window.plots.set_shown("albedo", False)
    window.top_split.setSizes([100, 900])
    program.panel_dock.show()
    window.findChild(object, "action_Reset Layout").trigger()
    assert window.plots.shown() == ("albedo",)
    assert program.panel_dock.isHidden()
    view, legend = window.top_split.sizes()
    assert view > legend


def test_an_empty_desk_says_what_to_do(program) -> None:
    page = program.legend.legend.pages.currentWidget()
    assert "Drop files" in page.findChild(QLabel).text()
    assert program.window.status.cell("subject").text() == ""
    assert program.window.findChild(QLabel, "no_view") is not None


def test_every_command_has_a_letter_or_name_of_its_own(program) -> None:
    found = [text for text, _action in commands(program.window, also_disabled=True)]
    assert len(found) == len(set(found))
    assert any("Follow Designer" in text for text in found)


def test_no_shortcut_is_taken_twice(program) -> None:
    keys = [
        shortcut.toString()
        for _text, action in commands(program.window, also_disabled=True)
        for shortcut in action.shortcuts()
    ]
    assert sorted(keys) == sorted(set(keys))


@pytest.fixture(scope="module")
def whole(qapp, tmp_path_factory):
    """The program with all of its parts; without OpenGL the view in three dimensions says that it cannot be."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("BRDF_SUITE_SETTINGS", str(tmp_path_factory.mktemp("settings")))
        patched.setenv("BRDF_SUITE_LINK", "test-whole-lobes")
        program = LobeVisualizer(PARTS)
        program.window.resize(1100, 760)
        program.window.show()
    yield program
    program.close()
    program.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.mark.parametrize("name", ODD)
def test_odd_reflectances_have_a_picture_and_figures_and_no_exception(whole, qtbot, name) -> None:
    """An exception in a slot or on a thread fails the test by itself."""
    whole.session.set_subjects(())
    for key in whole.window.plots.plots:
        whole.window.plots.set_shown(key, key != "basis", remember=False)
    whole.numbers.dock.show()
    key = whole.sources.add(
        PlottedMaterial("", name, Material(name, ODD[name]()), isotropic=name != "anisotropic")
    )
    whole.sources.add(PlottedMaterial("", "Matt", Material("Matt", Lambertian((0.5, 0.5, 0.5)))))
    whole.session.set_reference(key)
    for incidence in ((0.0, 0.0), (60.0, 90.0), (89.9, 0.0)):
        whole.session.set_incidence(*incidence)
    for shown in ("both", "side by side", "difference", "target"):
        whole.session.set_options(shown=shown)
    for radius in ("linear", "log", "cbrt"):
        whole.session.set_options(radius=radius)
    qtbot.waitUntil(lambda: whole.is_idle, timeout=60_000)
    assert whole.numbers.work.figures(key) is not None
    picture = whole.window.grab()
    assert not picture.isNull()
    assert not any("fault" in message.what for message in whole.window.messages.shown().values())


def test_the_whole_program_has_its_parts_and_no_shortcut_twice(whole) -> None:
    assert any(isinstance(part, Numbers) for part in whole.features)
    keys = [
        shortcut.toString()
        for _text, action in commands(whole.window, also_disabled=True)
        for shortcut in action.shortcuts()
    ]
    assert sorted(keys) == sorted(set(keys))


def test_keys_of_the_legend_are_the_legends_own(whole, qtbot) -> None:
    """Space is the sweep of the light elsewhere."""
    whole.session.set_subjects(())
    key = whole.sources.add(PlottedMaterial("", "Matt", Material("Matt", Lambertian((0.5, 0.5, 0.5)))))
    before = whole.session.incidence
    rows = whole.legend.legend.rows
    rows.setFocus()
    qtbot.keyClick(rows, Qt.Key.Key_Space)
    assert whole.session.is_hidden(key)
    qtbot.keyClick(rows, Qt.Key.Key_Space)
    assert not whole.session.is_hidden(key)
    assert whole.session.incidence == before
    qtbot.waitUntil(lambda: whole.is_idle, timeout=60_000)


@pytest.mark.parametrize("command", ["Keyboard Shortcuts", "About BRDF Suite", "Find a Command"])
def test_the_help_menu_opens_its_windows(program, command) -> None:
    before = {widget for widget in QApplication.topLevelWidgets() if widget.isVisible()}
    program.window.findChild(object, f"action_{command}").trigger()
    (opened,) = {w for w in QApplication.topLevelWidgets() if w.isVisible()} - before
    opened.close()
