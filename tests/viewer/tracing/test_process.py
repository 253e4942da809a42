"""The process that traces: what it does with requests, and what the window hears when it cannot or dies."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from brdf_viewer.tracing.job import TracedFrame
from brdf_viewer.tracing.picture_slots import SLOTS, take
from brdf_viewer.tracing.process import WORKER, TraceProcess
from brdf_viewer.tracing.request import TraceRequest
from brdf_viewer.tracing.scene_files import (
    read_environment_file,
    read_surface_file,
    write_environment,
    write_surface,
)
from brdf_viewer.tracing.worker import Worker

from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, ReferenceUnavailableError
from brdf_suite.lighting.environment import Environment
from brdf_suite.processes import child_command
from brdf_suite.surface.mesh import Mesh, PartGeometry

ENVIRONMENT = Environment("dim", np.full((8, 16, 3), 0.5, np.float32), ("a note",))
CORNERS = np.eye(3, dtype=np.float32)
FACET = Mesh(
    "facet",
    tuple(
        PartGeometry(
            name, "paint", CORNERS, np.tile([0.0, 0.0, 1.0], (3, 1)), CORNERS[:, :2], np.array([[0, 1, 2]])
        )
        for name in ("hood", "door")
    ),
)


def request_in(folder: Path, generation: int = 1, **fields) -> TraceRequest:
    request = TraceRequest(
        generation,
        "reference",
        "fast",
        View(rotation_deg=30.0),
        (6, 4),
        "blue",
        write_environment(ENVIRONMENT, folder),
        write_surface(FACET, folder, 1),
    )
    return replace(request, **fields)


def test_a_request_and_its_scene_come_over_whole(tmp_path) -> None:
    request = request_in(tmp_path, samples=64)
    assert TraceRequest.from_json(json.loads(json.dumps(request.to_json()))) == request
    light = read_environment_file(request.environment)
    assert (light.content_hash, light.name, light.notes) == (ENVIRONMENT.content_hash, "dim", ("a note",))
    mesh = read_surface_file(request.surface)
    assert [(p.name, p.material) for p in mesh.parts] == [("hood", "paint"), ("door", "paint")]
    for part in mesh.parts:
        assert (part.positions == CORNERS).all()
        assert (part.triangles == [[0, 1, 2]]).all()
    written = request.environment.stat().st_mtime_ns
    assert write_environment(ENVIRONMENT, tmp_path).stat().st_mtime_ns == written
    assert sorted(path.name[:5] for path in tmp_path.iterdir()) == ["light", "surfa"]
    request.surface.write_bytes(b"nothing")
    with pytest.raises(FileError, match="no scene of this program"):
        read_surface_file(request.surface)


class Job:
    """Gives frames of 1, 2, 3 … samples, each of one grey."""

    title, notices, no_denoiser = "a renderer", ("It leaves something out.",), ""

    def __init__(self, request: TraceRequest) -> None:
        self.request = request

    def frames(self):
        width, height = self.request.size
        for samples in range(1, 100):
            pixels = np.full((height, width, 4), float(samples), np.float32)
            yield TracedFrame(pixels, samples, 0, 1.0 / samples, 0.1 * samples)

    def denoise_picture(self, pixels: np.ndarray) -> np.ndarray:
        return -pixels

    def save(self, path: Path, view: View) -> None:
        path.write_text(f"{view.rotation_deg:g}")


class Engines:
    def __init__(self, refused: Exception | None = None) -> None:
        self.opened: list[int] = []
        self.refused = refused

    def open(self, request: TraceRequest, progress=None) -> Job:
        if self.refused is not None:
            raise self.refused
        self.opened.append(request.generation)
        progress(0.5, "half of it")
        return Job(request)


class Inbox:
    """Hands out one list of messages each time that it is asked, and ends when all are gone."""

    def __init__(self, *turns: list[dict]) -> None:
        self.turns = list(turns)
        self.closed = False

    def take(self, *, wait: bool) -> list[dict]:
        if self.turns:
            return self.turns.pop(0)
        self.closed = True
        return []


def answers(folder: Path, engines: Engines, *turns: list[dict]) -> list[dict]:
    said: list[dict] = []
    Worker(folder, Inbox(*turns), said.append, engines).run()
    return said


def pictures(said: list[dict]) -> list[int]:
    return [answer["samples"] for answer in said if answer["say"] == "picture"]


def test_the_newest_request_is_traced_alone_and_no_picture_is_written_over(tmp_path) -> None:
    engines = Engines()
    first, second = (request_in(tmp_path, number).to_json() for number in (1, 2))
    taken = [{"do": "taken", "slot": 0}]
    said = answers(tmp_path, engines, [first, second], [], [], [], [], taken, [])
    assert engines.opened == [2]
    assert [answer["say"] for answer in said[:2]] == ["moved", "opened"]
    assert said[1]["notices"] == ["It leaves something out."]
    # Two slots are full with the first and the second; the fourth is the newest when one is given back.
    assert pictures(said) == [1, 2, 4]
    assert [answer["slot"] for answer in said if answer["say"] == "picture"] == [0, 1, 0]
    assert (take(tmp_path, 0, (6, 4)) == 4.0).all()
    assert SLOTS == 2
    with pytest.raises(ValueError, match="reshape"):
        take(tmp_path, 0, (5, 5))


def test_it_stops_at_the_samples_asked_for_and_goes_on_when_reported(tmp_path) -> None:
    start = request_in(tmp_path, samples=2).to_json()
    back = [{"do": "taken", "slot": 0}, {"do": "taken", "slot": 1}]
    said = answers(
        tmp_path, Engines(), [start], [], [], [], back, [{"do": "resume", "samples": 3}, *back], [], [], []
    )
    assert pictures(said) == [1, 2, 3]
    assert [answer["done"] for answer in said if answer["say"] == "picture"] == [False, True, True]
    assert {answer["of"] for answer in said if answer["say"] == "picture"} == {2, 3}
    said = answers(tmp_path, Engines(), [request_in(tmp_path).to_json()], [], [{"do": "pause"}], [], [])
    assert pictures(said) == [1]


def test_the_noise_is_taken_out_when_asked_and_put_back(tmp_path) -> None:
    off, on = ({"do": "denoise", "on": value} for value in (False, True))
    start = request_in(tmp_path, samples=1, denoised=True).to_json()
    said = answers(tmp_path, Engines(), [start], [], [off], [{"do": "taken", "slot": 0}], [on], [])
    assert [a["denoised"] for a in said if a["say"] == "picture"] == [True, False, True]
    assert pictures(said) == [1, 1, 1]
    assert (take(tmp_path, 0, (6, 4)) == -1.0).all()
    assert (take(tmp_path, 1, (6, 4)) == 1.0).all()


def test_what_fails_is_reported_with_its_generation_and_the_next_request_is_taken(tmp_path) -> None:
    engines = Engines(ReferenceUnavailableError("install this"))
    said = answers(tmp_path, engines, [request_in(tmp_path, 7).to_json()], [], [])
    assert said == [{"say": "failed", "generation": 7, "text": "install this"}]
    for error, words in ((MemoryError(), "not enough memory"), (ZeroDivisionError("x"), "nternal error")):
        (reported,) = answers(tmp_path, Engines(error), [request_in(tmp_path, 7).to_json()], [])
        assert words in reported["text"]


def test_the_newest_picture_is_saved_in_the_view_of_the_moment(tmp_path) -> None:
    request = request_in(tmp_path).to_json()
    save = {"do": "save", "path": str(tmp_path / "a.exr"), "view": request["view"]}
    said = answers(tmp_path, Engines(), [save], [request], [save], [])
    assert [(a["say"], a["path"]) for a in said if "path" in a] == [
        ("not_saved", str(tmp_path / "a.exr")),
        ("saved", str(tmp_path / "a.exr")),
    ]
    assert (tmp_path / "a.exr").read_text() == "30"


@pytest.fixture
def run(qtbot):
    """Start a process of the window's; it is ended after the test."""
    made: list[TraceProcess] = []

    def start(*program: str) -> TraceProcess:
        process = TraceProcess(program=program and (sys.executable, *program))
        made.append(process)
        process.start()
        return process

    yield start
    for process in made:
        process.end()
        assert not process.folder.exists()


def test_a_crash_is_reported_with_its_last_words(run, qtbot) -> None:
    dies = "import os, sys; sys.stdin.readline(); print('LLVM ERROR: no', file=sys.stderr, flush=True); os.abort()"
    process = run("-c", dies)
    with qtbot.waitSignal(process.crashed) as crash:
        process.send({"do": "render"})
    assert "LLVM ERROR: no" in crash.args[0]
    assert f"signal {int(signal.SIGABRT)}" in crash.args[0]
    process.send({"do": "render"})  # no process is there to receive it
    ends = run("-c", "raise SystemExit(3)")
    with qtbot.waitSignal(ends.crashed) as crash:
        pass
    assert "status 3" in crash.args[0]
    assert "out of memory" in crash.args[0]


def test_a_process_that_was_reported_to_end_has_not_crashed(run, qtbot) -> None:
    process = run(
        "-c", 'import sys; print(\'{"say": "saved", "path": "here"}\', flush=True); sys.stdin.read()'
    )
    crashes: list[str] = []
    process.crashed.connect(crashes.append)
    with qtbot.waitSignal(process.saved) as ready:
        pass
    assert ready.args == ["here"]
    process.end()
    qtbot.wait(0)
    assert crashes == []


HIDDEN = (
    "import runpy, sys; sys.modules['mitsuba'] = None; "
    "runpy.run_module('brdf_viewer.tracing.worker', run_name='__main__')"
)


@pytest.mark.parametrize("missing", ["extra", "llvm"])
def test_what_is_missing_is_named_and_the_process_lives_on(run, qtbot, monkeypatch, missing) -> None:
    if missing == "llvm":
        pytest.importorskip("mitsuba")
        if Path("/proc/driver/nvidia/version").exists():
            pytest.skip("this machine renders on its graphics card, without LLVM")
        monkeypatch.setenv("DRJIT_LIBLLVM_PATH", "/nowhere/libLLVM-15.so.1")
    process = run("-c", HIDDEN) if missing == "extra" else run()
    for generation in (1, 2):
        with qtbot.waitSignal(process.failed) as failure:
            process.send(request_in(process.folder, generation).to_json())
        assert failure.args[0] == generation
        words = (
            "needs Mitsuba, which is not installed" if missing == "extra" else "libLLVM-15.so.1 is LLVM 15"
        )
        assert words in failure.args[1]


def test_it_ends_with_whoever_asked_it_and_leaves_nothing(tmp_path) -> None:
    folder = tmp_path / "scene"
    folder.mkdir()
    done = subprocess.run(child_command(WORKER, str(folder)), input=b"", capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    assert not folder.exists()
