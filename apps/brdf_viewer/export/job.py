"""What is to be exported, as a frozen value, and the command that does it in a process of its own."""

from __future__ import annotations

import contextlib
import shutil
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from glob import escape
from pathlib import Path
from typing import Literal

from brdf_qt.program.translation import mark
from brdf_qt.work.command_process import CommandProcess
from PySide6.QtCore import QObject

from brdf_suite.documents.store import PAINT_ENDING, VIEW_ENDING, AnyPaint, save_paint, save_view
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lens
from brdf_suite.regular_files import is_folder

Kind = Literal["picture", "turntable", "sheet"]
KIND_TITLES: dict[str, str] = {
    "picture": mark("Picture"),
    "turntable": mark("Turntable"),
    "sheet": mark("Contact sheet"),
}


@dataclass(frozen=True)
class Format:
    """A kind of file: its title, the ending of its name (empty: a folder), bits a channel where there is a choice."""

    title: str
    ending: str
    bits: int | None = None
    colour_spaces: tuple[str, ...] = ("srgb",)
    transparent: bool = False


_BOTH = ("srgb", "display-p3")
FORMATS: dict[str, tuple[Format, ...]] = {
    "picture": (
        Format(mark("PNG, 8 bits"), ".png", 8, _BOTH, True),
        Format(mark("PNG, 16 bits"), ".png", 16, _BOTH, True),
        Format(mark("EXR, radiance, 32 bits"), ".exr", 32, ("rec2020", *_BOTH), True),
        Format(mark("EXR, radiance, 16 bits"), ".exr", 16, ("rec2020", *_BOTH), True),
    ),
    "turntable": (
        Format(mark("MP4 video"), ".mp4"),
        Format(mark("WebM video"), ".webm"),
        Format(mark("Folder of PNG, 8 bits"), "", 8, _BOTH, True),
        Format(mark("Folder of PNG, 16 bits"), "", 16, _BOTH, True),
    ),
    "sheet": (Format(mark("PNG, 8 bits"), ".png", None, _BOTH),),
}


@dataclass(frozen=True)
class ExportSettings:
    """What the dialog asks for. ``source`` is the palette or folder of a sheet; ``columns`` 0: as many as fit.

    ``lens`` is that of a picture or a turntable, which has a ``shutter_deg`` in place of its turn.
    """

    kind: Kind
    form: Format
    size: tuple[int, int]
    colour_space: str = "srgb"
    samples: int = 4
    transparent: bool = False
    frames: int = 120
    frames_per_second: float = 30.0
    source: str = ""
    columns: int = 0
    lens: Lens = field(default_factory=Lens)
    shutter_deg: float = 0.0


class ExportJob:
    """An export to ``path`` with the scene written to files of its own, so that edits after its start change nothing.

    ``fit_words`` are options that say how lobes are fitted; a sheet takes none. ``paint`` is None where only a file is
    known, ``paint_key``, a measured one. The files go with :meth:`tidy`.
    """

    def __init__(
        self,
        settings: ExportSettings,
        path: Path,
        view: View,
        paint: AnyPaint | None,
        paint_key: str,
        fit_words: Sequence[str] = (),
    ) -> None:
        self.settings, self.path = settings, path
        self._fit_words = fit_words if settings.kind != "sheet" else ()
        self.folder = Path(tempfile.mkdtemp(prefix="brdf-export-"))
        self._view = self.folder / f"view{VIEW_ENDING}"
        self._paint = paint_key
        try:
            save_view(view, self._view)
            if paint is not None:
                self._paint = str(self.folder / f"paint{PAINT_ENDING}")
                save_paint(paint, self._paint)
        except BaseException:
            self.tidy()
            raise

    def arguments(self) -> list[str]:
        """Return the arguments of ``brdf-suite`` that do it."""
        s = self.settings
        words = {
            "picture": ["render", self._paint],
            "turntable": [
                "turntable",
                self._paint,
                f"--frames={s.frames}",
                f"--fps={s.frames_per_second:g}",
                f"--shutter-angle={s.shutter_deg:g}",
            ],
            "sheet": ["sheet", s.source, *([f"--columns={s.columns}"] if s.columns else [])],
        }[s.kind]
        words += ["-o", str(self.path), "--view", str(self._view), *self._fit_words]
        words += ["--size={}x{}".format(*s.size), f"--samples={s.samples}"]
        if len(s.form.colour_spaces) > 1:
            words.append(f"--colour-space={s.colour_space}")
        if s.form.bits is not None:
            words.append(f"--bits={s.form.bits}")
        if s.transparent and s.form.transparent:
            words.append("--transparent")
        return words

    def leftovers(self) -> list[Path]:
        """Return what an export that was ended by force may have left beside its target."""
        stem = self.path.name if not self.settings.form.ending else self.path.stem
        return list(self.path.parent.glob(f".{escape(stem[:80])}.{'[0-9a-f]' * 16}*"))

    def tidy(self) -> None:
        """Take the scene's files away."""
        shutil.rmtree(self.folder, ignore_errors=True)  # in the temporary folder, which is emptied anyway


class ExportProcess(CommandProcess):
    """Runs one export; its signals are those of the command, ``done`` with the lines that it printed."""

    def __init__(self, job: ExportJob, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.job = job

    def start(self) -> None:
        self.run_command(*self.job.arguments())

    def clean_up(self, *, forced: bool) -> None:
        """Remove the scene's files; after an end by force also the unfinished export."""
        if forced:
            for path in self.job.leftovers():
                with contextlib.suppress(OSError):  # another process may still hold it
                    shutil.rmtree(path) if is_folder(path) else path.unlink()
        self.job.tidy()
