"""Wrong command lines, signals during the start, closed pipes: no traceback and no unknown status.

Wrong lines run in forked children that have the command imported: hundreds in a minute. Each has a folder, a home and
a cache of its own, five seconds of processor time and a bound of memory; what runs out of them was at work, and is no
fault. Signals and pipes need real processes.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import random
import re
import resource
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from brdf_suite import variables
from brdf_suite.cli import default_action
from brdf_suite.cli.main import COMMANDS, main, parser
from brdf_suite.processes import child_command

_STATUSES = frozenset((0, 1, 2, 130, 141))
_SECONDS = 5.0
_MEMORY = 2 << 30
_WORDS = [
    "", " ", "-", "--", "---", "-1", "0", "1", "nan", "inf", "1e999", "9" * 5000, "0x10", "1x1", "0x0", "99999x99999",
    "-5x-5", "\u0661", "a\u202eb", "\ud800", "\n", "\x1b[31m", "%s", "{}", "$(id)", "`id`", ";", "..", "../..", "/",
    "/dev/null", "/proc/self/mem", "file\0x", "~", "~root", "blue", "copper#1", "table1:9", "no such", "--help",
    "--json", "-o", "--output=", "--size", "@file", "=1+1", "<img src=x>", "é" * 300, "model:ggx", "a,b,c", "1,2,3",
    "45as15", "D65", "*", "[", "(", "1/0", "{\"a\":", "NUL", "con", "\\\\host\\share",
]  # fmt: skip
_FILES = ("empty", "folder", "noise", "paint.brdfpaint", "palette.csv", "unreadable", "link")


@dataclass
class Lines:
    """What came of command lines: how many, and those with a traceback or an unknown end."""

    lines: int = 0
    faults: dict[str, str] = field(default_factory=dict)

    def judge(self, line: str, status: int, said: str, *, killed: bool = False) -> None:
        """Count a line by its status (negative: a signal) and what it said on standard error."""
        self.lines += 1
        if "Traceback" in said:
            self.faults[line] = said.strip().split("\n")[-1][:200]
        elif status not in _STATUSES and not killed:
            self.faults[line] = f"status {status}: {said[-200:]}"


def home(folder: Path) -> dict[str, str]:
    """Return the environment of a process whose home, cache and settings lie below ``folder``."""
    own = {name: str(folder / name.lower()) for name in ("HOME", variables.CACHE, variables.SETTINGS)}
    for place in own.values():
        Path(place).mkdir(parents=True, exist_ok=True)
    return {**os.environ, **own, "QT_QPA_PLATFORM": "offscreen", variables.LINK: f"attack{os.getpid()}"}


_LONG_NAMES = ("x" * 300, "x" * 300 + "/y", "d/" * 3000 + "x")
"""Names that no file system takes."""


def long_names() -> list[list[str]]:
    """Return lines of the commands that start no workers, each with a name that no file system takes."""
    found: list[list[str]] = []
    waiting = [(parser((name,)), [name]) for name in COMMANDS if name not in ("bench", "batch")]
    while waiting:
        parsing, words = waiting.pop()
        inner = next(
            (action.choices for action in parsing._actions if isinstance(action.choices, dict)), None
        )
        if inner is not None:
            named = words[:1] if words[0] in inner else sorted(inner)
            waiting += [(inner[name], [*words, name] if name != words[0] else words) for name in named]
            continue
        places = [action for action in parsing._actions if not action.option_strings]
        options = [action for action in parsing._actions if action.option_strings and action.nargs != 0]
        usual = [next(iter(action.choices)) if action.choices else "blue" for action in places]
        needed = {
            action.option_strings[-1]: "out.x"
            for action in options
            if action.required or action.dest == "output"
        }
        for name in _LONG_NAMES:
            for number in range(len(places)):
                given = [*usual[:number], name, *usual[number + 1 :]]
                found.append([*words, *given, *itertools.chain(*needed.items())])
            for action in options:
                chosen = {**needed, action.option_strings[-1]: name}
                found.append([*words, *usual, *itertools.chain(*chosen.items())])
    return found


def options_of(command: str) -> list[str]:
    """Return the options that a command declares, subcommands' among them."""
    found: list[str] = []
    waiting = [parser((command,))]
    while waiting:
        one = waiting.pop()
        for action in one._actions:
            found += action.option_strings
            choices = action.choices
            if isinstance(choices, dict):
                waiting += [choices[command]] if command in choices else list(choices.values())
                found += [] if command in choices else list(choices)
    return sorted(set(found) - {"--help", "-h", "--verbose", "-v"})  # --verbose is to show a traceback


def wrong_lines(seed: int) -> Iterator[list[str]]:
    """Yield wrong and half wrong lines of every command that opens no window, for ever."""
    rng = random.Random(seed)
    commands = [name for name in COMMANDS if name != "bench"]
    known = {name: options_of(name) for name in commands}
    with_long_names = long_names()
    while True:
        if rng.random() < 0.25:
            yield rng.choice(with_long_names)
        command = rng.choice(commands)
        line = [command]
        if command == "basis":  # in this process, so that its processor time counts
            line += ["--workers", "1"]
        for _ in range(rng.randrange(5)):
            kind = rng.randrange(6)
            if kind < 3 and known[command]:
                line.append(rng.choice(known[command]))
            elif kind == 3:
                line.append(rng.choice(_FILES))
            else:
                line.append(rng.choice(_WORDS))
        if rng.random() < 0.1:
            line[0] = rng.choice(_WORDS) or "x"
        if line[0] in default_action.PROGRAMS or line[0].startswith("-") or line[0] in ("", "open", "help"):
            continue
        yield line


def run_forked(line: list[str], folder: Path) -> tuple[int, str]:
    """Run the command in a forked child; return its status (negative: a signal) and its standard error."""
    errors = folder / "stderr"
    pid = os.fork()
    if pid == 0:
        try:
            for stream, target in ((0, os.devnull), (1, os.devnull), (2, str(errors))):
                os.dup2(os.open(target, os.O_RDWR | os.O_CREAT | os.O_TRUNC), stream)
            os.environ.update(home(folder))
            os.chdir(folder / "work")
            resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
            resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 26, 1 << 26))
            signal.setitimer(signal.ITIMER_PROF, _SECONDS)
            signal.signal(signal.SIGPROF, signal.SIG_DFL)
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            status = 1
            try:
                status = main(line)
            except SystemExit as error:
                status = error.code if isinstance(error.code, int) else 1
            except BaseException as error:  # noqa: BLE001 - the interpreter would print a traceback
                os.write(2, f"Traceback: {type(error).__name__}: {error}\n".encode("utf-8", "replace"))
            os._exit(status & 255)
        finally:
            os._exit(99)
    ends = time.monotonic() + 60.0
    while True:
        done, status = os.waitpid(pid, os.WNOHANG)
        if done:
            break
        if time.monotonic() > ends:
            os.kill(pid, signal.SIGKILL)
            os.waitpid(pid, 0)
            return -signal.SIGALRM, "hangs"
        time.sleep(0.002)
    return os.waitstatus_to_exitcode(status), errors.read_text(errors="replace")


def furnish(folder: Path) -> None:
    """Write the files that lines name."""
    work = folder / "work"
    (work / "folder").mkdir(parents=True)
    (work / "empty").touch()
    (work / "noise").write_bytes(random.Random(1).randbytes(5000))
    (work / "paint.brdfpaint").write_text('{"format": "brdfpaint", "version": 99}')
    (work / "palette.csv").write_text('name,L_45\n"=1+1,3\n')
    (work / "unreadable").write_text("x")
    (work / "unreadable").chmod(0)
    (work / "link").symlink_to("link")


def wrong(count: int, seed: int, report: Callable[[str], None]) -> Lines:
    """Run ``count`` wrong lines."""
    found = Lines()
    lines = wrong_lines(seed)
    for _ in range(count):
        line = next(lines)
        with tempfile.TemporaryDirectory(prefix="attack-", ignore_cleanup_errors=True) as folder:
            furnish(Path(folder))
            status, said = run_forked(line, Path(folder))
        before = len(found.faults)
        found.judge(repr(line)[:300], status, said, killed=status == -signal.SIGPROF)
        if len(found.faults) > before:
            report(f"brdf-suite {line!r}"[:200] + f": {said.strip()[-300:]}")
    return found


_NEW = "new"
"""Stands for the name of a folder that is not there."""
_STARTS = (
    ("brdf_suite", "list", "paints"),
    ("brdf_suite", "measure", "blue"),
    ("brdf_suite", "fit", "copper"),
    ("brdf_suite", "batch", "measure", "blue", "--workers", "1", "-o", _NEW),
    ("brdf_designer", "--quit-after", "0"),
    ("brdf_viewer", "--quit-after", "0"),
    ("brdf_lobe_visualizer", "--quit-after", "0"),
    ("brdf_color_swatch", "--quit-after", "0"),
)
_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE)


def signals(count: int, seed: int, report: Callable[[str], None]) -> Lines:
    """Signal processes at random moments of their start, and give the rest of them closed and broken pipes."""
    rng = random.Random(seed)
    found = Lines()
    with tempfile.TemporaryDirectory(prefix="attack-", ignore_cleanup_errors=True) as folder:
        environment = home(Path(folder))
        for number in range(count):
            start = _STARTS[number % len(_STARTS)]
            line = tuple(f"{folder}/{number}" if word is _NEW else word for word in start)
            before = len(found.faults)
            if number % 3 == 2:
                kind = number // 3 % len(_PIPES)
                status, said = _with_pipes(child_command(*line), environment, kind)
                found.judge(f"{' '.join(line)} with {_PIPES[kind]}", status, said)
            else:
                sent = rng.choice(_SIGNALS)
                after, to_group = rng.uniform(0.0, 3.0), rng.random() < 0.5
                status, said = _with_signal(child_command(*line), environment, sent, after, to_group=to_group)
                found.judge(
                    f"{' '.join(line)}, {sent.name} after {after:.3f} s" + " to its group" * to_group,
                    status,
                    said,
                    killed=status == -sent,
                )
            if len(found.faults) > before:
                report(f"{list(found.faults)[-1]}: {said.strip()[-300:]}")
    return found


def _with_signal(
    command: list[str], environment: dict[str, str], sent: signal.Signals, after_s: float, *, to_group: bool
) -> tuple[int, str]:
    """Signal a process, or it and its children as a terminal does."""
    process = subprocess.Popen(
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    _await_entry_point(process)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(after_s)
    if process.poll() is None:
        if to_group:
            os.killpg(process.pid, sent)
        else:
            process.send_signal(sent)
    return _ended(process)


_ENTRY_S = 10.0
"""Where the entry point was not seen by then, it has been passed."""


def _await_entry_point(process: subprocess.Popen[bytes]) -> None:
    """Wait until the suite's entry point has given SIGINT its default action.

    While the interpreter starts, it answers an interrupt with a traceback, and nothing of the suite has run.
    """
    was_handled, ends = False, time.monotonic() + _ENTRY_S
    while process.poll() is None and time.monotonic() < ends:
        found = re.search(r"^SigCgt:\s*(\w+)", Path(f"/proc/{process.pid}/status").read_text(), re.MULTILINE)
        is_handled = found is not None and bool(int(found[1], 16) >> (signal.SIGINT - 1) & 1)
        if was_handled and not is_handled:
            return
        was_handled = was_handled or is_handled
        time.sleep(0.001)


def _ended(process: subprocess.Popen[bytes]) -> tuple[int, str]:
    try:
        _, said = process.communicate(timeout=120.0)
    except subprocess.TimeoutExpired:
        process.kill()
        _, said = process.communicate()
        return 99, f"hangs {(said or b'').decode(errors='replace')}"
    return process.returncode, (said or b"").decode(errors="replace")


_PIPES = ("a pipe without a reader", "a closed standard output", "a full device", "a closed standard input")


def _with_pipes(command: list[str], environment: dict[str, str], kind: int) -> tuple[int, str]:
    def begin(stdin: int, stdout: int, closed: int | None = None) -> subprocess.Popen[bytes]:
        if closed is not None:  # by a shell: Popen gives every stream something
            command[:0] = ["sh", "-c", f'exec "$@" {closed}{"<" if closed == 0 else ">"}&-', "sh"]
        return subprocess.Popen(command, env=environment, stdin=stdin, stdout=stdout, stderr=subprocess.PIPE)

    if kind == 0:
        receive, send = os.pipe()
        os.close(receive)
        process = begin(subprocess.DEVNULL, send)
        os.close(send)
    elif kind == 2:
        with Path("/dev/full").open("wb") as full:
            process = begin(subprocess.DEVNULL, full.fileno())
    else:
        process = begin(subprocess.DEVNULL, subprocess.DEVNULL, 1 if kind == 1 else 0)
    return _ended(process)
