"""Every command without optional packages: what needs one says so in a line, all else works."""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from brdf_suite.cli.main import COMMANDS, parser
from brdf_suite.cli.output import STAGE_END
from brdf_suite.extras import PACKAGES

WALK = Path(__file__).with_name("walk_commands.py")
SMALL = ("--mesh", "sphere", "--size", "16x16", "--environment", "light.exr")

WORKING = (
    *(f"{program} --help" for program in ("open", "designer", "viewer", "lobes", "swatch")),
    "environment sky -o sky.exr",
    "environment studio new.brdfstudio --new",
    "environment info light.exr",
    "environment lights light.exr -n 2",
    "prefilter light.exr",
    "render blue -o blue.png {small}",
    "turntable blue -o turning --frames 2 {small}",
    "sheet list.gpl -o sheet.png {small}",
    "measure blue",
    "compare blue copper",
    "judge blue copper",
    "design start blue -o start.brdfpaint",
    "design step blue lighter -o step.brdfpaint",
    "design between blue copper -o between.brdfpaint",
    "design flakes blue --graininess 2 -o flaked.brdfpaint",
    "convert blue blue.astm",
    "export blue -o blue.csv",
    "palette convert list.gpl list.brdfpalette",
    "palette info list.gpl",
    "thumbnail list.gpl -o list.png --size 32",
    "palette find blue --in list.gpl",
    "project pack -o mine.brdfproject --paint blue",
    "project list mine.brdfproject",
    "project collect mine.brdfproject -o whole.brdfproject",
    "project unpack mine.brdfproject -o unpacked",
    "check blue",
    "fit blue",
    "fit-cook-torrance blue.astm -o fitted.brdfpaint --lobes 1 --starts 1 --samples 200",
    "factorize blue -o factored.brdfpaint --resolution 8 --pairs 500",
    "represent blue",
    "basis -o basis.json --database nowhere",
    "shading-table --help",
    "cache info",
    "cache verify",
    "bench --list",
    "list",
    "completion bash",
    "help render",
)
"""Commands that need nothing optional; what they answer is a matter of other tests."""

NEEDY = {
    "render blue --renderer reference -o a.png {small}": "Mitsuba",
    "render blue --renderer reference --denoise -o a.exr {small}": "Mitsuba",
    "render blue --renderer raytraced -o a.png {small}": "Mitsuba",
    "turntable blue --renderer reference -o traced {small}": "Mitsuba",
    "turntable blue --renderer raytraced -o traced {small}": "Mitsuba",
    "agreement --paints blue --environments light.exr --size 16x16": "FLIP",
    "turntable blue -o a.mp4 {small}": "ffmpeg",
    "turntable blue --renderer raytraced -o a.webm {small}": "ffmpeg",
    "acquire session -o a.brdftable": "numba",
    **{
        f"batch {step} blue -o batched": "Dask"
        for step in ("measure", "fit", "render {small}", "factorize", "export")
    },
    "batch prefilter light.exr -o batch_light": "Dask",
}
"""What stops at a missing package, and which."""


def commands(of: argparse.ArgumentParser, path: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Yield the words of every command and sub-command."""
    below = [action for action in of._actions if isinstance(action, argparse._SubParsersAction)]
    if not below:
        yield path
    for action in below:
        for name, one in action.choices.items():
            yield from commands(one, (*path, name))


def words(command: str) -> list[str]:
    return command.format(small=" ".join(SMALL)).split()


def walk(them: list[list[str]], folder: Path, environment: dict[str, str]) -> list[dict[str, object]]:
    answers = folder / "answers.jsonl"
    done = subprocess.run(
        [sys.executable, str(WALK), str(answers)],
        input=json.dumps(them),
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return [json.loads(line) for line in answers.read_text().splitlines()]


def test_no_command_ends_with_a_traceback(folder: Path, without_extras: dict[str, str]) -> None:
    every = [*WORKING, *NEEDY, "cache clear"]
    tried = [words(command) for command in every]
    untried = [
        path for path in commands(parser(COMMANDS)) if all(tuple(t[: len(path)]) != path for t in tried)
    ]
    assert untried == []
    answers = dict(zip(every, walk(tried, folder, without_extras), strict=True))
    for command, answer in answers.items():
        assert answer["status"] in (0, 1, 2), (command, answer)
        assert "Traceback" not in str(answer["errors"]), (command, answer)
    for command, package in NEEDY.items():
        lines = str(answers[command]["errors"]).splitlines()
        (line,) = (line for line in lines if not line.endswith(STAGE_END))
        assert answers[command]["status"] == 1
        assert f"needs {package}" in line
        assert "which is not installed; `" in line
        assert "` installs it" in line


def test_photographs_name_what_reads_them(folder: Path, without_extras: dict[str, str]) -> None:
    """Raw photographs want rawpy, and the photographs of a board OpenCV."""
    shutil.copytree(folder / "session", folder / "raw")
    described = folder / "raw" / "session.json"
    place = folder / "raw" / "light_0000"
    first = min(file.name for file in place.iterdir())
    (place / "a.nef").write_bytes(b"II*\0" + bytes(100))
    described.write_text(described.read_text().replace(f"light_0000/{first}", "light_0000/a.nef"))
    # PNG photographs are read by compiled kernels.
    with_kernels = {**without_extras, "BRDF_SUITE_TEST_KEPT": "numba"}
    both = [words("acquire raw --check --json"), words("acquire session -o a.brdftable")]
    raw, board = walk(both, folder, with_kernels)
    (finding,) = json.loads(str(raw["output"]))["findings"]
    assert Path(finding["path"]).name == "a.nef"
    assert "needs rawpy, which is not installed; `" in finding["reason"]
    assert board["status"] == 1
    assert "needs OpenCV, which is not installed; `" in str(board["errors"])


def test_what_is_blocked_is_all_that_is_optional(without_extras: dict[str, str]) -> None:
    code = """
import sys
for name in sys.argv[1:]:
    try:
        __import__(name)
    except ModuleNotFoundError as error:
        assert error.name == name
        print(name)
"""
    done = subprocess.run(
        [sys.executable, "-c", code, *PACKAGES],
        env=without_extras,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.split() == list(PACKAGES)
