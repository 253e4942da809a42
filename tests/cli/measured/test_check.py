"""``brdf-suite check`` as a user runs it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.store import save_paint
from brdf_suite.reflectance import registry


def command(*arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "brdf_suite", "check", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )


def test_a_shipped_paint_in_words() -> None:
    done = command("blue")
    assert done.returncode == 0, done.stderr
    assert "Blue: held" in done.stdout
    assert "reciprocity" in done.stdout
    assert len([line for line in done.stdout.splitlines() if line.lstrip().startswith("45 ")]) == 1


def test_a_model_as_json() -> None:
    done = command("lambertian", "--json")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["passed"] is True
    assert {f["check"] for f in report["findings"]} == {
        "non_negativity",
        "reciprocity",
        "directional_albedo",
        "white_furnace",
    }
    for row in report["albedo"]:
        assert row["directional_albedo"] == pytest.approx([0.8, 0.5, 0.2], rel=1e-3)


def test_a_known_violator_is_reported_with_its_size() -> None:
    done = command("cosine_lobes", "--json")
    assert done.returncode == 0
    found = {f["check"]: f for f in json.loads(done.stdout)["findings"]}["reciprocity"]
    assert found["outcome"] == "known violator"
    assert found["size"] > 0.5
    assert "light at" in found["where"]


def test_a_file_that_makes_light_is_measured(tmp_path: Path) -> None:
    """kd = 1.5 sends back half as much again as arrives; the paint claims nothing, so it is reported, not refused."""
    path = tmp_path / "bright.brdfpaint"
    save_paint(CookTorrancePaint("bright", (1.5, 0.1, 0.1), (CookTorranceLobe((0, 0, 0), 0.1, 0.1),)), path)
    done = command(path, "--json")
    found = {f["check"]: f for f in json.loads(done.stdout)["findings"]}["directional_albedo"]
    assert found["outcome"] == "known violator"
    assert found["size"] == pytest.approx(0.5, abs=1e-3)


def test_a_table_1_paint_by_name() -> None:
    done = command("table1_ford_f8", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["name"] == "Ford F8"


def test_all_models_at_once(monkeypatch, capsys) -> None:
    """Each that is registered; the models themselves are checked in tests/reflectance, so two stand for all here."""
    monkeypatch.setattr(registry, "MODELS", {name: registry.MODELS[name] for name in ("phong", "coat")})
    assert main(["check", "--models", "--json"]) == 0
    assert {report["name"] for report in json.loads(capsys.readouterr().out)["reports"]} == {"phong", "coat"}


@pytest.mark.parametrize("arguments", [(), ("blue", "--models"), ("no_such_thing",)])
def test_what_cannot_be_checked_is_said_in_one_line(arguments: tuple[str, ...]) -> None:
    done = command(*arguments)
    assert done.returncode == 1
    assert len(done.stderr.strip().splitlines()) == 1
    assert done.stderr.startswith("brdf-suite: ")
