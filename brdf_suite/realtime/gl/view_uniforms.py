"""What programs take of a view: uniforms of all surfaces and the background, and the words of the surface shader."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.documents.view import View
from brdf_suite.realtime.gl.programs import Features


def view_uniforms(view: View) -> dict[str, object]:
    """Return turn and colour of the light, and the exposure as a factor."""
    turn = np.radians(view.rotation_deg)
    return {
        "light_turn": (float(np.cos(turn)), float(np.sin(turn))),
        "light_colour": columns(environment_matrix(view.light_colour)),
        "exposure": 2.0**view.exposure_ev,
    }


def surface_features(view: View, *, knows_light: bool = False, smooth: bool = False) -> Features:
    """Return the words that the shader files test with ``#ifdef``, for one frame.

    ``knows_light`` says whether the mesh holds the light that arrives at it, ``smooth`` whether edges are to be.

    A word costs a program of its own, compiled at its first frame, so each represents what a user switches on
    or off, never for a number that is dragged.

    >>> sorted(surface_features(View(fresnel="off")))
    []
    """
    words: set[str] = set()
    if smooth:
        words.add("SMOOTH_REFLECTIONS")
    if view.look_up == "paper":
        words.add("LOOK_UP_PAPER")
    if view.fresnel != "off":
        words.add("FRESNEL_RAISED")
    if knows_light and view.surface_look.occlusion:
        words.add("OCCLUSION")
    return frozenset(words)


def columns(matrix: NDArray[np.float64]) -> tuple[float, ...]:
    """Return a matrix column by column, as OpenGL wants it."""
    return tuple(matrix.T.ravel().tolist())
