"""What a view lays on the paint: maps of normals and tangents, a mask, and the second paint that it lets through."""

from __future__ import annotations

from dataclasses import dataclass

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Illuminant, LightColour
from brdf_suite.files.images.relief import read_mask, read_normal_map, read_tangent_map
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import load_material, under_illuminant
from brdf_suite.progress import Progress, report
from brdf_suite.realtime.relief.values import MaskImage, PeelTile, SlopeMap, TangentMap
from brdf_suite.surface.orange_peel import TILE_WAVES, peel_slopes


@dataclass(frozen=True)
class ImageRequest:
    """The files and the paint that a view names; equal ones need not be loaded again.

    ``lamp`` is what a second paint with spectra is fitted for.
    """

    normal_map: str | None = None
    mask: str | None = None
    second_paint: str | None = None
    lamp: Illuminant = "D65"
    tangent_map: str | None = None

    @staticmethod
    def of(view: View) -> ImageRequest:
        """Return what ``view`` asks for: no mask without a second paint, and no second paint that nothing wears."""
        two_tone = view.two_tone
        paint = two_tone.paint if two_tone.mask is not None or view.surface_look.wears_second else None
        return ImageRequest(
            view.relief.normal_map,
            None if paint is None else two_tone.mask,
            paint,
            "D65" if paint is None else view.light_colour.illuminant,
            view.relief.tangent_map,
        )


@dataclass(frozen=True, eq=False)
class SurfaceImages:
    """The same, loaded and fitted."""

    request: ImageRequest
    normal_map: SlopeMap | None = None
    mask: MaskImage | None = None
    second_paint: LobeFit | None = None
    tangent_map: TangentMap | None = None


def load_surface_images(
    request: ImageRequest, progress: Progress | None = None, *, settings: FitSettings | None = None
) -> SurfaceImages:
    """Read images and fit the second paint, as ``settings`` say, which are those of the first.

    Raises
    ------
    FileError
        An image or the paint cannot be read, or an image is no normal map.
    UnreachableError, FittingError
        The paint cannot be fitted.
    """
    report(progress, 0.0, "reading the images")
    normal_map = None if request.normal_map is None else SlopeMap(read_normal_map(request.normal_map))
    mask = None if request.mask is None else MaskImage(read_mask(request.mask))
    tangents = None if request.tangent_map is None else TangentMap(read_tangent_map(request.tangent_map))
    second = None
    if request.second_paint is not None:
        report(progress, 0.5, "fitting the second paint")
        material = under_illuminant(load_material(request.second_paint), LightColour(request.lamp))
        second = fit_material(material, settings)
    report(progress, 1.0, "images")
    return SurfaceImages(request, normal_map, mask, second, tangents)


def orange_peel_tile() -> PeelTile:
    """Return the tile that every orange peel is drawn with; some tenths of a second."""
    return PeelTile(peel_slopes(), TILE_WAVES)
