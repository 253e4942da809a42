"""The View menu: forms, list, size, panes; keys of the suite."""

from __future__ import annotations

from functools import partial

from brdf_qt.program.translation import mark
from PySide6.QtCore import Qt

from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import SIZES
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow

_FORMS = (
    ("sphere", mark("Show as &Spheres")),
    ("panel", mark("Show as Curved &Panels")),
    ("flop_strip", mark("Show as &Flop Strips")),
    ("chips", mark("Show as Flat &Chips")),
)
_STEP = 1.25


class ViewCommands(SwatchFeature):
    """Commands on what is shown."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        view, add = window.menus["view"], window.add_command
        view.addSeparator()
        for number, (key, text) in enumerate(_FORMS, 1):
            act = partial(session.set_look, form=key, as_list=False)
            add("view", text, f"preset_{number}", act, f"form_{key}_command")
        self._list = add(
            "view",
            mark("Show as &List"),
            f"preset_{len(_FORMS) + 1}",
            lambda: session.set_look(as_list=not session.look.as_list),
            "list",
        )
        self._list.setCheckable(True)
        view.addSeparator()
        larger, smaller = partial(self._scale, _STEP), partial(self._scale, 1 / _STEP)
        add("view", mark("&Larger Swatches"), "larger", larger, "larger", icon="magnifying-glass-plus")
        add("view", mark("S&maller Swatches"), "smaller", smaller, "smaller", icon="magnifying-glass-minus")
        add("view", mark("Searc&h"), "find", self._search, "search", icon="magnifying-glass")
        clear = mark("Clear Filte&rs")
        add("view", clear, "clear_filters", lambda: session.set_state(session.state.cleared()), "clear")
        view.addSeparator()
        two = mark("&Two Panes")
        self._second = add("view", two, "two_panes", self._toggle_second, "two_panes", icon="book-open")
        self._second.setCheckable(True)
        add("view", mark("Go to the &Other Pane"), "other_pane", self._other_pane, "other_pane")
        window.toolbar.addAction(self._second)
        session.look_changed.connect(lambda _old, look: self._list.setChecked(look.as_list))
        for pane in window.panes:
            pane.close_requested.connect(lambda: self._second.setChecked(False))
        # What a first start shows where nothing was chosen yet: keys work at once.
        window.panes[0].view.setFocus(Qt.FocusReason.OtherFocusReason)

    def _scale(self, by: float) -> None:
        size = round(self._session.look.size * by)
        self._session.set_look(size=min(SIZES[1], max(SIZES[0], size)))

    def _search(self) -> None:
        self._window.bar.search.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self._window.bar.search.selectAll()

    def _toggle_second(self) -> None:
        shown = not self._window.has_two_panes
        self._second.setChecked(shown)
        self._window.second_pane_requested.emit(shown)

    def _other_pane(self) -> None:
        if self._window.has_two_panes:
            pane = self._window.panes[1 - self._session.front]
            self._session.set_front(pane.number)
            pane.view.setFocus(Qt.FocusReason.OtherFocusReason)
