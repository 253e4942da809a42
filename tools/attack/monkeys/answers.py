"""What a monkey answers to dialogs, types, drops and copies, and what stands for all outside the program."""

from __future__ import annotations

import random
from pathlib import Path

from brdf_qt.choosing.drag import MIME, PAINT_MIME, SOURCE_MIME
from PySide6.QtCore import QMimeData, QProcess, QUrl
from PySide6.QtGui import QColor, QDesktopServices, QImage
from PySide6.QtPrintSupport import QPrintDialog
from PySide6.QtWidgets import QFileDialog

TEXTS = (
    "nan", "1e999", "-1e-999", "9" * 400, "\u0661\u0662", "1,5", "--", "\u202egnp\u200b", "<img src=x><b>y</b>", "=1+1",
    "%s%n{0}", "../../x", "e\u0301\u0301\u0301", "\U0001f3a8", "\t\n", "a\0b", "'\"\\", "blue#1", "x" * 3000,
)  # fmt: skip
"""What is typed: numbers and names that fields and files may take for something else."""


class Answers:
    """The answers to file dialogs, and what stands for all that reaches outside the program."""

    def __init__(self, rng: random.Random, folder: Path) -> None:
        self._rng, self._folder = rng, folder
        self.files = sorted(path for path in (folder / "files").iterdir())

    def install(self) -> None:
        """Answer the dialogs of this process from now on."""
        rejected, accepted = QFileDialog.DialogCode.Rejected, QFileDialog.DialogCode.Accepted

        def ask(dialog: QFileDialog) -> int:
            saves = dialog.acceptMode() == QFileDialog.AcceptMode.AcceptSave
            chosen = self._save(dialog.defaultSuffix()) if saves else self.any_file()
            dialog.setProperty("chosen", chosen)
            return int((accepted if chosen else rejected).value)

        def opened(*_: object) -> tuple[str, str]:
            return self.any_file(), ""

        def several(*_: object) -> tuple[list[str], str]:
            return [name for name in (self.any_file(), self.any_file()) if name], ""

        def saved(*_: object) -> tuple[str, str]:
            return self._save(self._rng.choice(("png", "csv", "exr", ""))), ""

        QFileDialog.exec = ask  # type: ignore[method-assign,assignment]
        QFileDialog.selectedFiles = lambda dialog: [dialog.property("chosen")]  # type: ignore[method-assign]
        QFileDialog.getOpenFileName = staticmethod(opened)  # type: ignore[method-assign,assignment]
        QFileDialog.getOpenFileNames = staticmethod(several)  # type: ignore[method-assign,assignment]
        QFileDialog.getSaveFileName = staticmethod(saved)  # type: ignore[method-assign,assignment]
        QFileDialog.getExistingDirectory = staticmethod(  # type: ignore[method-assign,assignment]
            lambda *_: self._rng.choice(("", str(self._folder / "files"), "/nonexistent"))
        )
        QPrintDialog.exec = lambda _dialog: int(rejected.value)  # type: ignore[method-assign]
        QDesktopServices.openUrl = staticmethod(lambda _url: True)  # type: ignore[method-assign]
        QProcess.startDetached = staticmethod(lambda *_: (True, 0))  # type: ignore[method-assign,assignment]

    def any_file(self) -> str:
        """Return a file to be opened, or nothing where the dialog is cancelled."""
        return str(self._rng.choice(self.files)) if self._rng.random() < 0.7 else ""

    def _save(self, ending: str) -> str:
        if self._rng.random() < 0.3:
            return ""
        stem = self._rng.choice(
            ("saved 1", "saved 2", "a\nb", "-n", "x" * 240, "none/x", "files", "caf\u00e9 \u202e")
        )
        return str(self._folder / "saved" / (f"{stem}.{ending}" if ending else stem))

    def carried(self) -> tuple[str, QMimeData]:
        """Return what is dropped or put on the clipboard, and what it is in words."""
        data = QMimeData()
        what = self._rng.choice(
            ("file", "file", "files", "text", "huge text", "html", "image", "binary", "colour", "urls")
        )
        if what in ("file", "files"):
            names = [self._rng.choice(self.files) for _ in range(1 if what == "file" else 5)]
            data.setUrls([QUrl.fromLocalFile(str(name)) for name in names])
            what = f"{what} {names[0].name[:30]}"
        elif what == "text":
            data.setText(self._rng.choice(TEXTS))
        elif what == "huge text":
            data.setText(self._rng.choice(("x", "#12\t", "\u202e", "50\n", "\n")) * 500_000)
        elif what == "html":
            data.setHtml(
                '<img src="file:///dev/zero"><a href="file:///etc/passwd">x</a><table width=99999999>'
            )
        elif what == "image":
            image = QImage(self._rng.choice((1, 3000)), 2000, QImage.Format.Format_RGB32)
            image.fill(7)
            data.setImageData(image)
        elif what == "binary":
            content = self._rng.choice(
                (b"", b"{", b"null", b"[[[[" * 50_000, self._rng.randbytes(3000), b'{"palette": 1}')
            )
            for form in (MIME, SOURCE_MIME, PAINT_MIME, "text/plain", "text/uri-list", "application/x-color"):
                data.setData(form, content)
        elif what == "colour":
            data.setColorData(QColor.fromRgbF(1.0, 0.5, 0.0))
        else:
            texts = (
                "http://x/y.brdfpaint",
                "file://host/share/x",
                "file:",
                "x:" * 9,
                "data:text/plain,x",
                "file:///dev/zero",
            )
            data.setUrls([QUrl(text) for text in texts])
        return what, data
