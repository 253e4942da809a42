"""What we rely on in a BiRD file (BRDF JSON schema 1.0 of the BiRD project), as a JSON schema of our own.

It is looser than theirs where real files are (their schema asks for fields that their own example lacks), and
as strict where a wrong file would be misread: units, notations, and that every axis is a list.
"""

from __future__ import annotations

from typing import Any

from brdf_suite.files.measured.bounded_reading import MOST_SAMPLES

# The items are numbers too; that is checked by place when they are taken, since a schema of a million items is slow.
_LIST = {"type": "array", "minItems": 1, "maxItems": MOST_SAMPLES}


def _axis(*units: str) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {"unit": {"enum": list(units)}, "values": _LIST},
        "required": ["unit", "values"],
    }


_ANGLE = _axis("rad", "deg", "°")
# The micro sign and the Greek letter look alike, and both are met.
_WAVELENGTH = _axis("nm", "μm", "µm", "um")
_POLARIZATION = {
    "type": "object",
    "properties": {"notation": {"enum": ["sp", "inStokes"]}, "values": _LIST},
    "required": ["values"],
}

SCHEMA: dict[str, Any] = {
    "$schema": "https://json-schema.org/draft/2020-12/schema",
    "type": "object",
    "properties": {
        "metadata": {"type": "object", "properties": {"type": {"enum": ["BRDF"]}}},
        "data": {
            "type": "object",
            "properties": {
                "theta_i": _ANGLE,
                "phi_i": _ANGLE,
                "theta_r": _ANGLE,
                "phi_r": _ANGLE,
                "BRDF": _axis("1/sr", "sr^-1"),
                "uBRDF": {"type": "object"},
                "wavelength_i": _WAVELENGTH,
                "wavelength_r": _WAVELENGTH,
                "polarization_i": _POLARIZATION,
                "polarization_r": _POLARIZATION,
                "adhoc_variables": {"type": "object"},
            },
            "required": ["theta_i", "phi_i", "theta_r", "phi_r", "BRDF"],
        },
    },
    "required": ["metadata", "data"],
}
