"""Losses of writing a reflectance as an isotropic half-angle table."""

from __future__ import annotations

from brdf_suite.reflectance.protocol import Reflectance


def tabulation_notes(value: Reflectance) -> tuple[str, ...]:
    """Return the notices for the user, each a clause."""
    notes = ["tabulated in 90 × 90 × 180 half-angle bins, as an isotropic and reciprocal reflectance"]
    if getattr(value, "wavelengths_nm", None) is not None:
        notes.append("its spectra were left out; the colours are those of the chosen observer under D65")
    return tuple(notes)
