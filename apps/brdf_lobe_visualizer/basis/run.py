"""A search of the basis in a process of its own; what it finds is kept in ``FILE.part``, from which it resumes."""

from __future__ import annotations

from pathlib import Path

from brdf_qt.work.command_process import CommandProcess
from PySide6.QtCore import QObject

MOST_LOBES = 11


class BasisRun(CommandProcess):
    """One search over the paints of ``folder``, written to ``output``."""

    def __init__(self, folder: Path, output: Path, lobes: int, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.folder, self.output, self.lobes = folder, output, lobes

    @property
    def state(self) -> Path:
        """The file that holds what is found so far."""
        return self.output.with_name(self.output.name + ".part")

    def start(self) -> None:
        """Begin, or resume from what is kept."""
        from brdf_suite.fitting.basis_search.search import usable_cores  # much to import for a start

        # A core is left to the windows.
        workers = max(1, usable_cores() - 1)
        words = ["basis", "--database", str(self.folder), "-o", str(self.output)]
        self.run_command(*words, "--lobes", str(self.lobes), "--workers", str(workers))
