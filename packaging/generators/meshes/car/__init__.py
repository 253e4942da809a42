"""Procedural car: a fastback coupé with flowing reflections, for judging a paint on a car."""

from __future__ import annotations

from meshes.car.assembly import car

__all__ = ["car"]
