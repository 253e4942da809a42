"""The one table of keys: what a command is called here, what it does, and its keys, the same in all four programs.

A program names a command of the table when it adds it to its window; nothing else gives keys to a command.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtGui import QAction, QKeySequence

from brdf_qt.program.translation import mark

PRESETS = 9


@dataclass(frozen=True)
class Shortcut:
    """What a command does (English, marked for translation), and its keys as Qt writes them, the shown ones first."""

    meaning: str
    keys: tuple[str, ...]


def _table(*rows: tuple[str, str, str]) -> dict[str, Shortcut]:
    return {name: Shortcut(meaning, tuple(keys.split())) for name, meaning, keys in rows}


SHORTCUTS = _table(
    ("new", mark("New paint or palette"), "Ctrl+N"),
    ("open", mark("Open"), "Ctrl+O"),
    ("open_view", mark("Open a view"), "Ctrl+Shift+O"),
    ("open_environment", mark("Open an environment"), "Ctrl+Shift+E"),
    ("open_surface", mark("Open a surface"), "Ctrl+Shift+U"),
    ("open_palette", mark("Open a palette"), "Ctrl+Shift+P"),
    ("add_from_library", mark("Add from the library"), "Ctrl+Shift+B"),
    ("new_from_measurement", mark("New from a measurement"), "Ctrl+Shift+N"),
    ("acquire", mark("Acquire"), "Ctrl+Shift+M"),
    ("save", mark("Save"), "Ctrl+S"),
    ("save_as", mark("Save as"), "Ctrl+Shift+S"),
    ("export", mark("Export"), "Ctrl+E"),
    ("save_picture", mark("Save the picture"), "Ctrl+Shift+X"),
    ("save_traced", mark("Save the traced picture"), "Ctrl+Shift+R"),
    ("print", mark("Print"), "Ctrl+P"),
    ("close", mark("Close tab or palette"), "Ctrl+W"),
    ("reopen", mark("Reopen the closed tab"), "Ctrl+Shift+T"),
    ("quit", mark("Quit"), "Ctrl+Q"),
    ("undo", mark("Undo"), "Ctrl+Z"),
    ("redo", mark("Redo"), "Ctrl+Shift+Z Ctrl+Y"),
    ("cut", mark("Cut"), "Ctrl+X"),
    ("copy", mark("Copy"), "Ctrl+C"),
    ("paste", mark("Paste"), "Ctrl+V"),
    ("duplicate", mark("Duplicate"), "Ctrl+D"),
    ("delete", mark("Delete"), "Del"),
    ("copy_curves", mark("Copy the curves"), "Ctrl+Alt+C"),
    ("copy_figures", mark("Copy the figures"), "Ctrl+Shift+K"),
    ("select_all", mark("Select all"), "Ctrl+A"),
    ("select_none", mark("Select none"), "Ctrl+Shift+A"),
    ("invert_selection", mark("Invert the selection"), "Ctrl+I"),
    ("rename", mark("Rename"), "F2"),
    ("rename_group", mark("Rename the group"), "Shift+F2"),
    ("tags", mark("Edit the tags"), "Ctrl+T"),
    ("notes", mark("Edit the notes"), "Ctrl+J"),
    ("earlier", mark("Move the swatch up"), "Alt+Left"),
    ("later", mark("Move the swatch down"), "Alt+Right"),
    ("new_group", mark("New group"), "Ctrl+G"),
    ("dissolve_group", mark("Dissolve the group"), "Ctrl+Shift+G"),
    ("move_up", mark("Move the reflectance up"), "Ctrl+Shift+Up"),
    ("move_down", mark("Move the reflectance down"), "Ctrl+Shift+Down"),
    ("remove", mark("Remove the reflectance"), "Ctrl+Del"),
    ("settings", mark("Settings"), "Ctrl+,"),
    *((f"preset_{n}", mark("View or form by number"), f"{n}") for n in range(1, PRESETS + 1)),
    ("frame", mark("Frame all"), "F"),
    ("play", mark("Turntable, or sweep of the incidence"), "Space"),
    ("figures", mark("Figures over the picture"), "H"),
    ("lamp_handles", mark("Lamps in the picture"), "L"),
    ("put_highlight", mark("Put the highlight where you click"), "Shift+L"),
    ("reset_view", mark("Reset the view options"), "Ctrl+0"),
    ("larger", mark("Larger"), "Ctrl++"),
    ("smaller", mark("Smaller"), "Ctrl+-"),
    ("find", mark("Search"), "Ctrl+F"),
    ("clear_filters", mark("Clear the filters"), "Ctrl+Backspace"),
    ("panels", mark("Show or hide the panels"), "F4"),
    ("panels_of_picture", mark("Show or hide the panels, in the picture"), "Tab"),
    ("two_panes", mark("Two panes"), "F3"),
    ("other_pane", mark("Go to the other pane"), "Shift+F3"),
    ("numbers", mark("Numbers"), "F5"),
    ("history", mark("History"), "F6"),
    ("paint_strip", mark("Paint strip"), "Shift+F6"),
    ("curves", mark("Curves"), "F7"),
    ("lobes", mark("Lobes"), "Shift+F7"),
    ("factors", mark("Factors"), "F8"),
    ("three_lights", mark("Three lights"), "Shift+F8"),
    ("map", mark("Colour map"), "F9"),
    ("real_time", mark("Render in real time"), "Ctrl+Alt+1"),
    ("ray_traced", mark("Render by ray tracing"), "Ctrl+Alt+2"),
    ("path_traced", mark("Render by path tracing"), "Ctrl+Alt+3"),
    ("stop_refining", mark("Stop refining"), "Ctrl+."),
    ("resume_refining", mark("Resume refining"), "Ctrl+Shift+."),
    ("blink", mark("Alternate between A and B"), "B"),
    ("flip", mark("Switch between A and B, and stay"), "Shift+B"),
    ("freeze", mark("Keep A as B"), "Ctrl+B"),
    ("follow", mark("Follow Designer"), "Ctrl+L"),
    ("next_paint", mark("Next paint"), "Right"),
    ("previous_paint", mark("Previous paint"), "Left"),
    ("next_tab", mark("Next tab or reflectance"), "Ctrl+Tab Ctrl+PgDown"),
    ("previous_tab", mark("Previous tab or reflectance"), "Ctrl+Shift+Tab Ctrl+PgUp"),
    *((f"pick_{n}", mark("Pick the colour of an angle"), f"Ctrl+{n}") for n in range(1, PRESETS + 1)),
    ("first_value", mark("Go to the first value"), "Alt+0"),
    ("edit_one", mark("Edit one angle"), "Alt+1"),
    ("edit_all", mark("Edit all angles"), "Alt+2"),
    ("edit_flop", mark("Edit the flop"), "Alt+3"),
    ("space_lab", mark("Colours in L*a*b*"), "Alt+4"),
    ("space_lch", mark("Colours in LCh"), "Alt+5"),
    ("take_standard", mark("Use this state as standard"), "Ctrl+Shift+D"),
    ("load_standard", mark("Load a standard"), "Ctrl+Shift+L"),
    ("find_nearest", mark("Find the nearest"), "Ctrl+Shift+F"),
    ("compare", mark("Compare the two selected"), "Ctrl+Shift+C"),
    ("take_paint", mark("Add the paint from Designer"), "Ctrl+Shift+I"),
    ("send_designer", mark("Send to Designer"), "Ctrl+Return"),
    ("send_viewer", mark("Send to Viewer"), "Ctrl+Shift+V"),
    ("send_lobes", mark("Send to Lobe Visualizer"), "Ctrl+Shift+Return"),
    ("show", mark("Show the reflectance"), "Ctrl+H"),
    ("solo", mark("Show the reflectance alone"), "Ctrl+Shift+H"),
    ("show_all", mark("Show all reflectances"), "Ctrl+Alt+H"),
    ("reference", mark("Set as reference"), "Ctrl+R"),
    ("open_designer", mark("Open Designer"), "Ctrl+Shift+F5"),
    ("open_viewer", mark("Open Viewer"), "Ctrl+Shift+F6"),
    ("open_lobes", mark("Open Lobe Visualizer"), "Ctrl+Shift+F7"),
    ("open_swatch", mark("Open Color Swatch"), "Ctrl+Shift+F8"),
    *((f"panel_{n}", mark("Tab of the panel"), f"Ctrl+F{n}") for n in range(1, 6)),
    ("full_screen", mark("Full screen"), "F11"),
    ("find_command", mark("Find a command"), "Ctrl+K"),
    ("manual", mark("Manual"), "F1"),
    ("shortcuts", mark("Keyboard shortcuts"), "Shift+F1"),
)
"""All commands with keys, by name."""


def sequences(command: str) -> list[QKeySequence]:
    """Return the keys of a command; KeyError where the table has no command of that name."""
    return [QKeySequence(keys) for keys in SHORTCUTS[command].keys]


def give_keys(action: QAction, command: str) -> None:
    """Give an action the keys of a command of the table; its property ``command`` says which one it is."""
    action.setShortcuts(sequences(command))
    action.setProperty("command", command)
