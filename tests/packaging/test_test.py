"""What ``packaging/test.py`` runs for its arguments."""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture
def script(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(checkout / "packaging"))
    for name in ("changed", "prepare", "installer", "report", "system_libraries"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    spec = importlib.util.spec_from_file_location("test_script", checkout / "packaging" / "test.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_everything_runs_in_a_worker_for_each_core(script: ModuleType) -> None:
    screen, rest = script.runs_of([])
    for run in (screen, rest):
        assert run[:2] == [
            "-n",
            str(len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count()),
        ]
    assert set(screen) >= set(script.SCREEN)
    assert {f"--ignore={folder}" for folder in script.SCREEN} <= set(rest)


def test_fresh_seeds_go_with_any_run(script: ModuleType) -> None:
    assert script.runs_of(["tests/fitting", "--fresh-seeds", "-k", "limit"]) == [
        ["tests/fitting", "-k", "limit", "--hypothesis-profile=nightly"]
    ]
    assert [run[-1] for run in script.runs_of(["--fresh-seeds"])] == ["--hypothesis-profile=nightly"] * 2


def test_changes_run_what_they_reach_each_on_its_platform(
    script: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        script, "changed_files", lambda _root, _commit: ["apps/brdf_qt/work/command_process.py"]
    )
    screen, rest = script.runs_of(["--changed"])
    assert "tests/viewer/test_window.py" in screen
    assert "tests/qt/test_command_process.py" in rest
    assert not [word for word in rest if word.startswith(script.SCREEN)]
    assert "tests/appearance/test_spaces.py" not in rest
    printed = capsys.readouterr().out
    assert "1 changed files reach" in printed
    assert "tests/qt/test_command_process.py" in printed


def test_without_a_change_nothing_runs(
    script: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(script, "changed_files", lambda _root, _commit: [])
    assert script.runs_of(["--changed"]) == []
    assert "nothing has changed" in capsys.readouterr().out
    with pytest.raises(ValueError, match="one commit"):
        script.runs_of(["--changed", "HEAD", "-k", "limit"])
