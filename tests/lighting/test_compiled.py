"""The compiled kernels: against plain numpy and the addition theorem, and what happens where there are none."""

import logging
import subprocess
import sys

import numpy as np
import pytest

from brdf_suite.errors import Cancelled
from brdf_suite.lighting.filter.harmonics import lobe_coefficients
from brdf_suite.lighting.filter.kernels import compilation as compiled
from brdf_suite.lighting.filter.lobe_filter import LobeFilter
from brdf_suite.lighting.latlong import fejer_weights, ring_angles


@pytest.fixture
def fresh(monkeypatch: pytest.MonkeyPatch) -> type:
    """Let this process know nothing about kernels, as at its start."""
    monkeypatch.setattr(compiled._State, "kernels", None)
    monkeypatch.setattr(compiled._State, "broken", False)
    monkeypatch.setattr(compiled._State, "process", None)
    return compiled._State


@pytest.mark.usefixtures("kernels_compiled")
@pytest.mark.parametrize(("rings", "columns"), [(257, 512), (300, 480), (256, 100)])
def test_kernels_give_what_plain_numpy_gives(rings: int, columns: int) -> None:
    """Odd rings, rings and columns of any ratio, fewer columns than orders."""
    pixels = np.random.default_rng(rings).random((rings, columns, 3)).astype(np.float32)
    pixels[rings // 3, 7] = 1e4
    fast, plain = LobeFilter(pixels), LobeFilter(pixels, plain=True)
    for exponent, size in ((2.0, 64), (700.0, 96), (2500.0, 130)):
        expected = plain.lobe(exponent, size)
        assert np.abs(fast.lobe(exponent, size) - expected).max() < 3e-7 * expected.max()
    assert np.abs(fast.background(34) - plain.background(34)).max() < 1e-3 * pixels.max()


@pytest.mark.usefixtures("kernels_compiled")
@pytest.mark.parametrize("degree", [1342, 2048])
def test_high_degrees_obey_the_addition_theorem(degree: int) -> None:
    """Σ_m |Y_lm|² = (2l+1)/4π for every direction, poles included, though single terms span 10^±300."""
    from brdf_suite.lighting.filter.harmonics import legendre_starts
    from brdf_suite.lighting.filter.kernels import legendre as compiled_legendre

    coefficients = np.zeros(((degree + 1) * (degree + 2) // 2, 6))
    for m in range(degree + 1):
        coefficients[compiled_legendre.order_start(m + 1, degree) - 1, 0] = 1.0
    orders = np.empty((2, 300, 3, degree // 2 + 1, 2))
    cosines = np.cos(ring_angles(300))[149::-1].copy()
    starts = legendre_starts(degree)
    compiled_legendre.synthesise_rings(
        coefficients, degree, np.ones(degree + 1), cosines, 0, starts, 0, degree + 1, orders
    )
    values = np.empty((300, degree + 1))
    values[:, ::2] = orders[0, :, 0, :, 0]
    values[:, 1::2] = orders[1, :, 0, : (degree + 1) // 2, 0]
    total = values[:, 0] ** 2 + 2.0 * (values[:, 1:] ** 2).sum(axis=1)
    assert np.abs(total * 4.0 * np.pi / (2 * degree + 1) - 1.0).max() < 1e-10


@pytest.mark.usefixtures("kernels_compiled")
def test_work_in_kernels_can_be_cancelled() -> None:
    kernels = compiled.compile_now()
    assert kernels is not None
    said: list[float] = []

    def cancel(fraction: float, what: str) -> None:
        said.append(fraction)
        if len(said) == 2:
            raise Cancelled

    pixels = np.ones((512, 1024, 3), dtype=np.float32)
    with pytest.raises(Cancelled):
        kernels.analyse(pixels, fejer_weights(512), 64, cancel)
    coefficients = kernels.analyse(pixels, fejer_weights(512), 64)
    said.clear()
    with pytest.raises(Cancelled):
        kernels.cube(coefficients, lobe_coefficients(80.0, 64), 64, cancel)
    assert len(said) == 2


def test_without_kernels_numpy_works_while_another_process_compiles(
    fresh: type, monkeypatch: pytest.MonkeyPatch, tmp_path
) -> None:
    monkeypatch.setattr(compiled, "_stamp", lambda module: tmp_path / "not there")
    started = []
    sleeper = [sys.executable, "-c", "import time; time.sleep(600)"]

    def start() -> subprocess.Popen[bytes]:
        started.append(subprocess.Popen(sleeper))
        return started[-1]

    monkeypatch.setattr(compiled, "_start", start)
    white = np.ones((256, 512, 3), dtype=np.float32)
    try:
        for _ in range(2):
            lobe_filter = LobeFilter(white)
            assert not lobe_filter.compiled
        assert len(started) == 1
        assert np.abs(lobe_filter.lobe(20.0, 64) - 1.0).max() < 1e-4
        (tmp_path / "not there").touch()
        assert LobeFilter(white).compiled
    finally:
        started[0].kill()
        started[0].wait()


def test_a_wait_says_what_it_waits_for_and_can_be_cancelled(
    fresh: type, monkeypatch: pytest.MonkeyPatch, tmp_path
) -> None:
    monkeypatch.setattr(compiled, "_stamp", lambda module: tmp_path / "not there")
    process = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
    monkeypatch.setattr(compiled, "_start", lambda: process)

    def cancel(fraction: float, what: str) -> None:
        assert "compiling" in what
        raise Cancelled

    try:
        with pytest.raises(Cancelled):
            compiled.kernels(cancel, wait=True)
    finally:
        process.kill()
        process.wait()


def test_a_compiler_that_fails_is_reported_once_and_not_asked_again(
    fresh: type, monkeypatch: pytest.MonkeyPatch, tmp_path, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(compiled, "_stamp", lambda module: tmp_path / "not there")
    process = subprocess.Popen([sys.executable, "-c", "raise SystemExit(1)"])
    monkeypatch.setattr(compiled, "_start", lambda: process)
    with caplog.at_level(logging.WARNING):
        assert compiled.kernels(wait=True) is None
        assert compiled.kernels(wait=True) is None
    assert len([r for r in caplog.records if "could not be compiled" in r.message]) == 1


def test_numba_is_not_imported_before_it_is_needed() -> None:
    code = (
        "import sys, brdf_suite.lighting.filter.lobe_maps, brdf_suite.lighting.lobe_map_cache, brdf_suite.cli.main;"
        "raise SystemExit('numba' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
