"""Lamps of a view in the path tracer: points and directions, and those with an extent.

``strength`` of a lamp is its illuminance over π, of a point lamp that at 1 m. A lamp with an extent is seen as an even
disc: rays are sent to places drawn from it, and none meets it, as none meets a point. So it hides nothing of the other
light, and mirrors show what the narrow lobes of a paint reflect of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.geometry.directions import from_horizon
from brdf_suite.reference.mitsuba_modules import dr, mi, per_variant

_FAR = 1e5
"""Metres: where a distant lamp is taken to be."""


def lamp_power(lamp: Lamp) -> Floats:
    """Return the irradiance (3,) of a surface that faces a lamp, of a point lamp at 1 m."""
    return math.pi * lamp.strength * lamp_colour(lamp.temperature_k)


def lamp_emitter(lamp: Lamp) -> Any:
    """Return a lamp as Mitsuba takes it: the description of one of its emitters, or one of ours."""
    power = mi.ScalarColor3f(lamp_power(lamp).tolist())
    aim = LampAim.of(lamp)
    if aim.radius > 0.0:
        emitter = _plug_in()(mi.Properties())
        emitter.aim = aim
        emitter.power = power
        return emitter
    if aim.near:
        light = {"type": "point", "position": list(lamp.position)}
        return light | {"intensity": {"type": "rgb", "value": power}}
    return {
        "type": "directional",
        "direction": [-x for x in aim.place],
        "irradiance": {"type": "rgb", "value": power},
    }


@dataclass(frozen=True)
class LampAim:
    """Where a lamp is: ``place`` in metres where it is ``near``, else the unit direction to it; ``radius`` of its disc.

    The radius is in metres of a near lamp, in radians of a distant one.
    """

    place: tuple[float, ...]
    radius: float
    near: bool

    @classmethod
    def of(cls, lamp: Lamp) -> LampAim:
        """Return that of a lamp of a view."""
        if lamp.kind == "point":
            return cls(lamp.position, 0.5 * lamp.diameter, near=True)
        towards = from_horizon(lamp.azimuth_deg, lamp.elevation_deg)
        return cls(tuple(towards.tolist()), math.radians(0.5 * lamp.angle_deg), near=False)

    def draw(self, point: Any, sample: Any) -> tuple[Any, Any, Any]:
        """Return the unit direction from ``point`` to a place of the disc, how far that is, and one over its square.

        The last is of the lamp's middle, and 1 of a distant lamp, whose irradiance is the same everywhere.
        """
        middle = mi.Vector3f(*self.place)
        way = middle - mi.Vector3f(point) if self.near else middle
        squared = dr.maximum(dr.squared_norm(way), 1e-8)
        frame = mi.Frame3f(dr.normalize(way))
        disc = mi.warp.square_to_uniform_disk_concentric(sample) * self.radius
        reached = way + frame.s * disc.x + frame.t * disc.y
        distance = dr.norm(reached)
        return reached / distance, distance if self.near else mi.Float(_FAR), dr.rcp(squared)


def lamp_light(
    lamps: Sequence[Lamp], point: Any, draw: Callable[[], Any], sees: Callable[[Any, Any, Any], Any]
) -> tuple[Any, Any]:
    """Return what lamps send to level places ``point``: what arrives, and what would if nothing were in the way.

    ``draw`` gives squares of random numbers; ``sees`` returns which share comes along the way, from directions,
    distances, and which places ask.
    """
    arrived, sent = mi.Color3f(0.0), mi.Color3f(0.0)
    for lamp in lamps:
        towards, distance, nearness = LampAim.of(lamp).draw(point, draw())
        light = mi.Color3f(*lamp_power(lamp).tolist()) * (nearness * dr.maximum(towards.y, 0.0))
        arrived = arrived + light * sees(towards, distance, towards.y > 0.0)
        sent = sent + light
    return arrived, sent


@per_variant
def _plug_in() -> Any:
    class DiscLamp(mi.Emitter):
        """Emitter that rays are sent to and that none meets."""

        def __init__(self, properties: Any) -> None:
            super().__init__(properties)
            self.m_flags = +mi.EmitterFlags.DeltaPosition
            self.aim: Any = None
            self.power: Any = None

        def sample_direction(self, it: Any, sample: Any, active: Any = True) -> tuple[Any, Any]:
            towards, distance, nearness = self.aim.draw(it.p, sample)
            # By hand: the scalar variant has no zeros of it.
            ds: Any = mi.DirectionSample3f()
            ds.uv = mi.Point2f(0.0)
            ds.p = it.p + towards * distance
            ds.n = mi.Normal3f(-towards)
            ds.d, ds.dist, ds.time = towards, distance, it.time
            ds.pdf, ds.delta = mi.Float(1.0), mi.Bool(True)
            ds.emitter = mi.EmitterPtr(self) if dr.is_jit_v(mi.Float) else self
            light = mi.Color3f(self.power) * nearness
            return ds, dr.select(active, light, mi.Color3f(0.0))

        def pdf_direction(self, _it: Any, _ds: Any, _active: Any = True) -> Any:
            return mi.Float(0.0)

        def eval_direction(self, _it: Any, _ds: Any, _active: Any = True) -> Any:
            return mi.Color3f(0.0)

        def eval(self, _si: Any, _active: Any = True) -> Any:
            return mi.Color3f(0.0)

        def to_string(self) -> str:
            return "DiscLamp[]"

    return DiscLamp
