"""What goes wrong in hostile surroundings is seen: tracebacks, statuses, other answers, files that are not whole."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("resource", reason="memory limits are set through the Unix module resource")

from tools.attack.hostile.cases import CASES, run_cases
from tools.attack.hostile.environments import LOCALES, Answers, shell
from tools.attack.hostile.file_names import PALETTE, expect_palette
from tools.attack.hostile.scene import COMMAND, Scene, Surroundings


@pytest.fixture
def scene(tmp_path: Path) -> Scene:
    return Scene("a case", tmp_path, Surroundings())


def test_tracebacks_and_statuses_are_seen(scene: Scene) -> None:
    for expected in (False, None):
        scene.start(COMMAND, "list", "paints", fails=expected)
    assert scene.found.faults == {}
    scene.start(COMMAND, "measure", "none", "--verbose")  # which prints a traceback
    scene.start(COMMAND, "list", "paints", fails=True)
    scene.start(COMMAND, "measure", "none", fails=False)
    scene.start(COMMAND, "list", "paints", within=shell("exit 3"))
    scene.start(COMMAND, "list", "paints", within=shell("kill -9 $$"))
    faults = list(scene.found.faults.values())
    assert "Error" in faults[0]
    assert [text[:10] for text in faults[1:]] == ["status 0: ", "status 1: ", "status 3: ", "status -9:"]


def test_variables_are_changed_in_a_body_alone(scene: Scene) -> None:
    before = dict(scene.environment)
    with scene.changed({"HOME": None, "TZ": "nonsense"}):
        assert "HOME" not in scene.environment
        assert scene.environment["TZ"] == "nonsense"
    assert scene.environment == before


def test_other_answers_and_other_files_are_seen(scene: Scene) -> None:
    answers = Answers(scene)
    with scene.changed(LOCALES[3]):  # one that has no letters but those of ASCII
        answers.check("a locale")
    assert scene.found.faults == {}
    answers.check("another program", within=("true",))
    answers.check("a limit", fails=None, within=("true",), written=())
    texts = list(scene.found.faults.values())
    assert [text.split(":")[0] for text in texts] == ["another answer"] * 3 + ["another file"] * 2 + [
        "another answer"
    ] * 3


def test_a_palette_that_was_not_written_wholly_is_seen(scene: Scene) -> None:
    scene.documents("plain")
    file = scene.work / f"p{PALETTE}"
    expect_palette(scene, file, 2)
    assert scene.found.faults == {}
    expect_palette(scene, file, 3)
    expect_palette(scene, scene.work / "none", 2)
    assert len(scene.found.faults) == 2


def test_cases_are_chosen_by_the_beginnings_of_their_names(tmp_path: Path) -> None:
    said: list[str] = []
    assert run_cases(tmp_path, ["no such case"], said.append).processes == 0
    names = [case.name for case in CASES]
    assert len(set(names)) == len(names)
    assert {"closed streams", "links", "no home"} <= set(names)


@pytest.mark.parametrize("name", [case.name for case in CASES if case.in_slices])
def test_a_slice_of_hostile_surroundings(name: str, tmp_path: Path) -> None:
    tmp_path.chmod(0o755)
    found = run_cases(tmp_path, [name], print, brief=True)
    assert (found.faults, found.executions, found.local_files_shown) == ({}, 0, 0)
    assert found.processes >= 2
