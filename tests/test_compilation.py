"""Kernels are compiled also where nothing can be kept."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from brdf_suite.compilation import compiled


def test_a_kernel_works_without_a_place_to_be_kept() -> None:
    names: dict[str, object] = {}
    exec("def doubled(x):\n    return 2.0 * x", names)  # of no file, so that numba finds no folder for it
    doubled = compiled(names["doubled"])  # type: ignore[type-var] # what exec made has no type
    assert doubled(3.0) == 6.0
    assert doubled.signatures


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="owners and modes are of POSIX")
@pytest.mark.parametrize(("mode", "is_kept"), [(0o700, True), (0o757, False)])
def test_no_kernel_is_loaded_from_a_folder_that_every_user_may_write_to(
    tmp_path: Path, mode: int, is_kept: bool
) -> None:
    source = tmp_path / "doubling.py"
    source.write_text("def doubled(x):\n    return 2.0 * x\n")
    cache = tmp_path / "__pycache__"
    cache.mkdir()
    cache.chmod(mode)
    names: dict[str, Any] = {"__name__": "doubling", "__file__": str(source)}
    exec(compile(source.read_text(), str(source), "exec"), names)
    doubled = compiled(names["doubled"])
    assert doubled(3.0) == 6.0
    assert bool(list(cache.iterdir())) is is_kept
