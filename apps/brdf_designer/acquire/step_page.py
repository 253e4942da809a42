"""What every step of the assistant is built of: the picture or plot at the left, what belongs to it at the right."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.form import Form, fill_column, row_of
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from brdf_qt.program.translation import tr
from brdf_qt.window.section import Inspector, Section
from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QWidget

from brdf_designer.window.widgets import wrapped

SIDE_WIDTH = 300


class AcquirePage(QWidget):
    """A step: ``centre``, in the ``middle``, takes the room, ``side`` has sections.

    ``key`` names it, ``says`` describes it.
    """

    def __init__(self, key: str, says: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.key = key
        self.setObjectName(f"acquire_{key}")
        self.middle = QWidget()
        self.centre = fill_column(self.middle, wrapped(says), margins=(8, 0, 8, 8))
        self.side = SideInspector()
        self.setLayout(row_of(self.middle, self.side, grows=self.middle, spacing=0, margins=(0, 8, 0, 0)))

    def add_part(self, name: str, title: str, *widgets: QWidget) -> Section:
        """Add a section of that title at the end of the side."""
        section = Section(title, f"acquire_{self.key}_{name}")
        for widget in widgets:
            section.add(widget)
        self.side.add_section(section)
        return section


class PositionPage(AcquirePage):
    """A page with the photographs of one position. Intents: ``position_chosen(index)``."""

    position_chosen = Signal(int)

    def __init__(self, key: str, says: str, least_ev: float) -> None:
        super().__init__(key, says)
        self.position = QuietSlider(Qt.Orientation.Horizontal)
        self.position.valueChanged.connect(self._report_position)
        self.position.valueChanged.connect(self.position_chosen)
        self.where = wrapped()
        self.brightness = NumberField(tr("Brightness"), "EV", least_ev, 12.0, 0.5, 1, 0.0)
        self._angles: tuple[float, ...] = ()

    def position_form(self, tip: str) -> Form:
        """Return the form of position and brightness."""
        form = Form()
        form.add_row(tr("Position"), self.position, tip)
        form.add_wide(self.where)
        form.add_row(
            tr("Brightness"), self.brightness, tr("Brightness of the displayed picture only, in stops")
        )
        return form

    def show_positions(self, angles_deg: tuple[float, ...], index: int) -> None:
        """Offer these positions, and show which one is chosen, without an intent."""
        self._angles = angles_deg
        with QSignalBlocker(self.position):
            self.position.setRange(0, max(0, len(angles_deg) - 1))
            self.position.setValue(index)
        self._report_position(index)

    def position_text(self, index: int) -> str:
        """Return what is written of a position that there is."""
        return tr("Lamp at {angle:g}°").format(angle=self._angles[index])

    def _report_position(self, index: int) -> None:
        if index < len(self._angles):
            self.where.setText(self.position_text(index))


class SideInspector(Inspector):
    """An inspector of one width in every step; wider only where its fields want that."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return QSize(max(SIDE_WIDTH, self.minimumSizeHint().width()), super().sizeHint().height())


class Facts(QWidget):
    """Names and values, one pair a row; the values can be selected and copied."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(4)
        self._grid.setColumnStretch(1, 1)
        self._rows: list[tuple[QLabel, QLabel]] = []

    def show_rows(self, rows: Sequence[tuple[str, str, str]]) -> None:
        """Show (name, value, explanation) of each."""
        while len(self._rows) < len(rows):
            name, value = wrapped(""), wrapped("")
            name.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop)
            name.setForegroundRole(self.foregroundRole().PlaceholderText)
            name.setMinimumWidth(88)
            name.setMaximumWidth(120)
            value.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
            self._grid.addWidget(name, len(self._rows), 0)
            self._grid.addWidget(value, len(self._rows), 1)
            self._rows.append((name, value))
        for number, labels in enumerate(self._rows):
            texts = rows[number] if number < len(rows) else ("", "", "")
            for label, text in zip(labels, texts, strict=False):
                label.setText(text)
                label.setToolTip(plain_tip(texts[2]))
                label.setVisible(number < len(rows))
        self.setAccessibleDescription("; ".join(f"{name}: {value}" for name, value, _ in rows))

    @property
    def texts(self) -> dict[str, str]:
        """What is shown, by name."""
        return {name.text(): value.text() for name, value in self._rows if not name.isHidden()}
