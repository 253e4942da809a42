"""Clearcoat and flakes of a paint."""
