"""STEP and IGES: CAD surfaces, cut into triangles by Open CASCADE; cascadio gives a binary glTF file.

That file is in metres, with the axes of the CAD program, which has z up.
"""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.errors import FileError
from brdf_suite.files.meshes.glb import split_glb
from brdf_suite.files.meshes.gltf import read_gltf
from brdf_suite.files.meshes.outside.child import import_library
from brdf_suite.files.meshes.outside.values import ReadMesh, ReadPart, Refused
from brdf_suite.regular_files import read_bytes

cascadio = import_library("step")

_ANGLE = 0.35
"""Radians between neighbouring triangles of a curved surface."""


def read(file: Path, options: dict[str, Any]) -> ReadMesh:
    """Return the parts; ``tessellation_mm`` is the largest distance of a triangle from its surface."""
    try:
        converted = cascadio.load(
            read_bytes(file),
            file_type=options["kind"],
            tol_linear=options["tessellation_mm"],
            tol_angular=_ANGLE,
            use_parallel=False,
        )
    except RuntimeError as error:  # what Open CASCADE throws
        raise Refused(f"damaged ({' '.join(str(error).split())[:80]})") from error
    if not converted:
        raise Refused("damaged, or without a surface or a body that triangles can be made of")
    try:
        document, binary = split_glb(file, converted)
        parts = read_gltf(file, document, binary)
    except (FileError, LookupError, TypeError, ValueError, struct.error) as error:
        raise Refused("damaged: its surfaces could not be cut into triangles") from error
    found = []
    for part in parts:
        arrays: dict[str, Any] = {"positions": part.positions.astype(np.float32), "triangles": part.triangles}
        if part.normals is not None:
            arrays["normals"] = part.normals.astype(np.float32)
        look = part.look
        fields = {"name": part.name, "material": look.name, "colour": look.colour, "passing": look.passing}
        found.append(ReadPart(arrays, fields))
    return ReadMesh(found, up="z", metres=1.0)
