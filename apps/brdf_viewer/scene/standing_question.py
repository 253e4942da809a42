"""Asks how a mesh stands that looks wrong: axis up and unit, over the picture, which shows each answer at once.

Of a CAD file it also asks how near its triangles come to its surfaces.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import PurePath

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.labels import PlainLabel, set_bold
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.translation import decimal, tr
from brdf_qt.window.floating import Floating
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QButtonGroup, QFrame, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import PARAMETERS, SurfaceLook
from brdf_suite.files.meshes.kinds import CAD_ENDINGS
from brdf_suite.realtime.camera import frame
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.standing import Standing, find_standing
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.surface.section import UNIT_TITLES, UP_TITLES
from brdf_viewer.window import ViewerWindow

_FINENESS = PARAMETERS["surface.tessellation_mm"]
_ASKED = {
    "up": {key: UP_TITLES[key] for key in ("y", "z")},
    "unit": {key: UNIT_TITLES[key] for key in ("m", "cm", "mm", "in")},
}


class StandingPanel(Floating):
    """Two rows of choices, for CAD files a number, and a size. Signals: ``answered(field, value)``, ``closed()``."""

    answered = Signal(str, object)
    closed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Edge.BottomEdge, parent)
        self.setObjectName("standing")
        self.choices = {field: _choices(titles) for field, titles in _ASKED.items()}
        self.extent = PlainLabel()
        self.done = QPushButton(tr("Looks Right"))
        self.done.clicked.connect(self.closed)
        paper = QFrame()
        paper.setFrameShape(QFrame.Shape.StyledPanel)
        paper.setAutoFillBackground(True)
        self.question = PlainLabel()
        set_bold(self.question, True)
        self.fineness = NumberField(tr("Fineness"), *reach_of(_FINENESS, 0.05, 3))
        self.fineness.setToolTip(tr(_FINENESS.meaning))
        self.fineness.edited.connect(lambda value: self.answered.emit("tessellation_mm", value))
        self._fineness_title = PlainLabel(tr("Fineness"))
        column = QVBoxLayout(paper)
        column.addWidget(self.question)
        row = QHBoxLayout()
        for field, group in self.choices.items():
            for button in group.buttons():
                row.addWidget(button)
            group.buttonClicked.connect(
                lambda button, field=field: self.answered.emit(field, button.objectName())
            )
            row.addSpacing(12)
        row.addWidget(self._fineness_title)
        row.addWidget(self.fineness)
        row.addStretch(1)
        column.addLayout(row)
        last = QHBoxLayout()
        last.addWidget(self.extent, 1)
        last.addWidget(self.done)
        column.addLayout(last)
        outside = QVBoxLayout(self)
        outside.setContentsMargins(0, 0, 0, 0)
        outside.addWidget(paper)
        self.hide()

    def show_look(self, look: SurfaceLook, mesh: Mesh, *, of_cad: bool) -> None:
        """Show the present answers, and how large that makes the surface; ``of_cad``: also how fine it is cut."""
        self.question.setText(
            tr("Is it upright, the right size, and fine enough?")
            if of_cad
            else tr("Is it upright, and the right size?")
        )
        self._fineness_title.setVisible(of_cad)
        self.fineness.setVisible(of_cad)
        self.fineness.set_value(look.tessellation_mm)
        for field, group in self.choices.items():
            for button in group.buttons():
                button.setChecked(button.objectName() == getattr(look, field))
        low, high = mesh.bounds()
        x, y, z = (decimal(f"{edge:.3g}") for edge in high - low)
        words = tr("Now {width} × {depth} m, {height} m high")
        self.extent.setText(words.format(width=x, depth=z, height=y))


class StandingQuestion(ViewerFeature):
    """Proposes an answer where there is none, shows it, and takes another; the view keeps it with the file."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        self.panel = StandingPanel()
        self.panel.float_over(window.picture, window.picture)
        self.panel.answered.connect(lambda field, value: self._answer(**{field: value}))
        self.panel.closed.connect(self.panel.hide)
        self._seen: Mesh | None = None
        self._asked = ""
        state.contents_changed.connect(self._look)
        state.view_changed.connect(self._view_changed)

    def _look(self) -> None:
        """Look at a surface that was loaded; what has been asked is not asked again."""
        surface = self._state.surface
        if surface is None or surface.value is self._seen or surface.key != self._state.view.surface:
            return  # the view names a new surface a moment after it is there
        self._seen = surface.value
        if not self.panel.isHidden():
            if surface.key == self._asked:
                self._show()
                return
            self.panel.hide()
        look = self._state.view.surface_look
        if surface.key == self._asked or (look.up, look.unit) != ("file", "file"):
            return
        found = find_standing(surface.value)
        proposed = found if found is not None and found.is_doubtful else None
        if proposed is not None or (_is_cad(surface.key) and look.tessellation_mm == _FINENESS.default):
            self._asked = surface.key
            # Later: this comes from within a change of the view.
            QTimer.singleShot(0, self, lambda: self._ask(proposed))

    def _ask(self, proposed: Standing | None) -> None:
        """Show the question, and the likeliest answer; undone together with the opening of the file."""
        view = self._state.view
        if view.surface != self._asked:
            return
        self.panel.show()
        self._show()
        if proposed is not None:
            look = replace(view.surface_look, up=proposed.up, unit=proposed.unit)
            self._state.follow_view(surface_look=look, camera=frame(view.camera))

    def _show(self) -> None:
        """Show the view's answers."""
        if self._seen is not None:
            self.panel.show_look(self._state.view.surface_look, self._seen, of_cad=_is_cad(self._asked))

    def _answer(self, **fields: str | float) -> None:
        """Show an answer in the picture, where it may be undone as any change."""
        look = replace(self._state.view.surface_look, **fields)  # type: ignore[arg-type]  # its check says what is wrong
        self._state.change_view(surface_look=look, camera=frame(self._state.view.camera))

    def _view_changed(self, old: View, new: View) -> None:
        if new.surface != old.surface:
            self._look()
        if new.surface != self._asked:
            self.panel.hide()
        elif not self.panel.isHidden():
            self._show()


def _is_cad(key: str) -> bool:
    return PurePath(key).suffix.lower() in CAD_ENDINGS


def _choices(titles: Mapping[str, str]) -> QButtonGroup:
    group = QButtonGroup()
    for key, title in titles.items():
        button = ChoiceButton(tr(title))
        button.setObjectName(key)
        group.addButton(button)
    return group
