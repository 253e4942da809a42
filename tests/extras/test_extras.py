"""What is said of an optional package that is missing, too old or broken, for each kind of installation."""

from __future__ import annotations

import ast
import importlib.metadata
import shlex
import sys
from pathlib import Path

import pytest

from brdf_suite.errors import ExtraError, MissingExtraError
from brdf_suite.extras import PACKAGES, check_extra, import_extra, install_command, requirements


@pytest.fixture
def broken(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    """Put a rawpy before the real one that begins with the given lines."""

    def put(lines: str) -> None:
        (tmp_path / "rawpy").mkdir()
        (tmp_path / "rawpy" / "__init__.py").write_text(lines)
        monkeypatch.syspath_prepend(tmp_path)
        monkeypatch.delitem(sys.modules, "rawpy", raising=False)

    return put


def missing(monkeypatch: pytest.MonkeyPatch, instead: str = "") -> str:
    monkeypatch.setitem(sys.modules, "rawpy", None)
    with pytest.raises(MissingExtraError) as found:
        import_extra("rawpy", purpose="a raw file", instead=instead)
    assert str(found.value) == found.value.reason[0].upper() + found.value.reason[1:] + "."
    return str(found.value)


def test_every_extra_for_users_is_covered() -> None:
    """The extras of the project that the product imports, with the names of their packages."""
    for package in PACKAGES.values():
        stated = requirements(package.extra)
        assert stated
        if package.distribution != "drjit":  # which comes with Mitsuba
            assert [line for line in stated if line.startswith(package.distribution + ">=")]
    assert requirements("reference") == ["flip-evaluator>=1.6", "mitsuba>=3.7"]


def test_a_checkout_installs_by_its_own_program(
    monkeypatch: pytest.MonkeyPatch, checkout: Path, tmp_path: Path
) -> None:
    monkeypatch.setattr(sys, "prefix", str(checkout / ".venv"))
    run = checkout / "packaging" / "run.py"
    assert shlex.split(install_command("video"))[1:] == [str(run), "--with", "video"]
    words = missing(monkeypatch, "TIFF needs nothing more")
    assert words == (
        f"A raw file needs rawpy, which is not installed; `{install_command('acquisition')}` installs it, "
        "and TIFF needs nothing more."
    )


def test_another_environment_installs_by_pip_or_uv(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    monkeypatch.setattr(sys, "executable", str(tmp_path / "a b" / "python"))
    (tmp_path / "pip").mkdir()
    (tmp_path / "pip" / "__init__.py").write_text("")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "pip", raising=False)
    packages = ["flip-evaluator>=1.6", "mitsuba>=3.7"]
    python = str(tmp_path / "a b" / "python")
    assert shlex.split(install_command("reference")) == [python, "-m", "pip", "install", *packages]
    again = shlex.split(install_command("reference", again=True))
    assert again == [python, "-m", "pip", "install", "--force-reinstall", *packages]
    monkeypatch.setitem(sys.modules, "pip", None)
    assert shlex.split(install_command("reference")) == [
        *("uv", "pip", "install", "--python", python),
        *packages,
    ]
    assert "`uv pip install" in missing(monkeypatch)


def test_a_program_in_one_file_says_what_it_lacks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    words = missing(monkeypatch, "TIFF needs nothing more")
    assert words == (
        "A raw file needs rawpy, which this build of BRDF Suite does not contain; TIFF needs nothing more."
    )


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ("import no_such_part", "cannot be loaded (No module named 'no_such_part'); `"),
        ("raise OSError('it is\\nof another system.')", "cannot be loaded (it is of another system); `"),
        (
            "raise ImportError('libhere.so.1: cannot open shared object file: No such file or directory')",
            "; install the system library libhere.so.1 with the package manager of this system.",
        ),
    ],
)
def test_a_package_that_is_there_and_broken_is_not_called_missing(broken, lines: str, said: str) -> None:
    broken(lines)
    with pytest.raises(ExtraError) as found:
        import_extra("rawpy", purpose="a raw file")
    assert not isinstance(found.value, MissingExtraError)
    assert "which is installed but " in str(found.value)
    assert said in str(found.value)


def test_a_package_that_is_too_old_is_named_with_its_version(broken, tmp_path: Path) -> None:
    broken("")
    record = tmp_path / "rawpy-0.9.1.dist-info"
    record.mkdir()
    (record / "METADATA").write_text("Metadata-Version: 2.1\nName: rawpy\nVersion: 0.9.1\n")
    assert importlib.metadata.version("rawpy") == "0.9.1"
    with pytest.raises(ExtraError, match=r"needs rawpy 0\.24 or later, and 0\.9\.1 is installed; `"):
        check_extra("rawpy", purpose="a raw file")


def test_a_folder_that_an_uninstalled_package_left_is_no_package(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "rawpy").mkdir()
    monkeypatch.delitem(sys.modules, "rawpy", raising=False)
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    with pytest.raises(MissingExtraError):
        import_extra("rawpy", purpose="a raw file")


def test_optional_packages_are_imported_in_one_place(checkout: Path) -> None:
    """Other modules name them for the type checker alone."""
    found = []
    for file in [*(checkout / "brdf_suite").rglob("*.py"), *(checkout / "apps").rglob("*.py")]:
        text = file.read_text(encoding="utf-8")
        if not any(name in text for name in PACKAGES):
            continue
        tree = ast.parse(text)
        for_types = {
            inner
            for node in ast.walk(tree)
            if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
            for statement in node.body
            for inner in ast.walk(statement)
        }
        for node in set(ast.walk(tree)) - for_types:
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            if isinstance(node, ast.ImportFrom) and node.level == 0:
                names = [node.module or ""]
            found += [(file, name) for name in names if name.partition(".")[0] in PACKAGES]
    assert found == []


def test_nothing_names_a_project_that_is_not_published(checkout: Path) -> None:
    folders = ("brdf_suite", "apps", "docs")
    files = [
        file for name in folders for ending in ("py", "md") for file in (checkout / name).rglob(f"*.{ending}")
    ]
    assert [file for file in files if "brdf-suite[" in file.read_text(encoding="utf-8")] == []
