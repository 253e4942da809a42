"""Connected components of a graph, in numpy alone: importing scipy's takes as long as reading a scene."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def connected_components(
    count: int, first: NDArray[np.integer], second: NDArray[np.integer]
) -> tuple[int, NDArray[np.intp]]:
    """Return how many components ``count`` nodes have, and the component (count,) of each, 0… by its first node.

    Edge i joins the nodes ``first[i]`` and ``second[i]``, each of them 0…count-1.

    >>> connected_components(5, np.array([4, 1]), np.array([0, 2]))
    (3, array([0, 1, 1, 2, 0]))
    """
    root = np.arange(count, dtype=np.intp)
    one, other = np.asarray(first, np.intp), np.asarray(second, np.intp)
    while len(one):
        one, other = root[one], root[other]
        apart = one != other
        one, other = one[apart], other[apart]
        np.minimum.at(root, np.maximum(one, other), np.minimum(one, other))
        while not np.array_equal(further := root[root], root):
            root = further
    names = np.cumsum(root == np.arange(count)) - 1
    return (int(names[-1]) + 1 if count else 0), names[root]
