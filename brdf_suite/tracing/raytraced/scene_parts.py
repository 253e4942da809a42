"""What the ray tracer draws, part by part: each is made once and kept while what it is made of stays the same."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SECOND_PAINT
from brdf_suite.files.bounded_reading import file_stamp
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.paint_angles import material_weights
from brdf_suite.realtime.camera import Bounds, matrices
from brdf_suite.realtime.environment.backdrop import BLUR_EXPONENT
from brdf_suite.realtime.material.stock_materials import stock_materials
from brdf_suite.reference.bsdfs.translate import translate
from brdf_suite.reference.flakes.population import FlakeLayer
from brdf_suite.reference.raytraced.energy import TOLERANCE, largest_albedo
from brdf_suite.reference.raytraced.light_set import LightSet, Strata
from brdf_suite.reference.raytraced.quality import Quality
from brdf_suite.reference.raytraced.sky import TracedSky
from brdf_suite.reference.raytraced.split import split
from brdf_suite.reference.raytraced.surface import Surface, SurfaceArrays
from brdf_suite.reference.raytraced.table_split import TableSplit
from brdf_suite.reference.raytraced.tracer import LightArrays
from brdf_suite.reference.scene.backdrop import blur_map
from brdf_suite.reference.scene.camera import Pinhole, PinholeCamera
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.optics import divide_paint, load_lit, lobe_term
from brdf_suite.tracing.traced_picture import PAINT, Kept, Size, choose_materials

_BLURRED_ROWS = 96
_TOO_MUCH = "times the light that falls on it"


@dataclass(frozen=True, eq=False)
class PictureInputs:
    """All that a picture is made of, loaded; ``second`` is the paint of parts that wear it."""

    paint: Material
    environment: Environment
    mesh: Mesh
    view: View
    size: Size
    quality: Quality
    tables: TableSplit
    second: Material | None = None

    @property
    def paints(self) -> dict[str, Material]:
        """The paints by the words of parts that have them."""
        paints = {PAINT: self.paint}
        return paints if self.second is None else {**paints, SECOND_PAINT: self.second}


class Parts(Kept):
    """Makes the parts of a picture; what was made for the same is given again."""

    def second(self, view: View) -> Material | None:
        """Return the view's second paint, read where it changed; None where no part wears one."""
        asked = view.two_tone.paint
        if asked is None or not view.surface_look.wears_second:
            return None
        made_of = (asked, file_stamp(asked), view.light_colour.illuminant)
        return self.keep("second paint", made_of, lambda: load_lit(asked, view))

    def mesh(self, inputs: PictureInputs) -> tuple[Mesh, Bounds]:
        """Return the mesh with the materials that the view gives its parts, and its bounds."""

        def make() -> tuple[Mesh, Bounds]:
            mesh = choose_materials(inputs.mesh, inputs.view)
            return mesh, Bounds.of(p.positions for p in mesh.parts)

        worn = (inputs.view.surface_look.materials, inputs.view.two_tone.paint is None)
        return self.keep("mesh", (Same(inputs.mesh), *worn), make)

    def surface(self, mesh: Mesh, view: View) -> Any:
        """Return the mesh in the ray tracer."""
        numbers = {name: index for index, name in enumerate(materials_of(mesh))}

        def make() -> Surface:
            stock = stock_materials(default_basis().exponents)
            panes = {
                number: lobe_term(stock[name], view)
                for name, number in numbers.items()
                if name != PAINT and name in stock and stock[name].transmittance > 0.0
            }
            return Surface(SurfaceArrays.of(mesh.parts, numbers), panes)

        return self.keep("surface", (Same(mesh), view.fresnel), make)

    def splits(self, inputs: PictureInputs, mesh: Mesh) -> tuple[list[Any], tuple[str, ...]]:
        """Return each material cut in two, by its number, and sentences about the paint."""
        mirror, view = inputs.quality.mirrors, inputs.view
        names = materials_of(mesh)

        def stock() -> dict[str, Any]:
            weights = stock_materials(default_basis().exponents)
            used = {
                name: weights.get(name, weights["neutral"]) for name in names if name not in inputs.paints
            }
            return {name: split(lobe_term(w, view), mirror=mirror) for name, w in used.items()}

        cuts = dict(self.keep("stock", (tuple(names), mirror, view.fresnel), stock))
        notices: tuple[str, ...] = ()
        for name, paint in inputs.paints.items():
            if name in names:
                cuts[name], more = self._cut(name, paint, inputs)
                notices = (*notices, *more)
        return [cuts[name] for name in names], notices

    def _cut(self, name: str, paint: Material, inputs: PictureInputs) -> tuple[Any, tuple[str, ...]]:
        mirror, view = inputs.quality.mirrors, inputs.view
        made_of = (Same(paint.reflectance), view.fresnel)
        term, notices = self.keep(f"term of {name}", made_of, lambda: term_of(paint, view))
        cut = self.keep(
            f"cut of {name}",
            (Same(term), mirror, inputs.tables),
            lambda: split(term, mirror=mirror, tables=inputs.tables),
        )
        return cut, notices

    def light(self, inputs: PictureInputs) -> tuple[TracedSky, NDArray[np.float32]]:
        """Return the environment as rays find it, turned, and its radiance (h, w, 3) in the view's light colour."""
        environment, view = inputs.environment, inputs.view
        colour = view.light_colour
        made_of = (Same(environment), colour, inputs.quality.lights)

        def make() -> tuple[TracedSky, NDArray[np.float32]]:
            tint = environment_matrix(colour)
            radiance = np.maximum(environment.radiance @ tint.T.astype(np.float32), 0.0)
            return TracedSky.of(radiance, self._strata(inputs).without_suns(radiance)), radiance

        sky, radiance = self.keep("sky", made_of, make)
        turned = self.keep("turned", (*made_of, view.rotation_deg), lambda: sky.turned(view.rotation_deg))
        return turned, radiance

    def backdrop(self, inputs: PictureInputs) -> TracedSky:
        """Return the sky that is seen behind the object: the light's, or blurred where the view has it so."""
        view = inputs.view
        sky, radiance = self.light(inputs)
        if view.background != "blurred":
            return sky

        def make() -> TracedSky:
            around = direction(ring_angles(_BLURRED_ROWS)[:, None], column_angles(2 * _BLURRED_ROWS)[None])
            return TracedSky.of(blur_map(radiance, BLUR_EXPONENT)(around))

        soft = self.keep("blurred", (Same(inputs.environment), view.light_colour), make)
        return soft.turned(view.rotation_deg)

    def lights(self, inputs: PictureInputs, turn: int) -> LightArrays:
        """Return the lights of a round: the first, 0, are in the middle of their strata, others drawn from them."""
        view, quality = inputs.view, inputs.quality
        colour = view.light_colour
        tint = environment_matrix(colour)
        made_of = (Same(inputs.environment), quality.lights)

        def make() -> LightArrays:
            tinted = self._strata(inputs).tinted(tint)
            found: LightSet = tinted.middles() if turn == 0 else tinted.drawn(turn)
            everything = found.turned(view.rotation_deg).with_lamps(view.lamps, turn)
            return LightArrays.of(everything.dealt(quality.samples), view.lamps)

        return self.keep(
            "lights", (*made_of, quality.samples, colour, view.rotation_deg, view.lamps, turn), make
        )

    def _strata(self, inputs: PictureInputs) -> Strata:
        environment, count = inputs.environment, inputs.quality.lights
        return self.keep(
            "strata", (Same(environment), count), lambda: Strata.of(environment, count, np.eye(3))
        )

    def camera(self, view: View, bounds: Bounds, size: Size) -> Pinhole:
        """Return the eye of a view whose camera is placed, and its picture's size."""
        seen = matrices(view.camera, bounds, size)
        return Pinhole.of(PinholeCamera(seen.eye, seen.view_to_world, seen.half_tangents[0]), size)


class Same:
    """A value that equals itself alone, and stays alive as long as something was made of it."""

    def __init__(self, value: object) -> None:
        self._value = value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self._value is other._value

    def __hash__(self) -> int:
        return id(self._value)


def materials_of(mesh: Mesh) -> list[str]:
    """Return the materials of a mesh; their places are their numbers."""
    return sorted({part.material for part in mesh.parts})


def term_of(paint: Material, view: View) -> tuple[Any, tuple[str, ...]]:
    """Return what a paint reflects by, and sentences about it."""
    if isinstance(paint.reflectance, LobeWeights):
        return lobe_term(material_weights(paint.reflectance), view), ()
    translated = translate(paint.reflectance)
    notices = translated.notices
    most = largest_albedo(translated.term)
    if most > 1.0 + TOLERANCE and not any(_TOO_MUCH in notice for notice in paint.notices):
        notices = (*notices, f"This paint would reflect {most:.2f} {_TOO_MUCH}.")
    return translated.term, notices


def sparkle_of(paint: Material, view: View) -> FlakeLayer | None:
    """Return the flakes that are seen one by one; None where there are none, or the view shows none."""
    flakes = paint.flakes
    if flakes is None or view.sparkle.mode == "off" or flakes.density_per_mm2 <= 0.0:
        return None
    base, _, ior, _ = divide_paint(paint.reflectance, view)
    return FlakeLayer.of(flakes, base, ior, view.sparkle.strength, as_texture=True)
