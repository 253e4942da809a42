"""How radiance becomes the light of the screen, and what the screen cannot show."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QCheckBox, QWidget

from brdf_suite.realtime.pictures.display import Unshowable
from brdf_viewer.fields.choice_box import ChoiceBox
from brdf_viewer.fields.note import note, set_note

TONE_TITLES = {
    "faithful": "Faithful, soft highlights",
    "neutral": "Neutral (Khronos PBR)",
    "characteristic": "Characteristic curve",
    "aces": "ACES (fitted)",
    "agx": "AgX",
    "linear": "Linear, clipping marked",
}
TONE_TIPS = {
    "faithful": "Shows colours unchanged; compresses only values above 0.8",
    "neutral": "Removes 4 % of reflection from dark tones, keeps hue and saturation, compresses highlights",
    "characteristic": "A film's S-shaped response in log exposure",
    "aces": "The film industry's rendering, as Hill fitted it: darker and with more contrast; 0.18 becomes 0.11",
    "agx": "Sixteen stops in a soft curve; bright saturated light desaturates to white, as on film",
    "linear": "No curve, for judging colours; highlights are clipped and marked",
}
STYLE_TITLES = {"zebra": "Stripes", "colour": "Colours"}


class ToneSection(Section):
    """How radiance becomes the light of the screen, and what the screen cannot show."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Tone", "tone", parent)
        self.curve = ChoiceBox(TONE_TITLES, TONE_TIPS)
        self.clipping = QCheckBox("Highlights")
        self.clipping.setToolTip("Mark clipped highlights: black stripes, or orange")
        self.gamut = QCheckBox("Out of gamut")
        self.gamut.setToolTip(
            "Mark colours outside the screen's gamut: grey stripes in the other direction, or blue"
        )
        self.style_box = ChoiceBox(STYLE_TITLES)
        self.counted = note()
        self.profile = QCheckBox("Monitor profile")
        self.profile.setToolTip("Convert colours with the system's profile of this monitor")
        self.profile_note = note()
        form = Form()
        form.add_row("Tone curve", self.curve, "Mapping of radiance to the screen, before its transfer curve")
        form.add_row("Show clipping", self.clipping)
        form.add_row("", self.gamut)
        form.add_row(
            "Style", self.style_box, "Style of the marks; stripes keep the colour between them visible"
        )
        form.add_wide(self.counted)
        form.add_row("Screen", self.profile)
        form.add_wide(self.profile_note)
        self.add(form)

    def set_marks(self, clipping: bool, gamut: bool, style: str) -> None:
        """Show what is marked, and how."""
        self.clipping.setChecked(clipping)
        self.gamut.setChecked(gamut)
        self.style_box.show_choice(style)
        self.style_box.setEnabled(clipping or gamut)

    def set_counted(self, counted: Unshowable | None) -> None:
        """Show how much of the object the screen cannot show; None while nothing has been counted."""
        set_note(self.counted, "" if counted is None else describe_clipping(counted))

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
        return "The object is outside the picture"
    bright, colourful = (_share(part, counted.pixels) for part in (counted.too_bright, counted.too_colourful))
    return f"Clipped highlights: {bright} of the object; out of gamut: {colourful}".replace(
        "none of the object", "none"
    )


def _share(part: int, whole: int) -> str:
    if part == 0:
        return "none"
    share = 100.0 * part / whole
    return "less than 0.1 %" if share < 0.1 else f"{share:.1f} %"
