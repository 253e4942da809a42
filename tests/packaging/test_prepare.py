"""Preparing a machine: what is missing is named, nothing is done twice."""

from __future__ import annotations

import importlib.util
import signal
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture
def prepare(checkout: Path, monkeypatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(checkout / "packaging"))
    spec = importlib.util.spec_from_file_location("prepare_under_test", checkout / "packaging" / "prepare.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_library_that_cannot_be_loaded_names_its_package(prepare: ModuleType, monkeypatch) -> None:
    monkeypatch.setattr(prepare, "_LIBRARIES", {"libno_such_thing.so.9": "libno-such-thing9"})
    assert "libno-such-thing9" in prepare._missing_packages(for_tests=False)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="system packages are a matter of Linux")
def test_without_permission_the_one_line_to_run_is_printed(prepare: ModuleType, monkeypatch) -> None:
    monkeypatch.setattr(prepare, "_missing_packages", lambda for_tests: ["libegl1", "xvfb"])
    monkeypatch.setattr(prepare, "_root_prefix", lambda: None)
    monkeypatch.setattr(prepare.shutil, "which", lambda name: f"/usr/bin/{name}")
    with pytest.raises(SystemExit) as stopped:
        prepare.prepare()
    assert "sudo apt-get install -y --no-install-recommends libegl1 xvfb" in str(stopped.value)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="system packages are a matter of Linux")
def test_other_linux_systems_get_a_clear_message(prepare: ModuleType, monkeypatch) -> None:
    monkeypatch.setattr(prepare, "_missing_packages", lambda for_tests: ["libegl1"])
    monkeypatch.setattr(prepare.shutil, "which", lambda name: None)
    with pytest.raises(SystemExit, match="package manager") as stopped:
        prepare.prepare()
    assert "libegl1" in str(stopped.value)


def test_an_old_python_is_refused(prepare: ModuleType, monkeypatch) -> None:
    monkeypatch.setattr(prepare, "MINIMUM", (99, 0))
    with pytest.raises(SystemExit, match=r"needs Python 99\.0"):
        prepare.prepare()


@pytest.fixture
def environment(prepare: ModuleType, monkeypatch, tmp_path: Path) -> Path:
    """Stand in a folder of its own for the environment: a site-packages with two packages, no stamp yet."""
    folder = tmp_path / ".venv"
    for name in ("lib/python3.11/site-packages/numpy-2.0.dist-info", "lib/python3.11/site-packages/numpy"):
        (folder / name).mkdir(parents=True)
    lock = tmp_path / "lock.txt"
    lock.write_text("numpy==2.0\n")
    (folder / "python").touch()
    for name, path in (
        ("ENVIRONMENT", folder),
        ("PYTHON", folder / "python"),
        ("STAMP", folder / "stamp"),
        ("LOG", folder / "install.log"),
        ("LOCK", lock),
    ):
        monkeypatch.setattr(prepare, name, path)
    monkeypatch.setattr(prepare, "_install_system_libraries", lambda for_tests: None)
    return folder


def pip_that(folder: Path, body: str) -> Path:
    """Put a program in place of Python and pip; it gets pip's arguments."""
    program = folder / "pip_stand_in"
    program.write_text(f"#!{sys.executable}\nimport sys, time\n{body}\n")
    program.chmod(0o755)
    return program


def test_a_changed_lock_makes_the_environment_stale(prepare: ModuleType, environment: Path) -> None:
    assert prepare._stamped() is None
    prepare._write_stamp({"dev"})
    assert prepare._stamped() == (
        {"dev"},
        {"numpy", "numpy-2.0.dist-info"},
    )
    prepare.LOCK.write_text("numpy==2.1\n")
    assert prepare._stamped() is None
    prepare.STAMP.write_text("")
    assert prepare._stamped() is None


def test_an_environment_made_anew_keeps_what_it_was_made_for(
    prepare: ModuleType, environment: Path, monkeypatch
) -> None:
    prepare._write_stamp({"dev"})
    prepare.LOCK.write_text("numpy==2.1\n")
    asked: list[tuple[str, ...]] = []
    monkeypatch.setattr(prepare, "_make_environment", prepare.STAMP.unlink)
    monkeypatch.setattr(prepare, "_pip", lambda *arguments: asked.append(arguments))
    prepare.prepare()  # as packaging/run.py does, which asks for no extra
    assert asked[-1][-1] == ".[dev]"
    assert prepare._stamped() == ({"dev"}, {"numpy", "numpy-2.0.dist-info"})


def test_all_there_runs_nothing(prepare: ModuleType, environment: Path, capsys) -> None:
    prepare._write_stamp({"dev"})
    prepare.prepare()
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("lost", ["numpy", "numpy-2.0.dist-info"])
def test_a_package_that_was_taken_away_is_put_back(
    prepare: ModuleType, environment: Path, monkeypatch, capsys, lost: str
) -> None:
    prepare._write_stamp({"dev"})
    package = environment / "lib/python3.11/site-packages" / lost
    package.rmdir()
    asked: list[tuple[str, ...]] = []
    monkeypatch.setattr(prepare, "_make_environment", package.mkdir)
    monkeypatch.setattr(prepare, "_pip", lambda *arguments: asked.append(arguments))
    prepare.prepare()
    assert "the environment is damaged; mending it" in capsys.readouterr().out
    assert asked[-1][-1] == ".[dev]"  # with what it had before
    prepare.prepare()
    assert capsys.readouterr().out == ""
    assert len(asked) == 2


def test_what_pip_prints_goes_to_the_log(prepare: ModuleType, environment: Path, monkeypatch, capsys) -> None:
    body = (
        "for i in range(44): print('WARNING: not our matter')\n"
        "for i in range(23): print('Collecting package%d==1.0 (from brdf-suite)' % i)\n"
        "print('Installing collected packages: a, b, c')"
    )
    monkeypatch.setattr(prepare, "PYTHON", pip_that(environment, body))
    prepare._pip("numpy")
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        "[brdf-suite] fetching package 1, package0==1.0",
        "[brdf-suite] fetching package 11, package10==1.0",
        "[brdf-suite] fetching package 21, package20==1.0",
        "[brdf-suite] installing 3 packages",
    ]
    assert len(prepare.LOG.read_text().splitlines()) == 68


def test_on_a_terminal_one_line_changes(prepare: ModuleType, environment: Path, monkeypatch, capsys) -> None:
    body = "for i in range(3): print('Collecting package%d' % i)"
    monkeypatch.setattr(prepare, "PYTHON", pip_that(environment, body))
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    prepare._pip("numpy")
    out = capsys.readouterr().out
    assert "\n" not in out
    shown = [part.strip() for part in out.split("\r") if part.strip()]
    assert shown == [f"[brdf-suite] fetching package {i + 1}, package{i}" for i in range(3)]
    assert out.split("\r")[-2].strip() == ""  # and goes away at the end


def test_when_pip_fails_its_last_lines_are_shown(
    prepare: ModuleType, environment: Path, monkeypatch, capsys
) -> None:
    body = (
        "for i in range(40): print('line', i)\n"
        "print('ERROR: no such package')\n"
        "print('WARNING: of no use')\n"
        "sys.exit(1)"
    )
    monkeypatch.setattr(prepare, "PYTHON", pip_that(environment, body))
    with pytest.raises(SystemExit) as stopped:
        prepare._pip("numpy")
    text = str(stopped.value)
    assert "ERROR: no such package" in text
    assert str(prepare.LOG) in text
    assert "WARNING" not in text
    assert "line 20" not in text
    assert "line 39" in text


def test_a_place_without_permission_is_named(prepare: ModuleType, environment: Path, monkeypatch) -> None:
    monkeypatch.setattr(prepare.os, "access", lambda place, mode: place != environment)
    with pytest.raises(SystemExit) as stopped:
        prepare.prepare()
    assert str(stopped.value).startswith(f"{environment} cannot be written to")


def test_a_file_in_place_of_the_environment_is_named(
    prepare: ModuleType, environment: Path, monkeypatch, tmp_path: Path
) -> None:
    file = tmp_path / "file"
    file.touch()
    monkeypatch.setattr(prepare, "ENVIRONMENT", file)
    with pytest.raises(SystemExit) as stopped:
        prepare.prepare()
    assert str(file) in str(stopped.value)
    assert "cannot be written" in str(stopped.value)


@pytest.mark.skipif(sys.platform == "win32", reason="an interrupt is sent in another way there")
def test_cancelling_says_how_to_go_on(checkout: Path, environment: Path, tmp_path: Path) -> None:
    pip = pip_that(environment, "print('Collecting numpy', flush=True)\ntime.sleep(600)")
    driver = (
        "import sys, pathlib\n"
        "sys.path.insert(0, sys.argv[1])\n"
        "import prepare\n"
        "prepare._install_system_libraries = lambda for_tests: None\n"
        "prepare._make_environment = lambda: None\n"
        "prepare.ENVIRONMENT = pathlib.Path(sys.argv[2])\n"
        "prepare.PYTHON = pathlib.Path(sys.argv[3])\n"
        "prepare.STAMP = prepare.ENVIRONMENT / 'stamp'\n"
        "prepare.LOG = prepare.ENVIRONMENT / 'install.log'\n"
        "prepare.prepare()\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", driver, str(checkout / "packaging"), str(environment), str(pip)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as running:
        assert running.stdout is not None
        while "fetching" not in (line := running.stdout.readline()):
            assert line, "ended before it began"
        running.send_signal(signal.SIGINT)
        _, said = running.communicate(timeout=200)
    assert said == "cancelled; run this again to go on\n"
    assert running.returncode == 130


def test_run_passes_its_arguments_on(checkout: Path) -> None:
    if not (checkout / ".venv" / "brdf-suite-prepared").exists():
        pytest.skip("this checkout has not been prepared by packaging/run.py or packaging/test.py")
    done = subprocess.run(
        [sys.executable, str(checkout / "packaging" / "run.py"), "--version"],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    assert done.stdout.startswith("brdf-suite ")
