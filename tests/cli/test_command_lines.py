"""Command lines as people type them, mistakes among them: what each prints where, and its exit status."""

from __future__ import annotations

import io
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from brdf_suite.cli.main import COMMANDS, main, parser
from brdf_suite.cli.output import STAGE_END
from brdf_suite.cli.tools.manual import parsers
from brdf_suite.command_parser import CommandParser
from brdf_suite.extras import PACKAGES
from brdf_suite.variables import VARIABLES

CHECKOUT = Path(__file__).resolve().parents[2]
_STAGE = re.compile(rf".*{re.escape(STAGE_END)}\n", re.MULTILINE)
SMALL = "--size 16x12 --mesh sphere --environment booth --no-occlusion"


@dataclass(frozen=True)
class Line:
    """A command line and what it must do.

    ``out`` and ``err`` are parts of what is written there; empty: nothing may be. Lines of stages do not count.
    """

    words: str
    status: int
    out: str = ""
    err: str = ""
    stdin: str | None = None
    made: str | None = None


TRIAL = (
    Line("export blue -o - --format csv", 0, "name,illuminant", "standard output: Blue, CSV table"),
    Line("palette convert two.cxf - --format gpl", 0, "GIMP Palette", "standard output: 2 entries"),
    Line("measure -", 0, "Blue (standard input): six angles", "", stdin="blue.cxf"),
    Line(f"render blue -o - {SMALL}", 0, "\x89PNG", "standard output: 16×12"),
    Line(
        "render blue -o a.png --enviroment sunny",
        2,
        err="brdf-suite render: there is no option --enviroment; did you mean --environment?\n"
        "usage: brdf-suite render PAINT -o FILE [OPTION...]\n",
    ),
    Line(
        "render blu -o a.png",
        1,
        err="brdf-suite: blu: there is no such file, nor a shipped paint of that name; did you mean blue?\n",
    ),
    Line(
        "rendr blue",
        2,
        err="brdf-suite: there is no command 'rendr'; did you mean render?\n"
        "usage: brdf-suite COMMAND ... [OPTION...]\n",
    ),
    Line(
        "render blue",
        2,
        err="brdf-suite render: the following arguments are required: -o/--output\n"
        "usage: brdf-suite render PAINT -o FILE [OPTION...]\n",
    ),
    Line("list", 0, "environments:\n"),
    Line("paints", 2, err="there is no command 'paints'; did you mean list paints?"),
    Line("help render", 0, "usage: brdf-suite render PAINT -o FILE"),
    Line("measure blue -v", 0, "Blue: six", "brdf_suite: brdf-suite measure: "),
    Line("export blue -o a.csv --quiet", 0, made="a.csv"),
    Line(
        "open --help",
        0,
        "usage: brdf-suite open [PAINT] [OPTION...]\n\nOpen Designer and Viewer beside each other",
    ),
    Line("compare blue copper --csv", 0, "geometry,2000,76,cmc21,cmc11,cam02ucs,passes\n45as-15,"),
    Line("sheet blue copper -o s.png --form chips --size 16x12", 0, "s.png: 2 paints", made="s.png"),
    Line("export two.brdfpalette -o all.cxf", 0, "all.cxf: 2 paints, CxF3", "lost: ", made="all.cxf"),
    Line("palette convert blue x.ase", 0, "x.ase: 1 entries", "lost: 1 paint is written", made="x.ase"),
    Line("export blue -o a.cxf --format cxf3", 0, "CxF3", "lost: ", made="a.cxf"),
    Line("export blue -o a.mtlx --format mtlx", 0, "MaterialX, OpenPBR", "lost: ", made="a.mtlx"),
    Line("export blue -o b.mtlx --format materialx", 0, "MaterialX, OpenPBR", "lost: ", made="b.mtlx"),
    Line("export blue --list-losses --format bsdf", 0, "(rgl, .bsdf)"),
    Line("convert blue blue.merl", 0, "blue.merl: merl", "note: tabulated", made="blue.merl"),
    Line("judge blue copper", 0, "Copper against Blue: not judged", "no --tolerance is given"),
    Line(f"render blue -o a.jpg {SMALL}", 1, err="a.jpg: pictures are written as PNG or EXR"),
    Line("environment lights booth --image rings.png", 2, err="there is no option --image"),
)
"""What surprised in a trial of the command, but for what is tried in processes of their own below."""

LINES = (
    Line("--version", 0, "brdf-suite "),
    Line("render --version", 0, "brdf-suite "),
    Line("palette convert --version", 0, "brdf-suite "),
    Line("help", 0, "environment variables:"),
    Line("help palette convert", 0, "usage: brdf-suite palette convert PAINT|PALETTE... -o FILE"),
    Line("help rendr", 2, err="did you mean render?"),
    Line("rendr --help", 2, err="did you mean render?"),
    Line("-x", 2, err="brdf-suite: there is no option -x\nusage: brdf-suite COMMAND"),
    Line("--verson", 2, err="did you mean --version?"),
    Line("ls", 2, err="did you mean list?"),
    Line("view blue", 2, err="did you mean viewer?"),
    Line("palette", 2, err="brdf-suite palette: the following arguments are required: convert|info|find"),
    Line("palette inf x.ase", 2, err="brdf-suite palette: there is no command 'inf'; did you mean info?"),
    Line("cache inf", 2, err="did you mean info?"),
    Line("environment sunny", 2, err="brdf-suite environment: there is no command 'sunny'"),
    Line("design strt blue", 2, err="did you mean start?"),
    Line("list paints", 0, "fine_silver"),
    Line("list paints --csv", 0, "kind,name,title\npaints,blue,Blue\n"),
    Line("list environments", 0, "photo_studio"),
    Line("list surfaces --json", 0, '"name": "speed_form"'),
    Line("list formats", 0, "openpbr        paints"),
    Line("list models", 0, "Aspecular paint"),
    Line("list geometries --csv", 0, "geometries,e2194,"),
    Line("list paint", 2, err="did you mean paints?"),
    Line("list --json --csv", 2, err="--csv: not allowed with argument --json"),
    Line("measure blue -q -v", 2, err="not allowed with argument"),
    Line("-q measure blue", 0, "Blue: six angles"),
    Line("measure two.cxf --csv", 0, "Copper,two.cxf#2,"),
    Line("measure two.brdfpalette --json", 0, '"paints": ['),
    Line("measure blue copper --json --csv", 2, err="not allowed with argument --json"),
    Line("measure - --csv", 0, "\nBlue,standard input,", "", stdin="blue.brdfpaint"),
    Line("measure - --json", 0, '"name": "Blue"', "", stdin="blue.brdfpaint"),
    Line("measure -", 1, err="brdf-suite: standard input, at byte 0: is empty.", stdin="empty"),
    Line("measure -", 1, err="brdf-suite: standard input, at line 1", stdin="broken.brdfpaint"),
    Line("measure blue --geometry sixx", 1, err="sixx"),
    Line("measure nowhere.cxf", 1, err="brdf-suite: nowhere.cxf: there is no such file."),
    Line("measure zzzzzz", 1, err="`brdf-suite list paints` names all"),
    Line("check blue.cxf", 0, "Blue: held"),
    Line("check blu", 1, err="did you mean blue?"),
    Line("check blue --csv", 0, "name,check,violation,outcome,unit,where\n"),
    Line("fit blue.cxf", 0, "Blue: 11 lobes"),
    Line("fit - --csv", 0, "exponent,kdd_r,", "", stdin="blue.cxf"),
    Line("fit blue --lobe-count 99", 2, err="'99' is not a whole number from 1 to 12"),
    Line("fit blue --basis no.json", 1, err="no.json: cannot be read"),
    Line("compare blue.cxf copper", 0, "Copper against Blue"),
    Line("compare - -", 2, err="brdf-suite compare: standard input (-) can be read once", stdin="blue.cxf"),
    Line("compare blue", 2, err="required: SAMPLE-PAINT"),
    Line("compare blue copper --tolerance 1", 1, "FAIL"),
    Line("judge blue.cxf two.cxf --tolerance 1 --csv", 1, "batch,angle,difference,"),
    Line("judge blue - --tolerance 1", 0, "against Blue: pass", "", stdin="blue.cxf"),
    Line("judge blue copper --name Blu", 1, err="holds no standard called 'Blu'; did you mean Blue?"),
    Line("judge blue copper --tolerance x", 2, err="'x' is not a tolerance"),
    Line("design step blue.cxf lighter -o step.brdfpaint", 0, "step.brdfpaint: Blue", made="step.brdfpaint"),
    Line("design step blue lighter -o -", 0, '"format": "brdfpaint"', "standard output: Blue"),
    Line("design step blue lightr", 2, err="did you mean lighter?"),
    Line("design step blue lighter --stp 1", 2, err="brdf-suite design step: there is no option --stp"),
    Line("export blue -o -", 2, err="with -o - give --format too"),
    Line("export blue", 2, err="-o FILE is missing; --list-losses writes nothing"),
    Line("export blue -o a.csv --format bsd", 2, err="did you mean bsdf?"),
    Line("export blue -o a.xyz", 1, err="the ending .xyz names no format"),
    Line("export two.cxf -o - --format cxf3 -q", 0, "<?xml"),
    Line("export two.cxf -o - --format csv --json", 2, err="leave --json and --follow out"),
    Line("export - -o b.csv", 0, "b.csv: Blue, CSV", "", stdin="blue.brdfpaint", made="b.csv"),
    Line("convert blue", 2, err="the following arguments are required: -o/--output"),
    Line("convert blue -o b.astm", 0, "b.astm: astm", "note: ", made="b.astm"),
    Line("convert blue -o - --format astm", 0, "", "standard output: astm"),
    Line("convert blue red copper.astm", 2, err="one file holds one material"),
    Line("convert blue -o b.xyz", 1, err=".merl"),
    Line("convert blue -o b.astm --format ast", 2, err="did you mean astm?"),
    Line("palette convert blue copper -o p.gpl", 0, "p.gpl: 2 entries", "lost: ", made="p.gpl"),
    Line("palette convert - -o q.gpl", 0, "q.gpl: 2 entries", "lost: ", stdin="two.cxf", made="q.gpl"),
    Line("palette convert two.cxf --list-losses --format ase", 0, "Adobe Swatch", "lost: "),
    Line("palette convert two.cxf", 2, err="required: -o/--output"),
    Line("palette info two.cxf --csv", 0, "name,kind,code,"),
    Line("palette info blue", 0, "blue: Blue"),
    Line("palette find copper --in two.cxf --csv", 0, "\nCopper,2,"),
    Line("palette find copper --in -", 0, "Copper: nearest of 2", "", stdin="two.cxf"),
    Line("palette find coper --in two.cxf", 1, err="did you mean copper?"),
    Line(f"render blue.cxf -o r.png {SMALL}", 0, "r.png: 16×12", made="r.png"),
    Line(f"render blue -o r.png --follow {SMALL} --view -", 2, err="--follow reads standard input"),
    Line("render blue -o r.png --size big", 2, err="write WIDTHxHEIGHT in pixels"),
    Line("render blue -o r.png --tone neutrl", 2, err="did you mean neutral?"),
    Line(
        "render blue -o r.png --environment bouth",
        1,
        err="shipped environment of that name; did you mean booth?",
    ),
    Line("render blue -o r.png --mesh spher", 1, err="shipped surface of that name; did you mean sphere?"),
    Line("render blue copper -o r.png", 2, err="'copper' is one argument too many"),
    Line("render blue -o r.png --renderer real", 2, err="did you mean realtime?"),
    Line("turntable blue -o -", 2, err="-o - is not supported here; name a file"),
    Line("sheet two.cxf -o - --form chips --size 16x12", 0, "\x89PNG", "standard output: 2 paints"),
    Line("factorize blue -o -", 2, err="-o - is not supported here"),
    Line("environment lights booth -n 2 --csv", 0, "elevation_deg,azimuth_deg,"),
    Line("environment info both", 1, err="did you mean booth?"),
    Line("environment sky -o - --model overcast", 0, '"format": "brdfstudio"', "standard output: written"),
    Line("environment sky -o sky.brdfstudio --json", 0, '"output": "sky.brdfstudio"', made="sky.brdfstudio"),
    Line("environment studio new.brdfstudio --new --json", 0, '"output": "new', made="new.brdfstudio"),
    Line("project list mine.brdfproject --csv", 0, "kind,name\npaint,Blue\n"),
    Line(
        "fit-cook-torrance table1_white --lobes 1 --starts 1 --samples 300 --csv",
        0,
        "lobe,red,red_error,green,green_error,blue,blue_error,m,m_error,r,r_error\n0,",
    ),
    Line("environment sky -o sky.txt", 1, err="sky.txt: must end in .brdfstudio or .exr"),
    Line("environment studio new.brdfstudio", 1, err="Nothing to do: give --new"),
    Line("project pack --paint blue -o new.brdfproject", 0, "new.brdfproject: new", made="new.brdfproject"),
    Line("project pack mine.brdfproject --paint blue", 2, err="required: -o/--output"),
    Line("project list nothing.brdfproject", 1, err="nothing.brdfproject"),
    Line("cache info --csv", 0),
    Line("bench nothing", 1, err="There is no benchmark 'nothing'"),
    Line("completion ksh", 2, err="'ksh' is none of bash, zsh, fish, man"),
    Line("completion bash", 0, "complete -o default -F _brdf_suite brdf-suite\n"),
    Line("completion zsh", 0, "bashcompinit"),
    Line("completion fish", 0, "complete -c brdf-suite -n '__fish_seen_subcommand_from palette; and "),
    Line("completion man -o brdf-suite.1", 0, made="brdf-suite.1"),
    Line("completion man", 0, '.TH "BRDF\\-SUITE" 1 '),
    Line("list schemas", 0, "brdfstudio"),
    Line("list variables", 0, "BRDF_SUITE_CACHE_MB"),
    Line("schemas", 2, err="did you mean list schemas?"),
)


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a paint, a palette and CxF3 of them, and broken files."""
    folder = tmp_path_factory.mktemp("prepared")
    paints = CHECKOUT / "resources" / "paints"
    shutil.copy(paints / "blue.brdfpaint", folder)
    (folder / "empty").write_bytes(b"")
    (folder / "broken.brdfpaint").write_text('{"format": "brdfpaint", "version": 1,')
    for line in (
        "export blue -o {}/blue.cxf",
        "export blue copper -o {}/two.cxf",
        "palette convert blue copper -o {}/two.brdfpalette",
        "project pack --paint blue -o {}/mine.brdfproject",
    ):
        assert main([*shlex.split(line.format(folder)), "-q"]) == 0
    return folder


@pytest.fixture
def folder(prepared: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder of a test, without a screen."""
    for file in prepared.iterdir():
        shutil.copy(file, tmp_path)
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


Run = Callable[[str, str | None], tuple[int, str, str]]


@pytest.fixture
def run(capfdbinary: pytest.CaptureFixture[bytes], monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run a command line in this process; return its status, and what it wrote to both streams."""

    def one(line: str, stdin: str | None = None) -> tuple[int, str, str]:
        content = b"" if stdin is None else Path(stdin).read_bytes()
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content)))
        try:
            status = main(shlex.split(line))
        except SystemExit as end:  # after --help, and for wrong arguments
            status = int(str(end.code or 0))
        out, err = capfdbinary.readouterr()
        encoding = "latin-1" if out.startswith(b"\x89") else "utf-8-sig"
        return status, out.decode(encoding), _STAGE.sub("", err.decode())

    return one


@pytest.mark.parametrize("line", [*TRIAL, *LINES], ids=lambda line: line.words)
def test_a_command_line_does_what_people_expect(line: Line, run: Run, folder: Path) -> None:
    status, out, err = run(line.words, line.stdin)
    assert status == line.status, err
    assert line.out in out
    assert line.err in err
    assert not (err and not line.err), err
    assert not (status and out and not line.out), out
    assert line.made is None or (folder / line.made).stat().st_size > 0
    assert not (folder / "-").exists()


CXF = {
    "measure": "measure blue.cxf",
    "check": "check blue.cxf",
    "fit": "fit blue.cxf",
    "compare": "compare blue.cxf copper",
    "judge": "judge blue.cxf blue.cxf --tolerance 1",
    "design start": "design start blue.cxf -o start.brdfpaint",
    "design step": "design step blue.cxf lighter",
    "design between": "design between blue.cxf copper -o middle.brdfpaint",
    "design flakes": "design flakes blue.cxf --graininess 3 -o flakes.brdfpaint",
    "render": f"render blue.cxf -o r.png {SMALL}",
    "turntable": f"turntable blue.cxf -o frames --frames 2 {SMALL}",
    "sheet": "sheet blue.cxf -o s.png --form chips --size 16x12",
    "convert": "convert blue.cxf -o b.astm",
    "export": "export blue.cxf -o e.csv",
    "project pack": "project pack --paint blue.cxf -o p.brdfproject",
    "palette convert": "palette convert blue.cxf -o p.gpl",
    "palette info": "palette info blue.cxf",
    "palette find": "palette find blue.cxf --in two.cxf",
    "fit-cook-torrance": "fit-cook-torrance blue.cxf --lobes 1 --starts 1 --samples 300",
    "factorize": "factorize blue.cxf -o f.brdftable --resolution 8 --pairs 500",
    "acquire": "acquire session --simulate blue.cxf --positions 2 --exposures 2 --size 32x32",
}
"""A command line with a paint in CxF3, of each command that reads a paint."""
_NOT_TRIED = {"open", "represent", "agreement"}  # windows, and what takes minutes; they read as the others do
_BATCHES = {f"batch {step}" for step in ("measure", "fit", "render", "factorize", "export")}
"""They read as the others do, in processes of their own: tests/batches."""


@pytest.mark.usefixtures("shared_cache")
@pytest.mark.parametrize("words", CXF.values(), ids=CXF)
def test_cxf3_is_read_by_every_command_that_reads_a_paint(words: str, run: Run, folder: Path) -> None:
    status, _, err = run(words, None)
    assert status == 0, err


def test_cxf3_is_tried_with_every_command_that_reads_a_paint() -> None:
    reading = {
        " ".join(path[1:])
        for path, one in parsers(parser(COMMANDS))
        if any("PAINT" in str(action.metavar) for action in one._actions)
    }
    assert reading == set(CXF) | _NOT_TRIED | _BATCHES


def test_there_are_as_many_lines_as_wanted() -> None:
    assert len({(line.words, line.stdin) for line in LINES}) >= 60


def test_only_the_file_is_on_standard_output(run: Run, folder: Path) -> None:
    run("export two.cxf -o named.csv", None)
    _, out, _ = run("export two.cxf -o - --format csv", None)
    assert out == (folder / "named.csv").read_bytes().decode("utf-8-sig")


def leaves() -> Iterator[CommandParser]:
    """Yield the parsers of all commands that are written here; the programs have their own."""
    for path, one in parsers(parser(COMMANDS)):
        if path[1:] not in {("designer",), ("viewer",), ("lobes",), ("swatch",), ("help",)}:
            yield one


@pytest.mark.parametrize("one", [*leaves()], ids=lambda one: one.prog)
def test_every_help_has_a_usage_of_one_line_groups_and_examples_that_parse(one: CommandParser) -> None:
    text = one.format_help()
    assert text.splitlines()[0].startswith(f"usage: {one.prog}")
    assert text.splitlines()[1] == ""
    for word in ("--quiet", "--verbose", "--version", "general:", "examples:"):
        assert word in text
    assert one.examples
    for example in one.examples:
        plain = re.sub(r"^cat \S+ \| |\s+(>|>>|#) .*$", "", example)
        words = shlex.split(plain)
        assert words[:1] == ["brdf-suite"]
        if "help" not in plain and len(words) > 1:
            found = parser(COMMANDS).parse_args(words[1:])
            assert hasattr(found, "run"), example
            if not one.has_commands:
                assert found.parser.prog == one.prog


def test_render_sorts_its_options_into_groups() -> None:
    (render,) = (one for one in leaves() if one.prog == "brdf-suite render")
    text = render.format_help()
    for title in ("light", "object and camera", "picture", "lens", "file", "renderer", "lobes"):
        assert f"\n{title}:\n" in text


def test_every_environment_variable_is_declared_in_one_place_and_in_the_help(run: Run) -> None:
    sources = {
        file: file.read_text(encoding="utf-8")
        for folder in ("brdf_suite", "apps")
        for file in (CHECKOUT / folder).rglob("*.py")
    }
    declared = CHECKOUT / "brdf_suite" / "variables.py"
    named = {file: set(re.findall(r"[\"'](BRDF_SUITE_[A-Z_]+)[\"']", text)) for file, text in sources.items()}
    assert named.pop(declared) == {name for name in VARIABLES if name.startswith("BRDF_SUITE_")}
    assert {file.name: names for file, names in named.items() if names} == {}
    others = [
        *sources.values(),
        *(file.read_text() for file in (CHECKOUT / "tests" / "benchmarks").rglob("*.py")),
    ]
    for constant in ("CACHE", "CACHE_MB", "LINK", "REFERENCE_KEEP", "SETTINGS"):
        assert any(f"variables.{constant}" in text for text in others), f"{constant} is read nowhere"
    # What is read by a text in place of a declared name belongs to the system, and to no user.
    read = {name for text in sources.values() for name in re.findall(r"environ(?:\.get\(|\[)\"(\w+)\"", text)}
    assert read <= {"DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR", "QT_QPA_PLATFORM"}
    text = parser().format_help()
    assert [name for name in VARIABLES if name not in text] == []


def test_the_variables_are_listed_with_what_they_are_set_to(run: Run, folder: Path) -> None:
    _, out, _ = run("list variables --csv", None)
    assert f"variables,BRDF_SUITE_CACHE,{folder / 'cache'}," in out


def test_the_schemas_are_listed_with_their_files(run: Run, folder: Path) -> None:
    _, out, _ = run("list schemas --json", None)
    rows = json.loads(out)["schemas"]
    assert {"brdfpaint", "brdfpalette", "brdfview", "brdfstudio", "brdfproject"} <= {
        row["name"] for row in rows
    }
    assert all(json.loads(Path(row["file"]).read_text(encoding="utf-8"))["$schema"] for row in rows)


@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")
@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        (["brdf-suite", "ren"], {"render"}),
        (["brdf-suite", "palette", ""], {"convert", "info", "find"}),
        (["brdf-suite", "render", "--envi"], {"--environment"}),
        (["brdf-suite", "render", "--tone", "ne"], {"neutral"}),
        (["brdf-suite", "palette", "convert", "--thr"], {"--three-angles"}),
    ],
)
def test_bash_completes(typed: list[str], expected: set[str], run: Run, folder: Path) -> None:
    _, script, _ = run("completion bash", None)
    words = f"COMP_WORDS=({shlex.join(typed)}); COMP_CWORD={len(typed) - 1}"
    ask = f"{script}\n{words}; _brdf_suite; printf '%s\\n' \"${{COMPREPLY[@]}}\""
    done = subprocess.run(["bash", "-c", ask], capture_output=True, text=True, check=True, timeout=120)
    assert expected <= set(done.stdout.split())
    assert len(done.stdout.split()) < 12


def test_every_command_has_a_page_of_the_manual_with_every_option(run: Run, folder: Path) -> None:
    _, out, _ = run("completion man -o pages", None)
    pages = {path.stem: path.read_text(encoding="ascii") for path in (folder / "pages").iterdir()}
    assert out == f"pages: {len(pages)} pages\n"
    assert set(pages) == {
        "-".join(path) for path, _ in parsers(parser(COMMANDS)) if path[1:] != ("help",)
    }  # those of the programs, too
    for one in leaves():
        page = pages[one.prog.replace(" ", "-")]
        shown = [action for action in one._actions if action.help != "==SUPPRESS=="]
        for flag in (flag for action in shown for flag in action.option_strings):
            assert flag.replace("-", "\\-") in page, (one.prog, flag)
        for section in ("NAME", "SYNOPSIS", "GENERAL", "EXAMPLES", "SEE ALSO"):
            assert f".SH {section}\n" in page or f'.SH "{section}"\n' in page
    assert "\\-\\-theme" in pages["brdf-suite-designer"]
    assert "BRDF_SUITE_CACHE" in pages["brdf-suite"]
    if shutil.which("groff") is not None:
        files = sorted(map(str, (folder / "pages").iterdir()))
        done = subprocess.run(
            ["groff", "-man", "-ww", "-z", *files], capture_output=True, text=True, check=True
        )
        assert done.stderr == ""


def test_one_page_of_the_manual_is_written_by_its_name(run: Run, folder: Path) -> None:
    assert run("completion man -o brdf-suite-palette-find.1", None)[0] == 0
    page = (folder / "brdf-suite-palette-find.1").read_text(encoding="ascii")
    assert page.startswith('.TH "BRDF\\-SUITE\\-PALETTE\\-FIND" 1')
    status, _, err = run("completion man -o brdf-suite-rendr.1", None)
    assert (status, "did you mean brdf-suite-render?" in err) == (1, True)


def test_the_bench_is_hidden_where_there_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    code = (
        "import pathlib\n"
        "pathlib.Path.is_dir = lambda self: False\n"
        "from brdf_suite.cli.main import COMMANDS\n"
        "print('bench' in COMMANDS)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


@pytest.mark.usefixtures("shared_cache")
@pytest.mark.parametrize(
    ("line", "status", "out", "err"),
    [
        ("cat blue.cxf | {0} measure - --csv | head -n 1", 0, "name,source,", ""),
        ("{0} export blue -o - --format csv -q > a.csv; wc -l < a.csv", 0, "2", ""),
        ("{0} export blue -o a.gpl --format csv >/dev/null", 0, "", ""),
        ("{0} list paints | head -n 1", 0, "blue", ""),
        ("QT_QPA_PLATFORM=offscreen {0} designer --version", 0, "brdf-suite ", ""),
        (
            "QT_QPA_PLATFORM=offscreen {0} viewer --enviroment booth",
            2,
            "",
            "did you mean --environment?\nusage: brdf-viewer",
        ),
        ("{0} measure blue --verbose > /dev/null", 0, "", "brdf_suite: brdf-suite measure: "),
    ],
)
def test_in_a_shell(line: str, status: int, out: str, err: str, folder: Path) -> None:
    command = f"{shlex.quote(sys.executable)} -m brdf_suite"
    done = subprocess.run(
        ["bash", "-c", line.format(command)],
        capture_output=True,
        text=True,
        check=False,
        timeout=240,
        env={**os.environ, "BRDF_SUITE_SETTINGS": str(folder)},
    )
    assert done.returncode == status, done.stderr
    assert out in done.stdout
    assert err in done.stderr


def test_a_missing_extra_is_named_in_one_line(
    monkeypatch: pytest.MonkeyPatch, run: Run, folder: Path
) -> None:
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    assert "mitsuba" in PACKAGES
    status, out, err = run(f"render blue -o c.png --renderer reference {SMALL}", None)
    assert (status, out) == (1, "")
    assert len(err.splitlines()) == 1, err
    assert "needs Mitsuba" in err


_LONG = "x" * 300
"""A name that no file system takes."""


@pytest.mark.parametrize(
    "words",
    [
        f"turntable blue -o {_LONG}",
        f"convert blue -o {_LONG}.astm",
        f"project list {_LONG}",
        f"project collect {_LONG} -o out",
        f"project unpack {_LONG} -o out",
        f"acquire {_LONG} -o out.astm",
        f"fit-cook-torrance blue -o out.brdfpaint --state {_LONG}",
        f"basis --database {_LONG} -o out.json",
        f"basis --database {_LONG}/x -o out.json",
        f"basis -o {_LONG}",
        f"sheet {_LONG} -o out.png",
    ],
)
def test_a_name_that_no_file_system_takes_is_reported_in_one_line(run: Run, folder: Path, words: str) -> None:
    """Whether such a file is there cannot be asked: the question itself is an error."""
    status, _out, err = run(words, None)
    assert status == 1
    (line,) = [line for line in err.splitlines() if not line.endswith(STAGE_END)]
    assert line.startswith("brdf-suite: ")
    assert _LONG in line
