"""A second paint, B, beside the one on show, A."""

from __future__ import annotations

from brdf_qt.fields.choices import ChoiceBox, note
from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QPushButton, QStackedWidget, QWidget

from brdf_suite.documents.view_settings import PARAMETERS, Compare
from brdf_viewer.paint.pickers import second_picker

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
    """How two paints are shown, and which is the second; ``rest`` is the section with what is seldom changed.

    What one mode alone has stands in one place, which the others leave empty: nothing moves with the mode.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Compare"), "compare", parent, titled=False)
        self.mode = ChoiceBox(MODE_TITLES, MODE_TIPS)
        self.chooser = second_picker()
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
        self._of_mode, self._pages = QStackedWidget(), {"": QWidget()}
        for mode, label, field, tip in (
            ("swipe", tr("Divider"), self.divider, tr(divider.meaning)),
            ("blink", tr("Rate"), self.rate, tr(rate.meaning)),
            ("difference", tr("Maximum"), self.scale, tr(scale.meaning)),
        ):
            self._pages[mode] = page = Form()
            page.add_row(label, field, tip)
        for shown in self._pages.values():
            self._of_mode.addWidget(shown)
        form.add_wide(self._of_mode, self.facts)
        self.rest = Section(tr("Difference"), "compare_rest")
        basis = self.rest.add(Form())
        basis.add_row(tr("Basis"), self.basis, tr("Colours whose difference is shown"))
        self.show_compare(Compare())

    def show_compare(self, compare: Compare) -> None:
        """Show how it is compared, without a signal; what says nothing in this mode is not offered."""
        self.mode.show_choice(compare.mode)
        self.basis.show_choice(compare.basis)
        self.divider.set_value(100.0 * compare.divider)
        self.rate.set_value(compare.rate_hz)
        self.scale.set_value(compare.scale_delta_e)
        self.basis.setEnabled(compare.mode == "difference")
        self._of_mode.setCurrentWidget(self._pages.get(compare.mode, self._pages[""]))
