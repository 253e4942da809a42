"""Models in the window: sliders for the numbers of the selected one, and the text of one that is written here.

The text and the sliders are computed off the window's thread, one change at a time and then the newest: a drag shows
what it passes. The model that was shown stays until the new one is there, also where a text has an error.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from brdf_qt.documents.stamp import FileStamp, is_changed, stamp_of
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.dialogs import Answer, Overwrite, QtDialogs
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QTextDocument

from brdf_lobe_visualizer.model_text.panel import TextPanel
from brdf_lobe_visualizer.model_text.section import ModelNumbers
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.sources_control import Sources
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import SuiteError

_SOON_MS = 300
"""After the last key: a text is not compiled between two letters of a word."""
_JOB = "model"
_FOLDER_KEY = "folder/model"
_ENDINGS = {"glsl": ".brdf", "python": ".py"}


@dataclass(eq=False)
class _Text:
    """The text of one subject: its document, its file, the subject as it was shown last, and what is wrong in it.

    ``stamp`` is what the file held as it was read or written here.
    """

    document: QTextDocument
    path: Path | None
    stamp: FileStamp | None
    subject: PlottedMaterial
    error: Exception | None = None


class Models(Feature, QObject):
    """The section Model and the panel Model Text; ``dialogs`` ask for files, and are replaced by tests."""

    def __init__(self, session: LobeSession, window: LobeWindow, sources: Sources) -> None:
        super().__init__(window)
        self._session, self._window, self._sources = session, window, sources
        self.tasks = TaskRunner(self, threads=1)
        self.dialogs = QtDialogs(window)
        self._work: Any = None  # the module of that name, once it is imported
        self._texts: dict[str, _Text] = {}
        self._values: dict[str, dict[str, float]] = {}
        self._edited_texts: set[str] = set()
        self._count = 0
        self._soon = make_timer(self, self._go_on, _SOON_MS)
        self.section = ModelNumbers()
        self.inspector_section = window.add_section("model", tr("Model"), self.section)
        """Hidden where the selected reflectance has no numbers."""
        self.inspector_section.hide()
        self.section.edited.connect(self._slide)
        self.panel = TextPanel()
        self.dock = window.add_dock(
            "model_text", mark("Model Text"), self.panel, Qt.DockWidgetArea.LeftDockWidgetArea
        )
        self.panel.edited.connect(self._edit)
        self.panel.new_requested.connect(self.start_text)
        self.panel.open_requested.connect(self.ask_open)
        self.panel.save_requested.connect(self._save_front)
        self.panel.values_requested.connect(self._write_values)
        session.front_changed.connect(self._show)
        session.subjects_changed.connect(self._show)
        window.close_requested.connect(self._may_close)
        tip = mark("Write a reflectance model as GLSL or as formulas, with sliders for its parameters")
        window.add_command("reflectance", mark("Model &Text"), None, self.show_panel, "model_text", tip=tip)
        # What computes models is much to import, and the window does not need it to be painted.
        window.first_painted.connect(lambda: QTimer.singleShot(0, self, self._begin))

    @property
    def is_idle(self) -> bool:
        return self._work is not None and not self.tasks.busy and not self._soon.isActive()

    def close(self) -> None:
        """End what is computed."""
        self._soon.stop()
        self.tasks.stop()

    def show_panel(self) -> None:
        """Show the panel in front of those beside it."""
        self.dock.show()
        self.dock.raise_()
        self.panel.editor.setFocus()

    def start_text(self, language: str) -> None:
        """Add a model with a text to begin from, and edit it."""
        self._begin()
        self._count += 1
        name = tr("Model {number}").format(number=self._count)
        starts = self._work.STARTS

        def done(subject: PlottedMaterial) -> None:
            self._window.dismiss_message("new model")
            self._session.set_front(self._sources.add(subject))
            self.show_panel()

        def failed(error: Exception) -> None:
            self._window.show_message(message_of(error, "new model"))

        work = self._work
        self.tasks.submit(
            "new", lambda text, _progress: work.open_text(name, text), starts[language], done, failed
        )

    def ask_open(self) -> None:
        """Ask for a model's file and open it."""
        filters = tr("Models") + " (*.brdf *.py);;" + tr("All files (*)")
        path = self.dialogs.open_path(self._folder(), filters)
        if path is not None:
            settings().setValue(_FOLDER_KEY, str(path.parent))
            self._sources.open(path)
            self.show_panel()

    def save(self, key: str, *, another: bool = False) -> bool:
        """Write the text of a subject, where it has no file or with ``another`` to one that is asked for.

        A file that another program has changed is written over only where the user says so.
        """
        kept, subject = self._texts[key], self._session.subject(key) or self._texts[key].subject
        path = kept.path
        if path is not None and not another and is_changed(path, kept.stamp):
            answer = self.dialogs.changed_file(path)
            if answer is Overwrite.CANCEL:
                return False
            another = answer is Overwrite.SAVE_AS
        if path is None or another:
            language = subject.reflectance.model.language  # type: ignore[attr-defined]  # that of a text
            ending = _ENDINGS[language]
            stem = path.stem if path is not None else subject.title
            suggested = (path.parent if path is not None else self._folder()) / f"{stem}{ending}"
            path = self.dialogs.save_path(suggested, tr("Models") + f" (*{ending})")
            if path is None:
                return False
            settings().setValue(_FOLDER_KEY, str(path.parent))
        try:
            write_atomically(path, kept.document.toPlainText().encode())
        except SuiteError as error:
            self._window.show_message(message_of(error, "save model"))
            return False
        self._window.dismiss_message("save model")
        renamed = kept.path != path
        kept.path, kept.stamp = path, stamp_of(path)
        kept.document.setModified(False)
        if renamed and self._session.subject(key) is not None:
            material = replace(subject.material, name=path.name, origin=str(path))
            self._session.change(key, title=path.name, material=material)
            self._sources.note_saved(path, key)
        self._show()
        return True

    def _begin(self) -> None:
        if self._work is None:
            from brdf_lobe_visualizer.model_text import work

            self._work = work
            self._show()

    def _folder(self) -> Path:
        return Path(str(settings().value(_FOLDER_KEY, "")) or Path.home())

    def _show(self) -> None:
        if self._work is None:
            return
        self._offer_removed()
        front = self._session.front
        numbers = self._work.numbers_of(None if front is None else front.material)
        self.inspector_section.setVisible(bool(numbers))
        if front is not None and numbers:
            asked = self._values.get(front.key, {})
            shown = {
                key: replace(one, value=asked[key]) if key in asked else one for key, one in numbers.items()
            }
            self.section.show_numbers(shown)
        text = None if front is None else self._work.text_of(front.reflectance)
        if front is None or text is None:
            self.panel.show_document(
                None, "", tr("The selected reflectance has no text. Start a model by New, or open a file.")
            )
            return
        kept = self._texts.get(front.key)
        if kept is None:
            path = Path(front.material.origin) if front.material.origin else None
            document = self.panel.editor.make_document(text)
            document.setModified(False)
            kept = self._texts[front.key] = _Text(document, path, front.stamp, front)
        kept.subject = front
        changes = self.panel.editor.document() is not kept.document
        name = kept.path.name if kept.path is not None else front.title
        star = " •" if kept.document.isModified() else ""
        self.panel.show_document(kept.document, name + star)
        if changes:
            self._report(front.key, kept.error)

    def _edit(self) -> None:
        front = self._session.front
        if front is not None and front.key in self._texts:
            self._edited_texts.add(front.key)
            self._show()
            self._soon.start()

    def _slide(self, key: str, value: float) -> None:
        front = self._session.front
        if front is not None:
            self._values.setdefault(front.key, {})[key] = value
            self._go_on()

    def _go_on(self) -> None:
        """Compute the newest text or values that are not shown yet; the next follow when they are."""
        if self.tasks.busy or self._work is None:
            return
        waiting = [*self._edited_texts, *self._values]
        key = next((one for one in waiting if self._session.subject(one) is not None), None)
        if key is None:
            self._edited_texts.clear()
            self._values.clear()
            return
        subject = self._session.subject(key)
        assert subject is not None  # as was asked
        text = self._texts[key].document.toPlainText() if key in self._edited_texts else None
        self._edited_texts.discard(key)
        values = self._values.pop(key, {})
        work = self._work
        request = work.Change(subject.material, text, values)

        def done(changed: PlottedMaterial) -> None:
            self._report(key, None)
            self._session.change(
                key, material=changed.material, isotropic=changed.isotropic, notes=changed.notes
            )
            self._go_on()

        def failed(error: Exception) -> None:
            self._report(key, error)
            self._show()
            self._go_on()

        self.tasks.submit(_JOB, lambda asked, _progress: work.change(asked), request, done, failed)

    def _report(self, key: str, error: Exception | None) -> None:
        if key in self._texts:
            self._texts[key].error = error
        front = self._session.front
        if front is None or front.key != key:
            return
        if error is None:
            self._window.dismiss_message(_JOB)
            self.panel.show_state(tr("No errors."))
            return
        if key not in self._texts:
            self._window.show_message(message_of(error, _JOB, todo=tr("The previous picture stays.")))
            return
        line = self._work.line_of(error)
        self.panel.show_state(f"{error} " + tr("The previous picture stays."), line=line, bad=True)

    def _save_front(self, another: bool) -> None:
        front = self._session.front
        if front is not None and front.key in self._texts:
            self.save(front.key, another=another)

    def _write_values(self) -> None:
        front = self._session.front
        if front is None or front.key not in self._texts:
            return
        document = self._texts[front.key].document
        text = self._work.text_with_values(front.reflectance)
        if text and text != document.toPlainText():
            cursor = self.panel.editor.textCursor()
            place = cursor.position()
            cursor.beginEditBlock()
            cursor.select(cursor.SelectionType.Document)
            cursor.insertText(text)
            cursor.endEditBlock()
            cursor.setPosition(min(place, len(text)))
            self.panel.editor.setTextCursor(cursor)

    def _offer_removed(self) -> None:
        """Forget the texts of subjects that have gone; one with unsaved changes can be restored."""
        for key in [key for key in self._texts if self._session.subject(key) is None]:
            gone = self._texts.pop(key)
            self._edited_texts.discard(key)
            self._values.pop(key, None)
            if not gone.document.isModified():
                continue
            what = tr("“{name}” was removed with unsaved changes.").format(name=gone.subject.title)
            restore = (tr("Restore"), self._restorer(gone))
            self._window.show_message(Message(f"removed {key}", what, severity="warning", actions=(restore,)))

    def _restorer(self, gone: _Text) -> Callable[[], None]:
        def restore() -> None:
            key = gone.subject.key
            self._texts[key] = gone
            self._session.add(gone.subject)
            self._session.set_front(key)

        return restore

    def _may_close(self, question: QCloseEvent) -> None:
        for key, kept in list(self._texts.items()):
            # A model that was started here and never changed is no work.
            if not question.isAccepted() or not kept.document.isModified():
                continue
            answer = self.dialogs.unsaved(kept.path.name if kept.path is not None else kept.subject.title)
            if answer is Answer.CANCEL or (answer is Answer.SAVE and not self.save(key)):
                question.ignore()
