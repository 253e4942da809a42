"""An export in a process of its own, with the files that it left removed where it was ended by force."""

from __future__ import annotations

import contextlib
import shutil

from brdf_qt.work.command_process import CommandProcess
from PySide6.QtCore import QObject

from brdf_viewer.export.job import ExportJob


class ExportProcess(CommandProcess):
    """Runs one export; its signals are those of the command, ``done`` with the lines that it printed."""

    def __init__(self, job: ExportJob, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.job = job

    def start(self) -> None:
        """Begin."""
        self.run_command(*self.job.arguments())

    def clean_up(self, *, forced: bool) -> None:
        """Remove the scene's files; after an end by force also the unfinished export."""
        if forced:
            for path in self.job.leftovers():
                with contextlib.suppress(OSError):  # another process may still hold it
                    shutil.rmtree(path) if path.is_dir() else path.unlink()
        self.job.tidy()
