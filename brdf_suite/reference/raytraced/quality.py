"""Quality settings: lights, reflected rays and samples, (l, s, p) of Günther et al. 2005, Figure 8."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from brdf_suite.errors import ValueRangeError

MOST_LIGHTS, MOST_REFLECTIONS, MOST_SAMPLES = 1024, 4096, 1024


@dataclass(frozen=True)
class Quality:
    """``lights`` l of the environment, ``reflections`` s of the narrow lobes a pixel, ``samples`` p a pixel.

    A sample traces l/p shadow rays and s/p reflected rays, rounded up. ``mirror``: the narrow lobes are mirrored at
    the normal instead of sampled; None: where s is 1, as the paper advises, for one random ray is all noise.

    >>> Quality(128, 16, 16).lights_a_sample, Quality(1024, 256, 64).reflections_a_sample
    (8, 4)
    """

    lights: int
    reflections: int
    samples: int
    mirror: bool | None = None

    def __post_init__(self) -> None:
        limits = {"lights": MOST_LIGHTS, "reflections": MOST_REFLECTIONS, "samples": MOST_SAMPLES}
        for name, most in limits.items():
            value = getattr(self, name)
            if not isinstance(value, int) or isinstance(value, bool) or not 1 <= value <= most:
                raise ValueRangeError(name, f"expected a whole number from 1 to {most:,}, not {value!r}")

    @property
    def mirrors(self) -> bool:
        """Whether narrow lobes are mirrored."""
        return self.reflections == 1 if self.mirror is None else self.mirror

    @property
    def lights_a_sample(self) -> int:
        """Shadow rays of one sample, lamps of the view not counted."""
        return -(-self.lights // self.samples)

    @property
    def reflections_a_sample(self) -> int:
        """Reflected rays of one sample; they share its shadow rays out where they meet the surface again."""
        return -(-self.reflections // self.samples)


PRESETS: Mapping[str, Quality] = MappingProxyType(
    {"fast": Quality(16, 1, 1), "medium": Quality(128, 16, 16), "high": Quality(1024, 256, 64)}
)
DEFAULT_PRESET = "medium"


def find_quality(name_or_quality: str | Quality) -> Quality:
    """Return a preset by name, or the quality as it is; ValueRangeError where there is no such preset."""
    if isinstance(name_or_quality, Quality):
        return name_or_quality
    if name_or_quality not in PRESETS:
        raise ValueRangeError("quality", f"expected one of {', '.join(PRESETS)}, not {name_or_quality!r}")
    return PRESETS[name_or_quality]
