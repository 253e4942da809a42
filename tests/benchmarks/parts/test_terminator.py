"""Where a hard light grazes white paint, the picture is as bright as the integral."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.cli.tools.bench import load_module

terminator = load_module(Path(__file__).resolve().parent / "terminator.py")


@pytest.mark.usefixtures("shared_cache")
def test_a_grazing_sun_lights_white_paint_as_the_integral_does() -> None:
    found = terminator.run(paints=("solid_white",), count=24)
    assert found["terminator_median"] <= 0.01
    # The diffuse term is fitted to all angles, and is 3.6 % below what the paint reflects beyond γ = 105°.
    assert found["terminator_worst"] <= 0.045
