"""The command as a user runs it: real processes, real files, real pictures."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.cli.main import main
from brdf_suite.cli.output import STAGE_END
from brdf_suite.files.images.environments import write_exr
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import Material
from brdf_suite.realtime.environment import textures

ENVIRONMENTS = (
    "autoshop_01_1k.hdr",
    "interior.exr",
    "kiara_1_dawn_1k.hdr",
    "studio.exr",
    "sunset.exr",
    "warehouse.exr",
)
# What of the light they take from themselves is no matter of the picture's test, and takes seconds on large ones.
MESHES = {
    "CesiumMilkTruck.glb": ["--no-occlusion"],
    "materialx_shaderball.glb": ["--no-occlusion"],
    "spot.obj": [],
    "teapot.obj": ["--no-occlusion"],
}


pytestmark = pytest.mark.usefixtures("shared_cache")


@pytest.fixture
def command(tmp_path: Path):
    """Run ``brdf-suite`` in an empty folder without a screen."""

    def run(*arguments: object, timeout: float = 280.0) -> subprocess.CompletedProcess[str]:
        clean = {
            k: v for k, v in os.environ.items() if k not in {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}
        }
        return subprocess.run(
            [sys.executable, "-m", "brdf_suite", *map(str, arguments)],
            cwd=tmp_path,
            env=clean,
            capture_output=True,
            text=True,
            timeout=timeout,
            check=False,
        )

    return run


@pytest.fixture
def inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Run ``brdf-suite`` as ``command`` does but in this process: a new one imports for more than a second.

    Mip levels are not made: drawn in software they take longer than the small pictures that they would smooth.
    """
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(textures, "MIPMAPPED_FROM", 4096)
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> subprocess.CompletedProcess[str]:
        words = [str(argument) for argument in arguments]
        try:
            status = main(words)
        except SystemExit as end:  # after --help, and for wrong arguments
            status = end.code
        return subprocess.CompletedProcess(words, status, *capsys.readouterr())

    return run


def picture(path: Path) -> np.ndarray:
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB"))


def refused(done: subprocess.CompletedProcess[str], *words: str) -> None:
    """One line on standard error, beside those of stages, that holds the words; never a traceback."""
    assert done.returncode == 1, done.stderr
    lines = [line for line in done.stderr.strip().splitlines() if not line.endswith(STAGE_END)]
    assert len(lines) == 1, done.stderr
    assert lines[0].startswith("brdf-suite: ")
    for word in words:
        assert word in lines[0], lines[0]


def test_without_a_screen_the_default_scene_is_rendered(command, tmp_path: Path) -> None:
    done = command()
    assert done.returncode == 0, done.stderr
    assert "no screen" in done.stderr
    pixels = picture(tmp_path / "brdf-suite.png")
    assert pixels.shape == (720, 1280, 3)
    assert pixels.std() > 20
    assert [p.name for p in tmp_path.iterdir() if p.suffix == ".png"] == ["brdf-suite.png"]


def test_help_explains_units_and_exit_statuses(inside) -> None:
    done = inside("--help")
    assert done.returncode == 0
    for word in ("D65", "gloss units", "EV", "degrees", "exit status"):
        assert word in done.stdout


def test_wrong_arguments_exit_with_two(inside) -> None:
    done = inside("render", "blue", "-o", "a.png", "--size", "big")
    assert done.returncode == 2
    assert "WIDTHxHEIGHT" in done.stderr


def test_fit_prints_weights_errors_and_time(inside) -> None:
    done = inside("fit", "fine_silver", "--json")
    assert done.returncode == 0, done.stderr
    facts = json.loads(done.stdout)
    count = len(facts["exponents"])
    assert np.shape(facts["kdd"]) == np.shape(facts["kg"]) == (count, 3)
    assert min(np.min(facts["kd"]), np.min(facts["kdd"]), np.min(facts["kg"])) >= 0
    assert [row["aspecular_deg"] for row in facts["angles"]] == [15, 45, 110]
    assert facts["delta_e_2000_worst"] < 0.5
    assert facts["ms"] > 0
    assert facts["time_limited"] is False


def test_fit_as_text_names_every_lobe(inside) -> None:
    facts = json.loads(inside("fit", "blue", "--json").stdout)
    done = inside("fit", "blue")
    assert done.returncode == 0, done.stderr
    for exponent in facts["exponents"]:
        assert f"{exponent:,.1f}" in done.stdout


@pytest.mark.parametrize("name", ENVIRONMENTS)
def test_every_shared_environment_renders(inside, shared_data: Path, tmp_path: Path, name: str) -> None:
    path = shared_data / "environments" / name
    done = inside("render", "solid_red", "-o", "out.png", "--environment", path, "--size", "160x90", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["width"] == 160
    assert picture(tmp_path / "out.png").std() > 8


@pytest.mark.parametrize("name", MESHES)
def test_every_readable_shared_mesh_renders(inside, shared_data: Path, tmp_path: Path, name: str) -> None:
    path = shared_data / "meshes" / name
    done = inside("render", "solid_red", "-o", "out.png", "--mesh", path, "--size", "160x90", *MESHES[name])
    assert done.returncode == 0, done.stderr
    pixels = picture(tmp_path / "out.png").astype(float)
    # Red paint covers a good part of the picture, and the booth none.
    assert (pixels[..., 0] > 1.5 * pixels[..., 2] + 10).mean() > 0.02


def test_files_are_found_from_the_working_folder(inside, tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    triangle = tmp_path / "folder" / "triangle.obj"
    triangle.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    done = inside("render", "blue", "-o", "out.png", "--mesh", "folder/triangle.obj", "--size", "64x48")
    assert done.returncode == 0, done.stderr
    assert "note:" in done.stderr  # normals and texture coordinates were made, and that is reported


def test_the_unreadable_mesh_says_why(inside, tmp_path: Path) -> None:
    path = tmp_path / "crowd.gltf"
    path.write_text('{"extensionsRequired": ["EXT_mesh_gpu_instancing"]}')
    refused(inside("render", "blue", "-o", "out.png", "--mesh", path), "crowd", "EXT_mesh_gpu_instancing")


def test_shipped_surfaces_and_environments_differ(inside, tmp_path: Path) -> None:
    pictures = []
    for surface, environment in (("sphere", "booth"), ("car", "sunny"), ("panel", "overcast")):
        out = tmp_path / f"{surface}.png"
        # What of the light a surface takes from itself is no matter here, and takes most of the time of the car.
        done = inside(
            "render", "solid_red", "-o", out, "--mesh", surface, "--environment", environment, "--size", "160x90",
            "--no-occlusion",
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        pictures.append(picture(out).astype(int))
    assert all(np.abs(a - b).mean() > 3 for i, a in enumerate(pictures) for b in pictures[:i])


def test_prefilter_fills_the_cache_once(command, inside, shared_cache: Path, shared_data: Path) -> None:
    path = shared_data / "environments" / "studio.exr"
    first = json.loads(inside("prefilter", path, "--json").stdout)
    second = json.loads(command("prefilter", path, "--json").stdout)
    assert second["from_cache"] is True
    assert first["exponents"] == second["exponents"]
    assert any(p.is_file() for p in shared_cache.rglob("*"))


def test_bad_paints_are_refused_in_one_line(inside, tmp_path: Path) -> None:
    refused(inside("fit", "no_such_paint"), "no_such_paint", "brdf-suite list paints")
    refused(inside("fit", "fine_silvr"), "did you mean fine_silver?")
    broken = tmp_path / "broken.brdfpaint"
    broken.write_text('{"format": "brdfpaint", "version": 1,')
    refused(inside("fit", broken), "broken.brdfpaint", "line 1")
    done = inside("fit", "blue", "--json")
    document = json.loads((Path(__file__).parents[2] / "resources" / "paints" / "blue.brdfpaint").read_text())
    assert done.returncode == 0
    document["measurements"][1]["lab"] = [25, "four", -38]
    broken.write_text(json.dumps(document))
    refused(inside("render", broken, "-o", "out.png"), "broken.brdfpaint", "measurements[1].lab[1]")
    document["measurements"][1]["lab"] = [25, 4, -38]
    document["gloss"]["gu_20"] = 199.0
    broken.write_text(json.dumps(document))
    refused(inside("fit", broken), "brdf-suite: broken.brdfpaint: ", "199")
    refused(inside("render", broken, "-o", "out.png"), "brdf-suite: broken.brdfpaint: ", "199")


def test_names_that_no_file_system_takes_are_refused_in_one_line(inside) -> None:
    name = "x" * 300
    refused(inside("fit", name), "cannot be read")
    refused(inside("render", "blue", "-o", "out.png", "--mesh", name), "cannot be read")
    refused(inside("prefilter", name), "cannot be read")
    refused(inside("render", "blue", "-o", f"{name}/out.png"), "its folder cannot be used")


def test_a_reader_that_ends_early_gets_no_traceback() -> None:
    reader, writer = os.pipe()
    os.close(reader)  # before anything is written, so that the first write fails
    with os.fdopen(writer, "wb") as closed:
        done = subprocess.run(
            [sys.executable, "-m", "brdf_suite", "fit", "blue", "--json"],
            stdout=closed,
            stderr=subprocess.PIPE,
            text=True,
            timeout=240,
            check=False,
        )
    assert done.stderr == ""
    assert done.returncode == 1


def in_a_shell(words: str, folder: Path) -> subprocess.CompletedProcess[str]:
    line = f"exec {shlex.quote(sys.executable)} -m brdf_suite {words}"
    return subprocess.run(
        ["bash", "-c", line], cwd=folder, capture_output=True, text=True, timeout=240, check=False
    )


@pytest.mark.parametrize(
    "words", ["measure blue", "fit blue --json", "--help", "-q export blue -o - --format csv"]
)
def test_a_result_for_a_closed_output_is_reported_as_lost(words: str, tmp_path: Path) -> None:
    refused(in_a_shell(f"{words} >&-", tmp_path), "the output cannot be written", "is closed")


def test_what_prints_nothing_needs_no_output(tmp_path: Path) -> None:
    done = in_a_shell("-q export blue -o blue.csv >&-", tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "blue.csv").exists()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full, a disk that is always full")
@pytest.mark.parametrize("arguments", [["fit", "blue"], ["fit", "blue", "--json"], ["--help"]])
def test_output_that_cannot_be_written_is_reported_in_one_line(arguments: list[str]) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "brdf_suite", *arguments],
            env={k: v for k, v in os.environ.items() if k != "PYTHONUNBUFFERED"},
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            timeout=240,
            check=False,
        )
    refused(done, "the output cannot be written", "No space left")


def test_no_command_has_its_help_below_its_name(inside, monkeypatch) -> None:
    for columns in (80, 120):
        monkeypatch.setenv("COLUMNS", str(columns))
        lines = inside("--help").stdout.splitlines()
        for name in ("open", "designer", "viewer", "render", "fit", "prefilter", "bench"):
            row = next(i for i, line in enumerate(lines) if line.split()[:1] == [name])
            assert len(lines[row].split()) > 2, lines[row]
            assert not lines[row + 1].startswith(" " * 12), lines[row + 1]


def test_shipped_names_are_taken_in_any_letter_case(inside, tmp_path: Path) -> None:
    done = inside(
        "render", "Solid_Red", "-o", "out.png", "--mesh", "Sphere", "--environment", "BOOTH",
        "--size", "64x48", "--json",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    facts = json.loads(done.stdout)
    assert (facts["environment"], facts["surface"]) == ("booth", "sphere")


def test_missing_files_are_named_as_they_were_typed(inside) -> None:
    for option, name in (
        ("--environment", "both"),
        ("--environment", "no/such.exr"),
        ("--mesh", "spere"),
        ("--mesh", "no.obj"),
    ):
        done = inside("render", "blue", "-o", "out.png", option, name)
        refused(done, f"brdf-suite: {name}: there is no such file")
        assert ("nor a shipped" in done.stderr) == ("." not in name)  # shipped names are no help to a path


def test_empty_names_are_refused_in_words(inside) -> None:
    refused(inside("fit", ""), "name of the paint is empty", "brdf-suite list paints")
    refused(inside("render", "", "-o", "out.png"), "name of the paint is empty")
    refused(inside("render", "blue", "-o", "out.png", "--environment", ""), "environment is empty", "booth")
    refused(inside("render", "blue", "-o", "out.png", "--mesh", ""), "surface is empty", "speed_form")
    refused(inside("prefilter", ""), "environment is empty")
    refused(inside("open", ""), "paint is empty")
    for words in (("batch", "measure", "blue"), ("render", "blue")):
        done = inside(*words, "-o", "")
        assert done.returncode == 2
        assert "argument -o/--output: a file or a folder has no empty name" in done.stderr


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
def test_pipes_and_folders_are_no_environment(inside, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.exr")
    for name in ("pipe.exr", "."):
        refused(inside("render", "blue", "-o", "out.png", "--environment", name), "is not a plain file")


def test_a_fit_that_was_stopped_by_time_is_reported(monkeypatch, capsys, tmp_path: Path) -> None:
    def stopped(material: Material, settings: FitSettings) -> LobeFit:
        found = fit_material(material, settings)
        return replace(found, weights=replace(found.weights, time_limited=True))

    monkeypatch.setattr("brdf_suite.output.still.fit_material", stopped)
    assert main(["render", "blue", "-o", str(tmp_path / "out.png"), "--size", "64x48"]) == 0
    assert " ms, time-limited, maps " in capsys.readouterr().out


def test_bad_environments_are_refused_in_one_line(inside, shared_data: Path, tmp_path: Path) -> None:
    text = tmp_path / "text.hdr"
    text.write_text("this is not a picture\n" * 20)
    refused(inside("render", "blue", "-o", "out.png", "--environment", text), "text.hdr")
    cut = tmp_path / "cut.exr"
    cut.write_bytes((shared_data / "environments" / "sunset.exr").read_bytes()[:20_000])
    refused(inside("prefilter", cut), "cut.exr")
    refused(inside("prefilter", tmp_path / "missing.exr"), "missing.exr", "there is no such file")
    refused(inside("prefilter", "bouth"), "bouth", "nor a shipped environment", "booth")


def test_bad_meshes_are_refused_in_one_line(inside, tmp_path: Path) -> None:
    points = tmp_path / "points.obj"
    points.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
    refused(inside("render", "blue", "-o", "out.png", "--mesh", points), "points.obj", "triangles")
    empty = tmp_path / "empty.glb"
    empty.write_bytes(b"")
    refused(inside("render", "blue", "-o", "out.png", "--mesh", empty), "empty.glb")


def test_a_picture_that_cannot_be_written_says_so(inside, tmp_path: Path) -> None:
    refused(inside("render", "blue", "-o", "no/such/folder/out.png"), "folder does not exist")
    refused(inside("render", "blue", "-o", "out.jpg"), "PNG")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full, a disk that is always full")
def test_a_full_cache_disk_is_no_failure(inside, tmp_path: Path, monkeypatch) -> None:
    blocked = tmp_path / "blocked"
    blocked.write_text("a file where the cache folder should be")
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(blocked))
    # The maps of the booth are shipped; those of this light are nowhere.
    write_exr(tmp_path / "light.exr", np.ones((8, 16, 3), np.float32))
    done = inside("prefilter", "light.exr", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["from_cache"] is False


def test_programs_refuse_without_a_screen(inside) -> None:
    refused(inside("viewer"), "no screen", "render")


def test_options_after_a_program_are_the_programs(command, tmp_path: Path) -> None:
    helped = command("designer", "--help")
    assert helped.returncode == 0, helped.stderr
    assert "--screenshot" in helped.stdout
    done = subprocess.run(
        [sys.executable, "-m", "brdf_suite", "designer", "--report-startup", "--quit-after", "0"],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen", "BRDF_SUITE_SETTINGS": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["ready_s"] > 0


def test_bench_lists_and_refuses(inside) -> None:
    done = inside("bench", "--list")
    assert done.returncode == 0, done.stderr
    for name in ("edit", "fit", "prefilter", "startup", "viewer"):
        assert name in done.stdout
    refused(inside("bench", "nothing"), "nothing", "edit")


def test_the_installed_script_is_the_same_command() -> None:
    script = shutil.which("brdf-suite", path=str(Path(sys.executable).parent))
    assert script is not None
    done = subprocess.run([script, "--version"], capture_output=True, text=True, check=True, timeout=240)
    assert done.stdout.startswith("brdf-suite ")


def test_stages_are_shown_where_output_is_no_terminal(command, inside) -> None:
    words = ("render", "blue", "-o", "a.png", "--size", "64x36")
    done = command(*words)
    assert done.stderr.splitlines() == [
        "preparing the light (photo_studio) ...",
        "computing ambient occlusion ...",
        "drawing ...",
    ]
    assert len(done.stdout.splitlines()) == 1
    quiet = inside(*words, "--json")
    assert quiet.stderr == ""
    assert json.loads(quiet.stdout)["width"] == 64


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
def test_a_program_ends_with_the_command_that_started_it(tmp_path: Path) -> None:
    own = {
        "QT_QPA_PLATFORM": "offscreen",
        "BRDF_SUITE_SETTINGS": str(tmp_path),
        "BRDF_SUITE_LINK": tmp_path.name,
    }
    start = [sys.executable, "-m", "brdf_suite", "swatch"]
    with subprocess.Popen(start, env={**os.environ, **own}, stderr=subprocess.PIPE, text=True) as command:
        listed = Path(f"/proc/{command.pid}/task/{command.pid}/children")
        while command.poll() is None and not listed.read_text():
            time.sleep(0.05)
        child = listed.read_text().split()[0]
        command.send_signal(signal.SIGTERM)
        _, errors = command.communicate(timeout=120)
        assert command.returncode == 130, errors
    assert not Path(f"/proc/{child}").exists()


def test_a_list_of_nothing_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "plugins"]) == 0  # the tests' environment has none
    assert capsys.readouterr() == ("", "note: there are no plugins\n")
