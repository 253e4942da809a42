"""A hundred damaged copies of each environment file; ``tools/attack/fuzz_environments.py`` makes ten thousand."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

pytest.importorskip("resource", reason="memory limits are set through the Unix module resource")
if not Path("/proc/self/statm").exists():
    pytest.skip("the memory in use is read from /proc", allow_module_level=True)

MUTATIONS = 60


@pytest.fixture(scope="module")
def fuzzing(checkout: Path) -> ModuleType:
    folder = checkout / "tools" / "attack"
    for name in ("fuzz_measured", "fuzz_environments"):
        spec = importlib.util.spec_from_file_location(name, folder / f"{name}.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)
        module.SECONDS = 60.0  # a busy machine is no fault of a reader
    return module


def check(fuzzing: ModuleType, path: Path) -> None:
    counts, longest, peak = fuzzing.fuzz(path, MUTATIONS, seed=11)
    assert not [result for result in counts if result.startswith("FAULT")], counts
    assert counts["read"] > 0  # some damage does no harm, so the readers were really reached
    assert counts["refused"] > MUTATIONS // 5
    assert longest < fuzzing.SECONDS
    assert peak < 2048


@pytest.mark.parametrize("name", ["warehouse.exr", "kiara_1_dawn_1k.hdr"])
def test_damaged_files_are_refused_or_read_within_the_limits(
    shared_data: Path, fuzzing: ModuleType, name: str
) -> None:
    check(fuzzing, shared_data / "environments" / name)


def test_damaged_files_of_rare_kinds(tmp_path: Path, fuzzing: ModuleType) -> None:
    for path in fuzzing.rare_kinds(tmp_path):
        check(fuzzing, path)


def test_a_crash_a_hang_and_a_wrong_answer_are_seen(
    tmp_path: Path, fuzzing: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "x.exr"
    path.write_bytes(b"x" * 400)
    parent = fuzzing.os.getpid()

    def crash(_path: Path) -> str:
        if fuzzing.os.getpid() != parent:
            fuzzing.os.kill(fuzzing.os.getpid(), 9)
        return "read"

    def hang(_path: Path) -> str:
        fuzzing.time.sleep(600.0)
        return "read"

    monkeypatch.setattr(fuzzing, "_radiance", lambda _path: None)
    for outcome, words, seconds in ((crash, "died (SIGKILL)", 60.0), (hang, "over 0.8 s", 0.2)):
        monkeypatch.setattr(fuzzing, "SECONDS", seconds)
        monkeypatch.setattr(fuzzing, "outcome", outcome)
        counts, _, _ = fuzzing.fuzz(path, 2, seed=0, keep=tmp_path / "kept")
        assert sum(count for result, count in counts.items() if words in result) == 2
    assert len(list((tmp_path / "kept").iterdir())) == 2
