"""Light as a light booth has it at the push of a button: an environment, its lamps' colour, and a point source."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from brdf_qt.program.translation import mark

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Illuminant, Lamp, LightColour


@dataclass(frozen=True)
class LightingPreset:
    """What a button sets: environment, its lamps' colour and brightness, and lamps beside it; ``tip`` explains it."""

    title: str
    environment: str
    illuminant: Illuminant
    tip: str
    lamps: tuple[Lamp, ...] = ()
    brightness: float = 1.0


POINT = Lamp(kind="point", position=(0.9, 1.6, 1.1), strength=6.0, temperature_k=6500.0)

THREE = (
    Lamp(kind="point", position=(-1.3, 1.2, 0.7), strength=3.0, temperature_k=6500.0),
    Lamp(kind="point", position=(0.6, 1.7, 1.2), strength=4.0, temperature_k=5000.0),
    Lamp(kind="point", position=(1.5, 0.6, -0.4), strength=2.5, temperature_k=9000.0),
)

PRESETS: Mapping[str, LightingPreset] = MappingProxyType(
    {
        "d65": LightingPreset("D65", "booth", "D65", mark("Light booth, average daylight")),
        "d50": LightingPreset("D50", "booth", "D50", mark("Light booth, warm daylight (graphic arts)")),
        "a": LightingPreset("A", "booth", "A", mark("Light booth, incandescent lamps of 2,856 K")),
        "tl84": LightingPreset(
            "TL84", "booth", "TL84", mark("Light booth, three-band fluorescent lamps (CIE F11)")
        ),
        "cwf": LightingPreset(
            "CWF", "booth", "CWF", mark("Light booth, cool white fluorescent lamps (CIE F2)")
        ),
        "led": LightingPreset("LED", "booth", "LED", mark("Light booth, white LEDs of 4,100 K (CIE LED-B3)")),
        "sun": LightingPreset(mark("Sun and sky"), "sunny", "environment", mark("Clear sky with the sun")),
        "overcast": LightingPreset(
            mark("Overcast"), "overcast", "environment", mark("Even, cloudy sky, no sun")
        ),
        "point": LightingPreset(
            mark("Point source"),
            "booth",
            "D65",
            mark("Light booth with one small movable lamp, for sparkle"),
            (POINT,),
        ),
        "three": LightingPreset(
            mark("Three lamps"),
            "booth",
            "D65",
            mark("Three movable lamps, no environment – best for factored paints"),
            THREE,
            0.0,
        ),
    }
)


def with_preset(view: View, key: str) -> View:
    """Return the view in a preset's light; adaptation, exposure and rotation stay.

    The environment is named; who shows the view loads it.
    """
    preset = PRESETS[key]
    return replace(
        view,
        environment=preset.environment,
        environment_layout="auto",
        light_colour=replace(view.light_colour, illuminant=preset.illuminant, brightness=preset.brightness),
        lamps=preset.lamps,
    )


def preset_of(view: View) -> str:
    """Return the preset that the view's light is, wherever its lamps stand; empty where it is another.

    >>> preset_of(View())
    'd65'
    """
    illuminant = view.light_colour.illuminant
    if illuminant == "environment" and view.environment == "booth":
        illuminant = "D65"  # the booth's own lamps are neutral
    dark = view.light_colour.brightness == 0.0
    for key, preset in PRESETS.items():
        same_light = (view.environment, illuminant) == (preset.environment, preset.illuminant)
        same_light = same_light and dark == (preset.brightness == 0.0)
        if same_light and [lamp.kind for lamp in view.lamps] == [lamp.kind for lamp in preset.lamps]:
            return key
    return ""


def is_tinted(colour: LightColour) -> bool:
    """Whether the picture takes the lamp's colour on, or would to an eye that has not adapted."""
    return colour.illuminant not in ("environment", "D65")
