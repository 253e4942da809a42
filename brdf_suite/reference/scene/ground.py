"""Ground under the object, as in the real-time picture: the environment continued, in the object's shadow.

A level plane sends, towards wherever it is seen from, what the environment would send from there, times the share of
the light of environment and lamps that arrives at the place: ∫ V L cosθ / ∫ L cosθ for each channel, V = 0 where the
object is in the way. So the object stands in its own shadow and sees it, and no light comes through the plane from
below. The camera does not see the plane: the backdrop is multiplied by the same share. The share is traced on a grid
of places, by directions that are drawn as bright as the light is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.reference.mitsuba_modules import dr, mi, per_variant
from brdf_suite.reference.scene.lamps import lamp_light
from brdf_suite.reference.scene.place import texture

LONG_SIDE = 256
"""Places along the longer edge of the grid."""
FIRST_SAMPLES = 32
_REACH = 2.0
"""How far the grid goes beyond the object, in its heights: the shadow of a light 27° high."""
_RIM = 0.1
_LIFT = 1e-4


MOST_PANES = 8


@dataclass(eq=False)
class GroundGrid:
    """A grid of places on the ground, with their known irradiance.

    ``height`` in metres, ``low`` and ``high`` (x, z) of the grid's edges; ``arriving`` (rows along z, columns along x,
    3) the mean of ``samples`` directions a place, ``open_light`` that of open places, (3,) where there are no lamps.
    """

    height: float
    low: tuple[float, float]
    high: tuple[float, float]
    arriving: Floats
    open_light: Floats = field(default_factory=lambda: np.zeros(3))
    samples: int = 0
    passes: int = 0
    lamps: tuple[Lamp, ...] = ()

    @classmethod
    def under(cls, low: npt.NDArray[Any], high: npt.NDArray[Any]) -> GroundGrid:
        """Return the ground that touches the lowest point of an object with these corners (3,)."""
        size = np.asarray(high, float) - low
        margin = _REACH * size[1] + 0.1 * max(size[0], size[2])
        begin, end = np.asarray(low, float)[[0, 2]] - margin, np.asarray(high, float)[[0, 2]] + margin
        texel = float((end - begin).max()) / LONG_SIDE
        columns, rows = (max(8, math.ceil(length / texel)) for length in end - begin)
        return cls(
            float(low[1]),
            (float(begin[0]), float(begin[1])),
            (float(end[0]), float(end[1])),
            np.zeros((rows, columns, 3)),
        )

    @property
    def share(self) -> Floats:
        """(rows, columns, 3): the share of the light that arrives, 0…1; 1 at the edges."""
        ratio = self.arriving / np.where(self.open_light > 0.0, self.open_light, np.inf)
        ratio = np.where(self.open_light > 0.0, np.clip(ratio, 0.0, 1.0), 1.0)
        for axis in (0, 1):
            ratio = _smooth(ratio, axis)
        rows, columns = ratio.shape[:2]
        edge = _window(rows)[:, None, None] * _window(columns)[None, :, None]
        return np.asarray(1.0 - (1.0 - ratio) * edge)

    def seen_from(self, eye: npt.NDArray[np.float64], directions: Floats) -> Floats:
        """Return the share (..., 3) at the places that directions (..., 3) from ``eye`` (3,) meet; else 1."""
        up = float(eye[1]) - self.height
        fall = -directions[..., 1]
        meets = (fall > 0.0) & (up > 0.0)
        way = up / np.where(meets, fall, 1.0)
        x, z = eye[0] + way * directions[..., 0], eye[2] + way * directions[..., 2]
        share = self.share
        rows, columns = share.shape[:2]
        across = (x - self.low[0]) / (self.high[0] - self.low[0]) * columns - 0.5
        down = (z - self.low[1]) / (self.high[1] - self.low[1]) * rows - 0.5
        within = meets & (across > 0.0) & (across < columns - 1) & (down > 0.0) & (down < rows - 1)
        i, j = (np.where(within, place, 0.0).astype(np.int64) for place in (across, down))
        u, v = (np.where(within, place - k, 0.0)[..., None] for place, k in ((across, i), (down, j)))
        top = share[j, i] * (1.0 - u) + share[j, i + 1] * u
        bottom = share[j + 1, i] * (1.0 - u) + share[j + 1, i + 1] * u
        return np.where(within[..., None], top * (1.0 - v) + bottom * v, 1.0)

    def trace(self, scene: Any, samples: int) -> None:
        """Add ``samples`` at each place to what is known; the same call gives the same numbers."""
        rows, columns = self.arriving.shape[:2]
        count = rows * columns * samples
        sampler = mi.load_dict({"type": "independent"})
        sampler.seed(7919 + self.passes, count)
        place = dr.arange(mi.UInt32, count) // samples
        row = place // columns
        x = (mi.Float(place - row * columns) + sampler.next_1d()) / columns
        z = (mi.Float(row) + sampler.next_1d()) / rows
        size = max(self.high[0] - self.low[0], self.high[1] - self.low[1])
        at: Any = mi.Interaction3f()
        at.t, at.time = mi.Float(0.0), mi.Float(0.0)
        at.p = mi.Point3f(
            self.low[0] + x * (self.high[0] - self.low[0]),
            self.height + _LIFT * size,
            self.low[1] + z * (self.high[1] - self.low[1]),
        )
        at.n = mi.Normal3f(0.0, 1.0, 0.0)
        ds, weight = scene.environment().sample_direction(at, sampler.next_2d())
        light = weight * dr.maximum(ds.d.y, 0.0)
        passed = _passing(scene, mi.Ray3f(at.p, ds.d), ds.d.y > 0.0)

        def sees(towards: Any, distance: Any, asked: Any) -> Any:
            ray: Any = mi.Ray3f(at.p, towards)
            ray.maxt = mi.Float(distance)
            return _passing(scene, ray, asked)

        arrived, sent = lamp_light(self.lamps, at.p, sampler.next_2d, sees)
        found = np.array(light * passed + arrived, np.float64).T
        everywhere = np.array(light, np.float64).T.mean(axis=0)
        before, after = self.samples, self.samples + samples
        mean = found.reshape(rows, columns, samples, 3).mean(axis=2)
        if self.lamps:
            by_lamps = np.array(sent + dr.zeros(mi.Color3f, count), np.float64).T
            everywhere = everywhere + by_lamps.reshape(rows, columns, samples, 3).mean(axis=2)
        self.arriving = (self.arriving * before + mean * samples) / after
        self.open_light = (self.open_light * before + everywhere * samples) / after
        self.samples, self.passes = after, self.passes + 1


def _passing(scene: Any, ray: Any, active: Any) -> Any:
    """Return which share of the light comes along rays: 0 where it is hidden, less than 1 through panes."""

    def one_more(k: Any, going: Any, share: Any, ray: Any) -> tuple[Any, ...]:
        si = scene.ray_intersect(ray, going)
        met = going & si.is_valid()
        share = dr.select(met, share * si.bsdf().eval_null_transmission(si, met).y, share)
        going = met & (share > 0.0)
        return (
            k + 1,
            going,
            share,
            dr.select(going, si.spawn_ray_to(ray.o + ray.d * dr.minimum(ray.maxt, 1e5)), ray),
        )

    state = (mi.UInt32(0), mi.Bool(active), mi.Float(1.0), ray)
    return dr.while_loop(state, lambda k, going, *_: going & (k < MOST_PANES), one_more, label="panes")[2]


def ground_mesh(ground: GroundGrid, environment: Any) -> tuple[Any, Any]:
    """Return the plane, which sends on what the light of ``environment`` sends there, and its emitter.

    The tracer of the ground sets the emitter's ``share`` then: the scene has to be there first.
    """
    middle_x, middle_z = (0.5 * (low + high) for low, high in zip(ground.low, ground.high, strict=True))
    far = 1e3 * max(ground.high[0] - ground.low[0], ground.high[1] - ground.low[1])
    emitter = _plug_in()(mi.Properties())
    emitter.ground, emitter.environment = ground, environment
    emitter.share = texture(ground.share, repeat=False)
    properties = mi.Properties()
    properties["emitter"] = emitter
    properties["bsdf"] = mi.load_dict({"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}})
    mesh = mi.Mesh("ground", 4, 2, has_vertex_normals=False, has_vertex_texcoords=False, props=properties)
    x, z = np.array([-far, far, far, -far]) + middle_x, np.array([-far, -far, far, far]) + middle_z
    values = mi.traverse(mesh)
    values["vertex_positions"] = (
        np.stack([x, np.full(4, ground.height), z], axis=-1).astype(np.float32).ravel()
    )
    values["faces"] = np.array([0, 2, 1, 0, 3, 2], np.uint32)
    values.update()
    return mesh, emitter


@per_variant
def _plug_in() -> Any:
    class GroundLight(mi.Emitter):
        """Emitter of the environment's light reflected by the ground; paths meet it, the camera does not see it."""

        def __init__(self, properties: Any) -> None:
            properties["sampling_weight"] = 0.0
            super().__init__(properties)
            self.m_flags = +mi.EmitterFlags.Surface
            self.ground: Any = None
            self.environment: Any = None
            self.share: Any = None

        def eval(self, si: Any, active: Any = True) -> Any:
            beyond = dr.zeros(mi.SurfaceInteraction3f)
            beyond.wi = si.to_world(si.wi)
            light = self.environment.eval(beyond, active)
            low, high = self.ground.low, self.ground.high
            at = mi.Point2f((si.p.x - low[0]) / (high[0] - low[0]), (si.p.z - low[1]) / (high[1] - low[1]))
            within = dr.all((at > 0.0) & (at < 1.0))
            found = self.share.eval(at, active)
            share = dr.select(within, mi.Color3f(found[0], found[1], found[2]), mi.Color3f(1.0))
            return dr.select(active, light * share, mi.Color3f(0.0))

        def sample_direction(self, it: Any, _sample: Any, _active: Any = True) -> tuple[Any, Any]:
            return dr.zeros(mi.DirectionSample3f, dr.width(it.p)), mi.Color3f(0.0)

        def pdf_direction(self, _it: Any, _ds: Any, _active: Any = True) -> Any:
            return mi.Float(0.0)

        def eval_direction(self, _it: Any, _ds: Any, _active: Any = True) -> Any:
            return mi.Color3f(0.0)

        def to_string(self) -> str:
            return "GroundLight[]"

    return GroundLight


def _smooth(field: Floats, axis: int) -> Floats:
    """Blur by (1 2 1)/4 along an axis, to reduce noise between neighbours."""
    padded = np.concatenate([field.take([0], axis), field, field.take([-1], axis)], axis)
    count = field.shape[axis]
    before, here, after = (padded.take(range(k, k + count), axis) for k in (0, 1, 2))
    return np.asarray(0.25 * before + 0.5 * here + 0.25 * after)


def _window(count: int) -> npt.NDArray[np.float64]:
    inside = np.minimum(np.arange(count) + 0.5, count - np.arange(count) - 0.5) / count
    t = np.clip(inside / _RIM, 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))
