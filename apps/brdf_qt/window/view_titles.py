"""How the choices of a view are called in every program: lights, forms, backgrounds, tone curves, the camera."""

from __future__ import annotations

from brdf_qt.program.translation import mark

BACKGROUND_TITLES = {
    "environment": mark("Environment"),
    "blurred": mark("Environment, blurred"),
    "grey": mark("Neutral grey"),
    "colour": mark("Plain colour"),
}
TONE_TITLES = {
    "faithful": mark("Faithful, soft highlights"),
    "neutral": mark("Neutral (Khronos PBR)"),
    "characteristic": mark("Characteristic curve"),
    "aces": mark("ACES (fitted)"),
    "agx": "AgX",
    "linear": mark("Linear, clipping marked"),
}
TONE_TIPS = {
    "faithful": mark("Shows colours unchanged; compresses only values above 0.8"),
    "neutral": mark(
        "Removes 4 % of reflection from dark tones, keeps hue and saturation, compresses highlights"
    ),
    "characteristic": mark("A film's S-shaped response in log exposure"),
    "aces": mark(
        "The film industry's rendering, as Hill fitted it: darker and with more contrast; 0.18 becomes 0.11"
    ),
    "agx": mark("Sixteen stops in a soft curve; bright saturated light desaturates to white, as on film"),
    "linear": mark("No curve, for judging colours; highlights are clipped and marked"),
}
FRESNEL_TITLES = {"raised": mark("Raised"), "multi_angle": mark("Several angles"), "off": mark("Off")}
FRESNEL_TIPS = {
    "raised": mark(
        "The lobes fitted at 45°, with the coat brightened and the base dimmed by the exact Fresnel equations"
    ),
    "multi_angle": mark(
        "Lobes fitted at 16 angles of incidence and interpolated, also in their shape; measured files, "
        "which have no separate coat, are raised"
    ),
    "off": mark("The lobes of 45° at every angle"),
}
LOOK_UP_TITLES = {"shifted": mark("Shifted (exact horizon)"), "paper": mark("Mirror direction (paper)")}
LOOK_UP_TIPS = {
    "shifted": mark(
        "Each lobe is looked up between mirror direction and normal: only light above the surface counts"
    ),
    "paper": mark(
        "Each lobe is looked up in the mirror direction and dimmed by its cosine, as published by Westlund and "
        "Meyer: broad lobes take light from below the surface, towards grazing angles"
    ),
}
PRESETS: dict[str, tuple[str, float, float]] = {
    "front": (mark("Front"), 0.0, 6.0),
    "three_quarter": (mark("¾ view"), 35.0, 7.0),
    "side": (mark("Side"), 90.0, 4.0),
    "top": (mark("Top"), 0.0, 89.0),
}
"""Key: title, azimuth and elevation in degrees; the first is on key 1."""
