"""Losses of glTF with ``KHR_materials_sheen`` or ``KHR_materials_iridescence`` beside what the export writes.

    python -m tools.evaluation.gltf_extensions [PAINT...]

Each is fitted as the export is, from the exported parameters on, and its mean ΔE00 on the sphere printed as a table.

Sheen is a layer above the coat, as in Blender's Cycles: a linearly transformed cosine of Zeltner et al. 2022, here with
MaterialX's rational fits of its coefficients. The film is that of Belcour and Barla 2017 on the lobe, as glTF viewers
evaluate it: three channels by the Gaussians of the paper, at the view's angle from the normal, in place of f0. Viewers
take Schlick's rise, so the column before has that rise too, and no film. Where an extension does not lower the loss,
the figure is that without it.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Hashable
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import (
    REC709_PRIMARIES,
    REC709_TO_WORKING,
    primaries_to_xyz,
)
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Paint
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.exports.model_fit import target_of
from brdf_suite.pipeline.material import load_shipped_paint, paint_names
from brdf_suite.reflectance.instruments.rendered_sphere import exposure, rendered_sphere, shown_lab
from brdf_suite.reflectance.renderers.coated_facets import GLTF_LOBE_IOR, CoatedFacets, matt_term
from brdf_suite.reflectance.renderers.facet_lobe import RendererLobe, index_of, normal_reflectance

THICKNESSES_NM = (150.0, 250.0, 350.0, 450.0, 600.0, 800.0)
SHEEN_WIDTHS = (0.3, 0.7)
_XYZ_TO_REC709: Floats = np.asarray(np.linalg.inv(primaries_to_xyz(REC709_PRIMARIES)), np.float64)

Terms = Callable[[Floats, Floats], Floats]
Integrate = Callable[[Hashable, Terms], Floats]


@dataclass(frozen=True)
class Variant:
    """A way to write a paint: the index that the lobe rises by (1: Schlick's), and what is above or on the lobe."""

    ior: float
    sheen: bool = False
    film: bool = False

    def bounds(self) -> tuple[Floats, Floats]:
        """Return the lowest and highest parameters: matt colour, f0, logarithm of α, then the extension's."""
        low, high = [0.0] * 3 + [1e-4] * 3 + [math.log(0.02)], [1.0] * 6 + [0.0]
        if self.sheen:
            low, high = [*low, 0.0, 0.0, 0.0, 0.05], [*high, 1.0, 1.0, 1.0, 1.0]
        if self.film:
            low, high = [*low, 1.001, 50.0], [*high, 2.4, 1000.0]
            high[3:6] = [0.98] * 3
        return np.array(low), np.array(high)

    def starts(self, model: CoatedFacets) -> list[Floats]:
        """Return where fits begin: the export's parameters, with extensions that do nearly nothing."""
        plain = [*model.diffuse, *model.specular, math.log(model.alpha)]
        if self.sheen:
            return [np.array([*plain, 0.005, 0.005, 0.005, width]) for width in SHEEN_WIDTHS]
        if self.film:
            return [np.array([*plain, 1.03, thickness]) for thickness in THICKNESSES_NM]
        return [np.array(plain)]


VARIANTS = {
    "export": Variant(GLTF_LOBE_IOR),
    "sheen": Variant(GLTF_LOBE_IOR, sheen=True),
    "Schlick": Variant(1.0),
    "film": Variant(1.0, film=True),
}


def sheen_albedo(cos_o: Floats, width: float) -> Floats:
    """Return the share (n,) of light that white sheen sends to views of cosine ``cos_o`` (n,)."""
    w = width
    spread = w * (0.0206607 + 1.58491 * w) / (0.0379424 + w * (1.32227 + w))
    middle = w * (-0.193854 + w * (-1.14885 + w * (1.7932 - 0.95943 * w * w))) / (0.046391 + w)
    floor = w * (0.000654023 + (-0.0207818 + 0.119681 * w) * w) / (1.26264 + w * (-1.92021 + w))
    bell = np.exp(-0.5 * ((cos_o - middle) / spread) ** 2) / (spread * math.sqrt(2.0 * math.pi))
    return np.asarray(bell + floor)


def sheen_term(wi: Floats, wo: Floats, width: float) -> Floats:
    """Return f_r (n, 1) of white sheen of a ``width`` (roughness, 0 to 1), 1/sr."""
    x, w = wo[:, 2].clip(0.0, 1.0), width
    stretch = (2.58126 * x + 0.813703 * w) * w / (1.0 + 0.310327 * x * x + 2.60994 * x * w)
    shear = np.sqrt(1.0 - x) * (w - 1.0) * w**3
    shear /= 0.0000254053 + 1.71228 * x - 1.71506 * x * w + 1.34174 * w * w
    across = np.hypot(wo[:, 0], wo[:, 1])
    east = wo[:, :2] / np.maximum(across, 1e-12)[:, None]
    along = wi[:, 0] * east[:, 0] + wi[:, 1] * east[:, 1]
    aside = wi[:, 1] * east[:, 0] - wi[:, 0] * east[:, 1]
    length2 = (stretch * along + shear * wi[:, 2]) ** 2 + (stretch * aside) ** 2 + wi[:, 2] ** 2
    # The transformed cosine has the cosine of the light in it, which f_r has not.
    return np.asarray((sheen_albedo(x, width) / math.pi * (stretch / length2) ** 2)[:, None])


def film_reflectance(cosine: Floats, index: float, thickness_nm: float, f0: Floats) -> Floats:
    """Return the reflectance (n, 3), linear Rec. 709, of a film on a base of ``f0`` (3,), light at ``cosine`` (n,)."""
    inside = np.sqrt(np.maximum(1.0 - (1.0 - cosine**2) / index**2, 1e-6))
    low = normal_reflectance(index)
    upper = (low + (1.0 - low) * (1.0 - cosine) ** 5)[:, None]
    base = np.array([index_of(float(value)) for value in f0])
    low_base = ((base - index) / (base + index)) ** 2
    lower = low_base + (1.0 - low_base) * ((1.0 - inside) ** 5)[:, None]
    phase = math.pi + np.where(base < index, math.pi, 0.0)
    path = (2.0 * index * thickness_nm * 1e-9) * inside[:, None]
    both = (upper * lower).clip(1e-5, 0.9999)
    bounced = (1.0 - upper) ** 2 * lower / (1.0 - both)
    found, order = upper + bounced, bounced - (1.0 - upper)
    for number in (1, 2):
        order = order * np.sqrt(both)
        found = found + 2.0 * order * _sensitivity(number * path, number * phase)
    return np.clip(found, 0.0, 0.999)


def _sensitivity(path_m: Floats, phase: Floats) -> Floats:
    """Return the cosine of the phase (n, 3) as the three channels see it, linear Rec. 709."""
    turn = 2.0 * math.pi * path_m
    peak = np.array([5.4856e-13, 4.4201e-13, 5.2481e-13, 9.7470e-14])
    place = np.array([1.6810e6, 1.7953e6, 2.2084e6, 2.2399e6])
    variance = np.array([4.3278e9, 9.3046e9, 6.6121e9, 4.5282e9])
    shift = np.append(phase, phase[0])
    xyz = (
        peak * np.sqrt(2.0 * math.pi * variance) * np.cos(place * turn + shift) * np.exp(-variance * turn**2)
    )
    xyz[:, 0] += xyz[:, 3]
    return np.asarray(xyz[:, :3] / 1.0685e-7 @ _XYZ_TO_REC709.T)


def values(variant: Variant, x: Floats, model: CoatedFacets, integrate: Integrate, cos_o: Floats) -> Floats:
    """Return the values (n, 3), linear Rec. 709, of parameters at views of cosine (n,); the coat is ``model``'s."""
    matt, f0, lobe = x[:3], x[3:6], RendererLobe(math.exp(float(x[6])), variant.ior, "kulla_conty")
    if variant.film:
        f0 = film_reflectance(cos_o, float(x[7]), float(x[8]), f0)
    left = 1.0 - lobe.albedo(f0, cos_o).max(axis=-1)
    found = left[:, None] * integrate("matt", matt_term) * matt
    found = found + lobe.sum_terms(integrate(lobe, lobe.terms), f0, cos_o)
    coat, coat_f0 = model.coat, np.array([normal_reflectance(model.coat_ior)])
    found = (1.0 - coat.albedo(coat_f0, cos_o)) * found
    found = found + coat.sum_terms(integrate("coat", coat.terms), coat_f0, cos_o)
    if variant.sheen:
        colour, width = x[7:10], float(x[10])
        term = integrate(("sheen", width), lambda wi, wo: sheen_term(wi, wo, width))
        found = (1.0 - colour.max() * sheen_albedo(cos_o, width))[:, None] * found + term * colour
    return np.asarray(found)


def loss(paint: Paint, variant: Variant) -> float:
    """Return the mean ΔE00 on the sphere of a designed paint that is fitted in a variant."""
    target, model = target_of(paint, None), fit_coated_facets(ExportItem(paint), "gltf").model
    kept: dict[Hashable, Floats] = {}

    def integrate(key: Hashable, terms: Terms) -> Floats:
        if key not in kept:
            kept[key] = target.integrals(terms)
        return kept[key]

    low, high = variant.bounds()
    tried = [
        target.least(lambda x: values(variant, x, model, integrate, target.cos_o), start, low, high)
        for start in variant.starts(model)
    ]
    best = min(tried, key=lambda pair: pair[1])[0]
    sphere = rendered_sphere()
    pixels = sphere.pixels(target.reflectance)
    found = values(variant, best, model, lambda _, terms: sphere.summed(terms), sphere.cos_o)
    factor = exposure(pixels)
    other = shown_lab(found @ REC709_TO_WORKING.T, factor)
    return float(delta_e_2000(shown_lab(pixels, factor), other).mean())


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("paints", nargs="*", default=paint_names(), metavar="PAINT")
    print(f"| paint | {' | '.join(VARIANTS)} |\n|---|{'---|' * len(VARIANTS)}")
    for name in parser.parse_args().paints:
        paint = load_shipped_paint(name)
        plain, sheen, schlick, film = (loss(paint, variant) for variant in VARIANTS.values())
        found = (plain, min(plain, sheen), schlick, min(schlick, film))
        print(f"| {name} | {' | '.join(f'{value:.2f}' for value in found)} |", flush=True)


if __name__ == "__main__":
    main()
