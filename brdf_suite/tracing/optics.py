"""What the paint of a view reflects by, in the path tracer: its flakes, its relief, and a second paint by a mask."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from brdf_suite.documents.view import View
from brdf_suite.files.images.relief import read_mask, read_normal_map
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.pipeline.material import Material, load_material, under_illuminant
from brdf_suite.pipeline.paint_angles import material_weights
from brdf_suite.pipeline.surface_images import ImageRequest, orange_peel_tile
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.relief.textures import mask_coordinates
from brdf_suite.realtime.relief.values import MaskImage, SlopeMap
from brdf_suite.realtime.values import MaterialWeights
from brdf_suite.reference.bsdfs.lobe_weights import LobeWeightsTerm
from brdf_suite.reference.bsdfs.placed import LayeredPaintBsdf, Mask, TwoToneBsdf
from brdf_suite.reference.bsdfs.translate import TranslatedTerm, divide, translate
from brdf_suite.reference.flakes.population import FlakeLayer
from brdf_suite.reference.scalar import AS_A_TABLE, LobesSeen, table_bsdf
from brdf_suite.reference.scene.place import OrangePeelSlopes, Slopes, texture
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True, eq=False)
class Dress:
    """What a view lays on the paint, loaded: a normal map, a mask, and the second paint of it or of whole parts."""

    normal_map: SlopeMap | None = None
    mask: MaskImage | None = None
    second: Material | None = None


def load_lit(asked: str | os.PathLike[str] | Material, view: View) -> Material:
    """Return a material, loaded or by name or file, as it looks in the view's lamp; errors as :func:`load_material`."""
    material = asked if isinstance(asked, Material) else load_material(asked)
    return under_illuminant(material, view.light_colour)


def load_dress(view: View) -> Dress:
    """Read what a view lays on the paint; errors as :func:`~brdf_suite.pipeline.surface_images.load_surface_images`."""
    request = ImageRequest.of(view)
    return Dress(
        None if request.normal_map is None else SlopeMap(read_normal_map(request.normal_map)),
        None if request.mask is None else MaskImage(read_mask(request.mask)),
        None if request.second_paint is None else load_lit(request.second_paint, view),
    )


def optics_of(paint: Material, dress: Dress, view: View, bounds: Bounds) -> TranslatedTerm:
    """Return what ``paint`` reflects by in ``view``: the plain twin where nothing differs from place to place.

    Of parts of the second paint alone that is ``dress.second``, with a dress that has no mask.
    """
    first, notices = _placed(paint, dress, view)
    if dress.mask is not None and dress.second is not None:
        second, more = _placed(dress.second, dress, view)
        where: dict[str, Any] = mask_coordinates(view, bounds, dress.mask.aspect)
        mask = Mask.of(dress.mask.share, where["mask_tiles"], where["mask_u"], where["mask_v"])
        return TranslatedTerm(
            TwoToneBsdf(first, second, mask), (*notices, *(more if more != notices else ()))
        )
    if not first.is_plain:
        return TranslatedTerm(first, notices)
    if isinstance(paint.reflectance, LobeWeights):
        return TranslatedTerm(lobe_term(material_weights(paint.reflectance), view))
    return translate(paint.reflectance)


def lobe_term(weights: MaterialWeights, view: View) -> LobeWeightsTerm:
    """Return lobe weights as something that reflects, with the gains that the view asks for."""
    names = ("kd", "kdd", "kg", "coat", "theta_fit_rad", "ior", "transmittance")
    same = {name: getattr(weights, name) for name in names}
    return LobeWeightsTerm(np.asarray(weights.exponents, float), **same, raised=view.fresnel != "off")


def scalar_optics(paint: Material, dress: Dress, view: View, instead: str) -> TranslatedTerm:
    """Return the paint as one of Mitsuba's own plug-ins, where nothing else runs; ``instead`` says what is missing.

    Raises
    ------
    ReferenceUnavailableError
        The paint is not isotropic, so that it has no such form.
    """
    notices = [instead, AS_A_TABLE]
    placed = _peel_of(paint, view)[0] > 0.0 or (paint.flakes is not None and view.sparkle.mode != "off")
    if placed or dress.normal_map is not None or dress.mask is not None:
        notices.append(
            "Without LLVM there are no single flakes, no relief and no mask: the first paint is shown there, smooth."
        )
    if view.surface_look.ground:
        notices.append("Without LLVM there is no ground and no shadow on it.")
    if isinstance(paint.reflectance, LobeWeights):
        return TranslatedTerm(scalar_lobes(material_weights(paint.reflectance), view), tuple(notices))
    return TranslatedTerm(table_bsdf(paint.reflectance), tuple(notices))


def scalar_lobes(weights: MaterialWeights, view: View) -> Any:
    """Return lobe weights as one of Mitsuba's own plug-ins, with the gains that the view asks for."""
    # Coarser than a paint's: within a per cent, in a tenth of the time.
    return table_bsdf(LobesSeen(lobe_term(weights, view)), incidences=32, resolution=64)


def _placed(paint: Material, dress: Dress, view: View) -> tuple[LayeredPaintBsdf, tuple[str, ...]]:
    base, coat, ior, notices = divide_paint(paint.reflectance, view)
    layer = None
    if paint.flakes is not None and paint.flakes.density_per_mm2 > 0.0 and view.sparkle.mode != "off":
        layer = FlakeLayer.of(
            paint.flakes, base, ior, view.sparkle.strength, as_texture=view.sparkle.mode == "texture"
        )
    shape = None
    if dress.normal_map is not None:
        width = view.relief.normal_width_mm
        tiles = (1.0 / width, 1.0 / (width * dress.normal_map.aspect))
        shape = Slopes(texture(dress.normal_map.slopes), tiles, view.relief.normal_strength)
    peel = None
    slope_deg, length_mm = _peel_of(paint, view)
    if slope_deg > 0.0:
        tile, slope = orange_peel_tile(), math.tan(math.radians(slope_deg))
        peel = OrangePeelSlopes(texture(tile.slopes), 1.0 / (tile.waves * length_mm), slope)
    return LayeredPaintBsdf(base, coat, shape, peel, layer), notices


def divide_paint(reflectance: Reflectance, view: View) -> tuple[Any, Any | None, float, tuple[str, ...]]:
    """Return the terms of base and coat (None: there is none), the index of the coat, and notices."""
    if isinstance(reflectance, LobeWeights):
        weights = material_weights(reflectance)
        none = np.zeros_like(weights.kdd)
        base = lobe_term(replace(weights, kg=none), view)
        coat = lobe_term(replace(weights, kd=np.zeros(3), kdd=none), view)
        ior = weights.ior if weights.coat == "dielectric" else 1.0
        return base, coat if weights.kg.any() else None, ior, ()
    parts = divide(reflectance)
    return parts.base, parts.coat, parts.ior, parts.notices


def _peel_of(paint: Material, view: View) -> tuple[float, float]:
    """The view's orange peel, or the paint's own where the view asks for none: its slope, degrees, and length, mm."""
    if view.relief.orange_peel <= 0.0 and paint.orange_peel is not None:
        return paint.orange_peel.slope_deg, paint.orange_peel.wavelength_mm
    return view.relief.orange_peel, view.relief.orange_peel_mm
