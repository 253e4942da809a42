"""Path tracer's scene with the values and orientation of the real-time renderer.

World axes are those of the core (right-handed, y up, metres). The environment's centre column looks along +z and u
grows towards -x, which is Mitsuba's convention too. Mitsuba takes a map's first and last row for the poles
themselves, where ours are half a row away; a map with a row between each two of ours, and one at each pole, is the same
light to Mitsuba's bilinear look-up as ours is to our own.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.reference.bsdfs.plugin import make_bsdf
from brdf_suite.reference.mitsuba_modules import mi
from brdf_suite.reference.scene.camera import Pinhole, PinholeCamera
from brdf_suite.reference.scene.ground import FIRST_SAMPLES, GroundGrid, ground_mesh
from brdf_suite.reference.scene.lamps import LampAim, lamp_emitter
from brdf_suite.reference.scene.place import aligned, texture

DEFAULT_DEPTH = 8
"""Surfaces that a path may meet, and one more for the light: interreflections of a car body fade by a factor each."""


@dataclass(frozen=True, eq=False)
class SurfacePart:
    """Triangles that share a material: positions and normals (n, 3), triangles (k, 3), uvs (n, 2) in millimetres."""

    material: str
    positions: npt.NDArray[Any]
    normals: npt.NDArray[Any]
    triangles: npt.NDArray[Any]
    uvs: npt.NDArray[Any] | None = None


@dataclass(frozen=True, eq=False)
class Moment:
    """Where camera, light and lamps are at a moment of the exposure, seen from the object that turns."""

    eye: PinholeCamera
    rotation_deg: float
    lamps: tuple[Lamp, ...]


@dataclass(eq=False)
class TracedScene:
    """A scene in Mitsuba. Its methods change values in place, without rebuilding or recompiling.

    Attributes
    ----------
    scene
        Mitsuba's.
    size
        Width and height, pixels.
    terms
        What each material reflects by, by the material's name.
    discs
        The lamps with an extent, by name.
    moments
        The moment of a pass, by the pass's number; None where nothing moves while the shutter is open.
    """

    scene: Any
    size: tuple[int, int]
    terms: Mapping[str, Any]
    bsdfs: Mapping[str, Any] = field(default_factory=dict)
    discs: Mapping[str, Any] = field(default_factory=dict)
    moments: Callable[[int], Moment] | None = None

    def set_term(self, material: str, term: Any) -> None:
        """Set the term of a material from the next pass on."""
        if not isinstance(term, mi.BSDF):  # a pane stays what it is
            self.bsdfs[material].term = term
        self.terms = {**self.terms, material: term}

    def look_from(self, eye: PinholeCamera, size: tuple[int, int]) -> None:
        """Move the camera, and change the size of the picture; a lens stays one, and a pinhole one."""
        values = mi.traverse(self.scene)
        values["sensor.to_world"] = mi.Transform4f(_to_world(eye).matrix)
        values["sensor.x_fov"] = math.degrees(2.0 * math.atan(eye.half_width_tangent))
        if eye.aperture > 0.0:
            values["sensor.aperture_radius"], values["sensor.focus_distance"] = eye.aperture, eye.focus
        for name in ("size", "crop_size"):
            values[f"sensor.film.{name}"] = mi.ScalarVector2u(*size)
        values.update()
        self.size = size
        _set_viewpoint(self.bsdfs, eye, size)

    def set_light(self, radiance: npt.NDArray[np.float32] | None, rotation_deg: float) -> None:
        """Turn the light, and take another map (h, w, 3) of the same size where one is given."""
        values = mi.traverse(self.scene)
        if radiance is not None:
            pixels = mitsuba_map(radiance)
            # Mitsuba keeps the last column before the first, and the first after the last.
            values["light.data"] = mi.TensorXf(
                np.concatenate((pixels[:, -1:], pixels, pixels[:, :1]), axis=1)
            )
        values["light.to_world"] = mi.Transform4f(_turned(rotation_deg).matrix)
        values.update()

    def go_to(self, moment: Moment) -> None:
        """Move camera, light and lamps to where they are at a moment."""
        self.look_from(moment.eye, self.size)
        self.set_light(None, moment.rotation_deg)
        values = mi.traverse(self.scene)
        for index, lamp in enumerate(moment.lamps):
            name, aim = f"lamp_{index}", LampAim.of(lamp)
            if name in self.discs:
                self.discs[name].aim = aim
            elif aim.near:
                values[f"{name}.position"] = mi.Point3f(*aim.place)
            else:
                values[f"{name}.to_world"] = mi.Transform4f(_shining(aim.place).matrix)
        values.update()


def build_scene(
    parts: Sequence[SurfacePart],
    terms: Mapping[str, Any],
    radiance: npt.NDArray[np.float32],
    eye: PinholeCamera,
    view: View,
    size: tuple[int, int],
    *,
    depth: int = DEFAULT_DEPTH,
    ground: GroundGrid | None = None,
) -> TracedScene:
    """Return the scene: ``parts`` with the terms, or BSDFs, of their materials, in the light of a map (h, w, 3)."""
    # In the scalar variant materials are Mitsuba's own plug-ins already.
    bsdfs = {name: term if isinstance(term, mi.BSDF) else make_bsdf(term) for name, term in terms.items()}
    glazed = any(mi.has_flag(bsdfs[part.material].flags(), mi.BSDFFlags.Null) for part in parts)
    described: dict[str, Any] = {
        "type": "scene",
        "integrator": {
            # Light is looked for through panes.
            "type": "volpath" if glazed else "path",
            "max_depth": depth + 1,
            "rr_depth": 5,
            # What is behind the object is added without noise, by coverage; see backdrop.py.
            "hide_emitters": True,
        },
        "sensor": _sensor(eye, size),
        "light": {
            "type": "envmap",
            "bitmap": mi.Bitmap(mitsuba_map(radiance)),
            "to_world": _turned(view.rotation_deg),
        },
    }
    _set_viewpoint(bsdfs, eye, size)
    for index, lamp in enumerate(view.lamps):
        described[f"lamp_{index}"] = lamp_emitter(lamp)
    for index, part in enumerate(parts):
        described[f"part_{index}"] = _mesh(f"part_{index}", part, bsdfs[part.material])
    discs = {name: one for name, one in described.items() if isinstance(one, mi.Emitter)}
    if ground is None:
        return TracedScene(mi.load_dict(described), size, terms, bsdfs, discs)
    described["light"] = mi.load_dict(described["light"])
    described["ground"], emitter = ground_mesh(ground, described["light"])
    traced = TracedScene(mi.load_dict(described), size, terms, bsdfs, discs)
    ground.lamps = view.lamps
    ground.trace(traced.scene, FIRST_SAMPLES)
    emitter.share = texture(ground.share, repeat=False)
    return traced


def _set_viewpoint(bsdfs: Mapping[str, Any], eye: PinholeCamera, size: tuple[int, int]) -> None:
    ours = [bsdf for bsdf in bsdfs.values() if hasattr(bsdf, "term")]
    if ours:
        viewpoint = Pinhole.of(eye, size)
        for bsdf in ours:
            bsdf.viewpoint = viewpoint


def mitsuba_map(radiance: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """Return the map (2h + 1, w, 3) whose look-up by Mitsuba is ours of ``radiance`` (h, w, 3)."""
    rows, columns = radiance.shape[:2]
    # Beyond a pole lies the same ring, half a turn further.
    first, last = (np.roll(radiance[ring], columns // 2, 0)[None] for ring in (0, -1))
    rings = np.concatenate([first, radiance, last])
    found = np.empty((2 * rows + 1, columns, 3), np.float32)
    found[1::2] = radiance
    found[::2] = 0.5 * (rings[:-1] + rings[1:])
    return found


def _turned(rotation_deg: float) -> Any:
    return mi.ScalarTransform4f().rotate([0, 1, 0], rotation_deg)


def _shining(towards: Sequence[float]) -> Any:
    """Return the transform of a distant lamp that lies in the direction ``towards``."""
    up = [1, 0, 0] if abs(towards[1]) > 0.9 else [0, 1, 0]
    return mi.ScalarTransform4f().look_at(origin=[0, 0, 0], target=[-x for x in towards], up=up)


def _to_world(eye: PinholeCamera) -> Any:
    target = eye.place - eye.axes[:, 2]
    return mi.ScalarTransform4f().look_at(
        origin=eye.place.tolist(), target=target.tolist(), up=eye.axes[:, 1].tolist()
    )


def _sensor(eye: PinholeCamera, size: tuple[int, int]) -> dict[str, Any]:
    return {
        **_lens(eye),
        "fov_axis": "x",
        "fov": math.degrees(2.0 * math.atan(eye.half_width_tangent)),
        "near_clip": 1e-4,
        "far_clip": 1e7,
        "to_world": _to_world(eye),
        "sampler": {"type": "multijitter"},
        "film": {
            "type": "hdrfilm",
            "width": size[0],
            "height": size[1],
            "pixel_format": "rgba",
            "component_format": "float32",
            "rfilter": {"type": "box"},
        },
    }


def _lens(eye: PinholeCamera) -> dict[str, Any]:
    if eye.aperture <= 0.0:
        return {"type": "perspective"}
    return {"type": "thinlens", "aperture_radius": eye.aperture, "focus_distance": eye.focus}


def _mesh(name: str, part: SurfacePart, bsdf: Any) -> Any:
    properties = mi.Properties()
    properties["bsdf"] = bsdf
    mesh = mi.Mesh(
        name,
        len(part.positions),
        len(part.triangles),
        has_vertex_normals=True,
        has_vertex_texcoords=part.uvs is not None,
        props=properties,
    )
    values = mi.traverse(mesh)
    arrays = {"positions": part.positions, "normals": part.normals, "texcoords": part.uvs}
    for what, array in arrays.items():
        if array is not None:
            values[f"vertex_{what}"] = aligned(array).ravel()
    values["faces"] = aligned(part.triangles, np.uint32).ravel()
    values.update()
    return mesh
