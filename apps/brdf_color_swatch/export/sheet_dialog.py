"""The dialog of a contact sheet: paper, columns and content at the right, the pages as they will be at the left."""

from __future__ import annotations

import json
from dataclasses import dataclass
from datetime import date
from pathlib import Path

from brdf_qt.fields.form import described, fill_column, fill_row, icon_button, row_of
from brdf_qt.fields.labels import ElidedLabel, PlainLabel, plain_tip
from brdf_qt.fields.quiet import QuietComboBox, QuietSpinBox
from brdf_qt.program.names import title_of
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.pictures import Pictures
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QFormLayout,
    QLineEdit,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from brdf_color_swatch.export.sheet_page import SheetPreview, cell_texts
from brdf_color_swatch.grid.rows import Rows, group_title
from brdf_suite.palettes.swatches.look import SwatchLook
from brdf_suite.regular_files import is_file
from brdf_suite.reports.contact_sheet.page_layout import FIELDS, CellText, PageLayout, PageStyle

ENDINGS = (".pdf", ".png")
_KEY = "sheet/choice"
_OWNER = "sheet"
_PICTURE_PX = 384
_MOST_COLUMNS = 12
_PAGES = {"a4": "A4", "a3": "A3", "letter": "US Letter"}
_FORMS = {
    "flop_strip": mark("Flop strip"),
    "chips": mark("Colour chips"),
}
_FIELD_TITLES = {
    "code": mark("Code"),
    "colours": mark("Colours at 15°, 45° and 110°"),
    "figures": mark("Flop index and gloss"),
    "lab": mark("L*a*b* at 15°, 45° and 110°"),
}


@dataclass(frozen=True)
class SheetSource:
    """What may go on a sheet: places of a list in their order, those that are selected, and whether groups show."""

    title: str
    rows: Rows
    shown: tuple[int, ...]
    selected: tuple[int, ...]
    grouped: bool
    environment: str


def _forms() -> dict[str, str]:
    shapes = {key: title_of(key) for key in ("sphere", "panel")}
    return shapes | {key: tr(text) for key, text in _FORMS.items()}


class SheetDialog(QDialog):
    """Asks how a contact sheet looks, and where it is saved.

    Signals: ``save_requested()``, ``print_requested()``, ``folder_requested()``.

    ``pictures`` draws the paints for the preview and for paper.
    """

    save_requested = Signal()
    print_requested = Signal()
    folder_requested = Signal()

    def __init__(self, pictures: Pictures, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Contact Sheet"))
        self.setObjectName("sheet")
        self._pictures = pictures
        self._source: SheetSource | None = None
        self.texts: tuple[CellText, ...] = ()
        self.layout_: PageLayout | None = None
        self._page = 0
        self._looks: dict[tuple[str, str], SwatchLook] = {}
        self.preview = described(SheetPreview(), name="sheet_preview", spoken=tr("Preview of the page"))
        self._build()
        for key, value in _recall().items():
            self._set(key, value)
        pictures.arrived.connect(lambda _keys: self._show_page())
        self.finished.connect(lambda _result: self._release())

    def _build(self) -> None:
        self.title = described(QLineEdit(), name="sheet_title", spoken=tr("Title"))
        self.title.setMaxLength(200)
        self.shown, self.selected = QRadioButton(), QRadioButton()
        described(self.shown, name="sheet_shown")
        described(self.selected, name="sheet_selected")
        self.form = _choices("sheet_form", tr("Picture"), _forms())
        self.page = _choices("sheet_page", tr("Paper"), _PAGES)
        upright = {"portrait": tr("Portrait"), "landscape": tr("Landscape")}
        self.way = _choices("sheet_way", tr("Orientation"), upright)
        self.columns = described(QuietSpinBox(), name="sheet_columns", spoken=tr("Columns"))
        self.columns.setRange(1, _MOST_COLUMNS)
        self.columns.setValue(PageStyle().columns)
        self.fields = {key: QCheckBox(tr(title)) for key, title in _FIELD_TITLES.items()}
        for key, box in self.fields.items():
            described(box, name=f"sheet_{key}")
            box.setChecked(True)
        form = QFormLayout()
        form.setLabelAlignment(Qt.AlignmentFlag.AlignRight)
        self.file = described(
            QLineEdit(),
            name="sheet_file",
            spoken=tr("File"),
            tip=tr("Name of the file: .pdf, or .png for a picture"),
        )
        self.file.setMaxLength(200)
        self._folder = Path.home()
        self.folder = described(ElidedLabel(), name="sheet_folder", spoken=tr("Folder"))
        self.folder.setMinimumWidth(120)
        browse = icon_button("folder-open", tr("Choose another folder"), self.folder_requested.emit)
        place = QWidget()
        fill_row(place, self.folder, browse, spacing=4).setStretch(0, 1)
        form.addRow(tr("Title"), self.title)
        form.addRow(tr("Swatches"), self.shown)
        form.addRow("", self.selected)
        form.addRow(tr("Picture"), self.form)
        form.addRow(tr("Paper"), self.page)
        form.addRow(tr("Orientation"), self.way)
        form.addRow(tr("Columns"), self.columns)
        for number, box in enumerate(self.fields.values()):
            form.addRow(tr("Show") if number == 0 else "", box)
        form.addRow(tr("File"), self.file)
        form.addRow(tr("Folder"), place)
        self.back = icon_button("caret-left", tr("Previous page"), lambda: self._turn(-1), flat=True)
        self.forward = icon_button("caret-right", tr("Next page"), lambda: self._turn(1), flat=True)
        self.count = PlainLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        self.note = described(PlainLabel(wordWrap=True), name="sheet_note")
        self.save = described(QPushButton(tr("Save")), name="sheet_save")
        self.print = described(QPushButton(tr("Print…")), name="sheet_print")
        cancel = described(QPushButton(tr("Cancel")), name="sheet_cancel")
        self.save.setDefault(True)
        left, right = QWidget(), QWidget()
        fill_column(
            left, self.preview, row_of(None, self.back, self.count, self.forward, None), grows=self.preview
        )
        column = QVBoxLayout(right)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(form)
        column.addStretch(1)
        column.addWidget(self.note)
        column.addLayout(row_of(None, self.print, cancel, self.save, spacing=8))
        fill_row(self, left, right, spacing=16).setContentsMargins(12, 12, 12, 12)
        self.save.clicked.connect(self.save_requested)
        self.print.clicked.connect(self.print_requested)
        cancel.clicked.connect(self.reject)
        self.title.textEdited.connect(lambda _text: self._renew())
        self.file.textEdited.connect(lambda _text: self._show_page())
        for button in (self.shown, self.selected, *self.fields.values()):
            button.toggled.connect(lambda _on: self._renew())
        for choice in (self.form, self.page, self.way):
            choice.currentIndexChanged.connect(lambda _place: self._renew())
        self.columns.valueChanged.connect(lambda _value: self._renew())

    def open_for(self, source: SheetSource, form: str, path: Path) -> None:
        """Show the dialog for these swatches in a form, to be saved to ``path``.

        Several that are selected are proposed, and said so.
        """
        self._source = None
        self._set("form", form)
        self.title.setText(source.title)
        self.shown.setText(tr("All {count} shown").format(count=len(source.shown)))
        self.selected.setText(tr("{count} selected").format(count=len(source.selected)))
        self.selected.setEnabled(bool(source.selected))
        (self.selected if len(source.selected) > 1 else self.shown).setChecked(True)
        self._source = source
        self._page = 0
        self.file.setText(path.name)
        self.show_folder(path.parent)
        self._renew()
        self.open()

    def show_folder(self, folder: Path) -> None:
        """Show in which folder the file is saved."""
        self._folder = folder
        self.folder.setText(str(folder))
        self.folder.setToolTip(plain_tip(str(folder)))
        self._show_page()

    @property
    def path(self) -> Path | None:
        """The file that is named; None where no name is given, or one with a folder."""
        name = self.file.text().strip()
        if not name.strip(".") or Path(name).name != name:
            return None
        path = self._folder / name
        return path if path.suffix.lower() in ENDINGS else path.with_name(f"{name}{ENDINGS[0]}")

    @property
    def style_(self) -> PageStyle:
        """The paper and what stands below the pictures."""
        fields = tuple(key for key in FIELDS if self.fields[key].isChecked())
        landscape = self.way.currentData() == "landscape"
        return PageStyle(self.page.currentData(), landscape, self.columns.value(), fields)

    @property
    def places(self) -> tuple[int, ...]:
        """The swatches that go on the sheet, as places of the list, group by group."""
        if self._source is None:
            return ()
        places = self._source.selected if self.selected.isChecked() else self._source.shown
        groups = list(dict.fromkeys(self._heading(place) for place in places))
        return tuple(sorted(places, key=lambda place: groups.index(self._heading(place))))

    def picture(self, number: int) -> QPixmap | None:
        """Return the picture of an item of the sheet; None where it is not there."""
        content = self._source.rows.entries[self.places[number]].content if self._source is not None else None
        if content is None:
            return None
        # The one of the grid stands in for it until it is there.
        return self._pictures.picture(content, self._look) or self._pictures.latest(content)

    def _heading(self, place: int) -> str:
        source = self._source
        return group_title(source.rows.entries[place].group) if source is not None and source.grouped else ""

    @property
    def _look(self) -> SwatchLook:
        source = self._source
        environment = "booth" if source is None else source.environment
        look = SwatchLook(form=self.form.currentData(), environment=environment, size=_PICTURE_PX)
        # One value for one look: the pictures are known by it.
        return self._looks.setdefault((look.form, look.environment), look)

    def _turn(self, by: int) -> None:
        self._page += by
        self._show_page()

    def _renew(self) -> None:
        """Lay the sheet out anew."""
        source = self._source
        if source is None:
            return
        places = self.places
        style = self.style_.for_codes([source.rows.entries[place].code for place in places])
        groups = [self._heading(place) for place in places]
        title, day = self.title.text().strip() or source.title, f"{date.today():%d %B %Y}"
        self.texts = cell_texts(source.rows, places)
        self.layout_ = PageLayout.of(title, self.subtitle, day, groups, style, 1.0)
        contents = [source.rows.entries[place].content for place in places]
        self._pictures.request(_OWNER, contents, self._look)
        _remember(self._choice())
        self._show_page()

    @property
    def subtitle(self) -> str:
        """How the pictures were made, at the foot of every page of the preview and of printed paper."""
        if self.form.currentData() in ("flop_strip", "chips"):
            return tr("L*a*b*: D65, 10°, light at 45°")
        light = tr("Light booth") if self._look.environment == "booth" else self._look.environment
        return tr("{form}, {light}; L*a*b*: D65, 10°, light at 45°").format(
            form=self.form.currentText(), light=light
        )

    def _show_page(self) -> None:
        if self.layout_ is None or self._source is None:
            return
        pages = self.layout_.pages
        self._page = min(max(0, self._page), max(0, pages - 1))
        self.preview.show_page(self.layout_, self._page, self.texts, self.picture)
        self.count.setText(
            tr("Page {page} of {count}").format(page=self._page + 1, count=pages) if pages else ""
        )
        self.back.setEnabled(self._page > 0)
        self.forward.setEnabled(self._page + 1 < pages)
        entries = [self._source.rows.entries[place] for place in self.places]
        waiting = sum(not self._pictures.is_settled(entry.content, self._look) for entry in entries)
        path, words = self.path, []
        replaces = path is not None and is_file(path)
        if path is None:
            words.append(tr("Give the file a name."))
        elif replaces:
            words.append(tr("{name} is there already and will be replaced.").format(name=path.name))
        if waiting:
            words.append(tr("Preparing pictures: {count} to go").format(count=waiting))
        self.note.setText("\n".join(words))
        self.save.setText(tr("Replace") if replaces else tr("Save"))
        self.print.setEnabled(not waiting and bool(pages))
        self.save.setEnabled(bool(pages) and path is not None)

    def _release(self) -> None:
        """Give up the pictures that are still to come."""
        self._pictures.request(_OWNER, [], self._look)

    def _choice(self) -> dict[str, object]:
        boxes = {"form": self.form, "page": self.page, "way": self.way}
        found: dict[str, object] = {key: box.currentData() for key, box in boxes.items()}
        return {**found, "columns": self.columns.value(), "fields": list(self.style_.fields)}

    def _set(self, key: str, value: object) -> None:
        boxes = {"form": self.form, "page": self.page, "way": self.way}
        if key in boxes and (place := boxes[key].findData(value)) >= 0:
            boxes[key].setCurrentIndex(place)
        elif key == "columns" and isinstance(value, int):
            self.columns.setValue(value)
        elif key == "fields" and isinstance(value, list):
            for name, box in self.fields.items():
                box.setChecked(name in value)


def _choices(name: str, spoken: str, texts: dict[str, str]) -> QuietComboBox:
    box = described(QuietComboBox(), name=name, spoken=spoken)
    for key, text in texts.items():
        box.addItem(text, key)
    return box


def _remember(choice: dict[str, object]) -> None:
    settings().setValue(_KEY, json.dumps(choice))


def _recall() -> dict[str, object]:
    """Return the choices of the last sheet; none where there are none, or they are damaged."""
    try:
        found = json.loads(str(settings().value(_KEY, "{}")))
    except (ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}
