"""Test a frozen suite as a user has it: no Python on the path, nothing of this checkout.

    python packaging/frozen/smoke.py FOLDER|FILE.deb|FILE.run [--figures FILE.json]

A package is installed before and removed after (as root), an archive extracted. Then: the command's version and list, a
picture, an export, a comparison, a measured paint; each program opens its document under Xvfb and saves a picture of
its window; of the package, ``xdg-open`` opens a document as a file manager does, and a second one goes to the window
that is there.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

PATIENCE_S = 300.0
DOCUMENTS = {
    "brdf-designer": "paint.brdfpaint",
    "brdf-viewer": "view.brdfview",
    "brdf-swatch": "two.brdfpalette",
}


class SmokeError(Exception):
    """Something that a user would notice."""


class Suite:
    """The installed commands, run where there is nothing else."""

    def __init__(self, commands: Path, home: Path) -> None:
        self._commands = commands
        self.home = home
        tools = home / "bin"
        tools.mkdir()
        # The system's commands, for shell scripts as xdg-open is one; no Python among them.
        for folder in (Path("/usr/bin"), Path("/bin")):
            for file in folder.iterdir():
                if not (file.name.startswith(("python", "pypy")) or (tools / file.name).is_symlink()):
                    (tools / file.name).symlink_to(file)
        self.environment = {
            "HOME": str(home),
            "PATH": f"{commands}:{tools}",
            "LANG": "C.UTF-8",
            "XDG_RUNTIME_DIR": str(home),
            "LIBGL_ALWAYS_SOFTWARE": "1",
        }
        if shutil.which("python3", path=self.environment["PATH"]):
            raise SmokeError("there is a Python on the path")

    def run(self, command: str, *words: str, display: str = "") -> str:
        """Run a command, and return what it prints."""
        environment = self.environment | ({"DISPLAY": display} if display else {})
        done = subprocess.run(
            [str(self._commands / command), *words],
            cwd=self.home,
            env=environment,
            capture_output=True,
            text=True,
            timeout=PATIENCE_S,
            check=False,
        )
        if done.returncode != 0:
            raise SmokeError(f"{command} {' '.join(words)}: status {done.returncode}\n{done.stderr}")
        return done.stdout

    def start(self, words: Sequence[str], display: str) -> subprocess.Popen[bytes]:
        """Start a command and leave it running."""
        return subprocess.Popen(
            words, cwd=self.home, env=self.environment | {"DISPLAY": display}, stdin=subprocess.DEVNULL
        )

    def processes(self, executable: Path) -> list[int]:
        """Return the processes of this home folder that run an executable, also those that others started."""
        found = []
        for folder in Path("/proc").iterdir():
            with contextlib.suppress(OSError):  # ended meanwhile
                variables = (folder / "environ").read_bytes().split(b"\0")
                if f"HOME={self.home}".encode() in variables and (folder / "exe").resolve() == executable:
                    found.append(int(folder.name))
        return found


def check_command(suite: Suite) -> None:
    """The command without a screen: list, render, export, compare, documents for the programs."""
    print(suite.run("brdf-suite", "--version").strip())
    for words in (
        ("render", "blue", "-o", "blue.png", "--size", "160x120"),
        ("export", "blue", "-o", "blue.cxf"),
        ("export", "blue", "-o", "blue.pdf"),
        ("palette", "convert", "blue", "copper", "-o", "two.brdfpalette"),
        ("design", "start", "copper", "-o", "paint.brdfpaint"),
        ("thumbnail", "two.brdfpalette", "-o", "thumbnail.png"),
        ("prefilter", "overcast"),
    ):
        suite.run("brdf-suite", *words)
        print("  brdf-suite " + " ".join(words))
    for name in ("blue.png", "blue.cxf", "blue.pdf", "two.brdfpalette", "paint.brdfpaint", "thumbnail.png"):
        if not (suite.home / name).stat().st_size:
            raise SmokeError(f"{name} is empty")
    compared = json.loads(suite.run("brdf-suite", "compare", "blue", "blue", "--json"))
    if max(row["delta_e_2000"] for row in compared["angles"]) != 0.0:
        raise SmokeError("a paint differs from itself")
    (suite.home / "view.brdfview").write_text('{"format": "brdfview", "version": 8}\n', encoding="utf-8")


def check_programs(suite: Suite, display: str) -> float:
    """Each program opens its document and saves a picture of its window; return Designer's start to a usable window."""
    for program in ("brdf-designer", "brdf-viewer", "brdf-lobes", "brdf-swatch"):
        document = DOCUMENTS.get(program, "paint.brdfpaint")
        words = [
            "--open",
            document,
            "--report-startup",
            "--screenshot",
            f"{program}.png",
            "--size",
            "1280x720",
        ]
        printed = suite.run(program, *words, display=display)
        times = json.loads(printed.splitlines()[-1])
        if (suite.home / f"{program}.png").stat().st_size < 10_000:
            raise SmokeError(f"{program}: the picture of its window is empty")
        print(f"  {program} {document}: {times}")
    starts = []
    for _ in range(3):
        printed = suite.run(
            "brdf-designer", "paint.brdfpaint", "--report-startup", "--quit-after", "0", display=display
        )
        starts.append(json.loads(printed.splitlines()[-1])["ready_s"])
    ready = sorted(starts)[1]
    print(f"  Designer ready: {ready:.2f} s, median of {starts}")
    return ready


def check_file_manager(suite: Suite, display: str) -> None:
    """``xdg-open`` opens Designer for a paint; a second paint goes to the same window."""
    suite.environment["XDG_CURRENT_DESKTOP"] = "X-Generic"
    executable = Path("/usr/bin/brdf-designer").resolve()
    for name in ("first", "second"):
        shutil.copy(suite.home / "paint.brdfpaint", suite.home / f"{name}.brdfpaint")
    opened = [suite.start(["xdg-open", str(suite.home / "first.brdfpaint")], display)]
    try:
        _wait(lambda: _titles(display, "first"), "xdg-open shows no window with the paint")
        opened.append(suite.start(["xdg-open", str(suite.home / "second.brdfpaint")], display))
        _wait(lambda: _titles(display, "second"), "the second paint is not shown")
        # What has handed its paint over ends; another program would stay.
        _wait(lambda: opened[1].poll() is not None, "the second paint opened another program")
        if opened[0].poll() is not None:
            raise SmokeError("the first program ended")
    finally:
        for process in suite.processes(executable):
            os.kill(process, signal.SIGKILL)
        for one in opened:
            one.wait(PATIENCE_S)
    print("  xdg-open: opened, and the second document went to the same window")


def _titles(display: str, text: str) -> bool:
    found = subprocess.run(
        ["xwininfo", "-root", "-tree", "-display", display], capture_output=True, text=True, check=False
    )
    return any(text in line for line in found.stdout.splitlines())


def _wait(what: Callable[[], bool], problem: str) -> None:
    end = time.monotonic() + PATIENCE_S
    while not what():
        if time.monotonic() > end:
            raise SmokeError(problem)
        time.sleep(0.3)


@contextlib.contextmanager
def screen() -> Iterator[str]:
    """A display of Xvfb, which finds a free number itself."""
    reading, writing = os.pipe()
    server = subprocess.Popen(
        # Without a reset when the last window closes, during which the next one finds no display.
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1920x1080x24", "-nolisten", "tcp", "-noreset"],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    try:
        with os.fdopen(reading) as file:
            yield f":{file.readline().strip()}"
    finally:
        server.terminate()
        server.wait()


@contextlib.contextmanager
def installed(what: Path, work: Path) -> Iterator[Path]:
    """Install what was built; yield the folder of its commands."""
    if what.suffix == ".deb":
        subprocess.run(["apt-get", "install", "-y", "-q", str(what)], check=True, stdout=subprocess.DEVNULL)
        try:
            yield Path("/usr/bin")
        finally:
            subprocess.run(
                ["apt-get", "remove", "-y", "-q", "brdf-suite"], check=True, stdout=subprocess.DEVNULL
            )
            left = [path for path in (Path("/opt/brdf-suite"), Path("/usr/bin/brdf-suite")) if path.exists()]
            if left:
                raise SmokeError(f"left behind: {left}")
            print("  removed, nothing is left")
    elif what.suffix == ".run":
        subprocess.run(["sh", str(what), str(work / "opt")], check=True, stdout=subprocess.DEVNULL)
        yield work / "opt" / "brdf-suite"
    else:
        yield what


def main() -> int:
    """Install, test, remove."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("built", type=Path)
    parser.add_argument("--figures", type=Path, default=None, metavar="FILE")
    options = parser.parse_args()
    built = options.built.absolute()
    with tempfile.TemporaryDirectory() as work, installed(built, Path(work)) as commands:
        home = Path(work, "home")
        home.mkdir(mode=0o700)
        # The commands alone, where their folder has other programs too.
        own = home / "commands"
        own.mkdir()
        for name in ("brdf-suite", "brdf-designer", "brdf-viewer", "brdf-lobes", "brdf-swatch"):
            (own / name).symlink_to((commands / name).resolve().parent / name)
        suite = Suite(own, home)
        check_command(suite)
        with screen() as display:
            ready = check_programs(suite, display)
            if built.suffix == ".deb":
                check_file_manager(suite, display)
    if options.figures is not None:
        options.figures.write_text(json.dumps({"designer_ready_s": ready}), encoding="utf-8")
    print(f"{built.name}: passed")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except SmokeError as error:
        sys.exit(f"{error}")
