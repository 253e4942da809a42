"""Kernels are compiled also where nothing can be kept."""

from __future__ import annotations

from brdf_suite.compilation import compiled


def test_a_kernel_works_without_a_place_to_be_kept() -> None:
    names: dict[str, object] = {}
    exec("def doubled(x):\n    return 2.0 * x", names)  # of no file, so that numba finds no folder for it
    doubled = compiled(names["doubled"])  # type: ignore[type-var] # what exec made has no type
    assert doubled(3.0) == 6.0
    assert doubled.signatures
