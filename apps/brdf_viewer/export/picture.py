"""The picture as it is now, to a PNG file that says what it shows."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from brdf_qt.program.translation import tr
from PySide6.QtGui import QImage

from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.images.environments import write_png
from brdf_suite.output.picture_file import picture_metadata
from brdf_viewer.documents.file_kinds import AskPicture, file_name, with_ending
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

_KEY = "picture"
_MESSAGE_MS = 6000


class PictureExport(ViewerFeature):
    """File ▸ Save Picture: every pixel of the picture, with paint and settings as text in the file.

    ``grab`` returns the picture in sRGB.
    """

    def __init__(
        self, state: ViewerState, window: ViewerWindow, ask: AskPicture, grab: Callable[[], QImage]
    ) -> None:
        super().__init__(state, window)
        self._ask, self._grab = ask, grab
        window.commands.save_picture.triggered.connect(self.save)

    def save(self) -> None:
        """Ask for a file and write the picture to it; errors are reported in the window."""
        # As it was when the user asked: the paint may change while the dialog is open.
        fit, image, view = self._state.fit, self._grab(), self._state.exposed_view
        made_by = {"Renderer": self._window.overlay.mark} if self._state.traced is not None else {}
        if fit is None or not self._state.is_complete or image.isNull():
            todo = tr("Wait until paint, surface and environment are loaded, then save.")
            self._refuse(_KEY, tr("There is no picture yet."), todo)
            return
        chosen = self._ask(self._window, file_name(fit.name, "picture"))
        if not chosen:
            return
        path = with_ending(Path(chosen), ".png")
        try:
            _write(path, image, picture_metadata(fit, view) | made_by)
        except SuiteError as error:
            self._report(error, _KEY, tr("Choose another name or folder."))
            return
        self._window.messages.dismiss(_KEY)
        self._window.status.showMessage(tr("Saved: {path}").format(path=path.name), _MESSAGE_MS)


def _write(path: Path, image: QImage, metadata: dict[str, str]) -> None:
    """Write an RGB32 image as it is."""
    if path.suffix.lower() != ".png":
        text = tr("pictures are written as PNG; give a name that ends in {ending}")
        raise FileError(path, text.format(ending=".png"))
    flat = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    write_png(path, flat[:, : 4 * image.width()].reshape(image.height(), -1, 4)[..., 2::-1], metadata)
