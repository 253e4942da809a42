"""Passes: their mean and variance, budgets, cancelling, and going on from a file."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.output import STAGE_END
from brdf_suite.documents.view import View
from brdf_suite.errors import Cancelled, FileError, ReferenceUnavailableError
from brdf_suite.files.images.exr.image import read_exr
from brdf_suite.tracing.reference import picture as module
from brdf_suite.tracing.reference.picture import render_reference

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (24, 20)


@pytest.fixture(scope="module")
def view(small_light: str) -> View:
    return View(surface="sphere", environment=small_light)


def numbers(rng: np.random.Generator, passes: int):
    from brdf_suite.reference.passes import Estimate

    found = Estimate.nothing(SIZE)
    shape = (SIZE[1], SIZE[0])
    all_passes = rng.random((passes, *shape, 3))
    for radiance in all_passes:
        found = found.with_pass(radiance, np.ones(shape), 4, 0.5)
    return found, all_passes


def test_mean_and_variance_are_those_of_the_passes() -> None:
    found, passes = numbers(np.random.default_rng(1), 7)
    np.testing.assert_allclose(found.radiance, passes.mean(axis=0), rtol=1e-12)
    np.testing.assert_allclose(found.variance, passes.var(axis=0, ddof=1) / 7, rtol=1e-9)
    assert (found.samples, found.passes, found.seconds) == (28, 7, 3.5)
    # The same samples in passes of other sizes: the mean of all samples, and a variance of the same size.
    noise = np.random.default_rng(3).normal(size=(30, SIZE[1], SIZE[0], 3))
    from brdf_suite.reference.passes import Estimate

    uneven = Estimate.nothing(SIZE)
    for first, count in ((0, 1), (1, 1), (2, 2), (4, 4), (8, 22)):
        uneven = uneven.with_pass(noise[first : first + count].mean(axis=0), np.ones(SIZE[::-1]), count, 0.1)
    np.testing.assert_allclose(uneven.radiance, noise.mean(axis=0), atol=1e-12)
    assert uneven.variance.mean() == pytest.approx(1.0 / 30.0, rel=0.1)
    one, _ = numbers(np.random.default_rng(1), 1)
    assert np.isinf(one.variance).all()


def test_an_estimate_in_a_file_is_the_same_again(tmp_path: Path) -> None:
    from brdf_suite.reference.estimate_file import read_estimate, write_estimate

    found, _ = numbers(np.random.default_rng(2), 3)
    path = tmp_path / "a.exr"
    write_estimate(path, found, 2.0 * found.radiance, "key")
    again = read_estimate(path, "key")
    assert again is not None
    assert (again.samples, again.passes, again.seconds) == (12, 3, 1.5)
    np.testing.assert_allclose(again.radiance, found.radiance, rtol=1e-6)
    np.testing.assert_allclose(again.variance, found.variance, rtol=1e-6)
    np.testing.assert_allclose(read_exr(path).pixels, 2.0 * found.radiance, rtol=1e-6)
    assert read_estimate(path, "another scene") is None
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(FileError, match="no render to resume from"):
        read_estimate(path, "key")


def test_a_cancelled_render_is_gone_on_from_and_gives_the_same_picture(view: View, tmp_path: Path) -> None:
    whole, parts = tmp_path / "whole.exr", tmp_path / "parts.exr"
    render_reference("copper", view, SIZE, whole, samples=32)

    def cancel(fraction: float, what: str) -> None:
        if "samples" in what and int(what.split()[0]) >= 16:
            raise Cancelled

    with pytest.raises(Cancelled):
        render_reference("copper", view, SIZE, parts, samples=32, progress=cancel)
    assert not parts.exists()
    kept = parts.with_name("parts.exr.part.exr")
    assert kept.exists()
    picture = render_reference("copper", view, SIZE, parts, samples=32)
    assert (picture.samples, picture.resumed_samples) == (32, 16)
    assert not kept.exists()
    np.testing.assert_allclose(read_exr(parts).pixels, read_exr(whole).pixels, rtol=2e-5, atol=1e-6)
    # Another scene does not go on from it; nor does one that is to begin anew.
    with pytest.raises(Cancelled):
        render_reference("copper", view, SIZE, parts, samples=32, progress=cancel)
    assert render_reference("blue", view, SIZE, parts, samples=16).resumed_samples == 0


def test_progress_rises_and_states_what_is_left(view: View, tmp_path: Path) -> None:
    reported: list[tuple[float, str]] = []
    picture = render_reference(
        "copper",
        view,
        SIZE,
        tmp_path / "a.png",
        samples=24,
        progress=lambda f, what: reported.append((f, what)),
    )
    shares = [share for share, _ in reported]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert any("s left" in what for _, what in reported)
    assert picture.samples == 24
    assert 0.0 < picture.noise < 2.0


def test_a_budget_of_time_ends_it(view: View, tmp_path: Path) -> None:
    """Whatever the machine does in that time: at least one pass, and no more than were asked for."""
    picture = render_reference("copper", view, SIZE, tmp_path / "a.png", seconds=0.01, samples=100_000)
    assert 1 <= picture.samples < 100_000


def test_names_that_no_picture_can_have_are_refused(view: View, tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"\.png or \.exr"):
        render_reference("copper", view, SIZE, tmp_path / "a.jpg")
    with pytest.raises(FileError, match="folder does not exist"):
        render_reference("copper", view, SIZE, tmp_path / "none" / "a.png")


def test_a_renderer_that_fails_is_reported_and_what_is_there_is_kept(
    view: View, tmp_path: Path, monkeypatch
) -> None:
    from brdf_suite.reference import passes

    real, count = passes.trace_pass, 0

    def failing(scene, samples, seed):
        nonlocal count
        count += 1
        if count > 2:
            raise MemoryError("no more memory")
        return real(scene, samples, seed)

    with monkeypatch.context() as patched:
        patched.setattr(
            passes.mi, "render", lambda *_args, **_more: (_ for _ in ()).throw(RuntimeError("out of memory"))
        )
        with pytest.raises(ReferenceUnavailableError, match="out of memory"):
            render_reference("copper", view, SIZE, tmp_path / "b.png", samples=8)
    monkeypatch.setattr(passes, "trace_pass", failing)
    with pytest.raises(ReferenceUnavailableError, match="make the picture smaller"):
        render_reference("copper", view, SIZE, tmp_path / "a.png", samples=64)
    assert (tmp_path / "a.png.part.exr").exists()


def test_without_mitsuba_the_command_says_what_to_install(tmp_path: Path, monkeypatch, capsys) -> None:
    from brdf_suite.cli.main import main
    from brdf_suite.reference import variant as variants

    variants.choose_variant.cache_clear()
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    code = main(["render", "copper", "--renderer", "reference", "-o", str(tmp_path / "a.png")])
    variants.choose_variant.cache_clear()
    assert code == 1
    lines = capsys.readouterr().err.strip().splitlines()
    reported = [line for line in lines if not line.endswith(STAGE_END)]
    assert len(reported) == 1
    assert "needs Mitsuba, which is not installed" in reported[0]
    assert module.DEFAULT_SAMPLES == 256
