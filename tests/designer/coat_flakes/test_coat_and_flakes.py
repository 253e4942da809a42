"""The coat as gloss and as index and roughness, in step; haze, orange peel, refusals; and what cannot be."""

from __future__ import annotations

import pytest
from brdf_designer.assembly import Designer
from brdf_designer.colour.quantity_plot import QuantityPlot
from brdf_designer.session.edits import PickColour
from brdf_designer.session.state import GivenColour
from brdf_qt.fields.colour_slider import ColourSlider
from brdf_qt.fields.marks import Mark
from brdf_qt.fields.number import NumberField
from brdf_qt.window.command_palette import commands
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QComboBox, QLabel

from brdf_suite.appearance.flop.travel import flop_index
from brdf_suite.documents.paint import OrangePeel
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.reflectance.designed.build import build_paint


@pytest.fixture
def designer(program) -> Designer:
    """The Designer of the module: a window of its own for each test would take most of the time."""
    return program


def type_in(number, text: str) -> None:
    number.setFocus()
    number.selectAll()
    QTest.keyClicks(number, text)
    QTest.keyClick(number, Qt.Key.Key_Return)


def steps(designer) -> list[str]:
    return [designer.store.stack.text(i) for i in range(designer.store.stack.count())]


def test_gloss_and_coat_are_in_step_both_ways(designer, qtbot) -> None:
    coat = designer.window.coat
    before = designer.store.value
    assert coat.ior.value() == pytest.approx(1.529, abs=0.002)
    type_in(coat.ior, "1.560")
    gloss = designer.store.value.gloss
    assert gloss.gu_20 > before.gloss.gu_20
    assert gloss.gu_60 is not None
    assert coat.has_60.isChecked()
    solved = build_paint(designer.store.value)
    assert (solved.ior, solved.roughness) == (pytest.approx(1.56, abs=1e-3), pytest.approx(0.002, abs=2e-4))
    type_in(coat.roughness, "0.01")
    assert designer.store.value.gloss.gu_20 < gloss.gu_20
    assert coat.ior.value() == pytest.approx(1.56, abs=2e-3)
    assert coat.daily.fields["gloss.gu_20"].value() == pytest.approx(
        designer.store.value.gloss.gu_20, abs=0.06
    )
    assert steps(designer) == ["Change Coat Index", "Change Coat Roughness"]
    # And back: a reading that is typed is solved for the coat.
    type_in(coat.daily.fields["gloss.gu_20"], "50")
    assert coat.roughness.value() > 0.01
    for _ in range(3):
        designer.session.undo()
    assert designer.store.value == before


def test_a_coat_that_the_colours_do_not_allow_is_refused_with_what_can_be(designer) -> None:
    coat = designer.window.coat
    designer.session.edit(PickColour(0, (6.0, 0.0, 0.0)))
    before, roughness = designer.store.value, coat.roughness.value()
    type_in(coat.roughness, "0.2")
    message = designer.window.messages.shown()["edit"]
    text_shown = message.what
    assert "at 15°" in text_shown
    assert designer.store.value == before
    assert coat.roughness.value() == roughness
    most = text_shown.rsplit("up to ", 1)[1].rstrip(".")
    type_in(coat.roughness, most)
    assert "edit" not in designer.window.messages.shown()
    taken = designer.store.value
    assert taken != before
    designer.session.undo()
    ((text, take),) = message.actions
    assert text == f"Use Roughness {most}"
    take()
    assert designer.store.value == taken
    assert steps(designer)[-1] == "Change Coat Roughness"


def test_haze_is_computed_from_the_readings_or_from_the_coat(designer, qtbot) -> None:
    coat = designer.window.coat
    qtbot.waitUntil(lambda: "computed" in coat.haze.text())
    coat.has_60.click()
    gloss = designer.store.value.gloss
    assert coat.haze.text() == f"{gloss.gu_60 - gloss.gu_20:.1f} GU, from the readings"
    assert "D4039" in coat.haze.toolTip()


def test_orange_peel_is_part_of_the_paint(designer) -> None:
    coat = designer.window.coat
    assert not coat.peel.isEnabled()
    coat.has_peel.click()
    assert designer.store.value.orange_peel == OrangePeel()
    type_in(coat.peel.fields["orange_peel.amplitude_um"], "2")
    type_in(coat.peel.fields["orange_peel.wavelength_mm"], "6")
    assert designer.store.value.orange_peel == OrangePeel(2.0, 6.0)
    assert coat.slope.text().startswith("0.120°")
    type_in(coat.peel.fields["orange_peel.amplitude_um"], "19")
    type_in(coat.peel.fields["orange_peel.wavelength_mm"], "0.5")
    assert "steeper than 5°" in designer.window.messages.shown()["edit"].what
    assert designer.store.value.orange_peel == OrangePeel(19.0, 6.0)
    coat.has_peel.click()
    assert designer.store.value.orange_peel is None
    coat.has_peel.click()
    assert designer.store.value.orange_peel == OrangePeel(19.0, 6.0)
    assert steps(designer)[:3] == ["Orange Peel On", "Change Orange peel", "Change Peel wavelength"]


def test_a_gloss_that_cannot_be_is_explained_and_the_nearest_is_one_click_away(designer, qtbot) -> None:
    coat, messages = designer.window.coat, designer.window.messages
    asked_before = designer.store.value
    type_in(coat.daily.fields["gloss.gu_20"], "180")
    assert "reads from" in coat.note.text()
    assert coat.note.isVisible()
    assert not coat.ior.isEnabled()
    qtbot.waitUntil(lambda: "nearest" in messages.shown())
    message = messages.shown()["nearest"]
    assert "GU at 20°" in message.todo
    (text, take), *_ = message.actions
    assert text == "Use Closest"
    take()
    taken = designer.store.value
    assert 130.0 < taken.gloss.gu_20 < 180.0
    build_paint(taken)
    assert coat.ior.isEnabled()
    assert not coat.note.isVisible()
    assert "nearest" not in messages.shown()
    assert steps(designer) == ["Change Gloss 20°", "Use Closest Paint"]
    designer.session.undo()
    assert designer.store.value.gloss.gu_20 == 180.0
    designer.session.undo()
    assert designer.store.value == asked_before


def test_colours_that_no_lobes_give_are_reported_and_the_nearest_offered(own_designer, qtbot) -> None:
    window = own_designer.window
    type_in(window.editors.editors[2].fields[0], "80")
    asked = own_designer.store.value
    patches = window.patches.patches
    assert patches[2].fit.text().startswith("fit ΔE00")
    assert patches[2].fit.mark is Mark.BAD
    given = patches[2].field.given
    assert given is not None
    assert given != patches[2].field.grab().toImage().pixelColor(30, 30), (
        "what the fit gives is seen beside what is asked"
    )
    qtbot.waitUntil(lambda: own_designer.controller.is_idle)
    strip = window.strip.band.grab().toImage()
    end, height = strip.width() - 16, strip.height() // 2
    above, below = (strip.pixelColor(end, y).lightness() for y in (4, height))
    assert above - below > 40, "the strip shows what the lobes give under what is asked"
    qtbot.waitUntil(lambda: "nearest" in window.messages.shown())
    message = window.messages.shown()["nearest"]
    assert "No combination of lobes produces the target colour at" in message.what
    assert "110°" in message.what
    # Another edit takes the offer back: it was for the paint before.
    type_in(window.editors.editors[2].fields[0], "81")
    assert "nearest" not in window.messages.shown()
    qtbot.waitUntil(lambda: "nearest" in window.messages.shown())
    window.messages.shown()["nearest"].actions[0][1]()
    fitter = PaintFitter(time_limit_s=60.0)
    assert fitter.fit(own_designer.store.value).worst_delta_e < 1.0
    fitter.close()
    assert not any(patch.fit.font().bold() for patch in patches)
    own_designer.session.undo()
    own_designer.session.undo()
    assert own_designer.store.value == asked


def test_every_control_says_what_it_is_and_what_its_term_means(designer) -> None:
    window = designer.window
    for button in window.plot.buttons:
        assert button.accessibleName()
    checked = 0
    for part in (window.editors, window.coat, window.flakes, window.model, window.plot):
        for kind in (QAbstractButton, QComboBox, NumberField, ColourSlider, QuantityPlot):
            for control in part.findChildren(kind):
                if control.objectName().startswith("qt_") or isinstance(control.parent(), NumberField):
                    continue
                name = control.accessibleName() or getattr(control, "text", lambda: "")()
                assert name, control
                assert control.toolTip(), name
                checked += 1
    assert checked > 45
    tips = " ".join(field.toolTip() for field in window.panel.pages["paint"].findChildren(NumberField))
    for term in ("µm", "DOI", "Beckmann", "D523"):
        assert term in tips
    titles = [
        label for label in window.editors.editors[0].findChildren(QLabel) if label.text().startswith("15°")
    ]
    assert ["aspecular angle" in title.toolTip() for title in titles] == [True]
    assert "travel" in window.editors.flop.fields["lightness"].toolTip().lower()


def test_a_time_limit_is_shown_at_every_patch(own_designer) -> None:
    patches = own_designer.window.patches
    given = [GivenColour((50.0, 0.0, 0.0), (119, 119, 119), True)] * 3
    patches.show_differences([0.5, 0.0, 2.0], given, time_limited=True, exact_follows=True)
    assert all("time-limited" in patch.fit.accessibleName() for patch in patches.patches)
    assert "exact result follows" in patches.patches[2].fit.toolTip()
    assert "L* 50.0" in patches.patches[0].fit.toolTip()
    assert patches.patches[0].field.given.name() == "#777777"
    patches.show_differences(None)
    assert patches.patches[0].field.given is None
    assert patches.patches[0].fit.text() == "fit: none"


def test_the_choices_over_the_colours_are_commands_too(designer) -> None:
    found = dict(commands(designer.window))
    head = designer.window.editors.head
    modes, spaces = head.modes.value, head.spaces.value
    found["Paint ▸ Edit All Angles"].trigger()
    found["Paint ▸ Colours in LCh"].trigger()
    assert (head.modes.value, head.spaces.value) == ("all", "lch") != (modes, spaces)
    assert head.modes.buttons["all"].isChecked()
    assert designer.window.editors.editors[0].space == "lch"
    found["Paint ▸ Angles: 5 (15 to 110°)"].trigger()
    assert len(designer.store.value.measurements) == 5
    assert designer.window.editors.editors[4].fields[2].suffix() == "°"


def test_a_colour_that_the_lobes_do_not_reach_stands_out(own_designer, qtbot):
    patches, fit = own_designer.window.patches.patches, own_designer.window.status.cell("Fit")
    assert not any(patch.fit.font().bold() or patch.fit.mark for patch in patches)
    dict(commands(own_designer.window))["Paint ▸ Make Solid From ▸ 45°"].trigger()
    # Darker towards the mirror direction than away from it: lobes around the mirror direction cannot do that.
    type_in(own_designer.window.editors.editors[1].fields[0], "90")
    assert [patch.fit.font().bold() for patch in patches] == [False, True, False]
    assert patches[1].fit.text().startswith("fit ΔE00 ")
    assert [patch.fit.mark for patch in patches] == [None, Mark.BAD, None]
    assert "no non-negative sum of the lobes" in patches[1].fit.toolTip()
    assert "no non-negative sum" not in patches[0].fit.toolTip()
    qtbot.waitUntil(lambda: own_designer.controller.is_idle)
    assert fit.text().startswith("Fit")
    assert fit.mark is Mark.BAD
    assert fit.font().bold()
    assert "no non-negative sum of the lobes" in fit.toolTip()
    own_designer.session.undo()
    assert not any(patch.fit.font().bold() for patch in patches)
    qtbot.waitUntil(lambda: own_designer.controller.is_idle)
    assert not fit.font().bold()


def test_the_status_bar_shows_target_and_fit(own_designer, qtbot):
    qtbot.waitUntil(lambda: own_designer.controller.is_idle)
    flop, fit = (own_designer.window.status.cell(name) for name in ("Flop index", "Fit"))
    assert flop.text() == "Flop 13.9, achieved 13.9"
    assert fit.text().endswith(", exact")
    whole, *rows = fit.toolTip().splitlines()
    assert whole == fit.text()
    assert rows[0] == "15°: target 62.0 / −4.0 / −45.0, fit 62.0 / −4.0 / −45.0, ΔE00 0.00"
    # Darker towards the mirror direction than away from it cannot be reached: the flop that is shown says so.
    type_in(own_designer.window.editors.editors[2].fields[0], "55")
    qtbot.waitUntil(lambda: own_designer.controller.is_idle)
    asked, achieved = flop.text().rstrip(" ?").split(", achieved ")
    lightness = [row.lab_fitted[0] for row in own_designer.session.fit.readings]
    assert asked == f"Flop {flop_index(62.0, 25.0, 55.0).value:.1f}"
    assert achieved == f"{flop_index(*lightness).value:.1f}" != asked.split()[1]
    assert fit.text().startswith("Fit ΔE00 ≤ ")
    assert fit.mark is Mark.BAD
    worst = max(row.delta_e_2000 for row in own_designer.session.fit.readings)
    assert abs(float(fit.text().split("≤ ")[1].split(",")[0]) - worst) <= 0.01
    given = own_designer.session.fit.readings[2].lab_fitted
    assert f"fit {given[0]:.1f} / " in fit.toolTip().splitlines()[3]
    # Of a paint that cannot be, only what is asked is said.
    type_in(own_designer.window.coat.daily.fields["gloss.gu_20"], "199")
    assert "achieved" not in flop.text()
    assert fit.text().startswith("(")


def test_a_field_that_holds_a_refused_value_shows_the_paint_again_with_the_next_edit(designer) -> None:
    window = designer.window
    window.texts.name.clear()
    window.texts.name.edited.emit("")
    assert "edit" in window.messages.shown()
    assert window.texts.name.text() == ""
    type_in(window.editors.editors[2].fields[0], "6")
    assert window.texts.name.text() == "Blue"
    assert window.coat.daily.fields["gloss.gu_20"].value() == 90.0


def test_an_edit_of_a_colour_leaves_the_other_sections_alone(designer, monkeypatch) -> None:
    window = designer.window
    shown: list[str] = []
    for name in ("coat", "flakes", "model", "texts"):
        section = getattr(window, name)
        monkeypatch.setattr(section, "show_paint", lambda _paint, name=name: shown.append(name))
    type_in(window.editors.editors[2].fields[0], "6")
    type_in(window.editors.editors[2].fields[0], "7")
    shown.clear()
    type_in(window.editors.editors[2].fields[0], "8")
    assert shown == []
    type_in(window.coat.daily.fields["gloss.gu_20"], "88")
    assert shown == ["coat"]
