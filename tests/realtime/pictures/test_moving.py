"""Frames of a movement: smaller where whole ones would be slow, whole at rest."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.realtime.pictures.moving import BUDGET_MS, STEPS, WHOLE, Enlarger, Pace


def test_slow_frames_get_coarser_only_while_something_moves() -> None:
    pace = Pace()
    assert pace.begin_frame() is WHOLE
    pace.end_frame(16.0 * BUDGET_MS)
    assert pace.coarseness is WHOLE
    pace.move()
    half = pace.begin_frame()
    assert (half.scale, half.samples) == (0.5, 0)
    for _ in range(2):  # as expected
        pace.end_frame(16.0 * BUDGET_MS * half.cost)
        assert pace.begin_frame() is half
    assert pace.coarseness is half
    assert pace.rest()
    assert pace.begin_frame() is WHOLE
    assert not pace.rest()


def test_the_first_frame_of_a_large_surface_is_coarse_where_whole_ones_are_slow() -> None:
    pace = Pace()
    pace.arrive(1_000_000)  # nothing is known yet
    assert pace.begin_frame() is STEPS[-1]
    assert pace.begin_frame() is WHOLE
    pace.end_frame(BUDGET_MS)
    pace.arrive(10_000)
    assert pace.begin_frame() is WHOLE
    pace.arrive(1_000_000)
    assert pace.begin_frame() is STEPS[-1]
    assert pace.begin_frame() is WHOLE
    pace.want_whole()
    pace.arrive(1_000_000)
    assert pace.begin_frame() is WHOLE
    pace.end_frame(2.0)  # a graphics card
    pace.arrive(1_000_000)
    assert pace.begin_frame() is WHOLE


def test_fast_frames_stay_whole_and_sizes_do_not_alternate() -> None:
    pace = Pace()
    pace.move()
    pace.begin_frame()
    pace.end_frame(0.9 * BUDGET_MS)
    assert pace.begin_frame() is WHOLE
    pace.end_frame(1e6)
    assert pace.begin_frame() is STEPS[-1]
    pace.end_frame(1e6)  # the first with fewer samples
    assert pace.begin_frame() is STEPS[-1]
    # A finer one is taken only where it fits with room.
    pace.end_frame(0.95 * BUDGET_MS * STEPS[-1].cost / STEPS[-2].cost)
    assert pace.begin_frame() is STEPS[-1]
    pace.end_frame(0.6 * BUDGET_MS * STEPS[-1].cost / STEPS[-2].cost)
    assert pace.begin_frame() is STEPS[-2]
    assert [step.cost for step in STEPS] == sorted((step.cost for step in STEPS), reverse=True)


@pytest.mark.parametrize("whole_ms", [20.0, 70.0, 85.0, 310.0, 500.0, 1200.0, 3000.0])
def test_after_one_slow_frame_the_pace_finds_back(whole_ms: float) -> None:
    pace = Pace()
    pace.begin_frame()
    pace.end_frame(1e5)
    pace.move()
    for _ in range(4):
        step = pace.begin_frame()
        pace.end_frame(whole_ms * step.cost)
    coarsest = next((step for step in STEPS if 1.4 * whole_ms * step.cost <= BUDGET_MS), STEPS[-1])
    assert pace.coarseness.cost >= coarsest.cost
    assert pace.coarseness is STEPS[-1] or whole_ms * pace.coarseness.cost <= BUDGET_MS


def test_frames_that_say_nothing_do_not_count() -> None:
    pace = Pace()
    pace.end_frame(1e5)  # of a comparison, which was not begun here
    pace.move()
    assert pace.begin_frame() is WHOLE
    pace.end_frame(3.5 * BUDGET_MS)
    first = pace.begin_frame()
    assert first.samples == 0
    pace.end_frame(1e5)  # it compiled
    assert pace.begin_frame() is first
    pace.end_frame(1e5)
    assert pace.begin_frame() is STEPS[-1]
    assert pace.rest()
    assert not pace.rest()


@pytest.mark.parametrize("scale", [1.0, 0.5, 0.25])
def test_a_smaller_picture_fills_the_frame(renderer, scale: float) -> None:
    size = (64, 48)
    objects = renderer.objects
    texture = objects.texture(size, "f4")
    framebuffer = objects.framebuffer(texture)
    drawn = []

    def draw(target, wanted) -> None:
        drawn.append(wanted)
        objects.bind(target, wanted)
        target.clear(0.2, 0.4, 0.6, 1.0)
        target.clear(0.8, 0.4, 0.6, 1.0, viewport=(0, 0, wanted[0] // 2, wanted[1]))

    Enlarger(objects).draw(scale, framebuffer, size, draw)
    assert drawn == [(int(64 * scale), int(48 * scale))]
    found = np.frombuffer(texture.read(), np.float32).reshape(48, 64, 4)
    np.testing.assert_allclose(found[:, :28, 0], 0.8, atol=0.003)
    np.testing.assert_allclose(found[:, 36:, 0], 0.2, atol=0.003)
    np.testing.assert_allclose(found[..., 1], 0.4, atol=0.003)
    np.testing.assert_allclose(found[..., 2], 0.6, atol=0.003)
