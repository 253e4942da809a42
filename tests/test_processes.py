"""Child processes: only modules of the suite, and no Python file of the working folder is ever imported by them."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

from brdf_suite import processes
from brdf_suite.cli.main import main
from brdf_suite.processes import child_command

CHECKOUT = Path(__file__).resolve().parent.parent
SOURCES = sorted([*(CHECKOUT / "brdf_suite").rglob("*.py"), *(CHECKOUT / "apps").rglob("*.py")])
STARTS = CHECKOUT / "brdf_suite" / "processes.py"
POOL = CHECKOUT / "brdf_suite" / "fitting" / "basis_search" / "search.py"
HOSTILE = (
    "random",
    "json",
    "numpy",
    "PySide6",
    "subprocess",
    "logging",
    "struct",
    "socket",
    "multiprocessing",
)
TRAP = "from pathlib import Path\nPath(__file__).with_name('ran').touch()\n"


def uses(path: Path) -> set[str]:
    """What a source uses that can start Python: ``sys.executable``, and modules that build command lines themselves."""
    found: set[str] = set()
    text = path.read_text(encoding="utf-8")
    if not any(word in text for word in ("executable", "multiprocessing", "ProcessPoolExecutor")):
        return found  # what is looked for holds one of them, and parsing takes long
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Attribute) and node.attr in ("executable", "_base_executable"):
            found.add("executable")
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            names = [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
        for name in names:
            if name == "sys.executable":
                found.add("executable")
            if name.split(".")[0] == "multiprocessing" or "ProcessPoolExecutor" in name:
                found.add("multiprocessing")
    return found


def test_processes_are_started_in_one_place() -> None:
    used = {path: uses(path) for path in SOURCES}
    # The second one names the interpreter in the command that installs an extra, and starts nothing.
    named = CHECKOUT / "brdf_suite" / "extras.py"
    assert {path for path, found in used.items() if "executable" in found} == {STARTS, named}
    assert "subprocess" not in named.read_text(encoding="utf-8")
    assert {path for path, found in used.items() if "multiprocessing" in found} == {STARTS, POOL}


def modules() -> list[str]:
    """The modules of the suite that run as programs."""
    found = []
    for path in SOURCES:
        if 'if __name__ == "__main__":' in path.read_text(encoding="utf-8"):
            inside = path.relative_to(CHECKOUT / "apps" if "apps" in path.parts else CHECKOUT)
            found.append(".".join(inside.with_suffix("").parts).removesuffix(".__main__"))
    return found


@pytest.fixture
def hostile(tmp_path: Path) -> Path:
    folder = tmp_path / "hostile"
    folder.mkdir()
    for name in HOSTILE:
        (folder / f"{name}.py").write_text(TRAP)
    return folder


def run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONSAFEPATH"}
    return subprocess.run(
        command,
        cwd=folder,
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_trap_catches_a_process_that_is_started_without_the_option(hostile: Path) -> None:
    run([sys.executable, "-m", "brdf_suite", "--help"], hostile)
    assert (hostile / "ran").exists()


@pytest.mark.parametrize("module", modules())
def test_no_file_of_the_working_folder_runs(module: str, hostile: Path, tmp_path: Path) -> None:
    arguments = {
        "brdf_viewer.tracing.worker": [str(tmp_path / "scene")],
        "brdf_suite.reference.probe": ["none"],
    }
    done = run(child_command(module, *arguments.get(module, ["--help"])), hostile)
    assert not (hostile / "ran").exists()
    if (
        module != "brdf_suite.reference.probe"
    ):  # it fails where Mitsuba is missing, and for an unknown variant
        assert done.returncode == 0, done.stderr


def test_no_file_of_the_working_folder_runs_in_a_child_of_a_child(hostile: Path) -> None:
    done = run(child_command("brdf_suite", "designer", "--help"), hostile)
    assert "usage: brdf-designer" in done.stdout
    assert not (hostile / "ran").exists()


POOL_SCRIPT = """
from brdf_suite.fitting.basis_search.database import load_database
from brdf_suite.fitting.basis_search.search import Workers

def report(done):
    pass

if __name__ == "__main__":
    from pathlib import Path
    import shutil, sys
    from brdf_suite.resources import resource_root
    folder = Path(sys.argv[1])
    folder.mkdir()
    for name in ("blue", "solid_red"):
        shutil.copy(resource_root() / "paints" / f"{name}.brdfpaint", folder)
    workers = Workers(load_database(folder), 2)
    print(len(workers.run([(1.0, 20.0), (5.0, 100.0)], report)))
    workers.close()
"""


def test_no_file_of_the_working_folder_runs_in_a_pool(hostile: Path, tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(POOL_SCRIPT)
    done = run([sys.executable, str(script), str(tmp_path / "paints")], hostile)
    assert done.stdout.strip() == "2", done.stderr
    assert not (hostile / "ran").exists()


def test_a_frozen_build_runs_modules_by_the_hidden_option(
    monkeypatch: pytest.MonkeyPatch, hostile: Path
) -> None:
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    program, *arguments = child_command("brdf_viewer", "--help")
    assert program == sys.executable
    # What stands for the frozen program here: the command.
    monkeypatch.delattr(sys, "frozen")
    done = run([*child_command("brdf_suite"), *arguments], hostile)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("usage: brdf-viewer")


def test_a_program_runs_modules_by_the_hidden_option_too(hostile: Path) -> None:
    done = run(child_command("brdf_designer", "--module", "brdf_suite", "list", "formats"), hostile)
    assert done.returncode == 0, done.stderr
    assert "brdfpaint" in done.stdout


def test_no_folder_that_a_variable_names_runs(hostile: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", str(hostile))
    monkeypatch.setenv("PYTHONWARNINGS", "error::random.Warning")
    run([sys.executable, "-P", "-m", "brdf_suite", "--help"], hostile.parent)
    assert (hostile / "ran").exists()
    (hostile / "ran").unlink()
    done = run(child_command("brdf_suite", "--help"), hostile.parent)
    assert done.returncode == 0, done.stderr
    assert not (hostile / "ran").exists()


def test_a_source_that_a_variable_names_is_found_by_its_children(
    hostile: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(map(str, (CHECKOUT, CHECKOUT / "apps"))))
    assert "-E" not in child_command("brdf_suite")
    done = run(child_command("brdf_suite", "--help"), hostile)
    assert done.returncode == 0, done.stderr
    assert not (hostile / "ran").exists()


@pytest.mark.parametrize("words", [[], ["http.server"], ["brdf_suited"], ["os"]])
def test_the_hidden_option_runs_modules_of_the_suite_only(
    words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["--module", *words]) == 2
    assert "--module takes the name of a module of the suite" in capsys.readouterr().err
    for module in words:
        with pytest.raises(ValueError, match="is no module of the suite"):
            child_command(module)
        with pytest.raises(ValueError, match="is no module of the suite"):
            processes.run_module(module, [])


def run_in_shell(streams: str, *words: str, **variables: str) -> subprocess.CompletedProcess[bytes]:
    """Run Python in a shell, with some of the standard streams closed."""
    command = ["sh", "-c", f'exec "$@" {streams}', "sh", sys.executable, *words]
    return subprocess.run(command, env={**os.environ, **variables}, capture_output=True, check=False)


@pytest.mark.skipif(os.name == "nt", reason="streams are closed by a shell")
@pytest.mark.parametrize("streams", ["<&- >&- 2>&-", ">&-", "2>&-", ""])
def test_a_file_does_not_take_the_place_of_a_closed_stream(streams: str, tmp_path: Path) -> None:
    script = (
        "import os, sys\n"
        "from brdf_suite.processes import prepare_streams\n"
        "prepare_streams()\n"
        "with open(sys.argv[1], 'w') as file:\n"
        "    os.write(1, b'of a library'), os.write(2, b'of a library')\n"
        "    file.write('mine')\n"
    )
    done = run_in_shell(streams, "-c", script, str(tmp_path / "file"))
    assert (done.returncode, (tmp_path / "file").read_text()) == (0, "mine")


@pytest.mark.skipif(os.name == "nt", reason="without UTF-8 by the locale C alone")
def test_what_is_printed_for_programs_is_utf8_in_every_locale(tmp_path: Path) -> None:
    name = "Café 粉 Ω"
    (tmp_path / "a.gpl").write_text(f"GIMP Palette\nName: {name}\n128 50 20 {name}\n", encoding="utf-8")
    ascii_only = {
        "LC_ALL": "C",
        "PYTHONUTF8": "0",
        "PYTHONCOERCECLOCALE": "0",
        "PYTHONIOENCODING": "ascii:strict",
    }
    words = ("-m", "brdf_suite", "palette", "info", str(tmp_path / "a.gpl"), "--json")
    done = run_in_shell("", *words, **ascii_only)
    assert done.returncode == 0, done.stderr
    assert name in done.stdout.decode("utf-8")
    assert run_in_shell("", "-m", "brdf_color_swatch", "--help", **ascii_only).returncode == 0
