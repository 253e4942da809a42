"""Compile-time features of the surface shader for a view."""

from __future__ import annotations

from brdf_suite.documents.view import View
from brdf_suite.realtime.gl.programs import Features


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
