"""A scene of hostile surroundings: a folder, an environment, the processes that are started there, and their faults."""

from __future__ import annotations

import os
import pty
import re
import select
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TypeVar

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.processes import child_command
from tools.attack.command_lines import home

T = TypeVar("T")
WINDOWS = {"brdf_designer": "p.brdfpaint", "brdf_viewer": "p.brdfpaint", "brdf_color_swatch": "p.brdfpalette",
           "brdf_lobe_visualizer": "p.brdfpaint"}  # fmt: skip
"""The programs, and the document that each is opened with."""
COMMAND = "brdf_suite"
_PATIENCE_S = 180.0
_ORDINARY = ("setpriv", "--bounding-set=-dac_override,-dac_read_search,-fowner")
_TRACES = re.compile(r"Traceback|Fatal Python error|Exception ignored|Internal error")
_STATUSES = (0, 1, 2, 130)


@dataclass
class Surroundings:
    """Processes that were started, and what was wrong, by the name of the case."""

    processes: int = 0
    executions: int = 0
    local_files_shown: int = 0
    faults: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Case:
    """One kind of surroundings; ``run(scene)`` starts processes and reports through it; ``in_slices``: so do slices."""

    name: str
    run: Callable[[Scene], object]
    in_slices: bool = False


class Scene:
    """The folder, the environment and the figures of one case."""

    def __init__(self, name: str, folder: Path, found: Surroundings, *, brief: bool = False) -> None:
        self.name, self.folder, self.found = name, folder, found
        self._brief = brief
        self.work = folder / "work"
        self.work.mkdir()
        self.environment = home(folder)

    def some(self, every: Iterable[T], count: int = 1) -> list[T]:
        """Return what a case goes through; in a slice the last ``count`` of it."""
        return list(every)[-count:] if self._brief else list(every)

    def start(
        self,
        module: str,
        *arguments: str,
        ordinary: bool = False,
        fails: bool | None = None,
        within: Sequence[str] = (),
        own_variables: bool = False,
    ) -> str:
        """Run a module of the suite; return its output.

        Parameters
        ----------
        ordinary
            Without the rights by which an administrator writes what cannot be written.
        fails
            Whether it must fail or must not (None: either).
        within
            A command that starts the command which follows it, such as a shell with limits.
        own_variables
            The interpreter follows the variables ``PYTHON*``, as where a user starts the command.
        """
        self.found.processes += 1
        command = child_command(module, *arguments)
        if own_variables:
            command = [sys.executable, "-P", "-m", module, *arguments]
        rights = _ORDINARY if ordinary and os.getuid() == 0 else ()
        try:
            done = subprocess.run(
                [*rights, *within, *command],
                cwd=self.work,
                env=self.environment,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                encoding="utf-8",
                errors="replace",
                timeout=_PATIENCE_S,
                check=False,
            )
        except subprocess.TimeoutExpired:
            self.fault("hangs", arguments)
            return ""
        self._judge(done.stderr, done.returncode, fails, arguments)
        return done.stdout + done.stderr

    def _judge(self, said: str, status: int, fails: bool | None, arguments: Sequence[str]) -> None:
        if _TRACES.search(said):
            self.fault(said[-400:], arguments)
        elif status not in _STATUSES or (fails is not None and fails != bool(status)):
            self.fault(f"status {status}: {said[-300:]}", arguments)

    def show(self, module: str, *arguments: str) -> str:
        """Run a module of the suite on a terminal; return what it is shown."""
        self.found.processes += 1
        ours, its = pty.openpty()
        with os.fdopen(ours, "rb", buffering=0) as terminal:
            process = subprocess.Popen(
                child_command(module, *arguments),
                cwd=self.work,
                env=self.environment,
                stdin=subprocess.DEVNULL,
                stdout=its,
                stderr=its,
            )
            os.close(its)
            until, said = time.monotonic() + _PATIENCE_S, b""
            try:
                with suppress(OSError):  # how Linux reports that the other end is closed
                    while select.select([terminal], [], [], max(0.0, until - time.monotonic()))[0]:
                        block = terminal.read(1 << 16)
                        if not block:
                            break
                        said += block
                process.wait(max(0.0, until - time.monotonic()))
            except subprocess.TimeoutExpired:
                self.fault("hangs", arguments)
            else:
                self._judge(said.decode("utf-8", "replace"), process.returncode, None, arguments)
            finally:
                process.kill()
                process.wait()
        return said.decode("utf-8", "replace").replace("\r\n", "\n")

    @contextmanager
    def changed(self, variables: Mapping[str, str | None]) -> Iterator[None]:
        """Change variables of the environment in the body; None takes one away."""
        kept = self.environment
        self.environment = {name: value for name, value in {**kept, **variables}.items() if value is not None}
        try:
            yield
        finally:
            self.environment = kept

    def fault(self, text: str, what: object = "") -> None:
        """Count a fault."""
        self.found.faults[f"{self.name}, process {self.found.processes}: {what}"[:300]] = text

    def documents(self, name: str) -> None:
        """Write a paint and two palettes of that name, one as other programs write them."""
        gpl = f"GIMP Palette\nName: {name}\n128 50 20 {name}\n"
        (self.work / "p.gpl").write_text(gpl, encoding="utf-8")
        if not name.isprintable():
            return  # no document of the suite takes it
        paint = replace(load_shipped_paint("blue"), name=name, notes=name, source=name)
        save_paint(paint, self.work / "p.brdfpaint")
        flat, short = FlatColour(name, "RGB", (0.5, 0.2, 0.1)), name[:40]
        entries = (Entry(paint, code=short, tags=(short,), notes=name), Entry(flat, group=(short,)))
        save_palette(Palette(name, entries, notes=name), self.work / "p.brdfpalette")

    def window(self, module: str, *more: str) -> None:
        """Open a window on a document and take a picture of it."""
        self.start(module, WINDOWS[module], "--screenshot", "window.png", "--size", "900x700", *more)
