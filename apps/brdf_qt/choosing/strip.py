"""The paint strip: thumbnails of paints in one row, with search and origin at the left."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_qt.choosing.filter_fields import GROUPS, filter_fields
from brdf_qt.choosing.sources import FilteredSources, SourceModel
from brdf_qt.choosing.view import ThumbnailView
from brdf_qt.fields.form import described, fill_column, fill_row, icon_button, row_of
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import tr

_FIELDS_WIDTH = 176


class PaintStrip(QWidget):
    """The paints of ``model``. With ``second`` each has a mark that compares the paint on show with it.

    Signals: ``taken(key)``, ``second_taken(key)`` for the paint to compare with: by its mark, or with Shift;
    ``palette_requested()``, the user wants the paints of a palette file.
    """

    taken = Signal(str)
    second_taken = Signal(str)
    palette_requested = Signal()

    def __init__(self, model: SourceModel, *, second: bool = False, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("paint_strip")
        self.sources = FilteredSources(model, self)
        self.view = described(ThumbnailView(self.sources, "strip", wraps=False), spoken=tr("Paints"))
        self._compares = second
        tip = tr("Click to show; drag onto the picture or into a palette")
        if second:
            self.view.mark_tip = tr("Compare with {name} (also Shift click)")
            tip = tr("Click to show, its scales to compare; drag onto the picture or into a palette")
        self.view.setAccessibleDescription(tip)
        self.view.setToolTip(plain_tip(tip))
        self.search, self.origin = filter_fields(self.sources, tuple(GROUPS))
        self.search.left.connect(self.view.go_in)
        self.search.entered.connect(self._take_first)
        self.browse = icon_button(
            "folder-open", tr("List the paints of a palette"), self.palette_requested.emit
        )
        fields = QWidget()
        fields.setFixedWidth(_FIELDS_WIDTH)
        inside = row_of(self.origin, self.browse, grows=self.origin, spacing=4)
        fill_column(fields, None, self.search, inside, None, spacing=4)
        row = fill_row(self, fields, self.view)
        row.setStretch(0, 0)
        row.setStretch(1, 1)
        row.setContentsMargins(8, 4, 8, 4)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.view.taken.connect(self._take)

    def show_group(self, group: str) -> None:
        """List one group of the paints, as if the user had chosen it."""
        self.origin.show_choice(group)
        self.sources.set_group(group)

    def _take(self, key: str, shifted: bool) -> None:
        to_second = self._compares and shifted
        (self.second_taken if to_second else self.taken).emit(key)

    def _take_first(self) -> None:
        if self.sources.rowCount():
            self.sources.model.note_taken(self.sources.key_at(0))
            self._take(self.sources.key_at(0), shifted=False)
