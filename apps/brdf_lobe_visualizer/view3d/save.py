"""The section Export of the inspector: the view as PNG or SVG, the surface as OBJ or PLY."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from brdf_qt.fields.form import Form, described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.number import NumberField
from brdf_qt.program.icons import icon
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import message_of
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QFileDialog, QGridLayout, QPushButton, QWidget

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.errors import GraphicsError, SuiteError

if TYPE_CHECKING:
    from brdf_lobe_visualizer.view3d.view import LobeView

AskPath = Callable[[QWidget, str, Path, str], Path | None]
"""``(parent, title, suggested, filters) -> path``: asks where to write; tests answer for the user."""

_FOLDER_KEY = "folder/export"
PICTURE_PX = (1920, 1440)
MOST_PX = 16384
SIZE_MM = 100.0
KINDS: dict[str, tuple[str, str]] = {
    "png": (mark("Save Picture as PNG"), mark("PNG picture (*.png)")),
    "svg": (mark("Save Picture as SVG"), mark("SVG picture (*.svg)")),
    "obj": (mark("Save Surface as OBJ"), mark("Wavefront OBJ (*.obj)")),
    "ply": (mark("Save Surface as PLY"), mark("PLY with colours (*.ply)")),
}


class SaveSection(QWidget):
    """Sizes and buttons."""

    def __init__(self, save: SaveSurface, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("save_section")
        form = Form()
        self.width_ = NumberField(tr("Width of the picture"), "px", 64, MOST_PX, 16, 0, PICTURE_PX[0])
        self.height_ = NumberField(tr("Height of the picture"), "px", 64, MOST_PX, 16, 0, PICTURE_PX[1])
        self.size_ = NumberField(tr("Length of radius 1"), "mm", 0.001, 1e6, 10.0, 3, SIZE_MM)
        tip = tr("Size of PNG and SVG pictures. PNG uses 16 samples per pixel.")
        form.add_row(tr("Width"), self.width_, tip)
        form.add_row(tr("Height"), self.height_)
        tip = tr("Length of radius 1 in OBJ and PLY. The file states the value it stands for.")
        form.add_row(tr("Scale"), self.size_, tip)
        grid = QGridLayout()
        grid.setSpacing(8)
        self.buttons: dict[str, QPushButton] = {}
        for number, kind in enumerate(KINDS):
            button, title = QPushButton(icon("floppy-disk"), kind.upper()), tr(KINDS[kind][0])
            self.buttons[kind] = described(button, spoken=title, tip=title)
            button.clicked.connect(lambda _on=False, kind=kind: save.ask(kind))
            grid.addWidget(button, number // 2, number % 2)
        self.message = PlainLabel(wordWrap=True)
        self.message.hide()
        self.reset = QPushButton(tr("Reset Sizes"))
        self.reset.clicked.connect(self._reset)
        fill_column(self, form, grid, self.message, self.reset)

    def report(self, text: str) -> None:
        self.message.setText(text)
        self.message.show()

    def _reset(self) -> None:
        for field in (self.width_, self.height_, self.size_):
            field.reset()


class SaveSurface(QObject):
    """Writes what the view shows.

    ``draw_now`` draws what is pending; ``current_view`` returns the view, None until it is built.
    """

    def __init__(
        self,
        draw_now: Callable[[], object],
        current_view: Callable[[], LobeView | None],
        session: LobeSession,
        window: LobeWindow,
        ask_path: AskPath | None = None,
    ) -> None:
        super().__init__(window)
        self._draw_now, self._current_view = draw_now, current_view
        self._session, self._window = session, window
        self.ask_path = ask_path or _ask_path
        self.section = SaveSection(self)
        window.add_section("export", tr("Export"), self.section, is_open=False)
        for kind, (title, _) in KINDS.items():
            window.add_command("file", title, None, lambda kind=kind: self.ask(kind))

    def ask(self, kind: str) -> None:
        title, filters = KINDS[kind]
        front = self._session.front
        name = "".join(c if c.isalnum() or c in " -_" else "_" for c in (front.title if front else "lobes"))
        folder = Path(str(settings().value(_FOLDER_KEY, str(Path.home()))))
        path = self.ask_path(self._window, tr(title), folder / f"{name}.{kind}", tr(filters))
        if path is None:
            return
        if path.suffix.lower() != f".{kind}":
            path = path.with_name(f"{path.name}.{kind}")
        settings().setValue(_FOLDER_KEY, str(path.parent))
        try:
            self.write(path)
        except SuiteError as error:
            self._window.show_message(message_of(error, "export"))
            return
        self._window.dismiss_message("export")
        self.section.report(tr("Saved: {path}").format(path=path))

    def write(self, path: Path) -> None:
        """Write the view or the front surface, by the ending of ``path``.

        Raises :class:`GraphicsError` where there is no view, and what writing the file raises.
        """
        kind = path.suffix.lower().removeprefix(".")
        self._draw_now()
        if kind in ("png", "svg"):
            size = round(self.section.width_.value()), round(self.section.height_.value())
            self._view().write_picture(path, *size, " · ".join(self._about()))
        else:
            about = (*self._about(), "lengths in millimetres")
            self._view().write_surface(path, about, self.section.size_.value())

    def _view(self) -> LobeView:
        view = self._current_view()
        if view is None or not view.isValid():
            raise GraphicsError(tr("OpenGL is not available, so the lobes cannot be drawn."))
        return view

    def _about(self) -> list[str]:
        view = self._view()
        theta, phi = self._session.incidence
        title = view.scene.panels[0].title if view.scene.panels else ""
        return [title, view.scene.quantity, f"incidence {theta:g}, azimuth {phi:g} degrees"]


def _ask_path(parent: QWidget, title: str, suggested: Path, filters: str) -> Path | None:
    chosen, _ = QFileDialog.getSaveFileName(parent, title, str(suggested), filters)
    return Path(chosen) if chosen else None
