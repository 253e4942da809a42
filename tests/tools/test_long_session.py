"""The session that looks for growth names what grows, and runs the real programs."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "attack"))

from long_session import ROUNDS, faults, run_program, verdict


def samples(growth: dict[str, float]) -> list[dict[str, float]]:
    start = {"memory_mb": 100.0, "threads": 4.0, "gl_objects": 0.0}
    return [
        {key: value + growth.get(key, 0.0) * turn for key, value in start.items()} for turn in range(ROUNDS)
    ]


@pytest.mark.parametrize(
    ("growth", "scale", "wrong"),
    [
        ({}, 1.0, []),
        ({"memory_mb": 0.5}, 1.0, []),
        ({"memory_mb": 2.0}, 1.0, ["memory_mb"]),
        ({"memory_mb": 2.0}, 0.01, []),
        ({"threads": 1.0, "gl_objects": 1.0}, 1.0, ["threads", "gl_objects"]),
        ({"threads": 1.0, "gl_objects": 1.0}, 0.01, ["gl_objects"]),
        ({"threads": -0.1}, 1.0, []),
    ],
)
def test_what_grows_is_named(growth: dict[str, float], scale: float, wrong: list[str]) -> None:
    assert faults(verdict(samples(growth)), scale) == wrong


@pytest.mark.parametrize("program", ["designer", "swatch"])
def test_a_slice_of_the_day_leaves_no_more_than_before(program: str) -> None:
    held = run_program(program, 0.002, offscreen=True)
    assert len(held) == ROUNDS
    assert faults(verdict(held), 0.002) == []
