"""Preparing a machine: what is missing is named, nothing is done twice."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture
def prepare(checkout: Path) -> ModuleType:
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


def test_a_changed_lock_makes_the_environment_stale(prepare: ModuleType, monkeypatch, tmp_path: Path) -> None:
    python = tmp_path / "python"
    python.touch()
    stamp = tmp_path / "stamp"
    lock = tmp_path / "lock.txt"
    lock.write_text("numpy==2.0\n")
    monkeypatch.setattr(prepare, "PYTHON", python)
    monkeypatch.setattr(prepare, "STAMP", stamp)
    monkeypatch.setattr(prepare, "LOCK", lock)
    assert prepare._prepared_extras() is None
    stamp.write_text(f"{prepare._fingerprint()} dev")
    assert prepare._prepared_extras() == {"dev"}
    lock.write_text("numpy==2.1\n")
    assert prepare._prepared_extras() is None


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
