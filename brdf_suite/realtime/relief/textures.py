"""Relief and mask textures: normal and tangent maps, the orange peel tile, the two-tone mask."""

from __future__ import annotations

from collections.abc import Callable

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.paint import OrangePeel
from brdf_suite.documents.view import View
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.gl.context import draws_in_software
from brdf_suite.realtime.gl.objects import GpuObjects
from brdf_suite.realtime.gl.programs import RELIEF_UNITS, Features
from brdf_suite.realtime.relief.values import MaskImage, PeelTile, SlopeMap, TangentMap

NORMAL_UNIT, PEEL_UNIT, MASK_UNIT, TANGENT_UNIT = (
    RELIEF_UNITS[name] for name in ("normal_slopes", "peel_slopes", "paint_mask", "tangent_turns")
)

_ANISOTROPY = 8.0


class ReliefTextures:
    """Textures of one mesh's paint; each is there or not, and the view says which of them are shown.

    ``make_peel`` makes the tile of the orange peel when a view or a paint first asks for it.
    """

    def __init__(self, objects: GpuObjects, make_peel: Callable[[], PeelTile] | None = None) -> None:
        self._objects = objects
        self._make_peel = make_peel
        self._normal_map: tuple[moderngl.Texture, float] | None = None  # with height over width
        self._tangents: tuple[moderngl.Texture, float] | None = None
        self._peel: tuple[moderngl.Texture, int] | None = None  # with waves along an edge
        self._mask: tuple[moderngl.Texture, float] | None = None
        self._own_peels: dict[str, OrangePeel] = {}

    def set_normal_map(self, slopes: SlopeMap | None) -> None:
        """Replace the normal map; None: there is none."""
        self._give_back(self._normal_map)
        self._normal_map = None  # also where the graphics card refuses the new one
        if slopes is not None:
            self._normal_map = (self._slopes(slopes.slopes), slopes.aspect)

    def set_tangent_map(self, tangents: TangentMap | None) -> None:
        """Replace the map of tangents; None: they lie along u."""
        self._give_back(self._tangents)
        self._tangents = None
        if tangents is not None:
            pixels = np.zeros((*tangents.turns.shape[:2], 4), np.float16)
            pixels[..., :2] = tangents.turns
            self._tangents = (self._texture(pixels, "f2"), tangents.aspect)

    def set_peel(self, tile: PeelTile) -> None:
        """Take the tile that every orange peel is drawn with."""
        self._give_back(self._peel)
        self._peel = None  # also where the graphics card refuses the new one
        self._peel = (self._slopes(tile.slopes), tile.waves)

    def set_own_peel(self, material: str, peel: OrangePeel | None) -> None:
        """Give a material the orange peel that is drawn where the view asks for none."""
        if peel is None or peel.slope_deg == 0.0:
            self._own_peels.pop(material, None)
        else:
            self._own_peels[material] = peel

    def set_mask(self, mask: MaskImage | None) -> None:
        """Replace the mask of the second paint; None: there is one paint."""
        self._give_back(self._mask)
        self._mask = None
        if mask is not None:
            pixels = np.repeat(np.round(mask.share * 255.0).astype(np.uint8)[..., None], 4, axis=-1)
            self._mask = (self._texture(pixels, "f1"), mask.aspect)

    def features(self, view: View) -> Features:
        """Return the words of the paint's shader: NORMAL_MAP, COAT_RELIEF."""
        words = set()
        if self._normal_map is not None and view.relief.normal_map is not None:
            words.add("NORMAL_MAP")
        if self._tangents is not None and view.relief.tangent_map is not None:
            words.add("TANGENT_MAP")
        if view.relief.orange_peel > 0.0 or self._own_peels:
            if self._peel is None and self._make_peel is not None:
                self.set_peel(self._make_peel())
            if self._peel is not None:
                words.add("COAT_RELIEF")
        return frozenset(words)

    def has_second_paint(self, view: View) -> bool:
        """Whether a mask is there and wanted."""
        return self._mask is not None and view.two_tone.mask is not None and view.two_tone.paint is not None

    def bind(self, view: View, bounds: Bounds) -> dict[str, object]:
        """Bind what is there and return the uniforms of relief.glsl and mask.glsl."""
        values: dict[str, object] = {}
        if self._normal_map is not None:
            texture, aspect = self._normal_map
            texture.use(NORMAL_UNIT)
            width = view.relief.normal_width_mm
            values["normal_tiles"] = (1.0 / width, 1.0 / (width * aspect))
            values["normal_strength"] = view.relief.normal_strength
        if self._tangents is not None:
            texture, aspect = self._tangents
            texture.use(TANGENT_UNIT)
            width = view.relief.normal_width_mm
            values["tangent_tiles"] = (1.0 / width, 1.0 / (width * aspect))
        if self._peel is not None:
            self._peel[0].use(PEEL_UNIT)
        if self._mask is not None:
            texture, aspect = self._mask
            texture.use(MASK_UNIT)
            values |= mask_coordinates(view, bounds, aspect)
        return values

    def peel_uniforms(self, view: View, material: str) -> dict[str, object]:
        """Return the uniforms of orange_peel for one material: the view's, or where it has none the paint's own."""
        if self._peel is None:
            return {}
        own = self._own_peels.get(material)
        if view.relief.orange_peel > 0.0 or own is None:
            slope, length = view.relief.orange_peel, view.relief.orange_peel_mm
        else:
            slope, length = own.slope_deg, own.wavelength_mm
        return {
            "peel_tiles": 1.0 / (self._peel[1] * length),
            "peel_slope": float(np.tan(np.radians(slope))),
        }

    def release(self) -> None:
        """Give the textures back."""
        for held in (self._normal_map, self._tangents, self._peel, self._mask):
            self._give_back(held)
        self._normal_map = self._tangents = self._peel = self._mask = None

    def _slopes(self, slopes: NDArray[np.float32]) -> moderngl.Texture:
        pixels = np.zeros((*slopes.shape[:2], 4), np.float16)
        pixels[..., :2] = slopes
        pixels[..., 2] = (slopes**2).sum(axis=-1)
        return self._texture(pixels, "f2")

    def _texture(self, pixels: NDArray[np.uint8] | NDArray[np.float16], dtype: str) -> moderngl.Texture:
        made = self._objects.texture((pixels.shape[1], pixels.shape[0]), dtype)
        made.write(np.ascontiguousarray(pixels).tobytes())
        made.build_mipmaps()
        made.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
        # In software it is summed texel by texel over a pixel's whole ellipse, however many tiles that covers: one
        # frame took a hundred times as long. What a coarser level hides widens the lobes all the same.
        made.anisotropy = 1.0 if draws_in_software(self._objects.context) else _ANISOTROPY
        self._objects.counters.texture_uploads += 1
        return made

    def _give_back(self, held: tuple[moderngl.Texture, float] | None) -> None:
        if held is not None:
            self._objects.release(held[0])


def mask_coordinates(view: View, bounds: Bounds, aspect: float) -> dict[str, object]:
    """Return how mask.glsl comes from a place to the mask's coordinates, by the view's projection.

    ``uv``: tiles over the texture coordinates. Otherwise the image lies once over the bounding box, seen from the
    side (+x), the front (+z) or the top (+y, the front at its lower edge).
    """
    projection = view.two_tone.projection
    width = view.two_tone.mask_width_mm
    tiles = (1.0 / width, 1.0 / (width * aspect))
    if projection == "uv":
        return {"mask_tiles": tiles, "mask_u": (0.0,) * 4, "mask_v": (0.0,) * 4}
    low, high = np.asarray(bounds.minimum), np.asarray(bounds.maximum)
    # Which axis grows along the image's u and v as seen, and whether it runs against them.
    u_axis, u_sign, v_axis, v_sign = {
        "side": (2, -1.0, 1, 1.0),
        "front": (0, 1.0, 1, 1.0),
        "top": (0, 1.0, 2, -1.0),
    }[projection]
    rows = []
    for axis, sign in ((u_axis, u_sign), (v_axis, v_sign)):
        length = max(float(high[axis] - low[axis]), 1e-9)
        row = [0.0] * 4
        row[axis] = sign / length
        row[3] = -sign * float(low[axis] if sign > 0 else high[axis]) / length
        rows.append(tuple(row))
    return {"mask_tiles": (0.0, 0.0), "mask_u": rows[0], "mask_v": rows[1]}
