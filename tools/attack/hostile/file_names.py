"""Hostile names of files, and folders of them: bytes that are no text, names like options, links of every kind, twins.

What is written through a name has to be there under that name, and nowhere else: it is read again and compared. A
document is never lost; a link to it stays a link.
"""

from __future__ import annotations

import json
import os
import socket
from collections.abc import Iterator
from contextlib import chdir, contextmanager
from pathlib import Path
from typing import Any

from brdf_suite.documents.palette_store import load_palette, save_palette
from brdf_suite.documents.store import load_paint
from tools.attack.hostile.environments import shell
from tools.attack.hostile.scene import COMMAND, WINDOWS, Case, Scene

PAINT, PALETTE = ".brdfpaint", ".brdfpalette"
_NAME_MAX = 255
_DEEP = "d" * 200
_STEMS = (
    b"\xff\xfe\x80", b"caf\xe9", b"-n", b"--json", b"-", b"a\nb", b"a\rb\tc\x1b[31m\x07", b"end ", b" start", b"dots..",
    b"a#1", b"#", b"a:b", b"%41%2f", b"%s{0}$HOME`id`", b"~", b"[a]*?", b"a;b&c|d", b"'\"\\", b"=1+1",
    b"<img src=x>&amp;", "\u202egnp".encode(), "\u200b".encode(), "e\u0301".encode(), b"NUL", b".hidden", b"..a",
    b"x" * 243, "é".encode() * 121,
)  # fmt: skip


def odd_names(ending: str) -> list[str]:
    """Return names of files, each as long as a system allows at most."""
    return [os.fsdecode(stem[: _NAME_MAX - len(ending)] + ending.encode()) for stem in _STEMS]


def _names(scene: Scene) -> None:
    """Documents with odd names are read, opened, exported, packed and written."""
    scene.documents("plain")
    paint = (scene.work / "p.brdfpaint").read_bytes()
    palette = load_palette(scene.work / "p.brdfpalette")
    wanted = scene.start(COMMAND, "measure", "./p.brdfpaint", "--json", fails=False)
    for number, (name, written) in enumerate(zip(odd_names(PAINT), odd_names(PALETTE), strict=True)):
        file, made = scene.work / name, scene.work / written
        file.write_bytes(paint)
        if scene.start(COMMAND, "measure", f"./{name}", "--json", fails=False).count("\n") != wanted.count(
            "\n"
        ):
            scene.fault("another answer", ascii(name))
        scene.start(COMMAND, "palette", "convert", "p.brdfpalette", "-o", f"./{written}", fails=False)
        expect_palette(scene, made, len(palette))
        use = number % 4
        if use == 0:
            scene.start(
                COMMAND, "project", "pack", "--paint", f"./{name}", "-o", "x.brdfproject", fails=False
            )
            scene.start(COMMAND, "palette", "info", "--", written, fails=False)
        elif use == 1:
            scene.start(COMMAND, "design", "step", f"./{name}", "lighter", "-o", f"./{name}", fails=False)
            if load_paint(file).measurements == load_paint(scene.work / "p.brdfpaint").measurements:
                scene.fault("was not written", ascii(name))
        elif use == 2:  # the palette gets its name from that of the file
            made.write_text("GIMP Palette\n128 50 20 x\n")
            scene.start(COMMAND, "palette", "convert", f"./{written}", "-o", "x.brdfpalette", fails=False)
            scene.start(COMMAND, "palette", "info", f"./{written}", "--json", fails=False)
        module, document = list(WINDOWS.items())[number // 2 % len(WINDOWS)]
        if number % 2:
            opened = name if document.endswith(PAINT) else written
            line = (f"./{opened}", "--screenshot", "window.png", "--size", "900x700")
            # Without OpenGL, as on the offscreen platform, the Viewer says that it has no picture.
            scene.start(module, *line, fails=None if module == "brdf_viewer" else False)
        file.unlink()
        made.unlink(missing_ok=True)
    left = sorted(ascii(path.name) for path in scene.work.iterdir())
    expected = ["p.brdfpaint", "p.brdfpalette", "p.gpl", "window.png", "x.brdfpalette", "x.brdfproject"]
    if left != [ascii(name) for name in expected]:
        scene.fault(f"other files were written: {left}")


def expect_palette(scene: Scene, path: Path, entries: int) -> None:
    """Report a palette that is not there, or has not so many entries."""
    if not path.is_file() or len(load_palette(path)) != entries:
        scene.fault("was not written, or not wholly", ascii(path.name))


@contextmanager
def _deep_folder(top: Path, length: int) -> Iterator[tuple[str, int]]:
    """Make folders in each other until a path has ``length`` bytes; yield the path and the last one, open."""
    path = str(top)
    here = os.open(top, os.O_RDONLY)
    try:
        while len(path) < length:
            name = _DEEP[: max(1, min(len(_DEEP), length - len(path) - 1))]
            os.mkdir(name, dir_fd=here)
            below = os.open(name, os.O_RDONLY, dir_fd=here)
            os.close(here)
            here, path = below, f"{path}/{name}"
        yield path, here
    finally:
        os.close(here)


def _long_paths(scene: Scene) -> None:
    """Paths as long as a system allows, and longer ones that are reached from a folder on the way."""
    scene.documents("plain")
    content = (scene.work / "p.brdfpaint").read_bytes()
    for length in (4070, 4083, 4500):
        top = scene.work / str(length)
        top.mkdir()
        with _deep_folder(top, length) as (path, folder):
            with open(os.open("p.brdfpaint", os.O_CREAT | os.O_WRONLY, dir_fd=folder), "wb") as file:  # noqa: PTH123
                file.write(content)
            whole = f"{path}/p.brdfpaint"
            if len(whole) < 4096:
                scene.start(COMMAND, "measure", whole, fails=False)
                scene.start("brdf_designer", whole, "--quit-after", "0", fails=False)
            else:
                scene.start(COMMAND, "measure", whole, fails=True)
            for line in (("-o", f"{path}/x.csv"), ("-o", f"{path}/p.brdfpaint/x.csv")):
                scene.start(COMMAND, "export", "blue", *line)
            scene.start(COMMAND, "sheet", str(top), "-o", "x.png", "--form", "chips")
            steps = "; ".join(f"cd {name}" for name in path[len(str(scene.work)) + 1 :].split("/"))
            for words in (
                ("measure", "p.brdfpaint"),
                ("export", "p.brdfpaint", "-o", "x.csv"),
                ("palette", "info", "."),
            ):
                scene.start(COMMAND, *words, within=shell(steps))
            for module in WINDOWS:
                scene.start(module, "p.brdfpaint", "--quit-after", "0", within=shell(steps))
            with open(os.open("p.brdfpaint", os.O_RDONLY, dir_fd=folder), "rb") as file:  # noqa: PTH123
                if file.read() != content:
                    scene.fault("the document changed", length)


def _links(scene: Scene) -> None:
    """A document that is a link: what it names is replaced as a whole, and the link stays. Other links are refused."""
    scene.documents("plain")
    far = scene.folder / "far"
    far.mkdir()
    palette = load_palette(scene.work / "p.brdfpalette")
    work = scene.work
    for name, to in (
        ("link", "../far/real"), ("chain", "link"), ("dangling", "../far/new"), ("loop", "loop"), ("one", "two"),
        ("two", "one"), ("folder", "../far"), ("null", "/dev/null"), ("under", "link.brdfpalette/x"),
    ):  # fmt: skip
        ending = "" if to.startswith("/dev") or to == "../far" else PALETTE * ("/x" not in to)
        (work / f"{name}{PALETTE}").symlink_to(f"{to}{ending}")
    convert = ("palette", "convert", "p.gpl", "-o")
    for name, real in (("link", "real"), ("chain", "real"), ("dangling", "new")):
        if name != "dangling":
            save_palette(palette, far / f"real{PALETTE}")
        scene.start(COMMAND, *convert, f"{name}{PALETTE}", fails=False)
        if not (work / f"{name}{PALETTE}").is_symlink():
            scene.fault("the link was replaced", name)
        expect_palette(scene, far / f"{real}{PALETTE}", 1)
        scene.start(COMMAND, "palette", "info", f"{name}{PALETTE}", fails=False)
        scene.start("brdf_color_swatch", f"{name}{PALETTE}", "--quit-after", "0", fails=False)
    for name in ("loop", "one", "folder", "null", "under"):
        place = work / f"{name}{PALETTE}"
        to = os.readlink(place)  # noqa: PTH115 - the text itself
        scene.start(COMMAND, *convert, place.name, fails=True)
        scene.start(COMMAND, "measure", place.name, fails=True)
        scene.start(COMMAND, "sheet", place.name, "-o", "x.png", "--form", "chips", fails=None)
        for module in WINDOWS:
            scene.start(module, place.name, "--quit-after", "0")
        if not place.is_symlink() or os.readlink(place) != to:  # noqa: PTH115
            scene.fault("the link was replaced", name)
    # Two names of one file: the one that is written gets a file of its own, the other keeps the old content.
    save_palette(palette, work / f"a{PALETTE}")
    os.link(work / f"a{PALETTE}", work / f"b{PALETTE}")
    scene.start(COMMAND, *convert, f"a{PALETTE}", fails=False)
    expect_palette(scene, work / f"a{PALETTE}", 1)
    expect_palette(scene, work / f"b{PALETTE}", len(palette))
    # Input and output are the same file by two names.
    (work / f"same{PALETTE}").symlink_to(f"b{PALETTE}")
    scene.start(COMMAND, "palette", "convert", f"b{PALETTE}", "-o", f"same{PALETTE}", fails=False)
    expect_palette(scene, work / f"b{PALETTE}", len(palette))


def _twins(scene: Scene) -> None:
    """Names that differ by case, by Unicode's normal form or by an unseen mark alone are different documents."""
    scene.documents("plain")
    names = [
        "Blue",
        "blue",
        "BLUE",
        "caf\u00e9",
        "cafe\u0301",
        "a",
        "a\u200b",
        "\uff41",
        "stra\u00dfe",
        "strasse",
    ]
    folder = scene.work / "twins"
    folder.mkdir()
    for name in names:
        (folder / f"{name}{PAINT}").write_bytes((scene.work / "p.brdfpaint").read_bytes())
    _count(scene, "twins", len(names))
    for module in ("brdf_designer", "brdf_lobe_visualizer"):
        for name in names[:5] if module == "brdf_lobe_visualizer" else ["."]:
            scene.start(module, f"twins/{name}{PAINT if name != '.' else ''}", "--quit-after", "0")
    scene.start("brdf_designer", "--open", *(f"twins/{name}{PAINT}" for name in names), "--quit-after", "0")


def _count(scene: Scene, folder: str, paints: int, bad: int = 0) -> None:
    """Run what takes whole folders, and report where it did not find so many paints, or other faults than ``bad``."""
    fails = None if bad else False
    said = scene.start(COMMAND, "sheet", folder, "-o", "x.png", "--form", "chips", "--json", fails=fails)
    found = _answer(said)
    if found.get("paints", 0) - len(found.get("problems", ())) != paints:
        scene.fault(f"a sheet of other paints: {said[-300:]}", folder)
    scene.start(COMMAND, "palette", "convert", folder, "-o", f"x{PALETTE}", fails=fails)
    if not bad:
        expect_palette(scene, scene.work / f"x{PALETTE}", paints)
    scene.start(COMMAND, "palette", "info", folder, fails=fails)
    scene.start(COMMAND, "export", folder, "-o", "x.csv", fails=fails)
    line = ("batch", "measure", folder, "-o", "results", "--workers", "1", "--json")
    said = scene.start(COMMAND, *line, fails=fails)
    found = _answer(said)
    if found.get("items", 0) - len(found.get("problems", ())) != paints:
        scene.fault(f"a batch of other paints: {said[-300:]}", folder)


def _answer(said: str) -> dict[str, Any]:
    """Return the JSON object in an output, an empty one where there is none."""
    try:
        found: dict[str, Any]
        found, _ = json.JSONDecoder().raw_decode(said[max(0, said.find("{")) :])
    except ValueError:
        return {}
    return found


def _folders(scene: Scene) -> None:
    """A folder with odd names, pipes, devices, links without end and folders that are called like paints."""
    scene.documents("plain")
    folder = scene.work / "all"
    folder.mkdir()
    content = (scene.work / "p.brdfpaint").read_bytes()
    names = [name for name in odd_names(PAINT) if not name.startswith(".")]
    for name in names:
        (folder / name).write_bytes(content)
    for name, to in (
        ("loop", f"loop{PAINT}"), ("dangling", "nothing"), ("zero", "/dev/zero"), ("tty", "/dev/tty"), ("up", "..")
    ):  # fmt: skip
        (folder / f"{name}{PAINT}").symlink_to(to)
    (folder / "up").symlink_to("..")
    os.mkfifo(folder / f"pipe{PAINT}")
    (folder / f"folder{PAINT}").mkdir()
    (folder / f"empty{PAINT}").touch()
    (folder / f"damaged{PAINT}").write_bytes(content[: len(content) // 2])
    with socket.socket(socket.AF_UNIX) as server, chdir(folder):  # the name of a socket has at most 107 bytes
        server.bind(f"socket{PAINT}")
    _count(scene, "all", len(names), bad=2)
    for module in WINDOWS:
        scene.start(module, "all", "--quit-after", "0")
        for name in ("pipe", "zero", "tty", "socket", "loop", "folder"):
            scene.start(module, f"all/{name}{PAINT}", "--quit-after", "0")
    for name in names:
        if load_paint(folder / name).name != "plain":
            scene.fault("a document changed", ascii(name))


CASES = (
    Case("odd file names", _names),
    Case("long paths", _long_paths),
    Case("links", _links),
    Case("twin names", _twins),
    Case("folders of everything", _folders),
)
