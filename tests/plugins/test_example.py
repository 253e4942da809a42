"""The example package, installed as a user installs it, in the command and in a window."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest

_spec = importlib.util.spec_from_file_location("installed", Path(__file__).with_name("installed.py"))
installed = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(installed)


@pytest.fixture(scope="module")
def example(checkout: Path, tmp_path_factory) -> Path:
    """A folder that the example is installed in, built from its source without the network."""
    folder = tmp_path_factory.mktemp("example")
    source = tmp_path_factory.mktemp("source") / "plugin"
    subprocess.run(
        [sys.executable, "-c", "import shutil, sys; shutil.copytree(sys.argv[1], sys.argv[2])",
         str(checkout / "examples" / "plugin"), str(source)],
        check=True,
    )  # fmt: skip
    where = [
        "--offline",
        "--no-deps",
        "--no-build-isolation",
        "--python",
        sys.executable,
        "--target",
        str(folder),
    ]
    subprocess.run(
        [sys.executable, "-m", "uv", "pip", "install", "--quiet", *where, str(source)],
        check=True,
        timeout=300,
    )
    return folder


def test_both_entries_are_loaded(example: Path) -> None:
    done = installed.command(example, "list", "plugins", "--json")
    rows = {row["name"]: row for row in json.loads(done.stdout)["plugins"]}
    assert {name: (row["group"], row["state"]) for name, row in rows.items()} == {
        "velvet": ("brdf_suite.models", "loaded"),
        "paint_list": ("brdf_suite.palette_formats", "loaded"),
    }
    assert done.stderr == ""


def test_the_model_passes_the_checks_of_models(example: Path) -> None:
    done = installed.command(example, "check", "velvet")
    assert done.returncode == 0, done.stderr
    assert "velvet: held" in done.stdout


def test_the_palette_format_is_read_and_written(example: Path, tmp_path: Path) -> None:
    path, other, back = tmp_path / "a.paintlist", tmp_path / "a.ase", tmp_path / "b.paintlist"
    path.write_text("paintlist 1\nff8000 Orange\n004080 Night\n", encoding="utf-8")
    for source, target in ((path, other), (other, back)):
        done = installed.command(example, "palette", "convert", source, "-o", target)
        assert done.returncode == 0, done.stderr
    assert back.read_bytes() == path.read_bytes()
    path.write_text("paintlist 1\nff80 Orange\n", encoding="utf-8")
    done = installed.command(example, "palette", "info", path)
    assert done.returncode == 1
    assert "at line 2" in done.stderr


def test_every_check_of_the_registered_holds_for_the_example(checkout: Path, example: Path) -> None:
    """The tests that go over all models and all palette formats, with the example among them."""
    wanted = [
        "tests/reflectance/models/test_registry.py",
        "tests/files/palettes/test_formats.py",
        "examples/plugin/tests",
    ]
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            "-k",
            "(velvet or paint_list or test_plugin) and not every_real",
            *wanted,
        ],
        env=installed.environment(example),
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
        cwd=checkout,
    )
    assert done.returncode == 0, done.stdout
    assert "passed" in done.stdout


def test_its_parameters_are_sliders_in_the_window(example: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(Path(__file__).with_name("example_window.py"))],
        env=installed.environment(example),
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr
    seen = json.loads(done.stdout.splitlines()[-1])
    assert seen["listed"] == ["Velvet (example plug-in)"]
    assert seen["rows"] == {"sheen": 0.6, "width": 0.5}
    # Dragged from 0.6 to the right end, all light is the fibres', which are white.
    assert seen["after"]["sheen"] == pytest.approx(1.0)
    assert seen["red_before"] > 1.5 * seen["green_before"]
    assert seen["red_after"] == pytest.approx(seen["green_after"])
