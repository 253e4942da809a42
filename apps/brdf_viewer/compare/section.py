"""A second paint, B, beside the one on show, A."""

from __future__ import annotations

from brdf_qt.fields.choices import ChoiceBox, SourceChooser, note
from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QPushButton, QWidget

from brdf_suite.documents.view_settings import PARAMETERS, Compare

MODE_TITLES = {
    "off": mark("Off"),
    "side": mark("Side by side"),
    "swipe": mark("Swipe"),
    "blink": mark("Blink"),
    "difference": mark("Difference (ΔE00)"),
}
MODE_TIPS = {
    "off": mark("Only the current paint"),
    "side": mark("Each has half the picture with its own framing"),
    "swipe": mark("One picture: A left of the line, B right of it; drag the line"),
    "blink": mark("Alternately in the same place"),
    "difference": mark("Colour difference of each pixel on a colour scale"),
}
BASIS_TITLES = {"light": mark("Light"), "picture": mark("Picture")}
BASIS_TIPS = {
    "light": mark("Exposed radiance before the tone curve; radiance 1 has L* = 100"),
    "picture": mark("Displayed colours after the tone curve"),
}


class CompareSection(Section):
    """How two paints are shown, and which is the second."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Compare"), "compare", parent)
        self.mode = ChoiceBox(MODE_TITLES, MODE_TIPS)
        self.chooser = SourceChooser(tr("Open a paint, a measured file or a picture (.exr, .png) as B"))
        self.freeze = QPushButton(tr("Freeze A as B"))
        self.freeze.setToolTip(tr("Keep the current paint as B while A changes (Ctrl+B)"))
        divider, rate, scale = (PARAMETERS[f"compare.{n}"] for n in ("divider", "rate_hz", "scale_delta_e"))
        self.divider = NumberField(tr("Divider"), "%", 0.0, 100.0, 1.0, 1, 100.0 * divider.default)
        self.rate = NumberField(tr("Rate"), *reach_of(rate, 0.1, 1))
        self.scale = NumberField(tr("Maximum"), *reach_of(scale, 0.5, 1))
        self.basis = ChoiceBox(BASIS_TITLES, BASIS_TIPS)
        self.facts = note()
        form = self.add(Form())
        form.add_row(tr("Show"), self.mode, tr("Comparison of A and B; press B to blink"))
        tip = tr("Paint or picture that the current paint is compared with")
        form.add_row(tr("Second (B)"), self.chooser, tip)
        form.add_row("", self.freeze)
        self._shown_in: dict[QWidget, str] = {}
        for mode, label, field, tip in (
            ("swipe", tr("Divider"), self.divider, tr(divider.meaning)),
            ("blink", tr("Rate"), self.rate, tr(rate.meaning)),
            ("difference", tr("Basis"), self.basis, tr("Colours whose difference is shown")),
            ("difference", tr("Maximum"), self.scale, tr(scale.meaning)),
        ):
            self._shown_in |= {form.add_row(label, field, tip): mode, field: mode}
        form.add_wide(self.facts)
        self.show_compare(Compare())

    def show_compare(self, compare: Compare) -> None:
        """Show how it is compared, without a signal; what says nothing in this mode is hidden."""
        self.mode.show_choice(compare.mode)
        self.basis.show_choice(compare.basis)
        self.divider.set_value(100.0 * compare.divider)
        self.rate.set_value(compare.rate_hz)
        self.scale.set_value(compare.scale_delta_e)
        for widget, mode in self._shown_in.items():
            widget.setVisible(mode == compare.mode)
