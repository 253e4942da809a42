"""Which paint, and what the fit makes of it."""

from __future__ import annotations

from brdf_qt.fields.choices import note, set_note
from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip, set_bold
from brdf_qt.program.translation import tr
from brdf_qt.window.section import Section
from brdf_qt.work.fit_error import fit_mark, fit_tips, is_large
from PySide6.QtWidgets import QCheckBox, QWidget

from brdf_viewer.paint.patches import PaintPatches
from brdf_viewer.paint.pickers import paint_picker


class PaintSection(Section):
    """Which paint: the one in Designer, a shipped one, or a file; and what the fit makes of it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Paint"), "paint", parent, titled=False)
        self.follow = QCheckBox(tr("Follow Designer"))
        self.follow.setToolTip(tr("Show the paint that is being edited in Designer, at every change"))
        self.chooser = paint_picker()
        self.patches = PaintPatches()
        self.fit, self.facts = note(lines=2), note()
        form = self.add(Form())
        form.add_row(tr("Paint"), self.chooser, tr("Choosing another paint stops following Designer"))
        form.add_row("", self.follow)
        form.add_wide(self.patches, self.fit)

    def complete(self, *daily: QWidget) -> None:
        """Add what else is used daily, and below it what there is to say of the paint."""
        for widget in (*daily, self.facts):
            self.add(widget)

    def set_fit_error(self, worst_delta_e: float | None, time_limited: bool, exact_follows: bool) -> None:
        """Show the largest ΔE00 at the measured angles, None where there is none; a large one stands out."""
        limited = ", " + tr("time-limited") if time_limited else ""
        if worst_delta_e is None:
            text = tr("Fit: no measured angles to compare with{limited}").format(limited=limited)
        else:
            bound = tr("Fit: maximum ΔE00 {worst:.2f} at the measured angles{limited}")
            text = bound.format(worst=worst_delta_e, limited=limited)
        set_note(self.fit, text)
        self.fit.set_mark(fit_mark(worst_delta_e, time_limited))
        set_bold(self.fit, worst_delta_e is not None and is_large(worst_delta_e))
        self.fit.setToolTip(plain_tip(fit_tips(worst_delta_e, time_limited, exact_follows)))

    def set_following(self, following: bool, linked: bool) -> None:
        self.follow.setChecked(following)
        self.follow.setText(tr("Follow Designer") if linked else tr("Follow Designer (not open)"))
