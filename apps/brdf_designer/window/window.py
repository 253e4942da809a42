"""The window of Designer: the picture in the middle, below it the colours as a strip, five tabs at the right."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

from brdf_qt.fields.focus_order import order_focus
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.number import NumberField
from brdf_qt.program.icons import icon
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.start.tour import TourStep
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.message_bar import Message
from brdf_qt.window.stage import Drawer, Edge, Stage
from brdf_qt.window.tab_panel import standard_tabs
from brdf_qt.work.pictures import Pictures
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QToolButton, QWidget

from brdf_designer.coat_flakes.coat_section import CoatSection
from brdf_designer.coat_flakes.flakes_section import FlakesSection
from brdf_designer.colour.angle_plot import AnglePlot
from brdf_designer.colour.flop_strip import FlopStrip
from brdf_designer.colour.patches import PatchRow
from brdf_designer.colour.section import ColourEditors
from brdf_designer.documents.tabs_bar import DocumentTabs
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import Colours, Curves, FitState, TabState
from brdf_designer.standard_comparison.state import StandardPatch
from brdf_designer.window.menu_letters import give_letters
from brdf_designer.window.paint_sections import ModelSection, TextSection
from brdf_designer.window.pickers import ColourPickers, ReadingMenus, name_step
from brdf_designer.window.status import PaintStatus
from brdf_suite.documents.paint import Lab, Paint
from brdf_suite.foreign_text import make_visible

TABS = standard_tabs(
    paint=mark("Colours, gloss and flakes of the paint"),
    light=mark("The light that the paint stands in"),
    form=mark("The form that carries the paint, and from where it is seen"),
    compare=mark("The paint against a standard"),
    export=mark("Files for other programs, and reports"),
)
_DEEP = 420
"""Pixels that a drawer at the left is wide."""


class DesignerWindow(SuiteWindow):
    """The window of Designer: a frame, over which questions are asked, until :meth:`build` fills it.

    Its sections edit the paint session. Intents: ``new_requested``, and those of ``tabs``.
    """

    new_requested = Signal()

    takes_several_files = False
    opens_paints = True

    def __init__(self) -> None:
        super().__init__("Designer", tabs=TABS)
        self.pictures = Pictures(self)
        self._colours: Colours | None = None
        self._whole: Paint | None = None
        """The paint that all fields show; ``None`` where one of them may show something else."""
        self.stage = Stage()
        self._ordering = make_timer(self, self.order_focus)

    def build(self, session: PaintSession, shipped: Sequence[str]) -> None:
        """Make what edits the paint of ``session``, and the menus with the names of the ``shipped`` paints."""
        self.pickers = ColourPickers(session, self)
        self.strip, self.patches, self.plot = FlopStrip(session), PatchRow(), AnglePlot()
        self.tabs = DocumentTabs()
        self._build_centre()
        self._build_inspector(session)
        self.paint_status = PaintStatus(self.status)
        self._build_menus(session, shipped)

    # What a part of Designer adds.

    def add_drawer(
        self, key: str, title: str, widget: QWidget, edge: Edge, shortcut: str, icon: str, tip: str
    ) -> Drawer:
        """Add a drawer that slides over the picture, and the command that opens and closes it."""
        action = self.add_command(
            "view", title, shortcut, None, f"drawer_{key}", icon=icon, tip=tip, checked=False
        )
        return self.stage.add_drawer(key, title, widget, edge, _DEEP, action)

    def complete(self) -> None:
        """Settle what depends on every part: letters of the menus, size and place of the panels."""
        give_letters(tuple(self.menus.values()))
        self.restore_layout()

    def tour_steps(self) -> list[TourStep]:
        """Return the three steps: the picture, the tab that changes the paint, and what one does with it."""
        buttons = self.panel.buttons
        return [
            TourStep(
                self.stage,
                tr("The picture"),
                tr(
                    "The paint on a form, drawn anew at every edit. Drag to look from elsewhere, turn the wheel to "
                    "come nearer, drag with Alt to turn the light."
                ),
            ),
            TourStep(
                buttons["paint"],
                tr("The paint"),
                tr(
                    "Colours at every angle, gloss and flakes. Light and form have tabs of their own beside it, and "
                    "More at the end of each has the rest."
                ),
                partial(self.panel.show_page, "paint"),
            ),
            TourStep(
                buttons["compare"],
                tr("Compare and export"),
                tr(
                    "Compare judges the paint against a standard. Export, beside it, writes files for instruments and "
                    "other programs, and reports."
                ),
                partial(self.panel.show_page, "compare"),
            ),
        ]

    # What the controller shows.

    def show_colours(self, colours: Colours) -> None:
        """Show the document."""
        before, self._whole = self._whole, colours.paint
        self._colours = colours
        self.strip.band.show_paint(colours.paint)
        self.patches.show_colours(colours)
        self.editors.show_colours(colours)
        for section in (self.coat, self.flakes, self.model, self.texts):
            # A drag of a colour leaves the rest as it is; what is shown anew is shown whole.
            part = section.part_of(colours.paint)
            if before is None or before is colours.paint or section.part_of(before) != part:
                section.show_paint(colours.paint)
                if section is self.model:
                    self._show_model()
        self.plot.show_colours(colours)
        self.paint_status.show_colours(colours)
        if self.reading_menus.show_angles(colours.angles):
            self._order_focus_later()

    def _show_model(self) -> None:
        self.paint_status.show_model(self.model.rule.currentText(), changed=self.model.has_changed)

    def show_patches(self, colours: Colours) -> None:
        """Show colours in the patches alone."""
        self.patches.show_colours(colours)

    def show_fit(self, state: FitState) -> None:
        """Show reflectance and fit, fresh; what lies between the angles comes by :meth:`show_curves`."""
        self.show_given(state)
        self.coat.show_fit(state)
        self.model.show_notices(state.notices)
        self.paint_status.show_fit(state)

    def show_standard(self, patches: Sequence[StandardPatch] | None, labs: Mapping[int, Lab]) -> None:
        """Show a standard in the patches, in their order, and its L*a*b* by the readings; ``None``: there is none."""
        self.patches.show_standard(patches)
        self.editors.plane.show_standard(labs)

    def edit_reading(self, index: int) -> None:
        """Let the L* of a reading be typed at once, where the colours are what is seen of the panel."""
        if self.editors.plane.isVisible():
            self.editors.plane.take(index)

    def show_given(self, state: FitState) -> None:
        """Show what a fit gives at the readings in the patches alone."""
        assert self._colours is not None
        shown = [angle.index for angle in self._colours.angles]
        self.patches.show_differences(
            [state.delta_e[index] for index in shown],
            [state.given[index] for index in shown],
            time_limited=state.time_limited,
            exact_follows=state.exact_follows,
        )

    def show_curves(self, curves: Curves) -> None:
        """Show what model and lobes give over the aspecular angle, fresh."""
        for part in (self.strip, self.plot, self.paint_status):
            part.show_curves(curves)

    def mark_fit_stale(self) -> None:
        """Say that what is drawn of reflectance and fit is of the last paint that could be."""
        for part in (self.strip, self.plot, self.coat, self.paint_status):
            part.mark_stale()
        self.patches.show_differences(None)

    def show_tabs(self, tabs: Sequence[TabState], front: int) -> None:
        """Show which documents are open, whether they are saved, and which one is in front."""
        self.tabs.show_tabs(tabs, front)
        shown = tabs[front]
        self.setWindowTitle(f"{make_visible(shown.title)}[*]")
        self.setWindowFilePath(str(shown.path) if shown.path else "")
        self.setWindowModified(not shown.clean)
        for action in self._others_actions:
            action.setEnabled(len(tabs) > 1)

    def show_reopen(self, can: bool) -> None:
        """Show whether a closed tab can be reopened."""
        self.reopen_action.setEnabled(can)

    def show_message(self, message: Message) -> None:
        if message.key == "edit":
            self._whole = None  # a field holds what was refused
        super().show_message(message)

    def show_history(self, undo: str, redo: str, *, can_undo: bool, can_redo: bool) -> None:
        """Show what Undo and Redo would do, by name."""
        name_step(self.undo_action, tr("&Undo"), undo, can=can_undo)
        name_step(self.redo_action, tr("&Redo"), redo, can=can_redo)

    # How it is built.

    def _build_centre(self) -> None:
        centre, below, right = QWidget(), QWidget(), QWidget()
        tip = tr("Compare the paint with a paint, a palette, CxF3 or a measured BRDF in a file")
        self.load_standard = described(QToolButton(), name="load_standard", tip=tip)
        self.load_standard.setText(tr("Load Standard…"))
        self.load_standard.setIcon(icon("scales"))
        self.load_standard.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.load_standard.setAutoRaise(True)
        self.load_standard.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        fill_column(right, self.strip, row_of(None, self.load_standard), grows=self.strip, spacing=0)
        row = QHBoxLayout(below)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        row.addWidget(self.patches, 3)
        row.addWidget(right, 2)
        below.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        fill_column(centre, self.tabs, self.stage, below, grows=self.stage, spacing=6, margins=(8, 2, 0, 4))
        self.set_centre(centre)
        self.float_over(self.stage, self.stage.bar)
        self.tabs.new_requested.connect(self.new_requested)
        tip = tr("Show or hide L*, C* and h over the aspecular angle")
        self.add_drawer("curves", tr("Curves"), self.plot, "left", "curves", "chart-line", tip)

    def _build_inspector(self, session: PaintSession) -> None:
        self.editors = ColourEditors(session, self.pick_colour)
        self.plot.drag_started.connect(session.begin_gesture)
        self.plot.edited.connect(self.editors.edit_in_lch)
        # New buttons are the last of the window until they are put in order.
        self.editors.plane.angles_made.connect(self._order_focus_later)
        self.plot.drag_finished.connect(session.end_gesture)
        self.coat, self.flakes = CoatSection(session), FlakesSection(session)
        self.model, self.texts = ModelSection(session), TextSection(session)
        finish = QWidget()
        fill_column(finish, self.coat.daily, self.coat.note, self.flakes.has_flakes, self.flakes.daily)
        add = partial(self.add_section, tab="paint")
        add("paint", tr("Paint"), self.texts.daily)
        add("colour", tr("Colour"), self.editors)
        add("finish", tr("Gloss and flakes"), finish)
        add("angles", tr("Angles"), self.editors.head.rest, more=True)
        add("coat", tr("Coat"), self.coat, more=True)
        add("flakes", tr("Flakes"), self.flakes, more=True)
        add("model", tr("Model"), self.model, more=True)
        add("notes", tr("Notes"), self.texts, more=True)

    def _build_menus(self, session: PaintSession, shipped: Sequence[str]) -> None:
        documents, file = session.documents, self.file_menu
        new = self.add_action(file, mark("&New"), self.new_requested.emit, "new", "file-plus")
        opened = self.add_action(
            file, mark("&Open…"), lambda: self.open_requested.emit(None), "open", "folder-open"
        )
        shipped_menu = file.addMenu(tr("Open &Sample Paint"))
        for name in shipped:
            action = shipped_menu.addAction(title_of(name))
            action.triggered.connect(lambda _=False, name=name: self.shipped_requested.emit(name))
        self.add_recent_menu()
        file.addSeparator()
        save = self.add_action(
            file, mark("&Save"), lambda: documents.front.files.save(), "save", "floppy-disk"
        )
        self.add_action(file, mark("Save &As…"), lambda: documents.front.files.save_as(), "save_as")
        file.addSeparator()
        self.add_action(file, mark("&Close Tab"), lambda: documents.close(documents.front), "close", "x")
        close_others = self.add_action(
            file, mark("Close Ot&her Tabs"), lambda: documents.close_all(documents.front)
        )
        self.add_action(file, mark("Close A&ll Tabs"), lambda: documents.close_all())
        self.reopen_action = self.add_action(file, mark("Reopen Closed &Tab"), documents.reopen, "reopen")
        self.reopen_action.setEnabled(False)
        self.add_quit()
        self.undo_action = self.add_action(
            self.edit_menu, mark("&Undo"), session.undo, "undo", "arrow-counter-clockwise"
        )
        self.redo_action = self.add_action(
            self.edit_menu, mark("&Redo"), session.redo, "redo", "arrow-clockwise"
        )
        self.reading_menus = ReadingMenus(self.paint_menu, session, self.pick_colour)
        self._others_actions = [
            close_others,
            *(
                self.add_action(self.window_menu, text, partial(documents.step, by), keys)
                for text, by, keys in (
                    (mark("&Next Tab"), 1, "next_tab"),
                    (mark("&Previous Tab"), -1, "previous_tab"),
                )
            ),
        ]
        self.add_tabs_menu()
        viewer = self.openers["viewer"]
        for entry in (new, opened, save, None, self.undo_action, self.redo_action, None, viewer):
            if entry is None:
                self.toolbar.addSeparator()
            else:
                self.toolbar.addAction(entry)

    # The picker, drops and the end.

    def pick_colour(self, index: int) -> None:
        """Open the colour picker of a measurement beside the window; all its changes are one step."""
        assert self._colours is not None
        self.pickers.open(next(angle for angle in self._colours.angles if angle.index == index))

    def keep_opened(self) -> None:
        """Take what is shown for what the document had when it was opened: a double click goes back to it."""
        assert self._colours is not None
        self._whole = None
        self.strip.band.keep_opened()
        self.editors.show_all(self._colours)  # also while its numbers are not shown
        self.model.keep_opened()
        self._show_model()
        for part in (self.editors, self.coat, self.flakes, self.model):
            for field in part.findChildren(NumberField):
                field.set_default(field.value())
        for panel in (self.coat.daily, self.flakes.daily):
            for field in panel.fields.values():
                field.set_default(field.value())

    def order_focus(self) -> None:
        """Let Tab go through the window as seen: tabs, picture and drawers, colours, then the tabs at the right."""
        parts = [self.tabs, self.stage, self.patches, self.strip, self.load_standard]
        order_focus([*parts, *self.panel.focus_parts()])

    def _order_focus_later(self) -> None:
        """Order the fields that have come with the angles; those of the start are ordered once it is painted."""
        if self.isVisible() and not self._ordering.isActive():
            self._ordering.start()

    def close_pickers(self) -> None:
        """Close every picker: another document has come, and its readings are others."""
        self.pickers.close()
