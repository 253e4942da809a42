"""Scene to path-traced picture: the same paint, environment, surface and view as the real-time picture's.

The path tracer is an optional extra; nothing of it is imported before it is asked for.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.arrays import Floats
from brdf_suite.documents.store import view_to_json
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SECOND_PAINT
from brdf_suite.errors import PathLike, UnreachableError
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import illumination, spherical
from brdf_suite.lighting.environment import Environment
from brdf_suite.output.exposures import aperture_radius, focused, moment_of
from brdf_suite.output.turning import turned
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.scene import find_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.camera import Bounds, compose, matrices
from brdf_suite.realtime.environment.backdrop import BLUR_EXPONENT, plain_backdrop
from brdf_suite.realtime.material.stock_materials import stock_materials
from brdf_suite.reference.bsdfs.plugin import make_pane
from brdf_suite.reference.passes import Estimate
from brdf_suite.reference.scene.backdrop import Look, backdrop, blur_map, sharp
from brdf_suite.reference.scene.camera import PinholeCamera
from brdf_suite.reference.scene.ground import GroundGrid
from brdf_suite.reference.scene.scene import Moment, SurfacePart, TracedScene, build_scene
from brdf_suite.reference.variant import Variant, start
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.optics import (
    Dress,
    load_dress,
    load_lit,
    lobe_term,
    optics_of,
    scalar_lobes,
    scalar_optics,
)
from brdf_suite.tracing.traced_picture import (
    PAINT,
    SceneFacts,
    Size,
    choose_materials,
    digest_mesh,
    digest_reflectance,
)

ANGLES_DEG = (0.0, 30.0, 60.0, 75.0)
ALLOWED = 1.01
"""Of the light that arrives; the quadrature is sure of half a per cent."""
_AZIMUTHS = 16
_LOOKS = 256


def energy_notices(reflectance: Reflectance, name: str) -> tuple[str, ...]:
    """Return a sentence where a paint sends back more light than it gets; some milliseconds.

    Raises
    ------
    UnreachableError
        It gives numbers that are negative or not finite, in which no path can be traced.
    """
    rng = np.random.default_rng(3)
    wi, wo = (spherical(np.arccos(rng.random(_LOOKS)), rng.uniform(0.0, 6.28, _LOOKS)) for _ in "io")
    values = reflectance.eval(wi, wo)
    if not np.isfinite(values).all() or (values < 0.0).any():
        raise UnreachableError(
            f"{name} reflects amounts that are negative or not finite, so no light can be traced in it; "
            "brdf-suite check says where."
        )
    albedo = directional_albedo(reflectance, illumination(np.array(ANGLES_DEG)), _AZIMUTHS)
    row, channel = np.unravel_index(int(np.argmax(albedo)), albedo.shape)
    largest = float(albedo[row, channel])
    if not np.isfinite(largest):
        raise UnreachableError(f"{name} reflects an endless amount of light at {ANGLES_DEG[row]:g}°.")
    if largest <= ALLOWED:
        return ()
    return (
        f"{name} sends back {100.0 * largest:.0f} % of the {('red', 'green', 'blue')[channel]} light that arrives at "
        f"{ANGLES_DEG[row]:g}°, more than there is. It is traced as it stands; where the surface sees itself, light "
        "grows with each reflection.",
    )


GROUND_SAMPLES, GROUND_PASS = 256, 32
"""Directions at each place of the ground, for its shadow behind the object."""
_MOMENTS = 16
"""Of an exposure in which the object turns, for what is behind it."""
_LIT_BY = (
    "camera",
    "rotation_deg",
    "fresnel",
    "light_colour",
    "lamps",
    "surface_look",
    "relief",
    "two_tone",
    "lens",
)
"""What of a view the traced light depends on, beside environment and surface."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ReferenceScene(SceneFacts):
    """A scene ready to be traced."""

    traced: TracedScene
    eye: PinholeCamera
    light: NDArray[np.float32]
    ground: GroundGrid | None = None

    @cached_property
    def behind(self) -> Floats:
        """What the object leaves free, (h, w, 3): radiance, or the screen's light where it is of one colour."""
        plain = self.view.background in ("grey", "colour")
        if self.ground is None and plain:
            return np.broadcast_to(plain_backdrop(self.view), (self.size[1], self.size[0], 3))
        look = None
        if not plain:
            of_map = self.view.background == "environment"
            look = sharp(self.light) if of_map else blur_map(self.light, BLUR_EXPONENT)
        moments = self.traced.moments
        if moments is None:
            return self._behind(look, self.eye, self.view.rotation_deg, self.ground, GROUND_SAMPLES)
        total: Floats = np.zeros((self.size[1], self.size[0], 3))
        for number in range(_MOMENTS):
            moment, ground = moments(number), None
            self.traced.go_to(moment)
            if self.ground is not None:
                nothing = np.zeros_like(self.ground.arriving)
                ground = replace(
                    self.ground, arriving=nothing, open_light=np.zeros(3), samples=0, lamps=moment.lamps
                )
            total += self._behind(look, moment.eye, moment.rotation_deg, ground, GROUND_SAMPLES // _MOMENTS)
        return total / _MOMENTS

    def _behind(
        self,
        look: Look | None,
        eye: PinholeCamera,
        rotation_deg: float,
        ground: GroundGrid | None,
        samples: int,
    ) -> Floats:
        while ground is not None and ground.samples < samples:
            ground.trace(self.traced.scene, min(GROUND_PASS, samples))
        share = None if ground is None else ground.seen_from
        return backdrop(eye, self.size, rotation_deg, look, plain_backdrop(self.view), share)

    def whole(self, estimate: Estimate) -> Floats:
        """Return the radiance (h, w, 3) of the whole picture, working space, before exposure."""
        behind = self.behind
        if self.view.background in ("grey", "colour"):
            # A backdrop of one colour looks the same at any exposure; the environment is light like any other.
            behind = behind / 2.0 ** self.exposed_view(estimate).exposure_ev
        room = np.clip(1.0 - estimate.coverage, 0.0, 1.0)[..., None]
        return np.asarray(estimate.radiance + room * behind)

    def exposed_view(self, estimate: Estimate) -> View:
        """Return the view with its exposure measured where it is automatic."""
        return self.measure_exposure(estimate.radiance, estimate.coverage)

    def codes(self, estimate: Estimate) -> NDArray[np.uint8]:
        """Return the picture (h, w, 3) uint8 sRGB as the real-time renderer would show this light."""
        return self.show(self.whole(estimate), self.exposed_view(estimate))


def prepare_reference(
    paint: PathLike | Material,
    view: View,
    size: Size,
    *,
    environment: Environment | None = None,
    progress: Progress | None = None,
) -> ReferenceScene:
    """Load everything and hand it to the path tracer; an ``environment`` in memory takes the place of the view's.

    Raises
    ------
    ExtraError
        Mitsuba is missing or cannot be loaded; the message says how to install it.
    ReferenceUnavailableError
        LLVM is missing; the message says what to install.
    FileError
        The paint, environment or surface cannot be read.
    UnreachableError
        No such paint can be.
    """
    report(progress, 0.0, "starting the path tracer")
    variant = start(scalar=True)
    material = load_lit(paint, view)
    report(progress, 0.3, "reading the environment")
    if environment is None:
        _, path = find_environment(view.environment)
        environment = read_environment(path, view.environment_layout, subrange(progress, 0.3, 0.6))
    mesh = load_shaped(view.surface, view.surface_look, subrange(progress, 0.6, 0.8))
    return build_reference(material, view, size, environment, mesh, variant=variant)


def build_reference(
    material: Material,
    view: View,
    size: Size,
    environment: Environment,
    mesh: Mesh,
    *,
    dress: Dress | None = None,
    kept: ReferenceScene | None = None,
    variant: Variant | None = None,
) -> ReferenceScene:
    """Return the scene of what is loaded already; fitted weights as the reflectance are traced as they are.

    ``dress`` is what the view lays on it,
    read anew where it is not given. ``kept`` is a scene of the same parts, lamps and size of map: it is changed in
    place, which takes no building and no compiling, and must not be used after. ``variant`` is the one that was
    started, where it may be the scalar one. Errors as :func:`prepare_reference`.
    """
    variant = start() if variant is None else variant
    bounds = Bounds.of(p.positions for p in mesh.parts)
    view = focused(replace(view, camera=compose(view.camera, bounds, size)), mesh, size)
    eye = _eye(view, bounds, size)
    mesh = choose_materials(mesh, view)
    dress = load_dress(view) if dress is None else dress
    energy = _energy(material, dress)
    if variant.is_scalar:
        make_optics = partial(scalar_optics, view=view, instead=variant.instead)
    else:
        make_optics = partial(optics_of, view=view, bounds=bounds)
    optics = make_optics(material, dress)
    used = {p.material for p in mesh.parts}
    paints = {PAINT: optics.term}
    if dress.second is not None and SECOND_PAINT in used:
        paints[SECOND_PAINT] = make_optics(dress.second, replace(dress, mask=None, second=None)).term
    make = scalar_lobes if variant.is_scalar else lobe_term
    stock = stock_materials(default_basis().exponents).items()
    others = {
        name: make_pane(weights.ior, weights.transmittance) if weights.transmittance else make(weights, view)
        for name, weights in stock
        if name in used
    }
    terms = {**others, **paints}
    tint = environment_matrix(view.light_colour)
    radiance = np.maximum(environment.radiance @ tint.T.astype(np.float32), 0.0)
    ground = None
    if view.surface_look.ground and not variant.is_scalar:
        ground = GroundGrid.under(np.array(bounds.minimum), np.array(bounds.maximum))
    if kept is None or ground is not None:
        parts = [SurfacePart(p.material, p.positions, p.normals, p.triangles, p.uvs) for p in mesh.parts]
        traced = build_scene(parts, terms, radiance, eye, view, size, ground=ground)
    else:
        traced = kept.traced
        for part_name, term in terms.items():
            traced.set_term(part_name, term)
        traced.look_from(eye, size)
        traced.set_light(None if np.array_equal(radiance, kept.light) else radiance, view.rotation_deg)
    traced.moments = None if view.lens.turn_deg == 0.0 else partial(_moment, view, bounds, size)
    return ReferenceScene(
        name=material.name,
        traced=traced,
        view=view,
        size=size,
        key=_key(material, dress, view, size, environment, mesh),
        environment=environment.name,
        surface=mesh.name,
        renderer=variant.title,
        notices=(
            *material.notices,
            *energy,
            *optics.notices,
            *environment.notes,
            *mesh.notes,
            *_left_out(view, material, dress),
        ),
        eye=eye,
        light=radiance,
        ground=ground,
    )


def _eye(view: View, bounds: Bounds, size: Size) -> PinholeCamera:
    camera = matrices(view.camera, bounds, size)
    return PinholeCamera(
        camera.eye,
        camera.view_to_world,
        camera.half_tangents[0],
        aperture_radius(view),
        view.lens.focus_distance or 1.0,
    )


def _moment(view: View, bounds: Bounds, size: Size, number: int) -> Moment:
    shown = turned(view, moment_of(number) * view.lens.turn_deg, bounds.centre)
    return Moment(_eye(shown, bounds, size), shown.rotation_deg, shown.lamps)


def _energy(paint: Material, dress: Dress) -> tuple[str, ...]:
    """Sentences about paints that send back more light than they get; fitted weights are what they are."""
    notices: tuple[str, ...] = ()
    for worn in (paint, dress.second):
        if worn is not None and not isinstance(worn.reflectance, LobeWeights):
            notices += energy_notices(worn.reflectance, worn.name)
    return notices


def _left_out(view: View, paint: Material, dress: Dress) -> tuple[str, ...]:
    """Sentences about what the view asks for and the path tracer draws otherwise, or not."""
    notices = []
    worn = [item for item in (paint, dress.second) if item is not None]
    if view.fresnel == "off" and any(not isinstance(item.reflectance, LobeWeights) for item in worn):
        notices.append(
            "The reference shows the paint with its own reflection towards grazing: Fresnel is part of it."
        )
    if not view.surface_look.occlusion:
        notices.append("The reference always shows the shadows of the surface on itself.")
    return tuple(notices)


def _key(paint: Material, dress: Dress, view: View, size: Size, environment: Environment, mesh: Mesh) -> str:
    """Hash what the light of a scene depends on; how the light is shown is no part of it."""
    document = view_to_json(view)
    shown = {name: document[name] for name in _LIT_BY if name in document}
    if paint.flakes is not None or (dress.second is not None and dress.second.flakes is not None):
        shown["sparkle"] = document["sparkle"]
    digest = hashlib.sha256(json.dumps(shown, sort_keys=True).encode())
    digest.update(repr((paint.name, size, environment.content_hash)).encode())
    for worn in (paint, dress.second):
        if worn is not None:
            digest_reflectance(worn.reflectance, digest, 512)
            if worn.flakes is not None or worn.orange_peel is not None:
                digest.update(repr((worn.flakes, worn.orange_peel)).encode())
    if dress.normal_map is not None:
        digest.update(dress.normal_map.slopes.tobytes())
    if dress.mask is not None:
        digest.update(dress.mask.share.tobytes())
    digest_mesh(mesh, digest)
    return digest.hexdigest()
