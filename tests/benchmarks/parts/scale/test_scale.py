"""``bench scale`` measures sizes in processes of their own, and states the exponents between them."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.cli.tools import bench
from brdf_suite.cli.tools.bench import appendix, load_module, measure

BENCHMARK = Path(__file__).parents[2] / "bench_scale.py"


@pytest.fixture
def scale():
    return load_module(BENCHMARK)


def test_every_cost_has_sizes_figures_and_a_cause(scale) -> None:
    assert scale.SIZES.keys() == scale.FIGURES.keys() == scale.WHY.keys()
    assert {f"{name}_exponent" for name in scale.SIZES} <= scale.BOUNDS.keys()
    for usual, large in scale.SIZES.values():
        assert len(usual) >= 2
        assert [*usual, *large] == sorted({*usual, *large})


@pytest.mark.parametrize("power", [0.0, 1.0, 2.0])
def test_the_exponent_is_that_of_the_growth(scale, power: float) -> None:
    measured = {size: {"cpu_s": 3e-6 * size**power} for size in (10, 1_000, 100)}
    assert scale.exponent("nodes", measured) == pytest.approx(power)
    # An environment of twice the width has four times the pixels.
    assert scale.exponent("environment", measured) == pytest.approx(power / 2.0)


def test_one_cost_is_measured_at_its_sizes(scale, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scale, "SIZES", {"nodes": ((20, 200), (400,))})
    scale.LARGE = True
    result = measure(scale, None)
    assert result.figures["nodes_10k_ms"] > 0.0
    assert result.figures["nodes_exponent"] is not None
    assert result.figures["tabs_close_s"] is None
    assert set(result.tables["nodes"]) == {"20", "200", "400"}
    assert "| nodes | 20: " in appendix(scale)


def test_large_sizes_are_refused_where_a_benchmark_has_none(capsys: pytest.CaptureFixture[str]) -> None:
    from brdf_suite.cli.main import main

    assert main(["bench", "fit", "--large"]) != 0
    assert "has no larger sizes" in capsys.readouterr().err
    assert bench.load_module(BENCHMARK).LARGE is False
