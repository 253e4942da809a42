"""Connected components are those of scipy, also in their order."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components as reference

from brdf_suite.geometry.closed_surface import connected_components


@pytest.mark.parametrize("edges", [0, 1, 20, 60, 300])
def test_components_are_those_of_scipy(edges: int) -> None:
    rng = np.random.default_rng(edges)
    first, second = rng.integers(0, 60, (2, edges))
    number, names = connected_components(60, first, second)
    graph = coo_array((np.ones(edges, np.int8), (first, second)), shape=(60, 60))
    wanted = reference(graph, directed=False)
    assert number == wanted[0]
    assert np.array_equal(names, wanted[1])


def test_no_node_is_no_component() -> None:
    assert connected_components(0, np.zeros(0, int), np.zeros(0, int))[0] == 0
