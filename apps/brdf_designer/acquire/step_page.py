"""What every step of the assistant is built of: the picture or plot at the left, what belongs to it at the right."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.labels import plain_tip
from brdf_qt.window.section import Inspector, Section
from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QSizePolicy, QWidget

from brdf_designer.window.widgets import fill_column, wrapped

SIDE_WIDTH = 300


class AcquirePage(QWidget):
    """A step: ``centre`` takes the room, ``side`` has sections. ``key`` names it, ``says`` describes it."""

    def __init__(self, key: str, says: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.key = key
        self.setObjectName(f"acquire_{key}")
        left = QWidget()
        self.centre = fill_column(left, wrapped(says), margins=(8, 0, 8, 8))
        self.side = SideInspector()
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 8, 0, 0)
        row.setSpacing(0)
        row.addWidget(left, 1)
        row.addWidget(self.side)

    def add_part(self, name: str, title: str, *widgets: QWidget) -> Section:
        """Add a section of that title at the end of the side."""
        section = Section(title, f"acquire_{self.key}_{name}")
        for widget in widgets:
            section.add(widget)
        self.side.add_section(section)
        return section


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
