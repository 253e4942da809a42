"""Hostile surroundings: planted files, hostile names, and systems that lack a home, a screen, room or a right clock.

Each case starts real processes in a folder of its own. What is looked for: Python files of the working folder that ran,
PostScript that ran, local files that a name made a window show (a pipe that no other program opens stands for them),
tracebacks, and statuses that the command does not know.
"""

from __future__ import annotations

import os
import re
import shutil
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from brdf_suite.documents.store import save_view
from brdf_suite.documents.view import View
from tools.attack.hostile import environments, file_names
from tools.attack.hostile.scene import COMMAND, WINDOWS, Case, Scene, Surroundings

_UNGUARDED = re.compile(r"(?:^|,)\"?=", re.MULTILINE)
"""Cells that a spreadsheet takes for formulas. What a pipe gets is data, and keeps its invisible characters."""
_TRAPS = ("random", "json", "numpy", "PySide6", "struct", "logging", "brdf_suite", "PIL", "encodings", "site")
_PLUGINS = ("path", "hdrfilm", "perspective", "scene", "roughconductor", "sphere", "constant", "diffuse")
"""Of Mitsuba."""
_FONTS = ("DejaVuSans.ttf", "NotoSans-Regular.ttf", "Arial.ttf")
_TRAP = "from pathlib import Path\nPath(__file__).with_name('ran').touch()\n"
_POSTSCRIPT = "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 8 8\n(ran) (w) file closefile showpage\n"


def _planted_python(scene: Scene) -> None:
    for name in _TRAPS:
        (scene.work / f"{name}.py").write_text(_TRAP)
    scene.documents("plain")
    for module in scene.some(WINDOWS):
        scene.start(module, "--help")
        scene.window(module)
    scene.start(COMMAND, "measure", "p.brdfpaint")
    scene.start(COMMAND, "render", "p.brdfpaint", "-o", "x.png", "--size", "32x32")
    if (scene.work / "ran").exists():
        scene.found.executions += 1
        scene.fault("a Python file of the working folder ran")


def _planted_postscript(scene: Scene) -> None:
    scene.documents("plain")
    for ending in ("png", "jpg", "tif"):
        (scene.work / f"map.{ending}").write_text(_POSTSCRIPT)
    relief = replace(View().relief, normal_map=str(scene.work / "map.png"))
    two_tone = replace(View().two_tone, paint="copper", mask=str(scene.work / "map.tif"))
    save_view(replace(View(), relief=relief, two_tone=two_tone), scene.work / "v.brdfview")
    render = ("render", "blue", "-o", "x.png", "--size", "32x32")
    scene.start(COMMAND, *render, "--view", "v.brdfview")
    scene.start("brdf_viewer", "v.brdfview", "--screenshot", "window.png")
    if (scene.work / "ran").exists():
        scene.found.executions += 1
        scene.fault("PostScript ran")


def hostile_names(pipe: Path) -> list[str]:
    """Return names that windows, terminals, tables and file systems may take for something else."""
    return [
        f'<img src="{pipe}"><b>x</b>',
        f"![x]({pipe}) <table background='{pipe}'>",
        '=HYPERLINK("http://x","y")',
        "A\u202eB\u200b\u2066C %s %n {0} &amp; &lt;",
        "x" * 200,
    ]


@contextmanager
def _pipes_watched(*pipes: Path) -> Iterator[Callable[[], int]]:
    """Make pipes, and count how often another program has one open, which it is let out of."""
    opened = 0
    ended = threading.Event()

    def watch() -> None:
        nonlocal opened
        while not ended.wait(0.05):
            for pipe in pipes:
                try:
                    os.close(os.open(pipe, os.O_WRONLY | os.O_NONBLOCK))
                    opened += 1
                except OSError:
                    continue  # no other process has it open

    for pipe in pipes:
        os.mkfifo(pipe)
    watcher = threading.Thread(target=watch, daemon=True)
    watcher.start()
    try:
        yield lambda: opened
    finally:
        ended.set()
        watcher.join()


def _planted_files(scene: Scene) -> None:
    """Libraries, settings and fonts that the libraries of the suite look for in the working folder."""
    scene.documents("plain")
    (scene.work / "plugins").mkdir()
    (scene.work / ".numba_config.yaml").write_text("cache_dir: compiled\n")
    plugins = [scene.work / "plugins" / f"{name}.so" for name in _PLUGINS]
    with _pipes_watched(*plugins, *(scene.work / name for name in _FONTS)) as opened:
        for line in (
            (
                "render",
                "p.brdfpaint",
                "-o",
                "x.png",
                "--size",
                "16x16",
                "--renderer",
                "reference",
                "--spp",
                "1",
            ),
            ("sheet", "p.brdfpaint", "-o", "x.pdf", "--form", "chips"),
            ("prefilter", "overcast"),
        ):
            scene.start(COMMAND, *line, fails=False)
            if opened() or (scene.work / "compiled").exists():
                scene.found.executions += 1
                scene.fault("a file of the working folder was loaded", line)


def _hostile_names(scene: Scene) -> None:
    pipe = scene.folder / "pipe"
    with _pipes_watched(pipe) as opened:
        for number, name in enumerate(hostile_names(pipe)):
            scene.documents(name)
            for module in WINDOWS if number == 0 else [list(WINDOWS)[number % len(WINDOWS)]]:
                scene.window(module)
            for line in (["measure", "p.brdfpaint", "--csv"], ["palette", "info", "p.gpl"]):
                if _UNGUARDED.search(scene.start(COMMAND, *line)):
                    scene.fault("an unguarded formula", line)
                # Another program is given a name as it is.
                said = scene.show(COMMAND, *line)
                if re.search(r"[\x00-\x08\x0b-\x1f\x7f\u202e\u200b\u2066]", said):
                    scene.fault(f"an unguarded name on the terminal: {said[:200]!r}", line)
        if opened():
            scene.found.local_files_shown += 1
            scene.fault("a window opened the file that a name points to")


def _no_home(scene: Scene) -> None:
    scene.documents("plain")
    homes: list[dict[str, str | None]] = [{"HOME": one} for one in ("/nonexistent", "", "/proc/1", None)]
    for variables in scene.some(homes):
        kept = dict(scene.environment)
        for name in (
            "BRDF_SUITE_CACHE",
            "BRDF_SUITE_SETTINGS",
            "XDG_CACHE_HOME",
            "XDG_CONFIG_HOME",
            "XDG_RUNTIME_DIR",
        ):
            scene.environment.pop(name, None)
        for name, value in variables.items():
            scene.environment.pop(name, None)
            if value is not None:
                scene.environment[name] = value
        scene.start(COMMAND, "list", "paints", ordinary=True, fails=False)
        scene.start(COMMAND, "measure", "blue", ordinary=True, fails=False)
        scene.start("brdf_color_swatch", "--quit-after", "0", ordinary=True)
        scene.environment = kept


def _read_only(scene: Scene) -> None:
    """Everything that is written to belongs to another and cannot be written."""
    scene.documents("plain")
    before = (scene.work / "p.brdfpaint").read_bytes()
    for path in (scene.folder, *scene.folder.rglob("*")):
        path.chmod(0o555 if path.is_dir() else 0o444)
    try:
        scene.start(COMMAND, "list", "paints", ordinary=True, fails=False)
        scene.start(COMMAND, "measure", "p.brdfpaint", ordinary=True, fails=False)
        scene.start(COMMAND, "palette", "convert", "p.brdfpalette", "x.ase", ordinary=True, fails=True)
        scene.start(COMMAND, "cache", "verify", ordinary=True)
        scene.start(COMMAND, "cache", "clear", ordinary=True)
        scene.start(COMMAND, "prefilter", "overcast", ordinary=True)
        for module in scene.some(("brdf_designer", "brdf_color_swatch")):
            scene.start(module, WINDOWS[module], "--quit-after", "0", ordinary=True)
        if (scene.work / "p.brdfpaint").read_bytes() != before:
            scene.fault("a read-only document changed")
    finally:
        for path in (scene.folder, *scene.folder.rglob("*")):
            path.chmod(0o755 if path.is_dir() else 0o644)


def _clock(scene: Scene) -> None:
    """All files that a first run left are ten years in the future, and ten years old, when the next one starts."""
    scene.documents("plain")
    lines = (["measure", "p.brdfpaint"], ["prefilter", "overcast"], ["cache", "verify"])
    for shift in scene.some((0.0, -3.2e8, -3e9, 3.2e8)):
        now = max(0.0, time.time() + shift)
        for path in scene.folder.rglob("*"):
            os.utime(path, (now, now))
        for line in lines:
            scene.start(COMMAND, *line, fails=False)
        for module in scene.some(("brdf_designer", "brdf_color_swatch")):
            scene.start(module, WINDOWS[module], "--quit-after", "0", fails=False)


def _no_graphics(scene: Scene) -> None:
    """No driver of OpenGL, no screen, a screen that does not answer."""
    scene.documents("plain")
    render = ("render", "blue", "-o", "x.png", "--size", "32x32")
    for change in (
        {
            "LIBGL_DRIVERS_PATH": "/nonexistent",
            "GALLIUM_DRIVER": "none",
            "__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent",
        },
        {"MESA_GL_VERSION_OVERRIDE": "1.1"},
        {"QT_QPA_PLATFORM": "xcb", "DISPLAY": ":987"},
        {"QT_QPA_PLATFORM": "none"},
    ):
        kept = dict(scene.environment)
        scene.environment.update(change)
        scene.start(COMMAND, *render)
        if "none" not in change.values() or "GALLIUM_DRIVER" in change:
            # Qt ends a process itself where it finds no platform: with a message, and a signal that is its own.
            if change.get("QT_QPA_PLATFORM") != "xcb":
                scene.start("brdf_viewer", "blue", "--quit-after", "0")
            scene.start(COMMAND, "viewer", "blue", "--quit-after", "0")
        scene.environment = kept


def _tampered_cache(scene: Scene) -> None:
    """Whatever a first run kept is cut off, emptied, replaced or made a folder; the answer must not change."""
    scene.documents("plain")
    cache = Path(scene.environment["BRDF_SUITE_CACHE"])
    line = ("render", "p.brdfpaint", "-o", "x.png", "--size", "48x32")
    scene.start(COMMAND, *line, fails=False)
    if not (scene.work / "x.png").exists():
        return  # nothing can be drawn here
    wanted = (scene.work / "x.png").read_bytes()
    for number in scene.some((0, 1, 2, 4, 5, 3)):
        for path in [path for path in cache.rglob("*") if path.is_file()]:
            content = path.read_bytes()
            if number == 0:
                path.write_bytes(content[: len(content) // 2])
            elif number == 1:
                path.write_bytes(b"")
            elif number == 2:
                path.write_bytes(bytes(len(content)))
            elif number == 3:
                path.write_bytes(content[:-1] + bytes([content[-1] ^ 1]) if content else b"x")
            else:
                path.unlink()
                path.mkdir() if number == 4 else path.symlink_to("/dev/zero")
        scene.start(COMMAND, *line, fails=False)
        if (scene.work / "x.png").read_bytes() != wanted:
            scene.fault("another picture", f"tampering {number}")
        for path in [path for path in cache.rglob("*") if path.is_symlink()]:
            path.unlink()


CASES = (
    Case("planted Python", _planted_python, in_slices=True),
    Case("planted files", _planted_files, in_slices=True),
    Case("planted PostScript", _planted_postscript),
    Case("hostile names", _hostile_names),
    Case("no home", _no_home, in_slices=True),
    Case("read-only folders", _read_only, in_slices=True),
    Case("clock set back", _clock, in_slices=True),
    Case("no graphics", _no_graphics),
    Case("tampered cache", _tampered_cache, in_slices=True),
    *environments.CASES,
    *file_names.CASES,
)


def run_cases(
    folder: Path, words: list[str], report: Callable[[str], None], *, brief: bool = False
) -> Surroundings:
    """Run the cases whose names begin with one of ``words``, or all; ``brief``: a part of some, in a minute."""
    found = Surroundings()
    for case in CASES:
        if brief and not case.in_slices:
            continue
        if words and not any(case.name.startswith(word) for word in words):
            continue
        own = folder / case.name.replace(" ", "_")
        own.mkdir()
        own.chmod(0o755)
        count = len(found.faults)
        case.run(Scene(case.name, own, found, brief=brief))
        for place, text in list(found.faults.items())[count:]:
            report(f"{place}: {text}"[:600])
        shutil.rmtree(own, ignore_errors=True)
    return found
