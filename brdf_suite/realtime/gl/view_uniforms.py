"""Uniforms of a view shared by all surfaces and the background."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.documents.view import View


def view_uniforms(view: View) -> dict[str, object]:
    """Return turn and colour of the light, and the exposure as a factor."""
    turn = np.radians(view.rotation_deg)
    return {
        "light_turn": (float(np.cos(turn)), float(np.sin(turn))),
        "light_colour": columns(environment_matrix(view.light_colour)),
        "exposure": 2.0**view.exposure_ev,
    }


def columns(matrix: NDArray[np.float64]) -> tuple[float, ...]:
    """Return a matrix column by column, as OpenGL wants it."""
    return tuple(matrix.T.ravel().tolist())
