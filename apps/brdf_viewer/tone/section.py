"""How radiance becomes the light of the screen, and what the screen cannot show."""

from __future__ import annotations

from brdf_qt.fields.choices import ChoiceBox, note, set_note
from brdf_qt.fields.form import Form
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.window.section import Section
from brdf_qt.window.view_titles import TONE_TIPS, TONE_TITLES
from PySide6.QtWidgets import QCheckBox, QWidget

from brdf_suite.realtime.pictures.display import Unshowable

STYLE_TITLES = {"zebra": mark("Stripes"), "colour": mark("Colours")}


class ToneSection(Section):
    """How radiance becomes the light of the screen, and what the screen cannot show."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Tone"), "tone", parent)
        self.curve = ChoiceBox(TONE_TITLES, TONE_TIPS)
        self.clipping = QCheckBox(tr("Highlights"))
        self.clipping.setToolTip(tr("Mark clipped highlights: black stripes, or orange"))
        self.gamut = QCheckBox(tr("Out of gamut"))
        self.gamut.setToolTip(
            tr("Mark colours outside the screen's gamut: grey stripes in the other direction, or blue")
        )
        self.style_box = ChoiceBox(STYLE_TITLES)
        self.counted = note(lines=1)
        self.profile = QCheckBox(tr("Monitor profile"))
        self.profile.setToolTip(tr("Convert colours with the system's profile of this monitor"))
        self.profile_note = note()
        self.glare = QCheckBox(tr("Glare"))
        self.glare.setToolTip(
            tr(
                "Spread light above white as the eye scatters it; readings, marks and linear files are without"
            )
        )
        form = self.add(Form())
        tip = tr("Mapping of radiance to the screen, before its transfer curve")
        form.add_row(tr("Tone curve"), self.curve, tip)
        form.add_row("", self.glare)
        form.add_row(tr("Show clipping"), self.clipping)
        form.add_row("", self.gamut)
        tip = tr("Style of the marks; stripes keep the colour between them visible")
        form.add_row(tr("Style"), self.style_box, tip)
        form.add_wide(self.counted)
        form.add_row(tr("Screen"), self.profile)
        form.add_wide(self.profile_note)

    def set_marks(self, clipping: bool, gamut: bool, style: str) -> None:
        self.clipping.setChecked(clipping)
        self.gamut.setChecked(gamut)
        self.style_box.show_choice(style)
        self.style_box.setEnabled(clipping or gamut)

    def set_profile(self, text: str, usable: bool, used: bool) -> None:
        """Say whose colours are shown; ``usable``: the monitor has a profile that can be turned on and off."""
        self.profile.setEnabled(usable)
        self.profile.setChecked(used)
        set_note(self.profile_note, text)


def describe_clipping(counted: Unshowable) -> str:
    """Return in words how much of the object a screen cannot show.

    >>> describe_clipping(Unshowable(1000, 12, 0))
    'Clipped highlights: 1.2 % of the object; out of gamut: none'
    """
    if counted.pixels == 0:
        return tr("The object is outside the picture")
    bright, colourful = (_share(part, counted.pixels) for part in (counted.too_bright, counted.too_colourful))
    text = tr("Clipped highlights: {bright} of the object; out of gamut: {gamut}")
    if counted.too_bright == 0:
        text = tr("Clipped highlights: none; out of gamut: {gamut}")
    return text.format(bright=bright, gamut=colourful)


def _share(part: int, whole: int) -> str:
    if part == 0:
        return tr("none")
    share = 100.0 * part / whole
    return tr("less than 0.1 %") if share < 0.1 else decimal(f"{share:.1f} %")
