"""Mitsuba BSDF plug-ins: one that wraps a term, two-sided, and a tinted pane.

Mitsuba's class differs from variant to variant, so ours is made when it is first wanted.
"""

from __future__ import annotations

from typing import Any

from brdf_suite.reference.bsdfs import directions, terms
from brdf_suite.reference.bsdfs.placed import LayeredPaintBsdf, LocalBsdf, TwoToneBsdf
from brdf_suite.reference.mitsuba_modules import dr, mi, per_variant
from brdf_suite.reference.scene.camera import Pinhole
from brdf_suite.reference.scene.place import Place


def make_bsdf(term: Any) -> Any:
    """Return a BSDF of ``term``; Mitsuba keeps it as long as the scene."""
    made = _plug_in()(mi.Properties())
    made.term = term
    return made


def make_pane(ior: float, transmittance: float) -> Any:
    """Return a BSDF of a thin sheet: it mirrors R = 2 F/(1 + F) and passes ``transmittance`` (1 - R).

    What it passes goes straight on and is not its own: a picture's coverage is what a pane mirrors or keeps.
    """
    made = _pane_plug_in()(mi.Properties())
    made.ior, made.transmittance = ior, transmittance
    return made


@per_variant
def _pane_plug_in() -> Any:
    class PaneBsdf(mi.BSDF):
        """Mirrors, or lets pass, by chance: as often as it lets pass, so that what passes keeps its weight."""

        def __init__(self, properties: Any) -> None:
            super().__init__(properties)
            both = mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
            self.m_components = [mi.BSDFFlags.DeltaReflection | both, mi.BSDFFlags.Null | both]
            self.m_flags = mi.BSDFFlags.DeltaReflection | mi.BSDFFlags.Null | both
            self.ior, self.transmittance = 1.5, 1.0

        def _shares(self, si: Any) -> tuple[Any, Any]:
            f = directions.fresnel(dr.abs(si.wi.z), self.ior)
            mirrored = 2.0 * f / (1.0 + f)
            return mirrored, self.transmittance * (1.0 - mirrored)

        def eval_null_transmission(self, si: Any, active: Any = True) -> Any:
            return mi.Color3f(dr.select(active, self._shares(si)[1], 0.0))

        def sample(self, _context: Any, si: Any, choice: Any, _u: Any, active: Any = True) -> tuple[Any, Any]:
            mirrored, passed = self._shares(si)
            through = choice < passed
            found: Any = mi.BSDFSample3f(dr.select(through, -si.wi, mi.Vector3f(-si.wi.x, -si.wi.y, si.wi.z)))
            found.pdf = dr.select(active, dr.select(through, passed, 1.0 - passed), 0.0)
            found.eta = 1.0
            found.sampled_type = dr.select(
                through, mi.UInt32(+mi.BSDFFlags.Null), mi.UInt32(+mi.BSDFFlags.DeltaReflection)
            )
            found.sampled_component = dr.select(through, mi.UInt32(1), mi.UInt32(0))
            weight = dr.select(through, 1.0, mirrored / dr.maximum(1.0 - passed, 1e-6))
            return found, mi.Color3f(dr.select(active, weight, 0.0))

        def eval(self, _context: Any, _si: Any, _wo: Any, _active: Any = True) -> Any:
            return mi.Color3f(0.0)

        def pdf(self, _context: Any, _si: Any, _wo: Any, _active: Any = True) -> Any:
            return mi.Float(0.0)

        def eval_pdf(self, _context: Any, _si: Any, _wo: Any, _active: Any = True) -> tuple[Any, Any]:
            return mi.Color3f(0.0), mi.Float(0.0)

        def to_string(self) -> str:
            return f"PaneBsdf[{self.ior:g}, {self.transmittance:g}]"

    return PaneBsdf


@per_variant
def _plug_in() -> Any:
    class SuiteBsdf(mi.BSDF):
        """f_r of a term times the cosine of the light, sampled by the term's samplers."""

        def __init__(self, properties: Any) -> None:
            super().__init__(properties)
            flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
            self.m_components = [flags]
            self.m_flags = flags
            self.term: Any = None
            self.viewpoint: Pinhole | None = None

        def sample(self, _context: Any, si: Any, choice: Any, u: Any, active: Any = True) -> tuple[Any, Any]:
            view, side = _facing(si.wi)
            local = self._local_bsdf(si, view, side)
            light = terms.sample(local.samplers, view, choice, u)
            active &= (view.z > 0.0) & (light.z > 0.0)
            pdf = terms.pdf(local.samplers, light, view)
            found: Any = mi.BSDFSample3f(mi.Vector3f(light.x, light.y, light.z * side))
            found.pdf = dr.select(active, pdf, 0.0)
            found.eta = 1.0
            found.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
            found.sampled_component = mi.UInt32(0)
            active &= pdf > 0.0
            weight = local.reflected(light, view) / pdf
            return found, dr.select(active, weight, mi.Color3f(0.0))

        def eval(self, _context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(_context, si, wo, active)[0]

        def pdf(self, _context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(_context, si, wo, active)[1]

        def eval_pdf(self, _context: Any, si: Any, wo: Any, active: Any = True) -> tuple[Any, Any]:
            view, side = _facing(si.wi)
            light = mi.Vector3f(wo.x, wo.y, wo.z * side)
            active &= (view.z > 0.0) & (light.z > 0.0)
            local = self._local_bsdf(si, view, side)
            value = local.reflected(light, view)
            pdf = terms.pdf(local.samplers, light, view)
            return dr.select(active, value, mi.Color3f(0.0)), dr.select(active, pdf, 0.0)

        def _local_bsdf(self, si: Any, view: Any, side: Any) -> LocalBsdf:
            if isinstance(self.term, (LayeredPaintBsdf, TwoToneBsdf)) and self.viewpoint is not None:
                return self.term.at(Place.of(si, side, self.viewpoint), view)
            return LocalBsdf(self.term.samplers, lambda light, view: self.term.eval(light, view) * light.z)

        def to_string(self) -> str:
            return f"SuiteBsdf[{type(self.term).__name__}]"

    return SuiteBsdf


def _facing(direction: Any) -> tuple[Any, Any]:
    """Return the direction on the side of the normal, and the side: 1 or -1."""
    side = dr.select(direction.z >= 0.0, mi.Float(1.0), mi.Float(-1.0))
    return mi.Vector3f(direction.x, direction.y, direction.z * side), side
