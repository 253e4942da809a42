"""Registry of all models with a typical example each, for tests, checks and parameter panels.

The examples are made when they are asked for, so that listing the models costs nothing. Plug-ins add models by entry
points of the group ``brdf_suite.models``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, is_dataclass, replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.documents.parameter import Parameter
from brdf_suite.plugins import Call, Plugin, Registry
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.guarded import GuardedReflectance, is_own
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.cosine_lobes import CosineLobes
from brdf_suite.reflectance.models.ggx import Ggx
from brdf_suite.reflectance.models.lafortune import Lafortune, LafortuneLobe
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.phong import CoatedPhong, Phong
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import DeclaredModel, Reflectance


@dataclass(frozen=True)
class ModelEntry:
    """A model and one example of it.

    Parameters
    ----------
    name
        Short, as a command-line word.
    title
        For lists.
    make
        Makes the example: a frozen dataclass as :mod:`brdf_suite.reflectance.models` describes it. A plug-in's needs
        no ``sample`` and ``pdf``: they are made from its values.
    reciprocal, energy_conserving
        What the example claims.
    source
        Where the model is from.
    violations
        For a known violator: the size that each check finds, as docs and tests state it.
    """

    name: str
    title: str
    make: Callable[[], Reflectance]
    reciprocal: bool
    energy_conserving: bool
    source: str
    violations: Mapping[str, float] = field(default_factory=dict)

    @cached_property
    def default(self) -> Reflectance:
        """The example."""
        return self.make()

    @property
    def parameters(self) -> Mapping[str, Parameter]:
        """The declared parameters of the model, by field."""
        return self.default.parameters if isinstance(self.default, DeclaredModel) else {}


def _aspecular(*, second_light: bool = False, **rule: Any) -> Reflectance:
    # A blue metallic paint; the second light's readings turn it to violet, as a colour-shifting pigment does.
    readings = [
        Measurement(45.0, 15.0, (62.0, -4.0, -45.0)),
        Measurement(45.0, 45.0, (25.0, 4.0, -38.0)),
        Measurement(45.0, 110.0, (9.0, 8.0, -28.0)),
    ]
    if second_light:
        readings += [
            Measurement(15.0, 15.0, (60.0, 14.0, -46.0)),
            Measurement(15.0, 45.0, (25.0, 12.0, -37.0)),
            Measurement(15.0, 80.0, (14.0, 9.0, -32.0)),
        ]
    return build_paint(Paint("Blue", tuple(readings), Gloss(90.0), **rule))


def _cosine_lobes() -> Reflectance:
    return CosineLobes(
        kd=(0.01, 0.015, 0.03),
        exponents=(5.0, 20.0, 2000.0),
        kdd=((0.05, 0.06, 0.1), (0.03, 0.04, 0.06), (0.0, 0.0, 0.0)),
        kg=((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (12.0, 12.0, 12.0)),
    )


def _lafortune() -> Reflectance:
    # A forward lobe that leans beyond the mirror direction, an anisotropic one, and one back to the light.
    return Lafortune(
        (0.1, 0.2, 0.3),
        (
            LafortuneLobe((0.5, 0.45, 0.4), -1.0, -1.0, 0.9, 20.0),
            LafortuneLobe(0.05, -0.9, -0.6, 0.95, 8.0),
            LafortuneLobe(0.05, 0.7, 0.7, 0.7, 4.0),
        ),
    )


def _factored() -> Reflectance:
    # Satin: facets with a broad and a narrow part, and a colour that pales towards grazing.
    def of_direction(w: Floats) -> Floats:
        low = (1.0 - w[..., 2:]) ** 3
        return np.asarray((1.0 - low) * np.array([1.0, 0.8, 0.5]) + low * np.array([1.1, 1.1, 1.1]))

    def of_half_vector(h: Floats) -> Floats:
        tan2 = 1.0 / np.maximum(h[..., 2:], 1e-3) ** 2 - 1.0
        return np.asarray((0.08 + 0.12 * np.exp(-tan2 / 0.3) + 0.6 * np.exp(-tan2 / 0.02)) * np.ones(3))

    return Factored.from_functions(of_direction, of_half_vector, 32)


def _factored_radial() -> Reflectance:
    # A body of radial maps with a peak apart that Fresnel's rise brightens, as factored measurements are.
    along = (np.arange(24)[:, None] + 0.5) / 24
    p = np.exp(np.array([-0.3, -0.6, -1.0]) * along**2)
    q = 0.05 + np.exp(-((along / 0.3) ** 2)) * np.array([1.0, 0.7, 0.3])
    rise = 1.0 + 4.0 * (1.0 - along) ** 5 * np.ones(3)
    peak = 0.4 * np.exp(-((along**2 / 0.12) ** 2)) * np.ones(3)
    return Factored(
        p.astype(np.float32),
        q.astype(np.float32),
        0.15,
        more=(MapFactor("w.h", rise.astype(np.float32), logarithmic=True),),
        peak=(
            MapFactor("sqrt|h|", peak.astype(np.float32)),
            MapFactor("w.h", rise.astype(np.float32), logarithmic=True),
        ),
        logarithmic=True,
    )


_ASPECULAR: tuple[tuple[str, str, dict[str, Any]], ...] = (
    ("", "flake rule", {}),
    ("_monotone", "monotone rule", {"interpolation": "monotone"}),
    ("_polynomial", "polynomial rule", {"interpolation": "polynomial"}),
    ("_half_vector", "flake rule by the half vector's tilt", {"out_of_plane": "half_vector"}),
    ("_two_lights", "two light angles", {"second_light": True}),
)
_ENTRIES = (
    *(
        ModelEntry(
            f"aspecular{suffix}",
            f"Aspecular paint, {rule}",
            partial(_aspecular, **options),
            True,
            False,
            "Westlund and Meyer 2001; Shimizu, Meyer and Wingard 2003",
        )
        for suffix, rule, options in _ASPECULAR
    ),
    ModelEntry(
        "coat", "Clearcoat alone", partial(CoatLobe, 1.5, 0.01), True, True, "Beckmann; Walter et al. 2007"
    ),
    ModelEntry(
        "coated_matt",
        "Matt base under a clearcoat",
        lambda: Coated(Lambertian((0.6, 0.3, 0.2))),
        True,
        True,
        "Saunderson 1942",
    ),
    ModelEntry(
        "coated_phong",
        "Phong with a clearcoat by Fresnel",
        lambda: CoatedPhong((0.03, 0.05, 0.15), (0.2, 0.25, 0.4)),
        True,
        True,
        "after Günther et al. 2005, section 6.1",
    ),
    ModelEntry(
        "cook_torrance",
        "Cook-Torrance, three lobes (Polaris Silver)",
        lambda: CookTorrance(TABLE_1["table1_polaris_silver"]),
        True,
        False,
        "Günther et al. 2005, equation 1 and Table 1",
    ),
    ModelEntry(
        "cosine_lobes",
        "Sum of cosine lobes",
        _cosine_lobes,
        False,
        False,
        "BRDF approximation for interactive colour appearance design, equations 1 to 3",
        {"reciprocity": 0.998},
    ),
    ModelEntry(
        "factored",
        "Product of textures, light × half vector × view",
        _factored,
        True,
        False,
        "McCool, Ang and Ahmad 2001",
    ),
    ModelEntry(
        "factored_radial",
        "Product of radial textures with a peak apart",
        _factored_radial,
        True,
        False,
        "McCool, Ang and Ahmad 2001, sections 4.2 and 4.3",
    ),
    ModelEntry(
        "ggx",
        "GGX metal over a matt part",
        partial(Ggx, 0.05, (0.9, 0.7, 0.4)),
        True,
        True,
        "Walter et al. 2007; Heitz 2014",
    ),
    ModelEntry(
        "ggx_clearcoat",
        "GGX metal under a clearcoat",
        lambda: Coated(Ggx(0.02, (0.5, 0.3, 0.3), 0.35), 1.5, 0.005, spread=0.5),
        True,
        True,
        "Walter et al. 2007",
    ),
    ModelEntry("lafortune", "Generalised cosine lobes", _lafortune, True, True, "Lafortune et al. 1997"),
    ModelEntry("lambertian", "Matt", lambda: Lambertian((0.8, 0.5, 0.2)), True, True, "Lambert 1760"),
    ModelEntry("phong", "Phong, modified", partial(Phong, (0.1, 0.2, 0.4), 0.4), True, True, "Lewis 1994"),
    ModelEntry(
        "phong_original",
        "Phong, original",
        partial(Phong, (0.1, 0.2, 0.4), 0.4, form="original"),
        False,
        False,
        "Phong 1975",
        {"reciprocity": 0.999, "directional_albedo": 0.868},
    ),
    ModelEntry(
        "poulin_fournier",
        "Brushed metal of cylinders",
        lambda: PoulinFournier((0.1, 0.1, 0.12), (0.6, 0.55, 0.5)),
        True,
        True,
        "Poulin and Fournier 1990",
    ),
)


def _guard_example(entry: ModelEntry, plugin: Plugin) -> ModelEntry:
    """Let the reflectance that a plug-in makes name it where it fails."""

    def make() -> Reflectance:
        example = entry.make()
        return example if is_own(example) else GuardedReflectance(example, plugin, {})

    return replace(entry, make=make)


ENTRIES = Registry(
    "brdf_suite.models",
    ModelEntry,
    _ENTRIES,
    calls={
        "make": Call(
            lambda found: isinstance(found, DeclaredModel) and is_dataclass(found),
            "a dataclass with eval(), parameters, reciprocal and energy_conserving",
        )
    },
    prepare=_guard_example,
)
"""Every model with an example of it, those of plug-ins last."""
MODELS: Mapping[str, ModelEntry] = ENTRIES.by_name
"""The same by name."""
