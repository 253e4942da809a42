"""The studio that ``brdf-suite environment studio --new`` writes: one lamp of each kind, to be edited."""

from __future__ import annotations

from brdf_suite.documents.studio import Backdrop, Studio, StudioLamp

EXAMPLE = Studio(
    name="My studio",
    backdrop=Backdrop(luminance=0.15),
    lamps=(
        StudioLamp(
            "box", (0.0, 3.0, 0.0), (2.0, 4.0), luminance=5.0, colour_temperature_k=5500.0, softness_m=0.2
        ),
        StudioLamp(
            "strip", (-2.5, 1.0, 1.5), (2.4, 0.25), roll_deg=90.0, luminance=8.0, colour_temperature_k=6500.0
        ),
        StudioLamp(
            "ring", (2.2, 1.2, 2.2), (1.2, 0.12), luminance=10.0, colour_temperature_k=3200.0, softness_m=0.02
        ),
    ),
)
