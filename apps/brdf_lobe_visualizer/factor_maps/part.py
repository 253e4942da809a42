"""The panel Factors: the maps of the front reflectance where it is a product of maps, side by side, with a scale."""

from __future__ import annotations

from typing import cast

import numpy as np
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import decimal, mark, tr
from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.image_view import SliceImageView
from brdf_lobe_visualizer.cuts.images import Grid, Picture, ScaleBar
from brdf_lobe_visualizer.option_form import ChoiceField
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.window import LobeWindow
from brdf_lobe_visualizer.words import plain
from brdf_suite.inspection.factor_pictures import FactorPicture, angles_at, factor_pictures, factored_in
from brdf_suite.inspection.slices.images import DECADES, Tone, colour_codes, mapped_codes, share_of
from brdf_suite.inspection.slices.values import Channel, channel_of

_BAR_STEPS = 128
_GREYS = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1)
CHANNELS = {
    "colour": mark("colour"),
    "luminance": mark("luminance"),
    "red": mark("red"),
    "green": mark("green"),
    "blue": mark("blue"),
}
_CODES: dict[str, Channel] = {"luminance": "luminance", "red": "r", "green": "g", "blue": "b"}
TONES = {"gamma": mark("perceptual"), "log": mark("logarithmic")}
_READS = {
    "wi": "ωi",
    "wo": "ωo",
    "h": "h",
    "|wi|": "|ωi|",
    "|wo|": "|ωo|",
    "|h|": "|h|",
    "sqrt|h|": "√|h|",
    "w.h": "ω·h",
    "wi.wo": "ωi·ωo",
    "w.h,h.n": "ω·h, h·n",
    "wi.n,wo.n": "ωi·n, ωo·n",
}
"""How the paper writes what a map is read by."""


def title_of(picture: FactorPicture) -> str:
    """Return the factors as the paper writes them: p(ωi) p(ωo)."""
    name = picture.name or "?"
    return " ".join(f"{name}({_READS[read]})" for read in picture.reads)


def grid_of(pictures: tuple[FactorPicture, ...], channel: str, tone: Tone) -> Grid:
    """Return the pictures in one row, each over its largest value."""
    drawn = {}
    for number, picture in enumerate(pictures):
        if channel == "colour":
            codes, value = colour_codes(picture.values, tone, 1.0), channel_of(picture.values, "luminance")
        else:
            value = channel_of(picture.values, _CODES[channel])
            codes = mapped_codes(share_of(value, tone, 1.0), _GREYS)
        notes = (tr("added peak"), tr("peak")) if picture.part == "peak" else ()
        drawn[0, number] = Picture(codes, value, nothing=picture.outside, notes=notes)
    return Grid(("",), tuple(map(title_of, pictures)), drawn, _bar(tone))


def _bar(tone: Tone) -> ScaleBar:
    values = (
        (1.0, 0.5, 0.2, 0.1, 0.02) if tone == "gamma" else tuple(10.0**-k for k in range(int(DECADES) + 1))
    )
    ticks = tuple((float(share_of(value, tone, 1.0)), plain(value)) for value in values)
    return ScaleBar(mapped_codes(np.linspace(0.0, 1.0, _BAR_STEPS), _GREYS), ticks, tr("relative to maximum"))


class FactorsView(SliceImageView):
    """Draws the maps of one reflectance."""

    def __init__(self) -> None:
        super().__init__("factor_maps", tr("Maps of the factors"))
        self._pictures: tuple[FactorPicture, ...] = ()

    def show_pictures(self, pictures: tuple[FactorPicture, ...], channel: str, tone: Tone, why: str) -> None:
        """Show maps, or ``why`` there are none."""
        self._pictures = pictures
        self.empty.setText(why)
        self.show_grid(grid_of(pictures, channel, tone) if pictures else None)

    def head_at(self, column: int, x: float, y: float) -> str:
        """Return the map, and where in it the mouse is: a direction, or the numbers that it is over."""
        picture = self._pictures[column]
        title = title_of(picture)
        if picture.form == "disc":
            angles = angles_at(x, y)
            if angles is None:
                return title
            theta, phi = decimal(f"{angles[0]:.1f}"), decimal(f"{angles[1]:.0f}")
            return tr("{map}: θ {theta}°, φ {phi}°").format(map=title, theta=theta, phi=phi)
        if picture.form == "band":
            return tr("{map}: at {x}").format(map=title, x=f"{x:.2f}")
        return tr("{map}: at {x}, {y}").format(map=title, x=f"{x:.2f}", y=f"{1.0 - y:.2f}")


class FactorsPanel(QWidget):
    """The maps with their choices. Signal: ``seen()``."""

    seen = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("factors")
        self.view = FactorsView()
        self.note = described(PlainLabel(), name="factors_note")
        self.channel = described(ChoiceField(CHANNELS, "colour"), spoken=tr("Channel of the maps"))
        tip = tr("Each map is scaled to its maximum. The logarithmic scale covers four decades.")
        self.tone = described(ChoiceField(TONES, "gamma"), spoken=tr("Scale of the maps"), tip=tip)
        head = row_of(self.channel, self.tone, self.note, grows=self.note)
        fill_column(self, head, self.view, grows=self.view, spacing=4, margins=(8, 4, 8, 8))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.seen.emit()


class Factors(Feature, QObject):
    """A part of the window: the panel Factors at the bottom, hidden at a first start."""

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session = session
        self._ready = self._closed = False
        self.panel = FactorsPanel()
        self.dock = window.add_dock("factors", mark("Factors"), self.panel)
        self._fields = {
            "factor-channel": (self.panel.channel, "lobes/factor_channel"),
            "factor-scale": (self.panel.tone, "lobes/factor_tone"),
        }
        for script_key, (field, setting) in self._fields.items():
            stored = settings().value(setting)
            if field.findData(stored) >= 0:
                field.set_choice(stored)
            field.chosen.connect(lambda choice, key=script_key: self.run_script(key, choice))
        self.panel.seen.connect(self._show)
        session.subjects_changed.connect(self._show)
        session.front_changed.connect(self._show)
        # Drawing maps imports reflectances, which are not needed before the window is painted.
        window.first_painted.connect(lambda: QTimer.singleShot(0, self, self._begin))
        tip = mark("Show or hide the maps of a factored reflectance")
        window.add_command(
            "view", mark("&Factors"), "factors", lambda: self.dock.setVisible(self.dock.isHidden()), tip=tip
        )

    @property
    def is_idle(self) -> bool:
        return self._ready

    def close(self) -> None:
        """What is hidden while the window goes is shown no more."""
        self._closed = True

    def run_script(self, key: str, value: str) -> bool:
        """Choose channel or scale, and remember it: ``factor-channel=NAME``, ``factor-scale=gamma|log``."""
        field, setting = self._fields.get(key, (self.panel.channel, ""))
        if not setting or field.findData(value) < 0:
            return False
        settings().setValue(setting, value)
        field.set_choice(value)
        self._show()
        return True

    def _begin(self) -> None:
        self._ready = True
        self._show()

    def _show(self) -> None:
        if self._closed or not self._ready or not self.panel.isVisible():
            return
        front = self._session.front
        value = None if front is None else factored_in(front.reflectance)
        tone, channel = cast(Tone, self.panel.tone.choice), str(self.panel.channel.choice)
        if front is None or value is None:
            why = tr("No reflectance shown. Add one.") if front is None else tr("{name} is not factored.")
            why = why.format(name="" if front is None else front.title)
            hint = tr("Create a factored reflectance with brdf-suite factorize.") if front is not None else ""
            self.panel.view.show_pictures((), channel, tone, "\n".join(filter(None, (why, hint))))
            self.panel.note.setText("")
            return
        pictures = factor_pictures(value)
        self.panel.view.show_pictures(pictures, channel, tone, "")
        alpha = ", ".join(decimal(f"{number:.3g}") for number in value.terms[0][0].tolist())
        texels = ", ".join(f"{one.name} {one.texels}" for one in pictures)
        text = tr("{name}: α {alpha} 1/sr; texels: {texels}")
        self.panel.note.setText(text.format(name=front.title, alpha=alpha, texels=texels))
