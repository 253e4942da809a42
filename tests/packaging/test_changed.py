"""What a change can reach, found in a small repository of the same form as this one."""

from __future__ import annotations

import importlib
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

FILES = {
    "pyproject.toml": '[project.gui-scripts]\nbrdf-viewer = "brdf_viewer.__main__:main"\n',
    "brdf_suite/__init__.py": "",
    "brdf_suite/errors.py": "class SuiteError(Exception): ...\n",
    "brdf_suite/fitting/__init__.py": "",
    "brdf_suite/fitting/fit.py": "from ..errors import SuiteError\n",
    "brdf_suite/fitting/lazy.py": "def run():\n    from brdf_suite.fitting.fit import SuiteError\n",
    "brdf_suite/realtime/__init__.py": "",
    # Its pattern means the files beside it, and "plot.json" is no module of packaging/plot.py.
    "brdf_suite/realtime/renderer.py": "'Mentions brdf_suite.fitting.fit.'\nHERE.glob('*.py')\n",
    "brdf_suite/realtime/shaders/tone.glsl": "",
    "brdf_suite/cli/__init__.py": "",
    "brdf_suite/cli/main.py": 'PROGRAMS = {"viewer": "brdf_viewer"}\n',
    "apps/brdf_viewer/__init__.py": "",
    "apps/brdf_viewer/__main__.py": "from brdf_viewer.window import Window\n",
    "apps/brdf_viewer/window.py": "from brdf_suite.realtime import renderer\n",
    "resources/paints/blue.brdfpaint": "{}",
    "packaging/plot.py": "",
    "docs/figures.md": "",
    "README.md": "",
    "tests/conftest.py": "",
    "tests/fitting/test_fit.py": "from brdf_suite.fitting import fit\n",
    "tests/fitting/test_lazy.py": "from brdf_suite.fitting.lazy import run\n",
    "tests/fitting/test_child.py": 'CHILD = ["-m", "brdf_suite.fitting.fit"]\n',
    "tests/test_rooms.py": 'def modules(room):\n    return f"import brdf_suite.{room}"\n',
    "tests/realtime/conftest.py": 'load_module("ball.py")\n',
    "tests/realtime/ball.py": "",
    "tests/realtime/test_renderer.py": "from brdf_suite.realtime.renderer import x\nFILE = 'plot.json'\n",
    "tests/cli/test_main.py": "import brdf_suite.cli.main\n",
    "tests/cli/test_viewer.py": 'run("brdf_suite.cli.main", "viewer")\n',
    "tests/viewer/test_window.py": "import brdf_viewer.window\n",
    "tests/packaging/test_figures.py": 'PAGE = ROOT / "docs" / "figures.md"\n',
    "tests/packaging/test_paints.py": 'PAINTS = (ROOT / "resources" / "paints").glob("*.brdfpaint")\n',
}


@pytest.fixture
def changed(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(checkout / "packaging"))
    monkeypatch.delitem(sys.modules, "changed", raising=False)
    return importlib.import_module("changed")


@pytest.fixture
def git(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., str]:
    """A repository with the files in one commit on ``main``; call it with the words of a git command."""
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", str(tmp_path / "none"))
    monkeypatch.setenv("GIT_CONFIG_NOSYSTEM", "1")
    for name in ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"):  # set where a commit hook runs the tests
        monkeypatch.delenv(name, raising=False)
    root = tmp_path / "a répository"
    for name, text in FILES.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def run(*words: str) -> str:
        author = ["-c", "user.name=Tester", "-c", "user.email=tester@example.org"]
        done = subprocess.run(["git", *author, *words], cwd=root, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    run("init", "-q", "-b", "main")
    run("add", ".")
    run("commit", "-q", "-m", "All")
    return run


@pytest.fixture
def root(git: Callable[..., str]) -> Path:
    return Path(git("rev-parse", "--show-toplevel"))


@pytest.mark.parametrize(
    ("file", "tests"),
    [
        ("brdf_suite/fitting/fit.py", "fitting/test_child fitting/test_fit fitting/test_lazy test_rooms"),
        (
            "brdf_suite/realtime/shaders/tone.glsl",
            "cli/test_viewer realtime/test_renderer test_rooms viewer/test_window",
        ),
        ("apps/brdf_viewer/window.py", "cli/test_viewer viewer/test_window"),
        ("tests/realtime/ball.py", "realtime/test_renderer"),
        ("tests/cli/test_main.py", "cli/test_main"),
        ("resources/paints/blue.brdfpaint", "packaging/test_paints"),
        ("docs/figures.md", "packaging/test_figures"),
        ("README.md", "packaging/test_figures packaging/test_paints"),
        ("packaging/plot.py", "packaging/test_figures packaging/test_paints"),
    ],
)
def test_an_edit_selects_what_imports_or_names_the_file(
    changed: ModuleType, root: Path, file: str, tests: str
) -> None:
    with (root / file).open("a", encoding="utf-8") as stream:
        stream.write("\n")
    assert changed.changed_files(root) == [file]
    found = changed.select(root, [file]).tests
    assert list(found) == [f"tests/{test}.py" for test in tests.split()]


@pytest.mark.parametrize("file", ["pyproject.toml", "tests/conftest.py", "setup.sh"])
def test_all_tests_run_where_all_depend_on_the_file_or_nothing_is_known_of_it(
    changed: ModuleType, root: Path, file: str
) -> None:
    (root / file).write_text("# another\n", encoding="utf-8")
    found = changed.select(root, changed.changed_files(root)).tests
    every = {name for name in FILES if "/test_" in name}
    assert found is None or set(found) == every


def test_changes_are_those_of_the_branch_and_of_the_working_tree(
    changed: ModuleType, git: Callable[..., str], root: Path
) -> None:
    git("switch", "-q", "-c", "branch")
    (root / "packaging/plot.py").write_text("x = 1\n", encoding="utf-8")
    git("commit", "-q", "-a", "-m", "Committed")
    git("rm", "-q", "brdf_suite/fitting/fit.py")
    (root / "tests/fitting/test_new.py").write_text("", encoding="utf-8")
    uncommitted = ["brdf_suite/fitting/fit.py", "tests/fitting/test_new.py"]
    assert changed.changed_files(root) == [uncommitted[0], "packaging/plot.py", uncommitted[1]]
    assert changed.changed_files(root, "HEAD") == uncommitted
    with pytest.raises(ValueError, match="no commit nowhere"):
        changed.changed_files(root, "nowhere")
    # What imports a file that is gone fails, and must be seen to.
    found = changed.select(root, uncommitted).tests
    assert {"tests/fitting/test_fit.py", "tests/fitting/test_lazy.py", "tests/fitting/test_new.py"} <= set(
        found
    )


def test_without_git_changes_are_unknown_and_what_they_reach_is_not(
    changed: ModuleType, root: Path, tmp_path: Path
) -> None:
    shutil.rmtree(root / ".git")
    assert changed.select(root, ["apps/brdf_viewer/window.py"]).tests == (
        "tests/cli/test_viewer.py",
        "tests/viewer/test_window.py",
    )
    with pytest.raises(ValueError, match="no commit HEAD"):
        changed.changed_files(tmp_path)
