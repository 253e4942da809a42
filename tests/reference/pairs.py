"""Models, and pairs of directions in single precision, as the renderer sees them."""

from __future__ import annotations

import numpy as np

from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint, build_reflectance
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.ggx import Ggx
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.registry import MODELS as REGISTERED
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable


def designed(**changes):
    from dataclasses import replace

    return build_paint(replace(load_shipped_paint("copper"), **changes))


def two_lights():
    labs = {15.0: (62.0, -4.0, -45.0), 45.0: (25.0, 4.0, -38.0), 110.0: (9.0, 8.0, -28.0)}
    one = tuple(Measurement(45.0, angle, lab) for angle, lab in labs.items())
    two = (*one, Measurement(15.0, 45.0, (25.0, 12.0, -37.0)))
    return build_paint(Paint("two", two, Gloss(90.0)))


MODELS = {
    "lambertian": lambda: Lambertian(np.array([0.2, 0.5, 0.8])),
    "coat_lobe": lambda: CoatLobe(1.53, 0.005),
    "satin_coat_lobe": lambda: CoatLobe(1.5, 0.1),
    "matte_coat_lobe": lambda: CoatLobe(1.7, 0.5),
    "matte_coat_lobe_single": lambda: CoatLobe(1.7, 0.5, "single"),
    "matte_coated_white": lambda: Coated(Lambertian(1.0), 1.5, 0.4),
    "designed": designed,
    "designed_matte": lambda: designed(gloss=Gloss(8.0)),
    "designed_single": lambda: designed(gloss=Gloss(40.0), scattering="single"),
    "designed_base": lambda: designed().base,
    "designed_base_monotone": lambda: designed(interpolation="monotone").base,
    "designed_base_polynomial": lambda: designed(interpolation="polynomial").base,
    "designed_base_by_half_vector": lambda: designed(out_of_plane="half_vector").base,
    "designed_base_near_specular": lambda: designed(near_specular=1.7).base,
    "designed_base_two_lights": lambda: two_lights().base,
    "cook_torrance": lambda: CookTorrance(TABLE_1["table1_polaris_silver"]),
    "cook_torrance_white": lambda: build_reflectance(TABLE_1["table1_white"]),
    "coated": lambda: Coated(CookTorrance(TABLE_1["table1_blue"]), 1.5, 0.02, 0.6),
    "table": lambda: IsotropicTable.from_reflectance(
        CookTorrance(TABLE_1["table1_white"]), HalfAngleGrid(40, 20, 36)
    ),
    "table_both_ways": lambda: IsotropicTable.from_reflectance(
        CookTorrance(TABLE_1["table1_white"]), HalfAngleGrid(40, 20, 36, reciprocal=False)
    ),
}


for _name in ("factored", "factored_radial", "cosine_lobes"):
    MODELS[_name] = lambda name=_name: REGISTERED[name].default


def without_a_formula():
    return Ggx(np.array([0.6, 0.5, 0.4]), 0.3)


def pairs(n: int, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (n, 3) above the horizon; half of the views near the mirror direction, some near grazing."""
    rng = np.random.default_rng(seed)
    wi, wo = (spherical(np.arccos(rng.random(n) * 0.99 + 0.01), rng.uniform(0, 2 * np.pi, n)) for _ in "ab")
    spread = 10.0 ** rng.uniform(-3.5, -0.5, (n // 2, 1))
    near = wi[: n // 2] * (-1.0, -1.0, 1.0) + spread * rng.normal(size=(n // 2, 3))
    wo[: n // 2] = near / np.linalg.norm(near, axis=1)[:, None]
    above = wo[:, 2] > 0.005
    return singles(wi[above]), singles(wo[above])


def singles(directions: np.ndarray) -> np.ndarray:
    """The directions that single precision holds, of unit length: a formula may take the length for granted."""
    rounded = directions.astype(np.float32).astype(float)
    return rounded / np.linalg.norm(rounded, axis=1)[:, None]
