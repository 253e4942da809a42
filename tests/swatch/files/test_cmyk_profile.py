"""The profile of a press, chosen for a palette with colours in CMYK: from the notice, the menu, and remembered."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.loading import remembered_profile
from brdf_qt.program.settings import settings
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.files.palettes import write_palette
from brdf_suite.files.palettes.conversions import labs_d50

INKS = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 1.0, 0.0), (0.0, 0.0, 0.0, 0.0))
COLOURS = tuple(Entry(FlatColour(f"Ink {i}", "CMYK", row), id=str(i)) for i, row in enumerate(INKS))


@pytest.fixture
def profile(tmp_path, press_profile) -> Path:
    path = tmp_path / "press.icc"
    path.write_bytes(press_profile.press())
    return path


@pytest.fixture
def opened(swatch, tmp_path, qtbot):
    """Open the inks as a file of another program, of that name, as the user does; return its key."""
    settings().remove("palette/cmyk_profile")

    def open_file(name: str = "inks.ase") -> str:
        path = tmp_path / name
        if not path.exists():
            write_palette(Palette("Inks", COLOURS), path)
        swatch.window.files_dropped.emit([path])
        item = lambda: next((one for one in swatch.library.items if one.title in ("inks", "Inks")), None)  # noqa: E731
        qtbot.waitUntil(lambda: item() is not None and item().state == "open")
        key = item().key
        swatch.session.show_scope(Scope(key))
        return key

    yield open_file
    settings().remove("palette/cmyk_profile")


def shown(swatch, key: str) -> np.ndarray:
    """L*a*b* (D50, 2°) as the window shows the swatches."""
    return labs_d50(swatch.library.rows(key).lab[:, 1])


def press_button(program, key: str, text: str) -> None:
    message = program.window.messages.findChild(object, f"message_{key}")
    QTest.mouseClick(
        next(one for one in message.findChildren(QPushButton) if one.text() == text),
        Qt.MouseButton.LeftButton,
    )


def wait_idle(swatch, qtbot) -> None:
    qtbot.waitUntil(lambda: swatch.session.reading.is_idle)


def test_the_notice_offers_a_profile_which_is_one_step_and_remembered(
    swatch, opened, profile, press_profile, dialogs, qtbot, command
) -> None:
    key = opened()
    message = swatch.window.messages.shown()[f"open {key}"]
    assert "3 CMYK colours are shown without a profile" in message.todo
    before = swatch.session.palette
    assert swatch.library.item(key).is_clean
    dialogs.path = profile
    press_button(swatch, f"open {key}", "Choose CMYK Profile…")
    wait_idle(swatch, qtbot)
    wanted = [press_profile.look(*row) for row in INKS]
    assert np.abs(shown(swatch, key) - wanted).max() < 0.6
    assert [entry.content.values for entry in swatch.session.palette] == list(INKS)
    assert "through the profile press.icc" in swatch.window.messages.shown()["cmyk profile"].what
    assert f"open {key}" not in swatch.window.messages.shown()
    assert "without a profile" not in swatch.window.note_cell.text()
    assert swatch.library.item(key).is_clean
    command(swatch, "undo")
    assert swatch.session.palette == before
    assert remembered_profile() == profile
    # The next opening is through it.
    swatch.library.close(key)
    again = opened()
    assert again != key
    assert np.abs(shown(swatch, again) - wanted).max() < 0.6
    message = swatch.window.messages.shown()[f"open {again}"]
    assert "through the profile press.icc" in message.todo
    assert [text for text, _ in message.actions] == ["Choose CMYK Profile…"]
    command(swatch, "forget_cmyk_profile")
    assert remembered_profile() is None
    assert not swatch.window.command("forget_cmyk_profile").isEnabled()


def test_edits_stay_and_another_profile_takes_the_place_of_the_first(
    swatch, opened, profile, press_profile, dialogs, qtbot, command, tmp_path
) -> None:
    key = opened()
    first = next(iter(swatch.session.palette)).id
    swatch.session.edit("Rename", lambda palette: edits.rename_entry(palette, first, "Cyan"))
    pasted = Entry(FlatColour("Pasted", "CMYK", INKS[1]), id="pasted")
    swatch.session.edit("Paste", lambda palette: edits.add_entries(palette, [pasted]))
    dialogs.path = profile
    command(swatch, "cmyk_profile")
    wait_idle(swatch, qtbot)
    wanted = [press_profile.look(*row) for row in (*INKS, INKS[1])]
    assert [entry.name for entry in swatch.session.palette][::3] == ["Cyan", "Pasted"]
    assert np.abs(shown(swatch, key) - wanted).max() < 0.6
    assert not swatch.library.item(key).is_clean
    other = tmp_path / "other.icc"
    other.write_bytes(press_profile.press(darker=0.5))
    dialogs.path = other
    command(swatch, "cmyk_profile")
    wait_idle(swatch, qtbot)
    # Bare paper is white through every profile.
    lightness = shown(swatch, key)[:2, 0]
    assert lightness == pytest.approx([0.5 * row[0] for row in wanted[:2]], abs=0.6)
    assert remembered_profile() == other


def test_what_is_no_profile_is_named_and_changes_nothing(
    swatch, opened, dialogs, qtbot, command, tmp_path
) -> None:
    opened()
    before = swatch.session.palette
    dialogs.path = tmp_path / "no.icc"
    dialogs.path.write_bytes(b"nothing" * 20)
    command(swatch, "cmyk_profile")
    wait_idle(swatch, qtbot)
    message = swatch.window.messages.shown()["cmyk profile"]
    assert message.what.startswith("no.icc: ")
    assert swatch.session.palette == before
    assert remembered_profile() is None


def test_a_remembered_profile_that_is_gone_is_a_notice(swatch, opened, tmp_path) -> None:
    settings().setValue("palette/cmyk_profile", str(tmp_path / "gone.icc"))
    key = opened()
    todo = swatch.window.messages.shown()[f"open {key}"].todo
    assert "The CMYK profile gone.icc cannot be used: " in todo
    assert "without a profile" in todo


def test_a_palette_of_ours_keeps_its_colours_until_a_profile_is_chosen(
    swatch, opened, profile, press_profile, dialogs, qtbot, command, tmp_path
) -> None:
    settings().setValue("palette/cmyk_profile", str(profile))
    save_palette(replace(Palette("Inks", COLOURS)), tmp_path / "inks.brdfpalette")
    key = opened("inks.brdfpalette")
    assert f"open {key}" not in swatch.window.messages.shown()
    assert swatch.session.palette.entries == COLOURS
    dialogs.path = profile
    command(swatch, "cmyk_profile")
    wait_idle(swatch, qtbot)
    assert np.abs(shown(swatch, key) - [press_profile.look(*row) for row in INKS]).max() < 0.6
    assert not swatch.library.item(key).is_clean
    command(swatch, "cmyk_profile")
    wait_idle(swatch, qtbot)
    assert "have a look of their own" in swatch.window.messages.shown()["cmyk profile"].what


def test_a_palette_without_inks_offers_nothing(swatch) -> None:
    assert not swatch.window.command("cmyk_profile").isEnabled()
