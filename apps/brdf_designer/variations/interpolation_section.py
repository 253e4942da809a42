"""Between two paints: which other one, how far on the way to it, and small pictures along it."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.form import fill_column, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from brdf_qt.program.translation import tr
from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QWidget

from brdf_designer.variations.section import PictureButton
from brdf_designer.window.widgets import combo, wrapped
from brdf_suite.foreign_text import make_visible
from brdf_suite.paint_design.mix import LEAST_SHARE, MOST_SHARE

STOPS = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Where the small pictures are."""
FILE = "file"


class InterpolationSection(QWidget):
    """The body of the section.

    Intents: ``other_chosen(key)`` of an entry of :meth:`show_others`; ``share_edited(value)``, 0 at the paint and 1 at
    the other, with ``gesture_started`` and ``gesture_finished`` around a drag; ``stop_taken(value)`` by a click.
    """

    other_chosen = Signal(str)
    share_edited = Signal(float)
    gesture_started = Signal()
    gesture_finished = Signal()
    stop_taken = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        tip = tr("Paint at the other end: an open tab, a sample paint, or a file")
        self.others = combo((), tr("The other paint"), tip)
        self.others.setMaxVisibleItems(24)
        self.others.activated.connect(lambda _index: self.other_chosen.emit(self.others.currentData() or ""))
        self.hint = wrapped(tr("Choose the paint at the other end."))
        self.body = QWidget()
        fill_column(self, self.others, self.hint, self.body)
        self._build_body()
        self.body.hide()

    def show_others(self, entries: Sequence[tuple[str, str]], chosen: str) -> None:
        """Show (key, title) of the paints to choose from; an empty title is a line between groups."""
        with QSignalBlocker(self.others):
            self.others.clear()
            self.others.setPlaceholderText(tr("Interpolate to…"))
            for key, title in entries:
                if title:
                    self.others.addItem(make_visible(title), key)
                else:
                    self.others.insertSeparator(self.others.count())
            self.others.setCurrentIndex(self.others.findData(chosen) if chosen else -1)

    def show_ends(self, first: str | None, second: str = "") -> None:
        """Show the names of both ends; ``None``: there is no other paint yet."""
        self.body.setVisible(first is not None)
        self.hint.setVisible(first is None)
        if first is not None:
            self.first.setText(first)
            self.second.setText(second)

    def show_share(self, share: float) -> None:
        """Show how far on the way the paint is."""
        with QSignalBlocker(self.slider):
            self.slider.setValue(round(1000.0 * share))
        self.number.set_value(100.0 * share)

    def _build_body(self) -> None:
        self.stops = [PictureButton(f"between_{round(100 * stop)}", 44) for stop in STOPS]
        for stop, button in zip(STOPS, self.stops, strict=True):
            button.setText(f"{100 * stop:.0f} %")
            button.setToolTip(
                plain_tip(tr("Click to use the paint at {percent:.0f} %").format(percent=100 * stop))
            )
            button.clicked.connect(lambda _=False, stop=stop: self.stop_taken.emit(stop))
        self.slider = QuietSlider(Qt.Orientation.Horizontal)
        self.slider.setAccessibleName(tr("Share of the other paint, %"))
        self.slider.setSingleStep(10)
        self.slider.setPageStep(100)
        self.slider.sliderPressed.connect(self.gesture_started)
        self.slider.sliderReleased.connect(self.gesture_finished)
        self.slider.valueChanged.connect(lambda value: self._edited(value / 1000.0))
        self.first, self.second = PlainLabel(), PlainLabel()
        self.second.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for label in (self.first, self.second):
            label.setMinimumWidth(24)
        self.number = NumberField(
            tr("Share of the other paint"), "%", 100.0 * LEAST_SHARE, 100.0 * MOST_SHARE, 1.0, 1, 0.0
        )
        for share in (self.slider, self.number):
            share.setToolTip(tr("Position of the mixture: 0 % is this paint, 100 % the other one"))
        self.number.edited.connect(lambda value: self._edited(value / 100.0))
        self.number.gesture_started.connect(self.gesture_started)
        self.number.gesture_finished.connect(self.gesture_finished)
        ends = row_of(self.first, self.number, self.second)
        ends.setStretchFactor(self.first, 1)
        ends.setStretchFactor(self.second, 1)
        self.beyond = QCheckBox(tr("Beyond the ends"))
        self.beyond.setToolTip(tr("Extend the range from −50 to 150 %"))
        self.beyond.toggled.connect(self._set_reach)
        fill_column(self.body, row_of(*self.stops, spacing=0), self.slider, ends, self.beyond, spacing=4)
        self._set_reach(False)

    def _set_reach(self, beyond: bool) -> None:
        low, high = (LEAST_SHARE, MOST_SHARE) if beyond else (0.0, 1.0)
        with QSignalBlocker(self.slider):
            self.slider.setRange(round(1000 * low), round(1000 * high))
        self.number.setRange(100.0 * low, 100.0 * high)

    def _edited(self, share: float) -> None:
        self.show_share(share)
        self.share_edited.emit(share)
