"""An environment is handed out as soon as it can be shown, and sharpens as its maps are made."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.errors import Cancelled
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.lobe_maps import PartialMaps, filtered_exponents, prefilter
from brdf_suite.pipeline.scene import STACK_EXPONENTS, PreparedEnvironment, load_environment, map_exponents

EXPONENTS = (5.0, 70.0, 3000.0, 60000.0)


@pytest.fixture
def light(tmp_path: Path) -> Path:
    rng = np.random.default_rng(3)
    path = tmp_path / "light.exr"
    write_exr(path, rng.random((64, 128, 3), np.float32))
    return path


def test_the_nearest_map_stands_in_for_one_that_is_not_there() -> None:
    rng = np.random.default_rng(3)
    environment = Environment("x", rng.random((256, 512, 3), np.float32))
    so_far = PartialMaps(environment, EXPONENTS)
    steps = []

    def ready(exponent, faces) -> None:
        so_far.add(exponent, faces)
        steps.append((so_far.made, so_far.maps()))

    whole = prefilter(environment, EXPONENTS, ready=ready)
    shown = [(made, maps) for made, maps in steps if maps is not None]
    assert so_far.wanted == len(filtered_exponents(environment, EXPONENTS)) + 1 == 5
    assert shown[0][0] == 4  # diffuse, two broad ones, the background: one sharp lobe is missing
    first = shown[0][1]
    assert first.diffuse is whole.diffuse
    assert first.background is whole.background
    assert [a is b for a, b in zip(first.lobes, whole.lobes, strict=True)] == [True, True, False, True]
    assert first.lobes[2] is whole.background  # 3,000 is nearer to the map's own 3,544 than to 70
    last = shown[-1][1]
    assert shown[-1][0] == so_far.wanted
    assert all(a is b for a, b in zip(last.lobes, whole.lobes, strict=True))


def test_the_first_picture_comes_before_the_sharp_lobes(tmp_path: Path) -> None:
    path = tmp_path / "light.exr"
    write_exr(path, np.random.default_rng(3).random((512, 1024, 3), np.float32))
    partial: list[PreparedEnvironment] = []
    final = load_environment(path, partial=partial.append)
    assert final.is_final
    assert not final.from_cache
    assert [p.missing for p in partial] == [2, 1]
    assert not any(p.is_final for p in partial)
    assert (
        {p.wanted for p in partial}
        == {final.wanted}
        == {len(filtered_exponents(final.environment, map_exponents())) + 1}
    )
    assert all(p.environment is final.environment for p in partial)
    # The broad lobes are final at once, the very arrays.
    assert partial[0].maps.lobes[: len(STACK_EXPONENTS)] == final.maps.lobes[: len(STACK_EXPONENTS)]
    assert partial[0].maps.background is final.maps.background


def test_nothing_partial_comes_from_the_cache(light: Path) -> None:
    partial: list[PreparedEnvironment] = []
    load_environment(light)
    again = load_environment(light, partial=partial.append)
    assert again.from_cache
    assert again.is_final
    assert partial == []


def test_cancelled_after_the_first_picture(tmp_path: Path) -> None:
    path = tmp_path / "light.exr"
    write_exr(path, np.random.default_rng(3).random((512, 1024, 3), np.float32))
    partial: list[PreparedEnvironment] = []

    def progress(_fraction: float, _what: str) -> None:
        if partial:
            raise Cancelled

    with pytest.raises(Cancelled):
        load_environment(path, progress, partial=partial.append)
    assert [p.missing for p in partial] == [2]
    assert not load_environment(path).from_cache
