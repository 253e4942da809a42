"""What to export: a window of its own beside the picture, which stays in use, with a preview of what comes out."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.fields.choices import note, set_note
from brdf_qt.fields.form import Form, fill_row
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.fields.quiet import QuietComboBox, QuietSpinBox
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from brdf_suite.documents.view_settings import PARAMETERS, Lens
from brdf_suite.output.picture_file import COLOUR_SPACES
from brdf_viewer.export.job import FORMATS, KIND_TITLES, ExportSettings, Format
from brdf_viewer.export.preview import Preview

_SIZES = {
    "picture": ((1280, 720), (1920, 1080), (3840, 2160), (7680, 4320), (16384, 9216)),
    "turntable": ((1280, 720), (1920, 1080), (3840, 2160)),
    "sheet": ((240, 160), (360, 240), (720, 480)),
}
_SAMPLES = (1, 2, 4, 8, 16)
_LARGEST = 65_536
_SAVED_TITLES = {"screen": mark("Picture on screen"), "traced": mark("Traced picture")}
_SAVED = {
    "screen": Format(mark("PNG, 8 bits"), ".png"),
    "traced": Format(mark("EXR, radiance with variance"), ".exr"),
}
"""What there is already, in its own size: it is written at once."""


class ExportDialog(QDialog):
    """Asks for :class:`ExportSettings`; ``export_requested(settings)`` when the button is pressed.

    ``save_requested(kind)`` where what there is already is to be written, ``screen`` or ``traced``.
    ``cancel_requested()`` where an export is under way and is to end.

    Parameters
    ----------
    screen_size
        Returns the picture's size on screen, device pixels.
    ask_source
        Asks for the palette or folder of a sheet; empty where the user gives none.
    """

    export_requested = Signal(object)
    save_requested = Signal(str)
    cancel_requested = Signal()

    def __init__(
        self,
        screen_size: Callable[[], tuple[int, int]],
        ask_source: Callable[[QWidget], str],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Export"))
        self.setObjectName("export")
        self._screen_size, self.ask_source = screen_size, ask_source
        self.kind = QuietComboBox()
        for key, title in (KIND_TITLES | _SAVED_TITLES).items():
            self.kind.addItem(tr(title), key)
        self.preview = Preview()
        self.preset = QuietComboBox()
        self.width_field, self.height_field = (_number(1, _LARGEST, 1, " px") for _ in range(2))
        self.format = QuietComboBox()
        self.colour_space = QuietComboBox()
        self.samples = QuietComboBox()
        for count in _SAMPLES:
            self.samples.addItem(str(count), count)
        self.samples.setCurrentIndex(_SAMPLES.index(4))
        self.transparent = QCheckBox(tr("Transparent background"))
        self.frames = _number(2, 7200, 120, "")
        self.rate = _number(1, 240, 30, " /s")
        self.aperture = NumberField(tr("Aperture"), *reach_of(PARAMETERS["lens.f_number"], 0.1, 2))
        self.aperture.setPrefix("f/")
        self.aperture.setSpecialValueText(tr("All sharp"))
        self.focus = NumberField(tr("Focus"), "m", 0.0, 1e6, 0.05, 3, 0.0)
        self.focus.setSpecialValueText(tr("Middle of the picture"))
        self.turn = NumberField(tr("Motion blur"), *reach_of(PARAMETERS["lens.turn_deg"], 0.5, 2))
        self.shutter = NumberField(tr("Shutter"), "°", 0.0, 360.0, 15.0, 0, 0.0)
        self.columns = _number(0, 40, 0, "")
        self.columns.setSpecialValueText(tr("Automatic"))
        self.source = QLineEdit(readOnly=True, placeholderText=tr("Palette or folder"))
        self.browse_button = QPushButton(tr("Choose…"))
        self.export_button = QPushButton(tr("Export…"), default=True)
        self.cancel_button = QPushButton(tr("Cancel"), autoDefault=False)
        self._message = note()
        self._rows: dict[QWidget, tuple[str, ...]] = {}
        self._busy = False
        self._lens = self._lens_at_first = self._shown_lens()
        self._build()
        self.kind.currentIndexChanged.connect(self._show_kind)
        self.preset.currentIndexChanged.connect(self._take_preset)
        self.format.currentIndexChanged.connect(self._show_format)
        for field in (self.width_field, self.height_field):
            field.valueChanged.connect(self._show_preset)
        self.browse_button.clicked.connect(self._choose_source)
        self.export_button.clicked.connect(self._export)
        self.cancel_button.clicked.connect(self._cancel)
        for signal in (
            self.kind.currentIndexChanged,
            self.preset.currentIndexChanged,
            self.width_field.valueChanged,
            self.height_field.valueChanged,
            self.transparent.toggled,
            self.aperture.edited,
            self.focus.edited,
            self.turn.edited,
        ):
            signal.connect(self.preview.refresh)
        self._show_kind()

    def open_for(self, kind: str) -> None:
        """Show the dialog for a kind of export; empty: for that of last time."""
        self.kind.setCurrentIndex(self.kind.findData(kind or self.chosen))
        if self.chosen == "picture" and not self.isVisible():
            self._set_size(self._screen_size())
        self.preview.refresh()
        self.show()
        self.raise_()
        self.activateWindow()

    @property
    def chosen(self) -> str:
        """The kind of export that is chosen."""
        return str(self.kind.currentData())

    @property
    def size_chosen(self) -> tuple[int, int]:
        """Width and height of what is exported, pixels."""
        return (self.width_field.value(), self.height_field.value())

    @property
    def lens_chosen(self) -> Lens:
        """The lens of the picture."""
        return self._lens if self._shown_lens() == self._lens_at_first else self._shown_lens()

    def offer_traced(self, missing: str) -> None:
        """Offer the traced picture; ``missing`` says why there is none, empty where there is one."""
        place = self.kind.findData("traced")
        model = self.kind.model()
        assert isinstance(model, QStandardItemModel)
        model.item(place).setEnabled(not missing)
        self.kind.setItemData(place, plain_tip(missing), Qt.ItemDataRole.ToolTipRole)
        if missing and self.chosen == "traced":
            self.kind.setCurrentIndex(0)

    def settings(self) -> ExportSettings:
        return ExportSettings(
            kind=self.kind.currentData(),
            form=self._form(),
            size=self.size_chosen,
            colour_space=self.colour_space.currentData(),
            samples=self.samples.currentData(),
            transparent=self.transparent.isChecked(),
            frames=self.frames.value(),
            frames_per_second=float(self.rate.value()),
            source=self.source.text(),
            columns=self.columns.value(),
            lens=self.lens_chosen,
            shutter_deg=self.shutter.value(),
        )

    def set_lens(self, lens: Lens) -> None:
        """Show the lens of the view."""
        self.aperture.set_value(lens.f_number)
        self.focus.set_value(lens.focus_distance or 0.0)
        self.turn.set_value(lens.turn_deg)
        # Fields round: what is not edited stays as it is.
        self._lens, self._lens_at_first = lens, self._shown_lens()

    def _shown_lens(self) -> Lens:
        return Lens(self.aperture.value(), self.focus.value() or None, self.turn.value())

    def set_busy(self, busy: bool) -> None:
        """One export runs at a time."""
        self._busy = busy
        self.export_button.setEnabled(not busy and self._ready())

    def _export(self) -> None:
        if self.chosen in _SAVED:
            self.save_requested.emit(self.chosen)
        else:
            self.export_requested.emit(self.settings())

    def _cancel(self) -> None:
        """End the export that is under way; without one, close the dialog."""
        if self._busy:
            self.cancel_requested.emit()
        else:
            self.reject()

    def _build(self) -> None:
        size, chosen = QWidget(), QWidget()
        times = PlainLabel("×")
        times.setSizePolicy(times.sizePolicy().Policy.Maximum, times.sizePolicy().Policy.Preferred)
        fill_row(size, self.width_field, times, self.height_field, even=True)
        fill_row(chosen, self.source, self.browse_button)
        form = Form()
        form.add_row(tr("Export"), self.kind)
        self._add(form, tr("Paints"), chosen, "sheet")
        self._add(form, tr("Size"), self.preset, *KIND_TITLES)
        self._add(form, "", size, *KIND_TITLES)
        self._add(form, tr("Format"), self.format)
        tip = tr("Colour space; the ICC profile is embedded in the file")
        self._add(form, tr("Colours"), self.colour_space, *KIND_TITLES, tip=tip)
        tip = tr("Per pixel, limited by the graphics card")
        self._add(form, tr("Samples per pixel"), self.samples, *KIND_TITLES, tip=tip)
        self._add(form, "", self.transparent, "picture", "turntable")
        self._add(form, tr("Frames"), self.frames, "turntable", tip=tr("Frames per turn"))
        self._add(form, tr("Rate"), self.rate, "turntable", tip=tr("Frames per second of a video"))
        blurred = "picture", "turntable"
        self._add(form, tr("Aperture"), self.aperture, *blurred, tip=tr(PARAMETERS["lens.f_number"].meaning))
        self._add(form, tr("Focus"), self.focus, *blurred, tip=tr(PARAMETERS["lens.focus_distance"].meaning))
        self._add(form, tr("Motion blur"), self.turn, "picture", tip=tr(PARAMETERS["lens.turn_deg"].meaning))
        tip = tr("Motion blur: how long the shutter is open, 360° for the whole time of a frame")
        self._add(form, tr("Shutter"), self.shutter, "turntable", tip=tip)
        self._add(form, tr("Columns"), self.columns, "sheet")
        form.add_wide(self._message)
        box = QVBoxLayout(self)
        box.setSpacing(12)
        box.addWidget(self.preview, 0, Qt.AlignmentFlag.AlignHCenter)
        box.addWidget(form)
        box.addStretch()
        buttons = QHBoxLayout()
        buttons.addStretch()
        buttons.addWidget(self.cancel_button)
        buttons.addWidget(self.export_button)
        box.addLayout(buttons)

    def _add(self, form: Form, label: str, field: QWidget, *kinds: str, tip: str = "") -> None:
        """Add a row that is shown for these kinds of export, for all where none is given."""
        for widget in (form.add_row(label, field, tip), field):
            self._rows[widget] = kinds or (*KIND_TITLES, *_SAVED)

    def _show_kind(self) -> None:
        kind = self.kind.currentData()
        for widget, kinds in self._rows.items():
            widget.setVisible(kind in kinds)
        with QSignalBlocker(self.preset):
            self.preset.clear()
            if kind in ("picture", "turntable"):
                self.preset.addItem(tr("As on screen"), "screen")
            for size in _SIZES.get(kind, ()):
                self.preset.addItem("{} × {}".format(*size), size)
            self.preset.addItem(tr("Other"), None)
        self._set_size(_SIZES[kind][1] if kind in ("turntable", "sheet") else self._screen_size())
        with QSignalBlocker(self.format):
            self.format.clear()
            for form in (_SAVED[kind],) if kind in _SAVED else FORMATS[kind]:
                self.format.addItem(tr(form.title), form)
        self._show_format()

    def _form(self) -> Format:
        kind = self.chosen
        return _SAVED[kind] if kind in _SAVED else FORMATS[kind][self.format.currentIndex()]

    def _show_format(self) -> None:
        form = self._form()
        self.colour_space.clear()
        for key in form.colour_spaces:
            self.colour_space.addItem(COLOUR_SPACES[key], key)
        self.colour_space.setEnabled(len(form.colour_spaces) > 1)
        self.transparent.setEnabled(form.transparent)
        if not form.transparent:
            self.transparent.setChecked(False)
        notes = {
            ".exr": tr("Radiance before exposure and tone curve, in the primaries stated in the file"),
            ".mp4": tr("sRGB; an even width and height"),
            ".webm": tr("sRGB; an even width and height"),
        }
        set_note(self._message, notes.get(form.ending, ""))
        self.export_button.setEnabled(self._ready() and not self._busy)

    def _ready(self) -> bool:
        return self.kind.currentData() != "sheet" or bool(self.source.text())

    def _take_preset(self) -> None:
        size = self.preset.currentData()
        if size is not None:
            self._set_size(self._screen_size() if size == "screen" else tuple(size))

    def _set_size(self, size: tuple[int, int]) -> None:
        for field, edge in zip((self.width_field, self.height_field), size, strict=True):
            with QSignalBlocker(field):
                field.setValue(edge)
        self._show_preset()

    def _show_preset(self) -> None:
        size = (self.width_field.value(), self.height_field.value())
        known = [self.preset.itemData(i) for i in range(self.preset.count())]
        sizes = [item if item in (None, "screen") else tuple(item) for item in known]
        shown = size if size in sizes else "screen" if size == self._screen_size() else None
        with QSignalBlocker(self.preset):
            self.preset.setCurrentIndex(sizes.index(shown if shown in sizes else None))

    def _choose_source(self) -> None:
        chosen = self.ask_source(self)
        if chosen:
            self.source.setText(chosen)
            self._show_format()


def _number(low: int, high: int, value: int, unit: str) -> QSpinBox:
    field = QuietSpinBox(minimum=low, maximum=high, suffix=unit)
    field.setValue(value)
    return field
