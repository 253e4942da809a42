"""Which variant is taken, and what is reported where there is none; each trial is a process of its own."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from brdf_suite.errors import ExtraError, MissingExtraError, ReferenceUnavailableError
from brdf_suite.reference import variant
from brdf_suite.reference.variant import (
    ProbeResult,
    Variant,
    choose,
    choose_variant,
    parse_version,
    probe,
    start,
)

OLD, NEW, NEWEST = "/usr/lib/libLLVM-15.so.1", "/usr/lib/libLLVM.so.19.1", "/usr/lib/libLLVM.so.20.1"


class Trial:
    """Lets some libraries run, and notes what was tried."""

    def __init__(self, *run: str, cuda: bool = False) -> None:
        self.run, self.cuda, self.tried = run, cuda, []

    def __call__(self, name: str, path: str) -> ProbeResult:
        self.tried.append((name, path))
        ran = self.cuda if name.startswith("cuda") else path in self.run
        return ProbeResult(
            ran, "19.1.7" if ran else "", "" if ran else "its trial ended with signal 6 (LLVM ERROR)"
        )


def test_an_old_llvm_is_not_even_tried() -> None:
    trial = Trial(OLD, NEW)
    assert choose(False, [OLD, NEW], trial) == Variant("llvm_ad_rgb", NEW, "19.1.7")
    assert trial.tried == [("llvm_ad_rgb", NEW)]


def test_a_graphics_card_goes_first_and_what_fails_gives_way() -> None:
    assert choose(True, [NEW], Trial(cuda=True)) == Variant("cuda_ad_rgb")
    trial = Trial(NEW)
    assert choose(True, [NEWEST, NEW], trial).llvm_path == NEW
    assert [path for _, path in trial.tried] == ["", NEWEST, NEW]


@pytest.mark.parametrize(
    ("libraries", "words"), [([], ()), ([OLD], ("LLVM 15",)), ([NEW], ("signal 6", "LLVM ERROR"))]
)
def test_without_one_the_package_is_named(libraries: list[str], words: tuple[str, ...]) -> None:
    with pytest.raises(ReferenceUnavailableError, match="libllvm19") as reported:
        choose(False, libraries, Trial())
    assert all(word in str(reported.value) for word in ("apt-get install", "DRJIT_LIBLLVM_PATH", *words))


def test_without_the_extra_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    choose_variant.cache_clear()
    with pytest.raises(MissingExtraError, match="needs Mitsuba, which is not installed"):
        choose_variant()
    choose_variant.cache_clear()


def run_with_packages(monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    """Let the trial find packages in ``folder``, which child processes of the suite never do."""
    monkeypatch.setenv("PYTHONPATH", str(folder))
    monkeypatch.setattr(
        variant, "child_command", lambda module, *words: [sys.executable, "-P", "-m", module, *words]
    )


def test_a_mitsuba_that_cannot_be_loaded_is_not_taken_for_a_missing_llvm(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    package = tmp_path / "mitsuba"
    package.mkdir()
    (package / "__init__.py").write_text("raise ImportError('libmitsuba.so: undefined symbol: nothing')\n")
    run_with_packages(monkeypatch, tmp_path)
    with pytest.raises(ExtraError, match=r"cannot be loaded \(libmitsuba.so: undefined symbol: nothing\)"):
        probe("llvm_ad_rgb", NEW)


def test_a_trial_that_dies_takes_nothing_along(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A real process that ends as one does under an old LLVM."""
    package = tmp_path / "mitsuba"
    package.mkdir()
    (package / "__init__.py").write_text("import os; os.abort()\n")
    (tmp_path / "drjit.py").write_text("")
    run_with_packages(monkeypatch, tmp_path)
    found = probe("llvm_ad_rgb", NEW)
    assert not found.ran
    assert "signal 6" in found.words


def test_a_library_that_is_none_is_reported(tmp_path: Path) -> None:
    pytest.importorskip("mitsuba", reason="the extra reference is not installed")
    bad = tmp_path / "libLLVM.so.19.9"
    bad.write_bytes(b"no library")
    found = probe("llvm_ad_rgb", str(bad))
    assert not found.ran
    assert found.words


@pytest.mark.parametrize(
    ("path", "number"),
    [(OLD, 15), (NEW, 19), ("/usr/lib/llvm-17/lib/libLLVM.so", 17), ("/opt/libLLVM.so", 0)],
)
def test_versions_are_read_from_names(path: str, number: int) -> None:
    assert parse_version(path) == number


def test_choosing_imports_no_mitsuba() -> None:
    import subprocess

    code = "import sys, brdf_suite.reference.variant; print('mitsuba' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=240, check=True
    )
    assert done.stdout.strip() == "False"


def test_the_variant_that_was_chosen_runs(variant: Variant) -> None:
    import mitsuba as mi

    assert mi.variant() == variant.name
    mi.set_variant("scalar_rgb")  # as other code in the process may
    assert start() == variant
    assert mi.variant() == variant.name
    assert variant.title.startswith("Mitsuba, ")
