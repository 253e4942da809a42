"""The ray-traced picture: a scene that follows what is edited, in passes that make it better and better.

    session = RaytracedSession()
    session.show("blue", View(), (640, 480), "medium")
    for image in session.passes():
        picture = image.codes()       # (480, 640, 3) uint8, as a screen shows it

Another camera, paint, turn of the light, exposure or size costs some hundredths of a second: nothing is compiled anew.
Another light or surface is read and built anew. The ray tracer is an optional extra; nothing of it is imported before
a session begins.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from itertools import chain
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.documents.store import view_to_json
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import Material
from brdf_suite.progress import Progress, report
from brdf_suite.realtime.camera import compose
from brdf_suite.realtime.environment.backdrop import plain_backdrop
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.raytraced.frames import Film, trace_samples
from brdf_suite.reference.raytraced.picture import Sums
from brdf_suite.reference.raytraced.quality import DEFAULT_PRESET, PRESETS, Quality, find_quality
from brdf_suite.reference.raytraced.sky import TracedSky, sky_behind
from brdf_suite.reference.raytraced.table_split import TableSplit
from brdf_suite.reference.raytraced.tracer import SampleBudget, TracerScene
from brdf_suite.reference.scene.camera import Pinhole
from brdf_suite.reference.variant import start
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.raytraced.scene_parts import Parts, PictureInputs, materials_of, sparkle_of
from brdf_suite.tracing.traced_picture import (
    SceneFacts,
    Size,
    digest_mesh,
    digest_reflectance,
    load_inputs,
    too_large,
)

_LIT_BY = ("camera", "rotation_deg", "fresnel", "light_colour", "lamps", "sparkle", "surface_look")
_VERSION = 1


def scene_key(inputs: PictureInputs, mesh: Mesh) -> str:
    """Return a word that is the same for the same light, whatever its exposure, tone curve or backdrop."""
    document = view_to_json(inputs.view)
    shown = {name: document[name] for name in _LIT_BY if name in document}
    quality = {**asdict(inputs.quality), "tables": inputs.tables, "version": _VERSION}
    digest = hashlib.sha256(json.dumps([shown, quality], sort_keys=True).encode())
    digest.update(repr((inputs.size, inputs.environment.content_hash)).encode())
    for paint in inputs.paints.values():
        digest.update(repr((paint.name, paint.flakes)).encode())
        digest_reflectance(paint.reflectance, digest, 256)
    digest_mesh(mesh, digest)
    return digest.hexdigest()


__all__ = ["DEFAULT_PRESET", "PRESETS", "Quality", "RaytracedImage", "RaytracedScene", "RaytracedSession"]

PASS_SECONDS = 0.2
"""How long a pass takes, about: a picture is shown as often, and given up as soon."""


@dataclass(frozen=True, eq=False, kw_only=True)
class RaytracedScene(SceneFacts):
    """A scene to be ray-traced."""

    quality: Quality
    camera: Pinhole
    sky: TracedSky

    @cached_property
    def behind(self) -> NDArray[np.float32]:
        """What the object leaves free, (h, w, 3): radiance, or the screen's light where it is of one colour."""
        if self.view.background in ("environment", "blurred"):
            return sky_behind(self.sky, self.camera, self.size)
        plain = plain_backdrop(self.view).astype(np.float32)
        return np.broadcast_to(plain, (self.size[1], self.size[0], 3))


@dataclass(frozen=True, eq=False)
class RaytracedImage:
    """A picture of a scene, of as many samples as there are so far."""

    scene: RaytracedScene
    sums: Sums

    @cached_property
    def exposed_view(self) -> View:
        """The view with its exposure measured where it is automatic."""
        return self.scene.measure_exposure(self.sums.radiance, self.sums.coverage)

    def whole(self) -> Floats:
        """Return the radiance (h, w, 3) of the whole picture, working space, before exposure."""
        behind = self.scene.behind
        if self.scene.view.background in ("grey", "colour"):
            # A backdrop of one colour looks the same at any exposure; the environment is light like any other.
            behind = behind / np.float32(2.0**self.exposed_view.exposure_ev)
        return self.sums.before(behind)

    def codes(self) -> NDArray[np.uint8]:
        """Return the picture (h, w, 3) uint8 sRGB as the real-time renderer would show this light."""
        return self.scene.show(self.whole(), self.exposed_view)


class RaytracedSession:
    """One ray-traced scene that follows what it is shown; for one thread.

    Raises
    ------
    ExtraError
        Mitsuba is missing or cannot be loaded; the message says how to install it.
    ReferenceUnavailableError
        LLVM is missing; the message says what to install.
    """

    def __init__(self) -> None:
        self._renderer = start().title
        self._parts = Parts()
        self._wanted: PictureInputs | None = None
        self._scene: RaytracedScene | None = None
        self._rays_per_second = 4e6

    @property
    def scene(self) -> RaytracedScene:
        """What was shown last."""
        if self._scene is None:
            raise SuiteError("Nothing has been shown to the ray tracer yet.")
        return self._scene

    def show(
        self,
        paint: str | os.PathLike[str] | Material,
        view: View,
        size: Size,
        quality: str | Quality = DEFAULT_PRESET,
        progress: Progress | None = None,
        *,
        tables: TableSplit = "clamp",
        environment: Environment | None = None,
        mesh: Mesh | None = None,
    ) -> RaytracedScene:
        """Show a material, loaded or by name or file, in a view, ``size`` in pixels.

        Parameters
        ----------
        quality
            A name of :data:`PRESETS`, or a quality of one's own.
        tables
            How a measured table is cut in a broad part and its peak: ``clamp`` or ``subtract``.
        environment, mesh
            Where they are given, they take the place of those that the view names: a light that is being edited is
            in no file.

        Raises
        ------
        FileError
            The paint, environment or surface cannot be read.
        UnreachableError
            No such paint can be.
        ValueRangeError
            There is no such quality.
        """
        chosen = find_quality(quality)
        loaded = load_inputs(self._parts, paint, view, environment, mesh, progress)
        inputs = PictureInputs(*loaded, view, size, chosen, tables, self._parts.second(view))
        report(progress, 0.9, "building the scene")
        shaped, bounds = self._parts.mesh(inputs)
        inputs = replace(inputs, view=replace(view, camera=compose(view.camera, bounds, size)))
        _, paint_notices = self._parts.splits(inputs, shaped)
        self._wanted = inputs
        notices = chain.from_iterable(paint.notices for paint in inputs.paints.values())
        of_files = *inputs.environment.notes, *shaped.notes
        self._scene = RaytracedScene(
            name=inputs.paint.name,
            environment=inputs.environment.name,
            surface=shaped.name,
            renderer=self._renderer,
            notices=(*notices, *paint_notices, *of_files, *left_out(inputs)),
            view=inputs.view,
            size=size,
            key=scene_key(inputs, shaped),
            quality=inputs.quality,
            camera=self._parts.camera(inputs.view, bounds, size),
            sky=self._parts.backdrop(inputs),
        )
        report(progress, 1.0, "ready")
        return self._scene

    def passes(
        self,
        rounds: int | None = 1,
        *,
        begun: Sums | None = None,
        samples: int | None = None,
        between: Callable[[float], None] | None = None,
    ) -> Iterator[RaytracedImage]:
        """Yield ever better pictures of what is shown, the last of them whole.

        Parameters
        ----------
        rounds
            How often the quality's samples are taken; None: without end. Every round after the first has its lights
            drawn anew, so that the mean goes on to converge.
        begun
            Sums to go on from, of the same key.
        samples
            End at so many samples a pixel instead, be the round whole or not.
        between
            Called several times within a pass, with the share of it that is done; what it raises ends the tracing.

        Raises
        ------
        ReferenceUnavailableError
            The renderer failed, as it does where memory runs out.
        """
        scene, inputs = self.scene, self._wanted
        assert inputs is not None
        per_round = scene.quality.samples
        end = samples if samples is not None else None if rounds is None else rounds * per_round
        try:
            film: Film = self._parts.keep("film", scene.size, lambda: Film(scene.size))
            sums = begun or Sums.nothing(scene.size)
        except MemoryError as error:
            raise too_large(scene.size) from error
        rays = rays_a_sample(scene.quality)
        pixels = scene.size[0] * scene.size[1]
        while end is None or sums.samples < end:
            turn, done = divmod(sums.samples, per_round)
            fitting = round(PASS_SECONDS * self._rays_per_second / (rays * pixels))
            count = max(1, min(fitting, per_round - done))
            count = count if end is None else min(count, end - sums.samples)
            stage = self.tracer_scene(turn)
            deal = SampleBudget.of(scene.quality, len(stage.lights.kinds))
            start = perf_counter()
            values = trace_samples(
                stage, scene.camera, deal, film, sums.samples, count, rays_a_sample=rays, between=between
            )
            spent = perf_counter() - start
            # The first pass may compile: it says little about the speed.
            measured = count * rays * pixels / max(spent, 1e-6)
            self._rays_per_second = 0.5 * (self._rays_per_second + measured)
            sums = sums.plus(values, count, spent)
            yield RaytracedImage(scene, sums)

    def frame(self) -> RaytracedImage:
        """Return the whole picture of what is shown. Errors as :meth:`passes`."""
        *_, image = self.passes()
        return image

    def tracer_scene(self, turn: int) -> TracerScene:
        """Return what is traced with the lights of a round, made of the parts that are kept."""
        inputs = self._wanted
        assert inputs is not None
        mesh, bounds = self._parts.mesh(inputs)
        names = materials_of(mesh)
        splits, _ = self._parts.splits(inputs, mesh)
        sky, _ = self._parts.light(inputs)
        return TracerScene(
            self._parts.surface(mesh, inputs.view),
            splits,
            sky,
            self._parts.lights(inputs, turn),
            d.number(bounds.minimum[1]) if inputs.view.surface_look.ground else None,
            {
                number: layer
                for number, name in enumerate(names)
                if name in inputs.paints
                and (layer := sparkle_of(inputs.paints[name], inputs.view)) is not None
            },
        )


def rays_a_sample(quality: Quality) -> float:
    """Return about how many rays a sample traces: what is reflected meets the surface again now and then."""
    return 1.0 + quality.lights_a_sample + 2.0 * quality.reflections_a_sample


def left_out(inputs: PictureInputs) -> tuple[str, ...]:
    """Return sentences about what the view asks for and the ray tracer does not draw."""
    view, notices = inputs.view, []
    peeled = view.relief.orange_peel > 0.0 or any(
        paint.orange_peel is not None for paint in inputs.paints.values()
    )
    if view.relief.normal_map is not None or peeled:
        notices.append("The ray tracer shows a smooth surface, without normal map and orange peel.")
    if view.two_tone.paint is not None and view.two_tone.mask is not None:
        notices.append("The ray tracer shows the first paint alone where the mask divides two.")
    if view.lens.blurs:
        notices.append(
            "The ray tracer shows all sharp: without depth of field, and without the blur of a turn."
        )
    return tuple(notices)
