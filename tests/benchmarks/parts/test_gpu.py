"""The benchmark of graphics cards, small, on whatever draws here; and that a software renderer publishes nothing."""

from __future__ import annotations

from pathlib import Path

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.pipeline.picture import gl_renderer_name

gpu = load_module(Path(__file__).parents[1] / "bench_gpu.py")


def test_every_case_is_timed() -> None:
    found = gpu.measure({"small": (48, 27), "wide": (64, 36)}, 1, 12)
    assert set(found) == set(gpu.BOUNDS)
    assert all(value is not None and value > 0.0 for value in found.values())
    assert {tuple(row) for row in gpu.TABLES.values()} == {("small", "wide")}
    assert gl_renderer_name() in gpu.appendix()


def test_a_software_renderer_has_no_figures() -> None:
    found = gpu.run()
    if "llvmpipe" in gl_renderer_name():
        assert set(found.values()) == {None}
        assert all("no graphics card" in gpu.NOTES[key] for key in gpu.BOUNDS)
    else:
        assert None not in found.values()
