"""Ray-traced files: pictures that are gone on from, turntables frame by frame, and the command."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.cli.main import main
from brdf_suite.cli.output import STAGE_END
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.errors import Cancelled, FileError, ReferenceUnavailableError
from brdf_suite.files.images.exr.image import read_exr
from brdf_suite.output.turntable import Turn
from brdf_suite.reference.raytraced.quality import Quality
from brdf_suite.tracing.raytraced import file as raytraced_file
from brdf_suite.tracing.raytraced.file import render_raytraced
from brdf_suite.tracing.turntable import Budget, write_traced_turntable

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (24, 20)
FOUR = Quality(32, 4, 4)


@pytest.fixture(scope="module")
def view(small_light: str) -> View:
    return View(surface="sphere", environment=small_light, surface_look=SurfaceLook(ground=True))


def cancel_at(samples: int):
    """A progress callback that cancels once so many samples are reported."""

    def progress(_share: float, what: str) -> None:
        if "samples" in what and int(what.split()[0]) >= samples:
            raise Cancelled

    return progress


def test_sums_in_a_file_are_the_same_again(tmp_path: Path) -> None:
    from brdf_suite.reference.raytraced.picture import Sums, read_sums, write_sums

    rng = np.random.default_rng(1)
    sums = Sums(rng.random((5, 4, 7)), 3, 1.5)
    path = tmp_path / "a.exr"
    write_sums(path, sums, 2.0 * sums.radiance, "key")
    again = read_sums(path, "key")
    assert again is not None
    assert (again.samples, again.seconds) == (3, 1.5)
    np.testing.assert_allclose(again.values, sums.values, rtol=1e-6)
    np.testing.assert_allclose(read_exr(path).pixels, 2.0 * sums.radiance, rtol=1e-6)
    assert read_sums(path, "another") is None
    path.write_bytes(path.read_bytes()[:-60])
    with pytest.raises(FileError, match="no render to resume from"):
        read_sums(path, "key")


def test_a_cancelled_render_is_gone_on_from_and_gives_the_same_picture(
    view: View, tmp_path: Path, monkeypatch
) -> None:
    from brdf_suite.tracing.raytraced import picture as raytraced

    monkeypatch.setattr(raytraced, "PASS_SECONDS", 0.0)  # a sample a pass
    whole, parts = tmp_path / "whole.exr", tmp_path / "parts.exr"
    render_raytraced("copper", view, SIZE, whole, quality=FOUR, samples=6)
    kept = tmp_path / "parts.exr.raytraced.part.exr"
    with pytest.raises(Cancelled):
        render_raytraced("copper", view, SIZE, parts, quality=FOUR, samples=6, progress=cancel_at(3))
    assert kept.exists()
    assert not parts.exists()
    reported: list[tuple[float, str]] = []
    made = render_raytraced(
        "copper",
        view,
        SIZE,
        parts,
        quality=FOUR,
        samples=6,
        progress=lambda f, what: reported.append((f, what)),
    )
    assert (made.samples, made.resumed_samples, made.rounds) == (6, 3, 1.5)
    assert not kept.exists()
    np.testing.assert_allclose(read_exr(parts).pixels, read_exr(whole).pixels, rtol=1e-4, atol=1e-5)
    shares = [share for share, _ in reported]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert any("of 6 samples" in what for _, what in reported)
    # Another scene, or one that is to begin anew, does not go on from it.
    for paint, fresh in (("blue", False), ("copper", True)):
        with pytest.raises(Cancelled):
            render_raytraced("copper", view, SIZE, parts, quality=FOUR, progress=cancel_at(2))
        assert render_raytraced(paint, view, SIZE, parts, quality=FOUR, fresh=fresh).resumed_samples == 0


def test_a_budget_of_time_ends_it_after_a_pass(view: View, tmp_path: Path) -> None:
    made = render_raytraced(
        "copper", view, SIZE, tmp_path / "a.png", quality=FOUR, seconds=1e-3, samples=100_000
    )
    assert 1 <= made.samples < 100_000
    with Image.open(made.path) as picture:
        assert picture.size == SIZE
        assert "ray-traced with 32 lights" in picture.info["Description"]


def test_what_fails_is_reported_and_what_is_there_is_kept(view: View, tmp_path: Path, monkeypatch) -> None:
    from brdf_suite.reference.raytraced import frames
    from brdf_suite.tracing.raytraced import picture as raytraced

    with pytest.raises(FileError, match=r"\.png or \.exr"):
        render_raytraced("copper", view, SIZE, tmp_path / "a.jpg")
    with pytest.raises(FileError, match="folder does not exist"):
        render_raytraced("copper", view, SIZE, tmp_path / "none" / "a.png")
    monkeypatch.setattr(raytraced, "PASS_SECONDS", 0.0)
    real, calls = frames.trace, []

    def failing(*args, **more):
        calls.append(1)
        if len(calls) > 2:
            raise MemoryError("no more memory")
        return real(*args, **more)

    monkeypatch.setattr(frames, "trace", failing)
    with pytest.raises(ReferenceUnavailableError, match=r"no more memory.*smaller picture"):
        render_raytraced("copper", view, SIZE, tmp_path / "a.png", quality=FOUR)
    assert (tmp_path / "a.png.raytraced.part.exr").exists()

    def huge(_size):
        raise MemoryError

    with monkeypatch.context() as patched:
        patched.setattr(raytraced, "Film", huge)
        with pytest.raises(ReferenceUnavailableError, match="not enough memory to trace 24 × 20"):
            render_raytraced("copper", view, SIZE, tmp_path / "c.png", quality=FOUR)

    def wrong(*_args, **_more):
        raise RuntimeError("in a loop") from TypeError("a fault of the program")

    monkeypatch.setattr(frames, "trace", wrong)
    with pytest.raises(RuntimeError, match="in a loop"):
        render_raytraced("copper", view, SIZE, tmp_path / "b.png", quality=FOUR)


def test_remaining_time_is_reported_as_a_person_would() -> None:
    words = raytraced_file.duration_text
    assert [words(s) for s in (0.4, 99.0, 130.0, 7300.0)] == ["0 s", "99 s", "3 min", "2 h 2 min"]


@pytest.mark.parametrize("renderer", ["raytraced", "reference"])
def test_a_turntable_goes_on_from_its_finished_frames(small_light: str, tmp_path: Path, renderer) -> None:
    view = View(environment=small_light, exposure_mode="automatic")
    folder, turn, budget = tmp_path / "turn", Turn(3), Budget("fast", 1)

    def stop(_share: float, what: str) -> None:
        if what.startswith("frame 3"):
            raise Cancelled

    with pytest.raises(Cancelled):
        write_traced_turntable(renderer, "copper", view, SIZE, folder, turn, budget, progress=stop)
    kept = tmp_path / "turn.part"
    assert sorted(p.name for p in kept.glob("*.png")) == ["frame_0001.png", "frame_0002.png"]
    first = (kept / "frame_0001.png").read_bytes()
    assert not folder.exists()
    reported: list[str] = []
    made = write_traced_turntable(
        renderer, "copper", view, SIZE, folder, turn, budget, progress=lambda _f, what: reported.append(what)
    )
    assert not any(what.startswith("frame 1") for what in reported)
    assert made.frames == 3
    assert not kept.exists()
    assert sorted(p.name for p in folder.iterdir()) == [f"frame_000{k}.png" for k in (1, 2, 3)]
    assert (folder / "frame_0001.png").read_bytes() == first
    pictures = [np.asarray(Image.open(folder / f"frame_000{k}.png"), float) for k in (1, 2, 3)]
    assert np.abs(pictures[0] - pictures[1]).max() > 10.0
    with pytest.raises(FileError, match="not an empty folder"):
        write_traced_turntable(renderer, "copper", view, SIZE, folder, turn, budget)


def test_the_command(small_light: str, tmp_path: Path, capsys) -> None:
    target = tmp_path / "a.png"
    words = ["render", "copper", "-o", str(target), "--renderer", "raytraced", "--size", "24x20"]
    light = ["--mesh", "sphere", "--environment", small_light]
    words += light
    assert main([*words, "--quality", "fast", "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert (facts["lights"], facts["reflections"], facts["samples"]) == (16, 1, 1)
    assert target.stat().st_size > 200
    assert main([*words, "--spp", "2"]) == 0
    assert "128 lights, 16 reflected rays, 2 samples a pixel" in capsys.readouterr().out
    for more, said in (
        (["--bits", "16"], "With --renderer raytraced there is no --bits"),
        (["--transparent"], "With --renderer raytraced there is no --transparent"),
    ):
        assert main([*words, *more]) == 1
        assert said in capsys.readouterr().err
    for renderer, option in (("realtime", "--quality"), ("reference", "--quality")):
        assert main(["render", "copper", "-o", str(target), "--renderer", renderer, option, "fast"]) == 1
        assert f"With --renderer {renderer} there is no {option}" in capsys.readouterr().err
    turntable = ["turntable", "copper", "-o", str(tmp_path / "t"), "--size", "24x20", *light]
    assert main([*turntable, "--fresh"]) == 1
    assert "there is no --fresh" in capsys.readouterr().err
    turned = [*turntable, "--renderer", "raytraced", "--quality", "fast", "--frames", "2", "--json"]
    assert main(turned) == 0
    assert json.loads(capsys.readouterr().out)["frames"] == 2


def test_without_mitsuba_the_command_says_what_to_install(tmp_path: Path, monkeypatch, capsys) -> None:
    from brdf_suite.reference import variant as variants

    variants.choose_variant.cache_clear()
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    code = main(["render", "copper", "--renderer", "raytraced", "-o", str(tmp_path / "a.png")])
    variants.choose_variant.cache_clear()
    assert code == 1
    lines = capsys.readouterr().err.strip().splitlines()
    reported = [line for line in lines if not line.endswith(STAGE_END)]
    assert len(reported) == 1
    assert "needs Mitsuba, which is not installed" in reported[0]
