"""A car by code alone: a fastback coupé whose paint reflections flow over, for judging a paint on a car."""

from __future__ import annotations

from brdf_suite.surface.car.assembly import car

__all__ = ["car"]
