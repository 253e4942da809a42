"""Plug-ins that are broken in every way: named and skipped, and what is built in works on."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path

import pytest

_spec = importlib.util.spec_from_file_location("installed", Path(__file__).with_name("installed.py"))
installed = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(installed)

MODELS, PALETTES = "brdf_suite.models", "brdf_suite.palette_formats"
MEASURED, EXPORTS = "brdf_suite.measured_formats", "brdf_suite.exports"


@pytest.fixture(scope="module")
def broken(tmp_path_factory) -> Path:
    """A folder with one package of good and bad entries, and packages that cannot be imported."""
    folder = tmp_path_factory.mktemp("packages")
    code = """
def fail(*_):
    raise RuntimeError("out of ink")

class Bare:
    pass

@dataclass(frozen=True)
class Fails(Flat):
    def eval(self, wi, wo):
        return 1 / 0

@dataclass(frozen=True)
class Short(Flat):
    def eval(self, wi, wo):
        return np.zeros(3)

good = model("flat")
clash = model("lambertian")
twice = model("flat")
capital = model("Flat Paint")
text = "no entry"
unmade = model("unmade", fail)
bare = model("bare", Bare)
fails = model("fails", Fails)
short = model("short", Short)
nosy = palette("nosy", sniff=fail)
odd = palette("odd", read=fail)
lame = palette("lame", sniff=lambda head, size: head.startswith(b"LAME"), read=lambda content, path: None)
ending = palette("ending", read=fail, endings=("odd",))
uncallable = palette("uncallable", sniff=3, read=fail)
report = ExportFormat("pdf", "PDF", ".pdf", "x", lambda item: (), lambda items, path, progress: ())
silent = ExportFormat("silent", "Silent", ".silent", "x", lambda item: (), fail)
meter = MeasuredFormat("meter", "Meter", (".meter",), lambda head, size: head.startswith(b"METER"), fail)
"""
    groups = {
        MODELS: {
            name: name
            for name in (
                "good",
                "clash",
                "twice",
                "capital",
                "text",
                "unmade",
                "bare",
                "fails",
                "short",
                "gone",
            )
        },
        PALETTES: {name: name for name in ("nosy", "odd", "lame", "ending", "uncallable")},
        MEASURED: {"meter": "meter"},
        EXPORTS: {"report": "report", "silent": "silent"},
    }
    installed.install(folder, "colours", code, groups)
    for name, line in (
        ("raises", "raise ValueError('not today')"),
        ("leaves", "raise SystemExit(3)"),
        ("torn", "def ("),
    ):
        installed.install(folder, name, line, {MODELS: {name: "x"}})
    return folder


def test_each_is_listed_with_why_it_is_skipped(broken: Path) -> None:
    done = installed.command(broken, "list", "plugins", "--json")
    assert done.returncode == 0, done.stderr
    state = {row["name"]: row["state"] for row in json.loads(done.stdout)["plugins"]}
    assert {name for name, one in state.items() if one == "loaded"} == {
        *("good", "unmade", "bare", "fails", "short", "nosy", "odd", "lame", "silent", "meter")
    }
    for name, reason in {
        "clash": "the name lambertian is taken",
        "twice": "the name flat is taken",
        "capital": "'Flat Paint' cannot be used",
        "text": "expected a ModelEntry, not str",
        "gone": "AttributeError",
        "raises": "ValueError: not today",
        "leaves": "SystemExit: 3",
        "torn": "SyntaxError",
        "ending": "its endings cannot be used",
        "uncallable": "sniff: expected a function, not int",
        "report": "the name pdf is taken",
    }.items():
        assert state[name].startswith("skipped: "), name
        assert reason in state[name]
        assert f"plug-in {name} (" in done.stderr


def test_what_is_built_in_keeps_its_name(broken: Path) -> None:
    done = installed.command(broken, "check", "lambertian", "--json")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    found = report[0] if isinstance(report, list) else report
    assert found["albedo"][0]["directional_albedo"] == pytest.approx([0.8, 0.5, 0.2], abs=0.01)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("unmade", "RuntimeError: out of ink"),
        ("bare", "expected a dataclass with eval(), parameters"),
        ("fails", "ZeroDivisionError"),
        ("short", "its values have the shape (3,)"),
    ],
)
def test_a_model_that_fails_is_named_by_one_line(broken: Path, name: str, reason: str) -> None:
    done = installed.command(broken, "fit", name)
    assert done.returncode == 1
    assert "Traceback" not in done.stderr
    assert f"plug-in {name} (colours 1.0" in done.stderr or "plug-in" in done.stderr
    assert reason in done.stderr


def test_a_model_beside_broken_ones_works(broken: Path) -> None:
    done = installed.command(broken, "check", "flat")
    assert done.returncode == 0, done.stderr
    assert "flat: held" in done.stdout


def test_palettes_are_read_past_a_format_that_fails(broken: Path, tmp_path: Path) -> None:
    path = tmp_path / "a.gpl"
    path.write_text("GIMP Palette\nName: A\n#\n255 0 0 Red\n", encoding="utf-8")
    done = installed.command(broken, "palette", "info", path)
    assert done.returncode == 0, done.stderr
    assert "Red" in done.stdout
    assert "plug-in nosy" in done.stderr


@pytest.mark.parametrize(("head", "reason"), [("ODD", "out of ink"), ("LAME", "expected (palette, notes)")])
def test_a_palette_whose_reader_fails_is_refused(
    broken: Path, tmp_path: Path, head: str, reason: str
) -> None:
    path = tmp_path / "a.odd"
    path.write_text(f"{head} \1\n", encoding="utf-8")
    done = installed.command(broken, "palette", "info", path)
    assert done.returncode == 1
    assert reason in done.stderr
    assert "Traceback" not in done.stderr


def test_a_measured_file_and_an_export_that_fail_are_refused(broken: Path, tmp_path: Path) -> None:
    path = tmp_path / "a.meter"
    path.write_text("METER", encoding="utf-8")
    for words in (("fit", path), ("export", "blue", "-o", tmp_path / "a.silent")):
        done = installed.command(broken, *words)
        assert done.returncode == 1
        assert "RuntimeError: out of ink" in done.stderr
        assert "Traceback" not in done.stderr
