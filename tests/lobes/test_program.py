"""Lobe Visualizer as a process, what the command line sets, and what is remembered."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys

import pytest
from brdf_lobe_visualizer import remembered
from brdf_lobe_visualizer.command_line import parser
from brdf_lobe_visualizer.script import apply_subjects, apply_view, incidence, shown
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from PySide6.QtGui import QImage

from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian

SLOW = {
    "brdf_suite.inspection.measuring",
    "brdf_suite.pipeline.scene",
    "brdf_suite.fitting.lobes.measured",
    "trimesh",
    "moderngl",
    "colour",
    "OpenImageIO",
    "scipy.optimize",
    "mitsuba",
    "superqt",
    "PIL",
}


def test_a_run_reports_its_start_imports_nothing_slow_and_saves_its_picture(tmp_path) -> None:
    """How long it takes is measured by ``brdf-suite bench startup``."""
    picture = tmp_path / "a.png"
    # The modules are looked at when the window has been painted, before a file is read.
    code = (
        "import sys; from brdf_lobe_visualizer import command_line as m; from brdf_lobe_visualizer import assembly;"
        "start = assembly.LobeVisualizer.start;"
        "assembly.LobeVisualizer.start = lambda self: (print(sorted(sys.modules)), start(self));"
        f"status = m.main(['lambertian', 'blue', '--theme', 'light', '--size', '900x600', '--report-startup',"
        "'--panels', 'numbers', '--plots', 'albedo,curves',"
        f"'--screenshot', {str(picture)!r}]); sys.exit(status)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    modules, times = done.stdout.splitlines()[0], json.loads(done.stdout.splitlines()[-1])
    assert set(modules.replace("'", "").strip("[]\n").split(", ")) & SLOW == set()
    assert 0.0 < times["ready_s"] < times["shown_s"] <= times["complete_s"]
    image = QImage(str(picture))
    assert (image.width(), image.height()) == (900, 600)


def test_the_command_line_sets_the_view_of_the_run(program) -> None:
    line = (
        "a b --incidence 60,90 --radius log --channel g --cosine none --show target,fit --plots albedo "
        "--panels numbers --set figures=errors --front 2 --reference 1 --no-inspector"
    )
    options = parser().parse_args(line.split(" "))
    assert options.reflectances == ["a", "b"]
    apply_view(program, options)
    session = program.session
    assert (session.incidence, session.options.radius, session.options.channel) == ((60.0, 90.0), "log", "g")
    assert (session.options.cosine, session.options.shown) == ("none", "both")
    assert program.window.plots.shown() == ("albedo",)
    assert program.numbers.panel.isVisible()
    assert program.window.inspector_dock.isHidden()
    program.window.inspector_dock.show()
    assert program.numbers.panel.buttons["errors"].isChecked()
    for name in ("A", "B"):
        program.sources.add(PlottedMaterial("", name, Material(name, Lambertian((0.5, 0.5, 0.5)))))
    apply_subjects(program, options)
    assert (session.front.title, session.reference.title) == ("B", "A")


def test_an_option_that_no_view_has_is_refused(program) -> None:
    with pytest.raises(SystemExit, match="no view has this option"):
        apply_view(program, parser().parse_args(["--set", "nothing=1"]))


@pytest.mark.parametrize(
    ("text", "found"), [("45,0", (45.0, 0.0)), ("0", (0.0, 0.0)), ("12.5,-90", (12.5, -90.0))]
)
def test_an_incidence_is_read(text, found) -> None:
    assert incidence(text) == found


@pytest.mark.parametrize("text", ["90,0", "-1,0", "a,b", "1,2,3", "10,400", ""])
def test_what_is_no_incidence_is_refused(text) -> None:
    with pytest.raises(argparse.ArgumentTypeError):
        incidence(text)


def test_what_is_shown_is_read() -> None:
    assert [shown(text) for text in ("target", "fit,target", "side-by-side", "difference")] == [
        "target",
        "both",
        "side by side",
        "difference",
    ]
    with pytest.raises(argparse.ArgumentTypeError):
        shown("everything")


def test_the_view_is_remembered_and_nonsense_is_not(program) -> None:
    from brdf_qt.program.settings import settings

    session = program.session
    session.set_incidence(30.0, 60.0)
    session.set_options(radius="log", channel="r", cosine="both", shown="both")
    program.window.close()
    program.window.show()
    session.reset_options()
    session.reset_incidence()
    remembered.recall(session, program.window)
    assert (session.incidence, session.options.radius, session.options.cosine) == (
        (30.0, 60.0),
        "log",
        "both",
    )
    before = session.options
    for stored in ("no json", "[1]", '{"radius": "huge", "incidence": [1e9, "x"], "channel": ["r"]}'):
        settings().setValue("lobes/view", stored)
        remembered.recall(session, program.window)
        assert session.options == before


def test_one_command_resets_the_view(program) -> None:
    program.session.set_incidence(10.0, 20.0)
    program.session.set_options(radius="linear")
    program.window.findChild(object, "action_Reset View Options").trigger()
    assert program.session.incidence == (45.0, 0.0)
    assert program.session.options.radius == "cbrt"
