"""The comparison that docs/method/shading.md quotes runs, and its order holds on one paint and one environment."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.cli.tools.bench import load_module

compare_look_ups = load_module(Path(__file__).resolve().parent / "compare_look_ups.py")


@pytest.mark.usefixtures("shared_cache")
def test_the_default_is_nearest_to_direct_integration(capsys) -> None:
    errors, names = compare_look_ups.compare(["overcast"], ["copper", "teal_violet_shift"], count=30)
    assert names == ["copper"]  # the other was read under two lights
    mean = {form: values[0, 0] for form, values in errors.items()}
    paper, at_mirror, shifted, table, default, several, exact, crossing = mean.values()
    assert table < shifted < at_mirror < paper
    assert default < 0.5 * table
    assert several < table
    assert crossing <= default
    assert (
        abs(exact - table) < 0.5 * table
    )  # the look-up itself errs less than the lobes' ignorance of the coat
    compare_look_ups.show("one paint", errors, names)
    assert "least-squares table (default)" in capsys.readouterr().out
