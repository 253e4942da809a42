"""The panel Factors: the maps of the front reflectance where it is a product of maps, with channel and tone."""

from __future__ import annotations

from typing import cast

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from brdf_lobe_visualizer.choice_field import ChoiceField
from brdf_lobe_visualizer.factors.view import CHANNELS, TONES, FactorsView
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.inspection.factor_pictures import factor_pictures, factored_in
from brdf_suite.inspection.slices.images import Tone

_CHANNEL_KEY, _TONE_KEY = "lobes/factor_channel", "lobes/factor_tone"


class FactorsPanel(QWidget):
    """The maps with their choices. Signals: ``channel_chosen(str)``, ``tone_chosen(str)``, ``seen()``."""

    channel_chosen = Signal(str)
    tone_chosen = Signal(str)
    seen = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("factors")
        self.view = FactorsView()
        self.note = PlainLabel()
        self.note.setObjectName("factors_note")
        self.channel = ChoiceField(CHANNELS, "colour")
        self.channel.setAccessibleName(tr("Channel of the maps"))
        self.tone = ChoiceField(TONES, "gamma")
        self.tone.setAccessibleName(tr("Scale of the maps"))
        self.tone.setToolTip(
            tr("Each map is scaled to its maximum. The logarithmic scale covers four decades.")
        )
        self.channel.chosen.connect(self.channel_chosen)
        self.tone.chosen.connect(self.tone_chosen)
        head = QHBoxLayout()
        head.setSpacing(8)
        head.addWidget(self.channel)
        head.addWidget(self.tone)
        head.addWidget(self.note, 1)
        box = QVBoxLayout(self)
        box.setContentsMargins(8, 4, 8, 8)
        box.setSpacing(4)
        box.addLayout(head)
        box.addWidget(self.view, 1)

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
        self.dock = window.add_dock(
            "factors", mark("Factors"), self.panel, Qt.DockWidgetArea.BottomDockWidgetArea
        )
        self._channel = _known(str(settings().value(_CHANNEL_KEY, "colour")), CHANNELS, "colour")
        self._tone = _known(str(settings().value(_TONE_KEY, "gamma")), TONES, "gamma")
        self.panel.channel.set_choice(self._channel)
        self.panel.tone.set_choice(self._tone)
        self.panel.channel_chosen.connect(self.choose_channel)
        self.panel.tone_chosen.connect(self.choose_tone)
        self.panel.seen.connect(self._show)
        session.subjects_changed.connect(self._show)
        session.front_changed.connect(self._show)
        # Drawing maps imports reflectances, which are not needed before the window is painted.
        window.first_painted.connect(lambda: QTimer.singleShot(0, self, self._begin))
        window.add_command(
            "view",
            mark("&Factors"),
            "Ctrl+M",
            self._toggle,
            tip=mark("Show or hide the maps of a factored reflectance"),
        )

    @property
    def is_idle(self) -> bool:
        """Whether what is looked at is there."""
        return self._ready

    def close(self) -> None:
        """What is hidden while the window goes is shown no more."""
        self._closed = True

    def choose_channel(self, channel: str) -> None:
        """Show another channel, and remember it."""
        self._channel = channel
        settings().setValue(_CHANNEL_KEY, channel)
        self.panel.channel.set_choice(channel)
        self._show()

    def choose_tone(self, tone: str) -> None:
        """Show with another scale, and remember it."""
        self._tone = tone
        settings().setValue(_TONE_KEY, tone)
        self.panel.tone.set_choice(tone)
        self._show()

    def run_script(self, key: str, value: str) -> bool:
        """Take ``factor-channel=NAME`` and ``factor-scale=gamma|log`` from the command line."""
        if key == "factor-channel" and value in CHANNELS:
            self.choose_channel(value)
        elif key == "factor-scale" and value in TONES:
            self.choose_tone(value)
        else:
            return False
        return True

    def _toggle(self) -> None:
        self.dock.setVisible(self.dock.isHidden())

    def _begin(self) -> None:
        self._ready = True
        self._show()

    def _show(self) -> None:
        if self._closed or not self._ready or not self.panel.isVisible():
            return
        front = self._session.front
        value = None if front is None else factored_in(front.reflectance)
        tone = cast(Tone, self._tone)
        if front is None or value is None:
            why = tr("No reflectance shown. Add one.") if front is None else tr("{name} is not factored.")
            why = why.format(name="" if front is None else front.title)
            hint = tr("Create a factored reflectance with brdf-suite factorize.") if front is not None else ""
            self.panel.view.show_pictures((), self._channel, tone, "\n".join(filter(None, (why, hint))))
            self.panel.note.setText("")
            return
        pictures = factor_pictures(value)
        self.panel.view.show_pictures(pictures, self._channel, tone, "")
        alpha = ", ".join(f"{number:.3g}" for number in value.terms[0][0].tolist())
        texels = ", ".join(f"{one.name} {one.texels}" for one in pictures)
        self.panel.note.setText(
            tr("{name}: α {alpha} 1/sr; texels: {texels}").format(
                name=front.title, alpha=alpha, texels=texels
            )
        )


def _known(value: str, choices: dict[str, str], default: str) -> str:
    return value if value in choices else default
