"""Step 5: what of the picture is measured: arm, reflections and dust are painted out by hand."""

from __future__ import annotations

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QSizePolicy

from brdf_designer.acquire.exposures.page import percent
from brdf_designer.acquire.mask.view import LEAST_RADIUS, MOST_RADIUS, MaskView
from brdf_designer.acquire.plots.tone import Tones, drawn
from brdf_designer.acquire.step_page import Facts, PositionPage
from brdf_designer.window.widgets import button, make_row, wrapped
from brdf_suite.arrays import Bools


class MaskPage(PositionPage):
    """The page of the mask. Intents: ``mask_edited()``."""

    mask_edited = Signal()

    def __init__(self) -> None:
        super().__init__(
            "mask",
            tr(
                "Paint over the arm, its reflection and dust to exclude them. The lower half "
                "is always excluded."
            ),
            least_ev=-10.0,
        )
        self._tones: Tones | None = None
        self.picture = MaskView(tr("Mask over a photograph"), tr("Open a session first."))
        self.centre.addWidget(self.picture, 1)
        self.leave_out, self.take_in = ChoiceButton(tr("Exclude")), ChoiceButton(tr("Include"))
        modes = QButtonGroup(self)
        for one, tip in (
            (self.leave_out, tr("The brush excludes pixels from the measurement (X switches)")),
            (self.take_in, tr("The brush includes pixels in the measurement again (X switches)")),
        ):
            modes.addButton(one)
            one.setToolTip(plain_tip(tip))
            one.setAutoRaise(False)
            one.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            one.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.leave_out.setChecked(True)
        self.take_in.toggled.connect(self.picture.set_takes_in)
        self.picture.mode_changed.connect(
            lambda on: (self.take_in if on else self.leave_out).setChecked(True)
        )
        form = Form()
        self.radius = NumberField(
            tr("Radius"), tr("pixels"), LEAST_RADIUS, MOST_RADIUS, 1.0, 1, self.picture.radius
        )
        self.radius.edited.connect(self.picture.set_radius)
        self.picture.radius_changed.connect(self.radius.set_value)
        form.add_row(
            tr("Radius"),
            self.radius,
            tr("Radius of the brush; [ and ] change it while the picture has the focus"),
        )
        self.undo = button(tr("Undo"), tr("Undo the last stroke (Ctrl+Z)"), self.picture.undo)
        self.redo = button(tr("Redo"), tr("Redo the last undone stroke (Ctrl+Shift+Z)"), self.picture.redo)
        self.picture.mask_edited.connect(self._edited)
        self.add_part(
            "brush", tr("Brush"), make_row(self.leave_out, self.take_in), form, make_row(self.undo, self.redo)
        )
        self.everything = button(
            tr("Include All"),
            tr("Replace the mask by one that excludes no pixels"),
            self.picture.include_all,
        )
        self.facts = Facts(tr("The mask"))
        self.kept = wrapped()
        self.add_part("mask", tr("Mask"), self.facts, self.everything, self.kept)
        self.brightness.edited.connect(lambda _value: self._draw())
        look = self.position_form(tr("Position of the photograph below the mask"))
        self.add_part("look", tr("Picture"), look)
        self._show_state()

    def show_picture(self, tones: Tones | None) -> None:
        """Show the picture below the mask."""
        self._tones = tones
        if tones is None:
            self.picture.show_empty(tr("Open a session first."))
            self.picture.show_mask(None)
        self._draw()

    def show_mask(self, used: Bools | None) -> None:
        """Show a mask that was read; its steps begin anew."""
        self.picture.show_mask(used)
        self._show_state()

    def _edited(self) -> None:
        self._show_state()
        self.mask_edited.emit()

    def _show_state(self) -> None:
        history = self.picture.history
        for one in (self.leave_out, self.take_in, self.radius, self.everything):
            one.setEnabled(history is not None)
        self.undo.setEnabled(history is not None and history.can_undo)
        self.redo.setEnabled(history is not None and history.can_redo)
        share = percent(0.0 if history is None else 1.0 - history.share)
        self.facts.show_rows(
            [(tr("Excluded"), share, tr("Share of all pixels of the picture that the mask excludes"))]
        )

    def _draw(self) -> None:
        if self._tones is not None:
            self.picture.show_image(drawn(self._tones, self.brightness.value()))
