"""The flop as four handles: flop index, and the travel of lightness, chroma and hue about a face that stays."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from brdf_qt.fields.colour_slider import ColourSlider
from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.number import NumberField
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QGridLayout, QWidget

from brdf_designer.colour.angle_editor import add_slider_row, slider_grid
from brdf_designer.colour.display import lab_to_codes
from brdf_designer.session.edits import SetFlop, moved_labs
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import Colours
from brdf_designer.window.widgets import wrapped
from brdf_suite.appearance.flop.edits import FlopValues, flop_ends, measure_flop
from brdf_suite.errors import ValueRangeError

_QUIET_MS = 40
_TRACK_SAMPLES = 17


@dataclass(frozen=True)
class Handle:
    """One handle: its name in :class:`FlopValues`, label, reach, an explanation, step, unit."""

    key: str
    label: str
    low: float
    high: float
    tip: str
    step: float = 0.5
    unit: str = ""


_INDEX_TIP = mark(
    "Flop index 2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 for a solid colour, about 15 to 17 for a very high "
    "flop. It needs readings at 15, 45 and 110°."
)
_LIGHTNESS_TIP = mark(
    "Travel of lightness: L* at the farthest angle minus L* at the nearest. Negative: the paint darkens."
)
_CHROMA_TIP = mark(
    "Travel of chroma: C* at the farthest angle minus C* at the nearest. Negative: the paint greys."
)
_HUE_TIP = mark(
    "Travel of hue: rotation in degrees from the nearest to the farthest angle, "
    "positive from red towards yellow. A grey has no hue."
)
HANDLES = (
    Handle("index", mark("Flop index"), 0.0, 40.0, _INDEX_TIP, step=0.1),
    Handle("lightness", mark("ΔL* travel"), -150.0, 100.0, _LIGHTNESS_TIP),
    Handle("chroma", mark("ΔC* travel"), -120.0, 120.0, _CHROMA_TIP),
    Handle("hue", mark("Δh travel"), -180.0, 180.0, _HUE_TIP, step=1.0, unit="°"),
)
DECIMALS = 1
"""Of the number of each handle."""


class FlopPanel(QWidget):
    """Edits the flop of the paint. The track of a slider shows the far end's colour that each position would give."""

    def __init__(self, session: PaintSession) -> None:
        super().__init__()
        self._session = session
        grid = slider_grid()
        self.sliders: dict[str, ColourSlider] = {}
        self.fields: dict[str, NumberField] = {}
        for row, handle in enumerate(HANDLES):
            self._add(grid, row, handle)
        self._readings: tuple[list[float], np.ndarray] | None = None
        self._tracks = make_timer(self, self._show_tracks, _QUIET_MS)
        self.note = wrapped()
        box = fill_column(self, self.note, margins=(0, 0, 0, 4))
        box.insertLayout(0, grid)

    def _add(self, grid: QGridLayout, row: int, handle: Handle) -> None:
        name = tr(handle.label)
        slider = ColourSlider(
            tr("{name}, slider").format(name=name), handle.unit, handle.low, handle.high, 0.1
        )
        field = NumberField(name, handle.unit, handle.low, handle.high, handle.step, DECIMALS, handle.low)
        field.setObjectName(f"flop_{handle.key}")
        label = PlainLabel(name)
        for widget in (label, slider, field):
            widget.setToolTip(tr(handle.tip))
        session = self._session
        add_slider_row(
            grid, row, session, label, slider, field, lambda value: session.edit(SetFlop(handle.key, value))
        )
        self.sliders[handle.key], self.fields[handle.key] = slider, field

    def show_colours(self, colours: Colours) -> None:
        """Show the flop of the paint; what it has none of cannot be moved."""
        angles = [item.aspecular_deg for item in colours.paint.measurements]
        labs = np.array([item.lab for item in colours.paint.measurements])
        self._readings = None
        try:
            now, ends = measure_flop(angles, labs), flop_ends(angles)
        except ValueRangeError as error:
            self._show(FlopValues(math.nan, math.nan, math.nan, math.nan))
            self.note.setText(tr("No flop: {reason}.").format(reason=tr_core(error.reason)))
            return
        self._readings = (angles, labs)
        self._show(now)
        if self.isVisible():
            self._tracks.start()
        self.note.setText(
            tr("From {near:g}° to {far:g}°; the colour at {face:g}° stays.").format(
                near=angles[ends.near], far=angles[ends.far], face=angles[ends.face]
            )
        )

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._tracks.start()

    def _show(self, now: FlopValues) -> None:
        for handle, value in zip(HANDLES, (now.index, now.lightness, now.chroma, now.hue_deg), strict=True):
            key, known = handle.key, math.isfinite(value)
            for widget in (self.sliders[key], self.fields[key]):
                widget.setEnabled(known)
            if known:
                self.sliders[key].set_amount(value)
                self.fields[key].set_value(value)

    def _show_tracks(self) -> None:
        """Colour each track with what the far end would be: too slow for between an event and its numbers."""
        if self._readings is None:
            return
        angles, labs = self._readings
        far = flop_ends(angles).far
        for handle in HANDLES:
            slider = self.sliders[handle.key]
            if not slider.isEnabled():
                continue
            positions = np.linspace(handle.low, handle.high, _TRACK_SAMPLES).tolist()
            ends = [moved_labs(angles, labs, handle.key, position)[far] for position in positions]
            slider.set_track(*lab_to_codes(np.array(ends)))
