"""Hostile environments: variables of the system and of Qt, limits of the kernel, closed streams, missing folders.

Each case runs the usual commands and opens the programs on Qt's offscreen platform. Where the surroundings do not
matter to what is asked for, the answer has to be the same as without them, and no file may differ.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations

from brdf_suite import variables
from tools.attack.hostile.scene import COMMAND, WINDOWS, Case, Scene

NAME = "Café İıß 粉 Ω"
"""A name whose letters no single-byte encoding has all of."""
_SAME = (("list", "paints"), ("measure", "blue", "--json"), ("palette", "info", "p.brdfpalette", "--json"))
"""Commands whose output depends on nothing around them."""
_WRITTEN = {
    "x.png": ("render", "blue", "-o", "x.png", "--size", "32x32"),
    "x.csv": ("export", "p.brdfpaint", "-o", "x.csv"),
    "x.gpl": ("palette", "convert", "p.brdfpalette", "-o", "x.gpl"),
}
"""Commands that write a file, by its name; each file is the same each time."""
LOCALES: tuple[Mapping[str, str | None], ...] = (
    {"LC_ALL": "tr_TR.UTF-8"},
    {"LC_ALL": "de_DE.UTF-8", "LC_NUMERIC": "de_DE.UTF-8"},
    {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
    {"LC_ALL": "POSIX", "PYTHONIOENCODING": "ascii:strict"},
    {"LC_ALL": "xx_YY.nonsense", "LANGUAGE": "../../etc:\u202e"},
    {"LC_ALL": "", "LANG": "A" * 5000},
    {"LC_ALL": None, "LANG": None, "LC_CTYPE": None},
)
TIME_ZONES = (
    "",
    "nonsense",
    "UTC+99999",
    ":/dev/zero",
    "../../../etc/passwd",
    "<\u202e>-25:99:99",
    "A" * 5000,
)
WIDTHS = ("1", "0", "-7", "999999999", "nan", "9" * 5000, "")
_QT: tuple[Mapping[str, str], ...] = (
    {"QT_SCALE_FACTOR": "nonsense", "QT_STYLE_OVERRIDE": "nonsense"},
    {"QT_SCALE_FACTOR": "nan", "QT_FONT_DPI": "0"},
    {"QT_SCALE_FACTOR": "-3", "QT_FONT_DPI": "-96"},
    {"QT_SCALE_FACTOR": "0.01", "QT_STYLE_OVERRIDE": "Windows"},
    {"QT_SCREEN_SCALE_FACTORS": ";;=;1e9", "QT_SCALE_FACTOR_ROUNDING_POLICY": "nonsense"},
    {"QT_QPA_PLATFORMTHEME": "nonsense", "QT_IM_MODULE": "nonsense", "QT_PLUGIN_PATH": "/dev/null"},
    {"XDG_RUNTIME_DIR": "/nonexistent", "XDG_CONFIG_DIRS": ":::", "XDG_DATA_DIRS": "/dev/null"},
    {"QT_LOGGING_RULES": "*=true", "QT_DEBUG_PLUGINS": "1"},
)
_OWN: tuple[Mapping[str, str], ...] = (
    {variables.CACHE_MB: "nan", variables.READ_MB: "-1"},
    {variables.CACHE_MB: "9" * 5000, variables.READ_MB: "9" * 5000},
    {variables.CACHE_MB: "1e400", variables.READ_MB: "\u0661"},
    {variables.LINK: "/../" + "x" * 300},
    {variables.LINK: "\u202e\n*"},
    {"NUMBA_CACHE_DIR": "/dev/null/x", "OPENBLAS_NUM_THREADS": "nonsense", "OMP_NUM_THREADS": "-1"},
)


def shell(before: str, after: str = "") -> tuple[str, ...]:
    """Return a command that runs ``before`` in a shell, and then the command behind it, with the streams ``after``.

    >>> shell("ulimit -n 24")
    ('sh', '-c', 'ulimit -n 24; exec "$@" ', 'sh')
    """
    return ("sh", "-c", f'{before}; exec "$@" {after}', "sh")


class Answers:
    """What the commands print and write without anything around them, and what they do now."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        scene.documents(NAME)
        self.said = {line: scene.start(COMMAND, *line, fails=False) for line in _SAME}
        self.files = dict(zip(_WRITTEN, self._write(fails=False), strict=True))

    def check(
        self,
        what: str,
        *,
        fails: bool | None = False,
        within: Sequence[str] = (),
        said: bool = True,
        written: Iterable[str] = ("x.csv", "x.gpl"),
    ) -> None:
        """Run the commands, and report answers and files that differ; ``fails`` None: each may fail in words."""
        if said:
            for line, wanted in self.said.items():
                now = self.scene.start(COMMAND, *line, fails=fails, within=within, own_variables=True)
                if wanted not in now and not (fails is None and now.startswith("brdf-suite")):
                    self.scene.fault(f"another answer: {now[:200]!r}", (what, line))
        names = list(written)
        for name, content in zip(names, self._write(names, fails=fails, within=within), strict=True):
            if content != self.files[name] and (content is not None or fails is False):
                self.scene.fault("another file", (what, name))

    def _write(
        self, names: Iterable[str] = tuple(_WRITTEN), *, fails: bool | None, within: Sequence[str] = ()
    ) -> list[str | None]:
        found: list[str | None] = []
        for name in names:
            file = self.scene.work / name
            file.unlink(missing_ok=True)
            self.scene.start(COMMAND, *_WRITTEN[name], fails=fails, within=within, own_variables=True)
            found.append(hashlib.sha256(file.read_bytes()).hexdigest() if file.exists() else None)
        return found


def _open(
    scene: Scene, number: int | None, *, fails: bool | None = False, within: Sequence[str] = ()
) -> None:
    """Open the program of a number, None: all, on the scene's documents, which must not change."""
    for place, (module, document) in enumerate(WINDOWS.items()):
        if number is not None and place != number % len(WINDOWS):
            continue
        before = (scene.work / document).read_bytes()
        line = (document, "--quit-after", "0")
        scene.start(module, *line, fails=fails, within=within, own_variables=True)
        if (scene.work / document).read_bytes() != before:
            scene.fault("the document changed", line)


def _locales(scene: Scene) -> None:
    answers = Answers(scene)
    for number, change in enumerate(LOCALES):
        with scene.changed(change):
            answers.check(str(change)[:60])
            _open(scene, number)


def _time_zones(scene: Scene) -> None:
    answers = Answers(scene)
    for number, zone in enumerate(TIME_ZONES):
        with scene.changed({"TZ": zone}):
            answers.check(zone[:60], written=("x.csv",))
            _open(scene, number)


def _temporary_folders(scene: Scene) -> None:
    """The temporary folder is missing, cannot be written, is a file, is a link to nothing."""
    answers = Answers(scene)
    (scene.folder / "file").touch()
    (scene.folder / "link").symlink_to("nothing")
    (scene.folder / "locked").mkdir(mode=0o555)
    for number, name in enumerate(("missing", "locked", "file", "link", "x" * 300)):
        place = str(scene.folder / name)
        with scene.changed({"TMPDIR": place, "TMP": place, "TEMP": place}):
            answers.check(name[:20], written=_WRITTEN, said=number == 0)
            _open(scene, number)


def _widths(scene: Scene) -> None:
    for width in WIDTHS:
        with scene.changed({"COLUMNS": width, "LINES": width}):
            for words in (
                ("--help",),
                ("help", "render"),
                ("render", "--sizes", "1"),
                ("list", "paints"),
                ("measure", "blue"),
            ):
                scene.start(COMMAND, *words, fails=words[-1] == "1")
            scene.start("brdf_viewer", "--help", fails=False)


def _descriptors(scene: Scene) -> None:
    """So few files may be open that some of what a process needs cannot be opened."""
    answers = Answers(scene)
    for most in (24, 12):
        answers.check(f"{most} files", fails=None, within=shell(f"ulimit -n {most}"))
    _open(scene, None, fails=None, within=shell("ulimit -n 24"))


def _memory(scene: Scene) -> None:
    answers = Answers(scene)
    for limit in ("ulimit -s 512", "ulimit -v 1500000"):
        answers.check(limit, fails=None, within=shell(limit), written=_WRITTEN)
        _open(scene, None, fails=None, within=shell(limit))


def _streams(scene: Scene) -> None:
    """Standard streams are closed: what is opened next gets their numbers, and what a library prints goes there."""
    answers = Answers(scene)
    ways = {0: "<&-", 1: ">&-", 2: "2>&-"}
    closed = [some for count in (1, 2, 3) for some in combinations(ways, count)]
    for number, some in enumerate(closed):
        within = shell(":", " ".join(ways[stream] for stream in some))
        what = f"without {some}"
        # Where a result would be printed, its loss is a failure.
        answers.check(
            what, fails=None if 1 in some else False, within=within, said=1 not in some, written=_WRITTEN
        )
        with scene.changed({"QT_DEBUG_PLUGINS": "1"}):  # which prints hundreds of lines
            _open(scene, number if len(some) < 3 else None, within=within)


def _removed_folder(scene: Scene) -> None:
    """The working folder was removed before the start."""
    answers = Answers(scene)
    within = shell("mkdir gone; cd gone; rmdir ../gone")
    for line, wanted in list(answers.said.items())[:2]:
        if wanted not in scene.start(COMMAND, *line, fails=False, within=within, own_variables=True):
            scene.fault("another answer", line)
    place = scene.work / "p.brdfpaint"
    for words in (
        ("palette", "info", str(scene.work / "p.brdfpalette")),
        ("measure", str(place)),
        ("export", str(place), "-o", str(scene.work / "x.csv")),
        ("render", "blue", "-o", str(scene.work / "x.png"), "--size", "32x32"),
    ):
        scene.start(COMMAND, *words, fails=False, within=within, own_variables=True)
    for more in (
        ("measure", "p.brdfpaint"),
        ("export", "blue", "-o", "x.csv"),
        ("sheet", ".", "-o", "x.png"),
    ):
        scene.start(COMMAND, *more, fails=True, within=within, own_variables=True)
    scene.start(COMMAND, "batch", "measure", "blue", "-o", "x", "--workers", "1", fails=True, within=within)
    for module in WINDOWS:
        scene.start(module, str(place), "--quit-after", "0", within=within, fails=False)
        scene.start(module, "p.brdfpaint", "--quit-after", "0", within=within)


def _odd_variables(scene: Scene) -> None:
    answers = Answers(scene)
    for number, change in enumerate(_QT):
        with scene.changed(change):
            _open(scene, number)
            _open(scene, number + 2)
    for number, change in enumerate(_OWN):
        with scene.changed(change):
            answers.check(str(change)[:60], fails=None, said=False, written=("x.png",))
            _open(scene, number)
            scene.start(COMMAND, "cache")


def _odd_folders(scene: Scene) -> None:
    """Settings and cache are files, links to nothing, links to themselves, folders without end."""
    answers = Answers(scene)
    (scene.folder / "file").write_text("mine")
    (scene.folder / "loop").symlink_to("loop")
    places = {
        "a file": "file",
        "below a file": "file/x",
        "a link to nothing": "dangling/x",
        "a loop": "loop",
        "a long name": "x" * 300,
        "a long path": "x/" * 2100,
    }
    (scene.folder / "dangling").symlink_to("nothing")
    for number, (what, name) in enumerate(places.items()):
        for variable in (variables.SETTINGS, variables.CACHE):
            with scene.changed({variable: str(scene.folder / name)}):
                answers.check(f"{variable} is {what}", written=("x.png",), said=False)
                _open(scene, number if variable == variables.CACHE else None)
                if variable == variables.CACHE:
                    scene.start(COMMAND, "cache")
                    scene.start(COMMAND, "cache", "clear")
                    scene.start(COMMAND, "prefilter", "overcast")
    if (scene.folder / "file").read_text() != "mine":
        scene.fault("a file in the place of a folder was changed")


CASES = (
    Case("odd locales", _locales),
    Case("odd time zones", _time_zones),
    Case("temporary folders", _temporary_folders),
    Case("widths of the terminal", _widths),
    Case("few descriptors", _descriptors),
    Case("little memory", _memory),
    Case("closed streams", _streams),
    Case("removed folder", _removed_folder),
    Case("odd variables", _odd_variables),
    Case("odd folders", _odd_folders),
)
